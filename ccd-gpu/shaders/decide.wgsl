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
    var phi_23645_: array<u32, 2>;

    let _e7 = bitcast<u32>(param);
    let _e8 = (_e7 & 2147483647u);
    if (_e8 < 8388608u) {
        phi_23645_ = array<u32, 2>(0u, 0u);
    } else {
        phi_23645_ = array<u32, 2>((_e7 << bitcast<u32>(29i)), ((_e7 ^ _e8) | ((_e8 >> bitcast<u32>(3i)) + 939524096u)));
    }
    let _e19 = phi_23645_;
    return _e19;
}

fn function_1(param_1: array<f32, 3>, param_2: array<f32, 3>) -> array<f32, 3> {
    var phi_23630_: array<f32, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_23630_ = param_2;
    } else {
        phi_23630_ = param_1;
    }
    let _e26 = phi_23630_;
    return _e26;
}

fn function_2(param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: array<f32, 3>, param_6: u32) -> array<f32, 3> {
    var phi_23491_: f32;
    var phi_23492_: f32;
    var phi_23531_: f32;
    var phi_23532_: f32;
    var phi_23577_: f32;
    var phi_23578_: f32;
    var phi_23312_: f32;
    var phi_23313_: f32;
    var phi_23358_: f32;
    var phi_23359_: f32;
    var phi_23401_: f32;
    var phi_23402_: f32;
    var phi_23450_: f32;
    var phi_23451_: f32;
    var phi_23593_: array<array<f32, 3>, 4>;

    let _e9 = (param_3[0] - param_4[0]);
    let _e12 = (param_3[1] - param_4[1]);
    let _e15 = (param_3[2] - param_4[2]);
    if (param_6 != 0u) {
        let _e157 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e157 > 0f) {
            if (_e157 < 1f) {
                phi_23312_ = _e157;
            } else {
                phi_23312_ = 1f;
            }
            let _e161 = phi_23312_;
            phi_23313_ = _e161;
        } else {
            phi_23313_ = 0f;
        }
        let _e163 = phi_23313_;
        let _e199 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e199 > 0f) {
            if (_e199 < 1f) {
                phi_23358_ = _e199;
            } else {
                phi_23358_ = 1f;
            }
            let _e203 = phi_23358_;
            phi_23359_ = _e203;
        } else {
            phi_23359_ = 0f;
        }
        let _e205 = phi_23359_;
        let _e238 = ((((_e9 * param_5[0]) + (_e12 * param_5[1])) + (_e15 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e238 > 0f) {
            if (_e238 < 1f) {
                phi_23401_ = _e238;
            } else {
                phi_23401_ = 1f;
            }
            let _e242 = phi_23401_;
            phi_23402_ = _e242;
        } else {
            phi_23402_ = 0f;
        }
        let _e244 = phi_23402_;
        let _e257 = (param_3[0] - param_5[0]);
        let _e260 = (param_3[1] - param_5[1]);
        let _e263 = (param_3[2] - param_5[2]);
        let _e283 = ((((_e257 * param_4[0]) + (_e260 * param_4[1])) + (_e263 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e283 > 0f) {
            if (_e283 < 1f) {
                phi_23450_ = _e283;
            } else {
                phi_23450_ = 1f;
            }
            let _e287 = phi_23450_;
            phi_23451_ = _e287;
        } else {
            phi_23451_ = 0f;
        }
        let _e289 = phi_23451_;
        phi_23593_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e163)), (param_3[1] - (param_4[1] * _e163)), (param_3[2] - (param_4[2] * _e163))), array<f32, 3>((param_3[0] - (param_5[0] * _e205)), (param_3[1] - (param_5[1] * _e205)), (param_3[2] - (param_5[2] * _e205))), array<f32, 3>((_e9 - (param_5[0] * _e244)), (_e12 - (param_5[1] * _e244)), (_e15 - (param_5[2] * _e244))), array<f32, 3>((_e257 - (param_4[0] * _e289)), (_e260 - (param_4[1] * _e289)), (_e263 - (param_4[2] * _e289))));
    } else {
        let _e19 = (param_5[0] - param_4[0]);
        let _e22 = (param_5[1] - param_4[1]);
        let _e25 = (param_5[2] - param_4[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        if (_e36 > 0f) {
            if (_e36 < 1f) {
                phi_23491_ = _e36;
            } else {
                phi_23491_ = 1f;
            }
            let _e40 = phi_23491_;
            phi_23492_ = _e40;
        } else {
            phi_23492_ = 0f;
        }
        let _e42 = phi_23492_;
        let _e49 = array<f32, 3>((_e9 - (_e19 * _e42)), (_e12 - (_e22 * _e42)), (_e15 - (_e25 * _e42)));
        let _e72 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e72 > 0f) {
            if (_e72 < 1f) {
                phi_23531_ = _e72;
            } else {
                phi_23531_ = 1f;
            }
            let _e76 = phi_23531_;
            phi_23532_ = _e76;
        } else {
            phi_23532_ = 0f;
        }
        let _e78 = phi_23532_;
        let _e114 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e114 > 0f) {
            if (_e114 < 1f) {
                phi_23577_ = _e114;
            } else {
                phi_23577_ = 1f;
            }
            let _e118 = phi_23577_;
            phi_23578_ = _e118;
        } else {
            phi_23578_ = 0f;
        }
        let _e120 = phi_23578_;
        phi_23593_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e78)), (param_3[1] - (param_4[1] * _e78)), (param_3[2] - (param_4[2] * _e78))), array<f32, 3>((param_3[0] - (param_5[0] * _e120)), (param_3[1] - (param_5[1] * _e120)), (param_3[2] - (param_5[2] * _e120))), _e49, _e49);
    }
    let _e302 = phi_23593_;
    let _e305 = function_1(_e302[0], _e302[1]);
    let _e307 = function_1(_e305, _e302[2]);
    let _e309 = function_1(_e307, _e302[3]);
    return _e309;
}

fn function_3(param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: array<f32, 3>, param_10: u32) -> array<f32, 3> {
    var phi_23213_: bool;
    var phi_23214_: bool;
    var phi_23215_: bool;
    var phi_23216_: bool;
    var phi_23220_: bool;
    var phi_23193_: bool;
    var phi_23194_: bool;
    var phi_23195_: bool;
    var phi_23196_: bool;
    var phi_23197_: bool;
    var phi_23198_: bool;
    var phi_23202_: bool;
    var phi_23221_: bool;
    var phi_23254_: array<f32, 3>;
    var phi_23255_: bool;
    var phi_23256_: array<f32, 3>;
    var phi_23257_: bool;
    var phi_23262_: array<f32, 3>;

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
                    phi_23193_ = (_e78 <= 1f);
                    phi_23194_ = false;
                } else {
                    phi_23193_ = bool();
                    phi_23194_ = true;
                }
                let _e99 = phi_23193_;
                let _e101 = phi_23194_;
                phi_23195_ = _e99;
                phi_23196_ = _e101;
            } else {
                phi_23195_ = bool();
                phi_23196_ = true;
            }
            let _e103 = phi_23195_;
            let _e105 = phi_23196_;
            phi_23197_ = _e103;
            phi_23198_ = _e105;
        } else {
            phi_23197_ = bool();
            phi_23198_ = true;
        }
        let _e107 = phi_23197_;
        let _e109 = phi_23198_;
        if _e109 {
            phi_23202_ = false;
        } else {
            phi_23202_ = _e107;
        }
        let _e111 = phi_23202_;
        phi_23221_ = _e111;
    } else {
        if (_e74 >= 0f) {
            if (_e78 >= 0f) {
                phi_23213_ = ((_e74 + _e78) <= 1f);
                phi_23214_ = false;
            } else {
                phi_23213_ = bool();
                phi_23214_ = true;
            }
            let _e85 = phi_23213_;
            let _e87 = phi_23214_;
            phi_23215_ = _e85;
            phi_23216_ = _e87;
        } else {
            phi_23215_ = bool();
            phi_23216_ = true;
        }
        let _e89 = phi_23215_;
        let _e91 = phi_23216_;
        if _e91 {
            phi_23220_ = false;
        } else {
            phi_23220_ = _e89;
        }
        let _e93 = phi_23220_;
        phi_23221_ = _e93;
    }
    let _e113 = phi_23221_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e113 {
            phi_23254_ = array<f32, 3>((param_7[0] - ((param_8[0] * _e74) + (param_9[0] * _e78))), (param_7[1] - ((param_8[1] * _e74) + (param_9[1] * _e78))), (param_7[2] - ((param_8[2] * _e74) + (param_9[2] * _e78))));
            phi_23255_ = false;
        } else {
            phi_23254_ = array<f32, 3>();
            phi_23255_ = true;
        }
        let _e141 = phi_23254_;
        let _e143 = phi_23255_;
        phi_23256_ = _e141;
        phi_23257_ = _e143;
    } else {
        phi_23256_ = array<f32, 3>();
        phi_23257_ = true;
    }
    let _e145 = phi_23256_;
    let _e147 = phi_23257_;
    if _e147 {
        let _e148 = function_2(param_7, param_8, param_9, param_10);
        phi_23262_ = _e148;
    } else {
        phi_23262_ = _e145;
    }
    let _e150 = phi_23262_;
    return _e150;
}

fn function_4(param_11: u32, param_12: u32, param_13: u32) -> type_9 {
    var phi_22911_: u32;
    var phi_22918_: type_9;
    var phi_22960_: u32;
    var phi_22978_: u32;
    var phi_22985_: type_9;

    if ((param_11 >> bitcast<u32>(31i)) != 0u) {
        if (param_12 == 0u) {
            phi_22911_ = 1u;
        } else {
            phi_22911_ = 0u;
        }
        let _e15 = phi_22911_;
        phi_22918_ = type_9((~(param_11) + _e15), (~(param_12) + 1u));
    } else {
        phi_22918_ = type_9(param_11, param_12);
    }
    let _e22 = phi_22918_;
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
        phi_22960_ = 1u;
    } else {
        phi_22960_ = 0u;
    }
    let _e72 = phi_22960_;
    let _e78 = ((((((_e26 * _e29) + (_e35 >> bitcast<u32>(16i))) + (((_e27 * _e29) + (_e35 & 65535u)) >> bitcast<u32>(16i))) + _e72) << bitcast<u32>(1i)) | (_e69 >> bitcast<u32>(31i)));
    let _e83 = ((_e69 << bitcast<u32>(1i)) | ((_e22.member_1 * param_13) >> bitcast<u32>(31i)));
    if ((param_11 >> bitcast<u32>(31i)) != 0u) {
        if (_e83 == 0u) {
            phi_22978_ = 1u;
        } else {
            phi_22978_ = 0u;
        }
        let _e90 = phi_22978_;
        phi_22985_ = type_9((~(_e78) + _e90), (~(_e83) + 1u));
    } else {
        phi_22985_ = type_9(_e78, _e83);
    }
    let _e97 = phi_22985_;
    return _e97;
}

fn function_5(param_14: array<type_9, 3>, param_15: u32) -> array<type_9, 2> {
    var phi_23063_: u32;
    var phi_23075_: u32;
    var phi_23086_: u32;
    var phi_23098_: u32;

    if (param_14[1].member_1 < param_14[0].member_1) {
        phi_23063_ = 1u;
    } else {
        phi_23063_ = 0u;
    }
    let _e14 = phi_23063_;
    let _e18 = function_4(((param_14[1].member - param_14[0].member) - _e14), (param_14[1].member_1 - param_14[0].member_1), param_15);
    let _e21 = (param_14[0].member_1 + _e18.member_1);
    if (_e21 < param_14[0].member_1) {
        phi_23075_ = 1u;
    } else {
        phi_23075_ = 0u;
    }
    let _e24 = phi_23075_;
    if (param_14[2].member_1 < param_14[1].member_1) {
        phi_23086_ = 1u;
    } else {
        phi_23086_ = 0u;
    }
    let _e37 = phi_23086_;
    let _e41 = function_4(((param_14[2].member - param_14[1].member) - _e37), (param_14[2].member_1 - param_14[1].member_1), param_15);
    let _e44 = (param_14[1].member_1 + _e41.member_1);
    if (_e44 < param_14[1].member_1) {
        phi_23098_ = 1u;
    } else {
        phi_23098_ = 0u;
    }
    let _e47 = phi_23098_;
    return array<type_9, 2>(type_9(((param_14[0].member + _e18.member) + _e24), _e21), type_9(((param_14[1].member + _e41.member) + _e47), _e44));
}

fn function_6(param_16: u32, param_17: u32, param_18: u32, param_19: u32) -> bool {
    var phi_23047_: u32;

    if (param_19 < param_17) {
        phi_23047_ = 1u;
    } else {
        phi_23047_ = 0u;
    }
    let _e9 = phi_23047_;
    return ((((param_18 - param_16) - _e9) >> bitcast<u32>(31i)) != 0u);
}

fn function_7(param_20: u32, param_21: u32, param_22: u32, param_23: u32) -> bool {
    var phi_23024_: u32;
    var phi_23033_: u32;

    if (param_21 == 0u) {
        phi_23024_ = 1u;
    } else {
        phi_23024_ = 0u;
    }
    let _e9 = phi_23024_;
    if (param_23 < (~(param_21) + 1u)) {
        phi_23033_ = 1u;
    } else {
        phi_23033_ = 0u;
    }
    let _e16 = phi_23033_;
    return ((((param_22 - (~(param_20) + _e9)) - _e16) >> bitcast<u32>(31i)) != 0u);
}

fn function_8(param_24: u32, param_25: u32, param_26: u32, param_27: u32) -> type_9 {
    var phi_22736_: u32;
    var phi_22743_: type_9;
    var phi_22755_: u32;
    var phi_22762_: type_9;
    var phi_22821_: u32;
    var phi_22827_: u32;
    var phi_22835_: u32;
    var phi_22843_: u32;
    var phi_22864_: u32;
    var phi_22871_: type_9;

    if ((param_24 >> bitcast<u32>(31i)) != 0u) {
        if (param_25 == 0u) {
            phi_22736_ = 1u;
        } else {
            phi_22736_ = 0u;
        }
        let _e17 = phi_22736_;
        phi_22743_ = type_9((~(param_24) + _e17), (~(param_25) + 1u));
    } else {
        phi_22743_ = type_9(param_24, param_25);
    }
    let _e24 = phi_22743_;
    if ((param_26 >> bitcast<u32>(31i)) != 0u) {
        if (param_27 == 0u) {
            phi_22755_ = 1u;
        } else {
            phi_22755_ = 0u;
        }
        let _e33 = phi_22755_;
        phi_22762_ = type_9((~(param_26) + _e33), (~(param_27) + 1u));
    } else {
        phi_22762_ = type_9(param_26, param_27);
    }
    let _e40 = phi_22762_;
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
        phi_22821_ = 1u;
    } else {
        phi_22821_ = 0u;
    }
    let _e112 = phi_22821_;
    let _e113 = (_e64 + (((_e66 * _e69) + (_e75 >> bitcast<u32>(16i))) + (((_e67 * _e69) + (_e75 & 65535u)) >> bitcast<u32>(16i))));
    if (_e113 < _e64) {
        phi_22827_ = 1u;
    } else {
        phi_22827_ = 0u;
    }
    let _e116 = phi_22827_;
    let _e118 = (_e113 + (((_e88 * _e91) + (_e97 >> bitcast<u32>(16i))) + (((_e89 * _e91) + (_e97 & 65535u)) >> bitcast<u32>(16i))));
    if (_e118 < _e113) {
        phi_22835_ = 1u;
    } else {
        phi_22835_ = 0u;
    }
    let _e121 = phi_22835_;
    let _e123 = (_e118 + _e112);
    if (_e123 < _e118) {
        phi_22843_ = 1u;
    } else {
        phi_22843_ = 0u;
    }
    let _e126 = phi_22843_;
    let _e132 = ((_e123 << bitcast<u32>(2i)) | (_e109 >> bitcast<u32>(30i)));
    let _e137 = ((((((((_e44 * _e47) + (_e53 >> bitcast<u32>(16i))) + (((_e45 * _e47) + (_e53 & 65535u)) >> bitcast<u32>(16i))) + _e116) + _e121) + _e126) << bitcast<u32>(2i)) | (_e123 >> bitcast<u32>(30i)));
    if (((param_24 >> bitcast<u32>(31i)) != 0u) != ((param_26 >> bitcast<u32>(31i)) != 0u)) {
        if (_e132 == 0u) {
            phi_22864_ = 1u;
        } else {
            phi_22864_ = 0u;
        }
        let _e148 = phi_22864_;
        phi_22871_ = type_9((~(_e137) + _e148), (~(_e132) + 1u));
    } else {
        phi_22871_ = type_9(_e137, _e132);
    }
    let _e155 = phi_22871_;
    return _e155;
}

fn function_9(param_28: array<type_9, 2>, param_29: array<type_9, 2>) -> type_9 {
    var phi_23010_: u32;

    let _e12 = function_8(param_28[0].member, param_28[0].member_1, param_29[1].member, param_29[1].member_1);
    let _e23 = function_8(param_28[1].member, param_28[1].member_1, param_29[0].member, param_29[0].member_1);
    if (_e12.member_1 < _e23.member_1) {
        phi_23010_ = 1u;
    } else {
        phi_23010_ = 0u;
    }
    let _e28 = phi_23010_;
    return type_9(((_e12.member - _e23.member) - _e28), (_e12.member_1 - _e23.member_1));
}

fn function_10(param_30: u32) -> type_9 {
    return type_9(0u, param_30);
}

fn function_11(param_31: u32, param_32: u32) -> type_9 {
    var phi_22883_: u32;
    var phi_22891_: u32;

    let _e4 = (param_32 + param_32);
    if (_e4 < param_32) {
        phi_22883_ = 1u;
    } else {
        phi_22883_ = 0u;
    }
    let _e7 = phi_22883_;
    let _e10 = (_e4 + param_32);
    if (_e10 < _e4) {
        phi_22891_ = 1u;
    } else {
        phi_22891_ = 0u;
    }
    let _e13 = phi_22891_;
    return type_9(((((param_31 + param_31) + _e7) + param_31) + _e13), _e10);
}

fn function_12(param_33: array<u32, 2>, param_34: i32) -> type_9 {
    var phi_22685_: type_9;
    var phi_22686_: type_9;
    var phi_22687_: type_9;
    var phi_22688_: type_9;
    var phi_22689_: type_9;
    var phi_22690_: bool;
    var phi_22695_: type_9;
    var phi_22707_: u32;
    var phi_22714_: type_9;
    var phi_22718_: type_9;

    let _e25 = ((param_33[1] >> bitcast<u32>(20i)) & 2047u);
    if (_e25 == 0u) {
        phi_22718_ = type_9(0u, 0u);
    } else {
        let _e28 = ((param_33[1] & 1048575u) | 1048576u);
        let _e31 = ((bitcast<i32>(_e25) - 1015i) - param_34);
        let _e33 = (bitcast<u32>(_e31) % 32u);
        if (_e31 >= 64i) {
            phi_22689_ = type_9();
            phi_22690_ = true;
        } else {
            let _e35 = (_e31 <= -53i);
            if _e35 {
                phi_22688_ = type_9();
            } else {
                if (_e31 >= 32i) {
                    phi_22687_ = type_9((param_33[0] << bitcast<u32>((_e33 & 31u))), 0u);
                } else {
                    if (_e31 >= 0i) {
                        phi_22686_ = type_9(((_e28 << bitcast<u32>((_e33 & 31u))) | ((param_33[0] >> bitcast<u32>(1i)) >> bitcast<u32>(((31u - _e33) & 31u)))), (param_33[0] << bitcast<u32>((_e33 & 31u))));
                    } else {
                        if (_e31 > -32i) {
                            let _e47 = bitcast<u32>(-(_e31));
                            phi_22685_ = type_9(bitcast<u32>((bitcast<i32>(_e28) >> bitcast<u32>((_e47 & 31u)))), ((param_33[0] >> bitcast<u32>((_e47 & 31u))) | ((_e28 << bitcast<u32>(((31u - _e47) & 31u))) << bitcast<u32>(1i))));
                        } else {
                            phi_22685_ = type_9(0u, (_e28 >> bitcast<u32>(((bitcast<u32>(-(_e31)) - 32u) & 31u))));
                        }
                        let _e65 = phi_22685_;
                        phi_22686_ = _e65;
                    }
                    let _e81 = phi_22686_;
                    phi_22687_ = _e81;
                }
                let _e87 = phi_22687_;
                phi_22688_ = _e87;
            }
            let _e89 = phi_22688_;
            phi_22689_ = _e89;
            phi_22690_ = _e35;
        }
        let _e91 = phi_22689_;
        let _e93 = phi_22690_;
        if _e93 {
            phi_22695_ = type_9(0u, 0u);
        } else {
            phi_22695_ = _e91;
        }
        let _e95 = phi_22695_;
        if ((param_33[1] >> bitcast<u32>(31i)) != 0u) {
            if (_e95.member_1 == 0u) {
                phi_22707_ = 1u;
            } else {
                phi_22707_ = 0u;
            }
            let _e103 = phi_22707_;
            phi_22714_ = type_9((~(_e95.member) + _e103), (~(_e95.member_1) + 1u));
        } else {
            phi_22714_ = _e95;
        }
        let _e110 = phi_22714_;
        phi_22718_ = _e110;
    }
    let _e112 = phi_22718_;
    return _e112;
}

fn function_13(param_35: f32, param_36: f32) -> f32 {
    var phi_22608_: bool;
    var phi_22612_: f32;

    if (param_35 != param_35) {
        phi_22608_ = true;
    } else {
        phi_22608_ = (param_36 >= param_35);
    }
    let _e6 = phi_22608_;
    if _e6 {
        phi_22612_ = param_36;
    } else {
        phi_22612_ = param_35;
    }
    let _e8 = phi_22612_;
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
    var phi_361_: u32;
    var phi_371_: u32;
    var phi_378_: u32;
    var phi_394_: u32;
    var phi_415_: u32;
    var phi_416_: u32;
    var phi_419_: type_9;
    var phi_420_: type_9;
    var phi_443_: type_9;
    var phi_579_: type_25;
    var phi_1001_: type_23;
    var phi_1009_: f32;
    var phi_1016_: f32;
    var phi_1021_: f32;
    var phi_1028_: f32;
    var phi_1033_: f32;
    var phi_1041_: f32;
    var phi_1048_: f32;
    var phi_1053_: f32;
    var phi_1060_: f32;
    var phi_1065_: f32;
    var phi_1070_: f32;
    var phi_1080_: f32;
    var phi_1087_: f32;
    var phi_1092_: f32;
    var phi_1099_: f32;
    var phi_1104_: f32;
    var phi_1112_: f32;
    var phi_1119_: f32;
    var phi_1124_: f32;
    var phi_1131_: f32;
    var phi_1136_: f32;
    var phi_1141_: f32;
    var phi_1151_: f32;
    var phi_1158_: f32;
    var phi_1163_: f32;
    var phi_1170_: f32;
    var phi_1175_: f32;
    var phi_1183_: f32;
    var phi_1190_: f32;
    var phi_1195_: f32;
    var phi_1202_: f32;
    var phi_1207_: f32;
    var phi_1212_: f32;
    var phi_1229_: i32;
    var phi_1230_: bool;
    var phi_1231_: i32;
    var phi_1232_: bool;
    var phi_1236_: i32;
    var phi_1278_: array<u32, 2>;
    var phi_1295_: array<u32, 2>;
    var phi_1312_: array<u32, 2>;
    var phi_1346_: array<u32, 2>;
    var phi_1363_: array<u32, 2>;
    var phi_1380_: array<u32, 2>;
    var phi_1415_: array<u32, 2>;
    var phi_1432_: array<u32, 2>;
    var phi_1449_: array<u32, 2>;
    var phi_1483_: array<u32, 2>;
    var phi_1500_: array<u32, 2>;
    var phi_1517_: array<u32, 2>;
    var phi_1552_: array<u32, 2>;
    var phi_1569_: array<u32, 2>;
    var phi_1586_: array<u32, 2>;
    var phi_1620_: array<u32, 2>;
    var phi_1637_: array<u32, 2>;
    var phi_1654_: array<u32, 2>;
    var phi_1689_: array<u32, 2>;
    var phi_1706_: array<u32, 2>;
    var phi_1723_: array<u32, 2>;
    var phi_1757_: array<u32, 2>;
    var phi_1774_: array<u32, 2>;
    var phi_1791_: array<u32, 2>;
    var phi_2708_: array<array<array<type_9, 3>, 2>, 4>;
    var phi_2997_: u32;
    var phi_3009_: u32;
    var phi_3021_: u32;
    var phi_3041_: u32;
    var phi_3053_: u32;
    var phi_3065_: u32;
    var phi_3086_: u32;
    var phi_3098_: u32;
    var phi_3110_: u32;
    var phi_3130_: u32;
    var phi_3142_: u32;
    var phi_3154_: u32;
    var phi_3175_: u32;
    var phi_3187_: u32;
    var phi_3199_: u32;
    var phi_3219_: u32;
    var phi_3231_: u32;
    var phi_3243_: u32;
    var phi_2729_: u32;
    var phi_2741_: u32;
    var phi_2753_: u32;
    var phi_2773_: u32;
    var phi_2785_: u32;
    var phi_2797_: u32;
    var phi_2818_: u32;
    var phi_2830_: u32;
    var phi_2842_: u32;
    var phi_2862_: u32;
    var phi_2874_: u32;
    var phi_2886_: u32;
    var phi_2907_: u32;
    var phi_2919_: u32;
    var phi_2931_: u32;
    var phi_2951_: u32;
    var phi_2963_: u32;
    var phi_2975_: u32;
    var phi_3255_: array<array<array<type_9, 3>, 2>, 3>;
    var phi_3334_: u32;
    var phi_3414_: u32;
    var phi_3494_: u32;
    var phi_3582_: u32;
    var phi_3662_: u32;
    var phi_3742_: u32;
    var phi_3830_: u32;
    var phi_3910_: u32;
    var phi_3990_: u32;
    var phi_4078_: u32;
    var phi_4158_: u32;
    var phi_4238_: u32;
    var phi_4257_: u32;
    var phi_4269_: u32;
    var phi_4281_: u32;
    var phi_4310_: u32;
    var phi_4325_: u32;
    var phi_4351_: u32;
    var phi_4366_: u32;
    var phi_4389_: u32;
    var phi_4404_: u32;
    var phi_4412_: u32;
    var phi_4435_: u32;
    var phi_4450_: u32;
    var phi_4473_: u32;
    var phi_4488_: u32;
    var phi_4496_: u32;
    var phi_4519_: u32;
    var phi_4534_: u32;
    var phi_4550_: type_9;
    var phi_4553_: array<type_9, 4>;
    var phi_4557_: u32;
    var phi_4559_: u32;
    var phi_4551_: type_9;
    var phi_4582_: type_9;
    var phi_4617_: u32;
    var phi_4624_: type_9;
    var phi_4631_: u32;
    var phi_4644_: u32;
    var phi_4645_: u32;
    var phi_4660_: u32;
    var phi_4667_: type_9;
    var phi_4674_: u32;
    var phi_4687_: u32;
    var phi_4688_: u32;
    var phi_4704_: u32;
    var phi_4711_: type_9;
    var phi_4718_: u32;
    var phi_4731_: u32;
    var phi_4732_: u32;
    var phi_4748_: u32;
    var phi_4755_: type_9;
    var phi_4762_: u32;
    var phi_4775_: u32;
    var phi_4776_: u32;
    var phi_4779_: bool;
    var phi_4791_: bool;
    var phi_4809_: u32;
    var phi_4816_: type_9;
    var phi_4823_: u32;
    var phi_4836_: u32;
    var phi_4837_: u32;
    var phi_4852_: u32;
    var phi_4859_: type_9;
    var phi_4866_: u32;
    var phi_4879_: u32;
    var phi_4880_: u32;
    var phi_4887_: bool;
    var phi_4895_: u32;
    var phi_4913_: u32;
    var phi_4925_: u32;
    var phi_4937_: u32;
    var phi_4958_: u32;
    var phi_4965_: type_9;
    var phi_4979_: u32;
    var phi_4986_: type_9;
    var phi_4993_: u32;
    var phi_5003_: type_9;
    var phi_5017_: u32;
    var phi_5024_: type_9;
    var phi_5031_: u32;
    var phi_5041_: type_9;
    var phi_5052_: u32;
    var phi_5074_: u32;
    var phi_5087_: u32;
    var phi_5099_: u32;
    var phi_5111_: u32;
    var phi_5132_: u32;
    var phi_5139_: type_9;
    var phi_5153_: u32;
    var phi_5160_: type_9;
    var phi_5167_: u32;
    var phi_5177_: type_9;
    var phi_5191_: u32;
    var phi_5198_: type_9;
    var phi_5205_: u32;
    var phi_5215_: type_9;
    var phi_5226_: u32;
    var phi_5248_: u32;
    var phi_5261_: u32;
    var phi_5273_: u32;
    var phi_5285_: u32;
    var phi_5306_: u32;
    var phi_5313_: type_9;
    var phi_5327_: u32;
    var phi_5334_: type_9;
    var phi_5341_: u32;
    var phi_5351_: type_9;
    var phi_5365_: u32;
    var phi_5372_: type_9;
    var phi_5379_: u32;
    var phi_5389_: type_9;
    var phi_5400_: u32;
    var phi_5422_: u32;
    var phi_5443_: u32;
    var phi_5455_: u32;
    var phi_5466_: u32;
    var phi_5478_: u32;
    var phi_5489_: u32;
    var phi_5501_: u32;
    var phi_5520_: u32;
    var phi_5532_: u32;
    var phi_5543_: u32;
    var phi_5555_: u32;
    var phi_5566_: u32;
    var phi_5578_: u32;
    var phi_5597_: u32;
    var phi_5609_: u32;
    var phi_5620_: u32;
    var phi_5632_: u32;
    var phi_5643_: u32;
    var phi_5655_: u32;
    var phi_5740_: u32;
    var phi_5820_: u32;
    var phi_5900_: u32;
    var phi_5921_: u32;
    var phi_5928_: type_9;
    var phi_5942_: u32;
    var phi_5949_: type_9;
    var phi_5963_: u32;
    var phi_5970_: type_9;
    var phi_5977_: u32;
    var phi_5989_: u32;
    var phi_5997_: bool;
    var phi_5998_: bool;
    var phi_6006_: u32;
    var phi_6014_: i32;
    var phi_6015_: i32;
    var phi_6044_: array<type_9, 2>;
    var phi_6073_: array<type_9, 2>;
    var phi_6102_: array<type_9, 2>;
    var phi_6116_: type_9;
    var phi_6142_: u32;
    var phi_6164_: u32;
    var phi_6192_: u32;
    var phi_6214_: u32;
    var phi_6242_: u32;
    var phi_6264_: u32;
    var phi_6278_: u32;
    var phi_6285_: type_9;
    var phi_6292_: u32;
    var phi_6312_: u32;
    var phi_6319_: type_9;
    var phi_6332_: u32;
    var phi_6339_: type_9;
    var phi_6352_: u32;
    var phi_6359_: type_9;
    var phi_6406_: u32;
    var phi_6414_: u32;
    var phi_6424_: u32;
    var phi_6432_: u32;
    var phi_6370_: u32;
    var phi_6380_: u32;
    var phi_6388_: u32;
    var phi_6398_: u32;
    var phi_6438_: type_9;
    var phi_6439_: type_9;
    var phi_6440_: type_9;
    var phi_6441_: type_9;
    var phi_6554_: bool;
    var phi_6555_: bool;
    var phi_6556_: bool;
    var phi_6557_: bool;
    var phi_6561_: u32;
    var phi_6562_: u32;
    var phi_6563_: u32;
    var phi_6564_: bool;
    var phi_6565_: u32;
    var phi_6566_: bool;
    var phi_6567_: u32;
    var phi_6568_: bool;
    var phi_6572_: u32;
    var phi_6573_: u32;
    var phi_6581_: bool;
    var phi_6585_: bool;
    var phi_6586_: bool;
    var phi_6587_: bool;
    var phi_6588_: u32;
    var phi_6589_: u32;
    var phi_6590_: bool;
    var phi_6606_: u32;
    var phi_6629_: u32;
    var phi_6652_: u32;
    var phi_6671_: u32;
    var phi_6690_: u32;
    var phi_6709_: u32;
    var phi_6749_: u32;
    var phi_6756_: type_9;
    var phi_6763_: u32;
    var phi_6776_: u32;
    var phi_6777_: u32;
    var phi_6792_: u32;
    var phi_6799_: type_9;
    var phi_6806_: u32;
    var phi_6819_: u32;
    var phi_6820_: u32;
    var phi_6836_: u32;
    var phi_6843_: type_9;
    var phi_6850_: u32;
    var phi_6863_: u32;
    var phi_6864_: u32;
    var phi_6880_: u32;
    var phi_6887_: type_9;
    var phi_6894_: u32;
    var phi_6907_: u32;
    var phi_6908_: u32;
    var phi_6925_: array<type_9, 4>;
    var phi_6926_: u32;
    var phi_6927_: array<type_9, 4>;
    var phi_6929_: u32;
    var phi_6930_: u32;
    var phi_6931_: array<type_9, 4>;
    var phi_6933_: u32;
    var phi_6934_: u32;
    var phi_6935_: array<type_9, 4>;
    var phi_6937_: bool;
    var phi_6938_: u32;
    var phi_6939_: u32;
    var phi_6940_: bool;
    var phi_6941_: bool;
    var phi_6942_: u32;
    var phi_6943_: u32;
    var phi_6944_: bool;
    var phi_6963_: u32;
    var phi_6975_: bool;
    var phi_6976_: bool;
    var phi_6994_: u32;
    var phi_7006_: u32;
    var phi_7017_: u32;
    var phi_7029_: u32;
    var phi_7040_: u32;
    var phi_7052_: u32;
    var phi_7069_: u32;
    var phi_7081_: u32;
    var phi_7092_: u32;
    var phi_7104_: u32;
    var phi_7115_: u32;
    var phi_7127_: u32;
    var phi_7147_: u32;
    var phi_7159_: u32;
    var phi_7170_: u32;
    var phi_7182_: u32;
    var phi_7193_: u32;
    var phi_7205_: u32;
    var phi_7216_: u32;
    var phi_7228_: u32;
    var phi_7239_: array<type_9, 4>;
    var phi_7240_: array<type_9, 4>;
    var phi_7241_: u32;
    var phi_7242_: u32;
    var phi_7243_: bool;
    var phi_7247_: bool;
    var phi_7248_: array<type_9, 4>;
    var phi_7249_: u32;
    var phi_7250_: u32;
    var phi_7251_: bool;
    var phi_7252_: bool;
    var phi_7253_: bool;
    var phi_7254_: array<type_9, 4>;
    var phi_7256_: u32;
    var phi_7257_: u32;
    var phi_7258_: bool;
    var phi_7259_: bool;
    var phi_7260_: u32;
    var phi_7261_: u32;
    var phi_7262_: bool;
    var phi_7263_: bool;
    var phi_7264_: bool;
    var phi_4554_: array<type_9, 4>;
    var phi_4558_: u32;
    var phi_4560_: u32;
    var phi_7265_: u32;
    var phi_7266_: bool;
    var phi_7267_: bool;
    var phi_7268_: u32;
    var phi_7269_: u32;
    var phi_7270_: bool;
    var phi_7271_: bool;
    var phi_7272_: bool;
    var phi_7273_: bool;
    var phi_7274_: bool;
    var local_62: bool;
    var phi_7279_: type_9;
    var phi_7280_: bool;
    var phi_7281_: bool;
    var phi_7282_: bool;
    var phi_7287_: type_9;
    var phi_7288_: bool;
    var phi_7289_: bool;
    var phi_7290_: bool;
    var phi_7295_: type_9;
    var phi_7296_: bool;
    var phi_7297_: bool;
    var local_63: bool;
    var local_64: u32;
    var local_65: array<type_9, 4>;
    var local_66: array<type_9, 4>;
    var local_67: array<type_9, 4>;
    var phi_7322_: u32;
    var phi_7329_: type_9;
    var phi_7336_: u32;
    var phi_7349_: u32;
    var phi_7350_: u32;
    var phi_7359_: u32;
    var local_68: u32;
    var phi_7371_: u32;
    var phi_7382_: u32;
    var local_69: u32;
    var phi_7394_: u32;
    var phi_7405_: u32;
    var local_70: u32;
    var phi_7417_: u32;
    var phi_7434_: u32;
    var local_71: u32;
    var phi_7446_: u32;
    var phi_7457_: u32;
    var local_72: u32;
    var phi_7469_: u32;
    var phi_7480_: u32;
    var local_73: u32;
    var phi_7492_: u32;
    var local_74: u32;
    var local_75: u32;
    var local_76: u32;
    var phi_7512_: u32;
    var local_77: u32;
    var phi_7524_: u32;
    var phi_7535_: u32;
    var local_78: u32;
    var phi_7558_: u32;
    var local_79: u32;
    var phi_7581_: u32;
    var local_80: u32;
    var phi_7618_: u32;
    var phi_7625_: type_9;
    var phi_7632_: u32;
    var phi_7645_: u32;
    var phi_7646_: u32;
    var phi_7649_: bool;
    var phi_7650_: bool;
    var phi_7651_: bool;
    var phi_7652_: bool;
    var phi_7656_: bool;
    var local_81: u32;
    var local_82: u32;
    var phi_7662_: bool;
    var local_83: u32;
    var phi_7670_: bool;
    var phi_7671_: bool;
    var phi_7672_: bool;
    var phi_7673_: bool;
    var phi_7677_: bool;
    var local_84: u32;
    var phi_7683_: type_9;
    var phi_7684_: type_9;
    var phi_7685_: bool;
    var phi_7686_: bool;
    var phi_7690_: type_9;
    var phi_7691_: bool;
    var phi_7695_: type_9;
    var phi_7708_: u32;
    var phi_7726_: array<u32, 2>;
    var phi_7732_: type_28;
    var phi_7738_: bool;
    var phi_7739_: type_28;
    var phi_7740_: bool;
    var phi_7741_: type_28;
    var phi_7742_: bool;
    var phi_7760_: array<u32, 2>;
    var phi_7774_: bool;
    var phi_7790_: bool;
    var phi_7798_: f32;
    var phi_7805_: f32;
    var phi_7810_: f32;
    var phi_7817_: f32;
    var phi_7822_: f32;
    var phi_7830_: f32;
    var phi_7837_: f32;
    var phi_7842_: f32;
    var phi_7849_: f32;
    var phi_7854_: f32;
    var phi_7859_: f32;
    var phi_7869_: f32;
    var phi_7876_: f32;
    var phi_7881_: f32;
    var phi_7888_: f32;
    var phi_7893_: f32;
    var phi_7901_: f32;
    var phi_7908_: f32;
    var phi_7913_: f32;
    var phi_7920_: f32;
    var phi_7925_: f32;
    var phi_7930_: f32;
    var phi_7940_: f32;
    var phi_7947_: f32;
    var phi_7952_: f32;
    var phi_7959_: f32;
    var phi_7964_: f32;
    var phi_7972_: f32;
    var phi_7979_: f32;
    var phi_7984_: f32;
    var phi_7991_: f32;
    var phi_7996_: f32;
    var phi_8001_: f32;
    var phi_8008_: f32;
    var phi_8013_: f32;
    var phi_8020_: bool;
    var phi_8044_: u32;
    var phi_8055_: f32;
    var phi_8056_: f32;
    var phi_8114_: type_43;
    var phi_8115_: bool;
    var phi_8116_: type_43;
    var phi_8117_: bool;
    var phi_8118_: type_43;
    var phi_8119_: bool;
    var phi_8124_: type_43;
    var phi_15070_: f32;
    var phi_15077_: f32;
    var phi_15082_: f32;
    var phi_15089_: f32;
    var phi_15094_: f32;
    var phi_15107_: f32;
    var phi_15114_: f32;
    var phi_15119_: f32;
    var phi_15126_: f32;
    var phi_15131_: f32;
    var phi_15136_: f32;
    var phi_15153_: f32;
    var phi_15160_: f32;
    var phi_15165_: f32;
    var phi_15172_: f32;
    var phi_15177_: f32;
    var phi_15191_: f32;
    var phi_15198_: f32;
    var phi_15203_: f32;
    var phi_15210_: f32;
    var phi_15215_: f32;
    var phi_15220_: f32;
    var phi_15237_: f32;
    var phi_15244_: f32;
    var phi_15249_: f32;
    var phi_15256_: f32;
    var phi_15261_: f32;
    var phi_15275_: f32;
    var phi_15282_: f32;
    var phi_15287_: f32;
    var phi_15294_: f32;
    var phi_15299_: f32;
    var phi_15304_: f32;
    var phi_15335_: f32;
    var phi_15341_: f32;
    var phi_15348_: f32;
    var phi_15355_: f32;
    var phi_15361_: f32;
    var phi_15368_: f32;
    var phi_15374_: f32;
    var phi_15380_: f32;
    var phi_15386_: f32;
    var phi_15393_: f32;
    var phi_15400_: f32;
    var phi_15424_: f32;
    var phi_15429_: f32;
    var phi_15434_: f32;
    var phi_15439_: f32;
    var phi_15444_: f32;
    var phi_15449_: f32;
    var phi_15459_: f32;
    var phi_15472_: f32;
    var phi_15478_: f32;
    var phi_15483_: f32;
    var phi_15489_: f32;
    var phi_15495_: f32;
    var phi_15500_: f32;
    var phi_15505_: f32;
    var phi_15513_: bool;
    var phi_15518_: f32;
    var phi_15525_: f32;
    var phi_15531_: f32;
    var phi_15549_: f32;
    var phi_15610_: array<f32, 3>;
    var phi_15675_: array<f32, 3>;
    var phi_15697_: f32;
    var phi_15704_: f32;
    var phi_15709_: f32;
    var phi_15716_: f32;
    var phi_15721_: f32;
    var phi_15734_: f32;
    var phi_15741_: f32;
    var phi_15746_: f32;
    var phi_15753_: f32;
    var phi_15758_: f32;
    var phi_15763_: f32;
    var phi_15780_: f32;
    var phi_15787_: f32;
    var phi_15792_: f32;
    var phi_15799_: f32;
    var phi_15804_: f32;
    var phi_15818_: f32;
    var phi_15825_: f32;
    var phi_15830_: f32;
    var phi_15837_: f32;
    var phi_15842_: f32;
    var phi_15847_: f32;
    var phi_15864_: f32;
    var phi_15871_: f32;
    var phi_15876_: f32;
    var phi_15883_: f32;
    var phi_15888_: f32;
    var phi_15902_: f32;
    var phi_15909_: f32;
    var phi_15914_: f32;
    var phi_15921_: f32;
    var phi_15926_: f32;
    var phi_15931_: f32;
    var phi_16049_: f32;
    var phi_16056_: f32;
    var phi_16064_: f32;
    var phi_16108_: type_14;
    var phi_16111_: f32;
    var phi_16132_: bool;
    var phi_16138_: type_15;
    var phi_16109_: type_14;
    var phi_16152_: type_15;
    var phi_16112_: f32;
    var local_85: f32;
    var phi_16101_: f32;
    var phi_16165_: f32;
    var phi_16231_: f32;
    var phi_16237_: f32;
    var phi_16246_: f32;
    var phi_16252_: f32;
    var phi_16261_: f32;
    var phi_16267_: f32;
    var phi_16276_: f32;
    var phi_16282_: f32;
    var phi_16288_: type_29;
    var phi_16289_: bool;
    var phi_16290_: type_29;
    var phi_16291_: bool;
    var phi_16299_: type_29;
    var phi_16468_: bool;
    var phi_16469_: bool;
    var phi_16470_: bool;
    var phi_16471_: bool;
    var phi_16472_: bool;
    var phi_16473_: bool;
    var phi_16477_: bool;
    var phi_16504_: f32;
    var phi_16558_: type_14;
    var phi_16561_: f32;
    var phi_16582_: bool;
    var phi_16588_: type_15;
    var phi_16559_: type_14;
    var phi_16602_: type_15;
    var phi_16562_: f32;
    var local_86: f32;
    var phi_16551_: f32;
    var phi_16615_: f32;
    var phi_16681_: f32;
    var phi_16687_: f32;
    var phi_16696_: f32;
    var phi_16702_: f32;
    var phi_16711_: f32;
    var phi_16717_: f32;
    var phi_16726_: f32;
    var phi_16732_: f32;
    var phi_16738_: type_29;
    var phi_16739_: bool;
    var phi_16740_: type_29;
    var phi_16741_: bool;
    var phi_16749_: type_29;
    var phi_16918_: bool;
    var phi_16919_: bool;
    var phi_16920_: bool;
    var phi_16921_: bool;
    var phi_16922_: bool;
    var phi_16923_: bool;
    var phi_16927_: bool;
    var phi_16960_: f32;
    var phi_17008_: type_14;
    var phi_17011_: f32;
    var phi_17032_: bool;
    var phi_17038_: type_15;
    var phi_17009_: type_14;
    var phi_17052_: type_15;
    var phi_17012_: f32;
    var local_87: f32;
    var phi_17001_: f32;
    var phi_17065_: f32;
    var phi_17131_: f32;
    var phi_17137_: f32;
    var phi_17146_: f32;
    var phi_17152_: f32;
    var phi_17161_: f32;
    var phi_17167_: f32;
    var phi_17176_: f32;
    var phi_17182_: f32;
    var phi_17188_: type_29;
    var phi_17189_: bool;
    var phi_17190_: type_29;
    var phi_17191_: bool;
    var phi_17199_: type_29;
    var phi_17368_: bool;
    var phi_17369_: bool;
    var phi_17370_: bool;
    var phi_17371_: bool;
    var phi_17372_: bool;
    var phi_17373_: bool;
    var phi_17377_: bool;
    var phi_17417_: f32;
    var phi_17458_: type_14;
    var phi_17461_: f32;
    var phi_17482_: bool;
    var phi_17488_: type_15;
    var phi_17459_: type_14;
    var phi_17502_: type_15;
    var phi_17462_: f32;
    var local_88: f32;
    var phi_17451_: f32;
    var phi_17515_: f32;
    var phi_17581_: f32;
    var phi_17587_: f32;
    var phi_17596_: f32;
    var phi_17602_: f32;
    var phi_17611_: f32;
    var phi_17617_: f32;
    var phi_17626_: f32;
    var phi_17632_: f32;
    var phi_17638_: type_29;
    var phi_17639_: bool;
    var phi_17640_: type_29;
    var phi_17641_: bool;
    var phi_17649_: type_29;
    var phi_17818_: bool;
    var phi_17819_: bool;
    var phi_17820_: bool;
    var phi_17821_: bool;
    var phi_17822_: bool;
    var phi_17823_: bool;
    var phi_17827_: bool;
    var phi_17828_: bool;
    var phi_17829_: bool;
    var phi_17830_: bool;
    var phi_17831_: bool;
    var phi_17832_: bool;
    var phi_17836_: bool;
    var phi_17842_: type_44;
    var phi_17843_: bool;
    var phi_17844_: type_44;
    var phi_17845_: bool;
    var phi_17888_: type_14;
    var phi_17891_: f32;
    var phi_17912_: bool;
    var phi_17918_: type_15;
    var phi_17889_: type_14;
    var phi_17932_: type_15;
    var phi_17892_: f32;
    var local_89: f32;
    var phi_17881_: f32;
    var phi_17945_: f32;
    var phi_17951_: f32;
    var phi_17976_: type_9;
    var phi_17979_: u32;
    var phi_17977_: type_9;
    var phi_18002_: type_9;
    var phi_18046_: u32;
    var phi_18047_: u32;
    var phi_17980_: u32;
    var phi_18048_: u32;
    var phi_18068_: type_9;
    var phi_18069_: type_9;
    var phi_18092_: type_9;
    var phi_18111_: f32;
    var phi_18124_: f32;
    var phi_18158_: f32;
    var phi_18165_: f32;
    var phi_18176_: bool;
    var phi_18177_: bool;
    var phi_18178_: bool;
    var phi_18179_: bool;
    var phi_18183_: bool;
    var phi_18194_: type_47;
    var phi_18195_: type_47;
    var phi_18196_: bool;
    var phi_18197_: type_47;
    var phi_18198_: bool;
    var phi_18209_: f32;
    var phi_18219_: type_9;
    var phi_18222_: f32;
    var phi_18224_: f32;
    var phi_18226_: f32;
    var phi_18220_: type_9;
    var phi_18249_: type_9;
    var phi_18274_: f32;
    var phi_18275_: f32;
    var phi_18301_: f32;
    var phi_18317_: f32;
    var phi_18324_: bool;
    var phi_18325_: bool;
    var phi_18326_: bool;
    var phi_18332_: f32;
    var phi_18333_: f32;
    var phi_18334_: bool;
    var phi_18223_: f32;
    var phi_18225_: f32;
    var phi_18227_: f32;
    var phi_18335_: f32;
    var phi_18336_: bool;
    var phi_18337_: bool;
    var local_90: bool;
    var phi_18341_: f32;
    var phi_18342_: f32;
    var phi_18350_: f32;
    var phi_18354_: type_9;
    var phi_18357_: f32;
    var phi_18355_: type_9;
    var phi_18380_: type_9;
    var phi_18410_: f32;
    var phi_18411_: bool;
    var phi_18412_: f32;
    var phi_18413_: bool;
    var phi_18414_: bool;
    var phi_18415_: bool;
    var phi_18416_: f32;
    var phi_18358_: f32;
    var phi_18417_: bool;
    var phi_18418_: bool;
    var phi_18419_: bool;
    var phi_18420_: bool;
    var local_91: bool;
    var phi_18424_: bool;
    var phi_18425_: bool;
    var phi_18429_: bool;
    var phi_18433_: f32;
    var phi_18434_: f32;
    var phi_18436_: type_47;
    var phi_18465_: f32;
    var phi_18472_: f32;
    var phi_18477_: f32;
    var phi_18484_: f32;
    var phi_18489_: f32;
    var phi_18502_: f32;
    var phi_18509_: f32;
    var phi_18514_: f32;
    var phi_18521_: f32;
    var phi_18526_: f32;
    var phi_18531_: f32;
    var phi_18590_: f32;
    var phi_18596_: f32;
    var phi_18601_: f32;
    var phi_18607_: f32;
    var phi_18612_: f32;
    var phi_18624_: f32;
    var phi_18630_: f32;
    var phi_18635_: f32;
    var phi_18641_: f32;
    var phi_18646_: f32;
    var phi_18672_: f32;
    var phi_18679_: f32;
    var phi_18684_: f32;
    var phi_18691_: f32;
    var phi_18696_: f32;
    var phi_18709_: f32;
    var phi_18716_: f32;
    var phi_18721_: f32;
    var phi_18728_: f32;
    var phi_18733_: f32;
    var phi_18738_: f32;
    var phi_18797_: f32;
    var phi_18803_: f32;
    var phi_18808_: f32;
    var phi_18814_: f32;
    var phi_18819_: f32;
    var phi_18831_: f32;
    var phi_18837_: f32;
    var phi_18842_: f32;
    var phi_18848_: f32;
    var phi_18853_: f32;
    var phi_18879_: f32;
    var phi_18886_: f32;
    var phi_18891_: f32;
    var phi_18898_: f32;
    var phi_18903_: f32;
    var phi_18916_: f32;
    var phi_18923_: f32;
    var phi_18928_: f32;
    var phi_18935_: f32;
    var phi_18940_: f32;
    var phi_18945_: f32;
    var phi_19004_: f32;
    var phi_19010_: f32;
    var phi_19015_: f32;
    var phi_19021_: f32;
    var phi_19026_: f32;
    var phi_19038_: f32;
    var phi_19044_: f32;
    var phi_19049_: f32;
    var phi_19055_: f32;
    var phi_19060_: f32;
    var phi_19109_: f32;
    var phi_19115_: f32;
    var phi_19143_: f32;
    var phi_19149_: f32;
    var phi_19154_: u32;
    var phi_19155_: u32;
    var phi_19125_: f32;
    var phi_19131_: f32;
    var phi_19136_: u32;
    var phi_19137_: u32;
    var phi_19156_: u32;
    var phi_19157_: u32;
    var phi_19226_: f32;
    var phi_19235_: f32;
    var phi_19370_: f32;
    var phi_19376_: f32;
    var phi_19383_: f32;
    var phi_19418_: array<type_26, 4>;
    var phi_19438_: type_9;
    var phi_19441_: bool;
    var phi_19439_: type_9;
    var phi_19464_: type_9;
    var phi_19491_: bool;
    var phi_19492_: bool;
    var phi_19442_: bool;
    var phi_19493_: bool;
    var phi_19494_: bool;
    var local_92: bool;
    var phi_19498_: bool;
    var local_93: bool;
    var phi_19505_: u32;
    var phi_19506_: u32;
    var phi_19507_: bool;
    var phi_19508_: u32;
    var phi_19509_: u32;
    var phi_19510_: bool;
    var phi_19514_: u32;
    var phi_19524_: bool;
    var phi_19536_: bool;
    var phi_19537_: bool;
    var phi_19598_: array<f32, 3>;
    var phi_19663_: array<f32, 3>;
    var phi_19685_: f32;
    var phi_19692_: f32;
    var phi_19697_: f32;
    var phi_19704_: f32;
    var phi_19709_: f32;
    var phi_19722_: f32;
    var phi_19729_: f32;
    var phi_19734_: f32;
    var phi_19741_: f32;
    var phi_19746_: f32;
    var phi_19751_: f32;
    var phi_19768_: f32;
    var phi_19775_: f32;
    var phi_19780_: f32;
    var phi_19787_: f32;
    var phi_19792_: f32;
    var phi_19806_: f32;
    var phi_19813_: f32;
    var phi_19818_: f32;
    var phi_19825_: f32;
    var phi_19830_: f32;
    var phi_19835_: f32;
    var phi_19852_: f32;
    var phi_19859_: f32;
    var phi_19864_: f32;
    var phi_19871_: f32;
    var phi_19876_: f32;
    var phi_19890_: f32;
    var phi_19897_: f32;
    var phi_19902_: f32;
    var phi_19909_: f32;
    var phi_19914_: f32;
    var phi_19919_: f32;
    var phi_19960_: type_9;
    var phi_19963_: f32;
    var phi_19965_: f32;
    var phi_19967_: f32;
    var phi_19969_: f32;
    var phi_19971_: bool;
    var phi_19973_: u32;
    var phi_19961_: type_9;
    var phi_19996_: type_9;
    var phi_20110_: f32;
    var phi_20116_: f32;
    var phi_20122_: f32;
    var phi_20124_: array<f32, 3>;
    var phi_20131_: f32;
    var phi_20138_: f32;
    var phi_20146_: f32;
    var phi_20190_: type_14;
    var phi_20193_: f32;
    var phi_20214_: bool;
    var phi_20220_: type_15;
    var phi_20191_: type_14;
    var phi_20234_: type_15;
    var phi_20194_: f32;
    var local_94: f32;
    var phi_20183_: f32;
    var phi_20247_: f32;
    var phi_20313_: f32;
    var phi_20319_: f32;
    var phi_20328_: f32;
    var phi_20334_: f32;
    var phi_20343_: f32;
    var phi_20349_: f32;
    var phi_20358_: f32;
    var phi_20364_: f32;
    var phi_20370_: type_29;
    var phi_20371_: bool;
    var phi_20372_: type_29;
    var phi_20373_: bool;
    var phi_20381_: type_29;
    var phi_20552_: bool;
    var phi_20553_: bool;
    var phi_20554_: bool;
    var phi_20555_: bool;
    var phi_20556_: bool;
    var phi_20557_: bool;
    var phi_20561_: bool;
    var phi_20858_: bool;
    var phi_20859_: bool;
    var phi_20860_: bool;
    var phi_20861_: bool;
    var phi_20862_: bool;
    var phi_20863_: bool;
    var phi_20867_: bool;
    var phi_20871_: bool;
    var phi_20882_: bool;
    var phi_20883_: bool;
    var phi_20957_: bool;
    var phi_20958_: bool;
    var phi_20978_: f32;
    var phi_20979_: bool;
    var phi_20980_: f32;
    var phi_20981_: bool;
    var phi_20982_: f32;
    var phi_20983_: bool;
    var phi_20984_: bool;
    var phi_20988_: f32;
    var phi_20989_: bool;
    var phi_20993_: f32;
    var phi_21025_: bool;
    var phi_21026_: bool;
    var phi_21046_: f32;
    var phi_21047_: bool;
    var phi_21048_: f32;
    var phi_21049_: bool;
    var phi_21050_: f32;
    var phi_21051_: bool;
    var phi_21052_: bool;
    var phi_21056_: f32;
    var phi_21057_: bool;
    var phi_21061_: f32;
    var phi_21066_: f32;
    var phi_21098_: bool;
    var phi_21099_: bool;
    var phi_21119_: f32;
    var phi_21120_: bool;
    var phi_21121_: f32;
    var phi_21122_: bool;
    var phi_21123_: f32;
    var phi_21124_: bool;
    var phi_21125_: bool;
    var phi_21129_: f32;
    var phi_21130_: bool;
    var phi_21134_: f32;
    var phi_21166_: bool;
    var phi_21167_: bool;
    var phi_21187_: f32;
    var phi_21188_: bool;
    var phi_21189_: f32;
    var phi_21190_: bool;
    var phi_21191_: f32;
    var phi_21192_: bool;
    var phi_21193_: bool;
    var phi_21197_: f32;
    var phi_21198_: bool;
    var phi_21202_: f32;
    var phi_21207_: f32;
    var phi_21212_: f32;
    var phi_21217_: f32;
    var phi_21711_: bool;
    var phi_21712_: bool;
    var phi_21717_: f32;
    var phi_21719_: f32;
    var phi_21722_: f32;
    var phi_21723_: f32;
    var phi_21724_: bool;
    var phi_21726_: f32;
    var phi_21727_: f32;
    var phi_21728_: f32;
    var phi_21730_: bool;
    var phi_21731_: bool;
    var phi_21733_: bool;
    var phi_21734_: f32;
    var phi_21735_: f32;
    var phi_21736_: f32;
    var phi_21738_: bool;
    var phi_21739_: bool;
    var phi_21740_: bool;
    var phi_21742_: bool;
    var phi_21743_: f32;
    var phi_21744_: f32;
    var phi_21745_: f32;
    var phi_21747_: bool;
    var phi_21748_: bool;
    var phi_21749_: bool;
    var phi_21751_: bool;
    var phi_21837_: f32;
    var phi_21910_: f32;
    var phi_21915_: f32;
    var phi_21988_: f32;
    var phi_22061_: f32;
    var phi_22066_: f32;
    var phi_22082_: f32;
    var phi_22083_: f32;
    var phi_22084_: f32;
    var phi_21764_: bool;
    var phi_22086_: u32;
    var phi_22087_: f32;
    var phi_22088_: bool;
    var phi_22089_: bool;
    var phi_22090_: bool;
    var phi_22091_: u32;
    var phi_22092_: f32;
    var phi_22093_: f32;
    var phi_22094_: f32;
    var phi_22095_: f32;
    var phi_22096_: bool;
    var phi_22097_: u32;
    var phi_22098_: bool;
    var phi_22099_: bool;
    var phi_22100_: bool;
    var phi_22101_: bool;
    var phi_22103_: bool;
    var phi_22112_: f32;
    var phi_22117_: f32;
    var phi_22126_: bool;
    var phi_22130_: bool;
    var phi_22131_: f32;
    var phi_22132_: f32;
    var phi_22133_: f32;
    var phi_22134_: f32;
    var phi_22135_: bool;
    var phi_22136_: u32;
    var phi_22137_: bool;
    var phi_22138_: bool;
    var phi_22139_: bool;
    var phi_22140_: bool;
    var phi_22142_: bool;
    var phi_19964_: f32;
    var phi_19966_: f32;
    var phi_19968_: f32;
    var phi_19970_: f32;
    var phi_19972_: bool;
    var phi_19974_: u32;
    var phi_22143_: f32;
    var phi_22145_: bool;
    var phi_22146_: bool;
    var phi_22147_: bool;
    var phi_22148_: bool;
    var phi_22150_: bool;
    var phi_22151_: bool;
    var local_95: bool;
    var phi_22155_: bool;
    var phi_22156_: bool;
    var phi_22158_: bool;
    var phi_22159_: bool;
    var local_96: f32;
    var phi_22164_: type_44;
    var phi_22165_: bool;
    var phi_22167_: bool;
    var phi_22168_: bool;
    var phi_22169_: bool;
    var phi_22174_: type_44;
    var phi_22176_: bool;
    var phi_22177_: bool;
    var phi_22178_: bool;
    var phi_22179_: bool;
    var phi_22191_: f32;
    var phi_22192_: bool;
    var phi_22193_: bool;
    var phi_22194_: bool;
    var phi_22199_: type_44;
    var phi_22200_: bool;
    var phi_22201_: bool;
    var phi_22206_: type_44;
    var phi_22207_: bool;
    var phi_22211_: type_44;
    var phi_22218_: bool;
    var phi_22219_: f32;
    var phi_22220_: bool;
    var phi_22221_: bool;
    var phi_22222_: bool;
    var phi_22223_: bool;
    var phi_22224_: f32;
    var phi_22225_: f32;
    var phi_22226_: bool;
    var phi_22227_: bool;
    var phi_22228_: bool;
    var phi_22229_: bool;
    var phi_22230_: f32;
    var phi_22231_: f32;
    var phi_22232_: bool;
    var phi_22233_: bool;
    var phi_22234_: bool;
    var phi_22235_: bool;
    var phi_22239_: bool;
    var phi_22240_: bool;
    var phi_22241_: bool;
    var phi_22242_: type_47;
    var phi_22243_: bool;
    var phi_22244_: f32;
    var phi_22245_: f32;
    var phi_22246_: type_47;
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
    var local_97: bool;
    var phi_22270_: type_44;
    var phi_22271_: bool;
    var phi_22272_: bool;
    var local_98: bool;
    var local_99: type_47;
    var local_100: f32;
    var local_101: f32;
    var local_102: f32;
    var phi_22286_: type_44;
    var phi_22287_: bool;
    var phi_22288_: type_44;
    var phi_22289_: bool;
    var local_103: f32;
    var phi_22294_: type_44;
    var phi_22295_: type_44;
    var phi_22296_: bool;
    var local_104: type_47;
    var phi_22302_: type_44;
    var phi_22303_: bool;
    var phi_22307_: type_44;
    var phi_22308_: type_44;
    var phi_22309_: bool;
    var phi_22313_: type_44;
    var phi_22314_: type_44;
    var phi_22315_: bool;
    var phi_22319_: type_44;
    var phi_22330_: bool;
    var phi_22331_: bool;
    var phi_22335_: bool;
    var phi_22339_: u32;
    var phi_8298_: type_14;
    var phi_8301_: f32;
    var phi_8322_: bool;
    var phi_8328_: type_15;
    var phi_8299_: type_14;
    var phi_8342_: type_15;
    var phi_8302_: f32;
    var local_105: f32;
    var phi_8291_: f32;
    var phi_8355_: f32;
    var phi_8371_: f32;
    var phi_8378_: f32;
    var phi_8383_: f32;
    var phi_8390_: f32;
    var phi_8395_: f32;
    var phi_8408_: f32;
    var phi_8415_: f32;
    var phi_8420_: f32;
    var phi_8427_: f32;
    var phi_8432_: f32;
    var phi_8437_: f32;
    var phi_8454_: f32;
    var phi_8461_: f32;
    var phi_8466_: f32;
    var phi_8473_: f32;
    var phi_8478_: f32;
    var phi_8492_: f32;
    var phi_8499_: f32;
    var phi_8504_: f32;
    var phi_8511_: f32;
    var phi_8516_: f32;
    var phi_8521_: f32;
    var phi_8538_: f32;
    var phi_8545_: f32;
    var phi_8550_: f32;
    var phi_8557_: f32;
    var phi_8562_: f32;
    var phi_8576_: f32;
    var phi_8583_: f32;
    var phi_8588_: f32;
    var phi_8595_: f32;
    var phi_8600_: f32;
    var phi_8605_: f32;
    var phi_8866_: f32;
    var phi_8873_: f32;
    var phi_8878_: f32;
    var phi_8885_: f32;
    var phi_8890_: f32;
    var phi_8903_: f32;
    var phi_8910_: f32;
    var phi_8915_: f32;
    var phi_8922_: f32;
    var phi_8927_: f32;
    var phi_8932_: f32;
    var phi_8949_: f32;
    var phi_8956_: f32;
    var phi_8961_: f32;
    var phi_8968_: f32;
    var phi_8973_: f32;
    var phi_8987_: f32;
    var phi_8994_: f32;
    var phi_8999_: f32;
    var phi_9006_: f32;
    var phi_9011_: f32;
    var phi_9016_: f32;
    var phi_9033_: f32;
    var phi_9040_: f32;
    var phi_9045_: f32;
    var phi_9052_: f32;
    var phi_9057_: f32;
    var phi_9071_: f32;
    var phi_9078_: f32;
    var phi_9083_: f32;
    var phi_9090_: f32;
    var phi_9095_: f32;
    var phi_9100_: f32;
    var phi_9131_: f32;
    var phi_9137_: f32;
    var phi_9144_: f32;
    var phi_9151_: f32;
    var phi_9157_: f32;
    var phi_9164_: f32;
    var phi_9170_: f32;
    var phi_9176_: f32;
    var phi_9182_: f32;
    var phi_9189_: f32;
    var phi_9196_: f32;
    var phi_9220_: f32;
    var phi_9225_: f32;
    var phi_9230_: f32;
    var phi_9235_: f32;
    var phi_9240_: f32;
    var phi_9245_: f32;
    var phi_9255_: f32;
    var phi_9264_: type_45;
    var phi_9265_: bool;
    var phi_9266_: type_45;
    var phi_9267_: bool;
    var phi_9273_: type_14;
    var phi_9276_: f32;
    var phi_9278_: u32;
    var phi_9280_: f32;
    var phi_9301_: bool;
    var phi_9307_: type_15;
    var phi_9274_: type_14;
    var phi_9321_: type_15;
    var phi_9336_: bool;
    var phi_9337_: bool;
    var phi_9396_: array<f32, 3>;
    var phi_9461_: array<f32, 3>;
    var phi_9483_: f32;
    var phi_9490_: f32;
    var phi_9495_: f32;
    var phi_9502_: f32;
    var phi_9507_: f32;
    var phi_9520_: f32;
    var phi_9527_: f32;
    var phi_9532_: f32;
    var phi_9539_: f32;
    var phi_9544_: f32;
    var phi_9549_: f32;
    var phi_9566_: f32;
    var phi_9573_: f32;
    var phi_9578_: f32;
    var phi_9585_: f32;
    var phi_9590_: f32;
    var phi_9604_: f32;
    var phi_9611_: f32;
    var phi_9616_: f32;
    var phi_9623_: f32;
    var phi_9628_: f32;
    var phi_9633_: f32;
    var phi_9650_: f32;
    var phi_9657_: f32;
    var phi_9662_: f32;
    var phi_9669_: f32;
    var phi_9674_: f32;
    var phi_9688_: f32;
    var phi_9695_: f32;
    var phi_9700_: f32;
    var phi_9707_: f32;
    var phi_9712_: f32;
    var phi_9717_: f32;
    var phi_9758_: type_9;
    var phi_9761_: f32;
    var phi_9763_: f32;
    var phi_9765_: f32;
    var phi_9767_: f32;
    var phi_9769_: bool;
    var phi_9771_: u32;
    var phi_9759_: type_9;
    var phi_9794_: type_9;
    var phi_9908_: f32;
    var phi_9914_: f32;
    var phi_9920_: f32;
    var phi_9922_: array<f32, 3>;
    var phi_9929_: f32;
    var phi_9936_: f32;
    var phi_9944_: f32;
    var phi_9988_: type_14;
    var phi_9991_: f32;
    var phi_10012_: bool;
    var phi_10018_: type_15;
    var phi_9989_: type_14;
    var phi_10032_: type_15;
    var phi_9992_: f32;
    var local_106: f32;
    var phi_9981_: f32;
    var phi_10045_: f32;
    var phi_10111_: f32;
    var phi_10117_: f32;
    var phi_10126_: f32;
    var phi_10132_: f32;
    var phi_10141_: f32;
    var phi_10147_: f32;
    var phi_10156_: f32;
    var phi_10162_: f32;
    var phi_10168_: type_29;
    var phi_10169_: bool;
    var phi_10170_: type_29;
    var phi_10171_: bool;
    var phi_10179_: type_29;
    var phi_10350_: bool;
    var phi_10351_: bool;
    var phi_10352_: bool;
    var phi_10353_: bool;
    var phi_10354_: bool;
    var phi_10355_: bool;
    var phi_10359_: bool;
    var phi_10656_: bool;
    var phi_10657_: bool;
    var phi_10658_: bool;
    var phi_10659_: bool;
    var phi_10660_: bool;
    var phi_10661_: bool;
    var phi_10665_: bool;
    var phi_10669_: bool;
    var phi_10680_: bool;
    var phi_10681_: bool;
    var phi_10755_: bool;
    var phi_10756_: bool;
    var phi_10776_: f32;
    var phi_10777_: bool;
    var phi_10778_: f32;
    var phi_10779_: bool;
    var phi_10780_: f32;
    var phi_10781_: bool;
    var phi_10782_: bool;
    var phi_10786_: f32;
    var phi_10787_: bool;
    var phi_10791_: f32;
    var phi_10823_: bool;
    var phi_10824_: bool;
    var phi_10844_: f32;
    var phi_10845_: bool;
    var phi_10846_: f32;
    var phi_10847_: bool;
    var phi_10848_: f32;
    var phi_10849_: bool;
    var phi_10850_: bool;
    var phi_10854_: f32;
    var phi_10855_: bool;
    var phi_10859_: f32;
    var phi_10864_: f32;
    var phi_10896_: bool;
    var phi_10897_: bool;
    var phi_10917_: f32;
    var phi_10918_: bool;
    var phi_10919_: f32;
    var phi_10920_: bool;
    var phi_10921_: f32;
    var phi_10922_: bool;
    var phi_10923_: bool;
    var phi_10927_: f32;
    var phi_10928_: bool;
    var phi_10932_: f32;
    var phi_10964_: bool;
    var phi_10965_: bool;
    var phi_10985_: f32;
    var phi_10986_: bool;
    var phi_10987_: f32;
    var phi_10988_: bool;
    var phi_10989_: f32;
    var phi_10990_: bool;
    var phi_10991_: bool;
    var phi_10995_: f32;
    var phi_10996_: bool;
    var phi_11000_: f32;
    var phi_11005_: f32;
    var phi_11010_: f32;
    var phi_11015_: f32;
    var phi_11028_: f32;
    var phi_11165_: type_14;
    var phi_11168_: f32;
    var phi_11189_: bool;
    var phi_11195_: type_15;
    var phi_11166_: type_14;
    var phi_11209_: type_15;
    var phi_11169_: f32;
    var local_107: f32;
    var phi_11158_: f32;
    var phi_11222_: f32;
    var phi_11238_: f32;
    var phi_11245_: f32;
    var phi_11250_: f32;
    var phi_11257_: f32;
    var phi_11262_: f32;
    var phi_11275_: f32;
    var phi_11282_: f32;
    var phi_11287_: f32;
    var phi_11294_: f32;
    var phi_11299_: f32;
    var phi_11304_: f32;
    var phi_11321_: f32;
    var phi_11328_: f32;
    var phi_11333_: f32;
    var phi_11340_: f32;
    var phi_11345_: f32;
    var phi_11359_: f32;
    var phi_11366_: f32;
    var phi_11371_: f32;
    var phi_11378_: f32;
    var phi_11383_: f32;
    var phi_11388_: f32;
    var phi_11405_: f32;
    var phi_11412_: f32;
    var phi_11417_: f32;
    var phi_11424_: f32;
    var phi_11429_: f32;
    var phi_11443_: f32;
    var phi_11450_: f32;
    var phi_11455_: f32;
    var phi_11462_: f32;
    var phi_11467_: f32;
    var phi_11472_: f32;
    var phi_11492_: bool;
    var phi_11493_: bool;
    var phi_11494_: bool;
    var phi_11509_: bool;
    var phi_11510_: bool;
    var phi_11515_: f32;
    var phi_11517_: f32;
    var phi_11518_: f32;
    var phi_11519_: bool;
    var phi_11520_: f32;
    var phi_11521_: f32;
    var phi_11522_: bool;
    var phi_11523_: bool;
    var phi_11524_: f32;
    var phi_11525_: f32;
    var phi_11526_: f32;
    var phi_11527_: f32;
    var phi_11528_: bool;
    var phi_11529_: bool;
    var phi_11530_: bool;
    var phi_11531_: bool;
    var phi_11532_: f32;
    var phi_11533_: f32;
    var phi_11534_: f32;
    var phi_11535_: f32;
    var phi_11536_: bool;
    var phi_11537_: bool;
    var phi_11538_: bool;
    var phi_11539_: bool;
    var phi_11540_: bool;
    var phi_11541_: f32;
    var phi_11542_: f32;
    var phi_11543_: f32;
    var phi_11544_: f32;
    var phi_11545_: bool;
    var phi_11546_: bool;
    var phi_11547_: bool;
    var phi_11548_: bool;
    var phi_11549_: bool;
    var phi_11635_: f32;
    var phi_11708_: f32;
    var phi_11713_: f32;
    var phi_11786_: f32;
    var phi_11859_: f32;
    var phi_11864_: f32;
    var phi_11880_: f32;
    var phi_11881_: f32;
    var phi_11882_: f32;
    var phi_11562_: bool;
    var phi_11884_: u32;
    var phi_11885_: f32;
    var phi_11886_: bool;
    var phi_11887_: bool;
    var phi_11888_: bool;
    var phi_11889_: u32;
    var phi_11890_: f32;
    var phi_11891_: f32;
    var phi_11892_: f32;
    var phi_11893_: f32;
    var phi_11894_: bool;
    var phi_11895_: u32;
    var phi_11896_: bool;
    var phi_11897_: bool;
    var phi_11898_: bool;
    var phi_11899_: bool;
    var phi_11900_: bool;
    var phi_11901_: bool;
    var phi_11910_: f32;
    var phi_11915_: f32;
    var phi_11924_: bool;
    var phi_11928_: bool;
    var phi_11929_: f32;
    var phi_11930_: f32;
    var phi_11931_: f32;
    var phi_11932_: f32;
    var phi_11933_: bool;
    var phi_11934_: u32;
    var phi_11935_: bool;
    var phi_11936_: bool;
    var phi_11937_: bool;
    var phi_11938_: bool;
    var phi_11939_: bool;
    var phi_11940_: bool;
    var phi_9762_: f32;
    var phi_9764_: f32;
    var phi_9766_: f32;
    var phi_9768_: f32;
    var phi_9770_: bool;
    var phi_9772_: u32;
    var phi_11941_: f32;
    var phi_11942_: f32;
    var phi_11943_: bool;
    var phi_11944_: bool;
    var phi_11945_: bool;
    var phi_11946_: bool;
    var phi_11947_: bool;
    var phi_11948_: bool;
    var phi_11949_: bool;
    var local_108: bool;
    var phi_11953_: bool;
    var phi_11954_: bool;
    var phi_11955_: bool;
    var phi_11956_: bool;
    var phi_11957_: bool;
    var local_109: f32;
    var phi_11962_: type_44;
    var phi_11963_: bool;
    var phi_11964_: bool;
    var phi_11965_: bool;
    var phi_11966_: bool;
    var phi_11967_: bool;
    var phi_11972_: type_44;
    var phi_11973_: bool;
    var phi_11974_: bool;
    var phi_11975_: bool;
    var phi_11976_: bool;
    var phi_11977_: bool;
    var phi_11981_: f32;
    var phi_11982_: bool;
    var phi_11983_: bool;
    var phi_11984_: bool;
    var phi_11985_: bool;
    var phi_11989_: f32;
    var phi_11990_: bool;
    var phi_11991_: bool;
    var phi_11992_: bool;
    var phi_11997_: type_44;
    var phi_11998_: bool;
    var phi_11999_: bool;
    var phi_12004_: type_44;
    var phi_12005_: bool;
    var phi_12009_: type_44;
    var phi_12016_: f32;
    var phi_12017_: bool;
    var phi_12129_: f32;
    var phi_12136_: f32;
    var phi_12144_: f32;
    var phi_12202_: array<f32, 3>;
    var phi_12270_: array<f32, 3>;
    var phi_12295_: f32;
    var phi_12302_: f32;
    var phi_12307_: f32;
    var phi_12314_: f32;
    var phi_12319_: f32;
    var phi_12332_: f32;
    var phi_12339_: f32;
    var phi_12344_: f32;
    var phi_12351_: f32;
    var phi_12356_: f32;
    var phi_12361_: f32;
    var phi_12378_: f32;
    var phi_12385_: f32;
    var phi_12390_: f32;
    var phi_12397_: f32;
    var phi_12402_: f32;
    var phi_12416_: f32;
    var phi_12423_: f32;
    var phi_12428_: f32;
    var phi_12435_: f32;
    var phi_12440_: f32;
    var phi_12445_: f32;
    var phi_12462_: f32;
    var phi_12469_: f32;
    var phi_12474_: f32;
    var phi_12481_: f32;
    var phi_12486_: f32;
    var phi_12500_: f32;
    var phi_12507_: f32;
    var phi_12512_: f32;
    var phi_12519_: f32;
    var phi_12524_: f32;
    var phi_12529_: f32;
    var phi_12637_: type_14;
    var phi_12640_: f32;
    var phi_12661_: bool;
    var phi_12667_: type_15;
    var phi_12638_: type_14;
    var phi_12681_: type_15;
    var phi_12641_: f32;
    var local_110: f32;
    var phi_12630_: f32;
    var phi_12694_: f32;
    var phi_12828_: f32;
    var phi_12834_: f32;
    var phi_12843_: f32;
    var phi_12849_: f32;
    var phi_12858_: f32;
    var phi_12864_: f32;
    var phi_12873_: f32;
    var phi_12879_: f32;
    var phi_12929_: type_14;
    var phi_12932_: f32;
    var phi_12953_: bool;
    var phi_12959_: type_15;
    var phi_12930_: type_14;
    var phi_12973_: type_15;
    var phi_12933_: f32;
    var local_111: f32;
    var phi_12922_: f32;
    var phi_12986_: f32;
    var phi_13018_: type_14;
    var phi_13021_: f32;
    var phi_13042_: bool;
    var phi_13048_: type_15;
    var phi_13019_: type_14;
    var phi_13062_: type_15;
    var phi_13022_: f32;
    var local_112: f32;
    var phi_13011_: f32;
    var phi_13075_: f32;
    var phi_13091_: f32;
    var phi_13098_: f32;
    var phi_13103_: f32;
    var phi_13110_: f32;
    var phi_13115_: f32;
    var phi_13128_: f32;
    var phi_13135_: f32;
    var phi_13140_: f32;
    var phi_13147_: f32;
    var phi_13152_: f32;
    var phi_13157_: f32;
    var phi_13174_: f32;
    var phi_13181_: f32;
    var phi_13186_: f32;
    var phi_13193_: f32;
    var phi_13198_: f32;
    var phi_13212_: f32;
    var phi_13219_: f32;
    var phi_13224_: f32;
    var phi_13231_: f32;
    var phi_13236_: f32;
    var phi_13241_: f32;
    var phi_13258_: f32;
    var phi_13265_: f32;
    var phi_13270_: f32;
    var phi_13277_: f32;
    var phi_13282_: f32;
    var phi_13296_: f32;
    var phi_13303_: f32;
    var phi_13308_: f32;
    var phi_13315_: f32;
    var phi_13320_: f32;
    var phi_13325_: f32;
    var phi_13366_: f32;
    var phi_13372_: f32;
    var phi_13383_: type_9;
    var phi_13386_: f32;
    var phi_13384_: type_9;
    var phi_13409_: type_9;
    var phi_13438_: f32;
    var phi_13444_: f32;
    var phi_13457_: f32;
    var phi_13387_: f32;
    var local_113: f32;
    var local_114: f32;
    var phi_13485_: type_14;
    var phi_13488_: f32;
    var phi_13509_: bool;
    var phi_13515_: type_15;
    var phi_13486_: type_14;
    var phi_13529_: type_15;
    var phi_13489_: f32;
    var local_115: f32;
    var phi_13478_: f32;
    var phi_13542_: f32;
    var phi_13547_: type_9;
    var phi_13550_: f32;
    var phi_13552_: bool;
    var phi_13554_: bool;
    var phi_13548_: type_9;
    var phi_13577_: type_9;
    var phi_13614_: f32;
    var phi_13621_: f32;
    var phi_13629_: f32;
    var phi_13637_: f32;
    var phi_13644_: f32;
    var phi_13652_: f32;
    var phi_13658_: f32;
    var phi_13676_: f32;
    var phi_13682_: f32;
    var phi_13689_: f32;
    var phi_13715_: f32;
    var phi_13721_: f32;
    var phi_13757_: bool;
    var phi_13764_: bool;
    var phi_13777_: f32;
    var phi_13783_: f32;
    var phi_13784_: f32;
    var phi_13785_: f32;
    var phi_13551_: f32;
    var phi_13553_: bool;
    var phi_13555_: bool;
    var local_116: f32;
    var phi_13790_: f32;
    var local_117: bool;
    var local_118: bool;
    var phi_13799_: type_46;
    var phi_13800_: type_46;
    var phi_13801_: bool;
    var local_119: bool;
    var phi_13818_: f32;
    var phi_13819_: f32;
    var phi_13822_: type_9;
    var phi_13825_: f32;
    var phi_13827_: f32;
    var phi_13823_: type_9;
    var phi_13850_: type_9;
    var phi_13933_: f32;
    var phi_13934_: f32;
    var phi_13935_: f32;
    var phi_13918_: f32;
    var phi_13936_: f32;
    var phi_13937_: f32;
    var phi_13826_: f32;
    var phi_13828_: f32;
    var local_120: f32;
    var local_121: f32;
    var local_122: f32;
    var phi_14098_: bool;
    var phi_14099_: bool;
    var phi_14100_: bool;
    var phi_14101_: bool;
    var phi_14102_: bool;
    var phi_14103_: bool;
    var phi_14107_: bool;
    var phi_14111_: bool;
    var phi_14112_: bool;
    var phi_14113_: bool;
    var phi_14117_: f32;
    var phi_14120_: type_46;
    var phi_14121_: type_46;
    var phi_14122_: bool;
    var phi_14123_: type_46;
    var phi_14124_: type_46;
    var phi_14125_: bool;
    var phi_14130_: type_46;
    var phi_14131_: type_46;
    var phi_14132_: bool;
    var phi_14136_: type_46;
    var phi_14137_: type_46;
    var phi_14138_: bool;
    var phi_14139_: bool;
    var phi_14140_: type_46;
    var phi_14141_: type_46;
    var phi_14142_: bool;
    var phi_14143_: bool;
    var phi_14148_: type_46;
    var phi_14149_: bool;
    var phi_14153_: type_46;
    var phi_14169_: f32;
    var phi_14170_: f32;
    var phi_14171_: bool;
    var phi_14172_: f32;
    var phi_14173_: f32;
    var phi_14174_: bool;
    var phi_14175_: bool;
    var phi_14176_: bool;
    var phi_14177_: f32;
    var phi_14178_: f32;
    var phi_14179_: bool;
    var phi_14180_: bool;
    var phi_14181_: bool;
    var phi_14182_: f32;
    var phi_14183_: u32;
    var phi_14184_: f32;
    var phi_14185_: type_46;
    var phi_14186_: u32;
    var phi_14187_: u32;
    var phi_14188_: bool;
    var phi_14189_: bool;
    var phi_14190_: bool;
    var phi_14191_: f32;
    var phi_14192_: u32;
    var phi_14193_: f32;
    var phi_14194_: type_46;
    var phi_14195_: u32;
    var phi_14196_: u32;
    var phi_14197_: bool;
    var phi_14198_: bool;
    var phi_14199_: bool;
    var phi_14200_: bool;
    var phi_14201_: bool;
    var phi_14202_: f32;
    var phi_9277_: f32;
    var phi_9279_: u32;
    var phi_9281_: f32;
    var phi_14203_: type_46;
    var phi_14204_: u32;
    var phi_14205_: f32;
    var phi_14206_: u32;
    var phi_14207_: bool;
    var phi_14208_: bool;
    var phi_14209_: bool;
    var phi_14210_: bool;
    var phi_14211_: bool;
    var phi_14212_: bool;
    var local_123: bool;
    var phi_14216_: bool;
    var phi_14217_: bool;
    var phi_14218_: bool;
    var phi_14219_: bool;
    var local_124: type_46;
    var local_125: type_46;
    var phi_14236_: u32;
    var local_126: type_46;
    var phi_14241_: type_45;
    var phi_14242_: type_45;
    var phi_14243_: bool;
    var phi_14244_: bool;
    var phi_14245_: bool;
    var phi_14246_: bool;
    var phi_14250_: u32;
    var phi_14251_: f32;
    var phi_14252_: bool;
    var phi_14253_: bool;
    var phi_14254_: bool;
    var phi_14255_: bool;
    var phi_14259_: f32;
    var phi_14260_: u32;
    var phi_14261_: bool;
    var phi_14262_: bool;
    var phi_14263_: bool;
    var phi_14275_: f32;
    var phi_14278_: type_9;
    var phi_14279_: type_9;
    var phi_14302_: type_9;
    var phi_14323_: f32;
    var phi_14453_: type_14;
    var phi_14456_: f32;
    var phi_14477_: bool;
    var phi_14483_: type_15;
    var phi_14454_: type_14;
    var phi_14497_: type_15;
    var phi_14457_: f32;
    var local_127: f32;
    var phi_14446_: f32;
    var phi_14510_: f32;
    var phi_14526_: f32;
    var phi_14533_: f32;
    var phi_14538_: f32;
    var phi_14545_: f32;
    var phi_14550_: f32;
    var phi_14563_: f32;
    var phi_14570_: f32;
    var phi_14575_: f32;
    var phi_14582_: f32;
    var phi_14587_: f32;
    var phi_14592_: f32;
    var phi_14609_: f32;
    var phi_14616_: f32;
    var phi_14621_: f32;
    var phi_14628_: f32;
    var phi_14633_: f32;
    var phi_14647_: f32;
    var phi_14654_: f32;
    var phi_14659_: f32;
    var phi_14666_: f32;
    var phi_14671_: f32;
    var phi_14676_: f32;
    var phi_14693_: f32;
    var phi_14700_: f32;
    var phi_14705_: f32;
    var phi_14712_: f32;
    var phi_14717_: f32;
    var phi_14731_: f32;
    var phi_14738_: f32;
    var phi_14743_: f32;
    var phi_14750_: f32;
    var phi_14755_: f32;
    var phi_14760_: f32;
    var phi_14780_: bool;
    var phi_14781_: bool;
    var phi_14782_: bool;
    var local_128: bool;
    var phi_14790_: u32;
    var phi_14794_: type_45;
    var phi_14795_: bool;
    var phi_14803_: u32;
    var phi_14807_: type_45;
    var phi_14808_: type_45;
    var phi_14809_: bool;
    var phi_14810_: bool;
    var phi_14817_: type_45;
    var phi_14818_: bool;
    var phi_14822_: type_45;
    var phi_14823_: type_45;
    var phi_14824_: bool;
    var phi_14828_: type_45;
    var phi_22343_: type_45;
    var phi_22361_: type_28;
    var phi_22377_: array<u32, 2>;
    var phi_22398_: array<u32, 2>;
    var phi_22401_: bool;
    var phi_22416_: bool;
    var phi_22417_: bool;
    var phi_22425_: bool;
    var phi_22426_: bool;
    var phi_22431_: u32;
    var phi_22436_: type_28;
    var phi_22443_: bool;
    var phi_22468_: u32;
    var phi_22472_: type_20;
    var phi_22473_: bool;
    var phi_22474_: bool;
    var phi_22493_: u32;
    var phi_22560_: u32;
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
    let _e183 = id_2;
    let _e184 = n_2;
    let _e185 = lane_2;
    let _e198 = ((_e183.y * _e184.x) + _e183.x);
    let _e201 = (_e184.x * _e184.y);
    let _e204 = params.member.member_1.member_2;
    let _e206 = input.member[0u];
    if (_e204 < _e206) {
        phi_361_ = _e204;
    } else {
        phi_361_ = _e206;
    }
    let _e209 = phi_361_;
    let _e211 = params.member.member_1.member_1;
    if (_e209 > _e211) {
        let _e214 = params.member.member_1.member_1;
        phi_371_ = (_e209 - _e214);
    } else {
        phi_371_ = 0u;
    }
    let _e217 = phi_371_;
    let _e219 = params.member.member_1.member;
    if (_e219 < _e217) {
        phi_378_ = _e219;
    } else {
        phi_378_ = _e217;
    }
    let _e222 = phi_378_;
    let _e223 = (_e222 / 64u);
    if ((_e222 % 64u) > 0u) {
        phi_394_ = (_e223 + 1u);
    } else {
        phi_394_ = _e223;
    }
    let _e228 = phi_394_;
    if (_e228 > _e198) {
        let _e230 = (_e228 - _e198);
        if (_e201 == 0u) {
            return;
        }
        let _e232 = (_e230 / _e201);
        if (_e201 == 0u) {
            return;
        }
        if ((_e230 % _e201) > 0u) {
            phi_415_ = (_e232 + 1u);
        } else {
            phi_415_ = _e232;
        }
        let _e238 = phi_415_;
        phi_416_ = _e238;
    } else {
        phi_416_ = 0u;
    }
    let _e240 = phi_416_;
    phi_419_ = type_9(0u, _e240);
    loop {
        let _e243 = phi_419_;
        if (_e243.member < _e243.member_1) {
            phi_420_ = type_9((_e243.member + 1u), _e243.member_1);
            phi_443_ = type_9(1u, _e243.member);
        } else {
            phi_420_ = _e243;
            phi_443_ = type_9(0u, type_9().member_1);
        }
        let _e255 = phi_420_;
        let _e257 = phi_443_;
        let _e261 = (bitcast<i32>(_e257.member) != 0i);
        if _e261 {
            let _e265 = (((_e198 + (_e257.member_1 * _e201)) * 64u) + _e185);
            let _e269 = params.member.member_2.member.member;
            if (_e265 < _e222) {
                let _e274 = params.member.member_1.member_1;
                let _e276 = (2u * (_e274 + _e265));
                let _e279 = input.member[(4u + _e276)];
                let _e282 = input.member[(_e276 + 5u)];
                let _e287 = params.member.member_2.member.member;
                if (_e287 == 0u) {
                    let _e303 = (3u * _e282);
                    let _e305 = elements.member[_e303];
                    let _e308 = elements.member[(_e303 + 1u)];
                    let _e311 = elements.member[(_e303 + 2u)];
                    phi_579_ = type_25(0u, array<u32, 4>(_e279, _e305, _e308, _e311));
                } else {
                    let _e289 = (2u * _e279);
                    let _e290 = (2u * _e282);
                    let _e292 = elements.member[_e289];
                    let _e294 = elements.member[_e290];
                    let _e297 = elements.member[(_e289 + 1u)];
                    let _e300 = elements.member[(_e290 + 1u)];
                    phi_579_ = type_25(1u, array<u32, 4>(_e292, _e297, _e294, _e300));
                }
                let _e315 = phi_579_;
                local_58 = array<u32, 4>(_e315.member_1[0], _e315.member_1[1], _e315.member_1[2], _e315.member_1[3]);
                let _e323 = local_58;
                let _e329 = paths.member[_e323[0]];
                let _e331 = paths.member[_e323[1]];
                let _e337 = paths.member[_e323[2]];
                let _e339 = paths.member[_e323[3]];
                local_59 = array<array<f32, 3>, 4>(array<f32, 3>(_e329.member[0], _e329.member[1], _e329.member[2]), array<f32, 3>(_e331.member[0], _e331.member[1], _e331.member[2]), array<f32, 3>(_e337.member[0], _e337.member[1], _e337.member[2]), array<f32, 3>(_e339.member[0], _e339.member[1], _e339.member[2]));
                local_60 = array<array<f32, 3>, 4>(array<f32, 3>(_e329.member_1[0], _e329.member_1[1], _e329.member_1[2]), array<f32, 3>(_e331.member_1[0], _e331.member_1[1], _e331.member_1[2]), array<f32, 3>(_e337.member_1[0], _e337.member_1[1], _e337.member_1[2]), array<f32, 3>(_e339.member_1[0], _e339.member_1[1], _e339.member_1[2]));
                let _e379 = params.member.member.member_4;
                if (_e315.member != 0u) {
                    let _e471 = local_59[2u];
                    let _e476 = local_59[0u];
                    let _e485 = local_60[2u];
                    let _e490 = local_60[0u];
                    let _e500 = local_59[1u];
                    let _e505 = local_59[0u];
                    let _e514 = local_60[1u];
                    let _e519 = local_60[0u];
                    let _e529 = local_59[2u];
                    let _e534 = local_59[3u];
                    let _e543 = local_60[2u];
                    let _e548 = local_60[3u];
                    phi_1001_ = type_23(array<array<f32, 3>, 2>(array<f32, 3>((_e471[0] - _e476[0]), (_e471[1] - _e476[1]), (_e471[2] - _e476[2])), array<f32, 3>((_e485[0] - _e490[0]), (_e485[1] - _e490[1]), (_e485[2] - _e490[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e500[0] - _e505[0]), (_e500[1] - _e505[1]), (_e500[2] - _e505[2])), array<f32, 3>((_e514[0] - _e519[0]), (_e514[1] - _e519[1]), (_e514[2] - _e519[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e529[0] - _e534[0]), (_e529[1] - _e534[1]), (_e529[2] - _e534[2])), array<f32, 3>((_e543[0] - _e548[0]), (_e543[1] - _e548[1]), (_e543[2] - _e548[2]))), (_e379 + _e379));
                } else {
                    let _e382 = local_59[0u];
                    let _e387 = local_59[1u];
                    let _e396 = local_60[0u];
                    let _e401 = local_60[1u];
                    let _e411 = local_59[2u];
                    let _e416 = local_59[1u];
                    let _e425 = local_60[2u];
                    let _e430 = local_60[1u];
                    let _e440 = local_59[3u];
                    let _e445 = local_59[1u];
                    let _e454 = local_60[3u];
                    let _e459 = local_60[1u];
                    phi_1001_ = type_23(array<array<f32, 3>, 2>(array<f32, 3>((_e382[0] - _e387[0]), (_e382[1] - _e387[1]), (_e382[2] - _e387[2])), array<f32, 3>((_e396[0] - _e401[0]), (_e396[1] - _e401[1]), (_e396[2] - _e401[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e411[0] - _e416[0]), (_e411[1] - _e416[1]), (_e411[2] - _e416[2])), array<f32, 3>((_e425[0] - _e430[0]), (_e425[1] - _e430[1]), (_e425[2] - _e430[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e440[0] - _e445[0]), (_e440[1] - _e445[1]), (_e440[2] - _e445[2])), array<f32, 3>((_e454[0] - _e459[0]), (_e454[1] - _e459[1]), (_e454[2] - _e459[2]))), (_e379 + _e379));
                }
                let _e560 = phi_1001_;
                if (_e560.member[0][0] < 0f) {
                    phi_1009_ = -(_e560.member[0][0]);
                } else {
                    phi_1009_ = _e560.member[0][0];
                }
                let _e567 = phi_1009_;
                if (_e560.member[0][1] < 0f) {
                    phi_1016_ = -(_e560.member[0][1]);
                } else {
                    phi_1016_ = _e560.member[0][1];
                }
                let _e572 = phi_1016_;
                if (_e567 > _e572) {
                    phi_1021_ = _e567;
                } else {
                    phi_1021_ = _e572;
                }
                let _e575 = phi_1021_;
                if (_e560.member[0][2] < 0f) {
                    phi_1028_ = -(_e560.member[0][2]);
                } else {
                    phi_1028_ = _e560.member[0][2];
                }
                let _e580 = phi_1028_;
                if (_e575 > _e580) {
                    phi_1033_ = _e575;
                } else {
                    phi_1033_ = _e580;
                }
                let _e583 = phi_1033_;
                if (_e560.member[1][0] < 0f) {
                    phi_1041_ = -(_e560.member[1][0]);
                } else {
                    phi_1041_ = _e560.member[1][0];
                }
                let _e590 = phi_1041_;
                if (_e560.member[1][1] < 0f) {
                    phi_1048_ = -(_e560.member[1][1]);
                } else {
                    phi_1048_ = _e560.member[1][1];
                }
                let _e595 = phi_1048_;
                if (_e590 > _e595) {
                    phi_1053_ = _e590;
                } else {
                    phi_1053_ = _e595;
                }
                let _e598 = phi_1053_;
                if (_e560.member[1][2] < 0f) {
                    phi_1060_ = -(_e560.member[1][2]);
                } else {
                    phi_1060_ = _e560.member[1][2];
                }
                let _e603 = phi_1060_;
                if (_e598 > _e603) {
                    phi_1065_ = _e598;
                } else {
                    phi_1065_ = _e603;
                }
                let _e606 = phi_1065_;
                if (_e583 > _e606) {
                    phi_1070_ = _e583;
                } else {
                    phi_1070_ = _e606;
                }
                let _e609 = phi_1070_;
                if (_e560.member_1[0][0] < 0f) {
                    phi_1080_ = -(_e560.member_1[0][0]);
                } else {
                    phi_1080_ = _e560.member_1[0][0];
                }
                let _e618 = phi_1080_;
                if (_e560.member_1[0][1] < 0f) {
                    phi_1087_ = -(_e560.member_1[0][1]);
                } else {
                    phi_1087_ = _e560.member_1[0][1];
                }
                let _e623 = phi_1087_;
                if (_e618 > _e623) {
                    phi_1092_ = _e618;
                } else {
                    phi_1092_ = _e623;
                }
                let _e626 = phi_1092_;
                if (_e560.member_1[0][2] < 0f) {
                    phi_1099_ = -(_e560.member_1[0][2]);
                } else {
                    phi_1099_ = _e560.member_1[0][2];
                }
                let _e631 = phi_1099_;
                if (_e626 > _e631) {
                    phi_1104_ = _e626;
                } else {
                    phi_1104_ = _e631;
                }
                let _e634 = phi_1104_;
                if (_e560.member_1[1][0] < 0f) {
                    phi_1112_ = -(_e560.member_1[1][0]);
                } else {
                    phi_1112_ = _e560.member_1[1][0];
                }
                let _e641 = phi_1112_;
                if (_e560.member_1[1][1] < 0f) {
                    phi_1119_ = -(_e560.member_1[1][1]);
                } else {
                    phi_1119_ = _e560.member_1[1][1];
                }
                let _e646 = phi_1119_;
                if (_e641 > _e646) {
                    phi_1124_ = _e641;
                } else {
                    phi_1124_ = _e646;
                }
                let _e649 = phi_1124_;
                if (_e560.member_1[1][2] < 0f) {
                    phi_1131_ = -(_e560.member_1[1][2]);
                } else {
                    phi_1131_ = _e560.member_1[1][2];
                }
                let _e654 = phi_1131_;
                if (_e649 > _e654) {
                    phi_1136_ = _e649;
                } else {
                    phi_1136_ = _e654;
                }
                let _e657 = phi_1136_;
                if (_e634 > _e657) {
                    phi_1141_ = _e634;
                } else {
                    phi_1141_ = _e657;
                }
                let _e660 = phi_1141_;
                if (_e560.member_2[0][0] < 0f) {
                    phi_1151_ = -(_e560.member_2[0][0]);
                } else {
                    phi_1151_ = _e560.member_2[0][0];
                }
                let _e669 = phi_1151_;
                if (_e560.member_2[0][1] < 0f) {
                    phi_1158_ = -(_e560.member_2[0][1]);
                } else {
                    phi_1158_ = _e560.member_2[0][1];
                }
                let _e674 = phi_1158_;
                if (_e669 > _e674) {
                    phi_1163_ = _e669;
                } else {
                    phi_1163_ = _e674;
                }
                let _e677 = phi_1163_;
                if (_e560.member_2[0][2] < 0f) {
                    phi_1170_ = -(_e560.member_2[0][2]);
                } else {
                    phi_1170_ = _e560.member_2[0][2];
                }
                let _e682 = phi_1170_;
                if (_e677 > _e682) {
                    phi_1175_ = _e677;
                } else {
                    phi_1175_ = _e682;
                }
                let _e685 = phi_1175_;
                if (_e560.member_2[1][0] < 0f) {
                    phi_1183_ = -(_e560.member_2[1][0]);
                } else {
                    phi_1183_ = _e560.member_2[1][0];
                }
                let _e692 = phi_1183_;
                if (_e560.member_2[1][1] < 0f) {
                    phi_1190_ = -(_e560.member_2[1][1]);
                } else {
                    phi_1190_ = _e560.member_2[1][1];
                }
                let _e697 = phi_1190_;
                if (_e692 > _e697) {
                    phi_1195_ = _e692;
                } else {
                    phi_1195_ = _e697;
                }
                let _e700 = phi_1195_;
                if (_e560.member_2[1][2] < 0f) {
                    phi_1202_ = -(_e560.member_2[1][2]);
                } else {
                    phi_1202_ = _e560.member_2[1][2];
                }
                let _e705 = phi_1202_;
                if (_e700 > _e705) {
                    phi_1207_ = _e700;
                } else {
                    phi_1207_ = _e705;
                }
                let _e708 = phi_1207_;
                if (_e685 > _e708) {
                    phi_1212_ = _e685;
                } else {
                    phi_1212_ = _e708;
                }
                let _e711 = phi_1212_;
                let _e714 = function_13((_e609 + _e560.member_3), (_e660 + _e560.member_3));
                let _e715 = function_13(_e714, (_e711 + _e560.member_3));
                let _e719 = bitcast<i32>((bitcast<u32>(_e715) >> bitcast<u32>(23i)));
                if (_e719 >= 64i) {
                    if (_e719 <= 190i) {
                        phi_1229_ = (_e719 - 126i);
                        phi_1230_ = false;
                    } else {
                        phi_1229_ = i32();
                        phi_1230_ = true;
                    }
                    let _e724 = phi_1229_;
                    let _e726 = phi_1230_;
                    phi_1231_ = _e724;
                    phi_1232_ = _e726;
                } else {
                    phi_1231_ = i32();
                    phi_1232_ = true;
                }
                let _e728 = phi_1231_;
                let _e730 = phi_1232_;
                if _e730 {
                    phi_1236_ = 2147483647i;
                } else {
                    phi_1236_ = _e728;
                }
                let _e732 = phi_1236_;
                let _e734 = params.member.member_2.member_3;
                if (_e734 > 0u) {
                    if (_e732 != 2147483647i) {
                        let _e738 = params.member.member.member_1;
                        if ((_e738 & 8u) != 0u) {
                            let _e1035 = local_59[0u];
                            let _e1039 = bitcast<u32>(_e1035[0]);
                            let _e1040 = (_e1039 & 2147483647u);
                            if (_e1040 < 8388608u) {
                                phi_1278_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1278_ = array<u32, 2>((_e1039 << bitcast<u32>(29i)), ((_e1039 ^ _e1040) | ((_e1040 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1051 = phi_1278_;
                            let _e1052 = function_12(_e1051, _e732);
                            let _e1053 = bitcast<u32>(_e1035[1]);
                            let _e1054 = (_e1053 & 2147483647u);
                            if (_e1054 < 8388608u) {
                                phi_1295_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1295_ = array<u32, 2>((_e1053 << bitcast<u32>(29i)), ((_e1053 ^ _e1054) | ((_e1054 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1065 = phi_1295_;
                            let _e1066 = function_12(_e1065, _e732);
                            let _e1067 = bitcast<u32>(_e1035[2]);
                            let _e1068 = (_e1067 & 2147483647u);
                            if (_e1068 < 8388608u) {
                                phi_1312_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1312_ = array<u32, 2>((_e1067 << bitcast<u32>(29i)), ((_e1067 ^ _e1068) | ((_e1068 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1079 = phi_1312_;
                            let _e1080 = function_12(_e1079, _e732);
                            let _e1086 = local_60[0u];
                            let _e1090 = bitcast<u32>(_e1086[0]);
                            let _e1091 = (_e1090 & 2147483647u);
                            if (_e1091 < 8388608u) {
                                phi_1346_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1346_ = array<u32, 2>((_e1090 << bitcast<u32>(29i)), ((_e1090 ^ _e1091) | ((_e1091 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1102 = phi_1346_;
                            let _e1103 = function_12(_e1102, _e732);
                            let _e1104 = bitcast<u32>(_e1086[1]);
                            let _e1105 = (_e1104 & 2147483647u);
                            if (_e1105 < 8388608u) {
                                phi_1363_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1363_ = array<u32, 2>((_e1104 << bitcast<u32>(29i)), ((_e1104 ^ _e1105) | ((_e1105 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1116 = phi_1363_;
                            let _e1117 = function_12(_e1116, _e732);
                            let _e1118 = bitcast<u32>(_e1086[2]);
                            let _e1119 = (_e1118 & 2147483647u);
                            if (_e1119 < 8388608u) {
                                phi_1380_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1380_ = array<u32, 2>((_e1118 << bitcast<u32>(29i)), ((_e1118 ^ _e1119) | ((_e1119 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1130 = phi_1380_;
                            let _e1131 = function_12(_e1130, _e732);
                            let _e1138 = local_59[1u];
                            let _e1142 = bitcast<u32>(_e1138[0]);
                            let _e1143 = (_e1142 & 2147483647u);
                            if (_e1143 < 8388608u) {
                                phi_1415_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1415_ = array<u32, 2>((_e1142 << bitcast<u32>(29i)), ((_e1142 ^ _e1143) | ((_e1143 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1154 = phi_1415_;
                            let _e1155 = function_12(_e1154, _e732);
                            let _e1156 = bitcast<u32>(_e1138[1]);
                            let _e1157 = (_e1156 & 2147483647u);
                            if (_e1157 < 8388608u) {
                                phi_1432_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1432_ = array<u32, 2>((_e1156 << bitcast<u32>(29i)), ((_e1156 ^ _e1157) | ((_e1157 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1168 = phi_1432_;
                            let _e1169 = function_12(_e1168, _e732);
                            let _e1170 = bitcast<u32>(_e1138[2]);
                            let _e1171 = (_e1170 & 2147483647u);
                            if (_e1171 < 8388608u) {
                                phi_1449_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1449_ = array<u32, 2>((_e1170 << bitcast<u32>(29i)), ((_e1170 ^ _e1171) | ((_e1171 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1182 = phi_1449_;
                            let _e1183 = function_12(_e1182, _e732);
                            let _e1189 = local_60[1u];
                            let _e1193 = bitcast<u32>(_e1189[0]);
                            let _e1194 = (_e1193 & 2147483647u);
                            if (_e1194 < 8388608u) {
                                phi_1483_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1483_ = array<u32, 2>((_e1193 << bitcast<u32>(29i)), ((_e1193 ^ _e1194) | ((_e1194 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1205 = phi_1483_;
                            let _e1206 = function_12(_e1205, _e732);
                            let _e1207 = bitcast<u32>(_e1189[1]);
                            let _e1208 = (_e1207 & 2147483647u);
                            if (_e1208 < 8388608u) {
                                phi_1500_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1500_ = array<u32, 2>((_e1207 << bitcast<u32>(29i)), ((_e1207 ^ _e1208) | ((_e1208 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1219 = phi_1500_;
                            let _e1220 = function_12(_e1219, _e732);
                            let _e1221 = bitcast<u32>(_e1189[2]);
                            let _e1222 = (_e1221 & 2147483647u);
                            if (_e1222 < 8388608u) {
                                phi_1517_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1517_ = array<u32, 2>((_e1221 << bitcast<u32>(29i)), ((_e1221 ^ _e1222) | ((_e1222 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1233 = phi_1517_;
                            let _e1234 = function_12(_e1233, _e732);
                            let _e1241 = local_59[2u];
                            let _e1245 = bitcast<u32>(_e1241[0]);
                            let _e1246 = (_e1245 & 2147483647u);
                            if (_e1246 < 8388608u) {
                                phi_1552_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1552_ = array<u32, 2>((_e1245 << bitcast<u32>(29i)), ((_e1245 ^ _e1246) | ((_e1246 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1257 = phi_1552_;
                            let _e1258 = function_12(_e1257, _e732);
                            let _e1259 = bitcast<u32>(_e1241[1]);
                            let _e1260 = (_e1259 & 2147483647u);
                            if (_e1260 < 8388608u) {
                                phi_1569_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1569_ = array<u32, 2>((_e1259 << bitcast<u32>(29i)), ((_e1259 ^ _e1260) | ((_e1260 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1271 = phi_1569_;
                            let _e1272 = function_12(_e1271, _e732);
                            let _e1273 = bitcast<u32>(_e1241[2]);
                            let _e1274 = (_e1273 & 2147483647u);
                            if (_e1274 < 8388608u) {
                                phi_1586_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1586_ = array<u32, 2>((_e1273 << bitcast<u32>(29i)), ((_e1273 ^ _e1274) | ((_e1274 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1285 = phi_1586_;
                            let _e1286 = function_12(_e1285, _e732);
                            let _e1292 = local_60[2u];
                            let _e1296 = bitcast<u32>(_e1292[0]);
                            let _e1297 = (_e1296 & 2147483647u);
                            if (_e1297 < 8388608u) {
                                phi_1620_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1620_ = array<u32, 2>((_e1296 << bitcast<u32>(29i)), ((_e1296 ^ _e1297) | ((_e1297 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1308 = phi_1620_;
                            let _e1309 = function_12(_e1308, _e732);
                            let _e1310 = bitcast<u32>(_e1292[1]);
                            let _e1311 = (_e1310 & 2147483647u);
                            if (_e1311 < 8388608u) {
                                phi_1637_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1637_ = array<u32, 2>((_e1310 << bitcast<u32>(29i)), ((_e1310 ^ _e1311) | ((_e1311 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1322 = phi_1637_;
                            let _e1323 = function_12(_e1322, _e732);
                            let _e1324 = bitcast<u32>(_e1292[2]);
                            let _e1325 = (_e1324 & 2147483647u);
                            if (_e1325 < 8388608u) {
                                phi_1654_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1654_ = array<u32, 2>((_e1324 << bitcast<u32>(29i)), ((_e1324 ^ _e1325) | ((_e1325 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1336 = phi_1654_;
                            let _e1337 = function_12(_e1336, _e732);
                            let _e1344 = local_59[3u];
                            let _e1348 = bitcast<u32>(_e1344[0]);
                            let _e1349 = (_e1348 & 2147483647u);
                            if (_e1349 < 8388608u) {
                                phi_1689_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1689_ = array<u32, 2>((_e1348 << bitcast<u32>(29i)), ((_e1348 ^ _e1349) | ((_e1349 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1360 = phi_1689_;
                            let _e1361 = function_12(_e1360, _e732);
                            let _e1362 = bitcast<u32>(_e1344[1]);
                            let _e1363 = (_e1362 & 2147483647u);
                            if (_e1363 < 8388608u) {
                                phi_1706_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1706_ = array<u32, 2>((_e1362 << bitcast<u32>(29i)), ((_e1362 ^ _e1363) | ((_e1363 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1374 = phi_1706_;
                            let _e1375 = function_12(_e1374, _e732);
                            let _e1376 = bitcast<u32>(_e1344[2]);
                            let _e1377 = (_e1376 & 2147483647u);
                            if (_e1377 < 8388608u) {
                                phi_1723_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1723_ = array<u32, 2>((_e1376 << bitcast<u32>(29i)), ((_e1376 ^ _e1377) | ((_e1377 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1388 = phi_1723_;
                            let _e1389 = function_12(_e1388, _e732);
                            let _e1395 = local_60[3u];
                            let _e1399 = bitcast<u32>(_e1395[0]);
                            let _e1400 = (_e1399 & 2147483647u);
                            if (_e1400 < 8388608u) {
                                phi_1757_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1757_ = array<u32, 2>((_e1399 << bitcast<u32>(29i)), ((_e1399 ^ _e1400) | ((_e1400 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1411 = phi_1757_;
                            let _e1412 = function_12(_e1411, _e732);
                            let _e1413 = bitcast<u32>(_e1395[1]);
                            let _e1414 = (_e1413 & 2147483647u);
                            if (_e1414 < 8388608u) {
                                phi_1774_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1774_ = array<u32, 2>((_e1413 << bitcast<u32>(29i)), ((_e1413 ^ _e1414) | ((_e1414 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1425 = phi_1774_;
                            let _e1426 = function_12(_e1425, _e732);
                            let _e1427 = bitcast<u32>(_e1395[2]);
                            let _e1428 = (_e1427 & 2147483647u);
                            if (_e1428 < 8388608u) {
                                phi_1791_ = array<u32, 2>(0u, 0u);
                            } else {
                                phi_1791_ = array<u32, 2>((_e1427 << bitcast<u32>(29i)), ((_e1427 ^ _e1428) | ((_e1428 >> bitcast<u32>(3i)) + 939524096u)));
                            }
                            let _e1439 = phi_1791_;
                            let _e1440 = function_12(_e1439, _e732);
                            phi_2708_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e1052, _e1066, type_9(_e1080.member, _e1080.member_1)), array<type_9, 3>(_e1103, _e1117, type_9(_e1131.member, _e1131.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1155, _e1169, type_9(_e1183.member, _e1183.member_1)), array<type_9, 3>(_e1206, _e1220, type_9(_e1234.member, _e1234.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1258, _e1272, type_9(_e1286.member, _e1286.member_1)), array<type_9, 3>(_e1309, _e1323, type_9(_e1337.member, _e1337.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1361, _e1375, type_9(_e1389.member, _e1389.member_1)), array<type_9, 3>(_e1412, _e1426, type_9(_e1440.member, _e1440.member_1))));
                        } else {
                            let _e743 = params.member.member.member_10[1u];
                            local_61 = (_e732 - (bitcast<i32>((_e743 >> bitcast<u32>(20i))) - 1023i));
                            let _e750 = local_58[0u];
                            let _e753 = params.member.member.member[0u];
                            let _e755 = (6u * (_e753 + _e750));
                            let _e756 = (6u * _e750);
                            let _e757 = local_61;
                            local_57 = _e757;
                            let _e759 = positions.member[_e756];
                            let _e762 = positions.member[(_e756 + 1u)];
                            let _e764 = local_57;
                            let _e765 = function_12(array<u32, 2>(_e759, _e762), _e764);
                            let _e768 = positions.member[(_e756 + 2u)];
                            let _e771 = positions.member[(_e756 + 3u)];
                            let _e773 = local_57;
                            let _e774 = function_12(array<u32, 2>(_e768, _e771), _e773);
                            let _e777 = positions.member[(_e756 + 4u)];
                            let _e780 = positions.member[(_e756 + 5u)];
                            let _e782 = local_57;
                            let _e783 = function_12(array<u32, 2>(_e777, _e780), _e782);
                            let _e788 = local_61;
                            local_56 = _e788;
                            let _e790 = positions.member[_e755];
                            let _e793 = positions.member[(_e755 + 1u)];
                            let _e795 = local_56;
                            let _e796 = function_12(array<u32, 2>(_e790, _e793), _e795);
                            let _e799 = positions.member[(_e755 + 2u)];
                            let _e802 = positions.member[(_e755 + 3u)];
                            let _e804 = local_56;
                            let _e805 = function_12(array<u32, 2>(_e799, _e802), _e804);
                            let _e808 = positions.member[(_e755 + 4u)];
                            let _e811 = positions.member[(_e755 + 5u)];
                            let _e813 = local_56;
                            let _e814 = function_12(array<u32, 2>(_e808, _e811), _e813);
                            let _e821 = local_58[1u];
                            let _e824 = params.member.member.member[0u];
                            let _e826 = (6u * (_e824 + _e821));
                            let _e827 = (6u * _e821);
                            let _e828 = local_61;
                            local_55 = _e828;
                            let _e830 = positions.member[_e827];
                            let _e833 = positions.member[(_e827 + 1u)];
                            let _e835 = local_55;
                            let _e836 = function_12(array<u32, 2>(_e830, _e833), _e835);
                            let _e839 = positions.member[(_e827 + 2u)];
                            let _e842 = positions.member[(_e827 + 3u)];
                            let _e844 = local_55;
                            let _e845 = function_12(array<u32, 2>(_e839, _e842), _e844);
                            let _e848 = positions.member[(_e827 + 4u)];
                            let _e851 = positions.member[(_e827 + 5u)];
                            let _e853 = local_55;
                            let _e854 = function_12(array<u32, 2>(_e848, _e851), _e853);
                            let _e859 = local_61;
                            local_54 = _e859;
                            let _e861 = positions.member[_e826];
                            let _e864 = positions.member[(_e826 + 1u)];
                            let _e866 = local_54;
                            let _e867 = function_12(array<u32, 2>(_e861, _e864), _e866);
                            let _e870 = positions.member[(_e826 + 2u)];
                            let _e873 = positions.member[(_e826 + 3u)];
                            let _e875 = local_54;
                            let _e876 = function_12(array<u32, 2>(_e870, _e873), _e875);
                            let _e879 = positions.member[(_e826 + 4u)];
                            let _e882 = positions.member[(_e826 + 5u)];
                            let _e884 = local_54;
                            let _e885 = function_12(array<u32, 2>(_e879, _e882), _e884);
                            let _e892 = local_58[2u];
                            let _e895 = params.member.member.member[0u];
                            let _e897 = (6u * (_e895 + _e892));
                            let _e898 = (6u * _e892);
                            let _e899 = local_61;
                            local_53 = _e899;
                            let _e901 = positions.member[_e898];
                            let _e904 = positions.member[(_e898 + 1u)];
                            let _e906 = local_53;
                            let _e907 = function_12(array<u32, 2>(_e901, _e904), _e906);
                            let _e910 = positions.member[(_e898 + 2u)];
                            let _e913 = positions.member[(_e898 + 3u)];
                            let _e915 = local_53;
                            let _e916 = function_12(array<u32, 2>(_e910, _e913), _e915);
                            let _e919 = positions.member[(_e898 + 4u)];
                            let _e922 = positions.member[(_e898 + 5u)];
                            let _e924 = local_53;
                            let _e925 = function_12(array<u32, 2>(_e919, _e922), _e924);
                            let _e930 = local_61;
                            local_52 = _e930;
                            let _e932 = positions.member[_e897];
                            let _e935 = positions.member[(_e897 + 1u)];
                            let _e937 = local_52;
                            let _e938 = function_12(array<u32, 2>(_e932, _e935), _e937);
                            let _e941 = positions.member[(_e897 + 2u)];
                            let _e944 = positions.member[(_e897 + 3u)];
                            let _e946 = local_52;
                            let _e947 = function_12(array<u32, 2>(_e941, _e944), _e946);
                            let _e950 = positions.member[(_e897 + 4u)];
                            let _e953 = positions.member[(_e897 + 5u)];
                            let _e955 = local_52;
                            let _e956 = function_12(array<u32, 2>(_e950, _e953), _e955);
                            let _e963 = local_58[3u];
                            let _e966 = params.member.member.member[0u];
                            let _e968 = (6u * (_e966 + _e963));
                            let _e969 = (6u * _e963);
                            let _e970 = local_61;
                            local_51 = _e970;
                            let _e972 = positions.member[_e969];
                            let _e975 = positions.member[(_e969 + 1u)];
                            let _e977 = local_51;
                            let _e978 = function_12(array<u32, 2>(_e972, _e975), _e977);
                            let _e981 = positions.member[(_e969 + 2u)];
                            let _e984 = positions.member[(_e969 + 3u)];
                            let _e986 = local_51;
                            let _e987 = function_12(array<u32, 2>(_e981, _e984), _e986);
                            let _e990 = positions.member[(_e969 + 4u)];
                            let _e993 = positions.member[(_e969 + 5u)];
                            let _e995 = local_51;
                            let _e996 = function_12(array<u32, 2>(_e990, _e993), _e995);
                            let _e1001 = local_61;
                            local_50 = _e1001;
                            let _e1003 = positions.member[_e968];
                            let _e1006 = positions.member[(_e968 + 1u)];
                            let _e1008 = local_50;
                            let _e1009 = function_12(array<u32, 2>(_e1003, _e1006), _e1008);
                            let _e1012 = positions.member[(_e968 + 2u)];
                            let _e1015 = positions.member[(_e968 + 3u)];
                            let _e1017 = local_50;
                            let _e1018 = function_12(array<u32, 2>(_e1012, _e1015), _e1017);
                            let _e1021 = positions.member[(_e968 + 4u)];
                            let _e1024 = positions.member[(_e968 + 5u)];
                            let _e1026 = local_50;
                            let _e1027 = function_12(array<u32, 2>(_e1021, _e1024), _e1026);
                            phi_2708_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e765, _e774, type_9(_e783.member, _e783.member_1)), array<type_9, 3>(_e796, _e805, type_9(_e814.member, _e814.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e836, _e845, type_9(_e854.member, _e854.member_1)), array<type_9, 3>(_e867, _e876, type_9(_e885.member, _e885.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e907, _e916, type_9(_e925.member, _e925.member_1)), array<type_9, 3>(_e938, _e947, type_9(_e956.member, _e956.member_1))), array<array<type_9, 3>, 2>(array<type_9, 3>(_e978, _e987, type_9(_e996.member, _e996.member_1)), array<type_9, 3>(_e1009, _e1018, type_9(_e1027.member, _e1027.member_1))));
                        }
                        let _e1448 = phi_2708_;
                        let _e1450 = params.member.member_2.member_1;
                        let _e1452 = params.member.member_2.member_2;
                        let _e1454 = params.member.member_2.member_3;
                        if (_e315.member != 0u) {
                            if (_e1448[2][0][0].member_1 < _e1448[0][0][0].member_1) {
                                phi_2729_ = 1u;
                            } else {
                                phi_2729_ = 0u;
                            }
                            let _e1774 = phi_2729_;
                            if (_e1448[2][0][1].member_1 < _e1448[0][0][1].member_1) {
                                phi_2741_ = 1u;
                            } else {
                                phi_2741_ = 0u;
                            }
                            let _e1788 = phi_2741_;
                            if (_e1448[2][0][2].member_1 < _e1448[0][0][2].member_1) {
                                phi_2753_ = 1u;
                            } else {
                                phi_2753_ = 0u;
                            }
                            let _e1802 = phi_2753_;
                            if (_e1448[2][1][0].member_1 < _e1448[0][1][0].member_1) {
                                phi_2773_ = 1u;
                            } else {
                                phi_2773_ = 0u;
                            }
                            let _e1824 = phi_2773_;
                            if (_e1448[2][1][1].member_1 < _e1448[0][1][1].member_1) {
                                phi_2785_ = 1u;
                            } else {
                                phi_2785_ = 0u;
                            }
                            let _e1838 = phi_2785_;
                            if (_e1448[2][1][2].member_1 < _e1448[0][1][2].member_1) {
                                phi_2797_ = 1u;
                            } else {
                                phi_2797_ = 0u;
                            }
                            let _e1852 = phi_2797_;
                            if (_e1448[1][0][0].member_1 < _e1448[0][0][0].member_1) {
                                phi_2818_ = 1u;
                            } else {
                                phi_2818_ = 0u;
                            }
                            let _e1875 = phi_2818_;
                            if (_e1448[1][0][1].member_1 < _e1448[0][0][1].member_1) {
                                phi_2830_ = 1u;
                            } else {
                                phi_2830_ = 0u;
                            }
                            let _e1889 = phi_2830_;
                            if (_e1448[1][0][2].member_1 < _e1448[0][0][2].member_1) {
                                phi_2842_ = 1u;
                            } else {
                                phi_2842_ = 0u;
                            }
                            let _e1903 = phi_2842_;
                            if (_e1448[1][1][0].member_1 < _e1448[0][1][0].member_1) {
                                phi_2862_ = 1u;
                            } else {
                                phi_2862_ = 0u;
                            }
                            let _e1925 = phi_2862_;
                            if (_e1448[1][1][1].member_1 < _e1448[0][1][1].member_1) {
                                phi_2874_ = 1u;
                            } else {
                                phi_2874_ = 0u;
                            }
                            let _e1939 = phi_2874_;
                            if (_e1448[1][1][2].member_1 < _e1448[0][1][2].member_1) {
                                phi_2886_ = 1u;
                            } else {
                                phi_2886_ = 0u;
                            }
                            let _e1953 = phi_2886_;
                            if (_e1448[2][0][0].member_1 < _e1448[3][0][0].member_1) {
                                phi_2907_ = 1u;
                            } else {
                                phi_2907_ = 0u;
                            }
                            let _e1976 = phi_2907_;
                            if (_e1448[2][0][1].member_1 < _e1448[3][0][1].member_1) {
                                phi_2919_ = 1u;
                            } else {
                                phi_2919_ = 0u;
                            }
                            let _e1990 = phi_2919_;
                            if (_e1448[2][0][2].member_1 < _e1448[3][0][2].member_1) {
                                phi_2931_ = 1u;
                            } else {
                                phi_2931_ = 0u;
                            }
                            let _e2004 = phi_2931_;
                            if (_e1448[2][1][0].member_1 < _e1448[3][1][0].member_1) {
                                phi_2951_ = 1u;
                            } else {
                                phi_2951_ = 0u;
                            }
                            let _e2026 = phi_2951_;
                            if (_e1448[2][1][1].member_1 < _e1448[3][1][1].member_1) {
                                phi_2963_ = 1u;
                            } else {
                                phi_2963_ = 0u;
                            }
                            let _e2040 = phi_2963_;
                            if (_e1448[2][1][2].member_1 < _e1448[3][1][2].member_1) {
                                phi_2975_ = 1u;
                            } else {
                                phi_2975_ = 0u;
                            }
                            let _e2054 = phi_2975_;
                            phi_3255_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1448[2][0][0].member - _e1448[0][0][0].member) - _e1774), (_e1448[2][0][0].member_1 - _e1448[0][0][0].member_1)), type_9(((_e1448[2][0][1].member - _e1448[0][0][1].member) - _e1788), (_e1448[2][0][1].member_1 - _e1448[0][0][1].member_1)), type_9(((_e1448[2][0][2].member - _e1448[0][0][2].member) - _e1802), (_e1448[2][0][2].member_1 - _e1448[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1448[2][1][0].member - _e1448[0][1][0].member) - _e1824), (_e1448[2][1][0].member_1 - _e1448[0][1][0].member_1)), type_9(((_e1448[2][1][1].member - _e1448[0][1][1].member) - _e1838), (_e1448[2][1][1].member_1 - _e1448[0][1][1].member_1)), type_9(((_e1448[2][1][2].member - _e1448[0][1][2].member) - _e1852), (_e1448[2][1][2].member_1 - _e1448[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1448[1][0][0].member - _e1448[0][0][0].member) - _e1875), (_e1448[1][0][0].member_1 - _e1448[0][0][0].member_1)), type_9(((_e1448[1][0][1].member - _e1448[0][0][1].member) - _e1889), (_e1448[1][0][1].member_1 - _e1448[0][0][1].member_1)), type_9(((_e1448[1][0][2].member - _e1448[0][0][2].member) - _e1903), (_e1448[1][0][2].member_1 - _e1448[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1448[1][1][0].member - _e1448[0][1][0].member) - _e1925), (_e1448[1][1][0].member_1 - _e1448[0][1][0].member_1)), type_9(((_e1448[1][1][1].member - _e1448[0][1][1].member) - _e1939), (_e1448[1][1][1].member_1 - _e1448[0][1][1].member_1)), type_9(((_e1448[1][1][2].member - _e1448[0][1][2].member) - _e1953), (_e1448[1][1][2].member_1 - _e1448[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1448[2][0][0].member - _e1448[3][0][0].member) - _e1976), (_e1448[2][0][0].member_1 - _e1448[3][0][0].member_1)), type_9(((_e1448[2][0][1].member - _e1448[3][0][1].member) - _e1990), (_e1448[2][0][1].member_1 - _e1448[3][0][1].member_1)), type_9(((_e1448[2][0][2].member - _e1448[3][0][2].member) - _e2004), (_e1448[2][0][2].member_1 - _e1448[3][0][2].member_1))), array<type_9, 3>(type_9(((_e1448[2][1][0].member - _e1448[3][1][0].member) - _e2026), (_e1448[2][1][0].member_1 - _e1448[3][1][0].member_1)), type_9(((_e1448[2][1][1].member - _e1448[3][1][1].member) - _e2040), (_e1448[2][1][1].member_1 - _e1448[3][1][1].member_1)), type_9(((_e1448[2][1][2].member - _e1448[3][1][2].member) - _e2054), (_e1448[2][1][2].member_1 - _e1448[3][1][2].member_1)))));
                        } else {
                            if (_e1448[0][0][0].member_1 < _e1448[1][0][0].member_1) {
                                phi_2997_ = 1u;
                            } else {
                                phi_2997_ = 0u;
                            }
                            let _e1470 = phi_2997_;
                            if (_e1448[0][0][1].member_1 < _e1448[1][0][1].member_1) {
                                phi_3009_ = 1u;
                            } else {
                                phi_3009_ = 0u;
                            }
                            let _e1484 = phi_3009_;
                            if (_e1448[0][0][2].member_1 < _e1448[1][0][2].member_1) {
                                phi_3021_ = 1u;
                            } else {
                                phi_3021_ = 0u;
                            }
                            let _e1498 = phi_3021_;
                            if (_e1448[0][1][0].member_1 < _e1448[1][1][0].member_1) {
                                phi_3041_ = 1u;
                            } else {
                                phi_3041_ = 0u;
                            }
                            let _e1520 = phi_3041_;
                            if (_e1448[0][1][1].member_1 < _e1448[1][1][1].member_1) {
                                phi_3053_ = 1u;
                            } else {
                                phi_3053_ = 0u;
                            }
                            let _e1534 = phi_3053_;
                            if (_e1448[0][1][2].member_1 < _e1448[1][1][2].member_1) {
                                phi_3065_ = 1u;
                            } else {
                                phi_3065_ = 0u;
                            }
                            let _e1548 = phi_3065_;
                            if (_e1448[2][0][0].member_1 < _e1448[1][0][0].member_1) {
                                phi_3086_ = 1u;
                            } else {
                                phi_3086_ = 0u;
                            }
                            let _e1571 = phi_3086_;
                            if (_e1448[2][0][1].member_1 < _e1448[1][0][1].member_1) {
                                phi_3098_ = 1u;
                            } else {
                                phi_3098_ = 0u;
                            }
                            let _e1585 = phi_3098_;
                            if (_e1448[2][0][2].member_1 < _e1448[1][0][2].member_1) {
                                phi_3110_ = 1u;
                            } else {
                                phi_3110_ = 0u;
                            }
                            let _e1599 = phi_3110_;
                            if (_e1448[2][1][0].member_1 < _e1448[1][1][0].member_1) {
                                phi_3130_ = 1u;
                            } else {
                                phi_3130_ = 0u;
                            }
                            let _e1621 = phi_3130_;
                            if (_e1448[2][1][1].member_1 < _e1448[1][1][1].member_1) {
                                phi_3142_ = 1u;
                            } else {
                                phi_3142_ = 0u;
                            }
                            let _e1635 = phi_3142_;
                            if (_e1448[2][1][2].member_1 < _e1448[1][1][2].member_1) {
                                phi_3154_ = 1u;
                            } else {
                                phi_3154_ = 0u;
                            }
                            let _e1649 = phi_3154_;
                            if (_e1448[3][0][0].member_1 < _e1448[1][0][0].member_1) {
                                phi_3175_ = 1u;
                            } else {
                                phi_3175_ = 0u;
                            }
                            let _e1672 = phi_3175_;
                            if (_e1448[3][0][1].member_1 < _e1448[1][0][1].member_1) {
                                phi_3187_ = 1u;
                            } else {
                                phi_3187_ = 0u;
                            }
                            let _e1686 = phi_3187_;
                            if (_e1448[3][0][2].member_1 < _e1448[1][0][2].member_1) {
                                phi_3199_ = 1u;
                            } else {
                                phi_3199_ = 0u;
                            }
                            let _e1700 = phi_3199_;
                            if (_e1448[3][1][0].member_1 < _e1448[1][1][0].member_1) {
                                phi_3219_ = 1u;
                            } else {
                                phi_3219_ = 0u;
                            }
                            let _e1722 = phi_3219_;
                            if (_e1448[3][1][1].member_1 < _e1448[1][1][1].member_1) {
                                phi_3231_ = 1u;
                            } else {
                                phi_3231_ = 0u;
                            }
                            let _e1736 = phi_3231_;
                            if (_e1448[3][1][2].member_1 < _e1448[1][1][2].member_1) {
                                phi_3243_ = 1u;
                            } else {
                                phi_3243_ = 0u;
                            }
                            let _e1750 = phi_3243_;
                            phi_3255_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1448[0][0][0].member - _e1448[1][0][0].member) - _e1470), (_e1448[0][0][0].member_1 - _e1448[1][0][0].member_1)), type_9(((_e1448[0][0][1].member - _e1448[1][0][1].member) - _e1484), (_e1448[0][0][1].member_1 - _e1448[1][0][1].member_1)), type_9(((_e1448[0][0][2].member - _e1448[1][0][2].member) - _e1498), (_e1448[0][0][2].member_1 - _e1448[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1448[0][1][0].member - _e1448[1][1][0].member) - _e1520), (_e1448[0][1][0].member_1 - _e1448[1][1][0].member_1)), type_9(((_e1448[0][1][1].member - _e1448[1][1][1].member) - _e1534), (_e1448[0][1][1].member_1 - _e1448[1][1][1].member_1)), type_9(((_e1448[0][1][2].member - _e1448[1][1][2].member) - _e1548), (_e1448[0][1][2].member_1 - _e1448[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1448[2][0][0].member - _e1448[1][0][0].member) - _e1571), (_e1448[2][0][0].member_1 - _e1448[1][0][0].member_1)), type_9(((_e1448[2][0][1].member - _e1448[1][0][1].member) - _e1585), (_e1448[2][0][1].member_1 - _e1448[1][0][1].member_1)), type_9(((_e1448[2][0][2].member - _e1448[1][0][2].member) - _e1599), (_e1448[2][0][2].member_1 - _e1448[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1448[2][1][0].member - _e1448[1][1][0].member) - _e1621), (_e1448[2][1][0].member_1 - _e1448[1][1][0].member_1)), type_9(((_e1448[2][1][1].member - _e1448[1][1][1].member) - _e1635), (_e1448[2][1][1].member_1 - _e1448[1][1][1].member_1)), type_9(((_e1448[2][1][2].member - _e1448[1][1][2].member) - _e1649), (_e1448[2][1][2].member_1 - _e1448[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1448[3][0][0].member - _e1448[1][0][0].member) - _e1672), (_e1448[3][0][0].member_1 - _e1448[1][0][0].member_1)), type_9(((_e1448[3][0][1].member - _e1448[1][0][1].member) - _e1686), (_e1448[3][0][1].member_1 - _e1448[1][0][1].member_1)), type_9(((_e1448[3][0][2].member - _e1448[1][0][2].member) - _e1700), (_e1448[3][0][2].member_1 - _e1448[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1448[3][1][0].member - _e1448[1][1][0].member) - _e1722), (_e1448[3][1][0].member_1 - _e1448[1][1][0].member_1)), type_9(((_e1448[3][1][1].member - _e1448[1][1][1].member) - _e1736), (_e1448[3][1][1].member_1 - _e1448[1][1][1].member_1)), type_9(((_e1448[3][1][2].member - _e1448[1][1][2].member) - _e1750), (_e1448[3][1][2].member_1 - _e1448[1][1][2].member_1)))));
                        }
                        let _e2065 = phi_3255_;
                        local_48 = array<type_9, 3>(type_9(_e2065[1][0][0].member, _e2065[1][0][0].member_1), type_9(_e2065[1][0][1].member, _e2065[1][0][1].member_1), type_9(_e2065[1][0][2].member, _e2065[1][0][2].member_1));
                        local_49 = array<type_9, 3>(type_9(_e2065[2][0][0].member, _e2065[2][0][0].member_1), type_9(_e2065[2][0][1].member, _e2065[2][0][1].member_1), type_9(_e2065[2][0][2].member, _e2065[2][0][2].member_1));
                        let _e2098 = local_48[1u].member;
                        let _e2100 = local_48[1u].member_1;
                        let _e2103 = local_49[2u].member;
                        let _e2105 = local_49[2u].member_1;
                        let _e2106 = function_8(_e2098, _e2100, _e2103, _e2105);
                        let _e2111 = local_48[2u].member;
                        let _e2113 = local_48[2u].member_1;
                        let _e2116 = local_49[1u].member;
                        let _e2118 = local_49[1u].member_1;
                        let _e2119 = function_8(_e2111, _e2113, _e2116, _e2118);
                        if (_e2106.member_1 < _e2119.member_1) {
                            phi_3334_ = 1u;
                        } else {
                            phi_3334_ = 0u;
                        }
                        let _e2124 = phi_3334_;
                        let _e2126 = ((_e2106.member - _e2119.member) - _e2124);
                        let _e2127 = (_e2106.member_1 - _e2119.member_1);
                        local_46 = array<type_9, 3>(type_9(_e2065[1][0][0].member, _e2065[1][0][0].member_1), type_9(_e2065[1][0][1].member, _e2065[1][0][1].member_1), type_9(_e2065[1][0][2].member, _e2065[1][0][2].member_1));
                        local_47 = array<type_9, 3>(type_9(_e2065[2][0][0].member, _e2065[2][0][0].member_1), type_9(_e2065[2][0][1].member, _e2065[2][0][1].member_1), type_9(_e2065[2][0][2].member, _e2065[2][0][2].member_1));
                        let _e2156 = local_46[2u].member;
                        let _e2158 = local_46[2u].member_1;
                        let _e2161 = local_47[0u].member;
                        let _e2163 = local_47[0u].member_1;
                        let _e2164 = function_8(_e2156, _e2158, _e2161, _e2163);
                        let _e2169 = local_46[0u].member;
                        let _e2171 = local_46[0u].member_1;
                        let _e2174 = local_47[2u].member;
                        let _e2176 = local_47[2u].member_1;
                        let _e2177 = function_8(_e2169, _e2171, _e2174, _e2176);
                        if (_e2164.member_1 < _e2177.member_1) {
                            phi_3414_ = 1u;
                        } else {
                            phi_3414_ = 0u;
                        }
                        let _e2182 = phi_3414_;
                        let _e2184 = ((_e2164.member - _e2177.member) - _e2182);
                        let _e2185 = (_e2164.member_1 - _e2177.member_1);
                        local_44 = array<type_9, 3>(type_9(_e2065[1][0][0].member, _e2065[1][0][0].member_1), type_9(_e2065[1][0][1].member, _e2065[1][0][1].member_1), type_9(_e2065[1][0][2].member, _e2065[1][0][2].member_1));
                        local_45 = array<type_9, 3>(type_9(_e2065[2][0][0].member, _e2065[2][0][0].member_1), type_9(_e2065[2][0][1].member, _e2065[2][0][1].member_1), type_9(_e2065[2][0][2].member, _e2065[2][0][2].member_1));
                        let _e2214 = local_44[0u].member;
                        let _e2216 = local_44[0u].member_1;
                        let _e2219 = local_45[1u].member;
                        let _e2221 = local_45[1u].member_1;
                        let _e2222 = function_8(_e2214, _e2216, _e2219, _e2221);
                        let _e2227 = local_44[1u].member;
                        let _e2229 = local_44[1u].member_1;
                        let _e2232 = local_45[0u].member;
                        let _e2234 = local_45[0u].member_1;
                        let _e2235 = function_8(_e2227, _e2229, _e2232, _e2234);
                        if (_e2222.member_1 < _e2235.member_1) {
                            phi_3494_ = 1u;
                        } else {
                            phi_3494_ = 0u;
                        }
                        let _e2240 = phi_3494_;
                        let _e2242 = ((_e2222.member - _e2235.member) - _e2240);
                        let _e2243 = (_e2222.member_1 - _e2235.member_1);
                        local_42 = array<type_9, 3>(type_9(_e2065[1][1][0].member, _e2065[1][1][0].member_1), type_9(_e2065[1][1][1].member, _e2065[1][1][1].member_1), type_9(_e2065[1][1][2].member, _e2065[1][1][2].member_1));
                        local_43 = array<type_9, 3>(type_9(_e2065[2][1][0].member, _e2065[2][1][0].member_1), type_9(_e2065[2][1][1].member, _e2065[2][1][1].member_1), type_9(_e2065[2][1][2].member, _e2065[2][1][2].member_1));
                        let _e2276 = local_42[1u].member;
                        let _e2278 = local_42[1u].member_1;
                        let _e2281 = local_43[2u].member;
                        let _e2283 = local_43[2u].member_1;
                        let _e2284 = function_8(_e2276, _e2278, _e2281, _e2283);
                        let _e2289 = local_42[2u].member;
                        let _e2291 = local_42[2u].member_1;
                        let _e2294 = local_43[1u].member;
                        let _e2296 = local_43[1u].member_1;
                        let _e2297 = function_8(_e2289, _e2291, _e2294, _e2296);
                        if (_e2284.member_1 < _e2297.member_1) {
                            phi_3582_ = 1u;
                        } else {
                            phi_3582_ = 0u;
                        }
                        let _e2302 = phi_3582_;
                        let _e2304 = ((_e2284.member - _e2297.member) - _e2302);
                        let _e2305 = (_e2284.member_1 - _e2297.member_1);
                        local_40 = array<type_9, 3>(type_9(_e2065[1][1][0].member, _e2065[1][1][0].member_1), type_9(_e2065[1][1][1].member, _e2065[1][1][1].member_1), type_9(_e2065[1][1][2].member, _e2065[1][1][2].member_1));
                        local_41 = array<type_9, 3>(type_9(_e2065[2][1][0].member, _e2065[2][1][0].member_1), type_9(_e2065[2][1][1].member, _e2065[2][1][1].member_1), type_9(_e2065[2][1][2].member, _e2065[2][1][2].member_1));
                        let _e2334 = local_40[2u].member;
                        let _e2336 = local_40[2u].member_1;
                        let _e2339 = local_41[0u].member;
                        let _e2341 = local_41[0u].member_1;
                        let _e2342 = function_8(_e2334, _e2336, _e2339, _e2341);
                        let _e2347 = local_40[0u].member;
                        let _e2349 = local_40[0u].member_1;
                        let _e2352 = local_41[2u].member;
                        let _e2354 = local_41[2u].member_1;
                        let _e2355 = function_8(_e2347, _e2349, _e2352, _e2354);
                        if (_e2342.member_1 < _e2355.member_1) {
                            phi_3662_ = 1u;
                        } else {
                            phi_3662_ = 0u;
                        }
                        let _e2360 = phi_3662_;
                        let _e2362 = ((_e2342.member - _e2355.member) - _e2360);
                        let _e2363 = (_e2342.member_1 - _e2355.member_1);
                        local_38 = array<type_9, 3>(type_9(_e2065[1][1][0].member, _e2065[1][1][0].member_1), type_9(_e2065[1][1][1].member, _e2065[1][1][1].member_1), type_9(_e2065[1][1][2].member, _e2065[1][1][2].member_1));
                        local_39 = array<type_9, 3>(type_9(_e2065[2][1][0].member, _e2065[2][1][0].member_1), type_9(_e2065[2][1][1].member, _e2065[2][1][1].member_1), type_9(_e2065[2][1][2].member, _e2065[2][1][2].member_1));
                        let _e2392 = local_38[0u].member;
                        let _e2394 = local_38[0u].member_1;
                        let _e2397 = local_39[1u].member;
                        let _e2399 = local_39[1u].member_1;
                        let _e2400 = function_8(_e2392, _e2394, _e2397, _e2399);
                        let _e2405 = local_38[1u].member;
                        let _e2407 = local_38[1u].member_1;
                        let _e2410 = local_39[0u].member;
                        let _e2412 = local_39[0u].member_1;
                        let _e2413 = function_8(_e2405, _e2407, _e2410, _e2412);
                        if (_e2400.member_1 < _e2413.member_1) {
                            phi_3742_ = 1u;
                        } else {
                            phi_3742_ = 0u;
                        }
                        let _e2418 = phi_3742_;
                        let _e2420 = ((_e2400.member - _e2413.member) - _e2418);
                        let _e2421 = (_e2400.member_1 - _e2413.member_1);
                        local_36 = array<type_9, 3>(type_9(_e2065[1][0][0].member, _e2065[1][0][0].member_1), type_9(_e2065[1][0][1].member, _e2065[1][0][1].member_1), type_9(_e2065[1][0][2].member, _e2065[1][0][2].member_1));
                        local_37 = array<type_9, 3>(type_9(_e2065[2][1][0].member, _e2065[2][1][0].member_1), type_9(_e2065[2][1][1].member, _e2065[2][1][1].member_1), type_9(_e2065[2][1][2].member, _e2065[2][1][2].member_1));
                        let _e2454 = local_36[1u].member;
                        let _e2456 = local_36[1u].member_1;
                        let _e2459 = local_37[2u].member;
                        let _e2461 = local_37[2u].member_1;
                        let _e2462 = function_8(_e2454, _e2456, _e2459, _e2461);
                        let _e2467 = local_36[2u].member;
                        let _e2469 = local_36[2u].member_1;
                        let _e2472 = local_37[1u].member;
                        let _e2474 = local_37[1u].member_1;
                        let _e2475 = function_8(_e2467, _e2469, _e2472, _e2474);
                        if (_e2462.member_1 < _e2475.member_1) {
                            phi_3830_ = 1u;
                        } else {
                            phi_3830_ = 0u;
                        }
                        let _e2480 = phi_3830_;
                        let _e2483 = (_e2462.member_1 - _e2475.member_1);
                        local_34 = array<type_9, 3>(type_9(_e2065[1][0][0].member, _e2065[1][0][0].member_1), type_9(_e2065[1][0][1].member, _e2065[1][0][1].member_1), type_9(_e2065[1][0][2].member, _e2065[1][0][2].member_1));
                        local_35 = array<type_9, 3>(type_9(_e2065[2][1][0].member, _e2065[2][1][0].member_1), type_9(_e2065[2][1][1].member, _e2065[2][1][1].member_1), type_9(_e2065[2][1][2].member, _e2065[2][1][2].member_1));
                        let _e2512 = local_34[2u].member;
                        let _e2514 = local_34[2u].member_1;
                        let _e2517 = local_35[0u].member;
                        let _e2519 = local_35[0u].member_1;
                        let _e2520 = function_8(_e2512, _e2514, _e2517, _e2519);
                        let _e2525 = local_34[0u].member;
                        let _e2527 = local_34[0u].member_1;
                        let _e2530 = local_35[2u].member;
                        let _e2532 = local_35[2u].member_1;
                        let _e2533 = function_8(_e2525, _e2527, _e2530, _e2532);
                        if (_e2520.member_1 < _e2533.member_1) {
                            phi_3910_ = 1u;
                        } else {
                            phi_3910_ = 0u;
                        }
                        let _e2538 = phi_3910_;
                        let _e2541 = (_e2520.member_1 - _e2533.member_1);
                        local_32 = array<type_9, 3>(type_9(_e2065[1][0][0].member, _e2065[1][0][0].member_1), type_9(_e2065[1][0][1].member, _e2065[1][0][1].member_1), type_9(_e2065[1][0][2].member, _e2065[1][0][2].member_1));
                        local_33 = array<type_9, 3>(type_9(_e2065[2][1][0].member, _e2065[2][1][0].member_1), type_9(_e2065[2][1][1].member, _e2065[2][1][1].member_1), type_9(_e2065[2][1][2].member, _e2065[2][1][2].member_1));
                        let _e2570 = local_32[0u].member;
                        let _e2572 = local_32[0u].member_1;
                        let _e2575 = local_33[1u].member;
                        let _e2577 = local_33[1u].member_1;
                        let _e2578 = function_8(_e2570, _e2572, _e2575, _e2577);
                        let _e2583 = local_32[1u].member;
                        let _e2585 = local_32[1u].member_1;
                        let _e2588 = local_33[0u].member;
                        let _e2590 = local_33[0u].member_1;
                        let _e2591 = function_8(_e2583, _e2585, _e2588, _e2590);
                        if (_e2578.member_1 < _e2591.member_1) {
                            phi_3990_ = 1u;
                        } else {
                            phi_3990_ = 0u;
                        }
                        let _e2596 = phi_3990_;
                        let _e2599 = (_e2578.member_1 - _e2591.member_1);
                        local_30 = array<type_9, 3>(type_9(_e2065[1][1][0].member, _e2065[1][1][0].member_1), type_9(_e2065[1][1][1].member, _e2065[1][1][1].member_1), type_9(_e2065[1][1][2].member, _e2065[1][1][2].member_1));
                        local_31 = array<type_9, 3>(type_9(_e2065[2][0][0].member, _e2065[2][0][0].member_1), type_9(_e2065[2][0][1].member, _e2065[2][0][1].member_1), type_9(_e2065[2][0][2].member, _e2065[2][0][2].member_1));
                        let _e2632 = local_30[1u].member;
                        let _e2634 = local_30[1u].member_1;
                        let _e2637 = local_31[2u].member;
                        let _e2639 = local_31[2u].member_1;
                        let _e2640 = function_8(_e2632, _e2634, _e2637, _e2639);
                        let _e2645 = local_30[2u].member;
                        let _e2647 = local_30[2u].member_1;
                        let _e2650 = local_31[1u].member;
                        let _e2652 = local_31[1u].member_1;
                        let _e2653 = function_8(_e2645, _e2647, _e2650, _e2652);
                        if (_e2640.member_1 < _e2653.member_1) {
                            phi_4078_ = 1u;
                        } else {
                            phi_4078_ = 0u;
                        }
                        let _e2658 = phi_4078_;
                        local_28 = array<type_9, 3>(type_9(_e2065[1][1][0].member, _e2065[1][1][0].member_1), type_9(_e2065[1][1][1].member, _e2065[1][1][1].member_1), type_9(_e2065[1][1][2].member, _e2065[1][1][2].member_1));
                        local_29 = array<type_9, 3>(type_9(_e2065[2][0][0].member, _e2065[2][0][0].member_1), type_9(_e2065[2][0][1].member, _e2065[2][0][1].member_1), type_9(_e2065[2][0][2].member, _e2065[2][0][2].member_1));
                        let _e2690 = local_28[2u].member;
                        let _e2692 = local_28[2u].member_1;
                        let _e2695 = local_29[0u].member;
                        let _e2697 = local_29[0u].member_1;
                        let _e2698 = function_8(_e2690, _e2692, _e2695, _e2697);
                        let _e2703 = local_28[0u].member;
                        let _e2705 = local_28[0u].member_1;
                        let _e2708 = local_29[2u].member;
                        let _e2710 = local_29[2u].member_1;
                        let _e2711 = function_8(_e2703, _e2705, _e2708, _e2710);
                        if (_e2698.member_1 < _e2711.member_1) {
                            phi_4158_ = 1u;
                        } else {
                            phi_4158_ = 0u;
                        }
                        let _e2716 = phi_4158_;
                        local_26 = array<type_9, 3>(type_9(_e2065[1][1][0].member, _e2065[1][1][0].member_1), type_9(_e2065[1][1][1].member, _e2065[1][1][1].member_1), type_9(_e2065[1][1][2].member, _e2065[1][1][2].member_1));
                        local_27 = array<type_9, 3>(type_9(_e2065[2][0][0].member, _e2065[2][0][0].member_1), type_9(_e2065[2][0][1].member, _e2065[2][0][1].member_1), type_9(_e2065[2][0][2].member, _e2065[2][0][2].member_1));
                        let _e2748 = local_26[0u].member;
                        let _e2750 = local_26[0u].member_1;
                        let _e2753 = local_27[1u].member;
                        let _e2755 = local_27[1u].member_1;
                        let _e2756 = function_8(_e2748, _e2750, _e2753, _e2755);
                        let _e2761 = local_26[1u].member;
                        let _e2763 = local_26[1u].member_1;
                        let _e2766 = local_27[0u].member;
                        let _e2768 = local_27[0u].member_1;
                        let _e2769 = function_8(_e2761, _e2763, _e2766, _e2768);
                        if (_e2756.member_1 < _e2769.member_1) {
                            phi_4238_ = 1u;
                        } else {
                            phi_4238_ = 0u;
                        }
                        let _e2774 = phi_4238_;
                        let _e2778 = (_e2483 + (_e2640.member_1 - _e2653.member_1));
                        if (_e2778 < _e2483) {
                            phi_4257_ = 1u;
                        } else {
                            phi_4257_ = 0u;
                        }
                        let _e2781 = phi_4257_;
                        let _e2783 = ((((_e2462.member - _e2475.member) - _e2480) + ((_e2640.member - _e2653.member) - _e2658)) + _e2781);
                        let _e2784 = (_e2541 + (_e2698.member_1 - _e2711.member_1));
                        if (_e2784 < _e2541) {
                            phi_4269_ = 1u;
                        } else {
                            phi_4269_ = 0u;
                        }
                        let _e2787 = phi_4269_;
                        let _e2789 = ((((_e2520.member - _e2533.member) - _e2538) + ((_e2698.member - _e2711.member) - _e2716)) + _e2787);
                        let _e2790 = (_e2599 + (_e2756.member_1 - _e2769.member_1));
                        if (_e2790 < _e2599) {
                            phi_4281_ = 1u;
                        } else {
                            phi_4281_ = 0u;
                        }
                        let _e2793 = phi_4281_;
                        let _e2795 = ((((_e2578.member - _e2591.member) - _e2596) + ((_e2756.member - _e2769.member) - _e2774)) + _e2793);
                        let _e2802 = function_8(_e2065[0][0][0].member, _e2065[0][0][0].member_1, _e2126, _e2127);
                        let _e2809 = function_8(_e2065[0][0][1].member, _e2065[0][0][1].member_1, _e2184, _e2185);
                        let _e2812 = (_e2802.member_1 + _e2809.member_1);
                        if (_e2812 < _e2802.member_1) {
                            phi_4310_ = 1u;
                        } else {
                            phi_4310_ = 0u;
                        }
                        let _e2815 = phi_4310_;
                        let _e2822 = function_8(_e2065[0][0][2].member, _e2065[0][0][2].member_1, _e2242, _e2243);
                        let _e2825 = (_e2812 + _e2822.member_1);
                        if (_e2825 < _e2812) {
                            phi_4325_ = 1u;
                        } else {
                            phi_4325_ = 0u;
                        }
                        let _e2828 = phi_4325_;
                        let _e2831 = function_11(((((_e2802.member + _e2809.member) + _e2815) + _e2822.member) + _e2828), _e2825);
                        let _e2840 = function_8(_e2065[0][1][0].member, _e2065[0][1][0].member_1, _e2126, _e2127);
                        let _e2847 = function_8(_e2065[0][1][1].member, _e2065[0][1][1].member_1, _e2184, _e2185);
                        let _e2850 = (_e2840.member_1 + _e2847.member_1);
                        if (_e2850 < _e2840.member_1) {
                            phi_4351_ = 1u;
                        } else {
                            phi_4351_ = 0u;
                        }
                        let _e2853 = phi_4351_;
                        let _e2860 = function_8(_e2065[0][1][2].member, _e2065[0][1][2].member_1, _e2242, _e2243);
                        let _e2863 = (_e2850 + _e2860.member_1);
                        if (_e2863 < _e2850) {
                            phi_4366_ = 1u;
                        } else {
                            phi_4366_ = 0u;
                        }
                        let _e2866 = phi_4366_;
                        let _e2875 = function_8(_e2065[0][0][0].member, _e2065[0][0][0].member_1, _e2783, _e2778);
                        let _e2882 = function_8(_e2065[0][0][1].member, _e2065[0][0][1].member_1, _e2789, _e2784);
                        let _e2885 = (_e2875.member_1 + _e2882.member_1);
                        if (_e2885 < _e2875.member_1) {
                            phi_4389_ = 1u;
                        } else {
                            phi_4389_ = 0u;
                        }
                        let _e2888 = phi_4389_;
                        let _e2895 = function_8(_e2065[0][0][2].member, _e2065[0][0][2].member_1, _e2795, _e2790);
                        let _e2898 = (_e2885 + _e2895.member_1);
                        if (_e2898 < _e2885) {
                            phi_4404_ = 1u;
                        } else {
                            phi_4404_ = 0u;
                        }
                        let _e2901 = phi_4404_;
                        let _e2904 = (_e2863 + _e2898);
                        if (_e2904 < _e2863) {
                            phi_4412_ = 1u;
                        } else {
                            phi_4412_ = 0u;
                        }
                        let _e2907 = phi_4412_;
                        let _e2909 = ((((((_e2840.member + _e2847.member) + _e2853) + _e2860.member) + _e2866) + ((((_e2875.member + _e2882.member) + _e2888) + _e2895.member) + _e2901)) + _e2907);
                        let _e2916 = function_8(_e2065[0][0][0].member, _e2065[0][0][0].member_1, _e2304, _e2305);
                        let _e2923 = function_8(_e2065[0][0][1].member, _e2065[0][0][1].member_1, _e2362, _e2363);
                        let _e2926 = (_e2916.member_1 + _e2923.member_1);
                        if (_e2926 < _e2916.member_1) {
                            phi_4435_ = 1u;
                        } else {
                            phi_4435_ = 0u;
                        }
                        let _e2929 = phi_4435_;
                        let _e2936 = function_8(_e2065[0][0][2].member, _e2065[0][0][2].member_1, _e2420, _e2421);
                        let _e2939 = (_e2926 + _e2936.member_1);
                        if (_e2939 < _e2926) {
                            phi_4450_ = 1u;
                        } else {
                            phi_4450_ = 0u;
                        }
                        let _e2942 = phi_4450_;
                        let _e2951 = function_8(_e2065[0][1][0].member, _e2065[0][1][0].member_1, _e2783, _e2778);
                        let _e2958 = function_8(_e2065[0][1][1].member, _e2065[0][1][1].member_1, _e2789, _e2784);
                        let _e2961 = (_e2951.member_1 + _e2958.member_1);
                        if (_e2961 < _e2951.member_1) {
                            phi_4473_ = 1u;
                        } else {
                            phi_4473_ = 0u;
                        }
                        let _e2964 = phi_4473_;
                        let _e2971 = function_8(_e2065[0][1][2].member, _e2065[0][1][2].member_1, _e2795, _e2790);
                        let _e2974 = (_e2961 + _e2971.member_1);
                        if (_e2974 < _e2961) {
                            phi_4488_ = 1u;
                        } else {
                            phi_4488_ = 0u;
                        }
                        let _e2977 = phi_4488_;
                        let _e2980 = (_e2939 + _e2974);
                        if (_e2980 < _e2939) {
                            phi_4496_ = 1u;
                        } else {
                            phi_4496_ = 0u;
                        }
                        let _e2983 = phi_4496_;
                        let _e2985 = ((((((_e2916.member + _e2923.member) + _e2929) + _e2936.member) + _e2942) + ((((_e2951.member + _e2958.member) + _e2964) + _e2971.member) + _e2977)) + _e2983);
                        let _e2992 = function_8(_e2065[0][1][0].member, _e2065[0][1][0].member_1, _e2304, _e2305);
                        let _e2999 = function_8(_e2065[0][1][1].member, _e2065[0][1][1].member_1, _e2362, _e2363);
                        let _e3002 = (_e2992.member_1 + _e2999.member_1);
                        if (_e3002 < _e2992.member_1) {
                            phi_4519_ = 1u;
                        } else {
                            phi_4519_ = 0u;
                        }
                        let _e3005 = phi_4519_;
                        let _e3012 = function_8(_e2065[0][1][2].member, _e2065[0][1][2].member_1, _e2420, _e2421);
                        let _e3015 = (_e3002 + _e3012.member_1);
                        if (_e3015 < _e3002) {
                            phi_4534_ = 1u;
                        } else {
                            phi_4534_ = 0u;
                        }
                        let _e3018 = phi_4534_;
                        let _e3021 = function_11(((((_e2992.member + _e2999.member) + _e3005) + _e3012.member) + _e3018), _e3015);
                        phi_4550_ = type_9(0u, 128u);
                        phi_4553_ = array<type_9, 4>(_e2831, type_9(_e2909, _e2904), type_9(_e2985, _e2980), type_9(_e3021.member, _e3021.member_1));
                        phi_4557_ = 0u;
                        phi_4559_ = 0u;
                        loop {
                            let _e3029 = phi_4550_;
                            let _e3031 = phi_4553_;
                            let _e3033 = phi_4557_;
                            let _e3035 = phi_4559_;
                            local_65 = _e3031;
                            local_66 = _e3031;
                            local_67 = _e3031;
                            if (_e3029.member < _e3029.member_1) {
                                phi_4551_ = type_9((_e3029.member + 1u), _e3029.member_1);
                                phi_4582_ = type_9(1u, _e3029.member);
                            } else {
                                phi_4551_ = _e3029;
                                phi_4582_ = type_9(0u, type_9().member_1);
                            }
                            let _e3047 = phi_4551_;
                            let _e3049 = phi_4582_;
                            if (bitcast<i32>(_e3049.member) != 0i) {
                                let _e3053 = (31u - _e3033);
                                let _e3056 = (_e3035 << bitcast<u32>((_e3053 & 31u)));
                                let _e3061 = (_e3056 > _e1452);
                                if _e3061 {
                                    phi_7254_ = array<type_9, 4>();
                                    phi_7256_ = u32();
                                    phi_7257_ = u32();
                                    phi_7258_ = bool();
                                    phi_7259_ = bool();
                                    phi_7260_ = u32();
                                    phi_7261_ = u32();
                                    phi_7262_ = false;
                                    phi_7263_ = false;
                                    phi_7264_ = false;
                                } else {
                                    if (((_e3035 + 1u) << bitcast<u32>((_e3053 & 31u))) < _e1450) {
                                        phi_4779_ = true;
                                    } else {
                                        let _e3067 = function_10(128u);
                                        if ((_e3031[0].member >> bitcast<u32>(31i)) != 0u) {
                                            if (_e3031[0].member_1 == 0u) {
                                                phi_4617_ = 1u;
                                            } else {
                                                phi_4617_ = 0u;
                                            }
                                            let _e3076 = phi_4617_;
                                            phi_4624_ = type_9((~(_e3031[0].member) + _e3076), (~(_e3031[0].member_1) + 1u));
                                        } else {
                                            phi_4624_ = _e3031[0];
                                        }
                                        let _e3083 = phi_4624_;
                                        if (_e3067.member_1 < _e3083.member_1) {
                                            phi_4631_ = 1u;
                                        } else {
                                            phi_4631_ = 0u;
                                        }
                                        let _e3088 = phi_4631_;
                                        if ((((_e3067.member - _e3083.member) - _e3088) >> bitcast<u32>(31i)) != 0u) {
                                            if ((_e3031[0].member >> bitcast<u32>(31i)) != 0u) {
                                                phi_4644_ = 2u;
                                            } else {
                                                phi_4644_ = 1u;
                                            }
                                            let _e3098 = phi_4644_;
                                            phi_4645_ = _e3098;
                                        } else {
                                            phi_4645_ = 0u;
                                        }
                                        let _e3100 = phi_4645_;
                                        let _e3105 = function_10(128u);
                                        if ((_e3031[1].member >> bitcast<u32>(31i)) != 0u) {
                                            if (_e3031[1].member_1 == 0u) {
                                                phi_4660_ = 1u;
                                            } else {
                                                phi_4660_ = 0u;
                                            }
                                            let _e3114 = phi_4660_;
                                            phi_4667_ = type_9((~(_e3031[1].member) + _e3114), (~(_e3031[1].member_1) + 1u));
                                        } else {
                                            phi_4667_ = _e3031[1];
                                        }
                                        let _e3121 = phi_4667_;
                                        if (_e3105.member_1 < _e3121.member_1) {
                                            phi_4674_ = 1u;
                                        } else {
                                            phi_4674_ = 0u;
                                        }
                                        let _e3126 = phi_4674_;
                                        if ((((_e3105.member - _e3121.member) - _e3126) >> bitcast<u32>(31i)) != 0u) {
                                            if ((_e3031[1].member >> bitcast<u32>(31i)) != 0u) {
                                                phi_4687_ = 2u;
                                            } else {
                                                phi_4687_ = 1u;
                                            }
                                            let _e3136 = phi_4687_;
                                            phi_4688_ = _e3136;
                                        } else {
                                            phi_4688_ = 0u;
                                        }
                                        let _e3138 = phi_4688_;
                                        let _e3144 = function_10(128u);
                                        if ((_e3031[2].member >> bitcast<u32>(31i)) != 0u) {
                                            if (_e3031[2].member_1 == 0u) {
                                                phi_4704_ = 1u;
                                            } else {
                                                phi_4704_ = 0u;
                                            }
                                            let _e3153 = phi_4704_;
                                            phi_4711_ = type_9((~(_e3031[2].member) + _e3153), (~(_e3031[2].member_1) + 1u));
                                        } else {
                                            phi_4711_ = _e3031[2];
                                        }
                                        let _e3160 = phi_4711_;
                                        if (_e3144.member_1 < _e3160.member_1) {
                                            phi_4718_ = 1u;
                                        } else {
                                            phi_4718_ = 0u;
                                        }
                                        let _e3165 = phi_4718_;
                                        if ((((_e3144.member - _e3160.member) - _e3165) >> bitcast<u32>(31i)) != 0u) {
                                            if ((_e3031[2].member >> bitcast<u32>(31i)) != 0u) {
                                                phi_4731_ = 2u;
                                            } else {
                                                phi_4731_ = 1u;
                                            }
                                            let _e3175 = phi_4731_;
                                            phi_4732_ = _e3175;
                                        } else {
                                            phi_4732_ = 0u;
                                        }
                                        let _e3177 = phi_4732_;
                                        let _e3183 = function_10(128u);
                                        if ((_e3031[3].member >> bitcast<u32>(31i)) != 0u) {
                                            if (_e3031[3].member_1 == 0u) {
                                                phi_4748_ = 1u;
                                            } else {
                                                phi_4748_ = 0u;
                                            }
                                            let _e3192 = phi_4748_;
                                            phi_4755_ = type_9((~(_e3031[3].member) + _e3192), (~(_e3031[3].member_1) + 1u));
                                        } else {
                                            phi_4755_ = _e3031[3];
                                        }
                                        let _e3199 = phi_4755_;
                                        if (_e3183.member_1 < _e3199.member_1) {
                                            phi_4762_ = 1u;
                                        } else {
                                            phi_4762_ = 0u;
                                        }
                                        let _e3204 = phi_4762_;
                                        if ((((_e3183.member - _e3199.member) - _e3204) >> bitcast<u32>(31i)) != 0u) {
                                            if ((_e3031[3].member >> bitcast<u32>(31i)) != 0u) {
                                                phi_4775_ = 2u;
                                            } else {
                                                phi_4775_ = 1u;
                                            }
                                            let _e3214 = phi_4775_;
                                            phi_4776_ = _e3214;
                                        } else {
                                            phi_4776_ = 0u;
                                        }
                                        let _e3216 = phi_4776_;
                                        phi_4779_ = ((((_e3100 & _e3138) & _e3177) & _e3216) != 0u);
                                    }
                                    let _e3220 = phi_4779_;
                                    if _e3220 {
                                        phi_6935_ = _e3031;
                                        phi_6937_ = _e3220;
                                        phi_6938_ = _e3033;
                                        phi_6939_ = _e3035;
                                        phi_6940_ = bool();
                                        phi_6941_ = bool();
                                        phi_6942_ = u32();
                                        phi_6943_ = u32();
                                        phi_6944_ = true;
                                    } else {
                                        let _e3221 = (_e3033 == 31u);
                                        if _e3221 {
                                            phi_4791_ = true;
                                        } else {
                                            phi_4791_ = (_e3033 == 3u);
                                        }
                                        let _e3224 = phi_4791_;
                                        if _e3224 {
                                            let _e3229 = function_10(128u);
                                            if ((_e3031[0].member >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3031[0].member_1 == 0u) {
                                                    phi_4809_ = 1u;
                                                } else {
                                                    phi_4809_ = 0u;
                                                }
                                                let _e3238 = phi_4809_;
                                                phi_4816_ = type_9((~(_e3031[0].member) + _e3238), (~(_e3031[0].member_1) + 1u));
                                            } else {
                                                phi_4816_ = _e3031[0];
                                            }
                                            let _e3245 = phi_4816_;
                                            if (_e3229.member_1 < _e3245.member_1) {
                                                phi_4823_ = 1u;
                                            } else {
                                                phi_4823_ = 0u;
                                            }
                                            let _e3250 = phi_4823_;
                                            if ((((_e3229.member - _e3245.member) - _e3250) >> bitcast<u32>(31i)) != 0u) {
                                                if ((_e3031[0].member >> bitcast<u32>(31i)) != 0u) {
                                                    phi_4836_ = 2u;
                                                } else {
                                                    phi_4836_ = 1u;
                                                }
                                                let _e3260 = phi_4836_;
                                                phi_4837_ = _e3260;
                                            } else {
                                                phi_4837_ = 0u;
                                            }
                                            let _e3262 = phi_4837_;
                                            let _e3267 = function_10(128u);
                                            if ((_e3031[3].member >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3031[3].member_1 == 0u) {
                                                    phi_4852_ = 1u;
                                                } else {
                                                    phi_4852_ = 0u;
                                                }
                                                let _e3276 = phi_4852_;
                                                phi_4859_ = type_9((~(_e3031[3].member) + _e3276), (~(_e3031[3].member_1) + 1u));
                                            } else {
                                                phi_4859_ = _e3031[3];
                                            }
                                            let _e3283 = phi_4859_;
                                            if (_e3267.member_1 < _e3283.member_1) {
                                                phi_4866_ = 1u;
                                            } else {
                                                phi_4866_ = 0u;
                                            }
                                            let _e3288 = phi_4866_;
                                            if ((((_e3267.member - _e3283.member) - _e3288) >> bitcast<u32>(31i)) != 0u) {
                                                if ((_e3031[3].member >> bitcast<u32>(31i)) != 0u) {
                                                    phi_4879_ = 2u;
                                                } else {
                                                    phi_4879_ = 1u;
                                                }
                                                let _e3298 = phi_4879_;
                                                phi_4880_ = _e3298;
                                            } else {
                                                phi_4880_ = 0u;
                                            }
                                            let _e3300 = phi_4880_;
                                            let _e3302 = ((_e3262 | _e3300) == 3u);
                                            if _e3221 {
                                                phi_4887_ = !(_e3302);
                                            } else {
                                                phi_4887_ = false;
                                            }
                                            let _e3305 = phi_4887_;
                                            if _e3305 {
                                                phi_4895_ = select((bitcast<u32>(31i) - firstLeadingBit(_e1454)), 32u, (_e1454 == 0u));
                                            } else {
                                                phi_4895_ = _e3033;
                                            }
                                            let _e3312 = phi_4895_;
                                            if (_e2065[0][1][0].member_1 < _e2065[0][0][0].member_1) {
                                                phi_4913_ = 1u;
                                            } else {
                                                phi_4913_ = 0u;
                                            }
                                            let _e3333 = phi_4913_;
                                            let _e3335 = ((_e2065[0][1][0].member - _e2065[0][0][0].member) - _e3333);
                                            let _e3336 = (_e2065[0][1][0].member_1 - _e2065[0][0][0].member_1);
                                            if (_e2065[0][1][1].member_1 < _e2065[0][0][1].member_1) {
                                                phi_4925_ = 1u;
                                            } else {
                                                phi_4925_ = 0u;
                                            }
                                            let _e3347 = phi_4925_;
                                            let _e3349 = ((_e2065[0][1][1].member - _e2065[0][0][1].member) - _e3347);
                                            let _e3350 = (_e2065[0][1][1].member_1 - _e2065[0][0][1].member_1);
                                            if (_e2065[0][1][2].member_1 < _e2065[0][0][2].member_1) {
                                                phi_4937_ = 1u;
                                            } else {
                                                phi_4937_ = 0u;
                                            }
                                            let _e3361 = phi_4937_;
                                            let _e3363 = ((_e2065[0][1][2].member - _e2065[0][0][2].member) - _e3361);
                                            let _e3364 = (_e2065[0][1][2].member_1 - _e2065[0][0][2].member_1);
                                            if ((_e3335 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3336 == 0u) {
                                                    phi_4958_ = 1u;
                                                } else {
                                                    phi_4958_ = 0u;
                                                }
                                                let _e3371 = phi_4958_;
                                                phi_4965_ = type_9((~(_e3335) + _e3371), (~(_e3336) + 1u));
                                            } else {
                                                phi_4965_ = type_9(_e3335, _e3336);
                                            }
                                            let _e3378 = phi_4965_;
                                            if ((_e3349 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3350 == 0u) {
                                                    phi_4979_ = 1u;
                                                } else {
                                                    phi_4979_ = 0u;
                                                }
                                                let _e3387 = phi_4979_;
                                                phi_4986_ = type_9((~(_e3349) + _e3387), (~(_e3350) + 1u));
                                            } else {
                                                phi_4986_ = type_9(_e3349, _e3350);
                                            }
                                            let _e3394 = phi_4986_;
                                            if (_e3394.member_1 < _e3378.member_1) {
                                                phi_4993_ = 1u;
                                            } else {
                                                phi_4993_ = 0u;
                                            }
                                            let _e3399 = phi_4993_;
                                            if ((((_e3394.member - _e3378.member) - _e3399) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5003_ = _e3378;
                                            } else {
                                                phi_5003_ = _e3394;
                                            }
                                            let _e3406 = phi_5003_;
                                            if ((_e3363 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3364 == 0u) {
                                                    phi_5017_ = 1u;
                                                } else {
                                                    phi_5017_ = 0u;
                                                }
                                                let _e3415 = phi_5017_;
                                                phi_5024_ = type_9((~(_e3363) + _e3415), (~(_e3364) + 1u));
                                            } else {
                                                phi_5024_ = type_9(_e3363, _e3364);
                                            }
                                            let _e3422 = phi_5024_;
                                            if (_e3422.member_1 < _e3406.member_1) {
                                                phi_5031_ = 1u;
                                            } else {
                                                phi_5031_ = 0u;
                                            }
                                            let _e3427 = phi_5031_;
                                            if ((((_e3422.member - _e3406.member) - _e3427) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5041_ = _e3406;
                                            } else {
                                                phi_5041_ = _e3422;
                                            }
                                            let _e3434 = phi_5041_;
                                            let _e3437 = function_10(4u);
                                            let _e3440 = (_e3434.member_1 + _e3437.member_1);
                                            if (_e3440 < _e3434.member_1) {
                                                phi_5052_ = 1u;
                                            } else {
                                                phi_5052_ = 0u;
                                            }
                                            let _e3443 = phi_5052_;
                                            let _e3445 = ((_e3434.member + _e3437.member) + _e3443);
                                            let _e3460 = ((_e3440 >> bitcast<u32>((_e3312 & 31u))) | ((_e3445 << bitcast<u32>(((31u - _e3312) & 31u))) << bitcast<u32>(1i)));
                                            let _e3461 = function_10(4u);
                                            let _e3464 = (_e3460 + _e3461.member_1);
                                            if (_e3464 < _e3460) {
                                                phi_5074_ = 1u;
                                            } else {
                                                phi_5074_ = 0u;
                                            }
                                            let _e3467 = phi_5074_;
                                            if (_e2065[1][1][0].member_1 < _e2065[1][0][0].member_1) {
                                                phi_5087_ = 1u;
                                            } else {
                                                phi_5087_ = 0u;
                                            }
                                            let _e3482 = phi_5087_;
                                            let _e3484 = ((_e2065[1][1][0].member - _e2065[1][0][0].member) - _e3482);
                                            let _e3485 = (_e2065[1][1][0].member_1 - _e2065[1][0][0].member_1);
                                            if (_e2065[1][1][1].member_1 < _e2065[1][0][1].member_1) {
                                                phi_5099_ = 1u;
                                            } else {
                                                phi_5099_ = 0u;
                                            }
                                            let _e3496 = phi_5099_;
                                            let _e3498 = ((_e2065[1][1][1].member - _e2065[1][0][1].member) - _e3496);
                                            let _e3499 = (_e2065[1][1][1].member_1 - _e2065[1][0][1].member_1);
                                            if (_e2065[1][1][2].member_1 < _e2065[1][0][2].member_1) {
                                                phi_5111_ = 1u;
                                            } else {
                                                phi_5111_ = 0u;
                                            }
                                            let _e3510 = phi_5111_;
                                            let _e3512 = ((_e2065[1][1][2].member - _e2065[1][0][2].member) - _e3510);
                                            let _e3513 = (_e2065[1][1][2].member_1 - _e2065[1][0][2].member_1);
                                            if ((_e3484 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3485 == 0u) {
                                                    phi_5132_ = 1u;
                                                } else {
                                                    phi_5132_ = 0u;
                                                }
                                                let _e3520 = phi_5132_;
                                                phi_5139_ = type_9((~(_e3484) + _e3520), (~(_e3485) + 1u));
                                            } else {
                                                phi_5139_ = type_9(_e3484, _e3485);
                                            }
                                            let _e3527 = phi_5139_;
                                            if ((_e3498 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3499 == 0u) {
                                                    phi_5153_ = 1u;
                                                } else {
                                                    phi_5153_ = 0u;
                                                }
                                                let _e3536 = phi_5153_;
                                                phi_5160_ = type_9((~(_e3498) + _e3536), (~(_e3499) + 1u));
                                            } else {
                                                phi_5160_ = type_9(_e3498, _e3499);
                                            }
                                            let _e3543 = phi_5160_;
                                            if (_e3543.member_1 < _e3527.member_1) {
                                                phi_5167_ = 1u;
                                            } else {
                                                phi_5167_ = 0u;
                                            }
                                            let _e3548 = phi_5167_;
                                            if ((((_e3543.member - _e3527.member) - _e3548) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5177_ = _e3527;
                                            } else {
                                                phi_5177_ = _e3543;
                                            }
                                            let _e3555 = phi_5177_;
                                            if ((_e3512 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3513 == 0u) {
                                                    phi_5191_ = 1u;
                                                } else {
                                                    phi_5191_ = 0u;
                                                }
                                                let _e3564 = phi_5191_;
                                                phi_5198_ = type_9((~(_e3512) + _e3564), (~(_e3513) + 1u));
                                            } else {
                                                phi_5198_ = type_9(_e3512, _e3513);
                                            }
                                            let _e3571 = phi_5198_;
                                            if (_e3571.member_1 < _e3555.member_1) {
                                                phi_5205_ = 1u;
                                            } else {
                                                phi_5205_ = 0u;
                                            }
                                            let _e3576 = phi_5205_;
                                            if ((((_e3571.member - _e3555.member) - _e3576) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5215_ = _e3555;
                                            } else {
                                                phi_5215_ = _e3571;
                                            }
                                            let _e3583 = phi_5215_;
                                            let _e3586 = function_10(4u);
                                            let _e3589 = (_e3583.member_1 + _e3586.member_1);
                                            if (_e3589 < _e3583.member_1) {
                                                phi_5226_ = 1u;
                                            } else {
                                                phi_5226_ = 0u;
                                            }
                                            let _e3592 = phi_5226_;
                                            let _e3594 = ((_e3583.member + _e3586.member) + _e3592);
                                            let _e3609 = ((_e3589 >> bitcast<u32>((_e3312 & 31u))) | ((_e3594 << bitcast<u32>(((31u - _e3312) & 31u))) << bitcast<u32>(1i)));
                                            let _e3610 = function_10(4u);
                                            let _e3613 = (_e3609 + _e3610.member_1);
                                            if (_e3613 < _e3609) {
                                                phi_5248_ = 1u;
                                            } else {
                                                phi_5248_ = 0u;
                                            }
                                            let _e3616 = phi_5248_;
                                            if (_e2065[2][1][0].member_1 < _e2065[2][0][0].member_1) {
                                                phi_5261_ = 1u;
                                            } else {
                                                phi_5261_ = 0u;
                                            }
                                            let _e3631 = phi_5261_;
                                            let _e3633 = ((_e2065[2][1][0].member - _e2065[2][0][0].member) - _e3631);
                                            let _e3634 = (_e2065[2][1][0].member_1 - _e2065[2][0][0].member_1);
                                            if (_e2065[2][1][1].member_1 < _e2065[2][0][1].member_1) {
                                                phi_5273_ = 1u;
                                            } else {
                                                phi_5273_ = 0u;
                                            }
                                            let _e3645 = phi_5273_;
                                            let _e3647 = ((_e2065[2][1][1].member - _e2065[2][0][1].member) - _e3645);
                                            let _e3648 = (_e2065[2][1][1].member_1 - _e2065[2][0][1].member_1);
                                            if (_e2065[2][1][2].member_1 < _e2065[2][0][2].member_1) {
                                                phi_5285_ = 1u;
                                            } else {
                                                phi_5285_ = 0u;
                                            }
                                            let _e3659 = phi_5285_;
                                            let _e3661 = ((_e2065[2][1][2].member - _e2065[2][0][2].member) - _e3659);
                                            let _e3662 = (_e2065[2][1][2].member_1 - _e2065[2][0][2].member_1);
                                            if ((_e3633 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3634 == 0u) {
                                                    phi_5306_ = 1u;
                                                } else {
                                                    phi_5306_ = 0u;
                                                }
                                                let _e3669 = phi_5306_;
                                                phi_5313_ = type_9((~(_e3633) + _e3669), (~(_e3634) + 1u));
                                            } else {
                                                phi_5313_ = type_9(_e3633, _e3634);
                                            }
                                            let _e3676 = phi_5313_;
                                            if ((_e3647 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3648 == 0u) {
                                                    phi_5327_ = 1u;
                                                } else {
                                                    phi_5327_ = 0u;
                                                }
                                                let _e3685 = phi_5327_;
                                                phi_5334_ = type_9((~(_e3647) + _e3685), (~(_e3648) + 1u));
                                            } else {
                                                phi_5334_ = type_9(_e3647, _e3648);
                                            }
                                            let _e3692 = phi_5334_;
                                            if (_e3692.member_1 < _e3676.member_1) {
                                                phi_5341_ = 1u;
                                            } else {
                                                phi_5341_ = 0u;
                                            }
                                            let _e3697 = phi_5341_;
                                            if ((((_e3692.member - _e3676.member) - _e3697) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5351_ = _e3676;
                                            } else {
                                                phi_5351_ = _e3692;
                                            }
                                            let _e3704 = phi_5351_;
                                            if ((_e3661 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e3662 == 0u) {
                                                    phi_5365_ = 1u;
                                                } else {
                                                    phi_5365_ = 0u;
                                                }
                                                let _e3713 = phi_5365_;
                                                phi_5372_ = type_9((~(_e3661) + _e3713), (~(_e3662) + 1u));
                                            } else {
                                                phi_5372_ = type_9(_e3661, _e3662);
                                            }
                                            let _e3720 = phi_5372_;
                                            if (_e3720.member_1 < _e3704.member_1) {
                                                phi_5379_ = 1u;
                                            } else {
                                                phi_5379_ = 0u;
                                            }
                                            let _e3725 = phi_5379_;
                                            if ((((_e3720.member - _e3704.member) - _e3725) >> bitcast<u32>(31i)) != 0u) {
                                                phi_5389_ = _e3704;
                                            } else {
                                                phi_5389_ = _e3720;
                                            }
                                            let _e3732 = phi_5389_;
                                            let _e3735 = function_10(4u);
                                            let _e3738 = (_e3732.member_1 + _e3735.member_1);
                                            if (_e3738 < _e3732.member_1) {
                                                phi_5400_ = 1u;
                                            } else {
                                                phi_5400_ = 0u;
                                            }
                                            let _e3741 = phi_5400_;
                                            let _e3743 = ((_e3732.member + _e3735.member) + _e3741);
                                            let _e3758 = ((_e3738 >> bitcast<u32>((_e3312 & 31u))) | ((_e3743 << bitcast<u32>(((31u - _e3312) & 31u))) << bitcast<u32>(1i)));
                                            let _e3759 = function_10(4u);
                                            let _e3762 = (_e3758 + _e3759.member_1);
                                            if (_e3762 < _e3758) {
                                                phi_5422_ = 1u;
                                            } else {
                                                phi_5422_ = 0u;
                                            }
                                            let _e3765 = phi_5422_;
                                            local_25[0u].member = ((bitcast<u32>((bitcast<i32>(_e3445) >> bitcast<u32>((_e3312 & 31u)))) + _e3461.member) + _e3467);
                                            local_25[0u].member_1 = _e3464;
                                            local_25[1u].member = ((bitcast<u32>((bitcast<i32>(_e3594) >> bitcast<u32>((_e3312 & 31u)))) + _e3610.member) + _e3616);
                                            local_25[1u].member_1 = _e3613;
                                            local_25[2u].member = ((bitcast<u32>((bitcast<i32>(_e3743) >> bitcast<u32>((_e3312 & 31u)))) + _e3759.member) + _e3765);
                                            local_25[2u].member_1 = _e3762;
                                            if (_e2065[0][1][0].member_1 < _e2065[0][0][0].member_1) {
                                                phi_5443_ = 1u;
                                            } else {
                                                phi_5443_ = 0u;
                                            }
                                            let _e3790 = phi_5443_;
                                            let _e3794 = function_4(((_e2065[0][1][0].member - _e2065[0][0][0].member) - _e3790), (_e2065[0][1][0].member_1 - _e2065[0][0][0].member_1), _e3056);
                                            let _e3797 = (_e2065[0][0][0].member_1 + _e3794.member_1);
                                            if (_e3797 < _e2065[0][0][0].member_1) {
                                                phi_5455_ = 1u;
                                            } else {
                                                phi_5455_ = 0u;
                                            }
                                            let _e3800 = phi_5455_;
                                            let _e3802 = ((_e2065[0][0][0].member + _e3794.member) + _e3800);
                                            if (_e2065[0][1][1].member_1 < _e2065[0][0][1].member_1) {
                                                phi_5466_ = 1u;
                                            } else {
                                                phi_5466_ = 0u;
                                            }
                                            let _e3813 = phi_5466_;
                                            let _e3817 = function_4(((_e2065[0][1][1].member - _e2065[0][0][1].member) - _e3813), (_e2065[0][1][1].member_1 - _e2065[0][0][1].member_1), _e3056);
                                            let _e3820 = (_e2065[0][0][1].member_1 + _e3817.member_1);
                                            if (_e3820 < _e2065[0][0][1].member_1) {
                                                phi_5478_ = 1u;
                                            } else {
                                                phi_5478_ = 0u;
                                            }
                                            let _e3823 = phi_5478_;
                                            let _e3825 = ((_e2065[0][0][1].member + _e3817.member) + _e3823);
                                            if (_e2065[0][1][2].member_1 < _e2065[0][0][2].member_1) {
                                                phi_5489_ = 1u;
                                            } else {
                                                phi_5489_ = 0u;
                                            }
                                            let _e3836 = phi_5489_;
                                            let _e3840 = function_4(((_e2065[0][1][2].member - _e2065[0][0][2].member) - _e3836), (_e2065[0][1][2].member_1 - _e2065[0][0][2].member_1), _e3056);
                                            let _e3843 = (_e2065[0][0][2].member_1 + _e3840.member_1);
                                            if (_e3843 < _e2065[0][0][2].member_1) {
                                                phi_5501_ = 1u;
                                            } else {
                                                phi_5501_ = 0u;
                                            }
                                            let _e3846 = phi_5501_;
                                            let _e3848 = ((_e2065[0][0][2].member + _e3840.member) + _e3846);
                                            if (_e2065[1][1][0].member_1 < _e2065[1][0][0].member_1) {
                                                phi_5520_ = 1u;
                                            } else {
                                                phi_5520_ = 0u;
                                            }
                                            let _e3861 = phi_5520_;
                                            let _e3865 = function_4(((_e2065[1][1][0].member - _e2065[1][0][0].member) - _e3861), (_e2065[1][1][0].member_1 - _e2065[1][0][0].member_1), _e3056);
                                            let _e3868 = (_e2065[1][0][0].member_1 + _e3865.member_1);
                                            if (_e3868 < _e2065[1][0][0].member_1) {
                                                phi_5532_ = 1u;
                                            } else {
                                                phi_5532_ = 0u;
                                            }
                                            let _e3871 = phi_5532_;
                                            let _e3873 = ((_e2065[1][0][0].member + _e3865.member) + _e3871);
                                            if (_e2065[1][1][1].member_1 < _e2065[1][0][1].member_1) {
                                                phi_5543_ = 1u;
                                            } else {
                                                phi_5543_ = 0u;
                                            }
                                            let _e3884 = phi_5543_;
                                            let _e3888 = function_4(((_e2065[1][1][1].member - _e2065[1][0][1].member) - _e3884), (_e2065[1][1][1].member_1 - _e2065[1][0][1].member_1), _e3056);
                                            let _e3891 = (_e2065[1][0][1].member_1 + _e3888.member_1);
                                            if (_e3891 < _e2065[1][0][1].member_1) {
                                                phi_5555_ = 1u;
                                            } else {
                                                phi_5555_ = 0u;
                                            }
                                            let _e3894 = phi_5555_;
                                            let _e3896 = ((_e2065[1][0][1].member + _e3888.member) + _e3894);
                                            if (_e2065[1][1][2].member_1 < _e2065[1][0][2].member_1) {
                                                phi_5566_ = 1u;
                                            } else {
                                                phi_5566_ = 0u;
                                            }
                                            let _e3907 = phi_5566_;
                                            let _e3911 = function_4(((_e2065[1][1][2].member - _e2065[1][0][2].member) - _e3907), (_e2065[1][1][2].member_1 - _e2065[1][0][2].member_1), _e3056);
                                            let _e3914 = (_e2065[1][0][2].member_1 + _e3911.member_1);
                                            if (_e3914 < _e2065[1][0][2].member_1) {
                                                phi_5578_ = 1u;
                                            } else {
                                                phi_5578_ = 0u;
                                            }
                                            let _e3917 = phi_5578_;
                                            let _e3919 = ((_e2065[1][0][2].member + _e3911.member) + _e3917);
                                            if (_e2065[2][1][0].member_1 < _e2065[2][0][0].member_1) {
                                                phi_5597_ = 1u;
                                            } else {
                                                phi_5597_ = 0u;
                                            }
                                            let _e3932 = phi_5597_;
                                            let _e3936 = function_4(((_e2065[2][1][0].member - _e2065[2][0][0].member) - _e3932), (_e2065[2][1][0].member_1 - _e2065[2][0][0].member_1), _e3056);
                                            let _e3939 = (_e2065[2][0][0].member_1 + _e3936.member_1);
                                            if (_e3939 < _e2065[2][0][0].member_1) {
                                                phi_5609_ = 1u;
                                            } else {
                                                phi_5609_ = 0u;
                                            }
                                            let _e3942 = phi_5609_;
                                            let _e3944 = ((_e2065[2][0][0].member + _e3936.member) + _e3942);
                                            if (_e2065[2][1][1].member_1 < _e2065[2][0][1].member_1) {
                                                phi_5620_ = 1u;
                                            } else {
                                                phi_5620_ = 0u;
                                            }
                                            let _e3955 = phi_5620_;
                                            let _e3959 = function_4(((_e2065[2][1][1].member - _e2065[2][0][1].member) - _e3955), (_e2065[2][1][1].member_1 - _e2065[2][0][1].member_1), _e3056);
                                            let _e3962 = (_e2065[2][0][1].member_1 + _e3959.member_1);
                                            if (_e3962 < _e2065[2][0][1].member_1) {
                                                phi_5632_ = 1u;
                                            } else {
                                                phi_5632_ = 0u;
                                            }
                                            let _e3965 = phi_5632_;
                                            let _e3967 = ((_e2065[2][0][1].member + _e3959.member) + _e3965);
                                            if (_e2065[2][1][2].member_1 < _e2065[2][0][2].member_1) {
                                                phi_5643_ = 1u;
                                            } else {
                                                phi_5643_ = 0u;
                                            }
                                            let _e3978 = phi_5643_;
                                            let _e3982 = function_4(((_e2065[2][1][2].member - _e2065[2][0][2].member) - _e3978), (_e2065[2][1][2].member_1 - _e2065[2][0][2].member_1), _e3056);
                                            let _e3985 = (_e2065[2][0][2].member_1 + _e3982.member_1);
                                            if (_e3985 < _e2065[2][0][2].member_1) {
                                                phi_5655_ = 1u;
                                            } else {
                                                phi_5655_ = 0u;
                                            }
                                            let _e3988 = phi_5655_;
                                            let _e3990 = ((_e2065[2][0][2].member + _e3982.member) + _e3988);
                                            local_23 = array<type_9, 3>(type_9(_e3873, _e3868), type_9(_e3896, _e3891), type_9(_e3919, _e3914));
                                            local_24 = array<type_9, 3>(type_9(_e3944, _e3939), type_9(_e3967, _e3962), type_9(_e3990, _e3985));
                                            let _e4001 = local_23[1u].member;
                                            let _e4003 = local_23[1u].member_1;
                                            let _e4006 = local_24[2u].member;
                                            let _e4008 = local_24[2u].member_1;
                                            let _e4009 = function_8(_e4001, _e4003, _e4006, _e4008);
                                            let _e4014 = local_23[2u].member;
                                            let _e4016 = local_23[2u].member_1;
                                            let _e4019 = local_24[1u].member;
                                            let _e4021 = local_24[1u].member_1;
                                            let _e4022 = function_8(_e4014, _e4016, _e4019, _e4021);
                                            if (_e4009.member_1 < _e4022.member_1) {
                                                phi_5740_ = 1u;
                                            } else {
                                                phi_5740_ = 0u;
                                            }
                                            let _e4027 = phi_5740_;
                                            let _e4029 = ((_e4009.member - _e4022.member) - _e4027);
                                            let _e4030 = (_e4009.member_1 - _e4022.member_1);
                                            local_21 = array<type_9, 3>(type_9(_e3873, _e3868), type_9(_e3896, _e3891), type_9(_e3919, _e3914));
                                            local_22 = array<type_9, 3>(type_9(_e3944, _e3939), type_9(_e3967, _e3962), type_9(_e3990, _e3985));
                                            let _e4041 = local_21[2u].member;
                                            let _e4043 = local_21[2u].member_1;
                                            let _e4046 = local_22[0u].member;
                                            let _e4048 = local_22[0u].member_1;
                                            let _e4049 = function_8(_e4041, _e4043, _e4046, _e4048);
                                            let _e4054 = local_21[0u].member;
                                            let _e4056 = local_21[0u].member_1;
                                            let _e4059 = local_22[2u].member;
                                            let _e4061 = local_22[2u].member_1;
                                            let _e4062 = function_8(_e4054, _e4056, _e4059, _e4061);
                                            if (_e4049.member_1 < _e4062.member_1) {
                                                phi_5820_ = 1u;
                                            } else {
                                                phi_5820_ = 0u;
                                            }
                                            let _e4067 = phi_5820_;
                                            let _e4069 = ((_e4049.member - _e4062.member) - _e4067);
                                            let _e4070 = (_e4049.member_1 - _e4062.member_1);
                                            local_19 = array<type_9, 3>(type_9(_e3873, _e3868), type_9(_e3896, _e3891), type_9(_e3919, _e3914));
                                            local_20 = array<type_9, 3>(type_9(_e3944, _e3939), type_9(_e3967, _e3962), type_9(_e3990, _e3985));
                                            let _e4081 = local_19[0u].member;
                                            let _e4083 = local_19[0u].member_1;
                                            let _e4086 = local_20[1u].member;
                                            let _e4088 = local_20[1u].member_1;
                                            let _e4089 = function_8(_e4081, _e4083, _e4086, _e4088);
                                            let _e4094 = local_19[1u].member;
                                            let _e4096 = local_19[1u].member_1;
                                            let _e4099 = local_20[0u].member;
                                            let _e4101 = local_20[0u].member_1;
                                            let _e4102 = function_8(_e4094, _e4096, _e4099, _e4101);
                                            if (_e4089.member_1 < _e4102.member_1) {
                                                phi_5900_ = 1u;
                                            } else {
                                                phi_5900_ = 0u;
                                            }
                                            let _e4107 = phi_5900_;
                                            let _e4109 = ((_e4089.member - _e4102.member) - _e4107);
                                            let _e4110 = (_e4089.member_1 - _e4102.member_1);
                                            if ((_e4029 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e4030 == 0u) {
                                                    phi_5921_ = 1u;
                                                } else {
                                                    phi_5921_ = 0u;
                                                }
                                                let _e4117 = phi_5921_;
                                                phi_5928_ = type_9((~(_e4029) + _e4117), (~(_e4030) + 1u));
                                            } else {
                                                phi_5928_ = type_9(_e4029, _e4030);
                                            }
                                            let _e4124 = phi_5928_;
                                            if ((_e4069 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e4070 == 0u) {
                                                    phi_5942_ = 1u;
                                                } else {
                                                    phi_5942_ = 0u;
                                                }
                                                let _e4133 = phi_5942_;
                                                phi_5949_ = type_9((~(_e4069) + _e4133), (~(_e4070) + 1u));
                                            } else {
                                                phi_5949_ = type_9(_e4069, _e4070);
                                            }
                                            let _e4140 = phi_5949_;
                                            if ((_e4109 >> bitcast<u32>(31i)) != 0u) {
                                                if (_e4110 == 0u) {
                                                    phi_5963_ = 1u;
                                                } else {
                                                    phi_5963_ = 0u;
                                                }
                                                let _e4149 = phi_5963_;
                                                phi_5970_ = type_9((~(_e4109) + _e4149), (~(_e4110) + 1u));
                                            } else {
                                                phi_5970_ = type_9(_e4109, _e4110);
                                            }
                                            let _e4156 = phi_5970_;
                                            if (_e4140.member_1 < _e4124.member_1) {
                                                phi_5977_ = 1u;
                                            } else {
                                                phi_5977_ = 0u;
                                            }
                                            let _e4161 = phi_5977_;
                                            if ((((_e4140.member - _e4124.member) - _e4161) >> bitcast<u32>(31i)) != 0u) {
                                                if (_e4156.member_1 < _e4124.member_1) {
                                                    phi_5989_ = 1u;
                                                } else {
                                                    phi_5989_ = 0u;
                                                }
                                                let _e4169 = phi_5989_;
                                                if ((((_e4156.member - _e4124.member) - _e4169) >> bitcast<u32>(31i)) != 0u) {
                                                    phi_5997_ = false;
                                                } else {
                                                    phi_5997_ = true;
                                                }
                                                let _e4176 = phi_5997_;
                                                phi_5998_ = _e4176;
                                            } else {
                                                phi_5998_ = true;
                                            }
                                            let _e4178 = phi_5998_;
                                            if _e4178 {
                                                if (_e4156.member_1 < _e4140.member_1) {
                                                    phi_6006_ = 1u;
                                                } else {
                                                    phi_6006_ = 0u;
                                                }
                                                let _e4181 = phi_6006_;
                                                if ((((_e4156.member - _e4140.member) - _e4181) >> bitcast<u32>(31i)) != 0u) {
                                                    phi_6014_ = 1i;
                                                } else {
                                                    phi_6014_ = 2i;
                                                }
                                                let _e4188 = phi_6014_;
                                                phi_6015_ = _e4188;
                                            } else {
                                                phi_6015_ = 0i;
                                            }
                                            let _e4190 = phi_6015_;
                                            switch _e4190 {
                                                case 0: {
                                                    phi_6044_ = array<type_9, 2>(type_9(_e3825, _e3820), type_9(_e3848, _e3843));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6044_ = array<type_9, 2>(type_9(_e3848, _e3843), type_9(_e3802, _e3797));
                                                    break;
                                                }
                                                default: {
                                                    phi_6044_ = array<type_9, 2>(type_9(_e3802, _e3797), type_9(_e3825, _e3820));
                                                    break;
                                                }
                                            }
                                            let _e4201 = phi_6044_;
                                            switch _e4190 {
                                                case 0: {
                                                    phi_6073_ = array<type_9, 2>(type_9(_e3896, _e3891), type_9(_e3919, _e3914));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6073_ = array<type_9, 2>(type_9(_e3919, _e3914), type_9(_e3873, _e3868));
                                                    break;
                                                }
                                                default: {
                                                    phi_6073_ = array<type_9, 2>(type_9(_e3873, _e3868), type_9(_e3896, _e3891));
                                                    break;
                                                }
                                            }
                                            let _e4212 = phi_6073_;
                                            switch _e4190 {
                                                case 0: {
                                                    phi_6102_ = array<type_9, 2>(type_9(_e3967, _e3962), type_9(_e3990, _e3985));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6102_ = array<type_9, 2>(type_9(_e3990, _e3985), type_9(_e3944, _e3939));
                                                    break;
                                                }
                                                default: {
                                                    phi_6102_ = array<type_9, 2>(type_9(_e3944, _e3939), type_9(_e3967, _e3962));
                                                    break;
                                                }
                                            }
                                            let _e4223 = phi_6102_;
                                            switch _e4190 {
                                                case 0: {
                                                    phi_6116_ = type_9(_e4029, _e4030);
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6116_ = type_9(_e4069, _e4070);
                                                    break;
                                                }
                                                default: {
                                                    phi_6116_ = type_9(_e4109, _e4110);
                                                    break;
                                                }
                                            }
                                            let _e4228 = phi_6116_;
                                            let _e4231 = local_25[1u].member;
                                            let _e4233 = local_25[1u].member_1;
                                            let _e4236 = local_25[2u].member;
                                            let _e4238 = local_25[2u].member_1;
                                            let _e4239 = (_e4233 + _e4238);
                                            if (_e4239 < _e4233) {
                                                phi_6142_ = 1u;
                                            } else {
                                                phi_6142_ = 0u;
                                            }
                                            let _e4242 = phi_6142_;
                                            let _e4244 = ((_e4231 + _e4236) + _e4242);
                                            let _e4255 = ((_e4239 >> bitcast<u32>(1u)) | ((_e4244 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e4256 = function_10(17u);
                                            let _e4259 = (_e4255 + _e4256.member_1);
                                            if (_e4259 < _e4255) {
                                                phi_6164_ = 1u;
                                            } else {
                                                phi_6164_ = 0u;
                                            }
                                            let _e4262 = phi_6164_;
                                            let _e4264 = ((bitcast<u32>((bitcast<i32>(_e4244) >> bitcast<u32>(1u))) + _e4256.member) + _e4262);
                                            let _e4267 = local_25[0u].member;
                                            let _e4269 = local_25[0u].member_1;
                                            let _e4272 = local_25[2u].member;
                                            let _e4274 = local_25[2u].member_1;
                                            let _e4275 = (_e4269 + _e4274);
                                            if (_e4275 < _e4269) {
                                                phi_6192_ = 1u;
                                            } else {
                                                phi_6192_ = 0u;
                                            }
                                            let _e4278 = phi_6192_;
                                            let _e4280 = ((_e4267 + _e4272) + _e4278);
                                            let _e4291 = ((_e4275 >> bitcast<u32>(1u)) | ((_e4280 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e4292 = function_10(17u);
                                            let _e4295 = (_e4291 + _e4292.member_1);
                                            if (_e4295 < _e4291) {
                                                phi_6214_ = 1u;
                                            } else {
                                                phi_6214_ = 0u;
                                            }
                                            let _e4298 = phi_6214_;
                                            let _e4300 = ((bitcast<u32>((bitcast<i32>(_e4280) >> bitcast<u32>(1u))) + _e4292.member) + _e4298);
                                            let _e4303 = local_25[0u].member;
                                            let _e4305 = local_25[0u].member_1;
                                            let _e4308 = local_25[1u].member;
                                            let _e4310 = local_25[1u].member_1;
                                            let _e4311 = (_e4305 + _e4310);
                                            if (_e4311 < _e4305) {
                                                phi_6242_ = 1u;
                                            } else {
                                                phi_6242_ = 0u;
                                            }
                                            let _e4314 = phi_6242_;
                                            let _e4316 = ((_e4303 + _e4308) + _e4314);
                                            let _e4327 = ((_e4311 >> bitcast<u32>(1u)) | ((_e4316 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e4328 = function_10(17u);
                                            let _e4331 = (_e4327 + _e4328.member_1);
                                            if (_e4331 < _e4327) {
                                                phi_6264_ = 1u;
                                            } else {
                                                phi_6264_ = 0u;
                                            }
                                            let _e4334 = phi_6264_;
                                            let _e4336 = ((bitcast<u32>((bitcast<i32>(_e4316) >> bitcast<u32>(1u))) + _e4328.member) + _e4334);
                                            if ((_e4228.member >> bitcast<u32>(31i)) != 0u) {
                                                if (_e4228.member_1 == 0u) {
                                                    phi_6278_ = 1u;
                                                } else {
                                                    phi_6278_ = 0u;
                                                }
                                                let _e4344 = phi_6278_;
                                                phi_6285_ = type_9((~(_e4228.member) + _e4344), (~(_e4228.member_1) + 1u));
                                            } else {
                                                phi_6285_ = _e4228;
                                            }
                                            let _e4351 = phi_6285_;
                                            if (_e4259 < _e4351.member_1) {
                                                phi_6292_ = 1u;
                                            } else {
                                                phi_6292_ = 0u;
                                            }
                                            let _e4356 = phi_6292_;
                                            if ((((_e4264 - _e4351.member) - _e4356) >> bitcast<u32>(31i)) != 0u) {
                                                let _e4365 = ((_e4228.member >> bitcast<u32>(31i)) != 0u);
                                                if _e4365 {
                                                    if (_e4228.member_1 == 0u) {
                                                        phi_6312_ = 1u;
                                                    } else {
                                                        phi_6312_ = 0u;
                                                    }
                                                    let _e4370 = phi_6312_;
                                                    phi_6319_ = type_9((~(_e4228.member) + _e4370), (~(_e4228.member_1) + 1u));
                                                } else {
                                                    phi_6319_ = _e4228;
                                                }
                                                let _e4377 = phi_6319_;
                                                let _e4380 = function_9(_e4201, _e4223);
                                                if _e4365 {
                                                    if (_e4380.member_1 == 0u) {
                                                        phi_6332_ = 1u;
                                                    } else {
                                                        phi_6332_ = 0u;
                                                    }
                                                    let _e4385 = phi_6332_;
                                                    phi_6339_ = type_9((~(_e4380.member) + _e4385), (~(_e4380.member_1) + 1u));
                                                } else {
                                                    phi_6339_ = _e4380;
                                                }
                                                let _e4392 = phi_6339_;
                                                let _e4395 = function_9(_e4212, _e4201);
                                                if _e4365 {
                                                    if (_e4395.member_1 == 0u) {
                                                        phi_6352_ = 1u;
                                                    } else {
                                                        phi_6352_ = 0u;
                                                    }
                                                    let _e4400 = phi_6352_;
                                                    phi_6359_ = type_9((~(_e4395.member) + _e4400), (~(_e4395.member_1) + 1u));
                                                } else {
                                                    phi_6359_ = _e4395;
                                                }
                                                let _e4407 = phi_6359_;
                                                if (_e315.member != 0u) {
                                                    if (_e4377.member_1 < _e4392.member_1) {
                                                        phi_6370_ = 1u;
                                                    } else {
                                                        phi_6370_ = 0u;
                                                    }
                                                    let _e4441 = phi_6370_;
                                                    let _e4446 = (_e4259 + _e4295);
                                                    if (_e4446 < _e4259) {
                                                        phi_6380_ = 1u;
                                                    } else {
                                                        phi_6380_ = 0u;
                                                    }
                                                    let _e4449 = phi_6380_;
                                                    if (_e4377.member_1 < _e4407.member_1) {
                                                        phi_6388_ = 1u;
                                                    } else {
                                                        phi_6388_ = 0u;
                                                    }
                                                    let _e4455 = phi_6388_;
                                                    let _e4460 = (_e4259 + _e4331);
                                                    if (_e4460 < _e4259) {
                                                        phi_6398_ = 1u;
                                                    } else {
                                                        phi_6398_ = 0u;
                                                    }
                                                    let _e4463 = phi_6398_;
                                                    phi_6438_ = type_9(((_e4264 + _e4336) + _e4463), _e4460);
                                                    phi_6439_ = type_9(((_e4377.member - _e4407.member) - _e4455), (_e4377.member_1 - _e4407.member_1));
                                                    phi_6440_ = type_9(((_e4264 + _e4300) + _e4449), _e4446);
                                                    phi_6441_ = type_9(((_e4377.member - _e4392.member) - _e4441), (_e4377.member_1 - _e4392.member_1));
                                                } else {
                                                    if (_e4377.member_1 < _e4392.member_1) {
                                                        phi_6406_ = 1u;
                                                    } else {
                                                        phi_6406_ = 0u;
                                                    }
                                                    let _e4413 = phi_6406_;
                                                    let _e4416 = (_e4377.member_1 - _e4392.member_1);
                                                    if (_e4416 < _e4407.member_1) {
                                                        phi_6414_ = 1u;
                                                    } else {
                                                        phi_6414_ = 0u;
                                                    }
                                                    let _e4419 = phi_6414_;
                                                    let _e4421 = ((((_e4377.member - _e4392.member) - _e4413) - _e4407.member) - _e4419);
                                                    let _e4422 = (_e4416 - _e4407.member_1);
                                                    let _e4424 = (_e4259 + _e4295);
                                                    if (_e4424 < _e4259) {
                                                        phi_6424_ = 1u;
                                                    } else {
                                                        phi_6424_ = 0u;
                                                    }
                                                    let _e4427 = phi_6424_;
                                                    let _e4430 = (_e4424 + _e4331);
                                                    if (_e4430 < _e4424) {
                                                        phi_6432_ = 1u;
                                                    } else {
                                                        phi_6432_ = 0u;
                                                    }
                                                    let _e4433 = phi_6432_;
                                                    let _e4435 = ((((_e4264 + _e4300) + _e4427) + _e4336) + _e4433);
                                                    phi_6438_ = type_9(_e4435, _e4430);
                                                    phi_6439_ = type_9(_e4421, _e4422);
                                                    phi_6440_ = type_9(_e4435, _e4430);
                                                    phi_6441_ = type_9(_e4421, _e4422);
                                                }
                                                let _e4468 = phi_6438_;
                                                let _e4470 = phi_6439_;
                                                let _e4472 = phi_6440_;
                                                let _e4474 = phi_6441_;
                                                let _e4475 = function_7(_e4392.member, _e4392.member_1, _e4300, _e4295);
                                                if _e4475 {
                                                    phi_6567_ = u32();
                                                    phi_6568_ = true;
                                                } else {
                                                    let _e4476 = function_7(_e4407.member, _e4407.member_1, _e4336, _e4331);
                                                    if _e4476 {
                                                        phi_6565_ = u32();
                                                        phi_6566_ = true;
                                                    } else {
                                                        let _e4481 = function_7(_e4474.member, _e4474.member_1, _e4472.member, _e4472.member_1);
                                                        if _e4481 {
                                                            phi_6563_ = u32();
                                                            phi_6564_ = true;
                                                        } else {
                                                            let _e4486 = function_7(_e4470.member, _e4470.member_1, _e4468.member, _e4468.member_1);
                                                            if _e4486 {
                                                                phi_6562_ = u32();
                                                            } else {
                                                                let _e4487 = function_6(_e4392.member, _e4392.member_1, _e4300, _e4295);
                                                                if _e4487 {
                                                                    let _e4488 = function_6(_e4407.member, _e4407.member_1, _e4336, _e4331);
                                                                    if _e4488 {
                                                                        let _e4493 = function_6(_e4474.member, _e4474.member_1, _e4472.member, _e4472.member_1);
                                                                        if _e4493 {
                                                                            let _e4498 = function_6(_e4470.member, _e4470.member_1, _e4468.member, _e4468.member_1);
                                                                            if _e4498 {
                                                                                phi_6554_ = false;
                                                                            } else {
                                                                                phi_6554_ = true;
                                                                            }
                                                                            let _e4500 = phi_6554_;
                                                                            phi_6555_ = _e4500;
                                                                        } else {
                                                                            phi_6555_ = true;
                                                                        }
                                                                        let _e4502 = phi_6555_;
                                                                        phi_6556_ = _e4502;
                                                                    } else {
                                                                        phi_6556_ = true;
                                                                    }
                                                                    let _e4504 = phi_6556_;
                                                                    phi_6557_ = _e4504;
                                                                } else {
                                                                    phi_6557_ = true;
                                                                }
                                                                let _e4506 = phi_6557_;
                                                                if _e4506 {
                                                                    phi_6561_ = 2u;
                                                                } else {
                                                                    phi_6561_ = 0u;
                                                                }
                                                                let _e4508 = phi_6561_;
                                                                phi_6562_ = _e4508;
                                                            }
                                                            let _e4510 = phi_6562_;
                                                            phi_6563_ = _e4510;
                                                            phi_6564_ = _e4486;
                                                        }
                                                        let _e4512 = phi_6563_;
                                                        let _e4514 = phi_6564_;
                                                        phi_6565_ = _e4512;
                                                        phi_6566_ = _e4514;
                                                    }
                                                    let _e4516 = phi_6565_;
                                                    let _e4518 = phi_6566_;
                                                    phi_6567_ = _e4516;
                                                    phi_6568_ = _e4518;
                                                }
                                                let _e4520 = phi_6567_;
                                                let _e4522 = phi_6568_;
                                                if _e4522 {
                                                    phi_6572_ = 1u;
                                                } else {
                                                    phi_6572_ = _e4520;
                                                }
                                                let _e4524 = phi_6572_;
                                                phi_6573_ = _e4524;
                                            } else {
                                                phi_6573_ = 2u;
                                            }
                                            let _e4526 = phi_6573_;
                                            let _e4527 = (_e4526 == 1u);
                                            if _e3221 {
                                                phi_6581_ = _e4527;
                                            } else {
                                                phi_6581_ = true;
                                            }
                                            let _e4529 = phi_6581_;
                                            phi_6585_ = _e4527;
                                            phi_6586_ = _e3302;
                                            phi_6587_ = _e3305;
                                            phi_6588_ = (_e3056 + (1u << bitcast<u32>(((31u - _e3312) & 31u))));
                                            phi_6589_ = _e4526;
                                            phi_6590_ = _e4529;
                                        } else {
                                            phi_6585_ = _e3220;
                                            phi_6586_ = bool();
                                            phi_6587_ = bool();
                                            phi_6588_ = u32();
                                            phi_6589_ = u32();
                                            phi_6590_ = true;
                                        }
                                        let _e4531 = phi_6585_;
                                        let _e4533 = phi_6586_;
                                        let _e4535 = phi_6587_;
                                        let _e4537 = phi_6588_;
                                        let _e4539 = phi_6589_;
                                        let _e4541 = phi_6590_;
                                        if _e4541 {
                                            if _e4531 {
                                                phi_6927_ = _e3031;
                                                phi_6929_ = _e3033;
                                                phi_6930_ = _e3035;
                                            } else {
                                                let _e4550 = (_e3031[0].member_1 + _e3031[1].member_1);
                                                if (_e4550 < _e3031[0].member_1) {
                                                    phi_6606_ = 1u;
                                                } else {
                                                    phi_6606_ = 0u;
                                                }
                                                let _e4553 = phi_6606_;
                                                let _e4555 = ((_e3031[0].member + _e3031[1].member) + _e4553);
                                                let _e4563 = bitcast<u32>((bitcast<i32>(_e4555) >> bitcast<u32>(1u)));
                                                let _e4566 = ((_e4550 >> bitcast<u32>(1u)) | ((_e4555 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4575 = (_e3031[1].member_1 + _e3031[2].member_1);
                                                if (_e4575 < _e3031[1].member_1) {
                                                    phi_6629_ = 1u;
                                                } else {
                                                    phi_6629_ = 0u;
                                                }
                                                let _e4578 = phi_6629_;
                                                let _e4580 = ((_e3031[1].member + _e3031[2].member) + _e4578);
                                                let _e4588 = bitcast<u32>((bitcast<i32>(_e4580) >> bitcast<u32>(1u)));
                                                let _e4591 = ((_e4575 >> bitcast<u32>(1u)) | ((_e4580 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4600 = (_e3031[2].member_1 + _e3031[3].member_1);
                                                if (_e4600 < _e3031[2].member_1) {
                                                    phi_6652_ = 1u;
                                                } else {
                                                    phi_6652_ = 0u;
                                                }
                                                let _e4603 = phi_6652_;
                                                let _e4605 = ((_e3031[2].member + _e3031[3].member) + _e4603);
                                                let _e4613 = bitcast<u32>((bitcast<i32>(_e4605) >> bitcast<u32>(1u)));
                                                let _e4616 = ((_e4600 >> bitcast<u32>(1u)) | ((_e4605 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4617 = (_e4566 + _e4591);
                                                if (_e4617 < _e4566) {
                                                    phi_6671_ = 1u;
                                                } else {
                                                    phi_6671_ = 0u;
                                                }
                                                let _e4620 = phi_6671_;
                                                let _e4622 = ((_e4563 + _e4588) + _e4620);
                                                let _e4630 = bitcast<u32>((bitcast<i32>(_e4622) >> bitcast<u32>(1u)));
                                                let _e4633 = ((_e4617 >> bitcast<u32>(1u)) | ((_e4622 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4634 = (_e4591 + _e4616);
                                                if (_e4634 < _e4591) {
                                                    phi_6690_ = 1u;
                                                } else {
                                                    phi_6690_ = 0u;
                                                }
                                                let _e4637 = phi_6690_;
                                                let _e4639 = ((_e4588 + _e4613) + _e4637);
                                                let _e4647 = bitcast<u32>((bitcast<i32>(_e4639) >> bitcast<u32>(1u)));
                                                let _e4650 = ((_e4634 >> bitcast<u32>(1u)) | ((_e4639 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4651 = (_e4633 + _e4650);
                                                if (_e4651 < _e4633) {
                                                    phi_6709_ = 1u;
                                                } else {
                                                    phi_6709_ = 0u;
                                                }
                                                let _e4654 = phi_6709_;
                                                let _e4656 = ((_e4630 + _e4647) + _e4654);
                                                let _e4664 = bitcast<u32>((bitcast<i32>(_e4656) >> bitcast<u32>(1u)));
                                                let _e4667 = ((_e4651 >> bitcast<u32>(1u)) | ((_e4656 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4668 = (2u * _e3035);
                                                let _e4679 = function_10(128u);
                                                if ((_e3031[0].member >> bitcast<u32>(31i)) != 0u) {
                                                    if (_e3031[0].member_1 == 0u) {
                                                        phi_6749_ = 1u;
                                                    } else {
                                                        phi_6749_ = 0u;
                                                    }
                                                    let _e4688 = phi_6749_;
                                                    phi_6756_ = type_9((~(_e3031[0].member) + _e4688), (~(_e3031[0].member_1) + 1u));
                                                } else {
                                                    phi_6756_ = _e3031[0];
                                                }
                                                let _e4695 = phi_6756_;
                                                if (_e4679.member_1 < _e4695.member_1) {
                                                    phi_6763_ = 1u;
                                                } else {
                                                    phi_6763_ = 0u;
                                                }
                                                let _e4700 = phi_6763_;
                                                if ((((_e4679.member - _e4695.member) - _e4700) >> bitcast<u32>(31i)) != 0u) {
                                                    if ((_e3031[0].member >> bitcast<u32>(31i)) != 0u) {
                                                        phi_6776_ = 2u;
                                                    } else {
                                                        phi_6776_ = 1u;
                                                    }
                                                    let _e4710 = phi_6776_;
                                                    phi_6777_ = _e4710;
                                                } else {
                                                    phi_6777_ = 0u;
                                                }
                                                let _e4712 = phi_6777_;
                                                let _e4713 = function_10(128u);
                                                if ((_e4563 >> bitcast<u32>(31i)) != 0u) {
                                                    if (_e4566 == 0u) {
                                                        phi_6792_ = 1u;
                                                    } else {
                                                        phi_6792_ = 0u;
                                                    }
                                                    let _e4722 = phi_6792_;
                                                    phi_6799_ = type_9((~(_e4563) + _e4722), (~(_e4566) + 1u));
                                                } else {
                                                    phi_6799_ = type_9(_e4563, _e4566);
                                                }
                                                let _e4729 = phi_6799_;
                                                if (_e4713.member_1 < _e4729.member_1) {
                                                    phi_6806_ = 1u;
                                                } else {
                                                    phi_6806_ = 0u;
                                                }
                                                let _e4734 = phi_6806_;
                                                if ((((_e4713.member - _e4729.member) - _e4734) >> bitcast<u32>(31i)) != 0u) {
                                                    if ((_e4563 >> bitcast<u32>(31i)) != 0u) {
                                                        phi_6819_ = 2u;
                                                    } else {
                                                        phi_6819_ = 1u;
                                                    }
                                                    let _e4744 = phi_6819_;
                                                    phi_6820_ = _e4744;
                                                } else {
                                                    phi_6820_ = 0u;
                                                }
                                                let _e4746 = phi_6820_;
                                                let _e4748 = function_10(128u);
                                                if ((_e4630 >> bitcast<u32>(31i)) != 0u) {
                                                    if (_e4633 == 0u) {
                                                        phi_6836_ = 1u;
                                                    } else {
                                                        phi_6836_ = 0u;
                                                    }
                                                    let _e4757 = phi_6836_;
                                                    phi_6843_ = type_9((~(_e4630) + _e4757), (~(_e4633) + 1u));
                                                } else {
                                                    phi_6843_ = type_9(_e4630, _e4633);
                                                }
                                                let _e4764 = phi_6843_;
                                                if (_e4748.member_1 < _e4764.member_1) {
                                                    phi_6850_ = 1u;
                                                } else {
                                                    phi_6850_ = 0u;
                                                }
                                                let _e4769 = phi_6850_;
                                                if ((((_e4748.member - _e4764.member) - _e4769) >> bitcast<u32>(31i)) != 0u) {
                                                    if ((_e4630 >> bitcast<u32>(31i)) != 0u) {
                                                        phi_6863_ = 2u;
                                                    } else {
                                                        phi_6863_ = 1u;
                                                    }
                                                    let _e4779 = phi_6863_;
                                                    phi_6864_ = _e4779;
                                                } else {
                                                    phi_6864_ = 0u;
                                                }
                                                let _e4781 = phi_6864_;
                                                let _e4783 = function_10(128u);
                                                if ((_e4664 >> bitcast<u32>(31i)) != 0u) {
                                                    if (_e4667 == 0u) {
                                                        phi_6880_ = 1u;
                                                    } else {
                                                        phi_6880_ = 0u;
                                                    }
                                                    let _e4792 = phi_6880_;
                                                    phi_6887_ = type_9((~(_e4664) + _e4792), (~(_e4667) + 1u));
                                                } else {
                                                    phi_6887_ = type_9(_e4664, _e4667);
                                                }
                                                let _e4799 = phi_6887_;
                                                if (_e4783.member_1 < _e4799.member_1) {
                                                    phi_6894_ = 1u;
                                                } else {
                                                    phi_6894_ = 0u;
                                                }
                                                let _e4804 = phi_6894_;
                                                if ((((_e4783.member - _e4799.member) - _e4804) >> bitcast<u32>(31i)) != 0u) {
                                                    if ((_e4664 >> bitcast<u32>(31i)) != 0u) {
                                                        phi_6907_ = 2u;
                                                    } else {
                                                        phi_6907_ = 1u;
                                                    }
                                                    let _e4814 = phi_6907_;
                                                    phi_6908_ = _e4814;
                                                } else {
                                                    phi_6908_ = 0u;
                                                }
                                                let _e4816 = phi_6908_;
                                                if ((((_e4712 & _e4746) & _e4781) & _e4816) != 0u) {
                                                    phi_6925_ = array<type_9, 4>(type_9(_e4664, _e4667), type_9(_e4647, _e4650), type_9(_e4613, _e4616), type_9(_e3031[3].member, _e3031[3].member_1));
                                                    phi_6926_ = (_e4668 + 1u);
                                                } else {
                                                    phi_6925_ = array<type_9, 4>(_e3031[0], type_9(_e4563, _e4566), type_9(_e4630, _e4633), type_9(_e4664, _e4667));
                                                    phi_6926_ = _e4668;
                                                }
                                                let _e4830 = phi_6925_;
                                                let _e4832 = phi_6926_;
                                                phi_6927_ = _e4830;
                                                phi_6929_ = (_e3033 + 1u);
                                                phi_6930_ = _e4832;
                                            }
                                            let _e4834 = phi_6927_;
                                            let _e4836 = phi_6929_;
                                            let _e4838 = phi_6930_;
                                            phi_6931_ = _e4834;
                                            phi_6933_ = _e4836;
                                            phi_6934_ = _e4838;
                                        } else {
                                            phi_6931_ = array<type_9, 4>();
                                            phi_6933_ = u32();
                                            phi_6934_ = u32();
                                        }
                                        let _e4840 = phi_6931_;
                                        let _e4842 = phi_6933_;
                                        let _e4844 = phi_6934_;
                                        phi_6935_ = _e4840;
                                        phi_6937_ = _e4531;
                                        phi_6938_ = _e4842;
                                        phi_6939_ = _e4844;
                                        phi_6940_ = _e4533;
                                        phi_6941_ = _e4535;
                                        phi_6942_ = _e4537;
                                        phi_6943_ = _e4539;
                                        phi_6944_ = _e4541;
                                    }
                                    let _e4846 = phi_6935_;
                                    let _e4848 = phi_6937_;
                                    let _e4850 = phi_6938_;
                                    let _e4852 = phi_6939_;
                                    let _e4854 = phi_6940_;
                                    let _e4856 = phi_6941_;
                                    let _e4858 = phi_6942_;
                                    let _e4860 = phi_6943_;
                                    let _e4862 = phi_6944_;
                                    if _e4862 {
                                        if _e4848 {
                                            let _e4863 = (_e4852 + 1u);
                                            let _e4865 = (_e4863 & (4294967295u - _e4852));
                                            let _e4871 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e4865)), 32u, (_e4865 == 0u)));
                                            if (_e4850 < _e4871) {
                                                phi_6963_ = _e4850;
                                            } else {
                                                phi_6963_ = _e4871;
                                            }
                                            let _e4874 = phi_6963_;
                                            let _e4877 = (_e4863 >> bitcast<u32>((_e4874 & 31u)));
                                            let _e4878 = (_e4850 - _e4874);
                                            if (_e4877 == 1u) {
                                                if (_e4878 == 0u) {
                                                    phi_6975_ = false;
                                                } else {
                                                    phi_6975_ = true;
                                                }
                                                let _e4882 = phi_6975_;
                                                phi_6976_ = _e4882;
                                            } else {
                                                phi_6976_ = true;
                                            }
                                            let _e4884 = phi_6976_;
                                            if _e4884 {
                                                let _e4885 = (31u - _e4878);
                                                let _e4888 = (_e4877 << bitcast<u32>((_e4885 & 31u)));
                                                let _e4892 = ((_e4877 + 1u) << bitcast<u32>((_e4885 & 31u)));
                                                if (_e2904 < _e2831.member_1) {
                                                    phi_6994_ = 1u;
                                                } else {
                                                    phi_6994_ = 0u;
                                                }
                                                let _e4895 = phi_6994_;
                                                let _e4899 = function_4(((_e2909 - _e2831.member) - _e4895), (_e2904 - _e2831.member_1), _e4888);
                                                let _e4902 = (_e2831.member_1 + _e4899.member_1);
                                                if (_e4902 < _e2831.member_1) {
                                                    phi_7006_ = 1u;
                                                } else {
                                                    phi_7006_ = 0u;
                                                }
                                                let _e4905 = phi_7006_;
                                                if (_e2980 < _e2904) {
                                                    phi_7017_ = 1u;
                                                } else {
                                                    phi_7017_ = 0u;
                                                }
                                                let _e4910 = phi_7017_;
                                                let _e4914 = function_4(((_e2985 - _e2909) - _e4910), (_e2980 - _e2904), _e4888);
                                                let _e4917 = (_e2904 + _e4914.member_1);
                                                if (_e4917 < _e2904) {
                                                    phi_7029_ = 1u;
                                                } else {
                                                    phi_7029_ = 0u;
                                                }
                                                let _e4920 = phi_7029_;
                                                if (_e3021.member_1 < _e2980) {
                                                    phi_7040_ = 1u;
                                                } else {
                                                    phi_7040_ = 0u;
                                                }
                                                let _e4925 = phi_7040_;
                                                let _e4929 = function_4(((_e3021.member - _e2985) - _e4925), (_e3021.member_1 - _e2980), _e4888);
                                                let _e4932 = (_e2980 + _e4929.member_1);
                                                if (_e4932 < _e2980) {
                                                    phi_7052_ = 1u;
                                                } else {
                                                    phi_7052_ = 0u;
                                                }
                                                let _e4935 = phi_7052_;
                                                let _e4941 = array<type_9, 3>(type_9(((_e2831.member + _e4899.member) + _e4905), _e4902), type_9(((_e2909 + _e4914.member) + _e4920), _e4917), type_9(((_e2985 + _e4929.member) + _e4935), _e4932));
                                                if (_e2904 < _e2831.member_1) {
                                                    phi_7069_ = 1u;
                                                } else {
                                                    phi_7069_ = 0u;
                                                }
                                                let _e4944 = phi_7069_;
                                                let _e4948 = function_4(((_e2909 - _e2831.member) - _e4944), (_e2904 - _e2831.member_1), _e4892);
                                                let _e4951 = (_e2831.member_1 + _e4948.member_1);
                                                if (_e4951 < _e2831.member_1) {
                                                    phi_7081_ = 1u;
                                                } else {
                                                    phi_7081_ = 0u;
                                                }
                                                let _e4954 = phi_7081_;
                                                if (_e2980 < _e2904) {
                                                    phi_7092_ = 1u;
                                                } else {
                                                    phi_7092_ = 0u;
                                                }
                                                let _e4959 = phi_7092_;
                                                let _e4963 = function_4(((_e2985 - _e2909) - _e4959), (_e2980 - _e2904), _e4892);
                                                let _e4966 = (_e2904 + _e4963.member_1);
                                                if (_e4966 < _e2904) {
                                                    phi_7104_ = 1u;
                                                } else {
                                                    phi_7104_ = 0u;
                                                }
                                                let _e4969 = phi_7104_;
                                                if (_e3021.member_1 < _e2980) {
                                                    phi_7115_ = 1u;
                                                } else {
                                                    phi_7115_ = 0u;
                                                }
                                                let _e4974 = phi_7115_;
                                                let _e4978 = function_4(((_e3021.member - _e2985) - _e4974), (_e3021.member_1 - _e2980), _e4892);
                                                let _e4981 = (_e2980 + _e4978.member_1);
                                                if (_e4981 < _e2980) {
                                                    phi_7127_ = 1u;
                                                } else {
                                                    phi_7127_ = 0u;
                                                }
                                                let _e4984 = phi_7127_;
                                                let _e4991 = function_5(_e4941, _e4888);
                                                let _e4992 = function_5(_e4941, _e4892);
                                                let _e4993 = function_5(array<type_9, 3>(type_9(((_e2831.member + _e4948.member) + _e4954), _e4951), type_9(((_e2909 + _e4963.member) + _e4969), _e4966), type_9(((_e2985 + _e4978.member) + _e4984), _e4981)), _e4892);
                                                if (_e4991[1].member_1 < _e4991[0].member_1) {
                                                    phi_7147_ = 1u;
                                                } else {
                                                    phi_7147_ = 0u;
                                                }
                                                let _e5004 = phi_7147_;
                                                let _e5008 = function_4(((_e4991[1].member - _e4991[0].member) - _e5004), (_e4991[1].member_1 - _e4991[0].member_1), _e4888);
                                                let _e5011 = (_e4991[0].member_1 + _e5008.member_1);
                                                if (_e5011 < _e4991[0].member_1) {
                                                    phi_7159_ = 1u;
                                                } else {
                                                    phi_7159_ = 0u;
                                                }
                                                let _e5014 = phi_7159_;
                                                if (_e4991[1].member_1 < _e4991[0].member_1) {
                                                    phi_7170_ = 1u;
                                                } else {
                                                    phi_7170_ = 0u;
                                                }
                                                let _e5027 = phi_7170_;
                                                let _e5031 = function_4(((_e4991[1].member - _e4991[0].member) - _e5027), (_e4991[1].member_1 - _e4991[0].member_1), _e4892);
                                                let _e5034 = (_e4991[0].member_1 + _e5031.member_1);
                                                if (_e5034 < _e4991[0].member_1) {
                                                    phi_7182_ = 1u;
                                                } else {
                                                    phi_7182_ = 0u;
                                                }
                                                let _e5037 = phi_7182_;
                                                if (_e4992[1].member_1 < _e4992[0].member_1) {
                                                    phi_7193_ = 1u;
                                                } else {
                                                    phi_7193_ = 0u;
                                                }
                                                let _e5050 = phi_7193_;
                                                let _e5054 = function_4(((_e4992[1].member - _e4992[0].member) - _e5050), (_e4992[1].member_1 - _e4992[0].member_1), _e4892);
                                                let _e5057 = (_e4992[0].member_1 + _e5054.member_1);
                                                if (_e5057 < _e4992[0].member_1) {
                                                    phi_7205_ = 1u;
                                                } else {
                                                    phi_7205_ = 0u;
                                                }
                                                let _e5060 = phi_7205_;
                                                if (_e4993[1].member_1 < _e4993[0].member_1) {
                                                    phi_7216_ = 1u;
                                                } else {
                                                    phi_7216_ = 0u;
                                                }
                                                let _e5073 = phi_7216_;
                                                let _e5077 = function_4(((_e4993[1].member - _e4993[0].member) - _e5073), (_e4993[1].member_1 - _e4993[0].member_1), _e4892);
                                                let _e5080 = (_e4993[0].member_1 + _e5077.member_1);
                                                if (_e5080 < _e4993[0].member_1) {
                                                    phi_7228_ = 1u;
                                                } else {
                                                    phi_7228_ = 0u;
                                                }
                                                let _e5083 = phi_7228_;
                                                phi_7239_ = array<type_9, 4>(type_9(((_e4991[0].member + _e5008.member) + _e5014), _e5011), type_9(((_e4991[0].member + _e5031.member) + _e5037), _e5034), type_9(((_e4992[0].member + _e5054.member) + _e5060), _e5057), type_9(((_e4993[0].member + _e5077.member) + _e5083), _e5080));
                                            } else {
                                                phi_7239_ = array<type_9, 4>();
                                            }
                                            let _e5092 = phi_7239_;
                                            phi_7240_ = _e5092;
                                            phi_7241_ = _e4878;
                                            phi_7242_ = _e4877;
                                            phi_7243_ = _e4884;
                                        } else {
                                            phi_7240_ = _e4846;
                                            phi_7241_ = _e4850;
                                            phi_7242_ = _e4852;
                                            phi_7243_ = true;
                                        }
                                        let _e5094 = phi_7240_;
                                        let _e5096 = phi_7241_;
                                        let _e5098 = phi_7242_;
                                        let _e5100 = phi_7243_;
                                        if _e5100 {
                                            phi_7247_ = false;
                                        } else {
                                            phi_7247_ = true;
                                        }
                                        let _e5102 = phi_7247_;
                                        phi_7248_ = _e5094;
                                        phi_7249_ = _e5096;
                                        phi_7250_ = _e5098;
                                        phi_7251_ = _e5100;
                                        phi_7252_ = _e5102;
                                        phi_7253_ = false;
                                    } else {
                                        phi_7248_ = array<type_9, 4>();
                                        phi_7249_ = u32();
                                        phi_7250_ = u32();
                                        phi_7251_ = false;
                                        phi_7252_ = false;
                                        phi_7253_ = true;
                                    }
                                    let _e5104 = phi_7248_;
                                    let _e5106 = phi_7249_;
                                    let _e5108 = phi_7250_;
                                    let _e5110 = phi_7251_;
                                    let _e5112 = phi_7252_;
                                    let _e5114 = phi_7253_;
                                    phi_7254_ = _e5104;
                                    phi_7256_ = _e5106;
                                    phi_7257_ = _e5108;
                                    phi_7258_ = _e4854;
                                    phi_7259_ = _e4856;
                                    phi_7260_ = _e4858;
                                    phi_7261_ = _e4860;
                                    phi_7262_ = _e5110;
                                    phi_7263_ = _e5112;
                                    phi_7264_ = _e5114;
                                }
                                let _e5116 = phi_7254_;
                                let _e5118 = phi_7256_;
                                let _e5120 = phi_7257_;
                                let _e5122 = phi_7258_;
                                let _e5124 = phi_7259_;
                                let _e5126 = phi_7260_;
                                let _e5128 = phi_7261_;
                                let _e5130 = phi_7262_;
                                let _e5132 = phi_7263_;
                                let _e5134 = phi_7264_;
                                phi_4554_ = _e5116;
                                phi_4558_ = _e5118;
                                phi_4560_ = _e5120;
                                phi_7265_ = _e3056;
                                phi_7266_ = _e5122;
                                phi_7267_ = _e5124;
                                phi_7268_ = _e5126;
                                phi_7269_ = _e5128;
                                phi_7270_ = _e5130;
                                phi_7271_ = _e3061;
                                phi_7272_ = false;
                                phi_7273_ = _e5132;
                                phi_7274_ = _e5134;
                            } else {
                                phi_4554_ = array<type_9, 4>();
                                phi_4558_ = u32();
                                phi_4560_ = u32();
                                phi_7265_ = u32();
                                phi_7266_ = bool();
                                phi_7267_ = bool();
                                phi_7268_ = u32();
                                phi_7269_ = u32();
                                phi_7270_ = false;
                                phi_7271_ = false;
                                phi_7272_ = true;
                                phi_7273_ = false;
                                phi_7274_ = false;
                            }
                            let _e5136 = phi_4554_;
                            let _e5138 = phi_4558_;
                            let _e5140 = phi_4560_;
                            let _e5142 = phi_7265_;
                            let _e5144 = phi_7266_;
                            let _e5146 = phi_7267_;
                            let _e5148 = phi_7268_;
                            let _e5150 = phi_7269_;
                            let _e5152 = phi_7270_;
                            let _e5154 = phi_7271_;
                            let _e5156 = phi_7272_;
                            let _e5158 = phi_7273_;
                            let _e5160 = phi_7274_;
                            local_62 = _e5154;
                            local_129 = _e5156;
                            local_130 = _e5158;
                            local_131 = _e5160;
                            local_132 = _e5154;
                            local_63 = _e5146;
                            local_64 = _e5148;
                            local_68 = _e5148;
                            local_69 = _e5148;
                            local_70 = _e5148;
                            local_71 = _e5148;
                            local_72 = _e5148;
                            local_73 = _e5148;
                            local_74 = _e5148;
                            local_75 = _e5148;
                            local_76 = _e5148;
                            local_77 = _e5148;
                            local_78 = _e5148;
                            local_79 = _e5148;
                            local_80 = _e5148;
                            local_133 = _e5144;
                            local_81 = _e5142;
                            local_82 = _e5148;
                            local_83 = _e5150;
                            local_84 = _e5142;
                            continue;
                            continuing {
                                phi_4550_ = _e3047;
                                phi_4553_ = _e5136;
                                phi_4557_ = _e5138;
                                phi_4559_ = _e5140;
                                break if !(_e5152);
                            }
                        }
                        let _e5163 = local_62;
                        if _e5163 {
                            phi_7279_ = type_9(0u, type_9().member_1);
                            phi_7280_ = false;
                            phi_7281_ = false;
                            phi_7282_ = false;
                        } else {
                            phi_7279_ = type_9();
                            let _e15779 = local_129;
                            phi_7280_ = _e15779;
                            let _e15782 = local_130;
                            phi_7281_ = _e15782;
                            let _e15785 = local_131;
                            phi_7282_ = _e15785;
                        }
                        let _e5167 = phi_7279_;
                        let _e5169 = phi_7280_;
                        let _e5171 = phi_7281_;
                        let _e5173 = phi_7282_;
                        if _e5169 {
                            phi_7287_ = type_9(2u, type_9().member_1);
                            phi_7288_ = false;
                            phi_7289_ = false;
                            phi_7290_ = false;
                        } else {
                            phi_7287_ = type_9();
                            phi_7288_ = _e5171;
                            phi_7289_ = _e5173;
                            let _e15791 = local_132;
                            phi_7290_ = _e15791;
                        }
                        let _e5177 = phi_7287_;
                        let _e5179 = phi_7288_;
                        let _e5181 = phi_7289_;
                        let _e5183 = phi_7290_;
                        if _e5179 {
                            phi_7295_ = type_9(0u, type_9().member_1);
                            phi_7296_ = false;
                            phi_7297_ = false;
                        } else {
                            phi_7295_ = type_9();
                            phi_7296_ = _e5181;
                            phi_7297_ = _e5183;
                        }
                        let _e5187 = phi_7295_;
                        let _e5189 = phi_7296_;
                        let _e5191 = phi_7297_;
                        if _e5189 {
                            let _e5193 = local_63;
                            if _e5193 {
                                let _e5195 = local_64;
                                if (_e5195 <= 2147483648u) {
                                    let _e5198 = local_65;
                                    let _e5202 = local_66;
                                    let _e5205 = function_10(128u);
                                    if ((_e5198[0].member >> bitcast<u32>(31i)) != 0u) {
                                        if (_e5202[0].member_1 == 0u) {
                                            phi_7322_ = 1u;
                                        } else {
                                            phi_7322_ = 0u;
                                        }
                                        let _e5216 = phi_7322_;
                                        phi_7329_ = type_9((~(_e5198[0].member) + _e5216), (~(_e5202[0].member_1) + 1u));
                                    } else {
                                        let _e5212 = local_67;
                                        phi_7329_ = _e5212[0];
                                    }
                                    let _e5223 = phi_7329_;
                                    if (_e5205.member_1 < _e5223.member_1) {
                                        phi_7336_ = 1u;
                                    } else {
                                        phi_7336_ = 0u;
                                    }
                                    let _e5228 = phi_7336_;
                                    if ((((_e5205.member - _e5223.member) - _e5228) >> bitcast<u32>(31i)) != 0u) {
                                        if ((_e5198[0].member >> bitcast<u32>(31i)) != 0u) {
                                            phi_7349_ = 2u;
                                        } else {
                                            phi_7349_ = 1u;
                                        }
                                        let _e5238 = phi_7349_;
                                        phi_7350_ = _e5238;
                                    } else {
                                        phi_7350_ = 0u;
                                    }
                                    let _e5240 = phi_7350_;
                                    if (_e2904 < _e2831.member_1) {
                                        phi_7359_ = 1u;
                                    } else {
                                        phi_7359_ = 0u;
                                    }
                                    let _e5243 = phi_7359_;
                                    let _e5248 = local_68;
                                    let _e5249 = function_4(((_e2909 - _e2831.member) - _e5243), (_e2904 - _e2831.member_1), _e5248);
                                    let _e5252 = (_e2831.member_1 + _e5249.member_1);
                                    if (_e5252 < _e2831.member_1) {
                                        phi_7371_ = 1u;
                                    } else {
                                        phi_7371_ = 0u;
                                    }
                                    let _e5255 = phi_7371_;
                                    if (_e2980 < _e2904) {
                                        phi_7382_ = 1u;
                                    } else {
                                        phi_7382_ = 0u;
                                    }
                                    let _e5260 = phi_7382_;
                                    let _e5265 = local_69;
                                    let _e5266 = function_4(((_e2985 - _e2909) - _e5260), (_e2980 - _e2904), _e5265);
                                    let _e5269 = (_e2904 + _e5266.member_1);
                                    if (_e5269 < _e2904) {
                                        phi_7394_ = 1u;
                                    } else {
                                        phi_7394_ = 0u;
                                    }
                                    let _e5272 = phi_7394_;
                                    if (_e3021.member_1 < _e2980) {
                                        phi_7405_ = 1u;
                                    } else {
                                        phi_7405_ = 0u;
                                    }
                                    let _e5277 = phi_7405_;
                                    let _e5282 = local_70;
                                    let _e5283 = function_4(((_e3021.member - _e2985) - _e5277), (_e3021.member_1 - _e2980), _e5282);
                                    let _e5286 = (_e2980 + _e5283.member_1);
                                    if (_e5286 < _e2980) {
                                        phi_7417_ = 1u;
                                    } else {
                                        phi_7417_ = 0u;
                                    }
                                    let _e5289 = phi_7417_;
                                    let _e5295 = array<type_9, 3>(type_9(((_e2831.member + _e5249.member) + _e5255), _e5252), type_9(((_e2909 + _e5266.member) + _e5272), _e5269), type_9(((_e2985 + _e5283.member) + _e5289), _e5286));
                                    if (_e2904 < _e2831.member_1) {
                                        phi_7434_ = 1u;
                                    } else {
                                        phi_7434_ = 0u;
                                    }
                                    let _e5298 = phi_7434_;
                                    let _e5303 = local_71;
                                    let _e5304 = function_4(((_e2909 - _e2831.member) - _e5298), (_e2904 - _e2831.member_1), _e5303);
                                    let _e5307 = (_e2831.member_1 + _e5304.member_1);
                                    if (_e5307 < _e2831.member_1) {
                                        phi_7446_ = 1u;
                                    } else {
                                        phi_7446_ = 0u;
                                    }
                                    let _e5310 = phi_7446_;
                                    if (_e2980 < _e2904) {
                                        phi_7457_ = 1u;
                                    } else {
                                        phi_7457_ = 0u;
                                    }
                                    let _e5315 = phi_7457_;
                                    let _e5320 = local_72;
                                    let _e5321 = function_4(((_e2985 - _e2909) - _e5315), (_e2980 - _e2904), _e5320);
                                    let _e5324 = (_e2904 + _e5321.member_1);
                                    if (_e5324 < _e2904) {
                                        phi_7469_ = 1u;
                                    } else {
                                        phi_7469_ = 0u;
                                    }
                                    let _e5327 = phi_7469_;
                                    if (_e3021.member_1 < _e2980) {
                                        phi_7480_ = 1u;
                                    } else {
                                        phi_7480_ = 0u;
                                    }
                                    let _e5332 = phi_7480_;
                                    let _e5337 = local_73;
                                    let _e5338 = function_4(((_e3021.member - _e2985) - _e5332), (_e3021.member_1 - _e2980), _e5337);
                                    let _e5341 = (_e2980 + _e5338.member_1);
                                    if (_e5341 < _e2980) {
                                        phi_7492_ = 1u;
                                    } else {
                                        phi_7492_ = 0u;
                                    }
                                    let _e5344 = phi_7492_;
                                    let _e5352 = local_74;
                                    let _e5353 = function_5(_e5295, _e5352);
                                    let _e5355 = local_75;
                                    let _e5356 = function_5(_e5295, _e5355);
                                    let _e5358 = local_76;
                                    let _e5359 = function_5(array<type_9, 3>(type_9(((_e2831.member + _e5304.member) + _e5310), _e5307), type_9(((_e2909 + _e5321.member) + _e5327), _e5324), type_9(((_e2985 + _e5338.member) + _e5344), _e5341)), _e5358);
                                    if (_e5353[1].member_1 < _e5353[0].member_1) {
                                        phi_7512_ = 1u;
                                    } else {
                                        phi_7512_ = 0u;
                                    }
                                    let _e5370 = phi_7512_;
                                    let _e5375 = local_77;
                                    let _e5376 = function_4(((_e5353[1].member - _e5353[0].member) - _e5370), (_e5353[1].member_1 - _e5353[0].member_1), _e5375);
                                    let _e5379 = (_e5353[0].member_1 + _e5376.member_1);
                                    if (_e5379 < _e5353[0].member_1) {
                                        phi_7524_ = 1u;
                                    } else {
                                        phi_7524_ = 0u;
                                    }
                                    let _e5382 = phi_7524_;
                                    let _e5384 = ((_e5353[0].member + _e5376.member) + _e5382);
                                    if (_e5353[1].member_1 < _e5353[0].member_1) {
                                        phi_7535_ = 1u;
                                    } else {
                                        phi_7535_ = 0u;
                                    }
                                    let _e5395 = phi_7535_;
                                    let _e5400 = local_78;
                                    let _e5401 = function_4(((_e5353[1].member - _e5353[0].member) - _e5395), (_e5353[1].member_1 - _e5353[0].member_1), _e5400);
                                    if (_e5356[1].member_1 < _e5356[0].member_1) {
                                        phi_7558_ = 1u;
                                    } else {
                                        phi_7558_ = 0u;
                                    }
                                    let _e5412 = phi_7558_;
                                    let _e5417 = local_79;
                                    let _e5418 = function_4(((_e5356[1].member - _e5356[0].member) - _e5412), (_e5356[1].member_1 - _e5356[0].member_1), _e5417);
                                    if (_e5359[1].member_1 < _e5359[0].member_1) {
                                        phi_7581_ = 1u;
                                    } else {
                                        phi_7581_ = 0u;
                                    }
                                    let _e5429 = phi_7581_;
                                    let _e5434 = local_80;
                                    let _e5435 = function_4(((_e5359[1].member - _e5359[0].member) - _e5429), (_e5359[1].member_1 - _e5359[0].member_1), _e5434);
                                    let _e5436 = function_10(128u);
                                    if ((_e5384 >> bitcast<u32>(31i)) != 0u) {
                                        if (_e5379 == 0u) {
                                            phi_7618_ = 1u;
                                        } else {
                                            phi_7618_ = 0u;
                                        }
                                        let _e5445 = phi_7618_;
                                        phi_7625_ = type_9((~(_e5384) + _e5445), (~(_e5379) + 1u));
                                    } else {
                                        phi_7625_ = type_9(_e5384, _e5379);
                                    }
                                    let _e5452 = phi_7625_;
                                    if (_e5436.member_1 < _e5452.member_1) {
                                        phi_7632_ = 1u;
                                    } else {
                                        phi_7632_ = 0u;
                                    }
                                    let _e5457 = phi_7632_;
                                    if ((((_e5436.member - _e5452.member) - _e5457) >> bitcast<u32>(31i)) != 0u) {
                                        if ((_e5384 >> bitcast<u32>(31i)) != 0u) {
                                            phi_7645_ = 2u;
                                        } else {
                                            phi_7645_ = 1u;
                                        }
                                        let _e5467 = phi_7645_;
                                        phi_7646_ = _e5467;
                                    } else {
                                        phi_7646_ = 0u;
                                    }
                                    let _e5469 = phi_7646_;
                                    phi_7649_ = ((_e5240 | _e5469) == 3u);
                                    phi_7650_ = false;
                                } else {
                                    phi_7649_ = bool();
                                    phi_7650_ = true;
                                }
                                let _e5473 = phi_7649_;
                                let _e5475 = phi_7650_;
                                phi_7651_ = _e5473;
                                phi_7652_ = _e5475;
                            } else {
                                phi_7651_ = bool();
                                phi_7652_ = true;
                            }
                            let _e5477 = phi_7651_;
                            let _e5479 = phi_7652_;
                            if _e5479 {
                                let _e15846 = local_133;
                                phi_7656_ = _e15846;
                            } else {
                                phi_7656_ = _e5477;
                            }
                            let _e5481 = phi_7656_;
                            let _e5483 = local_81;
                            if (_e5483 >= _e1450) {
                                let _e5486 = local_82;
                                phi_7662_ = (_e5486 <= _e1452);
                            } else {
                                phi_7662_ = false;
                            }
                            let _e5489 = phi_7662_;
                            if _e5481 {
                                if _e5489 {
                                    let _e5491 = local_83;
                                    phi_7670_ = (_e5491 == 0u);
                                    phi_7671_ = false;
                                } else {
                                    phi_7670_ = bool();
                                    phi_7671_ = true;
                                }
                                let _e5494 = phi_7670_;
                                let _e5496 = phi_7671_;
                                phi_7672_ = _e5494;
                                phi_7673_ = _e5496;
                            } else {
                                phi_7672_ = bool();
                                phi_7673_ = true;
                            }
                            let _e5498 = phi_7672_;
                            let _e5500 = phi_7673_;
                            if _e5500 {
                                phi_7677_ = false;
                            } else {
                                phi_7677_ = _e5498;
                            }
                            let _e5502 = phi_7677_;
                            if _e5502 {
                                let _e5506 = local_84;
                                phi_7683_ = type_9(1u, _e5506);
                            } else {
                                phi_7683_ = type_9(2u, type_9().member_1);
                            }
                            let _e5509 = phi_7683_;
                            phi_7684_ = _e5509;
                            phi_7685_ = true;
                            phi_7686_ = false;
                        } else {
                            phi_7684_ = _e5187;
                            phi_7685_ = _e5179;
                            phi_7686_ = _e5191;
                        }
                        let _e5511 = phi_7684_;
                        let _e5513 = phi_7685_;
                        let _e5515 = phi_7686_;
                        if _e5513 {
                            phi_7690_ = _e5511;
                            phi_7691_ = true;
                        } else {
                            phi_7690_ = _e5167;
                            phi_7691_ = _e5515;
                        }
                        let _e5517 = phi_7690_;
                        let _e5519 = phi_7691_;
                        if _e5519 {
                            phi_7695_ = _e5517;
                        } else {
                            phi_7695_ = _e5177;
                        }
                        let _e5521 = phi_7695_;
                        switch bitcast<i32>(_e5521.member) {
                            case 0: {
                                phi_7732_ = type_28(0u, 0u, array<u32, 2>(0u, 0u), false);
                                break;
                            }
                            case 1: {
                                if (_e5521.member_1 > _e1450) {
                                    phi_7708_ = 1u;
                                } else {
                                    phi_7708_ = 0u;
                                }
                                let _e5527 = phi_7708_;
                                if (_e5521.member_1 == 0u) {
                                    phi_7726_ = array<u32, 2>(0u, 0u);
                                } else {
                                    let _e5533 = select((bitcast<u32>(31i) - firstLeadingBit(_e5521.member_1)), 32u, (_e5521.member_1 == 0u));
                                    let _e5538 = ((_e5521.member_1 << bitcast<u32>((_e5533 & 31u))) << bitcast<u32>(1i));
                                    phi_7726_ = array<u32, 2>((_e5538 << bitcast<u32>(20i)), (((1023u - _e5533) << bitcast<u32>(20i)) | (_e5538 >> bitcast<u32>(12i))));
                                }
                                let _e5549 = phi_7726_;
                                phi_7732_ = type_28(0u, _e5527, _e5549, true);
                                break;
                            }
                            case 2: {
                                phi_7732_ = type_28(1u, 0u, array<u32, 2>(0u, 0u), true);
                                break;
                            }
                            default: {
                                phi_7732_ = type_28();
                                break;
                            }
                        }
                        let _e5552 = phi_7732_;
                        if (_e5552.member == 0u) {
                            phi_7738_ = false;
                        } else {
                            phi_7738_ = true;
                        }
                        let _e5556 = phi_7738_;
                        phi_7739_ = _e5552;
                        phi_7740_ = _e5556;
                    } else {
                        phi_7739_ = type_28();
                        phi_7740_ = true;
                    }
                    let _e5558 = phi_7739_;
                    let _e5560 = phi_7740_;
                    phi_7741_ = _e5558;
                    phi_7742_ = _e5560;
                } else {
                    phi_7741_ = type_28();
                    phi_7742_ = true;
                }
                let _e5562 = phi_7741_;
                let _e5564 = phi_7742_;
                if _e5564 {
                    let _e5566 = params.member.member.member_12;
                    let _e5567 = bitcast<u32>(_e5566);
                    let _e5568 = (_e5567 & 2147483647u);
                    if (_e5568 < 8388608u) {
                        phi_7760_ = array<u32, 2>(0u, 0u);
                    } else {
                        phi_7760_ = array<u32, 2>((_e5567 << bitcast<u32>(29i)), ((_e5567 ^ _e5568) | ((_e5568 >> bitcast<u32>(3i)) + 939524096u)));
                    }
                    let _e5579 = phi_7760_;
                    let _e5583 = params.member.member.member_15[0u];
                    if (_e5579[0] == _e5583) {
                        let _e5588 = params.member.member.member_15[1u];
                        phi_7774_ = (_e5579[1] == _e5588);
                    } else {
                        phi_7774_ = false;
                    }
                    let _e5591 = phi_7774_;
                    let _e5593 = params.member.member.member_5;
                    let _e5595 = params.member.member.member_11;
                    let _e5597 = params.member.member.member_12;
                    let _e5599 = params.member.member.member_13;
                    let _e5601 = params.member.member.member_1;
                    if ((_e5601 & 64u) != 0u) {
                        phi_7790_ = _e5591;
                    } else {
                        phi_7790_ = false;
                    }
                    let _e5605 = phi_7790_;
                    if (_e560.member[0][0] < 0f) {
                        phi_7798_ = -(_e560.member[0][0]);
                    } else {
                        phi_7798_ = _e560.member[0][0];
                    }
                    let _e5612 = phi_7798_;
                    if (_e560.member[0][1] < 0f) {
                        phi_7805_ = -(_e560.member[0][1]);
                    } else {
                        phi_7805_ = _e560.member[0][1];
                    }
                    let _e5617 = phi_7805_;
                    if (_e5612 > _e5617) {
                        phi_7810_ = _e5612;
                    } else {
                        phi_7810_ = _e5617;
                    }
                    let _e5620 = phi_7810_;
                    if (_e560.member[0][2] < 0f) {
                        phi_7817_ = -(_e560.member[0][2]);
                    } else {
                        phi_7817_ = _e560.member[0][2];
                    }
                    let _e5625 = phi_7817_;
                    if (_e5620 > _e5625) {
                        phi_7822_ = _e5620;
                    } else {
                        phi_7822_ = _e5625;
                    }
                    let _e5628 = phi_7822_;
                    if (_e560.member[1][0] < 0f) {
                        phi_7830_ = -(_e560.member[1][0]);
                    } else {
                        phi_7830_ = _e560.member[1][0];
                    }
                    let _e5635 = phi_7830_;
                    if (_e560.member[1][1] < 0f) {
                        phi_7837_ = -(_e560.member[1][1]);
                    } else {
                        phi_7837_ = _e560.member[1][1];
                    }
                    let _e5640 = phi_7837_;
                    if (_e5635 > _e5640) {
                        phi_7842_ = _e5635;
                    } else {
                        phi_7842_ = _e5640;
                    }
                    let _e5643 = phi_7842_;
                    if (_e560.member[1][2] < 0f) {
                        phi_7849_ = -(_e560.member[1][2]);
                    } else {
                        phi_7849_ = _e560.member[1][2];
                    }
                    let _e5648 = phi_7849_;
                    if (_e5643 > _e5648) {
                        phi_7854_ = _e5643;
                    } else {
                        phi_7854_ = _e5648;
                    }
                    let _e5651 = phi_7854_;
                    if (_e5628 > _e5651) {
                        phi_7859_ = _e5628;
                    } else {
                        phi_7859_ = _e5651;
                    }
                    let _e5654 = phi_7859_;
                    let _e5656 = (_e5654 + _e560.member_3);
                    if (_e560.member_1[0][0] < 0f) {
                        phi_7869_ = -(_e560.member_1[0][0]);
                    } else {
                        phi_7869_ = _e560.member_1[0][0];
                    }
                    let _e5663 = phi_7869_;
                    if (_e560.member_1[0][1] < 0f) {
                        phi_7876_ = -(_e560.member_1[0][1]);
                    } else {
                        phi_7876_ = _e560.member_1[0][1];
                    }
                    let _e5668 = phi_7876_;
                    if (_e5663 > _e5668) {
                        phi_7881_ = _e5663;
                    } else {
                        phi_7881_ = _e5668;
                    }
                    let _e5671 = phi_7881_;
                    if (_e560.member_1[0][2] < 0f) {
                        phi_7888_ = -(_e560.member_1[0][2]);
                    } else {
                        phi_7888_ = _e560.member_1[0][2];
                    }
                    let _e5676 = phi_7888_;
                    if (_e5671 > _e5676) {
                        phi_7893_ = _e5671;
                    } else {
                        phi_7893_ = _e5676;
                    }
                    let _e5679 = phi_7893_;
                    if (_e560.member_1[1][0] < 0f) {
                        phi_7901_ = -(_e560.member_1[1][0]);
                    } else {
                        phi_7901_ = _e560.member_1[1][0];
                    }
                    let _e5686 = phi_7901_;
                    if (_e560.member_1[1][1] < 0f) {
                        phi_7908_ = -(_e560.member_1[1][1]);
                    } else {
                        phi_7908_ = _e560.member_1[1][1];
                    }
                    let _e5691 = phi_7908_;
                    if (_e5686 > _e5691) {
                        phi_7913_ = _e5686;
                    } else {
                        phi_7913_ = _e5691;
                    }
                    let _e5694 = phi_7913_;
                    if (_e560.member_1[1][2] < 0f) {
                        phi_7920_ = -(_e560.member_1[1][2]);
                    } else {
                        phi_7920_ = _e560.member_1[1][2];
                    }
                    let _e5699 = phi_7920_;
                    if (_e5694 > _e5699) {
                        phi_7925_ = _e5694;
                    } else {
                        phi_7925_ = _e5699;
                    }
                    let _e5702 = phi_7925_;
                    if (_e5679 > _e5702) {
                        phi_7930_ = _e5679;
                    } else {
                        phi_7930_ = _e5702;
                    }
                    let _e5705 = phi_7930_;
                    let _e5707 = (_e5705 + _e560.member_3);
                    if (_e560.member_2[0][0] < 0f) {
                        phi_7940_ = -(_e560.member_2[0][0]);
                    } else {
                        phi_7940_ = _e560.member_2[0][0];
                    }
                    let _e5714 = phi_7940_;
                    if (_e560.member_2[0][1] < 0f) {
                        phi_7947_ = -(_e560.member_2[0][1]);
                    } else {
                        phi_7947_ = _e560.member_2[0][1];
                    }
                    let _e5719 = phi_7947_;
                    if (_e5714 > _e5719) {
                        phi_7952_ = _e5714;
                    } else {
                        phi_7952_ = _e5719;
                    }
                    let _e5722 = phi_7952_;
                    if (_e560.member_2[0][2] < 0f) {
                        phi_7959_ = -(_e560.member_2[0][2]);
                    } else {
                        phi_7959_ = _e560.member_2[0][2];
                    }
                    let _e5727 = phi_7959_;
                    if (_e5722 > _e5727) {
                        phi_7964_ = _e5722;
                    } else {
                        phi_7964_ = _e5727;
                    }
                    let _e5730 = phi_7964_;
                    if (_e560.member_2[1][0] < 0f) {
                        phi_7972_ = -(_e560.member_2[1][0]);
                    } else {
                        phi_7972_ = _e560.member_2[1][0];
                    }
                    let _e5737 = phi_7972_;
                    if (_e560.member_2[1][1] < 0f) {
                        phi_7979_ = -(_e560.member_2[1][1]);
                    } else {
                        phi_7979_ = _e560.member_2[1][1];
                    }
                    let _e5742 = phi_7979_;
                    if (_e5737 > _e5742) {
                        phi_7984_ = _e5737;
                    } else {
                        phi_7984_ = _e5742;
                    }
                    let _e5745 = phi_7984_;
                    if (_e560.member_2[1][2] < 0f) {
                        phi_7991_ = -(_e560.member_2[1][2]);
                    } else {
                        phi_7991_ = _e560.member_2[1][2];
                    }
                    let _e5750 = phi_7991_;
                    if (_e5745 > _e5750) {
                        phi_7996_ = _e5745;
                    } else {
                        phi_7996_ = _e5750;
                    }
                    let _e5753 = phi_7996_;
                    if (_e5730 > _e5753) {
                        phi_8001_ = _e5730;
                    } else {
                        phi_8001_ = _e5753;
                    }
                    let _e5756 = phi_8001_;
                    let _e5758 = (_e5756 + _e560.member_3);
                    if (_e5656 > _e5707) {
                        phi_8008_ = _e5656;
                    } else {
                        phi_8008_ = _e5707;
                    }
                    let _e5761 = phi_8008_;
                    if (_e5761 > _e5758) {
                        phi_8013_ = _e5761;
                    } else {
                        phi_8013_ = _e5758;
                    }
                    let _e5764 = phi_8013_;
                    if (_e5764 <= 65536f) {
                        phi_8020_ = (_e5764 >= (1f / 65536f));
                    } else {
                        phi_8020_ = false;
                    }
                    let _e5769 = phi_8020_;
                    if _e5769 {
                        phi_8118_ = type_43();
                        phi_8119_ = true;
                    } else {
                        if (_e5764 >= 0.000000000000000000000000000000000000011754944f) {
                            if ((bitcast<u32>(_e5764) & 2139095040u) != 2139095040u) {
                                let _e5776 = (2130706432u - (bitcast<u32>(_e5764) & 2139095040u));
                                if (_e5776 > 8388608u) {
                                    phi_8044_ = _e5776;
                                } else {
                                    phi_8044_ = 8388608u;
                                }
                                let _e5779 = phi_8044_;
                                let _e5780 = bitcast<f32>(_e5779);
                                let _e5781 = (_e5593 * _e5780);
                                if (_e5593 > 0f) {
                                    if (_e5781 > 0.000000000000000000000000000000000000011754944f) {
                                        phi_8055_ = _e5781;
                                    } else {
                                        phi_8055_ = 0.000000000000000000000000000000000000011754944f;
                                    }
                                    let _e5785 = phi_8055_;
                                    phi_8056_ = _e5785;
                                } else {
                                    phi_8056_ = _e5781;
                                }
                                let _e5787 = phi_8056_;
                                phi_8114_ = type_43(type_23(array<array<f32, 3>, 2>(array<f32, 3>((_e560.member[0][0] * _e5780), (_e560.member[0][1] * _e5780), (_e560.member[0][2] * _e5780)), array<f32, 3>((_e560.member[1][0] * _e5780), (_e560.member[1][1] * _e5780), (_e560.member[1][2] * _e5780))), array<array<f32, 3>, 2>(array<f32, 3>((_e560.member_1[0][0] * _e5780), (_e560.member_1[0][1] * _e5780), (_e560.member_1[0][2] * _e5780)), array<f32, 3>((_e560.member_1[1][0] * _e5780), (_e560.member_1[1][1] * _e5780), (_e560.member_1[1][2] * _e5780))), array<array<f32, 3>, 2>(array<f32, 3>((_e560.member_2[0][0] * _e5780), (_e560.member_2[0][1] * _e5780), (_e560.member_2[0][2] * _e5780)), array<f32, 3>((_e560.member_2[1][0] * _e5780), (_e560.member_2[1][1] * _e5780), (_e560.member_2[1][2] * _e5780))), ((_e560.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e5780)), _e5787);
                                phi_8115_ = false;
                            } else {
                                phi_8114_ = type_43();
                                phi_8115_ = true;
                            }
                            let _e5852 = phi_8114_;
                            let _e5854 = phi_8115_;
                            phi_8116_ = _e5852;
                            phi_8117_ = _e5854;
                        } else {
                            phi_8116_ = type_43();
                            phi_8117_ = true;
                        }
                        let _e5856 = phi_8116_;
                        let _e5858 = phi_8117_;
                        phi_8118_ = _e5856;
                        phi_8119_ = _e5858;
                    }
                    let _e5860 = phi_8118_;
                    let _e5862 = phi_8119_;
                    if _e5862 {
                        phi_8124_ = type_43(_e560, _e5593);
                    } else {
                        phi_8124_ = _e5860;
                    }
                    let _e5865 = phi_8124_;
                    local_18 = type_23(array<array<f32, 3>, 2>(array<f32, 3>(_e5865.member.member[0][0], _e5865.member.member[0][1], _e5865.member.member[0][2]), array<f32, 3>(_e5865.member.member[1][0], _e5865.member.member[1][1], _e5865.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e5865.member.member_1[0][0], _e5865.member.member_1[0][1], _e5865.member.member_1[0][2]), array<f32, 3>(_e5865.member.member_1[1][0], _e5865.member.member_1[1][1], _e5865.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e5865.member.member_2[0][0], _e5865.member.member_2[0][1], _e5865.member.member_2[0][2]), array<f32, 3>(_e5865.member.member_2[1][0], _e5865.member.member_2[1][1], _e5865.member.member_2[1][2])), _e5865.member.member_3);
                    if (_e5865.member_1 > 0f) {
                        let _e10630 = local_18.member[0u];
                        let _e10636 = local_18.member[1u];
                        let _e10652 = local_18.member_1[0u];
                        let _e10658 = local_18.member_1[1u];
                        let _e10674 = local_18.member_2[0u];
                        let _e10680 = local_18.member_2[1u];
                        let _e10694 = function_3(array<f32, 3>((_e10630[0] + ((_e10636[0] - _e10630[0]) * _e5597)), (_e10630[1] + ((_e10636[1] - _e10630[1]) * _e5597)), (_e10630[2] + ((_e10636[2] - _e10630[2]) * _e5597))), array<f32, 3>((_e10652[0] + ((_e10658[0] - _e10652[0]) * _e5597)), (_e10652[1] + ((_e10658[1] - _e10652[1]) * _e5597)), (_e10652[2] + ((_e10658[2] - _e10652[2]) * _e5597))), array<f32, 3>((_e10674[0] + ((_e10680[0] - _e10674[0]) * _e5597)), (_e10674[1] + ((_e10680[1] - _e10674[1]) * _e5597)), (_e10674[2] + ((_e10680[2] - _e10674[2]) * _e5597))), _e315.member);
                        let _e10705 = (((_e10694[0] * _e10694[0]) + (_e10694[1] * _e10694[1])) + (_e10694[2] * _e10694[2]));
                        if (_e10705 <= 0.000000000000000000000000000000000000011754944f) {
                            if (_e10705 > 0f) {
                                phi_8291_ = (0.000000000000000000106433627f * 2f);
                            } else {
                                phi_8291_ = 0f;
                            }
                            let _e10758 = phi_8291_;
                            phi_8355_ = _e10758;
                        } else {
                            phi_8298_ = type_14(0i, 5i);
                            phi_8301_ = bitcast<f32>(((bitcast<u32>(_e10705) >> bitcast<u32>(1i)) + 532369198u));
                            loop {
                                let _e10713 = phi_8298_;
                                let _e10715 = phi_8301_;
                                local_105 = _e10715;
                                if (_e10713.member < _e10713.member_1) {
                                    let _e10722 = (_e10713.member + 1i);
                                    if ((false == (_e10722 > _e10713.member)) != false) {
                                        phi_8322_ = true;
                                    } else {
                                        phi_8322_ = false;
                                    }
                                    let _e10727 = phi_8322_;
                                    if _e10727 {
                                        phi_8328_ = type_15(0u, type_15().member_1);
                                    } else {
                                        phi_8328_ = type_15(1u, _e10722);
                                    }
                                    let _e10732 = phi_8328_;
                                    phi_8299_ = type_14(_e10732.member_1, _e10713.member_1);
                                    phi_8342_ = type_15(1u, _e10713.member);
                                } else {
                                    phi_8299_ = _e10713;
                                    phi_8342_ = type_15(0u, type_15().member_1);
                                }
                                let _e10738 = phi_8299_;
                                let _e10740 = phi_8342_;
                                let _e10743 = (bitcast<i32>(_e10740.member) != 0i);
                                if _e10743 {
                                    phi_8302_ = (0.5f * (_e10715 + (_e10705 / _e10715)));
                                } else {
                                    phi_8302_ = f32();
                                }
                                let _e10748 = phi_8302_;
                                continue;
                                continuing {
                                    phi_8298_ = _e10738;
                                    phi_8301_ = _e10748;
                                    break if !(_e10743);
                                }
                            }
                            let _e10753 = local_105;
                            phi_8355_ = (_e10753 * (1f + (8f * 0.000000059604645f)));
                        }
                        let _e10760 = phi_8355_;
                        let _e10766 = local_18.member[0u];
                        if (_e10766[0] < 0f) {
                            phi_8371_ = -(_e10766[0]);
                        } else {
                            phi_8371_ = _e10766[0];
                        }
                        let _e10773 = phi_8371_;
                        if (_e10766[1] < 0f) {
                            phi_8378_ = -(_e10766[1]);
                        } else {
                            phi_8378_ = _e10766[1];
                        }
                        let _e10777 = phi_8378_;
                        if (_e10773 > _e10777) {
                            phi_8383_ = _e10773;
                        } else {
                            phi_8383_ = _e10777;
                        }
                        let _e10780 = phi_8383_;
                        if (_e10766[2] < 0f) {
                            phi_8390_ = -(_e10766[2]);
                        } else {
                            phi_8390_ = _e10766[2];
                        }
                        let _e10784 = phi_8390_;
                        if (_e10780 > _e10784) {
                            phi_8395_ = _e10780;
                        } else {
                            phi_8395_ = _e10784;
                        }
                        let _e10787 = phi_8395_;
                        let _e10790 = local_18.member[1u];
                        if (_e10790[0] < 0f) {
                            phi_8408_ = -(_e10790[0]);
                        } else {
                            phi_8408_ = _e10790[0];
                        }
                        let _e10797 = phi_8408_;
                        if (_e10790[1] < 0f) {
                            phi_8415_ = -(_e10790[1]);
                        } else {
                            phi_8415_ = _e10790[1];
                        }
                        let _e10801 = phi_8415_;
                        if (_e10797 > _e10801) {
                            phi_8420_ = _e10797;
                        } else {
                            phi_8420_ = _e10801;
                        }
                        let _e10804 = phi_8420_;
                        if (_e10790[2] < 0f) {
                            phi_8427_ = -(_e10790[2]);
                        } else {
                            phi_8427_ = _e10790[2];
                        }
                        let _e10808 = phi_8427_;
                        if (_e10804 > _e10808) {
                            phi_8432_ = _e10804;
                        } else {
                            phi_8432_ = _e10808;
                        }
                        let _e10811 = phi_8432_;
                        if (_e10787 > _e10811) {
                            phi_8437_ = _e10787;
                        } else {
                            phi_8437_ = _e10811;
                        }
                        let _e10814 = phi_8437_;
                        let _e10816 = local_18.member_3;
                        let _e10820 = local_18.member_1[0u];
                        if (_e10820[0] < 0f) {
                            phi_8454_ = -(_e10820[0]);
                        } else {
                            phi_8454_ = _e10820[0];
                        }
                        let _e10827 = phi_8454_;
                        if (_e10820[1] < 0f) {
                            phi_8461_ = -(_e10820[1]);
                        } else {
                            phi_8461_ = _e10820[1];
                        }
                        let _e10831 = phi_8461_;
                        if (_e10827 > _e10831) {
                            phi_8466_ = _e10827;
                        } else {
                            phi_8466_ = _e10831;
                        }
                        let _e10834 = phi_8466_;
                        if (_e10820[2] < 0f) {
                            phi_8473_ = -(_e10820[2]);
                        } else {
                            phi_8473_ = _e10820[2];
                        }
                        let _e10838 = phi_8473_;
                        if (_e10834 > _e10838) {
                            phi_8478_ = _e10834;
                        } else {
                            phi_8478_ = _e10838;
                        }
                        let _e10841 = phi_8478_;
                        let _e10844 = local_18.member_1[1u];
                        if (_e10844[0] < 0f) {
                            phi_8492_ = -(_e10844[0]);
                        } else {
                            phi_8492_ = _e10844[0];
                        }
                        let _e10851 = phi_8492_;
                        if (_e10844[1] < 0f) {
                            phi_8499_ = -(_e10844[1]);
                        } else {
                            phi_8499_ = _e10844[1];
                        }
                        let _e10855 = phi_8499_;
                        if (_e10851 > _e10855) {
                            phi_8504_ = _e10851;
                        } else {
                            phi_8504_ = _e10855;
                        }
                        let _e10858 = phi_8504_;
                        if (_e10844[2] < 0f) {
                            phi_8511_ = -(_e10844[2]);
                        } else {
                            phi_8511_ = _e10844[2];
                        }
                        let _e10862 = phi_8511_;
                        if (_e10858 > _e10862) {
                            phi_8516_ = _e10858;
                        } else {
                            phi_8516_ = _e10862;
                        }
                        let _e10865 = phi_8516_;
                        if (_e10841 > _e10865) {
                            phi_8521_ = _e10841;
                        } else {
                            phi_8521_ = _e10865;
                        }
                        let _e10868 = phi_8521_;
                        let _e10870 = local_18.member_3;
                        let _e10874 = local_18.member_2[0u];
                        if (_e10874[0] < 0f) {
                            phi_8538_ = -(_e10874[0]);
                        } else {
                            phi_8538_ = _e10874[0];
                        }
                        let _e10881 = phi_8538_;
                        if (_e10874[1] < 0f) {
                            phi_8545_ = -(_e10874[1]);
                        } else {
                            phi_8545_ = _e10874[1];
                        }
                        let _e10885 = phi_8545_;
                        if (_e10881 > _e10885) {
                            phi_8550_ = _e10881;
                        } else {
                            phi_8550_ = _e10885;
                        }
                        let _e10888 = phi_8550_;
                        if (_e10874[2] < 0f) {
                            phi_8557_ = -(_e10874[2]);
                        } else {
                            phi_8557_ = _e10874[2];
                        }
                        let _e10892 = phi_8557_;
                        if (_e10888 > _e10892) {
                            phi_8562_ = _e10888;
                        } else {
                            phi_8562_ = _e10892;
                        }
                        let _e10895 = phi_8562_;
                        let _e10898 = local_18.member_2[1u];
                        if (_e10898[0] < 0f) {
                            phi_8576_ = -(_e10898[0]);
                        } else {
                            phi_8576_ = _e10898[0];
                        }
                        let _e10905 = phi_8576_;
                        if (_e10898[1] < 0f) {
                            phi_8583_ = -(_e10898[1]);
                        } else {
                            phi_8583_ = _e10898[1];
                        }
                        let _e10909 = phi_8583_;
                        if (_e10905 > _e10909) {
                            phi_8588_ = _e10905;
                        } else {
                            phi_8588_ = _e10909;
                        }
                        let _e10912 = phi_8588_;
                        if (_e10898[2] < 0f) {
                            phi_8595_ = -(_e10898[2]);
                        } else {
                            phi_8595_ = _e10898[2];
                        }
                        let _e10916 = phi_8595_;
                        if (_e10912 > _e10916) {
                            phi_8600_ = _e10912;
                        } else {
                            phi_8600_ = _e10916;
                        }
                        let _e10919 = phi_8600_;
                        if (_e10895 > _e10919) {
                            phi_8605_ = _e10895;
                        } else {
                            phi_8605_ = _e10919;
                        }
                        let _e10922 = phi_8605_;
                        let _e10924 = local_18.member_3;
                        let _e10931 = local_18.member_3;
                        let _e10938 = (((_e10760 * (1f + (0.000000059604645f * 8f))) + (((((((_e10814 + _e10816) + (_e10868 + _e10870)) + (_e10922 + _e10924)) * (0.000000059604645f * 16f)) + (_e10931 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e5865.member_1);
                        if _e10938 {
                            phi_9266_ = type_45();
                            phi_9267_ = true;
                        } else {
                            let _e10941 = local_18.member_1[0u];
                            let _e10947 = local_18.member_2[0u];
                            let _e10953 = ((_e10941[1] * _e10947[2]) - (_e10941[2] * _e10947[1]));
                            let _e10956 = ((_e10941[2] * _e10947[0]) - (_e10941[0] * _e10947[2]));
                            let _e10959 = ((_e10941[0] * _e10947[1]) - (_e10941[1] * _e10947[0]));
                            let _e10962 = local_18.member_1[1u];
                            let _e10968 = local_18.member_2[1u];
                            let _e10974 = ((_e10962[1] * _e10968[2]) - (_e10962[2] * _e10968[1]));
                            let _e10977 = ((_e10962[2] * _e10968[0]) - (_e10962[0] * _e10968[2]));
                            let _e10980 = ((_e10962[0] * _e10968[1]) - (_e10962[1] * _e10968[0]));
                            let _e10983 = local_18.member_1[0u];
                            let _e10989 = local_18.member_2[1u];
                            let _e11004 = local_18.member_1[1u];
                            let _e11010 = local_18.member_2[0u];
                            let _e11023 = (((_e10983[1] * _e10989[2]) - (_e10983[2] * _e10989[1])) + ((_e11004[1] * _e11010[2]) - (_e11004[2] * _e11010[1])));
                            let _e11024 = (((_e10983[2] * _e10989[0]) - (_e10983[0] * _e10989[2])) + ((_e11004[2] * _e11010[0]) - (_e11004[0] * _e11010[2])));
                            let _e11025 = (((_e10983[0] * _e10989[1]) - (_e10983[1] * _e10989[0])) + ((_e11004[0] * _e11010[1]) - (_e11004[1] * _e11010[0])));
                            let _e11028 = local_18.member[0u];
                            let _e11039 = local_18.member[1u];
                            let _e11050 = local_18.member[0u];
                            let _e11059 = ((((_e11039[0] * _e10953) + (_e11039[1] * _e10956)) + (_e11039[2] * _e10959)) + (((_e11050[0] * _e11023) + (_e11050[1] * _e11024)) + (_e11050[2] * _e11025)));
                            let _e11062 = local_18.member[0u];
                            let _e11073 = local_18.member[1u];
                            let _e11082 = ((((_e11062[0] * _e10974) + (_e11062[1] * _e10977)) + (_e11062[2] * _e10980)) + (((_e11073[0] * _e11023) + (_e11073[1] * _e11024)) + (_e11073[2] * _e11025)));
                            let _e11085 = local_18.member[1u];
                            let _e11096 = local_18.member[0u];
                            if (_e11096[0] < 0f) {
                                phi_8866_ = -(_e11096[0]);
                            } else {
                                phi_8866_ = _e11096[0];
                            }
                            let _e11103 = phi_8866_;
                            if (_e11096[1] < 0f) {
                                phi_8873_ = -(_e11096[1]);
                            } else {
                                phi_8873_ = _e11096[1];
                            }
                            let _e11107 = phi_8873_;
                            if (_e11103 > _e11107) {
                                phi_8878_ = _e11103;
                            } else {
                                phi_8878_ = _e11107;
                            }
                            let _e11110 = phi_8878_;
                            if (_e11096[2] < 0f) {
                                phi_8885_ = -(_e11096[2]);
                            } else {
                                phi_8885_ = _e11096[2];
                            }
                            let _e11114 = phi_8885_;
                            if (_e11110 > _e11114) {
                                phi_8890_ = _e11110;
                            } else {
                                phi_8890_ = _e11114;
                            }
                            let _e11117 = phi_8890_;
                            let _e11120 = local_18.member[1u];
                            if (_e11120[0] < 0f) {
                                phi_8903_ = -(_e11120[0]);
                            } else {
                                phi_8903_ = _e11120[0];
                            }
                            let _e11127 = phi_8903_;
                            if (_e11120[1] < 0f) {
                                phi_8910_ = -(_e11120[1]);
                            } else {
                                phi_8910_ = _e11120[1];
                            }
                            let _e11131 = phi_8910_;
                            if (_e11127 > _e11131) {
                                phi_8915_ = _e11127;
                            } else {
                                phi_8915_ = _e11131;
                            }
                            let _e11134 = phi_8915_;
                            if (_e11120[2] < 0f) {
                                phi_8922_ = -(_e11120[2]);
                            } else {
                                phi_8922_ = _e11120[2];
                            }
                            let _e11138 = phi_8922_;
                            if (_e11134 > _e11138) {
                                phi_8927_ = _e11134;
                            } else {
                                phi_8927_ = _e11138;
                            }
                            let _e11141 = phi_8927_;
                            if (_e11117 > _e11141) {
                                phi_8932_ = _e11117;
                            } else {
                                phi_8932_ = _e11141;
                            }
                            let _e11144 = phi_8932_;
                            let _e11146 = local_18.member_3;
                            let _e11147 = (_e11144 + _e11146);
                            let _e11150 = local_18.member_1[0u];
                            if (_e11150[0] < 0f) {
                                phi_8949_ = -(_e11150[0]);
                            } else {
                                phi_8949_ = _e11150[0];
                            }
                            let _e11157 = phi_8949_;
                            if (_e11150[1] < 0f) {
                                phi_8956_ = -(_e11150[1]);
                            } else {
                                phi_8956_ = _e11150[1];
                            }
                            let _e11161 = phi_8956_;
                            if (_e11157 > _e11161) {
                                phi_8961_ = _e11157;
                            } else {
                                phi_8961_ = _e11161;
                            }
                            let _e11164 = phi_8961_;
                            if (_e11150[2] < 0f) {
                                phi_8968_ = -(_e11150[2]);
                            } else {
                                phi_8968_ = _e11150[2];
                            }
                            let _e11168 = phi_8968_;
                            if (_e11164 > _e11168) {
                                phi_8973_ = _e11164;
                            } else {
                                phi_8973_ = _e11168;
                            }
                            let _e11171 = phi_8973_;
                            let _e11174 = local_18.member_1[1u];
                            if (_e11174[0] < 0f) {
                                phi_8987_ = -(_e11174[0]);
                            } else {
                                phi_8987_ = _e11174[0];
                            }
                            let _e11181 = phi_8987_;
                            if (_e11174[1] < 0f) {
                                phi_8994_ = -(_e11174[1]);
                            } else {
                                phi_8994_ = _e11174[1];
                            }
                            let _e11185 = phi_8994_;
                            if (_e11181 > _e11185) {
                                phi_8999_ = _e11181;
                            } else {
                                phi_8999_ = _e11185;
                            }
                            let _e11188 = phi_8999_;
                            if (_e11174[2] < 0f) {
                                phi_9006_ = -(_e11174[2]);
                            } else {
                                phi_9006_ = _e11174[2];
                            }
                            let _e11192 = phi_9006_;
                            if (_e11188 > _e11192) {
                                phi_9011_ = _e11188;
                            } else {
                                phi_9011_ = _e11192;
                            }
                            let _e11195 = phi_9011_;
                            if (_e11171 > _e11195) {
                                phi_9016_ = _e11171;
                            } else {
                                phi_9016_ = _e11195;
                            }
                            let _e11198 = phi_9016_;
                            let _e11200 = local_18.member_3;
                            let _e11201 = (_e11198 + _e11200);
                            let _e11204 = local_18.member_2[0u];
                            if (_e11204[0] < 0f) {
                                phi_9033_ = -(_e11204[0]);
                            } else {
                                phi_9033_ = _e11204[0];
                            }
                            let _e11211 = phi_9033_;
                            if (_e11204[1] < 0f) {
                                phi_9040_ = -(_e11204[1]);
                            } else {
                                phi_9040_ = _e11204[1];
                            }
                            let _e11215 = phi_9040_;
                            if (_e11211 > _e11215) {
                                phi_9045_ = _e11211;
                            } else {
                                phi_9045_ = _e11215;
                            }
                            let _e11218 = phi_9045_;
                            if (_e11204[2] < 0f) {
                                phi_9052_ = -(_e11204[2]);
                            } else {
                                phi_9052_ = _e11204[2];
                            }
                            let _e11222 = phi_9052_;
                            if (_e11218 > _e11222) {
                                phi_9057_ = _e11218;
                            } else {
                                phi_9057_ = _e11222;
                            }
                            let _e11225 = phi_9057_;
                            let _e11228 = local_18.member_2[1u];
                            if (_e11228[0] < 0f) {
                                phi_9071_ = -(_e11228[0]);
                            } else {
                                phi_9071_ = _e11228[0];
                            }
                            let _e11235 = phi_9071_;
                            if (_e11228[1] < 0f) {
                                phi_9078_ = -(_e11228[1]);
                            } else {
                                phi_9078_ = _e11228[1];
                            }
                            let _e11239 = phi_9078_;
                            if (_e11235 > _e11239) {
                                phi_9083_ = _e11235;
                            } else {
                                phi_9083_ = _e11239;
                            }
                            let _e11242 = phi_9083_;
                            if (_e11228[2] < 0f) {
                                phi_9090_ = -(_e11228[2]);
                            } else {
                                phi_9090_ = _e11228[2];
                            }
                            let _e11246 = phi_9090_;
                            if (_e11242 > _e11246) {
                                phi_9095_ = _e11242;
                            } else {
                                phi_9095_ = _e11246;
                            }
                            let _e11249 = phi_9095_;
                            if (_e11225 > _e11249) {
                                phi_9100_ = _e11225;
                            } else {
                                phi_9100_ = _e11249;
                            }
                            let _e11252 = phi_9100_;
                            let _e11254 = local_18.member_3;
                            let _e11255 = (_e11252 + _e11254);
                            let _e11257 = ((_e11201 * 8f) * _e11255);
                            let _e11264 = local_18.member_3;
                            if (_e10953 < 0f) {
                                phi_9131_ = -(_e10953);
                            } else {
                                phi_9131_ = _e10953;
                            }
                            let _e11281 = phi_9131_;
                            if (_e10956 < 0f) {
                                phi_9137_ = -(_e10956);
                            } else {
                                phi_9137_ = _e10956;
                            }
                            let _e11285 = phi_9137_;
                            if (_e10959 < 0f) {
                                phi_9144_ = -(_e10959);
                            } else {
                                phi_9144_ = _e10959;
                            }
                            let _e11290 = phi_9144_;
                            let _e11291 = ((_e11281 + _e11285) + _e11290);
                            if (_e10974 < 0f) {
                                phi_9151_ = -(_e10974);
                            } else {
                                phi_9151_ = _e10974;
                            }
                            let _e11295 = phi_9151_;
                            if (_e10977 < 0f) {
                                phi_9157_ = -(_e10977);
                            } else {
                                phi_9157_ = _e10977;
                            }
                            let _e11299 = phi_9157_;
                            if (_e10980 < 0f) {
                                phi_9164_ = -(_e10980);
                            } else {
                                phi_9164_ = _e10980;
                            }
                            let _e11304 = phi_9164_;
                            let _e11305 = ((_e11295 + _e11299) + _e11304);
                            if (_e11291 > _e11305) {
                                phi_9170_ = _e11291;
                            } else {
                                phi_9170_ = _e11305;
                            }
                            let _e11308 = phi_9170_;
                            if (_e11023 < 0f) {
                                phi_9176_ = -(_e11023);
                            } else {
                                phi_9176_ = _e11023;
                            }
                            let _e11312 = phi_9176_;
                            if (_e11024 < 0f) {
                                phi_9182_ = -(_e11024);
                            } else {
                                phi_9182_ = _e11024;
                            }
                            let _e11316 = phi_9182_;
                            if (_e11025 < 0f) {
                                phi_9189_ = -(_e11025);
                            } else {
                                phi_9189_ = _e11025;
                            }
                            let _e11321 = phi_9189_;
                            let _e11323 = (((_e11312 + _e11316) + _e11321) * 0.5f);
                            if (_e11308 > _e11323) {
                                phi_9196_ = _e11308;
                            } else {
                                phi_9196_ = _e11323;
                            }
                            let _e11326 = phi_9196_;
                            let _e11331 = local_18.member_3;
                            let _e11344 = ((((_e11028[0] * _e10953) + (_e11028[1] * _e10956)) + (_e11028[2] * _e10959)) * 3f);
                            let _e11345 = ((((_e11085[0] * _e10974) + (_e11085[1] * _e10977)) + (_e11085[2] * _e10980)) * 3f);
                            if (_e11344 < _e11345) {
                                phi_9220_ = _e11344;
                            } else {
                                phi_9220_ = _e11345;
                            }
                            let _e11348 = phi_9220_;
                            if (_e11059 < _e11082) {
                                phi_9225_ = _e11059;
                            } else {
                                phi_9225_ = _e11082;
                            }
                            let _e11351 = phi_9225_;
                            if (_e11348 < _e11351) {
                                phi_9230_ = _e11348;
                            } else {
                                phi_9230_ = _e11351;
                            }
                            let _e11354 = phi_9230_;
                            if (_e11344 > _e11345) {
                                phi_9235_ = _e11344;
                            } else {
                                phi_9235_ = _e11345;
                            }
                            let _e11357 = phi_9235_;
                            if (_e11059 > _e11082) {
                                phi_9240_ = _e11059;
                            } else {
                                phi_9240_ = _e11082;
                            }
                            let _e11360 = phi_9240_;
                            if (_e11357 > _e11360) {
                                phi_9245_ = _e11357;
                            } else {
                                phi_9245_ = _e11360;
                            }
                            let _e11363 = phi_9245_;
                            let _e11368 = -(_e11363);
                            if (_e11354 > _e11368) {
                                phi_9255_ = _e11354;
                            } else {
                                phi_9255_ = _e11368;
                            }
                            let _e11371 = phi_9255_;
                            if ((_e11371 - ((((((_e11147 * 8f) * _e11257) * (0.000000059604645f * (524f / 64f))) + ((_e11264 * 19f) * ((_e11147 * (_e11201 + _e11255)) + (_e11201 * _e11255)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e11147) * ((1f + _e11201) * (1f + _e11255))))) + ((_e5865.member_1 * (((_e11326 + (_e11257 * (0.000000059604645f * 8f))) + ((_e11331 * 6f) * (_e11201 + _e11255))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e11201) * (1f + _e11255))))) * (3f * 1.0001f)))) > 0f) {
                                phi_9264_ = type_45(type_44(0u, f32()), 0u);
                                phi_9265_ = false;
                            } else {
                                phi_9264_ = type_45();
                                phi_9265_ = true;
                            }
                            let _e11377 = phi_9264_;
                            let _e11379 = phi_9265_;
                            phi_9266_ = _e11377;
                            phi_9267_ = _e11379;
                        }
                        let _e11381 = phi_9266_;
                        let _e11383 = phi_9267_;
                        if _e11383 {
                            phi_9273_ = type_14(0i, 2i);
                            phi_9276_ = _e5597;
                            phi_9278_ = 0u;
                            phi_9280_ = _e5597;
                            loop {
                                let _e11385 = phi_9273_;
                                let _e11387 = phi_9276_;
                                let _e11389 = phi_9278_;
                                let _e11391 = phi_9280_;
                                local_167 = _e11389;
                                local_170 = _e11387;
                                local_171 = _e11389;
                                if (_e11385.member < _e11385.member_1) {
                                    let _e11398 = (_e11385.member + 1i);
                                    if ((false == (_e11398 > _e11385.member)) != false) {
                                        phi_9301_ = true;
                                    } else {
                                        phi_9301_ = false;
                                    }
                                    let _e11403 = phi_9301_;
                                    if _e11403 {
                                        phi_9307_ = type_15(0u, type_15().member_1);
                                    } else {
                                        phi_9307_ = type_15(1u, _e11398);
                                    }
                                    let _e11408 = phi_9307_;
                                    phi_9274_ = type_14(_e11408.member_1, _e11385.member_1);
                                    phi_9321_ = type_15(1u, _e11385.member);
                                } else {
                                    phi_9274_ = _e11385;
                                    phi_9321_ = type_15(0u, type_15().member_1);
                                }
                                let _e11414 = phi_9274_;
                                let _e11416 = phi_9321_;
                                if (bitcast<i32>(_e11416.member) != 0i) {
                                    if (_e11416.member_1 > 0i) {
                                        phi_9337_ = true;
                                    } else {
                                        if _e10938 {
                                            phi_9336_ = false;
                                        } else {
                                            phi_9336_ = true;
                                        }
                                        let _e11423 = phi_9336_;
                                        phi_9337_ = _e11423;
                                    }
                                    let _e11425 = phi_9337_;
                                    if _e11425 {
                                        let _e11428 = local_18.member[0u];
                                        let _e11435 = local_18.member_1[0u];
                                        let _e11441 = local_18.member_2[0u];
                                        let _e11445 = (_e11428[0] - _e11435[0]);
                                        let _e11446 = (_e11428[1] - _e11435[1]);
                                        let _e11447 = (_e11428[2] - _e11435[2]);
                                        if (_e315.member == 0u) {
                                            phi_9396_ = array<f32, 3>(_e11428[0], _e11428[1], _e11428[2]);
                                        } else {
                                            phi_9396_ = array<f32, 3>((_e11445 - _e11441[0]), (_e11446 - _e11441[1]), (_e11447 - _e11441[2]));
                                        }
                                        let _e11454 = phi_9396_;
                                        let _e11460 = local_18.member[1u];
                                        let _e11467 = local_18.member_1[1u];
                                        let _e11473 = local_18.member_2[1u];
                                        let _e11477 = (_e11460[0] - _e11467[0]);
                                        let _e11478 = (_e11460[1] - _e11467[1]);
                                        let _e11479 = (_e11460[2] - _e11467[2]);
                                        if (_e315.member == 0u) {
                                            phi_9461_ = array<f32, 3>(_e11460[0], _e11460[1], _e11460[2]);
                                        } else {
                                            phi_9461_ = array<f32, 3>((_e11477 - _e11473[0]), (_e11478 - _e11473[1]), (_e11479 - _e11473[2]));
                                        }
                                        let _e11486 = phi_9461_;
                                        let _e11492 = local_18.member[0u];
                                        if (_e11492[0] < 0f) {
                                            phi_9483_ = -(_e11492[0]);
                                        } else {
                                            phi_9483_ = _e11492[0];
                                        }
                                        let _e11499 = phi_9483_;
                                        if (_e11492[1] < 0f) {
                                            phi_9490_ = -(_e11492[1]);
                                        } else {
                                            phi_9490_ = _e11492[1];
                                        }
                                        let _e11503 = phi_9490_;
                                        if (_e11499 > _e11503) {
                                            phi_9495_ = _e11499;
                                        } else {
                                            phi_9495_ = _e11503;
                                        }
                                        let _e11506 = phi_9495_;
                                        if (_e11492[2] < 0f) {
                                            phi_9502_ = -(_e11492[2]);
                                        } else {
                                            phi_9502_ = _e11492[2];
                                        }
                                        let _e11510 = phi_9502_;
                                        if (_e11506 > _e11510) {
                                            phi_9507_ = _e11506;
                                        } else {
                                            phi_9507_ = _e11510;
                                        }
                                        let _e11513 = phi_9507_;
                                        let _e11516 = local_18.member[1u];
                                        if (_e11516[0] < 0f) {
                                            phi_9520_ = -(_e11516[0]);
                                        } else {
                                            phi_9520_ = _e11516[0];
                                        }
                                        let _e11523 = phi_9520_;
                                        if (_e11516[1] < 0f) {
                                            phi_9527_ = -(_e11516[1]);
                                        } else {
                                            phi_9527_ = _e11516[1];
                                        }
                                        let _e11527 = phi_9527_;
                                        if (_e11523 > _e11527) {
                                            phi_9532_ = _e11523;
                                        } else {
                                            phi_9532_ = _e11527;
                                        }
                                        let _e11530 = phi_9532_;
                                        if (_e11516[2] < 0f) {
                                            phi_9539_ = -(_e11516[2]);
                                        } else {
                                            phi_9539_ = _e11516[2];
                                        }
                                        let _e11534 = phi_9539_;
                                        if (_e11530 > _e11534) {
                                            phi_9544_ = _e11530;
                                        } else {
                                            phi_9544_ = _e11534;
                                        }
                                        let _e11537 = phi_9544_;
                                        if (_e11513 > _e11537) {
                                            phi_9549_ = _e11513;
                                        } else {
                                            phi_9549_ = _e11537;
                                        }
                                        let _e11540 = phi_9549_;
                                        let _e11542 = local_18.member_3;
                                        let _e11546 = local_18.member_1[0u];
                                        if (_e11546[0] < 0f) {
                                            phi_9566_ = -(_e11546[0]);
                                        } else {
                                            phi_9566_ = _e11546[0];
                                        }
                                        let _e11553 = phi_9566_;
                                        if (_e11546[1] < 0f) {
                                            phi_9573_ = -(_e11546[1]);
                                        } else {
                                            phi_9573_ = _e11546[1];
                                        }
                                        let _e11557 = phi_9573_;
                                        if (_e11553 > _e11557) {
                                            phi_9578_ = _e11553;
                                        } else {
                                            phi_9578_ = _e11557;
                                        }
                                        let _e11560 = phi_9578_;
                                        if (_e11546[2] < 0f) {
                                            phi_9585_ = -(_e11546[2]);
                                        } else {
                                            phi_9585_ = _e11546[2];
                                        }
                                        let _e11564 = phi_9585_;
                                        if (_e11560 > _e11564) {
                                            phi_9590_ = _e11560;
                                        } else {
                                            phi_9590_ = _e11564;
                                        }
                                        let _e11567 = phi_9590_;
                                        let _e11570 = local_18.member_1[1u];
                                        if (_e11570[0] < 0f) {
                                            phi_9604_ = -(_e11570[0]);
                                        } else {
                                            phi_9604_ = _e11570[0];
                                        }
                                        let _e11577 = phi_9604_;
                                        if (_e11570[1] < 0f) {
                                            phi_9611_ = -(_e11570[1]);
                                        } else {
                                            phi_9611_ = _e11570[1];
                                        }
                                        let _e11581 = phi_9611_;
                                        if (_e11577 > _e11581) {
                                            phi_9616_ = _e11577;
                                        } else {
                                            phi_9616_ = _e11581;
                                        }
                                        let _e11584 = phi_9616_;
                                        if (_e11570[2] < 0f) {
                                            phi_9623_ = -(_e11570[2]);
                                        } else {
                                            phi_9623_ = _e11570[2];
                                        }
                                        let _e11588 = phi_9623_;
                                        if (_e11584 > _e11588) {
                                            phi_9628_ = _e11584;
                                        } else {
                                            phi_9628_ = _e11588;
                                        }
                                        let _e11591 = phi_9628_;
                                        if (_e11567 > _e11591) {
                                            phi_9633_ = _e11567;
                                        } else {
                                            phi_9633_ = _e11591;
                                        }
                                        let _e11594 = phi_9633_;
                                        let _e11596 = local_18.member_3;
                                        let _e11600 = local_18.member_2[0u];
                                        if (_e11600[0] < 0f) {
                                            phi_9650_ = -(_e11600[0]);
                                        } else {
                                            phi_9650_ = _e11600[0];
                                        }
                                        let _e11607 = phi_9650_;
                                        if (_e11600[1] < 0f) {
                                            phi_9657_ = -(_e11600[1]);
                                        } else {
                                            phi_9657_ = _e11600[1];
                                        }
                                        let _e11611 = phi_9657_;
                                        if (_e11607 > _e11611) {
                                            phi_9662_ = _e11607;
                                        } else {
                                            phi_9662_ = _e11611;
                                        }
                                        let _e11614 = phi_9662_;
                                        if (_e11600[2] < 0f) {
                                            phi_9669_ = -(_e11600[2]);
                                        } else {
                                            phi_9669_ = _e11600[2];
                                        }
                                        let _e11618 = phi_9669_;
                                        if (_e11614 > _e11618) {
                                            phi_9674_ = _e11614;
                                        } else {
                                            phi_9674_ = _e11618;
                                        }
                                        let _e11621 = phi_9674_;
                                        let _e11624 = local_18.member_2[1u];
                                        if (_e11624[0] < 0f) {
                                            phi_9688_ = -(_e11624[0]);
                                        } else {
                                            phi_9688_ = _e11624[0];
                                        }
                                        let _e11631 = phi_9688_;
                                        if (_e11624[1] < 0f) {
                                            phi_9695_ = -(_e11624[1]);
                                        } else {
                                            phi_9695_ = _e11624[1];
                                        }
                                        let _e11635 = phi_9695_;
                                        if (_e11631 > _e11635) {
                                            phi_9700_ = _e11631;
                                        } else {
                                            phi_9700_ = _e11635;
                                        }
                                        let _e11638 = phi_9700_;
                                        if (_e11624[2] < 0f) {
                                            phi_9707_ = -(_e11624[2]);
                                        } else {
                                            phi_9707_ = _e11624[2];
                                        }
                                        let _e11642 = phi_9707_;
                                        if (_e11638 > _e11642) {
                                            phi_9712_ = _e11638;
                                        } else {
                                            phi_9712_ = _e11642;
                                        }
                                        let _e11645 = phi_9712_;
                                        if (_e11621 > _e11645) {
                                            phi_9717_ = _e11621;
                                        } else {
                                            phi_9717_ = _e11645;
                                        }
                                        let _e11648 = phi_9717_;
                                        let _e11650 = local_18.member_3;
                                        let _e11657 = local_18.member_3;
                                        let _e11662 = (_e5595 * 0.00390625f);
                                        local_16 = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        phi_9758_ = type_9(0u, 96u);
                                        phi_9761_ = _e11391;
                                        phi_9763_ = _e11391;
                                        phi_9765_ = (_e5599 - _e11391);
                                        phi_9767_ = _e11391;
                                        phi_9769_ = false;
                                        phi_9771_ = 0u;
                                        loop {
                                            let _e11665 = phi_9758_;
                                            let _e11667 = phi_9761_;
                                            let _e11669 = phi_9763_;
                                            let _e11671 = phi_9765_;
                                            let _e11673 = phi_9767_;
                                            let _e11675 = phi_9769_;
                                            let _e11677 = phi_9771_;
                                            local_109 = _e11667;
                                            local_157 = _e11669;
                                            if (_e11665.member < _e11665.member_1) {
                                                phi_9759_ = type_9((_e11665.member + 1u), _e11665.member_1);
                                                phi_9794_ = type_9(1u, _e11665.member);
                                            } else {
                                                phi_9759_ = _e11665;
                                                phi_9794_ = type_9(0u, type_9().member_1);
                                            }
                                            let _e11689 = phi_9759_;
                                            let _e11691 = phi_9794_;
                                            if (bitcast<i32>(_e11691.member) != 0i) {
                                                let _e11697 = local_18.member[0u];
                                                let _e11703 = local_18.member[1u];
                                                let _e11719 = local_18.member_1[0u];
                                                let _e11725 = local_18.member_1[1u];
                                                let _e11741 = local_18.member_2[0u];
                                                let _e11747 = local_18.member_2[1u];
                                                let _e11761 = function_3(array<f32, 3>((_e11697[0] + ((_e11703[0] - _e11697[0]) * _e11667)), (_e11697[1] + ((_e11703[1] - _e11697[1]) * _e11667)), (_e11697[2] + ((_e11703[2] - _e11697[2]) * _e11667))), array<f32, 3>((_e11719[0] + ((_e11725[0] - _e11719[0]) * _e11667)), (_e11719[1] + ((_e11725[1] - _e11719[1]) * _e11667)), (_e11719[2] + ((_e11725[2] - _e11719[2]) * _e11667))), array<f32, 3>((_e11741[0] + ((_e11747[0] - _e11741[0]) * _e11667)), (_e11741[1] + ((_e11747[1] - _e11741[1]) * _e11667)), (_e11741[2] + ((_e11747[2] - _e11741[2]) * _e11667))), _e315.member);
                                                if (_e11677 == 0u) {
                                                    phi_9922_ = _e11761;
                                                } else {
                                                    if (_e11677 == 1u) {
                                                        phi_9908_ = _e11761[0];
                                                    } else {
                                                        phi_9908_ = 0f;
                                                    }
                                                    let _e11766 = phi_9908_;
                                                    if (_e11677 == 2u) {
                                                        phi_9914_ = _e11761[1];
                                                    } else {
                                                        phi_9914_ = 0f;
                                                    }
                                                    let _e11770 = phi_9914_;
                                                    if (_e11677 == 3u) {
                                                        phi_9920_ = _e11761[2];
                                                    } else {
                                                        phi_9920_ = 0f;
                                                    }
                                                    let _e11774 = phi_9920_;
                                                    phi_9922_ = array<f32, 3>(_e11766, _e11770, _e11774);
                                                }
                                                let _e11777 = phi_9922_;
                                                if (_e11777[0] < 0f) {
                                                    phi_9929_ = -(_e11777[0]);
                                                } else {
                                                    phi_9929_ = _e11777[0];
                                                }
                                                let _e11782 = phi_9929_;
                                                if (_e11777[1] < 0f) {
                                                    phi_9936_ = -(_e11777[1]);
                                                } else {
                                                    phi_9936_ = _e11777[1];
                                                }
                                                let _e11787 = phi_9936_;
                                                if (_e11777[2] < 0f) {
                                                    phi_9944_ = -(_e11777[2]);
                                                } else {
                                                    phi_9944_ = _e11777[2];
                                                }
                                                let _e11793 = phi_9944_;
                                                let _e11794 = ((_e11782 + _e11787) + _e11793);
                                                if (_e11794 > 0f) {
                                                    if ((bitcast<u32>(_e11794) & 2139095040u) != 2139095040u) {
                                                        let _e11799 = (1f / _e11794);
                                                        let _e11801 = (_e11777[0] * _e11799);
                                                        let _e11803 = (_e11777[1] * _e11799);
                                                        let _e11805 = (_e11777[2] * _e11799);
                                                        let _e11810 = (((_e11801 * _e11801) + (_e11803 * _e11803)) + (_e11805 * _e11805));
                                                        if (_e11810 <= 0.000000000000000000000000000000000000011754944f) {
                                                            if (_e11810 > 0f) {
                                                                phi_9981_ = (0.000000000000000000106433627f * 2f);
                                                            } else {
                                                                phi_9981_ = 0f;
                                                            }
                                                            let _e11863 = phi_9981_;
                                                            phi_10045_ = _e11863;
                                                        } else {
                                                            phi_9988_ = type_14(0i, 5i);
                                                            phi_9991_ = bitcast<f32>(((bitcast<u32>(_e11810) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e11818 = phi_9988_;
                                                                let _e11820 = phi_9991_;
                                                                local_106 = _e11820;
                                                                if (_e11818.member < _e11818.member_1) {
                                                                    let _e11827 = (_e11818.member + 1i);
                                                                    if ((false == (_e11827 > _e11818.member)) != false) {
                                                                        phi_10012_ = true;
                                                                    } else {
                                                                        phi_10012_ = false;
                                                                    }
                                                                    let _e11832 = phi_10012_;
                                                                    if _e11832 {
                                                                        phi_10018_ = type_15(0u, type_15().member_1);
                                                                    } else {
                                                                        phi_10018_ = type_15(1u, _e11827);
                                                                    }
                                                                    let _e11837 = phi_10018_;
                                                                    phi_9989_ = type_14(_e11837.member_1, _e11818.member_1);
                                                                    phi_10032_ = type_15(1u, _e11818.member);
                                                                } else {
                                                                    phi_9989_ = _e11818;
                                                                    phi_10032_ = type_15(0u, type_15().member_1);
                                                                }
                                                                let _e11843 = phi_9989_;
                                                                let _e11845 = phi_10032_;
                                                                let _e11848 = (bitcast<i32>(_e11845.member) != 0i);
                                                                if _e11848 {
                                                                    phi_9992_ = (0.5f * (_e11820 + (_e11810 / _e11820)));
                                                                } else {
                                                                    phi_9992_ = f32();
                                                                }
                                                                let _e11853 = phi_9992_;
                                                                continue;
                                                                continuing {
                                                                    phi_9988_ = _e11843;
                                                                    phi_9991_ = _e11853;
                                                                    break if !(_e11848);
                                                                }
                                                            }
                                                            let _e11858 = local_106;
                                                            phi_10045_ = (_e11858 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e11865 = phi_10045_;
                                                        let _e11866 = (0.000000059604645f * 12f);
                                                        let _e11871 = ((((((((_e11540 + _e11542) + (_e11594 + _e11596)) + (_e11648 + _e11650)) * (0.000000059604645f * 16f)) + (_e11657 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e5865.member_1 * _e11865) * (1f + _e11866)));
                                                        let _e11876 = (((_e11801 * _e11428[0]) + (_e11803 * _e11428[1])) + (_e11805 * _e11428[2]));
                                                        let _e11881 = (((_e11801 * _e11445) + (_e11803 * _e11446)) + (_e11805 * _e11447));
                                                        let _e11886 = (((_e11801 * (_e11428[0] - _e11441[0])) + (_e11803 * (_e11428[1] - _e11441[1]))) + (_e11805 * (_e11428[2] - _e11441[2])));
                                                        let _e11894 = (((_e11801 * _e11454[0]) + (_e11803 * _e11454[1])) + (_e11805 * _e11454[2]));
                                                        let _e11900 = (((_e11801 * _e11460[0]) + (_e11803 * _e11460[1])) + (_e11805 * _e11460[2]));
                                                        let _e11905 = (((_e11801 * _e11477) + (_e11803 * _e11478)) + (_e11805 * _e11479));
                                                        let _e11910 = (((_e11801 * (_e11460[0] - _e11473[0])) + (_e11803 * (_e11460[1] - _e11473[1]))) + (_e11805 * (_e11460[2] - _e11473[2])));
                                                        let _e11918 = (((_e11801 * _e11486[0]) + (_e11803 * _e11486[1])) + (_e11805 * _e11486[2]));
                                                        if (_e11876 < 0f) {
                                                            phi_10111_ = -(_e11876);
                                                        } else {
                                                            phi_10111_ = _e11876;
                                                        }
                                                        let _e11923 = phi_10111_;
                                                        if (_e11900 < 0f) {
                                                            phi_10117_ = -(_e11900);
                                                        } else {
                                                            phi_10117_ = _e11900;
                                                        }
                                                        let _e11927 = phi_10117_;
                                                        if (_e11881 < 0f) {
                                                            phi_10126_ = -(_e11881);
                                                        } else {
                                                            phi_10126_ = _e11881;
                                                        }
                                                        let _e11934 = phi_10126_;
                                                        if (_e11905 < 0f) {
                                                            phi_10132_ = -(_e11905);
                                                        } else {
                                                            phi_10132_ = _e11905;
                                                        }
                                                        let _e11938 = phi_10132_;
                                                        if (_e11886 < 0f) {
                                                            phi_10141_ = -(_e11886);
                                                        } else {
                                                            phi_10141_ = _e11886;
                                                        }
                                                        let _e11945 = phi_10141_;
                                                        if (_e11910 < 0f) {
                                                            phi_10147_ = -(_e11910);
                                                        } else {
                                                            phi_10147_ = _e11910;
                                                        }
                                                        let _e11949 = phi_10147_;
                                                        if (_e11894 < 0f) {
                                                            phi_10156_ = -(_e11894);
                                                        } else {
                                                            phi_10156_ = _e11894;
                                                        }
                                                        let _e11956 = phi_10156_;
                                                        if (_e11918 < 0f) {
                                                            phi_10162_ = -(_e11918);
                                                        } else {
                                                            phi_10162_ = _e11918;
                                                        }
                                                        let _e11960 = phi_10162_;
                                                        phi_10168_ = type_29(array<f32, 4>(_e11876, _e11881, _e11886, _e11894), array<f32, 4>(_e11900, _e11905, _e11910, _e11918), array<f32, 4>((_e11871 + ((_e11923 + _e11927) * _e11866)), (_e11871 + ((_e11934 + _e11938) * _e11866)), (_e11871 + ((_e11945 + _e11949) * _e11866)), (_e11871 + ((_e11956 + _e11960) * _e11866))));
                                                        phi_10169_ = false;
                                                    } else {
                                                        phi_10168_ = type_29();
                                                        phi_10169_ = true;
                                                    }
                                                    let _e11967 = phi_10168_;
                                                    let _e11969 = phi_10169_;
                                                    phi_10170_ = _e11967;
                                                    phi_10171_ = _e11969;
                                                } else {
                                                    phi_10170_ = type_29();
                                                    phi_10171_ = true;
                                                }
                                                let _e11971 = phi_10170_;
                                                let _e11973 = phi_10171_;
                                                if _e11973 {
                                                    phi_10179_ = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                } else {
                                                    phi_10179_ = _e11971;
                                                }
                                                let _e11975 = phi_10179_;
                                                local_17 = type_29(array<f32, 4>(_e11975.member[0], _e11975.member[1], _e11975.member[2], _e11975.member[3]), array<f32, 4>(_e11975.member_1[0], _e11975.member_1[1], _e11975.member_1[2], _e11975.member_1[3]), array<f32, 4>(_e11975.member_2[0], _e11975.member_2[1], _e11975.member_2[2], _e11975.member_2[3]));
                                                let _e11995 = (_e11667 - _e11673);
                                                let _e11999 = local_17.member[0u];
                                                let _e12002 = local_17.member_1[0u];
                                                let _e12005 = local_17.member[0u];
                                                let _e12011 = local_17.member_2[0u];
                                                if (((_e11999 + ((_e12002 - _e12005) * _e11667)) - _e12011) > 0f) {
                                                    let _e12016 = local_17.member[1u];
                                                    let _e12019 = local_17.member_1[1u];
                                                    let _e12022 = local_17.member[1u];
                                                    let _e12028 = local_17.member_2[1u];
                                                    if (((_e12016 + ((_e12019 - _e12022) * _e11667)) - _e12028) > 0f) {
                                                        let _e12033 = local_17.member[2u];
                                                        let _e12036 = local_17.member_1[2u];
                                                        let _e12039 = local_17.member[2u];
                                                        let _e12045 = local_17.member_2[2u];
                                                        if (((_e12033 + ((_e12036 - _e12039) * _e11667)) - _e12045) > 0f) {
                                                            let _e12050 = local_17.member[3u];
                                                            let _e12053 = local_17.member_1[3u];
                                                            let _e12056 = local_17.member[3u];
                                                            let _e12062 = local_17.member_2[3u];
                                                            phi_10350_ = (((_e12050 + ((_e12053 - _e12056) * _e11667)) - _e12062) > 0f);
                                                            phi_10351_ = false;
                                                        } else {
                                                            phi_10350_ = bool();
                                                            phi_10351_ = true;
                                                        }
                                                        let _e12066 = phi_10350_;
                                                        let _e12068 = phi_10351_;
                                                        phi_10352_ = _e12066;
                                                        phi_10353_ = _e12068;
                                                    } else {
                                                        phi_10352_ = bool();
                                                        phi_10353_ = true;
                                                    }
                                                    let _e12070 = phi_10352_;
                                                    let _e12072 = phi_10353_;
                                                    phi_10354_ = _e12070;
                                                    phi_10355_ = _e12072;
                                                } else {
                                                    phi_10354_ = bool();
                                                    phi_10355_ = true;
                                                }
                                                let _e12074 = phi_10354_;
                                                let _e12076 = phi_10355_;
                                                if _e12076 {
                                                    phi_10359_ = false;
                                                } else {
                                                    phi_10359_ = _e12074;
                                                }
                                                let _e12078 = phi_10359_;
                                                if _e12078 {
                                                    if (_e11667 <= _e11669) {
                                                        phi_10669_ = true;
                                                    } else {
                                                        let _e12082 = local_16.member[0u];
                                                        let _e12085 = local_16.member_1[0u];
                                                        let _e12088 = local_16.member[0u];
                                                        let _e12094 = local_16.member_2[0u];
                                                        let _e12098 = local_17.member[0u];
                                                        let _e12101 = local_17.member_1[0u];
                                                        let _e12104 = local_17.member[0u];
                                                        let _e12110 = local_17.member_2[0u];
                                                        if ((((_e12082 + ((_e12085 - _e12088) * _e11667)) - _e12094) + ((_e12098 + ((_e12101 - _e12104) * _e11673)) - _e12110)) > 0f) {
                                                            let _e12116 = local_16.member[1u];
                                                            let _e12119 = local_16.member_1[1u];
                                                            let _e12122 = local_16.member[1u];
                                                            let _e12128 = local_16.member_2[1u];
                                                            let _e12132 = local_17.member[1u];
                                                            let _e12135 = local_17.member_1[1u];
                                                            let _e12138 = local_17.member[1u];
                                                            let _e12144 = local_17.member_2[1u];
                                                            if ((((_e12116 + ((_e12119 - _e12122) * _e11667)) - _e12128) + ((_e12132 + ((_e12135 - _e12138) * _e11673)) - _e12144)) > 0f) {
                                                                let _e12150 = local_16.member[2u];
                                                                let _e12153 = local_16.member_1[2u];
                                                                let _e12156 = local_16.member[2u];
                                                                let _e12162 = local_16.member_2[2u];
                                                                let _e12166 = local_17.member[2u];
                                                                let _e12169 = local_17.member_1[2u];
                                                                let _e12172 = local_17.member[2u];
                                                                let _e12178 = local_17.member_2[2u];
                                                                if ((((_e12150 + ((_e12153 - _e12156) * _e11667)) - _e12162) + ((_e12166 + ((_e12169 - _e12172) * _e11673)) - _e12178)) > 0f) {
                                                                    let _e12184 = local_16.member[3u];
                                                                    let _e12187 = local_16.member_1[3u];
                                                                    let _e12190 = local_16.member[3u];
                                                                    let _e12196 = local_16.member_2[3u];
                                                                    let _e12200 = local_17.member[3u];
                                                                    let _e12203 = local_17.member_1[3u];
                                                                    let _e12206 = local_17.member[3u];
                                                                    let _e12212 = local_17.member_2[3u];
                                                                    phi_10656_ = ((((_e12184 + ((_e12187 - _e12190) * _e11667)) - _e12196) + ((_e12200 + ((_e12203 - _e12206) * _e11673)) - _e12212)) > 0f);
                                                                    phi_10657_ = false;
                                                                } else {
                                                                    phi_10656_ = bool();
                                                                    phi_10657_ = true;
                                                                }
                                                                let _e12217 = phi_10656_;
                                                                let _e12219 = phi_10657_;
                                                                phi_10658_ = _e12217;
                                                                phi_10659_ = _e12219;
                                                            } else {
                                                                phi_10658_ = bool();
                                                                phi_10659_ = true;
                                                            }
                                                            let _e12221 = phi_10658_;
                                                            let _e12223 = phi_10659_;
                                                            phi_10660_ = _e12221;
                                                            phi_10661_ = _e12223;
                                                        } else {
                                                            phi_10660_ = bool();
                                                            phi_10661_ = true;
                                                        }
                                                        let _e12225 = phi_10660_;
                                                        let _e12227 = phi_10661_;
                                                        if _e12227 {
                                                            phi_10665_ = false;
                                                        } else {
                                                            phi_10665_ = _e12225;
                                                        }
                                                        let _e12229 = phi_10665_;
                                                        phi_10669_ = _e12229;
                                                    }
                                                    let _e12231 = phi_10669_;
                                                    if _e12231 {
                                                        if _e11675 {
                                                            if (_e11667 >= _e5599) {
                                                                phi_10680_ = false;
                                                            } else {
                                                                phi_10680_ = true;
                                                            }
                                                            let _e12234 = phi_10680_;
                                                            phi_10681_ = _e12234;
                                                        } else {
                                                            phi_10681_ = true;
                                                        }
                                                        let _e12236 = phi_10681_;
                                                        if _e12236 {
                                                            local_16 = type_29(array<f32, 4>(_e11975.member[0], _e11975.member[1], _e11975.member[2], _e11975.member[3]), array<f32, 4>(_e11975.member_1[0], _e11975.member_1[1], _e11975.member_1[2], _e11975.member_1[3]), array<f32, 4>(_e11975.member_2[0], _e11975.member_2[1], _e11975.member_2[2], _e11975.member_2[3]));
                                                            let _e12258 = local_16.member[0u];
                                                            let _e12261 = local_16.member_1[0u];
                                                            let _e12264 = local_16.member_2[0u];
                                                            if (_e12258 > _e12264) {
                                                                if (_e12261 > _e12264) {
                                                                    phi_10755_ = false;
                                                                } else {
                                                                    phi_10755_ = true;
                                                                }
                                                                let _e12268 = phi_10755_;
                                                                phi_10756_ = _e12268;
                                                            } else {
                                                                phi_10756_ = true;
                                                            }
                                                            let _e12270 = phi_10756_;
                                                            if _e12270 {
                                                                let _e12271 = (_e12261 >= _e12258);
                                                                if _e12271 {
                                                                    phi_10778_ = f32();
                                                                    phi_10779_ = false;
                                                                } else {
                                                                    if ((_e12258 - _e12261) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                        phi_10776_ = (((_e12258 - _e12264) / (_e12258 - _e12261)) * (1f - (0.000000059604645f * 16f)));
                                                                        phi_10777_ = false;
                                                                    } else {
                                                                        phi_10776_ = f32();
                                                                        phi_10777_ = true;
                                                                    }
                                                                    let _e12282 = phi_10776_;
                                                                    let _e12284 = phi_10777_;
                                                                    phi_10778_ = _e12282;
                                                                    phi_10779_ = _e12284;
                                                                }
                                                                let _e12286 = phi_10778_;
                                                                let _e12288 = phi_10779_;
                                                                phi_10780_ = _e12286;
                                                                phi_10781_ = _e12271;
                                                                phi_10782_ = _e12288;
                                                            } else {
                                                                phi_10780_ = f32();
                                                                phi_10781_ = true;
                                                                phi_10782_ = false;
                                                            }
                                                            let _e12290 = phi_10780_;
                                                            let _e12292 = phi_10781_;
                                                            let _e12294 = phi_10782_;
                                                            if _e12292 {
                                                                phi_10786_ = 2f;
                                                                phi_10787_ = true;
                                                            } else {
                                                                phi_10786_ = _e11667;
                                                                phi_10787_ = _e12294;
                                                            }
                                                            let _e12296 = phi_10786_;
                                                            let _e12298 = phi_10787_;
                                                            if _e12298 {
                                                                phi_10791_ = _e12296;
                                                            } else {
                                                                phi_10791_ = _e12290;
                                                            }
                                                            let _e12300 = phi_10791_;
                                                            let _e12303 = local_16.member[1u];
                                                            let _e12306 = local_16.member_1[1u];
                                                            let _e12309 = local_16.member_2[1u];
                                                            if (_e12303 > _e12309) {
                                                                if (_e12306 > _e12309) {
                                                                    phi_10823_ = false;
                                                                } else {
                                                                    phi_10823_ = true;
                                                                }
                                                                let _e12313 = phi_10823_;
                                                                phi_10824_ = _e12313;
                                                            } else {
                                                                phi_10824_ = true;
                                                            }
                                                            let _e12315 = phi_10824_;
                                                            if _e12315 {
                                                                let _e12316 = (_e12306 >= _e12303);
                                                                if _e12316 {
                                                                    phi_10846_ = f32();
                                                                    phi_10847_ = false;
                                                                } else {
                                                                    if ((_e12303 - _e12306) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                        phi_10844_ = (((_e12303 - _e12309) / (_e12303 - _e12306)) * (1f - (0.000000059604645f * 16f)));
                                                                        phi_10845_ = false;
                                                                    } else {
                                                                        phi_10844_ = f32();
                                                                        phi_10845_ = true;
                                                                    }
                                                                    let _e12327 = phi_10844_;
                                                                    let _e12329 = phi_10845_;
                                                                    phi_10846_ = _e12327;
                                                                    phi_10847_ = _e12329;
                                                                }
                                                                let _e12331 = phi_10846_;
                                                                let _e12333 = phi_10847_;
                                                                phi_10848_ = _e12331;
                                                                phi_10849_ = _e12316;
                                                                phi_10850_ = _e12333;
                                                            } else {
                                                                phi_10848_ = f32();
                                                                phi_10849_ = true;
                                                                phi_10850_ = false;
                                                            }
                                                            let _e12335 = phi_10848_;
                                                            let _e12337 = phi_10849_;
                                                            let _e12339 = phi_10850_;
                                                            if _e12337 {
                                                                phi_10854_ = 2f;
                                                                phi_10855_ = true;
                                                            } else {
                                                                phi_10854_ = _e11667;
                                                                phi_10855_ = _e12339;
                                                            }
                                                            let _e12341 = phi_10854_;
                                                            let _e12343 = phi_10855_;
                                                            if _e12343 {
                                                                phi_10859_ = _e12341;
                                                            } else {
                                                                phi_10859_ = _e12335;
                                                            }
                                                            let _e12345 = phi_10859_;
                                                            if (_e12300 < _e12345) {
                                                                phi_10864_ = _e12300;
                                                            } else {
                                                                phi_10864_ = _e12345;
                                                            }
                                                            let _e12348 = phi_10864_;
                                                            let _e12351 = local_16.member[2u];
                                                            let _e12354 = local_16.member_1[2u];
                                                            let _e12357 = local_16.member_2[2u];
                                                            if (_e12351 > _e12357) {
                                                                if (_e12354 > _e12357) {
                                                                    phi_10896_ = false;
                                                                } else {
                                                                    phi_10896_ = true;
                                                                }
                                                                let _e12361 = phi_10896_;
                                                                phi_10897_ = _e12361;
                                                            } else {
                                                                phi_10897_ = true;
                                                            }
                                                            let _e12363 = phi_10897_;
                                                            if _e12363 {
                                                                let _e12364 = (_e12354 >= _e12351);
                                                                if _e12364 {
                                                                    phi_10919_ = f32();
                                                                    phi_10920_ = false;
                                                                } else {
                                                                    if ((_e12351 - _e12354) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                        phi_10917_ = (((_e12351 - _e12357) / (_e12351 - _e12354)) * (1f - (0.000000059604645f * 16f)));
                                                                        phi_10918_ = false;
                                                                    } else {
                                                                        phi_10917_ = f32();
                                                                        phi_10918_ = true;
                                                                    }
                                                                    let _e12375 = phi_10917_;
                                                                    let _e12377 = phi_10918_;
                                                                    phi_10919_ = _e12375;
                                                                    phi_10920_ = _e12377;
                                                                }
                                                                let _e12379 = phi_10919_;
                                                                let _e12381 = phi_10920_;
                                                                phi_10921_ = _e12379;
                                                                phi_10922_ = _e12364;
                                                                phi_10923_ = _e12381;
                                                            } else {
                                                                phi_10921_ = f32();
                                                                phi_10922_ = true;
                                                                phi_10923_ = false;
                                                            }
                                                            let _e12383 = phi_10921_;
                                                            let _e12385 = phi_10922_;
                                                            let _e12387 = phi_10923_;
                                                            if _e12385 {
                                                                phi_10927_ = 2f;
                                                                phi_10928_ = true;
                                                            } else {
                                                                phi_10927_ = _e11667;
                                                                phi_10928_ = _e12387;
                                                            }
                                                            let _e12389 = phi_10927_;
                                                            let _e12391 = phi_10928_;
                                                            if _e12391 {
                                                                phi_10932_ = _e12389;
                                                            } else {
                                                                phi_10932_ = _e12383;
                                                            }
                                                            let _e12393 = phi_10932_;
                                                            let _e12396 = local_16.member[3u];
                                                            let _e12399 = local_16.member_1[3u];
                                                            let _e12402 = local_16.member_2[3u];
                                                            if (_e12396 > _e12402) {
                                                                if (_e12399 > _e12402) {
                                                                    phi_10964_ = false;
                                                                } else {
                                                                    phi_10964_ = true;
                                                                }
                                                                let _e12406 = phi_10964_;
                                                                phi_10965_ = _e12406;
                                                            } else {
                                                                phi_10965_ = true;
                                                            }
                                                            let _e12408 = phi_10965_;
                                                            if _e12408 {
                                                                let _e12409 = (_e12399 >= _e12396);
                                                                if _e12409 {
                                                                    phi_10987_ = f32();
                                                                    phi_10988_ = false;
                                                                } else {
                                                                    if ((_e12396 - _e12399) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                        phi_10985_ = (((_e12396 - _e12402) / (_e12396 - _e12399)) * (1f - (0.000000059604645f * 16f)));
                                                                        phi_10986_ = false;
                                                                    } else {
                                                                        phi_10985_ = f32();
                                                                        phi_10986_ = true;
                                                                    }
                                                                    let _e12420 = phi_10985_;
                                                                    let _e12422 = phi_10986_;
                                                                    phi_10987_ = _e12420;
                                                                    phi_10988_ = _e12422;
                                                                }
                                                                let _e12424 = phi_10987_;
                                                                let _e12426 = phi_10988_;
                                                                phi_10989_ = _e12424;
                                                                phi_10990_ = _e12409;
                                                                phi_10991_ = _e12426;
                                                            } else {
                                                                phi_10989_ = f32();
                                                                phi_10990_ = true;
                                                                phi_10991_ = false;
                                                            }
                                                            let _e12428 = phi_10989_;
                                                            let _e12430 = phi_10990_;
                                                            let _e12432 = phi_10991_;
                                                            if _e12430 {
                                                                phi_10995_ = 2f;
                                                                phi_10996_ = true;
                                                            } else {
                                                                phi_10995_ = _e11667;
                                                                phi_10996_ = _e12432;
                                                            }
                                                            let _e12434 = phi_10995_;
                                                            let _e12436 = phi_10996_;
                                                            if _e12436 {
                                                                phi_11000_ = _e12434;
                                                            } else {
                                                                phi_11000_ = _e12428;
                                                            }
                                                            let _e12438 = phi_11000_;
                                                            if (_e12393 < _e12438) {
                                                                phi_11005_ = _e12393;
                                                            } else {
                                                                phi_11005_ = _e12438;
                                                            }
                                                            let _e12441 = phi_11005_;
                                                            if (_e12348 < _e12441) {
                                                                phi_11010_ = _e12348;
                                                            } else {
                                                                phi_11010_ = _e12441;
                                                            }
                                                            let _e12444 = phi_11010_;
                                                            if (_e12444 > _e11667) {
                                                                phi_11015_ = _e12444;
                                                            } else {
                                                                phi_11015_ = _e11667;
                                                            }
                                                            let _e12447 = phi_11015_;
                                                            let _e12448 = (_e12447 > _e5599);
                                                            if _e12448 {
                                                                phi_11520_ = f32();
                                                                phi_11521_ = f32();
                                                                phi_11522_ = false;
                                                                phi_11523_ = false;
                                                            } else {
                                                                let _e12449 = (_e12447 - _e11667);
                                                                let _e12450 = (_e12449 <= _e11662);
                                                                let _e12452 = (_e12447 + (_e5595 * 0.01f));
                                                                if (_e12452 < _e5599) {
                                                                    phi_11028_ = _e12452;
                                                                } else {
                                                                    phi_11028_ = _e5599;
                                                                }
                                                                let _e12455 = phi_11028_;
                                                                if _e12450 {
                                                                    if (_e5865.member_1 > 0f) {
                                                                        let _e12459 = local_18.member[0u];
                                                                        let _e12465 = local_18.member[1u];
                                                                        let _e12481 = local_18.member_1[0u];
                                                                        let _e12487 = local_18.member_1[1u];
                                                                        let _e12503 = local_18.member_2[0u];
                                                                        let _e12509 = local_18.member_2[1u];
                                                                        let _e12523 = function_3(array<f32, 3>((_e12459[0] + ((_e12465[0] - _e12459[0]) * _e12455)), (_e12459[1] + ((_e12465[1] - _e12459[1]) * _e12455)), (_e12459[2] + ((_e12465[2] - _e12459[2]) * _e12455))), array<f32, 3>((_e12481[0] + ((_e12487[0] - _e12481[0]) * _e12455)), (_e12481[1] + ((_e12487[1] - _e12481[1]) * _e12455)), (_e12481[2] + ((_e12487[2] - _e12481[2]) * _e12455))), array<f32, 3>((_e12503[0] + ((_e12509[0] - _e12503[0]) * _e12455)), (_e12503[1] + ((_e12509[1] - _e12503[1]) * _e12455)), (_e12503[2] + ((_e12509[2] - _e12503[2]) * _e12455))), _e315.member);
                                                                        let _e12534 = (((_e12523[0] * _e12523[0]) + (_e12523[1] * _e12523[1])) + (_e12523[2] * _e12523[2]));
                                                                        if (_e12534 <= 0.000000000000000000000000000000000000011754944f) {
                                                                            if (_e12534 > 0f) {
                                                                                phi_11158_ = (0.000000000000000000106433627f * 2f);
                                                                            } else {
                                                                                phi_11158_ = 0f;
                                                                            }
                                                                            let _e12587 = phi_11158_;
                                                                            phi_11222_ = _e12587;
                                                                        } else {
                                                                            phi_11165_ = type_14(0i, 5i);
                                                                            phi_11168_ = bitcast<f32>(((bitcast<u32>(_e12534) >> bitcast<u32>(1i)) + 532369198u));
                                                                            loop {
                                                                                let _e12542 = phi_11165_;
                                                                                let _e12544 = phi_11168_;
                                                                                local_107 = _e12544;
                                                                                if (_e12542.member < _e12542.member_1) {
                                                                                    let _e12551 = (_e12542.member + 1i);
                                                                                    if ((false == (_e12551 > _e12542.member)) != false) {
                                                                                        phi_11189_ = true;
                                                                                    } else {
                                                                                        phi_11189_ = false;
                                                                                    }
                                                                                    let _e12556 = phi_11189_;
                                                                                    if _e12556 {
                                                                                        phi_11195_ = type_15(0u, type_15().member_1);
                                                                                    } else {
                                                                                        phi_11195_ = type_15(1u, _e12551);
                                                                                    }
                                                                                    let _e12561 = phi_11195_;
                                                                                    phi_11166_ = type_14(_e12561.member_1, _e12542.member_1);
                                                                                    phi_11209_ = type_15(1u, _e12542.member);
                                                                                } else {
                                                                                    phi_11166_ = _e12542;
                                                                                    phi_11209_ = type_15(0u, type_15().member_1);
                                                                                }
                                                                                let _e12567 = phi_11166_;
                                                                                let _e12569 = phi_11209_;
                                                                                let _e12572 = (bitcast<i32>(_e12569.member) != 0i);
                                                                                if _e12572 {
                                                                                    phi_11169_ = (0.5f * (_e12544 + (_e12534 / _e12544)));
                                                                                } else {
                                                                                    phi_11169_ = f32();
                                                                                }
                                                                                let _e12577 = phi_11169_;
                                                                                continue;
                                                                                continuing {
                                                                                    phi_11165_ = _e12567;
                                                                                    phi_11168_ = _e12577;
                                                                                    break if !(_e12572);
                                                                                }
                                                                            }
                                                                            let _e12582 = local_107;
                                                                            phi_11222_ = (_e12582 * (1f + (8f * 0.000000059604645f)));
                                                                        }
                                                                        let _e12589 = phi_11222_;
                                                                        let _e12595 = local_18.member[0u];
                                                                        if (_e12595[0] < 0f) {
                                                                            phi_11238_ = -(_e12595[0]);
                                                                        } else {
                                                                            phi_11238_ = _e12595[0];
                                                                        }
                                                                        let _e12602 = phi_11238_;
                                                                        if (_e12595[1] < 0f) {
                                                                            phi_11245_ = -(_e12595[1]);
                                                                        } else {
                                                                            phi_11245_ = _e12595[1];
                                                                        }
                                                                        let _e12606 = phi_11245_;
                                                                        if (_e12602 > _e12606) {
                                                                            phi_11250_ = _e12602;
                                                                        } else {
                                                                            phi_11250_ = _e12606;
                                                                        }
                                                                        let _e12609 = phi_11250_;
                                                                        if (_e12595[2] < 0f) {
                                                                            phi_11257_ = -(_e12595[2]);
                                                                        } else {
                                                                            phi_11257_ = _e12595[2];
                                                                        }
                                                                        let _e12613 = phi_11257_;
                                                                        if (_e12609 > _e12613) {
                                                                            phi_11262_ = _e12609;
                                                                        } else {
                                                                            phi_11262_ = _e12613;
                                                                        }
                                                                        let _e12616 = phi_11262_;
                                                                        let _e12619 = local_18.member[1u];
                                                                        if (_e12619[0] < 0f) {
                                                                            phi_11275_ = -(_e12619[0]);
                                                                        } else {
                                                                            phi_11275_ = _e12619[0];
                                                                        }
                                                                        let _e12626 = phi_11275_;
                                                                        if (_e12619[1] < 0f) {
                                                                            phi_11282_ = -(_e12619[1]);
                                                                        } else {
                                                                            phi_11282_ = _e12619[1];
                                                                        }
                                                                        let _e12630 = phi_11282_;
                                                                        if (_e12626 > _e12630) {
                                                                            phi_11287_ = _e12626;
                                                                        } else {
                                                                            phi_11287_ = _e12630;
                                                                        }
                                                                        let _e12633 = phi_11287_;
                                                                        if (_e12619[2] < 0f) {
                                                                            phi_11294_ = -(_e12619[2]);
                                                                        } else {
                                                                            phi_11294_ = _e12619[2];
                                                                        }
                                                                        let _e12637 = phi_11294_;
                                                                        if (_e12633 > _e12637) {
                                                                            phi_11299_ = _e12633;
                                                                        } else {
                                                                            phi_11299_ = _e12637;
                                                                        }
                                                                        let _e12640 = phi_11299_;
                                                                        if (_e12616 > _e12640) {
                                                                            phi_11304_ = _e12616;
                                                                        } else {
                                                                            phi_11304_ = _e12640;
                                                                        }
                                                                        let _e12643 = phi_11304_;
                                                                        let _e12645 = local_18.member_3;
                                                                        let _e12649 = local_18.member_1[0u];
                                                                        if (_e12649[0] < 0f) {
                                                                            phi_11321_ = -(_e12649[0]);
                                                                        } else {
                                                                            phi_11321_ = _e12649[0];
                                                                        }
                                                                        let _e12656 = phi_11321_;
                                                                        if (_e12649[1] < 0f) {
                                                                            phi_11328_ = -(_e12649[1]);
                                                                        } else {
                                                                            phi_11328_ = _e12649[1];
                                                                        }
                                                                        let _e12660 = phi_11328_;
                                                                        if (_e12656 > _e12660) {
                                                                            phi_11333_ = _e12656;
                                                                        } else {
                                                                            phi_11333_ = _e12660;
                                                                        }
                                                                        let _e12663 = phi_11333_;
                                                                        if (_e12649[2] < 0f) {
                                                                            phi_11340_ = -(_e12649[2]);
                                                                        } else {
                                                                            phi_11340_ = _e12649[2];
                                                                        }
                                                                        let _e12667 = phi_11340_;
                                                                        if (_e12663 > _e12667) {
                                                                            phi_11345_ = _e12663;
                                                                        } else {
                                                                            phi_11345_ = _e12667;
                                                                        }
                                                                        let _e12670 = phi_11345_;
                                                                        let _e12673 = local_18.member_1[1u];
                                                                        if (_e12673[0] < 0f) {
                                                                            phi_11359_ = -(_e12673[0]);
                                                                        } else {
                                                                            phi_11359_ = _e12673[0];
                                                                        }
                                                                        let _e12680 = phi_11359_;
                                                                        if (_e12673[1] < 0f) {
                                                                            phi_11366_ = -(_e12673[1]);
                                                                        } else {
                                                                            phi_11366_ = _e12673[1];
                                                                        }
                                                                        let _e12684 = phi_11366_;
                                                                        if (_e12680 > _e12684) {
                                                                            phi_11371_ = _e12680;
                                                                        } else {
                                                                            phi_11371_ = _e12684;
                                                                        }
                                                                        let _e12687 = phi_11371_;
                                                                        if (_e12673[2] < 0f) {
                                                                            phi_11378_ = -(_e12673[2]);
                                                                        } else {
                                                                            phi_11378_ = _e12673[2];
                                                                        }
                                                                        let _e12691 = phi_11378_;
                                                                        if (_e12687 > _e12691) {
                                                                            phi_11383_ = _e12687;
                                                                        } else {
                                                                            phi_11383_ = _e12691;
                                                                        }
                                                                        let _e12694 = phi_11383_;
                                                                        if (_e12670 > _e12694) {
                                                                            phi_11388_ = _e12670;
                                                                        } else {
                                                                            phi_11388_ = _e12694;
                                                                        }
                                                                        let _e12697 = phi_11388_;
                                                                        let _e12699 = local_18.member_3;
                                                                        let _e12703 = local_18.member_2[0u];
                                                                        if (_e12703[0] < 0f) {
                                                                            phi_11405_ = -(_e12703[0]);
                                                                        } else {
                                                                            phi_11405_ = _e12703[0];
                                                                        }
                                                                        let _e12710 = phi_11405_;
                                                                        if (_e12703[1] < 0f) {
                                                                            phi_11412_ = -(_e12703[1]);
                                                                        } else {
                                                                            phi_11412_ = _e12703[1];
                                                                        }
                                                                        let _e12714 = phi_11412_;
                                                                        if (_e12710 > _e12714) {
                                                                            phi_11417_ = _e12710;
                                                                        } else {
                                                                            phi_11417_ = _e12714;
                                                                        }
                                                                        let _e12717 = phi_11417_;
                                                                        if (_e12703[2] < 0f) {
                                                                            phi_11424_ = -(_e12703[2]);
                                                                        } else {
                                                                            phi_11424_ = _e12703[2];
                                                                        }
                                                                        let _e12721 = phi_11424_;
                                                                        if (_e12717 > _e12721) {
                                                                            phi_11429_ = _e12717;
                                                                        } else {
                                                                            phi_11429_ = _e12721;
                                                                        }
                                                                        let _e12724 = phi_11429_;
                                                                        let _e12727 = local_18.member_2[1u];
                                                                        if (_e12727[0] < 0f) {
                                                                            phi_11443_ = -(_e12727[0]);
                                                                        } else {
                                                                            phi_11443_ = _e12727[0];
                                                                        }
                                                                        let _e12734 = phi_11443_;
                                                                        if (_e12727[1] < 0f) {
                                                                            phi_11450_ = -(_e12727[1]);
                                                                        } else {
                                                                            phi_11450_ = _e12727[1];
                                                                        }
                                                                        let _e12738 = phi_11450_;
                                                                        if (_e12734 > _e12738) {
                                                                            phi_11455_ = _e12734;
                                                                        } else {
                                                                            phi_11455_ = _e12738;
                                                                        }
                                                                        let _e12741 = phi_11455_;
                                                                        if (_e12727[2] < 0f) {
                                                                            phi_11462_ = -(_e12727[2]);
                                                                        } else {
                                                                            phi_11462_ = _e12727[2];
                                                                        }
                                                                        let _e12745 = phi_11462_;
                                                                        if (_e12741 > _e12745) {
                                                                            phi_11467_ = _e12741;
                                                                        } else {
                                                                            phi_11467_ = _e12745;
                                                                        }
                                                                        let _e12748 = phi_11467_;
                                                                        if (_e12724 > _e12748) {
                                                                            phi_11472_ = _e12724;
                                                                        } else {
                                                                            phi_11472_ = _e12748;
                                                                        }
                                                                        let _e12751 = phi_11472_;
                                                                        let _e12753 = local_18.member_3;
                                                                        let _e12760 = local_18.member_3;
                                                                        if (((_e12589 * (1f + (0.000000059604645f * 8f))) + (((((((_e12643 + _e12645) + (_e12697 + _e12699)) + (_e12751 + _e12753)) * (0.000000059604645f * 16f)) + (_e12760 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e5865.member_1) {
                                                                            phi_11492_ = false;
                                                                        } else {
                                                                            phi_11492_ = true;
                                                                        }
                                                                        let _e12769 = phi_11492_;
                                                                        phi_11493_ = _e12769;
                                                                    } else {
                                                                        phi_11493_ = true;
                                                                    }
                                                                    let _e12771 = phi_11493_;
                                                                    phi_11494_ = _e12771;
                                                                } else {
                                                                    phi_11494_ = true;
                                                                }
                                                                let _e12773 = phi_11494_;
                                                                if _e12773 {
                                                                    if _e11675 {
                                                                        if _e12450 {
                                                                            phi_11510_ = true;
                                                                        } else {
                                                                            if (_e12449 <= (_e11671 * 0.25f)) {
                                                                                phi_11509_ = false;
                                                                            } else {
                                                                                phi_11509_ = true;
                                                                            }
                                                                            let _e12778 = phi_11509_;
                                                                            phi_11510_ = _e12778;
                                                                        }
                                                                        let _e12780 = phi_11510_;
                                                                        if _e12780 {
                                                                            phi_11515_ = (_e11995 + _e11995);
                                                                        } else {
                                                                            phi_11515_ = 0f;
                                                                        }
                                                                        let _e12783 = phi_11515_;
                                                                        phi_11517_ = _e12783;
                                                                    } else {
                                                                        phi_11517_ = (_e5599 - _e11667);
                                                                    }
                                                                    let _e12785 = phi_11517_;
                                                                    phi_11518_ = _e12785;
                                                                    phi_11519_ = false;
                                                                } else {
                                                                    phi_11518_ = f32();
                                                                    phi_11519_ = true;
                                                                }
                                                                let _e12787 = phi_11518_;
                                                                let _e12789 = phi_11519_;
                                                                phi_11520_ = _e12787;
                                                                phi_11521_ = _e12449;
                                                                phi_11522_ = _e12773;
                                                                phi_11523_ = _e12789;
                                                            }
                                                            let _e12791 = phi_11520_;
                                                            let _e12793 = phi_11521_;
                                                            let _e12795 = phi_11522_;
                                                            let _e12797 = phi_11523_;
                                                            phi_11524_ = _e12447;
                                                            phi_11525_ = _e12791;
                                                            phi_11526_ = _e12793;
                                                            phi_11527_ = _e12447;
                                                            phi_11528_ = _e12795;
                                                            phi_11529_ = _e12448;
                                                            phi_11530_ = _e12797;
                                                            phi_11531_ = false;
                                                        } else {
                                                            phi_11524_ = f32();
                                                            phi_11525_ = f32();
                                                            phi_11526_ = f32();
                                                            phi_11527_ = f32();
                                                            phi_11528_ = false;
                                                            phi_11529_ = false;
                                                            phi_11530_ = false;
                                                            phi_11531_ = true;
                                                        }
                                                        let _e12799 = phi_11524_;
                                                        let _e12801 = phi_11525_;
                                                        let _e12803 = phi_11526_;
                                                        let _e12805 = phi_11527_;
                                                        let _e12807 = phi_11528_;
                                                        let _e12809 = phi_11529_;
                                                        let _e12811 = phi_11530_;
                                                        let _e12813 = phi_11531_;
                                                        phi_11532_ = _e12799;
                                                        phi_11533_ = _e12801;
                                                        phi_11534_ = _e12803;
                                                        phi_11535_ = _e12805;
                                                        phi_11536_ = false;
                                                        phi_11537_ = _e12807;
                                                        phi_11538_ = _e12809;
                                                        phi_11539_ = _e12811;
                                                        phi_11540_ = _e12813;
                                                    } else {
                                                        phi_11532_ = f32();
                                                        phi_11533_ = f32();
                                                        phi_11534_ = f32();
                                                        phi_11535_ = f32();
                                                        phi_11536_ = true;
                                                        phi_11537_ = false;
                                                        phi_11538_ = false;
                                                        phi_11539_ = false;
                                                        phi_11540_ = false;
                                                    }
                                                    let _e12815 = phi_11532_;
                                                    let _e12817 = phi_11533_;
                                                    let _e12819 = phi_11534_;
                                                    let _e12821 = phi_11535_;
                                                    let _e12823 = phi_11536_;
                                                    let _e12825 = phi_11537_;
                                                    let _e12827 = phi_11538_;
                                                    let _e12829 = phi_11539_;
                                                    let _e12831 = phi_11540_;
                                                    phi_11541_ = _e12815;
                                                    phi_11542_ = _e12817;
                                                    phi_11543_ = _e12819;
                                                    phi_11544_ = _e12821;
                                                    phi_11545_ = _e12823;
                                                    phi_11546_ = _e12825;
                                                    phi_11547_ = _e12827;
                                                    phi_11548_ = _e12829;
                                                    phi_11549_ = _e12831;
                                                } else {
                                                    phi_11541_ = f32();
                                                    phi_11542_ = f32();
                                                    phi_11543_ = f32();
                                                    phi_11544_ = f32();
                                                    phi_11545_ = true;
                                                    phi_11546_ = false;
                                                    phi_11547_ = false;
                                                    phi_11548_ = false;
                                                    phi_11549_ = false;
                                                }
                                                let _e12833 = phi_11541_;
                                                let _e12835 = phi_11542_;
                                                let _e12837 = phi_11543_;
                                                let _e12839 = phi_11544_;
                                                let _e12841 = phi_11545_;
                                                let _e12843 = phi_11546_;
                                                let _e12845 = phi_11547_;
                                                let _e12847 = phi_11548_;
                                                let _e12849 = phi_11549_;
                                                if _e12841 {
                                                    if (_e11667 <= _e11669) {
                                                        let _e13010 = (_e11677 + 1u);
                                                        let _e13011 = (_e13010 > 3u);
                                                        if _e13011 {
                                                            phi_11562_ = false;
                                                        } else {
                                                            phi_11562_ = true;
                                                        }
                                                        let _e13013 = phi_11562_;
                                                        phi_11884_ = _e13010;
                                                        phi_11885_ = f32();
                                                        phi_11886_ = false;
                                                        phi_11887_ = _e13013;
                                                        phi_11888_ = _e13011;
                                                    } else {
                                                        let _e12853 = local_16.member[0u];
                                                        let _e12856 = local_16.member_1[0u];
                                                        let _e12859 = local_16.member[0u];
                                                        let _e12865 = local_16.member_2[0u];
                                                        let _e12866 = ((_e12853 + ((_e12856 - _e12859) * _e11673)) - _e12865);
                                                        let _e12869 = local_16.member[1u];
                                                        let _e12872 = local_16.member_1[1u];
                                                        let _e12875 = local_16.member[1u];
                                                        let _e12881 = local_16.member_2[1u];
                                                        let _e12882 = ((_e12869 + ((_e12872 - _e12875) * _e11673)) - _e12881);
                                                        if (_e12866 < _e12882) {
                                                            phi_11635_ = _e12866;
                                                        } else {
                                                            phi_11635_ = _e12882;
                                                        }
                                                        let _e12885 = phi_11635_;
                                                        let _e12888 = local_16.member[2u];
                                                        let _e12891 = local_16.member_1[2u];
                                                        let _e12894 = local_16.member[2u];
                                                        let _e12900 = local_16.member_2[2u];
                                                        let _e12901 = ((_e12888 + ((_e12891 - _e12894) * _e11673)) - _e12900);
                                                        let _e12904 = local_16.member[3u];
                                                        let _e12907 = local_16.member_1[3u];
                                                        let _e12910 = local_16.member[3u];
                                                        let _e12916 = local_16.member_2[3u];
                                                        let _e12917 = ((_e12904 + ((_e12907 - _e12910) * _e11673)) - _e12916);
                                                        if (_e12901 < _e12917) {
                                                            phi_11708_ = _e12901;
                                                        } else {
                                                            phi_11708_ = _e12917;
                                                        }
                                                        let _e12920 = phi_11708_;
                                                        if (_e12885 < _e12920) {
                                                            phi_11713_ = _e12885;
                                                        } else {
                                                            phi_11713_ = _e12920;
                                                        }
                                                        let _e12923 = phi_11713_;
                                                        let _e12926 = local_17.member[0u];
                                                        let _e12929 = local_17.member_1[0u];
                                                        let _e12932 = local_17.member[0u];
                                                        let _e12938 = local_17.member_2[0u];
                                                        let _e12939 = ((_e12926 + ((_e12929 - _e12932) * _e11667)) - _e12938);
                                                        let _e12942 = local_17.member[1u];
                                                        let _e12945 = local_17.member_1[1u];
                                                        let _e12948 = local_17.member[1u];
                                                        let _e12954 = local_17.member_2[1u];
                                                        let _e12955 = ((_e12942 + ((_e12945 - _e12948) * _e11667)) - _e12954);
                                                        if (_e12939 < _e12955) {
                                                            phi_11786_ = _e12939;
                                                        } else {
                                                            phi_11786_ = _e12955;
                                                        }
                                                        let _e12958 = phi_11786_;
                                                        let _e12961 = local_17.member[2u];
                                                        let _e12964 = local_17.member_1[2u];
                                                        let _e12967 = local_17.member[2u];
                                                        let _e12973 = local_17.member_2[2u];
                                                        let _e12974 = ((_e12961 + ((_e12964 - _e12967) * _e11667)) - _e12973);
                                                        let _e12977 = local_17.member[3u];
                                                        let _e12980 = local_17.member_1[3u];
                                                        let _e12983 = local_17.member[3u];
                                                        let _e12989 = local_17.member_2[3u];
                                                        let _e12990 = ((_e12977 + ((_e12980 - _e12983) * _e11667)) - _e12989);
                                                        if (_e12974 < _e12990) {
                                                            phi_11859_ = _e12974;
                                                        } else {
                                                            phi_11859_ = _e12990;
                                                        }
                                                        let _e12993 = phi_11859_;
                                                        if (_e12958 < _e12993) {
                                                            phi_11864_ = _e12958;
                                                        } else {
                                                            phi_11864_ = _e12993;
                                                        }
                                                        let _e12996 = phi_11864_;
                                                        if (_e12996 > 0f) {
                                                            phi_11882_ = 0.5f;
                                                        } else {
                                                            let _e13000 = (0.95f * (_e12923 / (_e12923 - _e12996)));
                                                            if (_e13000 > 0.0625f) {
                                                                if (_e13000 < 0.9f) {
                                                                    phi_11880_ = _e13000;
                                                                } else {
                                                                    phi_11880_ = 0.9f;
                                                                }
                                                                let _e13004 = phi_11880_;
                                                                phi_11881_ = _e13004;
                                                            } else {
                                                                phi_11881_ = 0.0625f;
                                                            }
                                                            let _e13006 = phi_11881_;
                                                            phi_11882_ = _e13006;
                                                        }
                                                        let _e13008 = phi_11882_;
                                                        phi_11884_ = u32();
                                                        phi_11885_ = (_e11995 * _e13008);
                                                        phi_11886_ = true;
                                                        phi_11887_ = false;
                                                        phi_11888_ = false;
                                                    }
                                                    let _e13015 = phi_11884_;
                                                    let _e13017 = phi_11885_;
                                                    let _e13019 = phi_11886_;
                                                    let _e13021 = phi_11887_;
                                                    let _e13023 = phi_11888_;
                                                    phi_11889_ = _e13015;
                                                    phi_11890_ = _e11669;
                                                    phi_11891_ = _e13017;
                                                    phi_11892_ = _e11671;
                                                    phi_11893_ = _e11673;
                                                    phi_11894_ = _e11675;
                                                    phi_11895_ = _e11677;
                                                    phi_11896_ = _e13019;
                                                    phi_11897_ = _e13021;
                                                    phi_11898_ = _e13023;
                                                    phi_11899_ = false;
                                                    phi_11900_ = false;
                                                    phi_11901_ = false;
                                                } else {
                                                    phi_11889_ = u32();
                                                    phi_11890_ = _e12833;
                                                    phi_11891_ = _e12835;
                                                    phi_11892_ = _e12837;
                                                    phi_11893_ = _e11667;
                                                    phi_11894_ = true;
                                                    phi_11895_ = 0u;
                                                    phi_11896_ = _e12843;
                                                    phi_11897_ = false;
                                                    phi_11898_ = false;
                                                    phi_11899_ = _e12845;
                                                    phi_11900_ = _e12847;
                                                    phi_11901_ = _e12849;
                                                }
                                                let _e13025 = phi_11889_;
                                                let _e13027 = phi_11890_;
                                                let _e13029 = phi_11891_;
                                                let _e13031 = phi_11892_;
                                                let _e13033 = phi_11893_;
                                                let _e13035 = phi_11894_;
                                                let _e13037 = phi_11895_;
                                                let _e13039 = phi_11896_;
                                                let _e13041 = phi_11897_;
                                                let _e13043 = phi_11898_;
                                                let _e13045 = phi_11899_;
                                                let _e13047 = phi_11900_;
                                                let _e13049 = phi_11901_;
                                                if _e13039 {
                                                    let _e13050 = (_e13033 + _e13029);
                                                    if (_e13050 > _e13027) {
                                                        phi_11910_ = _e13050;
                                                    } else {
                                                        phi_11910_ = _e13027;
                                                    }
                                                    let _e13053 = phi_11910_;
                                                    if (_e13053 < _e5599) {
                                                        phi_11915_ = _e13053;
                                                    } else {
                                                        phi_11915_ = _e5599;
                                                    }
                                                    let _e13056 = phi_11915_;
                                                    if !(_e11675) {
                                                        phi_11924_ = true;
                                                    } else {
                                                        phi_11924_ = ((_e13056 - _e13033) > _e11662);
                                                    }
                                                    let _e13060 = phi_11924_;
                                                    if _e13060 {
                                                        phi_11928_ = false;
                                                    } else {
                                                        phi_11928_ = true;
                                                    }
                                                    let _e13062 = phi_11928_;
                                                    phi_11929_ = _e13056;
                                                    phi_11930_ = _e13027;
                                                    phi_11931_ = _e13031;
                                                    phi_11932_ = _e13033;
                                                    phi_11933_ = _e13035;
                                                    phi_11934_ = _e13037;
                                                    phi_11935_ = _e13060;
                                                    phi_11936_ = _e13062;
                                                    phi_11937_ = false;
                                                    phi_11938_ = false;
                                                    phi_11939_ = false;
                                                    phi_11940_ = false;
                                                } else {
                                                    phi_11929_ = _e11667;
                                                    phi_11930_ = _e11669;
                                                    phi_11931_ = _e11671;
                                                    phi_11932_ = _e11673;
                                                    phi_11933_ = _e11675;
                                                    phi_11934_ = _e13025;
                                                    phi_11935_ = _e13041;
                                                    phi_11936_ = false;
                                                    phi_11937_ = _e13043;
                                                    phi_11938_ = _e13045;
                                                    phi_11939_ = _e13047;
                                                    phi_11940_ = _e13049;
                                                }
                                                let _e13064 = phi_11929_;
                                                let _e13066 = phi_11930_;
                                                let _e13068 = phi_11931_;
                                                let _e13070 = phi_11932_;
                                                let _e13072 = phi_11933_;
                                                let _e13074 = phi_11934_;
                                                let _e13076 = phi_11935_;
                                                let _e13078 = phi_11936_;
                                                let _e13080 = phi_11937_;
                                                let _e13082 = phi_11938_;
                                                let _e13084 = phi_11939_;
                                                let _e13086 = phi_11940_;
                                                phi_9762_ = _e13064;
                                                phi_9764_ = _e13066;
                                                phi_9766_ = _e13068;
                                                phi_9768_ = _e13070;
                                                phi_9770_ = _e13072;
                                                phi_9772_ = _e13074;
                                                phi_11941_ = _e13027;
                                                phi_11942_ = _e12839;
                                                phi_11943_ = _e13076;
                                                phi_11944_ = _e13078;
                                                phi_11945_ = _e13080;
                                                phi_11946_ = _e13082;
                                                phi_11947_ = _e13084;
                                                phi_11948_ = false;
                                                phi_11949_ = _e13086;
                                            } else {
                                                phi_9762_ = f32();
                                                phi_9764_ = f32();
                                                phi_9766_ = f32();
                                                phi_9768_ = f32();
                                                phi_9770_ = bool();
                                                phi_9772_ = u32();
                                                phi_11941_ = f32();
                                                phi_11942_ = f32();
                                                phi_11943_ = false;
                                                phi_11944_ = false;
                                                phi_11945_ = false;
                                                phi_11946_ = false;
                                                phi_11947_ = false;
                                                phi_11948_ = true;
                                                phi_11949_ = false;
                                            }
                                            let _e13088 = phi_9762_;
                                            let _e13090 = phi_9764_;
                                            let _e13092 = phi_9766_;
                                            let _e13094 = phi_9768_;
                                            let _e13096 = phi_9770_;
                                            let _e13098 = phi_9772_;
                                            let _e13100 = phi_11941_;
                                            let _e13102 = phi_11942_;
                                            let _e13104 = phi_11943_;
                                            let _e13106 = phi_11944_;
                                            let _e13108 = phi_11945_;
                                            let _e13110 = phi_11946_;
                                            let _e13112 = phi_11947_;
                                            let _e13114 = phi_11948_;
                                            let _e13116 = phi_11949_;
                                            local_108 = _e13106;
                                            local_149 = _e13108;
                                            local_150 = _e13110;
                                            local_151 = _e13112;
                                            local_152 = _e13114;
                                            local_153 = _e13116;
                                            local_154 = _e13106;
                                            local_155 = _e13102;
                                            local_156 = _e13100;
                                            continue;
                                            continuing {
                                                phi_9758_ = _e11689;
                                                phi_9761_ = _e13088;
                                                phi_9763_ = _e13090;
                                                phi_9765_ = _e13092;
                                                phi_9767_ = _e13094;
                                                phi_9769_ = _e13096;
                                                phi_9771_ = _e13098;
                                                break if !(_e13104);
                                            }
                                        }
                                        let _e13119 = local_108;
                                        if _e13119 {
                                            phi_11953_ = false;
                                            phi_11954_ = false;
                                            phi_11955_ = false;
                                            phi_11956_ = false;
                                            phi_11957_ = false;
                                        } else {
                                            let _e17094 = local_149;
                                            phi_11953_ = _e17094;
                                            let _e17097 = local_150;
                                            phi_11954_ = _e17097;
                                            let _e17100 = local_151;
                                            phi_11955_ = _e17100;
                                            let _e17103 = local_152;
                                            phi_11956_ = _e17103;
                                            let _e17106 = local_153;
                                            phi_11957_ = _e17106;
                                        }
                                        let _e13121 = phi_11953_;
                                        let _e13123 = phi_11954_;
                                        let _e13125 = phi_11955_;
                                        let _e13127 = phi_11956_;
                                        let _e13129 = phi_11957_;
                                        if _e13121 {
                                            let _e13131 = local_109;
                                            phi_11962_ = type_44(1u, _e13131);
                                            phi_11963_ = false;
                                            phi_11964_ = false;
                                            phi_11965_ = false;
                                            phi_11966_ = false;
                                            phi_11967_ = false;
                                        } else {
                                            phi_11962_ = type_44();
                                            phi_11963_ = _e13123;
                                            phi_11964_ = _e13125;
                                            let _e17113 = local_154;
                                            phi_11965_ = _e17113;
                                            phi_11966_ = _e13127;
                                            phi_11967_ = _e13129;
                                        }
                                        let _e13134 = phi_11962_;
                                        let _e13136 = phi_11963_;
                                        let _e13138 = phi_11964_;
                                        let _e13140 = phi_11965_;
                                        let _e13142 = phi_11966_;
                                        let _e13144 = phi_11967_;
                                        if _e13136 {
                                            phi_11972_ = type_44(0u, type_44().member_1);
                                            phi_11973_ = false;
                                            phi_11974_ = false;
                                            phi_11975_ = false;
                                            phi_11976_ = false;
                                            phi_11977_ = true;
                                        } else {
                                            phi_11972_ = _e13134;
                                            phi_11973_ = _e13138;
                                            phi_11974_ = _e13140;
                                            phi_11975_ = _e13142;
                                            phi_11976_ = _e13144;
                                            phi_11977_ = _e13121;
                                        }
                                        let _e13148 = phi_11972_;
                                        let _e13150 = phi_11973_;
                                        let _e13152 = phi_11974_;
                                        let _e13154 = phi_11975_;
                                        let _e13156 = phi_11976_;
                                        let _e13158 = phi_11977_;
                                        if _e13150 {
                                            let _e17124 = local_155;
                                            phi_11981_ = _e17124;
                                            phi_11982_ = true;
                                            phi_11983_ = false;
                                            phi_11984_ = false;
                                            phi_11985_ = false;
                                        } else {
                                            let _e17126 = local_156;
                                            phi_11981_ = _e17126;
                                            phi_11982_ = _e13152;
                                            phi_11983_ = _e13154;
                                            phi_11984_ = _e13156;
                                            phi_11985_ = _e13158;
                                        }
                                        let _e13160 = phi_11981_;
                                        let _e13162 = phi_11982_;
                                        let _e13164 = phi_11983_;
                                        let _e13166 = phi_11984_;
                                        let _e13168 = phi_11985_;
                                        if _e13162 {
                                            phi_11989_ = _e13160;
                                            phi_11990_ = true;
                                            phi_11991_ = false;
                                            phi_11992_ = false;
                                        } else {
                                            let _e17133 = local_157;
                                            phi_11989_ = _e17133;
                                            phi_11990_ = _e13164;
                                            phi_11991_ = _e13166;
                                            phi_11992_ = _e13168;
                                        }
                                        let _e13170 = phi_11989_;
                                        let _e13172 = phi_11990_;
                                        let _e13174 = phi_11991_;
                                        let _e13176 = phi_11992_;
                                        if _e13172 {
                                            phi_11997_ = type_44(1u, _e13170);
                                            phi_11998_ = false;
                                            phi_11999_ = false;
                                        } else {
                                            phi_11997_ = type_44();
                                            phi_11998_ = _e13174;
                                            phi_11999_ = _e13176;
                                        }
                                        let _e13179 = phi_11997_;
                                        let _e13181 = phi_11998_;
                                        let _e13183 = phi_11999_;
                                        if _e13181 {
                                            phi_12004_ = type_44(0u, type_44().member_1);
                                            phi_12005_ = true;
                                        } else {
                                            phi_12004_ = _e13148;
                                            phi_12005_ = _e13183;
                                        }
                                        let _e13187 = phi_12004_;
                                        let _e13189 = phi_12005_;
                                        if _e13189 {
                                            phi_12009_ = _e13187;
                                        } else {
                                            phi_12009_ = _e13179;
                                        }
                                        let _e13191 = phi_12009_;
                                        phi_12016_ = _e13191.member_1;
                                        phi_12017_ = (_e13191.member != 0u);
                                    } else {
                                        phi_12016_ = _e11387;
                                        phi_12017_ = true;
                                    }
                                    let _e13196 = phi_12016_;
                                    let _e13198 = phi_12017_;
                                    if _e13198 {
                                        let _e13199 = (_e13196 > _e5597);
                                        if _e13199 {
                                            phi_14182_ = f32();
                                            phi_14183_ = u32();
                                            phi_14184_ = f32();
                                            phi_14185_ = type_46();
                                            phi_14186_ = u32();
                                            phi_14187_ = u32();
                                            phi_14188_ = false;
                                            phi_14189_ = false;
                                            phi_14190_ = false;
                                        } else {
                                            let _e13202 = local_18.member[0u];
                                            let _e13208 = local_18.member[1u];
                                            let _e13224 = local_18.member_1[0u];
                                            let _e13230 = local_18.member_1[1u];
                                            let _e13246 = local_18.member_2[0u];
                                            let _e13252 = local_18.member_2[1u];
                                            let _e13266 = function_3(array<f32, 3>((_e13202[0] + ((_e13208[0] - _e13202[0]) * _e11391)), (_e13202[1] + ((_e13208[1] - _e13202[1]) * _e11391)), (_e13202[2] + ((_e13208[2] - _e13202[2]) * _e11391))), array<f32, 3>((_e13224[0] + ((_e13230[0] - _e13224[0]) * _e11391)), (_e13224[1] + ((_e13230[1] - _e13224[1]) * _e11391)), (_e13224[2] + ((_e13230[2] - _e13224[2]) * _e11391))), array<f32, 3>((_e13246[0] + ((_e13252[0] - _e13246[0]) * _e11391)), (_e13246[1] + ((_e13252[1] - _e13246[1]) * _e11391)), (_e13246[2] + ((_e13252[2] - _e13246[2]) * _e11391))), _e315.member);
                                            if (_e13266[0] < 0f) {
                                                phi_12129_ = -(_e13266[0]);
                                            } else {
                                                phi_12129_ = _e13266[0];
                                            }
                                            let _e13271 = phi_12129_;
                                            if (_e13266[1] < 0f) {
                                                phi_12136_ = -(_e13266[1]);
                                            } else {
                                                phi_12136_ = _e13266[1];
                                            }
                                            let _e13276 = phi_12136_;
                                            if (_e13266[2] < 0f) {
                                                phi_12144_ = -(_e13266[2]);
                                            } else {
                                                phi_12144_ = _e13266[2];
                                            }
                                            let _e13282 = phi_12144_;
                                            let _e13283 = ((_e13271 + _e13276) + _e13282);
                                            let _e13286 = local_18.member[0u];
                                            let _e13293 = local_18.member_1[0u];
                                            let _e13299 = local_18.member_2[0u];
                                            let _e13303 = (_e13286[0] - _e13293[0]);
                                            let _e13304 = (_e13286[1] - _e13293[1]);
                                            let _e13305 = (_e13286[2] - _e13293[2]);
                                            if (_e315.member == 0u) {
                                                phi_12202_ = array<f32, 3>(_e13286[0], _e13286[1], _e13286[2]);
                                            } else {
                                                phi_12202_ = array<f32, 3>((_e13303 - _e13299[0]), (_e13304 - _e13299[1]), (_e13305 - _e13299[2]));
                                            }
                                            let _e13312 = phi_12202_;
                                            let _e13318 = local_18.member[1u];
                                            let _e13325 = local_18.member_1[1u];
                                            let _e13331 = local_18.member_2[1u];
                                            let _e13335 = (_e13318[0] - _e13325[0]);
                                            let _e13336 = (_e13318[1] - _e13325[1]);
                                            let _e13337 = (_e13318[2] - _e13325[2]);
                                            if (_e315.member == 0u) {
                                                phi_12270_ = array<f32, 3>(_e13318[0], _e13318[1], _e13318[2]);
                                            } else {
                                                phi_12270_ = array<f32, 3>((_e13335 - _e13331[0]), (_e13336 - _e13331[1]), (_e13337 - _e13331[2]));
                                            }
                                            let _e13344 = phi_12270_;
                                            let _e13350 = local_18.member[0u];
                                            if (_e13350[0] < 0f) {
                                                phi_12295_ = -(_e13350[0]);
                                            } else {
                                                phi_12295_ = _e13350[0];
                                            }
                                            let _e13357 = phi_12295_;
                                            if (_e13350[1] < 0f) {
                                                phi_12302_ = -(_e13350[1]);
                                            } else {
                                                phi_12302_ = _e13350[1];
                                            }
                                            let _e13361 = phi_12302_;
                                            if (_e13357 > _e13361) {
                                                phi_12307_ = _e13357;
                                            } else {
                                                phi_12307_ = _e13361;
                                            }
                                            let _e13364 = phi_12307_;
                                            if (_e13350[2] < 0f) {
                                                phi_12314_ = -(_e13350[2]);
                                            } else {
                                                phi_12314_ = _e13350[2];
                                            }
                                            let _e13368 = phi_12314_;
                                            if (_e13364 > _e13368) {
                                                phi_12319_ = _e13364;
                                            } else {
                                                phi_12319_ = _e13368;
                                            }
                                            let _e13371 = phi_12319_;
                                            let _e13374 = local_18.member[1u];
                                            if (_e13374[0] < 0f) {
                                                phi_12332_ = -(_e13374[0]);
                                            } else {
                                                phi_12332_ = _e13374[0];
                                            }
                                            let _e13381 = phi_12332_;
                                            if (_e13374[1] < 0f) {
                                                phi_12339_ = -(_e13374[1]);
                                            } else {
                                                phi_12339_ = _e13374[1];
                                            }
                                            let _e13385 = phi_12339_;
                                            if (_e13381 > _e13385) {
                                                phi_12344_ = _e13381;
                                            } else {
                                                phi_12344_ = _e13385;
                                            }
                                            let _e13388 = phi_12344_;
                                            if (_e13374[2] < 0f) {
                                                phi_12351_ = -(_e13374[2]);
                                            } else {
                                                phi_12351_ = _e13374[2];
                                            }
                                            let _e13392 = phi_12351_;
                                            if (_e13388 > _e13392) {
                                                phi_12356_ = _e13388;
                                            } else {
                                                phi_12356_ = _e13392;
                                            }
                                            let _e13395 = phi_12356_;
                                            if (_e13371 > _e13395) {
                                                phi_12361_ = _e13371;
                                            } else {
                                                phi_12361_ = _e13395;
                                            }
                                            let _e13398 = phi_12361_;
                                            let _e13400 = local_18.member_3;
                                            let _e13404 = local_18.member_1[0u];
                                            if (_e13404[0] < 0f) {
                                                phi_12378_ = -(_e13404[0]);
                                            } else {
                                                phi_12378_ = _e13404[0];
                                            }
                                            let _e13411 = phi_12378_;
                                            if (_e13404[1] < 0f) {
                                                phi_12385_ = -(_e13404[1]);
                                            } else {
                                                phi_12385_ = _e13404[1];
                                            }
                                            let _e13415 = phi_12385_;
                                            if (_e13411 > _e13415) {
                                                phi_12390_ = _e13411;
                                            } else {
                                                phi_12390_ = _e13415;
                                            }
                                            let _e13418 = phi_12390_;
                                            if (_e13404[2] < 0f) {
                                                phi_12397_ = -(_e13404[2]);
                                            } else {
                                                phi_12397_ = _e13404[2];
                                            }
                                            let _e13422 = phi_12397_;
                                            if (_e13418 > _e13422) {
                                                phi_12402_ = _e13418;
                                            } else {
                                                phi_12402_ = _e13422;
                                            }
                                            let _e13425 = phi_12402_;
                                            let _e13428 = local_18.member_1[1u];
                                            if (_e13428[0] < 0f) {
                                                phi_12416_ = -(_e13428[0]);
                                            } else {
                                                phi_12416_ = _e13428[0];
                                            }
                                            let _e13435 = phi_12416_;
                                            if (_e13428[1] < 0f) {
                                                phi_12423_ = -(_e13428[1]);
                                            } else {
                                                phi_12423_ = _e13428[1];
                                            }
                                            let _e13439 = phi_12423_;
                                            if (_e13435 > _e13439) {
                                                phi_12428_ = _e13435;
                                            } else {
                                                phi_12428_ = _e13439;
                                            }
                                            let _e13442 = phi_12428_;
                                            if (_e13428[2] < 0f) {
                                                phi_12435_ = -(_e13428[2]);
                                            } else {
                                                phi_12435_ = _e13428[2];
                                            }
                                            let _e13446 = phi_12435_;
                                            if (_e13442 > _e13446) {
                                                phi_12440_ = _e13442;
                                            } else {
                                                phi_12440_ = _e13446;
                                            }
                                            let _e13449 = phi_12440_;
                                            if (_e13425 > _e13449) {
                                                phi_12445_ = _e13425;
                                            } else {
                                                phi_12445_ = _e13449;
                                            }
                                            let _e13452 = phi_12445_;
                                            let _e13454 = local_18.member_3;
                                            let _e13458 = local_18.member_2[0u];
                                            if (_e13458[0] < 0f) {
                                                phi_12462_ = -(_e13458[0]);
                                            } else {
                                                phi_12462_ = _e13458[0];
                                            }
                                            let _e13465 = phi_12462_;
                                            if (_e13458[1] < 0f) {
                                                phi_12469_ = -(_e13458[1]);
                                            } else {
                                                phi_12469_ = _e13458[1];
                                            }
                                            let _e13469 = phi_12469_;
                                            if (_e13465 > _e13469) {
                                                phi_12474_ = _e13465;
                                            } else {
                                                phi_12474_ = _e13469;
                                            }
                                            let _e13472 = phi_12474_;
                                            if (_e13458[2] < 0f) {
                                                phi_12481_ = -(_e13458[2]);
                                            } else {
                                                phi_12481_ = _e13458[2];
                                            }
                                            let _e13476 = phi_12481_;
                                            if (_e13472 > _e13476) {
                                                phi_12486_ = _e13472;
                                            } else {
                                                phi_12486_ = _e13476;
                                            }
                                            let _e13479 = phi_12486_;
                                            let _e13482 = local_18.member_2[1u];
                                            if (_e13482[0] < 0f) {
                                                phi_12500_ = -(_e13482[0]);
                                            } else {
                                                phi_12500_ = _e13482[0];
                                            }
                                            let _e13489 = phi_12500_;
                                            if (_e13482[1] < 0f) {
                                                phi_12507_ = -(_e13482[1]);
                                            } else {
                                                phi_12507_ = _e13482[1];
                                            }
                                            let _e13493 = phi_12507_;
                                            if (_e13489 > _e13493) {
                                                phi_12512_ = _e13489;
                                            } else {
                                                phi_12512_ = _e13493;
                                            }
                                            let _e13496 = phi_12512_;
                                            if (_e13482[2] < 0f) {
                                                phi_12519_ = -(_e13482[2]);
                                            } else {
                                                phi_12519_ = _e13482[2];
                                            }
                                            let _e13500 = phi_12519_;
                                            if (_e13496 > _e13500) {
                                                phi_12524_ = _e13496;
                                            } else {
                                                phi_12524_ = _e13500;
                                            }
                                            let _e13503 = phi_12524_;
                                            if (_e13479 > _e13503) {
                                                phi_12529_ = _e13479;
                                            } else {
                                                phi_12529_ = _e13503;
                                            }
                                            let _e13506 = phi_12529_;
                                            let _e13508 = local_18.member_3;
                                            let _e13515 = local_18.member_3;
                                            local_14 = type_33(array<array<array<f32, 3>, 4>, 2>(array<array<f32, 3>, 4>(_e13286, array<f32, 3>(_e13303, _e13304, _e13305), array<f32, 3>((_e13286[0] - _e13299[0]), (_e13286[1] - _e13299[1]), (_e13286[2] - _e13299[2])), array<f32, 3>(_e13312[0], _e13312[1], _e13312[2])), array<array<f32, 3>, 4>(_e13318, array<f32, 3>(_e13335, _e13336, _e13337), array<f32, 3>((_e13318[0] - _e13331[0]), (_e13318[1] - _e13331[1]), (_e13318[2] - _e13331[2])), array<f32, 3>(_e13344[0], _e13344[1], _e13344[2]))), ((((((_e13398 + _e13400) + (_e13452 + _e13454)) + (_e13506 + _e13508)) * (0.000000059604645f * 16f)) + (_e13515 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)), _e5865.member_1);
                                            let _e13537 = local_14.member_1;
                                            if (_e13283 > _e13537) {
                                                if ((bitcast<u32>(_e13283) & 2139095040u) != 2139095040u) {
                                                    let _e13542 = (1f / _e13283);
                                                    let _e13544 = (_e13266[0] * _e13542);
                                                    let _e13546 = (_e13266[1] * _e13542);
                                                    let _e13548 = (_e13266[2] * _e13542);
                                                    let _e13553 = (((_e13544 * _e13544) + (_e13546 * _e13546)) + (_e13548 * _e13548));
                                                    if (_e13553 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e13553 > 0f) {
                                                            phi_12630_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_12630_ = 0f;
                                                        }
                                                        let _e13606 = phi_12630_;
                                                        phi_12694_ = _e13606;
                                                    } else {
                                                        phi_12637_ = type_14(0i, 5i);
                                                        phi_12640_ = bitcast<f32>(((bitcast<u32>(_e13553) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e13561 = phi_12637_;
                                                            let _e13563 = phi_12640_;
                                                            local_110 = _e13563;
                                                            if (_e13561.member < _e13561.member_1) {
                                                                let _e13570 = (_e13561.member + 1i);
                                                                if ((false == (_e13570 > _e13561.member)) != false) {
                                                                    phi_12661_ = true;
                                                                } else {
                                                                    phi_12661_ = false;
                                                                }
                                                                let _e13575 = phi_12661_;
                                                                if _e13575 {
                                                                    phi_12667_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_12667_ = type_15(1u, _e13570);
                                                                }
                                                                let _e13580 = phi_12667_;
                                                                phi_12638_ = type_14(_e13580.member_1, _e13561.member_1);
                                                                phi_12681_ = type_15(1u, _e13561.member);
                                                            } else {
                                                                phi_12638_ = _e13561;
                                                                phi_12681_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e13586 = phi_12638_;
                                                            let _e13588 = phi_12681_;
                                                            let _e13591 = (bitcast<i32>(_e13588.member) != 0i);
                                                            if _e13591 {
                                                                phi_12641_ = (0.5f * (_e13563 + (_e13553 / _e13563)));
                                                            } else {
                                                                phi_12641_ = f32();
                                                            }
                                                            let _e13596 = phi_12641_;
                                                            continue;
                                                            continuing {
                                                                phi_12637_ = _e13586;
                                                                phi_12640_ = _e13596;
                                                                break if !(_e13591);
                                                            }
                                                        }
                                                        let _e13601 = local_110;
                                                        phi_12694_ = (_e13601 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e13608 = phi_12694_;
                                                    let _e13609 = (0.000000059604645f * 12f);
                                                    let _e13611 = local_14.member_1;
                                                    let _e13614 = local_14.member_2;
                                                    let _e13618 = ((_e13611 * 1.01f) + ((_e13614 * _e13608) * (1f + _e13609)));
                                                    let _e13622 = local_14.member[0u][0u];
                                                    let _e13630 = (((_e13544 * _e13622[0]) + (_e13546 * _e13622[1])) + (_e13548 * _e13622[2]));
                                                    let _e13634 = local_14.member[0u][1u];
                                                    let _e13642 = (((_e13544 * _e13634[0]) + (_e13546 * _e13634[1])) + (_e13548 * _e13634[2]));
                                                    let _e13646 = local_14.member[0u][2u];
                                                    let _e13654 = (((_e13544 * _e13646[0]) + (_e13546 * _e13646[1])) + (_e13548 * _e13646[2]));
                                                    let _e13658 = local_14.member[0u][3u];
                                                    let _e13666 = (((_e13544 * _e13658[0]) + (_e13546 * _e13658[1])) + (_e13548 * _e13658[2]));
                                                    let _e13670 = local_14.member[1u][0u];
                                                    let _e13678 = (((_e13544 * _e13670[0]) + (_e13546 * _e13670[1])) + (_e13548 * _e13670[2]));
                                                    let _e13682 = local_14.member[1u][1u];
                                                    let _e13690 = (((_e13544 * _e13682[0]) + (_e13546 * _e13682[1])) + (_e13548 * _e13682[2]));
                                                    let _e13694 = local_14.member[1u][2u];
                                                    let _e13702 = (((_e13544 * _e13694[0]) + (_e13546 * _e13694[1])) + (_e13548 * _e13694[2]));
                                                    let _e13706 = local_14.member[1u][3u];
                                                    let _e13714 = (((_e13544 * _e13706[0]) + (_e13546 * _e13706[1])) + (_e13548 * _e13706[2]));
                                                    if (_e13630 < 0f) {
                                                        phi_12828_ = -(_e13630);
                                                    } else {
                                                        phi_12828_ = _e13630;
                                                    }
                                                    let _e13718 = phi_12828_;
                                                    if (_e13678 < 0f) {
                                                        phi_12834_ = -(_e13678);
                                                    } else {
                                                        phi_12834_ = _e13678;
                                                    }
                                                    let _e13722 = phi_12834_;
                                                    if (_e13642 < 0f) {
                                                        phi_12843_ = -(_e13642);
                                                    } else {
                                                        phi_12843_ = _e13642;
                                                    }
                                                    let _e13729 = phi_12843_;
                                                    if (_e13690 < 0f) {
                                                        phi_12849_ = -(_e13690);
                                                    } else {
                                                        phi_12849_ = _e13690;
                                                    }
                                                    let _e13733 = phi_12849_;
                                                    if (_e13654 < 0f) {
                                                        phi_12858_ = -(_e13654);
                                                    } else {
                                                        phi_12858_ = _e13654;
                                                    }
                                                    let _e13740 = phi_12858_;
                                                    if (_e13702 < 0f) {
                                                        phi_12864_ = -(_e13702);
                                                    } else {
                                                        phi_12864_ = _e13702;
                                                    }
                                                    let _e13744 = phi_12864_;
                                                    if (_e13666 < 0f) {
                                                        phi_12873_ = -(_e13666);
                                                    } else {
                                                        phi_12873_ = _e13666;
                                                    }
                                                    let _e13751 = phi_12873_;
                                                    if (_e13714 < 0f) {
                                                        phi_12879_ = -(_e13714);
                                                    } else {
                                                        phi_12879_ = _e13714;
                                                    }
                                                    let _e13755 = phi_12879_;
                                                    local_15 = type_29(array<f32, 4>(_e13630, _e13642, _e13654, _e13666), array<f32, 4>(_e13678, _e13690, _e13702, _e13714), array<f32, 4>((_e13618 + ((_e13718 + _e13722) * _e13609)), (_e13618 + ((_e13729 + _e13733) * _e13609)), (_e13618 + ((_e13740 + _e13744) * _e13609)), (_e13618 + ((_e13751 + _e13755) * _e13609))));
                                                    let _e13767 = (((_e13544 * _e13544) + (_e13546 * _e13546)) + (_e13548 * _e13548));
                                                    if (_e13767 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e13767 > 0f) {
                                                            phi_12922_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_12922_ = 0f;
                                                        }
                                                        let _e13820 = phi_12922_;
                                                        phi_12986_ = _e13820;
                                                    } else {
                                                        phi_12929_ = type_14(0i, 5i);
                                                        phi_12932_ = bitcast<f32>(((bitcast<u32>(_e13767) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e13775 = phi_12929_;
                                                            let _e13777 = phi_12932_;
                                                            local_111 = _e13777;
                                                            if (_e13775.member < _e13775.member_1) {
                                                                let _e13784 = (_e13775.member + 1i);
                                                                if ((false == (_e13784 > _e13775.member)) != false) {
                                                                    phi_12953_ = true;
                                                                } else {
                                                                    phi_12953_ = false;
                                                                }
                                                                let _e13789 = phi_12953_;
                                                                if _e13789 {
                                                                    phi_12959_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_12959_ = type_15(1u, _e13784);
                                                                }
                                                                let _e13794 = phi_12959_;
                                                                phi_12930_ = type_14(_e13794.member_1, _e13775.member_1);
                                                                phi_12973_ = type_15(1u, _e13775.member);
                                                            } else {
                                                                phi_12930_ = _e13775;
                                                                phi_12973_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e13800 = phi_12930_;
                                                            let _e13802 = phi_12973_;
                                                            let _e13805 = (bitcast<i32>(_e13802.member) != 0i);
                                                            if _e13805 {
                                                                phi_12933_ = (0.5f * (_e13777 + (_e13767 / _e13777)));
                                                            } else {
                                                                phi_12933_ = f32();
                                                            }
                                                            let _e13810 = phi_12933_;
                                                            continue;
                                                            continuing {
                                                                phi_12929_ = _e13800;
                                                                phi_12932_ = _e13810;
                                                                break if !(_e13805);
                                                            }
                                                        }
                                                        let _e13815 = local_111;
                                                        phi_12986_ = (_e13815 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e13822 = phi_12986_;
                                                    let _e13833 = (((_e13266[0] * _e13266[0]) + (_e13266[1] * _e13266[1])) + (_e13266[2] * _e13266[2]));
                                                    if (_e13833 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e13833 > 0f) {
                                                            phi_13011_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_13011_ = 0f;
                                                        }
                                                        let _e13886 = phi_13011_;
                                                        phi_13075_ = _e13886;
                                                    } else {
                                                        phi_13018_ = type_14(0i, 5i);
                                                        phi_13021_ = bitcast<f32>(((bitcast<u32>(_e13833) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e13841 = phi_13018_;
                                                            let _e13843 = phi_13021_;
                                                            local_112 = _e13843;
                                                            if (_e13841.member < _e13841.member_1) {
                                                                let _e13850 = (_e13841.member + 1i);
                                                                if ((false == (_e13850 > _e13841.member)) != false) {
                                                                    phi_13042_ = true;
                                                                } else {
                                                                    phi_13042_ = false;
                                                                }
                                                                let _e13855 = phi_13042_;
                                                                if _e13855 {
                                                                    phi_13048_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_13048_ = type_15(1u, _e13850);
                                                                }
                                                                let _e13860 = phi_13048_;
                                                                phi_13019_ = type_14(_e13860.member_1, _e13841.member_1);
                                                                phi_13062_ = type_15(1u, _e13841.member);
                                                            } else {
                                                                phi_13019_ = _e13841;
                                                                phi_13062_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e13866 = phi_13019_;
                                                            let _e13868 = phi_13062_;
                                                            let _e13871 = (bitcast<i32>(_e13868.member) != 0i);
                                                            if _e13871 {
                                                                phi_13022_ = (0.5f * (_e13843 + (_e13833 / _e13843)));
                                                            } else {
                                                                phi_13022_ = f32();
                                                            }
                                                            let _e13876 = phi_13022_;
                                                            continue;
                                                            continuing {
                                                                phi_13018_ = _e13866;
                                                                phi_13021_ = _e13876;
                                                                break if !(_e13871);
                                                            }
                                                        }
                                                        let _e13881 = local_112;
                                                        phi_13075_ = (_e13881 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e13888 = phi_13075_;
                                                    let _e13894 = local_18.member[0u];
                                                    if (_e13894[0] < 0f) {
                                                        phi_13091_ = -(_e13894[0]);
                                                    } else {
                                                        phi_13091_ = _e13894[0];
                                                    }
                                                    let _e13901 = phi_13091_;
                                                    if (_e13894[1] < 0f) {
                                                        phi_13098_ = -(_e13894[1]);
                                                    } else {
                                                        phi_13098_ = _e13894[1];
                                                    }
                                                    let _e13905 = phi_13098_;
                                                    if (_e13901 > _e13905) {
                                                        phi_13103_ = _e13901;
                                                    } else {
                                                        phi_13103_ = _e13905;
                                                    }
                                                    let _e13908 = phi_13103_;
                                                    if (_e13894[2] < 0f) {
                                                        phi_13110_ = -(_e13894[2]);
                                                    } else {
                                                        phi_13110_ = _e13894[2];
                                                    }
                                                    let _e13912 = phi_13110_;
                                                    if (_e13908 > _e13912) {
                                                        phi_13115_ = _e13908;
                                                    } else {
                                                        phi_13115_ = _e13912;
                                                    }
                                                    let _e13915 = phi_13115_;
                                                    let _e13918 = local_18.member[1u];
                                                    if (_e13918[0] < 0f) {
                                                        phi_13128_ = -(_e13918[0]);
                                                    } else {
                                                        phi_13128_ = _e13918[0];
                                                    }
                                                    let _e13925 = phi_13128_;
                                                    if (_e13918[1] < 0f) {
                                                        phi_13135_ = -(_e13918[1]);
                                                    } else {
                                                        phi_13135_ = _e13918[1];
                                                    }
                                                    let _e13929 = phi_13135_;
                                                    if (_e13925 > _e13929) {
                                                        phi_13140_ = _e13925;
                                                    } else {
                                                        phi_13140_ = _e13929;
                                                    }
                                                    let _e13932 = phi_13140_;
                                                    if (_e13918[2] < 0f) {
                                                        phi_13147_ = -(_e13918[2]);
                                                    } else {
                                                        phi_13147_ = _e13918[2];
                                                    }
                                                    let _e13936 = phi_13147_;
                                                    if (_e13932 > _e13936) {
                                                        phi_13152_ = _e13932;
                                                    } else {
                                                        phi_13152_ = _e13936;
                                                    }
                                                    let _e13939 = phi_13152_;
                                                    if (_e13915 > _e13939) {
                                                        phi_13157_ = _e13915;
                                                    } else {
                                                        phi_13157_ = _e13939;
                                                    }
                                                    let _e13942 = phi_13157_;
                                                    let _e13944 = local_18.member_3;
                                                    let _e13948 = local_18.member_1[0u];
                                                    if (_e13948[0] < 0f) {
                                                        phi_13174_ = -(_e13948[0]);
                                                    } else {
                                                        phi_13174_ = _e13948[0];
                                                    }
                                                    let _e13955 = phi_13174_;
                                                    if (_e13948[1] < 0f) {
                                                        phi_13181_ = -(_e13948[1]);
                                                    } else {
                                                        phi_13181_ = _e13948[1];
                                                    }
                                                    let _e13959 = phi_13181_;
                                                    if (_e13955 > _e13959) {
                                                        phi_13186_ = _e13955;
                                                    } else {
                                                        phi_13186_ = _e13959;
                                                    }
                                                    let _e13962 = phi_13186_;
                                                    if (_e13948[2] < 0f) {
                                                        phi_13193_ = -(_e13948[2]);
                                                    } else {
                                                        phi_13193_ = _e13948[2];
                                                    }
                                                    let _e13966 = phi_13193_;
                                                    if (_e13962 > _e13966) {
                                                        phi_13198_ = _e13962;
                                                    } else {
                                                        phi_13198_ = _e13966;
                                                    }
                                                    let _e13969 = phi_13198_;
                                                    let _e13972 = local_18.member_1[1u];
                                                    if (_e13972[0] < 0f) {
                                                        phi_13212_ = -(_e13972[0]);
                                                    } else {
                                                        phi_13212_ = _e13972[0];
                                                    }
                                                    let _e13979 = phi_13212_;
                                                    if (_e13972[1] < 0f) {
                                                        phi_13219_ = -(_e13972[1]);
                                                    } else {
                                                        phi_13219_ = _e13972[1];
                                                    }
                                                    let _e13983 = phi_13219_;
                                                    if (_e13979 > _e13983) {
                                                        phi_13224_ = _e13979;
                                                    } else {
                                                        phi_13224_ = _e13983;
                                                    }
                                                    let _e13986 = phi_13224_;
                                                    if (_e13972[2] < 0f) {
                                                        phi_13231_ = -(_e13972[2]);
                                                    } else {
                                                        phi_13231_ = _e13972[2];
                                                    }
                                                    let _e13990 = phi_13231_;
                                                    if (_e13986 > _e13990) {
                                                        phi_13236_ = _e13986;
                                                    } else {
                                                        phi_13236_ = _e13990;
                                                    }
                                                    let _e13993 = phi_13236_;
                                                    if (_e13969 > _e13993) {
                                                        phi_13241_ = _e13969;
                                                    } else {
                                                        phi_13241_ = _e13993;
                                                    }
                                                    let _e13996 = phi_13241_;
                                                    let _e13998 = local_18.member_3;
                                                    let _e14002 = local_18.member_2[0u];
                                                    if (_e14002[0] < 0f) {
                                                        phi_13258_ = -(_e14002[0]);
                                                    } else {
                                                        phi_13258_ = _e14002[0];
                                                    }
                                                    let _e14009 = phi_13258_;
                                                    if (_e14002[1] < 0f) {
                                                        phi_13265_ = -(_e14002[1]);
                                                    } else {
                                                        phi_13265_ = _e14002[1];
                                                    }
                                                    let _e14013 = phi_13265_;
                                                    if (_e14009 > _e14013) {
                                                        phi_13270_ = _e14009;
                                                    } else {
                                                        phi_13270_ = _e14013;
                                                    }
                                                    let _e14016 = phi_13270_;
                                                    if (_e14002[2] < 0f) {
                                                        phi_13277_ = -(_e14002[2]);
                                                    } else {
                                                        phi_13277_ = _e14002[2];
                                                    }
                                                    let _e14020 = phi_13277_;
                                                    if (_e14016 > _e14020) {
                                                        phi_13282_ = _e14016;
                                                    } else {
                                                        phi_13282_ = _e14020;
                                                    }
                                                    let _e14023 = phi_13282_;
                                                    let _e14026 = local_18.member_2[1u];
                                                    if (_e14026[0] < 0f) {
                                                        phi_13296_ = -(_e14026[0]);
                                                    } else {
                                                        phi_13296_ = _e14026[0];
                                                    }
                                                    let _e14033 = phi_13296_;
                                                    if (_e14026[1] < 0f) {
                                                        phi_13303_ = -(_e14026[1]);
                                                    } else {
                                                        phi_13303_ = _e14026[1];
                                                    }
                                                    let _e14037 = phi_13303_;
                                                    if (_e14033 > _e14037) {
                                                        phi_13308_ = _e14033;
                                                    } else {
                                                        phi_13308_ = _e14037;
                                                    }
                                                    let _e14040 = phi_13308_;
                                                    if (_e14026[2] < 0f) {
                                                        phi_13315_ = -(_e14026[2]);
                                                    } else {
                                                        phi_13315_ = _e14026[2];
                                                    }
                                                    let _e14044 = phi_13315_;
                                                    if (_e14040 > _e14044) {
                                                        phi_13320_ = _e14040;
                                                    } else {
                                                        phi_13320_ = _e14044;
                                                    }
                                                    let _e14047 = phi_13320_;
                                                    if (_e14023 > _e14047) {
                                                        phi_13325_ = _e14023;
                                                    } else {
                                                        phi_13325_ = _e14047;
                                                    }
                                                    let _e14050 = phi_13325_;
                                                    let _e14052 = local_18.member_3;
                                                    let _e14059 = local_18.member_3;
                                                    let _e14069 = ((((_e13888 * (1f + (0.000000059604645f * 8f))) + (((((((_e13942 + _e13944) + (_e13996 + _e13998)) + (_e14050 + _e14052)) * (0.000000059604645f * 16f)) + (_e14059 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) * _e13822) * (1f + (0.000000059604645f * 64f)));
                                                    let _e14072 = local_15.member[0u];
                                                    let _e14075 = local_15.member_1[0u];
                                                    if (_e14072 < 0f) {
                                                        phi_13366_ = -(_e14072);
                                                    } else {
                                                        phi_13366_ = _e14072;
                                                    }
                                                    let _e14080 = phi_13366_;
                                                    if (_e14075 < 0f) {
                                                        phi_13372_ = -(_e14075);
                                                    } else {
                                                        phi_13372_ = _e14075;
                                                    }
                                                    let _e14084 = phi_13372_;
                                                    phi_13383_ = type_9(1u, 4u);
                                                    phi_13386_ = ((_e14072 + ((_e14075 - _e14072) * _e11391)) - ((_e13537 * 1.01f) + ((_e14080 + _e14084) * (0.000000059604645f * 12f))));
                                                    loop {
                                                        let _e14094 = phi_13383_;
                                                        let _e14096 = phi_13386_;
                                                        local_113 = _e14096;
                                                        local_114 = _e14096;
                                                        if (_e14094.member < _e14094.member_1) {
                                                            phi_13384_ = type_9((_e14094.member + 1u), _e14094.member_1);
                                                            phi_13409_ = type_9(1u, _e14094.member);
                                                        } else {
                                                            phi_13384_ = _e14094;
                                                            phi_13409_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e14108 = phi_13384_;
                                                        let _e14110 = phi_13409_;
                                                        let _e14114 = (bitcast<i32>(_e14110.member) != 0i);
                                                        if _e14114 {
                                                            let _e14117 = local_15.member[_e14110.member_1];
                                                            let _e14120 = local_15.member_1[_e14110.member_1];
                                                            if (_e14117 < 0f) {
                                                                phi_13438_ = -(_e14117);
                                                            } else {
                                                                phi_13438_ = _e14117;
                                                            }
                                                            let _e14125 = phi_13438_;
                                                            if (_e14120 < 0f) {
                                                                phi_13444_ = -(_e14120);
                                                            } else {
                                                                phi_13444_ = _e14120;
                                                            }
                                                            let _e14129 = phi_13444_;
                                                            let _e14137 = ((_e14117 + ((_e14120 - _e14117) * _e11391)) - ((_e13537 * 1.01f) + ((_e14125 + _e14129) * (0.000000059604645f * 12f))));
                                                            if (_e14096 < _e14137) {
                                                                phi_13457_ = _e14096;
                                                            } else {
                                                                phi_13457_ = _e14137;
                                                            }
                                                            let _e14140 = phi_13457_;
                                                            phi_13387_ = _e14140;
                                                        } else {
                                                            phi_13387_ = f32();
                                                        }
                                                        let _e14142 = phi_13387_;
                                                        continue;
                                                        continuing {
                                                            phi_13383_ = _e14108;
                                                            phi_13386_ = _e14142;
                                                            break if !(_e14114);
                                                        }
                                                    }
                                                    let _e14145 = local_113;
                                                    if (_e14145 > 0f) {
                                                        let _e14149 = local_114;
                                                        let _e14152 = (((_e14069 - _e14149) / _e14069) * 2.02f);
                                                        if (_e14152 <= 0.000000000000000000000000000000000000011754944f) {
                                                            if (_e14152 > 0f) {
                                                                phi_13478_ = (0.000000000000000000106433627f * 2f);
                                                            } else {
                                                                phi_13478_ = 0f;
                                                            }
                                                            let _e14205 = phi_13478_;
                                                            phi_13542_ = _e14205;
                                                        } else {
                                                            phi_13485_ = type_14(0i, 5i);
                                                            phi_13488_ = bitcast<f32>(((bitcast<u32>(_e14152) >> bitcast<u32>(1i)) + 532369198u));
                                                            loop {
                                                                let _e14160 = phi_13485_;
                                                                let _e14162 = phi_13488_;
                                                                local_115 = _e14162;
                                                                if (_e14160.member < _e14160.member_1) {
                                                                    let _e14169 = (_e14160.member + 1i);
                                                                    if ((false == (_e14169 > _e14160.member)) != false) {
                                                                        phi_13509_ = true;
                                                                    } else {
                                                                        phi_13509_ = false;
                                                                    }
                                                                    let _e14174 = phi_13509_;
                                                                    if _e14174 {
                                                                        phi_13515_ = type_15(0u, type_15().member_1);
                                                                    } else {
                                                                        phi_13515_ = type_15(1u, _e14169);
                                                                    }
                                                                    let _e14179 = phi_13515_;
                                                                    phi_13486_ = type_14(_e14179.member_1, _e14160.member_1);
                                                                    phi_13529_ = type_15(1u, _e14160.member);
                                                                } else {
                                                                    phi_13486_ = _e14160;
                                                                    phi_13529_ = type_15(0u, type_15().member_1);
                                                                }
                                                                let _e14185 = phi_13486_;
                                                                let _e14187 = phi_13529_;
                                                                let _e14190 = (bitcast<i32>(_e14187.member) != 0i);
                                                                if _e14190 {
                                                                    phi_13489_ = (0.5f * (_e14162 + (_e14152 / _e14162)));
                                                                } else {
                                                                    phi_13489_ = f32();
                                                                }
                                                                let _e14195 = phi_13489_;
                                                                continue;
                                                                continuing {
                                                                    phi_13485_ = _e14185;
                                                                    phi_13488_ = _e14195;
                                                                    break if !(_e14190);
                                                                }
                                                            }
                                                            let _e14200 = local_115;
                                                            phi_13542_ = (_e14200 * (1f + (8f * 0.000000059604645f)));
                                                        }
                                                        let _e14207 = phi_13542_;
                                                        let _e14209 = ((_e14207 * _e13822) * 1.01f);
                                                        phi_13547_ = type_9(0u, 4u);
                                                        phi_13550_ = 2f;
                                                        phi_13552_ = true;
                                                        phi_13554_ = true;
                                                        loop {
                                                            let _e14211 = phi_13547_;
                                                            let _e14213 = phi_13550_;
                                                            let _e14215 = phi_13552_;
                                                            let _e14217 = phi_13554_;
                                                            local_116 = _e14213;
                                                            local_158 = _e14213;
                                                            local_117 = _e14215;
                                                            local_118 = _e14217;
                                                            local_159 = _e14217;
                                                            local_119 = _e14217;
                                                            if (_e14211.member < _e14211.member_1) {
                                                                phi_13548_ = type_9((_e14211.member + 1u), _e14211.member_1);
                                                                phi_13577_ = type_9(1u, _e14211.member);
                                                            } else {
                                                                phi_13548_ = _e14211;
                                                                phi_13577_ = type_9(0u, type_9().member_1);
                                                            }
                                                            let _e14229 = phi_13548_;
                                                            let _e14231 = phi_13577_;
                                                            let _e14235 = (bitcast<i32>(_e14231.member) != 0i);
                                                            if _e14235 {
                                                                let _e14239 = local_14.member[0u][_e14231.member_1];
                                                                let _e14246 = local_14.member[1u][_e14231.member_1];
                                                                if (_e14239[0] < 0f) {
                                                                    phi_13614_ = -(_e14239[0]);
                                                                } else {
                                                                    phi_13614_ = _e14239[0];
                                                                }
                                                                let _e14253 = phi_13614_;
                                                                if (_e14239[1] < 0f) {
                                                                    phi_13621_ = -(_e14239[1]);
                                                                } else {
                                                                    phi_13621_ = _e14239[1];
                                                                }
                                                                let _e14257 = phi_13621_;
                                                                if (_e14239[2] < 0f) {
                                                                    phi_13629_ = -(_e14239[2]);
                                                                } else {
                                                                    phi_13629_ = _e14239[2];
                                                                }
                                                                let _e14262 = phi_13629_;
                                                                let _e14263 = ((_e14253 + _e14257) + _e14262);
                                                                if (_e14246[0] < 0f) {
                                                                    phi_13637_ = -(_e14246[0]);
                                                                } else {
                                                                    phi_13637_ = _e14246[0];
                                                                }
                                                                let _e14267 = phi_13637_;
                                                                if (_e14246[1] < 0f) {
                                                                    phi_13644_ = -(_e14246[1]);
                                                                } else {
                                                                    phi_13644_ = _e14246[1];
                                                                }
                                                                let _e14271 = phi_13644_;
                                                                if (_e14246[2] < 0f) {
                                                                    phi_13652_ = -(_e14246[2]);
                                                                } else {
                                                                    phi_13652_ = _e14246[2];
                                                                }
                                                                let _e14276 = phi_13652_;
                                                                let _e14277 = ((_e14267 + _e14271) + _e14276);
                                                                if (_e14263 > _e14277) {
                                                                    phi_13658_ = _e14263;
                                                                } else {
                                                                    phi_13658_ = _e14277;
                                                                }
                                                                let _e14280 = phi_13658_;
                                                                let _e14284 = (_e14246[0] - _e14239[0]);
                                                                let _e14285 = (_e14246[1] - _e14239[1]);
                                                                let _e14286 = (_e14246[2] - _e14239[2]);
                                                                if (_e14284 < 0f) {
                                                                    phi_13676_ = -(_e14284);
                                                                } else {
                                                                    phi_13676_ = _e14284;
                                                                }
                                                                let _e14290 = phi_13676_;
                                                                if (_e14285 < 0f) {
                                                                    phi_13682_ = -(_e14285);
                                                                } else {
                                                                    phi_13682_ = _e14285;
                                                                }
                                                                let _e14294 = phi_13682_;
                                                                if (_e14286 < 0f) {
                                                                    phi_13689_ = -(_e14286);
                                                                } else {
                                                                    phi_13689_ = _e14286;
                                                                }
                                                                let _e14299 = phi_13689_;
                                                                let _e14306 = local_15.member[_e14231.member_1];
                                                                let _e14309 = local_15.member_1[_e14231.member_1];
                                                                if (_e14306 < 0f) {
                                                                    phi_13715_ = -(_e14306);
                                                                } else {
                                                                    phi_13715_ = _e14306;
                                                                }
                                                                let _e14314 = phi_13715_;
                                                                if (_e14309 < 0f) {
                                                                    phi_13721_ = -(_e14309);
                                                                } else {
                                                                    phi_13721_ = _e14309;
                                                                }
                                                                let _e14318 = phi_13721_;
                                                                let _e14322 = ((_e13537 * 1.01f) + ((_e14314 + _e14318) * (0.000000059604645f * 12f)));
                                                                let _e14329 = local_15.member_1[_e14231.member_1];
                                                                let _e14332 = local_15.member[_e14231.member_1];
                                                                let _e14333 = (_e14329 - _e14332);
                                                                let _e14336 = ((_e14322 + _e14322) + (_e14209 * ((((_e14290 + _e14294) + _e14299) + (_e13537 * 6f)) * 1.01f)));
                                                                let _e14339 = ((((_e14306 + ((_e14309 - _e14306) * _e11391)) - _e14322) - (_e14209 * ((_e14280 + (_e13537 * 3f)) * 1.01f))) - _e14069);
                                                                let _e14340 = (_e14339 > 0.000000000000000000000000000000000000011754944f);
                                                                let _e14341 = (_e14333 > _e14336);
                                                                if _e14341 {
                                                                    phi_13757_ = true;
                                                                } else {
                                                                    phi_13757_ = _e14340;
                                                                }
                                                                let _e14343 = phi_13757_;
                                                                if (_e14333 < -(_e14336)) {
                                                                    phi_13764_ = true;
                                                                } else {
                                                                    phi_13764_ = _e14340;
                                                                }
                                                                let _e14348 = phi_13764_;
                                                                if _e14341 {
                                                                    phi_13785_ = _e14213;
                                                                } else {
                                                                    if _e14340 {
                                                                        let _e14350 = (_e14336 - _e14333);
                                                                        if (_e14350 > 0.000000000000000000000000000000000000011754944f) {
                                                                            phi_13777_ = _e14350;
                                                                        } else {
                                                                            phi_13777_ = 0.000000000000000000000000000000000000011754944f;
                                                                        }
                                                                        let _e14353 = phi_13777_;
                                                                        let _e14354 = (_e14339 / _e14353);
                                                                        if (_e14213 < _e14354) {
                                                                            phi_13783_ = _e14213;
                                                                        } else {
                                                                            phi_13783_ = _e14354;
                                                                        }
                                                                        let _e14357 = phi_13783_;
                                                                        phi_13784_ = _e14357;
                                                                    } else {
                                                                        phi_13784_ = _e14213;
                                                                    }
                                                                    let _e14359 = phi_13784_;
                                                                    phi_13785_ = _e14359;
                                                                }
                                                                let _e14361 = phi_13785_;
                                                                phi_13551_ = _e14361;
                                                                phi_13553_ = (_e14215 && _e14348);
                                                                phi_13555_ = (_e14217 && _e14343);
                                                            } else {
                                                                phi_13551_ = f32();
                                                                phi_13553_ = bool();
                                                                phi_13555_ = bool();
                                                            }
                                                            let _e14363 = phi_13551_;
                                                            let _e14365 = phi_13553_;
                                                            let _e14367 = phi_13555_;
                                                            continue;
                                                            continuing {
                                                                phi_13547_ = _e14229;
                                                                phi_13550_ = _e14363;
                                                                phi_13552_ = _e14365;
                                                                phi_13554_ = _e14367;
                                                                break if !(_e14235);
                                                            }
                                                        }
                                                        let _e14370 = local_116;
                                                        if (_e14370 < 2f) {
                                                            let _e17306 = local_158;
                                                            phi_13790_ = _e17306;
                                                        } else {
                                                            phi_13790_ = 2f;
                                                        }
                                                        let _e14373 = phi_13790_;
                                                        let _e14374 = (_e14373 * 0.999f);
                                                        let _e14376 = local_117;
                                                        if _e14376 {
                                                            let _e14378 = local_118;
                                                            if _e14378 {
                                                                phi_13799_ = type_46();
                                                            } else {
                                                                phi_13799_ = type_46(1u, _e11391, 2f);
                                                            }
                                                            let _e14381 = phi_13799_;
                                                            phi_13800_ = _e14381;
                                                            let _e17313 = local_159;
                                                            phi_13801_ = _e17313;
                                                        } else {
                                                            phi_13800_ = type_46();
                                                            phi_13801_ = true;
                                                        }
                                                        let _e14383 = phi_13800_;
                                                        let _e14385 = phi_13801_;
                                                        if _e14385 {
                                                            let _e14387 = local_119;
                                                            if _e14387 {
                                                                if (_e14374 > (0.000000059604645f * 4096f)) {
                                                                    let _e14391 = (_e11391 + _e14374);
                                                                    if (_e14391 < _e5599) {
                                                                        phi_13818_ = _e14391;
                                                                    } else {
                                                                        phi_13818_ = _e5599;
                                                                    }
                                                                    let _e14394 = phi_13818_;
                                                                    phi_13819_ = _e14394;
                                                                } else {
                                                                    phi_13819_ = _e11391;
                                                                }
                                                                let _e14396 = phi_13819_;
                                                                phi_13822_ = type_9(0u, 4u);
                                                                phi_13825_ = _e14396;
                                                                phi_13827_ = _e11391;
                                                                loop {
                                                                    let _e14398 = phi_13822_;
                                                                    let _e14400 = phi_13825_;
                                                                    let _e14402 = phi_13827_;
                                                                    local_120 = _e14400;
                                                                    local_121 = _e14402;
                                                                    local_122 = _e14402;
                                                                    if (_e14398.member < _e14398.member_1) {
                                                                        phi_13823_ = type_9((_e14398.member + 1u), _e14398.member_1);
                                                                        phi_13850_ = type_9(1u, _e14398.member);
                                                                    } else {
                                                                        phi_13823_ = _e14398;
                                                                        phi_13850_ = type_9(0u, type_9().member_1);
                                                                    }
                                                                    let _e14414 = phi_13823_;
                                                                    let _e14416 = phi_13850_;
                                                                    let _e14420 = (bitcast<i32>(_e14416.member) != 0i);
                                                                    if _e14420 {
                                                                        let _e14423 = local_15.member[_e14416.member_1];
                                                                        let _e14426 = local_15.member_1[_e14416.member_1];
                                                                        let _e14429 = local_15.member[_e14416.member_1];
                                                                        let _e14435 = local_15.member_2[_e14416.member_1];
                                                                        let _e14436 = ((_e14423 + ((_e14426 - _e14429) * _e11391)) - _e14435);
                                                                        let _e14439 = local_15.member_1[_e14416.member_1];
                                                                        let _e14442 = local_15.member[_e14416.member_1];
                                                                        let _e14443 = (_e14439 - _e14442);
                                                                        if (_e14443 > 0f) {
                                                                            let _e14457 = (_e11391 - (_e14436 / _e14443));
                                                                            if (_e14402 > _e14457) {
                                                                                phi_13918_ = _e14402;
                                                                            } else {
                                                                                phi_13918_ = _e14457;
                                                                            }
                                                                            let _e14460 = phi_13918_;
                                                                            phi_13936_ = _e14400;
                                                                            phi_13937_ = _e14460;
                                                                        } else {
                                                                            if (_e14436 > 0f) {
                                                                                if (_e14443 < 0f) {
                                                                                    let _e14448 = (_e11391 - (_e14436 / _e14443));
                                                                                    if (_e14400 < _e14448) {
                                                                                        phi_13933_ = _e14400;
                                                                                    } else {
                                                                                        phi_13933_ = _e14448;
                                                                                    }
                                                                                    let _e14451 = phi_13933_;
                                                                                    phi_13934_ = _e14451;
                                                                                } else {
                                                                                    phi_13934_ = _e14400;
                                                                                }
                                                                                let _e14453 = phi_13934_;
                                                                                phi_13935_ = _e14453;
                                                                            } else {
                                                                                phi_13935_ = _e14400;
                                                                            }
                                                                            let _e14455 = phi_13935_;
                                                                            phi_13936_ = _e14455;
                                                                            phi_13937_ = _e14402;
                                                                        }
                                                                        let _e14462 = phi_13936_;
                                                                        let _e14464 = phi_13937_;
                                                                        phi_13826_ = _e14462;
                                                                        phi_13828_ = _e14464;
                                                                    } else {
                                                                        phi_13826_ = f32();
                                                                        phi_13828_ = f32();
                                                                    }
                                                                    let _e14466 = phi_13826_;
                                                                    let _e14468 = phi_13828_;
                                                                    continue;
                                                                    continuing {
                                                                        phi_13822_ = _e14414;
                                                                        phi_13825_ = _e14466;
                                                                        phi_13827_ = _e14468;
                                                                        break if !(_e14420);
                                                                    }
                                                                }
                                                                let _e14471 = local_120;
                                                                let _e14473 = local_121;
                                                                let _e14477 = local_122;
                                                                let _e14478 = (_e14477 + ((_e14471 - _e14473) * 0.5f));
                                                                if (_e14478 > _e11391) {
                                                                    if (_e14478 <= _e14396) {
                                                                        let _e14483 = local_15.member[0u];
                                                                        let _e14486 = local_15.member_1[0u];
                                                                        let _e14489 = local_15.member[0u];
                                                                        let _e14495 = local_15.member_2[0u];
                                                                        if (((_e14483 + ((_e14486 - _e14489) * _e14478)) - _e14495) > 0f) {
                                                                            let _e14500 = local_15.member[1u];
                                                                            let _e14503 = local_15.member_1[1u];
                                                                            let _e14506 = local_15.member[1u];
                                                                            let _e14512 = local_15.member_2[1u];
                                                                            if (((_e14500 + ((_e14503 - _e14506) * _e14478)) - _e14512) > 0f) {
                                                                                let _e14517 = local_15.member[2u];
                                                                                let _e14520 = local_15.member_1[2u];
                                                                                let _e14523 = local_15.member[2u];
                                                                                let _e14529 = local_15.member_2[2u];
                                                                                if (((_e14517 + ((_e14520 - _e14523) * _e14478)) - _e14529) > 0f) {
                                                                                    let _e14534 = local_15.member[3u];
                                                                                    let _e14537 = local_15.member_1[3u];
                                                                                    let _e14540 = local_15.member[3u];
                                                                                    let _e14546 = local_15.member_2[3u];
                                                                                    phi_14098_ = (((_e14534 + ((_e14537 - _e14540) * _e14478)) - _e14546) > 0f);
                                                                                    phi_14099_ = false;
                                                                                } else {
                                                                                    phi_14098_ = bool();
                                                                                    phi_14099_ = true;
                                                                                }
                                                                                let _e14550 = phi_14098_;
                                                                                let _e14552 = phi_14099_;
                                                                                phi_14100_ = _e14550;
                                                                                phi_14101_ = _e14552;
                                                                            } else {
                                                                                phi_14100_ = bool();
                                                                                phi_14101_ = true;
                                                                            }
                                                                            let _e14554 = phi_14100_;
                                                                            let _e14556 = phi_14101_;
                                                                            phi_14102_ = _e14554;
                                                                            phi_14103_ = _e14556;
                                                                        } else {
                                                                            phi_14102_ = bool();
                                                                            phi_14103_ = true;
                                                                        }
                                                                        let _e14558 = phi_14102_;
                                                                        let _e14560 = phi_14103_;
                                                                        if _e14560 {
                                                                            phi_14107_ = false;
                                                                        } else {
                                                                            phi_14107_ = _e14558;
                                                                        }
                                                                        let _e14562 = phi_14107_;
                                                                        if _e14562 {
                                                                            phi_14111_ = false;
                                                                        } else {
                                                                            phi_14111_ = true;
                                                                        }
                                                                        let _e14564 = phi_14111_;
                                                                        phi_14112_ = _e14564;
                                                                    } else {
                                                                        phi_14112_ = true;
                                                                    }
                                                                    let _e14566 = phi_14112_;
                                                                    phi_14113_ = _e14566;
                                                                } else {
                                                                    phi_14113_ = true;
                                                                }
                                                                let _e14568 = phi_14113_;
                                                                if _e14568 {
                                                                    phi_14117_ = 2f;
                                                                } else {
                                                                    phi_14117_ = _e14478;
                                                                }
                                                                let _e14570 = phi_14117_;
                                                                phi_14120_ = type_46(2u, _e14396, _e14570);
                                                                phi_14121_ = type_46();
                                                                phi_14122_ = false;
                                                            } else {
                                                                phi_14120_ = type_46();
                                                                phi_14121_ = type_46(0u, _e11391, 2f);
                                                                phi_14122_ = true;
                                                            }
                                                            let _e14573 = phi_14120_;
                                                            let _e14575 = phi_14121_;
                                                            let _e14577 = phi_14122_;
                                                            phi_14123_ = _e14573;
                                                            phi_14124_ = _e14575;
                                                            phi_14125_ = _e14577;
                                                        } else {
                                                            phi_14123_ = type_46();
                                                            phi_14124_ = _e14383;
                                                            phi_14125_ = true;
                                                        }
                                                        let _e14579 = phi_14123_;
                                                        let _e14581 = phi_14124_;
                                                        let _e14583 = phi_14125_;
                                                        phi_14130_ = _e14581;
                                                        phi_14131_ = _e14579;
                                                        phi_14132_ = _e14583;
                                                    } else {
                                                        phi_14130_ = type_46(0u, _e11391, 2f);
                                                        phi_14131_ = type_46();
                                                        phi_14132_ = true;
                                                    }
                                                    let _e14585 = phi_14130_;
                                                    let _e14587 = phi_14131_;
                                                    let _e14589 = phi_14132_;
                                                    phi_14136_ = _e14585;
                                                    phi_14137_ = _e14587;
                                                    phi_14138_ = false;
                                                    phi_14139_ = _e14589;
                                                } else {
                                                    phi_14136_ = type_46();
                                                    phi_14137_ = type_46();
                                                    phi_14138_ = true;
                                                    phi_14139_ = false;
                                                }
                                                let _e14591 = phi_14136_;
                                                let _e14593 = phi_14137_;
                                                let _e14595 = phi_14138_;
                                                let _e14597 = phi_14139_;
                                                phi_14140_ = _e14591;
                                                phi_14141_ = _e14593;
                                                phi_14142_ = _e14595;
                                                phi_14143_ = _e14597;
                                            } else {
                                                phi_14140_ = type_46();
                                                phi_14141_ = type_46();
                                                phi_14142_ = true;
                                                phi_14143_ = false;
                                            }
                                            let _e14599 = phi_14140_;
                                            let _e14601 = phi_14141_;
                                            let _e14603 = phi_14142_;
                                            let _e14605 = phi_14143_;
                                            if _e14603 {
                                                phi_14148_ = type_46(0u, _e11391, 2f);
                                                phi_14149_ = true;
                                            } else {
                                                phi_14148_ = _e14599;
                                                phi_14149_ = _e14605;
                                            }
                                            let _e14608 = phi_14148_;
                                            let _e14610 = phi_14149_;
                                            if _e14610 {
                                                phi_14153_ = _e14608;
                                            } else {
                                                phi_14153_ = _e14601;
                                            }
                                            let _e14612 = phi_14153_;
                                            if _e5605 {
                                                if (_e14612.member == 2u) {
                                                    let _e14616 = (_e14612.member_2 <= _e5599);
                                                    if _e14616 {
                                                        phi_14169_ = _e14612.member_2;
                                                        phi_14170_ = _e14612.member_2;
                                                        phi_14171_ = false;
                                                    } else {
                                                        phi_14169_ = f32();
                                                        phi_14170_ = f32();
                                                        phi_14171_ = true;
                                                    }
                                                    let _e14620 = phi_14169_;
                                                    let _e14622 = phi_14170_;
                                                    let _e14624 = phi_14171_;
                                                    phi_14172_ = _e14620;
                                                    phi_14173_ = _e14622;
                                                    phi_14174_ = _e14616;
                                                    phi_14175_ = _e14624;
                                                    phi_14176_ = false;
                                                } else {
                                                    phi_14172_ = f32();
                                                    phi_14173_ = f32();
                                                    phi_14174_ = false;
                                                    phi_14175_ = false;
                                                    phi_14176_ = true;
                                                }
                                                let _e14626 = phi_14172_;
                                                let _e14628 = phi_14173_;
                                                let _e14630 = phi_14174_;
                                                let _e14632 = phi_14175_;
                                                let _e14634 = phi_14176_;
                                                phi_14177_ = _e14626;
                                                phi_14178_ = _e14628;
                                                phi_14179_ = _e14630;
                                                phi_14180_ = _e14632;
                                                phi_14181_ = _e14634;
                                            } else {
                                                phi_14177_ = f32();
                                                phi_14178_ = f32();
                                                phi_14179_ = false;
                                                phi_14180_ = false;
                                                phi_14181_ = true;
                                            }
                                            let _e14636 = phi_14177_;
                                            let _e14638 = phi_14178_;
                                            let _e14640 = phi_14179_;
                                            let _e14642 = phi_14180_;
                                            let _e14644 = phi_14181_;
                                            phi_14182_ = _e14636;
                                            phi_14183_ = _e14612.member;
                                            phi_14184_ = _e14638;
                                            phi_14185_ = _e14612;
                                            phi_14186_ = _e14612.member;
                                            phi_14187_ = _e14612.member;
                                            phi_14188_ = _e14640;
                                            phi_14189_ = _e14642;
                                            phi_14190_ = _e14644;
                                        }
                                        let _e14646 = phi_14182_;
                                        let _e14648 = phi_14183_;
                                        let _e14650 = phi_14184_;
                                        let _e14652 = phi_14185_;
                                        let _e14654 = phi_14186_;
                                        let _e14656 = phi_14187_;
                                        let _e14658 = phi_14188_;
                                        let _e14660 = phi_14189_;
                                        let _e14662 = phi_14190_;
                                        phi_14191_ = _e14646;
                                        phi_14192_ = _e14648;
                                        phi_14193_ = _e14650;
                                        phi_14194_ = _e14652;
                                        phi_14195_ = _e14654;
                                        phi_14196_ = _e14656;
                                        phi_14197_ = _e14658;
                                        phi_14198_ = _e13199;
                                        phi_14199_ = _e14660;
                                        phi_14200_ = _e14662;
                                        phi_14201_ = false;
                                    } else {
                                        phi_14191_ = f32();
                                        phi_14192_ = u32();
                                        phi_14193_ = f32();
                                        phi_14194_ = type_46();
                                        phi_14195_ = u32();
                                        phi_14196_ = u32();
                                        phi_14197_ = false;
                                        phi_14198_ = false;
                                        phi_14199_ = false;
                                        phi_14200_ = false;
                                        phi_14201_ = true;
                                    }
                                    let _e14664 = phi_14191_;
                                    let _e14666 = phi_14192_;
                                    let _e14668 = phi_14193_;
                                    let _e14670 = phi_14194_;
                                    let _e14672 = phi_14195_;
                                    let _e14674 = phi_14196_;
                                    let _e14676 = phi_14197_;
                                    let _e14678 = phi_14198_;
                                    let _e14680 = phi_14199_;
                                    let _e14682 = phi_14200_;
                                    let _e14684 = phi_14201_;
                                    phi_14202_ = _e13196;
                                    phi_9277_ = _e14664;
                                    phi_9279_ = _e14666;
                                    phi_9281_ = _e14668;
                                    phi_14203_ = _e14670;
                                    phi_14204_ = _e14672;
                                    phi_14205_ = _e13196;
                                    phi_14206_ = _e14674;
                                    phi_14207_ = _e14676;
                                    phi_14208_ = _e14678;
                                    phi_14209_ = _e14680;
                                    phi_14210_ = _e14682;
                                    phi_14211_ = false;
                                    phi_14212_ = _e14684;
                                } else {
                                    phi_14202_ = f32();
                                    phi_9277_ = f32();
                                    phi_9279_ = u32();
                                    phi_9281_ = f32();
                                    phi_14203_ = type_46();
                                    phi_14204_ = u32();
                                    phi_14205_ = f32();
                                    phi_14206_ = u32();
                                    phi_14207_ = false;
                                    phi_14208_ = false;
                                    phi_14209_ = false;
                                    phi_14210_ = false;
                                    phi_14211_ = true;
                                    phi_14212_ = false;
                                }
                                let _e14686 = phi_14202_;
                                let _e14688 = phi_9277_;
                                let _e14690 = phi_9279_;
                                let _e14692 = phi_9281_;
                                let _e14694 = phi_14203_;
                                let _e14696 = phi_14204_;
                                let _e14698 = phi_14205_;
                                let _e14700 = phi_14206_;
                                let _e14702 = phi_14207_;
                                let _e14704 = phi_14208_;
                                let _e14706 = phi_14209_;
                                let _e14708 = phi_14210_;
                                let _e14710 = phi_14211_;
                                let _e14712 = phi_14212_;
                                local_123 = _e14704;
                                local_160 = _e14706;
                                local_161 = _e14708;
                                local_162 = _e14710;
                                local_163 = _e14712;
                                local_124 = _e14694;
                                local_125 = _e14694;
                                local_164 = _e14696;
                                local_126 = _e14694;
                                local_165 = _e14704;
                                local_166 = _e14700;
                                local_168 = _e14698;
                                local_169 = _e14686;
                                continue;
                                continuing {
                                    phi_9273_ = _e11414;
                                    phi_9276_ = _e14688;
                                    phi_9278_ = _e14690;
                                    phi_9280_ = _e14692;
                                    break if !(_e14702);
                                }
                            }
                            let _e14715 = local_123;
                            if _e14715 {
                                phi_14216_ = false;
                                phi_14217_ = false;
                                phi_14218_ = false;
                                phi_14219_ = false;
                            } else {
                                let _e17414 = local_160;
                                phi_14216_ = _e17414;
                                let _e17417 = local_161;
                                phi_14217_ = _e17417;
                                let _e17420 = local_162;
                                phi_14218_ = _e17420;
                                let _e17423 = local_163;
                                phi_14219_ = _e17423;
                            }
                            let _e14717 = phi_14216_;
                            let _e14719 = phi_14217_;
                            let _e14721 = phi_14218_;
                            let _e14723 = phi_14219_;
                            if _e14717 {
                                let _e14725 = local_124;
                                if (_e14725.member_1 >= _e5599) {
                                    phi_14241_ = type_45(type_44(0u, f32()), 0u);
                                } else {
                                    let _e14729 = local_125;
                                    if (_e14729.member_1 > _e5597) {
                                        phi_14236_ = 0u;
                                    } else {
                                        let _e17428 = local_164;
                                        phi_14236_ = _e17428;
                                    }
                                    let _e14733 = phi_14236_;
                                    let _e14735 = local_126;
                                    phi_14241_ = type_45(type_44(2u, _e14735.member_1), _e14733);
                                }
                                let _e14742 = phi_14241_;
                                phi_14242_ = _e14742;
                                phi_14243_ = false;
                                phi_14244_ = false;
                                phi_14245_ = false;
                                phi_14246_ = false;
                            } else {
                                phi_14242_ = type_45();
                                phi_14243_ = _e14719;
                                let _e17435 = local_165;
                                phi_14244_ = _e17435;
                                phi_14245_ = _e14721;
                                phi_14246_ = _e14723;
                            }
                            let _e14744 = phi_14242_;
                            let _e14746 = phi_14243_;
                            let _e14748 = phi_14244_;
                            let _e14750 = phi_14245_;
                            let _e14752 = phi_14246_;
                            if _e14746 {
                                let _e17440 = local_166;
                                phi_14250_ = _e17440;
                                let _e17445 = local_168;
                                phi_14251_ = _e17445;
                                phi_14252_ = true;
                                phi_14253_ = false;
                                phi_14254_ = false;
                                phi_14255_ = false;
                            } else {
                                let _e17442 = local_167;
                                phi_14250_ = _e17442;
                                let _e17447 = local_169;
                                phi_14251_ = _e17447;
                                phi_14252_ = _e14748;
                                phi_14253_ = _e14750;
                                phi_14254_ = _e14752;
                                phi_14255_ = _e14717;
                            }
                            let _e14754 = phi_14250_;
                            let _e14756 = phi_14251_;
                            let _e14758 = phi_14252_;
                            let _e14760 = phi_14253_;
                            let _e14762 = phi_14254_;
                            let _e14764 = phi_14255_;
                            if _e14758 {
                                phi_14259_ = _e14756;
                                phi_14260_ = _e14754;
                                phi_14261_ = true;
                                phi_14262_ = false;
                                phi_14263_ = false;
                            } else {
                                let _e17454 = local_170;
                                phi_14259_ = _e17454;
                                let _e17457 = local_171;
                                phi_14260_ = _e17457;
                                phi_14261_ = _e14760;
                                phi_14262_ = _e14762;
                                phi_14263_ = _e14764;
                            }
                            let _e14766 = phi_14259_;
                            let _e14768 = phi_14260_;
                            let _e14770 = phi_14261_;
                            let _e14772 = phi_14262_;
                            let _e14774 = phi_14263_;
                            if _e14770 {
                                local_13[0u] = 0.01f;
                                local_13[1u] = 0f;
                                local_13[2u] = 0.8f;
                                if (_e5595 >= (0.000000059604645f * 8f)) {
                                    phi_14275_ = _e5595;
                                } else {
                                    phi_14275_ = 0f;
                                }
                                let _e14781 = phi_14275_;
                                phi_14278_ = type_9(0u, 3u);
                                loop {
                                    let _e14783 = phi_14278_;
                                    if (_e14783.member < _e14783.member_1) {
                                        phi_14279_ = type_9((_e14783.member + 1u), _e14783.member_1);
                                        phi_14302_ = type_9(1u, _e14783.member);
                                    } else {
                                        phi_14279_ = _e14783;
                                        phi_14302_ = type_9(0u, type_9().member_1);
                                    }
                                    let _e14795 = phi_14279_;
                                    let _e14797 = phi_14302_;
                                    if (bitcast<i32>(_e14797.member) != 0i) {
                                        let _e14803 = local_13[_e14797.member_1];
                                        let _e14805 = (_e14766 + (_e14781 * _e14803));
                                        if (_e14805 < _e5599) {
                                            phi_14323_ = _e14805;
                                        } else {
                                            phi_14323_ = _e5599;
                                        }
                                        let _e14808 = phi_14323_;
                                        let _e14811 = local_18.member[0u];
                                        let _e14817 = local_18.member[1u];
                                        let _e14833 = local_18.member_1[0u];
                                        let _e14839 = local_18.member_1[1u];
                                        let _e14855 = local_18.member_2[0u];
                                        let _e14861 = local_18.member_2[1u];
                                        let _e14875 = function_3(array<f32, 3>((_e14811[0] + ((_e14817[0] - _e14811[0]) * _e14808)), (_e14811[1] + ((_e14817[1] - _e14811[1]) * _e14808)), (_e14811[2] + ((_e14817[2] - _e14811[2]) * _e14808))), array<f32, 3>((_e14833[0] + ((_e14839[0] - _e14833[0]) * _e14808)), (_e14833[1] + ((_e14839[1] - _e14833[1]) * _e14808)), (_e14833[2] + ((_e14839[2] - _e14833[2]) * _e14808))), array<f32, 3>((_e14855[0] + ((_e14861[0] - _e14855[0]) * _e14808)), (_e14855[1] + ((_e14861[1] - _e14855[1]) * _e14808)), (_e14855[2] + ((_e14861[2] - _e14855[2]) * _e14808))), _e315.member);
                                        let _e14886 = (((_e14875[0] * _e14875[0]) + (_e14875[1] * _e14875[1])) + (_e14875[2] * _e14875[2]));
                                        if (_e14886 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e14886 > 0f) {
                                                phi_14446_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_14446_ = 0f;
                                            }
                                            let _e14939 = phi_14446_;
                                            phi_14510_ = _e14939;
                                        } else {
                                            phi_14453_ = type_14(0i, 5i);
                                            phi_14456_ = bitcast<f32>(((bitcast<u32>(_e14886) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e14894 = phi_14453_;
                                                let _e14896 = phi_14456_;
                                                local_127 = _e14896;
                                                if (_e14894.member < _e14894.member_1) {
                                                    let _e14903 = (_e14894.member + 1i);
                                                    if ((false == (_e14903 > _e14894.member)) != false) {
                                                        phi_14477_ = true;
                                                    } else {
                                                        phi_14477_ = false;
                                                    }
                                                    let _e14908 = phi_14477_;
                                                    if _e14908 {
                                                        phi_14483_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_14483_ = type_15(1u, _e14903);
                                                    }
                                                    let _e14913 = phi_14483_;
                                                    phi_14454_ = type_14(_e14913.member_1, _e14894.member_1);
                                                    phi_14497_ = type_15(1u, _e14894.member);
                                                } else {
                                                    phi_14454_ = _e14894;
                                                    phi_14497_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e14919 = phi_14454_;
                                                let _e14921 = phi_14497_;
                                                let _e14924 = (bitcast<i32>(_e14921.member) != 0i);
                                                if _e14924 {
                                                    phi_14457_ = (0.5f * (_e14896 + (_e14886 / _e14896)));
                                                } else {
                                                    phi_14457_ = f32();
                                                }
                                                let _e14929 = phi_14457_;
                                                continue;
                                                continuing {
                                                    phi_14453_ = _e14919;
                                                    phi_14456_ = _e14929;
                                                    break if !(_e14924);
                                                }
                                            }
                                            let _e14934 = local_127;
                                            phi_14510_ = (_e14934 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e14941 = phi_14510_;
                                        let _e14947 = local_18.member[0u];
                                        if (_e14947[0] < 0f) {
                                            phi_14526_ = -(_e14947[0]);
                                        } else {
                                            phi_14526_ = _e14947[0];
                                        }
                                        let _e14954 = phi_14526_;
                                        if (_e14947[1] < 0f) {
                                            phi_14533_ = -(_e14947[1]);
                                        } else {
                                            phi_14533_ = _e14947[1];
                                        }
                                        let _e14958 = phi_14533_;
                                        if (_e14954 > _e14958) {
                                            phi_14538_ = _e14954;
                                        } else {
                                            phi_14538_ = _e14958;
                                        }
                                        let _e14961 = phi_14538_;
                                        if (_e14947[2] < 0f) {
                                            phi_14545_ = -(_e14947[2]);
                                        } else {
                                            phi_14545_ = _e14947[2];
                                        }
                                        let _e14965 = phi_14545_;
                                        if (_e14961 > _e14965) {
                                            phi_14550_ = _e14961;
                                        } else {
                                            phi_14550_ = _e14965;
                                        }
                                        let _e14968 = phi_14550_;
                                        let _e14971 = local_18.member[1u];
                                        if (_e14971[0] < 0f) {
                                            phi_14563_ = -(_e14971[0]);
                                        } else {
                                            phi_14563_ = _e14971[0];
                                        }
                                        let _e14978 = phi_14563_;
                                        if (_e14971[1] < 0f) {
                                            phi_14570_ = -(_e14971[1]);
                                        } else {
                                            phi_14570_ = _e14971[1];
                                        }
                                        let _e14982 = phi_14570_;
                                        if (_e14978 > _e14982) {
                                            phi_14575_ = _e14978;
                                        } else {
                                            phi_14575_ = _e14982;
                                        }
                                        let _e14985 = phi_14575_;
                                        if (_e14971[2] < 0f) {
                                            phi_14582_ = -(_e14971[2]);
                                        } else {
                                            phi_14582_ = _e14971[2];
                                        }
                                        let _e14989 = phi_14582_;
                                        if (_e14985 > _e14989) {
                                            phi_14587_ = _e14985;
                                        } else {
                                            phi_14587_ = _e14989;
                                        }
                                        let _e14992 = phi_14587_;
                                        if (_e14968 > _e14992) {
                                            phi_14592_ = _e14968;
                                        } else {
                                            phi_14592_ = _e14992;
                                        }
                                        let _e14995 = phi_14592_;
                                        let _e14997 = local_18.member_3;
                                        let _e15001 = local_18.member_1[0u];
                                        if (_e15001[0] < 0f) {
                                            phi_14609_ = -(_e15001[0]);
                                        } else {
                                            phi_14609_ = _e15001[0];
                                        }
                                        let _e15008 = phi_14609_;
                                        if (_e15001[1] < 0f) {
                                            phi_14616_ = -(_e15001[1]);
                                        } else {
                                            phi_14616_ = _e15001[1];
                                        }
                                        let _e15012 = phi_14616_;
                                        if (_e15008 > _e15012) {
                                            phi_14621_ = _e15008;
                                        } else {
                                            phi_14621_ = _e15012;
                                        }
                                        let _e15015 = phi_14621_;
                                        if (_e15001[2] < 0f) {
                                            phi_14628_ = -(_e15001[2]);
                                        } else {
                                            phi_14628_ = _e15001[2];
                                        }
                                        let _e15019 = phi_14628_;
                                        if (_e15015 > _e15019) {
                                            phi_14633_ = _e15015;
                                        } else {
                                            phi_14633_ = _e15019;
                                        }
                                        let _e15022 = phi_14633_;
                                        let _e15025 = local_18.member_1[1u];
                                        if (_e15025[0] < 0f) {
                                            phi_14647_ = -(_e15025[0]);
                                        } else {
                                            phi_14647_ = _e15025[0];
                                        }
                                        let _e15032 = phi_14647_;
                                        if (_e15025[1] < 0f) {
                                            phi_14654_ = -(_e15025[1]);
                                        } else {
                                            phi_14654_ = _e15025[1];
                                        }
                                        let _e15036 = phi_14654_;
                                        if (_e15032 > _e15036) {
                                            phi_14659_ = _e15032;
                                        } else {
                                            phi_14659_ = _e15036;
                                        }
                                        let _e15039 = phi_14659_;
                                        if (_e15025[2] < 0f) {
                                            phi_14666_ = -(_e15025[2]);
                                        } else {
                                            phi_14666_ = _e15025[2];
                                        }
                                        let _e15043 = phi_14666_;
                                        if (_e15039 > _e15043) {
                                            phi_14671_ = _e15039;
                                        } else {
                                            phi_14671_ = _e15043;
                                        }
                                        let _e15046 = phi_14671_;
                                        if (_e15022 > _e15046) {
                                            phi_14676_ = _e15022;
                                        } else {
                                            phi_14676_ = _e15046;
                                        }
                                        let _e15049 = phi_14676_;
                                        let _e15051 = local_18.member_3;
                                        let _e15055 = local_18.member_2[0u];
                                        if (_e15055[0] < 0f) {
                                            phi_14693_ = -(_e15055[0]);
                                        } else {
                                            phi_14693_ = _e15055[0];
                                        }
                                        let _e15062 = phi_14693_;
                                        if (_e15055[1] < 0f) {
                                            phi_14700_ = -(_e15055[1]);
                                        } else {
                                            phi_14700_ = _e15055[1];
                                        }
                                        let _e15066 = phi_14700_;
                                        if (_e15062 > _e15066) {
                                            phi_14705_ = _e15062;
                                        } else {
                                            phi_14705_ = _e15066;
                                        }
                                        let _e15069 = phi_14705_;
                                        if (_e15055[2] < 0f) {
                                            phi_14712_ = -(_e15055[2]);
                                        } else {
                                            phi_14712_ = _e15055[2];
                                        }
                                        let _e15073 = phi_14712_;
                                        if (_e15069 > _e15073) {
                                            phi_14717_ = _e15069;
                                        } else {
                                            phi_14717_ = _e15073;
                                        }
                                        let _e15076 = phi_14717_;
                                        let _e15079 = local_18.member_2[1u];
                                        if (_e15079[0] < 0f) {
                                            phi_14731_ = -(_e15079[0]);
                                        } else {
                                            phi_14731_ = _e15079[0];
                                        }
                                        let _e15086 = phi_14731_;
                                        if (_e15079[1] < 0f) {
                                            phi_14738_ = -(_e15079[1]);
                                        } else {
                                            phi_14738_ = _e15079[1];
                                        }
                                        let _e15090 = phi_14738_;
                                        if (_e15086 > _e15090) {
                                            phi_14743_ = _e15086;
                                        } else {
                                            phi_14743_ = _e15090;
                                        }
                                        let _e15093 = phi_14743_;
                                        if (_e15079[2] < 0f) {
                                            phi_14750_ = -(_e15079[2]);
                                        } else {
                                            phi_14750_ = _e15079[2];
                                        }
                                        let _e15097 = phi_14750_;
                                        if (_e15093 > _e15097) {
                                            phi_14755_ = _e15093;
                                        } else {
                                            phi_14755_ = _e15097;
                                        }
                                        let _e15100 = phi_14755_;
                                        if (_e15076 > _e15100) {
                                            phi_14760_ = _e15076;
                                        } else {
                                            phi_14760_ = _e15100;
                                        }
                                        let _e15103 = phi_14760_;
                                        let _e15105 = local_18.member_3;
                                        let _e15112 = local_18.member_3;
                                        let _e15119 = (((_e14941 * (1f + (0.000000059604645f * 8f))) + (((((((_e14995 + _e14997) + (_e15049 + _e15051)) + (_e15103 + _e15105)) * (0.000000059604645f * 16f)) + (_e15112 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e5865.member_1);
                                        if _e15119 {
                                            phi_14780_ = false;
                                        } else {
                                            phi_14780_ = true;
                                        }
                                        let _e15121 = phi_14780_;
                                        phi_14781_ = _e15121;
                                        phi_14782_ = _e15119;
                                    } else {
                                        phi_14781_ = false;
                                        phi_14782_ = false;
                                    }
                                    let _e15123 = phi_14781_;
                                    let _e15125 = phi_14782_;
                                    local_128 = _e15125;
                                    continue;
                                    continuing {
                                        phi_14278_ = _e14795;
                                        break if !(_e15123);
                                    }
                                }
                                let _e15128 = local_128;
                                if _e15128 {
                                    if (_e14766 > _e5597) {
                                        phi_14790_ = 1u;
                                    } else {
                                        phi_14790_ = _e14768;
                                    }
                                    let _e15131 = phi_14790_;
                                    phi_14794_ = type_45(type_44(1u, _e14766), _e15131);
                                    phi_14795_ = false;
                                } else {
                                    phi_14794_ = type_45();
                                    phi_14795_ = true;
                                }
                                let _e15135 = phi_14794_;
                                let _e15137 = phi_14795_;
                                if _e15137 {
                                    if (_e14766 > _e5597) {
                                        phi_14803_ = 0u;
                                    } else {
                                        phi_14803_ = _e14768;
                                    }
                                    let _e15140 = phi_14803_;
                                    phi_14807_ = type_45(type_44(2u, _e14766), _e15140);
                                } else {
                                    phi_14807_ = _e15135;
                                }
                                let _e15144 = phi_14807_;
                                phi_14808_ = _e15144;
                                phi_14809_ = false;
                                phi_14810_ = false;
                            } else {
                                phi_14808_ = type_45();
                                phi_14809_ = _e14772;
                                phi_14810_ = _e14774;
                            }
                            let _e15146 = phi_14808_;
                            let _e15148 = phi_14809_;
                            let _e15150 = phi_14810_;
                            if _e15148 {
                                phi_14817_ = type_45(type_44(0u, f32()), 0u);
                                phi_14818_ = true;
                            } else {
                                phi_14817_ = _e14744;
                                phi_14818_ = _e15150;
                            }
                            let _e15154 = phi_14817_;
                            let _e15156 = phi_14818_;
                            phi_14822_ = _e15154;
                            phi_14823_ = _e15146;
                            phi_14824_ = _e15156;
                        } else {
                            phi_14822_ = _e11381;
                            phi_14823_ = type_45();
                            phi_14824_ = true;
                        }
                        let _e15158 = phi_14822_;
                        let _e15160 = phi_14823_;
                        let _e15162 = phi_14824_;
                        if _e15162 {
                            phi_14828_ = _e15158;
                        } else {
                            phi_14828_ = _e15160;
                        }
                        let _e15164 = phi_14828_;
                        phi_22343_ = _e15164;
                    } else {
                        let _e5909 = local_18.member_1[0u];
                        let _e5915 = local_18.member_2[0u];
                        let _e5921 = ((_e5909[1] * _e5915[2]) - (_e5909[2] * _e5915[1]));
                        let _e5924 = ((_e5909[2] * _e5915[0]) - (_e5909[0] * _e5915[2]));
                        let _e5927 = ((_e5909[0] * _e5915[1]) - (_e5909[1] * _e5915[0]));
                        let _e5930 = local_18.member_1[1u];
                        let _e5936 = local_18.member_2[1u];
                        let _e5942 = ((_e5930[1] * _e5936[2]) - (_e5930[2] * _e5936[1]));
                        let _e5945 = ((_e5930[2] * _e5936[0]) - (_e5930[0] * _e5936[2]));
                        let _e5948 = ((_e5930[0] * _e5936[1]) - (_e5930[1] * _e5936[0]));
                        let _e5951 = local_18.member_1[0u];
                        let _e5957 = local_18.member_2[1u];
                        let _e5972 = local_18.member_1[1u];
                        let _e5978 = local_18.member_2[0u];
                        let _e5991 = (((_e5951[1] * _e5957[2]) - (_e5951[2] * _e5957[1])) + ((_e5972[1] * _e5978[2]) - (_e5972[2] * _e5978[1])));
                        let _e5992 = (((_e5951[2] * _e5957[0]) - (_e5951[0] * _e5957[2])) + ((_e5972[2] * _e5978[0]) - (_e5972[0] * _e5978[2])));
                        let _e5993 = (((_e5951[0] * _e5957[1]) - (_e5951[1] * _e5957[0])) + ((_e5972[0] * _e5978[1]) - (_e5972[1] * _e5978[0])));
                        let _e5996 = local_18.member[0u];
                        let _e6004 = (((_e5996[0] * _e5921) + (_e5996[1] * _e5924)) + (_e5996[2] * _e5927));
                        let _e6007 = local_18.member[1u];
                        let _e6018 = local_18.member[0u];
                        let _e6027 = ((((_e6007[0] * _e5921) + (_e6007[1] * _e5924)) + (_e6007[2] * _e5927)) + (((_e6018[0] * _e5991) + (_e6018[1] * _e5992)) + (_e6018[2] * _e5993)));
                        let _e6030 = local_18.member[0u];
                        let _e6041 = local_18.member[1u];
                        let _e6050 = ((((_e6030[0] * _e5942) + (_e6030[1] * _e5945)) + (_e6030[2] * _e5948)) + (((_e6041[0] * _e5991) + (_e6041[1] * _e5992)) + (_e6041[2] * _e5993)));
                        let _e6053 = local_18.member[1u];
                        let _e6061 = (((_e6053[0] * _e5942) + (_e6053[1] * _e5945)) + (_e6053[2] * _e5948));
                        let _e6064 = local_18.member[0u];
                        if (_e6064[0] < 0f) {
                            phi_15070_ = -(_e6064[0]);
                        } else {
                            phi_15070_ = _e6064[0];
                        }
                        let _e6071 = phi_15070_;
                        if (_e6064[1] < 0f) {
                            phi_15077_ = -(_e6064[1]);
                        } else {
                            phi_15077_ = _e6064[1];
                        }
                        let _e6075 = phi_15077_;
                        if (_e6071 > _e6075) {
                            phi_15082_ = _e6071;
                        } else {
                            phi_15082_ = _e6075;
                        }
                        let _e6078 = phi_15082_;
                        if (_e6064[2] < 0f) {
                            phi_15089_ = -(_e6064[2]);
                        } else {
                            phi_15089_ = _e6064[2];
                        }
                        let _e6082 = phi_15089_;
                        if (_e6078 > _e6082) {
                            phi_15094_ = _e6078;
                        } else {
                            phi_15094_ = _e6082;
                        }
                        let _e6085 = phi_15094_;
                        let _e6088 = local_18.member[1u];
                        if (_e6088[0] < 0f) {
                            phi_15107_ = -(_e6088[0]);
                        } else {
                            phi_15107_ = _e6088[0];
                        }
                        let _e6095 = phi_15107_;
                        if (_e6088[1] < 0f) {
                            phi_15114_ = -(_e6088[1]);
                        } else {
                            phi_15114_ = _e6088[1];
                        }
                        let _e6099 = phi_15114_;
                        if (_e6095 > _e6099) {
                            phi_15119_ = _e6095;
                        } else {
                            phi_15119_ = _e6099;
                        }
                        let _e6102 = phi_15119_;
                        if (_e6088[2] < 0f) {
                            phi_15126_ = -(_e6088[2]);
                        } else {
                            phi_15126_ = _e6088[2];
                        }
                        let _e6106 = phi_15126_;
                        if (_e6102 > _e6106) {
                            phi_15131_ = _e6102;
                        } else {
                            phi_15131_ = _e6106;
                        }
                        let _e6109 = phi_15131_;
                        if (_e6085 > _e6109) {
                            phi_15136_ = _e6085;
                        } else {
                            phi_15136_ = _e6109;
                        }
                        let _e6112 = phi_15136_;
                        let _e6114 = local_18.member_3;
                        let _e6115 = (_e6112 + _e6114);
                        let _e6118 = local_18.member_1[0u];
                        if (_e6118[0] < 0f) {
                            phi_15153_ = -(_e6118[0]);
                        } else {
                            phi_15153_ = _e6118[0];
                        }
                        let _e6125 = phi_15153_;
                        if (_e6118[1] < 0f) {
                            phi_15160_ = -(_e6118[1]);
                        } else {
                            phi_15160_ = _e6118[1];
                        }
                        let _e6129 = phi_15160_;
                        if (_e6125 > _e6129) {
                            phi_15165_ = _e6125;
                        } else {
                            phi_15165_ = _e6129;
                        }
                        let _e6132 = phi_15165_;
                        if (_e6118[2] < 0f) {
                            phi_15172_ = -(_e6118[2]);
                        } else {
                            phi_15172_ = _e6118[2];
                        }
                        let _e6136 = phi_15172_;
                        if (_e6132 > _e6136) {
                            phi_15177_ = _e6132;
                        } else {
                            phi_15177_ = _e6136;
                        }
                        let _e6139 = phi_15177_;
                        let _e6142 = local_18.member_1[1u];
                        if (_e6142[0] < 0f) {
                            phi_15191_ = -(_e6142[0]);
                        } else {
                            phi_15191_ = _e6142[0];
                        }
                        let _e6149 = phi_15191_;
                        if (_e6142[1] < 0f) {
                            phi_15198_ = -(_e6142[1]);
                        } else {
                            phi_15198_ = _e6142[1];
                        }
                        let _e6153 = phi_15198_;
                        if (_e6149 > _e6153) {
                            phi_15203_ = _e6149;
                        } else {
                            phi_15203_ = _e6153;
                        }
                        let _e6156 = phi_15203_;
                        if (_e6142[2] < 0f) {
                            phi_15210_ = -(_e6142[2]);
                        } else {
                            phi_15210_ = _e6142[2];
                        }
                        let _e6160 = phi_15210_;
                        if (_e6156 > _e6160) {
                            phi_15215_ = _e6156;
                        } else {
                            phi_15215_ = _e6160;
                        }
                        let _e6163 = phi_15215_;
                        if (_e6139 > _e6163) {
                            phi_15220_ = _e6139;
                        } else {
                            phi_15220_ = _e6163;
                        }
                        let _e6166 = phi_15220_;
                        let _e6168 = local_18.member_3;
                        let _e6169 = (_e6166 + _e6168);
                        let _e6172 = local_18.member_2[0u];
                        if (_e6172[0] < 0f) {
                            phi_15237_ = -(_e6172[0]);
                        } else {
                            phi_15237_ = _e6172[0];
                        }
                        let _e6179 = phi_15237_;
                        if (_e6172[1] < 0f) {
                            phi_15244_ = -(_e6172[1]);
                        } else {
                            phi_15244_ = _e6172[1];
                        }
                        let _e6183 = phi_15244_;
                        if (_e6179 > _e6183) {
                            phi_15249_ = _e6179;
                        } else {
                            phi_15249_ = _e6183;
                        }
                        let _e6186 = phi_15249_;
                        if (_e6172[2] < 0f) {
                            phi_15256_ = -(_e6172[2]);
                        } else {
                            phi_15256_ = _e6172[2];
                        }
                        let _e6190 = phi_15256_;
                        if (_e6186 > _e6190) {
                            phi_15261_ = _e6186;
                        } else {
                            phi_15261_ = _e6190;
                        }
                        let _e6193 = phi_15261_;
                        let _e6196 = local_18.member_2[1u];
                        if (_e6196[0] < 0f) {
                            phi_15275_ = -(_e6196[0]);
                        } else {
                            phi_15275_ = _e6196[0];
                        }
                        let _e6203 = phi_15275_;
                        if (_e6196[1] < 0f) {
                            phi_15282_ = -(_e6196[1]);
                        } else {
                            phi_15282_ = _e6196[1];
                        }
                        let _e6207 = phi_15282_;
                        if (_e6203 > _e6207) {
                            phi_15287_ = _e6203;
                        } else {
                            phi_15287_ = _e6207;
                        }
                        let _e6210 = phi_15287_;
                        if (_e6196[2] < 0f) {
                            phi_15294_ = -(_e6196[2]);
                        } else {
                            phi_15294_ = _e6196[2];
                        }
                        let _e6214 = phi_15294_;
                        if (_e6210 > _e6214) {
                            phi_15299_ = _e6210;
                        } else {
                            phi_15299_ = _e6214;
                        }
                        let _e6217 = phi_15299_;
                        if (_e6193 > _e6217) {
                            phi_15304_ = _e6193;
                        } else {
                            phi_15304_ = _e6217;
                        }
                        let _e6220 = phi_15304_;
                        let _e6222 = local_18.member_3;
                        let _e6223 = (_e6220 + _e6222);
                        let _e6225 = ((_e6169 * 8f) * _e6223);
                        let _e6232 = local_18.member_3;
                        if (_e5921 < 0f) {
                            phi_15335_ = -(_e5921);
                        } else {
                            phi_15335_ = _e5921;
                        }
                        let _e6249 = phi_15335_;
                        if (_e5924 < 0f) {
                            phi_15341_ = -(_e5924);
                        } else {
                            phi_15341_ = _e5924;
                        }
                        let _e6253 = phi_15341_;
                        if (_e5927 < 0f) {
                            phi_15348_ = -(_e5927);
                        } else {
                            phi_15348_ = _e5927;
                        }
                        let _e6258 = phi_15348_;
                        let _e6259 = ((_e6249 + _e6253) + _e6258);
                        if (_e5942 < 0f) {
                            phi_15355_ = -(_e5942);
                        } else {
                            phi_15355_ = _e5942;
                        }
                        let _e6263 = phi_15355_;
                        if (_e5945 < 0f) {
                            phi_15361_ = -(_e5945);
                        } else {
                            phi_15361_ = _e5945;
                        }
                        let _e6267 = phi_15361_;
                        if (_e5948 < 0f) {
                            phi_15368_ = -(_e5948);
                        } else {
                            phi_15368_ = _e5948;
                        }
                        let _e6272 = phi_15368_;
                        let _e6273 = ((_e6263 + _e6267) + _e6272);
                        if (_e6259 > _e6273) {
                            phi_15374_ = _e6259;
                        } else {
                            phi_15374_ = _e6273;
                        }
                        let _e6276 = phi_15374_;
                        if (_e5991 < 0f) {
                            phi_15380_ = -(_e5991);
                        } else {
                            phi_15380_ = _e5991;
                        }
                        let _e6280 = phi_15380_;
                        if (_e5992 < 0f) {
                            phi_15386_ = -(_e5992);
                        } else {
                            phi_15386_ = _e5992;
                        }
                        let _e6284 = phi_15386_;
                        if (_e5993 < 0f) {
                            phi_15393_ = -(_e5993);
                        } else {
                            phi_15393_ = _e5993;
                        }
                        let _e6289 = phi_15393_;
                        let _e6291 = (((_e6280 + _e6284) + _e6289) * 0.5f);
                        if (_e6276 > _e6291) {
                            phi_15400_ = _e6276;
                        } else {
                            phi_15400_ = _e6291;
                        }
                        let _e6294 = phi_15400_;
                        let _e6299 = local_18.member_3;
                        let _e6311 = (((((_e6115 * 8f) * _e6225) * (0.000000059604645f * (524f / 64f))) + ((_e6232 * 19f) * ((_e6115 * (_e6169 + _e6223)) + (_e6169 * _e6223)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6115) * ((1f + _e6169) * (1f + _e6223)))));
                        let _e6312 = (_e6004 * 3f);
                        let _e6313 = (_e6061 * 3f);
                        if (_e6312 < _e6313) {
                            phi_15424_ = _e6312;
                        } else {
                            phi_15424_ = _e6313;
                        }
                        let _e6316 = phi_15424_;
                        if (_e6027 < _e6050) {
                            phi_15429_ = _e6027;
                        } else {
                            phi_15429_ = _e6050;
                        }
                        let _e6319 = phi_15429_;
                        if (_e6316 < _e6319) {
                            phi_15434_ = _e6316;
                        } else {
                            phi_15434_ = _e6319;
                        }
                        let _e6322 = phi_15434_;
                        if (_e6312 > _e6313) {
                            phi_15439_ = _e6312;
                        } else {
                            phi_15439_ = _e6313;
                        }
                        let _e6325 = phi_15439_;
                        if (_e6027 > _e6050) {
                            phi_15444_ = _e6027;
                        } else {
                            phi_15444_ = _e6050;
                        }
                        let _e6328 = phi_15444_;
                        if (_e6325 > _e6328) {
                            phi_15449_ = _e6325;
                        } else {
                            phi_15449_ = _e6328;
                        }
                        let _e6331 = phi_15449_;
                        let _e6336 = -(_e6331);
                        if (_e6322 > _e6336) {
                            phi_15459_ = _e6322;
                        } else {
                            phi_15459_ = _e6336;
                        }
                        let _e6339 = phi_15459_;
                        if ((_e6339 - (_e6311 + ((0f * (((_e6294 + (_e6225 * (0.000000059604645f * 8f))) + ((_e6299 * 6f) * (_e6169 + _e6223))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6169) * (1f + _e6223))))) * (3f * 1.0001f)))) > 0f) {
                            phi_22313_ = type_44(0u, type_44().member_1);
                            phi_22314_ = type_44();
                            phi_22315_ = true;
                        } else {
                            if (_e6004 < 0f) {
                                phi_15472_ = -(_e6004);
                            } else {
                                phi_15472_ = _e6004;
                            }
                            let _e6346 = phi_15472_;
                            if (_e6027 < 0f) {
                                phi_15478_ = -(_e6027);
                            } else {
                                phi_15478_ = _e6027;
                            }
                            let _e6350 = phi_15478_;
                            if (_e6346 > _e6350) {
                                phi_15483_ = _e6346;
                            } else {
                                phi_15483_ = _e6350;
                            }
                            let _e6353 = phi_15483_;
                            if (_e6050 < 0f) {
                                phi_15489_ = -(_e6050);
                            } else {
                                phi_15489_ = _e6050;
                            }
                            let _e6357 = phi_15489_;
                            if (_e6061 < 0f) {
                                phi_15495_ = -(_e6061);
                            } else {
                                phi_15495_ = _e6061;
                            }
                            let _e6361 = phi_15495_;
                            if (_e6357 > _e6361) {
                                phi_15500_ = _e6357;
                            } else {
                                phi_15500_ = _e6361;
                            }
                            let _e6364 = phi_15500_;
                            if (_e6353 > _e6364) {
                                phi_15505_ = _e6353;
                            } else {
                                phi_15505_ = _e6364;
                            }
                            let _e6367 = phi_15505_;
                            let _e6368 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                            if (_e6367 >= _e6368) {
                                phi_15513_ = (_e6367 <= (1f / _e6368));
                            } else {
                                phi_15513_ = false;
                            }
                            let _e6373 = phi_15513_;
                            if _e6373 {
                                phi_15518_ = (0.000000059604645f * 256f);
                            } else {
                                phi_15518_ = 2f;
                            }
                            let _e6376 = phi_15518_;
                            let _e6378 = ((_e6311 * 0.34f) + (_e6367 * _e6376));
                            if _e6373 {
                                phi_15525_ = (1f / _e6367);
                            } else {
                                phi_15525_ = 0f;
                            }
                            let _e6381 = phi_15525_;
                            let _e6382 = (_e5595 * 0.0625f);
                            if (0.00000000000022737368f < _e6382) {
                                phi_15531_ = 0.00000000000022737368f;
                            } else {
                                phi_15531_ = _e6382;
                            }
                            let _e6385 = phi_15531_;
                            let _e6386 = (1f - _e5597);
                            let _e6397 = ((((_e6004 * _e6386) + (_e6027 * _e5597)) * (_e6386 * _e6386)) + (((_e6050 * _e6386) + (_e6061 * _e5597)) * (_e5597 * _e5597)));
                            if (_e6397 < 0f) {
                                phi_15549_ = -(_e6397);
                            } else {
                                phi_15549_ = _e6397;
                            }
                            let _e6401 = phi_15549_;
                            if !((_e6401 > _e6378)) {
                                let _e6406 = local_18.member[0u];
                                let _e6413 = local_18.member_1[0u];
                                let _e6419 = local_18.member_2[0u];
                                let _e6423 = (_e6406[0] - _e6413[0]);
                                let _e6424 = (_e6406[1] - _e6413[1]);
                                let _e6425 = (_e6406[2] - _e6413[2]);
                                if (_e315.member == 0u) {
                                    phi_15610_ = array<f32, 3>(_e6406[0], _e6406[1], _e6406[2]);
                                } else {
                                    phi_15610_ = array<f32, 3>((_e6423 - _e6419[0]), (_e6424 - _e6419[1]), (_e6425 - _e6419[2]));
                                }
                                let _e6432 = phi_15610_;
                                let _e6433 = (_e6406[0] - _e6419[0]);
                                let _e6434 = (_e6406[1] - _e6419[1]);
                                let _e6435 = (_e6406[2] - _e6419[2]);
                                let _e6438 = local_18.member[1u];
                                let _e6445 = local_18.member_1[1u];
                                let _e6451 = local_18.member_2[1u];
                                let _e6455 = (_e6438[0] - _e6445[0]);
                                let _e6456 = (_e6438[1] - _e6445[1]);
                                let _e6457 = (_e6438[2] - _e6445[2]);
                                if (_e315.member == 0u) {
                                    phi_15675_ = array<f32, 3>(_e6438[0], _e6438[1], _e6438[2]);
                                } else {
                                    phi_15675_ = array<f32, 3>((_e6455 - _e6451[0]), (_e6456 - _e6451[1]), (_e6457 - _e6451[2]));
                                }
                                let _e6464 = phi_15675_;
                                let _e6465 = (_e6438[0] - _e6451[0]);
                                let _e6466 = (_e6438[1] - _e6451[1]);
                                let _e6467 = (_e6438[2] - _e6451[2]);
                                let _e6470 = local_18.member[0u];
                                if (_e6470[0] < 0f) {
                                    phi_15697_ = -(_e6470[0]);
                                } else {
                                    phi_15697_ = _e6470[0];
                                }
                                let _e6477 = phi_15697_;
                                if (_e6470[1] < 0f) {
                                    phi_15704_ = -(_e6470[1]);
                                } else {
                                    phi_15704_ = _e6470[1];
                                }
                                let _e6481 = phi_15704_;
                                if (_e6477 > _e6481) {
                                    phi_15709_ = _e6477;
                                } else {
                                    phi_15709_ = _e6481;
                                }
                                let _e6484 = phi_15709_;
                                if (_e6470[2] < 0f) {
                                    phi_15716_ = -(_e6470[2]);
                                } else {
                                    phi_15716_ = _e6470[2];
                                }
                                let _e6488 = phi_15716_;
                                if (_e6484 > _e6488) {
                                    phi_15721_ = _e6484;
                                } else {
                                    phi_15721_ = _e6488;
                                }
                                let _e6491 = phi_15721_;
                                let _e6494 = local_18.member[1u];
                                if (_e6494[0] < 0f) {
                                    phi_15734_ = -(_e6494[0]);
                                } else {
                                    phi_15734_ = _e6494[0];
                                }
                                let _e6501 = phi_15734_;
                                if (_e6494[1] < 0f) {
                                    phi_15741_ = -(_e6494[1]);
                                } else {
                                    phi_15741_ = _e6494[1];
                                }
                                let _e6505 = phi_15741_;
                                if (_e6501 > _e6505) {
                                    phi_15746_ = _e6501;
                                } else {
                                    phi_15746_ = _e6505;
                                }
                                let _e6508 = phi_15746_;
                                if (_e6494[2] < 0f) {
                                    phi_15753_ = -(_e6494[2]);
                                } else {
                                    phi_15753_ = _e6494[2];
                                }
                                let _e6512 = phi_15753_;
                                if (_e6508 > _e6512) {
                                    phi_15758_ = _e6508;
                                } else {
                                    phi_15758_ = _e6512;
                                }
                                let _e6515 = phi_15758_;
                                if (_e6491 > _e6515) {
                                    phi_15763_ = _e6491;
                                } else {
                                    phi_15763_ = _e6515;
                                }
                                let _e6518 = phi_15763_;
                                let _e6520 = local_18.member_3;
                                let _e6524 = local_18.member_1[0u];
                                if (_e6524[0] < 0f) {
                                    phi_15780_ = -(_e6524[0]);
                                } else {
                                    phi_15780_ = _e6524[0];
                                }
                                let _e6531 = phi_15780_;
                                if (_e6524[1] < 0f) {
                                    phi_15787_ = -(_e6524[1]);
                                } else {
                                    phi_15787_ = _e6524[1];
                                }
                                let _e6535 = phi_15787_;
                                if (_e6531 > _e6535) {
                                    phi_15792_ = _e6531;
                                } else {
                                    phi_15792_ = _e6535;
                                }
                                let _e6538 = phi_15792_;
                                if (_e6524[2] < 0f) {
                                    phi_15799_ = -(_e6524[2]);
                                } else {
                                    phi_15799_ = _e6524[2];
                                }
                                let _e6542 = phi_15799_;
                                if (_e6538 > _e6542) {
                                    phi_15804_ = _e6538;
                                } else {
                                    phi_15804_ = _e6542;
                                }
                                let _e6545 = phi_15804_;
                                let _e6548 = local_18.member_1[1u];
                                if (_e6548[0] < 0f) {
                                    phi_15818_ = -(_e6548[0]);
                                } else {
                                    phi_15818_ = _e6548[0];
                                }
                                let _e6555 = phi_15818_;
                                if (_e6548[1] < 0f) {
                                    phi_15825_ = -(_e6548[1]);
                                } else {
                                    phi_15825_ = _e6548[1];
                                }
                                let _e6559 = phi_15825_;
                                if (_e6555 > _e6559) {
                                    phi_15830_ = _e6555;
                                } else {
                                    phi_15830_ = _e6559;
                                }
                                let _e6562 = phi_15830_;
                                if (_e6548[2] < 0f) {
                                    phi_15837_ = -(_e6548[2]);
                                } else {
                                    phi_15837_ = _e6548[2];
                                }
                                let _e6566 = phi_15837_;
                                if (_e6562 > _e6566) {
                                    phi_15842_ = _e6562;
                                } else {
                                    phi_15842_ = _e6566;
                                }
                                let _e6569 = phi_15842_;
                                if (_e6545 > _e6569) {
                                    phi_15847_ = _e6545;
                                } else {
                                    phi_15847_ = _e6569;
                                }
                                let _e6572 = phi_15847_;
                                let _e6574 = local_18.member_3;
                                let _e6578 = local_18.member_2[0u];
                                if (_e6578[0] < 0f) {
                                    phi_15864_ = -(_e6578[0]);
                                } else {
                                    phi_15864_ = _e6578[0];
                                }
                                let _e6585 = phi_15864_;
                                if (_e6578[1] < 0f) {
                                    phi_15871_ = -(_e6578[1]);
                                } else {
                                    phi_15871_ = _e6578[1];
                                }
                                let _e6589 = phi_15871_;
                                if (_e6585 > _e6589) {
                                    phi_15876_ = _e6585;
                                } else {
                                    phi_15876_ = _e6589;
                                }
                                let _e6592 = phi_15876_;
                                if (_e6578[2] < 0f) {
                                    phi_15883_ = -(_e6578[2]);
                                } else {
                                    phi_15883_ = _e6578[2];
                                }
                                let _e6596 = phi_15883_;
                                if (_e6592 > _e6596) {
                                    phi_15888_ = _e6592;
                                } else {
                                    phi_15888_ = _e6596;
                                }
                                let _e6599 = phi_15888_;
                                let _e6602 = local_18.member_2[1u];
                                if (_e6602[0] < 0f) {
                                    phi_15902_ = -(_e6602[0]);
                                } else {
                                    phi_15902_ = _e6602[0];
                                }
                                let _e6609 = phi_15902_;
                                if (_e6602[1] < 0f) {
                                    phi_15909_ = -(_e6602[1]);
                                } else {
                                    phi_15909_ = _e6602[1];
                                }
                                let _e6613 = phi_15909_;
                                if (_e6609 > _e6613) {
                                    phi_15914_ = _e6609;
                                } else {
                                    phi_15914_ = _e6613;
                                }
                                let _e6616 = phi_15914_;
                                if (_e6602[2] < 0f) {
                                    phi_15921_ = -(_e6602[2]);
                                } else {
                                    phi_15921_ = _e6602[2];
                                }
                                let _e6620 = phi_15921_;
                                if (_e6616 > _e6620) {
                                    phi_15926_ = _e6616;
                                } else {
                                    phi_15926_ = _e6620;
                                }
                                let _e6623 = phi_15926_;
                                if (_e6599 > _e6623) {
                                    phi_15931_ = _e6599;
                                } else {
                                    phi_15931_ = _e6623;
                                }
                                let _e6626 = phi_15931_;
                                let _e6628 = local_18.member_3;
                                let _e6635 = local_18.member_3;
                                let _e6639 = ((((((_e6518 + _e6520) + (_e6572 + _e6574)) + (_e6626 + _e6628)) * (0.000000059604645f * 16f)) + (_e6635 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                                let _e6642 = local_18.member[0u];
                                let _e6648 = local_18.member[1u];
                                let _e6664 = local_18.member_1[0u];
                                let _e6670 = local_18.member_1[1u];
                                let _e6686 = local_18.member_2[0u];
                                let _e6692 = local_18.member_2[1u];
                                let _e6706 = function_3(array<f32, 3>((_e6642[0] + ((_e6648[0] - _e6642[0]) * _e5597)), (_e6642[1] + ((_e6648[1] - _e6642[1]) * _e5597)), (_e6642[2] + ((_e6648[2] - _e6642[2]) * _e5597))), array<f32, 3>((_e6664[0] + ((_e6670[0] - _e6664[0]) * _e5597)), (_e6664[1] + ((_e6670[1] - _e6664[1]) * _e5597)), (_e6664[2] + ((_e6670[2] - _e6664[2]) * _e5597))), array<f32, 3>((_e6686[0] + ((_e6692[0] - _e6686[0]) * _e5597)), (_e6686[1] + ((_e6692[1] - _e6686[1]) * _e5597)), (_e6686[2] + ((_e6692[2] - _e6686[2]) * _e5597))), _e315.member);
                                if (_e6706[0] < 0f) {
                                    phi_16049_ = -(_e6706[0]);
                                } else {
                                    phi_16049_ = _e6706[0];
                                }
                                let _e6711 = phi_16049_;
                                if (_e6706[1] < 0f) {
                                    phi_16056_ = -(_e6706[1]);
                                } else {
                                    phi_16056_ = _e6706[1];
                                }
                                let _e6716 = phi_16056_;
                                if (_e6706[2] < 0f) {
                                    phi_16064_ = -(_e6706[2]);
                                } else {
                                    phi_16064_ = _e6706[2];
                                }
                                let _e6722 = phi_16064_;
                                let _e6723 = ((_e6711 + _e6716) + _e6722);
                                if (_e6723 > 0f) {
                                    if ((bitcast<u32>(_e6723) & 2139095040u) != 2139095040u) {
                                        let _e6728 = (1f / _e6723);
                                        let _e6730 = (_e6706[0] * _e6728);
                                        let _e6732 = (_e6706[1] * _e6728);
                                        let _e6734 = (_e6706[2] * _e6728);
                                        let _e6739 = (((_e6730 * _e6730) + (_e6732 * _e6732)) + (_e6734 * _e6734));
                                        if (_e6739 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e6739 > 0f) {
                                                phi_16101_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_16101_ = 0f;
                                            }
                                            let _e6792 = phi_16101_;
                                            phi_16165_ = _e6792;
                                        } else {
                                            phi_16108_ = type_14(0i, 5i);
                                            phi_16111_ = bitcast<f32>(((bitcast<u32>(_e6739) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e6747 = phi_16108_;
                                                let _e6749 = phi_16111_;
                                                local_85 = _e6749;
                                                if (_e6747.member < _e6747.member_1) {
                                                    let _e6756 = (_e6747.member + 1i);
                                                    if ((false == (_e6756 > _e6747.member)) != false) {
                                                        phi_16132_ = true;
                                                    } else {
                                                        phi_16132_ = false;
                                                    }
                                                    let _e6761 = phi_16132_;
                                                    if _e6761 {
                                                        phi_16138_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_16138_ = type_15(1u, _e6756);
                                                    }
                                                    let _e6766 = phi_16138_;
                                                    phi_16109_ = type_14(_e6766.member_1, _e6747.member_1);
                                                    phi_16152_ = type_15(1u, _e6747.member);
                                                } else {
                                                    phi_16109_ = _e6747;
                                                    phi_16152_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e6772 = phi_16109_;
                                                let _e6774 = phi_16152_;
                                                let _e6777 = (bitcast<i32>(_e6774.member) != 0i);
                                                if _e6777 {
                                                    phi_16112_ = (0.5f * (_e6749 + (_e6739 / _e6749)));
                                                } else {
                                                    phi_16112_ = f32();
                                                }
                                                let _e6782 = phi_16112_;
                                                continue;
                                                continuing {
                                                    phi_16108_ = _e6772;
                                                    phi_16111_ = _e6782;
                                                    break if !(_e6777);
                                                }
                                            }
                                            let _e6787 = local_85;
                                            phi_16165_ = (_e6787 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e6794 = phi_16165_;
                                        let _e6795 = (0.000000059604645f * 12f);
                                        let _e6800 = ((_e6639 * 1.01f) + ((0f * _e6794) * (1f + _e6795)));
                                        let _e6805 = (((_e6730 * _e6406[0]) + (_e6732 * _e6406[1])) + (_e6734 * _e6406[2]));
                                        let _e6810 = (((_e6730 * _e6423) + (_e6732 * _e6424)) + (_e6734 * _e6425));
                                        let _e6815 = (((_e6730 * _e6433) + (_e6732 * _e6434)) + (_e6734 * _e6435));
                                        let _e6823 = (((_e6730 * _e6432[0]) + (_e6732 * _e6432[1])) + (_e6734 * _e6432[2]));
                                        let _e6829 = (((_e6730 * _e6438[0]) + (_e6732 * _e6438[1])) + (_e6734 * _e6438[2]));
                                        let _e6834 = (((_e6730 * _e6455) + (_e6732 * _e6456)) + (_e6734 * _e6457));
                                        let _e6839 = (((_e6730 * _e6465) + (_e6732 * _e6466)) + (_e6734 * _e6467));
                                        let _e6847 = (((_e6730 * _e6464[0]) + (_e6732 * _e6464[1])) + (_e6734 * _e6464[2]));
                                        if (_e6805 < 0f) {
                                            phi_16231_ = -(_e6805);
                                        } else {
                                            phi_16231_ = _e6805;
                                        }
                                        let _e6852 = phi_16231_;
                                        if (_e6829 < 0f) {
                                            phi_16237_ = -(_e6829);
                                        } else {
                                            phi_16237_ = _e6829;
                                        }
                                        let _e6856 = phi_16237_;
                                        if (_e6810 < 0f) {
                                            phi_16246_ = -(_e6810);
                                        } else {
                                            phi_16246_ = _e6810;
                                        }
                                        let _e6863 = phi_16246_;
                                        if (_e6834 < 0f) {
                                            phi_16252_ = -(_e6834);
                                        } else {
                                            phi_16252_ = _e6834;
                                        }
                                        let _e6867 = phi_16252_;
                                        if (_e6815 < 0f) {
                                            phi_16261_ = -(_e6815);
                                        } else {
                                            phi_16261_ = _e6815;
                                        }
                                        let _e6874 = phi_16261_;
                                        if (_e6839 < 0f) {
                                            phi_16267_ = -(_e6839);
                                        } else {
                                            phi_16267_ = _e6839;
                                        }
                                        let _e6878 = phi_16267_;
                                        if (_e6823 < 0f) {
                                            phi_16276_ = -(_e6823);
                                        } else {
                                            phi_16276_ = _e6823;
                                        }
                                        let _e6885 = phi_16276_;
                                        if (_e6847 < 0f) {
                                            phi_16282_ = -(_e6847);
                                        } else {
                                            phi_16282_ = _e6847;
                                        }
                                        let _e6889 = phi_16282_;
                                        phi_16288_ = type_29(array<f32, 4>(_e6805, _e6810, _e6815, _e6823), array<f32, 4>(_e6829, _e6834, _e6839, _e6847), array<f32, 4>((_e6800 + ((_e6852 + _e6856) * _e6795)), (_e6800 + ((_e6863 + _e6867) * _e6795)), (_e6800 + ((_e6874 + _e6878) * _e6795)), (_e6800 + ((_e6885 + _e6889) * _e6795))));
                                        phi_16289_ = false;
                                    } else {
                                        phi_16288_ = type_29();
                                        phi_16289_ = true;
                                    }
                                    let _e6896 = phi_16288_;
                                    let _e6898 = phi_16289_;
                                    phi_16290_ = _e6896;
                                    phi_16291_ = _e6898;
                                } else {
                                    phi_16290_ = type_29();
                                    phi_16291_ = true;
                                }
                                let _e6900 = phi_16290_;
                                let _e6902 = phi_16291_;
                                if _e6902 {
                                    phi_16299_ = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                } else {
                                    phi_16299_ = _e6900;
                                }
                                let _e6904 = phi_16299_;
                                local_8 = type_29(array<f32, 4>(_e6904.member[0], _e6904.member[1], _e6904.member[2], _e6904.member[3]), array<f32, 4>(_e6904.member_1[0], _e6904.member_1[1], _e6904.member_1[2], _e6904.member_1[3]), array<f32, 4>(_e6904.member_2[0], _e6904.member_2[1], _e6904.member_2[2], _e6904.member_2[3]));
                                let _e6926 = local_8.member[0u];
                                let _e6929 = local_8.member_1[0u];
                                let _e6932 = local_8.member[0u];
                                let _e6938 = local_8.member_2[0u];
                                if (((_e6926 + ((_e6929 - _e6932) * _e5597)) - _e6938) > 0f) {
                                    let _e6943 = local_8.member[1u];
                                    let _e6946 = local_8.member_1[1u];
                                    let _e6949 = local_8.member[1u];
                                    let _e6955 = local_8.member_2[1u];
                                    if (((_e6943 + ((_e6946 - _e6949) * _e5597)) - _e6955) > 0f) {
                                        let _e6960 = local_8.member[2u];
                                        let _e6963 = local_8.member_1[2u];
                                        let _e6966 = local_8.member[2u];
                                        let _e6972 = local_8.member_2[2u];
                                        if (((_e6960 + ((_e6963 - _e6966) * _e5597)) - _e6972) > 0f) {
                                            let _e6977 = local_8.member[3u];
                                            let _e6980 = local_8.member_1[3u];
                                            let _e6983 = local_8.member[3u];
                                            let _e6989 = local_8.member_2[3u];
                                            phi_16468_ = (((_e6977 + ((_e6980 - _e6983) * _e5597)) - _e6989) > 0f);
                                            phi_16469_ = false;
                                        } else {
                                            phi_16468_ = bool();
                                            phi_16469_ = true;
                                        }
                                        let _e6993 = phi_16468_;
                                        let _e6995 = phi_16469_;
                                        phi_16470_ = _e6993;
                                        phi_16471_ = _e6995;
                                    } else {
                                        phi_16470_ = bool();
                                        phi_16471_ = true;
                                    }
                                    let _e6997 = phi_16470_;
                                    let _e6999 = phi_16471_;
                                    phi_16472_ = _e6997;
                                    phi_16473_ = _e6999;
                                } else {
                                    phi_16472_ = bool();
                                    phi_16473_ = true;
                                }
                                let _e7001 = phi_16472_;
                                let _e7003 = phi_16473_;
                                if _e7003 {
                                    phi_16477_ = false;
                                } else {
                                    phi_16477_ = _e7001;
                                }
                                let _e7005 = phi_16477_;
                                if _e7005 {
                                    phi_17831_ = bool();
                                    phi_17832_ = true;
                                } else {
                                    if (_e6706[0] < 0f) {
                                        phi_16504_ = -(_e6706[0]);
                                    } else {
                                        phi_16504_ = _e6706[0];
                                    }
                                    let _e7010 = phi_16504_;
                                    let _e7012 = ((_e7010 + 0f) + 0f);
                                    if (_e7012 > 0f) {
                                        if ((bitcast<u32>(_e7012) & 2139095040u) != 2139095040u) {
                                            let _e7017 = (1f / _e7012);
                                            let _e7018 = (_e6706[0] * _e7017);
                                            let _e7019 = (0f * _e7017);
                                            let _e7020 = (0f * _e7017);
                                            let _e7025 = (((_e7018 * _e7018) + (_e7019 * _e7019)) + (_e7020 * _e7020));
                                            if (_e7025 <= 0.000000000000000000000000000000000000011754944f) {
                                                if (_e7025 > 0f) {
                                                    phi_16551_ = (0.000000000000000000106433627f * 2f);
                                                } else {
                                                    phi_16551_ = 0f;
                                                }
                                                let _e7078 = phi_16551_;
                                                phi_16615_ = _e7078;
                                            } else {
                                                phi_16558_ = type_14(0i, 5i);
                                                phi_16561_ = bitcast<f32>(((bitcast<u32>(_e7025) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e7033 = phi_16558_;
                                                    let _e7035 = phi_16561_;
                                                    local_86 = _e7035;
                                                    if (_e7033.member < _e7033.member_1) {
                                                        let _e7042 = (_e7033.member + 1i);
                                                        if ((false == (_e7042 > _e7033.member)) != false) {
                                                            phi_16582_ = true;
                                                        } else {
                                                            phi_16582_ = false;
                                                        }
                                                        let _e7047 = phi_16582_;
                                                        if _e7047 {
                                                            phi_16588_ = type_15(0u, type_15().member_1);
                                                        } else {
                                                            phi_16588_ = type_15(1u, _e7042);
                                                        }
                                                        let _e7052 = phi_16588_;
                                                        phi_16559_ = type_14(_e7052.member_1, _e7033.member_1);
                                                        phi_16602_ = type_15(1u, _e7033.member);
                                                    } else {
                                                        phi_16559_ = _e7033;
                                                        phi_16602_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e7058 = phi_16559_;
                                                    let _e7060 = phi_16602_;
                                                    let _e7063 = (bitcast<i32>(_e7060.member) != 0i);
                                                    if _e7063 {
                                                        phi_16562_ = (0.5f * (_e7035 + (_e7025 / _e7035)));
                                                    } else {
                                                        phi_16562_ = f32();
                                                    }
                                                    let _e7068 = phi_16562_;
                                                    continue;
                                                    continuing {
                                                        phi_16558_ = _e7058;
                                                        phi_16561_ = _e7068;
                                                        break if !(_e7063);
                                                    }
                                                }
                                                let _e7073 = local_86;
                                                phi_16615_ = (_e7073 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e7080 = phi_16615_;
                                            let _e7081 = (0.000000059604645f * 12f);
                                            let _e7086 = ((_e6639 * 1.01f) + ((0f * _e7080) * (1f + _e7081)));
                                            let _e7091 = (((_e7018 * _e6406[0]) + (_e7019 * _e6406[1])) + (_e7020 * _e6406[2]));
                                            let _e7096 = (((_e7018 * _e6423) + (_e7019 * _e6424)) + (_e7020 * _e6425));
                                            let _e7101 = (((_e7018 * _e6433) + (_e7019 * _e6434)) + (_e7020 * _e6435));
                                            let _e7109 = (((_e7018 * _e6432[0]) + (_e7019 * _e6432[1])) + (_e7020 * _e6432[2]));
                                            let _e7115 = (((_e7018 * _e6438[0]) + (_e7019 * _e6438[1])) + (_e7020 * _e6438[2]));
                                            let _e7120 = (((_e7018 * _e6455) + (_e7019 * _e6456)) + (_e7020 * _e6457));
                                            let _e7125 = (((_e7018 * _e6465) + (_e7019 * _e6466)) + (_e7020 * _e6467));
                                            let _e7133 = (((_e7018 * _e6464[0]) + (_e7019 * _e6464[1])) + (_e7020 * _e6464[2]));
                                            if (_e7091 < 0f) {
                                                phi_16681_ = -(_e7091);
                                            } else {
                                                phi_16681_ = _e7091;
                                            }
                                            let _e7138 = phi_16681_;
                                            if (_e7115 < 0f) {
                                                phi_16687_ = -(_e7115);
                                            } else {
                                                phi_16687_ = _e7115;
                                            }
                                            let _e7142 = phi_16687_;
                                            if (_e7096 < 0f) {
                                                phi_16696_ = -(_e7096);
                                            } else {
                                                phi_16696_ = _e7096;
                                            }
                                            let _e7149 = phi_16696_;
                                            if (_e7120 < 0f) {
                                                phi_16702_ = -(_e7120);
                                            } else {
                                                phi_16702_ = _e7120;
                                            }
                                            let _e7153 = phi_16702_;
                                            if (_e7101 < 0f) {
                                                phi_16711_ = -(_e7101);
                                            } else {
                                                phi_16711_ = _e7101;
                                            }
                                            let _e7160 = phi_16711_;
                                            if (_e7125 < 0f) {
                                                phi_16717_ = -(_e7125);
                                            } else {
                                                phi_16717_ = _e7125;
                                            }
                                            let _e7164 = phi_16717_;
                                            if (_e7109 < 0f) {
                                                phi_16726_ = -(_e7109);
                                            } else {
                                                phi_16726_ = _e7109;
                                            }
                                            let _e7171 = phi_16726_;
                                            if (_e7133 < 0f) {
                                                phi_16732_ = -(_e7133);
                                            } else {
                                                phi_16732_ = _e7133;
                                            }
                                            let _e7175 = phi_16732_;
                                            phi_16738_ = type_29(array<f32, 4>(_e7091, _e7096, _e7101, _e7109), array<f32, 4>(_e7115, _e7120, _e7125, _e7133), array<f32, 4>((_e7086 + ((_e7138 + _e7142) * _e7081)), (_e7086 + ((_e7149 + _e7153) * _e7081)), (_e7086 + ((_e7160 + _e7164) * _e7081)), (_e7086 + ((_e7171 + _e7175) * _e7081))));
                                            phi_16739_ = false;
                                        } else {
                                            phi_16738_ = type_29();
                                            phi_16739_ = true;
                                        }
                                        let _e7182 = phi_16738_;
                                        let _e7184 = phi_16739_;
                                        phi_16740_ = _e7182;
                                        phi_16741_ = _e7184;
                                    } else {
                                        phi_16740_ = type_29();
                                        phi_16741_ = true;
                                    }
                                    let _e7186 = phi_16740_;
                                    let _e7188 = phi_16741_;
                                    if _e7188 {
                                        phi_16749_ = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    } else {
                                        phi_16749_ = _e7186;
                                    }
                                    let _e7190 = phi_16749_;
                                    local_9 = type_29(array<f32, 4>(_e7190.member[0], _e7190.member[1], _e7190.member[2], _e7190.member[3]), array<f32, 4>(_e7190.member_1[0], _e7190.member_1[1], _e7190.member_1[2], _e7190.member_1[3]), array<f32, 4>(_e7190.member_2[0], _e7190.member_2[1], _e7190.member_2[2], _e7190.member_2[3]));
                                    let _e7212 = local_9.member[0u];
                                    let _e7215 = local_9.member_1[0u];
                                    let _e7218 = local_9.member[0u];
                                    let _e7224 = local_9.member_2[0u];
                                    if (((_e7212 + ((_e7215 - _e7218) * _e5597)) - _e7224) > 0f) {
                                        let _e7229 = local_9.member[1u];
                                        let _e7232 = local_9.member_1[1u];
                                        let _e7235 = local_9.member[1u];
                                        let _e7241 = local_9.member_2[1u];
                                        if (((_e7229 + ((_e7232 - _e7235) * _e5597)) - _e7241) > 0f) {
                                            let _e7246 = local_9.member[2u];
                                            let _e7249 = local_9.member_1[2u];
                                            let _e7252 = local_9.member[2u];
                                            let _e7258 = local_9.member_2[2u];
                                            if (((_e7246 + ((_e7249 - _e7252) * _e5597)) - _e7258) > 0f) {
                                                let _e7263 = local_9.member[3u];
                                                let _e7266 = local_9.member_1[3u];
                                                let _e7269 = local_9.member[3u];
                                                let _e7275 = local_9.member_2[3u];
                                                phi_16918_ = (((_e7263 + ((_e7266 - _e7269) * _e5597)) - _e7275) > 0f);
                                                phi_16919_ = false;
                                            } else {
                                                phi_16918_ = bool();
                                                phi_16919_ = true;
                                            }
                                            let _e7279 = phi_16918_;
                                            let _e7281 = phi_16919_;
                                            phi_16920_ = _e7279;
                                            phi_16921_ = _e7281;
                                        } else {
                                            phi_16920_ = bool();
                                            phi_16921_ = true;
                                        }
                                        let _e7283 = phi_16920_;
                                        let _e7285 = phi_16921_;
                                        phi_16922_ = _e7283;
                                        phi_16923_ = _e7285;
                                    } else {
                                        phi_16922_ = bool();
                                        phi_16923_ = true;
                                    }
                                    let _e7287 = phi_16922_;
                                    let _e7289 = phi_16923_;
                                    if _e7289 {
                                        phi_16927_ = false;
                                    } else {
                                        phi_16927_ = _e7287;
                                    }
                                    let _e7291 = phi_16927_;
                                    if _e7291 {
                                        phi_17829_ = bool();
                                        phi_17830_ = true;
                                    } else {
                                        if (_e6706[1] < 0f) {
                                            phi_16960_ = -(_e6706[1]);
                                        } else {
                                            phi_16960_ = _e6706[1];
                                        }
                                        let _e7296 = phi_16960_;
                                        let _e7298 = ((0f + _e7296) + 0f);
                                        if (_e7298 > 0f) {
                                            if ((bitcast<u32>(_e7298) & 2139095040u) != 2139095040u) {
                                                let _e7303 = (1f / _e7298);
                                                let _e7304 = (0f * _e7303);
                                                let _e7305 = (_e6706[1] * _e7303);
                                                let _e7306 = (0f * _e7303);
                                                let _e7311 = (((_e7304 * _e7304) + (_e7305 * _e7305)) + (_e7306 * _e7306));
                                                if (_e7311 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e7311 > 0f) {
                                                        phi_17001_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_17001_ = 0f;
                                                    }
                                                    let _e7364 = phi_17001_;
                                                    phi_17065_ = _e7364;
                                                } else {
                                                    phi_17008_ = type_14(0i, 5i);
                                                    phi_17011_ = bitcast<f32>(((bitcast<u32>(_e7311) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e7319 = phi_17008_;
                                                        let _e7321 = phi_17011_;
                                                        local_87 = _e7321;
                                                        if (_e7319.member < _e7319.member_1) {
                                                            let _e7328 = (_e7319.member + 1i);
                                                            if ((false == (_e7328 > _e7319.member)) != false) {
                                                                phi_17032_ = true;
                                                            } else {
                                                                phi_17032_ = false;
                                                            }
                                                            let _e7333 = phi_17032_;
                                                            if _e7333 {
                                                                phi_17038_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_17038_ = type_15(1u, _e7328);
                                                            }
                                                            let _e7338 = phi_17038_;
                                                            phi_17009_ = type_14(_e7338.member_1, _e7319.member_1);
                                                            phi_17052_ = type_15(1u, _e7319.member);
                                                        } else {
                                                            phi_17009_ = _e7319;
                                                            phi_17052_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e7344 = phi_17009_;
                                                        let _e7346 = phi_17052_;
                                                        let _e7349 = (bitcast<i32>(_e7346.member) != 0i);
                                                        if _e7349 {
                                                            phi_17012_ = (0.5f * (_e7321 + (_e7311 / _e7321)));
                                                        } else {
                                                            phi_17012_ = f32();
                                                        }
                                                        let _e7354 = phi_17012_;
                                                        continue;
                                                        continuing {
                                                            phi_17008_ = _e7344;
                                                            phi_17011_ = _e7354;
                                                            break if !(_e7349);
                                                        }
                                                    }
                                                    let _e7359 = local_87;
                                                    phi_17065_ = (_e7359 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e7366 = phi_17065_;
                                                let _e7367 = (0.000000059604645f * 12f);
                                                let _e7372 = ((_e6639 * 1.01f) + ((0f * _e7366) * (1f + _e7367)));
                                                let _e7377 = (((_e7304 * _e6406[0]) + (_e7305 * _e6406[1])) + (_e7306 * _e6406[2]));
                                                let _e7382 = (((_e7304 * _e6423) + (_e7305 * _e6424)) + (_e7306 * _e6425));
                                                let _e7387 = (((_e7304 * _e6433) + (_e7305 * _e6434)) + (_e7306 * _e6435));
                                                let _e7395 = (((_e7304 * _e6432[0]) + (_e7305 * _e6432[1])) + (_e7306 * _e6432[2]));
                                                let _e7401 = (((_e7304 * _e6438[0]) + (_e7305 * _e6438[1])) + (_e7306 * _e6438[2]));
                                                let _e7406 = (((_e7304 * _e6455) + (_e7305 * _e6456)) + (_e7306 * _e6457));
                                                let _e7411 = (((_e7304 * _e6465) + (_e7305 * _e6466)) + (_e7306 * _e6467));
                                                let _e7419 = (((_e7304 * _e6464[0]) + (_e7305 * _e6464[1])) + (_e7306 * _e6464[2]));
                                                if (_e7377 < 0f) {
                                                    phi_17131_ = -(_e7377);
                                                } else {
                                                    phi_17131_ = _e7377;
                                                }
                                                let _e7424 = phi_17131_;
                                                if (_e7401 < 0f) {
                                                    phi_17137_ = -(_e7401);
                                                } else {
                                                    phi_17137_ = _e7401;
                                                }
                                                let _e7428 = phi_17137_;
                                                if (_e7382 < 0f) {
                                                    phi_17146_ = -(_e7382);
                                                } else {
                                                    phi_17146_ = _e7382;
                                                }
                                                let _e7435 = phi_17146_;
                                                if (_e7406 < 0f) {
                                                    phi_17152_ = -(_e7406);
                                                } else {
                                                    phi_17152_ = _e7406;
                                                }
                                                let _e7439 = phi_17152_;
                                                if (_e7387 < 0f) {
                                                    phi_17161_ = -(_e7387);
                                                } else {
                                                    phi_17161_ = _e7387;
                                                }
                                                let _e7446 = phi_17161_;
                                                if (_e7411 < 0f) {
                                                    phi_17167_ = -(_e7411);
                                                } else {
                                                    phi_17167_ = _e7411;
                                                }
                                                let _e7450 = phi_17167_;
                                                if (_e7395 < 0f) {
                                                    phi_17176_ = -(_e7395);
                                                } else {
                                                    phi_17176_ = _e7395;
                                                }
                                                let _e7457 = phi_17176_;
                                                if (_e7419 < 0f) {
                                                    phi_17182_ = -(_e7419);
                                                } else {
                                                    phi_17182_ = _e7419;
                                                }
                                                let _e7461 = phi_17182_;
                                                phi_17188_ = type_29(array<f32, 4>(_e7377, _e7382, _e7387, _e7395), array<f32, 4>(_e7401, _e7406, _e7411, _e7419), array<f32, 4>((_e7372 + ((_e7424 + _e7428) * _e7367)), (_e7372 + ((_e7435 + _e7439) * _e7367)), (_e7372 + ((_e7446 + _e7450) * _e7367)), (_e7372 + ((_e7457 + _e7461) * _e7367))));
                                                phi_17189_ = false;
                                            } else {
                                                phi_17188_ = type_29();
                                                phi_17189_ = true;
                                            }
                                            let _e7468 = phi_17188_;
                                            let _e7470 = phi_17189_;
                                            phi_17190_ = _e7468;
                                            phi_17191_ = _e7470;
                                        } else {
                                            phi_17190_ = type_29();
                                            phi_17191_ = true;
                                        }
                                        let _e7472 = phi_17190_;
                                        let _e7474 = phi_17191_;
                                        if _e7474 {
                                            phi_17199_ = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        } else {
                                            phi_17199_ = _e7472;
                                        }
                                        let _e7476 = phi_17199_;
                                        local_10 = type_29(array<f32, 4>(_e7476.member[0], _e7476.member[1], _e7476.member[2], _e7476.member[3]), array<f32, 4>(_e7476.member_1[0], _e7476.member_1[1], _e7476.member_1[2], _e7476.member_1[3]), array<f32, 4>(_e7476.member_2[0], _e7476.member_2[1], _e7476.member_2[2], _e7476.member_2[3]));
                                        let _e7498 = local_10.member[0u];
                                        let _e7501 = local_10.member_1[0u];
                                        let _e7504 = local_10.member[0u];
                                        let _e7510 = local_10.member_2[0u];
                                        if (((_e7498 + ((_e7501 - _e7504) * _e5597)) - _e7510) > 0f) {
                                            let _e7515 = local_10.member[1u];
                                            let _e7518 = local_10.member_1[1u];
                                            let _e7521 = local_10.member[1u];
                                            let _e7527 = local_10.member_2[1u];
                                            if (((_e7515 + ((_e7518 - _e7521) * _e5597)) - _e7527) > 0f) {
                                                let _e7532 = local_10.member[2u];
                                                let _e7535 = local_10.member_1[2u];
                                                let _e7538 = local_10.member[2u];
                                                let _e7544 = local_10.member_2[2u];
                                                if (((_e7532 + ((_e7535 - _e7538) * _e5597)) - _e7544) > 0f) {
                                                    let _e7549 = local_10.member[3u];
                                                    let _e7552 = local_10.member_1[3u];
                                                    let _e7555 = local_10.member[3u];
                                                    let _e7561 = local_10.member_2[3u];
                                                    phi_17368_ = (((_e7549 + ((_e7552 - _e7555) * _e5597)) - _e7561) > 0f);
                                                    phi_17369_ = false;
                                                } else {
                                                    phi_17368_ = bool();
                                                    phi_17369_ = true;
                                                }
                                                let _e7565 = phi_17368_;
                                                let _e7567 = phi_17369_;
                                                phi_17370_ = _e7565;
                                                phi_17371_ = _e7567;
                                            } else {
                                                phi_17370_ = bool();
                                                phi_17371_ = true;
                                            }
                                            let _e7569 = phi_17370_;
                                            let _e7571 = phi_17371_;
                                            phi_17372_ = _e7569;
                                            phi_17373_ = _e7571;
                                        } else {
                                            phi_17372_ = bool();
                                            phi_17373_ = true;
                                        }
                                        let _e7573 = phi_17372_;
                                        let _e7575 = phi_17373_;
                                        if _e7575 {
                                            phi_17377_ = false;
                                        } else {
                                            phi_17377_ = _e7573;
                                        }
                                        let _e7577 = phi_17377_;
                                        if _e7577 {
                                            phi_17828_ = bool();
                                        } else {
                                            if (_e6706[2] < 0f) {
                                                phi_17417_ = -(_e6706[2]);
                                            } else {
                                                phi_17417_ = _e6706[2];
                                            }
                                            let _e7583 = phi_17417_;
                                            let _e7584 = ((0f + 0f) + _e7583);
                                            if (_e7584 > 0f) {
                                                if ((bitcast<u32>(_e7584) & 2139095040u) != 2139095040u) {
                                                    let _e7589 = (1f / _e7584);
                                                    let _e7590 = (0f * _e7589);
                                                    let _e7591 = (0f * _e7589);
                                                    let _e7592 = (_e6706[2] * _e7589);
                                                    let _e7597 = (((_e7590 * _e7590) + (_e7591 * _e7591)) + (_e7592 * _e7592));
                                                    if (_e7597 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e7597 > 0f) {
                                                            phi_17451_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_17451_ = 0f;
                                                        }
                                                        let _e7650 = phi_17451_;
                                                        phi_17515_ = _e7650;
                                                    } else {
                                                        phi_17458_ = type_14(0i, 5i);
                                                        phi_17461_ = bitcast<f32>(((bitcast<u32>(_e7597) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e7605 = phi_17458_;
                                                            let _e7607 = phi_17461_;
                                                            local_88 = _e7607;
                                                            if (_e7605.member < _e7605.member_1) {
                                                                let _e7614 = (_e7605.member + 1i);
                                                                if ((false == (_e7614 > _e7605.member)) != false) {
                                                                    phi_17482_ = true;
                                                                } else {
                                                                    phi_17482_ = false;
                                                                }
                                                                let _e7619 = phi_17482_;
                                                                if _e7619 {
                                                                    phi_17488_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_17488_ = type_15(1u, _e7614);
                                                                }
                                                                let _e7624 = phi_17488_;
                                                                phi_17459_ = type_14(_e7624.member_1, _e7605.member_1);
                                                                phi_17502_ = type_15(1u, _e7605.member);
                                                            } else {
                                                                phi_17459_ = _e7605;
                                                                phi_17502_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e7630 = phi_17459_;
                                                            let _e7632 = phi_17502_;
                                                            let _e7635 = (bitcast<i32>(_e7632.member) != 0i);
                                                            if _e7635 {
                                                                phi_17462_ = (0.5f * (_e7607 + (_e7597 / _e7607)));
                                                            } else {
                                                                phi_17462_ = f32();
                                                            }
                                                            let _e7640 = phi_17462_;
                                                            continue;
                                                            continuing {
                                                                phi_17458_ = _e7630;
                                                                phi_17461_ = _e7640;
                                                                break if !(_e7635);
                                                            }
                                                        }
                                                        let _e7645 = local_88;
                                                        phi_17515_ = (_e7645 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e7652 = phi_17515_;
                                                    let _e7653 = (0.000000059604645f * 12f);
                                                    let _e7658 = ((_e6639 * 1.01f) + ((0f * _e7652) * (1f + _e7653)));
                                                    let _e7663 = (((_e7590 * _e6406[0]) + (_e7591 * _e6406[1])) + (_e7592 * _e6406[2]));
                                                    let _e7668 = (((_e7590 * _e6423) + (_e7591 * _e6424)) + (_e7592 * _e6425));
                                                    let _e7673 = (((_e7590 * _e6433) + (_e7591 * _e6434)) + (_e7592 * _e6435));
                                                    let _e7681 = (((_e7590 * _e6432[0]) + (_e7591 * _e6432[1])) + (_e7592 * _e6432[2]));
                                                    let _e7687 = (((_e7590 * _e6438[0]) + (_e7591 * _e6438[1])) + (_e7592 * _e6438[2]));
                                                    let _e7692 = (((_e7590 * _e6455) + (_e7591 * _e6456)) + (_e7592 * _e6457));
                                                    let _e7697 = (((_e7590 * _e6465) + (_e7591 * _e6466)) + (_e7592 * _e6467));
                                                    let _e7705 = (((_e7590 * _e6464[0]) + (_e7591 * _e6464[1])) + (_e7592 * _e6464[2]));
                                                    if (_e7663 < 0f) {
                                                        phi_17581_ = -(_e7663);
                                                    } else {
                                                        phi_17581_ = _e7663;
                                                    }
                                                    let _e7710 = phi_17581_;
                                                    if (_e7687 < 0f) {
                                                        phi_17587_ = -(_e7687);
                                                    } else {
                                                        phi_17587_ = _e7687;
                                                    }
                                                    let _e7714 = phi_17587_;
                                                    if (_e7668 < 0f) {
                                                        phi_17596_ = -(_e7668);
                                                    } else {
                                                        phi_17596_ = _e7668;
                                                    }
                                                    let _e7721 = phi_17596_;
                                                    if (_e7692 < 0f) {
                                                        phi_17602_ = -(_e7692);
                                                    } else {
                                                        phi_17602_ = _e7692;
                                                    }
                                                    let _e7725 = phi_17602_;
                                                    if (_e7673 < 0f) {
                                                        phi_17611_ = -(_e7673);
                                                    } else {
                                                        phi_17611_ = _e7673;
                                                    }
                                                    let _e7732 = phi_17611_;
                                                    if (_e7697 < 0f) {
                                                        phi_17617_ = -(_e7697);
                                                    } else {
                                                        phi_17617_ = _e7697;
                                                    }
                                                    let _e7736 = phi_17617_;
                                                    if (_e7681 < 0f) {
                                                        phi_17626_ = -(_e7681);
                                                    } else {
                                                        phi_17626_ = _e7681;
                                                    }
                                                    let _e7743 = phi_17626_;
                                                    if (_e7705 < 0f) {
                                                        phi_17632_ = -(_e7705);
                                                    } else {
                                                        phi_17632_ = _e7705;
                                                    }
                                                    let _e7747 = phi_17632_;
                                                    phi_17638_ = type_29(array<f32, 4>(_e7663, _e7668, _e7673, _e7681), array<f32, 4>(_e7687, _e7692, _e7697, _e7705), array<f32, 4>((_e7658 + ((_e7710 + _e7714) * _e7653)), (_e7658 + ((_e7721 + _e7725) * _e7653)), (_e7658 + ((_e7732 + _e7736) * _e7653)), (_e7658 + ((_e7743 + _e7747) * _e7653))));
                                                    phi_17639_ = false;
                                                } else {
                                                    phi_17638_ = type_29();
                                                    phi_17639_ = true;
                                                }
                                                let _e7754 = phi_17638_;
                                                let _e7756 = phi_17639_;
                                                phi_17640_ = _e7754;
                                                phi_17641_ = _e7756;
                                            } else {
                                                phi_17640_ = type_29();
                                                phi_17641_ = true;
                                            }
                                            let _e7758 = phi_17640_;
                                            let _e7760 = phi_17641_;
                                            if _e7760 {
                                                phi_17649_ = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            } else {
                                                phi_17649_ = _e7758;
                                            }
                                            let _e7762 = phi_17649_;
                                            local_11 = type_29(array<f32, 4>(_e7762.member[0], _e7762.member[1], _e7762.member[2], _e7762.member[3]), array<f32, 4>(_e7762.member_1[0], _e7762.member_1[1], _e7762.member_1[2], _e7762.member_1[3]), array<f32, 4>(_e7762.member_2[0], _e7762.member_2[1], _e7762.member_2[2], _e7762.member_2[3]));
                                            let _e7784 = local_11.member[0u];
                                            let _e7787 = local_11.member_1[0u];
                                            let _e7790 = local_11.member[0u];
                                            let _e7796 = local_11.member_2[0u];
                                            if (((_e7784 + ((_e7787 - _e7790) * _e5597)) - _e7796) > 0f) {
                                                let _e7801 = local_11.member[1u];
                                                let _e7804 = local_11.member_1[1u];
                                                let _e7807 = local_11.member[1u];
                                                let _e7813 = local_11.member_2[1u];
                                                if (((_e7801 + ((_e7804 - _e7807) * _e5597)) - _e7813) > 0f) {
                                                    let _e7818 = local_11.member[2u];
                                                    let _e7821 = local_11.member_1[2u];
                                                    let _e7824 = local_11.member[2u];
                                                    let _e7830 = local_11.member_2[2u];
                                                    if (((_e7818 + ((_e7821 - _e7824) * _e5597)) - _e7830) > 0f) {
                                                        let _e7835 = local_11.member[3u];
                                                        let _e7838 = local_11.member_1[3u];
                                                        let _e7841 = local_11.member[3u];
                                                        let _e7847 = local_11.member_2[3u];
                                                        phi_17818_ = (((_e7835 + ((_e7838 - _e7841) * _e5597)) - _e7847) > 0f);
                                                        phi_17819_ = false;
                                                    } else {
                                                        phi_17818_ = bool();
                                                        phi_17819_ = true;
                                                    }
                                                    let _e7851 = phi_17818_;
                                                    let _e7853 = phi_17819_;
                                                    phi_17820_ = _e7851;
                                                    phi_17821_ = _e7853;
                                                } else {
                                                    phi_17820_ = bool();
                                                    phi_17821_ = true;
                                                }
                                                let _e7855 = phi_17820_;
                                                let _e7857 = phi_17821_;
                                                phi_17822_ = _e7855;
                                                phi_17823_ = _e7857;
                                            } else {
                                                phi_17822_ = bool();
                                                phi_17823_ = true;
                                            }
                                            let _e7859 = phi_17822_;
                                            let _e7861 = phi_17823_;
                                            if _e7861 {
                                                phi_17827_ = false;
                                            } else {
                                                phi_17827_ = _e7859;
                                            }
                                            let _e7863 = phi_17827_;
                                            phi_17828_ = _e7863;
                                        }
                                        let _e7865 = phi_17828_;
                                        phi_17829_ = _e7865;
                                        phi_17830_ = _e7577;
                                    }
                                    let _e7867 = phi_17829_;
                                    let _e7869 = phi_17830_;
                                    phi_17831_ = _e7867;
                                    phi_17832_ = _e7869;
                                }
                                let _e7871 = phi_17831_;
                                let _e7873 = phi_17832_;
                                if _e7873 {
                                    phi_17836_ = true;
                                } else {
                                    phi_17836_ = _e7871;
                                }
                                let _e7875 = phi_17836_;
                                if !(_e7875) {
                                    phi_17842_ = type_44(2u, _e5597);
                                    phi_17843_ = false;
                                } else {
                                    phi_17842_ = type_44();
                                    phi_17843_ = true;
                                }
                                let _e7879 = phi_17842_;
                                let _e7881 = phi_17843_;
                                phi_17844_ = _e7879;
                                phi_17845_ = _e7881;
                            } else {
                                phi_17844_ = type_44();
                                phi_17845_ = true;
                            }
                            let _e7883 = phi_17844_;
                            let _e7885 = phi_17845_;
                            if _e7885 {
                                let _e7891 = ((_e6027 - (3f * _e6004)) * _e6381);
                                let _e7892 = ((_e6050 - _e6027) * _e6381);
                                let _e7893 = (((3f * _e6061) - _e6050) * _e6381);
                                local_6[0u] = 0f;
                                local_6[1u] = 1f;
                                local_6[2u] = 1f;
                                local_6[3u] = 1f;
                                let _e7900 = ((_e7892 * _e7892) - (_e7891 * _e7893));
                                if (_e7900 > 0f) {
                                    if (_e7900 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e7900 > 0f) {
                                            phi_17881_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_17881_ = 0f;
                                        }
                                        let _e7954 = phi_17881_;
                                        phi_17945_ = _e7954;
                                    } else {
                                        phi_17888_ = type_14(0i, 5i);
                                        phi_17891_ = bitcast<f32>(((bitcast<u32>(_e7900) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e7909 = phi_17888_;
                                            let _e7911 = phi_17891_;
                                            local_89 = _e7911;
                                            if (_e7909.member < _e7909.member_1) {
                                                let _e7918 = (_e7909.member + 1i);
                                                if ((false == (_e7918 > _e7909.member)) != false) {
                                                    phi_17912_ = true;
                                                } else {
                                                    phi_17912_ = false;
                                                }
                                                let _e7923 = phi_17912_;
                                                if _e7923 {
                                                    phi_17918_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_17918_ = type_15(1u, _e7918);
                                                }
                                                let _e7928 = phi_17918_;
                                                phi_17889_ = type_14(_e7928.member_1, _e7909.member_1);
                                                phi_17932_ = type_15(1u, _e7909.member);
                                            } else {
                                                phi_17889_ = _e7909;
                                                phi_17932_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e7934 = phi_17889_;
                                            let _e7936 = phi_17932_;
                                            let _e7939 = (bitcast<i32>(_e7936.member) != 0i);
                                            if _e7939 {
                                                phi_17892_ = (0.5f * (_e7911 + (_e7900 / _e7911)));
                                            } else {
                                                phi_17892_ = f32();
                                            }
                                            let _e7944 = phi_17892_;
                                            continue;
                                            continuing {
                                                phi_17888_ = _e7934;
                                                phi_17891_ = _e7944;
                                                break if !(_e7939);
                                            }
                                        }
                                        let _e7949 = local_89;
                                        phi_17945_ = (_e7949 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e7956 = phi_17945_;
                                    if (_e7892 < 0f) {
                                        phi_17951_ = -(_e7956);
                                    } else {
                                        phi_17951_ = _e7956;
                                    }
                                    let _e7960 = phi_17951_;
                                    let _e7962 = -((_e7892 + _e7960));
                                    local_7[0u] = (_e7962 / (_e7962 + _e7893));
                                    local_7[1u] = (_e7891 / (_e7891 + _e7962));
                                    let _e7971 = local_7[1u];
                                    let _e7972 = local_7[0u];
                                    if (_e7971 < _e7972) {
                                        let _e7975 = local_7[1u];
                                        let _e7977 = local_7[0u];
                                        local_7[0u] = _e7975;
                                        local_7[1u] = _e7977;
                                    }
                                    phi_17976_ = type_9(0u, 2u);
                                    phi_17979_ = 1u;
                                    loop {
                                        let _e7981 = phi_17976_;
                                        let _e7983 = phi_17979_;
                                        local_134 = _e7983;
                                        if (_e7981.member < _e7981.member_1) {
                                            phi_17977_ = type_9((_e7981.member + 1u), _e7981.member_1);
                                            phi_18002_ = type_9(1u, _e7981.member);
                                        } else {
                                            phi_17977_ = _e7981;
                                            phi_18002_ = type_9(0u, type_9().member_1);
                                        }
                                        let _e7995 = phi_17977_;
                                        let _e7997 = phi_18002_;
                                        let _e8001 = (bitcast<i32>(_e7997.member) != 0i);
                                        if _e8001 {
                                            let _e8003 = local_7[_e7997.member_1];
                                            if (_e8003 > 0f) {
                                                let _e8006 = local_7[_e7997.member_1];
                                                if (_e8006 < 1f) {
                                                    let _e8009 = local_7[_e7997.member_1];
                                                    local_6[_e7983] = _e8009;
                                                    phi_18046_ = (_e7983 + 1u);
                                                } else {
                                                    phi_18046_ = _e7983;
                                                }
                                                let _e8013 = phi_18046_;
                                                phi_18047_ = _e8013;
                                            } else {
                                                phi_18047_ = _e7983;
                                            }
                                            let _e8015 = phi_18047_;
                                            phi_17980_ = _e8015;
                                        } else {
                                            phi_17980_ = u32();
                                        }
                                        let _e8017 = phi_17980_;
                                        continue;
                                        continuing {
                                            phi_17976_ = _e7995;
                                            phi_17979_ = _e8017;
                                            break if !(_e8001);
                                        }
                                    }
                                    let _e16175 = local_134;
                                    phi_18048_ = _e16175;
                                } else {
                                    phi_18048_ = 1u;
                                }
                                let _e8020 = phi_18048_;
                                local_6[_e8020] = 1f;
                                let _e8022 = local_6;
                                local_12 = _e8022;
                                phi_18068_ = type_9(0u, _e8020);
                                loop {
                                    let _e8025 = phi_18068_;
                                    if (_e8025.member < _e8025.member_1) {
                                        phi_18069_ = type_9((_e8025.member + 1u), _e8025.member_1);
                                        phi_18092_ = type_9(1u, _e8025.member);
                                    } else {
                                        phi_18069_ = _e8025;
                                        phi_18092_ = type_9(0u, type_9().member_1);
                                    }
                                    let _e8037 = phi_18069_;
                                    let _e8039 = phi_18092_;
                                    if (bitcast<i32>(_e8039.member) != 0i) {
                                        let _e8045 = local_12[_e8039.member_1];
                                        if (_e8045 > _e5597) {
                                            phi_18111_ = _e8045;
                                        } else {
                                            phi_18111_ = _e5597;
                                        }
                                        let _e8048 = phi_18111_;
                                        let _e8051 = local_12[(_e8039.member_1 + 1u)];
                                        if (_e8051 < _e5599) {
                                            phi_18124_ = _e8051;
                                        } else {
                                            phi_18124_ = _e5599;
                                        }
                                        let _e8054 = phi_18124_;
                                        if (_e8048 <= _e8054) {
                                            let _e8056 = (1f - _e8048);
                                            let _e8067 = ((((_e6004 * _e8056) + (_e6027 * _e8048)) * (_e8056 * _e8056)) + (((_e6050 * _e8056) + (_e6061 * _e8048)) * (_e8048 * _e8048)));
                                            let _e8068 = (1f - _e8054);
                                            let _e8079 = ((((_e6004 * _e8068) + (_e6027 * _e8054)) * (_e8068 * _e8068)) + (((_e6050 * _e8068) + (_e6061 * _e8054)) * (_e8054 * _e8054)));
                                            if (_e8067 < 0f) {
                                                phi_18158_ = -(_e8067);
                                            } else {
                                                phi_18158_ = _e8067;
                                            }
                                            let _e8083 = phi_18158_;
                                            let _e8084 = (_e8083 > _e6378);
                                            if (_e8079 < 0f) {
                                                phi_18165_ = -(_e8079);
                                            } else {
                                                phi_18165_ = _e8079;
                                            }
                                            let _e8088 = phi_18165_;
                                            let _e8089 = (_e8088 > _e6378);
                                            if _e8084 {
                                                if _e8089 {
                                                    phi_18176_ = ((_e8067 > 0f) != (_e8079 > 0f));
                                                    phi_18177_ = false;
                                                } else {
                                                    phi_18176_ = bool();
                                                    phi_18177_ = true;
                                                }
                                                let _e8094 = phi_18176_;
                                                let _e8096 = phi_18177_;
                                                phi_18178_ = _e8094;
                                                phi_18179_ = _e8096;
                                            } else {
                                                phi_18178_ = bool();
                                                phi_18179_ = true;
                                            }
                                            let _e8098 = phi_18178_;
                                            let _e8100 = phi_18179_;
                                            if _e8100 {
                                                phi_18183_ = false;
                                            } else {
                                                phi_18183_ = _e8098;
                                            }
                                            let _e8102 = phi_18183_;
                                            if _e8084 {
                                                if _e8089 {
                                                    if _e8102 {
                                                        phi_18194_ = type_47();
                                                    } else {
                                                        phi_18194_ = type_47(1f, 0f, _e8102);
                                                    }
                                                    let _e8105 = phi_18194_;
                                                    phi_18195_ = _e8105;
                                                    phi_18196_ = _e8102;
                                                } else {
                                                    phi_18195_ = type_47();
                                                    phi_18196_ = true;
                                                }
                                                let _e8107 = phi_18195_;
                                                let _e8109 = phi_18196_;
                                                phi_18197_ = _e8107;
                                                phi_18198_ = _e8109;
                                            } else {
                                                phi_18197_ = type_47();
                                                phi_18198_ = true;
                                            }
                                            let _e8111 = phi_18197_;
                                            let _e8113 = phi_18198_;
                                            if _e8113 {
                                                if _e8084 {
                                                    if (_e8067 < 0f) {
                                                        phi_18209_ = -1f;
                                                    } else {
                                                        phi_18209_ = 1f;
                                                    }
                                                    let _e8116 = phi_18209_;
                                                    let _e8119 = (_e6050 - _e6027);
                                                    phi_18219_ = type_9(0u, 64u);
                                                    phi_18222_ = _e8054;
                                                    phi_18224_ = _e8048;
                                                    phi_18226_ = (0.5f * (_e8048 + _e8054));
                                                    loop {
                                                        let _e8125 = phi_18219_;
                                                        let _e8127 = phi_18222_;
                                                        let _e8129 = phi_18224_;
                                                        let _e8131 = phi_18226_;
                                                        local_136 = _e8129;
                                                        if (_e8125.member < _e8125.member_1) {
                                                            phi_18220_ = type_9((_e8125.member + 1u), _e8125.member_1);
                                                            phi_18249_ = type_9(1u, _e8125.member);
                                                        } else {
                                                            phi_18220_ = _e8125;
                                                            phi_18249_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e8143 = phi_18220_;
                                                        let _e8145 = phi_18249_;
                                                        if (bitcast<i32>(_e8145.member) != 0i) {
                                                            let _e8149 = (1f - _e8131);
                                                            let _e8162 = ((_e8116 * ((((_e6004 * _e8149) + (_e6027 * _e8131)) * (_e8149 * _e8149)) + (((_e6050 * _e8149) + (_e6061 * _e8131)) * (_e8131 * _e8131)))) - _e6378);
                                                            if (_e8162 > 0f) {
                                                                phi_18274_ = _e8127;
                                                                phi_18275_ = _e8131;
                                                            } else {
                                                                phi_18274_ = _e8131;
                                                                phi_18275_ = _e8129;
                                                            }
                                                            let _e8165 = phi_18274_;
                                                            let _e8167 = phi_18275_;
                                                            let _e8169 = ((_e8165 - _e8167) > _e6385);
                                                            if _e8169 {
                                                                let _e8170 = (1f - _e8131);
                                                                let _e8182 = (-(_e8162) / (_e8116 * (((((_e6027 - (3f * _e6004)) * _e8170) + (_e8119 * _e8131)) * _e8170) + (((_e8119 * _e8170) + (((3f * _e6061) - _e6050) * _e8131)) * _e8131))));
                                                                if (_e8162 > 0f) {
                                                                    phi_18301_ = (0.5f * _e6385);
                                                                } else {
                                                                    phi_18301_ = -((0.5f * _e6385));
                                                                }
                                                                let _e8188 = phi_18301_;
                                                                let _e8190 = ((_e8131 + _e8182) + _e8188);
                                                                if (_e8190 > _e8167) {
                                                                    if (_e8190 < _e8165) {
                                                                        if (_e8182 < 0f) {
                                                                            phi_18317_ = -(_e8182);
                                                                        } else {
                                                                            phi_18317_ = _e8182;
                                                                        }
                                                                        let _e8196 = phi_18317_;
                                                                        if (_e8196 < (0.5f * (_e8165 - _e8167))) {
                                                                            phi_18324_ = false;
                                                                        } else {
                                                                            phi_18324_ = true;
                                                                        }
                                                                        let _e8201 = phi_18324_;
                                                                        phi_18325_ = _e8201;
                                                                    } else {
                                                                        phi_18325_ = true;
                                                                    }
                                                                    let _e8203 = phi_18325_;
                                                                    phi_18326_ = _e8203;
                                                                } else {
                                                                    phi_18326_ = true;
                                                                }
                                                                let _e8205 = phi_18326_;
                                                                if _e8205 {
                                                                    phi_18332_ = (0.5f * (_e8167 + _e8165));
                                                                } else {
                                                                    phi_18332_ = _e8190;
                                                                }
                                                                let _e8209 = phi_18332_;
                                                                phi_18333_ = _e8209;
                                                                phi_18334_ = false;
                                                            } else {
                                                                phi_18333_ = f32();
                                                                phi_18334_ = true;
                                                            }
                                                            let _e8211 = phi_18333_;
                                                            let _e8213 = phi_18334_;
                                                            phi_18223_ = _e8165;
                                                            phi_18225_ = _e8167;
                                                            phi_18227_ = _e8211;
                                                            phi_18335_ = _e8167;
                                                            phi_18336_ = _e8169;
                                                            phi_18337_ = _e8213;
                                                        } else {
                                                            phi_18223_ = f32();
                                                            phi_18225_ = f32();
                                                            phi_18227_ = f32();
                                                            phi_18335_ = f32();
                                                            phi_18336_ = false;
                                                            phi_18337_ = false;
                                                        }
                                                        let _e8215 = phi_18223_;
                                                        let _e8217 = phi_18225_;
                                                        let _e8219 = phi_18227_;
                                                        let _e8221 = phi_18335_;
                                                        let _e8223 = phi_18336_;
                                                        let _e8225 = phi_18337_;
                                                        local_90 = _e8225;
                                                        local_135 = _e8221;
                                                        continue;
                                                        continuing {
                                                            phi_18219_ = _e8143;
                                                            phi_18222_ = _e8215;
                                                            phi_18224_ = _e8217;
                                                            phi_18226_ = _e8219;
                                                            break if !(_e8223);
                                                        }
                                                    }
                                                    let _e8228 = local_90;
                                                    if _e8228 {
                                                        let _e16219 = local_135;
                                                        phi_18341_ = _e16219;
                                                    } else {
                                                        let _e16221 = local_136;
                                                        phi_18341_ = _e16221;
                                                    }
                                                    let _e8230 = phi_18341_;
                                                    phi_18342_ = _e8230;
                                                } else {
                                                    phi_18342_ = _e8048;
                                                }
                                                let _e8232 = phi_18342_;
                                                if _e8089 {
                                                    if (_e8079 < 0f) {
                                                        phi_18350_ = -1f;
                                                    } else {
                                                        phi_18350_ = 1f;
                                                    }
                                                    let _e8235 = phi_18350_;
                                                    phi_18354_ = type_9(0u, 64u);
                                                    phi_18357_ = (_e6385 + _e6385);
                                                    loop {
                                                        let _e8238 = phi_18354_;
                                                        let _e8240 = phi_18357_;
                                                        if (_e8238.member < _e8238.member_1) {
                                                            phi_18355_ = type_9((_e8238.member + 1u), _e8238.member_1);
                                                            phi_18380_ = type_9(1u, _e8238.member);
                                                        } else {
                                                            phi_18355_ = _e8238;
                                                            phi_18380_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e8252 = phi_18355_;
                                                        let _e8254 = phi_18380_;
                                                        if (bitcast<i32>(_e8254.member) != 0i) {
                                                            let _e8258 = (_e8232 + _e8240);
                                                            if (_e8258 < _e8054) {
                                                                let _e8260 = (1f - _e8258);
                                                                let _e8273 = ((_e8235 * ((((_e6004 * _e8260) + (_e6027 * _e8258)) * (_e8260 * _e8260)) + (((_e6050 * _e8260) + (_e6061 * _e8258)) * (_e8258 * _e8258)))) > _e6378);
                                                                if _e8273 {
                                                                    phi_18410_ = f32();
                                                                    phi_18411_ = false;
                                                                } else {
                                                                    phi_18410_ = (_e8240 + _e8240);
                                                                    phi_18411_ = true;
                                                                }
                                                                let _e8276 = phi_18410_;
                                                                let _e8278 = phi_18411_;
                                                                phi_18412_ = _e8276;
                                                                phi_18413_ = _e8278;
                                                                phi_18414_ = _e8273;
                                                                phi_18415_ = false;
                                                            } else {
                                                                phi_18412_ = f32();
                                                                phi_18413_ = false;
                                                                phi_18414_ = false;
                                                                phi_18415_ = true;
                                                            }
                                                            let _e8280 = phi_18412_;
                                                            let _e8282 = phi_18413_;
                                                            let _e8284 = phi_18414_;
                                                            let _e8286 = phi_18415_;
                                                            phi_18416_ = _e8258;
                                                            phi_18358_ = _e8280;
                                                            phi_18417_ = _e8282;
                                                            phi_18418_ = _e8284;
                                                            phi_18419_ = _e8286;
                                                            phi_18420_ = false;
                                                        } else {
                                                            phi_18416_ = f32();
                                                            phi_18358_ = f32();
                                                            phi_18417_ = false;
                                                            phi_18418_ = false;
                                                            phi_18419_ = false;
                                                            phi_18420_ = true;
                                                        }
                                                        let _e8288 = phi_18416_;
                                                        let _e8290 = phi_18358_;
                                                        let _e8292 = phi_18417_;
                                                        let _e8294 = phi_18418_;
                                                        let _e8296 = phi_18419_;
                                                        let _e8298 = phi_18420_;
                                                        local_91 = _e8294;
                                                        local_137 = _e8296;
                                                        local_138 = _e8298;
                                                        local_139 = _e8288;
                                                        continue;
                                                        continuing {
                                                            phi_18354_ = _e8252;
                                                            phi_18357_ = _e8290;
                                                            break if !(_e8292);
                                                        }
                                                    }
                                                    let _e8301 = local_91;
                                                    if _e8301 {
                                                        phi_18424_ = false;
                                                        phi_18425_ = false;
                                                    } else {
                                                        let _e16243 = local_137;
                                                        phi_18424_ = _e16243;
                                                        let _e16246 = local_138;
                                                        phi_18425_ = _e16246;
                                                    }
                                                    let _e8303 = phi_18424_;
                                                    let _e8305 = phi_18425_;
                                                    if _e8303 {
                                                        phi_18429_ = true;
                                                    } else {
                                                        phi_18429_ = _e8305;
                                                    }
                                                    let _e8307 = phi_18429_;
                                                    if _e8307 {
                                                        phi_18433_ = _e8054;
                                                    } else {
                                                        let _e16250 = local_139;
                                                        phi_18433_ = _e16250;
                                                    }
                                                    let _e8309 = phi_18433_;
                                                    phi_18434_ = _e8309;
                                                } else {
                                                    phi_18434_ = _e8054;
                                                }
                                                let _e8311 = phi_18434_;
                                                phi_18436_ = type_47(_e8232, _e8311, _e8102);
                                            } else {
                                                phi_18436_ = _e8111;
                                            }
                                            let _e8314 = phi_18436_;
                                            if (_e8314.member > _e8314.member_1) {
                                                phi_22229_ = bool();
                                                phi_22230_ = f32();
                                                phi_22231_ = f32();
                                                phi_22232_ = true;
                                                phi_22233_ = false;
                                                phi_22234_ = false;
                                                phi_22235_ = false;
                                            } else {
                                                let _e8321 = ((_e8314.member_1 - _e8314.member) * 0.5f);
                                                let _e8322 = (_e8314.member + _e8321);
                                                let _e8324 = (_e8321 + (0.000000059604645f * 4f));
                                                let _e8326 = local_18.member_3;
                                                let _e8329 = local_18.member[0u];
                                                if (_e8329[0] < 0f) {
                                                    phi_18465_ = -(_e8329[0]);
                                                } else {
                                                    phi_18465_ = _e8329[0];
                                                }
                                                let _e8336 = phi_18465_;
                                                if (_e8329[1] < 0f) {
                                                    phi_18472_ = -(_e8329[1]);
                                                } else {
                                                    phi_18472_ = _e8329[1];
                                                }
                                                let _e8340 = phi_18472_;
                                                if (_e8336 > _e8340) {
                                                    phi_18477_ = _e8336;
                                                } else {
                                                    phi_18477_ = _e8340;
                                                }
                                                let _e8343 = phi_18477_;
                                                if (_e8329[2] < 0f) {
                                                    phi_18484_ = -(_e8329[2]);
                                                } else {
                                                    phi_18484_ = _e8329[2];
                                                }
                                                let _e8347 = phi_18484_;
                                                if (_e8343 > _e8347) {
                                                    phi_18489_ = _e8343;
                                                } else {
                                                    phi_18489_ = _e8347;
                                                }
                                                let _e8350 = phi_18489_;
                                                let _e8352 = local_18.member[1u];
                                                if (_e8352[0] < 0f) {
                                                    phi_18502_ = -(_e8352[0]);
                                                } else {
                                                    phi_18502_ = _e8352[0];
                                                }
                                                let _e8359 = phi_18502_;
                                                if (_e8352[1] < 0f) {
                                                    phi_18509_ = -(_e8352[1]);
                                                } else {
                                                    phi_18509_ = _e8352[1];
                                                }
                                                let _e8363 = phi_18509_;
                                                if (_e8359 > _e8363) {
                                                    phi_18514_ = _e8359;
                                                } else {
                                                    phi_18514_ = _e8363;
                                                }
                                                let _e8366 = phi_18514_;
                                                if (_e8352[2] < 0f) {
                                                    phi_18521_ = -(_e8352[2]);
                                                } else {
                                                    phi_18521_ = _e8352[2];
                                                }
                                                let _e8370 = phi_18521_;
                                                if (_e8366 > _e8370) {
                                                    phi_18526_ = _e8366;
                                                } else {
                                                    phi_18526_ = _e8370;
                                                }
                                                let _e8373 = phi_18526_;
                                                if (_e8350 > _e8373) {
                                                    phi_18531_ = _e8350;
                                                } else {
                                                    phi_18531_ = _e8373;
                                                }
                                                let _e8376 = phi_18531_;
                                                let _e8379 = local_18.member[0u];
                                                let _e8384 = local_18.member[1u];
                                                let _e8394 = (_e8379[0] + ((_e8384[0] - _e8379[0]) * _e8322));
                                                let _e8395 = (_e8379[1] + ((_e8384[1] - _e8379[1]) * _e8322));
                                                let _e8396 = (_e8379[2] + ((_e8384[2] - _e8379[2]) * _e8322));
                                                let _e8398 = local_18.member[1u];
                                                let _e8403 = local_18.member[0u];
                                                let _e8407 = (_e8398[0] - _e8403[0]);
                                                let _e8408 = (_e8398[1] - _e8403[1]);
                                                let _e8409 = (_e8398[2] - _e8403[2]);
                                                if (_e8407 < 0f) {
                                                    phi_18590_ = -(_e8407);
                                                } else {
                                                    phi_18590_ = _e8407;
                                                }
                                                let _e8413 = phi_18590_;
                                                if (_e8408 < 0f) {
                                                    phi_18596_ = -(_e8408);
                                                } else {
                                                    phi_18596_ = _e8408;
                                                }
                                                let _e8417 = phi_18596_;
                                                if (_e8413 > _e8417) {
                                                    phi_18601_ = _e8413;
                                                } else {
                                                    phi_18601_ = _e8417;
                                                }
                                                let _e8420 = phi_18601_;
                                                if (_e8409 < 0f) {
                                                    phi_18607_ = -(_e8409);
                                                } else {
                                                    phi_18607_ = _e8409;
                                                }
                                                let _e8424 = phi_18607_;
                                                if (_e8420 > _e8424) {
                                                    phi_18612_ = _e8420;
                                                } else {
                                                    phi_18612_ = _e8424;
                                                }
                                                let _e8427 = phi_18612_;
                                                let _e8433 = ((((_e8324 * _e8427) * 1.01f) + ((_e8376 + _e8326) * (0.000000059604645f * 8f))) + _e8326);
                                                if (_e8394 < 0f) {
                                                    phi_18624_ = -(_e8394);
                                                } else {
                                                    phi_18624_ = _e8394;
                                                }
                                                let _e8437 = phi_18624_;
                                                if (_e8395 < 0f) {
                                                    phi_18630_ = -(_e8395);
                                                } else {
                                                    phi_18630_ = _e8395;
                                                }
                                                let _e8441 = phi_18630_;
                                                if (_e8437 > _e8441) {
                                                    phi_18635_ = _e8437;
                                                } else {
                                                    phi_18635_ = _e8441;
                                                }
                                                let _e8444 = phi_18635_;
                                                if (_e8396 < 0f) {
                                                    phi_18641_ = -(_e8396);
                                                } else {
                                                    phi_18641_ = _e8396;
                                                }
                                                let _e8448 = phi_18641_;
                                                if (_e8444 > _e8448) {
                                                    phi_18646_ = _e8444;
                                                } else {
                                                    phi_18646_ = _e8448;
                                                }
                                                let _e8451 = phi_18646_;
                                                local_2 = type_24(array<f32, 3>(_e8394, _e8395, _e8396), _e8433, (_e8451 + _e8433));
                                                let _e8457 = local_18.member_3;
                                                let _e8459 = local_18.member_1[0u];
                                                if (_e8459[0] < 0f) {
                                                    phi_18672_ = -(_e8459[0]);
                                                } else {
                                                    phi_18672_ = _e8459[0];
                                                }
                                                let _e8466 = phi_18672_;
                                                if (_e8459[1] < 0f) {
                                                    phi_18679_ = -(_e8459[1]);
                                                } else {
                                                    phi_18679_ = _e8459[1];
                                                }
                                                let _e8470 = phi_18679_;
                                                if (_e8466 > _e8470) {
                                                    phi_18684_ = _e8466;
                                                } else {
                                                    phi_18684_ = _e8470;
                                                }
                                                let _e8473 = phi_18684_;
                                                if (_e8459[2] < 0f) {
                                                    phi_18691_ = -(_e8459[2]);
                                                } else {
                                                    phi_18691_ = _e8459[2];
                                                }
                                                let _e8477 = phi_18691_;
                                                if (_e8473 > _e8477) {
                                                    phi_18696_ = _e8473;
                                                } else {
                                                    phi_18696_ = _e8477;
                                                }
                                                let _e8480 = phi_18696_;
                                                let _e8482 = local_18.member_1[1u];
                                                if (_e8482[0] < 0f) {
                                                    phi_18709_ = -(_e8482[0]);
                                                } else {
                                                    phi_18709_ = _e8482[0];
                                                }
                                                let _e8489 = phi_18709_;
                                                if (_e8482[1] < 0f) {
                                                    phi_18716_ = -(_e8482[1]);
                                                } else {
                                                    phi_18716_ = _e8482[1];
                                                }
                                                let _e8493 = phi_18716_;
                                                if (_e8489 > _e8493) {
                                                    phi_18721_ = _e8489;
                                                } else {
                                                    phi_18721_ = _e8493;
                                                }
                                                let _e8496 = phi_18721_;
                                                if (_e8482[2] < 0f) {
                                                    phi_18728_ = -(_e8482[2]);
                                                } else {
                                                    phi_18728_ = _e8482[2];
                                                }
                                                let _e8500 = phi_18728_;
                                                if (_e8496 > _e8500) {
                                                    phi_18733_ = _e8496;
                                                } else {
                                                    phi_18733_ = _e8500;
                                                }
                                                let _e8503 = phi_18733_;
                                                if (_e8480 > _e8503) {
                                                    phi_18738_ = _e8480;
                                                } else {
                                                    phi_18738_ = _e8503;
                                                }
                                                let _e8506 = phi_18738_;
                                                let _e8509 = local_18.member_1[0u];
                                                let _e8514 = local_18.member_1[1u];
                                                let _e8524 = (_e8509[0] + ((_e8514[0] - _e8509[0]) * _e8322));
                                                let _e8525 = (_e8509[1] + ((_e8514[1] - _e8509[1]) * _e8322));
                                                let _e8526 = (_e8509[2] + ((_e8514[2] - _e8509[2]) * _e8322));
                                                let _e8528 = local_18.member_1[1u];
                                                let _e8533 = local_18.member_1[0u];
                                                let _e8537 = (_e8528[0] - _e8533[0]);
                                                let _e8538 = (_e8528[1] - _e8533[1]);
                                                let _e8539 = (_e8528[2] - _e8533[2]);
                                                if (_e8537 < 0f) {
                                                    phi_18797_ = -(_e8537);
                                                } else {
                                                    phi_18797_ = _e8537;
                                                }
                                                let _e8543 = phi_18797_;
                                                if (_e8538 < 0f) {
                                                    phi_18803_ = -(_e8538);
                                                } else {
                                                    phi_18803_ = _e8538;
                                                }
                                                let _e8547 = phi_18803_;
                                                if (_e8543 > _e8547) {
                                                    phi_18808_ = _e8543;
                                                } else {
                                                    phi_18808_ = _e8547;
                                                }
                                                let _e8550 = phi_18808_;
                                                if (_e8539 < 0f) {
                                                    phi_18814_ = -(_e8539);
                                                } else {
                                                    phi_18814_ = _e8539;
                                                }
                                                let _e8554 = phi_18814_;
                                                if (_e8550 > _e8554) {
                                                    phi_18819_ = _e8550;
                                                } else {
                                                    phi_18819_ = _e8554;
                                                }
                                                let _e8557 = phi_18819_;
                                                let _e8563 = ((((_e8324 * _e8557) * 1.01f) + ((_e8506 + _e8457) * (0.000000059604645f * 8f))) + _e8457);
                                                if (_e8524 < 0f) {
                                                    phi_18831_ = -(_e8524);
                                                } else {
                                                    phi_18831_ = _e8524;
                                                }
                                                let _e8567 = phi_18831_;
                                                if (_e8525 < 0f) {
                                                    phi_18837_ = -(_e8525);
                                                } else {
                                                    phi_18837_ = _e8525;
                                                }
                                                let _e8571 = phi_18837_;
                                                if (_e8567 > _e8571) {
                                                    phi_18842_ = _e8567;
                                                } else {
                                                    phi_18842_ = _e8571;
                                                }
                                                let _e8574 = phi_18842_;
                                                if (_e8526 < 0f) {
                                                    phi_18848_ = -(_e8526);
                                                } else {
                                                    phi_18848_ = _e8526;
                                                }
                                                let _e8578 = phi_18848_;
                                                if (_e8574 > _e8578) {
                                                    phi_18853_ = _e8574;
                                                } else {
                                                    phi_18853_ = _e8578;
                                                }
                                                let _e8581 = phi_18853_;
                                                local_3 = type_24(array<f32, 3>(_e8524, _e8525, _e8526), _e8563, (_e8581 + _e8563));
                                                let _e8587 = local_18.member_3;
                                                let _e8589 = local_18.member_2[0u];
                                                if (_e8589[0] < 0f) {
                                                    phi_18879_ = -(_e8589[0]);
                                                } else {
                                                    phi_18879_ = _e8589[0];
                                                }
                                                let _e8596 = phi_18879_;
                                                if (_e8589[1] < 0f) {
                                                    phi_18886_ = -(_e8589[1]);
                                                } else {
                                                    phi_18886_ = _e8589[1];
                                                }
                                                let _e8600 = phi_18886_;
                                                if (_e8596 > _e8600) {
                                                    phi_18891_ = _e8596;
                                                } else {
                                                    phi_18891_ = _e8600;
                                                }
                                                let _e8603 = phi_18891_;
                                                if (_e8589[2] < 0f) {
                                                    phi_18898_ = -(_e8589[2]);
                                                } else {
                                                    phi_18898_ = _e8589[2];
                                                }
                                                let _e8607 = phi_18898_;
                                                if (_e8603 > _e8607) {
                                                    phi_18903_ = _e8603;
                                                } else {
                                                    phi_18903_ = _e8607;
                                                }
                                                let _e8610 = phi_18903_;
                                                let _e8612 = local_18.member_2[1u];
                                                if (_e8612[0] < 0f) {
                                                    phi_18916_ = -(_e8612[0]);
                                                } else {
                                                    phi_18916_ = _e8612[0];
                                                }
                                                let _e8619 = phi_18916_;
                                                if (_e8612[1] < 0f) {
                                                    phi_18923_ = -(_e8612[1]);
                                                } else {
                                                    phi_18923_ = _e8612[1];
                                                }
                                                let _e8623 = phi_18923_;
                                                if (_e8619 > _e8623) {
                                                    phi_18928_ = _e8619;
                                                } else {
                                                    phi_18928_ = _e8623;
                                                }
                                                let _e8626 = phi_18928_;
                                                if (_e8612[2] < 0f) {
                                                    phi_18935_ = -(_e8612[2]);
                                                } else {
                                                    phi_18935_ = _e8612[2];
                                                }
                                                let _e8630 = phi_18935_;
                                                if (_e8626 > _e8630) {
                                                    phi_18940_ = _e8626;
                                                } else {
                                                    phi_18940_ = _e8630;
                                                }
                                                let _e8633 = phi_18940_;
                                                if (_e8610 > _e8633) {
                                                    phi_18945_ = _e8610;
                                                } else {
                                                    phi_18945_ = _e8633;
                                                }
                                                let _e8636 = phi_18945_;
                                                let _e8639 = local_18.member_2[0u];
                                                let _e8644 = local_18.member_2[1u];
                                                let _e8654 = (_e8639[0] + ((_e8644[0] - _e8639[0]) * _e8322));
                                                let _e8655 = (_e8639[1] + ((_e8644[1] - _e8639[1]) * _e8322));
                                                let _e8656 = (_e8639[2] + ((_e8644[2] - _e8639[2]) * _e8322));
                                                let _e8658 = local_18.member_2[1u];
                                                let _e8663 = local_18.member_2[0u];
                                                let _e8667 = (_e8658[0] - _e8663[0]);
                                                let _e8668 = (_e8658[1] - _e8663[1]);
                                                let _e8669 = (_e8658[2] - _e8663[2]);
                                                if (_e8667 < 0f) {
                                                    phi_19004_ = -(_e8667);
                                                } else {
                                                    phi_19004_ = _e8667;
                                                }
                                                let _e8673 = phi_19004_;
                                                if (_e8668 < 0f) {
                                                    phi_19010_ = -(_e8668);
                                                } else {
                                                    phi_19010_ = _e8668;
                                                }
                                                let _e8677 = phi_19010_;
                                                if (_e8673 > _e8677) {
                                                    phi_19015_ = _e8673;
                                                } else {
                                                    phi_19015_ = _e8677;
                                                }
                                                let _e8680 = phi_19015_;
                                                if (_e8669 < 0f) {
                                                    phi_19021_ = -(_e8669);
                                                } else {
                                                    phi_19021_ = _e8669;
                                                }
                                                let _e8684 = phi_19021_;
                                                if (_e8680 > _e8684) {
                                                    phi_19026_ = _e8680;
                                                } else {
                                                    phi_19026_ = _e8684;
                                                }
                                                let _e8687 = phi_19026_;
                                                let _e8693 = ((((_e8324 * _e8687) * 1.01f) + ((_e8636 + _e8587) * (0.000000059604645f * 8f))) + _e8587);
                                                if (_e8654 < 0f) {
                                                    phi_19038_ = -(_e8654);
                                                } else {
                                                    phi_19038_ = _e8654;
                                                }
                                                let _e8697 = phi_19038_;
                                                if (_e8655 < 0f) {
                                                    phi_19044_ = -(_e8655);
                                                } else {
                                                    phi_19044_ = _e8655;
                                                }
                                                let _e8701 = phi_19044_;
                                                if (_e8697 > _e8701) {
                                                    phi_19049_ = _e8697;
                                                } else {
                                                    phi_19049_ = _e8701;
                                                }
                                                let _e8704 = phi_19049_;
                                                if (_e8656 < 0f) {
                                                    phi_19055_ = -(_e8656);
                                                } else {
                                                    phi_19055_ = _e8656;
                                                }
                                                let _e8708 = phi_19055_;
                                                if (_e8704 > _e8708) {
                                                    phi_19060_ = _e8704;
                                                } else {
                                                    phi_19060_ = _e8708;
                                                }
                                                let _e8711 = phi_19060_;
                                                local_4 = type_24(array<f32, 3>(_e8654, _e8655, _e8656), _e8693, (_e8711 + _e8693));
                                                let _e8716 = local_3.member;
                                                let _e8721 = local_4.member;
                                                let _e8727 = ((_e8716[1] * _e8721[2]) - (_e8716[2] * _e8721[1]));
                                                let _e8730 = ((_e8716[2] * _e8721[0]) - (_e8716[0] * _e8721[2]));
                                                let _e8733 = ((_e8716[0] * _e8721[1]) - (_e8716[1] * _e8721[0]));
                                                if (_e8727 < 0f) {
                                                    phi_19109_ = -(_e8727);
                                                } else {
                                                    phi_19109_ = _e8727;
                                                }
                                                let _e8737 = phi_19109_;
                                                if (_e8730 < 0f) {
                                                    phi_19115_ = -(_e8730);
                                                } else {
                                                    phi_19115_ = _e8730;
                                                }
                                                let _e8741 = phi_19115_;
                                                if (_e8737 > _e8741) {
                                                    if (_e8727 < 0f) {
                                                        phi_19125_ = -(_e8727);
                                                    } else {
                                                        phi_19125_ = _e8727;
                                                    }
                                                    let _e8759 = phi_19125_;
                                                    if (_e8733 < 0f) {
                                                        phi_19131_ = -(_e8733);
                                                    } else {
                                                        phi_19131_ = _e8733;
                                                    }
                                                    let _e8763 = phi_19131_;
                                                    if (_e8759 > _e8763) {
                                                        phi_19136_ = 2u;
                                                        phi_19137_ = 1u;
                                                    } else {
                                                        phi_19136_ = 1u;
                                                        phi_19137_ = 0u;
                                                    }
                                                    let _e8766 = phi_19136_;
                                                    let _e8768 = phi_19137_;
                                                    phi_19156_ = _e8766;
                                                    phi_19157_ = _e8768;
                                                } else {
                                                    if (_e8730 < 0f) {
                                                        phi_19143_ = -(_e8730);
                                                    } else {
                                                        phi_19143_ = _e8730;
                                                    }
                                                    let _e8746 = phi_19143_;
                                                    if (_e8733 < 0f) {
                                                        phi_19149_ = -(_e8733);
                                                    } else {
                                                        phi_19149_ = _e8733;
                                                    }
                                                    let _e8750 = phi_19149_;
                                                    if (_e8746 > _e8750) {
                                                        phi_19154_ = 0u;
                                                        phi_19155_ = 2u;
                                                    } else {
                                                        phi_19154_ = 1u;
                                                        phi_19155_ = 0u;
                                                    }
                                                    let _e8753 = phi_19154_;
                                                    let _e8755 = phi_19155_;
                                                    phi_19156_ = _e8753;
                                                    phi_19157_ = _e8755;
                                                }
                                                let _e8770 = phi_19156_;
                                                let _e8772 = phi_19157_;
                                                let _e8775 = local_3.member[_e8772];
                                                let _e8778 = local_4.member[_e8770];
                                                let _e8782 = local_3.member[_e8770];
                                                let _e8785 = local_4.member[_e8772];
                                                let _e8787 = ((_e8775 * _e8778) - (_e8782 * _e8785));
                                                let _e8789 = local_3.member_1;
                                                let _e8791 = local_4.member_2;
                                                let _e8794 = local_3.member_2;
                                                let _e8796 = local_4.member_1;
                                                let _e8801 = local_3.member_2;
                                                let _e8804 = local_4.member_2;
                                                let _e8812 = local_3.member_2;
                                                let _e8815 = local_4.member_2;
                                                let _e8819 = (((((_e8789 * _e8791) + (_e8794 * _e8796)) * 2.01f) + (((_e8801 * 2f) * (_e8804 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e8812) * (1f + _e8815))));
                                                if (_e8787 < 0f) {
                                                    phi_19226_ = -(_e8787);
                                                } else {
                                                    phi_19226_ = _e8787;
                                                }
                                                let _e8823 = phi_19226_;
                                                if (_e8823 > _e8819) {
                                                    if (_e8787 < 0f) {
                                                        phi_19235_ = -1f;
                                                    } else {
                                                        phi_19235_ = 1f;
                                                    }
                                                    let _e8827 = phi_19235_;
                                                    let _e8830 = local_2.member[_e8772];
                                                    let _e8833 = local_4.member[_e8770];
                                                    let _e8837 = local_2.member[_e8770];
                                                    let _e8840 = local_4.member[_e8772];
                                                    let _e8844 = local_2.member_1;
                                                    let _e8846 = local_4.member_2;
                                                    let _e8849 = local_2.member_2;
                                                    let _e8851 = local_4.member_1;
                                                    let _e8856 = local_2.member_2;
                                                    let _e8859 = local_4.member_2;
                                                    let _e8867 = local_2.member_2;
                                                    let _e8870 = local_4.member_2;
                                                    let _e8874 = (((((_e8844 * _e8846) + (_e8849 * _e8851)) * 2.01f) + (((_e8856 * 2f) * (_e8859 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e8867) * (1f + _e8870))));
                                                    let _e8877 = local_3.member[_e8772];
                                                    let _e8880 = local_2.member[_e8770];
                                                    let _e8884 = local_3.member[_e8770];
                                                    let _e8887 = local_2.member[_e8772];
                                                    let _e8891 = local_3.member_1;
                                                    let _e8893 = local_2.member_2;
                                                    let _e8896 = local_3.member_2;
                                                    let _e8898 = local_2.member_1;
                                                    let _e8903 = local_3.member_2;
                                                    let _e8906 = local_2.member_2;
                                                    let _e8914 = local_3.member_2;
                                                    let _e8917 = local_2.member_2;
                                                    let _e8921 = (((((_e8891 * _e8893) + (_e8896 * _e8898)) * 2.01f) + (((_e8903 * 2f) * (_e8906 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e8914) * (1f + _e8917))));
                                                    let _e8922 = (_e8787 * _e8827);
                                                    let _e8923 = (((_e8830 * _e8833) - (_e8837 * _e8840)) * _e8827);
                                                    let _e8924 = (((_e8877 * _e8880) - (_e8884 * _e8887)) * _e8827);
                                                    if (_e8922 < 0f) {
                                                        phi_19370_ = -(_e8922);
                                                    } else {
                                                        phi_19370_ = _e8922;
                                                    }
                                                    let _e8928 = phi_19370_;
                                                    if (_e8923 < 0f) {
                                                        phi_19376_ = -(_e8923);
                                                    } else {
                                                        phi_19376_ = _e8923;
                                                    }
                                                    let _e8932 = phi_19376_;
                                                    if (_e8924 < 0f) {
                                                        phi_19383_ = -(_e8924);
                                                    } else {
                                                        phi_19383_ = _e8924;
                                                    }
                                                    let _e8937 = phi_19383_;
                                                    let _e8940 = (((_e8928 + _e8932) + _e8937) * (0.000000059604645f * 4f));
                                                    if (_e315.member != 0u) {
                                                        phi_19418_ = array<type_26, 4>(type_26(_e8923, _e8874), type_26(_e8924, _e8921), type_26((_e8922 - _e8923), ((_e8819 + _e8874) + _e8940)), type_26((_e8922 - _e8924), ((_e8819 + _e8921) + _e8940)));
                                                    } else {
                                                        let _e8943 = ((_e8922 - _e8923) - _e8924);
                                                        let _e8946 = (((_e8819 + _e8874) + _e8921) + _e8940);
                                                        phi_19418_ = array<type_26, 4>(type_26(_e8923, _e8874), type_26(_e8924, _e8921), type_26(_e8943, _e8946), type_26(_e8943, _e8946));
                                                    }
                                                    let _e8964 = phi_19418_;
                                                    local_5 = array<type_26, 4>(type_26(_e8964[0].member, _e8964[0].member_1), type_26(_e8964[1].member, _e8964[1].member_1), type_26(_e8964[2].member, _e8964[2].member_1), type_26(_e8964[3].member, _e8964[3].member_1));
                                                    phi_19438_ = type_9(0u, 4u);
                                                    phi_19441_ = true;
                                                    loop {
                                                        let _e8983 = phi_19438_;
                                                        let _e8985 = phi_19441_;
                                                        local_93 = _e8985;
                                                        if (_e8983.member < _e8983.member_1) {
                                                            phi_19439_ = type_9((_e8983.member + 1u), _e8983.member_1);
                                                            phi_19464_ = type_9(1u, _e8983.member);
                                                        } else {
                                                            phi_19439_ = _e8983;
                                                            phi_19464_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e8997 = phi_19439_;
                                                        let _e8999 = phi_19464_;
                                                        if (bitcast<i32>(_e8999.member) != 0i) {
                                                            let _e9006 = local_5[_e8999.member_1].member;
                                                            let _e9009 = local_5[_e8999.member_1].member_1;
                                                            let _e9011 = (_e9006 < -(_e9009));
                                                            if _e9011 {
                                                                phi_19491_ = bool();
                                                                phi_19492_ = false;
                                                            } else {
                                                                phi_19491_ = (_e8985 && (_e9006 > _e9009));
                                                                phi_19492_ = true;
                                                            }
                                                            let _e9015 = phi_19491_;
                                                            let _e9017 = phi_19492_;
                                                            phi_19442_ = _e9015;
                                                            phi_19493_ = _e9017;
                                                            phi_19494_ = _e9011;
                                                        } else {
                                                            phi_19442_ = bool();
                                                            phi_19493_ = false;
                                                            phi_19494_ = false;
                                                        }
                                                        let _e9019 = phi_19442_;
                                                        let _e9021 = phi_19493_;
                                                        let _e9023 = phi_19494_;
                                                        local_92 = _e9023;
                                                        continue;
                                                        continuing {
                                                            phi_19438_ = _e8997;
                                                            phi_19441_ = _e9019;
                                                            break if !(_e9021);
                                                        }
                                                    }
                                                    let _e9026 = local_92;
                                                    if _e9026 {
                                                        phi_19498_ = false;
                                                    } else {
                                                        phi_19498_ = true;
                                                    }
                                                    let _e9028 = phi_19498_;
                                                    if _e9028 {
                                                        let _e9030 = local_93;
                                                        if _e9030 {
                                                            phi_19505_ = 1u;
                                                        } else {
                                                            phi_19505_ = 2u;
                                                        }
                                                        let _e9032 = phi_19505_;
                                                        phi_19506_ = _e9032;
                                                        phi_19507_ = false;
                                                    } else {
                                                        phi_19506_ = u32();
                                                        phi_19507_ = true;
                                                    }
                                                    let _e9034 = phi_19506_;
                                                    let _e9036 = phi_19507_;
                                                    phi_19508_ = _e9034;
                                                    phi_19509_ = 0u;
                                                    phi_19510_ = _e9036;
                                                } else {
                                                    phi_19508_ = u32();
                                                    phi_19509_ = 2u;
                                                    phi_19510_ = true;
                                                }
                                                let _e9038 = phi_19508_;
                                                let _e9040 = phi_19509_;
                                                let _e9042 = phi_19510_;
                                                if _e9042 {
                                                    phi_19514_ = _e9040;
                                                } else {
                                                    phi_19514_ = _e9038;
                                                }
                                                let _e9044 = phi_19514_;
                                                let _e9045 = (_e9044 == 0u);
                                                if _e9045 {
                                                    phi_22223_ = bool();
                                                    phi_22224_ = f32();
                                                    phi_22225_ = f32();
                                                    phi_22226_ = false;
                                                    phi_22227_ = false;
                                                    phi_22228_ = false;
                                                } else {
                                                    if (_e9044 == 1u) {
                                                        phi_19524_ = _e8314.member_2;
                                                    } else {
                                                        phi_19524_ = false;
                                                    }
                                                    let _e9049 = phi_19524_;
                                                    let _e9050 = (_e5595 * 0.99f);
                                                    if _e9049 {
                                                        if ((_e8314.member_1 - _e8314.member) <= _e9050) {
                                                            phi_19536_ = false;
                                                        } else {
                                                            phi_19536_ = true;
                                                        }
                                                        let _e9056 = phi_19536_;
                                                        phi_19537_ = _e9056;
                                                    } else {
                                                        phi_19537_ = true;
                                                    }
                                                    let _e9058 = phi_19537_;
                                                    if _e9058 {
                                                        let _e9063 = local_18.member[0u];
                                                        let _e9070 = local_18.member_1[0u];
                                                        let _e9076 = local_18.member_2[0u];
                                                        let _e9080 = (_e9063[0] - _e9070[0]);
                                                        let _e9081 = (_e9063[1] - _e9070[1]);
                                                        let _e9082 = (_e9063[2] - _e9070[2]);
                                                        if (_e315.member == 0u) {
                                                            phi_19598_ = array<f32, 3>(_e9063[0], _e9063[1], _e9063[2]);
                                                        } else {
                                                            phi_19598_ = array<f32, 3>((_e9080 - _e9076[0]), (_e9081 - _e9076[1]), (_e9082 - _e9076[2]));
                                                        }
                                                        let _e9089 = phi_19598_;
                                                        let _e9095 = local_18.member[1u];
                                                        let _e9102 = local_18.member_1[1u];
                                                        let _e9108 = local_18.member_2[1u];
                                                        let _e9112 = (_e9095[0] - _e9102[0]);
                                                        let _e9113 = (_e9095[1] - _e9102[1]);
                                                        let _e9114 = (_e9095[2] - _e9102[2]);
                                                        if (_e315.member == 0u) {
                                                            phi_19663_ = array<f32, 3>(_e9095[0], _e9095[1], _e9095[2]);
                                                        } else {
                                                            phi_19663_ = array<f32, 3>((_e9112 - _e9108[0]), (_e9113 - _e9108[1]), (_e9114 - _e9108[2]));
                                                        }
                                                        let _e9121 = phi_19663_;
                                                        let _e9127 = local_18.member[0u];
                                                        if (_e9127[0] < 0f) {
                                                            phi_19685_ = -(_e9127[0]);
                                                        } else {
                                                            phi_19685_ = _e9127[0];
                                                        }
                                                        let _e9134 = phi_19685_;
                                                        if (_e9127[1] < 0f) {
                                                            phi_19692_ = -(_e9127[1]);
                                                        } else {
                                                            phi_19692_ = _e9127[1];
                                                        }
                                                        let _e9138 = phi_19692_;
                                                        if (_e9134 > _e9138) {
                                                            phi_19697_ = _e9134;
                                                        } else {
                                                            phi_19697_ = _e9138;
                                                        }
                                                        let _e9141 = phi_19697_;
                                                        if (_e9127[2] < 0f) {
                                                            phi_19704_ = -(_e9127[2]);
                                                        } else {
                                                            phi_19704_ = _e9127[2];
                                                        }
                                                        let _e9145 = phi_19704_;
                                                        if (_e9141 > _e9145) {
                                                            phi_19709_ = _e9141;
                                                        } else {
                                                            phi_19709_ = _e9145;
                                                        }
                                                        let _e9148 = phi_19709_;
                                                        let _e9151 = local_18.member[1u];
                                                        if (_e9151[0] < 0f) {
                                                            phi_19722_ = -(_e9151[0]);
                                                        } else {
                                                            phi_19722_ = _e9151[0];
                                                        }
                                                        let _e9158 = phi_19722_;
                                                        if (_e9151[1] < 0f) {
                                                            phi_19729_ = -(_e9151[1]);
                                                        } else {
                                                            phi_19729_ = _e9151[1];
                                                        }
                                                        let _e9162 = phi_19729_;
                                                        if (_e9158 > _e9162) {
                                                            phi_19734_ = _e9158;
                                                        } else {
                                                            phi_19734_ = _e9162;
                                                        }
                                                        let _e9165 = phi_19734_;
                                                        if (_e9151[2] < 0f) {
                                                            phi_19741_ = -(_e9151[2]);
                                                        } else {
                                                            phi_19741_ = _e9151[2];
                                                        }
                                                        let _e9169 = phi_19741_;
                                                        if (_e9165 > _e9169) {
                                                            phi_19746_ = _e9165;
                                                        } else {
                                                            phi_19746_ = _e9169;
                                                        }
                                                        let _e9172 = phi_19746_;
                                                        if (_e9148 > _e9172) {
                                                            phi_19751_ = _e9148;
                                                        } else {
                                                            phi_19751_ = _e9172;
                                                        }
                                                        let _e9175 = phi_19751_;
                                                        let _e9177 = local_18.member_3;
                                                        let _e9181 = local_18.member_1[0u];
                                                        if (_e9181[0] < 0f) {
                                                            phi_19768_ = -(_e9181[0]);
                                                        } else {
                                                            phi_19768_ = _e9181[0];
                                                        }
                                                        let _e9188 = phi_19768_;
                                                        if (_e9181[1] < 0f) {
                                                            phi_19775_ = -(_e9181[1]);
                                                        } else {
                                                            phi_19775_ = _e9181[1];
                                                        }
                                                        let _e9192 = phi_19775_;
                                                        if (_e9188 > _e9192) {
                                                            phi_19780_ = _e9188;
                                                        } else {
                                                            phi_19780_ = _e9192;
                                                        }
                                                        let _e9195 = phi_19780_;
                                                        if (_e9181[2] < 0f) {
                                                            phi_19787_ = -(_e9181[2]);
                                                        } else {
                                                            phi_19787_ = _e9181[2];
                                                        }
                                                        let _e9199 = phi_19787_;
                                                        if (_e9195 > _e9199) {
                                                            phi_19792_ = _e9195;
                                                        } else {
                                                            phi_19792_ = _e9199;
                                                        }
                                                        let _e9202 = phi_19792_;
                                                        let _e9205 = local_18.member_1[1u];
                                                        if (_e9205[0] < 0f) {
                                                            phi_19806_ = -(_e9205[0]);
                                                        } else {
                                                            phi_19806_ = _e9205[0];
                                                        }
                                                        let _e9212 = phi_19806_;
                                                        if (_e9205[1] < 0f) {
                                                            phi_19813_ = -(_e9205[1]);
                                                        } else {
                                                            phi_19813_ = _e9205[1];
                                                        }
                                                        let _e9216 = phi_19813_;
                                                        if (_e9212 > _e9216) {
                                                            phi_19818_ = _e9212;
                                                        } else {
                                                            phi_19818_ = _e9216;
                                                        }
                                                        let _e9219 = phi_19818_;
                                                        if (_e9205[2] < 0f) {
                                                            phi_19825_ = -(_e9205[2]);
                                                        } else {
                                                            phi_19825_ = _e9205[2];
                                                        }
                                                        let _e9223 = phi_19825_;
                                                        if (_e9219 > _e9223) {
                                                            phi_19830_ = _e9219;
                                                        } else {
                                                            phi_19830_ = _e9223;
                                                        }
                                                        let _e9226 = phi_19830_;
                                                        if (_e9202 > _e9226) {
                                                            phi_19835_ = _e9202;
                                                        } else {
                                                            phi_19835_ = _e9226;
                                                        }
                                                        let _e9229 = phi_19835_;
                                                        let _e9231 = local_18.member_3;
                                                        let _e9235 = local_18.member_2[0u];
                                                        if (_e9235[0] < 0f) {
                                                            phi_19852_ = -(_e9235[0]);
                                                        } else {
                                                            phi_19852_ = _e9235[0];
                                                        }
                                                        let _e9242 = phi_19852_;
                                                        if (_e9235[1] < 0f) {
                                                            phi_19859_ = -(_e9235[1]);
                                                        } else {
                                                            phi_19859_ = _e9235[1];
                                                        }
                                                        let _e9246 = phi_19859_;
                                                        if (_e9242 > _e9246) {
                                                            phi_19864_ = _e9242;
                                                        } else {
                                                            phi_19864_ = _e9246;
                                                        }
                                                        let _e9249 = phi_19864_;
                                                        if (_e9235[2] < 0f) {
                                                            phi_19871_ = -(_e9235[2]);
                                                        } else {
                                                            phi_19871_ = _e9235[2];
                                                        }
                                                        let _e9253 = phi_19871_;
                                                        if (_e9249 > _e9253) {
                                                            phi_19876_ = _e9249;
                                                        } else {
                                                            phi_19876_ = _e9253;
                                                        }
                                                        let _e9256 = phi_19876_;
                                                        let _e9259 = local_18.member_2[1u];
                                                        if (_e9259[0] < 0f) {
                                                            phi_19890_ = -(_e9259[0]);
                                                        } else {
                                                            phi_19890_ = _e9259[0];
                                                        }
                                                        let _e9266 = phi_19890_;
                                                        if (_e9259[1] < 0f) {
                                                            phi_19897_ = -(_e9259[1]);
                                                        } else {
                                                            phi_19897_ = _e9259[1];
                                                        }
                                                        let _e9270 = phi_19897_;
                                                        if (_e9266 > _e9270) {
                                                            phi_19902_ = _e9266;
                                                        } else {
                                                            phi_19902_ = _e9270;
                                                        }
                                                        let _e9273 = phi_19902_;
                                                        if (_e9259[2] < 0f) {
                                                            phi_19909_ = -(_e9259[2]);
                                                        } else {
                                                            phi_19909_ = _e9259[2];
                                                        }
                                                        let _e9277 = phi_19909_;
                                                        if (_e9273 > _e9277) {
                                                            phi_19914_ = _e9273;
                                                        } else {
                                                            phi_19914_ = _e9277;
                                                        }
                                                        let _e9280 = phi_19914_;
                                                        if (_e9256 > _e9280) {
                                                            phi_19919_ = _e9256;
                                                        } else {
                                                            phi_19919_ = _e9280;
                                                        }
                                                        let _e9283 = phi_19919_;
                                                        let _e9285 = local_18.member_3;
                                                        let _e9292 = local_18.member_3;
                                                        let _e9297 = (_e5595 * 0.00390625f);
                                                        local = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                        phi_19960_ = type_9(0u, 96u);
                                                        phi_19963_ = _e8314.member;
                                                        phi_19965_ = _e8314.member;
                                                        phi_19967_ = (_e8314.member_1 - _e8314.member);
                                                        phi_19969_ = _e8314.member;
                                                        phi_19971_ = false;
                                                        phi_19973_ = 0u;
                                                        loop {
                                                            let _e9300 = phi_19960_;
                                                            let _e9302 = phi_19963_;
                                                            let _e9304 = phi_19965_;
                                                            let _e9306 = phi_19967_;
                                                            let _e9308 = phi_19969_;
                                                            let _e9310 = phi_19971_;
                                                            let _e9312 = phi_19973_;
                                                            local_96 = _e9302;
                                                            local_146 = _e9304;
                                                            if (_e9300.member < _e9300.member_1) {
                                                                phi_19961_ = type_9((_e9300.member + 1u), _e9300.member_1);
                                                                phi_19996_ = type_9(1u, _e9300.member);
                                                            } else {
                                                                phi_19961_ = _e9300;
                                                                phi_19996_ = type_9(0u, type_9().member_1);
                                                            }
                                                            let _e9324 = phi_19961_;
                                                            let _e9326 = phi_19996_;
                                                            if (bitcast<i32>(_e9326.member) != 0i) {
                                                                let _e9332 = local_18.member[0u];
                                                                let _e9338 = local_18.member[1u];
                                                                let _e9354 = local_18.member_1[0u];
                                                                let _e9360 = local_18.member_1[1u];
                                                                let _e9376 = local_18.member_2[0u];
                                                                let _e9382 = local_18.member_2[1u];
                                                                let _e9396 = function_3(array<f32, 3>((_e9332[0] + ((_e9338[0] - _e9332[0]) * _e9302)), (_e9332[1] + ((_e9338[1] - _e9332[1]) * _e9302)), (_e9332[2] + ((_e9338[2] - _e9332[2]) * _e9302))), array<f32, 3>((_e9354[0] + ((_e9360[0] - _e9354[0]) * _e9302)), (_e9354[1] + ((_e9360[1] - _e9354[1]) * _e9302)), (_e9354[2] + ((_e9360[2] - _e9354[2]) * _e9302))), array<f32, 3>((_e9376[0] + ((_e9382[0] - _e9376[0]) * _e9302)), (_e9376[1] + ((_e9382[1] - _e9376[1]) * _e9302)), (_e9376[2] + ((_e9382[2] - _e9376[2]) * _e9302))), _e315.member);
                                                                if (_e9312 == 0u) {
                                                                    phi_20124_ = _e9396;
                                                                } else {
                                                                    if (_e9312 == 1u) {
                                                                        phi_20110_ = _e9396[0];
                                                                    } else {
                                                                        phi_20110_ = 0f;
                                                                    }
                                                                    let _e9401 = phi_20110_;
                                                                    if (_e9312 == 2u) {
                                                                        phi_20116_ = _e9396[1];
                                                                    } else {
                                                                        phi_20116_ = 0f;
                                                                    }
                                                                    let _e9405 = phi_20116_;
                                                                    if (_e9312 == 3u) {
                                                                        phi_20122_ = _e9396[2];
                                                                    } else {
                                                                        phi_20122_ = 0f;
                                                                    }
                                                                    let _e9409 = phi_20122_;
                                                                    phi_20124_ = array<f32, 3>(_e9401, _e9405, _e9409);
                                                                }
                                                                let _e9412 = phi_20124_;
                                                                if (_e9412[0] < 0f) {
                                                                    phi_20131_ = -(_e9412[0]);
                                                                } else {
                                                                    phi_20131_ = _e9412[0];
                                                                }
                                                                let _e9417 = phi_20131_;
                                                                if (_e9412[1] < 0f) {
                                                                    phi_20138_ = -(_e9412[1]);
                                                                } else {
                                                                    phi_20138_ = _e9412[1];
                                                                }
                                                                let _e9422 = phi_20138_;
                                                                if (_e9412[2] < 0f) {
                                                                    phi_20146_ = -(_e9412[2]);
                                                                } else {
                                                                    phi_20146_ = _e9412[2];
                                                                }
                                                                let _e9428 = phi_20146_;
                                                                let _e9429 = ((_e9417 + _e9422) + _e9428);
                                                                if (_e9429 > 0f) {
                                                                    if ((bitcast<u32>(_e9429) & 2139095040u) != 2139095040u) {
                                                                        let _e9434 = (1f / _e9429);
                                                                        let _e9436 = (_e9412[0] * _e9434);
                                                                        let _e9438 = (_e9412[1] * _e9434);
                                                                        let _e9440 = (_e9412[2] * _e9434);
                                                                        let _e9445 = (((_e9436 * _e9436) + (_e9438 * _e9438)) + (_e9440 * _e9440));
                                                                        if (_e9445 <= 0.000000000000000000000000000000000000011754944f) {
                                                                            if (_e9445 > 0f) {
                                                                                phi_20183_ = (0.000000000000000000106433627f * 2f);
                                                                            } else {
                                                                                phi_20183_ = 0f;
                                                                            }
                                                                            let _e9498 = phi_20183_;
                                                                            phi_20247_ = _e9498;
                                                                        } else {
                                                                            phi_20190_ = type_14(0i, 5i);
                                                                            phi_20193_ = bitcast<f32>(((bitcast<u32>(_e9445) >> bitcast<u32>(1i)) + 532369198u));
                                                                            loop {
                                                                                let _e9453 = phi_20190_;
                                                                                let _e9455 = phi_20193_;
                                                                                local_94 = _e9455;
                                                                                if (_e9453.member < _e9453.member_1) {
                                                                                    let _e9462 = (_e9453.member + 1i);
                                                                                    if ((false == (_e9462 > _e9453.member)) != false) {
                                                                                        phi_20214_ = true;
                                                                                    } else {
                                                                                        phi_20214_ = false;
                                                                                    }
                                                                                    let _e9467 = phi_20214_;
                                                                                    if _e9467 {
                                                                                        phi_20220_ = type_15(0u, type_15().member_1);
                                                                                    } else {
                                                                                        phi_20220_ = type_15(1u, _e9462);
                                                                                    }
                                                                                    let _e9472 = phi_20220_;
                                                                                    phi_20191_ = type_14(_e9472.member_1, _e9453.member_1);
                                                                                    phi_20234_ = type_15(1u, _e9453.member);
                                                                                } else {
                                                                                    phi_20191_ = _e9453;
                                                                                    phi_20234_ = type_15(0u, type_15().member_1);
                                                                                }
                                                                                let _e9478 = phi_20191_;
                                                                                let _e9480 = phi_20234_;
                                                                                let _e9483 = (bitcast<i32>(_e9480.member) != 0i);
                                                                                if _e9483 {
                                                                                    phi_20194_ = (0.5f * (_e9455 + (_e9445 / _e9455)));
                                                                                } else {
                                                                                    phi_20194_ = f32();
                                                                                }
                                                                                let _e9488 = phi_20194_;
                                                                                continue;
                                                                                continuing {
                                                                                    phi_20190_ = _e9478;
                                                                                    phi_20193_ = _e9488;
                                                                                    break if !(_e9483);
                                                                                }
                                                                            }
                                                                            let _e9493 = local_94;
                                                                            phi_20247_ = (_e9493 * (1f + (8f * 0.000000059604645f)));
                                                                        }
                                                                        let _e9500 = phi_20247_;
                                                                        let _e9501 = (0.000000059604645f * 12f);
                                                                        let _e9506 = ((((((((_e9175 + _e9177) + (_e9229 + _e9231)) + (_e9283 + _e9285)) * (0.000000059604645f * 16f)) + (_e9292 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e9500) * (1f + _e9501)));
                                                                        let _e9511 = (((_e9436 * _e9063[0]) + (_e9438 * _e9063[1])) + (_e9440 * _e9063[2]));
                                                                        let _e9516 = (((_e9436 * _e9080) + (_e9438 * _e9081)) + (_e9440 * _e9082));
                                                                        let _e9521 = (((_e9436 * (_e9063[0] - _e9076[0])) + (_e9438 * (_e9063[1] - _e9076[1]))) + (_e9440 * (_e9063[2] - _e9076[2])));
                                                                        let _e9529 = (((_e9436 * _e9089[0]) + (_e9438 * _e9089[1])) + (_e9440 * _e9089[2]));
                                                                        let _e9535 = (((_e9436 * _e9095[0]) + (_e9438 * _e9095[1])) + (_e9440 * _e9095[2]));
                                                                        let _e9540 = (((_e9436 * _e9112) + (_e9438 * _e9113)) + (_e9440 * _e9114));
                                                                        let _e9545 = (((_e9436 * (_e9095[0] - _e9108[0])) + (_e9438 * (_e9095[1] - _e9108[1]))) + (_e9440 * (_e9095[2] - _e9108[2])));
                                                                        let _e9553 = (((_e9436 * _e9121[0]) + (_e9438 * _e9121[1])) + (_e9440 * _e9121[2]));
                                                                        if (_e9511 < 0f) {
                                                                            phi_20313_ = -(_e9511);
                                                                        } else {
                                                                            phi_20313_ = _e9511;
                                                                        }
                                                                        let _e9558 = phi_20313_;
                                                                        if (_e9535 < 0f) {
                                                                            phi_20319_ = -(_e9535);
                                                                        } else {
                                                                            phi_20319_ = _e9535;
                                                                        }
                                                                        let _e9562 = phi_20319_;
                                                                        if (_e9516 < 0f) {
                                                                            phi_20328_ = -(_e9516);
                                                                        } else {
                                                                            phi_20328_ = _e9516;
                                                                        }
                                                                        let _e9569 = phi_20328_;
                                                                        if (_e9540 < 0f) {
                                                                            phi_20334_ = -(_e9540);
                                                                        } else {
                                                                            phi_20334_ = _e9540;
                                                                        }
                                                                        let _e9573 = phi_20334_;
                                                                        if (_e9521 < 0f) {
                                                                            phi_20343_ = -(_e9521);
                                                                        } else {
                                                                            phi_20343_ = _e9521;
                                                                        }
                                                                        let _e9580 = phi_20343_;
                                                                        if (_e9545 < 0f) {
                                                                            phi_20349_ = -(_e9545);
                                                                        } else {
                                                                            phi_20349_ = _e9545;
                                                                        }
                                                                        let _e9584 = phi_20349_;
                                                                        if (_e9529 < 0f) {
                                                                            phi_20358_ = -(_e9529);
                                                                        } else {
                                                                            phi_20358_ = _e9529;
                                                                        }
                                                                        let _e9591 = phi_20358_;
                                                                        if (_e9553 < 0f) {
                                                                            phi_20364_ = -(_e9553);
                                                                        } else {
                                                                            phi_20364_ = _e9553;
                                                                        }
                                                                        let _e9595 = phi_20364_;
                                                                        phi_20370_ = type_29(array<f32, 4>(_e9511, _e9516, _e9521, _e9529), array<f32, 4>(_e9535, _e9540, _e9545, _e9553), array<f32, 4>((_e9506 + ((_e9558 + _e9562) * _e9501)), (_e9506 + ((_e9569 + _e9573) * _e9501)), (_e9506 + ((_e9580 + _e9584) * _e9501)), (_e9506 + ((_e9591 + _e9595) * _e9501))));
                                                                        phi_20371_ = false;
                                                                    } else {
                                                                        phi_20370_ = type_29();
                                                                        phi_20371_ = true;
                                                                    }
                                                                    let _e9602 = phi_20370_;
                                                                    let _e9604 = phi_20371_;
                                                                    phi_20372_ = _e9602;
                                                                    phi_20373_ = _e9604;
                                                                } else {
                                                                    phi_20372_ = type_29();
                                                                    phi_20373_ = true;
                                                                }
                                                                let _e9606 = phi_20372_;
                                                                let _e9608 = phi_20373_;
                                                                if _e9608 {
                                                                    phi_20381_ = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                                } else {
                                                                    phi_20381_ = _e9606;
                                                                }
                                                                let _e9610 = phi_20381_;
                                                                local_1 = type_29(array<f32, 4>(_e9610.member[0], _e9610.member[1], _e9610.member[2], _e9610.member[3]), array<f32, 4>(_e9610.member_1[0], _e9610.member_1[1], _e9610.member_1[2], _e9610.member_1[3]), array<f32, 4>(_e9610.member_2[0], _e9610.member_2[1], _e9610.member_2[2], _e9610.member_2[3]));
                                                                let _e9630 = (_e9302 - _e9308);
                                                                let _e9634 = local_1.member[0u];
                                                                let _e9637 = local_1.member_1[0u];
                                                                let _e9640 = local_1.member[0u];
                                                                let _e9646 = local_1.member_2[0u];
                                                                if (((_e9634 + ((_e9637 - _e9640) * _e9302)) - _e9646) > 0f) {
                                                                    let _e9651 = local_1.member[1u];
                                                                    let _e9654 = local_1.member_1[1u];
                                                                    let _e9657 = local_1.member[1u];
                                                                    let _e9663 = local_1.member_2[1u];
                                                                    if (((_e9651 + ((_e9654 - _e9657) * _e9302)) - _e9663) > 0f) {
                                                                        let _e9668 = local_1.member[2u];
                                                                        let _e9671 = local_1.member_1[2u];
                                                                        let _e9674 = local_1.member[2u];
                                                                        let _e9680 = local_1.member_2[2u];
                                                                        if (((_e9668 + ((_e9671 - _e9674) * _e9302)) - _e9680) > 0f) {
                                                                            let _e9685 = local_1.member[3u];
                                                                            let _e9688 = local_1.member_1[3u];
                                                                            let _e9691 = local_1.member[3u];
                                                                            let _e9697 = local_1.member_2[3u];
                                                                            phi_20552_ = (((_e9685 + ((_e9688 - _e9691) * _e9302)) - _e9697) > 0f);
                                                                            phi_20553_ = false;
                                                                        } else {
                                                                            phi_20552_ = bool();
                                                                            phi_20553_ = true;
                                                                        }
                                                                        let _e9701 = phi_20552_;
                                                                        let _e9703 = phi_20553_;
                                                                        phi_20554_ = _e9701;
                                                                        phi_20555_ = _e9703;
                                                                    } else {
                                                                        phi_20554_ = bool();
                                                                        phi_20555_ = true;
                                                                    }
                                                                    let _e9705 = phi_20554_;
                                                                    let _e9707 = phi_20555_;
                                                                    phi_20556_ = _e9705;
                                                                    phi_20557_ = _e9707;
                                                                } else {
                                                                    phi_20556_ = bool();
                                                                    phi_20557_ = true;
                                                                }
                                                                let _e9709 = phi_20556_;
                                                                let _e9711 = phi_20557_;
                                                                if _e9711 {
                                                                    phi_20561_ = false;
                                                                } else {
                                                                    phi_20561_ = _e9709;
                                                                }
                                                                let _e9713 = phi_20561_;
                                                                if _e9713 {
                                                                    if (_e9302 <= _e9304) {
                                                                        phi_20871_ = true;
                                                                    } else {
                                                                        let _e9717 = local.member[0u];
                                                                        let _e9720 = local.member_1[0u];
                                                                        let _e9723 = local.member[0u];
                                                                        let _e9729 = local.member_2[0u];
                                                                        let _e9733 = local_1.member[0u];
                                                                        let _e9736 = local_1.member_1[0u];
                                                                        let _e9739 = local_1.member[0u];
                                                                        let _e9745 = local_1.member_2[0u];
                                                                        if ((((_e9717 + ((_e9720 - _e9723) * _e9302)) - _e9729) + ((_e9733 + ((_e9736 - _e9739) * _e9308)) - _e9745)) > 0f) {
                                                                            let _e9751 = local.member[1u];
                                                                            let _e9754 = local.member_1[1u];
                                                                            let _e9757 = local.member[1u];
                                                                            let _e9763 = local.member_2[1u];
                                                                            let _e9767 = local_1.member[1u];
                                                                            let _e9770 = local_1.member_1[1u];
                                                                            let _e9773 = local_1.member[1u];
                                                                            let _e9779 = local_1.member_2[1u];
                                                                            if ((((_e9751 + ((_e9754 - _e9757) * _e9302)) - _e9763) + ((_e9767 + ((_e9770 - _e9773) * _e9308)) - _e9779)) > 0f) {
                                                                                let _e9785 = local.member[2u];
                                                                                let _e9788 = local.member_1[2u];
                                                                                let _e9791 = local.member[2u];
                                                                                let _e9797 = local.member_2[2u];
                                                                                let _e9801 = local_1.member[2u];
                                                                                let _e9804 = local_1.member_1[2u];
                                                                                let _e9807 = local_1.member[2u];
                                                                                let _e9813 = local_1.member_2[2u];
                                                                                if ((((_e9785 + ((_e9788 - _e9791) * _e9302)) - _e9797) + ((_e9801 + ((_e9804 - _e9807) * _e9308)) - _e9813)) > 0f) {
                                                                                    let _e9819 = local.member[3u];
                                                                                    let _e9822 = local.member_1[3u];
                                                                                    let _e9825 = local.member[3u];
                                                                                    let _e9831 = local.member_2[3u];
                                                                                    let _e9835 = local_1.member[3u];
                                                                                    let _e9838 = local_1.member_1[3u];
                                                                                    let _e9841 = local_1.member[3u];
                                                                                    let _e9847 = local_1.member_2[3u];
                                                                                    phi_20858_ = ((((_e9819 + ((_e9822 - _e9825) * _e9302)) - _e9831) + ((_e9835 + ((_e9838 - _e9841) * _e9308)) - _e9847)) > 0f);
                                                                                    phi_20859_ = false;
                                                                                } else {
                                                                                    phi_20858_ = bool();
                                                                                    phi_20859_ = true;
                                                                                }
                                                                                let _e9852 = phi_20858_;
                                                                                let _e9854 = phi_20859_;
                                                                                phi_20860_ = _e9852;
                                                                                phi_20861_ = _e9854;
                                                                            } else {
                                                                                phi_20860_ = bool();
                                                                                phi_20861_ = true;
                                                                            }
                                                                            let _e9856 = phi_20860_;
                                                                            let _e9858 = phi_20861_;
                                                                            phi_20862_ = _e9856;
                                                                            phi_20863_ = _e9858;
                                                                        } else {
                                                                            phi_20862_ = bool();
                                                                            phi_20863_ = true;
                                                                        }
                                                                        let _e9860 = phi_20862_;
                                                                        let _e9862 = phi_20863_;
                                                                        if _e9862 {
                                                                            phi_20867_ = false;
                                                                        } else {
                                                                            phi_20867_ = _e9860;
                                                                        }
                                                                        let _e9864 = phi_20867_;
                                                                        phi_20871_ = _e9864;
                                                                    }
                                                                    let _e9866 = phi_20871_;
                                                                    if _e9866 {
                                                                        if _e9310 {
                                                                            if (_e9302 >= _e8314.member_1) {
                                                                                phi_20882_ = false;
                                                                            } else {
                                                                                phi_20882_ = true;
                                                                            }
                                                                            let _e9869 = phi_20882_;
                                                                            phi_20883_ = _e9869;
                                                                        } else {
                                                                            phi_20883_ = true;
                                                                        }
                                                                        let _e9871 = phi_20883_;
                                                                        if _e9871 {
                                                                            local = type_29(array<f32, 4>(_e9610.member[0], _e9610.member[1], _e9610.member[2], _e9610.member[3]), array<f32, 4>(_e9610.member_1[0], _e9610.member_1[1], _e9610.member_1[2], _e9610.member_1[3]), array<f32, 4>(_e9610.member_2[0], _e9610.member_2[1], _e9610.member_2[2], _e9610.member_2[3]));
                                                                            let _e9893 = local.member[0u];
                                                                            let _e9896 = local.member_1[0u];
                                                                            let _e9899 = local.member_2[0u];
                                                                            if (_e9893 > _e9899) {
                                                                                if (_e9896 > _e9899) {
                                                                                    phi_20957_ = false;
                                                                                } else {
                                                                                    phi_20957_ = true;
                                                                                }
                                                                                let _e9903 = phi_20957_;
                                                                                phi_20958_ = _e9903;
                                                                            } else {
                                                                                phi_20958_ = true;
                                                                            }
                                                                            let _e9905 = phi_20958_;
                                                                            if _e9905 {
                                                                                let _e9906 = (_e9896 >= _e9893);
                                                                                if _e9906 {
                                                                                    phi_20980_ = f32();
                                                                                    phi_20981_ = false;
                                                                                } else {
                                                                                    if ((_e9893 - _e9896) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                        phi_20978_ = (((_e9893 - _e9899) / (_e9893 - _e9896)) * (1f - (0.000000059604645f * 16f)));
                                                                                        phi_20979_ = false;
                                                                                    } else {
                                                                                        phi_20978_ = f32();
                                                                                        phi_20979_ = true;
                                                                                    }
                                                                                    let _e9917 = phi_20978_;
                                                                                    let _e9919 = phi_20979_;
                                                                                    phi_20980_ = _e9917;
                                                                                    phi_20981_ = _e9919;
                                                                                }
                                                                                let _e9921 = phi_20980_;
                                                                                let _e9923 = phi_20981_;
                                                                                phi_20982_ = _e9921;
                                                                                phi_20983_ = _e9906;
                                                                                phi_20984_ = _e9923;
                                                                            } else {
                                                                                phi_20982_ = f32();
                                                                                phi_20983_ = true;
                                                                                phi_20984_ = false;
                                                                            }
                                                                            let _e9925 = phi_20982_;
                                                                            let _e9927 = phi_20983_;
                                                                            let _e9929 = phi_20984_;
                                                                            if _e9927 {
                                                                                phi_20988_ = 2f;
                                                                                phi_20989_ = true;
                                                                            } else {
                                                                                phi_20988_ = _e9302;
                                                                                phi_20989_ = _e9929;
                                                                            }
                                                                            let _e9931 = phi_20988_;
                                                                            let _e9933 = phi_20989_;
                                                                            if _e9933 {
                                                                                phi_20993_ = _e9931;
                                                                            } else {
                                                                                phi_20993_ = _e9925;
                                                                            }
                                                                            let _e9935 = phi_20993_;
                                                                            let _e9938 = local.member[1u];
                                                                            let _e9941 = local.member_1[1u];
                                                                            let _e9944 = local.member_2[1u];
                                                                            if (_e9938 > _e9944) {
                                                                                if (_e9941 > _e9944) {
                                                                                    phi_21025_ = false;
                                                                                } else {
                                                                                    phi_21025_ = true;
                                                                                }
                                                                                let _e9948 = phi_21025_;
                                                                                phi_21026_ = _e9948;
                                                                            } else {
                                                                                phi_21026_ = true;
                                                                            }
                                                                            let _e9950 = phi_21026_;
                                                                            if _e9950 {
                                                                                let _e9951 = (_e9941 >= _e9938);
                                                                                if _e9951 {
                                                                                    phi_21048_ = f32();
                                                                                    phi_21049_ = false;
                                                                                } else {
                                                                                    if ((_e9938 - _e9941) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                        phi_21046_ = (((_e9938 - _e9944) / (_e9938 - _e9941)) * (1f - (0.000000059604645f * 16f)));
                                                                                        phi_21047_ = false;
                                                                                    } else {
                                                                                        phi_21046_ = f32();
                                                                                        phi_21047_ = true;
                                                                                    }
                                                                                    let _e9962 = phi_21046_;
                                                                                    let _e9964 = phi_21047_;
                                                                                    phi_21048_ = _e9962;
                                                                                    phi_21049_ = _e9964;
                                                                                }
                                                                                let _e9966 = phi_21048_;
                                                                                let _e9968 = phi_21049_;
                                                                                phi_21050_ = _e9966;
                                                                                phi_21051_ = _e9951;
                                                                                phi_21052_ = _e9968;
                                                                            } else {
                                                                                phi_21050_ = f32();
                                                                                phi_21051_ = true;
                                                                                phi_21052_ = false;
                                                                            }
                                                                            let _e9970 = phi_21050_;
                                                                            let _e9972 = phi_21051_;
                                                                            let _e9974 = phi_21052_;
                                                                            if _e9972 {
                                                                                phi_21056_ = 2f;
                                                                                phi_21057_ = true;
                                                                            } else {
                                                                                phi_21056_ = _e9302;
                                                                                phi_21057_ = _e9974;
                                                                            }
                                                                            let _e9976 = phi_21056_;
                                                                            let _e9978 = phi_21057_;
                                                                            if _e9978 {
                                                                                phi_21061_ = _e9976;
                                                                            } else {
                                                                                phi_21061_ = _e9970;
                                                                            }
                                                                            let _e9980 = phi_21061_;
                                                                            if (_e9935 < _e9980) {
                                                                                phi_21066_ = _e9935;
                                                                            } else {
                                                                                phi_21066_ = _e9980;
                                                                            }
                                                                            let _e9983 = phi_21066_;
                                                                            let _e9986 = local.member[2u];
                                                                            let _e9989 = local.member_1[2u];
                                                                            let _e9992 = local.member_2[2u];
                                                                            if (_e9986 > _e9992) {
                                                                                if (_e9989 > _e9992) {
                                                                                    phi_21098_ = false;
                                                                                } else {
                                                                                    phi_21098_ = true;
                                                                                }
                                                                                let _e9996 = phi_21098_;
                                                                                phi_21099_ = _e9996;
                                                                            } else {
                                                                                phi_21099_ = true;
                                                                            }
                                                                            let _e9998 = phi_21099_;
                                                                            if _e9998 {
                                                                                let _e9999 = (_e9989 >= _e9986);
                                                                                if _e9999 {
                                                                                    phi_21121_ = f32();
                                                                                    phi_21122_ = false;
                                                                                } else {
                                                                                    if ((_e9986 - _e9989) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                        phi_21119_ = (((_e9986 - _e9992) / (_e9986 - _e9989)) * (1f - (0.000000059604645f * 16f)));
                                                                                        phi_21120_ = false;
                                                                                    } else {
                                                                                        phi_21119_ = f32();
                                                                                        phi_21120_ = true;
                                                                                    }
                                                                                    let _e10010 = phi_21119_;
                                                                                    let _e10012 = phi_21120_;
                                                                                    phi_21121_ = _e10010;
                                                                                    phi_21122_ = _e10012;
                                                                                }
                                                                                let _e10014 = phi_21121_;
                                                                                let _e10016 = phi_21122_;
                                                                                phi_21123_ = _e10014;
                                                                                phi_21124_ = _e9999;
                                                                                phi_21125_ = _e10016;
                                                                            } else {
                                                                                phi_21123_ = f32();
                                                                                phi_21124_ = true;
                                                                                phi_21125_ = false;
                                                                            }
                                                                            let _e10018 = phi_21123_;
                                                                            let _e10020 = phi_21124_;
                                                                            let _e10022 = phi_21125_;
                                                                            if _e10020 {
                                                                                phi_21129_ = 2f;
                                                                                phi_21130_ = true;
                                                                            } else {
                                                                                phi_21129_ = _e9302;
                                                                                phi_21130_ = _e10022;
                                                                            }
                                                                            let _e10024 = phi_21129_;
                                                                            let _e10026 = phi_21130_;
                                                                            if _e10026 {
                                                                                phi_21134_ = _e10024;
                                                                            } else {
                                                                                phi_21134_ = _e10018;
                                                                            }
                                                                            let _e10028 = phi_21134_;
                                                                            let _e10031 = local.member[3u];
                                                                            let _e10034 = local.member_1[3u];
                                                                            let _e10037 = local.member_2[3u];
                                                                            if (_e10031 > _e10037) {
                                                                                if (_e10034 > _e10037) {
                                                                                    phi_21166_ = false;
                                                                                } else {
                                                                                    phi_21166_ = true;
                                                                                }
                                                                                let _e10041 = phi_21166_;
                                                                                phi_21167_ = _e10041;
                                                                            } else {
                                                                                phi_21167_ = true;
                                                                            }
                                                                            let _e10043 = phi_21167_;
                                                                            if _e10043 {
                                                                                let _e10044 = (_e10034 >= _e10031);
                                                                                if _e10044 {
                                                                                    phi_21189_ = f32();
                                                                                    phi_21190_ = false;
                                                                                } else {
                                                                                    if ((_e10031 - _e10034) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                        phi_21187_ = (((_e10031 - _e10037) / (_e10031 - _e10034)) * (1f - (0.000000059604645f * 16f)));
                                                                                        phi_21188_ = false;
                                                                                    } else {
                                                                                        phi_21187_ = f32();
                                                                                        phi_21188_ = true;
                                                                                    }
                                                                                    let _e10055 = phi_21187_;
                                                                                    let _e10057 = phi_21188_;
                                                                                    phi_21189_ = _e10055;
                                                                                    phi_21190_ = _e10057;
                                                                                }
                                                                                let _e10059 = phi_21189_;
                                                                                let _e10061 = phi_21190_;
                                                                                phi_21191_ = _e10059;
                                                                                phi_21192_ = _e10044;
                                                                                phi_21193_ = _e10061;
                                                                            } else {
                                                                                phi_21191_ = f32();
                                                                                phi_21192_ = true;
                                                                                phi_21193_ = false;
                                                                            }
                                                                            let _e10063 = phi_21191_;
                                                                            let _e10065 = phi_21192_;
                                                                            let _e10067 = phi_21193_;
                                                                            if _e10065 {
                                                                                phi_21197_ = 2f;
                                                                                phi_21198_ = true;
                                                                            } else {
                                                                                phi_21197_ = _e9302;
                                                                                phi_21198_ = _e10067;
                                                                            }
                                                                            let _e10069 = phi_21197_;
                                                                            let _e10071 = phi_21198_;
                                                                            if _e10071 {
                                                                                phi_21202_ = _e10069;
                                                                            } else {
                                                                                phi_21202_ = _e10063;
                                                                            }
                                                                            let _e10073 = phi_21202_;
                                                                            if (_e10028 < _e10073) {
                                                                                phi_21207_ = _e10028;
                                                                            } else {
                                                                                phi_21207_ = _e10073;
                                                                            }
                                                                            let _e10076 = phi_21207_;
                                                                            if (_e9983 < _e10076) {
                                                                                phi_21212_ = _e9983;
                                                                            } else {
                                                                                phi_21212_ = _e10076;
                                                                            }
                                                                            let _e10079 = phi_21212_;
                                                                            if (_e10079 > _e9302) {
                                                                                phi_21217_ = _e10079;
                                                                            } else {
                                                                                phi_21217_ = _e9302;
                                                                            }
                                                                            let _e10082 = phi_21217_;
                                                                            let _e10083 = (_e10082 > _e8314.member_1);
                                                                            if _e10083 {
                                                                                phi_21722_ = f32();
                                                                                phi_21723_ = f32();
                                                                                phi_21724_ = false;
                                                                            } else {
                                                                                let _e10084 = (_e10082 - _e9302);
                                                                                if _e9310 {
                                                                                    if (_e10084 <= _e9297) {
                                                                                        phi_21712_ = true;
                                                                                    } else {
                                                                                        if (_e10084 <= (_e9306 * 0.25f)) {
                                                                                            phi_21711_ = false;
                                                                                        } else {
                                                                                            phi_21711_ = true;
                                                                                        }
                                                                                        let _e10090 = phi_21711_;
                                                                                        phi_21712_ = _e10090;
                                                                                    }
                                                                                    let _e10092 = phi_21712_;
                                                                                    if _e10092 {
                                                                                        phi_21717_ = (_e9630 + _e9630);
                                                                                    } else {
                                                                                        phi_21717_ = 0f;
                                                                                    }
                                                                                    let _e10095 = phi_21717_;
                                                                                    phi_21719_ = _e10095;
                                                                                } else {
                                                                                    phi_21719_ = (_e8314.member_1 - _e9302);
                                                                                }
                                                                                let _e10097 = phi_21719_;
                                                                                phi_21722_ = _e10097;
                                                                                phi_21723_ = _e10084;
                                                                                phi_21724_ = true;
                                                                            }
                                                                            let _e10099 = phi_21722_;
                                                                            let _e10101 = phi_21723_;
                                                                            let _e10103 = phi_21724_;
                                                                            phi_21726_ = _e10082;
                                                                            phi_21727_ = _e10099;
                                                                            phi_21728_ = _e10101;
                                                                            phi_21730_ = _e10103;
                                                                            phi_21731_ = _e10083;
                                                                            phi_21733_ = false;
                                                                        } else {
                                                                            phi_21726_ = f32();
                                                                            phi_21727_ = f32();
                                                                            phi_21728_ = f32();
                                                                            phi_21730_ = false;
                                                                            phi_21731_ = false;
                                                                            phi_21733_ = true;
                                                                        }
                                                                        let _e10105 = phi_21726_;
                                                                        let _e10107 = phi_21727_;
                                                                        let _e10109 = phi_21728_;
                                                                        let _e10111 = phi_21730_;
                                                                        let _e10113 = phi_21731_;
                                                                        let _e10115 = phi_21733_;
                                                                        phi_21734_ = _e10105;
                                                                        phi_21735_ = _e10107;
                                                                        phi_21736_ = _e10109;
                                                                        phi_21738_ = false;
                                                                        phi_21739_ = _e10111;
                                                                        phi_21740_ = _e10113;
                                                                        phi_21742_ = _e10115;
                                                                    } else {
                                                                        phi_21734_ = f32();
                                                                        phi_21735_ = f32();
                                                                        phi_21736_ = f32();
                                                                        phi_21738_ = true;
                                                                        phi_21739_ = false;
                                                                        phi_21740_ = false;
                                                                        phi_21742_ = false;
                                                                    }
                                                                    let _e10117 = phi_21734_;
                                                                    let _e10119 = phi_21735_;
                                                                    let _e10121 = phi_21736_;
                                                                    let _e10123 = phi_21738_;
                                                                    let _e10125 = phi_21739_;
                                                                    let _e10127 = phi_21740_;
                                                                    let _e10129 = phi_21742_;
                                                                    phi_21743_ = _e10117;
                                                                    phi_21744_ = _e10119;
                                                                    phi_21745_ = _e10121;
                                                                    phi_21747_ = _e10123;
                                                                    phi_21748_ = _e10125;
                                                                    phi_21749_ = _e10127;
                                                                    phi_21751_ = _e10129;
                                                                } else {
                                                                    phi_21743_ = f32();
                                                                    phi_21744_ = f32();
                                                                    phi_21745_ = f32();
                                                                    phi_21747_ = true;
                                                                    phi_21748_ = false;
                                                                    phi_21749_ = false;
                                                                    phi_21751_ = false;
                                                                }
                                                                let _e10131 = phi_21743_;
                                                                let _e10133 = phi_21744_;
                                                                let _e10135 = phi_21745_;
                                                                let _e10137 = phi_21747_;
                                                                let _e10139 = phi_21748_;
                                                                let _e10141 = phi_21749_;
                                                                let _e10143 = phi_21751_;
                                                                if _e10137 {
                                                                    if (_e9302 <= _e9304) {
                                                                        let _e10304 = (_e9312 + 1u);
                                                                        let _e10305 = (_e10304 > 3u);
                                                                        if _e10305 {
                                                                            phi_21764_ = false;
                                                                        } else {
                                                                            phi_21764_ = true;
                                                                        }
                                                                        let _e10307 = phi_21764_;
                                                                        phi_22086_ = _e10304;
                                                                        phi_22087_ = f32();
                                                                        phi_22088_ = false;
                                                                        phi_22089_ = _e10307;
                                                                        phi_22090_ = _e10305;
                                                                    } else {
                                                                        let _e10147 = local.member[0u];
                                                                        let _e10150 = local.member_1[0u];
                                                                        let _e10153 = local.member[0u];
                                                                        let _e10159 = local.member_2[0u];
                                                                        let _e10160 = ((_e10147 + ((_e10150 - _e10153) * _e9308)) - _e10159);
                                                                        let _e10163 = local.member[1u];
                                                                        let _e10166 = local.member_1[1u];
                                                                        let _e10169 = local.member[1u];
                                                                        let _e10175 = local.member_2[1u];
                                                                        let _e10176 = ((_e10163 + ((_e10166 - _e10169) * _e9308)) - _e10175);
                                                                        if (_e10160 < _e10176) {
                                                                            phi_21837_ = _e10160;
                                                                        } else {
                                                                            phi_21837_ = _e10176;
                                                                        }
                                                                        let _e10179 = phi_21837_;
                                                                        let _e10182 = local.member[2u];
                                                                        let _e10185 = local.member_1[2u];
                                                                        let _e10188 = local.member[2u];
                                                                        let _e10194 = local.member_2[2u];
                                                                        let _e10195 = ((_e10182 + ((_e10185 - _e10188) * _e9308)) - _e10194);
                                                                        let _e10198 = local.member[3u];
                                                                        let _e10201 = local.member_1[3u];
                                                                        let _e10204 = local.member[3u];
                                                                        let _e10210 = local.member_2[3u];
                                                                        let _e10211 = ((_e10198 + ((_e10201 - _e10204) * _e9308)) - _e10210);
                                                                        if (_e10195 < _e10211) {
                                                                            phi_21910_ = _e10195;
                                                                        } else {
                                                                            phi_21910_ = _e10211;
                                                                        }
                                                                        let _e10214 = phi_21910_;
                                                                        if (_e10179 < _e10214) {
                                                                            phi_21915_ = _e10179;
                                                                        } else {
                                                                            phi_21915_ = _e10214;
                                                                        }
                                                                        let _e10217 = phi_21915_;
                                                                        let _e10220 = local_1.member[0u];
                                                                        let _e10223 = local_1.member_1[0u];
                                                                        let _e10226 = local_1.member[0u];
                                                                        let _e10232 = local_1.member_2[0u];
                                                                        let _e10233 = ((_e10220 + ((_e10223 - _e10226) * _e9302)) - _e10232);
                                                                        let _e10236 = local_1.member[1u];
                                                                        let _e10239 = local_1.member_1[1u];
                                                                        let _e10242 = local_1.member[1u];
                                                                        let _e10248 = local_1.member_2[1u];
                                                                        let _e10249 = ((_e10236 + ((_e10239 - _e10242) * _e9302)) - _e10248);
                                                                        if (_e10233 < _e10249) {
                                                                            phi_21988_ = _e10233;
                                                                        } else {
                                                                            phi_21988_ = _e10249;
                                                                        }
                                                                        let _e10252 = phi_21988_;
                                                                        let _e10255 = local_1.member[2u];
                                                                        let _e10258 = local_1.member_1[2u];
                                                                        let _e10261 = local_1.member[2u];
                                                                        let _e10267 = local_1.member_2[2u];
                                                                        let _e10268 = ((_e10255 + ((_e10258 - _e10261) * _e9302)) - _e10267);
                                                                        let _e10271 = local_1.member[3u];
                                                                        let _e10274 = local_1.member_1[3u];
                                                                        let _e10277 = local_1.member[3u];
                                                                        let _e10283 = local_1.member_2[3u];
                                                                        let _e10284 = ((_e10271 + ((_e10274 - _e10277) * _e9302)) - _e10283);
                                                                        if (_e10268 < _e10284) {
                                                                            phi_22061_ = _e10268;
                                                                        } else {
                                                                            phi_22061_ = _e10284;
                                                                        }
                                                                        let _e10287 = phi_22061_;
                                                                        if (_e10252 < _e10287) {
                                                                            phi_22066_ = _e10252;
                                                                        } else {
                                                                            phi_22066_ = _e10287;
                                                                        }
                                                                        let _e10290 = phi_22066_;
                                                                        if (_e10290 > 0f) {
                                                                            phi_22084_ = 0.5f;
                                                                        } else {
                                                                            let _e10294 = (0.95f * (_e10217 / (_e10217 - _e10290)));
                                                                            if (_e10294 > 0.0625f) {
                                                                                if (_e10294 < 0.9f) {
                                                                                    phi_22082_ = _e10294;
                                                                                } else {
                                                                                    phi_22082_ = 0.9f;
                                                                                }
                                                                                let _e10298 = phi_22082_;
                                                                                phi_22083_ = _e10298;
                                                                            } else {
                                                                                phi_22083_ = 0.0625f;
                                                                            }
                                                                            let _e10300 = phi_22083_;
                                                                            phi_22084_ = _e10300;
                                                                        }
                                                                        let _e10302 = phi_22084_;
                                                                        phi_22086_ = u32();
                                                                        phi_22087_ = (_e9630 * _e10302);
                                                                        phi_22088_ = true;
                                                                        phi_22089_ = false;
                                                                        phi_22090_ = false;
                                                                    }
                                                                    let _e10309 = phi_22086_;
                                                                    let _e10311 = phi_22087_;
                                                                    let _e10313 = phi_22088_;
                                                                    let _e10315 = phi_22089_;
                                                                    let _e10317 = phi_22090_;
                                                                    phi_22091_ = _e10309;
                                                                    phi_22092_ = _e9304;
                                                                    phi_22093_ = _e10311;
                                                                    phi_22094_ = _e9306;
                                                                    phi_22095_ = _e9308;
                                                                    phi_22096_ = _e9310;
                                                                    phi_22097_ = _e9312;
                                                                    phi_22098_ = _e10313;
                                                                    phi_22099_ = _e10315;
                                                                    phi_22100_ = _e10317;
                                                                    phi_22101_ = false;
                                                                    phi_22103_ = false;
                                                                } else {
                                                                    phi_22091_ = u32();
                                                                    phi_22092_ = _e10131;
                                                                    phi_22093_ = _e10133;
                                                                    phi_22094_ = _e10135;
                                                                    phi_22095_ = _e9302;
                                                                    phi_22096_ = true;
                                                                    phi_22097_ = 0u;
                                                                    phi_22098_ = _e10139;
                                                                    phi_22099_ = false;
                                                                    phi_22100_ = false;
                                                                    phi_22101_ = _e10141;
                                                                    phi_22103_ = _e10143;
                                                                }
                                                                let _e10319 = phi_22091_;
                                                                let _e10321 = phi_22092_;
                                                                let _e10323 = phi_22093_;
                                                                let _e10325 = phi_22094_;
                                                                let _e10327 = phi_22095_;
                                                                let _e10329 = phi_22096_;
                                                                let _e10331 = phi_22097_;
                                                                let _e10333 = phi_22098_;
                                                                let _e10335 = phi_22099_;
                                                                let _e10337 = phi_22100_;
                                                                let _e10339 = phi_22101_;
                                                                let _e10341 = phi_22103_;
                                                                if _e10333 {
                                                                    let _e10342 = (_e10327 + _e10323);
                                                                    if (_e10342 > _e10321) {
                                                                        phi_22112_ = _e10342;
                                                                    } else {
                                                                        phi_22112_ = _e10321;
                                                                    }
                                                                    let _e10345 = phi_22112_;
                                                                    if (_e10345 < _e8314.member_1) {
                                                                        phi_22117_ = _e10345;
                                                                    } else {
                                                                        phi_22117_ = _e8314.member_1;
                                                                    }
                                                                    let _e10348 = phi_22117_;
                                                                    if !(_e9310) {
                                                                        phi_22126_ = true;
                                                                    } else {
                                                                        phi_22126_ = ((_e10348 - _e10327) > _e9297);
                                                                    }
                                                                    let _e10352 = phi_22126_;
                                                                    if _e10352 {
                                                                        phi_22130_ = false;
                                                                    } else {
                                                                        phi_22130_ = true;
                                                                    }
                                                                    let _e10354 = phi_22130_;
                                                                    phi_22131_ = _e10348;
                                                                    phi_22132_ = _e10321;
                                                                    phi_22133_ = _e10325;
                                                                    phi_22134_ = _e10327;
                                                                    phi_22135_ = _e10329;
                                                                    phi_22136_ = _e10331;
                                                                    phi_22137_ = _e10352;
                                                                    phi_22138_ = _e10354;
                                                                    phi_22139_ = false;
                                                                    phi_22140_ = false;
                                                                    phi_22142_ = false;
                                                                } else {
                                                                    phi_22131_ = _e9302;
                                                                    phi_22132_ = _e9304;
                                                                    phi_22133_ = _e9306;
                                                                    phi_22134_ = _e9308;
                                                                    phi_22135_ = _e9310;
                                                                    phi_22136_ = _e10319;
                                                                    phi_22137_ = _e10335;
                                                                    phi_22138_ = false;
                                                                    phi_22139_ = _e10337;
                                                                    phi_22140_ = _e10339;
                                                                    phi_22142_ = _e10341;
                                                                }
                                                                let _e10356 = phi_22131_;
                                                                let _e10358 = phi_22132_;
                                                                let _e10360 = phi_22133_;
                                                                let _e10362 = phi_22134_;
                                                                let _e10364 = phi_22135_;
                                                                let _e10366 = phi_22136_;
                                                                let _e10368 = phi_22137_;
                                                                let _e10370 = phi_22138_;
                                                                let _e10372 = phi_22139_;
                                                                let _e10374 = phi_22140_;
                                                                let _e10376 = phi_22142_;
                                                                phi_19964_ = _e10356;
                                                                phi_19966_ = _e10358;
                                                                phi_19968_ = _e10360;
                                                                phi_19970_ = _e10362;
                                                                phi_19972_ = _e10364;
                                                                phi_19974_ = _e10366;
                                                                phi_22143_ = _e10321;
                                                                phi_22145_ = _e10368;
                                                                phi_22146_ = _e10370;
                                                                phi_22147_ = _e10372;
                                                                phi_22148_ = _e10374;
                                                                phi_22150_ = false;
                                                                phi_22151_ = _e10376;
                                                            } else {
                                                                phi_19964_ = f32();
                                                                phi_19966_ = f32();
                                                                phi_19968_ = f32();
                                                                phi_19970_ = f32();
                                                                phi_19972_ = bool();
                                                                phi_19974_ = u32();
                                                                phi_22143_ = f32();
                                                                phi_22145_ = false;
                                                                phi_22146_ = false;
                                                                phi_22147_ = false;
                                                                phi_22148_ = false;
                                                                phi_22150_ = true;
                                                                phi_22151_ = false;
                                                            }
                                                            let _e10378 = phi_19964_;
                                                            let _e10380 = phi_19966_;
                                                            let _e10382 = phi_19968_;
                                                            let _e10384 = phi_19970_;
                                                            let _e10386 = phi_19972_;
                                                            let _e10388 = phi_19974_;
                                                            let _e10390 = phi_22143_;
                                                            let _e10392 = phi_22145_;
                                                            let _e10394 = phi_22146_;
                                                            let _e10396 = phi_22147_;
                                                            let _e10398 = phi_22148_;
                                                            let _e10400 = phi_22150_;
                                                            let _e10402 = phi_22151_;
                                                            local_95 = _e10394;
                                                            local_140 = _e10396;
                                                            local_141 = _e10398;
                                                            local_142 = _e10400;
                                                            local_143 = _e10402;
                                                            local_144 = _e10394;
                                                            local_145 = _e10390;
                                                            continue;
                                                            continuing {
                                                                phi_19960_ = _e9324;
                                                                phi_19963_ = _e10378;
                                                                phi_19965_ = _e10380;
                                                                phi_19967_ = _e10382;
                                                                phi_19969_ = _e10384;
                                                                phi_19971_ = _e10386;
                                                                phi_19973_ = _e10388;
                                                                break if !(_e10392);
                                                            }
                                                        }
                                                        let _e10405 = local_95;
                                                        if _e10405 {
                                                            phi_22155_ = false;
                                                            phi_22156_ = false;
                                                            phi_22158_ = false;
                                                            phi_22159_ = false;
                                                        } else {
                                                            let _e16584 = local_140;
                                                            phi_22155_ = _e16584;
                                                            let _e16587 = local_141;
                                                            phi_22156_ = _e16587;
                                                            let _e16590 = local_142;
                                                            phi_22158_ = _e16590;
                                                            let _e16593 = local_143;
                                                            phi_22159_ = _e16593;
                                                        }
                                                        let _e10407 = phi_22155_;
                                                        let _e10409 = phi_22156_;
                                                        let _e10411 = phi_22158_;
                                                        let _e10413 = phi_22159_;
                                                        if _e10407 {
                                                            let _e10415 = local_96;
                                                            phi_22164_ = type_44(1u, _e10415);
                                                            phi_22165_ = false;
                                                            phi_22167_ = false;
                                                            phi_22168_ = false;
                                                            phi_22169_ = false;
                                                        } else {
                                                            phi_22164_ = type_44();
                                                            phi_22165_ = _e10409;
                                                            let _e16599 = local_144;
                                                            phi_22167_ = _e16599;
                                                            phi_22168_ = _e10411;
                                                            phi_22169_ = _e10413;
                                                        }
                                                        let _e10418 = phi_22164_;
                                                        let _e10420 = phi_22165_;
                                                        let _e10422 = phi_22167_;
                                                        let _e10424 = phi_22168_;
                                                        let _e10426 = phi_22169_;
                                                        if _e10420 {
                                                            phi_22174_ = type_44(0u, type_44().member_1);
                                                            phi_22176_ = false;
                                                            phi_22177_ = false;
                                                            phi_22178_ = false;
                                                            phi_22179_ = true;
                                                        } else {
                                                            phi_22174_ = _e10418;
                                                            phi_22176_ = _e10422;
                                                            phi_22177_ = _e10424;
                                                            phi_22178_ = _e10426;
                                                            phi_22179_ = _e10407;
                                                        }
                                                        let _e10430 = phi_22174_;
                                                        let _e10432 = phi_22176_;
                                                        let _e10434 = phi_22177_;
                                                        let _e10436 = phi_22178_;
                                                        let _e10438 = phi_22179_;
                                                        if _e10432 {
                                                            let _e16609 = local_145;
                                                            phi_22191_ = _e16609;
                                                            phi_22192_ = true;
                                                            phi_22193_ = false;
                                                            phi_22194_ = false;
                                                        } else {
                                                            let _e16611 = local_146;
                                                            phi_22191_ = _e16611;
                                                            phi_22192_ = _e10434;
                                                            phi_22193_ = _e10436;
                                                            phi_22194_ = _e10438;
                                                        }
                                                        let _e10440 = phi_22191_;
                                                        let _e10442 = phi_22192_;
                                                        let _e10444 = phi_22193_;
                                                        let _e10446 = phi_22194_;
                                                        if _e10442 {
                                                            phi_22199_ = type_44(1u, _e10440);
                                                            phi_22200_ = false;
                                                            phi_22201_ = false;
                                                        } else {
                                                            phi_22199_ = type_44();
                                                            phi_22200_ = _e10444;
                                                            phi_22201_ = _e10446;
                                                        }
                                                        let _e10449 = phi_22199_;
                                                        let _e10451 = phi_22200_;
                                                        let _e10453 = phi_22201_;
                                                        if _e10451 {
                                                            phi_22206_ = type_44(0u, type_44().member_1);
                                                            phi_22207_ = true;
                                                        } else {
                                                            phi_22206_ = _e10430;
                                                            phi_22207_ = _e10453;
                                                        }
                                                        let _e10457 = phi_22206_;
                                                        let _e10459 = phi_22207_;
                                                        if _e10459 {
                                                            phi_22211_ = _e10457;
                                                        } else {
                                                            phi_22211_ = _e10449;
                                                        }
                                                        let _e10461 = phi_22211_;
                                                        let _e10464 = (_e10461.member != 0u);
                                                        if _e10464 {
                                                            phi_22218_ = false;
                                                        } else {
                                                            phi_22218_ = true;
                                                        }
                                                        let _e10466 = phi_22218_;
                                                        phi_22219_ = _e10461.member_1;
                                                        phi_22220_ = _e10466;
                                                        phi_22221_ = _e10464;
                                                        phi_22222_ = false;
                                                    } else {
                                                        phi_22219_ = f32();
                                                        phi_22220_ = false;
                                                        phi_22221_ = false;
                                                        phi_22222_ = true;
                                                    }
                                                    let _e10468 = phi_22219_;
                                                    let _e10470 = phi_22220_;
                                                    let _e10472 = phi_22221_;
                                                    let _e10474 = phi_22222_;
                                                    phi_22223_ = _e9049;
                                                    phi_22224_ = _e9050;
                                                    phi_22225_ = _e10468;
                                                    phi_22226_ = _e10470;
                                                    phi_22227_ = _e10472;
                                                    phi_22228_ = _e10474;
                                                }
                                                let _e10476 = phi_22223_;
                                                let _e10478 = phi_22224_;
                                                let _e10480 = phi_22225_;
                                                let _e10482 = phi_22226_;
                                                let _e10484 = phi_22227_;
                                                let _e10486 = phi_22228_;
                                                phi_22229_ = _e10476;
                                                phi_22230_ = _e10478;
                                                phi_22231_ = _e10480;
                                                phi_22232_ = _e9045;
                                                phi_22233_ = _e10482;
                                                phi_22234_ = _e10484;
                                                phi_22235_ = _e10486;
                                            }
                                            let _e10488 = phi_22229_;
                                            let _e10490 = phi_22230_;
                                            let _e10492 = phi_22231_;
                                            let _e10494 = phi_22232_;
                                            let _e10496 = phi_22233_;
                                            let _e10498 = phi_22234_;
                                            let _e10500 = phi_22235_;
                                            if _e10494 {
                                                phi_22239_ = false;
                                                phi_22240_ = false;
                                                phi_22241_ = false;
                                            } else {
                                                phi_22239_ = _e10496;
                                                phi_22240_ = _e10498;
                                                phi_22241_ = _e10500;
                                            }
                                            let _e10502 = phi_22239_;
                                            let _e10504 = phi_22240_;
                                            let _e10506 = phi_22241_;
                                            phi_22242_ = _e8314;
                                            phi_22243_ = _e10488;
                                            phi_22244_ = _e10490;
                                            phi_22245_ = _e10492;
                                            phi_22246_ = _e8314;
                                            phi_22247_ = _e10494;
                                            phi_22248_ = _e10502;
                                            phi_22249_ = _e10504;
                                            phi_22250_ = _e10506;
                                        } else {
                                            phi_22242_ = type_47();
                                            phi_22243_ = bool();
                                            phi_22244_ = f32();
                                            phi_22245_ = f32();
                                            phi_22246_ = type_47();
                                            phi_22247_ = true;
                                            phi_22248_ = false;
                                            phi_22249_ = false;
                                            phi_22250_ = false;
                                        }
                                        let _e10508 = phi_22242_;
                                        let _e10510 = phi_22243_;
                                        let _e10512 = phi_22244_;
                                        let _e10514 = phi_22245_;
                                        let _e10516 = phi_22246_;
                                        let _e10518 = phi_22247_;
                                        let _e10520 = phi_22248_;
                                        let _e10522 = phi_22249_;
                                        let _e10524 = phi_22250_;
                                        if _e10518 {
                                            phi_22254_ = true;
                                            phi_22255_ = false;
                                            phi_22256_ = false;
                                        } else {
                                            phi_22254_ = _e10520;
                                            phi_22255_ = _e10522;
                                            phi_22256_ = _e10524;
                                        }
                                        let _e10526 = phi_22254_;
                                        let _e10528 = phi_22255_;
                                        let _e10530 = phi_22256_;
                                        phi_22257_ = _e10508;
                                        phi_22258_ = _e10510;
                                        phi_22259_ = _e10512;
                                        phi_22260_ = _e10514;
                                        phi_22261_ = _e10516;
                                        phi_22262_ = _e10526;
                                        phi_22263_ = false;
                                        phi_22264_ = _e10528;
                                        phi_22265_ = _e10530;
                                    } else {
                                        phi_22257_ = type_47();
                                        phi_22258_ = bool();
                                        phi_22259_ = f32();
                                        phi_22260_ = f32();
                                        phi_22261_ = type_47();
                                        phi_22262_ = false;
                                        phi_22263_ = true;
                                        phi_22264_ = false;
                                        phi_22265_ = false;
                                    }
                                    let _e10532 = phi_22257_;
                                    let _e10534 = phi_22258_;
                                    let _e10536 = phi_22259_;
                                    let _e10538 = phi_22260_;
                                    let _e10540 = phi_22261_;
                                    let _e10542 = phi_22262_;
                                    let _e10544 = phi_22263_;
                                    let _e10546 = phi_22264_;
                                    let _e10548 = phi_22265_;
                                    local_97 = _e10544;
                                    local_147 = _e10546;
                                    local_148 = _e10548;
                                    local_98 = _e10534;
                                    local_99 = _e10532;
                                    local_100 = _e10538;
                                    local_101 = _e10536;
                                    local_102 = _e10538;
                                    local_103 = _e10538;
                                    local_104 = _e10540;
                                    continue;
                                    continuing {
                                        phi_18068_ = _e8037;
                                        break if !(_e10542);
                                    }
                                }
                                let _e10551 = local_97;
                                if _e10551 {
                                    phi_22270_ = type_44(0u, type_44().member_1);
                                    phi_22271_ = false;
                                    phi_22272_ = false;
                                } else {
                                    phi_22270_ = type_44();
                                    let _e16667 = local_147;
                                    phi_22271_ = _e16667;
                                    let _e16670 = local_148;
                                    phi_22272_ = _e16670;
                                }
                                let _e10555 = phi_22270_;
                                let _e10557 = phi_22271_;
                                let _e10559 = phi_22272_;
                                if _e10557 {
                                    let _e10561 = local_98;
                                    if _e10561 {
                                        let _e10563 = local_99;
                                        let _e10566 = local_100;
                                        let _e10569 = local_101;
                                        if ((_e10563.member_1 - _e10566) <= _e10569) {
                                            let _e10572 = local_102;
                                            phi_22286_ = type_44(1u, _e10572);
                                            phi_22287_ = false;
                                        } else {
                                            phi_22286_ = type_44();
                                            phi_22287_ = true;
                                        }
                                        let _e10575 = phi_22286_;
                                        let _e10577 = phi_22287_;
                                        phi_22288_ = _e10575;
                                        phi_22289_ = _e10577;
                                    } else {
                                        phi_22288_ = type_44();
                                        phi_22289_ = true;
                                    }
                                    let _e10579 = phi_22288_;
                                    let _e10581 = phi_22289_;
                                    if _e10581 {
                                        let _e10583 = local_103;
                                        phi_22294_ = type_44(2u, _e10583);
                                    } else {
                                        phi_22294_ = _e10579;
                                    }
                                    let _e10586 = phi_22294_;
                                    phi_22295_ = _e10586;
                                    phi_22296_ = false;
                                } else {
                                    phi_22295_ = type_44();
                                    phi_22296_ = _e10559;
                                }
                                let _e10588 = phi_22295_;
                                let _e10590 = phi_22296_;
                                if _e10590 {
                                    let _e10592 = local_104;
                                    phi_22302_ = type_44(1u, _e10592.member);
                                    phi_22303_ = true;
                                } else {
                                    phi_22302_ = _e10588;
                                    phi_22303_ = _e10557;
                                }
                                let _e10596 = phi_22302_;
                                let _e10598 = phi_22303_;
                                phi_22307_ = _e10596;
                                phi_22308_ = _e10555;
                                phi_22309_ = _e10598;
                            } else {
                                phi_22307_ = _e7883;
                                phi_22308_ = type_44();
                                phi_22309_ = true;
                            }
                            let _e10600 = phi_22307_;
                            let _e10602 = phi_22308_;
                            let _e10604 = phi_22309_;
                            phi_22313_ = _e10600;
                            phi_22314_ = _e10602;
                            phi_22315_ = _e10604;
                        }
                        let _e10608 = phi_22313_;
                        let _e10610 = phi_22314_;
                        let _e10612 = phi_22315_;
                        if _e10612 {
                            phi_22319_ = _e10608;
                        } else {
                            phi_22319_ = _e10610;
                        }
                        let _e10614 = phi_22319_;
                        if (_e10614.member == 1u) {
                            if (_e10614.member_1 > _e5597) {
                                phi_22330_ = false;
                            } else {
                                phi_22330_ = true;
                            }
                            let _e10620 = phi_22330_;
                            phi_22331_ = _e10620;
                        } else {
                            phi_22331_ = true;
                        }
                        let _e10622 = phi_22331_;
                        if _e10622 {
                            phi_22335_ = false;
                        } else {
                            phi_22335_ = true;
                        }
                        let _e10624 = phi_22335_;
                        if _e10624 {
                            phi_22339_ = 1u;
                        } else {
                            phi_22339_ = 0u;
                        }
                        let _e10626 = phi_22339_;
                        phi_22343_ = type_45(_e10614, _e10626);
                    }
                    let _e15166 = phi_22343_;
                    switch bitcast<i32>(_e15166.member.member) {
                        case 0: {
                            phi_22361_ = type_28(0u, _e15166.member_1, array<u32, 2>(0u, 0u), false);
                            break;
                        }
                        case 1: {
                            let _e15177 = function_(_e15166.member.member_1);
                            phi_22361_ = type_28(0u, _e15166.member_1, _e15177, true);
                            break;
                        }
                        case 2: {
                            let _e15173 = function_(_e15166.member.member_1);
                            phi_22361_ = type_28(1u, _e15166.member_1, _e15173, true);
                            break;
                        }
                        default: {
                            phi_22361_ = type_28();
                            break;
                        }
                    }
                    let _e15181 = phi_22361_;
                    let _e15185 = params.member.member.member_12;
                    let _e15186 = bitcast<u32>(_e15185);
                    let _e15187 = (_e15186 & 2147483647u);
                    if (_e15187 < 8388608u) {
                        phi_22377_ = array<u32, 2>(0u, 0u);
                    } else {
                        phi_22377_ = array<u32, 2>((_e15186 << bitcast<u32>(29i)), ((_e15186 ^ _e15187) | ((_e15187 >> bitcast<u32>(3i)) + 939524096u)));
                    }
                    let _e15198 = phi_22377_;
                    if (_e15181.member_2[0] == _e15198[0]) {
                        let _e15204 = params.member.member.member_12;
                        let _e15205 = bitcast<u32>(_e15204);
                        let _e15206 = (_e15205 & 2147483647u);
                        if (_e15206 < 8388608u) {
                            phi_22398_ = array<u32, 2>(0u, 0u);
                        } else {
                            phi_22398_ = array<u32, 2>((_e15205 << bitcast<u32>(29i)), ((_e15205 ^ _e15206) | ((_e15206 >> bitcast<u32>(3i)) + 939524096u)));
                        }
                        let _e15217 = phi_22398_;
                        phi_22401_ = (_e15181.member_2[1] == _e15217[1]);
                    } else {
                        phi_22401_ = false;
                    }
                    let _e15221 = phi_22401_;
                    let _e15223 = params.member.member.member_1;
                    if ((_e15223 & 128u) != 0u) {
                        phi_22417_ = true;
                    } else {
                        let _e15227 = params.member.member.member_1;
                        if ((_e15227 & 64u) != 0u) {
                            phi_22416_ = _e15221;
                        } else {
                            phi_22416_ = false;
                        }
                        let _e15231 = phi_22416_;
                        phi_22417_ = _e15231;
                    }
                    let _e15233 = phi_22417_;
                    if _e15181.member_3 {
                        if _e15233 {
                            phi_22425_ = false;
                        } else {
                            phi_22425_ = true;
                        }
                        let _e15236 = phi_22425_;
                        phi_22426_ = _e15236;
                    } else {
                        phi_22426_ = true;
                    }
                    let _e15238 = phi_22426_;
                    if _e15238 {
                        phi_22431_ = _e15181.member;
                    } else {
                        phi_22431_ = 1u;
                    }
                    let _e15241 = phi_22431_;
                    phi_22436_ = type_28(_e15241, _e15181.member_1, _e15181.member_2, _e15181.member_3);
                } else {
                    phi_22436_ = _e5562;
                }
                let _e15247 = phi_22436_;
                if _e15247.member_3 {
                    phi_22443_ = (_e15247.member == 0u);
                } else {
                    phi_22443_ = false;
                }
                let _e15252 = phi_22443_;
                if _e15252 {
                    let _e15261 = (_e15247.member_2[1] >> bitcast<u32>(20i));
                    if (_e15261 <= 896u) {
                        phi_22468_ = 0u;
                    } else {
                        phi_22468_ = ((((_e15261 - 896u) << bitcast<u32>(23i)) | ((_e15247.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e15247.member_2[0] >> bitcast<u32>(29i)));
                    }
                    let _e15276 = phi_22468_;
                    let _e15278 = atomicMin((&earliest.member[0u]), _e15276);
                }
                phi_22472_ = type_20(_e269, 0u, _e279, _e282, _e15247.member_2, _e15247.member_1);
                phi_22473_ = _e15252;
                phi_22474_ = (_e15247.member != 0u);
            } else {
                phi_22472_ = type_20(_e269, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_22473_ = false;
                phi_22474_ = false;
            }
            let _e15280 = phi_22472_;
            let _e15282 = phi_22473_;
            let _e15284 = phi_22474_;
            let _e15287 = params.member.member.member_1;
            if ((_e15287 & 16u) != 0u) {
                if (_e185 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e15282 {
                    let _e15293 = atomicAdd((&counters[0u]), 1u);
                    phi_22493_ = _e15293;
                } else {
                    phi_22493_ = 0u;
                }
                let _e15295 = phi_22493_;
                workgroupBarrier();
                if (_e185 == 0u) {
                    let _e15298 = atomicLoad((&counters[0u]));
                    if (_e15298 > 0u) {
                        let _e15301 = atomicAdd((&contacts.member[0u]), _e15298);
                        atomicStore((&counters[1u]), _e15301);
                    }
                }
                workgroupBarrier();
                let _e15304 = atomicLoad((&counters[1u]));
                let _e15305 = (_e15304 + _e15295);
                if _e15282 {
                    let _e15308 = params.member.member_1.member_3;
                    if (_e15305 < _e15308) {
                        let _e15310 = (7u * _e15305);
                        atomicStore((&contacts.member[(4u + _e15310)]), _e15280.member);
                        atomicStore((&contacts.member[(_e15310 + 5u)]), _e15280.member_1);
                        atomicStore((&contacts.member[(_e15310 + 6u)]), _e15280.member_2);
                        atomicStore((&contacts.member[(_e15310 + 7u)]), _e15280.member_3);
                        atomicStore((&contacts.member[(_e15310 + 8u)]), _e15280.member_4[0]);
                        atomicStore((&contacts.member[(_e15310 + 9u)]), _e15280.member_4[1]);
                        atomicStore((&contacts.member[(_e15310 + 10u)]), _e15280.member_5);
                    }
                }
            }
            workgroupBarrier();
            if (_e185 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e15284 {
                let _e15337 = atomicAdd((&counters[0u]), 1u);
                phi_22560_ = _e15337;
            } else {
                phi_22560_ = 0u;
            }
            let _e15339 = phi_22560_;
            workgroupBarrier();
            if (_e185 == 0u) {
                let _e15342 = atomicLoad((&counters[0u]));
                if (_e15342 > 0u) {
                    let _e15345 = atomicAdd((&undecided.member[0u]), _e15342);
                    atomicStore((&counters[1u]), _e15345);
                }
            }
            workgroupBarrier();
            let _e15348 = atomicLoad((&counters[1u]));
            let _e15349 = (_e15348 + _e15339);
            if _e15284 {
                let _e15355 = params.member.member_2.member.member_1;
                if (_e15349 < _e15355) {
                    let _e15357 = (2u * _e15349);
                    atomicStore((&undecided.member[(4u + _e15357)]), _e15280.member_2);
                    atomicStore((&undecided.member[(_e15357 + 5u)]), _e15280.member_3);
                }
            }
        }
        continue;
        continuing {
            phi_419_ = _e255;
            break if !(_e261);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_14(id, n, lane);
}
