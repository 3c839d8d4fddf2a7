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
    member: array<array<u32, 2>>,
}

struct type_26 {
    member: u32,
}

struct type_27 {
    member: type_7,
    member_1: type_8,
    member_2: type_26,
}

struct type_28 {
    member: type_27,
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
var<storage> params: type_28;
@group(0) @binding(4) 
var<storage> input: type_10;
@group(0) @binding(2) 
var<storage> positions: type_32;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_53;
@group(0) @binding(3) 
var<storage> elements: type_24;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_53;

fn function_(param: array<f32, 3>) -> array<f64, 3> {
    var phi_253_: f64;
    var phi_231_: array<u32, 2>;
    var phi_254_: f64;
    var phi_296_: f64;
    var phi_274_: array<u32, 2>;
    var phi_297_: f64;
    var phi_339_: f64;
    var phi_317_: array<u32, 2>;
    var phi_340_: f64;

    let _e10 = bitcast<u32>(param[0]);
    let _e11 = (_e10 & 2147483647u);
    if (_e11 >= 8388608u) {
        let _e21 = bitcast<u32>(param[0]);
        let _e22 = (_e21 & 2147483647u);
        if (_e22 < 8388608u) {
            phi_231_ = array<u32, 2>(0u, 0u);
        } else {
            phi_231_ = array<u32, 2>((_e21 << bitcast<u32>(29i)), ((_e21 ^ _e22) | ((_e22 >> bitcast<u32>(3i)) + 939524096u)));
        }
        let _e33 = phi_231_;
        phi_254_ = bitcast<f64>(((u64(_e33[1]) * 4294967296lu) + u64(_e33[0])));
    } else {
        if (_e10 == _e11) {
            phi_253_ = (f64(_e11) * 1.401298464324817e-45lf);
        } else {
            phi_253_ = -((f64(_e11) * 1.401298464324817e-45lf));
        }
        let _e20 = phi_253_;
        phi_254_ = _e20;
    }
    let _e42 = phi_254_;
    let _e44 = bitcast<u32>(param[1]);
    let _e45 = (_e44 & 2147483647u);
    if (_e45 >= 8388608u) {
        let _e55 = bitcast<u32>(param[1]);
        let _e56 = (_e55 & 2147483647u);
        if (_e56 < 8388608u) {
            phi_274_ = array<u32, 2>(0u, 0u);
        } else {
            phi_274_ = array<u32, 2>((_e55 << bitcast<u32>(29i)), ((_e55 ^ _e56) | ((_e56 >> bitcast<u32>(3i)) + 939524096u)));
        }
        let _e67 = phi_274_;
        phi_297_ = bitcast<f64>(((u64(_e67[1]) * 4294967296lu) + u64(_e67[0])));
    } else {
        if (_e44 == _e45) {
            phi_296_ = (f64(_e45) * 1.401298464324817e-45lf);
        } else {
            phi_296_ = -((f64(_e45) * 1.401298464324817e-45lf));
        }
        let _e54 = phi_296_;
        phi_297_ = _e54;
    }
    let _e76 = phi_297_;
    let _e78 = bitcast<u32>(param[2]);
    let _e79 = (_e78 & 2147483647u);
    if (_e79 >= 8388608u) {
        let _e89 = bitcast<u32>(param[2]);
        let _e90 = (_e89 & 2147483647u);
        if (_e90 < 8388608u) {
            phi_317_ = array<u32, 2>(0u, 0u);
        } else {
            phi_317_ = array<u32, 2>((_e89 << bitcast<u32>(29i)), ((_e89 ^ _e90) | ((_e90 >> bitcast<u32>(3i)) + 939524096u)));
        }
        let _e101 = phi_317_;
        phi_340_ = bitcast<f64>(((u64(_e101[1]) * 4294967296lu) + u64(_e101[0])));
    } else {
        if (_e78 == _e79) {
            phi_339_ = (f64(_e79) * 1.401298464324817e-45lf);
        } else {
            phi_339_ = -((f64(_e79) * 1.401298464324817e-45lf));
        }
        let _e88 = phi_339_;
        phi_340_ = _e88;
    }
    let _e110 = phi_340_;
    return array<f64, 3>(_e42, _e76, _e110);
}

fn function_1(param_1: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param_1);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_2(param_2: array<f64, 3>, param_3: array<f64, 3>) -> array<f64, 3> {
    var phi_16316_: array<f64, 3>;

    if ((((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])) < (((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2]))) {
        phi_16316_ = param_3;
    } else {
        phi_16316_ = param_2;
    }
    let _e26 = phi_16316_;
    return _e26;
}

fn function_3(param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: array<f64, 3>, param_7: u32) -> array<f64, 3> {
    var phi_16168_: f64;
    var phi_16170_: f64;
    var phi_16212_: f64;
    var phi_16214_: f64;
    var phi_16262_: f64;
    var phi_16264_: f64;
    var phi_15973_: f64;
    var phi_15975_: f64;
    var phi_16023_: f64;
    var phi_16025_: f64;
    var phi_16070_: f64;
    var phi_16072_: f64;
    var phi_16123_: f64;
    var phi_16125_: f64;
    var phi_16279_: array<array<f64, 3>, 4>;

    let _e9 = (param_4[0] - param_5[0]);
    let _e12 = (param_4[1] - param_5[1]);
    let _e15 = (param_4[2] - param_5[2]);
    if (param_7 != 0u) {
        let _e169 = ((((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e169 > f64(0f)) {
            if (_e169 < f64(1f)) {
                phi_15973_ = _e169;
            } else {
                phi_15973_ = f64(1f);
            }
            let _e177 = phi_15973_;
            phi_15975_ = _e177;
        } else {
            phi_15975_ = f64(0f);
        }
        let _e179 = phi_15975_;
        let _e215 = ((((param_4[0] * param_6[0]) + (param_4[1] * param_6[1])) + (param_4[2] * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        if (_e215 > f64(0f)) {
            if (_e215 < f64(1f)) {
                phi_16023_ = _e215;
            } else {
                phi_16023_ = f64(1f);
            }
            let _e223 = phi_16023_;
            phi_16025_ = _e223;
        } else {
            phi_16025_ = f64(0f);
        }
        let _e225 = phi_16025_;
        let _e258 = ((((_e9 * param_6[0]) + (_e12 * param_6[1])) + (_e15 * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        if (_e258 > f64(0f)) {
            if (_e258 < f64(1f)) {
                phi_16070_ = _e258;
            } else {
                phi_16070_ = f64(1f);
            }
            let _e266 = phi_16070_;
            phi_16072_ = _e266;
        } else {
            phi_16072_ = f64(0f);
        }
        let _e268 = phi_16072_;
        let _e281 = (param_4[0] - param_6[0]);
        let _e284 = (param_4[1] - param_6[1]);
        let _e287 = (param_4[2] - param_6[2]);
        let _e307 = ((((_e281 * param_5[0]) + (_e284 * param_5[1])) + (_e287 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e307 > f64(0f)) {
            if (_e307 < f64(1f)) {
                phi_16123_ = _e307;
            } else {
                phi_16123_ = f64(1f);
            }
            let _e315 = phi_16123_;
            phi_16125_ = _e315;
        } else {
            phi_16125_ = f64(0f);
        }
        let _e317 = phi_16125_;
        phi_16279_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e179)), (param_4[1] - (param_5[1] * _e179)), (param_4[2] - (param_5[2] * _e179))), array<f64, 3>((param_4[0] - (param_6[0] * _e225)), (param_4[1] - (param_6[1] * _e225)), (param_4[2] - (param_6[2] * _e225))), array<f64, 3>((_e9 - (param_6[0] * _e268)), (_e12 - (param_6[1] * _e268)), (_e15 - (param_6[2] * _e268))), array<f64, 3>((_e281 - (param_5[0] * _e317)), (_e284 - (param_5[1] * _e317)), (_e287 - (param_5[2] * _e317))));
    } else {
        let _e19 = (param_6[0] - param_5[0]);
        let _e22 = (param_6[1] - param_5[1]);
        let _e25 = (param_6[2] - param_5[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        if (_e36 > f64(0f)) {
            if (_e36 < f64(1f)) {
                phi_16168_ = _e36;
            } else {
                phi_16168_ = f64(1f);
            }
            let _e44 = phi_16168_;
            phi_16170_ = _e44;
        } else {
            phi_16170_ = f64(0f);
        }
        let _e46 = phi_16170_;
        let _e53 = array<f64, 3>((_e9 - (_e19 * _e46)), (_e12 - (_e22 * _e46)), (_e15 - (_e25 * _e46)));
        let _e76 = ((((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e76 > f64(0f)) {
            if (_e76 < f64(1f)) {
                phi_16212_ = _e76;
            } else {
                phi_16212_ = f64(1f);
            }
            let _e84 = phi_16212_;
            phi_16214_ = _e84;
        } else {
            phi_16214_ = f64(0f);
        }
        let _e86 = phi_16214_;
        let _e122 = ((((param_4[0] * param_6[0]) + (param_4[1] * param_6[1])) + (param_4[2] * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        if (_e122 > f64(0f)) {
            if (_e122 < f64(1f)) {
                phi_16262_ = _e122;
            } else {
                phi_16262_ = f64(1f);
            }
            let _e130 = phi_16262_;
            phi_16264_ = _e130;
        } else {
            phi_16264_ = f64(0f);
        }
        let _e132 = phi_16264_;
        phi_16279_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e86)), (param_4[1] - (param_5[1] * _e86)), (param_4[2] - (param_5[2] * _e86))), array<f64, 3>((param_4[0] - (param_6[0] * _e132)), (param_4[1] - (param_6[1] * _e132)), (param_4[2] - (param_6[2] * _e132))), _e53, _e53);
    }
    let _e330 = phi_16279_;
    let _e333 = function_2(_e330[0], _e330[1]);
    let _e335 = function_2(_e333, _e330[2]);
    let _e337 = function_2(_e335, _e330[3]);
    return _e337;
}

fn function_4(param_8: array<f64, 3>, param_9: array<f64, 3>, param_10: array<f64, 3>, param_11: u32) -> array<f64, 3> {
    var phi_15870_: bool;
    var phi_15871_: bool;
    var phi_15872_: bool;
    var phi_15873_: bool;
    var phi_15877_: bool;
    var phi_15850_: bool;
    var phi_15851_: bool;
    var phi_15852_: bool;
    var phi_15853_: bool;
    var phi_15854_: bool;
    var phi_15855_: bool;
    var phi_15859_: bool;
    var phi_15878_: bool;
    var phi_15912_: array<f64, 3>;
    var phi_15913_: bool;
    var phi_15914_: array<f64, 3>;
    var phi_15915_: bool;
    var phi_15920_: array<f64, 3>;

    let _e23 = (((param_9[0] * param_9[0]) + (param_9[1] * param_9[1])) + (param_9[2] * param_9[2]));
    let _e34 = (((param_9[0] * param_10[0]) + (param_9[1] * param_10[1])) + (param_9[2] * param_10[2]));
    let _e45 = (((param_10[0] * param_10[0]) + (param_10[1] * param_10[1])) + (param_10[2] * param_10[2]));
    let _e56 = (((param_8[0] * param_9[0]) + (param_8[1] * param_9[1])) + (param_8[2] * param_9[2]));
    let _e67 = (((param_8[0] * param_10[0]) + (param_8[1] * param_10[1])) + (param_8[2] * param_10[2]));
    let _e70 = ((_e23 * _e45) - (_e34 * _e34));
    let _e71 = f64(0f);
    let _e72 = f64(1f);
    let _e76 = (((_e56 * _e45) - (_e67 * _e34)) / _e70);
    let _e80 = (((_e67 * _e23) - (_e56 * _e34)) / _e70);
    if (param_11 != 0u) {
        if (_e76 >= _e71) {
            if (_e80 >= _e71) {
                if (_e76 <= _e72) {
                    phi_15850_ = (_e80 <= _e72);
                    phi_15851_ = false;
                } else {
                    phi_15850_ = bool();
                    phi_15851_ = true;
                }
                let _e101 = phi_15850_;
                let _e103 = phi_15851_;
                phi_15852_ = _e101;
                phi_15853_ = _e103;
            } else {
                phi_15852_ = bool();
                phi_15853_ = true;
            }
            let _e105 = phi_15852_;
            let _e107 = phi_15853_;
            phi_15854_ = _e105;
            phi_15855_ = _e107;
        } else {
            phi_15854_ = bool();
            phi_15855_ = true;
        }
        let _e109 = phi_15854_;
        let _e111 = phi_15855_;
        if _e111 {
            phi_15859_ = false;
        } else {
            phi_15859_ = _e109;
        }
        let _e113 = phi_15859_;
        phi_15878_ = _e113;
    } else {
        if (_e76 >= _e71) {
            if (_e80 >= _e71) {
                phi_15870_ = ((_e76 + _e80) <= _e72);
                phi_15871_ = false;
            } else {
                phi_15870_ = bool();
                phi_15871_ = true;
            }
            let _e87 = phi_15870_;
            let _e89 = phi_15871_;
            phi_15872_ = _e87;
            phi_15873_ = _e89;
        } else {
            phi_15872_ = bool();
            phi_15873_ = true;
        }
        let _e91 = phi_15872_;
        let _e93 = phi_15873_;
        if _e93 {
            phi_15877_ = false;
        } else {
            phi_15877_ = _e91;
        }
        let _e95 = phi_15877_;
        phi_15878_ = _e95;
    }
    let _e115 = phi_15878_;
    if (_e70 > ((_e23 * _e45) * (1.1102230246251565e-16lf * f64(64f)))) {
        if _e115 {
            phi_15912_ = array<f64, 3>((param_8[0] - ((param_9[0] * _e76) + (param_10[0] * _e80))), (param_8[1] - ((param_9[1] * _e76) + (param_10[1] * _e80))), (param_8[2] - ((param_9[2] * _e76) + (param_10[2] * _e80))));
            phi_15913_ = false;
        } else {
            phi_15912_ = array<f64, 3>();
            phi_15913_ = true;
        }
        let _e144 = phi_15912_;
        let _e146 = phi_15913_;
        phi_15914_ = _e144;
        phi_15915_ = _e146;
    } else {
        phi_15914_ = array<f64, 3>();
        phi_15915_ = true;
    }
    let _e148 = phi_15914_;
    let _e150 = phi_15915_;
    if _e150 {
        let _e151 = function_3(param_8, param_9, param_10, param_11);
        phi_15920_ = _e151;
    } else {
        phi_15920_ = _e148;
    }
    let _e153 = phi_15920_;
    return _e153;
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
    var phi_401_: u32;
    var phi_411_: u32;
    var phi_418_: u32;
    var phi_434_: u32;
    var phi_455_: u32;
    var phi_456_: u32;
    var phi_459_: type_12;
    var phi_460_: type_12;
    var phi_483_: type_12;
    var phi_745_: type_33;
    var phi_870_: f64;
    var phi_876_: f64;
    var phi_881_: f64;
    var phi_887_: f64;
    var phi_892_: f64;
    var phi_898_: f64;
    var phi_904_: f64;
    var phi_909_: f64;
    var phi_915_: f64;
    var phi_920_: f64;
    var phi_925_: f64;
    var phi_932_: f64;
    var phi_938_: f64;
    var phi_943_: f64;
    var phi_949_: f64;
    var phi_954_: f64;
    var phi_960_: f64;
    var phi_966_: f64;
    var phi_971_: f64;
    var phi_977_: f64;
    var phi_982_: f64;
    var phi_987_: f64;
    var phi_994_: f64;
    var phi_1000_: f64;
    var phi_1005_: f64;
    var phi_1011_: f64;
    var phi_1016_: f64;
    var phi_1022_: f64;
    var phi_1028_: f64;
    var phi_1033_: f64;
    var phi_1039_: f64;
    var phi_1044_: f64;
    var phi_1049_: f64;
    var phi_1055_: f64;
    var phi_1060_: f64;
    var phi_1069_: bool;
    var phi_1093_: u64;
    var phi_1105_: f64;
    var phi_1106_: f64;
    var phi_1140_: type_45;
    var phi_1141_: bool;
    var phi_1142_: type_45;
    var phi_1143_: bool;
    var phi_1144_: type_45;
    var phi_1145_: bool;
    var phi_1150_: type_45;
    var phi_8216_: f64;
    var phi_8223_: f64;
    var phi_8228_: f64;
    var phi_8235_: f64;
    var phi_8240_: f64;
    var phi_8253_: f64;
    var phi_8260_: f64;
    var phi_8265_: f64;
    var phi_8272_: f64;
    var phi_8277_: f64;
    var phi_8282_: f64;
    var phi_8299_: f64;
    var phi_8306_: f64;
    var phi_8311_: f64;
    var phi_8318_: f64;
    var phi_8323_: f64;
    var phi_8337_: f64;
    var phi_8344_: f64;
    var phi_8349_: f64;
    var phi_8356_: f64;
    var phi_8361_: f64;
    var phi_8366_: f64;
    var phi_8383_: f64;
    var phi_8390_: f64;
    var phi_8395_: f64;
    var phi_8402_: f64;
    var phi_8407_: f64;
    var phi_8421_: f64;
    var phi_8428_: f64;
    var phi_8433_: f64;
    var phi_8440_: f64;
    var phi_8445_: f64;
    var phi_8450_: f64;
    var phi_8487_: f64;
    var phi_8493_: f64;
    var phi_8500_: f64;
    var phi_8507_: f64;
    var phi_8513_: f64;
    var phi_8520_: f64;
    var phi_8526_: f64;
    var phi_8532_: f64;
    var phi_8538_: f64;
    var phi_8545_: f64;
    var phi_8552_: f64;
    var phi_8580_: f64;
    var phi_8585_: f64;
    var phi_8590_: f64;
    var phi_8595_: f64;
    var phi_8600_: f64;
    var phi_8605_: f64;
    var phi_8616_: f64;
    var phi_8630_: f64;
    var phi_8636_: f64;
    var phi_8641_: f64;
    var phi_8647_: f64;
    var phi_8653_: f64;
    var phi_8658_: f64;
    var phi_8663_: f64;
    var phi_8673_: bool;
    var phi_8680_: f64;
    var phi_8688_: f64;
    var phi_8696_: f64;
    var phi_8715_: f64;
    var phi_8864_: f64;
    var phi_8871_: f64;
    var phi_8876_: f64;
    var phi_8883_: f64;
    var phi_8888_: f64;
    var phi_8901_: f64;
    var phi_8908_: f64;
    var phi_8913_: f64;
    var phi_8920_: f64;
    var phi_8925_: f64;
    var phi_8930_: f64;
    var phi_8947_: f64;
    var phi_8954_: f64;
    var phi_8959_: f64;
    var phi_8966_: f64;
    var phi_8971_: f64;
    var phi_8985_: f64;
    var phi_8992_: f64;
    var phi_8997_: f64;
    var phi_9004_: f64;
    var phi_9009_: f64;
    var phi_9014_: f64;
    var phi_9031_: f64;
    var phi_9038_: f64;
    var phi_9043_: f64;
    var phi_9050_: f64;
    var phi_9055_: f64;
    var phi_9069_: f64;
    var phi_9076_: f64;
    var phi_9081_: f64;
    var phi_9088_: f64;
    var phi_9093_: f64;
    var phi_9098_: f64;
    var phi_9219_: f64;
    var phi_9226_: f64;
    var phi_9234_: f64;
    var phi_9280_: type_16;
    var phi_9283_: f64;
    var phi_9304_: bool;
    var phi_9310_: type_17;
    var phi_9281_: type_16;
    var phi_9324_: type_17;
    var phi_9284_: f64;
    var local_19: f64;
    var phi_9273_: f64;
    var phi_9337_: f64;
    var phi_9406_: f64;
    var phi_9412_: f64;
    var phi_9421_: f64;
    var phi_9427_: f64;
    var phi_9436_: f64;
    var phi_9442_: f64;
    var phi_9451_: f64;
    var phi_9457_: f64;
    var phi_9463_: type_38;
    var phi_9464_: bool;
    var phi_9465_: type_38;
    var phi_9466_: bool;
    var phi_9476_: type_38;
    var phi_9646_: bool;
    var phi_9647_: bool;
    var phi_9648_: bool;
    var phi_9649_: bool;
    var phi_9650_: bool;
    var phi_9651_: bool;
    var phi_9655_: bool;
    var phi_9683_: f64;
    var phi_9689_: f64;
    var phi_9696_: f64;
    var phi_9739_: type_16;
    var phi_9742_: f64;
    var phi_9763_: bool;
    var phi_9769_: type_17;
    var phi_9740_: type_16;
    var phi_9783_: type_17;
    var phi_9743_: f64;
    var local_20: f64;
    var phi_9732_: f64;
    var phi_9796_: f64;
    var phi_9865_: f64;
    var phi_9871_: f64;
    var phi_9880_: f64;
    var phi_9886_: f64;
    var phi_9895_: f64;
    var phi_9901_: f64;
    var phi_9910_: f64;
    var phi_9916_: f64;
    var phi_9922_: type_38;
    var phi_9923_: bool;
    var phi_9924_: type_38;
    var phi_9925_: bool;
    var phi_9935_: type_38;
    var phi_10105_: bool;
    var phi_10106_: bool;
    var phi_10107_: bool;
    var phi_10108_: bool;
    var phi_10109_: bool;
    var phi_10110_: bool;
    var phi_10114_: bool;
    var phi_10142_: f64;
    var phi_10148_: f64;
    var phi_10155_: f64;
    var phi_10198_: type_16;
    var phi_10201_: f64;
    var phi_10222_: bool;
    var phi_10228_: type_17;
    var phi_10199_: type_16;
    var phi_10242_: type_17;
    var phi_10202_: f64;
    var local_21: f64;
    var phi_10191_: f64;
    var phi_10255_: f64;
    var phi_10324_: f64;
    var phi_10330_: f64;
    var phi_10339_: f64;
    var phi_10345_: f64;
    var phi_10354_: f64;
    var phi_10360_: f64;
    var phi_10369_: f64;
    var phi_10375_: f64;
    var phi_10381_: type_38;
    var phi_10382_: bool;
    var phi_10383_: type_38;
    var phi_10384_: bool;
    var phi_10394_: type_38;
    var phi_10564_: bool;
    var phi_10565_: bool;
    var phi_10566_: bool;
    var phi_10567_: bool;
    var phi_10568_: bool;
    var phi_10569_: bool;
    var phi_10573_: bool;
    var phi_10601_: f64;
    var phi_10607_: f64;
    var phi_10614_: f64;
    var phi_10657_: type_16;
    var phi_10660_: f64;
    var phi_10681_: bool;
    var phi_10687_: type_17;
    var phi_10658_: type_16;
    var phi_10701_: type_17;
    var phi_10661_: f64;
    var local_22: f64;
    var phi_10650_: f64;
    var phi_10714_: f64;
    var phi_10783_: f64;
    var phi_10789_: f64;
    var phi_10798_: f64;
    var phi_10804_: f64;
    var phi_10813_: f64;
    var phi_10819_: f64;
    var phi_10828_: f64;
    var phi_10834_: f64;
    var phi_10840_: type_38;
    var phi_10841_: bool;
    var phi_10842_: type_38;
    var phi_10843_: bool;
    var phi_10853_: type_38;
    var phi_11023_: bool;
    var phi_11024_: bool;
    var phi_11025_: bool;
    var phi_11026_: bool;
    var phi_11027_: bool;
    var phi_11028_: bool;
    var phi_11032_: bool;
    var phi_11033_: bool;
    var phi_11034_: bool;
    var phi_11035_: bool;
    var phi_11036_: bool;
    var phi_11037_: bool;
    var phi_11041_: bool;
    var phi_11047_: type_46;
    var phi_11048_: bool;
    var phi_11049_: type_46;
    var phi_11050_: bool;
    var phi_11096_: type_16;
    var phi_11099_: f64;
    var phi_11120_: bool;
    var phi_11126_: type_17;
    var phi_11097_: type_16;
    var phi_11140_: type_17;
    var phi_11100_: f64;
    var local_23: f64;
    var phi_11089_: f64;
    var phi_11153_: f64;
    var phi_11159_: f64;
    var phi_11184_: type_12;
    var phi_11187_: u32;
    var phi_11185_: type_12;
    var phi_11210_: type_12;
    var phi_11254_: u32;
    var phi_11255_: u32;
    var phi_11188_: u32;
    var phi_11256_: u32;
    var phi_11276_: type_12;
    var phi_11277_: type_12;
    var phi_11300_: type_12;
    var phi_11319_: f64;
    var phi_11332_: f64;
    var phi_11368_: f64;
    var phi_11375_: f64;
    var phi_11387_: bool;
    var phi_11388_: bool;
    var phi_11389_: bool;
    var phi_11390_: bool;
    var phi_11394_: bool;
    var phi_11406_: type_49;
    var phi_11407_: type_49;
    var phi_11408_: bool;
    var phi_11409_: type_49;
    var phi_11410_: bool;
    var phi_11423_: f64;
    var phi_11435_: type_12;
    var phi_11438_: f64;
    var phi_11440_: f64;
    var phi_11442_: f64;
    var phi_11436_: type_12;
    var phi_11465_: type_12;
    var phi_11492_: f64;
    var phi_11493_: f64;
    var phi_11521_: f64;
    var phi_11537_: f64;
    var phi_11544_: bool;
    var phi_11545_: bool;
    var phi_11546_: bool;
    var phi_11552_: f64;
    var phi_11553_: f64;
    var phi_11554_: bool;
    var phi_11439_: f64;
    var phi_11441_: f64;
    var phi_11443_: f64;
    var phi_11555_: f64;
    var phi_11556_: bool;
    var phi_11557_: bool;
    var local_24: bool;
    var phi_11561_: f64;
    var phi_11562_: f64;
    var phi_11572_: f64;
    var phi_11576_: type_12;
    var phi_11579_: f64;
    var phi_11577_: type_12;
    var phi_11602_: type_12;
    var phi_11633_: f64;
    var phi_11634_: bool;
    var phi_11635_: f64;
    var phi_11636_: bool;
    var phi_11637_: bool;
    var phi_11638_: bool;
    var phi_11639_: f64;
    var phi_11580_: f64;
    var phi_11640_: bool;
    var phi_11641_: bool;
    var phi_11642_: bool;
    var phi_11643_: bool;
    var local_25: bool;
    var phi_11647_: bool;
    var phi_11648_: bool;
    var phi_11652_: bool;
    var phi_11656_: f64;
    var phi_11657_: f64;
    var phi_11659_: type_49;
    var phi_11690_: f64;
    var phi_11697_: f64;
    var phi_11702_: f64;
    var phi_11709_: f64;
    var phi_11714_: f64;
    var phi_11727_: f64;
    var phi_11734_: f64;
    var phi_11739_: f64;
    var phi_11746_: f64;
    var phi_11751_: f64;
    var phi_11756_: f64;
    var phi_11815_: f64;
    var phi_11821_: f64;
    var phi_11826_: f64;
    var phi_11832_: f64;
    var phi_11837_: f64;
    var phi_11851_: f64;
    var phi_11857_: f64;
    var phi_11862_: f64;
    var phi_11868_: f64;
    var phi_11873_: f64;
    var phi_11899_: f64;
    var phi_11906_: f64;
    var phi_11911_: f64;
    var phi_11918_: f64;
    var phi_11923_: f64;
    var phi_11936_: f64;
    var phi_11943_: f64;
    var phi_11948_: f64;
    var phi_11955_: f64;
    var phi_11960_: f64;
    var phi_11965_: f64;
    var phi_12024_: f64;
    var phi_12030_: f64;
    var phi_12035_: f64;
    var phi_12041_: f64;
    var phi_12046_: f64;
    var phi_12060_: f64;
    var phi_12066_: f64;
    var phi_12071_: f64;
    var phi_12077_: f64;
    var phi_12082_: f64;
    var phi_12108_: f64;
    var phi_12115_: f64;
    var phi_12120_: f64;
    var phi_12127_: f64;
    var phi_12132_: f64;
    var phi_12145_: f64;
    var phi_12152_: f64;
    var phi_12157_: f64;
    var phi_12164_: f64;
    var phi_12169_: f64;
    var phi_12174_: f64;
    var phi_12233_: f64;
    var phi_12239_: f64;
    var phi_12244_: f64;
    var phi_12250_: f64;
    var phi_12255_: f64;
    var phi_12269_: f64;
    var phi_12275_: f64;
    var phi_12280_: f64;
    var phi_12286_: f64;
    var phi_12291_: f64;
    var phi_12340_: f64;
    var phi_12346_: f64;
    var phi_12374_: f64;
    var phi_12380_: f64;
    var phi_12385_: u32;
    var phi_12386_: u32;
    var phi_12356_: f64;
    var phi_12362_: f64;
    var phi_12367_: u32;
    var phi_12368_: u32;
    var phi_12387_: u32;
    var phi_12388_: u32;
    var phi_12461_: f64;
    var phi_12473_: f64;
    var phi_12616_: f64;
    var phi_12622_: f64;
    var phi_12629_: f64;
    var phi_12685_: type_12;
    var phi_12688_: bool;
    var phi_12686_: type_12;
    var phi_12711_: type_12;
    var phi_12738_: bool;
    var phi_12739_: bool;
    var phi_12689_: bool;
    var phi_12740_: bool;
    var phi_12741_: bool;
    var local_26: bool;
    var phi_12745_: bool;
    var local_27: bool;
    var phi_12752_: u32;
    var phi_12753_: u32;
    var phi_12754_: bool;
    var phi_12755_: u32;
    var phi_12756_: u32;
    var phi_12757_: bool;
    var phi_12761_: u32;
    var phi_12771_: bool;
    var phi_12784_: bool;
    var phi_12785_: bool;
    var phi_12933_: f64;
    var phi_12940_: f64;
    var phi_12945_: f64;
    var phi_12952_: f64;
    var phi_12957_: f64;
    var phi_12970_: f64;
    var phi_12977_: f64;
    var phi_12982_: f64;
    var phi_12989_: f64;
    var phi_12994_: f64;
    var phi_12999_: f64;
    var phi_13016_: f64;
    var phi_13023_: f64;
    var phi_13028_: f64;
    var phi_13035_: f64;
    var phi_13040_: f64;
    var phi_13054_: f64;
    var phi_13061_: f64;
    var phi_13066_: f64;
    var phi_13073_: f64;
    var phi_13078_: f64;
    var phi_13083_: f64;
    var phi_13100_: f64;
    var phi_13107_: f64;
    var phi_13112_: f64;
    var phi_13119_: f64;
    var phi_13124_: f64;
    var phi_13138_: f64;
    var phi_13145_: f64;
    var phi_13150_: f64;
    var phi_13157_: f64;
    var phi_13162_: f64;
    var phi_13167_: f64;
    var phi_13214_: type_12;
    var phi_13217_: f64;
    var phi_13219_: f64;
    var phi_13221_: f64;
    var phi_13223_: f64;
    var phi_13225_: bool;
    var phi_13227_: u32;
    var phi_13215_: type_12;
    var phi_13250_: type_12;
    var phi_13365_: f64;
    var phi_13371_: f64;
    var phi_13377_: f64;
    var phi_13379_: array<f64, 3>;
    var phi_13386_: f64;
    var phi_13393_: f64;
    var phi_13401_: f64;
    var phi_13447_: type_16;
    var phi_13450_: f64;
    var phi_13471_: bool;
    var phi_13477_: type_17;
    var phi_13448_: type_16;
    var phi_13491_: type_17;
    var phi_13451_: f64;
    var local_28: f64;
    var phi_13440_: f64;
    var phi_13504_: f64;
    var phi_13573_: f64;
    var phi_13579_: f64;
    var phi_13588_: f64;
    var phi_13594_: f64;
    var phi_13603_: f64;
    var phi_13609_: f64;
    var phi_13618_: f64;
    var phi_13624_: f64;
    var phi_13630_: type_38;
    var phi_13631_: bool;
    var phi_13632_: type_38;
    var phi_13633_: bool;
    var phi_13643_: type_38;
    var phi_13815_: bool;
    var phi_13816_: bool;
    var phi_13817_: bool;
    var phi_13818_: bool;
    var phi_13819_: bool;
    var phi_13820_: bool;
    var phi_13824_: bool;
    var phi_14122_: bool;
    var phi_14123_: bool;
    var phi_14124_: bool;
    var phi_14125_: bool;
    var phi_14126_: bool;
    var phi_14127_: bool;
    var phi_14131_: bool;
    var phi_14135_: bool;
    var phi_14146_: bool;
    var phi_14147_: bool;
    var phi_14221_: bool;
    var phi_14222_: bool;
    var phi_14245_: f64;
    var phi_14246_: bool;
    var phi_14247_: f64;
    var phi_14248_: bool;
    var phi_14249_: f64;
    var phi_14250_: bool;
    var phi_14251_: bool;
    var phi_14256_: f64;
    var phi_14257_: bool;
    var phi_14261_: f64;
    var phi_14293_: bool;
    var phi_14294_: bool;
    var phi_14317_: f64;
    var phi_14318_: bool;
    var phi_14319_: f64;
    var phi_14320_: bool;
    var phi_14321_: f64;
    var phi_14322_: bool;
    var phi_14323_: bool;
    var phi_14328_: f64;
    var phi_14329_: bool;
    var phi_14333_: f64;
    var phi_14338_: f64;
    var phi_14370_: bool;
    var phi_14371_: bool;
    var phi_14394_: f64;
    var phi_14395_: bool;
    var phi_14396_: f64;
    var phi_14397_: bool;
    var phi_14398_: f64;
    var phi_14399_: bool;
    var phi_14400_: bool;
    var phi_14405_: f64;
    var phi_14406_: bool;
    var phi_14410_: f64;
    var phi_14442_: bool;
    var phi_14443_: bool;
    var phi_14466_: f64;
    var phi_14467_: bool;
    var phi_14468_: f64;
    var phi_14469_: bool;
    var phi_14470_: f64;
    var phi_14471_: bool;
    var phi_14472_: bool;
    var phi_14477_: f64;
    var phi_14478_: bool;
    var phi_14482_: f64;
    var phi_14487_: f64;
    var phi_14492_: f64;
    var phi_14497_: f64;
    var phi_14511_: f64;
    var phi_14649_: type_16;
    var phi_14652_: f64;
    var phi_14673_: bool;
    var phi_14679_: type_17;
    var phi_14650_: type_16;
    var phi_14693_: type_17;
    var phi_14653_: f64;
    var local_29: f64;
    var phi_14642_: f64;
    var phi_14706_: f64;
    var phi_14724_: f64;
    var phi_14731_: f64;
    var phi_14736_: f64;
    var phi_14743_: f64;
    var phi_14748_: f64;
    var phi_14761_: f64;
    var phi_14768_: f64;
    var phi_14773_: f64;
    var phi_14780_: f64;
    var phi_14785_: f64;
    var phi_14790_: f64;
    var phi_14807_: f64;
    var phi_14814_: f64;
    var phi_14819_: f64;
    var phi_14826_: f64;
    var phi_14831_: f64;
    var phi_14845_: f64;
    var phi_14852_: f64;
    var phi_14857_: f64;
    var phi_14864_: f64;
    var phi_14869_: f64;
    var phi_14874_: f64;
    var phi_14891_: f64;
    var phi_14898_: f64;
    var phi_14903_: f64;
    var phi_14910_: f64;
    var phi_14915_: f64;
    var phi_14929_: f64;
    var phi_14936_: f64;
    var phi_14941_: f64;
    var phi_14948_: f64;
    var phi_14953_: f64;
    var phi_14958_: f64;
    var phi_14982_: bool;
    var phi_14983_: bool;
    var phi_14984_: bool;
    var phi_15001_: f64;
    var phi_15002_: bool;
    var phi_15003_: f64;
    var phi_15004_: bool;
    var phi_15009_: f64;
    var phi_15011_: f64;
    var phi_15012_: f64;
    var phi_15013_: bool;
    var phi_15014_: f64;
    var phi_15015_: f64;
    var phi_15016_: bool;
    var phi_15017_: bool;
    var phi_15018_: f64;
    var phi_15019_: f64;
    var phi_15020_: f64;
    var phi_15021_: f64;
    var phi_15022_: bool;
    var phi_15023_: bool;
    var phi_15024_: bool;
    var phi_15025_: bool;
    var phi_15026_: f64;
    var phi_15027_: f64;
    var phi_15028_: f64;
    var phi_15029_: f64;
    var phi_15030_: bool;
    var phi_15031_: bool;
    var phi_15032_: bool;
    var phi_15033_: bool;
    var phi_15034_: bool;
    var phi_15035_: f64;
    var phi_15036_: f64;
    var phi_15037_: f64;
    var phi_15038_: f64;
    var phi_15039_: bool;
    var phi_15040_: bool;
    var phi_15041_: bool;
    var phi_15042_: bool;
    var phi_15043_: bool;
    var phi_15129_: f64;
    var phi_15202_: f64;
    var phi_15207_: f64;
    var phi_15280_: f64;
    var phi_15353_: f64;
    var phi_15358_: f64;
    var phi_15379_: f64;
    var phi_15380_: f64;
    var phi_15381_: f64;
    var phi_15056_: bool;
    var phi_15383_: u32;
    var phi_15384_: f64;
    var phi_15385_: bool;
    var phi_15386_: bool;
    var phi_15387_: bool;
    var phi_15388_: u32;
    var phi_15389_: f64;
    var phi_15390_: f64;
    var phi_15391_: f64;
    var phi_15392_: f64;
    var phi_15393_: bool;
    var phi_15394_: u32;
    var phi_15395_: bool;
    var phi_15396_: bool;
    var phi_15397_: bool;
    var phi_15398_: bool;
    var phi_15399_: bool;
    var phi_15400_: bool;
    var phi_15409_: f64;
    var phi_15414_: f64;
    var phi_15423_: bool;
    var phi_15427_: bool;
    var phi_15428_: f64;
    var phi_15429_: f64;
    var phi_15430_: f64;
    var phi_15431_: f64;
    var phi_15432_: bool;
    var phi_15433_: u32;
    var phi_15434_: bool;
    var phi_15435_: bool;
    var phi_15436_: bool;
    var phi_15437_: bool;
    var phi_15438_: bool;
    var phi_15439_: bool;
    var phi_13218_: f64;
    var phi_13220_: f64;
    var phi_13222_: f64;
    var phi_13224_: f64;
    var phi_13226_: bool;
    var phi_13228_: u32;
    var phi_15440_: f64;
    var phi_15441_: f64;
    var phi_15442_: bool;
    var phi_15443_: bool;
    var phi_15444_: bool;
    var phi_15445_: bool;
    var phi_15446_: bool;
    var phi_15447_: bool;
    var phi_15448_: bool;
    var local_30: bool;
    var phi_15452_: bool;
    var phi_15453_: bool;
    var phi_15454_: bool;
    var phi_15455_: bool;
    var phi_15456_: bool;
    var local_31: f64;
    var phi_15461_: type_46;
    var phi_15462_: bool;
    var phi_15463_: bool;
    var phi_15464_: bool;
    var phi_15465_: bool;
    var phi_15466_: bool;
    var phi_15471_: type_46;
    var phi_15472_: bool;
    var phi_15473_: bool;
    var phi_15474_: bool;
    var phi_15475_: bool;
    var phi_15476_: bool;
    var phi_15480_: f64;
    var phi_15481_: bool;
    var phi_15482_: bool;
    var phi_15483_: bool;
    var phi_15484_: bool;
    var phi_15488_: f64;
    var phi_15489_: bool;
    var phi_15490_: bool;
    var phi_15491_: bool;
    var phi_15496_: type_46;
    var phi_15497_: bool;
    var phi_15498_: bool;
    var phi_15503_: type_46;
    var phi_15504_: bool;
    var phi_15508_: type_46;
    var phi_15515_: bool;
    var phi_15516_: f64;
    var phi_15517_: bool;
    var phi_15518_: bool;
    var phi_15519_: bool;
    var phi_15520_: bool;
    var phi_15521_: f64;
    var phi_15522_: f64;
    var phi_15523_: bool;
    var phi_15524_: bool;
    var phi_15525_: bool;
    var phi_15526_: bool;
    var phi_15527_: f64;
    var phi_15528_: f64;
    var phi_15529_: bool;
    var phi_15530_: bool;
    var phi_15531_: bool;
    var phi_15532_: bool;
    var phi_15536_: bool;
    var phi_15537_: bool;
    var phi_15538_: bool;
    var phi_15539_: type_49;
    var phi_15540_: bool;
    var phi_15541_: f64;
    var phi_15542_: f64;
    var phi_15543_: type_49;
    var phi_15544_: bool;
    var phi_15545_: bool;
    var phi_15546_: bool;
    var phi_15547_: bool;
    var phi_15551_: bool;
    var phi_15552_: bool;
    var phi_15553_: bool;
    var phi_15554_: type_49;
    var phi_15555_: bool;
    var phi_15556_: f64;
    var phi_15557_: f64;
    var phi_15558_: type_49;
    var phi_15559_: bool;
    var phi_15560_: bool;
    var phi_15561_: bool;
    var phi_15562_: bool;
    var local_32: bool;
    var phi_15567_: type_46;
    var phi_15568_: bool;
    var phi_15569_: bool;
    var local_33: bool;
    var local_34: type_49;
    var local_35: f64;
    var local_36: f64;
    var local_37: f64;
    var phi_15583_: type_46;
    var phi_15584_: bool;
    var phi_15585_: type_46;
    var phi_15586_: bool;
    var local_38: f64;
    var phi_15591_: type_46;
    var phi_15592_: type_46;
    var phi_15593_: bool;
    var local_39: type_49;
    var phi_15599_: type_46;
    var phi_15600_: bool;
    var phi_15604_: type_46;
    var phi_15605_: type_46;
    var phi_15606_: bool;
    var phi_15610_: type_46;
    var phi_15611_: type_46;
    var phi_15612_: bool;
    var phi_15616_: type_46;
    var phi_15627_: bool;
    var phi_15628_: bool;
    var phi_15632_: bool;
    var phi_15636_: u32;
    var phi_1325_: type_16;
    var phi_1328_: f64;
    var phi_1349_: bool;
    var phi_1355_: type_17;
    var phi_1326_: type_16;
    var phi_1369_: type_17;
    var phi_1329_: f64;
    var local_40: f64;
    var phi_1318_: f64;
    var phi_1382_: f64;
    var phi_1400_: f64;
    var phi_1407_: f64;
    var phi_1412_: f64;
    var phi_1419_: f64;
    var phi_1424_: f64;
    var phi_1437_: f64;
    var phi_1444_: f64;
    var phi_1449_: f64;
    var phi_1456_: f64;
    var phi_1461_: f64;
    var phi_1466_: f64;
    var phi_1483_: f64;
    var phi_1490_: f64;
    var phi_1495_: f64;
    var phi_1502_: f64;
    var phi_1507_: f64;
    var phi_1521_: f64;
    var phi_1528_: f64;
    var phi_1533_: f64;
    var phi_1540_: f64;
    var phi_1545_: f64;
    var phi_1550_: f64;
    var phi_1567_: f64;
    var phi_1574_: f64;
    var phi_1579_: f64;
    var phi_1586_: f64;
    var phi_1591_: f64;
    var phi_1605_: f64;
    var phi_1612_: f64;
    var phi_1617_: f64;
    var phi_1624_: f64;
    var phi_1629_: f64;
    var phi_1634_: f64;
    var phi_1899_: f64;
    var phi_1906_: f64;
    var phi_1911_: f64;
    var phi_1918_: f64;
    var phi_1923_: f64;
    var phi_1936_: f64;
    var phi_1943_: f64;
    var phi_1948_: f64;
    var phi_1955_: f64;
    var phi_1960_: f64;
    var phi_1965_: f64;
    var phi_1982_: f64;
    var phi_1989_: f64;
    var phi_1994_: f64;
    var phi_2001_: f64;
    var phi_2006_: f64;
    var phi_2020_: f64;
    var phi_2027_: f64;
    var phi_2032_: f64;
    var phi_2039_: f64;
    var phi_2044_: f64;
    var phi_2049_: f64;
    var phi_2066_: f64;
    var phi_2073_: f64;
    var phi_2078_: f64;
    var phi_2085_: f64;
    var phi_2090_: f64;
    var phi_2104_: f64;
    var phi_2111_: f64;
    var phi_2116_: f64;
    var phi_2123_: f64;
    var phi_2128_: f64;
    var phi_2133_: f64;
    var phi_2170_: f64;
    var phi_2176_: f64;
    var phi_2183_: f64;
    var phi_2190_: f64;
    var phi_2196_: f64;
    var phi_2203_: f64;
    var phi_2209_: f64;
    var phi_2215_: f64;
    var phi_2221_: f64;
    var phi_2228_: f64;
    var phi_2235_: f64;
    var phi_2263_: f64;
    var phi_2268_: f64;
    var phi_2273_: f64;
    var phi_2278_: f64;
    var phi_2283_: f64;
    var phi_2288_: f64;
    var phi_2299_: f64;
    var phi_2309_: type_47;
    var phi_2310_: bool;
    var phi_2311_: type_47;
    var phi_2312_: bool;
    var phi_2318_: type_16;
    var phi_2321_: f64;
    var phi_2323_: u32;
    var phi_2325_: f64;
    var phi_2346_: bool;
    var phi_2352_: type_17;
    var phi_2319_: type_16;
    var phi_2366_: type_17;
    var phi_2381_: bool;
    var phi_2382_: bool;
    var phi_2528_: f64;
    var phi_2535_: f64;
    var phi_2540_: f64;
    var phi_2547_: f64;
    var phi_2552_: f64;
    var phi_2565_: f64;
    var phi_2572_: f64;
    var phi_2577_: f64;
    var phi_2584_: f64;
    var phi_2589_: f64;
    var phi_2594_: f64;
    var phi_2611_: f64;
    var phi_2618_: f64;
    var phi_2623_: f64;
    var phi_2630_: f64;
    var phi_2635_: f64;
    var phi_2649_: f64;
    var phi_2656_: f64;
    var phi_2661_: f64;
    var phi_2668_: f64;
    var phi_2673_: f64;
    var phi_2678_: f64;
    var phi_2695_: f64;
    var phi_2702_: f64;
    var phi_2707_: f64;
    var phi_2714_: f64;
    var phi_2719_: f64;
    var phi_2733_: f64;
    var phi_2740_: f64;
    var phi_2745_: f64;
    var phi_2752_: f64;
    var phi_2757_: f64;
    var phi_2762_: f64;
    var phi_2809_: type_12;
    var phi_2812_: f64;
    var phi_2814_: f64;
    var phi_2816_: f64;
    var phi_2818_: f64;
    var phi_2820_: bool;
    var phi_2822_: u32;
    var phi_2810_: type_12;
    var phi_2845_: type_12;
    var phi_2960_: f64;
    var phi_2966_: f64;
    var phi_2972_: f64;
    var phi_2974_: array<f64, 3>;
    var phi_2981_: f64;
    var phi_2988_: f64;
    var phi_2996_: f64;
    var phi_3042_: type_16;
    var phi_3045_: f64;
    var phi_3066_: bool;
    var phi_3072_: type_17;
    var phi_3043_: type_16;
    var phi_3086_: type_17;
    var phi_3046_: f64;
    var local_41: f64;
    var phi_3035_: f64;
    var phi_3099_: f64;
    var phi_3168_: f64;
    var phi_3174_: f64;
    var phi_3183_: f64;
    var phi_3189_: f64;
    var phi_3198_: f64;
    var phi_3204_: f64;
    var phi_3213_: f64;
    var phi_3219_: f64;
    var phi_3225_: type_38;
    var phi_3226_: bool;
    var phi_3227_: type_38;
    var phi_3228_: bool;
    var phi_3238_: type_38;
    var phi_3410_: bool;
    var phi_3411_: bool;
    var phi_3412_: bool;
    var phi_3413_: bool;
    var phi_3414_: bool;
    var phi_3415_: bool;
    var phi_3419_: bool;
    var phi_3717_: bool;
    var phi_3718_: bool;
    var phi_3719_: bool;
    var phi_3720_: bool;
    var phi_3721_: bool;
    var phi_3722_: bool;
    var phi_3726_: bool;
    var phi_3730_: bool;
    var phi_3741_: bool;
    var phi_3742_: bool;
    var phi_3816_: bool;
    var phi_3817_: bool;
    var phi_3840_: f64;
    var phi_3841_: bool;
    var phi_3842_: f64;
    var phi_3843_: bool;
    var phi_3844_: f64;
    var phi_3845_: bool;
    var phi_3846_: bool;
    var phi_3851_: f64;
    var phi_3852_: bool;
    var phi_3856_: f64;
    var phi_3888_: bool;
    var phi_3889_: bool;
    var phi_3912_: f64;
    var phi_3913_: bool;
    var phi_3914_: f64;
    var phi_3915_: bool;
    var phi_3916_: f64;
    var phi_3917_: bool;
    var phi_3918_: bool;
    var phi_3923_: f64;
    var phi_3924_: bool;
    var phi_3928_: f64;
    var phi_3933_: f64;
    var phi_3965_: bool;
    var phi_3966_: bool;
    var phi_3989_: f64;
    var phi_3990_: bool;
    var phi_3991_: f64;
    var phi_3992_: bool;
    var phi_3993_: f64;
    var phi_3994_: bool;
    var phi_3995_: bool;
    var phi_4000_: f64;
    var phi_4001_: bool;
    var phi_4005_: f64;
    var phi_4037_: bool;
    var phi_4038_: bool;
    var phi_4061_: f64;
    var phi_4062_: bool;
    var phi_4063_: f64;
    var phi_4064_: bool;
    var phi_4065_: f64;
    var phi_4066_: bool;
    var phi_4067_: bool;
    var phi_4072_: f64;
    var phi_4073_: bool;
    var phi_4077_: f64;
    var phi_4082_: f64;
    var phi_4087_: f64;
    var phi_4092_: f64;
    var phi_4106_: f64;
    var phi_4244_: type_16;
    var phi_4247_: f64;
    var phi_4268_: bool;
    var phi_4274_: type_17;
    var phi_4245_: type_16;
    var phi_4288_: type_17;
    var phi_4248_: f64;
    var local_42: f64;
    var phi_4237_: f64;
    var phi_4301_: f64;
    var phi_4319_: f64;
    var phi_4326_: f64;
    var phi_4331_: f64;
    var phi_4338_: f64;
    var phi_4343_: f64;
    var phi_4356_: f64;
    var phi_4363_: f64;
    var phi_4368_: f64;
    var phi_4375_: f64;
    var phi_4380_: f64;
    var phi_4385_: f64;
    var phi_4402_: f64;
    var phi_4409_: f64;
    var phi_4414_: f64;
    var phi_4421_: f64;
    var phi_4426_: f64;
    var phi_4440_: f64;
    var phi_4447_: f64;
    var phi_4452_: f64;
    var phi_4459_: f64;
    var phi_4464_: f64;
    var phi_4469_: f64;
    var phi_4486_: f64;
    var phi_4493_: f64;
    var phi_4498_: f64;
    var phi_4505_: f64;
    var phi_4510_: f64;
    var phi_4524_: f64;
    var phi_4531_: f64;
    var phi_4536_: f64;
    var phi_4543_: f64;
    var phi_4548_: f64;
    var phi_4553_: f64;
    var phi_4577_: bool;
    var phi_4578_: bool;
    var phi_4579_: bool;
    var phi_4596_: f64;
    var phi_4597_: bool;
    var phi_4598_: f64;
    var phi_4599_: bool;
    var phi_4604_: f64;
    var phi_4606_: f64;
    var phi_4607_: f64;
    var phi_4608_: bool;
    var phi_4609_: f64;
    var phi_4610_: f64;
    var phi_4611_: bool;
    var phi_4612_: bool;
    var phi_4613_: f64;
    var phi_4614_: f64;
    var phi_4615_: f64;
    var phi_4616_: f64;
    var phi_4617_: bool;
    var phi_4618_: bool;
    var phi_4619_: bool;
    var phi_4620_: bool;
    var phi_4621_: f64;
    var phi_4622_: f64;
    var phi_4623_: f64;
    var phi_4624_: f64;
    var phi_4625_: bool;
    var phi_4626_: bool;
    var phi_4627_: bool;
    var phi_4628_: bool;
    var phi_4629_: bool;
    var phi_4630_: f64;
    var phi_4631_: f64;
    var phi_4632_: f64;
    var phi_4633_: f64;
    var phi_4634_: bool;
    var phi_4635_: bool;
    var phi_4636_: bool;
    var phi_4637_: bool;
    var phi_4638_: bool;
    var phi_4724_: f64;
    var phi_4797_: f64;
    var phi_4802_: f64;
    var phi_4875_: f64;
    var phi_4948_: f64;
    var phi_4953_: f64;
    var phi_4974_: f64;
    var phi_4975_: f64;
    var phi_4976_: f64;
    var phi_4651_: bool;
    var phi_4978_: u32;
    var phi_4979_: f64;
    var phi_4980_: bool;
    var phi_4981_: bool;
    var phi_4982_: bool;
    var phi_4983_: u32;
    var phi_4984_: f64;
    var phi_4985_: f64;
    var phi_4986_: f64;
    var phi_4987_: f64;
    var phi_4988_: bool;
    var phi_4989_: u32;
    var phi_4990_: bool;
    var phi_4991_: bool;
    var phi_4992_: bool;
    var phi_4993_: bool;
    var phi_4994_: bool;
    var phi_4995_: bool;
    var phi_5004_: f64;
    var phi_5009_: f64;
    var phi_5018_: bool;
    var phi_5022_: bool;
    var phi_5023_: f64;
    var phi_5024_: f64;
    var phi_5025_: f64;
    var phi_5026_: f64;
    var phi_5027_: bool;
    var phi_5028_: u32;
    var phi_5029_: bool;
    var phi_5030_: bool;
    var phi_5031_: bool;
    var phi_5032_: bool;
    var phi_5033_: bool;
    var phi_5034_: bool;
    var phi_2813_: f64;
    var phi_2815_: f64;
    var phi_2817_: f64;
    var phi_2819_: f64;
    var phi_2821_: bool;
    var phi_2823_: u32;
    var phi_5035_: f64;
    var phi_5036_: f64;
    var phi_5037_: bool;
    var phi_5038_: bool;
    var phi_5039_: bool;
    var phi_5040_: bool;
    var phi_5041_: bool;
    var phi_5042_: bool;
    var phi_5043_: bool;
    var local_43: bool;
    var phi_5047_: bool;
    var phi_5048_: bool;
    var phi_5049_: bool;
    var phi_5050_: bool;
    var phi_5051_: bool;
    var local_44: f64;
    var phi_5056_: type_46;
    var phi_5057_: bool;
    var phi_5058_: bool;
    var phi_5059_: bool;
    var phi_5060_: bool;
    var phi_5061_: bool;
    var phi_5066_: type_46;
    var phi_5067_: bool;
    var phi_5068_: bool;
    var phi_5069_: bool;
    var phi_5070_: bool;
    var phi_5071_: bool;
    var phi_5075_: f64;
    var phi_5076_: bool;
    var phi_5077_: bool;
    var phi_5078_: bool;
    var phi_5079_: bool;
    var phi_5083_: f64;
    var phi_5084_: bool;
    var phi_5085_: bool;
    var phi_5086_: bool;
    var phi_5091_: type_46;
    var phi_5092_: bool;
    var phi_5093_: bool;
    var phi_5098_: type_46;
    var phi_5099_: bool;
    var phi_5103_: type_46;
    var phi_5110_: f64;
    var phi_5111_: bool;
    var phi_5224_: f64;
    var phi_5231_: f64;
    var phi_5239_: f64;
    var phi_5390_: f64;
    var phi_5397_: f64;
    var phi_5402_: f64;
    var phi_5409_: f64;
    var phi_5414_: f64;
    var phi_5427_: f64;
    var phi_5434_: f64;
    var phi_5439_: f64;
    var phi_5446_: f64;
    var phi_5451_: f64;
    var phi_5456_: f64;
    var phi_5473_: f64;
    var phi_5480_: f64;
    var phi_5485_: f64;
    var phi_5492_: f64;
    var phi_5497_: f64;
    var phi_5511_: f64;
    var phi_5518_: f64;
    var phi_5523_: f64;
    var phi_5530_: f64;
    var phi_5535_: f64;
    var phi_5540_: f64;
    var phi_5557_: f64;
    var phi_5564_: f64;
    var phi_5569_: f64;
    var phi_5576_: f64;
    var phi_5581_: f64;
    var phi_5595_: f64;
    var phi_5602_: f64;
    var phi_5607_: f64;
    var phi_5614_: f64;
    var phi_5619_: f64;
    var phi_5624_: f64;
    var phi_5736_: type_16;
    var phi_5739_: f64;
    var phi_5760_: bool;
    var phi_5766_: type_17;
    var phi_5737_: type_16;
    var phi_5780_: type_17;
    var phi_5740_: f64;
    var local_45: f64;
    var phi_5729_: f64;
    var phi_5793_: f64;
    var phi_5930_: f64;
    var phi_5936_: f64;
    var phi_5945_: f64;
    var phi_5951_: f64;
    var phi_5960_: f64;
    var phi_5966_: f64;
    var phi_5975_: f64;
    var phi_5981_: f64;
    var phi_6031_: type_16;
    var phi_6034_: f64;
    var phi_6055_: bool;
    var phi_6061_: type_17;
    var phi_6032_: type_16;
    var phi_6075_: type_17;
    var phi_6035_: f64;
    var local_46: f64;
    var phi_6024_: f64;
    var phi_6088_: f64;
    var phi_6120_: type_16;
    var phi_6123_: f64;
    var phi_6144_: bool;
    var phi_6150_: type_17;
    var phi_6121_: type_16;
    var phi_6164_: type_17;
    var phi_6124_: f64;
    var local_47: f64;
    var phi_6113_: f64;
    var phi_6177_: f64;
    var phi_6195_: f64;
    var phi_6202_: f64;
    var phi_6207_: f64;
    var phi_6214_: f64;
    var phi_6219_: f64;
    var phi_6232_: f64;
    var phi_6239_: f64;
    var phi_6244_: f64;
    var phi_6251_: f64;
    var phi_6256_: f64;
    var phi_6261_: f64;
    var phi_6278_: f64;
    var phi_6285_: f64;
    var phi_6290_: f64;
    var phi_6297_: f64;
    var phi_6302_: f64;
    var phi_6316_: f64;
    var phi_6323_: f64;
    var phi_6328_: f64;
    var phi_6335_: f64;
    var phi_6340_: f64;
    var phi_6345_: f64;
    var phi_6362_: f64;
    var phi_6369_: f64;
    var phi_6374_: f64;
    var phi_6381_: f64;
    var phi_6386_: f64;
    var phi_6400_: f64;
    var phi_6407_: f64;
    var phi_6412_: f64;
    var phi_6419_: f64;
    var phi_6424_: f64;
    var phi_6429_: f64;
    var phi_6477_: f64;
    var phi_6483_: f64;
    var phi_6495_: type_12;
    var phi_6498_: f64;
    var phi_6496_: type_12;
    var phi_6521_: type_12;
    var phi_6551_: f64;
    var phi_6557_: f64;
    var phi_6571_: f64;
    var phi_6499_: f64;
    var local_48: f64;
    var local_49: f64;
    var phi_6600_: type_16;
    var phi_6603_: f64;
    var phi_6624_: bool;
    var phi_6630_: type_17;
    var phi_6601_: type_16;
    var phi_6644_: type_17;
    var phi_6604_: f64;
    var local_50: f64;
    var phi_6593_: f64;
    var phi_6657_: f64;
    var phi_6664_: type_12;
    var phi_6667_: f64;
    var phi_6669_: bool;
    var phi_6671_: bool;
    var phi_6665_: type_12;
    var phi_6694_: type_12;
    var phi_6731_: f64;
    var phi_6738_: f64;
    var phi_6746_: f64;
    var phi_6754_: f64;
    var phi_6761_: f64;
    var phi_6769_: f64;
    var phi_6775_: f64;
    var phi_6795_: f64;
    var phi_6801_: f64;
    var phi_6808_: f64;
    var phi_6837_: f64;
    var phi_6843_: f64;
    var phi_6880_: bool;
    var phi_6887_: bool;
    var phi_6900_: f64;
    var phi_6906_: f64;
    var phi_6907_: f64;
    var phi_6908_: f64;
    var phi_6668_: f64;
    var phi_6670_: bool;
    var phi_6672_: bool;
    var local_51: f64;
    var phi_6914_: f64;
    var local_52: bool;
    var local_53: bool;
    var phi_6925_: type_48;
    var phi_6926_: type_48;
    var phi_6927_: bool;
    var local_54: bool;
    var phi_6945_: f64;
    var phi_6946_: f64;
    var phi_6949_: type_12;
    var phi_6952_: f64;
    var phi_6954_: f64;
    var phi_6950_: type_12;
    var phi_6977_: type_12;
    var phi_7063_: f64;
    var phi_7064_: f64;
    var phi_7065_: f64;
    var phi_7046_: f64;
    var phi_7066_: f64;
    var phi_7067_: f64;
    var phi_6953_: f64;
    var phi_6955_: f64;
    var local_55: f64;
    var local_56: f64;
    var local_57: f64;
    var phi_7230_: bool;
    var phi_7231_: bool;
    var phi_7232_: bool;
    var phi_7233_: bool;
    var phi_7234_: bool;
    var phi_7235_: bool;
    var phi_7239_: bool;
    var phi_7243_: bool;
    var phi_7244_: bool;
    var phi_7245_: bool;
    var phi_7250_: f64;
    var phi_7254_: type_48;
    var phi_7255_: type_48;
    var phi_7256_: bool;
    var phi_7257_: type_48;
    var phi_7258_: type_48;
    var phi_7259_: bool;
    var phi_7265_: type_48;
    var phi_7266_: type_48;
    var phi_7267_: bool;
    var phi_7271_: type_48;
    var phi_7272_: type_48;
    var phi_7273_: bool;
    var phi_7274_: bool;
    var phi_7275_: type_48;
    var phi_7276_: type_48;
    var phi_7277_: bool;
    var phi_7278_: bool;
    var phi_7284_: type_48;
    var phi_7285_: bool;
    var phi_7289_: type_48;
    var phi_7305_: f64;
    var phi_7306_: f64;
    var phi_7307_: bool;
    var phi_7308_: f64;
    var phi_7309_: f64;
    var phi_7310_: bool;
    var phi_7311_: bool;
    var phi_7312_: bool;
    var phi_7313_: f64;
    var phi_7314_: f64;
    var phi_7315_: bool;
    var phi_7316_: bool;
    var phi_7317_: bool;
    var phi_7318_: f64;
    var phi_7319_: u32;
    var phi_7320_: f64;
    var phi_7321_: type_48;
    var phi_7322_: u32;
    var phi_7323_: u32;
    var phi_7324_: bool;
    var phi_7325_: bool;
    var phi_7326_: bool;
    var phi_7327_: f64;
    var phi_7328_: u32;
    var phi_7329_: f64;
    var phi_7330_: type_48;
    var phi_7331_: u32;
    var phi_7332_: u32;
    var phi_7333_: bool;
    var phi_7334_: bool;
    var phi_7335_: bool;
    var phi_7336_: bool;
    var phi_7337_: bool;
    var phi_7338_: f64;
    var phi_2322_: f64;
    var phi_2324_: u32;
    var phi_2326_: f64;
    var phi_7339_: type_48;
    var phi_7340_: u32;
    var phi_7341_: f64;
    var phi_7342_: u32;
    var phi_7343_: bool;
    var phi_7344_: bool;
    var phi_7345_: bool;
    var phi_7346_: bool;
    var phi_7347_: bool;
    var phi_7348_: bool;
    var local_58: bool;
    var phi_7352_: bool;
    var phi_7353_: bool;
    var phi_7354_: bool;
    var phi_7355_: bool;
    var local_59: type_48;
    var local_60: type_48;
    var phi_7372_: u32;
    var local_61: type_48;
    var phi_7377_: type_47;
    var phi_7378_: type_47;
    var phi_7379_: bool;
    var phi_7380_: bool;
    var phi_7381_: bool;
    var phi_7382_: bool;
    var phi_7386_: u32;
    var phi_7387_: f64;
    var phi_7388_: bool;
    var phi_7389_: bool;
    var phi_7390_: bool;
    var phi_7391_: bool;
    var phi_7395_: f64;
    var phi_7396_: u32;
    var phi_7397_: bool;
    var phi_7398_: bool;
    var phi_7399_: bool;
    var phi_7413_: f64;
    var phi_7416_: type_12;
    var phi_7417_: type_12;
    var phi_7440_: type_12;
    var phi_7462_: f64;
    var phi_7592_: type_16;
    var phi_7595_: f64;
    var phi_7616_: bool;
    var phi_7622_: type_17;
    var phi_7593_: type_16;
    var phi_7636_: type_17;
    var phi_7596_: f64;
    var local_62: f64;
    var phi_7585_: f64;
    var phi_7649_: f64;
    var phi_7667_: f64;
    var phi_7674_: f64;
    var phi_7679_: f64;
    var phi_7686_: f64;
    var phi_7691_: f64;
    var phi_7704_: f64;
    var phi_7711_: f64;
    var phi_7716_: f64;
    var phi_7723_: f64;
    var phi_7728_: f64;
    var phi_7733_: f64;
    var phi_7750_: f64;
    var phi_7757_: f64;
    var phi_7762_: f64;
    var phi_7769_: f64;
    var phi_7774_: f64;
    var phi_7788_: f64;
    var phi_7795_: f64;
    var phi_7800_: f64;
    var phi_7807_: f64;
    var phi_7812_: f64;
    var phi_7817_: f64;
    var phi_7834_: f64;
    var phi_7841_: f64;
    var phi_7846_: f64;
    var phi_7853_: f64;
    var phi_7858_: f64;
    var phi_7872_: f64;
    var phi_7879_: f64;
    var phi_7884_: f64;
    var phi_7891_: f64;
    var phi_7896_: f64;
    var phi_7901_: f64;
    var phi_7925_: bool;
    var phi_7926_: bool;
    var phi_7927_: bool;
    var local_63: bool;
    var phi_7935_: u32;
    var phi_7939_: type_47;
    var phi_7940_: bool;
    var phi_7948_: u32;
    var phi_7952_: type_47;
    var phi_7953_: type_47;
    var phi_7954_: bool;
    var phi_7955_: bool;
    var phi_7962_: type_47;
    var phi_7963_: bool;
    var phi_7967_: type_47;
    var phi_7968_: type_47;
    var phi_7969_: bool;
    var phi_7973_: type_47;
    var phi_15640_: type_47;
    var phi_15655_: type_37;
    var phi_15679_: u32;
    var phi_15683_: type_22;
    var phi_15684_: bool;
    var phi_15703_: u32;
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
        phi_401_ = _e142;
    } else {
        phi_401_ = _e144;
    }
    let _e147 = phi_401_;
    let _e149 = params.member.member_1.member_1;
    if (_e147 > _e149) {
        let _e152 = params.member.member_1.member_1;
        phi_411_ = (_e147 - _e152);
    } else {
        phi_411_ = 0u;
    }
    let _e155 = phi_411_;
    let _e157 = params.member.member_1.member;
    if (_e157 < _e155) {
        phi_418_ = _e157;
    } else {
        phi_418_ = _e155;
    }
    let _e160 = phi_418_;
    let _e161 = (_e160 / 64u);
    if ((_e160 % 64u) > 0u) {
        phi_434_ = (_e161 + 1u);
    } else {
        phi_434_ = _e161;
    }
    let _e166 = phi_434_;
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
            phi_455_ = (_e170 + 1u);
        } else {
            phi_455_ = _e170;
        }
        let _e176 = phi_455_;
        phi_456_ = _e176;
    } else {
        phi_456_ = 0u;
    }
    let _e178 = phi_456_;
    phi_459_ = type_12(0u, _e178);
    loop {
        let _e181 = phi_459_;
        if (_e181.member < _e181.member_1) {
            phi_460_ = type_12((_e181.member + 1u), _e181.member_1);
            phi_483_ = type_12(1u, _e181.member);
        } else {
            phi_460_ = _e181;
            phi_483_ = type_12(0u, type_12().member_1);
        }
        let _e193 = phi_460_;
        let _e195 = phi_483_;
        let _e199 = (bitcast<i32>(_e195.member) != 0i);
        if _e199 {
            let _e203 = (((_e136 + (_e195.member_1 * _e139)) * 64u) + _e124);
            if (_e203 < _e160) {
                let _e207 = params.member.member_1.member_1;
                let _e209 = (2u * (_e207 + _e203));
                let _e212 = input.member[(4u + _e209)];
                let _e215 = input.member[(_e209 + 5u)];
                let _e218 = elements.member[_e212];
                let _e220 = elements.member[_e215];
                let _e226 = params.member.member.member_1;
                if ((_e226 & 8u) != 0u) {
                    let _e265 = paths.member[_e218[0]];
                    let _e267 = paths.member[_e218[1]];
                    let _e273 = paths.member[_e220[0]];
                    let _e275 = paths.member[_e220[1]];
                    let _e312 = function_(array<f32, 3>(_e265.member[0], _e265.member[1], _e265.member[2]));
                    let _e313 = function_(array<f32, 3>(_e267.member[0], _e267.member[1], _e267.member[2]));
                    let _e314 = function_(array<f32, 3>(_e273.member[0], _e273.member[1], _e273.member[2]));
                    let _e315 = function_(array<f32, 3>(_e275.member[0], _e275.member[1], _e275.member[2]));
                    let _e317 = function_(array<f32, 3>(_e265.member_1[0], _e265.member_1[1], _e265.member_1[2]));
                    let _e318 = function_(array<f32, 3>(_e267.member_1[0], _e267.member_1[1], _e267.member_1[2]));
                    let _e319 = function_(array<f32, 3>(_e273.member_1[0], _e273.member_1[1], _e273.member_1[2]));
                    let _e320 = function_(array<f32, 3>(_e275.member_1[0], _e275.member_1[1], _e275.member_1[2]));
                    phi_745_ = type_33(array<array<f64, 3>, 4>(_e312, _e313, _e314, _e315), array<array<f64, 3>, 4>(_e317, _e318, _e319, _e320));
                } else {
                    let _e230 = positions.member[_e218[0]];
                    let _e233 = params.member.member.member[0u];
                    let _e236 = positions.member[(_e233 + _e218[0])];
                    let _e238 = positions.member[_e218[1]];
                    let _e241 = params.member.member.member[0u];
                    let _e244 = positions.member[(_e241 + _e218[1])];
                    let _e246 = positions.member[_e220[0]];
                    let _e249 = params.member.member.member[0u];
                    let _e252 = positions.member[(_e249 + _e220[0])];
                    let _e254 = positions.member[_e220[1]];
                    let _e257 = params.member.member.member[0u];
                    let _e260 = positions.member[(_e257 + _e220[1])];
                    phi_745_ = type_33(array<array<f64, 3>, 4>(_e230, _e238, _e246, _e254), array<array<f64, 3>, 4>(_e236, _e244, _e252, _e260));
                }
                let _e324 = phi_745_;
                let _e331 = (_e324.member[2][0] - _e324.member[0][0]);
                let _e334 = (_e324.member[2][1] - _e324.member[0][1]);
                let _e337 = (_e324.member[2][2] - _e324.member[0][2]);
                let _e343 = (_e324.member_1[2][0] - _e324.member_1[0][0]);
                let _e346 = (_e324.member_1[2][1] - _e324.member_1[0][1]);
                let _e349 = (_e324.member_1[2][2] - _e324.member_1[0][2]);
                let _e356 = (_e324.member[1][0] - _e324.member[0][0]);
                let _e359 = (_e324.member[1][1] - _e324.member[0][1]);
                let _e362 = (_e324.member[1][2] - _e324.member[0][2]);
                let _e368 = (_e324.member_1[1][0] - _e324.member_1[0][0]);
                let _e371 = (_e324.member_1[1][1] - _e324.member_1[0][1]);
                let _e374 = (_e324.member_1[1][2] - _e324.member_1[0][2]);
                let _e381 = (_e324.member[2][0] - _e324.member[3][0]);
                let _e384 = (_e324.member[2][1] - _e324.member[3][1]);
                let _e387 = (_e324.member[2][2] - _e324.member[3][2]);
                let _e393 = (_e324.member_1[2][0] - _e324.member_1[3][0]);
                let _e396 = (_e324.member_1[2][1] - _e324.member_1[3][1]);
                let _e399 = (_e324.member_1[2][2] - _e324.member_1[3][2]);
                let _e402 = (0.0lf + 0.0lf);
                let _e405 = params.member.member.member_7;
                let _e412 = bitcast<f64>(((u64(_e405[1]) * 4294967296lu) + u64(_e405[0])));
                let _e414 = params.member.member.member_14;
                let _e421 = bitcast<f64>(((u64(_e414[1]) * 4294967296lu) + u64(_e414[0])));
                let _e423 = params.member.member.member_15;
                let _e430 = bitcast<f64>(((u64(_e423[1]) * 4294967296lu) + u64(_e423[0])));
                let _e432 = params.member.member.member_16;
                let _e439 = bitcast<f64>(((u64(_e432[1]) * 4294967296lu) + u64(_e432[0])));
                let _e441 = params.member.member.member_1;
                if (_e331 < 0.0lf) {
                    phi_870_ = -(_e331);
                } else {
                    phi_870_ = _e331;
                }
                let _e447 = phi_870_;
                if (_e334 < 0.0lf) {
                    phi_876_ = -(_e334);
                } else {
                    phi_876_ = _e334;
                }
                let _e451 = phi_876_;
                if (_e447 > _e451) {
                    phi_881_ = _e447;
                } else {
                    phi_881_ = _e451;
                }
                let _e454 = phi_881_;
                if (_e337 < 0.0lf) {
                    phi_887_ = -(_e337);
                } else {
                    phi_887_ = _e337;
                }
                let _e458 = phi_887_;
                if (_e454 > _e458) {
                    phi_892_ = _e454;
                } else {
                    phi_892_ = _e458;
                }
                let _e461 = phi_892_;
                if (_e343 < 0.0lf) {
                    phi_898_ = -(_e343);
                } else {
                    phi_898_ = _e343;
                }
                let _e465 = phi_898_;
                if (_e346 < 0.0lf) {
                    phi_904_ = -(_e346);
                } else {
                    phi_904_ = _e346;
                }
                let _e469 = phi_904_;
                if (_e465 > _e469) {
                    phi_909_ = _e465;
                } else {
                    phi_909_ = _e469;
                }
                let _e472 = phi_909_;
                if (_e349 < 0.0lf) {
                    phi_915_ = -(_e349);
                } else {
                    phi_915_ = _e349;
                }
                let _e476 = phi_915_;
                if (_e472 > _e476) {
                    phi_920_ = _e472;
                } else {
                    phi_920_ = _e476;
                }
                let _e479 = phi_920_;
                if (_e461 > _e479) {
                    phi_925_ = _e461;
                } else {
                    phi_925_ = _e479;
                }
                let _e482 = phi_925_;
                let _e483 = (_e482 + _e402);
                if (_e356 < 0.0lf) {
                    phi_932_ = -(_e356);
                } else {
                    phi_932_ = _e356;
                }
                let _e487 = phi_932_;
                if (_e359 < 0.0lf) {
                    phi_938_ = -(_e359);
                } else {
                    phi_938_ = _e359;
                }
                let _e491 = phi_938_;
                if (_e487 > _e491) {
                    phi_943_ = _e487;
                } else {
                    phi_943_ = _e491;
                }
                let _e494 = phi_943_;
                if (_e362 < 0.0lf) {
                    phi_949_ = -(_e362);
                } else {
                    phi_949_ = _e362;
                }
                let _e498 = phi_949_;
                if (_e494 > _e498) {
                    phi_954_ = _e494;
                } else {
                    phi_954_ = _e498;
                }
                let _e501 = phi_954_;
                if (_e368 < 0.0lf) {
                    phi_960_ = -(_e368);
                } else {
                    phi_960_ = _e368;
                }
                let _e505 = phi_960_;
                if (_e371 < 0.0lf) {
                    phi_966_ = -(_e371);
                } else {
                    phi_966_ = _e371;
                }
                let _e509 = phi_966_;
                if (_e505 > _e509) {
                    phi_971_ = _e505;
                } else {
                    phi_971_ = _e509;
                }
                let _e512 = phi_971_;
                if (_e374 < 0.0lf) {
                    phi_977_ = -(_e374);
                } else {
                    phi_977_ = _e374;
                }
                let _e516 = phi_977_;
                if (_e512 > _e516) {
                    phi_982_ = _e512;
                } else {
                    phi_982_ = _e516;
                }
                let _e519 = phi_982_;
                if (_e501 > _e519) {
                    phi_987_ = _e501;
                } else {
                    phi_987_ = _e519;
                }
                let _e522 = phi_987_;
                let _e523 = (_e522 + _e402);
                if (_e381 < 0.0lf) {
                    phi_994_ = -(_e381);
                } else {
                    phi_994_ = _e381;
                }
                let _e527 = phi_994_;
                if (_e384 < 0.0lf) {
                    phi_1000_ = -(_e384);
                } else {
                    phi_1000_ = _e384;
                }
                let _e531 = phi_1000_;
                if (_e527 > _e531) {
                    phi_1005_ = _e527;
                } else {
                    phi_1005_ = _e531;
                }
                let _e534 = phi_1005_;
                if (_e387 < 0.0lf) {
                    phi_1011_ = -(_e387);
                } else {
                    phi_1011_ = _e387;
                }
                let _e538 = phi_1011_;
                if (_e534 > _e538) {
                    phi_1016_ = _e534;
                } else {
                    phi_1016_ = _e538;
                }
                let _e541 = phi_1016_;
                if (_e393 < 0.0lf) {
                    phi_1022_ = -(_e393);
                } else {
                    phi_1022_ = _e393;
                }
                let _e545 = phi_1022_;
                if (_e396 < 0.0lf) {
                    phi_1028_ = -(_e396);
                } else {
                    phi_1028_ = _e396;
                }
                let _e549 = phi_1028_;
                if (_e545 > _e549) {
                    phi_1033_ = _e545;
                } else {
                    phi_1033_ = _e549;
                }
                let _e552 = phi_1033_;
                if (_e399 < 0.0lf) {
                    phi_1039_ = -(_e399);
                } else {
                    phi_1039_ = _e399;
                }
                let _e556 = phi_1039_;
                if (_e552 > _e556) {
                    phi_1044_ = _e552;
                } else {
                    phi_1044_ = _e556;
                }
                let _e559 = phi_1044_;
                if (_e541 > _e559) {
                    phi_1049_ = _e541;
                } else {
                    phi_1049_ = _e559;
                }
                let _e562 = phi_1049_;
                let _e563 = (_e562 + _e402);
                if (_e483 > _e523) {
                    phi_1055_ = _e483;
                } else {
                    phi_1055_ = _e523;
                }
                let _e566 = phi_1055_;
                if (_e566 > _e563) {
                    phi_1060_ = _e566;
                } else {
                    phi_1060_ = _e563;
                }
                let _e569 = phi_1060_;
                if (_e569 <= f64(65536f)) {
                    phi_1069_ = (_e569 >= f64((1f / 65536f)));
                } else {
                    phi_1069_ = false;
                }
                let _e576 = phi_1069_;
                if _e576 {
                    phi_1144_ = type_45();
                    phi_1145_ = true;
                } else {
                    if (_e569 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e569) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e583 = (9214364837600034816lu - (bitcast<u64>(_e569) & 9218868437227405312lu));
                            if (_e583 > 4503599627370496lu) {
                                phi_1093_ = _e583;
                            } else {
                                phi_1093_ = 4503599627370496lu;
                            }
                            let _e586 = phi_1093_;
                            let _e587 = bitcast<f64>(_e586);
                            let _e588 = (_e412 * _e587);
                            if (_e412 > f64(0f)) {
                                if (_e588 > 2.2250738585072014e-308lf) {
                                    phi_1105_ = _e588;
                                } else {
                                    phi_1105_ = 2.2250738585072014e-308lf;
                                }
                                let _e593 = phi_1105_;
                                phi_1106_ = _e593;
                            } else {
                                phi_1106_ = _e588;
                            }
                            let _e595 = phi_1106_;
                            phi_1140_ = type_45(type_35(array<array<f64, 3>, 2>(array<f64, 3>((_e331 * _e587), (_e334 * _e587), (_e337 * _e587)), array<f64, 3>((_e343 * _e587), (_e346 * _e587), (_e349 * _e587))), array<array<f64, 3>, 2>(array<f64, 3>((_e356 * _e587), (_e359 * _e587), (_e362 * _e587)), array<f64, 3>((_e368 * _e587), (_e371 * _e587), (_e374 * _e587))), array<array<f64, 3>, 2>(array<f64, 3>((_e381 * _e587), (_e384 * _e587), (_e387 * _e587)), array<f64, 3>((_e393 * _e587), (_e396 * _e587), (_e399 * _e587))), ((_e402 + (2.2250738585072014e-308lf * f64(8f))) * _e587)), _e595);
                            phi_1141_ = false;
                        } else {
                            phi_1140_ = type_45();
                            phi_1141_ = true;
                        }
                        let _e630 = phi_1140_;
                        let _e632 = phi_1141_;
                        phi_1142_ = _e630;
                        phi_1143_ = _e632;
                    } else {
                        phi_1142_ = type_45();
                        phi_1143_ = true;
                    }
                    let _e634 = phi_1142_;
                    let _e636 = phi_1143_;
                    phi_1144_ = _e634;
                    phi_1145_ = _e636;
                }
                let _e638 = phi_1144_;
                let _e640 = phi_1145_;
                if _e640 {
                    phi_1150_ = type_45(type_35(array<array<f64, 3>, 2>(array<f64, 3>(_e331, _e334, _e337), array<f64, 3>(_e343, _e346, _e349)), array<array<f64, 3>, 2>(array<f64, 3>(_e356, _e359, _e362), array<f64, 3>(_e368, _e371, _e374)), array<array<f64, 3>, 2>(array<f64, 3>(_e381, _e384, _e387), array<f64, 3>(_e393, _e396, _e399)), _e402), _e412);
                } else {
                    phi_1150_ = _e638;
                }
                let _e643 = phi_1150_;
                local_18 = type_35(array<array<f64, 3>, 2>(array<f64, 3>(_e643.member.member[0][0], _e643.member.member[0][1], _e643.member.member[0][2]), array<f64, 3>(_e643.member.member[1][0], _e643.member.member[1][1], _e643.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e643.member.member_1[0][0], _e643.member.member_1[0][1], _e643.member.member_1[0][2]), array<f64, 3>(_e643.member.member_1[1][0], _e643.member.member_1[1][1], _e643.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e643.member.member_2[0][0], _e643.member.member_2[0][1], _e643.member.member_2[0][2]), array<f64, 3>(_e643.member.member_2[1][0], _e643.member.member_2[1][1], _e643.member.member_2[1][2])), _e643.member.member_3);
                if (_e643.member_1 > f64(0f)) {
                    let _e5889 = local_18.member[0u];
                    let _e5895 = local_18.member[1u];
                    let _e5911 = local_18.member_1[0u];
                    let _e5917 = local_18.member_1[1u];
                    let _e5933 = local_18.member_2[0u];
                    let _e5939 = local_18.member_2[1u];
                    let _e5953 = function_4(array<f64, 3>((_e5889[0] + ((_e5895[0] - _e5889[0]) * _e430)), (_e5889[1] + ((_e5895[1] - _e5889[1]) * _e430)), (_e5889[2] + ((_e5895[2] - _e5889[2]) * _e430))), array<f64, 3>((_e5911[0] + ((_e5917[0] - _e5911[0]) * _e430)), (_e5911[1] + ((_e5917[1] - _e5911[1]) * _e430)), (_e5911[2] + ((_e5917[2] - _e5911[2]) * _e430))), array<f64, 3>((_e5933[0] + ((_e5939[0] - _e5933[0]) * _e430)), (_e5933[1] + ((_e5939[1] - _e5933[1]) * _e430)), (_e5933[2] + ((_e5939[2] - _e5933[2]) * _e430))), 1u);
                    let _e5964 = (((_e5953[0] * _e5953[0]) + (_e5953[1] * _e5953[1])) + (_e5953[2] * _e5953[2]));
                    if (_e5964 <= 2.2250738585072014e-308lf) {
                        if (_e5964 > 0.0lf) {
                            phi_1318_ = (1.464336215552873e-154lf * 2.0lf);
                        } else {
                            phi_1318_ = 0.0lf;
                        }
                        let _e6016 = phi_1318_;
                        phi_1382_ = _e6016;
                    } else {
                        phi_1325_ = type_16(0i, 5i);
                        phi_1328_ = bitcast<f64>(((bitcast<u64>(_e5964) / 2lu) + 2303426169912950784lu));
                        loop {
                            let _e5971 = phi_1325_;
                            let _e5973 = phi_1328_;
                            local_40 = _e5973;
                            if (_e5971.member < _e5971.member_1) {
                                let _e5980 = (_e5971.member + 1i);
                                if ((false == (_e5980 > _e5971.member)) != false) {
                                    phi_1349_ = true;
                                } else {
                                    phi_1349_ = false;
                                }
                                let _e5985 = phi_1349_;
                                if _e5985 {
                                    phi_1355_ = type_17(0u, type_17().member_1);
                                } else {
                                    phi_1355_ = type_17(1u, _e5980);
                                }
                                let _e5990 = phi_1355_;
                                phi_1326_ = type_16(_e5990.member_1, _e5971.member_1);
                                phi_1369_ = type_17(1u, _e5971.member);
                            } else {
                                phi_1326_ = _e5971;
                                phi_1369_ = type_17(0u, type_17().member_1);
                            }
                            let _e5996 = phi_1326_;
                            let _e5998 = phi_1369_;
                            let _e6001 = (bitcast<i32>(_e5998.member) != 0i);
                            if _e6001 {
                                phi_1329_ = (0.5lf * (_e5973 + (_e5964 / _e5973)));
                            } else {
                                phi_1329_ = f64();
                            }
                            let _e6006 = phi_1329_;
                            continue;
                            continuing {
                                phi_1325_ = _e5996;
                                phi_1328_ = _e6006;
                                break if !(_e6001);
                            }
                        }
                        let _e6011 = local_40;
                        phi_1382_ = (_e6011 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                    }
                    let _e6018 = phi_1382_;
                    let _e6026 = local_18.member[0u];
                    if (_e6026[0] < 0.0lf) {
                        phi_1400_ = -(_e6026[0]);
                    } else {
                        phi_1400_ = _e6026[0];
                    }
                    let _e6033 = phi_1400_;
                    if (_e6026[1] < 0.0lf) {
                        phi_1407_ = -(_e6026[1]);
                    } else {
                        phi_1407_ = _e6026[1];
                    }
                    let _e6037 = phi_1407_;
                    if (_e6033 > _e6037) {
                        phi_1412_ = _e6033;
                    } else {
                        phi_1412_ = _e6037;
                    }
                    let _e6040 = phi_1412_;
                    if (_e6026[2] < 0.0lf) {
                        phi_1419_ = -(_e6026[2]);
                    } else {
                        phi_1419_ = _e6026[2];
                    }
                    let _e6044 = phi_1419_;
                    if (_e6040 > _e6044) {
                        phi_1424_ = _e6040;
                    } else {
                        phi_1424_ = _e6044;
                    }
                    let _e6047 = phi_1424_;
                    let _e6050 = local_18.member[1u];
                    if (_e6050[0] < 0.0lf) {
                        phi_1437_ = -(_e6050[0]);
                    } else {
                        phi_1437_ = _e6050[0];
                    }
                    let _e6057 = phi_1437_;
                    if (_e6050[1] < 0.0lf) {
                        phi_1444_ = -(_e6050[1]);
                    } else {
                        phi_1444_ = _e6050[1];
                    }
                    let _e6061 = phi_1444_;
                    if (_e6057 > _e6061) {
                        phi_1449_ = _e6057;
                    } else {
                        phi_1449_ = _e6061;
                    }
                    let _e6064 = phi_1449_;
                    if (_e6050[2] < 0.0lf) {
                        phi_1456_ = -(_e6050[2]);
                    } else {
                        phi_1456_ = _e6050[2];
                    }
                    let _e6068 = phi_1456_;
                    if (_e6064 > _e6068) {
                        phi_1461_ = _e6064;
                    } else {
                        phi_1461_ = _e6068;
                    }
                    let _e6071 = phi_1461_;
                    if (_e6047 > _e6071) {
                        phi_1466_ = _e6047;
                    } else {
                        phi_1466_ = _e6071;
                    }
                    let _e6074 = phi_1466_;
                    let _e6076 = local_18.member_3;
                    let _e6080 = local_18.member_1[0u];
                    if (_e6080[0] < 0.0lf) {
                        phi_1483_ = -(_e6080[0]);
                    } else {
                        phi_1483_ = _e6080[0];
                    }
                    let _e6087 = phi_1483_;
                    if (_e6080[1] < 0.0lf) {
                        phi_1490_ = -(_e6080[1]);
                    } else {
                        phi_1490_ = _e6080[1];
                    }
                    let _e6091 = phi_1490_;
                    if (_e6087 > _e6091) {
                        phi_1495_ = _e6087;
                    } else {
                        phi_1495_ = _e6091;
                    }
                    let _e6094 = phi_1495_;
                    if (_e6080[2] < 0.0lf) {
                        phi_1502_ = -(_e6080[2]);
                    } else {
                        phi_1502_ = _e6080[2];
                    }
                    let _e6098 = phi_1502_;
                    if (_e6094 > _e6098) {
                        phi_1507_ = _e6094;
                    } else {
                        phi_1507_ = _e6098;
                    }
                    let _e6101 = phi_1507_;
                    let _e6104 = local_18.member_1[1u];
                    if (_e6104[0] < 0.0lf) {
                        phi_1521_ = -(_e6104[0]);
                    } else {
                        phi_1521_ = _e6104[0];
                    }
                    let _e6111 = phi_1521_;
                    if (_e6104[1] < 0.0lf) {
                        phi_1528_ = -(_e6104[1]);
                    } else {
                        phi_1528_ = _e6104[1];
                    }
                    let _e6115 = phi_1528_;
                    if (_e6111 > _e6115) {
                        phi_1533_ = _e6111;
                    } else {
                        phi_1533_ = _e6115;
                    }
                    let _e6118 = phi_1533_;
                    if (_e6104[2] < 0.0lf) {
                        phi_1540_ = -(_e6104[2]);
                    } else {
                        phi_1540_ = _e6104[2];
                    }
                    let _e6122 = phi_1540_;
                    if (_e6118 > _e6122) {
                        phi_1545_ = _e6118;
                    } else {
                        phi_1545_ = _e6122;
                    }
                    let _e6125 = phi_1545_;
                    if (_e6101 > _e6125) {
                        phi_1550_ = _e6101;
                    } else {
                        phi_1550_ = _e6125;
                    }
                    let _e6128 = phi_1550_;
                    let _e6130 = local_18.member_3;
                    let _e6134 = local_18.member_2[0u];
                    if (_e6134[0] < 0.0lf) {
                        phi_1567_ = -(_e6134[0]);
                    } else {
                        phi_1567_ = _e6134[0];
                    }
                    let _e6141 = phi_1567_;
                    if (_e6134[1] < 0.0lf) {
                        phi_1574_ = -(_e6134[1]);
                    } else {
                        phi_1574_ = _e6134[1];
                    }
                    let _e6145 = phi_1574_;
                    if (_e6141 > _e6145) {
                        phi_1579_ = _e6141;
                    } else {
                        phi_1579_ = _e6145;
                    }
                    let _e6148 = phi_1579_;
                    if (_e6134[2] < 0.0lf) {
                        phi_1586_ = -(_e6134[2]);
                    } else {
                        phi_1586_ = _e6134[2];
                    }
                    let _e6152 = phi_1586_;
                    if (_e6148 > _e6152) {
                        phi_1591_ = _e6148;
                    } else {
                        phi_1591_ = _e6152;
                    }
                    let _e6155 = phi_1591_;
                    let _e6158 = local_18.member_2[1u];
                    if (_e6158[0] < 0.0lf) {
                        phi_1605_ = -(_e6158[0]);
                    } else {
                        phi_1605_ = _e6158[0];
                    }
                    let _e6165 = phi_1605_;
                    if (_e6158[1] < 0.0lf) {
                        phi_1612_ = -(_e6158[1]);
                    } else {
                        phi_1612_ = _e6158[1];
                    }
                    let _e6169 = phi_1612_;
                    if (_e6165 > _e6169) {
                        phi_1617_ = _e6165;
                    } else {
                        phi_1617_ = _e6169;
                    }
                    let _e6172 = phi_1617_;
                    if (_e6158[2] < 0.0lf) {
                        phi_1624_ = -(_e6158[2]);
                    } else {
                        phi_1624_ = _e6158[2];
                    }
                    let _e6176 = phi_1624_;
                    if (_e6172 > _e6176) {
                        phi_1629_ = _e6172;
                    } else {
                        phi_1629_ = _e6176;
                    }
                    let _e6179 = phi_1629_;
                    if (_e6155 > _e6179) {
                        phi_1634_ = _e6155;
                    } else {
                        phi_1634_ = _e6179;
                    }
                    let _e6182 = phi_1634_;
                    let _e6184 = local_18.member_3;
                    let _e6192 = local_18.member_3;
                    let _e6202 = (((_e6018 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e6074 + _e6076) + (_e6128 + _e6130)) + (_e6182 + _e6184)) * (1.1102230246251565e-16lf * f64(16f))) + (_e6192 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e643.member_1);
                    if _e6202 {
                        phi_2311_ = type_47();
                        phi_2312_ = true;
                    } else {
                        let _e6205 = local_18.member_1[0u];
                        let _e6211 = local_18.member_2[0u];
                        let _e6217 = ((_e6205[1] * _e6211[2]) - (_e6205[2] * _e6211[1]));
                        let _e6220 = ((_e6205[2] * _e6211[0]) - (_e6205[0] * _e6211[2]));
                        let _e6223 = ((_e6205[0] * _e6211[1]) - (_e6205[1] * _e6211[0]));
                        let _e6226 = local_18.member_1[1u];
                        let _e6232 = local_18.member_2[1u];
                        let _e6238 = ((_e6226[1] * _e6232[2]) - (_e6226[2] * _e6232[1]));
                        let _e6241 = ((_e6226[2] * _e6232[0]) - (_e6226[0] * _e6232[2]));
                        let _e6244 = ((_e6226[0] * _e6232[1]) - (_e6226[1] * _e6232[0]));
                        let _e6247 = local_18.member_1[0u];
                        let _e6253 = local_18.member_2[1u];
                        let _e6268 = local_18.member_1[1u];
                        let _e6274 = local_18.member_2[0u];
                        let _e6287 = (((_e6247[1] * _e6253[2]) - (_e6247[2] * _e6253[1])) + ((_e6268[1] * _e6274[2]) - (_e6268[2] * _e6274[1])));
                        let _e6288 = (((_e6247[2] * _e6253[0]) - (_e6247[0] * _e6253[2])) + ((_e6268[2] * _e6274[0]) - (_e6268[0] * _e6274[2])));
                        let _e6289 = (((_e6247[0] * _e6253[1]) - (_e6247[1] * _e6253[0])) + ((_e6268[0] * _e6274[1]) - (_e6268[1] * _e6274[0])));
                        let _e6292 = local_18.member[0u];
                        let _e6303 = local_18.member[1u];
                        let _e6314 = local_18.member[0u];
                        let _e6323 = ((((_e6303[0] * _e6217) + (_e6303[1] * _e6220)) + (_e6303[2] * _e6223)) + (((_e6314[0] * _e6287) + (_e6314[1] * _e6288)) + (_e6314[2] * _e6289)));
                        let _e6326 = local_18.member[0u];
                        let _e6337 = local_18.member[1u];
                        let _e6346 = ((((_e6326[0] * _e6238) + (_e6326[1] * _e6241)) + (_e6326[2] * _e6244)) + (((_e6337[0] * _e6287) + (_e6337[1] * _e6288)) + (_e6337[2] * _e6289)));
                        let _e6349 = local_18.member[1u];
                        let _e6360 = local_18.member[0u];
                        if (_e6360[0] < 0.0lf) {
                            phi_1899_ = -(_e6360[0]);
                        } else {
                            phi_1899_ = _e6360[0];
                        }
                        let _e6367 = phi_1899_;
                        if (_e6360[1] < 0.0lf) {
                            phi_1906_ = -(_e6360[1]);
                        } else {
                            phi_1906_ = _e6360[1];
                        }
                        let _e6371 = phi_1906_;
                        if (_e6367 > _e6371) {
                            phi_1911_ = _e6367;
                        } else {
                            phi_1911_ = _e6371;
                        }
                        let _e6374 = phi_1911_;
                        if (_e6360[2] < 0.0lf) {
                            phi_1918_ = -(_e6360[2]);
                        } else {
                            phi_1918_ = _e6360[2];
                        }
                        let _e6378 = phi_1918_;
                        if (_e6374 > _e6378) {
                            phi_1923_ = _e6374;
                        } else {
                            phi_1923_ = _e6378;
                        }
                        let _e6381 = phi_1923_;
                        let _e6384 = local_18.member[1u];
                        if (_e6384[0] < 0.0lf) {
                            phi_1936_ = -(_e6384[0]);
                        } else {
                            phi_1936_ = _e6384[0];
                        }
                        let _e6391 = phi_1936_;
                        if (_e6384[1] < 0.0lf) {
                            phi_1943_ = -(_e6384[1]);
                        } else {
                            phi_1943_ = _e6384[1];
                        }
                        let _e6395 = phi_1943_;
                        if (_e6391 > _e6395) {
                            phi_1948_ = _e6391;
                        } else {
                            phi_1948_ = _e6395;
                        }
                        let _e6398 = phi_1948_;
                        if (_e6384[2] < 0.0lf) {
                            phi_1955_ = -(_e6384[2]);
                        } else {
                            phi_1955_ = _e6384[2];
                        }
                        let _e6402 = phi_1955_;
                        if (_e6398 > _e6402) {
                            phi_1960_ = _e6398;
                        } else {
                            phi_1960_ = _e6402;
                        }
                        let _e6405 = phi_1960_;
                        if (_e6381 > _e6405) {
                            phi_1965_ = _e6381;
                        } else {
                            phi_1965_ = _e6405;
                        }
                        let _e6408 = phi_1965_;
                        let _e6410 = local_18.member_3;
                        let _e6411 = (_e6408 + _e6410);
                        let _e6414 = local_18.member_1[0u];
                        if (_e6414[0] < 0.0lf) {
                            phi_1982_ = -(_e6414[0]);
                        } else {
                            phi_1982_ = _e6414[0];
                        }
                        let _e6421 = phi_1982_;
                        if (_e6414[1] < 0.0lf) {
                            phi_1989_ = -(_e6414[1]);
                        } else {
                            phi_1989_ = _e6414[1];
                        }
                        let _e6425 = phi_1989_;
                        if (_e6421 > _e6425) {
                            phi_1994_ = _e6421;
                        } else {
                            phi_1994_ = _e6425;
                        }
                        let _e6428 = phi_1994_;
                        if (_e6414[2] < 0.0lf) {
                            phi_2001_ = -(_e6414[2]);
                        } else {
                            phi_2001_ = _e6414[2];
                        }
                        let _e6432 = phi_2001_;
                        if (_e6428 > _e6432) {
                            phi_2006_ = _e6428;
                        } else {
                            phi_2006_ = _e6432;
                        }
                        let _e6435 = phi_2006_;
                        let _e6438 = local_18.member_1[1u];
                        if (_e6438[0] < 0.0lf) {
                            phi_2020_ = -(_e6438[0]);
                        } else {
                            phi_2020_ = _e6438[0];
                        }
                        let _e6445 = phi_2020_;
                        if (_e6438[1] < 0.0lf) {
                            phi_2027_ = -(_e6438[1]);
                        } else {
                            phi_2027_ = _e6438[1];
                        }
                        let _e6449 = phi_2027_;
                        if (_e6445 > _e6449) {
                            phi_2032_ = _e6445;
                        } else {
                            phi_2032_ = _e6449;
                        }
                        let _e6452 = phi_2032_;
                        if (_e6438[2] < 0.0lf) {
                            phi_2039_ = -(_e6438[2]);
                        } else {
                            phi_2039_ = _e6438[2];
                        }
                        let _e6456 = phi_2039_;
                        if (_e6452 > _e6456) {
                            phi_2044_ = _e6452;
                        } else {
                            phi_2044_ = _e6456;
                        }
                        let _e6459 = phi_2044_;
                        if (_e6435 > _e6459) {
                            phi_2049_ = _e6435;
                        } else {
                            phi_2049_ = _e6459;
                        }
                        let _e6462 = phi_2049_;
                        let _e6464 = local_18.member_3;
                        let _e6465 = (_e6462 + _e6464);
                        let _e6468 = local_18.member_2[0u];
                        if (_e6468[0] < 0.0lf) {
                            phi_2066_ = -(_e6468[0]);
                        } else {
                            phi_2066_ = _e6468[0];
                        }
                        let _e6475 = phi_2066_;
                        if (_e6468[1] < 0.0lf) {
                            phi_2073_ = -(_e6468[1]);
                        } else {
                            phi_2073_ = _e6468[1];
                        }
                        let _e6479 = phi_2073_;
                        if (_e6475 > _e6479) {
                            phi_2078_ = _e6475;
                        } else {
                            phi_2078_ = _e6479;
                        }
                        let _e6482 = phi_2078_;
                        if (_e6468[2] < 0.0lf) {
                            phi_2085_ = -(_e6468[2]);
                        } else {
                            phi_2085_ = _e6468[2];
                        }
                        let _e6486 = phi_2085_;
                        if (_e6482 > _e6486) {
                            phi_2090_ = _e6482;
                        } else {
                            phi_2090_ = _e6486;
                        }
                        let _e6489 = phi_2090_;
                        let _e6492 = local_18.member_2[1u];
                        if (_e6492[0] < 0.0lf) {
                            phi_2104_ = -(_e6492[0]);
                        } else {
                            phi_2104_ = _e6492[0];
                        }
                        let _e6499 = phi_2104_;
                        if (_e6492[1] < 0.0lf) {
                            phi_2111_ = -(_e6492[1]);
                        } else {
                            phi_2111_ = _e6492[1];
                        }
                        let _e6503 = phi_2111_;
                        if (_e6499 > _e6503) {
                            phi_2116_ = _e6499;
                        } else {
                            phi_2116_ = _e6503;
                        }
                        let _e6506 = phi_2116_;
                        if (_e6492[2] < 0.0lf) {
                            phi_2123_ = -(_e6492[2]);
                        } else {
                            phi_2123_ = _e6492[2];
                        }
                        let _e6510 = phi_2123_;
                        if (_e6506 > _e6510) {
                            phi_2128_ = _e6506;
                        } else {
                            phi_2128_ = _e6510;
                        }
                        let _e6513 = phi_2128_;
                        if (_e6489 > _e6513) {
                            phi_2133_ = _e6489;
                        } else {
                            phi_2133_ = _e6513;
                        }
                        let _e6516 = phi_2133_;
                        let _e6518 = local_18.member_3;
                        let _e6519 = (_e6516 + _e6518);
                        let _e6520 = f64(1f);
                        let _e6521 = f64(8f);
                        let _e6523 = ((_e6465 * _e6521) * _e6519);
                        let _e6531 = local_18.member_3;
                        if (_e6217 < 0.0lf) {
                            phi_2170_ = -(_e6217);
                        } else {
                            phi_2170_ = _e6217;
                        }
                        let _e6551 = phi_2170_;
                        if (_e6220 < 0.0lf) {
                            phi_2176_ = -(_e6220);
                        } else {
                            phi_2176_ = _e6220;
                        }
                        let _e6555 = phi_2176_;
                        if (_e6223 < 0.0lf) {
                            phi_2183_ = -(_e6223);
                        } else {
                            phi_2183_ = _e6223;
                        }
                        let _e6560 = phi_2183_;
                        let _e6561 = ((_e6551 + _e6555) + _e6560);
                        if (_e6238 < 0.0lf) {
                            phi_2190_ = -(_e6238);
                        } else {
                            phi_2190_ = _e6238;
                        }
                        let _e6565 = phi_2190_;
                        if (_e6241 < 0.0lf) {
                            phi_2196_ = -(_e6241);
                        } else {
                            phi_2196_ = _e6241;
                        }
                        let _e6569 = phi_2196_;
                        if (_e6244 < 0.0lf) {
                            phi_2203_ = -(_e6244);
                        } else {
                            phi_2203_ = _e6244;
                        }
                        let _e6574 = phi_2203_;
                        let _e6575 = ((_e6565 + _e6569) + _e6574);
                        if (_e6561 > _e6575) {
                            phi_2209_ = _e6561;
                        } else {
                            phi_2209_ = _e6575;
                        }
                        let _e6578 = phi_2209_;
                        if (_e6287 < 0.0lf) {
                            phi_2215_ = -(_e6287);
                        } else {
                            phi_2215_ = _e6287;
                        }
                        let _e6582 = phi_2215_;
                        if (_e6288 < 0.0lf) {
                            phi_2221_ = -(_e6288);
                        } else {
                            phi_2221_ = _e6288;
                        }
                        let _e6586 = phi_2221_;
                        if (_e6289 < 0.0lf) {
                            phi_2228_ = -(_e6289);
                        } else {
                            phi_2228_ = _e6289;
                        }
                        let _e6591 = phi_2228_;
                        let _e6593 = (((_e6582 + _e6586) + _e6591) * f64(0.5f));
                        if (_e6578 > _e6593) {
                            phi_2235_ = _e6578;
                        } else {
                            phi_2235_ = _e6593;
                        }
                        let _e6596 = phi_2235_;
                        let _e6602 = local_18.member_3;
                        let _e6617 = f64(3f);
                        let _e6618 = ((((_e6292[0] * _e6217) + (_e6292[1] * _e6220)) + (_e6292[2] * _e6223)) * _e6617);
                        let _e6619 = ((((_e6349[0] * _e6238) + (_e6349[1] * _e6241)) + (_e6349[2] * _e6244)) * _e6617);
                        if (_e6618 < _e6619) {
                            phi_2263_ = _e6618;
                        } else {
                            phi_2263_ = _e6619;
                        }
                        let _e6622 = phi_2263_;
                        if (_e6323 < _e6346) {
                            phi_2268_ = _e6323;
                        } else {
                            phi_2268_ = _e6346;
                        }
                        let _e6625 = phi_2268_;
                        if (_e6622 < _e6625) {
                            phi_2273_ = _e6622;
                        } else {
                            phi_2273_ = _e6625;
                        }
                        let _e6628 = phi_2273_;
                        if (_e6618 > _e6619) {
                            phi_2278_ = _e6618;
                        } else {
                            phi_2278_ = _e6619;
                        }
                        let _e6631 = phi_2278_;
                        if (_e6323 > _e6346) {
                            phi_2283_ = _e6323;
                        } else {
                            phi_2283_ = _e6346;
                        }
                        let _e6634 = phi_2283_;
                        if (_e6631 > _e6634) {
                            phi_2288_ = _e6631;
                        } else {
                            phi_2288_ = _e6634;
                        }
                        let _e6637 = phi_2288_;
                        let _e6643 = -(_e6637);
                        if (_e6628 > _e6643) {
                            phi_2299_ = _e6628;
                        } else {
                            phi_2299_ = _e6643;
                        }
                        let _e6646 = phi_2299_;
                        if ((_e6646 - ((((((_e6411 * _e6521) * _e6523) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e6531 * f64(19f)) * ((_e6411 * (_e6465 + _e6519)) + (_e6465 * _e6519)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e6520 + _e6411) * ((_e6520 + _e6465) * (_e6520 + _e6519))))) + ((_e643.member_1 * (((_e6596 + (_e6523 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e6602 * f64(6f)) * (_e6465 + _e6519))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e6520 + _e6465) * (_e6520 + _e6519))))) * f64((3f * 1.0001f))))) > f64(0f)) {
                            phi_2309_ = type_47(type_46(0u, f64()), 0u);
                            phi_2310_ = false;
                        } else {
                            phi_2309_ = type_47();
                            phi_2310_ = true;
                        }
                        let _e6653 = phi_2309_;
                        let _e6655 = phi_2310_;
                        phi_2311_ = _e6653;
                        phi_2312_ = _e6655;
                    }
                    let _e6657 = phi_2311_;
                    let _e6659 = phi_2312_;
                    if _e6659 {
                        phi_2318_ = type_16(0i, 2i);
                        phi_2321_ = _e430;
                        phi_2323_ = 0u;
                        phi_2325_ = _e430;
                        loop {
                            let _e6661 = phi_2318_;
                            let _e6663 = phi_2321_;
                            let _e6665 = phi_2323_;
                            let _e6667 = phi_2325_;
                            local_99 = _e6665;
                            local_102 = _e6663;
                            local_103 = _e6665;
                            if (_e6661.member < _e6661.member_1) {
                                let _e6674 = (_e6661.member + 1i);
                                if ((false == (_e6674 > _e6661.member)) != false) {
                                    phi_2346_ = true;
                                } else {
                                    phi_2346_ = false;
                                }
                                let _e6679 = phi_2346_;
                                if _e6679 {
                                    phi_2352_ = type_17(0u, type_17().member_1);
                                } else {
                                    phi_2352_ = type_17(1u, _e6674);
                                }
                                let _e6684 = phi_2352_;
                                phi_2319_ = type_16(_e6684.member_1, _e6661.member_1);
                                phi_2366_ = type_17(1u, _e6661.member);
                            } else {
                                phi_2319_ = _e6661;
                                phi_2366_ = type_17(0u, type_17().member_1);
                            }
                            let _e6690 = phi_2319_;
                            let _e6692 = phi_2366_;
                            if (bitcast<i32>(_e6692.member) != 0i) {
                                if (_e6692.member_1 > 0i) {
                                    phi_2382_ = true;
                                } else {
                                    if _e6202 {
                                        phi_2381_ = false;
                                    } else {
                                        phi_2381_ = true;
                                    }
                                    let _e6699 = phi_2381_;
                                    phi_2382_ = _e6699;
                                }
                                let _e6701 = phi_2382_;
                                if _e6701 {
                                    let _e6704 = local_18.member[0u];
                                    let _e6710 = local_18.member_1[0u];
                                    let _e6716 = local_18.member_2[0u];
                                    let _e6720 = (_e6704[0] - _e6710[0]);
                                    let _e6721 = (_e6704[1] - _e6710[1]);
                                    let _e6722 = (_e6704[2] - _e6710[2]);
                                    let _e6731 = local_18.member[1u];
                                    let _e6737 = local_18.member_1[1u];
                                    let _e6743 = local_18.member_2[1u];
                                    let _e6747 = (_e6731[0] - _e6737[0]);
                                    let _e6748 = (_e6731[1] - _e6737[1]);
                                    let _e6749 = (_e6731[2] - _e6737[2]);
                                    let _e6758 = local_18.member[0u];
                                    if (_e6758[0] < 0.0lf) {
                                        phi_2528_ = -(_e6758[0]);
                                    } else {
                                        phi_2528_ = _e6758[0];
                                    }
                                    let _e6765 = phi_2528_;
                                    if (_e6758[1] < 0.0lf) {
                                        phi_2535_ = -(_e6758[1]);
                                    } else {
                                        phi_2535_ = _e6758[1];
                                    }
                                    let _e6769 = phi_2535_;
                                    if (_e6765 > _e6769) {
                                        phi_2540_ = _e6765;
                                    } else {
                                        phi_2540_ = _e6769;
                                    }
                                    let _e6772 = phi_2540_;
                                    if (_e6758[2] < 0.0lf) {
                                        phi_2547_ = -(_e6758[2]);
                                    } else {
                                        phi_2547_ = _e6758[2];
                                    }
                                    let _e6776 = phi_2547_;
                                    if (_e6772 > _e6776) {
                                        phi_2552_ = _e6772;
                                    } else {
                                        phi_2552_ = _e6776;
                                    }
                                    let _e6779 = phi_2552_;
                                    let _e6782 = local_18.member[1u];
                                    if (_e6782[0] < 0.0lf) {
                                        phi_2565_ = -(_e6782[0]);
                                    } else {
                                        phi_2565_ = _e6782[0];
                                    }
                                    let _e6789 = phi_2565_;
                                    if (_e6782[1] < 0.0lf) {
                                        phi_2572_ = -(_e6782[1]);
                                    } else {
                                        phi_2572_ = _e6782[1];
                                    }
                                    let _e6793 = phi_2572_;
                                    if (_e6789 > _e6793) {
                                        phi_2577_ = _e6789;
                                    } else {
                                        phi_2577_ = _e6793;
                                    }
                                    let _e6796 = phi_2577_;
                                    if (_e6782[2] < 0.0lf) {
                                        phi_2584_ = -(_e6782[2]);
                                    } else {
                                        phi_2584_ = _e6782[2];
                                    }
                                    let _e6800 = phi_2584_;
                                    if (_e6796 > _e6800) {
                                        phi_2589_ = _e6796;
                                    } else {
                                        phi_2589_ = _e6800;
                                    }
                                    let _e6803 = phi_2589_;
                                    if (_e6779 > _e6803) {
                                        phi_2594_ = _e6779;
                                    } else {
                                        phi_2594_ = _e6803;
                                    }
                                    let _e6806 = phi_2594_;
                                    let _e6808 = local_18.member_3;
                                    let _e6812 = local_18.member_1[0u];
                                    if (_e6812[0] < 0.0lf) {
                                        phi_2611_ = -(_e6812[0]);
                                    } else {
                                        phi_2611_ = _e6812[0];
                                    }
                                    let _e6819 = phi_2611_;
                                    if (_e6812[1] < 0.0lf) {
                                        phi_2618_ = -(_e6812[1]);
                                    } else {
                                        phi_2618_ = _e6812[1];
                                    }
                                    let _e6823 = phi_2618_;
                                    if (_e6819 > _e6823) {
                                        phi_2623_ = _e6819;
                                    } else {
                                        phi_2623_ = _e6823;
                                    }
                                    let _e6826 = phi_2623_;
                                    if (_e6812[2] < 0.0lf) {
                                        phi_2630_ = -(_e6812[2]);
                                    } else {
                                        phi_2630_ = _e6812[2];
                                    }
                                    let _e6830 = phi_2630_;
                                    if (_e6826 > _e6830) {
                                        phi_2635_ = _e6826;
                                    } else {
                                        phi_2635_ = _e6830;
                                    }
                                    let _e6833 = phi_2635_;
                                    let _e6836 = local_18.member_1[1u];
                                    if (_e6836[0] < 0.0lf) {
                                        phi_2649_ = -(_e6836[0]);
                                    } else {
                                        phi_2649_ = _e6836[0];
                                    }
                                    let _e6843 = phi_2649_;
                                    if (_e6836[1] < 0.0lf) {
                                        phi_2656_ = -(_e6836[1]);
                                    } else {
                                        phi_2656_ = _e6836[1];
                                    }
                                    let _e6847 = phi_2656_;
                                    if (_e6843 > _e6847) {
                                        phi_2661_ = _e6843;
                                    } else {
                                        phi_2661_ = _e6847;
                                    }
                                    let _e6850 = phi_2661_;
                                    if (_e6836[2] < 0.0lf) {
                                        phi_2668_ = -(_e6836[2]);
                                    } else {
                                        phi_2668_ = _e6836[2];
                                    }
                                    let _e6854 = phi_2668_;
                                    if (_e6850 > _e6854) {
                                        phi_2673_ = _e6850;
                                    } else {
                                        phi_2673_ = _e6854;
                                    }
                                    let _e6857 = phi_2673_;
                                    if (_e6833 > _e6857) {
                                        phi_2678_ = _e6833;
                                    } else {
                                        phi_2678_ = _e6857;
                                    }
                                    let _e6860 = phi_2678_;
                                    let _e6862 = local_18.member_3;
                                    let _e6866 = local_18.member_2[0u];
                                    if (_e6866[0] < 0.0lf) {
                                        phi_2695_ = -(_e6866[0]);
                                    } else {
                                        phi_2695_ = _e6866[0];
                                    }
                                    let _e6873 = phi_2695_;
                                    if (_e6866[1] < 0.0lf) {
                                        phi_2702_ = -(_e6866[1]);
                                    } else {
                                        phi_2702_ = _e6866[1];
                                    }
                                    let _e6877 = phi_2702_;
                                    if (_e6873 > _e6877) {
                                        phi_2707_ = _e6873;
                                    } else {
                                        phi_2707_ = _e6877;
                                    }
                                    let _e6880 = phi_2707_;
                                    if (_e6866[2] < 0.0lf) {
                                        phi_2714_ = -(_e6866[2]);
                                    } else {
                                        phi_2714_ = _e6866[2];
                                    }
                                    let _e6884 = phi_2714_;
                                    if (_e6880 > _e6884) {
                                        phi_2719_ = _e6880;
                                    } else {
                                        phi_2719_ = _e6884;
                                    }
                                    let _e6887 = phi_2719_;
                                    let _e6890 = local_18.member_2[1u];
                                    if (_e6890[0] < 0.0lf) {
                                        phi_2733_ = -(_e6890[0]);
                                    } else {
                                        phi_2733_ = _e6890[0];
                                    }
                                    let _e6897 = phi_2733_;
                                    if (_e6890[1] < 0.0lf) {
                                        phi_2740_ = -(_e6890[1]);
                                    } else {
                                        phi_2740_ = _e6890[1];
                                    }
                                    let _e6901 = phi_2740_;
                                    if (_e6897 > _e6901) {
                                        phi_2745_ = _e6897;
                                    } else {
                                        phi_2745_ = _e6901;
                                    }
                                    let _e6904 = phi_2745_;
                                    if (_e6890[2] < 0.0lf) {
                                        phi_2752_ = -(_e6890[2]);
                                    } else {
                                        phi_2752_ = _e6890[2];
                                    }
                                    let _e6908 = phi_2752_;
                                    if (_e6904 > _e6908) {
                                        phi_2757_ = _e6904;
                                    } else {
                                        phi_2757_ = _e6908;
                                    }
                                    let _e6911 = phi_2757_;
                                    if (_e6887 > _e6911) {
                                        phi_2762_ = _e6887;
                                    } else {
                                        phi_2762_ = _e6911;
                                    }
                                    let _e6914 = phi_2762_;
                                    let _e6916 = local_18.member_3;
                                    let _e6924 = local_18.member_3;
                                    let _e6932 = (_e421 * f64(0.00390625f));
                                    let _e6933 = f64(0f);
                                    let _e6934 = f64(1f);
                                    local_16 = type_38(array<f64, 4>(_e6933, _e6933, _e6933, _e6933), array<f64, 4>(_e6933, _e6933, _e6933, _e6933), array<f64, 4>(_e6934, _e6934, _e6934, _e6934));
                                    phi_2809_ = type_12(0u, 96u);
                                    phi_2812_ = _e6667;
                                    phi_2814_ = _e6667;
                                    phi_2816_ = (_e439 - _e6667);
                                    phi_2818_ = _e6667;
                                    phi_2820_ = false;
                                    phi_2822_ = 0u;
                                    loop {
                                        let _e6941 = phi_2809_;
                                        let _e6943 = phi_2812_;
                                        let _e6945 = phi_2814_;
                                        let _e6947 = phi_2816_;
                                        let _e6949 = phi_2818_;
                                        let _e6951 = phi_2820_;
                                        let _e6953 = phi_2822_;
                                        local_44 = _e6943;
                                        local_89 = _e6945;
                                        if (_e6941.member < _e6941.member_1) {
                                            phi_2810_ = type_12((_e6941.member + 1u), _e6941.member_1);
                                            phi_2845_ = type_12(1u, _e6941.member);
                                        } else {
                                            phi_2810_ = _e6941;
                                            phi_2845_ = type_12(0u, type_12().member_1);
                                        }
                                        let _e6965 = phi_2810_;
                                        let _e6967 = phi_2845_;
                                        if (bitcast<i32>(_e6967.member) != 0i) {
                                            let _e6973 = local_18.member[0u];
                                            let _e6979 = local_18.member[1u];
                                            let _e6995 = local_18.member_1[0u];
                                            let _e7001 = local_18.member_1[1u];
                                            let _e7017 = local_18.member_2[0u];
                                            let _e7023 = local_18.member_2[1u];
                                            let _e7037 = function_4(array<f64, 3>((_e6973[0] + ((_e6979[0] - _e6973[0]) * _e6943)), (_e6973[1] + ((_e6979[1] - _e6973[1]) * _e6943)), (_e6973[2] + ((_e6979[2] - _e6973[2]) * _e6943))), array<f64, 3>((_e6995[0] + ((_e7001[0] - _e6995[0]) * _e6943)), (_e6995[1] + ((_e7001[1] - _e6995[1]) * _e6943)), (_e6995[2] + ((_e7001[2] - _e6995[2]) * _e6943))), array<f64, 3>((_e7017[0] + ((_e7023[0] - _e7017[0]) * _e6943)), (_e7017[1] + ((_e7023[1] - _e7017[1]) * _e6943)), (_e7017[2] + ((_e7023[2] - _e7017[2]) * _e6943))), 1u);
                                            if (_e6953 == 0u) {
                                                phi_2974_ = _e7037;
                                            } else {
                                                let _e7039 = f64(0f);
                                                if (_e6953 == 1u) {
                                                    phi_2960_ = _e7037[0];
                                                } else {
                                                    phi_2960_ = _e7039;
                                                }
                                                let _e7043 = phi_2960_;
                                                if (_e6953 == 2u) {
                                                    phi_2966_ = _e7037[1];
                                                } else {
                                                    phi_2966_ = _e7039;
                                                }
                                                let _e7047 = phi_2966_;
                                                if (_e6953 == 3u) {
                                                    phi_2972_ = _e7037[2];
                                                } else {
                                                    phi_2972_ = _e7039;
                                                }
                                                let _e7051 = phi_2972_;
                                                phi_2974_ = array<f64, 3>(_e7043, _e7047, _e7051);
                                            }
                                            let _e7054 = phi_2974_;
                                            if (_e7054[0] < 0.0lf) {
                                                phi_2981_ = -(_e7054[0]);
                                            } else {
                                                phi_2981_ = _e7054[0];
                                            }
                                            let _e7059 = phi_2981_;
                                            if (_e7054[1] < 0.0lf) {
                                                phi_2988_ = -(_e7054[1]);
                                            } else {
                                                phi_2988_ = _e7054[1];
                                            }
                                            let _e7064 = phi_2988_;
                                            if (_e7054[2] < 0.0lf) {
                                                phi_2996_ = -(_e7054[2]);
                                            } else {
                                                phi_2996_ = _e7054[2];
                                            }
                                            let _e7070 = phi_2996_;
                                            let _e7071 = ((_e7059 + _e7064) + _e7070);
                                            if (_e7071 > f64(0f)) {
                                                if ((bitcast<u64>(_e7071) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                    let _e7078 = (f64(1f) / _e7071);
                                                    let _e7080 = (_e7054[0] * _e7078);
                                                    let _e7082 = (_e7054[1] * _e7078);
                                                    let _e7084 = (_e7054[2] * _e7078);
                                                    let _e7089 = (((_e7080 * _e7080) + (_e7082 * _e7082)) + (_e7084 * _e7084));
                                                    if (_e7089 <= 2.2250738585072014e-308lf) {
                                                        if (_e7089 > 0.0lf) {
                                                            phi_3035_ = (1.464336215552873e-154lf * 2.0lf);
                                                        } else {
                                                            phi_3035_ = 0.0lf;
                                                        }
                                                        let _e7141 = phi_3035_;
                                                        phi_3099_ = _e7141;
                                                    } else {
                                                        phi_3042_ = type_16(0i, 5i);
                                                        phi_3045_ = bitcast<f64>(((bitcast<u64>(_e7089) / 2lu) + 2303426169912950784lu));
                                                        loop {
                                                            let _e7096 = phi_3042_;
                                                            let _e7098 = phi_3045_;
                                                            local_41 = _e7098;
                                                            if (_e7096.member < _e7096.member_1) {
                                                                let _e7105 = (_e7096.member + 1i);
                                                                if ((false == (_e7105 > _e7096.member)) != false) {
                                                                    phi_3066_ = true;
                                                                } else {
                                                                    phi_3066_ = false;
                                                                }
                                                                let _e7110 = phi_3066_;
                                                                if _e7110 {
                                                                    phi_3072_ = type_17(0u, type_17().member_1);
                                                                } else {
                                                                    phi_3072_ = type_17(1u, _e7105);
                                                                }
                                                                let _e7115 = phi_3072_;
                                                                phi_3043_ = type_16(_e7115.member_1, _e7096.member_1);
                                                                phi_3086_ = type_17(1u, _e7096.member);
                                                            } else {
                                                                phi_3043_ = _e7096;
                                                                phi_3086_ = type_17(0u, type_17().member_1);
                                                            }
                                                            let _e7121 = phi_3043_;
                                                            let _e7123 = phi_3086_;
                                                            let _e7126 = (bitcast<i32>(_e7123.member) != 0i);
                                                            if _e7126 {
                                                                phi_3046_ = (0.5lf * (_e7098 + (_e7089 / _e7098)));
                                                            } else {
                                                                phi_3046_ = f64();
                                                            }
                                                            let _e7131 = phi_3046_;
                                                            continue;
                                                            continuing {
                                                                phi_3042_ = _e7121;
                                                                phi_3045_ = _e7131;
                                                                break if !(_e7126);
                                                            }
                                                        }
                                                        let _e7136 = local_41;
                                                        phi_3099_ = (_e7136 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                    }
                                                    let _e7143 = phi_3099_;
                                                    let _e7145 = (1.1102230246251565e-16lf * f64(12f));
                                                    let _e7152 = ((((((((_e6806 + _e6808) + (_e6860 + _e6862)) + (_e6914 + _e6916)) * (1.1102230246251565e-16lf * f64(16f))) + (_e6924 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e643.member_1 * _e7143) * (f64(1f) + _e7145)));
                                                    let _e7157 = (((_e7080 * _e6704[0]) + (_e7082 * _e6704[1])) + (_e7084 * _e6704[2]));
                                                    let _e7162 = (((_e7080 * _e6720) + (_e7082 * _e6721)) + (_e7084 * _e6722));
                                                    let _e7167 = (((_e7080 * (_e6704[0] - _e6716[0])) + (_e7082 * (_e6704[1] - _e6716[1]))) + (_e7084 * (_e6704[2] - _e6716[2])));
                                                    let _e7172 = (((_e7080 * (_e6720 - _e6716[0])) + (_e7082 * (_e6721 - _e6716[1]))) + (_e7084 * (_e6722 - _e6716[2])));
                                                    let _e7178 = (((_e7080 * _e6731[0]) + (_e7082 * _e6731[1])) + (_e7084 * _e6731[2]));
                                                    let _e7183 = (((_e7080 * _e6747) + (_e7082 * _e6748)) + (_e7084 * _e6749));
                                                    let _e7188 = (((_e7080 * (_e6731[0] - _e6743[0])) + (_e7082 * (_e6731[1] - _e6743[1]))) + (_e7084 * (_e6731[2] - _e6743[2])));
                                                    let _e7193 = (((_e7080 * (_e6747 - _e6743[0])) + (_e7082 * (_e6748 - _e6743[1]))) + (_e7084 * (_e6749 - _e6743[2])));
                                                    if (_e7157 < 0.0lf) {
                                                        phi_3168_ = -(_e7157);
                                                    } else {
                                                        phi_3168_ = _e7157;
                                                    }
                                                    let _e7198 = phi_3168_;
                                                    if (_e7178 < 0.0lf) {
                                                        phi_3174_ = -(_e7178);
                                                    } else {
                                                        phi_3174_ = _e7178;
                                                    }
                                                    let _e7202 = phi_3174_;
                                                    if (_e7162 < 0.0lf) {
                                                        phi_3183_ = -(_e7162);
                                                    } else {
                                                        phi_3183_ = _e7162;
                                                    }
                                                    let _e7209 = phi_3183_;
                                                    if (_e7183 < 0.0lf) {
                                                        phi_3189_ = -(_e7183);
                                                    } else {
                                                        phi_3189_ = _e7183;
                                                    }
                                                    let _e7213 = phi_3189_;
                                                    if (_e7167 < 0.0lf) {
                                                        phi_3198_ = -(_e7167);
                                                    } else {
                                                        phi_3198_ = _e7167;
                                                    }
                                                    let _e7220 = phi_3198_;
                                                    if (_e7188 < 0.0lf) {
                                                        phi_3204_ = -(_e7188);
                                                    } else {
                                                        phi_3204_ = _e7188;
                                                    }
                                                    let _e7224 = phi_3204_;
                                                    if (_e7172 < 0.0lf) {
                                                        phi_3213_ = -(_e7172);
                                                    } else {
                                                        phi_3213_ = _e7172;
                                                    }
                                                    let _e7231 = phi_3213_;
                                                    if (_e7193 < 0.0lf) {
                                                        phi_3219_ = -(_e7193);
                                                    } else {
                                                        phi_3219_ = _e7193;
                                                    }
                                                    let _e7235 = phi_3219_;
                                                    phi_3225_ = type_38(array<f64, 4>(_e7157, _e7162, _e7167, _e7172), array<f64, 4>(_e7178, _e7183, _e7188, _e7193), array<f64, 4>((_e7152 + ((_e7198 + _e7202) * _e7145)), (_e7152 + ((_e7209 + _e7213) * _e7145)), (_e7152 + ((_e7220 + _e7224) * _e7145)), (_e7152 + ((_e7231 + _e7235) * _e7145))));
                                                    phi_3226_ = false;
                                                } else {
                                                    phi_3225_ = type_38();
                                                    phi_3226_ = true;
                                                }
                                                let _e7242 = phi_3225_;
                                                let _e7244 = phi_3226_;
                                                phi_3227_ = _e7242;
                                                phi_3228_ = _e7244;
                                            } else {
                                                phi_3227_ = type_38();
                                                phi_3228_ = true;
                                            }
                                            let _e7246 = phi_3227_;
                                            let _e7248 = phi_3228_;
                                            if _e7248 {
                                                let _e7249 = f64(0f);
                                                let _e7250 = f64(1f);
                                                phi_3238_ = type_38(array<f64, 4>(_e7249, _e7249, _e7249, _e7249), array<f64, 4>(_e7249, _e7249, _e7249, _e7249), array<f64, 4>(_e7250, _e7250, _e7250, _e7250));
                                            } else {
                                                phi_3238_ = _e7246;
                                            }
                                            let _e7256 = phi_3238_;
                                            local_17 = type_38(array<f64, 4>(_e7256.member[0], _e7256.member[1], _e7256.member[2], _e7256.member[3]), array<f64, 4>(_e7256.member_1[0], _e7256.member_1[1], _e7256.member_1[2], _e7256.member_1[3]), array<f64, 4>(_e7256.member_2[0], _e7256.member_2[1], _e7256.member_2[2], _e7256.member_2[3]));
                                            let _e7276 = (_e6943 - _e6949);
                                            let _e7278 = f64(0f);
                                            let _e7281 = local_17.member[0u];
                                            let _e7284 = local_17.member_1[0u];
                                            let _e7287 = local_17.member[0u];
                                            let _e7293 = local_17.member_2[0u];
                                            if (((_e7281 + ((_e7284 - _e7287) * _e6943)) - _e7293) > _e7278) {
                                                let _e7298 = local_17.member[1u];
                                                let _e7301 = local_17.member_1[1u];
                                                let _e7304 = local_17.member[1u];
                                                let _e7310 = local_17.member_2[1u];
                                                if (((_e7298 + ((_e7301 - _e7304) * _e6943)) - _e7310) > _e7278) {
                                                    let _e7315 = local_17.member[2u];
                                                    let _e7318 = local_17.member_1[2u];
                                                    let _e7321 = local_17.member[2u];
                                                    let _e7327 = local_17.member_2[2u];
                                                    if (((_e7315 + ((_e7318 - _e7321) * _e6943)) - _e7327) > _e7278) {
                                                        let _e7332 = local_17.member[3u];
                                                        let _e7335 = local_17.member_1[3u];
                                                        let _e7338 = local_17.member[3u];
                                                        let _e7344 = local_17.member_2[3u];
                                                        phi_3410_ = (((_e7332 + ((_e7335 - _e7338) * _e6943)) - _e7344) > _e7278);
                                                        phi_3411_ = false;
                                                    } else {
                                                        phi_3410_ = bool();
                                                        phi_3411_ = true;
                                                    }
                                                    let _e7348 = phi_3410_;
                                                    let _e7350 = phi_3411_;
                                                    phi_3412_ = _e7348;
                                                    phi_3413_ = _e7350;
                                                } else {
                                                    phi_3412_ = bool();
                                                    phi_3413_ = true;
                                                }
                                                let _e7352 = phi_3412_;
                                                let _e7354 = phi_3413_;
                                                phi_3414_ = _e7352;
                                                phi_3415_ = _e7354;
                                            } else {
                                                phi_3414_ = bool();
                                                phi_3415_ = true;
                                            }
                                            let _e7356 = phi_3414_;
                                            let _e7358 = phi_3415_;
                                            if _e7358 {
                                                phi_3419_ = false;
                                            } else {
                                                phi_3419_ = _e7356;
                                            }
                                            let _e7360 = phi_3419_;
                                            if _e7360 {
                                                if (_e6943 <= _e6945) {
                                                    phi_3730_ = true;
                                                } else {
                                                    let _e7362 = f64(0f);
                                                    let _e7365 = local_16.member[0u];
                                                    let _e7368 = local_16.member_1[0u];
                                                    let _e7371 = local_16.member[0u];
                                                    let _e7377 = local_16.member_2[0u];
                                                    let _e7381 = local_17.member[0u];
                                                    let _e7384 = local_17.member_1[0u];
                                                    let _e7387 = local_17.member[0u];
                                                    let _e7393 = local_17.member_2[0u];
                                                    if ((((_e7365 + ((_e7368 - _e7371) * _e6943)) - _e7377) + ((_e7381 + ((_e7384 - _e7387) * _e6949)) - _e7393)) > _e7362) {
                                                        let _e7399 = local_16.member[1u];
                                                        let _e7402 = local_16.member_1[1u];
                                                        let _e7405 = local_16.member[1u];
                                                        let _e7411 = local_16.member_2[1u];
                                                        let _e7415 = local_17.member[1u];
                                                        let _e7418 = local_17.member_1[1u];
                                                        let _e7421 = local_17.member[1u];
                                                        let _e7427 = local_17.member_2[1u];
                                                        if ((((_e7399 + ((_e7402 - _e7405) * _e6943)) - _e7411) + ((_e7415 + ((_e7418 - _e7421) * _e6949)) - _e7427)) > _e7362) {
                                                            let _e7433 = local_16.member[2u];
                                                            let _e7436 = local_16.member_1[2u];
                                                            let _e7439 = local_16.member[2u];
                                                            let _e7445 = local_16.member_2[2u];
                                                            let _e7449 = local_17.member[2u];
                                                            let _e7452 = local_17.member_1[2u];
                                                            let _e7455 = local_17.member[2u];
                                                            let _e7461 = local_17.member_2[2u];
                                                            if ((((_e7433 + ((_e7436 - _e7439) * _e6943)) - _e7445) + ((_e7449 + ((_e7452 - _e7455) * _e6949)) - _e7461)) > _e7362) {
                                                                let _e7467 = local_16.member[3u];
                                                                let _e7470 = local_16.member_1[3u];
                                                                let _e7473 = local_16.member[3u];
                                                                let _e7479 = local_16.member_2[3u];
                                                                let _e7483 = local_17.member[3u];
                                                                let _e7486 = local_17.member_1[3u];
                                                                let _e7489 = local_17.member[3u];
                                                                let _e7495 = local_17.member_2[3u];
                                                                phi_3717_ = ((((_e7467 + ((_e7470 - _e7473) * _e6943)) - _e7479) + ((_e7483 + ((_e7486 - _e7489) * _e6949)) - _e7495)) > _e7362);
                                                                phi_3718_ = false;
                                                            } else {
                                                                phi_3717_ = bool();
                                                                phi_3718_ = true;
                                                            }
                                                            let _e7500 = phi_3717_;
                                                            let _e7502 = phi_3718_;
                                                            phi_3719_ = _e7500;
                                                            phi_3720_ = _e7502;
                                                        } else {
                                                            phi_3719_ = bool();
                                                            phi_3720_ = true;
                                                        }
                                                        let _e7504 = phi_3719_;
                                                        let _e7506 = phi_3720_;
                                                        phi_3721_ = _e7504;
                                                        phi_3722_ = _e7506;
                                                    } else {
                                                        phi_3721_ = bool();
                                                        phi_3722_ = true;
                                                    }
                                                    let _e7508 = phi_3721_;
                                                    let _e7510 = phi_3722_;
                                                    if _e7510 {
                                                        phi_3726_ = false;
                                                    } else {
                                                        phi_3726_ = _e7508;
                                                    }
                                                    let _e7512 = phi_3726_;
                                                    phi_3730_ = _e7512;
                                                }
                                                let _e7514 = phi_3730_;
                                                if _e7514 {
                                                    if _e6951 {
                                                        if (_e6943 >= _e439) {
                                                            phi_3741_ = false;
                                                        } else {
                                                            phi_3741_ = true;
                                                        }
                                                        let _e7517 = phi_3741_;
                                                        phi_3742_ = _e7517;
                                                    } else {
                                                        phi_3742_ = true;
                                                    }
                                                    let _e7519 = phi_3742_;
                                                    if _e7519 {
                                                        local_16 = type_38(array<f64, 4>(_e7256.member[0], _e7256.member[1], _e7256.member[2], _e7256.member[3]), array<f64, 4>(_e7256.member_1[0], _e7256.member_1[1], _e7256.member_1[2], _e7256.member_1[3]), array<f64, 4>(_e7256.member_2[0], _e7256.member_2[1], _e7256.member_2[2], _e7256.member_2[3]));
                                                        let _e7541 = local_16.member[0u];
                                                        let _e7544 = local_16.member_1[0u];
                                                        let _e7547 = local_16.member_2[0u];
                                                        if (_e7541 > _e7547) {
                                                            if (_e7544 > _e7547) {
                                                                phi_3816_ = false;
                                                            } else {
                                                                phi_3816_ = true;
                                                            }
                                                            let _e7551 = phi_3816_;
                                                            phi_3817_ = _e7551;
                                                        } else {
                                                            phi_3817_ = true;
                                                        }
                                                        let _e7553 = phi_3817_;
                                                        if _e7553 {
                                                            let _e7554 = (_e7544 >= _e7541);
                                                            if _e7554 {
                                                                phi_3842_ = f64();
                                                                phi_3843_ = false;
                                                            } else {
                                                                if ((_e7541 - _e7544) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_3840_ = (((_e7541 - _e7547) / (_e7541 - _e7544)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_3841_ = false;
                                                                } else {
                                                                    phi_3840_ = f64();
                                                                    phi_3841_ = true;
                                                                }
                                                                let _e7568 = phi_3840_;
                                                                let _e7570 = phi_3841_;
                                                                phi_3842_ = _e7568;
                                                                phi_3843_ = _e7570;
                                                            }
                                                            let _e7572 = phi_3842_;
                                                            let _e7574 = phi_3843_;
                                                            phi_3844_ = _e7572;
                                                            phi_3845_ = _e7554;
                                                            phi_3846_ = _e7574;
                                                        } else {
                                                            phi_3844_ = f64();
                                                            phi_3845_ = true;
                                                            phi_3846_ = false;
                                                        }
                                                        let _e7576 = phi_3844_;
                                                        let _e7578 = phi_3845_;
                                                        let _e7580 = phi_3846_;
                                                        if _e7578 {
                                                            phi_3851_ = f64(2f);
                                                            phi_3852_ = true;
                                                        } else {
                                                            phi_3851_ = _e6943;
                                                            phi_3852_ = _e7580;
                                                        }
                                                        let _e7583 = phi_3851_;
                                                        let _e7585 = phi_3852_;
                                                        if _e7585 {
                                                            phi_3856_ = _e7583;
                                                        } else {
                                                            phi_3856_ = _e7576;
                                                        }
                                                        let _e7587 = phi_3856_;
                                                        let _e7590 = local_16.member[1u];
                                                        let _e7593 = local_16.member_1[1u];
                                                        let _e7596 = local_16.member_2[1u];
                                                        if (_e7590 > _e7596) {
                                                            if (_e7593 > _e7596) {
                                                                phi_3888_ = false;
                                                            } else {
                                                                phi_3888_ = true;
                                                            }
                                                            let _e7600 = phi_3888_;
                                                            phi_3889_ = _e7600;
                                                        } else {
                                                            phi_3889_ = true;
                                                        }
                                                        let _e7602 = phi_3889_;
                                                        if _e7602 {
                                                            let _e7603 = (_e7593 >= _e7590);
                                                            if _e7603 {
                                                                phi_3914_ = f64();
                                                                phi_3915_ = false;
                                                            } else {
                                                                if ((_e7590 - _e7593) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_3912_ = (((_e7590 - _e7596) / (_e7590 - _e7593)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_3913_ = false;
                                                                } else {
                                                                    phi_3912_ = f64();
                                                                    phi_3913_ = true;
                                                                }
                                                                let _e7617 = phi_3912_;
                                                                let _e7619 = phi_3913_;
                                                                phi_3914_ = _e7617;
                                                                phi_3915_ = _e7619;
                                                            }
                                                            let _e7621 = phi_3914_;
                                                            let _e7623 = phi_3915_;
                                                            phi_3916_ = _e7621;
                                                            phi_3917_ = _e7603;
                                                            phi_3918_ = _e7623;
                                                        } else {
                                                            phi_3916_ = f64();
                                                            phi_3917_ = true;
                                                            phi_3918_ = false;
                                                        }
                                                        let _e7625 = phi_3916_;
                                                        let _e7627 = phi_3917_;
                                                        let _e7629 = phi_3918_;
                                                        if _e7627 {
                                                            phi_3923_ = f64(2f);
                                                            phi_3924_ = true;
                                                        } else {
                                                            phi_3923_ = _e6943;
                                                            phi_3924_ = _e7629;
                                                        }
                                                        let _e7632 = phi_3923_;
                                                        let _e7634 = phi_3924_;
                                                        if _e7634 {
                                                            phi_3928_ = _e7632;
                                                        } else {
                                                            phi_3928_ = _e7625;
                                                        }
                                                        let _e7636 = phi_3928_;
                                                        if (_e7587 < _e7636) {
                                                            phi_3933_ = _e7587;
                                                        } else {
                                                            phi_3933_ = _e7636;
                                                        }
                                                        let _e7639 = phi_3933_;
                                                        let _e7642 = local_16.member[2u];
                                                        let _e7645 = local_16.member_1[2u];
                                                        let _e7648 = local_16.member_2[2u];
                                                        if (_e7642 > _e7648) {
                                                            if (_e7645 > _e7648) {
                                                                phi_3965_ = false;
                                                            } else {
                                                                phi_3965_ = true;
                                                            }
                                                            let _e7652 = phi_3965_;
                                                            phi_3966_ = _e7652;
                                                        } else {
                                                            phi_3966_ = true;
                                                        }
                                                        let _e7654 = phi_3966_;
                                                        if _e7654 {
                                                            let _e7655 = (_e7645 >= _e7642);
                                                            if _e7655 {
                                                                phi_3991_ = f64();
                                                                phi_3992_ = false;
                                                            } else {
                                                                if ((_e7642 - _e7645) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_3989_ = (((_e7642 - _e7648) / (_e7642 - _e7645)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_3990_ = false;
                                                                } else {
                                                                    phi_3989_ = f64();
                                                                    phi_3990_ = true;
                                                                }
                                                                let _e7669 = phi_3989_;
                                                                let _e7671 = phi_3990_;
                                                                phi_3991_ = _e7669;
                                                                phi_3992_ = _e7671;
                                                            }
                                                            let _e7673 = phi_3991_;
                                                            let _e7675 = phi_3992_;
                                                            phi_3993_ = _e7673;
                                                            phi_3994_ = _e7655;
                                                            phi_3995_ = _e7675;
                                                        } else {
                                                            phi_3993_ = f64();
                                                            phi_3994_ = true;
                                                            phi_3995_ = false;
                                                        }
                                                        let _e7677 = phi_3993_;
                                                        let _e7679 = phi_3994_;
                                                        let _e7681 = phi_3995_;
                                                        if _e7679 {
                                                            phi_4000_ = f64(2f);
                                                            phi_4001_ = true;
                                                        } else {
                                                            phi_4000_ = _e6943;
                                                            phi_4001_ = _e7681;
                                                        }
                                                        let _e7684 = phi_4000_;
                                                        let _e7686 = phi_4001_;
                                                        if _e7686 {
                                                            phi_4005_ = _e7684;
                                                        } else {
                                                            phi_4005_ = _e7677;
                                                        }
                                                        let _e7688 = phi_4005_;
                                                        let _e7691 = local_16.member[3u];
                                                        let _e7694 = local_16.member_1[3u];
                                                        let _e7697 = local_16.member_2[3u];
                                                        if (_e7691 > _e7697) {
                                                            if (_e7694 > _e7697) {
                                                                phi_4037_ = false;
                                                            } else {
                                                                phi_4037_ = true;
                                                            }
                                                            let _e7701 = phi_4037_;
                                                            phi_4038_ = _e7701;
                                                        } else {
                                                            phi_4038_ = true;
                                                        }
                                                        let _e7703 = phi_4038_;
                                                        if _e7703 {
                                                            let _e7704 = (_e7694 >= _e7691);
                                                            if _e7704 {
                                                                phi_4063_ = f64();
                                                                phi_4064_ = false;
                                                            } else {
                                                                if ((_e7691 - _e7694) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_4061_ = (((_e7691 - _e7697) / (_e7691 - _e7694)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_4062_ = false;
                                                                } else {
                                                                    phi_4061_ = f64();
                                                                    phi_4062_ = true;
                                                                }
                                                                let _e7718 = phi_4061_;
                                                                let _e7720 = phi_4062_;
                                                                phi_4063_ = _e7718;
                                                                phi_4064_ = _e7720;
                                                            }
                                                            let _e7722 = phi_4063_;
                                                            let _e7724 = phi_4064_;
                                                            phi_4065_ = _e7722;
                                                            phi_4066_ = _e7704;
                                                            phi_4067_ = _e7724;
                                                        } else {
                                                            phi_4065_ = f64();
                                                            phi_4066_ = true;
                                                            phi_4067_ = false;
                                                        }
                                                        let _e7726 = phi_4065_;
                                                        let _e7728 = phi_4066_;
                                                        let _e7730 = phi_4067_;
                                                        if _e7728 {
                                                            phi_4072_ = f64(2f);
                                                            phi_4073_ = true;
                                                        } else {
                                                            phi_4072_ = _e6943;
                                                            phi_4073_ = _e7730;
                                                        }
                                                        let _e7733 = phi_4072_;
                                                        let _e7735 = phi_4073_;
                                                        if _e7735 {
                                                            phi_4077_ = _e7733;
                                                        } else {
                                                            phi_4077_ = _e7726;
                                                        }
                                                        let _e7737 = phi_4077_;
                                                        if (_e7688 < _e7737) {
                                                            phi_4082_ = _e7688;
                                                        } else {
                                                            phi_4082_ = _e7737;
                                                        }
                                                        let _e7740 = phi_4082_;
                                                        if (_e7639 < _e7740) {
                                                            phi_4087_ = _e7639;
                                                        } else {
                                                            phi_4087_ = _e7740;
                                                        }
                                                        let _e7743 = phi_4087_;
                                                        if (_e7743 > _e6943) {
                                                            phi_4092_ = _e7743;
                                                        } else {
                                                            phi_4092_ = _e6943;
                                                        }
                                                        let _e7746 = phi_4092_;
                                                        let _e7747 = (_e7746 > _e439);
                                                        if _e7747 {
                                                            phi_4609_ = f64();
                                                            phi_4610_ = f64();
                                                            phi_4611_ = false;
                                                            phi_4612_ = false;
                                                        } else {
                                                            let _e7748 = (_e7746 - _e6943);
                                                            let _e7749 = (_e7748 <= _e6932);
                                                            let _e7752 = (_e7746 + (_e421 * f64(0.01f)));
                                                            if (_e7752 < _e439) {
                                                                phi_4106_ = _e7752;
                                                            } else {
                                                                phi_4106_ = _e439;
                                                            }
                                                            let _e7755 = phi_4106_;
                                                            if _e7749 {
                                                                if (_e643.member_1 > f64(0f)) {
                                                                    let _e7760 = local_18.member[0u];
                                                                    let _e7766 = local_18.member[1u];
                                                                    let _e7782 = local_18.member_1[0u];
                                                                    let _e7788 = local_18.member_1[1u];
                                                                    let _e7804 = local_18.member_2[0u];
                                                                    let _e7810 = local_18.member_2[1u];
                                                                    let _e7824 = function_4(array<f64, 3>((_e7760[0] + ((_e7766[0] - _e7760[0]) * _e7755)), (_e7760[1] + ((_e7766[1] - _e7760[1]) * _e7755)), (_e7760[2] + ((_e7766[2] - _e7760[2]) * _e7755))), array<f64, 3>((_e7782[0] + ((_e7788[0] - _e7782[0]) * _e7755)), (_e7782[1] + ((_e7788[1] - _e7782[1]) * _e7755)), (_e7782[2] + ((_e7788[2] - _e7782[2]) * _e7755))), array<f64, 3>((_e7804[0] + ((_e7810[0] - _e7804[0]) * _e7755)), (_e7804[1] + ((_e7810[1] - _e7804[1]) * _e7755)), (_e7804[2] + ((_e7810[2] - _e7804[2]) * _e7755))), 1u);
                                                                    let _e7835 = (((_e7824[0] * _e7824[0]) + (_e7824[1] * _e7824[1])) + (_e7824[2] * _e7824[2]));
                                                                    if (_e7835 <= 2.2250738585072014e-308lf) {
                                                                        if (_e7835 > 0.0lf) {
                                                                            phi_4237_ = (1.464336215552873e-154lf * 2.0lf);
                                                                        } else {
                                                                            phi_4237_ = 0.0lf;
                                                                        }
                                                                        let _e7887 = phi_4237_;
                                                                        phi_4301_ = _e7887;
                                                                    } else {
                                                                        phi_4244_ = type_16(0i, 5i);
                                                                        phi_4247_ = bitcast<f64>(((bitcast<u64>(_e7835) / 2lu) + 2303426169912950784lu));
                                                                        loop {
                                                                            let _e7842 = phi_4244_;
                                                                            let _e7844 = phi_4247_;
                                                                            local_42 = _e7844;
                                                                            if (_e7842.member < _e7842.member_1) {
                                                                                let _e7851 = (_e7842.member + 1i);
                                                                                if ((false == (_e7851 > _e7842.member)) != false) {
                                                                                    phi_4268_ = true;
                                                                                } else {
                                                                                    phi_4268_ = false;
                                                                                }
                                                                                let _e7856 = phi_4268_;
                                                                                if _e7856 {
                                                                                    phi_4274_ = type_17(0u, type_17().member_1);
                                                                                } else {
                                                                                    phi_4274_ = type_17(1u, _e7851);
                                                                                }
                                                                                let _e7861 = phi_4274_;
                                                                                phi_4245_ = type_16(_e7861.member_1, _e7842.member_1);
                                                                                phi_4288_ = type_17(1u, _e7842.member);
                                                                            } else {
                                                                                phi_4245_ = _e7842;
                                                                                phi_4288_ = type_17(0u, type_17().member_1);
                                                                            }
                                                                            let _e7867 = phi_4245_;
                                                                            let _e7869 = phi_4288_;
                                                                            let _e7872 = (bitcast<i32>(_e7869.member) != 0i);
                                                                            if _e7872 {
                                                                                phi_4248_ = (0.5lf * (_e7844 + (_e7835 / _e7844)));
                                                                            } else {
                                                                                phi_4248_ = f64();
                                                                            }
                                                                            let _e7877 = phi_4248_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_4244_ = _e7867;
                                                                                phi_4247_ = _e7877;
                                                                                break if !(_e7872);
                                                                            }
                                                                        }
                                                                        let _e7882 = local_42;
                                                                        phi_4301_ = (_e7882 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                    }
                                                                    let _e7889 = phi_4301_;
                                                                    let _e7897 = local_18.member[0u];
                                                                    if (_e7897[0] < 0.0lf) {
                                                                        phi_4319_ = -(_e7897[0]);
                                                                    } else {
                                                                        phi_4319_ = _e7897[0];
                                                                    }
                                                                    let _e7904 = phi_4319_;
                                                                    if (_e7897[1] < 0.0lf) {
                                                                        phi_4326_ = -(_e7897[1]);
                                                                    } else {
                                                                        phi_4326_ = _e7897[1];
                                                                    }
                                                                    let _e7908 = phi_4326_;
                                                                    if (_e7904 > _e7908) {
                                                                        phi_4331_ = _e7904;
                                                                    } else {
                                                                        phi_4331_ = _e7908;
                                                                    }
                                                                    let _e7911 = phi_4331_;
                                                                    if (_e7897[2] < 0.0lf) {
                                                                        phi_4338_ = -(_e7897[2]);
                                                                    } else {
                                                                        phi_4338_ = _e7897[2];
                                                                    }
                                                                    let _e7915 = phi_4338_;
                                                                    if (_e7911 > _e7915) {
                                                                        phi_4343_ = _e7911;
                                                                    } else {
                                                                        phi_4343_ = _e7915;
                                                                    }
                                                                    let _e7918 = phi_4343_;
                                                                    let _e7921 = local_18.member[1u];
                                                                    if (_e7921[0] < 0.0lf) {
                                                                        phi_4356_ = -(_e7921[0]);
                                                                    } else {
                                                                        phi_4356_ = _e7921[0];
                                                                    }
                                                                    let _e7928 = phi_4356_;
                                                                    if (_e7921[1] < 0.0lf) {
                                                                        phi_4363_ = -(_e7921[1]);
                                                                    } else {
                                                                        phi_4363_ = _e7921[1];
                                                                    }
                                                                    let _e7932 = phi_4363_;
                                                                    if (_e7928 > _e7932) {
                                                                        phi_4368_ = _e7928;
                                                                    } else {
                                                                        phi_4368_ = _e7932;
                                                                    }
                                                                    let _e7935 = phi_4368_;
                                                                    if (_e7921[2] < 0.0lf) {
                                                                        phi_4375_ = -(_e7921[2]);
                                                                    } else {
                                                                        phi_4375_ = _e7921[2];
                                                                    }
                                                                    let _e7939 = phi_4375_;
                                                                    if (_e7935 > _e7939) {
                                                                        phi_4380_ = _e7935;
                                                                    } else {
                                                                        phi_4380_ = _e7939;
                                                                    }
                                                                    let _e7942 = phi_4380_;
                                                                    if (_e7918 > _e7942) {
                                                                        phi_4385_ = _e7918;
                                                                    } else {
                                                                        phi_4385_ = _e7942;
                                                                    }
                                                                    let _e7945 = phi_4385_;
                                                                    let _e7947 = local_18.member_3;
                                                                    let _e7951 = local_18.member_1[0u];
                                                                    if (_e7951[0] < 0.0lf) {
                                                                        phi_4402_ = -(_e7951[0]);
                                                                    } else {
                                                                        phi_4402_ = _e7951[0];
                                                                    }
                                                                    let _e7958 = phi_4402_;
                                                                    if (_e7951[1] < 0.0lf) {
                                                                        phi_4409_ = -(_e7951[1]);
                                                                    } else {
                                                                        phi_4409_ = _e7951[1];
                                                                    }
                                                                    let _e7962 = phi_4409_;
                                                                    if (_e7958 > _e7962) {
                                                                        phi_4414_ = _e7958;
                                                                    } else {
                                                                        phi_4414_ = _e7962;
                                                                    }
                                                                    let _e7965 = phi_4414_;
                                                                    if (_e7951[2] < 0.0lf) {
                                                                        phi_4421_ = -(_e7951[2]);
                                                                    } else {
                                                                        phi_4421_ = _e7951[2];
                                                                    }
                                                                    let _e7969 = phi_4421_;
                                                                    if (_e7965 > _e7969) {
                                                                        phi_4426_ = _e7965;
                                                                    } else {
                                                                        phi_4426_ = _e7969;
                                                                    }
                                                                    let _e7972 = phi_4426_;
                                                                    let _e7975 = local_18.member_1[1u];
                                                                    if (_e7975[0] < 0.0lf) {
                                                                        phi_4440_ = -(_e7975[0]);
                                                                    } else {
                                                                        phi_4440_ = _e7975[0];
                                                                    }
                                                                    let _e7982 = phi_4440_;
                                                                    if (_e7975[1] < 0.0lf) {
                                                                        phi_4447_ = -(_e7975[1]);
                                                                    } else {
                                                                        phi_4447_ = _e7975[1];
                                                                    }
                                                                    let _e7986 = phi_4447_;
                                                                    if (_e7982 > _e7986) {
                                                                        phi_4452_ = _e7982;
                                                                    } else {
                                                                        phi_4452_ = _e7986;
                                                                    }
                                                                    let _e7989 = phi_4452_;
                                                                    if (_e7975[2] < 0.0lf) {
                                                                        phi_4459_ = -(_e7975[2]);
                                                                    } else {
                                                                        phi_4459_ = _e7975[2];
                                                                    }
                                                                    let _e7993 = phi_4459_;
                                                                    if (_e7989 > _e7993) {
                                                                        phi_4464_ = _e7989;
                                                                    } else {
                                                                        phi_4464_ = _e7993;
                                                                    }
                                                                    let _e7996 = phi_4464_;
                                                                    if (_e7972 > _e7996) {
                                                                        phi_4469_ = _e7972;
                                                                    } else {
                                                                        phi_4469_ = _e7996;
                                                                    }
                                                                    let _e7999 = phi_4469_;
                                                                    let _e8001 = local_18.member_3;
                                                                    let _e8005 = local_18.member_2[0u];
                                                                    if (_e8005[0] < 0.0lf) {
                                                                        phi_4486_ = -(_e8005[0]);
                                                                    } else {
                                                                        phi_4486_ = _e8005[0];
                                                                    }
                                                                    let _e8012 = phi_4486_;
                                                                    if (_e8005[1] < 0.0lf) {
                                                                        phi_4493_ = -(_e8005[1]);
                                                                    } else {
                                                                        phi_4493_ = _e8005[1];
                                                                    }
                                                                    let _e8016 = phi_4493_;
                                                                    if (_e8012 > _e8016) {
                                                                        phi_4498_ = _e8012;
                                                                    } else {
                                                                        phi_4498_ = _e8016;
                                                                    }
                                                                    let _e8019 = phi_4498_;
                                                                    if (_e8005[2] < 0.0lf) {
                                                                        phi_4505_ = -(_e8005[2]);
                                                                    } else {
                                                                        phi_4505_ = _e8005[2];
                                                                    }
                                                                    let _e8023 = phi_4505_;
                                                                    if (_e8019 > _e8023) {
                                                                        phi_4510_ = _e8019;
                                                                    } else {
                                                                        phi_4510_ = _e8023;
                                                                    }
                                                                    let _e8026 = phi_4510_;
                                                                    let _e8029 = local_18.member_2[1u];
                                                                    if (_e8029[0] < 0.0lf) {
                                                                        phi_4524_ = -(_e8029[0]);
                                                                    } else {
                                                                        phi_4524_ = _e8029[0];
                                                                    }
                                                                    let _e8036 = phi_4524_;
                                                                    if (_e8029[1] < 0.0lf) {
                                                                        phi_4531_ = -(_e8029[1]);
                                                                    } else {
                                                                        phi_4531_ = _e8029[1];
                                                                    }
                                                                    let _e8040 = phi_4531_;
                                                                    if (_e8036 > _e8040) {
                                                                        phi_4536_ = _e8036;
                                                                    } else {
                                                                        phi_4536_ = _e8040;
                                                                    }
                                                                    let _e8043 = phi_4536_;
                                                                    if (_e8029[2] < 0.0lf) {
                                                                        phi_4543_ = -(_e8029[2]);
                                                                    } else {
                                                                        phi_4543_ = _e8029[2];
                                                                    }
                                                                    let _e8047 = phi_4543_;
                                                                    if (_e8043 > _e8047) {
                                                                        phi_4548_ = _e8043;
                                                                    } else {
                                                                        phi_4548_ = _e8047;
                                                                    }
                                                                    let _e8050 = phi_4548_;
                                                                    if (_e8026 > _e8050) {
                                                                        phi_4553_ = _e8026;
                                                                    } else {
                                                                        phi_4553_ = _e8050;
                                                                    }
                                                                    let _e8053 = phi_4553_;
                                                                    let _e8055 = local_18.member_3;
                                                                    let _e8063 = local_18.member_3;
                                                                    if (((_e7889 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e7945 + _e7947) + (_e7999 + _e8001)) + (_e8053 + _e8055)) * (1.1102230246251565e-16lf * f64(16f))) + (_e8063 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e643.member_1) {
                                                                        phi_4577_ = false;
                                                                    } else {
                                                                        phi_4577_ = true;
                                                                    }
                                                                    let _e8075 = phi_4577_;
                                                                    phi_4578_ = _e8075;
                                                                } else {
                                                                    phi_4578_ = true;
                                                                }
                                                                let _e8077 = phi_4578_;
                                                                phi_4579_ = _e8077;
                                                            } else {
                                                                phi_4579_ = true;
                                                            }
                                                            let _e8079 = phi_4579_;
                                                            if _e8079 {
                                                                if _e6951 {
                                                                    if _e7749 {
                                                                        phi_4598_ = f64();
                                                                        phi_4599_ = true;
                                                                    } else {
                                                                        if (_e7748 <= (_e6947 * f64(0.25f))) {
                                                                            phi_4596_ = f64(0f);
                                                                            phi_4597_ = false;
                                                                        } else {
                                                                            phi_4596_ = f64();
                                                                            phi_4597_ = true;
                                                                        }
                                                                        let _e8086 = phi_4596_;
                                                                        let _e8088 = phi_4597_;
                                                                        phi_4598_ = _e8086;
                                                                        phi_4599_ = _e8088;
                                                                    }
                                                                    let _e8090 = phi_4598_;
                                                                    let _e8092 = phi_4599_;
                                                                    if _e8092 {
                                                                        phi_4604_ = (_e7276 + _e7276);
                                                                    } else {
                                                                        phi_4604_ = _e8090;
                                                                    }
                                                                    let _e8095 = phi_4604_;
                                                                    phi_4606_ = _e8095;
                                                                } else {
                                                                    phi_4606_ = (_e439 - _e6943);
                                                                }
                                                                let _e8097 = phi_4606_;
                                                                phi_4607_ = _e8097;
                                                                phi_4608_ = false;
                                                            } else {
                                                                phi_4607_ = f64();
                                                                phi_4608_ = true;
                                                            }
                                                            let _e8099 = phi_4607_;
                                                            let _e8101 = phi_4608_;
                                                            phi_4609_ = _e8099;
                                                            phi_4610_ = _e7748;
                                                            phi_4611_ = _e8079;
                                                            phi_4612_ = _e8101;
                                                        }
                                                        let _e8103 = phi_4609_;
                                                        let _e8105 = phi_4610_;
                                                        let _e8107 = phi_4611_;
                                                        let _e8109 = phi_4612_;
                                                        phi_4613_ = _e7746;
                                                        phi_4614_ = _e8103;
                                                        phi_4615_ = _e8105;
                                                        phi_4616_ = _e7746;
                                                        phi_4617_ = _e8107;
                                                        phi_4618_ = _e7747;
                                                        phi_4619_ = _e8109;
                                                        phi_4620_ = false;
                                                    } else {
                                                        phi_4613_ = f64();
                                                        phi_4614_ = f64();
                                                        phi_4615_ = f64();
                                                        phi_4616_ = f64();
                                                        phi_4617_ = false;
                                                        phi_4618_ = false;
                                                        phi_4619_ = false;
                                                        phi_4620_ = true;
                                                    }
                                                    let _e8111 = phi_4613_;
                                                    let _e8113 = phi_4614_;
                                                    let _e8115 = phi_4615_;
                                                    let _e8117 = phi_4616_;
                                                    let _e8119 = phi_4617_;
                                                    let _e8121 = phi_4618_;
                                                    let _e8123 = phi_4619_;
                                                    let _e8125 = phi_4620_;
                                                    phi_4621_ = _e8111;
                                                    phi_4622_ = _e8113;
                                                    phi_4623_ = _e8115;
                                                    phi_4624_ = _e8117;
                                                    phi_4625_ = false;
                                                    phi_4626_ = _e8119;
                                                    phi_4627_ = _e8121;
                                                    phi_4628_ = _e8123;
                                                    phi_4629_ = _e8125;
                                                } else {
                                                    phi_4621_ = f64();
                                                    phi_4622_ = f64();
                                                    phi_4623_ = f64();
                                                    phi_4624_ = f64();
                                                    phi_4625_ = true;
                                                    phi_4626_ = false;
                                                    phi_4627_ = false;
                                                    phi_4628_ = false;
                                                    phi_4629_ = false;
                                                }
                                                let _e8127 = phi_4621_;
                                                let _e8129 = phi_4622_;
                                                let _e8131 = phi_4623_;
                                                let _e8133 = phi_4624_;
                                                let _e8135 = phi_4625_;
                                                let _e8137 = phi_4626_;
                                                let _e8139 = phi_4627_;
                                                let _e8141 = phi_4628_;
                                                let _e8143 = phi_4629_;
                                                phi_4630_ = _e8127;
                                                phi_4631_ = _e8129;
                                                phi_4632_ = _e8131;
                                                phi_4633_ = _e8133;
                                                phi_4634_ = _e8135;
                                                phi_4635_ = _e8137;
                                                phi_4636_ = _e8139;
                                                phi_4637_ = _e8141;
                                                phi_4638_ = _e8143;
                                            } else {
                                                phi_4630_ = f64();
                                                phi_4631_ = f64();
                                                phi_4632_ = f64();
                                                phi_4633_ = f64();
                                                phi_4634_ = true;
                                                phi_4635_ = false;
                                                phi_4636_ = false;
                                                phi_4637_ = false;
                                                phi_4638_ = false;
                                            }
                                            let _e8145 = phi_4630_;
                                            let _e8147 = phi_4631_;
                                            let _e8149 = phi_4632_;
                                            let _e8151 = phi_4633_;
                                            let _e8153 = phi_4634_;
                                            let _e8155 = phi_4635_;
                                            let _e8157 = phi_4636_;
                                            let _e8159 = phi_4637_;
                                            let _e8161 = phi_4638_;
                                            if _e8153 {
                                                if (_e6943 <= _e6945) {
                                                    let _e8327 = (_e6953 + 1u);
                                                    let _e8328 = (_e8327 > 3u);
                                                    if _e8328 {
                                                        phi_4651_ = false;
                                                    } else {
                                                        phi_4651_ = true;
                                                    }
                                                    let _e8330 = phi_4651_;
                                                    phi_4978_ = _e8327;
                                                    phi_4979_ = f64();
                                                    phi_4980_ = false;
                                                    phi_4981_ = _e8330;
                                                    phi_4982_ = _e8328;
                                                } else {
                                                    let _e8165 = local_16.member[0u];
                                                    let _e8168 = local_16.member_1[0u];
                                                    let _e8171 = local_16.member[0u];
                                                    let _e8177 = local_16.member_2[0u];
                                                    let _e8178 = ((_e8165 + ((_e8168 - _e8171) * _e6949)) - _e8177);
                                                    let _e8181 = local_16.member[1u];
                                                    let _e8184 = local_16.member_1[1u];
                                                    let _e8187 = local_16.member[1u];
                                                    let _e8193 = local_16.member_2[1u];
                                                    let _e8194 = ((_e8181 + ((_e8184 - _e8187) * _e6949)) - _e8193);
                                                    if (_e8178 < _e8194) {
                                                        phi_4724_ = _e8178;
                                                    } else {
                                                        phi_4724_ = _e8194;
                                                    }
                                                    let _e8197 = phi_4724_;
                                                    let _e8200 = local_16.member[2u];
                                                    let _e8203 = local_16.member_1[2u];
                                                    let _e8206 = local_16.member[2u];
                                                    let _e8212 = local_16.member_2[2u];
                                                    let _e8213 = ((_e8200 + ((_e8203 - _e8206) * _e6949)) - _e8212);
                                                    let _e8216 = local_16.member[3u];
                                                    let _e8219 = local_16.member_1[3u];
                                                    let _e8222 = local_16.member[3u];
                                                    let _e8228 = local_16.member_2[3u];
                                                    let _e8229 = ((_e8216 + ((_e8219 - _e8222) * _e6949)) - _e8228);
                                                    if (_e8213 < _e8229) {
                                                        phi_4797_ = _e8213;
                                                    } else {
                                                        phi_4797_ = _e8229;
                                                    }
                                                    let _e8232 = phi_4797_;
                                                    if (_e8197 < _e8232) {
                                                        phi_4802_ = _e8197;
                                                    } else {
                                                        phi_4802_ = _e8232;
                                                    }
                                                    let _e8235 = phi_4802_;
                                                    let _e8238 = local_17.member[0u];
                                                    let _e8241 = local_17.member_1[0u];
                                                    let _e8244 = local_17.member[0u];
                                                    let _e8250 = local_17.member_2[0u];
                                                    let _e8251 = ((_e8238 + ((_e8241 - _e8244) * _e6943)) - _e8250);
                                                    let _e8254 = local_17.member[1u];
                                                    let _e8257 = local_17.member_1[1u];
                                                    let _e8260 = local_17.member[1u];
                                                    let _e8266 = local_17.member_2[1u];
                                                    let _e8267 = ((_e8254 + ((_e8257 - _e8260) * _e6943)) - _e8266);
                                                    if (_e8251 < _e8267) {
                                                        phi_4875_ = _e8251;
                                                    } else {
                                                        phi_4875_ = _e8267;
                                                    }
                                                    let _e8270 = phi_4875_;
                                                    let _e8273 = local_17.member[2u];
                                                    let _e8276 = local_17.member_1[2u];
                                                    let _e8279 = local_17.member[2u];
                                                    let _e8285 = local_17.member_2[2u];
                                                    let _e8286 = ((_e8273 + ((_e8276 - _e8279) * _e6943)) - _e8285);
                                                    let _e8289 = local_17.member[3u];
                                                    let _e8292 = local_17.member_1[3u];
                                                    let _e8295 = local_17.member[3u];
                                                    let _e8301 = local_17.member_2[3u];
                                                    let _e8302 = ((_e8289 + ((_e8292 - _e8295) * _e6943)) - _e8301);
                                                    if (_e8286 < _e8302) {
                                                        phi_4948_ = _e8286;
                                                    } else {
                                                        phi_4948_ = _e8302;
                                                    }
                                                    let _e8305 = phi_4948_;
                                                    if (_e8270 < _e8305) {
                                                        phi_4953_ = _e8270;
                                                    } else {
                                                        phi_4953_ = _e8305;
                                                    }
                                                    let _e8308 = phi_4953_;
                                                    let _e8309 = f64(0.0625f);
                                                    let _e8311 = f64(0.9f);
                                                    if (_e8308 > f64(0f)) {
                                                        phi_4976_ = f64(0.5f);
                                                    } else {
                                                        let _e8317 = (f64(0.95f) * (_e8235 / (_e8235 - _e8308)));
                                                        if (_e8317 > _e8309) {
                                                            if (_e8317 < _e8311) {
                                                                phi_4974_ = _e8317;
                                                            } else {
                                                                phi_4974_ = _e8311;
                                                            }
                                                            let _e8321 = phi_4974_;
                                                            phi_4975_ = _e8321;
                                                        } else {
                                                            phi_4975_ = _e8309;
                                                        }
                                                        let _e8323 = phi_4975_;
                                                        phi_4976_ = _e8323;
                                                    }
                                                    let _e8325 = phi_4976_;
                                                    phi_4978_ = u32();
                                                    phi_4979_ = (_e7276 * _e8325);
                                                    phi_4980_ = true;
                                                    phi_4981_ = false;
                                                    phi_4982_ = false;
                                                }
                                                let _e8332 = phi_4978_;
                                                let _e8334 = phi_4979_;
                                                let _e8336 = phi_4980_;
                                                let _e8338 = phi_4981_;
                                                let _e8340 = phi_4982_;
                                                phi_4983_ = _e8332;
                                                phi_4984_ = _e6945;
                                                phi_4985_ = _e8334;
                                                phi_4986_ = _e6947;
                                                phi_4987_ = _e6949;
                                                phi_4988_ = _e6951;
                                                phi_4989_ = _e6953;
                                                phi_4990_ = _e8336;
                                                phi_4991_ = _e8338;
                                                phi_4992_ = _e8340;
                                                phi_4993_ = false;
                                                phi_4994_ = false;
                                                phi_4995_ = false;
                                            } else {
                                                phi_4983_ = u32();
                                                phi_4984_ = _e8145;
                                                phi_4985_ = _e8147;
                                                phi_4986_ = _e8149;
                                                phi_4987_ = _e6943;
                                                phi_4988_ = true;
                                                phi_4989_ = 0u;
                                                phi_4990_ = _e8155;
                                                phi_4991_ = false;
                                                phi_4992_ = false;
                                                phi_4993_ = _e8157;
                                                phi_4994_ = _e8159;
                                                phi_4995_ = _e8161;
                                            }
                                            let _e8342 = phi_4983_;
                                            let _e8344 = phi_4984_;
                                            let _e8346 = phi_4985_;
                                            let _e8348 = phi_4986_;
                                            let _e8350 = phi_4987_;
                                            let _e8352 = phi_4988_;
                                            let _e8354 = phi_4989_;
                                            let _e8356 = phi_4990_;
                                            let _e8358 = phi_4991_;
                                            let _e8360 = phi_4992_;
                                            let _e8362 = phi_4993_;
                                            let _e8364 = phi_4994_;
                                            let _e8366 = phi_4995_;
                                            if _e8356 {
                                                let _e8367 = (_e8350 + _e8346);
                                                if (_e8367 > _e8344) {
                                                    phi_5004_ = _e8367;
                                                } else {
                                                    phi_5004_ = _e8344;
                                                }
                                                let _e8370 = phi_5004_;
                                                if (_e8370 < _e439) {
                                                    phi_5009_ = _e8370;
                                                } else {
                                                    phi_5009_ = _e439;
                                                }
                                                let _e8373 = phi_5009_;
                                                if !(_e6951) {
                                                    phi_5018_ = true;
                                                } else {
                                                    phi_5018_ = ((_e8373 - _e8350) > _e6932);
                                                }
                                                let _e8377 = phi_5018_;
                                                if _e8377 {
                                                    phi_5022_ = false;
                                                } else {
                                                    phi_5022_ = true;
                                                }
                                                let _e8379 = phi_5022_;
                                                phi_5023_ = _e8373;
                                                phi_5024_ = _e8344;
                                                phi_5025_ = _e8348;
                                                phi_5026_ = _e8350;
                                                phi_5027_ = _e8352;
                                                phi_5028_ = _e8354;
                                                phi_5029_ = _e8377;
                                                phi_5030_ = _e8379;
                                                phi_5031_ = false;
                                                phi_5032_ = false;
                                                phi_5033_ = false;
                                                phi_5034_ = false;
                                            } else {
                                                phi_5023_ = _e6943;
                                                phi_5024_ = _e6945;
                                                phi_5025_ = _e6947;
                                                phi_5026_ = _e6949;
                                                phi_5027_ = _e6951;
                                                phi_5028_ = _e8342;
                                                phi_5029_ = _e8358;
                                                phi_5030_ = false;
                                                phi_5031_ = _e8360;
                                                phi_5032_ = _e8362;
                                                phi_5033_ = _e8364;
                                                phi_5034_ = _e8366;
                                            }
                                            let _e8381 = phi_5023_;
                                            let _e8383 = phi_5024_;
                                            let _e8385 = phi_5025_;
                                            let _e8387 = phi_5026_;
                                            let _e8389 = phi_5027_;
                                            let _e8391 = phi_5028_;
                                            let _e8393 = phi_5029_;
                                            let _e8395 = phi_5030_;
                                            let _e8397 = phi_5031_;
                                            let _e8399 = phi_5032_;
                                            let _e8401 = phi_5033_;
                                            let _e8403 = phi_5034_;
                                            phi_2813_ = _e8381;
                                            phi_2815_ = _e8383;
                                            phi_2817_ = _e8385;
                                            phi_2819_ = _e8387;
                                            phi_2821_ = _e8389;
                                            phi_2823_ = _e8391;
                                            phi_5035_ = _e8344;
                                            phi_5036_ = _e8151;
                                            phi_5037_ = _e8393;
                                            phi_5038_ = _e8395;
                                            phi_5039_ = _e8397;
                                            phi_5040_ = _e8399;
                                            phi_5041_ = _e8401;
                                            phi_5042_ = false;
                                            phi_5043_ = _e8403;
                                        } else {
                                            phi_2813_ = f64();
                                            phi_2815_ = f64();
                                            phi_2817_ = f64();
                                            phi_2819_ = f64();
                                            phi_2821_ = bool();
                                            phi_2823_ = u32();
                                            phi_5035_ = f64();
                                            phi_5036_ = f64();
                                            phi_5037_ = false;
                                            phi_5038_ = false;
                                            phi_5039_ = false;
                                            phi_5040_ = false;
                                            phi_5041_ = false;
                                            phi_5042_ = true;
                                            phi_5043_ = false;
                                        }
                                        let _e8405 = phi_2813_;
                                        let _e8407 = phi_2815_;
                                        let _e8409 = phi_2817_;
                                        let _e8411 = phi_2819_;
                                        let _e8413 = phi_2821_;
                                        let _e8415 = phi_2823_;
                                        let _e8417 = phi_5035_;
                                        let _e8419 = phi_5036_;
                                        let _e8421 = phi_5037_;
                                        let _e8423 = phi_5038_;
                                        let _e8425 = phi_5039_;
                                        let _e8427 = phi_5040_;
                                        let _e8429 = phi_5041_;
                                        let _e8431 = phi_5042_;
                                        let _e8433 = phi_5043_;
                                        local_43 = _e8423;
                                        local_81 = _e8425;
                                        local_82 = _e8427;
                                        local_83 = _e8429;
                                        local_84 = _e8431;
                                        local_85 = _e8433;
                                        local_86 = _e8423;
                                        local_87 = _e8419;
                                        local_88 = _e8417;
                                        continue;
                                        continuing {
                                            phi_2809_ = _e6965;
                                            phi_2812_ = _e8405;
                                            phi_2814_ = _e8407;
                                            phi_2816_ = _e8409;
                                            phi_2818_ = _e8411;
                                            phi_2820_ = _e8413;
                                            phi_2822_ = _e8415;
                                            break if !(_e8421);
                                        }
                                    }
                                    let _e8436 = local_43;
                                    if _e8436 {
                                        phi_5047_ = false;
                                        phi_5048_ = false;
                                        phi_5049_ = false;
                                        phi_5050_ = false;
                                        phi_5051_ = false;
                                    } else {
                                        let _e11912 = local_81;
                                        phi_5047_ = _e11912;
                                        let _e11915 = local_82;
                                        phi_5048_ = _e11915;
                                        let _e11918 = local_83;
                                        phi_5049_ = _e11918;
                                        let _e11921 = local_84;
                                        phi_5050_ = _e11921;
                                        let _e11924 = local_85;
                                        phi_5051_ = _e11924;
                                    }
                                    let _e8438 = phi_5047_;
                                    let _e8440 = phi_5048_;
                                    let _e8442 = phi_5049_;
                                    let _e8444 = phi_5050_;
                                    let _e8446 = phi_5051_;
                                    if _e8438 {
                                        let _e8448 = local_44;
                                        phi_5056_ = type_46(1u, _e8448);
                                        phi_5057_ = false;
                                        phi_5058_ = false;
                                        phi_5059_ = false;
                                        phi_5060_ = false;
                                        phi_5061_ = false;
                                    } else {
                                        phi_5056_ = type_46();
                                        phi_5057_ = _e8440;
                                        phi_5058_ = _e8442;
                                        let _e11931 = local_86;
                                        phi_5059_ = _e11931;
                                        phi_5060_ = _e8444;
                                        phi_5061_ = _e8446;
                                    }
                                    let _e8451 = phi_5056_;
                                    let _e8453 = phi_5057_;
                                    let _e8455 = phi_5058_;
                                    let _e8457 = phi_5059_;
                                    let _e8459 = phi_5060_;
                                    let _e8461 = phi_5061_;
                                    if _e8453 {
                                        phi_5066_ = type_46(0u, type_46().member_1);
                                        phi_5067_ = false;
                                        phi_5068_ = false;
                                        phi_5069_ = false;
                                        phi_5070_ = false;
                                        phi_5071_ = true;
                                    } else {
                                        phi_5066_ = _e8451;
                                        phi_5067_ = _e8455;
                                        phi_5068_ = _e8457;
                                        phi_5069_ = _e8459;
                                        phi_5070_ = _e8461;
                                        phi_5071_ = _e8438;
                                    }
                                    let _e8465 = phi_5066_;
                                    let _e8467 = phi_5067_;
                                    let _e8469 = phi_5068_;
                                    let _e8471 = phi_5069_;
                                    let _e8473 = phi_5070_;
                                    let _e8475 = phi_5071_;
                                    if _e8467 {
                                        let _e11942 = local_87;
                                        phi_5075_ = _e11942;
                                        phi_5076_ = true;
                                        phi_5077_ = false;
                                        phi_5078_ = false;
                                        phi_5079_ = false;
                                    } else {
                                        let _e11944 = local_88;
                                        phi_5075_ = _e11944;
                                        phi_5076_ = _e8469;
                                        phi_5077_ = _e8471;
                                        phi_5078_ = _e8473;
                                        phi_5079_ = _e8475;
                                    }
                                    let _e8477 = phi_5075_;
                                    let _e8479 = phi_5076_;
                                    let _e8481 = phi_5077_;
                                    let _e8483 = phi_5078_;
                                    let _e8485 = phi_5079_;
                                    if _e8479 {
                                        phi_5083_ = _e8477;
                                        phi_5084_ = true;
                                        phi_5085_ = false;
                                        phi_5086_ = false;
                                    } else {
                                        let _e11951 = local_89;
                                        phi_5083_ = _e11951;
                                        phi_5084_ = _e8481;
                                        phi_5085_ = _e8483;
                                        phi_5086_ = _e8485;
                                    }
                                    let _e8487 = phi_5083_;
                                    let _e8489 = phi_5084_;
                                    let _e8491 = phi_5085_;
                                    let _e8493 = phi_5086_;
                                    if _e8489 {
                                        phi_5091_ = type_46(1u, _e8487);
                                        phi_5092_ = false;
                                        phi_5093_ = false;
                                    } else {
                                        phi_5091_ = type_46();
                                        phi_5092_ = _e8491;
                                        phi_5093_ = _e8493;
                                    }
                                    let _e8496 = phi_5091_;
                                    let _e8498 = phi_5092_;
                                    let _e8500 = phi_5093_;
                                    if _e8498 {
                                        phi_5098_ = type_46(0u, type_46().member_1);
                                        phi_5099_ = true;
                                    } else {
                                        phi_5098_ = _e8465;
                                        phi_5099_ = _e8500;
                                    }
                                    let _e8504 = phi_5098_;
                                    let _e8506 = phi_5099_;
                                    if _e8506 {
                                        phi_5103_ = _e8504;
                                    } else {
                                        phi_5103_ = _e8496;
                                    }
                                    let _e8508 = phi_5103_;
                                    phi_5110_ = _e8508.member_1;
                                    phi_5111_ = (_e8508.member != 0u);
                                } else {
                                    phi_5110_ = _e6663;
                                    phi_5111_ = true;
                                }
                                let _e8513 = phi_5110_;
                                let _e8515 = phi_5111_;
                                if _e8515 {
                                    let _e8516 = (_e8513 > _e430);
                                    if _e8516 {
                                        phi_7318_ = f64();
                                        phi_7319_ = u32();
                                        phi_7320_ = f64();
                                        phi_7321_ = type_48();
                                        phi_7322_ = u32();
                                        phi_7323_ = u32();
                                        phi_7324_ = false;
                                        phi_7325_ = false;
                                        phi_7326_ = false;
                                    } else {
                                        let _e8520 = local_18.member[0u];
                                        let _e8526 = local_18.member[1u];
                                        let _e8542 = local_18.member_1[0u];
                                        let _e8548 = local_18.member_1[1u];
                                        let _e8564 = local_18.member_2[0u];
                                        let _e8570 = local_18.member_2[1u];
                                        let _e8584 = function_4(array<f64, 3>((_e8520[0] + ((_e8526[0] - _e8520[0]) * _e6667)), (_e8520[1] + ((_e8526[1] - _e8520[1]) * _e6667)), (_e8520[2] + ((_e8526[2] - _e8520[2]) * _e6667))), array<f64, 3>((_e8542[0] + ((_e8548[0] - _e8542[0]) * _e6667)), (_e8542[1] + ((_e8548[1] - _e8542[1]) * _e6667)), (_e8542[2] + ((_e8548[2] - _e8542[2]) * _e6667))), array<f64, 3>((_e8564[0] + ((_e8570[0] - _e8564[0]) * _e6667)), (_e8564[1] + ((_e8570[1] - _e8564[1]) * _e6667)), (_e8564[2] + ((_e8570[2] - _e8564[2]) * _e6667))), 1u);
                                        if (_e8584[0] < 0.0lf) {
                                            phi_5224_ = -(_e8584[0]);
                                        } else {
                                            phi_5224_ = _e8584[0];
                                        }
                                        let _e8589 = phi_5224_;
                                        if (_e8584[1] < 0.0lf) {
                                            phi_5231_ = -(_e8584[1]);
                                        } else {
                                            phi_5231_ = _e8584[1];
                                        }
                                        let _e8594 = phi_5231_;
                                        if (_e8584[2] < 0.0lf) {
                                            phi_5239_ = -(_e8584[2]);
                                        } else {
                                            phi_5239_ = _e8584[2];
                                        }
                                        let _e8600 = phi_5239_;
                                        let _e8601 = ((_e8589 + _e8594) + _e8600);
                                        let _e8604 = local_18.member[0u];
                                        let _e8610 = local_18.member_1[0u];
                                        let _e8616 = local_18.member_2[0u];
                                        let _e8620 = (_e8604[0] - _e8610[0]);
                                        let _e8621 = (_e8604[1] - _e8610[1]);
                                        let _e8622 = (_e8604[2] - _e8610[2]);
                                        let _e8631 = local_18.member[1u];
                                        let _e8637 = local_18.member_1[1u];
                                        let _e8643 = local_18.member_2[1u];
                                        let _e8647 = (_e8631[0] - _e8637[0]);
                                        let _e8648 = (_e8631[1] - _e8637[1]);
                                        let _e8649 = (_e8631[2] - _e8637[2]);
                                        let _e8658 = local_18.member[0u];
                                        if (_e8658[0] < 0.0lf) {
                                            phi_5390_ = -(_e8658[0]);
                                        } else {
                                            phi_5390_ = _e8658[0];
                                        }
                                        let _e8665 = phi_5390_;
                                        if (_e8658[1] < 0.0lf) {
                                            phi_5397_ = -(_e8658[1]);
                                        } else {
                                            phi_5397_ = _e8658[1];
                                        }
                                        let _e8669 = phi_5397_;
                                        if (_e8665 > _e8669) {
                                            phi_5402_ = _e8665;
                                        } else {
                                            phi_5402_ = _e8669;
                                        }
                                        let _e8672 = phi_5402_;
                                        if (_e8658[2] < 0.0lf) {
                                            phi_5409_ = -(_e8658[2]);
                                        } else {
                                            phi_5409_ = _e8658[2];
                                        }
                                        let _e8676 = phi_5409_;
                                        if (_e8672 > _e8676) {
                                            phi_5414_ = _e8672;
                                        } else {
                                            phi_5414_ = _e8676;
                                        }
                                        let _e8679 = phi_5414_;
                                        let _e8682 = local_18.member[1u];
                                        if (_e8682[0] < 0.0lf) {
                                            phi_5427_ = -(_e8682[0]);
                                        } else {
                                            phi_5427_ = _e8682[0];
                                        }
                                        let _e8689 = phi_5427_;
                                        if (_e8682[1] < 0.0lf) {
                                            phi_5434_ = -(_e8682[1]);
                                        } else {
                                            phi_5434_ = _e8682[1];
                                        }
                                        let _e8693 = phi_5434_;
                                        if (_e8689 > _e8693) {
                                            phi_5439_ = _e8689;
                                        } else {
                                            phi_5439_ = _e8693;
                                        }
                                        let _e8696 = phi_5439_;
                                        if (_e8682[2] < 0.0lf) {
                                            phi_5446_ = -(_e8682[2]);
                                        } else {
                                            phi_5446_ = _e8682[2];
                                        }
                                        let _e8700 = phi_5446_;
                                        if (_e8696 > _e8700) {
                                            phi_5451_ = _e8696;
                                        } else {
                                            phi_5451_ = _e8700;
                                        }
                                        let _e8703 = phi_5451_;
                                        if (_e8679 > _e8703) {
                                            phi_5456_ = _e8679;
                                        } else {
                                            phi_5456_ = _e8703;
                                        }
                                        let _e8706 = phi_5456_;
                                        let _e8708 = local_18.member_3;
                                        let _e8712 = local_18.member_1[0u];
                                        if (_e8712[0] < 0.0lf) {
                                            phi_5473_ = -(_e8712[0]);
                                        } else {
                                            phi_5473_ = _e8712[0];
                                        }
                                        let _e8719 = phi_5473_;
                                        if (_e8712[1] < 0.0lf) {
                                            phi_5480_ = -(_e8712[1]);
                                        } else {
                                            phi_5480_ = _e8712[1];
                                        }
                                        let _e8723 = phi_5480_;
                                        if (_e8719 > _e8723) {
                                            phi_5485_ = _e8719;
                                        } else {
                                            phi_5485_ = _e8723;
                                        }
                                        let _e8726 = phi_5485_;
                                        if (_e8712[2] < 0.0lf) {
                                            phi_5492_ = -(_e8712[2]);
                                        } else {
                                            phi_5492_ = _e8712[2];
                                        }
                                        let _e8730 = phi_5492_;
                                        if (_e8726 > _e8730) {
                                            phi_5497_ = _e8726;
                                        } else {
                                            phi_5497_ = _e8730;
                                        }
                                        let _e8733 = phi_5497_;
                                        let _e8736 = local_18.member_1[1u];
                                        if (_e8736[0] < 0.0lf) {
                                            phi_5511_ = -(_e8736[0]);
                                        } else {
                                            phi_5511_ = _e8736[0];
                                        }
                                        let _e8743 = phi_5511_;
                                        if (_e8736[1] < 0.0lf) {
                                            phi_5518_ = -(_e8736[1]);
                                        } else {
                                            phi_5518_ = _e8736[1];
                                        }
                                        let _e8747 = phi_5518_;
                                        if (_e8743 > _e8747) {
                                            phi_5523_ = _e8743;
                                        } else {
                                            phi_5523_ = _e8747;
                                        }
                                        let _e8750 = phi_5523_;
                                        if (_e8736[2] < 0.0lf) {
                                            phi_5530_ = -(_e8736[2]);
                                        } else {
                                            phi_5530_ = _e8736[2];
                                        }
                                        let _e8754 = phi_5530_;
                                        if (_e8750 > _e8754) {
                                            phi_5535_ = _e8750;
                                        } else {
                                            phi_5535_ = _e8754;
                                        }
                                        let _e8757 = phi_5535_;
                                        if (_e8733 > _e8757) {
                                            phi_5540_ = _e8733;
                                        } else {
                                            phi_5540_ = _e8757;
                                        }
                                        let _e8760 = phi_5540_;
                                        let _e8762 = local_18.member_3;
                                        let _e8766 = local_18.member_2[0u];
                                        if (_e8766[0] < 0.0lf) {
                                            phi_5557_ = -(_e8766[0]);
                                        } else {
                                            phi_5557_ = _e8766[0];
                                        }
                                        let _e8773 = phi_5557_;
                                        if (_e8766[1] < 0.0lf) {
                                            phi_5564_ = -(_e8766[1]);
                                        } else {
                                            phi_5564_ = _e8766[1];
                                        }
                                        let _e8777 = phi_5564_;
                                        if (_e8773 > _e8777) {
                                            phi_5569_ = _e8773;
                                        } else {
                                            phi_5569_ = _e8777;
                                        }
                                        let _e8780 = phi_5569_;
                                        if (_e8766[2] < 0.0lf) {
                                            phi_5576_ = -(_e8766[2]);
                                        } else {
                                            phi_5576_ = _e8766[2];
                                        }
                                        let _e8784 = phi_5576_;
                                        if (_e8780 > _e8784) {
                                            phi_5581_ = _e8780;
                                        } else {
                                            phi_5581_ = _e8784;
                                        }
                                        let _e8787 = phi_5581_;
                                        let _e8790 = local_18.member_2[1u];
                                        if (_e8790[0] < 0.0lf) {
                                            phi_5595_ = -(_e8790[0]);
                                        } else {
                                            phi_5595_ = _e8790[0];
                                        }
                                        let _e8797 = phi_5595_;
                                        if (_e8790[1] < 0.0lf) {
                                            phi_5602_ = -(_e8790[1]);
                                        } else {
                                            phi_5602_ = _e8790[1];
                                        }
                                        let _e8801 = phi_5602_;
                                        if (_e8797 > _e8801) {
                                            phi_5607_ = _e8797;
                                        } else {
                                            phi_5607_ = _e8801;
                                        }
                                        let _e8804 = phi_5607_;
                                        if (_e8790[2] < 0.0lf) {
                                            phi_5614_ = -(_e8790[2]);
                                        } else {
                                            phi_5614_ = _e8790[2];
                                        }
                                        let _e8808 = phi_5614_;
                                        if (_e8804 > _e8808) {
                                            phi_5619_ = _e8804;
                                        } else {
                                            phi_5619_ = _e8808;
                                        }
                                        let _e8811 = phi_5619_;
                                        if (_e8787 > _e8811) {
                                            phi_5624_ = _e8787;
                                        } else {
                                            phi_5624_ = _e8811;
                                        }
                                        let _e8814 = phi_5624_;
                                        let _e8816 = local_18.member_3;
                                        let _e8824 = local_18.member_3;
                                        local_14 = type_44(array<array<array<f64, 3>, 4>, 2>(array<array<f64, 3>, 4>(_e8604, array<f64, 3>(_e8620, _e8621, _e8622), array<f64, 3>((_e8604[0] - _e8616[0]), (_e8604[1] - _e8616[1]), (_e8604[2] - _e8616[2])), array<f64, 3>((_e8620 - _e8616[0]), (_e8621 - _e8616[1]), (_e8622 - _e8616[2]))), array<array<f64, 3>, 4>(_e8631, array<f64, 3>(_e8647, _e8648, _e8649), array<f64, 3>((_e8631[0] - _e8643[0]), (_e8631[1] - _e8643[1]), (_e8631[2] - _e8643[2])), array<f64, 3>((_e8647 - _e8643[0]), (_e8648 - _e8643[1]), (_e8649 - _e8643[2])))), ((((((_e8706 + _e8708) + (_e8760 + _e8762)) + (_e8814 + _e8816)) * (1.1102230246251565e-16lf * f64(16f))) + (_e8824 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))), _e643.member_1);
                                        let _e8842 = local_14.member_1;
                                        if (_e8601 > _e8842) {
                                            if ((bitcast<u64>(_e8601) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e8848 = (f64(1f) / _e8601);
                                                let _e8850 = (_e8584[0] * _e8848);
                                                let _e8852 = (_e8584[1] * _e8848);
                                                let _e8854 = (_e8584[2] * _e8848);
                                                let _e8859 = (((_e8850 * _e8850) + (_e8852 * _e8852)) + (_e8854 * _e8854));
                                                if (_e8859 <= 2.2250738585072014e-308lf) {
                                                    if (_e8859 > 0.0lf) {
                                                        phi_5729_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_5729_ = 0.0lf;
                                                    }
                                                    let _e8911 = phi_5729_;
                                                    phi_5793_ = _e8911;
                                                } else {
                                                    phi_5736_ = type_16(0i, 5i);
                                                    phi_5739_ = bitcast<f64>(((bitcast<u64>(_e8859) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e8866 = phi_5736_;
                                                        let _e8868 = phi_5739_;
                                                        local_45 = _e8868;
                                                        if (_e8866.member < _e8866.member_1) {
                                                            let _e8875 = (_e8866.member + 1i);
                                                            if ((false == (_e8875 > _e8866.member)) != false) {
                                                                phi_5760_ = true;
                                                            } else {
                                                                phi_5760_ = false;
                                                            }
                                                            let _e8880 = phi_5760_;
                                                            if _e8880 {
                                                                phi_5766_ = type_17(0u, type_17().member_1);
                                                            } else {
                                                                phi_5766_ = type_17(1u, _e8875);
                                                            }
                                                            let _e8885 = phi_5766_;
                                                            phi_5737_ = type_16(_e8885.member_1, _e8866.member_1);
                                                            phi_5780_ = type_17(1u, _e8866.member);
                                                        } else {
                                                            phi_5737_ = _e8866;
                                                            phi_5780_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e8891 = phi_5737_;
                                                        let _e8893 = phi_5780_;
                                                        let _e8896 = (bitcast<i32>(_e8893.member) != 0i);
                                                        if _e8896 {
                                                            phi_5740_ = (0.5lf * (_e8868 + (_e8859 / _e8868)));
                                                        } else {
                                                            phi_5740_ = f64();
                                                        }
                                                        let _e8901 = phi_5740_;
                                                        continue;
                                                        continuing {
                                                            phi_5736_ = _e8891;
                                                            phi_5739_ = _e8901;
                                                            break if !(_e8896);
                                                        }
                                                    }
                                                    let _e8906 = local_45;
                                                    phi_5793_ = (_e8906 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e8913 = phi_5793_;
                                                let _e8915 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e8917 = local_14.member_1;
                                                let _e8921 = local_14.member_2;
                                                let _e8926 = ((_e8917 * f64(1.01f)) + ((_e8921 * _e8913) * (f64(1f) + _e8915)));
                                                let _e8930 = local_14.member[0u][0u];
                                                let _e8938 = (((_e8850 * _e8930[0]) + (_e8852 * _e8930[1])) + (_e8854 * _e8930[2]));
                                                let _e8942 = local_14.member[0u][1u];
                                                let _e8950 = (((_e8850 * _e8942[0]) + (_e8852 * _e8942[1])) + (_e8854 * _e8942[2]));
                                                let _e8954 = local_14.member[0u][2u];
                                                let _e8962 = (((_e8850 * _e8954[0]) + (_e8852 * _e8954[1])) + (_e8854 * _e8954[2]));
                                                let _e8966 = local_14.member[0u][3u];
                                                let _e8974 = (((_e8850 * _e8966[0]) + (_e8852 * _e8966[1])) + (_e8854 * _e8966[2]));
                                                let _e8978 = local_14.member[1u][0u];
                                                let _e8986 = (((_e8850 * _e8978[0]) + (_e8852 * _e8978[1])) + (_e8854 * _e8978[2]));
                                                let _e8990 = local_14.member[1u][1u];
                                                let _e8998 = (((_e8850 * _e8990[0]) + (_e8852 * _e8990[1])) + (_e8854 * _e8990[2]));
                                                let _e9002 = local_14.member[1u][2u];
                                                let _e9010 = (((_e8850 * _e9002[0]) + (_e8852 * _e9002[1])) + (_e8854 * _e9002[2]));
                                                let _e9014 = local_14.member[1u][3u];
                                                let _e9022 = (((_e8850 * _e9014[0]) + (_e8852 * _e9014[1])) + (_e8854 * _e9014[2]));
                                                if (_e8938 < 0.0lf) {
                                                    phi_5930_ = -(_e8938);
                                                } else {
                                                    phi_5930_ = _e8938;
                                                }
                                                let _e9026 = phi_5930_;
                                                if (_e8986 < 0.0lf) {
                                                    phi_5936_ = -(_e8986);
                                                } else {
                                                    phi_5936_ = _e8986;
                                                }
                                                let _e9030 = phi_5936_;
                                                if (_e8950 < 0.0lf) {
                                                    phi_5945_ = -(_e8950);
                                                } else {
                                                    phi_5945_ = _e8950;
                                                }
                                                let _e9037 = phi_5945_;
                                                if (_e8998 < 0.0lf) {
                                                    phi_5951_ = -(_e8998);
                                                } else {
                                                    phi_5951_ = _e8998;
                                                }
                                                let _e9041 = phi_5951_;
                                                if (_e8962 < 0.0lf) {
                                                    phi_5960_ = -(_e8962);
                                                } else {
                                                    phi_5960_ = _e8962;
                                                }
                                                let _e9048 = phi_5960_;
                                                if (_e9010 < 0.0lf) {
                                                    phi_5966_ = -(_e9010);
                                                } else {
                                                    phi_5966_ = _e9010;
                                                }
                                                let _e9052 = phi_5966_;
                                                if (_e8974 < 0.0lf) {
                                                    phi_5975_ = -(_e8974);
                                                } else {
                                                    phi_5975_ = _e8974;
                                                }
                                                let _e9059 = phi_5975_;
                                                if (_e9022 < 0.0lf) {
                                                    phi_5981_ = -(_e9022);
                                                } else {
                                                    phi_5981_ = _e9022;
                                                }
                                                let _e9063 = phi_5981_;
                                                local_15 = type_38(array<f64, 4>(_e8938, _e8950, _e8962, _e8974), array<f64, 4>(_e8986, _e8998, _e9010, _e9022), array<f64, 4>((_e8926 + ((_e9026 + _e9030) * _e8915)), (_e8926 + ((_e9037 + _e9041) * _e8915)), (_e8926 + ((_e9048 + _e9052) * _e8915)), (_e8926 + ((_e9059 + _e9063) * _e8915))));
                                                let _e9075 = (((_e8850 * _e8850) + (_e8852 * _e8852)) + (_e8854 * _e8854));
                                                if (_e9075 <= 2.2250738585072014e-308lf) {
                                                    if (_e9075 > 0.0lf) {
                                                        phi_6024_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_6024_ = 0.0lf;
                                                    }
                                                    let _e9127 = phi_6024_;
                                                    phi_6088_ = _e9127;
                                                } else {
                                                    phi_6031_ = type_16(0i, 5i);
                                                    phi_6034_ = bitcast<f64>(((bitcast<u64>(_e9075) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e9082 = phi_6031_;
                                                        let _e9084 = phi_6034_;
                                                        local_46 = _e9084;
                                                        if (_e9082.member < _e9082.member_1) {
                                                            let _e9091 = (_e9082.member + 1i);
                                                            if ((false == (_e9091 > _e9082.member)) != false) {
                                                                phi_6055_ = true;
                                                            } else {
                                                                phi_6055_ = false;
                                                            }
                                                            let _e9096 = phi_6055_;
                                                            if _e9096 {
                                                                phi_6061_ = type_17(0u, type_17().member_1);
                                                            } else {
                                                                phi_6061_ = type_17(1u, _e9091);
                                                            }
                                                            let _e9101 = phi_6061_;
                                                            phi_6032_ = type_16(_e9101.member_1, _e9082.member_1);
                                                            phi_6075_ = type_17(1u, _e9082.member);
                                                        } else {
                                                            phi_6032_ = _e9082;
                                                            phi_6075_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e9107 = phi_6032_;
                                                        let _e9109 = phi_6075_;
                                                        let _e9112 = (bitcast<i32>(_e9109.member) != 0i);
                                                        if _e9112 {
                                                            phi_6035_ = (0.5lf * (_e9084 + (_e9075 / _e9084)));
                                                        } else {
                                                            phi_6035_ = f64();
                                                        }
                                                        let _e9117 = phi_6035_;
                                                        continue;
                                                        continuing {
                                                            phi_6031_ = _e9107;
                                                            phi_6034_ = _e9117;
                                                            break if !(_e9112);
                                                        }
                                                    }
                                                    let _e9122 = local_46;
                                                    phi_6088_ = (_e9122 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e9129 = phi_6088_;
                                                let _e9140 = (((_e8584[0] * _e8584[0]) + (_e8584[1] * _e8584[1])) + (_e8584[2] * _e8584[2]));
                                                if (_e9140 <= 2.2250738585072014e-308lf) {
                                                    if (_e9140 > 0.0lf) {
                                                        phi_6113_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_6113_ = 0.0lf;
                                                    }
                                                    let _e9192 = phi_6113_;
                                                    phi_6177_ = _e9192;
                                                } else {
                                                    phi_6120_ = type_16(0i, 5i);
                                                    phi_6123_ = bitcast<f64>(((bitcast<u64>(_e9140) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e9147 = phi_6120_;
                                                        let _e9149 = phi_6123_;
                                                        local_47 = _e9149;
                                                        if (_e9147.member < _e9147.member_1) {
                                                            let _e9156 = (_e9147.member + 1i);
                                                            if ((false == (_e9156 > _e9147.member)) != false) {
                                                                phi_6144_ = true;
                                                            } else {
                                                                phi_6144_ = false;
                                                            }
                                                            let _e9161 = phi_6144_;
                                                            if _e9161 {
                                                                phi_6150_ = type_17(0u, type_17().member_1);
                                                            } else {
                                                                phi_6150_ = type_17(1u, _e9156);
                                                            }
                                                            let _e9166 = phi_6150_;
                                                            phi_6121_ = type_16(_e9166.member_1, _e9147.member_1);
                                                            phi_6164_ = type_17(1u, _e9147.member);
                                                        } else {
                                                            phi_6121_ = _e9147;
                                                            phi_6164_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e9172 = phi_6121_;
                                                        let _e9174 = phi_6164_;
                                                        let _e9177 = (bitcast<i32>(_e9174.member) != 0i);
                                                        if _e9177 {
                                                            phi_6124_ = (0.5lf * (_e9149 + (_e9140 / _e9149)));
                                                        } else {
                                                            phi_6124_ = f64();
                                                        }
                                                        let _e9182 = phi_6124_;
                                                        continue;
                                                        continuing {
                                                            phi_6120_ = _e9172;
                                                            phi_6123_ = _e9182;
                                                            break if !(_e9177);
                                                        }
                                                    }
                                                    let _e9187 = local_47;
                                                    phi_6177_ = (_e9187 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e9194 = phi_6177_;
                                                let _e9202 = local_18.member[0u];
                                                if (_e9202[0] < 0.0lf) {
                                                    phi_6195_ = -(_e9202[0]);
                                                } else {
                                                    phi_6195_ = _e9202[0];
                                                }
                                                let _e9209 = phi_6195_;
                                                if (_e9202[1] < 0.0lf) {
                                                    phi_6202_ = -(_e9202[1]);
                                                } else {
                                                    phi_6202_ = _e9202[1];
                                                }
                                                let _e9213 = phi_6202_;
                                                if (_e9209 > _e9213) {
                                                    phi_6207_ = _e9209;
                                                } else {
                                                    phi_6207_ = _e9213;
                                                }
                                                let _e9216 = phi_6207_;
                                                if (_e9202[2] < 0.0lf) {
                                                    phi_6214_ = -(_e9202[2]);
                                                } else {
                                                    phi_6214_ = _e9202[2];
                                                }
                                                let _e9220 = phi_6214_;
                                                if (_e9216 > _e9220) {
                                                    phi_6219_ = _e9216;
                                                } else {
                                                    phi_6219_ = _e9220;
                                                }
                                                let _e9223 = phi_6219_;
                                                let _e9226 = local_18.member[1u];
                                                if (_e9226[0] < 0.0lf) {
                                                    phi_6232_ = -(_e9226[0]);
                                                } else {
                                                    phi_6232_ = _e9226[0];
                                                }
                                                let _e9233 = phi_6232_;
                                                if (_e9226[1] < 0.0lf) {
                                                    phi_6239_ = -(_e9226[1]);
                                                } else {
                                                    phi_6239_ = _e9226[1];
                                                }
                                                let _e9237 = phi_6239_;
                                                if (_e9233 > _e9237) {
                                                    phi_6244_ = _e9233;
                                                } else {
                                                    phi_6244_ = _e9237;
                                                }
                                                let _e9240 = phi_6244_;
                                                if (_e9226[2] < 0.0lf) {
                                                    phi_6251_ = -(_e9226[2]);
                                                } else {
                                                    phi_6251_ = _e9226[2];
                                                }
                                                let _e9244 = phi_6251_;
                                                if (_e9240 > _e9244) {
                                                    phi_6256_ = _e9240;
                                                } else {
                                                    phi_6256_ = _e9244;
                                                }
                                                let _e9247 = phi_6256_;
                                                if (_e9223 > _e9247) {
                                                    phi_6261_ = _e9223;
                                                } else {
                                                    phi_6261_ = _e9247;
                                                }
                                                let _e9250 = phi_6261_;
                                                let _e9252 = local_18.member_3;
                                                let _e9256 = local_18.member_1[0u];
                                                if (_e9256[0] < 0.0lf) {
                                                    phi_6278_ = -(_e9256[0]);
                                                } else {
                                                    phi_6278_ = _e9256[0];
                                                }
                                                let _e9263 = phi_6278_;
                                                if (_e9256[1] < 0.0lf) {
                                                    phi_6285_ = -(_e9256[1]);
                                                } else {
                                                    phi_6285_ = _e9256[1];
                                                }
                                                let _e9267 = phi_6285_;
                                                if (_e9263 > _e9267) {
                                                    phi_6290_ = _e9263;
                                                } else {
                                                    phi_6290_ = _e9267;
                                                }
                                                let _e9270 = phi_6290_;
                                                if (_e9256[2] < 0.0lf) {
                                                    phi_6297_ = -(_e9256[2]);
                                                } else {
                                                    phi_6297_ = _e9256[2];
                                                }
                                                let _e9274 = phi_6297_;
                                                if (_e9270 > _e9274) {
                                                    phi_6302_ = _e9270;
                                                } else {
                                                    phi_6302_ = _e9274;
                                                }
                                                let _e9277 = phi_6302_;
                                                let _e9280 = local_18.member_1[1u];
                                                if (_e9280[0] < 0.0lf) {
                                                    phi_6316_ = -(_e9280[0]);
                                                } else {
                                                    phi_6316_ = _e9280[0];
                                                }
                                                let _e9287 = phi_6316_;
                                                if (_e9280[1] < 0.0lf) {
                                                    phi_6323_ = -(_e9280[1]);
                                                } else {
                                                    phi_6323_ = _e9280[1];
                                                }
                                                let _e9291 = phi_6323_;
                                                if (_e9287 > _e9291) {
                                                    phi_6328_ = _e9287;
                                                } else {
                                                    phi_6328_ = _e9291;
                                                }
                                                let _e9294 = phi_6328_;
                                                if (_e9280[2] < 0.0lf) {
                                                    phi_6335_ = -(_e9280[2]);
                                                } else {
                                                    phi_6335_ = _e9280[2];
                                                }
                                                let _e9298 = phi_6335_;
                                                if (_e9294 > _e9298) {
                                                    phi_6340_ = _e9294;
                                                } else {
                                                    phi_6340_ = _e9298;
                                                }
                                                let _e9301 = phi_6340_;
                                                if (_e9277 > _e9301) {
                                                    phi_6345_ = _e9277;
                                                } else {
                                                    phi_6345_ = _e9301;
                                                }
                                                let _e9304 = phi_6345_;
                                                let _e9306 = local_18.member_3;
                                                let _e9310 = local_18.member_2[0u];
                                                if (_e9310[0] < 0.0lf) {
                                                    phi_6362_ = -(_e9310[0]);
                                                } else {
                                                    phi_6362_ = _e9310[0];
                                                }
                                                let _e9317 = phi_6362_;
                                                if (_e9310[1] < 0.0lf) {
                                                    phi_6369_ = -(_e9310[1]);
                                                } else {
                                                    phi_6369_ = _e9310[1];
                                                }
                                                let _e9321 = phi_6369_;
                                                if (_e9317 > _e9321) {
                                                    phi_6374_ = _e9317;
                                                } else {
                                                    phi_6374_ = _e9321;
                                                }
                                                let _e9324 = phi_6374_;
                                                if (_e9310[2] < 0.0lf) {
                                                    phi_6381_ = -(_e9310[2]);
                                                } else {
                                                    phi_6381_ = _e9310[2];
                                                }
                                                let _e9328 = phi_6381_;
                                                if (_e9324 > _e9328) {
                                                    phi_6386_ = _e9324;
                                                } else {
                                                    phi_6386_ = _e9328;
                                                }
                                                let _e9331 = phi_6386_;
                                                let _e9334 = local_18.member_2[1u];
                                                if (_e9334[0] < 0.0lf) {
                                                    phi_6400_ = -(_e9334[0]);
                                                } else {
                                                    phi_6400_ = _e9334[0];
                                                }
                                                let _e9341 = phi_6400_;
                                                if (_e9334[1] < 0.0lf) {
                                                    phi_6407_ = -(_e9334[1]);
                                                } else {
                                                    phi_6407_ = _e9334[1];
                                                }
                                                let _e9345 = phi_6407_;
                                                if (_e9341 > _e9345) {
                                                    phi_6412_ = _e9341;
                                                } else {
                                                    phi_6412_ = _e9345;
                                                }
                                                let _e9348 = phi_6412_;
                                                if (_e9334[2] < 0.0lf) {
                                                    phi_6419_ = -(_e9334[2]);
                                                } else {
                                                    phi_6419_ = _e9334[2];
                                                }
                                                let _e9352 = phi_6419_;
                                                if (_e9348 > _e9352) {
                                                    phi_6424_ = _e9348;
                                                } else {
                                                    phi_6424_ = _e9352;
                                                }
                                                let _e9355 = phi_6424_;
                                                if (_e9331 > _e9355) {
                                                    phi_6429_ = _e9331;
                                                } else {
                                                    phi_6429_ = _e9355;
                                                }
                                                let _e9358 = phi_6429_;
                                                let _e9360 = local_18.member_3;
                                                let _e9368 = local_18.member_3;
                                                let _e9383 = ((((_e9194 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e9250 + _e9252) + (_e9304 + _e9306)) + (_e9358 + _e9360)) * (1.1102230246251565e-16lf * f64(16f))) + (_e9368 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) * _e9129) * (f64(1f) + (1.1102230246251565e-16lf * f64(64f))));
                                                let _e9386 = local_15.member[0u];
                                                let _e9389 = local_15.member_1[0u];
                                                if (_e9386 < 0.0lf) {
                                                    phi_6477_ = -(_e9386);
                                                } else {
                                                    phi_6477_ = _e9386;
                                                }
                                                let _e9395 = phi_6477_;
                                                if (_e9389 < 0.0lf) {
                                                    phi_6483_ = -(_e9389);
                                                } else {
                                                    phi_6483_ = _e9389;
                                                }
                                                let _e9399 = phi_6483_;
                                                phi_6495_ = type_12(1u, 4u);
                                                phi_6498_ = ((_e9386 + ((_e9389 - _e9386) * _e6667)) - ((_e8842 * f64(1.01f)) + ((_e9395 + _e9399) * (1.1102230246251565e-16lf * f64(12f)))));
                                                loop {
                                                    let _e9410 = phi_6495_;
                                                    let _e9412 = phi_6498_;
                                                    local_48 = _e9412;
                                                    local_49 = _e9412;
                                                    if (_e9410.member < _e9410.member_1) {
                                                        phi_6496_ = type_12((_e9410.member + 1u), _e9410.member_1);
                                                        phi_6521_ = type_12(1u, _e9410.member);
                                                    } else {
                                                        phi_6496_ = _e9410;
                                                        phi_6521_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e9424 = phi_6496_;
                                                    let _e9426 = phi_6521_;
                                                    let _e9430 = (bitcast<i32>(_e9426.member) != 0i);
                                                    if _e9430 {
                                                        let _e9433 = local_15.member[_e9426.member_1];
                                                        let _e9436 = local_15.member_1[_e9426.member_1];
                                                        if (_e9433 < 0.0lf) {
                                                            phi_6551_ = -(_e9433);
                                                        } else {
                                                            phi_6551_ = _e9433;
                                                        }
                                                        let _e9442 = phi_6551_;
                                                        if (_e9436 < 0.0lf) {
                                                            phi_6557_ = -(_e9436);
                                                        } else {
                                                            phi_6557_ = _e9436;
                                                        }
                                                        let _e9446 = phi_6557_;
                                                        let _e9455 = ((_e9433 + ((_e9436 - _e9433) * _e6667)) - ((_e8842 * f64(1.01f)) + ((_e9442 + _e9446) * (1.1102230246251565e-16lf * f64(12f)))));
                                                        if (_e9412 < _e9455) {
                                                            phi_6571_ = _e9412;
                                                        } else {
                                                            phi_6571_ = _e9455;
                                                        }
                                                        let _e9458 = phi_6571_;
                                                        phi_6499_ = _e9458;
                                                    } else {
                                                        phi_6499_ = f64();
                                                    }
                                                    let _e9460 = phi_6499_;
                                                    continue;
                                                    continuing {
                                                        phi_6495_ = _e9424;
                                                        phi_6498_ = _e9460;
                                                        break if !(_e9430);
                                                    }
                                                }
                                                let _e9463 = local_48;
                                                if (_e9463 > f64(0f)) {
                                                    let _e9468 = local_49;
                                                    let _e9472 = (((_e9383 - _e9468) / _e9383) * f64(2.02f));
                                                    if (_e9472 <= 2.2250738585072014e-308lf) {
                                                        if (_e9472 > 0.0lf) {
                                                            phi_6593_ = (1.464336215552873e-154lf * 2.0lf);
                                                        } else {
                                                            phi_6593_ = 0.0lf;
                                                        }
                                                        let _e9524 = phi_6593_;
                                                        phi_6657_ = _e9524;
                                                    } else {
                                                        phi_6600_ = type_16(0i, 5i);
                                                        phi_6603_ = bitcast<f64>(((bitcast<u64>(_e9472) / 2lu) + 2303426169912950784lu));
                                                        loop {
                                                            let _e9479 = phi_6600_;
                                                            let _e9481 = phi_6603_;
                                                            local_50 = _e9481;
                                                            if (_e9479.member < _e9479.member_1) {
                                                                let _e9488 = (_e9479.member + 1i);
                                                                if ((false == (_e9488 > _e9479.member)) != false) {
                                                                    phi_6624_ = true;
                                                                } else {
                                                                    phi_6624_ = false;
                                                                }
                                                                let _e9493 = phi_6624_;
                                                                if _e9493 {
                                                                    phi_6630_ = type_17(0u, type_17().member_1);
                                                                } else {
                                                                    phi_6630_ = type_17(1u, _e9488);
                                                                }
                                                                let _e9498 = phi_6630_;
                                                                phi_6601_ = type_16(_e9498.member_1, _e9479.member_1);
                                                                phi_6644_ = type_17(1u, _e9479.member);
                                                            } else {
                                                                phi_6601_ = _e9479;
                                                                phi_6644_ = type_17(0u, type_17().member_1);
                                                            }
                                                            let _e9504 = phi_6601_;
                                                            let _e9506 = phi_6644_;
                                                            let _e9509 = (bitcast<i32>(_e9506.member) != 0i);
                                                            if _e9509 {
                                                                phi_6604_ = (0.5lf * (_e9481 + (_e9472 / _e9481)));
                                                            } else {
                                                                phi_6604_ = f64();
                                                            }
                                                            let _e9514 = phi_6604_;
                                                            continue;
                                                            continuing {
                                                                phi_6600_ = _e9504;
                                                                phi_6603_ = _e9514;
                                                                break if !(_e9509);
                                                            }
                                                        }
                                                        let _e9519 = local_50;
                                                        phi_6657_ = (_e9519 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                    }
                                                    let _e9526 = phi_6657_;
                                                    let _e9529 = ((_e9526 * _e9129) * f64(1.01f));
                                                    phi_6664_ = type_12(0u, 4u);
                                                    phi_6667_ = f64(2f);
                                                    phi_6669_ = true;
                                                    phi_6671_ = true;
                                                    loop {
                                                        let _e9532 = phi_6664_;
                                                        let _e9534 = phi_6667_;
                                                        let _e9536 = phi_6669_;
                                                        let _e9538 = phi_6671_;
                                                        local_51 = _e9534;
                                                        local_90 = _e9534;
                                                        local_52 = _e9536;
                                                        local_53 = _e9538;
                                                        local_91 = _e9538;
                                                        local_54 = _e9538;
                                                        if (_e9532.member < _e9532.member_1) {
                                                            phi_6665_ = type_12((_e9532.member + 1u), _e9532.member_1);
                                                            phi_6694_ = type_12(1u, _e9532.member);
                                                        } else {
                                                            phi_6665_ = _e9532;
                                                            phi_6694_ = type_12(0u, type_12().member_1);
                                                        }
                                                        let _e9550 = phi_6665_;
                                                        let _e9552 = phi_6694_;
                                                        let _e9556 = (bitcast<i32>(_e9552.member) != 0i);
                                                        if _e9556 {
                                                            let _e9560 = local_14.member[0u][_e9552.member_1];
                                                            let _e9567 = local_14.member[1u][_e9552.member_1];
                                                            if (_e9560[0] < 0.0lf) {
                                                                phi_6731_ = -(_e9560[0]);
                                                            } else {
                                                                phi_6731_ = _e9560[0];
                                                            }
                                                            let _e9574 = phi_6731_;
                                                            if (_e9560[1] < 0.0lf) {
                                                                phi_6738_ = -(_e9560[1]);
                                                            } else {
                                                                phi_6738_ = _e9560[1];
                                                            }
                                                            let _e9578 = phi_6738_;
                                                            if (_e9560[2] < 0.0lf) {
                                                                phi_6746_ = -(_e9560[2]);
                                                            } else {
                                                                phi_6746_ = _e9560[2];
                                                            }
                                                            let _e9583 = phi_6746_;
                                                            let _e9584 = ((_e9574 + _e9578) + _e9583);
                                                            if (_e9567[0] < 0.0lf) {
                                                                phi_6754_ = -(_e9567[0]);
                                                            } else {
                                                                phi_6754_ = _e9567[0];
                                                            }
                                                            let _e9588 = phi_6754_;
                                                            if (_e9567[1] < 0.0lf) {
                                                                phi_6761_ = -(_e9567[1]);
                                                            } else {
                                                                phi_6761_ = _e9567[1];
                                                            }
                                                            let _e9592 = phi_6761_;
                                                            if (_e9567[2] < 0.0lf) {
                                                                phi_6769_ = -(_e9567[2]);
                                                            } else {
                                                                phi_6769_ = _e9567[2];
                                                            }
                                                            let _e9597 = phi_6769_;
                                                            let _e9598 = ((_e9588 + _e9592) + _e9597);
                                                            if (_e9584 > _e9598) {
                                                                phi_6775_ = _e9584;
                                                            } else {
                                                                phi_6775_ = _e9598;
                                                            }
                                                            let _e9601 = phi_6775_;
                                                            let _e9607 = (_e9567[0] - _e9560[0]);
                                                            let _e9608 = (_e9567[1] - _e9560[1]);
                                                            let _e9609 = (_e9567[2] - _e9560[2]);
                                                            if (_e9607 < 0.0lf) {
                                                                phi_6795_ = -(_e9607);
                                                            } else {
                                                                phi_6795_ = _e9607;
                                                            }
                                                            let _e9613 = phi_6795_;
                                                            if (_e9608 < 0.0lf) {
                                                                phi_6801_ = -(_e9608);
                                                            } else {
                                                                phi_6801_ = _e9608;
                                                            }
                                                            let _e9617 = phi_6801_;
                                                            if (_e9609 < 0.0lf) {
                                                                phi_6808_ = -(_e9609);
                                                            } else {
                                                                phi_6808_ = _e9609;
                                                            }
                                                            let _e9622 = phi_6808_;
                                                            let _e9631 = local_15.member[_e9552.member_1];
                                                            let _e9634 = local_15.member_1[_e9552.member_1];
                                                            if (_e9631 < 0.0lf) {
                                                                phi_6837_ = -(_e9631);
                                                            } else {
                                                                phi_6837_ = _e9631;
                                                            }
                                                            let _e9640 = phi_6837_;
                                                            if (_e9634 < 0.0lf) {
                                                                phi_6843_ = -(_e9634);
                                                            } else {
                                                                phi_6843_ = _e9634;
                                                            }
                                                            let _e9644 = phi_6843_;
                                                            let _e9649 = ((_e8842 * f64(1.01f)) + ((_e9640 + _e9644) * (1.1102230246251565e-16lf * f64(12f))));
                                                            let _e9656 = local_15.member_1[_e9552.member_1];
                                                            let _e9659 = local_15.member[_e9552.member_1];
                                                            let _e9660 = (_e9656 - _e9659);
                                                            let _e9663 = ((_e9649 + _e9649) + (_e9529 * ((((_e9613 + _e9617) + _e9622) + (_e8842 * f64(6f))) * f64(1.01f))));
                                                            let _e9666 = ((((_e9631 + ((_e9634 - _e9631) * _e6667)) - _e9649) - (_e9529 * ((_e9601 + (_e8842 * f64(3f))) * f64(1.01f)))) - _e9383);
                                                            let _e9667 = (_e9666 > 2.2250738585072014e-308lf);
                                                            let _e9668 = (_e9660 > _e9663);
                                                            if _e9668 {
                                                                phi_6880_ = true;
                                                            } else {
                                                                phi_6880_ = _e9667;
                                                            }
                                                            let _e9670 = phi_6880_;
                                                            if (_e9660 < -(_e9663)) {
                                                                phi_6887_ = true;
                                                            } else {
                                                                phi_6887_ = _e9667;
                                                            }
                                                            let _e9675 = phi_6887_;
                                                            if _e9668 {
                                                                phi_6908_ = _e9534;
                                                            } else {
                                                                if _e9667 {
                                                                    let _e9677 = (_e9663 - _e9660);
                                                                    if (_e9677 > 2.2250738585072014e-308lf) {
                                                                        phi_6900_ = _e9677;
                                                                    } else {
                                                                        phi_6900_ = 2.2250738585072014e-308lf;
                                                                    }
                                                                    let _e9680 = phi_6900_;
                                                                    let _e9681 = (_e9666 / _e9680);
                                                                    if (_e9534 < _e9681) {
                                                                        phi_6906_ = _e9534;
                                                                    } else {
                                                                        phi_6906_ = _e9681;
                                                                    }
                                                                    let _e9684 = phi_6906_;
                                                                    phi_6907_ = _e9684;
                                                                } else {
                                                                    phi_6907_ = _e9534;
                                                                }
                                                                let _e9686 = phi_6907_;
                                                                phi_6908_ = _e9686;
                                                            }
                                                            let _e9688 = phi_6908_;
                                                            phi_6668_ = _e9688;
                                                            phi_6670_ = (_e9536 && _e9675);
                                                            phi_6672_ = (_e9538 && _e9670);
                                                        } else {
                                                            phi_6668_ = f64();
                                                            phi_6670_ = bool();
                                                            phi_6672_ = bool();
                                                        }
                                                        let _e9690 = phi_6668_;
                                                        let _e9692 = phi_6670_;
                                                        let _e9694 = phi_6672_;
                                                        continue;
                                                        continuing {
                                                            phi_6664_ = _e9550;
                                                            phi_6667_ = _e9690;
                                                            phi_6669_ = _e9692;
                                                            phi_6671_ = _e9694;
                                                            break if !(_e9556);
                                                        }
                                                    }
                                                    let _e9696 = f64(2f);
                                                    let _e9698 = local_51;
                                                    if (_e9698 < _e9696) {
                                                        let _e12122 = local_90;
                                                        phi_6914_ = _e12122;
                                                    } else {
                                                        phi_6914_ = _e9696;
                                                    }
                                                    let _e9701 = phi_6914_;
                                                    let _e9703 = (_e9701 * f64(0.999f));
                                                    let _e9705 = local_52;
                                                    if _e9705 {
                                                        let _e9707 = local_53;
                                                        if _e9707 {
                                                            phi_6925_ = type_48();
                                                        } else {
                                                            phi_6925_ = type_48(_e6667, f64(2f), 1u);
                                                        }
                                                        let _e9711 = phi_6925_;
                                                        phi_6926_ = _e9711;
                                                        let _e12129 = local_91;
                                                        phi_6927_ = _e12129;
                                                    } else {
                                                        phi_6926_ = type_48();
                                                        phi_6927_ = true;
                                                    }
                                                    let _e9713 = phi_6926_;
                                                    let _e9715 = phi_6927_;
                                                    if _e9715 {
                                                        let _e9717 = local_54;
                                                        if _e9717 {
                                                            if (_e9703 > (1.1102230246251565e-16lf * f64(4096f))) {
                                                                let _e9723 = (_e6667 + _e9703);
                                                                if (_e9723 < _e439) {
                                                                    phi_6945_ = _e9723;
                                                                } else {
                                                                    phi_6945_ = _e439;
                                                                }
                                                                let _e9726 = phi_6945_;
                                                                phi_6946_ = _e9726;
                                                            } else {
                                                                phi_6946_ = _e6667;
                                                            }
                                                            let _e9728 = phi_6946_;
                                                            phi_6949_ = type_12(0u, 4u);
                                                            phi_6952_ = _e9728;
                                                            phi_6954_ = _e6667;
                                                            loop {
                                                                let _e9730 = phi_6949_;
                                                                let _e9732 = phi_6952_;
                                                                let _e9734 = phi_6954_;
                                                                local_55 = _e9732;
                                                                local_56 = _e9734;
                                                                local_57 = _e9734;
                                                                if (_e9730.member < _e9730.member_1) {
                                                                    phi_6950_ = type_12((_e9730.member + 1u), _e9730.member_1);
                                                                    phi_6977_ = type_12(1u, _e9730.member);
                                                                } else {
                                                                    phi_6950_ = _e9730;
                                                                    phi_6977_ = type_12(0u, type_12().member_1);
                                                                }
                                                                let _e9746 = phi_6950_;
                                                                let _e9748 = phi_6977_;
                                                                let _e9752 = (bitcast<i32>(_e9748.member) != 0i);
                                                                if _e9752 {
                                                                    let _e9755 = local_15.member[_e9748.member_1];
                                                                    let _e9758 = local_15.member_1[_e9748.member_1];
                                                                    let _e9761 = local_15.member[_e9748.member_1];
                                                                    let _e9767 = local_15.member_2[_e9748.member_1];
                                                                    let _e9768 = ((_e9755 + ((_e9758 - _e9761) * _e6667)) - _e9767);
                                                                    let _e9771 = local_15.member_1[_e9748.member_1];
                                                                    let _e9774 = local_15.member[_e9748.member_1];
                                                                    let _e9775 = (_e9771 - _e9774);
                                                                    if (_e9775 > f64(0f)) {
                                                                        let _e9792 = (_e6667 - (_e9768 / _e9775));
                                                                        if (_e9734 > _e9792) {
                                                                            phi_7046_ = _e9734;
                                                                        } else {
                                                                            phi_7046_ = _e9792;
                                                                        }
                                                                        let _e9795 = phi_7046_;
                                                                        phi_7066_ = _e9732;
                                                                        phi_7067_ = _e9795;
                                                                    } else {
                                                                        if (_e9768 > f64(0f)) {
                                                                            if (_e9775 < f64(0f)) {
                                                                                let _e9783 = (_e6667 - (_e9768 / _e9775));
                                                                                if (_e9732 < _e9783) {
                                                                                    phi_7063_ = _e9732;
                                                                                } else {
                                                                                    phi_7063_ = _e9783;
                                                                                }
                                                                                let _e9786 = phi_7063_;
                                                                                phi_7064_ = _e9786;
                                                                            } else {
                                                                                phi_7064_ = _e9732;
                                                                            }
                                                                            let _e9788 = phi_7064_;
                                                                            phi_7065_ = _e9788;
                                                                        } else {
                                                                            phi_7065_ = _e9732;
                                                                        }
                                                                        let _e9790 = phi_7065_;
                                                                        phi_7066_ = _e9790;
                                                                        phi_7067_ = _e9734;
                                                                    }
                                                                    let _e9797 = phi_7066_;
                                                                    let _e9799 = phi_7067_;
                                                                    phi_6953_ = _e9797;
                                                                    phi_6955_ = _e9799;
                                                                } else {
                                                                    phi_6953_ = f64();
                                                                    phi_6955_ = f64();
                                                                }
                                                                let _e9801 = phi_6953_;
                                                                let _e9803 = phi_6955_;
                                                                continue;
                                                                continuing {
                                                                    phi_6949_ = _e9746;
                                                                    phi_6952_ = _e9801;
                                                                    phi_6954_ = _e9803;
                                                                    break if !(_e9752);
                                                                }
                                                            }
                                                            let _e9806 = local_55;
                                                            let _e9808 = local_56;
                                                            let _e9813 = local_57;
                                                            let _e9814 = (_e9813 + ((_e9806 - _e9808) * f64(0.5f)));
                                                            if (_e9814 > _e6667) {
                                                                if (_e9814 <= _e9728) {
                                                                    let _e9817 = f64(0f);
                                                                    let _e9820 = local_15.member[0u];
                                                                    let _e9823 = local_15.member_1[0u];
                                                                    let _e9826 = local_15.member[0u];
                                                                    let _e9832 = local_15.member_2[0u];
                                                                    if (((_e9820 + ((_e9823 - _e9826) * _e9814)) - _e9832) > _e9817) {
                                                                        let _e9837 = local_15.member[1u];
                                                                        let _e9840 = local_15.member_1[1u];
                                                                        let _e9843 = local_15.member[1u];
                                                                        let _e9849 = local_15.member_2[1u];
                                                                        if (((_e9837 + ((_e9840 - _e9843) * _e9814)) - _e9849) > _e9817) {
                                                                            let _e9854 = local_15.member[2u];
                                                                            let _e9857 = local_15.member_1[2u];
                                                                            let _e9860 = local_15.member[2u];
                                                                            let _e9866 = local_15.member_2[2u];
                                                                            if (((_e9854 + ((_e9857 - _e9860) * _e9814)) - _e9866) > _e9817) {
                                                                                let _e9871 = local_15.member[3u];
                                                                                let _e9874 = local_15.member_1[3u];
                                                                                let _e9877 = local_15.member[3u];
                                                                                let _e9883 = local_15.member_2[3u];
                                                                                phi_7230_ = (((_e9871 + ((_e9874 - _e9877) * _e9814)) - _e9883) > _e9817);
                                                                                phi_7231_ = false;
                                                                            } else {
                                                                                phi_7230_ = bool();
                                                                                phi_7231_ = true;
                                                                            }
                                                                            let _e9887 = phi_7230_;
                                                                            let _e9889 = phi_7231_;
                                                                            phi_7232_ = _e9887;
                                                                            phi_7233_ = _e9889;
                                                                        } else {
                                                                            phi_7232_ = bool();
                                                                            phi_7233_ = true;
                                                                        }
                                                                        let _e9891 = phi_7232_;
                                                                        let _e9893 = phi_7233_;
                                                                        phi_7234_ = _e9891;
                                                                        phi_7235_ = _e9893;
                                                                    } else {
                                                                        phi_7234_ = bool();
                                                                        phi_7235_ = true;
                                                                    }
                                                                    let _e9895 = phi_7234_;
                                                                    let _e9897 = phi_7235_;
                                                                    if _e9897 {
                                                                        phi_7239_ = false;
                                                                    } else {
                                                                        phi_7239_ = _e9895;
                                                                    }
                                                                    let _e9899 = phi_7239_;
                                                                    if _e9899 {
                                                                        phi_7243_ = false;
                                                                    } else {
                                                                        phi_7243_ = true;
                                                                    }
                                                                    let _e9901 = phi_7243_;
                                                                    phi_7244_ = _e9901;
                                                                } else {
                                                                    phi_7244_ = true;
                                                                }
                                                                let _e9903 = phi_7244_;
                                                                phi_7245_ = _e9903;
                                                            } else {
                                                                phi_7245_ = true;
                                                            }
                                                            let _e9905 = phi_7245_;
                                                            if _e9905 {
                                                                phi_7250_ = f64(2f);
                                                            } else {
                                                                phi_7250_ = _e9814;
                                                            }
                                                            let _e9908 = phi_7250_;
                                                            phi_7254_ = type_48(_e9728, _e9908, 2u);
                                                            phi_7255_ = type_48();
                                                            phi_7256_ = false;
                                                        } else {
                                                            phi_7254_ = type_48();
                                                            phi_7255_ = type_48(_e6667, f64(2f), 0u);
                                                            phi_7256_ = true;
                                                        }
                                                        let _e9911 = phi_7254_;
                                                        let _e9913 = phi_7255_;
                                                        let _e9915 = phi_7256_;
                                                        phi_7257_ = _e9911;
                                                        phi_7258_ = _e9913;
                                                        phi_7259_ = _e9915;
                                                    } else {
                                                        phi_7257_ = type_48();
                                                        phi_7258_ = _e9713;
                                                        phi_7259_ = true;
                                                    }
                                                    let _e9917 = phi_7257_;
                                                    let _e9919 = phi_7258_;
                                                    let _e9921 = phi_7259_;
                                                    phi_7265_ = _e9919;
                                                    phi_7266_ = _e9917;
                                                    phi_7267_ = _e9921;
                                                } else {
                                                    phi_7265_ = type_48(_e6667, f64(2f), 0u);
                                                    phi_7266_ = type_48();
                                                    phi_7267_ = true;
                                                }
                                                let _e9923 = phi_7265_;
                                                let _e9925 = phi_7266_;
                                                let _e9927 = phi_7267_;
                                                phi_7271_ = _e9923;
                                                phi_7272_ = _e9925;
                                                phi_7273_ = false;
                                                phi_7274_ = _e9927;
                                            } else {
                                                phi_7271_ = type_48();
                                                phi_7272_ = type_48();
                                                phi_7273_ = true;
                                                phi_7274_ = false;
                                            }
                                            let _e9929 = phi_7271_;
                                            let _e9931 = phi_7272_;
                                            let _e9933 = phi_7273_;
                                            let _e9935 = phi_7274_;
                                            phi_7275_ = _e9929;
                                            phi_7276_ = _e9931;
                                            phi_7277_ = _e9933;
                                            phi_7278_ = _e9935;
                                        } else {
                                            phi_7275_ = type_48();
                                            phi_7276_ = type_48();
                                            phi_7277_ = true;
                                            phi_7278_ = false;
                                        }
                                        let _e9937 = phi_7275_;
                                        let _e9939 = phi_7276_;
                                        let _e9941 = phi_7277_;
                                        let _e9943 = phi_7278_;
                                        if _e9941 {
                                            phi_7284_ = type_48(_e6667, f64(2f), 0u);
                                            phi_7285_ = true;
                                        } else {
                                            phi_7284_ = _e9937;
                                            phi_7285_ = _e9943;
                                        }
                                        let _e9947 = phi_7284_;
                                        let _e9949 = phi_7285_;
                                        if _e9949 {
                                            phi_7289_ = _e9947;
                                        } else {
                                            phi_7289_ = _e9939;
                                        }
                                        let _e9951 = phi_7289_;
                                        if ((_e441 & 64u) != 0u) {
                                            if (_e9951.member_2 == 2u) {
                                                let _e9955 = (_e9951.member_1 <= _e439);
                                                if _e9955 {
                                                    phi_7305_ = _e9951.member_1;
                                                    phi_7306_ = _e9951.member_1;
                                                    phi_7307_ = false;
                                                } else {
                                                    phi_7305_ = f64();
                                                    phi_7306_ = f64();
                                                    phi_7307_ = true;
                                                }
                                                let _e9959 = phi_7305_;
                                                let _e9961 = phi_7306_;
                                                let _e9963 = phi_7307_;
                                                phi_7308_ = _e9959;
                                                phi_7309_ = _e9961;
                                                phi_7310_ = _e9955;
                                                phi_7311_ = _e9963;
                                                phi_7312_ = false;
                                            } else {
                                                phi_7308_ = f64();
                                                phi_7309_ = f64();
                                                phi_7310_ = false;
                                                phi_7311_ = false;
                                                phi_7312_ = true;
                                            }
                                            let _e9965 = phi_7308_;
                                            let _e9967 = phi_7309_;
                                            let _e9969 = phi_7310_;
                                            let _e9971 = phi_7311_;
                                            let _e9973 = phi_7312_;
                                            phi_7313_ = _e9965;
                                            phi_7314_ = _e9967;
                                            phi_7315_ = _e9969;
                                            phi_7316_ = _e9971;
                                            phi_7317_ = _e9973;
                                        } else {
                                            phi_7313_ = f64();
                                            phi_7314_ = f64();
                                            phi_7315_ = false;
                                            phi_7316_ = false;
                                            phi_7317_ = true;
                                        }
                                        let _e9975 = phi_7313_;
                                        let _e9977 = phi_7314_;
                                        let _e9979 = phi_7315_;
                                        let _e9981 = phi_7316_;
                                        let _e9983 = phi_7317_;
                                        phi_7318_ = _e9975;
                                        phi_7319_ = _e9951.member_2;
                                        phi_7320_ = _e9977;
                                        phi_7321_ = _e9951;
                                        phi_7322_ = _e9951.member_2;
                                        phi_7323_ = _e9951.member_2;
                                        phi_7324_ = _e9979;
                                        phi_7325_ = _e9981;
                                        phi_7326_ = _e9983;
                                    }
                                    let _e9985 = phi_7318_;
                                    let _e9987 = phi_7319_;
                                    let _e9989 = phi_7320_;
                                    let _e9991 = phi_7321_;
                                    let _e9993 = phi_7322_;
                                    let _e9995 = phi_7323_;
                                    let _e9997 = phi_7324_;
                                    let _e9999 = phi_7325_;
                                    let _e10001 = phi_7326_;
                                    phi_7327_ = _e9985;
                                    phi_7328_ = _e9987;
                                    phi_7329_ = _e9989;
                                    phi_7330_ = _e9991;
                                    phi_7331_ = _e9993;
                                    phi_7332_ = _e9995;
                                    phi_7333_ = _e9997;
                                    phi_7334_ = _e8516;
                                    phi_7335_ = _e9999;
                                    phi_7336_ = _e10001;
                                    phi_7337_ = false;
                                } else {
                                    phi_7327_ = f64();
                                    phi_7328_ = u32();
                                    phi_7329_ = f64();
                                    phi_7330_ = type_48();
                                    phi_7331_ = u32();
                                    phi_7332_ = u32();
                                    phi_7333_ = false;
                                    phi_7334_ = false;
                                    phi_7335_ = false;
                                    phi_7336_ = false;
                                    phi_7337_ = true;
                                }
                                let _e10003 = phi_7327_;
                                let _e10005 = phi_7328_;
                                let _e10007 = phi_7329_;
                                let _e10009 = phi_7330_;
                                let _e10011 = phi_7331_;
                                let _e10013 = phi_7332_;
                                let _e10015 = phi_7333_;
                                let _e10017 = phi_7334_;
                                let _e10019 = phi_7335_;
                                let _e10021 = phi_7336_;
                                let _e10023 = phi_7337_;
                                phi_7338_ = _e8513;
                                phi_2322_ = _e10003;
                                phi_2324_ = _e10005;
                                phi_2326_ = _e10007;
                                phi_7339_ = _e10009;
                                phi_7340_ = _e10011;
                                phi_7341_ = _e8513;
                                phi_7342_ = _e10013;
                                phi_7343_ = _e10015;
                                phi_7344_ = _e10017;
                                phi_7345_ = _e10019;
                                phi_7346_ = _e10021;
                                phi_7347_ = false;
                                phi_7348_ = _e10023;
                            } else {
                                phi_7338_ = f64();
                                phi_2322_ = f64();
                                phi_2324_ = u32();
                                phi_2326_ = f64();
                                phi_7339_ = type_48();
                                phi_7340_ = u32();
                                phi_7341_ = f64();
                                phi_7342_ = u32();
                                phi_7343_ = false;
                                phi_7344_ = false;
                                phi_7345_ = false;
                                phi_7346_ = false;
                                phi_7347_ = true;
                                phi_7348_ = false;
                            }
                            let _e10025 = phi_7338_;
                            let _e10027 = phi_2322_;
                            let _e10029 = phi_2324_;
                            let _e10031 = phi_2326_;
                            let _e10033 = phi_7339_;
                            let _e10035 = phi_7340_;
                            let _e10037 = phi_7341_;
                            let _e10039 = phi_7342_;
                            let _e10041 = phi_7343_;
                            let _e10043 = phi_7344_;
                            let _e10045 = phi_7345_;
                            let _e10047 = phi_7346_;
                            let _e10049 = phi_7347_;
                            let _e10051 = phi_7348_;
                            local_58 = _e10043;
                            local_92 = _e10045;
                            local_93 = _e10047;
                            local_94 = _e10049;
                            local_95 = _e10051;
                            local_59 = _e10033;
                            local_60 = _e10033;
                            local_96 = _e10035;
                            local_61 = _e10033;
                            local_97 = _e10043;
                            local_98 = _e10039;
                            local_100 = _e10037;
                            local_101 = _e10025;
                            continue;
                            continuing {
                                phi_2318_ = _e6690;
                                phi_2321_ = _e10027;
                                phi_2323_ = _e10029;
                                phi_2325_ = _e10031;
                                break if !(_e10041);
                            }
                        }
                        let _e10054 = local_58;
                        if _e10054 {
                            phi_7352_ = false;
                            phi_7353_ = false;
                            phi_7354_ = false;
                            phi_7355_ = false;
                        } else {
                            let _e12230 = local_92;
                            phi_7352_ = _e12230;
                            let _e12233 = local_93;
                            phi_7353_ = _e12233;
                            let _e12236 = local_94;
                            phi_7354_ = _e12236;
                            let _e12239 = local_95;
                            phi_7355_ = _e12239;
                        }
                        let _e10056 = phi_7352_;
                        let _e10058 = phi_7353_;
                        let _e10060 = phi_7354_;
                        let _e10062 = phi_7355_;
                        if _e10056 {
                            let _e10064 = local_59;
                            if (_e10064.member >= _e439) {
                                phi_7377_ = type_47(type_46(0u, f64()), 0u);
                            } else {
                                let _e10068 = local_60;
                                if (_e10068.member > _e430) {
                                    phi_7372_ = 0u;
                                } else {
                                    let _e12244 = local_96;
                                    phi_7372_ = _e12244;
                                }
                                let _e10072 = phi_7372_;
                                let _e10074 = local_61;
                                phi_7377_ = type_47(type_46(2u, _e10074.member), _e10072);
                            }
                            let _e10081 = phi_7377_;
                            phi_7378_ = _e10081;
                            phi_7379_ = false;
                            phi_7380_ = false;
                            phi_7381_ = false;
                            phi_7382_ = false;
                        } else {
                            phi_7378_ = type_47();
                            phi_7379_ = _e10058;
                            let _e12251 = local_97;
                            phi_7380_ = _e12251;
                            phi_7381_ = _e10060;
                            phi_7382_ = _e10062;
                        }
                        let _e10083 = phi_7378_;
                        let _e10085 = phi_7379_;
                        let _e10087 = phi_7380_;
                        let _e10089 = phi_7381_;
                        let _e10091 = phi_7382_;
                        if _e10085 {
                            let _e12256 = local_98;
                            phi_7386_ = _e12256;
                            let _e12261 = local_100;
                            phi_7387_ = _e12261;
                            phi_7388_ = true;
                            phi_7389_ = false;
                            phi_7390_ = false;
                            phi_7391_ = false;
                        } else {
                            let _e12258 = local_99;
                            phi_7386_ = _e12258;
                            let _e12263 = local_101;
                            phi_7387_ = _e12263;
                            phi_7388_ = _e10087;
                            phi_7389_ = _e10089;
                            phi_7390_ = _e10091;
                            phi_7391_ = _e10056;
                        }
                        let _e10093 = phi_7386_;
                        let _e10095 = phi_7387_;
                        let _e10097 = phi_7388_;
                        let _e10099 = phi_7389_;
                        let _e10101 = phi_7390_;
                        let _e10103 = phi_7391_;
                        if _e10097 {
                            phi_7395_ = _e10095;
                            phi_7396_ = _e10093;
                            phi_7397_ = true;
                            phi_7398_ = false;
                            phi_7399_ = false;
                        } else {
                            let _e12270 = local_102;
                            phi_7395_ = _e12270;
                            let _e12273 = local_103;
                            phi_7396_ = _e12273;
                            phi_7397_ = _e10099;
                            phi_7398_ = _e10101;
                            phi_7399_ = _e10103;
                        }
                        let _e10105 = phi_7395_;
                        let _e10107 = phi_7396_;
                        let _e10109 = phi_7397_;
                        let _e10111 = phi_7398_;
                        let _e10113 = phi_7399_;
                        if _e10109 {
                            local_13[0u] = 0.01f;
                            local_13[1u] = 0f;
                            local_13[2u] = 0.8f;
                            if (_e421 >= (1.1102230246251565e-16lf * f64(8f))) {
                                phi_7413_ = _e421;
                            } else {
                                phi_7413_ = f64(0f);
                            }
                            let _e10122 = phi_7413_;
                            phi_7416_ = type_12(0u, 3u);
                            loop {
                                let _e10124 = phi_7416_;
                                if (_e10124.member < _e10124.member_1) {
                                    phi_7417_ = type_12((_e10124.member + 1u), _e10124.member_1);
                                    phi_7440_ = type_12(1u, _e10124.member);
                                } else {
                                    phi_7417_ = _e10124;
                                    phi_7440_ = type_12(0u, type_12().member_1);
                                }
                                let _e10136 = phi_7417_;
                                let _e10138 = phi_7440_;
                                if (bitcast<i32>(_e10138.member) != 0i) {
                                    let _e10144 = local_13[_e10138.member_1];
                                    let _e10147 = (_e10105 + (_e10122 * f64(_e10144)));
                                    if (_e10147 < _e439) {
                                        phi_7462_ = _e10147;
                                    } else {
                                        phi_7462_ = _e439;
                                    }
                                    let _e10150 = phi_7462_;
                                    let _e10153 = local_18.member[0u];
                                    let _e10159 = local_18.member[1u];
                                    let _e10175 = local_18.member_1[0u];
                                    let _e10181 = local_18.member_1[1u];
                                    let _e10197 = local_18.member_2[0u];
                                    let _e10203 = local_18.member_2[1u];
                                    let _e10217 = function_4(array<f64, 3>((_e10153[0] + ((_e10159[0] - _e10153[0]) * _e10150)), (_e10153[1] + ((_e10159[1] - _e10153[1]) * _e10150)), (_e10153[2] + ((_e10159[2] - _e10153[2]) * _e10150))), array<f64, 3>((_e10175[0] + ((_e10181[0] - _e10175[0]) * _e10150)), (_e10175[1] + ((_e10181[1] - _e10175[1]) * _e10150)), (_e10175[2] + ((_e10181[2] - _e10175[2]) * _e10150))), array<f64, 3>((_e10197[0] + ((_e10203[0] - _e10197[0]) * _e10150)), (_e10197[1] + ((_e10203[1] - _e10197[1]) * _e10150)), (_e10197[2] + ((_e10203[2] - _e10197[2]) * _e10150))), 1u);
                                    let _e10228 = (((_e10217[0] * _e10217[0]) + (_e10217[1] * _e10217[1])) + (_e10217[2] * _e10217[2]));
                                    if (_e10228 <= 2.2250738585072014e-308lf) {
                                        if (_e10228 > 0.0lf) {
                                            phi_7585_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_7585_ = 0.0lf;
                                        }
                                        let _e10280 = phi_7585_;
                                        phi_7649_ = _e10280;
                                    } else {
                                        phi_7592_ = type_16(0i, 5i);
                                        phi_7595_ = bitcast<f64>(((bitcast<u64>(_e10228) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e10235 = phi_7592_;
                                            let _e10237 = phi_7595_;
                                            local_62 = _e10237;
                                            if (_e10235.member < _e10235.member_1) {
                                                let _e10244 = (_e10235.member + 1i);
                                                if ((false == (_e10244 > _e10235.member)) != false) {
                                                    phi_7616_ = true;
                                                } else {
                                                    phi_7616_ = false;
                                                }
                                                let _e10249 = phi_7616_;
                                                if _e10249 {
                                                    phi_7622_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_7622_ = type_17(1u, _e10244);
                                                }
                                                let _e10254 = phi_7622_;
                                                phi_7593_ = type_16(_e10254.member_1, _e10235.member_1);
                                                phi_7636_ = type_17(1u, _e10235.member);
                                            } else {
                                                phi_7593_ = _e10235;
                                                phi_7636_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e10260 = phi_7593_;
                                            let _e10262 = phi_7636_;
                                            let _e10265 = (bitcast<i32>(_e10262.member) != 0i);
                                            if _e10265 {
                                                phi_7596_ = (0.5lf * (_e10237 + (_e10228 / _e10237)));
                                            } else {
                                                phi_7596_ = f64();
                                            }
                                            let _e10270 = phi_7596_;
                                            continue;
                                            continuing {
                                                phi_7592_ = _e10260;
                                                phi_7595_ = _e10270;
                                                break if !(_e10265);
                                            }
                                        }
                                        let _e10275 = local_62;
                                        phi_7649_ = (_e10275 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e10282 = phi_7649_;
                                    let _e10290 = local_18.member[0u];
                                    if (_e10290[0] < 0.0lf) {
                                        phi_7667_ = -(_e10290[0]);
                                    } else {
                                        phi_7667_ = _e10290[0];
                                    }
                                    let _e10297 = phi_7667_;
                                    if (_e10290[1] < 0.0lf) {
                                        phi_7674_ = -(_e10290[1]);
                                    } else {
                                        phi_7674_ = _e10290[1];
                                    }
                                    let _e10301 = phi_7674_;
                                    if (_e10297 > _e10301) {
                                        phi_7679_ = _e10297;
                                    } else {
                                        phi_7679_ = _e10301;
                                    }
                                    let _e10304 = phi_7679_;
                                    if (_e10290[2] < 0.0lf) {
                                        phi_7686_ = -(_e10290[2]);
                                    } else {
                                        phi_7686_ = _e10290[2];
                                    }
                                    let _e10308 = phi_7686_;
                                    if (_e10304 > _e10308) {
                                        phi_7691_ = _e10304;
                                    } else {
                                        phi_7691_ = _e10308;
                                    }
                                    let _e10311 = phi_7691_;
                                    let _e10314 = local_18.member[1u];
                                    if (_e10314[0] < 0.0lf) {
                                        phi_7704_ = -(_e10314[0]);
                                    } else {
                                        phi_7704_ = _e10314[0];
                                    }
                                    let _e10321 = phi_7704_;
                                    if (_e10314[1] < 0.0lf) {
                                        phi_7711_ = -(_e10314[1]);
                                    } else {
                                        phi_7711_ = _e10314[1];
                                    }
                                    let _e10325 = phi_7711_;
                                    if (_e10321 > _e10325) {
                                        phi_7716_ = _e10321;
                                    } else {
                                        phi_7716_ = _e10325;
                                    }
                                    let _e10328 = phi_7716_;
                                    if (_e10314[2] < 0.0lf) {
                                        phi_7723_ = -(_e10314[2]);
                                    } else {
                                        phi_7723_ = _e10314[2];
                                    }
                                    let _e10332 = phi_7723_;
                                    if (_e10328 > _e10332) {
                                        phi_7728_ = _e10328;
                                    } else {
                                        phi_7728_ = _e10332;
                                    }
                                    let _e10335 = phi_7728_;
                                    if (_e10311 > _e10335) {
                                        phi_7733_ = _e10311;
                                    } else {
                                        phi_7733_ = _e10335;
                                    }
                                    let _e10338 = phi_7733_;
                                    let _e10340 = local_18.member_3;
                                    let _e10344 = local_18.member_1[0u];
                                    if (_e10344[0] < 0.0lf) {
                                        phi_7750_ = -(_e10344[0]);
                                    } else {
                                        phi_7750_ = _e10344[0];
                                    }
                                    let _e10351 = phi_7750_;
                                    if (_e10344[1] < 0.0lf) {
                                        phi_7757_ = -(_e10344[1]);
                                    } else {
                                        phi_7757_ = _e10344[1];
                                    }
                                    let _e10355 = phi_7757_;
                                    if (_e10351 > _e10355) {
                                        phi_7762_ = _e10351;
                                    } else {
                                        phi_7762_ = _e10355;
                                    }
                                    let _e10358 = phi_7762_;
                                    if (_e10344[2] < 0.0lf) {
                                        phi_7769_ = -(_e10344[2]);
                                    } else {
                                        phi_7769_ = _e10344[2];
                                    }
                                    let _e10362 = phi_7769_;
                                    if (_e10358 > _e10362) {
                                        phi_7774_ = _e10358;
                                    } else {
                                        phi_7774_ = _e10362;
                                    }
                                    let _e10365 = phi_7774_;
                                    let _e10368 = local_18.member_1[1u];
                                    if (_e10368[0] < 0.0lf) {
                                        phi_7788_ = -(_e10368[0]);
                                    } else {
                                        phi_7788_ = _e10368[0];
                                    }
                                    let _e10375 = phi_7788_;
                                    if (_e10368[1] < 0.0lf) {
                                        phi_7795_ = -(_e10368[1]);
                                    } else {
                                        phi_7795_ = _e10368[1];
                                    }
                                    let _e10379 = phi_7795_;
                                    if (_e10375 > _e10379) {
                                        phi_7800_ = _e10375;
                                    } else {
                                        phi_7800_ = _e10379;
                                    }
                                    let _e10382 = phi_7800_;
                                    if (_e10368[2] < 0.0lf) {
                                        phi_7807_ = -(_e10368[2]);
                                    } else {
                                        phi_7807_ = _e10368[2];
                                    }
                                    let _e10386 = phi_7807_;
                                    if (_e10382 > _e10386) {
                                        phi_7812_ = _e10382;
                                    } else {
                                        phi_7812_ = _e10386;
                                    }
                                    let _e10389 = phi_7812_;
                                    if (_e10365 > _e10389) {
                                        phi_7817_ = _e10365;
                                    } else {
                                        phi_7817_ = _e10389;
                                    }
                                    let _e10392 = phi_7817_;
                                    let _e10394 = local_18.member_3;
                                    let _e10398 = local_18.member_2[0u];
                                    if (_e10398[0] < 0.0lf) {
                                        phi_7834_ = -(_e10398[0]);
                                    } else {
                                        phi_7834_ = _e10398[0];
                                    }
                                    let _e10405 = phi_7834_;
                                    if (_e10398[1] < 0.0lf) {
                                        phi_7841_ = -(_e10398[1]);
                                    } else {
                                        phi_7841_ = _e10398[1];
                                    }
                                    let _e10409 = phi_7841_;
                                    if (_e10405 > _e10409) {
                                        phi_7846_ = _e10405;
                                    } else {
                                        phi_7846_ = _e10409;
                                    }
                                    let _e10412 = phi_7846_;
                                    if (_e10398[2] < 0.0lf) {
                                        phi_7853_ = -(_e10398[2]);
                                    } else {
                                        phi_7853_ = _e10398[2];
                                    }
                                    let _e10416 = phi_7853_;
                                    if (_e10412 > _e10416) {
                                        phi_7858_ = _e10412;
                                    } else {
                                        phi_7858_ = _e10416;
                                    }
                                    let _e10419 = phi_7858_;
                                    let _e10422 = local_18.member_2[1u];
                                    if (_e10422[0] < 0.0lf) {
                                        phi_7872_ = -(_e10422[0]);
                                    } else {
                                        phi_7872_ = _e10422[0];
                                    }
                                    let _e10429 = phi_7872_;
                                    if (_e10422[1] < 0.0lf) {
                                        phi_7879_ = -(_e10422[1]);
                                    } else {
                                        phi_7879_ = _e10422[1];
                                    }
                                    let _e10433 = phi_7879_;
                                    if (_e10429 > _e10433) {
                                        phi_7884_ = _e10429;
                                    } else {
                                        phi_7884_ = _e10433;
                                    }
                                    let _e10436 = phi_7884_;
                                    if (_e10422[2] < 0.0lf) {
                                        phi_7891_ = -(_e10422[2]);
                                    } else {
                                        phi_7891_ = _e10422[2];
                                    }
                                    let _e10440 = phi_7891_;
                                    if (_e10436 > _e10440) {
                                        phi_7896_ = _e10436;
                                    } else {
                                        phi_7896_ = _e10440;
                                    }
                                    let _e10443 = phi_7896_;
                                    if (_e10419 > _e10443) {
                                        phi_7901_ = _e10419;
                                    } else {
                                        phi_7901_ = _e10443;
                                    }
                                    let _e10446 = phi_7901_;
                                    let _e10448 = local_18.member_3;
                                    let _e10456 = local_18.member_3;
                                    let _e10466 = (((_e10282 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e10338 + _e10340) + (_e10392 + _e10394)) + (_e10446 + _e10448)) * (1.1102230246251565e-16lf * f64(16f))) + (_e10456 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e643.member_1);
                                    if _e10466 {
                                        phi_7925_ = false;
                                    } else {
                                        phi_7925_ = true;
                                    }
                                    let _e10468 = phi_7925_;
                                    phi_7926_ = _e10468;
                                    phi_7927_ = _e10466;
                                } else {
                                    phi_7926_ = false;
                                    phi_7927_ = false;
                                }
                                let _e10470 = phi_7926_;
                                let _e10472 = phi_7927_;
                                local_63 = _e10472;
                                continue;
                                continuing {
                                    phi_7416_ = _e10136;
                                    break if !(_e10470);
                                }
                            }
                            let _e10475 = local_63;
                            if _e10475 {
                                if (_e10105 > _e430) {
                                    phi_7935_ = 1u;
                                } else {
                                    phi_7935_ = _e10107;
                                }
                                let _e10478 = phi_7935_;
                                phi_7939_ = type_47(type_46(1u, _e10105), _e10478);
                                phi_7940_ = false;
                            } else {
                                phi_7939_ = type_47();
                                phi_7940_ = true;
                            }
                            let _e10482 = phi_7939_;
                            let _e10484 = phi_7940_;
                            if _e10484 {
                                if (_e10105 > _e430) {
                                    phi_7948_ = 0u;
                                } else {
                                    phi_7948_ = _e10107;
                                }
                                let _e10487 = phi_7948_;
                                phi_7952_ = type_47(type_46(2u, _e10105), _e10487);
                            } else {
                                phi_7952_ = _e10482;
                            }
                            let _e10491 = phi_7952_;
                            phi_7953_ = _e10491;
                            phi_7954_ = false;
                            phi_7955_ = false;
                        } else {
                            phi_7953_ = type_47();
                            phi_7954_ = _e10111;
                            phi_7955_ = _e10113;
                        }
                        let _e10493 = phi_7953_;
                        let _e10495 = phi_7954_;
                        let _e10497 = phi_7955_;
                        if _e10495 {
                            phi_7962_ = type_47(type_46(0u, f64()), 0u);
                            phi_7963_ = true;
                        } else {
                            phi_7962_ = _e10083;
                            phi_7963_ = _e10497;
                        }
                        let _e10501 = phi_7962_;
                        let _e10503 = phi_7963_;
                        phi_7967_ = _e10501;
                        phi_7968_ = _e10493;
                        phi_7969_ = _e10503;
                    } else {
                        phi_7967_ = _e6657;
                        phi_7968_ = type_47();
                        phi_7969_ = true;
                    }
                    let _e10505 = phi_7967_;
                    let _e10507 = phi_7968_;
                    let _e10509 = phi_7969_;
                    if _e10509 {
                        phi_7973_ = _e10505;
                    } else {
                        phi_7973_ = _e10507;
                    }
                    let _e10511 = phi_7973_;
                    phi_15640_ = _e10511;
                } else {
                    let _e686 = f64(0f);
                    let _e689 = local_18.member_1[0u];
                    let _e695 = local_18.member_2[0u];
                    let _e701 = ((_e689[1] * _e695[2]) - (_e689[2] * _e695[1]));
                    let _e704 = ((_e689[2] * _e695[0]) - (_e689[0] * _e695[2]));
                    let _e707 = ((_e689[0] * _e695[1]) - (_e689[1] * _e695[0]));
                    let _e710 = local_18.member_1[1u];
                    let _e716 = local_18.member_2[1u];
                    let _e722 = ((_e710[1] * _e716[2]) - (_e710[2] * _e716[1]));
                    let _e725 = ((_e710[2] * _e716[0]) - (_e710[0] * _e716[2]));
                    let _e728 = ((_e710[0] * _e716[1]) - (_e710[1] * _e716[0]));
                    let _e731 = local_18.member_1[0u];
                    let _e737 = local_18.member_2[1u];
                    let _e752 = local_18.member_1[1u];
                    let _e758 = local_18.member_2[0u];
                    let _e771 = (((_e731[1] * _e737[2]) - (_e731[2] * _e737[1])) + ((_e752[1] * _e758[2]) - (_e752[2] * _e758[1])));
                    let _e772 = (((_e731[2] * _e737[0]) - (_e731[0] * _e737[2])) + ((_e752[2] * _e758[0]) - (_e752[0] * _e758[2])));
                    let _e773 = (((_e731[0] * _e737[1]) - (_e731[1] * _e737[0])) + ((_e752[0] * _e758[1]) - (_e752[1] * _e758[0])));
                    let _e776 = local_18.member[0u];
                    let _e784 = (((_e776[0] * _e701) + (_e776[1] * _e704)) + (_e776[2] * _e707));
                    let _e787 = local_18.member[1u];
                    let _e798 = local_18.member[0u];
                    let _e807 = ((((_e787[0] * _e701) + (_e787[1] * _e704)) + (_e787[2] * _e707)) + (((_e798[0] * _e771) + (_e798[1] * _e772)) + (_e798[2] * _e773)));
                    let _e810 = local_18.member[0u];
                    let _e821 = local_18.member[1u];
                    let _e830 = ((((_e810[0] * _e722) + (_e810[1] * _e725)) + (_e810[2] * _e728)) + (((_e821[0] * _e771) + (_e821[1] * _e772)) + (_e821[2] * _e773)));
                    let _e833 = local_18.member[1u];
                    let _e841 = (((_e833[0] * _e722) + (_e833[1] * _e725)) + (_e833[2] * _e728));
                    let _e844 = local_18.member[0u];
                    if (_e844[0] < 0.0lf) {
                        phi_8216_ = -(_e844[0]);
                    } else {
                        phi_8216_ = _e844[0];
                    }
                    let _e851 = phi_8216_;
                    if (_e844[1] < 0.0lf) {
                        phi_8223_ = -(_e844[1]);
                    } else {
                        phi_8223_ = _e844[1];
                    }
                    let _e855 = phi_8223_;
                    if (_e851 > _e855) {
                        phi_8228_ = _e851;
                    } else {
                        phi_8228_ = _e855;
                    }
                    let _e858 = phi_8228_;
                    if (_e844[2] < 0.0lf) {
                        phi_8235_ = -(_e844[2]);
                    } else {
                        phi_8235_ = _e844[2];
                    }
                    let _e862 = phi_8235_;
                    if (_e858 > _e862) {
                        phi_8240_ = _e858;
                    } else {
                        phi_8240_ = _e862;
                    }
                    let _e865 = phi_8240_;
                    let _e868 = local_18.member[1u];
                    if (_e868[0] < 0.0lf) {
                        phi_8253_ = -(_e868[0]);
                    } else {
                        phi_8253_ = _e868[0];
                    }
                    let _e875 = phi_8253_;
                    if (_e868[1] < 0.0lf) {
                        phi_8260_ = -(_e868[1]);
                    } else {
                        phi_8260_ = _e868[1];
                    }
                    let _e879 = phi_8260_;
                    if (_e875 > _e879) {
                        phi_8265_ = _e875;
                    } else {
                        phi_8265_ = _e879;
                    }
                    let _e882 = phi_8265_;
                    if (_e868[2] < 0.0lf) {
                        phi_8272_ = -(_e868[2]);
                    } else {
                        phi_8272_ = _e868[2];
                    }
                    let _e886 = phi_8272_;
                    if (_e882 > _e886) {
                        phi_8277_ = _e882;
                    } else {
                        phi_8277_ = _e886;
                    }
                    let _e889 = phi_8277_;
                    if (_e865 > _e889) {
                        phi_8282_ = _e865;
                    } else {
                        phi_8282_ = _e889;
                    }
                    let _e892 = phi_8282_;
                    let _e894 = local_18.member_3;
                    let _e895 = (_e892 + _e894);
                    let _e898 = local_18.member_1[0u];
                    if (_e898[0] < 0.0lf) {
                        phi_8299_ = -(_e898[0]);
                    } else {
                        phi_8299_ = _e898[0];
                    }
                    let _e905 = phi_8299_;
                    if (_e898[1] < 0.0lf) {
                        phi_8306_ = -(_e898[1]);
                    } else {
                        phi_8306_ = _e898[1];
                    }
                    let _e909 = phi_8306_;
                    if (_e905 > _e909) {
                        phi_8311_ = _e905;
                    } else {
                        phi_8311_ = _e909;
                    }
                    let _e912 = phi_8311_;
                    if (_e898[2] < 0.0lf) {
                        phi_8318_ = -(_e898[2]);
                    } else {
                        phi_8318_ = _e898[2];
                    }
                    let _e916 = phi_8318_;
                    if (_e912 > _e916) {
                        phi_8323_ = _e912;
                    } else {
                        phi_8323_ = _e916;
                    }
                    let _e919 = phi_8323_;
                    let _e922 = local_18.member_1[1u];
                    if (_e922[0] < 0.0lf) {
                        phi_8337_ = -(_e922[0]);
                    } else {
                        phi_8337_ = _e922[0];
                    }
                    let _e929 = phi_8337_;
                    if (_e922[1] < 0.0lf) {
                        phi_8344_ = -(_e922[1]);
                    } else {
                        phi_8344_ = _e922[1];
                    }
                    let _e933 = phi_8344_;
                    if (_e929 > _e933) {
                        phi_8349_ = _e929;
                    } else {
                        phi_8349_ = _e933;
                    }
                    let _e936 = phi_8349_;
                    if (_e922[2] < 0.0lf) {
                        phi_8356_ = -(_e922[2]);
                    } else {
                        phi_8356_ = _e922[2];
                    }
                    let _e940 = phi_8356_;
                    if (_e936 > _e940) {
                        phi_8361_ = _e936;
                    } else {
                        phi_8361_ = _e940;
                    }
                    let _e943 = phi_8361_;
                    if (_e919 > _e943) {
                        phi_8366_ = _e919;
                    } else {
                        phi_8366_ = _e943;
                    }
                    let _e946 = phi_8366_;
                    let _e948 = local_18.member_3;
                    let _e949 = (_e946 + _e948);
                    let _e952 = local_18.member_2[0u];
                    if (_e952[0] < 0.0lf) {
                        phi_8383_ = -(_e952[0]);
                    } else {
                        phi_8383_ = _e952[0];
                    }
                    let _e959 = phi_8383_;
                    if (_e952[1] < 0.0lf) {
                        phi_8390_ = -(_e952[1]);
                    } else {
                        phi_8390_ = _e952[1];
                    }
                    let _e963 = phi_8390_;
                    if (_e959 > _e963) {
                        phi_8395_ = _e959;
                    } else {
                        phi_8395_ = _e963;
                    }
                    let _e966 = phi_8395_;
                    if (_e952[2] < 0.0lf) {
                        phi_8402_ = -(_e952[2]);
                    } else {
                        phi_8402_ = _e952[2];
                    }
                    let _e970 = phi_8402_;
                    if (_e966 > _e970) {
                        phi_8407_ = _e966;
                    } else {
                        phi_8407_ = _e970;
                    }
                    let _e973 = phi_8407_;
                    let _e976 = local_18.member_2[1u];
                    if (_e976[0] < 0.0lf) {
                        phi_8421_ = -(_e976[0]);
                    } else {
                        phi_8421_ = _e976[0];
                    }
                    let _e983 = phi_8421_;
                    if (_e976[1] < 0.0lf) {
                        phi_8428_ = -(_e976[1]);
                    } else {
                        phi_8428_ = _e976[1];
                    }
                    let _e987 = phi_8428_;
                    if (_e983 > _e987) {
                        phi_8433_ = _e983;
                    } else {
                        phi_8433_ = _e987;
                    }
                    let _e990 = phi_8433_;
                    if (_e976[2] < 0.0lf) {
                        phi_8440_ = -(_e976[2]);
                    } else {
                        phi_8440_ = _e976[2];
                    }
                    let _e994 = phi_8440_;
                    if (_e990 > _e994) {
                        phi_8445_ = _e990;
                    } else {
                        phi_8445_ = _e994;
                    }
                    let _e997 = phi_8445_;
                    if (_e973 > _e997) {
                        phi_8450_ = _e973;
                    } else {
                        phi_8450_ = _e997;
                    }
                    let _e1000 = phi_8450_;
                    let _e1002 = local_18.member_3;
                    let _e1003 = (_e1000 + _e1002);
                    let _e1004 = f64(1f);
                    let _e1005 = f64(8f);
                    let _e1007 = ((_e949 * _e1005) * _e1003);
                    let _e1015 = local_18.member_3;
                    if (_e701 < 0.0lf) {
                        phi_8487_ = -(_e701);
                    } else {
                        phi_8487_ = _e701;
                    }
                    let _e1035 = phi_8487_;
                    if (_e704 < 0.0lf) {
                        phi_8493_ = -(_e704);
                    } else {
                        phi_8493_ = _e704;
                    }
                    let _e1039 = phi_8493_;
                    if (_e707 < 0.0lf) {
                        phi_8500_ = -(_e707);
                    } else {
                        phi_8500_ = _e707;
                    }
                    let _e1044 = phi_8500_;
                    let _e1045 = ((_e1035 + _e1039) + _e1044);
                    if (_e722 < 0.0lf) {
                        phi_8507_ = -(_e722);
                    } else {
                        phi_8507_ = _e722;
                    }
                    let _e1049 = phi_8507_;
                    if (_e725 < 0.0lf) {
                        phi_8513_ = -(_e725);
                    } else {
                        phi_8513_ = _e725;
                    }
                    let _e1053 = phi_8513_;
                    if (_e728 < 0.0lf) {
                        phi_8520_ = -(_e728);
                    } else {
                        phi_8520_ = _e728;
                    }
                    let _e1058 = phi_8520_;
                    let _e1059 = ((_e1049 + _e1053) + _e1058);
                    if (_e1045 > _e1059) {
                        phi_8526_ = _e1045;
                    } else {
                        phi_8526_ = _e1059;
                    }
                    let _e1062 = phi_8526_;
                    if (_e771 < 0.0lf) {
                        phi_8532_ = -(_e771);
                    } else {
                        phi_8532_ = _e771;
                    }
                    let _e1066 = phi_8532_;
                    if (_e772 < 0.0lf) {
                        phi_8538_ = -(_e772);
                    } else {
                        phi_8538_ = _e772;
                    }
                    let _e1070 = phi_8538_;
                    if (_e773 < 0.0lf) {
                        phi_8545_ = -(_e773);
                    } else {
                        phi_8545_ = _e773;
                    }
                    let _e1075 = phi_8545_;
                    let _e1077 = (((_e1066 + _e1070) + _e1075) * f64(0.5f));
                    if (_e1062 > _e1077) {
                        phi_8552_ = _e1062;
                    } else {
                        phi_8552_ = _e1077;
                    }
                    let _e1080 = phi_8552_;
                    let _e1086 = local_18.member_3;
                    let _e1100 = (((((_e895 * _e1005) * _e1007) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e1015 * f64(19f)) * ((_e895 * (_e949 + _e1003)) + (_e949 * _e1003)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1004 + _e895) * ((_e1004 + _e949) * (_e1004 + _e1003)))));
                    let _e1101 = f64(3f);
                    let _e1102 = (_e784 * _e1101);
                    let _e1103 = (_e841 * _e1101);
                    if (_e1102 < _e1103) {
                        phi_8580_ = _e1102;
                    } else {
                        phi_8580_ = _e1103;
                    }
                    let _e1106 = phi_8580_;
                    if (_e807 < _e830) {
                        phi_8585_ = _e807;
                    } else {
                        phi_8585_ = _e830;
                    }
                    let _e1109 = phi_8585_;
                    if (_e1106 < _e1109) {
                        phi_8590_ = _e1106;
                    } else {
                        phi_8590_ = _e1109;
                    }
                    let _e1112 = phi_8590_;
                    if (_e1102 > _e1103) {
                        phi_8595_ = _e1102;
                    } else {
                        phi_8595_ = _e1103;
                    }
                    let _e1115 = phi_8595_;
                    if (_e807 > _e830) {
                        phi_8600_ = _e807;
                    } else {
                        phi_8600_ = _e830;
                    }
                    let _e1118 = phi_8600_;
                    if (_e1115 > _e1118) {
                        phi_8605_ = _e1115;
                    } else {
                        phi_8605_ = _e1118;
                    }
                    let _e1121 = phi_8605_;
                    let _e1127 = -(_e1121);
                    if (_e1112 > _e1127) {
                        phi_8616_ = _e1112;
                    } else {
                        phi_8616_ = _e1127;
                    }
                    let _e1130 = phi_8616_;
                    if ((_e1130 - (_e1100 + ((_e686 * (((_e1080 + (_e1007 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1086 * f64(6f)) * (_e949 + _e1003))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e1004 + _e949) * (_e1004 + _e1003))))) * f64((3f * 1.0001f))))) > _e686) {
                        phi_15610_ = type_46(0u, type_46().member_1);
                        phi_15611_ = type_46();
                        phi_15612_ = true;
                    } else {
                        if (_e784 < 0.0lf) {
                            phi_8630_ = -(_e784);
                        } else {
                            phi_8630_ = _e784;
                        }
                        let _e1138 = phi_8630_;
                        if (_e807 < 0.0lf) {
                            phi_8636_ = -(_e807);
                        } else {
                            phi_8636_ = _e807;
                        }
                        let _e1142 = phi_8636_;
                        if (_e1138 > _e1142) {
                            phi_8641_ = _e1138;
                        } else {
                            phi_8641_ = _e1142;
                        }
                        let _e1145 = phi_8641_;
                        if (_e830 < 0.0lf) {
                            phi_8647_ = -(_e830);
                        } else {
                            phi_8647_ = _e830;
                        }
                        let _e1149 = phi_8647_;
                        if (_e841 < 0.0lf) {
                            phi_8653_ = -(_e841);
                        } else {
                            phi_8653_ = _e841;
                        }
                        let _e1153 = phi_8653_;
                        if (_e1149 > _e1153) {
                            phi_8658_ = _e1149;
                        } else {
                            phi_8658_ = _e1153;
                        }
                        let _e1156 = phi_8658_;
                        if (_e1145 > _e1156) {
                            phi_8663_ = _e1145;
                        } else {
                            phi_8663_ = _e1156;
                        }
                        let _e1159 = phi_8663_;
                        let _e1161 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e1162 = f64(1f);
                        if (_e1159 >= _e1161) {
                            phi_8673_ = (_e1159 <= (_e1162 / _e1161));
                        } else {
                            phi_8673_ = false;
                        }
                        let _e1167 = phi_8673_;
                        if _e1167 {
                            phi_8680_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_8680_ = f64(2f);
                        }
                        let _e1172 = phi_8680_;
                        let _e1174 = ((_e1100 * f64(0.34f)) + (_e1159 * _e1172));
                        if _e1167 {
                            phi_8688_ = (_e1162 / _e1159);
                        } else {
                            phi_8688_ = f64(0f);
                        }
                        let _e1178 = phi_8688_;
                        let _e1179 = f64(0.00000000000022737368f);
                        let _e1181 = (_e421 * f64(0.0625f));
                        if (_e1179 < _e1181) {
                            phi_8696_ = _e1179;
                        } else {
                            phi_8696_ = _e1181;
                        }
                        let _e1184 = phi_8696_;
                        let _e1186 = (f64(1f) - _e430);
                        let _e1197 = ((((_e784 * _e1186) + (_e807 * _e430)) * (_e1186 * _e1186)) + (((_e830 * _e1186) + (_e841 * _e430)) * (_e430 * _e430)));
                        if (_e1197 < 0.0lf) {
                            phi_8715_ = -(_e1197);
                        } else {
                            phi_8715_ = _e1197;
                        }
                        let _e1201 = phi_8715_;
                        if !((_e1201 > _e1174)) {
                            let _e1204 = f64(0f);
                            let _e1207 = local_18.member[0u];
                            let _e1213 = local_18.member_1[0u];
                            let _e1219 = local_18.member_2[0u];
                            let _e1223 = (_e1207[0] - _e1213[0]);
                            let _e1224 = (_e1207[1] - _e1213[1]);
                            let _e1225 = (_e1207[2] - _e1213[2]);
                            let _e1226 = (_e1223 - _e1219[0]);
                            let _e1227 = (_e1224 - _e1219[1]);
                            let _e1228 = (_e1225 - _e1219[2]);
                            let _e1229 = (_e1207[0] - _e1219[0]);
                            let _e1230 = (_e1207[1] - _e1219[1]);
                            let _e1231 = (_e1207[2] - _e1219[2]);
                            let _e1234 = local_18.member[1u];
                            let _e1240 = local_18.member_1[1u];
                            let _e1246 = local_18.member_2[1u];
                            let _e1250 = (_e1234[0] - _e1240[0]);
                            let _e1251 = (_e1234[1] - _e1240[1]);
                            let _e1252 = (_e1234[2] - _e1240[2]);
                            let _e1253 = (_e1250 - _e1246[0]);
                            let _e1254 = (_e1251 - _e1246[1]);
                            let _e1255 = (_e1252 - _e1246[2]);
                            let _e1256 = (_e1234[0] - _e1246[0]);
                            let _e1257 = (_e1234[1] - _e1246[1]);
                            let _e1258 = (_e1234[2] - _e1246[2]);
                            let _e1261 = local_18.member[0u];
                            if (_e1261[0] < 0.0lf) {
                                phi_8864_ = -(_e1261[0]);
                            } else {
                                phi_8864_ = _e1261[0];
                            }
                            let _e1268 = phi_8864_;
                            if (_e1261[1] < 0.0lf) {
                                phi_8871_ = -(_e1261[1]);
                            } else {
                                phi_8871_ = _e1261[1];
                            }
                            let _e1272 = phi_8871_;
                            if (_e1268 > _e1272) {
                                phi_8876_ = _e1268;
                            } else {
                                phi_8876_ = _e1272;
                            }
                            let _e1275 = phi_8876_;
                            if (_e1261[2] < 0.0lf) {
                                phi_8883_ = -(_e1261[2]);
                            } else {
                                phi_8883_ = _e1261[2];
                            }
                            let _e1279 = phi_8883_;
                            if (_e1275 > _e1279) {
                                phi_8888_ = _e1275;
                            } else {
                                phi_8888_ = _e1279;
                            }
                            let _e1282 = phi_8888_;
                            let _e1285 = local_18.member[1u];
                            if (_e1285[0] < 0.0lf) {
                                phi_8901_ = -(_e1285[0]);
                            } else {
                                phi_8901_ = _e1285[0];
                            }
                            let _e1292 = phi_8901_;
                            if (_e1285[1] < 0.0lf) {
                                phi_8908_ = -(_e1285[1]);
                            } else {
                                phi_8908_ = _e1285[1];
                            }
                            let _e1296 = phi_8908_;
                            if (_e1292 > _e1296) {
                                phi_8913_ = _e1292;
                            } else {
                                phi_8913_ = _e1296;
                            }
                            let _e1299 = phi_8913_;
                            if (_e1285[2] < 0.0lf) {
                                phi_8920_ = -(_e1285[2]);
                            } else {
                                phi_8920_ = _e1285[2];
                            }
                            let _e1303 = phi_8920_;
                            if (_e1299 > _e1303) {
                                phi_8925_ = _e1299;
                            } else {
                                phi_8925_ = _e1303;
                            }
                            let _e1306 = phi_8925_;
                            if (_e1282 > _e1306) {
                                phi_8930_ = _e1282;
                            } else {
                                phi_8930_ = _e1306;
                            }
                            let _e1309 = phi_8930_;
                            let _e1311 = local_18.member_3;
                            let _e1315 = local_18.member_1[0u];
                            if (_e1315[0] < 0.0lf) {
                                phi_8947_ = -(_e1315[0]);
                            } else {
                                phi_8947_ = _e1315[0];
                            }
                            let _e1322 = phi_8947_;
                            if (_e1315[1] < 0.0lf) {
                                phi_8954_ = -(_e1315[1]);
                            } else {
                                phi_8954_ = _e1315[1];
                            }
                            let _e1326 = phi_8954_;
                            if (_e1322 > _e1326) {
                                phi_8959_ = _e1322;
                            } else {
                                phi_8959_ = _e1326;
                            }
                            let _e1329 = phi_8959_;
                            if (_e1315[2] < 0.0lf) {
                                phi_8966_ = -(_e1315[2]);
                            } else {
                                phi_8966_ = _e1315[2];
                            }
                            let _e1333 = phi_8966_;
                            if (_e1329 > _e1333) {
                                phi_8971_ = _e1329;
                            } else {
                                phi_8971_ = _e1333;
                            }
                            let _e1336 = phi_8971_;
                            let _e1339 = local_18.member_1[1u];
                            if (_e1339[0] < 0.0lf) {
                                phi_8985_ = -(_e1339[0]);
                            } else {
                                phi_8985_ = _e1339[0];
                            }
                            let _e1346 = phi_8985_;
                            if (_e1339[1] < 0.0lf) {
                                phi_8992_ = -(_e1339[1]);
                            } else {
                                phi_8992_ = _e1339[1];
                            }
                            let _e1350 = phi_8992_;
                            if (_e1346 > _e1350) {
                                phi_8997_ = _e1346;
                            } else {
                                phi_8997_ = _e1350;
                            }
                            let _e1353 = phi_8997_;
                            if (_e1339[2] < 0.0lf) {
                                phi_9004_ = -(_e1339[2]);
                            } else {
                                phi_9004_ = _e1339[2];
                            }
                            let _e1357 = phi_9004_;
                            if (_e1353 > _e1357) {
                                phi_9009_ = _e1353;
                            } else {
                                phi_9009_ = _e1357;
                            }
                            let _e1360 = phi_9009_;
                            if (_e1336 > _e1360) {
                                phi_9014_ = _e1336;
                            } else {
                                phi_9014_ = _e1360;
                            }
                            let _e1363 = phi_9014_;
                            let _e1365 = local_18.member_3;
                            let _e1369 = local_18.member_2[0u];
                            if (_e1369[0] < 0.0lf) {
                                phi_9031_ = -(_e1369[0]);
                            } else {
                                phi_9031_ = _e1369[0];
                            }
                            let _e1376 = phi_9031_;
                            if (_e1369[1] < 0.0lf) {
                                phi_9038_ = -(_e1369[1]);
                            } else {
                                phi_9038_ = _e1369[1];
                            }
                            let _e1380 = phi_9038_;
                            if (_e1376 > _e1380) {
                                phi_9043_ = _e1376;
                            } else {
                                phi_9043_ = _e1380;
                            }
                            let _e1383 = phi_9043_;
                            if (_e1369[2] < 0.0lf) {
                                phi_9050_ = -(_e1369[2]);
                            } else {
                                phi_9050_ = _e1369[2];
                            }
                            let _e1387 = phi_9050_;
                            if (_e1383 > _e1387) {
                                phi_9055_ = _e1383;
                            } else {
                                phi_9055_ = _e1387;
                            }
                            let _e1390 = phi_9055_;
                            let _e1393 = local_18.member_2[1u];
                            if (_e1393[0] < 0.0lf) {
                                phi_9069_ = -(_e1393[0]);
                            } else {
                                phi_9069_ = _e1393[0];
                            }
                            let _e1400 = phi_9069_;
                            if (_e1393[1] < 0.0lf) {
                                phi_9076_ = -(_e1393[1]);
                            } else {
                                phi_9076_ = _e1393[1];
                            }
                            let _e1404 = phi_9076_;
                            if (_e1400 > _e1404) {
                                phi_9081_ = _e1400;
                            } else {
                                phi_9081_ = _e1404;
                            }
                            let _e1407 = phi_9081_;
                            if (_e1393[2] < 0.0lf) {
                                phi_9088_ = -(_e1393[2]);
                            } else {
                                phi_9088_ = _e1393[2];
                            }
                            let _e1411 = phi_9088_;
                            if (_e1407 > _e1411) {
                                phi_9093_ = _e1407;
                            } else {
                                phi_9093_ = _e1411;
                            }
                            let _e1414 = phi_9093_;
                            if (_e1390 > _e1414) {
                                phi_9098_ = _e1390;
                            } else {
                                phi_9098_ = _e1414;
                            }
                            let _e1417 = phi_9098_;
                            let _e1419 = local_18.member_3;
                            let _e1427 = local_18.member_3;
                            let _e1433 = ((((((_e1309 + _e1311) + (_e1363 + _e1365)) + (_e1417 + _e1419)) * (1.1102230246251565e-16lf * f64(16f))) + (_e1427 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f)));
                            let _e1436 = local_18.member[0u];
                            let _e1442 = local_18.member[1u];
                            let _e1458 = local_18.member_1[0u];
                            let _e1464 = local_18.member_1[1u];
                            let _e1480 = local_18.member_2[0u];
                            let _e1486 = local_18.member_2[1u];
                            let _e1500 = function_4(array<f64, 3>((_e1436[0] + ((_e1442[0] - _e1436[0]) * _e430)), (_e1436[1] + ((_e1442[1] - _e1436[1]) * _e430)), (_e1436[2] + ((_e1442[2] - _e1436[2]) * _e430))), array<f64, 3>((_e1458[0] + ((_e1464[0] - _e1458[0]) * _e430)), (_e1458[1] + ((_e1464[1] - _e1458[1]) * _e430)), (_e1458[2] + ((_e1464[2] - _e1458[2]) * _e430))), array<f64, 3>((_e1480[0] + ((_e1486[0] - _e1480[0]) * _e430)), (_e1480[1] + ((_e1486[1] - _e1480[1]) * _e430)), (_e1480[2] + ((_e1486[2] - _e1480[2]) * _e430))), 1u);
                            if (_e1500[0] < 0.0lf) {
                                phi_9219_ = -(_e1500[0]);
                            } else {
                                phi_9219_ = _e1500[0];
                            }
                            let _e1505 = phi_9219_;
                            if (_e1500[1] < 0.0lf) {
                                phi_9226_ = -(_e1500[1]);
                            } else {
                                phi_9226_ = _e1500[1];
                            }
                            let _e1510 = phi_9226_;
                            if (_e1500[2] < 0.0lf) {
                                phi_9234_ = -(_e1500[2]);
                            } else {
                                phi_9234_ = _e1500[2];
                            }
                            let _e1516 = phi_9234_;
                            let _e1517 = ((_e1505 + _e1510) + _e1516);
                            if (_e1517 > f64(0f)) {
                                if ((bitcast<u64>(_e1517) & 9218868437227405312lu) != 9218868437227405312lu) {
                                    let _e1524 = (f64(1f) / _e1517);
                                    let _e1526 = (_e1500[0] * _e1524);
                                    let _e1528 = (_e1500[1] * _e1524);
                                    let _e1530 = (_e1500[2] * _e1524);
                                    let _e1535 = (((_e1526 * _e1526) + (_e1528 * _e1528)) + (_e1530 * _e1530));
                                    if (_e1535 <= 2.2250738585072014e-308lf) {
                                        if (_e1535 > 0.0lf) {
                                            phi_9273_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_9273_ = 0.0lf;
                                        }
                                        let _e1587 = phi_9273_;
                                        phi_9337_ = _e1587;
                                    } else {
                                        phi_9280_ = type_16(0i, 5i);
                                        phi_9283_ = bitcast<f64>(((bitcast<u64>(_e1535) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e1542 = phi_9280_;
                                            let _e1544 = phi_9283_;
                                            local_19 = _e1544;
                                            if (_e1542.member < _e1542.member_1) {
                                                let _e1551 = (_e1542.member + 1i);
                                                if ((false == (_e1551 > _e1542.member)) != false) {
                                                    phi_9304_ = true;
                                                } else {
                                                    phi_9304_ = false;
                                                }
                                                let _e1556 = phi_9304_;
                                                if _e1556 {
                                                    phi_9310_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_9310_ = type_17(1u, _e1551);
                                                }
                                                let _e1561 = phi_9310_;
                                                phi_9281_ = type_16(_e1561.member_1, _e1542.member_1);
                                                phi_9324_ = type_17(1u, _e1542.member);
                                            } else {
                                                phi_9281_ = _e1542;
                                                phi_9324_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e1567 = phi_9281_;
                                            let _e1569 = phi_9324_;
                                            let _e1572 = (bitcast<i32>(_e1569.member) != 0i);
                                            if _e1572 {
                                                phi_9284_ = (0.5lf * (_e1544 + (_e1535 / _e1544)));
                                            } else {
                                                phi_9284_ = f64();
                                            }
                                            let _e1577 = phi_9284_;
                                            continue;
                                            continuing {
                                                phi_9280_ = _e1567;
                                                phi_9283_ = _e1577;
                                                break if !(_e1572);
                                            }
                                        }
                                        let _e1582 = local_19;
                                        phi_9337_ = (_e1582 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e1589 = phi_9337_;
                                    let _e1591 = (1.1102230246251565e-16lf * f64(12f));
                                    let _e1598 = ((_e1433 * f64(1.01f)) + ((_e1204 * _e1589) * (f64(1f) + _e1591)));
                                    let _e1603 = (((_e1526 * _e1207[0]) + (_e1528 * _e1207[1])) + (_e1530 * _e1207[2]));
                                    let _e1608 = (((_e1526 * _e1223) + (_e1528 * _e1224)) + (_e1530 * _e1225));
                                    let _e1613 = (((_e1526 * _e1229) + (_e1528 * _e1230)) + (_e1530 * _e1231));
                                    let _e1618 = (((_e1526 * _e1226) + (_e1528 * _e1227)) + (_e1530 * _e1228));
                                    let _e1624 = (((_e1526 * _e1234[0]) + (_e1528 * _e1234[1])) + (_e1530 * _e1234[2]));
                                    let _e1629 = (((_e1526 * _e1250) + (_e1528 * _e1251)) + (_e1530 * _e1252));
                                    let _e1634 = (((_e1526 * _e1256) + (_e1528 * _e1257)) + (_e1530 * _e1258));
                                    let _e1639 = (((_e1526 * _e1253) + (_e1528 * _e1254)) + (_e1530 * _e1255));
                                    if (_e1603 < 0.0lf) {
                                        phi_9406_ = -(_e1603);
                                    } else {
                                        phi_9406_ = _e1603;
                                    }
                                    let _e1644 = phi_9406_;
                                    if (_e1624 < 0.0lf) {
                                        phi_9412_ = -(_e1624);
                                    } else {
                                        phi_9412_ = _e1624;
                                    }
                                    let _e1648 = phi_9412_;
                                    if (_e1608 < 0.0lf) {
                                        phi_9421_ = -(_e1608);
                                    } else {
                                        phi_9421_ = _e1608;
                                    }
                                    let _e1655 = phi_9421_;
                                    if (_e1629 < 0.0lf) {
                                        phi_9427_ = -(_e1629);
                                    } else {
                                        phi_9427_ = _e1629;
                                    }
                                    let _e1659 = phi_9427_;
                                    if (_e1613 < 0.0lf) {
                                        phi_9436_ = -(_e1613);
                                    } else {
                                        phi_9436_ = _e1613;
                                    }
                                    let _e1666 = phi_9436_;
                                    if (_e1634 < 0.0lf) {
                                        phi_9442_ = -(_e1634);
                                    } else {
                                        phi_9442_ = _e1634;
                                    }
                                    let _e1670 = phi_9442_;
                                    if (_e1618 < 0.0lf) {
                                        phi_9451_ = -(_e1618);
                                    } else {
                                        phi_9451_ = _e1618;
                                    }
                                    let _e1677 = phi_9451_;
                                    if (_e1639 < 0.0lf) {
                                        phi_9457_ = -(_e1639);
                                    } else {
                                        phi_9457_ = _e1639;
                                    }
                                    let _e1681 = phi_9457_;
                                    phi_9463_ = type_38(array<f64, 4>(_e1603, _e1608, _e1613, _e1618), array<f64, 4>(_e1624, _e1629, _e1634, _e1639), array<f64, 4>((_e1598 + ((_e1644 + _e1648) * _e1591)), (_e1598 + ((_e1655 + _e1659) * _e1591)), (_e1598 + ((_e1666 + _e1670) * _e1591)), (_e1598 + ((_e1677 + _e1681) * _e1591))));
                                    phi_9464_ = false;
                                } else {
                                    phi_9463_ = type_38();
                                    phi_9464_ = true;
                                }
                                let _e1688 = phi_9463_;
                                let _e1690 = phi_9464_;
                                phi_9465_ = _e1688;
                                phi_9466_ = _e1690;
                            } else {
                                phi_9465_ = type_38();
                                phi_9466_ = true;
                            }
                            let _e1692 = phi_9465_;
                            let _e1694 = phi_9466_;
                            if _e1694 {
                                let _e1695 = f64(0f);
                                let _e1696 = f64(1f);
                                phi_9476_ = type_38(array<f64, 4>(_e1695, _e1695, _e1695, _e1695), array<f64, 4>(_e1695, _e1695, _e1695, _e1695), array<f64, 4>(_e1696, _e1696, _e1696, _e1696));
                            } else {
                                phi_9476_ = _e1692;
                            }
                            let _e1702 = phi_9476_;
                            local_8 = type_38(array<f64, 4>(_e1702.member[0], _e1702.member[1], _e1702.member[2], _e1702.member[3]), array<f64, 4>(_e1702.member_1[0], _e1702.member_1[1], _e1702.member_1[2], _e1702.member_1[3]), array<f64, 4>(_e1702.member_2[0], _e1702.member_2[1], _e1702.member_2[2], _e1702.member_2[3]));
                            let _e1722 = f64(0f);
                            let _e1725 = local_8.member[0u];
                            let _e1728 = local_8.member_1[0u];
                            let _e1731 = local_8.member[0u];
                            let _e1737 = local_8.member_2[0u];
                            if (((_e1725 + ((_e1728 - _e1731) * _e430)) - _e1737) > _e1722) {
                                let _e1742 = local_8.member[1u];
                                let _e1745 = local_8.member_1[1u];
                                let _e1748 = local_8.member[1u];
                                let _e1754 = local_8.member_2[1u];
                                if (((_e1742 + ((_e1745 - _e1748) * _e430)) - _e1754) > _e1722) {
                                    let _e1759 = local_8.member[2u];
                                    let _e1762 = local_8.member_1[2u];
                                    let _e1765 = local_8.member[2u];
                                    let _e1771 = local_8.member_2[2u];
                                    if (((_e1759 + ((_e1762 - _e1765) * _e430)) - _e1771) > _e1722) {
                                        let _e1776 = local_8.member[3u];
                                        let _e1779 = local_8.member_1[3u];
                                        let _e1782 = local_8.member[3u];
                                        let _e1788 = local_8.member_2[3u];
                                        phi_9646_ = (((_e1776 + ((_e1779 - _e1782) * _e430)) - _e1788) > _e1722);
                                        phi_9647_ = false;
                                    } else {
                                        phi_9646_ = bool();
                                        phi_9647_ = true;
                                    }
                                    let _e1792 = phi_9646_;
                                    let _e1794 = phi_9647_;
                                    phi_9648_ = _e1792;
                                    phi_9649_ = _e1794;
                                } else {
                                    phi_9648_ = bool();
                                    phi_9649_ = true;
                                }
                                let _e1796 = phi_9648_;
                                let _e1798 = phi_9649_;
                                phi_9650_ = _e1796;
                                phi_9651_ = _e1798;
                            } else {
                                phi_9650_ = bool();
                                phi_9651_ = true;
                            }
                            let _e1800 = phi_9650_;
                            let _e1802 = phi_9651_;
                            if _e1802 {
                                phi_9655_ = false;
                            } else {
                                phi_9655_ = _e1800;
                            }
                            let _e1804 = phi_9655_;
                            if _e1804 {
                                phi_11036_ = bool();
                                phi_11037_ = true;
                            } else {
                                let _e1805 = f64(0f);
                                if (_e1500[0] < 0.0lf) {
                                    phi_9683_ = -(_e1500[0]);
                                } else {
                                    phi_9683_ = _e1500[0];
                                }
                                let _e1810 = phi_9683_;
                                if (_e1805 < 0.0lf) {
                                    phi_9689_ = -(_e1805);
                                } else {
                                    phi_9689_ = _e1805;
                                }
                                let _e1814 = phi_9689_;
                                if (_e1805 < 0.0lf) {
                                    phi_9696_ = -(_e1805);
                                } else {
                                    phi_9696_ = _e1805;
                                }
                                let _e1819 = phi_9696_;
                                let _e1820 = ((_e1810 + _e1814) + _e1819);
                                if (_e1820 > f64(0f)) {
                                    if ((bitcast<u64>(_e1820) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e1827 = (f64(1f) / _e1820);
                                        let _e1828 = (_e1500[0] * _e1827);
                                        let _e1829 = (_e1805 * _e1827);
                                        let _e1830 = (_e1805 * _e1827);
                                        let _e1835 = (((_e1828 * _e1828) + (_e1829 * _e1829)) + (_e1830 * _e1830));
                                        if (_e1835 <= 2.2250738585072014e-308lf) {
                                            if (_e1835 > 0.0lf) {
                                                phi_9732_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_9732_ = 0.0lf;
                                            }
                                            let _e1887 = phi_9732_;
                                            phi_9796_ = _e1887;
                                        } else {
                                            phi_9739_ = type_16(0i, 5i);
                                            phi_9742_ = bitcast<f64>(((bitcast<u64>(_e1835) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e1842 = phi_9739_;
                                                let _e1844 = phi_9742_;
                                                local_20 = _e1844;
                                                if (_e1842.member < _e1842.member_1) {
                                                    let _e1851 = (_e1842.member + 1i);
                                                    if ((false == (_e1851 > _e1842.member)) != false) {
                                                        phi_9763_ = true;
                                                    } else {
                                                        phi_9763_ = false;
                                                    }
                                                    let _e1856 = phi_9763_;
                                                    if _e1856 {
                                                        phi_9769_ = type_17(0u, type_17().member_1);
                                                    } else {
                                                        phi_9769_ = type_17(1u, _e1851);
                                                    }
                                                    let _e1861 = phi_9769_;
                                                    phi_9740_ = type_16(_e1861.member_1, _e1842.member_1);
                                                    phi_9783_ = type_17(1u, _e1842.member);
                                                } else {
                                                    phi_9740_ = _e1842;
                                                    phi_9783_ = type_17(0u, type_17().member_1);
                                                }
                                                let _e1867 = phi_9740_;
                                                let _e1869 = phi_9783_;
                                                let _e1872 = (bitcast<i32>(_e1869.member) != 0i);
                                                if _e1872 {
                                                    phi_9743_ = (0.5lf * (_e1844 + (_e1835 / _e1844)));
                                                } else {
                                                    phi_9743_ = f64();
                                                }
                                                let _e1877 = phi_9743_;
                                                continue;
                                                continuing {
                                                    phi_9739_ = _e1867;
                                                    phi_9742_ = _e1877;
                                                    break if !(_e1872);
                                                }
                                            }
                                            let _e1882 = local_20;
                                            phi_9796_ = (_e1882 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e1889 = phi_9796_;
                                        let _e1891 = (1.1102230246251565e-16lf * f64(12f));
                                        let _e1898 = ((_e1433 * f64(1.01f)) + ((_e1204 * _e1889) * (f64(1f) + _e1891)));
                                        let _e1903 = (((_e1828 * _e1207[0]) + (_e1829 * _e1207[1])) + (_e1830 * _e1207[2]));
                                        let _e1908 = (((_e1828 * _e1223) + (_e1829 * _e1224)) + (_e1830 * _e1225));
                                        let _e1913 = (((_e1828 * _e1229) + (_e1829 * _e1230)) + (_e1830 * _e1231));
                                        let _e1918 = (((_e1828 * _e1226) + (_e1829 * _e1227)) + (_e1830 * _e1228));
                                        let _e1924 = (((_e1828 * _e1234[0]) + (_e1829 * _e1234[1])) + (_e1830 * _e1234[2]));
                                        let _e1929 = (((_e1828 * _e1250) + (_e1829 * _e1251)) + (_e1830 * _e1252));
                                        let _e1934 = (((_e1828 * _e1256) + (_e1829 * _e1257)) + (_e1830 * _e1258));
                                        let _e1939 = (((_e1828 * _e1253) + (_e1829 * _e1254)) + (_e1830 * _e1255));
                                        if (_e1903 < 0.0lf) {
                                            phi_9865_ = -(_e1903);
                                        } else {
                                            phi_9865_ = _e1903;
                                        }
                                        let _e1944 = phi_9865_;
                                        if (_e1924 < 0.0lf) {
                                            phi_9871_ = -(_e1924);
                                        } else {
                                            phi_9871_ = _e1924;
                                        }
                                        let _e1948 = phi_9871_;
                                        if (_e1908 < 0.0lf) {
                                            phi_9880_ = -(_e1908);
                                        } else {
                                            phi_9880_ = _e1908;
                                        }
                                        let _e1955 = phi_9880_;
                                        if (_e1929 < 0.0lf) {
                                            phi_9886_ = -(_e1929);
                                        } else {
                                            phi_9886_ = _e1929;
                                        }
                                        let _e1959 = phi_9886_;
                                        if (_e1913 < 0.0lf) {
                                            phi_9895_ = -(_e1913);
                                        } else {
                                            phi_9895_ = _e1913;
                                        }
                                        let _e1966 = phi_9895_;
                                        if (_e1934 < 0.0lf) {
                                            phi_9901_ = -(_e1934);
                                        } else {
                                            phi_9901_ = _e1934;
                                        }
                                        let _e1970 = phi_9901_;
                                        if (_e1918 < 0.0lf) {
                                            phi_9910_ = -(_e1918);
                                        } else {
                                            phi_9910_ = _e1918;
                                        }
                                        let _e1977 = phi_9910_;
                                        if (_e1939 < 0.0lf) {
                                            phi_9916_ = -(_e1939);
                                        } else {
                                            phi_9916_ = _e1939;
                                        }
                                        let _e1981 = phi_9916_;
                                        phi_9922_ = type_38(array<f64, 4>(_e1903, _e1908, _e1913, _e1918), array<f64, 4>(_e1924, _e1929, _e1934, _e1939), array<f64, 4>((_e1898 + ((_e1944 + _e1948) * _e1891)), (_e1898 + ((_e1955 + _e1959) * _e1891)), (_e1898 + ((_e1966 + _e1970) * _e1891)), (_e1898 + ((_e1977 + _e1981) * _e1891))));
                                        phi_9923_ = false;
                                    } else {
                                        phi_9922_ = type_38();
                                        phi_9923_ = true;
                                    }
                                    let _e1988 = phi_9922_;
                                    let _e1990 = phi_9923_;
                                    phi_9924_ = _e1988;
                                    phi_9925_ = _e1990;
                                } else {
                                    phi_9924_ = type_38();
                                    phi_9925_ = true;
                                }
                                let _e1992 = phi_9924_;
                                let _e1994 = phi_9925_;
                                if _e1994 {
                                    let _e1995 = f64(0f);
                                    let _e1996 = f64(1f);
                                    phi_9935_ = type_38(array<f64, 4>(_e1995, _e1995, _e1995, _e1995), array<f64, 4>(_e1995, _e1995, _e1995, _e1995), array<f64, 4>(_e1996, _e1996, _e1996, _e1996));
                                } else {
                                    phi_9935_ = _e1992;
                                }
                                let _e2002 = phi_9935_;
                                local_9 = type_38(array<f64, 4>(_e2002.member[0], _e2002.member[1], _e2002.member[2], _e2002.member[3]), array<f64, 4>(_e2002.member_1[0], _e2002.member_1[1], _e2002.member_1[2], _e2002.member_1[3]), array<f64, 4>(_e2002.member_2[0], _e2002.member_2[1], _e2002.member_2[2], _e2002.member_2[3]));
                                let _e2022 = f64(0f);
                                let _e2025 = local_9.member[0u];
                                let _e2028 = local_9.member_1[0u];
                                let _e2031 = local_9.member[0u];
                                let _e2037 = local_9.member_2[0u];
                                if (((_e2025 + ((_e2028 - _e2031) * _e430)) - _e2037) > _e2022) {
                                    let _e2042 = local_9.member[1u];
                                    let _e2045 = local_9.member_1[1u];
                                    let _e2048 = local_9.member[1u];
                                    let _e2054 = local_9.member_2[1u];
                                    if (((_e2042 + ((_e2045 - _e2048) * _e430)) - _e2054) > _e2022) {
                                        let _e2059 = local_9.member[2u];
                                        let _e2062 = local_9.member_1[2u];
                                        let _e2065 = local_9.member[2u];
                                        let _e2071 = local_9.member_2[2u];
                                        if (((_e2059 + ((_e2062 - _e2065) * _e430)) - _e2071) > _e2022) {
                                            let _e2076 = local_9.member[3u];
                                            let _e2079 = local_9.member_1[3u];
                                            let _e2082 = local_9.member[3u];
                                            let _e2088 = local_9.member_2[3u];
                                            phi_10105_ = (((_e2076 + ((_e2079 - _e2082) * _e430)) - _e2088) > _e2022);
                                            phi_10106_ = false;
                                        } else {
                                            phi_10105_ = bool();
                                            phi_10106_ = true;
                                        }
                                        let _e2092 = phi_10105_;
                                        let _e2094 = phi_10106_;
                                        phi_10107_ = _e2092;
                                        phi_10108_ = _e2094;
                                    } else {
                                        phi_10107_ = bool();
                                        phi_10108_ = true;
                                    }
                                    let _e2096 = phi_10107_;
                                    let _e2098 = phi_10108_;
                                    phi_10109_ = _e2096;
                                    phi_10110_ = _e2098;
                                } else {
                                    phi_10109_ = bool();
                                    phi_10110_ = true;
                                }
                                let _e2100 = phi_10109_;
                                let _e2102 = phi_10110_;
                                if _e2102 {
                                    phi_10114_ = false;
                                } else {
                                    phi_10114_ = _e2100;
                                }
                                let _e2104 = phi_10114_;
                                if _e2104 {
                                    phi_11034_ = bool();
                                    phi_11035_ = true;
                                } else {
                                    let _e2105 = f64(0f);
                                    if (_e2105 < 0.0lf) {
                                        phi_10142_ = -(_e2105);
                                    } else {
                                        phi_10142_ = _e2105;
                                    }
                                    let _e2110 = phi_10142_;
                                    if (_e1500[1] < 0.0lf) {
                                        phi_10148_ = -(_e1500[1]);
                                    } else {
                                        phi_10148_ = _e1500[1];
                                    }
                                    let _e2114 = phi_10148_;
                                    if (_e2105 < 0.0lf) {
                                        phi_10155_ = -(_e2105);
                                    } else {
                                        phi_10155_ = _e2105;
                                    }
                                    let _e2119 = phi_10155_;
                                    let _e2120 = ((_e2110 + _e2114) + _e2119);
                                    if (_e2120 > f64(0f)) {
                                        if ((bitcast<u64>(_e2120) & 9218868437227405312lu) != 9218868437227405312lu) {
                                            let _e2127 = (f64(1f) / _e2120);
                                            let _e2128 = (_e2105 * _e2127);
                                            let _e2129 = (_e1500[1] * _e2127);
                                            let _e2130 = (_e2105 * _e2127);
                                            let _e2135 = (((_e2128 * _e2128) + (_e2129 * _e2129)) + (_e2130 * _e2130));
                                            if (_e2135 <= 2.2250738585072014e-308lf) {
                                                if (_e2135 > 0.0lf) {
                                                    phi_10191_ = (1.464336215552873e-154lf * 2.0lf);
                                                } else {
                                                    phi_10191_ = 0.0lf;
                                                }
                                                let _e2187 = phi_10191_;
                                                phi_10255_ = _e2187;
                                            } else {
                                                phi_10198_ = type_16(0i, 5i);
                                                phi_10201_ = bitcast<f64>(((bitcast<u64>(_e2135) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e2142 = phi_10198_;
                                                    let _e2144 = phi_10201_;
                                                    local_21 = _e2144;
                                                    if (_e2142.member < _e2142.member_1) {
                                                        let _e2151 = (_e2142.member + 1i);
                                                        if ((false == (_e2151 > _e2142.member)) != false) {
                                                            phi_10222_ = true;
                                                        } else {
                                                            phi_10222_ = false;
                                                        }
                                                        let _e2156 = phi_10222_;
                                                        if _e2156 {
                                                            phi_10228_ = type_17(0u, type_17().member_1);
                                                        } else {
                                                            phi_10228_ = type_17(1u, _e2151);
                                                        }
                                                        let _e2161 = phi_10228_;
                                                        phi_10199_ = type_16(_e2161.member_1, _e2142.member_1);
                                                        phi_10242_ = type_17(1u, _e2142.member);
                                                    } else {
                                                        phi_10199_ = _e2142;
                                                        phi_10242_ = type_17(0u, type_17().member_1);
                                                    }
                                                    let _e2167 = phi_10199_;
                                                    let _e2169 = phi_10242_;
                                                    let _e2172 = (bitcast<i32>(_e2169.member) != 0i);
                                                    if _e2172 {
                                                        phi_10202_ = (0.5lf * (_e2144 + (_e2135 / _e2144)));
                                                    } else {
                                                        phi_10202_ = f64();
                                                    }
                                                    let _e2177 = phi_10202_;
                                                    continue;
                                                    continuing {
                                                        phi_10198_ = _e2167;
                                                        phi_10201_ = _e2177;
                                                        break if !(_e2172);
                                                    }
                                                }
                                                let _e2182 = local_21;
                                                phi_10255_ = (_e2182 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e2189 = phi_10255_;
                                            let _e2191 = (1.1102230246251565e-16lf * f64(12f));
                                            let _e2198 = ((_e1433 * f64(1.01f)) + ((_e1204 * _e2189) * (f64(1f) + _e2191)));
                                            let _e2203 = (((_e2128 * _e1207[0]) + (_e2129 * _e1207[1])) + (_e2130 * _e1207[2]));
                                            let _e2208 = (((_e2128 * _e1223) + (_e2129 * _e1224)) + (_e2130 * _e1225));
                                            let _e2213 = (((_e2128 * _e1229) + (_e2129 * _e1230)) + (_e2130 * _e1231));
                                            let _e2218 = (((_e2128 * _e1226) + (_e2129 * _e1227)) + (_e2130 * _e1228));
                                            let _e2224 = (((_e2128 * _e1234[0]) + (_e2129 * _e1234[1])) + (_e2130 * _e1234[2]));
                                            let _e2229 = (((_e2128 * _e1250) + (_e2129 * _e1251)) + (_e2130 * _e1252));
                                            let _e2234 = (((_e2128 * _e1256) + (_e2129 * _e1257)) + (_e2130 * _e1258));
                                            let _e2239 = (((_e2128 * _e1253) + (_e2129 * _e1254)) + (_e2130 * _e1255));
                                            if (_e2203 < 0.0lf) {
                                                phi_10324_ = -(_e2203);
                                            } else {
                                                phi_10324_ = _e2203;
                                            }
                                            let _e2244 = phi_10324_;
                                            if (_e2224 < 0.0lf) {
                                                phi_10330_ = -(_e2224);
                                            } else {
                                                phi_10330_ = _e2224;
                                            }
                                            let _e2248 = phi_10330_;
                                            if (_e2208 < 0.0lf) {
                                                phi_10339_ = -(_e2208);
                                            } else {
                                                phi_10339_ = _e2208;
                                            }
                                            let _e2255 = phi_10339_;
                                            if (_e2229 < 0.0lf) {
                                                phi_10345_ = -(_e2229);
                                            } else {
                                                phi_10345_ = _e2229;
                                            }
                                            let _e2259 = phi_10345_;
                                            if (_e2213 < 0.0lf) {
                                                phi_10354_ = -(_e2213);
                                            } else {
                                                phi_10354_ = _e2213;
                                            }
                                            let _e2266 = phi_10354_;
                                            if (_e2234 < 0.0lf) {
                                                phi_10360_ = -(_e2234);
                                            } else {
                                                phi_10360_ = _e2234;
                                            }
                                            let _e2270 = phi_10360_;
                                            if (_e2218 < 0.0lf) {
                                                phi_10369_ = -(_e2218);
                                            } else {
                                                phi_10369_ = _e2218;
                                            }
                                            let _e2277 = phi_10369_;
                                            if (_e2239 < 0.0lf) {
                                                phi_10375_ = -(_e2239);
                                            } else {
                                                phi_10375_ = _e2239;
                                            }
                                            let _e2281 = phi_10375_;
                                            phi_10381_ = type_38(array<f64, 4>(_e2203, _e2208, _e2213, _e2218), array<f64, 4>(_e2224, _e2229, _e2234, _e2239), array<f64, 4>((_e2198 + ((_e2244 + _e2248) * _e2191)), (_e2198 + ((_e2255 + _e2259) * _e2191)), (_e2198 + ((_e2266 + _e2270) * _e2191)), (_e2198 + ((_e2277 + _e2281) * _e2191))));
                                            phi_10382_ = false;
                                        } else {
                                            phi_10381_ = type_38();
                                            phi_10382_ = true;
                                        }
                                        let _e2288 = phi_10381_;
                                        let _e2290 = phi_10382_;
                                        phi_10383_ = _e2288;
                                        phi_10384_ = _e2290;
                                    } else {
                                        phi_10383_ = type_38();
                                        phi_10384_ = true;
                                    }
                                    let _e2292 = phi_10383_;
                                    let _e2294 = phi_10384_;
                                    if _e2294 {
                                        let _e2295 = f64(0f);
                                        let _e2296 = f64(1f);
                                        phi_10394_ = type_38(array<f64, 4>(_e2295, _e2295, _e2295, _e2295), array<f64, 4>(_e2295, _e2295, _e2295, _e2295), array<f64, 4>(_e2296, _e2296, _e2296, _e2296));
                                    } else {
                                        phi_10394_ = _e2292;
                                    }
                                    let _e2302 = phi_10394_;
                                    local_10 = type_38(array<f64, 4>(_e2302.member[0], _e2302.member[1], _e2302.member[2], _e2302.member[3]), array<f64, 4>(_e2302.member_1[0], _e2302.member_1[1], _e2302.member_1[2], _e2302.member_1[3]), array<f64, 4>(_e2302.member_2[0], _e2302.member_2[1], _e2302.member_2[2], _e2302.member_2[3]));
                                    let _e2322 = f64(0f);
                                    let _e2325 = local_10.member[0u];
                                    let _e2328 = local_10.member_1[0u];
                                    let _e2331 = local_10.member[0u];
                                    let _e2337 = local_10.member_2[0u];
                                    if (((_e2325 + ((_e2328 - _e2331) * _e430)) - _e2337) > _e2322) {
                                        let _e2342 = local_10.member[1u];
                                        let _e2345 = local_10.member_1[1u];
                                        let _e2348 = local_10.member[1u];
                                        let _e2354 = local_10.member_2[1u];
                                        if (((_e2342 + ((_e2345 - _e2348) * _e430)) - _e2354) > _e2322) {
                                            let _e2359 = local_10.member[2u];
                                            let _e2362 = local_10.member_1[2u];
                                            let _e2365 = local_10.member[2u];
                                            let _e2371 = local_10.member_2[2u];
                                            if (((_e2359 + ((_e2362 - _e2365) * _e430)) - _e2371) > _e2322) {
                                                let _e2376 = local_10.member[3u];
                                                let _e2379 = local_10.member_1[3u];
                                                let _e2382 = local_10.member[3u];
                                                let _e2388 = local_10.member_2[3u];
                                                phi_10564_ = (((_e2376 + ((_e2379 - _e2382) * _e430)) - _e2388) > _e2322);
                                                phi_10565_ = false;
                                            } else {
                                                phi_10564_ = bool();
                                                phi_10565_ = true;
                                            }
                                            let _e2392 = phi_10564_;
                                            let _e2394 = phi_10565_;
                                            phi_10566_ = _e2392;
                                            phi_10567_ = _e2394;
                                        } else {
                                            phi_10566_ = bool();
                                            phi_10567_ = true;
                                        }
                                        let _e2396 = phi_10566_;
                                        let _e2398 = phi_10567_;
                                        phi_10568_ = _e2396;
                                        phi_10569_ = _e2398;
                                    } else {
                                        phi_10568_ = bool();
                                        phi_10569_ = true;
                                    }
                                    let _e2400 = phi_10568_;
                                    let _e2402 = phi_10569_;
                                    if _e2402 {
                                        phi_10573_ = false;
                                    } else {
                                        phi_10573_ = _e2400;
                                    }
                                    let _e2404 = phi_10573_;
                                    if _e2404 {
                                        phi_11033_ = bool();
                                    } else {
                                        let _e2405 = f64(0f);
                                        if (_e2405 < 0.0lf) {
                                            phi_10601_ = -(_e2405);
                                        } else {
                                            phi_10601_ = _e2405;
                                        }
                                        let _e2410 = phi_10601_;
                                        if (_e2405 < 0.0lf) {
                                            phi_10607_ = -(_e2405);
                                        } else {
                                            phi_10607_ = _e2405;
                                        }
                                        let _e2414 = phi_10607_;
                                        if (_e1500[2] < 0.0lf) {
                                            phi_10614_ = -(_e1500[2]);
                                        } else {
                                            phi_10614_ = _e1500[2];
                                        }
                                        let _e2419 = phi_10614_;
                                        let _e2420 = ((_e2410 + _e2414) + _e2419);
                                        if (_e2420 > f64(0f)) {
                                            if ((bitcast<u64>(_e2420) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e2427 = (f64(1f) / _e2420);
                                                let _e2428 = (_e2405 * _e2427);
                                                let _e2429 = (_e2405 * _e2427);
                                                let _e2430 = (_e1500[2] * _e2427);
                                                let _e2435 = (((_e2428 * _e2428) + (_e2429 * _e2429)) + (_e2430 * _e2430));
                                                if (_e2435 <= 2.2250738585072014e-308lf) {
                                                    if (_e2435 > 0.0lf) {
                                                        phi_10650_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_10650_ = 0.0lf;
                                                    }
                                                    let _e2487 = phi_10650_;
                                                    phi_10714_ = _e2487;
                                                } else {
                                                    phi_10657_ = type_16(0i, 5i);
                                                    phi_10660_ = bitcast<f64>(((bitcast<u64>(_e2435) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e2442 = phi_10657_;
                                                        let _e2444 = phi_10660_;
                                                        local_22 = _e2444;
                                                        if (_e2442.member < _e2442.member_1) {
                                                            let _e2451 = (_e2442.member + 1i);
                                                            if ((false == (_e2451 > _e2442.member)) != false) {
                                                                phi_10681_ = true;
                                                            } else {
                                                                phi_10681_ = false;
                                                            }
                                                            let _e2456 = phi_10681_;
                                                            if _e2456 {
                                                                phi_10687_ = type_17(0u, type_17().member_1);
                                                            } else {
                                                                phi_10687_ = type_17(1u, _e2451);
                                                            }
                                                            let _e2461 = phi_10687_;
                                                            phi_10658_ = type_16(_e2461.member_1, _e2442.member_1);
                                                            phi_10701_ = type_17(1u, _e2442.member);
                                                        } else {
                                                            phi_10658_ = _e2442;
                                                            phi_10701_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e2467 = phi_10658_;
                                                        let _e2469 = phi_10701_;
                                                        let _e2472 = (bitcast<i32>(_e2469.member) != 0i);
                                                        if _e2472 {
                                                            phi_10661_ = (0.5lf * (_e2444 + (_e2435 / _e2444)));
                                                        } else {
                                                            phi_10661_ = f64();
                                                        }
                                                        let _e2477 = phi_10661_;
                                                        continue;
                                                        continuing {
                                                            phi_10657_ = _e2467;
                                                            phi_10660_ = _e2477;
                                                            break if !(_e2472);
                                                        }
                                                    }
                                                    let _e2482 = local_22;
                                                    phi_10714_ = (_e2482 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e2489 = phi_10714_;
                                                let _e2491 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e2498 = ((_e1433 * f64(1.01f)) + ((_e1204 * _e2489) * (f64(1f) + _e2491)));
                                                let _e2503 = (((_e2428 * _e1207[0]) + (_e2429 * _e1207[1])) + (_e2430 * _e1207[2]));
                                                let _e2508 = (((_e2428 * _e1223) + (_e2429 * _e1224)) + (_e2430 * _e1225));
                                                let _e2513 = (((_e2428 * _e1229) + (_e2429 * _e1230)) + (_e2430 * _e1231));
                                                let _e2518 = (((_e2428 * _e1226) + (_e2429 * _e1227)) + (_e2430 * _e1228));
                                                let _e2524 = (((_e2428 * _e1234[0]) + (_e2429 * _e1234[1])) + (_e2430 * _e1234[2]));
                                                let _e2529 = (((_e2428 * _e1250) + (_e2429 * _e1251)) + (_e2430 * _e1252));
                                                let _e2534 = (((_e2428 * _e1256) + (_e2429 * _e1257)) + (_e2430 * _e1258));
                                                let _e2539 = (((_e2428 * _e1253) + (_e2429 * _e1254)) + (_e2430 * _e1255));
                                                if (_e2503 < 0.0lf) {
                                                    phi_10783_ = -(_e2503);
                                                } else {
                                                    phi_10783_ = _e2503;
                                                }
                                                let _e2544 = phi_10783_;
                                                if (_e2524 < 0.0lf) {
                                                    phi_10789_ = -(_e2524);
                                                } else {
                                                    phi_10789_ = _e2524;
                                                }
                                                let _e2548 = phi_10789_;
                                                if (_e2508 < 0.0lf) {
                                                    phi_10798_ = -(_e2508);
                                                } else {
                                                    phi_10798_ = _e2508;
                                                }
                                                let _e2555 = phi_10798_;
                                                if (_e2529 < 0.0lf) {
                                                    phi_10804_ = -(_e2529);
                                                } else {
                                                    phi_10804_ = _e2529;
                                                }
                                                let _e2559 = phi_10804_;
                                                if (_e2513 < 0.0lf) {
                                                    phi_10813_ = -(_e2513);
                                                } else {
                                                    phi_10813_ = _e2513;
                                                }
                                                let _e2566 = phi_10813_;
                                                if (_e2534 < 0.0lf) {
                                                    phi_10819_ = -(_e2534);
                                                } else {
                                                    phi_10819_ = _e2534;
                                                }
                                                let _e2570 = phi_10819_;
                                                if (_e2518 < 0.0lf) {
                                                    phi_10828_ = -(_e2518);
                                                } else {
                                                    phi_10828_ = _e2518;
                                                }
                                                let _e2577 = phi_10828_;
                                                if (_e2539 < 0.0lf) {
                                                    phi_10834_ = -(_e2539);
                                                } else {
                                                    phi_10834_ = _e2539;
                                                }
                                                let _e2581 = phi_10834_;
                                                phi_10840_ = type_38(array<f64, 4>(_e2503, _e2508, _e2513, _e2518), array<f64, 4>(_e2524, _e2529, _e2534, _e2539), array<f64, 4>((_e2498 + ((_e2544 + _e2548) * _e2491)), (_e2498 + ((_e2555 + _e2559) * _e2491)), (_e2498 + ((_e2566 + _e2570) * _e2491)), (_e2498 + ((_e2577 + _e2581) * _e2491))));
                                                phi_10841_ = false;
                                            } else {
                                                phi_10840_ = type_38();
                                                phi_10841_ = true;
                                            }
                                            let _e2588 = phi_10840_;
                                            let _e2590 = phi_10841_;
                                            phi_10842_ = _e2588;
                                            phi_10843_ = _e2590;
                                        } else {
                                            phi_10842_ = type_38();
                                            phi_10843_ = true;
                                        }
                                        let _e2592 = phi_10842_;
                                        let _e2594 = phi_10843_;
                                        if _e2594 {
                                            let _e2595 = f64(0f);
                                            let _e2596 = f64(1f);
                                            phi_10853_ = type_38(array<f64, 4>(_e2595, _e2595, _e2595, _e2595), array<f64, 4>(_e2595, _e2595, _e2595, _e2595), array<f64, 4>(_e2596, _e2596, _e2596, _e2596));
                                        } else {
                                            phi_10853_ = _e2592;
                                        }
                                        let _e2602 = phi_10853_;
                                        local_11 = type_38(array<f64, 4>(_e2602.member[0], _e2602.member[1], _e2602.member[2], _e2602.member[3]), array<f64, 4>(_e2602.member_1[0], _e2602.member_1[1], _e2602.member_1[2], _e2602.member_1[3]), array<f64, 4>(_e2602.member_2[0], _e2602.member_2[1], _e2602.member_2[2], _e2602.member_2[3]));
                                        let _e2622 = f64(0f);
                                        let _e2625 = local_11.member[0u];
                                        let _e2628 = local_11.member_1[0u];
                                        let _e2631 = local_11.member[0u];
                                        let _e2637 = local_11.member_2[0u];
                                        if (((_e2625 + ((_e2628 - _e2631) * _e430)) - _e2637) > _e2622) {
                                            let _e2642 = local_11.member[1u];
                                            let _e2645 = local_11.member_1[1u];
                                            let _e2648 = local_11.member[1u];
                                            let _e2654 = local_11.member_2[1u];
                                            if (((_e2642 + ((_e2645 - _e2648) * _e430)) - _e2654) > _e2622) {
                                                let _e2659 = local_11.member[2u];
                                                let _e2662 = local_11.member_1[2u];
                                                let _e2665 = local_11.member[2u];
                                                let _e2671 = local_11.member_2[2u];
                                                if (((_e2659 + ((_e2662 - _e2665) * _e430)) - _e2671) > _e2622) {
                                                    let _e2676 = local_11.member[3u];
                                                    let _e2679 = local_11.member_1[3u];
                                                    let _e2682 = local_11.member[3u];
                                                    let _e2688 = local_11.member_2[3u];
                                                    phi_11023_ = (((_e2676 + ((_e2679 - _e2682) * _e430)) - _e2688) > _e2622);
                                                    phi_11024_ = false;
                                                } else {
                                                    phi_11023_ = bool();
                                                    phi_11024_ = true;
                                                }
                                                let _e2692 = phi_11023_;
                                                let _e2694 = phi_11024_;
                                                phi_11025_ = _e2692;
                                                phi_11026_ = _e2694;
                                            } else {
                                                phi_11025_ = bool();
                                                phi_11026_ = true;
                                            }
                                            let _e2696 = phi_11025_;
                                            let _e2698 = phi_11026_;
                                            phi_11027_ = _e2696;
                                            phi_11028_ = _e2698;
                                        } else {
                                            phi_11027_ = bool();
                                            phi_11028_ = true;
                                        }
                                        let _e2700 = phi_11027_;
                                        let _e2702 = phi_11028_;
                                        if _e2702 {
                                            phi_11032_ = false;
                                        } else {
                                            phi_11032_ = _e2700;
                                        }
                                        let _e2704 = phi_11032_;
                                        phi_11033_ = _e2704;
                                    }
                                    let _e2706 = phi_11033_;
                                    phi_11034_ = _e2706;
                                    phi_11035_ = _e2404;
                                }
                                let _e2708 = phi_11034_;
                                let _e2710 = phi_11035_;
                                phi_11036_ = _e2708;
                                phi_11037_ = _e2710;
                            }
                            let _e2712 = phi_11036_;
                            let _e2714 = phi_11037_;
                            if _e2714 {
                                phi_11041_ = true;
                            } else {
                                phi_11041_ = _e2712;
                            }
                            let _e2716 = phi_11041_;
                            if !(_e2716) {
                                phi_11047_ = type_46(2u, _e430);
                                phi_11048_ = false;
                            } else {
                                phi_11047_ = type_46();
                                phi_11048_ = true;
                            }
                            let _e2720 = phi_11047_;
                            let _e2722 = phi_11048_;
                            phi_11049_ = _e2720;
                            phi_11050_ = _e2722;
                        } else {
                            phi_11049_ = type_46();
                            phi_11050_ = true;
                        }
                        let _e2724 = phi_11049_;
                        let _e2726 = phi_11050_;
                        if _e2726 {
                            let _e2727 = f64(0f);
                            let _e2728 = f64(1f);
                            let _e2729 = f64(3f);
                            let _e2735 = ((_e807 - (_e2729 * _e784)) * _e1178);
                            let _e2736 = ((_e830 - _e807) * _e1178);
                            let _e2737 = (((_e2729 * _e841) - _e830) * _e1178);
                            local_6[0u] = _e2727;
                            local_6[1u] = _e2728;
                            local_6[2u] = _e2728;
                            local_6[3u] = _e2728;
                            let _e2744 = ((_e2736 * _e2736) - (_e2735 * _e2737));
                            if (_e2744 > _e2727) {
                                if (_e2744 <= 2.2250738585072014e-308lf) {
                                    if (_e2744 > 0.0lf) {
                                        phi_11089_ = (1.464336215552873e-154lf * 2.0lf);
                                    } else {
                                        phi_11089_ = 0.0lf;
                                    }
                                    let _e2797 = phi_11089_;
                                    phi_11153_ = _e2797;
                                } else {
                                    phi_11096_ = type_16(0i, 5i);
                                    phi_11099_ = bitcast<f64>(((bitcast<u64>(_e2744) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e2752 = phi_11096_;
                                        let _e2754 = phi_11099_;
                                        local_23 = _e2754;
                                        if (_e2752.member < _e2752.member_1) {
                                            let _e2761 = (_e2752.member + 1i);
                                            if ((false == (_e2761 > _e2752.member)) != false) {
                                                phi_11120_ = true;
                                            } else {
                                                phi_11120_ = false;
                                            }
                                            let _e2766 = phi_11120_;
                                            if _e2766 {
                                                phi_11126_ = type_17(0u, type_17().member_1);
                                            } else {
                                                phi_11126_ = type_17(1u, _e2761);
                                            }
                                            let _e2771 = phi_11126_;
                                            phi_11097_ = type_16(_e2771.member_1, _e2752.member_1);
                                            phi_11140_ = type_17(1u, _e2752.member);
                                        } else {
                                            phi_11097_ = _e2752;
                                            phi_11140_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e2777 = phi_11097_;
                                        let _e2779 = phi_11140_;
                                        let _e2782 = (bitcast<i32>(_e2779.member) != 0i);
                                        if _e2782 {
                                            phi_11100_ = (0.5lf * (_e2754 + (_e2744 / _e2754)));
                                        } else {
                                            phi_11100_ = f64();
                                        }
                                        let _e2787 = phi_11100_;
                                        continue;
                                        continuing {
                                            phi_11096_ = _e2777;
                                            phi_11099_ = _e2787;
                                            break if !(_e2782);
                                        }
                                    }
                                    let _e2792 = local_23;
                                    phi_11153_ = (_e2792 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e2799 = phi_11153_;
                                if (_e2736 < _e2727) {
                                    phi_11159_ = -(_e2799);
                                } else {
                                    phi_11159_ = _e2799;
                                }
                                let _e2803 = phi_11159_;
                                let _e2805 = -((_e2736 + _e2803));
                                local_7[0u] = (_e2805 / (_e2805 + _e2737));
                                local_7[1u] = (_e2735 / (_e2735 + _e2805));
                                let _e2814 = local_7[1u];
                                let _e2815 = local_7[0u];
                                if (_e2814 < _e2815) {
                                    let _e2818 = local_7[1u];
                                    let _e2820 = local_7[0u];
                                    local_7[0u] = _e2818;
                                    local_7[1u] = _e2820;
                                }
                                phi_11184_ = type_12(0u, 2u);
                                phi_11187_ = 1u;
                                loop {
                                    let _e2824 = phi_11184_;
                                    let _e2826 = phi_11187_;
                                    local_64 = _e2826;
                                    if (_e2824.member < _e2824.member_1) {
                                        phi_11185_ = type_12((_e2824.member + 1u), _e2824.member_1);
                                        phi_11210_ = type_12(1u, _e2824.member);
                                    } else {
                                        phi_11185_ = _e2824;
                                        phi_11210_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e2838 = phi_11185_;
                                    let _e2840 = phi_11210_;
                                    let _e2844 = (bitcast<i32>(_e2840.member) != 0i);
                                    if _e2844 {
                                        let _e2846 = local_7[_e2840.member_1];
                                        if (_e2846 > _e2727) {
                                            let _e2849 = local_7[_e2840.member_1];
                                            if (_e2849 < _e2728) {
                                                let _e2852 = local_7[_e2840.member_1];
                                                local_6[_e2826] = _e2852;
                                                phi_11254_ = (_e2826 + 1u);
                                            } else {
                                                phi_11254_ = _e2826;
                                            }
                                            let _e2856 = phi_11254_;
                                            phi_11255_ = _e2856;
                                        } else {
                                            phi_11255_ = _e2826;
                                        }
                                        let _e2858 = phi_11255_;
                                        phi_11188_ = _e2858;
                                    } else {
                                        phi_11188_ = u32();
                                    }
                                    let _e2860 = phi_11188_;
                                    continue;
                                    continuing {
                                        phi_11184_ = _e2838;
                                        phi_11187_ = _e2860;
                                        break if !(_e2844);
                                    }
                                }
                                let _e10922 = local_64;
                                phi_11256_ = _e10922;
                            } else {
                                phi_11256_ = 1u;
                            }
                            let _e2863 = phi_11256_;
                            local_6[_e2863] = _e2728;
                            let _e2865 = local_6;
                            local_12 = _e2865;
                            phi_11276_ = type_12(0u, _e2863);
                            loop {
                                let _e2868 = phi_11276_;
                                if (_e2868.member < _e2868.member_1) {
                                    phi_11277_ = type_12((_e2868.member + 1u), _e2868.member_1);
                                    phi_11300_ = type_12(1u, _e2868.member);
                                } else {
                                    phi_11277_ = _e2868;
                                    phi_11300_ = type_12(0u, type_12().member_1);
                                }
                                let _e2880 = phi_11277_;
                                let _e2882 = phi_11300_;
                                if (bitcast<i32>(_e2882.member) != 0i) {
                                    let _e2888 = local_12[_e2882.member_1];
                                    if (_e2888 > _e430) {
                                        phi_11319_ = _e2888;
                                    } else {
                                        phi_11319_ = _e430;
                                    }
                                    let _e2891 = phi_11319_;
                                    let _e2894 = local_12[(_e2882.member_1 + 1u)];
                                    if (_e2894 < _e439) {
                                        phi_11332_ = _e2894;
                                    } else {
                                        phi_11332_ = _e439;
                                    }
                                    let _e2897 = phi_11332_;
                                    if (_e2891 <= _e2897) {
                                        let _e2900 = (f64(1f) - _e2891);
                                        let _e2911 = ((((_e784 * _e2900) + (_e807 * _e2891)) * (_e2900 * _e2900)) + (((_e830 * _e2900) + (_e841 * _e2891)) * (_e2891 * _e2891)));
                                        let _e2913 = (f64(1f) - _e2897);
                                        let _e2924 = ((((_e784 * _e2913) + (_e807 * _e2897)) * (_e2913 * _e2913)) + (((_e830 * _e2913) + (_e841 * _e2897)) * (_e2897 * _e2897)));
                                        if (_e2911 < 0.0lf) {
                                            phi_11368_ = -(_e2911);
                                        } else {
                                            phi_11368_ = _e2911;
                                        }
                                        let _e2928 = phi_11368_;
                                        let _e2929 = (_e2928 > _e1174);
                                        if (_e2924 < 0.0lf) {
                                            phi_11375_ = -(_e2924);
                                        } else {
                                            phi_11375_ = _e2924;
                                        }
                                        let _e2933 = phi_11375_;
                                        let _e2934 = (_e2933 > _e1174);
                                        let _e2935 = f64(0f);
                                        if _e2929 {
                                            if _e2934 {
                                                phi_11387_ = ((_e2911 > _e2935) != (_e2924 > _e2935));
                                                phi_11388_ = false;
                                            } else {
                                                phi_11387_ = bool();
                                                phi_11388_ = true;
                                            }
                                            let _e2940 = phi_11387_;
                                            let _e2942 = phi_11388_;
                                            phi_11389_ = _e2940;
                                            phi_11390_ = _e2942;
                                        } else {
                                            phi_11389_ = bool();
                                            phi_11390_ = true;
                                        }
                                        let _e2944 = phi_11389_;
                                        let _e2946 = phi_11390_;
                                        if _e2946 {
                                            phi_11394_ = false;
                                        } else {
                                            phi_11394_ = _e2944;
                                        }
                                        let _e2948 = phi_11394_;
                                        if _e2929 {
                                            if _e2934 {
                                                if _e2948 {
                                                    phi_11406_ = type_49();
                                                } else {
                                                    phi_11406_ = type_49(f64(1f), _e2935, _e2948);
                                                }
                                                let _e2952 = phi_11406_;
                                                phi_11407_ = _e2952;
                                                phi_11408_ = _e2948;
                                            } else {
                                                phi_11407_ = type_49();
                                                phi_11408_ = true;
                                            }
                                            let _e2954 = phi_11407_;
                                            let _e2956 = phi_11408_;
                                            phi_11409_ = _e2954;
                                            phi_11410_ = _e2956;
                                        } else {
                                            phi_11409_ = type_49();
                                            phi_11410_ = true;
                                        }
                                        let _e2958 = phi_11409_;
                                        let _e2960 = phi_11410_;
                                        if _e2960 {
                                            if _e2929 {
                                                if (_e2911 < _e2935) {
                                                    phi_11423_ = f64(-1f);
                                                } else {
                                                    phi_11423_ = f64(1f);
                                                }
                                                let _e2965 = phi_11423_;
                                                let _e2966 = f64(0.5f);
                                                let _e2967 = f64(3f);
                                                let _e2970 = (_e830 - _e807);
                                                phi_11435_ = type_12(0u, 64u);
                                                phi_11438_ = _e2897;
                                                phi_11440_ = _e2891;
                                                phi_11442_ = (_e2966 * (_e2891 + _e2897));
                                                loop {
                                                    let _e2976 = phi_11435_;
                                                    let _e2978 = phi_11438_;
                                                    let _e2980 = phi_11440_;
                                                    let _e2982 = phi_11442_;
                                                    local_66 = _e2980;
                                                    if (_e2976.member < _e2976.member_1) {
                                                        phi_11436_ = type_12((_e2976.member + 1u), _e2976.member_1);
                                                        phi_11465_ = type_12(1u, _e2976.member);
                                                    } else {
                                                        phi_11436_ = _e2976;
                                                        phi_11465_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e2994 = phi_11436_;
                                                    let _e2996 = phi_11465_;
                                                    if (bitcast<i32>(_e2996.member) != 0i) {
                                                        let _e3001 = (f64(1f) - _e2982);
                                                        let _e3014 = ((_e2965 * ((((_e784 * _e3001) + (_e807 * _e2982)) * (_e3001 * _e3001)) + (((_e830 * _e3001) + (_e841 * _e2982)) * (_e2982 * _e2982)))) - _e1174);
                                                        if (_e3014 > f64(0f)) {
                                                            phi_11492_ = _e2978;
                                                            phi_11493_ = _e2982;
                                                        } else {
                                                            phi_11492_ = _e2982;
                                                            phi_11493_ = _e2980;
                                                        }
                                                        let _e3018 = phi_11492_;
                                                        let _e3020 = phi_11493_;
                                                        let _e3022 = ((_e3018 - _e3020) > _e1184);
                                                        if _e3022 {
                                                            let _e3024 = (f64(1f) - _e2982);
                                                            let _e3036 = (-(_e3014) / (_e2965 * (((((_e807 - (_e2967 * _e784)) * _e3024) + (_e2970 * _e2982)) * _e3024) + (((_e2970 * _e3024) + (((_e2967 * _e841) - _e830) * _e2982)) * _e2982))));
                                                            if (_e3014 > f64(0f)) {
                                                                phi_11521_ = (_e2966 * _e1184);
                                                            } else {
                                                                phi_11521_ = -((_e2966 * _e1184));
                                                            }
                                                            let _e3043 = phi_11521_;
                                                            let _e3045 = ((_e2982 + _e3036) + _e3043);
                                                            if (_e3045 > _e3020) {
                                                                if (_e3045 < _e3018) {
                                                                    if (_e3036 < 0.0lf) {
                                                                        phi_11537_ = -(_e3036);
                                                                    } else {
                                                                        phi_11537_ = _e3036;
                                                                    }
                                                                    let _e3051 = phi_11537_;
                                                                    if (_e3051 < (_e2966 * (_e3018 - _e3020))) {
                                                                        phi_11544_ = false;
                                                                    } else {
                                                                        phi_11544_ = true;
                                                                    }
                                                                    let _e3056 = phi_11544_;
                                                                    phi_11545_ = _e3056;
                                                                } else {
                                                                    phi_11545_ = true;
                                                                }
                                                                let _e3058 = phi_11545_;
                                                                phi_11546_ = _e3058;
                                                            } else {
                                                                phi_11546_ = true;
                                                            }
                                                            let _e3060 = phi_11546_;
                                                            if _e3060 {
                                                                phi_11552_ = (_e2966 * (_e3020 + _e3018));
                                                            } else {
                                                                phi_11552_ = _e3045;
                                                            }
                                                            let _e3064 = phi_11552_;
                                                            phi_11553_ = _e3064;
                                                            phi_11554_ = false;
                                                        } else {
                                                            phi_11553_ = f64();
                                                            phi_11554_ = true;
                                                        }
                                                        let _e3066 = phi_11553_;
                                                        let _e3068 = phi_11554_;
                                                        phi_11439_ = _e3018;
                                                        phi_11441_ = _e3020;
                                                        phi_11443_ = _e3066;
                                                        phi_11555_ = _e3020;
                                                        phi_11556_ = _e3022;
                                                        phi_11557_ = _e3068;
                                                    } else {
                                                        phi_11439_ = f64();
                                                        phi_11441_ = f64();
                                                        phi_11443_ = f64();
                                                        phi_11555_ = f64();
                                                        phi_11556_ = false;
                                                        phi_11557_ = false;
                                                    }
                                                    let _e3070 = phi_11439_;
                                                    let _e3072 = phi_11441_;
                                                    let _e3074 = phi_11443_;
                                                    let _e3076 = phi_11555_;
                                                    let _e3078 = phi_11556_;
                                                    let _e3080 = phi_11557_;
                                                    local_24 = _e3080;
                                                    local_65 = _e3076;
                                                    continue;
                                                    continuing {
                                                        phi_11435_ = _e2994;
                                                        phi_11438_ = _e3070;
                                                        phi_11440_ = _e3072;
                                                        phi_11442_ = _e3074;
                                                        break if !(_e3078);
                                                    }
                                                }
                                                let _e3083 = local_24;
                                                if _e3083 {
                                                    let _e10966 = local_65;
                                                    phi_11561_ = _e10966;
                                                } else {
                                                    let _e10968 = local_66;
                                                    phi_11561_ = _e10968;
                                                }
                                                let _e3085 = phi_11561_;
                                                phi_11562_ = _e3085;
                                            } else {
                                                phi_11562_ = _e2891;
                                            }
                                            let _e3087 = phi_11562_;
                                            if _e2934 {
                                                if (_e2924 < _e2935) {
                                                    phi_11572_ = f64(-1f);
                                                } else {
                                                    phi_11572_ = f64(1f);
                                                }
                                                let _e3092 = phi_11572_;
                                                phi_11576_ = type_12(0u, 64u);
                                                phi_11579_ = (_e1184 + _e1184);
                                                loop {
                                                    let _e3095 = phi_11576_;
                                                    let _e3097 = phi_11579_;
                                                    if (_e3095.member < _e3095.member_1) {
                                                        phi_11577_ = type_12((_e3095.member + 1u), _e3095.member_1);
                                                        phi_11602_ = type_12(1u, _e3095.member);
                                                    } else {
                                                        phi_11577_ = _e3095;
                                                        phi_11602_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e3109 = phi_11577_;
                                                    let _e3111 = phi_11602_;
                                                    if (bitcast<i32>(_e3111.member) != 0i) {
                                                        let _e3115 = (_e3087 + _e3097);
                                                        if (_e3115 < _e2897) {
                                                            let _e3118 = (f64(1f) - _e3115);
                                                            let _e3131 = ((_e3092 * ((((_e784 * _e3118) + (_e807 * _e3115)) * (_e3118 * _e3118)) + (((_e830 * _e3118) + (_e841 * _e3115)) * (_e3115 * _e3115)))) > _e1174);
                                                            if _e3131 {
                                                                phi_11633_ = f64();
                                                                phi_11634_ = false;
                                                            } else {
                                                                phi_11633_ = (_e3097 + _e3097);
                                                                phi_11634_ = true;
                                                            }
                                                            let _e3134 = phi_11633_;
                                                            let _e3136 = phi_11634_;
                                                            phi_11635_ = _e3134;
                                                            phi_11636_ = _e3136;
                                                            phi_11637_ = _e3131;
                                                            phi_11638_ = false;
                                                        } else {
                                                            phi_11635_ = f64();
                                                            phi_11636_ = false;
                                                            phi_11637_ = false;
                                                            phi_11638_ = true;
                                                        }
                                                        let _e3138 = phi_11635_;
                                                        let _e3140 = phi_11636_;
                                                        let _e3142 = phi_11637_;
                                                        let _e3144 = phi_11638_;
                                                        phi_11639_ = _e3115;
                                                        phi_11580_ = _e3138;
                                                        phi_11640_ = _e3140;
                                                        phi_11641_ = _e3142;
                                                        phi_11642_ = _e3144;
                                                        phi_11643_ = false;
                                                    } else {
                                                        phi_11639_ = f64();
                                                        phi_11580_ = f64();
                                                        phi_11640_ = false;
                                                        phi_11641_ = false;
                                                        phi_11642_ = false;
                                                        phi_11643_ = true;
                                                    }
                                                    let _e3146 = phi_11639_;
                                                    let _e3148 = phi_11580_;
                                                    let _e3150 = phi_11640_;
                                                    let _e3152 = phi_11641_;
                                                    let _e3154 = phi_11642_;
                                                    let _e3156 = phi_11643_;
                                                    local_25 = _e3152;
                                                    local_67 = _e3154;
                                                    local_68 = _e3156;
                                                    local_69 = _e3146;
                                                    continue;
                                                    continuing {
                                                        phi_11576_ = _e3109;
                                                        phi_11579_ = _e3148;
                                                        break if !(_e3150);
                                                    }
                                                }
                                                let _e3159 = local_25;
                                                if _e3159 {
                                                    phi_11647_ = false;
                                                    phi_11648_ = false;
                                                } else {
                                                    let _e10990 = local_67;
                                                    phi_11647_ = _e10990;
                                                    let _e10993 = local_68;
                                                    phi_11648_ = _e10993;
                                                }
                                                let _e3161 = phi_11647_;
                                                let _e3163 = phi_11648_;
                                                if _e3161 {
                                                    phi_11652_ = true;
                                                } else {
                                                    phi_11652_ = _e3163;
                                                }
                                                let _e3165 = phi_11652_;
                                                if _e3165 {
                                                    phi_11656_ = _e2897;
                                                } else {
                                                    let _e10997 = local_69;
                                                    phi_11656_ = _e10997;
                                                }
                                                let _e3167 = phi_11656_;
                                                phi_11657_ = _e3167;
                                            } else {
                                                phi_11657_ = _e2897;
                                            }
                                            let _e3169 = phi_11657_;
                                            phi_11659_ = type_49(_e3087, _e3169, _e2948);
                                        } else {
                                            phi_11659_ = _e2958;
                                        }
                                        let _e3172 = phi_11659_;
                                        if (_e3172.member > _e3172.member_1) {
                                            phi_15526_ = bool();
                                            phi_15527_ = f64();
                                            phi_15528_ = f64();
                                            phi_15529_ = true;
                                            phi_15530_ = false;
                                            phi_15531_ = false;
                                            phi_15532_ = false;
                                        } else {
                                            let _e3180 = ((_e3172.member_1 - _e3172.member) * f64(0.5f));
                                            let _e3181 = (_e3172.member + _e3180);
                                            let _e3184 = (_e3180 + (1.1102230246251565e-16lf * f64(4f)));
                                            let _e3186 = local_18.member_3;
                                            let _e3189 = local_18.member[0u];
                                            if (_e3189[0] < 0.0lf) {
                                                phi_11690_ = -(_e3189[0]);
                                            } else {
                                                phi_11690_ = _e3189[0];
                                            }
                                            let _e3196 = phi_11690_;
                                            if (_e3189[1] < 0.0lf) {
                                                phi_11697_ = -(_e3189[1]);
                                            } else {
                                                phi_11697_ = _e3189[1];
                                            }
                                            let _e3200 = phi_11697_;
                                            if (_e3196 > _e3200) {
                                                phi_11702_ = _e3196;
                                            } else {
                                                phi_11702_ = _e3200;
                                            }
                                            let _e3203 = phi_11702_;
                                            if (_e3189[2] < 0.0lf) {
                                                phi_11709_ = -(_e3189[2]);
                                            } else {
                                                phi_11709_ = _e3189[2];
                                            }
                                            let _e3207 = phi_11709_;
                                            if (_e3203 > _e3207) {
                                                phi_11714_ = _e3203;
                                            } else {
                                                phi_11714_ = _e3207;
                                            }
                                            let _e3210 = phi_11714_;
                                            let _e3212 = local_18.member[1u];
                                            if (_e3212[0] < 0.0lf) {
                                                phi_11727_ = -(_e3212[0]);
                                            } else {
                                                phi_11727_ = _e3212[0];
                                            }
                                            let _e3219 = phi_11727_;
                                            if (_e3212[1] < 0.0lf) {
                                                phi_11734_ = -(_e3212[1]);
                                            } else {
                                                phi_11734_ = _e3212[1];
                                            }
                                            let _e3223 = phi_11734_;
                                            if (_e3219 > _e3223) {
                                                phi_11739_ = _e3219;
                                            } else {
                                                phi_11739_ = _e3223;
                                            }
                                            let _e3226 = phi_11739_;
                                            if (_e3212[2] < 0.0lf) {
                                                phi_11746_ = -(_e3212[2]);
                                            } else {
                                                phi_11746_ = _e3212[2];
                                            }
                                            let _e3230 = phi_11746_;
                                            if (_e3226 > _e3230) {
                                                phi_11751_ = _e3226;
                                            } else {
                                                phi_11751_ = _e3230;
                                            }
                                            let _e3233 = phi_11751_;
                                            if (_e3210 > _e3233) {
                                                phi_11756_ = _e3210;
                                            } else {
                                                phi_11756_ = _e3233;
                                            }
                                            let _e3236 = phi_11756_;
                                            let _e3239 = local_18.member[0u];
                                            let _e3244 = local_18.member[1u];
                                            let _e3254 = (_e3239[0] + ((_e3244[0] - _e3239[0]) * _e3181));
                                            let _e3255 = (_e3239[1] + ((_e3244[1] - _e3239[1]) * _e3181));
                                            let _e3256 = (_e3239[2] + ((_e3244[2] - _e3239[2]) * _e3181));
                                            let _e3258 = local_18.member[1u];
                                            let _e3263 = local_18.member[0u];
                                            let _e3267 = (_e3258[0] - _e3263[0]);
                                            let _e3268 = (_e3258[1] - _e3263[1]);
                                            let _e3269 = (_e3258[2] - _e3263[2]);
                                            if (_e3267 < 0.0lf) {
                                                phi_11815_ = -(_e3267);
                                            } else {
                                                phi_11815_ = _e3267;
                                            }
                                            let _e3273 = phi_11815_;
                                            if (_e3268 < 0.0lf) {
                                                phi_11821_ = -(_e3268);
                                            } else {
                                                phi_11821_ = _e3268;
                                            }
                                            let _e3277 = phi_11821_;
                                            if (_e3273 > _e3277) {
                                                phi_11826_ = _e3273;
                                            } else {
                                                phi_11826_ = _e3277;
                                            }
                                            let _e3280 = phi_11826_;
                                            if (_e3269 < 0.0lf) {
                                                phi_11832_ = -(_e3269);
                                            } else {
                                                phi_11832_ = _e3269;
                                            }
                                            let _e3284 = phi_11832_;
                                            if (_e3280 > _e3284) {
                                                phi_11837_ = _e3280;
                                            } else {
                                                phi_11837_ = _e3284;
                                            }
                                            let _e3287 = phi_11837_;
                                            let _e3295 = ((((_e3184 * _e3287) * f64(1.01f)) + ((_e3236 + _e3186) * (1.1102230246251565e-16lf * f64(8f)))) + _e3186);
                                            if (_e3254 < 0.0lf) {
                                                phi_11851_ = -(_e3254);
                                            } else {
                                                phi_11851_ = _e3254;
                                            }
                                            let _e3299 = phi_11851_;
                                            if (_e3255 < 0.0lf) {
                                                phi_11857_ = -(_e3255);
                                            } else {
                                                phi_11857_ = _e3255;
                                            }
                                            let _e3303 = phi_11857_;
                                            if (_e3299 > _e3303) {
                                                phi_11862_ = _e3299;
                                            } else {
                                                phi_11862_ = _e3303;
                                            }
                                            let _e3306 = phi_11862_;
                                            if (_e3256 < 0.0lf) {
                                                phi_11868_ = -(_e3256);
                                            } else {
                                                phi_11868_ = _e3256;
                                            }
                                            let _e3310 = phi_11868_;
                                            if (_e3306 > _e3310) {
                                                phi_11873_ = _e3306;
                                            } else {
                                                phi_11873_ = _e3310;
                                            }
                                            let _e3313 = phi_11873_;
                                            local_2 = type_39(array<f64, 3>(_e3254, _e3255, _e3256), _e3295, (_e3313 + _e3295));
                                            let _e3319 = local_18.member_3;
                                            let _e3321 = local_18.member_1[0u];
                                            if (_e3321[0] < 0.0lf) {
                                                phi_11899_ = -(_e3321[0]);
                                            } else {
                                                phi_11899_ = _e3321[0];
                                            }
                                            let _e3328 = phi_11899_;
                                            if (_e3321[1] < 0.0lf) {
                                                phi_11906_ = -(_e3321[1]);
                                            } else {
                                                phi_11906_ = _e3321[1];
                                            }
                                            let _e3332 = phi_11906_;
                                            if (_e3328 > _e3332) {
                                                phi_11911_ = _e3328;
                                            } else {
                                                phi_11911_ = _e3332;
                                            }
                                            let _e3335 = phi_11911_;
                                            if (_e3321[2] < 0.0lf) {
                                                phi_11918_ = -(_e3321[2]);
                                            } else {
                                                phi_11918_ = _e3321[2];
                                            }
                                            let _e3339 = phi_11918_;
                                            if (_e3335 > _e3339) {
                                                phi_11923_ = _e3335;
                                            } else {
                                                phi_11923_ = _e3339;
                                            }
                                            let _e3342 = phi_11923_;
                                            let _e3344 = local_18.member_1[1u];
                                            if (_e3344[0] < 0.0lf) {
                                                phi_11936_ = -(_e3344[0]);
                                            } else {
                                                phi_11936_ = _e3344[0];
                                            }
                                            let _e3351 = phi_11936_;
                                            if (_e3344[1] < 0.0lf) {
                                                phi_11943_ = -(_e3344[1]);
                                            } else {
                                                phi_11943_ = _e3344[1];
                                            }
                                            let _e3355 = phi_11943_;
                                            if (_e3351 > _e3355) {
                                                phi_11948_ = _e3351;
                                            } else {
                                                phi_11948_ = _e3355;
                                            }
                                            let _e3358 = phi_11948_;
                                            if (_e3344[2] < 0.0lf) {
                                                phi_11955_ = -(_e3344[2]);
                                            } else {
                                                phi_11955_ = _e3344[2];
                                            }
                                            let _e3362 = phi_11955_;
                                            if (_e3358 > _e3362) {
                                                phi_11960_ = _e3358;
                                            } else {
                                                phi_11960_ = _e3362;
                                            }
                                            let _e3365 = phi_11960_;
                                            if (_e3342 > _e3365) {
                                                phi_11965_ = _e3342;
                                            } else {
                                                phi_11965_ = _e3365;
                                            }
                                            let _e3368 = phi_11965_;
                                            let _e3371 = local_18.member_1[0u];
                                            let _e3376 = local_18.member_1[1u];
                                            let _e3386 = (_e3371[0] + ((_e3376[0] - _e3371[0]) * _e3181));
                                            let _e3387 = (_e3371[1] + ((_e3376[1] - _e3371[1]) * _e3181));
                                            let _e3388 = (_e3371[2] + ((_e3376[2] - _e3371[2]) * _e3181));
                                            let _e3390 = local_18.member_1[1u];
                                            let _e3395 = local_18.member_1[0u];
                                            let _e3399 = (_e3390[0] - _e3395[0]);
                                            let _e3400 = (_e3390[1] - _e3395[1]);
                                            let _e3401 = (_e3390[2] - _e3395[2]);
                                            if (_e3399 < 0.0lf) {
                                                phi_12024_ = -(_e3399);
                                            } else {
                                                phi_12024_ = _e3399;
                                            }
                                            let _e3405 = phi_12024_;
                                            if (_e3400 < 0.0lf) {
                                                phi_12030_ = -(_e3400);
                                            } else {
                                                phi_12030_ = _e3400;
                                            }
                                            let _e3409 = phi_12030_;
                                            if (_e3405 > _e3409) {
                                                phi_12035_ = _e3405;
                                            } else {
                                                phi_12035_ = _e3409;
                                            }
                                            let _e3412 = phi_12035_;
                                            if (_e3401 < 0.0lf) {
                                                phi_12041_ = -(_e3401);
                                            } else {
                                                phi_12041_ = _e3401;
                                            }
                                            let _e3416 = phi_12041_;
                                            if (_e3412 > _e3416) {
                                                phi_12046_ = _e3412;
                                            } else {
                                                phi_12046_ = _e3416;
                                            }
                                            let _e3419 = phi_12046_;
                                            let _e3427 = ((((_e3184 * _e3419) * f64(1.01f)) + ((_e3368 + _e3319) * (1.1102230246251565e-16lf * f64(8f)))) + _e3319);
                                            if (_e3386 < 0.0lf) {
                                                phi_12060_ = -(_e3386);
                                            } else {
                                                phi_12060_ = _e3386;
                                            }
                                            let _e3431 = phi_12060_;
                                            if (_e3387 < 0.0lf) {
                                                phi_12066_ = -(_e3387);
                                            } else {
                                                phi_12066_ = _e3387;
                                            }
                                            let _e3435 = phi_12066_;
                                            if (_e3431 > _e3435) {
                                                phi_12071_ = _e3431;
                                            } else {
                                                phi_12071_ = _e3435;
                                            }
                                            let _e3438 = phi_12071_;
                                            if (_e3388 < 0.0lf) {
                                                phi_12077_ = -(_e3388);
                                            } else {
                                                phi_12077_ = _e3388;
                                            }
                                            let _e3442 = phi_12077_;
                                            if (_e3438 > _e3442) {
                                                phi_12082_ = _e3438;
                                            } else {
                                                phi_12082_ = _e3442;
                                            }
                                            let _e3445 = phi_12082_;
                                            local_3 = type_39(array<f64, 3>(_e3386, _e3387, _e3388), _e3427, (_e3445 + _e3427));
                                            let _e3451 = local_18.member_3;
                                            let _e3453 = local_18.member_2[0u];
                                            if (_e3453[0] < 0.0lf) {
                                                phi_12108_ = -(_e3453[0]);
                                            } else {
                                                phi_12108_ = _e3453[0];
                                            }
                                            let _e3460 = phi_12108_;
                                            if (_e3453[1] < 0.0lf) {
                                                phi_12115_ = -(_e3453[1]);
                                            } else {
                                                phi_12115_ = _e3453[1];
                                            }
                                            let _e3464 = phi_12115_;
                                            if (_e3460 > _e3464) {
                                                phi_12120_ = _e3460;
                                            } else {
                                                phi_12120_ = _e3464;
                                            }
                                            let _e3467 = phi_12120_;
                                            if (_e3453[2] < 0.0lf) {
                                                phi_12127_ = -(_e3453[2]);
                                            } else {
                                                phi_12127_ = _e3453[2];
                                            }
                                            let _e3471 = phi_12127_;
                                            if (_e3467 > _e3471) {
                                                phi_12132_ = _e3467;
                                            } else {
                                                phi_12132_ = _e3471;
                                            }
                                            let _e3474 = phi_12132_;
                                            let _e3476 = local_18.member_2[1u];
                                            if (_e3476[0] < 0.0lf) {
                                                phi_12145_ = -(_e3476[0]);
                                            } else {
                                                phi_12145_ = _e3476[0];
                                            }
                                            let _e3483 = phi_12145_;
                                            if (_e3476[1] < 0.0lf) {
                                                phi_12152_ = -(_e3476[1]);
                                            } else {
                                                phi_12152_ = _e3476[1];
                                            }
                                            let _e3487 = phi_12152_;
                                            if (_e3483 > _e3487) {
                                                phi_12157_ = _e3483;
                                            } else {
                                                phi_12157_ = _e3487;
                                            }
                                            let _e3490 = phi_12157_;
                                            if (_e3476[2] < 0.0lf) {
                                                phi_12164_ = -(_e3476[2]);
                                            } else {
                                                phi_12164_ = _e3476[2];
                                            }
                                            let _e3494 = phi_12164_;
                                            if (_e3490 > _e3494) {
                                                phi_12169_ = _e3490;
                                            } else {
                                                phi_12169_ = _e3494;
                                            }
                                            let _e3497 = phi_12169_;
                                            if (_e3474 > _e3497) {
                                                phi_12174_ = _e3474;
                                            } else {
                                                phi_12174_ = _e3497;
                                            }
                                            let _e3500 = phi_12174_;
                                            let _e3503 = local_18.member_2[0u];
                                            let _e3508 = local_18.member_2[1u];
                                            let _e3518 = (_e3503[0] + ((_e3508[0] - _e3503[0]) * _e3181));
                                            let _e3519 = (_e3503[1] + ((_e3508[1] - _e3503[1]) * _e3181));
                                            let _e3520 = (_e3503[2] + ((_e3508[2] - _e3503[2]) * _e3181));
                                            let _e3522 = local_18.member_2[1u];
                                            let _e3527 = local_18.member_2[0u];
                                            let _e3531 = (_e3522[0] - _e3527[0]);
                                            let _e3532 = (_e3522[1] - _e3527[1]);
                                            let _e3533 = (_e3522[2] - _e3527[2]);
                                            if (_e3531 < 0.0lf) {
                                                phi_12233_ = -(_e3531);
                                            } else {
                                                phi_12233_ = _e3531;
                                            }
                                            let _e3537 = phi_12233_;
                                            if (_e3532 < 0.0lf) {
                                                phi_12239_ = -(_e3532);
                                            } else {
                                                phi_12239_ = _e3532;
                                            }
                                            let _e3541 = phi_12239_;
                                            if (_e3537 > _e3541) {
                                                phi_12244_ = _e3537;
                                            } else {
                                                phi_12244_ = _e3541;
                                            }
                                            let _e3544 = phi_12244_;
                                            if (_e3533 < 0.0lf) {
                                                phi_12250_ = -(_e3533);
                                            } else {
                                                phi_12250_ = _e3533;
                                            }
                                            let _e3548 = phi_12250_;
                                            if (_e3544 > _e3548) {
                                                phi_12255_ = _e3544;
                                            } else {
                                                phi_12255_ = _e3548;
                                            }
                                            let _e3551 = phi_12255_;
                                            let _e3559 = ((((_e3184 * _e3551) * f64(1.01f)) + ((_e3500 + _e3451) * (1.1102230246251565e-16lf * f64(8f)))) + _e3451);
                                            if (_e3518 < 0.0lf) {
                                                phi_12269_ = -(_e3518);
                                            } else {
                                                phi_12269_ = _e3518;
                                            }
                                            let _e3563 = phi_12269_;
                                            if (_e3519 < 0.0lf) {
                                                phi_12275_ = -(_e3519);
                                            } else {
                                                phi_12275_ = _e3519;
                                            }
                                            let _e3567 = phi_12275_;
                                            if (_e3563 > _e3567) {
                                                phi_12280_ = _e3563;
                                            } else {
                                                phi_12280_ = _e3567;
                                            }
                                            let _e3570 = phi_12280_;
                                            if (_e3520 < 0.0lf) {
                                                phi_12286_ = -(_e3520);
                                            } else {
                                                phi_12286_ = _e3520;
                                            }
                                            let _e3574 = phi_12286_;
                                            if (_e3570 > _e3574) {
                                                phi_12291_ = _e3570;
                                            } else {
                                                phi_12291_ = _e3574;
                                            }
                                            let _e3577 = phi_12291_;
                                            local_4 = type_39(array<f64, 3>(_e3518, _e3519, _e3520), _e3559, (_e3577 + _e3559));
                                            let _e3582 = local_3.member;
                                            let _e3587 = local_4.member;
                                            let _e3593 = ((_e3582[1] * _e3587[2]) - (_e3582[2] * _e3587[1]));
                                            let _e3596 = ((_e3582[2] * _e3587[0]) - (_e3582[0] * _e3587[2]));
                                            let _e3599 = ((_e3582[0] * _e3587[1]) - (_e3582[1] * _e3587[0]));
                                            if (_e3593 < 0.0lf) {
                                                phi_12340_ = -(_e3593);
                                            } else {
                                                phi_12340_ = _e3593;
                                            }
                                            let _e3603 = phi_12340_;
                                            if (_e3596 < 0.0lf) {
                                                phi_12346_ = -(_e3596);
                                            } else {
                                                phi_12346_ = _e3596;
                                            }
                                            let _e3607 = phi_12346_;
                                            if (_e3603 > _e3607) {
                                                if (_e3593 < 0.0lf) {
                                                    phi_12356_ = -(_e3593);
                                                } else {
                                                    phi_12356_ = _e3593;
                                                }
                                                let _e3625 = phi_12356_;
                                                if (_e3599 < 0.0lf) {
                                                    phi_12362_ = -(_e3599);
                                                } else {
                                                    phi_12362_ = _e3599;
                                                }
                                                let _e3629 = phi_12362_;
                                                if (_e3625 > _e3629) {
                                                    phi_12367_ = 2u;
                                                    phi_12368_ = 1u;
                                                } else {
                                                    phi_12367_ = 1u;
                                                    phi_12368_ = 0u;
                                                }
                                                let _e3632 = phi_12367_;
                                                let _e3634 = phi_12368_;
                                                phi_12387_ = _e3632;
                                                phi_12388_ = _e3634;
                                            } else {
                                                if (_e3596 < 0.0lf) {
                                                    phi_12374_ = -(_e3596);
                                                } else {
                                                    phi_12374_ = _e3596;
                                                }
                                                let _e3612 = phi_12374_;
                                                if (_e3599 < 0.0lf) {
                                                    phi_12380_ = -(_e3599);
                                                } else {
                                                    phi_12380_ = _e3599;
                                                }
                                                let _e3616 = phi_12380_;
                                                if (_e3612 > _e3616) {
                                                    phi_12385_ = 0u;
                                                    phi_12386_ = 2u;
                                                } else {
                                                    phi_12385_ = 1u;
                                                    phi_12386_ = 0u;
                                                }
                                                let _e3619 = phi_12385_;
                                                let _e3621 = phi_12386_;
                                                phi_12387_ = _e3619;
                                                phi_12388_ = _e3621;
                                            }
                                            let _e3636 = phi_12387_;
                                            let _e3638 = phi_12388_;
                                            let _e3641 = local_3.member[_e3638];
                                            let _e3644 = local_4.member[_e3636];
                                            let _e3648 = local_3.member[_e3636];
                                            let _e3651 = local_4.member[_e3638];
                                            let _e3653 = ((_e3641 * _e3644) - (_e3648 * _e3651));
                                            let _e3654 = f64(1f);
                                            let _e3655 = f64(2f);
                                            let _e3657 = local_3.member_1;
                                            let _e3659 = local_4.member_2;
                                            let _e3662 = local_3.member_2;
                                            let _e3664 = local_4.member_1;
                                            let _e3670 = local_3.member_2;
                                            let _e3673 = local_4.member_2;
                                            let _e3682 = local_3.member_2;
                                            let _e3685 = local_4.member_2;
                                            let _e3689 = (((((_e3657 * _e3659) + (_e3662 * _e3664)) * f64(2.01f)) + (((_e3670 * _e3655) * (_e3673 * _e3655)) * (1.1102230246251565e-16lf * _e3655))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e3654 + _e3682) * (_e3654 + _e3685))));
                                            if (_e3653 < 0.0lf) {
                                                phi_12461_ = -(_e3653);
                                            } else {
                                                phi_12461_ = _e3653;
                                            }
                                            let _e3693 = phi_12461_;
                                            if (_e3693 > _e3689) {
                                                if (_e3653 < f64(0f)) {
                                                    phi_12473_ = f64(-1f);
                                                } else {
                                                    phi_12473_ = f64(1f);
                                                }
                                                let _e3700 = phi_12473_;
                                                let _e3703 = local_2.member[_e3638];
                                                let _e3706 = local_4.member[_e3636];
                                                let _e3710 = local_2.member[_e3636];
                                                let _e3713 = local_4.member[_e3638];
                                                let _e3716 = f64(1f);
                                                let _e3717 = f64(2f);
                                                let _e3719 = local_2.member_1;
                                                let _e3721 = local_4.member_2;
                                                let _e3724 = local_2.member_2;
                                                let _e3726 = local_4.member_1;
                                                let _e3732 = local_2.member_2;
                                                let _e3735 = local_4.member_2;
                                                let _e3744 = local_2.member_2;
                                                let _e3747 = local_4.member_2;
                                                let _e3751 = (((((_e3719 * _e3721) + (_e3724 * _e3726)) * f64(2.01f)) + (((_e3732 * _e3717) * (_e3735 * _e3717)) * (1.1102230246251565e-16lf * _e3717))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e3716 + _e3744) * (_e3716 + _e3747))));
                                                let _e3754 = local_3.member[_e3638];
                                                let _e3757 = local_2.member[_e3636];
                                                let _e3761 = local_3.member[_e3636];
                                                let _e3764 = local_2.member[_e3638];
                                                let _e3767 = f64(1f);
                                                let _e3768 = f64(2f);
                                                let _e3770 = local_3.member_1;
                                                let _e3772 = local_2.member_2;
                                                let _e3775 = local_3.member_2;
                                                let _e3777 = local_2.member_1;
                                                let _e3783 = local_3.member_2;
                                                let _e3786 = local_2.member_2;
                                                let _e3795 = local_3.member_2;
                                                let _e3798 = local_2.member_2;
                                                let _e3802 = (((((_e3770 * _e3772) + (_e3775 * _e3777)) * f64(2.01f)) + (((_e3783 * _e3768) * (_e3786 * _e3768)) * (1.1102230246251565e-16lf * _e3768))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e3767 + _e3795) * (_e3767 + _e3798))));
                                                let _e3803 = (_e3653 * _e3700);
                                                let _e3804 = (((_e3703 * _e3706) - (_e3710 * _e3713)) * _e3700);
                                                let _e3805 = (((_e3754 * _e3757) - (_e3761 * _e3764)) * _e3700);
                                                if (_e3803 < 0.0lf) {
                                                    phi_12616_ = -(_e3803);
                                                } else {
                                                    phi_12616_ = _e3803;
                                                }
                                                let _e3809 = phi_12616_;
                                                if (_e3804 < 0.0lf) {
                                                    phi_12622_ = -(_e3804);
                                                } else {
                                                    phi_12622_ = _e3804;
                                                }
                                                let _e3813 = phi_12622_;
                                                if (_e3805 < 0.0lf) {
                                                    phi_12629_ = -(_e3805);
                                                } else {
                                                    phi_12629_ = _e3805;
                                                }
                                                let _e3818 = phi_12629_;
                                                let _e3822 = (((_e3809 + _e3813) + _e3818) * (1.1102230246251565e-16lf * f64(4f)));
                                                local_5 = array<type_40, 4>(type_40(_e3804, _e3751), type_40(_e3805, _e3802), type_40((_e3803 - _e3804), ((_e3689 + _e3751) + _e3822)), type_40((_e3803 - _e3805), ((_e3689 + _e3802) + _e3822)));
                                                phi_12685_ = type_12(0u, 4u);
                                                phi_12688_ = true;
                                                loop {
                                                    let _e3835 = phi_12685_;
                                                    let _e3837 = phi_12688_;
                                                    local_27 = _e3837;
                                                    if (_e3835.member < _e3835.member_1) {
                                                        phi_12686_ = type_12((_e3835.member + 1u), _e3835.member_1);
                                                        phi_12711_ = type_12(1u, _e3835.member);
                                                    } else {
                                                        phi_12686_ = _e3835;
                                                        phi_12711_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e3849 = phi_12686_;
                                                    let _e3851 = phi_12711_;
                                                    if (bitcast<i32>(_e3851.member) != 0i) {
                                                        let _e3858 = local_5[_e3851.member_1].member;
                                                        let _e3861 = local_5[_e3851.member_1].member_1;
                                                        let _e3863 = (_e3858 < -(_e3861));
                                                        if _e3863 {
                                                            phi_12738_ = bool();
                                                            phi_12739_ = false;
                                                        } else {
                                                            phi_12738_ = (_e3837 && (_e3858 > _e3861));
                                                            phi_12739_ = true;
                                                        }
                                                        let _e3867 = phi_12738_;
                                                        let _e3869 = phi_12739_;
                                                        phi_12689_ = _e3867;
                                                        phi_12740_ = _e3869;
                                                        phi_12741_ = _e3863;
                                                    } else {
                                                        phi_12689_ = bool();
                                                        phi_12740_ = false;
                                                        phi_12741_ = false;
                                                    }
                                                    let _e3871 = phi_12689_;
                                                    let _e3873 = phi_12740_;
                                                    let _e3875 = phi_12741_;
                                                    local_26 = _e3875;
                                                    continue;
                                                    continuing {
                                                        phi_12685_ = _e3849;
                                                        phi_12688_ = _e3871;
                                                        break if !(_e3873);
                                                    }
                                                }
                                                let _e3878 = local_26;
                                                if _e3878 {
                                                    phi_12745_ = false;
                                                } else {
                                                    phi_12745_ = true;
                                                }
                                                let _e3880 = phi_12745_;
                                                if _e3880 {
                                                    let _e3882 = local_27;
                                                    if _e3882 {
                                                        phi_12752_ = 1u;
                                                    } else {
                                                        phi_12752_ = 2u;
                                                    }
                                                    let _e3884 = phi_12752_;
                                                    phi_12753_ = _e3884;
                                                    phi_12754_ = false;
                                                } else {
                                                    phi_12753_ = u32();
                                                    phi_12754_ = true;
                                                }
                                                let _e3886 = phi_12753_;
                                                let _e3888 = phi_12754_;
                                                phi_12755_ = _e3886;
                                                phi_12756_ = 0u;
                                                phi_12757_ = _e3888;
                                            } else {
                                                phi_12755_ = u32();
                                                phi_12756_ = 2u;
                                                phi_12757_ = true;
                                            }
                                            let _e3890 = phi_12755_;
                                            let _e3892 = phi_12756_;
                                            let _e3894 = phi_12757_;
                                            if _e3894 {
                                                phi_12761_ = _e3892;
                                            } else {
                                                phi_12761_ = _e3890;
                                            }
                                            let _e3896 = phi_12761_;
                                            let _e3897 = (_e3896 == 0u);
                                            if _e3897 {
                                                phi_15520_ = bool();
                                                phi_15521_ = f64();
                                                phi_15522_ = f64();
                                                phi_15523_ = false;
                                                phi_15524_ = false;
                                                phi_15525_ = false;
                                            } else {
                                                if (_e3896 == 1u) {
                                                    phi_12771_ = _e3172.member_2;
                                                } else {
                                                    phi_12771_ = false;
                                                }
                                                let _e3901 = phi_12771_;
                                                let _e3903 = (_e421 * f64(0.99f));
                                                if _e3901 {
                                                    if ((_e3172.member_1 - _e3172.member) <= _e3903) {
                                                        phi_12784_ = false;
                                                    } else {
                                                        phi_12784_ = true;
                                                    }
                                                    let _e3909 = phi_12784_;
                                                    phi_12785_ = _e3909;
                                                } else {
                                                    phi_12785_ = true;
                                                }
                                                let _e3911 = phi_12785_;
                                                if _e3911 {
                                                    let _e3916 = local_18.member[0u];
                                                    let _e3922 = local_18.member_1[0u];
                                                    let _e3928 = local_18.member_2[0u];
                                                    let _e3932 = (_e3916[0] - _e3922[0]);
                                                    let _e3933 = (_e3916[1] - _e3922[1]);
                                                    let _e3934 = (_e3916[2] - _e3922[2]);
                                                    let _e3943 = local_18.member[1u];
                                                    let _e3949 = local_18.member_1[1u];
                                                    let _e3955 = local_18.member_2[1u];
                                                    let _e3959 = (_e3943[0] - _e3949[0]);
                                                    let _e3960 = (_e3943[1] - _e3949[1]);
                                                    let _e3961 = (_e3943[2] - _e3949[2]);
                                                    let _e3970 = local_18.member[0u];
                                                    if (_e3970[0] < 0.0lf) {
                                                        phi_12933_ = -(_e3970[0]);
                                                    } else {
                                                        phi_12933_ = _e3970[0];
                                                    }
                                                    let _e3977 = phi_12933_;
                                                    if (_e3970[1] < 0.0lf) {
                                                        phi_12940_ = -(_e3970[1]);
                                                    } else {
                                                        phi_12940_ = _e3970[1];
                                                    }
                                                    let _e3981 = phi_12940_;
                                                    if (_e3977 > _e3981) {
                                                        phi_12945_ = _e3977;
                                                    } else {
                                                        phi_12945_ = _e3981;
                                                    }
                                                    let _e3984 = phi_12945_;
                                                    if (_e3970[2] < 0.0lf) {
                                                        phi_12952_ = -(_e3970[2]);
                                                    } else {
                                                        phi_12952_ = _e3970[2];
                                                    }
                                                    let _e3988 = phi_12952_;
                                                    if (_e3984 > _e3988) {
                                                        phi_12957_ = _e3984;
                                                    } else {
                                                        phi_12957_ = _e3988;
                                                    }
                                                    let _e3991 = phi_12957_;
                                                    let _e3994 = local_18.member[1u];
                                                    if (_e3994[0] < 0.0lf) {
                                                        phi_12970_ = -(_e3994[0]);
                                                    } else {
                                                        phi_12970_ = _e3994[0];
                                                    }
                                                    let _e4001 = phi_12970_;
                                                    if (_e3994[1] < 0.0lf) {
                                                        phi_12977_ = -(_e3994[1]);
                                                    } else {
                                                        phi_12977_ = _e3994[1];
                                                    }
                                                    let _e4005 = phi_12977_;
                                                    if (_e4001 > _e4005) {
                                                        phi_12982_ = _e4001;
                                                    } else {
                                                        phi_12982_ = _e4005;
                                                    }
                                                    let _e4008 = phi_12982_;
                                                    if (_e3994[2] < 0.0lf) {
                                                        phi_12989_ = -(_e3994[2]);
                                                    } else {
                                                        phi_12989_ = _e3994[2];
                                                    }
                                                    let _e4012 = phi_12989_;
                                                    if (_e4008 > _e4012) {
                                                        phi_12994_ = _e4008;
                                                    } else {
                                                        phi_12994_ = _e4012;
                                                    }
                                                    let _e4015 = phi_12994_;
                                                    if (_e3991 > _e4015) {
                                                        phi_12999_ = _e3991;
                                                    } else {
                                                        phi_12999_ = _e4015;
                                                    }
                                                    let _e4018 = phi_12999_;
                                                    let _e4020 = local_18.member_3;
                                                    let _e4024 = local_18.member_1[0u];
                                                    if (_e4024[0] < 0.0lf) {
                                                        phi_13016_ = -(_e4024[0]);
                                                    } else {
                                                        phi_13016_ = _e4024[0];
                                                    }
                                                    let _e4031 = phi_13016_;
                                                    if (_e4024[1] < 0.0lf) {
                                                        phi_13023_ = -(_e4024[1]);
                                                    } else {
                                                        phi_13023_ = _e4024[1];
                                                    }
                                                    let _e4035 = phi_13023_;
                                                    if (_e4031 > _e4035) {
                                                        phi_13028_ = _e4031;
                                                    } else {
                                                        phi_13028_ = _e4035;
                                                    }
                                                    let _e4038 = phi_13028_;
                                                    if (_e4024[2] < 0.0lf) {
                                                        phi_13035_ = -(_e4024[2]);
                                                    } else {
                                                        phi_13035_ = _e4024[2];
                                                    }
                                                    let _e4042 = phi_13035_;
                                                    if (_e4038 > _e4042) {
                                                        phi_13040_ = _e4038;
                                                    } else {
                                                        phi_13040_ = _e4042;
                                                    }
                                                    let _e4045 = phi_13040_;
                                                    let _e4048 = local_18.member_1[1u];
                                                    if (_e4048[0] < 0.0lf) {
                                                        phi_13054_ = -(_e4048[0]);
                                                    } else {
                                                        phi_13054_ = _e4048[0];
                                                    }
                                                    let _e4055 = phi_13054_;
                                                    if (_e4048[1] < 0.0lf) {
                                                        phi_13061_ = -(_e4048[1]);
                                                    } else {
                                                        phi_13061_ = _e4048[1];
                                                    }
                                                    let _e4059 = phi_13061_;
                                                    if (_e4055 > _e4059) {
                                                        phi_13066_ = _e4055;
                                                    } else {
                                                        phi_13066_ = _e4059;
                                                    }
                                                    let _e4062 = phi_13066_;
                                                    if (_e4048[2] < 0.0lf) {
                                                        phi_13073_ = -(_e4048[2]);
                                                    } else {
                                                        phi_13073_ = _e4048[2];
                                                    }
                                                    let _e4066 = phi_13073_;
                                                    if (_e4062 > _e4066) {
                                                        phi_13078_ = _e4062;
                                                    } else {
                                                        phi_13078_ = _e4066;
                                                    }
                                                    let _e4069 = phi_13078_;
                                                    if (_e4045 > _e4069) {
                                                        phi_13083_ = _e4045;
                                                    } else {
                                                        phi_13083_ = _e4069;
                                                    }
                                                    let _e4072 = phi_13083_;
                                                    let _e4074 = local_18.member_3;
                                                    let _e4078 = local_18.member_2[0u];
                                                    if (_e4078[0] < 0.0lf) {
                                                        phi_13100_ = -(_e4078[0]);
                                                    } else {
                                                        phi_13100_ = _e4078[0];
                                                    }
                                                    let _e4085 = phi_13100_;
                                                    if (_e4078[1] < 0.0lf) {
                                                        phi_13107_ = -(_e4078[1]);
                                                    } else {
                                                        phi_13107_ = _e4078[1];
                                                    }
                                                    let _e4089 = phi_13107_;
                                                    if (_e4085 > _e4089) {
                                                        phi_13112_ = _e4085;
                                                    } else {
                                                        phi_13112_ = _e4089;
                                                    }
                                                    let _e4092 = phi_13112_;
                                                    if (_e4078[2] < 0.0lf) {
                                                        phi_13119_ = -(_e4078[2]);
                                                    } else {
                                                        phi_13119_ = _e4078[2];
                                                    }
                                                    let _e4096 = phi_13119_;
                                                    if (_e4092 > _e4096) {
                                                        phi_13124_ = _e4092;
                                                    } else {
                                                        phi_13124_ = _e4096;
                                                    }
                                                    let _e4099 = phi_13124_;
                                                    let _e4102 = local_18.member_2[1u];
                                                    if (_e4102[0] < 0.0lf) {
                                                        phi_13138_ = -(_e4102[0]);
                                                    } else {
                                                        phi_13138_ = _e4102[0];
                                                    }
                                                    let _e4109 = phi_13138_;
                                                    if (_e4102[1] < 0.0lf) {
                                                        phi_13145_ = -(_e4102[1]);
                                                    } else {
                                                        phi_13145_ = _e4102[1];
                                                    }
                                                    let _e4113 = phi_13145_;
                                                    if (_e4109 > _e4113) {
                                                        phi_13150_ = _e4109;
                                                    } else {
                                                        phi_13150_ = _e4113;
                                                    }
                                                    let _e4116 = phi_13150_;
                                                    if (_e4102[2] < 0.0lf) {
                                                        phi_13157_ = -(_e4102[2]);
                                                    } else {
                                                        phi_13157_ = _e4102[2];
                                                    }
                                                    let _e4120 = phi_13157_;
                                                    if (_e4116 > _e4120) {
                                                        phi_13162_ = _e4116;
                                                    } else {
                                                        phi_13162_ = _e4120;
                                                    }
                                                    let _e4123 = phi_13162_;
                                                    if (_e4099 > _e4123) {
                                                        phi_13167_ = _e4099;
                                                    } else {
                                                        phi_13167_ = _e4123;
                                                    }
                                                    let _e4126 = phi_13167_;
                                                    let _e4128 = local_18.member_3;
                                                    let _e4136 = local_18.member_3;
                                                    let _e4144 = (_e421 * f64(0.00390625f));
                                                    let _e4145 = f64(0f);
                                                    let _e4146 = f64(1f);
                                                    local = type_38(array<f64, 4>(_e4145, _e4145, _e4145, _e4145), array<f64, 4>(_e4145, _e4145, _e4145, _e4145), array<f64, 4>(_e4146, _e4146, _e4146, _e4146));
                                                    phi_13214_ = type_12(0u, 96u);
                                                    phi_13217_ = _e3172.member;
                                                    phi_13219_ = _e3172.member;
                                                    phi_13221_ = (_e3172.member_1 - _e3172.member);
                                                    phi_13223_ = _e3172.member;
                                                    phi_13225_ = false;
                                                    phi_13227_ = 0u;
                                                    loop {
                                                        let _e4153 = phi_13214_;
                                                        let _e4155 = phi_13217_;
                                                        let _e4157 = phi_13219_;
                                                        let _e4159 = phi_13221_;
                                                        let _e4161 = phi_13223_;
                                                        let _e4163 = phi_13225_;
                                                        let _e4165 = phi_13227_;
                                                        local_31 = _e4155;
                                                        local_78 = _e4157;
                                                        if (_e4153.member < _e4153.member_1) {
                                                            phi_13215_ = type_12((_e4153.member + 1u), _e4153.member_1);
                                                            phi_13250_ = type_12(1u, _e4153.member);
                                                        } else {
                                                            phi_13215_ = _e4153;
                                                            phi_13250_ = type_12(0u, type_12().member_1);
                                                        }
                                                        let _e4177 = phi_13215_;
                                                        let _e4179 = phi_13250_;
                                                        if (bitcast<i32>(_e4179.member) != 0i) {
                                                            let _e4185 = local_18.member[0u];
                                                            let _e4191 = local_18.member[1u];
                                                            let _e4207 = local_18.member_1[0u];
                                                            let _e4213 = local_18.member_1[1u];
                                                            let _e4229 = local_18.member_2[0u];
                                                            let _e4235 = local_18.member_2[1u];
                                                            let _e4249 = function_4(array<f64, 3>((_e4185[0] + ((_e4191[0] - _e4185[0]) * _e4155)), (_e4185[1] + ((_e4191[1] - _e4185[1]) * _e4155)), (_e4185[2] + ((_e4191[2] - _e4185[2]) * _e4155))), array<f64, 3>((_e4207[0] + ((_e4213[0] - _e4207[0]) * _e4155)), (_e4207[1] + ((_e4213[1] - _e4207[1]) * _e4155)), (_e4207[2] + ((_e4213[2] - _e4207[2]) * _e4155))), array<f64, 3>((_e4229[0] + ((_e4235[0] - _e4229[0]) * _e4155)), (_e4229[1] + ((_e4235[1] - _e4229[1]) * _e4155)), (_e4229[2] + ((_e4235[2] - _e4229[2]) * _e4155))), 1u);
                                                            if (_e4165 == 0u) {
                                                                phi_13379_ = _e4249;
                                                            } else {
                                                                let _e4251 = f64(0f);
                                                                if (_e4165 == 1u) {
                                                                    phi_13365_ = _e4249[0];
                                                                } else {
                                                                    phi_13365_ = _e4251;
                                                                }
                                                                let _e4255 = phi_13365_;
                                                                if (_e4165 == 2u) {
                                                                    phi_13371_ = _e4249[1];
                                                                } else {
                                                                    phi_13371_ = _e4251;
                                                                }
                                                                let _e4259 = phi_13371_;
                                                                if (_e4165 == 3u) {
                                                                    phi_13377_ = _e4249[2];
                                                                } else {
                                                                    phi_13377_ = _e4251;
                                                                }
                                                                let _e4263 = phi_13377_;
                                                                phi_13379_ = array<f64, 3>(_e4255, _e4259, _e4263);
                                                            }
                                                            let _e4266 = phi_13379_;
                                                            if (_e4266[0] < 0.0lf) {
                                                                phi_13386_ = -(_e4266[0]);
                                                            } else {
                                                                phi_13386_ = _e4266[0];
                                                            }
                                                            let _e4271 = phi_13386_;
                                                            if (_e4266[1] < 0.0lf) {
                                                                phi_13393_ = -(_e4266[1]);
                                                            } else {
                                                                phi_13393_ = _e4266[1];
                                                            }
                                                            let _e4276 = phi_13393_;
                                                            if (_e4266[2] < 0.0lf) {
                                                                phi_13401_ = -(_e4266[2]);
                                                            } else {
                                                                phi_13401_ = _e4266[2];
                                                            }
                                                            let _e4282 = phi_13401_;
                                                            let _e4283 = ((_e4271 + _e4276) + _e4282);
                                                            if (_e4283 > f64(0f)) {
                                                                if ((bitcast<u64>(_e4283) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                                    let _e4290 = (f64(1f) / _e4283);
                                                                    let _e4292 = (_e4266[0] * _e4290);
                                                                    let _e4294 = (_e4266[1] * _e4290);
                                                                    let _e4296 = (_e4266[2] * _e4290);
                                                                    let _e4301 = (((_e4292 * _e4292) + (_e4294 * _e4294)) + (_e4296 * _e4296));
                                                                    if (_e4301 <= 2.2250738585072014e-308lf) {
                                                                        if (_e4301 > 0.0lf) {
                                                                            phi_13440_ = (1.464336215552873e-154lf * 2.0lf);
                                                                        } else {
                                                                            phi_13440_ = 0.0lf;
                                                                        }
                                                                        let _e4353 = phi_13440_;
                                                                        phi_13504_ = _e4353;
                                                                    } else {
                                                                        phi_13447_ = type_16(0i, 5i);
                                                                        phi_13450_ = bitcast<f64>(((bitcast<u64>(_e4301) / 2lu) + 2303426169912950784lu));
                                                                        loop {
                                                                            let _e4308 = phi_13447_;
                                                                            let _e4310 = phi_13450_;
                                                                            local_28 = _e4310;
                                                                            if (_e4308.member < _e4308.member_1) {
                                                                                let _e4317 = (_e4308.member + 1i);
                                                                                if ((false == (_e4317 > _e4308.member)) != false) {
                                                                                    phi_13471_ = true;
                                                                                } else {
                                                                                    phi_13471_ = false;
                                                                                }
                                                                                let _e4322 = phi_13471_;
                                                                                if _e4322 {
                                                                                    phi_13477_ = type_17(0u, type_17().member_1);
                                                                                } else {
                                                                                    phi_13477_ = type_17(1u, _e4317);
                                                                                }
                                                                                let _e4327 = phi_13477_;
                                                                                phi_13448_ = type_16(_e4327.member_1, _e4308.member_1);
                                                                                phi_13491_ = type_17(1u, _e4308.member);
                                                                            } else {
                                                                                phi_13448_ = _e4308;
                                                                                phi_13491_ = type_17(0u, type_17().member_1);
                                                                            }
                                                                            let _e4333 = phi_13448_;
                                                                            let _e4335 = phi_13491_;
                                                                            let _e4338 = (bitcast<i32>(_e4335.member) != 0i);
                                                                            if _e4338 {
                                                                                phi_13451_ = (0.5lf * (_e4310 + (_e4301 / _e4310)));
                                                                            } else {
                                                                                phi_13451_ = f64();
                                                                            }
                                                                            let _e4343 = phi_13451_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_13447_ = _e4333;
                                                                                phi_13450_ = _e4343;
                                                                                break if !(_e4338);
                                                                            }
                                                                        }
                                                                        let _e4348 = local_28;
                                                                        phi_13504_ = (_e4348 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                    }
                                                                    let _e4355 = phi_13504_;
                                                                    let _e4357 = (1.1102230246251565e-16lf * f64(12f));
                                                                    let _e4364 = ((((((((_e4018 + _e4020) + (_e4072 + _e4074)) + (_e4126 + _e4128)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4136 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e686 * _e4355) * (f64(1f) + _e4357)));
                                                                    let _e4369 = (((_e4292 * _e3916[0]) + (_e4294 * _e3916[1])) + (_e4296 * _e3916[2]));
                                                                    let _e4374 = (((_e4292 * _e3932) + (_e4294 * _e3933)) + (_e4296 * _e3934));
                                                                    let _e4379 = (((_e4292 * (_e3916[0] - _e3928[0])) + (_e4294 * (_e3916[1] - _e3928[1]))) + (_e4296 * (_e3916[2] - _e3928[2])));
                                                                    let _e4384 = (((_e4292 * (_e3932 - _e3928[0])) + (_e4294 * (_e3933 - _e3928[1]))) + (_e4296 * (_e3934 - _e3928[2])));
                                                                    let _e4390 = (((_e4292 * _e3943[0]) + (_e4294 * _e3943[1])) + (_e4296 * _e3943[2]));
                                                                    let _e4395 = (((_e4292 * _e3959) + (_e4294 * _e3960)) + (_e4296 * _e3961));
                                                                    let _e4400 = (((_e4292 * (_e3943[0] - _e3955[0])) + (_e4294 * (_e3943[1] - _e3955[1]))) + (_e4296 * (_e3943[2] - _e3955[2])));
                                                                    let _e4405 = (((_e4292 * (_e3959 - _e3955[0])) + (_e4294 * (_e3960 - _e3955[1]))) + (_e4296 * (_e3961 - _e3955[2])));
                                                                    if (_e4369 < 0.0lf) {
                                                                        phi_13573_ = -(_e4369);
                                                                    } else {
                                                                        phi_13573_ = _e4369;
                                                                    }
                                                                    let _e4410 = phi_13573_;
                                                                    if (_e4390 < 0.0lf) {
                                                                        phi_13579_ = -(_e4390);
                                                                    } else {
                                                                        phi_13579_ = _e4390;
                                                                    }
                                                                    let _e4414 = phi_13579_;
                                                                    if (_e4374 < 0.0lf) {
                                                                        phi_13588_ = -(_e4374);
                                                                    } else {
                                                                        phi_13588_ = _e4374;
                                                                    }
                                                                    let _e4421 = phi_13588_;
                                                                    if (_e4395 < 0.0lf) {
                                                                        phi_13594_ = -(_e4395);
                                                                    } else {
                                                                        phi_13594_ = _e4395;
                                                                    }
                                                                    let _e4425 = phi_13594_;
                                                                    if (_e4379 < 0.0lf) {
                                                                        phi_13603_ = -(_e4379);
                                                                    } else {
                                                                        phi_13603_ = _e4379;
                                                                    }
                                                                    let _e4432 = phi_13603_;
                                                                    if (_e4400 < 0.0lf) {
                                                                        phi_13609_ = -(_e4400);
                                                                    } else {
                                                                        phi_13609_ = _e4400;
                                                                    }
                                                                    let _e4436 = phi_13609_;
                                                                    if (_e4384 < 0.0lf) {
                                                                        phi_13618_ = -(_e4384);
                                                                    } else {
                                                                        phi_13618_ = _e4384;
                                                                    }
                                                                    let _e4443 = phi_13618_;
                                                                    if (_e4405 < 0.0lf) {
                                                                        phi_13624_ = -(_e4405);
                                                                    } else {
                                                                        phi_13624_ = _e4405;
                                                                    }
                                                                    let _e4447 = phi_13624_;
                                                                    phi_13630_ = type_38(array<f64, 4>(_e4369, _e4374, _e4379, _e4384), array<f64, 4>(_e4390, _e4395, _e4400, _e4405), array<f64, 4>((_e4364 + ((_e4410 + _e4414) * _e4357)), (_e4364 + ((_e4421 + _e4425) * _e4357)), (_e4364 + ((_e4432 + _e4436) * _e4357)), (_e4364 + ((_e4443 + _e4447) * _e4357))));
                                                                    phi_13631_ = false;
                                                                } else {
                                                                    phi_13630_ = type_38();
                                                                    phi_13631_ = true;
                                                                }
                                                                let _e4454 = phi_13630_;
                                                                let _e4456 = phi_13631_;
                                                                phi_13632_ = _e4454;
                                                                phi_13633_ = _e4456;
                                                            } else {
                                                                phi_13632_ = type_38();
                                                                phi_13633_ = true;
                                                            }
                                                            let _e4458 = phi_13632_;
                                                            let _e4460 = phi_13633_;
                                                            if _e4460 {
                                                                let _e4461 = f64(0f);
                                                                let _e4462 = f64(1f);
                                                                phi_13643_ = type_38(array<f64, 4>(_e4461, _e4461, _e4461, _e4461), array<f64, 4>(_e4461, _e4461, _e4461, _e4461), array<f64, 4>(_e4462, _e4462, _e4462, _e4462));
                                                            } else {
                                                                phi_13643_ = _e4458;
                                                            }
                                                            let _e4468 = phi_13643_;
                                                            local_1 = type_38(array<f64, 4>(_e4468.member[0], _e4468.member[1], _e4468.member[2], _e4468.member[3]), array<f64, 4>(_e4468.member_1[0], _e4468.member_1[1], _e4468.member_1[2], _e4468.member_1[3]), array<f64, 4>(_e4468.member_2[0], _e4468.member_2[1], _e4468.member_2[2], _e4468.member_2[3]));
                                                            let _e4488 = (_e4155 - _e4161);
                                                            let _e4490 = f64(0f);
                                                            let _e4493 = local_1.member[0u];
                                                            let _e4496 = local_1.member_1[0u];
                                                            let _e4499 = local_1.member[0u];
                                                            let _e4505 = local_1.member_2[0u];
                                                            if (((_e4493 + ((_e4496 - _e4499) * _e4155)) - _e4505) > _e4490) {
                                                                let _e4510 = local_1.member[1u];
                                                                let _e4513 = local_1.member_1[1u];
                                                                let _e4516 = local_1.member[1u];
                                                                let _e4522 = local_1.member_2[1u];
                                                                if (((_e4510 + ((_e4513 - _e4516) * _e4155)) - _e4522) > _e4490) {
                                                                    let _e4527 = local_1.member[2u];
                                                                    let _e4530 = local_1.member_1[2u];
                                                                    let _e4533 = local_1.member[2u];
                                                                    let _e4539 = local_1.member_2[2u];
                                                                    if (((_e4527 + ((_e4530 - _e4533) * _e4155)) - _e4539) > _e4490) {
                                                                        let _e4544 = local_1.member[3u];
                                                                        let _e4547 = local_1.member_1[3u];
                                                                        let _e4550 = local_1.member[3u];
                                                                        let _e4556 = local_1.member_2[3u];
                                                                        phi_13815_ = (((_e4544 + ((_e4547 - _e4550) * _e4155)) - _e4556) > _e4490);
                                                                        phi_13816_ = false;
                                                                    } else {
                                                                        phi_13815_ = bool();
                                                                        phi_13816_ = true;
                                                                    }
                                                                    let _e4560 = phi_13815_;
                                                                    let _e4562 = phi_13816_;
                                                                    phi_13817_ = _e4560;
                                                                    phi_13818_ = _e4562;
                                                                } else {
                                                                    phi_13817_ = bool();
                                                                    phi_13818_ = true;
                                                                }
                                                                let _e4564 = phi_13817_;
                                                                let _e4566 = phi_13818_;
                                                                phi_13819_ = _e4564;
                                                                phi_13820_ = _e4566;
                                                            } else {
                                                                phi_13819_ = bool();
                                                                phi_13820_ = true;
                                                            }
                                                            let _e4568 = phi_13819_;
                                                            let _e4570 = phi_13820_;
                                                            if _e4570 {
                                                                phi_13824_ = false;
                                                            } else {
                                                                phi_13824_ = _e4568;
                                                            }
                                                            let _e4572 = phi_13824_;
                                                            if _e4572 {
                                                                if (_e4155 <= _e4157) {
                                                                    phi_14135_ = true;
                                                                } else {
                                                                    let _e4574 = f64(0f);
                                                                    let _e4577 = local.member[0u];
                                                                    let _e4580 = local.member_1[0u];
                                                                    let _e4583 = local.member[0u];
                                                                    let _e4589 = local.member_2[0u];
                                                                    let _e4593 = local_1.member[0u];
                                                                    let _e4596 = local_1.member_1[0u];
                                                                    let _e4599 = local_1.member[0u];
                                                                    let _e4605 = local_1.member_2[0u];
                                                                    if ((((_e4577 + ((_e4580 - _e4583) * _e4155)) - _e4589) + ((_e4593 + ((_e4596 - _e4599) * _e4161)) - _e4605)) > _e4574) {
                                                                        let _e4611 = local.member[1u];
                                                                        let _e4614 = local.member_1[1u];
                                                                        let _e4617 = local.member[1u];
                                                                        let _e4623 = local.member_2[1u];
                                                                        let _e4627 = local_1.member[1u];
                                                                        let _e4630 = local_1.member_1[1u];
                                                                        let _e4633 = local_1.member[1u];
                                                                        let _e4639 = local_1.member_2[1u];
                                                                        if ((((_e4611 + ((_e4614 - _e4617) * _e4155)) - _e4623) + ((_e4627 + ((_e4630 - _e4633) * _e4161)) - _e4639)) > _e4574) {
                                                                            let _e4645 = local.member[2u];
                                                                            let _e4648 = local.member_1[2u];
                                                                            let _e4651 = local.member[2u];
                                                                            let _e4657 = local.member_2[2u];
                                                                            let _e4661 = local_1.member[2u];
                                                                            let _e4664 = local_1.member_1[2u];
                                                                            let _e4667 = local_1.member[2u];
                                                                            let _e4673 = local_1.member_2[2u];
                                                                            if ((((_e4645 + ((_e4648 - _e4651) * _e4155)) - _e4657) + ((_e4661 + ((_e4664 - _e4667) * _e4161)) - _e4673)) > _e4574) {
                                                                                let _e4679 = local.member[3u];
                                                                                let _e4682 = local.member_1[3u];
                                                                                let _e4685 = local.member[3u];
                                                                                let _e4691 = local.member_2[3u];
                                                                                let _e4695 = local_1.member[3u];
                                                                                let _e4698 = local_1.member_1[3u];
                                                                                let _e4701 = local_1.member[3u];
                                                                                let _e4707 = local_1.member_2[3u];
                                                                                phi_14122_ = ((((_e4679 + ((_e4682 - _e4685) * _e4155)) - _e4691) + ((_e4695 + ((_e4698 - _e4701) * _e4161)) - _e4707)) > _e4574);
                                                                                phi_14123_ = false;
                                                                            } else {
                                                                                phi_14122_ = bool();
                                                                                phi_14123_ = true;
                                                                            }
                                                                            let _e4712 = phi_14122_;
                                                                            let _e4714 = phi_14123_;
                                                                            phi_14124_ = _e4712;
                                                                            phi_14125_ = _e4714;
                                                                        } else {
                                                                            phi_14124_ = bool();
                                                                            phi_14125_ = true;
                                                                        }
                                                                        let _e4716 = phi_14124_;
                                                                        let _e4718 = phi_14125_;
                                                                        phi_14126_ = _e4716;
                                                                        phi_14127_ = _e4718;
                                                                    } else {
                                                                        phi_14126_ = bool();
                                                                        phi_14127_ = true;
                                                                    }
                                                                    let _e4720 = phi_14126_;
                                                                    let _e4722 = phi_14127_;
                                                                    if _e4722 {
                                                                        phi_14131_ = false;
                                                                    } else {
                                                                        phi_14131_ = _e4720;
                                                                    }
                                                                    let _e4724 = phi_14131_;
                                                                    phi_14135_ = _e4724;
                                                                }
                                                                let _e4726 = phi_14135_;
                                                                if _e4726 {
                                                                    if _e4163 {
                                                                        if (_e4155 >= _e3172.member_1) {
                                                                            phi_14146_ = false;
                                                                        } else {
                                                                            phi_14146_ = true;
                                                                        }
                                                                        let _e4729 = phi_14146_;
                                                                        phi_14147_ = _e4729;
                                                                    } else {
                                                                        phi_14147_ = true;
                                                                    }
                                                                    let _e4731 = phi_14147_;
                                                                    if _e4731 {
                                                                        local = type_38(array<f64, 4>(_e4468.member[0], _e4468.member[1], _e4468.member[2], _e4468.member[3]), array<f64, 4>(_e4468.member_1[0], _e4468.member_1[1], _e4468.member_1[2], _e4468.member_1[3]), array<f64, 4>(_e4468.member_2[0], _e4468.member_2[1], _e4468.member_2[2], _e4468.member_2[3]));
                                                                        let _e4753 = local.member[0u];
                                                                        let _e4756 = local.member_1[0u];
                                                                        let _e4759 = local.member_2[0u];
                                                                        if (_e4753 > _e4759) {
                                                                            if (_e4756 > _e4759) {
                                                                                phi_14221_ = false;
                                                                            } else {
                                                                                phi_14221_ = true;
                                                                            }
                                                                            let _e4763 = phi_14221_;
                                                                            phi_14222_ = _e4763;
                                                                        } else {
                                                                            phi_14222_ = true;
                                                                        }
                                                                        let _e4765 = phi_14222_;
                                                                        if _e4765 {
                                                                            let _e4766 = (_e4756 >= _e4753);
                                                                            if _e4766 {
                                                                                phi_14247_ = f64();
                                                                                phi_14248_ = false;
                                                                            } else {
                                                                                if ((_e4753 - _e4756) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14245_ = (((_e4753 - _e4759) / (_e4753 - _e4756)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14246_ = false;
                                                                                } else {
                                                                                    phi_14245_ = f64();
                                                                                    phi_14246_ = true;
                                                                                }
                                                                                let _e4780 = phi_14245_;
                                                                                let _e4782 = phi_14246_;
                                                                                phi_14247_ = _e4780;
                                                                                phi_14248_ = _e4782;
                                                                            }
                                                                            let _e4784 = phi_14247_;
                                                                            let _e4786 = phi_14248_;
                                                                            phi_14249_ = _e4784;
                                                                            phi_14250_ = _e4766;
                                                                            phi_14251_ = _e4786;
                                                                        } else {
                                                                            phi_14249_ = f64();
                                                                            phi_14250_ = true;
                                                                            phi_14251_ = false;
                                                                        }
                                                                        let _e4788 = phi_14249_;
                                                                        let _e4790 = phi_14250_;
                                                                        let _e4792 = phi_14251_;
                                                                        if _e4790 {
                                                                            phi_14256_ = f64(2f);
                                                                            phi_14257_ = true;
                                                                        } else {
                                                                            phi_14256_ = _e4155;
                                                                            phi_14257_ = _e4792;
                                                                        }
                                                                        let _e4795 = phi_14256_;
                                                                        let _e4797 = phi_14257_;
                                                                        if _e4797 {
                                                                            phi_14261_ = _e4795;
                                                                        } else {
                                                                            phi_14261_ = _e4788;
                                                                        }
                                                                        let _e4799 = phi_14261_;
                                                                        let _e4802 = local.member[1u];
                                                                        let _e4805 = local.member_1[1u];
                                                                        let _e4808 = local.member_2[1u];
                                                                        if (_e4802 > _e4808) {
                                                                            if (_e4805 > _e4808) {
                                                                                phi_14293_ = false;
                                                                            } else {
                                                                                phi_14293_ = true;
                                                                            }
                                                                            let _e4812 = phi_14293_;
                                                                            phi_14294_ = _e4812;
                                                                        } else {
                                                                            phi_14294_ = true;
                                                                        }
                                                                        let _e4814 = phi_14294_;
                                                                        if _e4814 {
                                                                            let _e4815 = (_e4805 >= _e4802);
                                                                            if _e4815 {
                                                                                phi_14319_ = f64();
                                                                                phi_14320_ = false;
                                                                            } else {
                                                                                if ((_e4802 - _e4805) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14317_ = (((_e4802 - _e4808) / (_e4802 - _e4805)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14318_ = false;
                                                                                } else {
                                                                                    phi_14317_ = f64();
                                                                                    phi_14318_ = true;
                                                                                }
                                                                                let _e4829 = phi_14317_;
                                                                                let _e4831 = phi_14318_;
                                                                                phi_14319_ = _e4829;
                                                                                phi_14320_ = _e4831;
                                                                            }
                                                                            let _e4833 = phi_14319_;
                                                                            let _e4835 = phi_14320_;
                                                                            phi_14321_ = _e4833;
                                                                            phi_14322_ = _e4815;
                                                                            phi_14323_ = _e4835;
                                                                        } else {
                                                                            phi_14321_ = f64();
                                                                            phi_14322_ = true;
                                                                            phi_14323_ = false;
                                                                        }
                                                                        let _e4837 = phi_14321_;
                                                                        let _e4839 = phi_14322_;
                                                                        let _e4841 = phi_14323_;
                                                                        if _e4839 {
                                                                            phi_14328_ = f64(2f);
                                                                            phi_14329_ = true;
                                                                        } else {
                                                                            phi_14328_ = _e4155;
                                                                            phi_14329_ = _e4841;
                                                                        }
                                                                        let _e4844 = phi_14328_;
                                                                        let _e4846 = phi_14329_;
                                                                        if _e4846 {
                                                                            phi_14333_ = _e4844;
                                                                        } else {
                                                                            phi_14333_ = _e4837;
                                                                        }
                                                                        let _e4848 = phi_14333_;
                                                                        if (_e4799 < _e4848) {
                                                                            phi_14338_ = _e4799;
                                                                        } else {
                                                                            phi_14338_ = _e4848;
                                                                        }
                                                                        let _e4851 = phi_14338_;
                                                                        let _e4854 = local.member[2u];
                                                                        let _e4857 = local.member_1[2u];
                                                                        let _e4860 = local.member_2[2u];
                                                                        if (_e4854 > _e4860) {
                                                                            if (_e4857 > _e4860) {
                                                                                phi_14370_ = false;
                                                                            } else {
                                                                                phi_14370_ = true;
                                                                            }
                                                                            let _e4864 = phi_14370_;
                                                                            phi_14371_ = _e4864;
                                                                        } else {
                                                                            phi_14371_ = true;
                                                                        }
                                                                        let _e4866 = phi_14371_;
                                                                        if _e4866 {
                                                                            let _e4867 = (_e4857 >= _e4854);
                                                                            if _e4867 {
                                                                                phi_14396_ = f64();
                                                                                phi_14397_ = false;
                                                                            } else {
                                                                                if ((_e4854 - _e4857) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14394_ = (((_e4854 - _e4860) / (_e4854 - _e4857)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14395_ = false;
                                                                                } else {
                                                                                    phi_14394_ = f64();
                                                                                    phi_14395_ = true;
                                                                                }
                                                                                let _e4881 = phi_14394_;
                                                                                let _e4883 = phi_14395_;
                                                                                phi_14396_ = _e4881;
                                                                                phi_14397_ = _e4883;
                                                                            }
                                                                            let _e4885 = phi_14396_;
                                                                            let _e4887 = phi_14397_;
                                                                            phi_14398_ = _e4885;
                                                                            phi_14399_ = _e4867;
                                                                            phi_14400_ = _e4887;
                                                                        } else {
                                                                            phi_14398_ = f64();
                                                                            phi_14399_ = true;
                                                                            phi_14400_ = false;
                                                                        }
                                                                        let _e4889 = phi_14398_;
                                                                        let _e4891 = phi_14399_;
                                                                        let _e4893 = phi_14400_;
                                                                        if _e4891 {
                                                                            phi_14405_ = f64(2f);
                                                                            phi_14406_ = true;
                                                                        } else {
                                                                            phi_14405_ = _e4155;
                                                                            phi_14406_ = _e4893;
                                                                        }
                                                                        let _e4896 = phi_14405_;
                                                                        let _e4898 = phi_14406_;
                                                                        if _e4898 {
                                                                            phi_14410_ = _e4896;
                                                                        } else {
                                                                            phi_14410_ = _e4889;
                                                                        }
                                                                        let _e4900 = phi_14410_;
                                                                        let _e4903 = local.member[3u];
                                                                        let _e4906 = local.member_1[3u];
                                                                        let _e4909 = local.member_2[3u];
                                                                        if (_e4903 > _e4909) {
                                                                            if (_e4906 > _e4909) {
                                                                                phi_14442_ = false;
                                                                            } else {
                                                                                phi_14442_ = true;
                                                                            }
                                                                            let _e4913 = phi_14442_;
                                                                            phi_14443_ = _e4913;
                                                                        } else {
                                                                            phi_14443_ = true;
                                                                        }
                                                                        let _e4915 = phi_14443_;
                                                                        if _e4915 {
                                                                            let _e4916 = (_e4906 >= _e4903);
                                                                            if _e4916 {
                                                                                phi_14468_ = f64();
                                                                                phi_14469_ = false;
                                                                            } else {
                                                                                if ((_e4903 - _e4906) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14466_ = (((_e4903 - _e4909) / (_e4903 - _e4906)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14467_ = false;
                                                                                } else {
                                                                                    phi_14466_ = f64();
                                                                                    phi_14467_ = true;
                                                                                }
                                                                                let _e4930 = phi_14466_;
                                                                                let _e4932 = phi_14467_;
                                                                                phi_14468_ = _e4930;
                                                                                phi_14469_ = _e4932;
                                                                            }
                                                                            let _e4934 = phi_14468_;
                                                                            let _e4936 = phi_14469_;
                                                                            phi_14470_ = _e4934;
                                                                            phi_14471_ = _e4916;
                                                                            phi_14472_ = _e4936;
                                                                        } else {
                                                                            phi_14470_ = f64();
                                                                            phi_14471_ = true;
                                                                            phi_14472_ = false;
                                                                        }
                                                                        let _e4938 = phi_14470_;
                                                                        let _e4940 = phi_14471_;
                                                                        let _e4942 = phi_14472_;
                                                                        if _e4940 {
                                                                            phi_14477_ = f64(2f);
                                                                            phi_14478_ = true;
                                                                        } else {
                                                                            phi_14477_ = _e4155;
                                                                            phi_14478_ = _e4942;
                                                                        }
                                                                        let _e4945 = phi_14477_;
                                                                        let _e4947 = phi_14478_;
                                                                        if _e4947 {
                                                                            phi_14482_ = _e4945;
                                                                        } else {
                                                                            phi_14482_ = _e4938;
                                                                        }
                                                                        let _e4949 = phi_14482_;
                                                                        if (_e4900 < _e4949) {
                                                                            phi_14487_ = _e4900;
                                                                        } else {
                                                                            phi_14487_ = _e4949;
                                                                        }
                                                                        let _e4952 = phi_14487_;
                                                                        if (_e4851 < _e4952) {
                                                                            phi_14492_ = _e4851;
                                                                        } else {
                                                                            phi_14492_ = _e4952;
                                                                        }
                                                                        let _e4955 = phi_14492_;
                                                                        if (_e4955 > _e4155) {
                                                                            phi_14497_ = _e4955;
                                                                        } else {
                                                                            phi_14497_ = _e4155;
                                                                        }
                                                                        let _e4958 = phi_14497_;
                                                                        let _e4959 = (_e4958 > _e3172.member_1);
                                                                        if _e4959 {
                                                                            phi_15014_ = f64();
                                                                            phi_15015_ = f64();
                                                                            phi_15016_ = false;
                                                                            phi_15017_ = false;
                                                                        } else {
                                                                            let _e4960 = (_e4958 - _e4155);
                                                                            let _e4961 = (_e4960 <= _e4144);
                                                                            let _e4964 = (_e4958 + (_e421 * f64(0.01f)));
                                                                            if (_e4964 < _e3172.member_1) {
                                                                                phi_14511_ = _e4964;
                                                                            } else {
                                                                                phi_14511_ = _e3172.member_1;
                                                                            }
                                                                            let _e4967 = phi_14511_;
                                                                            if _e4961 {
                                                                                if (_e686 > f64(0f)) {
                                                                                    let _e4972 = local_18.member[0u];
                                                                                    let _e4978 = local_18.member[1u];
                                                                                    let _e4994 = local_18.member_1[0u];
                                                                                    let _e5000 = local_18.member_1[1u];
                                                                                    let _e5016 = local_18.member_2[0u];
                                                                                    let _e5022 = local_18.member_2[1u];
                                                                                    let _e5036 = function_4(array<f64, 3>((_e4972[0] + ((_e4978[0] - _e4972[0]) * _e4967)), (_e4972[1] + ((_e4978[1] - _e4972[1]) * _e4967)), (_e4972[2] + ((_e4978[2] - _e4972[2]) * _e4967))), array<f64, 3>((_e4994[0] + ((_e5000[0] - _e4994[0]) * _e4967)), (_e4994[1] + ((_e5000[1] - _e4994[1]) * _e4967)), (_e4994[2] + ((_e5000[2] - _e4994[2]) * _e4967))), array<f64, 3>((_e5016[0] + ((_e5022[0] - _e5016[0]) * _e4967)), (_e5016[1] + ((_e5022[1] - _e5016[1]) * _e4967)), (_e5016[2] + ((_e5022[2] - _e5016[2]) * _e4967))), 1u);
                                                                                    let _e5047 = (((_e5036[0] * _e5036[0]) + (_e5036[1] * _e5036[1])) + (_e5036[2] * _e5036[2]));
                                                                                    if (_e5047 <= 2.2250738585072014e-308lf) {
                                                                                        if (_e5047 > 0.0lf) {
                                                                                            phi_14642_ = (1.464336215552873e-154lf * 2.0lf);
                                                                                        } else {
                                                                                            phi_14642_ = 0.0lf;
                                                                                        }
                                                                                        let _e5099 = phi_14642_;
                                                                                        phi_14706_ = _e5099;
                                                                                    } else {
                                                                                        phi_14649_ = type_16(0i, 5i);
                                                                                        phi_14652_ = bitcast<f64>(((bitcast<u64>(_e5047) / 2lu) + 2303426169912950784lu));
                                                                                        loop {
                                                                                            let _e5054 = phi_14649_;
                                                                                            let _e5056 = phi_14652_;
                                                                                            local_29 = _e5056;
                                                                                            if (_e5054.member < _e5054.member_1) {
                                                                                                let _e5063 = (_e5054.member + 1i);
                                                                                                if ((false == (_e5063 > _e5054.member)) != false) {
                                                                                                    phi_14673_ = true;
                                                                                                } else {
                                                                                                    phi_14673_ = false;
                                                                                                }
                                                                                                let _e5068 = phi_14673_;
                                                                                                if _e5068 {
                                                                                                    phi_14679_ = type_17(0u, type_17().member_1);
                                                                                                } else {
                                                                                                    phi_14679_ = type_17(1u, _e5063);
                                                                                                }
                                                                                                let _e5073 = phi_14679_;
                                                                                                phi_14650_ = type_16(_e5073.member_1, _e5054.member_1);
                                                                                                phi_14693_ = type_17(1u, _e5054.member);
                                                                                            } else {
                                                                                                phi_14650_ = _e5054;
                                                                                                phi_14693_ = type_17(0u, type_17().member_1);
                                                                                            }
                                                                                            let _e5079 = phi_14650_;
                                                                                            let _e5081 = phi_14693_;
                                                                                            let _e5084 = (bitcast<i32>(_e5081.member) != 0i);
                                                                                            if _e5084 {
                                                                                                phi_14653_ = (0.5lf * (_e5056 + (_e5047 / _e5056)));
                                                                                            } else {
                                                                                                phi_14653_ = f64();
                                                                                            }
                                                                                            let _e5089 = phi_14653_;
                                                                                            continue;
                                                                                            continuing {
                                                                                                phi_14649_ = _e5079;
                                                                                                phi_14652_ = _e5089;
                                                                                                break if !(_e5084);
                                                                                            }
                                                                                        }
                                                                                        let _e5094 = local_29;
                                                                                        phi_14706_ = (_e5094 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                                    }
                                                                                    let _e5101 = phi_14706_;
                                                                                    let _e5109 = local_18.member[0u];
                                                                                    if (_e5109[0] < 0.0lf) {
                                                                                        phi_14724_ = -(_e5109[0]);
                                                                                    } else {
                                                                                        phi_14724_ = _e5109[0];
                                                                                    }
                                                                                    let _e5116 = phi_14724_;
                                                                                    if (_e5109[1] < 0.0lf) {
                                                                                        phi_14731_ = -(_e5109[1]);
                                                                                    } else {
                                                                                        phi_14731_ = _e5109[1];
                                                                                    }
                                                                                    let _e5120 = phi_14731_;
                                                                                    if (_e5116 > _e5120) {
                                                                                        phi_14736_ = _e5116;
                                                                                    } else {
                                                                                        phi_14736_ = _e5120;
                                                                                    }
                                                                                    let _e5123 = phi_14736_;
                                                                                    if (_e5109[2] < 0.0lf) {
                                                                                        phi_14743_ = -(_e5109[2]);
                                                                                    } else {
                                                                                        phi_14743_ = _e5109[2];
                                                                                    }
                                                                                    let _e5127 = phi_14743_;
                                                                                    if (_e5123 > _e5127) {
                                                                                        phi_14748_ = _e5123;
                                                                                    } else {
                                                                                        phi_14748_ = _e5127;
                                                                                    }
                                                                                    let _e5130 = phi_14748_;
                                                                                    let _e5133 = local_18.member[1u];
                                                                                    if (_e5133[0] < 0.0lf) {
                                                                                        phi_14761_ = -(_e5133[0]);
                                                                                    } else {
                                                                                        phi_14761_ = _e5133[0];
                                                                                    }
                                                                                    let _e5140 = phi_14761_;
                                                                                    if (_e5133[1] < 0.0lf) {
                                                                                        phi_14768_ = -(_e5133[1]);
                                                                                    } else {
                                                                                        phi_14768_ = _e5133[1];
                                                                                    }
                                                                                    let _e5144 = phi_14768_;
                                                                                    if (_e5140 > _e5144) {
                                                                                        phi_14773_ = _e5140;
                                                                                    } else {
                                                                                        phi_14773_ = _e5144;
                                                                                    }
                                                                                    let _e5147 = phi_14773_;
                                                                                    if (_e5133[2] < 0.0lf) {
                                                                                        phi_14780_ = -(_e5133[2]);
                                                                                    } else {
                                                                                        phi_14780_ = _e5133[2];
                                                                                    }
                                                                                    let _e5151 = phi_14780_;
                                                                                    if (_e5147 > _e5151) {
                                                                                        phi_14785_ = _e5147;
                                                                                    } else {
                                                                                        phi_14785_ = _e5151;
                                                                                    }
                                                                                    let _e5154 = phi_14785_;
                                                                                    if (_e5130 > _e5154) {
                                                                                        phi_14790_ = _e5130;
                                                                                    } else {
                                                                                        phi_14790_ = _e5154;
                                                                                    }
                                                                                    let _e5157 = phi_14790_;
                                                                                    let _e5159 = local_18.member_3;
                                                                                    let _e5163 = local_18.member_1[0u];
                                                                                    if (_e5163[0] < 0.0lf) {
                                                                                        phi_14807_ = -(_e5163[0]);
                                                                                    } else {
                                                                                        phi_14807_ = _e5163[0];
                                                                                    }
                                                                                    let _e5170 = phi_14807_;
                                                                                    if (_e5163[1] < 0.0lf) {
                                                                                        phi_14814_ = -(_e5163[1]);
                                                                                    } else {
                                                                                        phi_14814_ = _e5163[1];
                                                                                    }
                                                                                    let _e5174 = phi_14814_;
                                                                                    if (_e5170 > _e5174) {
                                                                                        phi_14819_ = _e5170;
                                                                                    } else {
                                                                                        phi_14819_ = _e5174;
                                                                                    }
                                                                                    let _e5177 = phi_14819_;
                                                                                    if (_e5163[2] < 0.0lf) {
                                                                                        phi_14826_ = -(_e5163[2]);
                                                                                    } else {
                                                                                        phi_14826_ = _e5163[2];
                                                                                    }
                                                                                    let _e5181 = phi_14826_;
                                                                                    if (_e5177 > _e5181) {
                                                                                        phi_14831_ = _e5177;
                                                                                    } else {
                                                                                        phi_14831_ = _e5181;
                                                                                    }
                                                                                    let _e5184 = phi_14831_;
                                                                                    let _e5187 = local_18.member_1[1u];
                                                                                    if (_e5187[0] < 0.0lf) {
                                                                                        phi_14845_ = -(_e5187[0]);
                                                                                    } else {
                                                                                        phi_14845_ = _e5187[0];
                                                                                    }
                                                                                    let _e5194 = phi_14845_;
                                                                                    if (_e5187[1] < 0.0lf) {
                                                                                        phi_14852_ = -(_e5187[1]);
                                                                                    } else {
                                                                                        phi_14852_ = _e5187[1];
                                                                                    }
                                                                                    let _e5198 = phi_14852_;
                                                                                    if (_e5194 > _e5198) {
                                                                                        phi_14857_ = _e5194;
                                                                                    } else {
                                                                                        phi_14857_ = _e5198;
                                                                                    }
                                                                                    let _e5201 = phi_14857_;
                                                                                    if (_e5187[2] < 0.0lf) {
                                                                                        phi_14864_ = -(_e5187[2]);
                                                                                    } else {
                                                                                        phi_14864_ = _e5187[2];
                                                                                    }
                                                                                    let _e5205 = phi_14864_;
                                                                                    if (_e5201 > _e5205) {
                                                                                        phi_14869_ = _e5201;
                                                                                    } else {
                                                                                        phi_14869_ = _e5205;
                                                                                    }
                                                                                    let _e5208 = phi_14869_;
                                                                                    if (_e5184 > _e5208) {
                                                                                        phi_14874_ = _e5184;
                                                                                    } else {
                                                                                        phi_14874_ = _e5208;
                                                                                    }
                                                                                    let _e5211 = phi_14874_;
                                                                                    let _e5213 = local_18.member_3;
                                                                                    let _e5217 = local_18.member_2[0u];
                                                                                    if (_e5217[0] < 0.0lf) {
                                                                                        phi_14891_ = -(_e5217[0]);
                                                                                    } else {
                                                                                        phi_14891_ = _e5217[0];
                                                                                    }
                                                                                    let _e5224 = phi_14891_;
                                                                                    if (_e5217[1] < 0.0lf) {
                                                                                        phi_14898_ = -(_e5217[1]);
                                                                                    } else {
                                                                                        phi_14898_ = _e5217[1];
                                                                                    }
                                                                                    let _e5228 = phi_14898_;
                                                                                    if (_e5224 > _e5228) {
                                                                                        phi_14903_ = _e5224;
                                                                                    } else {
                                                                                        phi_14903_ = _e5228;
                                                                                    }
                                                                                    let _e5231 = phi_14903_;
                                                                                    if (_e5217[2] < 0.0lf) {
                                                                                        phi_14910_ = -(_e5217[2]);
                                                                                    } else {
                                                                                        phi_14910_ = _e5217[2];
                                                                                    }
                                                                                    let _e5235 = phi_14910_;
                                                                                    if (_e5231 > _e5235) {
                                                                                        phi_14915_ = _e5231;
                                                                                    } else {
                                                                                        phi_14915_ = _e5235;
                                                                                    }
                                                                                    let _e5238 = phi_14915_;
                                                                                    let _e5241 = local_18.member_2[1u];
                                                                                    if (_e5241[0] < 0.0lf) {
                                                                                        phi_14929_ = -(_e5241[0]);
                                                                                    } else {
                                                                                        phi_14929_ = _e5241[0];
                                                                                    }
                                                                                    let _e5248 = phi_14929_;
                                                                                    if (_e5241[1] < 0.0lf) {
                                                                                        phi_14936_ = -(_e5241[1]);
                                                                                    } else {
                                                                                        phi_14936_ = _e5241[1];
                                                                                    }
                                                                                    let _e5252 = phi_14936_;
                                                                                    if (_e5248 > _e5252) {
                                                                                        phi_14941_ = _e5248;
                                                                                    } else {
                                                                                        phi_14941_ = _e5252;
                                                                                    }
                                                                                    let _e5255 = phi_14941_;
                                                                                    if (_e5241[2] < 0.0lf) {
                                                                                        phi_14948_ = -(_e5241[2]);
                                                                                    } else {
                                                                                        phi_14948_ = _e5241[2];
                                                                                    }
                                                                                    let _e5259 = phi_14948_;
                                                                                    if (_e5255 > _e5259) {
                                                                                        phi_14953_ = _e5255;
                                                                                    } else {
                                                                                        phi_14953_ = _e5259;
                                                                                    }
                                                                                    let _e5262 = phi_14953_;
                                                                                    if (_e5238 > _e5262) {
                                                                                        phi_14958_ = _e5238;
                                                                                    } else {
                                                                                        phi_14958_ = _e5262;
                                                                                    }
                                                                                    let _e5265 = phi_14958_;
                                                                                    let _e5267 = local_18.member_3;
                                                                                    let _e5275 = local_18.member_3;
                                                                                    if (((_e5101 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e5157 + _e5159) + (_e5211 + _e5213)) + (_e5265 + _e5267)) * (1.1102230246251565e-16lf * f64(16f))) + (_e5275 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e686) {
                                                                                        phi_14982_ = false;
                                                                                    } else {
                                                                                        phi_14982_ = true;
                                                                                    }
                                                                                    let _e5287 = phi_14982_;
                                                                                    phi_14983_ = _e5287;
                                                                                } else {
                                                                                    phi_14983_ = true;
                                                                                }
                                                                                let _e5289 = phi_14983_;
                                                                                phi_14984_ = _e5289;
                                                                            } else {
                                                                                phi_14984_ = true;
                                                                            }
                                                                            let _e5291 = phi_14984_;
                                                                            if _e5291 {
                                                                                if _e4163 {
                                                                                    if _e4961 {
                                                                                        phi_15003_ = f64();
                                                                                        phi_15004_ = true;
                                                                                    } else {
                                                                                        if (_e4960 <= (_e4159 * f64(0.25f))) {
                                                                                            phi_15001_ = f64(0f);
                                                                                            phi_15002_ = false;
                                                                                        } else {
                                                                                            phi_15001_ = f64();
                                                                                            phi_15002_ = true;
                                                                                        }
                                                                                        let _e5298 = phi_15001_;
                                                                                        let _e5300 = phi_15002_;
                                                                                        phi_15003_ = _e5298;
                                                                                        phi_15004_ = _e5300;
                                                                                    }
                                                                                    let _e5302 = phi_15003_;
                                                                                    let _e5304 = phi_15004_;
                                                                                    if _e5304 {
                                                                                        phi_15009_ = (_e4488 + _e4488);
                                                                                    } else {
                                                                                        phi_15009_ = _e5302;
                                                                                    }
                                                                                    let _e5307 = phi_15009_;
                                                                                    phi_15011_ = _e5307;
                                                                                } else {
                                                                                    phi_15011_ = (_e3172.member_1 - _e4155);
                                                                                }
                                                                                let _e5309 = phi_15011_;
                                                                                phi_15012_ = _e5309;
                                                                                phi_15013_ = false;
                                                                            } else {
                                                                                phi_15012_ = f64();
                                                                                phi_15013_ = true;
                                                                            }
                                                                            let _e5311 = phi_15012_;
                                                                            let _e5313 = phi_15013_;
                                                                            phi_15014_ = _e5311;
                                                                            phi_15015_ = _e4960;
                                                                            phi_15016_ = _e5291;
                                                                            phi_15017_ = _e5313;
                                                                        }
                                                                        let _e5315 = phi_15014_;
                                                                        let _e5317 = phi_15015_;
                                                                        let _e5319 = phi_15016_;
                                                                        let _e5321 = phi_15017_;
                                                                        phi_15018_ = _e4958;
                                                                        phi_15019_ = _e5315;
                                                                        phi_15020_ = _e5317;
                                                                        phi_15021_ = _e4958;
                                                                        phi_15022_ = _e5319;
                                                                        phi_15023_ = _e4959;
                                                                        phi_15024_ = _e5321;
                                                                        phi_15025_ = false;
                                                                    } else {
                                                                        phi_15018_ = f64();
                                                                        phi_15019_ = f64();
                                                                        phi_15020_ = f64();
                                                                        phi_15021_ = f64();
                                                                        phi_15022_ = false;
                                                                        phi_15023_ = false;
                                                                        phi_15024_ = false;
                                                                        phi_15025_ = true;
                                                                    }
                                                                    let _e5323 = phi_15018_;
                                                                    let _e5325 = phi_15019_;
                                                                    let _e5327 = phi_15020_;
                                                                    let _e5329 = phi_15021_;
                                                                    let _e5331 = phi_15022_;
                                                                    let _e5333 = phi_15023_;
                                                                    let _e5335 = phi_15024_;
                                                                    let _e5337 = phi_15025_;
                                                                    phi_15026_ = _e5323;
                                                                    phi_15027_ = _e5325;
                                                                    phi_15028_ = _e5327;
                                                                    phi_15029_ = _e5329;
                                                                    phi_15030_ = false;
                                                                    phi_15031_ = _e5331;
                                                                    phi_15032_ = _e5333;
                                                                    phi_15033_ = _e5335;
                                                                    phi_15034_ = _e5337;
                                                                } else {
                                                                    phi_15026_ = f64();
                                                                    phi_15027_ = f64();
                                                                    phi_15028_ = f64();
                                                                    phi_15029_ = f64();
                                                                    phi_15030_ = true;
                                                                    phi_15031_ = false;
                                                                    phi_15032_ = false;
                                                                    phi_15033_ = false;
                                                                    phi_15034_ = false;
                                                                }
                                                                let _e5339 = phi_15026_;
                                                                let _e5341 = phi_15027_;
                                                                let _e5343 = phi_15028_;
                                                                let _e5345 = phi_15029_;
                                                                let _e5347 = phi_15030_;
                                                                let _e5349 = phi_15031_;
                                                                let _e5351 = phi_15032_;
                                                                let _e5353 = phi_15033_;
                                                                let _e5355 = phi_15034_;
                                                                phi_15035_ = _e5339;
                                                                phi_15036_ = _e5341;
                                                                phi_15037_ = _e5343;
                                                                phi_15038_ = _e5345;
                                                                phi_15039_ = _e5347;
                                                                phi_15040_ = _e5349;
                                                                phi_15041_ = _e5351;
                                                                phi_15042_ = _e5353;
                                                                phi_15043_ = _e5355;
                                                            } else {
                                                                phi_15035_ = f64();
                                                                phi_15036_ = f64();
                                                                phi_15037_ = f64();
                                                                phi_15038_ = f64();
                                                                phi_15039_ = true;
                                                                phi_15040_ = false;
                                                                phi_15041_ = false;
                                                                phi_15042_ = false;
                                                                phi_15043_ = false;
                                                            }
                                                            let _e5357 = phi_15035_;
                                                            let _e5359 = phi_15036_;
                                                            let _e5361 = phi_15037_;
                                                            let _e5363 = phi_15038_;
                                                            let _e5365 = phi_15039_;
                                                            let _e5367 = phi_15040_;
                                                            let _e5369 = phi_15041_;
                                                            let _e5371 = phi_15042_;
                                                            let _e5373 = phi_15043_;
                                                            if _e5365 {
                                                                if (_e4155 <= _e4157) {
                                                                    let _e5539 = (_e4165 + 1u);
                                                                    let _e5540 = (_e5539 > 3u);
                                                                    if _e5540 {
                                                                        phi_15056_ = false;
                                                                    } else {
                                                                        phi_15056_ = true;
                                                                    }
                                                                    let _e5542 = phi_15056_;
                                                                    phi_15383_ = _e5539;
                                                                    phi_15384_ = f64();
                                                                    phi_15385_ = false;
                                                                    phi_15386_ = _e5542;
                                                                    phi_15387_ = _e5540;
                                                                } else {
                                                                    let _e5377 = local.member[0u];
                                                                    let _e5380 = local.member_1[0u];
                                                                    let _e5383 = local.member[0u];
                                                                    let _e5389 = local.member_2[0u];
                                                                    let _e5390 = ((_e5377 + ((_e5380 - _e5383) * _e4161)) - _e5389);
                                                                    let _e5393 = local.member[1u];
                                                                    let _e5396 = local.member_1[1u];
                                                                    let _e5399 = local.member[1u];
                                                                    let _e5405 = local.member_2[1u];
                                                                    let _e5406 = ((_e5393 + ((_e5396 - _e5399) * _e4161)) - _e5405);
                                                                    if (_e5390 < _e5406) {
                                                                        phi_15129_ = _e5390;
                                                                    } else {
                                                                        phi_15129_ = _e5406;
                                                                    }
                                                                    let _e5409 = phi_15129_;
                                                                    let _e5412 = local.member[2u];
                                                                    let _e5415 = local.member_1[2u];
                                                                    let _e5418 = local.member[2u];
                                                                    let _e5424 = local.member_2[2u];
                                                                    let _e5425 = ((_e5412 + ((_e5415 - _e5418) * _e4161)) - _e5424);
                                                                    let _e5428 = local.member[3u];
                                                                    let _e5431 = local.member_1[3u];
                                                                    let _e5434 = local.member[3u];
                                                                    let _e5440 = local.member_2[3u];
                                                                    let _e5441 = ((_e5428 + ((_e5431 - _e5434) * _e4161)) - _e5440);
                                                                    if (_e5425 < _e5441) {
                                                                        phi_15202_ = _e5425;
                                                                    } else {
                                                                        phi_15202_ = _e5441;
                                                                    }
                                                                    let _e5444 = phi_15202_;
                                                                    if (_e5409 < _e5444) {
                                                                        phi_15207_ = _e5409;
                                                                    } else {
                                                                        phi_15207_ = _e5444;
                                                                    }
                                                                    let _e5447 = phi_15207_;
                                                                    let _e5450 = local_1.member[0u];
                                                                    let _e5453 = local_1.member_1[0u];
                                                                    let _e5456 = local_1.member[0u];
                                                                    let _e5462 = local_1.member_2[0u];
                                                                    let _e5463 = ((_e5450 + ((_e5453 - _e5456) * _e4155)) - _e5462);
                                                                    let _e5466 = local_1.member[1u];
                                                                    let _e5469 = local_1.member_1[1u];
                                                                    let _e5472 = local_1.member[1u];
                                                                    let _e5478 = local_1.member_2[1u];
                                                                    let _e5479 = ((_e5466 + ((_e5469 - _e5472) * _e4155)) - _e5478);
                                                                    if (_e5463 < _e5479) {
                                                                        phi_15280_ = _e5463;
                                                                    } else {
                                                                        phi_15280_ = _e5479;
                                                                    }
                                                                    let _e5482 = phi_15280_;
                                                                    let _e5485 = local_1.member[2u];
                                                                    let _e5488 = local_1.member_1[2u];
                                                                    let _e5491 = local_1.member[2u];
                                                                    let _e5497 = local_1.member_2[2u];
                                                                    let _e5498 = ((_e5485 + ((_e5488 - _e5491) * _e4155)) - _e5497);
                                                                    let _e5501 = local_1.member[3u];
                                                                    let _e5504 = local_1.member_1[3u];
                                                                    let _e5507 = local_1.member[3u];
                                                                    let _e5513 = local_1.member_2[3u];
                                                                    let _e5514 = ((_e5501 + ((_e5504 - _e5507) * _e4155)) - _e5513);
                                                                    if (_e5498 < _e5514) {
                                                                        phi_15353_ = _e5498;
                                                                    } else {
                                                                        phi_15353_ = _e5514;
                                                                    }
                                                                    let _e5517 = phi_15353_;
                                                                    if (_e5482 < _e5517) {
                                                                        phi_15358_ = _e5482;
                                                                    } else {
                                                                        phi_15358_ = _e5517;
                                                                    }
                                                                    let _e5520 = phi_15358_;
                                                                    let _e5521 = f64(0.0625f);
                                                                    let _e5523 = f64(0.9f);
                                                                    if (_e5520 > f64(0f)) {
                                                                        phi_15381_ = f64(0.5f);
                                                                    } else {
                                                                        let _e5529 = (f64(0.95f) * (_e5447 / (_e5447 - _e5520)));
                                                                        if (_e5529 > _e5521) {
                                                                            if (_e5529 < _e5523) {
                                                                                phi_15379_ = _e5529;
                                                                            } else {
                                                                                phi_15379_ = _e5523;
                                                                            }
                                                                            let _e5533 = phi_15379_;
                                                                            phi_15380_ = _e5533;
                                                                        } else {
                                                                            phi_15380_ = _e5521;
                                                                        }
                                                                        let _e5535 = phi_15380_;
                                                                        phi_15381_ = _e5535;
                                                                    }
                                                                    let _e5537 = phi_15381_;
                                                                    phi_15383_ = u32();
                                                                    phi_15384_ = (_e4488 * _e5537);
                                                                    phi_15385_ = true;
                                                                    phi_15386_ = false;
                                                                    phi_15387_ = false;
                                                                }
                                                                let _e5544 = phi_15383_;
                                                                let _e5546 = phi_15384_;
                                                                let _e5548 = phi_15385_;
                                                                let _e5550 = phi_15386_;
                                                                let _e5552 = phi_15387_;
                                                                phi_15388_ = _e5544;
                                                                phi_15389_ = _e4157;
                                                                phi_15390_ = _e5546;
                                                                phi_15391_ = _e4159;
                                                                phi_15392_ = _e4161;
                                                                phi_15393_ = _e4163;
                                                                phi_15394_ = _e4165;
                                                                phi_15395_ = _e5548;
                                                                phi_15396_ = _e5550;
                                                                phi_15397_ = _e5552;
                                                                phi_15398_ = false;
                                                                phi_15399_ = false;
                                                                phi_15400_ = false;
                                                            } else {
                                                                phi_15388_ = u32();
                                                                phi_15389_ = _e5357;
                                                                phi_15390_ = _e5359;
                                                                phi_15391_ = _e5361;
                                                                phi_15392_ = _e4155;
                                                                phi_15393_ = true;
                                                                phi_15394_ = 0u;
                                                                phi_15395_ = _e5367;
                                                                phi_15396_ = false;
                                                                phi_15397_ = false;
                                                                phi_15398_ = _e5369;
                                                                phi_15399_ = _e5371;
                                                                phi_15400_ = _e5373;
                                                            }
                                                            let _e5554 = phi_15388_;
                                                            let _e5556 = phi_15389_;
                                                            let _e5558 = phi_15390_;
                                                            let _e5560 = phi_15391_;
                                                            let _e5562 = phi_15392_;
                                                            let _e5564 = phi_15393_;
                                                            let _e5566 = phi_15394_;
                                                            let _e5568 = phi_15395_;
                                                            let _e5570 = phi_15396_;
                                                            let _e5572 = phi_15397_;
                                                            let _e5574 = phi_15398_;
                                                            let _e5576 = phi_15399_;
                                                            let _e5578 = phi_15400_;
                                                            if _e5568 {
                                                                let _e5579 = (_e5562 + _e5558);
                                                                if (_e5579 > _e5556) {
                                                                    phi_15409_ = _e5579;
                                                                } else {
                                                                    phi_15409_ = _e5556;
                                                                }
                                                                let _e5582 = phi_15409_;
                                                                if (_e5582 < _e3172.member_1) {
                                                                    phi_15414_ = _e5582;
                                                                } else {
                                                                    phi_15414_ = _e3172.member_1;
                                                                }
                                                                let _e5585 = phi_15414_;
                                                                if !(_e4163) {
                                                                    phi_15423_ = true;
                                                                } else {
                                                                    phi_15423_ = ((_e5585 - _e5562) > _e4144);
                                                                }
                                                                let _e5589 = phi_15423_;
                                                                if _e5589 {
                                                                    phi_15427_ = false;
                                                                } else {
                                                                    phi_15427_ = true;
                                                                }
                                                                let _e5591 = phi_15427_;
                                                                phi_15428_ = _e5585;
                                                                phi_15429_ = _e5556;
                                                                phi_15430_ = _e5560;
                                                                phi_15431_ = _e5562;
                                                                phi_15432_ = _e5564;
                                                                phi_15433_ = _e5566;
                                                                phi_15434_ = _e5589;
                                                                phi_15435_ = _e5591;
                                                                phi_15436_ = false;
                                                                phi_15437_ = false;
                                                                phi_15438_ = false;
                                                                phi_15439_ = false;
                                                            } else {
                                                                phi_15428_ = _e4155;
                                                                phi_15429_ = _e4157;
                                                                phi_15430_ = _e4159;
                                                                phi_15431_ = _e4161;
                                                                phi_15432_ = _e4163;
                                                                phi_15433_ = _e5554;
                                                                phi_15434_ = _e5570;
                                                                phi_15435_ = false;
                                                                phi_15436_ = _e5572;
                                                                phi_15437_ = _e5574;
                                                                phi_15438_ = _e5576;
                                                                phi_15439_ = _e5578;
                                                            }
                                                            let _e5593 = phi_15428_;
                                                            let _e5595 = phi_15429_;
                                                            let _e5597 = phi_15430_;
                                                            let _e5599 = phi_15431_;
                                                            let _e5601 = phi_15432_;
                                                            let _e5603 = phi_15433_;
                                                            let _e5605 = phi_15434_;
                                                            let _e5607 = phi_15435_;
                                                            let _e5609 = phi_15436_;
                                                            let _e5611 = phi_15437_;
                                                            let _e5613 = phi_15438_;
                                                            let _e5615 = phi_15439_;
                                                            phi_13218_ = _e5593;
                                                            phi_13220_ = _e5595;
                                                            phi_13222_ = _e5597;
                                                            phi_13224_ = _e5599;
                                                            phi_13226_ = _e5601;
                                                            phi_13228_ = _e5603;
                                                            phi_15440_ = _e5556;
                                                            phi_15441_ = _e5363;
                                                            phi_15442_ = _e5605;
                                                            phi_15443_ = _e5607;
                                                            phi_15444_ = _e5609;
                                                            phi_15445_ = _e5611;
                                                            phi_15446_ = _e5613;
                                                            phi_15447_ = false;
                                                            phi_15448_ = _e5615;
                                                        } else {
                                                            phi_13218_ = f64();
                                                            phi_13220_ = f64();
                                                            phi_13222_ = f64();
                                                            phi_13224_ = f64();
                                                            phi_13226_ = bool();
                                                            phi_13228_ = u32();
                                                            phi_15440_ = f64();
                                                            phi_15441_ = f64();
                                                            phi_15442_ = false;
                                                            phi_15443_ = false;
                                                            phi_15444_ = false;
                                                            phi_15445_ = false;
                                                            phi_15446_ = false;
                                                            phi_15447_ = true;
                                                            phi_15448_ = false;
                                                        }
                                                        let _e5617 = phi_13218_;
                                                        let _e5619 = phi_13220_;
                                                        let _e5621 = phi_13222_;
                                                        let _e5623 = phi_13224_;
                                                        let _e5625 = phi_13226_;
                                                        let _e5627 = phi_13228_;
                                                        let _e5629 = phi_15440_;
                                                        let _e5631 = phi_15441_;
                                                        let _e5633 = phi_15442_;
                                                        let _e5635 = phi_15443_;
                                                        let _e5637 = phi_15444_;
                                                        let _e5639 = phi_15445_;
                                                        let _e5641 = phi_15446_;
                                                        let _e5643 = phi_15447_;
                                                        let _e5645 = phi_15448_;
                                                        local_30 = _e5635;
                                                        local_70 = _e5637;
                                                        local_71 = _e5639;
                                                        local_72 = _e5641;
                                                        local_73 = _e5643;
                                                        local_74 = _e5645;
                                                        local_75 = _e5635;
                                                        local_76 = _e5631;
                                                        local_77 = _e5629;
                                                        continue;
                                                        continuing {
                                                            phi_13214_ = _e4177;
                                                            phi_13217_ = _e5617;
                                                            phi_13219_ = _e5619;
                                                            phi_13221_ = _e5621;
                                                            phi_13223_ = _e5623;
                                                            phi_13225_ = _e5625;
                                                            phi_13227_ = _e5627;
                                                            break if !(_e5633);
                                                        }
                                                    }
                                                    let _e5648 = local_30;
                                                    if _e5648 {
                                                        phi_15452_ = false;
                                                        phi_15453_ = false;
                                                        phi_15454_ = false;
                                                        phi_15455_ = false;
                                                        phi_15456_ = false;
                                                    } else {
                                                        let _e11390 = local_70;
                                                        phi_15452_ = _e11390;
                                                        let _e11393 = local_71;
                                                        phi_15453_ = _e11393;
                                                        let _e11396 = local_72;
                                                        phi_15454_ = _e11396;
                                                        let _e11399 = local_73;
                                                        phi_15455_ = _e11399;
                                                        let _e11402 = local_74;
                                                        phi_15456_ = _e11402;
                                                    }
                                                    let _e5650 = phi_15452_;
                                                    let _e5652 = phi_15453_;
                                                    let _e5654 = phi_15454_;
                                                    let _e5656 = phi_15455_;
                                                    let _e5658 = phi_15456_;
                                                    if _e5650 {
                                                        let _e5660 = local_31;
                                                        phi_15461_ = type_46(1u, _e5660);
                                                        phi_15462_ = false;
                                                        phi_15463_ = false;
                                                        phi_15464_ = false;
                                                        phi_15465_ = false;
                                                        phi_15466_ = false;
                                                    } else {
                                                        phi_15461_ = type_46();
                                                        phi_15462_ = _e5652;
                                                        phi_15463_ = _e5654;
                                                        let _e11409 = local_75;
                                                        phi_15464_ = _e11409;
                                                        phi_15465_ = _e5656;
                                                        phi_15466_ = _e5658;
                                                    }
                                                    let _e5663 = phi_15461_;
                                                    let _e5665 = phi_15462_;
                                                    let _e5667 = phi_15463_;
                                                    let _e5669 = phi_15464_;
                                                    let _e5671 = phi_15465_;
                                                    let _e5673 = phi_15466_;
                                                    if _e5665 {
                                                        phi_15471_ = type_46(0u, type_46().member_1);
                                                        phi_15472_ = false;
                                                        phi_15473_ = false;
                                                        phi_15474_ = false;
                                                        phi_15475_ = false;
                                                        phi_15476_ = true;
                                                    } else {
                                                        phi_15471_ = _e5663;
                                                        phi_15472_ = _e5667;
                                                        phi_15473_ = _e5669;
                                                        phi_15474_ = _e5671;
                                                        phi_15475_ = _e5673;
                                                        phi_15476_ = _e5650;
                                                    }
                                                    let _e5677 = phi_15471_;
                                                    let _e5679 = phi_15472_;
                                                    let _e5681 = phi_15473_;
                                                    let _e5683 = phi_15474_;
                                                    let _e5685 = phi_15475_;
                                                    let _e5687 = phi_15476_;
                                                    if _e5679 {
                                                        let _e11420 = local_76;
                                                        phi_15480_ = _e11420;
                                                        phi_15481_ = true;
                                                        phi_15482_ = false;
                                                        phi_15483_ = false;
                                                        phi_15484_ = false;
                                                    } else {
                                                        let _e11422 = local_77;
                                                        phi_15480_ = _e11422;
                                                        phi_15481_ = _e5681;
                                                        phi_15482_ = _e5683;
                                                        phi_15483_ = _e5685;
                                                        phi_15484_ = _e5687;
                                                    }
                                                    let _e5689 = phi_15480_;
                                                    let _e5691 = phi_15481_;
                                                    let _e5693 = phi_15482_;
                                                    let _e5695 = phi_15483_;
                                                    let _e5697 = phi_15484_;
                                                    if _e5691 {
                                                        phi_15488_ = _e5689;
                                                        phi_15489_ = true;
                                                        phi_15490_ = false;
                                                        phi_15491_ = false;
                                                    } else {
                                                        let _e11429 = local_78;
                                                        phi_15488_ = _e11429;
                                                        phi_15489_ = _e5693;
                                                        phi_15490_ = _e5695;
                                                        phi_15491_ = _e5697;
                                                    }
                                                    let _e5699 = phi_15488_;
                                                    let _e5701 = phi_15489_;
                                                    let _e5703 = phi_15490_;
                                                    let _e5705 = phi_15491_;
                                                    if _e5701 {
                                                        phi_15496_ = type_46(1u, _e5699);
                                                        phi_15497_ = false;
                                                        phi_15498_ = false;
                                                    } else {
                                                        phi_15496_ = type_46();
                                                        phi_15497_ = _e5703;
                                                        phi_15498_ = _e5705;
                                                    }
                                                    let _e5708 = phi_15496_;
                                                    let _e5710 = phi_15497_;
                                                    let _e5712 = phi_15498_;
                                                    if _e5710 {
                                                        phi_15503_ = type_46(0u, type_46().member_1);
                                                        phi_15504_ = true;
                                                    } else {
                                                        phi_15503_ = _e5677;
                                                        phi_15504_ = _e5712;
                                                    }
                                                    let _e5716 = phi_15503_;
                                                    let _e5718 = phi_15504_;
                                                    if _e5718 {
                                                        phi_15508_ = _e5716;
                                                    } else {
                                                        phi_15508_ = _e5708;
                                                    }
                                                    let _e5720 = phi_15508_;
                                                    let _e5723 = (_e5720.member != 0u);
                                                    if _e5723 {
                                                        phi_15515_ = false;
                                                    } else {
                                                        phi_15515_ = true;
                                                    }
                                                    let _e5725 = phi_15515_;
                                                    phi_15516_ = _e5720.member_1;
                                                    phi_15517_ = _e5725;
                                                    phi_15518_ = _e5723;
                                                    phi_15519_ = false;
                                                } else {
                                                    phi_15516_ = f64();
                                                    phi_15517_ = false;
                                                    phi_15518_ = false;
                                                    phi_15519_ = true;
                                                }
                                                let _e5727 = phi_15516_;
                                                let _e5729 = phi_15517_;
                                                let _e5731 = phi_15518_;
                                                let _e5733 = phi_15519_;
                                                phi_15520_ = _e3901;
                                                phi_15521_ = _e3903;
                                                phi_15522_ = _e5727;
                                                phi_15523_ = _e5729;
                                                phi_15524_ = _e5731;
                                                phi_15525_ = _e5733;
                                            }
                                            let _e5735 = phi_15520_;
                                            let _e5737 = phi_15521_;
                                            let _e5739 = phi_15522_;
                                            let _e5741 = phi_15523_;
                                            let _e5743 = phi_15524_;
                                            let _e5745 = phi_15525_;
                                            phi_15526_ = _e5735;
                                            phi_15527_ = _e5737;
                                            phi_15528_ = _e5739;
                                            phi_15529_ = _e3897;
                                            phi_15530_ = _e5741;
                                            phi_15531_ = _e5743;
                                            phi_15532_ = _e5745;
                                        }
                                        let _e5747 = phi_15526_;
                                        let _e5749 = phi_15527_;
                                        let _e5751 = phi_15528_;
                                        let _e5753 = phi_15529_;
                                        let _e5755 = phi_15530_;
                                        let _e5757 = phi_15531_;
                                        let _e5759 = phi_15532_;
                                        if _e5753 {
                                            phi_15536_ = false;
                                            phi_15537_ = false;
                                            phi_15538_ = false;
                                        } else {
                                            phi_15536_ = _e5755;
                                            phi_15537_ = _e5757;
                                            phi_15538_ = _e5759;
                                        }
                                        let _e5761 = phi_15536_;
                                        let _e5763 = phi_15537_;
                                        let _e5765 = phi_15538_;
                                        phi_15539_ = _e3172;
                                        phi_15540_ = _e5747;
                                        phi_15541_ = _e5749;
                                        phi_15542_ = _e5751;
                                        phi_15543_ = _e3172;
                                        phi_15544_ = _e5753;
                                        phi_15545_ = _e5761;
                                        phi_15546_ = _e5763;
                                        phi_15547_ = _e5765;
                                    } else {
                                        phi_15539_ = type_49();
                                        phi_15540_ = bool();
                                        phi_15541_ = f64();
                                        phi_15542_ = f64();
                                        phi_15543_ = type_49();
                                        phi_15544_ = true;
                                        phi_15545_ = false;
                                        phi_15546_ = false;
                                        phi_15547_ = false;
                                    }
                                    let _e5767 = phi_15539_;
                                    let _e5769 = phi_15540_;
                                    let _e5771 = phi_15541_;
                                    let _e5773 = phi_15542_;
                                    let _e5775 = phi_15543_;
                                    let _e5777 = phi_15544_;
                                    let _e5779 = phi_15545_;
                                    let _e5781 = phi_15546_;
                                    let _e5783 = phi_15547_;
                                    if _e5777 {
                                        phi_15551_ = true;
                                        phi_15552_ = false;
                                        phi_15553_ = false;
                                    } else {
                                        phi_15551_ = _e5779;
                                        phi_15552_ = _e5781;
                                        phi_15553_ = _e5783;
                                    }
                                    let _e5785 = phi_15551_;
                                    let _e5787 = phi_15552_;
                                    let _e5789 = phi_15553_;
                                    phi_15554_ = _e5767;
                                    phi_15555_ = _e5769;
                                    phi_15556_ = _e5771;
                                    phi_15557_ = _e5773;
                                    phi_15558_ = _e5775;
                                    phi_15559_ = _e5785;
                                    phi_15560_ = false;
                                    phi_15561_ = _e5787;
                                    phi_15562_ = _e5789;
                                } else {
                                    phi_15554_ = type_49();
                                    phi_15555_ = bool();
                                    phi_15556_ = f64();
                                    phi_15557_ = f64();
                                    phi_15558_ = type_49();
                                    phi_15559_ = false;
                                    phi_15560_ = true;
                                    phi_15561_ = false;
                                    phi_15562_ = false;
                                }
                                let _e5791 = phi_15554_;
                                let _e5793 = phi_15555_;
                                let _e5795 = phi_15556_;
                                let _e5797 = phi_15557_;
                                let _e5799 = phi_15558_;
                                let _e5801 = phi_15559_;
                                let _e5803 = phi_15560_;
                                let _e5805 = phi_15561_;
                                let _e5807 = phi_15562_;
                                local_32 = _e5803;
                                local_79 = _e5805;
                                local_80 = _e5807;
                                local_33 = _e5793;
                                local_34 = _e5791;
                                local_35 = _e5797;
                                local_36 = _e5795;
                                local_37 = _e5797;
                                local_38 = _e5797;
                                local_39 = _e5799;
                                continue;
                                continuing {
                                    phi_11276_ = _e2880;
                                    break if !(_e5801);
                                }
                            }
                            let _e5810 = local_32;
                            if _e5810 {
                                phi_15567_ = type_46(0u, type_46().member_1);
                                phi_15568_ = false;
                                phi_15569_ = false;
                            } else {
                                phi_15567_ = type_46();
                                let _e11485 = local_79;
                                phi_15568_ = _e11485;
                                let _e11488 = local_80;
                                phi_15569_ = _e11488;
                            }
                            let _e5814 = phi_15567_;
                            let _e5816 = phi_15568_;
                            let _e5818 = phi_15569_;
                            if _e5816 {
                                let _e5820 = local_33;
                                if _e5820 {
                                    let _e5822 = local_34;
                                    let _e5825 = local_35;
                                    let _e5828 = local_36;
                                    if ((_e5822.member_1 - _e5825) <= _e5828) {
                                        let _e5831 = local_37;
                                        phi_15583_ = type_46(1u, _e5831);
                                        phi_15584_ = false;
                                    } else {
                                        phi_15583_ = type_46();
                                        phi_15584_ = true;
                                    }
                                    let _e5834 = phi_15583_;
                                    let _e5836 = phi_15584_;
                                    phi_15585_ = _e5834;
                                    phi_15586_ = _e5836;
                                } else {
                                    phi_15585_ = type_46();
                                    phi_15586_ = true;
                                }
                                let _e5838 = phi_15585_;
                                let _e5840 = phi_15586_;
                                if _e5840 {
                                    let _e5842 = local_38;
                                    phi_15591_ = type_46(2u, _e5842);
                                } else {
                                    phi_15591_ = _e5838;
                                }
                                let _e5845 = phi_15591_;
                                phi_15592_ = _e5845;
                                phi_15593_ = false;
                            } else {
                                phi_15592_ = type_46();
                                phi_15593_ = _e5818;
                            }
                            let _e5847 = phi_15592_;
                            let _e5849 = phi_15593_;
                            if _e5849 {
                                let _e5851 = local_39;
                                phi_15599_ = type_46(1u, _e5851.member);
                                phi_15600_ = true;
                            } else {
                                phi_15599_ = _e5847;
                                phi_15600_ = _e5816;
                            }
                            let _e5855 = phi_15599_;
                            let _e5857 = phi_15600_;
                            phi_15604_ = _e5855;
                            phi_15605_ = _e5814;
                            phi_15606_ = _e5857;
                        } else {
                            phi_15604_ = _e2724;
                            phi_15605_ = type_46();
                            phi_15606_ = true;
                        }
                        let _e5859 = phi_15604_;
                        let _e5861 = phi_15605_;
                        let _e5863 = phi_15606_;
                        phi_15610_ = _e5859;
                        phi_15611_ = _e5861;
                        phi_15612_ = _e5863;
                    }
                    let _e5867 = phi_15610_;
                    let _e5869 = phi_15611_;
                    let _e5871 = phi_15612_;
                    if _e5871 {
                        phi_15616_ = _e5867;
                    } else {
                        phi_15616_ = _e5869;
                    }
                    let _e5873 = phi_15616_;
                    if (_e5873.member == 1u) {
                        if (_e5873.member_1 > _e430) {
                            phi_15627_ = false;
                        } else {
                            phi_15627_ = true;
                        }
                        let _e5879 = phi_15627_;
                        phi_15628_ = _e5879;
                    } else {
                        phi_15628_ = true;
                    }
                    let _e5881 = phi_15628_;
                    if _e5881 {
                        phi_15632_ = false;
                    } else {
                        phi_15632_ = true;
                    }
                    let _e5883 = phi_15632_;
                    if _e5883 {
                        phi_15636_ = 1u;
                    } else {
                        phi_15636_ = 0u;
                    }
                    let _e5885 = phi_15636_;
                    phi_15640_ = type_47(_e5873, _e5885);
                }
                let _e10513 = phi_15640_;
                switch bitcast<i32>(_e10513.member.member) {
                    case 0: {
                        phi_15655_ = type_37(0u, _e10513.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e10524 = function_1(_e10513.member.member_1);
                        phi_15655_ = type_37(0u, _e10513.member_1, _e10524, true);
                        break;
                    }
                    case 2: {
                        let _e10520 = function_1(_e10513.member.member_1);
                        phi_15655_ = type_37(1u, _e10513.member_1, _e10520, true);
                        break;
                    }
                    default: {
                        phi_15655_ = type_37();
                        break;
                    }
                }
                let _e10528 = phi_15655_;
                if _e10528.member_3 {
                    let _e10536 = (_e10528.member_2[1] >> bitcast<u32>(20i));
                    if (_e10536 <= 896u) {
                        phi_15679_ = 0u;
                    } else {
                        phi_15679_ = ((((_e10536 - 896u) << bitcast<u32>(23i)) | ((_e10528.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e10528.member_2[0] >> bitcast<u32>(29i)));
                    }
                    let _e10551 = phi_15679_;
                    let _e10553 = atomicMin((&earliest.member[0u]), _e10551);
                }
                phi_15683_ = type_22(1u, _e10528.member, _e212, _e215, _e10528.member_2, _e10528.member_1);
                phi_15684_ = _e10528.member_3;
            } else {
                phi_15683_ = type_22(1u, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_15684_ = false;
            }
            let _e10555 = phi_15683_;
            let _e10557 = phi_15684_;
            let _e10560 = params.member.member.member_1;
            if ((_e10560 & 16u) != 0u) {
                if (_e124 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e10557 {
                    let _e10566 = atomicAdd((&counters[0u]), 1u);
                    phi_15703_ = _e10566;
                } else {
                    phi_15703_ = 0u;
                }
                let _e10568 = phi_15703_;
                workgroupBarrier();
                if (_e124 == 0u) {
                    let _e10571 = atomicLoad((&counters[0u]));
                    if (_e10571 > 0u) {
                        let _e10574 = atomicAdd((&contacts.member[0u]), _e10571);
                        atomicStore((&counters[1u]), _e10574);
                    }
                }
                workgroupBarrier();
                let _e10577 = atomicLoad((&counters[1u]));
                let _e10578 = (_e10577 + _e10568);
                if _e10557 {
                    let _e10581 = params.member.member_1.member_3;
                    if (_e10578 < _e10581) {
                        let _e10583 = (7u * _e10578);
                        atomicStore((&contacts.member[(4u + _e10583)]), _e10555.member);
                        atomicStore((&contacts.member[(_e10583 + 5u)]), _e10555.member_1);
                        atomicStore((&contacts.member[(_e10583 + 6u)]), _e10555.member_2);
                        atomicStore((&contacts.member[(_e10583 + 7u)]), _e10555.member_3);
                        atomicStore((&contacts.member[(_e10583 + 8u)]), _e10555.member_4[0]);
                        atomicStore((&contacts.member[(_e10583 + 9u)]), _e10555.member_4[1]);
                        atomicStore((&contacts.member[(_e10583 + 10u)]), _e10555.member_5);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_459_ = _e193;
            break if !(_e199);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_edge_edge_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_5(id, n, lane);
}
