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

struct type_20 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
    member_5: u32,
}

struct type_23 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
}

struct type_25 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_26 {
    member: f32,
    member_1: f32,
}

struct type_28 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_29 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
    member_2: array<f32, 4>,
}

struct type_33 {
    member: array<array<array<f32, 3>, 4>, 2>,
    member_1: f32,
    member_2: f32,
}

struct type_35 {
    member: type_9,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_36 {
    member: type_7,
    member_1: type_8,
    member_2: type_35,
}

struct type_37 {
    member: type_36,
}

struct type_43 {
    member: type_23,
    member_1: f32,
}

struct type_44 {
    member: u32,
    member_1: f32,
}

struct type_45 {
    member: type_44,
    member_1: u32,
}

struct type_46 {
    member: u32,
    member_1: f32,
    member_2: f32,
}

struct type_47 {
    member: f32,
    member_1: f32,
    member_2: bool,
}

struct type_51 {
    member: array<atomic<u32>>,
}

@group(0) @binding(1) 
var<storage> paths: type_19;
@group(0) @binding(4) 
var<storage> input: type_11;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(3) 
var<storage> elements: type_11;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_51;
@group(0) @binding(0) 
var<storage> params: type_37;
@group(0) @binding(2) 
var<storage> positions: type_11;
@group(0) @binding(6) 
var<storage, read_write> undecided: type_51;
@group(0) @binding(7) 
var<storage, read_write> earliest: type_51;

fn function_(param: f32) -> array<u32, 2> {
    var phi_23660_: array<u32, 2>;

    let _e7 = bitcast<u32>(param);
    let _e8 = (_e7 & 2147483647u);
    if (_e8 < 8388608u) {
        phi_23660_ = array<u32, 2>(0u, 0u);
    } else {
        phi_23660_ = array<u32, 2>((_e7 << bitcast<u32>(29i)), ((_e7 ^ _e8) | ((_e8 >> bitcast<u32>(3i)) + 939524096u)));
    }
    let _e19 = phi_23660_;
    return _e19;
}

fn function_1(param_1: array<f32, 3>, param_2: array<f32, 3>) -> array<f32, 3> {
    var phi_23645_: array<f32, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_23645_ = param_2;
    } else {
        phi_23645_ = param_1;
    }
    let _e26 = phi_23645_;
    return _e26;
}

fn function_2(param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: array<f32, 3>, param_6: u32) -> array<f32, 3> {
    var phi_23506_: f32;
    var phi_23507_: f32;
    var phi_23546_: f32;
    var phi_23547_: f32;
    var phi_23592_: f32;
    var phi_23593_: f32;
    var phi_23327_: f32;
    var phi_23328_: f32;
    var phi_23373_: f32;
    var phi_23374_: f32;
    var phi_23416_: f32;
    var phi_23417_: f32;
    var phi_23465_: f32;
    var phi_23466_: f32;
    var phi_23608_: array<array<f32, 3>, 4>;

    let _e9 = (param_3[0] - param_4[0]);
    let _e12 = (param_3[1] - param_4[1]);
    let _e15 = (param_3[2] - param_4[2]);
    if (param_6 != 0u) {
        let _e157 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e157 > 0f) {
            if (_e157 < 1f) {
                phi_23327_ = _e157;
            } else {
                phi_23327_ = 1f;
            }
            let _e161 = phi_23327_;
            phi_23328_ = _e161;
        } else {
            phi_23328_ = 0f;
        }
        let _e163 = phi_23328_;
        let _e199 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e199 > 0f) {
            if (_e199 < 1f) {
                phi_23373_ = _e199;
            } else {
                phi_23373_ = 1f;
            }
            let _e203 = phi_23373_;
            phi_23374_ = _e203;
        } else {
            phi_23374_ = 0f;
        }
        let _e205 = phi_23374_;
        let _e238 = ((((_e9 * param_5[0]) + (_e12 * param_5[1])) + (_e15 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e238 > 0f) {
            if (_e238 < 1f) {
                phi_23416_ = _e238;
            } else {
                phi_23416_ = 1f;
            }
            let _e242 = phi_23416_;
            phi_23417_ = _e242;
        } else {
            phi_23417_ = 0f;
        }
        let _e244 = phi_23417_;
        let _e257 = (param_3[0] - param_5[0]);
        let _e260 = (param_3[1] - param_5[1]);
        let _e263 = (param_3[2] - param_5[2]);
        let _e283 = ((((_e257 * param_4[0]) + (_e260 * param_4[1])) + (_e263 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e283 > 0f) {
            if (_e283 < 1f) {
                phi_23465_ = _e283;
            } else {
                phi_23465_ = 1f;
            }
            let _e287 = phi_23465_;
            phi_23466_ = _e287;
        } else {
            phi_23466_ = 0f;
        }
        let _e289 = phi_23466_;
        phi_23608_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e163)), (param_3[1] - (param_4[1] * _e163)), (param_3[2] - (param_4[2] * _e163))), array<f32, 3>((param_3[0] - (param_5[0] * _e205)), (param_3[1] - (param_5[1] * _e205)), (param_3[2] - (param_5[2] * _e205))), array<f32, 3>((_e9 - (param_5[0] * _e244)), (_e12 - (param_5[1] * _e244)), (_e15 - (param_5[2] * _e244))), array<f32, 3>((_e257 - (param_4[0] * _e289)), (_e260 - (param_4[1] * _e289)), (_e263 - (param_4[2] * _e289))));
    } else {
        let _e19 = (param_5[0] - param_4[0]);
        let _e22 = (param_5[1] - param_4[1]);
        let _e25 = (param_5[2] - param_4[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        if (_e36 > 0f) {
            if (_e36 < 1f) {
                phi_23506_ = _e36;
            } else {
                phi_23506_ = 1f;
            }
            let _e40 = phi_23506_;
            phi_23507_ = _e40;
        } else {
            phi_23507_ = 0f;
        }
        let _e42 = phi_23507_;
        let _e49 = array<f32, 3>((_e9 - (_e19 * _e42)), (_e12 - (_e22 * _e42)), (_e15 - (_e25 * _e42)));
        let _e72 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e72 > 0f) {
            if (_e72 < 1f) {
                phi_23546_ = _e72;
            } else {
                phi_23546_ = 1f;
            }
            let _e76 = phi_23546_;
            phi_23547_ = _e76;
        } else {
            phi_23547_ = 0f;
        }
        let _e78 = phi_23547_;
        let _e114 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e114 > 0f) {
            if (_e114 < 1f) {
                phi_23592_ = _e114;
            } else {
                phi_23592_ = 1f;
            }
            let _e118 = phi_23592_;
            phi_23593_ = _e118;
        } else {
            phi_23593_ = 0f;
        }
        let _e120 = phi_23593_;
        phi_23608_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e78)), (param_3[1] - (param_4[1] * _e78)), (param_3[2] - (param_4[2] * _e78))), array<f32, 3>((param_3[0] - (param_5[0] * _e120)), (param_3[1] - (param_5[1] * _e120)), (param_3[2] - (param_5[2] * _e120))), _e49, _e49);
    }
    let _e302 = phi_23608_;
    let _e305 = function_1(_e302[0], _e302[1]);
    let _e307 = function_1(_e305, _e302[2]);
    let _e309 = function_1(_e307, _e302[3]);
    return _e309;
}

fn function_3(param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: array<f32, 3>, param_10: u32) -> array<f32, 3> {
    var phi_23228_: bool;
    var phi_23229_: bool;
    var phi_23230_: bool;
    var phi_23231_: bool;
    var phi_23235_: bool;
    var phi_23208_: bool;
    var phi_23209_: bool;
    var phi_23210_: bool;
    var phi_23211_: bool;
    var phi_23212_: bool;
    var phi_23213_: bool;
    var phi_23217_: bool;
    var phi_23236_: bool;
    var phi_23269_: array<f32, 3>;
    var phi_23270_: bool;
    var phi_23271_: array<f32, 3>;
    var phi_23272_: bool;
    var phi_23277_: array<f32, 3>;

    let _e23 = (((param_8[0] * param_8[0]) + (param_8[1] * param_8[1])) + (param_8[2] * param_8[2]));
    let _e34 = (((param_8[0] * param_9[0]) + (param_8[1] * param_9[1])) + (param_8[2] * param_9[2]));
    let _e45 = (((param_9[0] * param_9[0]) + (param_9[1] * param_9[1])) + (param_9[2] * param_9[2]));
    let _e56 = (((param_7[0] * param_8[0]) + (param_7[1] * param_8[1])) + (param_7[2] * param_8[2]));
    let _e67 = (((param_7[0] * param_9[0]) + (param_7[1] * param_9[1])) + (param_7[2] * param_9[2]));
    let _e70 = ((_e23 * _e45) - (_e34 * _e34));
    let _e74 = (((_e56 * _e45) - (_e67 * _e34)) / _e70);
    let _e78 = (((_e67 * _e23) - (_e56 * _e34)) / _e70);
    if (param_10 != 0u) {
        if (_e74 >= 0f) {
            if (_e78 >= 0f) {
                if (_e74 <= 1f) {
                    phi_23208_ = (_e78 <= 1f);
                    phi_23209_ = false;
                } else {
                    phi_23208_ = bool();
                    phi_23209_ = true;
                }
                let _e99 = phi_23208_;
                let _e101 = phi_23209_;
                phi_23210_ = _e99;
                phi_23211_ = _e101;
            } else {
                phi_23210_ = bool();
                phi_23211_ = true;
            }
            let _e103 = phi_23210_;
            let _e105 = phi_23211_;
            phi_23212_ = _e103;
            phi_23213_ = _e105;
        } else {
            phi_23212_ = bool();
            phi_23213_ = true;
        }
        let _e107 = phi_23212_;
        let _e109 = phi_23213_;
        if _e109 {
            phi_23217_ = false;
        } else {
            phi_23217_ = _e107;
        }
        let _e111 = phi_23217_;
        phi_23236_ = _e111;
    } else {
        if (_e74 >= 0f) {
            if (_e78 >= 0f) {
                phi_23228_ = ((_e74 + _e78) <= 1f);
                phi_23229_ = false;
            } else {
                phi_23228_ = bool();
                phi_23229_ = true;
            }
            let _e85 = phi_23228_;
            let _e87 = phi_23229_;
            phi_23230_ = _e85;
            phi_23231_ = _e87;
        } else {
            phi_23230_ = bool();
            phi_23231_ = true;
        }
        let _e89 = phi_23230_;
        let _e91 = phi_23231_;
        if _e91 {
            phi_23235_ = false;
        } else {
            phi_23235_ = _e89;
        }
        let _e93 = phi_23235_;
        phi_23236_ = _e93;
    }
    let _e113 = phi_23236_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e113 {
            phi_23269_ = array<f32, 3>((param_7[0] - ((param_8[0] * _e74) + (param_9[0] * _e78))), (param_7[1] - ((param_8[1] * _e74) + (param_9[1] * _e78))), (param_7[2] - ((param_8[2] * _e74) + (param_9[2] * _e78))));
            phi_23270_ = false;
        } else {
            phi_23269_ = array<f32, 3>();
            phi_23270_ = true;
        }
        let _e141 = phi_23269_;
        let _e143 = phi_23270_;
        phi_23271_ = _e141;
        phi_23272_ = _e143;
    } else {
        phi_23271_ = array<f32, 3>();
        phi_23272_ = true;
    }
    let _e145 = phi_23271_;
    let _e147 = phi_23272_;
    if _e147 {
        let _e148 = function_2(param_7, param_8, param_9, param_10);
        phi_23277_ = _e148;
    } else {
        phi_23277_ = _e145;
    }
    let _e150 = phi_23277_;
    return _e150;
}

fn function_4(param_11: u32, param_12: u32, param_13: u32) -> type_9 {
    var phi_22926_: u32;
    var phi_22933_: type_9;
    var phi_22975_: u32;
    var phi_22993_: u32;
    var phi_23000_: type_9;

    if ((param_11 >> bitcast<u32>(31i)) != 0u) {
        if (param_12 == 0u) {
            phi_22926_ = 1u;
        } else {
            phi_22926_ = 0u;
        }
        let _e15 = phi_22926_;
        phi_22933_ = type_9((~(param_11) + _e15), (~(param_12) + 1u));
    } else {
        phi_22933_ = type_9(param_11, param_12);
    }
    let _e22 = phi_22933_;
    let _e26 = (_e22.member >> bitcast<u32>(16i));
    let _e27 = (_e22.member & 65535u);
    let _e29 = (param_13 >> bitcast<u32>(16i));
    let _e30 = (param_13 & 65535u);
    let _e35 = ((_e26 * _e30) + ((_e27 * _e30) >> bitcast<u32>(16i)));
    let _e46 = (_e22.member * param_13);
    let _e48 = (_e22.member_1 >> bitcast<u32>(16i));
    let _e49 = (_e22.member_1 & 65535u);
    let _e51 = (param_13 >> bitcast<u32>(16i));
    let _e52 = (param_13 & 65535u);
    let _e57 = ((_e48 * _e52) + ((_e49 * _e52) >> bitcast<u32>(16i)));
    let _e69 = (_e46 + (((_e48 * _e51) + (_e57 >> bitcast<u32>(16i))) + (((_e49 * _e51) + (_e57 & 65535u)) >> bitcast<u32>(16i))));
    if (_e69 < _e46) {
        phi_22975_ = 1u;
    } else {
        phi_22975_ = 0u;
    }
    let _e72 = phi_22975_;
    let _e78 = ((((((_e26 * _e29) + (_e35 >> bitcast<u32>(16i))) + (((_e27 * _e29) + (_e35 & 65535u)) >> bitcast<u32>(16i))) + _e72) << bitcast<u32>(1i)) | (_e69 >> bitcast<u32>(31i)));
    let _e83 = ((_e69 << bitcast<u32>(1i)) | ((_e22.member_1 * param_13) >> bitcast<u32>(31i)));
    if ((param_11 >> bitcast<u32>(31i)) != 0u) {
        if (_e83 == 0u) {
            phi_22993_ = 1u;
        } else {
            phi_22993_ = 0u;
        }
        let _e90 = phi_22993_;
        phi_23000_ = type_9((~(_e78) + _e90), (~(_e83) + 1u));
    } else {
        phi_23000_ = type_9(_e78, _e83);
    }
    let _e97 = phi_23000_;
    return _e97;
}

fn function_5(param_14: array<type_9, 3>, param_15: u32) -> array<type_9, 2> {
    var phi_23078_: u32;
    var phi_23090_: u32;
    var phi_23101_: u32;
    var phi_23113_: u32;

    if (param_14[1].member_1 < param_14[0].member_1) {
        phi_23078_ = 1u;
    } else {
        phi_23078_ = 0u;
    }
    let _e14 = phi_23078_;
    let _e18 = function_4(((param_14[1].member - param_14[0].member) - _e14), (param_14[1].member_1 - param_14[0].member_1), param_15);
    let _e21 = (param_14[0].member_1 + _e18.member_1);
    if (_e21 < param_14[0].member_1) {
        phi_23090_ = 1u;
    } else {
        phi_23090_ = 0u;
    }
    let _e24 = phi_23090_;
    if (param_14[2].member_1 < param_14[1].member_1) {
        phi_23101_ = 1u;
    } else {
        phi_23101_ = 0u;
    }
    let _e37 = phi_23101_;
    let _e41 = function_4(((param_14[2].member - param_14[1].member) - _e37), (param_14[2].member_1 - param_14[1].member_1), param_15);
    let _e44 = (param_14[1].member_1 + _e41.member_1);
    if (_e44 < param_14[1].member_1) {
        phi_23113_ = 1u;
    } else {
        phi_23113_ = 0u;
    }
    let _e47 = phi_23113_;
    return array<type_9, 2>(type_9(((param_14[0].member + _e18.member) + _e24), _e21), type_9(((param_14[1].member + _e41.member) + _e47), _e44));
}

fn function_6(param_16: u32, param_17: u32, param_18: u32, param_19: u32) -> bool {
    var phi_23062_: u32;

    if (param_19 < param_17) {
        phi_23062_ = 1u;
    } else {
        phi_23062_ = 0u;
    }
    let _e9 = phi_23062_;
    return ((((param_18 - param_16) - _e9) >> bitcast<u32>(31i)) != 0u);
}

fn function_7(param_20: u32, param_21: u32, param_22: u32, param_23: u32) -> bool {
    var phi_23039_: u32;
    var phi_23048_: u32;

    if (param_21 == 0u) {
        phi_23039_ = 1u;
    } else {
        phi_23039_ = 0u;
    }
    let _e9 = phi_23039_;
    if (param_23 < (~(param_21) + 1u)) {
        phi_23048_ = 1u;
    } else {
        phi_23048_ = 0u;
    }
    let _e16 = phi_23048_;
    return ((((param_22 - (~(param_20) + _e9)) - _e16) >> bitcast<u32>(31i)) != 0u);
}

fn function_8(param_24: u32, param_25: u32, param_26: u32, param_27: u32) -> type_9 {
    var phi_22751_: u32;
    var phi_22758_: type_9;
    var phi_22770_: u32;
    var phi_22777_: type_9;
    var phi_22836_: u32;
    var phi_22842_: u32;
    var phi_22850_: u32;
    var phi_22858_: u32;
    var phi_22879_: u32;
    var phi_22886_: type_9;

    if ((param_24 >> bitcast<u32>(31i)) != 0u) {
        if (param_25 == 0u) {
            phi_22751_ = 1u;
        } else {
            phi_22751_ = 0u;
        }
        let _e17 = phi_22751_;
        phi_22758_ = type_9((~(param_24) + _e17), (~(param_25) + 1u));
    } else {
        phi_22758_ = type_9(param_24, param_25);
    }
    let _e24 = phi_22758_;
    if ((param_26 >> bitcast<u32>(31i)) != 0u) {
        if (param_27 == 0u) {
            phi_22770_ = 1u;
        } else {
            phi_22770_ = 0u;
        }
        let _e33 = phi_22770_;
        phi_22777_ = type_9((~(param_26) + _e33), (~(param_27) + 1u));
    } else {
        phi_22777_ = type_9(param_26, param_27);
    }
    let _e40 = phi_22777_;
    let _e44 = (_e24.member >> bitcast<u32>(16i));
    let _e45 = (_e24.member & 65535u);
    let _e47 = (_e40.member >> bitcast<u32>(16i));
    let _e48 = (_e40.member & 65535u);
    let _e53 = ((_e44 * _e48) + ((_e45 * _e48) >> bitcast<u32>(16i)));
    let _e64 = (_e24.member * _e40.member);
    let _e66 = (_e24.member >> bitcast<u32>(16i));
    let _e67 = (_e24.member & 65535u);
    let _e69 = (_e40.member_1 >> bitcast<u32>(16i));
    let _e70 = (_e40.member_1 & 65535u);
    let _e75 = ((_e66 * _e70) + ((_e67 * _e70) >> bitcast<u32>(16i)));
    let _e88 = (_e24.member_1 >> bitcast<u32>(16i));
    let _e89 = (_e24.member_1 & 65535u);
    let _e91 = (_e40.member >> bitcast<u32>(16i));
    let _e92 = (_e40.member & 65535u);
    let _e97 = ((_e88 * _e92) + ((_e89 * _e92) >> bitcast<u32>(16i)));
    let _e108 = (_e24.member_1 * _e40.member);
    let _e109 = ((_e24.member * _e40.member_1) + _e108);
    if (_e109 < _e108) {
        phi_22836_ = 1u;
    } else {
        phi_22836_ = 0u;
    }
    let _e112 = phi_22836_;
    let _e113 = (_e64 + (((_e66 * _e69) + (_e75 >> bitcast<u32>(16i))) + (((_e67 * _e69) + (_e75 & 65535u)) >> bitcast<u32>(16i))));
    if (_e113 < _e64) {
        phi_22842_ = 1u;
    } else {
        phi_22842_ = 0u;
    }
    let _e116 = phi_22842_;
    let _e118 = (_e113 + (((_e88 * _e91) + (_e97 >> bitcast<u32>(16i))) + (((_e89 * _e91) + (_e97 & 65535u)) >> bitcast<u32>(16i))));
    if (_e118 < _e113) {
        phi_22850_ = 1u;
    } else {
        phi_22850_ = 0u;
    }
    let _e121 = phi_22850_;
    let _e123 = (_e118 + _e112);
    if (_e123 < _e118) {
        phi_22858_ = 1u;
    } else {
        phi_22858_ = 0u;
    }
    let _e126 = phi_22858_;
    let _e132 = ((_e123 << bitcast<u32>(2i)) | (_e109 >> bitcast<u32>(30i)));
    let _e137 = ((((((((_e44 * _e47) + (_e53 >> bitcast<u32>(16i))) + (((_e45 * _e47) + (_e53 & 65535u)) >> bitcast<u32>(16i))) + _e116) + _e121) + _e126) << bitcast<u32>(2i)) | (_e123 >> bitcast<u32>(30i)));
    if (((param_24 >> bitcast<u32>(31i)) != 0u) != ((param_26 >> bitcast<u32>(31i)) != 0u)) {
        if (_e132 == 0u) {
            phi_22879_ = 1u;
        } else {
            phi_22879_ = 0u;
        }
        let _e148 = phi_22879_;
        phi_22886_ = type_9((~(_e137) + _e148), (~(_e132) + 1u));
    } else {
        phi_22886_ = type_9(_e137, _e132);
    }
    let _e155 = phi_22886_;
    return _e155;
}

fn function_9(param_28: array<type_9, 2>, param_29: array<type_9, 2>) -> type_9 {
    var phi_23025_: u32;

    let _e12 = function_8(param_28[0].member, param_28[0].member_1, param_29[1].member, param_29[1].member_1);
    let _e23 = function_8(param_28[1].member, param_28[1].member_1, param_29[0].member, param_29[0].member_1);
    if (_e12.member_1 < _e23.member_1) {
        phi_23025_ = 1u;
    } else {
        phi_23025_ = 0u;
    }
    let _e28 = phi_23025_;
    return type_9(((_e12.member - _e23.member) - _e28), (_e12.member_1 - _e23.member_1));
}

fn function_10(param_30: u32) -> type_9 {
    return type_9(0u, param_30);
}

fn function_11(param_31: u32, param_32: u32) -> type_9 {
    var phi_22898_: u32;
    var phi_22906_: u32;

    let _e4 = (param_32 + param_32);
    if (_e4 < param_32) {
        phi_22898_ = 1u;
    } else {
        phi_22898_ = 0u;
    }
    let _e7 = phi_22898_;
    let _e10 = (_e4 + param_32);
    if (_e10 < _e4) {
        phi_22906_ = 1u;
    } else {
        phi_22906_ = 0u;
    }
    let _e13 = phi_22906_;
    return type_9(((((param_31 + param_31) + _e7) + param_31) + _e13), _e10);
}

fn function_12(param_33: array<u32, 2>, param_34: i32) -> type_9 {
    var phi_22700_: type_9;
    var phi_22701_: type_9;
    var phi_22702_: type_9;
    var phi_22703_: type_9;
    var phi_22704_: type_9;
    var phi_22705_: bool;
    var phi_22710_: type_9;
    var phi_22722_: u32;
    var phi_22729_: type_9;
    var phi_22733_: type_9;

    let _e25 = ((param_33[1] >> bitcast<u32>(20i)) & 2047u);
    if (_e25 == 0u) {
        phi_22733_ = type_9(0u, 0u);
    } else {
        let _e28 = ((param_33[1] & 1048575u) | 1048576u);
        let _e31 = ((bitcast<i32>(_e25) - 1015i) - param_34);
        let _e33 = (bitcast<u32>(_e31) % 32u);
        if (_e31 >= 64i) {
            phi_22704_ = type_9();
            phi_22705_ = true;
        } else {
            let _e35 = (_e31 <= -53i);
            if _e35 {
                phi_22703_ = type_9();
            } else {
                if (_e31 >= 32i) {
                    phi_22702_ = type_9((param_33[0] << bitcast<u32>((_e33 & 31u))), 0u);
                } else {
                    if (_e31 >= 0i) {
                        phi_22701_ = type_9(((_e28 << bitcast<u32>((_e33 & 31u))) | ((param_33[0] >> bitcast<u32>(1i)) >> bitcast<u32>(((31u - _e33) & 31u)))), (param_33[0] << bitcast<u32>((_e33 & 31u))));
                    } else {
                        if (_e31 > -32i) {
                            let _e47 = bitcast<u32>(-(_e31));
                            phi_22700_ = type_9(bitcast<u32>((bitcast<i32>(_e28) >> bitcast<u32>((_e47 & 31u)))), ((param_33[0] >> bitcast<u32>((_e47 & 31u))) | ((_e28 << bitcast<u32>(((31u - _e47) & 31u))) << bitcast<u32>(1i))));
                        } else {
                            phi_22700_ = type_9(0u, (_e28 >> bitcast<u32>(((bitcast<u32>(-(_e31)) - 32u) & 31u))));
                        }
                        let _e65 = phi_22700_;
                        phi_22701_ = _e65;
                    }
                    let _e81 = phi_22701_;
                    phi_22702_ = _e81;
                }
                let _e87 = phi_22702_;
                phi_22703_ = _e87;
            }
            let _e89 = phi_22703_;
            phi_22704_ = _e89;
            phi_22705_ = _e35;
        }
        let _e91 = phi_22704_;
        let _e93 = phi_22705_;
        if _e93 {
            phi_22710_ = type_9(0u, 0u);
        } else {
            phi_22710_ = _e91;
        }
        let _e95 = phi_22710_;
        if ((param_33[1] >> bitcast<u32>(31i)) != 0u) {
            if (_e95.member_1 == 0u) {
                phi_22722_ = 1u;
            } else {
                phi_22722_ = 0u;
            }
            let _e103 = phi_22722_;
            phi_22729_ = type_9((~(_e95.member) + _e103), (~(_e95.member_1) + 1u));
        } else {
            phi_22729_ = _e95;
        }
        let _e110 = phi_22729_;
        phi_22733_ = _e110;
    }
    let _e112 = phi_22733_;
    return _e112;
}

fn function_13(param_35: f32, param_36: f32) -> f32 {
    var phi_22623_: bool;
    var phi_22627_: f32;

    if (param_35 != param_35) {
        phi_22623_ = true;
    } else {
        phi_22623_ = (param_36 >= param_35);
    }
    let _e6 = phi_22623_;
    if _e6 {
        phi_22627_ = param_36;
    } else {
        phi_22627_ = param_35;
    }
    let _e8 = phi_22627_;
    return _e8;
}

fn function_14(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_29;
    var local_1: type_29;
    var local_2: type_24;
    var local_3: type_24;
    var local_4: type_24;
    var local_5: array<type_26, 4>;
    var local_6: array<f32, 4>;
    var local_7: array<f32, 2>;
    var local_8: type_29;
    var local_9: type_29;
    var local_10: type_29;
    var local_11: type_29;
    var local_12: array<f32, 4>;
    var local_13: array<f32, 3>;
    var local_14: type_33;
    var local_15: type_29;
    var local_16: type_29;
    var local_17: type_29;
    var local_18: type_23;
    var local_19: array<type_9, 3>;
    var local_20: array<type_9, 3>;
    var local_21: array<type_9, 3>;
    var local_22: array<type_9, 3>;
    var local_23: array<type_9, 3>;
    var local_24: array<type_9, 3>;
    var local_25: array<type_9, 3>;
    var local_26: array<type_9, 3>;
    var local_27: array<type_9, 3>;
    var local_28: array<type_9, 3>;
    var local_29: array<type_9, 3>;
    var local_30: array<type_9, 3>;
    var local_31: array<type_9, 3>;
    var local_32: array<type_9, 3>;
    var local_33: array<type_9, 3>;
    var local_34: array<type_9, 3>;
    var local_35: array<type_9, 3>;
    var local_36: array<type_9, 3>;
    var local_37: array<type_9, 3>;
    var local_38: array<type_9, 3>;
    var local_39: array<type_9, 3>;
    var local_40: array<type_9, 3>;
    var local_41: array<type_9, 3>;
    var local_42: array<type_9, 3>;
    var local_43: array<type_9, 3>;
    var local_44: array<type_9, 3>;
    var local_45: array<type_9, 3>;
    var local_46: array<type_9, 3>;
    var local_47: array<type_9, 3>;
    var local_48: array<type_9, 3>;
    var local_49: array<type_9, 3>;
    var local_50: i32;
    var local_51: i32;
    var local_52: i32;
    var local_53: i32;
    var local_54: i32;
    var local_55: i32;
    var local_56: i32;
    var local_57: i32;
    var local_58: array<u32, 4>;
    var local_59: array<array<f32, 3>, 4>;
    var local_60: array<array<f32, 3>, 4>;
    var local_61: i32;
    var phi_363_: u32;
    var phi_373_: u32;
    var phi_380_: u32;
    var phi_396_: u32;
    var phi_417_: u32;
    var phi_418_: u32;
    var phi_421_: type_9;
    var phi_422_: type_9;
    var phi_445_: type_9;
    var phi_581_: type_25;
    var phi_1003_: type_23;
    var phi_1011_: f32;
    var phi_1018_: f32;
    var phi_1023_: f32;
    var phi_1030_: f32;
    var phi_1035_: f32;
    var phi_1043_: f32;
    var phi_1050_: f32;
    var phi_1055_: f32;
    var phi_1062_: f32;
    var phi_1067_: f32;
    var phi_1072_: f32;
    var phi_1082_: f32;
    var phi_1089_: f32;
    var phi_1094_: f32;
    var phi_1101_: f32;
    var phi_1106_: f32;
    var phi_1114_: f32;
    var phi_1121_: f32;
    var phi_1126_: f32;
    var phi_1133_: f32;
    var phi_1138_: f32;
    var phi_1143_: f32;
    var phi_1153_: f32;
    var phi_1160_: f32;
    var phi_1165_: f32;
    var phi_1172_: f32;
    var phi_1177_: f32;
    var phi_1185_: f32;
    var phi_1192_: f32;
    var phi_1197_: f32;
    var phi_1204_: f32;
    var phi_1209_: f32;
    var phi_1214_: f32;
    var phi_1231_: i32;
    var phi_1232_: bool;
    var phi_1233_: i32;
    var phi_1234_: bool;
    var phi_1238_: i32;
    var phi_1280_: array<u32, 2>;
    var phi_1297_: array<u32, 2>;
    var phi_1314_: array<u32, 2>;
    var phi_1348_: array<u32, 2>;
    var phi_1365_: array<u32, 2>;
    var phi_1382_: array<u32, 2>;
    var phi_1417_: array<u32, 2>;
    var phi_1434_: array<u32, 2>;
    var phi_1451_: array<u32, 2>;
    var phi_1485_: array<u32, 2>;
    var phi_1502_: array<u32, 2>;
    var phi_1519_: array<u32, 2>;
    var phi_1554_: array<u32, 2>;
    var phi_1571_: array<u32, 2>;
    var phi_1588_: array<u32, 2>;
    var phi_1622_: array<u32, 2>;
    var phi_1639_: array<u32, 2>;
    var phi_1656_: array<u32, 2>;
    var phi_1691_: array<u32, 2>;
    var phi_1708_: array<u32, 2>;
    var phi_1725_: array<u32, 2>;
    var phi_1759_: array<u32, 2>;
    var phi_1776_: array<u32, 2>;
    var phi_1793_: array<u32, 2>;
    var phi_2710_: array<array<array<type_9, 3>, 2>, 4>;
    var phi_2999_: u32;
    var phi_3011_: u32;
    var phi_3023_: u32;
    var phi_3043_: u32;
    var phi_3055_: u32;
    var phi_3067_: u32;
    var phi_3088_: u32;
    var phi_3100_: u32;
    var phi_3112_: u32;
    var phi_3132_: u32;
    var phi_3144_: u32;
    var phi_3156_: u32;
    var phi_3177_: u32;
    var phi_3189_: u32;
    var phi_3201_: u32;
    var phi_3221_: u32;
    var phi_3233_: u32;
    var phi_3245_: u32;
    var phi_2731_: u32;
    var phi_2743_: u32;
    var phi_2755_: u32;
    var phi_2775_: u32;
    var phi_2787_: u32;
    var phi_2799_: u32;
    var phi_2820_: u32;
    var phi_2832_: u32;
    var phi_2844_: u32;
    var phi_2864_: u32;
    var phi_2876_: u32;
    var phi_2888_: u32;
    var phi_2909_: u32;
    var phi_2921_: u32;
    var phi_2933_: u32;
    var phi_2953_: u32;
    var phi_2965_: u32;
    var phi_2977_: u32;
    var phi_3257_: array<array<array<type_9, 3>, 2>, 3>;
    var phi_3336_: u32;
    var phi_3416_: u32;
    var phi_3496_: u32;
    var phi_3584_: u32;
    var phi_3664_: u32;
    var phi_3744_: u32;
    var phi_3832_: u32;
    var phi_3912_: u32;
    var phi_3992_: u32;
    var phi_4080_: u32;
    var phi_4160_: u32;
    var phi_4240_: u32;
    var phi_4259_: u32;
    var phi_4271_: u32;
    var phi_4283_: u32;
    var phi_4312_: u32;
    var phi_4327_: u32;
    var phi_4353_: u32;
    var phi_4368_: u32;
    var phi_4391_: u32;
    var phi_4406_: u32;
    var phi_4414_: u32;
    var phi_4437_: u32;
    var phi_4452_: u32;
    var phi_4475_: u32;
    var phi_4490_: u32;
    var phi_4498_: u32;
    var phi_4521_: u32;
    var phi_4536_: u32;
    var phi_4552_: type_9;
    var phi_4555_: array<type_9, 4>;
    var phi_4559_: u32;
    var phi_4561_: u32;
    var phi_4553_: type_9;
    var phi_4584_: type_9;
    var phi_4619_: u32;
    var phi_4626_: type_9;
    var phi_4633_: u32;
    var phi_4646_: u32;
    var phi_4647_: u32;
    var phi_4662_: u32;
    var phi_4669_: type_9;
    var phi_4676_: u32;
    var phi_4689_: u32;
    var phi_4690_: u32;
    var phi_4706_: u32;
    var phi_4713_: type_9;
    var phi_4720_: u32;
    var phi_4733_: u32;
    var phi_4734_: u32;
    var phi_4750_: u32;
    var phi_4757_: type_9;
    var phi_4764_: u32;
    var phi_4777_: u32;
    var phi_4778_: u32;
    var phi_4781_: bool;
    var phi_4804_: bool;
    var phi_4805_: bool;
    var phi_4806_: bool;
    var phi_4824_: u32;
    var phi_4831_: type_9;
    var phi_4838_: u32;
    var phi_4851_: u32;
    var phi_4852_: u32;
    var phi_4867_: u32;
    var phi_4874_: type_9;
    var phi_4881_: u32;
    var phi_4894_: u32;
    var phi_4895_: u32;
    var phi_4902_: bool;
    var phi_4910_: u32;
    var phi_4928_: u32;
    var phi_4940_: u32;
    var phi_4952_: u32;
    var phi_4973_: u32;
    var phi_4980_: type_9;
    var phi_4994_: u32;
    var phi_5001_: type_9;
    var phi_5008_: u32;
    var phi_5018_: type_9;
    var phi_5032_: u32;
    var phi_5039_: type_9;
    var phi_5046_: u32;
    var phi_5056_: type_9;
    var phi_5067_: u32;
    var phi_5089_: u32;
    var phi_5102_: u32;
    var phi_5114_: u32;
    var phi_5126_: u32;
    var phi_5147_: u32;
    var phi_5154_: type_9;
    var phi_5168_: u32;
    var phi_5175_: type_9;
    var phi_5182_: u32;
    var phi_5192_: type_9;
    var phi_5206_: u32;
    var phi_5213_: type_9;
    var phi_5220_: u32;
    var phi_5230_: type_9;
    var phi_5241_: u32;
    var phi_5263_: u32;
    var phi_5276_: u32;
    var phi_5288_: u32;
    var phi_5300_: u32;
    var phi_5321_: u32;
    var phi_5328_: type_9;
    var phi_5342_: u32;
    var phi_5349_: type_9;
    var phi_5356_: u32;
    var phi_5366_: type_9;
    var phi_5380_: u32;
    var phi_5387_: type_9;
    var phi_5394_: u32;
    var phi_5404_: type_9;
    var phi_5415_: u32;
    var phi_5437_: u32;
    var phi_5458_: u32;
    var phi_5470_: u32;
    var phi_5481_: u32;
    var phi_5493_: u32;
    var phi_5504_: u32;
    var phi_5516_: u32;
    var phi_5535_: u32;
    var phi_5547_: u32;
    var phi_5558_: u32;
    var phi_5570_: u32;
    var phi_5581_: u32;
    var phi_5593_: u32;
    var phi_5612_: u32;
    var phi_5624_: u32;
    var phi_5635_: u32;
    var phi_5647_: u32;
    var phi_5658_: u32;
    var phi_5670_: u32;
    var phi_5755_: u32;
    var phi_5835_: u32;
    var phi_5915_: u32;
    var phi_5936_: u32;
    var phi_5943_: type_9;
    var phi_5957_: u32;
    var phi_5964_: type_9;
    var phi_5978_: u32;
    var phi_5985_: type_9;
    var phi_5992_: u32;
    var phi_6004_: u32;
    var phi_6012_: bool;
    var phi_6013_: bool;
    var phi_6021_: u32;
    var phi_6029_: i32;
    var phi_6030_: i32;
    var phi_6059_: array<type_9, 2>;
    var phi_6088_: array<type_9, 2>;
    var phi_6117_: array<type_9, 2>;
    var phi_6131_: type_9;
    var phi_6157_: u32;
    var phi_6179_: u32;
    var phi_6207_: u32;
    var phi_6229_: u32;
    var phi_6257_: u32;
    var phi_6279_: u32;
    var phi_6293_: u32;
    var phi_6300_: type_9;
    var phi_6307_: u32;
    var phi_6327_: u32;
    var phi_6334_: type_9;
    var phi_6347_: u32;
    var phi_6354_: type_9;
    var phi_6367_: u32;
    var phi_6374_: type_9;
    var phi_6421_: u32;
    var phi_6429_: u32;
    var phi_6439_: u32;
    var phi_6447_: u32;
    var phi_6385_: u32;
    var phi_6395_: u32;
    var phi_6403_: u32;
    var phi_6413_: u32;
    var phi_6453_: type_9;
    var phi_6454_: type_9;
    var phi_6455_: type_9;
    var phi_6456_: type_9;
    var phi_6569_: bool;
    var phi_6570_: bool;
    var phi_6571_: bool;
    var phi_6572_: bool;
    var phi_6576_: u32;
    var phi_6577_: u32;
    var phi_6578_: u32;
    var phi_6579_: bool;
    var phi_6580_: u32;
    var phi_6581_: bool;
    var phi_6582_: u32;
    var phi_6583_: bool;
    var phi_6587_: u32;
    var phi_6588_: u32;
    var phi_6596_: bool;
    var phi_6600_: bool;
    var phi_6601_: bool;
    var phi_6602_: bool;
    var phi_6603_: u32;
    var phi_6604_: u32;
    var phi_6605_: bool;
    var phi_6621_: u32;
    var phi_6644_: u32;
    var phi_6667_: u32;
    var phi_6686_: u32;
    var phi_6705_: u32;
    var phi_6724_: u32;
    var phi_6764_: u32;
    var phi_6771_: type_9;
    var phi_6778_: u32;
    var phi_6791_: u32;
    var phi_6792_: u32;
    var phi_6807_: u32;
    var phi_6814_: type_9;
    var phi_6821_: u32;
    var phi_6834_: u32;
    var phi_6835_: u32;
    var phi_6851_: u32;
    var phi_6858_: type_9;
    var phi_6865_: u32;
    var phi_6878_: u32;
    var phi_6879_: u32;
    var phi_6895_: u32;
    var phi_6902_: type_9;
    var phi_6909_: u32;
    var phi_6922_: u32;
    var phi_6923_: u32;
    var phi_6940_: array<type_9, 4>;
    var phi_6941_: u32;
    var phi_6942_: array<type_9, 4>;
    var phi_6944_: u32;
    var phi_6945_: u32;
    var phi_6946_: array<type_9, 4>;
    var phi_6948_: u32;
    var phi_6949_: u32;
    var phi_6950_: array<type_9, 4>;
    var phi_6952_: bool;
    var phi_6953_: u32;
    var phi_6954_: u32;
    var phi_6955_: bool;
    var phi_6956_: bool;
    var phi_6957_: u32;
    var phi_6958_: u32;
    var phi_6959_: bool;
    var phi_6978_: u32;
    var phi_6990_: bool;
    var phi_6991_: bool;
    var phi_7009_: u32;
    var phi_7021_: u32;
    var phi_7032_: u32;
    var phi_7044_: u32;
    var phi_7055_: u32;
    var phi_7067_: u32;
    var phi_7084_: u32;
    var phi_7096_: u32;
    var phi_7107_: u32;
    var phi_7119_: u32;
    var phi_7130_: u32;
    var phi_7142_: u32;
    var phi_7162_: u32;
    var phi_7174_: u32;
    var phi_7185_: u32;
    var phi_7197_: u32;
    var phi_7208_: u32;
    var phi_7220_: u32;
    var phi_7231_: u32;
    var phi_7243_: u32;
    var phi_7254_: array<type_9, 4>;
    var phi_7255_: array<type_9, 4>;
    var phi_7256_: u32;
    var phi_7257_: u32;
    var phi_7258_: bool;
    var phi_7262_: bool;
    var phi_7263_: array<type_9, 4>;
    var phi_7264_: u32;
    var phi_7265_: u32;
    var phi_7266_: bool;
    var phi_7267_: bool;
    var phi_7268_: bool;
    var phi_7269_: array<type_9, 4>;
    var phi_7271_: u32;
    var phi_7272_: u32;
    var phi_7273_: bool;
    var phi_7274_: bool;
    var phi_7275_: u32;
    var phi_7276_: u32;
    var phi_7277_: bool;
    var phi_7278_: bool;
    var phi_7279_: bool;
    var phi_4556_: array<type_9, 4>;
    var phi_4560_: u32;
    var phi_4562_: u32;
    var phi_7280_: u32;
    var phi_7281_: bool;
    var phi_7282_: bool;
    var phi_7283_: u32;
    var phi_7284_: u32;
    var phi_7285_: bool;
    var phi_7286_: bool;
    var phi_7287_: bool;
    var phi_7288_: bool;
    var phi_7289_: bool;
    var local_62: bool;
    var phi_7294_: type_9;
    var phi_7295_: bool;
    var phi_7296_: bool;
    var phi_7297_: bool;
    var phi_7302_: type_9;
    var phi_7303_: bool;
    var phi_7304_: bool;
    var phi_7305_: bool;
    var phi_7310_: type_9;
    var phi_7311_: bool;
    var phi_7312_: bool;
    var local_63: bool;
    var local_64: u32;
    var local_65: array<type_9, 4>;
    var local_66: array<type_9, 4>;
    var local_67: array<type_9, 4>;
    var phi_7337_: u32;
    var phi_7344_: type_9;
    var phi_7351_: u32;
    var phi_7364_: u32;
    var phi_7365_: u32;
    var phi_7374_: u32;
    var local_68: u32;
    var phi_7386_: u32;
    var phi_7397_: u32;
    var local_69: u32;
    var phi_7409_: u32;
    var phi_7420_: u32;
    var local_70: u32;
    var phi_7432_: u32;
    var phi_7449_: u32;
    var local_71: u32;
    var phi_7461_: u32;
    var phi_7472_: u32;
    var local_72: u32;
    var phi_7484_: u32;
    var phi_7495_: u32;
    var local_73: u32;
    var phi_7507_: u32;
    var local_74: u32;
    var local_75: u32;
    var local_76: u32;
    var phi_7527_: u32;
    var local_77: u32;
    var phi_7539_: u32;
    var phi_7550_: u32;
    var local_78: u32;
    var phi_7573_: u32;
    var local_79: u32;
    var phi_7596_: u32;
    var local_80: u32;
    var phi_7633_: u32;
    var phi_7640_: type_9;
    var phi_7647_: u32;
    var phi_7660_: u32;
    var phi_7661_: u32;
    var phi_7664_: bool;
    var phi_7665_: bool;
    var phi_7666_: bool;
    var phi_7667_: bool;
    var phi_7671_: bool;
    var local_81: u32;
    var local_82: u32;
    var phi_7677_: bool;
    var local_83: u32;
    var phi_7685_: bool;
    var phi_7686_: bool;
    var phi_7687_: bool;
    var phi_7688_: bool;
    var phi_7692_: bool;
    var local_84: u32;
    var phi_7698_: type_9;
    var phi_7699_: type_9;
    var phi_7700_: bool;
    var phi_7701_: bool;
    var phi_7705_: type_9;
    var phi_7706_: bool;
    var phi_7710_: type_9;
    var phi_7723_: u32;
    var phi_7741_: array<u32, 2>;
    var phi_7747_: type_28;
    var phi_7753_: bool;
    var phi_7754_: type_28;
    var phi_7755_: bool;
    var phi_7756_: type_28;
    var phi_7757_: bool;
    var phi_7775_: array<u32, 2>;
    var phi_7789_: bool;
    var phi_7805_: bool;
    var phi_7813_: f32;
    var phi_7820_: f32;
    var phi_7825_: f32;
    var phi_7832_: f32;
    var phi_7837_: f32;
    var phi_7845_: f32;
    var phi_7852_: f32;
    var phi_7857_: f32;
    var phi_7864_: f32;
    var phi_7869_: f32;
    var phi_7874_: f32;
    var phi_7884_: f32;
    var phi_7891_: f32;
    var phi_7896_: f32;
    var phi_7903_: f32;
    var phi_7908_: f32;
    var phi_7916_: f32;
    var phi_7923_: f32;
    var phi_7928_: f32;
    var phi_7935_: f32;
    var phi_7940_: f32;
    var phi_7945_: f32;
    var phi_7955_: f32;
    var phi_7962_: f32;
    var phi_7967_: f32;
    var phi_7974_: f32;
    var phi_7979_: f32;
    var phi_7987_: f32;
    var phi_7994_: f32;
    var phi_7999_: f32;
    var phi_8006_: f32;
    var phi_8011_: f32;
    var phi_8016_: f32;
    var phi_8023_: f32;
    var phi_8028_: f32;
    var phi_8035_: bool;
    var phi_8059_: u32;
    var phi_8070_: f32;
    var phi_8071_: f32;
    var phi_8129_: type_43;
    var phi_8130_: bool;
    var phi_8131_: type_43;
    var phi_8132_: bool;
    var phi_8133_: type_43;
    var phi_8134_: bool;
    var phi_8139_: type_43;
    var phi_15085_: f32;
    var phi_15092_: f32;
    var phi_15097_: f32;
    var phi_15104_: f32;
    var phi_15109_: f32;
    var phi_15122_: f32;
    var phi_15129_: f32;
    var phi_15134_: f32;
    var phi_15141_: f32;
    var phi_15146_: f32;
    var phi_15151_: f32;
    var phi_15168_: f32;
    var phi_15175_: f32;
    var phi_15180_: f32;
    var phi_15187_: f32;
    var phi_15192_: f32;
    var phi_15206_: f32;
    var phi_15213_: f32;
    var phi_15218_: f32;
    var phi_15225_: f32;
    var phi_15230_: f32;
    var phi_15235_: f32;
    var phi_15252_: f32;
    var phi_15259_: f32;
    var phi_15264_: f32;
    var phi_15271_: f32;
    var phi_15276_: f32;
    var phi_15290_: f32;
    var phi_15297_: f32;
    var phi_15302_: f32;
    var phi_15309_: f32;
    var phi_15314_: f32;
    var phi_15319_: f32;
    var phi_15350_: f32;
    var phi_15356_: f32;
    var phi_15363_: f32;
    var phi_15370_: f32;
    var phi_15376_: f32;
    var phi_15383_: f32;
    var phi_15389_: f32;
    var phi_15395_: f32;
    var phi_15401_: f32;
    var phi_15408_: f32;
    var phi_15415_: f32;
    var phi_15439_: f32;
    var phi_15444_: f32;
    var phi_15449_: f32;
    var phi_15454_: f32;
    var phi_15459_: f32;
    var phi_15464_: f32;
    var phi_15474_: f32;
    var phi_15487_: f32;
    var phi_15493_: f32;
    var phi_15498_: f32;
    var phi_15504_: f32;
    var phi_15510_: f32;
    var phi_15515_: f32;
    var phi_15520_: f32;
    var phi_15528_: bool;
    var phi_15533_: f32;
    var phi_15540_: f32;
    var phi_15546_: f32;
    var phi_15564_: f32;
    var phi_15625_: array<f32, 3>;
    var phi_15690_: array<f32, 3>;
    var phi_15712_: f32;
    var phi_15719_: f32;
    var phi_15724_: f32;
    var phi_15731_: f32;
    var phi_15736_: f32;
    var phi_15749_: f32;
    var phi_15756_: f32;
    var phi_15761_: f32;
    var phi_15768_: f32;
    var phi_15773_: f32;
    var phi_15778_: f32;
    var phi_15795_: f32;
    var phi_15802_: f32;
    var phi_15807_: f32;
    var phi_15814_: f32;
    var phi_15819_: f32;
    var phi_15833_: f32;
    var phi_15840_: f32;
    var phi_15845_: f32;
    var phi_15852_: f32;
    var phi_15857_: f32;
    var phi_15862_: f32;
    var phi_15879_: f32;
    var phi_15886_: f32;
    var phi_15891_: f32;
    var phi_15898_: f32;
    var phi_15903_: f32;
    var phi_15917_: f32;
    var phi_15924_: f32;
    var phi_15929_: f32;
    var phi_15936_: f32;
    var phi_15941_: f32;
    var phi_15946_: f32;
    var phi_16064_: f32;
    var phi_16071_: f32;
    var phi_16079_: f32;
    var phi_16123_: type_14;
    var phi_16126_: f32;
    var phi_16147_: bool;
    var phi_16153_: type_15;
    var phi_16124_: type_14;
    var phi_16167_: type_15;
    var phi_16127_: f32;
    var local_85: f32;
    var phi_16116_: f32;
    var phi_16180_: f32;
    var phi_16246_: f32;
    var phi_16252_: f32;
    var phi_16261_: f32;
    var phi_16267_: f32;
    var phi_16276_: f32;
    var phi_16282_: f32;
    var phi_16291_: f32;
    var phi_16297_: f32;
    var phi_16303_: type_29;
    var phi_16304_: bool;
    var phi_16305_: type_29;
    var phi_16306_: bool;
    var phi_16314_: type_29;
    var phi_16483_: bool;
    var phi_16484_: bool;
    var phi_16485_: bool;
    var phi_16486_: bool;
    var phi_16487_: bool;
    var phi_16488_: bool;
    var phi_16492_: bool;
    var phi_16519_: f32;
    var phi_16573_: type_14;
    var phi_16576_: f32;
    var phi_16597_: bool;
    var phi_16603_: type_15;
    var phi_16574_: type_14;
    var phi_16617_: type_15;
    var phi_16577_: f32;
    var local_86: f32;
    var phi_16566_: f32;
    var phi_16630_: f32;
    var phi_16696_: f32;
    var phi_16702_: f32;
    var phi_16711_: f32;
    var phi_16717_: f32;
    var phi_16726_: f32;
    var phi_16732_: f32;
    var phi_16741_: f32;
    var phi_16747_: f32;
    var phi_16753_: type_29;
    var phi_16754_: bool;
    var phi_16755_: type_29;
    var phi_16756_: bool;
    var phi_16764_: type_29;
    var phi_16933_: bool;
    var phi_16934_: bool;
    var phi_16935_: bool;
    var phi_16936_: bool;
    var phi_16937_: bool;
    var phi_16938_: bool;
    var phi_16942_: bool;
    var phi_16975_: f32;
    var phi_17023_: type_14;
    var phi_17026_: f32;
    var phi_17047_: bool;
    var phi_17053_: type_15;
    var phi_17024_: type_14;
    var phi_17067_: type_15;
    var phi_17027_: f32;
    var local_87: f32;
    var phi_17016_: f32;
    var phi_17080_: f32;
    var phi_17146_: f32;
    var phi_17152_: f32;
    var phi_17161_: f32;
    var phi_17167_: f32;
    var phi_17176_: f32;
    var phi_17182_: f32;
    var phi_17191_: f32;
    var phi_17197_: f32;
    var phi_17203_: type_29;
    var phi_17204_: bool;
    var phi_17205_: type_29;
    var phi_17206_: bool;
    var phi_17214_: type_29;
    var phi_17383_: bool;
    var phi_17384_: bool;
    var phi_17385_: bool;
    var phi_17386_: bool;
    var phi_17387_: bool;
    var phi_17388_: bool;
    var phi_17392_: bool;
    var phi_17432_: f32;
    var phi_17473_: type_14;
    var phi_17476_: f32;
    var phi_17497_: bool;
    var phi_17503_: type_15;
    var phi_17474_: type_14;
    var phi_17517_: type_15;
    var phi_17477_: f32;
    var local_88: f32;
    var phi_17466_: f32;
    var phi_17530_: f32;
    var phi_17596_: f32;
    var phi_17602_: f32;
    var phi_17611_: f32;
    var phi_17617_: f32;
    var phi_17626_: f32;
    var phi_17632_: f32;
    var phi_17641_: f32;
    var phi_17647_: f32;
    var phi_17653_: type_29;
    var phi_17654_: bool;
    var phi_17655_: type_29;
    var phi_17656_: bool;
    var phi_17664_: type_29;
    var phi_17833_: bool;
    var phi_17834_: bool;
    var phi_17835_: bool;
    var phi_17836_: bool;
    var phi_17837_: bool;
    var phi_17838_: bool;
    var phi_17842_: bool;
    var phi_17843_: bool;
    var phi_17844_: bool;
    var phi_17845_: bool;
    var phi_17846_: bool;
    var phi_17847_: bool;
    var phi_17851_: bool;
    var phi_17857_: type_44;
    var phi_17858_: bool;
    var phi_17859_: type_44;
    var phi_17860_: bool;
    var phi_17903_: type_14;
    var phi_17906_: f32;
    var phi_17927_: bool;
    var phi_17933_: type_15;
    var phi_17904_: type_14;
    var phi_17947_: type_15;
    var phi_17907_: f32;
    var local_89: f32;
    var phi_17896_: f32;
    var phi_17960_: f32;
    var phi_17966_: f32;
    var phi_17991_: type_9;
    var phi_17994_: u32;
    var phi_17992_: type_9;
    var phi_18017_: type_9;
    var phi_18061_: u32;
    var phi_18062_: u32;
    var phi_17995_: u32;
    var phi_18063_: u32;
    var phi_18083_: type_9;
    var phi_18084_: type_9;
    var phi_18107_: type_9;
    var phi_18126_: f32;
    var phi_18139_: f32;
    var phi_18173_: f32;
    var phi_18180_: f32;
    var phi_18191_: bool;
    var phi_18192_: bool;
    var phi_18193_: bool;
    var phi_18194_: bool;
    var phi_18198_: bool;
    var phi_18209_: type_47;
    var phi_18210_: type_47;
    var phi_18211_: bool;
    var phi_18212_: type_47;
    var phi_18213_: bool;
    var phi_18224_: f32;
    var phi_18234_: type_9;
    var phi_18237_: f32;
    var phi_18239_: f32;
    var phi_18241_: f32;
    var phi_18235_: type_9;
    var phi_18264_: type_9;
    var phi_18289_: f32;
    var phi_18290_: f32;
    var phi_18316_: f32;
    var phi_18332_: f32;
    var phi_18339_: bool;
    var phi_18340_: bool;
    var phi_18341_: bool;
    var phi_18347_: f32;
    var phi_18348_: f32;
    var phi_18349_: bool;
    var phi_18238_: f32;
    var phi_18240_: f32;
    var phi_18242_: f32;
    var phi_18350_: f32;
    var phi_18351_: bool;
    var phi_18352_: bool;
    var local_90: bool;
    var phi_18356_: f32;
    var phi_18357_: f32;
    var phi_18365_: f32;
    var phi_18369_: type_9;
    var phi_18372_: f32;
    var phi_18370_: type_9;
    var phi_18395_: type_9;
    var phi_18425_: f32;
    var phi_18426_: bool;
    var phi_18427_: f32;
    var phi_18428_: bool;
    var phi_18429_: bool;
    var phi_18430_: bool;
    var phi_18431_: f32;
    var phi_18373_: f32;
    var phi_18432_: bool;
    var phi_18433_: bool;
    var phi_18434_: bool;
    var phi_18435_: bool;
    var local_91: bool;
    var phi_18439_: bool;
    var phi_18440_: bool;
    var phi_18444_: bool;
    var phi_18448_: f32;
    var phi_18449_: f32;
    var phi_18451_: type_47;
    var phi_18480_: f32;
    var phi_18487_: f32;
    var phi_18492_: f32;
    var phi_18499_: f32;
    var phi_18504_: f32;
    var phi_18517_: f32;
    var phi_18524_: f32;
    var phi_18529_: f32;
    var phi_18536_: f32;
    var phi_18541_: f32;
    var phi_18546_: f32;
    var phi_18605_: f32;
    var phi_18611_: f32;
    var phi_18616_: f32;
    var phi_18622_: f32;
    var phi_18627_: f32;
    var phi_18639_: f32;
    var phi_18645_: f32;
    var phi_18650_: f32;
    var phi_18656_: f32;
    var phi_18661_: f32;
    var phi_18687_: f32;
    var phi_18694_: f32;
    var phi_18699_: f32;
    var phi_18706_: f32;
    var phi_18711_: f32;
    var phi_18724_: f32;
    var phi_18731_: f32;
    var phi_18736_: f32;
    var phi_18743_: f32;
    var phi_18748_: f32;
    var phi_18753_: f32;
    var phi_18812_: f32;
    var phi_18818_: f32;
    var phi_18823_: f32;
    var phi_18829_: f32;
    var phi_18834_: f32;
    var phi_18846_: f32;
    var phi_18852_: f32;
    var phi_18857_: f32;
    var phi_18863_: f32;
    var phi_18868_: f32;
    var phi_18894_: f32;
    var phi_18901_: f32;
    var phi_18906_: f32;
    var phi_18913_: f32;
    var phi_18918_: f32;
    var phi_18931_: f32;
    var phi_18938_: f32;
    var phi_18943_: f32;
    var phi_18950_: f32;
    var phi_18955_: f32;
    var phi_18960_: f32;
    var phi_19019_: f32;
    var phi_19025_: f32;
    var phi_19030_: f32;
    var phi_19036_: f32;
    var phi_19041_: f32;
    var phi_19053_: f32;
    var phi_19059_: f32;
    var phi_19064_: f32;
    var phi_19070_: f32;
    var phi_19075_: f32;
    var phi_19124_: f32;
    var phi_19130_: f32;
    var phi_19158_: f32;
    var phi_19164_: f32;
    var phi_19169_: u32;
    var phi_19170_: u32;
    var phi_19140_: f32;
    var phi_19146_: f32;
    var phi_19151_: u32;
    var phi_19152_: u32;
    var phi_19171_: u32;
    var phi_19172_: u32;
    var phi_19241_: f32;
    var phi_19250_: f32;
    var phi_19385_: f32;
    var phi_19391_: f32;
    var phi_19398_: f32;
    var phi_19433_: array<type_26, 4>;
    var phi_19453_: type_9;
    var phi_19456_: bool;
    var phi_19454_: type_9;
    var phi_19479_: type_9;
    var phi_19506_: bool;
    var phi_19507_: bool;
    var phi_19457_: bool;
    var phi_19508_: bool;
    var phi_19509_: bool;
    var local_92: bool;
    var phi_19513_: bool;
    var local_93: bool;
    var phi_19520_: u32;
    var phi_19521_: u32;
    var phi_19522_: bool;
    var phi_19523_: u32;
    var phi_19524_: u32;
    var phi_19525_: bool;
    var phi_19529_: u32;
    var phi_19539_: bool;
    var phi_19551_: bool;
    var phi_19552_: bool;
    var phi_19613_: array<f32, 3>;
    var phi_19678_: array<f32, 3>;
    var phi_19700_: f32;
    var phi_19707_: f32;
    var phi_19712_: f32;
    var phi_19719_: f32;
    var phi_19724_: f32;
    var phi_19737_: f32;
    var phi_19744_: f32;
    var phi_19749_: f32;
    var phi_19756_: f32;
    var phi_19761_: f32;
    var phi_19766_: f32;
    var phi_19783_: f32;
    var phi_19790_: f32;
    var phi_19795_: f32;
    var phi_19802_: f32;
    var phi_19807_: f32;
    var phi_19821_: f32;
    var phi_19828_: f32;
    var phi_19833_: f32;
    var phi_19840_: f32;
    var phi_19845_: f32;
    var phi_19850_: f32;
    var phi_19867_: f32;
    var phi_19874_: f32;
    var phi_19879_: f32;
    var phi_19886_: f32;
    var phi_19891_: f32;
    var phi_19905_: f32;
    var phi_19912_: f32;
    var phi_19917_: f32;
    var phi_19924_: f32;
    var phi_19929_: f32;
    var phi_19934_: f32;
    var phi_19975_: type_9;
    var phi_19978_: f32;
    var phi_19980_: f32;
    var phi_19982_: f32;
    var phi_19984_: f32;
    var phi_19986_: bool;
    var phi_19988_: u32;
    var phi_19976_: type_9;
    var phi_20011_: type_9;
    var phi_20125_: f32;
    var phi_20131_: f32;
    var phi_20137_: f32;
    var phi_20139_: array<f32, 3>;
    var phi_20146_: f32;
    var phi_20153_: f32;
    var phi_20161_: f32;
    var phi_20205_: type_14;
    var phi_20208_: f32;
    var phi_20229_: bool;
    var phi_20235_: type_15;
    var phi_20206_: type_14;
    var phi_20249_: type_15;
    var phi_20209_: f32;
    var local_94: f32;
    var phi_20198_: f32;
    var phi_20262_: f32;
    var phi_20328_: f32;
    var phi_20334_: f32;
    var phi_20343_: f32;
    var phi_20349_: f32;
    var phi_20358_: f32;
    var phi_20364_: f32;
    var phi_20373_: f32;
    var phi_20379_: f32;
    var phi_20385_: type_29;
    var phi_20386_: bool;
    var phi_20387_: type_29;
    var phi_20388_: bool;
    var phi_20396_: type_29;
    var phi_20567_: bool;
    var phi_20568_: bool;
    var phi_20569_: bool;
    var phi_20570_: bool;
    var phi_20571_: bool;
    var phi_20572_: bool;
    var phi_20576_: bool;
    var phi_20873_: bool;
    var phi_20874_: bool;
    var phi_20875_: bool;
    var phi_20876_: bool;
    var phi_20877_: bool;
    var phi_20878_: bool;
    var phi_20882_: bool;
    var phi_20886_: bool;
    var phi_20897_: bool;
    var phi_20898_: bool;
    var phi_20972_: bool;
    var phi_20973_: bool;
    var phi_20993_: f32;
    var phi_20994_: bool;
    var phi_20995_: f32;
    var phi_20996_: bool;
    var phi_20997_: f32;
    var phi_20998_: bool;
    var phi_20999_: bool;
    var phi_21003_: f32;
    var phi_21004_: bool;
    var phi_21008_: f32;
    var phi_21040_: bool;
    var phi_21041_: bool;
    var phi_21061_: f32;
    var phi_21062_: bool;
    var phi_21063_: f32;
    var phi_21064_: bool;
    var phi_21065_: f32;
    var phi_21066_: bool;
    var phi_21067_: bool;
    var phi_21071_: f32;
    var phi_21072_: bool;
    var phi_21076_: f32;
    var phi_21081_: f32;
    var phi_21113_: bool;
    var phi_21114_: bool;
    var phi_21134_: f32;
    var phi_21135_: bool;
    var phi_21136_: f32;
    var phi_21137_: bool;
    var phi_21138_: f32;
    var phi_21139_: bool;
    var phi_21140_: bool;
    var phi_21144_: f32;
    var phi_21145_: bool;
    var phi_21149_: f32;
    var phi_21181_: bool;
    var phi_21182_: bool;
    var phi_21202_: f32;
    var phi_21203_: bool;
    var phi_21204_: f32;
    var phi_21205_: bool;
    var phi_21206_: f32;
    var phi_21207_: bool;
    var phi_21208_: bool;
    var phi_21212_: f32;
    var phi_21213_: bool;
    var phi_21217_: f32;
    var phi_21222_: f32;
    var phi_21227_: f32;
    var phi_21232_: f32;
    var phi_21726_: bool;
    var phi_21727_: bool;
    var phi_21732_: f32;
    var phi_21734_: f32;
    var phi_21737_: f32;
    var phi_21738_: f32;
    var phi_21739_: bool;
    var phi_21741_: f32;
    var phi_21742_: f32;
    var phi_21743_: f32;
    var phi_21745_: bool;
    var phi_21746_: bool;
    var phi_21748_: bool;
    var phi_21749_: f32;
    var phi_21750_: f32;
    var phi_21751_: f32;
    var phi_21753_: bool;
    var phi_21754_: bool;
    var phi_21755_: bool;
    var phi_21757_: bool;
    var phi_21758_: f32;
    var phi_21759_: f32;
    var phi_21760_: f32;
    var phi_21762_: bool;
    var phi_21763_: bool;
    var phi_21764_: bool;
    var phi_21766_: bool;
    var phi_21852_: f32;
    var phi_21925_: f32;
    var phi_21930_: f32;
    var phi_22003_: f32;
    var phi_22076_: f32;
    var phi_22081_: f32;
    var phi_22097_: f32;
    var phi_22098_: f32;
    var phi_22099_: f32;
    var phi_21779_: bool;
    var phi_22101_: u32;
    var phi_22102_: f32;
    var phi_22103_: bool;
    var phi_22104_: bool;
    var phi_22105_: bool;
    var phi_22106_: u32;
    var phi_22107_: f32;
    var phi_22108_: f32;
    var phi_22109_: f32;
    var phi_22110_: f32;
    var phi_22111_: bool;
    var phi_22112_: u32;
    var phi_22113_: bool;
    var phi_22114_: bool;
    var phi_22115_: bool;
    var phi_22116_: bool;
    var phi_22118_: bool;
    var phi_22127_: f32;
    var phi_22132_: f32;
    var phi_22141_: bool;
    var phi_22145_: bool;
    var phi_22146_: f32;
    var phi_22147_: f32;
    var phi_22148_: f32;
    var phi_22149_: f32;
    var phi_22150_: bool;
    var phi_22151_: u32;
    var phi_22152_: bool;
    var phi_22153_: bool;
    var phi_22154_: bool;
    var phi_22155_: bool;
    var phi_22157_: bool;
    var phi_19979_: f32;
    var phi_19981_: f32;
    var phi_19983_: f32;
    var phi_19985_: f32;
    var phi_19987_: bool;
    var phi_19989_: u32;
    var phi_22158_: f32;
    var phi_22160_: bool;
    var phi_22161_: bool;
    var phi_22162_: bool;
    var phi_22163_: bool;
    var phi_22165_: bool;
    var phi_22166_: bool;
    var local_95: bool;
    var phi_22170_: bool;
    var phi_22171_: bool;
    var phi_22173_: bool;
    var phi_22174_: bool;
    var local_96: f32;
    var phi_22179_: type_44;
    var phi_22180_: bool;
    var phi_22182_: bool;
    var phi_22183_: bool;
    var phi_22184_: bool;
    var phi_22189_: type_44;
    var phi_22191_: bool;
    var phi_22192_: bool;
    var phi_22193_: bool;
    var phi_22194_: bool;
    var phi_22206_: f32;
    var phi_22207_: bool;
    var phi_22208_: bool;
    var phi_22209_: bool;
    var phi_22214_: type_44;
    var phi_22215_: bool;
    var phi_22216_: bool;
    var phi_22221_: type_44;
    var phi_22222_: bool;
    var phi_22226_: type_44;
    var phi_22233_: bool;
    var phi_22234_: f32;
    var phi_22235_: bool;
    var phi_22236_: bool;
    var phi_22237_: bool;
    var phi_22238_: bool;
    var phi_22239_: f32;
    var phi_22240_: f32;
    var phi_22241_: bool;
    var phi_22242_: bool;
    var phi_22243_: bool;
    var phi_22244_: bool;
    var phi_22245_: f32;
    var phi_22246_: f32;
    var phi_22247_: bool;
    var phi_22248_: bool;
    var phi_22249_: bool;
    var phi_22250_: bool;
    var phi_22254_: bool;
    var phi_22255_: bool;
    var phi_22256_: bool;
    var phi_22257_: type_47;
    var phi_22258_: bool;
    var phi_22259_: f32;
    var phi_22260_: f32;
    var phi_22261_: type_47;
    var phi_22262_: bool;
    var phi_22263_: bool;
    var phi_22264_: bool;
    var phi_22265_: bool;
    var phi_22269_: bool;
    var phi_22270_: bool;
    var phi_22271_: bool;
    var phi_22272_: type_47;
    var phi_22273_: bool;
    var phi_22274_: f32;
    var phi_22275_: f32;
    var phi_22276_: type_47;
    var phi_22277_: bool;
    var phi_22278_: bool;
    var phi_22279_: bool;
    var phi_22280_: bool;
    var local_97: bool;
    var phi_22285_: type_44;
    var phi_22286_: bool;
    var phi_22287_: bool;
    var local_98: bool;
    var local_99: type_47;
    var local_100: f32;
    var local_101: f32;
    var local_102: f32;
    var phi_22301_: type_44;
    var phi_22302_: bool;
    var phi_22303_: type_44;
    var phi_22304_: bool;
    var local_103: f32;
    var phi_22309_: type_44;
    var phi_22310_: type_44;
    var phi_22311_: bool;
    var local_104: type_47;
    var phi_22317_: type_44;
    var phi_22318_: bool;
    var phi_22322_: type_44;
    var phi_22323_: type_44;
    var phi_22324_: bool;
    var phi_22328_: type_44;
    var phi_22329_: type_44;
    var phi_22330_: bool;
    var phi_22334_: type_44;
    var phi_22345_: bool;
    var phi_22346_: bool;
    var phi_22350_: bool;
    var phi_22354_: u32;
    var phi_8313_: type_14;
    var phi_8316_: f32;
    var phi_8337_: bool;
    var phi_8343_: type_15;
    var phi_8314_: type_14;
    var phi_8357_: type_15;
    var phi_8317_: f32;
    var local_105: f32;
    var phi_8306_: f32;
    var phi_8370_: f32;
    var phi_8386_: f32;
    var phi_8393_: f32;
    var phi_8398_: f32;
    var phi_8405_: f32;
    var phi_8410_: f32;
    var phi_8423_: f32;
    var phi_8430_: f32;
    var phi_8435_: f32;
    var phi_8442_: f32;
    var phi_8447_: f32;
    var phi_8452_: f32;
    var phi_8469_: f32;
    var phi_8476_: f32;
    var phi_8481_: f32;
    var phi_8488_: f32;
    var phi_8493_: f32;
    var phi_8507_: f32;
    var phi_8514_: f32;
    var phi_8519_: f32;
    var phi_8526_: f32;
    var phi_8531_: f32;
    var phi_8536_: f32;
    var phi_8553_: f32;
    var phi_8560_: f32;
    var phi_8565_: f32;
    var phi_8572_: f32;
    var phi_8577_: f32;
    var phi_8591_: f32;
    var phi_8598_: f32;
    var phi_8603_: f32;
    var phi_8610_: f32;
    var phi_8615_: f32;
    var phi_8620_: f32;
    var phi_8881_: f32;
    var phi_8888_: f32;
    var phi_8893_: f32;
    var phi_8900_: f32;
    var phi_8905_: f32;
    var phi_8918_: f32;
    var phi_8925_: f32;
    var phi_8930_: f32;
    var phi_8937_: f32;
    var phi_8942_: f32;
    var phi_8947_: f32;
    var phi_8964_: f32;
    var phi_8971_: f32;
    var phi_8976_: f32;
    var phi_8983_: f32;
    var phi_8988_: f32;
    var phi_9002_: f32;
    var phi_9009_: f32;
    var phi_9014_: f32;
    var phi_9021_: f32;
    var phi_9026_: f32;
    var phi_9031_: f32;
    var phi_9048_: f32;
    var phi_9055_: f32;
    var phi_9060_: f32;
    var phi_9067_: f32;
    var phi_9072_: f32;
    var phi_9086_: f32;
    var phi_9093_: f32;
    var phi_9098_: f32;
    var phi_9105_: f32;
    var phi_9110_: f32;
    var phi_9115_: f32;
    var phi_9146_: f32;
    var phi_9152_: f32;
    var phi_9159_: f32;
    var phi_9166_: f32;
    var phi_9172_: f32;
    var phi_9179_: f32;
    var phi_9185_: f32;
    var phi_9191_: f32;
    var phi_9197_: f32;
    var phi_9204_: f32;
    var phi_9211_: f32;
    var phi_9235_: f32;
    var phi_9240_: f32;
    var phi_9245_: f32;
    var phi_9250_: f32;
    var phi_9255_: f32;
    var phi_9260_: f32;
    var phi_9270_: f32;
    var phi_9279_: type_45;
    var phi_9280_: bool;
    var phi_9281_: type_45;
    var phi_9282_: bool;
    var phi_9288_: type_14;
    var phi_9291_: f32;
    var phi_9293_: u32;
    var phi_9295_: f32;
    var phi_9316_: bool;
    var phi_9322_: type_15;
    var phi_9289_: type_14;
    var phi_9336_: type_15;
    var phi_9351_: bool;
    var phi_9352_: bool;
    var phi_9411_: array<f32, 3>;
    var phi_9476_: array<f32, 3>;
    var phi_9498_: f32;
    var phi_9505_: f32;
    var phi_9510_: f32;
    var phi_9517_: f32;
    var phi_9522_: f32;
    var phi_9535_: f32;
    var phi_9542_: f32;
    var phi_9547_: f32;
    var phi_9554_: f32;
    var phi_9559_: f32;
    var phi_9564_: f32;
    var phi_9581_: f32;
    var phi_9588_: f32;
    var phi_9593_: f32;
    var phi_9600_: f32;
    var phi_9605_: f32;
    var phi_9619_: f32;
    var phi_9626_: f32;
    var phi_9631_: f32;
    var phi_9638_: f32;
    var phi_9643_: f32;
    var phi_9648_: f32;
    var phi_9665_: f32;
    var phi_9672_: f32;
    var phi_9677_: f32;
    var phi_9684_: f32;
    var phi_9689_: f32;
    var phi_9703_: f32;
    var phi_9710_: f32;
    var phi_9715_: f32;
    var phi_9722_: f32;
    var phi_9727_: f32;
    var phi_9732_: f32;
    var phi_9773_: type_9;
    var phi_9776_: f32;
    var phi_9778_: f32;
    var phi_9780_: f32;
    var phi_9782_: f32;
    var phi_9784_: bool;
    var phi_9786_: u32;
    var phi_9774_: type_9;
    var phi_9809_: type_9;
    var phi_9923_: f32;
    var phi_9929_: f32;
    var phi_9935_: f32;
    var phi_9937_: array<f32, 3>;
    var phi_9944_: f32;
    var phi_9951_: f32;
    var phi_9959_: f32;
    var phi_10003_: type_14;
    var phi_10006_: f32;
    var phi_10027_: bool;
    var phi_10033_: type_15;
    var phi_10004_: type_14;
    var phi_10047_: type_15;
    var phi_10007_: f32;
    var local_106: f32;
    var phi_9996_: f32;
    var phi_10060_: f32;
    var phi_10126_: f32;
    var phi_10132_: f32;
    var phi_10141_: f32;
    var phi_10147_: f32;
    var phi_10156_: f32;
    var phi_10162_: f32;
    var phi_10171_: f32;
    var phi_10177_: f32;
    var phi_10183_: type_29;
    var phi_10184_: bool;
    var phi_10185_: type_29;
    var phi_10186_: bool;
    var phi_10194_: type_29;
    var phi_10365_: bool;
    var phi_10366_: bool;
    var phi_10367_: bool;
    var phi_10368_: bool;
    var phi_10369_: bool;
    var phi_10370_: bool;
    var phi_10374_: bool;
    var phi_10671_: bool;
    var phi_10672_: bool;
    var phi_10673_: bool;
    var phi_10674_: bool;
    var phi_10675_: bool;
    var phi_10676_: bool;
    var phi_10680_: bool;
    var phi_10684_: bool;
    var phi_10695_: bool;
    var phi_10696_: bool;
    var phi_10770_: bool;
    var phi_10771_: bool;
    var phi_10791_: f32;
    var phi_10792_: bool;
    var phi_10793_: f32;
    var phi_10794_: bool;
    var phi_10795_: f32;
    var phi_10796_: bool;
    var phi_10797_: bool;
    var phi_10801_: f32;
    var phi_10802_: bool;
    var phi_10806_: f32;
    var phi_10838_: bool;
    var phi_10839_: bool;
    var phi_10859_: f32;
    var phi_10860_: bool;
    var phi_10861_: f32;
    var phi_10862_: bool;
    var phi_10863_: f32;
    var phi_10864_: bool;
    var phi_10865_: bool;
    var phi_10869_: f32;
    var phi_10870_: bool;
    var phi_10874_: f32;
    var phi_10879_: f32;
    var phi_10911_: bool;
    var phi_10912_: bool;
    var phi_10932_: f32;
    var phi_10933_: bool;
    var phi_10934_: f32;
    var phi_10935_: bool;
    var phi_10936_: f32;
    var phi_10937_: bool;
    var phi_10938_: bool;
    var phi_10942_: f32;
    var phi_10943_: bool;
    var phi_10947_: f32;
    var phi_10979_: bool;
    var phi_10980_: bool;
    var phi_11000_: f32;
    var phi_11001_: bool;
    var phi_11002_: f32;
    var phi_11003_: bool;
    var phi_11004_: f32;
    var phi_11005_: bool;
    var phi_11006_: bool;
    var phi_11010_: f32;
    var phi_11011_: bool;
    var phi_11015_: f32;
    var phi_11020_: f32;
    var phi_11025_: f32;
    var phi_11030_: f32;
    var phi_11043_: f32;
    var phi_11180_: type_14;
    var phi_11183_: f32;
    var phi_11204_: bool;
    var phi_11210_: type_15;
    var phi_11181_: type_14;
    var phi_11224_: type_15;
    var phi_11184_: f32;
    var local_107: f32;
    var phi_11173_: f32;
    var phi_11237_: f32;
    var phi_11253_: f32;
    var phi_11260_: f32;
    var phi_11265_: f32;
    var phi_11272_: f32;
    var phi_11277_: f32;
    var phi_11290_: f32;
    var phi_11297_: f32;
    var phi_11302_: f32;
    var phi_11309_: f32;
    var phi_11314_: f32;
    var phi_11319_: f32;
    var phi_11336_: f32;
    var phi_11343_: f32;
    var phi_11348_: f32;
    var phi_11355_: f32;
    var phi_11360_: f32;
    var phi_11374_: f32;
    var phi_11381_: f32;
    var phi_11386_: f32;
    var phi_11393_: f32;
    var phi_11398_: f32;
    var phi_11403_: f32;
    var phi_11420_: f32;
    var phi_11427_: f32;
    var phi_11432_: f32;
    var phi_11439_: f32;
    var phi_11444_: f32;
    var phi_11458_: f32;
    var phi_11465_: f32;
    var phi_11470_: f32;
    var phi_11477_: f32;
    var phi_11482_: f32;
    var phi_11487_: f32;
    var phi_11507_: bool;
    var phi_11508_: bool;
    var phi_11509_: bool;
    var phi_11524_: bool;
    var phi_11525_: bool;
    var phi_11530_: f32;
    var phi_11532_: f32;
    var phi_11533_: f32;
    var phi_11534_: bool;
    var phi_11535_: f32;
    var phi_11536_: f32;
    var phi_11537_: bool;
    var phi_11538_: bool;
    var phi_11539_: f32;
    var phi_11540_: f32;
    var phi_11541_: f32;
    var phi_11542_: f32;
    var phi_11543_: bool;
    var phi_11544_: bool;
    var phi_11545_: bool;
    var phi_11546_: bool;
    var phi_11547_: f32;
    var phi_11548_: f32;
    var phi_11549_: f32;
    var phi_11550_: f32;
    var phi_11551_: bool;
    var phi_11552_: bool;
    var phi_11553_: bool;
    var phi_11554_: bool;
    var phi_11555_: bool;
    var phi_11556_: f32;
    var phi_11557_: f32;
    var phi_11558_: f32;
    var phi_11559_: f32;
    var phi_11560_: bool;
    var phi_11561_: bool;
    var phi_11562_: bool;
    var phi_11563_: bool;
    var phi_11564_: bool;
    var phi_11650_: f32;
    var phi_11723_: f32;
    var phi_11728_: f32;
    var phi_11801_: f32;
    var phi_11874_: f32;
    var phi_11879_: f32;
    var phi_11895_: f32;
    var phi_11896_: f32;
    var phi_11897_: f32;
    var phi_11577_: bool;
    var phi_11899_: u32;
    var phi_11900_: f32;
    var phi_11901_: bool;
    var phi_11902_: bool;
    var phi_11903_: bool;
    var phi_11904_: u32;
    var phi_11905_: f32;
    var phi_11906_: f32;
    var phi_11907_: f32;
    var phi_11908_: f32;
    var phi_11909_: bool;
    var phi_11910_: u32;
    var phi_11911_: bool;
    var phi_11912_: bool;
    var phi_11913_: bool;
    var phi_11914_: bool;
    var phi_11915_: bool;
    var phi_11916_: bool;
    var phi_11925_: f32;
    var phi_11930_: f32;
    var phi_11939_: bool;
    var phi_11943_: bool;
    var phi_11944_: f32;
    var phi_11945_: f32;
    var phi_11946_: f32;
    var phi_11947_: f32;
    var phi_11948_: bool;
    var phi_11949_: u32;
    var phi_11950_: bool;
    var phi_11951_: bool;
    var phi_11952_: bool;
    var phi_11953_: bool;
    var phi_11954_: bool;
    var phi_11955_: bool;
    var phi_9777_: f32;
    var phi_9779_: f32;
    var phi_9781_: f32;
    var phi_9783_: f32;
    var phi_9785_: bool;
    var phi_9787_: u32;
    var phi_11956_: f32;
    var phi_11957_: f32;
    var phi_11958_: bool;
    var phi_11959_: bool;
    var phi_11960_: bool;
    var phi_11961_: bool;
    var phi_11962_: bool;
    var phi_11963_: bool;
    var phi_11964_: bool;
    var local_108: bool;
    var phi_11968_: bool;
    var phi_11969_: bool;
    var phi_11970_: bool;
    var phi_11971_: bool;
    var phi_11972_: bool;
    var local_109: f32;
    var phi_11977_: type_44;
    var phi_11978_: bool;
    var phi_11979_: bool;
    var phi_11980_: bool;
    var phi_11981_: bool;
    var phi_11982_: bool;
    var phi_11987_: type_44;
    var phi_11988_: bool;
    var phi_11989_: bool;
    var phi_11990_: bool;
    var phi_11991_: bool;
    var phi_11992_: bool;
    var phi_11996_: f32;
    var phi_11997_: bool;
    var phi_11998_: bool;
    var phi_11999_: bool;
    var phi_12000_: bool;
    var phi_12004_: f32;
    var phi_12005_: bool;
    var phi_12006_: bool;
    var phi_12007_: bool;
    var phi_12012_: type_44;
    var phi_12013_: bool;
    var phi_12014_: bool;
    var phi_12019_: type_44;
    var phi_12020_: bool;
    var phi_12024_: type_44;
    var phi_12031_: f32;
    var phi_12032_: bool;
    var phi_12144_: f32;
    var phi_12151_: f32;
    var phi_12159_: f32;
    var phi_12217_: array<f32, 3>;
    var phi_12285_: array<f32, 3>;
    var phi_12310_: f32;
    var phi_12317_: f32;
    var phi_12322_: f32;
    var phi_12329_: f32;
    var phi_12334_: f32;
    var phi_12347_: f32;
    var phi_12354_: f32;
    var phi_12359_: f32;
    var phi_12366_: f32;
    var phi_12371_: f32;
    var phi_12376_: f32;
    var phi_12393_: f32;
    var phi_12400_: f32;
    var phi_12405_: f32;
    var phi_12412_: f32;
    var phi_12417_: f32;
    var phi_12431_: f32;
    var phi_12438_: f32;
    var phi_12443_: f32;
    var phi_12450_: f32;
    var phi_12455_: f32;
    var phi_12460_: f32;
    var phi_12477_: f32;
    var phi_12484_: f32;
    var phi_12489_: f32;
    var phi_12496_: f32;
    var phi_12501_: f32;
    var phi_12515_: f32;
    var phi_12522_: f32;
    var phi_12527_: f32;
    var phi_12534_: f32;
    var phi_12539_: f32;
    var phi_12544_: f32;
    var phi_12652_: type_14;
    var phi_12655_: f32;
    var phi_12676_: bool;
    var phi_12682_: type_15;
    var phi_12653_: type_14;
    var phi_12696_: type_15;
    var phi_12656_: f32;
    var local_110: f32;
    var phi_12645_: f32;
    var phi_12709_: f32;
    var phi_12843_: f32;
    var phi_12849_: f32;
    var phi_12858_: f32;
    var phi_12864_: f32;
    var phi_12873_: f32;
    var phi_12879_: f32;
    var phi_12888_: f32;
    var phi_12894_: f32;
    var phi_12944_: type_14;
    var phi_12947_: f32;
    var phi_12968_: bool;
    var phi_12974_: type_15;
    var phi_12945_: type_14;
    var phi_12988_: type_15;
    var phi_12948_: f32;
    var local_111: f32;
    var phi_12937_: f32;
    var phi_13001_: f32;
    var phi_13033_: type_14;
    var phi_13036_: f32;
    var phi_13057_: bool;
    var phi_13063_: type_15;
    var phi_13034_: type_14;
    var phi_13077_: type_15;
    var phi_13037_: f32;
    var local_112: f32;
    var phi_13026_: f32;
    var phi_13090_: f32;
    var phi_13106_: f32;
    var phi_13113_: f32;
    var phi_13118_: f32;
    var phi_13125_: f32;
    var phi_13130_: f32;
    var phi_13143_: f32;
    var phi_13150_: f32;
    var phi_13155_: f32;
    var phi_13162_: f32;
    var phi_13167_: f32;
    var phi_13172_: f32;
    var phi_13189_: f32;
    var phi_13196_: f32;
    var phi_13201_: f32;
    var phi_13208_: f32;
    var phi_13213_: f32;
    var phi_13227_: f32;
    var phi_13234_: f32;
    var phi_13239_: f32;
    var phi_13246_: f32;
    var phi_13251_: f32;
    var phi_13256_: f32;
    var phi_13273_: f32;
    var phi_13280_: f32;
    var phi_13285_: f32;
    var phi_13292_: f32;
    var phi_13297_: f32;
    var phi_13311_: f32;
    var phi_13318_: f32;
    var phi_13323_: f32;
    var phi_13330_: f32;
    var phi_13335_: f32;
    var phi_13340_: f32;
    var phi_13381_: f32;
    var phi_13387_: f32;
    var phi_13398_: type_9;
    var phi_13401_: f32;
    var phi_13399_: type_9;
    var phi_13424_: type_9;
    var phi_13453_: f32;
    var phi_13459_: f32;
    var phi_13472_: f32;
    var phi_13402_: f32;
    var local_113: f32;
    var local_114: f32;
    var phi_13500_: type_14;
    var phi_13503_: f32;
    var phi_13524_: bool;
    var phi_13530_: type_15;
    var phi_13501_: type_14;
    var phi_13544_: type_15;
    var phi_13504_: f32;
    var local_115: f32;
    var phi_13493_: f32;
    var phi_13557_: f32;
    var phi_13562_: type_9;
    var phi_13565_: f32;
    var phi_13567_: bool;
    var phi_13569_: bool;
    var phi_13563_: type_9;
    var phi_13592_: type_9;
    var phi_13629_: f32;
    var phi_13636_: f32;
    var phi_13644_: f32;
    var phi_13652_: f32;
    var phi_13659_: f32;
    var phi_13667_: f32;
    var phi_13673_: f32;
    var phi_13691_: f32;
    var phi_13697_: f32;
    var phi_13704_: f32;
    var phi_13730_: f32;
    var phi_13736_: f32;
    var phi_13772_: bool;
    var phi_13779_: bool;
    var phi_13792_: f32;
    var phi_13798_: f32;
    var phi_13799_: f32;
    var phi_13800_: f32;
    var phi_13566_: f32;
    var phi_13568_: bool;
    var phi_13570_: bool;
    var local_116: f32;
    var phi_13805_: f32;
    var local_117: bool;
    var local_118: bool;
    var phi_13814_: type_46;
    var phi_13815_: type_46;
    var phi_13816_: bool;
    var local_119: bool;
    var phi_13833_: f32;
    var phi_13834_: f32;
    var phi_13837_: type_9;
    var phi_13840_: f32;
    var phi_13842_: f32;
    var phi_13838_: type_9;
    var phi_13865_: type_9;
    var phi_13948_: f32;
    var phi_13949_: f32;
    var phi_13950_: f32;
    var phi_13933_: f32;
    var phi_13951_: f32;
    var phi_13952_: f32;
    var phi_13841_: f32;
    var phi_13843_: f32;
    var local_120: f32;
    var local_121: f32;
    var local_122: f32;
    var phi_14113_: bool;
    var phi_14114_: bool;
    var phi_14115_: bool;
    var phi_14116_: bool;
    var phi_14117_: bool;
    var phi_14118_: bool;
    var phi_14122_: bool;
    var phi_14126_: bool;
    var phi_14127_: bool;
    var phi_14128_: bool;
    var phi_14132_: f32;
    var phi_14135_: type_46;
    var phi_14136_: type_46;
    var phi_14137_: bool;
    var phi_14138_: type_46;
    var phi_14139_: type_46;
    var phi_14140_: bool;
    var phi_14145_: type_46;
    var phi_14146_: type_46;
    var phi_14147_: bool;
    var phi_14151_: type_46;
    var phi_14152_: type_46;
    var phi_14153_: bool;
    var phi_14154_: bool;
    var phi_14155_: type_46;
    var phi_14156_: type_46;
    var phi_14157_: bool;
    var phi_14158_: bool;
    var phi_14163_: type_46;
    var phi_14164_: bool;
    var phi_14168_: type_46;
    var phi_14184_: f32;
    var phi_14185_: f32;
    var phi_14186_: bool;
    var phi_14187_: f32;
    var phi_14188_: f32;
    var phi_14189_: bool;
    var phi_14190_: bool;
    var phi_14191_: bool;
    var phi_14192_: f32;
    var phi_14193_: f32;
    var phi_14194_: bool;
    var phi_14195_: bool;
    var phi_14196_: bool;
    var phi_14197_: f32;
    var phi_14198_: u32;
    var phi_14199_: f32;
    var phi_14200_: type_46;
    var phi_14201_: u32;
    var phi_14202_: u32;
    var phi_14203_: bool;
    var phi_14204_: bool;
    var phi_14205_: bool;
    var phi_14206_: f32;
    var phi_14207_: u32;
    var phi_14208_: f32;
    var phi_14209_: type_46;
    var phi_14210_: u32;
    var phi_14211_: u32;
    var phi_14212_: bool;
    var phi_14213_: bool;
    var phi_14214_: bool;
    var phi_14215_: bool;
    var phi_14216_: bool;
    var phi_14217_: f32;
    var phi_9292_: f32;
    var phi_9294_: u32;
    var phi_9296_: f32;
    var phi_14218_: type_46;
    var phi_14219_: u32;
    var phi_14220_: f32;
    var phi_14221_: u32;
    var phi_14222_: bool;
    var phi_14223_: bool;
    var phi_14224_: bool;
    var phi_14225_: bool;
    var phi_14226_: bool;
    var phi_14227_: bool;
    var local_123: bool;
    var phi_14231_: bool;
    var phi_14232_: bool;
    var phi_14233_: bool;
    var phi_14234_: bool;
    var local_124: type_46;
    var local_125: type_46;
    var phi_14251_: u32;
    var local_126: type_46;
    var phi_14256_: type_45;
    var phi_14257_: type_45;
    var phi_14258_: bool;
    var phi_14259_: bool;
    var phi_14260_: bool;
    var phi_14261_: bool;
    var phi_14265_: u32;
    var phi_14266_: f32;
    var phi_14267_: bool;
    var phi_14268_: bool;
    var phi_14269_: bool;
    var phi_14270_: bool;
    var phi_14274_: f32;
    var phi_14275_: u32;
    var phi_14276_: bool;
    var phi_14277_: bool;
    var phi_14278_: bool;
    var phi_14290_: f32;
    var phi_14293_: type_9;
    var phi_14294_: type_9;
    var phi_14317_: type_9;
    var phi_14338_: f32;
    var phi_14468_: type_14;
    var phi_14471_: f32;
    var phi_14492_: bool;
    var phi_14498_: type_15;
    var phi_14469_: type_14;
    var phi_14512_: type_15;
    var phi_14472_: f32;
    var local_127: f32;
    var phi_14461_: f32;
    var phi_14525_: f32;
    var phi_14541_: f32;
    var phi_14548_: f32;
    var phi_14553_: f32;
    var phi_14560_: f32;
    var phi_14565_: f32;
    var phi_14578_: f32;
    var phi_14585_: f32;
    var phi_14590_: f32;
    var phi_14597_: f32;
    var phi_14602_: f32;
    var phi_14607_: f32;
    var phi_14624_: f32;
    var phi_14631_: f32;
    var phi_14636_: f32;
    var phi_14643_: f32;
    var phi_14648_: f32;
    var phi_14662_: f32;
    var phi_14669_: f32;
    var phi_14674_: f32;
    var phi_14681_: f32;
    var phi_14686_: f32;
    var phi_14691_: f32;
    var phi_14708_: f32;
    var phi_14715_: f32;
    var phi_14720_: f32;
    var phi_14727_: f32;
    var phi_14732_: f32;
    var phi_14746_: f32;
    var phi_14753_: f32;
    var phi_14758_: f32;
    var phi_14765_: f32;
    var phi_14770_: f32;
    var phi_14775_: f32;
    var phi_14795_: bool;
    var phi_14796_: bool;
    var phi_14797_: bool;
    var local_128: bool;
    var phi_14805_: u32;
    var phi_14809_: type_45;
    var phi_14810_: bool;
    var phi_14818_: u32;
    var phi_14822_: type_45;
    var phi_14823_: type_45;
    var phi_14824_: bool;
    var phi_14825_: bool;
    var phi_14832_: type_45;
    var phi_14833_: bool;
    var phi_14837_: type_45;
    var phi_14838_: type_45;
    var phi_14839_: bool;
    var phi_14843_: type_45;
    var phi_22358_: type_45;
    var phi_22376_: type_28;
    var phi_22392_: array<u32, 2>;
    var phi_22413_: array<u32, 2>;
    var phi_22416_: bool;
    var phi_22431_: bool;
    var phi_22432_: bool;
    var phi_22440_: bool;
    var phi_22441_: bool;
    var phi_22446_: u32;
    var phi_22451_: type_28;
    var phi_22458_: bool;
    var phi_22483_: u32;
    var phi_22487_: type_20;
    var phi_22488_: bool;
    var phi_22489_: bool;
    var phi_22508_: u32;
    var phi_22575_: u32;
    var local_129: bool;
    var local_130: bool;
    var local_131: bool;
    var local_132: bool;
    var local_133: bool;
    var local_134: u32;
    var local_135: f32;
    var local_136: f32;
    var local_137: bool;
    var local_138: bool;
    var local_139: f32;
    var local_140: bool;
    var local_141: bool;
    var local_142: bool;
    var local_143: bool;
    var local_144: bool;
    var local_145: f32;
    var local_146: f32;
    var local_147: bool;
    var local_148: bool;
    var local_149: bool;
    var local_150: bool;
    var local_151: bool;
    var local_152: bool;
    var local_153: bool;
    var local_154: bool;
    var local_155: f32;
    var local_156: f32;
    var local_157: f32;
    var local_158: f32;
    var local_159: bool;
    var local_160: bool;
    var local_161: bool;
    var local_162: bool;
    var local_163: bool;
    var local_164: u32;
    var local_165: bool;
    var local_166: u32;
    var local_167: u32;
    var local_168: f32;
    var local_169: f32;
    var local_170: f32;
    var local_171: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e184 = id_2;
    let _e185 = n_2;
    let _e186 = lane_2;
    let _e199 = ((_e184.y * _e185.x) + _e184.x);
    let _e202 = (_e185.x * _e185.y);
    let _e205 = params.member.member_1.member_2;
    let _e207 = input.member[0u];
    if (_e205 < _e207) {
        phi_363_ = _e205;
    } else {
        phi_363_ = _e207;
    }
    let _e210 = phi_363_;
    let _e212 = params.member.member_1.member_1;
    if (_e210 > _e212) {
        let _e215 = params.member.member_1.member_1;
        phi_373_ = (_e210 - _e215);
    } else {
        phi_373_ = 0u;
    }
    let _e218 = phi_373_;
    let _e220 = params.member.member_1.member;
    if (_e220 < _e218) {
        phi_380_ = _e220;
    } else {
        phi_380_ = _e218;
    }
    let _e223 = phi_380_;
    let _e224 = (_e223 / 64u);
    if ((_e223 % 64u) > 0u) {
        phi_396_ = (_e224 + 1u);
    } else {
        phi_396_ = _e224;
    }
    let _e229 = phi_396_;
    if (_e229 > _e199) {
        let _e231 = (_e229 - _e199);
        if (_e202 == 0u) {
            return;
        }
        let _e233 = (_e231 / _e202);
        if (_e202 == 0u) {
            return;
        }
        if ((_e231 % _e202) > 0u) {
            phi_417_ = (_e233 + 1u);
        } else {
            phi_417_ = _e233;
        }
        let _e239 = phi_417_;
        phi_418_ = _e239;
    } else {
        phi_418_ = 0u;
    }
    let _e241 = phi_418_;
    phi_421_ = type_9(0u, _e241);
    loop {
        let _e244 = phi_421_;
        if (_e244.member < _e244.member_1) {
            phi_422_ = type_9((_e244.member + 1u), _e244.member_1);
            phi_445_ = type_9(1u, _e244.member);
        } else {
            phi_422_ = _e244;
            phi_445_ = type_9(0u, type_9().member_1);
        }
        let _e256 = phi_422_;
        let _e258 = phi_445_;
        let _e262 = (bitcast<i32>(_e258.member) != 0i);
        if _e262 {
            let _e266 = (((_e199 + (_e258.member_1 * _e202)) * 64u) + _e186);
            let _e270 = params.member.member_2.member.member;
            if (_e266 < _e223) {
                let _e275 = params.member.member_1.member_1;
                let _e277 = (2u * (_e275 + _e266));
                let _e280 = input.member[(4u + _e277)];
                let _e283 = input.member[(_e277 + 5u)];
                let _e288 = params.member.member_2.member.member;
                if (_e288 == 0u) {
                    let _e304 = (3u * _e283);
                    let _e306 = elements.member[_e304];
                    let _e309 = elements.member[(_e304 + 1u)];
                    let _e312 = elements.member[(_e304 + 2u)];
                    phi_581_ = type_25(0u, array<u32, 4>(_e280, _e306, _e309, _e312));
                } else {
                    let _e290 = (2u * _e280);
                    let _e291 = (2u * _e283);
                    let _e293 = elements.member[_e290];
                    let _e295 = elements.member[_e291];
                    let _e298 = elements.member[(_e290 + 1u)];
                    let _e301 = elements.member[(_e291 + 1u)];
                    phi_581_ = type_25(1u, array<u32, 4>(_e293, _e298, _e295, _e301));
                }
                let _e316 = phi_581_;
                local_58 = array<u32, 4>(_e316.member_1[0], _e316.member_1[1], _e316.member_1[2], _e316.member_1[3]);
                let _e324 = local_58;
                let _e330 = paths.member[_e324[0]];
                let _e332 = paths.member[_e324[1]];
                let _e338 = paths.member[_e324[2]];
                let _e340 = paths.member[_e324[3]];
                local_59 = array<array<f32, 3>, 4>(array<f32, 3>(_e330.member[0], _e330.member[1], _e330.member[2]), array<f32, 3>(_e332.member[0], _e332.member[1], _e332.member[2]), array<f32, 3>(_e338.member[0], _e338.member[1], _e338.member[2]), array<f32, 3>(_e340.member[0], _e340.member[1], _e340.member[2]));
                local_60 = array<array<f32, 3>, 4>(array<f32, 3>(_e330.member_1[0], _e330.member_1[1], _e330.member_1[2]), array<f32, 3>(_e332.member_1[0], _e332.member_1[1], _e332.member_1[2]), array<f32, 3>(_e338.member_1[0], _e338.member_1[1], _e338.member_1[2]), array<f32, 3>(_e340.member_1[0], _e340.member_1[1], _e340.member_1[2]));
                let _e380 = params.member.member.member_4;
                if (_e316.member != 0u) {
                    let _e472 = local_59[2u];
                    let _e477 = local_59[0u];
                    let _e486 = local_60[2u];
                    let _e491 = local_60[0u];
                    let _e501 = local_59[1u];
                    let _e506 = local_59[0u];
                    let _e515 = local_60[1u];
                    let _e520 = local_60[0u];
                    let _e530 = local_59[2u];
                    let _e535 = local_59[3u];
                    let _e544 = local_60[2u];
                    let _e549 = local_60[3u];
                    phi_1003_ = type_23(array<array<f32, 3>, 2>(array<f32, 3>((_e472[0] - _e477[0]), (_e472[1] - _e477[1]), (_e472[2] - _e477[2])), array<f32, 3>((_e486[0] - _e491[0]), (_e486[1] - _e491[1]), (_e486[2] - _e491[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e501[0] - _e506[0]), (_e501[1] - _e506[1]), (_e501[2] - _e506[2])), array<f32, 3>((_e515[0] - _e520[0]), (_e515[1] - _e520[1]), (_e515[2] - _e520[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e530[0] - _e535[0]), (_e530[1] - _e535[1]), (_e530[2] - _e535[2])), array<f32, 3>((_e544[0] - _e549[0]), (_e544[1] - _e549[1]), (_e544[2] - _e549[2]))), (_e380 + _e380));
                } else {
                    let _e383 = local_59[0u];
                    let _e388 = local_59[1u];
                    let _e397 = local_60[0u];
                    let _e402 = local_60[1u];
                    let _e412 = local_59[2u];
                    let _e417 = local_59[1u];
                    let _e426 = local_60[2u];
                    let _e431 = local_60[1u];
                    let _e441 = local_59[3u];
                    let _e446 = local_59[1u];
                    let _e455 = local_60[3u];
                    let _e460 = local_60[1u];
                    phi_1003_ = type_23(array<array<f32, 3>, 2>(array<f32, 3>((_e383[0] - _e388[0]), (_e383[1] - _e388[1]), (_e383[2] - _e388[2])), array<f32, 3>((_e397[0] - _e402[0]), (_e397[1] - _e402[1]), (_e397[2] - _e402[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e412[0] - _e417[0]), (_e412[1] - _e417[1]), (_e412[2] - _e417[2])), array<f32, 3>((_e426[0] - _e431[0]), (_e426[1] - _e431[1]), (_e426[2] - _e431[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e441[0] - _e446[0]), (_e441[1] - _e446[1]), (_e441[2] - _e446[2])), array<f32, 3>((_e455[0] - _e460[0]), (_e455[1] - _e460[1]), (_e455[2] - _e460[2]))), (_e380 + _e380));
                }
                let _e561 = phi_1003_;
                if (_e561.member[0][0] < 0f) {
                    phi_1011_ = -(_e561.member[0][0]);
                } else {
                    phi_1011_ = _e561.member[0][0];
                }
                let _e568 = phi_1011_;
                if (_e561.member[0][1] < 0f) {
                    phi_1018_ = -(_e561.member[0][1]);
                } else {
                    phi_1018_ = _e561.member[0][1];
                }
                let _e573 = phi_1018_;
                if (_e568 > _e573) {
                    phi_1023_ = _e568;
                } else {
                    phi_1023_ = _e573;
                }
                let _e576 = phi_1023_;
                if (_e561.member[0][2] < 0f) {
                    phi_1030_ = -(_e561.member[0][2]);
                } else {
                    phi_1030_ = _e561.member[0][2];
                }
                let _e581 = phi_1030_;
                if (_e576 > _e581) {
                    phi_1035_ = _e576;
                } else {
                    phi_1035_ = _e581;
                }
                let _e584 = phi_1035_;
                if (_e561.member[1][0] < 0f) {
                    phi_1043_ = -(_e561.member[1][0]);
                } else {
                    phi_1043_ = _e561.member[1][0];
                }
                let _e591 = phi_1043_;
                if (_e561.member[1][1] < 0f) {
                    phi_1050_ = -(_e561.member[1][1]);
                } else {
                    phi_1050_ = _e561.member[1][1];
                }
                let _e596 = phi_1050_;
                if (_e591 > _e596) {
                    phi_1055_ = _e591;
                } else {
                    phi_1055_ = _e596;
                }
                let _e599 = phi_1055_;
                if (_e561.member[1][2] < 0f) {
                    phi_1062_ = -(_e561.member[1][2]);
                } else {
                    phi_1062_ = _e561.member[1][2];
                }
                let _e604 = phi_1062_;
                if (_e599 > _e604) {
                    phi_1067_ = _e599;
                } else {
                    phi_1067_ = _e604;
                }
                let _e607 = phi_1067_;
                if (_e584 > _e607) {
                    phi_1072_ = _e584;
                } else {
                    phi_1072_ = _e607;
                }
                let _e610 = phi_1072_;
                if (_e561.member_1[0][0] < 0f) {
                    phi_1082_ = -(_e561.member_1[0][0]);
                } else {
                    phi_1082_ = _e561.member_1[0][0];
                }
                let _e619 = phi_1082_;
                if (_e561.member_1[0][1] < 0f) {
                    phi_1089_ = -(_e561.member_1[0][1]);
                } else {
                    phi_1089_ = _e561.member_1[0][1];
                }
                let _e624 = phi_1089_;
                if (_e619 > _e624) {
                    phi_1094_ = _e619;
                } else {
                    phi_1094_ = _e624;
                }
                let _e627 = phi_1094_;
                if (_e561.member_1[0][2] < 0f) {
                    phi_1101_ = -(_e561.member_1[0][2]);
                } else {
                    phi_1101_ = _e561.member_1[0][2];
                }
                let _e632 = phi_1101_;
                if (_e627 > _e632) {
                    phi_1106_ = _e627;
                } else {
                    phi_1106_ = _e632;
                }
                let _e635 = phi_1106_;
                if (_e561.member_1[1][0] < 0f) {
                    phi_1114_ = -(_e561.member_1[1][0]);
                } else {
                    phi_1114_ = _e561.member_1[1][0];
                }
                let _e642 = phi_1114_;
                if (_e561.member_1[1][1] < 0f) {
                    phi_1121_ = -(_e561.member_1[1][1]);
                } else {
                    phi_1121_ = _e561.member_1[1][1];
                }
                let _e647 = phi_1121_;
                if (_e642 > _e647) {
                    phi_1126_ = _e642;
                } else {
                    phi_1126_ = _e647;
                }
                let _e650 = phi_1126_;
                if (_e561.member_1[1][2] < 0f) {
                    phi_1133_ = -(_e561.member_1[1][2]);
                } else {
                    phi_1133_ = _e561.member_1[1][2];
                }
                let _e655 = phi_1133_;
                if (_e650 > _e655) {
                    phi_1138_ = _e650;
                } else {
                    phi_1138_ = _e655;
                }
                let _e658 = phi_1138_;
                if (_e635 > _e658) {
                    phi_1143_ = _e635;
                } else {
                    phi_1143_ = _e658;
                }
                let _e661 = phi_1143_;
                if (_e561.member_2[0][0] < 0f) {
                    phi_1153_ = -(_e561.member_2[0][0]);
                } else {
                    phi_1153_ = _e561.member_2[0][0];
                }
                let _e670 = phi_1153_;
                if (_e561.member_2[0][1] < 0f) {
                    phi_1160_ = -(_e561.member_2[0][1]);
                } else {
                    phi_1160_ = _e561.member_2[0][1];
                }
                let _e675 = phi_1160_;
                if (_e670 > _e675) {
                    phi_1165_ = _e670;
                } else {
                    phi_1165_ = _e675;
                }
                let _e678 = phi_1165_;
                if (_e561.member_2[0][2] < 0f) {
                    phi_1172_ = -(_e561.member_2[0][2]);
                } else {
                    phi_1172_ = _e561.member_2[0][2];
                }
                let _e683 = phi_1172_;
                if (_e678 > _e683) {
                    phi_1177_ = _e678;
                } else {
                    phi_1177_ = _e683;
                }
                let _e686 = phi_1177_;
                if (_e561.member_2[1][0] < 0f) {
                    phi_1185_ = -(_e561.member_2[1][0]);
                } else {
                    phi_1185_ = _e561.member_2[1][0];
                }
                let _e693 = phi_1185_;
                if (_e561.member_2[1][1] < 0f) {
                    phi_1192_ = -(_e561.member_2[1][1]);
                } else {
                    phi_1192_ = _e561.member_2[1][1];
                }
                let _e698 = phi_1192_;
                if (_e693 > _e698) {
                    phi_1197_ = _e693;
                } else {
                    phi_1197_ = _e698;
                }
                let _e701 = phi_1197_;
                if (_e561.member_2[1][2] < 0f) {
                    phi_1204_ = -(_e561.member_2[1][2]);
                } else {
                    phi_1204_ = _e561.member_2[1][2];
                }
                let _e706 = phi_1204_;
                if (_e701 > _e706) {
                    phi_1209_ = _e701;
                } else {
                    phi_1209_ = _e706;
                }
                let _e709 = phi_1209_;
                if (_e686 > _e709) {
                    phi_1214_ = _e686;
                } else {
                    phi_1214_ = _e709;
                }
                let _e712 = phi_1214_;
                let _e715 = function_13((_e610 + _e561.member_3), (_e661 + _e561.member_3));
                let _e716 = function_13(_e715, (_e712 + _e561.member_3));
                let _e720 = bitcast<i32>((bitcast<u32>(_e716) >> bitcast<u32>(23i)));
                if (_e720 >= 64i) {
                    if (_e720 <= 190i) {
                        phi_1231_ = (_e720 - 126i);
                        phi_1232_ = false;
                    } else {
                        phi_1231_ = i32();
                        phi_1232_ = true;
                    }
                    let _e725 = phi_1231_;
                    let _e727 = phi_1232_;
                    phi_1233_ = _e725;
                    phi_1234_ = _e727;
                } else {
                    phi_1233_ = i32();
                    phi_1234_ = true;
                }
                let _e729 = phi_1233_;
                let _e731 = phi_1234_;
                if _e731 {
                    phi_1238_ = 2147483647i;
                } else {
                    phi_1238_ = _e729;
                }
                let _e733 = phi_1238_;
                let _e735 = params.member.member_2.member_3;
                if (_e735 > 0u) {
                    if (_e733 != 2147483647i) {
                        let _e739 = params.member.member.member_1;
                        if ((_e739 & 8u) != 0u) {
                            let _e1036 = local_59[0u];
                            let _e1040 = bitcast<u32>(_e1036[0]);
                            let _e1041 = (_e1040 & 2147483647u);
                            if (_e1041 < 8388608u) {
                                phi_1280_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1280_ = array<u32, 2>((_e1040 << bitcast<u32>(29i)), ((_e1040 ^ _e1041) | ((_e1041 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1052 = phi_1280_;
                            let _e1053 = function_12(_e1052, _e733);
                            let _e1054 = bitcast<u32>(_e1036[1]);
                            let _e1055 = (_e1054 & 2147483647u);
                            if (_e1055 < 8388608u) {
                                phi_1297_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1297_ = array<u32, 2>((_e1054 << bitcast<u32>(29i)), ((_e1054 ^ _e1055) | ((_e1055 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1066 = phi_1297_;
                            let _e1067 = function_12(_e1066, _e733);
                            let _e1068 = bitcast<u32>(_e1036[2]);
                            let _e1069 = (_e1068 & 2147483647u);
                            if (_e1069 < 8388608u) {
                                phi_1314_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1314_ = array<u32, 2>((_e1068 << bitcast<u32>(29i)), ((_e1068 ^ _e1069) | ((_e1069 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1080 = phi_1314_;
                            let _e1081 = function_12(_e1080, _e733);
                            let _e1087 = local_60[0u];
                            let _e1091 = bitcast<u32>(_e1087[0]);
                            let _e1092 = (_e1091 & 2147483647u);
                            if (_e1092 < 8388608u) {
                                phi_1348_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1348_ = array<u32, 2>((_e1091 << bitcast<u32>(29i)), ((_e1091 ^ _e1092) | ((_e1092 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1103 = phi_1348_;
                            let _e1104 = function_12(_e1103, _e733);
                            let _e1105 = bitcast<u32>(_e1087[1]);
                            let _e1106 = (_e1105 & 2147483647u);
                            if (_e1106 < 8388608u) {
                                phi_1365_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1365_ = array<u32, 2>((_e1105 << bitcast<u32>(29i)), ((_e1105 ^ _e1106) | ((_e1106 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1117 = phi_1365_;
                            let _e1118 = function_12(_e1117, _e733);
                            let _e1119 = bitcast<u32>(_e1087[2]);
                            let _e1120 = (_e1119 & 2147483647u);
                            if (_e1120 < 8388608u) {
                                phi_1382_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1382_ = array<u32, 2>((_e1119 << bitcast<u32>(29i)), ((_e1119 ^ _e1120) | ((_e1120 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1131 = phi_1382_;
                            let _e1132 = function_12(_e1131, _e733);
                            let _e1139 = local_59[1u];
                            let _e1143 = bitcast<u32>(_e1139[0]);
                            let _e1144 = (_e1143 & 2147483647u);
                            if (_e1144 < 8388608u) {
                                phi_1417_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1417_ = array<u32, 2>((_e1143 << bitcast<u32>(29i)), ((_e1143 ^ _e1144) | ((_e1144 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1155 = phi_1417_;
                            let _e1156 = function_12(_e1155, _e733);
                            let _e1157 = bitcast<u32>(_e1139[1]);
                            let _e1158 = (_e1157 & 2147483647u);
                            if (_e1158 < 8388608u) {
                                phi_1434_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1434_ = array<u32, 2>((_e1157 << bitcast<u32>(29i)), ((_e1157 ^ _e1158) | ((_e1158 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1169 = phi_1434_;
                            let _e1170 = function_12(_e1169, _e733);
                            let _e1171 = bitcast<u32>(_e1139[2]);
                            let _e1172 = (_e1171 & 2147483647u);
                            if (_e1172 < 8388608u) {
                                phi_1451_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1451_ = array<u32, 2>((_e1171 << bitcast<u32>(29i)), ((_e1171 ^ _e1172) | ((_e1172 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1183 = phi_1451_;
                            let _e1184 = function_12(_e1183, _e733);
                            let _e1190 = local_60[1u];
                            let _e1194 = bitcast<u32>(_e1190[0]);
                            let _e1195 = (_e1194 & 2147483647u);
                            if (_e1195 < 8388608u) {
                                phi_1485_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1485_ = array<u32, 2>((_e1194 << bitcast<u32>(29i)), ((_e1194 ^ _e1195) | ((_e1195 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1206 = phi_1485_;
                            let _e1207 = function_12(_e1206, _e733);
                            let _e1208 = bitcast<u32>(_e1190[1]);
                            let _e1209 = (_e1208 & 2147483647u);
                            if (_e1209 < 8388608u) {
                                phi_1502_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1502_ = array<u32, 2>((_e1208 << bitcast<u32>(29i)), ((_e1208 ^ _e1209) | ((_e1209 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1220 = phi_1502_;
                            let _e1221 = function_12(_e1220, _e733);
                            let _e1222 = bitcast<u32>(_e1190[2]);
                            let _e1223 = (_e1222 & 2147483647u);
                            if (_e1223 < 8388608u) {
                                phi_1519_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1519_ = array<u32, 2>((_e1222 << bitcast<u32>(29i)), ((_e1222 ^ _e1223) | ((_e1223 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1234 = phi_1519_;
                            let _e1235 = function_12(_e1234, _e733);
                            let _e1242 = local_59[2u];
                            let _e1246 = bitcast<u32>(_e1242[0]);
                            let _e1247 = (_e1246 & 2147483647u);
                            if (_e1247 < 8388608u) {
                                phi_1554_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1554_ = array<u32, 2>((_e1246 << bitcast<u32>(29i)), ((_e1246 ^ _e1247) | ((_e1247 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1258 = phi_1554_;
                            let _e1259 = function_12(_e1258, _e733);
                            let _e1260 = bitcast<u32>(_e1242[1]);
                            let _e1261 = (_e1260 & 2147483647u);
                            if (_e1261 < 8388608u) {
                                phi_1571_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1571_ = array<u32, 2>((_e1260 << bitcast<u32>(29i)), ((_e1260 ^ _e1261) | ((_e1261 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1272 = phi_1571_;
                            let _e1273 = function_12(_e1272, _e733);
                            let _e1274 = bitcast<u32>(_e1242[2]);
                            let _e1275 = (_e1274 & 2147483647u);
                            if (_e1275 < 8388608u) {
                                phi_1588_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1588_ = array<u32, 2>((_e1274 << bitcast<u32>(29i)), ((_e1274 ^ _e1275) | ((_e1275 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1286 = phi_1588_;
                            let _e1287 = function_12(_e1286, _e733);
                            let _e1293 = local_60[2u];
                            let _e1297 = bitcast<u32>(_e1293[0]);
                            let _e1298 = (_e1297 & 2147483647u);
                            if (_e1298 < 8388608u) {
                                phi_1622_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1622_ = array<u32, 2>((_e1297 << bitcast<u32>(29i)), ((_e1297 ^ _e1298) | ((_e1298 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1309 = phi_1622_;
                            let _e1310 = function_12(_e1309, _e733);
                            let _e1311 = bitcast<u32>(_e1293[1]);
                            let _e1312 = (_e1311 & 2147483647u);
                            if (_e1312 < 8388608u) {
                                phi_1639_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1639_ = array<u32, 2>((_e1311 << bitcast<u32>(29i)), ((_e1311 ^ _e1312) | ((_e1312 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1323 = phi_1639_;
                            let _e1324 = function_12(_e1323, _e733);
                            let _e1325 = bitcast<u32>(_e1293[2]);
                            let _e1326 = (_e1325 & 2147483647u);
                            if (_e1326 < 8388608u) {
                                phi_1656_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1656_ = array<u32, 2>((_e1325 << bitcast<u32>(29i)), ((_e1325 ^ _e1326) | ((_e1326 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1337 = phi_1656_;
                            let _e1338 = function_12(_e1337, _e733);
                            let _e1345 = local_59[3u];
                            let _e1349 = bitcast<u32>(_e1345[0]);
                            let _e1350 = (_e1349 & 2147483647u);
                            if (_e1350 < 8388608u) {
                                phi_1691_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1691_ = array<u32, 2>((_e1349 << bitcast<u32>(29i)), ((_e1349 ^ _e1350) | ((_e1350 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1361 = phi_1691_;
                            let _e1362 = function_12(_e1361, _e733);
                            let _e1363 = bitcast<u32>(_e1345[1]);
                            let _e1364 = (_e1363 & 2147483647u);
                            if (_e1364 < 8388608u) {
                                phi_1708_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1708_ = array<u32, 2>((_e1363 << bitcast<u32>(29i)), ((_e1363 ^ _e1364) | ((_e1364 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1375 = phi_1708_;
                            let _e1376 = function_12(_e1375, _e733);
                            let _e1377 = bitcast<u32>(_e1345[2]);
                            let _e1378 = (_e1377 & 2147483647u);
                            if (_e1378 < 8388608u) {
                                phi_1725_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1725_ = array<u32, 2>((_e1377 << bitcast<u32>(29i)), ((_e1377 ^ _e1378) | ((_e1378 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1389 = phi_1725_;
                            let _e1390 = function_12(_e1389, _e733);
                            let _e1396 = local_60[3u];
                            let _e1400 = bitcast<u32>(_e1396[0]);
                            let _e1401 = (_e1400 & 2147483647u);
                            if (_e1401 < 8388608u) {
                                phi_1759_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1759_ = array<u32, 2>((_e1400 << bitcast<u32>(29i)), ((_e1400 ^ _e1401) | ((_e1401 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1412 = phi_1759_;
                            let _e1413 = function_12(_e1412, _e733);
                            let _e1414 = bitcast<u32>(_e1396[1]);
                            let _e1415 = (_e1414 & 2147483647u);
                            if (_e1415 < 8388608u) {
                                phi_1776_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1776_ = array<u32, 2>((_e1414 << bitcast<u32>(29i)), ((_e1414 ^ _e1415) | ((_e1415 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1426 = phi_1776_;
                            let _e1427 = function_12(_e1426, _e733);
                            let _e1428 = bitcast<u32>(_e1396[2]);
                            let _e1429 = (_e1428 & 2147483647u);
                            if (_e1429 < 8388608u) {
                                phi_1793_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1793_ = array<u32, 2>((_e1428 << bitcast<u32>(29i)), ((_e1428 ^ _e1429) | ((_e1429 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1440 = phi_1793_;
                            let _e1441 = function_12(_e1440, _e733);
                            phi_2710_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e1053, _e1067, type_9(_e1081.member, _e1081.member_1)), array<type_9, 3>(_e1104, _e1118, type_9(_e1132.member, _e1132.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1156, _e1170, type_9(_e1184.member, _e1184.member_1)), array<type_9, 3>(_e1207, _e1221, type_9(_e1235.member, _e1235.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1259, _e1273, type_9(_e1287.member, _e1287.member_1)), array<type_9, 3>(_e1310, _e1324, type_9(_e1338.member, _e1338.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1362, _e1376, type_9(_e1390.member, _e1390.member_1)), array<type_9, 3>(_e1413, _e1427, type_9(_e1441.member, _e1441.member_1))));
                        } else {
                            let _e744 = params.member.member.member_10[1u];
                            local_61 = (_e733 - (bitcast<i32>((_e744 >> bitcast<u32>(20i))) - 1023i));
                            let _e751 = local_58[0u];
                            let _e754 = params.member.member.member[0u];
                            let _e756 = (6u * (_e754 + _e751));
                            let _e757 = (6u * _e751);
                            let _e758 = local_61;
                            local_57 = _e758;
                            let _e760 = positions.member[_e757];
                            let _e763 = positions.member[(_e757 + 1u)];
                            let _e765 = local_57;
                            let _e766 = function_12(array<u32, 2>(_e760, _e763), _e765);
                            let _e769 = positions.member[(_e757 + 2u)];
                            let _e772 = positions.member[(_e757 + 3u)];
                            let _e774 = local_57;
                            let _e775 = function_12(array<u32, 2>(_e769, _e772), _e774);
                            let _e778 = positions.member[(_e757 + 4u)];
                            let _e781 = positions.member[(_e757 + 5u)];
                            let _e783 = local_57;
                            let _e784 = function_12(array<u32, 2>(_e778, _e781), _e783);
                            let _e789 = local_61;
                            local_56 = _e789;
                            let _e791 = positions.member[_e756];
                            let _e794 = positions.member[(_e756 + 1u)];
                            let _e796 = local_56;
                            let _e797 = function_12(array<u32, 2>(_e791, _e794), _e796);
                            let _e800 = positions.member[(_e756 + 2u)];
                            let _e803 = positions.member[(_e756 + 3u)];
                            let _e805 = local_56;
                            let _e806 = function_12(array<u32, 2>(_e800, _e803), _e805);
                            let _e809 = positions.member[(_e756 + 4u)];
                            let _e812 = positions.member[(_e756 + 5u)];
                            let _e814 = local_56;
                            let _e815 = function_12(array<u32, 2>(_e809, _e812), _e814);
                            let _e822 = local_58[1u];
                            let _e825 = params.member.member.member[0u];
                            let _e827 = (6u * (_e825 + _e822));
                            let _e828 = (6u * _e822);
                            let _e829 = local_61;
                            local_55 = _e829;
                            let _e831 = positions.member[_e828];
                            let _e834 = positions.member[(_e828 + 1u)];
                            let _e836 = local_55;
                            let _e837 = function_12(array<u32, 2>(_e831, _e834), _e836);
                            let _e840 = positions.member[(_e828 + 2u)];
                            let _e843 = positions.member[(_e828 + 3u)];
                            let _e845 = local_55;
                            let _e846 = function_12(array<u32, 2>(_e840, _e843), _e845);
                            let _e849 = positions.member[(_e828 + 4u)];
                            let _e852 = positions.member[(_e828 + 5u)];
                            let _e854 = local_55;
                            let _e855 = function_12(array<u32, 2>(_e849, _e852), _e854);
                            let _e860 = local_61;
                            local_54 = _e860;
                            let _e862 = positions.member[_e827];
                            let _e865 = positions.member[(_e827 + 1u)];
                            let _e867 = local_54;
                            let _e868 = function_12(array<u32, 2>(_e862, _e865), _e867);
                            let _e871 = positions.member[(_e827 + 2u)];
                            let _e874 = positions.member[(_e827 + 3u)];
                            let _e876 = local_54;
                            let _e877 = function_12(array<u32, 2>(_e871, _e874), _e876);
                            let _e880 = positions.member[(_e827 + 4u)];
                            let _e883 = positions.member[(_e827 + 5u)];
                            let _e885 = local_54;
                            let _e886 = function_12(array<u32, 2>(_e880, _e883), _e885);
                            let _e893 = local_58[2u];
                            let _e896 = params.member.member.member[0u];
                            let _e898 = (6u * (_e896 + _e893));
                            let _e899 = (6u * _e893);
                            let _e900 = local_61;
                            local_53 = _e900;
                            let _e902 = positions.member[_e899];
                            let _e905 = positions.member[(_e899 + 1u)];
                            let _e907 = local_53;
                            let _e908 = function_12(array<u32, 2>(_e902, _e905), _e907);
                            let _e911 = positions.member[(_e899 + 2u)];
                            let _e914 = positions.member[(_e899 + 3u)];
                            let _e916 = local_53;
                            let _e917 = function_12(array<u32, 2>(_e911, _e914), _e916);
                            let _e920 = positions.member[(_e899 + 4u)];
                            let _e923 = positions.member[(_e899 + 5u)];
                            let _e925 = local_53;
                            let _e926 = function_12(array<u32, 2>(_e920, _e923), _e925);
                            let _e931 = local_61;
                            local_52 = _e931;
                            let _e933 = positions.member[_e898];
                            let _e936 = positions.member[(_e898 + 1u)];
                            let _e938 = local_52;
                            let _e939 = function_12(array<u32, 2>(_e933, _e936), _e938);
                            let _e942 = positions.member[(_e898 + 2u)];
                            let _e945 = positions.member[(_e898 + 3u)];
                            let _e947 = local_52;
                            let _e948 = function_12(array<u32, 2>(_e942, _e945), _e947);
                            let _e951 = positions.member[(_e898 + 4u)];
                            let _e954 = positions.member[(_e898 + 5u)];
                            let _e956 = local_52;
                            let _e957 = function_12(array<u32, 2>(_e951, _e954), _e956);
                            let _e964 = local_58[3u];
                            let _e967 = params.member.member.member[0u];
                            let _e969 = (6u * (_e967 + _e964));
                            let _e970 = (6u * _e964);
                            let _e971 = local_61;
                            local_51 = _e971;
                            let _e973 = positions.member[_e970];
                            let _e976 = positions.member[(_e970 + 1u)];
                            let _e978 = local_51;
                            let _e979 = function_12(array<u32, 2>(_e973, _e976), _e978);
                            let _e982 = positions.member[(_e970 + 2u)];
                            let _e985 = positions.member[(_e970 + 3u)];
                            let _e987 = local_51;
                            let _e988 = function_12(array<u32, 2>(_e982, _e985), _e987);
                            let _e991 = positions.member[(_e970 + 4u)];
                            let _e994 = positions.member[(_e970 + 5u)];
                            let _e996 = local_51;
                            let _e997 = function_12(array<u32, 2>(_e991, _e994), _e996);
                            let _e1002 = local_61;
                            local_50 = _e1002;
                            let _e1004 = positions.member[_e969];
                            let _e1007 = positions.member[(_e969 + 1u)];
                            let _e1009 = local_50;
                            let _e1010 = function_12(array<u32, 2>(_e1004, _e1007), _e1009);
                            let _e1013 = positions.member[(_e969 + 2u)];
                            let _e1016 = positions.member[(_e969 + 3u)];
                            let _e1018 = local_50;
                            let _e1019 = function_12(array<u32, 2>(_e1013, _e1016), _e1018);
                            let _e1022 = positions.member[(_e969 + 4u)];
                            let _e1025 = positions.member[(_e969 + 5u)];
                            let _e1027 = local_50;
                            let _e1028 = function_12(array<u32, 2>(_e1022, _e1025), _e1027);
                            phi_2710_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e766, _e775, type_9(_e784.member, _e784.member_1)), array<type_9, 3>(_e797, _e806, type_9(_e815.member, _e815.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e837, _e846, type_9(_e855.member, _e855.member_1)), array<type_9, 3>(_e868, _e877, type_9(_e886.member, _e886.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e908, _e917, type_9(_e926.member, _e926.member_1)), array<type_9, 3>(_e939, _e948, type_9(_e957.member, _e957.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e979, _e988, type_9(_e997.member, _e997.member_1)), array<type_9, 3>(_e1010, _e1019, type_9(_e1028.member, _e1028.member_1))));
                        }
                        let _e1449 = phi_2710_;
                        let _e1451 = params.member.member_2.member_1;
                        let _e1453 = params.member.member_2.member_2;
                        let _e1455 = params.member.member_2.member_3;
                        if (_e316.member != 0u) {
                            if (_e1449[2][0][0].member_1 < _e1449[0][0][0].member_1) {
                                phi_2731_ = 1u;
                            } else {
                                phi_2731_ = 0u;
                            }
                            let _e1775 = phi_2731_;
                            if (_e1449[2][0][1].member_1 < _e1449[0][0][1].member_1) {
                                phi_2743_ = 1u;
                            } else {
                                phi_2743_ = 0u;
                            }
                            let _e1789 = phi_2743_;
                            if (_e1449[2][0][2].member_1 < _e1449[0][0][2].member_1) {
                                phi_2755_ = 1u;
                            } else {
                                phi_2755_ = 0u;
                            }
                            let _e1803 = phi_2755_;
                            if (_e1449[2][1][0].member_1 < _e1449[0][1][0].member_1) {
                                phi_2775_ = 1u;
                            } else {
                                phi_2775_ = 0u;
                            }
                            let _e1825 = phi_2775_;
                            if (_e1449[2][1][1].member_1 < _e1449[0][1][1].member_1) {
                                phi_2787_ = 1u;
                            } else {
                                phi_2787_ = 0u;
                            }
                            let _e1839 = phi_2787_;
                            if (_e1449[2][1][2].member_1 < _e1449[0][1][2].member_1) {
                                phi_2799_ = 1u;
                            } else {
                                phi_2799_ = 0u;
                            }
                            let _e1853 = phi_2799_;
                            if (_e1449[1][0][0].member_1 < _e1449[0][0][0].member_1) {
                                phi_2820_ = 1u;
                            } else {
                                phi_2820_ = 0u;
                            }
                            let _e1876 = phi_2820_;
                            if (_e1449[1][0][1].member_1 < _e1449[0][0][1].member_1) {
                                phi_2832_ = 1u;
                            } else {
                                phi_2832_ = 0u;
                            }
                            let _e1890 = phi_2832_;
                            if (_e1449[1][0][2].member_1 < _e1449[0][0][2].member_1) {
                                phi_2844_ = 1u;
                            } else {
                                phi_2844_ = 0u;
                            }
                            let _e1904 = phi_2844_;
                            if (_e1449[1][1][0].member_1 < _e1449[0][1][0].member_1) {
                                phi_2864_ = 1u;
                            } else {
                                phi_2864_ = 0u;
                            }
                            let _e1926 = phi_2864_;
                            if (_e1449[1][1][1].member_1 < _e1449[0][1][1].member_1) {
                                phi_2876_ = 1u;
                            } else {
                                phi_2876_ = 0u;
                            }
                            let _e1940 = phi_2876_;
                            if (_e1449[1][1][2].member_1 < _e1449[0][1][2].member_1) {
                                phi_2888_ = 1u;
                            } else {
                                phi_2888_ = 0u;
                            }
                            let _e1954 = phi_2888_;
                            if (_e1449[2][0][0].member_1 < _e1449[3][0][0].member_1) {
                                phi_2909_ = 1u;
                            } else {
                                phi_2909_ = 0u;
                            }
                            let _e1977 = phi_2909_;
                            if (_e1449[2][0][1].member_1 < _e1449[3][0][1].member_1) {
                                phi_2921_ = 1u;
                            } else {
                                phi_2921_ = 0u;
                            }
                            let _e1991 = phi_2921_;
                            if (_e1449[2][0][2].member_1 < _e1449[3][0][2].member_1) {
                                phi_2933_ = 1u;
                            } else {
                                phi_2933_ = 0u;
                            }
                            let _e2005 = phi_2933_;
                            if (_e1449[2][1][0].member_1 < _e1449[3][1][0].member_1) {
                                phi_2953_ = 1u;
                            } else {
                                phi_2953_ = 0u;
                            }
                            let _e2027 = phi_2953_;
                            if (_e1449[2][1][1].member_1 < _e1449[3][1][1].member_1) {
                                phi_2965_ = 1u;
                            } else {
                                phi_2965_ = 0u;
                            }
                            let _e2041 = phi_2965_;
                            if (_e1449[2][1][2].member_1 < _e1449[3][1][2].member_1) {
                                phi_2977_ = 1u;
                            } else {
                                phi_2977_ = 0u;
                            }
                            let _e2055 = phi_2977_;
                            phi_3257_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1449[2][0][0].member - _e1449[0][0][0].member) - _e1775), (_e1449[2][0][0].member_1 - _e1449[0][0][0].member_1)), type_9(((_e1449[2][0][1].member - _e1449[0][0][1].member) - _e1789), (_e1449[2][0][1].member_1 - _e1449[0][0][1].member_1)), type_9(((_e1449[2][0][2].member - _e1449[0][0][2].member) - _e1803), (_e1449[2][0][2].member_1 - _e1449[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1449[2][1][0].member - _e1449[0][1][0].member) - _e1825), (_e1449[2][1][0].member_1 - _e1449[0][1][0].member_1)), type_9(((_e1449[2][1][1].member - _e1449[0][1][1].member) - _e1839), (_e1449[2][1][1].member_1 - _e1449[0][1][1].member_1)), type_9(((_e1449[2][1][2].member - _e1449[0][1][2].member) - _e1853), (_e1449[2][1][2].member_1 - _e1449[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1449[1][0][0].member - _e1449[0][0][0].member) - _e1876), (_e1449[1][0][0].member_1 - _e1449[0][0][0].member_1)), type_9(((_e1449[1][0][1].member - _e1449[0][0][1].member) - _e1890), (_e1449[1][0][1].member_1 - _e1449[0][0][1].member_1)), type_9(((_e1449[1][0][2].member - _e1449[0][0][2].member) - _e1904), (_e1449[1][0][2].member_1 - _e1449[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1449[1][1][0].member - _e1449[0][1][0].member) - _e1926), (_e1449[1][1][0].member_1 - _e1449[0][1][0].member_1)), type_9(((_e1449[1][1][1].member - _e1449[0][1][1].member) - _e1940), (_e1449[1][1][1].member_1 - _e1449[0][1][1].member_1)), type_9(((_e1449[1][1][2].member - _e1449[0][1][2].member) - _e1954), (_e1449[1][1][2].member_1 - _e1449[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1449[2][0][0].member - _e1449[3][0][0].member) - _e1977), (_e1449[2][0][0].member_1 - _e1449[3][0][0].member_1)), type_9(((_e1449[2][0][1].member - _e1449[3][0][1].member) - _e1991), (_e1449[2][0][1].member_1 - _e1449[3][0][1].member_1)), type_9(((_e1449[2][0][2].member - _e1449[3][0][2].member) - _e2005), (_e1449[2][0][2].member_1 - _e1449[3][0][2].member_1))), array<type_9, 3>(type_9(((_e1449[2][1][0].member - _e1449[3][1][0].member) - _e2027), (_e1449[2][1][0].member_1 - _e1449[3][1][0].member_1)), type_9(((_e1449[2][1][1].member - _e1449[3][1][1].member) - _e2041), (_e1449[2][1][1].member_1 - _e1449[3][1][1].member_1)), type_9(((_e1449[2][1][2].member - _e1449[3][1][2].member) - _e2055), (_e1449[2][1][2].member_1 - _e1449[3][1][2].member_1)))));
                        } else {
                            if (_e1449[0][0][0].member_1 < _e1449[1][0][0].member_1) {
                                phi_2999_ = 1u;
                            } else {
                                phi_2999_ = 0u;
                            }
                            let _e1471 = phi_2999_;
                            if (_e1449[0][0][1].member_1 < _e1449[1][0][1].member_1) {
                                phi_3011_ = 1u;
                            } else {
                                phi_3011_ = 0u;
                            }
                            let _e1485 = phi_3011_;
                            if (_e1449[0][0][2].member_1 < _e1449[1][0][2].member_1) {
                                phi_3023_ = 1u;
                            } else {
                                phi_3023_ = 0u;
                            }
                            let _e1499 = phi_3023_;
                            if (_e1449[0][1][0].member_1 < _e1449[1][1][0].member_1) {
                                phi_3043_ = 1u;
                            } else {
                                phi_3043_ = 0u;
                            }
                            let _e1521 = phi_3043_;
                            if (_e1449[0][1][1].member_1 < _e1449[1][1][1].member_1) {
                                phi_3055_ = 1u;
                            } else {
                                phi_3055_ = 0u;
                            }
                            let _e1535 = phi_3055_;
                            if (_e1449[0][1][2].member_1 < _e1449[1][1][2].member_1) {
                                phi_3067_ = 1u;
                            } else {
                                phi_3067_ = 0u;
                            }
                            let _e1549 = phi_3067_;
                            if (_e1449[2][0][0].member_1 < _e1449[1][0][0].member_1) {
                                phi_3088_ = 1u;
                            } else {
                                phi_3088_ = 0u;
                            }
                            let _e1572 = phi_3088_;
                            if (_e1449[2][0][1].member_1 < _e1449[1][0][1].member_1) {
                                phi_3100_ = 1u;
                            } else {
                                phi_3100_ = 0u;
                            }
                            let _e1586 = phi_3100_;
                            if (_e1449[2][0][2].member_1 < _e1449[1][0][2].member_1) {
                                phi_3112_ = 1u;
                            } else {
                                phi_3112_ = 0u;
                            }
                            let _e1600 = phi_3112_;
                            if (_e1449[2][1][0].member_1 < _e1449[1][1][0].member_1) {
                                phi_3132_ = 1u;
                            } else {
                                phi_3132_ = 0u;
                            }
                            let _e1622 = phi_3132_;
                            if (_e1449[2][1][1].member_1 < _e1449[1][1][1].member_1) {
                                phi_3144_ = 1u;
                            } else {
                                phi_3144_ = 0u;
                            }
                            let _e1636 = phi_3144_;
                            if (_e1449[2][1][2].member_1 < _e1449[1][1][2].member_1) {
                                phi_3156_ = 1u;
                            } else {
                                phi_3156_ = 0u;
                            }
                            let _e1650 = phi_3156_;
                            if (_e1449[3][0][0].member_1 < _e1449[1][0][0].member_1) {
                                phi_3177_ = 1u;
                            } else {
                                phi_3177_ = 0u;
                            }
                            let _e1673 = phi_3177_;
                            if (_e1449[3][0][1].member_1 < _e1449[1][0][1].member_1) {
                                phi_3189_ = 1u;
                            } else {
                                phi_3189_ = 0u;
                            }
                            let _e1687 = phi_3189_;
                            if (_e1449[3][0][2].member_1 < _e1449[1][0][2].member_1) {
                                phi_3201_ = 1u;
                            } else {
                                phi_3201_ = 0u;
                            }
                            let _e1701 = phi_3201_;
                            if (_e1449[3][1][0].member_1 < _e1449[1][1][0].member_1) {
                                phi_3221_ = 1u;
                            } else {
                                phi_3221_ = 0u;
                            }
                            let _e1723 = phi_3221_;
                            if (_e1449[3][1][1].member_1 < _e1449[1][1][1].member_1) {
                                phi_3233_ = 1u;
                            } else {
                                phi_3233_ = 0u;
                            }
                            let _e1737 = phi_3233_;
                            if (_e1449[3][1][2].member_1 < _e1449[1][1][2].member_1) {
                                phi_3245_ = 1u;
                            } else {
                                phi_3245_ = 0u;
                            }
                            let _e1751 = phi_3245_;
                            phi_3257_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1449[0][0][0].member - _e1449[1][0][0].member) - _e1471), (_e1449[0][0][0].member_1 - _e1449[1][0][0].member_1)), type_9(((_e1449[0][0][1].member - _e1449[1][0][1].member) - _e1485), (_e1449[0][0][1].member_1 - _e1449[1][0][1].member_1)), type_9(((_e1449[0][0][2].member - _e1449[1][0][2].member) - _e1499), (_e1449[0][0][2].member_1 - _e1449[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1449[0][1][0].member - _e1449[1][1][0].member) - _e1521), (_e1449[0][1][0].member_1 - _e1449[1][1][0].member_1)), type_9(((_e1449[0][1][1].member - _e1449[1][1][1].member) - _e1535), (_e1449[0][1][1].member_1 - _e1449[1][1][1].member_1)), type_9(((_e1449[0][1][2].member - _e1449[1][1][2].member) - _e1549), (_e1449[0][1][2].member_1 - _e1449[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1449[2][0][0].member - _e1449[1][0][0].member) - _e1572), (_e1449[2][0][0].member_1 - _e1449[1][0][0].member_1)), type_9(((_e1449[2][0][1].member - _e1449[1][0][1].member) - _e1586), (_e1449[2][0][1].member_1 - _e1449[1][0][1].member_1)), type_9(((_e1449[2][0][2].member - _e1449[1][0][2].member) - _e1600), (_e1449[2][0][2].member_1 - _e1449[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1449[2][1][0].member - _e1449[1][1][0].member) - _e1622), (_e1449[2][1][0].member_1 - _e1449[1][1][0].member_1)), type_9(((_e1449[2][1][1].member - _e1449[1][1][1].member) - _e1636), (_e1449[2][1][1].member_1 - _e1449[1][1][1].member_1)), type_9(((_e1449[2][1][2].member - _e1449[1][1][2].member) - _e1650), (_e1449[2][1][2].member_1 - _e1449[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1449[3][0][0].member - _e1449[1][0][0].member) - _e1673), (_e1449[3][0][0].member_1 - _e1449[1][0][0].member_1)), type_9(((_e1449[3][0][1].member - _e1449[1][0][1].member) - _e1687), (_e1449[3][0][1].member_1 - _e1449[1][0][1].member_1)), type_9(((_e1449[3][0][2].member - _e1449[1][0][2].member) - _e1701), (_e1449[3][0][2].member_1 - _e1449[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1449[3][1][0].member - _e1449[1][1][0].member) - _e1723), (_e1449[3][1][0].member_1 - _e1449[1][1][0].member_1)), type_9(((_e1449[3][1][1].member - _e1449[1][1][1].member) - _e1737), (_e1449[3][1][1].member_1 - _e1449[1][1][1].member_1)), type_9(((_e1449[3][1][2].member - _e1449[1][1][2].member) - _e1751), (_e1449[3][1][2].member_1 - _e1449[1][1][2].member_1)))));
                        }
                        let _e2066 = phi_3257_;
                        local_48 = array<type_9, 3>(type_9(_e2066[1][0][0].member, _e2066[1][0][0].member_1), type_9(_e2066[1][0][1].member, _e2066[1][0][1].member_1), type_9(_e2066[1][0][2].member, _e2066[1][0][2].member_1));
                        local_49 = array<type_9, 3>(type_9(_e2066[2][0][0].member, _e2066[2][0][0].member_1), type_9(_e2066[2][0][1].member, _e2066[2][0][1].member_1), type_9(_e2066[2][0][2].member, _e2066[2][0][2].member_1));
                        let _e2099 = local_48[1u].member;
                        let _e2101 = local_48[1u].member_1;
                        let _e2104 = local_49[2u].member;
                        let _e2106 = local_49[2u].member_1;
                        let _e2107 = function_8(_e2099, _e2101, _e2104, _e2106);
                        let _e2112 = local_48[2u].member;
                        let _e2114 = local_48[2u].member_1;
                        let _e2117 = local_49[1u].member;
                        let _e2119 = local_49[1u].member_1;
                        let _e2120 = function_8(_e2112, _e2114, _e2117, _e2119);
                        if (_e2107.member_1 < _e2120.member_1) {
                            phi_3336_ = 1u;
                        } else {
                            phi_3336_ = 0u;
                        }
                        let _e2125 = phi_3336_;
                        let _e2127 = ((_e2107.member - _e2120.member) - _e2125);
                        let _e2128 = (_e2107.member_1 - _e2120.member_1);
                        local_46 = array<type_9, 3>(type_9(_e2066[1][0][0].member, _e2066[1][0][0].member_1), type_9(_e2066[1][0][1].member, _e2066[1][0][1].member_1), type_9(_e2066[1][0][2].member, _e2066[1][0][2].member_1));
                        local_47 = array<type_9, 3>(type_9(_e2066[2][0][0].member, _e2066[2][0][0].member_1), type_9(_e2066[2][0][1].member, _e2066[2][0][1].member_1), type_9(_e2066[2][0][2].member, _e2066[2][0][2].member_1));
                        let _e2157 = local_46[2u].member;
                        let _e2159 = local_46[2u].member_1;
                        let _e2162 = local_47[0u].member;
                        let _e2164 = local_47[0u].member_1;
                        let _e2165 = function_8(_e2157, _e2159, _e2162, _e2164);
                        let _e2170 = local_46[0u].member;
                        let _e2172 = local_46[0u].member_1;
                        let _e2175 = local_47[2u].member;
                        let _e2177 = local_47[2u].member_1;
                        let _e2178 = function_8(_e2170, _e2172, _e2175, _e2177);
                        if (_e2165.member_1 < _e2178.member_1) {
                            phi_3416_ = 1u;
                        } else {
                            phi_3416_ = 0u;
                        }
                        let _e2183 = phi_3416_;
                        let _e2185 = ((_e2165.member - _e2178.member) - _e2183);
                        let _e2186 = (_e2165.member_1 - _e2178.member_1);
                        local_44 = array<type_9, 3>(type_9(_e2066[1][0][0].member, _e2066[1][0][0].member_1), type_9(_e2066[1][0][1].member, _e2066[1][0][1].member_1), type_9(_e2066[1][0][2].member, _e2066[1][0][2].member_1));
                        local_45 = array<type_9, 3>(type_9(_e2066[2][0][0].member, _e2066[2][0][0].member_1), type_9(_e2066[2][0][1].member, _e2066[2][0][1].member_1), type_9(_e2066[2][0][2].member, _e2066[2][0][2].member_1));
                        let _e2215 = local_44[0u].member;
                        let _e2217 = local_44[0u].member_1;
                        let _e2220 = local_45[1u].member;
                        let _e2222 = local_45[1u].member_1;
                        let _e2223 = function_8(_e2215, _e2217, _e2220, _e2222);
                        let _e2228 = local_44[1u].member;
                        let _e2230 = local_44[1u].member_1;
                        let _e2233 = local_45[0u].member;
                        let _e2235 = local_45[0u].member_1;
                        let _e2236 = function_8(_e2228, _e2230, _e2233, _e2235);
                        if (_e2223.member_1 < _e2236.member_1) {
                            phi_3496_ = 1u;
                        } else {
                            phi_3496_ = 0u;
                        }
                        let _e2241 = phi_3496_;
                        let _e2243 = ((_e2223.member - _e2236.member) - _e2241);
                        let _e2244 = (_e2223.member_1 - _e2236.member_1);
                        local_42 = array<type_9, 3>(type_9(_e2066[1][1][0].member, _e2066[1][1][0].member_1), type_9(_e2066[1][1][1].member, _e2066[1][1][1].member_1), type_9(_e2066[1][1][2].member, _e2066[1][1][2].member_1));
                        local_43 = array<type_9, 3>(type_9(_e2066[2][1][0].member, _e2066[2][1][0].member_1), type_9(_e2066[2][1][1].member, _e2066[2][1][1].member_1), type_9(_e2066[2][1][2].member, _e2066[2][1][2].member_1));
                        let _e2277 = local_42[1u].member;
                        let _e2279 = local_42[1u].member_1;
                        let _e2282 = local_43[2u].member;
                        let _e2284 = local_43[2u].member_1;
                        let _e2285 = function_8(_e2277, _e2279, _e2282, _e2284);
                        let _e2290 = local_42[2u].member;
                        let _e2292 = local_42[2u].member_1;
                        let _e2295 = local_43[1u].member;
                        let _e2297 = local_43[1u].member_1;
                        let _e2298 = function_8(_e2290, _e2292, _e2295, _e2297);
                        if (_e2285.member_1 < _e2298.member_1) {
                            phi_3584_ = 1u;
                        } else {
                            phi_3584_ = 0u;
                        }
                        let _e2303 = phi_3584_;
                        let _e2305 = ((_e2285.member - _e2298.member) - _e2303);
                        let _e2306 = (_e2285.member_1 - _e2298.member_1);
                        local_40 = array<type_9, 3>(type_9(_e2066[1][1][0].member, _e2066[1][1][0].member_1), type_9(_e2066[1][1][1].member, _e2066[1][1][1].member_1), type_9(_e2066[1][1][2].member, _e2066[1][1][2].member_1));
                        local_41 = array<type_9, 3>(type_9(_e2066[2][1][0].member, _e2066[2][1][0].member_1), type_9(_e2066[2][1][1].member, _e2066[2][1][1].member_1), type_9(_e2066[2][1][2].member, _e2066[2][1][2].member_1));
                        let _e2335 = local_40[2u].member;
                        let _e2337 = local_40[2u].member_1;
                        let _e2340 = local_41[0u].member;
                        let _e2342 = local_41[0u].member_1;
                        let _e2343 = function_8(_e2335, _e2337, _e2340, _e2342);
                        let _e2348 = local_40[0u].member;
                        let _e2350 = local_40[0u].member_1;
                        let _e2353 = local_41[2u].member;
                        let _e2355 = local_41[2u].member_1;
                        let _e2356 = function_8(_e2348, _e2350, _e2353, _e2355);
                        if (_e2343.member_1 < _e2356.member_1) {
                            phi_3664_ = 1u;
                        } else {
                            phi_3664_ = 0u;
                        }
                        let _e2361 = phi_3664_;
                        let _e2363 = ((_e2343.member - _e2356.member) - _e2361);
                        let _e2364 = (_e2343.member_1 - _e2356.member_1);
                        local_38 = array<type_9, 3>(type_9(_e2066[1][1][0].member, _e2066[1][1][0].member_1), type_9(_e2066[1][1][1].member, _e2066[1][1][1].member_1), type_9(_e2066[1][1][2].member, _e2066[1][1][2].member_1));
                        local_39 = array<type_9, 3>(type_9(_e2066[2][1][0].member, _e2066[2][1][0].member_1), type_9(_e2066[2][1][1].member, _e2066[2][1][1].member_1), type_9(_e2066[2][1][2].member, _e2066[2][1][2].member_1));
                        let _e2393 = local_38[0u].member;
                        let _e2395 = local_38[0u].member_1;
                        let _e2398 = local_39[1u].member;
                        let _e2400 = local_39[1u].member_1;
                        let _e2401 = function_8(_e2393, _e2395, _e2398, _e2400);
                        let _e2406 = local_38[1u].member;
                        let _e2408 = local_38[1u].member_1;
                        let _e2411 = local_39[0u].member;
                        let _e2413 = local_39[0u].member_1;
                        let _e2414 = function_8(_e2406, _e2408, _e2411, _e2413);
                        if (_e2401.member_1 < _e2414.member_1) {
                            phi_3744_ = 1u;
                        } else {
                            phi_3744_ = 0u;
                        }
                        let _e2419 = phi_3744_;
                        let _e2421 = ((_e2401.member - _e2414.member) - _e2419);
                        let _e2422 = (_e2401.member_1 - _e2414.member_1);
                        local_36 = array<type_9, 3>(type_9(_e2066[1][0][0].member, _e2066[1][0][0].member_1), type_9(_e2066[1][0][1].member, _e2066[1][0][1].member_1), type_9(_e2066[1][0][2].member, _e2066[1][0][2].member_1));
                        local_37 = array<type_9, 3>(type_9(_e2066[2][1][0].member, _e2066[2][1][0].member_1), type_9(_e2066[2][1][1].member, _e2066[2][1][1].member_1), type_9(_e2066[2][1][2].member, _e2066[2][1][2].member_1));
                        let _e2455 = local_36[1u].member;
                        let _e2457 = local_36[1u].member_1;
                        let _e2460 = local_37[2u].member;
                        let _e2462 = local_37[2u].member_1;
                        let _e2463 = function_8(_e2455, _e2457, _e2460, _e2462);
                        let _e2468 = local_36[2u].member;
                        let _e2470 = local_36[2u].member_1;
                        let _e2473 = local_37[1u].member;
                        let _e2475 = local_37[1u].member_1;
                        let _e2476 = function_8(_e2468, _e2470, _e2473, _e2475);
                        if (_e2463.member_1 < _e2476.member_1) {
                            phi_3832_ = 1u;
                        } else {
                            phi_3832_ = 0u;
                        }
                        let _e2481 = phi_3832_;
                        let _e2484 = (_e2463.member_1 - _e2476.member_1);
                        local_34 = array<type_9, 3>(type_9(_e2066[1][0][0].member, _e2066[1][0][0].member_1), type_9(_e2066[1][0][1].member, _e2066[1][0][1].member_1), type_9(_e2066[1][0][2].member, _e2066[1][0][2].member_1));
                        local_35 = array<type_9, 3>(type_9(_e2066[2][1][0].member, _e2066[2][1][0].member_1), type_9(_e2066[2][1][1].member, _e2066[2][1][1].member_1), type_9(_e2066[2][1][2].member, _e2066[2][1][2].member_1));
                        let _e2513 = local_34[2u].member;
                        let _e2515 = local_34[2u].member_1;
                        let _e2518 = local_35[0u].member;
                        let _e2520 = local_35[0u].member_1;
                        let _e2521 = function_8(_e2513, _e2515, _e2518, _e2520);
                        let _e2526 = local_34[0u].member;
                        let _e2528 = local_34[0u].member_1;
                        let _e2531 = local_35[2u].member;
                        let _e2533 = local_35[2u].member_1;
                        let _e2534 = function_8(_e2526, _e2528, _e2531, _e2533);
                        if (_e2521.member_1 < _e2534.member_1) {
                            phi_3912_ = 1u;
                        } else {
                            phi_3912_ = 0u;
                        }
                        let _e2539 = phi_3912_;
                        let _e2542 = (_e2521.member_1 - _e2534.member_1);
                        local_32 = array<type_9, 3>(type_9(_e2066[1][0][0].member, _e2066[1][0][0].member_1), type_9(_e2066[1][0][1].member, _e2066[1][0][1].member_1), type_9(_e2066[1][0][2].member, _e2066[1][0][2].member_1));
                        local_33 = array<type_9, 3>(type_9(_e2066[2][1][0].member, _e2066[2][1][0].member_1), type_9(_e2066[2][1][1].member, _e2066[2][1][1].member_1), type_9(_e2066[2][1][2].member, _e2066[2][1][2].member_1));
                        let _e2571 = local_32[0u].member;
                        let _e2573 = local_32[0u].member_1;
                        let _e2576 = local_33[1u].member;
                        let _e2578 = local_33[1u].member_1;
                        let _e2579 = function_8(_e2571, _e2573, _e2576, _e2578);
                        let _e2584 = local_32[1u].member;
                        let _e2586 = local_32[1u].member_1;
                        let _e2589 = local_33[0u].member;
                        let _e2591 = local_33[0u].member_1;
                        let _e2592 = function_8(_e2584, _e2586, _e2589, _e2591);
                        if (_e2579.member_1 < _e2592.member_1) {
                            phi_3992_ = 1u;
                        } else {
                            phi_3992_ = 0u;
                        }
                        let _e2597 = phi_3992_;
                        let _e2600 = (_e2579.member_1 - _e2592.member_1);
                        local_30 = array<type_9, 3>(type_9(_e2066[1][1][0].member, _e2066[1][1][0].member_1), type_9(_e2066[1][1][1].member, _e2066[1][1][1].member_1), type_9(_e2066[1][1][2].member, _e2066[1][1][2].member_1));
                        local_31 = array<type_9, 3>(type_9(_e2066[2][0][0].member, _e2066[2][0][0].member_1), type_9(_e2066[2][0][1].member, _e2066[2][0][1].member_1), type_9(_e2066[2][0][2].member, _e2066[2][0][2].member_1));
                        let _e2633 = local_30[1u].member;
                        let _e2635 = local_30[1u].member_1;
                        let _e2638 = local_31[2u].member;
                        let _e2640 = local_31[2u].member_1;
                        let _e2641 = function_8(_e2633, _e2635, _e2638, _e2640);
                        let _e2646 = local_30[2u].member;
                        let _e2648 = local_30[2u].member_1;
                        let _e2651 = local_31[1u].member;
                        let _e2653 = local_31[1u].member_1;
                        let _e2654 = function_8(_e2646, _e2648, _e2651, _e2653);
                        if (_e2641.member_1 < _e2654.member_1) {
                            phi_4080_ = 1u;
                        } else {
                            phi_4080_ = 0u;
                        }
                        let _e2659 = phi_4080_;
                        local_28 = array<type_9, 3>(type_9(_e2066[1][1][0].member, _e2066[1][1][0].member_1), type_9(_e2066[1][1][1].member, _e2066[1][1][1].member_1), type_9(_e2066[1][1][2].member, _e2066[1][1][2].member_1));
                        local_29 = array<type_9, 3>(type_9(_e2066[2][0][0].member, _e2066[2][0][0].member_1), type_9(_e2066[2][0][1].member, _e2066[2][0][1].member_1), type_9(_e2066[2][0][2].member, _e2066[2][0][2].member_1));
                        let _e2691 = local_28[2u].member;
                        let _e2693 = local_28[2u].member_1;
                        let _e2696 = local_29[0u].member;
                        let _e2698 = local_29[0u].member_1;
                        let _e2699 = function_8(_e2691, _e2693, _e2696, _e2698);
                        let _e2704 = local_28[0u].member;
                        let _e2706 = local_28[0u].member_1;
                        let _e2709 = local_29[2u].member;
                        let _e2711 = local_29[2u].member_1;
                        let _e2712 = function_8(_e2704, _e2706, _e2709, _e2711);
                        if (_e2699.member_1 < _e2712.member_1) {
                            phi_4160_ = 1u;
                        } else {
                            phi_4160_ = 0u;
                        }
                        let _e2717 = phi_4160_;
                        local_26 = array<type_9, 3>(type_9(_e2066[1][1][0].member, _e2066[1][1][0].member_1), type_9(_e2066[1][1][1].member, _e2066[1][1][1].member_1), type_9(_e2066[1][1][2].member, _e2066[1][1][2].member_1));
                        local_27 = array<type_9, 3>(type_9(_e2066[2][0][0].member, _e2066[2][0][0].member_1), type_9(_e2066[2][0][1].member, _e2066[2][0][1].member_1), type_9(_e2066[2][0][2].member, _e2066[2][0][2].member_1));
                        let _e2749 = local_26[0u].member;
                        let _e2751 = local_26[0u].member_1;
                        let _e2754 = local_27[1u].member;
                        let _e2756 = local_27[1u].member_1;
                        let _e2757 = function_8(_e2749, _e2751, _e2754, _e2756);
                        let _e2762 = local_26[1u].member;
                        let _e2764 = local_26[1u].member_1;
                        let _e2767 = local_27[0u].member;
                        let _e2769 = local_27[0u].member_1;
                        let _e2770 = function_8(_e2762, _e2764, _e2767, _e2769);
                        if (_e2757.member_1 < _e2770.member_1) {
                            phi_4240_ = 1u;
                        } else {
                            phi_4240_ = 0u;
                        }
                        let _e2775 = phi_4240_;
                        let _e2779 = (_e2484 + (_e2641.member_1 - _e2654.member_1));
                        if (_e2779 < _e2484) {
                            phi_4259_ = 1u;
                        } else {
                            phi_4259_ = 0u;
                        }
                        let _e2782 = phi_4259_;
                        let _e2784 = ((((_e2463.member - _e2476.member) - _e2481) + ((_e2641.member - _e2654.member) - _e2659)) + _e2782);
                        let _e2785 = (_e2542 + (_e2699.member_1 - _e2712.member_1));
                        if (_e2785 < _e2542) {
                            phi_4271_ = 1u;
                        } else {
                            phi_4271_ = 0u;
                        }
                        let _e2788 = phi_4271_;
                        let _e2790 = ((((_e2521.member - _e2534.member) - _e2539) + ((_e2699.member - _e2712.member) - _e2717)) + _e2788);
                        let _e2791 = (_e2600 + (_e2757.member_1 - _e2770.member_1));
                        if (_e2791 < _e2600) {
                            phi_4283_ = 1u;
                        } else {
                            phi_4283_ = 0u;
                        }
                        let _e2794 = phi_4283_;
                        let _e2796 = ((((_e2579.member - _e2592.member) - _e2597) + ((_e2757.member - _e2770.member) - _e2775)) + _e2794);
                        let _e2803 = function_8(_e2066[0][0][0].member, _e2066[0][0][0].member_1, _e2127, _e2128);
                        let _e2810 = function_8(_e2066[0][0][1].member, _e2066[0][0][1].member_1, _e2185, _e2186);
                        let _e2813 = (_e2803.member_1 + _e2810.member_1);
                        if (_e2813 < _e2803.member_1) {
                            phi_4312_ = 1u;
                        } else {
                            phi_4312_ = 0u;
                        }
                        let _e2816 = phi_4312_;
                        let _e2823 = function_8(_e2066[0][0][2].member, _e2066[0][0][2].member_1, _e2243, _e2244);
                        let _e2826 = (_e2813 + _e2823.member_1);
                        if (_e2826 < _e2813) {
                            phi_4327_ = 1u;
                        } else {
                            phi_4327_ = 0u;
                        }
                        let _e2829 = phi_4327_;
                        let _e2832 = function_11(((((_e2803.member + _e2810.member) + _e2816) + _e2823.member) + _e2829), _e2826);
                        let _e2841 = function_8(_e2066[0][1][0].member, _e2066[0][1][0].member_1, _e2127, _e2128);
                        let _e2848 = function_8(_e2066[0][1][1].member, _e2066[0][1][1].member_1, _e2185, _e2186);
                        let _e2851 = (_e2841.member_1 + _e2848.member_1);
                        if (_e2851 < _e2841.member_1) {
                            phi_4353_ = 1u;
                        } else {
                            phi_4353_ = 0u;
                        }
                        let _e2854 = phi_4353_;
                        let _e2861 = function_8(_e2066[0][1][2].member, _e2066[0][1][2].member_1, _e2243, _e2244);
                        let _e2864 = (_e2851 + _e2861.member_1);
                        if (_e2864 < _e2851) {
                            phi_4368_ = 1u;
                        } else {
                            phi_4368_ = 0u;
                        }
                        let _e2867 = phi_4368_;
                        let _e2876 = function_8(_e2066[0][0][0].member, _e2066[0][0][0].member_1, _e2784, _e2779);
                        let _e2883 = function_8(_e2066[0][0][1].member, _e2066[0][0][1].member_1, _e2790, _e2785);
                        let _e2886 = (_e2876.member_1 + _e2883.member_1);
                        if (_e2886 < _e2876.member_1) {
                            phi_4391_ = 1u;
                        } else {
                            phi_4391_ = 0u;
                        }
                        let _e2889 = phi_4391_;
                        let _e2896 = function_8(_e2066[0][0][2].member, _e2066[0][0][2].member_1, _e2796, _e2791);
                        let _e2899 = (_e2886 + _e2896.member_1);
                        if (_e2899 < _e2886) {
                            phi_4406_ = 1u;
                        } else {
                            phi_4406_ = 0u;
                        }
                        let _e2902 = phi_4406_;
                        let _e2905 = (_e2864 + _e2899);
                        if (_e2905 < _e2864) {
                            phi_4414_ = 1u;
                        } else {
                            phi_4414_ = 0u;
                        }
                        let _e2908 = phi_4414_;
                        let _e2910 = ((((((_e2841.member + _e2848.member) + _e2854) + _e2861.member) + _e2867) + ((((_e2876.member + _e2883.member) + _e2889) + _e2896.member) + _e2902)) + _e2908);
                        let _e2917 = function_8(_e2066[0][0][0].member, _e2066[0][0][0].member_1, _e2305, _e2306);
                        let _e2924 = function_8(_e2066[0][0][1].member, _e2066[0][0][1].member_1, _e2363, _e2364);
                        let _e2927 = (_e2917.member_1 + _e2924.member_1);
                        if (_e2927 < _e2917.member_1) {
                            phi_4437_ = 1u;
                        } else {
                            phi_4437_ = 0u;
                        }
                        let _e2930 = phi_4437_;
                        let _e2937 = function_8(_e2066[0][0][2].member, _e2066[0][0][2].member_1, _e2421, _e2422);
                        let _e2940 = (_e2927 + _e2937.member_1);
                        if (_e2940 < _e2927) {
                            phi_4452_ = 1u;
                        } else {
                            phi_4452_ = 0u;
                        }
                        let _e2943 = phi_4452_;
                        let _e2952 = function_8(_e2066[0][1][0].member, _e2066[0][1][0].member_1, _e2784, _e2779);
                        let _e2959 = function_8(_e2066[0][1][1].member, _e2066[0][1][1].member_1, _e2790, _e2785);
                        let _e2962 = (_e2952.member_1 + _e2959.member_1);
                        if (_e2962 < _e2952.member_1) {
                            phi_4475_ = 1u;
                        } else {
                            phi_4475_ = 0u;
                        }
                        let _e2965 = phi_4475_;
                        let _e2972 = function_8(_e2066[0][1][2].member, _e2066[0][1][2].member_1, _e2796, _e2791);
                        let _e2975 = (_e2962 + _e2972.member_1);
                        if (_e2975 < _e2962) {
                            phi_4490_ = 1u;
                        } else {
                            phi_4490_ = 0u;
                        }
                        let _e2978 = phi_4490_;
                        let _e2981 = (_e2940 + _e2975);
                        if (_e2981 < _e2940) {
                            phi_4498_ = 1u;
                        } else {
                            phi_4498_ = 0u;
                        }
                        let _e2984 = phi_4498_;
                        let _e2986 = ((((((_e2917.member + _e2924.member) + _e2930) + _e2937.member) + _e2943) + ((((_e2952.member + _e2959.member) + _e2965) + _e2972.member) + _e2978)) + _e2984);
                        let _e2993 = function_8(_e2066[0][1][0].member, _e2066[0][1][0].member_1, _e2305, _e2306);
                        let _e3000 = function_8(_e2066[0][1][1].member, _e2066[0][1][1].member_1, _e2363, _e2364);
                        let _e3003 = (_e2993.member_1 + _e3000.member_1);
                        if (_e3003 < _e2993.member_1) {
                            phi_4521_ = 1u;
                        } else {
                            phi_4521_ = 0u;
                        }
                        let _e3006 = phi_4521_;
                        let _e3013 = function_8(_e2066[0][1][2].member, _e2066[0][1][2].member_1, _e2421, _e2422);
                        let _e3016 = (_e3003 + _e3013.member_1);
                        if (_e3016 < _e3003) {
                            phi_4536_ = 1u;
                        } else {
                            phi_4536_ = 0u;
                        }
                        let _e3019 = phi_4536_;
                        let _e3022 = function_11(((((_e2993.member + _e3000.member) + _e3006) + _e3013.member) + _e3019), _e3016);
                        phi_4552_ = type_9(0u, 128u);
                        phi_4555_ = array<type_9, 4>(_e2832, type_9(_e2910, _e2905), type_9(_e2986, _e2981), type_9(_e3022.member, _e3022.member_1));
                        phi_4559_ = 0u;
                        phi_4561_ = 0u;
                        loop {
                            let _e3030 = phi_4552_;
                            let _e3032 = phi_4555_;
                            let _e3034 = phi_4559_;
                            let _e3036 = phi_4561_;
                            local_65 = _e3032;
                            local_66 = _e3032;
                            local_67 = _e3032;
                            if (_e3030.member < _e3030.member_1) {
                                phi_4553_ = type_9((_e3030.member + 1u), _e3030.member_1);
                                phi_4584_ = type_9(1u, _e3030.member);
                            } else {
                                phi_4553_ = _e3030;
                                phi_4584_ = type_9(0u, type_9().member_1);
                            }
                            let _e3048 = phi_4553_;
                            let _e3050 = phi_4584_;
                            if (bitcast<i32>(_e3050.member) != 0i) {
                                let _e3054 = (31u - _e3034);
                                let _e3057 = (_e3036 << bitcast<u32>((_e3054 & 31u)));
                                let _e3062 = (_e3057 > _e1453);
                                if _e3062 {
                                    phi_7269_ = array<type_9, 4>();
                                    phi_7271_ = u32();
                                    phi_7272_ = u32();
                                    phi_7273_ = bool();
                                    phi_7274_ = bool();
                                    phi_7275_ = u32();
                                    phi_7276_ = u32();
                                    phi_7277_ = false;
                                    phi_7278_ = false;
                                    phi_7279_ = false;
                                } else {
                                    if (((_e3036 + 1u) << bitcast<u32>((_e3054 & 31u))) < _e1451) {
                                        phi_4781_ = true;
                                    } else {
                                        let _e3068 = function_10(128u);
                                        if ((_e3032[0].member >> bitcast<u32>(31i)) != 0u) {
                                            if (_e3032[0].member_1 == 0u) {
                                                phi_4619_ = 1u;
                                            } else {
                                                phi_4619_ = 0u;
                                            }
                                            let _e3077 = phi_4619_;
                                            phi_4626_ = type_9((~(_e3032[0].member) + _e3077), (~(_e3032[0].member_1) + 1u));
                                        } else {
                                            phi_4626_ = _e3032[0];
                                        }
                                        let _e3084 = phi_4626_;
                                        if (_e3068.member_1 < _e3084.member_1) {
                                            phi_4633_ = 1u;
                                        } else {
                                            phi_4633_ = 0u;
                                        }
                                        let _e3089 = phi_4633_;
                                        if ((((_e3068.member - _e3084.member) - _e3089) >> bitcast<u32>(31i)) != 0u) {
                                            if ((_e3032[0].member >> bitcast<u32>(31i)) != 0u) {
                                                phi_4646_ = 2u;
                                            } else {
                                                phi_4646_ = 1u;
                                            }
                                            let _e3099 = phi_4646_;
                                            phi_4647_ = _e3099;
                                        } else {
                                            phi_4647_ = 0u;
                                        }
                                        let _e3101 = phi_4647_;
                                        let _e3106 = function_10(128u);
                                        if ((_e3032[1].member >> bitcast<u32>(31i)) != 0u) {
                                            if (_e3032[1].member_1 == 0u) {
                                                phi_4662_ = 1u;
                                            } else {
                                                phi_4662_ = 0u;
                                            }
                                            let _e3115 = phi_4662_;
                                            phi_4669_ = type_9((~(_e3032[1].member) + _e3115), (~(_e3032[1].member_1) + 1u));
                                        } else {
                                            phi_4669_ = _e3032[1];
                                        }
                                        let _e3122 = phi_4669_;
                                        if (_e3106.member_1 < _e3122.member_1) {
                                            phi_4676_ = 1u;
                                        } else {
                                            phi_4676_ = 0u;
                                        }
                                        let _e3127 = phi_4676_;
                                        if ((((_e3106.member - _e3122.member) - _e3127) >> bitcast<u32>(31i)) != 0u) {
                                            if ((_e3032[1].member >> bitcast<u32>(31i)) != 0u) {
                                                phi_4689_ = 2u;
                                            } else {
                                                phi_4689_ = 1u;
                                            }
                                            let _e3137 = phi_4689_;
                                            phi_4690_ = _e3137;
                                        } else {
                                            phi_4690_ = 0u;
                                        }
                                        let _e3139 = phi_4690_;
                                        let _e3145 = function_10(128u);
                                        if ((_e3032[2].member >> bitcast<u32>(31i)) != 0u) {
                                            if (_e3032[2].member_1 == 0u) {
                                                phi_4706_ = 1u;
                                            } else {
                                                phi_4706_ = 0u;
                                            }
                                            let _e3154 = phi_4706_;
                                            phi_4713_ = type_9((~(_e3032[2].member) + _e3154), (~(_e3032[2].member_1) + 1u));
                                        } else {
                                            phi_4713_ = _e3032[2];
                                        }
                                        let _e3161 = phi_4713_;
                                        if (_e3145.member_1 < _e3161.member_1) {
                                            phi_4720_ = 1u;
                                        } else {
                                            phi_4720_ = 0u;
                                        }
                                        let _e3166 = phi_4720_;
                                        if ((((_e3145.member - _e3161.member) - _e3166) >> bitcast<u32>(31i)) != 0u) {
                                            if ((_e3032[2].member >> bitcast<u32>(31i)) != 0u) {
                                                phi_4733_ = 2u;
                                            } else {
                                                phi_4733_ = 1u;
                                            }
                                            let _e3176 = phi_4733_;
                                            phi_4734_ = _e3176;
                                        } else {
                                            phi_4734_ = 0u;
                                        }
                                        let _e3178 = phi_4734_;
                                        let _e3184 = function_10(128u);
                                        if ((_e3032[3].member >> bitcast<u32>(31i)) != 0u) {
                                            if (_e3032[3].member_1 == 0u) {
                                                phi_4750_ = 1u;
                                            } else {
                                                phi_4750_ = 0u;
                                            }
                                            let _e3193 = phi_4750_;
                                            phi_4757_ = type_9((~(_e3032[3].member) + _e3193), (~(_e3032[3].member_1) + 1u));
                                        } else {
                                            phi_4757_ = _e3032[3];
                                        }
                                        let _e3200 = phi_4757_;
                                        if (_e3184.member_1 < _e3200.member_1) {
                                            phi_4764_ = 1u;
                                        } else {
                                            phi_4764_ = 0u;
                                        }
                                        let _e3205 = phi_4764_;
                                        if ((((_e3184.member - _e3200.member) - _e3205) >> bitcast<u32>(31i)) != 0u) {
                                            if ((_e3032[3].member >> bitcast<u32>(31i)) != 0u) {
                                                phi_4777_ = 2u;
                                            } else {
                                                phi_4777_ = 1u;
                                            }
                                            let _e3215 = phi_4777_;
                                            phi_4778_ = _e3215;
                                        } else {
                                            phi_4778_ = 0u;
                                        }
                                        let _e3217 = phi_4778_;
                                        phi_4781_ = ((((_e3101 & _e3139) & _e3178) & _e3217) != 0u);
                                    }
                                    let _e3221 = phi_4781_;
                                    if _e3221 {
                                        phi_6950_ = _e3032;
                                        phi_6952_ = _e3221;
                                        phi_6953_ = _e3034;
                                        phi_6954_ = _e3036;
                                        phi_6955_ = bool();
                                        phi_6956_ = bool();
                                        phi_6957_ = u32();
                                        phi_6958_ = u32();
                                        phi_6959_ = true;
                                    } else {
                                        let _e3222 = (_e3034 == 31u);
                                        if _e3222 {
                                            phi_4806_ = true;
                                        } else {
                                            if (_e3034 == 3u) {
                                                phi_4805_ = true;
                                            } else {
                                                if (_e3034 == 8u) {
                                                    phi_4804_ = true;
                                                } else {
                                                    phi_4804_ = (_e3034 == 14u);
                                                }
                                                let _e3227 = phi_4804_;
                                                phi_4805_ = _e3227;
                                            }
                                            let _e3229 = phi_4805_;
                                            phi_4806_ = _e3229;
                                        }
                                        let _e3231 = phi_4806_;
                                        if _e3231 {
                                            let _e3236 = function_10(128u);
                                            if ((_e3032[0].member >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3032[0].member_1 == 0u) {
                                                    phi_4824_ = 1u;
                                                } else {
                                                    phi_4824_ = 0u;
                                                }
                                                let _e3245 = phi_4824_;
                                                phi_4831_ = type_9((~(_e3032[0].member) + _e3245), (~(_e3032[0].member_1) + 1u));
                                            } else {
                                                phi_4831_ = _e3032[0];
                                            }
                                            let _e3252 = phi_4831_;
                                            if (_e3236.member_1 < _e3252.member_1) {
                                                phi_4838_ = 1u;
                                            } else {
                                                phi_4838_ = 0u;
                                            }
                                            let _e3257 = phi_4838_;
                                            if ((((_e3236.member - _e3252.member) - _e3257) >> bitcast<u32>(31i)) != 0u) {
                                                if ((_e3032[0].member >> bitcast<u32>(31i)) != 0u) {
                                                    phi_4851_ = 2u;
                                                } else {
                                                    phi_4851_ = 1u;
                                                }
                                                let _e3267 = phi_4851_;
                                                phi_4852_ = _e3267;
                                            } else {
                                                phi_4852_ = 0u;
                                            }
                                            let _e3269 = phi_4852_;
                                            let _e3274 = function_10(128u);
                                            if ((_e3032[3].member >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3032[3].member_1 == 0u) {
                                                    phi_4867_ = 1u;
                                                } else {
                                                    phi_4867_ = 0u;
                                                }
                                                let _e3283 = phi_4867_;
                                                phi_4874_ = type_9((~(_e3032[3].member) + _e3283), (~(_e3032[3].member_1) + 1u));
                                            } else {
                                                phi_4874_ = _e3032[3];
                                            }
                                            let _e3290 = phi_4874_;
                                            if (_e3274.member_1 < _e3290.member_1) {
                                                phi_4881_ = 1u;
                                            } else {
                                                phi_4881_ = 0u;
                                            }
                                            let _e3295 = phi_4881_;
                                            if ((((_e3274.member - _e3290.member) - _e3295) >> bitcast<u32>(31i)) != 0u) {
                                                if ((_e3032[3].member >> bitcast<u32>(31i)) != 0u) {
                                                    phi_4894_ = 2u;
                                                } else {
                                                    phi_4894_ = 1u;
                                                }
                                                let _e3305 = phi_4894_;
                                                phi_4895_ = _e3305;
                                            } else {
                                                phi_4895_ = 0u;
                                            }
                                            let _e3307 = phi_4895_;
                                            let _e3309 = ((_e3269 | _e3307) == 3u);
                                            if _e3222 {
                                                phi_4902_ = !(_e3309);
                                            } else {
                                                phi_4902_ = false;
                                            }
                                            let _e3312 = phi_4902_;
                                            if _e3312 {
                                                phi_4910_ = select((bitcast<u32>(31i) - firstLeadingBit(_e1455)), 32u, (_e1455 == 0u));
                                            } else {
                                                phi_4910_ = _e3034;
                                            }
                                            let _e3319 = phi_4910_;
                                            if (_e2066[0][1][0].member_1 < _e2066[0][0][0].member_1) {
                                                phi_4928_ = 1u;
                                            } else {
                                                phi_4928_ = 0u;
                                            }
                                            let _e3340 = phi_4928_;
                                            let _e3342 = ((_e2066[0][1][0].member - _e2066[0][0][0].member) - _e3340);
                                            let _e3343 = (_e2066[0][1][0].member_1 - _e2066[0][0][0].member_1);
                                            if (_e2066[0][1][1].member_1 < _e2066[0][0][1].member_1) {
                                                phi_4940_ = 1u;
                                            } else {
                                                phi_4940_ = 0u;
                                            }
                                            let _e3354 = phi_4940_;
                                            let _e3356 = ((_e2066[0][1][1].member - _e2066[0][0][1].member) - _e3354);
                                            let _e3357 = (_e2066[0][1][1].member_1 - _e2066[0][0][1].member_1);
                                            if (_e2066[0][1][2].member_1 < _e2066[0][0][2].member_1) {
                                                phi_4952_ = 1u;
                                            } else {
                                                phi_4952_ = 0u;
                                            }
                                            let _e3368 = phi_4952_;
                                            let _e3370 = ((_e2066[0][1][2].member - _e2066[0][0][2].member) - _e3368);
                                            let _e3371 = (_e2066[0][1][2].member_1 - _e2066[0][0][2].member_1);
                                            if ((_e3342 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3343 == 0u) {
                                                    phi_4973_ = 1u;
                                                } else {
                                                    phi_4973_ = 0u;
                                                }
                                                let _e3378 = phi_4973_;
                                                phi_4980_ = type_9((~(_e3342) + _e3378), (~(_e3343) + 1u));
                                            } else {
                                                phi_4980_ = type_9(_e3342, _e3343);
                                            }
                                            let _e3385 = phi_4980_;
                                            if ((_e3356 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3357 == 0u) {
                                                    phi_4994_ = 1u;
                                                } else {
                                                    phi_4994_ = 0u;
                                                }
                                                let _e3394 = phi_4994_;
                                                phi_5001_ = type_9((~(_e3356) + _e3394), (~(_e3357) + 1u));
                                            } else {
                                                phi_5001_ = type_9(_e3356, _e3357);
                                            }
                                            let _e3401 = phi_5001_;
                                            if (_e3401.member_1 < _e3385.member_1) {
                                                phi_5008_ = 1u;
                                            } else {
                                                phi_5008_ = 0u;
                                            }
                                            let _e3406 = phi_5008_;
                                            if ((((_e3401.member - _e3385.member) - _e3406) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5018_ = _e3385;
                                            } else {
                                                phi_5018_ = _e3401;
                                            }
                                            let _e3413 = phi_5018_;
                                            if ((_e3370 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3371 == 0u) {
                                                    phi_5032_ = 1u;
                                                } else {
                                                    phi_5032_ = 0u;
                                                }
                                                let _e3422 = phi_5032_;
                                                phi_5039_ = type_9((~(_e3370) + _e3422), (~(_e3371) + 1u));
                                            } else {
                                                phi_5039_ = type_9(_e3370, _e3371);
                                            }
                                            let _e3429 = phi_5039_;
                                            if (_e3429.member_1 < _e3413.member_1) {
                                                phi_5046_ = 1u;
                                            } else {
                                                phi_5046_ = 0u;
                                            }
                                            let _e3434 = phi_5046_;
                                            if ((((_e3429.member - _e3413.member) - _e3434) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5056_ = _e3413;
                                            } else {
                                                phi_5056_ = _e3429;
                                            }
                                            let _e3441 = phi_5056_;
                                            let _e3444 = function_10(4u);
                                            let _e3447 = (_e3441.member_1 + _e3444.member_1);
                                            if (_e3447 < _e3441.member_1) {
                                                phi_5067_ = 1u;
                                            } else {
                                                phi_5067_ = 0u;
                                            }
                                            let _e3450 = phi_5067_;
                                            let _e3452 = ((_e3441.member + _e3444.member) + _e3450);
                                            let _e3467 = ((_e3447 >> bitcast<u32>((_e3319 & 31u))) | ((_e3452 << bitcast<u32>(((31u - _e3319) & 31u))) << bitcast<u32>(1i)));
                                            let _e3468 = function_10(4u);
                                            let _e3471 = (_e3467 + _e3468.member_1);
                                            if (_e3471 < _e3467) {
                                                phi_5089_ = 1u;
                                            } else {
                                                phi_5089_ = 0u;
                                            }
                                            let _e3474 = phi_5089_;
                                            if (_e2066[1][1][0].member_1 < _e2066[1][0][0].member_1) {
                                                phi_5102_ = 1u;
                                            } else {
                                                phi_5102_ = 0u;
                                            }
                                            let _e3489 = phi_5102_;
                                            let _e3491 = ((_e2066[1][1][0].member - _e2066[1][0][0].member) - _e3489);
                                            let _e3492 = (_e2066[1][1][0].member_1 - _e2066[1][0][0].member_1);
                                            if (_e2066[1][1][1].member_1 < _e2066[1][0][1].member_1) {
                                                phi_5114_ = 1u;
                                            } else {
                                                phi_5114_ = 0u;
                                            }
                                            let _e3503 = phi_5114_;
                                            let _e3505 = ((_e2066[1][1][1].member - _e2066[1][0][1].member) - _e3503);
                                            let _e3506 = (_e2066[1][1][1].member_1 - _e2066[1][0][1].member_1);
                                            if (_e2066[1][1][2].member_1 < _e2066[1][0][2].member_1) {
                                                phi_5126_ = 1u;
                                            } else {
                                                phi_5126_ = 0u;
                                            }
                                            let _e3517 = phi_5126_;
                                            let _e3519 = ((_e2066[1][1][2].member - _e2066[1][0][2].member) - _e3517);
                                            let _e3520 = (_e2066[1][1][2].member_1 - _e2066[1][0][2].member_1);
                                            if ((_e3491 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3492 == 0u) {
                                                    phi_5147_ = 1u;
                                                } else {
                                                    phi_5147_ = 0u;
                                                }
                                                let _e3527 = phi_5147_;
                                                phi_5154_ = type_9((~(_e3491) + _e3527), (~(_e3492) + 1u));
                                            } else {
                                                phi_5154_ = type_9(_e3491, _e3492);
                                            }
                                            let _e3534 = phi_5154_;
                                            if ((_e3505 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3506 == 0u) {
                                                    phi_5168_ = 1u;
                                                } else {
                                                    phi_5168_ = 0u;
                                                }
                                                let _e3543 = phi_5168_;
                                                phi_5175_ = type_9((~(_e3505) + _e3543), (~(_e3506) + 1u));
                                            } else {
                                                phi_5175_ = type_9(_e3505, _e3506);
                                            }
                                            let _e3550 = phi_5175_;
                                            if (_e3550.member_1 < _e3534.member_1) {
                                                phi_5182_ = 1u;
                                            } else {
                                                phi_5182_ = 0u;
                                            }
                                            let _e3555 = phi_5182_;
                                            if ((((_e3550.member - _e3534.member) - _e3555) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5192_ = _e3534;
                                            } else {
                                                phi_5192_ = _e3550;
                                            }
                                            let _e3562 = phi_5192_;
                                            if ((_e3519 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3520 == 0u) {
                                                    phi_5206_ = 1u;
                                                } else {
                                                    phi_5206_ = 0u;
                                                }
                                                let _e3571 = phi_5206_;
                                                phi_5213_ = type_9((~(_e3519) + _e3571), (~(_e3520) + 1u));
                                            } else {
                                                phi_5213_ = type_9(_e3519, _e3520);
                                            }
                                            let _e3578 = phi_5213_;
                                            if (_e3578.member_1 < _e3562.member_1) {
                                                phi_5220_ = 1u;
                                            } else {
                                                phi_5220_ = 0u;
                                            }
                                            let _e3583 = phi_5220_;
                                            if ((((_e3578.member - _e3562.member) - _e3583) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5230_ = _e3562;
                                            } else {
                                                phi_5230_ = _e3578;
                                            }
                                            let _e3590 = phi_5230_;
                                            let _e3593 = function_10(4u);
                                            let _e3596 = (_e3590.member_1 + _e3593.member_1);
                                            if (_e3596 < _e3590.member_1) {
                                                phi_5241_ = 1u;
                                            } else {
                                                phi_5241_ = 0u;
                                            }
                                            let _e3599 = phi_5241_;
                                            let _e3601 = ((_e3590.member + _e3593.member) + _e3599);
                                            let _e3616 = ((_e3596 >> bitcast<u32>((_e3319 & 31u))) | ((_e3601 << bitcast<u32>(((31u - _e3319) & 31u))) << bitcast<u32>(1i)));
                                            let _e3617 = function_10(4u);
                                            let _e3620 = (_e3616 + _e3617.member_1);
                                            if (_e3620 < _e3616) {
                                                phi_5263_ = 1u;
                                            } else {
                                                phi_5263_ = 0u;
                                            }
                                            let _e3623 = phi_5263_;
                                            if (_e2066[2][1][0].member_1 < _e2066[2][0][0].member_1) {
                                                phi_5276_ = 1u;
                                            } else {
                                                phi_5276_ = 0u;
                                            }
                                            let _e3638 = phi_5276_;
                                            let _e3640 = ((_e2066[2][1][0].member - _e2066[2][0][0].member) - _e3638);
                                            let _e3641 = (_e2066[2][1][0].member_1 - _e2066[2][0][0].member_1);
                                            if (_e2066[2][1][1].member_1 < _e2066[2][0][1].member_1) {
                                                phi_5288_ = 1u;
                                            } else {
                                                phi_5288_ = 0u;
                                            }
                                            let _e3652 = phi_5288_;
                                            let _e3654 = ((_e2066[2][1][1].member - _e2066[2][0][1].member) - _e3652);
                                            let _e3655 = (_e2066[2][1][1].member_1 - _e2066[2][0][1].member_1);
                                            if (_e2066[2][1][2].member_1 < _e2066[2][0][2].member_1) {
                                                phi_5300_ = 1u;
                                            } else {
                                                phi_5300_ = 0u;
                                            }
                                            let _e3666 = phi_5300_;
                                            let _e3668 = ((_e2066[2][1][2].member - _e2066[2][0][2].member) - _e3666);
                                            let _e3669 = (_e2066[2][1][2].member_1 - _e2066[2][0][2].member_1);
                                            if ((_e3640 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3641 == 0u) {
                                                    phi_5321_ = 1u;
                                                } else {
                                                    phi_5321_ = 0u;
                                                }
                                                let _e3676 = phi_5321_;
                                                phi_5328_ = type_9((~(_e3640) + _e3676), (~(_e3641) + 1u));
                                            } else {
                                                phi_5328_ = type_9(_e3640, _e3641);
                                            }
                                            let _e3683 = phi_5328_;
                                            if ((_e3654 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3655 == 0u) {
                                                    phi_5342_ = 1u;
                                                } else {
                                                    phi_5342_ = 0u;
                                                }
                                                let _e3692 = phi_5342_;
                                                phi_5349_ = type_9((~(_e3654) + _e3692), (~(_e3655) + 1u));
                                            } else {
                                                phi_5349_ = type_9(_e3654, _e3655);
                                            }
                                            let _e3699 = phi_5349_;
                                            if (_e3699.member_1 < _e3683.member_1) {
                                                phi_5356_ = 1u;
                                            } else {
                                                phi_5356_ = 0u;
                                            }
                                            let _e3704 = phi_5356_;
                                            if ((((_e3699.member - _e3683.member) - _e3704) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5366_ = _e3683;
                                            } else {
                                                phi_5366_ = _e3699;
                                            }
                                            let _e3711 = phi_5366_;
                                            if ((_e3668 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3669 == 0u) {
                                                    phi_5380_ = 1u;
                                                } else {
                                                    phi_5380_ = 0u;
                                                }
                                                let _e3720 = phi_5380_;
                                                phi_5387_ = type_9((~(_e3668) + _e3720), (~(_e3669) + 1u));
                                            } else {
                                                phi_5387_ = type_9(_e3668, _e3669);
                                            }
                                            let _e3727 = phi_5387_;
                                            if (_e3727.member_1 < _e3711.member_1) {
                                                phi_5394_ = 1u;
                                            } else {
                                                phi_5394_ = 0u;
                                            }
                                            let _e3732 = phi_5394_;
                                            if ((((_e3727.member - _e3711.member) - _e3732) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5404_ = _e3711;
                                            } else {
                                                phi_5404_ = _e3727;
                                            }
                                            let _e3739 = phi_5404_;
                                            let _e3742 = function_10(4u);
                                            let _e3745 = (_e3739.member_1 + _e3742.member_1);
                                            if (_e3745 < _e3739.member_1) {
                                                phi_5415_ = 1u;
                                            } else {
                                                phi_5415_ = 0u;
                                            }
                                            let _e3748 = phi_5415_;
                                            let _e3750 = ((_e3739.member + _e3742.member) + _e3748);
                                            let _e3765 = ((_e3745 >> bitcast<u32>((_e3319 & 31u))) | ((_e3750 << bitcast<u32>(((31u - _e3319) & 31u))) << bitcast<u32>(1i)));
                                            let _e3766 = function_10(4u);
                                            let _e3769 = (_e3765 + _e3766.member_1);
                                            if (_e3769 < _e3765) {
                                                phi_5437_ = 1u;
                                            } else {
                                                phi_5437_ = 0u;
                                            }
                                            let _e3772 = phi_5437_;
                                            local_25[0u].member = ((bitcast<u32>((bitcast<i32>(_e3452) >> bitcast<u32>((_e3319 & 31u)))) + _e3468.member) + _e3474);
                                            local_25[0u].member_1 = _e3471;
                                            local_25[1u].member = ((bitcast<u32>((bitcast<i32>(_e3601) >> bitcast<u32>((_e3319 & 31u)))) + _e3617.member) + _e3623);
                                            local_25[1u].member_1 = _e3620;
                                            local_25[2u].member = ((bitcast<u32>((bitcast<i32>(_e3750) >> bitcast<u32>((_e3319 & 31u)))) + _e3766.member) + _e3772);
                                            local_25[2u].member_1 = _e3769;
                                            if (_e2066[0][1][0].member_1 < _e2066[0][0][0].member_1) {
                                                phi_5458_ = 1u;
                                            } else {
                                                phi_5458_ = 0u;
                                            }
                                            let _e3797 = phi_5458_;
                                            let _e3801 = function_4(((_e2066[0][1][0].member - _e2066[0][0][0].member) - _e3797), (_e2066[0][1][0].member_1 - _e2066[0][0][0].member_1), _e3057);
                                            let _e3804 = (_e2066[0][0][0].member_1 + _e3801.member_1);
                                            if (_e3804 < _e2066[0][0][0].member_1) {
                                                phi_5470_ = 1u;
                                            } else {
                                                phi_5470_ = 0u;
                                            }
                                            let _e3807 = phi_5470_;
                                            let _e3809 = ((_e2066[0][0][0].member + _e3801.member) + _e3807);
                                            if (_e2066[0][1][1].member_1 < _e2066[0][0][1].member_1) {
                                                phi_5481_ = 1u;
                                            } else {
                                                phi_5481_ = 0u;
                                            }
                                            let _e3820 = phi_5481_;
                                            let _e3824 = function_4(((_e2066[0][1][1].member - _e2066[0][0][1].member) - _e3820), (_e2066[0][1][1].member_1 - _e2066[0][0][1].member_1), _e3057);
                                            let _e3827 = (_e2066[0][0][1].member_1 + _e3824.member_1);
                                            if (_e3827 < _e2066[0][0][1].member_1) {
                                                phi_5493_ = 1u;
                                            } else {
                                                phi_5493_ = 0u;
                                            }
                                            let _e3830 = phi_5493_;
                                            let _e3832 = ((_e2066[0][0][1].member + _e3824.member) + _e3830);
                                            if (_e2066[0][1][2].member_1 < _e2066[0][0][2].member_1) {
                                                phi_5504_ = 1u;
                                            } else {
                                                phi_5504_ = 0u;
                                            }
                                            let _e3843 = phi_5504_;
                                            let _e3847 = function_4(((_e2066[0][1][2].member - _e2066[0][0][2].member) - _e3843), (_e2066[0][1][2].member_1 - _e2066[0][0][2].member_1), _e3057);
                                            let _e3850 = (_e2066[0][0][2].member_1 + _e3847.member_1);
                                            if (_e3850 < _e2066[0][0][2].member_1) {
                                                phi_5516_ = 1u;
                                            } else {
                                                phi_5516_ = 0u;
                                            }
                                            let _e3853 = phi_5516_;
                                            let _e3855 = ((_e2066[0][0][2].member + _e3847.member) + _e3853);
                                            if (_e2066[1][1][0].member_1 < _e2066[1][0][0].member_1) {
                                                phi_5535_ = 1u;
                                            } else {
                                                phi_5535_ = 0u;
                                            }
                                            let _e3868 = phi_5535_;
                                            let _e3872 = function_4(((_e2066[1][1][0].member - _e2066[1][0][0].member) - _e3868), (_e2066[1][1][0].member_1 - _e2066[1][0][0].member_1), _e3057);
                                            let _e3875 = (_e2066[1][0][0].member_1 + _e3872.member_1);
                                            if (_e3875 < _e2066[1][0][0].member_1) {
                                                phi_5547_ = 1u;
                                            } else {
                                                phi_5547_ = 0u;
                                            }
                                            let _e3878 = phi_5547_;
                                            let _e3880 = ((_e2066[1][0][0].member + _e3872.member) + _e3878);
                                            if (_e2066[1][1][1].member_1 < _e2066[1][0][1].member_1) {
                                                phi_5558_ = 1u;
                                            } else {
                                                phi_5558_ = 0u;
                                            }
                                            let _e3891 = phi_5558_;
                                            let _e3895 = function_4(((_e2066[1][1][1].member - _e2066[1][0][1].member) - _e3891), (_e2066[1][1][1].member_1 - _e2066[1][0][1].member_1), _e3057);
                                            let _e3898 = (_e2066[1][0][1].member_1 + _e3895.member_1);
                                            if (_e3898 < _e2066[1][0][1].member_1) {
                                                phi_5570_ = 1u;
                                            } else {
                                                phi_5570_ = 0u;
                                            }
                                            let _e3901 = phi_5570_;
                                            let _e3903 = ((_e2066[1][0][1].member + _e3895.member) + _e3901);
                                            if (_e2066[1][1][2].member_1 < _e2066[1][0][2].member_1) {
                                                phi_5581_ = 1u;
                                            } else {
                                                phi_5581_ = 0u;
                                            }
                                            let _e3914 = phi_5581_;
                                            let _e3918 = function_4(((_e2066[1][1][2].member - _e2066[1][0][2].member) - _e3914), (_e2066[1][1][2].member_1 - _e2066[1][0][2].member_1), _e3057);
                                            let _e3921 = (_e2066[1][0][2].member_1 + _e3918.member_1);
                                            if (_e3921 < _e2066[1][0][2].member_1) {
                                                phi_5593_ = 1u;
                                            } else {
                                                phi_5593_ = 0u;
                                            }
                                            let _e3924 = phi_5593_;
                                            let _e3926 = ((_e2066[1][0][2].member + _e3918.member) + _e3924);
                                            if (_e2066[2][1][0].member_1 < _e2066[2][0][0].member_1) {
                                                phi_5612_ = 1u;
                                            } else {
                                                phi_5612_ = 0u;
                                            }
                                            let _e3939 = phi_5612_;
                                            let _e3943 = function_4(((_e2066[2][1][0].member - _e2066[2][0][0].member) - _e3939), (_e2066[2][1][0].member_1 - _e2066[2][0][0].member_1), _e3057);
                                            let _e3946 = (_e2066[2][0][0].member_1 + _e3943.member_1);
                                            if (_e3946 < _e2066[2][0][0].member_1) {
                                                phi_5624_ = 1u;
                                            } else {
                                                phi_5624_ = 0u;
                                            }
                                            let _e3949 = phi_5624_;
                                            let _e3951 = ((_e2066[2][0][0].member + _e3943.member) + _e3949);
                                            if (_e2066[2][1][1].member_1 < _e2066[2][0][1].member_1) {
                                                phi_5635_ = 1u;
                                            } else {
                                                phi_5635_ = 0u;
                                            }
                                            let _e3962 = phi_5635_;
                                            let _e3966 = function_4(((_e2066[2][1][1].member - _e2066[2][0][1].member) - _e3962), (_e2066[2][1][1].member_1 - _e2066[2][0][1].member_1), _e3057);
                                            let _e3969 = (_e2066[2][0][1].member_1 + _e3966.member_1);
                                            if (_e3969 < _e2066[2][0][1].member_1) {
                                                phi_5647_ = 1u;
                                            } else {
                                                phi_5647_ = 0u;
                                            }
                                            let _e3972 = phi_5647_;
                                            let _e3974 = ((_e2066[2][0][1].member + _e3966.member) + _e3972);
                                            if (_e2066[2][1][2].member_1 < _e2066[2][0][2].member_1) {
                                                phi_5658_ = 1u;
                                            } else {
                                                phi_5658_ = 0u;
                                            }
                                            let _e3985 = phi_5658_;
                                            let _e3989 = function_4(((_e2066[2][1][2].member - _e2066[2][0][2].member) - _e3985), (_e2066[2][1][2].member_1 - _e2066[2][0][2].member_1), _e3057);
                                            let _e3992 = (_e2066[2][0][2].member_1 + _e3989.member_1);
                                            if (_e3992 < _e2066[2][0][2].member_1) {
                                                phi_5670_ = 1u;
                                            } else {
                                                phi_5670_ = 0u;
                                            }
                                            let _e3995 = phi_5670_;
                                            let _e3997 = ((_e2066[2][0][2].member + _e3989.member) + _e3995);
                                            local_23 = array<type_9, 3>(type_9(_e3880, _e3875), type_9(_e3903, _e3898), type_9(_e3926, _e3921));
                                            local_24 = array<type_9, 3>(type_9(_e3951, _e3946), type_9(_e3974, _e3969), type_9(_e3997, _e3992));
                                            let _e4008 = local_23[1u].member;
                                            let _e4010 = local_23[1u].member_1;
                                            let _e4013 = local_24[2u].member;
                                            let _e4015 = local_24[2u].member_1;
                                            let _e4016 = function_8(_e4008, _e4010, _e4013, _e4015);
                                            let _e4021 = local_23[2u].member;
                                            let _e4023 = local_23[2u].member_1;
                                            let _e4026 = local_24[1u].member;
                                            let _e4028 = local_24[1u].member_1;
                                            let _e4029 = function_8(_e4021, _e4023, _e4026, _e4028);
                                            if (_e4016.member_1 < _e4029.member_1) {
                                                phi_5755_ = 1u;
                                            } else {
                                                phi_5755_ = 0u;
                                            }
                                            let _e4034 = phi_5755_;
                                            let _e4036 = ((_e4016.member - _e4029.member) - _e4034);
                                            let _e4037 = (_e4016.member_1 - _e4029.member_1);
                                            local_21 = array<type_9, 3>(type_9(_e3880, _e3875), type_9(_e3903, _e3898), type_9(_e3926, _e3921));
                                            local_22 = array<type_9, 3>(type_9(_e3951, _e3946), type_9(_e3974, _e3969), type_9(_e3997, _e3992));
                                            let _e4048 = local_21[2u].member;
                                            let _e4050 = local_21[2u].member_1;
                                            let _e4053 = local_22[0u].member;
                                            let _e4055 = local_22[0u].member_1;
                                            let _e4056 = function_8(_e4048, _e4050, _e4053, _e4055);
                                            let _e4061 = local_21[0u].member;
                                            let _e4063 = local_21[0u].member_1;
                                            let _e4066 = local_22[2u].member;
                                            let _e4068 = local_22[2u].member_1;
                                            let _e4069 = function_8(_e4061, _e4063, _e4066, _e4068);
                                            if (_e4056.member_1 < _e4069.member_1) {
                                                phi_5835_ = 1u;
                                            } else {
                                                phi_5835_ = 0u;
                                            }
                                            let _e4074 = phi_5835_;
                                            let _e4076 = ((_e4056.member - _e4069.member) - _e4074);
                                            let _e4077 = (_e4056.member_1 - _e4069.member_1);
                                            local_19 = array<type_9, 3>(type_9(_e3880, _e3875), type_9(_e3903, _e3898), type_9(_e3926, _e3921));
                                            local_20 = array<type_9, 3>(type_9(_e3951, _e3946), type_9(_e3974, _e3969), type_9(_e3997, _e3992));
                                            let _e4088 = local_19[0u].member;
                                            let _e4090 = local_19[0u].member_1;
                                            let _e4093 = local_20[1u].member;
                                            let _e4095 = local_20[1u].member_1;
                                            let _e4096 = function_8(_e4088, _e4090, _e4093, _e4095);
                                            let _e4101 = local_19[1u].member;
                                            let _e4103 = local_19[1u].member_1;
                                            let _e4106 = local_20[0u].member;
                                            let _e4108 = local_20[0u].member_1;
                                            let _e4109 = function_8(_e4101, _e4103, _e4106, _e4108);
                                            if (_e4096.member_1 < _e4109.member_1) {
                                                phi_5915_ = 1u;
                                            } else {
                                                phi_5915_ = 0u;
                                            }
                                            let _e4114 = phi_5915_;
                                            let _e4116 = ((_e4096.member - _e4109.member) - _e4114);
                                            let _e4117 = (_e4096.member_1 - _e4109.member_1);
                                            if ((_e4036 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e4037 == 0u) {
                                                    phi_5936_ = 1u;
                                                } else {
                                                    phi_5936_ = 0u;
                                                }
                                                let _e4124 = phi_5936_;
                                                phi_5943_ = type_9((~(_e4036) + _e4124), (~(_e4037) + 1u));
                                            } else {
                                                phi_5943_ = type_9(_e4036, _e4037);
                                            }
                                            let _e4131 = phi_5943_;
                                            if ((_e4076 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e4077 == 0u) {
                                                    phi_5957_ = 1u;
                                                } else {
                                                    phi_5957_ = 0u;
                                                }
                                                let _e4140 = phi_5957_;
                                                phi_5964_ = type_9((~(_e4076) + _e4140), (~(_e4077) + 1u));
                                            } else {
                                                phi_5964_ = type_9(_e4076, _e4077);
                                            }
                                            let _e4147 = phi_5964_;
                                            if ((_e4116 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e4117 == 0u) {
                                                    phi_5978_ = 1u;
                                                } else {
                                                    phi_5978_ = 0u;
                                                }
                                                let _e4156 = phi_5978_;
                                                phi_5985_ = type_9((~(_e4116) + _e4156), (~(_e4117) + 1u));
                                            } else {
                                                phi_5985_ = type_9(_e4116, _e4117);
                                            }
                                            let _e4163 = phi_5985_;
                                            if (_e4147.member_1 < _e4131.member_1) {
                                                phi_5992_ = 1u;
                                            } else {
                                                phi_5992_ = 0u;
                                            }
                                            let _e4168 = phi_5992_;
                                            if ((((_e4147.member - _e4131.member) - _e4168) >> bitcast<u32>(31i)) != 0u) {
                                                if (_e4163.member_1 < _e4131.member_1) {
                                                    phi_6004_ = 1u;
                                                } else {
                                                    phi_6004_ = 0u;
                                                }
                                                let _e4176 = phi_6004_;
                                                if ((((_e4163.member - _e4131.member) - _e4176) >> bitcast<u32>(31i)) != 0u) {
                                                    phi_6012_ = false;
                                                } else {
                                                    phi_6012_ = true;
                                                }
                                                let _e4183 = phi_6012_;
                                                phi_6013_ = _e4183;
                                            } else {
                                                phi_6013_ = true;
                                            }
                                            let _e4185 = phi_6013_;
                                            if _e4185 {
                                                if (_e4163.member_1 < _e4147.member_1) {
                                                    phi_6021_ = 1u;
                                                } else {
                                                    phi_6021_ = 0u;
                                                }
                                                let _e4188 = phi_6021_;
                                                if ((((_e4163.member - _e4147.member) - _e4188) >> bitcast<u32>(31i)) != 0u) {
                                                    phi_6029_ = 1i;
                                                } else {
                                                    phi_6029_ = 2i;
                                                }
                                                let _e4195 = phi_6029_;
                                                phi_6030_ = _e4195;
                                            } else {
                                                phi_6030_ = 0i;
                                            }
                                            let _e4197 = phi_6030_;
                                            switch _e4197 {
                                                case 0: {
                                                    phi_6059_ = array<type_9, 2>(type_9(_e3832, _e3827), type_9(_e3855, _e3850));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6059_ = array<type_9, 2>(type_9(_e3855, _e3850), type_9(_e3809, _e3804));
                                                    break;
                                                }
                                                default: {
                                                    phi_6059_ = array<type_9, 2>(type_9(_e3809, _e3804), type_9(_e3832, _e3827));
                                                    break;
                                                }
                                            }
                                            let _e4208 = phi_6059_;
                                            switch _e4197 {
                                                case 0: {
                                                    phi_6088_ = array<type_9, 2>(type_9(_e3903, _e3898), type_9(_e3926, _e3921));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6088_ = array<type_9, 2>(type_9(_e3926, _e3921), type_9(_e3880, _e3875));
                                                    break;
                                                }
                                                default: {
                                                    phi_6088_ = array<type_9, 2>(type_9(_e3880, _e3875), type_9(_e3903, _e3898));
                                                    break;
                                                }
                                            }
                                            let _e4219 = phi_6088_;
                                            switch _e4197 {
                                                case 0: {
                                                    phi_6117_ = array<type_9, 2>(type_9(_e3974, _e3969), type_9(_e3997, _e3992));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6117_ = array<type_9, 2>(type_9(_e3997, _e3992), type_9(_e3951, _e3946));
                                                    break;
                                                }
                                                default: {
                                                    phi_6117_ = array<type_9, 2>(type_9(_e3951, _e3946), type_9(_e3974, _e3969));
                                                    break;
                                                }
                                            }
                                            let _e4230 = phi_6117_;
                                            switch _e4197 {
                                                case 0: {
                                                    phi_6131_ = type_9(_e4036, _e4037);
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6131_ = type_9(_e4076, _e4077);
                                                    break;
                                                }
                                                default: {
                                                    phi_6131_ = type_9(_e4116, _e4117);
                                                    break;
                                                }
                                            }
                                            let _e4235 = phi_6131_;
                                            let _e4238 = local_25[1u].member;
                                            let _e4240 = local_25[1u].member_1;
                                            let _e4243 = local_25[2u].member;
                                            let _e4245 = local_25[2u].member_1;
                                            let _e4246 = (_e4240 + _e4245);
                                            if (_e4246 < _e4240) {
                                                phi_6157_ = 1u;
                                            } else {
                                                phi_6157_ = 0u;
                                            }
                                            let _e4249 = phi_6157_;
                                            let _e4251 = ((_e4238 + _e4243) + _e4249);
                                            let _e4262 = ((_e4246 >> bitcast<u32>(1u)) | ((_e4251 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e4263 = function_10(17u);
                                            let _e4266 = (_e4262 + _e4263.member_1);
                                            if (_e4266 < _e4262) {
                                                phi_6179_ = 1u;
                                            } else {
                                                phi_6179_ = 0u;
                                            }
                                            let _e4269 = phi_6179_;
                                            let _e4271 = ((bitcast<u32>((bitcast<i32>(_e4251) >> bitcast<u32>(1u))) + _e4263.member) + _e4269);
                                            let _e4274 = local_25[0u].member;
                                            let _e4276 = local_25[0u].member_1;
                                            let _e4279 = local_25[2u].member;
                                            let _e4281 = local_25[2u].member_1;
                                            let _e4282 = (_e4276 + _e4281);
                                            if (_e4282 < _e4276) {
                                                phi_6207_ = 1u;
                                            } else {
                                                phi_6207_ = 0u;
                                            }
                                            let _e4285 = phi_6207_;
                                            let _e4287 = ((_e4274 + _e4279) + _e4285);
                                            let _e4298 = ((_e4282 >> bitcast<u32>(1u)) | ((_e4287 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e4299 = function_10(17u);
                                            let _e4302 = (_e4298 + _e4299.member_1);
                                            if (_e4302 < _e4298) {
                                                phi_6229_ = 1u;
                                            } else {
                                                phi_6229_ = 0u;
                                            }
                                            let _e4305 = phi_6229_;
                                            let _e4307 = ((bitcast<u32>((bitcast<i32>(_e4287) >> bitcast<u32>(1u))) + _e4299.member) + _e4305);
                                            let _e4310 = local_25[0u].member;
                                            let _e4312 = local_25[0u].member_1;
                                            let _e4315 = local_25[1u].member;
                                            let _e4317 = local_25[1u].member_1;
                                            let _e4318 = (_e4312 + _e4317);
                                            if (_e4318 < _e4312) {
                                                phi_6257_ = 1u;
                                            } else {
                                                phi_6257_ = 0u;
                                            }
                                            let _e4321 = phi_6257_;
                                            let _e4323 = ((_e4310 + _e4315) + _e4321);
                                            let _e4334 = ((_e4318 >> bitcast<u32>(1u)) | ((_e4323 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e4335 = function_10(17u);
                                            let _e4338 = (_e4334 + _e4335.member_1);
                                            if (_e4338 < _e4334) {
                                                phi_6279_ = 1u;
                                            } else {
                                                phi_6279_ = 0u;
                                            }
                                            let _e4341 = phi_6279_;
                                            let _e4343 = ((bitcast<u32>((bitcast<i32>(_e4323) >> bitcast<u32>(1u))) + _e4335.member) + _e4341);
                                            if ((_e4235.member >> bitcast<u32>(31i)) != 0u) {
                                                if (_e4235.member_1 == 0u) {
                                                    phi_6293_ = 1u;
                                                } else {
                                                    phi_6293_ = 0u;
                                                }
                                                let _e4351 = phi_6293_;
                                                phi_6300_ = type_9((~(_e4235.member) + _e4351), (~(_e4235.member_1) + 1u));
                                            } else {
                                                phi_6300_ = _e4235;
                                            }
                                            let _e4358 = phi_6300_;
                                            if (_e4266 < _e4358.member_1) {
                                                phi_6307_ = 1u;
                                            } else {
                                                phi_6307_ = 0u;
                                            }
                                            let _e4363 = phi_6307_;
                                            if ((((_e4271 - _e4358.member) - _e4363) >> bitcast<u32>(31i)) != 0u) {
                                                let _e4372 = ((_e4235.member >> bitcast<u32>(31i)) != 0u);
                                                if _e4372 {
                                                    if (_e4235.member_1 == 0u) {
                                                        phi_6327_ = 1u;
                                                    } else {
                                                        phi_6327_ = 0u;
                                                    }
                                                    let _e4377 = phi_6327_;
                                                    phi_6334_ = type_9((~(_e4235.member) + _e4377), (~(_e4235.member_1) + 1u));
                                                } else {
                                                    phi_6334_ = _e4235;
                                                }
                                                let _e4384 = phi_6334_;
                                                let _e4387 = function_9(_e4208, _e4230);
                                                if _e4372 {
                                                    if (_e4387.member_1 == 0u) {
                                                        phi_6347_ = 1u;
                                                    } else {
                                                        phi_6347_ = 0u;
                                                    }
                                                    let _e4392 = phi_6347_;
                                                    phi_6354_ = type_9((~(_e4387.member) + _e4392), (~(_e4387.member_1) + 1u));
                                                } else {
                                                    phi_6354_ = _e4387;
                                                }
                                                let _e4399 = phi_6354_;
                                                let _e4402 = function_9(_e4219, _e4208);
                                                if _e4372 {
                                                    if (_e4402.member_1 == 0u) {
                                                        phi_6367_ = 1u;
                                                    } else {
                                                        phi_6367_ = 0u;
                                                    }
                                                    let _e4407 = phi_6367_;
                                                    phi_6374_ = type_9((~(_e4402.member) + _e4407), (~(_e4402.member_1) + 1u));
                                                } else {
                                                    phi_6374_ = _e4402;
                                                }
                                                let _e4414 = phi_6374_;
                                                if (_e316.member != 0u) {
                                                    if (_e4384.member_1 < _e4399.member_1) {
                                                        phi_6385_ = 1u;
                                                    } else {
                                                        phi_6385_ = 0u;
                                                    }
                                                    let _e4448 = phi_6385_;
                                                    let _e4453 = (_e4266 + _e4302);
                                                    if (_e4453 < _e4266) {
                                                        phi_6395_ = 1u;
                                                    } else {
                                                        phi_6395_ = 0u;
                                                    }
                                                    let _e4456 = phi_6395_;
                                                    if (_e4384.member_1 < _e4414.member_1) {
                                                        phi_6403_ = 1u;
                                                    } else {
                                                        phi_6403_ = 0u;
                                                    }
                                                    let _e4462 = phi_6403_;
                                                    let _e4467 = (_e4266 + _e4338);
                                                    if (_e4467 < _e4266) {
                                                        phi_6413_ = 1u;
                                                    } else {
                                                        phi_6413_ = 0u;
                                                    }
                                                    let _e4470 = phi_6413_;
                                                    phi_6453_ = type_9(((_e4271 + _e4343) + _e4470), _e4467);
                                                    phi_6454_ = type_9(((_e4384.member - _e4414.member) - _e4462), (_e4384.member_1 - _e4414.member_1));
                                                    phi_6455_ = type_9(((_e4271 + _e4307) + _e4456), _e4453);
                                                    phi_6456_ = type_9(((_e4384.member - _e4399.member) - _e4448), (_e4384.member_1 - _e4399.member_1));
                                                } else {
                                                    if (_e4384.member_1 < _e4399.member_1) {
                                                        phi_6421_ = 1u;
                                                    } else {
                                                        phi_6421_ = 0u;
                                                    }
                                                    let _e4420 = phi_6421_;
                                                    let _e4423 = (_e4384.member_1 - _e4399.member_1);
                                                    if (_e4423 < _e4414.member_1) {
                                                        phi_6429_ = 1u;
                                                    } else {
                                                        phi_6429_ = 0u;
                                                    }
                                                    let _e4426 = phi_6429_;
                                                    let _e4428 = ((((_e4384.member - _e4399.member) - _e4420) - _e4414.member) - _e4426);
                                                    let _e4429 = (_e4423 - _e4414.member_1);
                                                    let _e4431 = (_e4266 + _e4302);
                                                    if (_e4431 < _e4266) {
                                                        phi_6439_ = 1u;
                                                    } else {
                                                        phi_6439_ = 0u;
                                                    }
                                                    let _e4434 = phi_6439_;
                                                    let _e4437 = (_e4431 + _e4338);
                                                    if (_e4437 < _e4431) {
                                                        phi_6447_ = 1u;
                                                    } else {
                                                        phi_6447_ = 0u;
                                                    }
                                                    let _e4440 = phi_6447_;
                                                    let _e4442 = ((((_e4271 + _e4307) + _e4434) + _e4343) + _e4440);
                                                    phi_6453_ = type_9(_e4442, _e4437);
                                                    phi_6454_ = type_9(_e4428, _e4429);
                                                    phi_6455_ = type_9(_e4442, _e4437);
                                                    phi_6456_ = type_9(_e4428, _e4429);
                                                }
                                                let _e4475 = phi_6453_;
                                                let _e4477 = phi_6454_;
                                                let _e4479 = phi_6455_;
                                                let _e4481 = phi_6456_;
                                                let _e4482 = function_7(_e4399.member, _e4399.member_1, _e4307, _e4302);
                                                if _e4482 {
                                                    phi_6582_ = u32();
                                                    phi_6583_ = true;
                                                } else {
                                                    let _e4483 = function_7(_e4414.member, _e4414.member_1, _e4343, _e4338);
                                                    if _e4483 {
                                                        phi_6580_ = u32();
                                                        phi_6581_ = true;
                                                    } else {
                                                        let _e4488 = function_7(_e4481.member, _e4481.member_1, _e4479.member, _e4479.member_1);
                                                        if _e4488 {
                                                            phi_6578_ = u32();
                                                            phi_6579_ = true;
                                                        } else {
                                                            let _e4493 = function_7(_e4477.member, _e4477.member_1, _e4475.member, _e4475.member_1);
                                                            if _e4493 {
                                                                phi_6577_ = u32();
                                                            } else {
                                                                let _e4494 = function_6(_e4399.member, _e4399.member_1, _e4307, _e4302);
                                                                if _e4494 {
                                                                    let _e4495 = function_6(_e4414.member, _e4414.member_1, _e4343, _e4338);
                                                                    if _e4495 {
                                                                        let _e4500 = function_6(_e4481.member, _e4481.member_1, _e4479.member, _e4479.member_1);
                                                                        if _e4500 {
                                                                            let _e4505 = function_6(_e4477.member, _e4477.member_1, _e4475.member, _e4475.member_1);
                                                                            if _e4505 {
                                                                                phi_6569_ = false;
                                                                            } else {
                                                                                phi_6569_ = true;
                                                                            }
                                                                            let _e4507 = phi_6569_;
                                                                            phi_6570_ = _e4507;
                                                                        } else {
                                                                            phi_6570_ = true;
                                                                        }
                                                                        let _e4509 = phi_6570_;
                                                                        phi_6571_ = _e4509;
                                                                    } else {
                                                                        phi_6571_ = true;
                                                                    }
                                                                    let _e4511 = phi_6571_;
                                                                    phi_6572_ = _e4511;
                                                                } else {
                                                                    phi_6572_ = true;
                                                                }
                                                                let _e4513 = phi_6572_;
                                                                if _e4513 {
                                                                    phi_6576_ = 2u;
                                                                } else {
                                                                    phi_6576_ = 0u;
                                                                }
                                                                let _e4515 = phi_6576_;
                                                                phi_6577_ = _e4515;
                                                            }
                                                            let _e4517 = phi_6577_;
                                                            phi_6578_ = _e4517;
                                                            phi_6579_ = _e4493;
                                                        }
                                                        let _e4519 = phi_6578_;
                                                        let _e4521 = phi_6579_;
                                                        phi_6580_ = _e4519;
                                                        phi_6581_ = _e4521;
                                                    }
                                                    let _e4523 = phi_6580_;
                                                    let _e4525 = phi_6581_;
                                                    phi_6582_ = _e4523;
                                                    phi_6583_ = _e4525;
                                                }
                                                let _e4527 = phi_6582_;
                                                let _e4529 = phi_6583_;
                                                if _e4529 {
                                                    phi_6587_ = 1u;
                                                } else {
                                                    phi_6587_ = _e4527;
                                                }
                                                let _e4531 = phi_6587_;
                                                phi_6588_ = _e4531;
                                            } else {
                                                phi_6588_ = 2u;
                                            }
                                            let _e4533 = phi_6588_;
                                            let _e4534 = (_e4533 == 1u);
                                            if _e3222 {
                                                phi_6596_ = _e4534;
                                            } else {
                                                phi_6596_ = true;
                                            }
                                            let _e4536 = phi_6596_;
                                            phi_6600_ = _e4534;
                                            phi_6601_ = _e3309;
                                            phi_6602_ = _e3312;
                                            phi_6603_ = (_e3057 + (1u << bitcast<u32>(((31u - _e3319) & 31u))));
                                            phi_6604_ = _e4533;
                                            phi_6605_ = _e4536;
                                        } else {
                                            phi_6600_ = _e3221;
                                            phi_6601_ = bool();
                                            phi_6602_ = bool();
                                            phi_6603_ = u32();
                                            phi_6604_ = u32();
                                            phi_6605_ = true;
                                        }
                                        let _e4538 = phi_6600_;
                                        let _e4540 = phi_6601_;
                                        let _e4542 = phi_6602_;
                                        let _e4544 = phi_6603_;
                                        let _e4546 = phi_6604_;
                                        let _e4548 = phi_6605_;
                                        if _e4548 {
                                            if _e4538 {
                                                phi_6942_ = _e3032;
                                                phi_6944_ = _e3034;
                                                phi_6945_ = _e3036;
                                            } else {
                                                let _e4557 = (_e3032[0].member_1 + _e3032[1].member_1);
                                                if (_e4557 < _e3032[0].member_1) {
                                                    phi_6621_ = 1u;
                                                } else {
                                                    phi_6621_ = 0u;
                                                }
                                                let _e4560 = phi_6621_;
                                                let _e4562 = ((_e3032[0].member + _e3032[1].member) + _e4560);
                                                let _e4570 = bitcast<u32>((bitcast<i32>(_e4562) >> bitcast<u32>(1u)));
                                                let _e4573 = ((_e4557 >> bitcast<u32>(1u)) | ((_e4562 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4582 = (_e3032[1].member_1 + _e3032[2].member_1);
                                                if (_e4582 < _e3032[1].member_1) {
                                                    phi_6644_ = 1u;
                                                } else {
                                                    phi_6644_ = 0u;
                                                }
                                                let _e4585 = phi_6644_;
                                                let _e4587 = ((_e3032[1].member + _e3032[2].member) + _e4585);
                                                let _e4595 = bitcast<u32>((bitcast<i32>(_e4587) >> bitcast<u32>(1u)));
                                                let _e4598 = ((_e4582 >> bitcast<u32>(1u)) | ((_e4587 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4607 = (_e3032[2].member_1 + _e3032[3].member_1);
                                                if (_e4607 < _e3032[2].member_1) {
                                                    phi_6667_ = 1u;
                                                } else {
                                                    phi_6667_ = 0u;
                                                }
                                                let _e4610 = phi_6667_;
                                                let _e4612 = ((_e3032[2].member + _e3032[3].member) + _e4610);
                                                let _e4620 = bitcast<u32>((bitcast<i32>(_e4612) >> bitcast<u32>(1u)));
                                                let _e4623 = ((_e4607 >> bitcast<u32>(1u)) | ((_e4612 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4624 = (_e4573 + _e4598);
                                                if (_e4624 < _e4573) {
                                                    phi_6686_ = 1u;
                                                } else {
                                                    phi_6686_ = 0u;
                                                }
                                                let _e4627 = phi_6686_;
                                                let _e4629 = ((_e4570 + _e4595) + _e4627);
                                                let _e4637 = bitcast<u32>((bitcast<i32>(_e4629) >> bitcast<u32>(1u)));
                                                let _e4640 = ((_e4624 >> bitcast<u32>(1u)) | ((_e4629 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4641 = (_e4598 + _e4623);
                                                if (_e4641 < _e4598) {
                                                    phi_6705_ = 1u;
                                                } else {
                                                    phi_6705_ = 0u;
                                                }
                                                let _e4644 = phi_6705_;
                                                let _e4646 = ((_e4595 + _e4620) + _e4644);
                                                let _e4654 = bitcast<u32>((bitcast<i32>(_e4646) >> bitcast<u32>(1u)));
                                                let _e4657 = ((_e4641 >> bitcast<u32>(1u)) | ((_e4646 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4658 = (_e4640 + _e4657);
                                                if (_e4658 < _e4640) {
                                                    phi_6724_ = 1u;
                                                } else {
                                                    phi_6724_ = 0u;
                                                }
                                                let _e4661 = phi_6724_;
                                                let _e4663 = ((_e4637 + _e4654) + _e4661);
                                                let _e4671 = bitcast<u32>((bitcast<i32>(_e4663) >> bitcast<u32>(1u)));
                                                let _e4674 = ((_e4658 >> bitcast<u32>(1u)) | ((_e4663 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4675 = (2u * _e3036);
                                                let _e4686 = function_10(128u);
                                                if ((_e3032[0].member >> bitcast<u32>(31i)) != 0u) {
                                                    if (_e3032[0].member_1 == 0u) {
                                                        phi_6764_ = 1u;
                                                    } else {
                                                        phi_6764_ = 0u;
                                                    }
                                                    let _e4695 = phi_6764_;
                                                    phi_6771_ = type_9((~(_e3032[0].member) + _e4695), (~(_e3032[0].member_1) + 1u));
                                                } else {
                                                    phi_6771_ = _e3032[0];
                                                }
                                                let _e4702 = phi_6771_;
                                                if (_e4686.member_1 < _e4702.member_1) {
                                                    phi_6778_ = 1u;
                                                } else {
                                                    phi_6778_ = 0u;
                                                }
                                                let _e4707 = phi_6778_;
                                                if ((((_e4686.member - _e4702.member) - _e4707) >> bitcast<u32>(31i)) != 0u) {
                                                    if ((_e3032[0].member >> bitcast<u32>(31i)) != 0u) {
                                                        phi_6791_ = 2u;
                                                    } else {
                                                        phi_6791_ = 1u;
                                                    }
                                                    let _e4717 = phi_6791_;
                                                    phi_6792_ = _e4717;
                                                } else {
                                                    phi_6792_ = 0u;
                                                }
                                                let _e4719 = phi_6792_;
                                                let _e4720 = function_10(128u);
                                                if ((_e4570 >> bitcast<u32>(31i)) != 0u) {
                                                    if (_e4573 == 0u) {
                                                        phi_6807_ = 1u;
                                                    } else {
                                                        phi_6807_ = 0u;
                                                    }
                                                    let _e4729 = phi_6807_;
                                                    phi_6814_ = type_9((~(_e4570) + _e4729), (~(_e4573) + 1u));
                                                } else {
                                                    phi_6814_ = type_9(_e4570, _e4573);
                                                }
                                                let _e4736 = phi_6814_;
                                                if (_e4720.member_1 < _e4736.member_1) {
                                                    phi_6821_ = 1u;
                                                } else {
                                                    phi_6821_ = 0u;
                                                }
                                                let _e4741 = phi_6821_;
                                                if ((((_e4720.member - _e4736.member) - _e4741) >> bitcast<u32>(31i)) != 0u) {
                                                    if ((_e4570 >> bitcast<u32>(31i)) != 0u) {
                                                        phi_6834_ = 2u;
                                                    } else {
                                                        phi_6834_ = 1u;
                                                    }
                                                    let _e4751 = phi_6834_;
                                                    phi_6835_ = _e4751;
                                                } else {
                                                    phi_6835_ = 0u;
                                                }
                                                let _e4753 = phi_6835_;
                                                let _e4755 = function_10(128u);
                                                if ((_e4637 >> bitcast<u32>(31i)) != 0u) {
                                                    if (_e4640 == 0u) {
                                                        phi_6851_ = 1u;
                                                    } else {
                                                        phi_6851_ = 0u;
                                                    }
                                                    let _e4764 = phi_6851_;
                                                    phi_6858_ = type_9((~(_e4637) + _e4764), (~(_e4640) + 1u));
                                                } else {
                                                    phi_6858_ = type_9(_e4637, _e4640);
                                                }
                                                let _e4771 = phi_6858_;
                                                if (_e4755.member_1 < _e4771.member_1) {
                                                    phi_6865_ = 1u;
                                                } else {
                                                    phi_6865_ = 0u;
                                                }
                                                let _e4776 = phi_6865_;
                                                if ((((_e4755.member - _e4771.member) - _e4776) >> bitcast<u32>(31i)) != 0u) {
                                                    if ((_e4637 >> bitcast<u32>(31i)) != 0u) {
                                                        phi_6878_ = 2u;
                                                    } else {
                                                        phi_6878_ = 1u;
                                                    }
                                                    let _e4786 = phi_6878_;
                                                    phi_6879_ = _e4786;
                                                } else {
                                                    phi_6879_ = 0u;
                                                }
                                                let _e4788 = phi_6879_;
                                                let _e4790 = function_10(128u);
                                                if ((_e4671 >> bitcast<u32>(31i)) != 0u) {
                                                    if (_e4674 == 0u) {
                                                        phi_6895_ = 1u;
                                                    } else {
                                                        phi_6895_ = 0u;
                                                    }
                                                    let _e4799 = phi_6895_;
                                                    phi_6902_ = type_9((~(_e4671) + _e4799), (~(_e4674) + 1u));
                                                } else {
                                                    phi_6902_ = type_9(_e4671, _e4674);
                                                }
                                                let _e4806 = phi_6902_;
                                                if (_e4790.member_1 < _e4806.member_1) {
                                                    phi_6909_ = 1u;
                                                } else {
                                                    phi_6909_ = 0u;
                                                }
                                                let _e4811 = phi_6909_;
                                                if ((((_e4790.member - _e4806.member) - _e4811) >> bitcast<u32>(31i)) != 0u) {
                                                    if ((_e4671 >> bitcast<u32>(31i)) != 0u) {
                                                        phi_6922_ = 2u;
                                                    } else {
                                                        phi_6922_ = 1u;
                                                    }
                                                    let _e4821 = phi_6922_;
                                                    phi_6923_ = _e4821;
                                                } else {
                                                    phi_6923_ = 0u;
                                                }
                                                let _e4823 = phi_6923_;
                                                if ((((_e4719 & _e4753) & _e4788) & _e4823) != 0u) {
                                                    phi_6940_ = array<type_9, 4>(type_9(_e4671, _e4674), type_9(_e4654, _e4657), type_9(_e4620, _e4623), type_9(_e3032[3].member, _e3032[3].member_1));
                                                    phi_6941_ = (_e4675 + 1u);
                                                } else {
                                                    phi_6940_ = array<type_9, 4>(_e3032[0], type_9(_e4570, _e4573), type_9(_e4637, _e4640), type_9(_e4671, _e4674));
                                                    phi_6941_ = _e4675;
                                                }
                                                let _e4837 = phi_6940_;
                                                let _e4839 = phi_6941_;
                                                phi_6942_ = _e4837;
                                                phi_6944_ = (_e3034 + 1u);
                                                phi_6945_ = _e4839;
                                            }
                                            let _e4841 = phi_6942_;
                                            let _e4843 = phi_6944_;
                                            let _e4845 = phi_6945_;
                                            phi_6946_ = _e4841;
                                            phi_6948_ = _e4843;
                                            phi_6949_ = _e4845;
                                        } else {
                                            phi_6946_ = array<type_9, 4>();
                                            phi_6948_ = u32();
                                            phi_6949_ = u32();
                                        }
                                        let _e4847 = phi_6946_;
                                        let _e4849 = phi_6948_;
                                        let _e4851 = phi_6949_;
                                        phi_6950_ = _e4847;
                                        phi_6952_ = _e4538;
                                        phi_6953_ = _e4849;
                                        phi_6954_ = _e4851;
                                        phi_6955_ = _e4540;
                                        phi_6956_ = _e4542;
                                        phi_6957_ = _e4544;
                                        phi_6958_ = _e4546;
                                        phi_6959_ = _e4548;
                                    }
                                    let _e4853 = phi_6950_;
                                    let _e4855 = phi_6952_;
                                    let _e4857 = phi_6953_;
                                    let _e4859 = phi_6954_;
                                    let _e4861 = phi_6955_;
                                    let _e4863 = phi_6956_;
                                    let _e4865 = phi_6957_;
                                    let _e4867 = phi_6958_;
                                    let _e4869 = phi_6959_;
                                    if _e4869 {
                                        if _e4855 {
                                            let _e4870 = (_e4859 + 1u);
                                            let _e4872 = (_e4870 & (4294967295u - _e4859));
                                            let _e4878 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e4872)), 32u, (_e4872 == 0u)));
                                            if (_e4857 < _e4878) {
                                                phi_6978_ = _e4857;
                                            } else {
                                                phi_6978_ = _e4878;
                                            }
                                            let _e4881 = phi_6978_;
                                            let _e4884 = (_e4870 >> bitcast<u32>((_e4881 & 31u)));
                                            let _e4885 = (_e4857 - _e4881);
                                            if (_e4884 == 1u) {
                                                if (_e4885 == 0u) {
                                                    phi_6990_ = false;
                                                } else {
                                                    phi_6990_ = true;
                                                }
                                                let _e4889 = phi_6990_;
                                                phi_6991_ = _e4889;
                                            } else {
                                                phi_6991_ = true;
                                            }
                                            let _e4891 = phi_6991_;
                                            if _e4891 {
                                                let _e4892 = (31u - _e4885);
                                                let _e4895 = (_e4884 << bitcast<u32>((_e4892 & 31u)));
                                                let _e4899 = ((_e4884 + 1u) << bitcast<u32>((_e4892 & 31u)));
                                                if (_e2905 < _e2832.member_1) {
                                                    phi_7009_ = 1u;
                                                } else {
                                                    phi_7009_ = 0u;
                                                }
                                                let _e4902 = phi_7009_;
                                                let _e4906 = function_4(((_e2910 - _e2832.member) - _e4902), (_e2905 - _e2832.member_1), _e4895);
                                                let _e4909 = (_e2832.member_1 + _e4906.member_1);
                                                if (_e4909 < _e2832.member_1) {
                                                    phi_7021_ = 1u;
                                                } else {
                                                    phi_7021_ = 0u;
                                                }
                                                let _e4912 = phi_7021_;
                                                if (_e2981 < _e2905) {
                                                    phi_7032_ = 1u;
                                                } else {
                                                    phi_7032_ = 0u;
                                                }
                                                let _e4917 = phi_7032_;
                                                let _e4921 = function_4(((_e2986 - _e2910) - _e4917), (_e2981 - _e2905), _e4895);
                                                let _e4924 = (_e2905 + _e4921.member_1);
                                                if (_e4924 < _e2905) {
                                                    phi_7044_ = 1u;
                                                } else {
                                                    phi_7044_ = 0u;
                                                }
                                                let _e4927 = phi_7044_;
                                                if (_e3022.member_1 < _e2981) {
                                                    phi_7055_ = 1u;
                                                } else {
                                                    phi_7055_ = 0u;
                                                }
                                                let _e4932 = phi_7055_;
                                                let _e4936 = function_4(((_e3022.member - _e2986) - _e4932), (_e3022.member_1 - _e2981), _e4895);
                                                let _e4939 = (_e2981 + _e4936.member_1);
                                                if (_e4939 < _e2981) {
                                                    phi_7067_ = 1u;
                                                } else {
                                                    phi_7067_ = 0u;
                                                }
                                                let _e4942 = phi_7067_;
                                                let _e4948 = array<type_9, 3>(type_9(((_e2832.member + _e4906.member) + _e4912), _e4909), type_9(((_e2910 + _e4921.member) + _e4927), _e4924), type_9(((_e2986 + _e4936.member) + _e4942), _e4939));
                                                if (_e2905 < _e2832.member_1) {
                                                    phi_7084_ = 1u;
                                                } else {
                                                    phi_7084_ = 0u;
                                                }
                                                let _e4951 = phi_7084_;
                                                let _e4955 = function_4(((_e2910 - _e2832.member) - _e4951), (_e2905 - _e2832.member_1), _e4899);
                                                let _e4958 = (_e2832.member_1 + _e4955.member_1);
                                                if (_e4958 < _e2832.member_1) {
                                                    phi_7096_ = 1u;
                                                } else {
                                                    phi_7096_ = 0u;
                                                }
                                                let _e4961 = phi_7096_;
                                                if (_e2981 < _e2905) {
                                                    phi_7107_ = 1u;
                                                } else {
                                                    phi_7107_ = 0u;
                                                }
                                                let _e4966 = phi_7107_;
                                                let _e4970 = function_4(((_e2986 - _e2910) - _e4966), (_e2981 - _e2905), _e4899);
                                                let _e4973 = (_e2905 + _e4970.member_1);
                                                if (_e4973 < _e2905) {
                                                    phi_7119_ = 1u;
                                                } else {
                                                    phi_7119_ = 0u;
                                                }
                                                let _e4976 = phi_7119_;
                                                if (_e3022.member_1 < _e2981) {
                                                    phi_7130_ = 1u;
                                                } else {
                                                    phi_7130_ = 0u;
                                                }
                                                let _e4981 = phi_7130_;
                                                let _e4985 = function_4(((_e3022.member - _e2986) - _e4981), (_e3022.member_1 - _e2981), _e4899);
                                                let _e4988 = (_e2981 + _e4985.member_1);
                                                if (_e4988 < _e2981) {
                                                    phi_7142_ = 1u;
                                                } else {
                                                    phi_7142_ = 0u;
                                                }
                                                let _e4991 = phi_7142_;
                                                let _e4998 = function_5(_e4948, _e4895);
                                                let _e4999 = function_5(_e4948, _e4899);
                                                let _e5000 = function_5(array<type_9, 3>(type_9(((_e2832.member + _e4955.member) + _e4961), _e4958), type_9(((_e2910 + _e4970.member) + _e4976), _e4973), type_9(((_e2986 + _e4985.member) + _e4991), _e4988)), _e4899);
                                                if (_e4998[1].member_1 < _e4998[0].member_1) {
                                                    phi_7162_ = 1u;
                                                } else {
                                                    phi_7162_ = 0u;
                                                }
                                                let _e5011 = phi_7162_;
                                                let _e5015 = function_4(((_e4998[1].member - _e4998[0].member) - _e5011), (_e4998[1].member_1 - _e4998[0].member_1), _e4895);
                                                let _e5018 = (_e4998[0].member_1 + _e5015.member_1);
                                                if (_e5018 < _e4998[0].member_1) {
                                                    phi_7174_ = 1u;
                                                } else {
                                                    phi_7174_ = 0u;
                                                }
                                                let _e5021 = phi_7174_;
                                                if (_e4998[1].member_1 < _e4998[0].member_1) {
                                                    phi_7185_ = 1u;
                                                } else {
                                                    phi_7185_ = 0u;
                                                }
                                                let _e5034 = phi_7185_;
                                                let _e5038 = function_4(((_e4998[1].member - _e4998[0].member) - _e5034), (_e4998[1].member_1 - _e4998[0].member_1), _e4899);
                                                let _e5041 = (_e4998[0].member_1 + _e5038.member_1);
                                                if (_e5041 < _e4998[0].member_1) {
                                                    phi_7197_ = 1u;
                                                } else {
                                                    phi_7197_ = 0u;
                                                }
                                                let _e5044 = phi_7197_;
                                                if (_e4999[1].member_1 < _e4999[0].member_1) {
                                                    phi_7208_ = 1u;
                                                } else {
                                                    phi_7208_ = 0u;
                                                }
                                                let _e5057 = phi_7208_;
                                                let _e5061 = function_4(((_e4999[1].member - _e4999[0].member) - _e5057), (_e4999[1].member_1 - _e4999[0].member_1), _e4899);
                                                let _e5064 = (_e4999[0].member_1 + _e5061.member_1);
                                                if (_e5064 < _e4999[0].member_1) {
                                                    phi_7220_ = 1u;
                                                } else {
                                                    phi_7220_ = 0u;
                                                }
                                                let _e5067 = phi_7220_;
                                                if (_e5000[1].member_1 < _e5000[0].member_1) {
                                                    phi_7231_ = 1u;
                                                } else {
                                                    phi_7231_ = 0u;
                                                }
                                                let _e5080 = phi_7231_;
                                                let _e5084 = function_4(((_e5000[1].member - _e5000[0].member) - _e5080), (_e5000[1].member_1 - _e5000[0].member_1), _e4899);
                                                let _e5087 = (_e5000[0].member_1 + _e5084.member_1);
                                                if (_e5087 < _e5000[0].member_1) {
                                                    phi_7243_ = 1u;
                                                } else {
                                                    phi_7243_ = 0u;
                                                }
                                                let _e5090 = phi_7243_;
                                                phi_7254_ = array<type_9, 4>(type_9(((_e4998[0].member + _e5015.member) + _e5021), _e5018), type_9(((_e4998[0].member + _e5038.member) + _e5044), _e5041), type_9(((_e4999[0].member + _e5061.member) + _e5067), _e5064), type_9(((_e5000[0].member + _e5084.member) + _e5090), _e5087));
                                            } else {
                                                phi_7254_ = array<type_9, 4>();
                                            }
                                            let _e5099 = phi_7254_;
                                            phi_7255_ = _e5099;
                                            phi_7256_ = _e4885;
                                            phi_7257_ = _e4884;
                                            phi_7258_ = _e4891;
                                        } else {
                                            phi_7255_ = _e4853;
                                            phi_7256_ = _e4857;
                                            phi_7257_ = _e4859;
                                            phi_7258_ = true;
                                        }
                                        let _e5101 = phi_7255_;
                                        let _e5103 = phi_7256_;
                                        let _e5105 = phi_7257_;
                                        let _e5107 = phi_7258_;
                                        if _e5107 {
                                            phi_7262_ = false;
                                        } else {
                                            phi_7262_ = true;
                                        }
                                        let _e5109 = phi_7262_;
                                        phi_7263_ = _e5101;
                                        phi_7264_ = _e5103;
                                        phi_7265_ = _e5105;
                                        phi_7266_ = _e5107;
                                        phi_7267_ = _e5109;
                                        phi_7268_ = false;
                                    } else {
                                        phi_7263_ = array<type_9, 4>();
                                        phi_7264_ = u32();
                                        phi_7265_ = u32();
                                        phi_7266_ = false;
                                        phi_7267_ = false;
                                        phi_7268_ = true;
                                    }
                                    let _e5111 = phi_7263_;
                                    let _e5113 = phi_7264_;
                                    let _e5115 = phi_7265_;
                                    let _e5117 = phi_7266_;
                                    let _e5119 = phi_7267_;
                                    let _e5121 = phi_7268_;
                                    phi_7269_ = _e5111;
                                    phi_7271_ = _e5113;
                                    phi_7272_ = _e5115;
                                    phi_7273_ = _e4861;
                                    phi_7274_ = _e4863;
                                    phi_7275_ = _e4865;
                                    phi_7276_ = _e4867;
                                    phi_7277_ = _e5117;
                                    phi_7278_ = _e5119;
                                    phi_7279_ = _e5121;
                                }
                                let _e5123 = phi_7269_;
                                let _e5125 = phi_7271_;
                                let _e5127 = phi_7272_;
                                let _e5129 = phi_7273_;
                                let _e5131 = phi_7274_;
                                let _e5133 = phi_7275_;
                                let _e5135 = phi_7276_;
                                let _e5137 = phi_7277_;
                                let _e5139 = phi_7278_;
                                let _e5141 = phi_7279_;
                                phi_4556_ = _e5123;
                                phi_4560_ = _e5125;
                                phi_4562_ = _e5127;
                                phi_7280_ = _e3057;
                                phi_7281_ = _e5129;
                                phi_7282_ = _e5131;
                                phi_7283_ = _e5133;
                                phi_7284_ = _e5135;
                                phi_7285_ = _e5137;
                                phi_7286_ = _e3062;
                                phi_7287_ = false;
                                phi_7288_ = _e5139;
                                phi_7289_ = _e5141;
                            } else {
                                phi_4556_ = array<type_9, 4>();
                                phi_4560_ = u32();
                                phi_4562_ = u32();
                                phi_7280_ = u32();
                                phi_7281_ = bool();
                                phi_7282_ = bool();
                                phi_7283_ = u32();
                                phi_7284_ = u32();
                                phi_7285_ = false;
                                phi_7286_ = false;
                                phi_7287_ = true;
                                phi_7288_ = false;
                                phi_7289_ = false;
                            }
                            let _e5143 = phi_4556_;
                            let _e5145 = phi_4560_;
                            let _e5147 = phi_4562_;
                            let _e5149 = phi_7280_;
                            let _e5151 = phi_7281_;
                            let _e5153 = phi_7282_;
                            let _e5155 = phi_7283_;
                            let _e5157 = phi_7284_;
                            let _e5159 = phi_7285_;
                            let _e5161 = phi_7286_;
                            let _e5163 = phi_7287_;
                            let _e5165 = phi_7288_;
                            let _e5167 = phi_7289_;
                            local_62 = _e5161;
                            local_129 = _e5163;
                            local_130 = _e5165;
                            local_131 = _e5167;
                            local_132 = _e5161;
                            local_63 = _e5153;
                            local_64 = _e5155;
                            local_68 = _e5155;
                            local_69 = _e5155;
                            local_70 = _e5155;
                            local_71 = _e5155;
                            local_72 = _e5155;
                            local_73 = _e5155;
                            local_74 = _e5155;
                            local_75 = _e5155;
                            local_76 = _e5155;
                            local_77 = _e5155;
                            local_78 = _e5155;
                            local_79 = _e5155;
                            local_80 = _e5155;
                            local_133 = _e5151;
                            local_81 = _e5149;
                            local_82 = _e5155;
                            local_83 = _e5157;
                            local_84 = _e5149;
                            continue;
                            continuing {
                                phi_4552_ = _e3048;
                                phi_4555_ = _e5143;
                                phi_4559_ = _e5145;
                                phi_4561_ = _e5147;
                                break if !(_e5159);
                            }
                        }
                        let _e5170 = local_62;
                        if _e5170 {
                            phi_7294_ = type_9(0u, type_9().member_1);
                            phi_7295_ = false;
                            phi_7296_ = false;
                            phi_7297_ = false;
                        } else {
                            phi_7294_ = type_9();
                            let _e15788 = local_129;
                            phi_7295_ = _e15788;
                            let _e15791 = local_130;
                            phi_7296_ = _e15791;
                            let _e15794 = local_131;
                            phi_7297_ = _e15794;
                        }
                        let _e5174 = phi_7294_;
                        let _e5176 = phi_7295_;
                        let _e5178 = phi_7296_;
                        let _e5180 = phi_7297_;
                        if _e5176 {
                            phi_7302_ = type_9(2u, type_9().member_1);
                            phi_7303_ = false;
                            phi_7304_ = false;
                            phi_7305_ = false;
                        } else {
                            phi_7302_ = type_9();
                            phi_7303_ = _e5178;
                            phi_7304_ = _e5180;
                            let _e15800 = local_132;
                            phi_7305_ = _e15800;
                        }
                        let _e5184 = phi_7302_;
                        let _e5186 = phi_7303_;
                        let _e5188 = phi_7304_;
                        let _e5190 = phi_7305_;
                        if _e5186 {
                            phi_7310_ = type_9(0u, type_9().member_1);
                            phi_7311_ = false;
                            phi_7312_ = false;
                        } else {
                            phi_7310_ = type_9();
                            phi_7311_ = _e5188;
                            phi_7312_ = _e5190;
                        }
                        let _e5194 = phi_7310_;
                        let _e5196 = phi_7311_;
                        let _e5198 = phi_7312_;
                        if _e5196 {
                            let _e5200 = local_63;
                            if _e5200 {
                                let _e5202 = local_64;
                                if (_e5202 <= 2147483648u) {
                                    let _e5205 = local_65;
                                    let _e5209 = local_66;
                                    let _e5212 = function_10(128u);
                                    if ((_e5205[0].member >> bitcast<u32>(31i)) != 0u) {
                                        if (_e5209[0].member_1 == 0u) {
                                            phi_7337_ = 1u;
                                        } else {
                                            phi_7337_ = 0u;
                                        }
                                        let _e5223 = phi_7337_;
                                        phi_7344_ = type_9((~(_e5205[0].member) + _e5223), (~(_e5209[0].member_1) + 1u));
                                    } else {
                                        let _e5219 = local_67;
                                        phi_7344_ = _e5219[0];
                                    }
                                    let _e5230 = phi_7344_;
                                    if (_e5212.member_1 < _e5230.member_1) {
                                        phi_7351_ = 1u;
                                    } else {
                                        phi_7351_ = 0u;
                                    }
                                    let _e5235 = phi_7351_;
                                    if ((((_e5212.member - _e5230.member) - _e5235) >> bitcast<u32>(31i)) != 0u) {
                                        if ((_e5205[0].member >> bitcast<u32>(31i)) != 0u) {
                                            phi_7364_ = 2u;
                                        } else {
                                            phi_7364_ = 1u;
                                        }
                                        let _e5245 = phi_7364_;
                                        phi_7365_ = _e5245;
                                    } else {
                                        phi_7365_ = 0u;
                                    }
                                    let _e5247 = phi_7365_;
                                    if (_e2905 < _e2832.member_1) {
                                        phi_7374_ = 1u;
                                    } else {
                                        phi_7374_ = 0u;
                                    }
                                    let _e5250 = phi_7374_;
                                    let _e5255 = local_68;
                                    let _e5256 = function_4(((_e2910 - _e2832.member) - _e5250), (_e2905 - _e2832.member_1), _e5255);
                                    let _e5259 = (_e2832.member_1 + _e5256.member_1);
                                    if (_e5259 < _e2832.member_1) {
                                        phi_7386_ = 1u;
                                    } else {
                                        phi_7386_ = 0u;
                                    }
                                    let _e5262 = phi_7386_;
                                    if (_e2981 < _e2905) {
                                        phi_7397_ = 1u;
                                    } else {
                                        phi_7397_ = 0u;
                                    }
                                    let _e5267 = phi_7397_;
                                    let _e5272 = local_69;
                                    let _e5273 = function_4(((_e2986 - _e2910) - _e5267), (_e2981 - _e2905), _e5272);
                                    let _e5276 = (_e2905 + _e5273.member_1);
                                    if (_e5276 < _e2905) {
                                        phi_7409_ = 1u;
                                    } else {
                                        phi_7409_ = 0u;
                                    }
                                    let _e5279 = phi_7409_;
                                    if (_e3022.member_1 < _e2981) {
                                        phi_7420_ = 1u;
                                    } else {
                                        phi_7420_ = 0u;
                                    }
                                    let _e5284 = phi_7420_;
                                    let _e5289 = local_70;
                                    let _e5290 = function_4(((_e3022.member - _e2986) - _e5284), (_e3022.member_1 - _e2981), _e5289);
                                    let _e5293 = (_e2981 + _e5290.member_1);
                                    if (_e5293 < _e2981) {
                                        phi_7432_ = 1u;
                                    } else {
                                        phi_7432_ = 0u;
                                    }
                                    let _e5296 = phi_7432_;
                                    let _e5302 = array<type_9, 3>(type_9(((_e2832.member + _e5256.member) + _e5262), _e5259), type_9(((_e2910 + _e5273.member) + _e5279), _e5276), type_9(((_e2986 + _e5290.member) + _e5296), _e5293));
                                    if (_e2905 < _e2832.member_1) {
                                        phi_7449_ = 1u;
                                    } else {
                                        phi_7449_ = 0u;
                                    }
                                    let _e5305 = phi_7449_;
                                    let _e5310 = local_71;
                                    let _e5311 = function_4(((_e2910 - _e2832.member) - _e5305), (_e2905 - _e2832.member_1), _e5310);
                                    let _e5314 = (_e2832.member_1 + _e5311.member_1);
                                    if (_e5314 < _e2832.member_1) {
                                        phi_7461_ = 1u;
                                    } else {
                                        phi_7461_ = 0u;
                                    }
                                    let _e5317 = phi_7461_;
                                    if (_e2981 < _e2905) {
                                        phi_7472_ = 1u;
                                    } else {
                                        phi_7472_ = 0u;
                                    }
                                    let _e5322 = phi_7472_;
                                    let _e5327 = local_72;
                                    let _e5328 = function_4(((_e2986 - _e2910) - _e5322), (_e2981 - _e2905), _e5327);
                                    let _e5331 = (_e2905 + _e5328.member_1);
                                    if (_e5331 < _e2905) {
                                        phi_7484_ = 1u;
                                    } else {
                                        phi_7484_ = 0u;
                                    }
                                    let _e5334 = phi_7484_;
                                    if (_e3022.member_1 < _e2981) {
                                        phi_7495_ = 1u;
                                    } else {
                                        phi_7495_ = 0u;
                                    }
                                    let _e5339 = phi_7495_;
                                    let _e5344 = local_73;
                                    let _e5345 = function_4(((_e3022.member - _e2986) - _e5339), (_e3022.member_1 - _e2981), _e5344);
                                    let _e5348 = (_e2981 + _e5345.member_1);
                                    if (_e5348 < _e2981) {
                                        phi_7507_ = 1u;
                                    } else {
                                        phi_7507_ = 0u;
                                    }
                                    let _e5351 = phi_7507_;
                                    let _e5359 = local_74;
                                    let _e5360 = function_5(_e5302, _e5359);
                                    let _e5362 = local_75;
                                    let _e5363 = function_5(_e5302, _e5362);
                                    let _e5365 = local_76;
                                    let _e5366 = function_5(array<type_9, 3>(type_9(((_e2832.member + _e5311.member) + _e5317), _e5314), type_9(((_e2910 + _e5328.member) + _e5334), _e5331), type_9(((_e2986 + _e5345.member) + _e5351), _e5348)), _e5365);
                                    if (_e5360[1].member_1 < _e5360[0].member_1) {
                                        phi_7527_ = 1u;
                                    } else {
                                        phi_7527_ = 0u;
                                    }
                                    let _e5377 = phi_7527_;
                                    let _e5382 = local_77;
                                    let _e5383 = function_4(((_e5360[1].member - _e5360[0].member) - _e5377), (_e5360[1].member_1 - _e5360[0].member_1), _e5382);
                                    let _e5386 = (_e5360[0].member_1 + _e5383.member_1);
                                    if (_e5386 < _e5360[0].member_1) {
                                        phi_7539_ = 1u;
                                    } else {
                                        phi_7539_ = 0u;
                                    }
                                    let _e5389 = phi_7539_;
                                    let _e5391 = ((_e5360[0].member + _e5383.member) + _e5389);
                                    if (_e5360[1].member_1 < _e5360[0].member_1) {
                                        phi_7550_ = 1u;
                                    } else {
                                        phi_7550_ = 0u;
                                    }
                                    let _e5402 = phi_7550_;
                                    let _e5407 = local_78;
                                    let _e5408 = function_4(((_e5360[1].member - _e5360[0].member) - _e5402), (_e5360[1].member_1 - _e5360[0].member_1), _e5407);
                                    if (_e5363[1].member_1 < _e5363[0].member_1) {
                                        phi_7573_ = 1u;
                                    } else {
                                        phi_7573_ = 0u;
                                    }
                                    let _e5419 = phi_7573_;
                                    let _e5424 = local_79;
                                    let _e5425 = function_4(((_e5363[1].member - _e5363[0].member) - _e5419), (_e5363[1].member_1 - _e5363[0].member_1), _e5424);
                                    if (_e5366[1].member_1 < _e5366[0].member_1) {
                                        phi_7596_ = 1u;
                                    } else {
                                        phi_7596_ = 0u;
                                    }
                                    let _e5436 = phi_7596_;
                                    let _e5441 = local_80;
                                    let _e5442 = function_4(((_e5366[1].member - _e5366[0].member) - _e5436), (_e5366[1].member_1 - _e5366[0].member_1), _e5441);
                                    let _e5443 = function_10(128u);
                                    if ((_e5391 >> bitcast<u32>(31i)) != 0u) {
                                        if (_e5386 == 0u) {
                                            phi_7633_ = 1u;
                                        } else {
                                            phi_7633_ = 0u;
                                        }
                                        let _e5452 = phi_7633_;
                                        phi_7640_ = type_9((~(_e5391) + _e5452), (~(_e5386) + 1u));
                                    } else {
                                        phi_7640_ = type_9(_e5391, _e5386);
                                    }
                                    let _e5459 = phi_7640_;
                                    if (_e5443.member_1 < _e5459.member_1) {
                                        phi_7647_ = 1u;
                                    } else {
                                        phi_7647_ = 0u;
                                    }
                                    let _e5464 = phi_7647_;
                                    if ((((_e5443.member - _e5459.member) - _e5464) >> bitcast<u32>(31i)) != 0u) {
                                        if ((_e5391 >> bitcast<u32>(31i)) != 0u) {
                                            phi_7660_ = 2u;
                                        } else {
                                            phi_7660_ = 1u;
                                        }
                                        let _e5474 = phi_7660_;
                                        phi_7661_ = _e5474;
                                    } else {
                                        phi_7661_ = 0u;
                                    }
                                    let _e5476 = phi_7661_;
                                    phi_7664_ = ((_e5247 | _e5476) == 3u);
                                    phi_7665_ = false;
                                } else {
                                    phi_7664_ = bool();
                                    phi_7665_ = true;
                                }
                                let _e5480 = phi_7664_;
                                let _e5482 = phi_7665_;
                                phi_7666_ = _e5480;
                                phi_7667_ = _e5482;
                            } else {
                                phi_7666_ = bool();
                                phi_7667_ = true;
                            }
                            let _e5484 = phi_7666_;
                            let _e5486 = phi_7667_;
                            if _e5486 {
                                let _e15855 = local_133;
                                phi_7671_ = _e15855;
                            } else {
                                phi_7671_ = _e5484;
                            }
                            let _e5488 = phi_7671_;
                            let _e5490 = local_81;
                            if (_e5490 >= _e1451) {
                                let _e5493 = local_82;
                                phi_7677_ = (_e5493 <= _e1453);
                            } else {
                                phi_7677_ = false;
                            }
                            let _e5496 = phi_7677_;
                            if _e5488 {
                                if _e5496 {
                                    let _e5498 = local_83;
                                    phi_7685_ = (_e5498 == 0u);
                                    phi_7686_ = false;
                                } else {
                                    phi_7685_ = bool();
                                    phi_7686_ = true;
                                }
                                let _e5501 = phi_7685_;
                                let _e5503 = phi_7686_;
                                phi_7687_ = _e5501;
                                phi_7688_ = _e5503;
                            } else {
                                phi_7687_ = bool();
                                phi_7688_ = true;
                            }
                            let _e5505 = phi_7687_;
                            let _e5507 = phi_7688_;
                            if _e5507 {
                                phi_7692_ = false;
                            } else {
                                phi_7692_ = _e5505;
                            }
                            let _e5509 = phi_7692_;
                            if _e5509 {
                                let _e5513 = local_84;
                                phi_7698_ = type_9(1u, _e5513);
                            } else {
                                phi_7698_ = type_9(2u, type_9().member_1);
                            }
                            let _e5516 = phi_7698_;
                            phi_7699_ = _e5516;
                            phi_7700_ = true;
                            phi_7701_ = false;
                        } else {
                            phi_7699_ = _e5194;
                            phi_7700_ = _e5186;
                            phi_7701_ = _e5198;
                        }
                        let _e5518 = phi_7699_;
                        let _e5520 = phi_7700_;
                        let _e5522 = phi_7701_;
                        if _e5520 {
                            phi_7705_ = _e5518;
                            phi_7706_ = true;
                        } else {
                            phi_7705_ = _e5174;
                            phi_7706_ = _e5522;
                        }
                        let _e5524 = phi_7705_;
                        let _e5526 = phi_7706_;
                        if _e5526 {
                            phi_7710_ = _e5524;
                        } else {
                            phi_7710_ = _e5184;
                        }
                        let _e5528 = phi_7710_;
                        switch bitcast<i32>(_e5528.member) {
                            case 0: {
                                phi_7747_ = type_28(0u, 0u, array<u32, 2>(0u, 0u), false);
                                break;
                            }
                            case 1: {
                                if (_e5528.member_1 > _e1451) {
                                    phi_7723_ = 1u;
                                } else {
                                    phi_7723_ = 0u;
                                }
                                let _e5534 = phi_7723_;
                                if (_e5528.member_1 == 0u) {
                                    phi_7741_ = array<u32, 2>(0u, 0u);
                                } else {
                                    let _e5540 = select((bitcast<u32>(31i) - firstLeadingBit(_e5528.member_1)), 32u, (_e5528.member_1 == 0u));
                                    let _e5545 = ((_e5528.member_1 << bitcast<u32>((_e5540 & 31u))) << bitcast<u32>(1i));
                                    phi_7741_ = array<u32, 2>((_e5545 << bitcast<u32>(20i)), (((1023u - _e5540) << bitcast<u32>(20i)) | (_e5545 >> bitcast<u32>(12i))));
                                }
                                let _e5556 = phi_7741_;
                                phi_7747_ = type_28(0u, _e5534, _e5556, true);
                                break;
                            }
                            case 2: {
                                phi_7747_ = type_28(1u, 0u, array<u32, 2>(0u, 0u), true);
                                break;
                            }
                            default: {
                                phi_7747_ = type_28();
                                break;
                            }
                        }
                        let _e5559 = phi_7747_;
                        if (_e5559.member == 0u) {
                            phi_7753_ = false;
                        } else {
                            phi_7753_ = true;
                        }
                        let _e5563 = phi_7753_;
                        phi_7754_ = _e5559;
                        phi_7755_ = _e5563;
                    } else {
                        phi_7754_ = type_28();
                        phi_7755_ = true;
                    }
                    let _e5565 = phi_7754_;
                    let _e5567 = phi_7755_;
                    phi_7756_ = _e5565;
                    phi_7757_ = _e5567;
                } else {
                    phi_7756_ = type_28();
                    phi_7757_ = true;
                }
                let _e5569 = phi_7756_;
                let _e5571 = phi_7757_;
                if _e5571 {
                    let _e5573 = params.member.member.member_12;
                    let _e5574 = bitcast<u32>(_e5573);
                    let _e5575 = (_e5574 & 2147483647u);
                    if (_e5575 < 8388608u) {
                        phi_7775_ = array<u32, 2>(0u, 0u);
                    } else {
                        phi_7775_ = array<u32, 2>((_e5574 << bitcast<u32>(29i)), ((_e5574 ^ _e5575) | ((_e5575 >> bitcast<u32>(3i)) + 939524096u)));
                    }
                    let _e5586 = phi_7775_;
                    let _e5590 = params.member.member.member_15[0u];
                    if (_e5586[0] == _e5590) {
                        let _e5595 = params.member.member.member_15[1u];
                        phi_7789_ = (_e5586[1] == _e5595);
                    } else {
                        phi_7789_ = false;
                    }
                    let _e5598 = phi_7789_;
                    let _e5600 = params.member.member.member_5;
                    let _e5602 = params.member.member.member_11;
                    let _e5604 = params.member.member.member_12;
                    let _e5606 = params.member.member.member_13;
                    let _e5608 = params.member.member.member_1;
                    if ((_e5608 & 64u) != 0u) {
                        phi_7805_ = _e5598;
                    } else {
                        phi_7805_ = false;
                    }
                    let _e5612 = phi_7805_;
                    if (_e561.member[0][0] < 0f) {
                        phi_7813_ = -(_e561.member[0][0]);
                    } else {
                        phi_7813_ = _e561.member[0][0];
                    }
                    let _e5619 = phi_7813_;
                    if (_e561.member[0][1] < 0f) {
                        phi_7820_ = -(_e561.member[0][1]);
                    } else {
                        phi_7820_ = _e561.member[0][1];
                    }
                    let _e5624 = phi_7820_;
                    if (_e5619 > _e5624) {
                        phi_7825_ = _e5619;
                    } else {
                        phi_7825_ = _e5624;
                    }
                    let _e5627 = phi_7825_;
                    if (_e561.member[0][2] < 0f) {
                        phi_7832_ = -(_e561.member[0][2]);
                    } else {
                        phi_7832_ = _e561.member[0][2];
                    }
                    let _e5632 = phi_7832_;
                    if (_e5627 > _e5632) {
                        phi_7837_ = _e5627;
                    } else {
                        phi_7837_ = _e5632;
                    }
                    let _e5635 = phi_7837_;
                    if (_e561.member[1][0] < 0f) {
                        phi_7845_ = -(_e561.member[1][0]);
                    } else {
                        phi_7845_ = _e561.member[1][0];
                    }
                    let _e5642 = phi_7845_;
                    if (_e561.member[1][1] < 0f) {
                        phi_7852_ = -(_e561.member[1][1]);
                    } else {
                        phi_7852_ = _e561.member[1][1];
                    }
                    let _e5647 = phi_7852_;
                    if (_e5642 > _e5647) {
                        phi_7857_ = _e5642;
                    } else {
                        phi_7857_ = _e5647;
                    }
                    let _e5650 = phi_7857_;
                    if (_e561.member[1][2] < 0f) {
                        phi_7864_ = -(_e561.member[1][2]);
                    } else {
                        phi_7864_ = _e561.member[1][2];
                    }
                    let _e5655 = phi_7864_;
                    if (_e5650 > _e5655) {
                        phi_7869_ = _e5650;
                    } else {
                        phi_7869_ = _e5655;
                    }
                    let _e5658 = phi_7869_;
                    if (_e5635 > _e5658) {
                        phi_7874_ = _e5635;
                    } else {
                        phi_7874_ = _e5658;
                    }
                    let _e5661 = phi_7874_;
                    let _e5663 = (_e5661 + _e561.member_3);
                    if (_e561.member_1[0][0] < 0f) {
                        phi_7884_ = -(_e561.member_1[0][0]);
                    } else {
                        phi_7884_ = _e561.member_1[0][0];
                    }
                    let _e5670 = phi_7884_;
                    if (_e561.member_1[0][1] < 0f) {
                        phi_7891_ = -(_e561.member_1[0][1]);
                    } else {
                        phi_7891_ = _e561.member_1[0][1];
                    }
                    let _e5675 = phi_7891_;
                    if (_e5670 > _e5675) {
                        phi_7896_ = _e5670;
                    } else {
                        phi_7896_ = _e5675;
                    }
                    let _e5678 = phi_7896_;
                    if (_e561.member_1[0][2] < 0f) {
                        phi_7903_ = -(_e561.member_1[0][2]);
                    } else {
                        phi_7903_ = _e561.member_1[0][2];
                    }
                    let _e5683 = phi_7903_;
                    if (_e5678 > _e5683) {
                        phi_7908_ = _e5678;
                    } else {
                        phi_7908_ = _e5683;
                    }
                    let _e5686 = phi_7908_;
                    if (_e561.member_1[1][0] < 0f) {
                        phi_7916_ = -(_e561.member_1[1][0]);
                    } else {
                        phi_7916_ = _e561.member_1[1][0];
                    }
                    let _e5693 = phi_7916_;
                    if (_e561.member_1[1][1] < 0f) {
                        phi_7923_ = -(_e561.member_1[1][1]);
                    } else {
                        phi_7923_ = _e561.member_1[1][1];
                    }
                    let _e5698 = phi_7923_;
                    if (_e5693 > _e5698) {
                        phi_7928_ = _e5693;
                    } else {
                        phi_7928_ = _e5698;
                    }
                    let _e5701 = phi_7928_;
                    if (_e561.member_1[1][2] < 0f) {
                        phi_7935_ = -(_e561.member_1[1][2]);
                    } else {
                        phi_7935_ = _e561.member_1[1][2];
                    }
                    let _e5706 = phi_7935_;
                    if (_e5701 > _e5706) {
                        phi_7940_ = _e5701;
                    } else {
                        phi_7940_ = _e5706;
                    }
                    let _e5709 = phi_7940_;
                    if (_e5686 > _e5709) {
                        phi_7945_ = _e5686;
                    } else {
                        phi_7945_ = _e5709;
                    }
                    let _e5712 = phi_7945_;
                    let _e5714 = (_e5712 + _e561.member_3);
                    if (_e561.member_2[0][0] < 0f) {
                        phi_7955_ = -(_e561.member_2[0][0]);
                    } else {
                        phi_7955_ = _e561.member_2[0][0];
                    }
                    let _e5721 = phi_7955_;
                    if (_e561.member_2[0][1] < 0f) {
                        phi_7962_ = -(_e561.member_2[0][1]);
                    } else {
                        phi_7962_ = _e561.member_2[0][1];
                    }
                    let _e5726 = phi_7962_;
                    if (_e5721 > _e5726) {
                        phi_7967_ = _e5721;
                    } else {
                        phi_7967_ = _e5726;
                    }
                    let _e5729 = phi_7967_;
                    if (_e561.member_2[0][2] < 0f) {
                        phi_7974_ = -(_e561.member_2[0][2]);
                    } else {
                        phi_7974_ = _e561.member_2[0][2];
                    }
                    let _e5734 = phi_7974_;
                    if (_e5729 > _e5734) {
                        phi_7979_ = _e5729;
                    } else {
                        phi_7979_ = _e5734;
                    }
                    let _e5737 = phi_7979_;
                    if (_e561.member_2[1][0] < 0f) {
                        phi_7987_ = -(_e561.member_2[1][0]);
                    } else {
                        phi_7987_ = _e561.member_2[1][0];
                    }
                    let _e5744 = phi_7987_;
                    if (_e561.member_2[1][1] < 0f) {
                        phi_7994_ = -(_e561.member_2[1][1]);
                    } else {
                        phi_7994_ = _e561.member_2[1][1];
                    }
                    let _e5749 = phi_7994_;
                    if (_e5744 > _e5749) {
                        phi_7999_ = _e5744;
                    } else {
                        phi_7999_ = _e5749;
                    }
                    let _e5752 = phi_7999_;
                    if (_e561.member_2[1][2] < 0f) {
                        phi_8006_ = -(_e561.member_2[1][2]);
                    } else {
                        phi_8006_ = _e561.member_2[1][2];
                    }
                    let _e5757 = phi_8006_;
                    if (_e5752 > _e5757) {
                        phi_8011_ = _e5752;
                    } else {
                        phi_8011_ = _e5757;
                    }
                    let _e5760 = phi_8011_;
                    if (_e5737 > _e5760) {
                        phi_8016_ = _e5737;
                    } else {
                        phi_8016_ = _e5760;
                    }
                    let _e5763 = phi_8016_;
                    let _e5765 = (_e5763 + _e561.member_3);
                    if (_e5663 > _e5714) {
                        phi_8023_ = _e5663;
                    } else {
                        phi_8023_ = _e5714;
                    }
                    let _e5768 = phi_8023_;
                    if (_e5768 > _e5765) {
                        phi_8028_ = _e5768;
                    } else {
                        phi_8028_ = _e5765;
                    }
                    let _e5771 = phi_8028_;
                    if (_e5771 <= 65536f) {
                        phi_8035_ = (_e5771 >= (1f / 65536f));
                    } else {
                        phi_8035_ = false;
                    }
                    let _e5776 = phi_8035_;
                    if _e5776 {
                        phi_8133_ = type_43();
                        phi_8134_ = true;
                    } else {
                        if (_e5771 >= 0.000000000000000000000000000000000000011754944f) {
                            if ((bitcast<u32>(_e5771) & 2139095040u) != 2139095040u) {
                                let _e5783 = (2130706432u - (bitcast<u32>(_e5771) & 2139095040u));
                                if (_e5783 > 8388608u) {
                                    phi_8059_ = _e5783;
                                } else {
                                    phi_8059_ = 8388608u;
                                }
                                let _e5786 = phi_8059_;
                                let _e5787 = bitcast<f32>(_e5786);
                                let _e5788 = (_e5600 * _e5787);
                                if (_e5600 > 0f) {
                                    if (_e5788 > 0.000000000000000000000000000000000000011754944f) {
                                        phi_8070_ = _e5788;
                                    } else {
                                        phi_8070_ = 0.000000000000000000000000000000000000011754944f;
                                    }
                                    let _e5792 = phi_8070_;
                                    phi_8071_ = _e5792;
                                } else {
                                    phi_8071_ = _e5788;
                                }
                                let _e5794 = phi_8071_;
                                phi_8129_ = type_43(type_23(array<array<f32, 3>, 2>(array<f32, 3>((_e561.member[0][0] * _e5787), (_e561.member[0][1] * _e5787), (_e561.member[0][2] * _e5787)), array<f32, 3>((_e561.member[1][0] * _e5787), (_e561.member[1][1] * _e5787), (_e561.member[1][2] * _e5787))), array<array<f32, 3>, 2>(array<f32, 3>((_e561.member_1[0][0] * _e5787), (_e561.member_1[0][1] * _e5787), (_e561.member_1[0][2] * _e5787)), array<f32, 3>((_e561.member_1[1][0] * _e5787), (_e561.member_1[1][1] * _e5787), (_e561.member_1[1][2] * _e5787))), array<array<f32, 3>, 2>(array<f32, 3>((_e561.member_2[0][0] * _e5787), (_e561.member_2[0][1] * _e5787), (_e561.member_2[0][2] * _e5787)), array<f32, 3>((_e561.member_2[1][0] * _e5787), (_e561.member_2[1][1] * _e5787), (_e561.member_2[1][2] * _e5787))), ((_e561.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e5787)), _e5794);
                                phi_8130_ = false;
                            } else {
                                phi_8129_ = type_43();
                                phi_8130_ = true;
                            }
                            let _e5859 = phi_8129_;
                            let _e5861 = phi_8130_;
                            phi_8131_ = _e5859;
                            phi_8132_ = _e5861;
                        } else {
                            phi_8131_ = type_43();
                            phi_8132_ = true;
                        }
                        let _e5863 = phi_8131_;
                        let _e5865 = phi_8132_;
                        phi_8133_ = _e5863;
                        phi_8134_ = _e5865;
                    }
                    let _e5867 = phi_8133_;
                    let _e5869 = phi_8134_;
                    if _e5869 {
                        phi_8139_ = type_43(_e561, _e5600);
                    } else {
                        phi_8139_ = _e5867;
                    }
                    let _e5872 = phi_8139_;
                    local_18 = type_23(array<array<f32, 3>, 2>(array<f32, 3>(_e5872.member.member[0][0], _e5872.member.member[0][1], _e5872.member.member[0][2]), array<f32, 3>(_e5872.member.member[1][0], _e5872.member.member[1][1], _e5872.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e5872.member.member_1[0][0], _e5872.member.member_1[0][1], _e5872.member.member_1[0][2]), array<f32, 3>(_e5872.member.member_1[1][0], _e5872.member.member_1[1][1], _e5872.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e5872.member.member_2[0][0], _e5872.member.member_2[0][1], _e5872.member.member_2[0][2]), array<f32, 3>(_e5872.member.member_2[1][0], _e5872.member.member_2[1][1], _e5872.member.member_2[1][2])), _e5872.member.member_3);
                    if (_e5872.member_1 > 0f) {
                        let _e10637 = local_18.member[0u];
                        let _e10643 = local_18.member[1u];
                        let _e10659 = local_18.member_1[0u];
                        let _e10665 = local_18.member_1[1u];
                        let _e10681 = local_18.member_2[0u];
                        let _e10687 = local_18.member_2[1u];
                        let _e10701 = function_3(array<f32, 3>((_e10637[0] + ((_e10643[0] - _e10637[0]) * _e5604)), (_e10637[1] + ((_e10643[1] - _e10637[1]) * _e5604)), (_e10637[2] + ((_e10643[2] - _e10637[2]) * _e5604))), array<f32, 3>((_e10659[0] + ((_e10665[0] - _e10659[0]) * _e5604)), (_e10659[1] + ((_e10665[1] - _e10659[1]) * _e5604)), (_e10659[2] + ((_e10665[2] - _e10659[2]) * _e5604))), array<f32, 3>((_e10681[0] + ((_e10687[0] - _e10681[0]) * _e5604)), (_e10681[1] + ((_e10687[1] - _e10681[1]) * _e5604)), (_e10681[2] + ((_e10687[2] - _e10681[2]) * _e5604))), _e316.member);
                        let _e10712 = (((_e10701[0] * _e10701[0]) + (_e10701[1] * _e10701[1])) + (_e10701[2] * _e10701[2]));
                        if (_e10712 <= 0.000000000000000000000000000000000000011754944f) {
                            if (_e10712 > 0f) {
                                phi_8306_ = (0.000000000000000000106433627f * 2f);
                            } else {
                                phi_8306_ = 0f;
                            }
                            let _e10765 = phi_8306_;
                            phi_8370_ = _e10765;
                        } else {
                            phi_8313_ = type_14(0i, 5i);
                            phi_8316_ = bitcast<f32>(((bitcast<u32>(_e10712) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e10720 = phi_8313_;
                                let _e10722 = phi_8316_;
                                local_105 = _e10722;
                                if (_e10720.member < _e10720.member_1) {
                                    let _e10729 = (_e10720.member + 1i);
                                    if ((false == (_e10729 > _e10720.member)) != false) {
                                        phi_8337_ = true;
                                    } else {
                                        phi_8337_ = false;
                                    }
                                    let _e10734 = phi_8337_;
                                    if _e10734 {
                                        phi_8343_ = type_15(0u, type_15().member_1);
                                    } else {
                                        phi_8343_ = type_15(1u, _e10729);
                                    }
                                    let _e10739 = phi_8343_;
                                    phi_8314_ = type_14(_e10739.member_1, _e10720.member_1);
                                    phi_8357_ = type_15(1u, _e10720.member);
                                } else {
                                    phi_8314_ = _e10720;
                                    phi_8357_ = type_15(0u, type_15().member_1);
                                }
                                let _e10745 = phi_8314_;
                                let _e10747 = phi_8357_;
                                let _e10750 = (bitcast<i32>(_e10747.member) != 0i);
                                if _e10750 {
                                    phi_8317_ = (0.5f * (_e10722 + (_e10712 / _e10722)));
                                } else {
                                    phi_8317_ = f32();
                                }
                                let _e10755 = phi_8317_;
                                continue;
                                continuing {
                                    phi_8313_ = _e10745;
                                    phi_8316_ = _e10755;
                                    break if !(_e10750);
                                }
                            }
                            let _e10760 = local_105;
                            phi_8370_ = (_e10760 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e10767 = phi_8370_;
                        let _e10773 = local_18.member[0u];
                        if (_e10773[0] < 0f) {
                            phi_8386_ = -(_e10773[0]);
                        } else {
                            phi_8386_ = _e10773[0];
                        }
                        let _e10780 = phi_8386_;
                        if (_e10773[1] < 0f) {
                            phi_8393_ = -(_e10773[1]);
                        } else {
                            phi_8393_ = _e10773[1];
                        }
                        let _e10784 = phi_8393_;
                        if (_e10780 > _e10784) {
                            phi_8398_ = _e10780;
                        } else {
                            phi_8398_ = _e10784;
                        }
                        let _e10787 = phi_8398_;
                        if (_e10773[2] < 0f) {
                            phi_8405_ = -(_e10773[2]);
                        } else {
                            phi_8405_ = _e10773[2];
                        }
                        let _e10791 = phi_8405_;
                        if (_e10787 > _e10791) {
                            phi_8410_ = _e10787;
                        } else {
                            phi_8410_ = _e10791;
                        }
                        let _e10794 = phi_8410_;
                        let _e10797 = local_18.member[1u];
                        if (_e10797[0] < 0f) {
                            phi_8423_ = -(_e10797[0]);
                        } else {
                            phi_8423_ = _e10797[0];
                        }
                        let _e10804 = phi_8423_;
                        if (_e10797[1] < 0f) {
                            phi_8430_ = -(_e10797[1]);
                        } else {
                            phi_8430_ = _e10797[1];
                        }
                        let _e10808 = phi_8430_;
                        if (_e10804 > _e10808) {
                            phi_8435_ = _e10804;
                        } else {
                            phi_8435_ = _e10808;
                        }
                        let _e10811 = phi_8435_;
                        if (_e10797[2] < 0f) {
                            phi_8442_ = -(_e10797[2]);
                        } else {
                            phi_8442_ = _e10797[2];
                        }
                        let _e10815 = phi_8442_;
                        if (_e10811 > _e10815) {
                            phi_8447_ = _e10811;
                        } else {
                            phi_8447_ = _e10815;
                        }
                        let _e10818 = phi_8447_;
                        if (_e10794 > _e10818) {
                            phi_8452_ = _e10794;
                        } else {
                            phi_8452_ = _e10818;
                        }
                        let _e10821 = phi_8452_;
                        let _e10823 = local_18.member_3;
                        let _e10827 = local_18.member_1[0u];
                        if (_e10827[0] < 0f) {
                            phi_8469_ = -(_e10827[0]);
                        } else {
                            phi_8469_ = _e10827[0];
                        }
                        let _e10834 = phi_8469_;
                        if (_e10827[1] < 0f) {
                            phi_8476_ = -(_e10827[1]);
                        } else {
                            phi_8476_ = _e10827[1];
                        }
                        let _e10838 = phi_8476_;
                        if (_e10834 > _e10838) {
                            phi_8481_ = _e10834;
                        } else {
                            phi_8481_ = _e10838;
                        }
                        let _e10841 = phi_8481_;
                        if (_e10827[2] < 0f) {
                            phi_8488_ = -(_e10827[2]);
                        } else {
                            phi_8488_ = _e10827[2];
                        }
                        let _e10845 = phi_8488_;
                        if (_e10841 > _e10845) {
                            phi_8493_ = _e10841;
                        } else {
                            phi_8493_ = _e10845;
                        }
                        let _e10848 = phi_8493_;
                        let _e10851 = local_18.member_1[1u];
                        if (_e10851[0] < 0f) {
                            phi_8507_ = -(_e10851[0]);
                        } else {
                            phi_8507_ = _e10851[0];
                        }
                        let _e10858 = phi_8507_;
                        if (_e10851[1] < 0f) {
                            phi_8514_ = -(_e10851[1]);
                        } else {
                            phi_8514_ = _e10851[1];
                        }
                        let _e10862 = phi_8514_;
                        if (_e10858 > _e10862) {
                            phi_8519_ = _e10858;
                        } else {
                            phi_8519_ = _e10862;
                        }
                        let _e10865 = phi_8519_;
                        if (_e10851[2] < 0f) {
                            phi_8526_ = -(_e10851[2]);
                        } else {
                            phi_8526_ = _e10851[2];
                        }
                        let _e10869 = phi_8526_;
                        if (_e10865 > _e10869) {
                            phi_8531_ = _e10865;
                        } else {
                            phi_8531_ = _e10869;
                        }
                        let _e10872 = phi_8531_;
                        if (_e10848 > _e10872) {
                            phi_8536_ = _e10848;
                        } else {
                            phi_8536_ = _e10872;
                        }
                        let _e10875 = phi_8536_;
                        let _e10877 = local_18.member_3;
                        let _e10881 = local_18.member_2[0u];
                        if (_e10881[0] < 0f) {
                            phi_8553_ = -(_e10881[0]);
                        } else {
                            phi_8553_ = _e10881[0];
                        }
                        let _e10888 = phi_8553_;
                        if (_e10881[1] < 0f) {
                            phi_8560_ = -(_e10881[1]);
                        } else {
                            phi_8560_ = _e10881[1];
                        }
                        let _e10892 = phi_8560_;
                        if (_e10888 > _e10892) {
                            phi_8565_ = _e10888;
                        } else {
                            phi_8565_ = _e10892;
                        }
                        let _e10895 = phi_8565_;
                        if (_e10881[2] < 0f) {
                            phi_8572_ = -(_e10881[2]);
                        } else {
                            phi_8572_ = _e10881[2];
                        }
                        let _e10899 = phi_8572_;
                        if (_e10895 > _e10899) {
                            phi_8577_ = _e10895;
                        } else {
                            phi_8577_ = _e10899;
                        }
                        let _e10902 = phi_8577_;
                        let _e10905 = local_18.member_2[1u];
                        if (_e10905[0] < 0f) {
                            phi_8591_ = -(_e10905[0]);
                        } else {
                            phi_8591_ = _e10905[0];
                        }
                        let _e10912 = phi_8591_;
                        if (_e10905[1] < 0f) {
                            phi_8598_ = -(_e10905[1]);
                        } else {
                            phi_8598_ = _e10905[1];
                        }
                        let _e10916 = phi_8598_;
                        if (_e10912 > _e10916) {
                            phi_8603_ = _e10912;
                        } else {
                            phi_8603_ = _e10916;
                        }
                        let _e10919 = phi_8603_;
                        if (_e10905[2] < 0f) {
                            phi_8610_ = -(_e10905[2]);
                        } else {
                            phi_8610_ = _e10905[2];
                        }
                        let _e10923 = phi_8610_;
                        if (_e10919 > _e10923) {
                            phi_8615_ = _e10919;
                        } else {
                            phi_8615_ = _e10923;
                        }
                        let _e10926 = phi_8615_;
                        if (_e10902 > _e10926) {
                            phi_8620_ = _e10902;
                        } else {
                            phi_8620_ = _e10926;
                        }
                        let _e10929 = phi_8620_;
                        let _e10931 = local_18.member_3;
                        let _e10938 = local_18.member_3;
                        let _e10945 = (((_e10767 * (1f + (0.000000059604645f * 8f))) + (((((((_e10821 + _e10823) + (_e10875 + _e10877)) + (_e10929 + _e10931)) * (0.000000059604645f * 16f)) + (_e10938 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e5872.member_1);
                        if _e10945 {
                            phi_9281_ = type_45();
                            phi_9282_ = true;
                        } else {
                            let _e10948 = local_18.member_1[0u];
                            let _e10954 = local_18.member_2[0u];
                            let _e10960 = ((_e10948[1] * _e10954[2]) - (_e10948[2] * _e10954[1]));
                            let _e10963 = ((_e10948[2] * _e10954[0]) - (_e10948[0] * _e10954[2]));
                            let _e10966 = ((_e10948[0] * _e10954[1]) - (_e10948[1] * _e10954[0]));
                            let _e10969 = local_18.member_1[1u];
                            let _e10975 = local_18.member_2[1u];
                            let _e10981 = ((_e10969[1] * _e10975[2]) - (_e10969[2] * _e10975[1]));
                            let _e10984 = ((_e10969[2] * _e10975[0]) - (_e10969[0] * _e10975[2]));
                            let _e10987 = ((_e10969[0] * _e10975[1]) - (_e10969[1] * _e10975[0]));
                            let _e10990 = local_18.member_1[0u];
                            let _e10996 = local_18.member_2[1u];
                            let _e11011 = local_18.member_1[1u];
                            let _e11017 = local_18.member_2[0u];
                            let _e11030 = (((_e10990[1] * _e10996[2]) - (_e10990[2] * _e10996[1])) + ((_e11011[1] * _e11017[2]) - (_e11011[2] * _e11017[1])));
                            let _e11031 = (((_e10990[2] * _e10996[0]) - (_e10990[0] * _e10996[2])) + ((_e11011[2] * _e11017[0]) - (_e11011[0] * _e11017[2])));
                            let _e11032 = (((_e10990[0] * _e10996[1]) - (_e10990[1] * _e10996[0])) + ((_e11011[0] * _e11017[1]) - (_e11011[1] * _e11017[0])));
                            let _e11035 = local_18.member[0u];
                            let _e11046 = local_18.member[1u];
                            let _e11057 = local_18.member[0u];
                            let _e11066 = ((((_e11046[0] * _e10960) + (_e11046[1] * _e10963)) + (_e11046[2] * _e10966)) + (((_e11057[0] * _e11030) + (_e11057[1] * _e11031)) + (_e11057[2] * _e11032)));
                            let _e11069 = local_18.member[0u];
                            let _e11080 = local_18.member[1u];
                            let _e11089 = ((((_e11069[0] * _e10981) + (_e11069[1] * _e10984)) + (_e11069[2] * _e10987)) + (((_e11080[0] * _e11030) + (_e11080[1] * _e11031)) + (_e11080[2] * _e11032)));
                            let _e11092 = local_18.member[1u];
                            let _e11103 = local_18.member[0u];
                            if (_e11103[0] < 0f) {
                                phi_8881_ = -(_e11103[0]);
                            } else {
                                phi_8881_ = _e11103[0];
                            }
                            let _e11110 = phi_8881_;
                            if (_e11103[1] < 0f) {
                                phi_8888_ = -(_e11103[1]);
                            } else {
                                phi_8888_ = _e11103[1];
                            }
                            let _e11114 = phi_8888_;
                            if (_e11110 > _e11114) {
                                phi_8893_ = _e11110;
                            } else {
                                phi_8893_ = _e11114;
                            }
                            let _e11117 = phi_8893_;
                            if (_e11103[2] < 0f) {
                                phi_8900_ = -(_e11103[2]);
                            } else {
                                phi_8900_ = _e11103[2];
                            }
                            let _e11121 = phi_8900_;
                            if (_e11117 > _e11121) {
                                phi_8905_ = _e11117;
                            } else {
                                phi_8905_ = _e11121;
                            }
                            let _e11124 = phi_8905_;
                            let _e11127 = local_18.member[1u];
                            if (_e11127[0] < 0f) {
                                phi_8918_ = -(_e11127[0]);
                            } else {
                                phi_8918_ = _e11127[0];
                            }
                            let _e11134 = phi_8918_;
                            if (_e11127[1] < 0f) {
                                phi_8925_ = -(_e11127[1]);
                            } else {
                                phi_8925_ = _e11127[1];
                            }
                            let _e11138 = phi_8925_;
                            if (_e11134 > _e11138) {
                                phi_8930_ = _e11134;
                            } else {
                                phi_8930_ = _e11138;
                            }
                            let _e11141 = phi_8930_;
                            if (_e11127[2] < 0f) {
                                phi_8937_ = -(_e11127[2]);
                            } else {
                                phi_8937_ = _e11127[2];
                            }
                            let _e11145 = phi_8937_;
                            if (_e11141 > _e11145) {
                                phi_8942_ = _e11141;
                            } else {
                                phi_8942_ = _e11145;
                            }
                            let _e11148 = phi_8942_;
                            if (_e11124 > _e11148) {
                                phi_8947_ = _e11124;
                            } else {
                                phi_8947_ = _e11148;
                            }
                            let _e11151 = phi_8947_;
                            let _e11153 = local_18.member_3;
                            let _e11154 = (_e11151 + _e11153);
                            let _e11157 = local_18.member_1[0u];
                            if (_e11157[0] < 0f) {
                                phi_8964_ = -(_e11157[0]);
                            } else {
                                phi_8964_ = _e11157[0];
                            }
                            let _e11164 = phi_8964_;
                            if (_e11157[1] < 0f) {
                                phi_8971_ = -(_e11157[1]);
                            } else {
                                phi_8971_ = _e11157[1];
                            }
                            let _e11168 = phi_8971_;
                            if (_e11164 > _e11168) {
                                phi_8976_ = _e11164;
                            } else {
                                phi_8976_ = _e11168;
                            }
                            let _e11171 = phi_8976_;
                            if (_e11157[2] < 0f) {
                                phi_8983_ = -(_e11157[2]);
                            } else {
                                phi_8983_ = _e11157[2];
                            }
                            let _e11175 = phi_8983_;
                            if (_e11171 > _e11175) {
                                phi_8988_ = _e11171;
                            } else {
                                phi_8988_ = _e11175;
                            }
                            let _e11178 = phi_8988_;
                            let _e11181 = local_18.member_1[1u];
                            if (_e11181[0] < 0f) {
                                phi_9002_ = -(_e11181[0]);
                            } else {
                                phi_9002_ = _e11181[0];
                            }
                            let _e11188 = phi_9002_;
                            if (_e11181[1] < 0f) {
                                phi_9009_ = -(_e11181[1]);
                            } else {
                                phi_9009_ = _e11181[1];
                            }
                            let _e11192 = phi_9009_;
                            if (_e11188 > _e11192) {
                                phi_9014_ = _e11188;
                            } else {
                                phi_9014_ = _e11192;
                            }
                            let _e11195 = phi_9014_;
                            if (_e11181[2] < 0f) {
                                phi_9021_ = -(_e11181[2]);
                            } else {
                                phi_9021_ = _e11181[2];
                            }
                            let _e11199 = phi_9021_;
                            if (_e11195 > _e11199) {
                                phi_9026_ = _e11195;
                            } else {
                                phi_9026_ = _e11199;
                            }
                            let _e11202 = phi_9026_;
                            if (_e11178 > _e11202) {
                                phi_9031_ = _e11178;
                            } else {
                                phi_9031_ = _e11202;
                            }
                            let _e11205 = phi_9031_;
                            let _e11207 = local_18.member_3;
                            let _e11208 = (_e11205 + _e11207);
                            let _e11211 = local_18.member_2[0u];
                            if (_e11211[0] < 0f) {
                                phi_9048_ = -(_e11211[0]);
                            } else {
                                phi_9048_ = _e11211[0];
                            }
                            let _e11218 = phi_9048_;
                            if (_e11211[1] < 0f) {
                                phi_9055_ = -(_e11211[1]);
                            } else {
                                phi_9055_ = _e11211[1];
                            }
                            let _e11222 = phi_9055_;
                            if (_e11218 > _e11222) {
                                phi_9060_ = _e11218;
                            } else {
                                phi_9060_ = _e11222;
                            }
                            let _e11225 = phi_9060_;
                            if (_e11211[2] < 0f) {
                                phi_9067_ = -(_e11211[2]);
                            } else {
                                phi_9067_ = _e11211[2];
                            }
                            let _e11229 = phi_9067_;
                            if (_e11225 > _e11229) {
                                phi_9072_ = _e11225;
                            } else {
                                phi_9072_ = _e11229;
                            }
                            let _e11232 = phi_9072_;
                            let _e11235 = local_18.member_2[1u];
                            if (_e11235[0] < 0f) {
                                phi_9086_ = -(_e11235[0]);
                            } else {
                                phi_9086_ = _e11235[0];
                            }
                            let _e11242 = phi_9086_;
                            if (_e11235[1] < 0f) {
                                phi_9093_ = -(_e11235[1]);
                            } else {
                                phi_9093_ = _e11235[1];
                            }
                            let _e11246 = phi_9093_;
                            if (_e11242 > _e11246) {
                                phi_9098_ = _e11242;
                            } else {
                                phi_9098_ = _e11246;
                            }
                            let _e11249 = phi_9098_;
                            if (_e11235[2] < 0f) {
                                phi_9105_ = -(_e11235[2]);
                            } else {
                                phi_9105_ = _e11235[2];
                            }
                            let _e11253 = phi_9105_;
                            if (_e11249 > _e11253) {
                                phi_9110_ = _e11249;
                            } else {
                                phi_9110_ = _e11253;
                            }
                            let _e11256 = phi_9110_;
                            if (_e11232 > _e11256) {
                                phi_9115_ = _e11232;
                            } else {
                                phi_9115_ = _e11256;
                            }
                            let _e11259 = phi_9115_;
                            let _e11261 = local_18.member_3;
                            let _e11262 = (_e11259 + _e11261);
                            let _e11264 = ((_e11208 * 8f) * _e11262);
                            let _e11271 = local_18.member_3;
                            if (_e10960 < 0f) {
                                phi_9146_ = -(_e10960);
                            } else {
                                phi_9146_ = _e10960;
                            }
                            let _e11288 = phi_9146_;
                            if (_e10963 < 0f) {
                                phi_9152_ = -(_e10963);
                            } else {
                                phi_9152_ = _e10963;
                            }
                            let _e11292 = phi_9152_;
                            if (_e10966 < 0f) {
                                phi_9159_ = -(_e10966);
                            } else {
                                phi_9159_ = _e10966;
                            }
                            let _e11297 = phi_9159_;
                            let _e11298 = ((_e11288 + _e11292) + _e11297);
                            if (_e10981 < 0f) {
                                phi_9166_ = -(_e10981);
                            } else {
                                phi_9166_ = _e10981;
                            }
                            let _e11302 = phi_9166_;
                            if (_e10984 < 0f) {
                                phi_9172_ = -(_e10984);
                            } else {
                                phi_9172_ = _e10984;
                            }
                            let _e11306 = phi_9172_;
                            if (_e10987 < 0f) {
                                phi_9179_ = -(_e10987);
                            } else {
                                phi_9179_ = _e10987;
                            }
                            let _e11311 = phi_9179_;
                            let _e11312 = ((_e11302 + _e11306) + _e11311);
                            if (_e11298 > _e11312) {
                                phi_9185_ = _e11298;
                            } else {
                                phi_9185_ = _e11312;
                            }
                            let _e11315 = phi_9185_;
                            if (_e11030 < 0f) {
                                phi_9191_ = -(_e11030);
                            } else {
                                phi_9191_ = _e11030;
                            }
                            let _e11319 = phi_9191_;
                            if (_e11031 < 0f) {
                                phi_9197_ = -(_e11031);
                            } else {
                                phi_9197_ = _e11031;
                            }
                            let _e11323 = phi_9197_;
                            if (_e11032 < 0f) {
                                phi_9204_ = -(_e11032);
                            } else {
                                phi_9204_ = _e11032;
                            }
                            let _e11328 = phi_9204_;
                            let _e11330 = (((_e11319 + _e11323) + _e11328) * 0.5f);
                            if (_e11315 > _e11330) {
                                phi_9211_ = _e11315;
                            } else {
                                phi_9211_ = _e11330;
                            }
                            let _e11333 = phi_9211_;
                            let _e11338 = local_18.member_3;
                            let _e11351 = ((((_e11035[0] * _e10960) + (_e11035[1] * _e10963)) + (_e11035[2] * _e10966)) * 3f);
                            let _e11352 = ((((_e11092[0] * _e10981) + (_e11092[1] * _e10984)) + (_e11092[2] * _e10987)) * 3f);
                            if (_e11351 < _e11352) {
                                phi_9235_ = _e11351;
                            } else {
                                phi_9235_ = _e11352;
                            }
                            let _e11355 = phi_9235_;
                            if (_e11066 < _e11089) {
                                phi_9240_ = _e11066;
                            } else {
                                phi_9240_ = _e11089;
                            }
                            let _e11358 = phi_9240_;
                            if (_e11355 < _e11358) {
                                phi_9245_ = _e11355;
                            } else {
                                phi_9245_ = _e11358;
                            }
                            let _e11361 = phi_9245_;
                            if (_e11351 > _e11352) {
                                phi_9250_ = _e11351;
                            } else {
                                phi_9250_ = _e11352;
                            }
                            let _e11364 = phi_9250_;
                            if (_e11066 > _e11089) {
                                phi_9255_ = _e11066;
                            } else {
                                phi_9255_ = _e11089;
                            }
                            let _e11367 = phi_9255_;
                            if (_e11364 > _e11367) {
                                phi_9260_ = _e11364;
                            } else {
                                phi_9260_ = _e11367;
                            }
                            let _e11370 = phi_9260_;
                            let _e11375 = -(_e11370);
                            if (_e11361 > _e11375) {
                                phi_9270_ = _e11361;
                            } else {
                                phi_9270_ = _e11375;
                            }
                            let _e11378 = phi_9270_;
                            if ((_e11378 - ((((((_e11154 * 8f) * _e11264) * (0.000000059604645f * (524f / 64f))) + ((_e11271 * 19f) * ((_e11154 * (_e11208 + _e11262)) + (_e11208 * _e11262)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e11154) * ((1f + _e11208) * (1f + _e11262))))) + ((_e5872.member_1 * (((_e11333 + (_e11264 * (0.000000059604645f * 8f))) + ((_e11338 * 6f) * (_e11208 + _e11262))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e11208) * (1f + _e11262))))) * (3f * 1.0001f)))) > 0f) {
                                phi_9279_ = type_45(type_44(0u, f32()), 0u);
                                phi_9280_ = false;
                            } else {
                                phi_9279_ = type_45();
                                phi_9280_ = true;
                            }
                            let _e11384 = phi_9279_;
                            let _e11386 = phi_9280_;
                            phi_9281_ = _e11384;
                            phi_9282_ = _e11386;
                        }
                        let _e11388 = phi_9281_;
                        let _e11390 = phi_9282_;
                        if _e11390 {
                            phi_9288_ = type_14(0i, 2i);
                            phi_9291_ = _e5604;
                            phi_9293_ = 0u;
                            phi_9295_ = _e5604;
                            loop {
                                let _e11392 = phi_9288_;
                                let _e11394 = phi_9291_;
                                let _e11396 = phi_9293_;
                                let _e11398 = phi_9295_;
                                local_167 = _e11396;
                                local_170 = _e11394;
                                local_171 = _e11396;
                                if (_e11392.member < _e11392.member_1) {
                                    let _e11405 = (_e11392.member + 1i);
                                    if ((false == (_e11405 > _e11392.member)) != false) {
                                        phi_9316_ = true;
                                    } else {
                                        phi_9316_ = false;
                                    }
                                    let _e11410 = phi_9316_;
                                    if _e11410 {
                                        phi_9322_ = type_15(0u, type_15().member_1);
                                    } else {
                                        phi_9322_ = type_15(1u, _e11405);
                                    }
                                    let _e11415 = phi_9322_;
                                    phi_9289_ = type_14(_e11415.member_1, _e11392.member_1);
                                    phi_9336_ = type_15(1u, _e11392.member);
                                } else {
                                    phi_9289_ = _e11392;
                                    phi_9336_ = type_15(0u, type_15().member_1);
                                }
                                let _e11421 = phi_9289_;
                                let _e11423 = phi_9336_;
                                if (bitcast<i32>(_e11423.member) != 0i) {
                                    if (_e11423.member_1 > 0i) {
                                        phi_9352_ = true;
                                    } else {
                                        if _e10945 {
                                            phi_9351_ = false;
                                        } else {
                                            phi_9351_ = true;
                                        }
                                        let _e11430 = phi_9351_;
                                        phi_9352_ = _e11430;
                                    }
                                    let _e11432 = phi_9352_;
                                    if _e11432 {
                                        let _e11435 = local_18.member[0u];
                                        let _e11442 = local_18.member_1[0u];
                                        let _e11448 = local_18.member_2[0u];
                                        let _e11452 = (_e11435[0] - _e11442[0]);
                                        let _e11453 = (_e11435[1] - _e11442[1]);
                                        let _e11454 = (_e11435[2] - _e11442[2]);
                                        if (_e316.member == 0u) {
                                            phi_9411_ = array<f32, 3>(_e11435[0], _e11435[1], _e11435[2]);
                                        } else {
                                            phi_9411_ = array<f32, 3>((_e11452 - _e11448[0]), (_e11453 - _e11448[1]), (_e11454 - _e11448[2]));
                                        }
                                        let _e11461 = phi_9411_;
                                        let _e11467 = local_18.member[1u];
                                        let _e11474 = local_18.member_1[1u];
                                        let _e11480 = local_18.member_2[1u];
                                        let _e11484 = (_e11467[0] - _e11474[0]);
                                        let _e11485 = (_e11467[1] - _e11474[1]);
                                        let _e11486 = (_e11467[2] - _e11474[2]);
                                        if (_e316.member == 0u) {
                                            phi_9476_ = array<f32, 3>(_e11467[0], _e11467[1], _e11467[2]);
                                        } else {
                                            phi_9476_ = array<f32, 3>((_e11484 - _e11480[0]), (_e11485 - _e11480[1]), (_e11486 - _e11480[2]));
                                        }
                                        let _e11493 = phi_9476_;
                                        let _e11499 = local_18.member[0u];
                                        if (_e11499[0] < 0f) {
                                            phi_9498_ = -(_e11499[0]);
                                        } else {
                                            phi_9498_ = _e11499[0];
                                        }
                                        let _e11506 = phi_9498_;
                                        if (_e11499[1] < 0f) {
                                            phi_9505_ = -(_e11499[1]);
                                        } else {
                                            phi_9505_ = _e11499[1];
                                        }
                                        let _e11510 = phi_9505_;
                                        if (_e11506 > _e11510) {
                                            phi_9510_ = _e11506;
                                        } else {
                                            phi_9510_ = _e11510;
                                        }
                                        let _e11513 = phi_9510_;
                                        if (_e11499[2] < 0f) {
                                            phi_9517_ = -(_e11499[2]);
                                        } else {
                                            phi_9517_ = _e11499[2];
                                        }
                                        let _e11517 = phi_9517_;
                                        if (_e11513 > _e11517) {
                                            phi_9522_ = _e11513;
                                        } else {
                                            phi_9522_ = _e11517;
                                        }
                                        let _e11520 = phi_9522_;
                                        let _e11523 = local_18.member[1u];
                                        if (_e11523[0] < 0f) {
                                            phi_9535_ = -(_e11523[0]);
                                        } else {
                                            phi_9535_ = _e11523[0];
                                        }
                                        let _e11530 = phi_9535_;
                                        if (_e11523[1] < 0f) {
                                            phi_9542_ = -(_e11523[1]);
                                        } else {
                                            phi_9542_ = _e11523[1];
                                        }
                                        let _e11534 = phi_9542_;
                                        if (_e11530 > _e11534) {
                                            phi_9547_ = _e11530;
                                        } else {
                                            phi_9547_ = _e11534;
                                        }
                                        let _e11537 = phi_9547_;
                                        if (_e11523[2] < 0f) {
                                            phi_9554_ = -(_e11523[2]);
                                        } else {
                                            phi_9554_ = _e11523[2];
                                        }
                                        let _e11541 = phi_9554_;
                                        if (_e11537 > _e11541) {
                                            phi_9559_ = _e11537;
                                        } else {
                                            phi_9559_ = _e11541;
                                        }
                                        let _e11544 = phi_9559_;
                                        if (_e11520 > _e11544) {
                                            phi_9564_ = _e11520;
                                        } else {
                                            phi_9564_ = _e11544;
                                        }
                                        let _e11547 = phi_9564_;
                                        let _e11549 = local_18.member_3;
                                        let _e11553 = local_18.member_1[0u];
                                        if (_e11553[0] < 0f) {
                                            phi_9581_ = -(_e11553[0]);
                                        } else {
                                            phi_9581_ = _e11553[0];
                                        }
                                        let _e11560 = phi_9581_;
                                        if (_e11553[1] < 0f) {
                                            phi_9588_ = -(_e11553[1]);
                                        } else {
                                            phi_9588_ = _e11553[1];
                                        }
                                        let _e11564 = phi_9588_;
                                        if (_e11560 > _e11564) {
                                            phi_9593_ = _e11560;
                                        } else {
                                            phi_9593_ = _e11564;
                                        }
                                        let _e11567 = phi_9593_;
                                        if (_e11553[2] < 0f) {
                                            phi_9600_ = -(_e11553[2]);
                                        } else {
                                            phi_9600_ = _e11553[2];
                                        }
                                        let _e11571 = phi_9600_;
                                        if (_e11567 > _e11571) {
                                            phi_9605_ = _e11567;
                                        } else {
                                            phi_9605_ = _e11571;
                                        }
                                        let _e11574 = phi_9605_;
                                        let _e11577 = local_18.member_1[1u];
                                        if (_e11577[0] < 0f) {
                                            phi_9619_ = -(_e11577[0]);
                                        } else {
                                            phi_9619_ = _e11577[0];
                                        }
                                        let _e11584 = phi_9619_;
                                        if (_e11577[1] < 0f) {
                                            phi_9626_ = -(_e11577[1]);
                                        } else {
                                            phi_9626_ = _e11577[1];
                                        }
                                        let _e11588 = phi_9626_;
                                        if (_e11584 > _e11588) {
                                            phi_9631_ = _e11584;
                                        } else {
                                            phi_9631_ = _e11588;
                                        }
                                        let _e11591 = phi_9631_;
                                        if (_e11577[2] < 0f) {
                                            phi_9638_ = -(_e11577[2]);
                                        } else {
                                            phi_9638_ = _e11577[2];
                                        }
                                        let _e11595 = phi_9638_;
                                        if (_e11591 > _e11595) {
                                            phi_9643_ = _e11591;
                                        } else {
                                            phi_9643_ = _e11595;
                                        }
                                        let _e11598 = phi_9643_;
                                        if (_e11574 > _e11598) {
                                            phi_9648_ = _e11574;
                                        } else {
                                            phi_9648_ = _e11598;
                                        }
                                        let _e11601 = phi_9648_;
                                        let _e11603 = local_18.member_3;
                                        let _e11607 = local_18.member_2[0u];
                                        if (_e11607[0] < 0f) {
                                            phi_9665_ = -(_e11607[0]);
                                        } else {
                                            phi_9665_ = _e11607[0];
                                        }
                                        let _e11614 = phi_9665_;
                                        if (_e11607[1] < 0f) {
                                            phi_9672_ = -(_e11607[1]);
                                        } else {
                                            phi_9672_ = _e11607[1];
                                        }
                                        let _e11618 = phi_9672_;
                                        if (_e11614 > _e11618) {
                                            phi_9677_ = _e11614;
                                        } else {
                                            phi_9677_ = _e11618;
                                        }
                                        let _e11621 = phi_9677_;
                                        if (_e11607[2] < 0f) {
                                            phi_9684_ = -(_e11607[2]);
                                        } else {
                                            phi_9684_ = _e11607[2];
                                        }
                                        let _e11625 = phi_9684_;
                                        if (_e11621 > _e11625) {
                                            phi_9689_ = _e11621;
                                        } else {
                                            phi_9689_ = _e11625;
                                        }
                                        let _e11628 = phi_9689_;
                                        let _e11631 = local_18.member_2[1u];
                                        if (_e11631[0] < 0f) {
                                            phi_9703_ = -(_e11631[0]);
                                        } else {
                                            phi_9703_ = _e11631[0];
                                        }
                                        let _e11638 = phi_9703_;
                                        if (_e11631[1] < 0f) {
                                            phi_9710_ = -(_e11631[1]);
                                        } else {
                                            phi_9710_ = _e11631[1];
                                        }
                                        let _e11642 = phi_9710_;
                                        if (_e11638 > _e11642) {
                                            phi_9715_ = _e11638;
                                        } else {
                                            phi_9715_ = _e11642;
                                        }
                                        let _e11645 = phi_9715_;
                                        if (_e11631[2] < 0f) {
                                            phi_9722_ = -(_e11631[2]);
                                        } else {
                                            phi_9722_ = _e11631[2];
                                        }
                                        let _e11649 = phi_9722_;
                                        if (_e11645 > _e11649) {
                                            phi_9727_ = _e11645;
                                        } else {
                                            phi_9727_ = _e11649;
                                        }
                                        let _e11652 = phi_9727_;
                                        if (_e11628 > _e11652) {
                                            phi_9732_ = _e11628;
                                        } else {
                                            phi_9732_ = _e11652;
                                        }
                                        let _e11655 = phi_9732_;
                                        let _e11657 = local_18.member_3;
                                        let _e11664 = local_18.member_3;
                                        let _e11669 = (_e5602 * 0.00390625f);
                                        local_16 = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        phi_9773_ = type_9(0u, 96u);
                                        phi_9776_ = _e11398;
                                        phi_9778_ = _e11398;
                                        phi_9780_ = (_e5606 - _e11398);
                                        phi_9782_ = _e11398;
                                        phi_9784_ = false;
                                        phi_9786_ = 0u;
                                        loop {
                                            let _e11672 = phi_9773_;
                                            let _e11674 = phi_9776_;
                                            let _e11676 = phi_9778_;
                                            let _e11678 = phi_9780_;
                                            let _e11680 = phi_9782_;
                                            let _e11682 = phi_9784_;
                                            let _e11684 = phi_9786_;
                                            local_109 = _e11674;
                                            local_157 = _e11676;
                                            if (_e11672.member < _e11672.member_1) {
                                                phi_9774_ = type_9((_e11672.member + 1u), _e11672.member_1);
                                                phi_9809_ = type_9(1u, _e11672.member);
                                            } else {
                                                phi_9774_ = _e11672;
                                                phi_9809_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e11696 = phi_9774_;
                                            let _e11698 = phi_9809_;
                                            if (bitcast<i32>(_e11698.member) != 0i) {
                                                let _e11704 = local_18.member[0u];
                                                let _e11710 = local_18.member[1u];
                                                let _e11726 = local_18.member_1[0u];
                                                let _e11732 = local_18.member_1[1u];
                                                let _e11748 = local_18.member_2[0u];
                                                let _e11754 = local_18.member_2[1u];
                                                let _e11768 = function_3(array<f32, 3>((_e11704[0] + ((_e11710[0] - _e11704[0]) * _e11674)), (_e11704[1] + ((_e11710[1] - _e11704[1]) * _e11674)), (_e11704[2] + ((_e11710[2] - _e11704[2]) * _e11674))), array<f32, 3>((_e11726[0] + ((_e11732[0] - _e11726[0]) * _e11674)), (_e11726[1] + ((_e11732[1] - _e11726[1]) * _e11674)), (_e11726[2] + ((_e11732[2] - _e11726[2]) * _e11674))), array<f32, 3>((_e11748[0] + ((_e11754[0] - _e11748[0]) * _e11674)), (_e11748[1] + ((_e11754[1] - _e11748[1]) * _e11674)), (_e11748[2] + ((_e11754[2] - _e11748[2]) * _e11674))), _e316.member);
                                                if (_e11684 == 0u) {
                                                    phi_9937_ = _e11768;
                                                } else {
                                                    if (_e11684 == 1u) {
                                                        phi_9923_ = _e11768[0];
                                                    } else {
                                                        phi_9923_ = 0f;
                                                    }
                                                    let _e11773 = phi_9923_;
                                                    if (_e11684 == 2u) {
                                                        phi_9929_ = _e11768[1];
                                                    } else {
                                                        phi_9929_ = 0f;
                                                    }
                                                    let _e11777 = phi_9929_;
                                                    if (_e11684 == 3u) {
                                                        phi_9935_ = _e11768[2];
                                                    } else {
                                                        phi_9935_ = 0f;
                                                    }
                                                    let _e11781 = phi_9935_;
                                                    phi_9937_ = array<f32, 3>(_e11773, _e11777, _e11781);
                                                }
                                                let _e11784 = phi_9937_;
                                                if (_e11784[0] < 0f) {
                                                    phi_9944_ = -(_e11784[0]);
                                                } else {
                                                    phi_9944_ = _e11784[0];
                                                }
                                                let _e11789 = phi_9944_;
                                                if (_e11784[1] < 0f) {
                                                    phi_9951_ = -(_e11784[1]);
                                                } else {
                                                    phi_9951_ = _e11784[1];
                                                }
                                                let _e11794 = phi_9951_;
                                                if (_e11784[2] < 0f) {
                                                    phi_9959_ = -(_e11784[2]);
                                                } else {
                                                    phi_9959_ = _e11784[2];
                                                }
                                                let _e11800 = phi_9959_;
                                                let _e11801 = ((_e11789 + _e11794) + _e11800);
                                                if (_e11801 > 0f) {
                                                    if ((bitcast<u32>(_e11801) & 2139095040u) != 2139095040u) {
                                                        let _e11806 = (1f / _e11801);
                                                        let _e11808 = (_e11784[0] * _e11806);
                                                        let _e11810 = (_e11784[1] * _e11806);
                                                        let _e11812 = (_e11784[2] * _e11806);
                                                        let _e11817 = (((_e11808 * _e11808) + (_e11810 * _e11810)) + (_e11812 * _e11812));
                                                        if (_e11817 <= 0.000000000000000000000000000000000000011754944f) {
                                                            if (_e11817 > 0f) {
                                                                phi_9996_ = (0.000000000000000000106433627f * 2f);
                                                            } else {
                                                                phi_9996_ = 0f;
                                                            }
                                                            let _e11870 = phi_9996_;
                                                            phi_10060_ = _e11870;
                                                        } else {
                                                            phi_10003_ = type_14(0i, 5i);
                                                            phi_10006_ = bitcast<f32>(((bitcast<u32>(_e11817) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e11825 = phi_10003_;
                                                                let _e11827 = phi_10006_;
                                                                local_106 = _e11827;
                                                                if (_e11825.member < _e11825.member_1) {
                                                                    let _e11834 = (_e11825.member + 1i);
                                                                    if ((false == (_e11834 > _e11825.member)) != false) {
                                                                        phi_10027_ = true;
                                                                    } else {
                                                                        phi_10027_ = false;
                                                                    }
                                                                    let _e11839 = phi_10027_;
                                                                    if _e11839 {
                                                                        phi_10033_ = type_15(0u, type_15().member_1);
                                                                    } else {
                                                                        phi_10033_ = type_15(1u, _e11834);
                                                                    }
                                                                    let _e11844 = phi_10033_;
                                                                    phi_10004_ = type_14(_e11844.member_1, _e11825.member_1);
                                                                    phi_10047_ = type_15(1u, _e11825.member);
                                                                } else {
                                                                    phi_10004_ = _e11825;
                                                                    phi_10047_ = type_15(0u, type_15().member_1);
                                                                }
                                                                let _e11850 = phi_10004_;
                                                                let _e11852 = phi_10047_;
                                                                let _e11855 = (bitcast<i32>(_e11852.member) != 0i);
                                                                if _e11855 {
                                                                    phi_10007_ = (0.5f * (_e11827 + (_e11817 / _e11827)));
                                                                } else {
                                                                    phi_10007_ = f32();
                                                                }
                                                                let _e11860 = phi_10007_;
                                                                continue;
                                                                continuing {
                                                                    phi_10003_ = _e11850;
                                                                    phi_10006_ = _e11860;
                                                                    break if !(_e11855);
                                                                }
                                                            }
                                                            let _e11865 = local_106;
                                                            phi_10060_ = (_e11865 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e11872 = phi_10060_;
                                                        let _e11873 = (0.000000059604645f * 12f);
                                                        let _e11878 = ((((((((_e11547 + _e11549) + (_e11601 + _e11603)) + (_e11655 + _e11657)) * (0.000000059604645f * 16f)) + (_e11664 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e5872.member_1 * _e11872) * (1f + _e11873)));
                                                        let _e11883 = (((_e11808 * _e11435[0]) + (_e11810 * _e11435[1])) + (_e11812 * _e11435[2]));
                                                        let _e11888 = (((_e11808 * _e11452) + (_e11810 * _e11453)) + (_e11812 * _e11454));
                                                        let _e11893 = (((_e11808 * (_e11435[0] - _e11448[0])) + (_e11810 * (_e11435[1] - _e11448[1]))) + (_e11812 * (_e11435[2] - _e11448[2])));
                                                        let _e11901 = (((_e11808 * _e11461[0]) + (_e11810 * _e11461[1])) + (_e11812 * _e11461[2]));
                                                        let _e11907 = (((_e11808 * _e11467[0]) + (_e11810 * _e11467[1])) + (_e11812 * _e11467[2]));
                                                        let _e11912 = (((_e11808 * _e11484) + (_e11810 * _e11485)) + (_e11812 * _e11486));
                                                        let _e11917 = (((_e11808 * (_e11467[0] - _e11480[0])) + (_e11810 * (_e11467[1] - _e11480[1]))) + (_e11812 * (_e11467[2] - _e11480[2])));
                                                        let _e11925 = (((_e11808 * _e11493[0]) + (_e11810 * _e11493[1])) + (_e11812 * _e11493[2]));
                                                        if (_e11883 < 0f) {
                                                            phi_10126_ = -(_e11883);
                                                        } else {
                                                            phi_10126_ = _e11883;
                                                        }
                                                        let _e11930 = phi_10126_;
                                                        if (_e11907 < 0f) {
                                                            phi_10132_ = -(_e11907);
                                                        } else {
                                                            phi_10132_ = _e11907;
                                                        }
                                                        let _e11934 = phi_10132_;
                                                        if (_e11888 < 0f) {
                                                            phi_10141_ = -(_e11888);
                                                        } else {
                                                            phi_10141_ = _e11888;
                                                        }
                                                        let _e11941 = phi_10141_;
                                                        if (_e11912 < 0f) {
                                                            phi_10147_ = -(_e11912);
                                                        } else {
                                                            phi_10147_ = _e11912;
                                                        }
                                                        let _e11945 = phi_10147_;
                                                        if (_e11893 < 0f) {
                                                            phi_10156_ = -(_e11893);
                                                        } else {
                                                            phi_10156_ = _e11893;
                                                        }
                                                        let _e11952 = phi_10156_;
                                                        if (_e11917 < 0f) {
                                                            phi_10162_ = -(_e11917);
                                                        } else {
                                                            phi_10162_ = _e11917;
                                                        }
                                                        let _e11956 = phi_10162_;
                                                        if (_e11901 < 0f) {
                                                            phi_10171_ = -(_e11901);
                                                        } else {
                                                            phi_10171_ = _e11901;
                                                        }
                                                        let _e11963 = phi_10171_;
                                                        if (_e11925 < 0f) {
                                                            phi_10177_ = -(_e11925);
                                                        } else {
                                                            phi_10177_ = _e11925;
                                                        }
                                                        let _e11967 = phi_10177_;
                                                        phi_10183_ = type_29(array<f32, 4>(_e11883, _e11888, _e11893, _e11901), array<f32, 4>(_e11907, _e11912, _e11917, _e11925), array<f32, 4>((_e11878 + ((_e11930 + _e11934) * _e11873)), (_e11878 + ((_e11941 + _e11945) * _e11873)), (_e11878 + ((_e11952 + _e11956) * _e11873)), (_e11878 + ((_e11963 + _e11967) * _e11873))));
                                                        phi_10184_ = false;
                                                    } else {
                                                        phi_10183_ = type_29();
                                                        phi_10184_ = true;
                                                    }
                                                    let _e11974 = phi_10183_;
                                                    let _e11976 = phi_10184_;
                                                    phi_10185_ = _e11974;
                                                    phi_10186_ = _e11976;
                                                } else {
                                                    phi_10185_ = type_29();
                                                    phi_10186_ = true;
                                                }
                                                let _e11978 = phi_10185_;
                                                let _e11980 = phi_10186_;
                                                if _e11980 {
                                                    phi_10194_ = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                } else {
                                                    phi_10194_ = _e11978;
                                                }
                                                let _e11982 = phi_10194_;
                                                local_17 = type_29(array<f32, 4>(_e11982.member[0], _e11982.member[1], _e11982.member[2], _e11982.member[3]), array<f32, 4>(_e11982.member_1[0], _e11982.member_1[1], _e11982.member_1[2], _e11982.member_1[3]), array<f32, 4>(_e11982.member_2[0], _e11982.member_2[1], _e11982.member_2[2], _e11982.member_2[3]));
                                                let _e12002 = (_e11674 - _e11680);
                                                let _e12006 = local_17.member[0u];
                                                let _e12009 = local_17.member_1[0u];
                                                let _e12012 = local_17.member[0u];
                                                let _e12018 = local_17.member_2[0u];
                                                if (((_e12006 + ((_e12009 - _e12012) * _e11674)) - _e12018) > 0f) {
                                                    let _e12023 = local_17.member[1u];
                                                    let _e12026 = local_17.member_1[1u];
                                                    let _e12029 = local_17.member[1u];
                                                    let _e12035 = local_17.member_2[1u];
                                                    if (((_e12023 + ((_e12026 - _e12029) * _e11674)) - _e12035) > 0f) {
                                                        let _e12040 = local_17.member[2u];
                                                        let _e12043 = local_17.member_1[2u];
                                                        let _e12046 = local_17.member[2u];
                                                        let _e12052 = local_17.member_2[2u];
                                                        if (((_e12040 + ((_e12043 - _e12046) * _e11674)) - _e12052) > 0f) {
                                                            let _e12057 = local_17.member[3u];
                                                            let _e12060 = local_17.member_1[3u];
                                                            let _e12063 = local_17.member[3u];
                                                            let _e12069 = local_17.member_2[3u];
                                                            phi_10365_ = (((_e12057 + ((_e12060 - _e12063) * _e11674)) - _e12069) > 0f);
                                                            phi_10366_ = false;
                                                        } else {
                                                            phi_10365_ = bool();
                                                            phi_10366_ = true;
                                                        }
                                                        let _e12073 = phi_10365_;
                                                        let _e12075 = phi_10366_;
                                                        phi_10367_ = _e12073;
                                                        phi_10368_ = _e12075;
                                                    } else {
                                                        phi_10367_ = bool();
                                                        phi_10368_ = true;
                                                    }
                                                    let _e12077 = phi_10367_;
                                                    let _e12079 = phi_10368_;
                                                    phi_10369_ = _e12077;
                                                    phi_10370_ = _e12079;
                                                } else {
                                                    phi_10369_ = bool();
                                                    phi_10370_ = true;
                                                }
                                                let _e12081 = phi_10369_;
                                                let _e12083 = phi_10370_;
                                                if _e12083 {
                                                    phi_10374_ = false;
                                                } else {
                                                    phi_10374_ = _e12081;
                                                }
                                                let _e12085 = phi_10374_;
                                                if _e12085 {
                                                    if (_e11674 <= _e11676) {
                                                        phi_10684_ = true;
                                                    } else {
                                                        let _e12089 = local_16.member[0u];
                                                        let _e12092 = local_16.member_1[0u];
                                                        let _e12095 = local_16.member[0u];
                                                        let _e12101 = local_16.member_2[0u];
                                                        let _e12105 = local_17.member[0u];
                                                        let _e12108 = local_17.member_1[0u];
                                                        let _e12111 = local_17.member[0u];
                                                        let _e12117 = local_17.member_2[0u];
                                                        if ((((_e12089 + ((_e12092 - _e12095) * _e11674)) - _e12101) + ((_e12105 + ((_e12108 - _e12111) * _e11680)) - _e12117)) > 0f) {
                                                            let _e12123 = local_16.member[1u];
                                                            let _e12126 = local_16.member_1[1u];
                                                            let _e12129 = local_16.member[1u];
                                                            let _e12135 = local_16.member_2[1u];
                                                            let _e12139 = local_17.member[1u];
                                                            let _e12142 = local_17.member_1[1u];
                                                            let _e12145 = local_17.member[1u];
                                                            let _e12151 = local_17.member_2[1u];
                                                            if ((((_e12123 + ((_e12126 - _e12129) * _e11674)) - _e12135) + ((_e12139 + ((_e12142 - _e12145) * _e11680)) - _e12151)) > 0f) {
                                                                let _e12157 = local_16.member[2u];
                                                                let _e12160 = local_16.member_1[2u];
                                                                let _e12163 = local_16.member[2u];
                                                                let _e12169 = local_16.member_2[2u];
                                                                let _e12173 = local_17.member[2u];
                                                                let _e12176 = local_17.member_1[2u];
                                                                let _e12179 = local_17.member[2u];
                                                                let _e12185 = local_17.member_2[2u];
                                                                if ((((_e12157 + ((_e12160 - _e12163) * _e11674)) - _e12169) + ((_e12173 + ((_e12176 - _e12179) * _e11680)) - _e12185)) > 0f) {
                                                                    let _e12191 = local_16.member[3u];
                                                                    let _e12194 = local_16.member_1[3u];
                                                                    let _e12197 = local_16.member[3u];
                                                                    let _e12203 = local_16.member_2[3u];
                                                                    let _e12207 = local_17.member[3u];
                                                                    let _e12210 = local_17.member_1[3u];
                                                                    let _e12213 = local_17.member[3u];
                                                                    let _e12219 = local_17.member_2[3u];
                                                                    phi_10671_ = ((((_e12191 + ((_e12194 - _e12197) * _e11674)) - _e12203) + ((_e12207 + ((_e12210 - _e12213) * _e11680)) - _e12219)) > 0f);
                                                                    phi_10672_ = false;
                                                                } else {
                                                                    phi_10671_ = bool();
                                                                    phi_10672_ = true;
                                                                }
                                                                let _e12224 = phi_10671_;
                                                                let _e12226 = phi_10672_;
                                                                phi_10673_ = _e12224;
                                                                phi_10674_ = _e12226;
                                                            } else {
                                                                phi_10673_ = bool();
                                                                phi_10674_ = true;
                                                            }
                                                            let _e12228 = phi_10673_;
                                                            let _e12230 = phi_10674_;
                                                            phi_10675_ = _e12228;
                                                            phi_10676_ = _e12230;
                                                        } else {
                                                            phi_10675_ = bool();
                                                            phi_10676_ = true;
                                                        }
                                                        let _e12232 = phi_10675_;
                                                        let _e12234 = phi_10676_;
                                                        if _e12234 {
                                                            phi_10680_ = false;
                                                        } else {
                                                            phi_10680_ = _e12232;
                                                        }
                                                        let _e12236 = phi_10680_;
                                                        phi_10684_ = _e12236;
                                                    }
                                                    let _e12238 = phi_10684_;
                                                    if _e12238 {
                                                        if _e11682 {
                                                            if (_e11674 >= _e5606) {
                                                                phi_10695_ = false;
                                                            } else {
                                                                phi_10695_ = true;
                                                            }
                                                            let _e12241 = phi_10695_;
                                                            phi_10696_ = _e12241;
                                                        } else {
                                                            phi_10696_ = true;
                                                        }
                                                        let _e12243 = phi_10696_;
                                                        if _e12243 {
                                                            local_16 = type_29(array<f32, 4>(_e11982.member[0], _e11982.member[1], _e11982.member[2], _e11982.member[3]), array<f32, 4>(_e11982.member_1[0], _e11982.member_1[1], _e11982.member_1[2], _e11982.member_1[3]), array<f32, 4>(_e11982.member_2[0], _e11982.member_2[1], _e11982.member_2[2], _e11982.member_2[3]));
                                                            let _e12265 = local_16.member[0u];
                                                            let _e12268 = local_16.member_1[0u];
                                                            let _e12271 = local_16.member_2[0u];
                                                            if (_e12265 > _e12271) {
                                                                if (_e12268 > _e12271) {
                                                                    phi_10770_ = false;
                                                                } else {
                                                                    phi_10770_ = true;
                                                                }
                                                                let _e12275 = phi_10770_;
                                                                phi_10771_ = _e12275;
                                                            } else {
                                                                phi_10771_ = true;
                                                            }
                                                            let _e12277 = phi_10771_;
                                                            if _e12277 {
                                                                let _e12278 = (_e12268 >= _e12265);
                                                                if _e12278 {
                                                                    phi_10793_ = f32();
                                                                    phi_10794_ = false;
                                                                } else {
                                                                    if ((_e12265 - _e12268) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                        phi_10791_ = (((_e12265 - _e12271) / (_e12265 - _e12268)) * (1f - (0.000000059604645f * 16f)));
                                                                        phi_10792_ = false;
                                                                    } else {
                                                                        phi_10791_ = f32();
                                                                        phi_10792_ = true;
                                                                    }
                                                                    let _e12289 = phi_10791_;
                                                                    let _e12291 = phi_10792_;
                                                                    phi_10793_ = _e12289;
                                                                    phi_10794_ = _e12291;
                                                                }
                                                                let _e12293 = phi_10793_;
                                                                let _e12295 = phi_10794_;
                                                                phi_10795_ = _e12293;
                                                                phi_10796_ = _e12278;
                                                                phi_10797_ = _e12295;
                                                            } else {
                                                                phi_10795_ = f32();
                                                                phi_10796_ = true;
                                                                phi_10797_ = false;
                                                            }
                                                            let _e12297 = phi_10795_;
                                                            let _e12299 = phi_10796_;
                                                            let _e12301 = phi_10797_;
                                                            if _e12299 {
                                                                phi_10801_ = 2f;
                                                                phi_10802_ = true;
                                                            } else {
                                                                phi_10801_ = _e11674;
                                                                phi_10802_ = _e12301;
                                                            }
                                                            let _e12303 = phi_10801_;
                                                            let _e12305 = phi_10802_;
                                                            if _e12305 {
                                                                phi_10806_ = _e12303;
                                                            } else {
                                                                phi_10806_ = _e12297;
                                                            }
                                                            let _e12307 = phi_10806_;
                                                            let _e12310 = local_16.member[1u];
                                                            let _e12313 = local_16.member_1[1u];
                                                            let _e12316 = local_16.member_2[1u];
                                                            if (_e12310 > _e12316) {
                                                                if (_e12313 > _e12316) {
                                                                    phi_10838_ = false;
                                                                } else {
                                                                    phi_10838_ = true;
                                                                }
                                                                let _e12320 = phi_10838_;
                                                                phi_10839_ = _e12320;
                                                            } else {
                                                                phi_10839_ = true;
                                                            }
                                                            let _e12322 = phi_10839_;
                                                            if _e12322 {
                                                                let _e12323 = (_e12313 >= _e12310);
                                                                if _e12323 {
                                                                    phi_10861_ = f32();
                                                                    phi_10862_ = false;
                                                                } else {
                                                                    if ((_e12310 - _e12313) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                        phi_10859_ = (((_e12310 - _e12316) / (_e12310 - _e12313)) * (1f - (0.000000059604645f * 16f)));
                                                                        phi_10860_ = false;
                                                                    } else {
                                                                        phi_10859_ = f32();
                                                                        phi_10860_ = true;
                                                                    }
                                                                    let _e12334 = phi_10859_;
                                                                    let _e12336 = phi_10860_;
                                                                    phi_10861_ = _e12334;
                                                                    phi_10862_ = _e12336;
                                                                }
                                                                let _e12338 = phi_10861_;
                                                                let _e12340 = phi_10862_;
                                                                phi_10863_ = _e12338;
                                                                phi_10864_ = _e12323;
                                                                phi_10865_ = _e12340;
                                                            } else {
                                                                phi_10863_ = f32();
                                                                phi_10864_ = true;
                                                                phi_10865_ = false;
                                                            }
                                                            let _e12342 = phi_10863_;
                                                            let _e12344 = phi_10864_;
                                                            let _e12346 = phi_10865_;
                                                            if _e12344 {
                                                                phi_10869_ = 2f;
                                                                phi_10870_ = true;
                                                            } else {
                                                                phi_10869_ = _e11674;
                                                                phi_10870_ = _e12346;
                                                            }
                                                            let _e12348 = phi_10869_;
                                                            let _e12350 = phi_10870_;
                                                            if _e12350 {
                                                                phi_10874_ = _e12348;
                                                            } else {
                                                                phi_10874_ = _e12342;
                                                            }
                                                            let _e12352 = phi_10874_;
                                                            if (_e12307 < _e12352) {
                                                                phi_10879_ = _e12307;
                                                            } else {
                                                                phi_10879_ = _e12352;
                                                            }
                                                            let _e12355 = phi_10879_;
                                                            let _e12358 = local_16.member[2u];
                                                            let _e12361 = local_16.member_1[2u];
                                                            let _e12364 = local_16.member_2[2u];
                                                            if (_e12358 > _e12364) {
                                                                if (_e12361 > _e12364) {
                                                                    phi_10911_ = false;
                                                                } else {
                                                                    phi_10911_ = true;
                                                                }
                                                                let _e12368 = phi_10911_;
                                                                phi_10912_ = _e12368;
                                                            } else {
                                                                phi_10912_ = true;
                                                            }
                                                            let _e12370 = phi_10912_;
                                                            if _e12370 {
                                                                let _e12371 = (_e12361 >= _e12358);
                                                                if _e12371 {
                                                                    phi_10934_ = f32();
                                                                    phi_10935_ = false;
                                                                } else {
                                                                    if ((_e12358 - _e12361) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                        phi_10932_ = (((_e12358 - _e12364) / (_e12358 - _e12361)) * (1f - (0.000000059604645f * 16f)));
                                                                        phi_10933_ = false;
                                                                    } else {
                                                                        phi_10932_ = f32();
                                                                        phi_10933_ = true;
                                                                    }
                                                                    let _e12382 = phi_10932_;
                                                                    let _e12384 = phi_10933_;
                                                                    phi_10934_ = _e12382;
                                                                    phi_10935_ = _e12384;
                                                                }
                                                                let _e12386 = phi_10934_;
                                                                let _e12388 = phi_10935_;
                                                                phi_10936_ = _e12386;
                                                                phi_10937_ = _e12371;
                                                                phi_10938_ = _e12388;
                                                            } else {
                                                                phi_10936_ = f32();
                                                                phi_10937_ = true;
                                                                phi_10938_ = false;
                                                            }
                                                            let _e12390 = phi_10936_;
                                                            let _e12392 = phi_10937_;
                                                            let _e12394 = phi_10938_;
                                                            if _e12392 {
                                                                phi_10942_ = 2f;
                                                                phi_10943_ = true;
                                                            } else {
                                                                phi_10942_ = _e11674;
                                                                phi_10943_ = _e12394;
                                                            }
                                                            let _e12396 = phi_10942_;
                                                            let _e12398 = phi_10943_;
                                                            if _e12398 {
                                                                phi_10947_ = _e12396;
                                                            } else {
                                                                phi_10947_ = _e12390;
                                                            }
                                                            let _e12400 = phi_10947_;
                                                            let _e12403 = local_16.member[3u];
                                                            let _e12406 = local_16.member_1[3u];
                                                            let _e12409 = local_16.member_2[3u];
                                                            if (_e12403 > _e12409) {
                                                                if (_e12406 > _e12409) {
                                                                    phi_10979_ = false;
                                                                } else {
                                                                    phi_10979_ = true;
                                                                }
                                                                let _e12413 = phi_10979_;
                                                                phi_10980_ = _e12413;
                                                            } else {
                                                                phi_10980_ = true;
                                                            }
                                                            let _e12415 = phi_10980_;
                                                            if _e12415 {
                                                                let _e12416 = (_e12406 >= _e12403);
                                                                if _e12416 {
                                                                    phi_11002_ = f32();
                                                                    phi_11003_ = false;
                                                                } else {
                                                                    if ((_e12403 - _e12406) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                        phi_11000_ = (((_e12403 - _e12409) / (_e12403 - _e12406)) * (1f - (0.000000059604645f * 16f)));
                                                                        phi_11001_ = false;
                                                                    } else {
                                                                        phi_11000_ = f32();
                                                                        phi_11001_ = true;
                                                                    }
                                                                    let _e12427 = phi_11000_;
                                                                    let _e12429 = phi_11001_;
                                                                    phi_11002_ = _e12427;
                                                                    phi_11003_ = _e12429;
                                                                }
                                                                let _e12431 = phi_11002_;
                                                                let _e12433 = phi_11003_;
                                                                phi_11004_ = _e12431;
                                                                phi_11005_ = _e12416;
                                                                phi_11006_ = _e12433;
                                                            } else {
                                                                phi_11004_ = f32();
                                                                phi_11005_ = true;
                                                                phi_11006_ = false;
                                                            }
                                                            let _e12435 = phi_11004_;
                                                            let _e12437 = phi_11005_;
                                                            let _e12439 = phi_11006_;
                                                            if _e12437 {
                                                                phi_11010_ = 2f;
                                                                phi_11011_ = true;
                                                            } else {
                                                                phi_11010_ = _e11674;
                                                                phi_11011_ = _e12439;
                                                            }
                                                            let _e12441 = phi_11010_;
                                                            let _e12443 = phi_11011_;
                                                            if _e12443 {
                                                                phi_11015_ = _e12441;
                                                            } else {
                                                                phi_11015_ = _e12435;
                                                            }
                                                            let _e12445 = phi_11015_;
                                                            if (_e12400 < _e12445) {
                                                                phi_11020_ = _e12400;
                                                            } else {
                                                                phi_11020_ = _e12445;
                                                            }
                                                            let _e12448 = phi_11020_;
                                                            if (_e12355 < _e12448) {
                                                                phi_11025_ = _e12355;
                                                            } else {
                                                                phi_11025_ = _e12448;
                                                            }
                                                            let _e12451 = phi_11025_;
                                                            if (_e12451 > _e11674) {
                                                                phi_11030_ = _e12451;
                                                            } else {
                                                                phi_11030_ = _e11674;
                                                            }
                                                            let _e12454 = phi_11030_;
                                                            let _e12455 = (_e12454 > _e5606);
                                                            if _e12455 {
                                                                phi_11535_ = f32();
                                                                phi_11536_ = f32();
                                                                phi_11537_ = false;
                                                                phi_11538_ = false;
                                                            } else {
                                                                let _e12456 = (_e12454 - _e11674);
                                                                let _e12457 = (_e12456 <= _e11669);
                                                                let _e12459 = (_e12454 + (_e5602 * 0.01f));
                                                                if (_e12459 < _e5606) {
                                                                    phi_11043_ = _e12459;
                                                                } else {
                                                                    phi_11043_ = _e5606;
                                                                }
                                                                let _e12462 = phi_11043_;
                                                                if _e12457 {
                                                                    if (_e5872.member_1 > 0f) {
                                                                        let _e12466 = local_18.member[0u];
                                                                        let _e12472 = local_18.member[1u];
                                                                        let _e12488 = local_18.member_1[0u];
                                                                        let _e12494 = local_18.member_1[1u];
                                                                        let _e12510 = local_18.member_2[0u];
                                                                        let _e12516 = local_18.member_2[1u];
                                                                        let _e12530 = function_3(array<f32, 3>((_e12466[0] + ((_e12472[0] - _e12466[0]) * _e12462)), (_e12466[1] + ((_e12472[1] - _e12466[1]) * _e12462)), (_e12466[2] + ((_e12472[2] - _e12466[2]) * _e12462))), array<f32, 3>((_e12488[0] + ((_e12494[0] - _e12488[0]) * _e12462)), (_e12488[1] + ((_e12494[1] - _e12488[1]) * _e12462)), (_e12488[2] + ((_e12494[2] - _e12488[2]) * _e12462))), array<f32, 3>((_e12510[0] + ((_e12516[0] - _e12510[0]) * _e12462)), (_e12510[1] + ((_e12516[1] - _e12510[1]) * _e12462)), (_e12510[2] + ((_e12516[2] - _e12510[2]) * _e12462))), _e316.member);
                                                                        let _e12541 = (((_e12530[0] * _e12530[0]) + (_e12530[1] * _e12530[1])) + (_e12530[2] * _e12530[2]));
                                                                        if (_e12541 <= 0.000000000000000000000000000000000000011754944f) {
                                                                            if (_e12541 > 0f) {
                                                                                phi_11173_ = (0.000000000000000000106433627f * 2f);
                                                                            } else {
                                                                                phi_11173_ = 0f;
                                                                            }
                                                                            let _e12594 = phi_11173_;
                                                                            phi_11237_ = _e12594;
                                                                        } else {
                                                                            phi_11180_ = type_14(0i, 5i);
                                                                            phi_11183_ = bitcast<f32>(((bitcast<u32>(_e12541) >> bitcast<u32>(1i)) + 532369198u));
                                                                            loop {
                                                                                let _e12549 = phi_11180_;
                                                                                let _e12551 = phi_11183_;
                                                                                local_107 = _e12551;
                                                                                if (_e12549.member < _e12549.member_1) {
                                                                                    let _e12558 = (_e12549.member + 1i);
                                                                                    if ((false == (_e12558 > _e12549.member)) != false) {
                                                                                        phi_11204_ = true;
                                                                                    } else {
                                                                                        phi_11204_ = false;
                                                                                    }
                                                                                    let _e12563 = phi_11204_;
                                                                                    if _e12563 {
                                                                                        phi_11210_ = type_15(0u, type_15().member_1);
                                                                                    } else {
                                                                                        phi_11210_ = type_15(1u, _e12558);
                                                                                    }
                                                                                    let _e12568 = phi_11210_;
                                                                                    phi_11181_ = type_14(_e12568.member_1, _e12549.member_1);
                                                                                    phi_11224_ = type_15(1u, _e12549.member);
                                                                                } else {
                                                                                    phi_11181_ = _e12549;
                                                                                    phi_11224_ = type_15(0u, type_15().member_1);
                                                                                }
                                                                                let _e12574 = phi_11181_;
                                                                                let _e12576 = phi_11224_;
                                                                                let _e12579 = (bitcast<i32>(_e12576.member) != 0i);
                                                                                if _e12579 {
                                                                                    phi_11184_ = (0.5f * (_e12551 + (_e12541 / _e12551)));
                                                                                } else {
                                                                                    phi_11184_ = f32();
                                                                                }
                                                                                let _e12584 = phi_11184_;
                                                                                continue;
                                                                                continuing {
                                                                                    phi_11180_ = _e12574;
                                                                                    phi_11183_ = _e12584;
                                                                                    break if !(_e12579);
                                                                                }
                                                                            }
                                                                            let _e12589 = local_107;
                                                                            phi_11237_ = (_e12589 * (1f + (8f * 0.000000059604645f)));
                                                                        }
                                                                        let _e12596 = phi_11237_;
                                                                        let _e12602 = local_18.member[0u];
                                                                        if (_e12602[0] < 0f) {
                                                                            phi_11253_ = -(_e12602[0]);
                                                                        } else {
                                                                            phi_11253_ = _e12602[0];
                                                                        }
                                                                        let _e12609 = phi_11253_;
                                                                        if (_e12602[1] < 0f) {
                                                                            phi_11260_ = -(_e12602[1]);
                                                                        } else {
                                                                            phi_11260_ = _e12602[1];
                                                                        }
                                                                        let _e12613 = phi_11260_;
                                                                        if (_e12609 > _e12613) {
                                                                            phi_11265_ = _e12609;
                                                                        } else {
                                                                            phi_11265_ = _e12613;
                                                                        }
                                                                        let _e12616 = phi_11265_;
                                                                        if (_e12602[2] < 0f) {
                                                                            phi_11272_ = -(_e12602[2]);
                                                                        } else {
                                                                            phi_11272_ = _e12602[2];
                                                                        }
                                                                        let _e12620 = phi_11272_;
                                                                        if (_e12616 > _e12620) {
                                                                            phi_11277_ = _e12616;
                                                                        } else {
                                                                            phi_11277_ = _e12620;
                                                                        }
                                                                        let _e12623 = phi_11277_;
                                                                        let _e12626 = local_18.member[1u];
                                                                        if (_e12626[0] < 0f) {
                                                                            phi_11290_ = -(_e12626[0]);
                                                                        } else {
                                                                            phi_11290_ = _e12626[0];
                                                                        }
                                                                        let _e12633 = phi_11290_;
                                                                        if (_e12626[1] < 0f) {
                                                                            phi_11297_ = -(_e12626[1]);
                                                                        } else {
                                                                            phi_11297_ = _e12626[1];
                                                                        }
                                                                        let _e12637 = phi_11297_;
                                                                        if (_e12633 > _e12637) {
                                                                            phi_11302_ = _e12633;
                                                                        } else {
                                                                            phi_11302_ = _e12637;
                                                                        }
                                                                        let _e12640 = phi_11302_;
                                                                        if (_e12626[2] < 0f) {
                                                                            phi_11309_ = -(_e12626[2]);
                                                                        } else {
                                                                            phi_11309_ = _e12626[2];
                                                                        }
                                                                        let _e12644 = phi_11309_;
                                                                        if (_e12640 > _e12644) {
                                                                            phi_11314_ = _e12640;
                                                                        } else {
                                                                            phi_11314_ = _e12644;
                                                                        }
                                                                        let _e12647 = phi_11314_;
                                                                        if (_e12623 > _e12647) {
                                                                            phi_11319_ = _e12623;
                                                                        } else {
                                                                            phi_11319_ = _e12647;
                                                                        }
                                                                        let _e12650 = phi_11319_;
                                                                        let _e12652 = local_18.member_3;
                                                                        let _e12656 = local_18.member_1[0u];
                                                                        if (_e12656[0] < 0f) {
                                                                            phi_11336_ = -(_e12656[0]);
                                                                        } else {
                                                                            phi_11336_ = _e12656[0];
                                                                        }
                                                                        let _e12663 = phi_11336_;
                                                                        if (_e12656[1] < 0f) {
                                                                            phi_11343_ = -(_e12656[1]);
                                                                        } else {
                                                                            phi_11343_ = _e12656[1];
                                                                        }
                                                                        let _e12667 = phi_11343_;
                                                                        if (_e12663 > _e12667) {
                                                                            phi_11348_ = _e12663;
                                                                        } else {
                                                                            phi_11348_ = _e12667;
                                                                        }
                                                                        let _e12670 = phi_11348_;
                                                                        if (_e12656[2] < 0f) {
                                                                            phi_11355_ = -(_e12656[2]);
                                                                        } else {
                                                                            phi_11355_ = _e12656[2];
                                                                        }
                                                                        let _e12674 = phi_11355_;
                                                                        if (_e12670 > _e12674) {
                                                                            phi_11360_ = _e12670;
                                                                        } else {
                                                                            phi_11360_ = _e12674;
                                                                        }
                                                                        let _e12677 = phi_11360_;
                                                                        let _e12680 = local_18.member_1[1u];
                                                                        if (_e12680[0] < 0f) {
                                                                            phi_11374_ = -(_e12680[0]);
                                                                        } else {
                                                                            phi_11374_ = _e12680[0];
                                                                        }
                                                                        let _e12687 = phi_11374_;
                                                                        if (_e12680[1] < 0f) {
                                                                            phi_11381_ = -(_e12680[1]);
                                                                        } else {
                                                                            phi_11381_ = _e12680[1];
                                                                        }
                                                                        let _e12691 = phi_11381_;
                                                                        if (_e12687 > _e12691) {
                                                                            phi_11386_ = _e12687;
                                                                        } else {
                                                                            phi_11386_ = _e12691;
                                                                        }
                                                                        let _e12694 = phi_11386_;
                                                                        if (_e12680[2] < 0f) {
                                                                            phi_11393_ = -(_e12680[2]);
                                                                        } else {
                                                                            phi_11393_ = _e12680[2];
                                                                        }
                                                                        let _e12698 = phi_11393_;
                                                                        if (_e12694 > _e12698) {
                                                                            phi_11398_ = _e12694;
                                                                        } else {
                                                                            phi_11398_ = _e12698;
                                                                        }
                                                                        let _e12701 = phi_11398_;
                                                                        if (_e12677 > _e12701) {
                                                                            phi_11403_ = _e12677;
                                                                        } else {
                                                                            phi_11403_ = _e12701;
                                                                        }
                                                                        let _e12704 = phi_11403_;
                                                                        let _e12706 = local_18.member_3;
                                                                        let _e12710 = local_18.member_2[0u];
                                                                        if (_e12710[0] < 0f) {
                                                                            phi_11420_ = -(_e12710[0]);
                                                                        } else {
                                                                            phi_11420_ = _e12710[0];
                                                                        }
                                                                        let _e12717 = phi_11420_;
                                                                        if (_e12710[1] < 0f) {
                                                                            phi_11427_ = -(_e12710[1]);
                                                                        } else {
                                                                            phi_11427_ = _e12710[1];
                                                                        }
                                                                        let _e12721 = phi_11427_;
                                                                        if (_e12717 > _e12721) {
                                                                            phi_11432_ = _e12717;
                                                                        } else {
                                                                            phi_11432_ = _e12721;
                                                                        }
                                                                        let _e12724 = phi_11432_;
                                                                        if (_e12710[2] < 0f) {
                                                                            phi_11439_ = -(_e12710[2]);
                                                                        } else {
                                                                            phi_11439_ = _e12710[2];
                                                                        }
                                                                        let _e12728 = phi_11439_;
                                                                        if (_e12724 > _e12728) {
                                                                            phi_11444_ = _e12724;
                                                                        } else {
                                                                            phi_11444_ = _e12728;
                                                                        }
                                                                        let _e12731 = phi_11444_;
                                                                        let _e12734 = local_18.member_2[1u];
                                                                        if (_e12734[0] < 0f) {
                                                                            phi_11458_ = -(_e12734[0]);
                                                                        } else {
                                                                            phi_11458_ = _e12734[0];
                                                                        }
                                                                        let _e12741 = phi_11458_;
                                                                        if (_e12734[1] < 0f) {
                                                                            phi_11465_ = -(_e12734[1]);
                                                                        } else {
                                                                            phi_11465_ = _e12734[1];
                                                                        }
                                                                        let _e12745 = phi_11465_;
                                                                        if (_e12741 > _e12745) {
                                                                            phi_11470_ = _e12741;
                                                                        } else {
                                                                            phi_11470_ = _e12745;
                                                                        }
                                                                        let _e12748 = phi_11470_;
                                                                        if (_e12734[2] < 0f) {
                                                                            phi_11477_ = -(_e12734[2]);
                                                                        } else {
                                                                            phi_11477_ = _e12734[2];
                                                                        }
                                                                        let _e12752 = phi_11477_;
                                                                        if (_e12748 > _e12752) {
                                                                            phi_11482_ = _e12748;
                                                                        } else {
                                                                            phi_11482_ = _e12752;
                                                                        }
                                                                        let _e12755 = phi_11482_;
                                                                        if (_e12731 > _e12755) {
                                                                            phi_11487_ = _e12731;
                                                                        } else {
                                                                            phi_11487_ = _e12755;
                                                                        }
                                                                        let _e12758 = phi_11487_;
                                                                        let _e12760 = local_18.member_3;
                                                                        let _e12767 = local_18.member_3;
                                                                        if (((_e12596 * (1f + (0.000000059604645f * 8f))) + (((((((_e12650 + _e12652) + (_e12704 + _e12706)) + (_e12758 + _e12760)) * (0.000000059604645f * 16f)) + (_e12767 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e5872.member_1) {
                                                                            phi_11507_ = false;
                                                                        } else {
                                                                            phi_11507_ = true;
                                                                        }
                                                                        let _e12776 = phi_11507_;
                                                                        phi_11508_ = _e12776;
                                                                    } else {
                                                                        phi_11508_ = true;
                                                                    }
                                                                    let _e12778 = phi_11508_;
                                                                    phi_11509_ = _e12778;
                                                                } else {
                                                                    phi_11509_ = true;
                                                                }
                                                                let _e12780 = phi_11509_;
                                                                if _e12780 {
                                                                    if _e11682 {
                                                                        if _e12457 {
                                                                            phi_11525_ = true;
                                                                        } else {
                                                                            if (_e12456 <= (_e11678 * 0.25f)) {
                                                                                phi_11524_ = false;
                                                                            } else {
                                                                                phi_11524_ = true;
                                                                            }
                                                                            let _e12785 = phi_11524_;
                                                                            phi_11525_ = _e12785;
                                                                        }
                                                                        let _e12787 = phi_11525_;
                                                                        if _e12787 {
                                                                            phi_11530_ = (_e12002 + _e12002);
                                                                        } else {
                                                                            phi_11530_ = 0f;
                                                                        }
                                                                        let _e12790 = phi_11530_;
                                                                        phi_11532_ = _e12790;
                                                                    } else {
                                                                        phi_11532_ = (_e5606 - _e11674);
                                                                    }
                                                                    let _e12792 = phi_11532_;
                                                                    phi_11533_ = _e12792;
                                                                    phi_11534_ = false;
                                                                } else {
                                                                    phi_11533_ = f32();
                                                                    phi_11534_ = true;
                                                                }
                                                                let _e12794 = phi_11533_;
                                                                let _e12796 = phi_11534_;
                                                                phi_11535_ = _e12794;
                                                                phi_11536_ = _e12456;
                                                                phi_11537_ = _e12780;
                                                                phi_11538_ = _e12796;
                                                            }
                                                            let _e12798 = phi_11535_;
                                                            let _e12800 = phi_11536_;
                                                            let _e12802 = phi_11537_;
                                                            let _e12804 = phi_11538_;
                                                            phi_11539_ = _e12454;
                                                            phi_11540_ = _e12798;
                                                            phi_11541_ = _e12800;
                                                            phi_11542_ = _e12454;
                                                            phi_11543_ = _e12802;
                                                            phi_11544_ = _e12455;
                                                            phi_11545_ = _e12804;
                                                            phi_11546_ = false;
                                                        } else {
                                                            phi_11539_ = f32();
                                                            phi_11540_ = f32();
                                                            phi_11541_ = f32();
                                                            phi_11542_ = f32();
                                                            phi_11543_ = false;
                                                            phi_11544_ = false;
                                                            phi_11545_ = false;
                                                            phi_11546_ = true;
                                                        }
                                                        let _e12806 = phi_11539_;
                                                        let _e12808 = phi_11540_;
                                                        let _e12810 = phi_11541_;
                                                        let _e12812 = phi_11542_;
                                                        let _e12814 = phi_11543_;
                                                        let _e12816 = phi_11544_;
                                                        let _e12818 = phi_11545_;
                                                        let _e12820 = phi_11546_;
                                                        phi_11547_ = _e12806;
                                                        phi_11548_ = _e12808;
                                                        phi_11549_ = _e12810;
                                                        phi_11550_ = _e12812;
                                                        phi_11551_ = false;
                                                        phi_11552_ = _e12814;
                                                        phi_11553_ = _e12816;
                                                        phi_11554_ = _e12818;
                                                        phi_11555_ = _e12820;
                                                    } else {
                                                        phi_11547_ = f32();
                                                        phi_11548_ = f32();
                                                        phi_11549_ = f32();
                                                        phi_11550_ = f32();
                                                        phi_11551_ = true;
                                                        phi_11552_ = false;
                                                        phi_11553_ = false;
                                                        phi_11554_ = false;
                                                        phi_11555_ = false;
                                                    }
                                                    let _e12822 = phi_11547_;
                                                    let _e12824 = phi_11548_;
                                                    let _e12826 = phi_11549_;
                                                    let _e12828 = phi_11550_;
                                                    let _e12830 = phi_11551_;
                                                    let _e12832 = phi_11552_;
                                                    let _e12834 = phi_11553_;
                                                    let _e12836 = phi_11554_;
                                                    let _e12838 = phi_11555_;
                                                    phi_11556_ = _e12822;
                                                    phi_11557_ = _e12824;
                                                    phi_11558_ = _e12826;
                                                    phi_11559_ = _e12828;
                                                    phi_11560_ = _e12830;
                                                    phi_11561_ = _e12832;
                                                    phi_11562_ = _e12834;
                                                    phi_11563_ = _e12836;
                                                    phi_11564_ = _e12838;
                                                } else {
                                                    phi_11556_ = f32();
                                                    phi_11557_ = f32();
                                                    phi_11558_ = f32();
                                                    phi_11559_ = f32();
                                                    phi_11560_ = true;
                                                    phi_11561_ = false;
                                                    phi_11562_ = false;
                                                    phi_11563_ = false;
                                                    phi_11564_ = false;
                                                }
                                                let _e12840 = phi_11556_;
                                                let _e12842 = phi_11557_;
                                                let _e12844 = phi_11558_;
                                                let _e12846 = phi_11559_;
                                                let _e12848 = phi_11560_;
                                                let _e12850 = phi_11561_;
                                                let _e12852 = phi_11562_;
                                                let _e12854 = phi_11563_;
                                                let _e12856 = phi_11564_;
                                                if _e12848 {
                                                    if (_e11674 <= _e11676) {
                                                        let _e13017 = (_e11684 + 1u);
                                                        let _e13018 = (_e13017 > 3u);
                                                        if _e13018 {
                                                            phi_11577_ = false;
                                                        } else {
                                                            phi_11577_ = true;
                                                        }
                                                        let _e13020 = phi_11577_;
                                                        phi_11899_ = _e13017;
                                                        phi_11900_ = f32();
                                                        phi_11901_ = false;
                                                        phi_11902_ = _e13020;
                                                        phi_11903_ = _e13018;
                                                    } else {
                                                        let _e12860 = local_16.member[0u];
                                                        let _e12863 = local_16.member_1[0u];
                                                        let _e12866 = local_16.member[0u];
                                                        let _e12872 = local_16.member_2[0u];
                                                        let _e12873 = ((_e12860 + ((_e12863 - _e12866) * _e11680)) - _e12872);
                                                        let _e12876 = local_16.member[1u];
                                                        let _e12879 = local_16.member_1[1u];
                                                        let _e12882 = local_16.member[1u];
                                                        let _e12888 = local_16.member_2[1u];
                                                        let _e12889 = ((_e12876 + ((_e12879 - _e12882) * _e11680)) - _e12888);
                                                        if (_e12873 < _e12889) {
                                                            phi_11650_ = _e12873;
                                                        } else {
                                                            phi_11650_ = _e12889;
                                                        }
                                                        let _e12892 = phi_11650_;
                                                        let _e12895 = local_16.member[2u];
                                                        let _e12898 = local_16.member_1[2u];
                                                        let _e12901 = local_16.member[2u];
                                                        let _e12907 = local_16.member_2[2u];
                                                        let _e12908 = ((_e12895 + ((_e12898 - _e12901) * _e11680)) - _e12907);
                                                        let _e12911 = local_16.member[3u];
                                                        let _e12914 = local_16.member_1[3u];
                                                        let _e12917 = local_16.member[3u];
                                                        let _e12923 = local_16.member_2[3u];
                                                        let _e12924 = ((_e12911 + ((_e12914 - _e12917) * _e11680)) - _e12923);
                                                        if (_e12908 < _e12924) {
                                                            phi_11723_ = _e12908;
                                                        } else {
                                                            phi_11723_ = _e12924;
                                                        }
                                                        let _e12927 = phi_11723_;
                                                        if (_e12892 < _e12927) {
                                                            phi_11728_ = _e12892;
                                                        } else {
                                                            phi_11728_ = _e12927;
                                                        }
                                                        let _e12930 = phi_11728_;
                                                        let _e12933 = local_17.member[0u];
                                                        let _e12936 = local_17.member_1[0u];
                                                        let _e12939 = local_17.member[0u];
                                                        let _e12945 = local_17.member_2[0u];
                                                        let _e12946 = ((_e12933 + ((_e12936 - _e12939) * _e11674)) - _e12945);
                                                        let _e12949 = local_17.member[1u];
                                                        let _e12952 = local_17.member_1[1u];
                                                        let _e12955 = local_17.member[1u];
                                                        let _e12961 = local_17.member_2[1u];
                                                        let _e12962 = ((_e12949 + ((_e12952 - _e12955) * _e11674)) - _e12961);
                                                        if (_e12946 < _e12962) {
                                                            phi_11801_ = _e12946;
                                                        } else {
                                                            phi_11801_ = _e12962;
                                                        }
                                                        let _e12965 = phi_11801_;
                                                        let _e12968 = local_17.member[2u];
                                                        let _e12971 = local_17.member_1[2u];
                                                        let _e12974 = local_17.member[2u];
                                                        let _e12980 = local_17.member_2[2u];
                                                        let _e12981 = ((_e12968 + ((_e12971 - _e12974) * _e11674)) - _e12980);
                                                        let _e12984 = local_17.member[3u];
                                                        let _e12987 = local_17.member_1[3u];
                                                        let _e12990 = local_17.member[3u];
                                                        let _e12996 = local_17.member_2[3u];
                                                        let _e12997 = ((_e12984 + ((_e12987 - _e12990) * _e11674)) - _e12996);
                                                        if (_e12981 < _e12997) {
                                                            phi_11874_ = _e12981;
                                                        } else {
                                                            phi_11874_ = _e12997;
                                                        }
                                                        let _e13000 = phi_11874_;
                                                        if (_e12965 < _e13000) {
                                                            phi_11879_ = _e12965;
                                                        } else {
                                                            phi_11879_ = _e13000;
                                                        }
                                                        let _e13003 = phi_11879_;
                                                        if (_e13003 > 0f) {
                                                            phi_11897_ = 0.5f;
                                                        } else {
                                                            let _e13007 = (0.95f * (_e12930 / (_e12930 - _e13003)));
                                                            if (_e13007 > 0.0625f) {
                                                                if (_e13007 < 0.9f) {
                                                                    phi_11895_ = _e13007;
                                                                } else {
                                                                    phi_11895_ = 0.9f;
                                                                }
                                                                let _e13011 = phi_11895_;
                                                                phi_11896_ = _e13011;
                                                            } else {
                                                                phi_11896_ = 0.0625f;
                                                            }
                                                            let _e13013 = phi_11896_;
                                                            phi_11897_ = _e13013;
                                                        }
                                                        let _e13015 = phi_11897_;
                                                        phi_11899_ = u32();
                                                        phi_11900_ = (_e12002 * _e13015);
                                                        phi_11901_ = true;
                                                        phi_11902_ = false;
                                                        phi_11903_ = false;
                                                    }
                                                    let _e13022 = phi_11899_;
                                                    let _e13024 = phi_11900_;
                                                    let _e13026 = phi_11901_;
                                                    let _e13028 = phi_11902_;
                                                    let _e13030 = phi_11903_;
                                                    phi_11904_ = _e13022;
                                                    phi_11905_ = _e11676;
                                                    phi_11906_ = _e13024;
                                                    phi_11907_ = _e11678;
                                                    phi_11908_ = _e11680;
                                                    phi_11909_ = _e11682;
                                                    phi_11910_ = _e11684;
                                                    phi_11911_ = _e13026;
                                                    phi_11912_ = _e13028;
                                                    phi_11913_ = _e13030;
                                                    phi_11914_ = false;
                                                    phi_11915_ = false;
                                                    phi_11916_ = false;
                                                } else {
                                                    phi_11904_ = u32();
                                                    phi_11905_ = _e12840;
                                                    phi_11906_ = _e12842;
                                                    phi_11907_ = _e12844;
                                                    phi_11908_ = _e11674;
                                                    phi_11909_ = true;
                                                    phi_11910_ = 0u;
                                                    phi_11911_ = _e12850;
                                                    phi_11912_ = false;
                                                    phi_11913_ = false;
                                                    phi_11914_ = _e12852;
                                                    phi_11915_ = _e12854;
                                                    phi_11916_ = _e12856;
                                                }
                                                let _e13032 = phi_11904_;
                                                let _e13034 = phi_11905_;
                                                let _e13036 = phi_11906_;
                                                let _e13038 = phi_11907_;
                                                let _e13040 = phi_11908_;
                                                let _e13042 = phi_11909_;
                                                let _e13044 = phi_11910_;
                                                let _e13046 = phi_11911_;
                                                let _e13048 = phi_11912_;
                                                let _e13050 = phi_11913_;
                                                let _e13052 = phi_11914_;
                                                let _e13054 = phi_11915_;
                                                let _e13056 = phi_11916_;
                                                if _e13046 {
                                                    let _e13057 = (_e13040 + _e13036);
                                                    if (_e13057 > _e13034) {
                                                        phi_11925_ = _e13057;
                                                    } else {
                                                        phi_11925_ = _e13034;
                                                    }
                                                    let _e13060 = phi_11925_;
                                                    if (_e13060 < _e5606) {
                                                        phi_11930_ = _e13060;
                                                    } else {
                                                        phi_11930_ = _e5606;
                                                    }
                                                    let _e13063 = phi_11930_;
                                                    if !(_e11682) {
                                                        phi_11939_ = true;
                                                    } else {
                                                        phi_11939_ = ((_e13063 - _e13040) > _e11669);
                                                    }
                                                    let _e13067 = phi_11939_;
                                                    if _e13067 {
                                                        phi_11943_ = false;
                                                    } else {
                                                        phi_11943_ = true;
                                                    }
                                                    let _e13069 = phi_11943_;
                                                    phi_11944_ = _e13063;
                                                    phi_11945_ = _e13034;
                                                    phi_11946_ = _e13038;
                                                    phi_11947_ = _e13040;
                                                    phi_11948_ = _e13042;
                                                    phi_11949_ = _e13044;
                                                    phi_11950_ = _e13067;
                                                    phi_11951_ = _e13069;
                                                    phi_11952_ = false;
                                                    phi_11953_ = false;
                                                    phi_11954_ = false;
                                                    phi_11955_ = false;
                                                } else {
                                                    phi_11944_ = _e11674;
                                                    phi_11945_ = _e11676;
                                                    phi_11946_ = _e11678;
                                                    phi_11947_ = _e11680;
                                                    phi_11948_ = _e11682;
                                                    phi_11949_ = _e13032;
                                                    phi_11950_ = _e13048;
                                                    phi_11951_ = false;
                                                    phi_11952_ = _e13050;
                                                    phi_11953_ = _e13052;
                                                    phi_11954_ = _e13054;
                                                    phi_11955_ = _e13056;
                                                }
                                                let _e13071 = phi_11944_;
                                                let _e13073 = phi_11945_;
                                                let _e13075 = phi_11946_;
                                                let _e13077 = phi_11947_;
                                                let _e13079 = phi_11948_;
                                                let _e13081 = phi_11949_;
                                                let _e13083 = phi_11950_;
                                                let _e13085 = phi_11951_;
                                                let _e13087 = phi_11952_;
                                                let _e13089 = phi_11953_;
                                                let _e13091 = phi_11954_;
                                                let _e13093 = phi_11955_;
                                                phi_9777_ = _e13071;
                                                phi_9779_ = _e13073;
                                                phi_9781_ = _e13075;
                                                phi_9783_ = _e13077;
                                                phi_9785_ = _e13079;
                                                phi_9787_ = _e13081;
                                                phi_11956_ = _e13034;
                                                phi_11957_ = _e12846;
                                                phi_11958_ = _e13083;
                                                phi_11959_ = _e13085;
                                                phi_11960_ = _e13087;
                                                phi_11961_ = _e13089;
                                                phi_11962_ = _e13091;
                                                phi_11963_ = false;
                                                phi_11964_ = _e13093;
                                            } else {
                                                phi_9777_ = f32();
                                                phi_9779_ = f32();
                                                phi_9781_ = f32();
                                                phi_9783_ = f32();
                                                phi_9785_ = bool();
                                                phi_9787_ = u32();
                                                phi_11956_ = f32();
                                                phi_11957_ = f32();
                                                phi_11958_ = false;
                                                phi_11959_ = false;
                                                phi_11960_ = false;
                                                phi_11961_ = false;
                                                phi_11962_ = false;
                                                phi_11963_ = true;
                                                phi_11964_ = false;
                                            }
                                            let _e13095 = phi_9777_;
                                            let _e13097 = phi_9779_;
                                            let _e13099 = phi_9781_;
                                            let _e13101 = phi_9783_;
                                            let _e13103 = phi_9785_;
                                            let _e13105 = phi_9787_;
                                            let _e13107 = phi_11956_;
                                            let _e13109 = phi_11957_;
                                            let _e13111 = phi_11958_;
                                            let _e13113 = phi_11959_;
                                            let _e13115 = phi_11960_;
                                            let _e13117 = phi_11961_;
                                            let _e13119 = phi_11962_;
                                            let _e13121 = phi_11963_;
                                            let _e13123 = phi_11964_;
                                            local_108 = _e13113;
                                            local_149 = _e13115;
                                            local_150 = _e13117;
                                            local_151 = _e13119;
                                            local_152 = _e13121;
                                            local_153 = _e13123;
                                            local_154 = _e13113;
                                            local_155 = _e13109;
                                            local_156 = _e13107;
                                            continue;
                                            continuing {
                                                phi_9773_ = _e11696;
                                                phi_9776_ = _e13095;
                                                phi_9778_ = _e13097;
                                                phi_9780_ = _e13099;
                                                phi_9782_ = _e13101;
                                                phi_9784_ = _e13103;
                                                phi_9786_ = _e13105;
                                                break if !(_e13111);
                                            }
                                        }
                                        let _e13126 = local_108;
                                        if _e13126 {
                                            phi_11968_ = false;
                                            phi_11969_ = false;
                                            phi_11970_ = false;
                                            phi_11971_ = false;
                                            phi_11972_ = false;
                                        } else {
                                            let _e17103 = local_149;
                                            phi_11968_ = _e17103;
                                            let _e17106 = local_150;
                                            phi_11969_ = _e17106;
                                            let _e17109 = local_151;
                                            phi_11970_ = _e17109;
                                            let _e17112 = local_152;
                                            phi_11971_ = _e17112;
                                            let _e17115 = local_153;
                                            phi_11972_ = _e17115;
                                        }
                                        let _e13128 = phi_11968_;
                                        let _e13130 = phi_11969_;
                                        let _e13132 = phi_11970_;
                                        let _e13134 = phi_11971_;
                                        let _e13136 = phi_11972_;
                                        if _e13128 {
                                            let _e13138 = local_109;
                                            phi_11977_ = type_44(1u, _e13138);
                                            phi_11978_ = false;
                                            phi_11979_ = false;
                                            phi_11980_ = false;
                                            phi_11981_ = false;
                                            phi_11982_ = false;
                                        } else {
                                            phi_11977_ = type_44();
                                            phi_11978_ = _e13130;
                                            phi_11979_ = _e13132;
                                            let _e17122 = local_154;
                                            phi_11980_ = _e17122;
                                            phi_11981_ = _e13134;
                                            phi_11982_ = _e13136;
                                        }
                                        let _e13141 = phi_11977_;
                                        let _e13143 = phi_11978_;
                                        let _e13145 = phi_11979_;
                                        let _e13147 = phi_11980_;
                                        let _e13149 = phi_11981_;
                                        let _e13151 = phi_11982_;
                                        if _e13143 {
                                            phi_11987_ = type_44(0u, type_44().member_1);
                                            phi_11988_ = false;
                                            phi_11989_ = false;
                                            phi_11990_ = false;
                                            phi_11991_ = false;
                                            phi_11992_ = true;
                                        } else {
                                            phi_11987_ = _e13141;
                                            phi_11988_ = _e13145;
                                            phi_11989_ = _e13147;
                                            phi_11990_ = _e13149;
                                            phi_11991_ = _e13151;
                                            phi_11992_ = _e13128;
                                        }
                                        let _e13155 = phi_11987_;
                                        let _e13157 = phi_11988_;
                                        let _e13159 = phi_11989_;
                                        let _e13161 = phi_11990_;
                                        let _e13163 = phi_11991_;
                                        let _e13165 = phi_11992_;
                                        if _e13157 {
                                            let _e17133 = local_155;
                                            phi_11996_ = _e17133;
                                            phi_11997_ = true;
                                            phi_11998_ = false;
                                            phi_11999_ = false;
                                            phi_12000_ = false;
                                        } else {
                                            let _e17135 = local_156;
                                            phi_11996_ = _e17135;
                                            phi_11997_ = _e13159;
                                            phi_11998_ = _e13161;
                                            phi_11999_ = _e13163;
                                            phi_12000_ = _e13165;
                                        }
                                        let _e13167 = phi_11996_;
                                        let _e13169 = phi_11997_;
                                        let _e13171 = phi_11998_;
                                        let _e13173 = phi_11999_;
                                        let _e13175 = phi_12000_;
                                        if _e13169 {
                                            phi_12004_ = _e13167;
                                            phi_12005_ = true;
                                            phi_12006_ = false;
                                            phi_12007_ = false;
                                        } else {
                                            let _e17142 = local_157;
                                            phi_12004_ = _e17142;
                                            phi_12005_ = _e13171;
                                            phi_12006_ = _e13173;
                                            phi_12007_ = _e13175;
                                        }
                                        let _e13177 = phi_12004_;
                                        let _e13179 = phi_12005_;
                                        let _e13181 = phi_12006_;
                                        let _e13183 = phi_12007_;
                                        if _e13179 {
                                            phi_12012_ = type_44(1u, _e13177);
                                            phi_12013_ = false;
                                            phi_12014_ = false;
                                        } else {
                                            phi_12012_ = type_44();
                                            phi_12013_ = _e13181;
                                            phi_12014_ = _e13183;
                                        }
                                        let _e13186 = phi_12012_;
                                        let _e13188 = phi_12013_;
                                        let _e13190 = phi_12014_;
                                        if _e13188 {
                                            phi_12019_ = type_44(0u, type_44().member_1);
                                            phi_12020_ = true;
                                        } else {
                                            phi_12019_ = _e13155;
                                            phi_12020_ = _e13190;
                                        }
                                        let _e13194 = phi_12019_;
                                        let _e13196 = phi_12020_;
                                        if _e13196 {
                                            phi_12024_ = _e13194;
                                        } else {
                                            phi_12024_ = _e13186;
                                        }
                                        let _e13198 = phi_12024_;
                                        phi_12031_ = _e13198.member_1;
                                        phi_12032_ = (_e13198.member != 0u);
                                    } else {
                                        phi_12031_ = _e11394;
                                        phi_12032_ = true;
                                    }
                                    let _e13203 = phi_12031_;
                                    let _e13205 = phi_12032_;
                                    if _e13205 {
                                        let _e13206 = (_e13203 > _e5604);
                                        if _e13206 {
                                            phi_14197_ = f32();
                                            phi_14198_ = u32();
                                            phi_14199_ = f32();
                                            phi_14200_ = type_46();
                                            phi_14201_ = u32();
                                            phi_14202_ = u32();
                                            phi_14203_ = false;
                                            phi_14204_ = false;
                                            phi_14205_ = false;
                                        } else {
                                            let _e13209 = local_18.member[0u];
                                            let _e13215 = local_18.member[1u];
                                            let _e13231 = local_18.member_1[0u];
                                            let _e13237 = local_18.member_1[1u];
                                            let _e13253 = local_18.member_2[0u];
                                            let _e13259 = local_18.member_2[1u];
                                            let _e13273 = function_3(array<f32, 3>((_e13209[0] + ((_e13215[0] - _e13209[0]) * _e11398)), (_e13209[1] + ((_e13215[1] - _e13209[1]) * _e11398)), (_e13209[2] + ((_e13215[2] - _e13209[2]) * _e11398))), array<f32, 3>((_e13231[0] + ((_e13237[0] - _e13231[0]) * _e11398)), (_e13231[1] + ((_e13237[1] - _e13231[1]) * _e11398)), (_e13231[2] + ((_e13237[2] - _e13231[2]) * _e11398))), array<f32, 3>((_e13253[0] + ((_e13259[0] - _e13253[0]) * _e11398)), (_e13253[1] + ((_e13259[1] - _e13253[1]) * _e11398)), (_e13253[2] + ((_e13259[2] - _e13253[2]) * _e11398))), _e316.member);
                                            if (_e13273[0] < 0f) {
                                                phi_12144_ = -(_e13273[0]);
                                            } else {
                                                phi_12144_ = _e13273[0];
                                            }
                                            let _e13278 = phi_12144_;
                                            if (_e13273[1] < 0f) {
                                                phi_12151_ = -(_e13273[1]);
                                            } else {
                                                phi_12151_ = _e13273[1];
                                            }
                                            let _e13283 = phi_12151_;
                                            if (_e13273[2] < 0f) {
                                                phi_12159_ = -(_e13273[2]);
                                            } else {
                                                phi_12159_ = _e13273[2];
                                            }
                                            let _e13289 = phi_12159_;
                                            let _e13290 = ((_e13278 + _e13283) + _e13289);
                                            let _e13293 = local_18.member[0u];
                                            let _e13300 = local_18.member_1[0u];
                                            let _e13306 = local_18.member_2[0u];
                                            let _e13310 = (_e13293[0] - _e13300[0]);
                                            let _e13311 = (_e13293[1] - _e13300[1]);
                                            let _e13312 = (_e13293[2] - _e13300[2]);
                                            if (_e316.member == 0u) {
                                                phi_12217_ = array<f32, 3>(_e13293[0], _e13293[1], _e13293[2]);
                                            } else {
                                                phi_12217_ = array<f32, 3>((_e13310 - _e13306[0]), (_e13311 - _e13306[1]), (_e13312 - _e13306[2]));
                                            }
                                            let _e13319 = phi_12217_;
                                            let _e13325 = local_18.member[1u];
                                            let _e13332 = local_18.member_1[1u];
                                            let _e13338 = local_18.member_2[1u];
                                            let _e13342 = (_e13325[0] - _e13332[0]);
                                            let _e13343 = (_e13325[1] - _e13332[1]);
                                            let _e13344 = (_e13325[2] - _e13332[2]);
                                            if (_e316.member == 0u) {
                                                phi_12285_ = array<f32, 3>(_e13325[0], _e13325[1], _e13325[2]);
                                            } else {
                                                phi_12285_ = array<f32, 3>((_e13342 - _e13338[0]), (_e13343 - _e13338[1]), (_e13344 - _e13338[2]));
                                            }
                                            let _e13351 = phi_12285_;
                                            let _e13357 = local_18.member[0u];
                                            if (_e13357[0] < 0f) {
                                                phi_12310_ = -(_e13357[0]);
                                            } else {
                                                phi_12310_ = _e13357[0];
                                            }
                                            let _e13364 = phi_12310_;
                                            if (_e13357[1] < 0f) {
                                                phi_12317_ = -(_e13357[1]);
                                            } else {
                                                phi_12317_ = _e13357[1];
                                            }
                                            let _e13368 = phi_12317_;
                                            if (_e13364 > _e13368) {
                                                phi_12322_ = _e13364;
                                            } else {
                                                phi_12322_ = _e13368;
                                            }
                                            let _e13371 = phi_12322_;
                                            if (_e13357[2] < 0f) {
                                                phi_12329_ = -(_e13357[2]);
                                            } else {
                                                phi_12329_ = _e13357[2];
                                            }
                                            let _e13375 = phi_12329_;
                                            if (_e13371 > _e13375) {
                                                phi_12334_ = _e13371;
                                            } else {
                                                phi_12334_ = _e13375;
                                            }
                                            let _e13378 = phi_12334_;
                                            let _e13381 = local_18.member[1u];
                                            if (_e13381[0] < 0f) {
                                                phi_12347_ = -(_e13381[0]);
                                            } else {
                                                phi_12347_ = _e13381[0];
                                            }
                                            let _e13388 = phi_12347_;
                                            if (_e13381[1] < 0f) {
                                                phi_12354_ = -(_e13381[1]);
                                            } else {
                                                phi_12354_ = _e13381[1];
                                            }
                                            let _e13392 = phi_12354_;
                                            if (_e13388 > _e13392) {
                                                phi_12359_ = _e13388;
                                            } else {
                                                phi_12359_ = _e13392;
                                            }
                                            let _e13395 = phi_12359_;
                                            if (_e13381[2] < 0f) {
                                                phi_12366_ = -(_e13381[2]);
                                            } else {
                                                phi_12366_ = _e13381[2];
                                            }
                                            let _e13399 = phi_12366_;
                                            if (_e13395 > _e13399) {
                                                phi_12371_ = _e13395;
                                            } else {
                                                phi_12371_ = _e13399;
                                            }
                                            let _e13402 = phi_12371_;
                                            if (_e13378 > _e13402) {
                                                phi_12376_ = _e13378;
                                            } else {
                                                phi_12376_ = _e13402;
                                            }
                                            let _e13405 = phi_12376_;
                                            let _e13407 = local_18.member_3;
                                            let _e13411 = local_18.member_1[0u];
                                            if (_e13411[0] < 0f) {
                                                phi_12393_ = -(_e13411[0]);
                                            } else {
                                                phi_12393_ = _e13411[0];
                                            }
                                            let _e13418 = phi_12393_;
                                            if (_e13411[1] < 0f) {
                                                phi_12400_ = -(_e13411[1]);
                                            } else {
                                                phi_12400_ = _e13411[1];
                                            }
                                            let _e13422 = phi_12400_;
                                            if (_e13418 > _e13422) {
                                                phi_12405_ = _e13418;
                                            } else {
                                                phi_12405_ = _e13422;
                                            }
                                            let _e13425 = phi_12405_;
                                            if (_e13411[2] < 0f) {
                                                phi_12412_ = -(_e13411[2]);
                                            } else {
                                                phi_12412_ = _e13411[2];
                                            }
                                            let _e13429 = phi_12412_;
                                            if (_e13425 > _e13429) {
                                                phi_12417_ = _e13425;
                                            } else {
                                                phi_12417_ = _e13429;
                                            }
                                            let _e13432 = phi_12417_;
                                            let _e13435 = local_18.member_1[1u];
                                            if (_e13435[0] < 0f) {
                                                phi_12431_ = -(_e13435[0]);
                                            } else {
                                                phi_12431_ = _e13435[0];
                                            }
                                            let _e13442 = phi_12431_;
                                            if (_e13435[1] < 0f) {
                                                phi_12438_ = -(_e13435[1]);
                                            } else {
                                                phi_12438_ = _e13435[1];
                                            }
                                            let _e13446 = phi_12438_;
                                            if (_e13442 > _e13446) {
                                                phi_12443_ = _e13442;
                                            } else {
                                                phi_12443_ = _e13446;
                                            }
                                            let _e13449 = phi_12443_;
                                            if (_e13435[2] < 0f) {
                                                phi_12450_ = -(_e13435[2]);
                                            } else {
                                                phi_12450_ = _e13435[2];
                                            }
                                            let _e13453 = phi_12450_;
                                            if (_e13449 > _e13453) {
                                                phi_12455_ = _e13449;
                                            } else {
                                                phi_12455_ = _e13453;
                                            }
                                            let _e13456 = phi_12455_;
                                            if (_e13432 > _e13456) {
                                                phi_12460_ = _e13432;
                                            } else {
                                                phi_12460_ = _e13456;
                                            }
                                            let _e13459 = phi_12460_;
                                            let _e13461 = local_18.member_3;
                                            let _e13465 = local_18.member_2[0u];
                                            if (_e13465[0] < 0f) {
                                                phi_12477_ = -(_e13465[0]);
                                            } else {
                                                phi_12477_ = _e13465[0];
                                            }
                                            let _e13472 = phi_12477_;
                                            if (_e13465[1] < 0f) {
                                                phi_12484_ = -(_e13465[1]);
                                            } else {
                                                phi_12484_ = _e13465[1];
                                            }
                                            let _e13476 = phi_12484_;
                                            if (_e13472 > _e13476) {
                                                phi_12489_ = _e13472;
                                            } else {
                                                phi_12489_ = _e13476;
                                            }
                                            let _e13479 = phi_12489_;
                                            if (_e13465[2] < 0f) {
                                                phi_12496_ = -(_e13465[2]);
                                            } else {
                                                phi_12496_ = _e13465[2];
                                            }
                                            let _e13483 = phi_12496_;
                                            if (_e13479 > _e13483) {
                                                phi_12501_ = _e13479;
                                            } else {
                                                phi_12501_ = _e13483;
                                            }
                                            let _e13486 = phi_12501_;
                                            let _e13489 = local_18.member_2[1u];
                                            if (_e13489[0] < 0f) {
                                                phi_12515_ = -(_e13489[0]);
                                            } else {
                                                phi_12515_ = _e13489[0];
                                            }
                                            let _e13496 = phi_12515_;
                                            if (_e13489[1] < 0f) {
                                                phi_12522_ = -(_e13489[1]);
                                            } else {
                                                phi_12522_ = _e13489[1];
                                            }
                                            let _e13500 = phi_12522_;
                                            if (_e13496 > _e13500) {
                                                phi_12527_ = _e13496;
                                            } else {
                                                phi_12527_ = _e13500;
                                            }
                                            let _e13503 = phi_12527_;
                                            if (_e13489[2] < 0f) {
                                                phi_12534_ = -(_e13489[2]);
                                            } else {
                                                phi_12534_ = _e13489[2];
                                            }
                                            let _e13507 = phi_12534_;
                                            if (_e13503 > _e13507) {
                                                phi_12539_ = _e13503;
                                            } else {
                                                phi_12539_ = _e13507;
                                            }
                                            let _e13510 = phi_12539_;
                                            if (_e13486 > _e13510) {
                                                phi_12544_ = _e13486;
                                            } else {
                                                phi_12544_ = _e13510;
                                            }
                                            let _e13513 = phi_12544_;
                                            let _e13515 = local_18.member_3;
                                            let _e13522 = local_18.member_3;
                                            local_14 = type_33(array<array<array<f32, 3>, 4>, 2>(array<array<f32, 3>, 4>(_e13293, array<f32, 3>(_e13310, _e13311, _e13312), array<f32, 3>((_e13293[0] - _e13306[0]), (_e13293[1] - _e13306[1]), (_e13293[2] - _e13306[2])), array<f32, 3>(_e13319[0], _e13319[1], _e13319[2])), array<array<f32, 3>, 4>(_e13325, array<f32, 3>(_e13342, _e13343, _e13344), array<f32, 3>((_e13325[0] - _e13338[0]), (_e13325[1] - _e13338[1]), (_e13325[2] - _e13338[2])), array<f32, 3>(_e13351[0], _e13351[1], _e13351[2]))), ((((((_e13405 + _e13407) + (_e13459 + _e13461)) + (_e13513 + _e13515)) * (0.000000059604645f * 16f)) + (_e13522 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)), _e5872.member_1);
                                            let _e13544 = local_14.member_1;
                                            if (_e13290 > _e13544) {
                                                if ((bitcast<u32>(_e13290) & 2139095040u) != 2139095040u) {
                                                    let _e13549 = (1f / _e13290);
                                                    let _e13551 = (_e13273[0] * _e13549);
                                                    let _e13553 = (_e13273[1] * _e13549);
                                                    let _e13555 = (_e13273[2] * _e13549);
                                                    let _e13560 = (((_e13551 * _e13551) + (_e13553 * _e13553)) + (_e13555 * _e13555));
                                                    if (_e13560 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e13560 > 0f) {
                                                            phi_12645_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_12645_ = 0f;
                                                        }
                                                        let _e13613 = phi_12645_;
                                                        phi_12709_ = _e13613;
                                                    } else {
                                                        phi_12652_ = type_14(0i, 5i);
                                                        phi_12655_ = bitcast<f32>(((bitcast<u32>(_e13560) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e13568 = phi_12652_;
                                                            let _e13570 = phi_12655_;
                                                            local_110 = _e13570;
                                                            if (_e13568.member < _e13568.member_1) {
                                                                let _e13577 = (_e13568.member + 1i);
                                                                if ((false == (_e13577 > _e13568.member)) != false) {
                                                                    phi_12676_ = true;
                                                                } else {
                                                                    phi_12676_ = false;
                                                                }
                                                                let _e13582 = phi_12676_;
                                                                if _e13582 {
                                                                    phi_12682_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_12682_ = type_15(1u, _e13577);
                                                                }
                                                                let _e13587 = phi_12682_;
                                                                phi_12653_ = type_14(_e13587.member_1, _e13568.member_1);
                                                                phi_12696_ = type_15(1u, _e13568.member);
                                                            } else {
                                                                phi_12653_ = _e13568;
                                                                phi_12696_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e13593 = phi_12653_;
                                                            let _e13595 = phi_12696_;
                                                            let _e13598 = (bitcast<i32>(_e13595.member) != 0i);
                                                            if _e13598 {
                                                                phi_12656_ = (0.5f * (_e13570 + (_e13560 / _e13570)));
                                                            } else {
                                                                phi_12656_ = f32();
                                                            }
                                                            let _e13603 = phi_12656_;
                                                            continue;
                                                            continuing {
                                                                phi_12652_ = _e13593;
                                                                phi_12655_ = _e13603;
                                                                break if !(_e13598);
                                                            }
                                                        }
                                                        let _e13608 = local_110;
                                                        phi_12709_ = (_e13608 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e13615 = phi_12709_;
                                                    let _e13616 = (0.000000059604645f * 12f);
                                                    let _e13618 = local_14.member_1;
                                                    let _e13621 = local_14.member_2;
                                                    let _e13625 = ((_e13618 * 1.01f) + ((_e13621 * _e13615) * (1f + _e13616)));
                                                    let _e13629 = local_14.member[0u][0u];
                                                    let _e13637 = (((_e13551 * _e13629[0]) + (_e13553 * _e13629[1])) + (_e13555 * _e13629[2]));
                                                    let _e13641 = local_14.member[0u][1u];
                                                    let _e13649 = (((_e13551 * _e13641[0]) + (_e13553 * _e13641[1])) + (_e13555 * _e13641[2]));
                                                    let _e13653 = local_14.member[0u][2u];
                                                    let _e13661 = (((_e13551 * _e13653[0]) + (_e13553 * _e13653[1])) + (_e13555 * _e13653[2]));
                                                    let _e13665 = local_14.member[0u][3u];
                                                    let _e13673 = (((_e13551 * _e13665[0]) + (_e13553 * _e13665[1])) + (_e13555 * _e13665[2]));
                                                    let _e13677 = local_14.member[1u][0u];
                                                    let _e13685 = (((_e13551 * _e13677[0]) + (_e13553 * _e13677[1])) + (_e13555 * _e13677[2]));
                                                    let _e13689 = local_14.member[1u][1u];
                                                    let _e13697 = (((_e13551 * _e13689[0]) + (_e13553 * _e13689[1])) + (_e13555 * _e13689[2]));
                                                    let _e13701 = local_14.member[1u][2u];
                                                    let _e13709 = (((_e13551 * _e13701[0]) + (_e13553 * _e13701[1])) + (_e13555 * _e13701[2]));
                                                    let _e13713 = local_14.member[1u][3u];
                                                    let _e13721 = (((_e13551 * _e13713[0]) + (_e13553 * _e13713[1])) + (_e13555 * _e13713[2]));
                                                    if (_e13637 < 0f) {
                                                        phi_12843_ = -(_e13637);
                                                    } else {
                                                        phi_12843_ = _e13637;
                                                    }
                                                    let _e13725 = phi_12843_;
                                                    if (_e13685 < 0f) {
                                                        phi_12849_ = -(_e13685);
                                                    } else {
                                                        phi_12849_ = _e13685;
                                                    }
                                                    let _e13729 = phi_12849_;
                                                    if (_e13649 < 0f) {
                                                        phi_12858_ = -(_e13649);
                                                    } else {
                                                        phi_12858_ = _e13649;
                                                    }
                                                    let _e13736 = phi_12858_;
                                                    if (_e13697 < 0f) {
                                                        phi_12864_ = -(_e13697);
                                                    } else {
                                                        phi_12864_ = _e13697;
                                                    }
                                                    let _e13740 = phi_12864_;
                                                    if (_e13661 < 0f) {
                                                        phi_12873_ = -(_e13661);
                                                    } else {
                                                        phi_12873_ = _e13661;
                                                    }
                                                    let _e13747 = phi_12873_;
                                                    if (_e13709 < 0f) {
                                                        phi_12879_ = -(_e13709);
                                                    } else {
                                                        phi_12879_ = _e13709;
                                                    }
                                                    let _e13751 = phi_12879_;
                                                    if (_e13673 < 0f) {
                                                        phi_12888_ = -(_e13673);
                                                    } else {
                                                        phi_12888_ = _e13673;
                                                    }
                                                    let _e13758 = phi_12888_;
                                                    if (_e13721 < 0f) {
                                                        phi_12894_ = -(_e13721);
                                                    } else {
                                                        phi_12894_ = _e13721;
                                                    }
                                                    let _e13762 = phi_12894_;
                                                    local_15 = type_29(array<f32, 4>(_e13637, _e13649, _e13661, _e13673), array<f32, 4>(_e13685, _e13697, _e13709, _e13721), array<f32, 4>((_e13625 + ((_e13725 + _e13729) * _e13616)), (_e13625 + ((_e13736 + _e13740) * _e13616)), (_e13625 + ((_e13747 + _e13751) * _e13616)), (_e13625 + ((_e13758 + _e13762) * _e13616))));
                                                    let _e13774 = (((_e13551 * _e13551) + (_e13553 * _e13553)) + (_e13555 * _e13555));
                                                    if (_e13774 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e13774 > 0f) {
                                                            phi_12937_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_12937_ = 0f;
                                                        }
                                                        let _e13827 = phi_12937_;
                                                        phi_13001_ = _e13827;
                                                    } else {
                                                        phi_12944_ = type_14(0i, 5i);
                                                        phi_12947_ = bitcast<f32>(((bitcast<u32>(_e13774) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e13782 = phi_12944_;
                                                            let _e13784 = phi_12947_;
                                                            local_111 = _e13784;
                                                            if (_e13782.member < _e13782.member_1) {
                                                                let _e13791 = (_e13782.member + 1i);
                                                                if ((false == (_e13791 > _e13782.member)) != false) {
                                                                    phi_12968_ = true;
                                                                } else {
                                                                    phi_12968_ = false;
                                                                }
                                                                let _e13796 = phi_12968_;
                                                                if _e13796 {
                                                                    phi_12974_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_12974_ = type_15(1u, _e13791);
                                                                }
                                                                let _e13801 = phi_12974_;
                                                                phi_12945_ = type_14(_e13801.member_1, _e13782.member_1);
                                                                phi_12988_ = type_15(1u, _e13782.member);
                                                            } else {
                                                                phi_12945_ = _e13782;
                                                                phi_12988_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e13807 = phi_12945_;
                                                            let _e13809 = phi_12988_;
                                                            let _e13812 = (bitcast<i32>(_e13809.member) != 0i);
                                                            if _e13812 {
                                                                phi_12948_ = (0.5f * (_e13784 + (_e13774 / _e13784)));
                                                            } else {
                                                                phi_12948_ = f32();
                                                            }
                                                            let _e13817 = phi_12948_;
                                                            continue;
                                                            continuing {
                                                                phi_12944_ = _e13807;
                                                                phi_12947_ = _e13817;
                                                                break if !(_e13812);
                                                            }
                                                        }
                                                        let _e13822 = local_111;
                                                        phi_13001_ = (_e13822 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e13829 = phi_13001_;
                                                    let _e13840 = (((_e13273[0] * _e13273[0]) + (_e13273[1] * _e13273[1])) + (_e13273[2] * _e13273[2]));
                                                    if (_e13840 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e13840 > 0f) {
                                                            phi_13026_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_13026_ = 0f;
                                                        }
                                                        let _e13893 = phi_13026_;
                                                        phi_13090_ = _e13893;
                                                    } else {
                                                        phi_13033_ = type_14(0i, 5i);
                                                        phi_13036_ = bitcast<f32>(((bitcast<u32>(_e13840) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e13848 = phi_13033_;
                                                            let _e13850 = phi_13036_;
                                                            local_112 = _e13850;
                                                            if (_e13848.member < _e13848.member_1) {
                                                                let _e13857 = (_e13848.member + 1i);
                                                                if ((false == (_e13857 > _e13848.member)) != false) {
                                                                    phi_13057_ = true;
                                                                } else {
                                                                    phi_13057_ = false;
                                                                }
                                                                let _e13862 = phi_13057_;
                                                                if _e13862 {
                                                                    phi_13063_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_13063_ = type_15(1u, _e13857);
                                                                }
                                                                let _e13867 = phi_13063_;
                                                                phi_13034_ = type_14(_e13867.member_1, _e13848.member_1);
                                                                phi_13077_ = type_15(1u, _e13848.member);
                                                            } else {
                                                                phi_13034_ = _e13848;
                                                                phi_13077_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e13873 = phi_13034_;
                                                            let _e13875 = phi_13077_;
                                                            let _e13878 = (bitcast<i32>(_e13875.member) != 0i);
                                                            if _e13878 {
                                                                phi_13037_ = (0.5f * (_e13850 + (_e13840 / _e13850)));
                                                            } else {
                                                                phi_13037_ = f32();
                                                            }
                                                            let _e13883 = phi_13037_;
                                                            continue;
                                                            continuing {
                                                                phi_13033_ = _e13873;
                                                                phi_13036_ = _e13883;
                                                                break if !(_e13878);
                                                            }
                                                        }
                                                        let _e13888 = local_112;
                                                        phi_13090_ = (_e13888 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e13895 = phi_13090_;
                                                    let _e13901 = local_18.member[0u];
                                                    if (_e13901[0] < 0f) {
                                                        phi_13106_ = -(_e13901[0]);
                                                    } else {
                                                        phi_13106_ = _e13901[0];
                                                    }
                                                    let _e13908 = phi_13106_;
                                                    if (_e13901[1] < 0f) {
                                                        phi_13113_ = -(_e13901[1]);
                                                    } else {
                                                        phi_13113_ = _e13901[1];
                                                    }
                                                    let _e13912 = phi_13113_;
                                                    if (_e13908 > _e13912) {
                                                        phi_13118_ = _e13908;
                                                    } else {
                                                        phi_13118_ = _e13912;
                                                    }
                                                    let _e13915 = phi_13118_;
                                                    if (_e13901[2] < 0f) {
                                                        phi_13125_ = -(_e13901[2]);
                                                    } else {
                                                        phi_13125_ = _e13901[2];
                                                    }
                                                    let _e13919 = phi_13125_;
                                                    if (_e13915 > _e13919) {
                                                        phi_13130_ = _e13915;
                                                    } else {
                                                        phi_13130_ = _e13919;
                                                    }
                                                    let _e13922 = phi_13130_;
                                                    let _e13925 = local_18.member[1u];
                                                    if (_e13925[0] < 0f) {
                                                        phi_13143_ = -(_e13925[0]);
                                                    } else {
                                                        phi_13143_ = _e13925[0];
                                                    }
                                                    let _e13932 = phi_13143_;
                                                    if (_e13925[1] < 0f) {
                                                        phi_13150_ = -(_e13925[1]);
                                                    } else {
                                                        phi_13150_ = _e13925[1];
                                                    }
                                                    let _e13936 = phi_13150_;
                                                    if (_e13932 > _e13936) {
                                                        phi_13155_ = _e13932;
                                                    } else {
                                                        phi_13155_ = _e13936;
                                                    }
                                                    let _e13939 = phi_13155_;
                                                    if (_e13925[2] < 0f) {
                                                        phi_13162_ = -(_e13925[2]);
                                                    } else {
                                                        phi_13162_ = _e13925[2];
                                                    }
                                                    let _e13943 = phi_13162_;
                                                    if (_e13939 > _e13943) {
                                                        phi_13167_ = _e13939;
                                                    } else {
                                                        phi_13167_ = _e13943;
                                                    }
                                                    let _e13946 = phi_13167_;
                                                    if (_e13922 > _e13946) {
                                                        phi_13172_ = _e13922;
                                                    } else {
                                                        phi_13172_ = _e13946;
                                                    }
                                                    let _e13949 = phi_13172_;
                                                    let _e13951 = local_18.member_3;
                                                    let _e13955 = local_18.member_1[0u];
                                                    if (_e13955[0] < 0f) {
                                                        phi_13189_ = -(_e13955[0]);
                                                    } else {
                                                        phi_13189_ = _e13955[0];
                                                    }
                                                    let _e13962 = phi_13189_;
                                                    if (_e13955[1] < 0f) {
                                                        phi_13196_ = -(_e13955[1]);
                                                    } else {
                                                        phi_13196_ = _e13955[1];
                                                    }
                                                    let _e13966 = phi_13196_;
                                                    if (_e13962 > _e13966) {
                                                        phi_13201_ = _e13962;
                                                    } else {
                                                        phi_13201_ = _e13966;
                                                    }
                                                    let _e13969 = phi_13201_;
                                                    if (_e13955[2] < 0f) {
                                                        phi_13208_ = -(_e13955[2]);
                                                    } else {
                                                        phi_13208_ = _e13955[2];
                                                    }
                                                    let _e13973 = phi_13208_;
                                                    if (_e13969 > _e13973) {
                                                        phi_13213_ = _e13969;
                                                    } else {
                                                        phi_13213_ = _e13973;
                                                    }
                                                    let _e13976 = phi_13213_;
                                                    let _e13979 = local_18.member_1[1u];
                                                    if (_e13979[0] < 0f) {
                                                        phi_13227_ = -(_e13979[0]);
                                                    } else {
                                                        phi_13227_ = _e13979[0];
                                                    }
                                                    let _e13986 = phi_13227_;
                                                    if (_e13979[1] < 0f) {
                                                        phi_13234_ = -(_e13979[1]);
                                                    } else {
                                                        phi_13234_ = _e13979[1];
                                                    }
                                                    let _e13990 = phi_13234_;
                                                    if (_e13986 > _e13990) {
                                                        phi_13239_ = _e13986;
                                                    } else {
                                                        phi_13239_ = _e13990;
                                                    }
                                                    let _e13993 = phi_13239_;
                                                    if (_e13979[2] < 0f) {
                                                        phi_13246_ = -(_e13979[2]);
                                                    } else {
                                                        phi_13246_ = _e13979[2];
                                                    }
                                                    let _e13997 = phi_13246_;
                                                    if (_e13993 > _e13997) {
                                                        phi_13251_ = _e13993;
                                                    } else {
                                                        phi_13251_ = _e13997;
                                                    }
                                                    let _e14000 = phi_13251_;
                                                    if (_e13976 > _e14000) {
                                                        phi_13256_ = _e13976;
                                                    } else {
                                                        phi_13256_ = _e14000;
                                                    }
                                                    let _e14003 = phi_13256_;
                                                    let _e14005 = local_18.member_3;
                                                    let _e14009 = local_18.member_2[0u];
                                                    if (_e14009[0] < 0f) {
                                                        phi_13273_ = -(_e14009[0]);
                                                    } else {
                                                        phi_13273_ = _e14009[0];
                                                    }
                                                    let _e14016 = phi_13273_;
                                                    if (_e14009[1] < 0f) {
                                                        phi_13280_ = -(_e14009[1]);
                                                    } else {
                                                        phi_13280_ = _e14009[1];
                                                    }
                                                    let _e14020 = phi_13280_;
                                                    if (_e14016 > _e14020) {
                                                        phi_13285_ = _e14016;
                                                    } else {
                                                        phi_13285_ = _e14020;
                                                    }
                                                    let _e14023 = phi_13285_;
                                                    if (_e14009[2] < 0f) {
                                                        phi_13292_ = -(_e14009[2]);
                                                    } else {
                                                        phi_13292_ = _e14009[2];
                                                    }
                                                    let _e14027 = phi_13292_;
                                                    if (_e14023 > _e14027) {
                                                        phi_13297_ = _e14023;
                                                    } else {
                                                        phi_13297_ = _e14027;
                                                    }
                                                    let _e14030 = phi_13297_;
                                                    let _e14033 = local_18.member_2[1u];
                                                    if (_e14033[0] < 0f) {
                                                        phi_13311_ = -(_e14033[0]);
                                                    } else {
                                                        phi_13311_ = _e14033[0];
                                                    }
                                                    let _e14040 = phi_13311_;
                                                    if (_e14033[1] < 0f) {
                                                        phi_13318_ = -(_e14033[1]);
                                                    } else {
                                                        phi_13318_ = _e14033[1];
                                                    }
                                                    let _e14044 = phi_13318_;
                                                    if (_e14040 > _e14044) {
                                                        phi_13323_ = _e14040;
                                                    } else {
                                                        phi_13323_ = _e14044;
                                                    }
                                                    let _e14047 = phi_13323_;
                                                    if (_e14033[2] < 0f) {
                                                        phi_13330_ = -(_e14033[2]);
                                                    } else {
                                                        phi_13330_ = _e14033[2];
                                                    }
                                                    let _e14051 = phi_13330_;
                                                    if (_e14047 > _e14051) {
                                                        phi_13335_ = _e14047;
                                                    } else {
                                                        phi_13335_ = _e14051;
                                                    }
                                                    let _e14054 = phi_13335_;
                                                    if (_e14030 > _e14054) {
                                                        phi_13340_ = _e14030;
                                                    } else {
                                                        phi_13340_ = _e14054;
                                                    }
                                                    let _e14057 = phi_13340_;
                                                    let _e14059 = local_18.member_3;
                                                    let _e14066 = local_18.member_3;
                                                    let _e14076 = ((((_e13895 * (1f + (0.000000059604645f * 8f))) + (((((((_e13949 + _e13951) + (_e14003 + _e14005)) + (_e14057 + _e14059)) * (0.000000059604645f * 16f)) + (_e14066 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) * _e13829) * (1f + (0.000000059604645f * 64f)));
                                                    let _e14079 = local_15.member[0u];
                                                    let _e14082 = local_15.member_1[0u];
                                                    if (_e14079 < 0f) {
                                                        phi_13381_ = -(_e14079);
                                                    } else {
                                                        phi_13381_ = _e14079;
                                                    }
                                                    let _e14087 = phi_13381_;
                                                    if (_e14082 < 0f) {
                                                        phi_13387_ = -(_e14082);
                                                    } else {
                                                        phi_13387_ = _e14082;
                                                    }
                                                    let _e14091 = phi_13387_;
                                                    phi_13398_ = type_9(1u, 4u);
                                                    phi_13401_ = ((_e14079 + ((_e14082 - _e14079) * _e11398)) - ((_e13544 * 1.01f) + ((_e14087 + _e14091) * (0.000000059604645f * 12f))));
                                                    loop {
                                                        let _e14101 = phi_13398_;
                                                        let _e14103 = phi_13401_;
                                                        local_113 = _e14103;
                                                        local_114 = _e14103;
                                                        if (_e14101.member < _e14101.member_1) {
                                                            phi_13399_ = type_9((_e14101.member + 1u), _e14101.member_1);
                                                            phi_13424_ = type_9(1u, _e14101.member);
                                                        } else {
                                                            phi_13399_ = _e14101;
                                                            phi_13424_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e14115 = phi_13399_;
                                                        let _e14117 = phi_13424_;
                                                        let _e14121 = (bitcast<i32>(_e14117.member) != 0i);
                                                        if _e14121 {
                                                            let _e14124 = local_15.member[_e14117.member_1];
                                                            let _e14127 = local_15.member_1[_e14117.member_1];
                                                            if (_e14124 < 0f) {
                                                                phi_13453_ = -(_e14124);
                                                            } else {
                                                                phi_13453_ = _e14124;
                                                            }
                                                            let _e14132 = phi_13453_;
                                                            if (_e14127 < 0f) {
                                                                phi_13459_ = -(_e14127);
                                                            } else {
                                                                phi_13459_ = _e14127;
                                                            }
                                                            let _e14136 = phi_13459_;
                                                            let _e14144 = ((_e14124 + ((_e14127 - _e14124) * _e11398)) - ((_e13544 * 1.01f) + ((_e14132 + _e14136) * (0.000000059604645f * 12f))));
                                                            if (_e14103 < _e14144) {
                                                                phi_13472_ = _e14103;
                                                            } else {
                                                                phi_13472_ = _e14144;
                                                            }
                                                            let _e14147 = phi_13472_;
                                                            phi_13402_ = _e14147;
                                                        } else {
                                                            phi_13402_ = f32();
                                                        }
                                                        let _e14149 = phi_13402_;
                                                        continue;
                                                        continuing {
                                                            phi_13398_ = _e14115;
                                                            phi_13401_ = _e14149;
                                                            break if !(_e14121);
                                                        }
                                                    }
                                                    let _e14152 = local_113;
                                                    if (_e14152 > 0f) {
                                                        let _e14156 = local_114;
                                                        let _e14159 = (((_e14076 - _e14156) / _e14076) * 2.02f);
                                                        if (_e14159 <= 0.000000000000000000000000000000000000011754944f) {
                                                            if (_e14159 > 0f) {
                                                                phi_13493_ = (0.000000000000000000106433627f * 2f);
                                                            } else {
                                                                phi_13493_ = 0f;
                                                            }
                                                            let _e14212 = phi_13493_;
                                                            phi_13557_ = _e14212;
                                                        } else {
                                                            phi_13500_ = type_14(0i, 5i);
                                                            phi_13503_ = bitcast<f32>(((bitcast<u32>(_e14159) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e14167 = phi_13500_;
                                                                let _e14169 = phi_13503_;
                                                                local_115 = _e14169;
                                                                if (_e14167.member < _e14167.member_1) {
                                                                    let _e14176 = (_e14167.member + 1i);
                                                                    if ((false == (_e14176 > _e14167.member)) != false) {
                                                                        phi_13524_ = true;
                                                                    } else {
                                                                        phi_13524_ = false;
                                                                    }
                                                                    let _e14181 = phi_13524_;
                                                                    if _e14181 {
                                                                        phi_13530_ = type_15(0u, type_15().member_1);
                                                                    } else {
                                                                        phi_13530_ = type_15(1u, _e14176);
                                                                    }
                                                                    let _e14186 = phi_13530_;
                                                                    phi_13501_ = type_14(_e14186.member_1, _e14167.member_1);
                                                                    phi_13544_ = type_15(1u, _e14167.member);
                                                                } else {
                                                                    phi_13501_ = _e14167;
                                                                    phi_13544_ = type_15(0u, type_15().member_1);
                                                                }
                                                                let _e14192 = phi_13501_;
                                                                let _e14194 = phi_13544_;
                                                                let _e14197 = (bitcast<i32>(_e14194.member) != 0i);
                                                                if _e14197 {
                                                                    phi_13504_ = (0.5f * (_e14169 + (_e14159 / _e14169)));
                                                                } else {
                                                                    phi_13504_ = f32();
                                                                }
                                                                let _e14202 = phi_13504_;
                                                                continue;
                                                                continuing {
                                                                    phi_13500_ = _e14192;
                                                                    phi_13503_ = _e14202;
                                                                    break if !(_e14197);
                                                                }
                                                            }
                                                            let _e14207 = local_115;
                                                            phi_13557_ = (_e14207 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e14214 = phi_13557_;
                                                        let _e14216 = ((_e14214 * _e13829) * 1.01f);
                                                        phi_13562_ = type_9(0u, 4u);
                                                        phi_13565_ = 2f;
                                                        phi_13567_ = true;
                                                        phi_13569_ = true;
                                                        loop {
                                                            let _e14218 = phi_13562_;
                                                            let _e14220 = phi_13565_;
                                                            let _e14222 = phi_13567_;
                                                            let _e14224 = phi_13569_;
                                                            local_116 = _e14220;
                                                            local_158 = _e14220;
                                                            local_117 = _e14222;
                                                            local_118 = _e14224;
                                                            local_159 = _e14224;
                                                            local_119 = _e14224;
                                                            if (_e14218.member < _e14218.member_1) {
                                                                phi_13563_ = type_9((_e14218.member + 1u), _e14218.member_1);
                                                                phi_13592_ = type_9(1u, _e14218.member);
                                                            } else {
                                                                phi_13563_ = _e14218;
                                                                phi_13592_ = type_9(0u, type_9().member_1);
                                                            }
                                                            let _e14236 = phi_13563_;
                                                            let _e14238 = phi_13592_;
                                                            let _e14242 = (bitcast<i32>(_e14238.member) != 0i);
                                                            if _e14242 {
                                                                let _e14246 = local_14.member[0u][_e14238.member_1];
                                                                let _e14253 = local_14.member[1u][_e14238.member_1];
                                                                if (_e14246[0] < 0f) {
                                                                    phi_13629_ = -(_e14246[0]);
                                                                } else {
                                                                    phi_13629_ = _e14246[0];
                                                                }
                                                                let _e14260 = phi_13629_;
                                                                if (_e14246[1] < 0f) {
                                                                    phi_13636_ = -(_e14246[1]);
                                                                } else {
                                                                    phi_13636_ = _e14246[1];
                                                                }
                                                                let _e14264 = phi_13636_;
                                                                if (_e14246[2] < 0f) {
                                                                    phi_13644_ = -(_e14246[2]);
                                                                } else {
                                                                    phi_13644_ = _e14246[2];
                                                                }
                                                                let _e14269 = phi_13644_;
                                                                let _e14270 = ((_e14260 + _e14264) + _e14269);
                                                                if (_e14253[0] < 0f) {
                                                                    phi_13652_ = -(_e14253[0]);
                                                                } else {
                                                                    phi_13652_ = _e14253[0];
                                                                }
                                                                let _e14274 = phi_13652_;
                                                                if (_e14253[1] < 0f) {
                                                                    phi_13659_ = -(_e14253[1]);
                                                                } else {
                                                                    phi_13659_ = _e14253[1];
                                                                }
                                                                let _e14278 = phi_13659_;
                                                                if (_e14253[2] < 0f) {
                                                                    phi_13667_ = -(_e14253[2]);
                                                                } else {
                                                                    phi_13667_ = _e14253[2];
                                                                }
                                                                let _e14283 = phi_13667_;
                                                                let _e14284 = ((_e14274 + _e14278) + _e14283);
                                                                if (_e14270 > _e14284) {
                                                                    phi_13673_ = _e14270;
                                                                } else {
                                                                    phi_13673_ = _e14284;
                                                                }
                                                                let _e14287 = phi_13673_;
                                                                let _e14291 = (_e14253[0] - _e14246[0]);
                                                                let _e14292 = (_e14253[1] - _e14246[1]);
                                                                let _e14293 = (_e14253[2] - _e14246[2]);
                                                                if (_e14291 < 0f) {
                                                                    phi_13691_ = -(_e14291);
                                                                } else {
                                                                    phi_13691_ = _e14291;
                                                                }
                                                                let _e14297 = phi_13691_;
                                                                if (_e14292 < 0f) {
                                                                    phi_13697_ = -(_e14292);
                                                                } else {
                                                                    phi_13697_ = _e14292;
                                                                }
                                                                let _e14301 = phi_13697_;
                                                                if (_e14293 < 0f) {
                                                                    phi_13704_ = -(_e14293);
                                                                } else {
                                                                    phi_13704_ = _e14293;
                                                                }
                                                                let _e14306 = phi_13704_;
                                                                let _e14313 = local_15.member[_e14238.member_1];
                                                                let _e14316 = local_15.member_1[_e14238.member_1];
                                                                if (_e14313 < 0f) {
                                                                    phi_13730_ = -(_e14313);
                                                                } else {
                                                                    phi_13730_ = _e14313;
                                                                }
                                                                let _e14321 = phi_13730_;
                                                                if (_e14316 < 0f) {
                                                                    phi_13736_ = -(_e14316);
                                                                } else {
                                                                    phi_13736_ = _e14316;
                                                                }
                                                                let _e14325 = phi_13736_;
                                                                let _e14329 = ((_e13544 * 1.01f) + ((_e14321 + _e14325) * (0.000000059604645f * 12f)));
                                                                let _e14336 = local_15.member_1[_e14238.member_1];
                                                                let _e14339 = local_15.member[_e14238.member_1];
                                                                let _e14340 = (_e14336 - _e14339);
                                                                let _e14343 = ((_e14329 + _e14329) + (_e14216 * ((((_e14297 + _e14301) + _e14306) + (_e13544 * 6f)) * 1.01f)));
                                                                let _e14346 = ((((_e14313 + ((_e14316 - _e14313) * _e11398)) - _e14329) - (_e14216 * ((_e14287 + (_e13544 * 3f)) * 1.01f))) - _e14076);
                                                                let _e14347 = (_e14346 > 0.000000000000000000000000000000000000011754944f);
                                                                let _e14348 = (_e14340 > _e14343);
                                                                if _e14348 {
                                                                    phi_13772_ = true;
                                                                } else {
                                                                    phi_13772_ = _e14347;
                                                                }
                                                                let _e14350 = phi_13772_;
                                                                if (_e14340 < -(_e14343)) {
                                                                    phi_13779_ = true;
                                                                } else {
                                                                    phi_13779_ = _e14347;
                                                                }
                                                                let _e14355 = phi_13779_;
                                                                if _e14348 {
                                                                    phi_13800_ = _e14220;
                                                                } else {
                                                                    if _e14347 {
                                                                        let _e14357 = (_e14343 - _e14340);
                                                                        if (_e14357 > 0.000000000000000000000000000000000000011754944f) {
                                                                            phi_13792_ = _e14357;
                                                                        } else {
                                                                            phi_13792_ = 0.000000000000000000000000000000000000011754944f;
                                                                        }
                                                                        let _e14360 = phi_13792_;
                                                                        let _e14361 = (_e14346 / _e14360);
                                                                        if (_e14220 < _e14361) {
                                                                            phi_13798_ = _e14220;
                                                                        } else {
                                                                            phi_13798_ = _e14361;
                                                                        }
                                                                        let _e14364 = phi_13798_;
                                                                        phi_13799_ = _e14364;
                                                                    } else {
                                                                        phi_13799_ = _e14220;
                                                                    }
                                                                    let _e14366 = phi_13799_;
                                                                    phi_13800_ = _e14366;
                                                                }
                                                                let _e14368 = phi_13800_;
                                                                phi_13566_ = _e14368;
                                                                phi_13568_ = (_e14222 && _e14355);
                                                                phi_13570_ = (_e14224 && _e14350);
                                                            } else {
                                                                phi_13566_ = f32();
                                                                phi_13568_ = bool();
                                                                phi_13570_ = bool();
                                                            }
                                                            let _e14370 = phi_13566_;
                                                            let _e14372 = phi_13568_;
                                                            let _e14374 = phi_13570_;
                                                            continue;
                                                            continuing {
                                                                phi_13562_ = _e14236;
                                                                phi_13565_ = _e14370;
                                                                phi_13567_ = _e14372;
                                                                phi_13569_ = _e14374;
                                                                break if !(_e14242);
                                                            }
                                                        }
                                                        let _e14377 = local_116;
                                                        if (_e14377 < 2f) {
                                                            let _e17315 = local_158;
                                                            phi_13805_ = _e17315;
                                                        } else {
                                                            phi_13805_ = 2f;
                                                        }
                                                        let _e14380 = phi_13805_;
                                                        let _e14381 = (_e14380 * 0.999f);
                                                        let _e14383 = local_117;
                                                        if _e14383 {
                                                            let _e14385 = local_118;
                                                            if _e14385 {
                                                                phi_13814_ = type_46();
                                                            } else {
                                                                phi_13814_ = type_46(1u, _e11398, 2f);
                                                            }
                                                            let _e14388 = phi_13814_;
                                                            phi_13815_ = _e14388;
                                                            let _e17322 = local_159;
                                                            phi_13816_ = _e17322;
                                                        } else {
                                                            phi_13815_ = type_46();
                                                            phi_13816_ = true;
                                                        }
                                                        let _e14390 = phi_13815_;
                                                        let _e14392 = phi_13816_;
                                                        if _e14392 {
                                                            let _e14394 = local_119;
                                                            if _e14394 {
                                                                if (_e14381 > (0.000000059604645f * 4096f)) {
                                                                    let _e14398 = (_e11398 + _e14381);
                                                                    if (_e14398 < _e5606) {
                                                                        phi_13833_ = _e14398;
                                                                    } else {
                                                                        phi_13833_ = _e5606;
                                                                    }
                                                                    let _e14401 = phi_13833_;
                                                                    phi_13834_ = _e14401;
                                                                } else {
                                                                    phi_13834_ = _e11398;
                                                                }
                                                                let _e14403 = phi_13834_;
                                                                phi_13837_ = type_9(0u, 4u);
                                                                phi_13840_ = _e14403;
                                                                phi_13842_ = _e11398;
                                                                loop {
                                                                    let _e14405 = phi_13837_;
                                                                    let _e14407 = phi_13840_;
                                                                    let _e14409 = phi_13842_;
                                                                    local_120 = _e14407;
                                                                    local_121 = _e14409;
                                                                    local_122 = _e14409;
                                                                    if (_e14405.member < _e14405.member_1) {
                                                                        phi_13838_ = type_9((_e14405.member + 1u), _e14405.member_1);
                                                                        phi_13865_ = type_9(1u, _e14405.member);
                                                                    } else {
                                                                        phi_13838_ = _e14405;
                                                                        phi_13865_ = type_9(0u, type_9().member_1);
                                                                    }
                                                                    let _e14421 = phi_13838_;
                                                                    let _e14423 = phi_13865_;
                                                                    let _e14427 = (bitcast<i32>(_e14423.member) != 0i);
                                                                    if _e14427 {
                                                                        let _e14430 = local_15.member[_e14423.member_1];
                                                                        let _e14433 = local_15.member_1[_e14423.member_1];
                                                                        let _e14436 = local_15.member[_e14423.member_1];
                                                                        let _e14442 = local_15.member_2[_e14423.member_1];
                                                                        let _e14443 = ((_e14430 + ((_e14433 - _e14436) * _e11398)) - _e14442);
                                                                        let _e14446 = local_15.member_1[_e14423.member_1];
                                                                        let _e14449 = local_15.member[_e14423.member_1];
                                                                        let _e14450 = (_e14446 - _e14449);
                                                                        if (_e14450 > 0f) {
                                                                            let _e14464 = (_e11398 - (_e14443 / _e14450));
                                                                            if (_e14409 > _e14464) {
                                                                                phi_13933_ = _e14409;
                                                                            } else {
                                                                                phi_13933_ = _e14464;
                                                                            }
                                                                            let _e14467 = phi_13933_;
                                                                            phi_13951_ = _e14407;
                                                                            phi_13952_ = _e14467;
                                                                        } else {
                                                                            if (_e14443 > 0f) {
                                                                                if (_e14450 < 0f) {
                                                                                    let _e14455 = (_e11398 - (_e14443 / _e14450));
                                                                                    if (_e14407 < _e14455) {
                                                                                        phi_13948_ = _e14407;
                                                                                    } else {
                                                                                        phi_13948_ = _e14455;
                                                                                    }
                                                                                    let _e14458 = phi_13948_;
                                                                                    phi_13949_ = _e14458;
                                                                                } else {
                                                                                    phi_13949_ = _e14407;
                                                                                }
                                                                                let _e14460 = phi_13949_;
                                                                                phi_13950_ = _e14460;
                                                                            } else {
                                                                                phi_13950_ = _e14407;
                                                                            }
                                                                            let _e14462 = phi_13950_;
                                                                            phi_13951_ = _e14462;
                                                                            phi_13952_ = _e14409;
                                                                        }
                                                                        let _e14469 = phi_13951_;
                                                                        let _e14471 = phi_13952_;
                                                                        phi_13841_ = _e14469;
                                                                        phi_13843_ = _e14471;
                                                                    } else {
                                                                        phi_13841_ = f32();
                                                                        phi_13843_ = f32();
                                                                    }
                                                                    let _e14473 = phi_13841_;
                                                                    let _e14475 = phi_13843_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_13837_ = _e14421;
                                                                        phi_13840_ = _e14473;
                                                                        phi_13842_ = _e14475;
                                                                        break if !(_e14427);
                                                                    }
                                                                }
                                                                let _e14478 = local_120;
                                                                let _e14480 = local_121;
                                                                let _e14484 = local_122;
                                                                let _e14485 = (_e14484 + ((_e14478 - _e14480) * 0.5f));
                                                                if (_e14485 > _e11398) {
                                                                    if (_e14485 <= _e14403) {
                                                                        let _e14490 = local_15.member[0u];
                                                                        let _e14493 = local_15.member_1[0u];
                                                                        let _e14496 = local_15.member[0u];
                                                                        let _e14502 = local_15.member_2[0u];
                                                                        if (((_e14490 + ((_e14493 - _e14496) * _e14485)) - _e14502) > 0f) {
                                                                            let _e14507 = local_15.member[1u];
                                                                            let _e14510 = local_15.member_1[1u];
                                                                            let _e14513 = local_15.member[1u];
                                                                            let _e14519 = local_15.member_2[1u];
                                                                            if (((_e14507 + ((_e14510 - _e14513) * _e14485)) - _e14519) > 0f) {
                                                                                let _e14524 = local_15.member[2u];
                                                                                let _e14527 = local_15.member_1[2u];
                                                                                let _e14530 = local_15.member[2u];
                                                                                let _e14536 = local_15.member_2[2u];
                                                                                if (((_e14524 + ((_e14527 - _e14530) * _e14485)) - _e14536) > 0f) {
                                                                                    let _e14541 = local_15.member[3u];
                                                                                    let _e14544 = local_15.member_1[3u];
                                                                                    let _e14547 = local_15.member[3u];
                                                                                    let _e14553 = local_15.member_2[3u];
                                                                                    phi_14113_ = (((_e14541 + ((_e14544 - _e14547) * _e14485)) - _e14553) > 0f);
                                                                                    phi_14114_ = false;
                                                                                } else {
                                                                                    phi_14113_ = bool();
                                                                                    phi_14114_ = true;
                                                                                }
                                                                                let _e14557 = phi_14113_;
                                                                                let _e14559 = phi_14114_;
                                                                                phi_14115_ = _e14557;
                                                                                phi_14116_ = _e14559;
                                                                            } else {
                                                                                phi_14115_ = bool();
                                                                                phi_14116_ = true;
                                                                            }
                                                                            let _e14561 = phi_14115_;
                                                                            let _e14563 = phi_14116_;
                                                                            phi_14117_ = _e14561;
                                                                            phi_14118_ = _e14563;
                                                                        } else {
                                                                            phi_14117_ = bool();
                                                                            phi_14118_ = true;
                                                                        }
                                                                        let _e14565 = phi_14117_;
                                                                        let _e14567 = phi_14118_;
                                                                        if _e14567 {
                                                                            phi_14122_ = false;
                                                                        } else {
                                                                            phi_14122_ = _e14565;
                                                                        }
                                                                        let _e14569 = phi_14122_;
                                                                        if _e14569 {
                                                                            phi_14126_ = false;
                                                                        } else {
                                                                            phi_14126_ = true;
                                                                        }
                                                                        let _e14571 = phi_14126_;
                                                                        phi_14127_ = _e14571;
                                                                    } else {
                                                                        phi_14127_ = true;
                                                                    }
                                                                    let _e14573 = phi_14127_;
                                                                    phi_14128_ = _e14573;
                                                                } else {
                                                                    phi_14128_ = true;
                                                                }
                                                                let _e14575 = phi_14128_;
                                                                if _e14575 {
                                                                    phi_14132_ = 2f;
                                                                } else {
                                                                    phi_14132_ = _e14485;
                                                                }
                                                                let _e14577 = phi_14132_;
                                                                phi_14135_ = type_46(2u, _e14403, _e14577);
                                                                phi_14136_ = type_46();
                                                                phi_14137_ = false;
                                                            } else {
                                                                phi_14135_ = type_46();
                                                                phi_14136_ = type_46(0u, _e11398, 2f);
                                                                phi_14137_ = true;
                                                            }
                                                            let _e14580 = phi_14135_;
                                                            let _e14582 = phi_14136_;
                                                            let _e14584 = phi_14137_;
                                                            phi_14138_ = _e14580;
                                                            phi_14139_ = _e14582;
                                                            phi_14140_ = _e14584;
                                                        } else {
                                                            phi_14138_ = type_46();
                                                            phi_14139_ = _e14390;
                                                            phi_14140_ = true;
                                                        }
                                                        let _e14586 = phi_14138_;
                                                        let _e14588 = phi_14139_;
                                                        let _e14590 = phi_14140_;
                                                        phi_14145_ = _e14588;
                                                        phi_14146_ = _e14586;
                                                        phi_14147_ = _e14590;
                                                    } else {
                                                        phi_14145_ = type_46(0u, _e11398, 2f);
                                                        phi_14146_ = type_46();
                                                        phi_14147_ = true;
                                                    }
                                                    let _e14592 = phi_14145_;
                                                    let _e14594 = phi_14146_;
                                                    let _e14596 = phi_14147_;
                                                    phi_14151_ = _e14592;
                                                    phi_14152_ = _e14594;
                                                    phi_14153_ = false;
                                                    phi_14154_ = _e14596;
                                                } else {
                                                    phi_14151_ = type_46();
                                                    phi_14152_ = type_46();
                                                    phi_14153_ = true;
                                                    phi_14154_ = false;
                                                }
                                                let _e14598 = phi_14151_;
                                                let _e14600 = phi_14152_;
                                                let _e14602 = phi_14153_;
                                                let _e14604 = phi_14154_;
                                                phi_14155_ = _e14598;
                                                phi_14156_ = _e14600;
                                                phi_14157_ = _e14602;
                                                phi_14158_ = _e14604;
                                            } else {
                                                phi_14155_ = type_46();
                                                phi_14156_ = type_46();
                                                phi_14157_ = true;
                                                phi_14158_ = false;
                                            }
                                            let _e14606 = phi_14155_;
                                            let _e14608 = phi_14156_;
                                            let _e14610 = phi_14157_;
                                            let _e14612 = phi_14158_;
                                            if _e14610 {
                                                phi_14163_ = type_46(0u, _e11398, 2f);
                                                phi_14164_ = true;
                                            } else {
                                                phi_14163_ = _e14606;
                                                phi_14164_ = _e14612;
                                            }
                                            let _e14615 = phi_14163_;
                                            let _e14617 = phi_14164_;
                                            if _e14617 {
                                                phi_14168_ = _e14615;
                                            } else {
                                                phi_14168_ = _e14608;
                                            }
                                            let _e14619 = phi_14168_;
                                            if _e5612 {
                                                if (_e14619.member == 2u) {
                                                    let _e14623 = (_e14619.member_2 <= _e5606);
                                                    if _e14623 {
                                                        phi_14184_ = _e14619.member_2;
                                                        phi_14185_ = _e14619.member_2;
                                                        phi_14186_ = false;
                                                    } else {
                                                        phi_14184_ = f32();
                                                        phi_14185_ = f32();
                                                        phi_14186_ = true;
                                                    }
                                                    let _e14627 = phi_14184_;
                                                    let _e14629 = phi_14185_;
                                                    let _e14631 = phi_14186_;
                                                    phi_14187_ = _e14627;
                                                    phi_14188_ = _e14629;
                                                    phi_14189_ = _e14623;
                                                    phi_14190_ = _e14631;
                                                    phi_14191_ = false;
                                                } else {
                                                    phi_14187_ = f32();
                                                    phi_14188_ = f32();
                                                    phi_14189_ = false;
                                                    phi_14190_ = false;
                                                    phi_14191_ = true;
                                                }
                                                let _e14633 = phi_14187_;
                                                let _e14635 = phi_14188_;
                                                let _e14637 = phi_14189_;
                                                let _e14639 = phi_14190_;
                                                let _e14641 = phi_14191_;
                                                phi_14192_ = _e14633;
                                                phi_14193_ = _e14635;
                                                phi_14194_ = _e14637;
                                                phi_14195_ = _e14639;
                                                phi_14196_ = _e14641;
                                            } else {
                                                phi_14192_ = f32();
                                                phi_14193_ = f32();
                                                phi_14194_ = false;
                                                phi_14195_ = false;
                                                phi_14196_ = true;
                                            }
                                            let _e14643 = phi_14192_;
                                            let _e14645 = phi_14193_;
                                            let _e14647 = phi_14194_;
                                            let _e14649 = phi_14195_;
                                            let _e14651 = phi_14196_;
                                            phi_14197_ = _e14643;
                                            phi_14198_ = _e14619.member;
                                            phi_14199_ = _e14645;
                                            phi_14200_ = _e14619;
                                            phi_14201_ = _e14619.member;
                                            phi_14202_ = _e14619.member;
                                            phi_14203_ = _e14647;
                                            phi_14204_ = _e14649;
                                            phi_14205_ = _e14651;
                                        }
                                        let _e14653 = phi_14197_;
                                        let _e14655 = phi_14198_;
                                        let _e14657 = phi_14199_;
                                        let _e14659 = phi_14200_;
                                        let _e14661 = phi_14201_;
                                        let _e14663 = phi_14202_;
                                        let _e14665 = phi_14203_;
                                        let _e14667 = phi_14204_;
                                        let _e14669 = phi_14205_;
                                        phi_14206_ = _e14653;
                                        phi_14207_ = _e14655;
                                        phi_14208_ = _e14657;
                                        phi_14209_ = _e14659;
                                        phi_14210_ = _e14661;
                                        phi_14211_ = _e14663;
                                        phi_14212_ = _e14665;
                                        phi_14213_ = _e13206;
                                        phi_14214_ = _e14667;
                                        phi_14215_ = _e14669;
                                        phi_14216_ = false;
                                    } else {
                                        phi_14206_ = f32();
                                        phi_14207_ = u32();
                                        phi_14208_ = f32();
                                        phi_14209_ = type_46();
                                        phi_14210_ = u32();
                                        phi_14211_ = u32();
                                        phi_14212_ = false;
                                        phi_14213_ = false;
                                        phi_14214_ = false;
                                        phi_14215_ = false;
                                        phi_14216_ = true;
                                    }
                                    let _e14671 = phi_14206_;
                                    let _e14673 = phi_14207_;
                                    let _e14675 = phi_14208_;
                                    let _e14677 = phi_14209_;
                                    let _e14679 = phi_14210_;
                                    let _e14681 = phi_14211_;
                                    let _e14683 = phi_14212_;
                                    let _e14685 = phi_14213_;
                                    let _e14687 = phi_14214_;
                                    let _e14689 = phi_14215_;
                                    let _e14691 = phi_14216_;
                                    phi_14217_ = _e13203;
                                    phi_9292_ = _e14671;
                                    phi_9294_ = _e14673;
                                    phi_9296_ = _e14675;
                                    phi_14218_ = _e14677;
                                    phi_14219_ = _e14679;
                                    phi_14220_ = _e13203;
                                    phi_14221_ = _e14681;
                                    phi_14222_ = _e14683;
                                    phi_14223_ = _e14685;
                                    phi_14224_ = _e14687;
                                    phi_14225_ = _e14689;
                                    phi_14226_ = false;
                                    phi_14227_ = _e14691;
                                } else {
                                    phi_14217_ = f32();
                                    phi_9292_ = f32();
                                    phi_9294_ = u32();
                                    phi_9296_ = f32();
                                    phi_14218_ = type_46();
                                    phi_14219_ = u32();
                                    phi_14220_ = f32();
                                    phi_14221_ = u32();
                                    phi_14222_ = false;
                                    phi_14223_ = false;
                                    phi_14224_ = false;
                                    phi_14225_ = false;
                                    phi_14226_ = true;
                                    phi_14227_ = false;
                                }
                                let _e14693 = phi_14217_;
                                let _e14695 = phi_9292_;
                                let _e14697 = phi_9294_;
                                let _e14699 = phi_9296_;
                                let _e14701 = phi_14218_;
                                let _e14703 = phi_14219_;
                                let _e14705 = phi_14220_;
                                let _e14707 = phi_14221_;
                                let _e14709 = phi_14222_;
                                let _e14711 = phi_14223_;
                                let _e14713 = phi_14224_;
                                let _e14715 = phi_14225_;
                                let _e14717 = phi_14226_;
                                let _e14719 = phi_14227_;
                                local_123 = _e14711;
                                local_160 = _e14713;
                                local_161 = _e14715;
                                local_162 = _e14717;
                                local_163 = _e14719;
                                local_124 = _e14701;
                                local_125 = _e14701;
                                local_164 = _e14703;
                                local_126 = _e14701;
                                local_165 = _e14711;
                                local_166 = _e14707;
                                local_168 = _e14705;
                                local_169 = _e14693;
                                continue;
                                continuing {
                                    phi_9288_ = _e11421;
                                    phi_9291_ = _e14695;
                                    phi_9293_ = _e14697;
                                    phi_9295_ = _e14699;
                                    break if !(_e14709);
                                }
                            }
                            let _e14722 = local_123;
                            if _e14722 {
                                phi_14231_ = false;
                                phi_14232_ = false;
                                phi_14233_ = false;
                                phi_14234_ = false;
                            } else {
                                let _e17423 = local_160;
                                phi_14231_ = _e17423;
                                let _e17426 = local_161;
                                phi_14232_ = _e17426;
                                let _e17429 = local_162;
                                phi_14233_ = _e17429;
                                let _e17432 = local_163;
                                phi_14234_ = _e17432;
                            }
                            let _e14724 = phi_14231_;
                            let _e14726 = phi_14232_;
                            let _e14728 = phi_14233_;
                            let _e14730 = phi_14234_;
                            if _e14724 {
                                let _e14732 = local_124;
                                if (_e14732.member_1 >= _e5606) {
                                    phi_14256_ = type_45(type_44(0u, f32()), 0u);
                                } else {
                                    let _e14736 = local_125;
                                    if (_e14736.member_1 > _e5604) {
                                        phi_14251_ = 0u;
                                    } else {
                                        let _e17437 = local_164;
                                        phi_14251_ = _e17437;
                                    }
                                    let _e14740 = phi_14251_;
                                    let _e14742 = local_126;
                                    phi_14256_ = type_45(type_44(2u, _e14742.member_1), _e14740);
                                }
                                let _e14749 = phi_14256_;
                                phi_14257_ = _e14749;
                                phi_14258_ = false;
                                phi_14259_ = false;
                                phi_14260_ = false;
                                phi_14261_ = false;
                            } else {
                                phi_14257_ = type_45();
                                phi_14258_ = _e14726;
                                let _e17444 = local_165;
                                phi_14259_ = _e17444;
                                phi_14260_ = _e14728;
                                phi_14261_ = _e14730;
                            }
                            let _e14751 = phi_14257_;
                            let _e14753 = phi_14258_;
                            let _e14755 = phi_14259_;
                            let _e14757 = phi_14260_;
                            let _e14759 = phi_14261_;
                            if _e14753 {
                                let _e17449 = local_166;
                                phi_14265_ = _e17449;
                                let _e17454 = local_168;
                                phi_14266_ = _e17454;
                                phi_14267_ = true;
                                phi_14268_ = false;
                                phi_14269_ = false;
                                phi_14270_ = false;
                            } else {
                                let _e17451 = local_167;
                                phi_14265_ = _e17451;
                                let _e17456 = local_169;
                                phi_14266_ = _e17456;
                                phi_14267_ = _e14755;
                                phi_14268_ = _e14757;
                                phi_14269_ = _e14759;
                                phi_14270_ = _e14724;
                            }
                            let _e14761 = phi_14265_;
                            let _e14763 = phi_14266_;
                            let _e14765 = phi_14267_;
                            let _e14767 = phi_14268_;
                            let _e14769 = phi_14269_;
                            let _e14771 = phi_14270_;
                            if _e14765 {
                                phi_14274_ = _e14763;
                                phi_14275_ = _e14761;
                                phi_14276_ = true;
                                phi_14277_ = false;
                                phi_14278_ = false;
                            } else {
                                let _e17463 = local_170;
                                phi_14274_ = _e17463;
                                let _e17466 = local_171;
                                phi_14275_ = _e17466;
                                phi_14276_ = _e14767;
                                phi_14277_ = _e14769;
                                phi_14278_ = _e14771;
                            }
                            let _e14773 = phi_14274_;
                            let _e14775 = phi_14275_;
                            let _e14777 = phi_14276_;
                            let _e14779 = phi_14277_;
                            let _e14781 = phi_14278_;
                            if _e14777 {
                                local_13[0u] = 0.01f;
                                local_13[1u] = 0f;
                                local_13[2u] = 0.8f;
                                if (_e5602 >= (0.000000059604645f * 8f)) {
                                    phi_14290_ = _e5602;
                                } else {
                                    phi_14290_ = 0f;
                                }
                                let _e14788 = phi_14290_;
                                phi_14293_ = type_9(0u, 3u);
                                loop {
                                    let _e14790 = phi_14293_;
                                    if (_e14790.member < _e14790.member_1) {
                                        phi_14294_ = type_9((_e14790.member + 1u), _e14790.member_1);
                                        phi_14317_ = type_9(1u, _e14790.member);
                                    } else {
                                        phi_14294_ = _e14790;
                                        phi_14317_ = type_9(0u, type_9().member_1);
                                    }
                                    let _e14802 = phi_14294_;
                                    let _e14804 = phi_14317_;
                                    if (bitcast<i32>(_e14804.member) != 0i) {
                                        let _e14810 = local_13[_e14804.member_1];
                                        let _e14812 = (_e14773 + (_e14788 * _e14810));
                                        if (_e14812 < _e5606) {
                                            phi_14338_ = _e14812;
                                        } else {
                                            phi_14338_ = _e5606;
                                        }
                                        let _e14815 = phi_14338_;
                                        let _e14818 = local_18.member[0u];
                                        let _e14824 = local_18.member[1u];
                                        let _e14840 = local_18.member_1[0u];
                                        let _e14846 = local_18.member_1[1u];
                                        let _e14862 = local_18.member_2[0u];
                                        let _e14868 = local_18.member_2[1u];
                                        let _e14882 = function_3(array<f32, 3>((_e14818[0] + ((_e14824[0] - _e14818[0]) * _e14815)), (_e14818[1] + ((_e14824[1] - _e14818[1]) * _e14815)), (_e14818[2] + ((_e14824[2] - _e14818[2]) * _e14815))), array<f32, 3>((_e14840[0] + ((_e14846[0] - _e14840[0]) * _e14815)), (_e14840[1] + ((_e14846[1] - _e14840[1]) * _e14815)), (_e14840[2] + ((_e14846[2] - _e14840[2]) * _e14815))), array<f32, 3>((_e14862[0] + ((_e14868[0] - _e14862[0]) * _e14815)), (_e14862[1] + ((_e14868[1] - _e14862[1]) * _e14815)), (_e14862[2] + ((_e14868[2] - _e14862[2]) * _e14815))), _e316.member);
                                        let _e14893 = (((_e14882[0] * _e14882[0]) + (_e14882[1] * _e14882[1])) + (_e14882[2] * _e14882[2]));
                                        if (_e14893 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e14893 > 0f) {
                                                phi_14461_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_14461_ = 0f;
                                            }
                                            let _e14946 = phi_14461_;
                                            phi_14525_ = _e14946;
                                        } else {
                                            phi_14468_ = type_14(0i, 5i);
                                            phi_14471_ = bitcast<f32>(((bitcast<u32>(_e14893) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e14901 = phi_14468_;
                                                let _e14903 = phi_14471_;
                                                local_127 = _e14903;
                                                if (_e14901.member < _e14901.member_1) {
                                                    let _e14910 = (_e14901.member + 1i);
                                                    if ((false == (_e14910 > _e14901.member)) != false) {
                                                        phi_14492_ = true;
                                                    } else {
                                                        phi_14492_ = false;
                                                    }
                                                    let _e14915 = phi_14492_;
                                                    if _e14915 {
                                                        phi_14498_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_14498_ = type_15(1u, _e14910);
                                                    }
                                                    let _e14920 = phi_14498_;
                                                    phi_14469_ = type_14(_e14920.member_1, _e14901.member_1);
                                                    phi_14512_ = type_15(1u, _e14901.member);
                                                } else {
                                                    phi_14469_ = _e14901;
                                                    phi_14512_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e14926 = phi_14469_;
                                                let _e14928 = phi_14512_;
                                                let _e14931 = (bitcast<i32>(_e14928.member) != 0i);
                                                if _e14931 {
                                                    phi_14472_ = (0.5f * (_e14903 + (_e14893 / _e14903)));
                                                } else {
                                                    phi_14472_ = f32();
                                                }
                                                let _e14936 = phi_14472_;
                                                continue;
                                                continuing {
                                                    phi_14468_ = _e14926;
                                                    phi_14471_ = _e14936;
                                                    break if !(_e14931);
                                                }
                                            }
                                            let _e14941 = local_127;
                                            phi_14525_ = (_e14941 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e14948 = phi_14525_;
                                        let _e14954 = local_18.member[0u];
                                        if (_e14954[0] < 0f) {
                                            phi_14541_ = -(_e14954[0]);
                                        } else {
                                            phi_14541_ = _e14954[0];
                                        }
                                        let _e14961 = phi_14541_;
                                        if (_e14954[1] < 0f) {
                                            phi_14548_ = -(_e14954[1]);
                                        } else {
                                            phi_14548_ = _e14954[1];
                                        }
                                        let _e14965 = phi_14548_;
                                        if (_e14961 > _e14965) {
                                            phi_14553_ = _e14961;
                                        } else {
                                            phi_14553_ = _e14965;
                                        }
                                        let _e14968 = phi_14553_;
                                        if (_e14954[2] < 0f) {
                                            phi_14560_ = -(_e14954[2]);
                                        } else {
                                            phi_14560_ = _e14954[2];
                                        }
                                        let _e14972 = phi_14560_;
                                        if (_e14968 > _e14972) {
                                            phi_14565_ = _e14968;
                                        } else {
                                            phi_14565_ = _e14972;
                                        }
                                        let _e14975 = phi_14565_;
                                        let _e14978 = local_18.member[1u];
                                        if (_e14978[0] < 0f) {
                                            phi_14578_ = -(_e14978[0]);
                                        } else {
                                            phi_14578_ = _e14978[0];
                                        }
                                        let _e14985 = phi_14578_;
                                        if (_e14978[1] < 0f) {
                                            phi_14585_ = -(_e14978[1]);
                                        } else {
                                            phi_14585_ = _e14978[1];
                                        }
                                        let _e14989 = phi_14585_;
                                        if (_e14985 > _e14989) {
                                            phi_14590_ = _e14985;
                                        } else {
                                            phi_14590_ = _e14989;
                                        }
                                        let _e14992 = phi_14590_;
                                        if (_e14978[2] < 0f) {
                                            phi_14597_ = -(_e14978[2]);
                                        } else {
                                            phi_14597_ = _e14978[2];
                                        }
                                        let _e14996 = phi_14597_;
                                        if (_e14992 > _e14996) {
                                            phi_14602_ = _e14992;
                                        } else {
                                            phi_14602_ = _e14996;
                                        }
                                        let _e14999 = phi_14602_;
                                        if (_e14975 > _e14999) {
                                            phi_14607_ = _e14975;
                                        } else {
                                            phi_14607_ = _e14999;
                                        }
                                        let _e15002 = phi_14607_;
                                        let _e15004 = local_18.member_3;
                                        let _e15008 = local_18.member_1[0u];
                                        if (_e15008[0] < 0f) {
                                            phi_14624_ = -(_e15008[0]);
                                        } else {
                                            phi_14624_ = _e15008[0];
                                        }
                                        let _e15015 = phi_14624_;
                                        if (_e15008[1] < 0f) {
                                            phi_14631_ = -(_e15008[1]);
                                        } else {
                                            phi_14631_ = _e15008[1];
                                        }
                                        let _e15019 = phi_14631_;
                                        if (_e15015 > _e15019) {
                                            phi_14636_ = _e15015;
                                        } else {
                                            phi_14636_ = _e15019;
                                        }
                                        let _e15022 = phi_14636_;
                                        if (_e15008[2] < 0f) {
                                            phi_14643_ = -(_e15008[2]);
                                        } else {
                                            phi_14643_ = _e15008[2];
                                        }
                                        let _e15026 = phi_14643_;
                                        if (_e15022 > _e15026) {
                                            phi_14648_ = _e15022;
                                        } else {
                                            phi_14648_ = _e15026;
                                        }
                                        let _e15029 = phi_14648_;
                                        let _e15032 = local_18.member_1[1u];
                                        if (_e15032[0] < 0f) {
                                            phi_14662_ = -(_e15032[0]);
                                        } else {
                                            phi_14662_ = _e15032[0];
                                        }
                                        let _e15039 = phi_14662_;
                                        if (_e15032[1] < 0f) {
                                            phi_14669_ = -(_e15032[1]);
                                        } else {
                                            phi_14669_ = _e15032[1];
                                        }
                                        let _e15043 = phi_14669_;
                                        if (_e15039 > _e15043) {
                                            phi_14674_ = _e15039;
                                        } else {
                                            phi_14674_ = _e15043;
                                        }
                                        let _e15046 = phi_14674_;
                                        if (_e15032[2] < 0f) {
                                            phi_14681_ = -(_e15032[2]);
                                        } else {
                                            phi_14681_ = _e15032[2];
                                        }
                                        let _e15050 = phi_14681_;
                                        if (_e15046 > _e15050) {
                                            phi_14686_ = _e15046;
                                        } else {
                                            phi_14686_ = _e15050;
                                        }
                                        let _e15053 = phi_14686_;
                                        if (_e15029 > _e15053) {
                                            phi_14691_ = _e15029;
                                        } else {
                                            phi_14691_ = _e15053;
                                        }
                                        let _e15056 = phi_14691_;
                                        let _e15058 = local_18.member_3;
                                        let _e15062 = local_18.member_2[0u];
                                        if (_e15062[0] < 0f) {
                                            phi_14708_ = -(_e15062[0]);
                                        } else {
                                            phi_14708_ = _e15062[0];
                                        }
                                        let _e15069 = phi_14708_;
                                        if (_e15062[1] < 0f) {
                                            phi_14715_ = -(_e15062[1]);
                                        } else {
                                            phi_14715_ = _e15062[1];
                                        }
                                        let _e15073 = phi_14715_;
                                        if (_e15069 > _e15073) {
                                            phi_14720_ = _e15069;
                                        } else {
                                            phi_14720_ = _e15073;
                                        }
                                        let _e15076 = phi_14720_;
                                        if (_e15062[2] < 0f) {
                                            phi_14727_ = -(_e15062[2]);
                                        } else {
                                            phi_14727_ = _e15062[2];
                                        }
                                        let _e15080 = phi_14727_;
                                        if (_e15076 > _e15080) {
                                            phi_14732_ = _e15076;
                                        } else {
                                            phi_14732_ = _e15080;
                                        }
                                        let _e15083 = phi_14732_;
                                        let _e15086 = local_18.member_2[1u];
                                        if (_e15086[0] < 0f) {
                                            phi_14746_ = -(_e15086[0]);
                                        } else {
                                            phi_14746_ = _e15086[0];
                                        }
                                        let _e15093 = phi_14746_;
                                        if (_e15086[1] < 0f) {
                                            phi_14753_ = -(_e15086[1]);
                                        } else {
                                            phi_14753_ = _e15086[1];
                                        }
                                        let _e15097 = phi_14753_;
                                        if (_e15093 > _e15097) {
                                            phi_14758_ = _e15093;
                                        } else {
                                            phi_14758_ = _e15097;
                                        }
                                        let _e15100 = phi_14758_;
                                        if (_e15086[2] < 0f) {
                                            phi_14765_ = -(_e15086[2]);
                                        } else {
                                            phi_14765_ = _e15086[2];
                                        }
                                        let _e15104 = phi_14765_;
                                        if (_e15100 > _e15104) {
                                            phi_14770_ = _e15100;
                                        } else {
                                            phi_14770_ = _e15104;
                                        }
                                        let _e15107 = phi_14770_;
                                        if (_e15083 > _e15107) {
                                            phi_14775_ = _e15083;
                                        } else {
                                            phi_14775_ = _e15107;
                                        }
                                        let _e15110 = phi_14775_;
                                        let _e15112 = local_18.member_3;
                                        let _e15119 = local_18.member_3;
                                        let _e15126 = (((_e14948 * (1f + (0.000000059604645f * 8f))) + (((((((_e15002 + _e15004) + (_e15056 + _e15058)) + (_e15110 + _e15112)) * (0.000000059604645f * 16f)) + (_e15119 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e5872.member_1);
                                        if _e15126 {
                                            phi_14795_ = false;
                                        } else {
                                            phi_14795_ = true;
                                        }
                                        let _e15128 = phi_14795_;
                                        phi_14796_ = _e15128;
                                        phi_14797_ = _e15126;
                                    } else {
                                        phi_14796_ = false;
                                        phi_14797_ = false;
                                    }
                                    let _e15130 = phi_14796_;
                                    let _e15132 = phi_14797_;
                                    local_128 = _e15132;
                                    continue;
                                    continuing {
                                        phi_14293_ = _e14802;
                                        break if !(_e15130);
                                    }
                                }
                                let _e15135 = local_128;
                                if _e15135 {
                                    if (_e14773 > _e5604) {
                                        phi_14805_ = 1u;
                                    } else {
                                        phi_14805_ = _e14775;
                                    }
                                    let _e15138 = phi_14805_;
                                    phi_14809_ = type_45(type_44(1u, _e14773), _e15138);
                                    phi_14810_ = false;
                                } else {
                                    phi_14809_ = type_45();
                                    phi_14810_ = true;
                                }
                                let _e15142 = phi_14809_;
                                let _e15144 = phi_14810_;
                                if _e15144 {
                                    if (_e14773 > _e5604) {
                                        phi_14818_ = 0u;
                                    } else {
                                        phi_14818_ = _e14775;
                                    }
                                    let _e15147 = phi_14818_;
                                    phi_14822_ = type_45(type_44(2u, _e14773), _e15147);
                                } else {
                                    phi_14822_ = _e15142;
                                }
                                let _e15151 = phi_14822_;
                                phi_14823_ = _e15151;
                                phi_14824_ = false;
                                phi_14825_ = false;
                            } else {
                                phi_14823_ = type_45();
                                phi_14824_ = _e14779;
                                phi_14825_ = _e14781;
                            }
                            let _e15153 = phi_14823_;
                            let _e15155 = phi_14824_;
                            let _e15157 = phi_14825_;
                            if _e15155 {
                                phi_14832_ = type_45(type_44(0u, f32()), 0u);
                                phi_14833_ = true;
                            } else {
                                phi_14832_ = _e14751;
                                phi_14833_ = _e15157;
                            }
                            let _e15161 = phi_14832_;
                            let _e15163 = phi_14833_;
                            phi_14837_ = _e15161;
                            phi_14838_ = _e15153;
                            phi_14839_ = _e15163;
                        } else {
                            phi_14837_ = _e11388;
                            phi_14838_ = type_45();
                            phi_14839_ = true;
                        }
                        let _e15165 = phi_14837_;
                        let _e15167 = phi_14838_;
                        let _e15169 = phi_14839_;
                        if _e15169 {
                            phi_14843_ = _e15165;
                        } else {
                            phi_14843_ = _e15167;
                        }
                        let _e15171 = phi_14843_;
                        phi_22358_ = _e15171;
                    } else {
                        let _e5916 = local_18.member_1[0u];
                        let _e5922 = local_18.member_2[0u];
                        let _e5928 = ((_e5916[1] * _e5922[2]) - (_e5916[2] * _e5922[1]));
                        let _e5931 = ((_e5916[2] * _e5922[0]) - (_e5916[0] * _e5922[2]));
                        let _e5934 = ((_e5916[0] * _e5922[1]) - (_e5916[1] * _e5922[0]));
                        let _e5937 = local_18.member_1[1u];
                        let _e5943 = local_18.member_2[1u];
                        let _e5949 = ((_e5937[1] * _e5943[2]) - (_e5937[2] * _e5943[1]));
                        let _e5952 = ((_e5937[2] * _e5943[0]) - (_e5937[0] * _e5943[2]));
                        let _e5955 = ((_e5937[0] * _e5943[1]) - (_e5937[1] * _e5943[0]));
                        let _e5958 = local_18.member_1[0u];
                        let _e5964 = local_18.member_2[1u];
                        let _e5979 = local_18.member_1[1u];
                        let _e5985 = local_18.member_2[0u];
                        let _e5998 = (((_e5958[1] * _e5964[2]) - (_e5958[2] * _e5964[1])) + ((_e5979[1] * _e5985[2]) - (_e5979[2] * _e5985[1])));
                        let _e5999 = (((_e5958[2] * _e5964[0]) - (_e5958[0] * _e5964[2])) + ((_e5979[2] * _e5985[0]) - (_e5979[0] * _e5985[2])));
                        let _e6000 = (((_e5958[0] * _e5964[1]) - (_e5958[1] * _e5964[0])) + ((_e5979[0] * _e5985[1]) - (_e5979[1] * _e5985[0])));
                        let _e6003 = local_18.member[0u];
                        let _e6011 = (((_e6003[0] * _e5928) + (_e6003[1] * _e5931)) + (_e6003[2] * _e5934));
                        let _e6014 = local_18.member[1u];
                        let _e6025 = local_18.member[0u];
                        let _e6034 = ((((_e6014[0] * _e5928) + (_e6014[1] * _e5931)) + (_e6014[2] * _e5934)) + (((_e6025[0] * _e5998) + (_e6025[1] * _e5999)) + (_e6025[2] * _e6000)));
                        let _e6037 = local_18.member[0u];
                        let _e6048 = local_18.member[1u];
                        let _e6057 = ((((_e6037[0] * _e5949) + (_e6037[1] * _e5952)) + (_e6037[2] * _e5955)) + (((_e6048[0] * _e5998) + (_e6048[1] * _e5999)) + (_e6048[2] * _e6000)));
                        let _e6060 = local_18.member[1u];
                        let _e6068 = (((_e6060[0] * _e5949) + (_e6060[1] * _e5952)) + (_e6060[2] * _e5955));
                        let _e6071 = local_18.member[0u];
                        if (_e6071[0] < 0f) {
                            phi_15085_ = -(_e6071[0]);
                        } else {
                            phi_15085_ = _e6071[0];
                        }
                        let _e6078 = phi_15085_;
                        if (_e6071[1] < 0f) {
                            phi_15092_ = -(_e6071[1]);
                        } else {
                            phi_15092_ = _e6071[1];
                        }
                        let _e6082 = phi_15092_;
                        if (_e6078 > _e6082) {
                            phi_15097_ = _e6078;
                        } else {
                            phi_15097_ = _e6082;
                        }
                        let _e6085 = phi_15097_;
                        if (_e6071[2] < 0f) {
                            phi_15104_ = -(_e6071[2]);
                        } else {
                            phi_15104_ = _e6071[2];
                        }
                        let _e6089 = phi_15104_;
                        if (_e6085 > _e6089) {
                            phi_15109_ = _e6085;
                        } else {
                            phi_15109_ = _e6089;
                        }
                        let _e6092 = phi_15109_;
                        let _e6095 = local_18.member[1u];
                        if (_e6095[0] < 0f) {
                            phi_15122_ = -(_e6095[0]);
                        } else {
                            phi_15122_ = _e6095[0];
                        }
                        let _e6102 = phi_15122_;
                        if (_e6095[1] < 0f) {
                            phi_15129_ = -(_e6095[1]);
                        } else {
                            phi_15129_ = _e6095[1];
                        }
                        let _e6106 = phi_15129_;
                        if (_e6102 > _e6106) {
                            phi_15134_ = _e6102;
                        } else {
                            phi_15134_ = _e6106;
                        }
                        let _e6109 = phi_15134_;
                        if (_e6095[2] < 0f) {
                            phi_15141_ = -(_e6095[2]);
                        } else {
                            phi_15141_ = _e6095[2];
                        }
                        let _e6113 = phi_15141_;
                        if (_e6109 > _e6113) {
                            phi_15146_ = _e6109;
                        } else {
                            phi_15146_ = _e6113;
                        }
                        let _e6116 = phi_15146_;
                        if (_e6092 > _e6116) {
                            phi_15151_ = _e6092;
                        } else {
                            phi_15151_ = _e6116;
                        }
                        let _e6119 = phi_15151_;
                        let _e6121 = local_18.member_3;
                        let _e6122 = (_e6119 + _e6121);
                        let _e6125 = local_18.member_1[0u];
                        if (_e6125[0] < 0f) {
                            phi_15168_ = -(_e6125[0]);
                        } else {
                            phi_15168_ = _e6125[0];
                        }
                        let _e6132 = phi_15168_;
                        if (_e6125[1] < 0f) {
                            phi_15175_ = -(_e6125[1]);
                        } else {
                            phi_15175_ = _e6125[1];
                        }
                        let _e6136 = phi_15175_;
                        if (_e6132 > _e6136) {
                            phi_15180_ = _e6132;
                        } else {
                            phi_15180_ = _e6136;
                        }
                        let _e6139 = phi_15180_;
                        if (_e6125[2] < 0f) {
                            phi_15187_ = -(_e6125[2]);
                        } else {
                            phi_15187_ = _e6125[2];
                        }
                        let _e6143 = phi_15187_;
                        if (_e6139 > _e6143) {
                            phi_15192_ = _e6139;
                        } else {
                            phi_15192_ = _e6143;
                        }
                        let _e6146 = phi_15192_;
                        let _e6149 = local_18.member_1[1u];
                        if (_e6149[0] < 0f) {
                            phi_15206_ = -(_e6149[0]);
                        } else {
                            phi_15206_ = _e6149[0];
                        }
                        let _e6156 = phi_15206_;
                        if (_e6149[1] < 0f) {
                            phi_15213_ = -(_e6149[1]);
                        } else {
                            phi_15213_ = _e6149[1];
                        }
                        let _e6160 = phi_15213_;
                        if (_e6156 > _e6160) {
                            phi_15218_ = _e6156;
                        } else {
                            phi_15218_ = _e6160;
                        }
                        let _e6163 = phi_15218_;
                        if (_e6149[2] < 0f) {
                            phi_15225_ = -(_e6149[2]);
                        } else {
                            phi_15225_ = _e6149[2];
                        }
                        let _e6167 = phi_15225_;
                        if (_e6163 > _e6167) {
                            phi_15230_ = _e6163;
                        } else {
                            phi_15230_ = _e6167;
                        }
                        let _e6170 = phi_15230_;
                        if (_e6146 > _e6170) {
                            phi_15235_ = _e6146;
                        } else {
                            phi_15235_ = _e6170;
                        }
                        let _e6173 = phi_15235_;
                        let _e6175 = local_18.member_3;
                        let _e6176 = (_e6173 + _e6175);
                        let _e6179 = local_18.member_2[0u];
                        if (_e6179[0] < 0f) {
                            phi_15252_ = -(_e6179[0]);
                        } else {
                            phi_15252_ = _e6179[0];
                        }
                        let _e6186 = phi_15252_;
                        if (_e6179[1] < 0f) {
                            phi_15259_ = -(_e6179[1]);
                        } else {
                            phi_15259_ = _e6179[1];
                        }
                        let _e6190 = phi_15259_;
                        if (_e6186 > _e6190) {
                            phi_15264_ = _e6186;
                        } else {
                            phi_15264_ = _e6190;
                        }
                        let _e6193 = phi_15264_;
                        if (_e6179[2] < 0f) {
                            phi_15271_ = -(_e6179[2]);
                        } else {
                            phi_15271_ = _e6179[2];
                        }
                        let _e6197 = phi_15271_;
                        if (_e6193 > _e6197) {
                            phi_15276_ = _e6193;
                        } else {
                            phi_15276_ = _e6197;
                        }
                        let _e6200 = phi_15276_;
                        let _e6203 = local_18.member_2[1u];
                        if (_e6203[0] < 0f) {
                            phi_15290_ = -(_e6203[0]);
                        } else {
                            phi_15290_ = _e6203[0];
                        }
                        let _e6210 = phi_15290_;
                        if (_e6203[1] < 0f) {
                            phi_15297_ = -(_e6203[1]);
                        } else {
                            phi_15297_ = _e6203[1];
                        }
                        let _e6214 = phi_15297_;
                        if (_e6210 > _e6214) {
                            phi_15302_ = _e6210;
                        } else {
                            phi_15302_ = _e6214;
                        }
                        let _e6217 = phi_15302_;
                        if (_e6203[2] < 0f) {
                            phi_15309_ = -(_e6203[2]);
                        } else {
                            phi_15309_ = _e6203[2];
                        }
                        let _e6221 = phi_15309_;
                        if (_e6217 > _e6221) {
                            phi_15314_ = _e6217;
                        } else {
                            phi_15314_ = _e6221;
                        }
                        let _e6224 = phi_15314_;
                        if (_e6200 > _e6224) {
                            phi_15319_ = _e6200;
                        } else {
                            phi_15319_ = _e6224;
                        }
                        let _e6227 = phi_15319_;
                        let _e6229 = local_18.member_3;
                        let _e6230 = (_e6227 + _e6229);
                        let _e6232 = ((_e6176 * 8f) * _e6230);
                        let _e6239 = local_18.member_3;
                        if (_e5928 < 0f) {
                            phi_15350_ = -(_e5928);
                        } else {
                            phi_15350_ = _e5928;
                        }
                        let _e6256 = phi_15350_;
                        if (_e5931 < 0f) {
                            phi_15356_ = -(_e5931);
                        } else {
                            phi_15356_ = _e5931;
                        }
                        let _e6260 = phi_15356_;
                        if (_e5934 < 0f) {
                            phi_15363_ = -(_e5934);
                        } else {
                            phi_15363_ = _e5934;
                        }
                        let _e6265 = phi_15363_;
                        let _e6266 = ((_e6256 + _e6260) + _e6265);
                        if (_e5949 < 0f) {
                            phi_15370_ = -(_e5949);
                        } else {
                            phi_15370_ = _e5949;
                        }
                        let _e6270 = phi_15370_;
                        if (_e5952 < 0f) {
                            phi_15376_ = -(_e5952);
                        } else {
                            phi_15376_ = _e5952;
                        }
                        let _e6274 = phi_15376_;
                        if (_e5955 < 0f) {
                            phi_15383_ = -(_e5955);
                        } else {
                            phi_15383_ = _e5955;
                        }
                        let _e6279 = phi_15383_;
                        let _e6280 = ((_e6270 + _e6274) + _e6279);
                        if (_e6266 > _e6280) {
                            phi_15389_ = _e6266;
                        } else {
                            phi_15389_ = _e6280;
                        }
                        let _e6283 = phi_15389_;
                        if (_e5998 < 0f) {
                            phi_15395_ = -(_e5998);
                        } else {
                            phi_15395_ = _e5998;
                        }
                        let _e6287 = phi_15395_;
                        if (_e5999 < 0f) {
                            phi_15401_ = -(_e5999);
                        } else {
                            phi_15401_ = _e5999;
                        }
                        let _e6291 = phi_15401_;
                        if (_e6000 < 0f) {
                            phi_15408_ = -(_e6000);
                        } else {
                            phi_15408_ = _e6000;
                        }
                        let _e6296 = phi_15408_;
                        let _e6298 = (((_e6287 + _e6291) + _e6296) * 0.5f);
                        if (_e6283 > _e6298) {
                            phi_15415_ = _e6283;
                        } else {
                            phi_15415_ = _e6298;
                        }
                        let _e6301 = phi_15415_;
                        let _e6306 = local_18.member_3;
                        let _e6318 = (((((_e6122 * 8f) * _e6232) * (0.000000059604645f * (524f / 64f))) + ((_e6239 * 19f) * ((_e6122 * (_e6176 + _e6230)) + (_e6176 * _e6230)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6122) * ((1f + _e6176) * (1f + _e6230)))));
                        let _e6319 = (_e6011 * 3f);
                        let _e6320 = (_e6068 * 3f);
                        if (_e6319 < _e6320) {
                            phi_15439_ = _e6319;
                        } else {
                            phi_15439_ = _e6320;
                        }
                        let _e6323 = phi_15439_;
                        if (_e6034 < _e6057) {
                            phi_15444_ = _e6034;
                        } else {
                            phi_15444_ = _e6057;
                        }
                        let _e6326 = phi_15444_;
                        if (_e6323 < _e6326) {
                            phi_15449_ = _e6323;
                        } else {
                            phi_15449_ = _e6326;
                        }
                        let _e6329 = phi_15449_;
                        if (_e6319 > _e6320) {
                            phi_15454_ = _e6319;
                        } else {
                            phi_15454_ = _e6320;
                        }
                        let _e6332 = phi_15454_;
                        if (_e6034 > _e6057) {
                            phi_15459_ = _e6034;
                        } else {
                            phi_15459_ = _e6057;
                        }
                        let _e6335 = phi_15459_;
                        if (_e6332 > _e6335) {
                            phi_15464_ = _e6332;
                        } else {
                            phi_15464_ = _e6335;
                        }
                        let _e6338 = phi_15464_;
                        let _e6343 = -(_e6338);
                        if (_e6329 > _e6343) {
                            phi_15474_ = _e6329;
                        } else {
                            phi_15474_ = _e6343;
                        }
                        let _e6346 = phi_15474_;
                        if ((_e6346 - (_e6318 + ((0f * (((_e6301 + (_e6232 * (0.000000059604645f * 8f))) + ((_e6306 * 6f) * (_e6176 + _e6230))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6176) * (1f + _e6230))))) * (3f * 1.0001f)))) > 0f) {
                            phi_22328_ = type_44(0u, type_44().member_1);
                            phi_22329_ = type_44();
                            phi_22330_ = true;
                        } else {
                            if (_e6011 < 0f) {
                                phi_15487_ = -(_e6011);
                            } else {
                                phi_15487_ = _e6011;
                            }
                            let _e6353 = phi_15487_;
                            if (_e6034 < 0f) {
                                phi_15493_ = -(_e6034);
                            } else {
                                phi_15493_ = _e6034;
                            }
                            let _e6357 = phi_15493_;
                            if (_e6353 > _e6357) {
                                phi_15498_ = _e6353;
                            } else {
                                phi_15498_ = _e6357;
                            }
                            let _e6360 = phi_15498_;
                            if (_e6057 < 0f) {
                                phi_15504_ = -(_e6057);
                            } else {
                                phi_15504_ = _e6057;
                            }
                            let _e6364 = phi_15504_;
                            if (_e6068 < 0f) {
                                phi_15510_ = -(_e6068);
                            } else {
                                phi_15510_ = _e6068;
                            }
                            let _e6368 = phi_15510_;
                            if (_e6364 > _e6368) {
                                phi_15515_ = _e6364;
                            } else {
                                phi_15515_ = _e6368;
                            }
                            let _e6371 = phi_15515_;
                            if (_e6360 > _e6371) {
                                phi_15520_ = _e6360;
                            } else {
                                phi_15520_ = _e6371;
                            }
                            let _e6374 = phi_15520_;
                            let _e6375 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                            if (_e6374 >= _e6375) {
                                phi_15528_ = (_e6374 <= (1f / _e6375));
                            } else {
                                phi_15528_ = false;
                            }
                            let _e6380 = phi_15528_;
                            if _e6380 {
                                phi_15533_ = (0.000000059604645f * 256f);
                            } else {
                                phi_15533_ = 2f;
                            }
                            let _e6383 = phi_15533_;
                            let _e6385 = ((_e6318 * 0.34f) + (_e6374 * _e6383));
                            if _e6380 {
                                phi_15540_ = (1f / _e6374);
                            } else {
                                phi_15540_ = 0f;
                            }
                            let _e6388 = phi_15540_;
                            let _e6389 = (_e5602 * 0.0625f);
                            if (0.00000000000022737368f < _e6389) {
                                phi_15546_ = 0.00000000000022737368f;
                            } else {
                                phi_15546_ = _e6389;
                            }
                            let _e6392 = phi_15546_;
                            let _e6393 = (1f - _e5604);
                            let _e6404 = ((((_e6011 * _e6393) + (_e6034 * _e5604)) * (_e6393 * _e6393)) + (((_e6057 * _e6393) + (_e6068 * _e5604)) * (_e5604 * _e5604)));
                            if (_e6404 < 0f) {
                                phi_15564_ = -(_e6404);
                            } else {
                                phi_15564_ = _e6404;
                            }
                            let _e6408 = phi_15564_;
                            if !((_e6408 > _e6385)) {
                                let _e6413 = local_18.member[0u];
                                let _e6420 = local_18.member_1[0u];
                                let _e6426 = local_18.member_2[0u];
                                let _e6430 = (_e6413[0] - _e6420[0]);
                                let _e6431 = (_e6413[1] - _e6420[1]);
                                let _e6432 = (_e6413[2] - _e6420[2]);
                                if (_e316.member == 0u) {
                                    phi_15625_ = array<f32, 3>(_e6413[0], _e6413[1], _e6413[2]);
                                } else {
                                    phi_15625_ = array<f32, 3>((_e6430 - _e6426[0]), (_e6431 - _e6426[1]), (_e6432 - _e6426[2]));
                                }
                                let _e6439 = phi_15625_;
                                let _e6440 = (_e6413[0] - _e6426[0]);
                                let _e6441 = (_e6413[1] - _e6426[1]);
                                let _e6442 = (_e6413[2] - _e6426[2]);
                                let _e6445 = local_18.member[1u];
                                let _e6452 = local_18.member_1[1u];
                                let _e6458 = local_18.member_2[1u];
                                let _e6462 = (_e6445[0] - _e6452[0]);
                                let _e6463 = (_e6445[1] - _e6452[1]);
                                let _e6464 = (_e6445[2] - _e6452[2]);
                                if (_e316.member == 0u) {
                                    phi_15690_ = array<f32, 3>(_e6445[0], _e6445[1], _e6445[2]);
                                } else {
                                    phi_15690_ = array<f32, 3>((_e6462 - _e6458[0]), (_e6463 - _e6458[1]), (_e6464 - _e6458[2]));
                                }
                                let _e6471 = phi_15690_;
                                let _e6472 = (_e6445[0] - _e6458[0]);
                                let _e6473 = (_e6445[1] - _e6458[1]);
                                let _e6474 = (_e6445[2] - _e6458[2]);
                                let _e6477 = local_18.member[0u];
                                if (_e6477[0] < 0f) {
                                    phi_15712_ = -(_e6477[0]);
                                } else {
                                    phi_15712_ = _e6477[0];
                                }
                                let _e6484 = phi_15712_;
                                if (_e6477[1] < 0f) {
                                    phi_15719_ = -(_e6477[1]);
                                } else {
                                    phi_15719_ = _e6477[1];
                                }
                                let _e6488 = phi_15719_;
                                if (_e6484 > _e6488) {
                                    phi_15724_ = _e6484;
                                } else {
                                    phi_15724_ = _e6488;
                                }
                                let _e6491 = phi_15724_;
                                if (_e6477[2] < 0f) {
                                    phi_15731_ = -(_e6477[2]);
                                } else {
                                    phi_15731_ = _e6477[2];
                                }
                                let _e6495 = phi_15731_;
                                if (_e6491 > _e6495) {
                                    phi_15736_ = _e6491;
                                } else {
                                    phi_15736_ = _e6495;
                                }
                                let _e6498 = phi_15736_;
                                let _e6501 = local_18.member[1u];
                                if (_e6501[0] < 0f) {
                                    phi_15749_ = -(_e6501[0]);
                                } else {
                                    phi_15749_ = _e6501[0];
                                }
                                let _e6508 = phi_15749_;
                                if (_e6501[1] < 0f) {
                                    phi_15756_ = -(_e6501[1]);
                                } else {
                                    phi_15756_ = _e6501[1];
                                }
                                let _e6512 = phi_15756_;
                                if (_e6508 > _e6512) {
                                    phi_15761_ = _e6508;
                                } else {
                                    phi_15761_ = _e6512;
                                }
                                let _e6515 = phi_15761_;
                                if (_e6501[2] < 0f) {
                                    phi_15768_ = -(_e6501[2]);
                                } else {
                                    phi_15768_ = _e6501[2];
                                }
                                let _e6519 = phi_15768_;
                                if (_e6515 > _e6519) {
                                    phi_15773_ = _e6515;
                                } else {
                                    phi_15773_ = _e6519;
                                }
                                let _e6522 = phi_15773_;
                                if (_e6498 > _e6522) {
                                    phi_15778_ = _e6498;
                                } else {
                                    phi_15778_ = _e6522;
                                }
                                let _e6525 = phi_15778_;
                                let _e6527 = local_18.member_3;
                                let _e6531 = local_18.member_1[0u];
                                if (_e6531[0] < 0f) {
                                    phi_15795_ = -(_e6531[0]);
                                } else {
                                    phi_15795_ = _e6531[0];
                                }
                                let _e6538 = phi_15795_;
                                if (_e6531[1] < 0f) {
                                    phi_15802_ = -(_e6531[1]);
                                } else {
                                    phi_15802_ = _e6531[1];
                                }
                                let _e6542 = phi_15802_;
                                if (_e6538 > _e6542) {
                                    phi_15807_ = _e6538;
                                } else {
                                    phi_15807_ = _e6542;
                                }
                                let _e6545 = phi_15807_;
                                if (_e6531[2] < 0f) {
                                    phi_15814_ = -(_e6531[2]);
                                } else {
                                    phi_15814_ = _e6531[2];
                                }
                                let _e6549 = phi_15814_;
                                if (_e6545 > _e6549) {
                                    phi_15819_ = _e6545;
                                } else {
                                    phi_15819_ = _e6549;
                                }
                                let _e6552 = phi_15819_;
                                let _e6555 = local_18.member_1[1u];
                                if (_e6555[0] < 0f) {
                                    phi_15833_ = -(_e6555[0]);
                                } else {
                                    phi_15833_ = _e6555[0];
                                }
                                let _e6562 = phi_15833_;
                                if (_e6555[1] < 0f) {
                                    phi_15840_ = -(_e6555[1]);
                                } else {
                                    phi_15840_ = _e6555[1];
                                }
                                let _e6566 = phi_15840_;
                                if (_e6562 > _e6566) {
                                    phi_15845_ = _e6562;
                                } else {
                                    phi_15845_ = _e6566;
                                }
                                let _e6569 = phi_15845_;
                                if (_e6555[2] < 0f) {
                                    phi_15852_ = -(_e6555[2]);
                                } else {
                                    phi_15852_ = _e6555[2];
                                }
                                let _e6573 = phi_15852_;
                                if (_e6569 > _e6573) {
                                    phi_15857_ = _e6569;
                                } else {
                                    phi_15857_ = _e6573;
                                }
                                let _e6576 = phi_15857_;
                                if (_e6552 > _e6576) {
                                    phi_15862_ = _e6552;
                                } else {
                                    phi_15862_ = _e6576;
                                }
                                let _e6579 = phi_15862_;
                                let _e6581 = local_18.member_3;
                                let _e6585 = local_18.member_2[0u];
                                if (_e6585[0] < 0f) {
                                    phi_15879_ = -(_e6585[0]);
                                } else {
                                    phi_15879_ = _e6585[0];
                                }
                                let _e6592 = phi_15879_;
                                if (_e6585[1] < 0f) {
                                    phi_15886_ = -(_e6585[1]);
                                } else {
                                    phi_15886_ = _e6585[1];
                                }
                                let _e6596 = phi_15886_;
                                if (_e6592 > _e6596) {
                                    phi_15891_ = _e6592;
                                } else {
                                    phi_15891_ = _e6596;
                                }
                                let _e6599 = phi_15891_;
                                if (_e6585[2] < 0f) {
                                    phi_15898_ = -(_e6585[2]);
                                } else {
                                    phi_15898_ = _e6585[2];
                                }
                                let _e6603 = phi_15898_;
                                if (_e6599 > _e6603) {
                                    phi_15903_ = _e6599;
                                } else {
                                    phi_15903_ = _e6603;
                                }
                                let _e6606 = phi_15903_;
                                let _e6609 = local_18.member_2[1u];
                                if (_e6609[0] < 0f) {
                                    phi_15917_ = -(_e6609[0]);
                                } else {
                                    phi_15917_ = _e6609[0];
                                }
                                let _e6616 = phi_15917_;
                                if (_e6609[1] < 0f) {
                                    phi_15924_ = -(_e6609[1]);
                                } else {
                                    phi_15924_ = _e6609[1];
                                }
                                let _e6620 = phi_15924_;
                                if (_e6616 > _e6620) {
                                    phi_15929_ = _e6616;
                                } else {
                                    phi_15929_ = _e6620;
                                }
                                let _e6623 = phi_15929_;
                                if (_e6609[2] < 0f) {
                                    phi_15936_ = -(_e6609[2]);
                                } else {
                                    phi_15936_ = _e6609[2];
                                }
                                let _e6627 = phi_15936_;
                                if (_e6623 > _e6627) {
                                    phi_15941_ = _e6623;
                                } else {
                                    phi_15941_ = _e6627;
                                }
                                let _e6630 = phi_15941_;
                                if (_e6606 > _e6630) {
                                    phi_15946_ = _e6606;
                                } else {
                                    phi_15946_ = _e6630;
                                }
                                let _e6633 = phi_15946_;
                                let _e6635 = local_18.member_3;
                                let _e6642 = local_18.member_3;
                                let _e6646 = ((((((_e6525 + _e6527) + (_e6579 + _e6581)) + (_e6633 + _e6635)) * (0.000000059604645f * 16f)) + (_e6642 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e6649 = local_18.member[0u];
                                let _e6655 = local_18.member[1u];
                                let _e6671 = local_18.member_1[0u];
                                let _e6677 = local_18.member_1[1u];
                                let _e6693 = local_18.member_2[0u];
                                let _e6699 = local_18.member_2[1u];
                                let _e6713 = function_3(array<f32, 3>((_e6649[0] + ((_e6655[0] - _e6649[0]) * _e5604)), (_e6649[1] + ((_e6655[1] - _e6649[1]) * _e5604)), (_e6649[2] + ((_e6655[2] - _e6649[2]) * _e5604))), array<f32, 3>((_e6671[0] + ((_e6677[0] - _e6671[0]) * _e5604)), (_e6671[1] + ((_e6677[1] - _e6671[1]) * _e5604)), (_e6671[2] + ((_e6677[2] - _e6671[2]) * _e5604))), array<f32, 3>((_e6693[0] + ((_e6699[0] - _e6693[0]) * _e5604)), (_e6693[1] + ((_e6699[1] - _e6693[1]) * _e5604)), (_e6693[2] + ((_e6699[2] - _e6693[2]) * _e5604))), _e316.member);
                                if (_e6713[0] < 0f) {
                                    phi_16064_ = -(_e6713[0]);
                                } else {
                                    phi_16064_ = _e6713[0];
                                }
                                let _e6718 = phi_16064_;
                                if (_e6713[1] < 0f) {
                                    phi_16071_ = -(_e6713[1]);
                                } else {
                                    phi_16071_ = _e6713[1];
                                }
                                let _e6723 = phi_16071_;
                                if (_e6713[2] < 0f) {
                                    phi_16079_ = -(_e6713[2]);
                                } else {
                                    phi_16079_ = _e6713[2];
                                }
                                let _e6729 = phi_16079_;
                                let _e6730 = ((_e6718 + _e6723) + _e6729);
                                if (_e6730 > 0f) {
                                    if ((bitcast<u32>(_e6730) & 2139095040u) != 2139095040u) {
                                        let _e6735 = (1f / _e6730);
                                        let _e6737 = (_e6713[0] * _e6735);
                                        let _e6739 = (_e6713[1] * _e6735);
                                        let _e6741 = (_e6713[2] * _e6735);
                                        let _e6746 = (((_e6737 * _e6737) + (_e6739 * _e6739)) + (_e6741 * _e6741));
                                        if (_e6746 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e6746 > 0f) {
                                                phi_16116_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_16116_ = 0f;
                                            }
                                            let _e6799 = phi_16116_;
                                            phi_16180_ = _e6799;
                                        } else {
                                            phi_16123_ = type_14(0i, 5i);
                                            phi_16126_ = bitcast<f32>(((bitcast<u32>(_e6746) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e6754 = phi_16123_;
                                                let _e6756 = phi_16126_;
                                                local_85 = _e6756;
                                                if (_e6754.member < _e6754.member_1) {
                                                    let _e6763 = (_e6754.member + 1i);
                                                    if ((false == (_e6763 > _e6754.member)) != false) {
                                                        phi_16147_ = true;
                                                    } else {
                                                        phi_16147_ = false;
                                                    }
                                                    let _e6768 = phi_16147_;
                                                    if _e6768 {
                                                        phi_16153_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_16153_ = type_15(1u, _e6763);
                                                    }
                                                    let _e6773 = phi_16153_;
                                                    phi_16124_ = type_14(_e6773.member_1, _e6754.member_1);
                                                    phi_16167_ = type_15(1u, _e6754.member);
                                                } else {
                                                    phi_16124_ = _e6754;
                                                    phi_16167_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e6779 = phi_16124_;
                                                let _e6781 = phi_16167_;
                                                let _e6784 = (bitcast<i32>(_e6781.member) != 0i);
                                                if _e6784 {
                                                    phi_16127_ = (0.5f * (_e6756 + (_e6746 / _e6756)));
                                                } else {
                                                    phi_16127_ = f32();
                                                }
                                                let _e6789 = phi_16127_;
                                                continue;
                                                continuing {
                                                    phi_16123_ = _e6779;
                                                    phi_16126_ = _e6789;
                                                    break if !(_e6784);
                                                }
                                            }
                                            let _e6794 = local_85;
                                            phi_16180_ = (_e6794 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e6801 = phi_16180_;
                                        let _e6802 = (0.000000059604645f * 12f);
                                        let _e6807 = ((_e6646 * 1.01f) + ((0f * _e6801) * (1f + _e6802)));
                                        let _e6812 = (((_e6737 * _e6413[0]) + (_e6739 * _e6413[1])) + (_e6741 * _e6413[2]));
                                        let _e6817 = (((_e6737 * _e6430) + (_e6739 * _e6431)) + (_e6741 * _e6432));
                                        let _e6822 = (((_e6737 * _e6440) + (_e6739 * _e6441)) + (_e6741 * _e6442));
                                        let _e6830 = (((_e6737 * _e6439[0]) + (_e6739 * _e6439[1])) + (_e6741 * _e6439[2]));
                                        let _e6836 = (((_e6737 * _e6445[0]) + (_e6739 * _e6445[1])) + (_e6741 * _e6445[2]));
                                        let _e6841 = (((_e6737 * _e6462) + (_e6739 * _e6463)) + (_e6741 * _e6464));
                                        let _e6846 = (((_e6737 * _e6472) + (_e6739 * _e6473)) + (_e6741 * _e6474));
                                        let _e6854 = (((_e6737 * _e6471[0]) + (_e6739 * _e6471[1])) + (_e6741 * _e6471[2]));
                                        if (_e6812 < 0f) {
                                            phi_16246_ = -(_e6812);
                                        } else {
                                            phi_16246_ = _e6812;
                                        }
                                        let _e6859 = phi_16246_;
                                        if (_e6836 < 0f) {
                                            phi_16252_ = -(_e6836);
                                        } else {
                                            phi_16252_ = _e6836;
                                        }
                                        let _e6863 = phi_16252_;
                                        if (_e6817 < 0f) {
                                            phi_16261_ = -(_e6817);
                                        } else {
                                            phi_16261_ = _e6817;
                                        }
                                        let _e6870 = phi_16261_;
                                        if (_e6841 < 0f) {
                                            phi_16267_ = -(_e6841);
                                        } else {
                                            phi_16267_ = _e6841;
                                        }
                                        let _e6874 = phi_16267_;
                                        if (_e6822 < 0f) {
                                            phi_16276_ = -(_e6822);
                                        } else {
                                            phi_16276_ = _e6822;
                                        }
                                        let _e6881 = phi_16276_;
                                        if (_e6846 < 0f) {
                                            phi_16282_ = -(_e6846);
                                        } else {
                                            phi_16282_ = _e6846;
                                        }
                                        let _e6885 = phi_16282_;
                                        if (_e6830 < 0f) {
                                            phi_16291_ = -(_e6830);
                                        } else {
                                            phi_16291_ = _e6830;
                                        }
                                        let _e6892 = phi_16291_;
                                        if (_e6854 < 0f) {
                                            phi_16297_ = -(_e6854);
                                        } else {
                                            phi_16297_ = _e6854;
                                        }
                                        let _e6896 = phi_16297_;
                                        phi_16303_ = type_29(array<f32, 4>(_e6812, _e6817, _e6822, _e6830), array<f32, 4>(_e6836, _e6841, _e6846, _e6854), array<f32, 4>((_e6807 + ((_e6859 + _e6863) * _e6802)), (_e6807 + ((_e6870 + _e6874) * _e6802)), (_e6807 + ((_e6881 + _e6885) * _e6802)), (_e6807 + ((_e6892 + _e6896) * _e6802))));
                                        phi_16304_ = false;
                                    } else {
                                        phi_16303_ = type_29();
                                        phi_16304_ = true;
                                    }
                                    let _e6903 = phi_16303_;
                                    let _e6905 = phi_16304_;
                                    phi_16305_ = _e6903;
                                    phi_16306_ = _e6905;
                                } else {
                                    phi_16305_ = type_29();
                                    phi_16306_ = true;
                                }
                                let _e6907 = phi_16305_;
                                let _e6909 = phi_16306_;
                                if _e6909 {
                                    phi_16314_ = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                } else {
                                    phi_16314_ = _e6907;
                                }
                                let _e6911 = phi_16314_;
                                local_8 = type_29(array<f32, 4>(_e6911.member[0], _e6911.member[1], _e6911.member[2], _e6911.member[3]), array<f32, 4>(_e6911.member_1[0], _e6911.member_1[1], _e6911.member_1[2], _e6911.member_1[3]), array<f32, 4>(_e6911.member_2[0], _e6911.member_2[1], _e6911.member_2[2], _e6911.member_2[3]));
                                let _e6933 = local_8.member[0u];
                                let _e6936 = local_8.member_1[0u];
                                let _e6939 = local_8.member[0u];
                                let _e6945 = local_8.member_2[0u];
                                if (((_e6933 + ((_e6936 - _e6939) * _e5604)) - _e6945) > 0f) {
                                    let _e6950 = local_8.member[1u];
                                    let _e6953 = local_8.member_1[1u];
                                    let _e6956 = local_8.member[1u];
                                    let _e6962 = local_8.member_2[1u];
                                    if (((_e6950 + ((_e6953 - _e6956) * _e5604)) - _e6962) > 0f) {
                                        let _e6967 = local_8.member[2u];
                                        let _e6970 = local_8.member_1[2u];
                                        let _e6973 = local_8.member[2u];
                                        let _e6979 = local_8.member_2[2u];
                                        if (((_e6967 + ((_e6970 - _e6973) * _e5604)) - _e6979) > 0f) {
                                            let _e6984 = local_8.member[3u];
                                            let _e6987 = local_8.member_1[3u];
                                            let _e6990 = local_8.member[3u];
                                            let _e6996 = local_8.member_2[3u];
                                            phi_16483_ = (((_e6984 + ((_e6987 - _e6990) * _e5604)) - _e6996) > 0f);
                                            phi_16484_ = false;
                                        } else {
                                            phi_16483_ = bool();
                                            phi_16484_ = true;
                                        }
                                        let _e7000 = phi_16483_;
                                        let _e7002 = phi_16484_;
                                        phi_16485_ = _e7000;
                                        phi_16486_ = _e7002;
                                    } else {
                                        phi_16485_ = bool();
                                        phi_16486_ = true;
                                    }
                                    let _e7004 = phi_16485_;
                                    let _e7006 = phi_16486_;
                                    phi_16487_ = _e7004;
                                    phi_16488_ = _e7006;
                                } else {
                                    phi_16487_ = bool();
                                    phi_16488_ = true;
                                }
                                let _e7008 = phi_16487_;
                                let _e7010 = phi_16488_;
                                if _e7010 {
                                    phi_16492_ = false;
                                } else {
                                    phi_16492_ = _e7008;
                                }
                                let _e7012 = phi_16492_;
                                if _e7012 {
                                    phi_17846_ = bool();
                                    phi_17847_ = true;
                                } else {
                                    if (_e6713[0] < 0f) {
                                        phi_16519_ = -(_e6713[0]);
                                    } else {
                                        phi_16519_ = _e6713[0];
                                    }
                                    let _e7017 = phi_16519_;
                                    let _e7019 = ((_e7017 + 0f) + 0f);
                                    if (_e7019 > 0f) {
                                        if ((bitcast<u32>(_e7019) & 2139095040u) != 2139095040u) {
                                            let _e7024 = (1f / _e7019);
                                            let _e7025 = (_e6713[0] * _e7024);
                                            let _e7026 = (0f * _e7024);
                                            let _e7027 = (0f * _e7024);
                                            let _e7032 = (((_e7025 * _e7025) + (_e7026 * _e7026)) + (_e7027 * _e7027));
                                            if (_e7032 <= 0.000000000000000000000000000000000000011754944f) {
                                                if (_e7032 > 0f) {
                                                    phi_16566_ = (0.000000000000000000106433627f * 2f);
                                                } else {
                                                    phi_16566_ = 0f;
                                                }
                                                let _e7085 = phi_16566_;
                                                phi_16630_ = _e7085;
                                            } else {
                                                phi_16573_ = type_14(0i, 5i);
                                                phi_16576_ = bitcast<f32>(((bitcast<u32>(_e7032) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e7040 = phi_16573_;
                                                    let _e7042 = phi_16576_;
                                                    local_86 = _e7042;
                                                    if (_e7040.member < _e7040.member_1) {
                                                        let _e7049 = (_e7040.member + 1i);
                                                        if ((false == (_e7049 > _e7040.member)) != false) {
                                                            phi_16597_ = true;
                                                        } else {
                                                            phi_16597_ = false;
                                                        }
                                                        let _e7054 = phi_16597_;
                                                        if _e7054 {
                                                            phi_16603_ = type_15(0u, type_15().member_1);
                                                        } else {
                                                            phi_16603_ = type_15(1u, _e7049);
                                                        }
                                                        let _e7059 = phi_16603_;
                                                        phi_16574_ = type_14(_e7059.member_1, _e7040.member_1);
                                                        phi_16617_ = type_15(1u, _e7040.member);
                                                    } else {
                                                        phi_16574_ = _e7040;
                                                        phi_16617_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e7065 = phi_16574_;
                                                    let _e7067 = phi_16617_;
                                                    let _e7070 = (bitcast<i32>(_e7067.member) != 0i);
                                                    if _e7070 {
                                                        phi_16577_ = (0.5f * (_e7042 + (_e7032 / _e7042)));
                                                    } else {
                                                        phi_16577_ = f32();
                                                    }
                                                    let _e7075 = phi_16577_;
                                                    continue;
                                                    continuing {
                                                        phi_16573_ = _e7065;
                                                        phi_16576_ = _e7075;
                                                        break if !(_e7070);
                                                    }
                                                }
                                                let _e7080 = local_86;
                                                phi_16630_ = (_e7080 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e7087 = phi_16630_;
                                            let _e7088 = (0.000000059604645f * 12f);
                                            let _e7093 = ((_e6646 * 1.01f) + ((0f * _e7087) * (1f + _e7088)));
                                            let _e7098 = (((_e7025 * _e6413[0]) + (_e7026 * _e6413[1])) + (_e7027 * _e6413[2]));
                                            let _e7103 = (((_e7025 * _e6430) + (_e7026 * _e6431)) + (_e7027 * _e6432));
                                            let _e7108 = (((_e7025 * _e6440) + (_e7026 * _e6441)) + (_e7027 * _e6442));
                                            let _e7116 = (((_e7025 * _e6439[0]) + (_e7026 * _e6439[1])) + (_e7027 * _e6439[2]));
                                            let _e7122 = (((_e7025 * _e6445[0]) + (_e7026 * _e6445[1])) + (_e7027 * _e6445[2]));
                                            let _e7127 = (((_e7025 * _e6462) + (_e7026 * _e6463)) + (_e7027 * _e6464));
                                            let _e7132 = (((_e7025 * _e6472) + (_e7026 * _e6473)) + (_e7027 * _e6474));
                                            let _e7140 = (((_e7025 * _e6471[0]) + (_e7026 * _e6471[1])) + (_e7027 * _e6471[2]));
                                            if (_e7098 < 0f) {
                                                phi_16696_ = -(_e7098);
                                            } else {
                                                phi_16696_ = _e7098;
                                            }
                                            let _e7145 = phi_16696_;
                                            if (_e7122 < 0f) {
                                                phi_16702_ = -(_e7122);
                                            } else {
                                                phi_16702_ = _e7122;
                                            }
                                            let _e7149 = phi_16702_;
                                            if (_e7103 < 0f) {
                                                phi_16711_ = -(_e7103);
                                            } else {
                                                phi_16711_ = _e7103;
                                            }
                                            let _e7156 = phi_16711_;
                                            if (_e7127 < 0f) {
                                                phi_16717_ = -(_e7127);
                                            } else {
                                                phi_16717_ = _e7127;
                                            }
                                            let _e7160 = phi_16717_;
                                            if (_e7108 < 0f) {
                                                phi_16726_ = -(_e7108);
                                            } else {
                                                phi_16726_ = _e7108;
                                            }
                                            let _e7167 = phi_16726_;
                                            if (_e7132 < 0f) {
                                                phi_16732_ = -(_e7132);
                                            } else {
                                                phi_16732_ = _e7132;
                                            }
                                            let _e7171 = phi_16732_;
                                            if (_e7116 < 0f) {
                                                phi_16741_ = -(_e7116);
                                            } else {
                                                phi_16741_ = _e7116;
                                            }
                                            let _e7178 = phi_16741_;
                                            if (_e7140 < 0f) {
                                                phi_16747_ = -(_e7140);
                                            } else {
                                                phi_16747_ = _e7140;
                                            }
                                            let _e7182 = phi_16747_;
                                            phi_16753_ = type_29(array<f32, 4>(_e7098, _e7103, _e7108, _e7116), array<f32, 4>(_e7122, _e7127, _e7132, _e7140), array<f32, 4>((_e7093 + ((_e7145 + _e7149) * _e7088)), (_e7093 + ((_e7156 + _e7160) * _e7088)), (_e7093 + ((_e7167 + _e7171) * _e7088)), (_e7093 + ((_e7178 + _e7182) * _e7088))));
                                            phi_16754_ = false;
                                        } else {
                                            phi_16753_ = type_29();
                                            phi_16754_ = true;
                                        }
                                        let _e7189 = phi_16753_;
                                        let _e7191 = phi_16754_;
                                        phi_16755_ = _e7189;
                                        phi_16756_ = _e7191;
                                    } else {
                                        phi_16755_ = type_29();
                                        phi_16756_ = true;
                                    }
                                    let _e7193 = phi_16755_;
                                    let _e7195 = phi_16756_;
                                    if _e7195 {
                                        phi_16764_ = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    } else {
                                        phi_16764_ = _e7193;
                                    }
                                    let _e7197 = phi_16764_;
                                    local_9 = type_29(array<f32, 4>(_e7197.member[0], _e7197.member[1], _e7197.member[2], _e7197.member[3]), array<f32, 4>(_e7197.member_1[0], _e7197.member_1[1], _e7197.member_1[2], _e7197.member_1[3]), array<f32, 4>(_e7197.member_2[0], _e7197.member_2[1], _e7197.member_2[2], _e7197.member_2[3]));
                                    let _e7219 = local_9.member[0u];
                                    let _e7222 = local_9.member_1[0u];
                                    let _e7225 = local_9.member[0u];
                                    let _e7231 = local_9.member_2[0u];
                                    if (((_e7219 + ((_e7222 - _e7225) * _e5604)) - _e7231) > 0f) {
                                        let _e7236 = local_9.member[1u];
                                        let _e7239 = local_9.member_1[1u];
                                        let _e7242 = local_9.member[1u];
                                        let _e7248 = local_9.member_2[1u];
                                        if (((_e7236 + ((_e7239 - _e7242) * _e5604)) - _e7248) > 0f) {
                                            let _e7253 = local_9.member[2u];
                                            let _e7256 = local_9.member_1[2u];
                                            let _e7259 = local_9.member[2u];
                                            let _e7265 = local_9.member_2[2u];
                                            if (((_e7253 + ((_e7256 - _e7259) * _e5604)) - _e7265) > 0f) {
                                                let _e7270 = local_9.member[3u];
                                                let _e7273 = local_9.member_1[3u];
                                                let _e7276 = local_9.member[3u];
                                                let _e7282 = local_9.member_2[3u];
                                                phi_16933_ = (((_e7270 + ((_e7273 - _e7276) * _e5604)) - _e7282) > 0f);
                                                phi_16934_ = false;
                                            } else {
                                                phi_16933_ = bool();
                                                phi_16934_ = true;
                                            }
                                            let _e7286 = phi_16933_;
                                            let _e7288 = phi_16934_;
                                            phi_16935_ = _e7286;
                                            phi_16936_ = _e7288;
                                        } else {
                                            phi_16935_ = bool();
                                            phi_16936_ = true;
                                        }
                                        let _e7290 = phi_16935_;
                                        let _e7292 = phi_16936_;
                                        phi_16937_ = _e7290;
                                        phi_16938_ = _e7292;
                                    } else {
                                        phi_16937_ = bool();
                                        phi_16938_ = true;
                                    }
                                    let _e7294 = phi_16937_;
                                    let _e7296 = phi_16938_;
                                    if _e7296 {
                                        phi_16942_ = false;
                                    } else {
                                        phi_16942_ = _e7294;
                                    }
                                    let _e7298 = phi_16942_;
                                    if _e7298 {
                                        phi_17844_ = bool();
                                        phi_17845_ = true;
                                    } else {
                                        if (_e6713[1] < 0f) {
                                            phi_16975_ = -(_e6713[1]);
                                        } else {
                                            phi_16975_ = _e6713[1];
                                        }
                                        let _e7303 = phi_16975_;
                                        let _e7305 = ((0f + _e7303) + 0f);
                                        if (_e7305 > 0f) {
                                            if ((bitcast<u32>(_e7305) & 2139095040u) != 2139095040u) {
                                                let _e7310 = (1f / _e7305);
                                                let _e7311 = (0f * _e7310);
                                                let _e7312 = (_e6713[1] * _e7310);
                                                let _e7313 = (0f * _e7310);
                                                let _e7318 = (((_e7311 * _e7311) + (_e7312 * _e7312)) + (_e7313 * _e7313));
                                                if (_e7318 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e7318 > 0f) {
                                                        phi_17016_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_17016_ = 0f;
                                                    }
                                                    let _e7371 = phi_17016_;
                                                    phi_17080_ = _e7371;
                                                } else {
                                                    phi_17023_ = type_14(0i, 5i);
                                                    phi_17026_ = bitcast<f32>(((bitcast<u32>(_e7318) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e7326 = phi_17023_;
                                                        let _e7328 = phi_17026_;
                                                        local_87 = _e7328;
                                                        if (_e7326.member < _e7326.member_1) {
                                                            let _e7335 = (_e7326.member + 1i);
                                                            if ((false == (_e7335 > _e7326.member)) != false) {
                                                                phi_17047_ = true;
                                                            } else {
                                                                phi_17047_ = false;
                                                            }
                                                            let _e7340 = phi_17047_;
                                                            if _e7340 {
                                                                phi_17053_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_17053_ = type_15(1u, _e7335);
                                                            }
                                                            let _e7345 = phi_17053_;
                                                            phi_17024_ = type_14(_e7345.member_1, _e7326.member_1);
                                                            phi_17067_ = type_15(1u, _e7326.member);
                                                        } else {
                                                            phi_17024_ = _e7326;
                                                            phi_17067_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e7351 = phi_17024_;
                                                        let _e7353 = phi_17067_;
                                                        let _e7356 = (bitcast<i32>(_e7353.member) != 0i);
                                                        if _e7356 {
                                                            phi_17027_ = (0.5f * (_e7328 + (_e7318 / _e7328)));
                                                        } else {
                                                            phi_17027_ = f32();
                                                        }
                                                        let _e7361 = phi_17027_;
                                                        continue;
                                                        continuing {
                                                            phi_17023_ = _e7351;
                                                            phi_17026_ = _e7361;
                                                            break if !(_e7356);
                                                        }
                                                    }
                                                    let _e7366 = local_87;
                                                    phi_17080_ = (_e7366 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e7373 = phi_17080_;
                                                let _e7374 = (0.000000059604645f * 12f);
                                                let _e7379 = ((_e6646 * 1.01f) + ((0f * _e7373) * (1f + _e7374)));
                                                let _e7384 = (((_e7311 * _e6413[0]) + (_e7312 * _e6413[1])) + (_e7313 * _e6413[2]));
                                                let _e7389 = (((_e7311 * _e6430) + (_e7312 * _e6431)) + (_e7313 * _e6432));
                                                let _e7394 = (((_e7311 * _e6440) + (_e7312 * _e6441)) + (_e7313 * _e6442));
                                                let _e7402 = (((_e7311 * _e6439[0]) + (_e7312 * _e6439[1])) + (_e7313 * _e6439[2]));
                                                let _e7408 = (((_e7311 * _e6445[0]) + (_e7312 * _e6445[1])) + (_e7313 * _e6445[2]));
                                                let _e7413 = (((_e7311 * _e6462) + (_e7312 * _e6463)) + (_e7313 * _e6464));
                                                let _e7418 = (((_e7311 * _e6472) + (_e7312 * _e6473)) + (_e7313 * _e6474));
                                                let _e7426 = (((_e7311 * _e6471[0]) + (_e7312 * _e6471[1])) + (_e7313 * _e6471[2]));
                                                if (_e7384 < 0f) {
                                                    phi_17146_ = -(_e7384);
                                                } else {
                                                    phi_17146_ = _e7384;
                                                }
                                                let _e7431 = phi_17146_;
                                                if (_e7408 < 0f) {
                                                    phi_17152_ = -(_e7408);
                                                } else {
                                                    phi_17152_ = _e7408;
                                                }
                                                let _e7435 = phi_17152_;
                                                if (_e7389 < 0f) {
                                                    phi_17161_ = -(_e7389);
                                                } else {
                                                    phi_17161_ = _e7389;
                                                }
                                                let _e7442 = phi_17161_;
                                                if (_e7413 < 0f) {
                                                    phi_17167_ = -(_e7413);
                                                } else {
                                                    phi_17167_ = _e7413;
                                                }
                                                let _e7446 = phi_17167_;
                                                if (_e7394 < 0f) {
                                                    phi_17176_ = -(_e7394);
                                                } else {
                                                    phi_17176_ = _e7394;
                                                }
                                                let _e7453 = phi_17176_;
                                                if (_e7418 < 0f) {
                                                    phi_17182_ = -(_e7418);
                                                } else {
                                                    phi_17182_ = _e7418;
                                                }
                                                let _e7457 = phi_17182_;
                                                if (_e7402 < 0f) {
                                                    phi_17191_ = -(_e7402);
                                                } else {
                                                    phi_17191_ = _e7402;
                                                }
                                                let _e7464 = phi_17191_;
                                                if (_e7426 < 0f) {
                                                    phi_17197_ = -(_e7426);
                                                } else {
                                                    phi_17197_ = _e7426;
                                                }
                                                let _e7468 = phi_17197_;
                                                phi_17203_ = type_29(array<f32, 4>(_e7384, _e7389, _e7394, _e7402), array<f32, 4>(_e7408, _e7413, _e7418, _e7426), array<f32, 4>((_e7379 + ((_e7431 + _e7435) * _e7374)), (_e7379 + ((_e7442 + _e7446) * _e7374)), (_e7379 + ((_e7453 + _e7457) * _e7374)), (_e7379 + ((_e7464 + _e7468) * _e7374))));
                                                phi_17204_ = false;
                                            } else {
                                                phi_17203_ = type_29();
                                                phi_17204_ = true;
                                            }
                                            let _e7475 = phi_17203_;
                                            let _e7477 = phi_17204_;
                                            phi_17205_ = _e7475;
                                            phi_17206_ = _e7477;
                                        } else {
                                            phi_17205_ = type_29();
                                            phi_17206_ = true;
                                        }
                                        let _e7479 = phi_17205_;
                                        let _e7481 = phi_17206_;
                                        if _e7481 {
                                            phi_17214_ = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        } else {
                                            phi_17214_ = _e7479;
                                        }
                                        let _e7483 = phi_17214_;
                                        local_10 = type_29(array<f32, 4>(_e7483.member[0], _e7483.member[1], _e7483.member[2], _e7483.member[3]), array<f32, 4>(_e7483.member_1[0], _e7483.member_1[1], _e7483.member_1[2], _e7483.member_1[3]), array<f32, 4>(_e7483.member_2[0], _e7483.member_2[1], _e7483.member_2[2], _e7483.member_2[3]));
                                        let _e7505 = local_10.member[0u];
                                        let _e7508 = local_10.member_1[0u];
                                        let _e7511 = local_10.member[0u];
                                        let _e7517 = local_10.member_2[0u];
                                        if (((_e7505 + ((_e7508 - _e7511) * _e5604)) - _e7517) > 0f) {
                                            let _e7522 = local_10.member[1u];
                                            let _e7525 = local_10.member_1[1u];
                                            let _e7528 = local_10.member[1u];
                                            let _e7534 = local_10.member_2[1u];
                                            if (((_e7522 + ((_e7525 - _e7528) * _e5604)) - _e7534) > 0f) {
                                                let _e7539 = local_10.member[2u];
                                                let _e7542 = local_10.member_1[2u];
                                                let _e7545 = local_10.member[2u];
                                                let _e7551 = local_10.member_2[2u];
                                                if (((_e7539 + ((_e7542 - _e7545) * _e5604)) - _e7551) > 0f) {
                                                    let _e7556 = local_10.member[3u];
                                                    let _e7559 = local_10.member_1[3u];
                                                    let _e7562 = local_10.member[3u];
                                                    let _e7568 = local_10.member_2[3u];
                                                    phi_17383_ = (((_e7556 + ((_e7559 - _e7562) * _e5604)) - _e7568) > 0f);
                                                    phi_17384_ = false;
                                                } else {
                                                    phi_17383_ = bool();
                                                    phi_17384_ = true;
                                                }
                                                let _e7572 = phi_17383_;
                                                let _e7574 = phi_17384_;
                                                phi_17385_ = _e7572;
                                                phi_17386_ = _e7574;
                                            } else {
                                                phi_17385_ = bool();
                                                phi_17386_ = true;
                                            }
                                            let _e7576 = phi_17385_;
                                            let _e7578 = phi_17386_;
                                            phi_17387_ = _e7576;
                                            phi_17388_ = _e7578;
                                        } else {
                                            phi_17387_ = bool();
                                            phi_17388_ = true;
                                        }
                                        let _e7580 = phi_17387_;
                                        let _e7582 = phi_17388_;
                                        if _e7582 {
                                            phi_17392_ = false;
                                        } else {
                                            phi_17392_ = _e7580;
                                        }
                                        let _e7584 = phi_17392_;
                                        if _e7584 {
                                            phi_17843_ = bool();
                                        } else {
                                            if (_e6713[2] < 0f) {
                                                phi_17432_ = -(_e6713[2]);
                                            } else {
                                                phi_17432_ = _e6713[2];
                                            }
                                            let _e7590 = phi_17432_;
                                            let _e7591 = ((0f + 0f) + _e7590);
                                            if (_e7591 > 0f) {
                                                if ((bitcast<u32>(_e7591) & 2139095040u) != 2139095040u) {
                                                    let _e7596 = (1f / _e7591);
                                                    let _e7597 = (0f * _e7596);
                                                    let _e7598 = (0f * _e7596);
                                                    let _e7599 = (_e6713[2] * _e7596);
                                                    let _e7604 = (((_e7597 * _e7597) + (_e7598 * _e7598)) + (_e7599 * _e7599));
                                                    if (_e7604 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e7604 > 0f) {
                                                            phi_17466_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_17466_ = 0f;
                                                        }
                                                        let _e7657 = phi_17466_;
                                                        phi_17530_ = _e7657;
                                                    } else {
                                                        phi_17473_ = type_14(0i, 5i);
                                                        phi_17476_ = bitcast<f32>(((bitcast<u32>(_e7604) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e7612 = phi_17473_;
                                                            let _e7614 = phi_17476_;
                                                            local_88 = _e7614;
                                                            if (_e7612.member < _e7612.member_1) {
                                                                let _e7621 = (_e7612.member + 1i);
                                                                if ((false == (_e7621 > _e7612.member)) != false) {
                                                                    phi_17497_ = true;
                                                                } else {
                                                                    phi_17497_ = false;
                                                                }
                                                                let _e7626 = phi_17497_;
                                                                if _e7626 {
                                                                    phi_17503_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_17503_ = type_15(1u, _e7621);
                                                                }
                                                                let _e7631 = phi_17503_;
                                                                phi_17474_ = type_14(_e7631.member_1, _e7612.member_1);
                                                                phi_17517_ = type_15(1u, _e7612.member);
                                                            } else {
                                                                phi_17474_ = _e7612;
                                                                phi_17517_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e7637 = phi_17474_;
                                                            let _e7639 = phi_17517_;
                                                            let _e7642 = (bitcast<i32>(_e7639.member) != 0i);
                                                            if _e7642 {
                                                                phi_17477_ = (0.5f * (_e7614 + (_e7604 / _e7614)));
                                                            } else {
                                                                phi_17477_ = f32();
                                                            }
                                                            let _e7647 = phi_17477_;
                                                            continue;
                                                            continuing {
                                                                phi_17473_ = _e7637;
                                                                phi_17476_ = _e7647;
                                                                break if !(_e7642);
                                                            }
                                                        }
                                                        let _e7652 = local_88;
                                                        phi_17530_ = (_e7652 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e7659 = phi_17530_;
                                                    let _e7660 = (0.000000059604645f * 12f);
                                                    let _e7665 = ((_e6646 * 1.01f) + ((0f * _e7659) * (1f + _e7660)));
                                                    let _e7670 = (((_e7597 * _e6413[0]) + (_e7598 * _e6413[1])) + (_e7599 * _e6413[2]));
                                                    let _e7675 = (((_e7597 * _e6430) + (_e7598 * _e6431)) + (_e7599 * _e6432));
                                                    let _e7680 = (((_e7597 * _e6440) + (_e7598 * _e6441)) + (_e7599 * _e6442));
                                                    let _e7688 = (((_e7597 * _e6439[0]) + (_e7598 * _e6439[1])) + (_e7599 * _e6439[2]));
                                                    let _e7694 = (((_e7597 * _e6445[0]) + (_e7598 * _e6445[1])) + (_e7599 * _e6445[2]));
                                                    let _e7699 = (((_e7597 * _e6462) + (_e7598 * _e6463)) + (_e7599 * _e6464));
                                                    let _e7704 = (((_e7597 * _e6472) + (_e7598 * _e6473)) + (_e7599 * _e6474));
                                                    let _e7712 = (((_e7597 * _e6471[0]) + (_e7598 * _e6471[1])) + (_e7599 * _e6471[2]));
                                                    if (_e7670 < 0f) {
                                                        phi_17596_ = -(_e7670);
                                                    } else {
                                                        phi_17596_ = _e7670;
                                                    }
                                                    let _e7717 = phi_17596_;
                                                    if (_e7694 < 0f) {
                                                        phi_17602_ = -(_e7694);
                                                    } else {
                                                        phi_17602_ = _e7694;
                                                    }
                                                    let _e7721 = phi_17602_;
                                                    if (_e7675 < 0f) {
                                                        phi_17611_ = -(_e7675);
                                                    } else {
                                                        phi_17611_ = _e7675;
                                                    }
                                                    let _e7728 = phi_17611_;
                                                    if (_e7699 < 0f) {
                                                        phi_17617_ = -(_e7699);
                                                    } else {
                                                        phi_17617_ = _e7699;
                                                    }
                                                    let _e7732 = phi_17617_;
                                                    if (_e7680 < 0f) {
                                                        phi_17626_ = -(_e7680);
                                                    } else {
                                                        phi_17626_ = _e7680;
                                                    }
                                                    let _e7739 = phi_17626_;
                                                    if (_e7704 < 0f) {
                                                        phi_17632_ = -(_e7704);
                                                    } else {
                                                        phi_17632_ = _e7704;
                                                    }
                                                    let _e7743 = phi_17632_;
                                                    if (_e7688 < 0f) {
                                                        phi_17641_ = -(_e7688);
                                                    } else {
                                                        phi_17641_ = _e7688;
                                                    }
                                                    let _e7750 = phi_17641_;
                                                    if (_e7712 < 0f) {
                                                        phi_17647_ = -(_e7712);
                                                    } else {
                                                        phi_17647_ = _e7712;
                                                    }
                                                    let _e7754 = phi_17647_;
                                                    phi_17653_ = type_29(array<f32, 4>(_e7670, _e7675, _e7680, _e7688), array<f32, 4>(_e7694, _e7699, _e7704, _e7712), array<f32, 4>((_e7665 + ((_e7717 + _e7721) * _e7660)), (_e7665 + ((_e7728 + _e7732) * _e7660)), (_e7665 + ((_e7739 + _e7743) * _e7660)), (_e7665 + ((_e7750 + _e7754) * _e7660))));
                                                    phi_17654_ = false;
                                                } else {
                                                    phi_17653_ = type_29();
                                                    phi_17654_ = true;
                                                }
                                                let _e7761 = phi_17653_;
                                                let _e7763 = phi_17654_;
                                                phi_17655_ = _e7761;
                                                phi_17656_ = _e7763;
                                            } else {
                                                phi_17655_ = type_29();
                                                phi_17656_ = true;
                                            }
                                            let _e7765 = phi_17655_;
                                            let _e7767 = phi_17656_;
                                            if _e7767 {
                                                phi_17664_ = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            } else {
                                                phi_17664_ = _e7765;
                                            }
                                            let _e7769 = phi_17664_;
                                            local_11 = type_29(array<f32, 4>(_e7769.member[0], _e7769.member[1], _e7769.member[2], _e7769.member[3]), array<f32, 4>(_e7769.member_1[0], _e7769.member_1[1], _e7769.member_1[2], _e7769.member_1[3]), array<f32, 4>(_e7769.member_2[0], _e7769.member_2[1], _e7769.member_2[2], _e7769.member_2[3]));
                                            let _e7791 = local_11.member[0u];
                                            let _e7794 = local_11.member_1[0u];
                                            let _e7797 = local_11.member[0u];
                                            let _e7803 = local_11.member_2[0u];
                                            if (((_e7791 + ((_e7794 - _e7797) * _e5604)) - _e7803) > 0f) {
                                                let _e7808 = local_11.member[1u];
                                                let _e7811 = local_11.member_1[1u];
                                                let _e7814 = local_11.member[1u];
                                                let _e7820 = local_11.member_2[1u];
                                                if (((_e7808 + ((_e7811 - _e7814) * _e5604)) - _e7820) > 0f) {
                                                    let _e7825 = local_11.member[2u];
                                                    let _e7828 = local_11.member_1[2u];
                                                    let _e7831 = local_11.member[2u];
                                                    let _e7837 = local_11.member_2[2u];
                                                    if (((_e7825 + ((_e7828 - _e7831) * _e5604)) - _e7837) > 0f) {
                                                        let _e7842 = local_11.member[3u];
                                                        let _e7845 = local_11.member_1[3u];
                                                        let _e7848 = local_11.member[3u];
                                                        let _e7854 = local_11.member_2[3u];
                                                        phi_17833_ = (((_e7842 + ((_e7845 - _e7848) * _e5604)) - _e7854) > 0f);
                                                        phi_17834_ = false;
                                                    } else {
                                                        phi_17833_ = bool();
                                                        phi_17834_ = true;
                                                    }
                                                    let _e7858 = phi_17833_;
                                                    let _e7860 = phi_17834_;
                                                    phi_17835_ = _e7858;
                                                    phi_17836_ = _e7860;
                                                } else {
                                                    phi_17835_ = bool();
                                                    phi_17836_ = true;
                                                }
                                                let _e7862 = phi_17835_;
                                                let _e7864 = phi_17836_;
                                                phi_17837_ = _e7862;
                                                phi_17838_ = _e7864;
                                            } else {
                                                phi_17837_ = bool();
                                                phi_17838_ = true;
                                            }
                                            let _e7866 = phi_17837_;
                                            let _e7868 = phi_17838_;
                                            if _e7868 {
                                                phi_17842_ = false;
                                            } else {
                                                phi_17842_ = _e7866;
                                            }
                                            let _e7870 = phi_17842_;
                                            phi_17843_ = _e7870;
                                        }
                                        let _e7872 = phi_17843_;
                                        phi_17844_ = _e7872;
                                        phi_17845_ = _e7584;
                                    }
                                    let _e7874 = phi_17844_;
                                    let _e7876 = phi_17845_;
                                    phi_17846_ = _e7874;
                                    phi_17847_ = _e7876;
                                }
                                let _e7878 = phi_17846_;
                                let _e7880 = phi_17847_;
                                if _e7880 {
                                    phi_17851_ = true;
                                } else {
                                    phi_17851_ = _e7878;
                                }
                                let _e7882 = phi_17851_;
                                if !(_e7882) {
                                    phi_17857_ = type_44(2u, _e5604);
                                    phi_17858_ = false;
                                } else {
                                    phi_17857_ = type_44();
                                    phi_17858_ = true;
                                }
                                let _e7886 = phi_17857_;
                                let _e7888 = phi_17858_;
                                phi_17859_ = _e7886;
                                phi_17860_ = _e7888;
                            } else {
                                phi_17859_ = type_44();
                                phi_17860_ = true;
                            }
                            let _e7890 = phi_17859_;
                            let _e7892 = phi_17860_;
                            if _e7892 {
                                let _e7898 = ((_e6034 - (3f * _e6011)) * _e6388);
                                let _e7899 = ((_e6057 - _e6034) * _e6388);
                                let _e7900 = (((3f * _e6068) - _e6057) * _e6388);
                                local_6[0u] = 0f;
                                local_6[1u] = 1f;
                                local_6[2u] = 1f;
                                local_6[3u] = 1f;
                                let _e7907 = ((_e7899 * _e7899) - (_e7898 * _e7900));
                                if (_e7907 > 0f) {
                                    if (_e7907 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e7907 > 0f) {
                                            phi_17896_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_17896_ = 0f;
                                        }
                                        let _e7961 = phi_17896_;
                                        phi_17960_ = _e7961;
                                    } else {
                                        phi_17903_ = type_14(0i, 5i);
                                        phi_17906_ = bitcast<f32>(((bitcast<u32>(_e7907) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e7916 = phi_17903_;
                                            let _e7918 = phi_17906_;
                                            local_89 = _e7918;
                                            if (_e7916.member < _e7916.member_1) {
                                                let _e7925 = (_e7916.member + 1i);
                                                if ((false == (_e7925 > _e7916.member)) != false) {
                                                    phi_17927_ = true;
                                                } else {
                                                    phi_17927_ = false;
                                                }
                                                let _e7930 = phi_17927_;
                                                if _e7930 {
                                                    phi_17933_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_17933_ = type_15(1u, _e7925);
                                                }
                                                let _e7935 = phi_17933_;
                                                phi_17904_ = type_14(_e7935.member_1, _e7916.member_1);
                                                phi_17947_ = type_15(1u, _e7916.member);
                                            } else {
                                                phi_17904_ = _e7916;
                                                phi_17947_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e7941 = phi_17904_;
                                            let _e7943 = phi_17947_;
                                            let _e7946 = (bitcast<i32>(_e7943.member) != 0i);
                                            if _e7946 {
                                                phi_17907_ = (0.5f * (_e7918 + (_e7907 / _e7918)));
                                            } else {
                                                phi_17907_ = f32();
                                            }
                                            let _e7951 = phi_17907_;
                                            continue;
                                            continuing {
                                                phi_17903_ = _e7941;
                                                phi_17906_ = _e7951;
                                                break if !(_e7946);
                                            }
                                        }
                                        let _e7956 = local_89;
                                        phi_17960_ = (_e7956 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e7963 = phi_17960_;
                                    if (_e7899 < 0f) {
                                        phi_17966_ = -(_e7963);
                                    } else {
                                        phi_17966_ = _e7963;
                                    }
                                    let _e7967 = phi_17966_;
                                    let _e7969 = -((_e7899 + _e7967));
                                    local_7[0u] = (_e7969 / (_e7969 + _e7900));
                                    local_7[1u] = (_e7898 / (_e7898 + _e7969));
                                    let _e7978 = local_7[1u];
                                    let _e7979 = local_7[0u];
                                    if (_e7978 < _e7979) {
                                        let _e7982 = local_7[1u];
                                        let _e7984 = local_7[0u];
                                        local_7[0u] = _e7982;
                                        local_7[1u] = _e7984;
                                    }
                                    phi_17991_ = type_9(0u, 2u);
                                    phi_17994_ = 1u;
                                    loop {
                                        let _e7988 = phi_17991_;
                                        let _e7990 = phi_17994_;
                                        local_134 = _e7990;
                                        if (_e7988.member < _e7988.member_1) {
                                            phi_17992_ = type_9((_e7988.member + 1u), _e7988.member_1);
                                            phi_18017_ = type_9(1u, _e7988.member);
                                        } else {
                                            phi_17992_ = _e7988;
                                            phi_18017_ = type_9(0u, type_9().member_1);
                                        }
                                        let _e8002 = phi_17992_;
                                        let _e8004 = phi_18017_;
                                        let _e8008 = (bitcast<i32>(_e8004.member) != 0i);
                                        if _e8008 {
                                            let _e8010 = local_7[_e8004.member_1];
                                            if (_e8010 > 0f) {
                                                let _e8013 = local_7[_e8004.member_1];
                                                if (_e8013 < 1f) {
                                                    let _e8016 = local_7[_e8004.member_1];
                                                    local_6[_e7990] = _e8016;
                                                    phi_18061_ = (_e7990 + 1u);
                                                } else {
                                                    phi_18061_ = _e7990;
                                                }
                                                let _e8020 = phi_18061_;
                                                phi_18062_ = _e8020;
                                            } else {
                                                phi_18062_ = _e7990;
                                            }
                                            let _e8022 = phi_18062_;
                                            phi_17995_ = _e8022;
                                        } else {
                                            phi_17995_ = u32();
                                        }
                                        let _e8024 = phi_17995_;
                                        continue;
                                        continuing {
                                            phi_17991_ = _e8002;
                                            phi_17994_ = _e8024;
                                            break if !(_e8008);
                                        }
                                    }
                                    let _e16184 = local_134;
                                    phi_18063_ = _e16184;
                                } else {
                                    phi_18063_ = 1u;
                                }
                                let _e8027 = phi_18063_;
                                local_6[_e8027] = 1f;
                                let _e8029 = local_6;
                                local_12 = _e8029;
                                phi_18083_ = type_9(0u, _e8027);
                                loop {
                                    let _e8032 = phi_18083_;
                                    if (_e8032.member < _e8032.member_1) {
                                        phi_18084_ = type_9((_e8032.member + 1u), _e8032.member_1);
                                        phi_18107_ = type_9(1u, _e8032.member);
                                    } else {
                                        phi_18084_ = _e8032;
                                        phi_18107_ = type_9(0u, type_9().member_1);
                                    }
                                    let _e8044 = phi_18084_;
                                    let _e8046 = phi_18107_;
                                    if (bitcast<i32>(_e8046.member) != 0i) {
                                        let _e8052 = local_12[_e8046.member_1];
                                        if (_e8052 > _e5604) {
                                            phi_18126_ = _e8052;
                                        } else {
                                            phi_18126_ = _e5604;
                                        }
                                        let _e8055 = phi_18126_;
                                        let _e8058 = local_12[(_e8046.member_1 + 1u)];
                                        if (_e8058 < _e5606) {
                                            phi_18139_ = _e8058;
                                        } else {
                                            phi_18139_ = _e5606;
                                        }
                                        let _e8061 = phi_18139_;
                                        if (_e8055 <= _e8061) {
                                            let _e8063 = (1f - _e8055);
                                            let _e8074 = ((((_e6011 * _e8063) + (_e6034 * _e8055)) * (_e8063 * _e8063)) + (((_e6057 * _e8063) + (_e6068 * _e8055)) * (_e8055 * _e8055)));
                                            let _e8075 = (1f - _e8061);
                                            let _e8086 = ((((_e6011 * _e8075) + (_e6034 * _e8061)) * (_e8075 * _e8075)) + (((_e6057 * _e8075) + (_e6068 * _e8061)) * (_e8061 * _e8061)));
                                            if (_e8074 < 0f) {
                                                phi_18173_ = -(_e8074);
                                            } else {
                                                phi_18173_ = _e8074;
                                            }
                                            let _e8090 = phi_18173_;
                                            let _e8091 = (_e8090 > _e6385);
                                            if (_e8086 < 0f) {
                                                phi_18180_ = -(_e8086);
                                            } else {
                                                phi_18180_ = _e8086;
                                            }
                                            let _e8095 = phi_18180_;
                                            let _e8096 = (_e8095 > _e6385);
                                            if _e8091 {
                                                if _e8096 {
                                                    phi_18191_ = ((_e8074 > 0f) != (_e8086 > 0f));
                                                    phi_18192_ = false;
                                                } else {
                                                    phi_18191_ = bool();
                                                    phi_18192_ = true;
                                                }
                                                let _e8101 = phi_18191_;
                                                let _e8103 = phi_18192_;
                                                phi_18193_ = _e8101;
                                                phi_18194_ = _e8103;
                                            } else {
                                                phi_18193_ = bool();
                                                phi_18194_ = true;
                                            }
                                            let _e8105 = phi_18193_;
                                            let _e8107 = phi_18194_;
                                            if _e8107 {
                                                phi_18198_ = false;
                                            } else {
                                                phi_18198_ = _e8105;
                                            }
                                            let _e8109 = phi_18198_;
                                            if _e8091 {
                                                if _e8096 {
                                                    if _e8109 {
                                                        phi_18209_ = type_47();
                                                    } else {
                                                        phi_18209_ = type_47(1f, 0f, _e8109);
                                                    }
                                                    let _e8112 = phi_18209_;
                                                    phi_18210_ = _e8112;
                                                    phi_18211_ = _e8109;
                                                } else {
                                                    phi_18210_ = type_47();
                                                    phi_18211_ = true;
                                                }
                                                let _e8114 = phi_18210_;
                                                let _e8116 = phi_18211_;
                                                phi_18212_ = _e8114;
                                                phi_18213_ = _e8116;
                                            } else {
                                                phi_18212_ = type_47();
                                                phi_18213_ = true;
                                            }
                                            let _e8118 = phi_18212_;
                                            let _e8120 = phi_18213_;
                                            if _e8120 {
                                                if _e8091 {
                                                    if (_e8074 < 0f) {
                                                        phi_18224_ = -1f;
                                                    } else {
                                                        phi_18224_ = 1f;
                                                    }
                                                    let _e8123 = phi_18224_;
                                                    let _e8126 = (_e6057 - _e6034);
                                                    phi_18234_ = type_9(0u, 64u);
                                                    phi_18237_ = _e8061;
                                                    phi_18239_ = _e8055;
                                                    phi_18241_ = (0.5f * (_e8055 + _e8061));
                                                    loop {
                                                        let _e8132 = phi_18234_;
                                                        let _e8134 = phi_18237_;
                                                        let _e8136 = phi_18239_;
                                                        let _e8138 = phi_18241_;
                                                        local_136 = _e8136;
                                                        if (_e8132.member < _e8132.member_1) {
                                                            phi_18235_ = type_9((_e8132.member + 1u), _e8132.member_1);
                                                            phi_18264_ = type_9(1u, _e8132.member);
                                                        } else {
                                                            phi_18235_ = _e8132;
                                                            phi_18264_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e8150 = phi_18235_;
                                                        let _e8152 = phi_18264_;
                                                        if (bitcast<i32>(_e8152.member) != 0i) {
                                                            let _e8156 = (1f - _e8138);
                                                            let _e8169 = ((_e8123 * ((((_e6011 * _e8156) + (_e6034 * _e8138)) * (_e8156 * _e8156)) + (((_e6057 * _e8156) + (_e6068 * _e8138)) * (_e8138 * _e8138)))) - _e6385);
                                                            if (_e8169 > 0f) {
                                                                phi_18289_ = _e8134;
                                                                phi_18290_ = _e8138;
                                                            } else {
                                                                phi_18289_ = _e8138;
                                                                phi_18290_ = _e8136;
                                                            }
                                                            let _e8172 = phi_18289_;
                                                            let _e8174 = phi_18290_;
                                                            let _e8176 = ((_e8172 - _e8174) > _e6392);
                                                            if _e8176 {
                                                                let _e8177 = (1f - _e8138);
                                                                let _e8189 = (-(_e8169) / (_e8123 * (((((_e6034 - (3f * _e6011)) * _e8177) + (_e8126 * _e8138)) * _e8177) + (((_e8126 * _e8177) + (((3f * _e6068) - _e6057) * _e8138)) * _e8138))));
                                                                if (_e8169 > 0f) {
                                                                    phi_18316_ = (0.5f * _e6392);
                                                                } else {
                                                                    phi_18316_ = -((0.5f * _e6392));
                                                                }
                                                                let _e8195 = phi_18316_;
                                                                let _e8197 = ((_e8138 + _e8189) + _e8195);
                                                                if (_e8197 > _e8174) {
                                                                    if (_e8197 < _e8172) {
                                                                        if (_e8189 < 0f) {
                                                                            phi_18332_ = -(_e8189);
                                                                        } else {
                                                                            phi_18332_ = _e8189;
                                                                        }
                                                                        let _e8203 = phi_18332_;
                                                                        if (_e8203 < (0.5f * (_e8172 - _e8174))) {
                                                                            phi_18339_ = false;
                                                                        } else {
                                                                            phi_18339_ = true;
                                                                        }
                                                                        let _e8208 = phi_18339_;
                                                                        phi_18340_ = _e8208;
                                                                    } else {
                                                                        phi_18340_ = true;
                                                                    }
                                                                    let _e8210 = phi_18340_;
                                                                    phi_18341_ = _e8210;
                                                                } else {
                                                                    phi_18341_ = true;
                                                                }
                                                                let _e8212 = phi_18341_;
                                                                if _e8212 {
                                                                    phi_18347_ = (0.5f * (_e8174 + _e8172));
                                                                } else {
                                                                    phi_18347_ = _e8197;
                                                                }
                                                                let _e8216 = phi_18347_;
                                                                phi_18348_ = _e8216;
                                                                phi_18349_ = false;
                                                            } else {
                                                                phi_18348_ = f32();
                                                                phi_18349_ = true;
                                                            }
                                                            let _e8218 = phi_18348_;
                                                            let _e8220 = phi_18349_;
                                                            phi_18238_ = _e8172;
                                                            phi_18240_ = _e8174;
                                                            phi_18242_ = _e8218;
                                                            phi_18350_ = _e8174;
                                                            phi_18351_ = _e8176;
                                                            phi_18352_ = _e8220;
                                                        } else {
                                                            phi_18238_ = f32();
                                                            phi_18240_ = f32();
                                                            phi_18242_ = f32();
                                                            phi_18350_ = f32();
                                                            phi_18351_ = false;
                                                            phi_18352_ = false;
                                                        }
                                                        let _e8222 = phi_18238_;
                                                        let _e8224 = phi_18240_;
                                                        let _e8226 = phi_18242_;
                                                        let _e8228 = phi_18350_;
                                                        let _e8230 = phi_18351_;
                                                        let _e8232 = phi_18352_;
                                                        local_90 = _e8232;
                                                        local_135 = _e8228;
                                                        continue;
                                                        continuing {
                                                            phi_18234_ = _e8150;
                                                            phi_18237_ = _e8222;
                                                            phi_18239_ = _e8224;
                                                            phi_18241_ = _e8226;
                                                            break if !(_e8230);
                                                        }
                                                    }
                                                    let _e8235 = local_90;
                                                    if _e8235 {
                                                        let _e16228 = local_135;
                                                        phi_18356_ = _e16228;
                                                    } else {
                                                        let _e16230 = local_136;
                                                        phi_18356_ = _e16230;
                                                    }
                                                    let _e8237 = phi_18356_;
                                                    phi_18357_ = _e8237;
                                                } else {
                                                    phi_18357_ = _e8055;
                                                }
                                                let _e8239 = phi_18357_;
                                                if _e8096 {
                                                    if (_e8086 < 0f) {
                                                        phi_18365_ = -1f;
                                                    } else {
                                                        phi_18365_ = 1f;
                                                    }
                                                    let _e8242 = phi_18365_;
                                                    phi_18369_ = type_9(0u, 64u);
                                                    phi_18372_ = (_e6392 + _e6392);
                                                    loop {
                                                        let _e8245 = phi_18369_;
                                                        let _e8247 = phi_18372_;
                                                        if (_e8245.member < _e8245.member_1) {
                                                            phi_18370_ = type_9((_e8245.member + 1u), _e8245.member_1);
                                                            phi_18395_ = type_9(1u, _e8245.member);
                                                        } else {
                                                            phi_18370_ = _e8245;
                                                            phi_18395_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e8259 = phi_18370_;
                                                        let _e8261 = phi_18395_;
                                                        if (bitcast<i32>(_e8261.member) != 0i) {
                                                            let _e8265 = (_e8239 + _e8247);
                                                            if (_e8265 < _e8061) {
                                                                let _e8267 = (1f - _e8265);
                                                                let _e8280 = ((_e8242 * ((((_e6011 * _e8267) + (_e6034 * _e8265)) * (_e8267 * _e8267)) + (((_e6057 * _e8267) + (_e6068 * _e8265)) * (_e8265 * _e8265)))) > _e6385);
                                                                if _e8280 {
                                                                    phi_18425_ = f32();
                                                                    phi_18426_ = false;
                                                                } else {
                                                                    phi_18425_ = (_e8247 + _e8247);
                                                                    phi_18426_ = true;
                                                                }
                                                                let _e8283 = phi_18425_;
                                                                let _e8285 = phi_18426_;
                                                                phi_18427_ = _e8283;
                                                                phi_18428_ = _e8285;
                                                                phi_18429_ = _e8280;
                                                                phi_18430_ = false;
                                                            } else {
                                                                phi_18427_ = f32();
                                                                phi_18428_ = false;
                                                                phi_18429_ = false;
                                                                phi_18430_ = true;
                                                            }
                                                            let _e8287 = phi_18427_;
                                                            let _e8289 = phi_18428_;
                                                            let _e8291 = phi_18429_;
                                                            let _e8293 = phi_18430_;
                                                            phi_18431_ = _e8265;
                                                            phi_18373_ = _e8287;
                                                            phi_18432_ = _e8289;
                                                            phi_18433_ = _e8291;
                                                            phi_18434_ = _e8293;
                                                            phi_18435_ = false;
                                                        } else {
                                                            phi_18431_ = f32();
                                                            phi_18373_ = f32();
                                                            phi_18432_ = false;
                                                            phi_18433_ = false;
                                                            phi_18434_ = false;
                                                            phi_18435_ = true;
                                                        }
                                                        let _e8295 = phi_18431_;
                                                        let _e8297 = phi_18373_;
                                                        let _e8299 = phi_18432_;
                                                        let _e8301 = phi_18433_;
                                                        let _e8303 = phi_18434_;
                                                        let _e8305 = phi_18435_;
                                                        local_91 = _e8301;
                                                        local_137 = _e8303;
                                                        local_138 = _e8305;
                                                        local_139 = _e8295;
                                                        continue;
                                                        continuing {
                                                            phi_18369_ = _e8259;
                                                            phi_18372_ = _e8297;
                                                            break if !(_e8299);
                                                        }
                                                    }
                                                    let _e8308 = local_91;
                                                    if _e8308 {
                                                        phi_18439_ = false;
                                                        phi_18440_ = false;
                                                    } else {
                                                        let _e16252 = local_137;
                                                        phi_18439_ = _e16252;
                                                        let _e16255 = local_138;
                                                        phi_18440_ = _e16255;
                                                    }
                                                    let _e8310 = phi_18439_;
                                                    let _e8312 = phi_18440_;
                                                    if _e8310 {
                                                        phi_18444_ = true;
                                                    } else {
                                                        phi_18444_ = _e8312;
                                                    }
                                                    let _e8314 = phi_18444_;
                                                    if _e8314 {
                                                        phi_18448_ = _e8061;
                                                    } else {
                                                        let _e16259 = local_139;
                                                        phi_18448_ = _e16259;
                                                    }
                                                    let _e8316 = phi_18448_;
                                                    phi_18449_ = _e8316;
                                                } else {
                                                    phi_18449_ = _e8061;
                                                }
                                                let _e8318 = phi_18449_;
                                                phi_18451_ = type_47(_e8239, _e8318, _e8109);
                                            } else {
                                                phi_18451_ = _e8118;
                                            }
                                            let _e8321 = phi_18451_;
                                            if (_e8321.member > _e8321.member_1) {
                                                phi_22244_ = bool();
                                                phi_22245_ = f32();
                                                phi_22246_ = f32();
                                                phi_22247_ = true;
                                                phi_22248_ = false;
                                                phi_22249_ = false;
                                                phi_22250_ = false;
                                            } else {
                                                let _e8328 = ((_e8321.member_1 - _e8321.member) * 0.5f);
                                                let _e8329 = (_e8321.member + _e8328);
                                                let _e8331 = (_e8328 + (0.000000059604645f * 4f));
                                                let _e8333 = local_18.member_3;
                                                let _e8336 = local_18.member[0u];
                                                if (_e8336[0] < 0f) {
                                                    phi_18480_ = -(_e8336[0]);
                                                } else {
                                                    phi_18480_ = _e8336[0];
                                                }
                                                let _e8343 = phi_18480_;
                                                if (_e8336[1] < 0f) {
                                                    phi_18487_ = -(_e8336[1]);
                                                } else {
                                                    phi_18487_ = _e8336[1];
                                                }
                                                let _e8347 = phi_18487_;
                                                if (_e8343 > _e8347) {
                                                    phi_18492_ = _e8343;
                                                } else {
                                                    phi_18492_ = _e8347;
                                                }
                                                let _e8350 = phi_18492_;
                                                if (_e8336[2] < 0f) {
                                                    phi_18499_ = -(_e8336[2]);
                                                } else {
                                                    phi_18499_ = _e8336[2];
                                                }
                                                let _e8354 = phi_18499_;
                                                if (_e8350 > _e8354) {
                                                    phi_18504_ = _e8350;
                                                } else {
                                                    phi_18504_ = _e8354;
                                                }
                                                let _e8357 = phi_18504_;
                                                let _e8359 = local_18.member[1u];
                                                if (_e8359[0] < 0f) {
                                                    phi_18517_ = -(_e8359[0]);
                                                } else {
                                                    phi_18517_ = _e8359[0];
                                                }
                                                let _e8366 = phi_18517_;
                                                if (_e8359[1] < 0f) {
                                                    phi_18524_ = -(_e8359[1]);
                                                } else {
                                                    phi_18524_ = _e8359[1];
                                                }
                                                let _e8370 = phi_18524_;
                                                if (_e8366 > _e8370) {
                                                    phi_18529_ = _e8366;
                                                } else {
                                                    phi_18529_ = _e8370;
                                                }
                                                let _e8373 = phi_18529_;
                                                if (_e8359[2] < 0f) {
                                                    phi_18536_ = -(_e8359[2]);
                                                } else {
                                                    phi_18536_ = _e8359[2];
                                                }
                                                let _e8377 = phi_18536_;
                                                if (_e8373 > _e8377) {
                                                    phi_18541_ = _e8373;
                                                } else {
                                                    phi_18541_ = _e8377;
                                                }
                                                let _e8380 = phi_18541_;
                                                if (_e8357 > _e8380) {
                                                    phi_18546_ = _e8357;
                                                } else {
                                                    phi_18546_ = _e8380;
                                                }
                                                let _e8383 = phi_18546_;
                                                let _e8386 = local_18.member[0u];
                                                let _e8391 = local_18.member[1u];
                                                let _e8401 = (_e8386[0] + ((_e8391[0] - _e8386[0]) * _e8329));
                                                let _e8402 = (_e8386[1] + ((_e8391[1] - _e8386[1]) * _e8329));
                                                let _e8403 = (_e8386[2] + ((_e8391[2] - _e8386[2]) * _e8329));
                                                let _e8405 = local_18.member[1u];
                                                let _e8410 = local_18.member[0u];
                                                let _e8414 = (_e8405[0] - _e8410[0]);
                                                let _e8415 = (_e8405[1] - _e8410[1]);
                                                let _e8416 = (_e8405[2] - _e8410[2]);
                                                if (_e8414 < 0f) {
                                                    phi_18605_ = -(_e8414);
                                                } else {
                                                    phi_18605_ = _e8414;
                                                }
                                                let _e8420 = phi_18605_;
                                                if (_e8415 < 0f) {
                                                    phi_18611_ = -(_e8415);
                                                } else {
                                                    phi_18611_ = _e8415;
                                                }
                                                let _e8424 = phi_18611_;
                                                if (_e8420 > _e8424) {
                                                    phi_18616_ = _e8420;
                                                } else {
                                                    phi_18616_ = _e8424;
                                                }
                                                let _e8427 = phi_18616_;
                                                if (_e8416 < 0f) {
                                                    phi_18622_ = -(_e8416);
                                                } else {
                                                    phi_18622_ = _e8416;
                                                }
                                                let _e8431 = phi_18622_;
                                                if (_e8427 > _e8431) {
                                                    phi_18627_ = _e8427;
                                                } else {
                                                    phi_18627_ = _e8431;
                                                }
                                                let _e8434 = phi_18627_;
                                                let _e8440 = ((((_e8331 * _e8434) * 1.01f) + ((_e8383 + _e8333) * (0.000000059604645f * 8f))) + _e8333);
                                                if (_e8401 < 0f) {
                                                    phi_18639_ = -(_e8401);
                                                } else {
                                                    phi_18639_ = _e8401;
                                                }
                                                let _e8444 = phi_18639_;
                                                if (_e8402 < 0f) {
                                                    phi_18645_ = -(_e8402);
                                                } else {
                                                    phi_18645_ = _e8402;
                                                }
                                                let _e8448 = phi_18645_;
                                                if (_e8444 > _e8448) {
                                                    phi_18650_ = _e8444;
                                                } else {
                                                    phi_18650_ = _e8448;
                                                }
                                                let _e8451 = phi_18650_;
                                                if (_e8403 < 0f) {
                                                    phi_18656_ = -(_e8403);
                                                } else {
                                                    phi_18656_ = _e8403;
                                                }
                                                let _e8455 = phi_18656_;
                                                if (_e8451 > _e8455) {
                                                    phi_18661_ = _e8451;
                                                } else {
                                                    phi_18661_ = _e8455;
                                                }
                                                let _e8458 = phi_18661_;
                                                local_2 = type_24(array<f32, 3>(_e8401, _e8402, _e8403), _e8440, (_e8458 + _e8440));
                                                let _e8464 = local_18.member_3;
                                                let _e8466 = local_18.member_1[0u];
                                                if (_e8466[0] < 0f) {
                                                    phi_18687_ = -(_e8466[0]);
                                                } else {
                                                    phi_18687_ = _e8466[0];
                                                }
                                                let _e8473 = phi_18687_;
                                                if (_e8466[1] < 0f) {
                                                    phi_18694_ = -(_e8466[1]);
                                                } else {
                                                    phi_18694_ = _e8466[1];
                                                }
                                                let _e8477 = phi_18694_;
                                                if (_e8473 > _e8477) {
                                                    phi_18699_ = _e8473;
                                                } else {
                                                    phi_18699_ = _e8477;
                                                }
                                                let _e8480 = phi_18699_;
                                                if (_e8466[2] < 0f) {
                                                    phi_18706_ = -(_e8466[2]);
                                                } else {
                                                    phi_18706_ = _e8466[2];
                                                }
                                                let _e8484 = phi_18706_;
                                                if (_e8480 > _e8484) {
                                                    phi_18711_ = _e8480;
                                                } else {
                                                    phi_18711_ = _e8484;
                                                }
                                                let _e8487 = phi_18711_;
                                                let _e8489 = local_18.member_1[1u];
                                                if (_e8489[0] < 0f) {
                                                    phi_18724_ = -(_e8489[0]);
                                                } else {
                                                    phi_18724_ = _e8489[0];
                                                }
                                                let _e8496 = phi_18724_;
                                                if (_e8489[1] < 0f) {
                                                    phi_18731_ = -(_e8489[1]);
                                                } else {
                                                    phi_18731_ = _e8489[1];
                                                }
                                                let _e8500 = phi_18731_;
                                                if (_e8496 > _e8500) {
                                                    phi_18736_ = _e8496;
                                                } else {
                                                    phi_18736_ = _e8500;
                                                }
                                                let _e8503 = phi_18736_;
                                                if (_e8489[2] < 0f) {
                                                    phi_18743_ = -(_e8489[2]);
                                                } else {
                                                    phi_18743_ = _e8489[2];
                                                }
                                                let _e8507 = phi_18743_;
                                                if (_e8503 > _e8507) {
                                                    phi_18748_ = _e8503;
                                                } else {
                                                    phi_18748_ = _e8507;
                                                }
                                                let _e8510 = phi_18748_;
                                                if (_e8487 > _e8510) {
                                                    phi_18753_ = _e8487;
                                                } else {
                                                    phi_18753_ = _e8510;
                                                }
                                                let _e8513 = phi_18753_;
                                                let _e8516 = local_18.member_1[0u];
                                                let _e8521 = local_18.member_1[1u];
                                                let _e8531 = (_e8516[0] + ((_e8521[0] - _e8516[0]) * _e8329));
                                                let _e8532 = (_e8516[1] + ((_e8521[1] - _e8516[1]) * _e8329));
                                                let _e8533 = (_e8516[2] + ((_e8521[2] - _e8516[2]) * _e8329));
                                                let _e8535 = local_18.member_1[1u];
                                                let _e8540 = local_18.member_1[0u];
                                                let _e8544 = (_e8535[0] - _e8540[0]);
                                                let _e8545 = (_e8535[1] - _e8540[1]);
                                                let _e8546 = (_e8535[2] - _e8540[2]);
                                                if (_e8544 < 0f) {
                                                    phi_18812_ = -(_e8544);
                                                } else {
                                                    phi_18812_ = _e8544;
                                                }
                                                let _e8550 = phi_18812_;
                                                if (_e8545 < 0f) {
                                                    phi_18818_ = -(_e8545);
                                                } else {
                                                    phi_18818_ = _e8545;
                                                }
                                                let _e8554 = phi_18818_;
                                                if (_e8550 > _e8554) {
                                                    phi_18823_ = _e8550;
                                                } else {
                                                    phi_18823_ = _e8554;
                                                }
                                                let _e8557 = phi_18823_;
                                                if (_e8546 < 0f) {
                                                    phi_18829_ = -(_e8546);
                                                } else {
                                                    phi_18829_ = _e8546;
                                                }
                                                let _e8561 = phi_18829_;
                                                if (_e8557 > _e8561) {
                                                    phi_18834_ = _e8557;
                                                } else {
                                                    phi_18834_ = _e8561;
                                                }
                                                let _e8564 = phi_18834_;
                                                let _e8570 = ((((_e8331 * _e8564) * 1.01f) + ((_e8513 + _e8464) * (0.000000059604645f * 8f))) + _e8464);
                                                if (_e8531 < 0f) {
                                                    phi_18846_ = -(_e8531);
                                                } else {
                                                    phi_18846_ = _e8531;
                                                }
                                                let _e8574 = phi_18846_;
                                                if (_e8532 < 0f) {
                                                    phi_18852_ = -(_e8532);
                                                } else {
                                                    phi_18852_ = _e8532;
                                                }
                                                let _e8578 = phi_18852_;
                                                if (_e8574 > _e8578) {
                                                    phi_18857_ = _e8574;
                                                } else {
                                                    phi_18857_ = _e8578;
                                                }
                                                let _e8581 = phi_18857_;
                                                if (_e8533 < 0f) {
                                                    phi_18863_ = -(_e8533);
                                                } else {
                                                    phi_18863_ = _e8533;
                                                }
                                                let _e8585 = phi_18863_;
                                                if (_e8581 > _e8585) {
                                                    phi_18868_ = _e8581;
                                                } else {
                                                    phi_18868_ = _e8585;
                                                }
                                                let _e8588 = phi_18868_;
                                                local_3 = type_24(array<f32, 3>(_e8531, _e8532, _e8533), _e8570, (_e8588 + _e8570));
                                                let _e8594 = local_18.member_3;
                                                let _e8596 = local_18.member_2[0u];
                                                if (_e8596[0] < 0f) {
                                                    phi_18894_ = -(_e8596[0]);
                                                } else {
                                                    phi_18894_ = _e8596[0];
                                                }
                                                let _e8603 = phi_18894_;
                                                if (_e8596[1] < 0f) {
                                                    phi_18901_ = -(_e8596[1]);
                                                } else {
                                                    phi_18901_ = _e8596[1];
                                                }
                                                let _e8607 = phi_18901_;
                                                if (_e8603 > _e8607) {
                                                    phi_18906_ = _e8603;
                                                } else {
                                                    phi_18906_ = _e8607;
                                                }
                                                let _e8610 = phi_18906_;
                                                if (_e8596[2] < 0f) {
                                                    phi_18913_ = -(_e8596[2]);
                                                } else {
                                                    phi_18913_ = _e8596[2];
                                                }
                                                let _e8614 = phi_18913_;
                                                if (_e8610 > _e8614) {
                                                    phi_18918_ = _e8610;
                                                } else {
                                                    phi_18918_ = _e8614;
                                                }
                                                let _e8617 = phi_18918_;
                                                let _e8619 = local_18.member_2[1u];
                                                if (_e8619[0] < 0f) {
                                                    phi_18931_ = -(_e8619[0]);
                                                } else {
                                                    phi_18931_ = _e8619[0];
                                                }
                                                let _e8626 = phi_18931_;
                                                if (_e8619[1] < 0f) {
                                                    phi_18938_ = -(_e8619[1]);
                                                } else {
                                                    phi_18938_ = _e8619[1];
                                                }
                                                let _e8630 = phi_18938_;
                                                if (_e8626 > _e8630) {
                                                    phi_18943_ = _e8626;
                                                } else {
                                                    phi_18943_ = _e8630;
                                                }
                                                let _e8633 = phi_18943_;
                                                if (_e8619[2] < 0f) {
                                                    phi_18950_ = -(_e8619[2]);
                                                } else {
                                                    phi_18950_ = _e8619[2];
                                                }
                                                let _e8637 = phi_18950_;
                                                if (_e8633 > _e8637) {
                                                    phi_18955_ = _e8633;
                                                } else {
                                                    phi_18955_ = _e8637;
                                                }
                                                let _e8640 = phi_18955_;
                                                if (_e8617 > _e8640) {
                                                    phi_18960_ = _e8617;
                                                } else {
                                                    phi_18960_ = _e8640;
                                                }
                                                let _e8643 = phi_18960_;
                                                let _e8646 = local_18.member_2[0u];
                                                let _e8651 = local_18.member_2[1u];
                                                let _e8661 = (_e8646[0] + ((_e8651[0] - _e8646[0]) * _e8329));
                                                let _e8662 = (_e8646[1] + ((_e8651[1] - _e8646[1]) * _e8329));
                                                let _e8663 = (_e8646[2] + ((_e8651[2] - _e8646[2]) * _e8329));
                                                let _e8665 = local_18.member_2[1u];
                                                let _e8670 = local_18.member_2[0u];
                                                let _e8674 = (_e8665[0] - _e8670[0]);
                                                let _e8675 = (_e8665[1] - _e8670[1]);
                                                let _e8676 = (_e8665[2] - _e8670[2]);
                                                if (_e8674 < 0f) {
                                                    phi_19019_ = -(_e8674);
                                                } else {
                                                    phi_19019_ = _e8674;
                                                }
                                                let _e8680 = phi_19019_;
                                                if (_e8675 < 0f) {
                                                    phi_19025_ = -(_e8675);
                                                } else {
                                                    phi_19025_ = _e8675;
                                                }
                                                let _e8684 = phi_19025_;
                                                if (_e8680 > _e8684) {
                                                    phi_19030_ = _e8680;
                                                } else {
                                                    phi_19030_ = _e8684;
                                                }
                                                let _e8687 = phi_19030_;
                                                if (_e8676 < 0f) {
                                                    phi_19036_ = -(_e8676);
                                                } else {
                                                    phi_19036_ = _e8676;
                                                }
                                                let _e8691 = phi_19036_;
                                                if (_e8687 > _e8691) {
                                                    phi_19041_ = _e8687;
                                                } else {
                                                    phi_19041_ = _e8691;
                                                }
                                                let _e8694 = phi_19041_;
                                                let _e8700 = ((((_e8331 * _e8694) * 1.01f) + ((_e8643 + _e8594) * (0.000000059604645f * 8f))) + _e8594);
                                                if (_e8661 < 0f) {
                                                    phi_19053_ = -(_e8661);
                                                } else {
                                                    phi_19053_ = _e8661;
                                                }
                                                let _e8704 = phi_19053_;
                                                if (_e8662 < 0f) {
                                                    phi_19059_ = -(_e8662);
                                                } else {
                                                    phi_19059_ = _e8662;
                                                }
                                                let _e8708 = phi_19059_;
                                                if (_e8704 > _e8708) {
                                                    phi_19064_ = _e8704;
                                                } else {
                                                    phi_19064_ = _e8708;
                                                }
                                                let _e8711 = phi_19064_;
                                                if (_e8663 < 0f) {
                                                    phi_19070_ = -(_e8663);
                                                } else {
                                                    phi_19070_ = _e8663;
                                                }
                                                let _e8715 = phi_19070_;
                                                if (_e8711 > _e8715) {
                                                    phi_19075_ = _e8711;
                                                } else {
                                                    phi_19075_ = _e8715;
                                                }
                                                let _e8718 = phi_19075_;
                                                local_4 = type_24(array<f32, 3>(_e8661, _e8662, _e8663), _e8700, (_e8718 + _e8700));
                                                let _e8723 = local_3.member;
                                                let _e8728 = local_4.member;
                                                let _e8734 = ((_e8723[1] * _e8728[2]) - (_e8723[2] * _e8728[1]));
                                                let _e8737 = ((_e8723[2] * _e8728[0]) - (_e8723[0] * _e8728[2]));
                                                let _e8740 = ((_e8723[0] * _e8728[1]) - (_e8723[1] * _e8728[0]));
                                                if (_e8734 < 0f) {
                                                    phi_19124_ = -(_e8734);
                                                } else {
                                                    phi_19124_ = _e8734;
                                                }
                                                let _e8744 = phi_19124_;
                                                if (_e8737 < 0f) {
                                                    phi_19130_ = -(_e8737);
                                                } else {
                                                    phi_19130_ = _e8737;
                                                }
                                                let _e8748 = phi_19130_;
                                                if (_e8744 > _e8748) {
                                                    if (_e8734 < 0f) {
                                                        phi_19140_ = -(_e8734);
                                                    } else {
                                                        phi_19140_ = _e8734;
                                                    }
                                                    let _e8766 = phi_19140_;
                                                    if (_e8740 < 0f) {
                                                        phi_19146_ = -(_e8740);
                                                    } else {
                                                        phi_19146_ = _e8740;
                                                    }
                                                    let _e8770 = phi_19146_;
                                                    if (_e8766 > _e8770) {
                                                        phi_19151_ = 2u;
                                                        phi_19152_ = 1u;
                                                    } else {
                                                        phi_19151_ = 1u;
                                                        phi_19152_ = 0u;
                                                    }
                                                    let _e8773 = phi_19151_;
                                                    let _e8775 = phi_19152_;
                                                    phi_19171_ = _e8773;
                                                    phi_19172_ = _e8775;
                                                } else {
                                                    if (_e8737 < 0f) {
                                                        phi_19158_ = -(_e8737);
                                                    } else {
                                                        phi_19158_ = _e8737;
                                                    }
                                                    let _e8753 = phi_19158_;
                                                    if (_e8740 < 0f) {
                                                        phi_19164_ = -(_e8740);
                                                    } else {
                                                        phi_19164_ = _e8740;
                                                    }
                                                    let _e8757 = phi_19164_;
                                                    if (_e8753 > _e8757) {
                                                        phi_19169_ = 0u;
                                                        phi_19170_ = 2u;
                                                    } else {
                                                        phi_19169_ = 1u;
                                                        phi_19170_ = 0u;
                                                    }
                                                    let _e8760 = phi_19169_;
                                                    let _e8762 = phi_19170_;
                                                    phi_19171_ = _e8760;
                                                    phi_19172_ = _e8762;
                                                }
                                                let _e8777 = phi_19171_;
                                                let _e8779 = phi_19172_;
                                                let _e8782 = local_3.member[_e8779];
                                                let _e8785 = local_4.member[_e8777];
                                                let _e8789 = local_3.member[_e8777];
                                                let _e8792 = local_4.member[_e8779];
                                                let _e8794 = ((_e8782 * _e8785) - (_e8789 * _e8792));
                                                let _e8796 = local_3.member_1;
                                                let _e8798 = local_4.member_2;
                                                let _e8801 = local_3.member_2;
                                                let _e8803 = local_4.member_1;
                                                let _e8808 = local_3.member_2;
                                                let _e8811 = local_4.member_2;
                                                let _e8819 = local_3.member_2;
                                                let _e8822 = local_4.member_2;
                                                let _e8826 = (((((_e8796 * _e8798) + (_e8801 * _e8803)) * 2.01f) + (((_e8808 * 2f) * (_e8811 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e8819) * (1f + _e8822))));
                                                if (_e8794 < 0f) {
                                                    phi_19241_ = -(_e8794);
                                                } else {
                                                    phi_19241_ = _e8794;
                                                }
                                                let _e8830 = phi_19241_;
                                                if (_e8830 > _e8826) {
                                                    if (_e8794 < 0f) {
                                                        phi_19250_ = -1f;
                                                    } else {
                                                        phi_19250_ = 1f;
                                                    }
                                                    let _e8834 = phi_19250_;
                                                    let _e8837 = local_2.member[_e8779];
                                                    let _e8840 = local_4.member[_e8777];
                                                    let _e8844 = local_2.member[_e8777];
                                                    let _e8847 = local_4.member[_e8779];
                                                    let _e8851 = local_2.member_1;
                                                    let _e8853 = local_4.member_2;
                                                    let _e8856 = local_2.member_2;
                                                    let _e8858 = local_4.member_1;
                                                    let _e8863 = local_2.member_2;
                                                    let _e8866 = local_4.member_2;
                                                    let _e8874 = local_2.member_2;
                                                    let _e8877 = local_4.member_2;
                                                    let _e8881 = (((((_e8851 * _e8853) + (_e8856 * _e8858)) * 2.01f) + (((_e8863 * 2f) * (_e8866 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e8874) * (1f + _e8877))));
                                                    let _e8884 = local_3.member[_e8779];
                                                    let _e8887 = local_2.member[_e8777];
                                                    let _e8891 = local_3.member[_e8777];
                                                    let _e8894 = local_2.member[_e8779];
                                                    let _e8898 = local_3.member_1;
                                                    let _e8900 = local_2.member_2;
                                                    let _e8903 = local_3.member_2;
                                                    let _e8905 = local_2.member_1;
                                                    let _e8910 = local_3.member_2;
                                                    let _e8913 = local_2.member_2;
                                                    let _e8921 = local_3.member_2;
                                                    let _e8924 = local_2.member_2;
                                                    let _e8928 = (((((_e8898 * _e8900) + (_e8903 * _e8905)) * 2.01f) + (((_e8910 * 2f) * (_e8913 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e8921) * (1f + _e8924))));
                                                    let _e8929 = (_e8794 * _e8834);
                                                    let _e8930 = (((_e8837 * _e8840) - (_e8844 * _e8847)) * _e8834);
                                                    let _e8931 = (((_e8884 * _e8887) - (_e8891 * _e8894)) * _e8834);
                                                    if (_e8929 < 0f) {
                                                        phi_19385_ = -(_e8929);
                                                    } else {
                                                        phi_19385_ = _e8929;
                                                    }
                                                    let _e8935 = phi_19385_;
                                                    if (_e8930 < 0f) {
                                                        phi_19391_ = -(_e8930);
                                                    } else {
                                                        phi_19391_ = _e8930;
                                                    }
                                                    let _e8939 = phi_19391_;
                                                    if (_e8931 < 0f) {
                                                        phi_19398_ = -(_e8931);
                                                    } else {
                                                        phi_19398_ = _e8931;
                                                    }
                                                    let _e8944 = phi_19398_;
                                                    let _e8947 = (((_e8935 + _e8939) + _e8944) * (0.000000059604645f * 4f));
                                                    if (_e316.member != 0u) {
                                                        phi_19433_ = array<type_26, 4>(type_26(_e8930, _e8881), type_26(_e8931, _e8928), type_26((_e8929 - _e8930), ((_e8826 + _e8881) + _e8947)), type_26((_e8929 - _e8931), ((_e8826 + _e8928) + _e8947)));
                                                    } else {
                                                        let _e8950 = ((_e8929 - _e8930) - _e8931);
                                                        let _e8953 = (((_e8826 + _e8881) + _e8928) + _e8947);
                                                        phi_19433_ = array<type_26, 4>(type_26(_e8930, _e8881), type_26(_e8931, _e8928), type_26(_e8950, _e8953), type_26(_e8950, _e8953));
                                                    }
                                                    let _e8971 = phi_19433_;
                                                    local_5 = array<type_26, 4>(type_26(_e8971[0].member, _e8971[0].member_1), type_26(_e8971[1].member, _e8971[1].member_1), type_26(_e8971[2].member, _e8971[2].member_1), type_26(_e8971[3].member, _e8971[3].member_1));
                                                    phi_19453_ = type_9(0u, 4u);
                                                    phi_19456_ = true;
                                                    loop {
                                                        let _e8990 = phi_19453_;
                                                        let _e8992 = phi_19456_;
                                                        local_93 = _e8992;
                                                        if (_e8990.member < _e8990.member_1) {
                                                            phi_19454_ = type_9((_e8990.member + 1u), _e8990.member_1);
                                                            phi_19479_ = type_9(1u, _e8990.member);
                                                        } else {
                                                            phi_19454_ = _e8990;
                                                            phi_19479_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e9004 = phi_19454_;
                                                        let _e9006 = phi_19479_;
                                                        if (bitcast<i32>(_e9006.member) != 0i) {
                                                            let _e9013 = local_5[_e9006.member_1].member;
                                                            let _e9016 = local_5[_e9006.member_1].member_1;
                                                            let _e9018 = (_e9013 < -(_e9016));
                                                            if _e9018 {
                                                                phi_19506_ = bool();
                                                                phi_19507_ = false;
                                                            } else {
                                                                phi_19506_ = (_e8992 && (_e9013 > _e9016));
                                                                phi_19507_ = true;
                                                            }
                                                            let _e9022 = phi_19506_;
                                                            let _e9024 = phi_19507_;
                                                            phi_19457_ = _e9022;
                                                            phi_19508_ = _e9024;
                                                            phi_19509_ = _e9018;
                                                        } else {
                                                            phi_19457_ = bool();
                                                            phi_19508_ = false;
                                                            phi_19509_ = false;
                                                        }
                                                        let _e9026 = phi_19457_;
                                                        let _e9028 = phi_19508_;
                                                        let _e9030 = phi_19509_;
                                                        local_92 = _e9030;
                                                        continue;
                                                        continuing {
                                                            phi_19453_ = _e9004;
                                                            phi_19456_ = _e9026;
                                                            break if !(_e9028);
                                                        }
                                                    }
                                                    let _e9033 = local_92;
                                                    if _e9033 {
                                                        phi_19513_ = false;
                                                    } else {
                                                        phi_19513_ = true;
                                                    }
                                                    let _e9035 = phi_19513_;
                                                    if _e9035 {
                                                        let _e9037 = local_93;
                                                        if _e9037 {
                                                            phi_19520_ = 1u;
                                                        } else {
                                                            phi_19520_ = 2u;
                                                        }
                                                        let _e9039 = phi_19520_;
                                                        phi_19521_ = _e9039;
                                                        phi_19522_ = false;
                                                    } else {
                                                        phi_19521_ = u32();
                                                        phi_19522_ = true;
                                                    }
                                                    let _e9041 = phi_19521_;
                                                    let _e9043 = phi_19522_;
                                                    phi_19523_ = _e9041;
                                                    phi_19524_ = 0u;
                                                    phi_19525_ = _e9043;
                                                } else {
                                                    phi_19523_ = u32();
                                                    phi_19524_ = 2u;
                                                    phi_19525_ = true;
                                                }
                                                let _e9045 = phi_19523_;
                                                let _e9047 = phi_19524_;
                                                let _e9049 = phi_19525_;
                                                if _e9049 {
                                                    phi_19529_ = _e9047;
                                                } else {
                                                    phi_19529_ = _e9045;
                                                }
                                                let _e9051 = phi_19529_;
                                                let _e9052 = (_e9051 == 0u);
                                                if _e9052 {
                                                    phi_22238_ = bool();
                                                    phi_22239_ = f32();
                                                    phi_22240_ = f32();
                                                    phi_22241_ = false;
                                                    phi_22242_ = false;
                                                    phi_22243_ = false;
                                                } else {
                                                    if (_e9051 == 1u) {
                                                        phi_19539_ = _e8321.member_2;
                                                    } else {
                                                        phi_19539_ = false;
                                                    }
                                                    let _e9056 = phi_19539_;
                                                    let _e9057 = (_e5602 * 0.99f);
                                                    if _e9056 {
                                                        if ((_e8321.member_1 - _e8321.member) <= _e9057) {
                                                            phi_19551_ = false;
                                                        } else {
                                                            phi_19551_ = true;
                                                        }
                                                        let _e9063 = phi_19551_;
                                                        phi_19552_ = _e9063;
                                                    } else {
                                                        phi_19552_ = true;
                                                    }
                                                    let _e9065 = phi_19552_;
                                                    if _e9065 {
                                                        let _e9070 = local_18.member[0u];
                                                        let _e9077 = local_18.member_1[0u];
                                                        let _e9083 = local_18.member_2[0u];
                                                        let _e9087 = (_e9070[0] - _e9077[0]);
                                                        let _e9088 = (_e9070[1] - _e9077[1]);
                                                        let _e9089 = (_e9070[2] - _e9077[2]);
                                                        if (_e316.member == 0u) {
                                                            phi_19613_ = array<f32, 3>(_e9070[0], _e9070[1], _e9070[2]);
                                                        } else {
                                                            phi_19613_ = array<f32, 3>((_e9087 - _e9083[0]), (_e9088 - _e9083[1]), (_e9089 - _e9083[2]));
                                                        }
                                                        let _e9096 = phi_19613_;
                                                        let _e9102 = local_18.member[1u];
                                                        let _e9109 = local_18.member_1[1u];
                                                        let _e9115 = local_18.member_2[1u];
                                                        let _e9119 = (_e9102[0] - _e9109[0]);
                                                        let _e9120 = (_e9102[1] - _e9109[1]);
                                                        let _e9121 = (_e9102[2] - _e9109[2]);
                                                        if (_e316.member == 0u) {
                                                            phi_19678_ = array<f32, 3>(_e9102[0], _e9102[1], _e9102[2]);
                                                        } else {
                                                            phi_19678_ = array<f32, 3>((_e9119 - _e9115[0]), (_e9120 - _e9115[1]), (_e9121 - _e9115[2]));
                                                        }
                                                        let _e9128 = phi_19678_;
                                                        let _e9134 = local_18.member[0u];
                                                        if (_e9134[0] < 0f) {
                                                            phi_19700_ = -(_e9134[0]);
                                                        } else {
                                                            phi_19700_ = _e9134[0];
                                                        }
                                                        let _e9141 = phi_19700_;
                                                        if (_e9134[1] < 0f) {
                                                            phi_19707_ = -(_e9134[1]);
                                                        } else {
                                                            phi_19707_ = _e9134[1];
                                                        }
                                                        let _e9145 = phi_19707_;
                                                        if (_e9141 > _e9145) {
                                                            phi_19712_ = _e9141;
                                                        } else {
                                                            phi_19712_ = _e9145;
                                                        }
                                                        let _e9148 = phi_19712_;
                                                        if (_e9134[2] < 0f) {
                                                            phi_19719_ = -(_e9134[2]);
                                                        } else {
                                                            phi_19719_ = _e9134[2];
                                                        }
                                                        let _e9152 = phi_19719_;
                                                        if (_e9148 > _e9152) {
                                                            phi_19724_ = _e9148;
                                                        } else {
                                                            phi_19724_ = _e9152;
                                                        }
                                                        let _e9155 = phi_19724_;
                                                        let _e9158 = local_18.member[1u];
                                                        if (_e9158[0] < 0f) {
                                                            phi_19737_ = -(_e9158[0]);
                                                        } else {
                                                            phi_19737_ = _e9158[0];
                                                        }
                                                        let _e9165 = phi_19737_;
                                                        if (_e9158[1] < 0f) {
                                                            phi_19744_ = -(_e9158[1]);
                                                        } else {
                                                            phi_19744_ = _e9158[1];
                                                        }
                                                        let _e9169 = phi_19744_;
                                                        if (_e9165 > _e9169) {
                                                            phi_19749_ = _e9165;
                                                        } else {
                                                            phi_19749_ = _e9169;
                                                        }
                                                        let _e9172 = phi_19749_;
                                                        if (_e9158[2] < 0f) {
                                                            phi_19756_ = -(_e9158[2]);
                                                        } else {
                                                            phi_19756_ = _e9158[2];
                                                        }
                                                        let _e9176 = phi_19756_;
                                                        if (_e9172 > _e9176) {
                                                            phi_19761_ = _e9172;
                                                        } else {
                                                            phi_19761_ = _e9176;
                                                        }
                                                        let _e9179 = phi_19761_;
                                                        if (_e9155 > _e9179) {
                                                            phi_19766_ = _e9155;
                                                        } else {
                                                            phi_19766_ = _e9179;
                                                        }
                                                        let _e9182 = phi_19766_;
                                                        let _e9184 = local_18.member_3;
                                                        let _e9188 = local_18.member_1[0u];
                                                        if (_e9188[0] < 0f) {
                                                            phi_19783_ = -(_e9188[0]);
                                                        } else {
                                                            phi_19783_ = _e9188[0];
                                                        }
                                                        let _e9195 = phi_19783_;
                                                        if (_e9188[1] < 0f) {
                                                            phi_19790_ = -(_e9188[1]);
                                                        } else {
                                                            phi_19790_ = _e9188[1];
                                                        }
                                                        let _e9199 = phi_19790_;
                                                        if (_e9195 > _e9199) {
                                                            phi_19795_ = _e9195;
                                                        } else {
                                                            phi_19795_ = _e9199;
                                                        }
                                                        let _e9202 = phi_19795_;
                                                        if (_e9188[2] < 0f) {
                                                            phi_19802_ = -(_e9188[2]);
                                                        } else {
                                                            phi_19802_ = _e9188[2];
                                                        }
                                                        let _e9206 = phi_19802_;
                                                        if (_e9202 > _e9206) {
                                                            phi_19807_ = _e9202;
                                                        } else {
                                                            phi_19807_ = _e9206;
                                                        }
                                                        let _e9209 = phi_19807_;
                                                        let _e9212 = local_18.member_1[1u];
                                                        if (_e9212[0] < 0f) {
                                                            phi_19821_ = -(_e9212[0]);
                                                        } else {
                                                            phi_19821_ = _e9212[0];
                                                        }
                                                        let _e9219 = phi_19821_;
                                                        if (_e9212[1] < 0f) {
                                                            phi_19828_ = -(_e9212[1]);
                                                        } else {
                                                            phi_19828_ = _e9212[1];
                                                        }
                                                        let _e9223 = phi_19828_;
                                                        if (_e9219 > _e9223) {
                                                            phi_19833_ = _e9219;
                                                        } else {
                                                            phi_19833_ = _e9223;
                                                        }
                                                        let _e9226 = phi_19833_;
                                                        if (_e9212[2] < 0f) {
                                                            phi_19840_ = -(_e9212[2]);
                                                        } else {
                                                            phi_19840_ = _e9212[2];
                                                        }
                                                        let _e9230 = phi_19840_;
                                                        if (_e9226 > _e9230) {
                                                            phi_19845_ = _e9226;
                                                        } else {
                                                            phi_19845_ = _e9230;
                                                        }
                                                        let _e9233 = phi_19845_;
                                                        if (_e9209 > _e9233) {
                                                            phi_19850_ = _e9209;
                                                        } else {
                                                            phi_19850_ = _e9233;
                                                        }
                                                        let _e9236 = phi_19850_;
                                                        let _e9238 = local_18.member_3;
                                                        let _e9242 = local_18.member_2[0u];
                                                        if (_e9242[0] < 0f) {
                                                            phi_19867_ = -(_e9242[0]);
                                                        } else {
                                                            phi_19867_ = _e9242[0];
                                                        }
                                                        let _e9249 = phi_19867_;
                                                        if (_e9242[1] < 0f) {
                                                            phi_19874_ = -(_e9242[1]);
                                                        } else {
                                                            phi_19874_ = _e9242[1];
                                                        }
                                                        let _e9253 = phi_19874_;
                                                        if (_e9249 > _e9253) {
                                                            phi_19879_ = _e9249;
                                                        } else {
                                                            phi_19879_ = _e9253;
                                                        }
                                                        let _e9256 = phi_19879_;
                                                        if (_e9242[2] < 0f) {
                                                            phi_19886_ = -(_e9242[2]);
                                                        } else {
                                                            phi_19886_ = _e9242[2];
                                                        }
                                                        let _e9260 = phi_19886_;
                                                        if (_e9256 > _e9260) {
                                                            phi_19891_ = _e9256;
                                                        } else {
                                                            phi_19891_ = _e9260;
                                                        }
                                                        let _e9263 = phi_19891_;
                                                        let _e9266 = local_18.member_2[1u];
                                                        if (_e9266[0] < 0f) {
                                                            phi_19905_ = -(_e9266[0]);
                                                        } else {
                                                            phi_19905_ = _e9266[0];
                                                        }
                                                        let _e9273 = phi_19905_;
                                                        if (_e9266[1] < 0f) {
                                                            phi_19912_ = -(_e9266[1]);
                                                        } else {
                                                            phi_19912_ = _e9266[1];
                                                        }
                                                        let _e9277 = phi_19912_;
                                                        if (_e9273 > _e9277) {
                                                            phi_19917_ = _e9273;
                                                        } else {
                                                            phi_19917_ = _e9277;
                                                        }
                                                        let _e9280 = phi_19917_;
                                                        if (_e9266[2] < 0f) {
                                                            phi_19924_ = -(_e9266[2]);
                                                        } else {
                                                            phi_19924_ = _e9266[2];
                                                        }
                                                        let _e9284 = phi_19924_;
                                                        if (_e9280 > _e9284) {
                                                            phi_19929_ = _e9280;
                                                        } else {
                                                            phi_19929_ = _e9284;
                                                        }
                                                        let _e9287 = phi_19929_;
                                                        if (_e9263 > _e9287) {
                                                            phi_19934_ = _e9263;
                                                        } else {
                                                            phi_19934_ = _e9287;
                                                        }
                                                        let _e9290 = phi_19934_;
                                                        let _e9292 = local_18.member_3;
                                                        let _e9299 = local_18.member_3;
                                                        let _e9304 = (_e5602 * 0.00390625f);
                                                        local = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                        phi_19975_ = type_9(0u, 96u);
                                                        phi_19978_ = _e8321.member;
                                                        phi_19980_ = _e8321.member;
                                                        phi_19982_ = (_e8321.member_1 - _e8321.member);
                                                        phi_19984_ = _e8321.member;
                                                        phi_19986_ = false;
                                                        phi_19988_ = 0u;
                                                        loop {
                                                            let _e9307 = phi_19975_;
                                                            let _e9309 = phi_19978_;
                                                            let _e9311 = phi_19980_;
                                                            let _e9313 = phi_19982_;
                                                            let _e9315 = phi_19984_;
                                                            let _e9317 = phi_19986_;
                                                            let _e9319 = phi_19988_;
                                                            local_96 = _e9309;
                                                            local_146 = _e9311;
                                                            if (_e9307.member < _e9307.member_1) {
                                                                phi_19976_ = type_9((_e9307.member + 1u), _e9307.member_1);
                                                                phi_20011_ = type_9(1u, _e9307.member);
                                                            } else {
                                                                phi_19976_ = _e9307;
                                                                phi_20011_ = type_9(0u, type_9().member_1);
                                                            }
                                                            let _e9331 = phi_19976_;
                                                            let _e9333 = phi_20011_;
                                                            if (bitcast<i32>(_e9333.member) != 0i) {
                                                                let _e9339 = local_18.member[0u];
                                                                let _e9345 = local_18.member[1u];
                                                                let _e9361 = local_18.member_1[0u];
                                                                let _e9367 = local_18.member_1[1u];
                                                                let _e9383 = local_18.member_2[0u];
                                                                let _e9389 = local_18.member_2[1u];
                                                                let _e9403 = function_3(array<f32, 3>((_e9339[0] + ((_e9345[0] - _e9339[0]) * _e9309)), (_e9339[1] + ((_e9345[1] - _e9339[1]) * _e9309)), (_e9339[2] + ((_e9345[2] - _e9339[2]) * _e9309))), array<f32, 3>((_e9361[0] + ((_e9367[0] - _e9361[0]) * _e9309)), (_e9361[1] + ((_e9367[1] - _e9361[1]) * _e9309)), (_e9361[2] + ((_e9367[2] - _e9361[2]) * _e9309))), array<f32, 3>((_e9383[0] + ((_e9389[0] - _e9383[0]) * _e9309)), (_e9383[1] + ((_e9389[1] - _e9383[1]) * _e9309)), (_e9383[2] + ((_e9389[2] - _e9383[2]) * _e9309))), _e316.member);
                                                                if (_e9319 == 0u) {
                                                                    phi_20139_ = _e9403;
                                                                } else {
                                                                    if (_e9319 == 1u) {
                                                                        phi_20125_ = _e9403[0];
                                                                    } else {
                                                                        phi_20125_ = 0f;
                                                                    }
                                                                    let _e9408 = phi_20125_;
                                                                    if (_e9319 == 2u) {
                                                                        phi_20131_ = _e9403[1];
                                                                    } else {
                                                                        phi_20131_ = 0f;
                                                                    }
                                                                    let _e9412 = phi_20131_;
                                                                    if (_e9319 == 3u) {
                                                                        phi_20137_ = _e9403[2];
                                                                    } else {
                                                                        phi_20137_ = 0f;
                                                                    }
                                                                    let _e9416 = phi_20137_;
                                                                    phi_20139_ = array<f32, 3>(_e9408, _e9412, _e9416);
                                                                }
                                                                let _e9419 = phi_20139_;
                                                                if (_e9419[0] < 0f) {
                                                                    phi_20146_ = -(_e9419[0]);
                                                                } else {
                                                                    phi_20146_ = _e9419[0];
                                                                }
                                                                let _e9424 = phi_20146_;
                                                                if (_e9419[1] < 0f) {
                                                                    phi_20153_ = -(_e9419[1]);
                                                                } else {
                                                                    phi_20153_ = _e9419[1];
                                                                }
                                                                let _e9429 = phi_20153_;
                                                                if (_e9419[2] < 0f) {
                                                                    phi_20161_ = -(_e9419[2]);
                                                                } else {
                                                                    phi_20161_ = _e9419[2];
                                                                }
                                                                let _e9435 = phi_20161_;
                                                                let _e9436 = ((_e9424 + _e9429) + _e9435);
                                                                if (_e9436 > 0f) {
                                                                    if ((bitcast<u32>(_e9436) & 2139095040u) != 2139095040u) {
                                                                        let _e9441 = (1f / _e9436);
                                                                        let _e9443 = (_e9419[0] * _e9441);
                                                                        let _e9445 = (_e9419[1] * _e9441);
                                                                        let _e9447 = (_e9419[2] * _e9441);
                                                                        let _e9452 = (((_e9443 * _e9443) + (_e9445 * _e9445)) + (_e9447 * _e9447));
                                                                        if (_e9452 <= 0.000000000000000000000000000000000000011754944f) {
                                                                            if (_e9452 > 0f) {
                                                                                phi_20198_ = (0.000000000000000000106433627f * 2f);
                                                                            } else {
                                                                                phi_20198_ = 0f;
                                                                            }
                                                                            let _e9505 = phi_20198_;
                                                                            phi_20262_ = _e9505;
                                                                        } else {
                                                                            phi_20205_ = type_14(0i, 5i);
                                                                            phi_20208_ = bitcast<f32>(((bitcast<u32>(_e9452) >> bitcast<u32>(1i)) + 532369198u));
                                                                            loop {
                                                                                let _e9460 = phi_20205_;
                                                                                let _e9462 = phi_20208_;
                                                                                local_94 = _e9462;
                                                                                if (_e9460.member < _e9460.member_1) {
                                                                                    let _e9469 = (_e9460.member + 1i);
                                                                                    if ((false == (_e9469 > _e9460.member)) != false) {
                                                                                        phi_20229_ = true;
                                                                                    } else {
                                                                                        phi_20229_ = false;
                                                                                    }
                                                                                    let _e9474 = phi_20229_;
                                                                                    if _e9474 {
                                                                                        phi_20235_ = type_15(0u, type_15().member_1);
                                                                                    } else {
                                                                                        phi_20235_ = type_15(1u, _e9469);
                                                                                    }
                                                                                    let _e9479 = phi_20235_;
                                                                                    phi_20206_ = type_14(_e9479.member_1, _e9460.member_1);
                                                                                    phi_20249_ = type_15(1u, _e9460.member);
                                                                                } else {
                                                                                    phi_20206_ = _e9460;
                                                                                    phi_20249_ = type_15(0u, type_15().member_1);
                                                                                }
                                                                                let _e9485 = phi_20206_;
                                                                                let _e9487 = phi_20249_;
                                                                                let _e9490 = (bitcast<i32>(_e9487.member) != 0i);
                                                                                if _e9490 {
                                                                                    phi_20209_ = (0.5f * (_e9462 + (_e9452 / _e9462)));
                                                                                } else {
                                                                                    phi_20209_ = f32();
                                                                                }
                                                                                let _e9495 = phi_20209_;
                                                                                continue;
                                                                                continuing {
                                                                                    phi_20205_ = _e9485;
                                                                                    phi_20208_ = _e9495;
                                                                                    break if !(_e9490);
                                                                                }
                                                                            }
                                                                            let _e9500 = local_94;
                                                                            phi_20262_ = (_e9500 * (1f + (8f * 0.000000059604645f)));
                                                                        }
                                                                        let _e9507 = phi_20262_;
                                                                        let _e9508 = (0.000000059604645f * 12f);
                                                                        let _e9513 = ((((((((_e9182 + _e9184) + (_e9236 + _e9238)) + (_e9290 + _e9292)) * (0.000000059604645f * 16f)) + (_e9299 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e9507) * (1f + _e9508)));
                                                                        let _e9518 = (((_e9443 * _e9070[0]) + (_e9445 * _e9070[1])) + (_e9447 * _e9070[2]));
                                                                        let _e9523 = (((_e9443 * _e9087) + (_e9445 * _e9088)) + (_e9447 * _e9089));
                                                                        let _e9528 = (((_e9443 * (_e9070[0] - _e9083[0])) + (_e9445 * (_e9070[1] - _e9083[1]))) + (_e9447 * (_e9070[2] - _e9083[2])));
                                                                        let _e9536 = (((_e9443 * _e9096[0]) + (_e9445 * _e9096[1])) + (_e9447 * _e9096[2]));
                                                                        let _e9542 = (((_e9443 * _e9102[0]) + (_e9445 * _e9102[1])) + (_e9447 * _e9102[2]));
                                                                        let _e9547 = (((_e9443 * _e9119) + (_e9445 * _e9120)) + (_e9447 * _e9121));
                                                                        let _e9552 = (((_e9443 * (_e9102[0] - _e9115[0])) + (_e9445 * (_e9102[1] - _e9115[1]))) + (_e9447 * (_e9102[2] - _e9115[2])));
                                                                        let _e9560 = (((_e9443 * _e9128[0]) + (_e9445 * _e9128[1])) + (_e9447 * _e9128[2]));
                                                                        if (_e9518 < 0f) {
                                                                            phi_20328_ = -(_e9518);
                                                                        } else {
                                                                            phi_20328_ = _e9518;
                                                                        }
                                                                        let _e9565 = phi_20328_;
                                                                        if (_e9542 < 0f) {
                                                                            phi_20334_ = -(_e9542);
                                                                        } else {
                                                                            phi_20334_ = _e9542;
                                                                        }
                                                                        let _e9569 = phi_20334_;
                                                                        if (_e9523 < 0f) {
                                                                            phi_20343_ = -(_e9523);
                                                                        } else {
                                                                            phi_20343_ = _e9523;
                                                                        }
                                                                        let _e9576 = phi_20343_;
                                                                        if (_e9547 < 0f) {
                                                                            phi_20349_ = -(_e9547);
                                                                        } else {
                                                                            phi_20349_ = _e9547;
                                                                        }
                                                                        let _e9580 = phi_20349_;
                                                                        if (_e9528 < 0f) {
                                                                            phi_20358_ = -(_e9528);
                                                                        } else {
                                                                            phi_20358_ = _e9528;
                                                                        }
                                                                        let _e9587 = phi_20358_;
                                                                        if (_e9552 < 0f) {
                                                                            phi_20364_ = -(_e9552);
                                                                        } else {
                                                                            phi_20364_ = _e9552;
                                                                        }
                                                                        let _e9591 = phi_20364_;
                                                                        if (_e9536 < 0f) {
                                                                            phi_20373_ = -(_e9536);
                                                                        } else {
                                                                            phi_20373_ = _e9536;
                                                                        }
                                                                        let _e9598 = phi_20373_;
                                                                        if (_e9560 < 0f) {
                                                                            phi_20379_ = -(_e9560);
                                                                        } else {
                                                                            phi_20379_ = _e9560;
                                                                        }
                                                                        let _e9602 = phi_20379_;
                                                                        phi_20385_ = type_29(array<f32, 4>(_e9518, _e9523, _e9528, _e9536), array<f32, 4>(_e9542, _e9547, _e9552, _e9560), array<f32, 4>((_e9513 + ((_e9565 + _e9569) * _e9508)), (_e9513 + ((_e9576 + _e9580) * _e9508)), (_e9513 + ((_e9587 + _e9591) * _e9508)), (_e9513 + ((_e9598 + _e9602) * _e9508))));
                                                                        phi_20386_ = false;
                                                                    } else {
                                                                        phi_20385_ = type_29();
                                                                        phi_20386_ = true;
                                                                    }
                                                                    let _e9609 = phi_20385_;
                                                                    let _e9611 = phi_20386_;
                                                                    phi_20387_ = _e9609;
                                                                    phi_20388_ = _e9611;
                                                                } else {
                                                                    phi_20387_ = type_29();
                                                                    phi_20388_ = true;
                                                                }
                                                                let _e9613 = phi_20387_;
                                                                let _e9615 = phi_20388_;
                                                                if _e9615 {
                                                                    phi_20396_ = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                                } else {
                                                                    phi_20396_ = _e9613;
                                                                }
                                                                let _e9617 = phi_20396_;
                                                                local_1 = type_29(array<f32, 4>(_e9617.member[0], _e9617.member[1], _e9617.member[2], _e9617.member[3]), array<f32, 4>(_e9617.member_1[0], _e9617.member_1[1], _e9617.member_1[2], _e9617.member_1[3]), array<f32, 4>(_e9617.member_2[0], _e9617.member_2[1], _e9617.member_2[2], _e9617.member_2[3]));
                                                                let _e9637 = (_e9309 - _e9315);
                                                                let _e9641 = local_1.member[0u];
                                                                let _e9644 = local_1.member_1[0u];
                                                                let _e9647 = local_1.member[0u];
                                                                let _e9653 = local_1.member_2[0u];
                                                                if (((_e9641 + ((_e9644 - _e9647) * _e9309)) - _e9653) > 0f) {
                                                                    let _e9658 = local_1.member[1u];
                                                                    let _e9661 = local_1.member_1[1u];
                                                                    let _e9664 = local_1.member[1u];
                                                                    let _e9670 = local_1.member_2[1u];
                                                                    if (((_e9658 + ((_e9661 - _e9664) * _e9309)) - _e9670) > 0f) {
                                                                        let _e9675 = local_1.member[2u];
                                                                        let _e9678 = local_1.member_1[2u];
                                                                        let _e9681 = local_1.member[2u];
                                                                        let _e9687 = local_1.member_2[2u];
                                                                        if (((_e9675 + ((_e9678 - _e9681) * _e9309)) - _e9687) > 0f) {
                                                                            let _e9692 = local_1.member[3u];
                                                                            let _e9695 = local_1.member_1[3u];
                                                                            let _e9698 = local_1.member[3u];
                                                                            let _e9704 = local_1.member_2[3u];
                                                                            phi_20567_ = (((_e9692 + ((_e9695 - _e9698) * _e9309)) - _e9704) > 0f);
                                                                            phi_20568_ = false;
                                                                        } else {
                                                                            phi_20567_ = bool();
                                                                            phi_20568_ = true;
                                                                        }
                                                                        let _e9708 = phi_20567_;
                                                                        let _e9710 = phi_20568_;
                                                                        phi_20569_ = _e9708;
                                                                        phi_20570_ = _e9710;
                                                                    } else {
                                                                        phi_20569_ = bool();
                                                                        phi_20570_ = true;
                                                                    }
                                                                    let _e9712 = phi_20569_;
                                                                    let _e9714 = phi_20570_;
                                                                    phi_20571_ = _e9712;
                                                                    phi_20572_ = _e9714;
                                                                } else {
                                                                    phi_20571_ = bool();
                                                                    phi_20572_ = true;
                                                                }
                                                                let _e9716 = phi_20571_;
                                                                let _e9718 = phi_20572_;
                                                                if _e9718 {
                                                                    phi_20576_ = false;
                                                                } else {
                                                                    phi_20576_ = _e9716;
                                                                }
                                                                let _e9720 = phi_20576_;
                                                                if _e9720 {
                                                                    if (_e9309 <= _e9311) {
                                                                        phi_20886_ = true;
                                                                    } else {
                                                                        let _e9724 = local.member[0u];
                                                                        let _e9727 = local.member_1[0u];
                                                                        let _e9730 = local.member[0u];
                                                                        let _e9736 = local.member_2[0u];
                                                                        let _e9740 = local_1.member[0u];
                                                                        let _e9743 = local_1.member_1[0u];
                                                                        let _e9746 = local_1.member[0u];
                                                                        let _e9752 = local_1.member_2[0u];
                                                                        if ((((_e9724 + ((_e9727 - _e9730) * _e9309)) - _e9736) + ((_e9740 + ((_e9743 - _e9746) * _e9315)) - _e9752)) > 0f) {
                                                                            let _e9758 = local.member[1u];
                                                                            let _e9761 = local.member_1[1u];
                                                                            let _e9764 = local.member[1u];
                                                                            let _e9770 = local.member_2[1u];
                                                                            let _e9774 = local_1.member[1u];
                                                                            let _e9777 = local_1.member_1[1u];
                                                                            let _e9780 = local_1.member[1u];
                                                                            let _e9786 = local_1.member_2[1u];
                                                                            if ((((_e9758 + ((_e9761 - _e9764) * _e9309)) - _e9770) + ((_e9774 + ((_e9777 - _e9780) * _e9315)) - _e9786)) > 0f) {
                                                                                let _e9792 = local.member[2u];
                                                                                let _e9795 = local.member_1[2u];
                                                                                let _e9798 = local.member[2u];
                                                                                let _e9804 = local.member_2[2u];
                                                                                let _e9808 = local_1.member[2u];
                                                                                let _e9811 = local_1.member_1[2u];
                                                                                let _e9814 = local_1.member[2u];
                                                                                let _e9820 = local_1.member_2[2u];
                                                                                if ((((_e9792 + ((_e9795 - _e9798) * _e9309)) - _e9804) + ((_e9808 + ((_e9811 - _e9814) * _e9315)) - _e9820)) > 0f) {
                                                                                    let _e9826 = local.member[3u];
                                                                                    let _e9829 = local.member_1[3u];
                                                                                    let _e9832 = local.member[3u];
                                                                                    let _e9838 = local.member_2[3u];
                                                                                    let _e9842 = local_1.member[3u];
                                                                                    let _e9845 = local_1.member_1[3u];
                                                                                    let _e9848 = local_1.member[3u];
                                                                                    let _e9854 = local_1.member_2[3u];
                                                                                    phi_20873_ = ((((_e9826 + ((_e9829 - _e9832) * _e9309)) - _e9838) + ((_e9842 + ((_e9845 - _e9848) * _e9315)) - _e9854)) > 0f);
                                                                                    phi_20874_ = false;
                                                                                } else {
                                                                                    phi_20873_ = bool();
                                                                                    phi_20874_ = true;
                                                                                }
                                                                                let _e9859 = phi_20873_;
                                                                                let _e9861 = phi_20874_;
                                                                                phi_20875_ = _e9859;
                                                                                phi_20876_ = _e9861;
                                                                            } else {
                                                                                phi_20875_ = bool();
                                                                                phi_20876_ = true;
                                                                            }
                                                                            let _e9863 = phi_20875_;
                                                                            let _e9865 = phi_20876_;
                                                                            phi_20877_ = _e9863;
                                                                            phi_20878_ = _e9865;
                                                                        } else {
                                                                            phi_20877_ = bool();
                                                                            phi_20878_ = true;
                                                                        }
                                                                        let _e9867 = phi_20877_;
                                                                        let _e9869 = phi_20878_;
                                                                        if _e9869 {
                                                                            phi_20882_ = false;
                                                                        } else {
                                                                            phi_20882_ = _e9867;
                                                                        }
                                                                        let _e9871 = phi_20882_;
                                                                        phi_20886_ = _e9871;
                                                                    }
                                                                    let _e9873 = phi_20886_;
                                                                    if _e9873 {
                                                                        if _e9317 {
                                                                            if (_e9309 >= _e8321.member_1) {
                                                                                phi_20897_ = false;
                                                                            } else {
                                                                                phi_20897_ = true;
                                                                            }
                                                                            let _e9876 = phi_20897_;
                                                                            phi_20898_ = _e9876;
                                                                        } else {
                                                                            phi_20898_ = true;
                                                                        }
                                                                        let _e9878 = phi_20898_;
                                                                        if _e9878 {
                                                                            local = type_29(array<f32, 4>(_e9617.member[0], _e9617.member[1], _e9617.member[2], _e9617.member[3]), array<f32, 4>(_e9617.member_1[0], _e9617.member_1[1], _e9617.member_1[2], _e9617.member_1[3]), array<f32, 4>(_e9617.member_2[0], _e9617.member_2[1], _e9617.member_2[2], _e9617.member_2[3]));
                                                                            let _e9900 = local.member[0u];
                                                                            let _e9903 = local.member_1[0u];
                                                                            let _e9906 = local.member_2[0u];
                                                                            if (_e9900 > _e9906) {
                                                                                if (_e9903 > _e9906) {
                                                                                    phi_20972_ = false;
                                                                                } else {
                                                                                    phi_20972_ = true;
                                                                                }
                                                                                let _e9910 = phi_20972_;
                                                                                phi_20973_ = _e9910;
                                                                            } else {
                                                                                phi_20973_ = true;
                                                                            }
                                                                            let _e9912 = phi_20973_;
                                                                            if _e9912 {
                                                                                let _e9913 = (_e9903 >= _e9900);
                                                                                if _e9913 {
                                                                                    phi_20995_ = f32();
                                                                                    phi_20996_ = false;
                                                                                } else {
                                                                                    if ((_e9900 - _e9903) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                        phi_20993_ = (((_e9900 - _e9906) / (_e9900 - _e9903)) * (1f - (0.000000059604645f * 16f)));
                                                                                        phi_20994_ = false;
                                                                                    } else {
                                                                                        phi_20993_ = f32();
                                                                                        phi_20994_ = true;
                                                                                    }
                                                                                    let _e9924 = phi_20993_;
                                                                                    let _e9926 = phi_20994_;
                                                                                    phi_20995_ = _e9924;
                                                                                    phi_20996_ = _e9926;
                                                                                }
                                                                                let _e9928 = phi_20995_;
                                                                                let _e9930 = phi_20996_;
                                                                                phi_20997_ = _e9928;
                                                                                phi_20998_ = _e9913;
                                                                                phi_20999_ = _e9930;
                                                                            } else {
                                                                                phi_20997_ = f32();
                                                                                phi_20998_ = true;
                                                                                phi_20999_ = false;
                                                                            }
                                                                            let _e9932 = phi_20997_;
                                                                            let _e9934 = phi_20998_;
                                                                            let _e9936 = phi_20999_;
                                                                            if _e9934 {
                                                                                phi_21003_ = 2f;
                                                                                phi_21004_ = true;
                                                                            } else {
                                                                                phi_21003_ = _e9309;
                                                                                phi_21004_ = _e9936;
                                                                            }
                                                                            let _e9938 = phi_21003_;
                                                                            let _e9940 = phi_21004_;
                                                                            if _e9940 {
                                                                                phi_21008_ = _e9938;
                                                                            } else {
                                                                                phi_21008_ = _e9932;
                                                                            }
                                                                            let _e9942 = phi_21008_;
                                                                            let _e9945 = local.member[1u];
                                                                            let _e9948 = local.member_1[1u];
                                                                            let _e9951 = local.member_2[1u];
                                                                            if (_e9945 > _e9951) {
                                                                                if (_e9948 > _e9951) {
                                                                                    phi_21040_ = false;
                                                                                } else {
                                                                                    phi_21040_ = true;
                                                                                }
                                                                                let _e9955 = phi_21040_;
                                                                                phi_21041_ = _e9955;
                                                                            } else {
                                                                                phi_21041_ = true;
                                                                            }
                                                                            let _e9957 = phi_21041_;
                                                                            if _e9957 {
                                                                                let _e9958 = (_e9948 >= _e9945);
                                                                                if _e9958 {
                                                                                    phi_21063_ = f32();
                                                                                    phi_21064_ = false;
                                                                                } else {
                                                                                    if ((_e9945 - _e9948) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                        phi_21061_ = (((_e9945 - _e9951) / (_e9945 - _e9948)) * (1f - (0.000000059604645f * 16f)));
                                                                                        phi_21062_ = false;
                                                                                    } else {
                                                                                        phi_21061_ = f32();
                                                                                        phi_21062_ = true;
                                                                                    }
                                                                                    let _e9969 = phi_21061_;
                                                                                    let _e9971 = phi_21062_;
                                                                                    phi_21063_ = _e9969;
                                                                                    phi_21064_ = _e9971;
                                                                                }
                                                                                let _e9973 = phi_21063_;
                                                                                let _e9975 = phi_21064_;
                                                                                phi_21065_ = _e9973;
                                                                                phi_21066_ = _e9958;
                                                                                phi_21067_ = _e9975;
                                                                            } else {
                                                                                phi_21065_ = f32();
                                                                                phi_21066_ = true;
                                                                                phi_21067_ = false;
                                                                            }
                                                                            let _e9977 = phi_21065_;
                                                                            let _e9979 = phi_21066_;
                                                                            let _e9981 = phi_21067_;
                                                                            if _e9979 {
                                                                                phi_21071_ = 2f;
                                                                                phi_21072_ = true;
                                                                            } else {
                                                                                phi_21071_ = _e9309;
                                                                                phi_21072_ = _e9981;
                                                                            }
                                                                            let _e9983 = phi_21071_;
                                                                            let _e9985 = phi_21072_;
                                                                            if _e9985 {
                                                                                phi_21076_ = _e9983;
                                                                            } else {
                                                                                phi_21076_ = _e9977;
                                                                            }
                                                                            let _e9987 = phi_21076_;
                                                                            if (_e9942 < _e9987) {
                                                                                phi_21081_ = _e9942;
                                                                            } else {
                                                                                phi_21081_ = _e9987;
                                                                            }
                                                                            let _e9990 = phi_21081_;
                                                                            let _e9993 = local.member[2u];
                                                                            let _e9996 = local.member_1[2u];
                                                                            let _e9999 = local.member_2[2u];
                                                                            if (_e9993 > _e9999) {
                                                                                if (_e9996 > _e9999) {
                                                                                    phi_21113_ = false;
                                                                                } else {
                                                                                    phi_21113_ = true;
                                                                                }
                                                                                let _e10003 = phi_21113_;
                                                                                phi_21114_ = _e10003;
                                                                            } else {
                                                                                phi_21114_ = true;
                                                                            }
                                                                            let _e10005 = phi_21114_;
                                                                            if _e10005 {
                                                                                let _e10006 = (_e9996 >= _e9993);
                                                                                if _e10006 {
                                                                                    phi_21136_ = f32();
                                                                                    phi_21137_ = false;
                                                                                } else {
                                                                                    if ((_e9993 - _e9996) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                        phi_21134_ = (((_e9993 - _e9999) / (_e9993 - _e9996)) * (1f - (0.000000059604645f * 16f)));
                                                                                        phi_21135_ = false;
                                                                                    } else {
                                                                                        phi_21134_ = f32();
                                                                                        phi_21135_ = true;
                                                                                    }
                                                                                    let _e10017 = phi_21134_;
                                                                                    let _e10019 = phi_21135_;
                                                                                    phi_21136_ = _e10017;
                                                                                    phi_21137_ = _e10019;
                                                                                }
                                                                                let _e10021 = phi_21136_;
                                                                                let _e10023 = phi_21137_;
                                                                                phi_21138_ = _e10021;
                                                                                phi_21139_ = _e10006;
                                                                                phi_21140_ = _e10023;
                                                                            } else {
                                                                                phi_21138_ = f32();
                                                                                phi_21139_ = true;
                                                                                phi_21140_ = false;
                                                                            }
                                                                            let _e10025 = phi_21138_;
                                                                            let _e10027 = phi_21139_;
                                                                            let _e10029 = phi_21140_;
                                                                            if _e10027 {
                                                                                phi_21144_ = 2f;
                                                                                phi_21145_ = true;
                                                                            } else {
                                                                                phi_21144_ = _e9309;
                                                                                phi_21145_ = _e10029;
                                                                            }
                                                                            let _e10031 = phi_21144_;
                                                                            let _e10033 = phi_21145_;
                                                                            if _e10033 {
                                                                                phi_21149_ = _e10031;
                                                                            } else {
                                                                                phi_21149_ = _e10025;
                                                                            }
                                                                            let _e10035 = phi_21149_;
                                                                            let _e10038 = local.member[3u];
                                                                            let _e10041 = local.member_1[3u];
                                                                            let _e10044 = local.member_2[3u];
                                                                            if (_e10038 > _e10044) {
                                                                                if (_e10041 > _e10044) {
                                                                                    phi_21181_ = false;
                                                                                } else {
                                                                                    phi_21181_ = true;
                                                                                }
                                                                                let _e10048 = phi_21181_;
                                                                                phi_21182_ = _e10048;
                                                                            } else {
                                                                                phi_21182_ = true;
                                                                            }
                                                                            let _e10050 = phi_21182_;
                                                                            if _e10050 {
                                                                                let _e10051 = (_e10041 >= _e10038);
                                                                                if _e10051 {
                                                                                    phi_21204_ = f32();
                                                                                    phi_21205_ = false;
                                                                                } else {
                                                                                    if ((_e10038 - _e10041) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                        phi_21202_ = (((_e10038 - _e10044) / (_e10038 - _e10041)) * (1f - (0.000000059604645f * 16f)));
                                                                                        phi_21203_ = false;
                                                                                    } else {
                                                                                        phi_21202_ = f32();
                                                                                        phi_21203_ = true;
                                                                                    }
                                                                                    let _e10062 = phi_21202_;
                                                                                    let _e10064 = phi_21203_;
                                                                                    phi_21204_ = _e10062;
                                                                                    phi_21205_ = _e10064;
                                                                                }
                                                                                let _e10066 = phi_21204_;
                                                                                let _e10068 = phi_21205_;
                                                                                phi_21206_ = _e10066;
                                                                                phi_21207_ = _e10051;
                                                                                phi_21208_ = _e10068;
                                                                            } else {
                                                                                phi_21206_ = f32();
                                                                                phi_21207_ = true;
                                                                                phi_21208_ = false;
                                                                            }
                                                                            let _e10070 = phi_21206_;
                                                                            let _e10072 = phi_21207_;
                                                                            let _e10074 = phi_21208_;
                                                                            if _e10072 {
                                                                                phi_21212_ = 2f;
                                                                                phi_21213_ = true;
                                                                            } else {
                                                                                phi_21212_ = _e9309;
                                                                                phi_21213_ = _e10074;
                                                                            }
                                                                            let _e10076 = phi_21212_;
                                                                            let _e10078 = phi_21213_;
                                                                            if _e10078 {
                                                                                phi_21217_ = _e10076;
                                                                            } else {
                                                                                phi_21217_ = _e10070;
                                                                            }
                                                                            let _e10080 = phi_21217_;
                                                                            if (_e10035 < _e10080) {
                                                                                phi_21222_ = _e10035;
                                                                            } else {
                                                                                phi_21222_ = _e10080;
                                                                            }
                                                                            let _e10083 = phi_21222_;
                                                                            if (_e9990 < _e10083) {
                                                                                phi_21227_ = _e9990;
                                                                            } else {
                                                                                phi_21227_ = _e10083;
                                                                            }
                                                                            let _e10086 = phi_21227_;
                                                                            if (_e10086 > _e9309) {
                                                                                phi_21232_ = _e10086;
                                                                            } else {
                                                                                phi_21232_ = _e9309;
                                                                            }
                                                                            let _e10089 = phi_21232_;
                                                                            let _e10090 = (_e10089 > _e8321.member_1);
                                                                            if _e10090 {
                                                                                phi_21737_ = f32();
                                                                                phi_21738_ = f32();
                                                                                phi_21739_ = false;
                                                                            } else {
                                                                                let _e10091 = (_e10089 - _e9309);
                                                                                if _e9317 {
                                                                                    if (_e10091 <= _e9304) {
                                                                                        phi_21727_ = true;
                                                                                    } else {
                                                                                        if (_e10091 <= (_e9313 * 0.25f)) {
                                                                                            phi_21726_ = false;
                                                                                        } else {
                                                                                            phi_21726_ = true;
                                                                                        }
                                                                                        let _e10097 = phi_21726_;
                                                                                        phi_21727_ = _e10097;
                                                                                    }
                                                                                    let _e10099 = phi_21727_;
                                                                                    if _e10099 {
                                                                                        phi_21732_ = (_e9637 + _e9637);
                                                                                    } else {
                                                                                        phi_21732_ = 0f;
                                                                                    }
                                                                                    let _e10102 = phi_21732_;
                                                                                    phi_21734_ = _e10102;
                                                                                } else {
                                                                                    phi_21734_ = (_e8321.member_1 - _e9309);
                                                                                }
                                                                                let _e10104 = phi_21734_;
                                                                                phi_21737_ = _e10104;
                                                                                phi_21738_ = _e10091;
                                                                                phi_21739_ = true;
                                                                            }
                                                                            let _e10106 = phi_21737_;
                                                                            let _e10108 = phi_21738_;
                                                                            let _e10110 = phi_21739_;
                                                                            phi_21741_ = _e10089;
                                                                            phi_21742_ = _e10106;
                                                                            phi_21743_ = _e10108;
                                                                            phi_21745_ = _e10110;
                                                                            phi_21746_ = _e10090;
                                                                            phi_21748_ = false;
                                                                        } else {
                                                                            phi_21741_ = f32();
                                                                            phi_21742_ = f32();
                                                                            phi_21743_ = f32();
                                                                            phi_21745_ = false;
                                                                            phi_21746_ = false;
                                                                            phi_21748_ = true;
                                                                        }
                                                                        let _e10112 = phi_21741_;
                                                                        let _e10114 = phi_21742_;
                                                                        let _e10116 = phi_21743_;
                                                                        let _e10118 = phi_21745_;
                                                                        let _e10120 = phi_21746_;
                                                                        let _e10122 = phi_21748_;
                                                                        phi_21749_ = _e10112;
                                                                        phi_21750_ = _e10114;
                                                                        phi_21751_ = _e10116;
                                                                        phi_21753_ = false;
                                                                        phi_21754_ = _e10118;
                                                                        phi_21755_ = _e10120;
                                                                        phi_21757_ = _e10122;
                                                                    } else {
                                                                        phi_21749_ = f32();
                                                                        phi_21750_ = f32();
                                                                        phi_21751_ = f32();
                                                                        phi_21753_ = true;
                                                                        phi_21754_ = false;
                                                                        phi_21755_ = false;
                                                                        phi_21757_ = false;
                                                                    }
                                                                    let _e10124 = phi_21749_;
                                                                    let _e10126 = phi_21750_;
                                                                    let _e10128 = phi_21751_;
                                                                    let _e10130 = phi_21753_;
                                                                    let _e10132 = phi_21754_;
                                                                    let _e10134 = phi_21755_;
                                                                    let _e10136 = phi_21757_;
                                                                    phi_21758_ = _e10124;
                                                                    phi_21759_ = _e10126;
                                                                    phi_21760_ = _e10128;
                                                                    phi_21762_ = _e10130;
                                                                    phi_21763_ = _e10132;
                                                                    phi_21764_ = _e10134;
                                                                    phi_21766_ = _e10136;
                                                                } else {
                                                                    phi_21758_ = f32();
                                                                    phi_21759_ = f32();
                                                                    phi_21760_ = f32();
                                                                    phi_21762_ = true;
                                                                    phi_21763_ = false;
                                                                    phi_21764_ = false;
                                                                    phi_21766_ = false;
                                                                }
                                                                let _e10138 = phi_21758_;
                                                                let _e10140 = phi_21759_;
                                                                let _e10142 = phi_21760_;
                                                                let _e10144 = phi_21762_;
                                                                let _e10146 = phi_21763_;
                                                                let _e10148 = phi_21764_;
                                                                let _e10150 = phi_21766_;
                                                                if _e10144 {
                                                                    if (_e9309 <= _e9311) {
                                                                        let _e10311 = (_e9319 + 1u);
                                                                        let _e10312 = (_e10311 > 3u);
                                                                        if _e10312 {
                                                                            phi_21779_ = false;
                                                                        } else {
                                                                            phi_21779_ = true;
                                                                        }
                                                                        let _e10314 = phi_21779_;
                                                                        phi_22101_ = _e10311;
                                                                        phi_22102_ = f32();
                                                                        phi_22103_ = false;
                                                                        phi_22104_ = _e10314;
                                                                        phi_22105_ = _e10312;
                                                                    } else {
                                                                        let _e10154 = local.member[0u];
                                                                        let _e10157 = local.member_1[0u];
                                                                        let _e10160 = local.member[0u];
                                                                        let _e10166 = local.member_2[0u];
                                                                        let _e10167 = ((_e10154 + ((_e10157 - _e10160) * _e9315)) - _e10166);
                                                                        let _e10170 = local.member[1u];
                                                                        let _e10173 = local.member_1[1u];
                                                                        let _e10176 = local.member[1u];
                                                                        let _e10182 = local.member_2[1u];
                                                                        let _e10183 = ((_e10170 + ((_e10173 - _e10176) * _e9315)) - _e10182);
                                                                        if (_e10167 < _e10183) {
                                                                            phi_21852_ = _e10167;
                                                                        } else {
                                                                            phi_21852_ = _e10183;
                                                                        }
                                                                        let _e10186 = phi_21852_;
                                                                        let _e10189 = local.member[2u];
                                                                        let _e10192 = local.member_1[2u];
                                                                        let _e10195 = local.member[2u];
                                                                        let _e10201 = local.member_2[2u];
                                                                        let _e10202 = ((_e10189 + ((_e10192 - _e10195) * _e9315)) - _e10201);
                                                                        let _e10205 = local.member[3u];
                                                                        let _e10208 = local.member_1[3u];
                                                                        let _e10211 = local.member[3u];
                                                                        let _e10217 = local.member_2[3u];
                                                                        let _e10218 = ((_e10205 + ((_e10208 - _e10211) * _e9315)) - _e10217);
                                                                        if (_e10202 < _e10218) {
                                                                            phi_21925_ = _e10202;
                                                                        } else {
                                                                            phi_21925_ = _e10218;
                                                                        }
                                                                        let _e10221 = phi_21925_;
                                                                        if (_e10186 < _e10221) {
                                                                            phi_21930_ = _e10186;
                                                                        } else {
                                                                            phi_21930_ = _e10221;
                                                                        }
                                                                        let _e10224 = phi_21930_;
                                                                        let _e10227 = local_1.member[0u];
                                                                        let _e10230 = local_1.member_1[0u];
                                                                        let _e10233 = local_1.member[0u];
                                                                        let _e10239 = local_1.member_2[0u];
                                                                        let _e10240 = ((_e10227 + ((_e10230 - _e10233) * _e9309)) - _e10239);
                                                                        let _e10243 = local_1.member[1u];
                                                                        let _e10246 = local_1.member_1[1u];
                                                                        let _e10249 = local_1.member[1u];
                                                                        let _e10255 = local_1.member_2[1u];
                                                                        let _e10256 = ((_e10243 + ((_e10246 - _e10249) * _e9309)) - _e10255);
                                                                        if (_e10240 < _e10256) {
                                                                            phi_22003_ = _e10240;
                                                                        } else {
                                                                            phi_22003_ = _e10256;
                                                                        }
                                                                        let _e10259 = phi_22003_;
                                                                        let _e10262 = local_1.member[2u];
                                                                        let _e10265 = local_1.member_1[2u];
                                                                        let _e10268 = local_1.member[2u];
                                                                        let _e10274 = local_1.member_2[2u];
                                                                        let _e10275 = ((_e10262 + ((_e10265 - _e10268) * _e9309)) - _e10274);
                                                                        let _e10278 = local_1.member[3u];
                                                                        let _e10281 = local_1.member_1[3u];
                                                                        let _e10284 = local_1.member[3u];
                                                                        let _e10290 = local_1.member_2[3u];
                                                                        let _e10291 = ((_e10278 + ((_e10281 - _e10284) * _e9309)) - _e10290);
                                                                        if (_e10275 < _e10291) {
                                                                            phi_22076_ = _e10275;
                                                                        } else {
                                                                            phi_22076_ = _e10291;
                                                                        }
                                                                        let _e10294 = phi_22076_;
                                                                        if (_e10259 < _e10294) {
                                                                            phi_22081_ = _e10259;
                                                                        } else {
                                                                            phi_22081_ = _e10294;
                                                                        }
                                                                        let _e10297 = phi_22081_;
                                                                        if (_e10297 > 0f) {
                                                                            phi_22099_ = 0.5f;
                                                                        } else {
                                                                            let _e10301 = (0.95f * (_e10224 / (_e10224 - _e10297)));
                                                                            if (_e10301 > 0.0625f) {
                                                                                if (_e10301 < 0.9f) {
                                                                                    phi_22097_ = _e10301;
                                                                                } else {
                                                                                    phi_22097_ = 0.9f;
                                                                                }
                                                                                let _e10305 = phi_22097_;
                                                                                phi_22098_ = _e10305;
                                                                            } else {
                                                                                phi_22098_ = 0.0625f;
                                                                            }
                                                                            let _e10307 = phi_22098_;
                                                                            phi_22099_ = _e10307;
                                                                        }
                                                                        let _e10309 = phi_22099_;
                                                                        phi_22101_ = u32();
                                                                        phi_22102_ = (_e9637 * _e10309);
                                                                        phi_22103_ = true;
                                                                        phi_22104_ = false;
                                                                        phi_22105_ = false;
                                                                    }
                                                                    let _e10316 = phi_22101_;
                                                                    let _e10318 = phi_22102_;
                                                                    let _e10320 = phi_22103_;
                                                                    let _e10322 = phi_22104_;
                                                                    let _e10324 = phi_22105_;
                                                                    phi_22106_ = _e10316;
                                                                    phi_22107_ = _e9311;
                                                                    phi_22108_ = _e10318;
                                                                    phi_22109_ = _e9313;
                                                                    phi_22110_ = _e9315;
                                                                    phi_22111_ = _e9317;
                                                                    phi_22112_ = _e9319;
                                                                    phi_22113_ = _e10320;
                                                                    phi_22114_ = _e10322;
                                                                    phi_22115_ = _e10324;
                                                                    phi_22116_ = false;
                                                                    phi_22118_ = false;
                                                                } else {
                                                                    phi_22106_ = u32();
                                                                    phi_22107_ = _e10138;
                                                                    phi_22108_ = _e10140;
                                                                    phi_22109_ = _e10142;
                                                                    phi_22110_ = _e9309;
                                                                    phi_22111_ = true;
                                                                    phi_22112_ = 0u;
                                                                    phi_22113_ = _e10146;
                                                                    phi_22114_ = false;
                                                                    phi_22115_ = false;
                                                                    phi_22116_ = _e10148;
                                                                    phi_22118_ = _e10150;
                                                                }
                                                                let _e10326 = phi_22106_;
                                                                let _e10328 = phi_22107_;
                                                                let _e10330 = phi_22108_;
                                                                let _e10332 = phi_22109_;
                                                                let _e10334 = phi_22110_;
                                                                let _e10336 = phi_22111_;
                                                                let _e10338 = phi_22112_;
                                                                let _e10340 = phi_22113_;
                                                                let _e10342 = phi_22114_;
                                                                let _e10344 = phi_22115_;
                                                                let _e10346 = phi_22116_;
                                                                let _e10348 = phi_22118_;
                                                                if _e10340 {
                                                                    let _e10349 = (_e10334 + _e10330);
                                                                    if (_e10349 > _e10328) {
                                                                        phi_22127_ = _e10349;
                                                                    } else {
                                                                        phi_22127_ = _e10328;
                                                                    }
                                                                    let _e10352 = phi_22127_;
                                                                    if (_e10352 < _e8321.member_1) {
                                                                        phi_22132_ = _e10352;
                                                                    } else {
                                                                        phi_22132_ = _e8321.member_1;
                                                                    }
                                                                    let _e10355 = phi_22132_;
                                                                    if !(_e9317) {
                                                                        phi_22141_ = true;
                                                                    } else {
                                                                        phi_22141_ = ((_e10355 - _e10334) > _e9304);
                                                                    }
                                                                    let _e10359 = phi_22141_;
                                                                    if _e10359 {
                                                                        phi_22145_ = false;
                                                                    } else {
                                                                        phi_22145_ = true;
                                                                    }
                                                                    let _e10361 = phi_22145_;
                                                                    phi_22146_ = _e10355;
                                                                    phi_22147_ = _e10328;
                                                                    phi_22148_ = _e10332;
                                                                    phi_22149_ = _e10334;
                                                                    phi_22150_ = _e10336;
                                                                    phi_22151_ = _e10338;
                                                                    phi_22152_ = _e10359;
                                                                    phi_22153_ = _e10361;
                                                                    phi_22154_ = false;
                                                                    phi_22155_ = false;
                                                                    phi_22157_ = false;
                                                                } else {
                                                                    phi_22146_ = _e9309;
                                                                    phi_22147_ = _e9311;
                                                                    phi_22148_ = _e9313;
                                                                    phi_22149_ = _e9315;
                                                                    phi_22150_ = _e9317;
                                                                    phi_22151_ = _e10326;
                                                                    phi_22152_ = _e10342;
                                                                    phi_22153_ = false;
                                                                    phi_22154_ = _e10344;
                                                                    phi_22155_ = _e10346;
                                                                    phi_22157_ = _e10348;
                                                                }
                                                                let _e10363 = phi_22146_;
                                                                let _e10365 = phi_22147_;
                                                                let _e10367 = phi_22148_;
                                                                let _e10369 = phi_22149_;
                                                                let _e10371 = phi_22150_;
                                                                let _e10373 = phi_22151_;
                                                                let _e10375 = phi_22152_;
                                                                let _e10377 = phi_22153_;
                                                                let _e10379 = phi_22154_;
                                                                let _e10381 = phi_22155_;
                                                                let _e10383 = phi_22157_;
                                                                phi_19979_ = _e10363;
                                                                phi_19981_ = _e10365;
                                                                phi_19983_ = _e10367;
                                                                phi_19985_ = _e10369;
                                                                phi_19987_ = _e10371;
                                                                phi_19989_ = _e10373;
                                                                phi_22158_ = _e10328;
                                                                phi_22160_ = _e10375;
                                                                phi_22161_ = _e10377;
                                                                phi_22162_ = _e10379;
                                                                phi_22163_ = _e10381;
                                                                phi_22165_ = false;
                                                                phi_22166_ = _e10383;
                                                            } else {
                                                                phi_19979_ = f32();
                                                                phi_19981_ = f32();
                                                                phi_19983_ = f32();
                                                                phi_19985_ = f32();
                                                                phi_19987_ = bool();
                                                                phi_19989_ = u32();
                                                                phi_22158_ = f32();
                                                                phi_22160_ = false;
                                                                phi_22161_ = false;
                                                                phi_22162_ = false;
                                                                phi_22163_ = false;
                                                                phi_22165_ = true;
                                                                phi_22166_ = false;
                                                            }
                                                            let _e10385 = phi_19979_;
                                                            let _e10387 = phi_19981_;
                                                            let _e10389 = phi_19983_;
                                                            let _e10391 = phi_19985_;
                                                            let _e10393 = phi_19987_;
                                                            let _e10395 = phi_19989_;
                                                            let _e10397 = phi_22158_;
                                                            let _e10399 = phi_22160_;
                                                            let _e10401 = phi_22161_;
                                                            let _e10403 = phi_22162_;
                                                            let _e10405 = phi_22163_;
                                                            let _e10407 = phi_22165_;
                                                            let _e10409 = phi_22166_;
                                                            local_95 = _e10401;
                                                            local_140 = _e10403;
                                                            local_141 = _e10405;
                                                            local_142 = _e10407;
                                                            local_143 = _e10409;
                                                            local_144 = _e10401;
                                                            local_145 = _e10397;
                                                            continue;
                                                            continuing {
                                                                phi_19975_ = _e9331;
                                                                phi_19978_ = _e10385;
                                                                phi_19980_ = _e10387;
                                                                phi_19982_ = _e10389;
                                                                phi_19984_ = _e10391;
                                                                phi_19986_ = _e10393;
                                                                phi_19988_ = _e10395;
                                                                break if !(_e10399);
                                                            }
                                                        }
                                                        let _e10412 = local_95;
                                                        if _e10412 {
                                                            phi_22170_ = false;
                                                            phi_22171_ = false;
                                                            phi_22173_ = false;
                                                            phi_22174_ = false;
                                                        } else {
                                                            let _e16593 = local_140;
                                                            phi_22170_ = _e16593;
                                                            let _e16596 = local_141;
                                                            phi_22171_ = _e16596;
                                                            let _e16599 = local_142;
                                                            phi_22173_ = _e16599;
                                                            let _e16602 = local_143;
                                                            phi_22174_ = _e16602;
                                                        }
                                                        let _e10414 = phi_22170_;
                                                        let _e10416 = phi_22171_;
                                                        let _e10418 = phi_22173_;
                                                        let _e10420 = phi_22174_;
                                                        if _e10414 {
                                                            let _e10422 = local_96;
                                                            phi_22179_ = type_44(1u, _e10422);
                                                            phi_22180_ = false;
                                                            phi_22182_ = false;
                                                            phi_22183_ = false;
                                                            phi_22184_ = false;
                                                        } else {
                                                            phi_22179_ = type_44();
                                                            phi_22180_ = _e10416;
                                                            let _e16608 = local_144;
                                                            phi_22182_ = _e16608;
                                                            phi_22183_ = _e10418;
                                                            phi_22184_ = _e10420;
                                                        }
                                                        let _e10425 = phi_22179_;
                                                        let _e10427 = phi_22180_;
                                                        let _e10429 = phi_22182_;
                                                        let _e10431 = phi_22183_;
                                                        let _e10433 = phi_22184_;
                                                        if _e10427 {
                                                            phi_22189_ = type_44(0u, type_44().member_1);
                                                            phi_22191_ = false;
                                                            phi_22192_ = false;
                                                            phi_22193_ = false;
                                                            phi_22194_ = true;
                                                        } else {
                                                            phi_22189_ = _e10425;
                                                            phi_22191_ = _e10429;
                                                            phi_22192_ = _e10431;
                                                            phi_22193_ = _e10433;
                                                            phi_22194_ = _e10414;
                                                        }
                                                        let _e10437 = phi_22189_;
                                                        let _e10439 = phi_22191_;
                                                        let _e10441 = phi_22192_;
                                                        let _e10443 = phi_22193_;
                                                        let _e10445 = phi_22194_;
                                                        if _e10439 {
                                                            let _e16618 = local_145;
                                                            phi_22206_ = _e16618;
                                                            phi_22207_ = true;
                                                            phi_22208_ = false;
                                                            phi_22209_ = false;
                                                        } else {
                                                            let _e16620 = local_146;
                                                            phi_22206_ = _e16620;
                                                            phi_22207_ = _e10441;
                                                            phi_22208_ = _e10443;
                                                            phi_22209_ = _e10445;
                                                        }
                                                        let _e10447 = phi_22206_;
                                                        let _e10449 = phi_22207_;
                                                        let _e10451 = phi_22208_;
                                                        let _e10453 = phi_22209_;
                                                        if _e10449 {
                                                            phi_22214_ = type_44(1u, _e10447);
                                                            phi_22215_ = false;
                                                            phi_22216_ = false;
                                                        } else {
                                                            phi_22214_ = type_44();
                                                            phi_22215_ = _e10451;
                                                            phi_22216_ = _e10453;
                                                        }
                                                        let _e10456 = phi_22214_;
                                                        let _e10458 = phi_22215_;
                                                        let _e10460 = phi_22216_;
                                                        if _e10458 {
                                                            phi_22221_ = type_44(0u, type_44().member_1);
                                                            phi_22222_ = true;
                                                        } else {
                                                            phi_22221_ = _e10437;
                                                            phi_22222_ = _e10460;
                                                        }
                                                        let _e10464 = phi_22221_;
                                                        let _e10466 = phi_22222_;
                                                        if _e10466 {
                                                            phi_22226_ = _e10464;
                                                        } else {
                                                            phi_22226_ = _e10456;
                                                        }
                                                        let _e10468 = phi_22226_;
                                                        let _e10471 = (_e10468.member != 0u);
                                                        if _e10471 {
                                                            phi_22233_ = false;
                                                        } else {
                                                            phi_22233_ = true;
                                                        }
                                                        let _e10473 = phi_22233_;
                                                        phi_22234_ = _e10468.member_1;
                                                        phi_22235_ = _e10473;
                                                        phi_22236_ = _e10471;
                                                        phi_22237_ = false;
                                                    } else {
                                                        phi_22234_ = f32();
                                                        phi_22235_ = false;
                                                        phi_22236_ = false;
                                                        phi_22237_ = true;
                                                    }
                                                    let _e10475 = phi_22234_;
                                                    let _e10477 = phi_22235_;
                                                    let _e10479 = phi_22236_;
                                                    let _e10481 = phi_22237_;
                                                    phi_22238_ = _e9056;
                                                    phi_22239_ = _e9057;
                                                    phi_22240_ = _e10475;
                                                    phi_22241_ = _e10477;
                                                    phi_22242_ = _e10479;
                                                    phi_22243_ = _e10481;
                                                }
                                                let _e10483 = phi_22238_;
                                                let _e10485 = phi_22239_;
                                                let _e10487 = phi_22240_;
                                                let _e10489 = phi_22241_;
                                                let _e10491 = phi_22242_;
                                                let _e10493 = phi_22243_;
                                                phi_22244_ = _e10483;
                                                phi_22245_ = _e10485;
                                                phi_22246_ = _e10487;
                                                phi_22247_ = _e9052;
                                                phi_22248_ = _e10489;
                                                phi_22249_ = _e10491;
                                                phi_22250_ = _e10493;
                                            }
                                            let _e10495 = phi_22244_;
                                            let _e10497 = phi_22245_;
                                            let _e10499 = phi_22246_;
                                            let _e10501 = phi_22247_;
                                            let _e10503 = phi_22248_;
                                            let _e10505 = phi_22249_;
                                            let _e10507 = phi_22250_;
                                            if _e10501 {
                                                phi_22254_ = false;
                                                phi_22255_ = false;
                                                phi_22256_ = false;
                                            } else {
                                                phi_22254_ = _e10503;
                                                phi_22255_ = _e10505;
                                                phi_22256_ = _e10507;
                                            }
                                            let _e10509 = phi_22254_;
                                            let _e10511 = phi_22255_;
                                            let _e10513 = phi_22256_;
                                            phi_22257_ = _e8321;
                                            phi_22258_ = _e10495;
                                            phi_22259_ = _e10497;
                                            phi_22260_ = _e10499;
                                            phi_22261_ = _e8321;
                                            phi_22262_ = _e10501;
                                            phi_22263_ = _e10509;
                                            phi_22264_ = _e10511;
                                            phi_22265_ = _e10513;
                                        } else {
                                            phi_22257_ = type_47();
                                            phi_22258_ = bool();
                                            phi_22259_ = f32();
                                            phi_22260_ = f32();
                                            phi_22261_ = type_47();
                                            phi_22262_ = true;
                                            phi_22263_ = false;
                                            phi_22264_ = false;
                                            phi_22265_ = false;
                                        }
                                        let _e10515 = phi_22257_;
                                        let _e10517 = phi_22258_;
                                        let _e10519 = phi_22259_;
                                        let _e10521 = phi_22260_;
                                        let _e10523 = phi_22261_;
                                        let _e10525 = phi_22262_;
                                        let _e10527 = phi_22263_;
                                        let _e10529 = phi_22264_;
                                        let _e10531 = phi_22265_;
                                        if _e10525 {
                                            phi_22269_ = true;
                                            phi_22270_ = false;
                                            phi_22271_ = false;
                                        } else {
                                            phi_22269_ = _e10527;
                                            phi_22270_ = _e10529;
                                            phi_22271_ = _e10531;
                                        }
                                        let _e10533 = phi_22269_;
                                        let _e10535 = phi_22270_;
                                        let _e10537 = phi_22271_;
                                        phi_22272_ = _e10515;
                                        phi_22273_ = _e10517;
                                        phi_22274_ = _e10519;
                                        phi_22275_ = _e10521;
                                        phi_22276_ = _e10523;
                                        phi_22277_ = _e10533;
                                        phi_22278_ = false;
                                        phi_22279_ = _e10535;
                                        phi_22280_ = _e10537;
                                    } else {
                                        phi_22272_ = type_47();
                                        phi_22273_ = bool();
                                        phi_22274_ = f32();
                                        phi_22275_ = f32();
                                        phi_22276_ = type_47();
                                        phi_22277_ = false;
                                        phi_22278_ = true;
                                        phi_22279_ = false;
                                        phi_22280_ = false;
                                    }
                                    let _e10539 = phi_22272_;
                                    let _e10541 = phi_22273_;
                                    let _e10543 = phi_22274_;
                                    let _e10545 = phi_22275_;
                                    let _e10547 = phi_22276_;
                                    let _e10549 = phi_22277_;
                                    let _e10551 = phi_22278_;
                                    let _e10553 = phi_22279_;
                                    let _e10555 = phi_22280_;
                                    local_97 = _e10551;
                                    local_147 = _e10553;
                                    local_148 = _e10555;
                                    local_98 = _e10541;
                                    local_99 = _e10539;
                                    local_100 = _e10545;
                                    local_101 = _e10543;
                                    local_102 = _e10545;
                                    local_103 = _e10545;
                                    local_104 = _e10547;
                                    continue;
                                    continuing {
                                        phi_18083_ = _e8044;
                                        break if !(_e10549);
                                    }
                                }
                                let _e10558 = local_97;
                                if _e10558 {
                                    phi_22285_ = type_44(0u, type_44().member_1);
                                    phi_22286_ = false;
                                    phi_22287_ = false;
                                } else {
                                    phi_22285_ = type_44();
                                    let _e16676 = local_147;
                                    phi_22286_ = _e16676;
                                    let _e16679 = local_148;
                                    phi_22287_ = _e16679;
                                }
                                let _e10562 = phi_22285_;
                                let _e10564 = phi_22286_;
                                let _e10566 = phi_22287_;
                                if _e10564 {
                                    let _e10568 = local_98;
                                    if _e10568 {
                                        let _e10570 = local_99;
                                        let _e10573 = local_100;
                                        let _e10576 = local_101;
                                        if ((_e10570.member_1 - _e10573) <= _e10576) {
                                            let _e10579 = local_102;
                                            phi_22301_ = type_44(1u, _e10579);
                                            phi_22302_ = false;
                                        } else {
                                            phi_22301_ = type_44();
                                            phi_22302_ = true;
                                        }
                                        let _e10582 = phi_22301_;
                                        let _e10584 = phi_22302_;
                                        phi_22303_ = _e10582;
                                        phi_22304_ = _e10584;
                                    } else {
                                        phi_22303_ = type_44();
                                        phi_22304_ = true;
                                    }
                                    let _e10586 = phi_22303_;
                                    let _e10588 = phi_22304_;
                                    if _e10588 {
                                        let _e10590 = local_103;
                                        phi_22309_ = type_44(2u, _e10590);
                                    } else {
                                        phi_22309_ = _e10586;
                                    }
                                    let _e10593 = phi_22309_;
                                    phi_22310_ = _e10593;
                                    phi_22311_ = false;
                                } else {
                                    phi_22310_ = type_44();
                                    phi_22311_ = _e10566;
                                }
                                let _e10595 = phi_22310_;
                                let _e10597 = phi_22311_;
                                if _e10597 {
                                    let _e10599 = local_104;
                                    phi_22317_ = type_44(1u, _e10599.member);
                                    phi_22318_ = true;
                                } else {
                                    phi_22317_ = _e10595;
                                    phi_22318_ = _e10564;
                                }
                                let _e10603 = phi_22317_;
                                let _e10605 = phi_22318_;
                                phi_22322_ = _e10603;
                                phi_22323_ = _e10562;
                                phi_22324_ = _e10605;
                            } else {
                                phi_22322_ = _e7890;
                                phi_22323_ = type_44();
                                phi_22324_ = true;
                            }
                            let _e10607 = phi_22322_;
                            let _e10609 = phi_22323_;
                            let _e10611 = phi_22324_;
                            phi_22328_ = _e10607;
                            phi_22329_ = _e10609;
                            phi_22330_ = _e10611;
                        }
                        let _e10615 = phi_22328_;
                        let _e10617 = phi_22329_;
                        let _e10619 = phi_22330_;
                        if _e10619 {
                            phi_22334_ = _e10615;
                        } else {
                            phi_22334_ = _e10617;
                        }
                        let _e10621 = phi_22334_;
                        if (_e10621.member == 1u) {
                            if (_e10621.member_1 > _e5604) {
                                phi_22345_ = false;
                            } else {
                                phi_22345_ = true;
                            }
                            let _e10627 = phi_22345_;
                            phi_22346_ = _e10627;
                        } else {
                            phi_22346_ = true;
                        }
                        let _e10629 = phi_22346_;
                        if _e10629 {
                            phi_22350_ = false;
                        } else {
                            phi_22350_ = true;
                        }
                        let _e10631 = phi_22350_;
                        if _e10631 {
                            phi_22354_ = 1u;
                        } else {
                            phi_22354_ = 0u;
                        }
                        let _e10633 = phi_22354_;
                        phi_22358_ = type_45(_e10621, _e10633);
                    }
                    let _e15173 = phi_22358_;
                    switch bitcast<i32>(_e15173.member.member) {
                        case 0: {
                            phi_22376_ = type_28(0u, _e15173.member_1, array<u32, 2>(0u, 0u), false);
                            break;
                        }
                        case 1: {
                            let _e15184 = function_(_e15173.member.member_1);
                            phi_22376_ = type_28(0u, _e15173.member_1, _e15184, true);
                            break;
                        }
                        case 2: {
                            let _e15180 = function_(_e15173.member.member_1);
                            phi_22376_ = type_28(1u, _e15173.member_1, _e15180, true);
                            break;
                        }
                        default: {
                            phi_22376_ = type_28();
                            break;
                        }
                    }
                    let _e15188 = phi_22376_;
                    let _e15192 = params.member.member.member_12;
                    let _e15193 = bitcast<u32>(_e15192);
                    let _e15194 = (_e15193 & 2147483647u);
                    if (_e15194 < 8388608u) {
                        phi_22392_ = array<u32, 2>(0u, 0u);
                    } else {
                        phi_22392_ = array<u32, 2>((_e15193 << bitcast<u32>(29i)), ((_e15193 ^ _e15194) | ((_e15194 >> bitcast<u32>(3i)) + 939524096u)));
                    }
                    let _e15205 = phi_22392_;
                    if (_e15188.member_2[0] == _e15205[0]) {
                        let _e15211 = params.member.member.member_12;
                        let _e15212 = bitcast<u32>(_e15211);
                        let _e15213 = (_e15212 & 2147483647u);
                        if (_e15213 < 8388608u) {
                            phi_22413_ = array<u32, 2>(0u, 0u);
                        } else {
                            phi_22413_ = array<u32, 2>((_e15212 << bitcast<u32>(29i)), ((_e15212 ^ _e15213) | ((_e15213 >> bitcast<u32>(3i)) + 939524096u)));
                        }
                        let _e15224 = phi_22413_;
                        phi_22416_ = (_e15188.member_2[1] == _e15224[1]);
                    } else {
                        phi_22416_ = false;
                    }
                    let _e15228 = phi_22416_;
                    let _e15230 = params.member.member.member_1;
                    if ((_e15230 & 128u) != 0u) {
                        phi_22432_ = true;
                    } else {
                        let _e15234 = params.member.member.member_1;
                        if ((_e15234 & 64u) != 0u) {
                            phi_22431_ = _e15228;
                        } else {
                            phi_22431_ = false;
                        }
                        let _e15238 = phi_22431_;
                        phi_22432_ = _e15238;
                    }
                    let _e15240 = phi_22432_;
                    if _e15188.member_3 {
                        if _e15240 {
                            phi_22440_ = false;
                        } else {
                            phi_22440_ = true;
                        }
                        let _e15243 = phi_22440_;
                        phi_22441_ = _e15243;
                    } else {
                        phi_22441_ = true;
                    }
                    let _e15245 = phi_22441_;
                    if _e15245 {
                        phi_22446_ = _e15188.member;
                    } else {
                        phi_22446_ = 1u;
                    }
                    let _e15248 = phi_22446_;
                    phi_22451_ = type_28(_e15248, _e15188.member_1, _e15188.member_2, _e15188.member_3);
                } else {
                    phi_22451_ = _e5569;
                }
                let _e15254 = phi_22451_;
                if _e15254.member_3 {
                    phi_22458_ = (_e15254.member == 0u);
                } else {
                    phi_22458_ = false;
                }
                let _e15259 = phi_22458_;
                if _e15259 {
                    let _e15268 = (_e15254.member_2[1] >> bitcast<u32>(20i));
                    if (_e15268 <= 896u) {
                        phi_22483_ = 0u;
                    } else {
                        phi_22483_ = ((((_e15268 - 896u) << bitcast<u32>(23i)) | ((_e15254.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e15254.member_2[0] >> bitcast<u32>(29i)));
                    }
                    let _e15283 = phi_22483_;
                    let _e15285 = atomicMin((&earliest.member[0u]), _e15283);
                }
                phi_22487_ = type_20(_e270, 0u, _e280, _e283, _e15254.member_2, _e15254.member_1);
                phi_22488_ = _e15259;
                phi_22489_ = (_e15254.member != 0u);
            } else {
                phi_22487_ = type_20(_e270, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_22488_ = false;
                phi_22489_ = false;
            }
            let _e15287 = phi_22487_;
            let _e15289 = phi_22488_;
            let _e15291 = phi_22489_;
            let _e15294 = params.member.member.member_1;
            if ((_e15294 & 16u) != 0u) {
                if (_e186 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e15289 {
                    let _e15300 = atomicAdd((&counters[0u]), 1u);
                    phi_22508_ = _e15300;
                } else {
                    phi_22508_ = 0u;
                }
                let _e15302 = phi_22508_;
                workgroupBarrier();
                if (_e186 == 0u) {
                    let _e15305 = atomicLoad((&counters[0u]));
                    if (_e15305 > 0u) {
                        let _e15308 = atomicAdd((&contacts.member[0u]), _e15305);
                        atomicStore((&counters[1u]), _e15308);
                    }
                }
                workgroupBarrier();
                let _e15311 = atomicLoad((&counters[1u]));
                let _e15312 = (_e15311 + _e15302);
                if _e15289 {
                    let _e15315 = params.member.member_1.member_3;
                    if (_e15312 < _e15315) {
                        let _e15317 = (7u * _e15312);
                        atomicStore((&contacts.member[(4u + _e15317)]), _e15287.member);
                        atomicStore((&contacts.member[(_e15317 + 5u)]), _e15287.member_1);
                        atomicStore((&contacts.member[(_e15317 + 6u)]), _e15287.member_2);
                        atomicStore((&contacts.member[(_e15317 + 7u)]), _e15287.member_3);
                        atomicStore((&contacts.member[(_e15317 + 8u)]), _e15287.member_4[0]);
                        atomicStore((&contacts.member[(_e15317 + 9u)]), _e15287.member_4[1]);
                        atomicStore((&contacts.member[(_e15317 + 10u)]), _e15287.member_5);
                    }
                }
            }
            workgroupBarrier();
            if (_e186 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e15291 {
                let _e15344 = atomicAdd((&counters[0u]), 1u);
                phi_22575_ = _e15344;
            } else {
                phi_22575_ = 0u;
            }
            let _e15346 = phi_22575_;
            workgroupBarrier();
            if (_e186 == 0u) {
                let _e15349 = atomicLoad((&counters[0u]));
                if (_e15349 > 0u) {
                    let _e15352 = atomicAdd((&undecided.member[0u]), _e15349);
                    atomicStore((&counters[1u]), _e15352);
                }
            }
            workgroupBarrier();
            let _e15355 = atomicLoad((&counters[1u]));
            let _e15356 = (_e15355 + _e15346);
            if _e15291 {
                let _e15362 = params.member.member_2.member.member_1;
                if (_e15356 < _e15362) {
                    let _e15364 = (2u * _e15356);
                    atomicStore((&undecided.member[(4u + _e15364)]), _e15287.member_2);
                    atomicStore((&undecided.member[(_e15364 + 5u)]), _e15287.member_3);
                }
            }
        }
        continue;
        continuing {
            phi_421_ = _e256;
            break if !(_e262);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_14(id, n, lane);
}
