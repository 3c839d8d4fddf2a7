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

struct type_21 {
    member: array<array<u32, 2>>,
}

struct type_23 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_25 {
    member: array<array<u32, 3>>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
    member_2: array<f32, 3>,
    member_3: array<f32, 3>,
    member_4: f32,
    member_5: f32,
    member_6: f32,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: f32,
}

struct type_31 {
    member: type_7,
    member_1: type_8,
    member_2: type_30,
}

struct type_32 {
    member: type_31,
}

struct type_33 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: u32,
    member_4: array<f32, 4>,
    member_5: array<u32, 4>,
}

struct type_35 {
    member: array<type_33>,
}

struct type_37 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_38 {
    member: f32,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

@group(0) @binding(1) 
var<storage> paths: type_19;
@group(0) @binding(0) 
var<storage> params: type_32;
@group(0) @binding(2) 
var<storage> edges: type_21;
@group(0) @binding(3) 
var<storage> faces: type_25;
@group(0) @binding(4) 
var<storage> contacts: type_11;
@group(0) @binding(5) 
var<storage, read_write> geometry: type_35;

fn function_(param: array<f32, 4>, param_1: u32) -> array<f32, 4> {
    var phi_4433_: array<f32, 4>;

    switch bitcast<i32>(param_1) {
        case 0: {
            phi_4433_ = param;
            break;
        }
        case 1: {
            phi_4433_ = array<f32, 4>(param[0], param[3], param[1], param[2]);
            break;
        }
        default: {
            phi_4433_ = array<f32, 4>(param[0], param[2], param[3], param[1]);
            break;
        }
    }
    let _e14 = phi_4433_;
    return _e14;
}

fn function_1(param_2: array<array<f32, 3>, 2>) -> array<f32, 3> {
    return array<f32, 3>((param_2[1][0] - param_2[0][0]), (param_2[1][1] - param_2[0][1]), (param_2[1][2] - param_2[0][2]));
}

fn function_2(param_3: type_38, param_4: type_38) -> type_38 {
    var phi_4401_: type_38;

    if (param_4.member_3 < param_3.member_3) {
        phi_4401_ = param_4;
    } else {
        phi_4401_ = param_3;
    }
    let _e6 = phi_4401_;
    return _e6;
}

fn function_3(param_5: f32, param_6: f32) -> f32 {
    var phi_3476_: f32;
    var phi_3481_: f32;
    var phi_3482_: f32;

    if (param_5 > 0f) {
        if (param_5 < param_6) {
            phi_3476_ = param_5;
        } else {
            phi_3476_ = param_6;
        }
        let _e6 = phi_3476_;
        if (_e6 > 0f) {
            phi_3481_ = _e6;
        } else {
            phi_3481_ = 0f;
        }
        let _e9 = phi_3481_;
        phi_3482_ = _e9;
    } else {
        phi_3482_ = 0f;
    }
    let _e11 = phi_3482_;
    return _e11;
}

fn function_4(param_7: ptr<function, type_26>, param_8: f32, param_9: f32) -> f32 {
    let _e4 = (*param_7).member;
    let _e9 = (*param_7).member_2;
    let _e20 = (*param_7).member_1;
    let _e30 = (*param_7).member_1;
    let _e35 = (*param_7).member_1;
    let _e45 = function_3((((((_e4[0] - (_e9[0] * param_8)) * _e20[0]) + ((_e4[1] - (_e9[1] * param_8)) * _e20[1])) + ((_e4[2] - (_e9[2] * param_8)) * _e20[2])) / (((_e30[0] * _e35[0]) + (_e30[1] * _e35[1])) + (_e30[2] * _e35[2]))), param_9);
    return _e45;
}

fn function_5(param_10: ptr<function, type_26>, param_11: f32, param_12: f32) -> type_38 {
    let _e4 = (*param_10).member;
    let _e9 = (*param_10).member_1;
    let _e20 = (*param_10).member_2;
    let _e27 = ((_e4[0] - (_e9[0] * param_11)) - (_e20[0] * param_12));
    let _e28 = ((_e4[1] - (_e9[1] * param_11)) - (_e20[1] * param_12));
    let _e29 = ((_e4[2] - (_e9[2] * param_11)) - (_e20[2] * param_12));
    return type_38(param_11, param_12, array<f32, 3>(_e27, _e28, _e29), (((_e27 * _e27) + (_e28 * _e28)) + (_e29 * _e29)));
}

fn function_6(param_13: ptr<function, type_26>, param_14: f32, param_15: f32) -> f32 {
    let _e4 = (*param_13).member;
    let _e9 = (*param_13).member_1;
    let _e20 = (*param_13).member_2;
    let _e30 = (*param_13).member_2;
    let _e35 = (*param_13).member_2;
    let _e45 = function_3((((((_e4[0] - (_e9[0] * param_14)) * _e20[0]) + ((_e4[1] - (_e9[1] * param_14)) * _e20[1])) + ((_e4[2] - (_e9[2] * param_14)) * _e20[2])) / (((_e30[0] * _e35[0]) + (_e30[1] * _e35[1])) + (_e30[2] * _e35[2]))), param_15);
    return _e45;
}

fn function_7(param_16: ptr<function, type_26>, param_17: u32) -> type_38 {
    var phi_4100_: f32;
    var phi_4107_: f32;
    var phi_4118_: type_38;
    var phi_4119_: bool;
    var phi_4120_: type_38;
    var phi_4121_: bool;
    var phi_3977_: bool;
    var phi_3978_: bool;
    var phi_3994_: f32;
    var phi_4000_: f32;
    var phi_4003_: type_38;
    var phi_4004_: bool;
    var phi_4005_: type_38;
    var phi_4006_: bool;
    var phi_4007_: type_38;
    var phi_4008_: bool;
    var phi_4125_: type_38;
    var phi_4126_: bool;
    var phi_4201_: type_38;
    var phi_4202_: type_38;
    var phi_4203_: bool;
    var phi_4207_: type_38;

    let _e9 = (param_17 == 0u);
    let _e11 = (*param_16).member_4;
    if (_e11 > 0f) {
        let _e90 = (*param_16).member_3;
        let _e95 = (*param_16).member_3;
        let _e103 = (((_e90[0] * _e95[0]) + (_e90[1] * _e95[1])) + (_e90[2] * _e95[2]));
        let _e105 = (*param_16).member;
        let _e110 = (*param_16).member_2;
        let _e124 = (*param_16).member_3;
        let _e133 = ((((((_e105[1] * _e110[2]) - (_e105[2] * _e110[1])) * _e124[0]) + (((_e105[2] * _e110[0]) - (_e105[0] * _e110[2])) * _e124[1])) + (((_e105[0] * _e110[1]) - (_e105[1] * _e110[0])) * _e124[2])) / _e103);
        let _e135 = (*param_16).member_1;
        let _e140 = (*param_16).member;
        let _e154 = (*param_16).member_3;
        let _e163 = ((((((_e135[1] * _e140[2]) - (_e135[2] * _e140[1])) * _e154[0]) + (((_e135[2] * _e140[0]) - (_e135[0] * _e140[2])) * _e154[1])) + (((_e135[0] * _e140[1]) - (_e135[1] * _e140[0])) * _e154[2])) / _e103);
        if _e9 {
            phi_3978_ = ((_e133 + _e163) <= 1f);
        } else {
            if (_e133 <= 1f) {
                phi_3977_ = (_e163 <= 1f);
            } else {
                phi_3977_ = false;
            }
            let _e167 = phi_3977_;
            phi_3978_ = _e167;
        }
        let _e171 = phi_3978_;
        if (_e133 >= 0f) {
            if (_e163 >= 0f) {
                if _e171 {
                    if _e9 {
                        phi_3994_ = (1f - _e133);
                    } else {
                        phi_3994_ = 1f;
                    }
                    let _e176 = phi_3994_;
                    let _e177 = function_6(param_16, _e133, _e176);
                    if _e9 {
                        phi_4000_ = (1f - _e177);
                    } else {
                        phi_4000_ = 1f;
                    }
                    let _e180 = phi_4000_;
                    let _e181 = function_4(param_16, _e177, _e180);
                    let _e182 = function_5(param_16, _e181, _e177);
                    phi_4003_ = _e182;
                    phi_4004_ = false;
                } else {
                    phi_4003_ = type_38();
                    phi_4004_ = true;
                }
                let _e184 = phi_4003_;
                let _e186 = phi_4004_;
                phi_4005_ = _e184;
                phi_4006_ = _e186;
            } else {
                phi_4005_ = type_38();
                phi_4006_ = true;
            }
            let _e188 = phi_4005_;
            let _e190 = phi_4006_;
            phi_4007_ = _e188;
            phi_4008_ = _e190;
        } else {
            phi_4007_ = type_38();
            phi_4008_ = true;
        }
        let _e192 = phi_4007_;
        let _e194 = phi_4008_;
        phi_4125_ = _e192;
        phi_4126_ = _e194;
    } else {
        if _e9 {
            phi_4120_ = type_38();
            phi_4121_ = true;
        } else {
            let _e14 = (*param_16).member;
            let _e19 = (*param_16).member_1;
            let _e27 = (((_e14[0] * _e19[0]) + (_e14[1] * _e19[1])) + (_e14[2] * _e19[2]));
            let _e29 = (*param_16).member;
            let _e34 = (*param_16).member_2;
            let _e42 = (*param_16).member_1;
            let _e50 = ((((_e29[0] - _e34[0]) * _e42[0]) + ((_e29[1] - _e34[1]) * _e42[1])) + ((_e29[2] - _e34[2]) * _e42[2]));
            let _e52 = (*param_16).member_1;
            let _e57 = (*param_16).member_1;
            let _e65 = (((_e52[0] * _e57[0]) + (_e52[1] * _e57[1])) + (_e52[2] * _e57[2]));
            if (_e27 < _e50) {
                phi_4100_ = _e27;
            } else {
                phi_4100_ = _e50;
            }
            let _e68 = phi_4100_;
            let _e70 = function_3((_e68 / _e65), 1f);
            if (_e27 > _e50) {
                phi_4107_ = _e27;
            } else {
                phi_4107_ = _e50;
            }
            let _e73 = phi_4107_;
            let _e75 = function_3((_e73 / _e65), 1f);
            if (_e70 < _e75) {
                let _e78 = ((_e70 + _e75) * 0.5f);
                let _e79 = function_6(param_16, _e78, 1f);
                let _e80 = function_5(param_16, _e78, _e79);
                phi_4118_ = _e80;
                phi_4119_ = false;
            } else {
                phi_4118_ = type_38();
                phi_4119_ = true;
            }
            let _e82 = phi_4118_;
            let _e84 = phi_4119_;
            phi_4120_ = _e82;
            phi_4121_ = _e84;
        }
        let _e86 = phi_4120_;
        let _e88 = phi_4121_;
        phi_4125_ = _e86;
        phi_4126_ = _e88;
    }
    let _e196 = phi_4125_;
    let _e198 = phi_4126_;
    if _e198 {
        let _e199 = function_4(param_16, 0f, 1f);
        let _e200 = function_5(param_16, _e199, 0f);
        let _e201 = function_6(param_16, 0f, 1f);
        let _e202 = function_5(param_16, 0f, _e201);
        let _e203 = function_2(_e200, _e202);
        if _e9 {
            let _e211 = (*param_16).member_2;
            let _e216 = (*param_16).member_1;
            let _e220 = (_e211[0] - _e216[0]);
            let _e221 = (_e211[1] - _e216[1]);
            let _e222 = (_e211[2] - _e216[2]);
            let _e224 = (*param_16).member;
            let _e229 = (*param_16).member_1;
            let _e247 = function_3((((((_e224[0] - _e229[0]) * _e220) + ((_e224[1] - _e229[1]) * _e221)) + ((_e224[2] - _e229[2]) * _e222)) / (((_e220 * _e220) + (_e221 * _e221)) + (_e222 * _e222))), 1f);
            let _e249 = function_5(param_16, (1f - _e247), _e247);
            let _e250 = function_2(_e203, _e249);
            phi_4201_ = _e250;
        } else {
            let _e204 = function_6(param_16, 1f, 1f);
            let _e205 = function_5(param_16, 1f, _e204);
            let _e206 = function_4(param_16, 1f, 1f);
            let _e207 = function_5(param_16, _e206, 1f);
            let _e208 = function_2(_e205, _e207);
            let _e209 = function_2(_e203, _e208);
            phi_4201_ = _e209;
        }
        let _e252 = phi_4201_;
        phi_4202_ = _e252;
        phi_4203_ = false;
    } else {
        phi_4202_ = type_38();
        phi_4203_ = true;
    }
    let _e254 = phi_4202_;
    let _e256 = phi_4203_;
    if _e256 {
        phi_4207_ = _e196;
    } else {
        phi_4207_ = _e254;
    }
    let _e258 = phi_4207_;
    return _e258;
}

fn function_8(param_18: f32) -> f32 {
    var phi_3833_: u32;
    var phi_3836_: f32;
    var phi_3837_: f32;

    if ((bitcast<u32>(param_18) & 2139095040u) != 2139095040u) {
        if (param_18 >= 0.000000000000000000000000000000000000011754944f) {
            let _e13 = (2130706432u - (bitcast<u32>(param_18) & 2139095040u));
            if (_e13 > 8388608u) {
                phi_3833_ = _e13;
            } else {
                phi_3833_ = 8388608u;
            }
            let _e16 = phi_3833_;
            phi_3836_ = bitcast<f32>(_e16);
        } else {
            phi_3836_ = (1f / 0.000000000000000000000000000000000000011754944f);
        }
        let _e19 = phi_3836_;
        phi_3837_ = _e19;
    } else {
        phi_3837_ = 1f;
    }
    let _e21 = phi_3837_;
    return _e21;
}

fn function_9(param_19: array<f32, 3>, param_20: array<f32, 3>, param_21: f32) -> array<f32, 3> {
    let _e4 = (1f - param_21);
    return array<f32, 3>(((param_19[0] * _e4) + (param_20[0] * param_21)), ((param_19[1] * _e4) + (param_20[1] * param_21)), ((param_19[2] * _e4) + (param_20[2] * param_21)));
}

fn function_10(param_22: ptr<function, array<array<f32, 3>, 4>>, param_23: u32) -> array<array<f32, 3>, 4> {
    var phi_3810_: array<array<f32, 3>, 4>;

    switch bitcast<i32>(param_23) {
        case 0: {
            let _e32 = (*param_22);
            phi_3810_ = array<array<f32, 3>, 4>(array<f32, 3>(_e32[0][0], _e32[0][1], _e32[0][2]), array<f32, 3>(_e32[1][0], _e32[1][1], _e32[1][2]), array<f32, 3>(_e32[2][0], _e32[2][1], _e32[2][2]), array<f32, 3>(_e32[3][0], _e32[3][1], _e32[3][2]));
            break;
        }
        case 1: {
            let _e8 = (*param_22)[0u];
            let _e14 = (*param_22)[2u];
            let _e20 = (*param_22)[3u];
            let _e26 = (*param_22)[1u];
            phi_3810_ = array<array<f32, 3>, 4>(array<f32, 3>(_e8[0], _e8[1], _e8[2]), array<f32, 3>(_e14[0], _e14[1], _e14[2]), array<f32, 3>(_e20[0], _e20[1], _e20[2]), array<f32, 3>(_e26[0], _e26[1], _e26[2]));
            break;
        }
        default: {
            let _e55 = (*param_22)[0u];
            let _e61 = (*param_22)[3u];
            let _e67 = (*param_22)[1u];
            let _e73 = (*param_22)[2u];
            phi_3810_ = array<array<f32, 3>, 4>(array<f32, 3>(_e55[0], _e55[1], _e55[2]), array<f32, 3>(_e61[0], _e61[1], _e61[2]), array<f32, 3>(_e67[0], _e67[1], _e67[2]), array<f32, 3>(_e73[0], _e73[1], _e73[2]));
            break;
        }
    }
    let _e80 = phi_3810_;
    return _e80;
}

fn function_11(param_24: ptr<function, array<array<f32, 3>, 4>>, param_25: ptr<function, array<array<f32, 3>, 4>>, param_26: f32) -> u32 {
    var phi_3538_: f32;
    var phi_3545_: f32;
    var phi_3553_: f32;
    var phi_3606_: f32;
    var phi_3613_: f32;
    var phi_3621_: f32;
    var phi_3674_: f32;
    var phi_3681_: f32;
    var phi_3689_: f32;
    var phi_3699_: bool;
    var phi_3700_: bool;
    var phi_3708_: u32;
    var phi_3709_: u32;

    let _e11 = (*param_24)[3u];
    let _e16 = (*param_24)[2u];
    let _e25 = (*param_25)[3u];
    let _e30 = (*param_25)[2u];
    let _e38 = function_9(array<f32, 3>((_e11[0] - _e16[0]), (_e11[1] - _e16[1]), (_e11[2] - _e16[2])), array<f32, 3>((_e25[0] - _e30[0]), (_e25[1] - _e30[1]), (_e25[2] - _e30[2])), param_26);
    if (_e38[0] < 0f) {
        phi_3538_ = -(_e38[0]);
    } else {
        phi_3538_ = _e38[0];
    }
    let _e43 = phi_3538_;
    if (_e38[1] < 0f) {
        phi_3545_ = -(_e38[1]);
    } else {
        phi_3545_ = _e38[1];
    }
    let _e48 = phi_3545_;
    if (_e38[2] < 0f) {
        phi_3553_ = -(_e38[2]);
    } else {
        phi_3553_ = _e38[2];
    }
    let _e54 = phi_3553_;
    let _e55 = ((_e43 + _e48) + _e54);
    let _e57 = (*param_24)[1u];
    let _e62 = (*param_24)[3u];
    let _e71 = (*param_25)[1u];
    let _e76 = (*param_25)[3u];
    let _e84 = function_9(array<f32, 3>((_e57[0] - _e62[0]), (_e57[1] - _e62[1]), (_e57[2] - _e62[2])), array<f32, 3>((_e71[0] - _e76[0]), (_e71[1] - _e76[1]), (_e71[2] - _e76[2])), param_26);
    if (_e84[0] < 0f) {
        phi_3606_ = -(_e84[0]);
    } else {
        phi_3606_ = _e84[0];
    }
    let _e89 = phi_3606_;
    if (_e84[1] < 0f) {
        phi_3613_ = -(_e84[1]);
    } else {
        phi_3613_ = _e84[1];
    }
    let _e94 = phi_3613_;
    if (_e84[2] < 0f) {
        phi_3621_ = -(_e84[2]);
    } else {
        phi_3621_ = _e84[2];
    }
    let _e100 = phi_3621_;
    let _e101 = ((_e89 + _e94) + _e100);
    let _e103 = (*param_24)[2u];
    let _e108 = (*param_24)[1u];
    let _e117 = (*param_25)[2u];
    let _e122 = (*param_25)[1u];
    let _e130 = function_9(array<f32, 3>((_e103[0] - _e108[0]), (_e103[1] - _e108[1]), (_e103[2] - _e108[2])), array<f32, 3>((_e117[0] - _e122[0]), (_e117[1] - _e122[1]), (_e117[2] - _e122[2])), param_26);
    if (_e130[0] < 0f) {
        phi_3674_ = -(_e130[0]);
    } else {
        phi_3674_ = _e130[0];
    }
    let _e135 = phi_3674_;
    if (_e130[1] < 0f) {
        phi_3681_ = -(_e130[1]);
    } else {
        phi_3681_ = _e130[1];
    }
    let _e140 = phi_3681_;
    if (_e130[2] < 0f) {
        phi_3689_ = -(_e130[2]);
    } else {
        phi_3689_ = _e130[2];
    }
    let _e146 = phi_3689_;
    let _e147 = ((_e135 + _e140) + _e146);
    if (_e55 >= _e101) {
        if (_e55 >= _e147) {
            phi_3699_ = false;
        } else {
            phi_3699_ = true;
        }
        let _e151 = phi_3699_;
        phi_3700_ = _e151;
    } else {
        phi_3700_ = true;
    }
    let _e153 = phi_3700_;
    if _e153 {
        if (_e101 >= _e147) {
            phi_3708_ = 1u;
        } else {
            phi_3708_ = 2u;
        }
        let _e156 = phi_3708_;
        phi_3709_ = _e156;
    } else {
        phi_3709_ = 0u;
    }
    let _e158 = phi_3709_;
    return _e158;
}

fn function_12(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_26;
    var local_1: array<array<f32, 3>, 4>;
    var local_2: array<array<f32, 3>, 4>;
    var phi_185_: u32;
    var phi_195_: u32;
    var phi_202_: u32;
    var phi_218_: u32;
    var phi_239_: u32;
    var phi_240_: u32;
    var phi_243_: type_9;
    var phi_244_: type_9;
    var phi_267_: type_9;
    var phi_410_: type_23;
    var phi_553_: u32;
    var phi_559_: f32;
    var phi_568_: u32;
    var phi_729_: type_37;
    var phi_745_: f32;
    var phi_752_: f32;
    var phi_757_: f32;
    var phi_764_: f32;
    var phi_769_: f32;
    var phi_776_: f32;
    var phi_783_: f32;
    var phi_788_: f32;
    var phi_795_: f32;
    var phi_800_: f32;
    var phi_805_: f32;
    var phi_812_: f32;
    var phi_819_: f32;
    var phi_824_: f32;
    var phi_831_: f32;
    var phi_836_: f32;
    var phi_841_: f32;
    var phi_871_: f32;
    var phi_878_: f32;
    var phi_883_: f32;
    var phi_890_: f32;
    var phi_895_: f32;
    var phi_903_: f32;
    var phi_910_: f32;
    var phi_915_: f32;
    var phi_922_: f32;
    var phi_927_: f32;
    var phi_932_: f32;
    var phi_942_: f32;
    var phi_949_: f32;
    var phi_954_: f32;
    var phi_961_: f32;
    var phi_966_: f32;
    var phi_974_: f32;
    var phi_981_: f32;
    var phi_986_: f32;
    var phi_993_: f32;
    var phi_998_: f32;
    var phi_1003_: f32;
    var phi_1013_: f32;
    var phi_1020_: f32;
    var phi_1025_: f32;
    var phi_1032_: f32;
    var phi_1037_: f32;
    var phi_1045_: f32;
    var phi_1052_: f32;
    var phi_1057_: f32;
    var phi_1064_: f32;
    var phi_1069_: f32;
    var phi_1074_: f32;
    var phi_1105_: f32;
    var phi_1111_: f32;
    var phi_1116_: f32;
    var phi_1122_: f32;
    var phi_1127_: f32;
    var phi_1135_: f32;
    var phi_1141_: f32;
    var phi_1146_: f32;
    var phi_1152_: f32;
    var phi_1157_: f32;
    var phi_1185_: type_14;
    var phi_1188_: f32;
    var phi_1209_: bool;
    var phi_1215_: type_15;
    var phi_1186_: type_14;
    var phi_1229_: type_15;
    var phi_1189_: f32;
    var local_3: f32;
    var phi_1178_: f32;
    var phi_1242_: f32;
    var phi_1250_: f32;
    var phi_1255_: f32;
    var phi_1305_: type_14;
    var phi_1308_: f32;
    var phi_1329_: bool;
    var phi_1335_: type_15;
    var phi_1306_: type_14;
    var phi_1349_: type_15;
    var phi_1309_: f32;
    var local_4: f32;
    var phi_1298_: f32;
    var phi_1362_: f32;
    var phi_1370_: f32;
    var phi_1376_: f32;
    var phi_1415_: bool;
    var phi_1421_: bool;
    var phi_1436_: bool;
    var phi_1437_: bool;
    var phi_1438_: bool;
    var phi_1439_: bool;
    var phi_1440_: bool;
    var phi_1444_: bool;
    var phi_1790_: f32;
    var phi_1797_: f32;
    var phi_1802_: f32;
    var phi_1809_: f32;
    var phi_1814_: f32;
    var phi_1822_: f32;
    var phi_1829_: f32;
    var phi_1834_: f32;
    var phi_1841_: f32;
    var phi_1846_: f32;
    var phi_1851_: f32;
    var phi_1861_: f32;
    var phi_1868_: f32;
    var phi_1873_: f32;
    var phi_1880_: f32;
    var phi_1885_: f32;
    var phi_1893_: f32;
    var phi_1900_: f32;
    var phi_1905_: f32;
    var phi_1912_: f32;
    var phi_1917_: f32;
    var phi_1922_: f32;
    var phi_1932_: f32;
    var phi_1939_: f32;
    var phi_1944_: f32;
    var phi_1951_: f32;
    var phi_1956_: f32;
    var phi_1964_: f32;
    var phi_1971_: f32;
    var phi_1976_: f32;
    var phi_1983_: f32;
    var phi_1988_: f32;
    var phi_1993_: f32;
    var phi_2011_: f32;
    var phi_2017_: f32;
    var phi_2022_: f32;
    var phi_2028_: f32;
    var phi_2033_: f32;
    var phi_2063_: type_14;
    var phi_2066_: f32;
    var phi_2087_: bool;
    var phi_2093_: type_15;
    var phi_2064_: type_14;
    var phi_2107_: type_15;
    var phi_2067_: f32;
    var local_5: f32;
    var phi_2056_: f32;
    var phi_2120_: f32;
    var phi_2146_: f32;
    var phi_2152_: f32;
    var phi_2159_: f32;
    var phi_2173_: f32;
    var phi_2187_: array<f32, 3>;
    var phi_2188_: array<f32, 3>;
    var phi_2189_: bool;
    var phi_2190_: array<f32, 3>;
    var phi_2191_: bool;
    var phi_2201_: bool;
    var phi_2202_: bool;
    var phi_2237_: array<f32, 3>;
    var phi_2238_: bool;
    var phi_2239_: array<f32, 3>;
    var phi_2240_: bool;
    var phi_2241_: array<f32, 3>;
    var phi_2242_: bool;
    var phi_2264_: f32;
    var phi_2271_: f32;
    var phi_2276_: f32;
    var phi_2283_: f32;
    var phi_2288_: f32;
    var phi_2301_: f32;
    var phi_2308_: f32;
    var phi_2313_: f32;
    var phi_2320_: f32;
    var phi_2325_: f32;
    var phi_2330_: bool;
    var phi_2331_: bool;
    var phi_2341_: array<f32, 3>;
    var phi_2342_: bool;
    var phi_2343_: array<f32, 3>;
    var phi_2344_: bool;
    var phi_2358_: array<f32, 3>;
    var phi_2359_: array<f32, 3>;
    var phi_2360_: array<f32, 3>;
    var phi_2367_: f32;
    var phi_2374_: f32;
    var phi_2379_: f32;
    var phi_2386_: f32;
    var phi_2391_: f32;
    var phi_2399_: array<f32, 3>;
    var phi_2406_: f32;
    var phi_2413_: f32;
    var phi_2418_: f32;
    var phi_2425_: f32;
    var phi_2430_: f32;
    var phi_2441_: f32;
    var phi_2448_: f32;
    var phi_2453_: f32;
    var phi_2460_: f32;
    var phi_2465_: f32;
    var phi_2498_: type_14;
    var phi_2501_: f32;
    var phi_2522_: bool;
    var phi_2528_: type_15;
    var phi_2499_: type_14;
    var phi_2542_: type_15;
    var phi_2502_: f32;
    var local_6: f32;
    var phi_2491_: f32;
    var phi_2555_: f32;
    var phi_2582_: array<f32, 3>;
    var phi_2589_: f32;
    var phi_2596_: f32;
    var phi_2604_: f32;
    var phi_2622_: f32;
    var phi_2628_: f32;
    var phi_2633_: f32;
    var phi_2639_: f32;
    var phi_2644_: f32;
    var phi_2674_: type_14;
    var phi_2677_: f32;
    var phi_2698_: bool;
    var phi_2704_: type_15;
    var phi_2675_: type_14;
    var phi_2718_: type_15;
    var phi_2678_: f32;
    var local_7: f32;
    var phi_2667_: f32;
    var phi_2731_: f32;
    var phi_2747_: array<f32, 3>;
    var phi_2748_: bool;
    var phi_2749_: array<f32, 3>;
    var phi_2750_: bool;
    var phi_2905_: f32;
    var phi_2912_: f32;
    var phi_2917_: f32;
    var phi_2924_: f32;
    var phi_2929_: f32;
    var phi_2936_: f32;
    var phi_2943_: f32;
    var phi_2948_: f32;
    var phi_2955_: f32;
    var phi_2960_: f32;
    var phi_2965_: array<f32, 3>;
    var phi_2972_: f32;
    var phi_2979_: f32;
    var phi_2984_: f32;
    var phi_2991_: f32;
    var phi_2996_: f32;
    var phi_3007_: f32;
    var phi_3014_: f32;
    var phi_3021_: f32;
    var phi_3031_: array<f32, 3>;
    var phi_3032_: bool;
    var phi_3033_: array<f32, 3>;
    var phi_3034_: bool;
    var phi_3044_: array<f32, 3>;
    var phi_3045_: array<f32, 3>;
    var phi_3052_: f32;
    var phi_3059_: f32;
    var phi_3064_: f32;
    var phi_3071_: f32;
    var phi_3076_: f32;
    var phi_3109_: type_14;
    var phi_3112_: f32;
    var phi_3133_: bool;
    var phi_3139_: type_15;
    var phi_3110_: type_14;
    var phi_3153_: type_15;
    var phi_3113_: f32;
    var local_8: f32;
    var phi_3102_: f32;
    var phi_3166_: f32;
    var phi_3201_: f32;
    var phi_3207_: f32;
    var phi_3212_: f32;
    var phi_3218_: f32;
    var phi_3223_: f32;
    var phi_3253_: type_14;
    var phi_3256_: f32;
    var phi_3277_: bool;
    var phi_3283_: type_15;
    var phi_3254_: type_14;
    var phi_3297_: type_15;
    var phi_3257_: f32;
    var local_9: f32;
    var phi_3246_: f32;
    var phi_3310_: f32;
    var phi_3327_: array<f32, 3>;
    var phi_2762_: f32;
    var phi_2768_: f32;
    var phi_2773_: f32;
    var phi_2779_: f32;
    var phi_2784_: f32;
    var phi_2814_: type_14;
    var phi_2817_: f32;
    var phi_2838_: bool;
    var phi_2844_: type_15;
    var phi_2815_: type_14;
    var phi_2858_: type_15;
    var phi_2818_: f32;
    var local_10: f32;
    var phi_2807_: f32;
    var phi_2871_: f32;
    var phi_3328_: array<f32, 3>;
    var phi_3349_: array<f32, 3>;
    var phi_3350_: array<f32, 3>;
    var phi_3351_: bool;
    var phi_3352_: array<f32, 3>;
    var phi_3353_: array<f32, 3>;
    var phi_3354_: bool;
    var phi_1506_: array<f32, 3>;
    var phi_1513_: f32;
    var phi_1520_: f32;
    var phi_1525_: f32;
    var phi_1532_: f32;
    var phi_1537_: f32;
    var phi_1570_: type_14;
    var phi_1573_: f32;
    var phi_1594_: bool;
    var phi_1600_: type_15;
    var phi_1571_: type_14;
    var phi_1614_: type_15;
    var phi_1574_: f32;
    var local_11: f32;
    var phi_1563_: f32;
    var phi_1627_: f32;
    var phi_1643_: array<f32, 3>;
    var phi_1644_: bool;
    var phi_1645_: array<f32, 3>;
    var phi_1646_: bool;
    var phi_1647_: array<f32, 3>;
    var phi_1648_: bool;
    var phi_1657_: f32;
    var phi_1663_: f32;
    var phi_1668_: f32;
    var phi_1674_: f32;
    var phi_1679_: f32;
    var phi_1709_: type_14;
    var phi_1712_: f32;
    var phi_1733_: bool;
    var phi_1739_: type_15;
    var phi_1710_: type_14;
    var phi_1753_: type_15;
    var phi_1713_: f32;
    var local_12: f32;
    var phi_1702_: f32;
    var phi_1766_: f32;
    var phi_1782_: array<f32, 3>;
    var phi_3358_: array<f32, 3>;
    var phi_3359_: array<f32, 3>;
    var phi_3360_: bool;
    var phi_3364_: array<f32, 3>;
    var phi_3381_: array<f32, 3>;
    var phi_3409_: f32;
    var phi_3437_: array<f32, 3>;
    var phi_3438_: array<f32, 3>;
    var phi_3439_: array<f32, 4>;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e55 = id_2;
    let _e56 = n_2;
    let _e57 = lane_2;
    let _e68 = ((_e55.y * _e56.x) + _e55.x);
    let _e71 = (_e56.x * _e56.y);
    let _e74 = params.member.member_1.member_2;
    let _e76 = contacts.member[0u];
    if (_e74 < _e76) {
        phi_185_ = _e74;
    } else {
        phi_185_ = _e76;
    }
    let _e79 = phi_185_;
    let _e81 = params.member.member_1.member_1;
    if (_e79 > _e81) {
        let _e84 = params.member.member_1.member_1;
        phi_195_ = (_e79 - _e84);
    } else {
        phi_195_ = 0u;
    }
    let _e87 = phi_195_;
    let _e89 = params.member.member_1.member;
    if (_e89 < _e87) {
        phi_202_ = _e89;
    } else {
        phi_202_ = _e87;
    }
    let _e92 = phi_202_;
    let _e93 = (_e92 / 64u);
    if ((_e92 % 64u) > 0u) {
        phi_218_ = (_e93 + 1u);
    } else {
        phi_218_ = _e93;
    }
    let _e98 = phi_218_;
    if (_e98 > _e68) {
        let _e100 = (_e98 - _e68);
        if (_e71 == 0u) {
            return;
        }
        let _e102 = (_e100 / _e71);
        if (_e71 == 0u) {
            return;
        }
        if ((_e100 % _e71) > 0u) {
            phi_239_ = (_e102 + 1u);
        } else {
            phi_239_ = _e102;
        }
        let _e108 = phi_239_;
        phi_240_ = _e108;
    } else {
        phi_240_ = 0u;
    }
    let _e110 = phi_240_;
    phi_243_ = type_9(0u, _e110);
    loop {
        let _e113 = phi_243_;
        if (_e113.member < _e113.member_1) {
            phi_244_ = type_9((_e113.member + 1u), _e113.member_1);
            phi_267_ = type_9(1u, _e113.member);
        } else {
            phi_244_ = _e113;
            phi_267_ = type_9(0u, type_9().member_1);
        }
        let _e125 = phi_244_;
        let _e127 = phi_267_;
        let _e131 = (bitcast<i32>(_e127.member) != 0i);
        if _e131 {
            let _e135 = (((_e68 + (_e127.member_1 * _e71)) * 64u) + _e57);
            if (_e135 < _e92) {
                let _e139 = params.member.member_1.member_1;
                let _e140 = (_e139 + _e135);
                let _e141 = (7u * _e140);
                let _e144 = contacts.member[(4u + _e141)];
                let _e147 = contacts.member[(_e141 + 5u)];
                let _e150 = contacts.member[(_e141 + 6u)];
                let _e153 = contacts.member[(_e141 + 7u)];
                let _e156 = contacts.member[(_e141 + 8u)];
                let _e159 = contacts.member[(_e141 + 9u)];
                if (_e144 == 0u) {
                    let _e172 = faces.member[_e153];
                    phi_410_ = type_23(0u, array<u32, 4>(_e150, _e172[0], _e172[1], _e172[2]));
                } else {
                    let _e162 = edges.member[_e150];
                    let _e164 = edges.member[_e153];
                    phi_410_ = type_23(1u, array<u32, 4>(_e162[0], _e162[1], _e164[0], _e164[1]));
                }
                let _e179 = phi_410_;
                let _e184 = paths.member[_e179.member_1[0]];
                let _e187 = paths.member[_e179.member_1[1]];
                let _e194 = paths.member[_e179.member_1[2]];
                let _e197 = paths.member[_e179.member_1[3]];
                local_1 = array<array<f32, 3>, 4>(array<f32, 3>(_e184.member[0], _e184.member[1], _e184.member[2]), array<f32, 3>(_e187.member[0], _e187.member[1], _e187.member[2]), array<f32, 3>(_e194.member[0], _e194.member[1], _e194.member[2]), array<f32, 3>(_e197.member[0], _e197.member[1], _e197.member[2]));
                local_2 = array<array<f32, 3>, 4>(array<f32, 3>(_e184.member_1[0], _e184.member_1[1], _e184.member_1[2]), array<f32, 3>(_e187.member_1[0], _e187.member_1[1], _e187.member_1[2]), array<f32, 3>(_e194.member_1[0], _e194.member_1[1], _e194.member_1[2]), array<f32, 3>(_e197.member_1[0], _e197.member_1[1], _e197.member_1[2]));
                let _e237 = (_e159 >> bitcast<u32>(20i));
                if (_e237 <= 896u) {
                    phi_553_ = 0u;
                } else {
                    phi_553_ = ((((_e237 - 896u) << bitcast<u32>(23i)) | ((_e159 & 1048575u) << bitcast<u32>(3i))) | (_e156 >> bitcast<u32>(29i)));
                }
                let _e250 = phi_553_;
                if (_e250 < 1065353216u) {
                    phi_559_ = bitcast<f32>(_e250);
                } else {
                    phi_559_ = 1f;
                }
                let _e254 = phi_559_;
                let _e257 = params.member.member.member_4;
                let _e258 = function_3(_e254, 1f);
                if (_e179.member == 0u) {
                    let _e260 = function_11((&local_1), (&local_2), _e258);
                    phi_568_ = _e260;
                } else {
                    phi_568_ = 0u;
                }
                let _e262 = phi_568_;
                let _e263 = function_10((&local_1), _e262);
                let _e264 = function_10((&local_2), _e262);
                if (_e179.member != 0u) {
                    phi_729_ = type_37(array<array<f32, 3>, 2>(array<f32, 3>((_e263[2][0] - _e263[0][0]), (_e263[2][1] - _e263[0][1]), (_e263[2][2] - _e263[0][2])), array<f32, 3>((_e264[2][0] - _e264[0][0]), (_e264[2][1] - _e264[0][1]), (_e264[2][2] - _e264[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e263[1][0] - _e263[0][0]), (_e263[1][1] - _e263[0][1]), (_e263[1][2] - _e263[0][2])), array<f32, 3>((_e264[1][0] - _e264[0][0]), (_e264[1][1] - _e264[0][1]), (_e264[1][2] - _e264[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e263[2][0] - _e263[3][0]), (_e263[2][1] - _e263[3][1]), (_e263[2][2] - _e263[3][2])), array<f32, 3>((_e264[2][0] - _e264[3][0]), (_e264[2][1] - _e264[3][1]), (_e264[2][2] - _e264[3][2]))), (_e257 + _e257));
                } else {
                    phi_729_ = type_37(array<array<f32, 3>, 2>(array<f32, 3>((_e263[0][0] - _e263[1][0]), (_e263[0][1] - _e263[1][1]), (_e263[0][2] - _e263[1][2])), array<f32, 3>((_e264[0][0] - _e264[1][0]), (_e264[0][1] - _e264[1][1]), (_e264[0][2] - _e264[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e263[2][0] - _e263[1][0]), (_e263[2][1] - _e263[1][1]), (_e263[2][2] - _e263[1][2])), array<f32, 3>((_e264[2][0] - _e264[1][0]), (_e264[2][1] - _e264[1][1]), (_e264[2][2] - _e264[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e263[3][0] - _e263[1][0]), (_e263[3][1] - _e263[1][1]), (_e263[3][2] - _e263[1][2])), array<f32, 3>((_e264[3][0] - _e264[1][0]), (_e264[3][1] - _e264[1][1]), (_e264[3][2] - _e264[1][2]))), (_e257 + _e257));
                }
                let _e421 = phi_729_;
                let _e426 = function_9(_e421.member[0], _e421.member[1], _e258);
                let _e431 = function_9(_e421.member_1[0], _e421.member_1[1], _e258);
                let _e436 = function_9(_e421.member_2[0], _e421.member_2[1], _e258);
                if (_e426[0] < 0f) {
                    phi_745_ = -(_e426[0]);
                } else {
                    phi_745_ = _e426[0];
                }
                let _e441 = phi_745_;
                if (_e426[1] < 0f) {
                    phi_752_ = -(_e426[1]);
                } else {
                    phi_752_ = _e426[1];
                }
                let _e446 = phi_752_;
                if (_e441 > _e446) {
                    phi_757_ = _e441;
                } else {
                    phi_757_ = _e446;
                }
                let _e449 = phi_757_;
                if (_e426[2] < 0f) {
                    phi_764_ = -(_e426[2]);
                } else {
                    phi_764_ = _e426[2];
                }
                let _e454 = phi_764_;
                if (_e449 > _e454) {
                    phi_769_ = _e449;
                } else {
                    phi_769_ = _e454;
                }
                let _e457 = phi_769_;
                if (_e431[0] < 0f) {
                    phi_776_ = -(_e431[0]);
                } else {
                    phi_776_ = _e431[0];
                }
                let _e462 = phi_776_;
                if (_e431[1] < 0f) {
                    phi_783_ = -(_e431[1]);
                } else {
                    phi_783_ = _e431[1];
                }
                let _e467 = phi_783_;
                if (_e462 > _e467) {
                    phi_788_ = _e462;
                } else {
                    phi_788_ = _e467;
                }
                let _e470 = phi_788_;
                if (_e431[2] < 0f) {
                    phi_795_ = -(_e431[2]);
                } else {
                    phi_795_ = _e431[2];
                }
                let _e475 = phi_795_;
                if (_e470 > _e475) {
                    phi_800_ = _e470;
                } else {
                    phi_800_ = _e475;
                }
                let _e478 = phi_800_;
                if (_e457 > _e478) {
                    phi_805_ = _e457;
                } else {
                    phi_805_ = _e478;
                }
                let _e481 = phi_805_;
                if (_e436[0] < 0f) {
                    phi_812_ = -(_e436[0]);
                } else {
                    phi_812_ = _e436[0];
                }
                let _e486 = phi_812_;
                if (_e436[1] < 0f) {
                    phi_819_ = -(_e436[1]);
                } else {
                    phi_819_ = _e436[1];
                }
                let _e491 = phi_819_;
                if (_e486 > _e491) {
                    phi_824_ = _e486;
                } else {
                    phi_824_ = _e491;
                }
                let _e494 = phi_824_;
                if (_e436[2] < 0f) {
                    phi_831_ = -(_e436[2]);
                } else {
                    phi_831_ = _e436[2];
                }
                let _e499 = phi_831_;
                if (_e494 > _e499) {
                    phi_836_ = _e494;
                } else {
                    phi_836_ = _e499;
                }
                let _e502 = phi_836_;
                if (_e481 > _e502) {
                    phi_841_ = _e481;
                } else {
                    phi_841_ = _e502;
                }
                let _e505 = phi_841_;
                let _e506 = function_8(_e505);
                let _e514 = (_e431[0] * _e506);
                let _e516 = (_e431[1] * _e506);
                let _e518 = (_e431[2] * _e506);
                let _e520 = (_e436[0] * _e506);
                let _e522 = (_e436[1] * _e506);
                let _e524 = (_e436[2] * _e506);
                if (_e421.member[0][0] < 0f) {
                    phi_871_ = -(_e421.member[0][0]);
                } else {
                    phi_871_ = _e421.member[0][0];
                }
                let _e531 = phi_871_;
                if (_e421.member[0][1] < 0f) {
                    phi_878_ = -(_e421.member[0][1]);
                } else {
                    phi_878_ = _e421.member[0][1];
                }
                let _e536 = phi_878_;
                if (_e531 > _e536) {
                    phi_883_ = _e531;
                } else {
                    phi_883_ = _e536;
                }
                let _e539 = phi_883_;
                if (_e421.member[0][2] < 0f) {
                    phi_890_ = -(_e421.member[0][2]);
                } else {
                    phi_890_ = _e421.member[0][2];
                }
                let _e544 = phi_890_;
                if (_e539 > _e544) {
                    phi_895_ = _e539;
                } else {
                    phi_895_ = _e544;
                }
                let _e547 = phi_895_;
                if (_e421.member[1][0] < 0f) {
                    phi_903_ = -(_e421.member[1][0]);
                } else {
                    phi_903_ = _e421.member[1][0];
                }
                let _e554 = phi_903_;
                if (_e421.member[1][1] < 0f) {
                    phi_910_ = -(_e421.member[1][1]);
                } else {
                    phi_910_ = _e421.member[1][1];
                }
                let _e559 = phi_910_;
                if (_e554 > _e559) {
                    phi_915_ = _e554;
                } else {
                    phi_915_ = _e559;
                }
                let _e562 = phi_915_;
                if (_e421.member[1][2] < 0f) {
                    phi_922_ = -(_e421.member[1][2]);
                } else {
                    phi_922_ = _e421.member[1][2];
                }
                let _e567 = phi_922_;
                if (_e562 > _e567) {
                    phi_927_ = _e562;
                } else {
                    phi_927_ = _e567;
                }
                let _e570 = phi_927_;
                if (_e547 > _e570) {
                    phi_932_ = _e547;
                } else {
                    phi_932_ = _e570;
                }
                let _e573 = phi_932_;
                if (_e421.member_1[0][0] < 0f) {
                    phi_942_ = -(_e421.member_1[0][0]);
                } else {
                    phi_942_ = _e421.member_1[0][0];
                }
                let _e582 = phi_942_;
                if (_e421.member_1[0][1] < 0f) {
                    phi_949_ = -(_e421.member_1[0][1]);
                } else {
                    phi_949_ = _e421.member_1[0][1];
                }
                let _e587 = phi_949_;
                if (_e582 > _e587) {
                    phi_954_ = _e582;
                } else {
                    phi_954_ = _e587;
                }
                let _e590 = phi_954_;
                if (_e421.member_1[0][2] < 0f) {
                    phi_961_ = -(_e421.member_1[0][2]);
                } else {
                    phi_961_ = _e421.member_1[0][2];
                }
                let _e595 = phi_961_;
                if (_e590 > _e595) {
                    phi_966_ = _e590;
                } else {
                    phi_966_ = _e595;
                }
                let _e598 = phi_966_;
                if (_e421.member_1[1][0] < 0f) {
                    phi_974_ = -(_e421.member_1[1][0]);
                } else {
                    phi_974_ = _e421.member_1[1][0];
                }
                let _e605 = phi_974_;
                if (_e421.member_1[1][1] < 0f) {
                    phi_981_ = -(_e421.member_1[1][1]);
                } else {
                    phi_981_ = _e421.member_1[1][1];
                }
                let _e610 = phi_981_;
                if (_e605 > _e610) {
                    phi_986_ = _e605;
                } else {
                    phi_986_ = _e610;
                }
                let _e613 = phi_986_;
                if (_e421.member_1[1][2] < 0f) {
                    phi_993_ = -(_e421.member_1[1][2]);
                } else {
                    phi_993_ = _e421.member_1[1][2];
                }
                let _e618 = phi_993_;
                if (_e613 > _e618) {
                    phi_998_ = _e613;
                } else {
                    phi_998_ = _e618;
                }
                let _e621 = phi_998_;
                if (_e598 > _e621) {
                    phi_1003_ = _e598;
                } else {
                    phi_1003_ = _e621;
                }
                let _e624 = phi_1003_;
                let _e626 = (_e624 + _e421.member_3);
                if (_e421.member_2[0][0] < 0f) {
                    phi_1013_ = -(_e421.member_2[0][0]);
                } else {
                    phi_1013_ = _e421.member_2[0][0];
                }
                let _e633 = phi_1013_;
                if (_e421.member_2[0][1] < 0f) {
                    phi_1020_ = -(_e421.member_2[0][1]);
                } else {
                    phi_1020_ = _e421.member_2[0][1];
                }
                let _e638 = phi_1020_;
                if (_e633 > _e638) {
                    phi_1025_ = _e633;
                } else {
                    phi_1025_ = _e638;
                }
                let _e641 = phi_1025_;
                if (_e421.member_2[0][2] < 0f) {
                    phi_1032_ = -(_e421.member_2[0][2]);
                } else {
                    phi_1032_ = _e421.member_2[0][2];
                }
                let _e646 = phi_1032_;
                if (_e641 > _e646) {
                    phi_1037_ = _e641;
                } else {
                    phi_1037_ = _e646;
                }
                let _e649 = phi_1037_;
                if (_e421.member_2[1][0] < 0f) {
                    phi_1045_ = -(_e421.member_2[1][0]);
                } else {
                    phi_1045_ = _e421.member_2[1][0];
                }
                let _e656 = phi_1045_;
                if (_e421.member_2[1][1] < 0f) {
                    phi_1052_ = -(_e421.member_2[1][1]);
                } else {
                    phi_1052_ = _e421.member_2[1][1];
                }
                let _e661 = phi_1052_;
                if (_e656 > _e661) {
                    phi_1057_ = _e656;
                } else {
                    phi_1057_ = _e661;
                }
                let _e664 = phi_1057_;
                if (_e421.member_2[1][2] < 0f) {
                    phi_1064_ = -(_e421.member_2[1][2]);
                } else {
                    phi_1064_ = _e421.member_2[1][2];
                }
                let _e669 = phi_1064_;
                if (_e664 > _e669) {
                    phi_1069_ = _e664;
                } else {
                    phi_1069_ = _e669;
                }
                let _e672 = phi_1069_;
                if (_e649 > _e672) {
                    phi_1074_ = _e649;
                } else {
                    phi_1074_ = _e672;
                }
                let _e675 = phi_1074_;
                let _e677 = (_e675 + _e421.member_3);
                let _e678 = (0.000000059604645f * 16f);
                let _e680 = (_e421.member_3 * 4f);
                let _e688 = ((_e516 * _e524) - (_e518 * _e522));
                let _e691 = ((_e518 * _e520) - (_e514 * _e524));
                let _e694 = ((_e514 * _e522) - (_e516 * _e520));
                if (_e520 < 0f) {
                    phi_1105_ = -(_e520);
                } else {
                    phi_1105_ = _e520;
                }
                let _e703 = phi_1105_;
                if (_e522 < 0f) {
                    phi_1111_ = -(_e522);
                } else {
                    phi_1111_ = _e522;
                }
                let _e707 = phi_1111_;
                if (_e703 > _e707) {
                    phi_1116_ = _e703;
                } else {
                    phi_1116_ = _e707;
                }
                let _e710 = phi_1116_;
                if (_e524 < 0f) {
                    phi_1122_ = -(_e524);
                } else {
                    phi_1122_ = _e524;
                }
                let _e714 = phi_1122_;
                if (_e710 > _e714) {
                    phi_1127_ = _e710;
                } else {
                    phi_1127_ = _e714;
                }
                let _e717 = phi_1127_;
                if (_e514 < 0f) {
                    phi_1135_ = -(_e514);
                } else {
                    phi_1135_ = _e514;
                }
                let _e723 = phi_1135_;
                if (_e516 < 0f) {
                    phi_1141_ = -(_e516);
                } else {
                    phi_1141_ = _e516;
                }
                let _e727 = phi_1141_;
                if (_e723 > _e727) {
                    phi_1146_ = _e723;
                } else {
                    phi_1146_ = _e727;
                }
                let _e730 = phi_1146_;
                if (_e518 < 0f) {
                    phi_1152_ = -(_e518);
                } else {
                    phi_1152_ = _e518;
                }
                let _e734 = phi_1152_;
                if (_e730 > _e734) {
                    phi_1157_ = _e730;
                } else {
                    phi_1157_ = _e734;
                }
                let _e737 = phi_1157_;
                let _e739 = (((((_e626 * _e678) + _e680) * _e506) * _e717) + ((((_e677 * _e678) + _e680) * _e506) * _e737));
                let _e744 = (((_e688 * _e688) + (_e691 * _e691)) + (_e694 * _e694));
                if (_e744 <= 0.000000000000000000000000000000000000011754944f) {
                    if (_e744 > 0f) {
                        phi_1178_ = (0.000000000000000000106433627f * 2f);
                    } else {
                        phi_1178_ = 0f;
                    }
                    let _e797 = phi_1178_;
                    phi_1242_ = _e797;
                } else {
                    phi_1185_ = type_14(0i, 5i);
                    phi_1188_ = bitcast<f32>(((bitcast<u32>(_e744) >> bitcast<u32>(1i)) + 532369198u));
                    loop {
                        let _e752 = phi_1185_;
                        let _e754 = phi_1188_;
                        local_3 = _e754;
                        if (_e752.member < _e752.member_1) {
                            let _e761 = (_e752.member + 1i);
                            if ((false == (_e761 > _e752.member)) != false) {
                                phi_1209_ = true;
                            } else {
                                phi_1209_ = false;
                            }
                            let _e766 = phi_1209_;
                            if _e766 {
                                phi_1215_ = type_15(0u, type_15().member_1);
                            } else {
                                phi_1215_ = type_15(1u, _e761);
                            }
                            let _e771 = phi_1215_;
                            phi_1186_ = type_14(_e771.member_1, _e752.member_1);
                            phi_1229_ = type_15(1u, _e752.member);
                        } else {
                            phi_1186_ = _e752;
                            phi_1229_ = type_15(0u, type_15().member_1);
                        }
                        let _e777 = phi_1186_;
                        let _e779 = phi_1229_;
                        let _e782 = (bitcast<i32>(_e779.member) != 0i);
                        if _e782 {
                            phi_1189_ = (0.5f * (_e754 + (_e744 / _e754)));
                        } else {
                            phi_1189_ = f32();
                        }
                        let _e787 = phi_1189_;
                        continue;
                        continuing {
                            phi_1185_ = _e777;
                            phi_1188_ = _e787;
                            break if !(_e782);
                        }
                    }
                    let _e792 = local_3;
                    phi_1242_ = (_e792 * (1f + (8f * 0.000000059604645f)));
                }
                let _e799 = phi_1242_;
                if (_e799 > 0f) {
                    phi_1250_ = ((_e799 + (_e744 / _e799)) * 0.5f);
                } else {
                    phi_1250_ = _e799;
                }
                let _e805 = phi_1250_;
                if (_e805 > _e739) {
                    phi_1255_ = _e805;
                } else {
                    phi_1255_ = 0f;
                }
                let _e808 = phi_1255_;
                local = type_26(array<f32, 3>((_e426[0] * _e506), (_e426[1] * _e506), (_e426[2] * _e506)), array<f32, 3>(_e514, _e516, _e518), array<f32, 3>(_e520, _e522, _e524), array<f32, 3>(_e688, _e691, _e694), _e808, _e739, ((((((_e573 + _e421.member_3) + _e626) + _e677) * _e678) + _e680) * _e506));
                let _e814 = function_7((&local), _e179.member);
                if (_e814.member_3 <= 0.000000000000000000000000000000000000011754944f) {
                    if (_e814.member_3 > 0f) {
                        phi_1298_ = (0.000000000000000000106433627f * 2f);
                    } else {
                        phi_1298_ = 0f;
                    }
                    let _e870 = phi_1298_;
                    phi_1362_ = _e870;
                } else {
                    phi_1305_ = type_14(0i, 5i);
                    phi_1308_ = bitcast<f32>(((bitcast<u32>(_e814.member_3) >> bitcast<u32>(1i)) + 532369198u));
                    loop {
                        let _e825 = phi_1305_;
                        let _e827 = phi_1308_;
                        local_4 = _e827;
                        if (_e825.member < _e825.member_1) {
                            let _e834 = (_e825.member + 1i);
                            if ((false == (_e834 > _e825.member)) != false) {
                                phi_1329_ = true;
                            } else {
                                phi_1329_ = false;
                            }
                            let _e839 = phi_1329_;
                            if _e839 {
                                phi_1335_ = type_15(0u, type_15().member_1);
                            } else {
                                phi_1335_ = type_15(1u, _e834);
                            }
                            let _e844 = phi_1335_;
                            phi_1306_ = type_14(_e844.member_1, _e825.member_1);
                            phi_1349_ = type_15(1u, _e825.member);
                        } else {
                            phi_1306_ = _e825;
                            phi_1349_ = type_15(0u, type_15().member_1);
                        }
                        let _e850 = phi_1306_;
                        let _e852 = phi_1349_;
                        let _e855 = (bitcast<i32>(_e852.member) != 0i);
                        if _e855 {
                            phi_1309_ = (0.5f * (_e827 + (_e814.member_3 / _e827)));
                        } else {
                            phi_1309_ = f32();
                        }
                        let _e860 = phi_1309_;
                        continue;
                        continuing {
                            phi_1305_ = _e850;
                            phi_1308_ = _e860;
                            break if !(_e855);
                        }
                    }
                    let _e865 = local_4;
                    phi_1362_ = (_e865 * (1f + (8f * 0.000000059604645f)));
                }
                let _e872 = phi_1362_;
                if (_e872 > 0f) {
                    phi_1370_ = ((_e872 + (_e814.member_3 / _e872)) * 0.5f);
                } else {
                    phi_1370_ = _e872;
                }
                let _e878 = phi_1370_;
                if (_e179.member == 0u) {
                    phi_1376_ = 1f;
                } else {
                    phi_1376_ = -(1f);
                }
                let _e882 = phi_1376_;
                let _e884 = function_1(_e421.member);
                let _e886 = function_1(_e421.member_1);
                let _e900 = function_1(_e421.member_2);
                let _e910 = (((_e884[0] - (_e886[0] * _e814.member)) - (_e900[0] * _e814.member_1)) * _e882);
                let _e911 = (((_e884[1] - (_e886[1] * _e814.member)) - (_e900[1] * _e814.member_1)) * _e882);
                let _e912 = (((_e884[2] - (_e886[2] * _e814.member)) - (_e900[2] * _e814.member_1)) * _e882);
                if (_e814.member > 0f) {
                    phi_1415_ = (_e814.member < 1f);
                } else {
                    phi_1415_ = false;
                }
                let _e919 = phi_1415_;
                if (_e814.member_1 > 0f) {
                    phi_1421_ = (_e814.member_1 < 1f);
                } else {
                    phi_1421_ = false;
                }
                let _e923 = phi_1421_;
                let _e924 = (_e882 > 0f);
                if _e919 {
                    if _e923 {
                        if _e924 {
                            phi_1436_ = ((_e814.member + _e814.member_1) < (1f - (0.000000059604645f * 4f)));
                        } else {
                            phi_1436_ = true;
                        }
                        let _e930 = phi_1436_;
                        phi_1437_ = _e930;
                        phi_1438_ = false;
                    } else {
                        phi_1437_ = bool();
                        phi_1438_ = true;
                    }
                    let _e932 = phi_1437_;
                    let _e934 = phi_1438_;
                    phi_1439_ = _e932;
                    phi_1440_ = _e934;
                } else {
                    phi_1439_ = bool();
                    phi_1440_ = true;
                }
                let _e936 = phi_1439_;
                let _e938 = phi_1440_;
                if _e938 {
                    phi_1444_ = false;
                } else {
                    phi_1444_ = _e936;
                }
                let _e940 = phi_1444_;
                let _e942 = local.member_4;
                let _e943 = (_e942 > 0f);
                let _e945 = local.member_3;
                let _e949 = (_e945[0] * _e882);
                let _e950 = (_e945[1] * _e882);
                let _e951 = (_e945[2] * _e882);
                let _e954 = local.member_6;
                if (_e878 > _e954) {
                    let _e2110 = (_e814.member_2[0] * _e882);
                    let _e2112 = (_e814.member_2[1] * _e882);
                    let _e2114 = (_e814.member_2[2] * _e882);
                    if _e943 {
                        if _e940 {
                            let _e2116 = local.member_5;
                            let _e2119 = local.member_6;
                            let _e2121 = local.member_4;
                            if ((_e2116 * _e878) <= (_e2119 * _e2121)) {
                                if ((((_e2110 * _e949) + (_e2112 * _e950)) + (_e2114 * _e951)) >= 0f) {
                                    phi_1506_ = array<f32, 3>(_e949, _e950, _e951);
                                } else {
                                    let _e2130 = -(1f);
                                    phi_1506_ = array<f32, 3>((_e949 * _e2130), (_e950 * _e2130), (_e951 * _e2130));
                                }
                                let _e2136 = phi_1506_;
                                if (_e2136[0] < 0f) {
                                    phi_1513_ = -(_e2136[0]);
                                } else {
                                    phi_1513_ = _e2136[0];
                                }
                                let _e2141 = phi_1513_;
                                if (_e2136[1] < 0f) {
                                    phi_1520_ = -(_e2136[1]);
                                } else {
                                    phi_1520_ = _e2136[1];
                                }
                                let _e2146 = phi_1520_;
                                if (_e2141 > _e2146) {
                                    phi_1525_ = _e2141;
                                } else {
                                    phi_1525_ = _e2146;
                                }
                                let _e2149 = phi_1525_;
                                if (_e2136[2] < 0f) {
                                    phi_1532_ = -(_e2136[2]);
                                } else {
                                    phi_1532_ = _e2136[2];
                                }
                                let _e2154 = phi_1532_;
                                if (_e2149 > _e2154) {
                                    phi_1537_ = _e2149;
                                } else {
                                    phi_1537_ = _e2154;
                                }
                                let _e2157 = phi_1537_;
                                let _e2158 = function_8(_e2157);
                                let _e2160 = (_e2136[0] * _e2158);
                                let _e2162 = (_e2136[1] * _e2158);
                                let _e2164 = (_e2136[2] * _e2158);
                                let _e2169 = (((_e2160 * _e2160) + (_e2162 * _e2162)) + (_e2164 * _e2164));
                                if (_e2169 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e2169 > 0f) {
                                        phi_1563_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_1563_ = 0f;
                                    }
                                    let _e2222 = phi_1563_;
                                    phi_1627_ = _e2222;
                                } else {
                                    phi_1570_ = type_14(0i, 5i);
                                    phi_1573_ = bitcast<f32>(((bitcast<u32>(_e2169) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e2177 = phi_1570_;
                                        let _e2179 = phi_1573_;
                                        local_11 = _e2179;
                                        if (_e2177.member < _e2177.member_1) {
                                            let _e2186 = (_e2177.member + 1i);
                                            if ((false == (_e2186 > _e2177.member)) != false) {
                                                phi_1594_ = true;
                                            } else {
                                                phi_1594_ = false;
                                            }
                                            let _e2191 = phi_1594_;
                                            if _e2191 {
                                                phi_1600_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_1600_ = type_15(1u, _e2186);
                                            }
                                            let _e2196 = phi_1600_;
                                            phi_1571_ = type_14(_e2196.member_1, _e2177.member_1);
                                            phi_1614_ = type_15(1u, _e2177.member);
                                        } else {
                                            phi_1571_ = _e2177;
                                            phi_1614_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e2202 = phi_1571_;
                                        let _e2204 = phi_1614_;
                                        let _e2207 = (bitcast<i32>(_e2204.member) != 0i);
                                        if _e2207 {
                                            phi_1574_ = (0.5f * (_e2179 + (_e2169 / _e2179)));
                                        } else {
                                            phi_1574_ = f32();
                                        }
                                        let _e2212 = phi_1574_;
                                        continue;
                                        continuing {
                                            phi_1570_ = _e2202;
                                            phi_1573_ = _e2212;
                                            break if !(_e2207);
                                        }
                                    }
                                    let _e2217 = local_11;
                                    phi_1627_ = (_e2217 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e2224 = phi_1627_;
                                let _e2225 = (1f / _e2224);
                                let _e2226 = (_e2160 * _e2225);
                                let _e2227 = (_e2162 * _e2225);
                                let _e2228 = (_e2164 * _e2225);
                                let _e2235 = ((3f - (((_e2226 * _e2226) + (_e2227 * _e2227)) + (_e2228 * _e2228))) * 0.5f);
                                phi_1643_ = array<f32, 3>((_e2226 * _e2235), (_e2227 * _e2235), (_e2228 * _e2235));
                                phi_1644_ = false;
                            } else {
                                phi_1643_ = array<f32, 3>();
                                phi_1644_ = true;
                            }
                            let _e2241 = phi_1643_;
                            let _e2243 = phi_1644_;
                            phi_1645_ = _e2241;
                            phi_1646_ = _e2243;
                        } else {
                            phi_1645_ = array<f32, 3>();
                            phi_1646_ = true;
                        }
                        let _e2245 = phi_1645_;
                        let _e2247 = phi_1646_;
                        phi_1647_ = _e2245;
                        phi_1648_ = _e2247;
                    } else {
                        phi_1647_ = array<f32, 3>();
                        phi_1648_ = true;
                    }
                    let _e2249 = phi_1647_;
                    let _e2251 = phi_1648_;
                    if _e2251 {
                        if (_e2110 < 0f) {
                            phi_1657_ = -(_e2110);
                        } else {
                            phi_1657_ = _e2110;
                        }
                        let _e2255 = phi_1657_;
                        if (_e2112 < 0f) {
                            phi_1663_ = -(_e2112);
                        } else {
                            phi_1663_ = _e2112;
                        }
                        let _e2259 = phi_1663_;
                        if (_e2255 > _e2259) {
                            phi_1668_ = _e2255;
                        } else {
                            phi_1668_ = _e2259;
                        }
                        let _e2262 = phi_1668_;
                        if (_e2114 < 0f) {
                            phi_1674_ = -(_e2114);
                        } else {
                            phi_1674_ = _e2114;
                        }
                        let _e2266 = phi_1674_;
                        if (_e2262 > _e2266) {
                            phi_1679_ = _e2262;
                        } else {
                            phi_1679_ = _e2266;
                        }
                        let _e2269 = phi_1679_;
                        let _e2270 = function_8(_e2269);
                        let _e2271 = (_e2110 * _e2270);
                        let _e2272 = (_e2112 * _e2270);
                        let _e2273 = (_e2114 * _e2270);
                        let _e2278 = (((_e2271 * _e2271) + (_e2272 * _e2272)) + (_e2273 * _e2273));
                        if (_e2278 <= 0.000000000000000000000000000000000000011754944f) {
                            if (_e2278 > 0f) {
                                phi_1702_ = (0.000000000000000000106433627f * 2f);
                            } else {
                                phi_1702_ = 0f;
                            }
                            let _e2331 = phi_1702_;
                            phi_1766_ = _e2331;
                        } else {
                            phi_1709_ = type_14(0i, 5i);
                            phi_1712_ = bitcast<f32>(((bitcast<u32>(_e2278) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e2286 = phi_1709_;
                                let _e2288 = phi_1712_;
                                local_12 = _e2288;
                                if (_e2286.member < _e2286.member_1) {
                                    let _e2295 = (_e2286.member + 1i);
                                    if ((false == (_e2295 > _e2286.member)) != false) {
                                        phi_1733_ = true;
                                    } else {
                                        phi_1733_ = false;
                                    }
                                    let _e2300 = phi_1733_;
                                    if _e2300 {
                                        phi_1739_ = type_15(0u, type_15().member_1);
                                    } else {
                                        phi_1739_ = type_15(1u, _e2295);
                                    }
                                    let _e2305 = phi_1739_;
                                    phi_1710_ = type_14(_e2305.member_1, _e2286.member_1);
                                    phi_1753_ = type_15(1u, _e2286.member);
                                } else {
                                    phi_1710_ = _e2286;
                                    phi_1753_ = type_15(0u, type_15().member_1);
                                }
                                let _e2311 = phi_1710_;
                                let _e2313 = phi_1753_;
                                let _e2316 = (bitcast<i32>(_e2313.member) != 0i);
                                if _e2316 {
                                    phi_1713_ = (0.5f * (_e2288 + (_e2278 / _e2288)));
                                } else {
                                    phi_1713_ = f32();
                                }
                                let _e2321 = phi_1713_;
                                continue;
                                continuing {
                                    phi_1709_ = _e2311;
                                    phi_1712_ = _e2321;
                                    break if !(_e2316);
                                }
                            }
                            let _e2326 = local_12;
                            phi_1766_ = (_e2326 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e2333 = phi_1766_;
                        let _e2334 = (1f / _e2333);
                        let _e2335 = (_e2271 * _e2334);
                        let _e2336 = (_e2272 * _e2334);
                        let _e2337 = (_e2273 * _e2334);
                        let _e2344 = ((3f - (((_e2335 * _e2335) + (_e2336 * _e2336)) + (_e2337 * _e2337))) * 0.5f);
                        phi_1782_ = array<f32, 3>((_e2335 * _e2344), (_e2336 * _e2344), (_e2337 * _e2344));
                    } else {
                        phi_1782_ = _e2249;
                    }
                    let _e2350 = phi_1782_;
                    phi_3358_ = _e2350;
                    phi_3359_ = array<f32, 3>();
                    phi_3360_ = true;
                } else {
                    if (_e421.member[0][0] < 0f) {
                        phi_1790_ = -(_e421.member[0][0]);
                    } else {
                        phi_1790_ = _e421.member[0][0];
                    }
                    let _e962 = phi_1790_;
                    if (_e421.member[0][1] < 0f) {
                        phi_1797_ = -(_e421.member[0][1]);
                    } else {
                        phi_1797_ = _e421.member[0][1];
                    }
                    let _e967 = phi_1797_;
                    if (_e962 > _e967) {
                        phi_1802_ = _e962;
                    } else {
                        phi_1802_ = _e967;
                    }
                    let _e970 = phi_1802_;
                    if (_e421.member[0][2] < 0f) {
                        phi_1809_ = -(_e421.member[0][2]);
                    } else {
                        phi_1809_ = _e421.member[0][2];
                    }
                    let _e975 = phi_1809_;
                    if (_e970 > _e975) {
                        phi_1814_ = _e970;
                    } else {
                        phi_1814_ = _e975;
                    }
                    let _e978 = phi_1814_;
                    if (_e421.member[1][0] < 0f) {
                        phi_1822_ = -(_e421.member[1][0]);
                    } else {
                        phi_1822_ = _e421.member[1][0];
                    }
                    let _e985 = phi_1822_;
                    if (_e421.member[1][1] < 0f) {
                        phi_1829_ = -(_e421.member[1][1]);
                    } else {
                        phi_1829_ = _e421.member[1][1];
                    }
                    let _e990 = phi_1829_;
                    if (_e985 > _e990) {
                        phi_1834_ = _e985;
                    } else {
                        phi_1834_ = _e990;
                    }
                    let _e993 = phi_1834_;
                    if (_e421.member[1][2] < 0f) {
                        phi_1841_ = -(_e421.member[1][2]);
                    } else {
                        phi_1841_ = _e421.member[1][2];
                    }
                    let _e998 = phi_1841_;
                    if (_e993 > _e998) {
                        phi_1846_ = _e993;
                    } else {
                        phi_1846_ = _e998;
                    }
                    let _e1001 = phi_1846_;
                    if (_e978 > _e1001) {
                        phi_1851_ = _e978;
                    } else {
                        phi_1851_ = _e1001;
                    }
                    let _e1004 = phi_1851_;
                    if (_e421.member_1[0][0] < 0f) {
                        phi_1861_ = -(_e421.member_1[0][0]);
                    } else {
                        phi_1861_ = _e421.member_1[0][0];
                    }
                    let _e1013 = phi_1861_;
                    if (_e421.member_1[0][1] < 0f) {
                        phi_1868_ = -(_e421.member_1[0][1]);
                    } else {
                        phi_1868_ = _e421.member_1[0][1];
                    }
                    let _e1018 = phi_1868_;
                    if (_e1013 > _e1018) {
                        phi_1873_ = _e1013;
                    } else {
                        phi_1873_ = _e1018;
                    }
                    let _e1021 = phi_1873_;
                    if (_e421.member_1[0][2] < 0f) {
                        phi_1880_ = -(_e421.member_1[0][2]);
                    } else {
                        phi_1880_ = _e421.member_1[0][2];
                    }
                    let _e1026 = phi_1880_;
                    if (_e1021 > _e1026) {
                        phi_1885_ = _e1021;
                    } else {
                        phi_1885_ = _e1026;
                    }
                    let _e1029 = phi_1885_;
                    if (_e421.member_1[1][0] < 0f) {
                        phi_1893_ = -(_e421.member_1[1][0]);
                    } else {
                        phi_1893_ = _e421.member_1[1][0];
                    }
                    let _e1036 = phi_1893_;
                    if (_e421.member_1[1][1] < 0f) {
                        phi_1900_ = -(_e421.member_1[1][1]);
                    } else {
                        phi_1900_ = _e421.member_1[1][1];
                    }
                    let _e1041 = phi_1900_;
                    if (_e1036 > _e1041) {
                        phi_1905_ = _e1036;
                    } else {
                        phi_1905_ = _e1041;
                    }
                    let _e1044 = phi_1905_;
                    if (_e421.member_1[1][2] < 0f) {
                        phi_1912_ = -(_e421.member_1[1][2]);
                    } else {
                        phi_1912_ = _e421.member_1[1][2];
                    }
                    let _e1049 = phi_1912_;
                    if (_e1044 > _e1049) {
                        phi_1917_ = _e1044;
                    } else {
                        phi_1917_ = _e1049;
                    }
                    let _e1052 = phi_1917_;
                    if (_e1029 > _e1052) {
                        phi_1922_ = _e1029;
                    } else {
                        phi_1922_ = _e1052;
                    }
                    let _e1055 = phi_1922_;
                    if (_e421.member_2[0][0] < 0f) {
                        phi_1932_ = -(_e421.member_2[0][0]);
                    } else {
                        phi_1932_ = _e421.member_2[0][0];
                    }
                    let _e1064 = phi_1932_;
                    if (_e421.member_2[0][1] < 0f) {
                        phi_1939_ = -(_e421.member_2[0][1]);
                    } else {
                        phi_1939_ = _e421.member_2[0][1];
                    }
                    let _e1069 = phi_1939_;
                    if (_e1064 > _e1069) {
                        phi_1944_ = _e1064;
                    } else {
                        phi_1944_ = _e1069;
                    }
                    let _e1072 = phi_1944_;
                    if (_e421.member_2[0][2] < 0f) {
                        phi_1951_ = -(_e421.member_2[0][2]);
                    } else {
                        phi_1951_ = _e421.member_2[0][2];
                    }
                    let _e1077 = phi_1951_;
                    if (_e1072 > _e1077) {
                        phi_1956_ = _e1072;
                    } else {
                        phi_1956_ = _e1077;
                    }
                    let _e1080 = phi_1956_;
                    if (_e421.member_2[1][0] < 0f) {
                        phi_1964_ = -(_e421.member_2[1][0]);
                    } else {
                        phi_1964_ = _e421.member_2[1][0];
                    }
                    let _e1087 = phi_1964_;
                    if (_e421.member_2[1][1] < 0f) {
                        phi_1971_ = -(_e421.member_2[1][1]);
                    } else {
                        phi_1971_ = _e421.member_2[1][1];
                    }
                    let _e1092 = phi_1971_;
                    if (_e1087 > _e1092) {
                        phi_1976_ = _e1087;
                    } else {
                        phi_1976_ = _e1092;
                    }
                    let _e1095 = phi_1976_;
                    if (_e421.member_2[1][2] < 0f) {
                        phi_1983_ = -(_e421.member_2[1][2]);
                    } else {
                        phi_1983_ = _e421.member_2[1][2];
                    }
                    let _e1100 = phi_1983_;
                    if (_e1095 > _e1100) {
                        phi_1988_ = _e1095;
                    } else {
                        phi_1988_ = _e1100;
                    }
                    let _e1103 = phi_1988_;
                    if (_e1080 > _e1103) {
                        phi_1993_ = _e1080;
                    } else {
                        phi_1993_ = _e1103;
                    }
                    let _e1106 = phi_1993_;
                    let _e1115 = (((((_e1004 + _e421.member_3) + (_e1055 + _e421.member_3)) + (_e1106 + _e421.member_3)) * (0.000000059604645f * 32f)) + (_e421.member_3 * 8f));
                    if _e943 {
                        if (_e949 < 0f) {
                            phi_2011_ = -(_e949);
                        } else {
                            phi_2011_ = _e949;
                        }
                        let _e1119 = phi_2011_;
                        if (_e950 < 0f) {
                            phi_2017_ = -(_e950);
                        } else {
                            phi_2017_ = _e950;
                        }
                        let _e1123 = phi_2017_;
                        if (_e1119 > _e1123) {
                            phi_2022_ = _e1119;
                        } else {
                            phi_2022_ = _e1123;
                        }
                        let _e1126 = phi_2022_;
                        if (_e951 < 0f) {
                            phi_2028_ = -(_e951);
                        } else {
                            phi_2028_ = _e951;
                        }
                        let _e1130 = phi_2028_;
                        if (_e1126 > _e1130) {
                            phi_2033_ = _e1126;
                        } else {
                            phi_2033_ = _e1130;
                        }
                        let _e1133 = phi_2033_;
                        let _e1134 = function_8(_e1133);
                        let _e1135 = (_e949 * _e1134);
                        let _e1136 = (_e950 * _e1134);
                        let _e1137 = (_e951 * _e1134);
                        let _e1142 = (((_e1135 * _e1135) + (_e1136 * _e1136)) + (_e1137 * _e1137));
                        if (_e1142 <= 0.000000000000000000000000000000000000011754944f) {
                            if (_e1142 > 0f) {
                                phi_2056_ = (0.000000000000000000106433627f * 2f);
                            } else {
                                phi_2056_ = 0f;
                            }
                            let _e1195 = phi_2056_;
                            phi_2120_ = _e1195;
                        } else {
                            phi_2063_ = type_14(0i, 5i);
                            phi_2066_ = bitcast<f32>(((bitcast<u32>(_e1142) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e1150 = phi_2063_;
                                let _e1152 = phi_2066_;
                                local_5 = _e1152;
                                if (_e1150.member < _e1150.member_1) {
                                    let _e1159 = (_e1150.member + 1i);
                                    if ((false == (_e1159 > _e1150.member)) != false) {
                                        phi_2087_ = true;
                                    } else {
                                        phi_2087_ = false;
                                    }
                                    let _e1164 = phi_2087_;
                                    if _e1164 {
                                        phi_2093_ = type_15(0u, type_15().member_1);
                                    } else {
                                        phi_2093_ = type_15(1u, _e1159);
                                    }
                                    let _e1169 = phi_2093_;
                                    phi_2064_ = type_14(_e1169.member_1, _e1150.member_1);
                                    phi_2107_ = type_15(1u, _e1150.member);
                                } else {
                                    phi_2064_ = _e1150;
                                    phi_2107_ = type_15(0u, type_15().member_1);
                                }
                                let _e1175 = phi_2064_;
                                let _e1177 = phi_2107_;
                                let _e1180 = (bitcast<i32>(_e1177.member) != 0i);
                                if _e1180 {
                                    phi_2067_ = (0.5f * (_e1152 + (_e1142 / _e1152)));
                                } else {
                                    phi_2067_ = f32();
                                }
                                let _e1185 = phi_2067_;
                                continue;
                                continuing {
                                    phi_2063_ = _e1175;
                                    phi_2066_ = _e1185;
                                    break if !(_e1180);
                                }
                            }
                            let _e1190 = local_5;
                            phi_2120_ = (_e1190 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e1197 = phi_2120_;
                        let _e1198 = (1f / _e1197);
                        let _e1199 = (_e1135 * _e1198);
                        let _e1200 = (_e1136 * _e1198);
                        let _e1201 = (_e1137 * _e1198);
                        let _e1208 = ((3f - (((_e1199 * _e1199) + (_e1200 * _e1200)) + (_e1201 * _e1201))) * 0.5f);
                        let _e1209 = (_e1199 * _e1208);
                        let _e1210 = (_e1200 * _e1208);
                        let _e1211 = (_e1201 * _e1208);
                        let _e1217 = (((_e910 * _e1209) + (_e911 * _e1210)) + (_e912 * _e1211));
                        if (_e910 < 0f) {
                            phi_2146_ = -(_e910);
                        } else {
                            phi_2146_ = _e910;
                        }
                        let _e1221 = phi_2146_;
                        if (_e911 < 0f) {
                            phi_2152_ = -(_e911);
                        } else {
                            phi_2152_ = _e911;
                        }
                        let _e1225 = phi_2152_;
                        if (_e912 < 0f) {
                            phi_2159_ = -(_e912);
                        } else {
                            phi_2159_ = _e912;
                        }
                        let _e1230 = phi_2159_;
                        let _e1233 = local.member_5;
                        let _e1235 = local.member_4;
                        if (_e1217 < 0f) {
                            phi_2173_ = -(_e1217);
                        } else {
                            phi_2173_ = _e1217;
                        }
                        let _e1242 = phi_2173_;
                        if (_e1242 > (_e1115 + (((_e1221 + _e1225) + _e1230) * (_e1233 / _e1235)))) {
                            if (_e1217 < 0f) {
                                phi_2187_ = array<f32, 3>(_e1209, _e1210, _e1211);
                            } else {
                                let _e1245 = -(1f);
                                phi_2187_ = array<f32, 3>((_e1209 * _e1245), (_e1210 * _e1245), (_e1211 * _e1245));
                            }
                            let _e1251 = phi_2187_;
                            phi_2188_ = _e1251;
                            phi_2189_ = false;
                        } else {
                            phi_2188_ = array<f32, 3>();
                            phi_2189_ = true;
                        }
                        let _e1253 = phi_2188_;
                        let _e1255 = phi_2189_;
                        phi_2190_ = _e1253;
                        phi_2191_ = _e1255;
                    } else {
                        phi_2190_ = array<f32, 3>();
                        phi_2191_ = true;
                    }
                    let _e1257 = phi_2190_;
                    let _e1259 = phi_2191_;
                    if _e1259 {
                        if _e943 {
                            if _e940 {
                                phi_2201_ = false;
                            } else {
                                phi_2201_ = true;
                            }
                            let _e1261 = phi_2201_;
                            phi_2202_ = _e1261;
                        } else {
                            phi_2202_ = true;
                        }
                        let _e1263 = phi_2202_;
                        if _e1263 {
                            if _e924 {
                                if _e919 {
                                    if _e923 {
                                        let _e1265 = local.member_2;
                                        let _e1270 = local.member_1;
                                        phi_2237_ = array<f32, 3>((_e1265[0] - _e1270[0]), (_e1265[1] - _e1270[1]), (_e1265[2] - _e1270[2]));
                                        phi_2238_ = false;
                                    } else {
                                        phi_2237_ = array<f32, 3>();
                                        phi_2238_ = true;
                                    }
                                    let _e1279 = phi_2237_;
                                    let _e1281 = phi_2238_;
                                    phi_2239_ = _e1279;
                                    phi_2240_ = _e1281;
                                } else {
                                    phi_2239_ = array<f32, 3>();
                                    phi_2240_ = true;
                                }
                                let _e1283 = phi_2239_;
                                let _e1285 = phi_2240_;
                                phi_2241_ = _e1283;
                                phi_2242_ = _e1285;
                            } else {
                                phi_2241_ = array<f32, 3>();
                                phi_2242_ = true;
                            }
                            let _e1287 = phi_2241_;
                            let _e1289 = phi_2242_;
                            if _e1289 {
                                if _e919 {
                                    if _e923 {
                                        let _e1291 = local.member_2;
                                        if (_e1291[0] < 0f) {
                                            phi_2264_ = -(_e1291[0]);
                                        } else {
                                            phi_2264_ = _e1291[0];
                                        }
                                        let _e1298 = phi_2264_;
                                        if (_e1291[1] < 0f) {
                                            phi_2271_ = -(_e1291[1]);
                                        } else {
                                            phi_2271_ = _e1291[1];
                                        }
                                        let _e1302 = phi_2271_;
                                        if (_e1298 > _e1302) {
                                            phi_2276_ = _e1298;
                                        } else {
                                            phi_2276_ = _e1302;
                                        }
                                        let _e1305 = phi_2276_;
                                        if (_e1291[2] < 0f) {
                                            phi_2283_ = -(_e1291[2]);
                                        } else {
                                            phi_2283_ = _e1291[2];
                                        }
                                        let _e1309 = phi_2283_;
                                        if (_e1305 > _e1309) {
                                            phi_2288_ = _e1305;
                                        } else {
                                            phi_2288_ = _e1309;
                                        }
                                        let _e1312 = phi_2288_;
                                        let _e1314 = local.member_1;
                                        if (_e1314[0] < 0f) {
                                            phi_2301_ = -(_e1314[0]);
                                        } else {
                                            phi_2301_ = _e1314[0];
                                        }
                                        let _e1321 = phi_2301_;
                                        if (_e1314[1] < 0f) {
                                            phi_2308_ = -(_e1314[1]);
                                        } else {
                                            phi_2308_ = _e1314[1];
                                        }
                                        let _e1325 = phi_2308_;
                                        if (_e1321 > _e1325) {
                                            phi_2313_ = _e1321;
                                        } else {
                                            phi_2313_ = _e1325;
                                        }
                                        let _e1328 = phi_2313_;
                                        if (_e1314[2] < 0f) {
                                            phi_2320_ = -(_e1314[2]);
                                        } else {
                                            phi_2320_ = _e1314[2];
                                        }
                                        let _e1332 = phi_2320_;
                                        if (_e1328 > _e1332) {
                                            phi_2325_ = _e1328;
                                        } else {
                                            phi_2325_ = _e1332;
                                        }
                                        let _e1335 = phi_2325_;
                                        if (_e1312 > _e1335) {
                                            phi_2330_ = false;
                                        } else {
                                            phi_2330_ = true;
                                        }
                                        let _e1338 = phi_2330_;
                                        phi_2331_ = _e1338;
                                    } else {
                                        phi_2331_ = true;
                                    }
                                    let _e1340 = phi_2331_;
                                    if _e1340 {
                                        let _e1342 = local.member_1;
                                        phi_2341_ = array<f32, 3>(_e1342[0], _e1342[1], _e1342[2]);
                                        phi_2342_ = false;
                                    } else {
                                        phi_2341_ = array<f32, 3>();
                                        phi_2342_ = true;
                                    }
                                    let _e1348 = phi_2341_;
                                    let _e1350 = phi_2342_;
                                    phi_2343_ = _e1348;
                                    phi_2344_ = _e1350;
                                } else {
                                    phi_2343_ = array<f32, 3>();
                                    phi_2344_ = true;
                                }
                                let _e1352 = phi_2343_;
                                let _e1354 = phi_2344_;
                                if _e1354 {
                                    if _e923 {
                                        let _e1356 = local.member_2;
                                        phi_2358_ = array<f32, 3>(_e1356[0], _e1356[1], _e1356[2]);
                                    } else {
                                        phi_2358_ = array<f32, 3>(0f, 0f, 0f);
                                    }
                                    let _e1362 = phi_2358_;
                                    phi_2359_ = _e1362;
                                } else {
                                    phi_2359_ = _e1352;
                                }
                                let _e1364 = phi_2359_;
                                phi_2360_ = _e1364;
                            } else {
                                phi_2360_ = _e1287;
                            }
                            let _e1366 = phi_2360_;
                            if (_e1366[0] < 0f) {
                                phi_2367_ = -(_e1366[0]);
                            } else {
                                phi_2367_ = _e1366[0];
                            }
                            let _e1371 = phi_2367_;
                            if (_e1366[1] < 0f) {
                                phi_2374_ = -(_e1366[1]);
                            } else {
                                phi_2374_ = _e1366[1];
                            }
                            let _e1376 = phi_2374_;
                            if (_e1371 > _e1376) {
                                phi_2379_ = _e1371;
                            } else {
                                phi_2379_ = _e1376;
                            }
                            let _e1379 = phi_2379_;
                            if (_e1366[2] < 0f) {
                                phi_2386_ = -(_e1366[2]);
                            } else {
                                phi_2386_ = _e1366[2];
                            }
                            let _e1384 = phi_2386_;
                            if (_e1379 > _e1384) {
                                phi_2391_ = _e1379;
                            } else {
                                phi_2391_ = _e1384;
                            }
                            let _e1387 = phi_2391_;
                            let _e1389 = local.member_6;
                            if (_e1387 > _e1389) {
                                phi_2399_ = _e1366;
                            } else {
                                phi_2399_ = array<f32, 3>(0f, 0f, 0f);
                            }
                            let _e1392 = phi_2399_;
                            if (_e1392[0] < 0f) {
                                phi_2406_ = -(_e1392[0]);
                            } else {
                                phi_2406_ = _e1392[0];
                            }
                            let _e1397 = phi_2406_;
                            if (_e1392[1] < 0f) {
                                phi_2413_ = -(_e1392[1]);
                            } else {
                                phi_2413_ = _e1392[1];
                            }
                            let _e1402 = phi_2413_;
                            if (_e1397 > _e1402) {
                                phi_2418_ = _e1397;
                            } else {
                                phi_2418_ = _e1402;
                            }
                            let _e1405 = phi_2418_;
                            if (_e1392[2] < 0f) {
                                phi_2425_ = -(_e1392[2]);
                            } else {
                                phi_2425_ = _e1392[2];
                            }
                            let _e1410 = phi_2425_;
                            if (_e1405 > _e1410) {
                                phi_2430_ = _e1405;
                            } else {
                                phi_2430_ = _e1410;
                            }
                            let _e1413 = phi_2430_;
                            if (_e1413 > 0f) {
                                if (_e1392[0] < 0f) {
                                    phi_2441_ = -(_e1392[0]);
                                } else {
                                    phi_2441_ = _e1392[0];
                                }
                                let _e1419 = phi_2441_;
                                if (_e1392[1] < 0f) {
                                    phi_2448_ = -(_e1392[1]);
                                } else {
                                    phi_2448_ = _e1392[1];
                                }
                                let _e1424 = phi_2448_;
                                if (_e1419 > _e1424) {
                                    phi_2453_ = _e1419;
                                } else {
                                    phi_2453_ = _e1424;
                                }
                                let _e1427 = phi_2453_;
                                if (_e1392[2] < 0f) {
                                    phi_2460_ = -(_e1392[2]);
                                } else {
                                    phi_2460_ = _e1392[2];
                                }
                                let _e1432 = phi_2460_;
                                if (_e1427 > _e1432) {
                                    phi_2465_ = _e1427;
                                } else {
                                    phi_2465_ = _e1432;
                                }
                                let _e1435 = phi_2465_;
                                let _e1436 = function_8(_e1435);
                                let _e1438 = (_e1392[0] * _e1436);
                                let _e1440 = (_e1392[1] * _e1436);
                                let _e1442 = (_e1392[2] * _e1436);
                                let _e1447 = (((_e1438 * _e1438) + (_e1440 * _e1440)) + (_e1442 * _e1442));
                                if (_e1447 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e1447 > 0f) {
                                        phi_2491_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_2491_ = 0f;
                                    }
                                    let _e1500 = phi_2491_;
                                    phi_2555_ = _e1500;
                                } else {
                                    phi_2498_ = type_14(0i, 5i);
                                    phi_2501_ = bitcast<f32>(((bitcast<u32>(_e1447) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1455 = phi_2498_;
                                        let _e1457 = phi_2501_;
                                        local_6 = _e1457;
                                        if (_e1455.member < _e1455.member_1) {
                                            let _e1464 = (_e1455.member + 1i);
                                            if ((false == (_e1464 > _e1455.member)) != false) {
                                                phi_2522_ = true;
                                            } else {
                                                phi_2522_ = false;
                                            }
                                            let _e1469 = phi_2522_;
                                            if _e1469 {
                                                phi_2528_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_2528_ = type_15(1u, _e1464);
                                            }
                                            let _e1474 = phi_2528_;
                                            phi_2499_ = type_14(_e1474.member_1, _e1455.member_1);
                                            phi_2542_ = type_15(1u, _e1455.member);
                                        } else {
                                            phi_2499_ = _e1455;
                                            phi_2542_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e1480 = phi_2499_;
                                        let _e1482 = phi_2542_;
                                        let _e1485 = (bitcast<i32>(_e1482.member) != 0i);
                                        if _e1485 {
                                            phi_2502_ = (0.5f * (_e1457 + (_e1447 / _e1457)));
                                        } else {
                                            phi_2502_ = f32();
                                        }
                                        let _e1490 = phi_2502_;
                                        continue;
                                        continuing {
                                            phi_2498_ = _e1480;
                                            phi_2501_ = _e1490;
                                            break if !(_e1485);
                                        }
                                    }
                                    let _e1495 = local_6;
                                    phi_2555_ = (_e1495 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e1502 = phi_2555_;
                                let _e1503 = (1f / _e1502);
                                let _e1504 = (_e1438 * _e1503);
                                let _e1505 = (_e1440 * _e1503);
                                let _e1506 = (_e1442 * _e1503);
                                let _e1513 = ((3f - (((_e1504 * _e1504) + (_e1505 * _e1505)) + (_e1506 * _e1506))) * 0.5f);
                                let _e1514 = (_e1504 * _e1513);
                                let _e1515 = (_e1505 * _e1513);
                                let _e1516 = (_e1506 * _e1513);
                                let _e1521 = (((_e910 * _e1514) + (_e911 * _e1515)) + (_e912 * _e1516));
                                phi_2582_ = array<f32, 3>((_e910 - (_e1514 * _e1521)), (_e911 - (_e1515 * _e1521)), (_e912 - (_e1516 * _e1521)));
                            } else {
                                phi_2582_ = array<f32, 3>(_e910, _e911, _e912);
                            }
                            let _e1530 = phi_2582_;
                            if (_e1530[0] < 0f) {
                                phi_2589_ = -(_e1530[0]);
                            } else {
                                phi_2589_ = _e1530[0];
                            }
                            let _e1535 = phi_2589_;
                            if (_e1530[1] < 0f) {
                                phi_2596_ = -(_e1530[1]);
                            } else {
                                phi_2596_ = _e1530[1];
                            }
                            let _e1540 = phi_2596_;
                            if (_e1530[2] < 0f) {
                                phi_2604_ = -(_e1530[2]);
                            } else {
                                phi_2604_ = _e1530[2];
                            }
                            let _e1546 = phi_2604_;
                            if (((_e1535 + _e1540) + _e1546) > _e1115) {
                                let _e1549 = -(1f);
                                let _e1551 = (_e1530[0] * _e1549);
                                let _e1553 = (_e1530[1] * _e1549);
                                let _e1555 = (_e1530[2] * _e1549);
                                if (_e1551 < 0f) {
                                    phi_2622_ = -(_e1551);
                                } else {
                                    phi_2622_ = _e1551;
                                }
                                let _e1559 = phi_2622_;
                                if (_e1553 < 0f) {
                                    phi_2628_ = -(_e1553);
                                } else {
                                    phi_2628_ = _e1553;
                                }
                                let _e1563 = phi_2628_;
                                if (_e1559 > _e1563) {
                                    phi_2633_ = _e1559;
                                } else {
                                    phi_2633_ = _e1563;
                                }
                                let _e1566 = phi_2633_;
                                if (_e1555 < 0f) {
                                    phi_2639_ = -(_e1555);
                                } else {
                                    phi_2639_ = _e1555;
                                }
                                let _e1570 = phi_2639_;
                                if (_e1566 > _e1570) {
                                    phi_2644_ = _e1566;
                                } else {
                                    phi_2644_ = _e1570;
                                }
                                let _e1573 = phi_2644_;
                                let _e1574 = function_8(_e1573);
                                let _e1575 = (_e1551 * _e1574);
                                let _e1576 = (_e1553 * _e1574);
                                let _e1577 = (_e1555 * _e1574);
                                let _e1582 = (((_e1575 * _e1575) + (_e1576 * _e1576)) + (_e1577 * _e1577));
                                if (_e1582 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e1582 > 0f) {
                                        phi_2667_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_2667_ = 0f;
                                    }
                                    let _e1635 = phi_2667_;
                                    phi_2731_ = _e1635;
                                } else {
                                    phi_2674_ = type_14(0i, 5i);
                                    phi_2677_ = bitcast<f32>(((bitcast<u32>(_e1582) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e1590 = phi_2674_;
                                        let _e1592 = phi_2677_;
                                        local_7 = _e1592;
                                        if (_e1590.member < _e1590.member_1) {
                                            let _e1599 = (_e1590.member + 1i);
                                            if ((false == (_e1599 > _e1590.member)) != false) {
                                                phi_2698_ = true;
                                            } else {
                                                phi_2698_ = false;
                                            }
                                            let _e1604 = phi_2698_;
                                            if _e1604 {
                                                phi_2704_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_2704_ = type_15(1u, _e1599);
                                            }
                                            let _e1609 = phi_2704_;
                                            phi_2675_ = type_14(_e1609.member_1, _e1590.member_1);
                                            phi_2718_ = type_15(1u, _e1590.member);
                                        } else {
                                            phi_2675_ = _e1590;
                                            phi_2718_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e1615 = phi_2675_;
                                        let _e1617 = phi_2718_;
                                        let _e1620 = (bitcast<i32>(_e1617.member) != 0i);
                                        if _e1620 {
                                            phi_2678_ = (0.5f * (_e1592 + (_e1582 / _e1592)));
                                        } else {
                                            phi_2678_ = f32();
                                        }
                                        let _e1625 = phi_2678_;
                                        continue;
                                        continuing {
                                            phi_2674_ = _e1615;
                                            phi_2677_ = _e1625;
                                            break if !(_e1620);
                                        }
                                    }
                                    let _e1630 = local_7;
                                    phi_2731_ = (_e1630 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e1637 = phi_2731_;
                                let _e1638 = (1f / _e1637);
                                let _e1639 = (_e1575 * _e1638);
                                let _e1640 = (_e1576 * _e1638);
                                let _e1641 = (_e1577 * _e1638);
                                let _e1648 = ((3f - (((_e1639 * _e1639) + (_e1640 * _e1640)) + (_e1641 * _e1641))) * 0.5f);
                                phi_2747_ = array<f32, 3>((_e1639 * _e1648), (_e1640 * _e1648), (_e1641 * _e1648));
                                phi_2748_ = false;
                            } else {
                                phi_2747_ = array<f32, 3>();
                                phi_2748_ = true;
                            }
                            let _e1654 = phi_2747_;
                            let _e1656 = phi_2748_;
                            phi_2749_ = _e1654;
                            phi_2750_ = _e1656;
                        } else {
                            phi_2749_ = array<f32, 3>();
                            phi_2750_ = true;
                        }
                        let _e1658 = phi_2749_;
                        let _e1660 = phi_2750_;
                        if _e1660 {
                            if _e943 {
                                if (_e949 < 0f) {
                                    phi_2762_ = -(_e949);
                                } else {
                                    phi_2762_ = _e949;
                                }
                                let _e1983 = phi_2762_;
                                if (_e950 < 0f) {
                                    phi_2768_ = -(_e950);
                                } else {
                                    phi_2768_ = _e950;
                                }
                                let _e1987 = phi_2768_;
                                if (_e1983 > _e1987) {
                                    phi_2773_ = _e1983;
                                } else {
                                    phi_2773_ = _e1987;
                                }
                                let _e1990 = phi_2773_;
                                if (_e951 < 0f) {
                                    phi_2779_ = -(_e951);
                                } else {
                                    phi_2779_ = _e951;
                                }
                                let _e1994 = phi_2779_;
                                if (_e1990 > _e1994) {
                                    phi_2784_ = _e1990;
                                } else {
                                    phi_2784_ = _e1994;
                                }
                                let _e1997 = phi_2784_;
                                let _e1998 = function_8(_e1997);
                                let _e1999 = (_e949 * _e1998);
                                let _e2000 = (_e950 * _e1998);
                                let _e2001 = (_e951 * _e1998);
                                let _e2006 = (((_e1999 * _e1999) + (_e2000 * _e2000)) + (_e2001 * _e2001));
                                if (_e2006 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e2006 > 0f) {
                                        phi_2807_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_2807_ = 0f;
                                    }
                                    let _e2059 = phi_2807_;
                                    phi_2871_ = _e2059;
                                } else {
                                    phi_2814_ = type_14(0i, 5i);
                                    phi_2817_ = bitcast<f32>(((bitcast<u32>(_e2006) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e2014 = phi_2814_;
                                        let _e2016 = phi_2817_;
                                        local_10 = _e2016;
                                        if (_e2014.member < _e2014.member_1) {
                                            let _e2023 = (_e2014.member + 1i);
                                            if ((false == (_e2023 > _e2014.member)) != false) {
                                                phi_2838_ = true;
                                            } else {
                                                phi_2838_ = false;
                                            }
                                            let _e2028 = phi_2838_;
                                            if _e2028 {
                                                phi_2844_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_2844_ = type_15(1u, _e2023);
                                            }
                                            let _e2033 = phi_2844_;
                                            phi_2815_ = type_14(_e2033.member_1, _e2014.member_1);
                                            phi_2858_ = type_15(1u, _e2014.member);
                                        } else {
                                            phi_2815_ = _e2014;
                                            phi_2858_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e2039 = phi_2815_;
                                        let _e2041 = phi_2858_;
                                        let _e2044 = (bitcast<i32>(_e2041.member) != 0i);
                                        if _e2044 {
                                            phi_2818_ = (0.5f * (_e2016 + (_e2006 / _e2016)));
                                        } else {
                                            phi_2818_ = f32();
                                        }
                                        let _e2049 = phi_2818_;
                                        continue;
                                        continuing {
                                            phi_2814_ = _e2039;
                                            phi_2817_ = _e2049;
                                            break if !(_e2044);
                                        }
                                    }
                                    let _e2054 = local_10;
                                    phi_2871_ = (_e2054 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e2061 = phi_2871_;
                                let _e2062 = (1f / _e2061);
                                let _e2063 = (_e1999 * _e2062);
                                let _e2064 = (_e2000 * _e2062);
                                let _e2065 = (_e2001 * _e2062);
                                let _e2072 = ((3f - (((_e2063 * _e2063) + (_e2064 * _e2064)) + (_e2065 * _e2065))) * 0.5f);
                                phi_3328_ = array<f32, 3>((_e2063 * _e2072), (_e2064 * _e2072), (_e2065 * _e2072));
                            } else {
                                let _e1662 = local.member_1;
                                let _e1668 = local.member_2;
                                if (_e1668[0] < 0f) {
                                    phi_2905_ = -(_e1668[0]);
                                } else {
                                    phi_2905_ = _e1668[0];
                                }
                                let _e1676 = phi_2905_;
                                if (_e1668[1] < 0f) {
                                    phi_2912_ = -(_e1668[1]);
                                } else {
                                    phi_2912_ = _e1668[1];
                                }
                                let _e1680 = phi_2912_;
                                if (_e1676 > _e1680) {
                                    phi_2917_ = _e1676;
                                } else {
                                    phi_2917_ = _e1680;
                                }
                                let _e1683 = phi_2917_;
                                if (_e1668[2] < 0f) {
                                    phi_2924_ = -(_e1668[2]);
                                } else {
                                    phi_2924_ = _e1668[2];
                                }
                                let _e1687 = phi_2924_;
                                if (_e1683 > _e1687) {
                                    phi_2929_ = _e1683;
                                } else {
                                    phi_2929_ = _e1687;
                                }
                                let _e1690 = phi_2929_;
                                if (_e1662[0] < 0f) {
                                    phi_2936_ = -(_e1662[0]);
                                } else {
                                    phi_2936_ = _e1662[0];
                                }
                                let _e1694 = phi_2936_;
                                if (_e1662[1] < 0f) {
                                    phi_2943_ = -(_e1662[1]);
                                } else {
                                    phi_2943_ = _e1662[1];
                                }
                                let _e1698 = phi_2943_;
                                if (_e1694 > _e1698) {
                                    phi_2948_ = _e1694;
                                } else {
                                    phi_2948_ = _e1698;
                                }
                                let _e1701 = phi_2948_;
                                if (_e1662[2] < 0f) {
                                    phi_2955_ = -(_e1662[2]);
                                } else {
                                    phi_2955_ = _e1662[2];
                                }
                                let _e1705 = phi_2955_;
                                if (_e1701 > _e1705) {
                                    phi_2960_ = _e1701;
                                } else {
                                    phi_2960_ = _e1705;
                                }
                                let _e1708 = phi_2960_;
                                if (_e1690 > _e1708) {
                                    phi_2965_ = array<f32, 3>(_e1668[0], _e1668[1], _e1668[2]);
                                } else {
                                    phi_2965_ = array<f32, 3>(_e1662[0], _e1662[1], _e1662[2]);
                                }
                                let _e1711 = phi_2965_;
                                if (_e1711[0] < 0f) {
                                    phi_2972_ = -(_e1711[0]);
                                } else {
                                    phi_2972_ = _e1711[0];
                                }
                                let _e1716 = phi_2972_;
                                if (_e1711[1] < 0f) {
                                    phi_2979_ = -(_e1711[1]);
                                } else {
                                    phi_2979_ = _e1711[1];
                                }
                                let _e1721 = phi_2979_;
                                if (_e1716 > _e1721) {
                                    phi_2984_ = _e1716;
                                } else {
                                    phi_2984_ = _e1721;
                                }
                                let _e1724 = phi_2984_;
                                if (_e1711[2] < 0f) {
                                    phi_2991_ = -(_e1711[2]);
                                } else {
                                    phi_2991_ = _e1711[2];
                                }
                                let _e1729 = phi_2991_;
                                if (_e1724 > _e1729) {
                                    phi_2996_ = _e1724;
                                } else {
                                    phi_2996_ = _e1729;
                                }
                                let _e1732 = phi_2996_;
                                if (_e1732 > 0f) {
                                    if (_e1711[0] < 0f) {
                                        phi_3007_ = -(_e1711[0]);
                                    } else {
                                        phi_3007_ = _e1711[0];
                                    }
                                    let _e1738 = phi_3007_;
                                    if (_e1711[1] < 0f) {
                                        phi_3014_ = -(_e1711[1]);
                                    } else {
                                        phi_3014_ = _e1711[1];
                                    }
                                    let _e1743 = phi_3014_;
                                    if (_e1711[2] < 0f) {
                                        phi_3021_ = -(_e1711[2]);
                                    } else {
                                        phi_3021_ = _e1711[2];
                                    }
                                    let _e1748 = phi_3021_;
                                    if (_e1738 <= _e1743) {
                                        if (_e1738 <= _e1748) {
                                            phi_3031_ = array<f32, 3>(1f, 0f, 0f);
                                            phi_3032_ = false;
                                        } else {
                                            phi_3031_ = array<f32, 3>();
                                            phi_3032_ = true;
                                        }
                                        let _e1752 = phi_3031_;
                                        let _e1754 = phi_3032_;
                                        phi_3033_ = _e1752;
                                        phi_3034_ = _e1754;
                                    } else {
                                        phi_3033_ = array<f32, 3>();
                                        phi_3034_ = true;
                                    }
                                    let _e1756 = phi_3033_;
                                    let _e1758 = phi_3034_;
                                    if _e1758 {
                                        if (_e1743 <= _e1748) {
                                            phi_3044_ = array<f32, 3>(0f, 1f, 0f);
                                        } else {
                                            phi_3044_ = array<f32, 3>(0f, 0f, 1f);
                                        }
                                        let _e1761 = phi_3044_;
                                        phi_3045_ = _e1761;
                                    } else {
                                        phi_3045_ = _e1756;
                                    }
                                    let _e1763 = phi_3045_;
                                    if (_e1711[0] < 0f) {
                                        phi_3052_ = -(_e1711[0]);
                                    } else {
                                        phi_3052_ = _e1711[0];
                                    }
                                    let _e1768 = phi_3052_;
                                    if (_e1711[1] < 0f) {
                                        phi_3059_ = -(_e1711[1]);
                                    } else {
                                        phi_3059_ = _e1711[1];
                                    }
                                    let _e1773 = phi_3059_;
                                    if (_e1768 > _e1773) {
                                        phi_3064_ = _e1768;
                                    } else {
                                        phi_3064_ = _e1773;
                                    }
                                    let _e1776 = phi_3064_;
                                    if (_e1711[2] < 0f) {
                                        phi_3071_ = -(_e1711[2]);
                                    } else {
                                        phi_3071_ = _e1711[2];
                                    }
                                    let _e1781 = phi_3071_;
                                    if (_e1776 > _e1781) {
                                        phi_3076_ = _e1776;
                                    } else {
                                        phi_3076_ = _e1781;
                                    }
                                    let _e1784 = phi_3076_;
                                    let _e1785 = function_8(_e1784);
                                    let _e1787 = (_e1711[0] * _e1785);
                                    let _e1789 = (_e1711[1] * _e1785);
                                    let _e1791 = (_e1711[2] * _e1785);
                                    let _e1796 = (((_e1787 * _e1787) + (_e1789 * _e1789)) + (_e1791 * _e1791));
                                    if (_e1796 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e1796 > 0f) {
                                            phi_3102_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3102_ = 0f;
                                        }
                                        let _e1849 = phi_3102_;
                                        phi_3166_ = _e1849;
                                    } else {
                                        phi_3109_ = type_14(0i, 5i);
                                        phi_3112_ = bitcast<f32>(((bitcast<u32>(_e1796) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e1804 = phi_3109_;
                                            let _e1806 = phi_3112_;
                                            local_8 = _e1806;
                                            if (_e1804.member < _e1804.member_1) {
                                                let _e1813 = (_e1804.member + 1i);
                                                if ((false == (_e1813 > _e1804.member)) != false) {
                                                    phi_3133_ = true;
                                                } else {
                                                    phi_3133_ = false;
                                                }
                                                let _e1818 = phi_3133_;
                                                if _e1818 {
                                                    phi_3139_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_3139_ = type_15(1u, _e1813);
                                                }
                                                let _e1823 = phi_3139_;
                                                phi_3110_ = type_14(_e1823.member_1, _e1804.member_1);
                                                phi_3153_ = type_15(1u, _e1804.member);
                                            } else {
                                                phi_3110_ = _e1804;
                                                phi_3153_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e1829 = phi_3110_;
                                            let _e1831 = phi_3153_;
                                            let _e1834 = (bitcast<i32>(_e1831.member) != 0i);
                                            if _e1834 {
                                                phi_3113_ = (0.5f * (_e1806 + (_e1796 / _e1806)));
                                            } else {
                                                phi_3113_ = f32();
                                            }
                                            let _e1839 = phi_3113_;
                                            continue;
                                            continuing {
                                                phi_3109_ = _e1829;
                                                phi_3112_ = _e1839;
                                                break if !(_e1834);
                                            }
                                        }
                                        let _e1844 = local_8;
                                        phi_3166_ = (_e1844 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e1851 = phi_3166_;
                                    let _e1852 = (1f / _e1851);
                                    let _e1853 = (_e1787 * _e1852);
                                    let _e1854 = (_e1789 * _e1852);
                                    let _e1855 = (_e1791 * _e1852);
                                    let _e1862 = ((3f - (((_e1853 * _e1853) + (_e1854 * _e1854)) + (_e1855 * _e1855))) * 0.5f);
                                    let _e1863 = (_e1853 * _e1862);
                                    let _e1864 = (_e1854 * _e1862);
                                    let _e1865 = (_e1855 * _e1862);
                                    let _e1870 = ((_e1864 * _e1763[2]) - (_e1865 * _e1763[1]));
                                    let _e1875 = ((_e1865 * _e1763[0]) - (_e1863 * _e1763[2]));
                                    let _e1880 = ((_e1863 * _e1763[1]) - (_e1864 * _e1763[0]));
                                    if (_e1870 < 0f) {
                                        phi_3201_ = -(_e1870);
                                    } else {
                                        phi_3201_ = _e1870;
                                    }
                                    let _e1884 = phi_3201_;
                                    if (_e1875 < 0f) {
                                        phi_3207_ = -(_e1875);
                                    } else {
                                        phi_3207_ = _e1875;
                                    }
                                    let _e1888 = phi_3207_;
                                    if (_e1884 > _e1888) {
                                        phi_3212_ = _e1884;
                                    } else {
                                        phi_3212_ = _e1888;
                                    }
                                    let _e1891 = phi_3212_;
                                    if (_e1880 < 0f) {
                                        phi_3218_ = -(_e1880);
                                    } else {
                                        phi_3218_ = _e1880;
                                    }
                                    let _e1895 = phi_3218_;
                                    if (_e1891 > _e1895) {
                                        phi_3223_ = _e1891;
                                    } else {
                                        phi_3223_ = _e1895;
                                    }
                                    let _e1898 = phi_3223_;
                                    let _e1899 = function_8(_e1898);
                                    let _e1900 = (_e1870 * _e1899);
                                    let _e1901 = (_e1875 * _e1899);
                                    let _e1902 = (_e1880 * _e1899);
                                    let _e1907 = (((_e1900 * _e1900) + (_e1901 * _e1901)) + (_e1902 * _e1902));
                                    if (_e1907 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e1907 > 0f) {
                                            phi_3246_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_3246_ = 0f;
                                        }
                                        let _e1960 = phi_3246_;
                                        phi_3310_ = _e1960;
                                    } else {
                                        phi_3253_ = type_14(0i, 5i);
                                        phi_3256_ = bitcast<f32>(((bitcast<u32>(_e1907) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e1915 = phi_3253_;
                                            let _e1917 = phi_3256_;
                                            local_9 = _e1917;
                                            if (_e1915.member < _e1915.member_1) {
                                                let _e1924 = (_e1915.member + 1i);
                                                if ((false == (_e1924 > _e1915.member)) != false) {
                                                    phi_3277_ = true;
                                                } else {
                                                    phi_3277_ = false;
                                                }
                                                let _e1929 = phi_3277_;
                                                if _e1929 {
                                                    phi_3283_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_3283_ = type_15(1u, _e1924);
                                                }
                                                let _e1934 = phi_3283_;
                                                phi_3254_ = type_14(_e1934.member_1, _e1915.member_1);
                                                phi_3297_ = type_15(1u, _e1915.member);
                                            } else {
                                                phi_3254_ = _e1915;
                                                phi_3297_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e1940 = phi_3254_;
                                            let _e1942 = phi_3297_;
                                            let _e1945 = (bitcast<i32>(_e1942.member) != 0i);
                                            if _e1945 {
                                                phi_3257_ = (0.5f * (_e1917 + (_e1907 / _e1917)));
                                            } else {
                                                phi_3257_ = f32();
                                            }
                                            let _e1950 = phi_3257_;
                                            continue;
                                            continuing {
                                                phi_3253_ = _e1940;
                                                phi_3256_ = _e1950;
                                                break if !(_e1945);
                                            }
                                        }
                                        let _e1955 = local_9;
                                        phi_3310_ = (_e1955 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e1962 = phi_3310_;
                                    let _e1963 = (1f / _e1962);
                                    let _e1964 = (_e1900 * _e1963);
                                    let _e1965 = (_e1901 * _e1963);
                                    let _e1966 = (_e1902 * _e1963);
                                    let _e1973 = ((3f - (((_e1964 * _e1964) + (_e1965 * _e1965)) + (_e1966 * _e1966))) * 0.5f);
                                    phi_3327_ = array<f32, 3>((_e1964 * _e1973), (_e1965 * _e1973), (_e1966 * _e1973));
                                } else {
                                    phi_3327_ = array<f32, 3>(1f, 0f, 0f);
                                }
                                let _e1979 = phi_3327_;
                                phi_3328_ = _e1979;
                            }
                            let _e2078 = phi_3328_;
                            if ((((_e910 * _e2078[0]) + (_e911 * _e2078[1])) + (_e912 * _e2078[2])) > _e1115) {
                                let _e2088 = -(1f);
                                phi_3349_ = array<f32, 3>((_e2078[0] * _e2088), (_e2078[1] * _e2088), (_e2078[2] * _e2088));
                            } else {
                                phi_3349_ = _e2078;
                            }
                            let _e2097 = phi_3349_;
                            phi_3350_ = _e2097;
                            phi_3351_ = false;
                        } else {
                            phi_3350_ = array<f32, 3>();
                            phi_3351_ = true;
                        }
                        let _e2099 = phi_3350_;
                        let _e2101 = phi_3351_;
                        phi_3352_ = _e2099;
                        phi_3353_ = _e1658;
                        phi_3354_ = _e2101;
                    } else {
                        phi_3352_ = array<f32, 3>();
                        phi_3353_ = _e1257;
                        phi_3354_ = true;
                    }
                    let _e2103 = phi_3352_;
                    let _e2105 = phi_3353_;
                    let _e2107 = phi_3354_;
                    phi_3358_ = _e2105;
                    phi_3359_ = _e2103;
                    phi_3360_ = _e2107;
                }
                let _e2352 = phi_3358_;
                let _e2354 = phi_3359_;
                let _e2356 = phi_3360_;
                if _e2356 {
                    phi_3364_ = _e2352;
                } else {
                    phi_3364_ = _e2354;
                }
                let _e2358 = phi_3364_;
                if ((((_e2358[0] * _e2358[0]) + (_e2358[1] * _e2358[1])) + (_e2358[2] * _e2358[2])) > 0.5f) {
                    phi_3381_ = _e2358;
                } else {
                    phi_3381_ = array<f32, 3>(1f, 0f, 0f);
                }
                let _e2372 = phi_3381_;
                let _e2375 = function_9(_e263[0], _e264[0], _e258);
                let _e2378 = function_9(_e263[1], _e264[1], _e258);
                let _e2381 = function_9(_e263[2], _e264[2], _e258);
                let _e2384 = function_9(_e263[3], _e264[3], _e258);
                if (_e179.member != 0u) {
                    let _e2421 = function_9(_e2375, _e2378, _e814.member);
                    let _e2422 = function_9(_e2381, _e2384, _e814.member_1);
                    phi_3437_ = _e2422;
                    phi_3438_ = _e2421;
                    phi_3439_ = array<f32, 4>((1f - _e814.member), _e814.member, (1f - _e814.member_1), _e814.member_1);
                } else {
                    let _e2387 = ((1f - _e814.member) - _e814.member_1);
                    if (_e2387 > 0f) {
                        phi_3409_ = _e2387;
                    } else {
                        phi_3409_ = 0f;
                    }
                    let _e2390 = phi_3409_;
                    let _e2417 = function_(array<f32, 4>(1f, _e2390, _e814.member, _e814.member_1), _e262);
                    phi_3437_ = array<f32, 3>((((_e2378[0] * _e2390) + (_e2381[0] * _e814.member)) + (_e2384[0] * _e814.member_1)), (((_e2378[1] * _e2390) + (_e2381[1] * _e814.member)) + (_e2384[1] * _e814.member_1)), (((_e2378[2] * _e2390) + (_e2381[2] * _e814.member)) + (_e2384[2] * _e814.member_1)));
                    phi_3438_ = _e2375;
                    phi_3439_ = _e2417;
                }
                let _e2424 = phi_3437_;
                let _e2426 = phi_3438_;
                let _e2428 = phi_3439_;
                let _e2429 = function_9(_e2426, _e2424, 0.5f);
                let _e2433 = params.member.member_2.member;
                let _e2436 = params.member.member_2.member_1;
                geometry.member[_e140] = type_33(array<f32, 3>(((_e2429[0] * _e2436) + _e2433[0]), ((_e2429[1] * _e2436) + _e2433[1]), ((_e2429[2] * _e2436) + _e2433[2])), ((_e878 / _e506) * _e2436), _e2372, _e147, _e2428, _e179.member_1);
            }
        }
        continue;
        continuing {
            phi_243_ = _e125;
            break if !(_e131);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn contact_geometry(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_12(id, n, lane);
}
