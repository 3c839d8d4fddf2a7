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
    var phi_23661_: array<u32, 2>;

    let _e7 = bitcast<u32>(param);
    let _e8 = (_e7 & 2147483647u);
    if (_e8 < 8388608u) {
        phi_23661_ = array<u32, 2>(0u, 0u);
    } else {
        phi_23661_ = array<u32, 2>((_e7 << bitcast<u32>(29i)), ((_e7 ^ _e8) | ((_e8 >> bitcast<u32>(3i)) + 939524096u)));
    }
    let _e19 = phi_23661_;
    return _e19;
}

fn function_1(param_1: array<f32, 3>, param_2: array<f32, 3>) -> array<f32, 3> {
    var phi_23646_: array<f32, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_23646_ = param_2;
    } else {
        phi_23646_ = param_1;
    }
    let _e26 = phi_23646_;
    return _e26;
}

fn function_2(param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: array<f32, 3>, param_6: u32) -> array<f32, 3> {
    var phi_23507_: f32;
    var phi_23508_: f32;
    var phi_23547_: f32;
    var phi_23548_: f32;
    var phi_23593_: f32;
    var phi_23594_: f32;
    var phi_23328_: f32;
    var phi_23329_: f32;
    var phi_23374_: f32;
    var phi_23375_: f32;
    var phi_23417_: f32;
    var phi_23418_: f32;
    var phi_23466_: f32;
    var phi_23467_: f32;
    var phi_23609_: array<array<f32, 3>, 4>;

    let _e9 = (param_3[0] - param_4[0]);
    let _e12 = (param_3[1] - param_4[1]);
    let _e15 = (param_3[2] - param_4[2]);
    if (param_6 != 0u) {
        let _e157 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e157 > 0f) {
            if (_e157 < 1f) {
                phi_23328_ = _e157;
            } else {
                phi_23328_ = 1f;
            }
            let _e161 = phi_23328_;
            phi_23329_ = _e161;
        } else {
            phi_23329_ = 0f;
        }
        let _e163 = phi_23329_;
        let _e199 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e199 > 0f) {
            if (_e199 < 1f) {
                phi_23374_ = _e199;
            } else {
                phi_23374_ = 1f;
            }
            let _e203 = phi_23374_;
            phi_23375_ = _e203;
        } else {
            phi_23375_ = 0f;
        }
        let _e205 = phi_23375_;
        let _e238 = ((((_e9 * param_5[0]) + (_e12 * param_5[1])) + (_e15 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e238 > 0f) {
            if (_e238 < 1f) {
                phi_23417_ = _e238;
            } else {
                phi_23417_ = 1f;
            }
            let _e242 = phi_23417_;
            phi_23418_ = _e242;
        } else {
            phi_23418_ = 0f;
        }
        let _e244 = phi_23418_;
        let _e257 = (param_3[0] - param_5[0]);
        let _e260 = (param_3[1] - param_5[1]);
        let _e263 = (param_3[2] - param_5[2]);
        let _e283 = ((((_e257 * param_4[0]) + (_e260 * param_4[1])) + (_e263 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e283 > 0f) {
            if (_e283 < 1f) {
                phi_23466_ = _e283;
            } else {
                phi_23466_ = 1f;
            }
            let _e287 = phi_23466_;
            phi_23467_ = _e287;
        } else {
            phi_23467_ = 0f;
        }
        let _e289 = phi_23467_;
        phi_23609_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e163)), (param_3[1] - (param_4[1] * _e163)), (param_3[2] - (param_4[2] * _e163))), array<f32, 3>((param_3[0] - (param_5[0] * _e205)), (param_3[1] - (param_5[1] * _e205)), (param_3[2] - (param_5[2] * _e205))), array<f32, 3>((_e9 - (param_5[0] * _e244)), (_e12 - (param_5[1] * _e244)), (_e15 - (param_5[2] * _e244))), array<f32, 3>((_e257 - (param_4[0] * _e289)), (_e260 - (param_4[1] * _e289)), (_e263 - (param_4[2] * _e289))));
    } else {
        let _e19 = (param_5[0] - param_4[0]);
        let _e22 = (param_5[1] - param_4[1]);
        let _e25 = (param_5[2] - param_4[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        if (_e36 > 0f) {
            if (_e36 < 1f) {
                phi_23507_ = _e36;
            } else {
                phi_23507_ = 1f;
            }
            let _e40 = phi_23507_;
            phi_23508_ = _e40;
        } else {
            phi_23508_ = 0f;
        }
        let _e42 = phi_23508_;
        let _e49 = array<f32, 3>((_e9 - (_e19 * _e42)), (_e12 - (_e22 * _e42)), (_e15 - (_e25 * _e42)));
        let _e72 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e72 > 0f) {
            if (_e72 < 1f) {
                phi_23547_ = _e72;
            } else {
                phi_23547_ = 1f;
            }
            let _e76 = phi_23547_;
            phi_23548_ = _e76;
        } else {
            phi_23548_ = 0f;
        }
        let _e78 = phi_23548_;
        let _e114 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e114 > 0f) {
            if (_e114 < 1f) {
                phi_23593_ = _e114;
            } else {
                phi_23593_ = 1f;
            }
            let _e118 = phi_23593_;
            phi_23594_ = _e118;
        } else {
            phi_23594_ = 0f;
        }
        let _e120 = phi_23594_;
        phi_23609_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e78)), (param_3[1] - (param_4[1] * _e78)), (param_3[2] - (param_4[2] * _e78))), array<f32, 3>((param_3[0] - (param_5[0] * _e120)), (param_3[1] - (param_5[1] * _e120)), (param_3[2] - (param_5[2] * _e120))), _e49, _e49);
    }
    let _e302 = phi_23609_;
    let _e305 = function_1(_e302[0], _e302[1]);
    let _e307 = function_1(_e305, _e302[2]);
    let _e309 = function_1(_e307, _e302[3]);
    return _e309;
}

fn function_3(param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: array<f32, 3>, param_10: u32) -> array<f32, 3> {
    var phi_23229_: bool;
    var phi_23230_: bool;
    var phi_23231_: bool;
    var phi_23232_: bool;
    var phi_23236_: bool;
    var phi_23209_: bool;
    var phi_23210_: bool;
    var phi_23211_: bool;
    var phi_23212_: bool;
    var phi_23213_: bool;
    var phi_23214_: bool;
    var phi_23218_: bool;
    var phi_23237_: bool;
    var phi_23270_: array<f32, 3>;
    var phi_23271_: bool;
    var phi_23272_: array<f32, 3>;
    var phi_23273_: bool;
    var phi_23278_: array<f32, 3>;

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
                    phi_23209_ = (_e78 <= 1f);
                    phi_23210_ = false;
                } else {
                    phi_23209_ = bool();
                    phi_23210_ = true;
                }
                let _e99 = phi_23209_;
                let _e101 = phi_23210_;
                phi_23211_ = _e99;
                phi_23212_ = _e101;
            } else {
                phi_23211_ = bool();
                phi_23212_ = true;
            }
            let _e103 = phi_23211_;
            let _e105 = phi_23212_;
            phi_23213_ = _e103;
            phi_23214_ = _e105;
        } else {
            phi_23213_ = bool();
            phi_23214_ = true;
        }
        let _e107 = phi_23213_;
        let _e109 = phi_23214_;
        if _e109 {
            phi_23218_ = false;
        } else {
            phi_23218_ = _e107;
        }
        let _e111 = phi_23218_;
        phi_23237_ = _e111;
    } else {
        if (_e74 >= 0f) {
            if (_e78 >= 0f) {
                phi_23229_ = ((_e74 + _e78) <= 1f);
                phi_23230_ = false;
            } else {
                phi_23229_ = bool();
                phi_23230_ = true;
            }
            let _e85 = phi_23229_;
            let _e87 = phi_23230_;
            phi_23231_ = _e85;
            phi_23232_ = _e87;
        } else {
            phi_23231_ = bool();
            phi_23232_ = true;
        }
        let _e89 = phi_23231_;
        let _e91 = phi_23232_;
        if _e91 {
            phi_23236_ = false;
        } else {
            phi_23236_ = _e89;
        }
        let _e93 = phi_23236_;
        phi_23237_ = _e93;
    }
    let _e113 = phi_23237_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e113 {
            phi_23270_ = array<f32, 3>((param_7[0] - ((param_8[0] * _e74) + (param_9[0] * _e78))), (param_7[1] - ((param_8[1] * _e74) + (param_9[1] * _e78))), (param_7[2] - ((param_8[2] * _e74) + (param_9[2] * _e78))));
            phi_23271_ = false;
        } else {
            phi_23270_ = array<f32, 3>();
            phi_23271_ = true;
        }
        let _e141 = phi_23270_;
        let _e143 = phi_23271_;
        phi_23272_ = _e141;
        phi_23273_ = _e143;
    } else {
        phi_23272_ = array<f32, 3>();
        phi_23273_ = true;
    }
    let _e145 = phi_23272_;
    let _e147 = phi_23273_;
    if _e147 {
        let _e148 = function_2(param_7, param_8, param_9, param_10);
        phi_23278_ = _e148;
    } else {
        phi_23278_ = _e145;
    }
    let _e150 = phi_23278_;
    return _e150;
}

fn function_4(param_11: u32, param_12: u32, param_13: u32) -> type_9 {
    var phi_22927_: u32;
    var phi_22934_: type_9;
    var phi_22976_: u32;
    var phi_22994_: u32;
    var phi_23001_: type_9;

    if ((param_11 >> bitcast<u32>(31i)) != 0u) {
        if (param_12 == 0u) {
            phi_22927_ = 1u;
        } else {
            phi_22927_ = 0u;
        }
        let _e15 = phi_22927_;
        phi_22934_ = type_9((~(param_11) + _e15), (~(param_12) + 1u));
    } else {
        phi_22934_ = type_9(param_11, param_12);
    }
    let _e22 = phi_22934_;
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
        phi_22976_ = 1u;
    } else {
        phi_22976_ = 0u;
    }
    let _e72 = phi_22976_;
    let _e78 = ((((((_e26 * _e29) + (_e35 >> bitcast<u32>(16i))) + (((_e27 * _e29) + (_e35 & 65535u)) >> bitcast<u32>(16i))) + _e72) << bitcast<u32>(1i)) | (_e69 >> bitcast<u32>(31i)));
    let _e83 = ((_e69 << bitcast<u32>(1i)) | ((_e22.member_1 * param_13) >> bitcast<u32>(31i)));
    if ((param_11 >> bitcast<u32>(31i)) != 0u) {
        if (_e83 == 0u) {
            phi_22994_ = 1u;
        } else {
            phi_22994_ = 0u;
        }
        let _e90 = phi_22994_;
        phi_23001_ = type_9((~(_e78) + _e90), (~(_e83) + 1u));
    } else {
        phi_23001_ = type_9(_e78, _e83);
    }
    let _e97 = phi_23001_;
    return _e97;
}

fn function_5(param_14: array<type_9, 3>, param_15: u32) -> array<type_9, 2> {
    var phi_23079_: u32;
    var phi_23091_: u32;
    var phi_23102_: u32;
    var phi_23114_: u32;

    if (param_14[1].member_1 < param_14[0].member_1) {
        phi_23079_ = 1u;
    } else {
        phi_23079_ = 0u;
    }
    let _e14 = phi_23079_;
    let _e18 = function_4(((param_14[1].member - param_14[0].member) - _e14), (param_14[1].member_1 - param_14[0].member_1), param_15);
    let _e21 = (param_14[0].member_1 + _e18.member_1);
    if (_e21 < param_14[0].member_1) {
        phi_23091_ = 1u;
    } else {
        phi_23091_ = 0u;
    }
    let _e24 = phi_23091_;
    if (param_14[2].member_1 < param_14[1].member_1) {
        phi_23102_ = 1u;
    } else {
        phi_23102_ = 0u;
    }
    let _e37 = phi_23102_;
    let _e41 = function_4(((param_14[2].member - param_14[1].member) - _e37), (param_14[2].member_1 - param_14[1].member_1), param_15);
    let _e44 = (param_14[1].member_1 + _e41.member_1);
    if (_e44 < param_14[1].member_1) {
        phi_23114_ = 1u;
    } else {
        phi_23114_ = 0u;
    }
    let _e47 = phi_23114_;
    return array<type_9, 2>(type_9(((param_14[0].member + _e18.member) + _e24), _e21), type_9(((param_14[1].member + _e41.member) + _e47), _e44));
}

fn function_6(param_16: u32, param_17: u32, param_18: u32, param_19: u32) -> bool {
    var phi_23063_: u32;

    if (param_19 < param_17) {
        phi_23063_ = 1u;
    } else {
        phi_23063_ = 0u;
    }
    let _e9 = phi_23063_;
    return ((((param_18 - param_16) - _e9) >> bitcast<u32>(31i)) != 0u);
}

fn function_7(param_20: u32, param_21: u32, param_22: u32, param_23: u32) -> bool {
    var phi_23040_: u32;
    var phi_23049_: u32;

    if (param_21 == 0u) {
        phi_23040_ = 1u;
    } else {
        phi_23040_ = 0u;
    }
    let _e9 = phi_23040_;
    if (param_23 < (~(param_21) + 1u)) {
        phi_23049_ = 1u;
    } else {
        phi_23049_ = 0u;
    }
    let _e16 = phi_23049_;
    return ((((param_22 - (~(param_20) + _e9)) - _e16) >> bitcast<u32>(31i)) != 0u);
}

fn function_8(param_24: u32, param_25: u32, param_26: u32, param_27: u32) -> type_9 {
    var phi_22752_: u32;
    var phi_22759_: type_9;
    var phi_22771_: u32;
    var phi_22778_: type_9;
    var phi_22837_: u32;
    var phi_22843_: u32;
    var phi_22851_: u32;
    var phi_22859_: u32;
    var phi_22880_: u32;
    var phi_22887_: type_9;

    if ((param_24 >> bitcast<u32>(31i)) != 0u) {
        if (param_25 == 0u) {
            phi_22752_ = 1u;
        } else {
            phi_22752_ = 0u;
        }
        let _e17 = phi_22752_;
        phi_22759_ = type_9((~(param_24) + _e17), (~(param_25) + 1u));
    } else {
        phi_22759_ = type_9(param_24, param_25);
    }
    let _e24 = phi_22759_;
    if ((param_26 >> bitcast<u32>(31i)) != 0u) {
        if (param_27 == 0u) {
            phi_22771_ = 1u;
        } else {
            phi_22771_ = 0u;
        }
        let _e33 = phi_22771_;
        phi_22778_ = type_9((~(param_26) + _e33), (~(param_27) + 1u));
    } else {
        phi_22778_ = type_9(param_26, param_27);
    }
    let _e40 = phi_22778_;
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
        phi_22837_ = 1u;
    } else {
        phi_22837_ = 0u;
    }
    let _e112 = phi_22837_;
    let _e113 = (_e64 + (((_e66 * _e69) + (_e75 >> bitcast<u32>(16i))) + (((_e67 * _e69) + (_e75 & 65535u)) >> bitcast<u32>(16i))));
    if (_e113 < _e64) {
        phi_22843_ = 1u;
    } else {
        phi_22843_ = 0u;
    }
    let _e116 = phi_22843_;
    let _e118 = (_e113 + (((_e88 * _e91) + (_e97 >> bitcast<u32>(16i))) + (((_e89 * _e91) + (_e97 & 65535u)) >> bitcast<u32>(16i))));
    if (_e118 < _e113) {
        phi_22851_ = 1u;
    } else {
        phi_22851_ = 0u;
    }
    let _e121 = phi_22851_;
    let _e123 = (_e118 + _e112);
    if (_e123 < _e118) {
        phi_22859_ = 1u;
    } else {
        phi_22859_ = 0u;
    }
    let _e126 = phi_22859_;
    let _e132 = ((_e123 << bitcast<u32>(2i)) | (_e109 >> bitcast<u32>(30i)));
    let _e137 = ((((((((_e44 * _e47) + (_e53 >> bitcast<u32>(16i))) + (((_e45 * _e47) + (_e53 & 65535u)) >> bitcast<u32>(16i))) + _e116) + _e121) + _e126) << bitcast<u32>(2i)) | (_e123 >> bitcast<u32>(30i)));
    if (((param_24 >> bitcast<u32>(31i)) != 0u) != ((param_26 >> bitcast<u32>(31i)) != 0u)) {
        if (_e132 == 0u) {
            phi_22880_ = 1u;
        } else {
            phi_22880_ = 0u;
        }
        let _e148 = phi_22880_;
        phi_22887_ = type_9((~(_e137) + _e148), (~(_e132) + 1u));
    } else {
        phi_22887_ = type_9(_e137, _e132);
    }
    let _e155 = phi_22887_;
    return _e155;
}

fn function_9(param_28: array<type_9, 2>, param_29: array<type_9, 2>) -> type_9 {
    var phi_23026_: u32;

    let _e12 = function_8(param_28[0].member, param_28[0].member_1, param_29[1].member, param_29[1].member_1);
    let _e23 = function_8(param_28[1].member, param_28[1].member_1, param_29[0].member, param_29[0].member_1);
    if (_e12.member_1 < _e23.member_1) {
        phi_23026_ = 1u;
    } else {
        phi_23026_ = 0u;
    }
    let _e28 = phi_23026_;
    return type_9(((_e12.member - _e23.member) - _e28), (_e12.member_1 - _e23.member_1));
}

fn function_10(param_30: u32) -> type_9 {
    return type_9(0u, param_30);
}

fn function_11(param_31: u32, param_32: u32) -> type_9 {
    var phi_22899_: u32;
    var phi_22907_: u32;

    let _e4 = (param_32 + param_32);
    if (_e4 < param_32) {
        phi_22899_ = 1u;
    } else {
        phi_22899_ = 0u;
    }
    let _e7 = phi_22899_;
    let _e10 = (_e4 + param_32);
    if (_e10 < _e4) {
        phi_22907_ = 1u;
    } else {
        phi_22907_ = 0u;
    }
    let _e13 = phi_22907_;
    return type_9(((((param_31 + param_31) + _e7) + param_31) + _e13), _e10);
}

fn function_12(param_33: array<u32, 2>, param_34: i32) -> type_9 {
    var phi_22701_: type_9;
    var phi_22702_: type_9;
    var phi_22703_: type_9;
    var phi_22704_: type_9;
    var phi_22705_: type_9;
    var phi_22706_: bool;
    var phi_22711_: type_9;
    var phi_22723_: u32;
    var phi_22730_: type_9;
    var phi_22734_: type_9;

    let _e25 = ((param_33[1] >> bitcast<u32>(20i)) & 2047u);
    if (_e25 == 0u) {
        phi_22734_ = type_9(0u, 0u);
    } else {
        let _e28 = ((param_33[1] & 1048575u) | 1048576u);
        let _e31 = ((bitcast<i32>(_e25) - 1015i) - param_34);
        let _e33 = (bitcast<u32>(_e31) % 32u);
        if (_e31 >= 64i) {
            phi_22705_ = type_9();
            phi_22706_ = true;
        } else {
            let _e35 = (_e31 <= -53i);
            if _e35 {
                phi_22704_ = type_9();
            } else {
                if (_e31 >= 32i) {
                    phi_22703_ = type_9((param_33[0] << bitcast<u32>((_e33 & 31u))), 0u);
                } else {
                    if (_e31 >= 0i) {
                        phi_22702_ = type_9(((_e28 << bitcast<u32>((_e33 & 31u))) | ((param_33[0] >> bitcast<u32>(1i)) >> bitcast<u32>(((31u - _e33) & 31u)))), (param_33[0] << bitcast<u32>((_e33 & 31u))));
                    } else {
                        if (_e31 > -32i) {
                            let _e47 = bitcast<u32>(-(_e31));
                            phi_22701_ = type_9(bitcast<u32>((bitcast<i32>(_e28) >> bitcast<u32>((_e47 & 31u)))), ((param_33[0] >> bitcast<u32>((_e47 & 31u))) | ((_e28 << bitcast<u32>(((31u - _e47) & 31u))) << bitcast<u32>(1i))));
                        } else {
                            phi_22701_ = type_9(0u, (_e28 >> bitcast<u32>(((bitcast<u32>(-(_e31)) - 32u) & 31u))));
                        }
                        let _e65 = phi_22701_;
                        phi_22702_ = _e65;
                    }
                    let _e81 = phi_22702_;
                    phi_22703_ = _e81;
                }
                let _e87 = phi_22703_;
                phi_22704_ = _e87;
            }
            let _e89 = phi_22704_;
            phi_22705_ = _e89;
            phi_22706_ = _e35;
        }
        let _e91 = phi_22705_;
        let _e93 = phi_22706_;
        if _e93 {
            phi_22711_ = type_9(0u, 0u);
        } else {
            phi_22711_ = _e91;
        }
        let _e95 = phi_22711_;
        if ((param_33[1] >> bitcast<u32>(31i)) != 0u) {
            if (_e95.member_1 == 0u) {
                phi_22723_ = 1u;
            } else {
                phi_22723_ = 0u;
            }
            let _e103 = phi_22723_;
            phi_22730_ = type_9((~(_e95.member) + _e103), (~(_e95.member_1) + 1u));
        } else {
            phi_22730_ = _e95;
        }
        let _e110 = phi_22730_;
        phi_22734_ = _e110;
    }
    let _e112 = phi_22734_;
    return _e112;
}

fn function_13(param_35: f32, param_36: f32) -> f32 {
    var phi_22624_: bool;
    var phi_22628_: f32;

    if (param_35 != param_35) {
        phi_22624_ = true;
    } else {
        phi_22624_ = (param_36 >= param_35);
    }
    let _e6 = phi_22624_;
    if _e6 {
        phi_22628_ = param_36;
    } else {
        phi_22628_ = param_35;
    }
    let _e8 = phi_22628_;
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
    var phi_1232_: i32;
    var phi_1233_: bool;
    var phi_1234_: i32;
    var phi_1235_: bool;
    var phi_1239_: i32;
    var phi_1281_: array<u32, 2>;
    var phi_1298_: array<u32, 2>;
    var phi_1315_: array<u32, 2>;
    var phi_1349_: array<u32, 2>;
    var phi_1366_: array<u32, 2>;
    var phi_1383_: array<u32, 2>;
    var phi_1418_: array<u32, 2>;
    var phi_1435_: array<u32, 2>;
    var phi_1452_: array<u32, 2>;
    var phi_1486_: array<u32, 2>;
    var phi_1503_: array<u32, 2>;
    var phi_1520_: array<u32, 2>;
    var phi_1555_: array<u32, 2>;
    var phi_1572_: array<u32, 2>;
    var phi_1589_: array<u32, 2>;
    var phi_1623_: array<u32, 2>;
    var phi_1640_: array<u32, 2>;
    var phi_1657_: array<u32, 2>;
    var phi_1692_: array<u32, 2>;
    var phi_1709_: array<u32, 2>;
    var phi_1726_: array<u32, 2>;
    var phi_1760_: array<u32, 2>;
    var phi_1777_: array<u32, 2>;
    var phi_1794_: array<u32, 2>;
    var phi_2711_: array<array<array<type_9, 3>, 2>, 4>;
    var phi_3000_: u32;
    var phi_3012_: u32;
    var phi_3024_: u32;
    var phi_3044_: u32;
    var phi_3056_: u32;
    var phi_3068_: u32;
    var phi_3089_: u32;
    var phi_3101_: u32;
    var phi_3113_: u32;
    var phi_3133_: u32;
    var phi_3145_: u32;
    var phi_3157_: u32;
    var phi_3178_: u32;
    var phi_3190_: u32;
    var phi_3202_: u32;
    var phi_3222_: u32;
    var phi_3234_: u32;
    var phi_3246_: u32;
    var phi_2732_: u32;
    var phi_2744_: u32;
    var phi_2756_: u32;
    var phi_2776_: u32;
    var phi_2788_: u32;
    var phi_2800_: u32;
    var phi_2821_: u32;
    var phi_2833_: u32;
    var phi_2845_: u32;
    var phi_2865_: u32;
    var phi_2877_: u32;
    var phi_2889_: u32;
    var phi_2910_: u32;
    var phi_2922_: u32;
    var phi_2934_: u32;
    var phi_2954_: u32;
    var phi_2966_: u32;
    var phi_2978_: u32;
    var phi_3258_: array<array<array<type_9, 3>, 2>, 3>;
    var phi_3337_: u32;
    var phi_3417_: u32;
    var phi_3497_: u32;
    var phi_3585_: u32;
    var phi_3665_: u32;
    var phi_3745_: u32;
    var phi_3833_: u32;
    var phi_3913_: u32;
    var phi_3993_: u32;
    var phi_4081_: u32;
    var phi_4161_: u32;
    var phi_4241_: u32;
    var phi_4260_: u32;
    var phi_4272_: u32;
    var phi_4284_: u32;
    var phi_4313_: u32;
    var phi_4328_: u32;
    var phi_4354_: u32;
    var phi_4369_: u32;
    var phi_4392_: u32;
    var phi_4407_: u32;
    var phi_4415_: u32;
    var phi_4438_: u32;
    var phi_4453_: u32;
    var phi_4476_: u32;
    var phi_4491_: u32;
    var phi_4499_: u32;
    var phi_4522_: u32;
    var phi_4537_: u32;
    var phi_4553_: type_9;
    var phi_4556_: array<type_9, 4>;
    var phi_4560_: u32;
    var phi_4562_: u32;
    var phi_4554_: type_9;
    var phi_4585_: type_9;
    var phi_4620_: u32;
    var phi_4627_: type_9;
    var phi_4634_: u32;
    var phi_4647_: u32;
    var phi_4648_: u32;
    var phi_4663_: u32;
    var phi_4670_: type_9;
    var phi_4677_: u32;
    var phi_4690_: u32;
    var phi_4691_: u32;
    var phi_4707_: u32;
    var phi_4714_: type_9;
    var phi_4721_: u32;
    var phi_4734_: u32;
    var phi_4735_: u32;
    var phi_4751_: u32;
    var phi_4758_: type_9;
    var phi_4765_: u32;
    var phi_4778_: u32;
    var phi_4779_: u32;
    var phi_4782_: bool;
    var phi_4805_: bool;
    var phi_4806_: bool;
    var phi_4807_: bool;
    var phi_4825_: u32;
    var phi_4832_: type_9;
    var phi_4839_: u32;
    var phi_4852_: u32;
    var phi_4853_: u32;
    var phi_4868_: u32;
    var phi_4875_: type_9;
    var phi_4882_: u32;
    var phi_4895_: u32;
    var phi_4896_: u32;
    var phi_4903_: bool;
    var phi_4911_: u32;
    var phi_4929_: u32;
    var phi_4941_: u32;
    var phi_4953_: u32;
    var phi_4974_: u32;
    var phi_4981_: type_9;
    var phi_4995_: u32;
    var phi_5002_: type_9;
    var phi_5009_: u32;
    var phi_5019_: type_9;
    var phi_5033_: u32;
    var phi_5040_: type_9;
    var phi_5047_: u32;
    var phi_5057_: type_9;
    var phi_5068_: u32;
    var phi_5090_: u32;
    var phi_5103_: u32;
    var phi_5115_: u32;
    var phi_5127_: u32;
    var phi_5148_: u32;
    var phi_5155_: type_9;
    var phi_5169_: u32;
    var phi_5176_: type_9;
    var phi_5183_: u32;
    var phi_5193_: type_9;
    var phi_5207_: u32;
    var phi_5214_: type_9;
    var phi_5221_: u32;
    var phi_5231_: type_9;
    var phi_5242_: u32;
    var phi_5264_: u32;
    var phi_5277_: u32;
    var phi_5289_: u32;
    var phi_5301_: u32;
    var phi_5322_: u32;
    var phi_5329_: type_9;
    var phi_5343_: u32;
    var phi_5350_: type_9;
    var phi_5357_: u32;
    var phi_5367_: type_9;
    var phi_5381_: u32;
    var phi_5388_: type_9;
    var phi_5395_: u32;
    var phi_5405_: type_9;
    var phi_5416_: u32;
    var phi_5438_: u32;
    var phi_5459_: u32;
    var phi_5471_: u32;
    var phi_5482_: u32;
    var phi_5494_: u32;
    var phi_5505_: u32;
    var phi_5517_: u32;
    var phi_5536_: u32;
    var phi_5548_: u32;
    var phi_5559_: u32;
    var phi_5571_: u32;
    var phi_5582_: u32;
    var phi_5594_: u32;
    var phi_5613_: u32;
    var phi_5625_: u32;
    var phi_5636_: u32;
    var phi_5648_: u32;
    var phi_5659_: u32;
    var phi_5671_: u32;
    var phi_5756_: u32;
    var phi_5836_: u32;
    var phi_5916_: u32;
    var phi_5937_: u32;
    var phi_5944_: type_9;
    var phi_5958_: u32;
    var phi_5965_: type_9;
    var phi_5979_: u32;
    var phi_5986_: type_9;
    var phi_5993_: u32;
    var phi_6005_: u32;
    var phi_6013_: bool;
    var phi_6014_: bool;
    var phi_6022_: u32;
    var phi_6030_: i32;
    var phi_6031_: i32;
    var phi_6060_: array<type_9, 2>;
    var phi_6089_: array<type_9, 2>;
    var phi_6118_: array<type_9, 2>;
    var phi_6132_: type_9;
    var phi_6158_: u32;
    var phi_6180_: u32;
    var phi_6208_: u32;
    var phi_6230_: u32;
    var phi_6258_: u32;
    var phi_6280_: u32;
    var phi_6294_: u32;
    var phi_6301_: type_9;
    var phi_6308_: u32;
    var phi_6328_: u32;
    var phi_6335_: type_9;
    var phi_6348_: u32;
    var phi_6355_: type_9;
    var phi_6368_: u32;
    var phi_6375_: type_9;
    var phi_6422_: u32;
    var phi_6430_: u32;
    var phi_6440_: u32;
    var phi_6448_: u32;
    var phi_6386_: u32;
    var phi_6396_: u32;
    var phi_6404_: u32;
    var phi_6414_: u32;
    var phi_6454_: type_9;
    var phi_6455_: type_9;
    var phi_6456_: type_9;
    var phi_6457_: type_9;
    var phi_6570_: bool;
    var phi_6571_: bool;
    var phi_6572_: bool;
    var phi_6573_: bool;
    var phi_6577_: u32;
    var phi_6578_: u32;
    var phi_6579_: u32;
    var phi_6580_: bool;
    var phi_6581_: u32;
    var phi_6582_: bool;
    var phi_6583_: u32;
    var phi_6584_: bool;
    var phi_6588_: u32;
    var phi_6589_: u32;
    var phi_6597_: bool;
    var phi_6601_: bool;
    var phi_6602_: bool;
    var phi_6603_: bool;
    var phi_6604_: u32;
    var phi_6605_: u32;
    var phi_6606_: bool;
    var phi_6622_: u32;
    var phi_6645_: u32;
    var phi_6668_: u32;
    var phi_6687_: u32;
    var phi_6706_: u32;
    var phi_6725_: u32;
    var phi_6765_: u32;
    var phi_6772_: type_9;
    var phi_6779_: u32;
    var phi_6792_: u32;
    var phi_6793_: u32;
    var phi_6808_: u32;
    var phi_6815_: type_9;
    var phi_6822_: u32;
    var phi_6835_: u32;
    var phi_6836_: u32;
    var phi_6852_: u32;
    var phi_6859_: type_9;
    var phi_6866_: u32;
    var phi_6879_: u32;
    var phi_6880_: u32;
    var phi_6896_: u32;
    var phi_6903_: type_9;
    var phi_6910_: u32;
    var phi_6923_: u32;
    var phi_6924_: u32;
    var phi_6941_: array<type_9, 4>;
    var phi_6942_: u32;
    var phi_6943_: array<type_9, 4>;
    var phi_6945_: u32;
    var phi_6946_: u32;
    var phi_6947_: array<type_9, 4>;
    var phi_6949_: u32;
    var phi_6950_: u32;
    var phi_6951_: array<type_9, 4>;
    var phi_6953_: bool;
    var phi_6954_: u32;
    var phi_6955_: u32;
    var phi_6956_: bool;
    var phi_6957_: bool;
    var phi_6958_: u32;
    var phi_6959_: u32;
    var phi_6960_: bool;
    var phi_6979_: u32;
    var phi_6991_: bool;
    var phi_6992_: bool;
    var phi_7010_: u32;
    var phi_7022_: u32;
    var phi_7033_: u32;
    var phi_7045_: u32;
    var phi_7056_: u32;
    var phi_7068_: u32;
    var phi_7085_: u32;
    var phi_7097_: u32;
    var phi_7108_: u32;
    var phi_7120_: u32;
    var phi_7131_: u32;
    var phi_7143_: u32;
    var phi_7163_: u32;
    var phi_7175_: u32;
    var phi_7186_: u32;
    var phi_7198_: u32;
    var phi_7209_: u32;
    var phi_7221_: u32;
    var phi_7232_: u32;
    var phi_7244_: u32;
    var phi_7255_: array<type_9, 4>;
    var phi_7256_: array<type_9, 4>;
    var phi_7257_: u32;
    var phi_7258_: u32;
    var phi_7259_: bool;
    var phi_7263_: bool;
    var phi_7264_: array<type_9, 4>;
    var phi_7265_: u32;
    var phi_7266_: u32;
    var phi_7267_: bool;
    var phi_7268_: bool;
    var phi_7269_: bool;
    var phi_7270_: array<type_9, 4>;
    var phi_7272_: u32;
    var phi_7273_: u32;
    var phi_7274_: bool;
    var phi_7275_: bool;
    var phi_7276_: u32;
    var phi_7277_: u32;
    var phi_7278_: bool;
    var phi_7279_: bool;
    var phi_7280_: bool;
    var phi_4557_: array<type_9, 4>;
    var phi_4561_: u32;
    var phi_4563_: u32;
    var phi_7281_: u32;
    var phi_7282_: bool;
    var phi_7283_: bool;
    var phi_7284_: u32;
    var phi_7285_: u32;
    var phi_7286_: bool;
    var phi_7287_: bool;
    var phi_7288_: bool;
    var phi_7289_: bool;
    var phi_7290_: bool;
    var local_62: bool;
    var phi_7295_: type_9;
    var phi_7296_: bool;
    var phi_7297_: bool;
    var phi_7298_: bool;
    var phi_7303_: type_9;
    var phi_7304_: bool;
    var phi_7305_: bool;
    var phi_7306_: bool;
    var phi_7311_: type_9;
    var phi_7312_: bool;
    var phi_7313_: bool;
    var local_63: bool;
    var local_64: u32;
    var local_65: array<type_9, 4>;
    var local_66: array<type_9, 4>;
    var local_67: array<type_9, 4>;
    var phi_7338_: u32;
    var phi_7345_: type_9;
    var phi_7352_: u32;
    var phi_7365_: u32;
    var phi_7366_: u32;
    var phi_7375_: u32;
    var local_68: u32;
    var phi_7387_: u32;
    var phi_7398_: u32;
    var local_69: u32;
    var phi_7410_: u32;
    var phi_7421_: u32;
    var local_70: u32;
    var phi_7433_: u32;
    var phi_7450_: u32;
    var local_71: u32;
    var phi_7462_: u32;
    var phi_7473_: u32;
    var local_72: u32;
    var phi_7485_: u32;
    var phi_7496_: u32;
    var local_73: u32;
    var phi_7508_: u32;
    var local_74: u32;
    var local_75: u32;
    var local_76: u32;
    var phi_7528_: u32;
    var local_77: u32;
    var phi_7540_: u32;
    var phi_7551_: u32;
    var local_78: u32;
    var phi_7574_: u32;
    var local_79: u32;
    var phi_7597_: u32;
    var local_80: u32;
    var phi_7634_: u32;
    var phi_7641_: type_9;
    var phi_7648_: u32;
    var phi_7661_: u32;
    var phi_7662_: u32;
    var phi_7665_: bool;
    var phi_7666_: bool;
    var phi_7667_: bool;
    var phi_7668_: bool;
    var phi_7672_: bool;
    var local_81: u32;
    var local_82: u32;
    var phi_7678_: bool;
    var local_83: u32;
    var phi_7686_: bool;
    var phi_7687_: bool;
    var phi_7688_: bool;
    var phi_7689_: bool;
    var phi_7693_: bool;
    var local_84: u32;
    var phi_7699_: type_9;
    var phi_7700_: type_9;
    var phi_7701_: bool;
    var phi_7702_: bool;
    var phi_7706_: type_9;
    var phi_7707_: bool;
    var phi_7711_: type_9;
    var phi_7724_: u32;
    var phi_7742_: array<u32, 2>;
    var phi_7748_: type_28;
    var phi_7754_: bool;
    var phi_7755_: type_28;
    var phi_7756_: bool;
    var phi_7757_: type_28;
    var phi_7758_: bool;
    var phi_7776_: array<u32, 2>;
    var phi_7790_: bool;
    var phi_7806_: bool;
    var phi_7814_: f32;
    var phi_7821_: f32;
    var phi_7826_: f32;
    var phi_7833_: f32;
    var phi_7838_: f32;
    var phi_7846_: f32;
    var phi_7853_: f32;
    var phi_7858_: f32;
    var phi_7865_: f32;
    var phi_7870_: f32;
    var phi_7875_: f32;
    var phi_7885_: f32;
    var phi_7892_: f32;
    var phi_7897_: f32;
    var phi_7904_: f32;
    var phi_7909_: f32;
    var phi_7917_: f32;
    var phi_7924_: f32;
    var phi_7929_: f32;
    var phi_7936_: f32;
    var phi_7941_: f32;
    var phi_7946_: f32;
    var phi_7956_: f32;
    var phi_7963_: f32;
    var phi_7968_: f32;
    var phi_7975_: f32;
    var phi_7980_: f32;
    var phi_7988_: f32;
    var phi_7995_: f32;
    var phi_8000_: f32;
    var phi_8007_: f32;
    var phi_8012_: f32;
    var phi_8017_: f32;
    var phi_8024_: f32;
    var phi_8029_: f32;
    var phi_8036_: bool;
    var phi_8060_: u32;
    var phi_8071_: f32;
    var phi_8072_: f32;
    var phi_8130_: type_43;
    var phi_8131_: bool;
    var phi_8132_: type_43;
    var phi_8133_: bool;
    var phi_8134_: type_43;
    var phi_8135_: bool;
    var phi_8140_: type_43;
    var phi_15086_: f32;
    var phi_15093_: f32;
    var phi_15098_: f32;
    var phi_15105_: f32;
    var phi_15110_: f32;
    var phi_15123_: f32;
    var phi_15130_: f32;
    var phi_15135_: f32;
    var phi_15142_: f32;
    var phi_15147_: f32;
    var phi_15152_: f32;
    var phi_15169_: f32;
    var phi_15176_: f32;
    var phi_15181_: f32;
    var phi_15188_: f32;
    var phi_15193_: f32;
    var phi_15207_: f32;
    var phi_15214_: f32;
    var phi_15219_: f32;
    var phi_15226_: f32;
    var phi_15231_: f32;
    var phi_15236_: f32;
    var phi_15253_: f32;
    var phi_15260_: f32;
    var phi_15265_: f32;
    var phi_15272_: f32;
    var phi_15277_: f32;
    var phi_15291_: f32;
    var phi_15298_: f32;
    var phi_15303_: f32;
    var phi_15310_: f32;
    var phi_15315_: f32;
    var phi_15320_: f32;
    var phi_15351_: f32;
    var phi_15357_: f32;
    var phi_15364_: f32;
    var phi_15371_: f32;
    var phi_15377_: f32;
    var phi_15384_: f32;
    var phi_15390_: f32;
    var phi_15396_: f32;
    var phi_15402_: f32;
    var phi_15409_: f32;
    var phi_15416_: f32;
    var phi_15440_: f32;
    var phi_15445_: f32;
    var phi_15450_: f32;
    var phi_15455_: f32;
    var phi_15460_: f32;
    var phi_15465_: f32;
    var phi_15475_: f32;
    var phi_15488_: f32;
    var phi_15494_: f32;
    var phi_15499_: f32;
    var phi_15505_: f32;
    var phi_15511_: f32;
    var phi_15516_: f32;
    var phi_15521_: f32;
    var phi_15529_: bool;
    var phi_15534_: f32;
    var phi_15541_: f32;
    var phi_15547_: f32;
    var phi_15565_: f32;
    var phi_15626_: array<f32, 3>;
    var phi_15691_: array<f32, 3>;
    var phi_15713_: f32;
    var phi_15720_: f32;
    var phi_15725_: f32;
    var phi_15732_: f32;
    var phi_15737_: f32;
    var phi_15750_: f32;
    var phi_15757_: f32;
    var phi_15762_: f32;
    var phi_15769_: f32;
    var phi_15774_: f32;
    var phi_15779_: f32;
    var phi_15796_: f32;
    var phi_15803_: f32;
    var phi_15808_: f32;
    var phi_15815_: f32;
    var phi_15820_: f32;
    var phi_15834_: f32;
    var phi_15841_: f32;
    var phi_15846_: f32;
    var phi_15853_: f32;
    var phi_15858_: f32;
    var phi_15863_: f32;
    var phi_15880_: f32;
    var phi_15887_: f32;
    var phi_15892_: f32;
    var phi_15899_: f32;
    var phi_15904_: f32;
    var phi_15918_: f32;
    var phi_15925_: f32;
    var phi_15930_: f32;
    var phi_15937_: f32;
    var phi_15942_: f32;
    var phi_15947_: f32;
    var phi_16065_: f32;
    var phi_16072_: f32;
    var phi_16080_: f32;
    var phi_16124_: type_14;
    var phi_16127_: f32;
    var phi_16148_: bool;
    var phi_16154_: type_15;
    var phi_16125_: type_14;
    var phi_16168_: type_15;
    var phi_16128_: f32;
    var local_85: f32;
    var phi_16117_: f32;
    var phi_16181_: f32;
    var phi_16247_: f32;
    var phi_16253_: f32;
    var phi_16262_: f32;
    var phi_16268_: f32;
    var phi_16277_: f32;
    var phi_16283_: f32;
    var phi_16292_: f32;
    var phi_16298_: f32;
    var phi_16304_: type_29;
    var phi_16305_: bool;
    var phi_16306_: type_29;
    var phi_16307_: bool;
    var phi_16315_: type_29;
    var phi_16484_: bool;
    var phi_16485_: bool;
    var phi_16486_: bool;
    var phi_16487_: bool;
    var phi_16488_: bool;
    var phi_16489_: bool;
    var phi_16493_: bool;
    var phi_16520_: f32;
    var phi_16574_: type_14;
    var phi_16577_: f32;
    var phi_16598_: bool;
    var phi_16604_: type_15;
    var phi_16575_: type_14;
    var phi_16618_: type_15;
    var phi_16578_: f32;
    var local_86: f32;
    var phi_16567_: f32;
    var phi_16631_: f32;
    var phi_16697_: f32;
    var phi_16703_: f32;
    var phi_16712_: f32;
    var phi_16718_: f32;
    var phi_16727_: f32;
    var phi_16733_: f32;
    var phi_16742_: f32;
    var phi_16748_: f32;
    var phi_16754_: type_29;
    var phi_16755_: bool;
    var phi_16756_: type_29;
    var phi_16757_: bool;
    var phi_16765_: type_29;
    var phi_16934_: bool;
    var phi_16935_: bool;
    var phi_16936_: bool;
    var phi_16937_: bool;
    var phi_16938_: bool;
    var phi_16939_: bool;
    var phi_16943_: bool;
    var phi_16976_: f32;
    var phi_17024_: type_14;
    var phi_17027_: f32;
    var phi_17048_: bool;
    var phi_17054_: type_15;
    var phi_17025_: type_14;
    var phi_17068_: type_15;
    var phi_17028_: f32;
    var local_87: f32;
    var phi_17017_: f32;
    var phi_17081_: f32;
    var phi_17147_: f32;
    var phi_17153_: f32;
    var phi_17162_: f32;
    var phi_17168_: f32;
    var phi_17177_: f32;
    var phi_17183_: f32;
    var phi_17192_: f32;
    var phi_17198_: f32;
    var phi_17204_: type_29;
    var phi_17205_: bool;
    var phi_17206_: type_29;
    var phi_17207_: bool;
    var phi_17215_: type_29;
    var phi_17384_: bool;
    var phi_17385_: bool;
    var phi_17386_: bool;
    var phi_17387_: bool;
    var phi_17388_: bool;
    var phi_17389_: bool;
    var phi_17393_: bool;
    var phi_17433_: f32;
    var phi_17474_: type_14;
    var phi_17477_: f32;
    var phi_17498_: bool;
    var phi_17504_: type_15;
    var phi_17475_: type_14;
    var phi_17518_: type_15;
    var phi_17478_: f32;
    var local_88: f32;
    var phi_17467_: f32;
    var phi_17531_: f32;
    var phi_17597_: f32;
    var phi_17603_: f32;
    var phi_17612_: f32;
    var phi_17618_: f32;
    var phi_17627_: f32;
    var phi_17633_: f32;
    var phi_17642_: f32;
    var phi_17648_: f32;
    var phi_17654_: type_29;
    var phi_17655_: bool;
    var phi_17656_: type_29;
    var phi_17657_: bool;
    var phi_17665_: type_29;
    var phi_17834_: bool;
    var phi_17835_: bool;
    var phi_17836_: bool;
    var phi_17837_: bool;
    var phi_17838_: bool;
    var phi_17839_: bool;
    var phi_17843_: bool;
    var phi_17844_: bool;
    var phi_17845_: bool;
    var phi_17846_: bool;
    var phi_17847_: bool;
    var phi_17848_: bool;
    var phi_17852_: bool;
    var phi_17858_: type_44;
    var phi_17859_: bool;
    var phi_17860_: type_44;
    var phi_17861_: bool;
    var phi_17904_: type_14;
    var phi_17907_: f32;
    var phi_17928_: bool;
    var phi_17934_: type_15;
    var phi_17905_: type_14;
    var phi_17948_: type_15;
    var phi_17908_: f32;
    var local_89: f32;
    var phi_17897_: f32;
    var phi_17961_: f32;
    var phi_17967_: f32;
    var phi_17992_: type_9;
    var phi_17995_: u32;
    var phi_17993_: type_9;
    var phi_18018_: type_9;
    var phi_18062_: u32;
    var phi_18063_: u32;
    var phi_17996_: u32;
    var phi_18064_: u32;
    var phi_18084_: type_9;
    var phi_18085_: type_9;
    var phi_18108_: type_9;
    var phi_18127_: f32;
    var phi_18140_: f32;
    var phi_18174_: f32;
    var phi_18181_: f32;
    var phi_18192_: bool;
    var phi_18193_: bool;
    var phi_18194_: bool;
    var phi_18195_: bool;
    var phi_18199_: bool;
    var phi_18210_: type_47;
    var phi_18211_: type_47;
    var phi_18212_: bool;
    var phi_18213_: type_47;
    var phi_18214_: bool;
    var phi_18225_: f32;
    var phi_18235_: type_9;
    var phi_18238_: f32;
    var phi_18240_: f32;
    var phi_18242_: f32;
    var phi_18236_: type_9;
    var phi_18265_: type_9;
    var phi_18290_: f32;
    var phi_18291_: f32;
    var phi_18317_: f32;
    var phi_18333_: f32;
    var phi_18340_: bool;
    var phi_18341_: bool;
    var phi_18342_: bool;
    var phi_18348_: f32;
    var phi_18349_: f32;
    var phi_18350_: bool;
    var phi_18239_: f32;
    var phi_18241_: f32;
    var phi_18243_: f32;
    var phi_18351_: f32;
    var phi_18352_: bool;
    var phi_18353_: bool;
    var local_90: bool;
    var phi_18357_: f32;
    var phi_18358_: f32;
    var phi_18366_: f32;
    var phi_18370_: type_9;
    var phi_18373_: f32;
    var phi_18371_: type_9;
    var phi_18396_: type_9;
    var phi_18426_: f32;
    var phi_18427_: bool;
    var phi_18428_: f32;
    var phi_18429_: bool;
    var phi_18430_: bool;
    var phi_18431_: bool;
    var phi_18432_: f32;
    var phi_18374_: f32;
    var phi_18433_: bool;
    var phi_18434_: bool;
    var phi_18435_: bool;
    var phi_18436_: bool;
    var local_91: bool;
    var phi_18440_: bool;
    var phi_18441_: bool;
    var phi_18445_: bool;
    var phi_18449_: f32;
    var phi_18450_: f32;
    var phi_18452_: type_47;
    var phi_18481_: f32;
    var phi_18488_: f32;
    var phi_18493_: f32;
    var phi_18500_: f32;
    var phi_18505_: f32;
    var phi_18518_: f32;
    var phi_18525_: f32;
    var phi_18530_: f32;
    var phi_18537_: f32;
    var phi_18542_: f32;
    var phi_18547_: f32;
    var phi_18606_: f32;
    var phi_18612_: f32;
    var phi_18617_: f32;
    var phi_18623_: f32;
    var phi_18628_: f32;
    var phi_18640_: f32;
    var phi_18646_: f32;
    var phi_18651_: f32;
    var phi_18657_: f32;
    var phi_18662_: f32;
    var phi_18688_: f32;
    var phi_18695_: f32;
    var phi_18700_: f32;
    var phi_18707_: f32;
    var phi_18712_: f32;
    var phi_18725_: f32;
    var phi_18732_: f32;
    var phi_18737_: f32;
    var phi_18744_: f32;
    var phi_18749_: f32;
    var phi_18754_: f32;
    var phi_18813_: f32;
    var phi_18819_: f32;
    var phi_18824_: f32;
    var phi_18830_: f32;
    var phi_18835_: f32;
    var phi_18847_: f32;
    var phi_18853_: f32;
    var phi_18858_: f32;
    var phi_18864_: f32;
    var phi_18869_: f32;
    var phi_18895_: f32;
    var phi_18902_: f32;
    var phi_18907_: f32;
    var phi_18914_: f32;
    var phi_18919_: f32;
    var phi_18932_: f32;
    var phi_18939_: f32;
    var phi_18944_: f32;
    var phi_18951_: f32;
    var phi_18956_: f32;
    var phi_18961_: f32;
    var phi_19020_: f32;
    var phi_19026_: f32;
    var phi_19031_: f32;
    var phi_19037_: f32;
    var phi_19042_: f32;
    var phi_19054_: f32;
    var phi_19060_: f32;
    var phi_19065_: f32;
    var phi_19071_: f32;
    var phi_19076_: f32;
    var phi_19125_: f32;
    var phi_19131_: f32;
    var phi_19159_: f32;
    var phi_19165_: f32;
    var phi_19170_: u32;
    var phi_19171_: u32;
    var phi_19141_: f32;
    var phi_19147_: f32;
    var phi_19152_: u32;
    var phi_19153_: u32;
    var phi_19172_: u32;
    var phi_19173_: u32;
    var phi_19242_: f32;
    var phi_19251_: f32;
    var phi_19386_: f32;
    var phi_19392_: f32;
    var phi_19399_: f32;
    var phi_19434_: array<type_26, 4>;
    var phi_19454_: type_9;
    var phi_19457_: bool;
    var phi_19455_: type_9;
    var phi_19480_: type_9;
    var phi_19507_: bool;
    var phi_19508_: bool;
    var phi_19458_: bool;
    var phi_19509_: bool;
    var phi_19510_: bool;
    var local_92: bool;
    var phi_19514_: bool;
    var local_93: bool;
    var phi_19521_: u32;
    var phi_19522_: u32;
    var phi_19523_: bool;
    var phi_19524_: u32;
    var phi_19525_: u32;
    var phi_19526_: bool;
    var phi_19530_: u32;
    var phi_19540_: bool;
    var phi_19552_: bool;
    var phi_19553_: bool;
    var phi_19614_: array<f32, 3>;
    var phi_19679_: array<f32, 3>;
    var phi_19701_: f32;
    var phi_19708_: f32;
    var phi_19713_: f32;
    var phi_19720_: f32;
    var phi_19725_: f32;
    var phi_19738_: f32;
    var phi_19745_: f32;
    var phi_19750_: f32;
    var phi_19757_: f32;
    var phi_19762_: f32;
    var phi_19767_: f32;
    var phi_19784_: f32;
    var phi_19791_: f32;
    var phi_19796_: f32;
    var phi_19803_: f32;
    var phi_19808_: f32;
    var phi_19822_: f32;
    var phi_19829_: f32;
    var phi_19834_: f32;
    var phi_19841_: f32;
    var phi_19846_: f32;
    var phi_19851_: f32;
    var phi_19868_: f32;
    var phi_19875_: f32;
    var phi_19880_: f32;
    var phi_19887_: f32;
    var phi_19892_: f32;
    var phi_19906_: f32;
    var phi_19913_: f32;
    var phi_19918_: f32;
    var phi_19925_: f32;
    var phi_19930_: f32;
    var phi_19935_: f32;
    var phi_19976_: type_9;
    var phi_19979_: f32;
    var phi_19981_: f32;
    var phi_19983_: f32;
    var phi_19985_: f32;
    var phi_19987_: bool;
    var phi_19989_: u32;
    var phi_19977_: type_9;
    var phi_20012_: type_9;
    var phi_20126_: f32;
    var phi_20132_: f32;
    var phi_20138_: f32;
    var phi_20140_: array<f32, 3>;
    var phi_20147_: f32;
    var phi_20154_: f32;
    var phi_20162_: f32;
    var phi_20206_: type_14;
    var phi_20209_: f32;
    var phi_20230_: bool;
    var phi_20236_: type_15;
    var phi_20207_: type_14;
    var phi_20250_: type_15;
    var phi_20210_: f32;
    var local_94: f32;
    var phi_20199_: f32;
    var phi_20263_: f32;
    var phi_20329_: f32;
    var phi_20335_: f32;
    var phi_20344_: f32;
    var phi_20350_: f32;
    var phi_20359_: f32;
    var phi_20365_: f32;
    var phi_20374_: f32;
    var phi_20380_: f32;
    var phi_20386_: type_29;
    var phi_20387_: bool;
    var phi_20388_: type_29;
    var phi_20389_: bool;
    var phi_20397_: type_29;
    var phi_20568_: bool;
    var phi_20569_: bool;
    var phi_20570_: bool;
    var phi_20571_: bool;
    var phi_20572_: bool;
    var phi_20573_: bool;
    var phi_20577_: bool;
    var phi_20874_: bool;
    var phi_20875_: bool;
    var phi_20876_: bool;
    var phi_20877_: bool;
    var phi_20878_: bool;
    var phi_20879_: bool;
    var phi_20883_: bool;
    var phi_20887_: bool;
    var phi_20898_: bool;
    var phi_20899_: bool;
    var phi_20973_: bool;
    var phi_20974_: bool;
    var phi_20994_: f32;
    var phi_20995_: bool;
    var phi_20996_: f32;
    var phi_20997_: bool;
    var phi_20998_: f32;
    var phi_20999_: bool;
    var phi_21000_: bool;
    var phi_21004_: f32;
    var phi_21005_: bool;
    var phi_21009_: f32;
    var phi_21041_: bool;
    var phi_21042_: bool;
    var phi_21062_: f32;
    var phi_21063_: bool;
    var phi_21064_: f32;
    var phi_21065_: bool;
    var phi_21066_: f32;
    var phi_21067_: bool;
    var phi_21068_: bool;
    var phi_21072_: f32;
    var phi_21073_: bool;
    var phi_21077_: f32;
    var phi_21082_: f32;
    var phi_21114_: bool;
    var phi_21115_: bool;
    var phi_21135_: f32;
    var phi_21136_: bool;
    var phi_21137_: f32;
    var phi_21138_: bool;
    var phi_21139_: f32;
    var phi_21140_: bool;
    var phi_21141_: bool;
    var phi_21145_: f32;
    var phi_21146_: bool;
    var phi_21150_: f32;
    var phi_21182_: bool;
    var phi_21183_: bool;
    var phi_21203_: f32;
    var phi_21204_: bool;
    var phi_21205_: f32;
    var phi_21206_: bool;
    var phi_21207_: f32;
    var phi_21208_: bool;
    var phi_21209_: bool;
    var phi_21213_: f32;
    var phi_21214_: bool;
    var phi_21218_: f32;
    var phi_21223_: f32;
    var phi_21228_: f32;
    var phi_21233_: f32;
    var phi_21727_: bool;
    var phi_21728_: bool;
    var phi_21733_: f32;
    var phi_21735_: f32;
    var phi_21738_: f32;
    var phi_21739_: f32;
    var phi_21740_: bool;
    var phi_21742_: f32;
    var phi_21743_: f32;
    var phi_21744_: f32;
    var phi_21746_: bool;
    var phi_21747_: bool;
    var phi_21749_: bool;
    var phi_21750_: f32;
    var phi_21751_: f32;
    var phi_21752_: f32;
    var phi_21754_: bool;
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
    var phi_21853_: f32;
    var phi_21926_: f32;
    var phi_21931_: f32;
    var phi_22004_: f32;
    var phi_22077_: f32;
    var phi_22082_: f32;
    var phi_22098_: f32;
    var phi_22099_: f32;
    var phi_22100_: f32;
    var phi_21780_: bool;
    var phi_22102_: u32;
    var phi_22103_: f32;
    var phi_22104_: bool;
    var phi_22105_: bool;
    var phi_22106_: bool;
    var phi_22107_: u32;
    var phi_22108_: f32;
    var phi_22109_: f32;
    var phi_22110_: f32;
    var phi_22111_: f32;
    var phi_22112_: bool;
    var phi_22113_: u32;
    var phi_22114_: bool;
    var phi_22115_: bool;
    var phi_22116_: bool;
    var phi_22117_: bool;
    var phi_22119_: bool;
    var phi_22128_: f32;
    var phi_22133_: f32;
    var phi_22142_: bool;
    var phi_22146_: bool;
    var phi_22147_: f32;
    var phi_22148_: f32;
    var phi_22149_: f32;
    var phi_22150_: f32;
    var phi_22151_: bool;
    var phi_22152_: u32;
    var phi_22153_: bool;
    var phi_22154_: bool;
    var phi_22155_: bool;
    var phi_22156_: bool;
    var phi_22158_: bool;
    var phi_19980_: f32;
    var phi_19982_: f32;
    var phi_19984_: f32;
    var phi_19986_: f32;
    var phi_19988_: bool;
    var phi_19990_: u32;
    var phi_22159_: f32;
    var phi_22161_: bool;
    var phi_22162_: bool;
    var phi_22163_: bool;
    var phi_22164_: bool;
    var phi_22166_: bool;
    var phi_22167_: bool;
    var local_95: bool;
    var phi_22171_: bool;
    var phi_22172_: bool;
    var phi_22174_: bool;
    var phi_22175_: bool;
    var local_96: f32;
    var phi_22180_: type_44;
    var phi_22181_: bool;
    var phi_22183_: bool;
    var phi_22184_: bool;
    var phi_22185_: bool;
    var phi_22190_: type_44;
    var phi_22192_: bool;
    var phi_22193_: bool;
    var phi_22194_: bool;
    var phi_22195_: bool;
    var phi_22207_: f32;
    var phi_22208_: bool;
    var phi_22209_: bool;
    var phi_22210_: bool;
    var phi_22215_: type_44;
    var phi_22216_: bool;
    var phi_22217_: bool;
    var phi_22222_: type_44;
    var phi_22223_: bool;
    var phi_22227_: type_44;
    var phi_22234_: bool;
    var phi_22235_: f32;
    var phi_22236_: bool;
    var phi_22237_: bool;
    var phi_22238_: bool;
    var phi_22239_: bool;
    var phi_22240_: f32;
    var phi_22241_: f32;
    var phi_22242_: bool;
    var phi_22243_: bool;
    var phi_22244_: bool;
    var phi_22245_: bool;
    var phi_22246_: f32;
    var phi_22247_: f32;
    var phi_22248_: bool;
    var phi_22249_: bool;
    var phi_22250_: bool;
    var phi_22251_: bool;
    var phi_22255_: bool;
    var phi_22256_: bool;
    var phi_22257_: bool;
    var phi_22258_: type_47;
    var phi_22259_: bool;
    var phi_22260_: f32;
    var phi_22261_: f32;
    var phi_22262_: type_47;
    var phi_22263_: bool;
    var phi_22264_: bool;
    var phi_22265_: bool;
    var phi_22266_: bool;
    var phi_22270_: bool;
    var phi_22271_: bool;
    var phi_22272_: bool;
    var phi_22273_: type_47;
    var phi_22274_: bool;
    var phi_22275_: f32;
    var phi_22276_: f32;
    var phi_22277_: type_47;
    var phi_22278_: bool;
    var phi_22279_: bool;
    var phi_22280_: bool;
    var phi_22281_: bool;
    var local_97: bool;
    var phi_22286_: type_44;
    var phi_22287_: bool;
    var phi_22288_: bool;
    var local_98: bool;
    var local_99: type_47;
    var local_100: f32;
    var local_101: f32;
    var local_102: f32;
    var phi_22302_: type_44;
    var phi_22303_: bool;
    var phi_22304_: type_44;
    var phi_22305_: bool;
    var local_103: f32;
    var phi_22310_: type_44;
    var phi_22311_: type_44;
    var phi_22312_: bool;
    var local_104: type_47;
    var phi_22318_: type_44;
    var phi_22319_: bool;
    var phi_22323_: type_44;
    var phi_22324_: type_44;
    var phi_22325_: bool;
    var phi_22329_: type_44;
    var phi_22330_: type_44;
    var phi_22331_: bool;
    var phi_22335_: type_44;
    var phi_22346_: bool;
    var phi_22347_: bool;
    var phi_22351_: bool;
    var phi_22355_: u32;
    var phi_8314_: type_14;
    var phi_8317_: f32;
    var phi_8338_: bool;
    var phi_8344_: type_15;
    var phi_8315_: type_14;
    var phi_8358_: type_15;
    var phi_8318_: f32;
    var local_105: f32;
    var phi_8307_: f32;
    var phi_8371_: f32;
    var phi_8387_: f32;
    var phi_8394_: f32;
    var phi_8399_: f32;
    var phi_8406_: f32;
    var phi_8411_: f32;
    var phi_8424_: f32;
    var phi_8431_: f32;
    var phi_8436_: f32;
    var phi_8443_: f32;
    var phi_8448_: f32;
    var phi_8453_: f32;
    var phi_8470_: f32;
    var phi_8477_: f32;
    var phi_8482_: f32;
    var phi_8489_: f32;
    var phi_8494_: f32;
    var phi_8508_: f32;
    var phi_8515_: f32;
    var phi_8520_: f32;
    var phi_8527_: f32;
    var phi_8532_: f32;
    var phi_8537_: f32;
    var phi_8554_: f32;
    var phi_8561_: f32;
    var phi_8566_: f32;
    var phi_8573_: f32;
    var phi_8578_: f32;
    var phi_8592_: f32;
    var phi_8599_: f32;
    var phi_8604_: f32;
    var phi_8611_: f32;
    var phi_8616_: f32;
    var phi_8621_: f32;
    var phi_8882_: f32;
    var phi_8889_: f32;
    var phi_8894_: f32;
    var phi_8901_: f32;
    var phi_8906_: f32;
    var phi_8919_: f32;
    var phi_8926_: f32;
    var phi_8931_: f32;
    var phi_8938_: f32;
    var phi_8943_: f32;
    var phi_8948_: f32;
    var phi_8965_: f32;
    var phi_8972_: f32;
    var phi_8977_: f32;
    var phi_8984_: f32;
    var phi_8989_: f32;
    var phi_9003_: f32;
    var phi_9010_: f32;
    var phi_9015_: f32;
    var phi_9022_: f32;
    var phi_9027_: f32;
    var phi_9032_: f32;
    var phi_9049_: f32;
    var phi_9056_: f32;
    var phi_9061_: f32;
    var phi_9068_: f32;
    var phi_9073_: f32;
    var phi_9087_: f32;
    var phi_9094_: f32;
    var phi_9099_: f32;
    var phi_9106_: f32;
    var phi_9111_: f32;
    var phi_9116_: f32;
    var phi_9147_: f32;
    var phi_9153_: f32;
    var phi_9160_: f32;
    var phi_9167_: f32;
    var phi_9173_: f32;
    var phi_9180_: f32;
    var phi_9186_: f32;
    var phi_9192_: f32;
    var phi_9198_: f32;
    var phi_9205_: f32;
    var phi_9212_: f32;
    var phi_9236_: f32;
    var phi_9241_: f32;
    var phi_9246_: f32;
    var phi_9251_: f32;
    var phi_9256_: f32;
    var phi_9261_: f32;
    var phi_9271_: f32;
    var phi_9280_: type_45;
    var phi_9281_: bool;
    var phi_9282_: type_45;
    var phi_9283_: bool;
    var phi_9289_: type_14;
    var phi_9292_: f32;
    var phi_9294_: u32;
    var phi_9296_: f32;
    var phi_9317_: bool;
    var phi_9323_: type_15;
    var phi_9290_: type_14;
    var phi_9337_: type_15;
    var phi_9352_: bool;
    var phi_9353_: bool;
    var phi_9412_: array<f32, 3>;
    var phi_9477_: array<f32, 3>;
    var phi_9499_: f32;
    var phi_9506_: f32;
    var phi_9511_: f32;
    var phi_9518_: f32;
    var phi_9523_: f32;
    var phi_9536_: f32;
    var phi_9543_: f32;
    var phi_9548_: f32;
    var phi_9555_: f32;
    var phi_9560_: f32;
    var phi_9565_: f32;
    var phi_9582_: f32;
    var phi_9589_: f32;
    var phi_9594_: f32;
    var phi_9601_: f32;
    var phi_9606_: f32;
    var phi_9620_: f32;
    var phi_9627_: f32;
    var phi_9632_: f32;
    var phi_9639_: f32;
    var phi_9644_: f32;
    var phi_9649_: f32;
    var phi_9666_: f32;
    var phi_9673_: f32;
    var phi_9678_: f32;
    var phi_9685_: f32;
    var phi_9690_: f32;
    var phi_9704_: f32;
    var phi_9711_: f32;
    var phi_9716_: f32;
    var phi_9723_: f32;
    var phi_9728_: f32;
    var phi_9733_: f32;
    var phi_9774_: type_9;
    var phi_9777_: f32;
    var phi_9779_: f32;
    var phi_9781_: f32;
    var phi_9783_: f32;
    var phi_9785_: bool;
    var phi_9787_: u32;
    var phi_9775_: type_9;
    var phi_9810_: type_9;
    var phi_9924_: f32;
    var phi_9930_: f32;
    var phi_9936_: f32;
    var phi_9938_: array<f32, 3>;
    var phi_9945_: f32;
    var phi_9952_: f32;
    var phi_9960_: f32;
    var phi_10004_: type_14;
    var phi_10007_: f32;
    var phi_10028_: bool;
    var phi_10034_: type_15;
    var phi_10005_: type_14;
    var phi_10048_: type_15;
    var phi_10008_: f32;
    var local_106: f32;
    var phi_9997_: f32;
    var phi_10061_: f32;
    var phi_10127_: f32;
    var phi_10133_: f32;
    var phi_10142_: f32;
    var phi_10148_: f32;
    var phi_10157_: f32;
    var phi_10163_: f32;
    var phi_10172_: f32;
    var phi_10178_: f32;
    var phi_10184_: type_29;
    var phi_10185_: bool;
    var phi_10186_: type_29;
    var phi_10187_: bool;
    var phi_10195_: type_29;
    var phi_10366_: bool;
    var phi_10367_: bool;
    var phi_10368_: bool;
    var phi_10369_: bool;
    var phi_10370_: bool;
    var phi_10371_: bool;
    var phi_10375_: bool;
    var phi_10672_: bool;
    var phi_10673_: bool;
    var phi_10674_: bool;
    var phi_10675_: bool;
    var phi_10676_: bool;
    var phi_10677_: bool;
    var phi_10681_: bool;
    var phi_10685_: bool;
    var phi_10696_: bool;
    var phi_10697_: bool;
    var phi_10771_: bool;
    var phi_10772_: bool;
    var phi_10792_: f32;
    var phi_10793_: bool;
    var phi_10794_: f32;
    var phi_10795_: bool;
    var phi_10796_: f32;
    var phi_10797_: bool;
    var phi_10798_: bool;
    var phi_10802_: f32;
    var phi_10803_: bool;
    var phi_10807_: f32;
    var phi_10839_: bool;
    var phi_10840_: bool;
    var phi_10860_: f32;
    var phi_10861_: bool;
    var phi_10862_: f32;
    var phi_10863_: bool;
    var phi_10864_: f32;
    var phi_10865_: bool;
    var phi_10866_: bool;
    var phi_10870_: f32;
    var phi_10871_: bool;
    var phi_10875_: f32;
    var phi_10880_: f32;
    var phi_10912_: bool;
    var phi_10913_: bool;
    var phi_10933_: f32;
    var phi_10934_: bool;
    var phi_10935_: f32;
    var phi_10936_: bool;
    var phi_10937_: f32;
    var phi_10938_: bool;
    var phi_10939_: bool;
    var phi_10943_: f32;
    var phi_10944_: bool;
    var phi_10948_: f32;
    var phi_10980_: bool;
    var phi_10981_: bool;
    var phi_11001_: f32;
    var phi_11002_: bool;
    var phi_11003_: f32;
    var phi_11004_: bool;
    var phi_11005_: f32;
    var phi_11006_: bool;
    var phi_11007_: bool;
    var phi_11011_: f32;
    var phi_11012_: bool;
    var phi_11016_: f32;
    var phi_11021_: f32;
    var phi_11026_: f32;
    var phi_11031_: f32;
    var phi_11044_: f32;
    var phi_11181_: type_14;
    var phi_11184_: f32;
    var phi_11205_: bool;
    var phi_11211_: type_15;
    var phi_11182_: type_14;
    var phi_11225_: type_15;
    var phi_11185_: f32;
    var local_107: f32;
    var phi_11174_: f32;
    var phi_11238_: f32;
    var phi_11254_: f32;
    var phi_11261_: f32;
    var phi_11266_: f32;
    var phi_11273_: f32;
    var phi_11278_: f32;
    var phi_11291_: f32;
    var phi_11298_: f32;
    var phi_11303_: f32;
    var phi_11310_: f32;
    var phi_11315_: f32;
    var phi_11320_: f32;
    var phi_11337_: f32;
    var phi_11344_: f32;
    var phi_11349_: f32;
    var phi_11356_: f32;
    var phi_11361_: f32;
    var phi_11375_: f32;
    var phi_11382_: f32;
    var phi_11387_: f32;
    var phi_11394_: f32;
    var phi_11399_: f32;
    var phi_11404_: f32;
    var phi_11421_: f32;
    var phi_11428_: f32;
    var phi_11433_: f32;
    var phi_11440_: f32;
    var phi_11445_: f32;
    var phi_11459_: f32;
    var phi_11466_: f32;
    var phi_11471_: f32;
    var phi_11478_: f32;
    var phi_11483_: f32;
    var phi_11488_: f32;
    var phi_11508_: bool;
    var phi_11509_: bool;
    var phi_11510_: bool;
    var phi_11525_: bool;
    var phi_11526_: bool;
    var phi_11531_: f32;
    var phi_11533_: f32;
    var phi_11534_: f32;
    var phi_11535_: bool;
    var phi_11536_: f32;
    var phi_11537_: f32;
    var phi_11538_: bool;
    var phi_11539_: bool;
    var phi_11540_: f32;
    var phi_11541_: f32;
    var phi_11542_: f32;
    var phi_11543_: f32;
    var phi_11544_: bool;
    var phi_11545_: bool;
    var phi_11546_: bool;
    var phi_11547_: bool;
    var phi_11548_: f32;
    var phi_11549_: f32;
    var phi_11550_: f32;
    var phi_11551_: f32;
    var phi_11552_: bool;
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
    var phi_11651_: f32;
    var phi_11724_: f32;
    var phi_11729_: f32;
    var phi_11802_: f32;
    var phi_11875_: f32;
    var phi_11880_: f32;
    var phi_11896_: f32;
    var phi_11897_: f32;
    var phi_11898_: f32;
    var phi_11578_: bool;
    var phi_11900_: u32;
    var phi_11901_: f32;
    var phi_11902_: bool;
    var phi_11903_: bool;
    var phi_11904_: bool;
    var phi_11905_: u32;
    var phi_11906_: f32;
    var phi_11907_: f32;
    var phi_11908_: f32;
    var phi_11909_: f32;
    var phi_11910_: bool;
    var phi_11911_: u32;
    var phi_11912_: bool;
    var phi_11913_: bool;
    var phi_11914_: bool;
    var phi_11915_: bool;
    var phi_11916_: bool;
    var phi_11917_: bool;
    var phi_11926_: f32;
    var phi_11931_: f32;
    var phi_11940_: bool;
    var phi_11944_: bool;
    var phi_11945_: f32;
    var phi_11946_: f32;
    var phi_11947_: f32;
    var phi_11948_: f32;
    var phi_11949_: bool;
    var phi_11950_: u32;
    var phi_11951_: bool;
    var phi_11952_: bool;
    var phi_11953_: bool;
    var phi_11954_: bool;
    var phi_11955_: bool;
    var phi_11956_: bool;
    var phi_9778_: f32;
    var phi_9780_: f32;
    var phi_9782_: f32;
    var phi_9784_: f32;
    var phi_9786_: bool;
    var phi_9788_: u32;
    var phi_11957_: f32;
    var phi_11958_: f32;
    var phi_11959_: bool;
    var phi_11960_: bool;
    var phi_11961_: bool;
    var phi_11962_: bool;
    var phi_11963_: bool;
    var phi_11964_: bool;
    var phi_11965_: bool;
    var local_108: bool;
    var phi_11969_: bool;
    var phi_11970_: bool;
    var phi_11971_: bool;
    var phi_11972_: bool;
    var phi_11973_: bool;
    var local_109: f32;
    var phi_11978_: type_44;
    var phi_11979_: bool;
    var phi_11980_: bool;
    var phi_11981_: bool;
    var phi_11982_: bool;
    var phi_11983_: bool;
    var phi_11988_: type_44;
    var phi_11989_: bool;
    var phi_11990_: bool;
    var phi_11991_: bool;
    var phi_11992_: bool;
    var phi_11993_: bool;
    var phi_11997_: f32;
    var phi_11998_: bool;
    var phi_11999_: bool;
    var phi_12000_: bool;
    var phi_12001_: bool;
    var phi_12005_: f32;
    var phi_12006_: bool;
    var phi_12007_: bool;
    var phi_12008_: bool;
    var phi_12013_: type_44;
    var phi_12014_: bool;
    var phi_12015_: bool;
    var phi_12020_: type_44;
    var phi_12021_: bool;
    var phi_12025_: type_44;
    var phi_12032_: f32;
    var phi_12033_: bool;
    var phi_12145_: f32;
    var phi_12152_: f32;
    var phi_12160_: f32;
    var phi_12218_: array<f32, 3>;
    var phi_12286_: array<f32, 3>;
    var phi_12311_: f32;
    var phi_12318_: f32;
    var phi_12323_: f32;
    var phi_12330_: f32;
    var phi_12335_: f32;
    var phi_12348_: f32;
    var phi_12355_: f32;
    var phi_12360_: f32;
    var phi_12367_: f32;
    var phi_12372_: f32;
    var phi_12377_: f32;
    var phi_12394_: f32;
    var phi_12401_: f32;
    var phi_12406_: f32;
    var phi_12413_: f32;
    var phi_12418_: f32;
    var phi_12432_: f32;
    var phi_12439_: f32;
    var phi_12444_: f32;
    var phi_12451_: f32;
    var phi_12456_: f32;
    var phi_12461_: f32;
    var phi_12478_: f32;
    var phi_12485_: f32;
    var phi_12490_: f32;
    var phi_12497_: f32;
    var phi_12502_: f32;
    var phi_12516_: f32;
    var phi_12523_: f32;
    var phi_12528_: f32;
    var phi_12535_: f32;
    var phi_12540_: f32;
    var phi_12545_: f32;
    var phi_12653_: type_14;
    var phi_12656_: f32;
    var phi_12677_: bool;
    var phi_12683_: type_15;
    var phi_12654_: type_14;
    var phi_12697_: type_15;
    var phi_12657_: f32;
    var local_110: f32;
    var phi_12646_: f32;
    var phi_12710_: f32;
    var phi_12844_: f32;
    var phi_12850_: f32;
    var phi_12859_: f32;
    var phi_12865_: f32;
    var phi_12874_: f32;
    var phi_12880_: f32;
    var phi_12889_: f32;
    var phi_12895_: f32;
    var phi_12945_: type_14;
    var phi_12948_: f32;
    var phi_12969_: bool;
    var phi_12975_: type_15;
    var phi_12946_: type_14;
    var phi_12989_: type_15;
    var phi_12949_: f32;
    var local_111: f32;
    var phi_12938_: f32;
    var phi_13002_: f32;
    var phi_13034_: type_14;
    var phi_13037_: f32;
    var phi_13058_: bool;
    var phi_13064_: type_15;
    var phi_13035_: type_14;
    var phi_13078_: type_15;
    var phi_13038_: f32;
    var local_112: f32;
    var phi_13027_: f32;
    var phi_13091_: f32;
    var phi_13107_: f32;
    var phi_13114_: f32;
    var phi_13119_: f32;
    var phi_13126_: f32;
    var phi_13131_: f32;
    var phi_13144_: f32;
    var phi_13151_: f32;
    var phi_13156_: f32;
    var phi_13163_: f32;
    var phi_13168_: f32;
    var phi_13173_: f32;
    var phi_13190_: f32;
    var phi_13197_: f32;
    var phi_13202_: f32;
    var phi_13209_: f32;
    var phi_13214_: f32;
    var phi_13228_: f32;
    var phi_13235_: f32;
    var phi_13240_: f32;
    var phi_13247_: f32;
    var phi_13252_: f32;
    var phi_13257_: f32;
    var phi_13274_: f32;
    var phi_13281_: f32;
    var phi_13286_: f32;
    var phi_13293_: f32;
    var phi_13298_: f32;
    var phi_13312_: f32;
    var phi_13319_: f32;
    var phi_13324_: f32;
    var phi_13331_: f32;
    var phi_13336_: f32;
    var phi_13341_: f32;
    var phi_13382_: f32;
    var phi_13388_: f32;
    var phi_13399_: type_9;
    var phi_13402_: f32;
    var phi_13400_: type_9;
    var phi_13425_: type_9;
    var phi_13454_: f32;
    var phi_13460_: f32;
    var phi_13473_: f32;
    var phi_13403_: f32;
    var local_113: f32;
    var local_114: f32;
    var phi_13501_: type_14;
    var phi_13504_: f32;
    var phi_13525_: bool;
    var phi_13531_: type_15;
    var phi_13502_: type_14;
    var phi_13545_: type_15;
    var phi_13505_: f32;
    var local_115: f32;
    var phi_13494_: f32;
    var phi_13558_: f32;
    var phi_13563_: type_9;
    var phi_13566_: f32;
    var phi_13568_: bool;
    var phi_13570_: bool;
    var phi_13564_: type_9;
    var phi_13593_: type_9;
    var phi_13630_: f32;
    var phi_13637_: f32;
    var phi_13645_: f32;
    var phi_13653_: f32;
    var phi_13660_: f32;
    var phi_13668_: f32;
    var phi_13674_: f32;
    var phi_13692_: f32;
    var phi_13698_: f32;
    var phi_13705_: f32;
    var phi_13731_: f32;
    var phi_13737_: f32;
    var phi_13773_: bool;
    var phi_13780_: bool;
    var phi_13793_: f32;
    var phi_13799_: f32;
    var phi_13800_: f32;
    var phi_13801_: f32;
    var phi_13567_: f32;
    var phi_13569_: bool;
    var phi_13571_: bool;
    var local_116: f32;
    var phi_13806_: f32;
    var local_117: bool;
    var local_118: bool;
    var phi_13815_: type_46;
    var phi_13816_: type_46;
    var phi_13817_: bool;
    var local_119: bool;
    var phi_13834_: f32;
    var phi_13835_: f32;
    var phi_13838_: type_9;
    var phi_13841_: f32;
    var phi_13843_: f32;
    var phi_13839_: type_9;
    var phi_13866_: type_9;
    var phi_13949_: f32;
    var phi_13950_: f32;
    var phi_13951_: f32;
    var phi_13934_: f32;
    var phi_13952_: f32;
    var phi_13953_: f32;
    var phi_13842_: f32;
    var phi_13844_: f32;
    var local_120: f32;
    var local_121: f32;
    var local_122: f32;
    var phi_14114_: bool;
    var phi_14115_: bool;
    var phi_14116_: bool;
    var phi_14117_: bool;
    var phi_14118_: bool;
    var phi_14119_: bool;
    var phi_14123_: bool;
    var phi_14127_: bool;
    var phi_14128_: bool;
    var phi_14129_: bool;
    var phi_14133_: f32;
    var phi_14136_: type_46;
    var phi_14137_: type_46;
    var phi_14138_: bool;
    var phi_14139_: type_46;
    var phi_14140_: type_46;
    var phi_14141_: bool;
    var phi_14146_: type_46;
    var phi_14147_: type_46;
    var phi_14148_: bool;
    var phi_14152_: type_46;
    var phi_14153_: type_46;
    var phi_14154_: bool;
    var phi_14155_: bool;
    var phi_14156_: type_46;
    var phi_14157_: type_46;
    var phi_14158_: bool;
    var phi_14159_: bool;
    var phi_14164_: type_46;
    var phi_14165_: bool;
    var phi_14169_: type_46;
    var phi_14185_: f32;
    var phi_14186_: f32;
    var phi_14187_: bool;
    var phi_14188_: f32;
    var phi_14189_: f32;
    var phi_14190_: bool;
    var phi_14191_: bool;
    var phi_14192_: bool;
    var phi_14193_: f32;
    var phi_14194_: f32;
    var phi_14195_: bool;
    var phi_14196_: bool;
    var phi_14197_: bool;
    var phi_14198_: f32;
    var phi_14199_: u32;
    var phi_14200_: f32;
    var phi_14201_: type_46;
    var phi_14202_: u32;
    var phi_14203_: u32;
    var phi_14204_: bool;
    var phi_14205_: bool;
    var phi_14206_: bool;
    var phi_14207_: f32;
    var phi_14208_: u32;
    var phi_14209_: f32;
    var phi_14210_: type_46;
    var phi_14211_: u32;
    var phi_14212_: u32;
    var phi_14213_: bool;
    var phi_14214_: bool;
    var phi_14215_: bool;
    var phi_14216_: bool;
    var phi_14217_: bool;
    var phi_14218_: f32;
    var phi_9293_: f32;
    var phi_9295_: u32;
    var phi_9297_: f32;
    var phi_14219_: type_46;
    var phi_14220_: u32;
    var phi_14221_: f32;
    var phi_14222_: u32;
    var phi_14223_: bool;
    var phi_14224_: bool;
    var phi_14225_: bool;
    var phi_14226_: bool;
    var phi_14227_: bool;
    var phi_14228_: bool;
    var local_123: bool;
    var phi_14232_: bool;
    var phi_14233_: bool;
    var phi_14234_: bool;
    var phi_14235_: bool;
    var local_124: type_46;
    var local_125: type_46;
    var phi_14252_: u32;
    var local_126: type_46;
    var phi_14257_: type_45;
    var phi_14258_: type_45;
    var phi_14259_: bool;
    var phi_14260_: bool;
    var phi_14261_: bool;
    var phi_14262_: bool;
    var phi_14266_: u32;
    var phi_14267_: f32;
    var phi_14268_: bool;
    var phi_14269_: bool;
    var phi_14270_: bool;
    var phi_14271_: bool;
    var phi_14275_: f32;
    var phi_14276_: u32;
    var phi_14277_: bool;
    var phi_14278_: bool;
    var phi_14279_: bool;
    var phi_14291_: f32;
    var phi_14294_: type_9;
    var phi_14295_: type_9;
    var phi_14318_: type_9;
    var phi_14339_: f32;
    var phi_14469_: type_14;
    var phi_14472_: f32;
    var phi_14493_: bool;
    var phi_14499_: type_15;
    var phi_14470_: type_14;
    var phi_14513_: type_15;
    var phi_14473_: f32;
    var local_127: f32;
    var phi_14462_: f32;
    var phi_14526_: f32;
    var phi_14542_: f32;
    var phi_14549_: f32;
    var phi_14554_: f32;
    var phi_14561_: f32;
    var phi_14566_: f32;
    var phi_14579_: f32;
    var phi_14586_: f32;
    var phi_14591_: f32;
    var phi_14598_: f32;
    var phi_14603_: f32;
    var phi_14608_: f32;
    var phi_14625_: f32;
    var phi_14632_: f32;
    var phi_14637_: f32;
    var phi_14644_: f32;
    var phi_14649_: f32;
    var phi_14663_: f32;
    var phi_14670_: f32;
    var phi_14675_: f32;
    var phi_14682_: f32;
    var phi_14687_: f32;
    var phi_14692_: f32;
    var phi_14709_: f32;
    var phi_14716_: f32;
    var phi_14721_: f32;
    var phi_14728_: f32;
    var phi_14733_: f32;
    var phi_14747_: f32;
    var phi_14754_: f32;
    var phi_14759_: f32;
    var phi_14766_: f32;
    var phi_14771_: f32;
    var phi_14776_: f32;
    var phi_14796_: bool;
    var phi_14797_: bool;
    var phi_14798_: bool;
    var local_128: bool;
    var phi_14806_: u32;
    var phi_14810_: type_45;
    var phi_14811_: bool;
    var phi_14819_: u32;
    var phi_14823_: type_45;
    var phi_14824_: type_45;
    var phi_14825_: bool;
    var phi_14826_: bool;
    var phi_14833_: type_45;
    var phi_14834_: bool;
    var phi_14838_: type_45;
    var phi_14839_: type_45;
    var phi_14840_: bool;
    var phi_14844_: type_45;
    var phi_22359_: type_45;
    var phi_22377_: type_28;
    var phi_22393_: array<u32, 2>;
    var phi_22414_: array<u32, 2>;
    var phi_22417_: bool;
    var phi_22432_: bool;
    var phi_22433_: bool;
    var phi_22441_: bool;
    var phi_22442_: bool;
    var phi_22447_: u32;
    var phi_22452_: type_28;
    var phi_22459_: bool;
    var phi_22484_: u32;
    var phi_22488_: type_20;
    var phi_22489_: bool;
    var phi_22490_: bool;
    var phi_22509_: u32;
    var phi_22576_: u32;
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
                let _e721 = bitcast<i32>(((bitcast<u32>(_e716) + 4u) >> bitcast<u32>(23i)));
                if (_e721 >= 64i) {
                    if (_e721 <= 190i) {
                        phi_1232_ = (_e721 - 126i);
                        phi_1233_ = false;
                    } else {
                        phi_1232_ = i32();
                        phi_1233_ = true;
                    }
                    let _e726 = phi_1232_;
                    let _e728 = phi_1233_;
                    phi_1234_ = _e726;
                    phi_1235_ = _e728;
                } else {
                    phi_1234_ = i32();
                    phi_1235_ = true;
                }
                let _e730 = phi_1234_;
                let _e732 = phi_1235_;
                if _e732 {
                    phi_1239_ = 2147483647i;
                } else {
                    phi_1239_ = _e730;
                }
                let _e734 = phi_1239_;
                let _e736 = params.member.member_2.member_3;
                if (_e736 > 0u) {
                    if (_e734 != 2147483647i) {
                        let _e740 = params.member.member.member_1;
                        if ((_e740 & 8u) != 0u) {
                            let _e1037 = local_59[0u];
                            let _e1041 = bitcast<u32>(_e1037[0]);
                            let _e1042 = (_e1041 & 2147483647u);
                            if (_e1042 < 8388608u) {
                                phi_1281_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1281_ = array<u32, 2>((_e1041 << bitcast<u32>(29i)), ((_e1041 ^ _e1042) | ((_e1042 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1053 = phi_1281_;
                            let _e1054 = function_12(_e1053, _e734);
                            let _e1055 = bitcast<u32>(_e1037[1]);
                            let _e1056 = (_e1055 & 2147483647u);
                            if (_e1056 < 8388608u) {
                                phi_1298_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1298_ = array<u32, 2>((_e1055 << bitcast<u32>(29i)), ((_e1055 ^ _e1056) | ((_e1056 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1067 = phi_1298_;
                            let _e1068 = function_12(_e1067, _e734);
                            let _e1069 = bitcast<u32>(_e1037[2]);
                            let _e1070 = (_e1069 & 2147483647u);
                            if (_e1070 < 8388608u) {
                                phi_1315_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1315_ = array<u32, 2>((_e1069 << bitcast<u32>(29i)), ((_e1069 ^ _e1070) | ((_e1070 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1081 = phi_1315_;
                            let _e1082 = function_12(_e1081, _e734);
                            let _e1088 = local_60[0u];
                            let _e1092 = bitcast<u32>(_e1088[0]);
                            let _e1093 = (_e1092 & 2147483647u);
                            if (_e1093 < 8388608u) {
                                phi_1349_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1349_ = array<u32, 2>((_e1092 << bitcast<u32>(29i)), ((_e1092 ^ _e1093) | ((_e1093 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1104 = phi_1349_;
                            let _e1105 = function_12(_e1104, _e734);
                            let _e1106 = bitcast<u32>(_e1088[1]);
                            let _e1107 = (_e1106 & 2147483647u);
                            if (_e1107 < 8388608u) {
                                phi_1366_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1366_ = array<u32, 2>((_e1106 << bitcast<u32>(29i)), ((_e1106 ^ _e1107) | ((_e1107 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1118 = phi_1366_;
                            let _e1119 = function_12(_e1118, _e734);
                            let _e1120 = bitcast<u32>(_e1088[2]);
                            let _e1121 = (_e1120 & 2147483647u);
                            if (_e1121 < 8388608u) {
                                phi_1383_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1383_ = array<u32, 2>((_e1120 << bitcast<u32>(29i)), ((_e1120 ^ _e1121) | ((_e1121 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1132 = phi_1383_;
                            let _e1133 = function_12(_e1132, _e734);
                            let _e1140 = local_59[1u];
                            let _e1144 = bitcast<u32>(_e1140[0]);
                            let _e1145 = (_e1144 & 2147483647u);
                            if (_e1145 < 8388608u) {
                                phi_1418_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1418_ = array<u32, 2>((_e1144 << bitcast<u32>(29i)), ((_e1144 ^ _e1145) | ((_e1145 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1156 = phi_1418_;
                            let _e1157 = function_12(_e1156, _e734);
                            let _e1158 = bitcast<u32>(_e1140[1]);
                            let _e1159 = (_e1158 & 2147483647u);
                            if (_e1159 < 8388608u) {
                                phi_1435_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1435_ = array<u32, 2>((_e1158 << bitcast<u32>(29i)), ((_e1158 ^ _e1159) | ((_e1159 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1170 = phi_1435_;
                            let _e1171 = function_12(_e1170, _e734);
                            let _e1172 = bitcast<u32>(_e1140[2]);
                            let _e1173 = (_e1172 & 2147483647u);
                            if (_e1173 < 8388608u) {
                                phi_1452_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1452_ = array<u32, 2>((_e1172 << bitcast<u32>(29i)), ((_e1172 ^ _e1173) | ((_e1173 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1184 = phi_1452_;
                            let _e1185 = function_12(_e1184, _e734);
                            let _e1191 = local_60[1u];
                            let _e1195 = bitcast<u32>(_e1191[0]);
                            let _e1196 = (_e1195 & 2147483647u);
                            if (_e1196 < 8388608u) {
                                phi_1486_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1486_ = array<u32, 2>((_e1195 << bitcast<u32>(29i)), ((_e1195 ^ _e1196) | ((_e1196 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1207 = phi_1486_;
                            let _e1208 = function_12(_e1207, _e734);
                            let _e1209 = bitcast<u32>(_e1191[1]);
                            let _e1210 = (_e1209 & 2147483647u);
                            if (_e1210 < 8388608u) {
                                phi_1503_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1503_ = array<u32, 2>((_e1209 << bitcast<u32>(29i)), ((_e1209 ^ _e1210) | ((_e1210 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1221 = phi_1503_;
                            let _e1222 = function_12(_e1221, _e734);
                            let _e1223 = bitcast<u32>(_e1191[2]);
                            let _e1224 = (_e1223 & 2147483647u);
                            if (_e1224 < 8388608u) {
                                phi_1520_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1520_ = array<u32, 2>((_e1223 << bitcast<u32>(29i)), ((_e1223 ^ _e1224) | ((_e1224 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1235 = phi_1520_;
                            let _e1236 = function_12(_e1235, _e734);
                            let _e1243 = local_59[2u];
                            let _e1247 = bitcast<u32>(_e1243[0]);
                            let _e1248 = (_e1247 & 2147483647u);
                            if (_e1248 < 8388608u) {
                                phi_1555_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1555_ = array<u32, 2>((_e1247 << bitcast<u32>(29i)), ((_e1247 ^ _e1248) | ((_e1248 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1259 = phi_1555_;
                            let _e1260 = function_12(_e1259, _e734);
                            let _e1261 = bitcast<u32>(_e1243[1]);
                            let _e1262 = (_e1261 & 2147483647u);
                            if (_e1262 < 8388608u) {
                                phi_1572_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1572_ = array<u32, 2>((_e1261 << bitcast<u32>(29i)), ((_e1261 ^ _e1262) | ((_e1262 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1273 = phi_1572_;
                            let _e1274 = function_12(_e1273, _e734);
                            let _e1275 = bitcast<u32>(_e1243[2]);
                            let _e1276 = (_e1275 & 2147483647u);
                            if (_e1276 < 8388608u) {
                                phi_1589_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1589_ = array<u32, 2>((_e1275 << bitcast<u32>(29i)), ((_e1275 ^ _e1276) | ((_e1276 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1287 = phi_1589_;
                            let _e1288 = function_12(_e1287, _e734);
                            let _e1294 = local_60[2u];
                            let _e1298 = bitcast<u32>(_e1294[0]);
                            let _e1299 = (_e1298 & 2147483647u);
                            if (_e1299 < 8388608u) {
                                phi_1623_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1623_ = array<u32, 2>((_e1298 << bitcast<u32>(29i)), ((_e1298 ^ _e1299) | ((_e1299 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1310 = phi_1623_;
                            let _e1311 = function_12(_e1310, _e734);
                            let _e1312 = bitcast<u32>(_e1294[1]);
                            let _e1313 = (_e1312 & 2147483647u);
                            if (_e1313 < 8388608u) {
                                phi_1640_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1640_ = array<u32, 2>((_e1312 << bitcast<u32>(29i)), ((_e1312 ^ _e1313) | ((_e1313 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1324 = phi_1640_;
                            let _e1325 = function_12(_e1324, _e734);
                            let _e1326 = bitcast<u32>(_e1294[2]);
                            let _e1327 = (_e1326 & 2147483647u);
                            if (_e1327 < 8388608u) {
                                phi_1657_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1657_ = array<u32, 2>((_e1326 << bitcast<u32>(29i)), ((_e1326 ^ _e1327) | ((_e1327 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1338 = phi_1657_;
                            let _e1339 = function_12(_e1338, _e734);
                            let _e1346 = local_59[3u];
                            let _e1350 = bitcast<u32>(_e1346[0]);
                            let _e1351 = (_e1350 & 2147483647u);
                            if (_e1351 < 8388608u) {
                                phi_1692_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1692_ = array<u32, 2>((_e1350 << bitcast<u32>(29i)), ((_e1350 ^ _e1351) | ((_e1351 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1362 = phi_1692_;
                            let _e1363 = function_12(_e1362, _e734);
                            let _e1364 = bitcast<u32>(_e1346[1]);
                            let _e1365 = (_e1364 & 2147483647u);
                            if (_e1365 < 8388608u) {
                                phi_1709_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1709_ = array<u32, 2>((_e1364 << bitcast<u32>(29i)), ((_e1364 ^ _e1365) | ((_e1365 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1376 = phi_1709_;
                            let _e1377 = function_12(_e1376, _e734);
                            let _e1378 = bitcast<u32>(_e1346[2]);
                            let _e1379 = (_e1378 & 2147483647u);
                            if (_e1379 < 8388608u) {
                                phi_1726_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1726_ = array<u32, 2>((_e1378 << bitcast<u32>(29i)), ((_e1378 ^ _e1379) | ((_e1379 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1390 = phi_1726_;
                            let _e1391 = function_12(_e1390, _e734);
                            let _e1397 = local_60[3u];
                            let _e1401 = bitcast<u32>(_e1397[0]);
                            let _e1402 = (_e1401 & 2147483647u);
                            if (_e1402 < 8388608u) {
                                phi_1760_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1760_ = array<u32, 2>((_e1401 << bitcast<u32>(29i)), ((_e1401 ^ _e1402) | ((_e1402 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1413 = phi_1760_;
                            let _e1414 = function_12(_e1413, _e734);
                            let _e1415 = bitcast<u32>(_e1397[1]);
                            let _e1416 = (_e1415 & 2147483647u);
                            if (_e1416 < 8388608u) {
                                phi_1777_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1777_ = array<u32, 2>((_e1415 << bitcast<u32>(29i)), ((_e1415 ^ _e1416) | ((_e1416 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1427 = phi_1777_;
                            let _e1428 = function_12(_e1427, _e734);
                            let _e1429 = bitcast<u32>(_e1397[2]);
                            let _e1430 = (_e1429 & 2147483647u);
                            if (_e1430 < 8388608u) {
                                phi_1794_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1794_ = array<u32, 2>((_e1429 << bitcast<u32>(29i)), ((_e1429 ^ _e1430) | ((_e1430 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1441 = phi_1794_;
                            let _e1442 = function_12(_e1441, _e734);
                            phi_2711_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e1054, _e1068, type_9(_e1082.member, _e1082.member_1)), array<type_9, 3>(_e1105, _e1119, type_9(_e1133.member, _e1133.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1157, _e1171, type_9(_e1185.member, _e1185.member_1)), array<type_9, 3>(_e1208, _e1222, type_9(_e1236.member, _e1236.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1260, _e1274, type_9(_e1288.member, _e1288.member_1)), array<type_9, 3>(_e1311, _e1325, type_9(_e1339.member, _e1339.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1363, _e1377, type_9(_e1391.member, _e1391.member_1)), array<type_9, 3>(_e1414, _e1428, type_9(_e1442.member, _e1442.member_1))));
                        } else {
                            let _e745 = params.member.member.member_10[1u];
                            local_61 = (_e734 - (bitcast<i32>((_e745 >> bitcast<u32>(20i))) - 1023i));
                            let _e752 = local_58[0u];
                            let _e755 = params.member.member.member[0u];
                            let _e757 = (6u * (_e755 + _e752));
                            let _e758 = (6u * _e752);
                            let _e759 = local_61;
                            local_57 = _e759;
                            let _e761 = positions.member[_e758];
                            let _e764 = positions.member[(_e758 + 1u)];
                            let _e766 = local_57;
                            let _e767 = function_12(array<u32, 2>(_e761, _e764), _e766);
                            let _e770 = positions.member[(_e758 + 2u)];
                            let _e773 = positions.member[(_e758 + 3u)];
                            let _e775 = local_57;
                            let _e776 = function_12(array<u32, 2>(_e770, _e773), _e775);
                            let _e779 = positions.member[(_e758 + 4u)];
                            let _e782 = positions.member[(_e758 + 5u)];
                            let _e784 = local_57;
                            let _e785 = function_12(array<u32, 2>(_e779, _e782), _e784);
                            let _e790 = local_61;
                            local_56 = _e790;
                            let _e792 = positions.member[_e757];
                            let _e795 = positions.member[(_e757 + 1u)];
                            let _e797 = local_56;
                            let _e798 = function_12(array<u32, 2>(_e792, _e795), _e797);
                            let _e801 = positions.member[(_e757 + 2u)];
                            let _e804 = positions.member[(_e757 + 3u)];
                            let _e806 = local_56;
                            let _e807 = function_12(array<u32, 2>(_e801, _e804), _e806);
                            let _e810 = positions.member[(_e757 + 4u)];
                            let _e813 = positions.member[(_e757 + 5u)];
                            let _e815 = local_56;
                            let _e816 = function_12(array<u32, 2>(_e810, _e813), _e815);
                            let _e823 = local_58[1u];
                            let _e826 = params.member.member.member[0u];
                            let _e828 = (6u * (_e826 + _e823));
                            let _e829 = (6u * _e823);
                            let _e830 = local_61;
                            local_55 = _e830;
                            let _e832 = positions.member[_e829];
                            let _e835 = positions.member[(_e829 + 1u)];
                            let _e837 = local_55;
                            let _e838 = function_12(array<u32, 2>(_e832, _e835), _e837);
                            let _e841 = positions.member[(_e829 + 2u)];
                            let _e844 = positions.member[(_e829 + 3u)];
                            let _e846 = local_55;
                            let _e847 = function_12(array<u32, 2>(_e841, _e844), _e846);
                            let _e850 = positions.member[(_e829 + 4u)];
                            let _e853 = positions.member[(_e829 + 5u)];
                            let _e855 = local_55;
                            let _e856 = function_12(array<u32, 2>(_e850, _e853), _e855);
                            let _e861 = local_61;
                            local_54 = _e861;
                            let _e863 = positions.member[_e828];
                            let _e866 = positions.member[(_e828 + 1u)];
                            let _e868 = local_54;
                            let _e869 = function_12(array<u32, 2>(_e863, _e866), _e868);
                            let _e872 = positions.member[(_e828 + 2u)];
                            let _e875 = positions.member[(_e828 + 3u)];
                            let _e877 = local_54;
                            let _e878 = function_12(array<u32, 2>(_e872, _e875), _e877);
                            let _e881 = positions.member[(_e828 + 4u)];
                            let _e884 = positions.member[(_e828 + 5u)];
                            let _e886 = local_54;
                            let _e887 = function_12(array<u32, 2>(_e881, _e884), _e886);
                            let _e894 = local_58[2u];
                            let _e897 = params.member.member.member[0u];
                            let _e899 = (6u * (_e897 + _e894));
                            let _e900 = (6u * _e894);
                            let _e901 = local_61;
                            local_53 = _e901;
                            let _e903 = positions.member[_e900];
                            let _e906 = positions.member[(_e900 + 1u)];
                            let _e908 = local_53;
                            let _e909 = function_12(array<u32, 2>(_e903, _e906), _e908);
                            let _e912 = positions.member[(_e900 + 2u)];
                            let _e915 = positions.member[(_e900 + 3u)];
                            let _e917 = local_53;
                            let _e918 = function_12(array<u32, 2>(_e912, _e915), _e917);
                            let _e921 = positions.member[(_e900 + 4u)];
                            let _e924 = positions.member[(_e900 + 5u)];
                            let _e926 = local_53;
                            let _e927 = function_12(array<u32, 2>(_e921, _e924), _e926);
                            let _e932 = local_61;
                            local_52 = _e932;
                            let _e934 = positions.member[_e899];
                            let _e937 = positions.member[(_e899 + 1u)];
                            let _e939 = local_52;
                            let _e940 = function_12(array<u32, 2>(_e934, _e937), _e939);
                            let _e943 = positions.member[(_e899 + 2u)];
                            let _e946 = positions.member[(_e899 + 3u)];
                            let _e948 = local_52;
                            let _e949 = function_12(array<u32, 2>(_e943, _e946), _e948);
                            let _e952 = positions.member[(_e899 + 4u)];
                            let _e955 = positions.member[(_e899 + 5u)];
                            let _e957 = local_52;
                            let _e958 = function_12(array<u32, 2>(_e952, _e955), _e957);
                            let _e965 = local_58[3u];
                            let _e968 = params.member.member.member[0u];
                            let _e970 = (6u * (_e968 + _e965));
                            let _e971 = (6u * _e965);
                            let _e972 = local_61;
                            local_51 = _e972;
                            let _e974 = positions.member[_e971];
                            let _e977 = positions.member[(_e971 + 1u)];
                            let _e979 = local_51;
                            let _e980 = function_12(array<u32, 2>(_e974, _e977), _e979);
                            let _e983 = positions.member[(_e971 + 2u)];
                            let _e986 = positions.member[(_e971 + 3u)];
                            let _e988 = local_51;
                            let _e989 = function_12(array<u32, 2>(_e983, _e986), _e988);
                            let _e992 = positions.member[(_e971 + 4u)];
                            let _e995 = positions.member[(_e971 + 5u)];
                            let _e997 = local_51;
                            let _e998 = function_12(array<u32, 2>(_e992, _e995), _e997);
                            let _e1003 = local_61;
                            local_50 = _e1003;
                            let _e1005 = positions.member[_e970];
                            let _e1008 = positions.member[(_e970 + 1u)];
                            let _e1010 = local_50;
                            let _e1011 = function_12(array<u32, 2>(_e1005, _e1008), _e1010);
                            let _e1014 = positions.member[(_e970 + 2u)];
                            let _e1017 = positions.member[(_e970 + 3u)];
                            let _e1019 = local_50;
                            let _e1020 = function_12(array<u32, 2>(_e1014, _e1017), _e1019);
                            let _e1023 = positions.member[(_e970 + 4u)];
                            let _e1026 = positions.member[(_e970 + 5u)];
                            let _e1028 = local_50;
                            let _e1029 = function_12(array<u32, 2>(_e1023, _e1026), _e1028);
                            phi_2711_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e767, _e776, type_9(_e785.member, _e785.member_1)), array<type_9, 3>(_e798, _e807, type_9(_e816.member, _e816.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e838, _e847, type_9(_e856.member, _e856.member_1)), array<type_9, 3>(_e869, _e878, type_9(_e887.member, _e887.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e909, _e918, type_9(_e927.member, _e927.member_1)), array<type_9, 3>(_e940, _e949, type_9(_e958.member, _e958.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e980, _e989, type_9(_e998.member, _e998.member_1)), array<type_9, 3>(_e1011, _e1020, type_9(_e1029.member, _e1029.member_1))));
                        }
                        let _e1450 = phi_2711_;
                        let _e1452 = params.member.member_2.member_1;
                        let _e1454 = params.member.member_2.member_2;
                        let _e1456 = params.member.member_2.member_3;
                        if (_e316.member != 0u) {
                            if (_e1450[2][0][0].member_1 < _e1450[0][0][0].member_1) {
                                phi_2732_ = 1u;
                            } else {
                                phi_2732_ = 0u;
                            }
                            let _e1776 = phi_2732_;
                            if (_e1450[2][0][1].member_1 < _e1450[0][0][1].member_1) {
                                phi_2744_ = 1u;
                            } else {
                                phi_2744_ = 0u;
                            }
                            let _e1790 = phi_2744_;
                            if (_e1450[2][0][2].member_1 < _e1450[0][0][2].member_1) {
                                phi_2756_ = 1u;
                            } else {
                                phi_2756_ = 0u;
                            }
                            let _e1804 = phi_2756_;
                            if (_e1450[2][1][0].member_1 < _e1450[0][1][0].member_1) {
                                phi_2776_ = 1u;
                            } else {
                                phi_2776_ = 0u;
                            }
                            let _e1826 = phi_2776_;
                            if (_e1450[2][1][1].member_1 < _e1450[0][1][1].member_1) {
                                phi_2788_ = 1u;
                            } else {
                                phi_2788_ = 0u;
                            }
                            let _e1840 = phi_2788_;
                            if (_e1450[2][1][2].member_1 < _e1450[0][1][2].member_1) {
                                phi_2800_ = 1u;
                            } else {
                                phi_2800_ = 0u;
                            }
                            let _e1854 = phi_2800_;
                            if (_e1450[1][0][0].member_1 < _e1450[0][0][0].member_1) {
                                phi_2821_ = 1u;
                            } else {
                                phi_2821_ = 0u;
                            }
                            let _e1877 = phi_2821_;
                            if (_e1450[1][0][1].member_1 < _e1450[0][0][1].member_1) {
                                phi_2833_ = 1u;
                            } else {
                                phi_2833_ = 0u;
                            }
                            let _e1891 = phi_2833_;
                            if (_e1450[1][0][2].member_1 < _e1450[0][0][2].member_1) {
                                phi_2845_ = 1u;
                            } else {
                                phi_2845_ = 0u;
                            }
                            let _e1905 = phi_2845_;
                            if (_e1450[1][1][0].member_1 < _e1450[0][1][0].member_1) {
                                phi_2865_ = 1u;
                            } else {
                                phi_2865_ = 0u;
                            }
                            let _e1927 = phi_2865_;
                            if (_e1450[1][1][1].member_1 < _e1450[0][1][1].member_1) {
                                phi_2877_ = 1u;
                            } else {
                                phi_2877_ = 0u;
                            }
                            let _e1941 = phi_2877_;
                            if (_e1450[1][1][2].member_1 < _e1450[0][1][2].member_1) {
                                phi_2889_ = 1u;
                            } else {
                                phi_2889_ = 0u;
                            }
                            let _e1955 = phi_2889_;
                            if (_e1450[2][0][0].member_1 < _e1450[3][0][0].member_1) {
                                phi_2910_ = 1u;
                            } else {
                                phi_2910_ = 0u;
                            }
                            let _e1978 = phi_2910_;
                            if (_e1450[2][0][1].member_1 < _e1450[3][0][1].member_1) {
                                phi_2922_ = 1u;
                            } else {
                                phi_2922_ = 0u;
                            }
                            let _e1992 = phi_2922_;
                            if (_e1450[2][0][2].member_1 < _e1450[3][0][2].member_1) {
                                phi_2934_ = 1u;
                            } else {
                                phi_2934_ = 0u;
                            }
                            let _e2006 = phi_2934_;
                            if (_e1450[2][1][0].member_1 < _e1450[3][1][0].member_1) {
                                phi_2954_ = 1u;
                            } else {
                                phi_2954_ = 0u;
                            }
                            let _e2028 = phi_2954_;
                            if (_e1450[2][1][1].member_1 < _e1450[3][1][1].member_1) {
                                phi_2966_ = 1u;
                            } else {
                                phi_2966_ = 0u;
                            }
                            let _e2042 = phi_2966_;
                            if (_e1450[2][1][2].member_1 < _e1450[3][1][2].member_1) {
                                phi_2978_ = 1u;
                            } else {
                                phi_2978_ = 0u;
                            }
                            let _e2056 = phi_2978_;
                            phi_3258_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1450[2][0][0].member - _e1450[0][0][0].member) - _e1776), (_e1450[2][0][0].member_1 - _e1450[0][0][0].member_1)), type_9(((_e1450[2][0][1].member - _e1450[0][0][1].member) - _e1790), (_e1450[2][0][1].member_1 - _e1450[0][0][1].member_1)), type_9(((_e1450[2][0][2].member - _e1450[0][0][2].member) - _e1804), (_e1450[2][0][2].member_1 - _e1450[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1450[2][1][0].member - _e1450[0][1][0].member) - _e1826), (_e1450[2][1][0].member_1 - _e1450[0][1][0].member_1)), type_9(((_e1450[2][1][1].member - _e1450[0][1][1].member) - _e1840), (_e1450[2][1][1].member_1 - _e1450[0][1][1].member_1)), type_9(((_e1450[2][1][2].member - _e1450[0][1][2].member) - _e1854), (_e1450[2][1][2].member_1 - _e1450[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1450[1][0][0].member - _e1450[0][0][0].member) - _e1877), (_e1450[1][0][0].member_1 - _e1450[0][0][0].member_1)), type_9(((_e1450[1][0][1].member - _e1450[0][0][1].member) - _e1891), (_e1450[1][0][1].member_1 - _e1450[0][0][1].member_1)), type_9(((_e1450[1][0][2].member - _e1450[0][0][2].member) - _e1905), (_e1450[1][0][2].member_1 - _e1450[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1450[1][1][0].member - _e1450[0][1][0].member) - _e1927), (_e1450[1][1][0].member_1 - _e1450[0][1][0].member_1)), type_9(((_e1450[1][1][1].member - _e1450[0][1][1].member) - _e1941), (_e1450[1][1][1].member_1 - _e1450[0][1][1].member_1)), type_9(((_e1450[1][1][2].member - _e1450[0][1][2].member) - _e1955), (_e1450[1][1][2].member_1 - _e1450[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1450[2][0][0].member - _e1450[3][0][0].member) - _e1978), (_e1450[2][0][0].member_1 - _e1450[3][0][0].member_1)), type_9(((_e1450[2][0][1].member - _e1450[3][0][1].member) - _e1992), (_e1450[2][0][1].member_1 - _e1450[3][0][1].member_1)), type_9(((_e1450[2][0][2].member - _e1450[3][0][2].member) - _e2006), (_e1450[2][0][2].member_1 - _e1450[3][0][2].member_1))), array<type_9, 3>(type_9(((_e1450[2][1][0].member - _e1450[3][1][0].member) - _e2028), (_e1450[2][1][0].member_1 - _e1450[3][1][0].member_1)), type_9(((_e1450[2][1][1].member - _e1450[3][1][1].member) - _e2042), (_e1450[2][1][1].member_1 - _e1450[3][1][1].member_1)), type_9(((_e1450[2][1][2].member - _e1450[3][1][2].member) - _e2056), (_e1450[2][1][2].member_1 - _e1450[3][1][2].member_1)))));
                        } else {
                            if (_e1450[0][0][0].member_1 < _e1450[1][0][0].member_1) {
                                phi_3000_ = 1u;
                            } else {
                                phi_3000_ = 0u;
                            }
                            let _e1472 = phi_3000_;
                            if (_e1450[0][0][1].member_1 < _e1450[1][0][1].member_1) {
                                phi_3012_ = 1u;
                            } else {
                                phi_3012_ = 0u;
                            }
                            let _e1486 = phi_3012_;
                            if (_e1450[0][0][2].member_1 < _e1450[1][0][2].member_1) {
                                phi_3024_ = 1u;
                            } else {
                                phi_3024_ = 0u;
                            }
                            let _e1500 = phi_3024_;
                            if (_e1450[0][1][0].member_1 < _e1450[1][1][0].member_1) {
                                phi_3044_ = 1u;
                            } else {
                                phi_3044_ = 0u;
                            }
                            let _e1522 = phi_3044_;
                            if (_e1450[0][1][1].member_1 < _e1450[1][1][1].member_1) {
                                phi_3056_ = 1u;
                            } else {
                                phi_3056_ = 0u;
                            }
                            let _e1536 = phi_3056_;
                            if (_e1450[0][1][2].member_1 < _e1450[1][1][2].member_1) {
                                phi_3068_ = 1u;
                            } else {
                                phi_3068_ = 0u;
                            }
                            let _e1550 = phi_3068_;
                            if (_e1450[2][0][0].member_1 < _e1450[1][0][0].member_1) {
                                phi_3089_ = 1u;
                            } else {
                                phi_3089_ = 0u;
                            }
                            let _e1573 = phi_3089_;
                            if (_e1450[2][0][1].member_1 < _e1450[1][0][1].member_1) {
                                phi_3101_ = 1u;
                            } else {
                                phi_3101_ = 0u;
                            }
                            let _e1587 = phi_3101_;
                            if (_e1450[2][0][2].member_1 < _e1450[1][0][2].member_1) {
                                phi_3113_ = 1u;
                            } else {
                                phi_3113_ = 0u;
                            }
                            let _e1601 = phi_3113_;
                            if (_e1450[2][1][0].member_1 < _e1450[1][1][0].member_1) {
                                phi_3133_ = 1u;
                            } else {
                                phi_3133_ = 0u;
                            }
                            let _e1623 = phi_3133_;
                            if (_e1450[2][1][1].member_1 < _e1450[1][1][1].member_1) {
                                phi_3145_ = 1u;
                            } else {
                                phi_3145_ = 0u;
                            }
                            let _e1637 = phi_3145_;
                            if (_e1450[2][1][2].member_1 < _e1450[1][1][2].member_1) {
                                phi_3157_ = 1u;
                            } else {
                                phi_3157_ = 0u;
                            }
                            let _e1651 = phi_3157_;
                            if (_e1450[3][0][0].member_1 < _e1450[1][0][0].member_1) {
                                phi_3178_ = 1u;
                            } else {
                                phi_3178_ = 0u;
                            }
                            let _e1674 = phi_3178_;
                            if (_e1450[3][0][1].member_1 < _e1450[1][0][1].member_1) {
                                phi_3190_ = 1u;
                            } else {
                                phi_3190_ = 0u;
                            }
                            let _e1688 = phi_3190_;
                            if (_e1450[3][0][2].member_1 < _e1450[1][0][2].member_1) {
                                phi_3202_ = 1u;
                            } else {
                                phi_3202_ = 0u;
                            }
                            let _e1702 = phi_3202_;
                            if (_e1450[3][1][0].member_1 < _e1450[1][1][0].member_1) {
                                phi_3222_ = 1u;
                            } else {
                                phi_3222_ = 0u;
                            }
                            let _e1724 = phi_3222_;
                            if (_e1450[3][1][1].member_1 < _e1450[1][1][1].member_1) {
                                phi_3234_ = 1u;
                            } else {
                                phi_3234_ = 0u;
                            }
                            let _e1738 = phi_3234_;
                            if (_e1450[3][1][2].member_1 < _e1450[1][1][2].member_1) {
                                phi_3246_ = 1u;
                            } else {
                                phi_3246_ = 0u;
                            }
                            let _e1752 = phi_3246_;
                            phi_3258_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1450[0][0][0].member - _e1450[1][0][0].member) - _e1472), (_e1450[0][0][0].member_1 - _e1450[1][0][0].member_1)), type_9(((_e1450[0][0][1].member - _e1450[1][0][1].member) - _e1486), (_e1450[0][0][1].member_1 - _e1450[1][0][1].member_1)), type_9(((_e1450[0][0][2].member - _e1450[1][0][2].member) - _e1500), (_e1450[0][0][2].member_1 - _e1450[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1450[0][1][0].member - _e1450[1][1][0].member) - _e1522), (_e1450[0][1][0].member_1 - _e1450[1][1][0].member_1)), type_9(((_e1450[0][1][1].member - _e1450[1][1][1].member) - _e1536), (_e1450[0][1][1].member_1 - _e1450[1][1][1].member_1)), type_9(((_e1450[0][1][2].member - _e1450[1][1][2].member) - _e1550), (_e1450[0][1][2].member_1 - _e1450[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1450[2][0][0].member - _e1450[1][0][0].member) - _e1573), (_e1450[2][0][0].member_1 - _e1450[1][0][0].member_1)), type_9(((_e1450[2][0][1].member - _e1450[1][0][1].member) - _e1587), (_e1450[2][0][1].member_1 - _e1450[1][0][1].member_1)), type_9(((_e1450[2][0][2].member - _e1450[1][0][2].member) - _e1601), (_e1450[2][0][2].member_1 - _e1450[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1450[2][1][0].member - _e1450[1][1][0].member) - _e1623), (_e1450[2][1][0].member_1 - _e1450[1][1][0].member_1)), type_9(((_e1450[2][1][1].member - _e1450[1][1][1].member) - _e1637), (_e1450[2][1][1].member_1 - _e1450[1][1][1].member_1)), type_9(((_e1450[2][1][2].member - _e1450[1][1][2].member) - _e1651), (_e1450[2][1][2].member_1 - _e1450[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1450[3][0][0].member - _e1450[1][0][0].member) - _e1674), (_e1450[3][0][0].member_1 - _e1450[1][0][0].member_1)), type_9(((_e1450[3][0][1].member - _e1450[1][0][1].member) - _e1688), (_e1450[3][0][1].member_1 - _e1450[1][0][1].member_1)), type_9(((_e1450[3][0][2].member - _e1450[1][0][2].member) - _e1702), (_e1450[3][0][2].member_1 - _e1450[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1450[3][1][0].member - _e1450[1][1][0].member) - _e1724), (_e1450[3][1][0].member_1 - _e1450[1][1][0].member_1)), type_9(((_e1450[3][1][1].member - _e1450[1][1][1].member) - _e1738), (_e1450[3][1][1].member_1 - _e1450[1][1][1].member_1)), type_9(((_e1450[3][1][2].member - _e1450[1][1][2].member) - _e1752), (_e1450[3][1][2].member_1 - _e1450[1][1][2].member_1)))));
                        }
                        let _e2067 = phi_3258_;
                        local_48 = array<type_9, 3>(type_9(_e2067[1][0][0].member, _e2067[1][0][0].member_1), type_9(_e2067[1][0][1].member, _e2067[1][0][1].member_1), type_9(_e2067[1][0][2].member, _e2067[1][0][2].member_1));
                        local_49 = array<type_9, 3>(type_9(_e2067[2][0][0].member, _e2067[2][0][0].member_1), type_9(_e2067[2][0][1].member, _e2067[2][0][1].member_1), type_9(_e2067[2][0][2].member, _e2067[2][0][2].member_1));
                        let _e2100 = local_48[1u].member;
                        let _e2102 = local_48[1u].member_1;
                        let _e2105 = local_49[2u].member;
                        let _e2107 = local_49[2u].member_1;
                        let _e2108 = function_8(_e2100, _e2102, _e2105, _e2107);
                        let _e2113 = local_48[2u].member;
                        let _e2115 = local_48[2u].member_1;
                        let _e2118 = local_49[1u].member;
                        let _e2120 = local_49[1u].member_1;
                        let _e2121 = function_8(_e2113, _e2115, _e2118, _e2120);
                        if (_e2108.member_1 < _e2121.member_1) {
                            phi_3337_ = 1u;
                        } else {
                            phi_3337_ = 0u;
                        }
                        let _e2126 = phi_3337_;
                        let _e2128 = ((_e2108.member - _e2121.member) - _e2126);
                        let _e2129 = (_e2108.member_1 - _e2121.member_1);
                        local_46 = array<type_9, 3>(type_9(_e2067[1][0][0].member, _e2067[1][0][0].member_1), type_9(_e2067[1][0][1].member, _e2067[1][0][1].member_1), type_9(_e2067[1][0][2].member, _e2067[1][0][2].member_1));
                        local_47 = array<type_9, 3>(type_9(_e2067[2][0][0].member, _e2067[2][0][0].member_1), type_9(_e2067[2][0][1].member, _e2067[2][0][1].member_1), type_9(_e2067[2][0][2].member, _e2067[2][0][2].member_1));
                        let _e2158 = local_46[2u].member;
                        let _e2160 = local_46[2u].member_1;
                        let _e2163 = local_47[0u].member;
                        let _e2165 = local_47[0u].member_1;
                        let _e2166 = function_8(_e2158, _e2160, _e2163, _e2165);
                        let _e2171 = local_46[0u].member;
                        let _e2173 = local_46[0u].member_1;
                        let _e2176 = local_47[2u].member;
                        let _e2178 = local_47[2u].member_1;
                        let _e2179 = function_8(_e2171, _e2173, _e2176, _e2178);
                        if (_e2166.member_1 < _e2179.member_1) {
                            phi_3417_ = 1u;
                        } else {
                            phi_3417_ = 0u;
                        }
                        let _e2184 = phi_3417_;
                        let _e2186 = ((_e2166.member - _e2179.member) - _e2184);
                        let _e2187 = (_e2166.member_1 - _e2179.member_1);
                        local_44 = array<type_9, 3>(type_9(_e2067[1][0][0].member, _e2067[1][0][0].member_1), type_9(_e2067[1][0][1].member, _e2067[1][0][1].member_1), type_9(_e2067[1][0][2].member, _e2067[1][0][2].member_1));
                        local_45 = array<type_9, 3>(type_9(_e2067[2][0][0].member, _e2067[2][0][0].member_1), type_9(_e2067[2][0][1].member, _e2067[2][0][1].member_1), type_9(_e2067[2][0][2].member, _e2067[2][0][2].member_1));
                        let _e2216 = local_44[0u].member;
                        let _e2218 = local_44[0u].member_1;
                        let _e2221 = local_45[1u].member;
                        let _e2223 = local_45[1u].member_1;
                        let _e2224 = function_8(_e2216, _e2218, _e2221, _e2223);
                        let _e2229 = local_44[1u].member;
                        let _e2231 = local_44[1u].member_1;
                        let _e2234 = local_45[0u].member;
                        let _e2236 = local_45[0u].member_1;
                        let _e2237 = function_8(_e2229, _e2231, _e2234, _e2236);
                        if (_e2224.member_1 < _e2237.member_1) {
                            phi_3497_ = 1u;
                        } else {
                            phi_3497_ = 0u;
                        }
                        let _e2242 = phi_3497_;
                        let _e2244 = ((_e2224.member - _e2237.member) - _e2242);
                        let _e2245 = (_e2224.member_1 - _e2237.member_1);
                        local_42 = array<type_9, 3>(type_9(_e2067[1][1][0].member, _e2067[1][1][0].member_1), type_9(_e2067[1][1][1].member, _e2067[1][1][1].member_1), type_9(_e2067[1][1][2].member, _e2067[1][1][2].member_1));
                        local_43 = array<type_9, 3>(type_9(_e2067[2][1][0].member, _e2067[2][1][0].member_1), type_9(_e2067[2][1][1].member, _e2067[2][1][1].member_1), type_9(_e2067[2][1][2].member, _e2067[2][1][2].member_1));
                        let _e2278 = local_42[1u].member;
                        let _e2280 = local_42[1u].member_1;
                        let _e2283 = local_43[2u].member;
                        let _e2285 = local_43[2u].member_1;
                        let _e2286 = function_8(_e2278, _e2280, _e2283, _e2285);
                        let _e2291 = local_42[2u].member;
                        let _e2293 = local_42[2u].member_1;
                        let _e2296 = local_43[1u].member;
                        let _e2298 = local_43[1u].member_1;
                        let _e2299 = function_8(_e2291, _e2293, _e2296, _e2298);
                        if (_e2286.member_1 < _e2299.member_1) {
                            phi_3585_ = 1u;
                        } else {
                            phi_3585_ = 0u;
                        }
                        let _e2304 = phi_3585_;
                        let _e2306 = ((_e2286.member - _e2299.member) - _e2304);
                        let _e2307 = (_e2286.member_1 - _e2299.member_1);
                        local_40 = array<type_9, 3>(type_9(_e2067[1][1][0].member, _e2067[1][1][0].member_1), type_9(_e2067[1][1][1].member, _e2067[1][1][1].member_1), type_9(_e2067[1][1][2].member, _e2067[1][1][2].member_1));
                        local_41 = array<type_9, 3>(type_9(_e2067[2][1][0].member, _e2067[2][1][0].member_1), type_9(_e2067[2][1][1].member, _e2067[2][1][1].member_1), type_9(_e2067[2][1][2].member, _e2067[2][1][2].member_1));
                        let _e2336 = local_40[2u].member;
                        let _e2338 = local_40[2u].member_1;
                        let _e2341 = local_41[0u].member;
                        let _e2343 = local_41[0u].member_1;
                        let _e2344 = function_8(_e2336, _e2338, _e2341, _e2343);
                        let _e2349 = local_40[0u].member;
                        let _e2351 = local_40[0u].member_1;
                        let _e2354 = local_41[2u].member;
                        let _e2356 = local_41[2u].member_1;
                        let _e2357 = function_8(_e2349, _e2351, _e2354, _e2356);
                        if (_e2344.member_1 < _e2357.member_1) {
                            phi_3665_ = 1u;
                        } else {
                            phi_3665_ = 0u;
                        }
                        let _e2362 = phi_3665_;
                        let _e2364 = ((_e2344.member - _e2357.member) - _e2362);
                        let _e2365 = (_e2344.member_1 - _e2357.member_1);
                        local_38 = array<type_9, 3>(type_9(_e2067[1][1][0].member, _e2067[1][1][0].member_1), type_9(_e2067[1][1][1].member, _e2067[1][1][1].member_1), type_9(_e2067[1][1][2].member, _e2067[1][1][2].member_1));
                        local_39 = array<type_9, 3>(type_9(_e2067[2][1][0].member, _e2067[2][1][0].member_1), type_9(_e2067[2][1][1].member, _e2067[2][1][1].member_1), type_9(_e2067[2][1][2].member, _e2067[2][1][2].member_1));
                        let _e2394 = local_38[0u].member;
                        let _e2396 = local_38[0u].member_1;
                        let _e2399 = local_39[1u].member;
                        let _e2401 = local_39[1u].member_1;
                        let _e2402 = function_8(_e2394, _e2396, _e2399, _e2401);
                        let _e2407 = local_38[1u].member;
                        let _e2409 = local_38[1u].member_1;
                        let _e2412 = local_39[0u].member;
                        let _e2414 = local_39[0u].member_1;
                        let _e2415 = function_8(_e2407, _e2409, _e2412, _e2414);
                        if (_e2402.member_1 < _e2415.member_1) {
                            phi_3745_ = 1u;
                        } else {
                            phi_3745_ = 0u;
                        }
                        let _e2420 = phi_3745_;
                        let _e2422 = ((_e2402.member - _e2415.member) - _e2420);
                        let _e2423 = (_e2402.member_1 - _e2415.member_1);
                        local_36 = array<type_9, 3>(type_9(_e2067[1][0][0].member, _e2067[1][0][0].member_1), type_9(_e2067[1][0][1].member, _e2067[1][0][1].member_1), type_9(_e2067[1][0][2].member, _e2067[1][0][2].member_1));
                        local_37 = array<type_9, 3>(type_9(_e2067[2][1][0].member, _e2067[2][1][0].member_1), type_9(_e2067[2][1][1].member, _e2067[2][1][1].member_1), type_9(_e2067[2][1][2].member, _e2067[2][1][2].member_1));
                        let _e2456 = local_36[1u].member;
                        let _e2458 = local_36[1u].member_1;
                        let _e2461 = local_37[2u].member;
                        let _e2463 = local_37[2u].member_1;
                        let _e2464 = function_8(_e2456, _e2458, _e2461, _e2463);
                        let _e2469 = local_36[2u].member;
                        let _e2471 = local_36[2u].member_1;
                        let _e2474 = local_37[1u].member;
                        let _e2476 = local_37[1u].member_1;
                        let _e2477 = function_8(_e2469, _e2471, _e2474, _e2476);
                        if (_e2464.member_1 < _e2477.member_1) {
                            phi_3833_ = 1u;
                        } else {
                            phi_3833_ = 0u;
                        }
                        let _e2482 = phi_3833_;
                        let _e2485 = (_e2464.member_1 - _e2477.member_1);
                        local_34 = array<type_9, 3>(type_9(_e2067[1][0][0].member, _e2067[1][0][0].member_1), type_9(_e2067[1][0][1].member, _e2067[1][0][1].member_1), type_9(_e2067[1][0][2].member, _e2067[1][0][2].member_1));
                        local_35 = array<type_9, 3>(type_9(_e2067[2][1][0].member, _e2067[2][1][0].member_1), type_9(_e2067[2][1][1].member, _e2067[2][1][1].member_1), type_9(_e2067[2][1][2].member, _e2067[2][1][2].member_1));
                        let _e2514 = local_34[2u].member;
                        let _e2516 = local_34[2u].member_1;
                        let _e2519 = local_35[0u].member;
                        let _e2521 = local_35[0u].member_1;
                        let _e2522 = function_8(_e2514, _e2516, _e2519, _e2521);
                        let _e2527 = local_34[0u].member;
                        let _e2529 = local_34[0u].member_1;
                        let _e2532 = local_35[2u].member;
                        let _e2534 = local_35[2u].member_1;
                        let _e2535 = function_8(_e2527, _e2529, _e2532, _e2534);
                        if (_e2522.member_1 < _e2535.member_1) {
                            phi_3913_ = 1u;
                        } else {
                            phi_3913_ = 0u;
                        }
                        let _e2540 = phi_3913_;
                        let _e2543 = (_e2522.member_1 - _e2535.member_1);
                        local_32 = array<type_9, 3>(type_9(_e2067[1][0][0].member, _e2067[1][0][0].member_1), type_9(_e2067[1][0][1].member, _e2067[1][0][1].member_1), type_9(_e2067[1][0][2].member, _e2067[1][0][2].member_1));
                        local_33 = array<type_9, 3>(type_9(_e2067[2][1][0].member, _e2067[2][1][0].member_1), type_9(_e2067[2][1][1].member, _e2067[2][1][1].member_1), type_9(_e2067[2][1][2].member, _e2067[2][1][2].member_1));
                        let _e2572 = local_32[0u].member;
                        let _e2574 = local_32[0u].member_1;
                        let _e2577 = local_33[1u].member;
                        let _e2579 = local_33[1u].member_1;
                        let _e2580 = function_8(_e2572, _e2574, _e2577, _e2579);
                        let _e2585 = local_32[1u].member;
                        let _e2587 = local_32[1u].member_1;
                        let _e2590 = local_33[0u].member;
                        let _e2592 = local_33[0u].member_1;
                        let _e2593 = function_8(_e2585, _e2587, _e2590, _e2592);
                        if (_e2580.member_1 < _e2593.member_1) {
                            phi_3993_ = 1u;
                        } else {
                            phi_3993_ = 0u;
                        }
                        let _e2598 = phi_3993_;
                        let _e2601 = (_e2580.member_1 - _e2593.member_1);
                        local_30 = array<type_9, 3>(type_9(_e2067[1][1][0].member, _e2067[1][1][0].member_1), type_9(_e2067[1][1][1].member, _e2067[1][1][1].member_1), type_9(_e2067[1][1][2].member, _e2067[1][1][2].member_1));
                        local_31 = array<type_9, 3>(type_9(_e2067[2][0][0].member, _e2067[2][0][0].member_1), type_9(_e2067[2][0][1].member, _e2067[2][0][1].member_1), type_9(_e2067[2][0][2].member, _e2067[2][0][2].member_1));
                        let _e2634 = local_30[1u].member;
                        let _e2636 = local_30[1u].member_1;
                        let _e2639 = local_31[2u].member;
                        let _e2641 = local_31[2u].member_1;
                        let _e2642 = function_8(_e2634, _e2636, _e2639, _e2641);
                        let _e2647 = local_30[2u].member;
                        let _e2649 = local_30[2u].member_1;
                        let _e2652 = local_31[1u].member;
                        let _e2654 = local_31[1u].member_1;
                        let _e2655 = function_8(_e2647, _e2649, _e2652, _e2654);
                        if (_e2642.member_1 < _e2655.member_1) {
                            phi_4081_ = 1u;
                        } else {
                            phi_4081_ = 0u;
                        }
                        let _e2660 = phi_4081_;
                        local_28 = array<type_9, 3>(type_9(_e2067[1][1][0].member, _e2067[1][1][0].member_1), type_9(_e2067[1][1][1].member, _e2067[1][1][1].member_1), type_9(_e2067[1][1][2].member, _e2067[1][1][2].member_1));
                        local_29 = array<type_9, 3>(type_9(_e2067[2][0][0].member, _e2067[2][0][0].member_1), type_9(_e2067[2][0][1].member, _e2067[2][0][1].member_1), type_9(_e2067[2][0][2].member, _e2067[2][0][2].member_1));
                        let _e2692 = local_28[2u].member;
                        let _e2694 = local_28[2u].member_1;
                        let _e2697 = local_29[0u].member;
                        let _e2699 = local_29[0u].member_1;
                        let _e2700 = function_8(_e2692, _e2694, _e2697, _e2699);
                        let _e2705 = local_28[0u].member;
                        let _e2707 = local_28[0u].member_1;
                        let _e2710 = local_29[2u].member;
                        let _e2712 = local_29[2u].member_1;
                        let _e2713 = function_8(_e2705, _e2707, _e2710, _e2712);
                        if (_e2700.member_1 < _e2713.member_1) {
                            phi_4161_ = 1u;
                        } else {
                            phi_4161_ = 0u;
                        }
                        let _e2718 = phi_4161_;
                        local_26 = array<type_9, 3>(type_9(_e2067[1][1][0].member, _e2067[1][1][0].member_1), type_9(_e2067[1][1][1].member, _e2067[1][1][1].member_1), type_9(_e2067[1][1][2].member, _e2067[1][1][2].member_1));
                        local_27 = array<type_9, 3>(type_9(_e2067[2][0][0].member, _e2067[2][0][0].member_1), type_9(_e2067[2][0][1].member, _e2067[2][0][1].member_1), type_9(_e2067[2][0][2].member, _e2067[2][0][2].member_1));
                        let _e2750 = local_26[0u].member;
                        let _e2752 = local_26[0u].member_1;
                        let _e2755 = local_27[1u].member;
                        let _e2757 = local_27[1u].member_1;
                        let _e2758 = function_8(_e2750, _e2752, _e2755, _e2757);
                        let _e2763 = local_26[1u].member;
                        let _e2765 = local_26[1u].member_1;
                        let _e2768 = local_27[0u].member;
                        let _e2770 = local_27[0u].member_1;
                        let _e2771 = function_8(_e2763, _e2765, _e2768, _e2770);
                        if (_e2758.member_1 < _e2771.member_1) {
                            phi_4241_ = 1u;
                        } else {
                            phi_4241_ = 0u;
                        }
                        let _e2776 = phi_4241_;
                        let _e2780 = (_e2485 + (_e2642.member_1 - _e2655.member_1));
                        if (_e2780 < _e2485) {
                            phi_4260_ = 1u;
                        } else {
                            phi_4260_ = 0u;
                        }
                        let _e2783 = phi_4260_;
                        let _e2785 = ((((_e2464.member - _e2477.member) - _e2482) + ((_e2642.member - _e2655.member) - _e2660)) + _e2783);
                        let _e2786 = (_e2543 + (_e2700.member_1 - _e2713.member_1));
                        if (_e2786 < _e2543) {
                            phi_4272_ = 1u;
                        } else {
                            phi_4272_ = 0u;
                        }
                        let _e2789 = phi_4272_;
                        let _e2791 = ((((_e2522.member - _e2535.member) - _e2540) + ((_e2700.member - _e2713.member) - _e2718)) + _e2789);
                        let _e2792 = (_e2601 + (_e2758.member_1 - _e2771.member_1));
                        if (_e2792 < _e2601) {
                            phi_4284_ = 1u;
                        } else {
                            phi_4284_ = 0u;
                        }
                        let _e2795 = phi_4284_;
                        let _e2797 = ((((_e2580.member - _e2593.member) - _e2598) + ((_e2758.member - _e2771.member) - _e2776)) + _e2795);
                        let _e2804 = function_8(_e2067[0][0][0].member, _e2067[0][0][0].member_1, _e2128, _e2129);
                        let _e2811 = function_8(_e2067[0][0][1].member, _e2067[0][0][1].member_1, _e2186, _e2187);
                        let _e2814 = (_e2804.member_1 + _e2811.member_1);
                        if (_e2814 < _e2804.member_1) {
                            phi_4313_ = 1u;
                        } else {
                            phi_4313_ = 0u;
                        }
                        let _e2817 = phi_4313_;
                        let _e2824 = function_8(_e2067[0][0][2].member, _e2067[0][0][2].member_1, _e2244, _e2245);
                        let _e2827 = (_e2814 + _e2824.member_1);
                        if (_e2827 < _e2814) {
                            phi_4328_ = 1u;
                        } else {
                            phi_4328_ = 0u;
                        }
                        let _e2830 = phi_4328_;
                        let _e2833 = function_11(((((_e2804.member + _e2811.member) + _e2817) + _e2824.member) + _e2830), _e2827);
                        let _e2842 = function_8(_e2067[0][1][0].member, _e2067[0][1][0].member_1, _e2128, _e2129);
                        let _e2849 = function_8(_e2067[0][1][1].member, _e2067[0][1][1].member_1, _e2186, _e2187);
                        let _e2852 = (_e2842.member_1 + _e2849.member_1);
                        if (_e2852 < _e2842.member_1) {
                            phi_4354_ = 1u;
                        } else {
                            phi_4354_ = 0u;
                        }
                        let _e2855 = phi_4354_;
                        let _e2862 = function_8(_e2067[0][1][2].member, _e2067[0][1][2].member_1, _e2244, _e2245);
                        let _e2865 = (_e2852 + _e2862.member_1);
                        if (_e2865 < _e2852) {
                            phi_4369_ = 1u;
                        } else {
                            phi_4369_ = 0u;
                        }
                        let _e2868 = phi_4369_;
                        let _e2877 = function_8(_e2067[0][0][0].member, _e2067[0][0][0].member_1, _e2785, _e2780);
                        let _e2884 = function_8(_e2067[0][0][1].member, _e2067[0][0][1].member_1, _e2791, _e2786);
                        let _e2887 = (_e2877.member_1 + _e2884.member_1);
                        if (_e2887 < _e2877.member_1) {
                            phi_4392_ = 1u;
                        } else {
                            phi_4392_ = 0u;
                        }
                        let _e2890 = phi_4392_;
                        let _e2897 = function_8(_e2067[0][0][2].member, _e2067[0][0][2].member_1, _e2797, _e2792);
                        let _e2900 = (_e2887 + _e2897.member_1);
                        if (_e2900 < _e2887) {
                            phi_4407_ = 1u;
                        } else {
                            phi_4407_ = 0u;
                        }
                        let _e2903 = phi_4407_;
                        let _e2906 = (_e2865 + _e2900);
                        if (_e2906 < _e2865) {
                            phi_4415_ = 1u;
                        } else {
                            phi_4415_ = 0u;
                        }
                        let _e2909 = phi_4415_;
                        let _e2911 = ((((((_e2842.member + _e2849.member) + _e2855) + _e2862.member) + _e2868) + ((((_e2877.member + _e2884.member) + _e2890) + _e2897.member) + _e2903)) + _e2909);
                        let _e2918 = function_8(_e2067[0][0][0].member, _e2067[0][0][0].member_1, _e2306, _e2307);
                        let _e2925 = function_8(_e2067[0][0][1].member, _e2067[0][0][1].member_1, _e2364, _e2365);
                        let _e2928 = (_e2918.member_1 + _e2925.member_1);
                        if (_e2928 < _e2918.member_1) {
                            phi_4438_ = 1u;
                        } else {
                            phi_4438_ = 0u;
                        }
                        let _e2931 = phi_4438_;
                        let _e2938 = function_8(_e2067[0][0][2].member, _e2067[0][0][2].member_1, _e2422, _e2423);
                        let _e2941 = (_e2928 + _e2938.member_1);
                        if (_e2941 < _e2928) {
                            phi_4453_ = 1u;
                        } else {
                            phi_4453_ = 0u;
                        }
                        let _e2944 = phi_4453_;
                        let _e2953 = function_8(_e2067[0][1][0].member, _e2067[0][1][0].member_1, _e2785, _e2780);
                        let _e2960 = function_8(_e2067[0][1][1].member, _e2067[0][1][1].member_1, _e2791, _e2786);
                        let _e2963 = (_e2953.member_1 + _e2960.member_1);
                        if (_e2963 < _e2953.member_1) {
                            phi_4476_ = 1u;
                        } else {
                            phi_4476_ = 0u;
                        }
                        let _e2966 = phi_4476_;
                        let _e2973 = function_8(_e2067[0][1][2].member, _e2067[0][1][2].member_1, _e2797, _e2792);
                        let _e2976 = (_e2963 + _e2973.member_1);
                        if (_e2976 < _e2963) {
                            phi_4491_ = 1u;
                        } else {
                            phi_4491_ = 0u;
                        }
                        let _e2979 = phi_4491_;
                        let _e2982 = (_e2941 + _e2976);
                        if (_e2982 < _e2941) {
                            phi_4499_ = 1u;
                        } else {
                            phi_4499_ = 0u;
                        }
                        let _e2985 = phi_4499_;
                        let _e2987 = ((((((_e2918.member + _e2925.member) + _e2931) + _e2938.member) + _e2944) + ((((_e2953.member + _e2960.member) + _e2966) + _e2973.member) + _e2979)) + _e2985);
                        let _e2994 = function_8(_e2067[0][1][0].member, _e2067[0][1][0].member_1, _e2306, _e2307);
                        let _e3001 = function_8(_e2067[0][1][1].member, _e2067[0][1][1].member_1, _e2364, _e2365);
                        let _e3004 = (_e2994.member_1 + _e3001.member_1);
                        if (_e3004 < _e2994.member_1) {
                            phi_4522_ = 1u;
                        } else {
                            phi_4522_ = 0u;
                        }
                        let _e3007 = phi_4522_;
                        let _e3014 = function_8(_e2067[0][1][2].member, _e2067[0][1][2].member_1, _e2422, _e2423);
                        let _e3017 = (_e3004 + _e3014.member_1);
                        if (_e3017 < _e3004) {
                            phi_4537_ = 1u;
                        } else {
                            phi_4537_ = 0u;
                        }
                        let _e3020 = phi_4537_;
                        let _e3023 = function_11(((((_e2994.member + _e3001.member) + _e3007) + _e3014.member) + _e3020), _e3017);
                        phi_4553_ = type_9(0u, 128u);
                        phi_4556_ = array<type_9, 4>(_e2833, type_9(_e2911, _e2906), type_9(_e2987, _e2982), type_9(_e3023.member, _e3023.member_1));
                        phi_4560_ = 0u;
                        phi_4562_ = 0u;
                        loop {
                            let _e3031 = phi_4553_;
                            let _e3033 = phi_4556_;
                            let _e3035 = phi_4560_;
                            let _e3037 = phi_4562_;
                            local_65 = _e3033;
                            local_66 = _e3033;
                            local_67 = _e3033;
                            if (_e3031.member < _e3031.member_1) {
                                phi_4554_ = type_9((_e3031.member + 1u), _e3031.member_1);
                                phi_4585_ = type_9(1u, _e3031.member);
                            } else {
                                phi_4554_ = _e3031;
                                phi_4585_ = type_9(0u, type_9().member_1);
                            }
                            let _e3049 = phi_4554_;
                            let _e3051 = phi_4585_;
                            if (bitcast<i32>(_e3051.member) != 0i) {
                                let _e3055 = (31u - _e3035);
                                let _e3058 = (_e3037 << bitcast<u32>((_e3055 & 31u)));
                                let _e3063 = (_e3058 > _e1454);
                                if _e3063 {
                                    phi_7270_ = array<type_9, 4>();
                                    phi_7272_ = u32();
                                    phi_7273_ = u32();
                                    phi_7274_ = bool();
                                    phi_7275_ = bool();
                                    phi_7276_ = u32();
                                    phi_7277_ = u32();
                                    phi_7278_ = false;
                                    phi_7279_ = false;
                                    phi_7280_ = false;
                                } else {
                                    if (((_e3037 + 1u) << bitcast<u32>((_e3055 & 31u))) < _e1452) {
                                        phi_4782_ = true;
                                    } else {
                                        let _e3069 = function_10(128u);
                                        if ((_e3033[0].member >> bitcast<u32>(31i)) != 0u) {
                                            if (_e3033[0].member_1 == 0u) {
                                                phi_4620_ = 1u;
                                            } else {
                                                phi_4620_ = 0u;
                                            }
                                            let _e3078 = phi_4620_;
                                            phi_4627_ = type_9((~(_e3033[0].member) + _e3078), (~(_e3033[0].member_1) + 1u));
                                        } else {
                                            phi_4627_ = _e3033[0];
                                        }
                                        let _e3085 = phi_4627_;
                                        if (_e3069.member_1 < _e3085.member_1) {
                                            phi_4634_ = 1u;
                                        } else {
                                            phi_4634_ = 0u;
                                        }
                                        let _e3090 = phi_4634_;
                                        if ((((_e3069.member - _e3085.member) - _e3090) >> bitcast<u32>(31i)) != 0u) {
                                            if ((_e3033[0].member >> bitcast<u32>(31i)) != 0u) {
                                                phi_4647_ = 2u;
                                            } else {
                                                phi_4647_ = 1u;
                                            }
                                            let _e3100 = phi_4647_;
                                            phi_4648_ = _e3100;
                                        } else {
                                            phi_4648_ = 0u;
                                        }
                                        let _e3102 = phi_4648_;
                                        let _e3107 = function_10(128u);
                                        if ((_e3033[1].member >> bitcast<u32>(31i)) != 0u) {
                                            if (_e3033[1].member_1 == 0u) {
                                                phi_4663_ = 1u;
                                            } else {
                                                phi_4663_ = 0u;
                                            }
                                            let _e3116 = phi_4663_;
                                            phi_4670_ = type_9((~(_e3033[1].member) + _e3116), (~(_e3033[1].member_1) + 1u));
                                        } else {
                                            phi_4670_ = _e3033[1];
                                        }
                                        let _e3123 = phi_4670_;
                                        if (_e3107.member_1 < _e3123.member_1) {
                                            phi_4677_ = 1u;
                                        } else {
                                            phi_4677_ = 0u;
                                        }
                                        let _e3128 = phi_4677_;
                                        if ((((_e3107.member - _e3123.member) - _e3128) >> bitcast<u32>(31i)) != 0u) {
                                            if ((_e3033[1].member >> bitcast<u32>(31i)) != 0u) {
                                                phi_4690_ = 2u;
                                            } else {
                                                phi_4690_ = 1u;
                                            }
                                            let _e3138 = phi_4690_;
                                            phi_4691_ = _e3138;
                                        } else {
                                            phi_4691_ = 0u;
                                        }
                                        let _e3140 = phi_4691_;
                                        let _e3146 = function_10(128u);
                                        if ((_e3033[2].member >> bitcast<u32>(31i)) != 0u) {
                                            if (_e3033[2].member_1 == 0u) {
                                                phi_4707_ = 1u;
                                            } else {
                                                phi_4707_ = 0u;
                                            }
                                            let _e3155 = phi_4707_;
                                            phi_4714_ = type_9((~(_e3033[2].member) + _e3155), (~(_e3033[2].member_1) + 1u));
                                        } else {
                                            phi_4714_ = _e3033[2];
                                        }
                                        let _e3162 = phi_4714_;
                                        if (_e3146.member_1 < _e3162.member_1) {
                                            phi_4721_ = 1u;
                                        } else {
                                            phi_4721_ = 0u;
                                        }
                                        let _e3167 = phi_4721_;
                                        if ((((_e3146.member - _e3162.member) - _e3167) >> bitcast<u32>(31i)) != 0u) {
                                            if ((_e3033[2].member >> bitcast<u32>(31i)) != 0u) {
                                                phi_4734_ = 2u;
                                            } else {
                                                phi_4734_ = 1u;
                                            }
                                            let _e3177 = phi_4734_;
                                            phi_4735_ = _e3177;
                                        } else {
                                            phi_4735_ = 0u;
                                        }
                                        let _e3179 = phi_4735_;
                                        let _e3185 = function_10(128u);
                                        if ((_e3033[3].member >> bitcast<u32>(31i)) != 0u) {
                                            if (_e3033[3].member_1 == 0u) {
                                                phi_4751_ = 1u;
                                            } else {
                                                phi_4751_ = 0u;
                                            }
                                            let _e3194 = phi_4751_;
                                            phi_4758_ = type_9((~(_e3033[3].member) + _e3194), (~(_e3033[3].member_1) + 1u));
                                        } else {
                                            phi_4758_ = _e3033[3];
                                        }
                                        let _e3201 = phi_4758_;
                                        if (_e3185.member_1 < _e3201.member_1) {
                                            phi_4765_ = 1u;
                                        } else {
                                            phi_4765_ = 0u;
                                        }
                                        let _e3206 = phi_4765_;
                                        if ((((_e3185.member - _e3201.member) - _e3206) >> bitcast<u32>(31i)) != 0u) {
                                            if ((_e3033[3].member >> bitcast<u32>(31i)) != 0u) {
                                                phi_4778_ = 2u;
                                            } else {
                                                phi_4778_ = 1u;
                                            }
                                            let _e3216 = phi_4778_;
                                            phi_4779_ = _e3216;
                                        } else {
                                            phi_4779_ = 0u;
                                        }
                                        let _e3218 = phi_4779_;
                                        phi_4782_ = ((((_e3102 & _e3140) & _e3179) & _e3218) != 0u);
                                    }
                                    let _e3222 = phi_4782_;
                                    if _e3222 {
                                        phi_6951_ = _e3033;
                                        phi_6953_ = _e3222;
                                        phi_6954_ = _e3035;
                                        phi_6955_ = _e3037;
                                        phi_6956_ = bool();
                                        phi_6957_ = bool();
                                        phi_6958_ = u32();
                                        phi_6959_ = u32();
                                        phi_6960_ = true;
                                    } else {
                                        let _e3223 = (_e3035 == 31u);
                                        if _e3223 {
                                            phi_4807_ = true;
                                        } else {
                                            if (_e3035 == 3u) {
                                                phi_4806_ = true;
                                            } else {
                                                if (_e3035 == 8u) {
                                                    phi_4805_ = true;
                                                } else {
                                                    phi_4805_ = (_e3035 == 14u);
                                                }
                                                let _e3228 = phi_4805_;
                                                phi_4806_ = _e3228;
                                            }
                                            let _e3230 = phi_4806_;
                                            phi_4807_ = _e3230;
                                        }
                                        let _e3232 = phi_4807_;
                                        if _e3232 {
                                            let _e3237 = function_10(128u);
                                            if ((_e3033[0].member >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3033[0].member_1 == 0u) {
                                                    phi_4825_ = 1u;
                                                } else {
                                                    phi_4825_ = 0u;
                                                }
                                                let _e3246 = phi_4825_;
                                                phi_4832_ = type_9((~(_e3033[0].member) + _e3246), (~(_e3033[0].member_1) + 1u));
                                            } else {
                                                phi_4832_ = _e3033[0];
                                            }
                                            let _e3253 = phi_4832_;
                                            if (_e3237.member_1 < _e3253.member_1) {
                                                phi_4839_ = 1u;
                                            } else {
                                                phi_4839_ = 0u;
                                            }
                                            let _e3258 = phi_4839_;
                                            if ((((_e3237.member - _e3253.member) - _e3258) >> bitcast<u32>(31i)) != 0u) {
                                                if ((_e3033[0].member >> bitcast<u32>(31i)) != 0u) {
                                                    phi_4852_ = 2u;
                                                } else {
                                                    phi_4852_ = 1u;
                                                }
                                                let _e3268 = phi_4852_;
                                                phi_4853_ = _e3268;
                                            } else {
                                                phi_4853_ = 0u;
                                            }
                                            let _e3270 = phi_4853_;
                                            let _e3275 = function_10(128u);
                                            if ((_e3033[3].member >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3033[3].member_1 == 0u) {
                                                    phi_4868_ = 1u;
                                                } else {
                                                    phi_4868_ = 0u;
                                                }
                                                let _e3284 = phi_4868_;
                                                phi_4875_ = type_9((~(_e3033[3].member) + _e3284), (~(_e3033[3].member_1) + 1u));
                                            } else {
                                                phi_4875_ = _e3033[3];
                                            }
                                            let _e3291 = phi_4875_;
                                            if (_e3275.member_1 < _e3291.member_1) {
                                                phi_4882_ = 1u;
                                            } else {
                                                phi_4882_ = 0u;
                                            }
                                            let _e3296 = phi_4882_;
                                            if ((((_e3275.member - _e3291.member) - _e3296) >> bitcast<u32>(31i)) != 0u) {
                                                if ((_e3033[3].member >> bitcast<u32>(31i)) != 0u) {
                                                    phi_4895_ = 2u;
                                                } else {
                                                    phi_4895_ = 1u;
                                                }
                                                let _e3306 = phi_4895_;
                                                phi_4896_ = _e3306;
                                            } else {
                                                phi_4896_ = 0u;
                                            }
                                            let _e3308 = phi_4896_;
                                            let _e3310 = ((_e3270 | _e3308) == 3u);
                                            if _e3223 {
                                                phi_4903_ = !(_e3310);
                                            } else {
                                                phi_4903_ = false;
                                            }
                                            let _e3313 = phi_4903_;
                                            if _e3313 {
                                                phi_4911_ = select((bitcast<u32>(31i) - firstLeadingBit(_e1456)), 32u, (_e1456 == 0u));
                                            } else {
                                                phi_4911_ = _e3035;
                                            }
                                            let _e3320 = phi_4911_;
                                            if (_e2067[0][1][0].member_1 < _e2067[0][0][0].member_1) {
                                                phi_4929_ = 1u;
                                            } else {
                                                phi_4929_ = 0u;
                                            }
                                            let _e3341 = phi_4929_;
                                            let _e3343 = ((_e2067[0][1][0].member - _e2067[0][0][0].member) - _e3341);
                                            let _e3344 = (_e2067[0][1][0].member_1 - _e2067[0][0][0].member_1);
                                            if (_e2067[0][1][1].member_1 < _e2067[0][0][1].member_1) {
                                                phi_4941_ = 1u;
                                            } else {
                                                phi_4941_ = 0u;
                                            }
                                            let _e3355 = phi_4941_;
                                            let _e3357 = ((_e2067[0][1][1].member - _e2067[0][0][1].member) - _e3355);
                                            let _e3358 = (_e2067[0][1][1].member_1 - _e2067[0][0][1].member_1);
                                            if (_e2067[0][1][2].member_1 < _e2067[0][0][2].member_1) {
                                                phi_4953_ = 1u;
                                            } else {
                                                phi_4953_ = 0u;
                                            }
                                            let _e3369 = phi_4953_;
                                            let _e3371 = ((_e2067[0][1][2].member - _e2067[0][0][2].member) - _e3369);
                                            let _e3372 = (_e2067[0][1][2].member_1 - _e2067[0][0][2].member_1);
                                            if ((_e3343 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3344 == 0u) {
                                                    phi_4974_ = 1u;
                                                } else {
                                                    phi_4974_ = 0u;
                                                }
                                                let _e3379 = phi_4974_;
                                                phi_4981_ = type_9((~(_e3343) + _e3379), (~(_e3344) + 1u));
                                            } else {
                                                phi_4981_ = type_9(_e3343, _e3344);
                                            }
                                            let _e3386 = phi_4981_;
                                            if ((_e3357 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3358 == 0u) {
                                                    phi_4995_ = 1u;
                                                } else {
                                                    phi_4995_ = 0u;
                                                }
                                                let _e3395 = phi_4995_;
                                                phi_5002_ = type_9((~(_e3357) + _e3395), (~(_e3358) + 1u));
                                            } else {
                                                phi_5002_ = type_9(_e3357, _e3358);
                                            }
                                            let _e3402 = phi_5002_;
                                            if (_e3402.member_1 < _e3386.member_1) {
                                                phi_5009_ = 1u;
                                            } else {
                                                phi_5009_ = 0u;
                                            }
                                            let _e3407 = phi_5009_;
                                            if ((((_e3402.member - _e3386.member) - _e3407) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5019_ = _e3386;
                                            } else {
                                                phi_5019_ = _e3402;
                                            }
                                            let _e3414 = phi_5019_;
                                            if ((_e3371 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3372 == 0u) {
                                                    phi_5033_ = 1u;
                                                } else {
                                                    phi_5033_ = 0u;
                                                }
                                                let _e3423 = phi_5033_;
                                                phi_5040_ = type_9((~(_e3371) + _e3423), (~(_e3372) + 1u));
                                            } else {
                                                phi_5040_ = type_9(_e3371, _e3372);
                                            }
                                            let _e3430 = phi_5040_;
                                            if (_e3430.member_1 < _e3414.member_1) {
                                                phi_5047_ = 1u;
                                            } else {
                                                phi_5047_ = 0u;
                                            }
                                            let _e3435 = phi_5047_;
                                            if ((((_e3430.member - _e3414.member) - _e3435) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5057_ = _e3414;
                                            } else {
                                                phi_5057_ = _e3430;
                                            }
                                            let _e3442 = phi_5057_;
                                            let _e3445 = function_10(4u);
                                            let _e3448 = (_e3442.member_1 + _e3445.member_1);
                                            if (_e3448 < _e3442.member_1) {
                                                phi_5068_ = 1u;
                                            } else {
                                                phi_5068_ = 0u;
                                            }
                                            let _e3451 = phi_5068_;
                                            let _e3453 = ((_e3442.member + _e3445.member) + _e3451);
                                            let _e3468 = ((_e3448 >> bitcast<u32>((_e3320 & 31u))) | ((_e3453 << bitcast<u32>(((31u - _e3320) & 31u))) << bitcast<u32>(1i)));
                                            let _e3469 = function_10(4u);
                                            let _e3472 = (_e3468 + _e3469.member_1);
                                            if (_e3472 < _e3468) {
                                                phi_5090_ = 1u;
                                            } else {
                                                phi_5090_ = 0u;
                                            }
                                            let _e3475 = phi_5090_;
                                            if (_e2067[1][1][0].member_1 < _e2067[1][0][0].member_1) {
                                                phi_5103_ = 1u;
                                            } else {
                                                phi_5103_ = 0u;
                                            }
                                            let _e3490 = phi_5103_;
                                            let _e3492 = ((_e2067[1][1][0].member - _e2067[1][0][0].member) - _e3490);
                                            let _e3493 = (_e2067[1][1][0].member_1 - _e2067[1][0][0].member_1);
                                            if (_e2067[1][1][1].member_1 < _e2067[1][0][1].member_1) {
                                                phi_5115_ = 1u;
                                            } else {
                                                phi_5115_ = 0u;
                                            }
                                            let _e3504 = phi_5115_;
                                            let _e3506 = ((_e2067[1][1][1].member - _e2067[1][0][1].member) - _e3504);
                                            let _e3507 = (_e2067[1][1][1].member_1 - _e2067[1][0][1].member_1);
                                            if (_e2067[1][1][2].member_1 < _e2067[1][0][2].member_1) {
                                                phi_5127_ = 1u;
                                            } else {
                                                phi_5127_ = 0u;
                                            }
                                            let _e3518 = phi_5127_;
                                            let _e3520 = ((_e2067[1][1][2].member - _e2067[1][0][2].member) - _e3518);
                                            let _e3521 = (_e2067[1][1][2].member_1 - _e2067[1][0][2].member_1);
                                            if ((_e3492 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3493 == 0u) {
                                                    phi_5148_ = 1u;
                                                } else {
                                                    phi_5148_ = 0u;
                                                }
                                                let _e3528 = phi_5148_;
                                                phi_5155_ = type_9((~(_e3492) + _e3528), (~(_e3493) + 1u));
                                            } else {
                                                phi_5155_ = type_9(_e3492, _e3493);
                                            }
                                            let _e3535 = phi_5155_;
                                            if ((_e3506 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3507 == 0u) {
                                                    phi_5169_ = 1u;
                                                } else {
                                                    phi_5169_ = 0u;
                                                }
                                                let _e3544 = phi_5169_;
                                                phi_5176_ = type_9((~(_e3506) + _e3544), (~(_e3507) + 1u));
                                            } else {
                                                phi_5176_ = type_9(_e3506, _e3507);
                                            }
                                            let _e3551 = phi_5176_;
                                            if (_e3551.member_1 < _e3535.member_1) {
                                                phi_5183_ = 1u;
                                            } else {
                                                phi_5183_ = 0u;
                                            }
                                            let _e3556 = phi_5183_;
                                            if ((((_e3551.member - _e3535.member) - _e3556) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5193_ = _e3535;
                                            } else {
                                                phi_5193_ = _e3551;
                                            }
                                            let _e3563 = phi_5193_;
                                            if ((_e3520 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3521 == 0u) {
                                                    phi_5207_ = 1u;
                                                } else {
                                                    phi_5207_ = 0u;
                                                }
                                                let _e3572 = phi_5207_;
                                                phi_5214_ = type_9((~(_e3520) + _e3572), (~(_e3521) + 1u));
                                            } else {
                                                phi_5214_ = type_9(_e3520, _e3521);
                                            }
                                            let _e3579 = phi_5214_;
                                            if (_e3579.member_1 < _e3563.member_1) {
                                                phi_5221_ = 1u;
                                            } else {
                                                phi_5221_ = 0u;
                                            }
                                            let _e3584 = phi_5221_;
                                            if ((((_e3579.member - _e3563.member) - _e3584) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5231_ = _e3563;
                                            } else {
                                                phi_5231_ = _e3579;
                                            }
                                            let _e3591 = phi_5231_;
                                            let _e3594 = function_10(4u);
                                            let _e3597 = (_e3591.member_1 + _e3594.member_1);
                                            if (_e3597 < _e3591.member_1) {
                                                phi_5242_ = 1u;
                                            } else {
                                                phi_5242_ = 0u;
                                            }
                                            let _e3600 = phi_5242_;
                                            let _e3602 = ((_e3591.member + _e3594.member) + _e3600);
                                            let _e3617 = ((_e3597 >> bitcast<u32>((_e3320 & 31u))) | ((_e3602 << bitcast<u32>(((31u - _e3320) & 31u))) << bitcast<u32>(1i)));
                                            let _e3618 = function_10(4u);
                                            let _e3621 = (_e3617 + _e3618.member_1);
                                            if (_e3621 < _e3617) {
                                                phi_5264_ = 1u;
                                            } else {
                                                phi_5264_ = 0u;
                                            }
                                            let _e3624 = phi_5264_;
                                            if (_e2067[2][1][0].member_1 < _e2067[2][0][0].member_1) {
                                                phi_5277_ = 1u;
                                            } else {
                                                phi_5277_ = 0u;
                                            }
                                            let _e3639 = phi_5277_;
                                            let _e3641 = ((_e2067[2][1][0].member - _e2067[2][0][0].member) - _e3639);
                                            let _e3642 = (_e2067[2][1][0].member_1 - _e2067[2][0][0].member_1);
                                            if (_e2067[2][1][1].member_1 < _e2067[2][0][1].member_1) {
                                                phi_5289_ = 1u;
                                            } else {
                                                phi_5289_ = 0u;
                                            }
                                            let _e3653 = phi_5289_;
                                            let _e3655 = ((_e2067[2][1][1].member - _e2067[2][0][1].member) - _e3653);
                                            let _e3656 = (_e2067[2][1][1].member_1 - _e2067[2][0][1].member_1);
                                            if (_e2067[2][1][2].member_1 < _e2067[2][0][2].member_1) {
                                                phi_5301_ = 1u;
                                            } else {
                                                phi_5301_ = 0u;
                                            }
                                            let _e3667 = phi_5301_;
                                            let _e3669 = ((_e2067[2][1][2].member - _e2067[2][0][2].member) - _e3667);
                                            let _e3670 = (_e2067[2][1][2].member_1 - _e2067[2][0][2].member_1);
                                            if ((_e3641 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3642 == 0u) {
                                                    phi_5322_ = 1u;
                                                } else {
                                                    phi_5322_ = 0u;
                                                }
                                                let _e3677 = phi_5322_;
                                                phi_5329_ = type_9((~(_e3641) + _e3677), (~(_e3642) + 1u));
                                            } else {
                                                phi_5329_ = type_9(_e3641, _e3642);
                                            }
                                            let _e3684 = phi_5329_;
                                            if ((_e3655 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3656 == 0u) {
                                                    phi_5343_ = 1u;
                                                } else {
                                                    phi_5343_ = 0u;
                                                }
                                                let _e3693 = phi_5343_;
                                                phi_5350_ = type_9((~(_e3655) + _e3693), (~(_e3656) + 1u));
                                            } else {
                                                phi_5350_ = type_9(_e3655, _e3656);
                                            }
                                            let _e3700 = phi_5350_;
                                            if (_e3700.member_1 < _e3684.member_1) {
                                                phi_5357_ = 1u;
                                            } else {
                                                phi_5357_ = 0u;
                                            }
                                            let _e3705 = phi_5357_;
                                            if ((((_e3700.member - _e3684.member) - _e3705) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5367_ = _e3684;
                                            } else {
                                                phi_5367_ = _e3700;
                                            }
                                            let _e3712 = phi_5367_;
                                            if ((_e3669 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3670 == 0u) {
                                                    phi_5381_ = 1u;
                                                } else {
                                                    phi_5381_ = 0u;
                                                }
                                                let _e3721 = phi_5381_;
                                                phi_5388_ = type_9((~(_e3669) + _e3721), (~(_e3670) + 1u));
                                            } else {
                                                phi_5388_ = type_9(_e3669, _e3670);
                                            }
                                            let _e3728 = phi_5388_;
                                            if (_e3728.member_1 < _e3712.member_1) {
                                                phi_5395_ = 1u;
                                            } else {
                                                phi_5395_ = 0u;
                                            }
                                            let _e3733 = phi_5395_;
                                            if ((((_e3728.member - _e3712.member) - _e3733) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5405_ = _e3712;
                                            } else {
                                                phi_5405_ = _e3728;
                                            }
                                            let _e3740 = phi_5405_;
                                            let _e3743 = function_10(4u);
                                            let _e3746 = (_e3740.member_1 + _e3743.member_1);
                                            if (_e3746 < _e3740.member_1) {
                                                phi_5416_ = 1u;
                                            } else {
                                                phi_5416_ = 0u;
                                            }
                                            let _e3749 = phi_5416_;
                                            let _e3751 = ((_e3740.member + _e3743.member) + _e3749);
                                            let _e3766 = ((_e3746 >> bitcast<u32>((_e3320 & 31u))) | ((_e3751 << bitcast<u32>(((31u - _e3320) & 31u))) << bitcast<u32>(1i)));
                                            let _e3767 = function_10(4u);
                                            let _e3770 = (_e3766 + _e3767.member_1);
                                            if (_e3770 < _e3766) {
                                                phi_5438_ = 1u;
                                            } else {
                                                phi_5438_ = 0u;
                                            }
                                            let _e3773 = phi_5438_;
                                            local_25[0u].member = ((bitcast<u32>((bitcast<i32>(_e3453) >> bitcast<u32>((_e3320 & 31u)))) + _e3469.member) + _e3475);
                                            local_25[0u].member_1 = _e3472;
                                            local_25[1u].member = ((bitcast<u32>((bitcast<i32>(_e3602) >> bitcast<u32>((_e3320 & 31u)))) + _e3618.member) + _e3624);
                                            local_25[1u].member_1 = _e3621;
                                            local_25[2u].member = ((bitcast<u32>((bitcast<i32>(_e3751) >> bitcast<u32>((_e3320 & 31u)))) + _e3767.member) + _e3773);
                                            local_25[2u].member_1 = _e3770;
                                            if (_e2067[0][1][0].member_1 < _e2067[0][0][0].member_1) {
                                                phi_5459_ = 1u;
                                            } else {
                                                phi_5459_ = 0u;
                                            }
                                            let _e3798 = phi_5459_;
                                            let _e3802 = function_4(((_e2067[0][1][0].member - _e2067[0][0][0].member) - _e3798), (_e2067[0][1][0].member_1 - _e2067[0][0][0].member_1), _e3058);
                                            let _e3805 = (_e2067[0][0][0].member_1 + _e3802.member_1);
                                            if (_e3805 < _e2067[0][0][0].member_1) {
                                                phi_5471_ = 1u;
                                            } else {
                                                phi_5471_ = 0u;
                                            }
                                            let _e3808 = phi_5471_;
                                            let _e3810 = ((_e2067[0][0][0].member + _e3802.member) + _e3808);
                                            if (_e2067[0][1][1].member_1 < _e2067[0][0][1].member_1) {
                                                phi_5482_ = 1u;
                                            } else {
                                                phi_5482_ = 0u;
                                            }
                                            let _e3821 = phi_5482_;
                                            let _e3825 = function_4(((_e2067[0][1][1].member - _e2067[0][0][1].member) - _e3821), (_e2067[0][1][1].member_1 - _e2067[0][0][1].member_1), _e3058);
                                            let _e3828 = (_e2067[0][0][1].member_1 + _e3825.member_1);
                                            if (_e3828 < _e2067[0][0][1].member_1) {
                                                phi_5494_ = 1u;
                                            } else {
                                                phi_5494_ = 0u;
                                            }
                                            let _e3831 = phi_5494_;
                                            let _e3833 = ((_e2067[0][0][1].member + _e3825.member) + _e3831);
                                            if (_e2067[0][1][2].member_1 < _e2067[0][0][2].member_1) {
                                                phi_5505_ = 1u;
                                            } else {
                                                phi_5505_ = 0u;
                                            }
                                            let _e3844 = phi_5505_;
                                            let _e3848 = function_4(((_e2067[0][1][2].member - _e2067[0][0][2].member) - _e3844), (_e2067[0][1][2].member_1 - _e2067[0][0][2].member_1), _e3058);
                                            let _e3851 = (_e2067[0][0][2].member_1 + _e3848.member_1);
                                            if (_e3851 < _e2067[0][0][2].member_1) {
                                                phi_5517_ = 1u;
                                            } else {
                                                phi_5517_ = 0u;
                                            }
                                            let _e3854 = phi_5517_;
                                            let _e3856 = ((_e2067[0][0][2].member + _e3848.member) + _e3854);
                                            if (_e2067[1][1][0].member_1 < _e2067[1][0][0].member_1) {
                                                phi_5536_ = 1u;
                                            } else {
                                                phi_5536_ = 0u;
                                            }
                                            let _e3869 = phi_5536_;
                                            let _e3873 = function_4(((_e2067[1][1][0].member - _e2067[1][0][0].member) - _e3869), (_e2067[1][1][0].member_1 - _e2067[1][0][0].member_1), _e3058);
                                            let _e3876 = (_e2067[1][0][0].member_1 + _e3873.member_1);
                                            if (_e3876 < _e2067[1][0][0].member_1) {
                                                phi_5548_ = 1u;
                                            } else {
                                                phi_5548_ = 0u;
                                            }
                                            let _e3879 = phi_5548_;
                                            let _e3881 = ((_e2067[1][0][0].member + _e3873.member) + _e3879);
                                            if (_e2067[1][1][1].member_1 < _e2067[1][0][1].member_1) {
                                                phi_5559_ = 1u;
                                            } else {
                                                phi_5559_ = 0u;
                                            }
                                            let _e3892 = phi_5559_;
                                            let _e3896 = function_4(((_e2067[1][1][1].member - _e2067[1][0][1].member) - _e3892), (_e2067[1][1][1].member_1 - _e2067[1][0][1].member_1), _e3058);
                                            let _e3899 = (_e2067[1][0][1].member_1 + _e3896.member_1);
                                            if (_e3899 < _e2067[1][0][1].member_1) {
                                                phi_5571_ = 1u;
                                            } else {
                                                phi_5571_ = 0u;
                                            }
                                            let _e3902 = phi_5571_;
                                            let _e3904 = ((_e2067[1][0][1].member + _e3896.member) + _e3902);
                                            if (_e2067[1][1][2].member_1 < _e2067[1][0][2].member_1) {
                                                phi_5582_ = 1u;
                                            } else {
                                                phi_5582_ = 0u;
                                            }
                                            let _e3915 = phi_5582_;
                                            let _e3919 = function_4(((_e2067[1][1][2].member - _e2067[1][0][2].member) - _e3915), (_e2067[1][1][2].member_1 - _e2067[1][0][2].member_1), _e3058);
                                            let _e3922 = (_e2067[1][0][2].member_1 + _e3919.member_1);
                                            if (_e3922 < _e2067[1][0][2].member_1) {
                                                phi_5594_ = 1u;
                                            } else {
                                                phi_5594_ = 0u;
                                            }
                                            let _e3925 = phi_5594_;
                                            let _e3927 = ((_e2067[1][0][2].member + _e3919.member) + _e3925);
                                            if (_e2067[2][1][0].member_1 < _e2067[2][0][0].member_1) {
                                                phi_5613_ = 1u;
                                            } else {
                                                phi_5613_ = 0u;
                                            }
                                            let _e3940 = phi_5613_;
                                            let _e3944 = function_4(((_e2067[2][1][0].member - _e2067[2][0][0].member) - _e3940), (_e2067[2][1][0].member_1 - _e2067[2][0][0].member_1), _e3058);
                                            let _e3947 = (_e2067[2][0][0].member_1 + _e3944.member_1);
                                            if (_e3947 < _e2067[2][0][0].member_1) {
                                                phi_5625_ = 1u;
                                            } else {
                                                phi_5625_ = 0u;
                                            }
                                            let _e3950 = phi_5625_;
                                            let _e3952 = ((_e2067[2][0][0].member + _e3944.member) + _e3950);
                                            if (_e2067[2][1][1].member_1 < _e2067[2][0][1].member_1) {
                                                phi_5636_ = 1u;
                                            } else {
                                                phi_5636_ = 0u;
                                            }
                                            let _e3963 = phi_5636_;
                                            let _e3967 = function_4(((_e2067[2][1][1].member - _e2067[2][0][1].member) - _e3963), (_e2067[2][1][1].member_1 - _e2067[2][0][1].member_1), _e3058);
                                            let _e3970 = (_e2067[2][0][1].member_1 + _e3967.member_1);
                                            if (_e3970 < _e2067[2][0][1].member_1) {
                                                phi_5648_ = 1u;
                                            } else {
                                                phi_5648_ = 0u;
                                            }
                                            let _e3973 = phi_5648_;
                                            let _e3975 = ((_e2067[2][0][1].member + _e3967.member) + _e3973);
                                            if (_e2067[2][1][2].member_1 < _e2067[2][0][2].member_1) {
                                                phi_5659_ = 1u;
                                            } else {
                                                phi_5659_ = 0u;
                                            }
                                            let _e3986 = phi_5659_;
                                            let _e3990 = function_4(((_e2067[2][1][2].member - _e2067[2][0][2].member) - _e3986), (_e2067[2][1][2].member_1 - _e2067[2][0][2].member_1), _e3058);
                                            let _e3993 = (_e2067[2][0][2].member_1 + _e3990.member_1);
                                            if (_e3993 < _e2067[2][0][2].member_1) {
                                                phi_5671_ = 1u;
                                            } else {
                                                phi_5671_ = 0u;
                                            }
                                            let _e3996 = phi_5671_;
                                            let _e3998 = ((_e2067[2][0][2].member + _e3990.member) + _e3996);
                                            local_23 = array<type_9, 3>(type_9(_e3881, _e3876), type_9(_e3904, _e3899), type_9(_e3927, _e3922));
                                            local_24 = array<type_9, 3>(type_9(_e3952, _e3947), type_9(_e3975, _e3970), type_9(_e3998, _e3993));
                                            let _e4009 = local_23[1u].member;
                                            let _e4011 = local_23[1u].member_1;
                                            let _e4014 = local_24[2u].member;
                                            let _e4016 = local_24[2u].member_1;
                                            let _e4017 = function_8(_e4009, _e4011, _e4014, _e4016);
                                            let _e4022 = local_23[2u].member;
                                            let _e4024 = local_23[2u].member_1;
                                            let _e4027 = local_24[1u].member;
                                            let _e4029 = local_24[1u].member_1;
                                            let _e4030 = function_8(_e4022, _e4024, _e4027, _e4029);
                                            if (_e4017.member_1 < _e4030.member_1) {
                                                phi_5756_ = 1u;
                                            } else {
                                                phi_5756_ = 0u;
                                            }
                                            let _e4035 = phi_5756_;
                                            let _e4037 = ((_e4017.member - _e4030.member) - _e4035);
                                            let _e4038 = (_e4017.member_1 - _e4030.member_1);
                                            local_21 = array<type_9, 3>(type_9(_e3881, _e3876), type_9(_e3904, _e3899), type_9(_e3927, _e3922));
                                            local_22 = array<type_9, 3>(type_9(_e3952, _e3947), type_9(_e3975, _e3970), type_9(_e3998, _e3993));
                                            let _e4049 = local_21[2u].member;
                                            let _e4051 = local_21[2u].member_1;
                                            let _e4054 = local_22[0u].member;
                                            let _e4056 = local_22[0u].member_1;
                                            let _e4057 = function_8(_e4049, _e4051, _e4054, _e4056);
                                            let _e4062 = local_21[0u].member;
                                            let _e4064 = local_21[0u].member_1;
                                            let _e4067 = local_22[2u].member;
                                            let _e4069 = local_22[2u].member_1;
                                            let _e4070 = function_8(_e4062, _e4064, _e4067, _e4069);
                                            if (_e4057.member_1 < _e4070.member_1) {
                                                phi_5836_ = 1u;
                                            } else {
                                                phi_5836_ = 0u;
                                            }
                                            let _e4075 = phi_5836_;
                                            let _e4077 = ((_e4057.member - _e4070.member) - _e4075);
                                            let _e4078 = (_e4057.member_1 - _e4070.member_1);
                                            local_19 = array<type_9, 3>(type_9(_e3881, _e3876), type_9(_e3904, _e3899), type_9(_e3927, _e3922));
                                            local_20 = array<type_9, 3>(type_9(_e3952, _e3947), type_9(_e3975, _e3970), type_9(_e3998, _e3993));
                                            let _e4089 = local_19[0u].member;
                                            let _e4091 = local_19[0u].member_1;
                                            let _e4094 = local_20[1u].member;
                                            let _e4096 = local_20[1u].member_1;
                                            let _e4097 = function_8(_e4089, _e4091, _e4094, _e4096);
                                            let _e4102 = local_19[1u].member;
                                            let _e4104 = local_19[1u].member_1;
                                            let _e4107 = local_20[0u].member;
                                            let _e4109 = local_20[0u].member_1;
                                            let _e4110 = function_8(_e4102, _e4104, _e4107, _e4109);
                                            if (_e4097.member_1 < _e4110.member_1) {
                                                phi_5916_ = 1u;
                                            } else {
                                                phi_5916_ = 0u;
                                            }
                                            let _e4115 = phi_5916_;
                                            let _e4117 = ((_e4097.member - _e4110.member) - _e4115);
                                            let _e4118 = (_e4097.member_1 - _e4110.member_1);
                                            if ((_e4037 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e4038 == 0u) {
                                                    phi_5937_ = 1u;
                                                } else {
                                                    phi_5937_ = 0u;
                                                }
                                                let _e4125 = phi_5937_;
                                                phi_5944_ = type_9((~(_e4037) + _e4125), (~(_e4038) + 1u));
                                            } else {
                                                phi_5944_ = type_9(_e4037, _e4038);
                                            }
                                            let _e4132 = phi_5944_;
                                            if ((_e4077 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e4078 == 0u) {
                                                    phi_5958_ = 1u;
                                                } else {
                                                    phi_5958_ = 0u;
                                                }
                                                let _e4141 = phi_5958_;
                                                phi_5965_ = type_9((~(_e4077) + _e4141), (~(_e4078) + 1u));
                                            } else {
                                                phi_5965_ = type_9(_e4077, _e4078);
                                            }
                                            let _e4148 = phi_5965_;
                                            if ((_e4117 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e4118 == 0u) {
                                                    phi_5979_ = 1u;
                                                } else {
                                                    phi_5979_ = 0u;
                                                }
                                                let _e4157 = phi_5979_;
                                                phi_5986_ = type_9((~(_e4117) + _e4157), (~(_e4118) + 1u));
                                            } else {
                                                phi_5986_ = type_9(_e4117, _e4118);
                                            }
                                            let _e4164 = phi_5986_;
                                            if (_e4148.member_1 < _e4132.member_1) {
                                                phi_5993_ = 1u;
                                            } else {
                                                phi_5993_ = 0u;
                                            }
                                            let _e4169 = phi_5993_;
                                            if ((((_e4148.member - _e4132.member) - _e4169) >> bitcast<u32>(31i)) != 0u) {
                                                if (_e4164.member_1 < _e4132.member_1) {
                                                    phi_6005_ = 1u;
                                                } else {
                                                    phi_6005_ = 0u;
                                                }
                                                let _e4177 = phi_6005_;
                                                if ((((_e4164.member - _e4132.member) - _e4177) >> bitcast<u32>(31i)) != 0u) {
                                                    phi_6013_ = false;
                                                } else {
                                                    phi_6013_ = true;
                                                }
                                                let _e4184 = phi_6013_;
                                                phi_6014_ = _e4184;
                                            } else {
                                                phi_6014_ = true;
                                            }
                                            let _e4186 = phi_6014_;
                                            if _e4186 {
                                                if (_e4164.member_1 < _e4148.member_1) {
                                                    phi_6022_ = 1u;
                                                } else {
                                                    phi_6022_ = 0u;
                                                }
                                                let _e4189 = phi_6022_;
                                                if ((((_e4164.member - _e4148.member) - _e4189) >> bitcast<u32>(31i)) != 0u) {
                                                    phi_6030_ = 1i;
                                                } else {
                                                    phi_6030_ = 2i;
                                                }
                                                let _e4196 = phi_6030_;
                                                phi_6031_ = _e4196;
                                            } else {
                                                phi_6031_ = 0i;
                                            }
                                            let _e4198 = phi_6031_;
                                            switch _e4198 {
                                                case 0: {
                                                    phi_6060_ = array<type_9, 2>(type_9(_e3833, _e3828), type_9(_e3856, _e3851));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6060_ = array<type_9, 2>(type_9(_e3856, _e3851), type_9(_e3810, _e3805));
                                                    break;
                                                }
                                                default: {
                                                    phi_6060_ = array<type_9, 2>(type_9(_e3810, _e3805), type_9(_e3833, _e3828));
                                                    break;
                                                }
                                            }
                                            let _e4209 = phi_6060_;
                                            switch _e4198 {
                                                case 0: {
                                                    phi_6089_ = array<type_9, 2>(type_9(_e3904, _e3899), type_9(_e3927, _e3922));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6089_ = array<type_9, 2>(type_9(_e3927, _e3922), type_9(_e3881, _e3876));
                                                    break;
                                                }
                                                default: {
                                                    phi_6089_ = array<type_9, 2>(type_9(_e3881, _e3876), type_9(_e3904, _e3899));
                                                    break;
                                                }
                                            }
                                            let _e4220 = phi_6089_;
                                            switch _e4198 {
                                                case 0: {
                                                    phi_6118_ = array<type_9, 2>(type_9(_e3975, _e3970), type_9(_e3998, _e3993));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6118_ = array<type_9, 2>(type_9(_e3998, _e3993), type_9(_e3952, _e3947));
                                                    break;
                                                }
                                                default: {
                                                    phi_6118_ = array<type_9, 2>(type_9(_e3952, _e3947), type_9(_e3975, _e3970));
                                                    break;
                                                }
                                            }
                                            let _e4231 = phi_6118_;
                                            switch _e4198 {
                                                case 0: {
                                                    phi_6132_ = type_9(_e4037, _e4038);
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6132_ = type_9(_e4077, _e4078);
                                                    break;
                                                }
                                                default: {
                                                    phi_6132_ = type_9(_e4117, _e4118);
                                                    break;
                                                }
                                            }
                                            let _e4236 = phi_6132_;
                                            let _e4239 = local_25[1u].member;
                                            let _e4241 = local_25[1u].member_1;
                                            let _e4244 = local_25[2u].member;
                                            let _e4246 = local_25[2u].member_1;
                                            let _e4247 = (_e4241 + _e4246);
                                            if (_e4247 < _e4241) {
                                                phi_6158_ = 1u;
                                            } else {
                                                phi_6158_ = 0u;
                                            }
                                            let _e4250 = phi_6158_;
                                            let _e4252 = ((_e4239 + _e4244) + _e4250);
                                            let _e4263 = ((_e4247 >> bitcast<u32>(1u)) | ((_e4252 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e4264 = function_10(17u);
                                            let _e4267 = (_e4263 + _e4264.member_1);
                                            if (_e4267 < _e4263) {
                                                phi_6180_ = 1u;
                                            } else {
                                                phi_6180_ = 0u;
                                            }
                                            let _e4270 = phi_6180_;
                                            let _e4272 = ((bitcast<u32>((bitcast<i32>(_e4252) >> bitcast<u32>(1u))) + _e4264.member) + _e4270);
                                            let _e4275 = local_25[0u].member;
                                            let _e4277 = local_25[0u].member_1;
                                            let _e4280 = local_25[2u].member;
                                            let _e4282 = local_25[2u].member_1;
                                            let _e4283 = (_e4277 + _e4282);
                                            if (_e4283 < _e4277) {
                                                phi_6208_ = 1u;
                                            } else {
                                                phi_6208_ = 0u;
                                            }
                                            let _e4286 = phi_6208_;
                                            let _e4288 = ((_e4275 + _e4280) + _e4286);
                                            let _e4299 = ((_e4283 >> bitcast<u32>(1u)) | ((_e4288 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e4300 = function_10(17u);
                                            let _e4303 = (_e4299 + _e4300.member_1);
                                            if (_e4303 < _e4299) {
                                                phi_6230_ = 1u;
                                            } else {
                                                phi_6230_ = 0u;
                                            }
                                            let _e4306 = phi_6230_;
                                            let _e4308 = ((bitcast<u32>((bitcast<i32>(_e4288) >> bitcast<u32>(1u))) + _e4300.member) + _e4306);
                                            let _e4311 = local_25[0u].member;
                                            let _e4313 = local_25[0u].member_1;
                                            let _e4316 = local_25[1u].member;
                                            let _e4318 = local_25[1u].member_1;
                                            let _e4319 = (_e4313 + _e4318);
                                            if (_e4319 < _e4313) {
                                                phi_6258_ = 1u;
                                            } else {
                                                phi_6258_ = 0u;
                                            }
                                            let _e4322 = phi_6258_;
                                            let _e4324 = ((_e4311 + _e4316) + _e4322);
                                            let _e4335 = ((_e4319 >> bitcast<u32>(1u)) | ((_e4324 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e4336 = function_10(17u);
                                            let _e4339 = (_e4335 + _e4336.member_1);
                                            if (_e4339 < _e4335) {
                                                phi_6280_ = 1u;
                                            } else {
                                                phi_6280_ = 0u;
                                            }
                                            let _e4342 = phi_6280_;
                                            let _e4344 = ((bitcast<u32>((bitcast<i32>(_e4324) >> bitcast<u32>(1u))) + _e4336.member) + _e4342);
                                            if ((_e4236.member >> bitcast<u32>(31i)) != 0u) {
                                                if (_e4236.member_1 == 0u) {
                                                    phi_6294_ = 1u;
                                                } else {
                                                    phi_6294_ = 0u;
                                                }
                                                let _e4352 = phi_6294_;
                                                phi_6301_ = type_9((~(_e4236.member) + _e4352), (~(_e4236.member_1) + 1u));
                                            } else {
                                                phi_6301_ = _e4236;
                                            }
                                            let _e4359 = phi_6301_;
                                            if (_e4267 < _e4359.member_1) {
                                                phi_6308_ = 1u;
                                            } else {
                                                phi_6308_ = 0u;
                                            }
                                            let _e4364 = phi_6308_;
                                            if ((((_e4272 - _e4359.member) - _e4364) >> bitcast<u32>(31i)) != 0u) {
                                                let _e4373 = ((_e4236.member >> bitcast<u32>(31i)) != 0u);
                                                if _e4373 {
                                                    if (_e4236.member_1 == 0u) {
                                                        phi_6328_ = 1u;
                                                    } else {
                                                        phi_6328_ = 0u;
                                                    }
                                                    let _e4378 = phi_6328_;
                                                    phi_6335_ = type_9((~(_e4236.member) + _e4378), (~(_e4236.member_1) + 1u));
                                                } else {
                                                    phi_6335_ = _e4236;
                                                }
                                                let _e4385 = phi_6335_;
                                                let _e4388 = function_9(_e4209, _e4231);
                                                if _e4373 {
                                                    if (_e4388.member_1 == 0u) {
                                                        phi_6348_ = 1u;
                                                    } else {
                                                        phi_6348_ = 0u;
                                                    }
                                                    let _e4393 = phi_6348_;
                                                    phi_6355_ = type_9((~(_e4388.member) + _e4393), (~(_e4388.member_1) + 1u));
                                                } else {
                                                    phi_6355_ = _e4388;
                                                }
                                                let _e4400 = phi_6355_;
                                                let _e4403 = function_9(_e4220, _e4209);
                                                if _e4373 {
                                                    if (_e4403.member_1 == 0u) {
                                                        phi_6368_ = 1u;
                                                    } else {
                                                        phi_6368_ = 0u;
                                                    }
                                                    let _e4408 = phi_6368_;
                                                    phi_6375_ = type_9((~(_e4403.member) + _e4408), (~(_e4403.member_1) + 1u));
                                                } else {
                                                    phi_6375_ = _e4403;
                                                }
                                                let _e4415 = phi_6375_;
                                                if (_e316.member != 0u) {
                                                    if (_e4385.member_1 < _e4400.member_1) {
                                                        phi_6386_ = 1u;
                                                    } else {
                                                        phi_6386_ = 0u;
                                                    }
                                                    let _e4449 = phi_6386_;
                                                    let _e4454 = (_e4267 + _e4303);
                                                    if (_e4454 < _e4267) {
                                                        phi_6396_ = 1u;
                                                    } else {
                                                        phi_6396_ = 0u;
                                                    }
                                                    let _e4457 = phi_6396_;
                                                    if (_e4385.member_1 < _e4415.member_1) {
                                                        phi_6404_ = 1u;
                                                    } else {
                                                        phi_6404_ = 0u;
                                                    }
                                                    let _e4463 = phi_6404_;
                                                    let _e4468 = (_e4267 + _e4339);
                                                    if (_e4468 < _e4267) {
                                                        phi_6414_ = 1u;
                                                    } else {
                                                        phi_6414_ = 0u;
                                                    }
                                                    let _e4471 = phi_6414_;
                                                    phi_6454_ = type_9(((_e4272 + _e4344) + _e4471), _e4468);
                                                    phi_6455_ = type_9(((_e4385.member - _e4415.member) - _e4463), (_e4385.member_1 - _e4415.member_1));
                                                    phi_6456_ = type_9(((_e4272 + _e4308) + _e4457), _e4454);
                                                    phi_6457_ = type_9(((_e4385.member - _e4400.member) - _e4449), (_e4385.member_1 - _e4400.member_1));
                                                } else {
                                                    if (_e4385.member_1 < _e4400.member_1) {
                                                        phi_6422_ = 1u;
                                                    } else {
                                                        phi_6422_ = 0u;
                                                    }
                                                    let _e4421 = phi_6422_;
                                                    let _e4424 = (_e4385.member_1 - _e4400.member_1);
                                                    if (_e4424 < _e4415.member_1) {
                                                        phi_6430_ = 1u;
                                                    } else {
                                                        phi_6430_ = 0u;
                                                    }
                                                    let _e4427 = phi_6430_;
                                                    let _e4429 = ((((_e4385.member - _e4400.member) - _e4421) - _e4415.member) - _e4427);
                                                    let _e4430 = (_e4424 - _e4415.member_1);
                                                    let _e4432 = (_e4267 + _e4303);
                                                    if (_e4432 < _e4267) {
                                                        phi_6440_ = 1u;
                                                    } else {
                                                        phi_6440_ = 0u;
                                                    }
                                                    let _e4435 = phi_6440_;
                                                    let _e4438 = (_e4432 + _e4339);
                                                    if (_e4438 < _e4432) {
                                                        phi_6448_ = 1u;
                                                    } else {
                                                        phi_6448_ = 0u;
                                                    }
                                                    let _e4441 = phi_6448_;
                                                    let _e4443 = ((((_e4272 + _e4308) + _e4435) + _e4344) + _e4441);
                                                    phi_6454_ = type_9(_e4443, _e4438);
                                                    phi_6455_ = type_9(_e4429, _e4430);
                                                    phi_6456_ = type_9(_e4443, _e4438);
                                                    phi_6457_ = type_9(_e4429, _e4430);
                                                }
                                                let _e4476 = phi_6454_;
                                                let _e4478 = phi_6455_;
                                                let _e4480 = phi_6456_;
                                                let _e4482 = phi_6457_;
                                                let _e4483 = function_7(_e4400.member, _e4400.member_1, _e4308, _e4303);
                                                if _e4483 {
                                                    phi_6583_ = u32();
                                                    phi_6584_ = true;
                                                } else {
                                                    let _e4484 = function_7(_e4415.member, _e4415.member_1, _e4344, _e4339);
                                                    if _e4484 {
                                                        phi_6581_ = u32();
                                                        phi_6582_ = true;
                                                    } else {
                                                        let _e4489 = function_7(_e4482.member, _e4482.member_1, _e4480.member, _e4480.member_1);
                                                        if _e4489 {
                                                            phi_6579_ = u32();
                                                            phi_6580_ = true;
                                                        } else {
                                                            let _e4494 = function_7(_e4478.member, _e4478.member_1, _e4476.member, _e4476.member_1);
                                                            if _e4494 {
                                                                phi_6578_ = u32();
                                                            } else {
                                                                let _e4495 = function_6(_e4400.member, _e4400.member_1, _e4308, _e4303);
                                                                if _e4495 {
                                                                    let _e4496 = function_6(_e4415.member, _e4415.member_1, _e4344, _e4339);
                                                                    if _e4496 {
                                                                        let _e4501 = function_6(_e4482.member, _e4482.member_1, _e4480.member, _e4480.member_1);
                                                                        if _e4501 {
                                                                            let _e4506 = function_6(_e4478.member, _e4478.member_1, _e4476.member, _e4476.member_1);
                                                                            if _e4506 {
                                                                                phi_6570_ = false;
                                                                            } else {
                                                                                phi_6570_ = true;
                                                                            }
                                                                            let _e4508 = phi_6570_;
                                                                            phi_6571_ = _e4508;
                                                                        } else {
                                                                            phi_6571_ = true;
                                                                        }
                                                                        let _e4510 = phi_6571_;
                                                                        phi_6572_ = _e4510;
                                                                    } else {
                                                                        phi_6572_ = true;
                                                                    }
                                                                    let _e4512 = phi_6572_;
                                                                    phi_6573_ = _e4512;
                                                                } else {
                                                                    phi_6573_ = true;
                                                                }
                                                                let _e4514 = phi_6573_;
                                                                if _e4514 {
                                                                    phi_6577_ = 2u;
                                                                } else {
                                                                    phi_6577_ = 0u;
                                                                }
                                                                let _e4516 = phi_6577_;
                                                                phi_6578_ = _e4516;
                                                            }
                                                            let _e4518 = phi_6578_;
                                                            phi_6579_ = _e4518;
                                                            phi_6580_ = _e4494;
                                                        }
                                                        let _e4520 = phi_6579_;
                                                        let _e4522 = phi_6580_;
                                                        phi_6581_ = _e4520;
                                                        phi_6582_ = _e4522;
                                                    }
                                                    let _e4524 = phi_6581_;
                                                    let _e4526 = phi_6582_;
                                                    phi_6583_ = _e4524;
                                                    phi_6584_ = _e4526;
                                                }
                                                let _e4528 = phi_6583_;
                                                let _e4530 = phi_6584_;
                                                if _e4530 {
                                                    phi_6588_ = 1u;
                                                } else {
                                                    phi_6588_ = _e4528;
                                                }
                                                let _e4532 = phi_6588_;
                                                phi_6589_ = _e4532;
                                            } else {
                                                phi_6589_ = 2u;
                                            }
                                            let _e4534 = phi_6589_;
                                            let _e4535 = (_e4534 == 1u);
                                            if _e3223 {
                                                phi_6597_ = _e4535;
                                            } else {
                                                phi_6597_ = true;
                                            }
                                            let _e4537 = phi_6597_;
                                            phi_6601_ = _e4535;
                                            phi_6602_ = _e3310;
                                            phi_6603_ = _e3313;
                                            phi_6604_ = (_e3058 + (1u << bitcast<u32>(((31u - _e3320) & 31u))));
                                            phi_6605_ = _e4534;
                                            phi_6606_ = _e4537;
                                        } else {
                                            phi_6601_ = _e3222;
                                            phi_6602_ = bool();
                                            phi_6603_ = bool();
                                            phi_6604_ = u32();
                                            phi_6605_ = u32();
                                            phi_6606_ = true;
                                        }
                                        let _e4539 = phi_6601_;
                                        let _e4541 = phi_6602_;
                                        let _e4543 = phi_6603_;
                                        let _e4545 = phi_6604_;
                                        let _e4547 = phi_6605_;
                                        let _e4549 = phi_6606_;
                                        if _e4549 {
                                            if _e4539 {
                                                phi_6943_ = _e3033;
                                                phi_6945_ = _e3035;
                                                phi_6946_ = _e3037;
                                            } else {
                                                let _e4558 = (_e3033[0].member_1 + _e3033[1].member_1);
                                                if (_e4558 < _e3033[0].member_1) {
                                                    phi_6622_ = 1u;
                                                } else {
                                                    phi_6622_ = 0u;
                                                }
                                                let _e4561 = phi_6622_;
                                                let _e4563 = ((_e3033[0].member + _e3033[1].member) + _e4561);
                                                let _e4571 = bitcast<u32>((bitcast<i32>(_e4563) >> bitcast<u32>(1u)));
                                                let _e4574 = ((_e4558 >> bitcast<u32>(1u)) | ((_e4563 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4583 = (_e3033[1].member_1 + _e3033[2].member_1);
                                                if (_e4583 < _e3033[1].member_1) {
                                                    phi_6645_ = 1u;
                                                } else {
                                                    phi_6645_ = 0u;
                                                }
                                                let _e4586 = phi_6645_;
                                                let _e4588 = ((_e3033[1].member + _e3033[2].member) + _e4586);
                                                let _e4596 = bitcast<u32>((bitcast<i32>(_e4588) >> bitcast<u32>(1u)));
                                                let _e4599 = ((_e4583 >> bitcast<u32>(1u)) | ((_e4588 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4608 = (_e3033[2].member_1 + _e3033[3].member_1);
                                                if (_e4608 < _e3033[2].member_1) {
                                                    phi_6668_ = 1u;
                                                } else {
                                                    phi_6668_ = 0u;
                                                }
                                                let _e4611 = phi_6668_;
                                                let _e4613 = ((_e3033[2].member + _e3033[3].member) + _e4611);
                                                let _e4621 = bitcast<u32>((bitcast<i32>(_e4613) >> bitcast<u32>(1u)));
                                                let _e4624 = ((_e4608 >> bitcast<u32>(1u)) | ((_e4613 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4625 = (_e4574 + _e4599);
                                                if (_e4625 < _e4574) {
                                                    phi_6687_ = 1u;
                                                } else {
                                                    phi_6687_ = 0u;
                                                }
                                                let _e4628 = phi_6687_;
                                                let _e4630 = ((_e4571 + _e4596) + _e4628);
                                                let _e4638 = bitcast<u32>((bitcast<i32>(_e4630) >> bitcast<u32>(1u)));
                                                let _e4641 = ((_e4625 >> bitcast<u32>(1u)) | ((_e4630 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4642 = (_e4599 + _e4624);
                                                if (_e4642 < _e4599) {
                                                    phi_6706_ = 1u;
                                                } else {
                                                    phi_6706_ = 0u;
                                                }
                                                let _e4645 = phi_6706_;
                                                let _e4647 = ((_e4596 + _e4621) + _e4645);
                                                let _e4655 = bitcast<u32>((bitcast<i32>(_e4647) >> bitcast<u32>(1u)));
                                                let _e4658 = ((_e4642 >> bitcast<u32>(1u)) | ((_e4647 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4659 = (_e4641 + _e4658);
                                                if (_e4659 < _e4641) {
                                                    phi_6725_ = 1u;
                                                } else {
                                                    phi_6725_ = 0u;
                                                }
                                                let _e4662 = phi_6725_;
                                                let _e4664 = ((_e4638 + _e4655) + _e4662);
                                                let _e4672 = bitcast<u32>((bitcast<i32>(_e4664) >> bitcast<u32>(1u)));
                                                let _e4675 = ((_e4659 >> bitcast<u32>(1u)) | ((_e4664 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4676 = (2u * _e3037);
                                                let _e4687 = function_10(128u);
                                                if ((_e3033[0].member >> bitcast<u32>(31i)) != 0u) {
                                                    if (_e3033[0].member_1 == 0u) {
                                                        phi_6765_ = 1u;
                                                    } else {
                                                        phi_6765_ = 0u;
                                                    }
                                                    let _e4696 = phi_6765_;
                                                    phi_6772_ = type_9((~(_e3033[0].member) + _e4696), (~(_e3033[0].member_1) + 1u));
                                                } else {
                                                    phi_6772_ = _e3033[0];
                                                }
                                                let _e4703 = phi_6772_;
                                                if (_e4687.member_1 < _e4703.member_1) {
                                                    phi_6779_ = 1u;
                                                } else {
                                                    phi_6779_ = 0u;
                                                }
                                                let _e4708 = phi_6779_;
                                                if ((((_e4687.member - _e4703.member) - _e4708) >> bitcast<u32>(31i)) != 0u) {
                                                    if ((_e3033[0].member >> bitcast<u32>(31i)) != 0u) {
                                                        phi_6792_ = 2u;
                                                    } else {
                                                        phi_6792_ = 1u;
                                                    }
                                                    let _e4718 = phi_6792_;
                                                    phi_6793_ = _e4718;
                                                } else {
                                                    phi_6793_ = 0u;
                                                }
                                                let _e4720 = phi_6793_;
                                                let _e4721 = function_10(128u);
                                                if ((_e4571 >> bitcast<u32>(31i)) != 0u) {
                                                    if (_e4574 == 0u) {
                                                        phi_6808_ = 1u;
                                                    } else {
                                                        phi_6808_ = 0u;
                                                    }
                                                    let _e4730 = phi_6808_;
                                                    phi_6815_ = type_9((~(_e4571) + _e4730), (~(_e4574) + 1u));
                                                } else {
                                                    phi_6815_ = type_9(_e4571, _e4574);
                                                }
                                                let _e4737 = phi_6815_;
                                                if (_e4721.member_1 < _e4737.member_1) {
                                                    phi_6822_ = 1u;
                                                } else {
                                                    phi_6822_ = 0u;
                                                }
                                                let _e4742 = phi_6822_;
                                                if ((((_e4721.member - _e4737.member) - _e4742) >> bitcast<u32>(31i)) != 0u) {
                                                    if ((_e4571 >> bitcast<u32>(31i)) != 0u) {
                                                        phi_6835_ = 2u;
                                                    } else {
                                                        phi_6835_ = 1u;
                                                    }
                                                    let _e4752 = phi_6835_;
                                                    phi_6836_ = _e4752;
                                                } else {
                                                    phi_6836_ = 0u;
                                                }
                                                let _e4754 = phi_6836_;
                                                let _e4756 = function_10(128u);
                                                if ((_e4638 >> bitcast<u32>(31i)) != 0u) {
                                                    if (_e4641 == 0u) {
                                                        phi_6852_ = 1u;
                                                    } else {
                                                        phi_6852_ = 0u;
                                                    }
                                                    let _e4765 = phi_6852_;
                                                    phi_6859_ = type_9((~(_e4638) + _e4765), (~(_e4641) + 1u));
                                                } else {
                                                    phi_6859_ = type_9(_e4638, _e4641);
                                                }
                                                let _e4772 = phi_6859_;
                                                if (_e4756.member_1 < _e4772.member_1) {
                                                    phi_6866_ = 1u;
                                                } else {
                                                    phi_6866_ = 0u;
                                                }
                                                let _e4777 = phi_6866_;
                                                if ((((_e4756.member - _e4772.member) - _e4777) >> bitcast<u32>(31i)) != 0u) {
                                                    if ((_e4638 >> bitcast<u32>(31i)) != 0u) {
                                                        phi_6879_ = 2u;
                                                    } else {
                                                        phi_6879_ = 1u;
                                                    }
                                                    let _e4787 = phi_6879_;
                                                    phi_6880_ = _e4787;
                                                } else {
                                                    phi_6880_ = 0u;
                                                }
                                                let _e4789 = phi_6880_;
                                                let _e4791 = function_10(128u);
                                                if ((_e4672 >> bitcast<u32>(31i)) != 0u) {
                                                    if (_e4675 == 0u) {
                                                        phi_6896_ = 1u;
                                                    } else {
                                                        phi_6896_ = 0u;
                                                    }
                                                    let _e4800 = phi_6896_;
                                                    phi_6903_ = type_9((~(_e4672) + _e4800), (~(_e4675) + 1u));
                                                } else {
                                                    phi_6903_ = type_9(_e4672, _e4675);
                                                }
                                                let _e4807 = phi_6903_;
                                                if (_e4791.member_1 < _e4807.member_1) {
                                                    phi_6910_ = 1u;
                                                } else {
                                                    phi_6910_ = 0u;
                                                }
                                                let _e4812 = phi_6910_;
                                                if ((((_e4791.member - _e4807.member) - _e4812) >> bitcast<u32>(31i)) != 0u) {
                                                    if ((_e4672 >> bitcast<u32>(31i)) != 0u) {
                                                        phi_6923_ = 2u;
                                                    } else {
                                                        phi_6923_ = 1u;
                                                    }
                                                    let _e4822 = phi_6923_;
                                                    phi_6924_ = _e4822;
                                                } else {
                                                    phi_6924_ = 0u;
                                                }
                                                let _e4824 = phi_6924_;
                                                if ((((_e4720 & _e4754) & _e4789) & _e4824) != 0u) {
                                                    phi_6941_ = array<type_9, 4>(type_9(_e4672, _e4675), type_9(_e4655, _e4658), type_9(_e4621, _e4624), type_9(_e3033[3].member, _e3033[3].member_1));
                                                    phi_6942_ = (_e4676 + 1u);
                                                } else {
                                                    phi_6941_ = array<type_9, 4>(_e3033[0], type_9(_e4571, _e4574), type_9(_e4638, _e4641), type_9(_e4672, _e4675));
                                                    phi_6942_ = _e4676;
                                                }
                                                let _e4838 = phi_6941_;
                                                let _e4840 = phi_6942_;
                                                phi_6943_ = _e4838;
                                                phi_6945_ = (_e3035 + 1u);
                                                phi_6946_ = _e4840;
                                            }
                                            let _e4842 = phi_6943_;
                                            let _e4844 = phi_6945_;
                                            let _e4846 = phi_6946_;
                                            phi_6947_ = _e4842;
                                            phi_6949_ = _e4844;
                                            phi_6950_ = _e4846;
                                        } else {
                                            phi_6947_ = array<type_9, 4>();
                                            phi_6949_ = u32();
                                            phi_6950_ = u32();
                                        }
                                        let _e4848 = phi_6947_;
                                        let _e4850 = phi_6949_;
                                        let _e4852 = phi_6950_;
                                        phi_6951_ = _e4848;
                                        phi_6953_ = _e4539;
                                        phi_6954_ = _e4850;
                                        phi_6955_ = _e4852;
                                        phi_6956_ = _e4541;
                                        phi_6957_ = _e4543;
                                        phi_6958_ = _e4545;
                                        phi_6959_ = _e4547;
                                        phi_6960_ = _e4549;
                                    }
                                    let _e4854 = phi_6951_;
                                    let _e4856 = phi_6953_;
                                    let _e4858 = phi_6954_;
                                    let _e4860 = phi_6955_;
                                    let _e4862 = phi_6956_;
                                    let _e4864 = phi_6957_;
                                    let _e4866 = phi_6958_;
                                    let _e4868 = phi_6959_;
                                    let _e4870 = phi_6960_;
                                    if _e4870 {
                                        if _e4856 {
                                            let _e4871 = (_e4860 + 1u);
                                            let _e4873 = (_e4871 & (4294967295u - _e4860));
                                            let _e4879 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e4873)), 32u, (_e4873 == 0u)));
                                            if (_e4858 < _e4879) {
                                                phi_6979_ = _e4858;
                                            } else {
                                                phi_6979_ = _e4879;
                                            }
                                            let _e4882 = phi_6979_;
                                            let _e4885 = (_e4871 >> bitcast<u32>((_e4882 & 31u)));
                                            let _e4886 = (_e4858 - _e4882);
                                            if (_e4885 == 1u) {
                                                if (_e4886 == 0u) {
                                                    phi_6991_ = false;
                                                } else {
                                                    phi_6991_ = true;
                                                }
                                                let _e4890 = phi_6991_;
                                                phi_6992_ = _e4890;
                                            } else {
                                                phi_6992_ = true;
                                            }
                                            let _e4892 = phi_6992_;
                                            if _e4892 {
                                                let _e4893 = (31u - _e4886);
                                                let _e4896 = (_e4885 << bitcast<u32>((_e4893 & 31u)));
                                                let _e4900 = ((_e4885 + 1u) << bitcast<u32>((_e4893 & 31u)));
                                                if (_e2906 < _e2833.member_1) {
                                                    phi_7010_ = 1u;
                                                } else {
                                                    phi_7010_ = 0u;
                                                }
                                                let _e4903 = phi_7010_;
                                                let _e4907 = function_4(((_e2911 - _e2833.member) - _e4903), (_e2906 - _e2833.member_1), _e4896);
                                                let _e4910 = (_e2833.member_1 + _e4907.member_1);
                                                if (_e4910 < _e2833.member_1) {
                                                    phi_7022_ = 1u;
                                                } else {
                                                    phi_7022_ = 0u;
                                                }
                                                let _e4913 = phi_7022_;
                                                if (_e2982 < _e2906) {
                                                    phi_7033_ = 1u;
                                                } else {
                                                    phi_7033_ = 0u;
                                                }
                                                let _e4918 = phi_7033_;
                                                let _e4922 = function_4(((_e2987 - _e2911) - _e4918), (_e2982 - _e2906), _e4896);
                                                let _e4925 = (_e2906 + _e4922.member_1);
                                                if (_e4925 < _e2906) {
                                                    phi_7045_ = 1u;
                                                } else {
                                                    phi_7045_ = 0u;
                                                }
                                                let _e4928 = phi_7045_;
                                                if (_e3023.member_1 < _e2982) {
                                                    phi_7056_ = 1u;
                                                } else {
                                                    phi_7056_ = 0u;
                                                }
                                                let _e4933 = phi_7056_;
                                                let _e4937 = function_4(((_e3023.member - _e2987) - _e4933), (_e3023.member_1 - _e2982), _e4896);
                                                let _e4940 = (_e2982 + _e4937.member_1);
                                                if (_e4940 < _e2982) {
                                                    phi_7068_ = 1u;
                                                } else {
                                                    phi_7068_ = 0u;
                                                }
                                                let _e4943 = phi_7068_;
                                                let _e4949 = array<type_9, 3>(type_9(((_e2833.member + _e4907.member) + _e4913), _e4910), type_9(((_e2911 + _e4922.member) + _e4928), _e4925), type_9(((_e2987 + _e4937.member) + _e4943), _e4940));
                                                if (_e2906 < _e2833.member_1) {
                                                    phi_7085_ = 1u;
                                                } else {
                                                    phi_7085_ = 0u;
                                                }
                                                let _e4952 = phi_7085_;
                                                let _e4956 = function_4(((_e2911 - _e2833.member) - _e4952), (_e2906 - _e2833.member_1), _e4900);
                                                let _e4959 = (_e2833.member_1 + _e4956.member_1);
                                                if (_e4959 < _e2833.member_1) {
                                                    phi_7097_ = 1u;
                                                } else {
                                                    phi_7097_ = 0u;
                                                }
                                                let _e4962 = phi_7097_;
                                                if (_e2982 < _e2906) {
                                                    phi_7108_ = 1u;
                                                } else {
                                                    phi_7108_ = 0u;
                                                }
                                                let _e4967 = phi_7108_;
                                                let _e4971 = function_4(((_e2987 - _e2911) - _e4967), (_e2982 - _e2906), _e4900);
                                                let _e4974 = (_e2906 + _e4971.member_1);
                                                if (_e4974 < _e2906) {
                                                    phi_7120_ = 1u;
                                                } else {
                                                    phi_7120_ = 0u;
                                                }
                                                let _e4977 = phi_7120_;
                                                if (_e3023.member_1 < _e2982) {
                                                    phi_7131_ = 1u;
                                                } else {
                                                    phi_7131_ = 0u;
                                                }
                                                let _e4982 = phi_7131_;
                                                let _e4986 = function_4(((_e3023.member - _e2987) - _e4982), (_e3023.member_1 - _e2982), _e4900);
                                                let _e4989 = (_e2982 + _e4986.member_1);
                                                if (_e4989 < _e2982) {
                                                    phi_7143_ = 1u;
                                                } else {
                                                    phi_7143_ = 0u;
                                                }
                                                let _e4992 = phi_7143_;
                                                let _e4999 = function_5(_e4949, _e4896);
                                                let _e5000 = function_5(_e4949, _e4900);
                                                let _e5001 = function_5(array<type_9, 3>(type_9(((_e2833.member + _e4956.member) + _e4962), _e4959), type_9(((_e2911 + _e4971.member) + _e4977), _e4974), type_9(((_e2987 + _e4986.member) + _e4992), _e4989)), _e4900);
                                                if (_e4999[1].member_1 < _e4999[0].member_1) {
                                                    phi_7163_ = 1u;
                                                } else {
                                                    phi_7163_ = 0u;
                                                }
                                                let _e5012 = phi_7163_;
                                                let _e5016 = function_4(((_e4999[1].member - _e4999[0].member) - _e5012), (_e4999[1].member_1 - _e4999[0].member_1), _e4896);
                                                let _e5019 = (_e4999[0].member_1 + _e5016.member_1);
                                                if (_e5019 < _e4999[0].member_1) {
                                                    phi_7175_ = 1u;
                                                } else {
                                                    phi_7175_ = 0u;
                                                }
                                                let _e5022 = phi_7175_;
                                                if (_e4999[1].member_1 < _e4999[0].member_1) {
                                                    phi_7186_ = 1u;
                                                } else {
                                                    phi_7186_ = 0u;
                                                }
                                                let _e5035 = phi_7186_;
                                                let _e5039 = function_4(((_e4999[1].member - _e4999[0].member) - _e5035), (_e4999[1].member_1 - _e4999[0].member_1), _e4900);
                                                let _e5042 = (_e4999[0].member_1 + _e5039.member_1);
                                                if (_e5042 < _e4999[0].member_1) {
                                                    phi_7198_ = 1u;
                                                } else {
                                                    phi_7198_ = 0u;
                                                }
                                                let _e5045 = phi_7198_;
                                                if (_e5000[1].member_1 < _e5000[0].member_1) {
                                                    phi_7209_ = 1u;
                                                } else {
                                                    phi_7209_ = 0u;
                                                }
                                                let _e5058 = phi_7209_;
                                                let _e5062 = function_4(((_e5000[1].member - _e5000[0].member) - _e5058), (_e5000[1].member_1 - _e5000[0].member_1), _e4900);
                                                let _e5065 = (_e5000[0].member_1 + _e5062.member_1);
                                                if (_e5065 < _e5000[0].member_1) {
                                                    phi_7221_ = 1u;
                                                } else {
                                                    phi_7221_ = 0u;
                                                }
                                                let _e5068 = phi_7221_;
                                                if (_e5001[1].member_1 < _e5001[0].member_1) {
                                                    phi_7232_ = 1u;
                                                } else {
                                                    phi_7232_ = 0u;
                                                }
                                                let _e5081 = phi_7232_;
                                                let _e5085 = function_4(((_e5001[1].member - _e5001[0].member) - _e5081), (_e5001[1].member_1 - _e5001[0].member_1), _e4900);
                                                let _e5088 = (_e5001[0].member_1 + _e5085.member_1);
                                                if (_e5088 < _e5001[0].member_1) {
                                                    phi_7244_ = 1u;
                                                } else {
                                                    phi_7244_ = 0u;
                                                }
                                                let _e5091 = phi_7244_;
                                                phi_7255_ = array<type_9, 4>(type_9(((_e4999[0].member + _e5016.member) + _e5022), _e5019), type_9(((_e4999[0].member + _e5039.member) + _e5045), _e5042), type_9(((_e5000[0].member + _e5062.member) + _e5068), _e5065), type_9(((_e5001[0].member + _e5085.member) + _e5091), _e5088));
                                            } else {
                                                phi_7255_ = array<type_9, 4>();
                                            }
                                            let _e5100 = phi_7255_;
                                            phi_7256_ = _e5100;
                                            phi_7257_ = _e4886;
                                            phi_7258_ = _e4885;
                                            phi_7259_ = _e4892;
                                        } else {
                                            phi_7256_ = _e4854;
                                            phi_7257_ = _e4858;
                                            phi_7258_ = _e4860;
                                            phi_7259_ = true;
                                        }
                                        let _e5102 = phi_7256_;
                                        let _e5104 = phi_7257_;
                                        let _e5106 = phi_7258_;
                                        let _e5108 = phi_7259_;
                                        if _e5108 {
                                            phi_7263_ = false;
                                        } else {
                                            phi_7263_ = true;
                                        }
                                        let _e5110 = phi_7263_;
                                        phi_7264_ = _e5102;
                                        phi_7265_ = _e5104;
                                        phi_7266_ = _e5106;
                                        phi_7267_ = _e5108;
                                        phi_7268_ = _e5110;
                                        phi_7269_ = false;
                                    } else {
                                        phi_7264_ = array<type_9, 4>();
                                        phi_7265_ = u32();
                                        phi_7266_ = u32();
                                        phi_7267_ = false;
                                        phi_7268_ = false;
                                        phi_7269_ = true;
                                    }
                                    let _e5112 = phi_7264_;
                                    let _e5114 = phi_7265_;
                                    let _e5116 = phi_7266_;
                                    let _e5118 = phi_7267_;
                                    let _e5120 = phi_7268_;
                                    let _e5122 = phi_7269_;
                                    phi_7270_ = _e5112;
                                    phi_7272_ = _e5114;
                                    phi_7273_ = _e5116;
                                    phi_7274_ = _e4862;
                                    phi_7275_ = _e4864;
                                    phi_7276_ = _e4866;
                                    phi_7277_ = _e4868;
                                    phi_7278_ = _e5118;
                                    phi_7279_ = _e5120;
                                    phi_7280_ = _e5122;
                                }
                                let _e5124 = phi_7270_;
                                let _e5126 = phi_7272_;
                                let _e5128 = phi_7273_;
                                let _e5130 = phi_7274_;
                                let _e5132 = phi_7275_;
                                let _e5134 = phi_7276_;
                                let _e5136 = phi_7277_;
                                let _e5138 = phi_7278_;
                                let _e5140 = phi_7279_;
                                let _e5142 = phi_7280_;
                                phi_4557_ = _e5124;
                                phi_4561_ = _e5126;
                                phi_4563_ = _e5128;
                                phi_7281_ = _e3058;
                                phi_7282_ = _e5130;
                                phi_7283_ = _e5132;
                                phi_7284_ = _e5134;
                                phi_7285_ = _e5136;
                                phi_7286_ = _e5138;
                                phi_7287_ = _e3063;
                                phi_7288_ = false;
                                phi_7289_ = _e5140;
                                phi_7290_ = _e5142;
                            } else {
                                phi_4557_ = array<type_9, 4>();
                                phi_4561_ = u32();
                                phi_4563_ = u32();
                                phi_7281_ = u32();
                                phi_7282_ = bool();
                                phi_7283_ = bool();
                                phi_7284_ = u32();
                                phi_7285_ = u32();
                                phi_7286_ = false;
                                phi_7287_ = false;
                                phi_7288_ = true;
                                phi_7289_ = false;
                                phi_7290_ = false;
                            }
                            let _e5144 = phi_4557_;
                            let _e5146 = phi_4561_;
                            let _e5148 = phi_4563_;
                            let _e5150 = phi_7281_;
                            let _e5152 = phi_7282_;
                            let _e5154 = phi_7283_;
                            let _e5156 = phi_7284_;
                            let _e5158 = phi_7285_;
                            let _e5160 = phi_7286_;
                            let _e5162 = phi_7287_;
                            let _e5164 = phi_7288_;
                            let _e5166 = phi_7289_;
                            let _e5168 = phi_7290_;
                            local_62 = _e5162;
                            local_129 = _e5164;
                            local_130 = _e5166;
                            local_131 = _e5168;
                            local_132 = _e5162;
                            local_63 = _e5154;
                            local_64 = _e5156;
                            local_68 = _e5156;
                            local_69 = _e5156;
                            local_70 = _e5156;
                            local_71 = _e5156;
                            local_72 = _e5156;
                            local_73 = _e5156;
                            local_74 = _e5156;
                            local_75 = _e5156;
                            local_76 = _e5156;
                            local_77 = _e5156;
                            local_78 = _e5156;
                            local_79 = _e5156;
                            local_80 = _e5156;
                            local_133 = _e5152;
                            local_81 = _e5150;
                            local_82 = _e5156;
                            local_83 = _e5158;
                            local_84 = _e5150;
                            continue;
                            continuing {
                                phi_4553_ = _e3049;
                                phi_4556_ = _e5144;
                                phi_4560_ = _e5146;
                                phi_4562_ = _e5148;
                                break if !(_e5160);
                            }
                        }
                        let _e5171 = local_62;
                        if _e5171 {
                            phi_7295_ = type_9(0u, type_9().member_1);
                            phi_7296_ = false;
                            phi_7297_ = false;
                            phi_7298_ = false;
                        } else {
                            phi_7295_ = type_9();
                            let _e15789 = local_129;
                            phi_7296_ = _e15789;
                            let _e15792 = local_130;
                            phi_7297_ = _e15792;
                            let _e15795 = local_131;
                            phi_7298_ = _e15795;
                        }
                        let _e5175 = phi_7295_;
                        let _e5177 = phi_7296_;
                        let _e5179 = phi_7297_;
                        let _e5181 = phi_7298_;
                        if _e5177 {
                            phi_7303_ = type_9(2u, type_9().member_1);
                            phi_7304_ = false;
                            phi_7305_ = false;
                            phi_7306_ = false;
                        } else {
                            phi_7303_ = type_9();
                            phi_7304_ = _e5179;
                            phi_7305_ = _e5181;
                            let _e15801 = local_132;
                            phi_7306_ = _e15801;
                        }
                        let _e5185 = phi_7303_;
                        let _e5187 = phi_7304_;
                        let _e5189 = phi_7305_;
                        let _e5191 = phi_7306_;
                        if _e5187 {
                            phi_7311_ = type_9(0u, type_9().member_1);
                            phi_7312_ = false;
                            phi_7313_ = false;
                        } else {
                            phi_7311_ = type_9();
                            phi_7312_ = _e5189;
                            phi_7313_ = _e5191;
                        }
                        let _e5195 = phi_7311_;
                        let _e5197 = phi_7312_;
                        let _e5199 = phi_7313_;
                        if _e5197 {
                            let _e5201 = local_63;
                            if _e5201 {
                                let _e5203 = local_64;
                                if (_e5203 <= 2147483648u) {
                                    let _e5206 = local_65;
                                    let _e5210 = local_66;
                                    let _e5213 = function_10(128u);
                                    if ((_e5206[0].member >> bitcast<u32>(31i)) != 0u) {
                                        if (_e5210[0].member_1 == 0u) {
                                            phi_7338_ = 1u;
                                        } else {
                                            phi_7338_ = 0u;
                                        }
                                        let _e5224 = phi_7338_;
                                        phi_7345_ = type_9((~(_e5206[0].member) + _e5224), (~(_e5210[0].member_1) + 1u));
                                    } else {
                                        let _e5220 = local_67;
                                        phi_7345_ = _e5220[0];
                                    }
                                    let _e5231 = phi_7345_;
                                    if (_e5213.member_1 < _e5231.member_1) {
                                        phi_7352_ = 1u;
                                    } else {
                                        phi_7352_ = 0u;
                                    }
                                    let _e5236 = phi_7352_;
                                    if ((((_e5213.member - _e5231.member) - _e5236) >> bitcast<u32>(31i)) != 0u) {
                                        if ((_e5206[0].member >> bitcast<u32>(31i)) != 0u) {
                                            phi_7365_ = 2u;
                                        } else {
                                            phi_7365_ = 1u;
                                        }
                                        let _e5246 = phi_7365_;
                                        phi_7366_ = _e5246;
                                    } else {
                                        phi_7366_ = 0u;
                                    }
                                    let _e5248 = phi_7366_;
                                    if (_e2906 < _e2833.member_1) {
                                        phi_7375_ = 1u;
                                    } else {
                                        phi_7375_ = 0u;
                                    }
                                    let _e5251 = phi_7375_;
                                    let _e5256 = local_68;
                                    let _e5257 = function_4(((_e2911 - _e2833.member) - _e5251), (_e2906 - _e2833.member_1), _e5256);
                                    let _e5260 = (_e2833.member_1 + _e5257.member_1);
                                    if (_e5260 < _e2833.member_1) {
                                        phi_7387_ = 1u;
                                    } else {
                                        phi_7387_ = 0u;
                                    }
                                    let _e5263 = phi_7387_;
                                    if (_e2982 < _e2906) {
                                        phi_7398_ = 1u;
                                    } else {
                                        phi_7398_ = 0u;
                                    }
                                    let _e5268 = phi_7398_;
                                    let _e5273 = local_69;
                                    let _e5274 = function_4(((_e2987 - _e2911) - _e5268), (_e2982 - _e2906), _e5273);
                                    let _e5277 = (_e2906 + _e5274.member_1);
                                    if (_e5277 < _e2906) {
                                        phi_7410_ = 1u;
                                    } else {
                                        phi_7410_ = 0u;
                                    }
                                    let _e5280 = phi_7410_;
                                    if (_e3023.member_1 < _e2982) {
                                        phi_7421_ = 1u;
                                    } else {
                                        phi_7421_ = 0u;
                                    }
                                    let _e5285 = phi_7421_;
                                    let _e5290 = local_70;
                                    let _e5291 = function_4(((_e3023.member - _e2987) - _e5285), (_e3023.member_1 - _e2982), _e5290);
                                    let _e5294 = (_e2982 + _e5291.member_1);
                                    if (_e5294 < _e2982) {
                                        phi_7433_ = 1u;
                                    } else {
                                        phi_7433_ = 0u;
                                    }
                                    let _e5297 = phi_7433_;
                                    let _e5303 = array<type_9, 3>(type_9(((_e2833.member + _e5257.member) + _e5263), _e5260), type_9(((_e2911 + _e5274.member) + _e5280), _e5277), type_9(((_e2987 + _e5291.member) + _e5297), _e5294));
                                    if (_e2906 < _e2833.member_1) {
                                        phi_7450_ = 1u;
                                    } else {
                                        phi_7450_ = 0u;
                                    }
                                    let _e5306 = phi_7450_;
                                    let _e5311 = local_71;
                                    let _e5312 = function_4(((_e2911 - _e2833.member) - _e5306), (_e2906 - _e2833.member_1), _e5311);
                                    let _e5315 = (_e2833.member_1 + _e5312.member_1);
                                    if (_e5315 < _e2833.member_1) {
                                        phi_7462_ = 1u;
                                    } else {
                                        phi_7462_ = 0u;
                                    }
                                    let _e5318 = phi_7462_;
                                    if (_e2982 < _e2906) {
                                        phi_7473_ = 1u;
                                    } else {
                                        phi_7473_ = 0u;
                                    }
                                    let _e5323 = phi_7473_;
                                    let _e5328 = local_72;
                                    let _e5329 = function_4(((_e2987 - _e2911) - _e5323), (_e2982 - _e2906), _e5328);
                                    let _e5332 = (_e2906 + _e5329.member_1);
                                    if (_e5332 < _e2906) {
                                        phi_7485_ = 1u;
                                    } else {
                                        phi_7485_ = 0u;
                                    }
                                    let _e5335 = phi_7485_;
                                    if (_e3023.member_1 < _e2982) {
                                        phi_7496_ = 1u;
                                    } else {
                                        phi_7496_ = 0u;
                                    }
                                    let _e5340 = phi_7496_;
                                    let _e5345 = local_73;
                                    let _e5346 = function_4(((_e3023.member - _e2987) - _e5340), (_e3023.member_1 - _e2982), _e5345);
                                    let _e5349 = (_e2982 + _e5346.member_1);
                                    if (_e5349 < _e2982) {
                                        phi_7508_ = 1u;
                                    } else {
                                        phi_7508_ = 0u;
                                    }
                                    let _e5352 = phi_7508_;
                                    let _e5360 = local_74;
                                    let _e5361 = function_5(_e5303, _e5360);
                                    let _e5363 = local_75;
                                    let _e5364 = function_5(_e5303, _e5363);
                                    let _e5366 = local_76;
                                    let _e5367 = function_5(array<type_9, 3>(type_9(((_e2833.member + _e5312.member) + _e5318), _e5315), type_9(((_e2911 + _e5329.member) + _e5335), _e5332), type_9(((_e2987 + _e5346.member) + _e5352), _e5349)), _e5366);
                                    if (_e5361[1].member_1 < _e5361[0].member_1) {
                                        phi_7528_ = 1u;
                                    } else {
                                        phi_7528_ = 0u;
                                    }
                                    let _e5378 = phi_7528_;
                                    let _e5383 = local_77;
                                    let _e5384 = function_4(((_e5361[1].member - _e5361[0].member) - _e5378), (_e5361[1].member_1 - _e5361[0].member_1), _e5383);
                                    let _e5387 = (_e5361[0].member_1 + _e5384.member_1);
                                    if (_e5387 < _e5361[0].member_1) {
                                        phi_7540_ = 1u;
                                    } else {
                                        phi_7540_ = 0u;
                                    }
                                    let _e5390 = phi_7540_;
                                    let _e5392 = ((_e5361[0].member + _e5384.member) + _e5390);
                                    if (_e5361[1].member_1 < _e5361[0].member_1) {
                                        phi_7551_ = 1u;
                                    } else {
                                        phi_7551_ = 0u;
                                    }
                                    let _e5403 = phi_7551_;
                                    let _e5408 = local_78;
                                    let _e5409 = function_4(((_e5361[1].member - _e5361[0].member) - _e5403), (_e5361[1].member_1 - _e5361[0].member_1), _e5408);
                                    if (_e5364[1].member_1 < _e5364[0].member_1) {
                                        phi_7574_ = 1u;
                                    } else {
                                        phi_7574_ = 0u;
                                    }
                                    let _e5420 = phi_7574_;
                                    let _e5425 = local_79;
                                    let _e5426 = function_4(((_e5364[1].member - _e5364[0].member) - _e5420), (_e5364[1].member_1 - _e5364[0].member_1), _e5425);
                                    if (_e5367[1].member_1 < _e5367[0].member_1) {
                                        phi_7597_ = 1u;
                                    } else {
                                        phi_7597_ = 0u;
                                    }
                                    let _e5437 = phi_7597_;
                                    let _e5442 = local_80;
                                    let _e5443 = function_4(((_e5367[1].member - _e5367[0].member) - _e5437), (_e5367[1].member_1 - _e5367[0].member_1), _e5442);
                                    let _e5444 = function_10(128u);
                                    if ((_e5392 >> bitcast<u32>(31i)) != 0u) {
                                        if (_e5387 == 0u) {
                                            phi_7634_ = 1u;
                                        } else {
                                            phi_7634_ = 0u;
                                        }
                                        let _e5453 = phi_7634_;
                                        phi_7641_ = type_9((~(_e5392) + _e5453), (~(_e5387) + 1u));
                                    } else {
                                        phi_7641_ = type_9(_e5392, _e5387);
                                    }
                                    let _e5460 = phi_7641_;
                                    if (_e5444.member_1 < _e5460.member_1) {
                                        phi_7648_ = 1u;
                                    } else {
                                        phi_7648_ = 0u;
                                    }
                                    let _e5465 = phi_7648_;
                                    if ((((_e5444.member - _e5460.member) - _e5465) >> bitcast<u32>(31i)) != 0u) {
                                        if ((_e5392 >> bitcast<u32>(31i)) != 0u) {
                                            phi_7661_ = 2u;
                                        } else {
                                            phi_7661_ = 1u;
                                        }
                                        let _e5475 = phi_7661_;
                                        phi_7662_ = _e5475;
                                    } else {
                                        phi_7662_ = 0u;
                                    }
                                    let _e5477 = phi_7662_;
                                    phi_7665_ = ((_e5248 | _e5477) == 3u);
                                    phi_7666_ = false;
                                } else {
                                    phi_7665_ = bool();
                                    phi_7666_ = true;
                                }
                                let _e5481 = phi_7665_;
                                let _e5483 = phi_7666_;
                                phi_7667_ = _e5481;
                                phi_7668_ = _e5483;
                            } else {
                                phi_7667_ = bool();
                                phi_7668_ = true;
                            }
                            let _e5485 = phi_7667_;
                            let _e5487 = phi_7668_;
                            if _e5487 {
                                let _e15856 = local_133;
                                phi_7672_ = _e15856;
                            } else {
                                phi_7672_ = _e5485;
                            }
                            let _e5489 = phi_7672_;
                            let _e5491 = local_81;
                            if (_e5491 >= _e1452) {
                                let _e5494 = local_82;
                                phi_7678_ = (_e5494 <= _e1454);
                            } else {
                                phi_7678_ = false;
                            }
                            let _e5497 = phi_7678_;
                            if _e5489 {
                                if _e5497 {
                                    let _e5499 = local_83;
                                    phi_7686_ = (_e5499 == 0u);
                                    phi_7687_ = false;
                                } else {
                                    phi_7686_ = bool();
                                    phi_7687_ = true;
                                }
                                let _e5502 = phi_7686_;
                                let _e5504 = phi_7687_;
                                phi_7688_ = _e5502;
                                phi_7689_ = _e5504;
                            } else {
                                phi_7688_ = bool();
                                phi_7689_ = true;
                            }
                            let _e5506 = phi_7688_;
                            let _e5508 = phi_7689_;
                            if _e5508 {
                                phi_7693_ = false;
                            } else {
                                phi_7693_ = _e5506;
                            }
                            let _e5510 = phi_7693_;
                            if _e5510 {
                                let _e5514 = local_84;
                                phi_7699_ = type_9(1u, _e5514);
                            } else {
                                phi_7699_ = type_9(2u, type_9().member_1);
                            }
                            let _e5517 = phi_7699_;
                            phi_7700_ = _e5517;
                            phi_7701_ = true;
                            phi_7702_ = false;
                        } else {
                            phi_7700_ = _e5195;
                            phi_7701_ = _e5187;
                            phi_7702_ = _e5199;
                        }
                        let _e5519 = phi_7700_;
                        let _e5521 = phi_7701_;
                        let _e5523 = phi_7702_;
                        if _e5521 {
                            phi_7706_ = _e5519;
                            phi_7707_ = true;
                        } else {
                            phi_7706_ = _e5175;
                            phi_7707_ = _e5523;
                        }
                        let _e5525 = phi_7706_;
                        let _e5527 = phi_7707_;
                        if _e5527 {
                            phi_7711_ = _e5525;
                        } else {
                            phi_7711_ = _e5185;
                        }
                        let _e5529 = phi_7711_;
                        switch bitcast<i32>(_e5529.member) {
                            case 0: {
                                phi_7748_ = type_28(0u, 0u, array<u32, 2>(0u, 0u), false);
                                break;
                            }
                            case 1: {
                                if (_e5529.member_1 > _e1452) {
                                    phi_7724_ = 1u;
                                } else {
                                    phi_7724_ = 0u;
                                }
                                let _e5535 = phi_7724_;
                                if (_e5529.member_1 == 0u) {
                                    phi_7742_ = array<u32, 2>(0u, 0u);
                                } else {
                                    let _e5541 = select((bitcast<u32>(31i) - firstLeadingBit(_e5529.member_1)), 32u, (_e5529.member_1 == 0u));
                                    let _e5546 = ((_e5529.member_1 << bitcast<u32>((_e5541 & 31u))) << bitcast<u32>(1i));
                                    phi_7742_ = array<u32, 2>((_e5546 << bitcast<u32>(20i)), (((1023u - _e5541) << bitcast<u32>(20i)) | (_e5546 >> bitcast<u32>(12i))));
                                }
                                let _e5557 = phi_7742_;
                                phi_7748_ = type_28(0u, _e5535, _e5557, true);
                                break;
                            }
                            case 2: {
                                phi_7748_ = type_28(1u, 0u, array<u32, 2>(0u, 0u), true);
                                break;
                            }
                            default: {
                                phi_7748_ = type_28();
                                break;
                            }
                        }
                        let _e5560 = phi_7748_;
                        if (_e5560.member == 0u) {
                            phi_7754_ = false;
                        } else {
                            phi_7754_ = true;
                        }
                        let _e5564 = phi_7754_;
                        phi_7755_ = _e5560;
                        phi_7756_ = _e5564;
                    } else {
                        phi_7755_ = type_28();
                        phi_7756_ = true;
                    }
                    let _e5566 = phi_7755_;
                    let _e5568 = phi_7756_;
                    phi_7757_ = _e5566;
                    phi_7758_ = _e5568;
                } else {
                    phi_7757_ = type_28();
                    phi_7758_ = true;
                }
                let _e5570 = phi_7757_;
                let _e5572 = phi_7758_;
                if _e5572 {
                    let _e5574 = params.member.member.member_12;
                    let _e5575 = bitcast<u32>(_e5574);
                    let _e5576 = (_e5575 & 2147483647u);
                    if (_e5576 < 8388608u) {
                        phi_7776_ = array<u32, 2>(0u, 0u);
                    } else {
                        phi_7776_ = array<u32, 2>((_e5575 << bitcast<u32>(29i)), ((_e5575 ^ _e5576) | ((_e5576 >> bitcast<u32>(3i)) + 939524096u)));
                    }
                    let _e5587 = phi_7776_;
                    let _e5591 = params.member.member.member_15[0u];
                    if (_e5587[0] == _e5591) {
                        let _e5596 = params.member.member.member_15[1u];
                        phi_7790_ = (_e5587[1] == _e5596);
                    } else {
                        phi_7790_ = false;
                    }
                    let _e5599 = phi_7790_;
                    let _e5601 = params.member.member.member_5;
                    let _e5603 = params.member.member.member_11;
                    let _e5605 = params.member.member.member_12;
                    let _e5607 = params.member.member.member_13;
                    let _e5609 = params.member.member.member_1;
                    if ((_e5609 & 64u) != 0u) {
                        phi_7806_ = _e5599;
                    } else {
                        phi_7806_ = false;
                    }
                    let _e5613 = phi_7806_;
                    if (_e561.member[0][0] < 0f) {
                        phi_7814_ = -(_e561.member[0][0]);
                    } else {
                        phi_7814_ = _e561.member[0][0];
                    }
                    let _e5620 = phi_7814_;
                    if (_e561.member[0][1] < 0f) {
                        phi_7821_ = -(_e561.member[0][1]);
                    } else {
                        phi_7821_ = _e561.member[0][1];
                    }
                    let _e5625 = phi_7821_;
                    if (_e5620 > _e5625) {
                        phi_7826_ = _e5620;
                    } else {
                        phi_7826_ = _e5625;
                    }
                    let _e5628 = phi_7826_;
                    if (_e561.member[0][2] < 0f) {
                        phi_7833_ = -(_e561.member[0][2]);
                    } else {
                        phi_7833_ = _e561.member[0][2];
                    }
                    let _e5633 = phi_7833_;
                    if (_e5628 > _e5633) {
                        phi_7838_ = _e5628;
                    } else {
                        phi_7838_ = _e5633;
                    }
                    let _e5636 = phi_7838_;
                    if (_e561.member[1][0] < 0f) {
                        phi_7846_ = -(_e561.member[1][0]);
                    } else {
                        phi_7846_ = _e561.member[1][0];
                    }
                    let _e5643 = phi_7846_;
                    if (_e561.member[1][1] < 0f) {
                        phi_7853_ = -(_e561.member[1][1]);
                    } else {
                        phi_7853_ = _e561.member[1][1];
                    }
                    let _e5648 = phi_7853_;
                    if (_e5643 > _e5648) {
                        phi_7858_ = _e5643;
                    } else {
                        phi_7858_ = _e5648;
                    }
                    let _e5651 = phi_7858_;
                    if (_e561.member[1][2] < 0f) {
                        phi_7865_ = -(_e561.member[1][2]);
                    } else {
                        phi_7865_ = _e561.member[1][2];
                    }
                    let _e5656 = phi_7865_;
                    if (_e5651 > _e5656) {
                        phi_7870_ = _e5651;
                    } else {
                        phi_7870_ = _e5656;
                    }
                    let _e5659 = phi_7870_;
                    if (_e5636 > _e5659) {
                        phi_7875_ = _e5636;
                    } else {
                        phi_7875_ = _e5659;
                    }
                    let _e5662 = phi_7875_;
                    let _e5664 = (_e5662 + _e561.member_3);
                    if (_e561.member_1[0][0] < 0f) {
                        phi_7885_ = -(_e561.member_1[0][0]);
                    } else {
                        phi_7885_ = _e561.member_1[0][0];
                    }
                    let _e5671 = phi_7885_;
                    if (_e561.member_1[0][1] < 0f) {
                        phi_7892_ = -(_e561.member_1[0][1]);
                    } else {
                        phi_7892_ = _e561.member_1[0][1];
                    }
                    let _e5676 = phi_7892_;
                    if (_e5671 > _e5676) {
                        phi_7897_ = _e5671;
                    } else {
                        phi_7897_ = _e5676;
                    }
                    let _e5679 = phi_7897_;
                    if (_e561.member_1[0][2] < 0f) {
                        phi_7904_ = -(_e561.member_1[0][2]);
                    } else {
                        phi_7904_ = _e561.member_1[0][2];
                    }
                    let _e5684 = phi_7904_;
                    if (_e5679 > _e5684) {
                        phi_7909_ = _e5679;
                    } else {
                        phi_7909_ = _e5684;
                    }
                    let _e5687 = phi_7909_;
                    if (_e561.member_1[1][0] < 0f) {
                        phi_7917_ = -(_e561.member_1[1][0]);
                    } else {
                        phi_7917_ = _e561.member_1[1][0];
                    }
                    let _e5694 = phi_7917_;
                    if (_e561.member_1[1][1] < 0f) {
                        phi_7924_ = -(_e561.member_1[1][1]);
                    } else {
                        phi_7924_ = _e561.member_1[1][1];
                    }
                    let _e5699 = phi_7924_;
                    if (_e5694 > _e5699) {
                        phi_7929_ = _e5694;
                    } else {
                        phi_7929_ = _e5699;
                    }
                    let _e5702 = phi_7929_;
                    if (_e561.member_1[1][2] < 0f) {
                        phi_7936_ = -(_e561.member_1[1][2]);
                    } else {
                        phi_7936_ = _e561.member_1[1][2];
                    }
                    let _e5707 = phi_7936_;
                    if (_e5702 > _e5707) {
                        phi_7941_ = _e5702;
                    } else {
                        phi_7941_ = _e5707;
                    }
                    let _e5710 = phi_7941_;
                    if (_e5687 > _e5710) {
                        phi_7946_ = _e5687;
                    } else {
                        phi_7946_ = _e5710;
                    }
                    let _e5713 = phi_7946_;
                    let _e5715 = (_e5713 + _e561.member_3);
                    if (_e561.member_2[0][0] < 0f) {
                        phi_7956_ = -(_e561.member_2[0][0]);
                    } else {
                        phi_7956_ = _e561.member_2[0][0];
                    }
                    let _e5722 = phi_7956_;
                    if (_e561.member_2[0][1] < 0f) {
                        phi_7963_ = -(_e561.member_2[0][1]);
                    } else {
                        phi_7963_ = _e561.member_2[0][1];
                    }
                    let _e5727 = phi_7963_;
                    if (_e5722 > _e5727) {
                        phi_7968_ = _e5722;
                    } else {
                        phi_7968_ = _e5727;
                    }
                    let _e5730 = phi_7968_;
                    if (_e561.member_2[0][2] < 0f) {
                        phi_7975_ = -(_e561.member_2[0][2]);
                    } else {
                        phi_7975_ = _e561.member_2[0][2];
                    }
                    let _e5735 = phi_7975_;
                    if (_e5730 > _e5735) {
                        phi_7980_ = _e5730;
                    } else {
                        phi_7980_ = _e5735;
                    }
                    let _e5738 = phi_7980_;
                    if (_e561.member_2[1][0] < 0f) {
                        phi_7988_ = -(_e561.member_2[1][0]);
                    } else {
                        phi_7988_ = _e561.member_2[1][0];
                    }
                    let _e5745 = phi_7988_;
                    if (_e561.member_2[1][1] < 0f) {
                        phi_7995_ = -(_e561.member_2[1][1]);
                    } else {
                        phi_7995_ = _e561.member_2[1][1];
                    }
                    let _e5750 = phi_7995_;
                    if (_e5745 > _e5750) {
                        phi_8000_ = _e5745;
                    } else {
                        phi_8000_ = _e5750;
                    }
                    let _e5753 = phi_8000_;
                    if (_e561.member_2[1][2] < 0f) {
                        phi_8007_ = -(_e561.member_2[1][2]);
                    } else {
                        phi_8007_ = _e561.member_2[1][2];
                    }
                    let _e5758 = phi_8007_;
                    if (_e5753 > _e5758) {
                        phi_8012_ = _e5753;
                    } else {
                        phi_8012_ = _e5758;
                    }
                    let _e5761 = phi_8012_;
                    if (_e5738 > _e5761) {
                        phi_8017_ = _e5738;
                    } else {
                        phi_8017_ = _e5761;
                    }
                    let _e5764 = phi_8017_;
                    let _e5766 = (_e5764 + _e561.member_3);
                    if (_e5664 > _e5715) {
                        phi_8024_ = _e5664;
                    } else {
                        phi_8024_ = _e5715;
                    }
                    let _e5769 = phi_8024_;
                    if (_e5769 > _e5766) {
                        phi_8029_ = _e5769;
                    } else {
                        phi_8029_ = _e5766;
                    }
                    let _e5772 = phi_8029_;
                    if (_e5772 <= 65536f) {
                        phi_8036_ = (_e5772 >= (1f / 65536f));
                    } else {
                        phi_8036_ = false;
                    }
                    let _e5777 = phi_8036_;
                    if _e5777 {
                        phi_8134_ = type_43();
                        phi_8135_ = true;
                    } else {
                        if (_e5772 >= 0.000000000000000000000000000000000000011754944f) {
                            if ((bitcast<u32>(_e5772) & 2139095040u) != 2139095040u) {
                                let _e5784 = (2130706432u - (bitcast<u32>(_e5772) & 2139095040u));
                                if (_e5784 > 8388608u) {
                                    phi_8060_ = _e5784;
                                } else {
                                    phi_8060_ = 8388608u;
                                }
                                let _e5787 = phi_8060_;
                                let _e5788 = bitcast<f32>(_e5787);
                                let _e5789 = (_e5601 * _e5788);
                                if (_e5601 > 0f) {
                                    if (_e5789 > 0.000000000000000000000000000000000000011754944f) {
                                        phi_8071_ = _e5789;
                                    } else {
                                        phi_8071_ = 0.000000000000000000000000000000000000011754944f;
                                    }
                                    let _e5793 = phi_8071_;
                                    phi_8072_ = _e5793;
                                } else {
                                    phi_8072_ = _e5789;
                                }
                                let _e5795 = phi_8072_;
                                phi_8130_ = type_43(type_23(array<array<f32, 3>, 2>(array<f32, 3>((_e561.member[0][0] * _e5788), (_e561.member[0][1] * _e5788), (_e561.member[0][2] * _e5788)), array<f32, 3>((_e561.member[1][0] * _e5788), (_e561.member[1][1] * _e5788), (_e561.member[1][2] * _e5788))), array<array<f32, 3>, 2>(array<f32, 3>((_e561.member_1[0][0] * _e5788), (_e561.member_1[0][1] * _e5788), (_e561.member_1[0][2] * _e5788)), array<f32, 3>((_e561.member_1[1][0] * _e5788), (_e561.member_1[1][1] * _e5788), (_e561.member_1[1][2] * _e5788))), array<array<f32, 3>, 2>(array<f32, 3>((_e561.member_2[0][0] * _e5788), (_e561.member_2[0][1] * _e5788), (_e561.member_2[0][2] * _e5788)), array<f32, 3>((_e561.member_2[1][0] * _e5788), (_e561.member_2[1][1] * _e5788), (_e561.member_2[1][2] * _e5788))), ((_e561.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e5788)), _e5795);
                                phi_8131_ = false;
                            } else {
                                phi_8130_ = type_43();
                                phi_8131_ = true;
                            }
                            let _e5860 = phi_8130_;
                            let _e5862 = phi_8131_;
                            phi_8132_ = _e5860;
                            phi_8133_ = _e5862;
                        } else {
                            phi_8132_ = type_43();
                            phi_8133_ = true;
                        }
                        let _e5864 = phi_8132_;
                        let _e5866 = phi_8133_;
                        phi_8134_ = _e5864;
                        phi_8135_ = _e5866;
                    }
                    let _e5868 = phi_8134_;
                    let _e5870 = phi_8135_;
                    if _e5870 {
                        phi_8140_ = type_43(_e561, _e5601);
                    } else {
                        phi_8140_ = _e5868;
                    }
                    let _e5873 = phi_8140_;
                    local_18 = type_23(array<array<f32, 3>, 2>(array<f32, 3>(_e5873.member.member[0][0], _e5873.member.member[0][1], _e5873.member.member[0][2]), array<f32, 3>(_e5873.member.member[1][0], _e5873.member.member[1][1], _e5873.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e5873.member.member_1[0][0], _e5873.member.member_1[0][1], _e5873.member.member_1[0][2]), array<f32, 3>(_e5873.member.member_1[1][0], _e5873.member.member_1[1][1], _e5873.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e5873.member.member_2[0][0], _e5873.member.member_2[0][1], _e5873.member.member_2[0][2]), array<f32, 3>(_e5873.member.member_2[1][0], _e5873.member.member_2[1][1], _e5873.member.member_2[1][2])), _e5873.member.member_3);
                    if (_e5873.member_1 > 0f) {
                        let _e10638 = local_18.member[0u];
                        let _e10644 = local_18.member[1u];
                        let _e10660 = local_18.member_1[0u];
                        let _e10666 = local_18.member_1[1u];
                        let _e10682 = local_18.member_2[0u];
                        let _e10688 = local_18.member_2[1u];
                        let _e10702 = function_3(array<f32, 3>((_e10638[0] + ((_e10644[0] - _e10638[0]) * _e5605)), (_e10638[1] + ((_e10644[1] - _e10638[1]) * _e5605)), (_e10638[2] + ((_e10644[2] - _e10638[2]) * _e5605))), array<f32, 3>((_e10660[0] + ((_e10666[0] - _e10660[0]) * _e5605)), (_e10660[1] + ((_e10666[1] - _e10660[1]) * _e5605)), (_e10660[2] + ((_e10666[2] - _e10660[2]) * _e5605))), array<f32, 3>((_e10682[0] + ((_e10688[0] - _e10682[0]) * _e5605)), (_e10682[1] + ((_e10688[1] - _e10682[1]) * _e5605)), (_e10682[2] + ((_e10688[2] - _e10682[2]) * _e5605))), _e316.member);
                        let _e10713 = (((_e10702[0] * _e10702[0]) + (_e10702[1] * _e10702[1])) + (_e10702[2] * _e10702[2]));
                        if (_e10713 <= 0.000000000000000000000000000000000000011754944f) {
                            if (_e10713 > 0f) {
                                phi_8307_ = (0.000000000000000000106433627f * 2f);
                            } else {
                                phi_8307_ = 0f;
                            }
                            let _e10766 = phi_8307_;
                            phi_8371_ = _e10766;
                        } else {
                            phi_8314_ = type_14(0i, 5i);
                            phi_8317_ = bitcast<f32>(((bitcast<u32>(_e10713) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e10721 = phi_8314_;
                                let _e10723 = phi_8317_;
                                local_105 = _e10723;
                                if (_e10721.member < _e10721.member_1) {
                                    let _e10730 = (_e10721.member + 1i);
                                    if ((false == (_e10730 > _e10721.member)) != false) {
                                        phi_8338_ = true;
                                    } else {
                                        phi_8338_ = false;
                                    }
                                    let _e10735 = phi_8338_;
                                    if _e10735 {
                                        phi_8344_ = type_15(0u, type_15().member_1);
                                    } else {
                                        phi_8344_ = type_15(1u, _e10730);
                                    }
                                    let _e10740 = phi_8344_;
                                    phi_8315_ = type_14(_e10740.member_1, _e10721.member_1);
                                    phi_8358_ = type_15(1u, _e10721.member);
                                } else {
                                    phi_8315_ = _e10721;
                                    phi_8358_ = type_15(0u, type_15().member_1);
                                }
                                let _e10746 = phi_8315_;
                                let _e10748 = phi_8358_;
                                let _e10751 = (bitcast<i32>(_e10748.member) != 0i);
                                if _e10751 {
                                    phi_8318_ = (0.5f * (_e10723 + (_e10713 / _e10723)));
                                } else {
                                    phi_8318_ = f32();
                                }
                                let _e10756 = phi_8318_;
                                continue;
                                continuing {
                                    phi_8314_ = _e10746;
                                    phi_8317_ = _e10756;
                                    break if !(_e10751);
                                }
                            }
                            let _e10761 = local_105;
                            phi_8371_ = (_e10761 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e10768 = phi_8371_;
                        let _e10774 = local_18.member[0u];
                        if (_e10774[0] < 0f) {
                            phi_8387_ = -(_e10774[0]);
                        } else {
                            phi_8387_ = _e10774[0];
                        }
                        let _e10781 = phi_8387_;
                        if (_e10774[1] < 0f) {
                            phi_8394_ = -(_e10774[1]);
                        } else {
                            phi_8394_ = _e10774[1];
                        }
                        let _e10785 = phi_8394_;
                        if (_e10781 > _e10785) {
                            phi_8399_ = _e10781;
                        } else {
                            phi_8399_ = _e10785;
                        }
                        let _e10788 = phi_8399_;
                        if (_e10774[2] < 0f) {
                            phi_8406_ = -(_e10774[2]);
                        } else {
                            phi_8406_ = _e10774[2];
                        }
                        let _e10792 = phi_8406_;
                        if (_e10788 > _e10792) {
                            phi_8411_ = _e10788;
                        } else {
                            phi_8411_ = _e10792;
                        }
                        let _e10795 = phi_8411_;
                        let _e10798 = local_18.member[1u];
                        if (_e10798[0] < 0f) {
                            phi_8424_ = -(_e10798[0]);
                        } else {
                            phi_8424_ = _e10798[0];
                        }
                        let _e10805 = phi_8424_;
                        if (_e10798[1] < 0f) {
                            phi_8431_ = -(_e10798[1]);
                        } else {
                            phi_8431_ = _e10798[1];
                        }
                        let _e10809 = phi_8431_;
                        if (_e10805 > _e10809) {
                            phi_8436_ = _e10805;
                        } else {
                            phi_8436_ = _e10809;
                        }
                        let _e10812 = phi_8436_;
                        if (_e10798[2] < 0f) {
                            phi_8443_ = -(_e10798[2]);
                        } else {
                            phi_8443_ = _e10798[2];
                        }
                        let _e10816 = phi_8443_;
                        if (_e10812 > _e10816) {
                            phi_8448_ = _e10812;
                        } else {
                            phi_8448_ = _e10816;
                        }
                        let _e10819 = phi_8448_;
                        if (_e10795 > _e10819) {
                            phi_8453_ = _e10795;
                        } else {
                            phi_8453_ = _e10819;
                        }
                        let _e10822 = phi_8453_;
                        let _e10824 = local_18.member_3;
                        let _e10828 = local_18.member_1[0u];
                        if (_e10828[0] < 0f) {
                            phi_8470_ = -(_e10828[0]);
                        } else {
                            phi_8470_ = _e10828[0];
                        }
                        let _e10835 = phi_8470_;
                        if (_e10828[1] < 0f) {
                            phi_8477_ = -(_e10828[1]);
                        } else {
                            phi_8477_ = _e10828[1];
                        }
                        let _e10839 = phi_8477_;
                        if (_e10835 > _e10839) {
                            phi_8482_ = _e10835;
                        } else {
                            phi_8482_ = _e10839;
                        }
                        let _e10842 = phi_8482_;
                        if (_e10828[2] < 0f) {
                            phi_8489_ = -(_e10828[2]);
                        } else {
                            phi_8489_ = _e10828[2];
                        }
                        let _e10846 = phi_8489_;
                        if (_e10842 > _e10846) {
                            phi_8494_ = _e10842;
                        } else {
                            phi_8494_ = _e10846;
                        }
                        let _e10849 = phi_8494_;
                        let _e10852 = local_18.member_1[1u];
                        if (_e10852[0] < 0f) {
                            phi_8508_ = -(_e10852[0]);
                        } else {
                            phi_8508_ = _e10852[0];
                        }
                        let _e10859 = phi_8508_;
                        if (_e10852[1] < 0f) {
                            phi_8515_ = -(_e10852[1]);
                        } else {
                            phi_8515_ = _e10852[1];
                        }
                        let _e10863 = phi_8515_;
                        if (_e10859 > _e10863) {
                            phi_8520_ = _e10859;
                        } else {
                            phi_8520_ = _e10863;
                        }
                        let _e10866 = phi_8520_;
                        if (_e10852[2] < 0f) {
                            phi_8527_ = -(_e10852[2]);
                        } else {
                            phi_8527_ = _e10852[2];
                        }
                        let _e10870 = phi_8527_;
                        if (_e10866 > _e10870) {
                            phi_8532_ = _e10866;
                        } else {
                            phi_8532_ = _e10870;
                        }
                        let _e10873 = phi_8532_;
                        if (_e10849 > _e10873) {
                            phi_8537_ = _e10849;
                        } else {
                            phi_8537_ = _e10873;
                        }
                        let _e10876 = phi_8537_;
                        let _e10878 = local_18.member_3;
                        let _e10882 = local_18.member_2[0u];
                        if (_e10882[0] < 0f) {
                            phi_8554_ = -(_e10882[0]);
                        } else {
                            phi_8554_ = _e10882[0];
                        }
                        let _e10889 = phi_8554_;
                        if (_e10882[1] < 0f) {
                            phi_8561_ = -(_e10882[1]);
                        } else {
                            phi_8561_ = _e10882[1];
                        }
                        let _e10893 = phi_8561_;
                        if (_e10889 > _e10893) {
                            phi_8566_ = _e10889;
                        } else {
                            phi_8566_ = _e10893;
                        }
                        let _e10896 = phi_8566_;
                        if (_e10882[2] < 0f) {
                            phi_8573_ = -(_e10882[2]);
                        } else {
                            phi_8573_ = _e10882[2];
                        }
                        let _e10900 = phi_8573_;
                        if (_e10896 > _e10900) {
                            phi_8578_ = _e10896;
                        } else {
                            phi_8578_ = _e10900;
                        }
                        let _e10903 = phi_8578_;
                        let _e10906 = local_18.member_2[1u];
                        if (_e10906[0] < 0f) {
                            phi_8592_ = -(_e10906[0]);
                        } else {
                            phi_8592_ = _e10906[0];
                        }
                        let _e10913 = phi_8592_;
                        if (_e10906[1] < 0f) {
                            phi_8599_ = -(_e10906[1]);
                        } else {
                            phi_8599_ = _e10906[1];
                        }
                        let _e10917 = phi_8599_;
                        if (_e10913 > _e10917) {
                            phi_8604_ = _e10913;
                        } else {
                            phi_8604_ = _e10917;
                        }
                        let _e10920 = phi_8604_;
                        if (_e10906[2] < 0f) {
                            phi_8611_ = -(_e10906[2]);
                        } else {
                            phi_8611_ = _e10906[2];
                        }
                        let _e10924 = phi_8611_;
                        if (_e10920 > _e10924) {
                            phi_8616_ = _e10920;
                        } else {
                            phi_8616_ = _e10924;
                        }
                        let _e10927 = phi_8616_;
                        if (_e10903 > _e10927) {
                            phi_8621_ = _e10903;
                        } else {
                            phi_8621_ = _e10927;
                        }
                        let _e10930 = phi_8621_;
                        let _e10932 = local_18.member_3;
                        let _e10939 = local_18.member_3;
                        let _e10946 = (((_e10768 * (1f + (0.000000059604645f * 8f))) + (((((((_e10822 + _e10824) + (_e10876 + _e10878)) + (_e10930 + _e10932)) * (0.000000059604645f * 16f)) + (_e10939 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e5873.member_1);
                        if _e10946 {
                            phi_9282_ = type_45();
                            phi_9283_ = true;
                        } else {
                            let _e10949 = local_18.member_1[0u];
                            let _e10955 = local_18.member_2[0u];
                            let _e10961 = ((_e10949[1] * _e10955[2]) - (_e10949[2] * _e10955[1]));
                            let _e10964 = ((_e10949[2] * _e10955[0]) - (_e10949[0] * _e10955[2]));
                            let _e10967 = ((_e10949[0] * _e10955[1]) - (_e10949[1] * _e10955[0]));
                            let _e10970 = local_18.member_1[1u];
                            let _e10976 = local_18.member_2[1u];
                            let _e10982 = ((_e10970[1] * _e10976[2]) - (_e10970[2] * _e10976[1]));
                            let _e10985 = ((_e10970[2] * _e10976[0]) - (_e10970[0] * _e10976[2]));
                            let _e10988 = ((_e10970[0] * _e10976[1]) - (_e10970[1] * _e10976[0]));
                            let _e10991 = local_18.member_1[0u];
                            let _e10997 = local_18.member_2[1u];
                            let _e11012 = local_18.member_1[1u];
                            let _e11018 = local_18.member_2[0u];
                            let _e11031 = (((_e10991[1] * _e10997[2]) - (_e10991[2] * _e10997[1])) + ((_e11012[1] * _e11018[2]) - (_e11012[2] * _e11018[1])));
                            let _e11032 = (((_e10991[2] * _e10997[0]) - (_e10991[0] * _e10997[2])) + ((_e11012[2] * _e11018[0]) - (_e11012[0] * _e11018[2])));
                            let _e11033 = (((_e10991[0] * _e10997[1]) - (_e10991[1] * _e10997[0])) + ((_e11012[0] * _e11018[1]) - (_e11012[1] * _e11018[0])));
                            let _e11036 = local_18.member[0u];
                            let _e11047 = local_18.member[1u];
                            let _e11058 = local_18.member[0u];
                            let _e11067 = ((((_e11047[0] * _e10961) + (_e11047[1] * _e10964)) + (_e11047[2] * _e10967)) + (((_e11058[0] * _e11031) + (_e11058[1] * _e11032)) + (_e11058[2] * _e11033)));
                            let _e11070 = local_18.member[0u];
                            let _e11081 = local_18.member[1u];
                            let _e11090 = ((((_e11070[0] * _e10982) + (_e11070[1] * _e10985)) + (_e11070[2] * _e10988)) + (((_e11081[0] * _e11031) + (_e11081[1] * _e11032)) + (_e11081[2] * _e11033)));
                            let _e11093 = local_18.member[1u];
                            let _e11104 = local_18.member[0u];
                            if (_e11104[0] < 0f) {
                                phi_8882_ = -(_e11104[0]);
                            } else {
                                phi_8882_ = _e11104[0];
                            }
                            let _e11111 = phi_8882_;
                            if (_e11104[1] < 0f) {
                                phi_8889_ = -(_e11104[1]);
                            } else {
                                phi_8889_ = _e11104[1];
                            }
                            let _e11115 = phi_8889_;
                            if (_e11111 > _e11115) {
                                phi_8894_ = _e11111;
                            } else {
                                phi_8894_ = _e11115;
                            }
                            let _e11118 = phi_8894_;
                            if (_e11104[2] < 0f) {
                                phi_8901_ = -(_e11104[2]);
                            } else {
                                phi_8901_ = _e11104[2];
                            }
                            let _e11122 = phi_8901_;
                            if (_e11118 > _e11122) {
                                phi_8906_ = _e11118;
                            } else {
                                phi_8906_ = _e11122;
                            }
                            let _e11125 = phi_8906_;
                            let _e11128 = local_18.member[1u];
                            if (_e11128[0] < 0f) {
                                phi_8919_ = -(_e11128[0]);
                            } else {
                                phi_8919_ = _e11128[0];
                            }
                            let _e11135 = phi_8919_;
                            if (_e11128[1] < 0f) {
                                phi_8926_ = -(_e11128[1]);
                            } else {
                                phi_8926_ = _e11128[1];
                            }
                            let _e11139 = phi_8926_;
                            if (_e11135 > _e11139) {
                                phi_8931_ = _e11135;
                            } else {
                                phi_8931_ = _e11139;
                            }
                            let _e11142 = phi_8931_;
                            if (_e11128[2] < 0f) {
                                phi_8938_ = -(_e11128[2]);
                            } else {
                                phi_8938_ = _e11128[2];
                            }
                            let _e11146 = phi_8938_;
                            if (_e11142 > _e11146) {
                                phi_8943_ = _e11142;
                            } else {
                                phi_8943_ = _e11146;
                            }
                            let _e11149 = phi_8943_;
                            if (_e11125 > _e11149) {
                                phi_8948_ = _e11125;
                            } else {
                                phi_8948_ = _e11149;
                            }
                            let _e11152 = phi_8948_;
                            let _e11154 = local_18.member_3;
                            let _e11155 = (_e11152 + _e11154);
                            let _e11158 = local_18.member_1[0u];
                            if (_e11158[0] < 0f) {
                                phi_8965_ = -(_e11158[0]);
                            } else {
                                phi_8965_ = _e11158[0];
                            }
                            let _e11165 = phi_8965_;
                            if (_e11158[1] < 0f) {
                                phi_8972_ = -(_e11158[1]);
                            } else {
                                phi_8972_ = _e11158[1];
                            }
                            let _e11169 = phi_8972_;
                            if (_e11165 > _e11169) {
                                phi_8977_ = _e11165;
                            } else {
                                phi_8977_ = _e11169;
                            }
                            let _e11172 = phi_8977_;
                            if (_e11158[2] < 0f) {
                                phi_8984_ = -(_e11158[2]);
                            } else {
                                phi_8984_ = _e11158[2];
                            }
                            let _e11176 = phi_8984_;
                            if (_e11172 > _e11176) {
                                phi_8989_ = _e11172;
                            } else {
                                phi_8989_ = _e11176;
                            }
                            let _e11179 = phi_8989_;
                            let _e11182 = local_18.member_1[1u];
                            if (_e11182[0] < 0f) {
                                phi_9003_ = -(_e11182[0]);
                            } else {
                                phi_9003_ = _e11182[0];
                            }
                            let _e11189 = phi_9003_;
                            if (_e11182[1] < 0f) {
                                phi_9010_ = -(_e11182[1]);
                            } else {
                                phi_9010_ = _e11182[1];
                            }
                            let _e11193 = phi_9010_;
                            if (_e11189 > _e11193) {
                                phi_9015_ = _e11189;
                            } else {
                                phi_9015_ = _e11193;
                            }
                            let _e11196 = phi_9015_;
                            if (_e11182[2] < 0f) {
                                phi_9022_ = -(_e11182[2]);
                            } else {
                                phi_9022_ = _e11182[2];
                            }
                            let _e11200 = phi_9022_;
                            if (_e11196 > _e11200) {
                                phi_9027_ = _e11196;
                            } else {
                                phi_9027_ = _e11200;
                            }
                            let _e11203 = phi_9027_;
                            if (_e11179 > _e11203) {
                                phi_9032_ = _e11179;
                            } else {
                                phi_9032_ = _e11203;
                            }
                            let _e11206 = phi_9032_;
                            let _e11208 = local_18.member_3;
                            let _e11209 = (_e11206 + _e11208);
                            let _e11212 = local_18.member_2[0u];
                            if (_e11212[0] < 0f) {
                                phi_9049_ = -(_e11212[0]);
                            } else {
                                phi_9049_ = _e11212[0];
                            }
                            let _e11219 = phi_9049_;
                            if (_e11212[1] < 0f) {
                                phi_9056_ = -(_e11212[1]);
                            } else {
                                phi_9056_ = _e11212[1];
                            }
                            let _e11223 = phi_9056_;
                            if (_e11219 > _e11223) {
                                phi_9061_ = _e11219;
                            } else {
                                phi_9061_ = _e11223;
                            }
                            let _e11226 = phi_9061_;
                            if (_e11212[2] < 0f) {
                                phi_9068_ = -(_e11212[2]);
                            } else {
                                phi_9068_ = _e11212[2];
                            }
                            let _e11230 = phi_9068_;
                            if (_e11226 > _e11230) {
                                phi_9073_ = _e11226;
                            } else {
                                phi_9073_ = _e11230;
                            }
                            let _e11233 = phi_9073_;
                            let _e11236 = local_18.member_2[1u];
                            if (_e11236[0] < 0f) {
                                phi_9087_ = -(_e11236[0]);
                            } else {
                                phi_9087_ = _e11236[0];
                            }
                            let _e11243 = phi_9087_;
                            if (_e11236[1] < 0f) {
                                phi_9094_ = -(_e11236[1]);
                            } else {
                                phi_9094_ = _e11236[1];
                            }
                            let _e11247 = phi_9094_;
                            if (_e11243 > _e11247) {
                                phi_9099_ = _e11243;
                            } else {
                                phi_9099_ = _e11247;
                            }
                            let _e11250 = phi_9099_;
                            if (_e11236[2] < 0f) {
                                phi_9106_ = -(_e11236[2]);
                            } else {
                                phi_9106_ = _e11236[2];
                            }
                            let _e11254 = phi_9106_;
                            if (_e11250 > _e11254) {
                                phi_9111_ = _e11250;
                            } else {
                                phi_9111_ = _e11254;
                            }
                            let _e11257 = phi_9111_;
                            if (_e11233 > _e11257) {
                                phi_9116_ = _e11233;
                            } else {
                                phi_9116_ = _e11257;
                            }
                            let _e11260 = phi_9116_;
                            let _e11262 = local_18.member_3;
                            let _e11263 = (_e11260 + _e11262);
                            let _e11265 = ((_e11209 * 8f) * _e11263);
                            let _e11272 = local_18.member_3;
                            if (_e10961 < 0f) {
                                phi_9147_ = -(_e10961);
                            } else {
                                phi_9147_ = _e10961;
                            }
                            let _e11289 = phi_9147_;
                            if (_e10964 < 0f) {
                                phi_9153_ = -(_e10964);
                            } else {
                                phi_9153_ = _e10964;
                            }
                            let _e11293 = phi_9153_;
                            if (_e10967 < 0f) {
                                phi_9160_ = -(_e10967);
                            } else {
                                phi_9160_ = _e10967;
                            }
                            let _e11298 = phi_9160_;
                            let _e11299 = ((_e11289 + _e11293) + _e11298);
                            if (_e10982 < 0f) {
                                phi_9167_ = -(_e10982);
                            } else {
                                phi_9167_ = _e10982;
                            }
                            let _e11303 = phi_9167_;
                            if (_e10985 < 0f) {
                                phi_9173_ = -(_e10985);
                            } else {
                                phi_9173_ = _e10985;
                            }
                            let _e11307 = phi_9173_;
                            if (_e10988 < 0f) {
                                phi_9180_ = -(_e10988);
                            } else {
                                phi_9180_ = _e10988;
                            }
                            let _e11312 = phi_9180_;
                            let _e11313 = ((_e11303 + _e11307) + _e11312);
                            if (_e11299 > _e11313) {
                                phi_9186_ = _e11299;
                            } else {
                                phi_9186_ = _e11313;
                            }
                            let _e11316 = phi_9186_;
                            if (_e11031 < 0f) {
                                phi_9192_ = -(_e11031);
                            } else {
                                phi_9192_ = _e11031;
                            }
                            let _e11320 = phi_9192_;
                            if (_e11032 < 0f) {
                                phi_9198_ = -(_e11032);
                            } else {
                                phi_9198_ = _e11032;
                            }
                            let _e11324 = phi_9198_;
                            if (_e11033 < 0f) {
                                phi_9205_ = -(_e11033);
                            } else {
                                phi_9205_ = _e11033;
                            }
                            let _e11329 = phi_9205_;
                            let _e11331 = (((_e11320 + _e11324) + _e11329) * 0.5f);
                            if (_e11316 > _e11331) {
                                phi_9212_ = _e11316;
                            } else {
                                phi_9212_ = _e11331;
                            }
                            let _e11334 = phi_9212_;
                            let _e11339 = local_18.member_3;
                            let _e11352 = ((((_e11036[0] * _e10961) + (_e11036[1] * _e10964)) + (_e11036[2] * _e10967)) * 3f);
                            let _e11353 = ((((_e11093[0] * _e10982) + (_e11093[1] * _e10985)) + (_e11093[2] * _e10988)) * 3f);
                            if (_e11352 < _e11353) {
                                phi_9236_ = _e11352;
                            } else {
                                phi_9236_ = _e11353;
                            }
                            let _e11356 = phi_9236_;
                            if (_e11067 < _e11090) {
                                phi_9241_ = _e11067;
                            } else {
                                phi_9241_ = _e11090;
                            }
                            let _e11359 = phi_9241_;
                            if (_e11356 < _e11359) {
                                phi_9246_ = _e11356;
                            } else {
                                phi_9246_ = _e11359;
                            }
                            let _e11362 = phi_9246_;
                            if (_e11352 > _e11353) {
                                phi_9251_ = _e11352;
                            } else {
                                phi_9251_ = _e11353;
                            }
                            let _e11365 = phi_9251_;
                            if (_e11067 > _e11090) {
                                phi_9256_ = _e11067;
                            } else {
                                phi_9256_ = _e11090;
                            }
                            let _e11368 = phi_9256_;
                            if (_e11365 > _e11368) {
                                phi_9261_ = _e11365;
                            } else {
                                phi_9261_ = _e11368;
                            }
                            let _e11371 = phi_9261_;
                            let _e11376 = -(_e11371);
                            if (_e11362 > _e11376) {
                                phi_9271_ = _e11362;
                            } else {
                                phi_9271_ = _e11376;
                            }
                            let _e11379 = phi_9271_;
                            if ((_e11379 - ((((((_e11155 * 8f) * _e11265) * (0.000000059604645f * (524f / 64f))) + ((_e11272 * 19f) * ((_e11155 * (_e11209 + _e11263)) + (_e11209 * _e11263)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e11155) * ((1f + _e11209) * (1f + _e11263))))) + ((_e5873.member_1 * (((_e11334 + (_e11265 * (0.000000059604645f * 8f))) + ((_e11339 * 6f) * (_e11209 + _e11263))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e11209) * (1f + _e11263))))) * (3f * 1.0001f)))) > 0f) {
                                phi_9280_ = type_45(type_44(0u, f32()), 0u);
                                phi_9281_ = false;
                            } else {
                                phi_9280_ = type_45();
                                phi_9281_ = true;
                            }
                            let _e11385 = phi_9280_;
                            let _e11387 = phi_9281_;
                            phi_9282_ = _e11385;
                            phi_9283_ = _e11387;
                        }
                        let _e11389 = phi_9282_;
                        let _e11391 = phi_9283_;
                        if _e11391 {
                            phi_9289_ = type_14(0i, 2i);
                            phi_9292_ = _e5605;
                            phi_9294_ = 0u;
                            phi_9296_ = _e5605;
                            loop {
                                let _e11393 = phi_9289_;
                                let _e11395 = phi_9292_;
                                let _e11397 = phi_9294_;
                                let _e11399 = phi_9296_;
                                local_167 = _e11397;
                                local_170 = _e11395;
                                local_171 = _e11397;
                                if (_e11393.member < _e11393.member_1) {
                                    let _e11406 = (_e11393.member + 1i);
                                    if ((false == (_e11406 > _e11393.member)) != false) {
                                        phi_9317_ = true;
                                    } else {
                                        phi_9317_ = false;
                                    }
                                    let _e11411 = phi_9317_;
                                    if _e11411 {
                                        phi_9323_ = type_15(0u, type_15().member_1);
                                    } else {
                                        phi_9323_ = type_15(1u, _e11406);
                                    }
                                    let _e11416 = phi_9323_;
                                    phi_9290_ = type_14(_e11416.member_1, _e11393.member_1);
                                    phi_9337_ = type_15(1u, _e11393.member);
                                } else {
                                    phi_9290_ = _e11393;
                                    phi_9337_ = type_15(0u, type_15().member_1);
                                }
                                let _e11422 = phi_9290_;
                                let _e11424 = phi_9337_;
                                if (bitcast<i32>(_e11424.member) != 0i) {
                                    if (_e11424.member_1 > 0i) {
                                        phi_9353_ = true;
                                    } else {
                                        if _e10946 {
                                            phi_9352_ = false;
                                        } else {
                                            phi_9352_ = true;
                                        }
                                        let _e11431 = phi_9352_;
                                        phi_9353_ = _e11431;
                                    }
                                    let _e11433 = phi_9353_;
                                    if _e11433 {
                                        let _e11436 = local_18.member[0u];
                                        let _e11443 = local_18.member_1[0u];
                                        let _e11449 = local_18.member_2[0u];
                                        let _e11453 = (_e11436[0] - _e11443[0]);
                                        let _e11454 = (_e11436[1] - _e11443[1]);
                                        let _e11455 = (_e11436[2] - _e11443[2]);
                                        if (_e316.member == 0u) {
                                            phi_9412_ = array<f32, 3>(_e11436[0], _e11436[1], _e11436[2]);
                                        } else {
                                            phi_9412_ = array<f32, 3>((_e11453 - _e11449[0]), (_e11454 - _e11449[1]), (_e11455 - _e11449[2]));
                                        }
                                        let _e11462 = phi_9412_;
                                        let _e11468 = local_18.member[1u];
                                        let _e11475 = local_18.member_1[1u];
                                        let _e11481 = local_18.member_2[1u];
                                        let _e11485 = (_e11468[0] - _e11475[0]);
                                        let _e11486 = (_e11468[1] - _e11475[1]);
                                        let _e11487 = (_e11468[2] - _e11475[2]);
                                        if (_e316.member == 0u) {
                                            phi_9477_ = array<f32, 3>(_e11468[0], _e11468[1], _e11468[2]);
                                        } else {
                                            phi_9477_ = array<f32, 3>((_e11485 - _e11481[0]), (_e11486 - _e11481[1]), (_e11487 - _e11481[2]));
                                        }
                                        let _e11494 = phi_9477_;
                                        let _e11500 = local_18.member[0u];
                                        if (_e11500[0] < 0f) {
                                            phi_9499_ = -(_e11500[0]);
                                        } else {
                                            phi_9499_ = _e11500[0];
                                        }
                                        let _e11507 = phi_9499_;
                                        if (_e11500[1] < 0f) {
                                            phi_9506_ = -(_e11500[1]);
                                        } else {
                                            phi_9506_ = _e11500[1];
                                        }
                                        let _e11511 = phi_9506_;
                                        if (_e11507 > _e11511) {
                                            phi_9511_ = _e11507;
                                        } else {
                                            phi_9511_ = _e11511;
                                        }
                                        let _e11514 = phi_9511_;
                                        if (_e11500[2] < 0f) {
                                            phi_9518_ = -(_e11500[2]);
                                        } else {
                                            phi_9518_ = _e11500[2];
                                        }
                                        let _e11518 = phi_9518_;
                                        if (_e11514 > _e11518) {
                                            phi_9523_ = _e11514;
                                        } else {
                                            phi_9523_ = _e11518;
                                        }
                                        let _e11521 = phi_9523_;
                                        let _e11524 = local_18.member[1u];
                                        if (_e11524[0] < 0f) {
                                            phi_9536_ = -(_e11524[0]);
                                        } else {
                                            phi_9536_ = _e11524[0];
                                        }
                                        let _e11531 = phi_9536_;
                                        if (_e11524[1] < 0f) {
                                            phi_9543_ = -(_e11524[1]);
                                        } else {
                                            phi_9543_ = _e11524[1];
                                        }
                                        let _e11535 = phi_9543_;
                                        if (_e11531 > _e11535) {
                                            phi_9548_ = _e11531;
                                        } else {
                                            phi_9548_ = _e11535;
                                        }
                                        let _e11538 = phi_9548_;
                                        if (_e11524[2] < 0f) {
                                            phi_9555_ = -(_e11524[2]);
                                        } else {
                                            phi_9555_ = _e11524[2];
                                        }
                                        let _e11542 = phi_9555_;
                                        if (_e11538 > _e11542) {
                                            phi_9560_ = _e11538;
                                        } else {
                                            phi_9560_ = _e11542;
                                        }
                                        let _e11545 = phi_9560_;
                                        if (_e11521 > _e11545) {
                                            phi_9565_ = _e11521;
                                        } else {
                                            phi_9565_ = _e11545;
                                        }
                                        let _e11548 = phi_9565_;
                                        let _e11550 = local_18.member_3;
                                        let _e11554 = local_18.member_1[0u];
                                        if (_e11554[0] < 0f) {
                                            phi_9582_ = -(_e11554[0]);
                                        } else {
                                            phi_9582_ = _e11554[0];
                                        }
                                        let _e11561 = phi_9582_;
                                        if (_e11554[1] < 0f) {
                                            phi_9589_ = -(_e11554[1]);
                                        } else {
                                            phi_9589_ = _e11554[1];
                                        }
                                        let _e11565 = phi_9589_;
                                        if (_e11561 > _e11565) {
                                            phi_9594_ = _e11561;
                                        } else {
                                            phi_9594_ = _e11565;
                                        }
                                        let _e11568 = phi_9594_;
                                        if (_e11554[2] < 0f) {
                                            phi_9601_ = -(_e11554[2]);
                                        } else {
                                            phi_9601_ = _e11554[2];
                                        }
                                        let _e11572 = phi_9601_;
                                        if (_e11568 > _e11572) {
                                            phi_9606_ = _e11568;
                                        } else {
                                            phi_9606_ = _e11572;
                                        }
                                        let _e11575 = phi_9606_;
                                        let _e11578 = local_18.member_1[1u];
                                        if (_e11578[0] < 0f) {
                                            phi_9620_ = -(_e11578[0]);
                                        } else {
                                            phi_9620_ = _e11578[0];
                                        }
                                        let _e11585 = phi_9620_;
                                        if (_e11578[1] < 0f) {
                                            phi_9627_ = -(_e11578[1]);
                                        } else {
                                            phi_9627_ = _e11578[1];
                                        }
                                        let _e11589 = phi_9627_;
                                        if (_e11585 > _e11589) {
                                            phi_9632_ = _e11585;
                                        } else {
                                            phi_9632_ = _e11589;
                                        }
                                        let _e11592 = phi_9632_;
                                        if (_e11578[2] < 0f) {
                                            phi_9639_ = -(_e11578[2]);
                                        } else {
                                            phi_9639_ = _e11578[2];
                                        }
                                        let _e11596 = phi_9639_;
                                        if (_e11592 > _e11596) {
                                            phi_9644_ = _e11592;
                                        } else {
                                            phi_9644_ = _e11596;
                                        }
                                        let _e11599 = phi_9644_;
                                        if (_e11575 > _e11599) {
                                            phi_9649_ = _e11575;
                                        } else {
                                            phi_9649_ = _e11599;
                                        }
                                        let _e11602 = phi_9649_;
                                        let _e11604 = local_18.member_3;
                                        let _e11608 = local_18.member_2[0u];
                                        if (_e11608[0] < 0f) {
                                            phi_9666_ = -(_e11608[0]);
                                        } else {
                                            phi_9666_ = _e11608[0];
                                        }
                                        let _e11615 = phi_9666_;
                                        if (_e11608[1] < 0f) {
                                            phi_9673_ = -(_e11608[1]);
                                        } else {
                                            phi_9673_ = _e11608[1];
                                        }
                                        let _e11619 = phi_9673_;
                                        if (_e11615 > _e11619) {
                                            phi_9678_ = _e11615;
                                        } else {
                                            phi_9678_ = _e11619;
                                        }
                                        let _e11622 = phi_9678_;
                                        if (_e11608[2] < 0f) {
                                            phi_9685_ = -(_e11608[2]);
                                        } else {
                                            phi_9685_ = _e11608[2];
                                        }
                                        let _e11626 = phi_9685_;
                                        if (_e11622 > _e11626) {
                                            phi_9690_ = _e11622;
                                        } else {
                                            phi_9690_ = _e11626;
                                        }
                                        let _e11629 = phi_9690_;
                                        let _e11632 = local_18.member_2[1u];
                                        if (_e11632[0] < 0f) {
                                            phi_9704_ = -(_e11632[0]);
                                        } else {
                                            phi_9704_ = _e11632[0];
                                        }
                                        let _e11639 = phi_9704_;
                                        if (_e11632[1] < 0f) {
                                            phi_9711_ = -(_e11632[1]);
                                        } else {
                                            phi_9711_ = _e11632[1];
                                        }
                                        let _e11643 = phi_9711_;
                                        if (_e11639 > _e11643) {
                                            phi_9716_ = _e11639;
                                        } else {
                                            phi_9716_ = _e11643;
                                        }
                                        let _e11646 = phi_9716_;
                                        if (_e11632[2] < 0f) {
                                            phi_9723_ = -(_e11632[2]);
                                        } else {
                                            phi_9723_ = _e11632[2];
                                        }
                                        let _e11650 = phi_9723_;
                                        if (_e11646 > _e11650) {
                                            phi_9728_ = _e11646;
                                        } else {
                                            phi_9728_ = _e11650;
                                        }
                                        let _e11653 = phi_9728_;
                                        if (_e11629 > _e11653) {
                                            phi_9733_ = _e11629;
                                        } else {
                                            phi_9733_ = _e11653;
                                        }
                                        let _e11656 = phi_9733_;
                                        let _e11658 = local_18.member_3;
                                        let _e11665 = local_18.member_3;
                                        let _e11670 = (_e5603 * 0.00390625f);
                                        local_16 = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        phi_9774_ = type_9(0u, 96u);
                                        phi_9777_ = _e11399;
                                        phi_9779_ = _e11399;
                                        phi_9781_ = (_e5607 - _e11399);
                                        phi_9783_ = _e11399;
                                        phi_9785_ = false;
                                        phi_9787_ = 0u;
                                        loop {
                                            let _e11673 = phi_9774_;
                                            let _e11675 = phi_9777_;
                                            let _e11677 = phi_9779_;
                                            let _e11679 = phi_9781_;
                                            let _e11681 = phi_9783_;
                                            let _e11683 = phi_9785_;
                                            let _e11685 = phi_9787_;
                                            local_109 = _e11675;
                                            local_157 = _e11677;
                                            if (_e11673.member < _e11673.member_1) {
                                                phi_9775_ = type_9((_e11673.member + 1u), _e11673.member_1);
                                                phi_9810_ = type_9(1u, _e11673.member);
                                            } else {
                                                phi_9775_ = _e11673;
                                                phi_9810_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e11697 = phi_9775_;
                                            let _e11699 = phi_9810_;
                                            if (bitcast<i32>(_e11699.member) != 0i) {
                                                let _e11705 = local_18.member[0u];
                                                let _e11711 = local_18.member[1u];
                                                let _e11727 = local_18.member_1[0u];
                                                let _e11733 = local_18.member_1[1u];
                                                let _e11749 = local_18.member_2[0u];
                                                let _e11755 = local_18.member_2[1u];
                                                let _e11769 = function_3(array<f32, 3>((_e11705[0] + ((_e11711[0] - _e11705[0]) * _e11675)), (_e11705[1] + ((_e11711[1] - _e11705[1]) * _e11675)), (_e11705[2] + ((_e11711[2] - _e11705[2]) * _e11675))), array<f32, 3>((_e11727[0] + ((_e11733[0] - _e11727[0]) * _e11675)), (_e11727[1] + ((_e11733[1] - _e11727[1]) * _e11675)), (_e11727[2] + ((_e11733[2] - _e11727[2]) * _e11675))), array<f32, 3>((_e11749[0] + ((_e11755[0] - _e11749[0]) * _e11675)), (_e11749[1] + ((_e11755[1] - _e11749[1]) * _e11675)), (_e11749[2] + ((_e11755[2] - _e11749[2]) * _e11675))), _e316.member);
                                                if (_e11685 == 0u) {
                                                    phi_9938_ = _e11769;
                                                } else {
                                                    if (_e11685 == 1u) {
                                                        phi_9924_ = _e11769[0];
                                                    } else {
                                                        phi_9924_ = 0f;
                                                    }
                                                    let _e11774 = phi_9924_;
                                                    if (_e11685 == 2u) {
                                                        phi_9930_ = _e11769[1];
                                                    } else {
                                                        phi_9930_ = 0f;
                                                    }
                                                    let _e11778 = phi_9930_;
                                                    if (_e11685 == 3u) {
                                                        phi_9936_ = _e11769[2];
                                                    } else {
                                                        phi_9936_ = 0f;
                                                    }
                                                    let _e11782 = phi_9936_;
                                                    phi_9938_ = array<f32, 3>(_e11774, _e11778, _e11782);
                                                }
                                                let _e11785 = phi_9938_;
                                                if (_e11785[0] < 0f) {
                                                    phi_9945_ = -(_e11785[0]);
                                                } else {
                                                    phi_9945_ = _e11785[0];
                                                }
                                                let _e11790 = phi_9945_;
                                                if (_e11785[1] < 0f) {
                                                    phi_9952_ = -(_e11785[1]);
                                                } else {
                                                    phi_9952_ = _e11785[1];
                                                }
                                                let _e11795 = phi_9952_;
                                                if (_e11785[2] < 0f) {
                                                    phi_9960_ = -(_e11785[2]);
                                                } else {
                                                    phi_9960_ = _e11785[2];
                                                }
                                                let _e11801 = phi_9960_;
                                                let _e11802 = ((_e11790 + _e11795) + _e11801);
                                                if (_e11802 > 0f) {
                                                    if ((bitcast<u32>(_e11802) & 2139095040u) != 2139095040u) {
                                                        let _e11807 = (1f / _e11802);
                                                        let _e11809 = (_e11785[0] * _e11807);
                                                        let _e11811 = (_e11785[1] * _e11807);
                                                        let _e11813 = (_e11785[2] * _e11807);
                                                        let _e11818 = (((_e11809 * _e11809) + (_e11811 * _e11811)) + (_e11813 * _e11813));
                                                        if (_e11818 <= 0.000000000000000000000000000000000000011754944f) {
                                                            if (_e11818 > 0f) {
                                                                phi_9997_ = (0.000000000000000000106433627f * 2f);
                                                            } else {
                                                                phi_9997_ = 0f;
                                                            }
                                                            let _e11871 = phi_9997_;
                                                            phi_10061_ = _e11871;
                                                        } else {
                                                            phi_10004_ = type_14(0i, 5i);
                                                            phi_10007_ = bitcast<f32>(((bitcast<u32>(_e11818) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e11826 = phi_10004_;
                                                                let _e11828 = phi_10007_;
                                                                local_106 = _e11828;
                                                                if (_e11826.member < _e11826.member_1) {
                                                                    let _e11835 = (_e11826.member + 1i);
                                                                    if ((false == (_e11835 > _e11826.member)) != false) {
                                                                        phi_10028_ = true;
                                                                    } else {
                                                                        phi_10028_ = false;
                                                                    }
                                                                    let _e11840 = phi_10028_;
                                                                    if _e11840 {
                                                                        phi_10034_ = type_15(0u, type_15().member_1);
                                                                    } else {
                                                                        phi_10034_ = type_15(1u, _e11835);
                                                                    }
                                                                    let _e11845 = phi_10034_;
                                                                    phi_10005_ = type_14(_e11845.member_1, _e11826.member_1);
                                                                    phi_10048_ = type_15(1u, _e11826.member);
                                                                } else {
                                                                    phi_10005_ = _e11826;
                                                                    phi_10048_ = type_15(0u, type_15().member_1);
                                                                }
                                                                let _e11851 = phi_10005_;
                                                                let _e11853 = phi_10048_;
                                                                let _e11856 = (bitcast<i32>(_e11853.member) != 0i);
                                                                if _e11856 {
                                                                    phi_10008_ = (0.5f * (_e11828 + (_e11818 / _e11828)));
                                                                } else {
                                                                    phi_10008_ = f32();
                                                                }
                                                                let _e11861 = phi_10008_;
                                                                continue;
                                                                continuing {
                                                                    phi_10004_ = _e11851;
                                                                    phi_10007_ = _e11861;
                                                                    break if !(_e11856);
                                                                }
                                                            }
                                                            let _e11866 = local_106;
                                                            phi_10061_ = (_e11866 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e11873 = phi_10061_;
                                                        let _e11874 = (0.000000059604645f * 12f);
                                                        let _e11879 = ((((((((_e11548 + _e11550) + (_e11602 + _e11604)) + (_e11656 + _e11658)) * (0.000000059604645f * 16f)) + (_e11665 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e5873.member_1 * _e11873) * (1f + _e11874)));
                                                        let _e11884 = (((_e11809 * _e11436[0]) + (_e11811 * _e11436[1])) + (_e11813 * _e11436[2]));
                                                        let _e11889 = (((_e11809 * _e11453) + (_e11811 * _e11454)) + (_e11813 * _e11455));
                                                        let _e11894 = (((_e11809 * (_e11436[0] - _e11449[0])) + (_e11811 * (_e11436[1] - _e11449[1]))) + (_e11813 * (_e11436[2] - _e11449[2])));
                                                        let _e11902 = (((_e11809 * _e11462[0]) + (_e11811 * _e11462[1])) + (_e11813 * _e11462[2]));
                                                        let _e11908 = (((_e11809 * _e11468[0]) + (_e11811 * _e11468[1])) + (_e11813 * _e11468[2]));
                                                        let _e11913 = (((_e11809 * _e11485) + (_e11811 * _e11486)) + (_e11813 * _e11487));
                                                        let _e11918 = (((_e11809 * (_e11468[0] - _e11481[0])) + (_e11811 * (_e11468[1] - _e11481[1]))) + (_e11813 * (_e11468[2] - _e11481[2])));
                                                        let _e11926 = (((_e11809 * _e11494[0]) + (_e11811 * _e11494[1])) + (_e11813 * _e11494[2]));
                                                        if (_e11884 < 0f) {
                                                            phi_10127_ = -(_e11884);
                                                        } else {
                                                            phi_10127_ = _e11884;
                                                        }
                                                        let _e11931 = phi_10127_;
                                                        if (_e11908 < 0f) {
                                                            phi_10133_ = -(_e11908);
                                                        } else {
                                                            phi_10133_ = _e11908;
                                                        }
                                                        let _e11935 = phi_10133_;
                                                        if (_e11889 < 0f) {
                                                            phi_10142_ = -(_e11889);
                                                        } else {
                                                            phi_10142_ = _e11889;
                                                        }
                                                        let _e11942 = phi_10142_;
                                                        if (_e11913 < 0f) {
                                                            phi_10148_ = -(_e11913);
                                                        } else {
                                                            phi_10148_ = _e11913;
                                                        }
                                                        let _e11946 = phi_10148_;
                                                        if (_e11894 < 0f) {
                                                            phi_10157_ = -(_e11894);
                                                        } else {
                                                            phi_10157_ = _e11894;
                                                        }
                                                        let _e11953 = phi_10157_;
                                                        if (_e11918 < 0f) {
                                                            phi_10163_ = -(_e11918);
                                                        } else {
                                                            phi_10163_ = _e11918;
                                                        }
                                                        let _e11957 = phi_10163_;
                                                        if (_e11902 < 0f) {
                                                            phi_10172_ = -(_e11902);
                                                        } else {
                                                            phi_10172_ = _e11902;
                                                        }
                                                        let _e11964 = phi_10172_;
                                                        if (_e11926 < 0f) {
                                                            phi_10178_ = -(_e11926);
                                                        } else {
                                                            phi_10178_ = _e11926;
                                                        }
                                                        let _e11968 = phi_10178_;
                                                        phi_10184_ = type_29(array<f32, 4>(_e11884, _e11889, _e11894, _e11902), array<f32, 4>(_e11908, _e11913, _e11918, _e11926), array<f32, 4>((_e11879 + ((_e11931 + _e11935) * _e11874)), (_e11879 + ((_e11942 + _e11946) * _e11874)), (_e11879 + ((_e11953 + _e11957) * _e11874)), (_e11879 + ((_e11964 + _e11968) * _e11874))));
                                                        phi_10185_ = false;
                                                    } else {
                                                        phi_10184_ = type_29();
                                                        phi_10185_ = true;
                                                    }
                                                    let _e11975 = phi_10184_;
                                                    let _e11977 = phi_10185_;
                                                    phi_10186_ = _e11975;
                                                    phi_10187_ = _e11977;
                                                } else {
                                                    phi_10186_ = type_29();
                                                    phi_10187_ = true;
                                                }
                                                let _e11979 = phi_10186_;
                                                let _e11981 = phi_10187_;
                                                if _e11981 {
                                                    phi_10195_ = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                } else {
                                                    phi_10195_ = _e11979;
                                                }
                                                let _e11983 = phi_10195_;
                                                local_17 = type_29(array<f32, 4>(_e11983.member[0], _e11983.member[1], _e11983.member[2], _e11983.member[3]), array<f32, 4>(_e11983.member_1[0], _e11983.member_1[1], _e11983.member_1[2], _e11983.member_1[3]), array<f32, 4>(_e11983.member_2[0], _e11983.member_2[1], _e11983.member_2[2], _e11983.member_2[3]));
                                                let _e12003 = (_e11675 - _e11681);
                                                let _e12007 = local_17.member[0u];
                                                let _e12010 = local_17.member_1[0u];
                                                let _e12013 = local_17.member[0u];
                                                let _e12019 = local_17.member_2[0u];
                                                if (((_e12007 + ((_e12010 - _e12013) * _e11675)) - _e12019) > 0f) {
                                                    let _e12024 = local_17.member[1u];
                                                    let _e12027 = local_17.member_1[1u];
                                                    let _e12030 = local_17.member[1u];
                                                    let _e12036 = local_17.member_2[1u];
                                                    if (((_e12024 + ((_e12027 - _e12030) * _e11675)) - _e12036) > 0f) {
                                                        let _e12041 = local_17.member[2u];
                                                        let _e12044 = local_17.member_1[2u];
                                                        let _e12047 = local_17.member[2u];
                                                        let _e12053 = local_17.member_2[2u];
                                                        if (((_e12041 + ((_e12044 - _e12047) * _e11675)) - _e12053) > 0f) {
                                                            let _e12058 = local_17.member[3u];
                                                            let _e12061 = local_17.member_1[3u];
                                                            let _e12064 = local_17.member[3u];
                                                            let _e12070 = local_17.member_2[3u];
                                                            phi_10366_ = (((_e12058 + ((_e12061 - _e12064) * _e11675)) - _e12070) > 0f);
                                                            phi_10367_ = false;
                                                        } else {
                                                            phi_10366_ = bool();
                                                            phi_10367_ = true;
                                                        }
                                                        let _e12074 = phi_10366_;
                                                        let _e12076 = phi_10367_;
                                                        phi_10368_ = _e12074;
                                                        phi_10369_ = _e12076;
                                                    } else {
                                                        phi_10368_ = bool();
                                                        phi_10369_ = true;
                                                    }
                                                    let _e12078 = phi_10368_;
                                                    let _e12080 = phi_10369_;
                                                    phi_10370_ = _e12078;
                                                    phi_10371_ = _e12080;
                                                } else {
                                                    phi_10370_ = bool();
                                                    phi_10371_ = true;
                                                }
                                                let _e12082 = phi_10370_;
                                                let _e12084 = phi_10371_;
                                                if _e12084 {
                                                    phi_10375_ = false;
                                                } else {
                                                    phi_10375_ = _e12082;
                                                }
                                                let _e12086 = phi_10375_;
                                                if _e12086 {
                                                    if (_e11675 <= _e11677) {
                                                        phi_10685_ = true;
                                                    } else {
                                                        let _e12090 = local_16.member[0u];
                                                        let _e12093 = local_16.member_1[0u];
                                                        let _e12096 = local_16.member[0u];
                                                        let _e12102 = local_16.member_2[0u];
                                                        let _e12106 = local_17.member[0u];
                                                        let _e12109 = local_17.member_1[0u];
                                                        let _e12112 = local_17.member[0u];
                                                        let _e12118 = local_17.member_2[0u];
                                                        if ((((_e12090 + ((_e12093 - _e12096) * _e11675)) - _e12102) + ((_e12106 + ((_e12109 - _e12112) * _e11681)) - _e12118)) > 0f) {
                                                            let _e12124 = local_16.member[1u];
                                                            let _e12127 = local_16.member_1[1u];
                                                            let _e12130 = local_16.member[1u];
                                                            let _e12136 = local_16.member_2[1u];
                                                            let _e12140 = local_17.member[1u];
                                                            let _e12143 = local_17.member_1[1u];
                                                            let _e12146 = local_17.member[1u];
                                                            let _e12152 = local_17.member_2[1u];
                                                            if ((((_e12124 + ((_e12127 - _e12130) * _e11675)) - _e12136) + ((_e12140 + ((_e12143 - _e12146) * _e11681)) - _e12152)) > 0f) {
                                                                let _e12158 = local_16.member[2u];
                                                                let _e12161 = local_16.member_1[2u];
                                                                let _e12164 = local_16.member[2u];
                                                                let _e12170 = local_16.member_2[2u];
                                                                let _e12174 = local_17.member[2u];
                                                                let _e12177 = local_17.member_1[2u];
                                                                let _e12180 = local_17.member[2u];
                                                                let _e12186 = local_17.member_2[2u];
                                                                if ((((_e12158 + ((_e12161 - _e12164) * _e11675)) - _e12170) + ((_e12174 + ((_e12177 - _e12180) * _e11681)) - _e12186)) > 0f) {
                                                                    let _e12192 = local_16.member[3u];
                                                                    let _e12195 = local_16.member_1[3u];
                                                                    let _e12198 = local_16.member[3u];
                                                                    let _e12204 = local_16.member_2[3u];
                                                                    let _e12208 = local_17.member[3u];
                                                                    let _e12211 = local_17.member_1[3u];
                                                                    let _e12214 = local_17.member[3u];
                                                                    let _e12220 = local_17.member_2[3u];
                                                                    phi_10672_ = ((((_e12192 + ((_e12195 - _e12198) * _e11675)) - _e12204) + ((_e12208 + ((_e12211 - _e12214) * _e11681)) - _e12220)) > 0f);
                                                                    phi_10673_ = false;
                                                                } else {
                                                                    phi_10672_ = bool();
                                                                    phi_10673_ = true;
                                                                }
                                                                let _e12225 = phi_10672_;
                                                                let _e12227 = phi_10673_;
                                                                phi_10674_ = _e12225;
                                                                phi_10675_ = _e12227;
                                                            } else {
                                                                phi_10674_ = bool();
                                                                phi_10675_ = true;
                                                            }
                                                            let _e12229 = phi_10674_;
                                                            let _e12231 = phi_10675_;
                                                            phi_10676_ = _e12229;
                                                            phi_10677_ = _e12231;
                                                        } else {
                                                            phi_10676_ = bool();
                                                            phi_10677_ = true;
                                                        }
                                                        let _e12233 = phi_10676_;
                                                        let _e12235 = phi_10677_;
                                                        if _e12235 {
                                                            phi_10681_ = false;
                                                        } else {
                                                            phi_10681_ = _e12233;
                                                        }
                                                        let _e12237 = phi_10681_;
                                                        phi_10685_ = _e12237;
                                                    }
                                                    let _e12239 = phi_10685_;
                                                    if _e12239 {
                                                        if _e11683 {
                                                            if (_e11675 >= _e5607) {
                                                                phi_10696_ = false;
                                                            } else {
                                                                phi_10696_ = true;
                                                            }
                                                            let _e12242 = phi_10696_;
                                                            phi_10697_ = _e12242;
                                                        } else {
                                                            phi_10697_ = true;
                                                        }
                                                        let _e12244 = phi_10697_;
                                                        if _e12244 {
                                                            local_16 = type_29(array<f32, 4>(_e11983.member[0], _e11983.member[1], _e11983.member[2], _e11983.member[3]), array<f32, 4>(_e11983.member_1[0], _e11983.member_1[1], _e11983.member_1[2], _e11983.member_1[3]), array<f32, 4>(_e11983.member_2[0], _e11983.member_2[1], _e11983.member_2[2], _e11983.member_2[3]));
                                                            let _e12266 = local_16.member[0u];
                                                            let _e12269 = local_16.member_1[0u];
                                                            let _e12272 = local_16.member_2[0u];
                                                            if (_e12266 > _e12272) {
                                                                if (_e12269 > _e12272) {
                                                                    phi_10771_ = false;
                                                                } else {
                                                                    phi_10771_ = true;
                                                                }
                                                                let _e12276 = phi_10771_;
                                                                phi_10772_ = _e12276;
                                                            } else {
                                                                phi_10772_ = true;
                                                            }
                                                            let _e12278 = phi_10772_;
                                                            if _e12278 {
                                                                let _e12279 = (_e12269 >= _e12266);
                                                                if _e12279 {
                                                                    phi_10794_ = f32();
                                                                    phi_10795_ = false;
                                                                } else {
                                                                    if ((_e12266 - _e12269) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                        phi_10792_ = (((_e12266 - _e12272) / (_e12266 - _e12269)) * (1f - (0.000000059604645f * 16f)));
                                                                        phi_10793_ = false;
                                                                    } else {
                                                                        phi_10792_ = f32();
                                                                        phi_10793_ = true;
                                                                    }
                                                                    let _e12290 = phi_10792_;
                                                                    let _e12292 = phi_10793_;
                                                                    phi_10794_ = _e12290;
                                                                    phi_10795_ = _e12292;
                                                                }
                                                                let _e12294 = phi_10794_;
                                                                let _e12296 = phi_10795_;
                                                                phi_10796_ = _e12294;
                                                                phi_10797_ = _e12279;
                                                                phi_10798_ = _e12296;
                                                            } else {
                                                                phi_10796_ = f32();
                                                                phi_10797_ = true;
                                                                phi_10798_ = false;
                                                            }
                                                            let _e12298 = phi_10796_;
                                                            let _e12300 = phi_10797_;
                                                            let _e12302 = phi_10798_;
                                                            if _e12300 {
                                                                phi_10802_ = 2f;
                                                                phi_10803_ = true;
                                                            } else {
                                                                phi_10802_ = _e11675;
                                                                phi_10803_ = _e12302;
                                                            }
                                                            let _e12304 = phi_10802_;
                                                            let _e12306 = phi_10803_;
                                                            if _e12306 {
                                                                phi_10807_ = _e12304;
                                                            } else {
                                                                phi_10807_ = _e12298;
                                                            }
                                                            let _e12308 = phi_10807_;
                                                            let _e12311 = local_16.member[1u];
                                                            let _e12314 = local_16.member_1[1u];
                                                            let _e12317 = local_16.member_2[1u];
                                                            if (_e12311 > _e12317) {
                                                                if (_e12314 > _e12317) {
                                                                    phi_10839_ = false;
                                                                } else {
                                                                    phi_10839_ = true;
                                                                }
                                                                let _e12321 = phi_10839_;
                                                                phi_10840_ = _e12321;
                                                            } else {
                                                                phi_10840_ = true;
                                                            }
                                                            let _e12323 = phi_10840_;
                                                            if _e12323 {
                                                                let _e12324 = (_e12314 >= _e12311);
                                                                if _e12324 {
                                                                    phi_10862_ = f32();
                                                                    phi_10863_ = false;
                                                                } else {
                                                                    if ((_e12311 - _e12314) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                        phi_10860_ = (((_e12311 - _e12317) / (_e12311 - _e12314)) * (1f - (0.000000059604645f * 16f)));
                                                                        phi_10861_ = false;
                                                                    } else {
                                                                        phi_10860_ = f32();
                                                                        phi_10861_ = true;
                                                                    }
                                                                    let _e12335 = phi_10860_;
                                                                    let _e12337 = phi_10861_;
                                                                    phi_10862_ = _e12335;
                                                                    phi_10863_ = _e12337;
                                                                }
                                                                let _e12339 = phi_10862_;
                                                                let _e12341 = phi_10863_;
                                                                phi_10864_ = _e12339;
                                                                phi_10865_ = _e12324;
                                                                phi_10866_ = _e12341;
                                                            } else {
                                                                phi_10864_ = f32();
                                                                phi_10865_ = true;
                                                                phi_10866_ = false;
                                                            }
                                                            let _e12343 = phi_10864_;
                                                            let _e12345 = phi_10865_;
                                                            let _e12347 = phi_10866_;
                                                            if _e12345 {
                                                                phi_10870_ = 2f;
                                                                phi_10871_ = true;
                                                            } else {
                                                                phi_10870_ = _e11675;
                                                                phi_10871_ = _e12347;
                                                            }
                                                            let _e12349 = phi_10870_;
                                                            let _e12351 = phi_10871_;
                                                            if _e12351 {
                                                                phi_10875_ = _e12349;
                                                            } else {
                                                                phi_10875_ = _e12343;
                                                            }
                                                            let _e12353 = phi_10875_;
                                                            if (_e12308 < _e12353) {
                                                                phi_10880_ = _e12308;
                                                            } else {
                                                                phi_10880_ = _e12353;
                                                            }
                                                            let _e12356 = phi_10880_;
                                                            let _e12359 = local_16.member[2u];
                                                            let _e12362 = local_16.member_1[2u];
                                                            let _e12365 = local_16.member_2[2u];
                                                            if (_e12359 > _e12365) {
                                                                if (_e12362 > _e12365) {
                                                                    phi_10912_ = false;
                                                                } else {
                                                                    phi_10912_ = true;
                                                                }
                                                                let _e12369 = phi_10912_;
                                                                phi_10913_ = _e12369;
                                                            } else {
                                                                phi_10913_ = true;
                                                            }
                                                            let _e12371 = phi_10913_;
                                                            if _e12371 {
                                                                let _e12372 = (_e12362 >= _e12359);
                                                                if _e12372 {
                                                                    phi_10935_ = f32();
                                                                    phi_10936_ = false;
                                                                } else {
                                                                    if ((_e12359 - _e12362) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                        phi_10933_ = (((_e12359 - _e12365) / (_e12359 - _e12362)) * (1f - (0.000000059604645f * 16f)));
                                                                        phi_10934_ = false;
                                                                    } else {
                                                                        phi_10933_ = f32();
                                                                        phi_10934_ = true;
                                                                    }
                                                                    let _e12383 = phi_10933_;
                                                                    let _e12385 = phi_10934_;
                                                                    phi_10935_ = _e12383;
                                                                    phi_10936_ = _e12385;
                                                                }
                                                                let _e12387 = phi_10935_;
                                                                let _e12389 = phi_10936_;
                                                                phi_10937_ = _e12387;
                                                                phi_10938_ = _e12372;
                                                                phi_10939_ = _e12389;
                                                            } else {
                                                                phi_10937_ = f32();
                                                                phi_10938_ = true;
                                                                phi_10939_ = false;
                                                            }
                                                            let _e12391 = phi_10937_;
                                                            let _e12393 = phi_10938_;
                                                            let _e12395 = phi_10939_;
                                                            if _e12393 {
                                                                phi_10943_ = 2f;
                                                                phi_10944_ = true;
                                                            } else {
                                                                phi_10943_ = _e11675;
                                                                phi_10944_ = _e12395;
                                                            }
                                                            let _e12397 = phi_10943_;
                                                            let _e12399 = phi_10944_;
                                                            if _e12399 {
                                                                phi_10948_ = _e12397;
                                                            } else {
                                                                phi_10948_ = _e12391;
                                                            }
                                                            let _e12401 = phi_10948_;
                                                            let _e12404 = local_16.member[3u];
                                                            let _e12407 = local_16.member_1[3u];
                                                            let _e12410 = local_16.member_2[3u];
                                                            if (_e12404 > _e12410) {
                                                                if (_e12407 > _e12410) {
                                                                    phi_10980_ = false;
                                                                } else {
                                                                    phi_10980_ = true;
                                                                }
                                                                let _e12414 = phi_10980_;
                                                                phi_10981_ = _e12414;
                                                            } else {
                                                                phi_10981_ = true;
                                                            }
                                                            let _e12416 = phi_10981_;
                                                            if _e12416 {
                                                                let _e12417 = (_e12407 >= _e12404);
                                                                if _e12417 {
                                                                    phi_11003_ = f32();
                                                                    phi_11004_ = false;
                                                                } else {
                                                                    if ((_e12404 - _e12407) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                        phi_11001_ = (((_e12404 - _e12410) / (_e12404 - _e12407)) * (1f - (0.000000059604645f * 16f)));
                                                                        phi_11002_ = false;
                                                                    } else {
                                                                        phi_11001_ = f32();
                                                                        phi_11002_ = true;
                                                                    }
                                                                    let _e12428 = phi_11001_;
                                                                    let _e12430 = phi_11002_;
                                                                    phi_11003_ = _e12428;
                                                                    phi_11004_ = _e12430;
                                                                }
                                                                let _e12432 = phi_11003_;
                                                                let _e12434 = phi_11004_;
                                                                phi_11005_ = _e12432;
                                                                phi_11006_ = _e12417;
                                                                phi_11007_ = _e12434;
                                                            } else {
                                                                phi_11005_ = f32();
                                                                phi_11006_ = true;
                                                                phi_11007_ = false;
                                                            }
                                                            let _e12436 = phi_11005_;
                                                            let _e12438 = phi_11006_;
                                                            let _e12440 = phi_11007_;
                                                            if _e12438 {
                                                                phi_11011_ = 2f;
                                                                phi_11012_ = true;
                                                            } else {
                                                                phi_11011_ = _e11675;
                                                                phi_11012_ = _e12440;
                                                            }
                                                            let _e12442 = phi_11011_;
                                                            let _e12444 = phi_11012_;
                                                            if _e12444 {
                                                                phi_11016_ = _e12442;
                                                            } else {
                                                                phi_11016_ = _e12436;
                                                            }
                                                            let _e12446 = phi_11016_;
                                                            if (_e12401 < _e12446) {
                                                                phi_11021_ = _e12401;
                                                            } else {
                                                                phi_11021_ = _e12446;
                                                            }
                                                            let _e12449 = phi_11021_;
                                                            if (_e12356 < _e12449) {
                                                                phi_11026_ = _e12356;
                                                            } else {
                                                                phi_11026_ = _e12449;
                                                            }
                                                            let _e12452 = phi_11026_;
                                                            if (_e12452 > _e11675) {
                                                                phi_11031_ = _e12452;
                                                            } else {
                                                                phi_11031_ = _e11675;
                                                            }
                                                            let _e12455 = phi_11031_;
                                                            let _e12456 = (_e12455 > _e5607);
                                                            if _e12456 {
                                                                phi_11536_ = f32();
                                                                phi_11537_ = f32();
                                                                phi_11538_ = false;
                                                                phi_11539_ = false;
                                                            } else {
                                                                let _e12457 = (_e12455 - _e11675);
                                                                let _e12458 = (_e12457 <= _e11670);
                                                                let _e12460 = (_e12455 + (_e5603 * 0.01f));
                                                                if (_e12460 < _e5607) {
                                                                    phi_11044_ = _e12460;
                                                                } else {
                                                                    phi_11044_ = _e5607;
                                                                }
                                                                let _e12463 = phi_11044_;
                                                                if _e12458 {
                                                                    if (_e5873.member_1 > 0f) {
                                                                        let _e12467 = local_18.member[0u];
                                                                        let _e12473 = local_18.member[1u];
                                                                        let _e12489 = local_18.member_1[0u];
                                                                        let _e12495 = local_18.member_1[1u];
                                                                        let _e12511 = local_18.member_2[0u];
                                                                        let _e12517 = local_18.member_2[1u];
                                                                        let _e12531 = function_3(array<f32, 3>((_e12467[0] + ((_e12473[0] - _e12467[0]) * _e12463)), (_e12467[1] + ((_e12473[1] - _e12467[1]) * _e12463)), (_e12467[2] + ((_e12473[2] - _e12467[2]) * _e12463))), array<f32, 3>((_e12489[0] + ((_e12495[0] - _e12489[0]) * _e12463)), (_e12489[1] + ((_e12495[1] - _e12489[1]) * _e12463)), (_e12489[2] + ((_e12495[2] - _e12489[2]) * _e12463))), array<f32, 3>((_e12511[0] + ((_e12517[0] - _e12511[0]) * _e12463)), (_e12511[1] + ((_e12517[1] - _e12511[1]) * _e12463)), (_e12511[2] + ((_e12517[2] - _e12511[2]) * _e12463))), _e316.member);
                                                                        let _e12542 = (((_e12531[0] * _e12531[0]) + (_e12531[1] * _e12531[1])) + (_e12531[2] * _e12531[2]));
                                                                        if (_e12542 <= 0.000000000000000000000000000000000000011754944f) {
                                                                            if (_e12542 > 0f) {
                                                                                phi_11174_ = (0.000000000000000000106433627f * 2f);
                                                                            } else {
                                                                                phi_11174_ = 0f;
                                                                            }
                                                                            let _e12595 = phi_11174_;
                                                                            phi_11238_ = _e12595;
                                                                        } else {
                                                                            phi_11181_ = type_14(0i, 5i);
                                                                            phi_11184_ = bitcast<f32>(((bitcast<u32>(_e12542) >> bitcast<u32>(1i)) + 532369198u));
                                                                            loop {
                                                                                let _e12550 = phi_11181_;
                                                                                let _e12552 = phi_11184_;
                                                                                local_107 = _e12552;
                                                                                if (_e12550.member < _e12550.member_1) {
                                                                                    let _e12559 = (_e12550.member + 1i);
                                                                                    if ((false == (_e12559 > _e12550.member)) != false) {
                                                                                        phi_11205_ = true;
                                                                                    } else {
                                                                                        phi_11205_ = false;
                                                                                    }
                                                                                    let _e12564 = phi_11205_;
                                                                                    if _e12564 {
                                                                                        phi_11211_ = type_15(0u, type_15().member_1);
                                                                                    } else {
                                                                                        phi_11211_ = type_15(1u, _e12559);
                                                                                    }
                                                                                    let _e12569 = phi_11211_;
                                                                                    phi_11182_ = type_14(_e12569.member_1, _e12550.member_1);
                                                                                    phi_11225_ = type_15(1u, _e12550.member);
                                                                                } else {
                                                                                    phi_11182_ = _e12550;
                                                                                    phi_11225_ = type_15(0u, type_15().member_1);
                                                                                }
                                                                                let _e12575 = phi_11182_;
                                                                                let _e12577 = phi_11225_;
                                                                                let _e12580 = (bitcast<i32>(_e12577.member) != 0i);
                                                                                if _e12580 {
                                                                                    phi_11185_ = (0.5f * (_e12552 + (_e12542 / _e12552)));
                                                                                } else {
                                                                                    phi_11185_ = f32();
                                                                                }
                                                                                let _e12585 = phi_11185_;
                                                                                continue;
                                                                                continuing {
                                                                                    phi_11181_ = _e12575;
                                                                                    phi_11184_ = _e12585;
                                                                                    break if !(_e12580);
                                                                                }
                                                                            }
                                                                            let _e12590 = local_107;
                                                                            phi_11238_ = (_e12590 * (1f + (8f * 0.000000059604645f)));
                                                                        }
                                                                        let _e12597 = phi_11238_;
                                                                        let _e12603 = local_18.member[0u];
                                                                        if (_e12603[0] < 0f) {
                                                                            phi_11254_ = -(_e12603[0]);
                                                                        } else {
                                                                            phi_11254_ = _e12603[0];
                                                                        }
                                                                        let _e12610 = phi_11254_;
                                                                        if (_e12603[1] < 0f) {
                                                                            phi_11261_ = -(_e12603[1]);
                                                                        } else {
                                                                            phi_11261_ = _e12603[1];
                                                                        }
                                                                        let _e12614 = phi_11261_;
                                                                        if (_e12610 > _e12614) {
                                                                            phi_11266_ = _e12610;
                                                                        } else {
                                                                            phi_11266_ = _e12614;
                                                                        }
                                                                        let _e12617 = phi_11266_;
                                                                        if (_e12603[2] < 0f) {
                                                                            phi_11273_ = -(_e12603[2]);
                                                                        } else {
                                                                            phi_11273_ = _e12603[2];
                                                                        }
                                                                        let _e12621 = phi_11273_;
                                                                        if (_e12617 > _e12621) {
                                                                            phi_11278_ = _e12617;
                                                                        } else {
                                                                            phi_11278_ = _e12621;
                                                                        }
                                                                        let _e12624 = phi_11278_;
                                                                        let _e12627 = local_18.member[1u];
                                                                        if (_e12627[0] < 0f) {
                                                                            phi_11291_ = -(_e12627[0]);
                                                                        } else {
                                                                            phi_11291_ = _e12627[0];
                                                                        }
                                                                        let _e12634 = phi_11291_;
                                                                        if (_e12627[1] < 0f) {
                                                                            phi_11298_ = -(_e12627[1]);
                                                                        } else {
                                                                            phi_11298_ = _e12627[1];
                                                                        }
                                                                        let _e12638 = phi_11298_;
                                                                        if (_e12634 > _e12638) {
                                                                            phi_11303_ = _e12634;
                                                                        } else {
                                                                            phi_11303_ = _e12638;
                                                                        }
                                                                        let _e12641 = phi_11303_;
                                                                        if (_e12627[2] < 0f) {
                                                                            phi_11310_ = -(_e12627[2]);
                                                                        } else {
                                                                            phi_11310_ = _e12627[2];
                                                                        }
                                                                        let _e12645 = phi_11310_;
                                                                        if (_e12641 > _e12645) {
                                                                            phi_11315_ = _e12641;
                                                                        } else {
                                                                            phi_11315_ = _e12645;
                                                                        }
                                                                        let _e12648 = phi_11315_;
                                                                        if (_e12624 > _e12648) {
                                                                            phi_11320_ = _e12624;
                                                                        } else {
                                                                            phi_11320_ = _e12648;
                                                                        }
                                                                        let _e12651 = phi_11320_;
                                                                        let _e12653 = local_18.member_3;
                                                                        let _e12657 = local_18.member_1[0u];
                                                                        if (_e12657[0] < 0f) {
                                                                            phi_11337_ = -(_e12657[0]);
                                                                        } else {
                                                                            phi_11337_ = _e12657[0];
                                                                        }
                                                                        let _e12664 = phi_11337_;
                                                                        if (_e12657[1] < 0f) {
                                                                            phi_11344_ = -(_e12657[1]);
                                                                        } else {
                                                                            phi_11344_ = _e12657[1];
                                                                        }
                                                                        let _e12668 = phi_11344_;
                                                                        if (_e12664 > _e12668) {
                                                                            phi_11349_ = _e12664;
                                                                        } else {
                                                                            phi_11349_ = _e12668;
                                                                        }
                                                                        let _e12671 = phi_11349_;
                                                                        if (_e12657[2] < 0f) {
                                                                            phi_11356_ = -(_e12657[2]);
                                                                        } else {
                                                                            phi_11356_ = _e12657[2];
                                                                        }
                                                                        let _e12675 = phi_11356_;
                                                                        if (_e12671 > _e12675) {
                                                                            phi_11361_ = _e12671;
                                                                        } else {
                                                                            phi_11361_ = _e12675;
                                                                        }
                                                                        let _e12678 = phi_11361_;
                                                                        let _e12681 = local_18.member_1[1u];
                                                                        if (_e12681[0] < 0f) {
                                                                            phi_11375_ = -(_e12681[0]);
                                                                        } else {
                                                                            phi_11375_ = _e12681[0];
                                                                        }
                                                                        let _e12688 = phi_11375_;
                                                                        if (_e12681[1] < 0f) {
                                                                            phi_11382_ = -(_e12681[1]);
                                                                        } else {
                                                                            phi_11382_ = _e12681[1];
                                                                        }
                                                                        let _e12692 = phi_11382_;
                                                                        if (_e12688 > _e12692) {
                                                                            phi_11387_ = _e12688;
                                                                        } else {
                                                                            phi_11387_ = _e12692;
                                                                        }
                                                                        let _e12695 = phi_11387_;
                                                                        if (_e12681[2] < 0f) {
                                                                            phi_11394_ = -(_e12681[2]);
                                                                        } else {
                                                                            phi_11394_ = _e12681[2];
                                                                        }
                                                                        let _e12699 = phi_11394_;
                                                                        if (_e12695 > _e12699) {
                                                                            phi_11399_ = _e12695;
                                                                        } else {
                                                                            phi_11399_ = _e12699;
                                                                        }
                                                                        let _e12702 = phi_11399_;
                                                                        if (_e12678 > _e12702) {
                                                                            phi_11404_ = _e12678;
                                                                        } else {
                                                                            phi_11404_ = _e12702;
                                                                        }
                                                                        let _e12705 = phi_11404_;
                                                                        let _e12707 = local_18.member_3;
                                                                        let _e12711 = local_18.member_2[0u];
                                                                        if (_e12711[0] < 0f) {
                                                                            phi_11421_ = -(_e12711[0]);
                                                                        } else {
                                                                            phi_11421_ = _e12711[0];
                                                                        }
                                                                        let _e12718 = phi_11421_;
                                                                        if (_e12711[1] < 0f) {
                                                                            phi_11428_ = -(_e12711[1]);
                                                                        } else {
                                                                            phi_11428_ = _e12711[1];
                                                                        }
                                                                        let _e12722 = phi_11428_;
                                                                        if (_e12718 > _e12722) {
                                                                            phi_11433_ = _e12718;
                                                                        } else {
                                                                            phi_11433_ = _e12722;
                                                                        }
                                                                        let _e12725 = phi_11433_;
                                                                        if (_e12711[2] < 0f) {
                                                                            phi_11440_ = -(_e12711[2]);
                                                                        } else {
                                                                            phi_11440_ = _e12711[2];
                                                                        }
                                                                        let _e12729 = phi_11440_;
                                                                        if (_e12725 > _e12729) {
                                                                            phi_11445_ = _e12725;
                                                                        } else {
                                                                            phi_11445_ = _e12729;
                                                                        }
                                                                        let _e12732 = phi_11445_;
                                                                        let _e12735 = local_18.member_2[1u];
                                                                        if (_e12735[0] < 0f) {
                                                                            phi_11459_ = -(_e12735[0]);
                                                                        } else {
                                                                            phi_11459_ = _e12735[0];
                                                                        }
                                                                        let _e12742 = phi_11459_;
                                                                        if (_e12735[1] < 0f) {
                                                                            phi_11466_ = -(_e12735[1]);
                                                                        } else {
                                                                            phi_11466_ = _e12735[1];
                                                                        }
                                                                        let _e12746 = phi_11466_;
                                                                        if (_e12742 > _e12746) {
                                                                            phi_11471_ = _e12742;
                                                                        } else {
                                                                            phi_11471_ = _e12746;
                                                                        }
                                                                        let _e12749 = phi_11471_;
                                                                        if (_e12735[2] < 0f) {
                                                                            phi_11478_ = -(_e12735[2]);
                                                                        } else {
                                                                            phi_11478_ = _e12735[2];
                                                                        }
                                                                        let _e12753 = phi_11478_;
                                                                        if (_e12749 > _e12753) {
                                                                            phi_11483_ = _e12749;
                                                                        } else {
                                                                            phi_11483_ = _e12753;
                                                                        }
                                                                        let _e12756 = phi_11483_;
                                                                        if (_e12732 > _e12756) {
                                                                            phi_11488_ = _e12732;
                                                                        } else {
                                                                            phi_11488_ = _e12756;
                                                                        }
                                                                        let _e12759 = phi_11488_;
                                                                        let _e12761 = local_18.member_3;
                                                                        let _e12768 = local_18.member_3;
                                                                        if (((_e12597 * (1f + (0.000000059604645f * 8f))) + (((((((_e12651 + _e12653) + (_e12705 + _e12707)) + (_e12759 + _e12761)) * (0.000000059604645f * 16f)) + (_e12768 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e5873.member_1) {
                                                                            phi_11508_ = false;
                                                                        } else {
                                                                            phi_11508_ = true;
                                                                        }
                                                                        let _e12777 = phi_11508_;
                                                                        phi_11509_ = _e12777;
                                                                    } else {
                                                                        phi_11509_ = true;
                                                                    }
                                                                    let _e12779 = phi_11509_;
                                                                    phi_11510_ = _e12779;
                                                                } else {
                                                                    phi_11510_ = true;
                                                                }
                                                                let _e12781 = phi_11510_;
                                                                if _e12781 {
                                                                    if _e11683 {
                                                                        if _e12458 {
                                                                            phi_11526_ = true;
                                                                        } else {
                                                                            if (_e12457 <= (_e11679 * 0.25f)) {
                                                                                phi_11525_ = false;
                                                                            } else {
                                                                                phi_11525_ = true;
                                                                            }
                                                                            let _e12786 = phi_11525_;
                                                                            phi_11526_ = _e12786;
                                                                        }
                                                                        let _e12788 = phi_11526_;
                                                                        if _e12788 {
                                                                            phi_11531_ = (_e12003 + _e12003);
                                                                        } else {
                                                                            phi_11531_ = 0f;
                                                                        }
                                                                        let _e12791 = phi_11531_;
                                                                        phi_11533_ = _e12791;
                                                                    } else {
                                                                        phi_11533_ = (_e5607 - _e11675);
                                                                    }
                                                                    let _e12793 = phi_11533_;
                                                                    phi_11534_ = _e12793;
                                                                    phi_11535_ = false;
                                                                } else {
                                                                    phi_11534_ = f32();
                                                                    phi_11535_ = true;
                                                                }
                                                                let _e12795 = phi_11534_;
                                                                let _e12797 = phi_11535_;
                                                                phi_11536_ = _e12795;
                                                                phi_11537_ = _e12457;
                                                                phi_11538_ = _e12781;
                                                                phi_11539_ = _e12797;
                                                            }
                                                            let _e12799 = phi_11536_;
                                                            let _e12801 = phi_11537_;
                                                            let _e12803 = phi_11538_;
                                                            let _e12805 = phi_11539_;
                                                            phi_11540_ = _e12455;
                                                            phi_11541_ = _e12799;
                                                            phi_11542_ = _e12801;
                                                            phi_11543_ = _e12455;
                                                            phi_11544_ = _e12803;
                                                            phi_11545_ = _e12456;
                                                            phi_11546_ = _e12805;
                                                            phi_11547_ = false;
                                                        } else {
                                                            phi_11540_ = f32();
                                                            phi_11541_ = f32();
                                                            phi_11542_ = f32();
                                                            phi_11543_ = f32();
                                                            phi_11544_ = false;
                                                            phi_11545_ = false;
                                                            phi_11546_ = false;
                                                            phi_11547_ = true;
                                                        }
                                                        let _e12807 = phi_11540_;
                                                        let _e12809 = phi_11541_;
                                                        let _e12811 = phi_11542_;
                                                        let _e12813 = phi_11543_;
                                                        let _e12815 = phi_11544_;
                                                        let _e12817 = phi_11545_;
                                                        let _e12819 = phi_11546_;
                                                        let _e12821 = phi_11547_;
                                                        phi_11548_ = _e12807;
                                                        phi_11549_ = _e12809;
                                                        phi_11550_ = _e12811;
                                                        phi_11551_ = _e12813;
                                                        phi_11552_ = false;
                                                        phi_11553_ = _e12815;
                                                        phi_11554_ = _e12817;
                                                        phi_11555_ = _e12819;
                                                        phi_11556_ = _e12821;
                                                    } else {
                                                        phi_11548_ = f32();
                                                        phi_11549_ = f32();
                                                        phi_11550_ = f32();
                                                        phi_11551_ = f32();
                                                        phi_11552_ = true;
                                                        phi_11553_ = false;
                                                        phi_11554_ = false;
                                                        phi_11555_ = false;
                                                        phi_11556_ = false;
                                                    }
                                                    let _e12823 = phi_11548_;
                                                    let _e12825 = phi_11549_;
                                                    let _e12827 = phi_11550_;
                                                    let _e12829 = phi_11551_;
                                                    let _e12831 = phi_11552_;
                                                    let _e12833 = phi_11553_;
                                                    let _e12835 = phi_11554_;
                                                    let _e12837 = phi_11555_;
                                                    let _e12839 = phi_11556_;
                                                    phi_11557_ = _e12823;
                                                    phi_11558_ = _e12825;
                                                    phi_11559_ = _e12827;
                                                    phi_11560_ = _e12829;
                                                    phi_11561_ = _e12831;
                                                    phi_11562_ = _e12833;
                                                    phi_11563_ = _e12835;
                                                    phi_11564_ = _e12837;
                                                    phi_11565_ = _e12839;
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
                                                let _e12841 = phi_11557_;
                                                let _e12843 = phi_11558_;
                                                let _e12845 = phi_11559_;
                                                let _e12847 = phi_11560_;
                                                let _e12849 = phi_11561_;
                                                let _e12851 = phi_11562_;
                                                let _e12853 = phi_11563_;
                                                let _e12855 = phi_11564_;
                                                let _e12857 = phi_11565_;
                                                if _e12849 {
                                                    if (_e11675 <= _e11677) {
                                                        let _e13018 = (_e11685 + 1u);
                                                        let _e13019 = (_e13018 > 3u);
                                                        if _e13019 {
                                                            phi_11578_ = false;
                                                        } else {
                                                            phi_11578_ = true;
                                                        }
                                                        let _e13021 = phi_11578_;
                                                        phi_11900_ = _e13018;
                                                        phi_11901_ = f32();
                                                        phi_11902_ = false;
                                                        phi_11903_ = _e13021;
                                                        phi_11904_ = _e13019;
                                                    } else {
                                                        let _e12861 = local_16.member[0u];
                                                        let _e12864 = local_16.member_1[0u];
                                                        let _e12867 = local_16.member[0u];
                                                        let _e12873 = local_16.member_2[0u];
                                                        let _e12874 = ((_e12861 + ((_e12864 - _e12867) * _e11681)) - _e12873);
                                                        let _e12877 = local_16.member[1u];
                                                        let _e12880 = local_16.member_1[1u];
                                                        let _e12883 = local_16.member[1u];
                                                        let _e12889 = local_16.member_2[1u];
                                                        let _e12890 = ((_e12877 + ((_e12880 - _e12883) * _e11681)) - _e12889);
                                                        if (_e12874 < _e12890) {
                                                            phi_11651_ = _e12874;
                                                        } else {
                                                            phi_11651_ = _e12890;
                                                        }
                                                        let _e12893 = phi_11651_;
                                                        let _e12896 = local_16.member[2u];
                                                        let _e12899 = local_16.member_1[2u];
                                                        let _e12902 = local_16.member[2u];
                                                        let _e12908 = local_16.member_2[2u];
                                                        let _e12909 = ((_e12896 + ((_e12899 - _e12902) * _e11681)) - _e12908);
                                                        let _e12912 = local_16.member[3u];
                                                        let _e12915 = local_16.member_1[3u];
                                                        let _e12918 = local_16.member[3u];
                                                        let _e12924 = local_16.member_2[3u];
                                                        let _e12925 = ((_e12912 + ((_e12915 - _e12918) * _e11681)) - _e12924);
                                                        if (_e12909 < _e12925) {
                                                            phi_11724_ = _e12909;
                                                        } else {
                                                            phi_11724_ = _e12925;
                                                        }
                                                        let _e12928 = phi_11724_;
                                                        if (_e12893 < _e12928) {
                                                            phi_11729_ = _e12893;
                                                        } else {
                                                            phi_11729_ = _e12928;
                                                        }
                                                        let _e12931 = phi_11729_;
                                                        let _e12934 = local_17.member[0u];
                                                        let _e12937 = local_17.member_1[0u];
                                                        let _e12940 = local_17.member[0u];
                                                        let _e12946 = local_17.member_2[0u];
                                                        let _e12947 = ((_e12934 + ((_e12937 - _e12940) * _e11675)) - _e12946);
                                                        let _e12950 = local_17.member[1u];
                                                        let _e12953 = local_17.member_1[1u];
                                                        let _e12956 = local_17.member[1u];
                                                        let _e12962 = local_17.member_2[1u];
                                                        let _e12963 = ((_e12950 + ((_e12953 - _e12956) * _e11675)) - _e12962);
                                                        if (_e12947 < _e12963) {
                                                            phi_11802_ = _e12947;
                                                        } else {
                                                            phi_11802_ = _e12963;
                                                        }
                                                        let _e12966 = phi_11802_;
                                                        let _e12969 = local_17.member[2u];
                                                        let _e12972 = local_17.member_1[2u];
                                                        let _e12975 = local_17.member[2u];
                                                        let _e12981 = local_17.member_2[2u];
                                                        let _e12982 = ((_e12969 + ((_e12972 - _e12975) * _e11675)) - _e12981);
                                                        let _e12985 = local_17.member[3u];
                                                        let _e12988 = local_17.member_1[3u];
                                                        let _e12991 = local_17.member[3u];
                                                        let _e12997 = local_17.member_2[3u];
                                                        let _e12998 = ((_e12985 + ((_e12988 - _e12991) * _e11675)) - _e12997);
                                                        if (_e12982 < _e12998) {
                                                            phi_11875_ = _e12982;
                                                        } else {
                                                            phi_11875_ = _e12998;
                                                        }
                                                        let _e13001 = phi_11875_;
                                                        if (_e12966 < _e13001) {
                                                            phi_11880_ = _e12966;
                                                        } else {
                                                            phi_11880_ = _e13001;
                                                        }
                                                        let _e13004 = phi_11880_;
                                                        if (_e13004 > 0f) {
                                                            phi_11898_ = 0.5f;
                                                        } else {
                                                            let _e13008 = (0.95f * (_e12931 / (_e12931 - _e13004)));
                                                            if (_e13008 > 0.0625f) {
                                                                if (_e13008 < 0.9f) {
                                                                    phi_11896_ = _e13008;
                                                                } else {
                                                                    phi_11896_ = 0.9f;
                                                                }
                                                                let _e13012 = phi_11896_;
                                                                phi_11897_ = _e13012;
                                                            } else {
                                                                phi_11897_ = 0.0625f;
                                                            }
                                                            let _e13014 = phi_11897_;
                                                            phi_11898_ = _e13014;
                                                        }
                                                        let _e13016 = phi_11898_;
                                                        phi_11900_ = u32();
                                                        phi_11901_ = (_e12003 * _e13016);
                                                        phi_11902_ = true;
                                                        phi_11903_ = false;
                                                        phi_11904_ = false;
                                                    }
                                                    let _e13023 = phi_11900_;
                                                    let _e13025 = phi_11901_;
                                                    let _e13027 = phi_11902_;
                                                    let _e13029 = phi_11903_;
                                                    let _e13031 = phi_11904_;
                                                    phi_11905_ = _e13023;
                                                    phi_11906_ = _e11677;
                                                    phi_11907_ = _e13025;
                                                    phi_11908_ = _e11679;
                                                    phi_11909_ = _e11681;
                                                    phi_11910_ = _e11683;
                                                    phi_11911_ = _e11685;
                                                    phi_11912_ = _e13027;
                                                    phi_11913_ = _e13029;
                                                    phi_11914_ = _e13031;
                                                    phi_11915_ = false;
                                                    phi_11916_ = false;
                                                    phi_11917_ = false;
                                                } else {
                                                    phi_11905_ = u32();
                                                    phi_11906_ = _e12841;
                                                    phi_11907_ = _e12843;
                                                    phi_11908_ = _e12845;
                                                    phi_11909_ = _e11675;
                                                    phi_11910_ = true;
                                                    phi_11911_ = 0u;
                                                    phi_11912_ = _e12851;
                                                    phi_11913_ = false;
                                                    phi_11914_ = false;
                                                    phi_11915_ = _e12853;
                                                    phi_11916_ = _e12855;
                                                    phi_11917_ = _e12857;
                                                }
                                                let _e13033 = phi_11905_;
                                                let _e13035 = phi_11906_;
                                                let _e13037 = phi_11907_;
                                                let _e13039 = phi_11908_;
                                                let _e13041 = phi_11909_;
                                                let _e13043 = phi_11910_;
                                                let _e13045 = phi_11911_;
                                                let _e13047 = phi_11912_;
                                                let _e13049 = phi_11913_;
                                                let _e13051 = phi_11914_;
                                                let _e13053 = phi_11915_;
                                                let _e13055 = phi_11916_;
                                                let _e13057 = phi_11917_;
                                                if _e13047 {
                                                    let _e13058 = (_e13041 + _e13037);
                                                    if (_e13058 > _e13035) {
                                                        phi_11926_ = _e13058;
                                                    } else {
                                                        phi_11926_ = _e13035;
                                                    }
                                                    let _e13061 = phi_11926_;
                                                    if (_e13061 < _e5607) {
                                                        phi_11931_ = _e13061;
                                                    } else {
                                                        phi_11931_ = _e5607;
                                                    }
                                                    let _e13064 = phi_11931_;
                                                    if !(_e11683) {
                                                        phi_11940_ = true;
                                                    } else {
                                                        phi_11940_ = ((_e13064 - _e13041) > _e11670);
                                                    }
                                                    let _e13068 = phi_11940_;
                                                    if _e13068 {
                                                        phi_11944_ = false;
                                                    } else {
                                                        phi_11944_ = true;
                                                    }
                                                    let _e13070 = phi_11944_;
                                                    phi_11945_ = _e13064;
                                                    phi_11946_ = _e13035;
                                                    phi_11947_ = _e13039;
                                                    phi_11948_ = _e13041;
                                                    phi_11949_ = _e13043;
                                                    phi_11950_ = _e13045;
                                                    phi_11951_ = _e13068;
                                                    phi_11952_ = _e13070;
                                                    phi_11953_ = false;
                                                    phi_11954_ = false;
                                                    phi_11955_ = false;
                                                    phi_11956_ = false;
                                                } else {
                                                    phi_11945_ = _e11675;
                                                    phi_11946_ = _e11677;
                                                    phi_11947_ = _e11679;
                                                    phi_11948_ = _e11681;
                                                    phi_11949_ = _e11683;
                                                    phi_11950_ = _e13033;
                                                    phi_11951_ = _e13049;
                                                    phi_11952_ = false;
                                                    phi_11953_ = _e13051;
                                                    phi_11954_ = _e13053;
                                                    phi_11955_ = _e13055;
                                                    phi_11956_ = _e13057;
                                                }
                                                let _e13072 = phi_11945_;
                                                let _e13074 = phi_11946_;
                                                let _e13076 = phi_11947_;
                                                let _e13078 = phi_11948_;
                                                let _e13080 = phi_11949_;
                                                let _e13082 = phi_11950_;
                                                let _e13084 = phi_11951_;
                                                let _e13086 = phi_11952_;
                                                let _e13088 = phi_11953_;
                                                let _e13090 = phi_11954_;
                                                let _e13092 = phi_11955_;
                                                let _e13094 = phi_11956_;
                                                phi_9778_ = _e13072;
                                                phi_9780_ = _e13074;
                                                phi_9782_ = _e13076;
                                                phi_9784_ = _e13078;
                                                phi_9786_ = _e13080;
                                                phi_9788_ = _e13082;
                                                phi_11957_ = _e13035;
                                                phi_11958_ = _e12847;
                                                phi_11959_ = _e13084;
                                                phi_11960_ = _e13086;
                                                phi_11961_ = _e13088;
                                                phi_11962_ = _e13090;
                                                phi_11963_ = _e13092;
                                                phi_11964_ = false;
                                                phi_11965_ = _e13094;
                                            } else {
                                                phi_9778_ = f32();
                                                phi_9780_ = f32();
                                                phi_9782_ = f32();
                                                phi_9784_ = f32();
                                                phi_9786_ = bool();
                                                phi_9788_ = u32();
                                                phi_11957_ = f32();
                                                phi_11958_ = f32();
                                                phi_11959_ = false;
                                                phi_11960_ = false;
                                                phi_11961_ = false;
                                                phi_11962_ = false;
                                                phi_11963_ = false;
                                                phi_11964_ = true;
                                                phi_11965_ = false;
                                            }
                                            let _e13096 = phi_9778_;
                                            let _e13098 = phi_9780_;
                                            let _e13100 = phi_9782_;
                                            let _e13102 = phi_9784_;
                                            let _e13104 = phi_9786_;
                                            let _e13106 = phi_9788_;
                                            let _e13108 = phi_11957_;
                                            let _e13110 = phi_11958_;
                                            let _e13112 = phi_11959_;
                                            let _e13114 = phi_11960_;
                                            let _e13116 = phi_11961_;
                                            let _e13118 = phi_11962_;
                                            let _e13120 = phi_11963_;
                                            let _e13122 = phi_11964_;
                                            let _e13124 = phi_11965_;
                                            local_108 = _e13114;
                                            local_149 = _e13116;
                                            local_150 = _e13118;
                                            local_151 = _e13120;
                                            local_152 = _e13122;
                                            local_153 = _e13124;
                                            local_154 = _e13114;
                                            local_155 = _e13110;
                                            local_156 = _e13108;
                                            continue;
                                            continuing {
                                                phi_9774_ = _e11697;
                                                phi_9777_ = _e13096;
                                                phi_9779_ = _e13098;
                                                phi_9781_ = _e13100;
                                                phi_9783_ = _e13102;
                                                phi_9785_ = _e13104;
                                                phi_9787_ = _e13106;
                                                break if !(_e13112);
                                            }
                                        }
                                        let _e13127 = local_108;
                                        if _e13127 {
                                            phi_11969_ = false;
                                            phi_11970_ = false;
                                            phi_11971_ = false;
                                            phi_11972_ = false;
                                            phi_11973_ = false;
                                        } else {
                                            let _e17104 = local_149;
                                            phi_11969_ = _e17104;
                                            let _e17107 = local_150;
                                            phi_11970_ = _e17107;
                                            let _e17110 = local_151;
                                            phi_11971_ = _e17110;
                                            let _e17113 = local_152;
                                            phi_11972_ = _e17113;
                                            let _e17116 = local_153;
                                            phi_11973_ = _e17116;
                                        }
                                        let _e13129 = phi_11969_;
                                        let _e13131 = phi_11970_;
                                        let _e13133 = phi_11971_;
                                        let _e13135 = phi_11972_;
                                        let _e13137 = phi_11973_;
                                        if _e13129 {
                                            let _e13139 = local_109;
                                            phi_11978_ = type_44(1u, _e13139);
                                            phi_11979_ = false;
                                            phi_11980_ = false;
                                            phi_11981_ = false;
                                            phi_11982_ = false;
                                            phi_11983_ = false;
                                        } else {
                                            phi_11978_ = type_44();
                                            phi_11979_ = _e13131;
                                            phi_11980_ = _e13133;
                                            let _e17123 = local_154;
                                            phi_11981_ = _e17123;
                                            phi_11982_ = _e13135;
                                            phi_11983_ = _e13137;
                                        }
                                        let _e13142 = phi_11978_;
                                        let _e13144 = phi_11979_;
                                        let _e13146 = phi_11980_;
                                        let _e13148 = phi_11981_;
                                        let _e13150 = phi_11982_;
                                        let _e13152 = phi_11983_;
                                        if _e13144 {
                                            phi_11988_ = type_44(0u, type_44().member_1);
                                            phi_11989_ = false;
                                            phi_11990_ = false;
                                            phi_11991_ = false;
                                            phi_11992_ = false;
                                            phi_11993_ = true;
                                        } else {
                                            phi_11988_ = _e13142;
                                            phi_11989_ = _e13146;
                                            phi_11990_ = _e13148;
                                            phi_11991_ = _e13150;
                                            phi_11992_ = _e13152;
                                            phi_11993_ = _e13129;
                                        }
                                        let _e13156 = phi_11988_;
                                        let _e13158 = phi_11989_;
                                        let _e13160 = phi_11990_;
                                        let _e13162 = phi_11991_;
                                        let _e13164 = phi_11992_;
                                        let _e13166 = phi_11993_;
                                        if _e13158 {
                                            let _e17134 = local_155;
                                            phi_11997_ = _e17134;
                                            phi_11998_ = true;
                                            phi_11999_ = false;
                                            phi_12000_ = false;
                                            phi_12001_ = false;
                                        } else {
                                            let _e17136 = local_156;
                                            phi_11997_ = _e17136;
                                            phi_11998_ = _e13160;
                                            phi_11999_ = _e13162;
                                            phi_12000_ = _e13164;
                                            phi_12001_ = _e13166;
                                        }
                                        let _e13168 = phi_11997_;
                                        let _e13170 = phi_11998_;
                                        let _e13172 = phi_11999_;
                                        let _e13174 = phi_12000_;
                                        let _e13176 = phi_12001_;
                                        if _e13170 {
                                            phi_12005_ = _e13168;
                                            phi_12006_ = true;
                                            phi_12007_ = false;
                                            phi_12008_ = false;
                                        } else {
                                            let _e17143 = local_157;
                                            phi_12005_ = _e17143;
                                            phi_12006_ = _e13172;
                                            phi_12007_ = _e13174;
                                            phi_12008_ = _e13176;
                                        }
                                        let _e13178 = phi_12005_;
                                        let _e13180 = phi_12006_;
                                        let _e13182 = phi_12007_;
                                        let _e13184 = phi_12008_;
                                        if _e13180 {
                                            phi_12013_ = type_44(1u, _e13178);
                                            phi_12014_ = false;
                                            phi_12015_ = false;
                                        } else {
                                            phi_12013_ = type_44();
                                            phi_12014_ = _e13182;
                                            phi_12015_ = _e13184;
                                        }
                                        let _e13187 = phi_12013_;
                                        let _e13189 = phi_12014_;
                                        let _e13191 = phi_12015_;
                                        if _e13189 {
                                            phi_12020_ = type_44(0u, type_44().member_1);
                                            phi_12021_ = true;
                                        } else {
                                            phi_12020_ = _e13156;
                                            phi_12021_ = _e13191;
                                        }
                                        let _e13195 = phi_12020_;
                                        let _e13197 = phi_12021_;
                                        if _e13197 {
                                            phi_12025_ = _e13195;
                                        } else {
                                            phi_12025_ = _e13187;
                                        }
                                        let _e13199 = phi_12025_;
                                        phi_12032_ = _e13199.member_1;
                                        phi_12033_ = (_e13199.member != 0u);
                                    } else {
                                        phi_12032_ = _e11395;
                                        phi_12033_ = true;
                                    }
                                    let _e13204 = phi_12032_;
                                    let _e13206 = phi_12033_;
                                    if _e13206 {
                                        let _e13207 = (_e13204 > _e5605);
                                        if _e13207 {
                                            phi_14198_ = f32();
                                            phi_14199_ = u32();
                                            phi_14200_ = f32();
                                            phi_14201_ = type_46();
                                            phi_14202_ = u32();
                                            phi_14203_ = u32();
                                            phi_14204_ = false;
                                            phi_14205_ = false;
                                            phi_14206_ = false;
                                        } else {
                                            let _e13210 = local_18.member[0u];
                                            let _e13216 = local_18.member[1u];
                                            let _e13232 = local_18.member_1[0u];
                                            let _e13238 = local_18.member_1[1u];
                                            let _e13254 = local_18.member_2[0u];
                                            let _e13260 = local_18.member_2[1u];
                                            let _e13274 = function_3(array<f32, 3>((_e13210[0] + ((_e13216[0] - _e13210[0]) * _e11399)), (_e13210[1] + ((_e13216[1] - _e13210[1]) * _e11399)), (_e13210[2] + ((_e13216[2] - _e13210[2]) * _e11399))), array<f32, 3>((_e13232[0] + ((_e13238[0] - _e13232[0]) * _e11399)), (_e13232[1] + ((_e13238[1] - _e13232[1]) * _e11399)), (_e13232[2] + ((_e13238[2] - _e13232[2]) * _e11399))), array<f32, 3>((_e13254[0] + ((_e13260[0] - _e13254[0]) * _e11399)), (_e13254[1] + ((_e13260[1] - _e13254[1]) * _e11399)), (_e13254[2] + ((_e13260[2] - _e13254[2]) * _e11399))), _e316.member);
                                            if (_e13274[0] < 0f) {
                                                phi_12145_ = -(_e13274[0]);
                                            } else {
                                                phi_12145_ = _e13274[0];
                                            }
                                            let _e13279 = phi_12145_;
                                            if (_e13274[1] < 0f) {
                                                phi_12152_ = -(_e13274[1]);
                                            } else {
                                                phi_12152_ = _e13274[1];
                                            }
                                            let _e13284 = phi_12152_;
                                            if (_e13274[2] < 0f) {
                                                phi_12160_ = -(_e13274[2]);
                                            } else {
                                                phi_12160_ = _e13274[2];
                                            }
                                            let _e13290 = phi_12160_;
                                            let _e13291 = ((_e13279 + _e13284) + _e13290);
                                            let _e13294 = local_18.member[0u];
                                            let _e13301 = local_18.member_1[0u];
                                            let _e13307 = local_18.member_2[0u];
                                            let _e13311 = (_e13294[0] - _e13301[0]);
                                            let _e13312 = (_e13294[1] - _e13301[1]);
                                            let _e13313 = (_e13294[2] - _e13301[2]);
                                            if (_e316.member == 0u) {
                                                phi_12218_ = array<f32, 3>(_e13294[0], _e13294[1], _e13294[2]);
                                            } else {
                                                phi_12218_ = array<f32, 3>((_e13311 - _e13307[0]), (_e13312 - _e13307[1]), (_e13313 - _e13307[2]));
                                            }
                                            let _e13320 = phi_12218_;
                                            let _e13326 = local_18.member[1u];
                                            let _e13333 = local_18.member_1[1u];
                                            let _e13339 = local_18.member_2[1u];
                                            let _e13343 = (_e13326[0] - _e13333[0]);
                                            let _e13344 = (_e13326[1] - _e13333[1]);
                                            let _e13345 = (_e13326[2] - _e13333[2]);
                                            if (_e316.member == 0u) {
                                                phi_12286_ = array<f32, 3>(_e13326[0], _e13326[1], _e13326[2]);
                                            } else {
                                                phi_12286_ = array<f32, 3>((_e13343 - _e13339[0]), (_e13344 - _e13339[1]), (_e13345 - _e13339[2]));
                                            }
                                            let _e13352 = phi_12286_;
                                            let _e13358 = local_18.member[0u];
                                            if (_e13358[0] < 0f) {
                                                phi_12311_ = -(_e13358[0]);
                                            } else {
                                                phi_12311_ = _e13358[0];
                                            }
                                            let _e13365 = phi_12311_;
                                            if (_e13358[1] < 0f) {
                                                phi_12318_ = -(_e13358[1]);
                                            } else {
                                                phi_12318_ = _e13358[1];
                                            }
                                            let _e13369 = phi_12318_;
                                            if (_e13365 > _e13369) {
                                                phi_12323_ = _e13365;
                                            } else {
                                                phi_12323_ = _e13369;
                                            }
                                            let _e13372 = phi_12323_;
                                            if (_e13358[2] < 0f) {
                                                phi_12330_ = -(_e13358[2]);
                                            } else {
                                                phi_12330_ = _e13358[2];
                                            }
                                            let _e13376 = phi_12330_;
                                            if (_e13372 > _e13376) {
                                                phi_12335_ = _e13372;
                                            } else {
                                                phi_12335_ = _e13376;
                                            }
                                            let _e13379 = phi_12335_;
                                            let _e13382 = local_18.member[1u];
                                            if (_e13382[0] < 0f) {
                                                phi_12348_ = -(_e13382[0]);
                                            } else {
                                                phi_12348_ = _e13382[0];
                                            }
                                            let _e13389 = phi_12348_;
                                            if (_e13382[1] < 0f) {
                                                phi_12355_ = -(_e13382[1]);
                                            } else {
                                                phi_12355_ = _e13382[1];
                                            }
                                            let _e13393 = phi_12355_;
                                            if (_e13389 > _e13393) {
                                                phi_12360_ = _e13389;
                                            } else {
                                                phi_12360_ = _e13393;
                                            }
                                            let _e13396 = phi_12360_;
                                            if (_e13382[2] < 0f) {
                                                phi_12367_ = -(_e13382[2]);
                                            } else {
                                                phi_12367_ = _e13382[2];
                                            }
                                            let _e13400 = phi_12367_;
                                            if (_e13396 > _e13400) {
                                                phi_12372_ = _e13396;
                                            } else {
                                                phi_12372_ = _e13400;
                                            }
                                            let _e13403 = phi_12372_;
                                            if (_e13379 > _e13403) {
                                                phi_12377_ = _e13379;
                                            } else {
                                                phi_12377_ = _e13403;
                                            }
                                            let _e13406 = phi_12377_;
                                            let _e13408 = local_18.member_3;
                                            let _e13412 = local_18.member_1[0u];
                                            if (_e13412[0] < 0f) {
                                                phi_12394_ = -(_e13412[0]);
                                            } else {
                                                phi_12394_ = _e13412[0];
                                            }
                                            let _e13419 = phi_12394_;
                                            if (_e13412[1] < 0f) {
                                                phi_12401_ = -(_e13412[1]);
                                            } else {
                                                phi_12401_ = _e13412[1];
                                            }
                                            let _e13423 = phi_12401_;
                                            if (_e13419 > _e13423) {
                                                phi_12406_ = _e13419;
                                            } else {
                                                phi_12406_ = _e13423;
                                            }
                                            let _e13426 = phi_12406_;
                                            if (_e13412[2] < 0f) {
                                                phi_12413_ = -(_e13412[2]);
                                            } else {
                                                phi_12413_ = _e13412[2];
                                            }
                                            let _e13430 = phi_12413_;
                                            if (_e13426 > _e13430) {
                                                phi_12418_ = _e13426;
                                            } else {
                                                phi_12418_ = _e13430;
                                            }
                                            let _e13433 = phi_12418_;
                                            let _e13436 = local_18.member_1[1u];
                                            if (_e13436[0] < 0f) {
                                                phi_12432_ = -(_e13436[0]);
                                            } else {
                                                phi_12432_ = _e13436[0];
                                            }
                                            let _e13443 = phi_12432_;
                                            if (_e13436[1] < 0f) {
                                                phi_12439_ = -(_e13436[1]);
                                            } else {
                                                phi_12439_ = _e13436[1];
                                            }
                                            let _e13447 = phi_12439_;
                                            if (_e13443 > _e13447) {
                                                phi_12444_ = _e13443;
                                            } else {
                                                phi_12444_ = _e13447;
                                            }
                                            let _e13450 = phi_12444_;
                                            if (_e13436[2] < 0f) {
                                                phi_12451_ = -(_e13436[2]);
                                            } else {
                                                phi_12451_ = _e13436[2];
                                            }
                                            let _e13454 = phi_12451_;
                                            if (_e13450 > _e13454) {
                                                phi_12456_ = _e13450;
                                            } else {
                                                phi_12456_ = _e13454;
                                            }
                                            let _e13457 = phi_12456_;
                                            if (_e13433 > _e13457) {
                                                phi_12461_ = _e13433;
                                            } else {
                                                phi_12461_ = _e13457;
                                            }
                                            let _e13460 = phi_12461_;
                                            let _e13462 = local_18.member_3;
                                            let _e13466 = local_18.member_2[0u];
                                            if (_e13466[0] < 0f) {
                                                phi_12478_ = -(_e13466[0]);
                                            } else {
                                                phi_12478_ = _e13466[0];
                                            }
                                            let _e13473 = phi_12478_;
                                            if (_e13466[1] < 0f) {
                                                phi_12485_ = -(_e13466[1]);
                                            } else {
                                                phi_12485_ = _e13466[1];
                                            }
                                            let _e13477 = phi_12485_;
                                            if (_e13473 > _e13477) {
                                                phi_12490_ = _e13473;
                                            } else {
                                                phi_12490_ = _e13477;
                                            }
                                            let _e13480 = phi_12490_;
                                            if (_e13466[2] < 0f) {
                                                phi_12497_ = -(_e13466[2]);
                                            } else {
                                                phi_12497_ = _e13466[2];
                                            }
                                            let _e13484 = phi_12497_;
                                            if (_e13480 > _e13484) {
                                                phi_12502_ = _e13480;
                                            } else {
                                                phi_12502_ = _e13484;
                                            }
                                            let _e13487 = phi_12502_;
                                            let _e13490 = local_18.member_2[1u];
                                            if (_e13490[0] < 0f) {
                                                phi_12516_ = -(_e13490[0]);
                                            } else {
                                                phi_12516_ = _e13490[0];
                                            }
                                            let _e13497 = phi_12516_;
                                            if (_e13490[1] < 0f) {
                                                phi_12523_ = -(_e13490[1]);
                                            } else {
                                                phi_12523_ = _e13490[1];
                                            }
                                            let _e13501 = phi_12523_;
                                            if (_e13497 > _e13501) {
                                                phi_12528_ = _e13497;
                                            } else {
                                                phi_12528_ = _e13501;
                                            }
                                            let _e13504 = phi_12528_;
                                            if (_e13490[2] < 0f) {
                                                phi_12535_ = -(_e13490[2]);
                                            } else {
                                                phi_12535_ = _e13490[2];
                                            }
                                            let _e13508 = phi_12535_;
                                            if (_e13504 > _e13508) {
                                                phi_12540_ = _e13504;
                                            } else {
                                                phi_12540_ = _e13508;
                                            }
                                            let _e13511 = phi_12540_;
                                            if (_e13487 > _e13511) {
                                                phi_12545_ = _e13487;
                                            } else {
                                                phi_12545_ = _e13511;
                                            }
                                            let _e13514 = phi_12545_;
                                            let _e13516 = local_18.member_3;
                                            let _e13523 = local_18.member_3;
                                            local_14 = type_33(array<array<array<f32, 3>, 4>, 2>(array<array<f32, 3>, 4>(_e13294, array<f32, 3>(_e13311, _e13312, _e13313), array<f32, 3>((_e13294[0] - _e13307[0]), (_e13294[1] - _e13307[1]), (_e13294[2] - _e13307[2])), array<f32, 3>(_e13320[0], _e13320[1], _e13320[2])), array<array<f32, 3>, 4>(_e13326, array<f32, 3>(_e13343, _e13344, _e13345), array<f32, 3>((_e13326[0] - _e13339[0]), (_e13326[1] - _e13339[1]), (_e13326[2] - _e13339[2])), array<f32, 3>(_e13352[0], _e13352[1], _e13352[2]))), ((((((_e13406 + _e13408) + (_e13460 + _e13462)) + (_e13514 + _e13516)) * (0.000000059604645f * 16f)) + (_e13523 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)), _e5873.member_1);
                                            let _e13545 = local_14.member_1;
                                            if (_e13291 > _e13545) {
                                                if ((bitcast<u32>(_e13291) & 2139095040u) != 2139095040u) {
                                                    let _e13550 = (1f / _e13291);
                                                    let _e13552 = (_e13274[0] * _e13550);
                                                    let _e13554 = (_e13274[1] * _e13550);
                                                    let _e13556 = (_e13274[2] * _e13550);
                                                    let _e13561 = (((_e13552 * _e13552) + (_e13554 * _e13554)) + (_e13556 * _e13556));
                                                    if (_e13561 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e13561 > 0f) {
                                                            phi_12646_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_12646_ = 0f;
                                                        }
                                                        let _e13614 = phi_12646_;
                                                        phi_12710_ = _e13614;
                                                    } else {
                                                        phi_12653_ = type_14(0i, 5i);
                                                        phi_12656_ = bitcast<f32>(((bitcast<u32>(_e13561) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e13569 = phi_12653_;
                                                            let _e13571 = phi_12656_;
                                                            local_110 = _e13571;
                                                            if (_e13569.member < _e13569.member_1) {
                                                                let _e13578 = (_e13569.member + 1i);
                                                                if ((false == (_e13578 > _e13569.member)) != false) {
                                                                    phi_12677_ = true;
                                                                } else {
                                                                    phi_12677_ = false;
                                                                }
                                                                let _e13583 = phi_12677_;
                                                                if _e13583 {
                                                                    phi_12683_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_12683_ = type_15(1u, _e13578);
                                                                }
                                                                let _e13588 = phi_12683_;
                                                                phi_12654_ = type_14(_e13588.member_1, _e13569.member_1);
                                                                phi_12697_ = type_15(1u, _e13569.member);
                                                            } else {
                                                                phi_12654_ = _e13569;
                                                                phi_12697_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e13594 = phi_12654_;
                                                            let _e13596 = phi_12697_;
                                                            let _e13599 = (bitcast<i32>(_e13596.member) != 0i);
                                                            if _e13599 {
                                                                phi_12657_ = (0.5f * (_e13571 + (_e13561 / _e13571)));
                                                            } else {
                                                                phi_12657_ = f32();
                                                            }
                                                            let _e13604 = phi_12657_;
                                                            continue;
                                                            continuing {
                                                                phi_12653_ = _e13594;
                                                                phi_12656_ = _e13604;
                                                                break if !(_e13599);
                                                            }
                                                        }
                                                        let _e13609 = local_110;
                                                        phi_12710_ = (_e13609 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e13616 = phi_12710_;
                                                    let _e13617 = (0.000000059604645f * 12f);
                                                    let _e13619 = local_14.member_1;
                                                    let _e13622 = local_14.member_2;
                                                    let _e13626 = ((_e13619 * 1.01f) + ((_e13622 * _e13616) * (1f + _e13617)));
                                                    let _e13630 = local_14.member[0u][0u];
                                                    let _e13638 = (((_e13552 * _e13630[0]) + (_e13554 * _e13630[1])) + (_e13556 * _e13630[2]));
                                                    let _e13642 = local_14.member[0u][1u];
                                                    let _e13650 = (((_e13552 * _e13642[0]) + (_e13554 * _e13642[1])) + (_e13556 * _e13642[2]));
                                                    let _e13654 = local_14.member[0u][2u];
                                                    let _e13662 = (((_e13552 * _e13654[0]) + (_e13554 * _e13654[1])) + (_e13556 * _e13654[2]));
                                                    let _e13666 = local_14.member[0u][3u];
                                                    let _e13674 = (((_e13552 * _e13666[0]) + (_e13554 * _e13666[1])) + (_e13556 * _e13666[2]));
                                                    let _e13678 = local_14.member[1u][0u];
                                                    let _e13686 = (((_e13552 * _e13678[0]) + (_e13554 * _e13678[1])) + (_e13556 * _e13678[2]));
                                                    let _e13690 = local_14.member[1u][1u];
                                                    let _e13698 = (((_e13552 * _e13690[0]) + (_e13554 * _e13690[1])) + (_e13556 * _e13690[2]));
                                                    let _e13702 = local_14.member[1u][2u];
                                                    let _e13710 = (((_e13552 * _e13702[0]) + (_e13554 * _e13702[1])) + (_e13556 * _e13702[2]));
                                                    let _e13714 = local_14.member[1u][3u];
                                                    let _e13722 = (((_e13552 * _e13714[0]) + (_e13554 * _e13714[1])) + (_e13556 * _e13714[2]));
                                                    if (_e13638 < 0f) {
                                                        phi_12844_ = -(_e13638);
                                                    } else {
                                                        phi_12844_ = _e13638;
                                                    }
                                                    let _e13726 = phi_12844_;
                                                    if (_e13686 < 0f) {
                                                        phi_12850_ = -(_e13686);
                                                    } else {
                                                        phi_12850_ = _e13686;
                                                    }
                                                    let _e13730 = phi_12850_;
                                                    if (_e13650 < 0f) {
                                                        phi_12859_ = -(_e13650);
                                                    } else {
                                                        phi_12859_ = _e13650;
                                                    }
                                                    let _e13737 = phi_12859_;
                                                    if (_e13698 < 0f) {
                                                        phi_12865_ = -(_e13698);
                                                    } else {
                                                        phi_12865_ = _e13698;
                                                    }
                                                    let _e13741 = phi_12865_;
                                                    if (_e13662 < 0f) {
                                                        phi_12874_ = -(_e13662);
                                                    } else {
                                                        phi_12874_ = _e13662;
                                                    }
                                                    let _e13748 = phi_12874_;
                                                    if (_e13710 < 0f) {
                                                        phi_12880_ = -(_e13710);
                                                    } else {
                                                        phi_12880_ = _e13710;
                                                    }
                                                    let _e13752 = phi_12880_;
                                                    if (_e13674 < 0f) {
                                                        phi_12889_ = -(_e13674);
                                                    } else {
                                                        phi_12889_ = _e13674;
                                                    }
                                                    let _e13759 = phi_12889_;
                                                    if (_e13722 < 0f) {
                                                        phi_12895_ = -(_e13722);
                                                    } else {
                                                        phi_12895_ = _e13722;
                                                    }
                                                    let _e13763 = phi_12895_;
                                                    local_15 = type_29(array<f32, 4>(_e13638, _e13650, _e13662, _e13674), array<f32, 4>(_e13686, _e13698, _e13710, _e13722), array<f32, 4>((_e13626 + ((_e13726 + _e13730) * _e13617)), (_e13626 + ((_e13737 + _e13741) * _e13617)), (_e13626 + ((_e13748 + _e13752) * _e13617)), (_e13626 + ((_e13759 + _e13763) * _e13617))));
                                                    let _e13775 = (((_e13552 * _e13552) + (_e13554 * _e13554)) + (_e13556 * _e13556));
                                                    if (_e13775 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e13775 > 0f) {
                                                            phi_12938_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_12938_ = 0f;
                                                        }
                                                        let _e13828 = phi_12938_;
                                                        phi_13002_ = _e13828;
                                                    } else {
                                                        phi_12945_ = type_14(0i, 5i);
                                                        phi_12948_ = bitcast<f32>(((bitcast<u32>(_e13775) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e13783 = phi_12945_;
                                                            let _e13785 = phi_12948_;
                                                            local_111 = _e13785;
                                                            if (_e13783.member < _e13783.member_1) {
                                                                let _e13792 = (_e13783.member + 1i);
                                                                if ((false == (_e13792 > _e13783.member)) != false) {
                                                                    phi_12969_ = true;
                                                                } else {
                                                                    phi_12969_ = false;
                                                                }
                                                                let _e13797 = phi_12969_;
                                                                if _e13797 {
                                                                    phi_12975_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_12975_ = type_15(1u, _e13792);
                                                                }
                                                                let _e13802 = phi_12975_;
                                                                phi_12946_ = type_14(_e13802.member_1, _e13783.member_1);
                                                                phi_12989_ = type_15(1u, _e13783.member);
                                                            } else {
                                                                phi_12946_ = _e13783;
                                                                phi_12989_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e13808 = phi_12946_;
                                                            let _e13810 = phi_12989_;
                                                            let _e13813 = (bitcast<i32>(_e13810.member) != 0i);
                                                            if _e13813 {
                                                                phi_12949_ = (0.5f * (_e13785 + (_e13775 / _e13785)));
                                                            } else {
                                                                phi_12949_ = f32();
                                                            }
                                                            let _e13818 = phi_12949_;
                                                            continue;
                                                            continuing {
                                                                phi_12945_ = _e13808;
                                                                phi_12948_ = _e13818;
                                                                break if !(_e13813);
                                                            }
                                                        }
                                                        let _e13823 = local_111;
                                                        phi_13002_ = (_e13823 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e13830 = phi_13002_;
                                                    let _e13841 = (((_e13274[0] * _e13274[0]) + (_e13274[1] * _e13274[1])) + (_e13274[2] * _e13274[2]));
                                                    if (_e13841 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e13841 > 0f) {
                                                            phi_13027_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_13027_ = 0f;
                                                        }
                                                        let _e13894 = phi_13027_;
                                                        phi_13091_ = _e13894;
                                                    } else {
                                                        phi_13034_ = type_14(0i, 5i);
                                                        phi_13037_ = bitcast<f32>(((bitcast<u32>(_e13841) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e13849 = phi_13034_;
                                                            let _e13851 = phi_13037_;
                                                            local_112 = _e13851;
                                                            if (_e13849.member < _e13849.member_1) {
                                                                let _e13858 = (_e13849.member + 1i);
                                                                if ((false == (_e13858 > _e13849.member)) != false) {
                                                                    phi_13058_ = true;
                                                                } else {
                                                                    phi_13058_ = false;
                                                                }
                                                                let _e13863 = phi_13058_;
                                                                if _e13863 {
                                                                    phi_13064_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_13064_ = type_15(1u, _e13858);
                                                                }
                                                                let _e13868 = phi_13064_;
                                                                phi_13035_ = type_14(_e13868.member_1, _e13849.member_1);
                                                                phi_13078_ = type_15(1u, _e13849.member);
                                                            } else {
                                                                phi_13035_ = _e13849;
                                                                phi_13078_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e13874 = phi_13035_;
                                                            let _e13876 = phi_13078_;
                                                            let _e13879 = (bitcast<i32>(_e13876.member) != 0i);
                                                            if _e13879 {
                                                                phi_13038_ = (0.5f * (_e13851 + (_e13841 / _e13851)));
                                                            } else {
                                                                phi_13038_ = f32();
                                                            }
                                                            let _e13884 = phi_13038_;
                                                            continue;
                                                            continuing {
                                                                phi_13034_ = _e13874;
                                                                phi_13037_ = _e13884;
                                                                break if !(_e13879);
                                                            }
                                                        }
                                                        let _e13889 = local_112;
                                                        phi_13091_ = (_e13889 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e13896 = phi_13091_;
                                                    let _e13902 = local_18.member[0u];
                                                    if (_e13902[0] < 0f) {
                                                        phi_13107_ = -(_e13902[0]);
                                                    } else {
                                                        phi_13107_ = _e13902[0];
                                                    }
                                                    let _e13909 = phi_13107_;
                                                    if (_e13902[1] < 0f) {
                                                        phi_13114_ = -(_e13902[1]);
                                                    } else {
                                                        phi_13114_ = _e13902[1];
                                                    }
                                                    let _e13913 = phi_13114_;
                                                    if (_e13909 > _e13913) {
                                                        phi_13119_ = _e13909;
                                                    } else {
                                                        phi_13119_ = _e13913;
                                                    }
                                                    let _e13916 = phi_13119_;
                                                    if (_e13902[2] < 0f) {
                                                        phi_13126_ = -(_e13902[2]);
                                                    } else {
                                                        phi_13126_ = _e13902[2];
                                                    }
                                                    let _e13920 = phi_13126_;
                                                    if (_e13916 > _e13920) {
                                                        phi_13131_ = _e13916;
                                                    } else {
                                                        phi_13131_ = _e13920;
                                                    }
                                                    let _e13923 = phi_13131_;
                                                    let _e13926 = local_18.member[1u];
                                                    if (_e13926[0] < 0f) {
                                                        phi_13144_ = -(_e13926[0]);
                                                    } else {
                                                        phi_13144_ = _e13926[0];
                                                    }
                                                    let _e13933 = phi_13144_;
                                                    if (_e13926[1] < 0f) {
                                                        phi_13151_ = -(_e13926[1]);
                                                    } else {
                                                        phi_13151_ = _e13926[1];
                                                    }
                                                    let _e13937 = phi_13151_;
                                                    if (_e13933 > _e13937) {
                                                        phi_13156_ = _e13933;
                                                    } else {
                                                        phi_13156_ = _e13937;
                                                    }
                                                    let _e13940 = phi_13156_;
                                                    if (_e13926[2] < 0f) {
                                                        phi_13163_ = -(_e13926[2]);
                                                    } else {
                                                        phi_13163_ = _e13926[2];
                                                    }
                                                    let _e13944 = phi_13163_;
                                                    if (_e13940 > _e13944) {
                                                        phi_13168_ = _e13940;
                                                    } else {
                                                        phi_13168_ = _e13944;
                                                    }
                                                    let _e13947 = phi_13168_;
                                                    if (_e13923 > _e13947) {
                                                        phi_13173_ = _e13923;
                                                    } else {
                                                        phi_13173_ = _e13947;
                                                    }
                                                    let _e13950 = phi_13173_;
                                                    let _e13952 = local_18.member_3;
                                                    let _e13956 = local_18.member_1[0u];
                                                    if (_e13956[0] < 0f) {
                                                        phi_13190_ = -(_e13956[0]);
                                                    } else {
                                                        phi_13190_ = _e13956[0];
                                                    }
                                                    let _e13963 = phi_13190_;
                                                    if (_e13956[1] < 0f) {
                                                        phi_13197_ = -(_e13956[1]);
                                                    } else {
                                                        phi_13197_ = _e13956[1];
                                                    }
                                                    let _e13967 = phi_13197_;
                                                    if (_e13963 > _e13967) {
                                                        phi_13202_ = _e13963;
                                                    } else {
                                                        phi_13202_ = _e13967;
                                                    }
                                                    let _e13970 = phi_13202_;
                                                    if (_e13956[2] < 0f) {
                                                        phi_13209_ = -(_e13956[2]);
                                                    } else {
                                                        phi_13209_ = _e13956[2];
                                                    }
                                                    let _e13974 = phi_13209_;
                                                    if (_e13970 > _e13974) {
                                                        phi_13214_ = _e13970;
                                                    } else {
                                                        phi_13214_ = _e13974;
                                                    }
                                                    let _e13977 = phi_13214_;
                                                    let _e13980 = local_18.member_1[1u];
                                                    if (_e13980[0] < 0f) {
                                                        phi_13228_ = -(_e13980[0]);
                                                    } else {
                                                        phi_13228_ = _e13980[0];
                                                    }
                                                    let _e13987 = phi_13228_;
                                                    if (_e13980[1] < 0f) {
                                                        phi_13235_ = -(_e13980[1]);
                                                    } else {
                                                        phi_13235_ = _e13980[1];
                                                    }
                                                    let _e13991 = phi_13235_;
                                                    if (_e13987 > _e13991) {
                                                        phi_13240_ = _e13987;
                                                    } else {
                                                        phi_13240_ = _e13991;
                                                    }
                                                    let _e13994 = phi_13240_;
                                                    if (_e13980[2] < 0f) {
                                                        phi_13247_ = -(_e13980[2]);
                                                    } else {
                                                        phi_13247_ = _e13980[2];
                                                    }
                                                    let _e13998 = phi_13247_;
                                                    if (_e13994 > _e13998) {
                                                        phi_13252_ = _e13994;
                                                    } else {
                                                        phi_13252_ = _e13998;
                                                    }
                                                    let _e14001 = phi_13252_;
                                                    if (_e13977 > _e14001) {
                                                        phi_13257_ = _e13977;
                                                    } else {
                                                        phi_13257_ = _e14001;
                                                    }
                                                    let _e14004 = phi_13257_;
                                                    let _e14006 = local_18.member_3;
                                                    let _e14010 = local_18.member_2[0u];
                                                    if (_e14010[0] < 0f) {
                                                        phi_13274_ = -(_e14010[0]);
                                                    } else {
                                                        phi_13274_ = _e14010[0];
                                                    }
                                                    let _e14017 = phi_13274_;
                                                    if (_e14010[1] < 0f) {
                                                        phi_13281_ = -(_e14010[1]);
                                                    } else {
                                                        phi_13281_ = _e14010[1];
                                                    }
                                                    let _e14021 = phi_13281_;
                                                    if (_e14017 > _e14021) {
                                                        phi_13286_ = _e14017;
                                                    } else {
                                                        phi_13286_ = _e14021;
                                                    }
                                                    let _e14024 = phi_13286_;
                                                    if (_e14010[2] < 0f) {
                                                        phi_13293_ = -(_e14010[2]);
                                                    } else {
                                                        phi_13293_ = _e14010[2];
                                                    }
                                                    let _e14028 = phi_13293_;
                                                    if (_e14024 > _e14028) {
                                                        phi_13298_ = _e14024;
                                                    } else {
                                                        phi_13298_ = _e14028;
                                                    }
                                                    let _e14031 = phi_13298_;
                                                    let _e14034 = local_18.member_2[1u];
                                                    if (_e14034[0] < 0f) {
                                                        phi_13312_ = -(_e14034[0]);
                                                    } else {
                                                        phi_13312_ = _e14034[0];
                                                    }
                                                    let _e14041 = phi_13312_;
                                                    if (_e14034[1] < 0f) {
                                                        phi_13319_ = -(_e14034[1]);
                                                    } else {
                                                        phi_13319_ = _e14034[1];
                                                    }
                                                    let _e14045 = phi_13319_;
                                                    if (_e14041 > _e14045) {
                                                        phi_13324_ = _e14041;
                                                    } else {
                                                        phi_13324_ = _e14045;
                                                    }
                                                    let _e14048 = phi_13324_;
                                                    if (_e14034[2] < 0f) {
                                                        phi_13331_ = -(_e14034[2]);
                                                    } else {
                                                        phi_13331_ = _e14034[2];
                                                    }
                                                    let _e14052 = phi_13331_;
                                                    if (_e14048 > _e14052) {
                                                        phi_13336_ = _e14048;
                                                    } else {
                                                        phi_13336_ = _e14052;
                                                    }
                                                    let _e14055 = phi_13336_;
                                                    if (_e14031 > _e14055) {
                                                        phi_13341_ = _e14031;
                                                    } else {
                                                        phi_13341_ = _e14055;
                                                    }
                                                    let _e14058 = phi_13341_;
                                                    let _e14060 = local_18.member_3;
                                                    let _e14067 = local_18.member_3;
                                                    let _e14077 = ((((_e13896 * (1f + (0.000000059604645f * 8f))) + (((((((_e13950 + _e13952) + (_e14004 + _e14006)) + (_e14058 + _e14060)) * (0.000000059604645f * 16f)) + (_e14067 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) * _e13830) * (1f + (0.000000059604645f * 64f)));
                                                    let _e14080 = local_15.member[0u];
                                                    let _e14083 = local_15.member_1[0u];
                                                    if (_e14080 < 0f) {
                                                        phi_13382_ = -(_e14080);
                                                    } else {
                                                        phi_13382_ = _e14080;
                                                    }
                                                    let _e14088 = phi_13382_;
                                                    if (_e14083 < 0f) {
                                                        phi_13388_ = -(_e14083);
                                                    } else {
                                                        phi_13388_ = _e14083;
                                                    }
                                                    let _e14092 = phi_13388_;
                                                    phi_13399_ = type_9(1u, 4u);
                                                    phi_13402_ = ((_e14080 + ((_e14083 - _e14080) * _e11399)) - ((_e13545 * 1.01f) + ((_e14088 + _e14092) * (0.000000059604645f * 12f))));
                                                    loop {
                                                        let _e14102 = phi_13399_;
                                                        let _e14104 = phi_13402_;
                                                        local_113 = _e14104;
                                                        local_114 = _e14104;
                                                        if (_e14102.member < _e14102.member_1) {
                                                            phi_13400_ = type_9((_e14102.member + 1u), _e14102.member_1);
                                                            phi_13425_ = type_9(1u, _e14102.member);
                                                        } else {
                                                            phi_13400_ = _e14102;
                                                            phi_13425_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e14116 = phi_13400_;
                                                        let _e14118 = phi_13425_;
                                                        let _e14122 = (bitcast<i32>(_e14118.member) != 0i);
                                                        if _e14122 {
                                                            let _e14125 = local_15.member[_e14118.member_1];
                                                            let _e14128 = local_15.member_1[_e14118.member_1];
                                                            if (_e14125 < 0f) {
                                                                phi_13454_ = -(_e14125);
                                                            } else {
                                                                phi_13454_ = _e14125;
                                                            }
                                                            let _e14133 = phi_13454_;
                                                            if (_e14128 < 0f) {
                                                                phi_13460_ = -(_e14128);
                                                            } else {
                                                                phi_13460_ = _e14128;
                                                            }
                                                            let _e14137 = phi_13460_;
                                                            let _e14145 = ((_e14125 + ((_e14128 - _e14125) * _e11399)) - ((_e13545 * 1.01f) + ((_e14133 + _e14137) * (0.000000059604645f * 12f))));
                                                            if (_e14104 < _e14145) {
                                                                phi_13473_ = _e14104;
                                                            } else {
                                                                phi_13473_ = _e14145;
                                                            }
                                                            let _e14148 = phi_13473_;
                                                            phi_13403_ = _e14148;
                                                        } else {
                                                            phi_13403_ = f32();
                                                        }
                                                        let _e14150 = phi_13403_;
                                                        continue;
                                                        continuing {
                                                            phi_13399_ = _e14116;
                                                            phi_13402_ = _e14150;
                                                            break if !(_e14122);
                                                        }
                                                    }
                                                    let _e14153 = local_113;
                                                    if (_e14153 > 0f) {
                                                        let _e14157 = local_114;
                                                        let _e14160 = (((_e14077 - _e14157) / _e14077) * 2.02f);
                                                        if (_e14160 <= 0.000000000000000000000000000000000000011754944f) {
                                                            if (_e14160 > 0f) {
                                                                phi_13494_ = (0.000000000000000000106433627f * 2f);
                                                            } else {
                                                                phi_13494_ = 0f;
                                                            }
                                                            let _e14213 = phi_13494_;
                                                            phi_13558_ = _e14213;
                                                        } else {
                                                            phi_13501_ = type_14(0i, 5i);
                                                            phi_13504_ = bitcast<f32>(((bitcast<u32>(_e14160) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e14168 = phi_13501_;
                                                                let _e14170 = phi_13504_;
                                                                local_115 = _e14170;
                                                                if (_e14168.member < _e14168.member_1) {
                                                                    let _e14177 = (_e14168.member + 1i);
                                                                    if ((false == (_e14177 > _e14168.member)) != false) {
                                                                        phi_13525_ = true;
                                                                    } else {
                                                                        phi_13525_ = false;
                                                                    }
                                                                    let _e14182 = phi_13525_;
                                                                    if _e14182 {
                                                                        phi_13531_ = type_15(0u, type_15().member_1);
                                                                    } else {
                                                                        phi_13531_ = type_15(1u, _e14177);
                                                                    }
                                                                    let _e14187 = phi_13531_;
                                                                    phi_13502_ = type_14(_e14187.member_1, _e14168.member_1);
                                                                    phi_13545_ = type_15(1u, _e14168.member);
                                                                } else {
                                                                    phi_13502_ = _e14168;
                                                                    phi_13545_ = type_15(0u, type_15().member_1);
                                                                }
                                                                let _e14193 = phi_13502_;
                                                                let _e14195 = phi_13545_;
                                                                let _e14198 = (bitcast<i32>(_e14195.member) != 0i);
                                                                if _e14198 {
                                                                    phi_13505_ = (0.5f * (_e14170 + (_e14160 / _e14170)));
                                                                } else {
                                                                    phi_13505_ = f32();
                                                                }
                                                                let _e14203 = phi_13505_;
                                                                continue;
                                                                continuing {
                                                                    phi_13501_ = _e14193;
                                                                    phi_13504_ = _e14203;
                                                                    break if !(_e14198);
                                                                }
                                                            }
                                                            let _e14208 = local_115;
                                                            phi_13558_ = (_e14208 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e14215 = phi_13558_;
                                                        let _e14217 = ((_e14215 * _e13830) * 1.01f);
                                                        phi_13563_ = type_9(0u, 4u);
                                                        phi_13566_ = 2f;
                                                        phi_13568_ = true;
                                                        phi_13570_ = true;
                                                        loop {
                                                            let _e14219 = phi_13563_;
                                                            let _e14221 = phi_13566_;
                                                            let _e14223 = phi_13568_;
                                                            let _e14225 = phi_13570_;
                                                            local_116 = _e14221;
                                                            local_158 = _e14221;
                                                            local_117 = _e14223;
                                                            local_118 = _e14225;
                                                            local_159 = _e14225;
                                                            local_119 = _e14225;
                                                            if (_e14219.member < _e14219.member_1) {
                                                                phi_13564_ = type_9((_e14219.member + 1u), _e14219.member_1);
                                                                phi_13593_ = type_9(1u, _e14219.member);
                                                            } else {
                                                                phi_13564_ = _e14219;
                                                                phi_13593_ = type_9(0u, type_9().member_1);
                                                            }
                                                            let _e14237 = phi_13564_;
                                                            let _e14239 = phi_13593_;
                                                            let _e14243 = (bitcast<i32>(_e14239.member) != 0i);
                                                            if _e14243 {
                                                                let _e14247 = local_14.member[0u][_e14239.member_1];
                                                                let _e14254 = local_14.member[1u][_e14239.member_1];
                                                                if (_e14247[0] < 0f) {
                                                                    phi_13630_ = -(_e14247[0]);
                                                                } else {
                                                                    phi_13630_ = _e14247[0];
                                                                }
                                                                let _e14261 = phi_13630_;
                                                                if (_e14247[1] < 0f) {
                                                                    phi_13637_ = -(_e14247[1]);
                                                                } else {
                                                                    phi_13637_ = _e14247[1];
                                                                }
                                                                let _e14265 = phi_13637_;
                                                                if (_e14247[2] < 0f) {
                                                                    phi_13645_ = -(_e14247[2]);
                                                                } else {
                                                                    phi_13645_ = _e14247[2];
                                                                }
                                                                let _e14270 = phi_13645_;
                                                                let _e14271 = ((_e14261 + _e14265) + _e14270);
                                                                if (_e14254[0] < 0f) {
                                                                    phi_13653_ = -(_e14254[0]);
                                                                } else {
                                                                    phi_13653_ = _e14254[0];
                                                                }
                                                                let _e14275 = phi_13653_;
                                                                if (_e14254[1] < 0f) {
                                                                    phi_13660_ = -(_e14254[1]);
                                                                } else {
                                                                    phi_13660_ = _e14254[1];
                                                                }
                                                                let _e14279 = phi_13660_;
                                                                if (_e14254[2] < 0f) {
                                                                    phi_13668_ = -(_e14254[2]);
                                                                } else {
                                                                    phi_13668_ = _e14254[2];
                                                                }
                                                                let _e14284 = phi_13668_;
                                                                let _e14285 = ((_e14275 + _e14279) + _e14284);
                                                                if (_e14271 > _e14285) {
                                                                    phi_13674_ = _e14271;
                                                                } else {
                                                                    phi_13674_ = _e14285;
                                                                }
                                                                let _e14288 = phi_13674_;
                                                                let _e14292 = (_e14254[0] - _e14247[0]);
                                                                let _e14293 = (_e14254[1] - _e14247[1]);
                                                                let _e14294 = (_e14254[2] - _e14247[2]);
                                                                if (_e14292 < 0f) {
                                                                    phi_13692_ = -(_e14292);
                                                                } else {
                                                                    phi_13692_ = _e14292;
                                                                }
                                                                let _e14298 = phi_13692_;
                                                                if (_e14293 < 0f) {
                                                                    phi_13698_ = -(_e14293);
                                                                } else {
                                                                    phi_13698_ = _e14293;
                                                                }
                                                                let _e14302 = phi_13698_;
                                                                if (_e14294 < 0f) {
                                                                    phi_13705_ = -(_e14294);
                                                                } else {
                                                                    phi_13705_ = _e14294;
                                                                }
                                                                let _e14307 = phi_13705_;
                                                                let _e14314 = local_15.member[_e14239.member_1];
                                                                let _e14317 = local_15.member_1[_e14239.member_1];
                                                                if (_e14314 < 0f) {
                                                                    phi_13731_ = -(_e14314);
                                                                } else {
                                                                    phi_13731_ = _e14314;
                                                                }
                                                                let _e14322 = phi_13731_;
                                                                if (_e14317 < 0f) {
                                                                    phi_13737_ = -(_e14317);
                                                                } else {
                                                                    phi_13737_ = _e14317;
                                                                }
                                                                let _e14326 = phi_13737_;
                                                                let _e14330 = ((_e13545 * 1.01f) + ((_e14322 + _e14326) * (0.000000059604645f * 12f)));
                                                                let _e14337 = local_15.member_1[_e14239.member_1];
                                                                let _e14340 = local_15.member[_e14239.member_1];
                                                                let _e14341 = (_e14337 - _e14340);
                                                                let _e14344 = ((_e14330 + _e14330) + (_e14217 * ((((_e14298 + _e14302) + _e14307) + (_e13545 * 6f)) * 1.01f)));
                                                                let _e14347 = ((((_e14314 + ((_e14317 - _e14314) * _e11399)) - _e14330) - (_e14217 * ((_e14288 + (_e13545 * 3f)) * 1.01f))) - _e14077);
                                                                let _e14348 = (_e14347 > 0.000000000000000000000000000000000000011754944f);
                                                                let _e14349 = (_e14341 > _e14344);
                                                                if _e14349 {
                                                                    phi_13773_ = true;
                                                                } else {
                                                                    phi_13773_ = _e14348;
                                                                }
                                                                let _e14351 = phi_13773_;
                                                                if (_e14341 < -(_e14344)) {
                                                                    phi_13780_ = true;
                                                                } else {
                                                                    phi_13780_ = _e14348;
                                                                }
                                                                let _e14356 = phi_13780_;
                                                                if _e14349 {
                                                                    phi_13801_ = _e14221;
                                                                } else {
                                                                    if _e14348 {
                                                                        let _e14358 = (_e14344 - _e14341);
                                                                        if (_e14358 > 0.000000000000000000000000000000000000011754944f) {
                                                                            phi_13793_ = _e14358;
                                                                        } else {
                                                                            phi_13793_ = 0.000000000000000000000000000000000000011754944f;
                                                                        }
                                                                        let _e14361 = phi_13793_;
                                                                        let _e14362 = (_e14347 / _e14361);
                                                                        if (_e14221 < _e14362) {
                                                                            phi_13799_ = _e14221;
                                                                        } else {
                                                                            phi_13799_ = _e14362;
                                                                        }
                                                                        let _e14365 = phi_13799_;
                                                                        phi_13800_ = _e14365;
                                                                    } else {
                                                                        phi_13800_ = _e14221;
                                                                    }
                                                                    let _e14367 = phi_13800_;
                                                                    phi_13801_ = _e14367;
                                                                }
                                                                let _e14369 = phi_13801_;
                                                                phi_13567_ = _e14369;
                                                                phi_13569_ = (_e14223 && _e14356);
                                                                phi_13571_ = (_e14225 && _e14351);
                                                            } else {
                                                                phi_13567_ = f32();
                                                                phi_13569_ = bool();
                                                                phi_13571_ = bool();
                                                            }
                                                            let _e14371 = phi_13567_;
                                                            let _e14373 = phi_13569_;
                                                            let _e14375 = phi_13571_;
                                                            continue;
                                                            continuing {
                                                                phi_13563_ = _e14237;
                                                                phi_13566_ = _e14371;
                                                                phi_13568_ = _e14373;
                                                                phi_13570_ = _e14375;
                                                                break if !(_e14243);
                                                            }
                                                        }
                                                        let _e14378 = local_116;
                                                        if (_e14378 < 2f) {
                                                            let _e17316 = local_158;
                                                            phi_13806_ = _e17316;
                                                        } else {
                                                            phi_13806_ = 2f;
                                                        }
                                                        let _e14381 = phi_13806_;
                                                        let _e14382 = (_e14381 * 0.999f);
                                                        let _e14384 = local_117;
                                                        if _e14384 {
                                                            let _e14386 = local_118;
                                                            if _e14386 {
                                                                phi_13815_ = type_46();
                                                            } else {
                                                                phi_13815_ = type_46(1u, _e11399, 2f);
                                                            }
                                                            let _e14389 = phi_13815_;
                                                            phi_13816_ = _e14389;
                                                            let _e17323 = local_159;
                                                            phi_13817_ = _e17323;
                                                        } else {
                                                            phi_13816_ = type_46();
                                                            phi_13817_ = true;
                                                        }
                                                        let _e14391 = phi_13816_;
                                                        let _e14393 = phi_13817_;
                                                        if _e14393 {
                                                            let _e14395 = local_119;
                                                            if _e14395 {
                                                                if (_e14382 > (0.000000059604645f * 4096f)) {
                                                                    let _e14399 = (_e11399 + _e14382);
                                                                    if (_e14399 < _e5607) {
                                                                        phi_13834_ = _e14399;
                                                                    } else {
                                                                        phi_13834_ = _e5607;
                                                                    }
                                                                    let _e14402 = phi_13834_;
                                                                    phi_13835_ = _e14402;
                                                                } else {
                                                                    phi_13835_ = _e11399;
                                                                }
                                                                let _e14404 = phi_13835_;
                                                                phi_13838_ = type_9(0u, 4u);
                                                                phi_13841_ = _e14404;
                                                                phi_13843_ = _e11399;
                                                                loop {
                                                                    let _e14406 = phi_13838_;
                                                                    let _e14408 = phi_13841_;
                                                                    let _e14410 = phi_13843_;
                                                                    local_120 = _e14408;
                                                                    local_121 = _e14410;
                                                                    local_122 = _e14410;
                                                                    if (_e14406.member < _e14406.member_1) {
                                                                        phi_13839_ = type_9((_e14406.member + 1u), _e14406.member_1);
                                                                        phi_13866_ = type_9(1u, _e14406.member);
                                                                    } else {
                                                                        phi_13839_ = _e14406;
                                                                        phi_13866_ = type_9(0u, type_9().member_1);
                                                                    }
                                                                    let _e14422 = phi_13839_;
                                                                    let _e14424 = phi_13866_;
                                                                    let _e14428 = (bitcast<i32>(_e14424.member) != 0i);
                                                                    if _e14428 {
                                                                        let _e14431 = local_15.member[_e14424.member_1];
                                                                        let _e14434 = local_15.member_1[_e14424.member_1];
                                                                        let _e14437 = local_15.member[_e14424.member_1];
                                                                        let _e14443 = local_15.member_2[_e14424.member_1];
                                                                        let _e14444 = ((_e14431 + ((_e14434 - _e14437) * _e11399)) - _e14443);
                                                                        let _e14447 = local_15.member_1[_e14424.member_1];
                                                                        let _e14450 = local_15.member[_e14424.member_1];
                                                                        let _e14451 = (_e14447 - _e14450);
                                                                        if (_e14451 > 0f) {
                                                                            let _e14465 = (_e11399 - (_e14444 / _e14451));
                                                                            if (_e14410 > _e14465) {
                                                                                phi_13934_ = _e14410;
                                                                            } else {
                                                                                phi_13934_ = _e14465;
                                                                            }
                                                                            let _e14468 = phi_13934_;
                                                                            phi_13952_ = _e14408;
                                                                            phi_13953_ = _e14468;
                                                                        } else {
                                                                            if (_e14444 > 0f) {
                                                                                if (_e14451 < 0f) {
                                                                                    let _e14456 = (_e11399 - (_e14444 / _e14451));
                                                                                    if (_e14408 < _e14456) {
                                                                                        phi_13949_ = _e14408;
                                                                                    } else {
                                                                                        phi_13949_ = _e14456;
                                                                                    }
                                                                                    let _e14459 = phi_13949_;
                                                                                    phi_13950_ = _e14459;
                                                                                } else {
                                                                                    phi_13950_ = _e14408;
                                                                                }
                                                                                let _e14461 = phi_13950_;
                                                                                phi_13951_ = _e14461;
                                                                            } else {
                                                                                phi_13951_ = _e14408;
                                                                            }
                                                                            let _e14463 = phi_13951_;
                                                                            phi_13952_ = _e14463;
                                                                            phi_13953_ = _e14410;
                                                                        }
                                                                        let _e14470 = phi_13952_;
                                                                        let _e14472 = phi_13953_;
                                                                        phi_13842_ = _e14470;
                                                                        phi_13844_ = _e14472;
                                                                    } else {
                                                                        phi_13842_ = f32();
                                                                        phi_13844_ = f32();
                                                                    }
                                                                    let _e14474 = phi_13842_;
                                                                    let _e14476 = phi_13844_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_13838_ = _e14422;
                                                                        phi_13841_ = _e14474;
                                                                        phi_13843_ = _e14476;
                                                                        break if !(_e14428);
                                                                    }
                                                                }
                                                                let _e14479 = local_120;
                                                                let _e14481 = local_121;
                                                                let _e14485 = local_122;
                                                                let _e14486 = (_e14485 + ((_e14479 - _e14481) * 0.5f));
                                                                if (_e14486 > _e11399) {
                                                                    if (_e14486 <= _e14404) {
                                                                        let _e14491 = local_15.member[0u];
                                                                        let _e14494 = local_15.member_1[0u];
                                                                        let _e14497 = local_15.member[0u];
                                                                        let _e14503 = local_15.member_2[0u];
                                                                        if (((_e14491 + ((_e14494 - _e14497) * _e14486)) - _e14503) > 0f) {
                                                                            let _e14508 = local_15.member[1u];
                                                                            let _e14511 = local_15.member_1[1u];
                                                                            let _e14514 = local_15.member[1u];
                                                                            let _e14520 = local_15.member_2[1u];
                                                                            if (((_e14508 + ((_e14511 - _e14514) * _e14486)) - _e14520) > 0f) {
                                                                                let _e14525 = local_15.member[2u];
                                                                                let _e14528 = local_15.member_1[2u];
                                                                                let _e14531 = local_15.member[2u];
                                                                                let _e14537 = local_15.member_2[2u];
                                                                                if (((_e14525 + ((_e14528 - _e14531) * _e14486)) - _e14537) > 0f) {
                                                                                    let _e14542 = local_15.member[3u];
                                                                                    let _e14545 = local_15.member_1[3u];
                                                                                    let _e14548 = local_15.member[3u];
                                                                                    let _e14554 = local_15.member_2[3u];
                                                                                    phi_14114_ = (((_e14542 + ((_e14545 - _e14548) * _e14486)) - _e14554) > 0f);
                                                                                    phi_14115_ = false;
                                                                                } else {
                                                                                    phi_14114_ = bool();
                                                                                    phi_14115_ = true;
                                                                                }
                                                                                let _e14558 = phi_14114_;
                                                                                let _e14560 = phi_14115_;
                                                                                phi_14116_ = _e14558;
                                                                                phi_14117_ = _e14560;
                                                                            } else {
                                                                                phi_14116_ = bool();
                                                                                phi_14117_ = true;
                                                                            }
                                                                            let _e14562 = phi_14116_;
                                                                            let _e14564 = phi_14117_;
                                                                            phi_14118_ = _e14562;
                                                                            phi_14119_ = _e14564;
                                                                        } else {
                                                                            phi_14118_ = bool();
                                                                            phi_14119_ = true;
                                                                        }
                                                                        let _e14566 = phi_14118_;
                                                                        let _e14568 = phi_14119_;
                                                                        if _e14568 {
                                                                            phi_14123_ = false;
                                                                        } else {
                                                                            phi_14123_ = _e14566;
                                                                        }
                                                                        let _e14570 = phi_14123_;
                                                                        if _e14570 {
                                                                            phi_14127_ = false;
                                                                        } else {
                                                                            phi_14127_ = true;
                                                                        }
                                                                        let _e14572 = phi_14127_;
                                                                        phi_14128_ = _e14572;
                                                                    } else {
                                                                        phi_14128_ = true;
                                                                    }
                                                                    let _e14574 = phi_14128_;
                                                                    phi_14129_ = _e14574;
                                                                } else {
                                                                    phi_14129_ = true;
                                                                }
                                                                let _e14576 = phi_14129_;
                                                                if _e14576 {
                                                                    phi_14133_ = 2f;
                                                                } else {
                                                                    phi_14133_ = _e14486;
                                                                }
                                                                let _e14578 = phi_14133_;
                                                                phi_14136_ = type_46(2u, _e14404, _e14578);
                                                                phi_14137_ = type_46();
                                                                phi_14138_ = false;
                                                            } else {
                                                                phi_14136_ = type_46();
                                                                phi_14137_ = type_46(0u, _e11399, 2f);
                                                                phi_14138_ = true;
                                                            }
                                                            let _e14581 = phi_14136_;
                                                            let _e14583 = phi_14137_;
                                                            let _e14585 = phi_14138_;
                                                            phi_14139_ = _e14581;
                                                            phi_14140_ = _e14583;
                                                            phi_14141_ = _e14585;
                                                        } else {
                                                            phi_14139_ = type_46();
                                                            phi_14140_ = _e14391;
                                                            phi_14141_ = true;
                                                        }
                                                        let _e14587 = phi_14139_;
                                                        let _e14589 = phi_14140_;
                                                        let _e14591 = phi_14141_;
                                                        phi_14146_ = _e14589;
                                                        phi_14147_ = _e14587;
                                                        phi_14148_ = _e14591;
                                                    } else {
                                                        phi_14146_ = type_46(0u, _e11399, 2f);
                                                        phi_14147_ = type_46();
                                                        phi_14148_ = true;
                                                    }
                                                    let _e14593 = phi_14146_;
                                                    let _e14595 = phi_14147_;
                                                    let _e14597 = phi_14148_;
                                                    phi_14152_ = _e14593;
                                                    phi_14153_ = _e14595;
                                                    phi_14154_ = false;
                                                    phi_14155_ = _e14597;
                                                } else {
                                                    phi_14152_ = type_46();
                                                    phi_14153_ = type_46();
                                                    phi_14154_ = true;
                                                    phi_14155_ = false;
                                                }
                                                let _e14599 = phi_14152_;
                                                let _e14601 = phi_14153_;
                                                let _e14603 = phi_14154_;
                                                let _e14605 = phi_14155_;
                                                phi_14156_ = _e14599;
                                                phi_14157_ = _e14601;
                                                phi_14158_ = _e14603;
                                                phi_14159_ = _e14605;
                                            } else {
                                                phi_14156_ = type_46();
                                                phi_14157_ = type_46();
                                                phi_14158_ = true;
                                                phi_14159_ = false;
                                            }
                                            let _e14607 = phi_14156_;
                                            let _e14609 = phi_14157_;
                                            let _e14611 = phi_14158_;
                                            let _e14613 = phi_14159_;
                                            if _e14611 {
                                                phi_14164_ = type_46(0u, _e11399, 2f);
                                                phi_14165_ = true;
                                            } else {
                                                phi_14164_ = _e14607;
                                                phi_14165_ = _e14613;
                                            }
                                            let _e14616 = phi_14164_;
                                            let _e14618 = phi_14165_;
                                            if _e14618 {
                                                phi_14169_ = _e14616;
                                            } else {
                                                phi_14169_ = _e14609;
                                            }
                                            let _e14620 = phi_14169_;
                                            if _e5613 {
                                                if (_e14620.member == 2u) {
                                                    let _e14624 = (_e14620.member_2 <= _e5607);
                                                    if _e14624 {
                                                        phi_14185_ = _e14620.member_2;
                                                        phi_14186_ = _e14620.member_2;
                                                        phi_14187_ = false;
                                                    } else {
                                                        phi_14185_ = f32();
                                                        phi_14186_ = f32();
                                                        phi_14187_ = true;
                                                    }
                                                    let _e14628 = phi_14185_;
                                                    let _e14630 = phi_14186_;
                                                    let _e14632 = phi_14187_;
                                                    phi_14188_ = _e14628;
                                                    phi_14189_ = _e14630;
                                                    phi_14190_ = _e14624;
                                                    phi_14191_ = _e14632;
                                                    phi_14192_ = false;
                                                } else {
                                                    phi_14188_ = f32();
                                                    phi_14189_ = f32();
                                                    phi_14190_ = false;
                                                    phi_14191_ = false;
                                                    phi_14192_ = true;
                                                }
                                                let _e14634 = phi_14188_;
                                                let _e14636 = phi_14189_;
                                                let _e14638 = phi_14190_;
                                                let _e14640 = phi_14191_;
                                                let _e14642 = phi_14192_;
                                                phi_14193_ = _e14634;
                                                phi_14194_ = _e14636;
                                                phi_14195_ = _e14638;
                                                phi_14196_ = _e14640;
                                                phi_14197_ = _e14642;
                                            } else {
                                                phi_14193_ = f32();
                                                phi_14194_ = f32();
                                                phi_14195_ = false;
                                                phi_14196_ = false;
                                                phi_14197_ = true;
                                            }
                                            let _e14644 = phi_14193_;
                                            let _e14646 = phi_14194_;
                                            let _e14648 = phi_14195_;
                                            let _e14650 = phi_14196_;
                                            let _e14652 = phi_14197_;
                                            phi_14198_ = _e14644;
                                            phi_14199_ = _e14620.member;
                                            phi_14200_ = _e14646;
                                            phi_14201_ = _e14620;
                                            phi_14202_ = _e14620.member;
                                            phi_14203_ = _e14620.member;
                                            phi_14204_ = _e14648;
                                            phi_14205_ = _e14650;
                                            phi_14206_ = _e14652;
                                        }
                                        let _e14654 = phi_14198_;
                                        let _e14656 = phi_14199_;
                                        let _e14658 = phi_14200_;
                                        let _e14660 = phi_14201_;
                                        let _e14662 = phi_14202_;
                                        let _e14664 = phi_14203_;
                                        let _e14666 = phi_14204_;
                                        let _e14668 = phi_14205_;
                                        let _e14670 = phi_14206_;
                                        phi_14207_ = _e14654;
                                        phi_14208_ = _e14656;
                                        phi_14209_ = _e14658;
                                        phi_14210_ = _e14660;
                                        phi_14211_ = _e14662;
                                        phi_14212_ = _e14664;
                                        phi_14213_ = _e14666;
                                        phi_14214_ = _e13207;
                                        phi_14215_ = _e14668;
                                        phi_14216_ = _e14670;
                                        phi_14217_ = false;
                                    } else {
                                        phi_14207_ = f32();
                                        phi_14208_ = u32();
                                        phi_14209_ = f32();
                                        phi_14210_ = type_46();
                                        phi_14211_ = u32();
                                        phi_14212_ = u32();
                                        phi_14213_ = false;
                                        phi_14214_ = false;
                                        phi_14215_ = false;
                                        phi_14216_ = false;
                                        phi_14217_ = true;
                                    }
                                    let _e14672 = phi_14207_;
                                    let _e14674 = phi_14208_;
                                    let _e14676 = phi_14209_;
                                    let _e14678 = phi_14210_;
                                    let _e14680 = phi_14211_;
                                    let _e14682 = phi_14212_;
                                    let _e14684 = phi_14213_;
                                    let _e14686 = phi_14214_;
                                    let _e14688 = phi_14215_;
                                    let _e14690 = phi_14216_;
                                    let _e14692 = phi_14217_;
                                    phi_14218_ = _e13204;
                                    phi_9293_ = _e14672;
                                    phi_9295_ = _e14674;
                                    phi_9297_ = _e14676;
                                    phi_14219_ = _e14678;
                                    phi_14220_ = _e14680;
                                    phi_14221_ = _e13204;
                                    phi_14222_ = _e14682;
                                    phi_14223_ = _e14684;
                                    phi_14224_ = _e14686;
                                    phi_14225_ = _e14688;
                                    phi_14226_ = _e14690;
                                    phi_14227_ = false;
                                    phi_14228_ = _e14692;
                                } else {
                                    phi_14218_ = f32();
                                    phi_9293_ = f32();
                                    phi_9295_ = u32();
                                    phi_9297_ = f32();
                                    phi_14219_ = type_46();
                                    phi_14220_ = u32();
                                    phi_14221_ = f32();
                                    phi_14222_ = u32();
                                    phi_14223_ = false;
                                    phi_14224_ = false;
                                    phi_14225_ = false;
                                    phi_14226_ = false;
                                    phi_14227_ = true;
                                    phi_14228_ = false;
                                }
                                let _e14694 = phi_14218_;
                                let _e14696 = phi_9293_;
                                let _e14698 = phi_9295_;
                                let _e14700 = phi_9297_;
                                let _e14702 = phi_14219_;
                                let _e14704 = phi_14220_;
                                let _e14706 = phi_14221_;
                                let _e14708 = phi_14222_;
                                let _e14710 = phi_14223_;
                                let _e14712 = phi_14224_;
                                let _e14714 = phi_14225_;
                                let _e14716 = phi_14226_;
                                let _e14718 = phi_14227_;
                                let _e14720 = phi_14228_;
                                local_123 = _e14712;
                                local_160 = _e14714;
                                local_161 = _e14716;
                                local_162 = _e14718;
                                local_163 = _e14720;
                                local_124 = _e14702;
                                local_125 = _e14702;
                                local_164 = _e14704;
                                local_126 = _e14702;
                                local_165 = _e14712;
                                local_166 = _e14708;
                                local_168 = _e14706;
                                local_169 = _e14694;
                                continue;
                                continuing {
                                    phi_9289_ = _e11422;
                                    phi_9292_ = _e14696;
                                    phi_9294_ = _e14698;
                                    phi_9296_ = _e14700;
                                    break if !(_e14710);
                                }
                            }
                            let _e14723 = local_123;
                            if _e14723 {
                                phi_14232_ = false;
                                phi_14233_ = false;
                                phi_14234_ = false;
                                phi_14235_ = false;
                            } else {
                                let _e17424 = local_160;
                                phi_14232_ = _e17424;
                                let _e17427 = local_161;
                                phi_14233_ = _e17427;
                                let _e17430 = local_162;
                                phi_14234_ = _e17430;
                                let _e17433 = local_163;
                                phi_14235_ = _e17433;
                            }
                            let _e14725 = phi_14232_;
                            let _e14727 = phi_14233_;
                            let _e14729 = phi_14234_;
                            let _e14731 = phi_14235_;
                            if _e14725 {
                                let _e14733 = local_124;
                                if (_e14733.member_1 >= _e5607) {
                                    phi_14257_ = type_45(type_44(0u, f32()), 0u);
                                } else {
                                    let _e14737 = local_125;
                                    if (_e14737.member_1 > _e5605) {
                                        phi_14252_ = 0u;
                                    } else {
                                        let _e17438 = local_164;
                                        phi_14252_ = _e17438;
                                    }
                                    let _e14741 = phi_14252_;
                                    let _e14743 = local_126;
                                    phi_14257_ = type_45(type_44(2u, _e14743.member_1), _e14741);
                                }
                                let _e14750 = phi_14257_;
                                phi_14258_ = _e14750;
                                phi_14259_ = false;
                                phi_14260_ = false;
                                phi_14261_ = false;
                                phi_14262_ = false;
                            } else {
                                phi_14258_ = type_45();
                                phi_14259_ = _e14727;
                                let _e17445 = local_165;
                                phi_14260_ = _e17445;
                                phi_14261_ = _e14729;
                                phi_14262_ = _e14731;
                            }
                            let _e14752 = phi_14258_;
                            let _e14754 = phi_14259_;
                            let _e14756 = phi_14260_;
                            let _e14758 = phi_14261_;
                            let _e14760 = phi_14262_;
                            if _e14754 {
                                let _e17450 = local_166;
                                phi_14266_ = _e17450;
                                let _e17455 = local_168;
                                phi_14267_ = _e17455;
                                phi_14268_ = true;
                                phi_14269_ = false;
                                phi_14270_ = false;
                                phi_14271_ = false;
                            } else {
                                let _e17452 = local_167;
                                phi_14266_ = _e17452;
                                let _e17457 = local_169;
                                phi_14267_ = _e17457;
                                phi_14268_ = _e14756;
                                phi_14269_ = _e14758;
                                phi_14270_ = _e14760;
                                phi_14271_ = _e14725;
                            }
                            let _e14762 = phi_14266_;
                            let _e14764 = phi_14267_;
                            let _e14766 = phi_14268_;
                            let _e14768 = phi_14269_;
                            let _e14770 = phi_14270_;
                            let _e14772 = phi_14271_;
                            if _e14766 {
                                phi_14275_ = _e14764;
                                phi_14276_ = _e14762;
                                phi_14277_ = true;
                                phi_14278_ = false;
                                phi_14279_ = false;
                            } else {
                                let _e17464 = local_170;
                                phi_14275_ = _e17464;
                                let _e17467 = local_171;
                                phi_14276_ = _e17467;
                                phi_14277_ = _e14768;
                                phi_14278_ = _e14770;
                                phi_14279_ = _e14772;
                            }
                            let _e14774 = phi_14275_;
                            let _e14776 = phi_14276_;
                            let _e14778 = phi_14277_;
                            let _e14780 = phi_14278_;
                            let _e14782 = phi_14279_;
                            if _e14778 {
                                local_13[0u] = 0.01f;
                                local_13[1u] = 0f;
                                local_13[2u] = 0.8f;
                                if (_e5603 >= (0.000000059604645f * 8f)) {
                                    phi_14291_ = _e5603;
                                } else {
                                    phi_14291_ = 0f;
                                }
                                let _e14789 = phi_14291_;
                                phi_14294_ = type_9(0u, 3u);
                                loop {
                                    let _e14791 = phi_14294_;
                                    if (_e14791.member < _e14791.member_1) {
                                        phi_14295_ = type_9((_e14791.member + 1u), _e14791.member_1);
                                        phi_14318_ = type_9(1u, _e14791.member);
                                    } else {
                                        phi_14295_ = _e14791;
                                        phi_14318_ = type_9(0u, type_9().member_1);
                                    }
                                    let _e14803 = phi_14295_;
                                    let _e14805 = phi_14318_;
                                    if (bitcast<i32>(_e14805.member) != 0i) {
                                        let _e14811 = local_13[_e14805.member_1];
                                        let _e14813 = (_e14774 + (_e14789 * _e14811));
                                        if (_e14813 < _e5607) {
                                            phi_14339_ = _e14813;
                                        } else {
                                            phi_14339_ = _e5607;
                                        }
                                        let _e14816 = phi_14339_;
                                        let _e14819 = local_18.member[0u];
                                        let _e14825 = local_18.member[1u];
                                        let _e14841 = local_18.member_1[0u];
                                        let _e14847 = local_18.member_1[1u];
                                        let _e14863 = local_18.member_2[0u];
                                        let _e14869 = local_18.member_2[1u];
                                        let _e14883 = function_3(array<f32, 3>((_e14819[0] + ((_e14825[0] - _e14819[0]) * _e14816)), (_e14819[1] + ((_e14825[1] - _e14819[1]) * _e14816)), (_e14819[2] + ((_e14825[2] - _e14819[2]) * _e14816))), array<f32, 3>((_e14841[0] + ((_e14847[0] - _e14841[0]) * _e14816)), (_e14841[1] + ((_e14847[1] - _e14841[1]) * _e14816)), (_e14841[2] + ((_e14847[2] - _e14841[2]) * _e14816))), array<f32, 3>((_e14863[0] + ((_e14869[0] - _e14863[0]) * _e14816)), (_e14863[1] + ((_e14869[1] - _e14863[1]) * _e14816)), (_e14863[2] + ((_e14869[2] - _e14863[2]) * _e14816))), _e316.member);
                                        let _e14894 = (((_e14883[0] * _e14883[0]) + (_e14883[1] * _e14883[1])) + (_e14883[2] * _e14883[2]));
                                        if (_e14894 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e14894 > 0f) {
                                                phi_14462_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_14462_ = 0f;
                                            }
                                            let _e14947 = phi_14462_;
                                            phi_14526_ = _e14947;
                                        } else {
                                            phi_14469_ = type_14(0i, 5i);
                                            phi_14472_ = bitcast<f32>(((bitcast<u32>(_e14894) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e14902 = phi_14469_;
                                                let _e14904 = phi_14472_;
                                                local_127 = _e14904;
                                                if (_e14902.member < _e14902.member_1) {
                                                    let _e14911 = (_e14902.member + 1i);
                                                    if ((false == (_e14911 > _e14902.member)) != false) {
                                                        phi_14493_ = true;
                                                    } else {
                                                        phi_14493_ = false;
                                                    }
                                                    let _e14916 = phi_14493_;
                                                    if _e14916 {
                                                        phi_14499_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_14499_ = type_15(1u, _e14911);
                                                    }
                                                    let _e14921 = phi_14499_;
                                                    phi_14470_ = type_14(_e14921.member_1, _e14902.member_1);
                                                    phi_14513_ = type_15(1u, _e14902.member);
                                                } else {
                                                    phi_14470_ = _e14902;
                                                    phi_14513_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e14927 = phi_14470_;
                                                let _e14929 = phi_14513_;
                                                let _e14932 = (bitcast<i32>(_e14929.member) != 0i);
                                                if _e14932 {
                                                    phi_14473_ = (0.5f * (_e14904 + (_e14894 / _e14904)));
                                                } else {
                                                    phi_14473_ = f32();
                                                }
                                                let _e14937 = phi_14473_;
                                                continue;
                                                continuing {
                                                    phi_14469_ = _e14927;
                                                    phi_14472_ = _e14937;
                                                    break if !(_e14932);
                                                }
                                            }
                                            let _e14942 = local_127;
                                            phi_14526_ = (_e14942 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e14949 = phi_14526_;
                                        let _e14955 = local_18.member[0u];
                                        if (_e14955[0] < 0f) {
                                            phi_14542_ = -(_e14955[0]);
                                        } else {
                                            phi_14542_ = _e14955[0];
                                        }
                                        let _e14962 = phi_14542_;
                                        if (_e14955[1] < 0f) {
                                            phi_14549_ = -(_e14955[1]);
                                        } else {
                                            phi_14549_ = _e14955[1];
                                        }
                                        let _e14966 = phi_14549_;
                                        if (_e14962 > _e14966) {
                                            phi_14554_ = _e14962;
                                        } else {
                                            phi_14554_ = _e14966;
                                        }
                                        let _e14969 = phi_14554_;
                                        if (_e14955[2] < 0f) {
                                            phi_14561_ = -(_e14955[2]);
                                        } else {
                                            phi_14561_ = _e14955[2];
                                        }
                                        let _e14973 = phi_14561_;
                                        if (_e14969 > _e14973) {
                                            phi_14566_ = _e14969;
                                        } else {
                                            phi_14566_ = _e14973;
                                        }
                                        let _e14976 = phi_14566_;
                                        let _e14979 = local_18.member[1u];
                                        if (_e14979[0] < 0f) {
                                            phi_14579_ = -(_e14979[0]);
                                        } else {
                                            phi_14579_ = _e14979[0];
                                        }
                                        let _e14986 = phi_14579_;
                                        if (_e14979[1] < 0f) {
                                            phi_14586_ = -(_e14979[1]);
                                        } else {
                                            phi_14586_ = _e14979[1];
                                        }
                                        let _e14990 = phi_14586_;
                                        if (_e14986 > _e14990) {
                                            phi_14591_ = _e14986;
                                        } else {
                                            phi_14591_ = _e14990;
                                        }
                                        let _e14993 = phi_14591_;
                                        if (_e14979[2] < 0f) {
                                            phi_14598_ = -(_e14979[2]);
                                        } else {
                                            phi_14598_ = _e14979[2];
                                        }
                                        let _e14997 = phi_14598_;
                                        if (_e14993 > _e14997) {
                                            phi_14603_ = _e14993;
                                        } else {
                                            phi_14603_ = _e14997;
                                        }
                                        let _e15000 = phi_14603_;
                                        if (_e14976 > _e15000) {
                                            phi_14608_ = _e14976;
                                        } else {
                                            phi_14608_ = _e15000;
                                        }
                                        let _e15003 = phi_14608_;
                                        let _e15005 = local_18.member_3;
                                        let _e15009 = local_18.member_1[0u];
                                        if (_e15009[0] < 0f) {
                                            phi_14625_ = -(_e15009[0]);
                                        } else {
                                            phi_14625_ = _e15009[0];
                                        }
                                        let _e15016 = phi_14625_;
                                        if (_e15009[1] < 0f) {
                                            phi_14632_ = -(_e15009[1]);
                                        } else {
                                            phi_14632_ = _e15009[1];
                                        }
                                        let _e15020 = phi_14632_;
                                        if (_e15016 > _e15020) {
                                            phi_14637_ = _e15016;
                                        } else {
                                            phi_14637_ = _e15020;
                                        }
                                        let _e15023 = phi_14637_;
                                        if (_e15009[2] < 0f) {
                                            phi_14644_ = -(_e15009[2]);
                                        } else {
                                            phi_14644_ = _e15009[2];
                                        }
                                        let _e15027 = phi_14644_;
                                        if (_e15023 > _e15027) {
                                            phi_14649_ = _e15023;
                                        } else {
                                            phi_14649_ = _e15027;
                                        }
                                        let _e15030 = phi_14649_;
                                        let _e15033 = local_18.member_1[1u];
                                        if (_e15033[0] < 0f) {
                                            phi_14663_ = -(_e15033[0]);
                                        } else {
                                            phi_14663_ = _e15033[0];
                                        }
                                        let _e15040 = phi_14663_;
                                        if (_e15033[1] < 0f) {
                                            phi_14670_ = -(_e15033[1]);
                                        } else {
                                            phi_14670_ = _e15033[1];
                                        }
                                        let _e15044 = phi_14670_;
                                        if (_e15040 > _e15044) {
                                            phi_14675_ = _e15040;
                                        } else {
                                            phi_14675_ = _e15044;
                                        }
                                        let _e15047 = phi_14675_;
                                        if (_e15033[2] < 0f) {
                                            phi_14682_ = -(_e15033[2]);
                                        } else {
                                            phi_14682_ = _e15033[2];
                                        }
                                        let _e15051 = phi_14682_;
                                        if (_e15047 > _e15051) {
                                            phi_14687_ = _e15047;
                                        } else {
                                            phi_14687_ = _e15051;
                                        }
                                        let _e15054 = phi_14687_;
                                        if (_e15030 > _e15054) {
                                            phi_14692_ = _e15030;
                                        } else {
                                            phi_14692_ = _e15054;
                                        }
                                        let _e15057 = phi_14692_;
                                        let _e15059 = local_18.member_3;
                                        let _e15063 = local_18.member_2[0u];
                                        if (_e15063[0] < 0f) {
                                            phi_14709_ = -(_e15063[0]);
                                        } else {
                                            phi_14709_ = _e15063[0];
                                        }
                                        let _e15070 = phi_14709_;
                                        if (_e15063[1] < 0f) {
                                            phi_14716_ = -(_e15063[1]);
                                        } else {
                                            phi_14716_ = _e15063[1];
                                        }
                                        let _e15074 = phi_14716_;
                                        if (_e15070 > _e15074) {
                                            phi_14721_ = _e15070;
                                        } else {
                                            phi_14721_ = _e15074;
                                        }
                                        let _e15077 = phi_14721_;
                                        if (_e15063[2] < 0f) {
                                            phi_14728_ = -(_e15063[2]);
                                        } else {
                                            phi_14728_ = _e15063[2];
                                        }
                                        let _e15081 = phi_14728_;
                                        if (_e15077 > _e15081) {
                                            phi_14733_ = _e15077;
                                        } else {
                                            phi_14733_ = _e15081;
                                        }
                                        let _e15084 = phi_14733_;
                                        let _e15087 = local_18.member_2[1u];
                                        if (_e15087[0] < 0f) {
                                            phi_14747_ = -(_e15087[0]);
                                        } else {
                                            phi_14747_ = _e15087[0];
                                        }
                                        let _e15094 = phi_14747_;
                                        if (_e15087[1] < 0f) {
                                            phi_14754_ = -(_e15087[1]);
                                        } else {
                                            phi_14754_ = _e15087[1];
                                        }
                                        let _e15098 = phi_14754_;
                                        if (_e15094 > _e15098) {
                                            phi_14759_ = _e15094;
                                        } else {
                                            phi_14759_ = _e15098;
                                        }
                                        let _e15101 = phi_14759_;
                                        if (_e15087[2] < 0f) {
                                            phi_14766_ = -(_e15087[2]);
                                        } else {
                                            phi_14766_ = _e15087[2];
                                        }
                                        let _e15105 = phi_14766_;
                                        if (_e15101 > _e15105) {
                                            phi_14771_ = _e15101;
                                        } else {
                                            phi_14771_ = _e15105;
                                        }
                                        let _e15108 = phi_14771_;
                                        if (_e15084 > _e15108) {
                                            phi_14776_ = _e15084;
                                        } else {
                                            phi_14776_ = _e15108;
                                        }
                                        let _e15111 = phi_14776_;
                                        let _e15113 = local_18.member_3;
                                        let _e15120 = local_18.member_3;
                                        let _e15127 = (((_e14949 * (1f + (0.000000059604645f * 8f))) + (((((((_e15003 + _e15005) + (_e15057 + _e15059)) + (_e15111 + _e15113)) * (0.000000059604645f * 16f)) + (_e15120 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e5873.member_1);
                                        if _e15127 {
                                            phi_14796_ = false;
                                        } else {
                                            phi_14796_ = true;
                                        }
                                        let _e15129 = phi_14796_;
                                        phi_14797_ = _e15129;
                                        phi_14798_ = _e15127;
                                    } else {
                                        phi_14797_ = false;
                                        phi_14798_ = false;
                                    }
                                    let _e15131 = phi_14797_;
                                    let _e15133 = phi_14798_;
                                    local_128 = _e15133;
                                    continue;
                                    continuing {
                                        phi_14294_ = _e14803;
                                        break if !(_e15131);
                                    }
                                }
                                let _e15136 = local_128;
                                if _e15136 {
                                    if (_e14774 > _e5605) {
                                        phi_14806_ = 1u;
                                    } else {
                                        phi_14806_ = _e14776;
                                    }
                                    let _e15139 = phi_14806_;
                                    phi_14810_ = type_45(type_44(1u, _e14774), _e15139);
                                    phi_14811_ = false;
                                } else {
                                    phi_14810_ = type_45();
                                    phi_14811_ = true;
                                }
                                let _e15143 = phi_14810_;
                                let _e15145 = phi_14811_;
                                if _e15145 {
                                    if (_e14774 > _e5605) {
                                        phi_14819_ = 0u;
                                    } else {
                                        phi_14819_ = _e14776;
                                    }
                                    let _e15148 = phi_14819_;
                                    phi_14823_ = type_45(type_44(2u, _e14774), _e15148);
                                } else {
                                    phi_14823_ = _e15143;
                                }
                                let _e15152 = phi_14823_;
                                phi_14824_ = _e15152;
                                phi_14825_ = false;
                                phi_14826_ = false;
                            } else {
                                phi_14824_ = type_45();
                                phi_14825_ = _e14780;
                                phi_14826_ = _e14782;
                            }
                            let _e15154 = phi_14824_;
                            let _e15156 = phi_14825_;
                            let _e15158 = phi_14826_;
                            if _e15156 {
                                phi_14833_ = type_45(type_44(0u, f32()), 0u);
                                phi_14834_ = true;
                            } else {
                                phi_14833_ = _e14752;
                                phi_14834_ = _e15158;
                            }
                            let _e15162 = phi_14833_;
                            let _e15164 = phi_14834_;
                            phi_14838_ = _e15162;
                            phi_14839_ = _e15154;
                            phi_14840_ = _e15164;
                        } else {
                            phi_14838_ = _e11389;
                            phi_14839_ = type_45();
                            phi_14840_ = true;
                        }
                        let _e15166 = phi_14838_;
                        let _e15168 = phi_14839_;
                        let _e15170 = phi_14840_;
                        if _e15170 {
                            phi_14844_ = _e15166;
                        } else {
                            phi_14844_ = _e15168;
                        }
                        let _e15172 = phi_14844_;
                        phi_22359_ = _e15172;
                    } else {
                        let _e5917 = local_18.member_1[0u];
                        let _e5923 = local_18.member_2[0u];
                        let _e5929 = ((_e5917[1] * _e5923[2]) - (_e5917[2] * _e5923[1]));
                        let _e5932 = ((_e5917[2] * _e5923[0]) - (_e5917[0] * _e5923[2]));
                        let _e5935 = ((_e5917[0] * _e5923[1]) - (_e5917[1] * _e5923[0]));
                        let _e5938 = local_18.member_1[1u];
                        let _e5944 = local_18.member_2[1u];
                        let _e5950 = ((_e5938[1] * _e5944[2]) - (_e5938[2] * _e5944[1]));
                        let _e5953 = ((_e5938[2] * _e5944[0]) - (_e5938[0] * _e5944[2]));
                        let _e5956 = ((_e5938[0] * _e5944[1]) - (_e5938[1] * _e5944[0]));
                        let _e5959 = local_18.member_1[0u];
                        let _e5965 = local_18.member_2[1u];
                        let _e5980 = local_18.member_1[1u];
                        let _e5986 = local_18.member_2[0u];
                        let _e5999 = (((_e5959[1] * _e5965[2]) - (_e5959[2] * _e5965[1])) + ((_e5980[1] * _e5986[2]) - (_e5980[2] * _e5986[1])));
                        let _e6000 = (((_e5959[2] * _e5965[0]) - (_e5959[0] * _e5965[2])) + ((_e5980[2] * _e5986[0]) - (_e5980[0] * _e5986[2])));
                        let _e6001 = (((_e5959[0] * _e5965[1]) - (_e5959[1] * _e5965[0])) + ((_e5980[0] * _e5986[1]) - (_e5980[1] * _e5986[0])));
                        let _e6004 = local_18.member[0u];
                        let _e6012 = (((_e6004[0] * _e5929) + (_e6004[1] * _e5932)) + (_e6004[2] * _e5935));
                        let _e6015 = local_18.member[1u];
                        let _e6026 = local_18.member[0u];
                        let _e6035 = ((((_e6015[0] * _e5929) + (_e6015[1] * _e5932)) + (_e6015[2] * _e5935)) + (((_e6026[0] * _e5999) + (_e6026[1] * _e6000)) + (_e6026[2] * _e6001)));
                        let _e6038 = local_18.member[0u];
                        let _e6049 = local_18.member[1u];
                        let _e6058 = ((((_e6038[0] * _e5950) + (_e6038[1] * _e5953)) + (_e6038[2] * _e5956)) + (((_e6049[0] * _e5999) + (_e6049[1] * _e6000)) + (_e6049[2] * _e6001)));
                        let _e6061 = local_18.member[1u];
                        let _e6069 = (((_e6061[0] * _e5950) + (_e6061[1] * _e5953)) + (_e6061[2] * _e5956));
                        let _e6072 = local_18.member[0u];
                        if (_e6072[0] < 0f) {
                            phi_15086_ = -(_e6072[0]);
                        } else {
                            phi_15086_ = _e6072[0];
                        }
                        let _e6079 = phi_15086_;
                        if (_e6072[1] < 0f) {
                            phi_15093_ = -(_e6072[1]);
                        } else {
                            phi_15093_ = _e6072[1];
                        }
                        let _e6083 = phi_15093_;
                        if (_e6079 > _e6083) {
                            phi_15098_ = _e6079;
                        } else {
                            phi_15098_ = _e6083;
                        }
                        let _e6086 = phi_15098_;
                        if (_e6072[2] < 0f) {
                            phi_15105_ = -(_e6072[2]);
                        } else {
                            phi_15105_ = _e6072[2];
                        }
                        let _e6090 = phi_15105_;
                        if (_e6086 > _e6090) {
                            phi_15110_ = _e6086;
                        } else {
                            phi_15110_ = _e6090;
                        }
                        let _e6093 = phi_15110_;
                        let _e6096 = local_18.member[1u];
                        if (_e6096[0] < 0f) {
                            phi_15123_ = -(_e6096[0]);
                        } else {
                            phi_15123_ = _e6096[0];
                        }
                        let _e6103 = phi_15123_;
                        if (_e6096[1] < 0f) {
                            phi_15130_ = -(_e6096[1]);
                        } else {
                            phi_15130_ = _e6096[1];
                        }
                        let _e6107 = phi_15130_;
                        if (_e6103 > _e6107) {
                            phi_15135_ = _e6103;
                        } else {
                            phi_15135_ = _e6107;
                        }
                        let _e6110 = phi_15135_;
                        if (_e6096[2] < 0f) {
                            phi_15142_ = -(_e6096[2]);
                        } else {
                            phi_15142_ = _e6096[2];
                        }
                        let _e6114 = phi_15142_;
                        if (_e6110 > _e6114) {
                            phi_15147_ = _e6110;
                        } else {
                            phi_15147_ = _e6114;
                        }
                        let _e6117 = phi_15147_;
                        if (_e6093 > _e6117) {
                            phi_15152_ = _e6093;
                        } else {
                            phi_15152_ = _e6117;
                        }
                        let _e6120 = phi_15152_;
                        let _e6122 = local_18.member_3;
                        let _e6123 = (_e6120 + _e6122);
                        let _e6126 = local_18.member_1[0u];
                        if (_e6126[0] < 0f) {
                            phi_15169_ = -(_e6126[0]);
                        } else {
                            phi_15169_ = _e6126[0];
                        }
                        let _e6133 = phi_15169_;
                        if (_e6126[1] < 0f) {
                            phi_15176_ = -(_e6126[1]);
                        } else {
                            phi_15176_ = _e6126[1];
                        }
                        let _e6137 = phi_15176_;
                        if (_e6133 > _e6137) {
                            phi_15181_ = _e6133;
                        } else {
                            phi_15181_ = _e6137;
                        }
                        let _e6140 = phi_15181_;
                        if (_e6126[2] < 0f) {
                            phi_15188_ = -(_e6126[2]);
                        } else {
                            phi_15188_ = _e6126[2];
                        }
                        let _e6144 = phi_15188_;
                        if (_e6140 > _e6144) {
                            phi_15193_ = _e6140;
                        } else {
                            phi_15193_ = _e6144;
                        }
                        let _e6147 = phi_15193_;
                        let _e6150 = local_18.member_1[1u];
                        if (_e6150[0] < 0f) {
                            phi_15207_ = -(_e6150[0]);
                        } else {
                            phi_15207_ = _e6150[0];
                        }
                        let _e6157 = phi_15207_;
                        if (_e6150[1] < 0f) {
                            phi_15214_ = -(_e6150[1]);
                        } else {
                            phi_15214_ = _e6150[1];
                        }
                        let _e6161 = phi_15214_;
                        if (_e6157 > _e6161) {
                            phi_15219_ = _e6157;
                        } else {
                            phi_15219_ = _e6161;
                        }
                        let _e6164 = phi_15219_;
                        if (_e6150[2] < 0f) {
                            phi_15226_ = -(_e6150[2]);
                        } else {
                            phi_15226_ = _e6150[2];
                        }
                        let _e6168 = phi_15226_;
                        if (_e6164 > _e6168) {
                            phi_15231_ = _e6164;
                        } else {
                            phi_15231_ = _e6168;
                        }
                        let _e6171 = phi_15231_;
                        if (_e6147 > _e6171) {
                            phi_15236_ = _e6147;
                        } else {
                            phi_15236_ = _e6171;
                        }
                        let _e6174 = phi_15236_;
                        let _e6176 = local_18.member_3;
                        let _e6177 = (_e6174 + _e6176);
                        let _e6180 = local_18.member_2[0u];
                        if (_e6180[0] < 0f) {
                            phi_15253_ = -(_e6180[0]);
                        } else {
                            phi_15253_ = _e6180[0];
                        }
                        let _e6187 = phi_15253_;
                        if (_e6180[1] < 0f) {
                            phi_15260_ = -(_e6180[1]);
                        } else {
                            phi_15260_ = _e6180[1];
                        }
                        let _e6191 = phi_15260_;
                        if (_e6187 > _e6191) {
                            phi_15265_ = _e6187;
                        } else {
                            phi_15265_ = _e6191;
                        }
                        let _e6194 = phi_15265_;
                        if (_e6180[2] < 0f) {
                            phi_15272_ = -(_e6180[2]);
                        } else {
                            phi_15272_ = _e6180[2];
                        }
                        let _e6198 = phi_15272_;
                        if (_e6194 > _e6198) {
                            phi_15277_ = _e6194;
                        } else {
                            phi_15277_ = _e6198;
                        }
                        let _e6201 = phi_15277_;
                        let _e6204 = local_18.member_2[1u];
                        if (_e6204[0] < 0f) {
                            phi_15291_ = -(_e6204[0]);
                        } else {
                            phi_15291_ = _e6204[0];
                        }
                        let _e6211 = phi_15291_;
                        if (_e6204[1] < 0f) {
                            phi_15298_ = -(_e6204[1]);
                        } else {
                            phi_15298_ = _e6204[1];
                        }
                        let _e6215 = phi_15298_;
                        if (_e6211 > _e6215) {
                            phi_15303_ = _e6211;
                        } else {
                            phi_15303_ = _e6215;
                        }
                        let _e6218 = phi_15303_;
                        if (_e6204[2] < 0f) {
                            phi_15310_ = -(_e6204[2]);
                        } else {
                            phi_15310_ = _e6204[2];
                        }
                        let _e6222 = phi_15310_;
                        if (_e6218 > _e6222) {
                            phi_15315_ = _e6218;
                        } else {
                            phi_15315_ = _e6222;
                        }
                        let _e6225 = phi_15315_;
                        if (_e6201 > _e6225) {
                            phi_15320_ = _e6201;
                        } else {
                            phi_15320_ = _e6225;
                        }
                        let _e6228 = phi_15320_;
                        let _e6230 = local_18.member_3;
                        let _e6231 = (_e6228 + _e6230);
                        let _e6233 = ((_e6177 * 8f) * _e6231);
                        let _e6240 = local_18.member_3;
                        if (_e5929 < 0f) {
                            phi_15351_ = -(_e5929);
                        } else {
                            phi_15351_ = _e5929;
                        }
                        let _e6257 = phi_15351_;
                        if (_e5932 < 0f) {
                            phi_15357_ = -(_e5932);
                        } else {
                            phi_15357_ = _e5932;
                        }
                        let _e6261 = phi_15357_;
                        if (_e5935 < 0f) {
                            phi_15364_ = -(_e5935);
                        } else {
                            phi_15364_ = _e5935;
                        }
                        let _e6266 = phi_15364_;
                        let _e6267 = ((_e6257 + _e6261) + _e6266);
                        if (_e5950 < 0f) {
                            phi_15371_ = -(_e5950);
                        } else {
                            phi_15371_ = _e5950;
                        }
                        let _e6271 = phi_15371_;
                        if (_e5953 < 0f) {
                            phi_15377_ = -(_e5953);
                        } else {
                            phi_15377_ = _e5953;
                        }
                        let _e6275 = phi_15377_;
                        if (_e5956 < 0f) {
                            phi_15384_ = -(_e5956);
                        } else {
                            phi_15384_ = _e5956;
                        }
                        let _e6280 = phi_15384_;
                        let _e6281 = ((_e6271 + _e6275) + _e6280);
                        if (_e6267 > _e6281) {
                            phi_15390_ = _e6267;
                        } else {
                            phi_15390_ = _e6281;
                        }
                        let _e6284 = phi_15390_;
                        if (_e5999 < 0f) {
                            phi_15396_ = -(_e5999);
                        } else {
                            phi_15396_ = _e5999;
                        }
                        let _e6288 = phi_15396_;
                        if (_e6000 < 0f) {
                            phi_15402_ = -(_e6000);
                        } else {
                            phi_15402_ = _e6000;
                        }
                        let _e6292 = phi_15402_;
                        if (_e6001 < 0f) {
                            phi_15409_ = -(_e6001);
                        } else {
                            phi_15409_ = _e6001;
                        }
                        let _e6297 = phi_15409_;
                        let _e6299 = (((_e6288 + _e6292) + _e6297) * 0.5f);
                        if (_e6284 > _e6299) {
                            phi_15416_ = _e6284;
                        } else {
                            phi_15416_ = _e6299;
                        }
                        let _e6302 = phi_15416_;
                        let _e6307 = local_18.member_3;
                        let _e6319 = (((((_e6123 * 8f) * _e6233) * (0.000000059604645f * (524f / 64f))) + ((_e6240 * 19f) * ((_e6123 * (_e6177 + _e6231)) + (_e6177 * _e6231)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6123) * ((1f + _e6177) * (1f + _e6231)))));
                        let _e6320 = (_e6012 * 3f);
                        let _e6321 = (_e6069 * 3f);
                        if (_e6320 < _e6321) {
                            phi_15440_ = _e6320;
                        } else {
                            phi_15440_ = _e6321;
                        }
                        let _e6324 = phi_15440_;
                        if (_e6035 < _e6058) {
                            phi_15445_ = _e6035;
                        } else {
                            phi_15445_ = _e6058;
                        }
                        let _e6327 = phi_15445_;
                        if (_e6324 < _e6327) {
                            phi_15450_ = _e6324;
                        } else {
                            phi_15450_ = _e6327;
                        }
                        let _e6330 = phi_15450_;
                        if (_e6320 > _e6321) {
                            phi_15455_ = _e6320;
                        } else {
                            phi_15455_ = _e6321;
                        }
                        let _e6333 = phi_15455_;
                        if (_e6035 > _e6058) {
                            phi_15460_ = _e6035;
                        } else {
                            phi_15460_ = _e6058;
                        }
                        let _e6336 = phi_15460_;
                        if (_e6333 > _e6336) {
                            phi_15465_ = _e6333;
                        } else {
                            phi_15465_ = _e6336;
                        }
                        let _e6339 = phi_15465_;
                        let _e6344 = -(_e6339);
                        if (_e6330 > _e6344) {
                            phi_15475_ = _e6330;
                        } else {
                            phi_15475_ = _e6344;
                        }
                        let _e6347 = phi_15475_;
                        if ((_e6347 - (_e6319 + ((0f * (((_e6302 + (_e6233 * (0.000000059604645f * 8f))) + ((_e6307 * 6f) * (_e6177 + _e6231))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6177) * (1f + _e6231))))) * (3f * 1.0001f)))) > 0f) {
                            phi_22329_ = type_44(0u, type_44().member_1);
                            phi_22330_ = type_44();
                            phi_22331_ = true;
                        } else {
                            if (_e6012 < 0f) {
                                phi_15488_ = -(_e6012);
                            } else {
                                phi_15488_ = _e6012;
                            }
                            let _e6354 = phi_15488_;
                            if (_e6035 < 0f) {
                                phi_15494_ = -(_e6035);
                            } else {
                                phi_15494_ = _e6035;
                            }
                            let _e6358 = phi_15494_;
                            if (_e6354 > _e6358) {
                                phi_15499_ = _e6354;
                            } else {
                                phi_15499_ = _e6358;
                            }
                            let _e6361 = phi_15499_;
                            if (_e6058 < 0f) {
                                phi_15505_ = -(_e6058);
                            } else {
                                phi_15505_ = _e6058;
                            }
                            let _e6365 = phi_15505_;
                            if (_e6069 < 0f) {
                                phi_15511_ = -(_e6069);
                            } else {
                                phi_15511_ = _e6069;
                            }
                            let _e6369 = phi_15511_;
                            if (_e6365 > _e6369) {
                                phi_15516_ = _e6365;
                            } else {
                                phi_15516_ = _e6369;
                            }
                            let _e6372 = phi_15516_;
                            if (_e6361 > _e6372) {
                                phi_15521_ = _e6361;
                            } else {
                                phi_15521_ = _e6372;
                            }
                            let _e6375 = phi_15521_;
                            let _e6376 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                            if (_e6375 >= _e6376) {
                                phi_15529_ = (_e6375 <= (1f / _e6376));
                            } else {
                                phi_15529_ = false;
                            }
                            let _e6381 = phi_15529_;
                            if _e6381 {
                                phi_15534_ = (0.000000059604645f * 256f);
                            } else {
                                phi_15534_ = 2f;
                            }
                            let _e6384 = phi_15534_;
                            let _e6386 = ((_e6319 * 0.34f) + (_e6375 * _e6384));
                            if _e6381 {
                                phi_15541_ = (1f / _e6375);
                            } else {
                                phi_15541_ = 0f;
                            }
                            let _e6389 = phi_15541_;
                            let _e6390 = (_e5603 * 0.0625f);
                            if (0.00000000000022737368f < _e6390) {
                                phi_15547_ = 0.00000000000022737368f;
                            } else {
                                phi_15547_ = _e6390;
                            }
                            let _e6393 = phi_15547_;
                            let _e6394 = (1f - _e5605);
                            let _e6405 = ((((_e6012 * _e6394) + (_e6035 * _e5605)) * (_e6394 * _e6394)) + (((_e6058 * _e6394) + (_e6069 * _e5605)) * (_e5605 * _e5605)));
                            if (_e6405 < 0f) {
                                phi_15565_ = -(_e6405);
                            } else {
                                phi_15565_ = _e6405;
                            }
                            let _e6409 = phi_15565_;
                            if !((_e6409 > _e6386)) {
                                let _e6414 = local_18.member[0u];
                                let _e6421 = local_18.member_1[0u];
                                let _e6427 = local_18.member_2[0u];
                                let _e6431 = (_e6414[0] - _e6421[0]);
                                let _e6432 = (_e6414[1] - _e6421[1]);
                                let _e6433 = (_e6414[2] - _e6421[2]);
                                if (_e316.member == 0u) {
                                    phi_15626_ = array<f32, 3>(_e6414[0], _e6414[1], _e6414[2]);
                                } else {
                                    phi_15626_ = array<f32, 3>((_e6431 - _e6427[0]), (_e6432 - _e6427[1]), (_e6433 - _e6427[2]));
                                }
                                let _e6440 = phi_15626_;
                                let _e6441 = (_e6414[0] - _e6427[0]);
                                let _e6442 = (_e6414[1] - _e6427[1]);
                                let _e6443 = (_e6414[2] - _e6427[2]);
                                let _e6446 = local_18.member[1u];
                                let _e6453 = local_18.member_1[1u];
                                let _e6459 = local_18.member_2[1u];
                                let _e6463 = (_e6446[0] - _e6453[0]);
                                let _e6464 = (_e6446[1] - _e6453[1]);
                                let _e6465 = (_e6446[2] - _e6453[2]);
                                if (_e316.member == 0u) {
                                    phi_15691_ = array<f32, 3>(_e6446[0], _e6446[1], _e6446[2]);
                                } else {
                                    phi_15691_ = array<f32, 3>((_e6463 - _e6459[0]), (_e6464 - _e6459[1]), (_e6465 - _e6459[2]));
                                }
                                let _e6472 = phi_15691_;
                                let _e6473 = (_e6446[0] - _e6459[0]);
                                let _e6474 = (_e6446[1] - _e6459[1]);
                                let _e6475 = (_e6446[2] - _e6459[2]);
                                let _e6478 = local_18.member[0u];
                                if (_e6478[0] < 0f) {
                                    phi_15713_ = -(_e6478[0]);
                                } else {
                                    phi_15713_ = _e6478[0];
                                }
                                let _e6485 = phi_15713_;
                                if (_e6478[1] < 0f) {
                                    phi_15720_ = -(_e6478[1]);
                                } else {
                                    phi_15720_ = _e6478[1];
                                }
                                let _e6489 = phi_15720_;
                                if (_e6485 > _e6489) {
                                    phi_15725_ = _e6485;
                                } else {
                                    phi_15725_ = _e6489;
                                }
                                let _e6492 = phi_15725_;
                                if (_e6478[2] < 0f) {
                                    phi_15732_ = -(_e6478[2]);
                                } else {
                                    phi_15732_ = _e6478[2];
                                }
                                let _e6496 = phi_15732_;
                                if (_e6492 > _e6496) {
                                    phi_15737_ = _e6492;
                                } else {
                                    phi_15737_ = _e6496;
                                }
                                let _e6499 = phi_15737_;
                                let _e6502 = local_18.member[1u];
                                if (_e6502[0] < 0f) {
                                    phi_15750_ = -(_e6502[0]);
                                } else {
                                    phi_15750_ = _e6502[0];
                                }
                                let _e6509 = phi_15750_;
                                if (_e6502[1] < 0f) {
                                    phi_15757_ = -(_e6502[1]);
                                } else {
                                    phi_15757_ = _e6502[1];
                                }
                                let _e6513 = phi_15757_;
                                if (_e6509 > _e6513) {
                                    phi_15762_ = _e6509;
                                } else {
                                    phi_15762_ = _e6513;
                                }
                                let _e6516 = phi_15762_;
                                if (_e6502[2] < 0f) {
                                    phi_15769_ = -(_e6502[2]);
                                } else {
                                    phi_15769_ = _e6502[2];
                                }
                                let _e6520 = phi_15769_;
                                if (_e6516 > _e6520) {
                                    phi_15774_ = _e6516;
                                } else {
                                    phi_15774_ = _e6520;
                                }
                                let _e6523 = phi_15774_;
                                if (_e6499 > _e6523) {
                                    phi_15779_ = _e6499;
                                } else {
                                    phi_15779_ = _e6523;
                                }
                                let _e6526 = phi_15779_;
                                let _e6528 = local_18.member_3;
                                let _e6532 = local_18.member_1[0u];
                                if (_e6532[0] < 0f) {
                                    phi_15796_ = -(_e6532[0]);
                                } else {
                                    phi_15796_ = _e6532[0];
                                }
                                let _e6539 = phi_15796_;
                                if (_e6532[1] < 0f) {
                                    phi_15803_ = -(_e6532[1]);
                                } else {
                                    phi_15803_ = _e6532[1];
                                }
                                let _e6543 = phi_15803_;
                                if (_e6539 > _e6543) {
                                    phi_15808_ = _e6539;
                                } else {
                                    phi_15808_ = _e6543;
                                }
                                let _e6546 = phi_15808_;
                                if (_e6532[2] < 0f) {
                                    phi_15815_ = -(_e6532[2]);
                                } else {
                                    phi_15815_ = _e6532[2];
                                }
                                let _e6550 = phi_15815_;
                                if (_e6546 > _e6550) {
                                    phi_15820_ = _e6546;
                                } else {
                                    phi_15820_ = _e6550;
                                }
                                let _e6553 = phi_15820_;
                                let _e6556 = local_18.member_1[1u];
                                if (_e6556[0] < 0f) {
                                    phi_15834_ = -(_e6556[0]);
                                } else {
                                    phi_15834_ = _e6556[0];
                                }
                                let _e6563 = phi_15834_;
                                if (_e6556[1] < 0f) {
                                    phi_15841_ = -(_e6556[1]);
                                } else {
                                    phi_15841_ = _e6556[1];
                                }
                                let _e6567 = phi_15841_;
                                if (_e6563 > _e6567) {
                                    phi_15846_ = _e6563;
                                } else {
                                    phi_15846_ = _e6567;
                                }
                                let _e6570 = phi_15846_;
                                if (_e6556[2] < 0f) {
                                    phi_15853_ = -(_e6556[2]);
                                } else {
                                    phi_15853_ = _e6556[2];
                                }
                                let _e6574 = phi_15853_;
                                if (_e6570 > _e6574) {
                                    phi_15858_ = _e6570;
                                } else {
                                    phi_15858_ = _e6574;
                                }
                                let _e6577 = phi_15858_;
                                if (_e6553 > _e6577) {
                                    phi_15863_ = _e6553;
                                } else {
                                    phi_15863_ = _e6577;
                                }
                                let _e6580 = phi_15863_;
                                let _e6582 = local_18.member_3;
                                let _e6586 = local_18.member_2[0u];
                                if (_e6586[0] < 0f) {
                                    phi_15880_ = -(_e6586[0]);
                                } else {
                                    phi_15880_ = _e6586[0];
                                }
                                let _e6593 = phi_15880_;
                                if (_e6586[1] < 0f) {
                                    phi_15887_ = -(_e6586[1]);
                                } else {
                                    phi_15887_ = _e6586[1];
                                }
                                let _e6597 = phi_15887_;
                                if (_e6593 > _e6597) {
                                    phi_15892_ = _e6593;
                                } else {
                                    phi_15892_ = _e6597;
                                }
                                let _e6600 = phi_15892_;
                                if (_e6586[2] < 0f) {
                                    phi_15899_ = -(_e6586[2]);
                                } else {
                                    phi_15899_ = _e6586[2];
                                }
                                let _e6604 = phi_15899_;
                                if (_e6600 > _e6604) {
                                    phi_15904_ = _e6600;
                                } else {
                                    phi_15904_ = _e6604;
                                }
                                let _e6607 = phi_15904_;
                                let _e6610 = local_18.member_2[1u];
                                if (_e6610[0] < 0f) {
                                    phi_15918_ = -(_e6610[0]);
                                } else {
                                    phi_15918_ = _e6610[0];
                                }
                                let _e6617 = phi_15918_;
                                if (_e6610[1] < 0f) {
                                    phi_15925_ = -(_e6610[1]);
                                } else {
                                    phi_15925_ = _e6610[1];
                                }
                                let _e6621 = phi_15925_;
                                if (_e6617 > _e6621) {
                                    phi_15930_ = _e6617;
                                } else {
                                    phi_15930_ = _e6621;
                                }
                                let _e6624 = phi_15930_;
                                if (_e6610[2] < 0f) {
                                    phi_15937_ = -(_e6610[2]);
                                } else {
                                    phi_15937_ = _e6610[2];
                                }
                                let _e6628 = phi_15937_;
                                if (_e6624 > _e6628) {
                                    phi_15942_ = _e6624;
                                } else {
                                    phi_15942_ = _e6628;
                                }
                                let _e6631 = phi_15942_;
                                if (_e6607 > _e6631) {
                                    phi_15947_ = _e6607;
                                } else {
                                    phi_15947_ = _e6631;
                                }
                                let _e6634 = phi_15947_;
                                let _e6636 = local_18.member_3;
                                let _e6643 = local_18.member_3;
                                let _e6647 = ((((((_e6526 + _e6528) + (_e6580 + _e6582)) + (_e6634 + _e6636)) * (0.000000059604645f * 16f)) + (_e6643 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e6650 = local_18.member[0u];
                                let _e6656 = local_18.member[1u];
                                let _e6672 = local_18.member_1[0u];
                                let _e6678 = local_18.member_1[1u];
                                let _e6694 = local_18.member_2[0u];
                                let _e6700 = local_18.member_2[1u];
                                let _e6714 = function_3(array<f32, 3>((_e6650[0] + ((_e6656[0] - _e6650[0]) * _e5605)), (_e6650[1] + ((_e6656[1] - _e6650[1]) * _e5605)), (_e6650[2] + ((_e6656[2] - _e6650[2]) * _e5605))), array<f32, 3>((_e6672[0] + ((_e6678[0] - _e6672[0]) * _e5605)), (_e6672[1] + ((_e6678[1] - _e6672[1]) * _e5605)), (_e6672[2] + ((_e6678[2] - _e6672[2]) * _e5605))), array<f32, 3>((_e6694[0] + ((_e6700[0] - _e6694[0]) * _e5605)), (_e6694[1] + ((_e6700[1] - _e6694[1]) * _e5605)), (_e6694[2] + ((_e6700[2] - _e6694[2]) * _e5605))), _e316.member);
                                if (_e6714[0] < 0f) {
                                    phi_16065_ = -(_e6714[0]);
                                } else {
                                    phi_16065_ = _e6714[0];
                                }
                                let _e6719 = phi_16065_;
                                if (_e6714[1] < 0f) {
                                    phi_16072_ = -(_e6714[1]);
                                } else {
                                    phi_16072_ = _e6714[1];
                                }
                                let _e6724 = phi_16072_;
                                if (_e6714[2] < 0f) {
                                    phi_16080_ = -(_e6714[2]);
                                } else {
                                    phi_16080_ = _e6714[2];
                                }
                                let _e6730 = phi_16080_;
                                let _e6731 = ((_e6719 + _e6724) + _e6730);
                                if (_e6731 > 0f) {
                                    if ((bitcast<u32>(_e6731) & 2139095040u) != 2139095040u) {
                                        let _e6736 = (1f / _e6731);
                                        let _e6738 = (_e6714[0] * _e6736);
                                        let _e6740 = (_e6714[1] * _e6736);
                                        let _e6742 = (_e6714[2] * _e6736);
                                        let _e6747 = (((_e6738 * _e6738) + (_e6740 * _e6740)) + (_e6742 * _e6742));
                                        if (_e6747 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e6747 > 0f) {
                                                phi_16117_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_16117_ = 0f;
                                            }
                                            let _e6800 = phi_16117_;
                                            phi_16181_ = _e6800;
                                        } else {
                                            phi_16124_ = type_14(0i, 5i);
                                            phi_16127_ = bitcast<f32>(((bitcast<u32>(_e6747) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e6755 = phi_16124_;
                                                let _e6757 = phi_16127_;
                                                local_85 = _e6757;
                                                if (_e6755.member < _e6755.member_1) {
                                                    let _e6764 = (_e6755.member + 1i);
                                                    if ((false == (_e6764 > _e6755.member)) != false) {
                                                        phi_16148_ = true;
                                                    } else {
                                                        phi_16148_ = false;
                                                    }
                                                    let _e6769 = phi_16148_;
                                                    if _e6769 {
                                                        phi_16154_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_16154_ = type_15(1u, _e6764);
                                                    }
                                                    let _e6774 = phi_16154_;
                                                    phi_16125_ = type_14(_e6774.member_1, _e6755.member_1);
                                                    phi_16168_ = type_15(1u, _e6755.member);
                                                } else {
                                                    phi_16125_ = _e6755;
                                                    phi_16168_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e6780 = phi_16125_;
                                                let _e6782 = phi_16168_;
                                                let _e6785 = (bitcast<i32>(_e6782.member) != 0i);
                                                if _e6785 {
                                                    phi_16128_ = (0.5f * (_e6757 + (_e6747 / _e6757)));
                                                } else {
                                                    phi_16128_ = f32();
                                                }
                                                let _e6790 = phi_16128_;
                                                continue;
                                                continuing {
                                                    phi_16124_ = _e6780;
                                                    phi_16127_ = _e6790;
                                                    break if !(_e6785);
                                                }
                                            }
                                            let _e6795 = local_85;
                                            phi_16181_ = (_e6795 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e6802 = phi_16181_;
                                        let _e6803 = (0.000000059604645f * 12f);
                                        let _e6808 = ((_e6647 * 1.01f) + ((0f * _e6802) * (1f + _e6803)));
                                        let _e6813 = (((_e6738 * _e6414[0]) + (_e6740 * _e6414[1])) + (_e6742 * _e6414[2]));
                                        let _e6818 = (((_e6738 * _e6431) + (_e6740 * _e6432)) + (_e6742 * _e6433));
                                        let _e6823 = (((_e6738 * _e6441) + (_e6740 * _e6442)) + (_e6742 * _e6443));
                                        let _e6831 = (((_e6738 * _e6440[0]) + (_e6740 * _e6440[1])) + (_e6742 * _e6440[2]));
                                        let _e6837 = (((_e6738 * _e6446[0]) + (_e6740 * _e6446[1])) + (_e6742 * _e6446[2]));
                                        let _e6842 = (((_e6738 * _e6463) + (_e6740 * _e6464)) + (_e6742 * _e6465));
                                        let _e6847 = (((_e6738 * _e6473) + (_e6740 * _e6474)) + (_e6742 * _e6475));
                                        let _e6855 = (((_e6738 * _e6472[0]) + (_e6740 * _e6472[1])) + (_e6742 * _e6472[2]));
                                        if (_e6813 < 0f) {
                                            phi_16247_ = -(_e6813);
                                        } else {
                                            phi_16247_ = _e6813;
                                        }
                                        let _e6860 = phi_16247_;
                                        if (_e6837 < 0f) {
                                            phi_16253_ = -(_e6837);
                                        } else {
                                            phi_16253_ = _e6837;
                                        }
                                        let _e6864 = phi_16253_;
                                        if (_e6818 < 0f) {
                                            phi_16262_ = -(_e6818);
                                        } else {
                                            phi_16262_ = _e6818;
                                        }
                                        let _e6871 = phi_16262_;
                                        if (_e6842 < 0f) {
                                            phi_16268_ = -(_e6842);
                                        } else {
                                            phi_16268_ = _e6842;
                                        }
                                        let _e6875 = phi_16268_;
                                        if (_e6823 < 0f) {
                                            phi_16277_ = -(_e6823);
                                        } else {
                                            phi_16277_ = _e6823;
                                        }
                                        let _e6882 = phi_16277_;
                                        if (_e6847 < 0f) {
                                            phi_16283_ = -(_e6847);
                                        } else {
                                            phi_16283_ = _e6847;
                                        }
                                        let _e6886 = phi_16283_;
                                        if (_e6831 < 0f) {
                                            phi_16292_ = -(_e6831);
                                        } else {
                                            phi_16292_ = _e6831;
                                        }
                                        let _e6893 = phi_16292_;
                                        if (_e6855 < 0f) {
                                            phi_16298_ = -(_e6855);
                                        } else {
                                            phi_16298_ = _e6855;
                                        }
                                        let _e6897 = phi_16298_;
                                        phi_16304_ = type_29(array<f32, 4>(_e6813, _e6818, _e6823, _e6831), array<f32, 4>(_e6837, _e6842, _e6847, _e6855), array<f32, 4>((_e6808 + ((_e6860 + _e6864) * _e6803)), (_e6808 + ((_e6871 + _e6875) * _e6803)), (_e6808 + ((_e6882 + _e6886) * _e6803)), (_e6808 + ((_e6893 + _e6897) * _e6803))));
                                        phi_16305_ = false;
                                    } else {
                                        phi_16304_ = type_29();
                                        phi_16305_ = true;
                                    }
                                    let _e6904 = phi_16304_;
                                    let _e6906 = phi_16305_;
                                    phi_16306_ = _e6904;
                                    phi_16307_ = _e6906;
                                } else {
                                    phi_16306_ = type_29();
                                    phi_16307_ = true;
                                }
                                let _e6908 = phi_16306_;
                                let _e6910 = phi_16307_;
                                if _e6910 {
                                    phi_16315_ = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                } else {
                                    phi_16315_ = _e6908;
                                }
                                let _e6912 = phi_16315_;
                                local_8 = type_29(array<f32, 4>(_e6912.member[0], _e6912.member[1], _e6912.member[2], _e6912.member[3]), array<f32, 4>(_e6912.member_1[0], _e6912.member_1[1], _e6912.member_1[2], _e6912.member_1[3]), array<f32, 4>(_e6912.member_2[0], _e6912.member_2[1], _e6912.member_2[2], _e6912.member_2[3]));
                                let _e6934 = local_8.member[0u];
                                let _e6937 = local_8.member_1[0u];
                                let _e6940 = local_8.member[0u];
                                let _e6946 = local_8.member_2[0u];
                                if (((_e6934 + ((_e6937 - _e6940) * _e5605)) - _e6946) > 0f) {
                                    let _e6951 = local_8.member[1u];
                                    let _e6954 = local_8.member_1[1u];
                                    let _e6957 = local_8.member[1u];
                                    let _e6963 = local_8.member_2[1u];
                                    if (((_e6951 + ((_e6954 - _e6957) * _e5605)) - _e6963) > 0f) {
                                        let _e6968 = local_8.member[2u];
                                        let _e6971 = local_8.member_1[2u];
                                        let _e6974 = local_8.member[2u];
                                        let _e6980 = local_8.member_2[2u];
                                        if (((_e6968 + ((_e6971 - _e6974) * _e5605)) - _e6980) > 0f) {
                                            let _e6985 = local_8.member[3u];
                                            let _e6988 = local_8.member_1[3u];
                                            let _e6991 = local_8.member[3u];
                                            let _e6997 = local_8.member_2[3u];
                                            phi_16484_ = (((_e6985 + ((_e6988 - _e6991) * _e5605)) - _e6997) > 0f);
                                            phi_16485_ = false;
                                        } else {
                                            phi_16484_ = bool();
                                            phi_16485_ = true;
                                        }
                                        let _e7001 = phi_16484_;
                                        let _e7003 = phi_16485_;
                                        phi_16486_ = _e7001;
                                        phi_16487_ = _e7003;
                                    } else {
                                        phi_16486_ = bool();
                                        phi_16487_ = true;
                                    }
                                    let _e7005 = phi_16486_;
                                    let _e7007 = phi_16487_;
                                    phi_16488_ = _e7005;
                                    phi_16489_ = _e7007;
                                } else {
                                    phi_16488_ = bool();
                                    phi_16489_ = true;
                                }
                                let _e7009 = phi_16488_;
                                let _e7011 = phi_16489_;
                                if _e7011 {
                                    phi_16493_ = false;
                                } else {
                                    phi_16493_ = _e7009;
                                }
                                let _e7013 = phi_16493_;
                                if _e7013 {
                                    phi_17847_ = bool();
                                    phi_17848_ = true;
                                } else {
                                    if (_e6714[0] < 0f) {
                                        phi_16520_ = -(_e6714[0]);
                                    } else {
                                        phi_16520_ = _e6714[0];
                                    }
                                    let _e7018 = phi_16520_;
                                    let _e7020 = ((_e7018 + 0f) + 0f);
                                    if (_e7020 > 0f) {
                                        if ((bitcast<u32>(_e7020) & 2139095040u) != 2139095040u) {
                                            let _e7025 = (1f / _e7020);
                                            let _e7026 = (_e6714[0] * _e7025);
                                            let _e7027 = (0f * _e7025);
                                            let _e7028 = (0f * _e7025);
                                            let _e7033 = (((_e7026 * _e7026) + (_e7027 * _e7027)) + (_e7028 * _e7028));
                                            if (_e7033 <= 0.000000000000000000000000000000000000011754944f) {
                                                if (_e7033 > 0f) {
                                                    phi_16567_ = (0.000000000000000000106433627f * 2f);
                                                } else {
                                                    phi_16567_ = 0f;
                                                }
                                                let _e7086 = phi_16567_;
                                                phi_16631_ = _e7086;
                                            } else {
                                                phi_16574_ = type_14(0i, 5i);
                                                phi_16577_ = bitcast<f32>(((bitcast<u32>(_e7033) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e7041 = phi_16574_;
                                                    let _e7043 = phi_16577_;
                                                    local_86 = _e7043;
                                                    if (_e7041.member < _e7041.member_1) {
                                                        let _e7050 = (_e7041.member + 1i);
                                                        if ((false == (_e7050 > _e7041.member)) != false) {
                                                            phi_16598_ = true;
                                                        } else {
                                                            phi_16598_ = false;
                                                        }
                                                        let _e7055 = phi_16598_;
                                                        if _e7055 {
                                                            phi_16604_ = type_15(0u, type_15().member_1);
                                                        } else {
                                                            phi_16604_ = type_15(1u, _e7050);
                                                        }
                                                        let _e7060 = phi_16604_;
                                                        phi_16575_ = type_14(_e7060.member_1, _e7041.member_1);
                                                        phi_16618_ = type_15(1u, _e7041.member);
                                                    } else {
                                                        phi_16575_ = _e7041;
                                                        phi_16618_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e7066 = phi_16575_;
                                                    let _e7068 = phi_16618_;
                                                    let _e7071 = (bitcast<i32>(_e7068.member) != 0i);
                                                    if _e7071 {
                                                        phi_16578_ = (0.5f * (_e7043 + (_e7033 / _e7043)));
                                                    } else {
                                                        phi_16578_ = f32();
                                                    }
                                                    let _e7076 = phi_16578_;
                                                    continue;
                                                    continuing {
                                                        phi_16574_ = _e7066;
                                                        phi_16577_ = _e7076;
                                                        break if !(_e7071);
                                                    }
                                                }
                                                let _e7081 = local_86;
                                                phi_16631_ = (_e7081 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e7088 = phi_16631_;
                                            let _e7089 = (0.000000059604645f * 12f);
                                            let _e7094 = ((_e6647 * 1.01f) + ((0f * _e7088) * (1f + _e7089)));
                                            let _e7099 = (((_e7026 * _e6414[0]) + (_e7027 * _e6414[1])) + (_e7028 * _e6414[2]));
                                            let _e7104 = (((_e7026 * _e6431) + (_e7027 * _e6432)) + (_e7028 * _e6433));
                                            let _e7109 = (((_e7026 * _e6441) + (_e7027 * _e6442)) + (_e7028 * _e6443));
                                            let _e7117 = (((_e7026 * _e6440[0]) + (_e7027 * _e6440[1])) + (_e7028 * _e6440[2]));
                                            let _e7123 = (((_e7026 * _e6446[0]) + (_e7027 * _e6446[1])) + (_e7028 * _e6446[2]));
                                            let _e7128 = (((_e7026 * _e6463) + (_e7027 * _e6464)) + (_e7028 * _e6465));
                                            let _e7133 = (((_e7026 * _e6473) + (_e7027 * _e6474)) + (_e7028 * _e6475));
                                            let _e7141 = (((_e7026 * _e6472[0]) + (_e7027 * _e6472[1])) + (_e7028 * _e6472[2]));
                                            if (_e7099 < 0f) {
                                                phi_16697_ = -(_e7099);
                                            } else {
                                                phi_16697_ = _e7099;
                                            }
                                            let _e7146 = phi_16697_;
                                            if (_e7123 < 0f) {
                                                phi_16703_ = -(_e7123);
                                            } else {
                                                phi_16703_ = _e7123;
                                            }
                                            let _e7150 = phi_16703_;
                                            if (_e7104 < 0f) {
                                                phi_16712_ = -(_e7104);
                                            } else {
                                                phi_16712_ = _e7104;
                                            }
                                            let _e7157 = phi_16712_;
                                            if (_e7128 < 0f) {
                                                phi_16718_ = -(_e7128);
                                            } else {
                                                phi_16718_ = _e7128;
                                            }
                                            let _e7161 = phi_16718_;
                                            if (_e7109 < 0f) {
                                                phi_16727_ = -(_e7109);
                                            } else {
                                                phi_16727_ = _e7109;
                                            }
                                            let _e7168 = phi_16727_;
                                            if (_e7133 < 0f) {
                                                phi_16733_ = -(_e7133);
                                            } else {
                                                phi_16733_ = _e7133;
                                            }
                                            let _e7172 = phi_16733_;
                                            if (_e7117 < 0f) {
                                                phi_16742_ = -(_e7117);
                                            } else {
                                                phi_16742_ = _e7117;
                                            }
                                            let _e7179 = phi_16742_;
                                            if (_e7141 < 0f) {
                                                phi_16748_ = -(_e7141);
                                            } else {
                                                phi_16748_ = _e7141;
                                            }
                                            let _e7183 = phi_16748_;
                                            phi_16754_ = type_29(array<f32, 4>(_e7099, _e7104, _e7109, _e7117), array<f32, 4>(_e7123, _e7128, _e7133, _e7141), array<f32, 4>((_e7094 + ((_e7146 + _e7150) * _e7089)), (_e7094 + ((_e7157 + _e7161) * _e7089)), (_e7094 + ((_e7168 + _e7172) * _e7089)), (_e7094 + ((_e7179 + _e7183) * _e7089))));
                                            phi_16755_ = false;
                                        } else {
                                            phi_16754_ = type_29();
                                            phi_16755_ = true;
                                        }
                                        let _e7190 = phi_16754_;
                                        let _e7192 = phi_16755_;
                                        phi_16756_ = _e7190;
                                        phi_16757_ = _e7192;
                                    } else {
                                        phi_16756_ = type_29();
                                        phi_16757_ = true;
                                    }
                                    let _e7194 = phi_16756_;
                                    let _e7196 = phi_16757_;
                                    if _e7196 {
                                        phi_16765_ = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    } else {
                                        phi_16765_ = _e7194;
                                    }
                                    let _e7198 = phi_16765_;
                                    local_9 = type_29(array<f32, 4>(_e7198.member[0], _e7198.member[1], _e7198.member[2], _e7198.member[3]), array<f32, 4>(_e7198.member_1[0], _e7198.member_1[1], _e7198.member_1[2], _e7198.member_1[3]), array<f32, 4>(_e7198.member_2[0], _e7198.member_2[1], _e7198.member_2[2], _e7198.member_2[3]));
                                    let _e7220 = local_9.member[0u];
                                    let _e7223 = local_9.member_1[0u];
                                    let _e7226 = local_9.member[0u];
                                    let _e7232 = local_9.member_2[0u];
                                    if (((_e7220 + ((_e7223 - _e7226) * _e5605)) - _e7232) > 0f) {
                                        let _e7237 = local_9.member[1u];
                                        let _e7240 = local_9.member_1[1u];
                                        let _e7243 = local_9.member[1u];
                                        let _e7249 = local_9.member_2[1u];
                                        if (((_e7237 + ((_e7240 - _e7243) * _e5605)) - _e7249) > 0f) {
                                            let _e7254 = local_9.member[2u];
                                            let _e7257 = local_9.member_1[2u];
                                            let _e7260 = local_9.member[2u];
                                            let _e7266 = local_9.member_2[2u];
                                            if (((_e7254 + ((_e7257 - _e7260) * _e5605)) - _e7266) > 0f) {
                                                let _e7271 = local_9.member[3u];
                                                let _e7274 = local_9.member_1[3u];
                                                let _e7277 = local_9.member[3u];
                                                let _e7283 = local_9.member_2[3u];
                                                phi_16934_ = (((_e7271 + ((_e7274 - _e7277) * _e5605)) - _e7283) > 0f);
                                                phi_16935_ = false;
                                            } else {
                                                phi_16934_ = bool();
                                                phi_16935_ = true;
                                            }
                                            let _e7287 = phi_16934_;
                                            let _e7289 = phi_16935_;
                                            phi_16936_ = _e7287;
                                            phi_16937_ = _e7289;
                                        } else {
                                            phi_16936_ = bool();
                                            phi_16937_ = true;
                                        }
                                        let _e7291 = phi_16936_;
                                        let _e7293 = phi_16937_;
                                        phi_16938_ = _e7291;
                                        phi_16939_ = _e7293;
                                    } else {
                                        phi_16938_ = bool();
                                        phi_16939_ = true;
                                    }
                                    let _e7295 = phi_16938_;
                                    let _e7297 = phi_16939_;
                                    if _e7297 {
                                        phi_16943_ = false;
                                    } else {
                                        phi_16943_ = _e7295;
                                    }
                                    let _e7299 = phi_16943_;
                                    if _e7299 {
                                        phi_17845_ = bool();
                                        phi_17846_ = true;
                                    } else {
                                        if (_e6714[1] < 0f) {
                                            phi_16976_ = -(_e6714[1]);
                                        } else {
                                            phi_16976_ = _e6714[1];
                                        }
                                        let _e7304 = phi_16976_;
                                        let _e7306 = ((0f + _e7304) + 0f);
                                        if (_e7306 > 0f) {
                                            if ((bitcast<u32>(_e7306) & 2139095040u) != 2139095040u) {
                                                let _e7311 = (1f / _e7306);
                                                let _e7312 = (0f * _e7311);
                                                let _e7313 = (_e6714[1] * _e7311);
                                                let _e7314 = (0f * _e7311);
                                                let _e7319 = (((_e7312 * _e7312) + (_e7313 * _e7313)) + (_e7314 * _e7314));
                                                if (_e7319 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e7319 > 0f) {
                                                        phi_17017_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_17017_ = 0f;
                                                    }
                                                    let _e7372 = phi_17017_;
                                                    phi_17081_ = _e7372;
                                                } else {
                                                    phi_17024_ = type_14(0i, 5i);
                                                    phi_17027_ = bitcast<f32>(((bitcast<u32>(_e7319) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e7327 = phi_17024_;
                                                        let _e7329 = phi_17027_;
                                                        local_87 = _e7329;
                                                        if (_e7327.member < _e7327.member_1) {
                                                            let _e7336 = (_e7327.member + 1i);
                                                            if ((false == (_e7336 > _e7327.member)) != false) {
                                                                phi_17048_ = true;
                                                            } else {
                                                                phi_17048_ = false;
                                                            }
                                                            let _e7341 = phi_17048_;
                                                            if _e7341 {
                                                                phi_17054_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_17054_ = type_15(1u, _e7336);
                                                            }
                                                            let _e7346 = phi_17054_;
                                                            phi_17025_ = type_14(_e7346.member_1, _e7327.member_1);
                                                            phi_17068_ = type_15(1u, _e7327.member);
                                                        } else {
                                                            phi_17025_ = _e7327;
                                                            phi_17068_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e7352 = phi_17025_;
                                                        let _e7354 = phi_17068_;
                                                        let _e7357 = (bitcast<i32>(_e7354.member) != 0i);
                                                        if _e7357 {
                                                            phi_17028_ = (0.5f * (_e7329 + (_e7319 / _e7329)));
                                                        } else {
                                                            phi_17028_ = f32();
                                                        }
                                                        let _e7362 = phi_17028_;
                                                        continue;
                                                        continuing {
                                                            phi_17024_ = _e7352;
                                                            phi_17027_ = _e7362;
                                                            break if !(_e7357);
                                                        }
                                                    }
                                                    let _e7367 = local_87;
                                                    phi_17081_ = (_e7367 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e7374 = phi_17081_;
                                                let _e7375 = (0.000000059604645f * 12f);
                                                let _e7380 = ((_e6647 * 1.01f) + ((0f * _e7374) * (1f + _e7375)));
                                                let _e7385 = (((_e7312 * _e6414[0]) + (_e7313 * _e6414[1])) + (_e7314 * _e6414[2]));
                                                let _e7390 = (((_e7312 * _e6431) + (_e7313 * _e6432)) + (_e7314 * _e6433));
                                                let _e7395 = (((_e7312 * _e6441) + (_e7313 * _e6442)) + (_e7314 * _e6443));
                                                let _e7403 = (((_e7312 * _e6440[0]) + (_e7313 * _e6440[1])) + (_e7314 * _e6440[2]));
                                                let _e7409 = (((_e7312 * _e6446[0]) + (_e7313 * _e6446[1])) + (_e7314 * _e6446[2]));
                                                let _e7414 = (((_e7312 * _e6463) + (_e7313 * _e6464)) + (_e7314 * _e6465));
                                                let _e7419 = (((_e7312 * _e6473) + (_e7313 * _e6474)) + (_e7314 * _e6475));
                                                let _e7427 = (((_e7312 * _e6472[0]) + (_e7313 * _e6472[1])) + (_e7314 * _e6472[2]));
                                                if (_e7385 < 0f) {
                                                    phi_17147_ = -(_e7385);
                                                } else {
                                                    phi_17147_ = _e7385;
                                                }
                                                let _e7432 = phi_17147_;
                                                if (_e7409 < 0f) {
                                                    phi_17153_ = -(_e7409);
                                                } else {
                                                    phi_17153_ = _e7409;
                                                }
                                                let _e7436 = phi_17153_;
                                                if (_e7390 < 0f) {
                                                    phi_17162_ = -(_e7390);
                                                } else {
                                                    phi_17162_ = _e7390;
                                                }
                                                let _e7443 = phi_17162_;
                                                if (_e7414 < 0f) {
                                                    phi_17168_ = -(_e7414);
                                                } else {
                                                    phi_17168_ = _e7414;
                                                }
                                                let _e7447 = phi_17168_;
                                                if (_e7395 < 0f) {
                                                    phi_17177_ = -(_e7395);
                                                } else {
                                                    phi_17177_ = _e7395;
                                                }
                                                let _e7454 = phi_17177_;
                                                if (_e7419 < 0f) {
                                                    phi_17183_ = -(_e7419);
                                                } else {
                                                    phi_17183_ = _e7419;
                                                }
                                                let _e7458 = phi_17183_;
                                                if (_e7403 < 0f) {
                                                    phi_17192_ = -(_e7403);
                                                } else {
                                                    phi_17192_ = _e7403;
                                                }
                                                let _e7465 = phi_17192_;
                                                if (_e7427 < 0f) {
                                                    phi_17198_ = -(_e7427);
                                                } else {
                                                    phi_17198_ = _e7427;
                                                }
                                                let _e7469 = phi_17198_;
                                                phi_17204_ = type_29(array<f32, 4>(_e7385, _e7390, _e7395, _e7403), array<f32, 4>(_e7409, _e7414, _e7419, _e7427), array<f32, 4>((_e7380 + ((_e7432 + _e7436) * _e7375)), (_e7380 + ((_e7443 + _e7447) * _e7375)), (_e7380 + ((_e7454 + _e7458) * _e7375)), (_e7380 + ((_e7465 + _e7469) * _e7375))));
                                                phi_17205_ = false;
                                            } else {
                                                phi_17204_ = type_29();
                                                phi_17205_ = true;
                                            }
                                            let _e7476 = phi_17204_;
                                            let _e7478 = phi_17205_;
                                            phi_17206_ = _e7476;
                                            phi_17207_ = _e7478;
                                        } else {
                                            phi_17206_ = type_29();
                                            phi_17207_ = true;
                                        }
                                        let _e7480 = phi_17206_;
                                        let _e7482 = phi_17207_;
                                        if _e7482 {
                                            phi_17215_ = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        } else {
                                            phi_17215_ = _e7480;
                                        }
                                        let _e7484 = phi_17215_;
                                        local_10 = type_29(array<f32, 4>(_e7484.member[0], _e7484.member[1], _e7484.member[2], _e7484.member[3]), array<f32, 4>(_e7484.member_1[0], _e7484.member_1[1], _e7484.member_1[2], _e7484.member_1[3]), array<f32, 4>(_e7484.member_2[0], _e7484.member_2[1], _e7484.member_2[2], _e7484.member_2[3]));
                                        let _e7506 = local_10.member[0u];
                                        let _e7509 = local_10.member_1[0u];
                                        let _e7512 = local_10.member[0u];
                                        let _e7518 = local_10.member_2[0u];
                                        if (((_e7506 + ((_e7509 - _e7512) * _e5605)) - _e7518) > 0f) {
                                            let _e7523 = local_10.member[1u];
                                            let _e7526 = local_10.member_1[1u];
                                            let _e7529 = local_10.member[1u];
                                            let _e7535 = local_10.member_2[1u];
                                            if (((_e7523 + ((_e7526 - _e7529) * _e5605)) - _e7535) > 0f) {
                                                let _e7540 = local_10.member[2u];
                                                let _e7543 = local_10.member_1[2u];
                                                let _e7546 = local_10.member[2u];
                                                let _e7552 = local_10.member_2[2u];
                                                if (((_e7540 + ((_e7543 - _e7546) * _e5605)) - _e7552) > 0f) {
                                                    let _e7557 = local_10.member[3u];
                                                    let _e7560 = local_10.member_1[3u];
                                                    let _e7563 = local_10.member[3u];
                                                    let _e7569 = local_10.member_2[3u];
                                                    phi_17384_ = (((_e7557 + ((_e7560 - _e7563) * _e5605)) - _e7569) > 0f);
                                                    phi_17385_ = false;
                                                } else {
                                                    phi_17384_ = bool();
                                                    phi_17385_ = true;
                                                }
                                                let _e7573 = phi_17384_;
                                                let _e7575 = phi_17385_;
                                                phi_17386_ = _e7573;
                                                phi_17387_ = _e7575;
                                            } else {
                                                phi_17386_ = bool();
                                                phi_17387_ = true;
                                            }
                                            let _e7577 = phi_17386_;
                                            let _e7579 = phi_17387_;
                                            phi_17388_ = _e7577;
                                            phi_17389_ = _e7579;
                                        } else {
                                            phi_17388_ = bool();
                                            phi_17389_ = true;
                                        }
                                        let _e7581 = phi_17388_;
                                        let _e7583 = phi_17389_;
                                        if _e7583 {
                                            phi_17393_ = false;
                                        } else {
                                            phi_17393_ = _e7581;
                                        }
                                        let _e7585 = phi_17393_;
                                        if _e7585 {
                                            phi_17844_ = bool();
                                        } else {
                                            if (_e6714[2] < 0f) {
                                                phi_17433_ = -(_e6714[2]);
                                            } else {
                                                phi_17433_ = _e6714[2];
                                            }
                                            let _e7591 = phi_17433_;
                                            let _e7592 = ((0f + 0f) + _e7591);
                                            if (_e7592 > 0f) {
                                                if ((bitcast<u32>(_e7592) & 2139095040u) != 2139095040u) {
                                                    let _e7597 = (1f / _e7592);
                                                    let _e7598 = (0f * _e7597);
                                                    let _e7599 = (0f * _e7597);
                                                    let _e7600 = (_e6714[2] * _e7597);
                                                    let _e7605 = (((_e7598 * _e7598) + (_e7599 * _e7599)) + (_e7600 * _e7600));
                                                    if (_e7605 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e7605 > 0f) {
                                                            phi_17467_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_17467_ = 0f;
                                                        }
                                                        let _e7658 = phi_17467_;
                                                        phi_17531_ = _e7658;
                                                    } else {
                                                        phi_17474_ = type_14(0i, 5i);
                                                        phi_17477_ = bitcast<f32>(((bitcast<u32>(_e7605) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e7613 = phi_17474_;
                                                            let _e7615 = phi_17477_;
                                                            local_88 = _e7615;
                                                            if (_e7613.member < _e7613.member_1) {
                                                                let _e7622 = (_e7613.member + 1i);
                                                                if ((false == (_e7622 > _e7613.member)) != false) {
                                                                    phi_17498_ = true;
                                                                } else {
                                                                    phi_17498_ = false;
                                                                }
                                                                let _e7627 = phi_17498_;
                                                                if _e7627 {
                                                                    phi_17504_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_17504_ = type_15(1u, _e7622);
                                                                }
                                                                let _e7632 = phi_17504_;
                                                                phi_17475_ = type_14(_e7632.member_1, _e7613.member_1);
                                                                phi_17518_ = type_15(1u, _e7613.member);
                                                            } else {
                                                                phi_17475_ = _e7613;
                                                                phi_17518_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e7638 = phi_17475_;
                                                            let _e7640 = phi_17518_;
                                                            let _e7643 = (bitcast<i32>(_e7640.member) != 0i);
                                                            if _e7643 {
                                                                phi_17478_ = (0.5f * (_e7615 + (_e7605 / _e7615)));
                                                            } else {
                                                                phi_17478_ = f32();
                                                            }
                                                            let _e7648 = phi_17478_;
                                                            continue;
                                                            continuing {
                                                                phi_17474_ = _e7638;
                                                                phi_17477_ = _e7648;
                                                                break if !(_e7643);
                                                            }
                                                        }
                                                        let _e7653 = local_88;
                                                        phi_17531_ = (_e7653 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e7660 = phi_17531_;
                                                    let _e7661 = (0.000000059604645f * 12f);
                                                    let _e7666 = ((_e6647 * 1.01f) + ((0f * _e7660) * (1f + _e7661)));
                                                    let _e7671 = (((_e7598 * _e6414[0]) + (_e7599 * _e6414[1])) + (_e7600 * _e6414[2]));
                                                    let _e7676 = (((_e7598 * _e6431) + (_e7599 * _e6432)) + (_e7600 * _e6433));
                                                    let _e7681 = (((_e7598 * _e6441) + (_e7599 * _e6442)) + (_e7600 * _e6443));
                                                    let _e7689 = (((_e7598 * _e6440[0]) + (_e7599 * _e6440[1])) + (_e7600 * _e6440[2]));
                                                    let _e7695 = (((_e7598 * _e6446[0]) + (_e7599 * _e6446[1])) + (_e7600 * _e6446[2]));
                                                    let _e7700 = (((_e7598 * _e6463) + (_e7599 * _e6464)) + (_e7600 * _e6465));
                                                    let _e7705 = (((_e7598 * _e6473) + (_e7599 * _e6474)) + (_e7600 * _e6475));
                                                    let _e7713 = (((_e7598 * _e6472[0]) + (_e7599 * _e6472[1])) + (_e7600 * _e6472[2]));
                                                    if (_e7671 < 0f) {
                                                        phi_17597_ = -(_e7671);
                                                    } else {
                                                        phi_17597_ = _e7671;
                                                    }
                                                    let _e7718 = phi_17597_;
                                                    if (_e7695 < 0f) {
                                                        phi_17603_ = -(_e7695);
                                                    } else {
                                                        phi_17603_ = _e7695;
                                                    }
                                                    let _e7722 = phi_17603_;
                                                    if (_e7676 < 0f) {
                                                        phi_17612_ = -(_e7676);
                                                    } else {
                                                        phi_17612_ = _e7676;
                                                    }
                                                    let _e7729 = phi_17612_;
                                                    if (_e7700 < 0f) {
                                                        phi_17618_ = -(_e7700);
                                                    } else {
                                                        phi_17618_ = _e7700;
                                                    }
                                                    let _e7733 = phi_17618_;
                                                    if (_e7681 < 0f) {
                                                        phi_17627_ = -(_e7681);
                                                    } else {
                                                        phi_17627_ = _e7681;
                                                    }
                                                    let _e7740 = phi_17627_;
                                                    if (_e7705 < 0f) {
                                                        phi_17633_ = -(_e7705);
                                                    } else {
                                                        phi_17633_ = _e7705;
                                                    }
                                                    let _e7744 = phi_17633_;
                                                    if (_e7689 < 0f) {
                                                        phi_17642_ = -(_e7689);
                                                    } else {
                                                        phi_17642_ = _e7689;
                                                    }
                                                    let _e7751 = phi_17642_;
                                                    if (_e7713 < 0f) {
                                                        phi_17648_ = -(_e7713);
                                                    } else {
                                                        phi_17648_ = _e7713;
                                                    }
                                                    let _e7755 = phi_17648_;
                                                    phi_17654_ = type_29(array<f32, 4>(_e7671, _e7676, _e7681, _e7689), array<f32, 4>(_e7695, _e7700, _e7705, _e7713), array<f32, 4>((_e7666 + ((_e7718 + _e7722) * _e7661)), (_e7666 + ((_e7729 + _e7733) * _e7661)), (_e7666 + ((_e7740 + _e7744) * _e7661)), (_e7666 + ((_e7751 + _e7755) * _e7661))));
                                                    phi_17655_ = false;
                                                } else {
                                                    phi_17654_ = type_29();
                                                    phi_17655_ = true;
                                                }
                                                let _e7762 = phi_17654_;
                                                let _e7764 = phi_17655_;
                                                phi_17656_ = _e7762;
                                                phi_17657_ = _e7764;
                                            } else {
                                                phi_17656_ = type_29();
                                                phi_17657_ = true;
                                            }
                                            let _e7766 = phi_17656_;
                                            let _e7768 = phi_17657_;
                                            if _e7768 {
                                                phi_17665_ = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            } else {
                                                phi_17665_ = _e7766;
                                            }
                                            let _e7770 = phi_17665_;
                                            local_11 = type_29(array<f32, 4>(_e7770.member[0], _e7770.member[1], _e7770.member[2], _e7770.member[3]), array<f32, 4>(_e7770.member_1[0], _e7770.member_1[1], _e7770.member_1[2], _e7770.member_1[3]), array<f32, 4>(_e7770.member_2[0], _e7770.member_2[1], _e7770.member_2[2], _e7770.member_2[3]));
                                            let _e7792 = local_11.member[0u];
                                            let _e7795 = local_11.member_1[0u];
                                            let _e7798 = local_11.member[0u];
                                            let _e7804 = local_11.member_2[0u];
                                            if (((_e7792 + ((_e7795 - _e7798) * _e5605)) - _e7804) > 0f) {
                                                let _e7809 = local_11.member[1u];
                                                let _e7812 = local_11.member_1[1u];
                                                let _e7815 = local_11.member[1u];
                                                let _e7821 = local_11.member_2[1u];
                                                if (((_e7809 + ((_e7812 - _e7815) * _e5605)) - _e7821) > 0f) {
                                                    let _e7826 = local_11.member[2u];
                                                    let _e7829 = local_11.member_1[2u];
                                                    let _e7832 = local_11.member[2u];
                                                    let _e7838 = local_11.member_2[2u];
                                                    if (((_e7826 + ((_e7829 - _e7832) * _e5605)) - _e7838) > 0f) {
                                                        let _e7843 = local_11.member[3u];
                                                        let _e7846 = local_11.member_1[3u];
                                                        let _e7849 = local_11.member[3u];
                                                        let _e7855 = local_11.member_2[3u];
                                                        phi_17834_ = (((_e7843 + ((_e7846 - _e7849) * _e5605)) - _e7855) > 0f);
                                                        phi_17835_ = false;
                                                    } else {
                                                        phi_17834_ = bool();
                                                        phi_17835_ = true;
                                                    }
                                                    let _e7859 = phi_17834_;
                                                    let _e7861 = phi_17835_;
                                                    phi_17836_ = _e7859;
                                                    phi_17837_ = _e7861;
                                                } else {
                                                    phi_17836_ = bool();
                                                    phi_17837_ = true;
                                                }
                                                let _e7863 = phi_17836_;
                                                let _e7865 = phi_17837_;
                                                phi_17838_ = _e7863;
                                                phi_17839_ = _e7865;
                                            } else {
                                                phi_17838_ = bool();
                                                phi_17839_ = true;
                                            }
                                            let _e7867 = phi_17838_;
                                            let _e7869 = phi_17839_;
                                            if _e7869 {
                                                phi_17843_ = false;
                                            } else {
                                                phi_17843_ = _e7867;
                                            }
                                            let _e7871 = phi_17843_;
                                            phi_17844_ = _e7871;
                                        }
                                        let _e7873 = phi_17844_;
                                        phi_17845_ = _e7873;
                                        phi_17846_ = _e7585;
                                    }
                                    let _e7875 = phi_17845_;
                                    let _e7877 = phi_17846_;
                                    phi_17847_ = _e7875;
                                    phi_17848_ = _e7877;
                                }
                                let _e7879 = phi_17847_;
                                let _e7881 = phi_17848_;
                                if _e7881 {
                                    phi_17852_ = true;
                                } else {
                                    phi_17852_ = _e7879;
                                }
                                let _e7883 = phi_17852_;
                                if !(_e7883) {
                                    phi_17858_ = type_44(2u, _e5605);
                                    phi_17859_ = false;
                                } else {
                                    phi_17858_ = type_44();
                                    phi_17859_ = true;
                                }
                                let _e7887 = phi_17858_;
                                let _e7889 = phi_17859_;
                                phi_17860_ = _e7887;
                                phi_17861_ = _e7889;
                            } else {
                                phi_17860_ = type_44();
                                phi_17861_ = true;
                            }
                            let _e7891 = phi_17860_;
                            let _e7893 = phi_17861_;
                            if _e7893 {
                                let _e7899 = ((_e6035 - (3f * _e6012)) * _e6389);
                                let _e7900 = ((_e6058 - _e6035) * _e6389);
                                let _e7901 = (((3f * _e6069) - _e6058) * _e6389);
                                local_6[0u] = 0f;
                                local_6[1u] = 1f;
                                local_6[2u] = 1f;
                                local_6[3u] = 1f;
                                let _e7908 = ((_e7900 * _e7900) - (_e7899 * _e7901));
                                if (_e7908 > 0f) {
                                    if (_e7908 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e7908 > 0f) {
                                            phi_17897_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_17897_ = 0f;
                                        }
                                        let _e7962 = phi_17897_;
                                        phi_17961_ = _e7962;
                                    } else {
                                        phi_17904_ = type_14(0i, 5i);
                                        phi_17907_ = bitcast<f32>(((bitcast<u32>(_e7908) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e7917 = phi_17904_;
                                            let _e7919 = phi_17907_;
                                            local_89 = _e7919;
                                            if (_e7917.member < _e7917.member_1) {
                                                let _e7926 = (_e7917.member + 1i);
                                                if ((false == (_e7926 > _e7917.member)) != false) {
                                                    phi_17928_ = true;
                                                } else {
                                                    phi_17928_ = false;
                                                }
                                                let _e7931 = phi_17928_;
                                                if _e7931 {
                                                    phi_17934_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_17934_ = type_15(1u, _e7926);
                                                }
                                                let _e7936 = phi_17934_;
                                                phi_17905_ = type_14(_e7936.member_1, _e7917.member_1);
                                                phi_17948_ = type_15(1u, _e7917.member);
                                            } else {
                                                phi_17905_ = _e7917;
                                                phi_17948_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e7942 = phi_17905_;
                                            let _e7944 = phi_17948_;
                                            let _e7947 = (bitcast<i32>(_e7944.member) != 0i);
                                            if _e7947 {
                                                phi_17908_ = (0.5f * (_e7919 + (_e7908 / _e7919)));
                                            } else {
                                                phi_17908_ = f32();
                                            }
                                            let _e7952 = phi_17908_;
                                            continue;
                                            continuing {
                                                phi_17904_ = _e7942;
                                                phi_17907_ = _e7952;
                                                break if !(_e7947);
                                            }
                                        }
                                        let _e7957 = local_89;
                                        phi_17961_ = (_e7957 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e7964 = phi_17961_;
                                    if (_e7900 < 0f) {
                                        phi_17967_ = -(_e7964);
                                    } else {
                                        phi_17967_ = _e7964;
                                    }
                                    let _e7968 = phi_17967_;
                                    let _e7970 = -((_e7900 + _e7968));
                                    local_7[0u] = (_e7970 / (_e7970 + _e7901));
                                    local_7[1u] = (_e7899 / (_e7899 + _e7970));
                                    let _e7979 = local_7[1u];
                                    let _e7980 = local_7[0u];
                                    if (_e7979 < _e7980) {
                                        let _e7983 = local_7[1u];
                                        let _e7985 = local_7[0u];
                                        local_7[0u] = _e7983;
                                        local_7[1u] = _e7985;
                                    }
                                    phi_17992_ = type_9(0u, 2u);
                                    phi_17995_ = 1u;
                                    loop {
                                        let _e7989 = phi_17992_;
                                        let _e7991 = phi_17995_;
                                        local_134 = _e7991;
                                        if (_e7989.member < _e7989.member_1) {
                                            phi_17993_ = type_9((_e7989.member + 1u), _e7989.member_1);
                                            phi_18018_ = type_9(1u, _e7989.member);
                                        } else {
                                            phi_17993_ = _e7989;
                                            phi_18018_ = type_9(0u, type_9().member_1);
                                        }
                                        let _e8003 = phi_17993_;
                                        let _e8005 = phi_18018_;
                                        let _e8009 = (bitcast<i32>(_e8005.member) != 0i);
                                        if _e8009 {
                                            let _e8011 = local_7[_e8005.member_1];
                                            if (_e8011 > 0f) {
                                                let _e8014 = local_7[_e8005.member_1];
                                                if (_e8014 < 1f) {
                                                    let _e8017 = local_7[_e8005.member_1];
                                                    local_6[_e7991] = _e8017;
                                                    phi_18062_ = (_e7991 + 1u);
                                                } else {
                                                    phi_18062_ = _e7991;
                                                }
                                                let _e8021 = phi_18062_;
                                                phi_18063_ = _e8021;
                                            } else {
                                                phi_18063_ = _e7991;
                                            }
                                            let _e8023 = phi_18063_;
                                            phi_17996_ = _e8023;
                                        } else {
                                            phi_17996_ = u32();
                                        }
                                        let _e8025 = phi_17996_;
                                        continue;
                                        continuing {
                                            phi_17992_ = _e8003;
                                            phi_17995_ = _e8025;
                                            break if !(_e8009);
                                        }
                                    }
                                    let _e16185 = local_134;
                                    phi_18064_ = _e16185;
                                } else {
                                    phi_18064_ = 1u;
                                }
                                let _e8028 = phi_18064_;
                                local_6[_e8028] = 1f;
                                let _e8030 = local_6;
                                local_12 = _e8030;
                                phi_18084_ = type_9(0u, _e8028);
                                loop {
                                    let _e8033 = phi_18084_;
                                    if (_e8033.member < _e8033.member_1) {
                                        phi_18085_ = type_9((_e8033.member + 1u), _e8033.member_1);
                                        phi_18108_ = type_9(1u, _e8033.member);
                                    } else {
                                        phi_18085_ = _e8033;
                                        phi_18108_ = type_9(0u, type_9().member_1);
                                    }
                                    let _e8045 = phi_18085_;
                                    let _e8047 = phi_18108_;
                                    if (bitcast<i32>(_e8047.member) != 0i) {
                                        let _e8053 = local_12[_e8047.member_1];
                                        if (_e8053 > _e5605) {
                                            phi_18127_ = _e8053;
                                        } else {
                                            phi_18127_ = _e5605;
                                        }
                                        let _e8056 = phi_18127_;
                                        let _e8059 = local_12[(_e8047.member_1 + 1u)];
                                        if (_e8059 < _e5607) {
                                            phi_18140_ = _e8059;
                                        } else {
                                            phi_18140_ = _e5607;
                                        }
                                        let _e8062 = phi_18140_;
                                        if (_e8056 <= _e8062) {
                                            let _e8064 = (1f - _e8056);
                                            let _e8075 = ((((_e6012 * _e8064) + (_e6035 * _e8056)) * (_e8064 * _e8064)) + (((_e6058 * _e8064) + (_e6069 * _e8056)) * (_e8056 * _e8056)));
                                            let _e8076 = (1f - _e8062);
                                            let _e8087 = ((((_e6012 * _e8076) + (_e6035 * _e8062)) * (_e8076 * _e8076)) + (((_e6058 * _e8076) + (_e6069 * _e8062)) * (_e8062 * _e8062)));
                                            if (_e8075 < 0f) {
                                                phi_18174_ = -(_e8075);
                                            } else {
                                                phi_18174_ = _e8075;
                                            }
                                            let _e8091 = phi_18174_;
                                            let _e8092 = (_e8091 > _e6386);
                                            if (_e8087 < 0f) {
                                                phi_18181_ = -(_e8087);
                                            } else {
                                                phi_18181_ = _e8087;
                                            }
                                            let _e8096 = phi_18181_;
                                            let _e8097 = (_e8096 > _e6386);
                                            if _e8092 {
                                                if _e8097 {
                                                    phi_18192_ = ((_e8075 > 0f) != (_e8087 > 0f));
                                                    phi_18193_ = false;
                                                } else {
                                                    phi_18192_ = bool();
                                                    phi_18193_ = true;
                                                }
                                                let _e8102 = phi_18192_;
                                                let _e8104 = phi_18193_;
                                                phi_18194_ = _e8102;
                                                phi_18195_ = _e8104;
                                            } else {
                                                phi_18194_ = bool();
                                                phi_18195_ = true;
                                            }
                                            let _e8106 = phi_18194_;
                                            let _e8108 = phi_18195_;
                                            if _e8108 {
                                                phi_18199_ = false;
                                            } else {
                                                phi_18199_ = _e8106;
                                            }
                                            let _e8110 = phi_18199_;
                                            if _e8092 {
                                                if _e8097 {
                                                    if _e8110 {
                                                        phi_18210_ = type_47();
                                                    } else {
                                                        phi_18210_ = type_47(1f, 0f, _e8110);
                                                    }
                                                    let _e8113 = phi_18210_;
                                                    phi_18211_ = _e8113;
                                                    phi_18212_ = _e8110;
                                                } else {
                                                    phi_18211_ = type_47();
                                                    phi_18212_ = true;
                                                }
                                                let _e8115 = phi_18211_;
                                                let _e8117 = phi_18212_;
                                                phi_18213_ = _e8115;
                                                phi_18214_ = _e8117;
                                            } else {
                                                phi_18213_ = type_47();
                                                phi_18214_ = true;
                                            }
                                            let _e8119 = phi_18213_;
                                            let _e8121 = phi_18214_;
                                            if _e8121 {
                                                if _e8092 {
                                                    if (_e8075 < 0f) {
                                                        phi_18225_ = -1f;
                                                    } else {
                                                        phi_18225_ = 1f;
                                                    }
                                                    let _e8124 = phi_18225_;
                                                    let _e8127 = (_e6058 - _e6035);
                                                    phi_18235_ = type_9(0u, 64u);
                                                    phi_18238_ = _e8062;
                                                    phi_18240_ = _e8056;
                                                    phi_18242_ = (0.5f * (_e8056 + _e8062));
                                                    loop {
                                                        let _e8133 = phi_18235_;
                                                        let _e8135 = phi_18238_;
                                                        let _e8137 = phi_18240_;
                                                        let _e8139 = phi_18242_;
                                                        local_136 = _e8137;
                                                        if (_e8133.member < _e8133.member_1) {
                                                            phi_18236_ = type_9((_e8133.member + 1u), _e8133.member_1);
                                                            phi_18265_ = type_9(1u, _e8133.member);
                                                        } else {
                                                            phi_18236_ = _e8133;
                                                            phi_18265_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e8151 = phi_18236_;
                                                        let _e8153 = phi_18265_;
                                                        if (bitcast<i32>(_e8153.member) != 0i) {
                                                            let _e8157 = (1f - _e8139);
                                                            let _e8170 = ((_e8124 * ((((_e6012 * _e8157) + (_e6035 * _e8139)) * (_e8157 * _e8157)) + (((_e6058 * _e8157) + (_e6069 * _e8139)) * (_e8139 * _e8139)))) - _e6386);
                                                            if (_e8170 > 0f) {
                                                                phi_18290_ = _e8135;
                                                                phi_18291_ = _e8139;
                                                            } else {
                                                                phi_18290_ = _e8139;
                                                                phi_18291_ = _e8137;
                                                            }
                                                            let _e8173 = phi_18290_;
                                                            let _e8175 = phi_18291_;
                                                            let _e8177 = ((_e8173 - _e8175) > _e6393);
                                                            if _e8177 {
                                                                let _e8178 = (1f - _e8139);
                                                                let _e8190 = (-(_e8170) / (_e8124 * (((((_e6035 - (3f * _e6012)) * _e8178) + (_e8127 * _e8139)) * _e8178) + (((_e8127 * _e8178) + (((3f * _e6069) - _e6058) * _e8139)) * _e8139))));
                                                                if (_e8170 > 0f) {
                                                                    phi_18317_ = (0.5f * _e6393);
                                                                } else {
                                                                    phi_18317_ = -((0.5f * _e6393));
                                                                }
                                                                let _e8196 = phi_18317_;
                                                                let _e8198 = ((_e8139 + _e8190) + _e8196);
                                                                if (_e8198 > _e8175) {
                                                                    if (_e8198 < _e8173) {
                                                                        if (_e8190 < 0f) {
                                                                            phi_18333_ = -(_e8190);
                                                                        } else {
                                                                            phi_18333_ = _e8190;
                                                                        }
                                                                        let _e8204 = phi_18333_;
                                                                        if (_e8204 < (0.5f * (_e8173 - _e8175))) {
                                                                            phi_18340_ = false;
                                                                        } else {
                                                                            phi_18340_ = true;
                                                                        }
                                                                        let _e8209 = phi_18340_;
                                                                        phi_18341_ = _e8209;
                                                                    } else {
                                                                        phi_18341_ = true;
                                                                    }
                                                                    let _e8211 = phi_18341_;
                                                                    phi_18342_ = _e8211;
                                                                } else {
                                                                    phi_18342_ = true;
                                                                }
                                                                let _e8213 = phi_18342_;
                                                                if _e8213 {
                                                                    phi_18348_ = (0.5f * (_e8175 + _e8173));
                                                                } else {
                                                                    phi_18348_ = _e8198;
                                                                }
                                                                let _e8217 = phi_18348_;
                                                                phi_18349_ = _e8217;
                                                                phi_18350_ = false;
                                                            } else {
                                                                phi_18349_ = f32();
                                                                phi_18350_ = true;
                                                            }
                                                            let _e8219 = phi_18349_;
                                                            let _e8221 = phi_18350_;
                                                            phi_18239_ = _e8173;
                                                            phi_18241_ = _e8175;
                                                            phi_18243_ = _e8219;
                                                            phi_18351_ = _e8175;
                                                            phi_18352_ = _e8177;
                                                            phi_18353_ = _e8221;
                                                        } else {
                                                            phi_18239_ = f32();
                                                            phi_18241_ = f32();
                                                            phi_18243_ = f32();
                                                            phi_18351_ = f32();
                                                            phi_18352_ = false;
                                                            phi_18353_ = false;
                                                        }
                                                        let _e8223 = phi_18239_;
                                                        let _e8225 = phi_18241_;
                                                        let _e8227 = phi_18243_;
                                                        let _e8229 = phi_18351_;
                                                        let _e8231 = phi_18352_;
                                                        let _e8233 = phi_18353_;
                                                        local_90 = _e8233;
                                                        local_135 = _e8229;
                                                        continue;
                                                        continuing {
                                                            phi_18235_ = _e8151;
                                                            phi_18238_ = _e8223;
                                                            phi_18240_ = _e8225;
                                                            phi_18242_ = _e8227;
                                                            break if !(_e8231);
                                                        }
                                                    }
                                                    let _e8236 = local_90;
                                                    if _e8236 {
                                                        let _e16229 = local_135;
                                                        phi_18357_ = _e16229;
                                                    } else {
                                                        let _e16231 = local_136;
                                                        phi_18357_ = _e16231;
                                                    }
                                                    let _e8238 = phi_18357_;
                                                    phi_18358_ = _e8238;
                                                } else {
                                                    phi_18358_ = _e8056;
                                                }
                                                let _e8240 = phi_18358_;
                                                if _e8097 {
                                                    if (_e8087 < 0f) {
                                                        phi_18366_ = -1f;
                                                    } else {
                                                        phi_18366_ = 1f;
                                                    }
                                                    let _e8243 = phi_18366_;
                                                    phi_18370_ = type_9(0u, 64u);
                                                    phi_18373_ = (_e6393 + _e6393);
                                                    loop {
                                                        let _e8246 = phi_18370_;
                                                        let _e8248 = phi_18373_;
                                                        if (_e8246.member < _e8246.member_1) {
                                                            phi_18371_ = type_9((_e8246.member + 1u), _e8246.member_1);
                                                            phi_18396_ = type_9(1u, _e8246.member);
                                                        } else {
                                                            phi_18371_ = _e8246;
                                                            phi_18396_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e8260 = phi_18371_;
                                                        let _e8262 = phi_18396_;
                                                        if (bitcast<i32>(_e8262.member) != 0i) {
                                                            let _e8266 = (_e8240 + _e8248);
                                                            if (_e8266 < _e8062) {
                                                                let _e8268 = (1f - _e8266);
                                                                let _e8281 = ((_e8243 * ((((_e6012 * _e8268) + (_e6035 * _e8266)) * (_e8268 * _e8268)) + (((_e6058 * _e8268) + (_e6069 * _e8266)) * (_e8266 * _e8266)))) > _e6386);
                                                                if _e8281 {
                                                                    phi_18426_ = f32();
                                                                    phi_18427_ = false;
                                                                } else {
                                                                    phi_18426_ = (_e8248 + _e8248);
                                                                    phi_18427_ = true;
                                                                }
                                                                let _e8284 = phi_18426_;
                                                                let _e8286 = phi_18427_;
                                                                phi_18428_ = _e8284;
                                                                phi_18429_ = _e8286;
                                                                phi_18430_ = _e8281;
                                                                phi_18431_ = false;
                                                            } else {
                                                                phi_18428_ = f32();
                                                                phi_18429_ = false;
                                                                phi_18430_ = false;
                                                                phi_18431_ = true;
                                                            }
                                                            let _e8288 = phi_18428_;
                                                            let _e8290 = phi_18429_;
                                                            let _e8292 = phi_18430_;
                                                            let _e8294 = phi_18431_;
                                                            phi_18432_ = _e8266;
                                                            phi_18374_ = _e8288;
                                                            phi_18433_ = _e8290;
                                                            phi_18434_ = _e8292;
                                                            phi_18435_ = _e8294;
                                                            phi_18436_ = false;
                                                        } else {
                                                            phi_18432_ = f32();
                                                            phi_18374_ = f32();
                                                            phi_18433_ = false;
                                                            phi_18434_ = false;
                                                            phi_18435_ = false;
                                                            phi_18436_ = true;
                                                        }
                                                        let _e8296 = phi_18432_;
                                                        let _e8298 = phi_18374_;
                                                        let _e8300 = phi_18433_;
                                                        let _e8302 = phi_18434_;
                                                        let _e8304 = phi_18435_;
                                                        let _e8306 = phi_18436_;
                                                        local_91 = _e8302;
                                                        local_137 = _e8304;
                                                        local_138 = _e8306;
                                                        local_139 = _e8296;
                                                        continue;
                                                        continuing {
                                                            phi_18370_ = _e8260;
                                                            phi_18373_ = _e8298;
                                                            break if !(_e8300);
                                                        }
                                                    }
                                                    let _e8309 = local_91;
                                                    if _e8309 {
                                                        phi_18440_ = false;
                                                        phi_18441_ = false;
                                                    } else {
                                                        let _e16253 = local_137;
                                                        phi_18440_ = _e16253;
                                                        let _e16256 = local_138;
                                                        phi_18441_ = _e16256;
                                                    }
                                                    let _e8311 = phi_18440_;
                                                    let _e8313 = phi_18441_;
                                                    if _e8311 {
                                                        phi_18445_ = true;
                                                    } else {
                                                        phi_18445_ = _e8313;
                                                    }
                                                    let _e8315 = phi_18445_;
                                                    if _e8315 {
                                                        phi_18449_ = _e8062;
                                                    } else {
                                                        let _e16260 = local_139;
                                                        phi_18449_ = _e16260;
                                                    }
                                                    let _e8317 = phi_18449_;
                                                    phi_18450_ = _e8317;
                                                } else {
                                                    phi_18450_ = _e8062;
                                                }
                                                let _e8319 = phi_18450_;
                                                phi_18452_ = type_47(_e8240, _e8319, _e8110);
                                            } else {
                                                phi_18452_ = _e8119;
                                            }
                                            let _e8322 = phi_18452_;
                                            if (_e8322.member > _e8322.member_1) {
                                                phi_22245_ = bool();
                                                phi_22246_ = f32();
                                                phi_22247_ = f32();
                                                phi_22248_ = true;
                                                phi_22249_ = false;
                                                phi_22250_ = false;
                                                phi_22251_ = false;
                                            } else {
                                                let _e8329 = ((_e8322.member_1 - _e8322.member) * 0.5f);
                                                let _e8330 = (_e8322.member + _e8329);
                                                let _e8332 = (_e8329 + (0.000000059604645f * 4f));
                                                let _e8334 = local_18.member_3;
                                                let _e8337 = local_18.member[0u];
                                                if (_e8337[0] < 0f) {
                                                    phi_18481_ = -(_e8337[0]);
                                                } else {
                                                    phi_18481_ = _e8337[0];
                                                }
                                                let _e8344 = phi_18481_;
                                                if (_e8337[1] < 0f) {
                                                    phi_18488_ = -(_e8337[1]);
                                                } else {
                                                    phi_18488_ = _e8337[1];
                                                }
                                                let _e8348 = phi_18488_;
                                                if (_e8344 > _e8348) {
                                                    phi_18493_ = _e8344;
                                                } else {
                                                    phi_18493_ = _e8348;
                                                }
                                                let _e8351 = phi_18493_;
                                                if (_e8337[2] < 0f) {
                                                    phi_18500_ = -(_e8337[2]);
                                                } else {
                                                    phi_18500_ = _e8337[2];
                                                }
                                                let _e8355 = phi_18500_;
                                                if (_e8351 > _e8355) {
                                                    phi_18505_ = _e8351;
                                                } else {
                                                    phi_18505_ = _e8355;
                                                }
                                                let _e8358 = phi_18505_;
                                                let _e8360 = local_18.member[1u];
                                                if (_e8360[0] < 0f) {
                                                    phi_18518_ = -(_e8360[0]);
                                                } else {
                                                    phi_18518_ = _e8360[0];
                                                }
                                                let _e8367 = phi_18518_;
                                                if (_e8360[1] < 0f) {
                                                    phi_18525_ = -(_e8360[1]);
                                                } else {
                                                    phi_18525_ = _e8360[1];
                                                }
                                                let _e8371 = phi_18525_;
                                                if (_e8367 > _e8371) {
                                                    phi_18530_ = _e8367;
                                                } else {
                                                    phi_18530_ = _e8371;
                                                }
                                                let _e8374 = phi_18530_;
                                                if (_e8360[2] < 0f) {
                                                    phi_18537_ = -(_e8360[2]);
                                                } else {
                                                    phi_18537_ = _e8360[2];
                                                }
                                                let _e8378 = phi_18537_;
                                                if (_e8374 > _e8378) {
                                                    phi_18542_ = _e8374;
                                                } else {
                                                    phi_18542_ = _e8378;
                                                }
                                                let _e8381 = phi_18542_;
                                                if (_e8358 > _e8381) {
                                                    phi_18547_ = _e8358;
                                                } else {
                                                    phi_18547_ = _e8381;
                                                }
                                                let _e8384 = phi_18547_;
                                                let _e8387 = local_18.member[0u];
                                                let _e8392 = local_18.member[1u];
                                                let _e8402 = (_e8387[0] + ((_e8392[0] - _e8387[0]) * _e8330));
                                                let _e8403 = (_e8387[1] + ((_e8392[1] - _e8387[1]) * _e8330));
                                                let _e8404 = (_e8387[2] + ((_e8392[2] - _e8387[2]) * _e8330));
                                                let _e8406 = local_18.member[1u];
                                                let _e8411 = local_18.member[0u];
                                                let _e8415 = (_e8406[0] - _e8411[0]);
                                                let _e8416 = (_e8406[1] - _e8411[1]);
                                                let _e8417 = (_e8406[2] - _e8411[2]);
                                                if (_e8415 < 0f) {
                                                    phi_18606_ = -(_e8415);
                                                } else {
                                                    phi_18606_ = _e8415;
                                                }
                                                let _e8421 = phi_18606_;
                                                if (_e8416 < 0f) {
                                                    phi_18612_ = -(_e8416);
                                                } else {
                                                    phi_18612_ = _e8416;
                                                }
                                                let _e8425 = phi_18612_;
                                                if (_e8421 > _e8425) {
                                                    phi_18617_ = _e8421;
                                                } else {
                                                    phi_18617_ = _e8425;
                                                }
                                                let _e8428 = phi_18617_;
                                                if (_e8417 < 0f) {
                                                    phi_18623_ = -(_e8417);
                                                } else {
                                                    phi_18623_ = _e8417;
                                                }
                                                let _e8432 = phi_18623_;
                                                if (_e8428 > _e8432) {
                                                    phi_18628_ = _e8428;
                                                } else {
                                                    phi_18628_ = _e8432;
                                                }
                                                let _e8435 = phi_18628_;
                                                let _e8441 = ((((_e8332 * _e8435) * 1.01f) + ((_e8384 + _e8334) * (0.000000059604645f * 8f))) + _e8334);
                                                if (_e8402 < 0f) {
                                                    phi_18640_ = -(_e8402);
                                                } else {
                                                    phi_18640_ = _e8402;
                                                }
                                                let _e8445 = phi_18640_;
                                                if (_e8403 < 0f) {
                                                    phi_18646_ = -(_e8403);
                                                } else {
                                                    phi_18646_ = _e8403;
                                                }
                                                let _e8449 = phi_18646_;
                                                if (_e8445 > _e8449) {
                                                    phi_18651_ = _e8445;
                                                } else {
                                                    phi_18651_ = _e8449;
                                                }
                                                let _e8452 = phi_18651_;
                                                if (_e8404 < 0f) {
                                                    phi_18657_ = -(_e8404);
                                                } else {
                                                    phi_18657_ = _e8404;
                                                }
                                                let _e8456 = phi_18657_;
                                                if (_e8452 > _e8456) {
                                                    phi_18662_ = _e8452;
                                                } else {
                                                    phi_18662_ = _e8456;
                                                }
                                                let _e8459 = phi_18662_;
                                                local_2 = type_24(array<f32, 3>(_e8402, _e8403, _e8404), _e8441, (_e8459 + _e8441));
                                                let _e8465 = local_18.member_3;
                                                let _e8467 = local_18.member_1[0u];
                                                if (_e8467[0] < 0f) {
                                                    phi_18688_ = -(_e8467[0]);
                                                } else {
                                                    phi_18688_ = _e8467[0];
                                                }
                                                let _e8474 = phi_18688_;
                                                if (_e8467[1] < 0f) {
                                                    phi_18695_ = -(_e8467[1]);
                                                } else {
                                                    phi_18695_ = _e8467[1];
                                                }
                                                let _e8478 = phi_18695_;
                                                if (_e8474 > _e8478) {
                                                    phi_18700_ = _e8474;
                                                } else {
                                                    phi_18700_ = _e8478;
                                                }
                                                let _e8481 = phi_18700_;
                                                if (_e8467[2] < 0f) {
                                                    phi_18707_ = -(_e8467[2]);
                                                } else {
                                                    phi_18707_ = _e8467[2];
                                                }
                                                let _e8485 = phi_18707_;
                                                if (_e8481 > _e8485) {
                                                    phi_18712_ = _e8481;
                                                } else {
                                                    phi_18712_ = _e8485;
                                                }
                                                let _e8488 = phi_18712_;
                                                let _e8490 = local_18.member_1[1u];
                                                if (_e8490[0] < 0f) {
                                                    phi_18725_ = -(_e8490[0]);
                                                } else {
                                                    phi_18725_ = _e8490[0];
                                                }
                                                let _e8497 = phi_18725_;
                                                if (_e8490[1] < 0f) {
                                                    phi_18732_ = -(_e8490[1]);
                                                } else {
                                                    phi_18732_ = _e8490[1];
                                                }
                                                let _e8501 = phi_18732_;
                                                if (_e8497 > _e8501) {
                                                    phi_18737_ = _e8497;
                                                } else {
                                                    phi_18737_ = _e8501;
                                                }
                                                let _e8504 = phi_18737_;
                                                if (_e8490[2] < 0f) {
                                                    phi_18744_ = -(_e8490[2]);
                                                } else {
                                                    phi_18744_ = _e8490[2];
                                                }
                                                let _e8508 = phi_18744_;
                                                if (_e8504 > _e8508) {
                                                    phi_18749_ = _e8504;
                                                } else {
                                                    phi_18749_ = _e8508;
                                                }
                                                let _e8511 = phi_18749_;
                                                if (_e8488 > _e8511) {
                                                    phi_18754_ = _e8488;
                                                } else {
                                                    phi_18754_ = _e8511;
                                                }
                                                let _e8514 = phi_18754_;
                                                let _e8517 = local_18.member_1[0u];
                                                let _e8522 = local_18.member_1[1u];
                                                let _e8532 = (_e8517[0] + ((_e8522[0] - _e8517[0]) * _e8330));
                                                let _e8533 = (_e8517[1] + ((_e8522[1] - _e8517[1]) * _e8330));
                                                let _e8534 = (_e8517[2] + ((_e8522[2] - _e8517[2]) * _e8330));
                                                let _e8536 = local_18.member_1[1u];
                                                let _e8541 = local_18.member_1[0u];
                                                let _e8545 = (_e8536[0] - _e8541[0]);
                                                let _e8546 = (_e8536[1] - _e8541[1]);
                                                let _e8547 = (_e8536[2] - _e8541[2]);
                                                if (_e8545 < 0f) {
                                                    phi_18813_ = -(_e8545);
                                                } else {
                                                    phi_18813_ = _e8545;
                                                }
                                                let _e8551 = phi_18813_;
                                                if (_e8546 < 0f) {
                                                    phi_18819_ = -(_e8546);
                                                } else {
                                                    phi_18819_ = _e8546;
                                                }
                                                let _e8555 = phi_18819_;
                                                if (_e8551 > _e8555) {
                                                    phi_18824_ = _e8551;
                                                } else {
                                                    phi_18824_ = _e8555;
                                                }
                                                let _e8558 = phi_18824_;
                                                if (_e8547 < 0f) {
                                                    phi_18830_ = -(_e8547);
                                                } else {
                                                    phi_18830_ = _e8547;
                                                }
                                                let _e8562 = phi_18830_;
                                                if (_e8558 > _e8562) {
                                                    phi_18835_ = _e8558;
                                                } else {
                                                    phi_18835_ = _e8562;
                                                }
                                                let _e8565 = phi_18835_;
                                                let _e8571 = ((((_e8332 * _e8565) * 1.01f) + ((_e8514 + _e8465) * (0.000000059604645f * 8f))) + _e8465);
                                                if (_e8532 < 0f) {
                                                    phi_18847_ = -(_e8532);
                                                } else {
                                                    phi_18847_ = _e8532;
                                                }
                                                let _e8575 = phi_18847_;
                                                if (_e8533 < 0f) {
                                                    phi_18853_ = -(_e8533);
                                                } else {
                                                    phi_18853_ = _e8533;
                                                }
                                                let _e8579 = phi_18853_;
                                                if (_e8575 > _e8579) {
                                                    phi_18858_ = _e8575;
                                                } else {
                                                    phi_18858_ = _e8579;
                                                }
                                                let _e8582 = phi_18858_;
                                                if (_e8534 < 0f) {
                                                    phi_18864_ = -(_e8534);
                                                } else {
                                                    phi_18864_ = _e8534;
                                                }
                                                let _e8586 = phi_18864_;
                                                if (_e8582 > _e8586) {
                                                    phi_18869_ = _e8582;
                                                } else {
                                                    phi_18869_ = _e8586;
                                                }
                                                let _e8589 = phi_18869_;
                                                local_3 = type_24(array<f32, 3>(_e8532, _e8533, _e8534), _e8571, (_e8589 + _e8571));
                                                let _e8595 = local_18.member_3;
                                                let _e8597 = local_18.member_2[0u];
                                                if (_e8597[0] < 0f) {
                                                    phi_18895_ = -(_e8597[0]);
                                                } else {
                                                    phi_18895_ = _e8597[0];
                                                }
                                                let _e8604 = phi_18895_;
                                                if (_e8597[1] < 0f) {
                                                    phi_18902_ = -(_e8597[1]);
                                                } else {
                                                    phi_18902_ = _e8597[1];
                                                }
                                                let _e8608 = phi_18902_;
                                                if (_e8604 > _e8608) {
                                                    phi_18907_ = _e8604;
                                                } else {
                                                    phi_18907_ = _e8608;
                                                }
                                                let _e8611 = phi_18907_;
                                                if (_e8597[2] < 0f) {
                                                    phi_18914_ = -(_e8597[2]);
                                                } else {
                                                    phi_18914_ = _e8597[2];
                                                }
                                                let _e8615 = phi_18914_;
                                                if (_e8611 > _e8615) {
                                                    phi_18919_ = _e8611;
                                                } else {
                                                    phi_18919_ = _e8615;
                                                }
                                                let _e8618 = phi_18919_;
                                                let _e8620 = local_18.member_2[1u];
                                                if (_e8620[0] < 0f) {
                                                    phi_18932_ = -(_e8620[0]);
                                                } else {
                                                    phi_18932_ = _e8620[0];
                                                }
                                                let _e8627 = phi_18932_;
                                                if (_e8620[1] < 0f) {
                                                    phi_18939_ = -(_e8620[1]);
                                                } else {
                                                    phi_18939_ = _e8620[1];
                                                }
                                                let _e8631 = phi_18939_;
                                                if (_e8627 > _e8631) {
                                                    phi_18944_ = _e8627;
                                                } else {
                                                    phi_18944_ = _e8631;
                                                }
                                                let _e8634 = phi_18944_;
                                                if (_e8620[2] < 0f) {
                                                    phi_18951_ = -(_e8620[2]);
                                                } else {
                                                    phi_18951_ = _e8620[2];
                                                }
                                                let _e8638 = phi_18951_;
                                                if (_e8634 > _e8638) {
                                                    phi_18956_ = _e8634;
                                                } else {
                                                    phi_18956_ = _e8638;
                                                }
                                                let _e8641 = phi_18956_;
                                                if (_e8618 > _e8641) {
                                                    phi_18961_ = _e8618;
                                                } else {
                                                    phi_18961_ = _e8641;
                                                }
                                                let _e8644 = phi_18961_;
                                                let _e8647 = local_18.member_2[0u];
                                                let _e8652 = local_18.member_2[1u];
                                                let _e8662 = (_e8647[0] + ((_e8652[0] - _e8647[0]) * _e8330));
                                                let _e8663 = (_e8647[1] + ((_e8652[1] - _e8647[1]) * _e8330));
                                                let _e8664 = (_e8647[2] + ((_e8652[2] - _e8647[2]) * _e8330));
                                                let _e8666 = local_18.member_2[1u];
                                                let _e8671 = local_18.member_2[0u];
                                                let _e8675 = (_e8666[0] - _e8671[0]);
                                                let _e8676 = (_e8666[1] - _e8671[1]);
                                                let _e8677 = (_e8666[2] - _e8671[2]);
                                                if (_e8675 < 0f) {
                                                    phi_19020_ = -(_e8675);
                                                } else {
                                                    phi_19020_ = _e8675;
                                                }
                                                let _e8681 = phi_19020_;
                                                if (_e8676 < 0f) {
                                                    phi_19026_ = -(_e8676);
                                                } else {
                                                    phi_19026_ = _e8676;
                                                }
                                                let _e8685 = phi_19026_;
                                                if (_e8681 > _e8685) {
                                                    phi_19031_ = _e8681;
                                                } else {
                                                    phi_19031_ = _e8685;
                                                }
                                                let _e8688 = phi_19031_;
                                                if (_e8677 < 0f) {
                                                    phi_19037_ = -(_e8677);
                                                } else {
                                                    phi_19037_ = _e8677;
                                                }
                                                let _e8692 = phi_19037_;
                                                if (_e8688 > _e8692) {
                                                    phi_19042_ = _e8688;
                                                } else {
                                                    phi_19042_ = _e8692;
                                                }
                                                let _e8695 = phi_19042_;
                                                let _e8701 = ((((_e8332 * _e8695) * 1.01f) + ((_e8644 + _e8595) * (0.000000059604645f * 8f))) + _e8595);
                                                if (_e8662 < 0f) {
                                                    phi_19054_ = -(_e8662);
                                                } else {
                                                    phi_19054_ = _e8662;
                                                }
                                                let _e8705 = phi_19054_;
                                                if (_e8663 < 0f) {
                                                    phi_19060_ = -(_e8663);
                                                } else {
                                                    phi_19060_ = _e8663;
                                                }
                                                let _e8709 = phi_19060_;
                                                if (_e8705 > _e8709) {
                                                    phi_19065_ = _e8705;
                                                } else {
                                                    phi_19065_ = _e8709;
                                                }
                                                let _e8712 = phi_19065_;
                                                if (_e8664 < 0f) {
                                                    phi_19071_ = -(_e8664);
                                                } else {
                                                    phi_19071_ = _e8664;
                                                }
                                                let _e8716 = phi_19071_;
                                                if (_e8712 > _e8716) {
                                                    phi_19076_ = _e8712;
                                                } else {
                                                    phi_19076_ = _e8716;
                                                }
                                                let _e8719 = phi_19076_;
                                                local_4 = type_24(array<f32, 3>(_e8662, _e8663, _e8664), _e8701, (_e8719 + _e8701));
                                                let _e8724 = local_3.member;
                                                let _e8729 = local_4.member;
                                                let _e8735 = ((_e8724[1] * _e8729[2]) - (_e8724[2] * _e8729[1]));
                                                let _e8738 = ((_e8724[2] * _e8729[0]) - (_e8724[0] * _e8729[2]));
                                                let _e8741 = ((_e8724[0] * _e8729[1]) - (_e8724[1] * _e8729[0]));
                                                if (_e8735 < 0f) {
                                                    phi_19125_ = -(_e8735);
                                                } else {
                                                    phi_19125_ = _e8735;
                                                }
                                                let _e8745 = phi_19125_;
                                                if (_e8738 < 0f) {
                                                    phi_19131_ = -(_e8738);
                                                } else {
                                                    phi_19131_ = _e8738;
                                                }
                                                let _e8749 = phi_19131_;
                                                if (_e8745 > _e8749) {
                                                    if (_e8735 < 0f) {
                                                        phi_19141_ = -(_e8735);
                                                    } else {
                                                        phi_19141_ = _e8735;
                                                    }
                                                    let _e8767 = phi_19141_;
                                                    if (_e8741 < 0f) {
                                                        phi_19147_ = -(_e8741);
                                                    } else {
                                                        phi_19147_ = _e8741;
                                                    }
                                                    let _e8771 = phi_19147_;
                                                    if (_e8767 > _e8771) {
                                                        phi_19152_ = 2u;
                                                        phi_19153_ = 1u;
                                                    } else {
                                                        phi_19152_ = 1u;
                                                        phi_19153_ = 0u;
                                                    }
                                                    let _e8774 = phi_19152_;
                                                    let _e8776 = phi_19153_;
                                                    phi_19172_ = _e8774;
                                                    phi_19173_ = _e8776;
                                                } else {
                                                    if (_e8738 < 0f) {
                                                        phi_19159_ = -(_e8738);
                                                    } else {
                                                        phi_19159_ = _e8738;
                                                    }
                                                    let _e8754 = phi_19159_;
                                                    if (_e8741 < 0f) {
                                                        phi_19165_ = -(_e8741);
                                                    } else {
                                                        phi_19165_ = _e8741;
                                                    }
                                                    let _e8758 = phi_19165_;
                                                    if (_e8754 > _e8758) {
                                                        phi_19170_ = 0u;
                                                        phi_19171_ = 2u;
                                                    } else {
                                                        phi_19170_ = 1u;
                                                        phi_19171_ = 0u;
                                                    }
                                                    let _e8761 = phi_19170_;
                                                    let _e8763 = phi_19171_;
                                                    phi_19172_ = _e8761;
                                                    phi_19173_ = _e8763;
                                                }
                                                let _e8778 = phi_19172_;
                                                let _e8780 = phi_19173_;
                                                let _e8783 = local_3.member[_e8780];
                                                let _e8786 = local_4.member[_e8778];
                                                let _e8790 = local_3.member[_e8778];
                                                let _e8793 = local_4.member[_e8780];
                                                let _e8795 = ((_e8783 * _e8786) - (_e8790 * _e8793));
                                                let _e8797 = local_3.member_1;
                                                let _e8799 = local_4.member_2;
                                                let _e8802 = local_3.member_2;
                                                let _e8804 = local_4.member_1;
                                                let _e8809 = local_3.member_2;
                                                let _e8812 = local_4.member_2;
                                                let _e8820 = local_3.member_2;
                                                let _e8823 = local_4.member_2;
                                                let _e8827 = (((((_e8797 * _e8799) + (_e8802 * _e8804)) * 2.01f) + (((_e8809 * 2f) * (_e8812 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e8820) * (1f + _e8823))));
                                                if (_e8795 < 0f) {
                                                    phi_19242_ = -(_e8795);
                                                } else {
                                                    phi_19242_ = _e8795;
                                                }
                                                let _e8831 = phi_19242_;
                                                if (_e8831 > _e8827) {
                                                    if (_e8795 < 0f) {
                                                        phi_19251_ = -1f;
                                                    } else {
                                                        phi_19251_ = 1f;
                                                    }
                                                    let _e8835 = phi_19251_;
                                                    let _e8838 = local_2.member[_e8780];
                                                    let _e8841 = local_4.member[_e8778];
                                                    let _e8845 = local_2.member[_e8778];
                                                    let _e8848 = local_4.member[_e8780];
                                                    let _e8852 = local_2.member_1;
                                                    let _e8854 = local_4.member_2;
                                                    let _e8857 = local_2.member_2;
                                                    let _e8859 = local_4.member_1;
                                                    let _e8864 = local_2.member_2;
                                                    let _e8867 = local_4.member_2;
                                                    let _e8875 = local_2.member_2;
                                                    let _e8878 = local_4.member_2;
                                                    let _e8882 = (((((_e8852 * _e8854) + (_e8857 * _e8859)) * 2.01f) + (((_e8864 * 2f) * (_e8867 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e8875) * (1f + _e8878))));
                                                    let _e8885 = local_3.member[_e8780];
                                                    let _e8888 = local_2.member[_e8778];
                                                    let _e8892 = local_3.member[_e8778];
                                                    let _e8895 = local_2.member[_e8780];
                                                    let _e8899 = local_3.member_1;
                                                    let _e8901 = local_2.member_2;
                                                    let _e8904 = local_3.member_2;
                                                    let _e8906 = local_2.member_1;
                                                    let _e8911 = local_3.member_2;
                                                    let _e8914 = local_2.member_2;
                                                    let _e8922 = local_3.member_2;
                                                    let _e8925 = local_2.member_2;
                                                    let _e8929 = (((((_e8899 * _e8901) + (_e8904 * _e8906)) * 2.01f) + (((_e8911 * 2f) * (_e8914 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e8922) * (1f + _e8925))));
                                                    let _e8930 = (_e8795 * _e8835);
                                                    let _e8931 = (((_e8838 * _e8841) - (_e8845 * _e8848)) * _e8835);
                                                    let _e8932 = (((_e8885 * _e8888) - (_e8892 * _e8895)) * _e8835);
                                                    if (_e8930 < 0f) {
                                                        phi_19386_ = -(_e8930);
                                                    } else {
                                                        phi_19386_ = _e8930;
                                                    }
                                                    let _e8936 = phi_19386_;
                                                    if (_e8931 < 0f) {
                                                        phi_19392_ = -(_e8931);
                                                    } else {
                                                        phi_19392_ = _e8931;
                                                    }
                                                    let _e8940 = phi_19392_;
                                                    if (_e8932 < 0f) {
                                                        phi_19399_ = -(_e8932);
                                                    } else {
                                                        phi_19399_ = _e8932;
                                                    }
                                                    let _e8945 = phi_19399_;
                                                    let _e8948 = (((_e8936 + _e8940) + _e8945) * (0.000000059604645f * 4f));
                                                    if (_e316.member != 0u) {
                                                        phi_19434_ = array<type_26, 4>(type_26(_e8931, _e8882), type_26(_e8932, _e8929), type_26((_e8930 - _e8931), ((_e8827 + _e8882) + _e8948)), type_26((_e8930 - _e8932), ((_e8827 + _e8929) + _e8948)));
                                                    } else {
                                                        let _e8951 = ((_e8930 - _e8931) - _e8932);
                                                        let _e8954 = (((_e8827 + _e8882) + _e8929) + _e8948);
                                                        phi_19434_ = array<type_26, 4>(type_26(_e8931, _e8882), type_26(_e8932, _e8929), type_26(_e8951, _e8954), type_26(_e8951, _e8954));
                                                    }
                                                    let _e8972 = phi_19434_;
                                                    local_5 = array<type_26, 4>(type_26(_e8972[0].member, _e8972[0].member_1), type_26(_e8972[1].member, _e8972[1].member_1), type_26(_e8972[2].member, _e8972[2].member_1), type_26(_e8972[3].member, _e8972[3].member_1));
                                                    phi_19454_ = type_9(0u, 4u);
                                                    phi_19457_ = true;
                                                    loop {
                                                        let _e8991 = phi_19454_;
                                                        let _e8993 = phi_19457_;
                                                        local_93 = _e8993;
                                                        if (_e8991.member < _e8991.member_1) {
                                                            phi_19455_ = type_9((_e8991.member + 1u), _e8991.member_1);
                                                            phi_19480_ = type_9(1u, _e8991.member);
                                                        } else {
                                                            phi_19455_ = _e8991;
                                                            phi_19480_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e9005 = phi_19455_;
                                                        let _e9007 = phi_19480_;
                                                        if (bitcast<i32>(_e9007.member) != 0i) {
                                                            let _e9014 = local_5[_e9007.member_1].member;
                                                            let _e9017 = local_5[_e9007.member_1].member_1;
                                                            let _e9019 = (_e9014 < -(_e9017));
                                                            if _e9019 {
                                                                phi_19507_ = bool();
                                                                phi_19508_ = false;
                                                            } else {
                                                                phi_19507_ = (_e8993 && (_e9014 > _e9017));
                                                                phi_19508_ = true;
                                                            }
                                                            let _e9023 = phi_19507_;
                                                            let _e9025 = phi_19508_;
                                                            phi_19458_ = _e9023;
                                                            phi_19509_ = _e9025;
                                                            phi_19510_ = _e9019;
                                                        } else {
                                                            phi_19458_ = bool();
                                                            phi_19509_ = false;
                                                            phi_19510_ = false;
                                                        }
                                                        let _e9027 = phi_19458_;
                                                        let _e9029 = phi_19509_;
                                                        let _e9031 = phi_19510_;
                                                        local_92 = _e9031;
                                                        continue;
                                                        continuing {
                                                            phi_19454_ = _e9005;
                                                            phi_19457_ = _e9027;
                                                            break if !(_e9029);
                                                        }
                                                    }
                                                    let _e9034 = local_92;
                                                    if _e9034 {
                                                        phi_19514_ = false;
                                                    } else {
                                                        phi_19514_ = true;
                                                    }
                                                    let _e9036 = phi_19514_;
                                                    if _e9036 {
                                                        let _e9038 = local_93;
                                                        if _e9038 {
                                                            phi_19521_ = 1u;
                                                        } else {
                                                            phi_19521_ = 2u;
                                                        }
                                                        let _e9040 = phi_19521_;
                                                        phi_19522_ = _e9040;
                                                        phi_19523_ = false;
                                                    } else {
                                                        phi_19522_ = u32();
                                                        phi_19523_ = true;
                                                    }
                                                    let _e9042 = phi_19522_;
                                                    let _e9044 = phi_19523_;
                                                    phi_19524_ = _e9042;
                                                    phi_19525_ = 0u;
                                                    phi_19526_ = _e9044;
                                                } else {
                                                    phi_19524_ = u32();
                                                    phi_19525_ = 2u;
                                                    phi_19526_ = true;
                                                }
                                                let _e9046 = phi_19524_;
                                                let _e9048 = phi_19525_;
                                                let _e9050 = phi_19526_;
                                                if _e9050 {
                                                    phi_19530_ = _e9048;
                                                } else {
                                                    phi_19530_ = _e9046;
                                                }
                                                let _e9052 = phi_19530_;
                                                let _e9053 = (_e9052 == 0u);
                                                if _e9053 {
                                                    phi_22239_ = bool();
                                                    phi_22240_ = f32();
                                                    phi_22241_ = f32();
                                                    phi_22242_ = false;
                                                    phi_22243_ = false;
                                                    phi_22244_ = false;
                                                } else {
                                                    if (_e9052 == 1u) {
                                                        phi_19540_ = _e8322.member_2;
                                                    } else {
                                                        phi_19540_ = false;
                                                    }
                                                    let _e9057 = phi_19540_;
                                                    let _e9058 = (_e5603 * 0.99f);
                                                    if _e9057 {
                                                        if ((_e8322.member_1 - _e8322.member) <= _e9058) {
                                                            phi_19552_ = false;
                                                        } else {
                                                            phi_19552_ = true;
                                                        }
                                                        let _e9064 = phi_19552_;
                                                        phi_19553_ = _e9064;
                                                    } else {
                                                        phi_19553_ = true;
                                                    }
                                                    let _e9066 = phi_19553_;
                                                    if _e9066 {
                                                        let _e9071 = local_18.member[0u];
                                                        let _e9078 = local_18.member_1[0u];
                                                        let _e9084 = local_18.member_2[0u];
                                                        let _e9088 = (_e9071[0] - _e9078[0]);
                                                        let _e9089 = (_e9071[1] - _e9078[1]);
                                                        let _e9090 = (_e9071[2] - _e9078[2]);
                                                        if (_e316.member == 0u) {
                                                            phi_19614_ = array<f32, 3>(_e9071[0], _e9071[1], _e9071[2]);
                                                        } else {
                                                            phi_19614_ = array<f32, 3>((_e9088 - _e9084[0]), (_e9089 - _e9084[1]), (_e9090 - _e9084[2]));
                                                        }
                                                        let _e9097 = phi_19614_;
                                                        let _e9103 = local_18.member[1u];
                                                        let _e9110 = local_18.member_1[1u];
                                                        let _e9116 = local_18.member_2[1u];
                                                        let _e9120 = (_e9103[0] - _e9110[0]);
                                                        let _e9121 = (_e9103[1] - _e9110[1]);
                                                        let _e9122 = (_e9103[2] - _e9110[2]);
                                                        if (_e316.member == 0u) {
                                                            phi_19679_ = array<f32, 3>(_e9103[0], _e9103[1], _e9103[2]);
                                                        } else {
                                                            phi_19679_ = array<f32, 3>((_e9120 - _e9116[0]), (_e9121 - _e9116[1]), (_e9122 - _e9116[2]));
                                                        }
                                                        let _e9129 = phi_19679_;
                                                        let _e9135 = local_18.member[0u];
                                                        if (_e9135[0] < 0f) {
                                                            phi_19701_ = -(_e9135[0]);
                                                        } else {
                                                            phi_19701_ = _e9135[0];
                                                        }
                                                        let _e9142 = phi_19701_;
                                                        if (_e9135[1] < 0f) {
                                                            phi_19708_ = -(_e9135[1]);
                                                        } else {
                                                            phi_19708_ = _e9135[1];
                                                        }
                                                        let _e9146 = phi_19708_;
                                                        if (_e9142 > _e9146) {
                                                            phi_19713_ = _e9142;
                                                        } else {
                                                            phi_19713_ = _e9146;
                                                        }
                                                        let _e9149 = phi_19713_;
                                                        if (_e9135[2] < 0f) {
                                                            phi_19720_ = -(_e9135[2]);
                                                        } else {
                                                            phi_19720_ = _e9135[2];
                                                        }
                                                        let _e9153 = phi_19720_;
                                                        if (_e9149 > _e9153) {
                                                            phi_19725_ = _e9149;
                                                        } else {
                                                            phi_19725_ = _e9153;
                                                        }
                                                        let _e9156 = phi_19725_;
                                                        let _e9159 = local_18.member[1u];
                                                        if (_e9159[0] < 0f) {
                                                            phi_19738_ = -(_e9159[0]);
                                                        } else {
                                                            phi_19738_ = _e9159[0];
                                                        }
                                                        let _e9166 = phi_19738_;
                                                        if (_e9159[1] < 0f) {
                                                            phi_19745_ = -(_e9159[1]);
                                                        } else {
                                                            phi_19745_ = _e9159[1];
                                                        }
                                                        let _e9170 = phi_19745_;
                                                        if (_e9166 > _e9170) {
                                                            phi_19750_ = _e9166;
                                                        } else {
                                                            phi_19750_ = _e9170;
                                                        }
                                                        let _e9173 = phi_19750_;
                                                        if (_e9159[2] < 0f) {
                                                            phi_19757_ = -(_e9159[2]);
                                                        } else {
                                                            phi_19757_ = _e9159[2];
                                                        }
                                                        let _e9177 = phi_19757_;
                                                        if (_e9173 > _e9177) {
                                                            phi_19762_ = _e9173;
                                                        } else {
                                                            phi_19762_ = _e9177;
                                                        }
                                                        let _e9180 = phi_19762_;
                                                        if (_e9156 > _e9180) {
                                                            phi_19767_ = _e9156;
                                                        } else {
                                                            phi_19767_ = _e9180;
                                                        }
                                                        let _e9183 = phi_19767_;
                                                        let _e9185 = local_18.member_3;
                                                        let _e9189 = local_18.member_1[0u];
                                                        if (_e9189[0] < 0f) {
                                                            phi_19784_ = -(_e9189[0]);
                                                        } else {
                                                            phi_19784_ = _e9189[0];
                                                        }
                                                        let _e9196 = phi_19784_;
                                                        if (_e9189[1] < 0f) {
                                                            phi_19791_ = -(_e9189[1]);
                                                        } else {
                                                            phi_19791_ = _e9189[1];
                                                        }
                                                        let _e9200 = phi_19791_;
                                                        if (_e9196 > _e9200) {
                                                            phi_19796_ = _e9196;
                                                        } else {
                                                            phi_19796_ = _e9200;
                                                        }
                                                        let _e9203 = phi_19796_;
                                                        if (_e9189[2] < 0f) {
                                                            phi_19803_ = -(_e9189[2]);
                                                        } else {
                                                            phi_19803_ = _e9189[2];
                                                        }
                                                        let _e9207 = phi_19803_;
                                                        if (_e9203 > _e9207) {
                                                            phi_19808_ = _e9203;
                                                        } else {
                                                            phi_19808_ = _e9207;
                                                        }
                                                        let _e9210 = phi_19808_;
                                                        let _e9213 = local_18.member_1[1u];
                                                        if (_e9213[0] < 0f) {
                                                            phi_19822_ = -(_e9213[0]);
                                                        } else {
                                                            phi_19822_ = _e9213[0];
                                                        }
                                                        let _e9220 = phi_19822_;
                                                        if (_e9213[1] < 0f) {
                                                            phi_19829_ = -(_e9213[1]);
                                                        } else {
                                                            phi_19829_ = _e9213[1];
                                                        }
                                                        let _e9224 = phi_19829_;
                                                        if (_e9220 > _e9224) {
                                                            phi_19834_ = _e9220;
                                                        } else {
                                                            phi_19834_ = _e9224;
                                                        }
                                                        let _e9227 = phi_19834_;
                                                        if (_e9213[2] < 0f) {
                                                            phi_19841_ = -(_e9213[2]);
                                                        } else {
                                                            phi_19841_ = _e9213[2];
                                                        }
                                                        let _e9231 = phi_19841_;
                                                        if (_e9227 > _e9231) {
                                                            phi_19846_ = _e9227;
                                                        } else {
                                                            phi_19846_ = _e9231;
                                                        }
                                                        let _e9234 = phi_19846_;
                                                        if (_e9210 > _e9234) {
                                                            phi_19851_ = _e9210;
                                                        } else {
                                                            phi_19851_ = _e9234;
                                                        }
                                                        let _e9237 = phi_19851_;
                                                        let _e9239 = local_18.member_3;
                                                        let _e9243 = local_18.member_2[0u];
                                                        if (_e9243[0] < 0f) {
                                                            phi_19868_ = -(_e9243[0]);
                                                        } else {
                                                            phi_19868_ = _e9243[0];
                                                        }
                                                        let _e9250 = phi_19868_;
                                                        if (_e9243[1] < 0f) {
                                                            phi_19875_ = -(_e9243[1]);
                                                        } else {
                                                            phi_19875_ = _e9243[1];
                                                        }
                                                        let _e9254 = phi_19875_;
                                                        if (_e9250 > _e9254) {
                                                            phi_19880_ = _e9250;
                                                        } else {
                                                            phi_19880_ = _e9254;
                                                        }
                                                        let _e9257 = phi_19880_;
                                                        if (_e9243[2] < 0f) {
                                                            phi_19887_ = -(_e9243[2]);
                                                        } else {
                                                            phi_19887_ = _e9243[2];
                                                        }
                                                        let _e9261 = phi_19887_;
                                                        if (_e9257 > _e9261) {
                                                            phi_19892_ = _e9257;
                                                        } else {
                                                            phi_19892_ = _e9261;
                                                        }
                                                        let _e9264 = phi_19892_;
                                                        let _e9267 = local_18.member_2[1u];
                                                        if (_e9267[0] < 0f) {
                                                            phi_19906_ = -(_e9267[0]);
                                                        } else {
                                                            phi_19906_ = _e9267[0];
                                                        }
                                                        let _e9274 = phi_19906_;
                                                        if (_e9267[1] < 0f) {
                                                            phi_19913_ = -(_e9267[1]);
                                                        } else {
                                                            phi_19913_ = _e9267[1];
                                                        }
                                                        let _e9278 = phi_19913_;
                                                        if (_e9274 > _e9278) {
                                                            phi_19918_ = _e9274;
                                                        } else {
                                                            phi_19918_ = _e9278;
                                                        }
                                                        let _e9281 = phi_19918_;
                                                        if (_e9267[2] < 0f) {
                                                            phi_19925_ = -(_e9267[2]);
                                                        } else {
                                                            phi_19925_ = _e9267[2];
                                                        }
                                                        let _e9285 = phi_19925_;
                                                        if (_e9281 > _e9285) {
                                                            phi_19930_ = _e9281;
                                                        } else {
                                                            phi_19930_ = _e9285;
                                                        }
                                                        let _e9288 = phi_19930_;
                                                        if (_e9264 > _e9288) {
                                                            phi_19935_ = _e9264;
                                                        } else {
                                                            phi_19935_ = _e9288;
                                                        }
                                                        let _e9291 = phi_19935_;
                                                        let _e9293 = local_18.member_3;
                                                        let _e9300 = local_18.member_3;
                                                        let _e9305 = (_e5603 * 0.00390625f);
                                                        local = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                        phi_19976_ = type_9(0u, 96u);
                                                        phi_19979_ = _e8322.member;
                                                        phi_19981_ = _e8322.member;
                                                        phi_19983_ = (_e8322.member_1 - _e8322.member);
                                                        phi_19985_ = _e8322.member;
                                                        phi_19987_ = false;
                                                        phi_19989_ = 0u;
                                                        loop {
                                                            let _e9308 = phi_19976_;
                                                            let _e9310 = phi_19979_;
                                                            let _e9312 = phi_19981_;
                                                            let _e9314 = phi_19983_;
                                                            let _e9316 = phi_19985_;
                                                            let _e9318 = phi_19987_;
                                                            let _e9320 = phi_19989_;
                                                            local_96 = _e9310;
                                                            local_146 = _e9312;
                                                            if (_e9308.member < _e9308.member_1) {
                                                                phi_19977_ = type_9((_e9308.member + 1u), _e9308.member_1);
                                                                phi_20012_ = type_9(1u, _e9308.member);
                                                            } else {
                                                                phi_19977_ = _e9308;
                                                                phi_20012_ = type_9(0u, type_9().member_1);
                                                            }
                                                            let _e9332 = phi_19977_;
                                                            let _e9334 = phi_20012_;
                                                            if (bitcast<i32>(_e9334.member) != 0i) {
                                                                let _e9340 = local_18.member[0u];
                                                                let _e9346 = local_18.member[1u];
                                                                let _e9362 = local_18.member_1[0u];
                                                                let _e9368 = local_18.member_1[1u];
                                                                let _e9384 = local_18.member_2[0u];
                                                                let _e9390 = local_18.member_2[1u];
                                                                let _e9404 = function_3(array<f32, 3>((_e9340[0] + ((_e9346[0] - _e9340[0]) * _e9310)), (_e9340[1] + ((_e9346[1] - _e9340[1]) * _e9310)), (_e9340[2] + ((_e9346[2] - _e9340[2]) * _e9310))), array<f32, 3>((_e9362[0] + ((_e9368[0] - _e9362[0]) * _e9310)), (_e9362[1] + ((_e9368[1] - _e9362[1]) * _e9310)), (_e9362[2] + ((_e9368[2] - _e9362[2]) * _e9310))), array<f32, 3>((_e9384[0] + ((_e9390[0] - _e9384[0]) * _e9310)), (_e9384[1] + ((_e9390[1] - _e9384[1]) * _e9310)), (_e9384[2] + ((_e9390[2] - _e9384[2]) * _e9310))), _e316.member);
                                                                if (_e9320 == 0u) {
                                                                    phi_20140_ = _e9404;
                                                                } else {
                                                                    if (_e9320 == 1u) {
                                                                        phi_20126_ = _e9404[0];
                                                                    } else {
                                                                        phi_20126_ = 0f;
                                                                    }
                                                                    let _e9409 = phi_20126_;
                                                                    if (_e9320 == 2u) {
                                                                        phi_20132_ = _e9404[1];
                                                                    } else {
                                                                        phi_20132_ = 0f;
                                                                    }
                                                                    let _e9413 = phi_20132_;
                                                                    if (_e9320 == 3u) {
                                                                        phi_20138_ = _e9404[2];
                                                                    } else {
                                                                        phi_20138_ = 0f;
                                                                    }
                                                                    let _e9417 = phi_20138_;
                                                                    phi_20140_ = array<f32, 3>(_e9409, _e9413, _e9417);
                                                                }
                                                                let _e9420 = phi_20140_;
                                                                if (_e9420[0] < 0f) {
                                                                    phi_20147_ = -(_e9420[0]);
                                                                } else {
                                                                    phi_20147_ = _e9420[0];
                                                                }
                                                                let _e9425 = phi_20147_;
                                                                if (_e9420[1] < 0f) {
                                                                    phi_20154_ = -(_e9420[1]);
                                                                } else {
                                                                    phi_20154_ = _e9420[1];
                                                                }
                                                                let _e9430 = phi_20154_;
                                                                if (_e9420[2] < 0f) {
                                                                    phi_20162_ = -(_e9420[2]);
                                                                } else {
                                                                    phi_20162_ = _e9420[2];
                                                                }
                                                                let _e9436 = phi_20162_;
                                                                let _e9437 = ((_e9425 + _e9430) + _e9436);
                                                                if (_e9437 > 0f) {
                                                                    if ((bitcast<u32>(_e9437) & 2139095040u) != 2139095040u) {
                                                                        let _e9442 = (1f / _e9437);
                                                                        let _e9444 = (_e9420[0] * _e9442);
                                                                        let _e9446 = (_e9420[1] * _e9442);
                                                                        let _e9448 = (_e9420[2] * _e9442);
                                                                        let _e9453 = (((_e9444 * _e9444) + (_e9446 * _e9446)) + (_e9448 * _e9448));
                                                                        if (_e9453 <= 0.000000000000000000000000000000000000011754944f) {
                                                                            if (_e9453 > 0f) {
                                                                                phi_20199_ = (0.000000000000000000106433627f * 2f);
                                                                            } else {
                                                                                phi_20199_ = 0f;
                                                                            }
                                                                            let _e9506 = phi_20199_;
                                                                            phi_20263_ = _e9506;
                                                                        } else {
                                                                            phi_20206_ = type_14(0i, 5i);
                                                                            phi_20209_ = bitcast<f32>(((bitcast<u32>(_e9453) >> bitcast<u32>(1i)) + 532369198u));
                                                                            loop {
                                                                                let _e9461 = phi_20206_;
                                                                                let _e9463 = phi_20209_;
                                                                                local_94 = _e9463;
                                                                                if (_e9461.member < _e9461.member_1) {
                                                                                    let _e9470 = (_e9461.member + 1i);
                                                                                    if ((false == (_e9470 > _e9461.member)) != false) {
                                                                                        phi_20230_ = true;
                                                                                    } else {
                                                                                        phi_20230_ = false;
                                                                                    }
                                                                                    let _e9475 = phi_20230_;
                                                                                    if _e9475 {
                                                                                        phi_20236_ = type_15(0u, type_15().member_1);
                                                                                    } else {
                                                                                        phi_20236_ = type_15(1u, _e9470);
                                                                                    }
                                                                                    let _e9480 = phi_20236_;
                                                                                    phi_20207_ = type_14(_e9480.member_1, _e9461.member_1);
                                                                                    phi_20250_ = type_15(1u, _e9461.member);
                                                                                } else {
                                                                                    phi_20207_ = _e9461;
                                                                                    phi_20250_ = type_15(0u, type_15().member_1);
                                                                                }
                                                                                let _e9486 = phi_20207_;
                                                                                let _e9488 = phi_20250_;
                                                                                let _e9491 = (bitcast<i32>(_e9488.member) != 0i);
                                                                                if _e9491 {
                                                                                    phi_20210_ = (0.5f * (_e9463 + (_e9453 / _e9463)));
                                                                                } else {
                                                                                    phi_20210_ = f32();
                                                                                }
                                                                                let _e9496 = phi_20210_;
                                                                                continue;
                                                                                continuing {
                                                                                    phi_20206_ = _e9486;
                                                                                    phi_20209_ = _e9496;
                                                                                    break if !(_e9491);
                                                                                }
                                                                            }
                                                                            let _e9501 = local_94;
                                                                            phi_20263_ = (_e9501 * (1f + (8f * 0.000000059604645f)));
                                                                        }
                                                                        let _e9508 = phi_20263_;
                                                                        let _e9509 = (0.000000059604645f * 12f);
                                                                        let _e9514 = ((((((((_e9183 + _e9185) + (_e9237 + _e9239)) + (_e9291 + _e9293)) * (0.000000059604645f * 16f)) + (_e9300 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e9508) * (1f + _e9509)));
                                                                        let _e9519 = (((_e9444 * _e9071[0]) + (_e9446 * _e9071[1])) + (_e9448 * _e9071[2]));
                                                                        let _e9524 = (((_e9444 * _e9088) + (_e9446 * _e9089)) + (_e9448 * _e9090));
                                                                        let _e9529 = (((_e9444 * (_e9071[0] - _e9084[0])) + (_e9446 * (_e9071[1] - _e9084[1]))) + (_e9448 * (_e9071[2] - _e9084[2])));
                                                                        let _e9537 = (((_e9444 * _e9097[0]) + (_e9446 * _e9097[1])) + (_e9448 * _e9097[2]));
                                                                        let _e9543 = (((_e9444 * _e9103[0]) + (_e9446 * _e9103[1])) + (_e9448 * _e9103[2]));
                                                                        let _e9548 = (((_e9444 * _e9120) + (_e9446 * _e9121)) + (_e9448 * _e9122));
                                                                        let _e9553 = (((_e9444 * (_e9103[0] - _e9116[0])) + (_e9446 * (_e9103[1] - _e9116[1]))) + (_e9448 * (_e9103[2] - _e9116[2])));
                                                                        let _e9561 = (((_e9444 * _e9129[0]) + (_e9446 * _e9129[1])) + (_e9448 * _e9129[2]));
                                                                        if (_e9519 < 0f) {
                                                                            phi_20329_ = -(_e9519);
                                                                        } else {
                                                                            phi_20329_ = _e9519;
                                                                        }
                                                                        let _e9566 = phi_20329_;
                                                                        if (_e9543 < 0f) {
                                                                            phi_20335_ = -(_e9543);
                                                                        } else {
                                                                            phi_20335_ = _e9543;
                                                                        }
                                                                        let _e9570 = phi_20335_;
                                                                        if (_e9524 < 0f) {
                                                                            phi_20344_ = -(_e9524);
                                                                        } else {
                                                                            phi_20344_ = _e9524;
                                                                        }
                                                                        let _e9577 = phi_20344_;
                                                                        if (_e9548 < 0f) {
                                                                            phi_20350_ = -(_e9548);
                                                                        } else {
                                                                            phi_20350_ = _e9548;
                                                                        }
                                                                        let _e9581 = phi_20350_;
                                                                        if (_e9529 < 0f) {
                                                                            phi_20359_ = -(_e9529);
                                                                        } else {
                                                                            phi_20359_ = _e9529;
                                                                        }
                                                                        let _e9588 = phi_20359_;
                                                                        if (_e9553 < 0f) {
                                                                            phi_20365_ = -(_e9553);
                                                                        } else {
                                                                            phi_20365_ = _e9553;
                                                                        }
                                                                        let _e9592 = phi_20365_;
                                                                        if (_e9537 < 0f) {
                                                                            phi_20374_ = -(_e9537);
                                                                        } else {
                                                                            phi_20374_ = _e9537;
                                                                        }
                                                                        let _e9599 = phi_20374_;
                                                                        if (_e9561 < 0f) {
                                                                            phi_20380_ = -(_e9561);
                                                                        } else {
                                                                            phi_20380_ = _e9561;
                                                                        }
                                                                        let _e9603 = phi_20380_;
                                                                        phi_20386_ = type_29(array<f32, 4>(_e9519, _e9524, _e9529, _e9537), array<f32, 4>(_e9543, _e9548, _e9553, _e9561), array<f32, 4>((_e9514 + ((_e9566 + _e9570) * _e9509)), (_e9514 + ((_e9577 + _e9581) * _e9509)), (_e9514 + ((_e9588 + _e9592) * _e9509)), (_e9514 + ((_e9599 + _e9603) * _e9509))));
                                                                        phi_20387_ = false;
                                                                    } else {
                                                                        phi_20386_ = type_29();
                                                                        phi_20387_ = true;
                                                                    }
                                                                    let _e9610 = phi_20386_;
                                                                    let _e9612 = phi_20387_;
                                                                    phi_20388_ = _e9610;
                                                                    phi_20389_ = _e9612;
                                                                } else {
                                                                    phi_20388_ = type_29();
                                                                    phi_20389_ = true;
                                                                }
                                                                let _e9614 = phi_20388_;
                                                                let _e9616 = phi_20389_;
                                                                if _e9616 {
                                                                    phi_20397_ = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                                } else {
                                                                    phi_20397_ = _e9614;
                                                                }
                                                                let _e9618 = phi_20397_;
                                                                local_1 = type_29(array<f32, 4>(_e9618.member[0], _e9618.member[1], _e9618.member[2], _e9618.member[3]), array<f32, 4>(_e9618.member_1[0], _e9618.member_1[1], _e9618.member_1[2], _e9618.member_1[3]), array<f32, 4>(_e9618.member_2[0], _e9618.member_2[1], _e9618.member_2[2], _e9618.member_2[3]));
                                                                let _e9638 = (_e9310 - _e9316);
                                                                let _e9642 = local_1.member[0u];
                                                                let _e9645 = local_1.member_1[0u];
                                                                let _e9648 = local_1.member[0u];
                                                                let _e9654 = local_1.member_2[0u];
                                                                if (((_e9642 + ((_e9645 - _e9648) * _e9310)) - _e9654) > 0f) {
                                                                    let _e9659 = local_1.member[1u];
                                                                    let _e9662 = local_1.member_1[1u];
                                                                    let _e9665 = local_1.member[1u];
                                                                    let _e9671 = local_1.member_2[1u];
                                                                    if (((_e9659 + ((_e9662 - _e9665) * _e9310)) - _e9671) > 0f) {
                                                                        let _e9676 = local_1.member[2u];
                                                                        let _e9679 = local_1.member_1[2u];
                                                                        let _e9682 = local_1.member[2u];
                                                                        let _e9688 = local_1.member_2[2u];
                                                                        if (((_e9676 + ((_e9679 - _e9682) * _e9310)) - _e9688) > 0f) {
                                                                            let _e9693 = local_1.member[3u];
                                                                            let _e9696 = local_1.member_1[3u];
                                                                            let _e9699 = local_1.member[3u];
                                                                            let _e9705 = local_1.member_2[3u];
                                                                            phi_20568_ = (((_e9693 + ((_e9696 - _e9699) * _e9310)) - _e9705) > 0f);
                                                                            phi_20569_ = false;
                                                                        } else {
                                                                            phi_20568_ = bool();
                                                                            phi_20569_ = true;
                                                                        }
                                                                        let _e9709 = phi_20568_;
                                                                        let _e9711 = phi_20569_;
                                                                        phi_20570_ = _e9709;
                                                                        phi_20571_ = _e9711;
                                                                    } else {
                                                                        phi_20570_ = bool();
                                                                        phi_20571_ = true;
                                                                    }
                                                                    let _e9713 = phi_20570_;
                                                                    let _e9715 = phi_20571_;
                                                                    phi_20572_ = _e9713;
                                                                    phi_20573_ = _e9715;
                                                                } else {
                                                                    phi_20572_ = bool();
                                                                    phi_20573_ = true;
                                                                }
                                                                let _e9717 = phi_20572_;
                                                                let _e9719 = phi_20573_;
                                                                if _e9719 {
                                                                    phi_20577_ = false;
                                                                } else {
                                                                    phi_20577_ = _e9717;
                                                                }
                                                                let _e9721 = phi_20577_;
                                                                if _e9721 {
                                                                    if (_e9310 <= _e9312) {
                                                                        phi_20887_ = true;
                                                                    } else {
                                                                        let _e9725 = local.member[0u];
                                                                        let _e9728 = local.member_1[0u];
                                                                        let _e9731 = local.member[0u];
                                                                        let _e9737 = local.member_2[0u];
                                                                        let _e9741 = local_1.member[0u];
                                                                        let _e9744 = local_1.member_1[0u];
                                                                        let _e9747 = local_1.member[0u];
                                                                        let _e9753 = local_1.member_2[0u];
                                                                        if ((((_e9725 + ((_e9728 - _e9731) * _e9310)) - _e9737) + ((_e9741 + ((_e9744 - _e9747) * _e9316)) - _e9753)) > 0f) {
                                                                            let _e9759 = local.member[1u];
                                                                            let _e9762 = local.member_1[1u];
                                                                            let _e9765 = local.member[1u];
                                                                            let _e9771 = local.member_2[1u];
                                                                            let _e9775 = local_1.member[1u];
                                                                            let _e9778 = local_1.member_1[1u];
                                                                            let _e9781 = local_1.member[1u];
                                                                            let _e9787 = local_1.member_2[1u];
                                                                            if ((((_e9759 + ((_e9762 - _e9765) * _e9310)) - _e9771) + ((_e9775 + ((_e9778 - _e9781) * _e9316)) - _e9787)) > 0f) {
                                                                                let _e9793 = local.member[2u];
                                                                                let _e9796 = local.member_1[2u];
                                                                                let _e9799 = local.member[2u];
                                                                                let _e9805 = local.member_2[2u];
                                                                                let _e9809 = local_1.member[2u];
                                                                                let _e9812 = local_1.member_1[2u];
                                                                                let _e9815 = local_1.member[2u];
                                                                                let _e9821 = local_1.member_2[2u];
                                                                                if ((((_e9793 + ((_e9796 - _e9799) * _e9310)) - _e9805) + ((_e9809 + ((_e9812 - _e9815) * _e9316)) - _e9821)) > 0f) {
                                                                                    let _e9827 = local.member[3u];
                                                                                    let _e9830 = local.member_1[3u];
                                                                                    let _e9833 = local.member[3u];
                                                                                    let _e9839 = local.member_2[3u];
                                                                                    let _e9843 = local_1.member[3u];
                                                                                    let _e9846 = local_1.member_1[3u];
                                                                                    let _e9849 = local_1.member[3u];
                                                                                    let _e9855 = local_1.member_2[3u];
                                                                                    phi_20874_ = ((((_e9827 + ((_e9830 - _e9833) * _e9310)) - _e9839) + ((_e9843 + ((_e9846 - _e9849) * _e9316)) - _e9855)) > 0f);
                                                                                    phi_20875_ = false;
                                                                                } else {
                                                                                    phi_20874_ = bool();
                                                                                    phi_20875_ = true;
                                                                                }
                                                                                let _e9860 = phi_20874_;
                                                                                let _e9862 = phi_20875_;
                                                                                phi_20876_ = _e9860;
                                                                                phi_20877_ = _e9862;
                                                                            } else {
                                                                                phi_20876_ = bool();
                                                                                phi_20877_ = true;
                                                                            }
                                                                            let _e9864 = phi_20876_;
                                                                            let _e9866 = phi_20877_;
                                                                            phi_20878_ = _e9864;
                                                                            phi_20879_ = _e9866;
                                                                        } else {
                                                                            phi_20878_ = bool();
                                                                            phi_20879_ = true;
                                                                        }
                                                                        let _e9868 = phi_20878_;
                                                                        let _e9870 = phi_20879_;
                                                                        if _e9870 {
                                                                            phi_20883_ = false;
                                                                        } else {
                                                                            phi_20883_ = _e9868;
                                                                        }
                                                                        let _e9872 = phi_20883_;
                                                                        phi_20887_ = _e9872;
                                                                    }
                                                                    let _e9874 = phi_20887_;
                                                                    if _e9874 {
                                                                        if _e9318 {
                                                                            if (_e9310 >= _e8322.member_1) {
                                                                                phi_20898_ = false;
                                                                            } else {
                                                                                phi_20898_ = true;
                                                                            }
                                                                            let _e9877 = phi_20898_;
                                                                            phi_20899_ = _e9877;
                                                                        } else {
                                                                            phi_20899_ = true;
                                                                        }
                                                                        let _e9879 = phi_20899_;
                                                                        if _e9879 {
                                                                            local = type_29(array<f32, 4>(_e9618.member[0], _e9618.member[1], _e9618.member[2], _e9618.member[3]), array<f32, 4>(_e9618.member_1[0], _e9618.member_1[1], _e9618.member_1[2], _e9618.member_1[3]), array<f32, 4>(_e9618.member_2[0], _e9618.member_2[1], _e9618.member_2[2], _e9618.member_2[3]));
                                                                            let _e9901 = local.member[0u];
                                                                            let _e9904 = local.member_1[0u];
                                                                            let _e9907 = local.member_2[0u];
                                                                            if (_e9901 > _e9907) {
                                                                                if (_e9904 > _e9907) {
                                                                                    phi_20973_ = false;
                                                                                } else {
                                                                                    phi_20973_ = true;
                                                                                }
                                                                                let _e9911 = phi_20973_;
                                                                                phi_20974_ = _e9911;
                                                                            } else {
                                                                                phi_20974_ = true;
                                                                            }
                                                                            let _e9913 = phi_20974_;
                                                                            if _e9913 {
                                                                                let _e9914 = (_e9904 >= _e9901);
                                                                                if _e9914 {
                                                                                    phi_20996_ = f32();
                                                                                    phi_20997_ = false;
                                                                                } else {
                                                                                    if ((_e9901 - _e9904) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                        phi_20994_ = (((_e9901 - _e9907) / (_e9901 - _e9904)) * (1f - (0.000000059604645f * 16f)));
                                                                                        phi_20995_ = false;
                                                                                    } else {
                                                                                        phi_20994_ = f32();
                                                                                        phi_20995_ = true;
                                                                                    }
                                                                                    let _e9925 = phi_20994_;
                                                                                    let _e9927 = phi_20995_;
                                                                                    phi_20996_ = _e9925;
                                                                                    phi_20997_ = _e9927;
                                                                                }
                                                                                let _e9929 = phi_20996_;
                                                                                let _e9931 = phi_20997_;
                                                                                phi_20998_ = _e9929;
                                                                                phi_20999_ = _e9914;
                                                                                phi_21000_ = _e9931;
                                                                            } else {
                                                                                phi_20998_ = f32();
                                                                                phi_20999_ = true;
                                                                                phi_21000_ = false;
                                                                            }
                                                                            let _e9933 = phi_20998_;
                                                                            let _e9935 = phi_20999_;
                                                                            let _e9937 = phi_21000_;
                                                                            if _e9935 {
                                                                                phi_21004_ = 2f;
                                                                                phi_21005_ = true;
                                                                            } else {
                                                                                phi_21004_ = _e9310;
                                                                                phi_21005_ = _e9937;
                                                                            }
                                                                            let _e9939 = phi_21004_;
                                                                            let _e9941 = phi_21005_;
                                                                            if _e9941 {
                                                                                phi_21009_ = _e9939;
                                                                            } else {
                                                                                phi_21009_ = _e9933;
                                                                            }
                                                                            let _e9943 = phi_21009_;
                                                                            let _e9946 = local.member[1u];
                                                                            let _e9949 = local.member_1[1u];
                                                                            let _e9952 = local.member_2[1u];
                                                                            if (_e9946 > _e9952) {
                                                                                if (_e9949 > _e9952) {
                                                                                    phi_21041_ = false;
                                                                                } else {
                                                                                    phi_21041_ = true;
                                                                                }
                                                                                let _e9956 = phi_21041_;
                                                                                phi_21042_ = _e9956;
                                                                            } else {
                                                                                phi_21042_ = true;
                                                                            }
                                                                            let _e9958 = phi_21042_;
                                                                            if _e9958 {
                                                                                let _e9959 = (_e9949 >= _e9946);
                                                                                if _e9959 {
                                                                                    phi_21064_ = f32();
                                                                                    phi_21065_ = false;
                                                                                } else {
                                                                                    if ((_e9946 - _e9949) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                        phi_21062_ = (((_e9946 - _e9952) / (_e9946 - _e9949)) * (1f - (0.000000059604645f * 16f)));
                                                                                        phi_21063_ = false;
                                                                                    } else {
                                                                                        phi_21062_ = f32();
                                                                                        phi_21063_ = true;
                                                                                    }
                                                                                    let _e9970 = phi_21062_;
                                                                                    let _e9972 = phi_21063_;
                                                                                    phi_21064_ = _e9970;
                                                                                    phi_21065_ = _e9972;
                                                                                }
                                                                                let _e9974 = phi_21064_;
                                                                                let _e9976 = phi_21065_;
                                                                                phi_21066_ = _e9974;
                                                                                phi_21067_ = _e9959;
                                                                                phi_21068_ = _e9976;
                                                                            } else {
                                                                                phi_21066_ = f32();
                                                                                phi_21067_ = true;
                                                                                phi_21068_ = false;
                                                                            }
                                                                            let _e9978 = phi_21066_;
                                                                            let _e9980 = phi_21067_;
                                                                            let _e9982 = phi_21068_;
                                                                            if _e9980 {
                                                                                phi_21072_ = 2f;
                                                                                phi_21073_ = true;
                                                                            } else {
                                                                                phi_21072_ = _e9310;
                                                                                phi_21073_ = _e9982;
                                                                            }
                                                                            let _e9984 = phi_21072_;
                                                                            let _e9986 = phi_21073_;
                                                                            if _e9986 {
                                                                                phi_21077_ = _e9984;
                                                                            } else {
                                                                                phi_21077_ = _e9978;
                                                                            }
                                                                            let _e9988 = phi_21077_;
                                                                            if (_e9943 < _e9988) {
                                                                                phi_21082_ = _e9943;
                                                                            } else {
                                                                                phi_21082_ = _e9988;
                                                                            }
                                                                            let _e9991 = phi_21082_;
                                                                            let _e9994 = local.member[2u];
                                                                            let _e9997 = local.member_1[2u];
                                                                            let _e10000 = local.member_2[2u];
                                                                            if (_e9994 > _e10000) {
                                                                                if (_e9997 > _e10000) {
                                                                                    phi_21114_ = false;
                                                                                } else {
                                                                                    phi_21114_ = true;
                                                                                }
                                                                                let _e10004 = phi_21114_;
                                                                                phi_21115_ = _e10004;
                                                                            } else {
                                                                                phi_21115_ = true;
                                                                            }
                                                                            let _e10006 = phi_21115_;
                                                                            if _e10006 {
                                                                                let _e10007 = (_e9997 >= _e9994);
                                                                                if _e10007 {
                                                                                    phi_21137_ = f32();
                                                                                    phi_21138_ = false;
                                                                                } else {
                                                                                    if ((_e9994 - _e9997) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                        phi_21135_ = (((_e9994 - _e10000) / (_e9994 - _e9997)) * (1f - (0.000000059604645f * 16f)));
                                                                                        phi_21136_ = false;
                                                                                    } else {
                                                                                        phi_21135_ = f32();
                                                                                        phi_21136_ = true;
                                                                                    }
                                                                                    let _e10018 = phi_21135_;
                                                                                    let _e10020 = phi_21136_;
                                                                                    phi_21137_ = _e10018;
                                                                                    phi_21138_ = _e10020;
                                                                                }
                                                                                let _e10022 = phi_21137_;
                                                                                let _e10024 = phi_21138_;
                                                                                phi_21139_ = _e10022;
                                                                                phi_21140_ = _e10007;
                                                                                phi_21141_ = _e10024;
                                                                            } else {
                                                                                phi_21139_ = f32();
                                                                                phi_21140_ = true;
                                                                                phi_21141_ = false;
                                                                            }
                                                                            let _e10026 = phi_21139_;
                                                                            let _e10028 = phi_21140_;
                                                                            let _e10030 = phi_21141_;
                                                                            if _e10028 {
                                                                                phi_21145_ = 2f;
                                                                                phi_21146_ = true;
                                                                            } else {
                                                                                phi_21145_ = _e9310;
                                                                                phi_21146_ = _e10030;
                                                                            }
                                                                            let _e10032 = phi_21145_;
                                                                            let _e10034 = phi_21146_;
                                                                            if _e10034 {
                                                                                phi_21150_ = _e10032;
                                                                            } else {
                                                                                phi_21150_ = _e10026;
                                                                            }
                                                                            let _e10036 = phi_21150_;
                                                                            let _e10039 = local.member[3u];
                                                                            let _e10042 = local.member_1[3u];
                                                                            let _e10045 = local.member_2[3u];
                                                                            if (_e10039 > _e10045) {
                                                                                if (_e10042 > _e10045) {
                                                                                    phi_21182_ = false;
                                                                                } else {
                                                                                    phi_21182_ = true;
                                                                                }
                                                                                let _e10049 = phi_21182_;
                                                                                phi_21183_ = _e10049;
                                                                            } else {
                                                                                phi_21183_ = true;
                                                                            }
                                                                            let _e10051 = phi_21183_;
                                                                            if _e10051 {
                                                                                let _e10052 = (_e10042 >= _e10039);
                                                                                if _e10052 {
                                                                                    phi_21205_ = f32();
                                                                                    phi_21206_ = false;
                                                                                } else {
                                                                                    if ((_e10039 - _e10042) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                        phi_21203_ = (((_e10039 - _e10045) / (_e10039 - _e10042)) * (1f - (0.000000059604645f * 16f)));
                                                                                        phi_21204_ = false;
                                                                                    } else {
                                                                                        phi_21203_ = f32();
                                                                                        phi_21204_ = true;
                                                                                    }
                                                                                    let _e10063 = phi_21203_;
                                                                                    let _e10065 = phi_21204_;
                                                                                    phi_21205_ = _e10063;
                                                                                    phi_21206_ = _e10065;
                                                                                }
                                                                                let _e10067 = phi_21205_;
                                                                                let _e10069 = phi_21206_;
                                                                                phi_21207_ = _e10067;
                                                                                phi_21208_ = _e10052;
                                                                                phi_21209_ = _e10069;
                                                                            } else {
                                                                                phi_21207_ = f32();
                                                                                phi_21208_ = true;
                                                                                phi_21209_ = false;
                                                                            }
                                                                            let _e10071 = phi_21207_;
                                                                            let _e10073 = phi_21208_;
                                                                            let _e10075 = phi_21209_;
                                                                            if _e10073 {
                                                                                phi_21213_ = 2f;
                                                                                phi_21214_ = true;
                                                                            } else {
                                                                                phi_21213_ = _e9310;
                                                                                phi_21214_ = _e10075;
                                                                            }
                                                                            let _e10077 = phi_21213_;
                                                                            let _e10079 = phi_21214_;
                                                                            if _e10079 {
                                                                                phi_21218_ = _e10077;
                                                                            } else {
                                                                                phi_21218_ = _e10071;
                                                                            }
                                                                            let _e10081 = phi_21218_;
                                                                            if (_e10036 < _e10081) {
                                                                                phi_21223_ = _e10036;
                                                                            } else {
                                                                                phi_21223_ = _e10081;
                                                                            }
                                                                            let _e10084 = phi_21223_;
                                                                            if (_e9991 < _e10084) {
                                                                                phi_21228_ = _e9991;
                                                                            } else {
                                                                                phi_21228_ = _e10084;
                                                                            }
                                                                            let _e10087 = phi_21228_;
                                                                            if (_e10087 > _e9310) {
                                                                                phi_21233_ = _e10087;
                                                                            } else {
                                                                                phi_21233_ = _e9310;
                                                                            }
                                                                            let _e10090 = phi_21233_;
                                                                            let _e10091 = (_e10090 > _e8322.member_1);
                                                                            if _e10091 {
                                                                                phi_21738_ = f32();
                                                                                phi_21739_ = f32();
                                                                                phi_21740_ = false;
                                                                            } else {
                                                                                let _e10092 = (_e10090 - _e9310);
                                                                                if _e9318 {
                                                                                    if (_e10092 <= _e9305) {
                                                                                        phi_21728_ = true;
                                                                                    } else {
                                                                                        if (_e10092 <= (_e9314 * 0.25f)) {
                                                                                            phi_21727_ = false;
                                                                                        } else {
                                                                                            phi_21727_ = true;
                                                                                        }
                                                                                        let _e10098 = phi_21727_;
                                                                                        phi_21728_ = _e10098;
                                                                                    }
                                                                                    let _e10100 = phi_21728_;
                                                                                    if _e10100 {
                                                                                        phi_21733_ = (_e9638 + _e9638);
                                                                                    } else {
                                                                                        phi_21733_ = 0f;
                                                                                    }
                                                                                    let _e10103 = phi_21733_;
                                                                                    phi_21735_ = _e10103;
                                                                                } else {
                                                                                    phi_21735_ = (_e8322.member_1 - _e9310);
                                                                                }
                                                                                let _e10105 = phi_21735_;
                                                                                phi_21738_ = _e10105;
                                                                                phi_21739_ = _e10092;
                                                                                phi_21740_ = true;
                                                                            }
                                                                            let _e10107 = phi_21738_;
                                                                            let _e10109 = phi_21739_;
                                                                            let _e10111 = phi_21740_;
                                                                            phi_21742_ = _e10090;
                                                                            phi_21743_ = _e10107;
                                                                            phi_21744_ = _e10109;
                                                                            phi_21746_ = _e10111;
                                                                            phi_21747_ = _e10091;
                                                                            phi_21749_ = false;
                                                                        } else {
                                                                            phi_21742_ = f32();
                                                                            phi_21743_ = f32();
                                                                            phi_21744_ = f32();
                                                                            phi_21746_ = false;
                                                                            phi_21747_ = false;
                                                                            phi_21749_ = true;
                                                                        }
                                                                        let _e10113 = phi_21742_;
                                                                        let _e10115 = phi_21743_;
                                                                        let _e10117 = phi_21744_;
                                                                        let _e10119 = phi_21746_;
                                                                        let _e10121 = phi_21747_;
                                                                        let _e10123 = phi_21749_;
                                                                        phi_21750_ = _e10113;
                                                                        phi_21751_ = _e10115;
                                                                        phi_21752_ = _e10117;
                                                                        phi_21754_ = false;
                                                                        phi_21755_ = _e10119;
                                                                        phi_21756_ = _e10121;
                                                                        phi_21758_ = _e10123;
                                                                    } else {
                                                                        phi_21750_ = f32();
                                                                        phi_21751_ = f32();
                                                                        phi_21752_ = f32();
                                                                        phi_21754_ = true;
                                                                        phi_21755_ = false;
                                                                        phi_21756_ = false;
                                                                        phi_21758_ = false;
                                                                    }
                                                                    let _e10125 = phi_21750_;
                                                                    let _e10127 = phi_21751_;
                                                                    let _e10129 = phi_21752_;
                                                                    let _e10131 = phi_21754_;
                                                                    let _e10133 = phi_21755_;
                                                                    let _e10135 = phi_21756_;
                                                                    let _e10137 = phi_21758_;
                                                                    phi_21759_ = _e10125;
                                                                    phi_21760_ = _e10127;
                                                                    phi_21761_ = _e10129;
                                                                    phi_21763_ = _e10131;
                                                                    phi_21764_ = _e10133;
                                                                    phi_21765_ = _e10135;
                                                                    phi_21767_ = _e10137;
                                                                } else {
                                                                    phi_21759_ = f32();
                                                                    phi_21760_ = f32();
                                                                    phi_21761_ = f32();
                                                                    phi_21763_ = true;
                                                                    phi_21764_ = false;
                                                                    phi_21765_ = false;
                                                                    phi_21767_ = false;
                                                                }
                                                                let _e10139 = phi_21759_;
                                                                let _e10141 = phi_21760_;
                                                                let _e10143 = phi_21761_;
                                                                let _e10145 = phi_21763_;
                                                                let _e10147 = phi_21764_;
                                                                let _e10149 = phi_21765_;
                                                                let _e10151 = phi_21767_;
                                                                if _e10145 {
                                                                    if (_e9310 <= _e9312) {
                                                                        let _e10312 = (_e9320 + 1u);
                                                                        let _e10313 = (_e10312 > 3u);
                                                                        if _e10313 {
                                                                            phi_21780_ = false;
                                                                        } else {
                                                                            phi_21780_ = true;
                                                                        }
                                                                        let _e10315 = phi_21780_;
                                                                        phi_22102_ = _e10312;
                                                                        phi_22103_ = f32();
                                                                        phi_22104_ = false;
                                                                        phi_22105_ = _e10315;
                                                                        phi_22106_ = _e10313;
                                                                    } else {
                                                                        let _e10155 = local.member[0u];
                                                                        let _e10158 = local.member_1[0u];
                                                                        let _e10161 = local.member[0u];
                                                                        let _e10167 = local.member_2[0u];
                                                                        let _e10168 = ((_e10155 + ((_e10158 - _e10161) * _e9316)) - _e10167);
                                                                        let _e10171 = local.member[1u];
                                                                        let _e10174 = local.member_1[1u];
                                                                        let _e10177 = local.member[1u];
                                                                        let _e10183 = local.member_2[1u];
                                                                        let _e10184 = ((_e10171 + ((_e10174 - _e10177) * _e9316)) - _e10183);
                                                                        if (_e10168 < _e10184) {
                                                                            phi_21853_ = _e10168;
                                                                        } else {
                                                                            phi_21853_ = _e10184;
                                                                        }
                                                                        let _e10187 = phi_21853_;
                                                                        let _e10190 = local.member[2u];
                                                                        let _e10193 = local.member_1[2u];
                                                                        let _e10196 = local.member[2u];
                                                                        let _e10202 = local.member_2[2u];
                                                                        let _e10203 = ((_e10190 + ((_e10193 - _e10196) * _e9316)) - _e10202);
                                                                        let _e10206 = local.member[3u];
                                                                        let _e10209 = local.member_1[3u];
                                                                        let _e10212 = local.member[3u];
                                                                        let _e10218 = local.member_2[3u];
                                                                        let _e10219 = ((_e10206 + ((_e10209 - _e10212) * _e9316)) - _e10218);
                                                                        if (_e10203 < _e10219) {
                                                                            phi_21926_ = _e10203;
                                                                        } else {
                                                                            phi_21926_ = _e10219;
                                                                        }
                                                                        let _e10222 = phi_21926_;
                                                                        if (_e10187 < _e10222) {
                                                                            phi_21931_ = _e10187;
                                                                        } else {
                                                                            phi_21931_ = _e10222;
                                                                        }
                                                                        let _e10225 = phi_21931_;
                                                                        let _e10228 = local_1.member[0u];
                                                                        let _e10231 = local_1.member_1[0u];
                                                                        let _e10234 = local_1.member[0u];
                                                                        let _e10240 = local_1.member_2[0u];
                                                                        let _e10241 = ((_e10228 + ((_e10231 - _e10234) * _e9310)) - _e10240);
                                                                        let _e10244 = local_1.member[1u];
                                                                        let _e10247 = local_1.member_1[1u];
                                                                        let _e10250 = local_1.member[1u];
                                                                        let _e10256 = local_1.member_2[1u];
                                                                        let _e10257 = ((_e10244 + ((_e10247 - _e10250) * _e9310)) - _e10256);
                                                                        if (_e10241 < _e10257) {
                                                                            phi_22004_ = _e10241;
                                                                        } else {
                                                                            phi_22004_ = _e10257;
                                                                        }
                                                                        let _e10260 = phi_22004_;
                                                                        let _e10263 = local_1.member[2u];
                                                                        let _e10266 = local_1.member_1[2u];
                                                                        let _e10269 = local_1.member[2u];
                                                                        let _e10275 = local_1.member_2[2u];
                                                                        let _e10276 = ((_e10263 + ((_e10266 - _e10269) * _e9310)) - _e10275);
                                                                        let _e10279 = local_1.member[3u];
                                                                        let _e10282 = local_1.member_1[3u];
                                                                        let _e10285 = local_1.member[3u];
                                                                        let _e10291 = local_1.member_2[3u];
                                                                        let _e10292 = ((_e10279 + ((_e10282 - _e10285) * _e9310)) - _e10291);
                                                                        if (_e10276 < _e10292) {
                                                                            phi_22077_ = _e10276;
                                                                        } else {
                                                                            phi_22077_ = _e10292;
                                                                        }
                                                                        let _e10295 = phi_22077_;
                                                                        if (_e10260 < _e10295) {
                                                                            phi_22082_ = _e10260;
                                                                        } else {
                                                                            phi_22082_ = _e10295;
                                                                        }
                                                                        let _e10298 = phi_22082_;
                                                                        if (_e10298 > 0f) {
                                                                            phi_22100_ = 0.5f;
                                                                        } else {
                                                                            let _e10302 = (0.95f * (_e10225 / (_e10225 - _e10298)));
                                                                            if (_e10302 > 0.0625f) {
                                                                                if (_e10302 < 0.9f) {
                                                                                    phi_22098_ = _e10302;
                                                                                } else {
                                                                                    phi_22098_ = 0.9f;
                                                                                }
                                                                                let _e10306 = phi_22098_;
                                                                                phi_22099_ = _e10306;
                                                                            } else {
                                                                                phi_22099_ = 0.0625f;
                                                                            }
                                                                            let _e10308 = phi_22099_;
                                                                            phi_22100_ = _e10308;
                                                                        }
                                                                        let _e10310 = phi_22100_;
                                                                        phi_22102_ = u32();
                                                                        phi_22103_ = (_e9638 * _e10310);
                                                                        phi_22104_ = true;
                                                                        phi_22105_ = false;
                                                                        phi_22106_ = false;
                                                                    }
                                                                    let _e10317 = phi_22102_;
                                                                    let _e10319 = phi_22103_;
                                                                    let _e10321 = phi_22104_;
                                                                    let _e10323 = phi_22105_;
                                                                    let _e10325 = phi_22106_;
                                                                    phi_22107_ = _e10317;
                                                                    phi_22108_ = _e9312;
                                                                    phi_22109_ = _e10319;
                                                                    phi_22110_ = _e9314;
                                                                    phi_22111_ = _e9316;
                                                                    phi_22112_ = _e9318;
                                                                    phi_22113_ = _e9320;
                                                                    phi_22114_ = _e10321;
                                                                    phi_22115_ = _e10323;
                                                                    phi_22116_ = _e10325;
                                                                    phi_22117_ = false;
                                                                    phi_22119_ = false;
                                                                } else {
                                                                    phi_22107_ = u32();
                                                                    phi_22108_ = _e10139;
                                                                    phi_22109_ = _e10141;
                                                                    phi_22110_ = _e10143;
                                                                    phi_22111_ = _e9310;
                                                                    phi_22112_ = true;
                                                                    phi_22113_ = 0u;
                                                                    phi_22114_ = _e10147;
                                                                    phi_22115_ = false;
                                                                    phi_22116_ = false;
                                                                    phi_22117_ = _e10149;
                                                                    phi_22119_ = _e10151;
                                                                }
                                                                let _e10327 = phi_22107_;
                                                                let _e10329 = phi_22108_;
                                                                let _e10331 = phi_22109_;
                                                                let _e10333 = phi_22110_;
                                                                let _e10335 = phi_22111_;
                                                                let _e10337 = phi_22112_;
                                                                let _e10339 = phi_22113_;
                                                                let _e10341 = phi_22114_;
                                                                let _e10343 = phi_22115_;
                                                                let _e10345 = phi_22116_;
                                                                let _e10347 = phi_22117_;
                                                                let _e10349 = phi_22119_;
                                                                if _e10341 {
                                                                    let _e10350 = (_e10335 + _e10331);
                                                                    if (_e10350 > _e10329) {
                                                                        phi_22128_ = _e10350;
                                                                    } else {
                                                                        phi_22128_ = _e10329;
                                                                    }
                                                                    let _e10353 = phi_22128_;
                                                                    if (_e10353 < _e8322.member_1) {
                                                                        phi_22133_ = _e10353;
                                                                    } else {
                                                                        phi_22133_ = _e8322.member_1;
                                                                    }
                                                                    let _e10356 = phi_22133_;
                                                                    if !(_e9318) {
                                                                        phi_22142_ = true;
                                                                    } else {
                                                                        phi_22142_ = ((_e10356 - _e10335) > _e9305);
                                                                    }
                                                                    let _e10360 = phi_22142_;
                                                                    if _e10360 {
                                                                        phi_22146_ = false;
                                                                    } else {
                                                                        phi_22146_ = true;
                                                                    }
                                                                    let _e10362 = phi_22146_;
                                                                    phi_22147_ = _e10356;
                                                                    phi_22148_ = _e10329;
                                                                    phi_22149_ = _e10333;
                                                                    phi_22150_ = _e10335;
                                                                    phi_22151_ = _e10337;
                                                                    phi_22152_ = _e10339;
                                                                    phi_22153_ = _e10360;
                                                                    phi_22154_ = _e10362;
                                                                    phi_22155_ = false;
                                                                    phi_22156_ = false;
                                                                    phi_22158_ = false;
                                                                } else {
                                                                    phi_22147_ = _e9310;
                                                                    phi_22148_ = _e9312;
                                                                    phi_22149_ = _e9314;
                                                                    phi_22150_ = _e9316;
                                                                    phi_22151_ = _e9318;
                                                                    phi_22152_ = _e10327;
                                                                    phi_22153_ = _e10343;
                                                                    phi_22154_ = false;
                                                                    phi_22155_ = _e10345;
                                                                    phi_22156_ = _e10347;
                                                                    phi_22158_ = _e10349;
                                                                }
                                                                let _e10364 = phi_22147_;
                                                                let _e10366 = phi_22148_;
                                                                let _e10368 = phi_22149_;
                                                                let _e10370 = phi_22150_;
                                                                let _e10372 = phi_22151_;
                                                                let _e10374 = phi_22152_;
                                                                let _e10376 = phi_22153_;
                                                                let _e10378 = phi_22154_;
                                                                let _e10380 = phi_22155_;
                                                                let _e10382 = phi_22156_;
                                                                let _e10384 = phi_22158_;
                                                                phi_19980_ = _e10364;
                                                                phi_19982_ = _e10366;
                                                                phi_19984_ = _e10368;
                                                                phi_19986_ = _e10370;
                                                                phi_19988_ = _e10372;
                                                                phi_19990_ = _e10374;
                                                                phi_22159_ = _e10329;
                                                                phi_22161_ = _e10376;
                                                                phi_22162_ = _e10378;
                                                                phi_22163_ = _e10380;
                                                                phi_22164_ = _e10382;
                                                                phi_22166_ = false;
                                                                phi_22167_ = _e10384;
                                                            } else {
                                                                phi_19980_ = f32();
                                                                phi_19982_ = f32();
                                                                phi_19984_ = f32();
                                                                phi_19986_ = f32();
                                                                phi_19988_ = bool();
                                                                phi_19990_ = u32();
                                                                phi_22159_ = f32();
                                                                phi_22161_ = false;
                                                                phi_22162_ = false;
                                                                phi_22163_ = false;
                                                                phi_22164_ = false;
                                                                phi_22166_ = true;
                                                                phi_22167_ = false;
                                                            }
                                                            let _e10386 = phi_19980_;
                                                            let _e10388 = phi_19982_;
                                                            let _e10390 = phi_19984_;
                                                            let _e10392 = phi_19986_;
                                                            let _e10394 = phi_19988_;
                                                            let _e10396 = phi_19990_;
                                                            let _e10398 = phi_22159_;
                                                            let _e10400 = phi_22161_;
                                                            let _e10402 = phi_22162_;
                                                            let _e10404 = phi_22163_;
                                                            let _e10406 = phi_22164_;
                                                            let _e10408 = phi_22166_;
                                                            let _e10410 = phi_22167_;
                                                            local_95 = _e10402;
                                                            local_140 = _e10404;
                                                            local_141 = _e10406;
                                                            local_142 = _e10408;
                                                            local_143 = _e10410;
                                                            local_144 = _e10402;
                                                            local_145 = _e10398;
                                                            continue;
                                                            continuing {
                                                                phi_19976_ = _e9332;
                                                                phi_19979_ = _e10386;
                                                                phi_19981_ = _e10388;
                                                                phi_19983_ = _e10390;
                                                                phi_19985_ = _e10392;
                                                                phi_19987_ = _e10394;
                                                                phi_19989_ = _e10396;
                                                                break if !(_e10400);
                                                            }
                                                        }
                                                        let _e10413 = local_95;
                                                        if _e10413 {
                                                            phi_22171_ = false;
                                                            phi_22172_ = false;
                                                            phi_22174_ = false;
                                                            phi_22175_ = false;
                                                        } else {
                                                            let _e16594 = local_140;
                                                            phi_22171_ = _e16594;
                                                            let _e16597 = local_141;
                                                            phi_22172_ = _e16597;
                                                            let _e16600 = local_142;
                                                            phi_22174_ = _e16600;
                                                            let _e16603 = local_143;
                                                            phi_22175_ = _e16603;
                                                        }
                                                        let _e10415 = phi_22171_;
                                                        let _e10417 = phi_22172_;
                                                        let _e10419 = phi_22174_;
                                                        let _e10421 = phi_22175_;
                                                        if _e10415 {
                                                            let _e10423 = local_96;
                                                            phi_22180_ = type_44(1u, _e10423);
                                                            phi_22181_ = false;
                                                            phi_22183_ = false;
                                                            phi_22184_ = false;
                                                            phi_22185_ = false;
                                                        } else {
                                                            phi_22180_ = type_44();
                                                            phi_22181_ = _e10417;
                                                            let _e16609 = local_144;
                                                            phi_22183_ = _e16609;
                                                            phi_22184_ = _e10419;
                                                            phi_22185_ = _e10421;
                                                        }
                                                        let _e10426 = phi_22180_;
                                                        let _e10428 = phi_22181_;
                                                        let _e10430 = phi_22183_;
                                                        let _e10432 = phi_22184_;
                                                        let _e10434 = phi_22185_;
                                                        if _e10428 {
                                                            phi_22190_ = type_44(0u, type_44().member_1);
                                                            phi_22192_ = false;
                                                            phi_22193_ = false;
                                                            phi_22194_ = false;
                                                            phi_22195_ = true;
                                                        } else {
                                                            phi_22190_ = _e10426;
                                                            phi_22192_ = _e10430;
                                                            phi_22193_ = _e10432;
                                                            phi_22194_ = _e10434;
                                                            phi_22195_ = _e10415;
                                                        }
                                                        let _e10438 = phi_22190_;
                                                        let _e10440 = phi_22192_;
                                                        let _e10442 = phi_22193_;
                                                        let _e10444 = phi_22194_;
                                                        let _e10446 = phi_22195_;
                                                        if _e10440 {
                                                            let _e16619 = local_145;
                                                            phi_22207_ = _e16619;
                                                            phi_22208_ = true;
                                                            phi_22209_ = false;
                                                            phi_22210_ = false;
                                                        } else {
                                                            let _e16621 = local_146;
                                                            phi_22207_ = _e16621;
                                                            phi_22208_ = _e10442;
                                                            phi_22209_ = _e10444;
                                                            phi_22210_ = _e10446;
                                                        }
                                                        let _e10448 = phi_22207_;
                                                        let _e10450 = phi_22208_;
                                                        let _e10452 = phi_22209_;
                                                        let _e10454 = phi_22210_;
                                                        if _e10450 {
                                                            phi_22215_ = type_44(1u, _e10448);
                                                            phi_22216_ = false;
                                                            phi_22217_ = false;
                                                        } else {
                                                            phi_22215_ = type_44();
                                                            phi_22216_ = _e10452;
                                                            phi_22217_ = _e10454;
                                                        }
                                                        let _e10457 = phi_22215_;
                                                        let _e10459 = phi_22216_;
                                                        let _e10461 = phi_22217_;
                                                        if _e10459 {
                                                            phi_22222_ = type_44(0u, type_44().member_1);
                                                            phi_22223_ = true;
                                                        } else {
                                                            phi_22222_ = _e10438;
                                                            phi_22223_ = _e10461;
                                                        }
                                                        let _e10465 = phi_22222_;
                                                        let _e10467 = phi_22223_;
                                                        if _e10467 {
                                                            phi_22227_ = _e10465;
                                                        } else {
                                                            phi_22227_ = _e10457;
                                                        }
                                                        let _e10469 = phi_22227_;
                                                        let _e10472 = (_e10469.member != 0u);
                                                        if _e10472 {
                                                            phi_22234_ = false;
                                                        } else {
                                                            phi_22234_ = true;
                                                        }
                                                        let _e10474 = phi_22234_;
                                                        phi_22235_ = _e10469.member_1;
                                                        phi_22236_ = _e10474;
                                                        phi_22237_ = _e10472;
                                                        phi_22238_ = false;
                                                    } else {
                                                        phi_22235_ = f32();
                                                        phi_22236_ = false;
                                                        phi_22237_ = false;
                                                        phi_22238_ = true;
                                                    }
                                                    let _e10476 = phi_22235_;
                                                    let _e10478 = phi_22236_;
                                                    let _e10480 = phi_22237_;
                                                    let _e10482 = phi_22238_;
                                                    phi_22239_ = _e9057;
                                                    phi_22240_ = _e9058;
                                                    phi_22241_ = _e10476;
                                                    phi_22242_ = _e10478;
                                                    phi_22243_ = _e10480;
                                                    phi_22244_ = _e10482;
                                                }
                                                let _e10484 = phi_22239_;
                                                let _e10486 = phi_22240_;
                                                let _e10488 = phi_22241_;
                                                let _e10490 = phi_22242_;
                                                let _e10492 = phi_22243_;
                                                let _e10494 = phi_22244_;
                                                phi_22245_ = _e10484;
                                                phi_22246_ = _e10486;
                                                phi_22247_ = _e10488;
                                                phi_22248_ = _e9053;
                                                phi_22249_ = _e10490;
                                                phi_22250_ = _e10492;
                                                phi_22251_ = _e10494;
                                            }
                                            let _e10496 = phi_22245_;
                                            let _e10498 = phi_22246_;
                                            let _e10500 = phi_22247_;
                                            let _e10502 = phi_22248_;
                                            let _e10504 = phi_22249_;
                                            let _e10506 = phi_22250_;
                                            let _e10508 = phi_22251_;
                                            if _e10502 {
                                                phi_22255_ = false;
                                                phi_22256_ = false;
                                                phi_22257_ = false;
                                            } else {
                                                phi_22255_ = _e10504;
                                                phi_22256_ = _e10506;
                                                phi_22257_ = _e10508;
                                            }
                                            let _e10510 = phi_22255_;
                                            let _e10512 = phi_22256_;
                                            let _e10514 = phi_22257_;
                                            phi_22258_ = _e8322;
                                            phi_22259_ = _e10496;
                                            phi_22260_ = _e10498;
                                            phi_22261_ = _e10500;
                                            phi_22262_ = _e8322;
                                            phi_22263_ = _e10502;
                                            phi_22264_ = _e10510;
                                            phi_22265_ = _e10512;
                                            phi_22266_ = _e10514;
                                        } else {
                                            phi_22258_ = type_47();
                                            phi_22259_ = bool();
                                            phi_22260_ = f32();
                                            phi_22261_ = f32();
                                            phi_22262_ = type_47();
                                            phi_22263_ = true;
                                            phi_22264_ = false;
                                            phi_22265_ = false;
                                            phi_22266_ = false;
                                        }
                                        let _e10516 = phi_22258_;
                                        let _e10518 = phi_22259_;
                                        let _e10520 = phi_22260_;
                                        let _e10522 = phi_22261_;
                                        let _e10524 = phi_22262_;
                                        let _e10526 = phi_22263_;
                                        let _e10528 = phi_22264_;
                                        let _e10530 = phi_22265_;
                                        let _e10532 = phi_22266_;
                                        if _e10526 {
                                            phi_22270_ = true;
                                            phi_22271_ = false;
                                            phi_22272_ = false;
                                        } else {
                                            phi_22270_ = _e10528;
                                            phi_22271_ = _e10530;
                                            phi_22272_ = _e10532;
                                        }
                                        let _e10534 = phi_22270_;
                                        let _e10536 = phi_22271_;
                                        let _e10538 = phi_22272_;
                                        phi_22273_ = _e10516;
                                        phi_22274_ = _e10518;
                                        phi_22275_ = _e10520;
                                        phi_22276_ = _e10522;
                                        phi_22277_ = _e10524;
                                        phi_22278_ = _e10534;
                                        phi_22279_ = false;
                                        phi_22280_ = _e10536;
                                        phi_22281_ = _e10538;
                                    } else {
                                        phi_22273_ = type_47();
                                        phi_22274_ = bool();
                                        phi_22275_ = f32();
                                        phi_22276_ = f32();
                                        phi_22277_ = type_47();
                                        phi_22278_ = false;
                                        phi_22279_ = true;
                                        phi_22280_ = false;
                                        phi_22281_ = false;
                                    }
                                    let _e10540 = phi_22273_;
                                    let _e10542 = phi_22274_;
                                    let _e10544 = phi_22275_;
                                    let _e10546 = phi_22276_;
                                    let _e10548 = phi_22277_;
                                    let _e10550 = phi_22278_;
                                    let _e10552 = phi_22279_;
                                    let _e10554 = phi_22280_;
                                    let _e10556 = phi_22281_;
                                    local_97 = _e10552;
                                    local_147 = _e10554;
                                    local_148 = _e10556;
                                    local_98 = _e10542;
                                    local_99 = _e10540;
                                    local_100 = _e10546;
                                    local_101 = _e10544;
                                    local_102 = _e10546;
                                    local_103 = _e10546;
                                    local_104 = _e10548;
                                    continue;
                                    continuing {
                                        phi_18084_ = _e8045;
                                        break if !(_e10550);
                                    }
                                }
                                let _e10559 = local_97;
                                if _e10559 {
                                    phi_22286_ = type_44(0u, type_44().member_1);
                                    phi_22287_ = false;
                                    phi_22288_ = false;
                                } else {
                                    phi_22286_ = type_44();
                                    let _e16677 = local_147;
                                    phi_22287_ = _e16677;
                                    let _e16680 = local_148;
                                    phi_22288_ = _e16680;
                                }
                                let _e10563 = phi_22286_;
                                let _e10565 = phi_22287_;
                                let _e10567 = phi_22288_;
                                if _e10565 {
                                    let _e10569 = local_98;
                                    if _e10569 {
                                        let _e10571 = local_99;
                                        let _e10574 = local_100;
                                        let _e10577 = local_101;
                                        if ((_e10571.member_1 - _e10574) <= _e10577) {
                                            let _e10580 = local_102;
                                            phi_22302_ = type_44(1u, _e10580);
                                            phi_22303_ = false;
                                        } else {
                                            phi_22302_ = type_44();
                                            phi_22303_ = true;
                                        }
                                        let _e10583 = phi_22302_;
                                        let _e10585 = phi_22303_;
                                        phi_22304_ = _e10583;
                                        phi_22305_ = _e10585;
                                    } else {
                                        phi_22304_ = type_44();
                                        phi_22305_ = true;
                                    }
                                    let _e10587 = phi_22304_;
                                    let _e10589 = phi_22305_;
                                    if _e10589 {
                                        let _e10591 = local_103;
                                        phi_22310_ = type_44(2u, _e10591);
                                    } else {
                                        phi_22310_ = _e10587;
                                    }
                                    let _e10594 = phi_22310_;
                                    phi_22311_ = _e10594;
                                    phi_22312_ = false;
                                } else {
                                    phi_22311_ = type_44();
                                    phi_22312_ = _e10567;
                                }
                                let _e10596 = phi_22311_;
                                let _e10598 = phi_22312_;
                                if _e10598 {
                                    let _e10600 = local_104;
                                    phi_22318_ = type_44(1u, _e10600.member);
                                    phi_22319_ = true;
                                } else {
                                    phi_22318_ = _e10596;
                                    phi_22319_ = _e10565;
                                }
                                let _e10604 = phi_22318_;
                                let _e10606 = phi_22319_;
                                phi_22323_ = _e10604;
                                phi_22324_ = _e10563;
                                phi_22325_ = _e10606;
                            } else {
                                phi_22323_ = _e7891;
                                phi_22324_ = type_44();
                                phi_22325_ = true;
                            }
                            let _e10608 = phi_22323_;
                            let _e10610 = phi_22324_;
                            let _e10612 = phi_22325_;
                            phi_22329_ = _e10608;
                            phi_22330_ = _e10610;
                            phi_22331_ = _e10612;
                        }
                        let _e10616 = phi_22329_;
                        let _e10618 = phi_22330_;
                        let _e10620 = phi_22331_;
                        if _e10620 {
                            phi_22335_ = _e10616;
                        } else {
                            phi_22335_ = _e10618;
                        }
                        let _e10622 = phi_22335_;
                        if (_e10622.member == 1u) {
                            if (_e10622.member_1 > _e5605) {
                                phi_22346_ = false;
                            } else {
                                phi_22346_ = true;
                            }
                            let _e10628 = phi_22346_;
                            phi_22347_ = _e10628;
                        } else {
                            phi_22347_ = true;
                        }
                        let _e10630 = phi_22347_;
                        if _e10630 {
                            phi_22351_ = false;
                        } else {
                            phi_22351_ = true;
                        }
                        let _e10632 = phi_22351_;
                        if _e10632 {
                            phi_22355_ = 1u;
                        } else {
                            phi_22355_ = 0u;
                        }
                        let _e10634 = phi_22355_;
                        phi_22359_ = type_45(_e10622, _e10634);
                    }
                    let _e15174 = phi_22359_;
                    switch bitcast<i32>(_e15174.member.member) {
                        case 0: {
                            phi_22377_ = type_28(0u, _e15174.member_1, array<u32, 2>(0u, 0u), false);
                            break;
                        }
                        case 1: {
                            let _e15185 = function_(_e15174.member.member_1);
                            phi_22377_ = type_28(0u, _e15174.member_1, _e15185, true);
                            break;
                        }
                        case 2: {
                            let _e15181 = function_(_e15174.member.member_1);
                            phi_22377_ = type_28(1u, _e15174.member_1, _e15181, true);
                            break;
                        }
                        default: {
                            phi_22377_ = type_28();
                            break;
                        }
                    }
                    let _e15189 = phi_22377_;
                    let _e15193 = params.member.member.member_12;
                    let _e15194 = bitcast<u32>(_e15193);
                    let _e15195 = (_e15194 & 2147483647u);
                    if (_e15195 < 8388608u) {
                        phi_22393_ = array<u32, 2>(0u, 0u);
                    } else {
                        phi_22393_ = array<u32, 2>((_e15194 << bitcast<u32>(29i)), ((_e15194 ^ _e15195) | ((_e15195 >> bitcast<u32>(3i)) + 939524096u)));
                    }
                    let _e15206 = phi_22393_;
                    if (_e15189.member_2[0] == _e15206[0]) {
                        let _e15212 = params.member.member.member_12;
                        let _e15213 = bitcast<u32>(_e15212);
                        let _e15214 = (_e15213 & 2147483647u);
                        if (_e15214 < 8388608u) {
                            phi_22414_ = array<u32, 2>(0u, 0u);
                        } else {
                            phi_22414_ = array<u32, 2>((_e15213 << bitcast<u32>(29i)), ((_e15213 ^ _e15214) | ((_e15214 >> bitcast<u32>(3i)) + 939524096u)));
                        }
                        let _e15225 = phi_22414_;
                        phi_22417_ = (_e15189.member_2[1] == _e15225[1]);
                    } else {
                        phi_22417_ = false;
                    }
                    let _e15229 = phi_22417_;
                    let _e15231 = params.member.member.member_1;
                    if ((_e15231 & 128u) != 0u) {
                        phi_22433_ = true;
                    } else {
                        let _e15235 = params.member.member.member_1;
                        if ((_e15235 & 64u) != 0u) {
                            phi_22432_ = _e15229;
                        } else {
                            phi_22432_ = false;
                        }
                        let _e15239 = phi_22432_;
                        phi_22433_ = _e15239;
                    }
                    let _e15241 = phi_22433_;
                    if _e15189.member_3 {
                        if _e15241 {
                            phi_22441_ = false;
                        } else {
                            phi_22441_ = true;
                        }
                        let _e15244 = phi_22441_;
                        phi_22442_ = _e15244;
                    } else {
                        phi_22442_ = true;
                    }
                    let _e15246 = phi_22442_;
                    if _e15246 {
                        phi_22447_ = _e15189.member;
                    } else {
                        phi_22447_ = 1u;
                    }
                    let _e15249 = phi_22447_;
                    phi_22452_ = type_28(_e15249, _e15189.member_1, _e15189.member_2, _e15189.member_3);
                } else {
                    phi_22452_ = _e5570;
                }
                let _e15255 = phi_22452_;
                if _e15255.member_3 {
                    phi_22459_ = (_e15255.member == 0u);
                } else {
                    phi_22459_ = false;
                }
                let _e15260 = phi_22459_;
                if _e15260 {
                    let _e15269 = (_e15255.member_2[1] >> bitcast<u32>(20i));
                    if (_e15269 <= 896u) {
                        phi_22484_ = 0u;
                    } else {
                        phi_22484_ = ((((_e15269 - 896u) << bitcast<u32>(23i)) | ((_e15255.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e15255.member_2[0] >> bitcast<u32>(29i)));
                    }
                    let _e15284 = phi_22484_;
                    let _e15286 = atomicMin((&earliest.member[0u]), _e15284);
                }
                phi_22488_ = type_20(_e270, 0u, _e280, _e283, _e15255.member_2, _e15255.member_1);
                phi_22489_ = _e15260;
                phi_22490_ = (_e15255.member != 0u);
            } else {
                phi_22488_ = type_20(_e270, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_22489_ = false;
                phi_22490_ = false;
            }
            let _e15288 = phi_22488_;
            let _e15290 = phi_22489_;
            let _e15292 = phi_22490_;
            let _e15295 = params.member.member.member_1;
            if ((_e15295 & 16u) != 0u) {
                if (_e186 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e15290 {
                    let _e15301 = atomicAdd((&counters[0u]), 1u);
                    phi_22509_ = _e15301;
                } else {
                    phi_22509_ = 0u;
                }
                let _e15303 = phi_22509_;
                workgroupBarrier();
                if (_e186 == 0u) {
                    let _e15306 = atomicLoad((&counters[0u]));
                    if (_e15306 > 0u) {
                        let _e15309 = atomicAdd((&contacts.member[0u]), _e15306);
                        atomicStore((&counters[1u]), _e15309);
                    }
                }
                workgroupBarrier();
                let _e15312 = atomicLoad((&counters[1u]));
                let _e15313 = (_e15312 + _e15303);
                if _e15290 {
                    let _e15316 = params.member.member_1.member_3;
                    if (_e15313 < _e15316) {
                        let _e15318 = (7u * _e15313);
                        atomicStore((&contacts.member[(4u + _e15318)]), _e15288.member);
                        atomicStore((&contacts.member[(_e15318 + 5u)]), _e15288.member_1);
                        atomicStore((&contacts.member[(_e15318 + 6u)]), _e15288.member_2);
                        atomicStore((&contacts.member[(_e15318 + 7u)]), _e15288.member_3);
                        atomicStore((&contacts.member[(_e15318 + 8u)]), _e15288.member_4[0]);
                        atomicStore((&contacts.member[(_e15318 + 9u)]), _e15288.member_4[1]);
                        atomicStore((&contacts.member[(_e15318 + 10u)]), _e15288.member_5);
                    }
                }
            }
            workgroupBarrier();
            if (_e186 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e15292 {
                let _e15345 = atomicAdd((&counters[0u]), 1u);
                phi_22576_ = _e15345;
            } else {
                phi_22576_ = 0u;
            }
            let _e15347 = phi_22576_;
            workgroupBarrier();
            if (_e186 == 0u) {
                let _e15350 = atomicLoad((&counters[0u]));
                if (_e15350 > 0u) {
                    let _e15353 = atomicAdd((&undecided.member[0u]), _e15350);
                    atomicStore((&counters[1u]), _e15353);
                }
            }
            workgroupBarrier();
            let _e15356 = atomicLoad((&counters[1u]));
            let _e15357 = (_e15356 + _e15347);
            if _e15292 {
                let _e15363 = params.member.member_2.member.member_1;
                if (_e15357 < _e15363) {
                    let _e15365 = (2u * _e15357);
                    atomicStore((&undecided.member[(4u + _e15365)]), _e15288.member_2);
                    atomicStore((&undecided.member[(_e15365 + 5u)]), _e15288.member_3);
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
