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

struct type_16 {
    member: f32,
    member_1: f32,
}

struct type_18 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
    member_5: u32,
}

struct type_21 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
}

struct type_22 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_23 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_25 {
    member: array<type_23>,
}

struct type_28 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_29 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_30 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
    member_2: array<f32, 4>,
}

struct type_34 {
    member: array<array<array<f32, 3>, 4>, 2>,
    member_1: f32,
    member_2: f32,
}

struct type_36 {
    member: type_9,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_37 {
    member: type_7,
    member_1: type_8,
    member_2: type_36,
}

struct type_38 {
    member: type_37,
}

struct type_44 {
    member: type_28,
    member_1: f32,
}

struct type_45 {
    member: u32,
    member_1: f32,
}

struct type_46 {
    member: type_45,
    member_1: u32,
}

struct type_47 {
    member: u32,
    member_1: f32,
    member_2: f32,
}

struct type_48 {
    member: f32,
    member_1: f32,
    member_2: bool,
}

struct type_52 {
    member: array<atomic<u32>>,
}

@group(0) @binding(4) 
var<storage> input: type_11;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(1) 
var<storage> paths: type_25;
@group(0) @binding(3) 
var<storage> elements: type_11;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_52;
@group(0) @binding(0) 
var<storage> params: type_38;
@group(0) @binding(2) 
var<storage> positions: type_11;
@group(0) @binding(6) 
var<storage, read_write> undecided: type_52;
@group(0) @binding(7) 
var<storage, read_write> earliest: type_52;

fn function_(param: f32, param_1: f32) -> f32 {
    var phi_272_: bool;
    var phi_276_: f32;

    if (param != param) {
        phi_272_ = true;
    } else {
        phi_272_ = (param_1 >= param);
    }
    let _e6 = phi_272_;
    if _e6 {
        phi_276_ = param_1;
    } else {
        phi_276_ = param;
    }
    let _e8 = phi_276_;
    return _e8;
}

fn function_1(param_2: f32) -> array<u32, 2> {
    var phi_23655_: array<u32, 2>;

    let _e7 = bitcast<u32>(param_2);
    let _e8 = (_e7 & 2147483647u);
    if (_e8 < 8388608u) {
        phi_23655_ = array<u32, 2>(0u, 0u);
    } else {
        phi_23655_ = array<u32, 2>((_e7 << bitcast<u32>(29i)), ((_e7 ^ _e8) | ((_e8 >> bitcast<u32>(3i)) + 939524096u)));
    }
    let _e19 = phi_23655_;
    return _e19;
}

fn function_2(param_3: array<f32, 3>, param_4: array<f32, 3>) -> array<f32, 3> {
    var phi_23640_: array<f32, 3>;

    if ((((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])) < (((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2]))) {
        phi_23640_ = param_4;
    } else {
        phi_23640_ = param_3;
    }
    let _e26 = phi_23640_;
    return _e26;
}

fn function_3(param_5: array<f32, 3>, param_6: array<f32, 3>, param_7: array<f32, 3>, param_8: u32) -> array<f32, 3> {
    var phi_23501_: f32;
    var phi_23502_: f32;
    var phi_23541_: f32;
    var phi_23542_: f32;
    var phi_23587_: f32;
    var phi_23588_: f32;
    var phi_23322_: f32;
    var phi_23323_: f32;
    var phi_23368_: f32;
    var phi_23369_: f32;
    var phi_23411_: f32;
    var phi_23412_: f32;
    var phi_23460_: f32;
    var phi_23461_: f32;
    var phi_23603_: array<array<f32, 3>, 4>;

    let _e9 = (param_5[0] - param_6[0]);
    let _e12 = (param_5[1] - param_6[1]);
    let _e15 = (param_5[2] - param_6[2]);
    if (param_8 != 0u) {
        let _e157 = ((((param_5[0] * param_6[0]) + (param_5[1] * param_6[1])) + (param_5[2] * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        if (_e157 > 0f) {
            if (_e157 < 1f) {
                phi_23322_ = _e157;
            } else {
                phi_23322_ = 1f;
            }
            let _e161 = phi_23322_;
            phi_23323_ = _e161;
        } else {
            phi_23323_ = 0f;
        }
        let _e163 = phi_23323_;
        let _e199 = ((((param_5[0] * param_7[0]) + (param_5[1] * param_7[1])) + (param_5[2] * param_7[2])) / (((param_7[0] * param_7[0]) + (param_7[1] * param_7[1])) + (param_7[2] * param_7[2])));
        if (_e199 > 0f) {
            if (_e199 < 1f) {
                phi_23368_ = _e199;
            } else {
                phi_23368_ = 1f;
            }
            let _e203 = phi_23368_;
            phi_23369_ = _e203;
        } else {
            phi_23369_ = 0f;
        }
        let _e205 = phi_23369_;
        let _e238 = ((((_e9 * param_7[0]) + (_e12 * param_7[1])) + (_e15 * param_7[2])) / (((param_7[0] * param_7[0]) + (param_7[1] * param_7[1])) + (param_7[2] * param_7[2])));
        if (_e238 > 0f) {
            if (_e238 < 1f) {
                phi_23411_ = _e238;
            } else {
                phi_23411_ = 1f;
            }
            let _e242 = phi_23411_;
            phi_23412_ = _e242;
        } else {
            phi_23412_ = 0f;
        }
        let _e244 = phi_23412_;
        let _e257 = (param_5[0] - param_7[0]);
        let _e260 = (param_5[1] - param_7[1]);
        let _e263 = (param_5[2] - param_7[2]);
        let _e283 = ((((_e257 * param_6[0]) + (_e260 * param_6[1])) + (_e263 * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        if (_e283 > 0f) {
            if (_e283 < 1f) {
                phi_23460_ = _e283;
            } else {
                phi_23460_ = 1f;
            }
            let _e287 = phi_23460_;
            phi_23461_ = _e287;
        } else {
            phi_23461_ = 0f;
        }
        let _e289 = phi_23461_;
        phi_23603_ = array<array<f32, 3>, 4>(array<f32, 3>((param_5[0] - (param_6[0] * _e163)), (param_5[1] - (param_6[1] * _e163)), (param_5[2] - (param_6[2] * _e163))), array<f32, 3>((param_5[0] - (param_7[0] * _e205)), (param_5[1] - (param_7[1] * _e205)), (param_5[2] - (param_7[2] * _e205))), array<f32, 3>((_e9 - (param_7[0] * _e244)), (_e12 - (param_7[1] * _e244)), (_e15 - (param_7[2] * _e244))), array<f32, 3>((_e257 - (param_6[0] * _e289)), (_e260 - (param_6[1] * _e289)), (_e263 - (param_6[2] * _e289))));
    } else {
        let _e19 = (param_7[0] - param_6[0]);
        let _e22 = (param_7[1] - param_6[1]);
        let _e25 = (param_7[2] - param_6[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        if (_e36 > 0f) {
            if (_e36 < 1f) {
                phi_23501_ = _e36;
            } else {
                phi_23501_ = 1f;
            }
            let _e40 = phi_23501_;
            phi_23502_ = _e40;
        } else {
            phi_23502_ = 0f;
        }
        let _e42 = phi_23502_;
        let _e49 = array<f32, 3>((_e9 - (_e19 * _e42)), (_e12 - (_e22 * _e42)), (_e15 - (_e25 * _e42)));
        let _e72 = ((((param_5[0] * param_6[0]) + (param_5[1] * param_6[1])) + (param_5[2] * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        if (_e72 > 0f) {
            if (_e72 < 1f) {
                phi_23541_ = _e72;
            } else {
                phi_23541_ = 1f;
            }
            let _e76 = phi_23541_;
            phi_23542_ = _e76;
        } else {
            phi_23542_ = 0f;
        }
        let _e78 = phi_23542_;
        let _e114 = ((((param_5[0] * param_7[0]) + (param_5[1] * param_7[1])) + (param_5[2] * param_7[2])) / (((param_7[0] * param_7[0]) + (param_7[1] * param_7[1])) + (param_7[2] * param_7[2])));
        if (_e114 > 0f) {
            if (_e114 < 1f) {
                phi_23587_ = _e114;
            } else {
                phi_23587_ = 1f;
            }
            let _e118 = phi_23587_;
            phi_23588_ = _e118;
        } else {
            phi_23588_ = 0f;
        }
        let _e120 = phi_23588_;
        phi_23603_ = array<array<f32, 3>, 4>(array<f32, 3>((param_5[0] - (param_6[0] * _e78)), (param_5[1] - (param_6[1] * _e78)), (param_5[2] - (param_6[2] * _e78))), array<f32, 3>((param_5[0] - (param_7[0] * _e120)), (param_5[1] - (param_7[1] * _e120)), (param_5[2] - (param_7[2] * _e120))), _e49, _e49);
    }
    let _e302 = phi_23603_;
    let _e305 = function_2(_e302[0], _e302[1]);
    let _e307 = function_2(_e305, _e302[2]);
    let _e309 = function_2(_e307, _e302[3]);
    return _e309;
}

fn function_4(param_9: array<f32, 3>, param_10: array<f32, 3>, param_11: array<f32, 3>, param_12: u32) -> array<f32, 3> {
    var phi_23223_: bool;
    var phi_23224_: bool;
    var phi_23225_: bool;
    var phi_23226_: bool;
    var phi_23230_: bool;
    var phi_23203_: bool;
    var phi_23204_: bool;
    var phi_23205_: bool;
    var phi_23206_: bool;
    var phi_23207_: bool;
    var phi_23208_: bool;
    var phi_23212_: bool;
    var phi_23231_: bool;
    var phi_23264_: array<f32, 3>;
    var phi_23265_: bool;
    var phi_23266_: array<f32, 3>;
    var phi_23267_: bool;
    var phi_23272_: array<f32, 3>;

    let _e23 = (((param_10[0] * param_10[0]) + (param_10[1] * param_10[1])) + (param_10[2] * param_10[2]));
    let _e34 = (((param_10[0] * param_11[0]) + (param_10[1] * param_11[1])) + (param_10[2] * param_11[2]));
    let _e45 = (((param_11[0] * param_11[0]) + (param_11[1] * param_11[1])) + (param_11[2] * param_11[2]));
    let _e56 = (((param_9[0] * param_10[0]) + (param_9[1] * param_10[1])) + (param_9[2] * param_10[2]));
    let _e67 = (((param_9[0] * param_11[0]) + (param_9[1] * param_11[1])) + (param_9[2] * param_11[2]));
    let _e70 = ((_e23 * _e45) - (_e34 * _e34));
    let _e74 = (((_e56 * _e45) - (_e67 * _e34)) / _e70);
    let _e78 = (((_e67 * _e23) - (_e56 * _e34)) / _e70);
    if (param_12 != 0u) {
        if (_e74 >= 0f) {
            if (_e78 >= 0f) {
                if (_e74 <= 1f) {
                    phi_23203_ = (_e78 <= 1f);
                    phi_23204_ = false;
                } else {
                    phi_23203_ = bool();
                    phi_23204_ = true;
                }
                let _e99 = phi_23203_;
                let _e101 = phi_23204_;
                phi_23205_ = _e99;
                phi_23206_ = _e101;
            } else {
                phi_23205_ = bool();
                phi_23206_ = true;
            }
            let _e103 = phi_23205_;
            let _e105 = phi_23206_;
            phi_23207_ = _e103;
            phi_23208_ = _e105;
        } else {
            phi_23207_ = bool();
            phi_23208_ = true;
        }
        let _e107 = phi_23207_;
        let _e109 = phi_23208_;
        if _e109 {
            phi_23212_ = false;
        } else {
            phi_23212_ = _e107;
        }
        let _e111 = phi_23212_;
        phi_23231_ = _e111;
    } else {
        if (_e74 >= 0f) {
            if (_e78 >= 0f) {
                phi_23223_ = ((_e74 + _e78) <= 1f);
                phi_23224_ = false;
            } else {
                phi_23223_ = bool();
                phi_23224_ = true;
            }
            let _e85 = phi_23223_;
            let _e87 = phi_23224_;
            phi_23225_ = _e85;
            phi_23226_ = _e87;
        } else {
            phi_23225_ = bool();
            phi_23226_ = true;
        }
        let _e89 = phi_23225_;
        let _e91 = phi_23226_;
        if _e91 {
            phi_23230_ = false;
        } else {
            phi_23230_ = _e89;
        }
        let _e93 = phi_23230_;
        phi_23231_ = _e93;
    }
    let _e113 = phi_23231_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e113 {
            phi_23264_ = array<f32, 3>((param_9[0] - ((param_10[0] * _e74) + (param_11[0] * _e78))), (param_9[1] - ((param_10[1] * _e74) + (param_11[1] * _e78))), (param_9[2] - ((param_10[2] * _e74) + (param_11[2] * _e78))));
            phi_23265_ = false;
        } else {
            phi_23264_ = array<f32, 3>();
            phi_23265_ = true;
        }
        let _e141 = phi_23264_;
        let _e143 = phi_23265_;
        phi_23266_ = _e141;
        phi_23267_ = _e143;
    } else {
        phi_23266_ = array<f32, 3>();
        phi_23267_ = true;
    }
    let _e145 = phi_23266_;
    let _e147 = phi_23267_;
    if _e147 {
        let _e148 = function_3(param_9, param_10, param_11, param_12);
        phi_23272_ = _e148;
    } else {
        phi_23272_ = _e145;
    }
    let _e150 = phi_23272_;
    return _e150;
}

fn function_5(param_13: u32, param_14: u32, param_15: u32) -> type_9 {
    var phi_22921_: u32;
    var phi_22928_: type_9;
    var phi_22970_: u32;
    var phi_22988_: u32;
    var phi_22995_: type_9;

    if ((param_13 >> bitcast<u32>(31i)) != 0u) {
        if (param_14 == 0u) {
            phi_22921_ = 1u;
        } else {
            phi_22921_ = 0u;
        }
        let _e15 = phi_22921_;
        phi_22928_ = type_9((~(param_13) + _e15), (~(param_14) + 1u));
    } else {
        phi_22928_ = type_9(param_13, param_14);
    }
    let _e22 = phi_22928_;
    let _e26 = (_e22.member >> bitcast<u32>(16i));
    let _e27 = (_e22.member & 65535u);
    let _e29 = (param_15 >> bitcast<u32>(16i));
    let _e30 = (param_15 & 65535u);
    let _e35 = ((_e26 * _e30) + ((_e27 * _e30) >> bitcast<u32>(16i)));
    let _e46 = (_e22.member * param_15);
    let _e48 = (_e22.member_1 >> bitcast<u32>(16i));
    let _e49 = (_e22.member_1 & 65535u);
    let _e51 = (param_15 >> bitcast<u32>(16i));
    let _e52 = (param_15 & 65535u);
    let _e57 = ((_e48 * _e52) + ((_e49 * _e52) >> bitcast<u32>(16i)));
    let _e69 = (_e46 + (((_e48 * _e51) + (_e57 >> bitcast<u32>(16i))) + (((_e49 * _e51) + (_e57 & 65535u)) >> bitcast<u32>(16i))));
    if (_e69 < _e46) {
        phi_22970_ = 1u;
    } else {
        phi_22970_ = 0u;
    }
    let _e72 = phi_22970_;
    let _e78 = ((((((_e26 * _e29) + (_e35 >> bitcast<u32>(16i))) + (((_e27 * _e29) + (_e35 & 65535u)) >> bitcast<u32>(16i))) + _e72) << bitcast<u32>(1i)) | (_e69 >> bitcast<u32>(31i)));
    let _e83 = ((_e69 << bitcast<u32>(1i)) | ((_e22.member_1 * param_15) >> bitcast<u32>(31i)));
    if ((param_13 >> bitcast<u32>(31i)) != 0u) {
        if (_e83 == 0u) {
            phi_22988_ = 1u;
        } else {
            phi_22988_ = 0u;
        }
        let _e90 = phi_22988_;
        phi_22995_ = type_9((~(_e78) + _e90), (~(_e83) + 1u));
    } else {
        phi_22995_ = type_9(_e78, _e83);
    }
    let _e97 = phi_22995_;
    return _e97;
}

fn function_6(param_16: array<type_9, 3>, param_17: u32) -> array<type_9, 2> {
    var phi_23073_: u32;
    var phi_23085_: u32;
    var phi_23096_: u32;
    var phi_23108_: u32;

    if (param_16[1].member_1 < param_16[0].member_1) {
        phi_23073_ = 1u;
    } else {
        phi_23073_ = 0u;
    }
    let _e14 = phi_23073_;
    let _e18 = function_5(((param_16[1].member - param_16[0].member) - _e14), (param_16[1].member_1 - param_16[0].member_1), param_17);
    let _e21 = (param_16[0].member_1 + _e18.member_1);
    if (_e21 < param_16[0].member_1) {
        phi_23085_ = 1u;
    } else {
        phi_23085_ = 0u;
    }
    let _e24 = phi_23085_;
    if (param_16[2].member_1 < param_16[1].member_1) {
        phi_23096_ = 1u;
    } else {
        phi_23096_ = 0u;
    }
    let _e37 = phi_23096_;
    let _e41 = function_5(((param_16[2].member - param_16[1].member) - _e37), (param_16[2].member_1 - param_16[1].member_1), param_17);
    let _e44 = (param_16[1].member_1 + _e41.member_1);
    if (_e44 < param_16[1].member_1) {
        phi_23108_ = 1u;
    } else {
        phi_23108_ = 0u;
    }
    let _e47 = phi_23108_;
    return array<type_9, 2>(type_9(((param_16[0].member + _e18.member) + _e24), _e21), type_9(((param_16[1].member + _e41.member) + _e47), _e44));
}

fn function_7(param_18: u32, param_19: u32, param_20: u32, param_21: u32) -> bool {
    var phi_23057_: u32;

    if (param_21 < param_19) {
        phi_23057_ = 1u;
    } else {
        phi_23057_ = 0u;
    }
    let _e9 = phi_23057_;
    return ((((param_20 - param_18) - _e9) >> bitcast<u32>(31i)) != 0u);
}

fn function_8(param_22: u32, param_23: u32, param_24: u32, param_25: u32) -> bool {
    var phi_23034_: u32;
    var phi_23043_: u32;

    if (param_23 == 0u) {
        phi_23034_ = 1u;
    } else {
        phi_23034_ = 0u;
    }
    let _e9 = phi_23034_;
    if (param_25 < (~(param_23) + 1u)) {
        phi_23043_ = 1u;
    } else {
        phi_23043_ = 0u;
    }
    let _e16 = phi_23043_;
    return ((((param_24 - (~(param_22) + _e9)) - _e16) >> bitcast<u32>(31i)) != 0u);
}

fn function_9(param_26: u32, param_27: u32, param_28: u32, param_29: u32) -> type_9 {
    var phi_22746_: u32;
    var phi_22753_: type_9;
    var phi_22765_: u32;
    var phi_22772_: type_9;
    var phi_22831_: u32;
    var phi_22837_: u32;
    var phi_22845_: u32;
    var phi_22853_: u32;
    var phi_22874_: u32;
    var phi_22881_: type_9;

    if ((param_26 >> bitcast<u32>(31i)) != 0u) {
        if (param_27 == 0u) {
            phi_22746_ = 1u;
        } else {
            phi_22746_ = 0u;
        }
        let _e17 = phi_22746_;
        phi_22753_ = type_9((~(param_26) + _e17), (~(param_27) + 1u));
    } else {
        phi_22753_ = type_9(param_26, param_27);
    }
    let _e24 = phi_22753_;
    if ((param_28 >> bitcast<u32>(31i)) != 0u) {
        if (param_29 == 0u) {
            phi_22765_ = 1u;
        } else {
            phi_22765_ = 0u;
        }
        let _e33 = phi_22765_;
        phi_22772_ = type_9((~(param_28) + _e33), (~(param_29) + 1u));
    } else {
        phi_22772_ = type_9(param_28, param_29);
    }
    let _e40 = phi_22772_;
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
        phi_22831_ = 1u;
    } else {
        phi_22831_ = 0u;
    }
    let _e112 = phi_22831_;
    let _e113 = (_e64 + (((_e66 * _e69) + (_e75 >> bitcast<u32>(16i))) + (((_e67 * _e69) + (_e75 & 65535u)) >> bitcast<u32>(16i))));
    if (_e113 < _e64) {
        phi_22837_ = 1u;
    } else {
        phi_22837_ = 0u;
    }
    let _e116 = phi_22837_;
    let _e118 = (_e113 + (((_e88 * _e91) + (_e97 >> bitcast<u32>(16i))) + (((_e89 * _e91) + (_e97 & 65535u)) >> bitcast<u32>(16i))));
    if (_e118 < _e113) {
        phi_22845_ = 1u;
    } else {
        phi_22845_ = 0u;
    }
    let _e121 = phi_22845_;
    let _e123 = (_e118 + _e112);
    if (_e123 < _e118) {
        phi_22853_ = 1u;
    } else {
        phi_22853_ = 0u;
    }
    let _e126 = phi_22853_;
    let _e132 = ((_e123 << bitcast<u32>(2i)) | (_e109 >> bitcast<u32>(30i)));
    let _e137 = ((((((((_e44 * _e47) + (_e53 >> bitcast<u32>(16i))) + (((_e45 * _e47) + (_e53 & 65535u)) >> bitcast<u32>(16i))) + _e116) + _e121) + _e126) << bitcast<u32>(2i)) | (_e123 >> bitcast<u32>(30i)));
    if (((param_26 >> bitcast<u32>(31i)) != 0u) != ((param_28 >> bitcast<u32>(31i)) != 0u)) {
        if (_e132 == 0u) {
            phi_22874_ = 1u;
        } else {
            phi_22874_ = 0u;
        }
        let _e148 = phi_22874_;
        phi_22881_ = type_9((~(_e137) + _e148), (~(_e132) + 1u));
    } else {
        phi_22881_ = type_9(_e137, _e132);
    }
    let _e155 = phi_22881_;
    return _e155;
}

fn function_10(param_30: array<type_9, 2>, param_31: array<type_9, 2>) -> type_9 {
    var phi_23020_: u32;

    let _e12 = function_9(param_30[0].member, param_30[0].member_1, param_31[1].member, param_31[1].member_1);
    let _e23 = function_9(param_30[1].member, param_30[1].member_1, param_31[0].member, param_31[0].member_1);
    if (_e12.member_1 < _e23.member_1) {
        phi_23020_ = 1u;
    } else {
        phi_23020_ = 0u;
    }
    let _e28 = phi_23020_;
    return type_9(((_e12.member - _e23.member) - _e28), (_e12.member_1 - _e23.member_1));
}

fn function_11(param_32: u32) -> type_9 {
    return type_9(0u, param_32);
}

fn function_12(param_33: u32, param_34: u32) -> type_9 {
    var phi_22893_: u32;
    var phi_22901_: u32;

    let _e4 = (param_34 + param_34);
    if (_e4 < param_34) {
        phi_22893_ = 1u;
    } else {
        phi_22893_ = 0u;
    }
    let _e7 = phi_22893_;
    let _e10 = (_e4 + param_34);
    if (_e10 < _e4) {
        phi_22901_ = 1u;
    } else {
        phi_22901_ = 0u;
    }
    let _e13 = phi_22901_;
    return type_9(((((param_33 + param_33) + _e7) + param_33) + _e13), _e10);
}

fn function_13(param_35: array<u32, 2>, param_36: i32) -> type_9 {
    var phi_22633_: u32;
    var phi_22640_: u32;
    var phi_22699_: type_9;
    var phi_22700_: type_9;
    var phi_22701_: type_9;
    var phi_22702_: type_9;
    var phi_22703_: type_9;
    var phi_22704_: bool;
    var phi_22709_: type_9;
    var phi_22721_: u32;
    var phi_22728_: type_9;

    let _e25 = ((param_35[1] >> bitcast<u32>(20i)) & 2047u);
    if (_e25 == 0u) {
        phi_22633_ = 0u;
    } else {
        phi_22633_ = 1048576u;
    }
    let _e28 = phi_22633_;
    let _e30 = ((param_35[1] & 1048575u) | _e28);
    if (1u < _e25) {
        phi_22640_ = _e25;
    } else {
        phi_22640_ = 1u;
    }
    let _e33 = phi_22640_;
    let _e36 = ((bitcast<i32>(_e33) - 1015i) - param_36);
    let _e38 = (bitcast<u32>(_e36) % 32u);
    if (_e36 >= 64i) {
        phi_22703_ = type_9();
        phi_22704_ = true;
    } else {
        let _e40 = (_e36 <= -53i);
        if _e40 {
            phi_22702_ = type_9();
        } else {
            if (_e36 >= 32i) {
                phi_22701_ = type_9((param_35[0] << bitcast<u32>((_e38 & 31u))), 0u);
            } else {
                if (_e36 >= 0i) {
                    phi_22700_ = type_9(((_e30 << bitcast<u32>((_e38 & 31u))) | ((param_35[0] >> bitcast<u32>(1i)) >> bitcast<u32>(((31u - _e38) & 31u)))), (param_35[0] << bitcast<u32>((_e38 & 31u))));
                } else {
                    if (_e36 > -32i) {
                        let _e52 = bitcast<u32>(-(_e36));
                        phi_22699_ = type_9(bitcast<u32>((bitcast<i32>(_e30) >> bitcast<u32>((_e52 & 31u)))), ((param_35[0] >> bitcast<u32>((_e52 & 31u))) | ((_e30 << bitcast<u32>(((31u - _e52) & 31u))) << bitcast<u32>(1i))));
                    } else {
                        phi_22699_ = type_9(0u, (_e30 >> bitcast<u32>(((bitcast<u32>(-(_e36)) - 32u) & 31u))));
                    }
                    let _e70 = phi_22699_;
                    phi_22700_ = _e70;
                }
                let _e86 = phi_22700_;
                phi_22701_ = _e86;
            }
            let _e92 = phi_22701_;
            phi_22702_ = _e92;
        }
        let _e94 = phi_22702_;
        phi_22703_ = _e94;
        phi_22704_ = _e40;
    }
    let _e96 = phi_22703_;
    let _e98 = phi_22704_;
    if _e98 {
        phi_22709_ = type_9(0u, 0u);
    } else {
        phi_22709_ = _e96;
    }
    let _e100 = phi_22709_;
    if ((param_35[1] >> bitcast<u32>(31i)) != 0u) {
        if (_e100.member_1 == 0u) {
            phi_22721_ = 1u;
        } else {
            phi_22721_ = 0u;
        }
        let _e108 = phi_22721_;
        phi_22728_ = type_9((~(_e100.member) + _e108), (~(_e100.member_1) + 1u));
    } else {
        phi_22728_ = _e100;
    }
    let _e115 = phi_22728_;
    return _e115;
}

fn function_14(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_30;
    var local_1: type_30;
    var local_2: type_21;
    var local_3: type_21;
    var local_4: type_21;
    var local_5: array<type_16, 4>;
    var local_6: array<f32, 4>;
    var local_7: array<f32, 2>;
    var local_8: type_30;
    var local_9: type_30;
    var local_10: type_30;
    var local_11: type_30;
    var local_12: array<f32, 4>;
    var local_13: array<f32, 3>;
    var local_14: type_34;
    var local_15: type_30;
    var local_16: type_30;
    var local_17: type_30;
    var local_18: type_28;
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
    var phi_380_: u32;
    var phi_390_: u32;
    var phi_397_: u32;
    var phi_413_: u32;
    var phi_434_: u32;
    var phi_435_: u32;
    var phi_438_: type_9;
    var phi_439_: type_9;
    var phi_462_: type_9;
    var phi_598_: type_22;
    var phi_1012_: type_28;
    var phi_1020_: f32;
    var phi_1027_: f32;
    var phi_1032_: f32;
    var phi_1039_: f32;
    var phi_1044_: f32;
    var phi_1052_: f32;
    var phi_1059_: f32;
    var phi_1064_: f32;
    var phi_1071_: f32;
    var phi_1076_: f32;
    var phi_1081_: f32;
    var phi_1091_: f32;
    var phi_1098_: f32;
    var phi_1103_: f32;
    var phi_1110_: f32;
    var phi_1115_: f32;
    var phi_1123_: f32;
    var phi_1130_: f32;
    var phi_1135_: f32;
    var phi_1142_: f32;
    var phi_1147_: f32;
    var phi_1152_: f32;
    var phi_1162_: f32;
    var phi_1169_: f32;
    var phi_1174_: f32;
    var phi_1181_: f32;
    var phi_1186_: f32;
    var phi_1194_: f32;
    var phi_1201_: f32;
    var phi_1206_: f32;
    var phi_1213_: f32;
    var phi_1218_: f32;
    var phi_1223_: f32;
    var phi_1241_: i32;
    var phi_1242_: bool;
    var phi_1243_: i32;
    var phi_1244_: bool;
    var phi_1248_: i32;
    var phi_1290_: array<u32, 2>;
    var phi_1307_: array<u32, 2>;
    var phi_1324_: array<u32, 2>;
    var phi_1358_: array<u32, 2>;
    var phi_1375_: array<u32, 2>;
    var phi_1392_: array<u32, 2>;
    var phi_1427_: array<u32, 2>;
    var phi_1444_: array<u32, 2>;
    var phi_1461_: array<u32, 2>;
    var phi_1495_: array<u32, 2>;
    var phi_1512_: array<u32, 2>;
    var phi_1529_: array<u32, 2>;
    var phi_1564_: array<u32, 2>;
    var phi_1581_: array<u32, 2>;
    var phi_1598_: array<u32, 2>;
    var phi_1632_: array<u32, 2>;
    var phi_1649_: array<u32, 2>;
    var phi_1666_: array<u32, 2>;
    var phi_1701_: array<u32, 2>;
    var phi_1718_: array<u32, 2>;
    var phi_1735_: array<u32, 2>;
    var phi_1769_: array<u32, 2>;
    var phi_1786_: array<u32, 2>;
    var phi_1803_: array<u32, 2>;
    var phi_2720_: array<array<array<type_9, 3>, 2>, 4>;
    var phi_3009_: u32;
    var phi_3021_: u32;
    var phi_3033_: u32;
    var phi_3053_: u32;
    var phi_3065_: u32;
    var phi_3077_: u32;
    var phi_3098_: u32;
    var phi_3110_: u32;
    var phi_3122_: u32;
    var phi_3142_: u32;
    var phi_3154_: u32;
    var phi_3166_: u32;
    var phi_3187_: u32;
    var phi_3199_: u32;
    var phi_3211_: u32;
    var phi_3231_: u32;
    var phi_3243_: u32;
    var phi_3255_: u32;
    var phi_2741_: u32;
    var phi_2753_: u32;
    var phi_2765_: u32;
    var phi_2785_: u32;
    var phi_2797_: u32;
    var phi_2809_: u32;
    var phi_2830_: u32;
    var phi_2842_: u32;
    var phi_2854_: u32;
    var phi_2874_: u32;
    var phi_2886_: u32;
    var phi_2898_: u32;
    var phi_2919_: u32;
    var phi_2931_: u32;
    var phi_2943_: u32;
    var phi_2963_: u32;
    var phi_2975_: u32;
    var phi_2987_: u32;
    var phi_3267_: array<array<array<type_9, 3>, 2>, 3>;
    var phi_3346_: u32;
    var phi_3426_: u32;
    var phi_3506_: u32;
    var phi_3594_: u32;
    var phi_3674_: u32;
    var phi_3754_: u32;
    var phi_3842_: u32;
    var phi_3922_: u32;
    var phi_4002_: u32;
    var phi_4090_: u32;
    var phi_4170_: u32;
    var phi_4250_: u32;
    var phi_4269_: u32;
    var phi_4281_: u32;
    var phi_4293_: u32;
    var phi_4322_: u32;
    var phi_4337_: u32;
    var phi_4363_: u32;
    var phi_4378_: u32;
    var phi_4401_: u32;
    var phi_4416_: u32;
    var phi_4424_: u32;
    var phi_4447_: u32;
    var phi_4462_: u32;
    var phi_4485_: u32;
    var phi_4500_: u32;
    var phi_4508_: u32;
    var phi_4531_: u32;
    var phi_4546_: u32;
    var phi_4562_: type_9;
    var phi_4565_: array<type_9, 4>;
    var phi_4569_: u32;
    var phi_4571_: u32;
    var phi_4563_: type_9;
    var phi_4594_: type_9;
    var phi_4629_: u32;
    var phi_4636_: type_9;
    var phi_4643_: u32;
    var phi_4656_: u32;
    var phi_4657_: u32;
    var phi_4672_: u32;
    var phi_4679_: type_9;
    var phi_4686_: u32;
    var phi_4699_: u32;
    var phi_4700_: u32;
    var phi_4716_: u32;
    var phi_4723_: type_9;
    var phi_4730_: u32;
    var phi_4743_: u32;
    var phi_4744_: u32;
    var phi_4760_: u32;
    var phi_4767_: type_9;
    var phi_4774_: u32;
    var phi_4787_: u32;
    var phi_4788_: u32;
    var phi_4791_: bool;
    var phi_4814_: bool;
    var phi_4815_: bool;
    var phi_4816_: bool;
    var phi_4834_: u32;
    var phi_4841_: type_9;
    var phi_4848_: u32;
    var phi_4861_: u32;
    var phi_4862_: u32;
    var phi_4877_: u32;
    var phi_4884_: type_9;
    var phi_4891_: u32;
    var phi_4904_: u32;
    var phi_4905_: u32;
    var phi_4912_: bool;
    var phi_4920_: u32;
    var phi_4938_: u32;
    var phi_4950_: u32;
    var phi_4962_: u32;
    var phi_4983_: u32;
    var phi_4990_: type_9;
    var phi_5004_: u32;
    var phi_5011_: type_9;
    var phi_5018_: u32;
    var phi_5028_: type_9;
    var phi_5042_: u32;
    var phi_5049_: type_9;
    var phi_5056_: u32;
    var phi_5066_: type_9;
    var phi_5077_: u32;
    var phi_5099_: u32;
    var phi_5112_: u32;
    var phi_5124_: u32;
    var phi_5136_: u32;
    var phi_5157_: u32;
    var phi_5164_: type_9;
    var phi_5178_: u32;
    var phi_5185_: type_9;
    var phi_5192_: u32;
    var phi_5202_: type_9;
    var phi_5216_: u32;
    var phi_5223_: type_9;
    var phi_5230_: u32;
    var phi_5240_: type_9;
    var phi_5251_: u32;
    var phi_5273_: u32;
    var phi_5286_: u32;
    var phi_5298_: u32;
    var phi_5310_: u32;
    var phi_5331_: u32;
    var phi_5338_: type_9;
    var phi_5352_: u32;
    var phi_5359_: type_9;
    var phi_5366_: u32;
    var phi_5376_: type_9;
    var phi_5390_: u32;
    var phi_5397_: type_9;
    var phi_5404_: u32;
    var phi_5414_: type_9;
    var phi_5425_: u32;
    var phi_5447_: u32;
    var phi_5468_: u32;
    var phi_5480_: u32;
    var phi_5491_: u32;
    var phi_5503_: u32;
    var phi_5514_: u32;
    var phi_5526_: u32;
    var phi_5545_: u32;
    var phi_5557_: u32;
    var phi_5568_: u32;
    var phi_5580_: u32;
    var phi_5591_: u32;
    var phi_5603_: u32;
    var phi_5622_: u32;
    var phi_5634_: u32;
    var phi_5645_: u32;
    var phi_5657_: u32;
    var phi_5668_: u32;
    var phi_5680_: u32;
    var phi_5765_: u32;
    var phi_5845_: u32;
    var phi_5925_: u32;
    var phi_5946_: u32;
    var phi_5953_: type_9;
    var phi_5967_: u32;
    var phi_5974_: type_9;
    var phi_5988_: u32;
    var phi_5995_: type_9;
    var phi_6002_: u32;
    var phi_6014_: u32;
    var phi_6022_: bool;
    var phi_6023_: bool;
    var phi_6031_: u32;
    var phi_6039_: i32;
    var phi_6040_: i32;
    var phi_6069_: array<type_9, 2>;
    var phi_6098_: array<type_9, 2>;
    var phi_6127_: array<type_9, 2>;
    var phi_6141_: type_9;
    var phi_6167_: u32;
    var phi_6189_: u32;
    var phi_6217_: u32;
    var phi_6239_: u32;
    var phi_6267_: u32;
    var phi_6289_: u32;
    var phi_6303_: u32;
    var phi_6310_: type_9;
    var phi_6317_: u32;
    var phi_6337_: u32;
    var phi_6344_: type_9;
    var phi_6357_: u32;
    var phi_6364_: type_9;
    var phi_6377_: u32;
    var phi_6384_: type_9;
    var phi_6431_: u32;
    var phi_6439_: u32;
    var phi_6449_: u32;
    var phi_6457_: u32;
    var phi_6395_: u32;
    var phi_6405_: u32;
    var phi_6413_: u32;
    var phi_6423_: u32;
    var phi_6463_: type_9;
    var phi_6464_: type_9;
    var phi_6465_: type_9;
    var phi_6466_: type_9;
    var phi_6579_: bool;
    var phi_6580_: bool;
    var phi_6581_: bool;
    var phi_6582_: bool;
    var phi_6586_: u32;
    var phi_6587_: u32;
    var phi_6588_: u32;
    var phi_6589_: bool;
    var phi_6590_: u32;
    var phi_6591_: bool;
    var phi_6592_: u32;
    var phi_6593_: bool;
    var phi_6597_: u32;
    var phi_6598_: u32;
    var phi_6606_: bool;
    var phi_6610_: bool;
    var phi_6611_: bool;
    var phi_6612_: bool;
    var phi_6613_: u32;
    var phi_6614_: u32;
    var phi_6615_: bool;
    var phi_6631_: u32;
    var phi_6654_: u32;
    var phi_6677_: u32;
    var phi_6696_: u32;
    var phi_6715_: u32;
    var phi_6734_: u32;
    var phi_6774_: u32;
    var phi_6781_: type_9;
    var phi_6788_: u32;
    var phi_6801_: u32;
    var phi_6802_: u32;
    var phi_6817_: u32;
    var phi_6824_: type_9;
    var phi_6831_: u32;
    var phi_6844_: u32;
    var phi_6845_: u32;
    var phi_6861_: u32;
    var phi_6868_: type_9;
    var phi_6875_: u32;
    var phi_6888_: u32;
    var phi_6889_: u32;
    var phi_6905_: u32;
    var phi_6912_: type_9;
    var phi_6919_: u32;
    var phi_6932_: u32;
    var phi_6933_: u32;
    var phi_6950_: array<type_9, 4>;
    var phi_6951_: u32;
    var phi_6952_: array<type_9, 4>;
    var phi_6954_: u32;
    var phi_6955_: u32;
    var phi_6956_: array<type_9, 4>;
    var phi_6958_: u32;
    var phi_6959_: u32;
    var phi_6960_: array<type_9, 4>;
    var phi_6962_: bool;
    var phi_6963_: u32;
    var phi_6964_: u32;
    var phi_6965_: bool;
    var phi_6966_: bool;
    var phi_6967_: u32;
    var phi_6968_: u32;
    var phi_6969_: bool;
    var phi_6988_: u32;
    var phi_7000_: bool;
    var phi_7001_: bool;
    var phi_7019_: u32;
    var phi_7031_: u32;
    var phi_7042_: u32;
    var phi_7054_: u32;
    var phi_7065_: u32;
    var phi_7077_: u32;
    var phi_7094_: u32;
    var phi_7106_: u32;
    var phi_7117_: u32;
    var phi_7129_: u32;
    var phi_7140_: u32;
    var phi_7152_: u32;
    var phi_7172_: u32;
    var phi_7184_: u32;
    var phi_7195_: u32;
    var phi_7207_: u32;
    var phi_7218_: u32;
    var phi_7230_: u32;
    var phi_7241_: u32;
    var phi_7253_: u32;
    var phi_7264_: array<type_9, 4>;
    var phi_7265_: array<type_9, 4>;
    var phi_7266_: u32;
    var phi_7267_: u32;
    var phi_7268_: bool;
    var phi_7272_: bool;
    var phi_7273_: array<type_9, 4>;
    var phi_7274_: u32;
    var phi_7275_: u32;
    var phi_7276_: bool;
    var phi_7277_: bool;
    var phi_7278_: bool;
    var phi_7279_: array<type_9, 4>;
    var phi_7281_: u32;
    var phi_7282_: u32;
    var phi_7283_: bool;
    var phi_7284_: bool;
    var phi_7285_: u32;
    var phi_7286_: u32;
    var phi_7287_: bool;
    var phi_7288_: bool;
    var phi_7289_: bool;
    var phi_4566_: array<type_9, 4>;
    var phi_4570_: u32;
    var phi_4572_: u32;
    var phi_7290_: u32;
    var phi_7291_: bool;
    var phi_7292_: bool;
    var phi_7293_: u32;
    var phi_7294_: u32;
    var phi_7295_: bool;
    var phi_7296_: bool;
    var phi_7297_: bool;
    var phi_7298_: bool;
    var phi_7299_: bool;
    var local_62: bool;
    var phi_7304_: type_9;
    var phi_7305_: bool;
    var phi_7306_: bool;
    var phi_7307_: bool;
    var phi_7312_: type_9;
    var phi_7313_: bool;
    var phi_7314_: bool;
    var phi_7315_: bool;
    var phi_7320_: type_9;
    var phi_7321_: bool;
    var phi_7322_: bool;
    var local_63: bool;
    var local_64: u32;
    var local_65: array<type_9, 4>;
    var local_66: array<type_9, 4>;
    var local_67: array<type_9, 4>;
    var phi_7347_: u32;
    var phi_7354_: type_9;
    var phi_7361_: u32;
    var phi_7374_: u32;
    var phi_7375_: u32;
    var phi_7384_: u32;
    var local_68: u32;
    var phi_7396_: u32;
    var phi_7407_: u32;
    var local_69: u32;
    var phi_7419_: u32;
    var phi_7430_: u32;
    var local_70: u32;
    var phi_7442_: u32;
    var phi_7459_: u32;
    var local_71: u32;
    var phi_7471_: u32;
    var phi_7482_: u32;
    var local_72: u32;
    var phi_7494_: u32;
    var phi_7505_: u32;
    var local_73: u32;
    var phi_7517_: u32;
    var local_74: u32;
    var local_75: u32;
    var local_76: u32;
    var phi_7537_: u32;
    var local_77: u32;
    var phi_7549_: u32;
    var phi_7560_: u32;
    var local_78: u32;
    var phi_7583_: u32;
    var local_79: u32;
    var phi_7606_: u32;
    var local_80: u32;
    var phi_7643_: u32;
    var phi_7650_: type_9;
    var phi_7657_: u32;
    var phi_7670_: u32;
    var phi_7671_: u32;
    var phi_7674_: bool;
    var phi_7675_: bool;
    var phi_7676_: bool;
    var phi_7677_: bool;
    var phi_7681_: bool;
    var local_81: u32;
    var local_82: u32;
    var phi_7687_: bool;
    var local_83: u32;
    var phi_7695_: bool;
    var phi_7696_: bool;
    var phi_7697_: bool;
    var phi_7698_: bool;
    var phi_7702_: bool;
    var local_84: u32;
    var phi_7708_: type_9;
    var phi_7709_: type_9;
    var phi_7710_: bool;
    var phi_7711_: bool;
    var phi_7715_: type_9;
    var phi_7716_: bool;
    var phi_7720_: type_9;
    var phi_7733_: u32;
    var phi_7751_: array<u32, 2>;
    var phi_7757_: type_29;
    var phi_7763_: bool;
    var phi_7764_: type_29;
    var phi_7765_: bool;
    var phi_7766_: type_29;
    var phi_7767_: bool;
    var phi_7785_: array<u32, 2>;
    var phi_7799_: bool;
    var phi_7815_: bool;
    var phi_7823_: f32;
    var phi_7830_: f32;
    var phi_7835_: f32;
    var phi_7842_: f32;
    var phi_7847_: f32;
    var phi_7855_: f32;
    var phi_7862_: f32;
    var phi_7867_: f32;
    var phi_7874_: f32;
    var phi_7879_: f32;
    var phi_7884_: f32;
    var phi_7894_: f32;
    var phi_7901_: f32;
    var phi_7906_: f32;
    var phi_7913_: f32;
    var phi_7918_: f32;
    var phi_7926_: f32;
    var phi_7933_: f32;
    var phi_7938_: f32;
    var phi_7945_: f32;
    var phi_7950_: f32;
    var phi_7955_: f32;
    var phi_7965_: f32;
    var phi_7972_: f32;
    var phi_7977_: f32;
    var phi_7984_: f32;
    var phi_7989_: f32;
    var phi_7997_: f32;
    var phi_8004_: f32;
    var phi_8009_: f32;
    var phi_8016_: f32;
    var phi_8021_: f32;
    var phi_8026_: f32;
    var phi_8033_: f32;
    var phi_8038_: f32;
    var phi_8045_: bool;
    var phi_8069_: u32;
    var phi_8080_: f32;
    var phi_8081_: f32;
    var phi_8139_: type_44;
    var phi_8140_: bool;
    var phi_8141_: type_44;
    var phi_8142_: bool;
    var phi_8143_: type_44;
    var phi_8144_: bool;
    var phi_8149_: type_44;
    var phi_15095_: f32;
    var phi_15102_: f32;
    var phi_15107_: f32;
    var phi_15114_: f32;
    var phi_15119_: f32;
    var phi_15132_: f32;
    var phi_15139_: f32;
    var phi_15144_: f32;
    var phi_15151_: f32;
    var phi_15156_: f32;
    var phi_15161_: f32;
    var phi_15178_: f32;
    var phi_15185_: f32;
    var phi_15190_: f32;
    var phi_15197_: f32;
    var phi_15202_: f32;
    var phi_15216_: f32;
    var phi_15223_: f32;
    var phi_15228_: f32;
    var phi_15235_: f32;
    var phi_15240_: f32;
    var phi_15245_: f32;
    var phi_15262_: f32;
    var phi_15269_: f32;
    var phi_15274_: f32;
    var phi_15281_: f32;
    var phi_15286_: f32;
    var phi_15300_: f32;
    var phi_15307_: f32;
    var phi_15312_: f32;
    var phi_15319_: f32;
    var phi_15324_: f32;
    var phi_15329_: f32;
    var phi_15360_: f32;
    var phi_15366_: f32;
    var phi_15373_: f32;
    var phi_15380_: f32;
    var phi_15386_: f32;
    var phi_15393_: f32;
    var phi_15399_: f32;
    var phi_15405_: f32;
    var phi_15411_: f32;
    var phi_15418_: f32;
    var phi_15425_: f32;
    var phi_15449_: f32;
    var phi_15454_: f32;
    var phi_15459_: f32;
    var phi_15464_: f32;
    var phi_15469_: f32;
    var phi_15474_: f32;
    var phi_15484_: f32;
    var phi_15497_: f32;
    var phi_15503_: f32;
    var phi_15508_: f32;
    var phi_15514_: f32;
    var phi_15520_: f32;
    var phi_15525_: f32;
    var phi_15530_: f32;
    var phi_15538_: bool;
    var phi_15543_: f32;
    var phi_15550_: f32;
    var phi_15556_: f32;
    var phi_15574_: f32;
    var phi_15635_: array<f32, 3>;
    var phi_15700_: array<f32, 3>;
    var phi_15722_: f32;
    var phi_15729_: f32;
    var phi_15734_: f32;
    var phi_15741_: f32;
    var phi_15746_: f32;
    var phi_15759_: f32;
    var phi_15766_: f32;
    var phi_15771_: f32;
    var phi_15778_: f32;
    var phi_15783_: f32;
    var phi_15788_: f32;
    var phi_15805_: f32;
    var phi_15812_: f32;
    var phi_15817_: f32;
    var phi_15824_: f32;
    var phi_15829_: f32;
    var phi_15843_: f32;
    var phi_15850_: f32;
    var phi_15855_: f32;
    var phi_15862_: f32;
    var phi_15867_: f32;
    var phi_15872_: f32;
    var phi_15889_: f32;
    var phi_15896_: f32;
    var phi_15901_: f32;
    var phi_15908_: f32;
    var phi_15913_: f32;
    var phi_15927_: f32;
    var phi_15934_: f32;
    var phi_15939_: f32;
    var phi_15946_: f32;
    var phi_15951_: f32;
    var phi_15956_: f32;
    var phi_16074_: f32;
    var phi_16081_: f32;
    var phi_16089_: f32;
    var phi_16133_: type_14;
    var phi_16136_: f32;
    var phi_16157_: bool;
    var phi_16163_: type_15;
    var phi_16134_: type_14;
    var phi_16177_: type_15;
    var phi_16137_: f32;
    var local_85: f32;
    var phi_16126_: f32;
    var phi_16190_: f32;
    var phi_16256_: f32;
    var phi_16262_: f32;
    var phi_16271_: f32;
    var phi_16277_: f32;
    var phi_16286_: f32;
    var phi_16292_: f32;
    var phi_16301_: f32;
    var phi_16307_: f32;
    var phi_16313_: type_30;
    var phi_16314_: bool;
    var phi_16315_: type_30;
    var phi_16316_: bool;
    var phi_16324_: type_30;
    var phi_16493_: bool;
    var phi_16494_: bool;
    var phi_16495_: bool;
    var phi_16496_: bool;
    var phi_16497_: bool;
    var phi_16498_: bool;
    var phi_16502_: bool;
    var phi_16529_: f32;
    var phi_16583_: type_14;
    var phi_16586_: f32;
    var phi_16607_: bool;
    var phi_16613_: type_15;
    var phi_16584_: type_14;
    var phi_16627_: type_15;
    var phi_16587_: f32;
    var local_86: f32;
    var phi_16576_: f32;
    var phi_16640_: f32;
    var phi_16706_: f32;
    var phi_16712_: f32;
    var phi_16721_: f32;
    var phi_16727_: f32;
    var phi_16736_: f32;
    var phi_16742_: f32;
    var phi_16751_: f32;
    var phi_16757_: f32;
    var phi_16763_: type_30;
    var phi_16764_: bool;
    var phi_16765_: type_30;
    var phi_16766_: bool;
    var phi_16774_: type_30;
    var phi_16943_: bool;
    var phi_16944_: bool;
    var phi_16945_: bool;
    var phi_16946_: bool;
    var phi_16947_: bool;
    var phi_16948_: bool;
    var phi_16952_: bool;
    var phi_16985_: f32;
    var phi_17033_: type_14;
    var phi_17036_: f32;
    var phi_17057_: bool;
    var phi_17063_: type_15;
    var phi_17034_: type_14;
    var phi_17077_: type_15;
    var phi_17037_: f32;
    var local_87: f32;
    var phi_17026_: f32;
    var phi_17090_: f32;
    var phi_17156_: f32;
    var phi_17162_: f32;
    var phi_17171_: f32;
    var phi_17177_: f32;
    var phi_17186_: f32;
    var phi_17192_: f32;
    var phi_17201_: f32;
    var phi_17207_: f32;
    var phi_17213_: type_30;
    var phi_17214_: bool;
    var phi_17215_: type_30;
    var phi_17216_: bool;
    var phi_17224_: type_30;
    var phi_17393_: bool;
    var phi_17394_: bool;
    var phi_17395_: bool;
    var phi_17396_: bool;
    var phi_17397_: bool;
    var phi_17398_: bool;
    var phi_17402_: bool;
    var phi_17442_: f32;
    var phi_17483_: type_14;
    var phi_17486_: f32;
    var phi_17507_: bool;
    var phi_17513_: type_15;
    var phi_17484_: type_14;
    var phi_17527_: type_15;
    var phi_17487_: f32;
    var local_88: f32;
    var phi_17476_: f32;
    var phi_17540_: f32;
    var phi_17606_: f32;
    var phi_17612_: f32;
    var phi_17621_: f32;
    var phi_17627_: f32;
    var phi_17636_: f32;
    var phi_17642_: f32;
    var phi_17651_: f32;
    var phi_17657_: f32;
    var phi_17663_: type_30;
    var phi_17664_: bool;
    var phi_17665_: type_30;
    var phi_17666_: bool;
    var phi_17674_: type_30;
    var phi_17843_: bool;
    var phi_17844_: bool;
    var phi_17845_: bool;
    var phi_17846_: bool;
    var phi_17847_: bool;
    var phi_17848_: bool;
    var phi_17852_: bool;
    var phi_17853_: bool;
    var phi_17854_: bool;
    var phi_17855_: bool;
    var phi_17856_: bool;
    var phi_17857_: bool;
    var phi_17861_: bool;
    var phi_17867_: type_45;
    var phi_17868_: bool;
    var phi_17869_: type_45;
    var phi_17870_: bool;
    var phi_17913_: type_14;
    var phi_17916_: f32;
    var phi_17937_: bool;
    var phi_17943_: type_15;
    var phi_17914_: type_14;
    var phi_17957_: type_15;
    var phi_17917_: f32;
    var local_89: f32;
    var phi_17906_: f32;
    var phi_17970_: f32;
    var phi_17976_: f32;
    var phi_18001_: type_9;
    var phi_18004_: u32;
    var phi_18002_: type_9;
    var phi_18027_: type_9;
    var phi_18071_: u32;
    var phi_18072_: u32;
    var phi_18005_: u32;
    var phi_18073_: u32;
    var phi_18093_: type_9;
    var phi_18094_: type_9;
    var phi_18117_: type_9;
    var phi_18136_: f32;
    var phi_18149_: f32;
    var phi_18183_: f32;
    var phi_18190_: f32;
    var phi_18201_: bool;
    var phi_18202_: bool;
    var phi_18203_: bool;
    var phi_18204_: bool;
    var phi_18208_: bool;
    var phi_18219_: type_48;
    var phi_18220_: type_48;
    var phi_18221_: bool;
    var phi_18222_: type_48;
    var phi_18223_: bool;
    var phi_18234_: f32;
    var phi_18244_: type_9;
    var phi_18247_: f32;
    var phi_18249_: f32;
    var phi_18251_: f32;
    var phi_18245_: type_9;
    var phi_18274_: type_9;
    var phi_18299_: f32;
    var phi_18300_: f32;
    var phi_18326_: f32;
    var phi_18342_: f32;
    var phi_18349_: bool;
    var phi_18350_: bool;
    var phi_18351_: bool;
    var phi_18357_: f32;
    var phi_18358_: f32;
    var phi_18359_: bool;
    var phi_18248_: f32;
    var phi_18250_: f32;
    var phi_18252_: f32;
    var phi_18360_: f32;
    var phi_18361_: bool;
    var phi_18362_: bool;
    var local_90: bool;
    var phi_18366_: f32;
    var phi_18367_: f32;
    var phi_18375_: f32;
    var phi_18379_: type_9;
    var phi_18382_: f32;
    var phi_18380_: type_9;
    var phi_18405_: type_9;
    var phi_18435_: f32;
    var phi_18436_: bool;
    var phi_18437_: f32;
    var phi_18438_: bool;
    var phi_18439_: bool;
    var phi_18440_: bool;
    var phi_18441_: f32;
    var phi_18383_: f32;
    var phi_18442_: bool;
    var phi_18443_: bool;
    var phi_18444_: bool;
    var phi_18445_: bool;
    var local_91: bool;
    var phi_18449_: bool;
    var phi_18450_: bool;
    var phi_18454_: bool;
    var phi_18458_: f32;
    var phi_18459_: f32;
    var phi_18461_: type_48;
    var phi_18490_: f32;
    var phi_18497_: f32;
    var phi_18502_: f32;
    var phi_18509_: f32;
    var phi_18514_: f32;
    var phi_18527_: f32;
    var phi_18534_: f32;
    var phi_18539_: f32;
    var phi_18546_: f32;
    var phi_18551_: f32;
    var phi_18556_: f32;
    var phi_18615_: f32;
    var phi_18621_: f32;
    var phi_18626_: f32;
    var phi_18632_: f32;
    var phi_18637_: f32;
    var phi_18649_: f32;
    var phi_18655_: f32;
    var phi_18660_: f32;
    var phi_18666_: f32;
    var phi_18671_: f32;
    var phi_18697_: f32;
    var phi_18704_: f32;
    var phi_18709_: f32;
    var phi_18716_: f32;
    var phi_18721_: f32;
    var phi_18734_: f32;
    var phi_18741_: f32;
    var phi_18746_: f32;
    var phi_18753_: f32;
    var phi_18758_: f32;
    var phi_18763_: f32;
    var phi_18822_: f32;
    var phi_18828_: f32;
    var phi_18833_: f32;
    var phi_18839_: f32;
    var phi_18844_: f32;
    var phi_18856_: f32;
    var phi_18862_: f32;
    var phi_18867_: f32;
    var phi_18873_: f32;
    var phi_18878_: f32;
    var phi_18904_: f32;
    var phi_18911_: f32;
    var phi_18916_: f32;
    var phi_18923_: f32;
    var phi_18928_: f32;
    var phi_18941_: f32;
    var phi_18948_: f32;
    var phi_18953_: f32;
    var phi_18960_: f32;
    var phi_18965_: f32;
    var phi_18970_: f32;
    var phi_19029_: f32;
    var phi_19035_: f32;
    var phi_19040_: f32;
    var phi_19046_: f32;
    var phi_19051_: f32;
    var phi_19063_: f32;
    var phi_19069_: f32;
    var phi_19074_: f32;
    var phi_19080_: f32;
    var phi_19085_: f32;
    var phi_19134_: f32;
    var phi_19140_: f32;
    var phi_19168_: f32;
    var phi_19174_: f32;
    var phi_19179_: u32;
    var phi_19180_: u32;
    var phi_19150_: f32;
    var phi_19156_: f32;
    var phi_19161_: u32;
    var phi_19162_: u32;
    var phi_19181_: u32;
    var phi_19182_: u32;
    var phi_19251_: f32;
    var phi_19260_: f32;
    var phi_19395_: f32;
    var phi_19401_: f32;
    var phi_19408_: f32;
    var phi_19443_: array<type_16, 4>;
    var phi_19463_: type_9;
    var phi_19466_: bool;
    var phi_19464_: type_9;
    var phi_19489_: type_9;
    var phi_19516_: bool;
    var phi_19517_: bool;
    var phi_19467_: bool;
    var phi_19518_: bool;
    var phi_19519_: bool;
    var local_92: bool;
    var phi_19523_: bool;
    var local_93: bool;
    var phi_19530_: u32;
    var phi_19531_: u32;
    var phi_19532_: bool;
    var phi_19533_: u32;
    var phi_19534_: u32;
    var phi_19535_: bool;
    var phi_19539_: u32;
    var phi_19549_: bool;
    var phi_19561_: bool;
    var phi_19562_: bool;
    var phi_19623_: array<f32, 3>;
    var phi_19688_: array<f32, 3>;
    var phi_19710_: f32;
    var phi_19717_: f32;
    var phi_19722_: f32;
    var phi_19729_: f32;
    var phi_19734_: f32;
    var phi_19747_: f32;
    var phi_19754_: f32;
    var phi_19759_: f32;
    var phi_19766_: f32;
    var phi_19771_: f32;
    var phi_19776_: f32;
    var phi_19793_: f32;
    var phi_19800_: f32;
    var phi_19805_: f32;
    var phi_19812_: f32;
    var phi_19817_: f32;
    var phi_19831_: f32;
    var phi_19838_: f32;
    var phi_19843_: f32;
    var phi_19850_: f32;
    var phi_19855_: f32;
    var phi_19860_: f32;
    var phi_19877_: f32;
    var phi_19884_: f32;
    var phi_19889_: f32;
    var phi_19896_: f32;
    var phi_19901_: f32;
    var phi_19915_: f32;
    var phi_19922_: f32;
    var phi_19927_: f32;
    var phi_19934_: f32;
    var phi_19939_: f32;
    var phi_19944_: f32;
    var phi_19985_: type_9;
    var phi_19988_: f32;
    var phi_19990_: f32;
    var phi_19992_: f32;
    var phi_19994_: f32;
    var phi_19996_: bool;
    var phi_19998_: u32;
    var phi_19986_: type_9;
    var phi_20021_: type_9;
    var phi_20135_: f32;
    var phi_20141_: f32;
    var phi_20147_: f32;
    var phi_20149_: array<f32, 3>;
    var phi_20156_: f32;
    var phi_20163_: f32;
    var phi_20171_: f32;
    var phi_20215_: type_14;
    var phi_20218_: f32;
    var phi_20239_: bool;
    var phi_20245_: type_15;
    var phi_20216_: type_14;
    var phi_20259_: type_15;
    var phi_20219_: f32;
    var local_94: f32;
    var phi_20208_: f32;
    var phi_20272_: f32;
    var phi_20338_: f32;
    var phi_20344_: f32;
    var phi_20353_: f32;
    var phi_20359_: f32;
    var phi_20368_: f32;
    var phi_20374_: f32;
    var phi_20383_: f32;
    var phi_20389_: f32;
    var phi_20395_: type_30;
    var phi_20396_: bool;
    var phi_20397_: type_30;
    var phi_20398_: bool;
    var phi_20406_: type_30;
    var phi_20577_: bool;
    var phi_20578_: bool;
    var phi_20579_: bool;
    var phi_20580_: bool;
    var phi_20581_: bool;
    var phi_20582_: bool;
    var phi_20586_: bool;
    var phi_20883_: bool;
    var phi_20884_: bool;
    var phi_20885_: bool;
    var phi_20886_: bool;
    var phi_20887_: bool;
    var phi_20888_: bool;
    var phi_20892_: bool;
    var phi_20896_: bool;
    var phi_20907_: bool;
    var phi_20908_: bool;
    var phi_20982_: bool;
    var phi_20983_: bool;
    var phi_21003_: f32;
    var phi_21004_: bool;
    var phi_21005_: f32;
    var phi_21006_: bool;
    var phi_21007_: f32;
    var phi_21008_: bool;
    var phi_21009_: bool;
    var phi_21013_: f32;
    var phi_21014_: bool;
    var phi_21018_: f32;
    var phi_21050_: bool;
    var phi_21051_: bool;
    var phi_21071_: f32;
    var phi_21072_: bool;
    var phi_21073_: f32;
    var phi_21074_: bool;
    var phi_21075_: f32;
    var phi_21076_: bool;
    var phi_21077_: bool;
    var phi_21081_: f32;
    var phi_21082_: bool;
    var phi_21086_: f32;
    var phi_21091_: f32;
    var phi_21123_: bool;
    var phi_21124_: bool;
    var phi_21144_: f32;
    var phi_21145_: bool;
    var phi_21146_: f32;
    var phi_21147_: bool;
    var phi_21148_: f32;
    var phi_21149_: bool;
    var phi_21150_: bool;
    var phi_21154_: f32;
    var phi_21155_: bool;
    var phi_21159_: f32;
    var phi_21191_: bool;
    var phi_21192_: bool;
    var phi_21212_: f32;
    var phi_21213_: bool;
    var phi_21214_: f32;
    var phi_21215_: bool;
    var phi_21216_: f32;
    var phi_21217_: bool;
    var phi_21218_: bool;
    var phi_21222_: f32;
    var phi_21223_: bool;
    var phi_21227_: f32;
    var phi_21232_: f32;
    var phi_21237_: f32;
    var phi_21242_: f32;
    var phi_21736_: bool;
    var phi_21737_: bool;
    var phi_21742_: f32;
    var phi_21744_: f32;
    var phi_21747_: f32;
    var phi_21748_: f32;
    var phi_21749_: bool;
    var phi_21751_: f32;
    var phi_21752_: f32;
    var phi_21753_: f32;
    var phi_21755_: bool;
    var phi_21756_: bool;
    var phi_21758_: bool;
    var phi_21759_: f32;
    var phi_21760_: f32;
    var phi_21761_: f32;
    var phi_21763_: bool;
    var phi_21764_: bool;
    var phi_21765_: bool;
    var phi_21767_: bool;
    var phi_21768_: f32;
    var phi_21769_: f32;
    var phi_21770_: f32;
    var phi_21772_: bool;
    var phi_21773_: bool;
    var phi_21774_: bool;
    var phi_21776_: bool;
    var phi_21862_: f32;
    var phi_21935_: f32;
    var phi_21940_: f32;
    var phi_22013_: f32;
    var phi_22086_: f32;
    var phi_22091_: f32;
    var phi_22107_: f32;
    var phi_22108_: f32;
    var phi_22109_: f32;
    var phi_21789_: bool;
    var phi_22111_: u32;
    var phi_22112_: f32;
    var phi_22113_: bool;
    var phi_22114_: bool;
    var phi_22115_: bool;
    var phi_22116_: u32;
    var phi_22117_: f32;
    var phi_22118_: f32;
    var phi_22119_: f32;
    var phi_22120_: f32;
    var phi_22121_: bool;
    var phi_22122_: u32;
    var phi_22123_: bool;
    var phi_22124_: bool;
    var phi_22125_: bool;
    var phi_22126_: bool;
    var phi_22128_: bool;
    var phi_22137_: f32;
    var phi_22142_: f32;
    var phi_22151_: bool;
    var phi_22155_: bool;
    var phi_22156_: f32;
    var phi_22157_: f32;
    var phi_22158_: f32;
    var phi_22159_: f32;
    var phi_22160_: bool;
    var phi_22161_: u32;
    var phi_22162_: bool;
    var phi_22163_: bool;
    var phi_22164_: bool;
    var phi_22165_: bool;
    var phi_22167_: bool;
    var phi_19989_: f32;
    var phi_19991_: f32;
    var phi_19993_: f32;
    var phi_19995_: f32;
    var phi_19997_: bool;
    var phi_19999_: u32;
    var phi_22168_: f32;
    var phi_22170_: bool;
    var phi_22171_: bool;
    var phi_22172_: bool;
    var phi_22173_: bool;
    var phi_22175_: bool;
    var phi_22176_: bool;
    var local_95: bool;
    var phi_22180_: bool;
    var phi_22181_: bool;
    var phi_22183_: bool;
    var phi_22184_: bool;
    var local_96: f32;
    var phi_22189_: type_45;
    var phi_22190_: bool;
    var phi_22192_: bool;
    var phi_22193_: bool;
    var phi_22194_: bool;
    var phi_22199_: type_45;
    var phi_22201_: bool;
    var phi_22202_: bool;
    var phi_22203_: bool;
    var phi_22204_: bool;
    var phi_22216_: f32;
    var phi_22217_: bool;
    var phi_22218_: bool;
    var phi_22219_: bool;
    var phi_22224_: type_45;
    var phi_22225_: bool;
    var phi_22226_: bool;
    var phi_22231_: type_45;
    var phi_22232_: bool;
    var phi_22236_: type_45;
    var phi_22243_: bool;
    var phi_22244_: f32;
    var phi_22245_: bool;
    var phi_22246_: bool;
    var phi_22247_: bool;
    var phi_22248_: bool;
    var phi_22249_: f32;
    var phi_22250_: f32;
    var phi_22251_: bool;
    var phi_22252_: bool;
    var phi_22253_: bool;
    var phi_22254_: bool;
    var phi_22255_: f32;
    var phi_22256_: f32;
    var phi_22257_: bool;
    var phi_22258_: bool;
    var phi_22259_: bool;
    var phi_22260_: bool;
    var phi_22264_: bool;
    var phi_22265_: bool;
    var phi_22266_: bool;
    var phi_22267_: type_48;
    var phi_22268_: bool;
    var phi_22269_: f32;
    var phi_22270_: f32;
    var phi_22271_: type_48;
    var phi_22272_: bool;
    var phi_22273_: bool;
    var phi_22274_: bool;
    var phi_22275_: bool;
    var phi_22279_: bool;
    var phi_22280_: bool;
    var phi_22281_: bool;
    var phi_22282_: type_48;
    var phi_22283_: bool;
    var phi_22284_: f32;
    var phi_22285_: f32;
    var phi_22286_: type_48;
    var phi_22287_: bool;
    var phi_22288_: bool;
    var phi_22289_: bool;
    var phi_22290_: bool;
    var local_97: bool;
    var phi_22295_: type_45;
    var phi_22296_: bool;
    var phi_22297_: bool;
    var local_98: bool;
    var local_99: type_48;
    var local_100: f32;
    var local_101: f32;
    var local_102: f32;
    var phi_22311_: type_45;
    var phi_22312_: bool;
    var phi_22313_: type_45;
    var phi_22314_: bool;
    var local_103: f32;
    var phi_22319_: type_45;
    var phi_22320_: type_45;
    var phi_22321_: bool;
    var local_104: type_48;
    var phi_22327_: type_45;
    var phi_22328_: bool;
    var phi_22332_: type_45;
    var phi_22333_: type_45;
    var phi_22334_: bool;
    var phi_22338_: type_45;
    var phi_22339_: type_45;
    var phi_22340_: bool;
    var phi_22344_: type_45;
    var phi_22355_: bool;
    var phi_22356_: bool;
    var phi_22360_: bool;
    var phi_22364_: u32;
    var phi_8323_: type_14;
    var phi_8326_: f32;
    var phi_8347_: bool;
    var phi_8353_: type_15;
    var phi_8324_: type_14;
    var phi_8367_: type_15;
    var phi_8327_: f32;
    var local_105: f32;
    var phi_8316_: f32;
    var phi_8380_: f32;
    var phi_8396_: f32;
    var phi_8403_: f32;
    var phi_8408_: f32;
    var phi_8415_: f32;
    var phi_8420_: f32;
    var phi_8433_: f32;
    var phi_8440_: f32;
    var phi_8445_: f32;
    var phi_8452_: f32;
    var phi_8457_: f32;
    var phi_8462_: f32;
    var phi_8479_: f32;
    var phi_8486_: f32;
    var phi_8491_: f32;
    var phi_8498_: f32;
    var phi_8503_: f32;
    var phi_8517_: f32;
    var phi_8524_: f32;
    var phi_8529_: f32;
    var phi_8536_: f32;
    var phi_8541_: f32;
    var phi_8546_: f32;
    var phi_8563_: f32;
    var phi_8570_: f32;
    var phi_8575_: f32;
    var phi_8582_: f32;
    var phi_8587_: f32;
    var phi_8601_: f32;
    var phi_8608_: f32;
    var phi_8613_: f32;
    var phi_8620_: f32;
    var phi_8625_: f32;
    var phi_8630_: f32;
    var phi_8891_: f32;
    var phi_8898_: f32;
    var phi_8903_: f32;
    var phi_8910_: f32;
    var phi_8915_: f32;
    var phi_8928_: f32;
    var phi_8935_: f32;
    var phi_8940_: f32;
    var phi_8947_: f32;
    var phi_8952_: f32;
    var phi_8957_: f32;
    var phi_8974_: f32;
    var phi_8981_: f32;
    var phi_8986_: f32;
    var phi_8993_: f32;
    var phi_8998_: f32;
    var phi_9012_: f32;
    var phi_9019_: f32;
    var phi_9024_: f32;
    var phi_9031_: f32;
    var phi_9036_: f32;
    var phi_9041_: f32;
    var phi_9058_: f32;
    var phi_9065_: f32;
    var phi_9070_: f32;
    var phi_9077_: f32;
    var phi_9082_: f32;
    var phi_9096_: f32;
    var phi_9103_: f32;
    var phi_9108_: f32;
    var phi_9115_: f32;
    var phi_9120_: f32;
    var phi_9125_: f32;
    var phi_9156_: f32;
    var phi_9162_: f32;
    var phi_9169_: f32;
    var phi_9176_: f32;
    var phi_9182_: f32;
    var phi_9189_: f32;
    var phi_9195_: f32;
    var phi_9201_: f32;
    var phi_9207_: f32;
    var phi_9214_: f32;
    var phi_9221_: f32;
    var phi_9245_: f32;
    var phi_9250_: f32;
    var phi_9255_: f32;
    var phi_9260_: f32;
    var phi_9265_: f32;
    var phi_9270_: f32;
    var phi_9280_: f32;
    var phi_9289_: type_46;
    var phi_9290_: bool;
    var phi_9291_: type_46;
    var phi_9292_: bool;
    var phi_9298_: type_14;
    var phi_9301_: f32;
    var phi_9303_: u32;
    var phi_9305_: f32;
    var phi_9326_: bool;
    var phi_9332_: type_15;
    var phi_9299_: type_14;
    var phi_9346_: type_15;
    var phi_9361_: bool;
    var phi_9362_: bool;
    var phi_9421_: array<f32, 3>;
    var phi_9486_: array<f32, 3>;
    var phi_9508_: f32;
    var phi_9515_: f32;
    var phi_9520_: f32;
    var phi_9527_: f32;
    var phi_9532_: f32;
    var phi_9545_: f32;
    var phi_9552_: f32;
    var phi_9557_: f32;
    var phi_9564_: f32;
    var phi_9569_: f32;
    var phi_9574_: f32;
    var phi_9591_: f32;
    var phi_9598_: f32;
    var phi_9603_: f32;
    var phi_9610_: f32;
    var phi_9615_: f32;
    var phi_9629_: f32;
    var phi_9636_: f32;
    var phi_9641_: f32;
    var phi_9648_: f32;
    var phi_9653_: f32;
    var phi_9658_: f32;
    var phi_9675_: f32;
    var phi_9682_: f32;
    var phi_9687_: f32;
    var phi_9694_: f32;
    var phi_9699_: f32;
    var phi_9713_: f32;
    var phi_9720_: f32;
    var phi_9725_: f32;
    var phi_9732_: f32;
    var phi_9737_: f32;
    var phi_9742_: f32;
    var phi_9783_: type_9;
    var phi_9786_: f32;
    var phi_9788_: f32;
    var phi_9790_: f32;
    var phi_9792_: f32;
    var phi_9794_: bool;
    var phi_9796_: u32;
    var phi_9784_: type_9;
    var phi_9819_: type_9;
    var phi_9933_: f32;
    var phi_9939_: f32;
    var phi_9945_: f32;
    var phi_9947_: array<f32, 3>;
    var phi_9954_: f32;
    var phi_9961_: f32;
    var phi_9969_: f32;
    var phi_10013_: type_14;
    var phi_10016_: f32;
    var phi_10037_: bool;
    var phi_10043_: type_15;
    var phi_10014_: type_14;
    var phi_10057_: type_15;
    var phi_10017_: f32;
    var local_106: f32;
    var phi_10006_: f32;
    var phi_10070_: f32;
    var phi_10136_: f32;
    var phi_10142_: f32;
    var phi_10151_: f32;
    var phi_10157_: f32;
    var phi_10166_: f32;
    var phi_10172_: f32;
    var phi_10181_: f32;
    var phi_10187_: f32;
    var phi_10193_: type_30;
    var phi_10194_: bool;
    var phi_10195_: type_30;
    var phi_10196_: bool;
    var phi_10204_: type_30;
    var phi_10375_: bool;
    var phi_10376_: bool;
    var phi_10377_: bool;
    var phi_10378_: bool;
    var phi_10379_: bool;
    var phi_10380_: bool;
    var phi_10384_: bool;
    var phi_10681_: bool;
    var phi_10682_: bool;
    var phi_10683_: bool;
    var phi_10684_: bool;
    var phi_10685_: bool;
    var phi_10686_: bool;
    var phi_10690_: bool;
    var phi_10694_: bool;
    var phi_10705_: bool;
    var phi_10706_: bool;
    var phi_10780_: bool;
    var phi_10781_: bool;
    var phi_10801_: f32;
    var phi_10802_: bool;
    var phi_10803_: f32;
    var phi_10804_: bool;
    var phi_10805_: f32;
    var phi_10806_: bool;
    var phi_10807_: bool;
    var phi_10811_: f32;
    var phi_10812_: bool;
    var phi_10816_: f32;
    var phi_10848_: bool;
    var phi_10849_: bool;
    var phi_10869_: f32;
    var phi_10870_: bool;
    var phi_10871_: f32;
    var phi_10872_: bool;
    var phi_10873_: f32;
    var phi_10874_: bool;
    var phi_10875_: bool;
    var phi_10879_: f32;
    var phi_10880_: bool;
    var phi_10884_: f32;
    var phi_10889_: f32;
    var phi_10921_: bool;
    var phi_10922_: bool;
    var phi_10942_: f32;
    var phi_10943_: bool;
    var phi_10944_: f32;
    var phi_10945_: bool;
    var phi_10946_: f32;
    var phi_10947_: bool;
    var phi_10948_: bool;
    var phi_10952_: f32;
    var phi_10953_: bool;
    var phi_10957_: f32;
    var phi_10989_: bool;
    var phi_10990_: bool;
    var phi_11010_: f32;
    var phi_11011_: bool;
    var phi_11012_: f32;
    var phi_11013_: bool;
    var phi_11014_: f32;
    var phi_11015_: bool;
    var phi_11016_: bool;
    var phi_11020_: f32;
    var phi_11021_: bool;
    var phi_11025_: f32;
    var phi_11030_: f32;
    var phi_11035_: f32;
    var phi_11040_: f32;
    var phi_11053_: f32;
    var phi_11190_: type_14;
    var phi_11193_: f32;
    var phi_11214_: bool;
    var phi_11220_: type_15;
    var phi_11191_: type_14;
    var phi_11234_: type_15;
    var phi_11194_: f32;
    var local_107: f32;
    var phi_11183_: f32;
    var phi_11247_: f32;
    var phi_11263_: f32;
    var phi_11270_: f32;
    var phi_11275_: f32;
    var phi_11282_: f32;
    var phi_11287_: f32;
    var phi_11300_: f32;
    var phi_11307_: f32;
    var phi_11312_: f32;
    var phi_11319_: f32;
    var phi_11324_: f32;
    var phi_11329_: f32;
    var phi_11346_: f32;
    var phi_11353_: f32;
    var phi_11358_: f32;
    var phi_11365_: f32;
    var phi_11370_: f32;
    var phi_11384_: f32;
    var phi_11391_: f32;
    var phi_11396_: f32;
    var phi_11403_: f32;
    var phi_11408_: f32;
    var phi_11413_: f32;
    var phi_11430_: f32;
    var phi_11437_: f32;
    var phi_11442_: f32;
    var phi_11449_: f32;
    var phi_11454_: f32;
    var phi_11468_: f32;
    var phi_11475_: f32;
    var phi_11480_: f32;
    var phi_11487_: f32;
    var phi_11492_: f32;
    var phi_11497_: f32;
    var phi_11517_: bool;
    var phi_11518_: bool;
    var phi_11519_: bool;
    var phi_11534_: bool;
    var phi_11535_: bool;
    var phi_11540_: f32;
    var phi_11542_: f32;
    var phi_11543_: f32;
    var phi_11544_: bool;
    var phi_11545_: f32;
    var phi_11546_: f32;
    var phi_11547_: bool;
    var phi_11548_: bool;
    var phi_11549_: f32;
    var phi_11550_: f32;
    var phi_11551_: f32;
    var phi_11552_: f32;
    var phi_11553_: bool;
    var phi_11554_: bool;
    var phi_11555_: bool;
    var phi_11556_: bool;
    var phi_11557_: f32;
    var phi_11558_: f32;
    var phi_11559_: f32;
    var phi_11560_: f32;
    var phi_11561_: bool;
    var phi_11562_: bool;
    var phi_11563_: bool;
    var phi_11564_: bool;
    var phi_11565_: bool;
    var phi_11566_: f32;
    var phi_11567_: f32;
    var phi_11568_: f32;
    var phi_11569_: f32;
    var phi_11570_: bool;
    var phi_11571_: bool;
    var phi_11572_: bool;
    var phi_11573_: bool;
    var phi_11574_: bool;
    var phi_11660_: f32;
    var phi_11733_: f32;
    var phi_11738_: f32;
    var phi_11811_: f32;
    var phi_11884_: f32;
    var phi_11889_: f32;
    var phi_11905_: f32;
    var phi_11906_: f32;
    var phi_11907_: f32;
    var phi_11587_: bool;
    var phi_11909_: u32;
    var phi_11910_: f32;
    var phi_11911_: bool;
    var phi_11912_: bool;
    var phi_11913_: bool;
    var phi_11914_: u32;
    var phi_11915_: f32;
    var phi_11916_: f32;
    var phi_11917_: f32;
    var phi_11918_: f32;
    var phi_11919_: bool;
    var phi_11920_: u32;
    var phi_11921_: bool;
    var phi_11922_: bool;
    var phi_11923_: bool;
    var phi_11924_: bool;
    var phi_11925_: bool;
    var phi_11926_: bool;
    var phi_11935_: f32;
    var phi_11940_: f32;
    var phi_11949_: bool;
    var phi_11953_: bool;
    var phi_11954_: f32;
    var phi_11955_: f32;
    var phi_11956_: f32;
    var phi_11957_: f32;
    var phi_11958_: bool;
    var phi_11959_: u32;
    var phi_11960_: bool;
    var phi_11961_: bool;
    var phi_11962_: bool;
    var phi_11963_: bool;
    var phi_11964_: bool;
    var phi_11965_: bool;
    var phi_9787_: f32;
    var phi_9789_: f32;
    var phi_9791_: f32;
    var phi_9793_: f32;
    var phi_9795_: bool;
    var phi_9797_: u32;
    var phi_11966_: f32;
    var phi_11967_: f32;
    var phi_11968_: bool;
    var phi_11969_: bool;
    var phi_11970_: bool;
    var phi_11971_: bool;
    var phi_11972_: bool;
    var phi_11973_: bool;
    var phi_11974_: bool;
    var local_108: bool;
    var phi_11978_: bool;
    var phi_11979_: bool;
    var phi_11980_: bool;
    var phi_11981_: bool;
    var phi_11982_: bool;
    var local_109: f32;
    var phi_11987_: type_45;
    var phi_11988_: bool;
    var phi_11989_: bool;
    var phi_11990_: bool;
    var phi_11991_: bool;
    var phi_11992_: bool;
    var phi_11997_: type_45;
    var phi_11998_: bool;
    var phi_11999_: bool;
    var phi_12000_: bool;
    var phi_12001_: bool;
    var phi_12002_: bool;
    var phi_12006_: f32;
    var phi_12007_: bool;
    var phi_12008_: bool;
    var phi_12009_: bool;
    var phi_12010_: bool;
    var phi_12014_: f32;
    var phi_12015_: bool;
    var phi_12016_: bool;
    var phi_12017_: bool;
    var phi_12022_: type_45;
    var phi_12023_: bool;
    var phi_12024_: bool;
    var phi_12029_: type_45;
    var phi_12030_: bool;
    var phi_12034_: type_45;
    var phi_12041_: f32;
    var phi_12042_: bool;
    var phi_12154_: f32;
    var phi_12161_: f32;
    var phi_12169_: f32;
    var phi_12227_: array<f32, 3>;
    var phi_12295_: array<f32, 3>;
    var phi_12320_: f32;
    var phi_12327_: f32;
    var phi_12332_: f32;
    var phi_12339_: f32;
    var phi_12344_: f32;
    var phi_12357_: f32;
    var phi_12364_: f32;
    var phi_12369_: f32;
    var phi_12376_: f32;
    var phi_12381_: f32;
    var phi_12386_: f32;
    var phi_12403_: f32;
    var phi_12410_: f32;
    var phi_12415_: f32;
    var phi_12422_: f32;
    var phi_12427_: f32;
    var phi_12441_: f32;
    var phi_12448_: f32;
    var phi_12453_: f32;
    var phi_12460_: f32;
    var phi_12465_: f32;
    var phi_12470_: f32;
    var phi_12487_: f32;
    var phi_12494_: f32;
    var phi_12499_: f32;
    var phi_12506_: f32;
    var phi_12511_: f32;
    var phi_12525_: f32;
    var phi_12532_: f32;
    var phi_12537_: f32;
    var phi_12544_: f32;
    var phi_12549_: f32;
    var phi_12554_: f32;
    var phi_12662_: type_14;
    var phi_12665_: f32;
    var phi_12686_: bool;
    var phi_12692_: type_15;
    var phi_12663_: type_14;
    var phi_12706_: type_15;
    var phi_12666_: f32;
    var local_110: f32;
    var phi_12655_: f32;
    var phi_12719_: f32;
    var phi_12853_: f32;
    var phi_12859_: f32;
    var phi_12868_: f32;
    var phi_12874_: f32;
    var phi_12883_: f32;
    var phi_12889_: f32;
    var phi_12898_: f32;
    var phi_12904_: f32;
    var phi_12954_: type_14;
    var phi_12957_: f32;
    var phi_12978_: bool;
    var phi_12984_: type_15;
    var phi_12955_: type_14;
    var phi_12998_: type_15;
    var phi_12958_: f32;
    var local_111: f32;
    var phi_12947_: f32;
    var phi_13011_: f32;
    var phi_13043_: type_14;
    var phi_13046_: f32;
    var phi_13067_: bool;
    var phi_13073_: type_15;
    var phi_13044_: type_14;
    var phi_13087_: type_15;
    var phi_13047_: f32;
    var local_112: f32;
    var phi_13036_: f32;
    var phi_13100_: f32;
    var phi_13116_: f32;
    var phi_13123_: f32;
    var phi_13128_: f32;
    var phi_13135_: f32;
    var phi_13140_: f32;
    var phi_13153_: f32;
    var phi_13160_: f32;
    var phi_13165_: f32;
    var phi_13172_: f32;
    var phi_13177_: f32;
    var phi_13182_: f32;
    var phi_13199_: f32;
    var phi_13206_: f32;
    var phi_13211_: f32;
    var phi_13218_: f32;
    var phi_13223_: f32;
    var phi_13237_: f32;
    var phi_13244_: f32;
    var phi_13249_: f32;
    var phi_13256_: f32;
    var phi_13261_: f32;
    var phi_13266_: f32;
    var phi_13283_: f32;
    var phi_13290_: f32;
    var phi_13295_: f32;
    var phi_13302_: f32;
    var phi_13307_: f32;
    var phi_13321_: f32;
    var phi_13328_: f32;
    var phi_13333_: f32;
    var phi_13340_: f32;
    var phi_13345_: f32;
    var phi_13350_: f32;
    var phi_13391_: f32;
    var phi_13397_: f32;
    var phi_13408_: type_9;
    var phi_13411_: f32;
    var phi_13409_: type_9;
    var phi_13434_: type_9;
    var phi_13463_: f32;
    var phi_13469_: f32;
    var phi_13482_: f32;
    var phi_13412_: f32;
    var local_113: f32;
    var local_114: f32;
    var phi_13510_: type_14;
    var phi_13513_: f32;
    var phi_13534_: bool;
    var phi_13540_: type_15;
    var phi_13511_: type_14;
    var phi_13554_: type_15;
    var phi_13514_: f32;
    var local_115: f32;
    var phi_13503_: f32;
    var phi_13567_: f32;
    var phi_13572_: type_9;
    var phi_13575_: f32;
    var phi_13577_: bool;
    var phi_13579_: bool;
    var phi_13573_: type_9;
    var phi_13602_: type_9;
    var phi_13639_: f32;
    var phi_13646_: f32;
    var phi_13654_: f32;
    var phi_13662_: f32;
    var phi_13669_: f32;
    var phi_13677_: f32;
    var phi_13683_: f32;
    var phi_13701_: f32;
    var phi_13707_: f32;
    var phi_13714_: f32;
    var phi_13740_: f32;
    var phi_13746_: f32;
    var phi_13782_: bool;
    var phi_13789_: bool;
    var phi_13802_: f32;
    var phi_13808_: f32;
    var phi_13809_: f32;
    var phi_13810_: f32;
    var phi_13576_: f32;
    var phi_13578_: bool;
    var phi_13580_: bool;
    var local_116: f32;
    var phi_13815_: f32;
    var local_117: bool;
    var local_118: bool;
    var phi_13824_: type_47;
    var phi_13825_: type_47;
    var phi_13826_: bool;
    var local_119: bool;
    var phi_13843_: f32;
    var phi_13844_: f32;
    var phi_13847_: type_9;
    var phi_13850_: f32;
    var phi_13852_: f32;
    var phi_13848_: type_9;
    var phi_13875_: type_9;
    var phi_13958_: f32;
    var phi_13959_: f32;
    var phi_13960_: f32;
    var phi_13943_: f32;
    var phi_13961_: f32;
    var phi_13962_: f32;
    var phi_13851_: f32;
    var phi_13853_: f32;
    var local_120: f32;
    var local_121: f32;
    var local_122: f32;
    var phi_14123_: bool;
    var phi_14124_: bool;
    var phi_14125_: bool;
    var phi_14126_: bool;
    var phi_14127_: bool;
    var phi_14128_: bool;
    var phi_14132_: bool;
    var phi_14136_: bool;
    var phi_14137_: bool;
    var phi_14138_: bool;
    var phi_14142_: f32;
    var phi_14145_: type_47;
    var phi_14146_: type_47;
    var phi_14147_: bool;
    var phi_14148_: type_47;
    var phi_14149_: type_47;
    var phi_14150_: bool;
    var phi_14155_: type_47;
    var phi_14156_: type_47;
    var phi_14157_: bool;
    var phi_14161_: type_47;
    var phi_14162_: type_47;
    var phi_14163_: bool;
    var phi_14164_: bool;
    var phi_14165_: type_47;
    var phi_14166_: type_47;
    var phi_14167_: bool;
    var phi_14168_: bool;
    var phi_14173_: type_47;
    var phi_14174_: bool;
    var phi_14178_: type_47;
    var phi_14194_: f32;
    var phi_14195_: f32;
    var phi_14196_: bool;
    var phi_14197_: f32;
    var phi_14198_: f32;
    var phi_14199_: bool;
    var phi_14200_: bool;
    var phi_14201_: bool;
    var phi_14202_: f32;
    var phi_14203_: f32;
    var phi_14204_: bool;
    var phi_14205_: bool;
    var phi_14206_: bool;
    var phi_14207_: f32;
    var phi_14208_: u32;
    var phi_14209_: f32;
    var phi_14210_: type_47;
    var phi_14211_: u32;
    var phi_14212_: u32;
    var phi_14213_: bool;
    var phi_14214_: bool;
    var phi_14215_: bool;
    var phi_14216_: f32;
    var phi_14217_: u32;
    var phi_14218_: f32;
    var phi_14219_: type_47;
    var phi_14220_: u32;
    var phi_14221_: u32;
    var phi_14222_: bool;
    var phi_14223_: bool;
    var phi_14224_: bool;
    var phi_14225_: bool;
    var phi_14226_: bool;
    var phi_14227_: f32;
    var phi_9302_: f32;
    var phi_9304_: u32;
    var phi_9306_: f32;
    var phi_14228_: type_47;
    var phi_14229_: u32;
    var phi_14230_: f32;
    var phi_14231_: u32;
    var phi_14232_: bool;
    var phi_14233_: bool;
    var phi_14234_: bool;
    var phi_14235_: bool;
    var phi_14236_: bool;
    var phi_14237_: bool;
    var local_123: bool;
    var phi_14241_: bool;
    var phi_14242_: bool;
    var phi_14243_: bool;
    var phi_14244_: bool;
    var local_124: type_47;
    var local_125: type_47;
    var phi_14261_: u32;
    var local_126: type_47;
    var phi_14266_: type_46;
    var phi_14267_: type_46;
    var phi_14268_: bool;
    var phi_14269_: bool;
    var phi_14270_: bool;
    var phi_14271_: bool;
    var phi_14275_: u32;
    var phi_14276_: f32;
    var phi_14277_: bool;
    var phi_14278_: bool;
    var phi_14279_: bool;
    var phi_14280_: bool;
    var phi_14284_: f32;
    var phi_14285_: u32;
    var phi_14286_: bool;
    var phi_14287_: bool;
    var phi_14288_: bool;
    var phi_14300_: f32;
    var phi_14303_: type_9;
    var phi_14304_: type_9;
    var phi_14327_: type_9;
    var phi_14348_: f32;
    var phi_14478_: type_14;
    var phi_14481_: f32;
    var phi_14502_: bool;
    var phi_14508_: type_15;
    var phi_14479_: type_14;
    var phi_14522_: type_15;
    var phi_14482_: f32;
    var local_127: f32;
    var phi_14471_: f32;
    var phi_14535_: f32;
    var phi_14551_: f32;
    var phi_14558_: f32;
    var phi_14563_: f32;
    var phi_14570_: f32;
    var phi_14575_: f32;
    var phi_14588_: f32;
    var phi_14595_: f32;
    var phi_14600_: f32;
    var phi_14607_: f32;
    var phi_14612_: f32;
    var phi_14617_: f32;
    var phi_14634_: f32;
    var phi_14641_: f32;
    var phi_14646_: f32;
    var phi_14653_: f32;
    var phi_14658_: f32;
    var phi_14672_: f32;
    var phi_14679_: f32;
    var phi_14684_: f32;
    var phi_14691_: f32;
    var phi_14696_: f32;
    var phi_14701_: f32;
    var phi_14718_: f32;
    var phi_14725_: f32;
    var phi_14730_: f32;
    var phi_14737_: f32;
    var phi_14742_: f32;
    var phi_14756_: f32;
    var phi_14763_: f32;
    var phi_14768_: f32;
    var phi_14775_: f32;
    var phi_14780_: f32;
    var phi_14785_: f32;
    var phi_14805_: bool;
    var phi_14806_: bool;
    var phi_14807_: bool;
    var local_128: bool;
    var phi_14815_: u32;
    var phi_14819_: type_46;
    var phi_14820_: bool;
    var phi_14828_: u32;
    var phi_14832_: type_46;
    var phi_14833_: type_46;
    var phi_14834_: bool;
    var phi_14835_: bool;
    var phi_14842_: type_46;
    var phi_14843_: bool;
    var phi_14847_: type_46;
    var phi_14848_: type_46;
    var phi_14849_: bool;
    var phi_14853_: type_46;
    var phi_22368_: type_46;
    var phi_22386_: type_29;
    var phi_22402_: array<u32, 2>;
    var phi_22423_: array<u32, 2>;
    var phi_22426_: bool;
    var phi_22441_: bool;
    var phi_22442_: bool;
    var phi_22450_: bool;
    var phi_22451_: bool;
    var phi_22456_: u32;
    var phi_22461_: type_29;
    var phi_22468_: bool;
    var phi_22493_: u32;
    var phi_22497_: type_18;
    var phi_22498_: bool;
    var phi_22499_: bool;
    var phi_22518_: u32;
    var phi_22585_: u32;
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
        phi_380_ = _e205;
    } else {
        phi_380_ = _e207;
    }
    let _e210 = phi_380_;
    let _e212 = params.member.member_1.member_1;
    if (_e210 > _e212) {
        let _e215 = params.member.member_1.member_1;
        phi_390_ = (_e210 - _e215);
    } else {
        phi_390_ = 0u;
    }
    let _e218 = phi_390_;
    let _e220 = params.member.member_1.member;
    if (_e220 < _e218) {
        phi_397_ = _e220;
    } else {
        phi_397_ = _e218;
    }
    let _e223 = phi_397_;
    let _e224 = (_e223 / 64u);
    if ((_e223 % 64u) > 0u) {
        phi_413_ = (_e224 + 1u);
    } else {
        phi_413_ = _e224;
    }
    let _e229 = phi_413_;
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
            phi_434_ = (_e233 + 1u);
        } else {
            phi_434_ = _e233;
        }
        let _e239 = phi_434_;
        phi_435_ = _e239;
    } else {
        phi_435_ = 0u;
    }
    let _e241 = phi_435_;
    phi_438_ = type_9(0u, _e241);
    loop {
        let _e244 = phi_438_;
        if (_e244.member < _e244.member_1) {
            phi_439_ = type_9((_e244.member + 1u), _e244.member_1);
            phi_462_ = type_9(1u, _e244.member);
        } else {
            phi_439_ = _e244;
            phi_462_ = type_9(0u, type_9().member_1);
        }
        let _e256 = phi_439_;
        let _e258 = phi_462_;
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
                    phi_598_ = type_22(0u, array<u32, 4>(_e280, _e306, _e309, _e312));
                } else {
                    let _e290 = (2u * _e280);
                    let _e291 = (2u * _e283);
                    let _e293 = elements.member[_e290];
                    let _e295 = elements.member[_e291];
                    let _e298 = elements.member[(_e290 + 1u)];
                    let _e301 = elements.member[(_e291 + 1u)];
                    phi_598_ = type_22(1u, array<u32, 4>(_e293, _e298, _e295, _e301));
                }
                let _e316 = phi_598_;
                local_58 = array<u32, 4>(_e316.member_1[0], _e316.member_1[1], _e316.member_1[2], _e316.member_1[3]);
                let _e324 = local_58;
                let _e330 = paths.member[_e324[0]];
                let _e344 = paths.member[_e324[1]];
                let _e358 = paths.member[_e324[2]];
                let _e372 = paths.member[_e324[3]];
                local_59 = array<array<f32, 3>, 4>(array<f32, 3>(_e330.member.x, _e330.member.y, _e330.member.z), array<f32, 3>(_e344.member.x, _e344.member.y, _e344.member.z), array<f32, 3>(_e358.member.x, _e358.member.y, _e358.member.z), array<f32, 3>(_e372.member.x, _e372.member.y, _e372.member.z));
                local_60 = array<array<f32, 3>, 4>(array<f32, 3>(_e330.member_1.x, _e330.member_1.y, _e330.member_1.z), array<f32, 3>(_e344.member_1.x, _e344.member_1.y, _e344.member_1.z), array<f32, 3>(_e358.member_1.x, _e358.member_1.y, _e358.member_1.z), array<f32, 3>(_e372.member_1.x, _e372.member_1.y, _e372.member_1.z));
                let _e396 = params.member.member.member_4;
                if (_e316.member != 0u) {
                    let _e488 = local_59[2u];
                    let _e493 = local_59[0u];
                    let _e502 = local_60[2u];
                    let _e507 = local_60[0u];
                    let _e517 = local_59[1u];
                    let _e522 = local_59[0u];
                    let _e531 = local_60[1u];
                    let _e536 = local_60[0u];
                    let _e546 = local_59[2u];
                    let _e551 = local_59[3u];
                    let _e560 = local_60[2u];
                    let _e565 = local_60[3u];
                    phi_1012_ = type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e488[0] - _e493[0]), (_e488[1] - _e493[1]), (_e488[2] - _e493[2])), array<f32, 3>((_e502[0] - _e507[0]), (_e502[1] - _e507[1]), (_e502[2] - _e507[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e517[0] - _e522[0]), (_e517[1] - _e522[1]), (_e517[2] - _e522[2])), array<f32, 3>((_e531[0] - _e536[0]), (_e531[1] - _e536[1]), (_e531[2] - _e536[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e546[0] - _e551[0]), (_e546[1] - _e551[1]), (_e546[2] - _e551[2])), array<f32, 3>((_e560[0] - _e565[0]), (_e560[1] - _e565[1]), (_e560[2] - _e565[2]))), (_e396 + _e396));
                } else {
                    let _e399 = local_59[0u];
                    let _e404 = local_59[1u];
                    let _e413 = local_60[0u];
                    let _e418 = local_60[1u];
                    let _e428 = local_59[2u];
                    let _e433 = local_59[1u];
                    let _e442 = local_60[2u];
                    let _e447 = local_60[1u];
                    let _e457 = local_59[3u];
                    let _e462 = local_59[1u];
                    let _e471 = local_60[3u];
                    let _e476 = local_60[1u];
                    phi_1012_ = type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e399[0] - _e404[0]), (_e399[1] - _e404[1]), (_e399[2] - _e404[2])), array<f32, 3>((_e413[0] - _e418[0]), (_e413[1] - _e418[1]), (_e413[2] - _e418[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e428[0] - _e433[0]), (_e428[1] - _e433[1]), (_e428[2] - _e433[2])), array<f32, 3>((_e442[0] - _e447[0]), (_e442[1] - _e447[1]), (_e442[2] - _e447[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e457[0] - _e462[0]), (_e457[1] - _e462[1]), (_e457[2] - _e462[2])), array<f32, 3>((_e471[0] - _e476[0]), (_e471[1] - _e476[1]), (_e471[2] - _e476[2]))), (_e396 + _e396));
                }
                let _e577 = phi_1012_;
                if (_e577.member[0][0] < 0f) {
                    phi_1020_ = -(_e577.member[0][0]);
                } else {
                    phi_1020_ = _e577.member[0][0];
                }
                let _e584 = phi_1020_;
                if (_e577.member[0][1] < 0f) {
                    phi_1027_ = -(_e577.member[0][1]);
                } else {
                    phi_1027_ = _e577.member[0][1];
                }
                let _e589 = phi_1027_;
                if (_e584 > _e589) {
                    phi_1032_ = _e584;
                } else {
                    phi_1032_ = _e589;
                }
                let _e592 = phi_1032_;
                if (_e577.member[0][2] < 0f) {
                    phi_1039_ = -(_e577.member[0][2]);
                } else {
                    phi_1039_ = _e577.member[0][2];
                }
                let _e597 = phi_1039_;
                if (_e592 > _e597) {
                    phi_1044_ = _e592;
                } else {
                    phi_1044_ = _e597;
                }
                let _e600 = phi_1044_;
                if (_e577.member[1][0] < 0f) {
                    phi_1052_ = -(_e577.member[1][0]);
                } else {
                    phi_1052_ = _e577.member[1][0];
                }
                let _e607 = phi_1052_;
                if (_e577.member[1][1] < 0f) {
                    phi_1059_ = -(_e577.member[1][1]);
                } else {
                    phi_1059_ = _e577.member[1][1];
                }
                let _e612 = phi_1059_;
                if (_e607 > _e612) {
                    phi_1064_ = _e607;
                } else {
                    phi_1064_ = _e612;
                }
                let _e615 = phi_1064_;
                if (_e577.member[1][2] < 0f) {
                    phi_1071_ = -(_e577.member[1][2]);
                } else {
                    phi_1071_ = _e577.member[1][2];
                }
                let _e620 = phi_1071_;
                if (_e615 > _e620) {
                    phi_1076_ = _e615;
                } else {
                    phi_1076_ = _e620;
                }
                let _e623 = phi_1076_;
                if (_e600 > _e623) {
                    phi_1081_ = _e600;
                } else {
                    phi_1081_ = _e623;
                }
                let _e626 = phi_1081_;
                if (_e577.member_1[0][0] < 0f) {
                    phi_1091_ = -(_e577.member_1[0][0]);
                } else {
                    phi_1091_ = _e577.member_1[0][0];
                }
                let _e635 = phi_1091_;
                if (_e577.member_1[0][1] < 0f) {
                    phi_1098_ = -(_e577.member_1[0][1]);
                } else {
                    phi_1098_ = _e577.member_1[0][1];
                }
                let _e640 = phi_1098_;
                if (_e635 > _e640) {
                    phi_1103_ = _e635;
                } else {
                    phi_1103_ = _e640;
                }
                let _e643 = phi_1103_;
                if (_e577.member_1[0][2] < 0f) {
                    phi_1110_ = -(_e577.member_1[0][2]);
                } else {
                    phi_1110_ = _e577.member_1[0][2];
                }
                let _e648 = phi_1110_;
                if (_e643 > _e648) {
                    phi_1115_ = _e643;
                } else {
                    phi_1115_ = _e648;
                }
                let _e651 = phi_1115_;
                if (_e577.member_1[1][0] < 0f) {
                    phi_1123_ = -(_e577.member_1[1][0]);
                } else {
                    phi_1123_ = _e577.member_1[1][0];
                }
                let _e658 = phi_1123_;
                if (_e577.member_1[1][1] < 0f) {
                    phi_1130_ = -(_e577.member_1[1][1]);
                } else {
                    phi_1130_ = _e577.member_1[1][1];
                }
                let _e663 = phi_1130_;
                if (_e658 > _e663) {
                    phi_1135_ = _e658;
                } else {
                    phi_1135_ = _e663;
                }
                let _e666 = phi_1135_;
                if (_e577.member_1[1][2] < 0f) {
                    phi_1142_ = -(_e577.member_1[1][2]);
                } else {
                    phi_1142_ = _e577.member_1[1][2];
                }
                let _e671 = phi_1142_;
                if (_e666 > _e671) {
                    phi_1147_ = _e666;
                } else {
                    phi_1147_ = _e671;
                }
                let _e674 = phi_1147_;
                if (_e651 > _e674) {
                    phi_1152_ = _e651;
                } else {
                    phi_1152_ = _e674;
                }
                let _e677 = phi_1152_;
                if (_e577.member_2[0][0] < 0f) {
                    phi_1162_ = -(_e577.member_2[0][0]);
                } else {
                    phi_1162_ = _e577.member_2[0][0];
                }
                let _e686 = phi_1162_;
                if (_e577.member_2[0][1] < 0f) {
                    phi_1169_ = -(_e577.member_2[0][1]);
                } else {
                    phi_1169_ = _e577.member_2[0][1];
                }
                let _e691 = phi_1169_;
                if (_e686 > _e691) {
                    phi_1174_ = _e686;
                } else {
                    phi_1174_ = _e691;
                }
                let _e694 = phi_1174_;
                if (_e577.member_2[0][2] < 0f) {
                    phi_1181_ = -(_e577.member_2[0][2]);
                } else {
                    phi_1181_ = _e577.member_2[0][2];
                }
                let _e699 = phi_1181_;
                if (_e694 > _e699) {
                    phi_1186_ = _e694;
                } else {
                    phi_1186_ = _e699;
                }
                let _e702 = phi_1186_;
                if (_e577.member_2[1][0] < 0f) {
                    phi_1194_ = -(_e577.member_2[1][0]);
                } else {
                    phi_1194_ = _e577.member_2[1][0];
                }
                let _e709 = phi_1194_;
                if (_e577.member_2[1][1] < 0f) {
                    phi_1201_ = -(_e577.member_2[1][1]);
                } else {
                    phi_1201_ = _e577.member_2[1][1];
                }
                let _e714 = phi_1201_;
                if (_e709 > _e714) {
                    phi_1206_ = _e709;
                } else {
                    phi_1206_ = _e714;
                }
                let _e717 = phi_1206_;
                if (_e577.member_2[1][2] < 0f) {
                    phi_1213_ = -(_e577.member_2[1][2]);
                } else {
                    phi_1213_ = _e577.member_2[1][2];
                }
                let _e722 = phi_1213_;
                if (_e717 > _e722) {
                    phi_1218_ = _e717;
                } else {
                    phi_1218_ = _e722;
                }
                let _e725 = phi_1218_;
                if (_e702 > _e725) {
                    phi_1223_ = _e702;
                } else {
                    phi_1223_ = _e725;
                }
                let _e728 = phi_1223_;
                let _e731 = function_((_e626 + _e577.member_3), (_e677 + _e577.member_3));
                let _e732 = function_(_e731, (_e728 + _e577.member_3));
                let _e737 = bitcast<i32>(((bitcast<u32>(_e732) + 4u) >> bitcast<u32>(23i)));
                if (_e737 >= 64i) {
                    if (_e737 <= 190i) {
                        phi_1241_ = (_e737 - 126i);
                        phi_1242_ = false;
                    } else {
                        phi_1241_ = i32();
                        phi_1242_ = true;
                    }
                    let _e742 = phi_1241_;
                    let _e744 = phi_1242_;
                    phi_1243_ = _e742;
                    phi_1244_ = _e744;
                } else {
                    phi_1243_ = i32();
                    phi_1244_ = true;
                }
                let _e746 = phi_1243_;
                let _e748 = phi_1244_;
                if _e748 {
                    phi_1248_ = 2147483647i;
                } else {
                    phi_1248_ = _e746;
                }
                let _e750 = phi_1248_;
                let _e752 = params.member.member_2.member_3;
                if (_e752 > 0u) {
                    if (_e750 != 2147483647i) {
                        let _e756 = params.member.member.member_1;
                        if ((_e756 & 8u) != 0u) {
                            let _e1053 = local_59[0u];
                            let _e1057 = bitcast<u32>(_e1053[0]);
                            let _e1058 = (_e1057 & 2147483647u);
                            if (_e1058 < 8388608u) {
                                phi_1290_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1290_ = array<u32, 2>((_e1057 << bitcast<u32>(29i)), ((_e1057 ^ _e1058) | ((_e1058 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1069 = phi_1290_;
                            let _e1070 = function_13(_e1069, _e750);
                            let _e1071 = bitcast<u32>(_e1053[1]);
                            let _e1072 = (_e1071 & 2147483647u);
                            if (_e1072 < 8388608u) {
                                phi_1307_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1307_ = array<u32, 2>((_e1071 << bitcast<u32>(29i)), ((_e1071 ^ _e1072) | ((_e1072 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1083 = phi_1307_;
                            let _e1084 = function_13(_e1083, _e750);
                            let _e1085 = bitcast<u32>(_e1053[2]);
                            let _e1086 = (_e1085 & 2147483647u);
                            if (_e1086 < 8388608u) {
                                phi_1324_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1324_ = array<u32, 2>((_e1085 << bitcast<u32>(29i)), ((_e1085 ^ _e1086) | ((_e1086 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1097 = phi_1324_;
                            let _e1098 = function_13(_e1097, _e750);
                            let _e1104 = local_60[0u];
                            let _e1108 = bitcast<u32>(_e1104[0]);
                            let _e1109 = (_e1108 & 2147483647u);
                            if (_e1109 < 8388608u) {
                                phi_1358_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1358_ = array<u32, 2>((_e1108 << bitcast<u32>(29i)), ((_e1108 ^ _e1109) | ((_e1109 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1120 = phi_1358_;
                            let _e1121 = function_13(_e1120, _e750);
                            let _e1122 = bitcast<u32>(_e1104[1]);
                            let _e1123 = (_e1122 & 2147483647u);
                            if (_e1123 < 8388608u) {
                                phi_1375_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1375_ = array<u32, 2>((_e1122 << bitcast<u32>(29i)), ((_e1122 ^ _e1123) | ((_e1123 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1134 = phi_1375_;
                            let _e1135 = function_13(_e1134, _e750);
                            let _e1136 = bitcast<u32>(_e1104[2]);
                            let _e1137 = (_e1136 & 2147483647u);
                            if (_e1137 < 8388608u) {
                                phi_1392_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1392_ = array<u32, 2>((_e1136 << bitcast<u32>(29i)), ((_e1136 ^ _e1137) | ((_e1137 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1148 = phi_1392_;
                            let _e1149 = function_13(_e1148, _e750);
                            let _e1156 = local_59[1u];
                            let _e1160 = bitcast<u32>(_e1156[0]);
                            let _e1161 = (_e1160 & 2147483647u);
                            if (_e1161 < 8388608u) {
                                phi_1427_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1427_ = array<u32, 2>((_e1160 << bitcast<u32>(29i)), ((_e1160 ^ _e1161) | ((_e1161 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1172 = phi_1427_;
                            let _e1173 = function_13(_e1172, _e750);
                            let _e1174 = bitcast<u32>(_e1156[1]);
                            let _e1175 = (_e1174 & 2147483647u);
                            if (_e1175 < 8388608u) {
                                phi_1444_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1444_ = array<u32, 2>((_e1174 << bitcast<u32>(29i)), ((_e1174 ^ _e1175) | ((_e1175 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1186 = phi_1444_;
                            let _e1187 = function_13(_e1186, _e750);
                            let _e1188 = bitcast<u32>(_e1156[2]);
                            let _e1189 = (_e1188 & 2147483647u);
                            if (_e1189 < 8388608u) {
                                phi_1461_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1461_ = array<u32, 2>((_e1188 << bitcast<u32>(29i)), ((_e1188 ^ _e1189) | ((_e1189 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1200 = phi_1461_;
                            let _e1201 = function_13(_e1200, _e750);
                            let _e1207 = local_60[1u];
                            let _e1211 = bitcast<u32>(_e1207[0]);
                            let _e1212 = (_e1211 & 2147483647u);
                            if (_e1212 < 8388608u) {
                                phi_1495_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1495_ = array<u32, 2>((_e1211 << bitcast<u32>(29i)), ((_e1211 ^ _e1212) | ((_e1212 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1223 = phi_1495_;
                            let _e1224 = function_13(_e1223, _e750);
                            let _e1225 = bitcast<u32>(_e1207[1]);
                            let _e1226 = (_e1225 & 2147483647u);
                            if (_e1226 < 8388608u) {
                                phi_1512_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1512_ = array<u32, 2>((_e1225 << bitcast<u32>(29i)), ((_e1225 ^ _e1226) | ((_e1226 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1237 = phi_1512_;
                            let _e1238 = function_13(_e1237, _e750);
                            let _e1239 = bitcast<u32>(_e1207[2]);
                            let _e1240 = (_e1239 & 2147483647u);
                            if (_e1240 < 8388608u) {
                                phi_1529_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1529_ = array<u32, 2>((_e1239 << bitcast<u32>(29i)), ((_e1239 ^ _e1240) | ((_e1240 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1251 = phi_1529_;
                            let _e1252 = function_13(_e1251, _e750);
                            let _e1259 = local_59[2u];
                            let _e1263 = bitcast<u32>(_e1259[0]);
                            let _e1264 = (_e1263 & 2147483647u);
                            if (_e1264 < 8388608u) {
                                phi_1564_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1564_ = array<u32, 2>((_e1263 << bitcast<u32>(29i)), ((_e1263 ^ _e1264) | ((_e1264 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1275 = phi_1564_;
                            let _e1276 = function_13(_e1275, _e750);
                            let _e1277 = bitcast<u32>(_e1259[1]);
                            let _e1278 = (_e1277 & 2147483647u);
                            if (_e1278 < 8388608u) {
                                phi_1581_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1581_ = array<u32, 2>((_e1277 << bitcast<u32>(29i)), ((_e1277 ^ _e1278) | ((_e1278 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1289 = phi_1581_;
                            let _e1290 = function_13(_e1289, _e750);
                            let _e1291 = bitcast<u32>(_e1259[2]);
                            let _e1292 = (_e1291 & 2147483647u);
                            if (_e1292 < 8388608u) {
                                phi_1598_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1598_ = array<u32, 2>((_e1291 << bitcast<u32>(29i)), ((_e1291 ^ _e1292) | ((_e1292 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1303 = phi_1598_;
                            let _e1304 = function_13(_e1303, _e750);
                            let _e1310 = local_60[2u];
                            let _e1314 = bitcast<u32>(_e1310[0]);
                            let _e1315 = (_e1314 & 2147483647u);
                            if (_e1315 < 8388608u) {
                                phi_1632_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1632_ = array<u32, 2>((_e1314 << bitcast<u32>(29i)), ((_e1314 ^ _e1315) | ((_e1315 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1326 = phi_1632_;
                            let _e1327 = function_13(_e1326, _e750);
                            let _e1328 = bitcast<u32>(_e1310[1]);
                            let _e1329 = (_e1328 & 2147483647u);
                            if (_e1329 < 8388608u) {
                                phi_1649_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1649_ = array<u32, 2>((_e1328 << bitcast<u32>(29i)), ((_e1328 ^ _e1329) | ((_e1329 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1340 = phi_1649_;
                            let _e1341 = function_13(_e1340, _e750);
                            let _e1342 = bitcast<u32>(_e1310[2]);
                            let _e1343 = (_e1342 & 2147483647u);
                            if (_e1343 < 8388608u) {
                                phi_1666_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1666_ = array<u32, 2>((_e1342 << bitcast<u32>(29i)), ((_e1342 ^ _e1343) | ((_e1343 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1354 = phi_1666_;
                            let _e1355 = function_13(_e1354, _e750);
                            let _e1362 = local_59[3u];
                            let _e1366 = bitcast<u32>(_e1362[0]);
                            let _e1367 = (_e1366 & 2147483647u);
                            if (_e1367 < 8388608u) {
                                phi_1701_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1701_ = array<u32, 2>((_e1366 << bitcast<u32>(29i)), ((_e1366 ^ _e1367) | ((_e1367 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1378 = phi_1701_;
                            let _e1379 = function_13(_e1378, _e750);
                            let _e1380 = bitcast<u32>(_e1362[1]);
                            let _e1381 = (_e1380 & 2147483647u);
                            if (_e1381 < 8388608u) {
                                phi_1718_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1718_ = array<u32, 2>((_e1380 << bitcast<u32>(29i)), ((_e1380 ^ _e1381) | ((_e1381 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1392 = phi_1718_;
                            let _e1393 = function_13(_e1392, _e750);
                            let _e1394 = bitcast<u32>(_e1362[2]);
                            let _e1395 = (_e1394 & 2147483647u);
                            if (_e1395 < 8388608u) {
                                phi_1735_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1735_ = array<u32, 2>((_e1394 << bitcast<u32>(29i)), ((_e1394 ^ _e1395) | ((_e1395 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1406 = phi_1735_;
                            let _e1407 = function_13(_e1406, _e750);
                            let _e1413 = local_60[3u];
                            let _e1417 = bitcast<u32>(_e1413[0]);
                            let _e1418 = (_e1417 & 2147483647u);
                            if (_e1418 < 8388608u) {
                                phi_1769_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1769_ = array<u32, 2>((_e1417 << bitcast<u32>(29i)), ((_e1417 ^ _e1418) | ((_e1418 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1429 = phi_1769_;
                            let _e1430 = function_13(_e1429, _e750);
                            let _e1431 = bitcast<u32>(_e1413[1]);
                            let _e1432 = (_e1431 & 2147483647u);
                            if (_e1432 < 8388608u) {
                                phi_1786_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1786_ = array<u32, 2>((_e1431 << bitcast<u32>(29i)), ((_e1431 ^ _e1432) | ((_e1432 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1443 = phi_1786_;
                            let _e1444 = function_13(_e1443, _e750);
                            let _e1445 = bitcast<u32>(_e1413[2]);
                            let _e1446 = (_e1445 & 2147483647u);
                            if (_e1446 < 8388608u) {
                                phi_1803_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1803_ = array<u32, 2>((_e1445 << bitcast<u32>(29i)), ((_e1445 ^ _e1446) | ((_e1446 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1457 = phi_1803_;
                            let _e1458 = function_13(_e1457, _e750);
                            phi_2720_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e1070, _e1084, type_9(_e1098.member, _e1098.member_1)), array<type_9, 3>(_e1121, _e1135, type_9(_e1149.member, _e1149.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1173, _e1187, type_9(_e1201.member, _e1201.member_1)), array<type_9, 3>(_e1224, _e1238, type_9(_e1252.member, _e1252.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1276, _e1290, type_9(_e1304.member, _e1304.member_1)), array<type_9, 3>(_e1327, _e1341, type_9(_e1355.member, _e1355.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1379, _e1393, type_9(_e1407.member, _e1407.member_1)), array<type_9, 3>(_e1430, _e1444, type_9(_e1458.member, _e1458.member_1))));
                        } else {
                            let _e761 = params.member.member.member_10[1u];
                            local_61 = (_e750 - (bitcast<i32>((_e761 >> bitcast<u32>(20i))) - 1023i));
                            let _e768 = local_58[0u];
                            let _e771 = params.member.member.member[0u];
                            let _e773 = (6u * (_e771 + _e768));
                            let _e774 = (6u * _e768);
                            let _e775 = local_61;
                            local_57 = _e775;
                            let _e777 = positions.member[_e774];
                            let _e780 = positions.member[(_e774 + 1u)];
                            let _e782 = local_57;
                            let _e783 = function_13(array<u32, 2>(_e777, _e780), _e782);
                            let _e786 = positions.member[(_e774 + 2u)];
                            let _e789 = positions.member[(_e774 + 3u)];
                            let _e791 = local_57;
                            let _e792 = function_13(array<u32, 2>(_e786, _e789), _e791);
                            let _e795 = positions.member[(_e774 + 4u)];
                            let _e798 = positions.member[(_e774 + 5u)];
                            let _e800 = local_57;
                            let _e801 = function_13(array<u32, 2>(_e795, _e798), _e800);
                            let _e806 = local_61;
                            local_56 = _e806;
                            let _e808 = positions.member[_e773];
                            let _e811 = positions.member[(_e773 + 1u)];
                            let _e813 = local_56;
                            let _e814 = function_13(array<u32, 2>(_e808, _e811), _e813);
                            let _e817 = positions.member[(_e773 + 2u)];
                            let _e820 = positions.member[(_e773 + 3u)];
                            let _e822 = local_56;
                            let _e823 = function_13(array<u32, 2>(_e817, _e820), _e822);
                            let _e826 = positions.member[(_e773 + 4u)];
                            let _e829 = positions.member[(_e773 + 5u)];
                            let _e831 = local_56;
                            let _e832 = function_13(array<u32, 2>(_e826, _e829), _e831);
                            let _e839 = local_58[1u];
                            let _e842 = params.member.member.member[0u];
                            let _e844 = (6u * (_e842 + _e839));
                            let _e845 = (6u * _e839);
                            let _e846 = local_61;
                            local_55 = _e846;
                            let _e848 = positions.member[_e845];
                            let _e851 = positions.member[(_e845 + 1u)];
                            let _e853 = local_55;
                            let _e854 = function_13(array<u32, 2>(_e848, _e851), _e853);
                            let _e857 = positions.member[(_e845 + 2u)];
                            let _e860 = positions.member[(_e845 + 3u)];
                            let _e862 = local_55;
                            let _e863 = function_13(array<u32, 2>(_e857, _e860), _e862);
                            let _e866 = positions.member[(_e845 + 4u)];
                            let _e869 = positions.member[(_e845 + 5u)];
                            let _e871 = local_55;
                            let _e872 = function_13(array<u32, 2>(_e866, _e869), _e871);
                            let _e877 = local_61;
                            local_54 = _e877;
                            let _e879 = positions.member[_e844];
                            let _e882 = positions.member[(_e844 + 1u)];
                            let _e884 = local_54;
                            let _e885 = function_13(array<u32, 2>(_e879, _e882), _e884);
                            let _e888 = positions.member[(_e844 + 2u)];
                            let _e891 = positions.member[(_e844 + 3u)];
                            let _e893 = local_54;
                            let _e894 = function_13(array<u32, 2>(_e888, _e891), _e893);
                            let _e897 = positions.member[(_e844 + 4u)];
                            let _e900 = positions.member[(_e844 + 5u)];
                            let _e902 = local_54;
                            let _e903 = function_13(array<u32, 2>(_e897, _e900), _e902);
                            let _e910 = local_58[2u];
                            let _e913 = params.member.member.member[0u];
                            let _e915 = (6u * (_e913 + _e910));
                            let _e916 = (6u * _e910);
                            let _e917 = local_61;
                            local_53 = _e917;
                            let _e919 = positions.member[_e916];
                            let _e922 = positions.member[(_e916 + 1u)];
                            let _e924 = local_53;
                            let _e925 = function_13(array<u32, 2>(_e919, _e922), _e924);
                            let _e928 = positions.member[(_e916 + 2u)];
                            let _e931 = positions.member[(_e916 + 3u)];
                            let _e933 = local_53;
                            let _e934 = function_13(array<u32, 2>(_e928, _e931), _e933);
                            let _e937 = positions.member[(_e916 + 4u)];
                            let _e940 = positions.member[(_e916 + 5u)];
                            let _e942 = local_53;
                            let _e943 = function_13(array<u32, 2>(_e937, _e940), _e942);
                            let _e948 = local_61;
                            local_52 = _e948;
                            let _e950 = positions.member[_e915];
                            let _e953 = positions.member[(_e915 + 1u)];
                            let _e955 = local_52;
                            let _e956 = function_13(array<u32, 2>(_e950, _e953), _e955);
                            let _e959 = positions.member[(_e915 + 2u)];
                            let _e962 = positions.member[(_e915 + 3u)];
                            let _e964 = local_52;
                            let _e965 = function_13(array<u32, 2>(_e959, _e962), _e964);
                            let _e968 = positions.member[(_e915 + 4u)];
                            let _e971 = positions.member[(_e915 + 5u)];
                            let _e973 = local_52;
                            let _e974 = function_13(array<u32, 2>(_e968, _e971), _e973);
                            let _e981 = local_58[3u];
                            let _e984 = params.member.member.member[0u];
                            let _e986 = (6u * (_e984 + _e981));
                            let _e987 = (6u * _e981);
                            let _e988 = local_61;
                            local_51 = _e988;
                            let _e990 = positions.member[_e987];
                            let _e993 = positions.member[(_e987 + 1u)];
                            let _e995 = local_51;
                            let _e996 = function_13(array<u32, 2>(_e990, _e993), _e995);
                            let _e999 = positions.member[(_e987 + 2u)];
                            let _e1002 = positions.member[(_e987 + 3u)];
                            let _e1004 = local_51;
                            let _e1005 = function_13(array<u32, 2>(_e999, _e1002), _e1004);
                            let _e1008 = positions.member[(_e987 + 4u)];
                            let _e1011 = positions.member[(_e987 + 5u)];
                            let _e1013 = local_51;
                            let _e1014 = function_13(array<u32, 2>(_e1008, _e1011), _e1013);
                            let _e1019 = local_61;
                            local_50 = _e1019;
                            let _e1021 = positions.member[_e986];
                            let _e1024 = positions.member[(_e986 + 1u)];
                            let _e1026 = local_50;
                            let _e1027 = function_13(array<u32, 2>(_e1021, _e1024), _e1026);
                            let _e1030 = positions.member[(_e986 + 2u)];
                            let _e1033 = positions.member[(_e986 + 3u)];
                            let _e1035 = local_50;
                            let _e1036 = function_13(array<u32, 2>(_e1030, _e1033), _e1035);
                            let _e1039 = positions.member[(_e986 + 4u)];
                            let _e1042 = positions.member[(_e986 + 5u)];
                            let _e1044 = local_50;
                            let _e1045 = function_13(array<u32, 2>(_e1039, _e1042), _e1044);
                            phi_2720_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e783, _e792, type_9(_e801.member, _e801.member_1)), array<type_9, 3>(_e814, _e823, type_9(_e832.member, _e832.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e854, _e863, type_9(_e872.member, _e872.member_1)), array<type_9, 3>(_e885, _e894, type_9(_e903.member, _e903.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e925, _e934, type_9(_e943.member, _e943.member_1)), array<type_9, 3>(_e956, _e965, type_9(_e974.member, _e974.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e996, _e1005, type_9(_e1014.member, _e1014.member_1)), array<type_9, 3>(_e1027, _e1036, type_9(_e1045.member, _e1045.member_1))));
                        }
                        let _e1466 = phi_2720_;
                        let _e1468 = params.member.member_2.member_1;
                        let _e1470 = params.member.member_2.member_2;
                        let _e1472 = params.member.member_2.member_3;
                        if (_e316.member != 0u) {
                            if (_e1466[2][0][0].member_1 < _e1466[0][0][0].member_1) {
                                phi_2741_ = 1u;
                            } else {
                                phi_2741_ = 0u;
                            }
                            let _e1792 = phi_2741_;
                            if (_e1466[2][0][1].member_1 < _e1466[0][0][1].member_1) {
                                phi_2753_ = 1u;
                            } else {
                                phi_2753_ = 0u;
                            }
                            let _e1806 = phi_2753_;
                            if (_e1466[2][0][2].member_1 < _e1466[0][0][2].member_1) {
                                phi_2765_ = 1u;
                            } else {
                                phi_2765_ = 0u;
                            }
                            let _e1820 = phi_2765_;
                            if (_e1466[2][1][0].member_1 < _e1466[0][1][0].member_1) {
                                phi_2785_ = 1u;
                            } else {
                                phi_2785_ = 0u;
                            }
                            let _e1842 = phi_2785_;
                            if (_e1466[2][1][1].member_1 < _e1466[0][1][1].member_1) {
                                phi_2797_ = 1u;
                            } else {
                                phi_2797_ = 0u;
                            }
                            let _e1856 = phi_2797_;
                            if (_e1466[2][1][2].member_1 < _e1466[0][1][2].member_1) {
                                phi_2809_ = 1u;
                            } else {
                                phi_2809_ = 0u;
                            }
                            let _e1870 = phi_2809_;
                            if (_e1466[1][0][0].member_1 < _e1466[0][0][0].member_1) {
                                phi_2830_ = 1u;
                            } else {
                                phi_2830_ = 0u;
                            }
                            let _e1893 = phi_2830_;
                            if (_e1466[1][0][1].member_1 < _e1466[0][0][1].member_1) {
                                phi_2842_ = 1u;
                            } else {
                                phi_2842_ = 0u;
                            }
                            let _e1907 = phi_2842_;
                            if (_e1466[1][0][2].member_1 < _e1466[0][0][2].member_1) {
                                phi_2854_ = 1u;
                            } else {
                                phi_2854_ = 0u;
                            }
                            let _e1921 = phi_2854_;
                            if (_e1466[1][1][0].member_1 < _e1466[0][1][0].member_1) {
                                phi_2874_ = 1u;
                            } else {
                                phi_2874_ = 0u;
                            }
                            let _e1943 = phi_2874_;
                            if (_e1466[1][1][1].member_1 < _e1466[0][1][1].member_1) {
                                phi_2886_ = 1u;
                            } else {
                                phi_2886_ = 0u;
                            }
                            let _e1957 = phi_2886_;
                            if (_e1466[1][1][2].member_1 < _e1466[0][1][2].member_1) {
                                phi_2898_ = 1u;
                            } else {
                                phi_2898_ = 0u;
                            }
                            let _e1971 = phi_2898_;
                            if (_e1466[2][0][0].member_1 < _e1466[3][0][0].member_1) {
                                phi_2919_ = 1u;
                            } else {
                                phi_2919_ = 0u;
                            }
                            let _e1994 = phi_2919_;
                            if (_e1466[2][0][1].member_1 < _e1466[3][0][1].member_1) {
                                phi_2931_ = 1u;
                            } else {
                                phi_2931_ = 0u;
                            }
                            let _e2008 = phi_2931_;
                            if (_e1466[2][0][2].member_1 < _e1466[3][0][2].member_1) {
                                phi_2943_ = 1u;
                            } else {
                                phi_2943_ = 0u;
                            }
                            let _e2022 = phi_2943_;
                            if (_e1466[2][1][0].member_1 < _e1466[3][1][0].member_1) {
                                phi_2963_ = 1u;
                            } else {
                                phi_2963_ = 0u;
                            }
                            let _e2044 = phi_2963_;
                            if (_e1466[2][1][1].member_1 < _e1466[3][1][1].member_1) {
                                phi_2975_ = 1u;
                            } else {
                                phi_2975_ = 0u;
                            }
                            let _e2058 = phi_2975_;
                            if (_e1466[2][1][2].member_1 < _e1466[3][1][2].member_1) {
                                phi_2987_ = 1u;
                            } else {
                                phi_2987_ = 0u;
                            }
                            let _e2072 = phi_2987_;
                            phi_3267_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1466[2][0][0].member - _e1466[0][0][0].member) - _e1792), (_e1466[2][0][0].member_1 - _e1466[0][0][0].member_1)), type_9(((_e1466[2][0][1].member - _e1466[0][0][1].member) - _e1806), (_e1466[2][0][1].member_1 - _e1466[0][0][1].member_1)), type_9(((_e1466[2][0][2].member - _e1466[0][0][2].member) - _e1820), (_e1466[2][0][2].member_1 - _e1466[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1466[2][1][0].member - _e1466[0][1][0].member) - _e1842), (_e1466[2][1][0].member_1 - _e1466[0][1][0].member_1)), type_9(((_e1466[2][1][1].member - _e1466[0][1][1].member) - _e1856), (_e1466[2][1][1].member_1 - _e1466[0][1][1].member_1)), type_9(((_e1466[2][1][2].member - _e1466[0][1][2].member) - _e1870), (_e1466[2][1][2].member_1 - _e1466[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1466[1][0][0].member - _e1466[0][0][0].member) - _e1893), (_e1466[1][0][0].member_1 - _e1466[0][0][0].member_1)), type_9(((_e1466[1][0][1].member - _e1466[0][0][1].member) - _e1907), (_e1466[1][0][1].member_1 - _e1466[0][0][1].member_1)), type_9(((_e1466[1][0][2].member - _e1466[0][0][2].member) - _e1921), (_e1466[1][0][2].member_1 - _e1466[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1466[1][1][0].member - _e1466[0][1][0].member) - _e1943), (_e1466[1][1][0].member_1 - _e1466[0][1][0].member_1)), type_9(((_e1466[1][1][1].member - _e1466[0][1][1].member) - _e1957), (_e1466[1][1][1].member_1 - _e1466[0][1][1].member_1)), type_9(((_e1466[1][1][2].member - _e1466[0][1][2].member) - _e1971), (_e1466[1][1][2].member_1 - _e1466[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1466[2][0][0].member - _e1466[3][0][0].member) - _e1994), (_e1466[2][0][0].member_1 - _e1466[3][0][0].member_1)), type_9(((_e1466[2][0][1].member - _e1466[3][0][1].member) - _e2008), (_e1466[2][0][1].member_1 - _e1466[3][0][1].member_1)), type_9(((_e1466[2][0][2].member - _e1466[3][0][2].member) - _e2022), (_e1466[2][0][2].member_1 - _e1466[3][0][2].member_1))), array<type_9, 3>(type_9(((_e1466[2][1][0].member - _e1466[3][1][0].member) - _e2044), (_e1466[2][1][0].member_1 - _e1466[3][1][0].member_1)), type_9(((_e1466[2][1][1].member - _e1466[3][1][1].member) - _e2058), (_e1466[2][1][1].member_1 - _e1466[3][1][1].member_1)), type_9(((_e1466[2][1][2].member - _e1466[3][1][2].member) - _e2072), (_e1466[2][1][2].member_1 - _e1466[3][1][2].member_1)))));
                        } else {
                            if (_e1466[0][0][0].member_1 < _e1466[1][0][0].member_1) {
                                phi_3009_ = 1u;
                            } else {
                                phi_3009_ = 0u;
                            }
                            let _e1488 = phi_3009_;
                            if (_e1466[0][0][1].member_1 < _e1466[1][0][1].member_1) {
                                phi_3021_ = 1u;
                            } else {
                                phi_3021_ = 0u;
                            }
                            let _e1502 = phi_3021_;
                            if (_e1466[0][0][2].member_1 < _e1466[1][0][2].member_1) {
                                phi_3033_ = 1u;
                            } else {
                                phi_3033_ = 0u;
                            }
                            let _e1516 = phi_3033_;
                            if (_e1466[0][1][0].member_1 < _e1466[1][1][0].member_1) {
                                phi_3053_ = 1u;
                            } else {
                                phi_3053_ = 0u;
                            }
                            let _e1538 = phi_3053_;
                            if (_e1466[0][1][1].member_1 < _e1466[1][1][1].member_1) {
                                phi_3065_ = 1u;
                            } else {
                                phi_3065_ = 0u;
                            }
                            let _e1552 = phi_3065_;
                            if (_e1466[0][1][2].member_1 < _e1466[1][1][2].member_1) {
                                phi_3077_ = 1u;
                            } else {
                                phi_3077_ = 0u;
                            }
                            let _e1566 = phi_3077_;
                            if (_e1466[2][0][0].member_1 < _e1466[1][0][0].member_1) {
                                phi_3098_ = 1u;
                            } else {
                                phi_3098_ = 0u;
                            }
                            let _e1589 = phi_3098_;
                            if (_e1466[2][0][1].member_1 < _e1466[1][0][1].member_1) {
                                phi_3110_ = 1u;
                            } else {
                                phi_3110_ = 0u;
                            }
                            let _e1603 = phi_3110_;
                            if (_e1466[2][0][2].member_1 < _e1466[1][0][2].member_1) {
                                phi_3122_ = 1u;
                            } else {
                                phi_3122_ = 0u;
                            }
                            let _e1617 = phi_3122_;
                            if (_e1466[2][1][0].member_1 < _e1466[1][1][0].member_1) {
                                phi_3142_ = 1u;
                            } else {
                                phi_3142_ = 0u;
                            }
                            let _e1639 = phi_3142_;
                            if (_e1466[2][1][1].member_1 < _e1466[1][1][1].member_1) {
                                phi_3154_ = 1u;
                            } else {
                                phi_3154_ = 0u;
                            }
                            let _e1653 = phi_3154_;
                            if (_e1466[2][1][2].member_1 < _e1466[1][1][2].member_1) {
                                phi_3166_ = 1u;
                            } else {
                                phi_3166_ = 0u;
                            }
                            let _e1667 = phi_3166_;
                            if (_e1466[3][0][0].member_1 < _e1466[1][0][0].member_1) {
                                phi_3187_ = 1u;
                            } else {
                                phi_3187_ = 0u;
                            }
                            let _e1690 = phi_3187_;
                            if (_e1466[3][0][1].member_1 < _e1466[1][0][1].member_1) {
                                phi_3199_ = 1u;
                            } else {
                                phi_3199_ = 0u;
                            }
                            let _e1704 = phi_3199_;
                            if (_e1466[3][0][2].member_1 < _e1466[1][0][2].member_1) {
                                phi_3211_ = 1u;
                            } else {
                                phi_3211_ = 0u;
                            }
                            let _e1718 = phi_3211_;
                            if (_e1466[3][1][0].member_1 < _e1466[1][1][0].member_1) {
                                phi_3231_ = 1u;
                            } else {
                                phi_3231_ = 0u;
                            }
                            let _e1740 = phi_3231_;
                            if (_e1466[3][1][1].member_1 < _e1466[1][1][1].member_1) {
                                phi_3243_ = 1u;
                            } else {
                                phi_3243_ = 0u;
                            }
                            let _e1754 = phi_3243_;
                            if (_e1466[3][1][2].member_1 < _e1466[1][1][2].member_1) {
                                phi_3255_ = 1u;
                            } else {
                                phi_3255_ = 0u;
                            }
                            let _e1768 = phi_3255_;
                            phi_3267_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1466[0][0][0].member - _e1466[1][0][0].member) - _e1488), (_e1466[0][0][0].member_1 - _e1466[1][0][0].member_1)), type_9(((_e1466[0][0][1].member - _e1466[1][0][1].member) - _e1502), (_e1466[0][0][1].member_1 - _e1466[1][0][1].member_1)), type_9(((_e1466[0][0][2].member - _e1466[1][0][2].member) - _e1516), (_e1466[0][0][2].member_1 - _e1466[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1466[0][1][0].member - _e1466[1][1][0].member) - _e1538), (_e1466[0][1][0].member_1 - _e1466[1][1][0].member_1)), type_9(((_e1466[0][1][1].member - _e1466[1][1][1].member) - _e1552), (_e1466[0][1][1].member_1 - _e1466[1][1][1].member_1)), type_9(((_e1466[0][1][2].member - _e1466[1][1][2].member) - _e1566), (_e1466[0][1][2].member_1 - _e1466[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1466[2][0][0].member - _e1466[1][0][0].member) - _e1589), (_e1466[2][0][0].member_1 - _e1466[1][0][0].member_1)), type_9(((_e1466[2][0][1].member - _e1466[1][0][1].member) - _e1603), (_e1466[2][0][1].member_1 - _e1466[1][0][1].member_1)), type_9(((_e1466[2][0][2].member - _e1466[1][0][2].member) - _e1617), (_e1466[2][0][2].member_1 - _e1466[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1466[2][1][0].member - _e1466[1][1][0].member) - _e1639), (_e1466[2][1][0].member_1 - _e1466[1][1][0].member_1)), type_9(((_e1466[2][1][1].member - _e1466[1][1][1].member) - _e1653), (_e1466[2][1][1].member_1 - _e1466[1][1][1].member_1)), type_9(((_e1466[2][1][2].member - _e1466[1][1][2].member) - _e1667), (_e1466[2][1][2].member_1 - _e1466[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1466[3][0][0].member - _e1466[1][0][0].member) - _e1690), (_e1466[3][0][0].member_1 - _e1466[1][0][0].member_1)), type_9(((_e1466[3][0][1].member - _e1466[1][0][1].member) - _e1704), (_e1466[3][0][1].member_1 - _e1466[1][0][1].member_1)), type_9(((_e1466[3][0][2].member - _e1466[1][0][2].member) - _e1718), (_e1466[3][0][2].member_1 - _e1466[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1466[3][1][0].member - _e1466[1][1][0].member) - _e1740), (_e1466[3][1][0].member_1 - _e1466[1][1][0].member_1)), type_9(((_e1466[3][1][1].member - _e1466[1][1][1].member) - _e1754), (_e1466[3][1][1].member_1 - _e1466[1][1][1].member_1)), type_9(((_e1466[3][1][2].member - _e1466[1][1][2].member) - _e1768), (_e1466[3][1][2].member_1 - _e1466[1][1][2].member_1)))));
                        }
                        let _e2083 = phi_3267_;
                        local_48 = array<type_9, 3>(type_9(_e2083[1][0][0].member, _e2083[1][0][0].member_1), type_9(_e2083[1][0][1].member, _e2083[1][0][1].member_1), type_9(_e2083[1][0][2].member, _e2083[1][0][2].member_1));
                        local_49 = array<type_9, 3>(type_9(_e2083[2][0][0].member, _e2083[2][0][0].member_1), type_9(_e2083[2][0][1].member, _e2083[2][0][1].member_1), type_9(_e2083[2][0][2].member, _e2083[2][0][2].member_1));
                        let _e2116 = local_48[1u].member;
                        let _e2118 = local_48[1u].member_1;
                        let _e2121 = local_49[2u].member;
                        let _e2123 = local_49[2u].member_1;
                        let _e2124 = function_9(_e2116, _e2118, _e2121, _e2123);
                        let _e2129 = local_48[2u].member;
                        let _e2131 = local_48[2u].member_1;
                        let _e2134 = local_49[1u].member;
                        let _e2136 = local_49[1u].member_1;
                        let _e2137 = function_9(_e2129, _e2131, _e2134, _e2136);
                        if (_e2124.member_1 < _e2137.member_1) {
                            phi_3346_ = 1u;
                        } else {
                            phi_3346_ = 0u;
                        }
                        let _e2142 = phi_3346_;
                        let _e2144 = ((_e2124.member - _e2137.member) - _e2142);
                        let _e2145 = (_e2124.member_1 - _e2137.member_1);
                        local_46 = array<type_9, 3>(type_9(_e2083[1][0][0].member, _e2083[1][0][0].member_1), type_9(_e2083[1][0][1].member, _e2083[1][0][1].member_1), type_9(_e2083[1][0][2].member, _e2083[1][0][2].member_1));
                        local_47 = array<type_9, 3>(type_9(_e2083[2][0][0].member, _e2083[2][0][0].member_1), type_9(_e2083[2][0][1].member, _e2083[2][0][1].member_1), type_9(_e2083[2][0][2].member, _e2083[2][0][2].member_1));
                        let _e2174 = local_46[2u].member;
                        let _e2176 = local_46[2u].member_1;
                        let _e2179 = local_47[0u].member;
                        let _e2181 = local_47[0u].member_1;
                        let _e2182 = function_9(_e2174, _e2176, _e2179, _e2181);
                        let _e2187 = local_46[0u].member;
                        let _e2189 = local_46[0u].member_1;
                        let _e2192 = local_47[2u].member;
                        let _e2194 = local_47[2u].member_1;
                        let _e2195 = function_9(_e2187, _e2189, _e2192, _e2194);
                        if (_e2182.member_1 < _e2195.member_1) {
                            phi_3426_ = 1u;
                        } else {
                            phi_3426_ = 0u;
                        }
                        let _e2200 = phi_3426_;
                        let _e2202 = ((_e2182.member - _e2195.member) - _e2200);
                        let _e2203 = (_e2182.member_1 - _e2195.member_1);
                        local_44 = array<type_9, 3>(type_9(_e2083[1][0][0].member, _e2083[1][0][0].member_1), type_9(_e2083[1][0][1].member, _e2083[1][0][1].member_1), type_9(_e2083[1][0][2].member, _e2083[1][0][2].member_1));
                        local_45 = array<type_9, 3>(type_9(_e2083[2][0][0].member, _e2083[2][0][0].member_1), type_9(_e2083[2][0][1].member, _e2083[2][0][1].member_1), type_9(_e2083[2][0][2].member, _e2083[2][0][2].member_1));
                        let _e2232 = local_44[0u].member;
                        let _e2234 = local_44[0u].member_1;
                        let _e2237 = local_45[1u].member;
                        let _e2239 = local_45[1u].member_1;
                        let _e2240 = function_9(_e2232, _e2234, _e2237, _e2239);
                        let _e2245 = local_44[1u].member;
                        let _e2247 = local_44[1u].member_1;
                        let _e2250 = local_45[0u].member;
                        let _e2252 = local_45[0u].member_1;
                        let _e2253 = function_9(_e2245, _e2247, _e2250, _e2252);
                        if (_e2240.member_1 < _e2253.member_1) {
                            phi_3506_ = 1u;
                        } else {
                            phi_3506_ = 0u;
                        }
                        let _e2258 = phi_3506_;
                        let _e2260 = ((_e2240.member - _e2253.member) - _e2258);
                        let _e2261 = (_e2240.member_1 - _e2253.member_1);
                        local_42 = array<type_9, 3>(type_9(_e2083[1][1][0].member, _e2083[1][1][0].member_1), type_9(_e2083[1][1][1].member, _e2083[1][1][1].member_1), type_9(_e2083[1][1][2].member, _e2083[1][1][2].member_1));
                        local_43 = array<type_9, 3>(type_9(_e2083[2][1][0].member, _e2083[2][1][0].member_1), type_9(_e2083[2][1][1].member, _e2083[2][1][1].member_1), type_9(_e2083[2][1][2].member, _e2083[2][1][2].member_1));
                        let _e2294 = local_42[1u].member;
                        let _e2296 = local_42[1u].member_1;
                        let _e2299 = local_43[2u].member;
                        let _e2301 = local_43[2u].member_1;
                        let _e2302 = function_9(_e2294, _e2296, _e2299, _e2301);
                        let _e2307 = local_42[2u].member;
                        let _e2309 = local_42[2u].member_1;
                        let _e2312 = local_43[1u].member;
                        let _e2314 = local_43[1u].member_1;
                        let _e2315 = function_9(_e2307, _e2309, _e2312, _e2314);
                        if (_e2302.member_1 < _e2315.member_1) {
                            phi_3594_ = 1u;
                        } else {
                            phi_3594_ = 0u;
                        }
                        let _e2320 = phi_3594_;
                        let _e2322 = ((_e2302.member - _e2315.member) - _e2320);
                        let _e2323 = (_e2302.member_1 - _e2315.member_1);
                        local_40 = array<type_9, 3>(type_9(_e2083[1][1][0].member, _e2083[1][1][0].member_1), type_9(_e2083[1][1][1].member, _e2083[1][1][1].member_1), type_9(_e2083[1][1][2].member, _e2083[1][1][2].member_1));
                        local_41 = array<type_9, 3>(type_9(_e2083[2][1][0].member, _e2083[2][1][0].member_1), type_9(_e2083[2][1][1].member, _e2083[2][1][1].member_1), type_9(_e2083[2][1][2].member, _e2083[2][1][2].member_1));
                        let _e2352 = local_40[2u].member;
                        let _e2354 = local_40[2u].member_1;
                        let _e2357 = local_41[0u].member;
                        let _e2359 = local_41[0u].member_1;
                        let _e2360 = function_9(_e2352, _e2354, _e2357, _e2359);
                        let _e2365 = local_40[0u].member;
                        let _e2367 = local_40[0u].member_1;
                        let _e2370 = local_41[2u].member;
                        let _e2372 = local_41[2u].member_1;
                        let _e2373 = function_9(_e2365, _e2367, _e2370, _e2372);
                        if (_e2360.member_1 < _e2373.member_1) {
                            phi_3674_ = 1u;
                        } else {
                            phi_3674_ = 0u;
                        }
                        let _e2378 = phi_3674_;
                        let _e2380 = ((_e2360.member - _e2373.member) - _e2378);
                        let _e2381 = (_e2360.member_1 - _e2373.member_1);
                        local_38 = array<type_9, 3>(type_9(_e2083[1][1][0].member, _e2083[1][1][0].member_1), type_9(_e2083[1][1][1].member, _e2083[1][1][1].member_1), type_9(_e2083[1][1][2].member, _e2083[1][1][2].member_1));
                        local_39 = array<type_9, 3>(type_9(_e2083[2][1][0].member, _e2083[2][1][0].member_1), type_9(_e2083[2][1][1].member, _e2083[2][1][1].member_1), type_9(_e2083[2][1][2].member, _e2083[2][1][2].member_1));
                        let _e2410 = local_38[0u].member;
                        let _e2412 = local_38[0u].member_1;
                        let _e2415 = local_39[1u].member;
                        let _e2417 = local_39[1u].member_1;
                        let _e2418 = function_9(_e2410, _e2412, _e2415, _e2417);
                        let _e2423 = local_38[1u].member;
                        let _e2425 = local_38[1u].member_1;
                        let _e2428 = local_39[0u].member;
                        let _e2430 = local_39[0u].member_1;
                        let _e2431 = function_9(_e2423, _e2425, _e2428, _e2430);
                        if (_e2418.member_1 < _e2431.member_1) {
                            phi_3754_ = 1u;
                        } else {
                            phi_3754_ = 0u;
                        }
                        let _e2436 = phi_3754_;
                        let _e2438 = ((_e2418.member - _e2431.member) - _e2436);
                        let _e2439 = (_e2418.member_1 - _e2431.member_1);
                        local_36 = array<type_9, 3>(type_9(_e2083[1][0][0].member, _e2083[1][0][0].member_1), type_9(_e2083[1][0][1].member, _e2083[1][0][1].member_1), type_9(_e2083[1][0][2].member, _e2083[1][0][2].member_1));
                        local_37 = array<type_9, 3>(type_9(_e2083[2][1][0].member, _e2083[2][1][0].member_1), type_9(_e2083[2][1][1].member, _e2083[2][1][1].member_1), type_9(_e2083[2][1][2].member, _e2083[2][1][2].member_1));
                        let _e2472 = local_36[1u].member;
                        let _e2474 = local_36[1u].member_1;
                        let _e2477 = local_37[2u].member;
                        let _e2479 = local_37[2u].member_1;
                        let _e2480 = function_9(_e2472, _e2474, _e2477, _e2479);
                        let _e2485 = local_36[2u].member;
                        let _e2487 = local_36[2u].member_1;
                        let _e2490 = local_37[1u].member;
                        let _e2492 = local_37[1u].member_1;
                        let _e2493 = function_9(_e2485, _e2487, _e2490, _e2492);
                        if (_e2480.member_1 < _e2493.member_1) {
                            phi_3842_ = 1u;
                        } else {
                            phi_3842_ = 0u;
                        }
                        let _e2498 = phi_3842_;
                        let _e2501 = (_e2480.member_1 - _e2493.member_1);
                        local_34 = array<type_9, 3>(type_9(_e2083[1][0][0].member, _e2083[1][0][0].member_1), type_9(_e2083[1][0][1].member, _e2083[1][0][1].member_1), type_9(_e2083[1][0][2].member, _e2083[1][0][2].member_1));
                        local_35 = array<type_9, 3>(type_9(_e2083[2][1][0].member, _e2083[2][1][0].member_1), type_9(_e2083[2][1][1].member, _e2083[2][1][1].member_1), type_9(_e2083[2][1][2].member, _e2083[2][1][2].member_1));
                        let _e2530 = local_34[2u].member;
                        let _e2532 = local_34[2u].member_1;
                        let _e2535 = local_35[0u].member;
                        let _e2537 = local_35[0u].member_1;
                        let _e2538 = function_9(_e2530, _e2532, _e2535, _e2537);
                        let _e2543 = local_34[0u].member;
                        let _e2545 = local_34[0u].member_1;
                        let _e2548 = local_35[2u].member;
                        let _e2550 = local_35[2u].member_1;
                        let _e2551 = function_9(_e2543, _e2545, _e2548, _e2550);
                        if (_e2538.member_1 < _e2551.member_1) {
                            phi_3922_ = 1u;
                        } else {
                            phi_3922_ = 0u;
                        }
                        let _e2556 = phi_3922_;
                        let _e2559 = (_e2538.member_1 - _e2551.member_1);
                        local_32 = array<type_9, 3>(type_9(_e2083[1][0][0].member, _e2083[1][0][0].member_1), type_9(_e2083[1][0][1].member, _e2083[1][0][1].member_1), type_9(_e2083[1][0][2].member, _e2083[1][0][2].member_1));
                        local_33 = array<type_9, 3>(type_9(_e2083[2][1][0].member, _e2083[2][1][0].member_1), type_9(_e2083[2][1][1].member, _e2083[2][1][1].member_1), type_9(_e2083[2][1][2].member, _e2083[2][1][2].member_1));
                        let _e2588 = local_32[0u].member;
                        let _e2590 = local_32[0u].member_1;
                        let _e2593 = local_33[1u].member;
                        let _e2595 = local_33[1u].member_1;
                        let _e2596 = function_9(_e2588, _e2590, _e2593, _e2595);
                        let _e2601 = local_32[1u].member;
                        let _e2603 = local_32[1u].member_1;
                        let _e2606 = local_33[0u].member;
                        let _e2608 = local_33[0u].member_1;
                        let _e2609 = function_9(_e2601, _e2603, _e2606, _e2608);
                        if (_e2596.member_1 < _e2609.member_1) {
                            phi_4002_ = 1u;
                        } else {
                            phi_4002_ = 0u;
                        }
                        let _e2614 = phi_4002_;
                        let _e2617 = (_e2596.member_1 - _e2609.member_1);
                        local_30 = array<type_9, 3>(type_9(_e2083[1][1][0].member, _e2083[1][1][0].member_1), type_9(_e2083[1][1][1].member, _e2083[1][1][1].member_1), type_9(_e2083[1][1][2].member, _e2083[1][1][2].member_1));
                        local_31 = array<type_9, 3>(type_9(_e2083[2][0][0].member, _e2083[2][0][0].member_1), type_9(_e2083[2][0][1].member, _e2083[2][0][1].member_1), type_9(_e2083[2][0][2].member, _e2083[2][0][2].member_1));
                        let _e2650 = local_30[1u].member;
                        let _e2652 = local_30[1u].member_1;
                        let _e2655 = local_31[2u].member;
                        let _e2657 = local_31[2u].member_1;
                        let _e2658 = function_9(_e2650, _e2652, _e2655, _e2657);
                        let _e2663 = local_30[2u].member;
                        let _e2665 = local_30[2u].member_1;
                        let _e2668 = local_31[1u].member;
                        let _e2670 = local_31[1u].member_1;
                        let _e2671 = function_9(_e2663, _e2665, _e2668, _e2670);
                        if (_e2658.member_1 < _e2671.member_1) {
                            phi_4090_ = 1u;
                        } else {
                            phi_4090_ = 0u;
                        }
                        let _e2676 = phi_4090_;
                        local_28 = array<type_9, 3>(type_9(_e2083[1][1][0].member, _e2083[1][1][0].member_1), type_9(_e2083[1][1][1].member, _e2083[1][1][1].member_1), type_9(_e2083[1][1][2].member, _e2083[1][1][2].member_1));
                        local_29 = array<type_9, 3>(type_9(_e2083[2][0][0].member, _e2083[2][0][0].member_1), type_9(_e2083[2][0][1].member, _e2083[2][0][1].member_1), type_9(_e2083[2][0][2].member, _e2083[2][0][2].member_1));
                        let _e2708 = local_28[2u].member;
                        let _e2710 = local_28[2u].member_1;
                        let _e2713 = local_29[0u].member;
                        let _e2715 = local_29[0u].member_1;
                        let _e2716 = function_9(_e2708, _e2710, _e2713, _e2715);
                        let _e2721 = local_28[0u].member;
                        let _e2723 = local_28[0u].member_1;
                        let _e2726 = local_29[2u].member;
                        let _e2728 = local_29[2u].member_1;
                        let _e2729 = function_9(_e2721, _e2723, _e2726, _e2728);
                        if (_e2716.member_1 < _e2729.member_1) {
                            phi_4170_ = 1u;
                        } else {
                            phi_4170_ = 0u;
                        }
                        let _e2734 = phi_4170_;
                        local_26 = array<type_9, 3>(type_9(_e2083[1][1][0].member, _e2083[1][1][0].member_1), type_9(_e2083[1][1][1].member, _e2083[1][1][1].member_1), type_9(_e2083[1][1][2].member, _e2083[1][1][2].member_1));
                        local_27 = array<type_9, 3>(type_9(_e2083[2][0][0].member, _e2083[2][0][0].member_1), type_9(_e2083[2][0][1].member, _e2083[2][0][1].member_1), type_9(_e2083[2][0][2].member, _e2083[2][0][2].member_1));
                        let _e2766 = local_26[0u].member;
                        let _e2768 = local_26[0u].member_1;
                        let _e2771 = local_27[1u].member;
                        let _e2773 = local_27[1u].member_1;
                        let _e2774 = function_9(_e2766, _e2768, _e2771, _e2773);
                        let _e2779 = local_26[1u].member;
                        let _e2781 = local_26[1u].member_1;
                        let _e2784 = local_27[0u].member;
                        let _e2786 = local_27[0u].member_1;
                        let _e2787 = function_9(_e2779, _e2781, _e2784, _e2786);
                        if (_e2774.member_1 < _e2787.member_1) {
                            phi_4250_ = 1u;
                        } else {
                            phi_4250_ = 0u;
                        }
                        let _e2792 = phi_4250_;
                        let _e2796 = (_e2501 + (_e2658.member_1 - _e2671.member_1));
                        if (_e2796 < _e2501) {
                            phi_4269_ = 1u;
                        } else {
                            phi_4269_ = 0u;
                        }
                        let _e2799 = phi_4269_;
                        let _e2801 = ((((_e2480.member - _e2493.member) - _e2498) + ((_e2658.member - _e2671.member) - _e2676)) + _e2799);
                        let _e2802 = (_e2559 + (_e2716.member_1 - _e2729.member_1));
                        if (_e2802 < _e2559) {
                            phi_4281_ = 1u;
                        } else {
                            phi_4281_ = 0u;
                        }
                        let _e2805 = phi_4281_;
                        let _e2807 = ((((_e2538.member - _e2551.member) - _e2556) + ((_e2716.member - _e2729.member) - _e2734)) + _e2805);
                        let _e2808 = (_e2617 + (_e2774.member_1 - _e2787.member_1));
                        if (_e2808 < _e2617) {
                            phi_4293_ = 1u;
                        } else {
                            phi_4293_ = 0u;
                        }
                        let _e2811 = phi_4293_;
                        let _e2813 = ((((_e2596.member - _e2609.member) - _e2614) + ((_e2774.member - _e2787.member) - _e2792)) + _e2811);
                        let _e2820 = function_9(_e2083[0][0][0].member, _e2083[0][0][0].member_1, _e2144, _e2145);
                        let _e2827 = function_9(_e2083[0][0][1].member, _e2083[0][0][1].member_1, _e2202, _e2203);
                        let _e2830 = (_e2820.member_1 + _e2827.member_1);
                        if (_e2830 < _e2820.member_1) {
                            phi_4322_ = 1u;
                        } else {
                            phi_4322_ = 0u;
                        }
                        let _e2833 = phi_4322_;
                        let _e2840 = function_9(_e2083[0][0][2].member, _e2083[0][0][2].member_1, _e2260, _e2261);
                        let _e2843 = (_e2830 + _e2840.member_1);
                        if (_e2843 < _e2830) {
                            phi_4337_ = 1u;
                        } else {
                            phi_4337_ = 0u;
                        }
                        let _e2846 = phi_4337_;
                        let _e2849 = function_12(((((_e2820.member + _e2827.member) + _e2833) + _e2840.member) + _e2846), _e2843);
                        let _e2858 = function_9(_e2083[0][1][0].member, _e2083[0][1][0].member_1, _e2144, _e2145);
                        let _e2865 = function_9(_e2083[0][1][1].member, _e2083[0][1][1].member_1, _e2202, _e2203);
                        let _e2868 = (_e2858.member_1 + _e2865.member_1);
                        if (_e2868 < _e2858.member_1) {
                            phi_4363_ = 1u;
                        } else {
                            phi_4363_ = 0u;
                        }
                        let _e2871 = phi_4363_;
                        let _e2878 = function_9(_e2083[0][1][2].member, _e2083[0][1][2].member_1, _e2260, _e2261);
                        let _e2881 = (_e2868 + _e2878.member_1);
                        if (_e2881 < _e2868) {
                            phi_4378_ = 1u;
                        } else {
                            phi_4378_ = 0u;
                        }
                        let _e2884 = phi_4378_;
                        let _e2893 = function_9(_e2083[0][0][0].member, _e2083[0][0][0].member_1, _e2801, _e2796);
                        let _e2900 = function_9(_e2083[0][0][1].member, _e2083[0][0][1].member_1, _e2807, _e2802);
                        let _e2903 = (_e2893.member_1 + _e2900.member_1);
                        if (_e2903 < _e2893.member_1) {
                            phi_4401_ = 1u;
                        } else {
                            phi_4401_ = 0u;
                        }
                        let _e2906 = phi_4401_;
                        let _e2913 = function_9(_e2083[0][0][2].member, _e2083[0][0][2].member_1, _e2813, _e2808);
                        let _e2916 = (_e2903 + _e2913.member_1);
                        if (_e2916 < _e2903) {
                            phi_4416_ = 1u;
                        } else {
                            phi_4416_ = 0u;
                        }
                        let _e2919 = phi_4416_;
                        let _e2922 = (_e2881 + _e2916);
                        if (_e2922 < _e2881) {
                            phi_4424_ = 1u;
                        } else {
                            phi_4424_ = 0u;
                        }
                        let _e2925 = phi_4424_;
                        let _e2927 = ((((((_e2858.member + _e2865.member) + _e2871) + _e2878.member) + _e2884) + ((((_e2893.member + _e2900.member) + _e2906) + _e2913.member) + _e2919)) + _e2925);
                        let _e2934 = function_9(_e2083[0][0][0].member, _e2083[0][0][0].member_1, _e2322, _e2323);
                        let _e2941 = function_9(_e2083[0][0][1].member, _e2083[0][0][1].member_1, _e2380, _e2381);
                        let _e2944 = (_e2934.member_1 + _e2941.member_1);
                        if (_e2944 < _e2934.member_1) {
                            phi_4447_ = 1u;
                        } else {
                            phi_4447_ = 0u;
                        }
                        let _e2947 = phi_4447_;
                        let _e2954 = function_9(_e2083[0][0][2].member, _e2083[0][0][2].member_1, _e2438, _e2439);
                        let _e2957 = (_e2944 + _e2954.member_1);
                        if (_e2957 < _e2944) {
                            phi_4462_ = 1u;
                        } else {
                            phi_4462_ = 0u;
                        }
                        let _e2960 = phi_4462_;
                        let _e2969 = function_9(_e2083[0][1][0].member, _e2083[0][1][0].member_1, _e2801, _e2796);
                        let _e2976 = function_9(_e2083[0][1][1].member, _e2083[0][1][1].member_1, _e2807, _e2802);
                        let _e2979 = (_e2969.member_1 + _e2976.member_1);
                        if (_e2979 < _e2969.member_1) {
                            phi_4485_ = 1u;
                        } else {
                            phi_4485_ = 0u;
                        }
                        let _e2982 = phi_4485_;
                        let _e2989 = function_9(_e2083[0][1][2].member, _e2083[0][1][2].member_1, _e2813, _e2808);
                        let _e2992 = (_e2979 + _e2989.member_1);
                        if (_e2992 < _e2979) {
                            phi_4500_ = 1u;
                        } else {
                            phi_4500_ = 0u;
                        }
                        let _e2995 = phi_4500_;
                        let _e2998 = (_e2957 + _e2992);
                        if (_e2998 < _e2957) {
                            phi_4508_ = 1u;
                        } else {
                            phi_4508_ = 0u;
                        }
                        let _e3001 = phi_4508_;
                        let _e3003 = ((((((_e2934.member + _e2941.member) + _e2947) + _e2954.member) + _e2960) + ((((_e2969.member + _e2976.member) + _e2982) + _e2989.member) + _e2995)) + _e3001);
                        let _e3010 = function_9(_e2083[0][1][0].member, _e2083[0][1][0].member_1, _e2322, _e2323);
                        let _e3017 = function_9(_e2083[0][1][1].member, _e2083[0][1][1].member_1, _e2380, _e2381);
                        let _e3020 = (_e3010.member_1 + _e3017.member_1);
                        if (_e3020 < _e3010.member_1) {
                            phi_4531_ = 1u;
                        } else {
                            phi_4531_ = 0u;
                        }
                        let _e3023 = phi_4531_;
                        let _e3030 = function_9(_e2083[0][1][2].member, _e2083[0][1][2].member_1, _e2438, _e2439);
                        let _e3033 = (_e3020 + _e3030.member_1);
                        if (_e3033 < _e3020) {
                            phi_4546_ = 1u;
                        } else {
                            phi_4546_ = 0u;
                        }
                        let _e3036 = phi_4546_;
                        let _e3039 = function_12(((((_e3010.member + _e3017.member) + _e3023) + _e3030.member) + _e3036), _e3033);
                        phi_4562_ = type_9(0u, 128u);
                        phi_4565_ = array<type_9, 4>(_e2849, type_9(_e2927, _e2922), type_9(_e3003, _e2998), type_9(_e3039.member, _e3039.member_1));
                        phi_4569_ = 0u;
                        phi_4571_ = 0u;
                        loop {
                            let _e3047 = phi_4562_;
                            let _e3049 = phi_4565_;
                            let _e3051 = phi_4569_;
                            let _e3053 = phi_4571_;
                            local_65 = _e3049;
                            local_66 = _e3049;
                            local_67 = _e3049;
                            if (_e3047.member < _e3047.member_1) {
                                phi_4563_ = type_9((_e3047.member + 1u), _e3047.member_1);
                                phi_4594_ = type_9(1u, _e3047.member);
                            } else {
                                phi_4563_ = _e3047;
                                phi_4594_ = type_9(0u, type_9().member_1);
                            }
                            let _e3065 = phi_4563_;
                            let _e3067 = phi_4594_;
                            if (bitcast<i32>(_e3067.member) != 0i) {
                                let _e3071 = (31u - _e3051);
                                let _e3074 = (_e3053 << bitcast<u32>((_e3071 & 31u)));
                                let _e3079 = (_e3074 > _e1470);
                                if _e3079 {
                                    phi_7279_ = array<type_9, 4>();
                                    phi_7281_ = u32();
                                    phi_7282_ = u32();
                                    phi_7283_ = bool();
                                    phi_7284_ = bool();
                                    phi_7285_ = u32();
                                    phi_7286_ = u32();
                                    phi_7287_ = false;
                                    phi_7288_ = false;
                                    phi_7289_ = false;
                                } else {
                                    if (((_e3053 + 1u) << bitcast<u32>((_e3071 & 31u))) < _e1468) {
                                        phi_4791_ = true;
                                    } else {
                                        let _e3085 = function_11(128u);
                                        if ((_e3049[0].member >> bitcast<u32>(31i)) != 0u) {
                                            if (_e3049[0].member_1 == 0u) {
                                                phi_4629_ = 1u;
                                            } else {
                                                phi_4629_ = 0u;
                                            }
                                            let _e3094 = phi_4629_;
                                            phi_4636_ = type_9((~(_e3049[0].member) + _e3094), (~(_e3049[0].member_1) + 1u));
                                        } else {
                                            phi_4636_ = _e3049[0];
                                        }
                                        let _e3101 = phi_4636_;
                                        if (_e3085.member_1 < _e3101.member_1) {
                                            phi_4643_ = 1u;
                                        } else {
                                            phi_4643_ = 0u;
                                        }
                                        let _e3106 = phi_4643_;
                                        if ((((_e3085.member - _e3101.member) - _e3106) >> bitcast<u32>(31i)) != 0u) {
                                            if ((_e3049[0].member >> bitcast<u32>(31i)) != 0u) {
                                                phi_4656_ = 2u;
                                            } else {
                                                phi_4656_ = 1u;
                                            }
                                            let _e3116 = phi_4656_;
                                            phi_4657_ = _e3116;
                                        } else {
                                            phi_4657_ = 0u;
                                        }
                                        let _e3118 = phi_4657_;
                                        let _e3123 = function_11(128u);
                                        if ((_e3049[1].member >> bitcast<u32>(31i)) != 0u) {
                                            if (_e3049[1].member_1 == 0u) {
                                                phi_4672_ = 1u;
                                            } else {
                                                phi_4672_ = 0u;
                                            }
                                            let _e3132 = phi_4672_;
                                            phi_4679_ = type_9((~(_e3049[1].member) + _e3132), (~(_e3049[1].member_1) + 1u));
                                        } else {
                                            phi_4679_ = _e3049[1];
                                        }
                                        let _e3139 = phi_4679_;
                                        if (_e3123.member_1 < _e3139.member_1) {
                                            phi_4686_ = 1u;
                                        } else {
                                            phi_4686_ = 0u;
                                        }
                                        let _e3144 = phi_4686_;
                                        if ((((_e3123.member - _e3139.member) - _e3144) >> bitcast<u32>(31i)) != 0u) {
                                            if ((_e3049[1].member >> bitcast<u32>(31i)) != 0u) {
                                                phi_4699_ = 2u;
                                            } else {
                                                phi_4699_ = 1u;
                                            }
                                            let _e3154 = phi_4699_;
                                            phi_4700_ = _e3154;
                                        } else {
                                            phi_4700_ = 0u;
                                        }
                                        let _e3156 = phi_4700_;
                                        let _e3162 = function_11(128u);
                                        if ((_e3049[2].member >> bitcast<u32>(31i)) != 0u) {
                                            if (_e3049[2].member_1 == 0u) {
                                                phi_4716_ = 1u;
                                            } else {
                                                phi_4716_ = 0u;
                                            }
                                            let _e3171 = phi_4716_;
                                            phi_4723_ = type_9((~(_e3049[2].member) + _e3171), (~(_e3049[2].member_1) + 1u));
                                        } else {
                                            phi_4723_ = _e3049[2];
                                        }
                                        let _e3178 = phi_4723_;
                                        if (_e3162.member_1 < _e3178.member_1) {
                                            phi_4730_ = 1u;
                                        } else {
                                            phi_4730_ = 0u;
                                        }
                                        let _e3183 = phi_4730_;
                                        if ((((_e3162.member - _e3178.member) - _e3183) >> bitcast<u32>(31i)) != 0u) {
                                            if ((_e3049[2].member >> bitcast<u32>(31i)) != 0u) {
                                                phi_4743_ = 2u;
                                            } else {
                                                phi_4743_ = 1u;
                                            }
                                            let _e3193 = phi_4743_;
                                            phi_4744_ = _e3193;
                                        } else {
                                            phi_4744_ = 0u;
                                        }
                                        let _e3195 = phi_4744_;
                                        let _e3201 = function_11(128u);
                                        if ((_e3049[3].member >> bitcast<u32>(31i)) != 0u) {
                                            if (_e3049[3].member_1 == 0u) {
                                                phi_4760_ = 1u;
                                            } else {
                                                phi_4760_ = 0u;
                                            }
                                            let _e3210 = phi_4760_;
                                            phi_4767_ = type_9((~(_e3049[3].member) + _e3210), (~(_e3049[3].member_1) + 1u));
                                        } else {
                                            phi_4767_ = _e3049[3];
                                        }
                                        let _e3217 = phi_4767_;
                                        if (_e3201.member_1 < _e3217.member_1) {
                                            phi_4774_ = 1u;
                                        } else {
                                            phi_4774_ = 0u;
                                        }
                                        let _e3222 = phi_4774_;
                                        if ((((_e3201.member - _e3217.member) - _e3222) >> bitcast<u32>(31i)) != 0u) {
                                            if ((_e3049[3].member >> bitcast<u32>(31i)) != 0u) {
                                                phi_4787_ = 2u;
                                            } else {
                                                phi_4787_ = 1u;
                                            }
                                            let _e3232 = phi_4787_;
                                            phi_4788_ = _e3232;
                                        } else {
                                            phi_4788_ = 0u;
                                        }
                                        let _e3234 = phi_4788_;
                                        phi_4791_ = ((((_e3118 & _e3156) & _e3195) & _e3234) != 0u);
                                    }
                                    let _e3238 = phi_4791_;
                                    if _e3238 {
                                        phi_6960_ = _e3049;
                                        phi_6962_ = _e3238;
                                        phi_6963_ = _e3051;
                                        phi_6964_ = _e3053;
                                        phi_6965_ = bool();
                                        phi_6966_ = bool();
                                        phi_6967_ = u32();
                                        phi_6968_ = u32();
                                        phi_6969_ = true;
                                    } else {
                                        let _e3239 = (_e3051 == 31u);
                                        if _e3239 {
                                            phi_4816_ = true;
                                        } else {
                                            if (_e3051 == 3u) {
                                                phi_4815_ = true;
                                            } else {
                                                if (_e3051 == 8u) {
                                                    phi_4814_ = true;
                                                } else {
                                                    phi_4814_ = (_e3051 == 14u);
                                                }
                                                let _e3244 = phi_4814_;
                                                phi_4815_ = _e3244;
                                            }
                                            let _e3246 = phi_4815_;
                                            phi_4816_ = _e3246;
                                        }
                                        let _e3248 = phi_4816_;
                                        if _e3248 {
                                            let _e3253 = function_11(128u);
                                            if ((_e3049[0].member >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3049[0].member_1 == 0u) {
                                                    phi_4834_ = 1u;
                                                } else {
                                                    phi_4834_ = 0u;
                                                }
                                                let _e3262 = phi_4834_;
                                                phi_4841_ = type_9((~(_e3049[0].member) + _e3262), (~(_e3049[0].member_1) + 1u));
                                            } else {
                                                phi_4841_ = _e3049[0];
                                            }
                                            let _e3269 = phi_4841_;
                                            if (_e3253.member_1 < _e3269.member_1) {
                                                phi_4848_ = 1u;
                                            } else {
                                                phi_4848_ = 0u;
                                            }
                                            let _e3274 = phi_4848_;
                                            if ((((_e3253.member - _e3269.member) - _e3274) >> bitcast<u32>(31i)) != 0u) {
                                                if ((_e3049[0].member >> bitcast<u32>(31i)) != 0u) {
                                                    phi_4861_ = 2u;
                                                } else {
                                                    phi_4861_ = 1u;
                                                }
                                                let _e3284 = phi_4861_;
                                                phi_4862_ = _e3284;
                                            } else {
                                                phi_4862_ = 0u;
                                            }
                                            let _e3286 = phi_4862_;
                                            let _e3291 = function_11(128u);
                                            if ((_e3049[3].member >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3049[3].member_1 == 0u) {
                                                    phi_4877_ = 1u;
                                                } else {
                                                    phi_4877_ = 0u;
                                                }
                                                let _e3300 = phi_4877_;
                                                phi_4884_ = type_9((~(_e3049[3].member) + _e3300), (~(_e3049[3].member_1) + 1u));
                                            } else {
                                                phi_4884_ = _e3049[3];
                                            }
                                            let _e3307 = phi_4884_;
                                            if (_e3291.member_1 < _e3307.member_1) {
                                                phi_4891_ = 1u;
                                            } else {
                                                phi_4891_ = 0u;
                                            }
                                            let _e3312 = phi_4891_;
                                            if ((((_e3291.member - _e3307.member) - _e3312) >> bitcast<u32>(31i)) != 0u) {
                                                if ((_e3049[3].member >> bitcast<u32>(31i)) != 0u) {
                                                    phi_4904_ = 2u;
                                                } else {
                                                    phi_4904_ = 1u;
                                                }
                                                let _e3322 = phi_4904_;
                                                phi_4905_ = _e3322;
                                            } else {
                                                phi_4905_ = 0u;
                                            }
                                            let _e3324 = phi_4905_;
                                            let _e3326 = ((_e3286 | _e3324) == 3u);
                                            if _e3239 {
                                                phi_4912_ = !(_e3326);
                                            } else {
                                                phi_4912_ = false;
                                            }
                                            let _e3329 = phi_4912_;
                                            if _e3329 {
                                                phi_4920_ = select((bitcast<u32>(31i) - firstLeadingBit(_e1472)), 32u, (_e1472 == 0u));
                                            } else {
                                                phi_4920_ = _e3051;
                                            }
                                            let _e3336 = phi_4920_;
                                            if (_e2083[0][1][0].member_1 < _e2083[0][0][0].member_1) {
                                                phi_4938_ = 1u;
                                            } else {
                                                phi_4938_ = 0u;
                                            }
                                            let _e3357 = phi_4938_;
                                            let _e3359 = ((_e2083[0][1][0].member - _e2083[0][0][0].member) - _e3357);
                                            let _e3360 = (_e2083[0][1][0].member_1 - _e2083[0][0][0].member_1);
                                            if (_e2083[0][1][1].member_1 < _e2083[0][0][1].member_1) {
                                                phi_4950_ = 1u;
                                            } else {
                                                phi_4950_ = 0u;
                                            }
                                            let _e3371 = phi_4950_;
                                            let _e3373 = ((_e2083[0][1][1].member - _e2083[0][0][1].member) - _e3371);
                                            let _e3374 = (_e2083[0][1][1].member_1 - _e2083[0][0][1].member_1);
                                            if (_e2083[0][1][2].member_1 < _e2083[0][0][2].member_1) {
                                                phi_4962_ = 1u;
                                            } else {
                                                phi_4962_ = 0u;
                                            }
                                            let _e3385 = phi_4962_;
                                            let _e3387 = ((_e2083[0][1][2].member - _e2083[0][0][2].member) - _e3385);
                                            let _e3388 = (_e2083[0][1][2].member_1 - _e2083[0][0][2].member_1);
                                            if ((_e3359 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3360 == 0u) {
                                                    phi_4983_ = 1u;
                                                } else {
                                                    phi_4983_ = 0u;
                                                }
                                                let _e3395 = phi_4983_;
                                                phi_4990_ = type_9((~(_e3359) + _e3395), (~(_e3360) + 1u));
                                            } else {
                                                phi_4990_ = type_9(_e3359, _e3360);
                                            }
                                            let _e3402 = phi_4990_;
                                            if ((_e3373 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3374 == 0u) {
                                                    phi_5004_ = 1u;
                                                } else {
                                                    phi_5004_ = 0u;
                                                }
                                                let _e3411 = phi_5004_;
                                                phi_5011_ = type_9((~(_e3373) + _e3411), (~(_e3374) + 1u));
                                            } else {
                                                phi_5011_ = type_9(_e3373, _e3374);
                                            }
                                            let _e3418 = phi_5011_;
                                            if (_e3418.member_1 < _e3402.member_1) {
                                                phi_5018_ = 1u;
                                            } else {
                                                phi_5018_ = 0u;
                                            }
                                            let _e3423 = phi_5018_;
                                            if ((((_e3418.member - _e3402.member) - _e3423) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5028_ = _e3402;
                                            } else {
                                                phi_5028_ = _e3418;
                                            }
                                            let _e3430 = phi_5028_;
                                            if ((_e3387 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3388 == 0u) {
                                                    phi_5042_ = 1u;
                                                } else {
                                                    phi_5042_ = 0u;
                                                }
                                                let _e3439 = phi_5042_;
                                                phi_5049_ = type_9((~(_e3387) + _e3439), (~(_e3388) + 1u));
                                            } else {
                                                phi_5049_ = type_9(_e3387, _e3388);
                                            }
                                            let _e3446 = phi_5049_;
                                            if (_e3446.member_1 < _e3430.member_1) {
                                                phi_5056_ = 1u;
                                            } else {
                                                phi_5056_ = 0u;
                                            }
                                            let _e3451 = phi_5056_;
                                            if ((((_e3446.member - _e3430.member) - _e3451) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5066_ = _e3430;
                                            } else {
                                                phi_5066_ = _e3446;
                                            }
                                            let _e3458 = phi_5066_;
                                            let _e3461 = function_11(4u);
                                            let _e3464 = (_e3458.member_1 + _e3461.member_1);
                                            if (_e3464 < _e3458.member_1) {
                                                phi_5077_ = 1u;
                                            } else {
                                                phi_5077_ = 0u;
                                            }
                                            let _e3467 = phi_5077_;
                                            let _e3469 = ((_e3458.member + _e3461.member) + _e3467);
                                            let _e3484 = ((_e3464 >> bitcast<u32>((_e3336 & 31u))) | ((_e3469 << bitcast<u32>(((31u - _e3336) & 31u))) << bitcast<u32>(1i)));
                                            let _e3485 = function_11(4u);
                                            let _e3488 = (_e3484 + _e3485.member_1);
                                            if (_e3488 < _e3484) {
                                                phi_5099_ = 1u;
                                            } else {
                                                phi_5099_ = 0u;
                                            }
                                            let _e3491 = phi_5099_;
                                            if (_e2083[1][1][0].member_1 < _e2083[1][0][0].member_1) {
                                                phi_5112_ = 1u;
                                            } else {
                                                phi_5112_ = 0u;
                                            }
                                            let _e3506 = phi_5112_;
                                            let _e3508 = ((_e2083[1][1][0].member - _e2083[1][0][0].member) - _e3506);
                                            let _e3509 = (_e2083[1][1][0].member_1 - _e2083[1][0][0].member_1);
                                            if (_e2083[1][1][1].member_1 < _e2083[1][0][1].member_1) {
                                                phi_5124_ = 1u;
                                            } else {
                                                phi_5124_ = 0u;
                                            }
                                            let _e3520 = phi_5124_;
                                            let _e3522 = ((_e2083[1][1][1].member - _e2083[1][0][1].member) - _e3520);
                                            let _e3523 = (_e2083[1][1][1].member_1 - _e2083[1][0][1].member_1);
                                            if (_e2083[1][1][2].member_1 < _e2083[1][0][2].member_1) {
                                                phi_5136_ = 1u;
                                            } else {
                                                phi_5136_ = 0u;
                                            }
                                            let _e3534 = phi_5136_;
                                            let _e3536 = ((_e2083[1][1][2].member - _e2083[1][0][2].member) - _e3534);
                                            let _e3537 = (_e2083[1][1][2].member_1 - _e2083[1][0][2].member_1);
                                            if ((_e3508 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3509 == 0u) {
                                                    phi_5157_ = 1u;
                                                } else {
                                                    phi_5157_ = 0u;
                                                }
                                                let _e3544 = phi_5157_;
                                                phi_5164_ = type_9((~(_e3508) + _e3544), (~(_e3509) + 1u));
                                            } else {
                                                phi_5164_ = type_9(_e3508, _e3509);
                                            }
                                            let _e3551 = phi_5164_;
                                            if ((_e3522 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3523 == 0u) {
                                                    phi_5178_ = 1u;
                                                } else {
                                                    phi_5178_ = 0u;
                                                }
                                                let _e3560 = phi_5178_;
                                                phi_5185_ = type_9((~(_e3522) + _e3560), (~(_e3523) + 1u));
                                            } else {
                                                phi_5185_ = type_9(_e3522, _e3523);
                                            }
                                            let _e3567 = phi_5185_;
                                            if (_e3567.member_1 < _e3551.member_1) {
                                                phi_5192_ = 1u;
                                            } else {
                                                phi_5192_ = 0u;
                                            }
                                            let _e3572 = phi_5192_;
                                            if ((((_e3567.member - _e3551.member) - _e3572) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5202_ = _e3551;
                                            } else {
                                                phi_5202_ = _e3567;
                                            }
                                            let _e3579 = phi_5202_;
                                            if ((_e3536 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3537 == 0u) {
                                                    phi_5216_ = 1u;
                                                } else {
                                                    phi_5216_ = 0u;
                                                }
                                                let _e3588 = phi_5216_;
                                                phi_5223_ = type_9((~(_e3536) + _e3588), (~(_e3537) + 1u));
                                            } else {
                                                phi_5223_ = type_9(_e3536, _e3537);
                                            }
                                            let _e3595 = phi_5223_;
                                            if (_e3595.member_1 < _e3579.member_1) {
                                                phi_5230_ = 1u;
                                            } else {
                                                phi_5230_ = 0u;
                                            }
                                            let _e3600 = phi_5230_;
                                            if ((((_e3595.member - _e3579.member) - _e3600) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5240_ = _e3579;
                                            } else {
                                                phi_5240_ = _e3595;
                                            }
                                            let _e3607 = phi_5240_;
                                            let _e3610 = function_11(4u);
                                            let _e3613 = (_e3607.member_1 + _e3610.member_1);
                                            if (_e3613 < _e3607.member_1) {
                                                phi_5251_ = 1u;
                                            } else {
                                                phi_5251_ = 0u;
                                            }
                                            let _e3616 = phi_5251_;
                                            let _e3618 = ((_e3607.member + _e3610.member) + _e3616);
                                            let _e3633 = ((_e3613 >> bitcast<u32>((_e3336 & 31u))) | ((_e3618 << bitcast<u32>(((31u - _e3336) & 31u))) << bitcast<u32>(1i)));
                                            let _e3634 = function_11(4u);
                                            let _e3637 = (_e3633 + _e3634.member_1);
                                            if (_e3637 < _e3633) {
                                                phi_5273_ = 1u;
                                            } else {
                                                phi_5273_ = 0u;
                                            }
                                            let _e3640 = phi_5273_;
                                            if (_e2083[2][1][0].member_1 < _e2083[2][0][0].member_1) {
                                                phi_5286_ = 1u;
                                            } else {
                                                phi_5286_ = 0u;
                                            }
                                            let _e3655 = phi_5286_;
                                            let _e3657 = ((_e2083[2][1][0].member - _e2083[2][0][0].member) - _e3655);
                                            let _e3658 = (_e2083[2][1][0].member_1 - _e2083[2][0][0].member_1);
                                            if (_e2083[2][1][1].member_1 < _e2083[2][0][1].member_1) {
                                                phi_5298_ = 1u;
                                            } else {
                                                phi_5298_ = 0u;
                                            }
                                            let _e3669 = phi_5298_;
                                            let _e3671 = ((_e2083[2][1][1].member - _e2083[2][0][1].member) - _e3669);
                                            let _e3672 = (_e2083[2][1][1].member_1 - _e2083[2][0][1].member_1);
                                            if (_e2083[2][1][2].member_1 < _e2083[2][0][2].member_1) {
                                                phi_5310_ = 1u;
                                            } else {
                                                phi_5310_ = 0u;
                                            }
                                            let _e3683 = phi_5310_;
                                            let _e3685 = ((_e2083[2][1][2].member - _e2083[2][0][2].member) - _e3683);
                                            let _e3686 = (_e2083[2][1][2].member_1 - _e2083[2][0][2].member_1);
                                            if ((_e3657 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3658 == 0u) {
                                                    phi_5331_ = 1u;
                                                } else {
                                                    phi_5331_ = 0u;
                                                }
                                                let _e3693 = phi_5331_;
                                                phi_5338_ = type_9((~(_e3657) + _e3693), (~(_e3658) + 1u));
                                            } else {
                                                phi_5338_ = type_9(_e3657, _e3658);
                                            }
                                            let _e3700 = phi_5338_;
                                            if ((_e3671 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3672 == 0u) {
                                                    phi_5352_ = 1u;
                                                } else {
                                                    phi_5352_ = 0u;
                                                }
                                                let _e3709 = phi_5352_;
                                                phi_5359_ = type_9((~(_e3671) + _e3709), (~(_e3672) + 1u));
                                            } else {
                                                phi_5359_ = type_9(_e3671, _e3672);
                                            }
                                            let _e3716 = phi_5359_;
                                            if (_e3716.member_1 < _e3700.member_1) {
                                                phi_5366_ = 1u;
                                            } else {
                                                phi_5366_ = 0u;
                                            }
                                            let _e3721 = phi_5366_;
                                            if ((((_e3716.member - _e3700.member) - _e3721) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5376_ = _e3700;
                                            } else {
                                                phi_5376_ = _e3716;
                                            }
                                            let _e3728 = phi_5376_;
                                            if ((_e3685 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3686 == 0u) {
                                                    phi_5390_ = 1u;
                                                } else {
                                                    phi_5390_ = 0u;
                                                }
                                                let _e3737 = phi_5390_;
                                                phi_5397_ = type_9((~(_e3685) + _e3737), (~(_e3686) + 1u));
                                            } else {
                                                phi_5397_ = type_9(_e3685, _e3686);
                                            }
                                            let _e3744 = phi_5397_;
                                            if (_e3744.member_1 < _e3728.member_1) {
                                                phi_5404_ = 1u;
                                            } else {
                                                phi_5404_ = 0u;
                                            }
                                            let _e3749 = phi_5404_;
                                            if ((((_e3744.member - _e3728.member) - _e3749) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5414_ = _e3728;
                                            } else {
                                                phi_5414_ = _e3744;
                                            }
                                            let _e3756 = phi_5414_;
                                            let _e3759 = function_11(4u);
                                            let _e3762 = (_e3756.member_1 + _e3759.member_1);
                                            if (_e3762 < _e3756.member_1) {
                                                phi_5425_ = 1u;
                                            } else {
                                                phi_5425_ = 0u;
                                            }
                                            let _e3765 = phi_5425_;
                                            let _e3767 = ((_e3756.member + _e3759.member) + _e3765);
                                            let _e3782 = ((_e3762 >> bitcast<u32>((_e3336 & 31u))) | ((_e3767 << bitcast<u32>(((31u - _e3336) & 31u))) << bitcast<u32>(1i)));
                                            let _e3783 = function_11(4u);
                                            let _e3786 = (_e3782 + _e3783.member_1);
                                            if (_e3786 < _e3782) {
                                                phi_5447_ = 1u;
                                            } else {
                                                phi_5447_ = 0u;
                                            }
                                            let _e3789 = phi_5447_;
                                            local_25[0u].member = ((bitcast<u32>((bitcast<i32>(_e3469) >> bitcast<u32>((_e3336 & 31u)))) + _e3485.member) + _e3491);
                                            local_25[0u].member_1 = _e3488;
                                            local_25[1u].member = ((bitcast<u32>((bitcast<i32>(_e3618) >> bitcast<u32>((_e3336 & 31u)))) + _e3634.member) + _e3640);
                                            local_25[1u].member_1 = _e3637;
                                            local_25[2u].member = ((bitcast<u32>((bitcast<i32>(_e3767) >> bitcast<u32>((_e3336 & 31u)))) + _e3783.member) + _e3789);
                                            local_25[2u].member_1 = _e3786;
                                            if (_e2083[0][1][0].member_1 < _e2083[0][0][0].member_1) {
                                                phi_5468_ = 1u;
                                            } else {
                                                phi_5468_ = 0u;
                                            }
                                            let _e3814 = phi_5468_;
                                            let _e3818 = function_5(((_e2083[0][1][0].member - _e2083[0][0][0].member) - _e3814), (_e2083[0][1][0].member_1 - _e2083[0][0][0].member_1), _e3074);
                                            let _e3821 = (_e2083[0][0][0].member_1 + _e3818.member_1);
                                            if (_e3821 < _e2083[0][0][0].member_1) {
                                                phi_5480_ = 1u;
                                            } else {
                                                phi_5480_ = 0u;
                                            }
                                            let _e3824 = phi_5480_;
                                            let _e3826 = ((_e2083[0][0][0].member + _e3818.member) + _e3824);
                                            if (_e2083[0][1][1].member_1 < _e2083[0][0][1].member_1) {
                                                phi_5491_ = 1u;
                                            } else {
                                                phi_5491_ = 0u;
                                            }
                                            let _e3837 = phi_5491_;
                                            let _e3841 = function_5(((_e2083[0][1][1].member - _e2083[0][0][1].member) - _e3837), (_e2083[0][1][1].member_1 - _e2083[0][0][1].member_1), _e3074);
                                            let _e3844 = (_e2083[0][0][1].member_1 + _e3841.member_1);
                                            if (_e3844 < _e2083[0][0][1].member_1) {
                                                phi_5503_ = 1u;
                                            } else {
                                                phi_5503_ = 0u;
                                            }
                                            let _e3847 = phi_5503_;
                                            let _e3849 = ((_e2083[0][0][1].member + _e3841.member) + _e3847);
                                            if (_e2083[0][1][2].member_1 < _e2083[0][0][2].member_1) {
                                                phi_5514_ = 1u;
                                            } else {
                                                phi_5514_ = 0u;
                                            }
                                            let _e3860 = phi_5514_;
                                            let _e3864 = function_5(((_e2083[0][1][2].member - _e2083[0][0][2].member) - _e3860), (_e2083[0][1][2].member_1 - _e2083[0][0][2].member_1), _e3074);
                                            let _e3867 = (_e2083[0][0][2].member_1 + _e3864.member_1);
                                            if (_e3867 < _e2083[0][0][2].member_1) {
                                                phi_5526_ = 1u;
                                            } else {
                                                phi_5526_ = 0u;
                                            }
                                            let _e3870 = phi_5526_;
                                            let _e3872 = ((_e2083[0][0][2].member + _e3864.member) + _e3870);
                                            if (_e2083[1][1][0].member_1 < _e2083[1][0][0].member_1) {
                                                phi_5545_ = 1u;
                                            } else {
                                                phi_5545_ = 0u;
                                            }
                                            let _e3885 = phi_5545_;
                                            let _e3889 = function_5(((_e2083[1][1][0].member - _e2083[1][0][0].member) - _e3885), (_e2083[1][1][0].member_1 - _e2083[1][0][0].member_1), _e3074);
                                            let _e3892 = (_e2083[1][0][0].member_1 + _e3889.member_1);
                                            if (_e3892 < _e2083[1][0][0].member_1) {
                                                phi_5557_ = 1u;
                                            } else {
                                                phi_5557_ = 0u;
                                            }
                                            let _e3895 = phi_5557_;
                                            let _e3897 = ((_e2083[1][0][0].member + _e3889.member) + _e3895);
                                            if (_e2083[1][1][1].member_1 < _e2083[1][0][1].member_1) {
                                                phi_5568_ = 1u;
                                            } else {
                                                phi_5568_ = 0u;
                                            }
                                            let _e3908 = phi_5568_;
                                            let _e3912 = function_5(((_e2083[1][1][1].member - _e2083[1][0][1].member) - _e3908), (_e2083[1][1][1].member_1 - _e2083[1][0][1].member_1), _e3074);
                                            let _e3915 = (_e2083[1][0][1].member_1 + _e3912.member_1);
                                            if (_e3915 < _e2083[1][0][1].member_1) {
                                                phi_5580_ = 1u;
                                            } else {
                                                phi_5580_ = 0u;
                                            }
                                            let _e3918 = phi_5580_;
                                            let _e3920 = ((_e2083[1][0][1].member + _e3912.member) + _e3918);
                                            if (_e2083[1][1][2].member_1 < _e2083[1][0][2].member_1) {
                                                phi_5591_ = 1u;
                                            } else {
                                                phi_5591_ = 0u;
                                            }
                                            let _e3931 = phi_5591_;
                                            let _e3935 = function_5(((_e2083[1][1][2].member - _e2083[1][0][2].member) - _e3931), (_e2083[1][1][2].member_1 - _e2083[1][0][2].member_1), _e3074);
                                            let _e3938 = (_e2083[1][0][2].member_1 + _e3935.member_1);
                                            if (_e3938 < _e2083[1][0][2].member_1) {
                                                phi_5603_ = 1u;
                                            } else {
                                                phi_5603_ = 0u;
                                            }
                                            let _e3941 = phi_5603_;
                                            let _e3943 = ((_e2083[1][0][2].member + _e3935.member) + _e3941);
                                            if (_e2083[2][1][0].member_1 < _e2083[2][0][0].member_1) {
                                                phi_5622_ = 1u;
                                            } else {
                                                phi_5622_ = 0u;
                                            }
                                            let _e3956 = phi_5622_;
                                            let _e3960 = function_5(((_e2083[2][1][0].member - _e2083[2][0][0].member) - _e3956), (_e2083[2][1][0].member_1 - _e2083[2][0][0].member_1), _e3074);
                                            let _e3963 = (_e2083[2][0][0].member_1 + _e3960.member_1);
                                            if (_e3963 < _e2083[2][0][0].member_1) {
                                                phi_5634_ = 1u;
                                            } else {
                                                phi_5634_ = 0u;
                                            }
                                            let _e3966 = phi_5634_;
                                            let _e3968 = ((_e2083[2][0][0].member + _e3960.member) + _e3966);
                                            if (_e2083[2][1][1].member_1 < _e2083[2][0][1].member_1) {
                                                phi_5645_ = 1u;
                                            } else {
                                                phi_5645_ = 0u;
                                            }
                                            let _e3979 = phi_5645_;
                                            let _e3983 = function_5(((_e2083[2][1][1].member - _e2083[2][0][1].member) - _e3979), (_e2083[2][1][1].member_1 - _e2083[2][0][1].member_1), _e3074);
                                            let _e3986 = (_e2083[2][0][1].member_1 + _e3983.member_1);
                                            if (_e3986 < _e2083[2][0][1].member_1) {
                                                phi_5657_ = 1u;
                                            } else {
                                                phi_5657_ = 0u;
                                            }
                                            let _e3989 = phi_5657_;
                                            let _e3991 = ((_e2083[2][0][1].member + _e3983.member) + _e3989);
                                            if (_e2083[2][1][2].member_1 < _e2083[2][0][2].member_1) {
                                                phi_5668_ = 1u;
                                            } else {
                                                phi_5668_ = 0u;
                                            }
                                            let _e4002 = phi_5668_;
                                            let _e4006 = function_5(((_e2083[2][1][2].member - _e2083[2][0][2].member) - _e4002), (_e2083[2][1][2].member_1 - _e2083[2][0][2].member_1), _e3074);
                                            let _e4009 = (_e2083[2][0][2].member_1 + _e4006.member_1);
                                            if (_e4009 < _e2083[2][0][2].member_1) {
                                                phi_5680_ = 1u;
                                            } else {
                                                phi_5680_ = 0u;
                                            }
                                            let _e4012 = phi_5680_;
                                            let _e4014 = ((_e2083[2][0][2].member + _e4006.member) + _e4012);
                                            local_23 = array<type_9, 3>(type_9(_e3897, _e3892), type_9(_e3920, _e3915), type_9(_e3943, _e3938));
                                            local_24 = array<type_9, 3>(type_9(_e3968, _e3963), type_9(_e3991, _e3986), type_9(_e4014, _e4009));
                                            let _e4025 = local_23[1u].member;
                                            let _e4027 = local_23[1u].member_1;
                                            let _e4030 = local_24[2u].member;
                                            let _e4032 = local_24[2u].member_1;
                                            let _e4033 = function_9(_e4025, _e4027, _e4030, _e4032);
                                            let _e4038 = local_23[2u].member;
                                            let _e4040 = local_23[2u].member_1;
                                            let _e4043 = local_24[1u].member;
                                            let _e4045 = local_24[1u].member_1;
                                            let _e4046 = function_9(_e4038, _e4040, _e4043, _e4045);
                                            if (_e4033.member_1 < _e4046.member_1) {
                                                phi_5765_ = 1u;
                                            } else {
                                                phi_5765_ = 0u;
                                            }
                                            let _e4051 = phi_5765_;
                                            let _e4053 = ((_e4033.member - _e4046.member) - _e4051);
                                            let _e4054 = (_e4033.member_1 - _e4046.member_1);
                                            local_21 = array<type_9, 3>(type_9(_e3897, _e3892), type_9(_e3920, _e3915), type_9(_e3943, _e3938));
                                            local_22 = array<type_9, 3>(type_9(_e3968, _e3963), type_9(_e3991, _e3986), type_9(_e4014, _e4009));
                                            let _e4065 = local_21[2u].member;
                                            let _e4067 = local_21[2u].member_1;
                                            let _e4070 = local_22[0u].member;
                                            let _e4072 = local_22[0u].member_1;
                                            let _e4073 = function_9(_e4065, _e4067, _e4070, _e4072);
                                            let _e4078 = local_21[0u].member;
                                            let _e4080 = local_21[0u].member_1;
                                            let _e4083 = local_22[2u].member;
                                            let _e4085 = local_22[2u].member_1;
                                            let _e4086 = function_9(_e4078, _e4080, _e4083, _e4085);
                                            if (_e4073.member_1 < _e4086.member_1) {
                                                phi_5845_ = 1u;
                                            } else {
                                                phi_5845_ = 0u;
                                            }
                                            let _e4091 = phi_5845_;
                                            let _e4093 = ((_e4073.member - _e4086.member) - _e4091);
                                            let _e4094 = (_e4073.member_1 - _e4086.member_1);
                                            local_19 = array<type_9, 3>(type_9(_e3897, _e3892), type_9(_e3920, _e3915), type_9(_e3943, _e3938));
                                            local_20 = array<type_9, 3>(type_9(_e3968, _e3963), type_9(_e3991, _e3986), type_9(_e4014, _e4009));
                                            let _e4105 = local_19[0u].member;
                                            let _e4107 = local_19[0u].member_1;
                                            let _e4110 = local_20[1u].member;
                                            let _e4112 = local_20[1u].member_1;
                                            let _e4113 = function_9(_e4105, _e4107, _e4110, _e4112);
                                            let _e4118 = local_19[1u].member;
                                            let _e4120 = local_19[1u].member_1;
                                            let _e4123 = local_20[0u].member;
                                            let _e4125 = local_20[0u].member_1;
                                            let _e4126 = function_9(_e4118, _e4120, _e4123, _e4125);
                                            if (_e4113.member_1 < _e4126.member_1) {
                                                phi_5925_ = 1u;
                                            } else {
                                                phi_5925_ = 0u;
                                            }
                                            let _e4131 = phi_5925_;
                                            let _e4133 = ((_e4113.member - _e4126.member) - _e4131);
                                            let _e4134 = (_e4113.member_1 - _e4126.member_1);
                                            if ((_e4053 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e4054 == 0u) {
                                                    phi_5946_ = 1u;
                                                } else {
                                                    phi_5946_ = 0u;
                                                }
                                                let _e4141 = phi_5946_;
                                                phi_5953_ = type_9((~(_e4053) + _e4141), (~(_e4054) + 1u));
                                            } else {
                                                phi_5953_ = type_9(_e4053, _e4054);
                                            }
                                            let _e4148 = phi_5953_;
                                            if ((_e4093 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e4094 == 0u) {
                                                    phi_5967_ = 1u;
                                                } else {
                                                    phi_5967_ = 0u;
                                                }
                                                let _e4157 = phi_5967_;
                                                phi_5974_ = type_9((~(_e4093) + _e4157), (~(_e4094) + 1u));
                                            } else {
                                                phi_5974_ = type_9(_e4093, _e4094);
                                            }
                                            let _e4164 = phi_5974_;
                                            if ((_e4133 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e4134 == 0u) {
                                                    phi_5988_ = 1u;
                                                } else {
                                                    phi_5988_ = 0u;
                                                }
                                                let _e4173 = phi_5988_;
                                                phi_5995_ = type_9((~(_e4133) + _e4173), (~(_e4134) + 1u));
                                            } else {
                                                phi_5995_ = type_9(_e4133, _e4134);
                                            }
                                            let _e4180 = phi_5995_;
                                            if (_e4164.member_1 < _e4148.member_1) {
                                                phi_6002_ = 1u;
                                            } else {
                                                phi_6002_ = 0u;
                                            }
                                            let _e4185 = phi_6002_;
                                            if ((((_e4164.member - _e4148.member) - _e4185) >> bitcast<u32>(31i)) != 0u) {
                                                if (_e4180.member_1 < _e4148.member_1) {
                                                    phi_6014_ = 1u;
                                                } else {
                                                    phi_6014_ = 0u;
                                                }
                                                let _e4193 = phi_6014_;
                                                if ((((_e4180.member - _e4148.member) - _e4193) >> bitcast<u32>(31i)) != 0u) {
                                                    phi_6022_ = false;
                                                } else {
                                                    phi_6022_ = true;
                                                }
                                                let _e4200 = phi_6022_;
                                                phi_6023_ = _e4200;
                                            } else {
                                                phi_6023_ = true;
                                            }
                                            let _e4202 = phi_6023_;
                                            if _e4202 {
                                                if (_e4180.member_1 < _e4164.member_1) {
                                                    phi_6031_ = 1u;
                                                } else {
                                                    phi_6031_ = 0u;
                                                }
                                                let _e4205 = phi_6031_;
                                                if ((((_e4180.member - _e4164.member) - _e4205) >> bitcast<u32>(31i)) != 0u) {
                                                    phi_6039_ = 1i;
                                                } else {
                                                    phi_6039_ = 2i;
                                                }
                                                let _e4212 = phi_6039_;
                                                phi_6040_ = _e4212;
                                            } else {
                                                phi_6040_ = 0i;
                                            }
                                            let _e4214 = phi_6040_;
                                            switch _e4214 {
                                                case 0: {
                                                    phi_6069_ = array<type_9, 2>(type_9(_e3849, _e3844), type_9(_e3872, _e3867));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6069_ = array<type_9, 2>(type_9(_e3872, _e3867), type_9(_e3826, _e3821));
                                                    break;
                                                }
                                                default: {
                                                    phi_6069_ = array<type_9, 2>(type_9(_e3826, _e3821), type_9(_e3849, _e3844));
                                                    break;
                                                }
                                            }
                                            let _e4225 = phi_6069_;
                                            switch _e4214 {
                                                case 0: {
                                                    phi_6098_ = array<type_9, 2>(type_9(_e3920, _e3915), type_9(_e3943, _e3938));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6098_ = array<type_9, 2>(type_9(_e3943, _e3938), type_9(_e3897, _e3892));
                                                    break;
                                                }
                                                default: {
                                                    phi_6098_ = array<type_9, 2>(type_9(_e3897, _e3892), type_9(_e3920, _e3915));
                                                    break;
                                                }
                                            }
                                            let _e4236 = phi_6098_;
                                            switch _e4214 {
                                                case 0: {
                                                    phi_6127_ = array<type_9, 2>(type_9(_e3991, _e3986), type_9(_e4014, _e4009));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6127_ = array<type_9, 2>(type_9(_e4014, _e4009), type_9(_e3968, _e3963));
                                                    break;
                                                }
                                                default: {
                                                    phi_6127_ = array<type_9, 2>(type_9(_e3968, _e3963), type_9(_e3991, _e3986));
                                                    break;
                                                }
                                            }
                                            let _e4247 = phi_6127_;
                                            switch _e4214 {
                                                case 0: {
                                                    phi_6141_ = type_9(_e4053, _e4054);
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6141_ = type_9(_e4093, _e4094);
                                                    break;
                                                }
                                                default: {
                                                    phi_6141_ = type_9(_e4133, _e4134);
                                                    break;
                                                }
                                            }
                                            let _e4252 = phi_6141_;
                                            let _e4255 = local_25[1u].member;
                                            let _e4257 = local_25[1u].member_1;
                                            let _e4260 = local_25[2u].member;
                                            let _e4262 = local_25[2u].member_1;
                                            let _e4263 = (_e4257 + _e4262);
                                            if (_e4263 < _e4257) {
                                                phi_6167_ = 1u;
                                            } else {
                                                phi_6167_ = 0u;
                                            }
                                            let _e4266 = phi_6167_;
                                            let _e4268 = ((_e4255 + _e4260) + _e4266);
                                            let _e4279 = ((_e4263 >> bitcast<u32>(1u)) | ((_e4268 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e4280 = function_11(17u);
                                            let _e4283 = (_e4279 + _e4280.member_1);
                                            if (_e4283 < _e4279) {
                                                phi_6189_ = 1u;
                                            } else {
                                                phi_6189_ = 0u;
                                            }
                                            let _e4286 = phi_6189_;
                                            let _e4288 = ((bitcast<u32>((bitcast<i32>(_e4268) >> bitcast<u32>(1u))) + _e4280.member) + _e4286);
                                            let _e4291 = local_25[0u].member;
                                            let _e4293 = local_25[0u].member_1;
                                            let _e4296 = local_25[2u].member;
                                            let _e4298 = local_25[2u].member_1;
                                            let _e4299 = (_e4293 + _e4298);
                                            if (_e4299 < _e4293) {
                                                phi_6217_ = 1u;
                                            } else {
                                                phi_6217_ = 0u;
                                            }
                                            let _e4302 = phi_6217_;
                                            let _e4304 = ((_e4291 + _e4296) + _e4302);
                                            let _e4315 = ((_e4299 >> bitcast<u32>(1u)) | ((_e4304 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e4316 = function_11(17u);
                                            let _e4319 = (_e4315 + _e4316.member_1);
                                            if (_e4319 < _e4315) {
                                                phi_6239_ = 1u;
                                            } else {
                                                phi_6239_ = 0u;
                                            }
                                            let _e4322 = phi_6239_;
                                            let _e4324 = ((bitcast<u32>((bitcast<i32>(_e4304) >> bitcast<u32>(1u))) + _e4316.member) + _e4322);
                                            let _e4327 = local_25[0u].member;
                                            let _e4329 = local_25[0u].member_1;
                                            let _e4332 = local_25[1u].member;
                                            let _e4334 = local_25[1u].member_1;
                                            let _e4335 = (_e4329 + _e4334);
                                            if (_e4335 < _e4329) {
                                                phi_6267_ = 1u;
                                            } else {
                                                phi_6267_ = 0u;
                                            }
                                            let _e4338 = phi_6267_;
                                            let _e4340 = ((_e4327 + _e4332) + _e4338);
                                            let _e4351 = ((_e4335 >> bitcast<u32>(1u)) | ((_e4340 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e4352 = function_11(17u);
                                            let _e4355 = (_e4351 + _e4352.member_1);
                                            if (_e4355 < _e4351) {
                                                phi_6289_ = 1u;
                                            } else {
                                                phi_6289_ = 0u;
                                            }
                                            let _e4358 = phi_6289_;
                                            let _e4360 = ((bitcast<u32>((bitcast<i32>(_e4340) >> bitcast<u32>(1u))) + _e4352.member) + _e4358);
                                            if ((_e4252.member >> bitcast<u32>(31i)) != 0u) {
                                                if (_e4252.member_1 == 0u) {
                                                    phi_6303_ = 1u;
                                                } else {
                                                    phi_6303_ = 0u;
                                                }
                                                let _e4368 = phi_6303_;
                                                phi_6310_ = type_9((~(_e4252.member) + _e4368), (~(_e4252.member_1) + 1u));
                                            } else {
                                                phi_6310_ = _e4252;
                                            }
                                            let _e4375 = phi_6310_;
                                            if (_e4283 < _e4375.member_1) {
                                                phi_6317_ = 1u;
                                            } else {
                                                phi_6317_ = 0u;
                                            }
                                            let _e4380 = phi_6317_;
                                            if ((((_e4288 - _e4375.member) - _e4380) >> bitcast<u32>(31i)) != 0u) {
                                                let _e4389 = ((_e4252.member >> bitcast<u32>(31i)) != 0u);
                                                if _e4389 {
                                                    if (_e4252.member_1 == 0u) {
                                                        phi_6337_ = 1u;
                                                    } else {
                                                        phi_6337_ = 0u;
                                                    }
                                                    let _e4394 = phi_6337_;
                                                    phi_6344_ = type_9((~(_e4252.member) + _e4394), (~(_e4252.member_1) + 1u));
                                                } else {
                                                    phi_6344_ = _e4252;
                                                }
                                                let _e4401 = phi_6344_;
                                                let _e4404 = function_10(_e4225, _e4247);
                                                if _e4389 {
                                                    if (_e4404.member_1 == 0u) {
                                                        phi_6357_ = 1u;
                                                    } else {
                                                        phi_6357_ = 0u;
                                                    }
                                                    let _e4409 = phi_6357_;
                                                    phi_6364_ = type_9((~(_e4404.member) + _e4409), (~(_e4404.member_1) + 1u));
                                                } else {
                                                    phi_6364_ = _e4404;
                                                }
                                                let _e4416 = phi_6364_;
                                                let _e4419 = function_10(_e4236, _e4225);
                                                if _e4389 {
                                                    if (_e4419.member_1 == 0u) {
                                                        phi_6377_ = 1u;
                                                    } else {
                                                        phi_6377_ = 0u;
                                                    }
                                                    let _e4424 = phi_6377_;
                                                    phi_6384_ = type_9((~(_e4419.member) + _e4424), (~(_e4419.member_1) + 1u));
                                                } else {
                                                    phi_6384_ = _e4419;
                                                }
                                                let _e4431 = phi_6384_;
                                                if (_e316.member != 0u) {
                                                    if (_e4401.member_1 < _e4416.member_1) {
                                                        phi_6395_ = 1u;
                                                    } else {
                                                        phi_6395_ = 0u;
                                                    }
                                                    let _e4465 = phi_6395_;
                                                    let _e4470 = (_e4283 + _e4319);
                                                    if (_e4470 < _e4283) {
                                                        phi_6405_ = 1u;
                                                    } else {
                                                        phi_6405_ = 0u;
                                                    }
                                                    let _e4473 = phi_6405_;
                                                    if (_e4401.member_1 < _e4431.member_1) {
                                                        phi_6413_ = 1u;
                                                    } else {
                                                        phi_6413_ = 0u;
                                                    }
                                                    let _e4479 = phi_6413_;
                                                    let _e4484 = (_e4283 + _e4355);
                                                    if (_e4484 < _e4283) {
                                                        phi_6423_ = 1u;
                                                    } else {
                                                        phi_6423_ = 0u;
                                                    }
                                                    let _e4487 = phi_6423_;
                                                    phi_6463_ = type_9(((_e4288 + _e4360) + _e4487), _e4484);
                                                    phi_6464_ = type_9(((_e4401.member - _e4431.member) - _e4479), (_e4401.member_1 - _e4431.member_1));
                                                    phi_6465_ = type_9(((_e4288 + _e4324) + _e4473), _e4470);
                                                    phi_6466_ = type_9(((_e4401.member - _e4416.member) - _e4465), (_e4401.member_1 - _e4416.member_1));
                                                } else {
                                                    if (_e4401.member_1 < _e4416.member_1) {
                                                        phi_6431_ = 1u;
                                                    } else {
                                                        phi_6431_ = 0u;
                                                    }
                                                    let _e4437 = phi_6431_;
                                                    let _e4440 = (_e4401.member_1 - _e4416.member_1);
                                                    if (_e4440 < _e4431.member_1) {
                                                        phi_6439_ = 1u;
                                                    } else {
                                                        phi_6439_ = 0u;
                                                    }
                                                    let _e4443 = phi_6439_;
                                                    let _e4445 = ((((_e4401.member - _e4416.member) - _e4437) - _e4431.member) - _e4443);
                                                    let _e4446 = (_e4440 - _e4431.member_1);
                                                    let _e4448 = (_e4283 + _e4319);
                                                    if (_e4448 < _e4283) {
                                                        phi_6449_ = 1u;
                                                    } else {
                                                        phi_6449_ = 0u;
                                                    }
                                                    let _e4451 = phi_6449_;
                                                    let _e4454 = (_e4448 + _e4355);
                                                    if (_e4454 < _e4448) {
                                                        phi_6457_ = 1u;
                                                    } else {
                                                        phi_6457_ = 0u;
                                                    }
                                                    let _e4457 = phi_6457_;
                                                    let _e4459 = ((((_e4288 + _e4324) + _e4451) + _e4360) + _e4457);
                                                    phi_6463_ = type_9(_e4459, _e4454);
                                                    phi_6464_ = type_9(_e4445, _e4446);
                                                    phi_6465_ = type_9(_e4459, _e4454);
                                                    phi_6466_ = type_9(_e4445, _e4446);
                                                }
                                                let _e4492 = phi_6463_;
                                                let _e4494 = phi_6464_;
                                                let _e4496 = phi_6465_;
                                                let _e4498 = phi_6466_;
                                                let _e4499 = function_8(_e4416.member, _e4416.member_1, _e4324, _e4319);
                                                if _e4499 {
                                                    phi_6592_ = u32();
                                                    phi_6593_ = true;
                                                } else {
                                                    let _e4500 = function_8(_e4431.member, _e4431.member_1, _e4360, _e4355);
                                                    if _e4500 {
                                                        phi_6590_ = u32();
                                                        phi_6591_ = true;
                                                    } else {
                                                        let _e4505 = function_8(_e4498.member, _e4498.member_1, _e4496.member, _e4496.member_1);
                                                        if _e4505 {
                                                            phi_6588_ = u32();
                                                            phi_6589_ = true;
                                                        } else {
                                                            let _e4510 = function_8(_e4494.member, _e4494.member_1, _e4492.member, _e4492.member_1);
                                                            if _e4510 {
                                                                phi_6587_ = u32();
                                                            } else {
                                                                let _e4511 = function_7(_e4416.member, _e4416.member_1, _e4324, _e4319);
                                                                if _e4511 {
                                                                    let _e4512 = function_7(_e4431.member, _e4431.member_1, _e4360, _e4355);
                                                                    if _e4512 {
                                                                        let _e4517 = function_7(_e4498.member, _e4498.member_1, _e4496.member, _e4496.member_1);
                                                                        if _e4517 {
                                                                            let _e4522 = function_7(_e4494.member, _e4494.member_1, _e4492.member, _e4492.member_1);
                                                                            if _e4522 {
                                                                                phi_6579_ = false;
                                                                            } else {
                                                                                phi_6579_ = true;
                                                                            }
                                                                            let _e4524 = phi_6579_;
                                                                            phi_6580_ = _e4524;
                                                                        } else {
                                                                            phi_6580_ = true;
                                                                        }
                                                                        let _e4526 = phi_6580_;
                                                                        phi_6581_ = _e4526;
                                                                    } else {
                                                                        phi_6581_ = true;
                                                                    }
                                                                    let _e4528 = phi_6581_;
                                                                    phi_6582_ = _e4528;
                                                                } else {
                                                                    phi_6582_ = true;
                                                                }
                                                                let _e4530 = phi_6582_;
                                                                if _e4530 {
                                                                    phi_6586_ = 2u;
                                                                } else {
                                                                    phi_6586_ = 0u;
                                                                }
                                                                let _e4532 = phi_6586_;
                                                                phi_6587_ = _e4532;
                                                            }
                                                            let _e4534 = phi_6587_;
                                                            phi_6588_ = _e4534;
                                                            phi_6589_ = _e4510;
                                                        }
                                                        let _e4536 = phi_6588_;
                                                        let _e4538 = phi_6589_;
                                                        phi_6590_ = _e4536;
                                                        phi_6591_ = _e4538;
                                                    }
                                                    let _e4540 = phi_6590_;
                                                    let _e4542 = phi_6591_;
                                                    phi_6592_ = _e4540;
                                                    phi_6593_ = _e4542;
                                                }
                                                let _e4544 = phi_6592_;
                                                let _e4546 = phi_6593_;
                                                if _e4546 {
                                                    phi_6597_ = 1u;
                                                } else {
                                                    phi_6597_ = _e4544;
                                                }
                                                let _e4548 = phi_6597_;
                                                phi_6598_ = _e4548;
                                            } else {
                                                phi_6598_ = 2u;
                                            }
                                            let _e4550 = phi_6598_;
                                            let _e4551 = (_e4550 == 1u);
                                            if _e3239 {
                                                phi_6606_ = _e4551;
                                            } else {
                                                phi_6606_ = true;
                                            }
                                            let _e4553 = phi_6606_;
                                            phi_6610_ = _e4551;
                                            phi_6611_ = _e3326;
                                            phi_6612_ = _e3329;
                                            phi_6613_ = (_e3074 + (1u << bitcast<u32>(((31u - _e3336) & 31u))));
                                            phi_6614_ = _e4550;
                                            phi_6615_ = _e4553;
                                        } else {
                                            phi_6610_ = _e3238;
                                            phi_6611_ = bool();
                                            phi_6612_ = bool();
                                            phi_6613_ = u32();
                                            phi_6614_ = u32();
                                            phi_6615_ = true;
                                        }
                                        let _e4555 = phi_6610_;
                                        let _e4557 = phi_6611_;
                                        let _e4559 = phi_6612_;
                                        let _e4561 = phi_6613_;
                                        let _e4563 = phi_6614_;
                                        let _e4565 = phi_6615_;
                                        if _e4565 {
                                            if _e4555 {
                                                phi_6952_ = _e3049;
                                                phi_6954_ = _e3051;
                                                phi_6955_ = _e3053;
                                            } else {
                                                let _e4574 = (_e3049[0].member_1 + _e3049[1].member_1);
                                                if (_e4574 < _e3049[0].member_1) {
                                                    phi_6631_ = 1u;
                                                } else {
                                                    phi_6631_ = 0u;
                                                }
                                                let _e4577 = phi_6631_;
                                                let _e4579 = ((_e3049[0].member + _e3049[1].member) + _e4577);
                                                let _e4587 = bitcast<u32>((bitcast<i32>(_e4579) >> bitcast<u32>(1u)));
                                                let _e4590 = ((_e4574 >> bitcast<u32>(1u)) | ((_e4579 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4599 = (_e3049[1].member_1 + _e3049[2].member_1);
                                                if (_e4599 < _e3049[1].member_1) {
                                                    phi_6654_ = 1u;
                                                } else {
                                                    phi_6654_ = 0u;
                                                }
                                                let _e4602 = phi_6654_;
                                                let _e4604 = ((_e3049[1].member + _e3049[2].member) + _e4602);
                                                let _e4612 = bitcast<u32>((bitcast<i32>(_e4604) >> bitcast<u32>(1u)));
                                                let _e4615 = ((_e4599 >> bitcast<u32>(1u)) | ((_e4604 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4624 = (_e3049[2].member_1 + _e3049[3].member_1);
                                                if (_e4624 < _e3049[2].member_1) {
                                                    phi_6677_ = 1u;
                                                } else {
                                                    phi_6677_ = 0u;
                                                }
                                                let _e4627 = phi_6677_;
                                                let _e4629 = ((_e3049[2].member + _e3049[3].member) + _e4627);
                                                let _e4637 = bitcast<u32>((bitcast<i32>(_e4629) >> bitcast<u32>(1u)));
                                                let _e4640 = ((_e4624 >> bitcast<u32>(1u)) | ((_e4629 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4641 = (_e4590 + _e4615);
                                                if (_e4641 < _e4590) {
                                                    phi_6696_ = 1u;
                                                } else {
                                                    phi_6696_ = 0u;
                                                }
                                                let _e4644 = phi_6696_;
                                                let _e4646 = ((_e4587 + _e4612) + _e4644);
                                                let _e4654 = bitcast<u32>((bitcast<i32>(_e4646) >> bitcast<u32>(1u)));
                                                let _e4657 = ((_e4641 >> bitcast<u32>(1u)) | ((_e4646 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4658 = (_e4615 + _e4640);
                                                if (_e4658 < _e4615) {
                                                    phi_6715_ = 1u;
                                                } else {
                                                    phi_6715_ = 0u;
                                                }
                                                let _e4661 = phi_6715_;
                                                let _e4663 = ((_e4612 + _e4637) + _e4661);
                                                let _e4671 = bitcast<u32>((bitcast<i32>(_e4663) >> bitcast<u32>(1u)));
                                                let _e4674 = ((_e4658 >> bitcast<u32>(1u)) | ((_e4663 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4675 = (_e4657 + _e4674);
                                                if (_e4675 < _e4657) {
                                                    phi_6734_ = 1u;
                                                } else {
                                                    phi_6734_ = 0u;
                                                }
                                                let _e4678 = phi_6734_;
                                                let _e4680 = ((_e4654 + _e4671) + _e4678);
                                                let _e4688 = bitcast<u32>((bitcast<i32>(_e4680) >> bitcast<u32>(1u)));
                                                let _e4691 = ((_e4675 >> bitcast<u32>(1u)) | ((_e4680 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4692 = (2u * _e3053);
                                                let _e4703 = function_11(128u);
                                                if ((_e3049[0].member >> bitcast<u32>(31i)) != 0u) {
                                                    if (_e3049[0].member_1 == 0u) {
                                                        phi_6774_ = 1u;
                                                    } else {
                                                        phi_6774_ = 0u;
                                                    }
                                                    let _e4712 = phi_6774_;
                                                    phi_6781_ = type_9((~(_e3049[0].member) + _e4712), (~(_e3049[0].member_1) + 1u));
                                                } else {
                                                    phi_6781_ = _e3049[0];
                                                }
                                                let _e4719 = phi_6781_;
                                                if (_e4703.member_1 < _e4719.member_1) {
                                                    phi_6788_ = 1u;
                                                } else {
                                                    phi_6788_ = 0u;
                                                }
                                                let _e4724 = phi_6788_;
                                                if ((((_e4703.member - _e4719.member) - _e4724) >> bitcast<u32>(31i)) != 0u) {
                                                    if ((_e3049[0].member >> bitcast<u32>(31i)) != 0u) {
                                                        phi_6801_ = 2u;
                                                    } else {
                                                        phi_6801_ = 1u;
                                                    }
                                                    let _e4734 = phi_6801_;
                                                    phi_6802_ = _e4734;
                                                } else {
                                                    phi_6802_ = 0u;
                                                }
                                                let _e4736 = phi_6802_;
                                                let _e4737 = function_11(128u);
                                                if ((_e4587 >> bitcast<u32>(31i)) != 0u) {
                                                    if (_e4590 == 0u) {
                                                        phi_6817_ = 1u;
                                                    } else {
                                                        phi_6817_ = 0u;
                                                    }
                                                    let _e4746 = phi_6817_;
                                                    phi_6824_ = type_9((~(_e4587) + _e4746), (~(_e4590) + 1u));
                                                } else {
                                                    phi_6824_ = type_9(_e4587, _e4590);
                                                }
                                                let _e4753 = phi_6824_;
                                                if (_e4737.member_1 < _e4753.member_1) {
                                                    phi_6831_ = 1u;
                                                } else {
                                                    phi_6831_ = 0u;
                                                }
                                                let _e4758 = phi_6831_;
                                                if ((((_e4737.member - _e4753.member) - _e4758) >> bitcast<u32>(31i)) != 0u) {
                                                    if ((_e4587 >> bitcast<u32>(31i)) != 0u) {
                                                        phi_6844_ = 2u;
                                                    } else {
                                                        phi_6844_ = 1u;
                                                    }
                                                    let _e4768 = phi_6844_;
                                                    phi_6845_ = _e4768;
                                                } else {
                                                    phi_6845_ = 0u;
                                                }
                                                let _e4770 = phi_6845_;
                                                let _e4772 = function_11(128u);
                                                if ((_e4654 >> bitcast<u32>(31i)) != 0u) {
                                                    if (_e4657 == 0u) {
                                                        phi_6861_ = 1u;
                                                    } else {
                                                        phi_6861_ = 0u;
                                                    }
                                                    let _e4781 = phi_6861_;
                                                    phi_6868_ = type_9((~(_e4654) + _e4781), (~(_e4657) + 1u));
                                                } else {
                                                    phi_6868_ = type_9(_e4654, _e4657);
                                                }
                                                let _e4788 = phi_6868_;
                                                if (_e4772.member_1 < _e4788.member_1) {
                                                    phi_6875_ = 1u;
                                                } else {
                                                    phi_6875_ = 0u;
                                                }
                                                let _e4793 = phi_6875_;
                                                if ((((_e4772.member - _e4788.member) - _e4793) >> bitcast<u32>(31i)) != 0u) {
                                                    if ((_e4654 >> bitcast<u32>(31i)) != 0u) {
                                                        phi_6888_ = 2u;
                                                    } else {
                                                        phi_6888_ = 1u;
                                                    }
                                                    let _e4803 = phi_6888_;
                                                    phi_6889_ = _e4803;
                                                } else {
                                                    phi_6889_ = 0u;
                                                }
                                                let _e4805 = phi_6889_;
                                                let _e4807 = function_11(128u);
                                                if ((_e4688 >> bitcast<u32>(31i)) != 0u) {
                                                    if (_e4691 == 0u) {
                                                        phi_6905_ = 1u;
                                                    } else {
                                                        phi_6905_ = 0u;
                                                    }
                                                    let _e4816 = phi_6905_;
                                                    phi_6912_ = type_9((~(_e4688) + _e4816), (~(_e4691) + 1u));
                                                } else {
                                                    phi_6912_ = type_9(_e4688, _e4691);
                                                }
                                                let _e4823 = phi_6912_;
                                                if (_e4807.member_1 < _e4823.member_1) {
                                                    phi_6919_ = 1u;
                                                } else {
                                                    phi_6919_ = 0u;
                                                }
                                                let _e4828 = phi_6919_;
                                                if ((((_e4807.member - _e4823.member) - _e4828) >> bitcast<u32>(31i)) != 0u) {
                                                    if ((_e4688 >> bitcast<u32>(31i)) != 0u) {
                                                        phi_6932_ = 2u;
                                                    } else {
                                                        phi_6932_ = 1u;
                                                    }
                                                    let _e4838 = phi_6932_;
                                                    phi_6933_ = _e4838;
                                                } else {
                                                    phi_6933_ = 0u;
                                                }
                                                let _e4840 = phi_6933_;
                                                if ((((_e4736 & _e4770) & _e4805) & _e4840) != 0u) {
                                                    phi_6950_ = array<type_9, 4>(type_9(_e4688, _e4691), type_9(_e4671, _e4674), type_9(_e4637, _e4640), type_9(_e3049[3].member, _e3049[3].member_1));
                                                    phi_6951_ = (_e4692 + 1u);
                                                } else {
                                                    phi_6950_ = array<type_9, 4>(_e3049[0], type_9(_e4587, _e4590), type_9(_e4654, _e4657), type_9(_e4688, _e4691));
                                                    phi_6951_ = _e4692;
                                                }
                                                let _e4854 = phi_6950_;
                                                let _e4856 = phi_6951_;
                                                phi_6952_ = _e4854;
                                                phi_6954_ = (_e3051 + 1u);
                                                phi_6955_ = _e4856;
                                            }
                                            let _e4858 = phi_6952_;
                                            let _e4860 = phi_6954_;
                                            let _e4862 = phi_6955_;
                                            phi_6956_ = _e4858;
                                            phi_6958_ = _e4860;
                                            phi_6959_ = _e4862;
                                        } else {
                                            phi_6956_ = array<type_9, 4>();
                                            phi_6958_ = u32();
                                            phi_6959_ = u32();
                                        }
                                        let _e4864 = phi_6956_;
                                        let _e4866 = phi_6958_;
                                        let _e4868 = phi_6959_;
                                        phi_6960_ = _e4864;
                                        phi_6962_ = _e4555;
                                        phi_6963_ = _e4866;
                                        phi_6964_ = _e4868;
                                        phi_6965_ = _e4557;
                                        phi_6966_ = _e4559;
                                        phi_6967_ = _e4561;
                                        phi_6968_ = _e4563;
                                        phi_6969_ = _e4565;
                                    }
                                    let _e4870 = phi_6960_;
                                    let _e4872 = phi_6962_;
                                    let _e4874 = phi_6963_;
                                    let _e4876 = phi_6964_;
                                    let _e4878 = phi_6965_;
                                    let _e4880 = phi_6966_;
                                    let _e4882 = phi_6967_;
                                    let _e4884 = phi_6968_;
                                    let _e4886 = phi_6969_;
                                    if _e4886 {
                                        if _e4872 {
                                            let _e4887 = (_e4876 + 1u);
                                            let _e4889 = (_e4887 & (4294967295u - _e4876));
                                            let _e4895 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e4889)), 32u, (_e4889 == 0u)));
                                            if (_e4874 < _e4895) {
                                                phi_6988_ = _e4874;
                                            } else {
                                                phi_6988_ = _e4895;
                                            }
                                            let _e4898 = phi_6988_;
                                            let _e4901 = (_e4887 >> bitcast<u32>((_e4898 & 31u)));
                                            let _e4902 = (_e4874 - _e4898);
                                            if (_e4901 == 1u) {
                                                if (_e4902 == 0u) {
                                                    phi_7000_ = false;
                                                } else {
                                                    phi_7000_ = true;
                                                }
                                                let _e4906 = phi_7000_;
                                                phi_7001_ = _e4906;
                                            } else {
                                                phi_7001_ = true;
                                            }
                                            let _e4908 = phi_7001_;
                                            if _e4908 {
                                                let _e4909 = (31u - _e4902);
                                                let _e4912 = (_e4901 << bitcast<u32>((_e4909 & 31u)));
                                                let _e4916 = ((_e4901 + 1u) << bitcast<u32>((_e4909 & 31u)));
                                                if (_e2922 < _e2849.member_1) {
                                                    phi_7019_ = 1u;
                                                } else {
                                                    phi_7019_ = 0u;
                                                }
                                                let _e4919 = phi_7019_;
                                                let _e4923 = function_5(((_e2927 - _e2849.member) - _e4919), (_e2922 - _e2849.member_1), _e4912);
                                                let _e4926 = (_e2849.member_1 + _e4923.member_1);
                                                if (_e4926 < _e2849.member_1) {
                                                    phi_7031_ = 1u;
                                                } else {
                                                    phi_7031_ = 0u;
                                                }
                                                let _e4929 = phi_7031_;
                                                if (_e2998 < _e2922) {
                                                    phi_7042_ = 1u;
                                                } else {
                                                    phi_7042_ = 0u;
                                                }
                                                let _e4934 = phi_7042_;
                                                let _e4938 = function_5(((_e3003 - _e2927) - _e4934), (_e2998 - _e2922), _e4912);
                                                let _e4941 = (_e2922 + _e4938.member_1);
                                                if (_e4941 < _e2922) {
                                                    phi_7054_ = 1u;
                                                } else {
                                                    phi_7054_ = 0u;
                                                }
                                                let _e4944 = phi_7054_;
                                                if (_e3039.member_1 < _e2998) {
                                                    phi_7065_ = 1u;
                                                } else {
                                                    phi_7065_ = 0u;
                                                }
                                                let _e4949 = phi_7065_;
                                                let _e4953 = function_5(((_e3039.member - _e3003) - _e4949), (_e3039.member_1 - _e2998), _e4912);
                                                let _e4956 = (_e2998 + _e4953.member_1);
                                                if (_e4956 < _e2998) {
                                                    phi_7077_ = 1u;
                                                } else {
                                                    phi_7077_ = 0u;
                                                }
                                                let _e4959 = phi_7077_;
                                                let _e4965 = array<type_9, 3>(type_9(((_e2849.member + _e4923.member) + _e4929), _e4926), type_9(((_e2927 + _e4938.member) + _e4944), _e4941), type_9(((_e3003 + _e4953.member) + _e4959), _e4956));
                                                if (_e2922 < _e2849.member_1) {
                                                    phi_7094_ = 1u;
                                                } else {
                                                    phi_7094_ = 0u;
                                                }
                                                let _e4968 = phi_7094_;
                                                let _e4972 = function_5(((_e2927 - _e2849.member) - _e4968), (_e2922 - _e2849.member_1), _e4916);
                                                let _e4975 = (_e2849.member_1 + _e4972.member_1);
                                                if (_e4975 < _e2849.member_1) {
                                                    phi_7106_ = 1u;
                                                } else {
                                                    phi_7106_ = 0u;
                                                }
                                                let _e4978 = phi_7106_;
                                                if (_e2998 < _e2922) {
                                                    phi_7117_ = 1u;
                                                } else {
                                                    phi_7117_ = 0u;
                                                }
                                                let _e4983 = phi_7117_;
                                                let _e4987 = function_5(((_e3003 - _e2927) - _e4983), (_e2998 - _e2922), _e4916);
                                                let _e4990 = (_e2922 + _e4987.member_1);
                                                if (_e4990 < _e2922) {
                                                    phi_7129_ = 1u;
                                                } else {
                                                    phi_7129_ = 0u;
                                                }
                                                let _e4993 = phi_7129_;
                                                if (_e3039.member_1 < _e2998) {
                                                    phi_7140_ = 1u;
                                                } else {
                                                    phi_7140_ = 0u;
                                                }
                                                let _e4998 = phi_7140_;
                                                let _e5002 = function_5(((_e3039.member - _e3003) - _e4998), (_e3039.member_1 - _e2998), _e4916);
                                                let _e5005 = (_e2998 + _e5002.member_1);
                                                if (_e5005 < _e2998) {
                                                    phi_7152_ = 1u;
                                                } else {
                                                    phi_7152_ = 0u;
                                                }
                                                let _e5008 = phi_7152_;
                                                let _e5015 = function_6(_e4965, _e4912);
                                                let _e5016 = function_6(_e4965, _e4916);
                                                let _e5017 = function_6(array<type_9, 3>(type_9(((_e2849.member + _e4972.member) + _e4978), _e4975), type_9(((_e2927 + _e4987.member) + _e4993), _e4990), type_9(((_e3003 + _e5002.member) + _e5008), _e5005)), _e4916);
                                                if (_e5015[1].member_1 < _e5015[0].member_1) {
                                                    phi_7172_ = 1u;
                                                } else {
                                                    phi_7172_ = 0u;
                                                }
                                                let _e5028 = phi_7172_;
                                                let _e5032 = function_5(((_e5015[1].member - _e5015[0].member) - _e5028), (_e5015[1].member_1 - _e5015[0].member_1), _e4912);
                                                let _e5035 = (_e5015[0].member_1 + _e5032.member_1);
                                                if (_e5035 < _e5015[0].member_1) {
                                                    phi_7184_ = 1u;
                                                } else {
                                                    phi_7184_ = 0u;
                                                }
                                                let _e5038 = phi_7184_;
                                                if (_e5015[1].member_1 < _e5015[0].member_1) {
                                                    phi_7195_ = 1u;
                                                } else {
                                                    phi_7195_ = 0u;
                                                }
                                                let _e5051 = phi_7195_;
                                                let _e5055 = function_5(((_e5015[1].member - _e5015[0].member) - _e5051), (_e5015[1].member_1 - _e5015[0].member_1), _e4916);
                                                let _e5058 = (_e5015[0].member_1 + _e5055.member_1);
                                                if (_e5058 < _e5015[0].member_1) {
                                                    phi_7207_ = 1u;
                                                } else {
                                                    phi_7207_ = 0u;
                                                }
                                                let _e5061 = phi_7207_;
                                                if (_e5016[1].member_1 < _e5016[0].member_1) {
                                                    phi_7218_ = 1u;
                                                } else {
                                                    phi_7218_ = 0u;
                                                }
                                                let _e5074 = phi_7218_;
                                                let _e5078 = function_5(((_e5016[1].member - _e5016[0].member) - _e5074), (_e5016[1].member_1 - _e5016[0].member_1), _e4916);
                                                let _e5081 = (_e5016[0].member_1 + _e5078.member_1);
                                                if (_e5081 < _e5016[0].member_1) {
                                                    phi_7230_ = 1u;
                                                } else {
                                                    phi_7230_ = 0u;
                                                }
                                                let _e5084 = phi_7230_;
                                                if (_e5017[1].member_1 < _e5017[0].member_1) {
                                                    phi_7241_ = 1u;
                                                } else {
                                                    phi_7241_ = 0u;
                                                }
                                                let _e5097 = phi_7241_;
                                                let _e5101 = function_5(((_e5017[1].member - _e5017[0].member) - _e5097), (_e5017[1].member_1 - _e5017[0].member_1), _e4916);
                                                let _e5104 = (_e5017[0].member_1 + _e5101.member_1);
                                                if (_e5104 < _e5017[0].member_1) {
                                                    phi_7253_ = 1u;
                                                } else {
                                                    phi_7253_ = 0u;
                                                }
                                                let _e5107 = phi_7253_;
                                                phi_7264_ = array<type_9, 4>(type_9(((_e5015[0].member + _e5032.member) + _e5038), _e5035), type_9(((_e5015[0].member + _e5055.member) + _e5061), _e5058), type_9(((_e5016[0].member + _e5078.member) + _e5084), _e5081), type_9(((_e5017[0].member + _e5101.member) + _e5107), _e5104));
                                            } else {
                                                phi_7264_ = array<type_9, 4>();
                                            }
                                            let _e5116 = phi_7264_;
                                            phi_7265_ = _e5116;
                                            phi_7266_ = _e4902;
                                            phi_7267_ = _e4901;
                                            phi_7268_ = _e4908;
                                        } else {
                                            phi_7265_ = _e4870;
                                            phi_7266_ = _e4874;
                                            phi_7267_ = _e4876;
                                            phi_7268_ = true;
                                        }
                                        let _e5118 = phi_7265_;
                                        let _e5120 = phi_7266_;
                                        let _e5122 = phi_7267_;
                                        let _e5124 = phi_7268_;
                                        if _e5124 {
                                            phi_7272_ = false;
                                        } else {
                                            phi_7272_ = true;
                                        }
                                        let _e5126 = phi_7272_;
                                        phi_7273_ = _e5118;
                                        phi_7274_ = _e5120;
                                        phi_7275_ = _e5122;
                                        phi_7276_ = _e5124;
                                        phi_7277_ = _e5126;
                                        phi_7278_ = false;
                                    } else {
                                        phi_7273_ = array<type_9, 4>();
                                        phi_7274_ = u32();
                                        phi_7275_ = u32();
                                        phi_7276_ = false;
                                        phi_7277_ = false;
                                        phi_7278_ = true;
                                    }
                                    let _e5128 = phi_7273_;
                                    let _e5130 = phi_7274_;
                                    let _e5132 = phi_7275_;
                                    let _e5134 = phi_7276_;
                                    let _e5136 = phi_7277_;
                                    let _e5138 = phi_7278_;
                                    phi_7279_ = _e5128;
                                    phi_7281_ = _e5130;
                                    phi_7282_ = _e5132;
                                    phi_7283_ = _e4878;
                                    phi_7284_ = _e4880;
                                    phi_7285_ = _e4882;
                                    phi_7286_ = _e4884;
                                    phi_7287_ = _e5134;
                                    phi_7288_ = _e5136;
                                    phi_7289_ = _e5138;
                                }
                                let _e5140 = phi_7279_;
                                let _e5142 = phi_7281_;
                                let _e5144 = phi_7282_;
                                let _e5146 = phi_7283_;
                                let _e5148 = phi_7284_;
                                let _e5150 = phi_7285_;
                                let _e5152 = phi_7286_;
                                let _e5154 = phi_7287_;
                                let _e5156 = phi_7288_;
                                let _e5158 = phi_7289_;
                                phi_4566_ = _e5140;
                                phi_4570_ = _e5142;
                                phi_4572_ = _e5144;
                                phi_7290_ = _e3074;
                                phi_7291_ = _e5146;
                                phi_7292_ = _e5148;
                                phi_7293_ = _e5150;
                                phi_7294_ = _e5152;
                                phi_7295_ = _e5154;
                                phi_7296_ = _e3079;
                                phi_7297_ = false;
                                phi_7298_ = _e5156;
                                phi_7299_ = _e5158;
                            } else {
                                phi_4566_ = array<type_9, 4>();
                                phi_4570_ = u32();
                                phi_4572_ = u32();
                                phi_7290_ = u32();
                                phi_7291_ = bool();
                                phi_7292_ = bool();
                                phi_7293_ = u32();
                                phi_7294_ = u32();
                                phi_7295_ = false;
                                phi_7296_ = false;
                                phi_7297_ = true;
                                phi_7298_ = false;
                                phi_7299_ = false;
                            }
                            let _e5160 = phi_4566_;
                            let _e5162 = phi_4570_;
                            let _e5164 = phi_4572_;
                            let _e5166 = phi_7290_;
                            let _e5168 = phi_7291_;
                            let _e5170 = phi_7292_;
                            let _e5172 = phi_7293_;
                            let _e5174 = phi_7294_;
                            let _e5176 = phi_7295_;
                            let _e5178 = phi_7296_;
                            let _e5180 = phi_7297_;
                            let _e5182 = phi_7298_;
                            let _e5184 = phi_7299_;
                            local_62 = _e5178;
                            local_129 = _e5180;
                            local_130 = _e5182;
                            local_131 = _e5184;
                            local_132 = _e5178;
                            local_63 = _e5170;
                            local_64 = _e5172;
                            local_68 = _e5172;
                            local_69 = _e5172;
                            local_70 = _e5172;
                            local_71 = _e5172;
                            local_72 = _e5172;
                            local_73 = _e5172;
                            local_74 = _e5172;
                            local_75 = _e5172;
                            local_76 = _e5172;
                            local_77 = _e5172;
                            local_78 = _e5172;
                            local_79 = _e5172;
                            local_80 = _e5172;
                            local_133 = _e5168;
                            local_81 = _e5166;
                            local_82 = _e5172;
                            local_83 = _e5174;
                            local_84 = _e5166;
                            continue;
                            continuing {
                                phi_4562_ = _e3065;
                                phi_4565_ = _e5160;
                                phi_4569_ = _e5162;
                                phi_4571_ = _e5164;
                                break if !(_e5176);
                            }
                        }
                        let _e5187 = local_62;
                        if _e5187 {
                            phi_7304_ = type_9(0u, type_9().member_1);
                            phi_7305_ = false;
                            phi_7306_ = false;
                            phi_7307_ = false;
                        } else {
                            phi_7304_ = type_9();
                            let _e15805 = local_129;
                            phi_7305_ = _e15805;
                            let _e15808 = local_130;
                            phi_7306_ = _e15808;
                            let _e15811 = local_131;
                            phi_7307_ = _e15811;
                        }
                        let _e5191 = phi_7304_;
                        let _e5193 = phi_7305_;
                        let _e5195 = phi_7306_;
                        let _e5197 = phi_7307_;
                        if _e5193 {
                            phi_7312_ = type_9(2u, type_9().member_1);
                            phi_7313_ = false;
                            phi_7314_ = false;
                            phi_7315_ = false;
                        } else {
                            phi_7312_ = type_9();
                            phi_7313_ = _e5195;
                            phi_7314_ = _e5197;
                            let _e15817 = local_132;
                            phi_7315_ = _e15817;
                        }
                        let _e5201 = phi_7312_;
                        let _e5203 = phi_7313_;
                        let _e5205 = phi_7314_;
                        let _e5207 = phi_7315_;
                        if _e5203 {
                            phi_7320_ = type_9(0u, type_9().member_1);
                            phi_7321_ = false;
                            phi_7322_ = false;
                        } else {
                            phi_7320_ = type_9();
                            phi_7321_ = _e5205;
                            phi_7322_ = _e5207;
                        }
                        let _e5211 = phi_7320_;
                        let _e5213 = phi_7321_;
                        let _e5215 = phi_7322_;
                        if _e5213 {
                            let _e5217 = local_63;
                            if _e5217 {
                                let _e5219 = local_64;
                                if (_e5219 <= 2147483648u) {
                                    let _e5222 = local_65;
                                    let _e5226 = local_66;
                                    let _e5229 = function_11(128u);
                                    if ((_e5222[0].member >> bitcast<u32>(31i)) != 0u) {
                                        if (_e5226[0].member_1 == 0u) {
                                            phi_7347_ = 1u;
                                        } else {
                                            phi_7347_ = 0u;
                                        }
                                        let _e5240 = phi_7347_;
                                        phi_7354_ = type_9((~(_e5222[0].member) + _e5240), (~(_e5226[0].member_1) + 1u));
                                    } else {
                                        let _e5236 = local_67;
                                        phi_7354_ = _e5236[0];
                                    }
                                    let _e5247 = phi_7354_;
                                    if (_e5229.member_1 < _e5247.member_1) {
                                        phi_7361_ = 1u;
                                    } else {
                                        phi_7361_ = 0u;
                                    }
                                    let _e5252 = phi_7361_;
                                    if ((((_e5229.member - _e5247.member) - _e5252) >> bitcast<u32>(31i)) != 0u) {
                                        if ((_e5222[0].member >> bitcast<u32>(31i)) != 0u) {
                                            phi_7374_ = 2u;
                                        } else {
                                            phi_7374_ = 1u;
                                        }
                                        let _e5262 = phi_7374_;
                                        phi_7375_ = _e5262;
                                    } else {
                                        phi_7375_ = 0u;
                                    }
                                    let _e5264 = phi_7375_;
                                    if (_e2922 < _e2849.member_1) {
                                        phi_7384_ = 1u;
                                    } else {
                                        phi_7384_ = 0u;
                                    }
                                    let _e5267 = phi_7384_;
                                    let _e5272 = local_68;
                                    let _e5273 = function_5(((_e2927 - _e2849.member) - _e5267), (_e2922 - _e2849.member_1), _e5272);
                                    let _e5276 = (_e2849.member_1 + _e5273.member_1);
                                    if (_e5276 < _e2849.member_1) {
                                        phi_7396_ = 1u;
                                    } else {
                                        phi_7396_ = 0u;
                                    }
                                    let _e5279 = phi_7396_;
                                    if (_e2998 < _e2922) {
                                        phi_7407_ = 1u;
                                    } else {
                                        phi_7407_ = 0u;
                                    }
                                    let _e5284 = phi_7407_;
                                    let _e5289 = local_69;
                                    let _e5290 = function_5(((_e3003 - _e2927) - _e5284), (_e2998 - _e2922), _e5289);
                                    let _e5293 = (_e2922 + _e5290.member_1);
                                    if (_e5293 < _e2922) {
                                        phi_7419_ = 1u;
                                    } else {
                                        phi_7419_ = 0u;
                                    }
                                    let _e5296 = phi_7419_;
                                    if (_e3039.member_1 < _e2998) {
                                        phi_7430_ = 1u;
                                    } else {
                                        phi_7430_ = 0u;
                                    }
                                    let _e5301 = phi_7430_;
                                    let _e5306 = local_70;
                                    let _e5307 = function_5(((_e3039.member - _e3003) - _e5301), (_e3039.member_1 - _e2998), _e5306);
                                    let _e5310 = (_e2998 + _e5307.member_1);
                                    if (_e5310 < _e2998) {
                                        phi_7442_ = 1u;
                                    } else {
                                        phi_7442_ = 0u;
                                    }
                                    let _e5313 = phi_7442_;
                                    let _e5319 = array<type_9, 3>(type_9(((_e2849.member + _e5273.member) + _e5279), _e5276), type_9(((_e2927 + _e5290.member) + _e5296), _e5293), type_9(((_e3003 + _e5307.member) + _e5313), _e5310));
                                    if (_e2922 < _e2849.member_1) {
                                        phi_7459_ = 1u;
                                    } else {
                                        phi_7459_ = 0u;
                                    }
                                    let _e5322 = phi_7459_;
                                    let _e5327 = local_71;
                                    let _e5328 = function_5(((_e2927 - _e2849.member) - _e5322), (_e2922 - _e2849.member_1), _e5327);
                                    let _e5331 = (_e2849.member_1 + _e5328.member_1);
                                    if (_e5331 < _e2849.member_1) {
                                        phi_7471_ = 1u;
                                    } else {
                                        phi_7471_ = 0u;
                                    }
                                    let _e5334 = phi_7471_;
                                    if (_e2998 < _e2922) {
                                        phi_7482_ = 1u;
                                    } else {
                                        phi_7482_ = 0u;
                                    }
                                    let _e5339 = phi_7482_;
                                    let _e5344 = local_72;
                                    let _e5345 = function_5(((_e3003 - _e2927) - _e5339), (_e2998 - _e2922), _e5344);
                                    let _e5348 = (_e2922 + _e5345.member_1);
                                    if (_e5348 < _e2922) {
                                        phi_7494_ = 1u;
                                    } else {
                                        phi_7494_ = 0u;
                                    }
                                    let _e5351 = phi_7494_;
                                    if (_e3039.member_1 < _e2998) {
                                        phi_7505_ = 1u;
                                    } else {
                                        phi_7505_ = 0u;
                                    }
                                    let _e5356 = phi_7505_;
                                    let _e5361 = local_73;
                                    let _e5362 = function_5(((_e3039.member - _e3003) - _e5356), (_e3039.member_1 - _e2998), _e5361);
                                    let _e5365 = (_e2998 + _e5362.member_1);
                                    if (_e5365 < _e2998) {
                                        phi_7517_ = 1u;
                                    } else {
                                        phi_7517_ = 0u;
                                    }
                                    let _e5368 = phi_7517_;
                                    let _e5376 = local_74;
                                    let _e5377 = function_6(_e5319, _e5376);
                                    let _e5379 = local_75;
                                    let _e5380 = function_6(_e5319, _e5379);
                                    let _e5382 = local_76;
                                    let _e5383 = function_6(array<type_9, 3>(type_9(((_e2849.member + _e5328.member) + _e5334), _e5331), type_9(((_e2927 + _e5345.member) + _e5351), _e5348), type_9(((_e3003 + _e5362.member) + _e5368), _e5365)), _e5382);
                                    if (_e5377[1].member_1 < _e5377[0].member_1) {
                                        phi_7537_ = 1u;
                                    } else {
                                        phi_7537_ = 0u;
                                    }
                                    let _e5394 = phi_7537_;
                                    let _e5399 = local_77;
                                    let _e5400 = function_5(((_e5377[1].member - _e5377[0].member) - _e5394), (_e5377[1].member_1 - _e5377[0].member_1), _e5399);
                                    let _e5403 = (_e5377[0].member_1 + _e5400.member_1);
                                    if (_e5403 < _e5377[0].member_1) {
                                        phi_7549_ = 1u;
                                    } else {
                                        phi_7549_ = 0u;
                                    }
                                    let _e5406 = phi_7549_;
                                    let _e5408 = ((_e5377[0].member + _e5400.member) + _e5406);
                                    if (_e5377[1].member_1 < _e5377[0].member_1) {
                                        phi_7560_ = 1u;
                                    } else {
                                        phi_7560_ = 0u;
                                    }
                                    let _e5419 = phi_7560_;
                                    let _e5424 = local_78;
                                    let _e5425 = function_5(((_e5377[1].member - _e5377[0].member) - _e5419), (_e5377[1].member_1 - _e5377[0].member_1), _e5424);
                                    if (_e5380[1].member_1 < _e5380[0].member_1) {
                                        phi_7583_ = 1u;
                                    } else {
                                        phi_7583_ = 0u;
                                    }
                                    let _e5436 = phi_7583_;
                                    let _e5441 = local_79;
                                    let _e5442 = function_5(((_e5380[1].member - _e5380[0].member) - _e5436), (_e5380[1].member_1 - _e5380[0].member_1), _e5441);
                                    if (_e5383[1].member_1 < _e5383[0].member_1) {
                                        phi_7606_ = 1u;
                                    } else {
                                        phi_7606_ = 0u;
                                    }
                                    let _e5453 = phi_7606_;
                                    let _e5458 = local_80;
                                    let _e5459 = function_5(((_e5383[1].member - _e5383[0].member) - _e5453), (_e5383[1].member_1 - _e5383[0].member_1), _e5458);
                                    let _e5460 = function_11(128u);
                                    if ((_e5408 >> bitcast<u32>(31i)) != 0u) {
                                        if (_e5403 == 0u) {
                                            phi_7643_ = 1u;
                                        } else {
                                            phi_7643_ = 0u;
                                        }
                                        let _e5469 = phi_7643_;
                                        phi_7650_ = type_9((~(_e5408) + _e5469), (~(_e5403) + 1u));
                                    } else {
                                        phi_7650_ = type_9(_e5408, _e5403);
                                    }
                                    let _e5476 = phi_7650_;
                                    if (_e5460.member_1 < _e5476.member_1) {
                                        phi_7657_ = 1u;
                                    } else {
                                        phi_7657_ = 0u;
                                    }
                                    let _e5481 = phi_7657_;
                                    if ((((_e5460.member - _e5476.member) - _e5481) >> bitcast<u32>(31i)) != 0u) {
                                        if ((_e5408 >> bitcast<u32>(31i)) != 0u) {
                                            phi_7670_ = 2u;
                                        } else {
                                            phi_7670_ = 1u;
                                        }
                                        let _e5491 = phi_7670_;
                                        phi_7671_ = _e5491;
                                    } else {
                                        phi_7671_ = 0u;
                                    }
                                    let _e5493 = phi_7671_;
                                    phi_7674_ = ((_e5264 | _e5493) == 3u);
                                    phi_7675_ = false;
                                } else {
                                    phi_7674_ = bool();
                                    phi_7675_ = true;
                                }
                                let _e5497 = phi_7674_;
                                let _e5499 = phi_7675_;
                                phi_7676_ = _e5497;
                                phi_7677_ = _e5499;
                            } else {
                                phi_7676_ = bool();
                                phi_7677_ = true;
                            }
                            let _e5501 = phi_7676_;
                            let _e5503 = phi_7677_;
                            if _e5503 {
                                let _e15872 = local_133;
                                phi_7681_ = _e15872;
                            } else {
                                phi_7681_ = _e5501;
                            }
                            let _e5505 = phi_7681_;
                            let _e5507 = local_81;
                            if (_e5507 >= _e1468) {
                                let _e5510 = local_82;
                                phi_7687_ = (_e5510 <= _e1470);
                            } else {
                                phi_7687_ = false;
                            }
                            let _e5513 = phi_7687_;
                            if _e5505 {
                                if _e5513 {
                                    let _e5515 = local_83;
                                    phi_7695_ = (_e5515 == 0u);
                                    phi_7696_ = false;
                                } else {
                                    phi_7695_ = bool();
                                    phi_7696_ = true;
                                }
                                let _e5518 = phi_7695_;
                                let _e5520 = phi_7696_;
                                phi_7697_ = _e5518;
                                phi_7698_ = _e5520;
                            } else {
                                phi_7697_ = bool();
                                phi_7698_ = true;
                            }
                            let _e5522 = phi_7697_;
                            let _e5524 = phi_7698_;
                            if _e5524 {
                                phi_7702_ = false;
                            } else {
                                phi_7702_ = _e5522;
                            }
                            let _e5526 = phi_7702_;
                            if _e5526 {
                                let _e5530 = local_84;
                                phi_7708_ = type_9(1u, _e5530);
                            } else {
                                phi_7708_ = type_9(2u, type_9().member_1);
                            }
                            let _e5533 = phi_7708_;
                            phi_7709_ = _e5533;
                            phi_7710_ = true;
                            phi_7711_ = false;
                        } else {
                            phi_7709_ = _e5211;
                            phi_7710_ = _e5203;
                            phi_7711_ = _e5215;
                        }
                        let _e5535 = phi_7709_;
                        let _e5537 = phi_7710_;
                        let _e5539 = phi_7711_;
                        if _e5537 {
                            phi_7715_ = _e5535;
                            phi_7716_ = true;
                        } else {
                            phi_7715_ = _e5191;
                            phi_7716_ = _e5539;
                        }
                        let _e5541 = phi_7715_;
                        let _e5543 = phi_7716_;
                        if _e5543 {
                            phi_7720_ = _e5541;
                        } else {
                            phi_7720_ = _e5201;
                        }
                        let _e5545 = phi_7720_;
                        switch bitcast<i32>(_e5545.member) {
                            case 0: {
                                phi_7757_ = type_29(0u, 0u, array<u32, 2>(0u, 0u), false);
                                break;
                            }
                            case 1: {
                                if (_e5545.member_1 > _e1468) {
                                    phi_7733_ = 1u;
                                } else {
                                    phi_7733_ = 0u;
                                }
                                let _e5551 = phi_7733_;
                                if (_e5545.member_1 == 0u) {
                                    phi_7751_ = array<u32, 2>(0u, 0u);
                                } else {
                                    let _e5557 = select((bitcast<u32>(31i) - firstLeadingBit(_e5545.member_1)), 32u, (_e5545.member_1 == 0u));
                                    let _e5562 = ((_e5545.member_1 << bitcast<u32>((_e5557 & 31u))) << bitcast<u32>(1i));
                                    phi_7751_ = array<u32, 2>((_e5562 << bitcast<u32>(20i)), (((1023u - _e5557) << bitcast<u32>(20i)) | (_e5562 >> bitcast<u32>(12i))));
                                }
                                let _e5573 = phi_7751_;
                                phi_7757_ = type_29(0u, _e5551, _e5573, true);
                                break;
                            }
                            case 2: {
                                phi_7757_ = type_29(1u, 0u, array<u32, 2>(0u, 0u), true);
                                break;
                            }
                            default: {
                                phi_7757_ = type_29();
                                break;
                            }
                        }
                        let _e5576 = phi_7757_;
                        if (_e5576.member == 0u) {
                            phi_7763_ = false;
                        } else {
                            phi_7763_ = true;
                        }
                        let _e5580 = phi_7763_;
                        phi_7764_ = _e5576;
                        phi_7765_ = _e5580;
                    } else {
                        phi_7764_ = type_29();
                        phi_7765_ = true;
                    }
                    let _e5582 = phi_7764_;
                    let _e5584 = phi_7765_;
                    phi_7766_ = _e5582;
                    phi_7767_ = _e5584;
                } else {
                    phi_7766_ = type_29();
                    phi_7767_ = true;
                }
                let _e5586 = phi_7766_;
                let _e5588 = phi_7767_;
                if _e5588 {
                    let _e5590 = params.member.member.member_12;
                    let _e5591 = bitcast<u32>(_e5590);
                    let _e5592 = (_e5591 & 2147483647u);
                    if (_e5592 < 8388608u) {
                        phi_7785_ = array<u32, 2>(0u, 0u);
                    } else {
                        phi_7785_ = array<u32, 2>((_e5591 << bitcast<u32>(29i)), ((_e5591 ^ _e5592) | ((_e5592 >> bitcast<u32>(3i)) + 939524096u)));
                    }
                    let _e5603 = phi_7785_;
                    let _e5607 = params.member.member.member_15[0u];
                    if (_e5603[0] == _e5607) {
                        let _e5612 = params.member.member.member_15[1u];
                        phi_7799_ = (_e5603[1] == _e5612);
                    } else {
                        phi_7799_ = false;
                    }
                    let _e5615 = phi_7799_;
                    let _e5617 = params.member.member.member_5;
                    let _e5619 = params.member.member.member_11;
                    let _e5621 = params.member.member.member_12;
                    let _e5623 = params.member.member.member_13;
                    let _e5625 = params.member.member.member_1;
                    if ((_e5625 & 64u) != 0u) {
                        phi_7815_ = _e5615;
                    } else {
                        phi_7815_ = false;
                    }
                    let _e5629 = phi_7815_;
                    if (_e577.member[0][0] < 0f) {
                        phi_7823_ = -(_e577.member[0][0]);
                    } else {
                        phi_7823_ = _e577.member[0][0];
                    }
                    let _e5636 = phi_7823_;
                    if (_e577.member[0][1] < 0f) {
                        phi_7830_ = -(_e577.member[0][1]);
                    } else {
                        phi_7830_ = _e577.member[0][1];
                    }
                    let _e5641 = phi_7830_;
                    if (_e5636 > _e5641) {
                        phi_7835_ = _e5636;
                    } else {
                        phi_7835_ = _e5641;
                    }
                    let _e5644 = phi_7835_;
                    if (_e577.member[0][2] < 0f) {
                        phi_7842_ = -(_e577.member[0][2]);
                    } else {
                        phi_7842_ = _e577.member[0][2];
                    }
                    let _e5649 = phi_7842_;
                    if (_e5644 > _e5649) {
                        phi_7847_ = _e5644;
                    } else {
                        phi_7847_ = _e5649;
                    }
                    let _e5652 = phi_7847_;
                    if (_e577.member[1][0] < 0f) {
                        phi_7855_ = -(_e577.member[1][0]);
                    } else {
                        phi_7855_ = _e577.member[1][0];
                    }
                    let _e5659 = phi_7855_;
                    if (_e577.member[1][1] < 0f) {
                        phi_7862_ = -(_e577.member[1][1]);
                    } else {
                        phi_7862_ = _e577.member[1][1];
                    }
                    let _e5664 = phi_7862_;
                    if (_e5659 > _e5664) {
                        phi_7867_ = _e5659;
                    } else {
                        phi_7867_ = _e5664;
                    }
                    let _e5667 = phi_7867_;
                    if (_e577.member[1][2] < 0f) {
                        phi_7874_ = -(_e577.member[1][2]);
                    } else {
                        phi_7874_ = _e577.member[1][2];
                    }
                    let _e5672 = phi_7874_;
                    if (_e5667 > _e5672) {
                        phi_7879_ = _e5667;
                    } else {
                        phi_7879_ = _e5672;
                    }
                    let _e5675 = phi_7879_;
                    if (_e5652 > _e5675) {
                        phi_7884_ = _e5652;
                    } else {
                        phi_7884_ = _e5675;
                    }
                    let _e5678 = phi_7884_;
                    let _e5680 = (_e5678 + _e577.member_3);
                    if (_e577.member_1[0][0] < 0f) {
                        phi_7894_ = -(_e577.member_1[0][0]);
                    } else {
                        phi_7894_ = _e577.member_1[0][0];
                    }
                    let _e5687 = phi_7894_;
                    if (_e577.member_1[0][1] < 0f) {
                        phi_7901_ = -(_e577.member_1[0][1]);
                    } else {
                        phi_7901_ = _e577.member_1[0][1];
                    }
                    let _e5692 = phi_7901_;
                    if (_e5687 > _e5692) {
                        phi_7906_ = _e5687;
                    } else {
                        phi_7906_ = _e5692;
                    }
                    let _e5695 = phi_7906_;
                    if (_e577.member_1[0][2] < 0f) {
                        phi_7913_ = -(_e577.member_1[0][2]);
                    } else {
                        phi_7913_ = _e577.member_1[0][2];
                    }
                    let _e5700 = phi_7913_;
                    if (_e5695 > _e5700) {
                        phi_7918_ = _e5695;
                    } else {
                        phi_7918_ = _e5700;
                    }
                    let _e5703 = phi_7918_;
                    if (_e577.member_1[1][0] < 0f) {
                        phi_7926_ = -(_e577.member_1[1][0]);
                    } else {
                        phi_7926_ = _e577.member_1[1][0];
                    }
                    let _e5710 = phi_7926_;
                    if (_e577.member_1[1][1] < 0f) {
                        phi_7933_ = -(_e577.member_1[1][1]);
                    } else {
                        phi_7933_ = _e577.member_1[1][1];
                    }
                    let _e5715 = phi_7933_;
                    if (_e5710 > _e5715) {
                        phi_7938_ = _e5710;
                    } else {
                        phi_7938_ = _e5715;
                    }
                    let _e5718 = phi_7938_;
                    if (_e577.member_1[1][2] < 0f) {
                        phi_7945_ = -(_e577.member_1[1][2]);
                    } else {
                        phi_7945_ = _e577.member_1[1][2];
                    }
                    let _e5723 = phi_7945_;
                    if (_e5718 > _e5723) {
                        phi_7950_ = _e5718;
                    } else {
                        phi_7950_ = _e5723;
                    }
                    let _e5726 = phi_7950_;
                    if (_e5703 > _e5726) {
                        phi_7955_ = _e5703;
                    } else {
                        phi_7955_ = _e5726;
                    }
                    let _e5729 = phi_7955_;
                    let _e5731 = (_e5729 + _e577.member_3);
                    if (_e577.member_2[0][0] < 0f) {
                        phi_7965_ = -(_e577.member_2[0][0]);
                    } else {
                        phi_7965_ = _e577.member_2[0][0];
                    }
                    let _e5738 = phi_7965_;
                    if (_e577.member_2[0][1] < 0f) {
                        phi_7972_ = -(_e577.member_2[0][1]);
                    } else {
                        phi_7972_ = _e577.member_2[0][1];
                    }
                    let _e5743 = phi_7972_;
                    if (_e5738 > _e5743) {
                        phi_7977_ = _e5738;
                    } else {
                        phi_7977_ = _e5743;
                    }
                    let _e5746 = phi_7977_;
                    if (_e577.member_2[0][2] < 0f) {
                        phi_7984_ = -(_e577.member_2[0][2]);
                    } else {
                        phi_7984_ = _e577.member_2[0][2];
                    }
                    let _e5751 = phi_7984_;
                    if (_e5746 > _e5751) {
                        phi_7989_ = _e5746;
                    } else {
                        phi_7989_ = _e5751;
                    }
                    let _e5754 = phi_7989_;
                    if (_e577.member_2[1][0] < 0f) {
                        phi_7997_ = -(_e577.member_2[1][0]);
                    } else {
                        phi_7997_ = _e577.member_2[1][0];
                    }
                    let _e5761 = phi_7997_;
                    if (_e577.member_2[1][1] < 0f) {
                        phi_8004_ = -(_e577.member_2[1][1]);
                    } else {
                        phi_8004_ = _e577.member_2[1][1];
                    }
                    let _e5766 = phi_8004_;
                    if (_e5761 > _e5766) {
                        phi_8009_ = _e5761;
                    } else {
                        phi_8009_ = _e5766;
                    }
                    let _e5769 = phi_8009_;
                    if (_e577.member_2[1][2] < 0f) {
                        phi_8016_ = -(_e577.member_2[1][2]);
                    } else {
                        phi_8016_ = _e577.member_2[1][2];
                    }
                    let _e5774 = phi_8016_;
                    if (_e5769 > _e5774) {
                        phi_8021_ = _e5769;
                    } else {
                        phi_8021_ = _e5774;
                    }
                    let _e5777 = phi_8021_;
                    if (_e5754 > _e5777) {
                        phi_8026_ = _e5754;
                    } else {
                        phi_8026_ = _e5777;
                    }
                    let _e5780 = phi_8026_;
                    let _e5782 = (_e5780 + _e577.member_3);
                    if (_e5680 > _e5731) {
                        phi_8033_ = _e5680;
                    } else {
                        phi_8033_ = _e5731;
                    }
                    let _e5785 = phi_8033_;
                    if (_e5785 > _e5782) {
                        phi_8038_ = _e5785;
                    } else {
                        phi_8038_ = _e5782;
                    }
                    let _e5788 = phi_8038_;
                    if (_e5788 <= 65536f) {
                        phi_8045_ = (_e5788 >= (1f / 65536f));
                    } else {
                        phi_8045_ = false;
                    }
                    let _e5793 = phi_8045_;
                    if _e5793 {
                        phi_8143_ = type_44();
                        phi_8144_ = true;
                    } else {
                        if (_e5788 >= 0.000000000000000000000000000000000000011754944f) {
                            if ((bitcast<u32>(_e5788) & 2139095040u) != 2139095040u) {
                                let _e5800 = (2130706432u - (bitcast<u32>(_e5788) & 2139095040u));
                                if (_e5800 > 8388608u) {
                                    phi_8069_ = _e5800;
                                } else {
                                    phi_8069_ = 8388608u;
                                }
                                let _e5803 = phi_8069_;
                                let _e5804 = bitcast<f32>(_e5803);
                                let _e5805 = (_e5617 * _e5804);
                                if (_e5617 > 0f) {
                                    if (_e5805 > 0.000000000000000000000000000000000000011754944f) {
                                        phi_8080_ = _e5805;
                                    } else {
                                        phi_8080_ = 0.000000000000000000000000000000000000011754944f;
                                    }
                                    let _e5809 = phi_8080_;
                                    phi_8081_ = _e5809;
                                } else {
                                    phi_8081_ = _e5805;
                                }
                                let _e5811 = phi_8081_;
                                phi_8139_ = type_44(type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e577.member[0][0] * _e5804), (_e577.member[0][1] * _e5804), (_e577.member[0][2] * _e5804)), array<f32, 3>((_e577.member[1][0] * _e5804), (_e577.member[1][1] * _e5804), (_e577.member[1][2] * _e5804))), array<array<f32, 3>, 2>(array<f32, 3>((_e577.member_1[0][0] * _e5804), (_e577.member_1[0][1] * _e5804), (_e577.member_1[0][2] * _e5804)), array<f32, 3>((_e577.member_1[1][0] * _e5804), (_e577.member_1[1][1] * _e5804), (_e577.member_1[1][2] * _e5804))), array<array<f32, 3>, 2>(array<f32, 3>((_e577.member_2[0][0] * _e5804), (_e577.member_2[0][1] * _e5804), (_e577.member_2[0][2] * _e5804)), array<f32, 3>((_e577.member_2[1][0] * _e5804), (_e577.member_2[1][1] * _e5804), (_e577.member_2[1][2] * _e5804))), ((_e577.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e5804)), _e5811);
                                phi_8140_ = false;
                            } else {
                                phi_8139_ = type_44();
                                phi_8140_ = true;
                            }
                            let _e5876 = phi_8139_;
                            let _e5878 = phi_8140_;
                            phi_8141_ = _e5876;
                            phi_8142_ = _e5878;
                        } else {
                            phi_8141_ = type_44();
                            phi_8142_ = true;
                        }
                        let _e5880 = phi_8141_;
                        let _e5882 = phi_8142_;
                        phi_8143_ = _e5880;
                        phi_8144_ = _e5882;
                    }
                    let _e5884 = phi_8143_;
                    let _e5886 = phi_8144_;
                    if _e5886 {
                        phi_8149_ = type_44(_e577, _e5617);
                    } else {
                        phi_8149_ = _e5884;
                    }
                    let _e5889 = phi_8149_;
                    local_18 = type_28(array<array<f32, 3>, 2>(array<f32, 3>(_e5889.member.member[0][0], _e5889.member.member[0][1], _e5889.member.member[0][2]), array<f32, 3>(_e5889.member.member[1][0], _e5889.member.member[1][1], _e5889.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e5889.member.member_1[0][0], _e5889.member.member_1[0][1], _e5889.member.member_1[0][2]), array<f32, 3>(_e5889.member.member_1[1][0], _e5889.member.member_1[1][1], _e5889.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e5889.member.member_2[0][0], _e5889.member.member_2[0][1], _e5889.member.member_2[0][2]), array<f32, 3>(_e5889.member.member_2[1][0], _e5889.member.member_2[1][1], _e5889.member.member_2[1][2])), _e5889.member.member_3);
                    if (_e5889.member_1 > 0f) {
                        let _e10654 = local_18.member[0u];
                        let _e10660 = local_18.member[1u];
                        let _e10676 = local_18.member_1[0u];
                        let _e10682 = local_18.member_1[1u];
                        let _e10698 = local_18.member_2[0u];
                        let _e10704 = local_18.member_2[1u];
                        let _e10718 = function_4(array<f32, 3>((_e10654[0] + ((_e10660[0] - _e10654[0]) * _e5621)), (_e10654[1] + ((_e10660[1] - _e10654[1]) * _e5621)), (_e10654[2] + ((_e10660[2] - _e10654[2]) * _e5621))), array<f32, 3>((_e10676[0] + ((_e10682[0] - _e10676[0]) * _e5621)), (_e10676[1] + ((_e10682[1] - _e10676[1]) * _e5621)), (_e10676[2] + ((_e10682[2] - _e10676[2]) * _e5621))), array<f32, 3>((_e10698[0] + ((_e10704[0] - _e10698[0]) * _e5621)), (_e10698[1] + ((_e10704[1] - _e10698[1]) * _e5621)), (_e10698[2] + ((_e10704[2] - _e10698[2]) * _e5621))), _e316.member);
                        let _e10729 = (((_e10718[0] * _e10718[0]) + (_e10718[1] * _e10718[1])) + (_e10718[2] * _e10718[2]));
                        if (_e10729 <= 0.000000000000000000000000000000000000011754944f) {
                            if (_e10729 > 0f) {
                                phi_8316_ = (0.000000000000000000106433627f * 2f);
                            } else {
                                phi_8316_ = 0f;
                            }
                            let _e10782 = phi_8316_;
                            phi_8380_ = _e10782;
                        } else {
                            phi_8323_ = type_14(0i, 5i);
                            phi_8326_ = bitcast<f32>(((bitcast<u32>(_e10729) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e10737 = phi_8323_;
                                let _e10739 = phi_8326_;
                                local_105 = _e10739;
                                if (_e10737.member < _e10737.member_1) {
                                    let _e10746 = (_e10737.member + 1i);
                                    if ((false == (_e10746 > _e10737.member)) != false) {
                                        phi_8347_ = true;
                                    } else {
                                        phi_8347_ = false;
                                    }
                                    let _e10751 = phi_8347_;
                                    if _e10751 {
                                        phi_8353_ = type_15(0u, type_15().member_1);
                                    } else {
                                        phi_8353_ = type_15(1u, _e10746);
                                    }
                                    let _e10756 = phi_8353_;
                                    phi_8324_ = type_14(_e10756.member_1, _e10737.member_1);
                                    phi_8367_ = type_15(1u, _e10737.member);
                                } else {
                                    phi_8324_ = _e10737;
                                    phi_8367_ = type_15(0u, type_15().member_1);
                                }
                                let _e10762 = phi_8324_;
                                let _e10764 = phi_8367_;
                                let _e10767 = (bitcast<i32>(_e10764.member) != 0i);
                                if _e10767 {
                                    phi_8327_ = (0.5f * (_e10739 + (_e10729 / _e10739)));
                                } else {
                                    phi_8327_ = f32();
                                }
                                let _e10772 = phi_8327_;
                                continue;
                                continuing {
                                    phi_8323_ = _e10762;
                                    phi_8326_ = _e10772;
                                    break if !(_e10767);
                                }
                            }
                            let _e10777 = local_105;
                            phi_8380_ = (_e10777 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e10784 = phi_8380_;
                        let _e10790 = local_18.member[0u];
                        if (_e10790[0] < 0f) {
                            phi_8396_ = -(_e10790[0]);
                        } else {
                            phi_8396_ = _e10790[0];
                        }
                        let _e10797 = phi_8396_;
                        if (_e10790[1] < 0f) {
                            phi_8403_ = -(_e10790[1]);
                        } else {
                            phi_8403_ = _e10790[1];
                        }
                        let _e10801 = phi_8403_;
                        if (_e10797 > _e10801) {
                            phi_8408_ = _e10797;
                        } else {
                            phi_8408_ = _e10801;
                        }
                        let _e10804 = phi_8408_;
                        if (_e10790[2] < 0f) {
                            phi_8415_ = -(_e10790[2]);
                        } else {
                            phi_8415_ = _e10790[2];
                        }
                        let _e10808 = phi_8415_;
                        if (_e10804 > _e10808) {
                            phi_8420_ = _e10804;
                        } else {
                            phi_8420_ = _e10808;
                        }
                        let _e10811 = phi_8420_;
                        let _e10814 = local_18.member[1u];
                        if (_e10814[0] < 0f) {
                            phi_8433_ = -(_e10814[0]);
                        } else {
                            phi_8433_ = _e10814[0];
                        }
                        let _e10821 = phi_8433_;
                        if (_e10814[1] < 0f) {
                            phi_8440_ = -(_e10814[1]);
                        } else {
                            phi_8440_ = _e10814[1];
                        }
                        let _e10825 = phi_8440_;
                        if (_e10821 > _e10825) {
                            phi_8445_ = _e10821;
                        } else {
                            phi_8445_ = _e10825;
                        }
                        let _e10828 = phi_8445_;
                        if (_e10814[2] < 0f) {
                            phi_8452_ = -(_e10814[2]);
                        } else {
                            phi_8452_ = _e10814[2];
                        }
                        let _e10832 = phi_8452_;
                        if (_e10828 > _e10832) {
                            phi_8457_ = _e10828;
                        } else {
                            phi_8457_ = _e10832;
                        }
                        let _e10835 = phi_8457_;
                        if (_e10811 > _e10835) {
                            phi_8462_ = _e10811;
                        } else {
                            phi_8462_ = _e10835;
                        }
                        let _e10838 = phi_8462_;
                        let _e10840 = local_18.member_3;
                        let _e10844 = local_18.member_1[0u];
                        if (_e10844[0] < 0f) {
                            phi_8479_ = -(_e10844[0]);
                        } else {
                            phi_8479_ = _e10844[0];
                        }
                        let _e10851 = phi_8479_;
                        if (_e10844[1] < 0f) {
                            phi_8486_ = -(_e10844[1]);
                        } else {
                            phi_8486_ = _e10844[1];
                        }
                        let _e10855 = phi_8486_;
                        if (_e10851 > _e10855) {
                            phi_8491_ = _e10851;
                        } else {
                            phi_8491_ = _e10855;
                        }
                        let _e10858 = phi_8491_;
                        if (_e10844[2] < 0f) {
                            phi_8498_ = -(_e10844[2]);
                        } else {
                            phi_8498_ = _e10844[2];
                        }
                        let _e10862 = phi_8498_;
                        if (_e10858 > _e10862) {
                            phi_8503_ = _e10858;
                        } else {
                            phi_8503_ = _e10862;
                        }
                        let _e10865 = phi_8503_;
                        let _e10868 = local_18.member_1[1u];
                        if (_e10868[0] < 0f) {
                            phi_8517_ = -(_e10868[0]);
                        } else {
                            phi_8517_ = _e10868[0];
                        }
                        let _e10875 = phi_8517_;
                        if (_e10868[1] < 0f) {
                            phi_8524_ = -(_e10868[1]);
                        } else {
                            phi_8524_ = _e10868[1];
                        }
                        let _e10879 = phi_8524_;
                        if (_e10875 > _e10879) {
                            phi_8529_ = _e10875;
                        } else {
                            phi_8529_ = _e10879;
                        }
                        let _e10882 = phi_8529_;
                        if (_e10868[2] < 0f) {
                            phi_8536_ = -(_e10868[2]);
                        } else {
                            phi_8536_ = _e10868[2];
                        }
                        let _e10886 = phi_8536_;
                        if (_e10882 > _e10886) {
                            phi_8541_ = _e10882;
                        } else {
                            phi_8541_ = _e10886;
                        }
                        let _e10889 = phi_8541_;
                        if (_e10865 > _e10889) {
                            phi_8546_ = _e10865;
                        } else {
                            phi_8546_ = _e10889;
                        }
                        let _e10892 = phi_8546_;
                        let _e10894 = local_18.member_3;
                        let _e10898 = local_18.member_2[0u];
                        if (_e10898[0] < 0f) {
                            phi_8563_ = -(_e10898[0]);
                        } else {
                            phi_8563_ = _e10898[0];
                        }
                        let _e10905 = phi_8563_;
                        if (_e10898[1] < 0f) {
                            phi_8570_ = -(_e10898[1]);
                        } else {
                            phi_8570_ = _e10898[1];
                        }
                        let _e10909 = phi_8570_;
                        if (_e10905 > _e10909) {
                            phi_8575_ = _e10905;
                        } else {
                            phi_8575_ = _e10909;
                        }
                        let _e10912 = phi_8575_;
                        if (_e10898[2] < 0f) {
                            phi_8582_ = -(_e10898[2]);
                        } else {
                            phi_8582_ = _e10898[2];
                        }
                        let _e10916 = phi_8582_;
                        if (_e10912 > _e10916) {
                            phi_8587_ = _e10912;
                        } else {
                            phi_8587_ = _e10916;
                        }
                        let _e10919 = phi_8587_;
                        let _e10922 = local_18.member_2[1u];
                        if (_e10922[0] < 0f) {
                            phi_8601_ = -(_e10922[0]);
                        } else {
                            phi_8601_ = _e10922[0];
                        }
                        let _e10929 = phi_8601_;
                        if (_e10922[1] < 0f) {
                            phi_8608_ = -(_e10922[1]);
                        } else {
                            phi_8608_ = _e10922[1];
                        }
                        let _e10933 = phi_8608_;
                        if (_e10929 > _e10933) {
                            phi_8613_ = _e10929;
                        } else {
                            phi_8613_ = _e10933;
                        }
                        let _e10936 = phi_8613_;
                        if (_e10922[2] < 0f) {
                            phi_8620_ = -(_e10922[2]);
                        } else {
                            phi_8620_ = _e10922[2];
                        }
                        let _e10940 = phi_8620_;
                        if (_e10936 > _e10940) {
                            phi_8625_ = _e10936;
                        } else {
                            phi_8625_ = _e10940;
                        }
                        let _e10943 = phi_8625_;
                        if (_e10919 > _e10943) {
                            phi_8630_ = _e10919;
                        } else {
                            phi_8630_ = _e10943;
                        }
                        let _e10946 = phi_8630_;
                        let _e10948 = local_18.member_3;
                        let _e10955 = local_18.member_3;
                        let _e10962 = (((_e10784 * (1f + (0.000000059604645f * 8f))) + (((((((_e10838 + _e10840) + (_e10892 + _e10894)) + (_e10946 + _e10948)) * (0.000000059604645f * 16f)) + (_e10955 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e5889.member_1);
                        if _e10962 {
                            phi_9291_ = type_46();
                            phi_9292_ = true;
                        } else {
                            let _e10965 = local_18.member_1[0u];
                            let _e10971 = local_18.member_2[0u];
                            let _e10977 = ((_e10965[1] * _e10971[2]) - (_e10965[2] * _e10971[1]));
                            let _e10980 = ((_e10965[2] * _e10971[0]) - (_e10965[0] * _e10971[2]));
                            let _e10983 = ((_e10965[0] * _e10971[1]) - (_e10965[1] * _e10971[0]));
                            let _e10986 = local_18.member_1[1u];
                            let _e10992 = local_18.member_2[1u];
                            let _e10998 = ((_e10986[1] * _e10992[2]) - (_e10986[2] * _e10992[1]));
                            let _e11001 = ((_e10986[2] * _e10992[0]) - (_e10986[0] * _e10992[2]));
                            let _e11004 = ((_e10986[0] * _e10992[1]) - (_e10986[1] * _e10992[0]));
                            let _e11007 = local_18.member_1[0u];
                            let _e11013 = local_18.member_2[1u];
                            let _e11028 = local_18.member_1[1u];
                            let _e11034 = local_18.member_2[0u];
                            let _e11047 = (((_e11007[1] * _e11013[2]) - (_e11007[2] * _e11013[1])) + ((_e11028[1] * _e11034[2]) - (_e11028[2] * _e11034[1])));
                            let _e11048 = (((_e11007[2] * _e11013[0]) - (_e11007[0] * _e11013[2])) + ((_e11028[2] * _e11034[0]) - (_e11028[0] * _e11034[2])));
                            let _e11049 = (((_e11007[0] * _e11013[1]) - (_e11007[1] * _e11013[0])) + ((_e11028[0] * _e11034[1]) - (_e11028[1] * _e11034[0])));
                            let _e11052 = local_18.member[0u];
                            let _e11063 = local_18.member[1u];
                            let _e11074 = local_18.member[0u];
                            let _e11083 = ((((_e11063[0] * _e10977) + (_e11063[1] * _e10980)) + (_e11063[2] * _e10983)) + (((_e11074[0] * _e11047) + (_e11074[1] * _e11048)) + (_e11074[2] * _e11049)));
                            let _e11086 = local_18.member[0u];
                            let _e11097 = local_18.member[1u];
                            let _e11106 = ((((_e11086[0] * _e10998) + (_e11086[1] * _e11001)) + (_e11086[2] * _e11004)) + (((_e11097[0] * _e11047) + (_e11097[1] * _e11048)) + (_e11097[2] * _e11049)));
                            let _e11109 = local_18.member[1u];
                            let _e11120 = local_18.member[0u];
                            if (_e11120[0] < 0f) {
                                phi_8891_ = -(_e11120[0]);
                            } else {
                                phi_8891_ = _e11120[0];
                            }
                            let _e11127 = phi_8891_;
                            if (_e11120[1] < 0f) {
                                phi_8898_ = -(_e11120[1]);
                            } else {
                                phi_8898_ = _e11120[1];
                            }
                            let _e11131 = phi_8898_;
                            if (_e11127 > _e11131) {
                                phi_8903_ = _e11127;
                            } else {
                                phi_8903_ = _e11131;
                            }
                            let _e11134 = phi_8903_;
                            if (_e11120[2] < 0f) {
                                phi_8910_ = -(_e11120[2]);
                            } else {
                                phi_8910_ = _e11120[2];
                            }
                            let _e11138 = phi_8910_;
                            if (_e11134 > _e11138) {
                                phi_8915_ = _e11134;
                            } else {
                                phi_8915_ = _e11138;
                            }
                            let _e11141 = phi_8915_;
                            let _e11144 = local_18.member[1u];
                            if (_e11144[0] < 0f) {
                                phi_8928_ = -(_e11144[0]);
                            } else {
                                phi_8928_ = _e11144[0];
                            }
                            let _e11151 = phi_8928_;
                            if (_e11144[1] < 0f) {
                                phi_8935_ = -(_e11144[1]);
                            } else {
                                phi_8935_ = _e11144[1];
                            }
                            let _e11155 = phi_8935_;
                            if (_e11151 > _e11155) {
                                phi_8940_ = _e11151;
                            } else {
                                phi_8940_ = _e11155;
                            }
                            let _e11158 = phi_8940_;
                            if (_e11144[2] < 0f) {
                                phi_8947_ = -(_e11144[2]);
                            } else {
                                phi_8947_ = _e11144[2];
                            }
                            let _e11162 = phi_8947_;
                            if (_e11158 > _e11162) {
                                phi_8952_ = _e11158;
                            } else {
                                phi_8952_ = _e11162;
                            }
                            let _e11165 = phi_8952_;
                            if (_e11141 > _e11165) {
                                phi_8957_ = _e11141;
                            } else {
                                phi_8957_ = _e11165;
                            }
                            let _e11168 = phi_8957_;
                            let _e11170 = local_18.member_3;
                            let _e11171 = (_e11168 + _e11170);
                            let _e11174 = local_18.member_1[0u];
                            if (_e11174[0] < 0f) {
                                phi_8974_ = -(_e11174[0]);
                            } else {
                                phi_8974_ = _e11174[0];
                            }
                            let _e11181 = phi_8974_;
                            if (_e11174[1] < 0f) {
                                phi_8981_ = -(_e11174[1]);
                            } else {
                                phi_8981_ = _e11174[1];
                            }
                            let _e11185 = phi_8981_;
                            if (_e11181 > _e11185) {
                                phi_8986_ = _e11181;
                            } else {
                                phi_8986_ = _e11185;
                            }
                            let _e11188 = phi_8986_;
                            if (_e11174[2] < 0f) {
                                phi_8993_ = -(_e11174[2]);
                            } else {
                                phi_8993_ = _e11174[2];
                            }
                            let _e11192 = phi_8993_;
                            if (_e11188 > _e11192) {
                                phi_8998_ = _e11188;
                            } else {
                                phi_8998_ = _e11192;
                            }
                            let _e11195 = phi_8998_;
                            let _e11198 = local_18.member_1[1u];
                            if (_e11198[0] < 0f) {
                                phi_9012_ = -(_e11198[0]);
                            } else {
                                phi_9012_ = _e11198[0];
                            }
                            let _e11205 = phi_9012_;
                            if (_e11198[1] < 0f) {
                                phi_9019_ = -(_e11198[1]);
                            } else {
                                phi_9019_ = _e11198[1];
                            }
                            let _e11209 = phi_9019_;
                            if (_e11205 > _e11209) {
                                phi_9024_ = _e11205;
                            } else {
                                phi_9024_ = _e11209;
                            }
                            let _e11212 = phi_9024_;
                            if (_e11198[2] < 0f) {
                                phi_9031_ = -(_e11198[2]);
                            } else {
                                phi_9031_ = _e11198[2];
                            }
                            let _e11216 = phi_9031_;
                            if (_e11212 > _e11216) {
                                phi_9036_ = _e11212;
                            } else {
                                phi_9036_ = _e11216;
                            }
                            let _e11219 = phi_9036_;
                            if (_e11195 > _e11219) {
                                phi_9041_ = _e11195;
                            } else {
                                phi_9041_ = _e11219;
                            }
                            let _e11222 = phi_9041_;
                            let _e11224 = local_18.member_3;
                            let _e11225 = (_e11222 + _e11224);
                            let _e11228 = local_18.member_2[0u];
                            if (_e11228[0] < 0f) {
                                phi_9058_ = -(_e11228[0]);
                            } else {
                                phi_9058_ = _e11228[0];
                            }
                            let _e11235 = phi_9058_;
                            if (_e11228[1] < 0f) {
                                phi_9065_ = -(_e11228[1]);
                            } else {
                                phi_9065_ = _e11228[1];
                            }
                            let _e11239 = phi_9065_;
                            if (_e11235 > _e11239) {
                                phi_9070_ = _e11235;
                            } else {
                                phi_9070_ = _e11239;
                            }
                            let _e11242 = phi_9070_;
                            if (_e11228[2] < 0f) {
                                phi_9077_ = -(_e11228[2]);
                            } else {
                                phi_9077_ = _e11228[2];
                            }
                            let _e11246 = phi_9077_;
                            if (_e11242 > _e11246) {
                                phi_9082_ = _e11242;
                            } else {
                                phi_9082_ = _e11246;
                            }
                            let _e11249 = phi_9082_;
                            let _e11252 = local_18.member_2[1u];
                            if (_e11252[0] < 0f) {
                                phi_9096_ = -(_e11252[0]);
                            } else {
                                phi_9096_ = _e11252[0];
                            }
                            let _e11259 = phi_9096_;
                            if (_e11252[1] < 0f) {
                                phi_9103_ = -(_e11252[1]);
                            } else {
                                phi_9103_ = _e11252[1];
                            }
                            let _e11263 = phi_9103_;
                            if (_e11259 > _e11263) {
                                phi_9108_ = _e11259;
                            } else {
                                phi_9108_ = _e11263;
                            }
                            let _e11266 = phi_9108_;
                            if (_e11252[2] < 0f) {
                                phi_9115_ = -(_e11252[2]);
                            } else {
                                phi_9115_ = _e11252[2];
                            }
                            let _e11270 = phi_9115_;
                            if (_e11266 > _e11270) {
                                phi_9120_ = _e11266;
                            } else {
                                phi_9120_ = _e11270;
                            }
                            let _e11273 = phi_9120_;
                            if (_e11249 > _e11273) {
                                phi_9125_ = _e11249;
                            } else {
                                phi_9125_ = _e11273;
                            }
                            let _e11276 = phi_9125_;
                            let _e11278 = local_18.member_3;
                            let _e11279 = (_e11276 + _e11278);
                            let _e11281 = ((_e11225 * 8f) * _e11279);
                            let _e11288 = local_18.member_3;
                            if (_e10977 < 0f) {
                                phi_9156_ = -(_e10977);
                            } else {
                                phi_9156_ = _e10977;
                            }
                            let _e11305 = phi_9156_;
                            if (_e10980 < 0f) {
                                phi_9162_ = -(_e10980);
                            } else {
                                phi_9162_ = _e10980;
                            }
                            let _e11309 = phi_9162_;
                            if (_e10983 < 0f) {
                                phi_9169_ = -(_e10983);
                            } else {
                                phi_9169_ = _e10983;
                            }
                            let _e11314 = phi_9169_;
                            let _e11315 = ((_e11305 + _e11309) + _e11314);
                            if (_e10998 < 0f) {
                                phi_9176_ = -(_e10998);
                            } else {
                                phi_9176_ = _e10998;
                            }
                            let _e11319 = phi_9176_;
                            if (_e11001 < 0f) {
                                phi_9182_ = -(_e11001);
                            } else {
                                phi_9182_ = _e11001;
                            }
                            let _e11323 = phi_9182_;
                            if (_e11004 < 0f) {
                                phi_9189_ = -(_e11004);
                            } else {
                                phi_9189_ = _e11004;
                            }
                            let _e11328 = phi_9189_;
                            let _e11329 = ((_e11319 + _e11323) + _e11328);
                            if (_e11315 > _e11329) {
                                phi_9195_ = _e11315;
                            } else {
                                phi_9195_ = _e11329;
                            }
                            let _e11332 = phi_9195_;
                            if (_e11047 < 0f) {
                                phi_9201_ = -(_e11047);
                            } else {
                                phi_9201_ = _e11047;
                            }
                            let _e11336 = phi_9201_;
                            if (_e11048 < 0f) {
                                phi_9207_ = -(_e11048);
                            } else {
                                phi_9207_ = _e11048;
                            }
                            let _e11340 = phi_9207_;
                            if (_e11049 < 0f) {
                                phi_9214_ = -(_e11049);
                            } else {
                                phi_9214_ = _e11049;
                            }
                            let _e11345 = phi_9214_;
                            let _e11347 = (((_e11336 + _e11340) + _e11345) * 0.5f);
                            if (_e11332 > _e11347) {
                                phi_9221_ = _e11332;
                            } else {
                                phi_9221_ = _e11347;
                            }
                            let _e11350 = phi_9221_;
                            let _e11355 = local_18.member_3;
                            let _e11368 = ((((_e11052[0] * _e10977) + (_e11052[1] * _e10980)) + (_e11052[2] * _e10983)) * 3f);
                            let _e11369 = ((((_e11109[0] * _e10998) + (_e11109[1] * _e11001)) + (_e11109[2] * _e11004)) * 3f);
                            if (_e11368 < _e11369) {
                                phi_9245_ = _e11368;
                            } else {
                                phi_9245_ = _e11369;
                            }
                            let _e11372 = phi_9245_;
                            if (_e11083 < _e11106) {
                                phi_9250_ = _e11083;
                            } else {
                                phi_9250_ = _e11106;
                            }
                            let _e11375 = phi_9250_;
                            if (_e11372 < _e11375) {
                                phi_9255_ = _e11372;
                            } else {
                                phi_9255_ = _e11375;
                            }
                            let _e11378 = phi_9255_;
                            if (_e11368 > _e11369) {
                                phi_9260_ = _e11368;
                            } else {
                                phi_9260_ = _e11369;
                            }
                            let _e11381 = phi_9260_;
                            if (_e11083 > _e11106) {
                                phi_9265_ = _e11083;
                            } else {
                                phi_9265_ = _e11106;
                            }
                            let _e11384 = phi_9265_;
                            if (_e11381 > _e11384) {
                                phi_9270_ = _e11381;
                            } else {
                                phi_9270_ = _e11384;
                            }
                            let _e11387 = phi_9270_;
                            let _e11392 = -(_e11387);
                            if (_e11378 > _e11392) {
                                phi_9280_ = _e11378;
                            } else {
                                phi_9280_ = _e11392;
                            }
                            let _e11395 = phi_9280_;
                            if ((_e11395 - ((((((_e11171 * 8f) * _e11281) * (0.000000059604645f * (524f / 64f))) + ((_e11288 * 19f) * ((_e11171 * (_e11225 + _e11279)) + (_e11225 * _e11279)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e11171) * ((1f + _e11225) * (1f + _e11279))))) + ((_e5889.member_1 * (((_e11350 + (_e11281 * (0.000000059604645f * 8f))) + ((_e11355 * 6f) * (_e11225 + _e11279))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e11225) * (1f + _e11279))))) * (3f * 1.0001f)))) > 0f) {
                                phi_9289_ = type_46(type_45(0u, f32()), 0u);
                                phi_9290_ = false;
                            } else {
                                phi_9289_ = type_46();
                                phi_9290_ = true;
                            }
                            let _e11401 = phi_9289_;
                            let _e11403 = phi_9290_;
                            phi_9291_ = _e11401;
                            phi_9292_ = _e11403;
                        }
                        let _e11405 = phi_9291_;
                        let _e11407 = phi_9292_;
                        if _e11407 {
                            phi_9298_ = type_14(0i, 2i);
                            phi_9301_ = _e5621;
                            phi_9303_ = 0u;
                            phi_9305_ = _e5621;
                            loop {
                                let _e11409 = phi_9298_;
                                let _e11411 = phi_9301_;
                                let _e11413 = phi_9303_;
                                let _e11415 = phi_9305_;
                                local_167 = _e11413;
                                local_170 = _e11411;
                                local_171 = _e11413;
                                if (_e11409.member < _e11409.member_1) {
                                    let _e11422 = (_e11409.member + 1i);
                                    if ((false == (_e11422 > _e11409.member)) != false) {
                                        phi_9326_ = true;
                                    } else {
                                        phi_9326_ = false;
                                    }
                                    let _e11427 = phi_9326_;
                                    if _e11427 {
                                        phi_9332_ = type_15(0u, type_15().member_1);
                                    } else {
                                        phi_9332_ = type_15(1u, _e11422);
                                    }
                                    let _e11432 = phi_9332_;
                                    phi_9299_ = type_14(_e11432.member_1, _e11409.member_1);
                                    phi_9346_ = type_15(1u, _e11409.member);
                                } else {
                                    phi_9299_ = _e11409;
                                    phi_9346_ = type_15(0u, type_15().member_1);
                                }
                                let _e11438 = phi_9299_;
                                let _e11440 = phi_9346_;
                                if (bitcast<i32>(_e11440.member) != 0i) {
                                    if (_e11440.member_1 > 0i) {
                                        phi_9362_ = true;
                                    } else {
                                        if _e10962 {
                                            phi_9361_ = false;
                                        } else {
                                            phi_9361_ = true;
                                        }
                                        let _e11447 = phi_9361_;
                                        phi_9362_ = _e11447;
                                    }
                                    let _e11449 = phi_9362_;
                                    if _e11449 {
                                        let _e11452 = local_18.member[0u];
                                        let _e11459 = local_18.member_1[0u];
                                        let _e11465 = local_18.member_2[0u];
                                        let _e11469 = (_e11452[0] - _e11459[0]);
                                        let _e11470 = (_e11452[1] - _e11459[1]);
                                        let _e11471 = (_e11452[2] - _e11459[2]);
                                        if (_e316.member == 0u) {
                                            phi_9421_ = array<f32, 3>(_e11452[0], _e11452[1], _e11452[2]);
                                        } else {
                                            phi_9421_ = array<f32, 3>((_e11469 - _e11465[0]), (_e11470 - _e11465[1]), (_e11471 - _e11465[2]));
                                        }
                                        let _e11478 = phi_9421_;
                                        let _e11484 = local_18.member[1u];
                                        let _e11491 = local_18.member_1[1u];
                                        let _e11497 = local_18.member_2[1u];
                                        let _e11501 = (_e11484[0] - _e11491[0]);
                                        let _e11502 = (_e11484[1] - _e11491[1]);
                                        let _e11503 = (_e11484[2] - _e11491[2]);
                                        if (_e316.member == 0u) {
                                            phi_9486_ = array<f32, 3>(_e11484[0], _e11484[1], _e11484[2]);
                                        } else {
                                            phi_9486_ = array<f32, 3>((_e11501 - _e11497[0]), (_e11502 - _e11497[1]), (_e11503 - _e11497[2]));
                                        }
                                        let _e11510 = phi_9486_;
                                        let _e11516 = local_18.member[0u];
                                        if (_e11516[0] < 0f) {
                                            phi_9508_ = -(_e11516[0]);
                                        } else {
                                            phi_9508_ = _e11516[0];
                                        }
                                        let _e11523 = phi_9508_;
                                        if (_e11516[1] < 0f) {
                                            phi_9515_ = -(_e11516[1]);
                                        } else {
                                            phi_9515_ = _e11516[1];
                                        }
                                        let _e11527 = phi_9515_;
                                        if (_e11523 > _e11527) {
                                            phi_9520_ = _e11523;
                                        } else {
                                            phi_9520_ = _e11527;
                                        }
                                        let _e11530 = phi_9520_;
                                        if (_e11516[2] < 0f) {
                                            phi_9527_ = -(_e11516[2]);
                                        } else {
                                            phi_9527_ = _e11516[2];
                                        }
                                        let _e11534 = phi_9527_;
                                        if (_e11530 > _e11534) {
                                            phi_9532_ = _e11530;
                                        } else {
                                            phi_9532_ = _e11534;
                                        }
                                        let _e11537 = phi_9532_;
                                        let _e11540 = local_18.member[1u];
                                        if (_e11540[0] < 0f) {
                                            phi_9545_ = -(_e11540[0]);
                                        } else {
                                            phi_9545_ = _e11540[0];
                                        }
                                        let _e11547 = phi_9545_;
                                        if (_e11540[1] < 0f) {
                                            phi_9552_ = -(_e11540[1]);
                                        } else {
                                            phi_9552_ = _e11540[1];
                                        }
                                        let _e11551 = phi_9552_;
                                        if (_e11547 > _e11551) {
                                            phi_9557_ = _e11547;
                                        } else {
                                            phi_9557_ = _e11551;
                                        }
                                        let _e11554 = phi_9557_;
                                        if (_e11540[2] < 0f) {
                                            phi_9564_ = -(_e11540[2]);
                                        } else {
                                            phi_9564_ = _e11540[2];
                                        }
                                        let _e11558 = phi_9564_;
                                        if (_e11554 > _e11558) {
                                            phi_9569_ = _e11554;
                                        } else {
                                            phi_9569_ = _e11558;
                                        }
                                        let _e11561 = phi_9569_;
                                        if (_e11537 > _e11561) {
                                            phi_9574_ = _e11537;
                                        } else {
                                            phi_9574_ = _e11561;
                                        }
                                        let _e11564 = phi_9574_;
                                        let _e11566 = local_18.member_3;
                                        let _e11570 = local_18.member_1[0u];
                                        if (_e11570[0] < 0f) {
                                            phi_9591_ = -(_e11570[0]);
                                        } else {
                                            phi_9591_ = _e11570[0];
                                        }
                                        let _e11577 = phi_9591_;
                                        if (_e11570[1] < 0f) {
                                            phi_9598_ = -(_e11570[1]);
                                        } else {
                                            phi_9598_ = _e11570[1];
                                        }
                                        let _e11581 = phi_9598_;
                                        if (_e11577 > _e11581) {
                                            phi_9603_ = _e11577;
                                        } else {
                                            phi_9603_ = _e11581;
                                        }
                                        let _e11584 = phi_9603_;
                                        if (_e11570[2] < 0f) {
                                            phi_9610_ = -(_e11570[2]);
                                        } else {
                                            phi_9610_ = _e11570[2];
                                        }
                                        let _e11588 = phi_9610_;
                                        if (_e11584 > _e11588) {
                                            phi_9615_ = _e11584;
                                        } else {
                                            phi_9615_ = _e11588;
                                        }
                                        let _e11591 = phi_9615_;
                                        let _e11594 = local_18.member_1[1u];
                                        if (_e11594[0] < 0f) {
                                            phi_9629_ = -(_e11594[0]);
                                        } else {
                                            phi_9629_ = _e11594[0];
                                        }
                                        let _e11601 = phi_9629_;
                                        if (_e11594[1] < 0f) {
                                            phi_9636_ = -(_e11594[1]);
                                        } else {
                                            phi_9636_ = _e11594[1];
                                        }
                                        let _e11605 = phi_9636_;
                                        if (_e11601 > _e11605) {
                                            phi_9641_ = _e11601;
                                        } else {
                                            phi_9641_ = _e11605;
                                        }
                                        let _e11608 = phi_9641_;
                                        if (_e11594[2] < 0f) {
                                            phi_9648_ = -(_e11594[2]);
                                        } else {
                                            phi_9648_ = _e11594[2];
                                        }
                                        let _e11612 = phi_9648_;
                                        if (_e11608 > _e11612) {
                                            phi_9653_ = _e11608;
                                        } else {
                                            phi_9653_ = _e11612;
                                        }
                                        let _e11615 = phi_9653_;
                                        if (_e11591 > _e11615) {
                                            phi_9658_ = _e11591;
                                        } else {
                                            phi_9658_ = _e11615;
                                        }
                                        let _e11618 = phi_9658_;
                                        let _e11620 = local_18.member_3;
                                        let _e11624 = local_18.member_2[0u];
                                        if (_e11624[0] < 0f) {
                                            phi_9675_ = -(_e11624[0]);
                                        } else {
                                            phi_9675_ = _e11624[0];
                                        }
                                        let _e11631 = phi_9675_;
                                        if (_e11624[1] < 0f) {
                                            phi_9682_ = -(_e11624[1]);
                                        } else {
                                            phi_9682_ = _e11624[1];
                                        }
                                        let _e11635 = phi_9682_;
                                        if (_e11631 > _e11635) {
                                            phi_9687_ = _e11631;
                                        } else {
                                            phi_9687_ = _e11635;
                                        }
                                        let _e11638 = phi_9687_;
                                        if (_e11624[2] < 0f) {
                                            phi_9694_ = -(_e11624[2]);
                                        } else {
                                            phi_9694_ = _e11624[2];
                                        }
                                        let _e11642 = phi_9694_;
                                        if (_e11638 > _e11642) {
                                            phi_9699_ = _e11638;
                                        } else {
                                            phi_9699_ = _e11642;
                                        }
                                        let _e11645 = phi_9699_;
                                        let _e11648 = local_18.member_2[1u];
                                        if (_e11648[0] < 0f) {
                                            phi_9713_ = -(_e11648[0]);
                                        } else {
                                            phi_9713_ = _e11648[0];
                                        }
                                        let _e11655 = phi_9713_;
                                        if (_e11648[1] < 0f) {
                                            phi_9720_ = -(_e11648[1]);
                                        } else {
                                            phi_9720_ = _e11648[1];
                                        }
                                        let _e11659 = phi_9720_;
                                        if (_e11655 > _e11659) {
                                            phi_9725_ = _e11655;
                                        } else {
                                            phi_9725_ = _e11659;
                                        }
                                        let _e11662 = phi_9725_;
                                        if (_e11648[2] < 0f) {
                                            phi_9732_ = -(_e11648[2]);
                                        } else {
                                            phi_9732_ = _e11648[2];
                                        }
                                        let _e11666 = phi_9732_;
                                        if (_e11662 > _e11666) {
                                            phi_9737_ = _e11662;
                                        } else {
                                            phi_9737_ = _e11666;
                                        }
                                        let _e11669 = phi_9737_;
                                        if (_e11645 > _e11669) {
                                            phi_9742_ = _e11645;
                                        } else {
                                            phi_9742_ = _e11669;
                                        }
                                        let _e11672 = phi_9742_;
                                        let _e11674 = local_18.member_3;
                                        let _e11681 = local_18.member_3;
                                        let _e11686 = (_e5619 * 0.00390625f);
                                        local_16 = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        phi_9783_ = type_9(0u, 96u);
                                        phi_9786_ = _e11415;
                                        phi_9788_ = _e11415;
                                        phi_9790_ = (_e5623 - _e11415);
                                        phi_9792_ = _e11415;
                                        phi_9794_ = false;
                                        phi_9796_ = 0u;
                                        loop {
                                            let _e11689 = phi_9783_;
                                            let _e11691 = phi_9786_;
                                            let _e11693 = phi_9788_;
                                            let _e11695 = phi_9790_;
                                            let _e11697 = phi_9792_;
                                            let _e11699 = phi_9794_;
                                            let _e11701 = phi_9796_;
                                            local_109 = _e11691;
                                            local_157 = _e11693;
                                            if (_e11689.member < _e11689.member_1) {
                                                phi_9784_ = type_9((_e11689.member + 1u), _e11689.member_1);
                                                phi_9819_ = type_9(1u, _e11689.member);
                                            } else {
                                                phi_9784_ = _e11689;
                                                phi_9819_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e11713 = phi_9784_;
                                            let _e11715 = phi_9819_;
                                            if (bitcast<i32>(_e11715.member) != 0i) {
                                                let _e11721 = local_18.member[0u];
                                                let _e11727 = local_18.member[1u];
                                                let _e11743 = local_18.member_1[0u];
                                                let _e11749 = local_18.member_1[1u];
                                                let _e11765 = local_18.member_2[0u];
                                                let _e11771 = local_18.member_2[1u];
                                                let _e11785 = function_4(array<f32, 3>((_e11721[0] + ((_e11727[0] - _e11721[0]) * _e11691)), (_e11721[1] + ((_e11727[1] - _e11721[1]) * _e11691)), (_e11721[2] + ((_e11727[2] - _e11721[2]) * _e11691))), array<f32, 3>((_e11743[0] + ((_e11749[0] - _e11743[0]) * _e11691)), (_e11743[1] + ((_e11749[1] - _e11743[1]) * _e11691)), (_e11743[2] + ((_e11749[2] - _e11743[2]) * _e11691))), array<f32, 3>((_e11765[0] + ((_e11771[0] - _e11765[0]) * _e11691)), (_e11765[1] + ((_e11771[1] - _e11765[1]) * _e11691)), (_e11765[2] + ((_e11771[2] - _e11765[2]) * _e11691))), _e316.member);
                                                if (_e11701 == 0u) {
                                                    phi_9947_ = _e11785;
                                                } else {
                                                    if (_e11701 == 1u) {
                                                        phi_9933_ = _e11785[0];
                                                    } else {
                                                        phi_9933_ = 0f;
                                                    }
                                                    let _e11790 = phi_9933_;
                                                    if (_e11701 == 2u) {
                                                        phi_9939_ = _e11785[1];
                                                    } else {
                                                        phi_9939_ = 0f;
                                                    }
                                                    let _e11794 = phi_9939_;
                                                    if (_e11701 == 3u) {
                                                        phi_9945_ = _e11785[2];
                                                    } else {
                                                        phi_9945_ = 0f;
                                                    }
                                                    let _e11798 = phi_9945_;
                                                    phi_9947_ = array<f32, 3>(_e11790, _e11794, _e11798);
                                                }
                                                let _e11801 = phi_9947_;
                                                if (_e11801[0] < 0f) {
                                                    phi_9954_ = -(_e11801[0]);
                                                } else {
                                                    phi_9954_ = _e11801[0];
                                                }
                                                let _e11806 = phi_9954_;
                                                if (_e11801[1] < 0f) {
                                                    phi_9961_ = -(_e11801[1]);
                                                } else {
                                                    phi_9961_ = _e11801[1];
                                                }
                                                let _e11811 = phi_9961_;
                                                if (_e11801[2] < 0f) {
                                                    phi_9969_ = -(_e11801[2]);
                                                } else {
                                                    phi_9969_ = _e11801[2];
                                                }
                                                let _e11817 = phi_9969_;
                                                let _e11818 = ((_e11806 + _e11811) + _e11817);
                                                if (_e11818 > 0f) {
                                                    if ((bitcast<u32>(_e11818) & 2139095040u) != 2139095040u) {
                                                        let _e11823 = (1f / _e11818);
                                                        let _e11825 = (_e11801[0] * _e11823);
                                                        let _e11827 = (_e11801[1] * _e11823);
                                                        let _e11829 = (_e11801[2] * _e11823);
                                                        let _e11834 = (((_e11825 * _e11825) + (_e11827 * _e11827)) + (_e11829 * _e11829));
                                                        if (_e11834 <= 0.000000000000000000000000000000000000011754944f) {
                                                            if (_e11834 > 0f) {
                                                                phi_10006_ = (0.000000000000000000106433627f * 2f);
                                                            } else {
                                                                phi_10006_ = 0f;
                                                            }
                                                            let _e11887 = phi_10006_;
                                                            phi_10070_ = _e11887;
                                                        } else {
                                                            phi_10013_ = type_14(0i, 5i);
                                                            phi_10016_ = bitcast<f32>(((bitcast<u32>(_e11834) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e11842 = phi_10013_;
                                                                let _e11844 = phi_10016_;
                                                                local_106 = _e11844;
                                                                if (_e11842.member < _e11842.member_1) {
                                                                    let _e11851 = (_e11842.member + 1i);
                                                                    if ((false == (_e11851 > _e11842.member)) != false) {
                                                                        phi_10037_ = true;
                                                                    } else {
                                                                        phi_10037_ = false;
                                                                    }
                                                                    let _e11856 = phi_10037_;
                                                                    if _e11856 {
                                                                        phi_10043_ = type_15(0u, type_15().member_1);
                                                                    } else {
                                                                        phi_10043_ = type_15(1u, _e11851);
                                                                    }
                                                                    let _e11861 = phi_10043_;
                                                                    phi_10014_ = type_14(_e11861.member_1, _e11842.member_1);
                                                                    phi_10057_ = type_15(1u, _e11842.member);
                                                                } else {
                                                                    phi_10014_ = _e11842;
                                                                    phi_10057_ = type_15(0u, type_15().member_1);
                                                                }
                                                                let _e11867 = phi_10014_;
                                                                let _e11869 = phi_10057_;
                                                                let _e11872 = (bitcast<i32>(_e11869.member) != 0i);
                                                                if _e11872 {
                                                                    phi_10017_ = (0.5f * (_e11844 + (_e11834 / _e11844)));
                                                                } else {
                                                                    phi_10017_ = f32();
                                                                }
                                                                let _e11877 = phi_10017_;
                                                                continue;
                                                                continuing {
                                                                    phi_10013_ = _e11867;
                                                                    phi_10016_ = _e11877;
                                                                    break if !(_e11872);
                                                                }
                                                            }
                                                            let _e11882 = local_106;
                                                            phi_10070_ = (_e11882 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e11889 = phi_10070_;
                                                        let _e11890 = (0.000000059604645f * 12f);
                                                        let _e11895 = ((((((((_e11564 + _e11566) + (_e11618 + _e11620)) + (_e11672 + _e11674)) * (0.000000059604645f * 16f)) + (_e11681 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e5889.member_1 * _e11889) * (1f + _e11890)));
                                                        let _e11900 = (((_e11825 * _e11452[0]) + (_e11827 * _e11452[1])) + (_e11829 * _e11452[2]));
                                                        let _e11905 = (((_e11825 * _e11469) + (_e11827 * _e11470)) + (_e11829 * _e11471));
                                                        let _e11910 = (((_e11825 * (_e11452[0] - _e11465[0])) + (_e11827 * (_e11452[1] - _e11465[1]))) + (_e11829 * (_e11452[2] - _e11465[2])));
                                                        let _e11918 = (((_e11825 * _e11478[0]) + (_e11827 * _e11478[1])) + (_e11829 * _e11478[2]));
                                                        let _e11924 = (((_e11825 * _e11484[0]) + (_e11827 * _e11484[1])) + (_e11829 * _e11484[2]));
                                                        let _e11929 = (((_e11825 * _e11501) + (_e11827 * _e11502)) + (_e11829 * _e11503));
                                                        let _e11934 = (((_e11825 * (_e11484[0] - _e11497[0])) + (_e11827 * (_e11484[1] - _e11497[1]))) + (_e11829 * (_e11484[2] - _e11497[2])));
                                                        let _e11942 = (((_e11825 * _e11510[0]) + (_e11827 * _e11510[1])) + (_e11829 * _e11510[2]));
                                                        if (_e11900 < 0f) {
                                                            phi_10136_ = -(_e11900);
                                                        } else {
                                                            phi_10136_ = _e11900;
                                                        }
                                                        let _e11947 = phi_10136_;
                                                        if (_e11924 < 0f) {
                                                            phi_10142_ = -(_e11924);
                                                        } else {
                                                            phi_10142_ = _e11924;
                                                        }
                                                        let _e11951 = phi_10142_;
                                                        if (_e11905 < 0f) {
                                                            phi_10151_ = -(_e11905);
                                                        } else {
                                                            phi_10151_ = _e11905;
                                                        }
                                                        let _e11958 = phi_10151_;
                                                        if (_e11929 < 0f) {
                                                            phi_10157_ = -(_e11929);
                                                        } else {
                                                            phi_10157_ = _e11929;
                                                        }
                                                        let _e11962 = phi_10157_;
                                                        if (_e11910 < 0f) {
                                                            phi_10166_ = -(_e11910);
                                                        } else {
                                                            phi_10166_ = _e11910;
                                                        }
                                                        let _e11969 = phi_10166_;
                                                        if (_e11934 < 0f) {
                                                            phi_10172_ = -(_e11934);
                                                        } else {
                                                            phi_10172_ = _e11934;
                                                        }
                                                        let _e11973 = phi_10172_;
                                                        if (_e11918 < 0f) {
                                                            phi_10181_ = -(_e11918);
                                                        } else {
                                                            phi_10181_ = _e11918;
                                                        }
                                                        let _e11980 = phi_10181_;
                                                        if (_e11942 < 0f) {
                                                            phi_10187_ = -(_e11942);
                                                        } else {
                                                            phi_10187_ = _e11942;
                                                        }
                                                        let _e11984 = phi_10187_;
                                                        phi_10193_ = type_30(array<f32, 4>(_e11900, _e11905, _e11910, _e11918), array<f32, 4>(_e11924, _e11929, _e11934, _e11942), array<f32, 4>((_e11895 + ((_e11947 + _e11951) * _e11890)), (_e11895 + ((_e11958 + _e11962) * _e11890)), (_e11895 + ((_e11969 + _e11973) * _e11890)), (_e11895 + ((_e11980 + _e11984) * _e11890))));
                                                        phi_10194_ = false;
                                                    } else {
                                                        phi_10193_ = type_30();
                                                        phi_10194_ = true;
                                                    }
                                                    let _e11991 = phi_10193_;
                                                    let _e11993 = phi_10194_;
                                                    phi_10195_ = _e11991;
                                                    phi_10196_ = _e11993;
                                                } else {
                                                    phi_10195_ = type_30();
                                                    phi_10196_ = true;
                                                }
                                                let _e11995 = phi_10195_;
                                                let _e11997 = phi_10196_;
                                                if _e11997 {
                                                    phi_10204_ = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                } else {
                                                    phi_10204_ = _e11995;
                                                }
                                                let _e11999 = phi_10204_;
                                                local_17 = type_30(array<f32, 4>(_e11999.member[0], _e11999.member[1], _e11999.member[2], _e11999.member[3]), array<f32, 4>(_e11999.member_1[0], _e11999.member_1[1], _e11999.member_1[2], _e11999.member_1[3]), array<f32, 4>(_e11999.member_2[0], _e11999.member_2[1], _e11999.member_2[2], _e11999.member_2[3]));
                                                let _e12019 = (_e11691 - _e11697);
                                                let _e12023 = local_17.member[0u];
                                                let _e12026 = local_17.member_1[0u];
                                                let _e12029 = local_17.member[0u];
                                                let _e12035 = local_17.member_2[0u];
                                                if (((_e12023 + ((_e12026 - _e12029) * _e11691)) - _e12035) > 0f) {
                                                    let _e12040 = local_17.member[1u];
                                                    let _e12043 = local_17.member_1[1u];
                                                    let _e12046 = local_17.member[1u];
                                                    let _e12052 = local_17.member_2[1u];
                                                    if (((_e12040 + ((_e12043 - _e12046) * _e11691)) - _e12052) > 0f) {
                                                        let _e12057 = local_17.member[2u];
                                                        let _e12060 = local_17.member_1[2u];
                                                        let _e12063 = local_17.member[2u];
                                                        let _e12069 = local_17.member_2[2u];
                                                        if (((_e12057 + ((_e12060 - _e12063) * _e11691)) - _e12069) > 0f) {
                                                            let _e12074 = local_17.member[3u];
                                                            let _e12077 = local_17.member_1[3u];
                                                            let _e12080 = local_17.member[3u];
                                                            let _e12086 = local_17.member_2[3u];
                                                            phi_10375_ = (((_e12074 + ((_e12077 - _e12080) * _e11691)) - _e12086) > 0f);
                                                            phi_10376_ = false;
                                                        } else {
                                                            phi_10375_ = bool();
                                                            phi_10376_ = true;
                                                        }
                                                        let _e12090 = phi_10375_;
                                                        let _e12092 = phi_10376_;
                                                        phi_10377_ = _e12090;
                                                        phi_10378_ = _e12092;
                                                    } else {
                                                        phi_10377_ = bool();
                                                        phi_10378_ = true;
                                                    }
                                                    let _e12094 = phi_10377_;
                                                    let _e12096 = phi_10378_;
                                                    phi_10379_ = _e12094;
                                                    phi_10380_ = _e12096;
                                                } else {
                                                    phi_10379_ = bool();
                                                    phi_10380_ = true;
                                                }
                                                let _e12098 = phi_10379_;
                                                let _e12100 = phi_10380_;
                                                if _e12100 {
                                                    phi_10384_ = false;
                                                } else {
                                                    phi_10384_ = _e12098;
                                                }
                                                let _e12102 = phi_10384_;
                                                if _e12102 {
                                                    if (_e11691 <= _e11693) {
                                                        phi_10694_ = true;
                                                    } else {
                                                        let _e12106 = local_16.member[0u];
                                                        let _e12109 = local_16.member_1[0u];
                                                        let _e12112 = local_16.member[0u];
                                                        let _e12118 = local_16.member_2[0u];
                                                        let _e12122 = local_17.member[0u];
                                                        let _e12125 = local_17.member_1[0u];
                                                        let _e12128 = local_17.member[0u];
                                                        let _e12134 = local_17.member_2[0u];
                                                        if ((((_e12106 + ((_e12109 - _e12112) * _e11691)) - _e12118) + ((_e12122 + ((_e12125 - _e12128) * _e11697)) - _e12134)) > 0f) {
                                                            let _e12140 = local_16.member[1u];
                                                            let _e12143 = local_16.member_1[1u];
                                                            let _e12146 = local_16.member[1u];
                                                            let _e12152 = local_16.member_2[1u];
                                                            let _e12156 = local_17.member[1u];
                                                            let _e12159 = local_17.member_1[1u];
                                                            let _e12162 = local_17.member[1u];
                                                            let _e12168 = local_17.member_2[1u];
                                                            if ((((_e12140 + ((_e12143 - _e12146) * _e11691)) - _e12152) + ((_e12156 + ((_e12159 - _e12162) * _e11697)) - _e12168)) > 0f) {
                                                                let _e12174 = local_16.member[2u];
                                                                let _e12177 = local_16.member_1[2u];
                                                                let _e12180 = local_16.member[2u];
                                                                let _e12186 = local_16.member_2[2u];
                                                                let _e12190 = local_17.member[2u];
                                                                let _e12193 = local_17.member_1[2u];
                                                                let _e12196 = local_17.member[2u];
                                                                let _e12202 = local_17.member_2[2u];
                                                                if ((((_e12174 + ((_e12177 - _e12180) * _e11691)) - _e12186) + ((_e12190 + ((_e12193 - _e12196) * _e11697)) - _e12202)) > 0f) {
                                                                    let _e12208 = local_16.member[3u];
                                                                    let _e12211 = local_16.member_1[3u];
                                                                    let _e12214 = local_16.member[3u];
                                                                    let _e12220 = local_16.member_2[3u];
                                                                    let _e12224 = local_17.member[3u];
                                                                    let _e12227 = local_17.member_1[3u];
                                                                    let _e12230 = local_17.member[3u];
                                                                    let _e12236 = local_17.member_2[3u];
                                                                    phi_10681_ = ((((_e12208 + ((_e12211 - _e12214) * _e11691)) - _e12220) + ((_e12224 + ((_e12227 - _e12230) * _e11697)) - _e12236)) > 0f);
                                                                    phi_10682_ = false;
                                                                } else {
                                                                    phi_10681_ = bool();
                                                                    phi_10682_ = true;
                                                                }
                                                                let _e12241 = phi_10681_;
                                                                let _e12243 = phi_10682_;
                                                                phi_10683_ = _e12241;
                                                                phi_10684_ = _e12243;
                                                            } else {
                                                                phi_10683_ = bool();
                                                                phi_10684_ = true;
                                                            }
                                                            let _e12245 = phi_10683_;
                                                            let _e12247 = phi_10684_;
                                                            phi_10685_ = _e12245;
                                                            phi_10686_ = _e12247;
                                                        } else {
                                                            phi_10685_ = bool();
                                                            phi_10686_ = true;
                                                        }
                                                        let _e12249 = phi_10685_;
                                                        let _e12251 = phi_10686_;
                                                        if _e12251 {
                                                            phi_10690_ = false;
                                                        } else {
                                                            phi_10690_ = _e12249;
                                                        }
                                                        let _e12253 = phi_10690_;
                                                        phi_10694_ = _e12253;
                                                    }
                                                    let _e12255 = phi_10694_;
                                                    if _e12255 {
                                                        if _e11699 {
                                                            if (_e11691 >= _e5623) {
                                                                phi_10705_ = false;
                                                            } else {
                                                                phi_10705_ = true;
                                                            }
                                                            let _e12258 = phi_10705_;
                                                            phi_10706_ = _e12258;
                                                        } else {
                                                            phi_10706_ = true;
                                                        }
                                                        let _e12260 = phi_10706_;
                                                        if _e12260 {
                                                            local_16 = type_30(array<f32, 4>(_e11999.member[0], _e11999.member[1], _e11999.member[2], _e11999.member[3]), array<f32, 4>(_e11999.member_1[0], _e11999.member_1[1], _e11999.member_1[2], _e11999.member_1[3]), array<f32, 4>(_e11999.member_2[0], _e11999.member_2[1], _e11999.member_2[2], _e11999.member_2[3]));
                                                            let _e12282 = local_16.member[0u];
                                                            let _e12285 = local_16.member_1[0u];
                                                            let _e12288 = local_16.member_2[0u];
                                                            if (_e12282 > _e12288) {
                                                                if (_e12285 > _e12288) {
                                                                    phi_10780_ = false;
                                                                } else {
                                                                    phi_10780_ = true;
                                                                }
                                                                let _e12292 = phi_10780_;
                                                                phi_10781_ = _e12292;
                                                            } else {
                                                                phi_10781_ = true;
                                                            }
                                                            let _e12294 = phi_10781_;
                                                            if _e12294 {
                                                                let _e12295 = (_e12285 >= _e12282);
                                                                if _e12295 {
                                                                    phi_10803_ = f32();
                                                                    phi_10804_ = false;
                                                                } else {
                                                                    if ((_e12282 - _e12285) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                        phi_10801_ = (((_e12282 - _e12288) / (_e12282 - _e12285)) * (1f - (0.000000059604645f * 16f)));
                                                                        phi_10802_ = false;
                                                                    } else {
                                                                        phi_10801_ = f32();
                                                                        phi_10802_ = true;
                                                                    }
                                                                    let _e12306 = phi_10801_;
                                                                    let _e12308 = phi_10802_;
                                                                    phi_10803_ = _e12306;
                                                                    phi_10804_ = _e12308;
                                                                }
                                                                let _e12310 = phi_10803_;
                                                                let _e12312 = phi_10804_;
                                                                phi_10805_ = _e12310;
                                                                phi_10806_ = _e12295;
                                                                phi_10807_ = _e12312;
                                                            } else {
                                                                phi_10805_ = f32();
                                                                phi_10806_ = true;
                                                                phi_10807_ = false;
                                                            }
                                                            let _e12314 = phi_10805_;
                                                            let _e12316 = phi_10806_;
                                                            let _e12318 = phi_10807_;
                                                            if _e12316 {
                                                                phi_10811_ = 2f;
                                                                phi_10812_ = true;
                                                            } else {
                                                                phi_10811_ = _e11691;
                                                                phi_10812_ = _e12318;
                                                            }
                                                            let _e12320 = phi_10811_;
                                                            let _e12322 = phi_10812_;
                                                            if _e12322 {
                                                                phi_10816_ = _e12320;
                                                            } else {
                                                                phi_10816_ = _e12314;
                                                            }
                                                            let _e12324 = phi_10816_;
                                                            let _e12327 = local_16.member[1u];
                                                            let _e12330 = local_16.member_1[1u];
                                                            let _e12333 = local_16.member_2[1u];
                                                            if (_e12327 > _e12333) {
                                                                if (_e12330 > _e12333) {
                                                                    phi_10848_ = false;
                                                                } else {
                                                                    phi_10848_ = true;
                                                                }
                                                                let _e12337 = phi_10848_;
                                                                phi_10849_ = _e12337;
                                                            } else {
                                                                phi_10849_ = true;
                                                            }
                                                            let _e12339 = phi_10849_;
                                                            if _e12339 {
                                                                let _e12340 = (_e12330 >= _e12327);
                                                                if _e12340 {
                                                                    phi_10871_ = f32();
                                                                    phi_10872_ = false;
                                                                } else {
                                                                    if ((_e12327 - _e12330) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                        phi_10869_ = (((_e12327 - _e12333) / (_e12327 - _e12330)) * (1f - (0.000000059604645f * 16f)));
                                                                        phi_10870_ = false;
                                                                    } else {
                                                                        phi_10869_ = f32();
                                                                        phi_10870_ = true;
                                                                    }
                                                                    let _e12351 = phi_10869_;
                                                                    let _e12353 = phi_10870_;
                                                                    phi_10871_ = _e12351;
                                                                    phi_10872_ = _e12353;
                                                                }
                                                                let _e12355 = phi_10871_;
                                                                let _e12357 = phi_10872_;
                                                                phi_10873_ = _e12355;
                                                                phi_10874_ = _e12340;
                                                                phi_10875_ = _e12357;
                                                            } else {
                                                                phi_10873_ = f32();
                                                                phi_10874_ = true;
                                                                phi_10875_ = false;
                                                            }
                                                            let _e12359 = phi_10873_;
                                                            let _e12361 = phi_10874_;
                                                            let _e12363 = phi_10875_;
                                                            if _e12361 {
                                                                phi_10879_ = 2f;
                                                                phi_10880_ = true;
                                                            } else {
                                                                phi_10879_ = _e11691;
                                                                phi_10880_ = _e12363;
                                                            }
                                                            let _e12365 = phi_10879_;
                                                            let _e12367 = phi_10880_;
                                                            if _e12367 {
                                                                phi_10884_ = _e12365;
                                                            } else {
                                                                phi_10884_ = _e12359;
                                                            }
                                                            let _e12369 = phi_10884_;
                                                            if (_e12324 < _e12369) {
                                                                phi_10889_ = _e12324;
                                                            } else {
                                                                phi_10889_ = _e12369;
                                                            }
                                                            let _e12372 = phi_10889_;
                                                            let _e12375 = local_16.member[2u];
                                                            let _e12378 = local_16.member_1[2u];
                                                            let _e12381 = local_16.member_2[2u];
                                                            if (_e12375 > _e12381) {
                                                                if (_e12378 > _e12381) {
                                                                    phi_10921_ = false;
                                                                } else {
                                                                    phi_10921_ = true;
                                                                }
                                                                let _e12385 = phi_10921_;
                                                                phi_10922_ = _e12385;
                                                            } else {
                                                                phi_10922_ = true;
                                                            }
                                                            let _e12387 = phi_10922_;
                                                            if _e12387 {
                                                                let _e12388 = (_e12378 >= _e12375);
                                                                if _e12388 {
                                                                    phi_10944_ = f32();
                                                                    phi_10945_ = false;
                                                                } else {
                                                                    if ((_e12375 - _e12378) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                        phi_10942_ = (((_e12375 - _e12381) / (_e12375 - _e12378)) * (1f - (0.000000059604645f * 16f)));
                                                                        phi_10943_ = false;
                                                                    } else {
                                                                        phi_10942_ = f32();
                                                                        phi_10943_ = true;
                                                                    }
                                                                    let _e12399 = phi_10942_;
                                                                    let _e12401 = phi_10943_;
                                                                    phi_10944_ = _e12399;
                                                                    phi_10945_ = _e12401;
                                                                }
                                                                let _e12403 = phi_10944_;
                                                                let _e12405 = phi_10945_;
                                                                phi_10946_ = _e12403;
                                                                phi_10947_ = _e12388;
                                                                phi_10948_ = _e12405;
                                                            } else {
                                                                phi_10946_ = f32();
                                                                phi_10947_ = true;
                                                                phi_10948_ = false;
                                                            }
                                                            let _e12407 = phi_10946_;
                                                            let _e12409 = phi_10947_;
                                                            let _e12411 = phi_10948_;
                                                            if _e12409 {
                                                                phi_10952_ = 2f;
                                                                phi_10953_ = true;
                                                            } else {
                                                                phi_10952_ = _e11691;
                                                                phi_10953_ = _e12411;
                                                            }
                                                            let _e12413 = phi_10952_;
                                                            let _e12415 = phi_10953_;
                                                            if _e12415 {
                                                                phi_10957_ = _e12413;
                                                            } else {
                                                                phi_10957_ = _e12407;
                                                            }
                                                            let _e12417 = phi_10957_;
                                                            let _e12420 = local_16.member[3u];
                                                            let _e12423 = local_16.member_1[3u];
                                                            let _e12426 = local_16.member_2[3u];
                                                            if (_e12420 > _e12426) {
                                                                if (_e12423 > _e12426) {
                                                                    phi_10989_ = false;
                                                                } else {
                                                                    phi_10989_ = true;
                                                                }
                                                                let _e12430 = phi_10989_;
                                                                phi_10990_ = _e12430;
                                                            } else {
                                                                phi_10990_ = true;
                                                            }
                                                            let _e12432 = phi_10990_;
                                                            if _e12432 {
                                                                let _e12433 = (_e12423 >= _e12420);
                                                                if _e12433 {
                                                                    phi_11012_ = f32();
                                                                    phi_11013_ = false;
                                                                } else {
                                                                    if ((_e12420 - _e12423) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                        phi_11010_ = (((_e12420 - _e12426) / (_e12420 - _e12423)) * (1f - (0.000000059604645f * 16f)));
                                                                        phi_11011_ = false;
                                                                    } else {
                                                                        phi_11010_ = f32();
                                                                        phi_11011_ = true;
                                                                    }
                                                                    let _e12444 = phi_11010_;
                                                                    let _e12446 = phi_11011_;
                                                                    phi_11012_ = _e12444;
                                                                    phi_11013_ = _e12446;
                                                                }
                                                                let _e12448 = phi_11012_;
                                                                let _e12450 = phi_11013_;
                                                                phi_11014_ = _e12448;
                                                                phi_11015_ = _e12433;
                                                                phi_11016_ = _e12450;
                                                            } else {
                                                                phi_11014_ = f32();
                                                                phi_11015_ = true;
                                                                phi_11016_ = false;
                                                            }
                                                            let _e12452 = phi_11014_;
                                                            let _e12454 = phi_11015_;
                                                            let _e12456 = phi_11016_;
                                                            if _e12454 {
                                                                phi_11020_ = 2f;
                                                                phi_11021_ = true;
                                                            } else {
                                                                phi_11020_ = _e11691;
                                                                phi_11021_ = _e12456;
                                                            }
                                                            let _e12458 = phi_11020_;
                                                            let _e12460 = phi_11021_;
                                                            if _e12460 {
                                                                phi_11025_ = _e12458;
                                                            } else {
                                                                phi_11025_ = _e12452;
                                                            }
                                                            let _e12462 = phi_11025_;
                                                            if (_e12417 < _e12462) {
                                                                phi_11030_ = _e12417;
                                                            } else {
                                                                phi_11030_ = _e12462;
                                                            }
                                                            let _e12465 = phi_11030_;
                                                            if (_e12372 < _e12465) {
                                                                phi_11035_ = _e12372;
                                                            } else {
                                                                phi_11035_ = _e12465;
                                                            }
                                                            let _e12468 = phi_11035_;
                                                            if (_e12468 > _e11691) {
                                                                phi_11040_ = _e12468;
                                                            } else {
                                                                phi_11040_ = _e11691;
                                                            }
                                                            let _e12471 = phi_11040_;
                                                            let _e12472 = (_e12471 > _e5623);
                                                            if _e12472 {
                                                                phi_11545_ = f32();
                                                                phi_11546_ = f32();
                                                                phi_11547_ = false;
                                                                phi_11548_ = false;
                                                            } else {
                                                                let _e12473 = (_e12471 - _e11691);
                                                                let _e12474 = (_e12473 <= _e11686);
                                                                let _e12476 = (_e12471 + (_e5619 * 0.01f));
                                                                if (_e12476 < _e5623) {
                                                                    phi_11053_ = _e12476;
                                                                } else {
                                                                    phi_11053_ = _e5623;
                                                                }
                                                                let _e12479 = phi_11053_;
                                                                if _e12474 {
                                                                    if (_e5889.member_1 > 0f) {
                                                                        let _e12483 = local_18.member[0u];
                                                                        let _e12489 = local_18.member[1u];
                                                                        let _e12505 = local_18.member_1[0u];
                                                                        let _e12511 = local_18.member_1[1u];
                                                                        let _e12527 = local_18.member_2[0u];
                                                                        let _e12533 = local_18.member_2[1u];
                                                                        let _e12547 = function_4(array<f32, 3>((_e12483[0] + ((_e12489[0] - _e12483[0]) * _e12479)), (_e12483[1] + ((_e12489[1] - _e12483[1]) * _e12479)), (_e12483[2] + ((_e12489[2] - _e12483[2]) * _e12479))), array<f32, 3>((_e12505[0] + ((_e12511[0] - _e12505[0]) * _e12479)), (_e12505[1] + ((_e12511[1] - _e12505[1]) * _e12479)), (_e12505[2] + ((_e12511[2] - _e12505[2]) * _e12479))), array<f32, 3>((_e12527[0] + ((_e12533[0] - _e12527[0]) * _e12479)), (_e12527[1] + ((_e12533[1] - _e12527[1]) * _e12479)), (_e12527[2] + ((_e12533[2] - _e12527[2]) * _e12479))), _e316.member);
                                                                        let _e12558 = (((_e12547[0] * _e12547[0]) + (_e12547[1] * _e12547[1])) + (_e12547[2] * _e12547[2]));
                                                                        if (_e12558 <= 0.000000000000000000000000000000000000011754944f) {
                                                                            if (_e12558 > 0f) {
                                                                                phi_11183_ = (0.000000000000000000106433627f * 2f);
                                                                            } else {
                                                                                phi_11183_ = 0f;
                                                                            }
                                                                            let _e12611 = phi_11183_;
                                                                            phi_11247_ = _e12611;
                                                                        } else {
                                                                            phi_11190_ = type_14(0i, 5i);
                                                                            phi_11193_ = bitcast<f32>(((bitcast<u32>(_e12558) >> bitcast<u32>(1i)) + 532369198u));
                                                                            loop {
                                                                                let _e12566 = phi_11190_;
                                                                                let _e12568 = phi_11193_;
                                                                                local_107 = _e12568;
                                                                                if (_e12566.member < _e12566.member_1) {
                                                                                    let _e12575 = (_e12566.member + 1i);
                                                                                    if ((false == (_e12575 > _e12566.member)) != false) {
                                                                                        phi_11214_ = true;
                                                                                    } else {
                                                                                        phi_11214_ = false;
                                                                                    }
                                                                                    let _e12580 = phi_11214_;
                                                                                    if _e12580 {
                                                                                        phi_11220_ = type_15(0u, type_15().member_1);
                                                                                    } else {
                                                                                        phi_11220_ = type_15(1u, _e12575);
                                                                                    }
                                                                                    let _e12585 = phi_11220_;
                                                                                    phi_11191_ = type_14(_e12585.member_1, _e12566.member_1);
                                                                                    phi_11234_ = type_15(1u, _e12566.member);
                                                                                } else {
                                                                                    phi_11191_ = _e12566;
                                                                                    phi_11234_ = type_15(0u, type_15().member_1);
                                                                                }
                                                                                let _e12591 = phi_11191_;
                                                                                let _e12593 = phi_11234_;
                                                                                let _e12596 = (bitcast<i32>(_e12593.member) != 0i);
                                                                                if _e12596 {
                                                                                    phi_11194_ = (0.5f * (_e12568 + (_e12558 / _e12568)));
                                                                                } else {
                                                                                    phi_11194_ = f32();
                                                                                }
                                                                                let _e12601 = phi_11194_;
                                                                                continue;
                                                                                continuing {
                                                                                    phi_11190_ = _e12591;
                                                                                    phi_11193_ = _e12601;
                                                                                    break if !(_e12596);
                                                                                }
                                                                            }
                                                                            let _e12606 = local_107;
                                                                            phi_11247_ = (_e12606 * (1f + (8f * 0.000000059604645f)));
                                                                        }
                                                                        let _e12613 = phi_11247_;
                                                                        let _e12619 = local_18.member[0u];
                                                                        if (_e12619[0] < 0f) {
                                                                            phi_11263_ = -(_e12619[0]);
                                                                        } else {
                                                                            phi_11263_ = _e12619[0];
                                                                        }
                                                                        let _e12626 = phi_11263_;
                                                                        if (_e12619[1] < 0f) {
                                                                            phi_11270_ = -(_e12619[1]);
                                                                        } else {
                                                                            phi_11270_ = _e12619[1];
                                                                        }
                                                                        let _e12630 = phi_11270_;
                                                                        if (_e12626 > _e12630) {
                                                                            phi_11275_ = _e12626;
                                                                        } else {
                                                                            phi_11275_ = _e12630;
                                                                        }
                                                                        let _e12633 = phi_11275_;
                                                                        if (_e12619[2] < 0f) {
                                                                            phi_11282_ = -(_e12619[2]);
                                                                        } else {
                                                                            phi_11282_ = _e12619[2];
                                                                        }
                                                                        let _e12637 = phi_11282_;
                                                                        if (_e12633 > _e12637) {
                                                                            phi_11287_ = _e12633;
                                                                        } else {
                                                                            phi_11287_ = _e12637;
                                                                        }
                                                                        let _e12640 = phi_11287_;
                                                                        let _e12643 = local_18.member[1u];
                                                                        if (_e12643[0] < 0f) {
                                                                            phi_11300_ = -(_e12643[0]);
                                                                        } else {
                                                                            phi_11300_ = _e12643[0];
                                                                        }
                                                                        let _e12650 = phi_11300_;
                                                                        if (_e12643[1] < 0f) {
                                                                            phi_11307_ = -(_e12643[1]);
                                                                        } else {
                                                                            phi_11307_ = _e12643[1];
                                                                        }
                                                                        let _e12654 = phi_11307_;
                                                                        if (_e12650 > _e12654) {
                                                                            phi_11312_ = _e12650;
                                                                        } else {
                                                                            phi_11312_ = _e12654;
                                                                        }
                                                                        let _e12657 = phi_11312_;
                                                                        if (_e12643[2] < 0f) {
                                                                            phi_11319_ = -(_e12643[2]);
                                                                        } else {
                                                                            phi_11319_ = _e12643[2];
                                                                        }
                                                                        let _e12661 = phi_11319_;
                                                                        if (_e12657 > _e12661) {
                                                                            phi_11324_ = _e12657;
                                                                        } else {
                                                                            phi_11324_ = _e12661;
                                                                        }
                                                                        let _e12664 = phi_11324_;
                                                                        if (_e12640 > _e12664) {
                                                                            phi_11329_ = _e12640;
                                                                        } else {
                                                                            phi_11329_ = _e12664;
                                                                        }
                                                                        let _e12667 = phi_11329_;
                                                                        let _e12669 = local_18.member_3;
                                                                        let _e12673 = local_18.member_1[0u];
                                                                        if (_e12673[0] < 0f) {
                                                                            phi_11346_ = -(_e12673[0]);
                                                                        } else {
                                                                            phi_11346_ = _e12673[0];
                                                                        }
                                                                        let _e12680 = phi_11346_;
                                                                        if (_e12673[1] < 0f) {
                                                                            phi_11353_ = -(_e12673[1]);
                                                                        } else {
                                                                            phi_11353_ = _e12673[1];
                                                                        }
                                                                        let _e12684 = phi_11353_;
                                                                        if (_e12680 > _e12684) {
                                                                            phi_11358_ = _e12680;
                                                                        } else {
                                                                            phi_11358_ = _e12684;
                                                                        }
                                                                        let _e12687 = phi_11358_;
                                                                        if (_e12673[2] < 0f) {
                                                                            phi_11365_ = -(_e12673[2]);
                                                                        } else {
                                                                            phi_11365_ = _e12673[2];
                                                                        }
                                                                        let _e12691 = phi_11365_;
                                                                        if (_e12687 > _e12691) {
                                                                            phi_11370_ = _e12687;
                                                                        } else {
                                                                            phi_11370_ = _e12691;
                                                                        }
                                                                        let _e12694 = phi_11370_;
                                                                        let _e12697 = local_18.member_1[1u];
                                                                        if (_e12697[0] < 0f) {
                                                                            phi_11384_ = -(_e12697[0]);
                                                                        } else {
                                                                            phi_11384_ = _e12697[0];
                                                                        }
                                                                        let _e12704 = phi_11384_;
                                                                        if (_e12697[1] < 0f) {
                                                                            phi_11391_ = -(_e12697[1]);
                                                                        } else {
                                                                            phi_11391_ = _e12697[1];
                                                                        }
                                                                        let _e12708 = phi_11391_;
                                                                        if (_e12704 > _e12708) {
                                                                            phi_11396_ = _e12704;
                                                                        } else {
                                                                            phi_11396_ = _e12708;
                                                                        }
                                                                        let _e12711 = phi_11396_;
                                                                        if (_e12697[2] < 0f) {
                                                                            phi_11403_ = -(_e12697[2]);
                                                                        } else {
                                                                            phi_11403_ = _e12697[2];
                                                                        }
                                                                        let _e12715 = phi_11403_;
                                                                        if (_e12711 > _e12715) {
                                                                            phi_11408_ = _e12711;
                                                                        } else {
                                                                            phi_11408_ = _e12715;
                                                                        }
                                                                        let _e12718 = phi_11408_;
                                                                        if (_e12694 > _e12718) {
                                                                            phi_11413_ = _e12694;
                                                                        } else {
                                                                            phi_11413_ = _e12718;
                                                                        }
                                                                        let _e12721 = phi_11413_;
                                                                        let _e12723 = local_18.member_3;
                                                                        let _e12727 = local_18.member_2[0u];
                                                                        if (_e12727[0] < 0f) {
                                                                            phi_11430_ = -(_e12727[0]);
                                                                        } else {
                                                                            phi_11430_ = _e12727[0];
                                                                        }
                                                                        let _e12734 = phi_11430_;
                                                                        if (_e12727[1] < 0f) {
                                                                            phi_11437_ = -(_e12727[1]);
                                                                        } else {
                                                                            phi_11437_ = _e12727[1];
                                                                        }
                                                                        let _e12738 = phi_11437_;
                                                                        if (_e12734 > _e12738) {
                                                                            phi_11442_ = _e12734;
                                                                        } else {
                                                                            phi_11442_ = _e12738;
                                                                        }
                                                                        let _e12741 = phi_11442_;
                                                                        if (_e12727[2] < 0f) {
                                                                            phi_11449_ = -(_e12727[2]);
                                                                        } else {
                                                                            phi_11449_ = _e12727[2];
                                                                        }
                                                                        let _e12745 = phi_11449_;
                                                                        if (_e12741 > _e12745) {
                                                                            phi_11454_ = _e12741;
                                                                        } else {
                                                                            phi_11454_ = _e12745;
                                                                        }
                                                                        let _e12748 = phi_11454_;
                                                                        let _e12751 = local_18.member_2[1u];
                                                                        if (_e12751[0] < 0f) {
                                                                            phi_11468_ = -(_e12751[0]);
                                                                        } else {
                                                                            phi_11468_ = _e12751[0];
                                                                        }
                                                                        let _e12758 = phi_11468_;
                                                                        if (_e12751[1] < 0f) {
                                                                            phi_11475_ = -(_e12751[1]);
                                                                        } else {
                                                                            phi_11475_ = _e12751[1];
                                                                        }
                                                                        let _e12762 = phi_11475_;
                                                                        if (_e12758 > _e12762) {
                                                                            phi_11480_ = _e12758;
                                                                        } else {
                                                                            phi_11480_ = _e12762;
                                                                        }
                                                                        let _e12765 = phi_11480_;
                                                                        if (_e12751[2] < 0f) {
                                                                            phi_11487_ = -(_e12751[2]);
                                                                        } else {
                                                                            phi_11487_ = _e12751[2];
                                                                        }
                                                                        let _e12769 = phi_11487_;
                                                                        if (_e12765 > _e12769) {
                                                                            phi_11492_ = _e12765;
                                                                        } else {
                                                                            phi_11492_ = _e12769;
                                                                        }
                                                                        let _e12772 = phi_11492_;
                                                                        if (_e12748 > _e12772) {
                                                                            phi_11497_ = _e12748;
                                                                        } else {
                                                                            phi_11497_ = _e12772;
                                                                        }
                                                                        let _e12775 = phi_11497_;
                                                                        let _e12777 = local_18.member_3;
                                                                        let _e12784 = local_18.member_3;
                                                                        if (((_e12613 * (1f + (0.000000059604645f * 8f))) + (((((((_e12667 + _e12669) + (_e12721 + _e12723)) + (_e12775 + _e12777)) * (0.000000059604645f * 16f)) + (_e12784 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e5889.member_1) {
                                                                            phi_11517_ = false;
                                                                        } else {
                                                                            phi_11517_ = true;
                                                                        }
                                                                        let _e12793 = phi_11517_;
                                                                        phi_11518_ = _e12793;
                                                                    } else {
                                                                        phi_11518_ = true;
                                                                    }
                                                                    let _e12795 = phi_11518_;
                                                                    phi_11519_ = _e12795;
                                                                } else {
                                                                    phi_11519_ = true;
                                                                }
                                                                let _e12797 = phi_11519_;
                                                                if _e12797 {
                                                                    if _e11699 {
                                                                        if _e12474 {
                                                                            phi_11535_ = true;
                                                                        } else {
                                                                            if (_e12473 <= (_e11695 * 0.25f)) {
                                                                                phi_11534_ = false;
                                                                            } else {
                                                                                phi_11534_ = true;
                                                                            }
                                                                            let _e12802 = phi_11534_;
                                                                            phi_11535_ = _e12802;
                                                                        }
                                                                        let _e12804 = phi_11535_;
                                                                        if _e12804 {
                                                                            phi_11540_ = (_e12019 + _e12019);
                                                                        } else {
                                                                            phi_11540_ = 0f;
                                                                        }
                                                                        let _e12807 = phi_11540_;
                                                                        phi_11542_ = _e12807;
                                                                    } else {
                                                                        phi_11542_ = (_e5623 - _e11691);
                                                                    }
                                                                    let _e12809 = phi_11542_;
                                                                    phi_11543_ = _e12809;
                                                                    phi_11544_ = false;
                                                                } else {
                                                                    phi_11543_ = f32();
                                                                    phi_11544_ = true;
                                                                }
                                                                let _e12811 = phi_11543_;
                                                                let _e12813 = phi_11544_;
                                                                phi_11545_ = _e12811;
                                                                phi_11546_ = _e12473;
                                                                phi_11547_ = _e12797;
                                                                phi_11548_ = _e12813;
                                                            }
                                                            let _e12815 = phi_11545_;
                                                            let _e12817 = phi_11546_;
                                                            let _e12819 = phi_11547_;
                                                            let _e12821 = phi_11548_;
                                                            phi_11549_ = _e12471;
                                                            phi_11550_ = _e12815;
                                                            phi_11551_ = _e12817;
                                                            phi_11552_ = _e12471;
                                                            phi_11553_ = _e12819;
                                                            phi_11554_ = _e12472;
                                                            phi_11555_ = _e12821;
                                                            phi_11556_ = false;
                                                        } else {
                                                            phi_11549_ = f32();
                                                            phi_11550_ = f32();
                                                            phi_11551_ = f32();
                                                            phi_11552_ = f32();
                                                            phi_11553_ = false;
                                                            phi_11554_ = false;
                                                            phi_11555_ = false;
                                                            phi_11556_ = true;
                                                        }
                                                        let _e12823 = phi_11549_;
                                                        let _e12825 = phi_11550_;
                                                        let _e12827 = phi_11551_;
                                                        let _e12829 = phi_11552_;
                                                        let _e12831 = phi_11553_;
                                                        let _e12833 = phi_11554_;
                                                        let _e12835 = phi_11555_;
                                                        let _e12837 = phi_11556_;
                                                        phi_11557_ = _e12823;
                                                        phi_11558_ = _e12825;
                                                        phi_11559_ = _e12827;
                                                        phi_11560_ = _e12829;
                                                        phi_11561_ = false;
                                                        phi_11562_ = _e12831;
                                                        phi_11563_ = _e12833;
                                                        phi_11564_ = _e12835;
                                                        phi_11565_ = _e12837;
                                                    } else {
                                                        phi_11557_ = f32();
                                                        phi_11558_ = f32();
                                                        phi_11559_ = f32();
                                                        phi_11560_ = f32();
                                                        phi_11561_ = true;
                                                        phi_11562_ = false;
                                                        phi_11563_ = false;
                                                        phi_11564_ = false;
                                                        phi_11565_ = false;
                                                    }
                                                    let _e12839 = phi_11557_;
                                                    let _e12841 = phi_11558_;
                                                    let _e12843 = phi_11559_;
                                                    let _e12845 = phi_11560_;
                                                    let _e12847 = phi_11561_;
                                                    let _e12849 = phi_11562_;
                                                    let _e12851 = phi_11563_;
                                                    let _e12853 = phi_11564_;
                                                    let _e12855 = phi_11565_;
                                                    phi_11566_ = _e12839;
                                                    phi_11567_ = _e12841;
                                                    phi_11568_ = _e12843;
                                                    phi_11569_ = _e12845;
                                                    phi_11570_ = _e12847;
                                                    phi_11571_ = _e12849;
                                                    phi_11572_ = _e12851;
                                                    phi_11573_ = _e12853;
                                                    phi_11574_ = _e12855;
                                                } else {
                                                    phi_11566_ = f32();
                                                    phi_11567_ = f32();
                                                    phi_11568_ = f32();
                                                    phi_11569_ = f32();
                                                    phi_11570_ = true;
                                                    phi_11571_ = false;
                                                    phi_11572_ = false;
                                                    phi_11573_ = false;
                                                    phi_11574_ = false;
                                                }
                                                let _e12857 = phi_11566_;
                                                let _e12859 = phi_11567_;
                                                let _e12861 = phi_11568_;
                                                let _e12863 = phi_11569_;
                                                let _e12865 = phi_11570_;
                                                let _e12867 = phi_11571_;
                                                let _e12869 = phi_11572_;
                                                let _e12871 = phi_11573_;
                                                let _e12873 = phi_11574_;
                                                if _e12865 {
                                                    if (_e11691 <= _e11693) {
                                                        let _e13034 = (_e11701 + 1u);
                                                        let _e13035 = (_e13034 > 3u);
                                                        if _e13035 {
                                                            phi_11587_ = false;
                                                        } else {
                                                            phi_11587_ = true;
                                                        }
                                                        let _e13037 = phi_11587_;
                                                        phi_11909_ = _e13034;
                                                        phi_11910_ = f32();
                                                        phi_11911_ = false;
                                                        phi_11912_ = _e13037;
                                                        phi_11913_ = _e13035;
                                                    } else {
                                                        let _e12877 = local_16.member[0u];
                                                        let _e12880 = local_16.member_1[0u];
                                                        let _e12883 = local_16.member[0u];
                                                        let _e12889 = local_16.member_2[0u];
                                                        let _e12890 = ((_e12877 + ((_e12880 - _e12883) * _e11697)) - _e12889);
                                                        let _e12893 = local_16.member[1u];
                                                        let _e12896 = local_16.member_1[1u];
                                                        let _e12899 = local_16.member[1u];
                                                        let _e12905 = local_16.member_2[1u];
                                                        let _e12906 = ((_e12893 + ((_e12896 - _e12899) * _e11697)) - _e12905);
                                                        if (_e12890 < _e12906) {
                                                            phi_11660_ = _e12890;
                                                        } else {
                                                            phi_11660_ = _e12906;
                                                        }
                                                        let _e12909 = phi_11660_;
                                                        let _e12912 = local_16.member[2u];
                                                        let _e12915 = local_16.member_1[2u];
                                                        let _e12918 = local_16.member[2u];
                                                        let _e12924 = local_16.member_2[2u];
                                                        let _e12925 = ((_e12912 + ((_e12915 - _e12918) * _e11697)) - _e12924);
                                                        let _e12928 = local_16.member[3u];
                                                        let _e12931 = local_16.member_1[3u];
                                                        let _e12934 = local_16.member[3u];
                                                        let _e12940 = local_16.member_2[3u];
                                                        let _e12941 = ((_e12928 + ((_e12931 - _e12934) * _e11697)) - _e12940);
                                                        if (_e12925 < _e12941) {
                                                            phi_11733_ = _e12925;
                                                        } else {
                                                            phi_11733_ = _e12941;
                                                        }
                                                        let _e12944 = phi_11733_;
                                                        if (_e12909 < _e12944) {
                                                            phi_11738_ = _e12909;
                                                        } else {
                                                            phi_11738_ = _e12944;
                                                        }
                                                        let _e12947 = phi_11738_;
                                                        let _e12950 = local_17.member[0u];
                                                        let _e12953 = local_17.member_1[0u];
                                                        let _e12956 = local_17.member[0u];
                                                        let _e12962 = local_17.member_2[0u];
                                                        let _e12963 = ((_e12950 + ((_e12953 - _e12956) * _e11691)) - _e12962);
                                                        let _e12966 = local_17.member[1u];
                                                        let _e12969 = local_17.member_1[1u];
                                                        let _e12972 = local_17.member[1u];
                                                        let _e12978 = local_17.member_2[1u];
                                                        let _e12979 = ((_e12966 + ((_e12969 - _e12972) * _e11691)) - _e12978);
                                                        if (_e12963 < _e12979) {
                                                            phi_11811_ = _e12963;
                                                        } else {
                                                            phi_11811_ = _e12979;
                                                        }
                                                        let _e12982 = phi_11811_;
                                                        let _e12985 = local_17.member[2u];
                                                        let _e12988 = local_17.member_1[2u];
                                                        let _e12991 = local_17.member[2u];
                                                        let _e12997 = local_17.member_2[2u];
                                                        let _e12998 = ((_e12985 + ((_e12988 - _e12991) * _e11691)) - _e12997);
                                                        let _e13001 = local_17.member[3u];
                                                        let _e13004 = local_17.member_1[3u];
                                                        let _e13007 = local_17.member[3u];
                                                        let _e13013 = local_17.member_2[3u];
                                                        let _e13014 = ((_e13001 + ((_e13004 - _e13007) * _e11691)) - _e13013);
                                                        if (_e12998 < _e13014) {
                                                            phi_11884_ = _e12998;
                                                        } else {
                                                            phi_11884_ = _e13014;
                                                        }
                                                        let _e13017 = phi_11884_;
                                                        if (_e12982 < _e13017) {
                                                            phi_11889_ = _e12982;
                                                        } else {
                                                            phi_11889_ = _e13017;
                                                        }
                                                        let _e13020 = phi_11889_;
                                                        if (_e13020 > 0f) {
                                                            phi_11907_ = 0.5f;
                                                        } else {
                                                            let _e13024 = (0.95f * (_e12947 / (_e12947 - _e13020)));
                                                            if (_e13024 > 0.0625f) {
                                                                if (_e13024 < 0.9f) {
                                                                    phi_11905_ = _e13024;
                                                                } else {
                                                                    phi_11905_ = 0.9f;
                                                                }
                                                                let _e13028 = phi_11905_;
                                                                phi_11906_ = _e13028;
                                                            } else {
                                                                phi_11906_ = 0.0625f;
                                                            }
                                                            let _e13030 = phi_11906_;
                                                            phi_11907_ = _e13030;
                                                        }
                                                        let _e13032 = phi_11907_;
                                                        phi_11909_ = u32();
                                                        phi_11910_ = (_e12019 * _e13032);
                                                        phi_11911_ = true;
                                                        phi_11912_ = false;
                                                        phi_11913_ = false;
                                                    }
                                                    let _e13039 = phi_11909_;
                                                    let _e13041 = phi_11910_;
                                                    let _e13043 = phi_11911_;
                                                    let _e13045 = phi_11912_;
                                                    let _e13047 = phi_11913_;
                                                    phi_11914_ = _e13039;
                                                    phi_11915_ = _e11693;
                                                    phi_11916_ = _e13041;
                                                    phi_11917_ = _e11695;
                                                    phi_11918_ = _e11697;
                                                    phi_11919_ = _e11699;
                                                    phi_11920_ = _e11701;
                                                    phi_11921_ = _e13043;
                                                    phi_11922_ = _e13045;
                                                    phi_11923_ = _e13047;
                                                    phi_11924_ = false;
                                                    phi_11925_ = false;
                                                    phi_11926_ = false;
                                                } else {
                                                    phi_11914_ = u32();
                                                    phi_11915_ = _e12857;
                                                    phi_11916_ = _e12859;
                                                    phi_11917_ = _e12861;
                                                    phi_11918_ = _e11691;
                                                    phi_11919_ = true;
                                                    phi_11920_ = 0u;
                                                    phi_11921_ = _e12867;
                                                    phi_11922_ = false;
                                                    phi_11923_ = false;
                                                    phi_11924_ = _e12869;
                                                    phi_11925_ = _e12871;
                                                    phi_11926_ = _e12873;
                                                }
                                                let _e13049 = phi_11914_;
                                                let _e13051 = phi_11915_;
                                                let _e13053 = phi_11916_;
                                                let _e13055 = phi_11917_;
                                                let _e13057 = phi_11918_;
                                                let _e13059 = phi_11919_;
                                                let _e13061 = phi_11920_;
                                                let _e13063 = phi_11921_;
                                                let _e13065 = phi_11922_;
                                                let _e13067 = phi_11923_;
                                                let _e13069 = phi_11924_;
                                                let _e13071 = phi_11925_;
                                                let _e13073 = phi_11926_;
                                                if _e13063 {
                                                    let _e13074 = (_e13057 + _e13053);
                                                    if (_e13074 > _e13051) {
                                                        phi_11935_ = _e13074;
                                                    } else {
                                                        phi_11935_ = _e13051;
                                                    }
                                                    let _e13077 = phi_11935_;
                                                    if (_e13077 < _e5623) {
                                                        phi_11940_ = _e13077;
                                                    } else {
                                                        phi_11940_ = _e5623;
                                                    }
                                                    let _e13080 = phi_11940_;
                                                    if !(_e11699) {
                                                        phi_11949_ = true;
                                                    } else {
                                                        phi_11949_ = ((_e13080 - _e13057) > _e11686);
                                                    }
                                                    let _e13084 = phi_11949_;
                                                    if _e13084 {
                                                        phi_11953_ = false;
                                                    } else {
                                                        phi_11953_ = true;
                                                    }
                                                    let _e13086 = phi_11953_;
                                                    phi_11954_ = _e13080;
                                                    phi_11955_ = _e13051;
                                                    phi_11956_ = _e13055;
                                                    phi_11957_ = _e13057;
                                                    phi_11958_ = _e13059;
                                                    phi_11959_ = _e13061;
                                                    phi_11960_ = _e13084;
                                                    phi_11961_ = _e13086;
                                                    phi_11962_ = false;
                                                    phi_11963_ = false;
                                                    phi_11964_ = false;
                                                    phi_11965_ = false;
                                                } else {
                                                    phi_11954_ = _e11691;
                                                    phi_11955_ = _e11693;
                                                    phi_11956_ = _e11695;
                                                    phi_11957_ = _e11697;
                                                    phi_11958_ = _e11699;
                                                    phi_11959_ = _e13049;
                                                    phi_11960_ = _e13065;
                                                    phi_11961_ = false;
                                                    phi_11962_ = _e13067;
                                                    phi_11963_ = _e13069;
                                                    phi_11964_ = _e13071;
                                                    phi_11965_ = _e13073;
                                                }
                                                let _e13088 = phi_11954_;
                                                let _e13090 = phi_11955_;
                                                let _e13092 = phi_11956_;
                                                let _e13094 = phi_11957_;
                                                let _e13096 = phi_11958_;
                                                let _e13098 = phi_11959_;
                                                let _e13100 = phi_11960_;
                                                let _e13102 = phi_11961_;
                                                let _e13104 = phi_11962_;
                                                let _e13106 = phi_11963_;
                                                let _e13108 = phi_11964_;
                                                let _e13110 = phi_11965_;
                                                phi_9787_ = _e13088;
                                                phi_9789_ = _e13090;
                                                phi_9791_ = _e13092;
                                                phi_9793_ = _e13094;
                                                phi_9795_ = _e13096;
                                                phi_9797_ = _e13098;
                                                phi_11966_ = _e13051;
                                                phi_11967_ = _e12863;
                                                phi_11968_ = _e13100;
                                                phi_11969_ = _e13102;
                                                phi_11970_ = _e13104;
                                                phi_11971_ = _e13106;
                                                phi_11972_ = _e13108;
                                                phi_11973_ = false;
                                                phi_11974_ = _e13110;
                                            } else {
                                                phi_9787_ = f32();
                                                phi_9789_ = f32();
                                                phi_9791_ = f32();
                                                phi_9793_ = f32();
                                                phi_9795_ = bool();
                                                phi_9797_ = u32();
                                                phi_11966_ = f32();
                                                phi_11967_ = f32();
                                                phi_11968_ = false;
                                                phi_11969_ = false;
                                                phi_11970_ = false;
                                                phi_11971_ = false;
                                                phi_11972_ = false;
                                                phi_11973_ = true;
                                                phi_11974_ = false;
                                            }
                                            let _e13112 = phi_9787_;
                                            let _e13114 = phi_9789_;
                                            let _e13116 = phi_9791_;
                                            let _e13118 = phi_9793_;
                                            let _e13120 = phi_9795_;
                                            let _e13122 = phi_9797_;
                                            let _e13124 = phi_11966_;
                                            let _e13126 = phi_11967_;
                                            let _e13128 = phi_11968_;
                                            let _e13130 = phi_11969_;
                                            let _e13132 = phi_11970_;
                                            let _e13134 = phi_11971_;
                                            let _e13136 = phi_11972_;
                                            let _e13138 = phi_11973_;
                                            let _e13140 = phi_11974_;
                                            local_108 = _e13130;
                                            local_149 = _e13132;
                                            local_150 = _e13134;
                                            local_151 = _e13136;
                                            local_152 = _e13138;
                                            local_153 = _e13140;
                                            local_154 = _e13130;
                                            local_155 = _e13126;
                                            local_156 = _e13124;
                                            continue;
                                            continuing {
                                                phi_9783_ = _e11713;
                                                phi_9786_ = _e13112;
                                                phi_9788_ = _e13114;
                                                phi_9790_ = _e13116;
                                                phi_9792_ = _e13118;
                                                phi_9794_ = _e13120;
                                                phi_9796_ = _e13122;
                                                break if !(_e13128);
                                            }
                                        }
                                        let _e13143 = local_108;
                                        if _e13143 {
                                            phi_11978_ = false;
                                            phi_11979_ = false;
                                            phi_11980_ = false;
                                            phi_11981_ = false;
                                            phi_11982_ = false;
                                        } else {
                                            let _e17120 = local_149;
                                            phi_11978_ = _e17120;
                                            let _e17123 = local_150;
                                            phi_11979_ = _e17123;
                                            let _e17126 = local_151;
                                            phi_11980_ = _e17126;
                                            let _e17129 = local_152;
                                            phi_11981_ = _e17129;
                                            let _e17132 = local_153;
                                            phi_11982_ = _e17132;
                                        }
                                        let _e13145 = phi_11978_;
                                        let _e13147 = phi_11979_;
                                        let _e13149 = phi_11980_;
                                        let _e13151 = phi_11981_;
                                        let _e13153 = phi_11982_;
                                        if _e13145 {
                                            let _e13155 = local_109;
                                            phi_11987_ = type_45(1u, _e13155);
                                            phi_11988_ = false;
                                            phi_11989_ = false;
                                            phi_11990_ = false;
                                            phi_11991_ = false;
                                            phi_11992_ = false;
                                        } else {
                                            phi_11987_ = type_45();
                                            phi_11988_ = _e13147;
                                            phi_11989_ = _e13149;
                                            let _e17139 = local_154;
                                            phi_11990_ = _e17139;
                                            phi_11991_ = _e13151;
                                            phi_11992_ = _e13153;
                                        }
                                        let _e13158 = phi_11987_;
                                        let _e13160 = phi_11988_;
                                        let _e13162 = phi_11989_;
                                        let _e13164 = phi_11990_;
                                        let _e13166 = phi_11991_;
                                        let _e13168 = phi_11992_;
                                        if _e13160 {
                                            phi_11997_ = type_45(0u, type_45().member_1);
                                            phi_11998_ = false;
                                            phi_11999_ = false;
                                            phi_12000_ = false;
                                            phi_12001_ = false;
                                            phi_12002_ = true;
                                        } else {
                                            phi_11997_ = _e13158;
                                            phi_11998_ = _e13162;
                                            phi_11999_ = _e13164;
                                            phi_12000_ = _e13166;
                                            phi_12001_ = _e13168;
                                            phi_12002_ = _e13145;
                                        }
                                        let _e13172 = phi_11997_;
                                        let _e13174 = phi_11998_;
                                        let _e13176 = phi_11999_;
                                        let _e13178 = phi_12000_;
                                        let _e13180 = phi_12001_;
                                        let _e13182 = phi_12002_;
                                        if _e13174 {
                                            let _e17150 = local_155;
                                            phi_12006_ = _e17150;
                                            phi_12007_ = true;
                                            phi_12008_ = false;
                                            phi_12009_ = false;
                                            phi_12010_ = false;
                                        } else {
                                            let _e17152 = local_156;
                                            phi_12006_ = _e17152;
                                            phi_12007_ = _e13176;
                                            phi_12008_ = _e13178;
                                            phi_12009_ = _e13180;
                                            phi_12010_ = _e13182;
                                        }
                                        let _e13184 = phi_12006_;
                                        let _e13186 = phi_12007_;
                                        let _e13188 = phi_12008_;
                                        let _e13190 = phi_12009_;
                                        let _e13192 = phi_12010_;
                                        if _e13186 {
                                            phi_12014_ = _e13184;
                                            phi_12015_ = true;
                                            phi_12016_ = false;
                                            phi_12017_ = false;
                                        } else {
                                            let _e17159 = local_157;
                                            phi_12014_ = _e17159;
                                            phi_12015_ = _e13188;
                                            phi_12016_ = _e13190;
                                            phi_12017_ = _e13192;
                                        }
                                        let _e13194 = phi_12014_;
                                        let _e13196 = phi_12015_;
                                        let _e13198 = phi_12016_;
                                        let _e13200 = phi_12017_;
                                        if _e13196 {
                                            phi_12022_ = type_45(1u, _e13194);
                                            phi_12023_ = false;
                                            phi_12024_ = false;
                                        } else {
                                            phi_12022_ = type_45();
                                            phi_12023_ = _e13198;
                                            phi_12024_ = _e13200;
                                        }
                                        let _e13203 = phi_12022_;
                                        let _e13205 = phi_12023_;
                                        let _e13207 = phi_12024_;
                                        if _e13205 {
                                            phi_12029_ = type_45(0u, type_45().member_1);
                                            phi_12030_ = true;
                                        } else {
                                            phi_12029_ = _e13172;
                                            phi_12030_ = _e13207;
                                        }
                                        let _e13211 = phi_12029_;
                                        let _e13213 = phi_12030_;
                                        if _e13213 {
                                            phi_12034_ = _e13211;
                                        } else {
                                            phi_12034_ = _e13203;
                                        }
                                        let _e13215 = phi_12034_;
                                        phi_12041_ = _e13215.member_1;
                                        phi_12042_ = (_e13215.member != 0u);
                                    } else {
                                        phi_12041_ = _e11411;
                                        phi_12042_ = true;
                                    }
                                    let _e13220 = phi_12041_;
                                    let _e13222 = phi_12042_;
                                    if _e13222 {
                                        let _e13223 = (_e13220 > _e5621);
                                        if _e13223 {
                                            phi_14207_ = f32();
                                            phi_14208_ = u32();
                                            phi_14209_ = f32();
                                            phi_14210_ = type_47();
                                            phi_14211_ = u32();
                                            phi_14212_ = u32();
                                            phi_14213_ = false;
                                            phi_14214_ = false;
                                            phi_14215_ = false;
                                        } else {
                                            let _e13226 = local_18.member[0u];
                                            let _e13232 = local_18.member[1u];
                                            let _e13248 = local_18.member_1[0u];
                                            let _e13254 = local_18.member_1[1u];
                                            let _e13270 = local_18.member_2[0u];
                                            let _e13276 = local_18.member_2[1u];
                                            let _e13290 = function_4(array<f32, 3>((_e13226[0] + ((_e13232[0] - _e13226[0]) * _e11415)), (_e13226[1] + ((_e13232[1] - _e13226[1]) * _e11415)), (_e13226[2] + ((_e13232[2] - _e13226[2]) * _e11415))), array<f32, 3>((_e13248[0] + ((_e13254[0] - _e13248[0]) * _e11415)), (_e13248[1] + ((_e13254[1] - _e13248[1]) * _e11415)), (_e13248[2] + ((_e13254[2] - _e13248[2]) * _e11415))), array<f32, 3>((_e13270[0] + ((_e13276[0] - _e13270[0]) * _e11415)), (_e13270[1] + ((_e13276[1] - _e13270[1]) * _e11415)), (_e13270[2] + ((_e13276[2] - _e13270[2]) * _e11415))), _e316.member);
                                            if (_e13290[0] < 0f) {
                                                phi_12154_ = -(_e13290[0]);
                                            } else {
                                                phi_12154_ = _e13290[0];
                                            }
                                            let _e13295 = phi_12154_;
                                            if (_e13290[1] < 0f) {
                                                phi_12161_ = -(_e13290[1]);
                                            } else {
                                                phi_12161_ = _e13290[1];
                                            }
                                            let _e13300 = phi_12161_;
                                            if (_e13290[2] < 0f) {
                                                phi_12169_ = -(_e13290[2]);
                                            } else {
                                                phi_12169_ = _e13290[2];
                                            }
                                            let _e13306 = phi_12169_;
                                            let _e13307 = ((_e13295 + _e13300) + _e13306);
                                            let _e13310 = local_18.member[0u];
                                            let _e13317 = local_18.member_1[0u];
                                            let _e13323 = local_18.member_2[0u];
                                            let _e13327 = (_e13310[0] - _e13317[0]);
                                            let _e13328 = (_e13310[1] - _e13317[1]);
                                            let _e13329 = (_e13310[2] - _e13317[2]);
                                            if (_e316.member == 0u) {
                                                phi_12227_ = array<f32, 3>(_e13310[0], _e13310[1], _e13310[2]);
                                            } else {
                                                phi_12227_ = array<f32, 3>((_e13327 - _e13323[0]), (_e13328 - _e13323[1]), (_e13329 - _e13323[2]));
                                            }
                                            let _e13336 = phi_12227_;
                                            let _e13342 = local_18.member[1u];
                                            let _e13349 = local_18.member_1[1u];
                                            let _e13355 = local_18.member_2[1u];
                                            let _e13359 = (_e13342[0] - _e13349[0]);
                                            let _e13360 = (_e13342[1] - _e13349[1]);
                                            let _e13361 = (_e13342[2] - _e13349[2]);
                                            if (_e316.member == 0u) {
                                                phi_12295_ = array<f32, 3>(_e13342[0], _e13342[1], _e13342[2]);
                                            } else {
                                                phi_12295_ = array<f32, 3>((_e13359 - _e13355[0]), (_e13360 - _e13355[1]), (_e13361 - _e13355[2]));
                                            }
                                            let _e13368 = phi_12295_;
                                            let _e13374 = local_18.member[0u];
                                            if (_e13374[0] < 0f) {
                                                phi_12320_ = -(_e13374[0]);
                                            } else {
                                                phi_12320_ = _e13374[0];
                                            }
                                            let _e13381 = phi_12320_;
                                            if (_e13374[1] < 0f) {
                                                phi_12327_ = -(_e13374[1]);
                                            } else {
                                                phi_12327_ = _e13374[1];
                                            }
                                            let _e13385 = phi_12327_;
                                            if (_e13381 > _e13385) {
                                                phi_12332_ = _e13381;
                                            } else {
                                                phi_12332_ = _e13385;
                                            }
                                            let _e13388 = phi_12332_;
                                            if (_e13374[2] < 0f) {
                                                phi_12339_ = -(_e13374[2]);
                                            } else {
                                                phi_12339_ = _e13374[2];
                                            }
                                            let _e13392 = phi_12339_;
                                            if (_e13388 > _e13392) {
                                                phi_12344_ = _e13388;
                                            } else {
                                                phi_12344_ = _e13392;
                                            }
                                            let _e13395 = phi_12344_;
                                            let _e13398 = local_18.member[1u];
                                            if (_e13398[0] < 0f) {
                                                phi_12357_ = -(_e13398[0]);
                                            } else {
                                                phi_12357_ = _e13398[0];
                                            }
                                            let _e13405 = phi_12357_;
                                            if (_e13398[1] < 0f) {
                                                phi_12364_ = -(_e13398[1]);
                                            } else {
                                                phi_12364_ = _e13398[1];
                                            }
                                            let _e13409 = phi_12364_;
                                            if (_e13405 > _e13409) {
                                                phi_12369_ = _e13405;
                                            } else {
                                                phi_12369_ = _e13409;
                                            }
                                            let _e13412 = phi_12369_;
                                            if (_e13398[2] < 0f) {
                                                phi_12376_ = -(_e13398[2]);
                                            } else {
                                                phi_12376_ = _e13398[2];
                                            }
                                            let _e13416 = phi_12376_;
                                            if (_e13412 > _e13416) {
                                                phi_12381_ = _e13412;
                                            } else {
                                                phi_12381_ = _e13416;
                                            }
                                            let _e13419 = phi_12381_;
                                            if (_e13395 > _e13419) {
                                                phi_12386_ = _e13395;
                                            } else {
                                                phi_12386_ = _e13419;
                                            }
                                            let _e13422 = phi_12386_;
                                            let _e13424 = local_18.member_3;
                                            let _e13428 = local_18.member_1[0u];
                                            if (_e13428[0] < 0f) {
                                                phi_12403_ = -(_e13428[0]);
                                            } else {
                                                phi_12403_ = _e13428[0];
                                            }
                                            let _e13435 = phi_12403_;
                                            if (_e13428[1] < 0f) {
                                                phi_12410_ = -(_e13428[1]);
                                            } else {
                                                phi_12410_ = _e13428[1];
                                            }
                                            let _e13439 = phi_12410_;
                                            if (_e13435 > _e13439) {
                                                phi_12415_ = _e13435;
                                            } else {
                                                phi_12415_ = _e13439;
                                            }
                                            let _e13442 = phi_12415_;
                                            if (_e13428[2] < 0f) {
                                                phi_12422_ = -(_e13428[2]);
                                            } else {
                                                phi_12422_ = _e13428[2];
                                            }
                                            let _e13446 = phi_12422_;
                                            if (_e13442 > _e13446) {
                                                phi_12427_ = _e13442;
                                            } else {
                                                phi_12427_ = _e13446;
                                            }
                                            let _e13449 = phi_12427_;
                                            let _e13452 = local_18.member_1[1u];
                                            if (_e13452[0] < 0f) {
                                                phi_12441_ = -(_e13452[0]);
                                            } else {
                                                phi_12441_ = _e13452[0];
                                            }
                                            let _e13459 = phi_12441_;
                                            if (_e13452[1] < 0f) {
                                                phi_12448_ = -(_e13452[1]);
                                            } else {
                                                phi_12448_ = _e13452[1];
                                            }
                                            let _e13463 = phi_12448_;
                                            if (_e13459 > _e13463) {
                                                phi_12453_ = _e13459;
                                            } else {
                                                phi_12453_ = _e13463;
                                            }
                                            let _e13466 = phi_12453_;
                                            if (_e13452[2] < 0f) {
                                                phi_12460_ = -(_e13452[2]);
                                            } else {
                                                phi_12460_ = _e13452[2];
                                            }
                                            let _e13470 = phi_12460_;
                                            if (_e13466 > _e13470) {
                                                phi_12465_ = _e13466;
                                            } else {
                                                phi_12465_ = _e13470;
                                            }
                                            let _e13473 = phi_12465_;
                                            if (_e13449 > _e13473) {
                                                phi_12470_ = _e13449;
                                            } else {
                                                phi_12470_ = _e13473;
                                            }
                                            let _e13476 = phi_12470_;
                                            let _e13478 = local_18.member_3;
                                            let _e13482 = local_18.member_2[0u];
                                            if (_e13482[0] < 0f) {
                                                phi_12487_ = -(_e13482[0]);
                                            } else {
                                                phi_12487_ = _e13482[0];
                                            }
                                            let _e13489 = phi_12487_;
                                            if (_e13482[1] < 0f) {
                                                phi_12494_ = -(_e13482[1]);
                                            } else {
                                                phi_12494_ = _e13482[1];
                                            }
                                            let _e13493 = phi_12494_;
                                            if (_e13489 > _e13493) {
                                                phi_12499_ = _e13489;
                                            } else {
                                                phi_12499_ = _e13493;
                                            }
                                            let _e13496 = phi_12499_;
                                            if (_e13482[2] < 0f) {
                                                phi_12506_ = -(_e13482[2]);
                                            } else {
                                                phi_12506_ = _e13482[2];
                                            }
                                            let _e13500 = phi_12506_;
                                            if (_e13496 > _e13500) {
                                                phi_12511_ = _e13496;
                                            } else {
                                                phi_12511_ = _e13500;
                                            }
                                            let _e13503 = phi_12511_;
                                            let _e13506 = local_18.member_2[1u];
                                            if (_e13506[0] < 0f) {
                                                phi_12525_ = -(_e13506[0]);
                                            } else {
                                                phi_12525_ = _e13506[0];
                                            }
                                            let _e13513 = phi_12525_;
                                            if (_e13506[1] < 0f) {
                                                phi_12532_ = -(_e13506[1]);
                                            } else {
                                                phi_12532_ = _e13506[1];
                                            }
                                            let _e13517 = phi_12532_;
                                            if (_e13513 > _e13517) {
                                                phi_12537_ = _e13513;
                                            } else {
                                                phi_12537_ = _e13517;
                                            }
                                            let _e13520 = phi_12537_;
                                            if (_e13506[2] < 0f) {
                                                phi_12544_ = -(_e13506[2]);
                                            } else {
                                                phi_12544_ = _e13506[2];
                                            }
                                            let _e13524 = phi_12544_;
                                            if (_e13520 > _e13524) {
                                                phi_12549_ = _e13520;
                                            } else {
                                                phi_12549_ = _e13524;
                                            }
                                            let _e13527 = phi_12549_;
                                            if (_e13503 > _e13527) {
                                                phi_12554_ = _e13503;
                                            } else {
                                                phi_12554_ = _e13527;
                                            }
                                            let _e13530 = phi_12554_;
                                            let _e13532 = local_18.member_3;
                                            let _e13539 = local_18.member_3;
                                            local_14 = type_34(array<array<array<f32, 3>, 4>, 2>(array<array<f32, 3>, 4>(_e13310, array<f32, 3>(_e13327, _e13328, _e13329), array<f32, 3>((_e13310[0] - _e13323[0]), (_e13310[1] - _e13323[1]), (_e13310[2] - _e13323[2])), array<f32, 3>(_e13336[0], _e13336[1], _e13336[2])), array<array<f32, 3>, 4>(_e13342, array<f32, 3>(_e13359, _e13360, _e13361), array<f32, 3>((_e13342[0] - _e13355[0]), (_e13342[1] - _e13355[1]), (_e13342[2] - _e13355[2])), array<f32, 3>(_e13368[0], _e13368[1], _e13368[2]))), ((((((_e13422 + _e13424) + (_e13476 + _e13478)) + (_e13530 + _e13532)) * (0.000000059604645f * 16f)) + (_e13539 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)), _e5889.member_1);
                                            let _e13561 = local_14.member_1;
                                            if (_e13307 > _e13561) {
                                                if ((bitcast<u32>(_e13307) & 2139095040u) != 2139095040u) {
                                                    let _e13566 = (1f / _e13307);
                                                    let _e13568 = (_e13290[0] * _e13566);
                                                    let _e13570 = (_e13290[1] * _e13566);
                                                    let _e13572 = (_e13290[2] * _e13566);
                                                    let _e13577 = (((_e13568 * _e13568) + (_e13570 * _e13570)) + (_e13572 * _e13572));
                                                    if (_e13577 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e13577 > 0f) {
                                                            phi_12655_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_12655_ = 0f;
                                                        }
                                                        let _e13630 = phi_12655_;
                                                        phi_12719_ = _e13630;
                                                    } else {
                                                        phi_12662_ = type_14(0i, 5i);
                                                        phi_12665_ = bitcast<f32>(((bitcast<u32>(_e13577) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e13585 = phi_12662_;
                                                            let _e13587 = phi_12665_;
                                                            local_110 = _e13587;
                                                            if (_e13585.member < _e13585.member_1) {
                                                                let _e13594 = (_e13585.member + 1i);
                                                                if ((false == (_e13594 > _e13585.member)) != false) {
                                                                    phi_12686_ = true;
                                                                } else {
                                                                    phi_12686_ = false;
                                                                }
                                                                let _e13599 = phi_12686_;
                                                                if _e13599 {
                                                                    phi_12692_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_12692_ = type_15(1u, _e13594);
                                                                }
                                                                let _e13604 = phi_12692_;
                                                                phi_12663_ = type_14(_e13604.member_1, _e13585.member_1);
                                                                phi_12706_ = type_15(1u, _e13585.member);
                                                            } else {
                                                                phi_12663_ = _e13585;
                                                                phi_12706_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e13610 = phi_12663_;
                                                            let _e13612 = phi_12706_;
                                                            let _e13615 = (bitcast<i32>(_e13612.member) != 0i);
                                                            if _e13615 {
                                                                phi_12666_ = (0.5f * (_e13587 + (_e13577 / _e13587)));
                                                            } else {
                                                                phi_12666_ = f32();
                                                            }
                                                            let _e13620 = phi_12666_;
                                                            continue;
                                                            continuing {
                                                                phi_12662_ = _e13610;
                                                                phi_12665_ = _e13620;
                                                                break if !(_e13615);
                                                            }
                                                        }
                                                        let _e13625 = local_110;
                                                        phi_12719_ = (_e13625 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e13632 = phi_12719_;
                                                    let _e13633 = (0.000000059604645f * 12f);
                                                    let _e13635 = local_14.member_1;
                                                    let _e13638 = local_14.member_2;
                                                    let _e13642 = ((_e13635 * 1.01f) + ((_e13638 * _e13632) * (1f + _e13633)));
                                                    let _e13646 = local_14.member[0u][0u];
                                                    let _e13654 = (((_e13568 * _e13646[0]) + (_e13570 * _e13646[1])) + (_e13572 * _e13646[2]));
                                                    let _e13658 = local_14.member[0u][1u];
                                                    let _e13666 = (((_e13568 * _e13658[0]) + (_e13570 * _e13658[1])) + (_e13572 * _e13658[2]));
                                                    let _e13670 = local_14.member[0u][2u];
                                                    let _e13678 = (((_e13568 * _e13670[0]) + (_e13570 * _e13670[1])) + (_e13572 * _e13670[2]));
                                                    let _e13682 = local_14.member[0u][3u];
                                                    let _e13690 = (((_e13568 * _e13682[0]) + (_e13570 * _e13682[1])) + (_e13572 * _e13682[2]));
                                                    let _e13694 = local_14.member[1u][0u];
                                                    let _e13702 = (((_e13568 * _e13694[0]) + (_e13570 * _e13694[1])) + (_e13572 * _e13694[2]));
                                                    let _e13706 = local_14.member[1u][1u];
                                                    let _e13714 = (((_e13568 * _e13706[0]) + (_e13570 * _e13706[1])) + (_e13572 * _e13706[2]));
                                                    let _e13718 = local_14.member[1u][2u];
                                                    let _e13726 = (((_e13568 * _e13718[0]) + (_e13570 * _e13718[1])) + (_e13572 * _e13718[2]));
                                                    let _e13730 = local_14.member[1u][3u];
                                                    let _e13738 = (((_e13568 * _e13730[0]) + (_e13570 * _e13730[1])) + (_e13572 * _e13730[2]));
                                                    if (_e13654 < 0f) {
                                                        phi_12853_ = -(_e13654);
                                                    } else {
                                                        phi_12853_ = _e13654;
                                                    }
                                                    let _e13742 = phi_12853_;
                                                    if (_e13702 < 0f) {
                                                        phi_12859_ = -(_e13702);
                                                    } else {
                                                        phi_12859_ = _e13702;
                                                    }
                                                    let _e13746 = phi_12859_;
                                                    if (_e13666 < 0f) {
                                                        phi_12868_ = -(_e13666);
                                                    } else {
                                                        phi_12868_ = _e13666;
                                                    }
                                                    let _e13753 = phi_12868_;
                                                    if (_e13714 < 0f) {
                                                        phi_12874_ = -(_e13714);
                                                    } else {
                                                        phi_12874_ = _e13714;
                                                    }
                                                    let _e13757 = phi_12874_;
                                                    if (_e13678 < 0f) {
                                                        phi_12883_ = -(_e13678);
                                                    } else {
                                                        phi_12883_ = _e13678;
                                                    }
                                                    let _e13764 = phi_12883_;
                                                    if (_e13726 < 0f) {
                                                        phi_12889_ = -(_e13726);
                                                    } else {
                                                        phi_12889_ = _e13726;
                                                    }
                                                    let _e13768 = phi_12889_;
                                                    if (_e13690 < 0f) {
                                                        phi_12898_ = -(_e13690);
                                                    } else {
                                                        phi_12898_ = _e13690;
                                                    }
                                                    let _e13775 = phi_12898_;
                                                    if (_e13738 < 0f) {
                                                        phi_12904_ = -(_e13738);
                                                    } else {
                                                        phi_12904_ = _e13738;
                                                    }
                                                    let _e13779 = phi_12904_;
                                                    local_15 = type_30(array<f32, 4>(_e13654, _e13666, _e13678, _e13690), array<f32, 4>(_e13702, _e13714, _e13726, _e13738), array<f32, 4>((_e13642 + ((_e13742 + _e13746) * _e13633)), (_e13642 + ((_e13753 + _e13757) * _e13633)), (_e13642 + ((_e13764 + _e13768) * _e13633)), (_e13642 + ((_e13775 + _e13779) * _e13633))));
                                                    let _e13791 = (((_e13568 * _e13568) + (_e13570 * _e13570)) + (_e13572 * _e13572));
                                                    if (_e13791 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e13791 > 0f) {
                                                            phi_12947_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_12947_ = 0f;
                                                        }
                                                        let _e13844 = phi_12947_;
                                                        phi_13011_ = _e13844;
                                                    } else {
                                                        phi_12954_ = type_14(0i, 5i);
                                                        phi_12957_ = bitcast<f32>(((bitcast<u32>(_e13791) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e13799 = phi_12954_;
                                                            let _e13801 = phi_12957_;
                                                            local_111 = _e13801;
                                                            if (_e13799.member < _e13799.member_1) {
                                                                let _e13808 = (_e13799.member + 1i);
                                                                if ((false == (_e13808 > _e13799.member)) != false) {
                                                                    phi_12978_ = true;
                                                                } else {
                                                                    phi_12978_ = false;
                                                                }
                                                                let _e13813 = phi_12978_;
                                                                if _e13813 {
                                                                    phi_12984_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_12984_ = type_15(1u, _e13808);
                                                                }
                                                                let _e13818 = phi_12984_;
                                                                phi_12955_ = type_14(_e13818.member_1, _e13799.member_1);
                                                                phi_12998_ = type_15(1u, _e13799.member);
                                                            } else {
                                                                phi_12955_ = _e13799;
                                                                phi_12998_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e13824 = phi_12955_;
                                                            let _e13826 = phi_12998_;
                                                            let _e13829 = (bitcast<i32>(_e13826.member) != 0i);
                                                            if _e13829 {
                                                                phi_12958_ = (0.5f * (_e13801 + (_e13791 / _e13801)));
                                                            } else {
                                                                phi_12958_ = f32();
                                                            }
                                                            let _e13834 = phi_12958_;
                                                            continue;
                                                            continuing {
                                                                phi_12954_ = _e13824;
                                                                phi_12957_ = _e13834;
                                                                break if !(_e13829);
                                                            }
                                                        }
                                                        let _e13839 = local_111;
                                                        phi_13011_ = (_e13839 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e13846 = phi_13011_;
                                                    let _e13857 = (((_e13290[0] * _e13290[0]) + (_e13290[1] * _e13290[1])) + (_e13290[2] * _e13290[2]));
                                                    if (_e13857 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e13857 > 0f) {
                                                            phi_13036_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_13036_ = 0f;
                                                        }
                                                        let _e13910 = phi_13036_;
                                                        phi_13100_ = _e13910;
                                                    } else {
                                                        phi_13043_ = type_14(0i, 5i);
                                                        phi_13046_ = bitcast<f32>(((bitcast<u32>(_e13857) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e13865 = phi_13043_;
                                                            let _e13867 = phi_13046_;
                                                            local_112 = _e13867;
                                                            if (_e13865.member < _e13865.member_1) {
                                                                let _e13874 = (_e13865.member + 1i);
                                                                if ((false == (_e13874 > _e13865.member)) != false) {
                                                                    phi_13067_ = true;
                                                                } else {
                                                                    phi_13067_ = false;
                                                                }
                                                                let _e13879 = phi_13067_;
                                                                if _e13879 {
                                                                    phi_13073_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_13073_ = type_15(1u, _e13874);
                                                                }
                                                                let _e13884 = phi_13073_;
                                                                phi_13044_ = type_14(_e13884.member_1, _e13865.member_1);
                                                                phi_13087_ = type_15(1u, _e13865.member);
                                                            } else {
                                                                phi_13044_ = _e13865;
                                                                phi_13087_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e13890 = phi_13044_;
                                                            let _e13892 = phi_13087_;
                                                            let _e13895 = (bitcast<i32>(_e13892.member) != 0i);
                                                            if _e13895 {
                                                                phi_13047_ = (0.5f * (_e13867 + (_e13857 / _e13867)));
                                                            } else {
                                                                phi_13047_ = f32();
                                                            }
                                                            let _e13900 = phi_13047_;
                                                            continue;
                                                            continuing {
                                                                phi_13043_ = _e13890;
                                                                phi_13046_ = _e13900;
                                                                break if !(_e13895);
                                                            }
                                                        }
                                                        let _e13905 = local_112;
                                                        phi_13100_ = (_e13905 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e13912 = phi_13100_;
                                                    let _e13918 = local_18.member[0u];
                                                    if (_e13918[0] < 0f) {
                                                        phi_13116_ = -(_e13918[0]);
                                                    } else {
                                                        phi_13116_ = _e13918[0];
                                                    }
                                                    let _e13925 = phi_13116_;
                                                    if (_e13918[1] < 0f) {
                                                        phi_13123_ = -(_e13918[1]);
                                                    } else {
                                                        phi_13123_ = _e13918[1];
                                                    }
                                                    let _e13929 = phi_13123_;
                                                    if (_e13925 > _e13929) {
                                                        phi_13128_ = _e13925;
                                                    } else {
                                                        phi_13128_ = _e13929;
                                                    }
                                                    let _e13932 = phi_13128_;
                                                    if (_e13918[2] < 0f) {
                                                        phi_13135_ = -(_e13918[2]);
                                                    } else {
                                                        phi_13135_ = _e13918[2];
                                                    }
                                                    let _e13936 = phi_13135_;
                                                    if (_e13932 > _e13936) {
                                                        phi_13140_ = _e13932;
                                                    } else {
                                                        phi_13140_ = _e13936;
                                                    }
                                                    let _e13939 = phi_13140_;
                                                    let _e13942 = local_18.member[1u];
                                                    if (_e13942[0] < 0f) {
                                                        phi_13153_ = -(_e13942[0]);
                                                    } else {
                                                        phi_13153_ = _e13942[0];
                                                    }
                                                    let _e13949 = phi_13153_;
                                                    if (_e13942[1] < 0f) {
                                                        phi_13160_ = -(_e13942[1]);
                                                    } else {
                                                        phi_13160_ = _e13942[1];
                                                    }
                                                    let _e13953 = phi_13160_;
                                                    if (_e13949 > _e13953) {
                                                        phi_13165_ = _e13949;
                                                    } else {
                                                        phi_13165_ = _e13953;
                                                    }
                                                    let _e13956 = phi_13165_;
                                                    if (_e13942[2] < 0f) {
                                                        phi_13172_ = -(_e13942[2]);
                                                    } else {
                                                        phi_13172_ = _e13942[2];
                                                    }
                                                    let _e13960 = phi_13172_;
                                                    if (_e13956 > _e13960) {
                                                        phi_13177_ = _e13956;
                                                    } else {
                                                        phi_13177_ = _e13960;
                                                    }
                                                    let _e13963 = phi_13177_;
                                                    if (_e13939 > _e13963) {
                                                        phi_13182_ = _e13939;
                                                    } else {
                                                        phi_13182_ = _e13963;
                                                    }
                                                    let _e13966 = phi_13182_;
                                                    let _e13968 = local_18.member_3;
                                                    let _e13972 = local_18.member_1[0u];
                                                    if (_e13972[0] < 0f) {
                                                        phi_13199_ = -(_e13972[0]);
                                                    } else {
                                                        phi_13199_ = _e13972[0];
                                                    }
                                                    let _e13979 = phi_13199_;
                                                    if (_e13972[1] < 0f) {
                                                        phi_13206_ = -(_e13972[1]);
                                                    } else {
                                                        phi_13206_ = _e13972[1];
                                                    }
                                                    let _e13983 = phi_13206_;
                                                    if (_e13979 > _e13983) {
                                                        phi_13211_ = _e13979;
                                                    } else {
                                                        phi_13211_ = _e13983;
                                                    }
                                                    let _e13986 = phi_13211_;
                                                    if (_e13972[2] < 0f) {
                                                        phi_13218_ = -(_e13972[2]);
                                                    } else {
                                                        phi_13218_ = _e13972[2];
                                                    }
                                                    let _e13990 = phi_13218_;
                                                    if (_e13986 > _e13990) {
                                                        phi_13223_ = _e13986;
                                                    } else {
                                                        phi_13223_ = _e13990;
                                                    }
                                                    let _e13993 = phi_13223_;
                                                    let _e13996 = local_18.member_1[1u];
                                                    if (_e13996[0] < 0f) {
                                                        phi_13237_ = -(_e13996[0]);
                                                    } else {
                                                        phi_13237_ = _e13996[0];
                                                    }
                                                    let _e14003 = phi_13237_;
                                                    if (_e13996[1] < 0f) {
                                                        phi_13244_ = -(_e13996[1]);
                                                    } else {
                                                        phi_13244_ = _e13996[1];
                                                    }
                                                    let _e14007 = phi_13244_;
                                                    if (_e14003 > _e14007) {
                                                        phi_13249_ = _e14003;
                                                    } else {
                                                        phi_13249_ = _e14007;
                                                    }
                                                    let _e14010 = phi_13249_;
                                                    if (_e13996[2] < 0f) {
                                                        phi_13256_ = -(_e13996[2]);
                                                    } else {
                                                        phi_13256_ = _e13996[2];
                                                    }
                                                    let _e14014 = phi_13256_;
                                                    if (_e14010 > _e14014) {
                                                        phi_13261_ = _e14010;
                                                    } else {
                                                        phi_13261_ = _e14014;
                                                    }
                                                    let _e14017 = phi_13261_;
                                                    if (_e13993 > _e14017) {
                                                        phi_13266_ = _e13993;
                                                    } else {
                                                        phi_13266_ = _e14017;
                                                    }
                                                    let _e14020 = phi_13266_;
                                                    let _e14022 = local_18.member_3;
                                                    let _e14026 = local_18.member_2[0u];
                                                    if (_e14026[0] < 0f) {
                                                        phi_13283_ = -(_e14026[0]);
                                                    } else {
                                                        phi_13283_ = _e14026[0];
                                                    }
                                                    let _e14033 = phi_13283_;
                                                    if (_e14026[1] < 0f) {
                                                        phi_13290_ = -(_e14026[1]);
                                                    } else {
                                                        phi_13290_ = _e14026[1];
                                                    }
                                                    let _e14037 = phi_13290_;
                                                    if (_e14033 > _e14037) {
                                                        phi_13295_ = _e14033;
                                                    } else {
                                                        phi_13295_ = _e14037;
                                                    }
                                                    let _e14040 = phi_13295_;
                                                    if (_e14026[2] < 0f) {
                                                        phi_13302_ = -(_e14026[2]);
                                                    } else {
                                                        phi_13302_ = _e14026[2];
                                                    }
                                                    let _e14044 = phi_13302_;
                                                    if (_e14040 > _e14044) {
                                                        phi_13307_ = _e14040;
                                                    } else {
                                                        phi_13307_ = _e14044;
                                                    }
                                                    let _e14047 = phi_13307_;
                                                    let _e14050 = local_18.member_2[1u];
                                                    if (_e14050[0] < 0f) {
                                                        phi_13321_ = -(_e14050[0]);
                                                    } else {
                                                        phi_13321_ = _e14050[0];
                                                    }
                                                    let _e14057 = phi_13321_;
                                                    if (_e14050[1] < 0f) {
                                                        phi_13328_ = -(_e14050[1]);
                                                    } else {
                                                        phi_13328_ = _e14050[1];
                                                    }
                                                    let _e14061 = phi_13328_;
                                                    if (_e14057 > _e14061) {
                                                        phi_13333_ = _e14057;
                                                    } else {
                                                        phi_13333_ = _e14061;
                                                    }
                                                    let _e14064 = phi_13333_;
                                                    if (_e14050[2] < 0f) {
                                                        phi_13340_ = -(_e14050[2]);
                                                    } else {
                                                        phi_13340_ = _e14050[2];
                                                    }
                                                    let _e14068 = phi_13340_;
                                                    if (_e14064 > _e14068) {
                                                        phi_13345_ = _e14064;
                                                    } else {
                                                        phi_13345_ = _e14068;
                                                    }
                                                    let _e14071 = phi_13345_;
                                                    if (_e14047 > _e14071) {
                                                        phi_13350_ = _e14047;
                                                    } else {
                                                        phi_13350_ = _e14071;
                                                    }
                                                    let _e14074 = phi_13350_;
                                                    let _e14076 = local_18.member_3;
                                                    let _e14083 = local_18.member_3;
                                                    let _e14093 = ((((_e13912 * (1f + (0.000000059604645f * 8f))) + (((((((_e13966 + _e13968) + (_e14020 + _e14022)) + (_e14074 + _e14076)) * (0.000000059604645f * 16f)) + (_e14083 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) * _e13846) * (1f + (0.000000059604645f * 64f)));
                                                    let _e14096 = local_15.member[0u];
                                                    let _e14099 = local_15.member_1[0u];
                                                    if (_e14096 < 0f) {
                                                        phi_13391_ = -(_e14096);
                                                    } else {
                                                        phi_13391_ = _e14096;
                                                    }
                                                    let _e14104 = phi_13391_;
                                                    if (_e14099 < 0f) {
                                                        phi_13397_ = -(_e14099);
                                                    } else {
                                                        phi_13397_ = _e14099;
                                                    }
                                                    let _e14108 = phi_13397_;
                                                    phi_13408_ = type_9(1u, 4u);
                                                    phi_13411_ = ((_e14096 + ((_e14099 - _e14096) * _e11415)) - ((_e13561 * 1.01f) + ((_e14104 + _e14108) * (0.000000059604645f * 12f))));
                                                    loop {
                                                        let _e14118 = phi_13408_;
                                                        let _e14120 = phi_13411_;
                                                        local_113 = _e14120;
                                                        local_114 = _e14120;
                                                        if (_e14118.member < _e14118.member_1) {
                                                            phi_13409_ = type_9((_e14118.member + 1u), _e14118.member_1);
                                                            phi_13434_ = type_9(1u, _e14118.member);
                                                        } else {
                                                            phi_13409_ = _e14118;
                                                            phi_13434_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e14132 = phi_13409_;
                                                        let _e14134 = phi_13434_;
                                                        let _e14138 = (bitcast<i32>(_e14134.member) != 0i);
                                                        if _e14138 {
                                                            let _e14141 = local_15.member[_e14134.member_1];
                                                            let _e14144 = local_15.member_1[_e14134.member_1];
                                                            if (_e14141 < 0f) {
                                                                phi_13463_ = -(_e14141);
                                                            } else {
                                                                phi_13463_ = _e14141;
                                                            }
                                                            let _e14149 = phi_13463_;
                                                            if (_e14144 < 0f) {
                                                                phi_13469_ = -(_e14144);
                                                            } else {
                                                                phi_13469_ = _e14144;
                                                            }
                                                            let _e14153 = phi_13469_;
                                                            let _e14161 = ((_e14141 + ((_e14144 - _e14141) * _e11415)) - ((_e13561 * 1.01f) + ((_e14149 + _e14153) * (0.000000059604645f * 12f))));
                                                            if (_e14120 < _e14161) {
                                                                phi_13482_ = _e14120;
                                                            } else {
                                                                phi_13482_ = _e14161;
                                                            }
                                                            let _e14164 = phi_13482_;
                                                            phi_13412_ = _e14164;
                                                        } else {
                                                            phi_13412_ = f32();
                                                        }
                                                        let _e14166 = phi_13412_;
                                                        continue;
                                                        continuing {
                                                            phi_13408_ = _e14132;
                                                            phi_13411_ = _e14166;
                                                            break if !(_e14138);
                                                        }
                                                    }
                                                    let _e14169 = local_113;
                                                    if (_e14169 > 0f) {
                                                        let _e14173 = local_114;
                                                        let _e14176 = (((_e14093 - _e14173) / _e14093) * 2.02f);
                                                        if (_e14176 <= 0.000000000000000000000000000000000000011754944f) {
                                                            if (_e14176 > 0f) {
                                                                phi_13503_ = (0.000000000000000000106433627f * 2f);
                                                            } else {
                                                                phi_13503_ = 0f;
                                                            }
                                                            let _e14229 = phi_13503_;
                                                            phi_13567_ = _e14229;
                                                        } else {
                                                            phi_13510_ = type_14(0i, 5i);
                                                            phi_13513_ = bitcast<f32>(((bitcast<u32>(_e14176) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e14184 = phi_13510_;
                                                                let _e14186 = phi_13513_;
                                                                local_115 = _e14186;
                                                                if (_e14184.member < _e14184.member_1) {
                                                                    let _e14193 = (_e14184.member + 1i);
                                                                    if ((false == (_e14193 > _e14184.member)) != false) {
                                                                        phi_13534_ = true;
                                                                    } else {
                                                                        phi_13534_ = false;
                                                                    }
                                                                    let _e14198 = phi_13534_;
                                                                    if _e14198 {
                                                                        phi_13540_ = type_15(0u, type_15().member_1);
                                                                    } else {
                                                                        phi_13540_ = type_15(1u, _e14193);
                                                                    }
                                                                    let _e14203 = phi_13540_;
                                                                    phi_13511_ = type_14(_e14203.member_1, _e14184.member_1);
                                                                    phi_13554_ = type_15(1u, _e14184.member);
                                                                } else {
                                                                    phi_13511_ = _e14184;
                                                                    phi_13554_ = type_15(0u, type_15().member_1);
                                                                }
                                                                let _e14209 = phi_13511_;
                                                                let _e14211 = phi_13554_;
                                                                let _e14214 = (bitcast<i32>(_e14211.member) != 0i);
                                                                if _e14214 {
                                                                    phi_13514_ = (0.5f * (_e14186 + (_e14176 / _e14186)));
                                                                } else {
                                                                    phi_13514_ = f32();
                                                                }
                                                                let _e14219 = phi_13514_;
                                                                continue;
                                                                continuing {
                                                                    phi_13510_ = _e14209;
                                                                    phi_13513_ = _e14219;
                                                                    break if !(_e14214);
                                                                }
                                                            }
                                                            let _e14224 = local_115;
                                                            phi_13567_ = (_e14224 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e14231 = phi_13567_;
                                                        let _e14233 = ((_e14231 * _e13846) * 1.01f);
                                                        phi_13572_ = type_9(0u, 4u);
                                                        phi_13575_ = 2f;
                                                        phi_13577_ = true;
                                                        phi_13579_ = true;
                                                        loop {
                                                            let _e14235 = phi_13572_;
                                                            let _e14237 = phi_13575_;
                                                            let _e14239 = phi_13577_;
                                                            let _e14241 = phi_13579_;
                                                            local_116 = _e14237;
                                                            local_158 = _e14237;
                                                            local_117 = _e14239;
                                                            local_118 = _e14241;
                                                            local_159 = _e14241;
                                                            local_119 = _e14241;
                                                            if (_e14235.member < _e14235.member_1) {
                                                                phi_13573_ = type_9((_e14235.member + 1u), _e14235.member_1);
                                                                phi_13602_ = type_9(1u, _e14235.member);
                                                            } else {
                                                                phi_13573_ = _e14235;
                                                                phi_13602_ = type_9(0u, type_9().member_1);
                                                            }
                                                            let _e14253 = phi_13573_;
                                                            let _e14255 = phi_13602_;
                                                            let _e14259 = (bitcast<i32>(_e14255.member) != 0i);
                                                            if _e14259 {
                                                                let _e14263 = local_14.member[0u][_e14255.member_1];
                                                                let _e14270 = local_14.member[1u][_e14255.member_1];
                                                                if (_e14263[0] < 0f) {
                                                                    phi_13639_ = -(_e14263[0]);
                                                                } else {
                                                                    phi_13639_ = _e14263[0];
                                                                }
                                                                let _e14277 = phi_13639_;
                                                                if (_e14263[1] < 0f) {
                                                                    phi_13646_ = -(_e14263[1]);
                                                                } else {
                                                                    phi_13646_ = _e14263[1];
                                                                }
                                                                let _e14281 = phi_13646_;
                                                                if (_e14263[2] < 0f) {
                                                                    phi_13654_ = -(_e14263[2]);
                                                                } else {
                                                                    phi_13654_ = _e14263[2];
                                                                }
                                                                let _e14286 = phi_13654_;
                                                                let _e14287 = ((_e14277 + _e14281) + _e14286);
                                                                if (_e14270[0] < 0f) {
                                                                    phi_13662_ = -(_e14270[0]);
                                                                } else {
                                                                    phi_13662_ = _e14270[0];
                                                                }
                                                                let _e14291 = phi_13662_;
                                                                if (_e14270[1] < 0f) {
                                                                    phi_13669_ = -(_e14270[1]);
                                                                } else {
                                                                    phi_13669_ = _e14270[1];
                                                                }
                                                                let _e14295 = phi_13669_;
                                                                if (_e14270[2] < 0f) {
                                                                    phi_13677_ = -(_e14270[2]);
                                                                } else {
                                                                    phi_13677_ = _e14270[2];
                                                                }
                                                                let _e14300 = phi_13677_;
                                                                let _e14301 = ((_e14291 + _e14295) + _e14300);
                                                                if (_e14287 > _e14301) {
                                                                    phi_13683_ = _e14287;
                                                                } else {
                                                                    phi_13683_ = _e14301;
                                                                }
                                                                let _e14304 = phi_13683_;
                                                                let _e14308 = (_e14270[0] - _e14263[0]);
                                                                let _e14309 = (_e14270[1] - _e14263[1]);
                                                                let _e14310 = (_e14270[2] - _e14263[2]);
                                                                if (_e14308 < 0f) {
                                                                    phi_13701_ = -(_e14308);
                                                                } else {
                                                                    phi_13701_ = _e14308;
                                                                }
                                                                let _e14314 = phi_13701_;
                                                                if (_e14309 < 0f) {
                                                                    phi_13707_ = -(_e14309);
                                                                } else {
                                                                    phi_13707_ = _e14309;
                                                                }
                                                                let _e14318 = phi_13707_;
                                                                if (_e14310 < 0f) {
                                                                    phi_13714_ = -(_e14310);
                                                                } else {
                                                                    phi_13714_ = _e14310;
                                                                }
                                                                let _e14323 = phi_13714_;
                                                                let _e14330 = local_15.member[_e14255.member_1];
                                                                let _e14333 = local_15.member_1[_e14255.member_1];
                                                                if (_e14330 < 0f) {
                                                                    phi_13740_ = -(_e14330);
                                                                } else {
                                                                    phi_13740_ = _e14330;
                                                                }
                                                                let _e14338 = phi_13740_;
                                                                if (_e14333 < 0f) {
                                                                    phi_13746_ = -(_e14333);
                                                                } else {
                                                                    phi_13746_ = _e14333;
                                                                }
                                                                let _e14342 = phi_13746_;
                                                                let _e14346 = ((_e13561 * 1.01f) + ((_e14338 + _e14342) * (0.000000059604645f * 12f)));
                                                                let _e14353 = local_15.member_1[_e14255.member_1];
                                                                let _e14356 = local_15.member[_e14255.member_1];
                                                                let _e14357 = (_e14353 - _e14356);
                                                                let _e14360 = ((_e14346 + _e14346) + (_e14233 * ((((_e14314 + _e14318) + _e14323) + (_e13561 * 6f)) * 1.01f)));
                                                                let _e14363 = ((((_e14330 + ((_e14333 - _e14330) * _e11415)) - _e14346) - (_e14233 * ((_e14304 + (_e13561 * 3f)) * 1.01f))) - _e14093);
                                                                let _e14364 = (_e14363 > 0.000000000000000000000000000000000000011754944f);
                                                                let _e14365 = (_e14357 > _e14360);
                                                                if _e14365 {
                                                                    phi_13782_ = true;
                                                                } else {
                                                                    phi_13782_ = _e14364;
                                                                }
                                                                let _e14367 = phi_13782_;
                                                                if (_e14357 < -(_e14360)) {
                                                                    phi_13789_ = true;
                                                                } else {
                                                                    phi_13789_ = _e14364;
                                                                }
                                                                let _e14372 = phi_13789_;
                                                                if _e14365 {
                                                                    phi_13810_ = _e14237;
                                                                } else {
                                                                    if _e14364 {
                                                                        let _e14374 = (_e14360 - _e14357);
                                                                        if (_e14374 > 0.000000000000000000000000000000000000011754944f) {
                                                                            phi_13802_ = _e14374;
                                                                        } else {
                                                                            phi_13802_ = 0.000000000000000000000000000000000000011754944f;
                                                                        }
                                                                        let _e14377 = phi_13802_;
                                                                        let _e14378 = (_e14363 / _e14377);
                                                                        if (_e14237 < _e14378) {
                                                                            phi_13808_ = _e14237;
                                                                        } else {
                                                                            phi_13808_ = _e14378;
                                                                        }
                                                                        let _e14381 = phi_13808_;
                                                                        phi_13809_ = _e14381;
                                                                    } else {
                                                                        phi_13809_ = _e14237;
                                                                    }
                                                                    let _e14383 = phi_13809_;
                                                                    phi_13810_ = _e14383;
                                                                }
                                                                let _e14385 = phi_13810_;
                                                                phi_13576_ = _e14385;
                                                                phi_13578_ = (_e14239 && _e14372);
                                                                phi_13580_ = (_e14241 && _e14367);
                                                            } else {
                                                                phi_13576_ = f32();
                                                                phi_13578_ = bool();
                                                                phi_13580_ = bool();
                                                            }
                                                            let _e14387 = phi_13576_;
                                                            let _e14389 = phi_13578_;
                                                            let _e14391 = phi_13580_;
                                                            continue;
                                                            continuing {
                                                                phi_13572_ = _e14253;
                                                                phi_13575_ = _e14387;
                                                                phi_13577_ = _e14389;
                                                                phi_13579_ = _e14391;
                                                                break if !(_e14259);
                                                            }
                                                        }
                                                        let _e14394 = local_116;
                                                        if (_e14394 < 2f) {
                                                            let _e17332 = local_158;
                                                            phi_13815_ = _e17332;
                                                        } else {
                                                            phi_13815_ = 2f;
                                                        }
                                                        let _e14397 = phi_13815_;
                                                        let _e14398 = (_e14397 * 0.999f);
                                                        let _e14400 = local_117;
                                                        if _e14400 {
                                                            let _e14402 = local_118;
                                                            if _e14402 {
                                                                phi_13824_ = type_47();
                                                            } else {
                                                                phi_13824_ = type_47(1u, _e11415, 2f);
                                                            }
                                                            let _e14405 = phi_13824_;
                                                            phi_13825_ = _e14405;
                                                            let _e17339 = local_159;
                                                            phi_13826_ = _e17339;
                                                        } else {
                                                            phi_13825_ = type_47();
                                                            phi_13826_ = true;
                                                        }
                                                        let _e14407 = phi_13825_;
                                                        let _e14409 = phi_13826_;
                                                        if _e14409 {
                                                            let _e14411 = local_119;
                                                            if _e14411 {
                                                                if (_e14398 > (0.000000059604645f * 4096f)) {
                                                                    let _e14415 = (_e11415 + _e14398);
                                                                    if (_e14415 < _e5623) {
                                                                        phi_13843_ = _e14415;
                                                                    } else {
                                                                        phi_13843_ = _e5623;
                                                                    }
                                                                    let _e14418 = phi_13843_;
                                                                    phi_13844_ = _e14418;
                                                                } else {
                                                                    phi_13844_ = _e11415;
                                                                }
                                                                let _e14420 = phi_13844_;
                                                                phi_13847_ = type_9(0u, 4u);
                                                                phi_13850_ = _e14420;
                                                                phi_13852_ = _e11415;
                                                                loop {
                                                                    let _e14422 = phi_13847_;
                                                                    let _e14424 = phi_13850_;
                                                                    let _e14426 = phi_13852_;
                                                                    local_120 = _e14424;
                                                                    local_121 = _e14426;
                                                                    local_122 = _e14426;
                                                                    if (_e14422.member < _e14422.member_1) {
                                                                        phi_13848_ = type_9((_e14422.member + 1u), _e14422.member_1);
                                                                        phi_13875_ = type_9(1u, _e14422.member);
                                                                    } else {
                                                                        phi_13848_ = _e14422;
                                                                        phi_13875_ = type_9(0u, type_9().member_1);
                                                                    }
                                                                    let _e14438 = phi_13848_;
                                                                    let _e14440 = phi_13875_;
                                                                    let _e14444 = (bitcast<i32>(_e14440.member) != 0i);
                                                                    if _e14444 {
                                                                        let _e14447 = local_15.member[_e14440.member_1];
                                                                        let _e14450 = local_15.member_1[_e14440.member_1];
                                                                        let _e14453 = local_15.member[_e14440.member_1];
                                                                        let _e14459 = local_15.member_2[_e14440.member_1];
                                                                        let _e14460 = ((_e14447 + ((_e14450 - _e14453) * _e11415)) - _e14459);
                                                                        let _e14463 = local_15.member_1[_e14440.member_1];
                                                                        let _e14466 = local_15.member[_e14440.member_1];
                                                                        let _e14467 = (_e14463 - _e14466);
                                                                        if (_e14467 > 0f) {
                                                                            let _e14481 = (_e11415 - (_e14460 / _e14467));
                                                                            if (_e14426 > _e14481) {
                                                                                phi_13943_ = _e14426;
                                                                            } else {
                                                                                phi_13943_ = _e14481;
                                                                            }
                                                                            let _e14484 = phi_13943_;
                                                                            phi_13961_ = _e14424;
                                                                            phi_13962_ = _e14484;
                                                                        } else {
                                                                            if (_e14460 > 0f) {
                                                                                if (_e14467 < 0f) {
                                                                                    let _e14472 = (_e11415 - (_e14460 / _e14467));
                                                                                    if (_e14424 < _e14472) {
                                                                                        phi_13958_ = _e14424;
                                                                                    } else {
                                                                                        phi_13958_ = _e14472;
                                                                                    }
                                                                                    let _e14475 = phi_13958_;
                                                                                    phi_13959_ = _e14475;
                                                                                } else {
                                                                                    phi_13959_ = _e14424;
                                                                                }
                                                                                let _e14477 = phi_13959_;
                                                                                phi_13960_ = _e14477;
                                                                            } else {
                                                                                phi_13960_ = _e14424;
                                                                            }
                                                                            let _e14479 = phi_13960_;
                                                                            phi_13961_ = _e14479;
                                                                            phi_13962_ = _e14426;
                                                                        }
                                                                        let _e14486 = phi_13961_;
                                                                        let _e14488 = phi_13962_;
                                                                        phi_13851_ = _e14486;
                                                                        phi_13853_ = _e14488;
                                                                    } else {
                                                                        phi_13851_ = f32();
                                                                        phi_13853_ = f32();
                                                                    }
                                                                    let _e14490 = phi_13851_;
                                                                    let _e14492 = phi_13853_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_13847_ = _e14438;
                                                                        phi_13850_ = _e14490;
                                                                        phi_13852_ = _e14492;
                                                                        break if !(_e14444);
                                                                    }
                                                                }
                                                                let _e14495 = local_120;
                                                                let _e14497 = local_121;
                                                                let _e14501 = local_122;
                                                                let _e14502 = (_e14501 + ((_e14495 - _e14497) * 0.5f));
                                                                if (_e14502 > _e11415) {
                                                                    if (_e14502 <= _e14420) {
                                                                        let _e14507 = local_15.member[0u];
                                                                        let _e14510 = local_15.member_1[0u];
                                                                        let _e14513 = local_15.member[0u];
                                                                        let _e14519 = local_15.member_2[0u];
                                                                        if (((_e14507 + ((_e14510 - _e14513) * _e14502)) - _e14519) > 0f) {
                                                                            let _e14524 = local_15.member[1u];
                                                                            let _e14527 = local_15.member_1[1u];
                                                                            let _e14530 = local_15.member[1u];
                                                                            let _e14536 = local_15.member_2[1u];
                                                                            if (((_e14524 + ((_e14527 - _e14530) * _e14502)) - _e14536) > 0f) {
                                                                                let _e14541 = local_15.member[2u];
                                                                                let _e14544 = local_15.member_1[2u];
                                                                                let _e14547 = local_15.member[2u];
                                                                                let _e14553 = local_15.member_2[2u];
                                                                                if (((_e14541 + ((_e14544 - _e14547) * _e14502)) - _e14553) > 0f) {
                                                                                    let _e14558 = local_15.member[3u];
                                                                                    let _e14561 = local_15.member_1[3u];
                                                                                    let _e14564 = local_15.member[3u];
                                                                                    let _e14570 = local_15.member_2[3u];
                                                                                    phi_14123_ = (((_e14558 + ((_e14561 - _e14564) * _e14502)) - _e14570) > 0f);
                                                                                    phi_14124_ = false;
                                                                                } else {
                                                                                    phi_14123_ = bool();
                                                                                    phi_14124_ = true;
                                                                                }
                                                                                let _e14574 = phi_14123_;
                                                                                let _e14576 = phi_14124_;
                                                                                phi_14125_ = _e14574;
                                                                                phi_14126_ = _e14576;
                                                                            } else {
                                                                                phi_14125_ = bool();
                                                                                phi_14126_ = true;
                                                                            }
                                                                            let _e14578 = phi_14125_;
                                                                            let _e14580 = phi_14126_;
                                                                            phi_14127_ = _e14578;
                                                                            phi_14128_ = _e14580;
                                                                        } else {
                                                                            phi_14127_ = bool();
                                                                            phi_14128_ = true;
                                                                        }
                                                                        let _e14582 = phi_14127_;
                                                                        let _e14584 = phi_14128_;
                                                                        if _e14584 {
                                                                            phi_14132_ = false;
                                                                        } else {
                                                                            phi_14132_ = _e14582;
                                                                        }
                                                                        let _e14586 = phi_14132_;
                                                                        if _e14586 {
                                                                            phi_14136_ = false;
                                                                        } else {
                                                                            phi_14136_ = true;
                                                                        }
                                                                        let _e14588 = phi_14136_;
                                                                        phi_14137_ = _e14588;
                                                                    } else {
                                                                        phi_14137_ = true;
                                                                    }
                                                                    let _e14590 = phi_14137_;
                                                                    phi_14138_ = _e14590;
                                                                } else {
                                                                    phi_14138_ = true;
                                                                }
                                                                let _e14592 = phi_14138_;
                                                                if _e14592 {
                                                                    phi_14142_ = 2f;
                                                                } else {
                                                                    phi_14142_ = _e14502;
                                                                }
                                                                let _e14594 = phi_14142_;
                                                                phi_14145_ = type_47(2u, _e14420, _e14594);
                                                                phi_14146_ = type_47();
                                                                phi_14147_ = false;
                                                            } else {
                                                                phi_14145_ = type_47();
                                                                phi_14146_ = type_47(0u, _e11415, 2f);
                                                                phi_14147_ = true;
                                                            }
                                                            let _e14597 = phi_14145_;
                                                            let _e14599 = phi_14146_;
                                                            let _e14601 = phi_14147_;
                                                            phi_14148_ = _e14597;
                                                            phi_14149_ = _e14599;
                                                            phi_14150_ = _e14601;
                                                        } else {
                                                            phi_14148_ = type_47();
                                                            phi_14149_ = _e14407;
                                                            phi_14150_ = true;
                                                        }
                                                        let _e14603 = phi_14148_;
                                                        let _e14605 = phi_14149_;
                                                        let _e14607 = phi_14150_;
                                                        phi_14155_ = _e14605;
                                                        phi_14156_ = _e14603;
                                                        phi_14157_ = _e14607;
                                                    } else {
                                                        phi_14155_ = type_47(0u, _e11415, 2f);
                                                        phi_14156_ = type_47();
                                                        phi_14157_ = true;
                                                    }
                                                    let _e14609 = phi_14155_;
                                                    let _e14611 = phi_14156_;
                                                    let _e14613 = phi_14157_;
                                                    phi_14161_ = _e14609;
                                                    phi_14162_ = _e14611;
                                                    phi_14163_ = false;
                                                    phi_14164_ = _e14613;
                                                } else {
                                                    phi_14161_ = type_47();
                                                    phi_14162_ = type_47();
                                                    phi_14163_ = true;
                                                    phi_14164_ = false;
                                                }
                                                let _e14615 = phi_14161_;
                                                let _e14617 = phi_14162_;
                                                let _e14619 = phi_14163_;
                                                let _e14621 = phi_14164_;
                                                phi_14165_ = _e14615;
                                                phi_14166_ = _e14617;
                                                phi_14167_ = _e14619;
                                                phi_14168_ = _e14621;
                                            } else {
                                                phi_14165_ = type_47();
                                                phi_14166_ = type_47();
                                                phi_14167_ = true;
                                                phi_14168_ = false;
                                            }
                                            let _e14623 = phi_14165_;
                                            let _e14625 = phi_14166_;
                                            let _e14627 = phi_14167_;
                                            let _e14629 = phi_14168_;
                                            if _e14627 {
                                                phi_14173_ = type_47(0u, _e11415, 2f);
                                                phi_14174_ = true;
                                            } else {
                                                phi_14173_ = _e14623;
                                                phi_14174_ = _e14629;
                                            }
                                            let _e14632 = phi_14173_;
                                            let _e14634 = phi_14174_;
                                            if _e14634 {
                                                phi_14178_ = _e14632;
                                            } else {
                                                phi_14178_ = _e14625;
                                            }
                                            let _e14636 = phi_14178_;
                                            if _e5629 {
                                                if (_e14636.member == 2u) {
                                                    let _e14640 = (_e14636.member_2 <= _e5623);
                                                    if _e14640 {
                                                        phi_14194_ = _e14636.member_2;
                                                        phi_14195_ = _e14636.member_2;
                                                        phi_14196_ = false;
                                                    } else {
                                                        phi_14194_ = f32();
                                                        phi_14195_ = f32();
                                                        phi_14196_ = true;
                                                    }
                                                    let _e14644 = phi_14194_;
                                                    let _e14646 = phi_14195_;
                                                    let _e14648 = phi_14196_;
                                                    phi_14197_ = _e14644;
                                                    phi_14198_ = _e14646;
                                                    phi_14199_ = _e14640;
                                                    phi_14200_ = _e14648;
                                                    phi_14201_ = false;
                                                } else {
                                                    phi_14197_ = f32();
                                                    phi_14198_ = f32();
                                                    phi_14199_ = false;
                                                    phi_14200_ = false;
                                                    phi_14201_ = true;
                                                }
                                                let _e14650 = phi_14197_;
                                                let _e14652 = phi_14198_;
                                                let _e14654 = phi_14199_;
                                                let _e14656 = phi_14200_;
                                                let _e14658 = phi_14201_;
                                                phi_14202_ = _e14650;
                                                phi_14203_ = _e14652;
                                                phi_14204_ = _e14654;
                                                phi_14205_ = _e14656;
                                                phi_14206_ = _e14658;
                                            } else {
                                                phi_14202_ = f32();
                                                phi_14203_ = f32();
                                                phi_14204_ = false;
                                                phi_14205_ = false;
                                                phi_14206_ = true;
                                            }
                                            let _e14660 = phi_14202_;
                                            let _e14662 = phi_14203_;
                                            let _e14664 = phi_14204_;
                                            let _e14666 = phi_14205_;
                                            let _e14668 = phi_14206_;
                                            phi_14207_ = _e14660;
                                            phi_14208_ = _e14636.member;
                                            phi_14209_ = _e14662;
                                            phi_14210_ = _e14636;
                                            phi_14211_ = _e14636.member;
                                            phi_14212_ = _e14636.member;
                                            phi_14213_ = _e14664;
                                            phi_14214_ = _e14666;
                                            phi_14215_ = _e14668;
                                        }
                                        let _e14670 = phi_14207_;
                                        let _e14672 = phi_14208_;
                                        let _e14674 = phi_14209_;
                                        let _e14676 = phi_14210_;
                                        let _e14678 = phi_14211_;
                                        let _e14680 = phi_14212_;
                                        let _e14682 = phi_14213_;
                                        let _e14684 = phi_14214_;
                                        let _e14686 = phi_14215_;
                                        phi_14216_ = _e14670;
                                        phi_14217_ = _e14672;
                                        phi_14218_ = _e14674;
                                        phi_14219_ = _e14676;
                                        phi_14220_ = _e14678;
                                        phi_14221_ = _e14680;
                                        phi_14222_ = _e14682;
                                        phi_14223_ = _e13223;
                                        phi_14224_ = _e14684;
                                        phi_14225_ = _e14686;
                                        phi_14226_ = false;
                                    } else {
                                        phi_14216_ = f32();
                                        phi_14217_ = u32();
                                        phi_14218_ = f32();
                                        phi_14219_ = type_47();
                                        phi_14220_ = u32();
                                        phi_14221_ = u32();
                                        phi_14222_ = false;
                                        phi_14223_ = false;
                                        phi_14224_ = false;
                                        phi_14225_ = false;
                                        phi_14226_ = true;
                                    }
                                    let _e14688 = phi_14216_;
                                    let _e14690 = phi_14217_;
                                    let _e14692 = phi_14218_;
                                    let _e14694 = phi_14219_;
                                    let _e14696 = phi_14220_;
                                    let _e14698 = phi_14221_;
                                    let _e14700 = phi_14222_;
                                    let _e14702 = phi_14223_;
                                    let _e14704 = phi_14224_;
                                    let _e14706 = phi_14225_;
                                    let _e14708 = phi_14226_;
                                    phi_14227_ = _e13220;
                                    phi_9302_ = _e14688;
                                    phi_9304_ = _e14690;
                                    phi_9306_ = _e14692;
                                    phi_14228_ = _e14694;
                                    phi_14229_ = _e14696;
                                    phi_14230_ = _e13220;
                                    phi_14231_ = _e14698;
                                    phi_14232_ = _e14700;
                                    phi_14233_ = _e14702;
                                    phi_14234_ = _e14704;
                                    phi_14235_ = _e14706;
                                    phi_14236_ = false;
                                    phi_14237_ = _e14708;
                                } else {
                                    phi_14227_ = f32();
                                    phi_9302_ = f32();
                                    phi_9304_ = u32();
                                    phi_9306_ = f32();
                                    phi_14228_ = type_47();
                                    phi_14229_ = u32();
                                    phi_14230_ = f32();
                                    phi_14231_ = u32();
                                    phi_14232_ = false;
                                    phi_14233_ = false;
                                    phi_14234_ = false;
                                    phi_14235_ = false;
                                    phi_14236_ = true;
                                    phi_14237_ = false;
                                }
                                let _e14710 = phi_14227_;
                                let _e14712 = phi_9302_;
                                let _e14714 = phi_9304_;
                                let _e14716 = phi_9306_;
                                let _e14718 = phi_14228_;
                                let _e14720 = phi_14229_;
                                let _e14722 = phi_14230_;
                                let _e14724 = phi_14231_;
                                let _e14726 = phi_14232_;
                                let _e14728 = phi_14233_;
                                let _e14730 = phi_14234_;
                                let _e14732 = phi_14235_;
                                let _e14734 = phi_14236_;
                                let _e14736 = phi_14237_;
                                local_123 = _e14728;
                                local_160 = _e14730;
                                local_161 = _e14732;
                                local_162 = _e14734;
                                local_163 = _e14736;
                                local_124 = _e14718;
                                local_125 = _e14718;
                                local_164 = _e14720;
                                local_126 = _e14718;
                                local_165 = _e14728;
                                local_166 = _e14724;
                                local_168 = _e14722;
                                local_169 = _e14710;
                                continue;
                                continuing {
                                    phi_9298_ = _e11438;
                                    phi_9301_ = _e14712;
                                    phi_9303_ = _e14714;
                                    phi_9305_ = _e14716;
                                    break if !(_e14726);
                                }
                            }
                            let _e14739 = local_123;
                            if _e14739 {
                                phi_14241_ = false;
                                phi_14242_ = false;
                                phi_14243_ = false;
                                phi_14244_ = false;
                            } else {
                                let _e17440 = local_160;
                                phi_14241_ = _e17440;
                                let _e17443 = local_161;
                                phi_14242_ = _e17443;
                                let _e17446 = local_162;
                                phi_14243_ = _e17446;
                                let _e17449 = local_163;
                                phi_14244_ = _e17449;
                            }
                            let _e14741 = phi_14241_;
                            let _e14743 = phi_14242_;
                            let _e14745 = phi_14243_;
                            let _e14747 = phi_14244_;
                            if _e14741 {
                                let _e14749 = local_124;
                                if (_e14749.member_1 >= _e5623) {
                                    phi_14266_ = type_46(type_45(0u, f32()), 0u);
                                } else {
                                    let _e14753 = local_125;
                                    if (_e14753.member_1 > _e5621) {
                                        phi_14261_ = 0u;
                                    } else {
                                        let _e17454 = local_164;
                                        phi_14261_ = _e17454;
                                    }
                                    let _e14757 = phi_14261_;
                                    let _e14759 = local_126;
                                    phi_14266_ = type_46(type_45(2u, _e14759.member_1), _e14757);
                                }
                                let _e14766 = phi_14266_;
                                phi_14267_ = _e14766;
                                phi_14268_ = false;
                                phi_14269_ = false;
                                phi_14270_ = false;
                                phi_14271_ = false;
                            } else {
                                phi_14267_ = type_46();
                                phi_14268_ = _e14743;
                                let _e17461 = local_165;
                                phi_14269_ = _e17461;
                                phi_14270_ = _e14745;
                                phi_14271_ = _e14747;
                            }
                            let _e14768 = phi_14267_;
                            let _e14770 = phi_14268_;
                            let _e14772 = phi_14269_;
                            let _e14774 = phi_14270_;
                            let _e14776 = phi_14271_;
                            if _e14770 {
                                let _e17466 = local_166;
                                phi_14275_ = _e17466;
                                let _e17471 = local_168;
                                phi_14276_ = _e17471;
                                phi_14277_ = true;
                                phi_14278_ = false;
                                phi_14279_ = false;
                                phi_14280_ = false;
                            } else {
                                let _e17468 = local_167;
                                phi_14275_ = _e17468;
                                let _e17473 = local_169;
                                phi_14276_ = _e17473;
                                phi_14277_ = _e14772;
                                phi_14278_ = _e14774;
                                phi_14279_ = _e14776;
                                phi_14280_ = _e14741;
                            }
                            let _e14778 = phi_14275_;
                            let _e14780 = phi_14276_;
                            let _e14782 = phi_14277_;
                            let _e14784 = phi_14278_;
                            let _e14786 = phi_14279_;
                            let _e14788 = phi_14280_;
                            if _e14782 {
                                phi_14284_ = _e14780;
                                phi_14285_ = _e14778;
                                phi_14286_ = true;
                                phi_14287_ = false;
                                phi_14288_ = false;
                            } else {
                                let _e17480 = local_170;
                                phi_14284_ = _e17480;
                                let _e17483 = local_171;
                                phi_14285_ = _e17483;
                                phi_14286_ = _e14784;
                                phi_14287_ = _e14786;
                                phi_14288_ = _e14788;
                            }
                            let _e14790 = phi_14284_;
                            let _e14792 = phi_14285_;
                            let _e14794 = phi_14286_;
                            let _e14796 = phi_14287_;
                            let _e14798 = phi_14288_;
                            if _e14794 {
                                local_13[0u] = 0.01f;
                                local_13[1u] = 0f;
                                local_13[2u] = 0.8f;
                                if (_e5619 >= (0.000000059604645f * 8f)) {
                                    phi_14300_ = _e5619;
                                } else {
                                    phi_14300_ = 0f;
                                }
                                let _e14805 = phi_14300_;
                                phi_14303_ = type_9(0u, 3u);
                                loop {
                                    let _e14807 = phi_14303_;
                                    if (_e14807.member < _e14807.member_1) {
                                        phi_14304_ = type_9((_e14807.member + 1u), _e14807.member_1);
                                        phi_14327_ = type_9(1u, _e14807.member);
                                    } else {
                                        phi_14304_ = _e14807;
                                        phi_14327_ = type_9(0u, type_9().member_1);
                                    }
                                    let _e14819 = phi_14304_;
                                    let _e14821 = phi_14327_;
                                    if (bitcast<i32>(_e14821.member) != 0i) {
                                        let _e14827 = local_13[_e14821.member_1];
                                        let _e14829 = (_e14790 + (_e14805 * _e14827));
                                        if (_e14829 < _e5623) {
                                            phi_14348_ = _e14829;
                                        } else {
                                            phi_14348_ = _e5623;
                                        }
                                        let _e14832 = phi_14348_;
                                        let _e14835 = local_18.member[0u];
                                        let _e14841 = local_18.member[1u];
                                        let _e14857 = local_18.member_1[0u];
                                        let _e14863 = local_18.member_1[1u];
                                        let _e14879 = local_18.member_2[0u];
                                        let _e14885 = local_18.member_2[1u];
                                        let _e14899 = function_4(array<f32, 3>((_e14835[0] + ((_e14841[0] - _e14835[0]) * _e14832)), (_e14835[1] + ((_e14841[1] - _e14835[1]) * _e14832)), (_e14835[2] + ((_e14841[2] - _e14835[2]) * _e14832))), array<f32, 3>((_e14857[0] + ((_e14863[0] - _e14857[0]) * _e14832)), (_e14857[1] + ((_e14863[1] - _e14857[1]) * _e14832)), (_e14857[2] + ((_e14863[2] - _e14857[2]) * _e14832))), array<f32, 3>((_e14879[0] + ((_e14885[0] - _e14879[0]) * _e14832)), (_e14879[1] + ((_e14885[1] - _e14879[1]) * _e14832)), (_e14879[2] + ((_e14885[2] - _e14879[2]) * _e14832))), _e316.member);
                                        let _e14910 = (((_e14899[0] * _e14899[0]) + (_e14899[1] * _e14899[1])) + (_e14899[2] * _e14899[2]));
                                        if (_e14910 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e14910 > 0f) {
                                                phi_14471_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_14471_ = 0f;
                                            }
                                            let _e14963 = phi_14471_;
                                            phi_14535_ = _e14963;
                                        } else {
                                            phi_14478_ = type_14(0i, 5i);
                                            phi_14481_ = bitcast<f32>(((bitcast<u32>(_e14910) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e14918 = phi_14478_;
                                                let _e14920 = phi_14481_;
                                                local_127 = _e14920;
                                                if (_e14918.member < _e14918.member_1) {
                                                    let _e14927 = (_e14918.member + 1i);
                                                    if ((false == (_e14927 > _e14918.member)) != false) {
                                                        phi_14502_ = true;
                                                    } else {
                                                        phi_14502_ = false;
                                                    }
                                                    let _e14932 = phi_14502_;
                                                    if _e14932 {
                                                        phi_14508_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_14508_ = type_15(1u, _e14927);
                                                    }
                                                    let _e14937 = phi_14508_;
                                                    phi_14479_ = type_14(_e14937.member_1, _e14918.member_1);
                                                    phi_14522_ = type_15(1u, _e14918.member);
                                                } else {
                                                    phi_14479_ = _e14918;
                                                    phi_14522_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e14943 = phi_14479_;
                                                let _e14945 = phi_14522_;
                                                let _e14948 = (bitcast<i32>(_e14945.member) != 0i);
                                                if _e14948 {
                                                    phi_14482_ = (0.5f * (_e14920 + (_e14910 / _e14920)));
                                                } else {
                                                    phi_14482_ = f32();
                                                }
                                                let _e14953 = phi_14482_;
                                                continue;
                                                continuing {
                                                    phi_14478_ = _e14943;
                                                    phi_14481_ = _e14953;
                                                    break if !(_e14948);
                                                }
                                            }
                                            let _e14958 = local_127;
                                            phi_14535_ = (_e14958 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e14965 = phi_14535_;
                                        let _e14971 = local_18.member[0u];
                                        if (_e14971[0] < 0f) {
                                            phi_14551_ = -(_e14971[0]);
                                        } else {
                                            phi_14551_ = _e14971[0];
                                        }
                                        let _e14978 = phi_14551_;
                                        if (_e14971[1] < 0f) {
                                            phi_14558_ = -(_e14971[1]);
                                        } else {
                                            phi_14558_ = _e14971[1];
                                        }
                                        let _e14982 = phi_14558_;
                                        if (_e14978 > _e14982) {
                                            phi_14563_ = _e14978;
                                        } else {
                                            phi_14563_ = _e14982;
                                        }
                                        let _e14985 = phi_14563_;
                                        if (_e14971[2] < 0f) {
                                            phi_14570_ = -(_e14971[2]);
                                        } else {
                                            phi_14570_ = _e14971[2];
                                        }
                                        let _e14989 = phi_14570_;
                                        if (_e14985 > _e14989) {
                                            phi_14575_ = _e14985;
                                        } else {
                                            phi_14575_ = _e14989;
                                        }
                                        let _e14992 = phi_14575_;
                                        let _e14995 = local_18.member[1u];
                                        if (_e14995[0] < 0f) {
                                            phi_14588_ = -(_e14995[0]);
                                        } else {
                                            phi_14588_ = _e14995[0];
                                        }
                                        let _e15002 = phi_14588_;
                                        if (_e14995[1] < 0f) {
                                            phi_14595_ = -(_e14995[1]);
                                        } else {
                                            phi_14595_ = _e14995[1];
                                        }
                                        let _e15006 = phi_14595_;
                                        if (_e15002 > _e15006) {
                                            phi_14600_ = _e15002;
                                        } else {
                                            phi_14600_ = _e15006;
                                        }
                                        let _e15009 = phi_14600_;
                                        if (_e14995[2] < 0f) {
                                            phi_14607_ = -(_e14995[2]);
                                        } else {
                                            phi_14607_ = _e14995[2];
                                        }
                                        let _e15013 = phi_14607_;
                                        if (_e15009 > _e15013) {
                                            phi_14612_ = _e15009;
                                        } else {
                                            phi_14612_ = _e15013;
                                        }
                                        let _e15016 = phi_14612_;
                                        if (_e14992 > _e15016) {
                                            phi_14617_ = _e14992;
                                        } else {
                                            phi_14617_ = _e15016;
                                        }
                                        let _e15019 = phi_14617_;
                                        let _e15021 = local_18.member_3;
                                        let _e15025 = local_18.member_1[0u];
                                        if (_e15025[0] < 0f) {
                                            phi_14634_ = -(_e15025[0]);
                                        } else {
                                            phi_14634_ = _e15025[0];
                                        }
                                        let _e15032 = phi_14634_;
                                        if (_e15025[1] < 0f) {
                                            phi_14641_ = -(_e15025[1]);
                                        } else {
                                            phi_14641_ = _e15025[1];
                                        }
                                        let _e15036 = phi_14641_;
                                        if (_e15032 > _e15036) {
                                            phi_14646_ = _e15032;
                                        } else {
                                            phi_14646_ = _e15036;
                                        }
                                        let _e15039 = phi_14646_;
                                        if (_e15025[2] < 0f) {
                                            phi_14653_ = -(_e15025[2]);
                                        } else {
                                            phi_14653_ = _e15025[2];
                                        }
                                        let _e15043 = phi_14653_;
                                        if (_e15039 > _e15043) {
                                            phi_14658_ = _e15039;
                                        } else {
                                            phi_14658_ = _e15043;
                                        }
                                        let _e15046 = phi_14658_;
                                        let _e15049 = local_18.member_1[1u];
                                        if (_e15049[0] < 0f) {
                                            phi_14672_ = -(_e15049[0]);
                                        } else {
                                            phi_14672_ = _e15049[0];
                                        }
                                        let _e15056 = phi_14672_;
                                        if (_e15049[1] < 0f) {
                                            phi_14679_ = -(_e15049[1]);
                                        } else {
                                            phi_14679_ = _e15049[1];
                                        }
                                        let _e15060 = phi_14679_;
                                        if (_e15056 > _e15060) {
                                            phi_14684_ = _e15056;
                                        } else {
                                            phi_14684_ = _e15060;
                                        }
                                        let _e15063 = phi_14684_;
                                        if (_e15049[2] < 0f) {
                                            phi_14691_ = -(_e15049[2]);
                                        } else {
                                            phi_14691_ = _e15049[2];
                                        }
                                        let _e15067 = phi_14691_;
                                        if (_e15063 > _e15067) {
                                            phi_14696_ = _e15063;
                                        } else {
                                            phi_14696_ = _e15067;
                                        }
                                        let _e15070 = phi_14696_;
                                        if (_e15046 > _e15070) {
                                            phi_14701_ = _e15046;
                                        } else {
                                            phi_14701_ = _e15070;
                                        }
                                        let _e15073 = phi_14701_;
                                        let _e15075 = local_18.member_3;
                                        let _e15079 = local_18.member_2[0u];
                                        if (_e15079[0] < 0f) {
                                            phi_14718_ = -(_e15079[0]);
                                        } else {
                                            phi_14718_ = _e15079[0];
                                        }
                                        let _e15086 = phi_14718_;
                                        if (_e15079[1] < 0f) {
                                            phi_14725_ = -(_e15079[1]);
                                        } else {
                                            phi_14725_ = _e15079[1];
                                        }
                                        let _e15090 = phi_14725_;
                                        if (_e15086 > _e15090) {
                                            phi_14730_ = _e15086;
                                        } else {
                                            phi_14730_ = _e15090;
                                        }
                                        let _e15093 = phi_14730_;
                                        if (_e15079[2] < 0f) {
                                            phi_14737_ = -(_e15079[2]);
                                        } else {
                                            phi_14737_ = _e15079[2];
                                        }
                                        let _e15097 = phi_14737_;
                                        if (_e15093 > _e15097) {
                                            phi_14742_ = _e15093;
                                        } else {
                                            phi_14742_ = _e15097;
                                        }
                                        let _e15100 = phi_14742_;
                                        let _e15103 = local_18.member_2[1u];
                                        if (_e15103[0] < 0f) {
                                            phi_14756_ = -(_e15103[0]);
                                        } else {
                                            phi_14756_ = _e15103[0];
                                        }
                                        let _e15110 = phi_14756_;
                                        if (_e15103[1] < 0f) {
                                            phi_14763_ = -(_e15103[1]);
                                        } else {
                                            phi_14763_ = _e15103[1];
                                        }
                                        let _e15114 = phi_14763_;
                                        if (_e15110 > _e15114) {
                                            phi_14768_ = _e15110;
                                        } else {
                                            phi_14768_ = _e15114;
                                        }
                                        let _e15117 = phi_14768_;
                                        if (_e15103[2] < 0f) {
                                            phi_14775_ = -(_e15103[2]);
                                        } else {
                                            phi_14775_ = _e15103[2];
                                        }
                                        let _e15121 = phi_14775_;
                                        if (_e15117 > _e15121) {
                                            phi_14780_ = _e15117;
                                        } else {
                                            phi_14780_ = _e15121;
                                        }
                                        let _e15124 = phi_14780_;
                                        if (_e15100 > _e15124) {
                                            phi_14785_ = _e15100;
                                        } else {
                                            phi_14785_ = _e15124;
                                        }
                                        let _e15127 = phi_14785_;
                                        let _e15129 = local_18.member_3;
                                        let _e15136 = local_18.member_3;
                                        let _e15143 = (((_e14965 * (1f + (0.000000059604645f * 8f))) + (((((((_e15019 + _e15021) + (_e15073 + _e15075)) + (_e15127 + _e15129)) * (0.000000059604645f * 16f)) + (_e15136 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e5889.member_1);
                                        if _e15143 {
                                            phi_14805_ = false;
                                        } else {
                                            phi_14805_ = true;
                                        }
                                        let _e15145 = phi_14805_;
                                        phi_14806_ = _e15145;
                                        phi_14807_ = _e15143;
                                    } else {
                                        phi_14806_ = false;
                                        phi_14807_ = false;
                                    }
                                    let _e15147 = phi_14806_;
                                    let _e15149 = phi_14807_;
                                    local_128 = _e15149;
                                    continue;
                                    continuing {
                                        phi_14303_ = _e14819;
                                        break if !(_e15147);
                                    }
                                }
                                let _e15152 = local_128;
                                if _e15152 {
                                    if (_e14790 > _e5621) {
                                        phi_14815_ = 1u;
                                    } else {
                                        phi_14815_ = _e14792;
                                    }
                                    let _e15155 = phi_14815_;
                                    phi_14819_ = type_46(type_45(1u, _e14790), _e15155);
                                    phi_14820_ = false;
                                } else {
                                    phi_14819_ = type_46();
                                    phi_14820_ = true;
                                }
                                let _e15159 = phi_14819_;
                                let _e15161 = phi_14820_;
                                if _e15161 {
                                    if (_e14790 > _e5621) {
                                        phi_14828_ = 0u;
                                    } else {
                                        phi_14828_ = _e14792;
                                    }
                                    let _e15164 = phi_14828_;
                                    phi_14832_ = type_46(type_45(2u, _e14790), _e15164);
                                } else {
                                    phi_14832_ = _e15159;
                                }
                                let _e15168 = phi_14832_;
                                phi_14833_ = _e15168;
                                phi_14834_ = false;
                                phi_14835_ = false;
                            } else {
                                phi_14833_ = type_46();
                                phi_14834_ = _e14796;
                                phi_14835_ = _e14798;
                            }
                            let _e15170 = phi_14833_;
                            let _e15172 = phi_14834_;
                            let _e15174 = phi_14835_;
                            if _e15172 {
                                phi_14842_ = type_46(type_45(0u, f32()), 0u);
                                phi_14843_ = true;
                            } else {
                                phi_14842_ = _e14768;
                                phi_14843_ = _e15174;
                            }
                            let _e15178 = phi_14842_;
                            let _e15180 = phi_14843_;
                            phi_14847_ = _e15178;
                            phi_14848_ = _e15170;
                            phi_14849_ = _e15180;
                        } else {
                            phi_14847_ = _e11405;
                            phi_14848_ = type_46();
                            phi_14849_ = true;
                        }
                        let _e15182 = phi_14847_;
                        let _e15184 = phi_14848_;
                        let _e15186 = phi_14849_;
                        if _e15186 {
                            phi_14853_ = _e15182;
                        } else {
                            phi_14853_ = _e15184;
                        }
                        let _e15188 = phi_14853_;
                        phi_22368_ = _e15188;
                    } else {
                        let _e5933 = local_18.member_1[0u];
                        let _e5939 = local_18.member_2[0u];
                        let _e5945 = ((_e5933[1] * _e5939[2]) - (_e5933[2] * _e5939[1]));
                        let _e5948 = ((_e5933[2] * _e5939[0]) - (_e5933[0] * _e5939[2]));
                        let _e5951 = ((_e5933[0] * _e5939[1]) - (_e5933[1] * _e5939[0]));
                        let _e5954 = local_18.member_1[1u];
                        let _e5960 = local_18.member_2[1u];
                        let _e5966 = ((_e5954[1] * _e5960[2]) - (_e5954[2] * _e5960[1]));
                        let _e5969 = ((_e5954[2] * _e5960[0]) - (_e5954[0] * _e5960[2]));
                        let _e5972 = ((_e5954[0] * _e5960[1]) - (_e5954[1] * _e5960[0]));
                        let _e5975 = local_18.member_1[0u];
                        let _e5981 = local_18.member_2[1u];
                        let _e5996 = local_18.member_1[1u];
                        let _e6002 = local_18.member_2[0u];
                        let _e6015 = (((_e5975[1] * _e5981[2]) - (_e5975[2] * _e5981[1])) + ((_e5996[1] * _e6002[2]) - (_e5996[2] * _e6002[1])));
                        let _e6016 = (((_e5975[2] * _e5981[0]) - (_e5975[0] * _e5981[2])) + ((_e5996[2] * _e6002[0]) - (_e5996[0] * _e6002[2])));
                        let _e6017 = (((_e5975[0] * _e5981[1]) - (_e5975[1] * _e5981[0])) + ((_e5996[0] * _e6002[1]) - (_e5996[1] * _e6002[0])));
                        let _e6020 = local_18.member[0u];
                        let _e6028 = (((_e6020[0] * _e5945) + (_e6020[1] * _e5948)) + (_e6020[2] * _e5951));
                        let _e6031 = local_18.member[1u];
                        let _e6042 = local_18.member[0u];
                        let _e6051 = ((((_e6031[0] * _e5945) + (_e6031[1] * _e5948)) + (_e6031[2] * _e5951)) + (((_e6042[0] * _e6015) + (_e6042[1] * _e6016)) + (_e6042[2] * _e6017)));
                        let _e6054 = local_18.member[0u];
                        let _e6065 = local_18.member[1u];
                        let _e6074 = ((((_e6054[0] * _e5966) + (_e6054[1] * _e5969)) + (_e6054[2] * _e5972)) + (((_e6065[0] * _e6015) + (_e6065[1] * _e6016)) + (_e6065[2] * _e6017)));
                        let _e6077 = local_18.member[1u];
                        let _e6085 = (((_e6077[0] * _e5966) + (_e6077[1] * _e5969)) + (_e6077[2] * _e5972));
                        let _e6088 = local_18.member[0u];
                        if (_e6088[0] < 0f) {
                            phi_15095_ = -(_e6088[0]);
                        } else {
                            phi_15095_ = _e6088[0];
                        }
                        let _e6095 = phi_15095_;
                        if (_e6088[1] < 0f) {
                            phi_15102_ = -(_e6088[1]);
                        } else {
                            phi_15102_ = _e6088[1];
                        }
                        let _e6099 = phi_15102_;
                        if (_e6095 > _e6099) {
                            phi_15107_ = _e6095;
                        } else {
                            phi_15107_ = _e6099;
                        }
                        let _e6102 = phi_15107_;
                        if (_e6088[2] < 0f) {
                            phi_15114_ = -(_e6088[2]);
                        } else {
                            phi_15114_ = _e6088[2];
                        }
                        let _e6106 = phi_15114_;
                        if (_e6102 > _e6106) {
                            phi_15119_ = _e6102;
                        } else {
                            phi_15119_ = _e6106;
                        }
                        let _e6109 = phi_15119_;
                        let _e6112 = local_18.member[1u];
                        if (_e6112[0] < 0f) {
                            phi_15132_ = -(_e6112[0]);
                        } else {
                            phi_15132_ = _e6112[0];
                        }
                        let _e6119 = phi_15132_;
                        if (_e6112[1] < 0f) {
                            phi_15139_ = -(_e6112[1]);
                        } else {
                            phi_15139_ = _e6112[1];
                        }
                        let _e6123 = phi_15139_;
                        if (_e6119 > _e6123) {
                            phi_15144_ = _e6119;
                        } else {
                            phi_15144_ = _e6123;
                        }
                        let _e6126 = phi_15144_;
                        if (_e6112[2] < 0f) {
                            phi_15151_ = -(_e6112[2]);
                        } else {
                            phi_15151_ = _e6112[2];
                        }
                        let _e6130 = phi_15151_;
                        if (_e6126 > _e6130) {
                            phi_15156_ = _e6126;
                        } else {
                            phi_15156_ = _e6130;
                        }
                        let _e6133 = phi_15156_;
                        if (_e6109 > _e6133) {
                            phi_15161_ = _e6109;
                        } else {
                            phi_15161_ = _e6133;
                        }
                        let _e6136 = phi_15161_;
                        let _e6138 = local_18.member_3;
                        let _e6139 = (_e6136 + _e6138);
                        let _e6142 = local_18.member_1[0u];
                        if (_e6142[0] < 0f) {
                            phi_15178_ = -(_e6142[0]);
                        } else {
                            phi_15178_ = _e6142[0];
                        }
                        let _e6149 = phi_15178_;
                        if (_e6142[1] < 0f) {
                            phi_15185_ = -(_e6142[1]);
                        } else {
                            phi_15185_ = _e6142[1];
                        }
                        let _e6153 = phi_15185_;
                        if (_e6149 > _e6153) {
                            phi_15190_ = _e6149;
                        } else {
                            phi_15190_ = _e6153;
                        }
                        let _e6156 = phi_15190_;
                        if (_e6142[2] < 0f) {
                            phi_15197_ = -(_e6142[2]);
                        } else {
                            phi_15197_ = _e6142[2];
                        }
                        let _e6160 = phi_15197_;
                        if (_e6156 > _e6160) {
                            phi_15202_ = _e6156;
                        } else {
                            phi_15202_ = _e6160;
                        }
                        let _e6163 = phi_15202_;
                        let _e6166 = local_18.member_1[1u];
                        if (_e6166[0] < 0f) {
                            phi_15216_ = -(_e6166[0]);
                        } else {
                            phi_15216_ = _e6166[0];
                        }
                        let _e6173 = phi_15216_;
                        if (_e6166[1] < 0f) {
                            phi_15223_ = -(_e6166[1]);
                        } else {
                            phi_15223_ = _e6166[1];
                        }
                        let _e6177 = phi_15223_;
                        if (_e6173 > _e6177) {
                            phi_15228_ = _e6173;
                        } else {
                            phi_15228_ = _e6177;
                        }
                        let _e6180 = phi_15228_;
                        if (_e6166[2] < 0f) {
                            phi_15235_ = -(_e6166[2]);
                        } else {
                            phi_15235_ = _e6166[2];
                        }
                        let _e6184 = phi_15235_;
                        if (_e6180 > _e6184) {
                            phi_15240_ = _e6180;
                        } else {
                            phi_15240_ = _e6184;
                        }
                        let _e6187 = phi_15240_;
                        if (_e6163 > _e6187) {
                            phi_15245_ = _e6163;
                        } else {
                            phi_15245_ = _e6187;
                        }
                        let _e6190 = phi_15245_;
                        let _e6192 = local_18.member_3;
                        let _e6193 = (_e6190 + _e6192);
                        let _e6196 = local_18.member_2[0u];
                        if (_e6196[0] < 0f) {
                            phi_15262_ = -(_e6196[0]);
                        } else {
                            phi_15262_ = _e6196[0];
                        }
                        let _e6203 = phi_15262_;
                        if (_e6196[1] < 0f) {
                            phi_15269_ = -(_e6196[1]);
                        } else {
                            phi_15269_ = _e6196[1];
                        }
                        let _e6207 = phi_15269_;
                        if (_e6203 > _e6207) {
                            phi_15274_ = _e6203;
                        } else {
                            phi_15274_ = _e6207;
                        }
                        let _e6210 = phi_15274_;
                        if (_e6196[2] < 0f) {
                            phi_15281_ = -(_e6196[2]);
                        } else {
                            phi_15281_ = _e6196[2];
                        }
                        let _e6214 = phi_15281_;
                        if (_e6210 > _e6214) {
                            phi_15286_ = _e6210;
                        } else {
                            phi_15286_ = _e6214;
                        }
                        let _e6217 = phi_15286_;
                        let _e6220 = local_18.member_2[1u];
                        if (_e6220[0] < 0f) {
                            phi_15300_ = -(_e6220[0]);
                        } else {
                            phi_15300_ = _e6220[0];
                        }
                        let _e6227 = phi_15300_;
                        if (_e6220[1] < 0f) {
                            phi_15307_ = -(_e6220[1]);
                        } else {
                            phi_15307_ = _e6220[1];
                        }
                        let _e6231 = phi_15307_;
                        if (_e6227 > _e6231) {
                            phi_15312_ = _e6227;
                        } else {
                            phi_15312_ = _e6231;
                        }
                        let _e6234 = phi_15312_;
                        if (_e6220[2] < 0f) {
                            phi_15319_ = -(_e6220[2]);
                        } else {
                            phi_15319_ = _e6220[2];
                        }
                        let _e6238 = phi_15319_;
                        if (_e6234 > _e6238) {
                            phi_15324_ = _e6234;
                        } else {
                            phi_15324_ = _e6238;
                        }
                        let _e6241 = phi_15324_;
                        if (_e6217 > _e6241) {
                            phi_15329_ = _e6217;
                        } else {
                            phi_15329_ = _e6241;
                        }
                        let _e6244 = phi_15329_;
                        let _e6246 = local_18.member_3;
                        let _e6247 = (_e6244 + _e6246);
                        let _e6249 = ((_e6193 * 8f) * _e6247);
                        let _e6256 = local_18.member_3;
                        if (_e5945 < 0f) {
                            phi_15360_ = -(_e5945);
                        } else {
                            phi_15360_ = _e5945;
                        }
                        let _e6273 = phi_15360_;
                        if (_e5948 < 0f) {
                            phi_15366_ = -(_e5948);
                        } else {
                            phi_15366_ = _e5948;
                        }
                        let _e6277 = phi_15366_;
                        if (_e5951 < 0f) {
                            phi_15373_ = -(_e5951);
                        } else {
                            phi_15373_ = _e5951;
                        }
                        let _e6282 = phi_15373_;
                        let _e6283 = ((_e6273 + _e6277) + _e6282);
                        if (_e5966 < 0f) {
                            phi_15380_ = -(_e5966);
                        } else {
                            phi_15380_ = _e5966;
                        }
                        let _e6287 = phi_15380_;
                        if (_e5969 < 0f) {
                            phi_15386_ = -(_e5969);
                        } else {
                            phi_15386_ = _e5969;
                        }
                        let _e6291 = phi_15386_;
                        if (_e5972 < 0f) {
                            phi_15393_ = -(_e5972);
                        } else {
                            phi_15393_ = _e5972;
                        }
                        let _e6296 = phi_15393_;
                        let _e6297 = ((_e6287 + _e6291) + _e6296);
                        if (_e6283 > _e6297) {
                            phi_15399_ = _e6283;
                        } else {
                            phi_15399_ = _e6297;
                        }
                        let _e6300 = phi_15399_;
                        if (_e6015 < 0f) {
                            phi_15405_ = -(_e6015);
                        } else {
                            phi_15405_ = _e6015;
                        }
                        let _e6304 = phi_15405_;
                        if (_e6016 < 0f) {
                            phi_15411_ = -(_e6016);
                        } else {
                            phi_15411_ = _e6016;
                        }
                        let _e6308 = phi_15411_;
                        if (_e6017 < 0f) {
                            phi_15418_ = -(_e6017);
                        } else {
                            phi_15418_ = _e6017;
                        }
                        let _e6313 = phi_15418_;
                        let _e6315 = (((_e6304 + _e6308) + _e6313) * 0.5f);
                        if (_e6300 > _e6315) {
                            phi_15425_ = _e6300;
                        } else {
                            phi_15425_ = _e6315;
                        }
                        let _e6318 = phi_15425_;
                        let _e6323 = local_18.member_3;
                        let _e6335 = (((((_e6139 * 8f) * _e6249) * (0.000000059604645f * (524f / 64f))) + ((_e6256 * 19f) * ((_e6139 * (_e6193 + _e6247)) + (_e6193 * _e6247)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6139) * ((1f + _e6193) * (1f + _e6247)))));
                        let _e6336 = (_e6028 * 3f);
                        let _e6337 = (_e6085 * 3f);
                        if (_e6336 < _e6337) {
                            phi_15449_ = _e6336;
                        } else {
                            phi_15449_ = _e6337;
                        }
                        let _e6340 = phi_15449_;
                        if (_e6051 < _e6074) {
                            phi_15454_ = _e6051;
                        } else {
                            phi_15454_ = _e6074;
                        }
                        let _e6343 = phi_15454_;
                        if (_e6340 < _e6343) {
                            phi_15459_ = _e6340;
                        } else {
                            phi_15459_ = _e6343;
                        }
                        let _e6346 = phi_15459_;
                        if (_e6336 > _e6337) {
                            phi_15464_ = _e6336;
                        } else {
                            phi_15464_ = _e6337;
                        }
                        let _e6349 = phi_15464_;
                        if (_e6051 > _e6074) {
                            phi_15469_ = _e6051;
                        } else {
                            phi_15469_ = _e6074;
                        }
                        let _e6352 = phi_15469_;
                        if (_e6349 > _e6352) {
                            phi_15474_ = _e6349;
                        } else {
                            phi_15474_ = _e6352;
                        }
                        let _e6355 = phi_15474_;
                        let _e6360 = -(_e6355);
                        if (_e6346 > _e6360) {
                            phi_15484_ = _e6346;
                        } else {
                            phi_15484_ = _e6360;
                        }
                        let _e6363 = phi_15484_;
                        if ((_e6363 - (_e6335 + ((0f * (((_e6318 + (_e6249 * (0.000000059604645f * 8f))) + ((_e6323 * 6f) * (_e6193 + _e6247))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6193) * (1f + _e6247))))) * (3f * 1.0001f)))) > 0f) {
                            phi_22338_ = type_45(0u, type_45().member_1);
                            phi_22339_ = type_45();
                            phi_22340_ = true;
                        } else {
                            if (_e6028 < 0f) {
                                phi_15497_ = -(_e6028);
                            } else {
                                phi_15497_ = _e6028;
                            }
                            let _e6370 = phi_15497_;
                            if (_e6051 < 0f) {
                                phi_15503_ = -(_e6051);
                            } else {
                                phi_15503_ = _e6051;
                            }
                            let _e6374 = phi_15503_;
                            if (_e6370 > _e6374) {
                                phi_15508_ = _e6370;
                            } else {
                                phi_15508_ = _e6374;
                            }
                            let _e6377 = phi_15508_;
                            if (_e6074 < 0f) {
                                phi_15514_ = -(_e6074);
                            } else {
                                phi_15514_ = _e6074;
                            }
                            let _e6381 = phi_15514_;
                            if (_e6085 < 0f) {
                                phi_15520_ = -(_e6085);
                            } else {
                                phi_15520_ = _e6085;
                            }
                            let _e6385 = phi_15520_;
                            if (_e6381 > _e6385) {
                                phi_15525_ = _e6381;
                            } else {
                                phi_15525_ = _e6385;
                            }
                            let _e6388 = phi_15525_;
                            if (_e6377 > _e6388) {
                                phi_15530_ = _e6377;
                            } else {
                                phi_15530_ = _e6388;
                            }
                            let _e6391 = phi_15530_;
                            let _e6392 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                            if (_e6391 >= _e6392) {
                                phi_15538_ = (_e6391 <= (1f / _e6392));
                            } else {
                                phi_15538_ = false;
                            }
                            let _e6397 = phi_15538_;
                            if _e6397 {
                                phi_15543_ = (0.000000059604645f * 256f);
                            } else {
                                phi_15543_ = 2f;
                            }
                            let _e6400 = phi_15543_;
                            let _e6402 = ((_e6335 * 0.34f) + (_e6391 * _e6400));
                            if _e6397 {
                                phi_15550_ = (1f / _e6391);
                            } else {
                                phi_15550_ = 0f;
                            }
                            let _e6405 = phi_15550_;
                            let _e6406 = (_e5619 * 0.0625f);
                            if (0.00000000000022737368f < _e6406) {
                                phi_15556_ = 0.00000000000022737368f;
                            } else {
                                phi_15556_ = _e6406;
                            }
                            let _e6409 = phi_15556_;
                            let _e6410 = (1f - _e5621);
                            let _e6421 = ((((_e6028 * _e6410) + (_e6051 * _e5621)) * (_e6410 * _e6410)) + (((_e6074 * _e6410) + (_e6085 * _e5621)) * (_e5621 * _e5621)));
                            if (_e6421 < 0f) {
                                phi_15574_ = -(_e6421);
                            } else {
                                phi_15574_ = _e6421;
                            }
                            let _e6425 = phi_15574_;
                            if !((_e6425 > _e6402)) {
                                let _e6430 = local_18.member[0u];
                                let _e6437 = local_18.member_1[0u];
                                let _e6443 = local_18.member_2[0u];
                                let _e6447 = (_e6430[0] - _e6437[0]);
                                let _e6448 = (_e6430[1] - _e6437[1]);
                                let _e6449 = (_e6430[2] - _e6437[2]);
                                if (_e316.member == 0u) {
                                    phi_15635_ = array<f32, 3>(_e6430[0], _e6430[1], _e6430[2]);
                                } else {
                                    phi_15635_ = array<f32, 3>((_e6447 - _e6443[0]), (_e6448 - _e6443[1]), (_e6449 - _e6443[2]));
                                }
                                let _e6456 = phi_15635_;
                                let _e6457 = (_e6430[0] - _e6443[0]);
                                let _e6458 = (_e6430[1] - _e6443[1]);
                                let _e6459 = (_e6430[2] - _e6443[2]);
                                let _e6462 = local_18.member[1u];
                                let _e6469 = local_18.member_1[1u];
                                let _e6475 = local_18.member_2[1u];
                                let _e6479 = (_e6462[0] - _e6469[0]);
                                let _e6480 = (_e6462[1] - _e6469[1]);
                                let _e6481 = (_e6462[2] - _e6469[2]);
                                if (_e316.member == 0u) {
                                    phi_15700_ = array<f32, 3>(_e6462[0], _e6462[1], _e6462[2]);
                                } else {
                                    phi_15700_ = array<f32, 3>((_e6479 - _e6475[0]), (_e6480 - _e6475[1]), (_e6481 - _e6475[2]));
                                }
                                let _e6488 = phi_15700_;
                                let _e6489 = (_e6462[0] - _e6475[0]);
                                let _e6490 = (_e6462[1] - _e6475[1]);
                                let _e6491 = (_e6462[2] - _e6475[2]);
                                let _e6494 = local_18.member[0u];
                                if (_e6494[0] < 0f) {
                                    phi_15722_ = -(_e6494[0]);
                                } else {
                                    phi_15722_ = _e6494[0];
                                }
                                let _e6501 = phi_15722_;
                                if (_e6494[1] < 0f) {
                                    phi_15729_ = -(_e6494[1]);
                                } else {
                                    phi_15729_ = _e6494[1];
                                }
                                let _e6505 = phi_15729_;
                                if (_e6501 > _e6505) {
                                    phi_15734_ = _e6501;
                                } else {
                                    phi_15734_ = _e6505;
                                }
                                let _e6508 = phi_15734_;
                                if (_e6494[2] < 0f) {
                                    phi_15741_ = -(_e6494[2]);
                                } else {
                                    phi_15741_ = _e6494[2];
                                }
                                let _e6512 = phi_15741_;
                                if (_e6508 > _e6512) {
                                    phi_15746_ = _e6508;
                                } else {
                                    phi_15746_ = _e6512;
                                }
                                let _e6515 = phi_15746_;
                                let _e6518 = local_18.member[1u];
                                if (_e6518[0] < 0f) {
                                    phi_15759_ = -(_e6518[0]);
                                } else {
                                    phi_15759_ = _e6518[0];
                                }
                                let _e6525 = phi_15759_;
                                if (_e6518[1] < 0f) {
                                    phi_15766_ = -(_e6518[1]);
                                } else {
                                    phi_15766_ = _e6518[1];
                                }
                                let _e6529 = phi_15766_;
                                if (_e6525 > _e6529) {
                                    phi_15771_ = _e6525;
                                } else {
                                    phi_15771_ = _e6529;
                                }
                                let _e6532 = phi_15771_;
                                if (_e6518[2] < 0f) {
                                    phi_15778_ = -(_e6518[2]);
                                } else {
                                    phi_15778_ = _e6518[2];
                                }
                                let _e6536 = phi_15778_;
                                if (_e6532 > _e6536) {
                                    phi_15783_ = _e6532;
                                } else {
                                    phi_15783_ = _e6536;
                                }
                                let _e6539 = phi_15783_;
                                if (_e6515 > _e6539) {
                                    phi_15788_ = _e6515;
                                } else {
                                    phi_15788_ = _e6539;
                                }
                                let _e6542 = phi_15788_;
                                let _e6544 = local_18.member_3;
                                let _e6548 = local_18.member_1[0u];
                                if (_e6548[0] < 0f) {
                                    phi_15805_ = -(_e6548[0]);
                                } else {
                                    phi_15805_ = _e6548[0];
                                }
                                let _e6555 = phi_15805_;
                                if (_e6548[1] < 0f) {
                                    phi_15812_ = -(_e6548[1]);
                                } else {
                                    phi_15812_ = _e6548[1];
                                }
                                let _e6559 = phi_15812_;
                                if (_e6555 > _e6559) {
                                    phi_15817_ = _e6555;
                                } else {
                                    phi_15817_ = _e6559;
                                }
                                let _e6562 = phi_15817_;
                                if (_e6548[2] < 0f) {
                                    phi_15824_ = -(_e6548[2]);
                                } else {
                                    phi_15824_ = _e6548[2];
                                }
                                let _e6566 = phi_15824_;
                                if (_e6562 > _e6566) {
                                    phi_15829_ = _e6562;
                                } else {
                                    phi_15829_ = _e6566;
                                }
                                let _e6569 = phi_15829_;
                                let _e6572 = local_18.member_1[1u];
                                if (_e6572[0] < 0f) {
                                    phi_15843_ = -(_e6572[0]);
                                } else {
                                    phi_15843_ = _e6572[0];
                                }
                                let _e6579 = phi_15843_;
                                if (_e6572[1] < 0f) {
                                    phi_15850_ = -(_e6572[1]);
                                } else {
                                    phi_15850_ = _e6572[1];
                                }
                                let _e6583 = phi_15850_;
                                if (_e6579 > _e6583) {
                                    phi_15855_ = _e6579;
                                } else {
                                    phi_15855_ = _e6583;
                                }
                                let _e6586 = phi_15855_;
                                if (_e6572[2] < 0f) {
                                    phi_15862_ = -(_e6572[2]);
                                } else {
                                    phi_15862_ = _e6572[2];
                                }
                                let _e6590 = phi_15862_;
                                if (_e6586 > _e6590) {
                                    phi_15867_ = _e6586;
                                } else {
                                    phi_15867_ = _e6590;
                                }
                                let _e6593 = phi_15867_;
                                if (_e6569 > _e6593) {
                                    phi_15872_ = _e6569;
                                } else {
                                    phi_15872_ = _e6593;
                                }
                                let _e6596 = phi_15872_;
                                let _e6598 = local_18.member_3;
                                let _e6602 = local_18.member_2[0u];
                                if (_e6602[0] < 0f) {
                                    phi_15889_ = -(_e6602[0]);
                                } else {
                                    phi_15889_ = _e6602[0];
                                }
                                let _e6609 = phi_15889_;
                                if (_e6602[1] < 0f) {
                                    phi_15896_ = -(_e6602[1]);
                                } else {
                                    phi_15896_ = _e6602[1];
                                }
                                let _e6613 = phi_15896_;
                                if (_e6609 > _e6613) {
                                    phi_15901_ = _e6609;
                                } else {
                                    phi_15901_ = _e6613;
                                }
                                let _e6616 = phi_15901_;
                                if (_e6602[2] < 0f) {
                                    phi_15908_ = -(_e6602[2]);
                                } else {
                                    phi_15908_ = _e6602[2];
                                }
                                let _e6620 = phi_15908_;
                                if (_e6616 > _e6620) {
                                    phi_15913_ = _e6616;
                                } else {
                                    phi_15913_ = _e6620;
                                }
                                let _e6623 = phi_15913_;
                                let _e6626 = local_18.member_2[1u];
                                if (_e6626[0] < 0f) {
                                    phi_15927_ = -(_e6626[0]);
                                } else {
                                    phi_15927_ = _e6626[0];
                                }
                                let _e6633 = phi_15927_;
                                if (_e6626[1] < 0f) {
                                    phi_15934_ = -(_e6626[1]);
                                } else {
                                    phi_15934_ = _e6626[1];
                                }
                                let _e6637 = phi_15934_;
                                if (_e6633 > _e6637) {
                                    phi_15939_ = _e6633;
                                } else {
                                    phi_15939_ = _e6637;
                                }
                                let _e6640 = phi_15939_;
                                if (_e6626[2] < 0f) {
                                    phi_15946_ = -(_e6626[2]);
                                } else {
                                    phi_15946_ = _e6626[2];
                                }
                                let _e6644 = phi_15946_;
                                if (_e6640 > _e6644) {
                                    phi_15951_ = _e6640;
                                } else {
                                    phi_15951_ = _e6644;
                                }
                                let _e6647 = phi_15951_;
                                if (_e6623 > _e6647) {
                                    phi_15956_ = _e6623;
                                } else {
                                    phi_15956_ = _e6647;
                                }
                                let _e6650 = phi_15956_;
                                let _e6652 = local_18.member_3;
                                let _e6659 = local_18.member_3;
                                let _e6663 = ((((((_e6542 + _e6544) + (_e6596 + _e6598)) + (_e6650 + _e6652)) * (0.000000059604645f * 16f)) + (_e6659 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e6666 = local_18.member[0u];
                                let _e6672 = local_18.member[1u];
                                let _e6688 = local_18.member_1[0u];
                                let _e6694 = local_18.member_1[1u];
                                let _e6710 = local_18.member_2[0u];
                                let _e6716 = local_18.member_2[1u];
                                let _e6730 = function_4(array<f32, 3>((_e6666[0] + ((_e6672[0] - _e6666[0]) * _e5621)), (_e6666[1] + ((_e6672[1] - _e6666[1]) * _e5621)), (_e6666[2] + ((_e6672[2] - _e6666[2]) * _e5621))), array<f32, 3>((_e6688[0] + ((_e6694[0] - _e6688[0]) * _e5621)), (_e6688[1] + ((_e6694[1] - _e6688[1]) * _e5621)), (_e6688[2] + ((_e6694[2] - _e6688[2]) * _e5621))), array<f32, 3>((_e6710[0] + ((_e6716[0] - _e6710[0]) * _e5621)), (_e6710[1] + ((_e6716[1] - _e6710[1]) * _e5621)), (_e6710[2] + ((_e6716[2] - _e6710[2]) * _e5621))), _e316.member);
                                if (_e6730[0] < 0f) {
                                    phi_16074_ = -(_e6730[0]);
                                } else {
                                    phi_16074_ = _e6730[0];
                                }
                                let _e6735 = phi_16074_;
                                if (_e6730[1] < 0f) {
                                    phi_16081_ = -(_e6730[1]);
                                } else {
                                    phi_16081_ = _e6730[1];
                                }
                                let _e6740 = phi_16081_;
                                if (_e6730[2] < 0f) {
                                    phi_16089_ = -(_e6730[2]);
                                } else {
                                    phi_16089_ = _e6730[2];
                                }
                                let _e6746 = phi_16089_;
                                let _e6747 = ((_e6735 + _e6740) + _e6746);
                                if (_e6747 > 0f) {
                                    if ((bitcast<u32>(_e6747) & 2139095040u) != 2139095040u) {
                                        let _e6752 = (1f / _e6747);
                                        let _e6754 = (_e6730[0] * _e6752);
                                        let _e6756 = (_e6730[1] * _e6752);
                                        let _e6758 = (_e6730[2] * _e6752);
                                        let _e6763 = (((_e6754 * _e6754) + (_e6756 * _e6756)) + (_e6758 * _e6758));
                                        if (_e6763 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e6763 > 0f) {
                                                phi_16126_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_16126_ = 0f;
                                            }
                                            let _e6816 = phi_16126_;
                                            phi_16190_ = _e6816;
                                        } else {
                                            phi_16133_ = type_14(0i, 5i);
                                            phi_16136_ = bitcast<f32>(((bitcast<u32>(_e6763) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e6771 = phi_16133_;
                                                let _e6773 = phi_16136_;
                                                local_85 = _e6773;
                                                if (_e6771.member < _e6771.member_1) {
                                                    let _e6780 = (_e6771.member + 1i);
                                                    if ((false == (_e6780 > _e6771.member)) != false) {
                                                        phi_16157_ = true;
                                                    } else {
                                                        phi_16157_ = false;
                                                    }
                                                    let _e6785 = phi_16157_;
                                                    if _e6785 {
                                                        phi_16163_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_16163_ = type_15(1u, _e6780);
                                                    }
                                                    let _e6790 = phi_16163_;
                                                    phi_16134_ = type_14(_e6790.member_1, _e6771.member_1);
                                                    phi_16177_ = type_15(1u, _e6771.member);
                                                } else {
                                                    phi_16134_ = _e6771;
                                                    phi_16177_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e6796 = phi_16134_;
                                                let _e6798 = phi_16177_;
                                                let _e6801 = (bitcast<i32>(_e6798.member) != 0i);
                                                if _e6801 {
                                                    phi_16137_ = (0.5f * (_e6773 + (_e6763 / _e6773)));
                                                } else {
                                                    phi_16137_ = f32();
                                                }
                                                let _e6806 = phi_16137_;
                                                continue;
                                                continuing {
                                                    phi_16133_ = _e6796;
                                                    phi_16136_ = _e6806;
                                                    break if !(_e6801);
                                                }
                                            }
                                            let _e6811 = local_85;
                                            phi_16190_ = (_e6811 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e6818 = phi_16190_;
                                        let _e6819 = (0.000000059604645f * 12f);
                                        let _e6824 = ((_e6663 * 1.01f) + ((0f * _e6818) * (1f + _e6819)));
                                        let _e6829 = (((_e6754 * _e6430[0]) + (_e6756 * _e6430[1])) + (_e6758 * _e6430[2]));
                                        let _e6834 = (((_e6754 * _e6447) + (_e6756 * _e6448)) + (_e6758 * _e6449));
                                        let _e6839 = (((_e6754 * _e6457) + (_e6756 * _e6458)) + (_e6758 * _e6459));
                                        let _e6847 = (((_e6754 * _e6456[0]) + (_e6756 * _e6456[1])) + (_e6758 * _e6456[2]));
                                        let _e6853 = (((_e6754 * _e6462[0]) + (_e6756 * _e6462[1])) + (_e6758 * _e6462[2]));
                                        let _e6858 = (((_e6754 * _e6479) + (_e6756 * _e6480)) + (_e6758 * _e6481));
                                        let _e6863 = (((_e6754 * _e6489) + (_e6756 * _e6490)) + (_e6758 * _e6491));
                                        let _e6871 = (((_e6754 * _e6488[0]) + (_e6756 * _e6488[1])) + (_e6758 * _e6488[2]));
                                        if (_e6829 < 0f) {
                                            phi_16256_ = -(_e6829);
                                        } else {
                                            phi_16256_ = _e6829;
                                        }
                                        let _e6876 = phi_16256_;
                                        if (_e6853 < 0f) {
                                            phi_16262_ = -(_e6853);
                                        } else {
                                            phi_16262_ = _e6853;
                                        }
                                        let _e6880 = phi_16262_;
                                        if (_e6834 < 0f) {
                                            phi_16271_ = -(_e6834);
                                        } else {
                                            phi_16271_ = _e6834;
                                        }
                                        let _e6887 = phi_16271_;
                                        if (_e6858 < 0f) {
                                            phi_16277_ = -(_e6858);
                                        } else {
                                            phi_16277_ = _e6858;
                                        }
                                        let _e6891 = phi_16277_;
                                        if (_e6839 < 0f) {
                                            phi_16286_ = -(_e6839);
                                        } else {
                                            phi_16286_ = _e6839;
                                        }
                                        let _e6898 = phi_16286_;
                                        if (_e6863 < 0f) {
                                            phi_16292_ = -(_e6863);
                                        } else {
                                            phi_16292_ = _e6863;
                                        }
                                        let _e6902 = phi_16292_;
                                        if (_e6847 < 0f) {
                                            phi_16301_ = -(_e6847);
                                        } else {
                                            phi_16301_ = _e6847;
                                        }
                                        let _e6909 = phi_16301_;
                                        if (_e6871 < 0f) {
                                            phi_16307_ = -(_e6871);
                                        } else {
                                            phi_16307_ = _e6871;
                                        }
                                        let _e6913 = phi_16307_;
                                        phi_16313_ = type_30(array<f32, 4>(_e6829, _e6834, _e6839, _e6847), array<f32, 4>(_e6853, _e6858, _e6863, _e6871), array<f32, 4>((_e6824 + ((_e6876 + _e6880) * _e6819)), (_e6824 + ((_e6887 + _e6891) * _e6819)), (_e6824 + ((_e6898 + _e6902) * _e6819)), (_e6824 + ((_e6909 + _e6913) * _e6819))));
                                        phi_16314_ = false;
                                    } else {
                                        phi_16313_ = type_30();
                                        phi_16314_ = true;
                                    }
                                    let _e6920 = phi_16313_;
                                    let _e6922 = phi_16314_;
                                    phi_16315_ = _e6920;
                                    phi_16316_ = _e6922;
                                } else {
                                    phi_16315_ = type_30();
                                    phi_16316_ = true;
                                }
                                let _e6924 = phi_16315_;
                                let _e6926 = phi_16316_;
                                if _e6926 {
                                    phi_16324_ = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                } else {
                                    phi_16324_ = _e6924;
                                }
                                let _e6928 = phi_16324_;
                                local_8 = type_30(array<f32, 4>(_e6928.member[0], _e6928.member[1], _e6928.member[2], _e6928.member[3]), array<f32, 4>(_e6928.member_1[0], _e6928.member_1[1], _e6928.member_1[2], _e6928.member_1[3]), array<f32, 4>(_e6928.member_2[0], _e6928.member_2[1], _e6928.member_2[2], _e6928.member_2[3]));
                                let _e6950 = local_8.member[0u];
                                let _e6953 = local_8.member_1[0u];
                                let _e6956 = local_8.member[0u];
                                let _e6962 = local_8.member_2[0u];
                                if (((_e6950 + ((_e6953 - _e6956) * _e5621)) - _e6962) > 0f) {
                                    let _e6967 = local_8.member[1u];
                                    let _e6970 = local_8.member_1[1u];
                                    let _e6973 = local_8.member[1u];
                                    let _e6979 = local_8.member_2[1u];
                                    if (((_e6967 + ((_e6970 - _e6973) * _e5621)) - _e6979) > 0f) {
                                        let _e6984 = local_8.member[2u];
                                        let _e6987 = local_8.member_1[2u];
                                        let _e6990 = local_8.member[2u];
                                        let _e6996 = local_8.member_2[2u];
                                        if (((_e6984 + ((_e6987 - _e6990) * _e5621)) - _e6996) > 0f) {
                                            let _e7001 = local_8.member[3u];
                                            let _e7004 = local_8.member_1[3u];
                                            let _e7007 = local_8.member[3u];
                                            let _e7013 = local_8.member_2[3u];
                                            phi_16493_ = (((_e7001 + ((_e7004 - _e7007) * _e5621)) - _e7013) > 0f);
                                            phi_16494_ = false;
                                        } else {
                                            phi_16493_ = bool();
                                            phi_16494_ = true;
                                        }
                                        let _e7017 = phi_16493_;
                                        let _e7019 = phi_16494_;
                                        phi_16495_ = _e7017;
                                        phi_16496_ = _e7019;
                                    } else {
                                        phi_16495_ = bool();
                                        phi_16496_ = true;
                                    }
                                    let _e7021 = phi_16495_;
                                    let _e7023 = phi_16496_;
                                    phi_16497_ = _e7021;
                                    phi_16498_ = _e7023;
                                } else {
                                    phi_16497_ = bool();
                                    phi_16498_ = true;
                                }
                                let _e7025 = phi_16497_;
                                let _e7027 = phi_16498_;
                                if _e7027 {
                                    phi_16502_ = false;
                                } else {
                                    phi_16502_ = _e7025;
                                }
                                let _e7029 = phi_16502_;
                                if _e7029 {
                                    phi_17856_ = bool();
                                    phi_17857_ = true;
                                } else {
                                    if (_e6730[0] < 0f) {
                                        phi_16529_ = -(_e6730[0]);
                                    } else {
                                        phi_16529_ = _e6730[0];
                                    }
                                    let _e7034 = phi_16529_;
                                    let _e7036 = ((_e7034 + 0f) + 0f);
                                    if (_e7036 > 0f) {
                                        if ((bitcast<u32>(_e7036) & 2139095040u) != 2139095040u) {
                                            let _e7041 = (1f / _e7036);
                                            let _e7042 = (_e6730[0] * _e7041);
                                            let _e7043 = (0f * _e7041);
                                            let _e7044 = (0f * _e7041);
                                            let _e7049 = (((_e7042 * _e7042) + (_e7043 * _e7043)) + (_e7044 * _e7044));
                                            if (_e7049 <= 0.000000000000000000000000000000000000011754944f) {
                                                if (_e7049 > 0f) {
                                                    phi_16576_ = (0.000000000000000000106433627f * 2f);
                                                } else {
                                                    phi_16576_ = 0f;
                                                }
                                                let _e7102 = phi_16576_;
                                                phi_16640_ = _e7102;
                                            } else {
                                                phi_16583_ = type_14(0i, 5i);
                                                phi_16586_ = bitcast<f32>(((bitcast<u32>(_e7049) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e7057 = phi_16583_;
                                                    let _e7059 = phi_16586_;
                                                    local_86 = _e7059;
                                                    if (_e7057.member < _e7057.member_1) {
                                                        let _e7066 = (_e7057.member + 1i);
                                                        if ((false == (_e7066 > _e7057.member)) != false) {
                                                            phi_16607_ = true;
                                                        } else {
                                                            phi_16607_ = false;
                                                        }
                                                        let _e7071 = phi_16607_;
                                                        if _e7071 {
                                                            phi_16613_ = type_15(0u, type_15().member_1);
                                                        } else {
                                                            phi_16613_ = type_15(1u, _e7066);
                                                        }
                                                        let _e7076 = phi_16613_;
                                                        phi_16584_ = type_14(_e7076.member_1, _e7057.member_1);
                                                        phi_16627_ = type_15(1u, _e7057.member);
                                                    } else {
                                                        phi_16584_ = _e7057;
                                                        phi_16627_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e7082 = phi_16584_;
                                                    let _e7084 = phi_16627_;
                                                    let _e7087 = (bitcast<i32>(_e7084.member) != 0i);
                                                    if _e7087 {
                                                        phi_16587_ = (0.5f * (_e7059 + (_e7049 / _e7059)));
                                                    } else {
                                                        phi_16587_ = f32();
                                                    }
                                                    let _e7092 = phi_16587_;
                                                    continue;
                                                    continuing {
                                                        phi_16583_ = _e7082;
                                                        phi_16586_ = _e7092;
                                                        break if !(_e7087);
                                                    }
                                                }
                                                let _e7097 = local_86;
                                                phi_16640_ = (_e7097 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e7104 = phi_16640_;
                                            let _e7105 = (0.000000059604645f * 12f);
                                            let _e7110 = ((_e6663 * 1.01f) + ((0f * _e7104) * (1f + _e7105)));
                                            let _e7115 = (((_e7042 * _e6430[0]) + (_e7043 * _e6430[1])) + (_e7044 * _e6430[2]));
                                            let _e7120 = (((_e7042 * _e6447) + (_e7043 * _e6448)) + (_e7044 * _e6449));
                                            let _e7125 = (((_e7042 * _e6457) + (_e7043 * _e6458)) + (_e7044 * _e6459));
                                            let _e7133 = (((_e7042 * _e6456[0]) + (_e7043 * _e6456[1])) + (_e7044 * _e6456[2]));
                                            let _e7139 = (((_e7042 * _e6462[0]) + (_e7043 * _e6462[1])) + (_e7044 * _e6462[2]));
                                            let _e7144 = (((_e7042 * _e6479) + (_e7043 * _e6480)) + (_e7044 * _e6481));
                                            let _e7149 = (((_e7042 * _e6489) + (_e7043 * _e6490)) + (_e7044 * _e6491));
                                            let _e7157 = (((_e7042 * _e6488[0]) + (_e7043 * _e6488[1])) + (_e7044 * _e6488[2]));
                                            if (_e7115 < 0f) {
                                                phi_16706_ = -(_e7115);
                                            } else {
                                                phi_16706_ = _e7115;
                                            }
                                            let _e7162 = phi_16706_;
                                            if (_e7139 < 0f) {
                                                phi_16712_ = -(_e7139);
                                            } else {
                                                phi_16712_ = _e7139;
                                            }
                                            let _e7166 = phi_16712_;
                                            if (_e7120 < 0f) {
                                                phi_16721_ = -(_e7120);
                                            } else {
                                                phi_16721_ = _e7120;
                                            }
                                            let _e7173 = phi_16721_;
                                            if (_e7144 < 0f) {
                                                phi_16727_ = -(_e7144);
                                            } else {
                                                phi_16727_ = _e7144;
                                            }
                                            let _e7177 = phi_16727_;
                                            if (_e7125 < 0f) {
                                                phi_16736_ = -(_e7125);
                                            } else {
                                                phi_16736_ = _e7125;
                                            }
                                            let _e7184 = phi_16736_;
                                            if (_e7149 < 0f) {
                                                phi_16742_ = -(_e7149);
                                            } else {
                                                phi_16742_ = _e7149;
                                            }
                                            let _e7188 = phi_16742_;
                                            if (_e7133 < 0f) {
                                                phi_16751_ = -(_e7133);
                                            } else {
                                                phi_16751_ = _e7133;
                                            }
                                            let _e7195 = phi_16751_;
                                            if (_e7157 < 0f) {
                                                phi_16757_ = -(_e7157);
                                            } else {
                                                phi_16757_ = _e7157;
                                            }
                                            let _e7199 = phi_16757_;
                                            phi_16763_ = type_30(array<f32, 4>(_e7115, _e7120, _e7125, _e7133), array<f32, 4>(_e7139, _e7144, _e7149, _e7157), array<f32, 4>((_e7110 + ((_e7162 + _e7166) * _e7105)), (_e7110 + ((_e7173 + _e7177) * _e7105)), (_e7110 + ((_e7184 + _e7188) * _e7105)), (_e7110 + ((_e7195 + _e7199) * _e7105))));
                                            phi_16764_ = false;
                                        } else {
                                            phi_16763_ = type_30();
                                            phi_16764_ = true;
                                        }
                                        let _e7206 = phi_16763_;
                                        let _e7208 = phi_16764_;
                                        phi_16765_ = _e7206;
                                        phi_16766_ = _e7208;
                                    } else {
                                        phi_16765_ = type_30();
                                        phi_16766_ = true;
                                    }
                                    let _e7210 = phi_16765_;
                                    let _e7212 = phi_16766_;
                                    if _e7212 {
                                        phi_16774_ = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    } else {
                                        phi_16774_ = _e7210;
                                    }
                                    let _e7214 = phi_16774_;
                                    local_9 = type_30(array<f32, 4>(_e7214.member[0], _e7214.member[1], _e7214.member[2], _e7214.member[3]), array<f32, 4>(_e7214.member_1[0], _e7214.member_1[1], _e7214.member_1[2], _e7214.member_1[3]), array<f32, 4>(_e7214.member_2[0], _e7214.member_2[1], _e7214.member_2[2], _e7214.member_2[3]));
                                    let _e7236 = local_9.member[0u];
                                    let _e7239 = local_9.member_1[0u];
                                    let _e7242 = local_9.member[0u];
                                    let _e7248 = local_9.member_2[0u];
                                    if (((_e7236 + ((_e7239 - _e7242) * _e5621)) - _e7248) > 0f) {
                                        let _e7253 = local_9.member[1u];
                                        let _e7256 = local_9.member_1[1u];
                                        let _e7259 = local_9.member[1u];
                                        let _e7265 = local_9.member_2[1u];
                                        if (((_e7253 + ((_e7256 - _e7259) * _e5621)) - _e7265) > 0f) {
                                            let _e7270 = local_9.member[2u];
                                            let _e7273 = local_9.member_1[2u];
                                            let _e7276 = local_9.member[2u];
                                            let _e7282 = local_9.member_2[2u];
                                            if (((_e7270 + ((_e7273 - _e7276) * _e5621)) - _e7282) > 0f) {
                                                let _e7287 = local_9.member[3u];
                                                let _e7290 = local_9.member_1[3u];
                                                let _e7293 = local_9.member[3u];
                                                let _e7299 = local_9.member_2[3u];
                                                phi_16943_ = (((_e7287 + ((_e7290 - _e7293) * _e5621)) - _e7299) > 0f);
                                                phi_16944_ = false;
                                            } else {
                                                phi_16943_ = bool();
                                                phi_16944_ = true;
                                            }
                                            let _e7303 = phi_16943_;
                                            let _e7305 = phi_16944_;
                                            phi_16945_ = _e7303;
                                            phi_16946_ = _e7305;
                                        } else {
                                            phi_16945_ = bool();
                                            phi_16946_ = true;
                                        }
                                        let _e7307 = phi_16945_;
                                        let _e7309 = phi_16946_;
                                        phi_16947_ = _e7307;
                                        phi_16948_ = _e7309;
                                    } else {
                                        phi_16947_ = bool();
                                        phi_16948_ = true;
                                    }
                                    let _e7311 = phi_16947_;
                                    let _e7313 = phi_16948_;
                                    if _e7313 {
                                        phi_16952_ = false;
                                    } else {
                                        phi_16952_ = _e7311;
                                    }
                                    let _e7315 = phi_16952_;
                                    if _e7315 {
                                        phi_17854_ = bool();
                                        phi_17855_ = true;
                                    } else {
                                        if (_e6730[1] < 0f) {
                                            phi_16985_ = -(_e6730[1]);
                                        } else {
                                            phi_16985_ = _e6730[1];
                                        }
                                        let _e7320 = phi_16985_;
                                        let _e7322 = ((0f + _e7320) + 0f);
                                        if (_e7322 > 0f) {
                                            if ((bitcast<u32>(_e7322) & 2139095040u) != 2139095040u) {
                                                let _e7327 = (1f / _e7322);
                                                let _e7328 = (0f * _e7327);
                                                let _e7329 = (_e6730[1] * _e7327);
                                                let _e7330 = (0f * _e7327);
                                                let _e7335 = (((_e7328 * _e7328) + (_e7329 * _e7329)) + (_e7330 * _e7330));
                                                if (_e7335 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e7335 > 0f) {
                                                        phi_17026_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_17026_ = 0f;
                                                    }
                                                    let _e7388 = phi_17026_;
                                                    phi_17090_ = _e7388;
                                                } else {
                                                    phi_17033_ = type_14(0i, 5i);
                                                    phi_17036_ = bitcast<f32>(((bitcast<u32>(_e7335) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e7343 = phi_17033_;
                                                        let _e7345 = phi_17036_;
                                                        local_87 = _e7345;
                                                        if (_e7343.member < _e7343.member_1) {
                                                            let _e7352 = (_e7343.member + 1i);
                                                            if ((false == (_e7352 > _e7343.member)) != false) {
                                                                phi_17057_ = true;
                                                            } else {
                                                                phi_17057_ = false;
                                                            }
                                                            let _e7357 = phi_17057_;
                                                            if _e7357 {
                                                                phi_17063_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_17063_ = type_15(1u, _e7352);
                                                            }
                                                            let _e7362 = phi_17063_;
                                                            phi_17034_ = type_14(_e7362.member_1, _e7343.member_1);
                                                            phi_17077_ = type_15(1u, _e7343.member);
                                                        } else {
                                                            phi_17034_ = _e7343;
                                                            phi_17077_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e7368 = phi_17034_;
                                                        let _e7370 = phi_17077_;
                                                        let _e7373 = (bitcast<i32>(_e7370.member) != 0i);
                                                        if _e7373 {
                                                            phi_17037_ = (0.5f * (_e7345 + (_e7335 / _e7345)));
                                                        } else {
                                                            phi_17037_ = f32();
                                                        }
                                                        let _e7378 = phi_17037_;
                                                        continue;
                                                        continuing {
                                                            phi_17033_ = _e7368;
                                                            phi_17036_ = _e7378;
                                                            break if !(_e7373);
                                                        }
                                                    }
                                                    let _e7383 = local_87;
                                                    phi_17090_ = (_e7383 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e7390 = phi_17090_;
                                                let _e7391 = (0.000000059604645f * 12f);
                                                let _e7396 = ((_e6663 * 1.01f) + ((0f * _e7390) * (1f + _e7391)));
                                                let _e7401 = (((_e7328 * _e6430[0]) + (_e7329 * _e6430[1])) + (_e7330 * _e6430[2]));
                                                let _e7406 = (((_e7328 * _e6447) + (_e7329 * _e6448)) + (_e7330 * _e6449));
                                                let _e7411 = (((_e7328 * _e6457) + (_e7329 * _e6458)) + (_e7330 * _e6459));
                                                let _e7419 = (((_e7328 * _e6456[0]) + (_e7329 * _e6456[1])) + (_e7330 * _e6456[2]));
                                                let _e7425 = (((_e7328 * _e6462[0]) + (_e7329 * _e6462[1])) + (_e7330 * _e6462[2]));
                                                let _e7430 = (((_e7328 * _e6479) + (_e7329 * _e6480)) + (_e7330 * _e6481));
                                                let _e7435 = (((_e7328 * _e6489) + (_e7329 * _e6490)) + (_e7330 * _e6491));
                                                let _e7443 = (((_e7328 * _e6488[0]) + (_e7329 * _e6488[1])) + (_e7330 * _e6488[2]));
                                                if (_e7401 < 0f) {
                                                    phi_17156_ = -(_e7401);
                                                } else {
                                                    phi_17156_ = _e7401;
                                                }
                                                let _e7448 = phi_17156_;
                                                if (_e7425 < 0f) {
                                                    phi_17162_ = -(_e7425);
                                                } else {
                                                    phi_17162_ = _e7425;
                                                }
                                                let _e7452 = phi_17162_;
                                                if (_e7406 < 0f) {
                                                    phi_17171_ = -(_e7406);
                                                } else {
                                                    phi_17171_ = _e7406;
                                                }
                                                let _e7459 = phi_17171_;
                                                if (_e7430 < 0f) {
                                                    phi_17177_ = -(_e7430);
                                                } else {
                                                    phi_17177_ = _e7430;
                                                }
                                                let _e7463 = phi_17177_;
                                                if (_e7411 < 0f) {
                                                    phi_17186_ = -(_e7411);
                                                } else {
                                                    phi_17186_ = _e7411;
                                                }
                                                let _e7470 = phi_17186_;
                                                if (_e7435 < 0f) {
                                                    phi_17192_ = -(_e7435);
                                                } else {
                                                    phi_17192_ = _e7435;
                                                }
                                                let _e7474 = phi_17192_;
                                                if (_e7419 < 0f) {
                                                    phi_17201_ = -(_e7419);
                                                } else {
                                                    phi_17201_ = _e7419;
                                                }
                                                let _e7481 = phi_17201_;
                                                if (_e7443 < 0f) {
                                                    phi_17207_ = -(_e7443);
                                                } else {
                                                    phi_17207_ = _e7443;
                                                }
                                                let _e7485 = phi_17207_;
                                                phi_17213_ = type_30(array<f32, 4>(_e7401, _e7406, _e7411, _e7419), array<f32, 4>(_e7425, _e7430, _e7435, _e7443), array<f32, 4>((_e7396 + ((_e7448 + _e7452) * _e7391)), (_e7396 + ((_e7459 + _e7463) * _e7391)), (_e7396 + ((_e7470 + _e7474) * _e7391)), (_e7396 + ((_e7481 + _e7485) * _e7391))));
                                                phi_17214_ = false;
                                            } else {
                                                phi_17213_ = type_30();
                                                phi_17214_ = true;
                                            }
                                            let _e7492 = phi_17213_;
                                            let _e7494 = phi_17214_;
                                            phi_17215_ = _e7492;
                                            phi_17216_ = _e7494;
                                        } else {
                                            phi_17215_ = type_30();
                                            phi_17216_ = true;
                                        }
                                        let _e7496 = phi_17215_;
                                        let _e7498 = phi_17216_;
                                        if _e7498 {
                                            phi_17224_ = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        } else {
                                            phi_17224_ = _e7496;
                                        }
                                        let _e7500 = phi_17224_;
                                        local_10 = type_30(array<f32, 4>(_e7500.member[0], _e7500.member[1], _e7500.member[2], _e7500.member[3]), array<f32, 4>(_e7500.member_1[0], _e7500.member_1[1], _e7500.member_1[2], _e7500.member_1[3]), array<f32, 4>(_e7500.member_2[0], _e7500.member_2[1], _e7500.member_2[2], _e7500.member_2[3]));
                                        let _e7522 = local_10.member[0u];
                                        let _e7525 = local_10.member_1[0u];
                                        let _e7528 = local_10.member[0u];
                                        let _e7534 = local_10.member_2[0u];
                                        if (((_e7522 + ((_e7525 - _e7528) * _e5621)) - _e7534) > 0f) {
                                            let _e7539 = local_10.member[1u];
                                            let _e7542 = local_10.member_1[1u];
                                            let _e7545 = local_10.member[1u];
                                            let _e7551 = local_10.member_2[1u];
                                            if (((_e7539 + ((_e7542 - _e7545) * _e5621)) - _e7551) > 0f) {
                                                let _e7556 = local_10.member[2u];
                                                let _e7559 = local_10.member_1[2u];
                                                let _e7562 = local_10.member[2u];
                                                let _e7568 = local_10.member_2[2u];
                                                if (((_e7556 + ((_e7559 - _e7562) * _e5621)) - _e7568) > 0f) {
                                                    let _e7573 = local_10.member[3u];
                                                    let _e7576 = local_10.member_1[3u];
                                                    let _e7579 = local_10.member[3u];
                                                    let _e7585 = local_10.member_2[3u];
                                                    phi_17393_ = (((_e7573 + ((_e7576 - _e7579) * _e5621)) - _e7585) > 0f);
                                                    phi_17394_ = false;
                                                } else {
                                                    phi_17393_ = bool();
                                                    phi_17394_ = true;
                                                }
                                                let _e7589 = phi_17393_;
                                                let _e7591 = phi_17394_;
                                                phi_17395_ = _e7589;
                                                phi_17396_ = _e7591;
                                            } else {
                                                phi_17395_ = bool();
                                                phi_17396_ = true;
                                            }
                                            let _e7593 = phi_17395_;
                                            let _e7595 = phi_17396_;
                                            phi_17397_ = _e7593;
                                            phi_17398_ = _e7595;
                                        } else {
                                            phi_17397_ = bool();
                                            phi_17398_ = true;
                                        }
                                        let _e7597 = phi_17397_;
                                        let _e7599 = phi_17398_;
                                        if _e7599 {
                                            phi_17402_ = false;
                                        } else {
                                            phi_17402_ = _e7597;
                                        }
                                        let _e7601 = phi_17402_;
                                        if _e7601 {
                                            phi_17853_ = bool();
                                        } else {
                                            if (_e6730[2] < 0f) {
                                                phi_17442_ = -(_e6730[2]);
                                            } else {
                                                phi_17442_ = _e6730[2];
                                            }
                                            let _e7607 = phi_17442_;
                                            let _e7608 = ((0f + 0f) + _e7607);
                                            if (_e7608 > 0f) {
                                                if ((bitcast<u32>(_e7608) & 2139095040u) != 2139095040u) {
                                                    let _e7613 = (1f / _e7608);
                                                    let _e7614 = (0f * _e7613);
                                                    let _e7615 = (0f * _e7613);
                                                    let _e7616 = (_e6730[2] * _e7613);
                                                    let _e7621 = (((_e7614 * _e7614) + (_e7615 * _e7615)) + (_e7616 * _e7616));
                                                    if (_e7621 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e7621 > 0f) {
                                                            phi_17476_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_17476_ = 0f;
                                                        }
                                                        let _e7674 = phi_17476_;
                                                        phi_17540_ = _e7674;
                                                    } else {
                                                        phi_17483_ = type_14(0i, 5i);
                                                        phi_17486_ = bitcast<f32>(((bitcast<u32>(_e7621) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e7629 = phi_17483_;
                                                            let _e7631 = phi_17486_;
                                                            local_88 = _e7631;
                                                            if (_e7629.member < _e7629.member_1) {
                                                                let _e7638 = (_e7629.member + 1i);
                                                                if ((false == (_e7638 > _e7629.member)) != false) {
                                                                    phi_17507_ = true;
                                                                } else {
                                                                    phi_17507_ = false;
                                                                }
                                                                let _e7643 = phi_17507_;
                                                                if _e7643 {
                                                                    phi_17513_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_17513_ = type_15(1u, _e7638);
                                                                }
                                                                let _e7648 = phi_17513_;
                                                                phi_17484_ = type_14(_e7648.member_1, _e7629.member_1);
                                                                phi_17527_ = type_15(1u, _e7629.member);
                                                            } else {
                                                                phi_17484_ = _e7629;
                                                                phi_17527_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e7654 = phi_17484_;
                                                            let _e7656 = phi_17527_;
                                                            let _e7659 = (bitcast<i32>(_e7656.member) != 0i);
                                                            if _e7659 {
                                                                phi_17487_ = (0.5f * (_e7631 + (_e7621 / _e7631)));
                                                            } else {
                                                                phi_17487_ = f32();
                                                            }
                                                            let _e7664 = phi_17487_;
                                                            continue;
                                                            continuing {
                                                                phi_17483_ = _e7654;
                                                                phi_17486_ = _e7664;
                                                                break if !(_e7659);
                                                            }
                                                        }
                                                        let _e7669 = local_88;
                                                        phi_17540_ = (_e7669 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e7676 = phi_17540_;
                                                    let _e7677 = (0.000000059604645f * 12f);
                                                    let _e7682 = ((_e6663 * 1.01f) + ((0f * _e7676) * (1f + _e7677)));
                                                    let _e7687 = (((_e7614 * _e6430[0]) + (_e7615 * _e6430[1])) + (_e7616 * _e6430[2]));
                                                    let _e7692 = (((_e7614 * _e6447) + (_e7615 * _e6448)) + (_e7616 * _e6449));
                                                    let _e7697 = (((_e7614 * _e6457) + (_e7615 * _e6458)) + (_e7616 * _e6459));
                                                    let _e7705 = (((_e7614 * _e6456[0]) + (_e7615 * _e6456[1])) + (_e7616 * _e6456[2]));
                                                    let _e7711 = (((_e7614 * _e6462[0]) + (_e7615 * _e6462[1])) + (_e7616 * _e6462[2]));
                                                    let _e7716 = (((_e7614 * _e6479) + (_e7615 * _e6480)) + (_e7616 * _e6481));
                                                    let _e7721 = (((_e7614 * _e6489) + (_e7615 * _e6490)) + (_e7616 * _e6491));
                                                    let _e7729 = (((_e7614 * _e6488[0]) + (_e7615 * _e6488[1])) + (_e7616 * _e6488[2]));
                                                    if (_e7687 < 0f) {
                                                        phi_17606_ = -(_e7687);
                                                    } else {
                                                        phi_17606_ = _e7687;
                                                    }
                                                    let _e7734 = phi_17606_;
                                                    if (_e7711 < 0f) {
                                                        phi_17612_ = -(_e7711);
                                                    } else {
                                                        phi_17612_ = _e7711;
                                                    }
                                                    let _e7738 = phi_17612_;
                                                    if (_e7692 < 0f) {
                                                        phi_17621_ = -(_e7692);
                                                    } else {
                                                        phi_17621_ = _e7692;
                                                    }
                                                    let _e7745 = phi_17621_;
                                                    if (_e7716 < 0f) {
                                                        phi_17627_ = -(_e7716);
                                                    } else {
                                                        phi_17627_ = _e7716;
                                                    }
                                                    let _e7749 = phi_17627_;
                                                    if (_e7697 < 0f) {
                                                        phi_17636_ = -(_e7697);
                                                    } else {
                                                        phi_17636_ = _e7697;
                                                    }
                                                    let _e7756 = phi_17636_;
                                                    if (_e7721 < 0f) {
                                                        phi_17642_ = -(_e7721);
                                                    } else {
                                                        phi_17642_ = _e7721;
                                                    }
                                                    let _e7760 = phi_17642_;
                                                    if (_e7705 < 0f) {
                                                        phi_17651_ = -(_e7705);
                                                    } else {
                                                        phi_17651_ = _e7705;
                                                    }
                                                    let _e7767 = phi_17651_;
                                                    if (_e7729 < 0f) {
                                                        phi_17657_ = -(_e7729);
                                                    } else {
                                                        phi_17657_ = _e7729;
                                                    }
                                                    let _e7771 = phi_17657_;
                                                    phi_17663_ = type_30(array<f32, 4>(_e7687, _e7692, _e7697, _e7705), array<f32, 4>(_e7711, _e7716, _e7721, _e7729), array<f32, 4>((_e7682 + ((_e7734 + _e7738) * _e7677)), (_e7682 + ((_e7745 + _e7749) * _e7677)), (_e7682 + ((_e7756 + _e7760) * _e7677)), (_e7682 + ((_e7767 + _e7771) * _e7677))));
                                                    phi_17664_ = false;
                                                } else {
                                                    phi_17663_ = type_30();
                                                    phi_17664_ = true;
                                                }
                                                let _e7778 = phi_17663_;
                                                let _e7780 = phi_17664_;
                                                phi_17665_ = _e7778;
                                                phi_17666_ = _e7780;
                                            } else {
                                                phi_17665_ = type_30();
                                                phi_17666_ = true;
                                            }
                                            let _e7782 = phi_17665_;
                                            let _e7784 = phi_17666_;
                                            if _e7784 {
                                                phi_17674_ = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            } else {
                                                phi_17674_ = _e7782;
                                            }
                                            let _e7786 = phi_17674_;
                                            local_11 = type_30(array<f32, 4>(_e7786.member[0], _e7786.member[1], _e7786.member[2], _e7786.member[3]), array<f32, 4>(_e7786.member_1[0], _e7786.member_1[1], _e7786.member_1[2], _e7786.member_1[3]), array<f32, 4>(_e7786.member_2[0], _e7786.member_2[1], _e7786.member_2[2], _e7786.member_2[3]));
                                            let _e7808 = local_11.member[0u];
                                            let _e7811 = local_11.member_1[0u];
                                            let _e7814 = local_11.member[0u];
                                            let _e7820 = local_11.member_2[0u];
                                            if (((_e7808 + ((_e7811 - _e7814) * _e5621)) - _e7820) > 0f) {
                                                let _e7825 = local_11.member[1u];
                                                let _e7828 = local_11.member_1[1u];
                                                let _e7831 = local_11.member[1u];
                                                let _e7837 = local_11.member_2[1u];
                                                if (((_e7825 + ((_e7828 - _e7831) * _e5621)) - _e7837) > 0f) {
                                                    let _e7842 = local_11.member[2u];
                                                    let _e7845 = local_11.member_1[2u];
                                                    let _e7848 = local_11.member[2u];
                                                    let _e7854 = local_11.member_2[2u];
                                                    if (((_e7842 + ((_e7845 - _e7848) * _e5621)) - _e7854) > 0f) {
                                                        let _e7859 = local_11.member[3u];
                                                        let _e7862 = local_11.member_1[3u];
                                                        let _e7865 = local_11.member[3u];
                                                        let _e7871 = local_11.member_2[3u];
                                                        phi_17843_ = (((_e7859 + ((_e7862 - _e7865) * _e5621)) - _e7871) > 0f);
                                                        phi_17844_ = false;
                                                    } else {
                                                        phi_17843_ = bool();
                                                        phi_17844_ = true;
                                                    }
                                                    let _e7875 = phi_17843_;
                                                    let _e7877 = phi_17844_;
                                                    phi_17845_ = _e7875;
                                                    phi_17846_ = _e7877;
                                                } else {
                                                    phi_17845_ = bool();
                                                    phi_17846_ = true;
                                                }
                                                let _e7879 = phi_17845_;
                                                let _e7881 = phi_17846_;
                                                phi_17847_ = _e7879;
                                                phi_17848_ = _e7881;
                                            } else {
                                                phi_17847_ = bool();
                                                phi_17848_ = true;
                                            }
                                            let _e7883 = phi_17847_;
                                            let _e7885 = phi_17848_;
                                            if _e7885 {
                                                phi_17852_ = false;
                                            } else {
                                                phi_17852_ = _e7883;
                                            }
                                            let _e7887 = phi_17852_;
                                            phi_17853_ = _e7887;
                                        }
                                        let _e7889 = phi_17853_;
                                        phi_17854_ = _e7889;
                                        phi_17855_ = _e7601;
                                    }
                                    let _e7891 = phi_17854_;
                                    let _e7893 = phi_17855_;
                                    phi_17856_ = _e7891;
                                    phi_17857_ = _e7893;
                                }
                                let _e7895 = phi_17856_;
                                let _e7897 = phi_17857_;
                                if _e7897 {
                                    phi_17861_ = true;
                                } else {
                                    phi_17861_ = _e7895;
                                }
                                let _e7899 = phi_17861_;
                                if !(_e7899) {
                                    phi_17867_ = type_45(2u, _e5621);
                                    phi_17868_ = false;
                                } else {
                                    phi_17867_ = type_45();
                                    phi_17868_ = true;
                                }
                                let _e7903 = phi_17867_;
                                let _e7905 = phi_17868_;
                                phi_17869_ = _e7903;
                                phi_17870_ = _e7905;
                            } else {
                                phi_17869_ = type_45();
                                phi_17870_ = true;
                            }
                            let _e7907 = phi_17869_;
                            let _e7909 = phi_17870_;
                            if _e7909 {
                                let _e7915 = ((_e6051 - (3f * _e6028)) * _e6405);
                                let _e7916 = ((_e6074 - _e6051) * _e6405);
                                let _e7917 = (((3f * _e6085) - _e6074) * _e6405);
                                local_6[0u] = 0f;
                                local_6[1u] = 1f;
                                local_6[2u] = 1f;
                                local_6[3u] = 1f;
                                let _e7924 = ((_e7916 * _e7916) - (_e7915 * _e7917));
                                if (_e7924 > 0f) {
                                    if (_e7924 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e7924 > 0f) {
                                            phi_17906_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_17906_ = 0f;
                                        }
                                        let _e7978 = phi_17906_;
                                        phi_17970_ = _e7978;
                                    } else {
                                        phi_17913_ = type_14(0i, 5i);
                                        phi_17916_ = bitcast<f32>(((bitcast<u32>(_e7924) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e7933 = phi_17913_;
                                            let _e7935 = phi_17916_;
                                            local_89 = _e7935;
                                            if (_e7933.member < _e7933.member_1) {
                                                let _e7942 = (_e7933.member + 1i);
                                                if ((false == (_e7942 > _e7933.member)) != false) {
                                                    phi_17937_ = true;
                                                } else {
                                                    phi_17937_ = false;
                                                }
                                                let _e7947 = phi_17937_;
                                                if _e7947 {
                                                    phi_17943_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_17943_ = type_15(1u, _e7942);
                                                }
                                                let _e7952 = phi_17943_;
                                                phi_17914_ = type_14(_e7952.member_1, _e7933.member_1);
                                                phi_17957_ = type_15(1u, _e7933.member);
                                            } else {
                                                phi_17914_ = _e7933;
                                                phi_17957_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e7958 = phi_17914_;
                                            let _e7960 = phi_17957_;
                                            let _e7963 = (bitcast<i32>(_e7960.member) != 0i);
                                            if _e7963 {
                                                phi_17917_ = (0.5f * (_e7935 + (_e7924 / _e7935)));
                                            } else {
                                                phi_17917_ = f32();
                                            }
                                            let _e7968 = phi_17917_;
                                            continue;
                                            continuing {
                                                phi_17913_ = _e7958;
                                                phi_17916_ = _e7968;
                                                break if !(_e7963);
                                            }
                                        }
                                        let _e7973 = local_89;
                                        phi_17970_ = (_e7973 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e7980 = phi_17970_;
                                    if (_e7916 < 0f) {
                                        phi_17976_ = -(_e7980);
                                    } else {
                                        phi_17976_ = _e7980;
                                    }
                                    let _e7984 = phi_17976_;
                                    let _e7986 = -((_e7916 + _e7984));
                                    local_7[0u] = (_e7986 / (_e7986 + _e7917));
                                    local_7[1u] = (_e7915 / (_e7915 + _e7986));
                                    let _e7995 = local_7[1u];
                                    let _e7996 = local_7[0u];
                                    if (_e7995 < _e7996) {
                                        let _e7999 = local_7[1u];
                                        let _e8001 = local_7[0u];
                                        local_7[0u] = _e7999;
                                        local_7[1u] = _e8001;
                                    }
                                    phi_18001_ = type_9(0u, 2u);
                                    phi_18004_ = 1u;
                                    loop {
                                        let _e8005 = phi_18001_;
                                        let _e8007 = phi_18004_;
                                        local_134 = _e8007;
                                        if (_e8005.member < _e8005.member_1) {
                                            phi_18002_ = type_9((_e8005.member + 1u), _e8005.member_1);
                                            phi_18027_ = type_9(1u, _e8005.member);
                                        } else {
                                            phi_18002_ = _e8005;
                                            phi_18027_ = type_9(0u, type_9().member_1);
                                        }
                                        let _e8019 = phi_18002_;
                                        let _e8021 = phi_18027_;
                                        let _e8025 = (bitcast<i32>(_e8021.member) != 0i);
                                        if _e8025 {
                                            let _e8027 = local_7[_e8021.member_1];
                                            if (_e8027 > 0f) {
                                                let _e8030 = local_7[_e8021.member_1];
                                                if (_e8030 < 1f) {
                                                    let _e8033 = local_7[_e8021.member_1];
                                                    local_6[_e8007] = _e8033;
                                                    phi_18071_ = (_e8007 + 1u);
                                                } else {
                                                    phi_18071_ = _e8007;
                                                }
                                                let _e8037 = phi_18071_;
                                                phi_18072_ = _e8037;
                                            } else {
                                                phi_18072_ = _e8007;
                                            }
                                            let _e8039 = phi_18072_;
                                            phi_18005_ = _e8039;
                                        } else {
                                            phi_18005_ = u32();
                                        }
                                        let _e8041 = phi_18005_;
                                        continue;
                                        continuing {
                                            phi_18001_ = _e8019;
                                            phi_18004_ = _e8041;
                                            break if !(_e8025);
                                        }
                                    }
                                    let _e16201 = local_134;
                                    phi_18073_ = _e16201;
                                } else {
                                    phi_18073_ = 1u;
                                }
                                let _e8044 = phi_18073_;
                                local_6[_e8044] = 1f;
                                let _e8046 = local_6;
                                local_12 = _e8046;
                                phi_18093_ = type_9(0u, _e8044);
                                loop {
                                    let _e8049 = phi_18093_;
                                    if (_e8049.member < _e8049.member_1) {
                                        phi_18094_ = type_9((_e8049.member + 1u), _e8049.member_1);
                                        phi_18117_ = type_9(1u, _e8049.member);
                                    } else {
                                        phi_18094_ = _e8049;
                                        phi_18117_ = type_9(0u, type_9().member_1);
                                    }
                                    let _e8061 = phi_18094_;
                                    let _e8063 = phi_18117_;
                                    if (bitcast<i32>(_e8063.member) != 0i) {
                                        let _e8069 = local_12[_e8063.member_1];
                                        if (_e8069 > _e5621) {
                                            phi_18136_ = _e8069;
                                        } else {
                                            phi_18136_ = _e5621;
                                        }
                                        let _e8072 = phi_18136_;
                                        let _e8075 = local_12[(_e8063.member_1 + 1u)];
                                        if (_e8075 < _e5623) {
                                            phi_18149_ = _e8075;
                                        } else {
                                            phi_18149_ = _e5623;
                                        }
                                        let _e8078 = phi_18149_;
                                        if (_e8072 <= _e8078) {
                                            let _e8080 = (1f - _e8072);
                                            let _e8091 = ((((_e6028 * _e8080) + (_e6051 * _e8072)) * (_e8080 * _e8080)) + (((_e6074 * _e8080) + (_e6085 * _e8072)) * (_e8072 * _e8072)));
                                            let _e8092 = (1f - _e8078);
                                            let _e8103 = ((((_e6028 * _e8092) + (_e6051 * _e8078)) * (_e8092 * _e8092)) + (((_e6074 * _e8092) + (_e6085 * _e8078)) * (_e8078 * _e8078)));
                                            if (_e8091 < 0f) {
                                                phi_18183_ = -(_e8091);
                                            } else {
                                                phi_18183_ = _e8091;
                                            }
                                            let _e8107 = phi_18183_;
                                            let _e8108 = (_e8107 > _e6402);
                                            if (_e8103 < 0f) {
                                                phi_18190_ = -(_e8103);
                                            } else {
                                                phi_18190_ = _e8103;
                                            }
                                            let _e8112 = phi_18190_;
                                            let _e8113 = (_e8112 > _e6402);
                                            if _e8108 {
                                                if _e8113 {
                                                    phi_18201_ = ((_e8091 > 0f) != (_e8103 > 0f));
                                                    phi_18202_ = false;
                                                } else {
                                                    phi_18201_ = bool();
                                                    phi_18202_ = true;
                                                }
                                                let _e8118 = phi_18201_;
                                                let _e8120 = phi_18202_;
                                                phi_18203_ = _e8118;
                                                phi_18204_ = _e8120;
                                            } else {
                                                phi_18203_ = bool();
                                                phi_18204_ = true;
                                            }
                                            let _e8122 = phi_18203_;
                                            let _e8124 = phi_18204_;
                                            if _e8124 {
                                                phi_18208_ = false;
                                            } else {
                                                phi_18208_ = _e8122;
                                            }
                                            let _e8126 = phi_18208_;
                                            if _e8108 {
                                                if _e8113 {
                                                    if _e8126 {
                                                        phi_18219_ = type_48();
                                                    } else {
                                                        phi_18219_ = type_48(1f, 0f, _e8126);
                                                    }
                                                    let _e8129 = phi_18219_;
                                                    phi_18220_ = _e8129;
                                                    phi_18221_ = _e8126;
                                                } else {
                                                    phi_18220_ = type_48();
                                                    phi_18221_ = true;
                                                }
                                                let _e8131 = phi_18220_;
                                                let _e8133 = phi_18221_;
                                                phi_18222_ = _e8131;
                                                phi_18223_ = _e8133;
                                            } else {
                                                phi_18222_ = type_48();
                                                phi_18223_ = true;
                                            }
                                            let _e8135 = phi_18222_;
                                            let _e8137 = phi_18223_;
                                            if _e8137 {
                                                if _e8108 {
                                                    if (_e8091 < 0f) {
                                                        phi_18234_ = -1f;
                                                    } else {
                                                        phi_18234_ = 1f;
                                                    }
                                                    let _e8140 = phi_18234_;
                                                    let _e8143 = (_e6074 - _e6051);
                                                    phi_18244_ = type_9(0u, 64u);
                                                    phi_18247_ = _e8078;
                                                    phi_18249_ = _e8072;
                                                    phi_18251_ = (0.5f * (_e8072 + _e8078));
                                                    loop {
                                                        let _e8149 = phi_18244_;
                                                        let _e8151 = phi_18247_;
                                                        let _e8153 = phi_18249_;
                                                        let _e8155 = phi_18251_;
                                                        local_136 = _e8153;
                                                        if (_e8149.member < _e8149.member_1) {
                                                            phi_18245_ = type_9((_e8149.member + 1u), _e8149.member_1);
                                                            phi_18274_ = type_9(1u, _e8149.member);
                                                        } else {
                                                            phi_18245_ = _e8149;
                                                            phi_18274_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e8167 = phi_18245_;
                                                        let _e8169 = phi_18274_;
                                                        if (bitcast<i32>(_e8169.member) != 0i) {
                                                            let _e8173 = (1f - _e8155);
                                                            let _e8186 = ((_e8140 * ((((_e6028 * _e8173) + (_e6051 * _e8155)) * (_e8173 * _e8173)) + (((_e6074 * _e8173) + (_e6085 * _e8155)) * (_e8155 * _e8155)))) - _e6402);
                                                            if (_e8186 > 0f) {
                                                                phi_18299_ = _e8151;
                                                                phi_18300_ = _e8155;
                                                            } else {
                                                                phi_18299_ = _e8155;
                                                                phi_18300_ = _e8153;
                                                            }
                                                            let _e8189 = phi_18299_;
                                                            let _e8191 = phi_18300_;
                                                            let _e8193 = ((_e8189 - _e8191) > _e6409);
                                                            if _e8193 {
                                                                let _e8194 = (1f - _e8155);
                                                                let _e8206 = (-(_e8186) / (_e8140 * (((((_e6051 - (3f * _e6028)) * _e8194) + (_e8143 * _e8155)) * _e8194) + (((_e8143 * _e8194) + (((3f * _e6085) - _e6074) * _e8155)) * _e8155))));
                                                                if (_e8186 > 0f) {
                                                                    phi_18326_ = (0.5f * _e6409);
                                                                } else {
                                                                    phi_18326_ = -((0.5f * _e6409));
                                                                }
                                                                let _e8212 = phi_18326_;
                                                                let _e8214 = ((_e8155 + _e8206) + _e8212);
                                                                if (_e8214 > _e8191) {
                                                                    if (_e8214 < _e8189) {
                                                                        if (_e8206 < 0f) {
                                                                            phi_18342_ = -(_e8206);
                                                                        } else {
                                                                            phi_18342_ = _e8206;
                                                                        }
                                                                        let _e8220 = phi_18342_;
                                                                        if (_e8220 < (0.5f * (_e8189 - _e8191))) {
                                                                            phi_18349_ = false;
                                                                        } else {
                                                                            phi_18349_ = true;
                                                                        }
                                                                        let _e8225 = phi_18349_;
                                                                        phi_18350_ = _e8225;
                                                                    } else {
                                                                        phi_18350_ = true;
                                                                    }
                                                                    let _e8227 = phi_18350_;
                                                                    phi_18351_ = _e8227;
                                                                } else {
                                                                    phi_18351_ = true;
                                                                }
                                                                let _e8229 = phi_18351_;
                                                                if _e8229 {
                                                                    phi_18357_ = (0.5f * (_e8191 + _e8189));
                                                                } else {
                                                                    phi_18357_ = _e8214;
                                                                }
                                                                let _e8233 = phi_18357_;
                                                                phi_18358_ = _e8233;
                                                                phi_18359_ = false;
                                                            } else {
                                                                phi_18358_ = f32();
                                                                phi_18359_ = true;
                                                            }
                                                            let _e8235 = phi_18358_;
                                                            let _e8237 = phi_18359_;
                                                            phi_18248_ = _e8189;
                                                            phi_18250_ = _e8191;
                                                            phi_18252_ = _e8235;
                                                            phi_18360_ = _e8191;
                                                            phi_18361_ = _e8193;
                                                            phi_18362_ = _e8237;
                                                        } else {
                                                            phi_18248_ = f32();
                                                            phi_18250_ = f32();
                                                            phi_18252_ = f32();
                                                            phi_18360_ = f32();
                                                            phi_18361_ = false;
                                                            phi_18362_ = false;
                                                        }
                                                        let _e8239 = phi_18248_;
                                                        let _e8241 = phi_18250_;
                                                        let _e8243 = phi_18252_;
                                                        let _e8245 = phi_18360_;
                                                        let _e8247 = phi_18361_;
                                                        let _e8249 = phi_18362_;
                                                        local_90 = _e8249;
                                                        local_135 = _e8245;
                                                        continue;
                                                        continuing {
                                                            phi_18244_ = _e8167;
                                                            phi_18247_ = _e8239;
                                                            phi_18249_ = _e8241;
                                                            phi_18251_ = _e8243;
                                                            break if !(_e8247);
                                                        }
                                                    }
                                                    let _e8252 = local_90;
                                                    if _e8252 {
                                                        let _e16245 = local_135;
                                                        phi_18366_ = _e16245;
                                                    } else {
                                                        let _e16247 = local_136;
                                                        phi_18366_ = _e16247;
                                                    }
                                                    let _e8254 = phi_18366_;
                                                    phi_18367_ = _e8254;
                                                } else {
                                                    phi_18367_ = _e8072;
                                                }
                                                let _e8256 = phi_18367_;
                                                if _e8113 {
                                                    if (_e8103 < 0f) {
                                                        phi_18375_ = -1f;
                                                    } else {
                                                        phi_18375_ = 1f;
                                                    }
                                                    let _e8259 = phi_18375_;
                                                    phi_18379_ = type_9(0u, 64u);
                                                    phi_18382_ = (_e6409 + _e6409);
                                                    loop {
                                                        let _e8262 = phi_18379_;
                                                        let _e8264 = phi_18382_;
                                                        if (_e8262.member < _e8262.member_1) {
                                                            phi_18380_ = type_9((_e8262.member + 1u), _e8262.member_1);
                                                            phi_18405_ = type_9(1u, _e8262.member);
                                                        } else {
                                                            phi_18380_ = _e8262;
                                                            phi_18405_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e8276 = phi_18380_;
                                                        let _e8278 = phi_18405_;
                                                        if (bitcast<i32>(_e8278.member) != 0i) {
                                                            let _e8282 = (_e8256 + _e8264);
                                                            if (_e8282 < _e8078) {
                                                                let _e8284 = (1f - _e8282);
                                                                let _e8297 = ((_e8259 * ((((_e6028 * _e8284) + (_e6051 * _e8282)) * (_e8284 * _e8284)) + (((_e6074 * _e8284) + (_e6085 * _e8282)) * (_e8282 * _e8282)))) > _e6402);
                                                                if _e8297 {
                                                                    phi_18435_ = f32();
                                                                    phi_18436_ = false;
                                                                } else {
                                                                    phi_18435_ = (_e8264 + _e8264);
                                                                    phi_18436_ = true;
                                                                }
                                                                let _e8300 = phi_18435_;
                                                                let _e8302 = phi_18436_;
                                                                phi_18437_ = _e8300;
                                                                phi_18438_ = _e8302;
                                                                phi_18439_ = _e8297;
                                                                phi_18440_ = false;
                                                            } else {
                                                                phi_18437_ = f32();
                                                                phi_18438_ = false;
                                                                phi_18439_ = false;
                                                                phi_18440_ = true;
                                                            }
                                                            let _e8304 = phi_18437_;
                                                            let _e8306 = phi_18438_;
                                                            let _e8308 = phi_18439_;
                                                            let _e8310 = phi_18440_;
                                                            phi_18441_ = _e8282;
                                                            phi_18383_ = _e8304;
                                                            phi_18442_ = _e8306;
                                                            phi_18443_ = _e8308;
                                                            phi_18444_ = _e8310;
                                                            phi_18445_ = false;
                                                        } else {
                                                            phi_18441_ = f32();
                                                            phi_18383_ = f32();
                                                            phi_18442_ = false;
                                                            phi_18443_ = false;
                                                            phi_18444_ = false;
                                                            phi_18445_ = true;
                                                        }
                                                        let _e8312 = phi_18441_;
                                                        let _e8314 = phi_18383_;
                                                        let _e8316 = phi_18442_;
                                                        let _e8318 = phi_18443_;
                                                        let _e8320 = phi_18444_;
                                                        let _e8322 = phi_18445_;
                                                        local_91 = _e8318;
                                                        local_137 = _e8320;
                                                        local_138 = _e8322;
                                                        local_139 = _e8312;
                                                        continue;
                                                        continuing {
                                                            phi_18379_ = _e8276;
                                                            phi_18382_ = _e8314;
                                                            break if !(_e8316);
                                                        }
                                                    }
                                                    let _e8325 = local_91;
                                                    if _e8325 {
                                                        phi_18449_ = false;
                                                        phi_18450_ = false;
                                                    } else {
                                                        let _e16269 = local_137;
                                                        phi_18449_ = _e16269;
                                                        let _e16272 = local_138;
                                                        phi_18450_ = _e16272;
                                                    }
                                                    let _e8327 = phi_18449_;
                                                    let _e8329 = phi_18450_;
                                                    if _e8327 {
                                                        phi_18454_ = true;
                                                    } else {
                                                        phi_18454_ = _e8329;
                                                    }
                                                    let _e8331 = phi_18454_;
                                                    if _e8331 {
                                                        phi_18458_ = _e8078;
                                                    } else {
                                                        let _e16276 = local_139;
                                                        phi_18458_ = _e16276;
                                                    }
                                                    let _e8333 = phi_18458_;
                                                    phi_18459_ = _e8333;
                                                } else {
                                                    phi_18459_ = _e8078;
                                                }
                                                let _e8335 = phi_18459_;
                                                phi_18461_ = type_48(_e8256, _e8335, _e8126);
                                            } else {
                                                phi_18461_ = _e8135;
                                            }
                                            let _e8338 = phi_18461_;
                                            if (_e8338.member > _e8338.member_1) {
                                                phi_22254_ = bool();
                                                phi_22255_ = f32();
                                                phi_22256_ = f32();
                                                phi_22257_ = true;
                                                phi_22258_ = false;
                                                phi_22259_ = false;
                                                phi_22260_ = false;
                                            } else {
                                                let _e8345 = ((_e8338.member_1 - _e8338.member) * 0.5f);
                                                let _e8346 = (_e8338.member + _e8345);
                                                let _e8348 = (_e8345 + (0.000000059604645f * 4f));
                                                let _e8350 = local_18.member_3;
                                                let _e8353 = local_18.member[0u];
                                                if (_e8353[0] < 0f) {
                                                    phi_18490_ = -(_e8353[0]);
                                                } else {
                                                    phi_18490_ = _e8353[0];
                                                }
                                                let _e8360 = phi_18490_;
                                                if (_e8353[1] < 0f) {
                                                    phi_18497_ = -(_e8353[1]);
                                                } else {
                                                    phi_18497_ = _e8353[1];
                                                }
                                                let _e8364 = phi_18497_;
                                                if (_e8360 > _e8364) {
                                                    phi_18502_ = _e8360;
                                                } else {
                                                    phi_18502_ = _e8364;
                                                }
                                                let _e8367 = phi_18502_;
                                                if (_e8353[2] < 0f) {
                                                    phi_18509_ = -(_e8353[2]);
                                                } else {
                                                    phi_18509_ = _e8353[2];
                                                }
                                                let _e8371 = phi_18509_;
                                                if (_e8367 > _e8371) {
                                                    phi_18514_ = _e8367;
                                                } else {
                                                    phi_18514_ = _e8371;
                                                }
                                                let _e8374 = phi_18514_;
                                                let _e8376 = local_18.member[1u];
                                                if (_e8376[0] < 0f) {
                                                    phi_18527_ = -(_e8376[0]);
                                                } else {
                                                    phi_18527_ = _e8376[0];
                                                }
                                                let _e8383 = phi_18527_;
                                                if (_e8376[1] < 0f) {
                                                    phi_18534_ = -(_e8376[1]);
                                                } else {
                                                    phi_18534_ = _e8376[1];
                                                }
                                                let _e8387 = phi_18534_;
                                                if (_e8383 > _e8387) {
                                                    phi_18539_ = _e8383;
                                                } else {
                                                    phi_18539_ = _e8387;
                                                }
                                                let _e8390 = phi_18539_;
                                                if (_e8376[2] < 0f) {
                                                    phi_18546_ = -(_e8376[2]);
                                                } else {
                                                    phi_18546_ = _e8376[2];
                                                }
                                                let _e8394 = phi_18546_;
                                                if (_e8390 > _e8394) {
                                                    phi_18551_ = _e8390;
                                                } else {
                                                    phi_18551_ = _e8394;
                                                }
                                                let _e8397 = phi_18551_;
                                                if (_e8374 > _e8397) {
                                                    phi_18556_ = _e8374;
                                                } else {
                                                    phi_18556_ = _e8397;
                                                }
                                                let _e8400 = phi_18556_;
                                                let _e8403 = local_18.member[0u];
                                                let _e8408 = local_18.member[1u];
                                                let _e8418 = (_e8403[0] + ((_e8408[0] - _e8403[0]) * _e8346));
                                                let _e8419 = (_e8403[1] + ((_e8408[1] - _e8403[1]) * _e8346));
                                                let _e8420 = (_e8403[2] + ((_e8408[2] - _e8403[2]) * _e8346));
                                                let _e8422 = local_18.member[1u];
                                                let _e8427 = local_18.member[0u];
                                                let _e8431 = (_e8422[0] - _e8427[0]);
                                                let _e8432 = (_e8422[1] - _e8427[1]);
                                                let _e8433 = (_e8422[2] - _e8427[2]);
                                                if (_e8431 < 0f) {
                                                    phi_18615_ = -(_e8431);
                                                } else {
                                                    phi_18615_ = _e8431;
                                                }
                                                let _e8437 = phi_18615_;
                                                if (_e8432 < 0f) {
                                                    phi_18621_ = -(_e8432);
                                                } else {
                                                    phi_18621_ = _e8432;
                                                }
                                                let _e8441 = phi_18621_;
                                                if (_e8437 > _e8441) {
                                                    phi_18626_ = _e8437;
                                                } else {
                                                    phi_18626_ = _e8441;
                                                }
                                                let _e8444 = phi_18626_;
                                                if (_e8433 < 0f) {
                                                    phi_18632_ = -(_e8433);
                                                } else {
                                                    phi_18632_ = _e8433;
                                                }
                                                let _e8448 = phi_18632_;
                                                if (_e8444 > _e8448) {
                                                    phi_18637_ = _e8444;
                                                } else {
                                                    phi_18637_ = _e8448;
                                                }
                                                let _e8451 = phi_18637_;
                                                let _e8457 = ((((_e8348 * _e8451) * 1.01f) + ((_e8400 + _e8350) * (0.000000059604645f * 8f))) + _e8350);
                                                if (_e8418 < 0f) {
                                                    phi_18649_ = -(_e8418);
                                                } else {
                                                    phi_18649_ = _e8418;
                                                }
                                                let _e8461 = phi_18649_;
                                                if (_e8419 < 0f) {
                                                    phi_18655_ = -(_e8419);
                                                } else {
                                                    phi_18655_ = _e8419;
                                                }
                                                let _e8465 = phi_18655_;
                                                if (_e8461 > _e8465) {
                                                    phi_18660_ = _e8461;
                                                } else {
                                                    phi_18660_ = _e8465;
                                                }
                                                let _e8468 = phi_18660_;
                                                if (_e8420 < 0f) {
                                                    phi_18666_ = -(_e8420);
                                                } else {
                                                    phi_18666_ = _e8420;
                                                }
                                                let _e8472 = phi_18666_;
                                                if (_e8468 > _e8472) {
                                                    phi_18671_ = _e8468;
                                                } else {
                                                    phi_18671_ = _e8472;
                                                }
                                                let _e8475 = phi_18671_;
                                                local_2 = type_21(array<f32, 3>(_e8418, _e8419, _e8420), _e8457, (_e8475 + _e8457));
                                                let _e8481 = local_18.member_3;
                                                let _e8483 = local_18.member_1[0u];
                                                if (_e8483[0] < 0f) {
                                                    phi_18697_ = -(_e8483[0]);
                                                } else {
                                                    phi_18697_ = _e8483[0];
                                                }
                                                let _e8490 = phi_18697_;
                                                if (_e8483[1] < 0f) {
                                                    phi_18704_ = -(_e8483[1]);
                                                } else {
                                                    phi_18704_ = _e8483[1];
                                                }
                                                let _e8494 = phi_18704_;
                                                if (_e8490 > _e8494) {
                                                    phi_18709_ = _e8490;
                                                } else {
                                                    phi_18709_ = _e8494;
                                                }
                                                let _e8497 = phi_18709_;
                                                if (_e8483[2] < 0f) {
                                                    phi_18716_ = -(_e8483[2]);
                                                } else {
                                                    phi_18716_ = _e8483[2];
                                                }
                                                let _e8501 = phi_18716_;
                                                if (_e8497 > _e8501) {
                                                    phi_18721_ = _e8497;
                                                } else {
                                                    phi_18721_ = _e8501;
                                                }
                                                let _e8504 = phi_18721_;
                                                let _e8506 = local_18.member_1[1u];
                                                if (_e8506[0] < 0f) {
                                                    phi_18734_ = -(_e8506[0]);
                                                } else {
                                                    phi_18734_ = _e8506[0];
                                                }
                                                let _e8513 = phi_18734_;
                                                if (_e8506[1] < 0f) {
                                                    phi_18741_ = -(_e8506[1]);
                                                } else {
                                                    phi_18741_ = _e8506[1];
                                                }
                                                let _e8517 = phi_18741_;
                                                if (_e8513 > _e8517) {
                                                    phi_18746_ = _e8513;
                                                } else {
                                                    phi_18746_ = _e8517;
                                                }
                                                let _e8520 = phi_18746_;
                                                if (_e8506[2] < 0f) {
                                                    phi_18753_ = -(_e8506[2]);
                                                } else {
                                                    phi_18753_ = _e8506[2];
                                                }
                                                let _e8524 = phi_18753_;
                                                if (_e8520 > _e8524) {
                                                    phi_18758_ = _e8520;
                                                } else {
                                                    phi_18758_ = _e8524;
                                                }
                                                let _e8527 = phi_18758_;
                                                if (_e8504 > _e8527) {
                                                    phi_18763_ = _e8504;
                                                } else {
                                                    phi_18763_ = _e8527;
                                                }
                                                let _e8530 = phi_18763_;
                                                let _e8533 = local_18.member_1[0u];
                                                let _e8538 = local_18.member_1[1u];
                                                let _e8548 = (_e8533[0] + ((_e8538[0] - _e8533[0]) * _e8346));
                                                let _e8549 = (_e8533[1] + ((_e8538[1] - _e8533[1]) * _e8346));
                                                let _e8550 = (_e8533[2] + ((_e8538[2] - _e8533[2]) * _e8346));
                                                let _e8552 = local_18.member_1[1u];
                                                let _e8557 = local_18.member_1[0u];
                                                let _e8561 = (_e8552[0] - _e8557[0]);
                                                let _e8562 = (_e8552[1] - _e8557[1]);
                                                let _e8563 = (_e8552[2] - _e8557[2]);
                                                if (_e8561 < 0f) {
                                                    phi_18822_ = -(_e8561);
                                                } else {
                                                    phi_18822_ = _e8561;
                                                }
                                                let _e8567 = phi_18822_;
                                                if (_e8562 < 0f) {
                                                    phi_18828_ = -(_e8562);
                                                } else {
                                                    phi_18828_ = _e8562;
                                                }
                                                let _e8571 = phi_18828_;
                                                if (_e8567 > _e8571) {
                                                    phi_18833_ = _e8567;
                                                } else {
                                                    phi_18833_ = _e8571;
                                                }
                                                let _e8574 = phi_18833_;
                                                if (_e8563 < 0f) {
                                                    phi_18839_ = -(_e8563);
                                                } else {
                                                    phi_18839_ = _e8563;
                                                }
                                                let _e8578 = phi_18839_;
                                                if (_e8574 > _e8578) {
                                                    phi_18844_ = _e8574;
                                                } else {
                                                    phi_18844_ = _e8578;
                                                }
                                                let _e8581 = phi_18844_;
                                                let _e8587 = ((((_e8348 * _e8581) * 1.01f) + ((_e8530 + _e8481) * (0.000000059604645f * 8f))) + _e8481);
                                                if (_e8548 < 0f) {
                                                    phi_18856_ = -(_e8548);
                                                } else {
                                                    phi_18856_ = _e8548;
                                                }
                                                let _e8591 = phi_18856_;
                                                if (_e8549 < 0f) {
                                                    phi_18862_ = -(_e8549);
                                                } else {
                                                    phi_18862_ = _e8549;
                                                }
                                                let _e8595 = phi_18862_;
                                                if (_e8591 > _e8595) {
                                                    phi_18867_ = _e8591;
                                                } else {
                                                    phi_18867_ = _e8595;
                                                }
                                                let _e8598 = phi_18867_;
                                                if (_e8550 < 0f) {
                                                    phi_18873_ = -(_e8550);
                                                } else {
                                                    phi_18873_ = _e8550;
                                                }
                                                let _e8602 = phi_18873_;
                                                if (_e8598 > _e8602) {
                                                    phi_18878_ = _e8598;
                                                } else {
                                                    phi_18878_ = _e8602;
                                                }
                                                let _e8605 = phi_18878_;
                                                local_3 = type_21(array<f32, 3>(_e8548, _e8549, _e8550), _e8587, (_e8605 + _e8587));
                                                let _e8611 = local_18.member_3;
                                                let _e8613 = local_18.member_2[0u];
                                                if (_e8613[0] < 0f) {
                                                    phi_18904_ = -(_e8613[0]);
                                                } else {
                                                    phi_18904_ = _e8613[0];
                                                }
                                                let _e8620 = phi_18904_;
                                                if (_e8613[1] < 0f) {
                                                    phi_18911_ = -(_e8613[1]);
                                                } else {
                                                    phi_18911_ = _e8613[1];
                                                }
                                                let _e8624 = phi_18911_;
                                                if (_e8620 > _e8624) {
                                                    phi_18916_ = _e8620;
                                                } else {
                                                    phi_18916_ = _e8624;
                                                }
                                                let _e8627 = phi_18916_;
                                                if (_e8613[2] < 0f) {
                                                    phi_18923_ = -(_e8613[2]);
                                                } else {
                                                    phi_18923_ = _e8613[2];
                                                }
                                                let _e8631 = phi_18923_;
                                                if (_e8627 > _e8631) {
                                                    phi_18928_ = _e8627;
                                                } else {
                                                    phi_18928_ = _e8631;
                                                }
                                                let _e8634 = phi_18928_;
                                                let _e8636 = local_18.member_2[1u];
                                                if (_e8636[0] < 0f) {
                                                    phi_18941_ = -(_e8636[0]);
                                                } else {
                                                    phi_18941_ = _e8636[0];
                                                }
                                                let _e8643 = phi_18941_;
                                                if (_e8636[1] < 0f) {
                                                    phi_18948_ = -(_e8636[1]);
                                                } else {
                                                    phi_18948_ = _e8636[1];
                                                }
                                                let _e8647 = phi_18948_;
                                                if (_e8643 > _e8647) {
                                                    phi_18953_ = _e8643;
                                                } else {
                                                    phi_18953_ = _e8647;
                                                }
                                                let _e8650 = phi_18953_;
                                                if (_e8636[2] < 0f) {
                                                    phi_18960_ = -(_e8636[2]);
                                                } else {
                                                    phi_18960_ = _e8636[2];
                                                }
                                                let _e8654 = phi_18960_;
                                                if (_e8650 > _e8654) {
                                                    phi_18965_ = _e8650;
                                                } else {
                                                    phi_18965_ = _e8654;
                                                }
                                                let _e8657 = phi_18965_;
                                                if (_e8634 > _e8657) {
                                                    phi_18970_ = _e8634;
                                                } else {
                                                    phi_18970_ = _e8657;
                                                }
                                                let _e8660 = phi_18970_;
                                                let _e8663 = local_18.member_2[0u];
                                                let _e8668 = local_18.member_2[1u];
                                                let _e8678 = (_e8663[0] + ((_e8668[0] - _e8663[0]) * _e8346));
                                                let _e8679 = (_e8663[1] + ((_e8668[1] - _e8663[1]) * _e8346));
                                                let _e8680 = (_e8663[2] + ((_e8668[2] - _e8663[2]) * _e8346));
                                                let _e8682 = local_18.member_2[1u];
                                                let _e8687 = local_18.member_2[0u];
                                                let _e8691 = (_e8682[0] - _e8687[0]);
                                                let _e8692 = (_e8682[1] - _e8687[1]);
                                                let _e8693 = (_e8682[2] - _e8687[2]);
                                                if (_e8691 < 0f) {
                                                    phi_19029_ = -(_e8691);
                                                } else {
                                                    phi_19029_ = _e8691;
                                                }
                                                let _e8697 = phi_19029_;
                                                if (_e8692 < 0f) {
                                                    phi_19035_ = -(_e8692);
                                                } else {
                                                    phi_19035_ = _e8692;
                                                }
                                                let _e8701 = phi_19035_;
                                                if (_e8697 > _e8701) {
                                                    phi_19040_ = _e8697;
                                                } else {
                                                    phi_19040_ = _e8701;
                                                }
                                                let _e8704 = phi_19040_;
                                                if (_e8693 < 0f) {
                                                    phi_19046_ = -(_e8693);
                                                } else {
                                                    phi_19046_ = _e8693;
                                                }
                                                let _e8708 = phi_19046_;
                                                if (_e8704 > _e8708) {
                                                    phi_19051_ = _e8704;
                                                } else {
                                                    phi_19051_ = _e8708;
                                                }
                                                let _e8711 = phi_19051_;
                                                let _e8717 = ((((_e8348 * _e8711) * 1.01f) + ((_e8660 + _e8611) * (0.000000059604645f * 8f))) + _e8611);
                                                if (_e8678 < 0f) {
                                                    phi_19063_ = -(_e8678);
                                                } else {
                                                    phi_19063_ = _e8678;
                                                }
                                                let _e8721 = phi_19063_;
                                                if (_e8679 < 0f) {
                                                    phi_19069_ = -(_e8679);
                                                } else {
                                                    phi_19069_ = _e8679;
                                                }
                                                let _e8725 = phi_19069_;
                                                if (_e8721 > _e8725) {
                                                    phi_19074_ = _e8721;
                                                } else {
                                                    phi_19074_ = _e8725;
                                                }
                                                let _e8728 = phi_19074_;
                                                if (_e8680 < 0f) {
                                                    phi_19080_ = -(_e8680);
                                                } else {
                                                    phi_19080_ = _e8680;
                                                }
                                                let _e8732 = phi_19080_;
                                                if (_e8728 > _e8732) {
                                                    phi_19085_ = _e8728;
                                                } else {
                                                    phi_19085_ = _e8732;
                                                }
                                                let _e8735 = phi_19085_;
                                                local_4 = type_21(array<f32, 3>(_e8678, _e8679, _e8680), _e8717, (_e8735 + _e8717));
                                                let _e8740 = local_3.member;
                                                let _e8745 = local_4.member;
                                                let _e8751 = ((_e8740[1] * _e8745[2]) - (_e8740[2] * _e8745[1]));
                                                let _e8754 = ((_e8740[2] * _e8745[0]) - (_e8740[0] * _e8745[2]));
                                                let _e8757 = ((_e8740[0] * _e8745[1]) - (_e8740[1] * _e8745[0]));
                                                if (_e8751 < 0f) {
                                                    phi_19134_ = -(_e8751);
                                                } else {
                                                    phi_19134_ = _e8751;
                                                }
                                                let _e8761 = phi_19134_;
                                                if (_e8754 < 0f) {
                                                    phi_19140_ = -(_e8754);
                                                } else {
                                                    phi_19140_ = _e8754;
                                                }
                                                let _e8765 = phi_19140_;
                                                if (_e8761 > _e8765) {
                                                    if (_e8751 < 0f) {
                                                        phi_19150_ = -(_e8751);
                                                    } else {
                                                        phi_19150_ = _e8751;
                                                    }
                                                    let _e8783 = phi_19150_;
                                                    if (_e8757 < 0f) {
                                                        phi_19156_ = -(_e8757);
                                                    } else {
                                                        phi_19156_ = _e8757;
                                                    }
                                                    let _e8787 = phi_19156_;
                                                    if (_e8783 > _e8787) {
                                                        phi_19161_ = 2u;
                                                        phi_19162_ = 1u;
                                                    } else {
                                                        phi_19161_ = 1u;
                                                        phi_19162_ = 0u;
                                                    }
                                                    let _e8790 = phi_19161_;
                                                    let _e8792 = phi_19162_;
                                                    phi_19181_ = _e8790;
                                                    phi_19182_ = _e8792;
                                                } else {
                                                    if (_e8754 < 0f) {
                                                        phi_19168_ = -(_e8754);
                                                    } else {
                                                        phi_19168_ = _e8754;
                                                    }
                                                    let _e8770 = phi_19168_;
                                                    if (_e8757 < 0f) {
                                                        phi_19174_ = -(_e8757);
                                                    } else {
                                                        phi_19174_ = _e8757;
                                                    }
                                                    let _e8774 = phi_19174_;
                                                    if (_e8770 > _e8774) {
                                                        phi_19179_ = 0u;
                                                        phi_19180_ = 2u;
                                                    } else {
                                                        phi_19179_ = 1u;
                                                        phi_19180_ = 0u;
                                                    }
                                                    let _e8777 = phi_19179_;
                                                    let _e8779 = phi_19180_;
                                                    phi_19181_ = _e8777;
                                                    phi_19182_ = _e8779;
                                                }
                                                let _e8794 = phi_19181_;
                                                let _e8796 = phi_19182_;
                                                let _e8799 = local_3.member[_e8796];
                                                let _e8802 = local_4.member[_e8794];
                                                let _e8806 = local_3.member[_e8794];
                                                let _e8809 = local_4.member[_e8796];
                                                let _e8811 = ((_e8799 * _e8802) - (_e8806 * _e8809));
                                                let _e8813 = local_3.member_1;
                                                let _e8815 = local_4.member_2;
                                                let _e8818 = local_3.member_2;
                                                let _e8820 = local_4.member_1;
                                                let _e8825 = local_3.member_2;
                                                let _e8828 = local_4.member_2;
                                                let _e8836 = local_3.member_2;
                                                let _e8839 = local_4.member_2;
                                                let _e8843 = (((((_e8813 * _e8815) + (_e8818 * _e8820)) * 2.01f) + (((_e8825 * 2f) * (_e8828 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e8836) * (1f + _e8839))));
                                                if (_e8811 < 0f) {
                                                    phi_19251_ = -(_e8811);
                                                } else {
                                                    phi_19251_ = _e8811;
                                                }
                                                let _e8847 = phi_19251_;
                                                if (_e8847 > _e8843) {
                                                    if (_e8811 < 0f) {
                                                        phi_19260_ = -1f;
                                                    } else {
                                                        phi_19260_ = 1f;
                                                    }
                                                    let _e8851 = phi_19260_;
                                                    let _e8854 = local_2.member[_e8796];
                                                    let _e8857 = local_4.member[_e8794];
                                                    let _e8861 = local_2.member[_e8794];
                                                    let _e8864 = local_4.member[_e8796];
                                                    let _e8868 = local_2.member_1;
                                                    let _e8870 = local_4.member_2;
                                                    let _e8873 = local_2.member_2;
                                                    let _e8875 = local_4.member_1;
                                                    let _e8880 = local_2.member_2;
                                                    let _e8883 = local_4.member_2;
                                                    let _e8891 = local_2.member_2;
                                                    let _e8894 = local_4.member_2;
                                                    let _e8898 = (((((_e8868 * _e8870) + (_e8873 * _e8875)) * 2.01f) + (((_e8880 * 2f) * (_e8883 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e8891) * (1f + _e8894))));
                                                    let _e8901 = local_3.member[_e8796];
                                                    let _e8904 = local_2.member[_e8794];
                                                    let _e8908 = local_3.member[_e8794];
                                                    let _e8911 = local_2.member[_e8796];
                                                    let _e8915 = local_3.member_1;
                                                    let _e8917 = local_2.member_2;
                                                    let _e8920 = local_3.member_2;
                                                    let _e8922 = local_2.member_1;
                                                    let _e8927 = local_3.member_2;
                                                    let _e8930 = local_2.member_2;
                                                    let _e8938 = local_3.member_2;
                                                    let _e8941 = local_2.member_2;
                                                    let _e8945 = (((((_e8915 * _e8917) + (_e8920 * _e8922)) * 2.01f) + (((_e8927 * 2f) * (_e8930 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e8938) * (1f + _e8941))));
                                                    let _e8946 = (_e8811 * _e8851);
                                                    let _e8947 = (((_e8854 * _e8857) - (_e8861 * _e8864)) * _e8851);
                                                    let _e8948 = (((_e8901 * _e8904) - (_e8908 * _e8911)) * _e8851);
                                                    if (_e8946 < 0f) {
                                                        phi_19395_ = -(_e8946);
                                                    } else {
                                                        phi_19395_ = _e8946;
                                                    }
                                                    let _e8952 = phi_19395_;
                                                    if (_e8947 < 0f) {
                                                        phi_19401_ = -(_e8947);
                                                    } else {
                                                        phi_19401_ = _e8947;
                                                    }
                                                    let _e8956 = phi_19401_;
                                                    if (_e8948 < 0f) {
                                                        phi_19408_ = -(_e8948);
                                                    } else {
                                                        phi_19408_ = _e8948;
                                                    }
                                                    let _e8961 = phi_19408_;
                                                    let _e8964 = (((_e8952 + _e8956) + _e8961) * (0.000000059604645f * 4f));
                                                    if (_e316.member != 0u) {
                                                        phi_19443_ = array<type_16, 4>(type_16(_e8947, _e8898), type_16(_e8948, _e8945), type_16((_e8946 - _e8947), ((_e8843 + _e8898) + _e8964)), type_16((_e8946 - _e8948), ((_e8843 + _e8945) + _e8964)));
                                                    } else {
                                                        let _e8967 = ((_e8946 - _e8947) - _e8948);
                                                        let _e8970 = (((_e8843 + _e8898) + _e8945) + _e8964);
                                                        phi_19443_ = array<type_16, 4>(type_16(_e8947, _e8898), type_16(_e8948, _e8945), type_16(_e8967, _e8970), type_16(_e8967, _e8970));
                                                    }
                                                    let _e8988 = phi_19443_;
                                                    local_5 = array<type_16, 4>(type_16(_e8988[0].member, _e8988[0].member_1), type_16(_e8988[1].member, _e8988[1].member_1), type_16(_e8988[2].member, _e8988[2].member_1), type_16(_e8988[3].member, _e8988[3].member_1));
                                                    phi_19463_ = type_9(0u, 4u);
                                                    phi_19466_ = true;
                                                    loop {
                                                        let _e9007 = phi_19463_;
                                                        let _e9009 = phi_19466_;
                                                        local_93 = _e9009;
                                                        if (_e9007.member < _e9007.member_1) {
                                                            phi_19464_ = type_9((_e9007.member + 1u), _e9007.member_1);
                                                            phi_19489_ = type_9(1u, _e9007.member);
                                                        } else {
                                                            phi_19464_ = _e9007;
                                                            phi_19489_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e9021 = phi_19464_;
                                                        let _e9023 = phi_19489_;
                                                        if (bitcast<i32>(_e9023.member) != 0i) {
                                                            let _e9030 = local_5[_e9023.member_1].member;
                                                            let _e9033 = local_5[_e9023.member_1].member_1;
                                                            let _e9035 = (_e9030 < -(_e9033));
                                                            if _e9035 {
                                                                phi_19516_ = bool();
                                                                phi_19517_ = false;
                                                            } else {
                                                                phi_19516_ = (_e9009 && (_e9030 > _e9033));
                                                                phi_19517_ = true;
                                                            }
                                                            let _e9039 = phi_19516_;
                                                            let _e9041 = phi_19517_;
                                                            phi_19467_ = _e9039;
                                                            phi_19518_ = _e9041;
                                                            phi_19519_ = _e9035;
                                                        } else {
                                                            phi_19467_ = bool();
                                                            phi_19518_ = false;
                                                            phi_19519_ = false;
                                                        }
                                                        let _e9043 = phi_19467_;
                                                        let _e9045 = phi_19518_;
                                                        let _e9047 = phi_19519_;
                                                        local_92 = _e9047;
                                                        continue;
                                                        continuing {
                                                            phi_19463_ = _e9021;
                                                            phi_19466_ = _e9043;
                                                            break if !(_e9045);
                                                        }
                                                    }
                                                    let _e9050 = local_92;
                                                    if _e9050 {
                                                        phi_19523_ = false;
                                                    } else {
                                                        phi_19523_ = true;
                                                    }
                                                    let _e9052 = phi_19523_;
                                                    if _e9052 {
                                                        let _e9054 = local_93;
                                                        if _e9054 {
                                                            phi_19530_ = 1u;
                                                        } else {
                                                            phi_19530_ = 2u;
                                                        }
                                                        let _e9056 = phi_19530_;
                                                        phi_19531_ = _e9056;
                                                        phi_19532_ = false;
                                                    } else {
                                                        phi_19531_ = u32();
                                                        phi_19532_ = true;
                                                    }
                                                    let _e9058 = phi_19531_;
                                                    let _e9060 = phi_19532_;
                                                    phi_19533_ = _e9058;
                                                    phi_19534_ = 0u;
                                                    phi_19535_ = _e9060;
                                                } else {
                                                    phi_19533_ = u32();
                                                    phi_19534_ = 2u;
                                                    phi_19535_ = true;
                                                }
                                                let _e9062 = phi_19533_;
                                                let _e9064 = phi_19534_;
                                                let _e9066 = phi_19535_;
                                                if _e9066 {
                                                    phi_19539_ = _e9064;
                                                } else {
                                                    phi_19539_ = _e9062;
                                                }
                                                let _e9068 = phi_19539_;
                                                let _e9069 = (_e9068 == 0u);
                                                if _e9069 {
                                                    phi_22248_ = bool();
                                                    phi_22249_ = f32();
                                                    phi_22250_ = f32();
                                                    phi_22251_ = false;
                                                    phi_22252_ = false;
                                                    phi_22253_ = false;
                                                } else {
                                                    if (_e9068 == 1u) {
                                                        phi_19549_ = _e8338.member_2;
                                                    } else {
                                                        phi_19549_ = false;
                                                    }
                                                    let _e9073 = phi_19549_;
                                                    let _e9074 = (_e5619 * 0.99f);
                                                    if _e9073 {
                                                        if ((_e8338.member_1 - _e8338.member) <= _e9074) {
                                                            phi_19561_ = false;
                                                        } else {
                                                            phi_19561_ = true;
                                                        }
                                                        let _e9080 = phi_19561_;
                                                        phi_19562_ = _e9080;
                                                    } else {
                                                        phi_19562_ = true;
                                                    }
                                                    let _e9082 = phi_19562_;
                                                    if _e9082 {
                                                        let _e9087 = local_18.member[0u];
                                                        let _e9094 = local_18.member_1[0u];
                                                        let _e9100 = local_18.member_2[0u];
                                                        let _e9104 = (_e9087[0] - _e9094[0]);
                                                        let _e9105 = (_e9087[1] - _e9094[1]);
                                                        let _e9106 = (_e9087[2] - _e9094[2]);
                                                        if (_e316.member == 0u) {
                                                            phi_19623_ = array<f32, 3>(_e9087[0], _e9087[1], _e9087[2]);
                                                        } else {
                                                            phi_19623_ = array<f32, 3>((_e9104 - _e9100[0]), (_e9105 - _e9100[1]), (_e9106 - _e9100[2]));
                                                        }
                                                        let _e9113 = phi_19623_;
                                                        let _e9119 = local_18.member[1u];
                                                        let _e9126 = local_18.member_1[1u];
                                                        let _e9132 = local_18.member_2[1u];
                                                        let _e9136 = (_e9119[0] - _e9126[0]);
                                                        let _e9137 = (_e9119[1] - _e9126[1]);
                                                        let _e9138 = (_e9119[2] - _e9126[2]);
                                                        if (_e316.member == 0u) {
                                                            phi_19688_ = array<f32, 3>(_e9119[0], _e9119[1], _e9119[2]);
                                                        } else {
                                                            phi_19688_ = array<f32, 3>((_e9136 - _e9132[0]), (_e9137 - _e9132[1]), (_e9138 - _e9132[2]));
                                                        }
                                                        let _e9145 = phi_19688_;
                                                        let _e9151 = local_18.member[0u];
                                                        if (_e9151[0] < 0f) {
                                                            phi_19710_ = -(_e9151[0]);
                                                        } else {
                                                            phi_19710_ = _e9151[0];
                                                        }
                                                        let _e9158 = phi_19710_;
                                                        if (_e9151[1] < 0f) {
                                                            phi_19717_ = -(_e9151[1]);
                                                        } else {
                                                            phi_19717_ = _e9151[1];
                                                        }
                                                        let _e9162 = phi_19717_;
                                                        if (_e9158 > _e9162) {
                                                            phi_19722_ = _e9158;
                                                        } else {
                                                            phi_19722_ = _e9162;
                                                        }
                                                        let _e9165 = phi_19722_;
                                                        if (_e9151[2] < 0f) {
                                                            phi_19729_ = -(_e9151[2]);
                                                        } else {
                                                            phi_19729_ = _e9151[2];
                                                        }
                                                        let _e9169 = phi_19729_;
                                                        if (_e9165 > _e9169) {
                                                            phi_19734_ = _e9165;
                                                        } else {
                                                            phi_19734_ = _e9169;
                                                        }
                                                        let _e9172 = phi_19734_;
                                                        let _e9175 = local_18.member[1u];
                                                        if (_e9175[0] < 0f) {
                                                            phi_19747_ = -(_e9175[0]);
                                                        } else {
                                                            phi_19747_ = _e9175[0];
                                                        }
                                                        let _e9182 = phi_19747_;
                                                        if (_e9175[1] < 0f) {
                                                            phi_19754_ = -(_e9175[1]);
                                                        } else {
                                                            phi_19754_ = _e9175[1];
                                                        }
                                                        let _e9186 = phi_19754_;
                                                        if (_e9182 > _e9186) {
                                                            phi_19759_ = _e9182;
                                                        } else {
                                                            phi_19759_ = _e9186;
                                                        }
                                                        let _e9189 = phi_19759_;
                                                        if (_e9175[2] < 0f) {
                                                            phi_19766_ = -(_e9175[2]);
                                                        } else {
                                                            phi_19766_ = _e9175[2];
                                                        }
                                                        let _e9193 = phi_19766_;
                                                        if (_e9189 > _e9193) {
                                                            phi_19771_ = _e9189;
                                                        } else {
                                                            phi_19771_ = _e9193;
                                                        }
                                                        let _e9196 = phi_19771_;
                                                        if (_e9172 > _e9196) {
                                                            phi_19776_ = _e9172;
                                                        } else {
                                                            phi_19776_ = _e9196;
                                                        }
                                                        let _e9199 = phi_19776_;
                                                        let _e9201 = local_18.member_3;
                                                        let _e9205 = local_18.member_1[0u];
                                                        if (_e9205[0] < 0f) {
                                                            phi_19793_ = -(_e9205[0]);
                                                        } else {
                                                            phi_19793_ = _e9205[0];
                                                        }
                                                        let _e9212 = phi_19793_;
                                                        if (_e9205[1] < 0f) {
                                                            phi_19800_ = -(_e9205[1]);
                                                        } else {
                                                            phi_19800_ = _e9205[1];
                                                        }
                                                        let _e9216 = phi_19800_;
                                                        if (_e9212 > _e9216) {
                                                            phi_19805_ = _e9212;
                                                        } else {
                                                            phi_19805_ = _e9216;
                                                        }
                                                        let _e9219 = phi_19805_;
                                                        if (_e9205[2] < 0f) {
                                                            phi_19812_ = -(_e9205[2]);
                                                        } else {
                                                            phi_19812_ = _e9205[2];
                                                        }
                                                        let _e9223 = phi_19812_;
                                                        if (_e9219 > _e9223) {
                                                            phi_19817_ = _e9219;
                                                        } else {
                                                            phi_19817_ = _e9223;
                                                        }
                                                        let _e9226 = phi_19817_;
                                                        let _e9229 = local_18.member_1[1u];
                                                        if (_e9229[0] < 0f) {
                                                            phi_19831_ = -(_e9229[0]);
                                                        } else {
                                                            phi_19831_ = _e9229[0];
                                                        }
                                                        let _e9236 = phi_19831_;
                                                        if (_e9229[1] < 0f) {
                                                            phi_19838_ = -(_e9229[1]);
                                                        } else {
                                                            phi_19838_ = _e9229[1];
                                                        }
                                                        let _e9240 = phi_19838_;
                                                        if (_e9236 > _e9240) {
                                                            phi_19843_ = _e9236;
                                                        } else {
                                                            phi_19843_ = _e9240;
                                                        }
                                                        let _e9243 = phi_19843_;
                                                        if (_e9229[2] < 0f) {
                                                            phi_19850_ = -(_e9229[2]);
                                                        } else {
                                                            phi_19850_ = _e9229[2];
                                                        }
                                                        let _e9247 = phi_19850_;
                                                        if (_e9243 > _e9247) {
                                                            phi_19855_ = _e9243;
                                                        } else {
                                                            phi_19855_ = _e9247;
                                                        }
                                                        let _e9250 = phi_19855_;
                                                        if (_e9226 > _e9250) {
                                                            phi_19860_ = _e9226;
                                                        } else {
                                                            phi_19860_ = _e9250;
                                                        }
                                                        let _e9253 = phi_19860_;
                                                        let _e9255 = local_18.member_3;
                                                        let _e9259 = local_18.member_2[0u];
                                                        if (_e9259[0] < 0f) {
                                                            phi_19877_ = -(_e9259[0]);
                                                        } else {
                                                            phi_19877_ = _e9259[0];
                                                        }
                                                        let _e9266 = phi_19877_;
                                                        if (_e9259[1] < 0f) {
                                                            phi_19884_ = -(_e9259[1]);
                                                        } else {
                                                            phi_19884_ = _e9259[1];
                                                        }
                                                        let _e9270 = phi_19884_;
                                                        if (_e9266 > _e9270) {
                                                            phi_19889_ = _e9266;
                                                        } else {
                                                            phi_19889_ = _e9270;
                                                        }
                                                        let _e9273 = phi_19889_;
                                                        if (_e9259[2] < 0f) {
                                                            phi_19896_ = -(_e9259[2]);
                                                        } else {
                                                            phi_19896_ = _e9259[2];
                                                        }
                                                        let _e9277 = phi_19896_;
                                                        if (_e9273 > _e9277) {
                                                            phi_19901_ = _e9273;
                                                        } else {
                                                            phi_19901_ = _e9277;
                                                        }
                                                        let _e9280 = phi_19901_;
                                                        let _e9283 = local_18.member_2[1u];
                                                        if (_e9283[0] < 0f) {
                                                            phi_19915_ = -(_e9283[0]);
                                                        } else {
                                                            phi_19915_ = _e9283[0];
                                                        }
                                                        let _e9290 = phi_19915_;
                                                        if (_e9283[1] < 0f) {
                                                            phi_19922_ = -(_e9283[1]);
                                                        } else {
                                                            phi_19922_ = _e9283[1];
                                                        }
                                                        let _e9294 = phi_19922_;
                                                        if (_e9290 > _e9294) {
                                                            phi_19927_ = _e9290;
                                                        } else {
                                                            phi_19927_ = _e9294;
                                                        }
                                                        let _e9297 = phi_19927_;
                                                        if (_e9283[2] < 0f) {
                                                            phi_19934_ = -(_e9283[2]);
                                                        } else {
                                                            phi_19934_ = _e9283[2];
                                                        }
                                                        let _e9301 = phi_19934_;
                                                        if (_e9297 > _e9301) {
                                                            phi_19939_ = _e9297;
                                                        } else {
                                                            phi_19939_ = _e9301;
                                                        }
                                                        let _e9304 = phi_19939_;
                                                        if (_e9280 > _e9304) {
                                                            phi_19944_ = _e9280;
                                                        } else {
                                                            phi_19944_ = _e9304;
                                                        }
                                                        let _e9307 = phi_19944_;
                                                        let _e9309 = local_18.member_3;
                                                        let _e9316 = local_18.member_3;
                                                        let _e9321 = (_e5619 * 0.00390625f);
                                                        local = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                        phi_19985_ = type_9(0u, 96u);
                                                        phi_19988_ = _e8338.member;
                                                        phi_19990_ = _e8338.member;
                                                        phi_19992_ = (_e8338.member_1 - _e8338.member);
                                                        phi_19994_ = _e8338.member;
                                                        phi_19996_ = false;
                                                        phi_19998_ = 0u;
                                                        loop {
                                                            let _e9324 = phi_19985_;
                                                            let _e9326 = phi_19988_;
                                                            let _e9328 = phi_19990_;
                                                            let _e9330 = phi_19992_;
                                                            let _e9332 = phi_19994_;
                                                            let _e9334 = phi_19996_;
                                                            let _e9336 = phi_19998_;
                                                            local_96 = _e9326;
                                                            local_146 = _e9328;
                                                            if (_e9324.member < _e9324.member_1) {
                                                                phi_19986_ = type_9((_e9324.member + 1u), _e9324.member_1);
                                                                phi_20021_ = type_9(1u, _e9324.member);
                                                            } else {
                                                                phi_19986_ = _e9324;
                                                                phi_20021_ = type_9(0u, type_9().member_1);
                                                            }
                                                            let _e9348 = phi_19986_;
                                                            let _e9350 = phi_20021_;
                                                            if (bitcast<i32>(_e9350.member) != 0i) {
                                                                let _e9356 = local_18.member[0u];
                                                                let _e9362 = local_18.member[1u];
                                                                let _e9378 = local_18.member_1[0u];
                                                                let _e9384 = local_18.member_1[1u];
                                                                let _e9400 = local_18.member_2[0u];
                                                                let _e9406 = local_18.member_2[1u];
                                                                let _e9420 = function_4(array<f32, 3>((_e9356[0] + ((_e9362[0] - _e9356[0]) * _e9326)), (_e9356[1] + ((_e9362[1] - _e9356[1]) * _e9326)), (_e9356[2] + ((_e9362[2] - _e9356[2]) * _e9326))), array<f32, 3>((_e9378[0] + ((_e9384[0] - _e9378[0]) * _e9326)), (_e9378[1] + ((_e9384[1] - _e9378[1]) * _e9326)), (_e9378[2] + ((_e9384[2] - _e9378[2]) * _e9326))), array<f32, 3>((_e9400[0] + ((_e9406[0] - _e9400[0]) * _e9326)), (_e9400[1] + ((_e9406[1] - _e9400[1]) * _e9326)), (_e9400[2] + ((_e9406[2] - _e9400[2]) * _e9326))), _e316.member);
                                                                if (_e9336 == 0u) {
                                                                    phi_20149_ = _e9420;
                                                                } else {
                                                                    if (_e9336 == 1u) {
                                                                        phi_20135_ = _e9420[0];
                                                                    } else {
                                                                        phi_20135_ = 0f;
                                                                    }
                                                                    let _e9425 = phi_20135_;
                                                                    if (_e9336 == 2u) {
                                                                        phi_20141_ = _e9420[1];
                                                                    } else {
                                                                        phi_20141_ = 0f;
                                                                    }
                                                                    let _e9429 = phi_20141_;
                                                                    if (_e9336 == 3u) {
                                                                        phi_20147_ = _e9420[2];
                                                                    } else {
                                                                        phi_20147_ = 0f;
                                                                    }
                                                                    let _e9433 = phi_20147_;
                                                                    phi_20149_ = array<f32, 3>(_e9425, _e9429, _e9433);
                                                                }
                                                                let _e9436 = phi_20149_;
                                                                if (_e9436[0] < 0f) {
                                                                    phi_20156_ = -(_e9436[0]);
                                                                } else {
                                                                    phi_20156_ = _e9436[0];
                                                                }
                                                                let _e9441 = phi_20156_;
                                                                if (_e9436[1] < 0f) {
                                                                    phi_20163_ = -(_e9436[1]);
                                                                } else {
                                                                    phi_20163_ = _e9436[1];
                                                                }
                                                                let _e9446 = phi_20163_;
                                                                if (_e9436[2] < 0f) {
                                                                    phi_20171_ = -(_e9436[2]);
                                                                } else {
                                                                    phi_20171_ = _e9436[2];
                                                                }
                                                                let _e9452 = phi_20171_;
                                                                let _e9453 = ((_e9441 + _e9446) + _e9452);
                                                                if (_e9453 > 0f) {
                                                                    if ((bitcast<u32>(_e9453) & 2139095040u) != 2139095040u) {
                                                                        let _e9458 = (1f / _e9453);
                                                                        let _e9460 = (_e9436[0] * _e9458);
                                                                        let _e9462 = (_e9436[1] * _e9458);
                                                                        let _e9464 = (_e9436[2] * _e9458);
                                                                        let _e9469 = (((_e9460 * _e9460) + (_e9462 * _e9462)) + (_e9464 * _e9464));
                                                                        if (_e9469 <= 0.000000000000000000000000000000000000011754944f) {
                                                                            if (_e9469 > 0f) {
                                                                                phi_20208_ = (0.000000000000000000106433627f * 2f);
                                                                            } else {
                                                                                phi_20208_ = 0f;
                                                                            }
                                                                            let _e9522 = phi_20208_;
                                                                            phi_20272_ = _e9522;
                                                                        } else {
                                                                            phi_20215_ = type_14(0i, 5i);
                                                                            phi_20218_ = bitcast<f32>(((bitcast<u32>(_e9469) >> bitcast<u32>(1i)) + 532369198u));
                                                                            loop {
                                                                                let _e9477 = phi_20215_;
                                                                                let _e9479 = phi_20218_;
                                                                                local_94 = _e9479;
                                                                                if (_e9477.member < _e9477.member_1) {
                                                                                    let _e9486 = (_e9477.member + 1i);
                                                                                    if ((false == (_e9486 > _e9477.member)) != false) {
                                                                                        phi_20239_ = true;
                                                                                    } else {
                                                                                        phi_20239_ = false;
                                                                                    }
                                                                                    let _e9491 = phi_20239_;
                                                                                    if _e9491 {
                                                                                        phi_20245_ = type_15(0u, type_15().member_1);
                                                                                    } else {
                                                                                        phi_20245_ = type_15(1u, _e9486);
                                                                                    }
                                                                                    let _e9496 = phi_20245_;
                                                                                    phi_20216_ = type_14(_e9496.member_1, _e9477.member_1);
                                                                                    phi_20259_ = type_15(1u, _e9477.member);
                                                                                } else {
                                                                                    phi_20216_ = _e9477;
                                                                                    phi_20259_ = type_15(0u, type_15().member_1);
                                                                                }
                                                                                let _e9502 = phi_20216_;
                                                                                let _e9504 = phi_20259_;
                                                                                let _e9507 = (bitcast<i32>(_e9504.member) != 0i);
                                                                                if _e9507 {
                                                                                    phi_20219_ = (0.5f * (_e9479 + (_e9469 / _e9479)));
                                                                                } else {
                                                                                    phi_20219_ = f32();
                                                                                }
                                                                                let _e9512 = phi_20219_;
                                                                                continue;
                                                                                continuing {
                                                                                    phi_20215_ = _e9502;
                                                                                    phi_20218_ = _e9512;
                                                                                    break if !(_e9507);
                                                                                }
                                                                            }
                                                                            let _e9517 = local_94;
                                                                            phi_20272_ = (_e9517 * (1f + (8f * 0.000000059604645f)));
                                                                        }
                                                                        let _e9524 = phi_20272_;
                                                                        let _e9525 = (0.000000059604645f * 12f);
                                                                        let _e9530 = ((((((((_e9199 + _e9201) + (_e9253 + _e9255)) + (_e9307 + _e9309)) * (0.000000059604645f * 16f)) + (_e9316 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e9524) * (1f + _e9525)));
                                                                        let _e9535 = (((_e9460 * _e9087[0]) + (_e9462 * _e9087[1])) + (_e9464 * _e9087[2]));
                                                                        let _e9540 = (((_e9460 * _e9104) + (_e9462 * _e9105)) + (_e9464 * _e9106));
                                                                        let _e9545 = (((_e9460 * (_e9087[0] - _e9100[0])) + (_e9462 * (_e9087[1] - _e9100[1]))) + (_e9464 * (_e9087[2] - _e9100[2])));
                                                                        let _e9553 = (((_e9460 * _e9113[0]) + (_e9462 * _e9113[1])) + (_e9464 * _e9113[2]));
                                                                        let _e9559 = (((_e9460 * _e9119[0]) + (_e9462 * _e9119[1])) + (_e9464 * _e9119[2]));
                                                                        let _e9564 = (((_e9460 * _e9136) + (_e9462 * _e9137)) + (_e9464 * _e9138));
                                                                        let _e9569 = (((_e9460 * (_e9119[0] - _e9132[0])) + (_e9462 * (_e9119[1] - _e9132[1]))) + (_e9464 * (_e9119[2] - _e9132[2])));
                                                                        let _e9577 = (((_e9460 * _e9145[0]) + (_e9462 * _e9145[1])) + (_e9464 * _e9145[2]));
                                                                        if (_e9535 < 0f) {
                                                                            phi_20338_ = -(_e9535);
                                                                        } else {
                                                                            phi_20338_ = _e9535;
                                                                        }
                                                                        let _e9582 = phi_20338_;
                                                                        if (_e9559 < 0f) {
                                                                            phi_20344_ = -(_e9559);
                                                                        } else {
                                                                            phi_20344_ = _e9559;
                                                                        }
                                                                        let _e9586 = phi_20344_;
                                                                        if (_e9540 < 0f) {
                                                                            phi_20353_ = -(_e9540);
                                                                        } else {
                                                                            phi_20353_ = _e9540;
                                                                        }
                                                                        let _e9593 = phi_20353_;
                                                                        if (_e9564 < 0f) {
                                                                            phi_20359_ = -(_e9564);
                                                                        } else {
                                                                            phi_20359_ = _e9564;
                                                                        }
                                                                        let _e9597 = phi_20359_;
                                                                        if (_e9545 < 0f) {
                                                                            phi_20368_ = -(_e9545);
                                                                        } else {
                                                                            phi_20368_ = _e9545;
                                                                        }
                                                                        let _e9604 = phi_20368_;
                                                                        if (_e9569 < 0f) {
                                                                            phi_20374_ = -(_e9569);
                                                                        } else {
                                                                            phi_20374_ = _e9569;
                                                                        }
                                                                        let _e9608 = phi_20374_;
                                                                        if (_e9553 < 0f) {
                                                                            phi_20383_ = -(_e9553);
                                                                        } else {
                                                                            phi_20383_ = _e9553;
                                                                        }
                                                                        let _e9615 = phi_20383_;
                                                                        if (_e9577 < 0f) {
                                                                            phi_20389_ = -(_e9577);
                                                                        } else {
                                                                            phi_20389_ = _e9577;
                                                                        }
                                                                        let _e9619 = phi_20389_;
                                                                        phi_20395_ = type_30(array<f32, 4>(_e9535, _e9540, _e9545, _e9553), array<f32, 4>(_e9559, _e9564, _e9569, _e9577), array<f32, 4>((_e9530 + ((_e9582 + _e9586) * _e9525)), (_e9530 + ((_e9593 + _e9597) * _e9525)), (_e9530 + ((_e9604 + _e9608) * _e9525)), (_e9530 + ((_e9615 + _e9619) * _e9525))));
                                                                        phi_20396_ = false;
                                                                    } else {
                                                                        phi_20395_ = type_30();
                                                                        phi_20396_ = true;
                                                                    }
                                                                    let _e9626 = phi_20395_;
                                                                    let _e9628 = phi_20396_;
                                                                    phi_20397_ = _e9626;
                                                                    phi_20398_ = _e9628;
                                                                } else {
                                                                    phi_20397_ = type_30();
                                                                    phi_20398_ = true;
                                                                }
                                                                let _e9630 = phi_20397_;
                                                                let _e9632 = phi_20398_;
                                                                if _e9632 {
                                                                    phi_20406_ = type_30(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                                } else {
                                                                    phi_20406_ = _e9630;
                                                                }
                                                                let _e9634 = phi_20406_;
                                                                local_1 = type_30(array<f32, 4>(_e9634.member[0], _e9634.member[1], _e9634.member[2], _e9634.member[3]), array<f32, 4>(_e9634.member_1[0], _e9634.member_1[1], _e9634.member_1[2], _e9634.member_1[3]), array<f32, 4>(_e9634.member_2[0], _e9634.member_2[1], _e9634.member_2[2], _e9634.member_2[3]));
                                                                let _e9654 = (_e9326 - _e9332);
                                                                let _e9658 = local_1.member[0u];
                                                                let _e9661 = local_1.member_1[0u];
                                                                let _e9664 = local_1.member[0u];
                                                                let _e9670 = local_1.member_2[0u];
                                                                if (((_e9658 + ((_e9661 - _e9664) * _e9326)) - _e9670) > 0f) {
                                                                    let _e9675 = local_1.member[1u];
                                                                    let _e9678 = local_1.member_1[1u];
                                                                    let _e9681 = local_1.member[1u];
                                                                    let _e9687 = local_1.member_2[1u];
                                                                    if (((_e9675 + ((_e9678 - _e9681) * _e9326)) - _e9687) > 0f) {
                                                                        let _e9692 = local_1.member[2u];
                                                                        let _e9695 = local_1.member_1[2u];
                                                                        let _e9698 = local_1.member[2u];
                                                                        let _e9704 = local_1.member_2[2u];
                                                                        if (((_e9692 + ((_e9695 - _e9698) * _e9326)) - _e9704) > 0f) {
                                                                            let _e9709 = local_1.member[3u];
                                                                            let _e9712 = local_1.member_1[3u];
                                                                            let _e9715 = local_1.member[3u];
                                                                            let _e9721 = local_1.member_2[3u];
                                                                            phi_20577_ = (((_e9709 + ((_e9712 - _e9715) * _e9326)) - _e9721) > 0f);
                                                                            phi_20578_ = false;
                                                                        } else {
                                                                            phi_20577_ = bool();
                                                                            phi_20578_ = true;
                                                                        }
                                                                        let _e9725 = phi_20577_;
                                                                        let _e9727 = phi_20578_;
                                                                        phi_20579_ = _e9725;
                                                                        phi_20580_ = _e9727;
                                                                    } else {
                                                                        phi_20579_ = bool();
                                                                        phi_20580_ = true;
                                                                    }
                                                                    let _e9729 = phi_20579_;
                                                                    let _e9731 = phi_20580_;
                                                                    phi_20581_ = _e9729;
                                                                    phi_20582_ = _e9731;
                                                                } else {
                                                                    phi_20581_ = bool();
                                                                    phi_20582_ = true;
                                                                }
                                                                let _e9733 = phi_20581_;
                                                                let _e9735 = phi_20582_;
                                                                if _e9735 {
                                                                    phi_20586_ = false;
                                                                } else {
                                                                    phi_20586_ = _e9733;
                                                                }
                                                                let _e9737 = phi_20586_;
                                                                if _e9737 {
                                                                    if (_e9326 <= _e9328) {
                                                                        phi_20896_ = true;
                                                                    } else {
                                                                        let _e9741 = local.member[0u];
                                                                        let _e9744 = local.member_1[0u];
                                                                        let _e9747 = local.member[0u];
                                                                        let _e9753 = local.member_2[0u];
                                                                        let _e9757 = local_1.member[0u];
                                                                        let _e9760 = local_1.member_1[0u];
                                                                        let _e9763 = local_1.member[0u];
                                                                        let _e9769 = local_1.member_2[0u];
                                                                        if ((((_e9741 + ((_e9744 - _e9747) * _e9326)) - _e9753) + ((_e9757 + ((_e9760 - _e9763) * _e9332)) - _e9769)) > 0f) {
                                                                            let _e9775 = local.member[1u];
                                                                            let _e9778 = local.member_1[1u];
                                                                            let _e9781 = local.member[1u];
                                                                            let _e9787 = local.member_2[1u];
                                                                            let _e9791 = local_1.member[1u];
                                                                            let _e9794 = local_1.member_1[1u];
                                                                            let _e9797 = local_1.member[1u];
                                                                            let _e9803 = local_1.member_2[1u];
                                                                            if ((((_e9775 + ((_e9778 - _e9781) * _e9326)) - _e9787) + ((_e9791 + ((_e9794 - _e9797) * _e9332)) - _e9803)) > 0f) {
                                                                                let _e9809 = local.member[2u];
                                                                                let _e9812 = local.member_1[2u];
                                                                                let _e9815 = local.member[2u];
                                                                                let _e9821 = local.member_2[2u];
                                                                                let _e9825 = local_1.member[2u];
                                                                                let _e9828 = local_1.member_1[2u];
                                                                                let _e9831 = local_1.member[2u];
                                                                                let _e9837 = local_1.member_2[2u];
                                                                                if ((((_e9809 + ((_e9812 - _e9815) * _e9326)) - _e9821) + ((_e9825 + ((_e9828 - _e9831) * _e9332)) - _e9837)) > 0f) {
                                                                                    let _e9843 = local.member[3u];
                                                                                    let _e9846 = local.member_1[3u];
                                                                                    let _e9849 = local.member[3u];
                                                                                    let _e9855 = local.member_2[3u];
                                                                                    let _e9859 = local_1.member[3u];
                                                                                    let _e9862 = local_1.member_1[3u];
                                                                                    let _e9865 = local_1.member[3u];
                                                                                    let _e9871 = local_1.member_2[3u];
                                                                                    phi_20883_ = ((((_e9843 + ((_e9846 - _e9849) * _e9326)) - _e9855) + ((_e9859 + ((_e9862 - _e9865) * _e9332)) - _e9871)) > 0f);
                                                                                    phi_20884_ = false;
                                                                                } else {
                                                                                    phi_20883_ = bool();
                                                                                    phi_20884_ = true;
                                                                                }
                                                                                let _e9876 = phi_20883_;
                                                                                let _e9878 = phi_20884_;
                                                                                phi_20885_ = _e9876;
                                                                                phi_20886_ = _e9878;
                                                                            } else {
                                                                                phi_20885_ = bool();
                                                                                phi_20886_ = true;
                                                                            }
                                                                            let _e9880 = phi_20885_;
                                                                            let _e9882 = phi_20886_;
                                                                            phi_20887_ = _e9880;
                                                                            phi_20888_ = _e9882;
                                                                        } else {
                                                                            phi_20887_ = bool();
                                                                            phi_20888_ = true;
                                                                        }
                                                                        let _e9884 = phi_20887_;
                                                                        let _e9886 = phi_20888_;
                                                                        if _e9886 {
                                                                            phi_20892_ = false;
                                                                        } else {
                                                                            phi_20892_ = _e9884;
                                                                        }
                                                                        let _e9888 = phi_20892_;
                                                                        phi_20896_ = _e9888;
                                                                    }
                                                                    let _e9890 = phi_20896_;
                                                                    if _e9890 {
                                                                        if _e9334 {
                                                                            if (_e9326 >= _e8338.member_1) {
                                                                                phi_20907_ = false;
                                                                            } else {
                                                                                phi_20907_ = true;
                                                                            }
                                                                            let _e9893 = phi_20907_;
                                                                            phi_20908_ = _e9893;
                                                                        } else {
                                                                            phi_20908_ = true;
                                                                        }
                                                                        let _e9895 = phi_20908_;
                                                                        if _e9895 {
                                                                            local = type_30(array<f32, 4>(_e9634.member[0], _e9634.member[1], _e9634.member[2], _e9634.member[3]), array<f32, 4>(_e9634.member_1[0], _e9634.member_1[1], _e9634.member_1[2], _e9634.member_1[3]), array<f32, 4>(_e9634.member_2[0], _e9634.member_2[1], _e9634.member_2[2], _e9634.member_2[3]));
                                                                            let _e9917 = local.member[0u];
                                                                            let _e9920 = local.member_1[0u];
                                                                            let _e9923 = local.member_2[0u];
                                                                            if (_e9917 > _e9923) {
                                                                                if (_e9920 > _e9923) {
                                                                                    phi_20982_ = false;
                                                                                } else {
                                                                                    phi_20982_ = true;
                                                                                }
                                                                                let _e9927 = phi_20982_;
                                                                                phi_20983_ = _e9927;
                                                                            } else {
                                                                                phi_20983_ = true;
                                                                            }
                                                                            let _e9929 = phi_20983_;
                                                                            if _e9929 {
                                                                                let _e9930 = (_e9920 >= _e9917);
                                                                                if _e9930 {
                                                                                    phi_21005_ = f32();
                                                                                    phi_21006_ = false;
                                                                                } else {
                                                                                    if ((_e9917 - _e9920) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                        phi_21003_ = (((_e9917 - _e9923) / (_e9917 - _e9920)) * (1f - (0.000000059604645f * 16f)));
                                                                                        phi_21004_ = false;
                                                                                    } else {
                                                                                        phi_21003_ = f32();
                                                                                        phi_21004_ = true;
                                                                                    }
                                                                                    let _e9941 = phi_21003_;
                                                                                    let _e9943 = phi_21004_;
                                                                                    phi_21005_ = _e9941;
                                                                                    phi_21006_ = _e9943;
                                                                                }
                                                                                let _e9945 = phi_21005_;
                                                                                let _e9947 = phi_21006_;
                                                                                phi_21007_ = _e9945;
                                                                                phi_21008_ = _e9930;
                                                                                phi_21009_ = _e9947;
                                                                            } else {
                                                                                phi_21007_ = f32();
                                                                                phi_21008_ = true;
                                                                                phi_21009_ = false;
                                                                            }
                                                                            let _e9949 = phi_21007_;
                                                                            let _e9951 = phi_21008_;
                                                                            let _e9953 = phi_21009_;
                                                                            if _e9951 {
                                                                                phi_21013_ = 2f;
                                                                                phi_21014_ = true;
                                                                            } else {
                                                                                phi_21013_ = _e9326;
                                                                                phi_21014_ = _e9953;
                                                                            }
                                                                            let _e9955 = phi_21013_;
                                                                            let _e9957 = phi_21014_;
                                                                            if _e9957 {
                                                                                phi_21018_ = _e9955;
                                                                            } else {
                                                                                phi_21018_ = _e9949;
                                                                            }
                                                                            let _e9959 = phi_21018_;
                                                                            let _e9962 = local.member[1u];
                                                                            let _e9965 = local.member_1[1u];
                                                                            let _e9968 = local.member_2[1u];
                                                                            if (_e9962 > _e9968) {
                                                                                if (_e9965 > _e9968) {
                                                                                    phi_21050_ = false;
                                                                                } else {
                                                                                    phi_21050_ = true;
                                                                                }
                                                                                let _e9972 = phi_21050_;
                                                                                phi_21051_ = _e9972;
                                                                            } else {
                                                                                phi_21051_ = true;
                                                                            }
                                                                            let _e9974 = phi_21051_;
                                                                            if _e9974 {
                                                                                let _e9975 = (_e9965 >= _e9962);
                                                                                if _e9975 {
                                                                                    phi_21073_ = f32();
                                                                                    phi_21074_ = false;
                                                                                } else {
                                                                                    if ((_e9962 - _e9965) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                        phi_21071_ = (((_e9962 - _e9968) / (_e9962 - _e9965)) * (1f - (0.000000059604645f * 16f)));
                                                                                        phi_21072_ = false;
                                                                                    } else {
                                                                                        phi_21071_ = f32();
                                                                                        phi_21072_ = true;
                                                                                    }
                                                                                    let _e9986 = phi_21071_;
                                                                                    let _e9988 = phi_21072_;
                                                                                    phi_21073_ = _e9986;
                                                                                    phi_21074_ = _e9988;
                                                                                }
                                                                                let _e9990 = phi_21073_;
                                                                                let _e9992 = phi_21074_;
                                                                                phi_21075_ = _e9990;
                                                                                phi_21076_ = _e9975;
                                                                                phi_21077_ = _e9992;
                                                                            } else {
                                                                                phi_21075_ = f32();
                                                                                phi_21076_ = true;
                                                                                phi_21077_ = false;
                                                                            }
                                                                            let _e9994 = phi_21075_;
                                                                            let _e9996 = phi_21076_;
                                                                            let _e9998 = phi_21077_;
                                                                            if _e9996 {
                                                                                phi_21081_ = 2f;
                                                                                phi_21082_ = true;
                                                                            } else {
                                                                                phi_21081_ = _e9326;
                                                                                phi_21082_ = _e9998;
                                                                            }
                                                                            let _e10000 = phi_21081_;
                                                                            let _e10002 = phi_21082_;
                                                                            if _e10002 {
                                                                                phi_21086_ = _e10000;
                                                                            } else {
                                                                                phi_21086_ = _e9994;
                                                                            }
                                                                            let _e10004 = phi_21086_;
                                                                            if (_e9959 < _e10004) {
                                                                                phi_21091_ = _e9959;
                                                                            } else {
                                                                                phi_21091_ = _e10004;
                                                                            }
                                                                            let _e10007 = phi_21091_;
                                                                            let _e10010 = local.member[2u];
                                                                            let _e10013 = local.member_1[2u];
                                                                            let _e10016 = local.member_2[2u];
                                                                            if (_e10010 > _e10016) {
                                                                                if (_e10013 > _e10016) {
                                                                                    phi_21123_ = false;
                                                                                } else {
                                                                                    phi_21123_ = true;
                                                                                }
                                                                                let _e10020 = phi_21123_;
                                                                                phi_21124_ = _e10020;
                                                                            } else {
                                                                                phi_21124_ = true;
                                                                            }
                                                                            let _e10022 = phi_21124_;
                                                                            if _e10022 {
                                                                                let _e10023 = (_e10013 >= _e10010);
                                                                                if _e10023 {
                                                                                    phi_21146_ = f32();
                                                                                    phi_21147_ = false;
                                                                                } else {
                                                                                    if ((_e10010 - _e10013) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                        phi_21144_ = (((_e10010 - _e10016) / (_e10010 - _e10013)) * (1f - (0.000000059604645f * 16f)));
                                                                                        phi_21145_ = false;
                                                                                    } else {
                                                                                        phi_21144_ = f32();
                                                                                        phi_21145_ = true;
                                                                                    }
                                                                                    let _e10034 = phi_21144_;
                                                                                    let _e10036 = phi_21145_;
                                                                                    phi_21146_ = _e10034;
                                                                                    phi_21147_ = _e10036;
                                                                                }
                                                                                let _e10038 = phi_21146_;
                                                                                let _e10040 = phi_21147_;
                                                                                phi_21148_ = _e10038;
                                                                                phi_21149_ = _e10023;
                                                                                phi_21150_ = _e10040;
                                                                            } else {
                                                                                phi_21148_ = f32();
                                                                                phi_21149_ = true;
                                                                                phi_21150_ = false;
                                                                            }
                                                                            let _e10042 = phi_21148_;
                                                                            let _e10044 = phi_21149_;
                                                                            let _e10046 = phi_21150_;
                                                                            if _e10044 {
                                                                                phi_21154_ = 2f;
                                                                                phi_21155_ = true;
                                                                            } else {
                                                                                phi_21154_ = _e9326;
                                                                                phi_21155_ = _e10046;
                                                                            }
                                                                            let _e10048 = phi_21154_;
                                                                            let _e10050 = phi_21155_;
                                                                            if _e10050 {
                                                                                phi_21159_ = _e10048;
                                                                            } else {
                                                                                phi_21159_ = _e10042;
                                                                            }
                                                                            let _e10052 = phi_21159_;
                                                                            let _e10055 = local.member[3u];
                                                                            let _e10058 = local.member_1[3u];
                                                                            let _e10061 = local.member_2[3u];
                                                                            if (_e10055 > _e10061) {
                                                                                if (_e10058 > _e10061) {
                                                                                    phi_21191_ = false;
                                                                                } else {
                                                                                    phi_21191_ = true;
                                                                                }
                                                                                let _e10065 = phi_21191_;
                                                                                phi_21192_ = _e10065;
                                                                            } else {
                                                                                phi_21192_ = true;
                                                                            }
                                                                            let _e10067 = phi_21192_;
                                                                            if _e10067 {
                                                                                let _e10068 = (_e10058 >= _e10055);
                                                                                if _e10068 {
                                                                                    phi_21214_ = f32();
                                                                                    phi_21215_ = false;
                                                                                } else {
                                                                                    if ((_e10055 - _e10058) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                        phi_21212_ = (((_e10055 - _e10061) / (_e10055 - _e10058)) * (1f - (0.000000059604645f * 16f)));
                                                                                        phi_21213_ = false;
                                                                                    } else {
                                                                                        phi_21212_ = f32();
                                                                                        phi_21213_ = true;
                                                                                    }
                                                                                    let _e10079 = phi_21212_;
                                                                                    let _e10081 = phi_21213_;
                                                                                    phi_21214_ = _e10079;
                                                                                    phi_21215_ = _e10081;
                                                                                }
                                                                                let _e10083 = phi_21214_;
                                                                                let _e10085 = phi_21215_;
                                                                                phi_21216_ = _e10083;
                                                                                phi_21217_ = _e10068;
                                                                                phi_21218_ = _e10085;
                                                                            } else {
                                                                                phi_21216_ = f32();
                                                                                phi_21217_ = true;
                                                                                phi_21218_ = false;
                                                                            }
                                                                            let _e10087 = phi_21216_;
                                                                            let _e10089 = phi_21217_;
                                                                            let _e10091 = phi_21218_;
                                                                            if _e10089 {
                                                                                phi_21222_ = 2f;
                                                                                phi_21223_ = true;
                                                                            } else {
                                                                                phi_21222_ = _e9326;
                                                                                phi_21223_ = _e10091;
                                                                            }
                                                                            let _e10093 = phi_21222_;
                                                                            let _e10095 = phi_21223_;
                                                                            if _e10095 {
                                                                                phi_21227_ = _e10093;
                                                                            } else {
                                                                                phi_21227_ = _e10087;
                                                                            }
                                                                            let _e10097 = phi_21227_;
                                                                            if (_e10052 < _e10097) {
                                                                                phi_21232_ = _e10052;
                                                                            } else {
                                                                                phi_21232_ = _e10097;
                                                                            }
                                                                            let _e10100 = phi_21232_;
                                                                            if (_e10007 < _e10100) {
                                                                                phi_21237_ = _e10007;
                                                                            } else {
                                                                                phi_21237_ = _e10100;
                                                                            }
                                                                            let _e10103 = phi_21237_;
                                                                            if (_e10103 > _e9326) {
                                                                                phi_21242_ = _e10103;
                                                                            } else {
                                                                                phi_21242_ = _e9326;
                                                                            }
                                                                            let _e10106 = phi_21242_;
                                                                            let _e10107 = (_e10106 > _e8338.member_1);
                                                                            if _e10107 {
                                                                                phi_21747_ = f32();
                                                                                phi_21748_ = f32();
                                                                                phi_21749_ = false;
                                                                            } else {
                                                                                let _e10108 = (_e10106 - _e9326);
                                                                                if _e9334 {
                                                                                    if (_e10108 <= _e9321) {
                                                                                        phi_21737_ = true;
                                                                                    } else {
                                                                                        if (_e10108 <= (_e9330 * 0.25f)) {
                                                                                            phi_21736_ = false;
                                                                                        } else {
                                                                                            phi_21736_ = true;
                                                                                        }
                                                                                        let _e10114 = phi_21736_;
                                                                                        phi_21737_ = _e10114;
                                                                                    }
                                                                                    let _e10116 = phi_21737_;
                                                                                    if _e10116 {
                                                                                        phi_21742_ = (_e9654 + _e9654);
                                                                                    } else {
                                                                                        phi_21742_ = 0f;
                                                                                    }
                                                                                    let _e10119 = phi_21742_;
                                                                                    phi_21744_ = _e10119;
                                                                                } else {
                                                                                    phi_21744_ = (_e8338.member_1 - _e9326);
                                                                                }
                                                                                let _e10121 = phi_21744_;
                                                                                phi_21747_ = _e10121;
                                                                                phi_21748_ = _e10108;
                                                                                phi_21749_ = true;
                                                                            }
                                                                            let _e10123 = phi_21747_;
                                                                            let _e10125 = phi_21748_;
                                                                            let _e10127 = phi_21749_;
                                                                            phi_21751_ = _e10106;
                                                                            phi_21752_ = _e10123;
                                                                            phi_21753_ = _e10125;
                                                                            phi_21755_ = _e10127;
                                                                            phi_21756_ = _e10107;
                                                                            phi_21758_ = false;
                                                                        } else {
                                                                            phi_21751_ = f32();
                                                                            phi_21752_ = f32();
                                                                            phi_21753_ = f32();
                                                                            phi_21755_ = false;
                                                                            phi_21756_ = false;
                                                                            phi_21758_ = true;
                                                                        }
                                                                        let _e10129 = phi_21751_;
                                                                        let _e10131 = phi_21752_;
                                                                        let _e10133 = phi_21753_;
                                                                        let _e10135 = phi_21755_;
                                                                        let _e10137 = phi_21756_;
                                                                        let _e10139 = phi_21758_;
                                                                        phi_21759_ = _e10129;
                                                                        phi_21760_ = _e10131;
                                                                        phi_21761_ = _e10133;
                                                                        phi_21763_ = false;
                                                                        phi_21764_ = _e10135;
                                                                        phi_21765_ = _e10137;
                                                                        phi_21767_ = _e10139;
                                                                    } else {
                                                                        phi_21759_ = f32();
                                                                        phi_21760_ = f32();
                                                                        phi_21761_ = f32();
                                                                        phi_21763_ = true;
                                                                        phi_21764_ = false;
                                                                        phi_21765_ = false;
                                                                        phi_21767_ = false;
                                                                    }
                                                                    let _e10141 = phi_21759_;
                                                                    let _e10143 = phi_21760_;
                                                                    let _e10145 = phi_21761_;
                                                                    let _e10147 = phi_21763_;
                                                                    let _e10149 = phi_21764_;
                                                                    let _e10151 = phi_21765_;
                                                                    let _e10153 = phi_21767_;
                                                                    phi_21768_ = _e10141;
                                                                    phi_21769_ = _e10143;
                                                                    phi_21770_ = _e10145;
                                                                    phi_21772_ = _e10147;
                                                                    phi_21773_ = _e10149;
                                                                    phi_21774_ = _e10151;
                                                                    phi_21776_ = _e10153;
                                                                } else {
                                                                    phi_21768_ = f32();
                                                                    phi_21769_ = f32();
                                                                    phi_21770_ = f32();
                                                                    phi_21772_ = true;
                                                                    phi_21773_ = false;
                                                                    phi_21774_ = false;
                                                                    phi_21776_ = false;
                                                                }
                                                                let _e10155 = phi_21768_;
                                                                let _e10157 = phi_21769_;
                                                                let _e10159 = phi_21770_;
                                                                let _e10161 = phi_21772_;
                                                                let _e10163 = phi_21773_;
                                                                let _e10165 = phi_21774_;
                                                                let _e10167 = phi_21776_;
                                                                if _e10161 {
                                                                    if (_e9326 <= _e9328) {
                                                                        let _e10328 = (_e9336 + 1u);
                                                                        let _e10329 = (_e10328 > 3u);
                                                                        if _e10329 {
                                                                            phi_21789_ = false;
                                                                        } else {
                                                                            phi_21789_ = true;
                                                                        }
                                                                        let _e10331 = phi_21789_;
                                                                        phi_22111_ = _e10328;
                                                                        phi_22112_ = f32();
                                                                        phi_22113_ = false;
                                                                        phi_22114_ = _e10331;
                                                                        phi_22115_ = _e10329;
                                                                    } else {
                                                                        let _e10171 = local.member[0u];
                                                                        let _e10174 = local.member_1[0u];
                                                                        let _e10177 = local.member[0u];
                                                                        let _e10183 = local.member_2[0u];
                                                                        let _e10184 = ((_e10171 + ((_e10174 - _e10177) * _e9332)) - _e10183);
                                                                        let _e10187 = local.member[1u];
                                                                        let _e10190 = local.member_1[1u];
                                                                        let _e10193 = local.member[1u];
                                                                        let _e10199 = local.member_2[1u];
                                                                        let _e10200 = ((_e10187 + ((_e10190 - _e10193) * _e9332)) - _e10199);
                                                                        if (_e10184 < _e10200) {
                                                                            phi_21862_ = _e10184;
                                                                        } else {
                                                                            phi_21862_ = _e10200;
                                                                        }
                                                                        let _e10203 = phi_21862_;
                                                                        let _e10206 = local.member[2u];
                                                                        let _e10209 = local.member_1[2u];
                                                                        let _e10212 = local.member[2u];
                                                                        let _e10218 = local.member_2[2u];
                                                                        let _e10219 = ((_e10206 + ((_e10209 - _e10212) * _e9332)) - _e10218);
                                                                        let _e10222 = local.member[3u];
                                                                        let _e10225 = local.member_1[3u];
                                                                        let _e10228 = local.member[3u];
                                                                        let _e10234 = local.member_2[3u];
                                                                        let _e10235 = ((_e10222 + ((_e10225 - _e10228) * _e9332)) - _e10234);
                                                                        if (_e10219 < _e10235) {
                                                                            phi_21935_ = _e10219;
                                                                        } else {
                                                                            phi_21935_ = _e10235;
                                                                        }
                                                                        let _e10238 = phi_21935_;
                                                                        if (_e10203 < _e10238) {
                                                                            phi_21940_ = _e10203;
                                                                        } else {
                                                                            phi_21940_ = _e10238;
                                                                        }
                                                                        let _e10241 = phi_21940_;
                                                                        let _e10244 = local_1.member[0u];
                                                                        let _e10247 = local_1.member_1[0u];
                                                                        let _e10250 = local_1.member[0u];
                                                                        let _e10256 = local_1.member_2[0u];
                                                                        let _e10257 = ((_e10244 + ((_e10247 - _e10250) * _e9326)) - _e10256);
                                                                        let _e10260 = local_1.member[1u];
                                                                        let _e10263 = local_1.member_1[1u];
                                                                        let _e10266 = local_1.member[1u];
                                                                        let _e10272 = local_1.member_2[1u];
                                                                        let _e10273 = ((_e10260 + ((_e10263 - _e10266) * _e9326)) - _e10272);
                                                                        if (_e10257 < _e10273) {
                                                                            phi_22013_ = _e10257;
                                                                        } else {
                                                                            phi_22013_ = _e10273;
                                                                        }
                                                                        let _e10276 = phi_22013_;
                                                                        let _e10279 = local_1.member[2u];
                                                                        let _e10282 = local_1.member_1[2u];
                                                                        let _e10285 = local_1.member[2u];
                                                                        let _e10291 = local_1.member_2[2u];
                                                                        let _e10292 = ((_e10279 + ((_e10282 - _e10285) * _e9326)) - _e10291);
                                                                        let _e10295 = local_1.member[3u];
                                                                        let _e10298 = local_1.member_1[3u];
                                                                        let _e10301 = local_1.member[3u];
                                                                        let _e10307 = local_1.member_2[3u];
                                                                        let _e10308 = ((_e10295 + ((_e10298 - _e10301) * _e9326)) - _e10307);
                                                                        if (_e10292 < _e10308) {
                                                                            phi_22086_ = _e10292;
                                                                        } else {
                                                                            phi_22086_ = _e10308;
                                                                        }
                                                                        let _e10311 = phi_22086_;
                                                                        if (_e10276 < _e10311) {
                                                                            phi_22091_ = _e10276;
                                                                        } else {
                                                                            phi_22091_ = _e10311;
                                                                        }
                                                                        let _e10314 = phi_22091_;
                                                                        if (_e10314 > 0f) {
                                                                            phi_22109_ = 0.5f;
                                                                        } else {
                                                                            let _e10318 = (0.95f * (_e10241 / (_e10241 - _e10314)));
                                                                            if (_e10318 > 0.0625f) {
                                                                                if (_e10318 < 0.9f) {
                                                                                    phi_22107_ = _e10318;
                                                                                } else {
                                                                                    phi_22107_ = 0.9f;
                                                                                }
                                                                                let _e10322 = phi_22107_;
                                                                                phi_22108_ = _e10322;
                                                                            } else {
                                                                                phi_22108_ = 0.0625f;
                                                                            }
                                                                            let _e10324 = phi_22108_;
                                                                            phi_22109_ = _e10324;
                                                                        }
                                                                        let _e10326 = phi_22109_;
                                                                        phi_22111_ = u32();
                                                                        phi_22112_ = (_e9654 * _e10326);
                                                                        phi_22113_ = true;
                                                                        phi_22114_ = false;
                                                                        phi_22115_ = false;
                                                                    }
                                                                    let _e10333 = phi_22111_;
                                                                    let _e10335 = phi_22112_;
                                                                    let _e10337 = phi_22113_;
                                                                    let _e10339 = phi_22114_;
                                                                    let _e10341 = phi_22115_;
                                                                    phi_22116_ = _e10333;
                                                                    phi_22117_ = _e9328;
                                                                    phi_22118_ = _e10335;
                                                                    phi_22119_ = _e9330;
                                                                    phi_22120_ = _e9332;
                                                                    phi_22121_ = _e9334;
                                                                    phi_22122_ = _e9336;
                                                                    phi_22123_ = _e10337;
                                                                    phi_22124_ = _e10339;
                                                                    phi_22125_ = _e10341;
                                                                    phi_22126_ = false;
                                                                    phi_22128_ = false;
                                                                } else {
                                                                    phi_22116_ = u32();
                                                                    phi_22117_ = _e10155;
                                                                    phi_22118_ = _e10157;
                                                                    phi_22119_ = _e10159;
                                                                    phi_22120_ = _e9326;
                                                                    phi_22121_ = true;
                                                                    phi_22122_ = 0u;
                                                                    phi_22123_ = _e10163;
                                                                    phi_22124_ = false;
                                                                    phi_22125_ = false;
                                                                    phi_22126_ = _e10165;
                                                                    phi_22128_ = _e10167;
                                                                }
                                                                let _e10343 = phi_22116_;
                                                                let _e10345 = phi_22117_;
                                                                let _e10347 = phi_22118_;
                                                                let _e10349 = phi_22119_;
                                                                let _e10351 = phi_22120_;
                                                                let _e10353 = phi_22121_;
                                                                let _e10355 = phi_22122_;
                                                                let _e10357 = phi_22123_;
                                                                let _e10359 = phi_22124_;
                                                                let _e10361 = phi_22125_;
                                                                let _e10363 = phi_22126_;
                                                                let _e10365 = phi_22128_;
                                                                if _e10357 {
                                                                    let _e10366 = (_e10351 + _e10347);
                                                                    if (_e10366 > _e10345) {
                                                                        phi_22137_ = _e10366;
                                                                    } else {
                                                                        phi_22137_ = _e10345;
                                                                    }
                                                                    let _e10369 = phi_22137_;
                                                                    if (_e10369 < _e8338.member_1) {
                                                                        phi_22142_ = _e10369;
                                                                    } else {
                                                                        phi_22142_ = _e8338.member_1;
                                                                    }
                                                                    let _e10372 = phi_22142_;
                                                                    if !(_e9334) {
                                                                        phi_22151_ = true;
                                                                    } else {
                                                                        phi_22151_ = ((_e10372 - _e10351) > _e9321);
                                                                    }
                                                                    let _e10376 = phi_22151_;
                                                                    if _e10376 {
                                                                        phi_22155_ = false;
                                                                    } else {
                                                                        phi_22155_ = true;
                                                                    }
                                                                    let _e10378 = phi_22155_;
                                                                    phi_22156_ = _e10372;
                                                                    phi_22157_ = _e10345;
                                                                    phi_22158_ = _e10349;
                                                                    phi_22159_ = _e10351;
                                                                    phi_22160_ = _e10353;
                                                                    phi_22161_ = _e10355;
                                                                    phi_22162_ = _e10376;
                                                                    phi_22163_ = _e10378;
                                                                    phi_22164_ = false;
                                                                    phi_22165_ = false;
                                                                    phi_22167_ = false;
                                                                } else {
                                                                    phi_22156_ = _e9326;
                                                                    phi_22157_ = _e9328;
                                                                    phi_22158_ = _e9330;
                                                                    phi_22159_ = _e9332;
                                                                    phi_22160_ = _e9334;
                                                                    phi_22161_ = _e10343;
                                                                    phi_22162_ = _e10359;
                                                                    phi_22163_ = false;
                                                                    phi_22164_ = _e10361;
                                                                    phi_22165_ = _e10363;
                                                                    phi_22167_ = _e10365;
                                                                }
                                                                let _e10380 = phi_22156_;
                                                                let _e10382 = phi_22157_;
                                                                let _e10384 = phi_22158_;
                                                                let _e10386 = phi_22159_;
                                                                let _e10388 = phi_22160_;
                                                                let _e10390 = phi_22161_;
                                                                let _e10392 = phi_22162_;
                                                                let _e10394 = phi_22163_;
                                                                let _e10396 = phi_22164_;
                                                                let _e10398 = phi_22165_;
                                                                let _e10400 = phi_22167_;
                                                                phi_19989_ = _e10380;
                                                                phi_19991_ = _e10382;
                                                                phi_19993_ = _e10384;
                                                                phi_19995_ = _e10386;
                                                                phi_19997_ = _e10388;
                                                                phi_19999_ = _e10390;
                                                                phi_22168_ = _e10345;
                                                                phi_22170_ = _e10392;
                                                                phi_22171_ = _e10394;
                                                                phi_22172_ = _e10396;
                                                                phi_22173_ = _e10398;
                                                                phi_22175_ = false;
                                                                phi_22176_ = _e10400;
                                                            } else {
                                                                phi_19989_ = f32();
                                                                phi_19991_ = f32();
                                                                phi_19993_ = f32();
                                                                phi_19995_ = f32();
                                                                phi_19997_ = bool();
                                                                phi_19999_ = u32();
                                                                phi_22168_ = f32();
                                                                phi_22170_ = false;
                                                                phi_22171_ = false;
                                                                phi_22172_ = false;
                                                                phi_22173_ = false;
                                                                phi_22175_ = true;
                                                                phi_22176_ = false;
                                                            }
                                                            let _e10402 = phi_19989_;
                                                            let _e10404 = phi_19991_;
                                                            let _e10406 = phi_19993_;
                                                            let _e10408 = phi_19995_;
                                                            let _e10410 = phi_19997_;
                                                            let _e10412 = phi_19999_;
                                                            let _e10414 = phi_22168_;
                                                            let _e10416 = phi_22170_;
                                                            let _e10418 = phi_22171_;
                                                            let _e10420 = phi_22172_;
                                                            let _e10422 = phi_22173_;
                                                            let _e10424 = phi_22175_;
                                                            let _e10426 = phi_22176_;
                                                            local_95 = _e10418;
                                                            local_140 = _e10420;
                                                            local_141 = _e10422;
                                                            local_142 = _e10424;
                                                            local_143 = _e10426;
                                                            local_144 = _e10418;
                                                            local_145 = _e10414;
                                                            continue;
                                                            continuing {
                                                                phi_19985_ = _e9348;
                                                                phi_19988_ = _e10402;
                                                                phi_19990_ = _e10404;
                                                                phi_19992_ = _e10406;
                                                                phi_19994_ = _e10408;
                                                                phi_19996_ = _e10410;
                                                                phi_19998_ = _e10412;
                                                                break if !(_e10416);
                                                            }
                                                        }
                                                        let _e10429 = local_95;
                                                        if _e10429 {
                                                            phi_22180_ = false;
                                                            phi_22181_ = false;
                                                            phi_22183_ = false;
                                                            phi_22184_ = false;
                                                        } else {
                                                            let _e16610 = local_140;
                                                            phi_22180_ = _e16610;
                                                            let _e16613 = local_141;
                                                            phi_22181_ = _e16613;
                                                            let _e16616 = local_142;
                                                            phi_22183_ = _e16616;
                                                            let _e16619 = local_143;
                                                            phi_22184_ = _e16619;
                                                        }
                                                        let _e10431 = phi_22180_;
                                                        let _e10433 = phi_22181_;
                                                        let _e10435 = phi_22183_;
                                                        let _e10437 = phi_22184_;
                                                        if _e10431 {
                                                            let _e10439 = local_96;
                                                            phi_22189_ = type_45(1u, _e10439);
                                                            phi_22190_ = false;
                                                            phi_22192_ = false;
                                                            phi_22193_ = false;
                                                            phi_22194_ = false;
                                                        } else {
                                                            phi_22189_ = type_45();
                                                            phi_22190_ = _e10433;
                                                            let _e16625 = local_144;
                                                            phi_22192_ = _e16625;
                                                            phi_22193_ = _e10435;
                                                            phi_22194_ = _e10437;
                                                        }
                                                        let _e10442 = phi_22189_;
                                                        let _e10444 = phi_22190_;
                                                        let _e10446 = phi_22192_;
                                                        let _e10448 = phi_22193_;
                                                        let _e10450 = phi_22194_;
                                                        if _e10444 {
                                                            phi_22199_ = type_45(0u, type_45().member_1);
                                                            phi_22201_ = false;
                                                            phi_22202_ = false;
                                                            phi_22203_ = false;
                                                            phi_22204_ = true;
                                                        } else {
                                                            phi_22199_ = _e10442;
                                                            phi_22201_ = _e10446;
                                                            phi_22202_ = _e10448;
                                                            phi_22203_ = _e10450;
                                                            phi_22204_ = _e10431;
                                                        }
                                                        let _e10454 = phi_22199_;
                                                        let _e10456 = phi_22201_;
                                                        let _e10458 = phi_22202_;
                                                        let _e10460 = phi_22203_;
                                                        let _e10462 = phi_22204_;
                                                        if _e10456 {
                                                            let _e16635 = local_145;
                                                            phi_22216_ = _e16635;
                                                            phi_22217_ = true;
                                                            phi_22218_ = false;
                                                            phi_22219_ = false;
                                                        } else {
                                                            let _e16637 = local_146;
                                                            phi_22216_ = _e16637;
                                                            phi_22217_ = _e10458;
                                                            phi_22218_ = _e10460;
                                                            phi_22219_ = _e10462;
                                                        }
                                                        let _e10464 = phi_22216_;
                                                        let _e10466 = phi_22217_;
                                                        let _e10468 = phi_22218_;
                                                        let _e10470 = phi_22219_;
                                                        if _e10466 {
                                                            phi_22224_ = type_45(1u, _e10464);
                                                            phi_22225_ = false;
                                                            phi_22226_ = false;
                                                        } else {
                                                            phi_22224_ = type_45();
                                                            phi_22225_ = _e10468;
                                                            phi_22226_ = _e10470;
                                                        }
                                                        let _e10473 = phi_22224_;
                                                        let _e10475 = phi_22225_;
                                                        let _e10477 = phi_22226_;
                                                        if _e10475 {
                                                            phi_22231_ = type_45(0u, type_45().member_1);
                                                            phi_22232_ = true;
                                                        } else {
                                                            phi_22231_ = _e10454;
                                                            phi_22232_ = _e10477;
                                                        }
                                                        let _e10481 = phi_22231_;
                                                        let _e10483 = phi_22232_;
                                                        if _e10483 {
                                                            phi_22236_ = _e10481;
                                                        } else {
                                                            phi_22236_ = _e10473;
                                                        }
                                                        let _e10485 = phi_22236_;
                                                        let _e10488 = (_e10485.member != 0u);
                                                        if _e10488 {
                                                            phi_22243_ = false;
                                                        } else {
                                                            phi_22243_ = true;
                                                        }
                                                        let _e10490 = phi_22243_;
                                                        phi_22244_ = _e10485.member_1;
                                                        phi_22245_ = _e10490;
                                                        phi_22246_ = _e10488;
                                                        phi_22247_ = false;
                                                    } else {
                                                        phi_22244_ = f32();
                                                        phi_22245_ = false;
                                                        phi_22246_ = false;
                                                        phi_22247_ = true;
                                                    }
                                                    let _e10492 = phi_22244_;
                                                    let _e10494 = phi_22245_;
                                                    let _e10496 = phi_22246_;
                                                    let _e10498 = phi_22247_;
                                                    phi_22248_ = _e9073;
                                                    phi_22249_ = _e9074;
                                                    phi_22250_ = _e10492;
                                                    phi_22251_ = _e10494;
                                                    phi_22252_ = _e10496;
                                                    phi_22253_ = _e10498;
                                                }
                                                let _e10500 = phi_22248_;
                                                let _e10502 = phi_22249_;
                                                let _e10504 = phi_22250_;
                                                let _e10506 = phi_22251_;
                                                let _e10508 = phi_22252_;
                                                let _e10510 = phi_22253_;
                                                phi_22254_ = _e10500;
                                                phi_22255_ = _e10502;
                                                phi_22256_ = _e10504;
                                                phi_22257_ = _e9069;
                                                phi_22258_ = _e10506;
                                                phi_22259_ = _e10508;
                                                phi_22260_ = _e10510;
                                            }
                                            let _e10512 = phi_22254_;
                                            let _e10514 = phi_22255_;
                                            let _e10516 = phi_22256_;
                                            let _e10518 = phi_22257_;
                                            let _e10520 = phi_22258_;
                                            let _e10522 = phi_22259_;
                                            let _e10524 = phi_22260_;
                                            if _e10518 {
                                                phi_22264_ = false;
                                                phi_22265_ = false;
                                                phi_22266_ = false;
                                            } else {
                                                phi_22264_ = _e10520;
                                                phi_22265_ = _e10522;
                                                phi_22266_ = _e10524;
                                            }
                                            let _e10526 = phi_22264_;
                                            let _e10528 = phi_22265_;
                                            let _e10530 = phi_22266_;
                                            phi_22267_ = _e8338;
                                            phi_22268_ = _e10512;
                                            phi_22269_ = _e10514;
                                            phi_22270_ = _e10516;
                                            phi_22271_ = _e8338;
                                            phi_22272_ = _e10518;
                                            phi_22273_ = _e10526;
                                            phi_22274_ = _e10528;
                                            phi_22275_ = _e10530;
                                        } else {
                                            phi_22267_ = type_48();
                                            phi_22268_ = bool();
                                            phi_22269_ = f32();
                                            phi_22270_ = f32();
                                            phi_22271_ = type_48();
                                            phi_22272_ = true;
                                            phi_22273_ = false;
                                            phi_22274_ = false;
                                            phi_22275_ = false;
                                        }
                                        let _e10532 = phi_22267_;
                                        let _e10534 = phi_22268_;
                                        let _e10536 = phi_22269_;
                                        let _e10538 = phi_22270_;
                                        let _e10540 = phi_22271_;
                                        let _e10542 = phi_22272_;
                                        let _e10544 = phi_22273_;
                                        let _e10546 = phi_22274_;
                                        let _e10548 = phi_22275_;
                                        if _e10542 {
                                            phi_22279_ = true;
                                            phi_22280_ = false;
                                            phi_22281_ = false;
                                        } else {
                                            phi_22279_ = _e10544;
                                            phi_22280_ = _e10546;
                                            phi_22281_ = _e10548;
                                        }
                                        let _e10550 = phi_22279_;
                                        let _e10552 = phi_22280_;
                                        let _e10554 = phi_22281_;
                                        phi_22282_ = _e10532;
                                        phi_22283_ = _e10534;
                                        phi_22284_ = _e10536;
                                        phi_22285_ = _e10538;
                                        phi_22286_ = _e10540;
                                        phi_22287_ = _e10550;
                                        phi_22288_ = false;
                                        phi_22289_ = _e10552;
                                        phi_22290_ = _e10554;
                                    } else {
                                        phi_22282_ = type_48();
                                        phi_22283_ = bool();
                                        phi_22284_ = f32();
                                        phi_22285_ = f32();
                                        phi_22286_ = type_48();
                                        phi_22287_ = false;
                                        phi_22288_ = true;
                                        phi_22289_ = false;
                                        phi_22290_ = false;
                                    }
                                    let _e10556 = phi_22282_;
                                    let _e10558 = phi_22283_;
                                    let _e10560 = phi_22284_;
                                    let _e10562 = phi_22285_;
                                    let _e10564 = phi_22286_;
                                    let _e10566 = phi_22287_;
                                    let _e10568 = phi_22288_;
                                    let _e10570 = phi_22289_;
                                    let _e10572 = phi_22290_;
                                    local_97 = _e10568;
                                    local_147 = _e10570;
                                    local_148 = _e10572;
                                    local_98 = _e10558;
                                    local_99 = _e10556;
                                    local_100 = _e10562;
                                    local_101 = _e10560;
                                    local_102 = _e10562;
                                    local_103 = _e10562;
                                    local_104 = _e10564;
                                    continue;
                                    continuing {
                                        phi_18093_ = _e8061;
                                        break if !(_e10566);
                                    }
                                }
                                let _e10575 = local_97;
                                if _e10575 {
                                    phi_22295_ = type_45(0u, type_45().member_1);
                                    phi_22296_ = false;
                                    phi_22297_ = false;
                                } else {
                                    phi_22295_ = type_45();
                                    let _e16693 = local_147;
                                    phi_22296_ = _e16693;
                                    let _e16696 = local_148;
                                    phi_22297_ = _e16696;
                                }
                                let _e10579 = phi_22295_;
                                let _e10581 = phi_22296_;
                                let _e10583 = phi_22297_;
                                if _e10581 {
                                    let _e10585 = local_98;
                                    if _e10585 {
                                        let _e10587 = local_99;
                                        let _e10590 = local_100;
                                        let _e10593 = local_101;
                                        if ((_e10587.member_1 - _e10590) <= _e10593) {
                                            let _e10596 = local_102;
                                            phi_22311_ = type_45(1u, _e10596);
                                            phi_22312_ = false;
                                        } else {
                                            phi_22311_ = type_45();
                                            phi_22312_ = true;
                                        }
                                        let _e10599 = phi_22311_;
                                        let _e10601 = phi_22312_;
                                        phi_22313_ = _e10599;
                                        phi_22314_ = _e10601;
                                    } else {
                                        phi_22313_ = type_45();
                                        phi_22314_ = true;
                                    }
                                    let _e10603 = phi_22313_;
                                    let _e10605 = phi_22314_;
                                    if _e10605 {
                                        let _e10607 = local_103;
                                        phi_22319_ = type_45(2u, _e10607);
                                    } else {
                                        phi_22319_ = _e10603;
                                    }
                                    let _e10610 = phi_22319_;
                                    phi_22320_ = _e10610;
                                    phi_22321_ = false;
                                } else {
                                    phi_22320_ = type_45();
                                    phi_22321_ = _e10583;
                                }
                                let _e10612 = phi_22320_;
                                let _e10614 = phi_22321_;
                                if _e10614 {
                                    let _e10616 = local_104;
                                    phi_22327_ = type_45(1u, _e10616.member);
                                    phi_22328_ = true;
                                } else {
                                    phi_22327_ = _e10612;
                                    phi_22328_ = _e10581;
                                }
                                let _e10620 = phi_22327_;
                                let _e10622 = phi_22328_;
                                phi_22332_ = _e10620;
                                phi_22333_ = _e10579;
                                phi_22334_ = _e10622;
                            } else {
                                phi_22332_ = _e7907;
                                phi_22333_ = type_45();
                                phi_22334_ = true;
                            }
                            let _e10624 = phi_22332_;
                            let _e10626 = phi_22333_;
                            let _e10628 = phi_22334_;
                            phi_22338_ = _e10624;
                            phi_22339_ = _e10626;
                            phi_22340_ = _e10628;
                        }
                        let _e10632 = phi_22338_;
                        let _e10634 = phi_22339_;
                        let _e10636 = phi_22340_;
                        if _e10636 {
                            phi_22344_ = _e10632;
                        } else {
                            phi_22344_ = _e10634;
                        }
                        let _e10638 = phi_22344_;
                        if (_e10638.member == 1u) {
                            if (_e10638.member_1 > _e5621) {
                                phi_22355_ = false;
                            } else {
                                phi_22355_ = true;
                            }
                            let _e10644 = phi_22355_;
                            phi_22356_ = _e10644;
                        } else {
                            phi_22356_ = true;
                        }
                        let _e10646 = phi_22356_;
                        if _e10646 {
                            phi_22360_ = false;
                        } else {
                            phi_22360_ = true;
                        }
                        let _e10648 = phi_22360_;
                        if _e10648 {
                            phi_22364_ = 1u;
                        } else {
                            phi_22364_ = 0u;
                        }
                        let _e10650 = phi_22364_;
                        phi_22368_ = type_46(_e10638, _e10650);
                    }
                    let _e15190 = phi_22368_;
                    switch bitcast<i32>(_e15190.member.member) {
                        case 0: {
                            phi_22386_ = type_29(0u, _e15190.member_1, array<u32, 2>(0u, 0u), false);
                            break;
                        }
                        case 1: {
                            let _e15201 = function_1(_e15190.member.member_1);
                            phi_22386_ = type_29(0u, _e15190.member_1, _e15201, true);
                            break;
                        }
                        case 2: {
                            let _e15197 = function_1(_e15190.member.member_1);
                            phi_22386_ = type_29(1u, _e15190.member_1, _e15197, true);
                            break;
                        }
                        default: {
                            phi_22386_ = type_29();
                            break;
                        }
                    }
                    let _e15205 = phi_22386_;
                    let _e15209 = params.member.member.member_12;
                    let _e15210 = bitcast<u32>(_e15209);
                    let _e15211 = (_e15210 & 2147483647u);
                    if (_e15211 < 8388608u) {
                        phi_22402_ = array<u32, 2>(0u, 0u);
                    } else {
                        phi_22402_ = array<u32, 2>((_e15210 << bitcast<u32>(29i)), ((_e15210 ^ _e15211) | ((_e15211 >> bitcast<u32>(3i)) + 939524096u)));
                    }
                    let _e15222 = phi_22402_;
                    if (_e15205.member_2[0] == _e15222[0]) {
                        let _e15228 = params.member.member.member_12;
                        let _e15229 = bitcast<u32>(_e15228);
                        let _e15230 = (_e15229 & 2147483647u);
                        if (_e15230 < 8388608u) {
                            phi_22423_ = array<u32, 2>(0u, 0u);
                        } else {
                            phi_22423_ = array<u32, 2>((_e15229 << bitcast<u32>(29i)), ((_e15229 ^ _e15230) | ((_e15230 >> bitcast<u32>(3i)) + 939524096u)));
                        }
                        let _e15241 = phi_22423_;
                        phi_22426_ = (_e15205.member_2[1] == _e15241[1]);
                    } else {
                        phi_22426_ = false;
                    }
                    let _e15245 = phi_22426_;
                    let _e15247 = params.member.member.member_1;
                    if ((_e15247 & 128u) != 0u) {
                        phi_22442_ = true;
                    } else {
                        let _e15251 = params.member.member.member_1;
                        if ((_e15251 & 64u) != 0u) {
                            phi_22441_ = _e15245;
                        } else {
                            phi_22441_ = false;
                        }
                        let _e15255 = phi_22441_;
                        phi_22442_ = _e15255;
                    }
                    let _e15257 = phi_22442_;
                    if _e15205.member_3 {
                        if _e15257 {
                            phi_22450_ = false;
                        } else {
                            phi_22450_ = true;
                        }
                        let _e15260 = phi_22450_;
                        phi_22451_ = _e15260;
                    } else {
                        phi_22451_ = true;
                    }
                    let _e15262 = phi_22451_;
                    if _e15262 {
                        phi_22456_ = _e15205.member;
                    } else {
                        phi_22456_ = 1u;
                    }
                    let _e15265 = phi_22456_;
                    phi_22461_ = type_29(_e15265, _e15205.member_1, _e15205.member_2, _e15205.member_3);
                } else {
                    phi_22461_ = _e5586;
                }
                let _e15271 = phi_22461_;
                if _e15271.member_3 {
                    phi_22468_ = (_e15271.member == 0u);
                } else {
                    phi_22468_ = false;
                }
                let _e15276 = phi_22468_;
                if _e15276 {
                    let _e15285 = (_e15271.member_2[1] >> bitcast<u32>(20i));
                    if (_e15285 <= 896u) {
                        phi_22493_ = 0u;
                    } else {
                        phi_22493_ = ((((_e15285 - 896u) << bitcast<u32>(23i)) | ((_e15271.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e15271.member_2[0] >> bitcast<u32>(29i)));
                    }
                    let _e15300 = phi_22493_;
                    let _e15302 = atomicMin((&earliest.member[0u]), _e15300);
                }
                phi_22497_ = type_18(_e270, 0u, _e280, _e283, _e15271.member_2, _e15271.member_1);
                phi_22498_ = _e15276;
                phi_22499_ = (_e15271.member != 0u);
            } else {
                phi_22497_ = type_18(_e270, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_22498_ = false;
                phi_22499_ = false;
            }
            let _e15304 = phi_22497_;
            let _e15306 = phi_22498_;
            let _e15308 = phi_22499_;
            let _e15311 = params.member.member.member_1;
            if ((_e15311 & 16u) != 0u) {
                if (_e186 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e15306 {
                    let _e15317 = atomicAdd((&counters[0u]), 1u);
                    phi_22518_ = _e15317;
                } else {
                    phi_22518_ = 0u;
                }
                let _e15319 = phi_22518_;
                workgroupBarrier();
                if (_e186 == 0u) {
                    let _e15322 = atomicLoad((&counters[0u]));
                    if (_e15322 > 0u) {
                        let _e15325 = atomicAdd((&contacts.member[0u]), _e15322);
                        atomicStore((&counters[1u]), _e15325);
                    }
                }
                workgroupBarrier();
                let _e15328 = atomicLoad((&counters[1u]));
                let _e15329 = (_e15328 + _e15319);
                if _e15306 {
                    let _e15332 = params.member.member_1.member_3;
                    if (_e15329 < _e15332) {
                        let _e15334 = (7u * _e15329);
                        atomicStore((&contacts.member[(4u + _e15334)]), _e15304.member);
                        atomicStore((&contacts.member[(_e15334 + 5u)]), _e15304.member_1);
                        atomicStore((&contacts.member[(_e15334 + 6u)]), _e15304.member_2);
                        atomicStore((&contacts.member[(_e15334 + 7u)]), _e15304.member_3);
                        atomicStore((&contacts.member[(_e15334 + 8u)]), _e15304.member_4[0]);
                        atomicStore((&contacts.member[(_e15334 + 9u)]), _e15304.member_4[1]);
                        atomicStore((&contacts.member[(_e15334 + 10u)]), _e15304.member_5);
                    }
                }
            }
            workgroupBarrier();
            if (_e186 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e15308 {
                let _e15361 = atomicAdd((&counters[0u]), 1u);
                phi_22585_ = _e15361;
            } else {
                phi_22585_ = 0u;
            }
            let _e15363 = phi_22585_;
            workgroupBarrier();
            if (_e186 == 0u) {
                let _e15366 = atomicLoad((&counters[0u]));
                if (_e15366 > 0u) {
                    let _e15369 = atomicAdd((&undecided.member[0u]), _e15366);
                    atomicStore((&counters[1u]), _e15369);
                }
            }
            workgroupBarrier();
            let _e15372 = atomicLoad((&counters[1u]));
            let _e15373 = (_e15372 + _e15363);
            if _e15308 {
                let _e15379 = params.member.member_2.member.member_1;
                if (_e15373 < _e15379) {
                    let _e15381 = (2u * _e15373);
                    atomicStore((&undecided.member[(4u + _e15381)]), _e15304.member_2);
                    atomicStore((&undecided.member[(_e15381 + 5u)]), _e15304.member_3);
                }
            }
        }
        continue;
        continuing {
            phi_438_ = _e256;
            break if !(_e262);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_14(id, n, lane);
}
