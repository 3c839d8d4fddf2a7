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

struct type_20 {
    member: u32,
    member_1: u32,
    member_2: u32,
}

struct type_21 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_22 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_24 {
    member: array<type_22>,
}

struct type_27 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_28 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
    member_2: array<f32, 4>,
}

struct type_29 {
    member: type_27,
    member_1: f32,
}

struct type_30 {
    member: u32,
    member_1: f32,
}

struct type_31 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_34 {
    member: array<f32, 4>,
    member_1: f32,
    member_2: f32,
    member_3: f32,
}

struct type_37 {
    member: type_9,
    member_1: u32,
    member_2: u32,
    member_3: u32,
}

struct type_38 {
    member: type_7,
    member_1: type_8,
    member_2: type_37,
}

struct type_39 {
    member: type_38,
}

struct type_45 {
    member: f32,
    member_1: f32,
    member_2: bool,
}

struct type_49 {
    member: array<atomic<u32>>,
}

@group(0) @binding(4) 
var<storage> input: type_11;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(1) 
var<storage> paths: type_24;
@group(0) @binding(3) 
var<storage> elements: type_11;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_49;
@group(0) @binding(0) 
var<storage> params: type_39;
@group(0) @binding(2) 
var<storage> positions: type_11;
@group(0) @binding(6) 
var<storage, read_write> undecided: type_49;
@group(0) @binding(7) 
var<storage, read_write> earliest: type_49;
var<private> global: type_9 = type_9(2u, u32());

fn function_(param: f32, param_1: f32) -> f32 {
    return select(param, param_1, select((param_1 >= param), true, (param != param)));
}

fn function_1(param_2: array<f32, 3>, param_3: array<f32, 3>) -> array<f32, 3> {
    let _e24 = ((((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])) < (((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])));
    return array<f32, 3>(select(param_2[0], param_3[0], _e24), select(param_2[1], param_3[1], _e24), select(param_2[2], param_3[2], _e24));
}

fn function_2(param_4: array<f32, 3>, param_5: array<f32, 3>, param_6: array<f32, 3>, param_7: u32) -> array<f32, 3> {
    var phi_769_: array<array<f32, 3>, 4>;

    let _e9 = (param_4[0] - param_5[0]);
    let _e12 = (param_4[1] - param_5[1]);
    let _e15 = (param_4[2] - param_5[2]);
    if (param_7 != 0u) {
        let _e151 = ((((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        let _e155 = select(0f, select(1f, _e151, (_e151 < 1f)), (_e151 > 0f));
        let _e191 = ((((param_4[0] * param_6[0]) + (param_4[1] * param_6[1])) + (param_4[2] * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        let _e195 = select(0f, select(1f, _e191, (_e191 < 1f)), (_e191 > 0f));
        let _e228 = ((((_e9 * param_6[0]) + (_e12 * param_6[1])) + (_e15 * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        let _e232 = select(0f, select(1f, _e228, (_e228 < 1f)), (_e228 > 0f));
        let _e245 = (param_4[0] - param_6[0]);
        let _e248 = (param_4[1] - param_6[1]);
        let _e251 = (param_4[2] - param_6[2]);
        let _e271 = ((((_e245 * param_5[0]) + (_e248 * param_5[1])) + (_e251 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        let _e275 = select(0f, select(1f, _e271, (_e271 < 1f)), (_e271 > 0f));
        phi_769_ = array<array<f32, 3>, 4>(array<f32, 3>((param_4[0] - (param_5[0] * _e155)), (param_4[1] - (param_5[1] * _e155)), (param_4[2] - (param_5[2] * _e155))), array<f32, 3>((param_4[0] - (param_6[0] * _e195)), (param_4[1] - (param_6[1] * _e195)), (param_4[2] - (param_6[2] * _e195))), array<f32, 3>((_e9 - (param_6[0] * _e232)), (_e12 - (param_6[1] * _e232)), (_e15 - (param_6[2] * _e232))), array<f32, 3>((_e245 - (param_5[0] * _e275)), (_e248 - (param_5[1] * _e275)), (_e251 - (param_5[2] * _e275))));
    } else {
        let _e19 = (param_6[0] - param_5[0]);
        let _e22 = (param_6[1] - param_5[1]);
        let _e25 = (param_6[2] - param_5[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        let _e40 = select(0f, select(1f, _e36, (_e36 < 1f)), (_e36 > 0f));
        let _e47 = array<f32, 3>((_e9 - (_e19 * _e40)), (_e12 - (_e22 * _e40)), (_e15 - (_e25 * _e40)));
        let _e70 = ((((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        let _e74 = select(0f, select(1f, _e70, (_e70 < 1f)), (_e70 > 0f));
        let _e110 = ((((param_4[0] * param_6[0]) + (param_4[1] * param_6[1])) + (param_4[2] * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        let _e114 = select(0f, select(1f, _e110, (_e110 < 1f)), (_e110 > 0f));
        phi_769_ = array<array<f32, 3>, 4>(array<f32, 3>((param_4[0] - (param_5[0] * _e74)), (param_4[1] - (param_5[1] * _e74)), (param_4[2] - (param_5[2] * _e74))), array<f32, 3>((param_4[0] - (param_6[0] * _e114)), (param_4[1] - (param_6[1] * _e114)), (param_4[2] - (param_6[2] * _e114))), _e47, _e47);
    }
    let _e288 = phi_769_;
    let _e291 = function_1(_e288[0], _e288[1]);
    let _e293 = function_1(_e291, _e288[2]);
    let _e295 = function_1(_e293, _e288[3]);
    return _e295;
}

fn function_3(param_8: array<f32, 3>, param_9: array<f32, 3>, param_10: array<f32, 3>, param_11: u32) -> array<f32, 3> {
    var phi_397_: bool;
    var phi_430_: array<f32, 3>;
    var phi_431_: bool;
    var phi_432_: array<f32, 3>;
    var phi_433_: bool;
    var phi_438_: array<f32, 3>;

    let _e23 = (((param_9[0] * param_9[0]) + (param_9[1] * param_9[1])) + (param_9[2] * param_9[2]));
    let _e34 = (((param_9[0] * param_10[0]) + (param_9[1] * param_10[1])) + (param_9[2] * param_10[2]));
    let _e45 = (((param_10[0] * param_10[0]) + (param_10[1] * param_10[1])) + (param_10[2] * param_10[2]));
    let _e56 = (((param_8[0] * param_9[0]) + (param_8[1] * param_9[1])) + (param_8[2] * param_9[2]));
    let _e67 = (((param_8[0] * param_10[0]) + (param_8[1] * param_10[1])) + (param_8[2] * param_10[2]));
    let _e70 = ((_e23 * _e45) - (_e34 * _e34));
    let _e74 = (((_e56 * _e45) - (_e67 * _e34)) / _e70);
    let _e78 = (((_e67 * _e23) - (_e56 * _e34)) / _e70);
    if (param_11 != 0u) {
        let _e89 = (_e74 >= 0f);
        let _e90 = (_e78 >= 0f);
        let _e91 = (_e74 <= 1f);
        phi_397_ = select(select(bool(), select(bool(), select(bool(), (_e78 <= 1f), _e91), _e90), _e89), false, select(true, select(true, select(true, false, _e91), _e90), _e89));
    } else {
        let _e80 = (_e74 >= 0f);
        let _e81 = (_e78 >= 0f);
        phi_397_ = select(select(bool(), select(bool(), ((_e74 + _e78) <= 1f), _e81), _e80), false, select(true, select(true, false, _e81), _e80));
    }
    let _e101 = phi_397_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e101 {
            phi_430_ = array<f32, 3>((param_8[0] - ((param_9[0] * _e74) + (param_10[0] * _e78))), (param_8[1] - ((param_9[1] * _e74) + (param_10[1] * _e78))), (param_8[2] - ((param_9[2] * _e74) + (param_10[2] * _e78))));
            phi_431_ = false;
        } else {
            phi_430_ = array<f32, 3>();
            phi_431_ = true;
        }
        let _e129 = phi_430_;
        let _e131 = phi_431_;
        phi_432_ = _e129;
        phi_433_ = _e131;
    } else {
        phi_432_ = array<f32, 3>();
        phi_433_ = true;
    }
    let _e133 = phi_432_;
    let _e135 = phi_433_;
    if _e135 {
        let _e136 = function_2(param_8, param_9, param_10, param_11);
        phi_438_ = _e136;
    } else {
        phi_438_ = _e133;
    }
    let _e138 = phi_438_;
    return _e138;
}

fn function_4(param_12: f32) -> array<u32, 2> {
    let _e7 = bitcast<u32>(param_12);
    let _e8 = (_e7 & 2147483647u);
    let _e9 = (_e8 < 8388608u);
    return array<u32, 2>(select((_e7 << bitcast<u32>(29i)), 0u, _e9), select(((_e7 ^ _e8) | ((_e8 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e9));
}

fn function_5(param_13: ptr<function, type_34>, param_14: f32, param_15: f32, param_16: f32) -> bool {
    var phi_15935_: bool;
    var phi_15936_: bool;
    var phi_15941_: bool;

    let _e14 = (*param_13).member_3;
    let _e16 = (*param_13).member_3;
    let _e18 = (param_14 + (_e14 + _e16));
    if (_e18 < param_16) {
        let _e20 = (1f - param_15);
        let _e23 = (*param_13).member[0u];
        let _e26 = (*param_13).member[1u];
        let _e29 = (*param_13).member[2u];
        let _e32 = (*param_13).member[3u];
        let _e43 = ((((_e23 * _e20) + (_e26 * param_15)) * (_e20 * _e20)) + (((_e29 * _e20) + (_e32 * param_15)) * (param_15 * param_15)));
        let _e45 = select(param_15, _e18, (_e18 > param_15));
        let _e46 = (1f - _e45);
        let _e49 = (*param_13).member[0u];
        let _e52 = (*param_13).member[1u];
        let _e55 = (*param_13).member[2u];
        let _e58 = (*param_13).member[3u];
        let _e69 = ((((_e49 * _e46) + (_e52 * _e45)) * (_e46 * _e46)) + (((_e55 * _e46) + (_e58 * _e45)) * (_e45 * _e45)));
        let _e71 = (*param_13).member_1;
        let _e73 = (*param_13).member_1;
        let _e79 = (*param_13).member_1;
        if (select(_e43, -(_e43), (_e43 < 0f)) > _e79) {
            let _e84 = (select(_e69, -(_e69), (_e69 < 0f)) > (_e71 + _e73));
            phi_15935_ = select(bool(), ((_e43 > 0f) == (_e69 > 0f)), _e84);
            phi_15936_ = select(true, false, _e84);
        } else {
            phi_15935_ = bool();
            phi_15936_ = true;
        }
        let _e91 = phi_15935_;
        let _e93 = phi_15936_;
        phi_15941_ = select(_e91, false, _e93);
    } else {
        phi_15941_ = false;
    }
    let _e96 = phi_15941_;
    return _e96;
}

fn function_6(param_17: u32, param_18: u32, param_19: u32) -> type_9 {
    let _e11 = ((param_17 >> bitcast<u32>(31i)) != 0u);
    let _e18 = select(param_17, (~(param_17) + select(0u, 1u, (param_18 == 0u))), _e11);
    let _e19 = select(param_18, (~(param_18) + 1u), _e11);
    let _e21 = (_e18 >> bitcast<u32>(16i));
    let _e22 = (_e18 & 65535u);
    let _e24 = (param_19 >> bitcast<u32>(16i));
    let _e25 = (param_19 & 65535u);
    let _e30 = ((_e21 * _e25) + ((_e22 * _e25) >> bitcast<u32>(16i)));
    let _e41 = (_e18 * param_19);
    let _e43 = (_e19 >> bitcast<u32>(16i));
    let _e44 = (_e19 & 65535u);
    let _e46 = (param_19 >> bitcast<u32>(16i));
    let _e47 = (param_19 & 65535u);
    let _e52 = ((_e43 * _e47) + ((_e44 * _e47) >> bitcast<u32>(16i)));
    let _e64 = (_e41 + (((_e43 * _e46) + (_e52 >> bitcast<u32>(16i))) + (((_e44 * _e46) + (_e52 & 65535u)) >> bitcast<u32>(16i))));
    let _e72 = ((((((_e21 * _e24) + (_e30 >> bitcast<u32>(16i))) + (((_e22 * _e24) + (_e30 & 65535u)) >> bitcast<u32>(16i))) + select(0u, 1u, (_e64 < _e41))) << bitcast<u32>(1i)) | (_e64 >> bitcast<u32>(31i)));
    let _e77 = ((_e64 << bitcast<u32>(1i)) | ((_e19 * param_19) >> bitcast<u32>(31i)));
    let _e80 = ((param_17 >> bitcast<u32>(31i)) != 0u);
    return type_9(select(_e72, (~(_e72) + select(0u, 1u, (_e77 == 0u))), _e80), select(_e77, (~(_e77) + 1u), _e80));
}

fn function_7(param_20: array<type_9, 3>, param_21: u32) -> array<type_9, 2> {
    let _e17 = function_6(((param_20[1].member - param_20[0].member) - select(0u, 1u, (param_20[1].member_1 < param_20[0].member_1))), (param_20[1].member_1 - param_20[0].member_1), param_21);
    let _e20 = (param_20[0].member_1 + _e17.member_1);
    let _e38 = function_6(((param_20[2].member - param_20[1].member) - select(0u, 1u, (param_20[2].member_1 < param_20[1].member_1))), (param_20[2].member_1 - param_20[1].member_1), param_21);
    let _e41 = (param_20[1].member_1 + _e38.member_1);
    return array<type_9, 2>(type_9(((param_20[0].member + _e17.member) + select(0u, 1u, (_e20 < param_20[0].member_1))), _e20), type_9(((param_20[1].member + _e38.member) + select(0u, 1u, (_e41 < param_20[1].member_1))), _e41));
}

fn function_8(param_22: u32, param_23: u32, param_24: u32, param_25: u32) -> bool {
    return ((((param_24 - param_22) - select(0u, 1u, (param_25 < param_23))) >> bitcast<u32>(31i)) != 0u);
}

fn function_9(param_26: u32, param_27: u32, param_28: u32, param_29: u32) -> bool {
    return ((((param_28 - (~(param_26) + select(0u, 1u, (param_27 == 0u)))) - select(0u, 1u, (param_29 < (~(param_27) + 1u)))) >> bitcast<u32>(31i)) != 0u);
}

fn function_10(param_30: u32, param_31: u32, param_32: u32, param_33: u32) -> type_9 {
    let _e13 = ((param_30 >> bitcast<u32>(31i)) != 0u);
    let _e20 = select(param_30, (~(param_30) + select(0u, 1u, (param_31 == 0u))), _e13);
    let _e21 = select(param_31, (~(param_31) + 1u), _e13);
    let _e24 = ((param_32 >> bitcast<u32>(31i)) != 0u);
    let _e31 = select(param_32, (~(param_32) + select(0u, 1u, (param_33 == 0u))), _e24);
    let _e32 = select(param_33, (~(param_33) + 1u), _e24);
    let _e34 = (_e20 >> bitcast<u32>(16i));
    let _e35 = (_e20 & 65535u);
    let _e37 = (_e31 >> bitcast<u32>(16i));
    let _e38 = (_e31 & 65535u);
    let _e43 = ((_e34 * _e38) + ((_e35 * _e38) >> bitcast<u32>(16i)));
    let _e54 = (_e20 * _e31);
    let _e56 = (_e20 >> bitcast<u32>(16i));
    let _e57 = (_e20 & 65535u);
    let _e59 = (_e32 >> bitcast<u32>(16i));
    let _e60 = (_e32 & 65535u);
    let _e65 = ((_e56 * _e60) + ((_e57 * _e60) >> bitcast<u32>(16i)));
    let _e78 = (_e21 >> bitcast<u32>(16i));
    let _e79 = (_e21 & 65535u);
    let _e81 = (_e31 >> bitcast<u32>(16i));
    let _e82 = (_e31 & 65535u);
    let _e87 = ((_e78 * _e82) + ((_e79 * _e82) >> bitcast<u32>(16i)));
    let _e98 = (_e21 * _e31);
    let _e99 = ((_e20 * _e32) + _e98);
    let _e102 = (_e54 + (((_e56 * _e59) + (_e65 >> bitcast<u32>(16i))) + (((_e57 * _e59) + (_e65 & 65535u)) >> bitcast<u32>(16i))));
    let _e106 = (_e102 + (((_e78 * _e81) + (_e87 >> bitcast<u32>(16i))) + (((_e79 * _e81) + (_e87 & 65535u)) >> bitcast<u32>(16i))));
    let _e110 = (_e106 + select(0u, 1u, (_e99 < _e98)));
    let _e118 = ((_e110 << bitcast<u32>(2i)) | (_e99 >> bitcast<u32>(30i)));
    let _e123 = ((((((((_e34 * _e37) + (_e43 >> bitcast<u32>(16i))) + (((_e35 * _e37) + (_e43 & 65535u)) >> bitcast<u32>(16i))) + select(0u, 1u, (_e102 < _e54))) + select(0u, 1u, (_e106 < _e102))) + select(0u, 1u, (_e110 < _e106))) << bitcast<u32>(2i)) | (_e110 >> bitcast<u32>(30i)));
    let _e130 = (((param_30 >> bitcast<u32>(31i)) != 0u) != ((param_32 >> bitcast<u32>(31i)) != 0u));
    return type_9(select(_e123, (~(_e123) + select(0u, 1u, (_e118 == 0u))), _e130), select(_e118, (~(_e118) + 1u), _e130));
}

fn function_11(param_34: array<type_9, 2>, param_35: array<type_9, 2>) -> type_9 {
    let _e12 = function_10(param_34[0].member, param_34[0].member_1, param_35[1].member, param_35[1].member_1);
    let _e23 = function_10(param_34[1].member, param_34[1].member_1, param_35[0].member, param_35[0].member_1);
    return type_9(((_e12.member - _e23.member) - select(0u, 1u, (_e12.member_1 < _e23.member_1))), (_e12.member_1 - _e23.member_1));
}

fn function_12(param_36: f32, param_37: f32, param_38: f32) -> f32 {
    return (param_36 + ((param_37 - param_36) * param_38));
}

fn function_13(param_39: u32) -> type_9 {
    return type_9(0u, param_39);
}

fn function_14(param_40: u32, param_41: u32) -> type_9 {
    let _e4 = (param_41 + param_41);
    let _e9 = (_e4 + param_41);
    return type_9(((((param_40 + param_40) + select(0u, 1u, (_e4 < param_41))) + param_40) + select(0u, 1u, (_e9 < _e4))), _e9);
}

fn function_15(param_42: array<u32, 2>, param_43: i32) -> type_9 {
    var phi_15420_: type_9;
    var phi_15421_: type_9;
    var phi_15422_: type_9;
    var phi_15423_: type_9;
    var phi_15424_: type_9;
    var phi_15425_: bool;

    let _e24 = ((param_42[1] >> bitcast<u32>(20i)) & 2047u);
    let _e28 = ((param_42[1] & 1048575u) | select(1048576u, 0u, (_e24 == 0u)));
    let _e33 = ((bitcast<i32>(select(1u, _e24, (1u < _e24))) - 1015i) - param_43);
    let _e35 = (bitcast<u32>(_e33) % 32u);
    if (_e33 >= 64i) {
        phi_15424_ = type_9();
        phi_15425_ = true;
    } else {
        let _e37 = (_e33 <= -53i);
        if _e37 {
            phi_15423_ = type_9();
        } else {
            if (_e33 >= 32i) {
                phi_15422_ = type_9((param_42[0] << bitcast<u32>((_e35 & 31u))), 0u);
            } else {
                if (_e33 >= 0i) {
                    phi_15421_ = type_9(((_e28 << bitcast<u32>((_e35 & 31u))) | ((param_42[0] >> bitcast<u32>(1i)) >> bitcast<u32>(((31u - _e35) & 31u)))), (param_42[0] << bitcast<u32>((_e35 & 31u))));
                } else {
                    if (_e33 > -32i) {
                        let _e49 = bitcast<u32>(-(_e33));
                        phi_15420_ = type_9(bitcast<u32>((bitcast<i32>(_e28) >> bitcast<u32>((_e49 & 31u)))), ((param_42[0] >> bitcast<u32>((_e49 & 31u))) | ((_e28 << bitcast<u32>(((31u - _e49) & 31u))) << bitcast<u32>(1i))));
                    } else {
                        phi_15420_ = type_9(0u, (_e28 >> bitcast<u32>(((bitcast<u32>(-(_e33)) - 32u) & 31u))));
                    }
                    let _e67 = phi_15420_;
                    phi_15421_ = _e67;
                }
                let _e83 = phi_15421_;
                phi_15422_ = _e83;
            }
            let _e89 = phi_15422_;
            phi_15423_ = _e89;
        }
        let _e91 = phi_15423_;
        phi_15424_ = _e91;
        phi_15425_ = _e37;
    }
    let _e93 = phi_15424_;
    let _e95 = phi_15425_;
    let _e97 = select(_e93.member, 0u, _e95);
    let _e99 = select(_e93.member_1, 0u, _e95);
    let _e102 = ((param_42[1] >> bitcast<u32>(31i)) != 0u);
    return type_9(select(_e97, (~(_e97) + select(0u, 1u, (_e99 == 0u))), _e102), select(_e99, (~(_e99) + 1u), _e102));
}

fn function_16(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_28;
    var local_1: type_28;
    var local_2: array<type_16, 4>;
    var local_3: array<f32, 4>;
    var local_4: array<f32, 2>;
    var local_5: type_34;
    var local_6: array<f32, 4>;
    var local_7: type_27;
    var local_8: array<type_9, 3>;
    var local_9: array<type_9, 3>;
    var local_10: array<type_9, 3>;
    var local_11: array<type_9, 3>;
    var local_12: array<type_9, 3>;
    var local_13: array<type_9, 3>;
    var local_14: array<type_9, 3>;
    var local_15: array<type_9, 3>;
    var local_16: array<type_9, 3>;
    var local_17: array<type_9, 3>;
    var local_18: array<type_9, 3>;
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
    var local_39: array<u32, 4>;
    var local_40: array<array<f32, 3>, 4>;
    var local_41: array<array<f32, 3>, 4>;
    var phi_924_: u32;
    var phi_970_: u32;
    var phi_973_: type_9;
    var phi_1131_: type_21;
    var phi_1545_: type_27;
    var phi_3253_: array<array<array<type_9, 3>, 2>, 4>;
    var phi_3800_: array<array<array<type_9, 3>, 2>, 3>;
    var phi_5104_: array<type_9, 4>;
    var phi_5107_: bool;
    var phi_5109_: bool;
    var phi_5111_: bool;
    var phi_5113_: bool;
    var phi_5115_: type_20;
    var phi_5119_: u32;
    var phi_5121_: u32;
    var phi_5123_: u32;
    var phi_5125_: u32;
    var phi_5127_: u32;
    var phi_5136_: array<type_9, 4>;
    var phi_5139_: bool;
    var phi_5141_: bool;
    var phi_5145_: bool;
    var phi_5147_: bool;
    var phi_5149_: bool;
    var phi_5151_: bool;
    var phi_5153_: u32;
    var phi_5155_: u32;
    var phi_5157_: u32;
    var phi_5159_: u32;
    var phi_5161_: u32;
    var phi_5366_: bool;
    var phi_5367_: bool;
    var phi_5368_: bool;
    var phi_6010_: array<type_9, 4>;
    var phi_6011_: bool;
    var phi_6012_: u32;
    var phi_6013_: array<type_9, 4>;
    var phi_6014_: bool;
    var phi_6015_: bool;
    var phi_6017_: u32;
    var phi_6018_: u32;
    var phi_6019_: array<type_9, 4>;
    var phi_6020_: bool;
    var phi_6021_: bool;
    var phi_6023_: u32;
    var phi_6024_: u32;
    var phi_6025_: array<type_9, 4>;
    var phi_6026_: bool;
    var phi_6027_: bool;
    var phi_6029_: bool;
    var phi_6030_: bool;
    var phi_6031_: bool;
    var phi_6032_: bool;
    var phi_6033_: u32;
    var phi_6034_: u32;
    var phi_6035_: u32;
    var phi_6036_: u32;
    var phi_6037_: u32;
    var phi_6038_: bool;
    var phi_6039_: array<type_9, 4>;
    var phi_6040_: bool;
    var phi_6041_: bool;
    var phi_6043_: bool;
    var phi_6044_: bool;
    var phi_6045_: bool;
    var phi_6046_: bool;
    var phi_6047_: u32;
    var phi_6048_: u32;
    var phi_6049_: u32;
    var phi_6050_: u32;
    var phi_6051_: u32;
    var phi_6052_: bool;
    var phi_5137_: array<type_9, 4>;
    var phi_5140_: bool;
    var phi_5142_: bool;
    var phi_5146_: bool;
    var phi_5148_: bool;
    var phi_5150_: bool;
    var phi_5152_: bool;
    var phi_5154_: u32;
    var phi_5156_: u32;
    var phi_5158_: u32;
    var phi_5160_: u32;
    var phi_5162_: u32;
    var phi_6053_: bool;
    var local_42: bool;
    var local_43: bool;
    var local_44: array<type_9, 4>;
    var local_45: array<type_9, 4>;
    var local_46: array<type_9, 4>;
    var local_47: array<type_9, 4>;
    var local_48: array<type_9, 4>;
    var local_49: array<type_9, 4>;
    var local_50: array<type_9, 4>;
    var local_51: array<type_9, 4>;
    var local_52: array<type_9, 4>;
    var local_53: array<type_9, 4>;
    var local_54: array<type_9, 4>;
    var local_55: array<type_9, 4>;
    var local_56: u32;
    var local_57: u32;
    var local_58: u32;
    var local_59: u32;
    var local_60: array<type_9, 4>;
    var local_61: array<type_9, 4>;
    var local_62: array<type_9, 4>;
    var local_63: array<type_9, 4>;
    var local_64: array<type_9, 4>;
    var local_65: array<type_9, 4>;
    var local_66: bool;
    var local_67: bool;
    var local_68: u32;
    var local_69: bool;
    var local_70: u32;
    var local_71: array<type_9, 4>;
    var local_72: array<type_9, 4>;
    var local_73: array<type_9, 4>;
    var local_74: u32;
    var local_75: u32;
    var local_76: array<type_9, 4>;
    var local_77: array<type_9, 4>;
    var local_78: array<type_9, 4>;
    var phi_6637_: bool;
    var phi_6638_: bool;
    var phi_6639_: type_20;
    var phi_6640_: bool;
    var phi_6641_: type_20;
    var phi_6642_: bool;
    var phi_6643_: type_20;
    var phi_6644_: bool;
    var phi_6645_: type_20;
    var phi_6646_: bool;
    var phi_6647_: bool;
    var phi_6648_: type_20;
    var phi_6649_: bool;
    var local_79: u32;
    var local_80: u32;
    var local_81: array<type_9, 4>;
    var local_82: array<type_9, 4>;
    var local_83: array<type_9, 4>;
    var local_84: array<type_9, 4>;
    var local_85: array<type_9, 4>;
    var local_86: array<type_9, 4>;
    var local_87: array<type_9, 4>;
    var local_88: array<type_9, 4>;
    var phi_6690_: type_14;
    var phi_6693_: f32;
    var phi_6695_: f32;
    var phi_6697_: f32;
    var phi_6691_: type_14;
    var phi_6738_: type_15;
    var phi_6694_: f32;
    var phi_6696_: f32;
    var phi_6698_: f32;
    var local_89: f32;
    var local_90: u32;
    var local_91: u32;
    var local_92: u32;
    var phi_7156_: bool;
    var phi_7157_: bool;
    var phi_7158_: bool;
    var phi_7159_: type_20;
    var phi_7160_: type_20;
    var local_93: u32;
    var local_94: u32;
    var phi_7161_: bool;
    var phi_7162_: bool;
    var phi_7163_: bool;
    var phi_7164_: type_20;
    var phi_7165_: type_20;
    var phi_8312_: array<type_9, 2>;
    var phi_8341_: array<type_9, 2>;
    var phi_8370_: array<type_9, 2>;
    var phi_8384_: type_9;
    var phi_8706_: type_9;
    var phi_8707_: type_9;
    var phi_8708_: type_9;
    var phi_8709_: type_9;
    var phi_8823_: bool;
    var phi_8824_: bool;
    var phi_8825_: bool;
    var phi_8830_: u32;
    var phi_8831_: u32;
    var phi_8832_: bool;
    var phi_8833_: u32;
    var phi_8834_: bool;
    var phi_8835_: u32;
    var phi_8836_: bool;
    var phi_8841_: u32;
    var local_95: bool;
    var phi_8913_: bool;
    var phi_8914_: bool;
    var phi_8915_: bool;
    var phi_8916_: bool;
    var phi_8917_: bool;
    var phi_8924_: bool;
    var phi_8925_: bool;
    var phi_8926_: bool;
    var phi_8927_: bool;
    var phi_8928_: type_20;
    var phi_8929_: bool;
    var phi_8930_: bool;
    var phi_8931_: type_20;
    var phi_8932_: bool;
    var phi_8933_: bool;
    var phi_8934_: bool;
    var phi_8935_: bool;
    var phi_8936_: bool;
    var phi_8937_: bool;
    var phi_8938_: bool;
    var phi_8939_: bool;
    var phi_8940_: type_20;
    var phi_8941_: bool;
    var phi_8942_: bool;
    var phi_8943_: type_20;
    var phi_8944_: bool;
    var phi_8945_: bool;
    var phi_8946_: bool;
    var phi_8947_: bool;
    var local_96: u32;
    var local_97: u32;
    var local_98: u32;
    var local_99: u32;
    var local_100: u32;
    var local_101: u32;
    var phi_8998_: u32;
    var phi_8999_: u32;
    var phi_9000_: bool;
    var phi_9001_: bool;
    var phi_9002_: u32;
    var phi_9003_: u32;
    var phi_9004_: bool;
    var phi_9005_: bool;
    var phi_9006_: bool;
    var phi_9007_: bool;
    var phi_9008_: u32;
    var phi_9009_: u32;
    var phi_9010_: bool;
    var phi_9011_: bool;
    var phi_9012_: bool;
    var phi_9279_: array<type_9, 4>;
    var phi_9280_: array<type_9, 4>;
    var phi_9281_: bool;
    var phi_9282_: bool;
    var phi_9283_: array<type_9, 4>;
    var phi_9284_: bool;
    var phi_9285_: bool;
    var phi_9286_: bool;
    var phi_9287_: bool;
    var phi_9288_: u32;
    var phi_9289_: u32;
    var phi_9290_: bool;
    var phi_9291_: bool;
    var phi_9292_: bool;
    var phi_9293_: bool;
    var phi_9294_: bool;
    var phi_9295_: bool;
    var phi_5105_: array<type_9, 4>;
    var phi_5108_: bool;
    var phi_5110_: bool;
    var phi_5112_: bool;
    var phi_5114_: bool;
    var phi_5116_: type_20;
    var phi_5120_: u32;
    var phi_5122_: u32;
    var phi_5124_: u32;
    var phi_5126_: u32;
    var phi_5128_: u32;
    var phi_9296_: bool;
    var phi_9297_: type_20;
    var phi_9298_: bool;
    var phi_9299_: bool;
    var phi_9300_: bool;
    var phi_9301_: bool;
    var phi_9302_: bool;
    var phi_9303_: bool;
    var phi_9304_: bool;
    var local_102: bool;
    var local_103: bool;
    var local_104: bool;
    var local_105: bool;
    var local_106: bool;
    var local_107: bool;
    var local_108: bool;
    var local_109: bool;
    var local_110: bool;
    var local_111: bool;
    var local_112: bool;
    var local_113: bool;
    var local_114: bool;
    var local_115: bool;
    var phi_9346_: type_9;
    var phi_9347_: bool;
    var phi_9348_: bool;
    var phi_9349_: bool;
    var local_116: type_20;
    var phi_9411_: bool;
    var phi_9412_: bool;
    var phi_9413_: bool;
    var phi_9414_: bool;
    var phi_9419_: bool;
    var phi_9453_: array<u32, 2>;
    var phi_9456_: type_31;
    var phi_9457_: bool;
    var phi_9464_: type_31;
    var phi_9465_: type_31;
    var phi_9466_: bool;
    var phi_9467_: type_31;
    var phi_9468_: bool;
    var phi_9469_: type_31;
    var phi_9470_: bool;
    var phi_9741_: bool;
    var phi_9835_: type_29;
    var phi_9836_: bool;
    var phi_9837_: type_29;
    var phi_9838_: bool;
    var phi_9839_: type_29;
    var phi_9840_: bool;
    var phi_9845_: type_29;
    var phi_10570_: bool;
    var phi_10582_: f32;
    var phi_10653_: type_14;
    var phi_10656_: f32;
    var phi_10654_: type_14;
    var phi_10697_: type_15;
    var phi_10657_: f32;
    var local_117: f32;
    var phi_10710_: f32;
    var phi_10741_: type_9;
    var phi_10744_: u32;
    var phi_10811_: u32;
    var phi_10812_: u32;
    var phi_10745_: u32;
    var phi_10813_: u32;
    var phi_10869_: type_9;
    var phi_11025_: type_45;
    var phi_11026_: bool;
    var phi_11027_: type_45;
    var phi_11028_: bool;
    var phi_11059_: type_9;
    var phi_11062_: f32;
    var phi_11064_: f32;
    var phi_11066_: f32;
    var phi_11176_: bool;
    var phi_11183_: f32;
    var phi_11184_: bool;
    var phi_11063_: f32;
    var phi_11065_: f32;
    var phi_11067_: f32;
    var phi_11185_: f32;
    var phi_11186_: bool;
    var phi_11187_: bool;
    var local_118: bool;
    var local_119: f32;
    var local_120: f32;
    var phi_11192_: f32;
    var phi_11208_: type_9;
    var phi_11211_: f32;
    var phi_11276_: f32;
    var phi_11277_: bool;
    var phi_11278_: bool;
    var phi_11279_: bool;
    var phi_11280_: f32;
    var phi_11212_: f32;
    var phi_11281_: bool;
    var phi_11282_: bool;
    var phi_11283_: bool;
    var phi_11284_: bool;
    var local_121: bool;
    var local_122: bool;
    var local_123: bool;
    var local_124: bool;
    var local_125: f32;
    var phi_11298_: f32;
    var phi_11300_: type_45;
    var phi_12137_: array<type_16, 4>;
    var phi_12157_: type_9;
    var phi_12160_: bool;
    var phi_12161_: bool;
    var phi_12212_: bool;
    var phi_12213_: bool;
    var local_126: bool;
    var local_127: bool;
    var phi_12227_: u32;
    var phi_12228_: u32;
    var phi_12229_: bool;
    var phi_12260_: bool;
    var phi_12261_: bool;
    var phi_12262_: bool;
    var phi_12263_: bool;
    var phi_12264_: bool;
    var phi_12265_: bool;
    var phi_12266_: bool;
    var phi_12267_: bool;
    var phi_12268_: bool;
    var phi_12269_: bool;
    var phi_12270_: bool;
    var phi_12271_: bool;
    var phi_12272_: type_45;
    var phi_12273_: bool;
    var phi_12274_: type_45;
    var phi_12275_: bool;
    var phi_12276_: bool;
    var phi_12277_: bool;
    var phi_12278_: bool;
    var phi_12279_: type_45;
    var phi_12280_: bool;
    var phi_12281_: type_45;
    var phi_12282_: bool;
    var phi_12283_: bool;
    var phi_12284_: bool;
    var phi_12285_: bool;
    var phi_12286_: bool;
    var phi_12294_: type_45;
    var phi_12295_: bool;
    var phi_12296_: type_45;
    var phi_12297_: bool;
    var phi_12298_: bool;
    var phi_12299_: bool;
    var phi_12300_: bool;
    var phi_12301_: bool;
    var phi_12724_: type_9;
    var phi_12727_: f32;
    var phi_12729_: f32;
    var phi_12731_: f32;
    var phi_12733_: f32;
    var phi_12735_: bool;
    var phi_12737_: u32;
    var phi_12888_: array<f32, 3>;
    var phi_12954_: type_14;
    var phi_12957_: f32;
    var phi_12955_: type_14;
    var phi_12998_: type_15;
    var phi_12958_: f32;
    var local_128: f32;
    var phi_13011_: f32;
    var phi_13134_: type_28;
    var phi_13135_: bool;
    var phi_13136_: type_28;
    var phi_13137_: bool;
    var phi_13145_: type_28;
    var phi_13316_: bool;
    var phi_13317_: bool;
    var phi_13318_: bool;
    var phi_13319_: bool;
    var phi_13320_: bool;
    var phi_13321_: bool;
    var phi_13622_: bool;
    var phi_13623_: bool;
    var phi_13624_: bool;
    var phi_13625_: bool;
    var phi_13626_: bool;
    var phi_13627_: bool;
    var phi_13635_: bool;
    var phi_13742_: f32;
    var phi_13743_: bool;
    var phi_13744_: f32;
    var phi_13745_: bool;
    var phi_13746_: f32;
    var phi_13747_: bool;
    var phi_13748_: bool;
    var phi_13810_: f32;
    var phi_13811_: bool;
    var phi_13812_: f32;
    var phi_13813_: bool;
    var phi_13814_: f32;
    var phi_13815_: bool;
    var phi_13816_: bool;
    var phi_13883_: f32;
    var phi_13884_: bool;
    var phi_13885_: f32;
    var phi_13886_: bool;
    var phi_13887_: f32;
    var phi_13888_: bool;
    var phi_13889_: bool;
    var phi_13951_: f32;
    var phi_13952_: bool;
    var phi_13953_: f32;
    var phi_13954_: bool;
    var phi_13955_: f32;
    var phi_13956_: bool;
    var phi_13957_: bool;
    var phi_14486_: f32;
    var phi_14487_: f32;
    var phi_14488_: bool;
    var phi_14490_: f32;
    var phi_14491_: f32;
    var phi_14492_: f32;
    var phi_14494_: bool;
    var phi_14495_: bool;
    var phi_14497_: bool;
    var phi_14498_: f32;
    var phi_14499_: f32;
    var phi_14500_: f32;
    var phi_14502_: bool;
    var phi_14503_: bool;
    var phi_14504_: bool;
    var phi_14506_: bool;
    var phi_14507_: f32;
    var phi_14508_: f32;
    var phi_14509_: f32;
    var phi_14511_: bool;
    var phi_14512_: bool;
    var phi_14513_: bool;
    var phi_14515_: bool;
    var phi_14848_: f32;
    var phi_14850_: u32;
    var phi_14851_: f32;
    var phi_14852_: bool;
    var phi_14853_: bool;
    var phi_14854_: bool;
    var phi_14855_: u32;
    var phi_14856_: f32;
    var phi_14857_: f32;
    var phi_14858_: f32;
    var phi_14859_: f32;
    var phi_14860_: bool;
    var phi_14861_: u32;
    var phi_14862_: bool;
    var phi_14863_: bool;
    var phi_14864_: bool;
    var phi_14865_: bool;
    var phi_14867_: bool;
    var phi_14895_: f32;
    var phi_14896_: f32;
    var phi_14897_: f32;
    var phi_14898_: f32;
    var phi_14899_: bool;
    var phi_14900_: u32;
    var phi_14901_: bool;
    var phi_14902_: bool;
    var phi_14903_: bool;
    var phi_14904_: bool;
    var phi_14906_: bool;
    var phi_12728_: f32;
    var phi_12730_: f32;
    var phi_12732_: f32;
    var phi_12734_: f32;
    var phi_12736_: bool;
    var phi_12738_: u32;
    var phi_14907_: f32;
    var phi_14909_: bool;
    var phi_14910_: bool;
    var phi_14911_: bool;
    var phi_14912_: bool;
    var phi_14914_: bool;
    var phi_14915_: bool;
    var local_129: bool;
    var local_130: bool;
    var local_131: bool;
    var local_132: bool;
    var local_133: bool;
    var local_134: bool;
    var local_135: bool;
    var local_136: bool;
    var local_137: f32;
    var local_138: bool;
    var local_139: f32;
    var local_140: f32;
    var phi_14983_: f32;
    var phi_14984_: bool;
    var phi_14985_: bool;
    var phi_14986_: bool;
    var phi_14987_: bool;
    var phi_14988_: bool;
    var phi_14989_: type_45;
    var phi_14990_: bool;
    var phi_14991_: f32;
    var phi_14992_: type_45;
    var phi_14993_: bool;
    var phi_14994_: bool;
    var phi_14995_: bool;
    var phi_14996_: bool;
    var phi_14997_: bool;
    var phi_14998_: bool;
    var local_141: bool;
    var local_142: bool;
    var local_143: type_45;
    var local_144: f32;
    var local_145: f32;
    var phi_15014_: type_30;
    var phi_15015_: bool;
    var local_146: f32;
    var phi_15021_: type_30;
    var phi_15022_: bool;
    var phi_15023_: bool;
    var phi_15024_: bool;
    var phi_15025_: bool;
    var local_147: bool;
    var local_148: type_45;
    var phi_15067_: type_30;
    var phi_15068_: type_30;
    var phi_15069_: bool;
    var phi_15113_: type_31;
    var phi_15153_: bool;
    var phi_15169_: bool;
    var phi_15188_: type_31;
    var phi_15189_: type_31;
    var phi_15190_: type_9;
    var phi_15221_: u32;
    var phi_15243_: u32;
    var phi_15309_: u32;
    var local_149: bool;
    var local_150: bool;
    var local_151: bool;
    var local_152: bool;
    var local_153: bool;
    var local_154: bool;
    var local_155: bool;
    var local_156: u32;
    var local_157: u32;
    var local_158: array<type_9, 4>;
    var local_159: u32;
    var local_160: u32;
    var local_161: u32;
    var local_162: u32;
    var local_163: bool;
    var local_164: bool;
    var local_165: bool;
    var local_166: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e161 = id_2;
    let _e162 = n_2;
    let _e163 = lane_2;
    let _e176 = ((_e161.y * _e162.x) + _e161.x);
    let _e179 = (_e162.x * _e162.y);
    let _e182 = params.member.member_1.member_2;
    let _e184 = input.member[0u];
    let _e186 = select(_e184, _e182, (_e182 < _e184));
    let _e188 = params.member.member_1.member_1;
    if (_e186 > _e188) {
        let _e191 = params.member.member_1.member_1;
        phi_924_ = (_e186 - _e191);
    } else {
        phi_924_ = 0u;
    }
    let _e194 = phi_924_;
    let _e196 = params.member.member_1.member;
    let _e198 = select(_e194, _e196, (_e196 < _e194));
    let _e200 = (_e198 / 64u);
    let _e204 = select(_e200, (_e200 + 1u), ((_e198 % 64u) > 0u));
    if (_e204 > _e176) {
        let _e206 = (_e204 - _e176);
        if (_e179 == 0u) {
            return;
        }
        let _e208 = (_e206 / _e179);
        if (_e179 == 0u) {
            return;
        }
        phi_970_ = select(_e208, (_e208 + 1u), ((_e206 % _e179) > 0u));
    } else {
        phi_970_ = 0u;
    }
    let _e215 = phi_970_;
    phi_973_ = type_9(0u, _e215);
    loop {
        let _e218 = phi_973_;
        let _e221 = (_e218.member < _e218.member_1);
        let _e234 = (bitcast<i32>(select(0u, 1u, _e221)) != 0i);
        if _e234 {
            let _e238 = (((_e176 + (select(type_9().member_1, _e218.member, _e221) * _e179)) * 64u) + _e163);
            if (_e238 < _e198) {
                let _e242 = params.member.member_1.member_1;
                let _e244 = (2u * (_e242 + _e238));
                let _e247 = input.member[(4u + _e244)];
                let _e250 = input.member[(_e244 + 5u)];
                let _e256 = params.member.member_2.member.member;
                if (_e256 == 0u) {
                    let _e272 = (3u * _e250);
                    let _e274 = elements.member[_e272];
                    let _e277 = elements.member[(_e272 + 1u)];
                    let _e280 = elements.member[(_e272 + 2u)];
                    phi_1131_ = type_21(0u, array<u32, 4>(_e247, _e274, _e277, _e280));
                } else {
                    let _e258 = (2u * _e247);
                    let _e259 = (2u * _e250);
                    let _e261 = elements.member[_e258];
                    let _e263 = elements.member[_e259];
                    let _e266 = elements.member[(_e258 + 1u)];
                    let _e269 = elements.member[(_e259 + 1u)];
                    phi_1131_ = type_21(1u, array<u32, 4>(_e261, _e266, _e263, _e269));
                }
                let _e284 = phi_1131_;
                local_39 = array<u32, 4>(_e284.member_1[0], _e284.member_1[1], _e284.member_1[2], _e284.member_1[3]);
                let _e293 = paths.member[_e284.member_1[0]];
                let _e307 = paths.member[_e284.member_1[1]];
                let _e321 = paths.member[_e284.member_1[2]];
                let _e335 = paths.member[_e284.member_1[3]];
                local_40 = array<array<f32, 3>, 4>(array<f32, 3>(_e293.member.x, _e293.member.y, _e293.member.z), array<f32, 3>(_e307.member.x, _e307.member.y, _e307.member.z), array<f32, 3>(_e321.member.x, _e321.member.y, _e321.member.z), array<f32, 3>(_e335.member.x, _e335.member.y, _e335.member.z));
                local_41 = array<array<f32, 3>, 4>(array<f32, 3>(_e293.member_1.x, _e293.member_1.y, _e293.member_1.z), array<f32, 3>(_e307.member_1.x, _e307.member_1.y, _e307.member_1.z), array<f32, 3>(_e321.member_1.x, _e321.member_1.y, _e321.member_1.z), array<f32, 3>(_e335.member_1.x, _e335.member_1.y, _e335.member_1.z));
                let _e359 = params.member.member.member_4;
                if (_e284.member != 0u) {
                    let _e450 = local_40;
                    let _e455 = local_40;
                    let _e464 = local_41;
                    let _e469 = local_41;
                    let _e479 = local_40;
                    let _e484 = local_40;
                    let _e493 = local_41;
                    let _e498 = local_41;
                    let _e508 = local_40;
                    let _e513 = local_40;
                    let _e522 = local_41;
                    let _e527 = local_41;
                    phi_1545_ = type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e450[2][0] - _e455[0][0]), (_e450[2][1] - _e455[0][1]), (_e450[2][2] - _e455[0][2])), array<f32, 3>((_e464[2][0] - _e469[0][0]), (_e464[2][1] - _e469[0][1]), (_e464[2][2] - _e469[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e479[1][0] - _e484[0][0]), (_e479[1][1] - _e484[0][1]), (_e479[1][2] - _e484[0][2])), array<f32, 3>((_e493[1][0] - _e498[0][0]), (_e493[1][1] - _e498[0][1]), (_e493[1][2] - _e498[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e508[2][0] - _e513[3][0]), (_e508[2][1] - _e513[3][1]), (_e508[2][2] - _e513[3][2])), array<f32, 3>((_e522[2][0] - _e527[3][0]), (_e522[2][1] - _e527[3][1]), (_e522[2][2] - _e527[3][2]))), (_e359 + _e359));
                } else {
                    let _e361 = local_40;
                    let _e366 = local_40;
                    let _e375 = local_41;
                    let _e380 = local_41;
                    let _e390 = local_40;
                    let _e395 = local_40;
                    let _e404 = local_41;
                    let _e409 = local_41;
                    let _e419 = local_40;
                    let _e424 = local_40;
                    let _e433 = local_41;
                    let _e438 = local_41;
                    phi_1545_ = type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e361[0][0] - _e366[1][0]), (_e361[0][1] - _e366[1][1]), (_e361[0][2] - _e366[1][2])), array<f32, 3>((_e375[0][0] - _e380[1][0]), (_e375[0][1] - _e380[1][1]), (_e375[0][2] - _e380[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e390[2][0] - _e395[1][0]), (_e390[2][1] - _e395[1][1]), (_e390[2][2] - _e395[1][2])), array<f32, 3>((_e404[2][0] - _e409[1][0]), (_e404[2][1] - _e409[1][1]), (_e404[2][2] - _e409[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e419[3][0] - _e424[1][0]), (_e419[3][1] - _e424[1][1]), (_e419[3][2] - _e424[1][2])), array<f32, 3>((_e433[3][0] - _e438[1][0]), (_e433[3][1] - _e438[1][1]), (_e433[3][2] - _e438[1][2]))), (_e359 + _e359));
                }
                let _e540 = phi_1545_;
                let _e546 = select(_e540.member[0][0], -(_e540.member[0][0]), (_e540.member[0][0] < 0f));
                let _e550 = select(_e540.member[0][1], -(_e540.member[0][1]), (_e540.member[0][1] < 0f));
                let _e552 = select(_e550, _e546, (_e546 > _e550));
                let _e556 = select(_e540.member[0][2], -(_e540.member[0][2]), (_e540.member[0][2] < 0f));
                let _e558 = select(_e556, _e552, (_e552 > _e556));
                let _e564 = select(_e540.member[1][0], -(_e540.member[1][0]), (_e540.member[1][0] < 0f));
                let _e568 = select(_e540.member[1][1], -(_e540.member[1][1]), (_e540.member[1][1] < 0f));
                let _e570 = select(_e568, _e564, (_e564 > _e568));
                let _e574 = select(_e540.member[1][2], -(_e540.member[1][2]), (_e540.member[1][2] < 0f));
                let _e576 = select(_e574, _e570, (_e570 > _e574));
                let _e586 = select(_e540.member_1[0][0], -(_e540.member_1[0][0]), (_e540.member_1[0][0] < 0f));
                let _e590 = select(_e540.member_1[0][1], -(_e540.member_1[0][1]), (_e540.member_1[0][1] < 0f));
                let _e592 = select(_e590, _e586, (_e586 > _e590));
                let _e596 = select(_e540.member_1[0][2], -(_e540.member_1[0][2]), (_e540.member_1[0][2] < 0f));
                let _e598 = select(_e596, _e592, (_e592 > _e596));
                let _e604 = select(_e540.member_1[1][0], -(_e540.member_1[1][0]), (_e540.member_1[1][0] < 0f));
                let _e608 = select(_e540.member_1[1][1], -(_e540.member_1[1][1]), (_e540.member_1[1][1] < 0f));
                let _e610 = select(_e608, _e604, (_e604 > _e608));
                let _e614 = select(_e540.member_1[1][2], -(_e540.member_1[1][2]), (_e540.member_1[1][2] < 0f));
                let _e616 = select(_e614, _e610, (_e610 > _e614));
                let _e626 = select(_e540.member_2[0][0], -(_e540.member_2[0][0]), (_e540.member_2[0][0] < 0f));
                let _e630 = select(_e540.member_2[0][1], -(_e540.member_2[0][1]), (_e540.member_2[0][1] < 0f));
                let _e632 = select(_e630, _e626, (_e626 > _e630));
                let _e636 = select(_e540.member_2[0][2], -(_e540.member_2[0][2]), (_e540.member_2[0][2] < 0f));
                let _e638 = select(_e636, _e632, (_e632 > _e636));
                let _e644 = select(_e540.member_2[1][0], -(_e540.member_2[1][0]), (_e540.member_2[1][0] < 0f));
                let _e648 = select(_e540.member_2[1][1], -(_e540.member_2[1][1]), (_e540.member_2[1][1] < 0f));
                let _e650 = select(_e648, _e644, (_e644 > _e648));
                let _e654 = select(_e540.member_2[1][2], -(_e540.member_2[1][2]), (_e540.member_2[1][2] < 0f));
                let _e656 = select(_e654, _e650, (_e650 > _e654));
                let _e661 = function_((select(_e576, _e558, (_e558 > _e576)) + _e540.member_3), (select(_e616, _e598, (_e598 > _e616)) + _e540.member_3));
                let _e662 = function_(_e661, (select(_e656, _e638, (_e638 > _e656)) + _e540.member_3));
                let _e667 = bitcast<i32>(((bitcast<u32>(_e662) + 4u) >> bitcast<u32>(23i)));
                let _e668 = (_e667 >= 64i);
                let _e669 = (_e667 <= 190i);
                let _e675 = select(select(i32(), select(i32(), (_e667 - 126i), _e669), _e668), 2147483647i, select(true, select(true, false, _e669), _e668));
                let _e677 = params.member.member_2.member_3;
                if (_e677 > 0u) {
                    if (_e675 != 2147483647i) {
                        let _e681 = params.member.member.member_1;
                        if ((_e681 & 8u) != 0u) {
                            let _e921 = local_40;
                            let _e926 = bitcast<u32>(_e921[0][0]);
                            let _e927 = (_e926 & 2147483647u);
                            let _e928 = (_e927 < 8388608u);
                            let _e939 = function_15(array<u32, 2>(select((_e926 << bitcast<u32>(29i)), 0u, _e928), select(((_e926 ^ _e927) | ((_e927 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e928)), _e675);
                            let _e940 = bitcast<u32>(_e921[0][1]);
                            let _e941 = (_e940 & 2147483647u);
                            let _e942 = (_e941 < 8388608u);
                            let _e953 = function_15(array<u32, 2>(select((_e940 << bitcast<u32>(29i)), 0u, _e942), select(((_e940 ^ _e941) | ((_e941 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e942)), _e675);
                            let _e954 = bitcast<u32>(_e921[0][2]);
                            let _e955 = (_e954 & 2147483647u);
                            let _e956 = (_e955 < 8388608u);
                            let _e967 = function_15(array<u32, 2>(select((_e954 << bitcast<u32>(29i)), 0u, _e956), select(((_e954 ^ _e955) | ((_e955 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e956)), _e675);
                            let _e969 = local_41;
                            let _e974 = bitcast<u32>(_e969[0][0]);
                            let _e975 = (_e974 & 2147483647u);
                            let _e976 = (_e975 < 8388608u);
                            let _e987 = function_15(array<u32, 2>(select((_e974 << bitcast<u32>(29i)), 0u, _e976), select(((_e974 ^ _e975) | ((_e975 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e976)), _e675);
                            let _e988 = bitcast<u32>(_e969[0][1]);
                            let _e989 = (_e988 & 2147483647u);
                            let _e990 = (_e989 < 8388608u);
                            let _e1001 = function_15(array<u32, 2>(select((_e988 << bitcast<u32>(29i)), 0u, _e990), select(((_e988 ^ _e989) | ((_e989 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e990)), _e675);
                            let _e1002 = bitcast<u32>(_e969[0][2]);
                            let _e1003 = (_e1002 & 2147483647u);
                            let _e1004 = (_e1003 < 8388608u);
                            let _e1015 = function_15(array<u32, 2>(select((_e1002 << bitcast<u32>(29i)), 0u, _e1004), select(((_e1002 ^ _e1003) | ((_e1003 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1004)), _e675);
                            let _e1018 = local_40;
                            let _e1023 = bitcast<u32>(_e1018[1][0]);
                            let _e1024 = (_e1023 & 2147483647u);
                            let _e1025 = (_e1024 < 8388608u);
                            let _e1036 = function_15(array<u32, 2>(select((_e1023 << bitcast<u32>(29i)), 0u, _e1025), select(((_e1023 ^ _e1024) | ((_e1024 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1025)), _e675);
                            let _e1037 = bitcast<u32>(_e1018[1][1]);
                            let _e1038 = (_e1037 & 2147483647u);
                            let _e1039 = (_e1038 < 8388608u);
                            let _e1050 = function_15(array<u32, 2>(select((_e1037 << bitcast<u32>(29i)), 0u, _e1039), select(((_e1037 ^ _e1038) | ((_e1038 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1039)), _e675);
                            let _e1051 = bitcast<u32>(_e1018[1][2]);
                            let _e1052 = (_e1051 & 2147483647u);
                            let _e1053 = (_e1052 < 8388608u);
                            let _e1064 = function_15(array<u32, 2>(select((_e1051 << bitcast<u32>(29i)), 0u, _e1053), select(((_e1051 ^ _e1052) | ((_e1052 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1053)), _e675);
                            let _e1066 = local_41;
                            let _e1071 = bitcast<u32>(_e1066[1][0]);
                            let _e1072 = (_e1071 & 2147483647u);
                            let _e1073 = (_e1072 < 8388608u);
                            let _e1084 = function_15(array<u32, 2>(select((_e1071 << bitcast<u32>(29i)), 0u, _e1073), select(((_e1071 ^ _e1072) | ((_e1072 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1073)), _e675);
                            let _e1085 = bitcast<u32>(_e1066[1][1]);
                            let _e1086 = (_e1085 & 2147483647u);
                            let _e1087 = (_e1086 < 8388608u);
                            let _e1098 = function_15(array<u32, 2>(select((_e1085 << bitcast<u32>(29i)), 0u, _e1087), select(((_e1085 ^ _e1086) | ((_e1086 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1087)), _e675);
                            let _e1099 = bitcast<u32>(_e1066[1][2]);
                            let _e1100 = (_e1099 & 2147483647u);
                            let _e1101 = (_e1100 < 8388608u);
                            let _e1112 = function_15(array<u32, 2>(select((_e1099 << bitcast<u32>(29i)), 0u, _e1101), select(((_e1099 ^ _e1100) | ((_e1100 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1101)), _e675);
                            let _e1115 = local_40;
                            let _e1120 = bitcast<u32>(_e1115[2][0]);
                            let _e1121 = (_e1120 & 2147483647u);
                            let _e1122 = (_e1121 < 8388608u);
                            let _e1133 = function_15(array<u32, 2>(select((_e1120 << bitcast<u32>(29i)), 0u, _e1122), select(((_e1120 ^ _e1121) | ((_e1121 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1122)), _e675);
                            let _e1134 = bitcast<u32>(_e1115[2][1]);
                            let _e1135 = (_e1134 & 2147483647u);
                            let _e1136 = (_e1135 < 8388608u);
                            let _e1147 = function_15(array<u32, 2>(select((_e1134 << bitcast<u32>(29i)), 0u, _e1136), select(((_e1134 ^ _e1135) | ((_e1135 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1136)), _e675);
                            let _e1148 = bitcast<u32>(_e1115[2][2]);
                            let _e1149 = (_e1148 & 2147483647u);
                            let _e1150 = (_e1149 < 8388608u);
                            let _e1161 = function_15(array<u32, 2>(select((_e1148 << bitcast<u32>(29i)), 0u, _e1150), select(((_e1148 ^ _e1149) | ((_e1149 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1150)), _e675);
                            let _e1163 = local_41;
                            let _e1168 = bitcast<u32>(_e1163[2][0]);
                            let _e1169 = (_e1168 & 2147483647u);
                            let _e1170 = (_e1169 < 8388608u);
                            let _e1181 = function_15(array<u32, 2>(select((_e1168 << bitcast<u32>(29i)), 0u, _e1170), select(((_e1168 ^ _e1169) | ((_e1169 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1170)), _e675);
                            let _e1182 = bitcast<u32>(_e1163[2][1]);
                            let _e1183 = (_e1182 & 2147483647u);
                            let _e1184 = (_e1183 < 8388608u);
                            let _e1195 = function_15(array<u32, 2>(select((_e1182 << bitcast<u32>(29i)), 0u, _e1184), select(((_e1182 ^ _e1183) | ((_e1183 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1184)), _e675);
                            let _e1196 = bitcast<u32>(_e1163[2][2]);
                            let _e1197 = (_e1196 & 2147483647u);
                            let _e1198 = (_e1197 < 8388608u);
                            let _e1209 = function_15(array<u32, 2>(select((_e1196 << bitcast<u32>(29i)), 0u, _e1198), select(((_e1196 ^ _e1197) | ((_e1197 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1198)), _e675);
                            let _e1212 = local_40;
                            let _e1217 = bitcast<u32>(_e1212[3][0]);
                            let _e1218 = (_e1217 & 2147483647u);
                            let _e1219 = (_e1218 < 8388608u);
                            let _e1230 = function_15(array<u32, 2>(select((_e1217 << bitcast<u32>(29i)), 0u, _e1219), select(((_e1217 ^ _e1218) | ((_e1218 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1219)), _e675);
                            let _e1231 = bitcast<u32>(_e1212[3][1]);
                            let _e1232 = (_e1231 & 2147483647u);
                            let _e1233 = (_e1232 < 8388608u);
                            let _e1244 = function_15(array<u32, 2>(select((_e1231 << bitcast<u32>(29i)), 0u, _e1233), select(((_e1231 ^ _e1232) | ((_e1232 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1233)), _e675);
                            let _e1245 = bitcast<u32>(_e1212[3][2]);
                            let _e1246 = (_e1245 & 2147483647u);
                            let _e1247 = (_e1246 < 8388608u);
                            let _e1258 = function_15(array<u32, 2>(select((_e1245 << bitcast<u32>(29i)), 0u, _e1247), select(((_e1245 ^ _e1246) | ((_e1246 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1247)), _e675);
                            let _e1260 = local_41;
                            let _e1265 = bitcast<u32>(_e1260[3][0]);
                            let _e1266 = (_e1265 & 2147483647u);
                            let _e1267 = (_e1266 < 8388608u);
                            let _e1278 = function_15(array<u32, 2>(select((_e1265 << bitcast<u32>(29i)), 0u, _e1267), select(((_e1265 ^ _e1266) | ((_e1266 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1267)), _e675);
                            let _e1279 = bitcast<u32>(_e1260[3][1]);
                            let _e1280 = (_e1279 & 2147483647u);
                            let _e1281 = (_e1280 < 8388608u);
                            let _e1292 = function_15(array<u32, 2>(select((_e1279 << bitcast<u32>(29i)), 0u, _e1281), select(((_e1279 ^ _e1280) | ((_e1280 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1281)), _e675);
                            let _e1293 = bitcast<u32>(_e1260[3][2]);
                            let _e1294 = (_e1293 & 2147483647u);
                            let _e1295 = (_e1294 < 8388608u);
                            let _e1306 = function_15(array<u32, 2>(select((_e1293 << bitcast<u32>(29i)), 0u, _e1295), select(((_e1293 ^ _e1294) | ((_e1294 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1295)), _e675);
                            phi_3253_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e939, _e953, _e967), array<type_9, 3>(_e987, _e1001, _e1015)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1036, _e1050, _e1064), array<type_9, 3>(_e1084, _e1098, _e1112)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1133, _e1147, _e1161), array<type_9, 3>(_e1181, _e1195, _e1209)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1230, _e1244, _e1258), array<type_9, 3>(_e1278, _e1292, _e1306)));
                        } else {
                            let _e686 = params.member.member.member_10[1u];
                            let _e691 = (_e675 - (bitcast<i32>((_e686 >> bitcast<u32>(20i))) - 1023i));
                            let _e692 = local_39;
                            let _e696 = params.member.member.member[0u];
                            let _e698 = (6u * (_e696 + _e692[0]));
                            let _e699 = (6u * _e692[0]);
                            let _e701 = positions.member[_e699];
                            let _e704 = positions.member[(_e699 + 1u)];
                            let _e706 = function_15(array<u32, 2>(_e701, _e704), _e691);
                            let _e709 = positions.member[(_e699 + 2u)];
                            let _e712 = positions.member[(_e699 + 3u)];
                            let _e714 = function_15(array<u32, 2>(_e709, _e712), _e691);
                            let _e717 = positions.member[(_e699 + 4u)];
                            let _e720 = positions.member[(_e699 + 5u)];
                            let _e722 = function_15(array<u32, 2>(_e717, _e720), _e691);
                            let _e725 = positions.member[_e698];
                            let _e728 = positions.member[(_e698 + 1u)];
                            let _e730 = function_15(array<u32, 2>(_e725, _e728), _e691);
                            let _e733 = positions.member[(_e698 + 2u)];
                            let _e736 = positions.member[(_e698 + 3u)];
                            let _e738 = function_15(array<u32, 2>(_e733, _e736), _e691);
                            let _e741 = positions.member[(_e698 + 4u)];
                            let _e744 = positions.member[(_e698 + 5u)];
                            let _e746 = function_15(array<u32, 2>(_e741, _e744), _e691);
                            let _e749 = local_39;
                            let _e753 = params.member.member.member[0u];
                            let _e755 = (6u * (_e753 + _e749[1]));
                            let _e756 = (6u * _e749[1]);
                            let _e758 = positions.member[_e756];
                            let _e761 = positions.member[(_e756 + 1u)];
                            let _e763 = function_15(array<u32, 2>(_e758, _e761), _e691);
                            let _e766 = positions.member[(_e756 + 2u)];
                            let _e769 = positions.member[(_e756 + 3u)];
                            let _e771 = function_15(array<u32, 2>(_e766, _e769), _e691);
                            let _e774 = positions.member[(_e756 + 4u)];
                            let _e777 = positions.member[(_e756 + 5u)];
                            let _e779 = function_15(array<u32, 2>(_e774, _e777), _e691);
                            let _e782 = positions.member[_e755];
                            let _e785 = positions.member[(_e755 + 1u)];
                            let _e787 = function_15(array<u32, 2>(_e782, _e785), _e691);
                            let _e790 = positions.member[(_e755 + 2u)];
                            let _e793 = positions.member[(_e755 + 3u)];
                            let _e795 = function_15(array<u32, 2>(_e790, _e793), _e691);
                            let _e798 = positions.member[(_e755 + 4u)];
                            let _e801 = positions.member[(_e755 + 5u)];
                            let _e803 = function_15(array<u32, 2>(_e798, _e801), _e691);
                            let _e806 = local_39;
                            let _e810 = params.member.member.member[0u];
                            let _e812 = (6u * (_e810 + _e806[2]));
                            let _e813 = (6u * _e806[2]);
                            let _e815 = positions.member[_e813];
                            let _e818 = positions.member[(_e813 + 1u)];
                            let _e820 = function_15(array<u32, 2>(_e815, _e818), _e691);
                            let _e823 = positions.member[(_e813 + 2u)];
                            let _e826 = positions.member[(_e813 + 3u)];
                            let _e828 = function_15(array<u32, 2>(_e823, _e826), _e691);
                            let _e831 = positions.member[(_e813 + 4u)];
                            let _e834 = positions.member[(_e813 + 5u)];
                            let _e836 = function_15(array<u32, 2>(_e831, _e834), _e691);
                            let _e839 = positions.member[_e812];
                            let _e842 = positions.member[(_e812 + 1u)];
                            let _e844 = function_15(array<u32, 2>(_e839, _e842), _e691);
                            let _e847 = positions.member[(_e812 + 2u)];
                            let _e850 = positions.member[(_e812 + 3u)];
                            let _e852 = function_15(array<u32, 2>(_e847, _e850), _e691);
                            let _e855 = positions.member[(_e812 + 4u)];
                            let _e858 = positions.member[(_e812 + 5u)];
                            let _e860 = function_15(array<u32, 2>(_e855, _e858), _e691);
                            let _e863 = local_39;
                            let _e867 = params.member.member.member[0u];
                            let _e869 = (6u * (_e867 + _e863[3]));
                            let _e870 = (6u * _e863[3]);
                            let _e872 = positions.member[_e870];
                            let _e875 = positions.member[(_e870 + 1u)];
                            let _e877 = function_15(array<u32, 2>(_e872, _e875), _e691);
                            let _e880 = positions.member[(_e870 + 2u)];
                            let _e883 = positions.member[(_e870 + 3u)];
                            let _e885 = function_15(array<u32, 2>(_e880, _e883), _e691);
                            let _e888 = positions.member[(_e870 + 4u)];
                            let _e891 = positions.member[(_e870 + 5u)];
                            let _e893 = function_15(array<u32, 2>(_e888, _e891), _e691);
                            let _e896 = positions.member[_e869];
                            let _e899 = positions.member[(_e869 + 1u)];
                            let _e901 = function_15(array<u32, 2>(_e896, _e899), _e691);
                            let _e904 = positions.member[(_e869 + 2u)];
                            let _e907 = positions.member[(_e869 + 3u)];
                            let _e909 = function_15(array<u32, 2>(_e904, _e907), _e691);
                            let _e912 = positions.member[(_e869 + 4u)];
                            let _e915 = positions.member[(_e869 + 5u)];
                            let _e917 = function_15(array<u32, 2>(_e912, _e915), _e691);
                            phi_3253_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e706, _e714, _e722), array<type_9, 3>(_e730, _e738, _e746)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e763, _e771, _e779), array<type_9, 3>(_e787, _e795, _e803)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e820, _e828, _e836), array<type_9, 3>(_e844, _e852, _e860)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e877, _e885, _e893), array<type_9, 3>(_e901, _e909, _e917)));
                        }
                        let _e1311 = phi_3253_;
                        let _e1313 = params.member.member_2.member_1;
                        let _e1315 = params.member.member_2.member_2;
                        let _e1317 = params.member.member_2.member_3;
                        if (_e284.member != 0u) {
                            phi_3800_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1311[2][0][0].member - _e1311[0][0][0].member) - select(0u, 1u, (_e1311[2][0][0].member_1 < _e1311[0][0][0].member_1))), (_e1311[2][0][0].member_1 - _e1311[0][0][0].member_1)), type_9(((_e1311[2][0][1].member - _e1311[0][0][1].member) - select(0u, 1u, (_e1311[2][0][1].member_1 < _e1311[0][0][1].member_1))), (_e1311[2][0][1].member_1 - _e1311[0][0][1].member_1)), type_9(((_e1311[2][0][2].member - _e1311[0][0][2].member) - select(0u, 1u, (_e1311[2][0][2].member_1 < _e1311[0][0][2].member_1))), (_e1311[2][0][2].member_1 - _e1311[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1311[2][1][0].member - _e1311[0][1][0].member) - select(0u, 1u, (_e1311[2][1][0].member_1 < _e1311[0][1][0].member_1))), (_e1311[2][1][0].member_1 - _e1311[0][1][0].member_1)), type_9(((_e1311[2][1][1].member - _e1311[0][1][1].member) - select(0u, 1u, (_e1311[2][1][1].member_1 < _e1311[0][1][1].member_1))), (_e1311[2][1][1].member_1 - _e1311[0][1][1].member_1)), type_9(((_e1311[2][1][2].member - _e1311[0][1][2].member) - select(0u, 1u, (_e1311[2][1][2].member_1 < _e1311[0][1][2].member_1))), (_e1311[2][1][2].member_1 - _e1311[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1311[1][0][0].member - _e1311[0][0][0].member) - select(0u, 1u, (_e1311[1][0][0].member_1 < _e1311[0][0][0].member_1))), (_e1311[1][0][0].member_1 - _e1311[0][0][0].member_1)), type_9(((_e1311[1][0][1].member - _e1311[0][0][1].member) - select(0u, 1u, (_e1311[1][0][1].member_1 < _e1311[0][0][1].member_1))), (_e1311[1][0][1].member_1 - _e1311[0][0][1].member_1)), type_9(((_e1311[1][0][2].member - _e1311[0][0][2].member) - select(0u, 1u, (_e1311[1][0][2].member_1 < _e1311[0][0][2].member_1))), (_e1311[1][0][2].member_1 - _e1311[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1311[1][1][0].member - _e1311[0][1][0].member) - select(0u, 1u, (_e1311[1][1][0].member_1 < _e1311[0][1][0].member_1))), (_e1311[1][1][0].member_1 - _e1311[0][1][0].member_1)), type_9(((_e1311[1][1][1].member - _e1311[0][1][1].member) - select(0u, 1u, (_e1311[1][1][1].member_1 < _e1311[0][1][1].member_1))), (_e1311[1][1][1].member_1 - _e1311[0][1][1].member_1)), type_9(((_e1311[1][1][2].member - _e1311[0][1][2].member) - select(0u, 1u, (_e1311[1][1][2].member_1 < _e1311[0][1][2].member_1))), (_e1311[1][1][2].member_1 - _e1311[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1311[2][0][0].member - _e1311[3][0][0].member) - select(0u, 1u, (_e1311[2][0][0].member_1 < _e1311[3][0][0].member_1))), (_e1311[2][0][0].member_1 - _e1311[3][0][0].member_1)), type_9(((_e1311[2][0][1].member - _e1311[3][0][1].member) - select(0u, 1u, (_e1311[2][0][1].member_1 < _e1311[3][0][1].member_1))), (_e1311[2][0][1].member_1 - _e1311[3][0][1].member_1)), type_9(((_e1311[2][0][2].member - _e1311[3][0][2].member) - select(0u, 1u, (_e1311[2][0][2].member_1 < _e1311[3][0][2].member_1))), (_e1311[2][0][2].member_1 - _e1311[3][0][2].member_1))), array<type_9, 3>(type_9(((_e1311[2][1][0].member - _e1311[3][1][0].member) - select(0u, 1u, (_e1311[2][1][0].member_1 < _e1311[3][1][0].member_1))), (_e1311[2][1][0].member_1 - _e1311[3][1][0].member_1)), type_9(((_e1311[2][1][1].member - _e1311[3][1][1].member) - select(0u, 1u, (_e1311[2][1][1].member_1 < _e1311[3][1][1].member_1))), (_e1311[2][1][1].member_1 - _e1311[3][1][1].member_1)), type_9(((_e1311[2][1][2].member - _e1311[3][1][2].member) - select(0u, 1u, (_e1311[2][1][2].member_1 < _e1311[3][1][2].member_1))), (_e1311[2][1][2].member_1 - _e1311[3][1][2].member_1)))));
                        } else {
                            phi_3800_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1311[0][0][0].member - _e1311[1][0][0].member) - select(0u, 1u, (_e1311[0][0][0].member_1 < _e1311[1][0][0].member_1))), (_e1311[0][0][0].member_1 - _e1311[1][0][0].member_1)), type_9(((_e1311[0][0][1].member - _e1311[1][0][1].member) - select(0u, 1u, (_e1311[0][0][1].member_1 < _e1311[1][0][1].member_1))), (_e1311[0][0][1].member_1 - _e1311[1][0][1].member_1)), type_9(((_e1311[0][0][2].member - _e1311[1][0][2].member) - select(0u, 1u, (_e1311[0][0][2].member_1 < _e1311[1][0][2].member_1))), (_e1311[0][0][2].member_1 - _e1311[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1311[0][1][0].member - _e1311[1][1][0].member) - select(0u, 1u, (_e1311[0][1][0].member_1 < _e1311[1][1][0].member_1))), (_e1311[0][1][0].member_1 - _e1311[1][1][0].member_1)), type_9(((_e1311[0][1][1].member - _e1311[1][1][1].member) - select(0u, 1u, (_e1311[0][1][1].member_1 < _e1311[1][1][1].member_1))), (_e1311[0][1][1].member_1 - _e1311[1][1][1].member_1)), type_9(((_e1311[0][1][2].member - _e1311[1][1][2].member) - select(0u, 1u, (_e1311[0][1][2].member_1 < _e1311[1][1][2].member_1))), (_e1311[0][1][2].member_1 - _e1311[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1311[2][0][0].member - _e1311[1][0][0].member) - select(0u, 1u, (_e1311[2][0][0].member_1 < _e1311[1][0][0].member_1))), (_e1311[2][0][0].member_1 - _e1311[1][0][0].member_1)), type_9(((_e1311[2][0][1].member - _e1311[1][0][1].member) - select(0u, 1u, (_e1311[2][0][1].member_1 < _e1311[1][0][1].member_1))), (_e1311[2][0][1].member_1 - _e1311[1][0][1].member_1)), type_9(((_e1311[2][0][2].member - _e1311[1][0][2].member) - select(0u, 1u, (_e1311[2][0][2].member_1 < _e1311[1][0][2].member_1))), (_e1311[2][0][2].member_1 - _e1311[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1311[2][1][0].member - _e1311[1][1][0].member) - select(0u, 1u, (_e1311[2][1][0].member_1 < _e1311[1][1][0].member_1))), (_e1311[2][1][0].member_1 - _e1311[1][1][0].member_1)), type_9(((_e1311[2][1][1].member - _e1311[1][1][1].member) - select(0u, 1u, (_e1311[2][1][1].member_1 < _e1311[1][1][1].member_1))), (_e1311[2][1][1].member_1 - _e1311[1][1][1].member_1)), type_9(((_e1311[2][1][2].member - _e1311[1][1][2].member) - select(0u, 1u, (_e1311[2][1][2].member_1 < _e1311[1][1][2].member_1))), (_e1311[2][1][2].member_1 - _e1311[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1311[3][0][0].member - _e1311[1][0][0].member) - select(0u, 1u, (_e1311[3][0][0].member_1 < _e1311[1][0][0].member_1))), (_e1311[3][0][0].member_1 - _e1311[1][0][0].member_1)), type_9(((_e1311[3][0][1].member - _e1311[1][0][1].member) - select(0u, 1u, (_e1311[3][0][1].member_1 < _e1311[1][0][1].member_1))), (_e1311[3][0][1].member_1 - _e1311[1][0][1].member_1)), type_9(((_e1311[3][0][2].member - _e1311[1][0][2].member) - select(0u, 1u, (_e1311[3][0][2].member_1 < _e1311[1][0][2].member_1))), (_e1311[3][0][2].member_1 - _e1311[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1311[3][1][0].member - _e1311[1][1][0].member) - select(0u, 1u, (_e1311[3][1][0].member_1 < _e1311[1][1][0].member_1))), (_e1311[3][1][0].member_1 - _e1311[1][1][0].member_1)), type_9(((_e1311[3][1][1].member - _e1311[1][1][1].member) - select(0u, 1u, (_e1311[3][1][1].member_1 < _e1311[1][1][1].member_1))), (_e1311[3][1][1].member_1 - _e1311[1][1][1].member_1)), type_9(((_e1311[3][1][2].member - _e1311[1][1][2].member) - select(0u, 1u, (_e1311[3][1][2].member_1 < _e1311[1][1][2].member_1))), (_e1311[3][1][2].member_1 - _e1311[1][1][2].member_1)))));
                        }
                        let _e1892 = phi_3800_;
                        local_37 = array<type_9, 3>(type_9(_e1892[1][0][0].member, _e1892[1][0][0].member_1), type_9(_e1892[1][0][1].member, _e1892[1][0][1].member_1), type_9(_e1892[1][0][2].member, _e1892[1][0][2].member_1));
                        local_38 = array<type_9, 3>(type_9(_e1892[2][0][0].member, _e1892[2][0][0].member_1), type_9(_e1892[2][0][1].member, _e1892[2][0][1].member_1), type_9(_e1892[2][0][2].member, _e1892[2][0][2].member_1));
                        let _e1925 = local_37[1u].member;
                        let _e1927 = local_37[1u].member_1;
                        let _e1930 = local_38[2u].member;
                        let _e1932 = local_38[2u].member_1;
                        let _e1933 = function_10(_e1925, _e1927, _e1930, _e1932);
                        let _e1938 = local_37[2u].member;
                        let _e1940 = local_37[2u].member_1;
                        let _e1943 = local_38[1u].member;
                        let _e1945 = local_38[1u].member_1;
                        let _e1946 = function_10(_e1938, _e1940, _e1943, _e1945);
                        let _e1952 = ((_e1933.member - _e1946.member) - select(0u, 1u, (_e1933.member_1 < _e1946.member_1)));
                        let _e1953 = (_e1933.member_1 - _e1946.member_1);
                        local_35 = array<type_9, 3>(type_9(_e1892[1][0][0].member, _e1892[1][0][0].member_1), type_9(_e1892[1][0][1].member, _e1892[1][0][1].member_1), type_9(_e1892[1][0][2].member, _e1892[1][0][2].member_1));
                        local_36 = array<type_9, 3>(type_9(_e1892[2][0][0].member, _e1892[2][0][0].member_1), type_9(_e1892[2][0][1].member, _e1892[2][0][1].member_1), type_9(_e1892[2][0][2].member, _e1892[2][0][2].member_1));
                        let _e1982 = local_35[2u].member;
                        let _e1984 = local_35[2u].member_1;
                        let _e1987 = local_36[0u].member;
                        let _e1989 = local_36[0u].member_1;
                        let _e1990 = function_10(_e1982, _e1984, _e1987, _e1989);
                        let _e1995 = local_35[0u].member;
                        let _e1997 = local_35[0u].member_1;
                        let _e2000 = local_36[2u].member;
                        let _e2002 = local_36[2u].member_1;
                        let _e2003 = function_10(_e1995, _e1997, _e2000, _e2002);
                        let _e2009 = ((_e1990.member - _e2003.member) - select(0u, 1u, (_e1990.member_1 < _e2003.member_1)));
                        let _e2010 = (_e1990.member_1 - _e2003.member_1);
                        local_33 = array<type_9, 3>(type_9(_e1892[1][0][0].member, _e1892[1][0][0].member_1), type_9(_e1892[1][0][1].member, _e1892[1][0][1].member_1), type_9(_e1892[1][0][2].member, _e1892[1][0][2].member_1));
                        local_34 = array<type_9, 3>(type_9(_e1892[2][0][0].member, _e1892[2][0][0].member_1), type_9(_e1892[2][0][1].member, _e1892[2][0][1].member_1), type_9(_e1892[2][0][2].member, _e1892[2][0][2].member_1));
                        let _e2039 = local_33[0u].member;
                        let _e2041 = local_33[0u].member_1;
                        let _e2044 = local_34[1u].member;
                        let _e2046 = local_34[1u].member_1;
                        let _e2047 = function_10(_e2039, _e2041, _e2044, _e2046);
                        let _e2052 = local_33[1u].member;
                        let _e2054 = local_33[1u].member_1;
                        let _e2057 = local_34[0u].member;
                        let _e2059 = local_34[0u].member_1;
                        let _e2060 = function_10(_e2052, _e2054, _e2057, _e2059);
                        let _e2066 = ((_e2047.member - _e2060.member) - select(0u, 1u, (_e2047.member_1 < _e2060.member_1)));
                        let _e2067 = (_e2047.member_1 - _e2060.member_1);
                        local_31 = array<type_9, 3>(type_9(_e1892[1][1][0].member, _e1892[1][1][0].member_1), type_9(_e1892[1][1][1].member, _e1892[1][1][1].member_1), type_9(_e1892[1][1][2].member, _e1892[1][1][2].member_1));
                        local_32 = array<type_9, 3>(type_9(_e1892[2][1][0].member, _e1892[2][1][0].member_1), type_9(_e1892[2][1][1].member, _e1892[2][1][1].member_1), type_9(_e1892[2][1][2].member, _e1892[2][1][2].member_1));
                        let _e2100 = local_31[1u].member;
                        let _e2102 = local_31[1u].member_1;
                        let _e2105 = local_32[2u].member;
                        let _e2107 = local_32[2u].member_1;
                        let _e2108 = function_10(_e2100, _e2102, _e2105, _e2107);
                        let _e2113 = local_31[2u].member;
                        let _e2115 = local_31[2u].member_1;
                        let _e2118 = local_32[1u].member;
                        let _e2120 = local_32[1u].member_1;
                        let _e2121 = function_10(_e2113, _e2115, _e2118, _e2120);
                        let _e2127 = ((_e2108.member - _e2121.member) - select(0u, 1u, (_e2108.member_1 < _e2121.member_1)));
                        let _e2128 = (_e2108.member_1 - _e2121.member_1);
                        local_29 = array<type_9, 3>(type_9(_e1892[1][1][0].member, _e1892[1][1][0].member_1), type_9(_e1892[1][1][1].member, _e1892[1][1][1].member_1), type_9(_e1892[1][1][2].member, _e1892[1][1][2].member_1));
                        local_30 = array<type_9, 3>(type_9(_e1892[2][1][0].member, _e1892[2][1][0].member_1), type_9(_e1892[2][1][1].member, _e1892[2][1][1].member_1), type_9(_e1892[2][1][2].member, _e1892[2][1][2].member_1));
                        let _e2157 = local_29[2u].member;
                        let _e2159 = local_29[2u].member_1;
                        let _e2162 = local_30[0u].member;
                        let _e2164 = local_30[0u].member_1;
                        let _e2165 = function_10(_e2157, _e2159, _e2162, _e2164);
                        let _e2170 = local_29[0u].member;
                        let _e2172 = local_29[0u].member_1;
                        let _e2175 = local_30[2u].member;
                        let _e2177 = local_30[2u].member_1;
                        let _e2178 = function_10(_e2170, _e2172, _e2175, _e2177);
                        let _e2184 = ((_e2165.member - _e2178.member) - select(0u, 1u, (_e2165.member_1 < _e2178.member_1)));
                        let _e2185 = (_e2165.member_1 - _e2178.member_1);
                        local_27 = array<type_9, 3>(type_9(_e1892[1][1][0].member, _e1892[1][1][0].member_1), type_9(_e1892[1][1][1].member, _e1892[1][1][1].member_1), type_9(_e1892[1][1][2].member, _e1892[1][1][2].member_1));
                        local_28 = array<type_9, 3>(type_9(_e1892[2][1][0].member, _e1892[2][1][0].member_1), type_9(_e1892[2][1][1].member, _e1892[2][1][1].member_1), type_9(_e1892[2][1][2].member, _e1892[2][1][2].member_1));
                        let _e2214 = local_27[0u].member;
                        let _e2216 = local_27[0u].member_1;
                        let _e2219 = local_28[1u].member;
                        let _e2221 = local_28[1u].member_1;
                        let _e2222 = function_10(_e2214, _e2216, _e2219, _e2221);
                        let _e2227 = local_27[1u].member;
                        let _e2229 = local_27[1u].member_1;
                        let _e2232 = local_28[0u].member;
                        let _e2234 = local_28[0u].member_1;
                        let _e2235 = function_10(_e2227, _e2229, _e2232, _e2234);
                        let _e2241 = ((_e2222.member - _e2235.member) - select(0u, 1u, (_e2222.member_1 < _e2235.member_1)));
                        let _e2242 = (_e2222.member_1 - _e2235.member_1);
                        local_25 = array<type_9, 3>(type_9(_e1892[1][0][0].member, _e1892[1][0][0].member_1), type_9(_e1892[1][0][1].member, _e1892[1][0][1].member_1), type_9(_e1892[1][0][2].member, _e1892[1][0][2].member_1));
                        local_26 = array<type_9, 3>(type_9(_e1892[2][1][0].member, _e1892[2][1][0].member_1), type_9(_e1892[2][1][1].member, _e1892[2][1][1].member_1), type_9(_e1892[2][1][2].member, _e1892[2][1][2].member_1));
                        let _e2275 = local_25[1u].member;
                        let _e2277 = local_25[1u].member_1;
                        let _e2280 = local_26[2u].member;
                        let _e2282 = local_26[2u].member_1;
                        let _e2283 = function_10(_e2275, _e2277, _e2280, _e2282);
                        let _e2288 = local_25[2u].member;
                        let _e2290 = local_25[2u].member_1;
                        let _e2293 = local_26[1u].member;
                        let _e2295 = local_26[1u].member_1;
                        let _e2296 = function_10(_e2288, _e2290, _e2293, _e2295);
                        let _e2303 = (_e2283.member_1 - _e2296.member_1);
                        local_23 = array<type_9, 3>(type_9(_e1892[1][0][0].member, _e1892[1][0][0].member_1), type_9(_e1892[1][0][1].member, _e1892[1][0][1].member_1), type_9(_e1892[1][0][2].member, _e1892[1][0][2].member_1));
                        local_24 = array<type_9, 3>(type_9(_e1892[2][1][0].member, _e1892[2][1][0].member_1), type_9(_e1892[2][1][1].member, _e1892[2][1][1].member_1), type_9(_e1892[2][1][2].member, _e1892[2][1][2].member_1));
                        let _e2332 = local_23[2u].member;
                        let _e2334 = local_23[2u].member_1;
                        let _e2337 = local_24[0u].member;
                        let _e2339 = local_24[0u].member_1;
                        let _e2340 = function_10(_e2332, _e2334, _e2337, _e2339);
                        let _e2345 = local_23[0u].member;
                        let _e2347 = local_23[0u].member_1;
                        let _e2350 = local_24[2u].member;
                        let _e2352 = local_24[2u].member_1;
                        let _e2353 = function_10(_e2345, _e2347, _e2350, _e2352);
                        let _e2360 = (_e2340.member_1 - _e2353.member_1);
                        local_21 = array<type_9, 3>(type_9(_e1892[1][0][0].member, _e1892[1][0][0].member_1), type_9(_e1892[1][0][1].member, _e1892[1][0][1].member_1), type_9(_e1892[1][0][2].member, _e1892[1][0][2].member_1));
                        local_22 = array<type_9, 3>(type_9(_e1892[2][1][0].member, _e1892[2][1][0].member_1), type_9(_e1892[2][1][1].member, _e1892[2][1][1].member_1), type_9(_e1892[2][1][2].member, _e1892[2][1][2].member_1));
                        let _e2389 = local_21[0u].member;
                        let _e2391 = local_21[0u].member_1;
                        let _e2394 = local_22[1u].member;
                        let _e2396 = local_22[1u].member_1;
                        let _e2397 = function_10(_e2389, _e2391, _e2394, _e2396);
                        let _e2402 = local_21[1u].member;
                        let _e2404 = local_21[1u].member_1;
                        let _e2407 = local_22[0u].member;
                        let _e2409 = local_22[0u].member_1;
                        let _e2410 = function_10(_e2402, _e2404, _e2407, _e2409);
                        let _e2417 = (_e2397.member_1 - _e2410.member_1);
                        local_19 = array<type_9, 3>(type_9(_e1892[1][1][0].member, _e1892[1][1][0].member_1), type_9(_e1892[1][1][1].member, _e1892[1][1][1].member_1), type_9(_e1892[1][1][2].member, _e1892[1][1][2].member_1));
                        local_20 = array<type_9, 3>(type_9(_e1892[2][0][0].member, _e1892[2][0][0].member_1), type_9(_e1892[2][0][1].member, _e1892[2][0][1].member_1), type_9(_e1892[2][0][2].member, _e1892[2][0][2].member_1));
                        let _e2450 = local_19[1u].member;
                        let _e2452 = local_19[1u].member_1;
                        let _e2455 = local_20[2u].member;
                        let _e2457 = local_20[2u].member_1;
                        let _e2458 = function_10(_e2450, _e2452, _e2455, _e2457);
                        let _e2463 = local_19[2u].member;
                        let _e2465 = local_19[2u].member_1;
                        let _e2468 = local_20[1u].member;
                        let _e2470 = local_20[1u].member_1;
                        let _e2471 = function_10(_e2463, _e2465, _e2468, _e2470);
                        local_17 = array<type_9, 3>(type_9(_e1892[1][1][0].member, _e1892[1][1][0].member_1), type_9(_e1892[1][1][1].member, _e1892[1][1][1].member_1), type_9(_e1892[1][1][2].member, _e1892[1][1][2].member_1));
                        local_18 = array<type_9, 3>(type_9(_e1892[2][0][0].member, _e1892[2][0][0].member_1), type_9(_e1892[2][0][1].member, _e1892[2][0][1].member_1), type_9(_e1892[2][0][2].member, _e1892[2][0][2].member_1));
                        let _e2507 = local_17[2u].member;
                        let _e2509 = local_17[2u].member_1;
                        let _e2512 = local_18[0u].member;
                        let _e2514 = local_18[0u].member_1;
                        let _e2515 = function_10(_e2507, _e2509, _e2512, _e2514);
                        let _e2520 = local_17[0u].member;
                        let _e2522 = local_17[0u].member_1;
                        let _e2525 = local_18[2u].member;
                        let _e2527 = local_18[2u].member_1;
                        let _e2528 = function_10(_e2520, _e2522, _e2525, _e2527);
                        local_15 = array<type_9, 3>(type_9(_e1892[1][1][0].member, _e1892[1][1][0].member_1), type_9(_e1892[1][1][1].member, _e1892[1][1][1].member_1), type_9(_e1892[1][1][2].member, _e1892[1][1][2].member_1));
                        local_16 = array<type_9, 3>(type_9(_e1892[2][0][0].member, _e1892[2][0][0].member_1), type_9(_e1892[2][0][1].member, _e1892[2][0][1].member_1), type_9(_e1892[2][0][2].member, _e1892[2][0][2].member_1));
                        let _e2564 = local_15[0u].member;
                        let _e2566 = local_15[0u].member_1;
                        let _e2569 = local_16[1u].member;
                        let _e2571 = local_16[1u].member_1;
                        let _e2572 = function_10(_e2564, _e2566, _e2569, _e2571);
                        let _e2577 = local_15[1u].member;
                        let _e2579 = local_15[1u].member_1;
                        let _e2582 = local_16[0u].member;
                        let _e2584 = local_16[0u].member_1;
                        let _e2585 = function_10(_e2577, _e2579, _e2582, _e2584);
                        let _e2593 = (_e2303 + (_e2458.member_1 - _e2471.member_1));
                        let _e2597 = ((((_e2283.member - _e2296.member) - select(0u, 1u, (_e2283.member_1 < _e2296.member_1))) + ((_e2458.member - _e2471.member) - select(0u, 1u, (_e2458.member_1 < _e2471.member_1)))) + select(0u, 1u, (_e2593 < _e2303)));
                        let _e2598 = (_e2360 + (_e2515.member_1 - _e2528.member_1));
                        let _e2602 = ((((_e2340.member - _e2353.member) - select(0u, 1u, (_e2340.member_1 < _e2353.member_1))) + ((_e2515.member - _e2528.member) - select(0u, 1u, (_e2515.member_1 < _e2528.member_1)))) + select(0u, 1u, (_e2598 < _e2360)));
                        let _e2603 = (_e2417 + (_e2572.member_1 - _e2585.member_1));
                        let _e2607 = ((((_e2397.member - _e2410.member) - select(0u, 1u, (_e2397.member_1 < _e2410.member_1))) + ((_e2572.member - _e2585.member) - select(0u, 1u, (_e2572.member_1 < _e2585.member_1)))) + select(0u, 1u, (_e2603 < _e2417)));
                        let _e2614 = function_10(_e1892[0][0][0].member, _e1892[0][0][0].member_1, _e1952, _e1953);
                        let _e2621 = function_10(_e1892[0][0][1].member, _e1892[0][0][1].member_1, _e2009, _e2010);
                        let _e2624 = (_e2614.member_1 + _e2621.member_1);
                        let _e2633 = function_10(_e1892[0][0][2].member, _e1892[0][0][2].member_1, _e2066, _e2067);
                        let _e2636 = (_e2624 + _e2633.member_1);
                        let _e2641 = function_14(((((_e2614.member + _e2621.member) + select(0u, 1u, (_e2624 < _e2614.member_1))) + _e2633.member) + select(0u, 1u, (_e2636 < _e2624))), _e2636);
                        let _e2650 = function_10(_e1892[0][1][0].member, _e1892[0][1][0].member_1, _e1952, _e1953);
                        let _e2657 = function_10(_e1892[0][1][1].member, _e1892[0][1][1].member_1, _e2009, _e2010);
                        let _e2660 = (_e2650.member_1 + _e2657.member_1);
                        let _e2669 = function_10(_e1892[0][1][2].member, _e1892[0][1][2].member_1, _e2066, _e2067);
                        let _e2672 = (_e2660 + _e2669.member_1);
                        let _e2683 = function_10(_e1892[0][0][0].member, _e1892[0][0][0].member_1, _e2597, _e2593);
                        let _e2690 = function_10(_e1892[0][0][1].member, _e1892[0][0][1].member_1, _e2602, _e2598);
                        let _e2693 = (_e2683.member_1 + _e2690.member_1);
                        let _e2702 = function_10(_e1892[0][0][2].member, _e1892[0][0][2].member_1, _e2607, _e2603);
                        let _e2705 = (_e2693 + _e2702.member_1);
                        let _e2710 = (_e2672 + _e2705);
                        let _e2714 = ((((((_e2650.member + _e2657.member) + select(0u, 1u, (_e2660 < _e2650.member_1))) + _e2669.member) + select(0u, 1u, (_e2672 < _e2660))) + ((((_e2683.member + _e2690.member) + select(0u, 1u, (_e2693 < _e2683.member_1))) + _e2702.member) + select(0u, 1u, (_e2705 < _e2693)))) + select(0u, 1u, (_e2710 < _e2672)));
                        let _e2721 = function_10(_e1892[0][0][0].member, _e1892[0][0][0].member_1, _e2127, _e2128);
                        let _e2728 = function_10(_e1892[0][0][1].member, _e1892[0][0][1].member_1, _e2184, _e2185);
                        let _e2731 = (_e2721.member_1 + _e2728.member_1);
                        let _e2740 = function_10(_e1892[0][0][2].member, _e1892[0][0][2].member_1, _e2241, _e2242);
                        let _e2743 = (_e2731 + _e2740.member_1);
                        let _e2754 = function_10(_e1892[0][1][0].member, _e1892[0][1][0].member_1, _e2597, _e2593);
                        let _e2761 = function_10(_e1892[0][1][1].member, _e1892[0][1][1].member_1, _e2602, _e2598);
                        let _e2764 = (_e2754.member_1 + _e2761.member_1);
                        let _e2773 = function_10(_e1892[0][1][2].member, _e1892[0][1][2].member_1, _e2607, _e2603);
                        let _e2776 = (_e2764 + _e2773.member_1);
                        let _e2781 = (_e2743 + _e2776);
                        let _e2785 = ((((((_e2721.member + _e2728.member) + select(0u, 1u, (_e2731 < _e2721.member_1))) + _e2740.member) + select(0u, 1u, (_e2743 < _e2731))) + ((((_e2754.member + _e2761.member) + select(0u, 1u, (_e2764 < _e2754.member_1))) + _e2773.member) + select(0u, 1u, (_e2776 < _e2764)))) + select(0u, 1u, (_e2781 < _e2743)));
                        let _e2792 = function_10(_e1892[0][1][0].member, _e1892[0][1][0].member_1, _e2127, _e2128);
                        let _e2799 = function_10(_e1892[0][1][1].member, _e1892[0][1][1].member_1, _e2184, _e2185);
                        let _e2802 = (_e2792.member_1 + _e2799.member_1);
                        let _e2811 = function_10(_e1892[0][1][2].member, _e1892[0][1][2].member_1, _e2241, _e2242);
                        let _e2814 = (_e2802 + _e2811.member_1);
                        let _e2819 = function_14(((((_e2792.member + _e2799.member) + select(0u, 1u, (_e2802 < _e2792.member_1))) + _e2811.member) + select(0u, 1u, (_e2814 < _e2802))), _e2814);
                        let _e2829 = select((bitcast<u32>(31i) - firstLeadingBit(_e1317)), 32u, (_e1317 == 0u));
                        let _e2831 = select(18u, _e2829, (18u < _e2829));
                        phi_5104_ = array<type_9, 4>(_e2641, type_9(_e2714, _e2710), type_9(_e2785, _e2781), _e2819);
                        phi_5107_ = false;
                        phi_5109_ = false;
                        phi_5111_ = false;
                        phi_5113_ = false;
                        phi_5115_ = type_20(0u, 0u, 0u);
                        phi_5119_ = 0u;
                        phi_5121_ = 0u;
                        phi_5123_ = 0u;
                        phi_5125_ = 0u;
                        phi_5127_ = 0u;
                        loop {
                            let _e2833 = phi_5104_;
                            let _e2835 = phi_5107_;
                            let _e2837 = phi_5109_;
                            let _e2839 = phi_5111_;
                            let _e2841 = phi_5113_;
                            let _e2843 = phi_5115_;
                            let _e2845 = phi_5119_;
                            let _e2847 = phi_5121_;
                            let _e2849 = phi_5123_;
                            let _e2851 = phi_5125_;
                            let _e2853 = phi_5127_;
                            if (_e2849 < 64u) {
                                phi_5136_ = _e2833;
                                phi_5139_ = _e2839;
                                phi_5141_ = _e2841;
                                phi_5145_ = _e2835;
                                phi_5147_ = false;
                                phi_5149_ = false;
                                phi_5151_ = false;
                                phi_5153_ = _e2845;
                                phi_5155_ = _e2847;
                                phi_5157_ = _e2849;
                                phi_5159_ = _e2851;
                                phi_5161_ = _e2853;
                                loop {
                                    let _e2856 = phi_5136_;
                                    let _e2858 = phi_5139_;
                                    let _e2860 = phi_5141_;
                                    let _e2862 = phi_5145_;
                                    let _e2864 = phi_5147_;
                                    let _e2866 = phi_5149_;
                                    let _e2868 = phi_5151_;
                                    let _e2870 = phi_5153_;
                                    let _e2872 = phi_5155_;
                                    let _e2874 = phi_5157_;
                                    let _e2876 = phi_5159_;
                                    let _e2878 = phi_5161_;
                                    local_42 = _e2862;
                                    local_43 = _e2868;
                                    local_44 = _e2856;
                                    local_45 = _e2856;
                                    local_46 = _e2856;
                                    local_47 = _e2856;
                                    local_48 = _e2856;
                                    local_49 = _e2856;
                                    local_50 = _e2856;
                                    local_51 = _e2856;
                                    local_52 = _e2856;
                                    local_53 = _e2856;
                                    local_54 = _e2856;
                                    local_55 = _e2856;
                                    local_56 = _e2876;
                                    local_57 = _e2872;
                                    local_58 = _e2870;
                                    local_59 = _e2876;
                                    local_60 = _e2856;
                                    local_61 = _e2856;
                                    local_62 = _e2856;
                                    local_63 = _e2856;
                                    local_64 = _e2856;
                                    local_65 = _e2856;
                                    local_66 = _e2864;
                                    local_67 = _e2864;
                                    local_68 = _e2876;
                                    local_69 = _e2866;
                                    local_70 = _e2876;
                                    local_71 = _e2856;
                                    local_72 = _e2856;
                                    local_73 = _e2856;
                                    local_74 = _e2872;
                                    local_75 = _e2872;
                                    local_76 = _e2856;
                                    local_77 = _e2856;
                                    local_78 = _e2856;
                                    local_79 = _e2872;
                                    local_80 = _e2870;
                                    local_81 = _e2856;
                                    local_82 = _e2856;
                                    local_83 = _e2856;
                                    local_84 = _e2856;
                                    local_85 = _e2856;
                                    local_86 = _e2856;
                                    local_87 = _e2856;
                                    local_88 = _e2856;
                                    local_90 = _e2872;
                                    local_91 = _e2870;
                                    local_92 = _e2876;
                                    local_93 = _e2872;
                                    local_94 = _e2872;
                                    local_95 = _e2864;
                                    local_149 = _e2868;
                                    local_150 = _e2858;
                                    local_151 = _e2860;
                                    local_152 = _e2868;
                                    local_153 = _e2858;
                                    local_154 = _e2860;
                                    local_155 = _e2868;
                                    local_96 = _e2878;
                                    local_97 = _e2878;
                                    local_98 = _e2876;
                                    local_99 = _e2876;
                                    local_100 = _e2876;
                                    local_101 = _e2872;
                                    local_156 = _e2876;
                                    local_157 = _e2878;
                                    local_158 = _e2856;
                                    local_159 = _e2870;
                                    local_160 = _e2872;
                                    local_161 = _e2874;
                                    if (_e2874 < 64u) {
                                        if _e2868 {
                                            phi_6039_ = array<type_9, 4>();
                                            phi_6040_ = bool();
                                            phi_6041_ = bool();
                                            phi_6043_ = bool();
                                            phi_6044_ = bool();
                                            phi_6045_ = bool();
                                            phi_6046_ = bool();
                                            phi_6047_ = u32();
                                            phi_6048_ = u32();
                                            phi_6049_ = u32();
                                            phi_6050_ = u32();
                                            phi_6051_ = u32();
                                            phi_6052_ = false;
                                        } else {
                                            if _e2862 {
                                                phi_6025_ = array<type_9, 4>();
                                                phi_6026_ = bool();
                                                phi_6027_ = bool();
                                                phi_6029_ = bool();
                                                phi_6030_ = bool();
                                                phi_6031_ = bool();
                                                phi_6032_ = bool();
                                                phi_6033_ = u32();
                                                phi_6034_ = u32();
                                                phi_6035_ = u32();
                                                phi_6036_ = u32();
                                                phi_6037_ = u32();
                                                phi_6038_ = false;
                                            } else {
                                                let _e2881 = (31u - _e2876);
                                                let _e2884 = (_e2878 << bitcast<u32>((_e2881 & 31u)));
                                                let _e2888 = ((_e2878 + 1u) << bitcast<u32>((_e2881 & 31u)));
                                                if (_e2884 > _e1315) {
                                                    phi_5367_ = bool();
                                                    phi_5368_ = true;
                                                } else {
                                                    let _e2890 = (_e2888 < _e1313);
                                                    if _e2890 {
                                                        phi_5366_ = bool();
                                                    } else {
                                                        let _e2895 = function_13(128u);
                                                        let _e2900 = ((_e2856[0].member >> bitcast<u32>(31i)) != 0u);
                                                        let _e2928 = function_13(128u);
                                                        let _e2933 = ((_e2856[1].member >> bitcast<u32>(31i)) != 0u);
                                                        let _e2962 = function_13(128u);
                                                        let _e2967 = ((_e2856[2].member >> bitcast<u32>(31i)) != 0u);
                                                        let _e2996 = function_13(128u);
                                                        let _e3001 = ((_e2856[3].member >> bitcast<u32>(31i)) != 0u);
                                                        phi_5366_ = ((((select(0u, select(1u, 2u, ((_e2856[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2895.member - select(_e2856[0].member, (~(_e2856[0].member) + select(0u, 1u, (_e2856[0].member_1 == 0u))), _e2900)) - select(0u, 1u, (_e2895.member_1 < select(_e2856[0].member_1, (~(_e2856[0].member_1) + 1u), _e2900)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e2856[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e2928.member - select(_e2856[1].member, (~(_e2856[1].member) + select(0u, 1u, (_e2856[1].member_1 == 0u))), _e2933)) - select(0u, 1u, (_e2928.member_1 < select(_e2856[1].member_1, (~(_e2856[1].member_1) + 1u), _e2933)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2856[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e2962.member - select(_e2856[2].member, (~(_e2856[2].member) + select(0u, 1u, (_e2856[2].member_1 == 0u))), _e2967)) - select(0u, 1u, (_e2962.member_1 < select(_e2856[2].member_1, (~(_e2856[2].member_1) + 1u), _e2967)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2856[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e2996.member - select(_e2856[3].member, (~(_e2856[3].member) + select(0u, 1u, (_e2856[3].member_1 == 0u))), _e3001)) - select(0u, 1u, (_e2996.member_1 < select(_e2856[3].member_1, (~(_e2856[3].member_1) + 1u), _e3001)))) >> bitcast<u32>(31i)) != 0u))) != 0u);
                                                    }
                                                    let _e3028 = phi_5366_;
                                                    phi_5367_ = _e3028;
                                                    phi_5368_ = _e2890;
                                                }
                                                let _e3030 = phi_5367_;
                                                let _e3032 = phi_5368_;
                                                let _e3033 = select(_e3030, true, _e3032);
                                                let _e3038 = function_13(128u);
                                                let _e3043 = ((_e2856[0].member >> bitcast<u32>(31i)) != 0u);
                                                let _e3066 = select(0u, select(1u, 2u, ((_e2856[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3038.member - select(_e2856[0].member, (~(_e2856[0].member) + select(0u, 1u, (_e2856[0].member_1 == 0u))), _e3043)) - select(0u, 1u, (_e3038.member_1 < select(_e2856[0].member_1, (~(_e2856[0].member_1) + 1u), _e3043)))) >> bitcast<u32>(31i)) != 0u));
                                                let _e3071 = function_13(128u);
                                                let _e3076 = ((_e2856[1].member >> bitcast<u32>(31i)) != 0u);
                                                let _e3099 = select(0u, select(1u, 2u, ((_e2856[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e3071.member - select(_e2856[1].member, (~(_e2856[1].member) + select(0u, 1u, (_e2856[1].member_1 == 0u))), _e3076)) - select(0u, 1u, (_e3071.member_1 < select(_e2856[1].member_1, (~(_e2856[1].member_1) + 1u), _e3076)))) >> bitcast<u32>(31i)) != 0u));
                                                let _e3104 = function_13(128u);
                                                let _e3109 = ((_e2856[2].member >> bitcast<u32>(31i)) != 0u);
                                                let _e3132 = select(0u, select(1u, 2u, ((_e2856[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e3104.member - select(_e2856[2].member, (~(_e2856[2].member) + select(0u, 1u, (_e2856[2].member_1 == 0u))), _e3109)) - select(0u, 1u, (_e3104.member_1 < select(_e2856[2].member_1, (~(_e2856[2].member_1) + 1u), _e3109)))) >> bitcast<u32>(31i)) != 0u));
                                                let _e3137 = function_13(128u);
                                                let _e3142 = ((_e2856[3].member >> bitcast<u32>(31i)) != 0u);
                                                let _e3165 = select(0u, select(1u, 2u, ((_e2856[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e3137.member - select(_e2856[3].member, (~(_e2856[3].member) + select(0u, 1u, (_e2856[3].member_1 == 0u))), _e3142)) - select(0u, 1u, (_e3137.member_1 < select(_e2856[3].member_1, (~(_e2856[3].member_1) + 1u), _e3142)))) >> bitcast<u32>(31i)) != 0u));
                                                let _e3175 = select(false, select(true, select(false, (_e3099 != 0u), (_e3132 == _e3165)), select(true, (_e3132 == 0u), (_e3099 == _e3066))), ((_e3066 | _e3165) == 3u));
                                                let _e3180 = function_13(128u);
                                                let _e3185 = ((_e2856[0].member >> bitcast<u32>(31i)) != 0u);
                                                let _e3211 = select(false, (_e2884 >= _e1313), (select(0u, select(1u, 2u, ((_e2856[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3180.member - select(_e2856[0].member, (~(_e2856[0].member) + select(0u, 1u, (_e2856[0].member_1 == 0u))), _e3185)) - select(0u, 1u, (_e3180.member_1 < select(_e2856[0].member_1, (~(_e2856[0].member_1) + 1u), _e3185)))) >> bitcast<u32>(31i)) != 0u)) == 0u));
                                                let _e3212 = (_e2876 == 3u);
                                                let _e3213 = (_e2876 == 8u);
                                                let _e3218 = select(select(select((_e2876 == 14u), bool(), _e3213), bool(), _e3212), true, select(_e3213, true, _e3212));
                                                let _e3220 = select(false, !(_e2858), _e3211);
                                                let _e3221 = (_e2876 == 31u);
                                                let _e3232 = select(select(false, !(_e2860), select(select(select(select(select(false, !(_e2837), _e3175), bool(), _e3211), bool(), _e3218), bool(), _e3221), true, select(select(_e3211, true, _e3218), true, _e3221))), true, _e3220);
                                                if _e3033 {
                                                    phi_6019_ = _e2856;
                                                    phi_6020_ = _e2858;
                                                    phi_6021_ = _e2860;
                                                    phi_6023_ = _e2876;
                                                    phi_6024_ = _e2878;
                                                } else {
                                                    if _e3232 {
                                                        phi_6013_ = _e2856;
                                                        phi_6014_ = _e2858;
                                                        phi_6015_ = _e2860;
                                                        phi_6017_ = _e2876;
                                                        phi_6018_ = _e2878;
                                                    } else {
                                                        let _e3241 = (_e2856[0].member_1 + _e2856[1].member_1);
                                                        let _e3245 = ((_e2856[0].member + _e2856[1].member) + select(0u, 1u, (_e3241 < _e2856[0].member_1)));
                                                        let _e3253 = bitcast<u32>((bitcast<i32>(_e3245) >> bitcast<u32>(1u)));
                                                        let _e3256 = ((_e3241 >> bitcast<u32>(1u)) | ((_e3245 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                        let _e3265 = (_e2856[1].member_1 + _e2856[2].member_1);
                                                        let _e3269 = ((_e2856[1].member + _e2856[2].member) + select(0u, 1u, (_e3265 < _e2856[1].member_1)));
                                                        let _e3277 = bitcast<u32>((bitcast<i32>(_e3269) >> bitcast<u32>(1u)));
                                                        let _e3280 = ((_e3265 >> bitcast<u32>(1u)) | ((_e3269 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                        let _e3289 = (_e2856[2].member_1 + _e2856[3].member_1);
                                                        let _e3293 = ((_e2856[2].member + _e2856[3].member) + select(0u, 1u, (_e3289 < _e2856[2].member_1)));
                                                        let _e3301 = bitcast<u32>((bitcast<i32>(_e3293) >> bitcast<u32>(1u)));
                                                        let _e3304 = ((_e3289 >> bitcast<u32>(1u)) | ((_e3293 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                        let _e3305 = (_e3256 + _e3280);
                                                        let _e3309 = ((_e3253 + _e3277) + select(0u, 1u, (_e3305 < _e3256)));
                                                        let _e3317 = bitcast<u32>((bitcast<i32>(_e3309) >> bitcast<u32>(1u)));
                                                        let _e3320 = ((_e3305 >> bitcast<u32>(1u)) | ((_e3309 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                        let _e3321 = (_e3280 + _e3304);
                                                        let _e3325 = ((_e3277 + _e3301) + select(0u, 1u, (_e3321 < _e3280)));
                                                        let _e3333 = bitcast<u32>((bitcast<i32>(_e3325) >> bitcast<u32>(1u)));
                                                        let _e3336 = ((_e3321 >> bitcast<u32>(1u)) | ((_e3325 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                        let _e3337 = (_e3320 + _e3336);
                                                        let _e3341 = ((_e3317 + _e3333) + select(0u, 1u, (_e3337 < _e3320)));
                                                        let _e3349 = bitcast<u32>((bitcast<i32>(_e3341) >> bitcast<u32>(1u)));
                                                        let _e3352 = ((_e3337 >> bitcast<u32>(1u)) | ((_e3341 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                        let _e3353 = (2u * _e2878);
                                                        let _e3364 = function_13(128u);
                                                        let _e3369 = ((_e2856[0].member >> bitcast<u32>(31i)) != 0u);
                                                        let _e3393 = function_13(128u);
                                                        let _e3398 = ((_e3253 >> bitcast<u32>(31i)) != 0u);
                                                        let _e3420 = function_13(128u);
                                                        let _e3425 = ((_e3317 >> bitcast<u32>(31i)) != 0u);
                                                        let _e3447 = function_13(128u);
                                                        let _e3452 = ((_e3349 >> bitcast<u32>(31i)) != 0u);
                                                        if ((((select(0u, select(1u, 2u, ((_e2856[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3364.member - select(_e2856[0].member, (~(_e2856[0].member) + select(0u, 1u, (_e2856[0].member_1 == 0u))), _e3369)) - select(0u, 1u, (_e3364.member_1 < select(_e2856[0].member_1, (~(_e2856[0].member_1) + 1u), _e3369)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e3253 >> bitcast<u32>(31i)) != 0u)), ((((_e3393.member - select(_e3253, (~(_e3253) + select(0u, 1u, (_e3256 == 0u))), _e3398)) - select(0u, 1u, (_e3393.member_1 < select(_e3256, (~(_e3256) + 1u), _e3398)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e3317 >> bitcast<u32>(31i)) != 0u)), ((((_e3420.member - select(_e3317, (~(_e3317) + select(0u, 1u, (_e3320 == 0u))), _e3425)) - select(0u, 1u, (_e3420.member_1 < select(_e3320, (~(_e3320) + 1u), _e3425)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e3349 >> bitcast<u32>(31i)) != 0u)), ((((_e3447.member - select(_e3349, (~(_e3349) + select(0u, 1u, (_e3352 == 0u))), _e3452)) - select(0u, 1u, (_e3447.member_1 < select(_e3352, (~(_e3352) + 1u), _e3452)))) >> bitcast<u32>(31i)) != 0u))) != 0u) {
                                                            phi_6010_ = array<type_9, 4>(type_9(_e3349, _e3352), type_9(_e3333, _e3336), type_9(_e3301, _e3304), _e2856[3]);
                                                            phi_6011_ = false;
                                                            phi_6012_ = (_e3353 + 1u);
                                                        } else {
                                                            phi_6010_ = array<type_9, 4>(_e2856[0], type_9(_e3253, _e3256), type_9(_e3317, _e3320), type_9(_e3349, _e3352));
                                                            phi_6011_ = _e2858;
                                                            phi_6012_ = _e3353;
                                                        }
                                                        let _e3482 = phi_6010_;
                                                        let _e3484 = phi_6011_;
                                                        let _e3486 = phi_6012_;
                                                        phi_6013_ = _e3482;
                                                        phi_6014_ = _e3484;
                                                        phi_6015_ = false;
                                                        phi_6017_ = (_e2876 + 1u);
                                                        phi_6018_ = _e3486;
                                                    }
                                                    let _e3488 = phi_6013_;
                                                    let _e3490 = phi_6014_;
                                                    let _e3492 = phi_6015_;
                                                    let _e3494 = phi_6017_;
                                                    let _e3496 = phi_6018_;
                                                    phi_6019_ = _e3488;
                                                    phi_6020_ = _e3490;
                                                    phi_6021_ = _e3492;
                                                    phi_6023_ = _e3494;
                                                    phi_6024_ = _e3496;
                                                }
                                                let _e3498 = phi_6019_;
                                                let _e3500 = phi_6020_;
                                                let _e3502 = phi_6021_;
                                                let _e3504 = phi_6023_;
                                                let _e3506 = phi_6024_;
                                                phi_6025_ = _e3498;
                                                phi_6026_ = _e3500;
                                                phi_6027_ = _e3502;
                                                phi_6029_ = _e3232;
                                                phi_6030_ = _e3220;
                                                phi_6031_ = _e3175;
                                                phi_6032_ = _e3033;
                                                phi_6033_ = _e2888;
                                                phi_6034_ = _e2884;
                                                phi_6035_ = (_e2874 + 1u);
                                                phi_6036_ = _e3504;
                                                phi_6037_ = _e3506;
                                                phi_6038_ = true;
                                            }
                                            let _e3508 = phi_6025_;
                                            let _e3510 = phi_6026_;
                                            let _e3512 = phi_6027_;
                                            let _e3514 = phi_6029_;
                                            let _e3516 = phi_6030_;
                                            let _e3518 = phi_6031_;
                                            let _e3520 = phi_6032_;
                                            let _e3522 = phi_6033_;
                                            let _e3524 = phi_6034_;
                                            let _e3526 = phi_6035_;
                                            let _e3528 = phi_6036_;
                                            let _e3530 = phi_6037_;
                                            let _e3532 = phi_6038_;
                                            phi_6039_ = _e3508;
                                            phi_6040_ = _e3510;
                                            phi_6041_ = _e3512;
                                            phi_6043_ = _e3514;
                                            phi_6044_ = _e3516;
                                            phi_6045_ = _e3518;
                                            phi_6046_ = _e3520;
                                            phi_6047_ = _e3522;
                                            phi_6048_ = _e3524;
                                            phi_6049_ = _e3526;
                                            phi_6050_ = _e3528;
                                            phi_6051_ = _e3530;
                                            phi_6052_ = _e3532;
                                        }
                                        let _e3534 = phi_6039_;
                                        let _e3536 = phi_6040_;
                                        let _e3538 = phi_6041_;
                                        let _e3540 = phi_6043_;
                                        let _e3542 = phi_6044_;
                                        let _e3544 = phi_6045_;
                                        let _e3546 = phi_6046_;
                                        let _e3548 = phi_6047_;
                                        let _e3550 = phi_6048_;
                                        let _e3552 = phi_6049_;
                                        let _e3554 = phi_6050_;
                                        let _e3556 = phi_6051_;
                                        let _e3558 = phi_6052_;
                                        phi_5137_ = _e3534;
                                        phi_5140_ = _e3536;
                                        phi_5142_ = _e3538;
                                        phi_5146_ = _e3540;
                                        phi_5148_ = _e3542;
                                        phi_5150_ = _e3544;
                                        phi_5152_ = _e3546;
                                        phi_5154_ = _e3548;
                                        phi_5156_ = _e3550;
                                        phi_5158_ = _e3552;
                                        phi_5160_ = _e3554;
                                        phi_5162_ = _e3556;
                                        phi_6053_ = _e3558;
                                    } else {
                                        phi_5137_ = array<type_9, 4>();
                                        phi_5140_ = bool();
                                        phi_5142_ = bool();
                                        phi_5146_ = bool();
                                        phi_5148_ = bool();
                                        phi_5150_ = bool();
                                        phi_5152_ = bool();
                                        phi_5154_ = u32();
                                        phi_5156_ = u32();
                                        phi_5158_ = u32();
                                        phi_5160_ = u32();
                                        phi_5162_ = u32();
                                        phi_6053_ = false;
                                    }
                                    let _e3560 = phi_5137_;
                                    let _e3562 = phi_5140_;
                                    let _e3564 = phi_5142_;
                                    let _e3566 = phi_5146_;
                                    let _e3568 = phi_5148_;
                                    let _e3570 = phi_5150_;
                                    let _e3572 = phi_5152_;
                                    let _e3574 = phi_5154_;
                                    let _e3576 = phi_5156_;
                                    let _e3578 = phi_5158_;
                                    let _e3580 = phi_5160_;
                                    let _e3582 = phi_5162_;
                                    let _e3584 = phi_6053_;
                                    continue;
                                    continuing {
                                        phi_5136_ = _e3560;
                                        phi_5139_ = _e3562;
                                        phi_5141_ = _e3564;
                                        phi_5145_ = _e3566;
                                        phi_5147_ = _e3568;
                                        phi_5149_ = _e3570;
                                        phi_5151_ = _e3572;
                                        phi_5153_ = _e3574;
                                        phi_5155_ = _e3576;
                                        phi_5157_ = _e3578;
                                        phi_5159_ = _e3580;
                                        phi_5161_ = _e3582;
                                        break if !(_e3584);
                                    }
                                }
                                let _e3587 = local_42;
                                if _e3587 {
                                    let _e3589 = local_43;
                                    if _e3589 {
                                        phi_8924_ = _e2835;
                                        phi_8925_ = _e2837;
                                        let _e9781 = local_150;
                                        phi_8926_ = _e9781;
                                        let _e9784 = local_151;
                                        phi_8927_ = _e9784;
                                        phi_8928_ = _e2843;
                                        let _e9788 = local_152;
                                        phi_8929_ = _e9788;
                                        phi_8930_ = bool();
                                        phi_8931_ = type_20();
                                        phi_8932_ = true;
                                        phi_8933_ = false;
                                        phi_8934_ = false;
                                        phi_8935_ = false;
                                    } else {
                                        let _e3591 = local_44;
                                        let _e3595 = local_45;
                                        let _e3598 = function_13(128u);
                                        let _e3603 = ((_e3591[0].member >> bitcast<u32>(31i)) != 0u);
                                        let _e3611 = local_46;
                                        let _e3630 = local_47;
                                        let _e3634 = local_48;
                                        let _e3637 = function_13(128u);
                                        let _e3642 = ((_e3630[1].member >> bitcast<u32>(31i)) != 0u);
                                        let _e3650 = local_49;
                                        let _e3670 = local_50;
                                        let _e3674 = local_51;
                                        let _e3677 = function_13(128u);
                                        let _e3682 = ((_e3670[2].member >> bitcast<u32>(31i)) != 0u);
                                        let _e3690 = local_52;
                                        let _e3710 = local_53;
                                        let _e3714 = local_54;
                                        let _e3717 = function_13(128u);
                                        let _e3722 = ((_e3710[3].member >> bitcast<u32>(31i)) != 0u);
                                        let _e3730 = local_55;
                                        let _e3751 = local_56;
                                        let _e3756 = local_57;
                                        let _e3758 = local_58;
                                        let _e3760 = local_59;
                                        let _e3761 = type_20(_e3756, _e3758, _e3760);
                                        let _e3763 = local_60;
                                        let _e3767 = local_61;
                                        let _e3770 = function_13(128u);
                                        let _e3775 = ((_e3763[0].member >> bitcast<u32>(31i)) != 0u);
                                        let _e3783 = local_62;
                                        let _e3802 = local_63;
                                        let _e3806 = local_64;
                                        let _e3809 = function_13(128u);
                                        let _e3814 = ((_e3802[3].member >> bitcast<u32>(31i)) != 0u);
                                        let _e3822 = local_65;
                                        let _e3841 = ((select(0u, select(1u, 2u, ((_e3763[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3770.member - select(_e3783[0].member, (~(_e3763[0].member) + select(0u, 1u, (_e3767[0].member_1 == 0u))), _e3775)) - select(0u, 1u, (_e3770.member_1 < select(_e3783[0].member_1, (~(_e3767[0].member_1) + 1u), _e3775)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e3802[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e3809.member - select(_e3822[3].member, (~(_e3802[3].member) + select(0u, 1u, (_e3806[3].member_1 == 0u))), _e3814)) - select(0u, 1u, (_e3809.member_1 < select(_e3822[3].member_1, (~(_e3806[3].member_1) + 1u), _e3814)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                        let _e3843 = local_66;
                                        let _e3846 = local_67;
                                        if _e3846 {
                                            let _e4463 = local_93;
                                            let _e4466 = local_94;
                                            phi_7161_ = _e2835;
                                            phi_7162_ = _e2837;
                                            phi_7163_ = _e3841;
                                            phi_7164_ = type_20(_e4466, (_e4463 + 1u), 31u);
                                            phi_7165_ = _e2843;
                                        } else {
                                            if _e2835 {
                                                phi_6647_ = bool();
                                                phi_6648_ = type_20();
                                                phi_6649_ = true;
                                            } else {
                                                let _e3848 = local_68;
                                                let _e3852 = local_69;
                                                if select(true, select(true, false, (_e3848 < _e2831)), _e3852) {
                                                    let _e3855 = local_70;
                                                    if (_e3855 == 31u) {
                                                        if _e3841 {
                                                            phi_6640_ = _e3841;
                                                            phi_6641_ = _e3761;
                                                        } else {
                                                            let _e3858 = local_71;
                                                            let _e3862 = local_72;
                                                            let _e3865 = function_13(128u);
                                                            let _e3870 = ((_e3858[0].member >> bitcast<u32>(31i)) != 0u);
                                                            let _e3878 = local_73;
                                                            if (select(0u, select(1u, 2u, ((_e3858[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3865.member - select(_e3878[0].member, (~(_e3858[0].member) + select(0u, 1u, (_e3862[0].member_1 == 0u))), _e3870)) - select(0u, 1u, (_e3865.member_1 < select(_e3878[0].member_1, (~(_e3862[0].member_1) + 1u), _e3870)))) >> bitcast<u32>(31i)) != 0u)) == 0u) {
                                                                phi_6638_ = _e3841;
                                                                phi_6639_ = _e3761;
                                                            } else {
                                                                let _e3901 = select((bitcast<u32>(31i) - firstLeadingBit(_e1317)), 32u, (_e1317 == 0u));
                                                                let _e3907 = local_74;
                                                                let _e3908 = (_e3907 + (1u << bitcast<u32>(((31u - _e3901) & 31u))));
                                                                let _e3910 = local_75;
                                                                if (_e3908 <= 2147483648u) {
                                                                    let _e3914 = local_76;
                                                                    let _e3918 = local_77;
                                                                    let _e3921 = function_13(128u);
                                                                    let _e3926 = ((_e3914[0].member >> bitcast<u32>(31i)) != 0u);
                                                                    let _e3934 = local_78;
                                                                    let _e3957 = function_6(((_e2714 - _e2641.member) - select(0u, 1u, (_e2710 < _e2641.member_1))), (_e2710 - _e2641.member_1), _e3908);
                                                                    let _e3960 = (_e2641.member_1 + _e3957.member_1);
                                                                    let _e3964 = ((_e2641.member + _e3957.member) + select(0u, 1u, (_e3960 < _e2641.member_1)));
                                                                    let _e3970 = function_6(((_e2785 - _e2714) - select(0u, 1u, (_e2781 < _e2710))), (_e2781 - _e2710), _e3908);
                                                                    let _e3973 = (_e2710 + _e3970.member_1);
                                                                    let _e3977 = ((_e2714 + _e3970.member) + select(0u, 1u, (_e3973 < _e2710)));
                                                                    let _e3983 = function_6(((_e2819.member - _e2785) - select(0u, 1u, (_e2819.member_1 < _e2781))), (_e2819.member_1 - _e2781), _e3908);
                                                                    let _e3986 = (_e2781 + _e3983.member_1);
                                                                    let _e3996 = function_6(((_e3977 - _e3964) - select(0u, 1u, (_e3973 < _e3960))), (_e3973 - _e3960), _e3908);
                                                                    let _e3999 = (_e3960 + _e3996.member_1);
                                                                    let _e4003 = ((_e3964 + _e3996.member) + select(0u, 1u, (_e3999 < _e3960)));
                                                                    let _e4009 = function_6(((((_e2785 + _e3983.member) + select(0u, 1u, (_e3986 < _e2781))) - _e3977) - select(0u, 1u, (_e3986 < _e3973))), (_e3986 - _e3973), _e3908);
                                                                    let _e4012 = (_e3973 + _e4009.member_1);
                                                                    let _e4022 = function_6(((((_e3977 + _e4009.member) + select(0u, 1u, (_e4012 < _e3973))) - _e4003) - select(0u, 1u, (_e4012 < _e3999))), (_e4012 - _e3999), _e3908);
                                                                    let _e4025 = (_e3999 + _e4022.member_1);
                                                                    let _e4029 = ((_e4003 + _e4022.member) + select(0u, 1u, (_e4025 < _e3999)));
                                                                    let _e4030 = function_13(128u);
                                                                    let _e4035 = ((_e4029 >> bitcast<u32>(31i)) != 0u);
                                                                    phi_6637_ = ((select(0u, select(1u, 2u, ((_e3914[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3921.member - select(_e3934[0].member, (~(_e3914[0].member) + select(0u, 1u, (_e3918[0].member_1 == 0u))), _e3926)) - select(0u, 1u, (_e3921.member_1 < select(_e3934[0].member_1, (~(_e3918[0].member_1) + 1u), _e3926)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e4029 >> bitcast<u32>(31i)) != 0u)), ((((_e4030.member - select(_e4029, (~(_e4029) + select(0u, 1u, (_e4025 == 0u))), _e4035)) - select(0u, 1u, (_e4030.member_1 < select(_e4025, (~(_e4025) + 1u), _e4035)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                                                } else {
                                                                    phi_6637_ = false;
                                                                }
                                                                let _e4059 = phi_6637_;
                                                                phi_6638_ = _e4059;
                                                                phi_6639_ = type_20(_e3910, _e3908, _e3901);
                                                            }
                                                            let _e4061 = phi_6638_;
                                                            let _e4063 = phi_6639_;
                                                            phi_6640_ = _e4061;
                                                            phi_6641_ = _e4063;
                                                        }
                                                        let _e4065 = phi_6640_;
                                                        let _e4067 = phi_6641_;
                                                        phi_6642_ = _e4065;
                                                        phi_6643_ = _e4067;
                                                    } else {
                                                        phi_6642_ = _e3841;
                                                        phi_6643_ = _e3761;
                                                    }
                                                    let _e4069 = phi_6642_;
                                                    let _e4071 = phi_6643_;
                                                    phi_6644_ = _e4069;
                                                    phi_6645_ = _e4071;
                                                    phi_6646_ = false;
                                                } else {
                                                    phi_6644_ = bool();
                                                    phi_6645_ = type_20();
                                                    phi_6646_ = true;
                                                }
                                                let _e4073 = phi_6644_;
                                                let _e4075 = phi_6645_;
                                                let _e4077 = phi_6646_;
                                                phi_6647_ = _e4073;
                                                phi_6648_ = _e4075;
                                                phi_6649_ = _e4077;
                                            }
                                            let _e4079 = phi_6647_;
                                            let _e4081 = phi_6648_;
                                            let _e4083 = phi_6649_;
                                            if _e4083 {
                                                let _e4084 = select(_e2831, 31u, _e2835);
                                                let _e4087 = local_79;
                                                let _e4088 = select(_e4087, _e2843.member, _e2835);
                                                let _e4091 = local_80;
                                                let _e4092 = select(_e4091, _e2843.member_1, _e2835);
                                                let _e4094 = local_81;
                                                let _e4098 = local_82;
                                                let _e4105 = ((f32(bitcast<i32>(_e4094[0].member)) * 4294967300f) + f32(_e4098[0].member_1));
                                                let _e4107 = local_83;
                                                let _e4111 = local_84;
                                                let _e4118 = ((f32(bitcast<i32>(_e4107[1].member)) * 4294967300f) + f32(_e4111[1].member_1));
                                                let _e4120 = local_85;
                                                let _e4124 = local_86;
                                                let _e4131 = ((f32(bitcast<i32>(_e4120[2].member)) * 4294967300f) + f32(_e4124[2].member_1));
                                                let _e4133 = local_87;
                                                let _e4137 = local_88;
                                                let _e4144 = ((f32(bitcast<i32>(_e4133[3].member)) * 4294967300f) + f32(_e4137[3].member_1));
                                                phi_6690_ = type_14(0i, 6i);
                                                phi_6693_ = 1f;
                                                phi_6695_ = 0f;
                                                phi_6697_ = (_e4105 / (_e4105 - _e4144));
                                                loop {
                                                    let _e4148 = phi_6690_;
                                                    let _e4150 = phi_6693_;
                                                    let _e4152 = phi_6695_;
                                                    let _e4154 = phi_6697_;
                                                    local_89 = _e4154;
                                                    if (_e4148.member < _e4148.member_1) {
                                                        let _e4161 = (_e4148.member + 1i);
                                                        phi_6691_ = type_14(select(_e4161, type_15().member_1, select(false, true, ((false == (_e4161 > _e4148.member)) != false))), _e4148.member_1);
                                                        phi_6738_ = type_15(1u, _e4148.member);
                                                    } else {
                                                        phi_6691_ = _e4148;
                                                        phi_6738_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e4172 = phi_6691_;
                                                    let _e4174 = phi_6738_;
                                                    let _e4177 = (bitcast<i32>(_e4174.member) != 0i);
                                                    if _e4177 {
                                                        let _e4178 = function_12(_e4105, _e4118, _e4154);
                                                        let _e4179 = function_12(_e4118, _e4131, _e4154);
                                                        let _e4180 = function_12(_e4131, _e4144, _e4154);
                                                        let _e4181 = function_12(_e4178, _e4179, _e4154);
                                                        let _e4182 = function_12(_e4179, _e4180, _e4154);
                                                        let _e4183 = function_12(_e4181, _e4182, _e4154);
                                                        let _e4186 = ((_e4183 < 0f) == (_e4105 < 0f));
                                                        let _e4187 = select(_e4154, _e4150, _e4186);
                                                        let _e4188 = select(_e4152, _e4154, _e4186);
                                                        let _e4192 = (_e4154 - (_e4183 / (3f * (_e4182 - _e4181))));
                                                        phi_6694_ = _e4187;
                                                        phi_6696_ = _e4188;
                                                        phi_6698_ = select(_e4192, (0.5f * (_e4188 + _e4187)), select(true, select(true, false, (_e4192 <= _e4187)), (_e4192 >= _e4188)));
                                                    } else {
                                                        phi_6694_ = f32();
                                                        phi_6696_ = f32();
                                                        phi_6698_ = f32();
                                                    }
                                                    let _e4201 = phi_6694_;
                                                    let _e4203 = phi_6696_;
                                                    let _e4205 = phi_6698_;
                                                    continue;
                                                    continuing {
                                                        phi_6690_ = _e4172;
                                                        phi_6693_ = _e4201;
                                                        phi_6695_ = _e4203;
                                                        phi_6697_ = _e4205;
                                                        break if !(_e4177);
                                                    }
                                                }
                                                let _e4210 = (1u << bitcast<u32>(((31u - _e4084) & 31u)));
                                                let _e4211 = (_e4092 - _e4088);
                                                let _e4214 = local_89;
                                                let _e4215 = (_e4214 * f32(_e4211));
                                                let _e4220 = select(select(u32(_e4215), 0u, (_e4215 < 0f)), 4294967295u, (_e4215 > 4294967000f));
                                                let _e4222 = select(_e4220, _e4211, (_e4211 < _e4220));
                                                let _e4224 = (_e4210 / 2u);
                                                let _e4227 = ((_e4088 + _e4222) - select(_e4224, _e4222, (_e4222 < _e4224)));
                                                let _e4228 = (_e4227 + _e4210);
                                                let _e4230 = select(_e4228, _e4092, (_e4092 < _e4228));
                                                let _e4236 = function_6(((_e2714 - _e2641.member) - select(0u, 1u, (_e2710 < _e2641.member_1))), (_e2710 - _e2641.member_1), _e4227);
                                                let _e4239 = (_e2641.member_1 + _e4236.member_1);
                                                let _e4243 = ((_e2641.member + _e4236.member) + select(0u, 1u, (_e4239 < _e2641.member_1)));
                                                let _e4249 = function_6(((_e2785 - _e2714) - select(0u, 1u, (_e2781 < _e2710))), (_e2781 - _e2710), _e4227);
                                                let _e4252 = (_e2710 + _e4249.member_1);
                                                let _e4256 = ((_e2714 + _e4249.member) + select(0u, 1u, (_e4252 < _e2710)));
                                                let _e4262 = function_6(((_e2819.member - _e2785) - select(0u, 1u, (_e2819.member_1 < _e2781))), (_e2819.member_1 - _e2781), _e4227);
                                                let _e4265 = (_e2781 + _e4262.member_1);
                                                let _e4275 = function_6(((_e4256 - _e4243) - select(0u, 1u, (_e4252 < _e4239))), (_e4252 - _e4239), _e4227);
                                                let _e4278 = (_e4239 + _e4275.member_1);
                                                let _e4282 = ((_e4243 + _e4275.member) + select(0u, 1u, (_e4278 < _e4239)));
                                                let _e4288 = function_6(((((_e2785 + _e4262.member) + select(0u, 1u, (_e4265 < _e2781))) - _e4256) - select(0u, 1u, (_e4265 < _e4252))), (_e4265 - _e4252), _e4227);
                                                let _e4291 = (_e4252 + _e4288.member_1);
                                                let _e4301 = function_6(((((_e4256 + _e4288.member) + select(0u, 1u, (_e4291 < _e4252))) - _e4282) - select(0u, 1u, (_e4291 < _e4278))), (_e4291 - _e4278), _e4227);
                                                let _e4304 = (_e4278 + _e4301.member_1);
                                                let _e4308 = ((_e4282 + _e4301.member) + select(0u, 1u, (_e4304 < _e4278)));
                                                let _e4309 = function_13(128u);
                                                let _e4314 = ((_e4308 >> bitcast<u32>(31i)) != 0u);
                                                let _e4340 = function_6(((_e2714 - _e2641.member) - select(0u, 1u, (_e2710 < _e2641.member_1))), (_e2710 - _e2641.member_1), _e4230);
                                                let _e4343 = (_e2641.member_1 + _e4340.member_1);
                                                let _e4347 = ((_e2641.member + _e4340.member) + select(0u, 1u, (_e4343 < _e2641.member_1)));
                                                let _e4353 = function_6(((_e2785 - _e2714) - select(0u, 1u, (_e2781 < _e2710))), (_e2781 - _e2710), _e4230);
                                                let _e4356 = (_e2710 + _e4353.member_1);
                                                let _e4360 = ((_e2714 + _e4353.member) + select(0u, 1u, (_e4356 < _e2710)));
                                                let _e4366 = function_6(((_e2819.member - _e2785) - select(0u, 1u, (_e2819.member_1 < _e2781))), (_e2819.member_1 - _e2781), _e4230);
                                                let _e4369 = (_e2781 + _e4366.member_1);
                                                let _e4379 = function_6(((_e4360 - _e4347) - select(0u, 1u, (_e4356 < _e4343))), (_e4356 - _e4343), _e4230);
                                                let _e4382 = (_e4343 + _e4379.member_1);
                                                let _e4386 = ((_e4347 + _e4379.member) + select(0u, 1u, (_e4382 < _e4343)));
                                                let _e4392 = function_6(((((_e2785 + _e4366.member) + select(0u, 1u, (_e4369 < _e2781))) - _e4360) - select(0u, 1u, (_e4369 < _e4356))), (_e4369 - _e4356), _e4230);
                                                let _e4395 = (_e4356 + _e4392.member_1);
                                                let _e4405 = function_6(((((_e4360 + _e4392.member) + select(0u, 1u, (_e4395 < _e4356))) - _e4386) - select(0u, 1u, (_e4395 < _e4382))), (_e4395 - _e4382), _e4230);
                                                let _e4408 = (_e4382 + _e4405.member_1);
                                                let _e4412 = ((_e4386 + _e4405.member) + select(0u, 1u, (_e4408 < _e4382)));
                                                let _e4413 = function_13(128u);
                                                let _e4418 = ((_e4412 >> bitcast<u32>(31i)) != 0u);
                                                let _e4440 = ((select(0u, select(1u, 2u, ((_e4308 >> bitcast<u32>(31i)) != 0u)), ((((_e4309.member - select(_e4308, (~(_e4308) + select(0u, 1u, (_e4304 == 0u))), _e4314)) - select(0u, 1u, (_e4309.member_1 < select(_e4304, (~(_e4304) + 1u), _e4314)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e4412 >> bitcast<u32>(31i)) != 0u)), ((((_e4413.member - select(_e4412, (~(_e4412) + select(0u, 1u, (_e4408 == 0u))), _e4418)) - select(0u, 1u, (_e4413.member_1 < select(_e4408, (~(_e4408) + 1u), _e4418)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                                let _e4443 = local_90;
                                                let _e4446 = local_91;
                                                let _e4449 = local_92;
                                                phi_7156_ = _e4440;
                                                phi_7157_ = true;
                                                phi_7158_ = _e4440;
                                                phi_7159_ = type_20(select(_e4443, _e4227, _e4440), select(_e4446, _e4230, _e4440), select(_e4449, _e4084, _e4440));
                                                phi_7160_ = type_20(_e4227, _e4230, _e4084);
                                            } else {
                                                phi_7156_ = _e2835;
                                                phi_7157_ = _e2837;
                                                phi_7158_ = _e4079;
                                                phi_7159_ = _e4081;
                                                phi_7160_ = _e2843;
                                            }
                                            let _e4453 = phi_7156_;
                                            let _e4455 = phi_7157_;
                                            let _e4457 = phi_7158_;
                                            let _e4459 = phi_7159_;
                                            let _e4461 = phi_7160_;
                                            phi_7161_ = _e4453;
                                            phi_7162_ = _e4455;
                                            phi_7163_ = _e4457;
                                            phi_7164_ = _e4459;
                                            phi_7165_ = _e4461;
                                        }
                                        let _e4469 = phi_7161_;
                                        let _e4471 = phi_7162_;
                                        let _e4473 = phi_7163_;
                                        let _e4475 = phi_7164_;
                                        let _e4477 = phi_7165_;
                                        let _e4496 = ((_e1892[0][1][0].member - _e1892[0][0][0].member) - select(0u, 1u, (_e1892[0][1][0].member_1 < _e1892[0][0][0].member_1)));
                                        let _e4497 = (_e1892[0][1][0].member_1 - _e1892[0][0][0].member_1);
                                        let _e4509 = ((_e1892[0][1][1].member - _e1892[0][0][1].member) - select(0u, 1u, (_e1892[0][1][1].member_1 < _e1892[0][0][1].member_1)));
                                        let _e4510 = (_e1892[0][1][1].member_1 - _e1892[0][0][1].member_1);
                                        let _e4522 = ((_e1892[0][1][2].member - _e1892[0][0][2].member) - select(0u, 1u, (_e1892[0][1][2].member_1 < _e1892[0][0][2].member_1)));
                                        let _e4523 = (_e1892[0][1][2].member_1 - _e1892[0][0][2].member_1);
                                        let _e4526 = ((_e4496 >> bitcast<u32>(31i)) != 0u);
                                        let _e4533 = select(_e4496, (~(_e4496) + select(0u, 1u, (_e4497 == 0u))), _e4526);
                                        let _e4534 = select(_e4497, (~(_e4497) + 1u), _e4526);
                                        let _e4537 = ((_e4509 >> bitcast<u32>(31i)) != 0u);
                                        let _e4544 = select(_e4509, (~(_e4509) + select(0u, 1u, (_e4510 == 0u))), _e4537);
                                        let _e4545 = select(_e4510, (~(_e4510) + 1u), _e4537);
                                        let _e4552 = ((((_e4544 - _e4533) - select(0u, 1u, (_e4545 < _e4534))) >> bitcast<u32>(31i)) != 0u);
                                        let _e4553 = select(_e4544, _e4533, _e4552);
                                        let _e4554 = select(_e4545, _e4534, _e4552);
                                        let _e4557 = ((_e4522 >> bitcast<u32>(31i)) != 0u);
                                        let _e4564 = select(_e4522, (~(_e4522) + select(0u, 1u, (_e4523 == 0u))), _e4557);
                                        let _e4565 = select(_e4523, (~(_e4523) + 1u), _e4557);
                                        let _e4572 = ((((_e4564 - _e4553) - select(0u, 1u, (_e4565 < _e4554))) >> bitcast<u32>(31i)) != 0u);
                                        let _e4574 = select(_e4565, _e4554, _e4572);
                                        let _e4575 = function_13(4u);
                                        let _e4578 = (_e4574 + _e4575.member_1);
                                        let _e4582 = ((select(_e4564, _e4553, _e4572) + _e4575.member) + select(0u, 1u, (_e4578 < _e4574)));
                                        let _e4597 = ((_e4578 >> bitcast<u32>((_e4475.member_2 & 31u))) | ((_e4582 << bitcast<u32>(((31u - _e4475.member_2) & 31u))) << bitcast<u32>(1i)));
                                        let _e4598 = function_13(4u);
                                        let _e4601 = (_e4597 + _e4598.member_1);
                                        let _e4619 = ((_e1892[1][1][0].member - _e1892[1][0][0].member) - select(0u, 1u, (_e1892[1][1][0].member_1 < _e1892[1][0][0].member_1)));
                                        let _e4620 = (_e1892[1][1][0].member_1 - _e1892[1][0][0].member_1);
                                        let _e4632 = ((_e1892[1][1][1].member - _e1892[1][0][1].member) - select(0u, 1u, (_e1892[1][1][1].member_1 < _e1892[1][0][1].member_1)));
                                        let _e4633 = (_e1892[1][1][1].member_1 - _e1892[1][0][1].member_1);
                                        let _e4645 = ((_e1892[1][1][2].member - _e1892[1][0][2].member) - select(0u, 1u, (_e1892[1][1][2].member_1 < _e1892[1][0][2].member_1)));
                                        let _e4646 = (_e1892[1][1][2].member_1 - _e1892[1][0][2].member_1);
                                        let _e4649 = ((_e4619 >> bitcast<u32>(31i)) != 0u);
                                        let _e4656 = select(_e4619, (~(_e4619) + select(0u, 1u, (_e4620 == 0u))), _e4649);
                                        let _e4657 = select(_e4620, (~(_e4620) + 1u), _e4649);
                                        let _e4660 = ((_e4632 >> bitcast<u32>(31i)) != 0u);
                                        let _e4667 = select(_e4632, (~(_e4632) + select(0u, 1u, (_e4633 == 0u))), _e4660);
                                        let _e4668 = select(_e4633, (~(_e4633) + 1u), _e4660);
                                        let _e4675 = ((((_e4667 - _e4656) - select(0u, 1u, (_e4668 < _e4657))) >> bitcast<u32>(31i)) != 0u);
                                        let _e4676 = select(_e4667, _e4656, _e4675);
                                        let _e4677 = select(_e4668, _e4657, _e4675);
                                        let _e4680 = ((_e4645 >> bitcast<u32>(31i)) != 0u);
                                        let _e4687 = select(_e4645, (~(_e4645) + select(0u, 1u, (_e4646 == 0u))), _e4680);
                                        let _e4688 = select(_e4646, (~(_e4646) + 1u), _e4680);
                                        let _e4695 = ((((_e4687 - _e4676) - select(0u, 1u, (_e4688 < _e4677))) >> bitcast<u32>(31i)) != 0u);
                                        let _e4697 = select(_e4688, _e4677, _e4695);
                                        let _e4698 = function_13(4u);
                                        let _e4701 = (_e4697 + _e4698.member_1);
                                        let _e4705 = ((select(_e4687, _e4676, _e4695) + _e4698.member) + select(0u, 1u, (_e4701 < _e4697)));
                                        let _e4720 = ((_e4701 >> bitcast<u32>((_e4475.member_2 & 31u))) | ((_e4705 << bitcast<u32>(((31u - _e4475.member_2) & 31u))) << bitcast<u32>(1i)));
                                        let _e4721 = function_13(4u);
                                        let _e4724 = (_e4720 + _e4721.member_1);
                                        let _e4742 = ((_e1892[2][1][0].member - _e1892[2][0][0].member) - select(0u, 1u, (_e1892[2][1][0].member_1 < _e1892[2][0][0].member_1)));
                                        let _e4743 = (_e1892[2][1][0].member_1 - _e1892[2][0][0].member_1);
                                        let _e4755 = ((_e1892[2][1][1].member - _e1892[2][0][1].member) - select(0u, 1u, (_e1892[2][1][1].member_1 < _e1892[2][0][1].member_1)));
                                        let _e4756 = (_e1892[2][1][1].member_1 - _e1892[2][0][1].member_1);
                                        let _e4768 = ((_e1892[2][1][2].member - _e1892[2][0][2].member) - select(0u, 1u, (_e1892[2][1][2].member_1 < _e1892[2][0][2].member_1)));
                                        let _e4769 = (_e1892[2][1][2].member_1 - _e1892[2][0][2].member_1);
                                        let _e4772 = ((_e4742 >> bitcast<u32>(31i)) != 0u);
                                        let _e4779 = select(_e4742, (~(_e4742) + select(0u, 1u, (_e4743 == 0u))), _e4772);
                                        let _e4780 = select(_e4743, (~(_e4743) + 1u), _e4772);
                                        let _e4783 = ((_e4755 >> bitcast<u32>(31i)) != 0u);
                                        let _e4790 = select(_e4755, (~(_e4755) + select(0u, 1u, (_e4756 == 0u))), _e4783);
                                        let _e4791 = select(_e4756, (~(_e4756) + 1u), _e4783);
                                        let _e4798 = ((((_e4790 - _e4779) - select(0u, 1u, (_e4791 < _e4780))) >> bitcast<u32>(31i)) != 0u);
                                        let _e4799 = select(_e4790, _e4779, _e4798);
                                        let _e4800 = select(_e4791, _e4780, _e4798);
                                        let _e4803 = ((_e4768 >> bitcast<u32>(31i)) != 0u);
                                        let _e4810 = select(_e4768, (~(_e4768) + select(0u, 1u, (_e4769 == 0u))), _e4803);
                                        let _e4811 = select(_e4769, (~(_e4769) + 1u), _e4803);
                                        let _e4818 = ((((_e4810 - _e4799) - select(0u, 1u, (_e4811 < _e4800))) >> bitcast<u32>(31i)) != 0u);
                                        let _e4820 = select(_e4811, _e4800, _e4818);
                                        let _e4821 = function_13(4u);
                                        let _e4824 = (_e4820 + _e4821.member_1);
                                        let _e4828 = ((select(_e4810, _e4799, _e4818) + _e4821.member) + select(0u, 1u, (_e4824 < _e4820)));
                                        let _e4843 = ((_e4824 >> bitcast<u32>((_e4475.member_2 & 31u))) | ((_e4828 << bitcast<u32>(((31u - _e4475.member_2) & 31u))) << bitcast<u32>(1i)));
                                        let _e4844 = function_13(4u);
                                        let _e4847 = (_e4843 + _e4844.member_1);
                                        local_14[0u].member = ((bitcast<u32>((bitcast<i32>(_e4582) >> bitcast<u32>((_e4475.member_2 & 31u)))) + _e4598.member) + select(0u, 1u, (_e4601 < _e4597)));
                                        local_14[0u].member_1 = _e4601;
                                        local_14[1u].member = ((bitcast<u32>((bitcast<i32>(_e4705) >> bitcast<u32>((_e4475.member_2 & 31u)))) + _e4721.member) + select(0u, 1u, (_e4724 < _e4720)));
                                        local_14[1u].member_1 = _e4724;
                                        local_14[2u].member = ((bitcast<u32>((bitcast<i32>(_e4828) >> bitcast<u32>((_e4475.member_2 & 31u)))) + _e4844.member) + select(0u, 1u, (_e4847 < _e4843)));
                                        local_14[2u].member_1 = _e4847;
                                        let _e4877 = function_6(((_e1892[0][1][0].member - _e1892[0][0][0].member) - select(0u, 1u, (_e1892[0][1][0].member_1 < _e1892[0][0][0].member_1))), (_e1892[0][1][0].member_1 - _e1892[0][0][0].member_1), _e4475.member);
                                        let _e4880 = (_e1892[0][0][0].member_1 + _e4877.member_1);
                                        let _e4884 = ((_e1892[0][0][0].member + _e4877.member) + select(0u, 1u, (_e4880 < _e1892[0][0][0].member_1)));
                                        let _e4898 = function_6(((_e1892[0][1][1].member - _e1892[0][0][1].member) - select(0u, 1u, (_e1892[0][1][1].member_1 < _e1892[0][0][1].member_1))), (_e1892[0][1][1].member_1 - _e1892[0][0][1].member_1), _e4475.member);
                                        let _e4901 = (_e1892[0][0][1].member_1 + _e4898.member_1);
                                        let _e4905 = ((_e1892[0][0][1].member + _e4898.member) + select(0u, 1u, (_e4901 < _e1892[0][0][1].member_1)));
                                        let _e4919 = function_6(((_e1892[0][1][2].member - _e1892[0][0][2].member) - select(0u, 1u, (_e1892[0][1][2].member_1 < _e1892[0][0][2].member_1))), (_e1892[0][1][2].member_1 - _e1892[0][0][2].member_1), _e4475.member);
                                        let _e4922 = (_e1892[0][0][2].member_1 + _e4919.member_1);
                                        let _e4926 = ((_e1892[0][0][2].member + _e4919.member) + select(0u, 1u, (_e4922 < _e1892[0][0][2].member_1)));
                                        let _e4942 = function_6(((_e1892[1][1][0].member - _e1892[1][0][0].member) - select(0u, 1u, (_e1892[1][1][0].member_1 < _e1892[1][0][0].member_1))), (_e1892[1][1][0].member_1 - _e1892[1][0][0].member_1), _e4475.member);
                                        let _e4945 = (_e1892[1][0][0].member_1 + _e4942.member_1);
                                        let _e4949 = ((_e1892[1][0][0].member + _e4942.member) + select(0u, 1u, (_e4945 < _e1892[1][0][0].member_1)));
                                        let _e4963 = function_6(((_e1892[1][1][1].member - _e1892[1][0][1].member) - select(0u, 1u, (_e1892[1][1][1].member_1 < _e1892[1][0][1].member_1))), (_e1892[1][1][1].member_1 - _e1892[1][0][1].member_1), _e4475.member);
                                        let _e4966 = (_e1892[1][0][1].member_1 + _e4963.member_1);
                                        let _e4970 = ((_e1892[1][0][1].member + _e4963.member) + select(0u, 1u, (_e4966 < _e1892[1][0][1].member_1)));
                                        let _e4984 = function_6(((_e1892[1][1][2].member - _e1892[1][0][2].member) - select(0u, 1u, (_e1892[1][1][2].member_1 < _e1892[1][0][2].member_1))), (_e1892[1][1][2].member_1 - _e1892[1][0][2].member_1), _e4475.member);
                                        let _e4987 = (_e1892[1][0][2].member_1 + _e4984.member_1);
                                        let _e4991 = ((_e1892[1][0][2].member + _e4984.member) + select(0u, 1u, (_e4987 < _e1892[1][0][2].member_1)));
                                        let _e5007 = function_6(((_e1892[2][1][0].member - _e1892[2][0][0].member) - select(0u, 1u, (_e1892[2][1][0].member_1 < _e1892[2][0][0].member_1))), (_e1892[2][1][0].member_1 - _e1892[2][0][0].member_1), _e4475.member);
                                        let _e5010 = (_e1892[2][0][0].member_1 + _e5007.member_1);
                                        let _e5014 = ((_e1892[2][0][0].member + _e5007.member) + select(0u, 1u, (_e5010 < _e1892[2][0][0].member_1)));
                                        let _e5028 = function_6(((_e1892[2][1][1].member - _e1892[2][0][1].member) - select(0u, 1u, (_e1892[2][1][1].member_1 < _e1892[2][0][1].member_1))), (_e1892[2][1][1].member_1 - _e1892[2][0][1].member_1), _e4475.member);
                                        let _e5031 = (_e1892[2][0][1].member_1 + _e5028.member_1);
                                        let _e5035 = ((_e1892[2][0][1].member + _e5028.member) + select(0u, 1u, (_e5031 < _e1892[2][0][1].member_1)));
                                        let _e5049 = function_6(((_e1892[2][1][2].member - _e1892[2][0][2].member) - select(0u, 1u, (_e1892[2][1][2].member_1 < _e1892[2][0][2].member_1))), (_e1892[2][1][2].member_1 - _e1892[2][0][2].member_1), _e4475.member);
                                        let _e5052 = (_e1892[2][0][2].member_1 + _e5049.member_1);
                                        let _e5056 = ((_e1892[2][0][2].member + _e5049.member) + select(0u, 1u, (_e5052 < _e1892[2][0][2].member_1)));
                                        local_12 = array<type_9, 3>(type_9(_e4949, _e4945), type_9(_e4970, _e4966), type_9(_e4991, _e4987));
                                        local_13 = array<type_9, 3>(type_9(_e5014, _e5010), type_9(_e5035, _e5031), type_9(_e5056, _e5052));
                                        let _e5067 = local_12[1u].member;
                                        let _e5069 = local_12[1u].member_1;
                                        let _e5072 = local_13[2u].member;
                                        let _e5074 = local_13[2u].member_1;
                                        let _e5075 = function_10(_e5067, _e5069, _e5072, _e5074);
                                        let _e5080 = local_12[2u].member;
                                        let _e5082 = local_12[2u].member_1;
                                        let _e5085 = local_13[1u].member;
                                        let _e5087 = local_13[1u].member_1;
                                        let _e5088 = function_10(_e5080, _e5082, _e5085, _e5087);
                                        let _e5094 = ((_e5075.member - _e5088.member) - select(0u, 1u, (_e5075.member_1 < _e5088.member_1)));
                                        let _e5095 = (_e5075.member_1 - _e5088.member_1);
                                        local_10 = array<type_9, 3>(type_9(_e4949, _e4945), type_9(_e4970, _e4966), type_9(_e4991, _e4987));
                                        local_11 = array<type_9, 3>(type_9(_e5014, _e5010), type_9(_e5035, _e5031), type_9(_e5056, _e5052));
                                        let _e5106 = local_10[2u].member;
                                        let _e5108 = local_10[2u].member_1;
                                        let _e5111 = local_11[0u].member;
                                        let _e5113 = local_11[0u].member_1;
                                        let _e5114 = function_10(_e5106, _e5108, _e5111, _e5113);
                                        let _e5119 = local_10[0u].member;
                                        let _e5121 = local_10[0u].member_1;
                                        let _e5124 = local_11[2u].member;
                                        let _e5126 = local_11[2u].member_1;
                                        let _e5127 = function_10(_e5119, _e5121, _e5124, _e5126);
                                        let _e5133 = ((_e5114.member - _e5127.member) - select(0u, 1u, (_e5114.member_1 < _e5127.member_1)));
                                        let _e5134 = (_e5114.member_1 - _e5127.member_1);
                                        local_8 = array<type_9, 3>(type_9(_e4949, _e4945), type_9(_e4970, _e4966), type_9(_e4991, _e4987));
                                        local_9 = array<type_9, 3>(type_9(_e5014, _e5010), type_9(_e5035, _e5031), type_9(_e5056, _e5052));
                                        let _e5145 = local_8[0u].member;
                                        let _e5147 = local_8[0u].member_1;
                                        let _e5150 = local_9[1u].member;
                                        let _e5152 = local_9[1u].member_1;
                                        let _e5153 = function_10(_e5145, _e5147, _e5150, _e5152);
                                        let _e5158 = local_8[1u].member;
                                        let _e5160 = local_8[1u].member_1;
                                        let _e5163 = local_9[0u].member;
                                        let _e5165 = local_9[0u].member_1;
                                        let _e5166 = function_10(_e5158, _e5160, _e5163, _e5165);
                                        let _e5172 = ((_e5153.member - _e5166.member) - select(0u, 1u, (_e5153.member_1 < _e5166.member_1)));
                                        let _e5173 = (_e5153.member_1 - _e5166.member_1);
                                        let _e5176 = ((_e5094 >> bitcast<u32>(31i)) != 0u);
                                        let _e5183 = select(_e5094, (~(_e5094) + select(0u, 1u, (_e5095 == 0u))), _e5176);
                                        let _e5184 = select(_e5095, (~(_e5095) + 1u), _e5176);
                                        let _e5187 = ((_e5133 >> bitcast<u32>(31i)) != 0u);
                                        let _e5194 = select(_e5133, (~(_e5133) + select(0u, 1u, (_e5134 == 0u))), _e5187);
                                        let _e5195 = select(_e5134, (~(_e5134) + 1u), _e5187);
                                        let _e5198 = ((_e5172 >> bitcast<u32>(31i)) != 0u);
                                        let _e5205 = select(_e5172, (~(_e5172) + select(0u, 1u, (_e5173 == 0u))), _e5198);
                                        let _e5206 = select(_e5173, (~(_e5173) + 1u), _e5198);
                                        let _e5231 = select(0i, select(2i, 1i, ((((_e5205 - _e5194) - select(0u, 1u, (_e5206 < _e5195))) >> bitcast<u32>(31i)) != 0u)), select(true, select(true, false, ((((_e5205 - _e5183) - select(0u, 1u, (_e5206 < _e5184))) >> bitcast<u32>(31i)) != 0u)), ((((_e5194 - _e5183) - select(0u, 1u, (_e5195 < _e5184))) >> bitcast<u32>(31i)) != 0u)));
                                        switch _e5231 {
                                            case 0: {
                                                phi_8312_ = array<type_9, 2>(type_9(_e4905, _e4901), type_9(_e4926, _e4922));
                                                break;
                                            }
                                            case 1: {
                                                phi_8312_ = array<type_9, 2>(type_9(_e4926, _e4922), type_9(_e4884, _e4880));
                                                break;
                                            }
                                            default: {
                                                phi_8312_ = array<type_9, 2>(type_9(_e4884, _e4880), type_9(_e4905, _e4901));
                                                break;
                                            }
                                        }
                                        let _e5242 = phi_8312_;
                                        switch _e5231 {
                                            case 0: {
                                                phi_8341_ = array<type_9, 2>(type_9(_e4970, _e4966), type_9(_e4991, _e4987));
                                                break;
                                            }
                                            case 1: {
                                                phi_8341_ = array<type_9, 2>(type_9(_e4991, _e4987), type_9(_e4949, _e4945));
                                                break;
                                            }
                                            default: {
                                                phi_8341_ = array<type_9, 2>(type_9(_e4949, _e4945), type_9(_e4970, _e4966));
                                                break;
                                            }
                                        }
                                        let _e5253 = phi_8341_;
                                        switch _e5231 {
                                            case 0: {
                                                phi_8370_ = array<type_9, 2>(type_9(_e5035, _e5031), type_9(_e5056, _e5052));
                                                break;
                                            }
                                            case 1: {
                                                phi_8370_ = array<type_9, 2>(type_9(_e5056, _e5052), type_9(_e5014, _e5010));
                                                break;
                                            }
                                            default: {
                                                phi_8370_ = array<type_9, 2>(type_9(_e5014, _e5010), type_9(_e5035, _e5031));
                                                break;
                                            }
                                        }
                                        let _e5264 = phi_8370_;
                                        switch _e5231 {
                                            case 0: {
                                                phi_8384_ = type_9(_e5094, _e5095);
                                                break;
                                            }
                                            case 1: {
                                                phi_8384_ = type_9(_e5133, _e5134);
                                                break;
                                            }
                                            default: {
                                                phi_8384_ = type_9(_e5172, _e5173);
                                                break;
                                            }
                                        }
                                        let _e5269 = phi_8384_;
                                        let _e5272 = local_14[1u].member;
                                        let _e5274 = local_14[1u].member_1;
                                        let _e5277 = local_14[2u].member;
                                        let _e5279 = local_14[2u].member_1;
                                        let _e5280 = (_e5274 + _e5279);
                                        let _e5284 = ((_e5272 + _e5277) + select(0u, 1u, (_e5280 < _e5274)));
                                        let _e5295 = ((_e5280 >> bitcast<u32>(1u)) | ((_e5284 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                        let _e5296 = function_13(17u);
                                        let _e5299 = (_e5295 + _e5296.member_1);
                                        let _e5303 = ((bitcast<u32>((bitcast<i32>(_e5284) >> bitcast<u32>(1u))) + _e5296.member) + select(0u, 1u, (_e5299 < _e5295)));
                                        let _e5306 = local_14[0u].member;
                                        let _e5308 = local_14[0u].member_1;
                                        let _e5311 = local_14[2u].member;
                                        let _e5313 = local_14[2u].member_1;
                                        let _e5314 = (_e5308 + _e5313);
                                        let _e5318 = ((_e5306 + _e5311) + select(0u, 1u, (_e5314 < _e5308)));
                                        let _e5329 = ((_e5314 >> bitcast<u32>(1u)) | ((_e5318 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                        let _e5330 = function_13(17u);
                                        let _e5333 = (_e5329 + _e5330.member_1);
                                        let _e5337 = ((bitcast<u32>((bitcast<i32>(_e5318) >> bitcast<u32>(1u))) + _e5330.member) + select(0u, 1u, (_e5333 < _e5329)));
                                        let _e5340 = local_14[0u].member;
                                        let _e5342 = local_14[0u].member_1;
                                        let _e5345 = local_14[1u].member;
                                        let _e5347 = local_14[1u].member_1;
                                        let _e5348 = (_e5342 + _e5347);
                                        let _e5352 = ((_e5340 + _e5345) + select(0u, 1u, (_e5348 < _e5342)));
                                        let _e5363 = ((_e5348 >> bitcast<u32>(1u)) | ((_e5352 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                        let _e5364 = function_13(17u);
                                        let _e5367 = (_e5363 + _e5364.member_1);
                                        let _e5371 = ((bitcast<u32>((bitcast<i32>(_e5352) >> bitcast<u32>(1u))) + _e5364.member) + select(0u, 1u, (_e5367 < _e5363)));
                                        let _e5376 = ((_e5269.member >> bitcast<u32>(31i)) != 0u);
                                        if ((((_e5303 - select(_e5269.member, (~(_e5269.member) + select(0u, 1u, (_e5269.member_1 == 0u))), _e5376)) - select(0u, 1u, (_e5299 < select(_e5269.member_1, (~(_e5269.member_1) + 1u), _e5376)))) >> bitcast<u32>(31i)) != 0u) {
                                            let _e5397 = ((_e5269.member >> bitcast<u32>(31i)) != 0u);
                                            let _e5407 = select(_e5269.member, (~(_e5269.member) + select(0u, 1u, (_e5269.member_1 == 0u))), _e5397);
                                            let _e5409 = select(_e5269.member_1, (~(_e5269.member_1) + 1u), _e5397);
                                            let _e5410 = function_11(_e5242, _e5264);
                                            let _e5420 = select(_e5410.member, (~(_e5410.member) + select(0u, 1u, (_e5410.member_1 == 0u))), _e5397);
                                            let _e5422 = select(_e5410.member_1, (~(_e5410.member_1) + 1u), _e5397);
                                            let _e5423 = function_11(_e5253, _e5242);
                                            let _e5433 = select(_e5423.member, (~(_e5423.member) + select(0u, 1u, (_e5423.member_1 == 0u))), _e5397);
                                            let _e5435 = select(_e5423.member_1, (~(_e5423.member_1) + 1u), _e5397);
                                            if (_e284.member != 0u) {
                                                let _e5467 = (_e5299 + _e5333);
                                                let _e5479 = (_e5299 + _e5367);
                                                phi_8706_ = type_9(((_e5303 + _e5371) + select(0u, 1u, (_e5479 < _e5299))), _e5479);
                                                phi_8707_ = type_9(((_e5407 - _e5433) - select(0u, 1u, (_e5409 < _e5435))), (_e5409 - _e5435));
                                                phi_8708_ = type_9(((_e5303 + _e5337) + select(0u, 1u, (_e5467 < _e5299))), _e5467);
                                                phi_8709_ = type_9(((_e5407 - _e5420) - select(0u, 1u, (_e5409 < _e5422))), (_e5409 - _e5422));
                                            } else {
                                                let _e5441 = (_e5409 - _e5422);
                                                let _e5445 = ((((_e5407 - _e5420) - select(0u, 1u, (_e5409 < _e5422))) - _e5433) - select(0u, 1u, (_e5441 < _e5435)));
                                                let _e5446 = (_e5441 - _e5435);
                                                let _e5448 = (_e5299 + _e5333);
                                                let _e5453 = (_e5448 + _e5367);
                                                let _e5457 = ((((_e5303 + _e5337) + select(0u, 1u, (_e5448 < _e5299))) + _e5371) + select(0u, 1u, (_e5453 < _e5448)));
                                                phi_8706_ = type_9(_e5457, _e5453);
                                                phi_8707_ = type_9(_e5445, _e5446);
                                                phi_8708_ = type_9(_e5457, _e5453);
                                                phi_8709_ = type_9(_e5445, _e5446);
                                            }
                                            let _e5486 = phi_8706_;
                                            let _e5488 = phi_8707_;
                                            let _e5490 = phi_8708_;
                                            let _e5492 = phi_8709_;
                                            let _e5493 = function_9(_e5420, _e5422, _e5337, _e5333);
                                            if _e5493 {
                                                phi_8835_ = u32();
                                                phi_8836_ = true;
                                            } else {
                                                let _e5494 = function_9(_e5433, _e5435, _e5371, _e5367);
                                                if _e5494 {
                                                    phi_8833_ = u32();
                                                    phi_8834_ = true;
                                                } else {
                                                    let _e5499 = function_9(_e5492.member, _e5492.member_1, _e5490.member, _e5490.member_1);
                                                    if _e5499 {
                                                        phi_8831_ = u32();
                                                        phi_8832_ = true;
                                                    } else {
                                                        let _e5504 = function_9(_e5488.member, _e5488.member_1, _e5486.member, _e5486.member_1);
                                                        if _e5504 {
                                                            phi_8830_ = u32();
                                                        } else {
                                                            let _e5505 = function_8(_e5420, _e5422, _e5337, _e5333);
                                                            if _e5505 {
                                                                let _e5506 = function_8(_e5433, _e5435, _e5371, _e5367);
                                                                if _e5506 {
                                                                    let _e5511 = function_8(_e5492.member, _e5492.member_1, _e5490.member, _e5490.member_1);
                                                                    if _e5511 {
                                                                        let _e5516 = function_8(_e5488.member, _e5488.member_1, _e5486.member, _e5486.member_1);
                                                                        phi_8823_ = select(true, false, _e5516);
                                                                    } else {
                                                                        phi_8823_ = true;
                                                                    }
                                                                    let _e5519 = phi_8823_;
                                                                    phi_8824_ = _e5519;
                                                                } else {
                                                                    phi_8824_ = true;
                                                                }
                                                                let _e5521 = phi_8824_;
                                                                phi_8825_ = _e5521;
                                                            } else {
                                                                phi_8825_ = true;
                                                            }
                                                            let _e5523 = phi_8825_;
                                                            phi_8830_ = select(0u, 2u, _e5523);
                                                        }
                                                        let _e5526 = phi_8830_;
                                                        phi_8831_ = _e5526;
                                                        phi_8832_ = _e5504;
                                                    }
                                                    let _e5528 = phi_8831_;
                                                    let _e5530 = phi_8832_;
                                                    phi_8833_ = _e5528;
                                                    phi_8834_ = _e5530;
                                                }
                                                let _e5532 = phi_8833_;
                                                let _e5534 = phi_8834_;
                                                phi_8835_ = _e5532;
                                                phi_8836_ = _e5534;
                                            }
                                            let _e5536 = phi_8835_;
                                            let _e5538 = phi_8836_;
                                            phi_8841_ = select(_e5536, 1u, _e5538);
                                        } else {
                                            phi_8841_ = 2u;
                                        }
                                        let _e5541 = phi_8841_;
                                        let _e5542 = (_e5541 == 1u);
                                        let _e5543 = (_e5541 == 0u);
                                        let _e5559 = local_95;
                                        if _e5559 {
                                            let _e9772 = local_149;
                                            phi_8913_ = _e9772;
                                            phi_8914_ = _e5542;
                                            phi_8915_ = select(true, false, _e5542);
                                            phi_8916_ = false;
                                            phi_8917_ = false;
                                        } else {
                                            let _e5563 = select(true, select(true, select(true, select(true, false, ((_e4475.member_1 - _e4475.member) <= _e1317)), select(false, (_e4475.member_1 <= _e1315), (_e4475.member >= _e1313))), _e4473), _e5543);
                                            let _e5565 = select(select(false, select((_e4475.member > _e1315), true, (_e4475.member_1 < _e1313)), _e4469), true, _e5542);
                                            let _e5566 = select(true, _e5565, select(((((select(0u, select(1u, 2u, ((_e3591[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3598.member - select(_e3611[0].member, (~(_e3591[0].member) + select(0u, 1u, (_e3595[0].member_1 == 0u))), _e3603)) - select(0u, 1u, (_e3598.member_1 < select(_e3611[0].member_1, (~(_e3595[0].member_1) + 1u), _e3603)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e3630[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e3637.member - select(_e3650[1].member, (~(_e3630[1].member) + select(0u, 1u, (_e3634[1].member_1 == 0u))), _e3642)) - select(0u, 1u, (_e3637.member_1 < select(_e3650[1].member_1, (~(_e3634[1].member_1) + 1u), _e3642)))) >> bitcast<u32>(31i)) != 0u))) | select(0u, select(1u, 2u, ((_e3670[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e3677.member - select(_e3690[2].member, (~(_e3670[2].member) + select(0u, 1u, (_e3674[2].member_1 == 0u))), _e3682)) - select(0u, 1u, (_e3677.member_1 < select(_e3690[2].member_1, (~(_e3674[2].member_1) + 1u), _e3682)))) >> bitcast<u32>(31i)) != 0u))) | select(0u, select(1u, 2u, ((_e3710[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e3717.member - select(_e3730[3].member, (~(_e3710[3].member) + select(0u, 1u, (_e3714[3].member_1 == 0u))), _e3722)) - select(0u, 1u, (_e3717.member_1 < select(_e3730[3].member_1, (~(_e3714[3].member_1) + 1u), _e3722)))) >> bitcast<u32>(31i)) != 0u))) == 0u), true, select((_e3751 == 31u), true, _e2835)));
                                            phi_8913_ = select(bool(), _e5565, _e5563);
                                            phi_8914_ = select(false, _e5566, _e5563);
                                            phi_8915_ = false;
                                            phi_8916_ = select(false, select(true, false, _e5566), _e5563);
                                            phi_8917_ = select(true, false, _e5563);
                                        }
                                        let _e5574 = phi_8913_;
                                        let _e5576 = phi_8914_;
                                        let _e5578 = phi_8915_;
                                        let _e5580 = phi_8916_;
                                        let _e5582 = phi_8917_;
                                        phi_8924_ = _e4469;
                                        phi_8925_ = _e4471;
                                        phi_8926_ = true;
                                        phi_8927_ = !(_e3843);
                                        phi_8928_ = _e4477;
                                        phi_8929_ = _e5574;
                                        phi_8930_ = _e5543;
                                        phi_8931_ = _e4475;
                                        phi_8932_ = _e5576;
                                        phi_8933_ = select(_e5578, false, _e5576);
                                        phi_8934_ = select(_e5580, false, _e5576);
                                        phi_8935_ = select(_e5582, false, _e5576);
                                    }
                                    let _e5587 = phi_8924_;
                                    let _e5589 = phi_8925_;
                                    let _e5591 = phi_8926_;
                                    let _e5593 = phi_8927_;
                                    let _e5595 = phi_8928_;
                                    let _e5597 = phi_8929_;
                                    let _e5599 = phi_8930_;
                                    let _e5601 = phi_8931_;
                                    let _e5603 = phi_8932_;
                                    let _e5605 = phi_8933_;
                                    let _e5607 = phi_8934_;
                                    let _e5609 = phi_8935_;
                                    phi_8936_ = _e5587;
                                    phi_8937_ = _e5589;
                                    phi_8938_ = _e5591;
                                    phi_8939_ = _e5593;
                                    phi_8940_ = _e5595;
                                    phi_8941_ = _e5597;
                                    phi_8942_ = _e5599;
                                    phi_8943_ = _e5601;
                                    phi_8944_ = _e5603;
                                    phi_8945_ = _e5605;
                                    phi_8946_ = _e5607;
                                    phi_8947_ = _e5609;
                                } else {
                                    phi_8936_ = _e2835;
                                    phi_8937_ = _e2837;
                                    let _e9799 = local_153;
                                    phi_8938_ = _e9799;
                                    let _e9802 = local_154;
                                    phi_8939_ = _e9802;
                                    phi_8940_ = _e2843;
                                    let _e9806 = local_155;
                                    phi_8941_ = _e9806;
                                    phi_8942_ = bool();
                                    phi_8943_ = type_20();
                                    phi_8944_ = true;
                                    phi_8945_ = false;
                                    phi_8946_ = false;
                                    phi_8947_ = false;
                                }
                                let _e5611 = phi_8936_;
                                let _e5613 = phi_8937_;
                                let _e5615 = phi_8938_;
                                let _e5617 = phi_8939_;
                                let _e5619 = phi_8940_;
                                let _e5621 = phi_8941_;
                                let _e5623 = phi_8942_;
                                let _e5625 = phi_8943_;
                                let _e5627 = phi_8944_;
                                let _e5629 = phi_8945_;
                                let _e5631 = phi_8946_;
                                let _e5633 = phi_8947_;
                                if _e5627 {
                                    if _e5621 {
                                        let _e5637 = local_96;
                                        let _e5638 = (_e5637 + 1u);
                                        let _e5640 = local_97;
                                        let _e5642 = (_e5638 & (4294967295u - _e5640));
                                        let _e5648 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e5642)), 32u, (_e5642 == 0u)));
                                        let _e5650 = local_98;
                                        let _e5653 = local_99;
                                        let _e5654 = select(_e5648, _e5653, (_e5650 < _e5648));
                                        let _e5657 = (_e5638 >> bitcast<u32>((_e5654 & 31u)));
                                        let _e5659 = local_100;
                                        let _e5660 = (_e5659 - _e5654);
                                        let _e5662 = local_101;
                                        let _e5663 = (_e5662 > _e1315);
                                        if _e5663 {
                                            phi_8998_ = u32();
                                            phi_8999_ = u32();
                                            phi_9000_ = false;
                                            phi_9001_ = false;
                                        } else {
                                            let _e5667 = select(true, select(true, false, (_e5660 == 0u)), (_e5657 == 1u));
                                            let _e5668 = (31u - _e5660);
                                            phi_8998_ = select(u32(), ((_e5657 + 1u) << bitcast<u32>((_e5668 & 31u))), _e5667);
                                            phi_8999_ = select(u32(), (_e5657 << bitcast<u32>((_e5668 & 31u))), _e5667);
                                            phi_9000_ = _e5667;
                                            phi_9001_ = select(true, false, _e5667);
                                        }
                                        let _e5680 = phi_8998_;
                                        let _e5682 = phi_8999_;
                                        let _e5684 = phi_9000_;
                                        let _e5686 = phi_9001_;
                                        phi_9002_ = _e5680;
                                        phi_9003_ = _e5682;
                                        phi_9004_ = false;
                                        phi_9005_ = false;
                                        phi_9006_ = false;
                                        phi_9007_ = false;
                                        phi_9008_ = _e5660;
                                        phi_9009_ = _e5657;
                                        phi_9010_ = _e5684;
                                        phi_9011_ = _e5663;
                                        phi_9012_ = _e5686;
                                    } else {
                                        phi_9002_ = _e5619.member_1;
                                        phi_9003_ = _e5619.member;
                                        phi_9004_ = _e5611;
                                        phi_9005_ = _e5613;
                                        phi_9006_ = _e5615;
                                        phi_9007_ = _e5617;
                                        let _e9831 = local_156;
                                        phi_9008_ = _e9831;
                                        let _e9834 = local_157;
                                        phi_9009_ = _e9834;
                                        phi_9010_ = true;
                                        phi_9011_ = false;
                                        phi_9012_ = false;
                                    }
                                    let _e5688 = phi_9002_;
                                    let _e5690 = phi_9003_;
                                    let _e5692 = phi_9004_;
                                    let _e5694 = phi_9005_;
                                    let _e5696 = phi_9006_;
                                    let _e5698 = phi_9007_;
                                    let _e5700 = phi_9008_;
                                    let _e5702 = phi_9009_;
                                    let _e5704 = phi_9010_;
                                    let _e5706 = phi_9011_;
                                    let _e5708 = phi_9012_;
                                    if _e5704 {
                                        if select(_e5692, true, _e5621) {
                                            let _e5715 = function_6(((_e2714 - _e2641.member) - select(0u, 1u, (_e2710 < _e2641.member_1))), (_e2710 - _e2641.member_1), _e5690);
                                            let _e5718 = (_e2641.member_1 + _e5715.member_1);
                                            let _e5728 = function_6(((_e2785 - _e2714) - select(0u, 1u, (_e2781 < _e2710))), (_e2781 - _e2710), _e5690);
                                            let _e5731 = (_e2710 + _e5728.member_1);
                                            let _e5741 = function_6(((_e2819.member - _e2785) - select(0u, 1u, (_e2819.member_1 < _e2781))), (_e2819.member_1 - _e2781), _e5690);
                                            let _e5744 = (_e2781 + _e5741.member_1);
                                            let _e5752 = array<type_9, 3>(type_9(((_e2641.member + _e5715.member) + select(0u, 1u, (_e5718 < _e2641.member_1))), _e5718), type_9(((_e2714 + _e5728.member) + select(0u, 1u, (_e5731 < _e2710))), _e5731), type_9(((_e2785 + _e5741.member) + select(0u, 1u, (_e5744 < _e2781))), _e5744));
                                            let _e5758 = function_6(((_e2714 - _e2641.member) - select(0u, 1u, (_e2710 < _e2641.member_1))), (_e2710 - _e2641.member_1), _e5688);
                                            let _e5761 = (_e2641.member_1 + _e5758.member_1);
                                            let _e5771 = function_6(((_e2785 - _e2714) - select(0u, 1u, (_e2781 < _e2710))), (_e2781 - _e2710), _e5688);
                                            let _e5774 = (_e2710 + _e5771.member_1);
                                            let _e5784 = function_6(((_e2819.member - _e2785) - select(0u, 1u, (_e2819.member_1 < _e2781))), (_e2819.member_1 - _e2781), _e5688);
                                            let _e5787 = (_e2781 + _e5784.member_1);
                                            let _e5796 = function_7(_e5752, _e5690);
                                            let _e5797 = function_7(_e5752, _e5688);
                                            let _e5798 = function_7(array<type_9, 3>(type_9(((_e2641.member + _e5758.member) + select(0u, 1u, (_e5761 < _e2641.member_1))), _e5761), type_9(((_e2714 + _e5771.member) + select(0u, 1u, (_e5774 < _e2710))), _e5774), type_9(((_e2785 + _e5784.member) + select(0u, 1u, (_e5787 < _e2781))), _e5787)), _e5688);
                                            let _e5812 = function_6(((_e5796[1].member - _e5796[0].member) - select(0u, 1u, (_e5796[1].member_1 < _e5796[0].member_1))), (_e5796[1].member_1 - _e5796[0].member_1), _e5690);
                                            let _e5815 = (_e5796[0].member_1 + _e5812.member_1);
                                            let _e5833 = function_6(((_e5796[1].member - _e5796[0].member) - select(0u, 1u, (_e5796[1].member_1 < _e5796[0].member_1))), (_e5796[1].member_1 - _e5796[0].member_1), _e5688);
                                            let _e5836 = (_e5796[0].member_1 + _e5833.member_1);
                                            let _e5854 = function_6(((_e5797[1].member - _e5797[0].member) - select(0u, 1u, (_e5797[1].member_1 < _e5797[0].member_1))), (_e5797[1].member_1 - _e5797[0].member_1), _e5688);
                                            let _e5857 = (_e5797[0].member_1 + _e5854.member_1);
                                            let _e5875 = function_6(((_e5798[1].member - _e5798[0].member) - select(0u, 1u, (_e5798[1].member_1 < _e5798[0].member_1))), (_e5798[1].member_1 - _e5798[0].member_1), _e5688);
                                            let _e5878 = (_e5798[0].member_1 + _e5875.member_1);
                                            phi_9279_ = array<type_9, 4>(type_9(((_e5796[0].member + _e5812.member) + select(0u, 1u, (_e5815 < _e5796[0].member_1))), _e5815), type_9(((_e5796[0].member + _e5833.member) + select(0u, 1u, (_e5836 < _e5796[0].member_1))), _e5836), type_9(((_e5797[0].member + _e5854.member) + select(0u, 1u, (_e5857 < _e5797[0].member_1))), _e5857), type_9(((_e5798[0].member + _e5875.member) + select(0u, 1u, (_e5878 < _e5798[0].member_1))), _e5878));
                                        } else {
                                            let _e9840 = local_158;
                                            phi_9279_ = _e9840;
                                        }
                                        let _e5889 = phi_9279_;
                                        phi_9280_ = _e5889;
                                        phi_9281_ = false;
                                        phi_9282_ = false;
                                    } else {
                                        phi_9280_ = array<type_9, 4>();
                                        phi_9281_ = _e5706;
                                        phi_9282_ = _e5708;
                                    }
                                    let _e5891 = phi_9280_;
                                    let _e5893 = phi_9281_;
                                    let _e5895 = phi_9282_;
                                    phi_9283_ = _e5891;
                                    phi_9284_ = _e5692;
                                    phi_9285_ = _e5694;
                                    phi_9286_ = _e5696;
                                    phi_9287_ = _e5698;
                                    phi_9288_ = _e5700;
                                    phi_9289_ = _e5702;
                                    phi_9290_ = _e5704;
                                    phi_9291_ = _e5893;
                                    phi_9292_ = _e5895;
                                    phi_9293_ = false;
                                    phi_9294_ = false;
                                    phi_9295_ = false;
                                } else {
                                    phi_9283_ = array<type_9, 4>();
                                    phi_9284_ = bool();
                                    phi_9285_ = bool();
                                    phi_9286_ = bool();
                                    phi_9287_ = bool();
                                    phi_9288_ = u32();
                                    phi_9289_ = u32();
                                    phi_9290_ = false;
                                    phi_9291_ = false;
                                    phi_9292_ = false;
                                    phi_9293_ = _e5629;
                                    phi_9294_ = _e5631;
                                    phi_9295_ = _e5633;
                                }
                                let _e5897 = phi_9283_;
                                let _e5899 = phi_9284_;
                                let _e5901 = phi_9285_;
                                let _e5903 = phi_9286_;
                                let _e5905 = phi_9287_;
                                let _e5907 = phi_9288_;
                                let _e5909 = phi_9289_;
                                let _e5911 = phi_9290_;
                                let _e5913 = phi_9291_;
                                let _e5915 = phi_9292_;
                                let _e5917 = phi_9293_;
                                let _e5919 = phi_9294_;
                                let _e5921 = phi_9295_;
                                phi_5105_ = _e5897;
                                phi_5108_ = _e5899;
                                phi_5110_ = _e5901;
                                phi_5112_ = _e5903;
                                phi_5114_ = _e5905;
                                phi_5116_ = _e5619;
                                let _e9865 = local_159;
                                phi_5120_ = _e9865;
                                let _e9868 = local_160;
                                phi_5122_ = _e9868;
                                let _e9871 = local_161;
                                phi_5124_ = _e9871;
                                phi_5126_ = _e5907;
                                phi_5128_ = _e5909;
                                phi_9296_ = _e5623;
                                phi_9297_ = _e5625;
                                phi_9298_ = _e5911;
                                phi_9299_ = false;
                                phi_9300_ = _e5913;
                                phi_9301_ = _e5915;
                                phi_9302_ = _e5917;
                                phi_9303_ = _e5919;
                                phi_9304_ = _e5921;
                            } else {
                                phi_5105_ = array<type_9, 4>();
                                phi_5108_ = bool();
                                phi_5110_ = bool();
                                phi_5112_ = bool();
                                phi_5114_ = bool();
                                phi_5116_ = type_20();
                                phi_5120_ = u32();
                                phi_5122_ = u32();
                                phi_5124_ = u32();
                                phi_5126_ = u32();
                                phi_5128_ = u32();
                                phi_9296_ = bool();
                                phi_9297_ = type_20();
                                phi_9298_ = false;
                                phi_9299_ = true;
                                phi_9300_ = false;
                                phi_9301_ = false;
                                phi_9302_ = false;
                                phi_9303_ = false;
                                phi_9304_ = false;
                            }
                            let _e5923 = phi_5105_;
                            let _e5925 = phi_5108_;
                            let _e5927 = phi_5110_;
                            let _e5929 = phi_5112_;
                            let _e5931 = phi_5114_;
                            let _e5933 = phi_5116_;
                            let _e5935 = phi_5120_;
                            let _e5937 = phi_5122_;
                            let _e5939 = phi_5124_;
                            let _e5941 = phi_5126_;
                            let _e5943 = phi_5128_;
                            let _e5945 = phi_9296_;
                            let _e5947 = phi_9297_;
                            let _e5949 = phi_9298_;
                            let _e5951 = phi_9299_;
                            let _e5953 = phi_9300_;
                            let _e5955 = phi_9301_;
                            let _e5957 = phi_9302_;
                            let _e5959 = phi_9303_;
                            let _e5961 = phi_9304_;
                            local_102 = _e5951;
                            local_103 = _e5951;
                            local_104 = _e5951;
                            local_105 = _e5953;
                            local_106 = _e5951;
                            local_107 = _e5955;
                            local_108 = _e5951;
                            local_109 = _e5957;
                            local_110 = _e5951;
                            local_111 = _e5959;
                            local_112 = _e5951;
                            local_113 = _e5961;
                            local_114 = _e5945;
                            local_115 = _e5945;
                            local_116 = _e5947;
                            continue;
                            continuing {
                                phi_5104_ = _e5923;
                                phi_5107_ = _e5925;
                                phi_5109_ = _e5927;
                                phi_5111_ = _e5929;
                                phi_5113_ = _e5931;
                                phi_5115_ = _e5933;
                                phi_5119_ = _e5935;
                                phi_5121_ = _e5937;
                                phi_5123_ = _e5939;
                                phi_5125_ = _e5941;
                                phi_5127_ = _e5943;
                                break if !(_e5949);
                            }
                        }
                        let _e5965 = local_102;
                        let _e5970 = local_103;
                        let _e5973 = local_104;
                        let _e5975 = local_105;
                        let _e5976 = select(_e5975, false, _e5973);
                        let _e5978 = local_106;
                        let _e5980 = local_107;
                        let _e5983 = local_108;
                        let _e5985 = local_109;
                        let _e5988 = local_110;
                        let _e5990 = local_111;
                        let _e5993 = local_112;
                        let _e5995 = local_113;
                        let _e5997 = select(select(_e5980, false, _e5978), false, _e5976);
                        let _e6001 = select(_e5976, true, _e5997);
                        let _e6010 = select(select(select(select(_e5985, false, _e5983), false, _e5976), false, _e5997), false, _e6001);
                        if _e6010 {
                            let _e6014 = local_114;
                            let _e6019 = local_115;
                            phi_9346_ = type_9(select(2u, 3u, _e6014), select(type_9().member_1, type_9().member_1, _e6019));
                            phi_9347_ = false;
                            phi_9348_ = false;
                            phi_9349_ = false;
                        } else {
                            phi_9346_ = type_9();
                            phi_9347_ = select(select(select(select(_e5990, false, _e5988), false, _e5976), false, _e5997), false, _e6001);
                            phi_9348_ = select(select(select(select(_e5995, false, _e5993), false, _e5976), false, _e5997), false, _e6001);
                            phi_9349_ = _e6001;
                        }
                        let _e6023 = phi_9346_;
                        let _e6025 = phi_9347_;
                        let _e6027 = phi_9348_;
                        let _e6029 = phi_9349_;
                        let _e6035 = select(_e6027, false, _e6025);
                        let _e6039 = local_116;
                        let _e6043 = select(_e6025, true, _e6035);
                        let _e6050 = select(select(select(_e6010, false, _e6025), false, _e6035), true, _e6043);
                        let _e6054 = select(select(select(select(_e6029, false, _e6025), false, _e6035), false, _e6043), true, _e6050);
                        let _e6055 = select(select(type_9().member, 2u, _e5965), select(select(type_9().member, 0u, _e6001), select(_e6023.member, select(select(type_9().member, 2u, _e6025), 1u, _e6035), _e6043), _e6050), _e6054);
                        let _e6056 = select(select(type_9().member_1, type_9().member_1, _e5970), select(select(type_9().member_1, type_9().member_1, _e6001), select(_e6023.member_1, select(select(type_9().member_1, type_9().member_1, _e6025), _e6039.member, _e6035), _e6043), _e6050), _e6054);
                        let _e6059 = global.member;
                        if (bitcast<i32>(_e6055) == bitcast<i32>(_e6059)) {
                            if (bitcast<i32>(_e6055) == 1i) {
                                let _e6065 = global.member;
                                if (bitcast<i32>(_e6065) == 1i) {
                                    let _e6069 = global.member_1;
                                    phi_9411_ = (_e6056 == _e6069);
                                    phi_9412_ = false;
                                } else {
                                    phi_9411_ = bool();
                                    phi_9412_ = true;
                                }
                                let _e6072 = phi_9411_;
                                let _e6074 = phi_9412_;
                                phi_9413_ = _e6072;
                                phi_9414_ = _e6074;
                            } else {
                                phi_9413_ = bool();
                                phi_9414_ = true;
                            }
                            let _e6076 = phi_9413_;
                            let _e6078 = phi_9414_;
                            phi_9419_ = select(_e6076, true, _e6078);
                        } else {
                            phi_9419_ = false;
                        }
                        let _e6081 = phi_9419_;
                        if !(_e6081) {
                            switch bitcast<i32>(_e6055) {
                                case 0: {
                                    phi_9456_ = type_31(0u, 0u, array<u32, 2>(0u, 0u), false);
                                    phi_9457_ = false;
                                    break;
                                }
                                case 1: {
                                    if (_e6056 == 0u) {
                                        phi_9453_ = array<u32, 2>(0u, 0u);
                                    } else {
                                        let _e6091 = select((bitcast<u32>(31i) - firstLeadingBit(_e6056)), 32u, (_e6056 == 0u));
                                        let _e6096 = ((_e6056 << bitcast<u32>((_e6091 & 31u))) << bitcast<u32>(1i));
                                        phi_9453_ = array<u32, 2>((_e6096 << bitcast<u32>(20i)), (((1023u - _e6091) << bitcast<u32>(20i)) | (_e6096 >> bitcast<u32>(12i))));
                                    }
                                    let _e6107 = phi_9453_;
                                    phi_9456_ = type_31(0u, select(0u, 1u, (_e6056 > _e1313)), _e6107, true);
                                    phi_9457_ = false;
                                    break;
                                }
                                case 2: {
                                    phi_9456_ = type_31();
                                    phi_9457_ = true;
                                    break;
                                }
                                case 3: {
                                    phi_9456_ = type_31();
                                    phi_9457_ = true;
                                    break;
                                }
                                default: {
                                    phi_9456_ = type_31();
                                    phi_9457_ = bool();
                                    break;
                                }
                            }
                            let _e6110 = phi_9456_;
                            let _e6112 = phi_9457_;
                            if _e6112 {
                                phi_9464_ = type_31(1u, 0u, array<u32, 2>(0u, 0u), true);
                            } else {
                                phi_9464_ = _e6110;
                            }
                            let _e6114 = phi_9464_;
                            phi_9465_ = _e6114;
                            phi_9466_ = false;
                        } else {
                            phi_9465_ = type_31();
                            phi_9466_ = true;
                        }
                        let _e6116 = phi_9465_;
                        let _e6118 = phi_9466_;
                        phi_9467_ = _e6116;
                        phi_9468_ = _e6118;
                    } else {
                        phi_9467_ = type_31();
                        phi_9468_ = true;
                    }
                    let _e6120 = phi_9467_;
                    let _e6122 = phi_9468_;
                    phi_9469_ = _e6120;
                    phi_9470_ = _e6122;
                } else {
                    phi_9469_ = type_31();
                    phi_9470_ = true;
                }
                let _e6124 = phi_9469_;
                let _e6126 = phi_9470_;
                if _e6126 {
                    let _e6128 = params.member.member.member_11;
                    let _e6130 = params.member.member.member_12;
                    let _e6132 = params.member.member.member_13;
                    let _e6134 = params.member.member.member_13;
                    let _e6140 = select(_e540.member[0][0], -(_e540.member[0][0]), (_e540.member[0][0] < 0f));
                    let _e6144 = select(_e540.member[0][1], -(_e540.member[0][1]), (_e540.member[0][1] < 0f));
                    let _e6146 = select(_e6144, _e6140, (_e6140 > _e6144));
                    let _e6150 = select(_e540.member[0][2], -(_e540.member[0][2]), (_e540.member[0][2] < 0f));
                    let _e6152 = select(_e6150, _e6146, (_e6146 > _e6150));
                    let _e6158 = select(_e540.member[1][0], -(_e540.member[1][0]), (_e540.member[1][0] < 0f));
                    let _e6162 = select(_e540.member[1][1], -(_e540.member[1][1]), (_e540.member[1][1] < 0f));
                    let _e6164 = select(_e6162, _e6158, (_e6158 > _e6162));
                    let _e6168 = select(_e540.member[1][2], -(_e540.member[1][2]), (_e540.member[1][2] < 0f));
                    let _e6170 = select(_e6168, _e6164, (_e6164 > _e6168));
                    let _e6174 = (select(_e6170, _e6152, (_e6152 > _e6170)) + _e540.member_3);
                    let _e6180 = select(_e540.member_1[0][0], -(_e540.member_1[0][0]), (_e540.member_1[0][0] < 0f));
                    let _e6184 = select(_e540.member_1[0][1], -(_e540.member_1[0][1]), (_e540.member_1[0][1] < 0f));
                    let _e6186 = select(_e6184, _e6180, (_e6180 > _e6184));
                    let _e6190 = select(_e540.member_1[0][2], -(_e540.member_1[0][2]), (_e540.member_1[0][2] < 0f));
                    let _e6192 = select(_e6190, _e6186, (_e6186 > _e6190));
                    let _e6198 = select(_e540.member_1[1][0], -(_e540.member_1[1][0]), (_e540.member_1[1][0] < 0f));
                    let _e6202 = select(_e540.member_1[1][1], -(_e540.member_1[1][1]), (_e540.member_1[1][1] < 0f));
                    let _e6204 = select(_e6202, _e6198, (_e6198 > _e6202));
                    let _e6208 = select(_e540.member_1[1][2], -(_e540.member_1[1][2]), (_e540.member_1[1][2] < 0f));
                    let _e6210 = select(_e6208, _e6204, (_e6204 > _e6208));
                    let _e6214 = (select(_e6210, _e6192, (_e6192 > _e6210)) + _e540.member_3);
                    let _e6220 = select(_e540.member_2[0][0], -(_e540.member_2[0][0]), (_e540.member_2[0][0] < 0f));
                    let _e6224 = select(_e540.member_2[0][1], -(_e540.member_2[0][1]), (_e540.member_2[0][1] < 0f));
                    let _e6226 = select(_e6224, _e6220, (_e6220 > _e6224));
                    let _e6230 = select(_e540.member_2[0][2], -(_e540.member_2[0][2]), (_e540.member_2[0][2] < 0f));
                    let _e6232 = select(_e6230, _e6226, (_e6226 > _e6230));
                    let _e6238 = select(_e540.member_2[1][0], -(_e540.member_2[1][0]), (_e540.member_2[1][0] < 0f));
                    let _e6242 = select(_e540.member_2[1][1], -(_e540.member_2[1][1]), (_e540.member_2[1][1] < 0f));
                    let _e6244 = select(_e6242, _e6238, (_e6238 > _e6242));
                    let _e6248 = select(_e540.member_2[1][2], -(_e540.member_2[1][2]), (_e540.member_2[1][2] < 0f));
                    let _e6250 = select(_e6248, _e6244, (_e6244 > _e6248));
                    let _e6254 = (select(_e6250, _e6232, (_e6232 > _e6250)) + _e540.member_3);
                    let _e6256 = select(_e6214, _e6174, (_e6174 > _e6214));
                    let _e6258 = select(_e6254, _e6256, (_e6256 > _e6254));
                    if (_e6258 <= 65536f) {
                        phi_9741_ = (_e6258 >= (1f / 65536f));
                    } else {
                        phi_9741_ = false;
                    }
                    let _e6263 = phi_9741_;
                    if _e6263 {
                        phi_9839_ = type_29();
                        phi_9840_ = true;
                    } else {
                        if (_e6258 >= 0.000000000000000000000000000000000000011754944f) {
                            if ((bitcast<u32>(_e6258) & 2139095040u) != 2139095040u) {
                                let _e6270 = (2130706432u - (bitcast<u32>(_e6258) & 2139095040u));
                                let _e6273 = bitcast<f32>(select(8388608u, _e6270, (_e6270 > 8388608u)));
                                phi_9835_ = type_29(type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e540.member[0][0] * _e6273), (_e540.member[0][1] * _e6273), (_e540.member[0][2] * _e6273)), array<f32, 3>((_e540.member[1][0] * _e6273), (_e540.member[1][1] * _e6273), (_e540.member[1][2] * _e6273))), array<array<f32, 3>, 2>(array<f32, 3>((_e540.member_1[0][0] * _e6273), (_e540.member_1[0][1] * _e6273), (_e540.member_1[0][2] * _e6273)), array<f32, 3>((_e540.member_1[1][0] * _e6273), (_e540.member_1[1][1] * _e6273), (_e540.member_1[1][2] * _e6273))), array<array<f32, 3>, 2>(array<f32, 3>((_e540.member_2[0][0] * _e6273), (_e540.member_2[0][1] * _e6273), (_e540.member_2[0][2] * _e6273)), array<f32, 3>((_e540.member_2[1][0] * _e6273), (_e540.member_2[1][1] * _e6273), (_e540.member_2[1][2] * _e6273))), ((_e540.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e6273)), (0f * _e6273));
                                phi_9836_ = false;
                            } else {
                                phi_9835_ = type_29();
                                phi_9836_ = true;
                            }
                            let _e6339 = phi_9835_;
                            let _e6341 = phi_9836_;
                            phi_9837_ = _e6339;
                            phi_9838_ = _e6341;
                        } else {
                            phi_9837_ = type_29();
                            phi_9838_ = true;
                        }
                        let _e6343 = phi_9837_;
                        let _e6345 = phi_9838_;
                        phi_9839_ = _e6343;
                        phi_9840_ = _e6345;
                    }
                    let _e6347 = phi_9839_;
                    let _e6349 = phi_9840_;
                    if _e6349 {
                        phi_9845_ = type_29(_e540, 0f);
                    } else {
                        phi_9845_ = _e6347;
                    }
                    let _e6352 = phi_9845_;
                    local_7 = type_27(array<array<f32, 3>, 2>(array<f32, 3>(_e6352.member.member[0][0], _e6352.member.member[0][1], _e6352.member.member[0][2]), array<f32, 3>(_e6352.member.member[1][0], _e6352.member.member[1][1], _e6352.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e6352.member.member_1[0][0], _e6352.member.member_1[0][1], _e6352.member.member_1[0][2]), array<f32, 3>(_e6352.member.member_1[1][0], _e6352.member.member_1[1][1], _e6352.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e6352.member.member_2[0][0], _e6352.member.member_2[0][1], _e6352.member.member_2[0][2]), array<f32, 3>(_e6352.member.member_2[1][0], _e6352.member.member_2[1][1], _e6352.member.member_2[1][2])), _e6352.member.member_3);
                    let _e6394 = local_7.member_1[0u];
                    let _e6400 = local_7.member_2[0u];
                    let _e6406 = ((_e6394[1] * _e6400[2]) - (_e6394[2] * _e6400[1]));
                    let _e6409 = ((_e6394[2] * _e6400[0]) - (_e6394[0] * _e6400[2]));
                    let _e6412 = ((_e6394[0] * _e6400[1]) - (_e6394[1] * _e6400[0]));
                    let _e6415 = local_7.member_1[1u];
                    let _e6421 = local_7.member_2[1u];
                    let _e6427 = ((_e6415[1] * _e6421[2]) - (_e6415[2] * _e6421[1]));
                    let _e6430 = ((_e6415[2] * _e6421[0]) - (_e6415[0] * _e6421[2]));
                    let _e6433 = ((_e6415[0] * _e6421[1]) - (_e6415[1] * _e6421[0]));
                    let _e6436 = local_7.member_1[0u];
                    let _e6442 = local_7.member_2[1u];
                    let _e6457 = local_7.member_1[1u];
                    let _e6463 = local_7.member_2[0u];
                    let _e6476 = (((_e6436[1] * _e6442[2]) - (_e6436[2] * _e6442[1])) + ((_e6457[1] * _e6463[2]) - (_e6457[2] * _e6463[1])));
                    let _e6477 = (((_e6436[2] * _e6442[0]) - (_e6436[0] * _e6442[2])) + ((_e6457[2] * _e6463[0]) - (_e6457[0] * _e6463[2])));
                    let _e6478 = (((_e6436[0] * _e6442[1]) - (_e6436[1] * _e6442[0])) + ((_e6457[0] * _e6463[1]) - (_e6457[1] * _e6463[0])));
                    let _e6481 = local_7.member[0u];
                    let _e6489 = (((_e6481[0] * _e6406) + (_e6481[1] * _e6409)) + (_e6481[2] * _e6412));
                    let _e6492 = local_7.member[1u];
                    let _e6503 = local_7.member[0u];
                    let _e6512 = ((((_e6492[0] * _e6406) + (_e6492[1] * _e6409)) + (_e6492[2] * _e6412)) + (((_e6503[0] * _e6476) + (_e6503[1] * _e6477)) + (_e6503[2] * _e6478)));
                    let _e6515 = local_7.member[0u];
                    let _e6526 = local_7.member[1u];
                    let _e6535 = ((((_e6515[0] * _e6427) + (_e6515[1] * _e6430)) + (_e6515[2] * _e6433)) + (((_e6526[0] * _e6476) + (_e6526[1] * _e6477)) + (_e6526[2] * _e6478)));
                    let _e6538 = local_7.member[1u];
                    let _e6546 = (((_e6538[0] * _e6427) + (_e6538[1] * _e6430)) + (_e6538[2] * _e6433));
                    let _e6549 = local_7.member[0u];
                    let _e6555 = select(_e6549[0], -(_e6549[0]), (_e6549[0] < 0f));
                    let _e6558 = select(_e6549[1], -(_e6549[1]), (_e6549[1] < 0f));
                    let _e6560 = select(_e6558, _e6555, (_e6555 > _e6558));
                    let _e6563 = select(_e6549[2], -(_e6549[2]), (_e6549[2] < 0f));
                    let _e6565 = select(_e6563, _e6560, (_e6560 > _e6563));
                    let _e6568 = local_7.member[1u];
                    let _e6574 = select(_e6568[0], -(_e6568[0]), (_e6568[0] < 0f));
                    let _e6577 = select(_e6568[1], -(_e6568[1]), (_e6568[1] < 0f));
                    let _e6579 = select(_e6577, _e6574, (_e6574 > _e6577));
                    let _e6582 = select(_e6568[2], -(_e6568[2]), (_e6568[2] < 0f));
                    let _e6584 = select(_e6582, _e6579, (_e6579 > _e6582));
                    let _e6588 = local_7.member_3;
                    let _e6589 = (select(_e6584, _e6565, (_e6565 > _e6584)) + _e6588);
                    let _e6592 = local_7.member_1[0u];
                    let _e6598 = select(_e6592[0], -(_e6592[0]), (_e6592[0] < 0f));
                    let _e6601 = select(_e6592[1], -(_e6592[1]), (_e6592[1] < 0f));
                    let _e6603 = select(_e6601, _e6598, (_e6598 > _e6601));
                    let _e6606 = select(_e6592[2], -(_e6592[2]), (_e6592[2] < 0f));
                    let _e6608 = select(_e6606, _e6603, (_e6603 > _e6606));
                    let _e6611 = local_7.member_1[1u];
                    let _e6617 = select(_e6611[0], -(_e6611[0]), (_e6611[0] < 0f));
                    let _e6620 = select(_e6611[1], -(_e6611[1]), (_e6611[1] < 0f));
                    let _e6622 = select(_e6620, _e6617, (_e6617 > _e6620));
                    let _e6625 = select(_e6611[2], -(_e6611[2]), (_e6611[2] < 0f));
                    let _e6627 = select(_e6625, _e6622, (_e6622 > _e6625));
                    let _e6631 = local_7.member_3;
                    let _e6632 = (select(_e6627, _e6608, (_e6608 > _e6627)) + _e6631);
                    let _e6635 = local_7.member_2[0u];
                    let _e6641 = select(_e6635[0], -(_e6635[0]), (_e6635[0] < 0f));
                    let _e6644 = select(_e6635[1], -(_e6635[1]), (_e6635[1] < 0f));
                    let _e6646 = select(_e6644, _e6641, (_e6641 > _e6644));
                    let _e6649 = select(_e6635[2], -(_e6635[2]), (_e6635[2] < 0f));
                    let _e6651 = select(_e6649, _e6646, (_e6646 > _e6649));
                    let _e6654 = local_7.member_2[1u];
                    let _e6660 = select(_e6654[0], -(_e6654[0]), (_e6654[0] < 0f));
                    let _e6663 = select(_e6654[1], -(_e6654[1]), (_e6654[1] < 0f));
                    let _e6665 = select(_e6663, _e6660, (_e6660 > _e6663));
                    let _e6668 = select(_e6654[2], -(_e6654[2]), (_e6654[2] < 0f));
                    let _e6670 = select(_e6668, _e6665, (_e6665 > _e6668));
                    let _e6674 = local_7.member_3;
                    let _e6675 = (select(_e6670, _e6651, (_e6651 > _e6670)) + _e6674);
                    let _e6677 = ((_e6632 * 8f) * _e6675);
                    let _e6684 = local_7.member_3;
                    let _e6708 = ((select(_e6406, -(_e6406), (_e6406 < 0f)) + select(_e6409, -(_e6409), (_e6409 < 0f))) + select(_e6412, -(_e6412), (_e6412 < 0f)));
                    let _e6719 = ((select(_e6427, -(_e6427), (_e6427 < 0f)) + select(_e6430, -(_e6430), (_e6430 < 0f))) + select(_e6433, -(_e6433), (_e6433 < 0f)));
                    let _e6721 = select(_e6719, _e6708, (_e6708 > _e6719));
                    let _e6733 = (((select(_e6476, -(_e6476), (_e6476 < 0f)) + select(_e6477, -(_e6477), (_e6477 < 0f))) + select(_e6478, -(_e6478), (_e6478 < 0f))) * 0.5f);
                    let _e6740 = local_7.member_3;
                    let _e6752 = (((((_e6589 * 8f) * _e6677) * (0.000000059604645f * (524f / 64f))) + ((_e6684 * 19f) * ((_e6589 * (_e6632 + _e6675)) + (_e6632 * _e6675)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6589) * ((1f + _e6632) * (1f + _e6675)))));
                    let _e6753 = (_e6489 * 3f);
                    let _e6754 = (_e6546 * 3f);
                    let _e6756 = select(_e6754, _e6753, (_e6753 < _e6754));
                    let _e6758 = select(_e6535, _e6512, (_e6512 < _e6535));
                    let _e6760 = select(_e6758, _e6756, (_e6756 < _e6758));
                    let _e6762 = select(_e6754, _e6753, (_e6753 > _e6754));
                    let _e6764 = select(_e6535, _e6512, (_e6512 > _e6535));
                    let _e6771 = -(select(_e6764, _e6762, (_e6762 > _e6764)));
                    if ((select(_e6771, _e6760, (_e6760 > _e6771)) - (_e6752 + ((0f * (((select(_e6733, _e6721, (_e6721 > _e6733)) + (_e6677 * (0.000000059604645f * 8f))) + ((_e6740 * 6f) * (_e6632 + _e6675))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6632) * (1f + _e6675))))) * (3f * 1.0001f)))) > 0f) {
                        phi_15067_ = type_30(0u, type_30().member_1);
                        phi_15068_ = type_30();
                        phi_15069_ = true;
                    } else {
                        let _e6779 = select(_e6489, -(_e6489), (_e6489 < 0f));
                        let _e6782 = select(_e6512, -(_e6512), (_e6512 < 0f));
                        let _e6784 = select(_e6782, _e6779, (_e6779 > _e6782));
                        let _e6787 = select(_e6535, -(_e6535), (_e6535 < 0f));
                        let _e6790 = select(_e6546, -(_e6546), (_e6546 < 0f));
                        let _e6792 = select(_e6790, _e6787, (_e6787 > _e6790));
                        let _e6794 = select(_e6792, _e6784, (_e6784 > _e6792));
                        let _e6795 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e6794 >= _e6795) {
                            phi_10570_ = (_e6794 <= (1f / _e6795));
                        } else {
                            phi_10570_ = false;
                        }
                        let _e6800 = phi_10570_;
                        if _e6800 {
                            phi_10582_ = (1f / _e6794);
                        } else {
                            phi_10582_ = 0f;
                        }
                        let _e6807 = phi_10582_;
                        let _e6808 = (_e6128 * 0.0625f);
                        local_5 = type_34(array<f32, 4>(_e6489, _e6512, _e6535, _e6546), ((_e6752 * 0.34f) + (_e6794 * select(2f, (0.000000059604645f * 256f), _e6800))), _e6807, select(_e6808, 0.00000000000022737368f, (0.00000000000022737368f < _e6808)));
                        let _e6815 = local_5.member[0u];
                        let _e6818 = local_5.member[1u];
                        let _e6821 = local_5.member[2u];
                        let _e6824 = local_5.member[3u];
                        let _e6831 = local_5.member_2;
                        let _e6832 = ((_e6818 - (3f * _e6815)) * _e6831);
                        let _e6834 = local_5.member_2;
                        let _e6835 = ((_e6821 - _e6818) * _e6834);
                        let _e6837 = local_5.member_2;
                        let _e6838 = (((3f * _e6824) - _e6821) * _e6837);
                        local_3[0u] = 0f;
                        local_3[1u] = 1f;
                        local_3[2u] = 1f;
                        local_3[3u] = 1f;
                        let _e6845 = ((_e6835 * _e6835) - (_e6832 * _e6838));
                        if (_e6845 > 0f) {
                            if (_e6845 <= 0.000000000000000000000000000000000000011754944f) {
                                phi_10710_ = select(0f, (0.000000000000000000106433627f * 2f), (_e6845 > 0f));
                            } else {
                                phi_10653_ = type_14(0i, 5i);
                                phi_10656_ = bitcast<f32>(((bitcast<u32>(_e6845) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e6854 = phi_10653_;
                                    let _e6856 = phi_10656_;
                                    local_117 = _e6856;
                                    if (_e6854.member < _e6854.member_1) {
                                        let _e6863 = (_e6854.member + 1i);
                                        phi_10654_ = type_14(select(_e6863, type_15().member_1, select(false, true, ((false == (_e6863 > _e6854.member)) != false))), _e6854.member_1);
                                        phi_10697_ = type_15(1u, _e6854.member);
                                    } else {
                                        phi_10654_ = _e6854;
                                        phi_10697_ = type_15(0u, type_15().member_1);
                                    }
                                    let _e6874 = phi_10654_;
                                    let _e6876 = phi_10697_;
                                    let _e6879 = (bitcast<i32>(_e6876.member) != 0i);
                                    if _e6879 {
                                        phi_10657_ = (0.5f * (_e6856 + (_e6845 / _e6856)));
                                    } else {
                                        phi_10657_ = f32();
                                    }
                                    let _e6884 = phi_10657_;
                                    continue;
                                    continuing {
                                        phi_10653_ = _e6874;
                                        phi_10656_ = _e6884;
                                        break if !(_e6879);
                                    }
                                }
                                let _e6889 = local_117;
                                phi_10710_ = (_e6889 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e6895 = phi_10710_;
                            let _e6900 = -((_e6835 + select(_e6895, -(_e6895), (_e6835 < 0f))));
                            local_4[0u] = (_e6900 / (_e6900 + _e6838));
                            local_4[1u] = (_e6832 / (_e6832 + _e6900));
                            let _e6909 = local_4[1u];
                            let _e6910 = local_4[0u];
                            if (_e6909 < _e6910) {
                                let _e6913 = local_4[1u];
                                let _e6915 = local_4[0u];
                                local_4[0u] = _e6913;
                                local_4[1u] = _e6915;
                            }
                            phi_10741_ = type_9(0u, 2u);
                            phi_10744_ = 1u;
                            loop {
                                let _e6919 = phi_10741_;
                                let _e6921 = phi_10744_;
                                local_162 = _e6921;
                                let _e6924 = (_e6919.member < _e6919.member_1);
                                let _e6935 = select(type_9().member_1, _e6919.member, _e6924);
                                let _e6937 = (bitcast<i32>(select(0u, 1u, _e6924)) != 0i);
                                if _e6937 {
                                    let _e6939 = local_4[_e6935];
                                    if (_e6939 > 0f) {
                                        let _e6942 = local_4[_e6935];
                                        if (_e6942 < 1f) {
                                            let _e6945 = local_4[_e6935];
                                            local_3[_e6921] = _e6945;
                                            phi_10811_ = (_e6921 + 1u);
                                        } else {
                                            phi_10811_ = _e6921;
                                        }
                                        let _e6949 = phi_10811_;
                                        phi_10812_ = _e6949;
                                    } else {
                                        phi_10812_ = _e6921;
                                    }
                                    let _e6951 = phi_10812_;
                                    phi_10745_ = _e6951;
                                } else {
                                    phi_10745_ = u32();
                                }
                                let _e6953 = phi_10745_;
                                continue;
                                continuing {
                                    phi_10741_ = type_9(select(_e6919.member, (_e6919.member + 1u), _e6924), select(_e6919.member_1, _e6919.member_1, _e6924));
                                    phi_10744_ = _e6953;
                                    break if !(_e6937);
                                }
                            }
                            let _e9941 = local_162;
                            phi_10813_ = _e9941;
                        } else {
                            phi_10813_ = 1u;
                        }
                        let _e6956 = phi_10813_;
                        local_3[_e6956] = 1f;
                        let _e6958 = local_3;
                        local_6 = _e6958;
                        let _e6959 = (_e6128 * 0.99f);
                        let _e6960 = (1f - _e6130);
                        let _e6963 = local_5.member[0u];
                        let _e6966 = local_5.member[1u];
                        let _e6969 = local_5.member[2u];
                        let _e6972 = local_5.member[3u];
                        let _e6983 = ((((_e6963 * _e6960) + (_e6966 * _e6130)) * (_e6960 * _e6960)) + (((_e6969 * _e6960) + (_e6972 * _e6130)) * (_e6130 * _e6130)));
                        let _e6988 = local_5.member_1;
                        phi_10869_ = type_9(select(1u, 0u, !((select(_e6983, -(_e6983), (_e6983 < 0f)) > _e6988))), (_e6956 + 1u));
                        loop {
                            let _e6995 = phi_10869_;
                            let _e6998 = (_e6995.member < _e6995.member_1);
                            let _e7009 = select(type_9().member_1, _e6995.member, _e6998);
                            if (bitcast<i32>(select(0u, 1u, _e6998)) != 0i) {
                                if (_e7009 > 0u) {
                                    let _e7016 = local_6[(_e7009 - 1u)];
                                    let _e7018 = select(_e6130, _e7016, (_e7016 > _e6130));
                                    let _e7020 = local_6[_e7009];
                                    let _e7022 = select(_e6132, _e7020, (_e7020 < _e6132));
                                    if (_e7018 <= _e7022) {
                                        let _e7024 = function_5((&local_5), _e6134, _e7018, _e7022);
                                        if _e7024 {
                                            phi_12272_ = type_45();
                                            phi_12273_ = bool();
                                            phi_12274_ = type_45();
                                            phi_12275_ = false;
                                            phi_12276_ = false;
                                            phi_12277_ = false;
                                            phi_12278_ = false;
                                        } else {
                                            let _e7025 = (1f - _e7018);
                                            let _e7028 = local_5.member[0u];
                                            let _e7031 = local_5.member[1u];
                                            let _e7034 = local_5.member[2u];
                                            let _e7037 = local_5.member[3u];
                                            let _e7048 = ((((_e7028 * _e7025) + (_e7031 * _e7018)) * (_e7025 * _e7025)) + (((_e7034 * _e7025) + (_e7037 * _e7018)) * (_e7018 * _e7018)));
                                            let _e7049 = (1f - _e7022);
                                            let _e7052 = local_5.member[0u];
                                            let _e7055 = local_5.member[1u];
                                            let _e7058 = local_5.member[2u];
                                            let _e7061 = local_5.member[3u];
                                            let _e7072 = ((((_e7052 * _e7049) + (_e7055 * _e7022)) * (_e7049 * _e7049)) + (((_e7058 * _e7049) + (_e7061 * _e7022)) * (_e7022 * _e7022)));
                                            let _e7077 = local_5.member_1;
                                            let _e7078 = (select(_e7048, -(_e7048), (_e7048 < 0f)) > _e7077);
                                            let _e7083 = local_5.member_1;
                                            let _e7084 = (select(_e7072, -(_e7072), (_e7072 < 0f)) > _e7083);
                                            let _e7092 = select(select(bool(), select(bool(), ((_e7048 > 0f) != (_e7072 > 0f)), _e7084), _e7078), false, select(true, select(true, false, _e7084), _e7078));
                                            if _e7078 {
                                                if _e7084 {
                                                    phi_11025_ = type_45(select(1f, type_45().member, _e7092), select(0f, type_45().member_1, _e7092), select(_e7092, type_45().member_2, _e7092));
                                                    phi_11026_ = _e7092;
                                                } else {
                                                    phi_11025_ = type_45();
                                                    phi_11026_ = true;
                                                }
                                                let _e7101 = phi_11025_;
                                                let _e7103 = phi_11026_;
                                                phi_11027_ = _e7101;
                                                phi_11028_ = _e7103;
                                            } else {
                                                phi_11027_ = type_45();
                                                phi_11028_ = true;
                                            }
                                            let _e7105 = phi_11027_;
                                            let _e7107 = phi_11028_;
                                            if _e7107 {
                                                if _e7078 {
                                                    let _e7109 = select(1f, -1f, (_e7048 < 0f));
                                                    let _e7111 = local_5.member_3;
                                                    let _e7114 = local_5.member[0u];
                                                    let _e7117 = local_5.member[1u];
                                                    let _e7120 = local_5.member[2u];
                                                    let _e7123 = local_5.member[3u];
                                                    let _e7126 = (_e7120 - _e7117);
                                                    phi_11059_ = type_9(0u, 64u);
                                                    phi_11062_ = _e7022;
                                                    phi_11064_ = _e7018;
                                                    phi_11066_ = (0.5f * (_e7018 + _e7022));
                                                    loop {
                                                        let _e7132 = phi_11059_;
                                                        let _e7134 = phi_11062_;
                                                        let _e7136 = phi_11064_;
                                                        let _e7138 = phi_11066_;
                                                        local_120 = _e7136;
                                                        let _e7141 = (_e7132.member < _e7132.member_1);
                                                        if (bitcast<i32>(select(0u, 1u, _e7141)) != 0i) {
                                                            let _e7153 = (1f - _e7138);
                                                            let _e7156 = local_5.member[0u];
                                                            let _e7159 = local_5.member[1u];
                                                            let _e7162 = local_5.member[2u];
                                                            let _e7165 = local_5.member[3u];
                                                            let _e7179 = local_5.member_1;
                                                            let _e7180 = ((_e7109 * ((((_e7156 * _e7153) + (_e7159 * _e7138)) * (_e7153 * _e7153)) + (((_e7162 * _e7153) + (_e7165 * _e7138)) * (_e7138 * _e7138)))) - _e7179);
                                                            let _e7181 = (_e7180 > 0f);
                                                            let _e7182 = select(_e7138, _e7134, _e7181);
                                                            let _e7183 = select(_e7136, _e7138, _e7181);
                                                            let _e7185 = ((_e7182 - _e7183) > _e7111);
                                                            if _e7185 {
                                                                let _e7186 = (1f - _e7138);
                                                                let _e7198 = (-(_e7180) / (_e7109 * (((((_e7117 - (3f * _e7114)) * _e7186) + (_e7126 * _e7138)) * _e7186) + (((_e7126 * _e7186) + (((3f * _e7123) - _e7120) * _e7138)) * _e7138))));
                                                                let _e7205 = ((_e7138 + _e7198) + select(-((0.5f * _e7111)), (0.5f * _e7111), (_e7180 > 0f)));
                                                                if (_e7205 > _e7183) {
                                                                    phi_11176_ = select(true, select(true, false, (select(_e7198, -(_e7198), (_e7198 < 0f)) < (0.5f * (_e7182 - _e7183)))), (_e7205 < _e7182));
                                                                } else {
                                                                    phi_11176_ = true;
                                                                }
                                                                let _e7217 = phi_11176_;
                                                                phi_11183_ = select(_e7205, (0.5f * (_e7183 + _e7182)), _e7217);
                                                                phi_11184_ = false;
                                                            } else {
                                                                phi_11183_ = f32();
                                                                phi_11184_ = true;
                                                            }
                                                            let _e7222 = phi_11183_;
                                                            let _e7224 = phi_11184_;
                                                            phi_11063_ = _e7182;
                                                            phi_11065_ = _e7183;
                                                            phi_11067_ = _e7222;
                                                            phi_11185_ = _e7183;
                                                            phi_11186_ = _e7185;
                                                            phi_11187_ = _e7224;
                                                        } else {
                                                            phi_11063_ = f32();
                                                            phi_11065_ = f32();
                                                            phi_11067_ = f32();
                                                            phi_11185_ = f32();
                                                            phi_11186_ = false;
                                                            phi_11187_ = false;
                                                        }
                                                        let _e7226 = phi_11063_;
                                                        let _e7228 = phi_11065_;
                                                        let _e7230 = phi_11067_;
                                                        let _e7232 = phi_11185_;
                                                        let _e7234 = phi_11186_;
                                                        let _e7236 = phi_11187_;
                                                        local_118 = _e7236;
                                                        local_119 = _e7232;
                                                        continue;
                                                        continuing {
                                                            phi_11059_ = type_9(select(_e7132.member, (_e7132.member + 1u), _e7141), select(_e7132.member_1, _e7132.member_1, _e7141));
                                                            phi_11062_ = _e7226;
                                                            phi_11064_ = _e7228;
                                                            phi_11066_ = _e7230;
                                                            break if !(_e7234);
                                                        }
                                                    }
                                                    let _e7239 = local_118;
                                                    let _e7241 = local_119;
                                                    let _e7243 = local_120;
                                                    phi_11192_ = select(_e7243, _e7241, _e7239);
                                                } else {
                                                    phi_11192_ = _e7018;
                                                }
                                                let _e7246 = phi_11192_;
                                                if _e7084 {
                                                    let _e7250 = local_5.member_3;
                                                    let _e7252 = local_5.member_3;
                                                    phi_11208_ = type_9(0u, 64u);
                                                    phi_11211_ = (_e7250 + _e7252);
                                                    loop {
                                                        let _e7255 = phi_11208_;
                                                        let _e7257 = phi_11211_;
                                                        let _e7260 = (_e7255.member < _e7255.member_1);
                                                        if (bitcast<i32>(select(0u, 1u, _e7260)) != 0i) {
                                                            let _e7272 = (_e7246 + _e7257);
                                                            if (_e7272 < _e7022) {
                                                                let _e7274 = (1f - _e7272);
                                                                let _e7277 = local_5.member[0u];
                                                                let _e7280 = local_5.member[1u];
                                                                let _e7283 = local_5.member[2u];
                                                                let _e7286 = local_5.member[3u];
                                                                let _e7300 = local_5.member_1;
                                                                let _e7301 = ((select(1f, -1f, (_e7072 < 0f)) * ((((_e7277 * _e7274) + (_e7280 * _e7272)) * (_e7274 * _e7274)) + (((_e7283 * _e7274) + (_e7286 * _e7272)) * (_e7272 * _e7272)))) > _e7300);
                                                                phi_11276_ = select((_e7257 + _e7257), f32(), _e7301);
                                                                phi_11277_ = select(true, false, _e7301);
                                                                phi_11278_ = _e7301;
                                                                phi_11279_ = false;
                                                            } else {
                                                                phi_11276_ = f32();
                                                                phi_11277_ = false;
                                                                phi_11278_ = false;
                                                                phi_11279_ = true;
                                                            }
                                                            let _e7306 = phi_11276_;
                                                            let _e7308 = phi_11277_;
                                                            let _e7310 = phi_11278_;
                                                            let _e7312 = phi_11279_;
                                                            phi_11280_ = _e7272;
                                                            phi_11212_ = _e7306;
                                                            phi_11281_ = _e7308;
                                                            phi_11282_ = _e7310;
                                                            phi_11283_ = _e7312;
                                                            phi_11284_ = false;
                                                        } else {
                                                            phi_11280_ = f32();
                                                            phi_11212_ = f32();
                                                            phi_11281_ = false;
                                                            phi_11282_ = false;
                                                            phi_11283_ = false;
                                                            phi_11284_ = true;
                                                        }
                                                        let _e7314 = phi_11280_;
                                                        let _e7316 = phi_11212_;
                                                        let _e7318 = phi_11281_;
                                                        let _e7320 = phi_11282_;
                                                        let _e7322 = phi_11283_;
                                                        let _e7324 = phi_11284_;
                                                        local_121 = _e7320;
                                                        local_122 = _e7322;
                                                        local_123 = _e7320;
                                                        local_124 = _e7324;
                                                        local_125 = _e7314;
                                                        continue;
                                                        continuing {
                                                            phi_11208_ = type_9(select(_e7255.member, (_e7255.member + 1u), _e7260), select(_e7255.member_1, _e7255.member_1, _e7260));
                                                            phi_11211_ = _e7316;
                                                            break if !(_e7318);
                                                        }
                                                    }
                                                    let _e7327 = local_121;
                                                    let _e7329 = local_122;
                                                    let _e7332 = local_123;
                                                    let _e7334 = local_124;
                                                    let _e7338 = local_125;
                                                    phi_11298_ = select(_e7338, _e7022, select(select(_e7334, false, _e7332), true, select(_e7329, false, _e7327)));
                                                } else {
                                                    phi_11298_ = _e7022;
                                                }
                                                let _e7341 = phi_11298_;
                                                phi_11300_ = type_45(_e7246, _e7341, _e7092);
                                            } else {
                                                phi_11300_ = _e7105;
                                            }
                                            let _e7344 = phi_11300_;
                                            if (_e7344.member > _e7344.member_1) {
                                                phi_12267_ = bool();
                                                phi_12268_ = true;
                                                phi_12269_ = false;
                                                phi_12270_ = false;
                                                phi_12271_ = false;
                                            } else {
                                                let _e7349 = (_e7344.member > _e6134);
                                                if _e7349 {
                                                    phi_12263_ = bool();
                                                    phi_12264_ = false;
                                                    phi_12265_ = false;
                                                    phi_12266_ = false;
                                                } else {
                                                    let _e7353 = ((_e7344.member_1 - _e7344.member) * 0.5f);
                                                    let _e7354 = (_e7344.member + _e7353);
                                                    let _e7356 = (_e7353 + (0.000000059604645f * 4f));
                                                    let _e7358 = local_7.member_3;
                                                    let _e7361 = local_7.member[0u];
                                                    let _e7367 = select(_e7361[0], -(_e7361[0]), (_e7361[0] < 0f));
                                                    let _e7370 = select(_e7361[1], -(_e7361[1]), (_e7361[1] < 0f));
                                                    let _e7372 = select(_e7370, _e7367, (_e7367 > _e7370));
                                                    let _e7375 = select(_e7361[2], -(_e7361[2]), (_e7361[2] < 0f));
                                                    let _e7377 = select(_e7375, _e7372, (_e7372 > _e7375));
                                                    let _e7379 = local_7.member[1u];
                                                    let _e7385 = select(_e7379[0], -(_e7379[0]), (_e7379[0] < 0f));
                                                    let _e7388 = select(_e7379[1], -(_e7379[1]), (_e7379[1] < 0f));
                                                    let _e7390 = select(_e7388, _e7385, (_e7385 > _e7388));
                                                    let _e7393 = select(_e7379[2], -(_e7379[2]), (_e7379[2] < 0f));
                                                    let _e7395 = select(_e7393, _e7390, (_e7390 > _e7393));
                                                    let _e7400 = local_7.member[0u];
                                                    let _e7405 = local_7.member[1u];
                                                    let _e7415 = (_e7400[0] + ((_e7405[0] - _e7400[0]) * _e7354));
                                                    let _e7416 = (_e7400[1] + ((_e7405[1] - _e7400[1]) * _e7354));
                                                    let _e7417 = (_e7400[2] + ((_e7405[2] - _e7400[2]) * _e7354));
                                                    let _e7419 = local_7.member[1u];
                                                    let _e7424 = local_7.member[0u];
                                                    let _e7428 = (_e7419[0] - _e7424[0]);
                                                    let _e7429 = (_e7419[1] - _e7424[1]);
                                                    let _e7430 = (_e7419[2] - _e7424[2]);
                                                    let _e7433 = select(_e7428, -(_e7428), (_e7428 < 0f));
                                                    let _e7436 = select(_e7429, -(_e7429), (_e7429 < 0f));
                                                    let _e7438 = select(_e7436, _e7433, (_e7433 > _e7436));
                                                    let _e7441 = select(_e7430, -(_e7430), (_e7430 < 0f));
                                                    let _e7449 = ((((_e7356 * select(_e7441, _e7438, (_e7438 > _e7441))) * 1.01f) + ((select(_e7395, _e7377, (_e7377 > _e7395)) + _e7358) * (0.000000059604645f * 8f))) + _e7358);
                                                    let _e7452 = select(_e7415, -(_e7415), (_e7415 < 0f));
                                                    let _e7455 = select(_e7416, -(_e7416), (_e7416 < 0f));
                                                    let _e7457 = select(_e7455, _e7452, (_e7452 > _e7455));
                                                    let _e7460 = select(_e7417, -(_e7417), (_e7417 < 0f));
                                                    let _e7463 = (select(_e7460, _e7457, (_e7457 > _e7460)) + _e7449);
                                                    let _e7466 = local_7.member_3;
                                                    let _e7468 = local_7.member_1[0u];
                                                    let _e7474 = select(_e7468[0], -(_e7468[0]), (_e7468[0] < 0f));
                                                    let _e7477 = select(_e7468[1], -(_e7468[1]), (_e7468[1] < 0f));
                                                    let _e7479 = select(_e7477, _e7474, (_e7474 > _e7477));
                                                    let _e7482 = select(_e7468[2], -(_e7468[2]), (_e7468[2] < 0f));
                                                    let _e7484 = select(_e7482, _e7479, (_e7479 > _e7482));
                                                    let _e7486 = local_7.member_1[1u];
                                                    let _e7492 = select(_e7486[0], -(_e7486[0]), (_e7486[0] < 0f));
                                                    let _e7495 = select(_e7486[1], -(_e7486[1]), (_e7486[1] < 0f));
                                                    let _e7497 = select(_e7495, _e7492, (_e7492 > _e7495));
                                                    let _e7500 = select(_e7486[2], -(_e7486[2]), (_e7486[2] < 0f));
                                                    let _e7502 = select(_e7500, _e7497, (_e7497 > _e7500));
                                                    let _e7507 = local_7.member_1[0u];
                                                    let _e7512 = local_7.member_1[1u];
                                                    let _e7522 = (_e7507[0] + ((_e7512[0] - _e7507[0]) * _e7354));
                                                    let _e7523 = (_e7507[1] + ((_e7512[1] - _e7507[1]) * _e7354));
                                                    let _e7524 = (_e7507[2] + ((_e7512[2] - _e7507[2]) * _e7354));
                                                    let _e7526 = local_7.member_1[1u];
                                                    let _e7531 = local_7.member_1[0u];
                                                    let _e7535 = (_e7526[0] - _e7531[0]);
                                                    let _e7536 = (_e7526[1] - _e7531[1]);
                                                    let _e7537 = (_e7526[2] - _e7531[2]);
                                                    let _e7540 = select(_e7535, -(_e7535), (_e7535 < 0f));
                                                    let _e7543 = select(_e7536, -(_e7536), (_e7536 < 0f));
                                                    let _e7545 = select(_e7543, _e7540, (_e7540 > _e7543));
                                                    let _e7548 = select(_e7537, -(_e7537), (_e7537 < 0f));
                                                    let _e7556 = ((((_e7356 * select(_e7548, _e7545, (_e7545 > _e7548))) * 1.01f) + ((select(_e7502, _e7484, (_e7484 > _e7502)) + _e7466) * (0.000000059604645f * 8f))) + _e7466);
                                                    let _e7559 = select(_e7522, -(_e7522), (_e7522 < 0f));
                                                    let _e7562 = select(_e7523, -(_e7523), (_e7523 < 0f));
                                                    let _e7564 = select(_e7562, _e7559, (_e7559 > _e7562));
                                                    let _e7567 = select(_e7524, -(_e7524), (_e7524 < 0f));
                                                    let _e7570 = (select(_e7567, _e7564, (_e7564 > _e7567)) + _e7556);
                                                    let _e7573 = local_7.member_3;
                                                    let _e7575 = local_7.member_2[0u];
                                                    let _e7581 = select(_e7575[0], -(_e7575[0]), (_e7575[0] < 0f));
                                                    let _e7584 = select(_e7575[1], -(_e7575[1]), (_e7575[1] < 0f));
                                                    let _e7586 = select(_e7584, _e7581, (_e7581 > _e7584));
                                                    let _e7589 = select(_e7575[2], -(_e7575[2]), (_e7575[2] < 0f));
                                                    let _e7591 = select(_e7589, _e7586, (_e7586 > _e7589));
                                                    let _e7593 = local_7.member_2[1u];
                                                    let _e7599 = select(_e7593[0], -(_e7593[0]), (_e7593[0] < 0f));
                                                    let _e7602 = select(_e7593[1], -(_e7593[1]), (_e7593[1] < 0f));
                                                    let _e7604 = select(_e7602, _e7599, (_e7599 > _e7602));
                                                    let _e7607 = select(_e7593[2], -(_e7593[2]), (_e7593[2] < 0f));
                                                    let _e7609 = select(_e7607, _e7604, (_e7604 > _e7607));
                                                    let _e7614 = local_7.member_2[0u];
                                                    let _e7619 = local_7.member_2[1u];
                                                    let _e7629 = (_e7614[0] + ((_e7619[0] - _e7614[0]) * _e7354));
                                                    let _e7630 = (_e7614[1] + ((_e7619[1] - _e7614[1]) * _e7354));
                                                    let _e7631 = (_e7614[2] + ((_e7619[2] - _e7614[2]) * _e7354));
                                                    let _e7633 = local_7.member_2[1u];
                                                    let _e7638 = local_7.member_2[0u];
                                                    let _e7642 = (_e7633[0] - _e7638[0]);
                                                    let _e7643 = (_e7633[1] - _e7638[1]);
                                                    let _e7644 = (_e7633[2] - _e7638[2]);
                                                    let _e7647 = select(_e7642, -(_e7642), (_e7642 < 0f));
                                                    let _e7650 = select(_e7643, -(_e7643), (_e7643 < 0f));
                                                    let _e7652 = select(_e7650, _e7647, (_e7647 > _e7650));
                                                    let _e7655 = select(_e7644, -(_e7644), (_e7644 < 0f));
                                                    let _e7663 = ((((_e7356 * select(_e7655, _e7652, (_e7652 > _e7655))) * 1.01f) + ((select(_e7609, _e7591, (_e7591 > _e7609)) + _e7573) * (0.000000059604645f * 8f))) + _e7573);
                                                    let _e7666 = select(_e7629, -(_e7629), (_e7629 < 0f));
                                                    let _e7669 = select(_e7630, -(_e7630), (_e7630 < 0f));
                                                    let _e7671 = select(_e7669, _e7666, (_e7666 > _e7669));
                                                    let _e7674 = select(_e7631, -(_e7631), (_e7631 < 0f));
                                                    let _e7677 = (select(_e7674, _e7671, (_e7671 > _e7674)) + _e7663);
                                                    let _e7680 = ((_e7523 * _e7631) - (_e7524 * _e7630));
                                                    let _e7683 = ((_e7524 * _e7629) - (_e7522 * _e7631));
                                                    let _e7686 = ((_e7522 * _e7630) - (_e7523 * _e7629));
                                                    let _e7701 = select(false, (select(_e7680, -(_e7680), (_e7680 < 0f)) > select(_e7686, -(_e7686), (_e7686 < 0f))), (select(_e7680, -(_e7680), (_e7680 < 0f)) > select(_e7683, -(_e7683), (_e7683 < 0f))));
                                                    let _e7716 = select((select(_e7683, -(_e7683), (_e7683 < 0f)) > select(_e7686, -(_e7686), (_e7686 < 0f))), false, (select(_e7680, -(_e7680), (_e7680 < 0f)) > select(_e7683, -(_e7683), (_e7683 < 0f))));
                                                    let _e7719 = select(select(_e7415, _e7416, _e7701), _e7417, _e7716);
                                                    let _e7720 = select(select(_e7416, _e7417, _e7701), _e7415, _e7716);
                                                    let _e7723 = select(select(_e7522, _e7523, _e7701), _e7524, _e7716);
                                                    let _e7724 = select(select(_e7523, _e7524, _e7701), _e7522, _e7716);
                                                    let _e7727 = select(select(_e7629, _e7630, _e7701), _e7631, _e7716);
                                                    let _e7728 = select(select(_e7630, _e7631, _e7701), _e7629, _e7716);
                                                    let _e7731 = ((_e7723 * _e7728) - (_e7724 * _e7727));
                                                    let _e7747 = (((((_e7556 * _e7677) + (_e7570 * _e7663)) * 2.01f) + (((_e7570 * 2f) * (_e7677 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e7570) * (1f + _e7677))));
                                                    if (select(_e7731, -(_e7731), (_e7731 < 0f)) > _e7747) {
                                                        let _e7753 = select(1f, -1f, (_e7731 < 0f));
                                                        let _e7772 = (((((_e7449 * _e7677) + (_e7463 * _e7663)) * 2.01f) + (((_e7463 * 2f) * (_e7677 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e7463) * (1f + _e7677))));
                                                        let _e7791 = (((((_e7556 * _e7463) + (_e7570 * _e7449)) * 2.01f) + (((_e7570 * 2f) * (_e7463 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e7570) * (1f + _e7463))));
                                                        let _e7792 = (_e7731 * _e7753);
                                                        let _e7793 = (((_e7719 * _e7728) - (_e7720 * _e7727)) * _e7753);
                                                        let _e7794 = (((_e7723 * _e7720) - (_e7724 * _e7719)) * _e7753);
                                                        let _e7807 = (((select(_e7792, -(_e7792), (_e7792 < 0f)) + select(_e7793, -(_e7793), (_e7793 < 0f))) + select(_e7794, -(_e7794), (_e7794 < 0f))) * (0.000000059604645f * 4f));
                                                        if (_e284.member != 0u) {
                                                            phi_12137_ = array<type_16, 4>(type_16(_e7793, _e7772), type_16(_e7794, _e7791), type_16((_e7792 - _e7793), ((_e7747 + _e7772) + _e7807)), type_16((_e7792 - _e7794), ((_e7747 + _e7791) + _e7807)));
                                                        } else {
                                                            let _e7810 = ((_e7792 - _e7793) - _e7794);
                                                            let _e7813 = (((_e7747 + _e7772) + _e7791) + _e7807);
                                                            phi_12137_ = array<type_16, 4>(type_16(_e7793, _e7772), type_16(_e7794, _e7791), type_16(_e7810, _e7813), type_16(_e7810, _e7813));
                                                        }
                                                        let _e7831 = phi_12137_;
                                                        local_2 = array<type_16, 4>(type_16(_e7831[0].member, _e7831[0].member_1), type_16(_e7831[1].member, _e7831[1].member_1), type_16(_e7831[2].member, _e7831[2].member_1), type_16(_e7831[3].member, _e7831[3].member_1));
                                                        phi_12157_ = type_9(0u, 4u);
                                                        phi_12160_ = true;
                                                        loop {
                                                            let _e7850 = phi_12157_;
                                                            let _e7852 = phi_12160_;
                                                            local_127 = _e7852;
                                                            let _e7855 = (_e7850.member < _e7850.member_1);
                                                            let _e7866 = select(type_9().member_1, _e7850.member, _e7855);
                                                            if (bitcast<i32>(select(0u, 1u, _e7855)) != 0i) {
                                                                let _e7871 = local_2[_e7866].member;
                                                                let _e7874 = local_2[_e7866].member_1;
                                                                let _e7876 = (_e7871 < -(_e7874));
                                                                phi_12161_ = select((_e7852 && (_e7871 > _e7874)), bool(), _e7876);
                                                                phi_12212_ = select(true, false, _e7876);
                                                                phi_12213_ = _e7876;
                                                            } else {
                                                                phi_12161_ = bool();
                                                                phi_12212_ = false;
                                                                phi_12213_ = false;
                                                            }
                                                            let _e7882 = phi_12161_;
                                                            let _e7884 = phi_12212_;
                                                            let _e7886 = phi_12213_;
                                                            local_126 = _e7886;
                                                            continue;
                                                            continuing {
                                                                phi_12157_ = type_9(select(_e7850.member, (_e7850.member + 1u), _e7855), select(_e7850.member_1, _e7850.member_1, _e7855));
                                                                phi_12160_ = _e7882;
                                                                break if !(_e7884);
                                                            }
                                                        }
                                                        let _e7889 = local_126;
                                                        let _e7890 = select(true, false, _e7889);
                                                        let _e7892 = local_127;
                                                        phi_12227_ = select(u32(), select(2u, 1u, _e7892), _e7890);
                                                        phi_12228_ = 0u;
                                                        phi_12229_ = select(true, false, _e7890);
                                                    } else {
                                                        phi_12227_ = u32();
                                                        phi_12228_ = 2u;
                                                        phi_12229_ = true;
                                                    }
                                                    let _e7897 = phi_12227_;
                                                    let _e7899 = phi_12228_;
                                                    let _e7901 = phi_12229_;
                                                    let _e7902 = select(_e7897, _e7899, _e7901);
                                                    let _e7903 = (_e7902 == 0u);
                                                    if _e7903 {
                                                        phi_12260_ = bool();
                                                        phi_12261_ = false;
                                                        phi_12262_ = false;
                                                    } else {
                                                        let _e7906 = select(false, _e7344.member_2, (_e7902 == 1u));
                                                        let _e7912 = select(true, select(true, false, ((_e7344.member_1 - _e7344.member) <= _e6959)), _e7906);
                                                        phi_12260_ = _e7906;
                                                        phi_12261_ = _e7912;
                                                        phi_12262_ = select(true, false, _e7912);
                                                    }
                                                    let _e7915 = phi_12260_;
                                                    let _e7917 = phi_12261_;
                                                    let _e7919 = phi_12262_;
                                                    phi_12263_ = _e7915;
                                                    phi_12264_ = _e7903;
                                                    phi_12265_ = _e7917;
                                                    phi_12266_ = _e7919;
                                                }
                                                let _e7921 = phi_12263_;
                                                let _e7923 = phi_12264_;
                                                let _e7925 = phi_12265_;
                                                let _e7927 = phi_12266_;
                                                phi_12267_ = _e7921;
                                                phi_12268_ = _e7923;
                                                phi_12269_ = _e7925;
                                                phi_12270_ = _e7349;
                                                phi_12271_ = _e7927;
                                            }
                                            let _e7929 = phi_12267_;
                                            let _e7931 = phi_12268_;
                                            let _e7933 = phi_12269_;
                                            let _e7935 = phi_12270_;
                                            let _e7937 = phi_12271_;
                                            phi_12272_ = _e7344;
                                            phi_12273_ = _e7929;
                                            phi_12274_ = _e7344;
                                            phi_12275_ = _e7931;
                                            phi_12276_ = _e7933;
                                            phi_12277_ = _e7935;
                                            phi_12278_ = _e7937;
                                        }
                                        let _e7939 = phi_12272_;
                                        let _e7941 = phi_12273_;
                                        let _e7943 = phi_12274_;
                                        let _e7945 = phi_12275_;
                                        let _e7947 = phi_12276_;
                                        let _e7949 = phi_12277_;
                                        let _e7951 = phi_12278_;
                                        phi_12279_ = _e7939;
                                        phi_12280_ = _e7941;
                                        phi_12281_ = _e7943;
                                        phi_12282_ = _e7945;
                                        phi_12283_ = _e7947;
                                        phi_12284_ = _e7024;
                                        phi_12285_ = _e7949;
                                        phi_12286_ = _e7951;
                                    } else {
                                        phi_12279_ = type_45();
                                        phi_12280_ = bool();
                                        phi_12281_ = type_45();
                                        phi_12282_ = true;
                                        phi_12283_ = false;
                                        phi_12284_ = false;
                                        phi_12285_ = false;
                                        phi_12286_ = false;
                                    }
                                    let _e7953 = phi_12279_;
                                    let _e7955 = phi_12280_;
                                    let _e7957 = phi_12281_;
                                    let _e7959 = phi_12282_;
                                    let _e7961 = phi_12283_;
                                    let _e7963 = phi_12284_;
                                    let _e7965 = phi_12285_;
                                    let _e7967 = phi_12286_;
                                    phi_12294_ = _e7953;
                                    phi_12295_ = _e7955;
                                    phi_12296_ = _e7957;
                                    phi_12297_ = select(_e7961, false, _e7959);
                                    phi_12298_ = _e7959;
                                    phi_12299_ = select(_e7963, false, _e7959);
                                    phi_12300_ = select(_e7965, false, _e7959);
                                    phi_12301_ = select(_e7967, false, _e7959);
                                } else {
                                    phi_12294_ = type_45(_e6130, _e6130, false);
                                    phi_12295_ = false;
                                    phi_12296_ = type_45();
                                    phi_12297_ = true;
                                    phi_12298_ = false;
                                    phi_12299_ = false;
                                    phi_12300_ = false;
                                    phi_12301_ = false;
                                }
                                let _e7973 = phi_12294_;
                                let _e7975 = phi_12295_;
                                let _e7977 = phi_12296_;
                                let _e7979 = phi_12297_;
                                let _e7981 = phi_12298_;
                                let _e7983 = phi_12299_;
                                let _e7985 = phi_12300_;
                                let _e7987 = phi_12301_;
                                if _e7979 {
                                    let _e7992 = local_7.member[0u];
                                    let _e7998 = local_7.member_1[0u];
                                    let _e8004 = local_7.member_2[0u];
                                    let _e8008 = (_e7992[0] - _e7998[0]);
                                    let _e8009 = (_e7992[1] - _e7998[1]);
                                    let _e8010 = (_e7992[2] - _e7998[2]);
                                    let _e8011 = (_e284.member == 0u);
                                    let _e8023 = local_7.member[1u];
                                    let _e8029 = local_7.member_1[1u];
                                    let _e8035 = local_7.member_2[1u];
                                    let _e8039 = (_e8023[0] - _e8029[0]);
                                    let _e8040 = (_e8023[1] - _e8029[1]);
                                    let _e8041 = (_e8023[2] - _e8029[2]);
                                    let _e8042 = (_e284.member == 0u);
                                    let _e8054 = local_7.member[0u];
                                    let _e8060 = select(_e8054[0], -(_e8054[0]), (_e8054[0] < 0f));
                                    let _e8063 = select(_e8054[1], -(_e8054[1]), (_e8054[1] < 0f));
                                    let _e8065 = select(_e8063, _e8060, (_e8060 > _e8063));
                                    let _e8068 = select(_e8054[2], -(_e8054[2]), (_e8054[2] < 0f));
                                    let _e8070 = select(_e8068, _e8065, (_e8065 > _e8068));
                                    let _e8073 = local_7.member[1u];
                                    let _e8079 = select(_e8073[0], -(_e8073[0]), (_e8073[0] < 0f));
                                    let _e8082 = select(_e8073[1], -(_e8073[1]), (_e8073[1] < 0f));
                                    let _e8084 = select(_e8082, _e8079, (_e8079 > _e8082));
                                    let _e8087 = select(_e8073[2], -(_e8073[2]), (_e8073[2] < 0f));
                                    let _e8089 = select(_e8087, _e8084, (_e8084 > _e8087));
                                    let _e8093 = local_7.member_3;
                                    let _e8097 = local_7.member_1[0u];
                                    let _e8103 = select(_e8097[0], -(_e8097[0]), (_e8097[0] < 0f));
                                    let _e8106 = select(_e8097[1], -(_e8097[1]), (_e8097[1] < 0f));
                                    let _e8108 = select(_e8106, _e8103, (_e8103 > _e8106));
                                    let _e8111 = select(_e8097[2], -(_e8097[2]), (_e8097[2] < 0f));
                                    let _e8113 = select(_e8111, _e8108, (_e8108 > _e8111));
                                    let _e8116 = local_7.member_1[1u];
                                    let _e8122 = select(_e8116[0], -(_e8116[0]), (_e8116[0] < 0f));
                                    let _e8125 = select(_e8116[1], -(_e8116[1]), (_e8116[1] < 0f));
                                    let _e8127 = select(_e8125, _e8122, (_e8122 > _e8125));
                                    let _e8130 = select(_e8116[2], -(_e8116[2]), (_e8116[2] < 0f));
                                    let _e8132 = select(_e8130, _e8127, (_e8127 > _e8130));
                                    let _e8136 = local_7.member_3;
                                    let _e8140 = local_7.member_2[0u];
                                    let _e8146 = select(_e8140[0], -(_e8140[0]), (_e8140[0] < 0f));
                                    let _e8149 = select(_e8140[1], -(_e8140[1]), (_e8140[1] < 0f));
                                    let _e8151 = select(_e8149, _e8146, (_e8146 > _e8149));
                                    let _e8154 = select(_e8140[2], -(_e8140[2]), (_e8140[2] < 0f));
                                    let _e8156 = select(_e8154, _e8151, (_e8151 > _e8154));
                                    let _e8159 = local_7.member_2[1u];
                                    let _e8165 = select(_e8159[0], -(_e8159[0]), (_e8159[0] < 0f));
                                    let _e8168 = select(_e8159[1], -(_e8159[1]), (_e8159[1] < 0f));
                                    let _e8170 = select(_e8168, _e8165, (_e8165 > _e8168));
                                    let _e8173 = select(_e8159[2], -(_e8159[2]), (_e8159[2] < 0f));
                                    let _e8175 = select(_e8173, _e8170, (_e8170 > _e8173));
                                    let _e8179 = local_7.member_3;
                                    let _e8186 = local_7.member_3;
                                    let _e8191 = (_e6128 * 0.00390625f);
                                    local = type_28(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    phi_12724_ = type_9(0u, 96u);
                                    phi_12727_ = _e7973.member;
                                    phi_12729_ = _e7973.member;
                                    phi_12731_ = (_e7973.member_1 - _e7973.member);
                                    phi_12733_ = _e7973.member;
                                    phi_12735_ = false;
                                    phi_12737_ = 0u;
                                    loop {
                                        let _e8194 = phi_12724_;
                                        let _e8196 = phi_12727_;
                                        let _e8198 = phi_12729_;
                                        let _e8200 = phi_12731_;
                                        let _e8202 = phi_12733_;
                                        let _e8204 = phi_12735_;
                                        let _e8206 = phi_12737_;
                                        local_137 = _e8196;
                                        local_140 = _e8198;
                                        let _e8209 = (_e8194.member < _e8194.member_1);
                                        if (bitcast<i32>(select(0u, 1u, _e8209)) != 0i) {
                                            let _e8223 = local_7.member[0u];
                                            let _e8229 = local_7.member[1u];
                                            let _e8245 = local_7.member_1[0u];
                                            let _e8251 = local_7.member_1[1u];
                                            let _e8267 = local_7.member_2[0u];
                                            let _e8273 = local_7.member_2[1u];
                                            let _e8287 = function_3(array<f32, 3>((_e8223[0] + ((_e8229[0] - _e8223[0]) * _e8196)), (_e8223[1] + ((_e8229[1] - _e8223[1]) * _e8196)), (_e8223[2] + ((_e8229[2] - _e8223[2]) * _e8196))), array<f32, 3>((_e8245[0] + ((_e8251[0] - _e8245[0]) * _e8196)), (_e8245[1] + ((_e8251[1] - _e8245[1]) * _e8196)), (_e8245[2] + ((_e8251[2] - _e8245[2]) * _e8196))), array<f32, 3>((_e8267[0] + ((_e8273[0] - _e8267[0]) * _e8196)), (_e8267[1] + ((_e8273[1] - _e8267[1]) * _e8196)), (_e8267[2] + ((_e8273[2] - _e8267[2]) * _e8196))), _e284.member);
                                            if (_e8206 == 0u) {
                                                phi_12888_ = _e8287;
                                            } else {
                                                phi_12888_ = array<f32, 3>(select(0f, _e8287[0], (_e8206 == 1u)), select(0f, _e8287[1], (_e8206 == 2u)), select(0f, _e8287[2], (_e8206 == 3u)));
                                            }
                                            let _e8300 = phi_12888_;
                                            let _e8314 = ((select(_e8300[0], -(_e8300[0]), (_e8300[0] < 0f)) + select(_e8300[1], -(_e8300[1]), (_e8300[1] < 0f))) + select(_e8300[2], -(_e8300[2]), (_e8300[2] < 0f)));
                                            if (_e8314 > 0f) {
                                                if ((bitcast<u32>(_e8314) & 2139095040u) != 2139095040u) {
                                                    let _e8319 = (1f / _e8314);
                                                    let _e8321 = (_e8300[0] * _e8319);
                                                    let _e8323 = (_e8300[1] * _e8319);
                                                    let _e8325 = (_e8300[2] * _e8319);
                                                    let _e8330 = (((_e8321 * _e8321) + (_e8323 * _e8323)) + (_e8325 * _e8325));
                                                    if (_e8330 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_13011_ = select(0f, (0.000000000000000000106433627f * 2f), (_e8330 > 0f));
                                                    } else {
                                                        phi_12954_ = type_14(0i, 5i);
                                                        phi_12957_ = bitcast<f32>(((bitcast<u32>(_e8330) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e8338 = phi_12954_;
                                                            let _e8340 = phi_12957_;
                                                            local_128 = _e8340;
                                                            if (_e8338.member < _e8338.member_1) {
                                                                let _e8347 = (_e8338.member + 1i);
                                                                phi_12955_ = type_14(select(_e8347, type_15().member_1, select(false, true, ((false == (_e8347 > _e8338.member)) != false))), _e8338.member_1);
                                                                phi_12998_ = type_15(1u, _e8338.member);
                                                            } else {
                                                                phi_12955_ = _e8338;
                                                                phi_12998_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e8358 = phi_12955_;
                                                            let _e8360 = phi_12998_;
                                                            let _e8363 = (bitcast<i32>(_e8360.member) != 0i);
                                                            if _e8363 {
                                                                phi_12958_ = (0.5f * (_e8340 + (_e8330 / _e8340)));
                                                            } else {
                                                                phi_12958_ = f32();
                                                            }
                                                            let _e8368 = phi_12958_;
                                                            continue;
                                                            continuing {
                                                                phi_12954_ = _e8358;
                                                                phi_12957_ = _e8368;
                                                                break if !(_e8363);
                                                            }
                                                        }
                                                        let _e8373 = local_128;
                                                        phi_13011_ = (_e8373 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e8379 = phi_13011_;
                                                    let _e8380 = (0.000000059604645f * 12f);
                                                    let _e8385 = ((((((((select(_e8089, _e8070, (_e8070 > _e8089)) + _e8093) + (select(_e8132, _e8113, (_e8113 > _e8132)) + _e8136)) + (select(_e8175, _e8156, (_e8156 > _e8175)) + _e8179)) * (0.000000059604645f * 16f)) + (_e8186 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e8379) * (1f + _e8380)));
                                                    let _e8390 = (((_e8321 * _e7992[0]) + (_e8323 * _e7992[1])) + (_e8325 * _e7992[2]));
                                                    let _e8395 = (((_e8321 * _e8008) + (_e8323 * _e8009)) + (_e8325 * _e8010));
                                                    let _e8400 = (((_e8321 * (_e7992[0] - _e8004[0])) + (_e8323 * (_e7992[1] - _e8004[1]))) + (_e8325 * (_e7992[2] - _e8004[2])));
                                                    let _e8405 = (((_e8321 * select((_e8008 - _e8004[0]), _e7992[0], _e8011)) + (_e8323 * select((_e8009 - _e8004[1]), _e7992[1], _e8011))) + (_e8325 * select((_e8010 - _e8004[2]), _e7992[2], _e8011)));
                                                    let _e8411 = (((_e8321 * _e8023[0]) + (_e8323 * _e8023[1])) + (_e8325 * _e8023[2]));
                                                    let _e8416 = (((_e8321 * _e8039) + (_e8323 * _e8040)) + (_e8325 * _e8041));
                                                    let _e8421 = (((_e8321 * (_e8023[0] - _e8035[0])) + (_e8323 * (_e8023[1] - _e8035[1]))) + (_e8325 * (_e8023[2] - _e8035[2])));
                                                    let _e8426 = (((_e8321 * select((_e8039 - _e8035[0]), _e8023[0], _e8042)) + (_e8323 * select((_e8040 - _e8035[1]), _e8023[1], _e8042))) + (_e8325 * select((_e8041 - _e8035[2]), _e8023[2], _e8042)));
                                                    phi_13134_ = type_28(array<f32, 4>(_e8390, _e8395, _e8400, _e8405), array<f32, 4>(_e8411, _e8416, _e8421, _e8426), array<f32, 4>((_e8385 + ((select(_e8390, -(_e8390), (_e8390 < 0f)) + select(_e8411, -(_e8411), (_e8411 < 0f))) * _e8380)), (_e8385 + ((select(_e8395, -(_e8395), (_e8395 < 0f)) + select(_e8416, -(_e8416), (_e8416 < 0f))) * _e8380)), (_e8385 + ((select(_e8400, -(_e8400), (_e8400 < 0f)) + select(_e8421, -(_e8421), (_e8421 < 0f))) * _e8380)), (_e8385 + ((select(_e8405, -(_e8405), (_e8405 < 0f)) + select(_e8426, -(_e8426), (_e8426 < 0f))) * _e8380))));
                                                    phi_13135_ = false;
                                                } else {
                                                    phi_13134_ = type_28();
                                                    phi_13135_ = true;
                                                }
                                                let _e8467 = phi_13134_;
                                                let _e8469 = phi_13135_;
                                                phi_13136_ = _e8467;
                                                phi_13137_ = _e8469;
                                            } else {
                                                phi_13136_ = type_28();
                                                phi_13137_ = true;
                                            }
                                            let _e8471 = phi_13136_;
                                            let _e8473 = phi_13137_;
                                            if _e8473 {
                                                phi_13145_ = type_28(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            } else {
                                                phi_13145_ = _e8471;
                                            }
                                            let _e8475 = phi_13145_;
                                            local_1 = type_28(array<f32, 4>(_e8475.member[0], _e8475.member[1], _e8475.member[2], _e8475.member[3]), array<f32, 4>(_e8475.member_1[0], _e8475.member_1[1], _e8475.member_1[2], _e8475.member_1[3]), array<f32, 4>(_e8475.member_2[0], _e8475.member_2[1], _e8475.member_2[2], _e8475.member_2[3]));
                                            let _e8495 = (_e8196 - _e8202);
                                            let _e8499 = local_1.member[0u];
                                            let _e8502 = local_1.member_1[0u];
                                            let _e8505 = local_1.member[0u];
                                            let _e8511 = local_1.member_2[0u];
                                            if (((_e8499 + ((_e8502 - _e8505) * _e8196)) - _e8511) > 0f) {
                                                let _e8516 = local_1.member[1u];
                                                let _e8519 = local_1.member_1[1u];
                                                let _e8522 = local_1.member[1u];
                                                let _e8528 = local_1.member_2[1u];
                                                if (((_e8516 + ((_e8519 - _e8522) * _e8196)) - _e8528) > 0f) {
                                                    let _e8533 = local_1.member[2u];
                                                    let _e8536 = local_1.member_1[2u];
                                                    let _e8539 = local_1.member[2u];
                                                    let _e8545 = local_1.member_2[2u];
                                                    if (((_e8533 + ((_e8536 - _e8539) * _e8196)) - _e8545) > 0f) {
                                                        let _e8550 = local_1.member[3u];
                                                        let _e8553 = local_1.member_1[3u];
                                                        let _e8556 = local_1.member[3u];
                                                        let _e8562 = local_1.member_2[3u];
                                                        phi_13316_ = (((_e8550 + ((_e8553 - _e8556) * _e8196)) - _e8562) > 0f);
                                                        phi_13317_ = false;
                                                    } else {
                                                        phi_13316_ = bool();
                                                        phi_13317_ = true;
                                                    }
                                                    let _e8566 = phi_13316_;
                                                    let _e8568 = phi_13317_;
                                                    phi_13318_ = _e8566;
                                                    phi_13319_ = _e8568;
                                                } else {
                                                    phi_13318_ = bool();
                                                    phi_13319_ = true;
                                                }
                                                let _e8570 = phi_13318_;
                                                let _e8572 = phi_13319_;
                                                phi_13320_ = _e8570;
                                                phi_13321_ = _e8572;
                                            } else {
                                                phi_13320_ = bool();
                                                phi_13321_ = true;
                                            }
                                            let _e8574 = phi_13320_;
                                            let _e8576 = phi_13321_;
                                            if select(_e8574, false, _e8576) {
                                                if (_e8196 <= _e8198) {
                                                    phi_13635_ = true;
                                                } else {
                                                    let _e8581 = local.member[0u];
                                                    let _e8584 = local.member_1[0u];
                                                    let _e8587 = local.member[0u];
                                                    let _e8593 = local.member_2[0u];
                                                    let _e8597 = local_1.member[0u];
                                                    let _e8600 = local_1.member_1[0u];
                                                    let _e8603 = local_1.member[0u];
                                                    let _e8609 = local_1.member_2[0u];
                                                    if ((((_e8581 + ((_e8584 - _e8587) * _e8196)) - _e8593) + ((_e8597 + ((_e8600 - _e8603) * _e8202)) - _e8609)) > 0f) {
                                                        let _e8615 = local.member[1u];
                                                        let _e8618 = local.member_1[1u];
                                                        let _e8621 = local.member[1u];
                                                        let _e8627 = local.member_2[1u];
                                                        let _e8631 = local_1.member[1u];
                                                        let _e8634 = local_1.member_1[1u];
                                                        let _e8637 = local_1.member[1u];
                                                        let _e8643 = local_1.member_2[1u];
                                                        if ((((_e8615 + ((_e8618 - _e8621) * _e8196)) - _e8627) + ((_e8631 + ((_e8634 - _e8637) * _e8202)) - _e8643)) > 0f) {
                                                            let _e8649 = local.member[2u];
                                                            let _e8652 = local.member_1[2u];
                                                            let _e8655 = local.member[2u];
                                                            let _e8661 = local.member_2[2u];
                                                            let _e8665 = local_1.member[2u];
                                                            let _e8668 = local_1.member_1[2u];
                                                            let _e8671 = local_1.member[2u];
                                                            let _e8677 = local_1.member_2[2u];
                                                            if ((((_e8649 + ((_e8652 - _e8655) * _e8196)) - _e8661) + ((_e8665 + ((_e8668 - _e8671) * _e8202)) - _e8677)) > 0f) {
                                                                let _e8683 = local.member[3u];
                                                                let _e8686 = local.member_1[3u];
                                                                let _e8689 = local.member[3u];
                                                                let _e8695 = local.member_2[3u];
                                                                let _e8699 = local_1.member[3u];
                                                                let _e8702 = local_1.member_1[3u];
                                                                let _e8705 = local_1.member[3u];
                                                                let _e8711 = local_1.member_2[3u];
                                                                phi_13622_ = ((((_e8683 + ((_e8686 - _e8689) * _e8196)) - _e8695) + ((_e8699 + ((_e8702 - _e8705) * _e8202)) - _e8711)) > 0f);
                                                                phi_13623_ = false;
                                                            } else {
                                                                phi_13622_ = bool();
                                                                phi_13623_ = true;
                                                            }
                                                            let _e8716 = phi_13622_;
                                                            let _e8718 = phi_13623_;
                                                            phi_13624_ = _e8716;
                                                            phi_13625_ = _e8718;
                                                        } else {
                                                            phi_13624_ = bool();
                                                            phi_13625_ = true;
                                                        }
                                                        let _e8720 = phi_13624_;
                                                        let _e8722 = phi_13625_;
                                                        phi_13626_ = _e8720;
                                                        phi_13627_ = _e8722;
                                                    } else {
                                                        phi_13626_ = bool();
                                                        phi_13627_ = true;
                                                    }
                                                    let _e8724 = phi_13626_;
                                                    let _e8726 = phi_13627_;
                                                    phi_13635_ = select(_e8724, false, _e8726);
                                                }
                                                let _e8729 = phi_13635_;
                                                if _e8729 {
                                                    if select(true, select(true, false, (_e8196 >= _e7973.member_1)), _e8204) {
                                                        local = type_28(array<f32, 4>(_e8475.member[0], _e8475.member[1], _e8475.member[2], _e8475.member[3]), array<f32, 4>(_e8475.member_1[0], _e8475.member_1[1], _e8475.member_1[2], _e8475.member_1[3]), array<f32, 4>(_e8475.member_2[0], _e8475.member_2[1], _e8475.member_2[2], _e8475.member_2[3]));
                                                        let _e8754 = local.member[0u];
                                                        let _e8757 = local.member_1[0u];
                                                        let _e8760 = local.member_2[0u];
                                                        if select(true, select(true, false, (_e8757 > _e8760)), (_e8754 > _e8760)) {
                                                            let _e8765 = (_e8757 >= _e8754);
                                                            if _e8765 {
                                                                phi_13744_ = f32();
                                                                phi_13745_ = false;
                                                            } else {
                                                                if ((_e8754 - _e8757) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_13742_ = (((_e8754 - _e8760) / (_e8754 - _e8757)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_13743_ = false;
                                                                } else {
                                                                    phi_13742_ = f32();
                                                                    phi_13743_ = true;
                                                                }
                                                                let _e8776 = phi_13742_;
                                                                let _e8778 = phi_13743_;
                                                                phi_13744_ = _e8776;
                                                                phi_13745_ = _e8778;
                                                            }
                                                            let _e8780 = phi_13744_;
                                                            let _e8782 = phi_13745_;
                                                            phi_13746_ = _e8780;
                                                            phi_13747_ = _e8765;
                                                            phi_13748_ = _e8782;
                                                        } else {
                                                            phi_13746_ = f32();
                                                            phi_13747_ = true;
                                                            phi_13748_ = false;
                                                        }
                                                        let _e8784 = phi_13746_;
                                                        let _e8786 = phi_13747_;
                                                        let _e8788 = phi_13748_;
                                                        let _e8791 = select(_e8784, select(_e8196, 2f, _e8786), select(_e8788, true, _e8786));
                                                        let _e8794 = local.member[1u];
                                                        let _e8797 = local.member_1[1u];
                                                        let _e8800 = local.member_2[1u];
                                                        if select(true, select(true, false, (_e8797 > _e8800)), (_e8794 > _e8800)) {
                                                            let _e8805 = (_e8797 >= _e8794);
                                                            if _e8805 {
                                                                phi_13812_ = f32();
                                                                phi_13813_ = false;
                                                            } else {
                                                                if ((_e8794 - _e8797) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_13810_ = (((_e8794 - _e8800) / (_e8794 - _e8797)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_13811_ = false;
                                                                } else {
                                                                    phi_13810_ = f32();
                                                                    phi_13811_ = true;
                                                                }
                                                                let _e8816 = phi_13810_;
                                                                let _e8818 = phi_13811_;
                                                                phi_13812_ = _e8816;
                                                                phi_13813_ = _e8818;
                                                            }
                                                            let _e8820 = phi_13812_;
                                                            let _e8822 = phi_13813_;
                                                            phi_13814_ = _e8820;
                                                            phi_13815_ = _e8805;
                                                            phi_13816_ = _e8822;
                                                        } else {
                                                            phi_13814_ = f32();
                                                            phi_13815_ = true;
                                                            phi_13816_ = false;
                                                        }
                                                        let _e8824 = phi_13814_;
                                                        let _e8826 = phi_13815_;
                                                        let _e8828 = phi_13816_;
                                                        let _e8831 = select(_e8824, select(_e8196, 2f, _e8826), select(_e8828, true, _e8826));
                                                        let _e8833 = select(_e8831, _e8791, (_e8791 < _e8831));
                                                        let _e8836 = local.member[2u];
                                                        let _e8839 = local.member_1[2u];
                                                        let _e8842 = local.member_2[2u];
                                                        if select(true, select(true, false, (_e8839 > _e8842)), (_e8836 > _e8842)) {
                                                            let _e8847 = (_e8839 >= _e8836);
                                                            if _e8847 {
                                                                phi_13885_ = f32();
                                                                phi_13886_ = false;
                                                            } else {
                                                                if ((_e8836 - _e8839) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_13883_ = (((_e8836 - _e8842) / (_e8836 - _e8839)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_13884_ = false;
                                                                } else {
                                                                    phi_13883_ = f32();
                                                                    phi_13884_ = true;
                                                                }
                                                                let _e8858 = phi_13883_;
                                                                let _e8860 = phi_13884_;
                                                                phi_13885_ = _e8858;
                                                                phi_13886_ = _e8860;
                                                            }
                                                            let _e8862 = phi_13885_;
                                                            let _e8864 = phi_13886_;
                                                            phi_13887_ = _e8862;
                                                            phi_13888_ = _e8847;
                                                            phi_13889_ = _e8864;
                                                        } else {
                                                            phi_13887_ = f32();
                                                            phi_13888_ = true;
                                                            phi_13889_ = false;
                                                        }
                                                        let _e8866 = phi_13887_;
                                                        let _e8868 = phi_13888_;
                                                        let _e8870 = phi_13889_;
                                                        let _e8873 = select(_e8866, select(_e8196, 2f, _e8868), select(_e8870, true, _e8868));
                                                        let _e8876 = local.member[3u];
                                                        let _e8879 = local.member_1[3u];
                                                        let _e8882 = local.member_2[3u];
                                                        if select(true, select(true, false, (_e8879 > _e8882)), (_e8876 > _e8882)) {
                                                            let _e8887 = (_e8879 >= _e8876);
                                                            if _e8887 {
                                                                phi_13953_ = f32();
                                                                phi_13954_ = false;
                                                            } else {
                                                                if ((_e8876 - _e8879) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_13951_ = (((_e8876 - _e8882) / (_e8876 - _e8879)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_13952_ = false;
                                                                } else {
                                                                    phi_13951_ = f32();
                                                                    phi_13952_ = true;
                                                                }
                                                                let _e8898 = phi_13951_;
                                                                let _e8900 = phi_13952_;
                                                                phi_13953_ = _e8898;
                                                                phi_13954_ = _e8900;
                                                            }
                                                            let _e8902 = phi_13953_;
                                                            let _e8904 = phi_13954_;
                                                            phi_13955_ = _e8902;
                                                            phi_13956_ = _e8887;
                                                            phi_13957_ = _e8904;
                                                        } else {
                                                            phi_13955_ = f32();
                                                            phi_13956_ = true;
                                                            phi_13957_ = false;
                                                        }
                                                        let _e8906 = phi_13955_;
                                                        let _e8908 = phi_13956_;
                                                        let _e8910 = phi_13957_;
                                                        let _e8913 = select(_e8906, select(_e8196, 2f, _e8908), select(_e8910, true, _e8908));
                                                        let _e8915 = select(_e8913, _e8873, (_e8873 < _e8913));
                                                        let _e8917 = select(_e8915, _e8833, (_e8833 < _e8915));
                                                        let _e8919 = select(_e8196, _e8917, (_e8917 > _e8196));
                                                        let _e8920 = (_e8919 > _e7973.member_1);
                                                        if _e8920 {
                                                            phi_14486_ = f32();
                                                            phi_14487_ = f32();
                                                            phi_14488_ = false;
                                                        } else {
                                                            let _e8921 = (_e8919 - _e8196);
                                                            phi_14486_ = select((_e7973.member_1 - _e8196), select(0f, (_e8495 + _e8495), select(select(true, false, (_e8921 <= (_e8200 * 0.25f))), true, (_e8921 <= _e8191))), _e8204);
                                                            phi_14487_ = _e8921;
                                                            phi_14488_ = true;
                                                        }
                                                        let _e8932 = phi_14486_;
                                                        let _e8934 = phi_14487_;
                                                        let _e8936 = phi_14488_;
                                                        phi_14490_ = _e8919;
                                                        phi_14491_ = _e8932;
                                                        phi_14492_ = _e8934;
                                                        phi_14494_ = _e8936;
                                                        phi_14495_ = _e8920;
                                                        phi_14497_ = false;
                                                    } else {
                                                        phi_14490_ = f32();
                                                        phi_14491_ = f32();
                                                        phi_14492_ = f32();
                                                        phi_14494_ = false;
                                                        phi_14495_ = false;
                                                        phi_14497_ = true;
                                                    }
                                                    let _e8938 = phi_14490_;
                                                    let _e8940 = phi_14491_;
                                                    let _e8942 = phi_14492_;
                                                    let _e8944 = phi_14494_;
                                                    let _e8946 = phi_14495_;
                                                    let _e8948 = phi_14497_;
                                                    phi_14498_ = _e8938;
                                                    phi_14499_ = _e8940;
                                                    phi_14500_ = _e8942;
                                                    phi_14502_ = false;
                                                    phi_14503_ = _e8944;
                                                    phi_14504_ = _e8946;
                                                    phi_14506_ = _e8948;
                                                } else {
                                                    phi_14498_ = f32();
                                                    phi_14499_ = f32();
                                                    phi_14500_ = f32();
                                                    phi_14502_ = true;
                                                    phi_14503_ = false;
                                                    phi_14504_ = false;
                                                    phi_14506_ = false;
                                                }
                                                let _e8950 = phi_14498_;
                                                let _e8952 = phi_14499_;
                                                let _e8954 = phi_14500_;
                                                let _e8956 = phi_14502_;
                                                let _e8958 = phi_14503_;
                                                let _e8960 = phi_14504_;
                                                let _e8962 = phi_14506_;
                                                phi_14507_ = _e8950;
                                                phi_14508_ = _e8952;
                                                phi_14509_ = _e8954;
                                                phi_14511_ = _e8956;
                                                phi_14512_ = _e8958;
                                                phi_14513_ = _e8960;
                                                phi_14515_ = _e8962;
                                            } else {
                                                phi_14507_ = f32();
                                                phi_14508_ = f32();
                                                phi_14509_ = f32();
                                                phi_14511_ = true;
                                                phi_14512_ = false;
                                                phi_14513_ = false;
                                                phi_14515_ = false;
                                            }
                                            let _e8964 = phi_14507_;
                                            let _e8966 = phi_14508_;
                                            let _e8968 = phi_14509_;
                                            let _e8970 = phi_14511_;
                                            let _e8972 = phi_14512_;
                                            let _e8974 = phi_14513_;
                                            let _e8976 = phi_14515_;
                                            if _e8970 {
                                                if (_e8196 <= _e8198) {
                                                    let _e9129 = (_e8206 + 1u);
                                                    let _e9130 = (_e9129 > 3u);
                                                    phi_14850_ = _e9129;
                                                    phi_14851_ = f32();
                                                    phi_14852_ = false;
                                                    phi_14853_ = select(true, false, _e9130);
                                                    phi_14854_ = _e9130;
                                                } else {
                                                    let _e8980 = local.member[0u];
                                                    let _e8983 = local.member_1[0u];
                                                    let _e8986 = local.member[0u];
                                                    let _e8992 = local.member_2[0u];
                                                    let _e8993 = ((_e8980 + ((_e8983 - _e8986) * _e8202)) - _e8992);
                                                    let _e8996 = local.member[1u];
                                                    let _e8999 = local.member_1[1u];
                                                    let _e9002 = local.member[1u];
                                                    let _e9008 = local.member_2[1u];
                                                    let _e9009 = ((_e8996 + ((_e8999 - _e9002) * _e8202)) - _e9008);
                                                    let _e9011 = select(_e9009, _e8993, (_e8993 < _e9009));
                                                    let _e9014 = local.member[2u];
                                                    let _e9017 = local.member_1[2u];
                                                    let _e9020 = local.member[2u];
                                                    let _e9026 = local.member_2[2u];
                                                    let _e9027 = ((_e9014 + ((_e9017 - _e9020) * _e8202)) - _e9026);
                                                    let _e9030 = local.member[3u];
                                                    let _e9033 = local.member_1[3u];
                                                    let _e9036 = local.member[3u];
                                                    let _e9042 = local.member_2[3u];
                                                    let _e9043 = ((_e9030 + ((_e9033 - _e9036) * _e8202)) - _e9042);
                                                    let _e9045 = select(_e9043, _e9027, (_e9027 < _e9043));
                                                    let _e9047 = select(_e9045, _e9011, (_e9011 < _e9045));
                                                    let _e9050 = local_1.member[0u];
                                                    let _e9053 = local_1.member_1[0u];
                                                    let _e9056 = local_1.member[0u];
                                                    let _e9062 = local_1.member_2[0u];
                                                    let _e9063 = ((_e9050 + ((_e9053 - _e9056) * _e8196)) - _e9062);
                                                    let _e9066 = local_1.member[1u];
                                                    let _e9069 = local_1.member_1[1u];
                                                    let _e9072 = local_1.member[1u];
                                                    let _e9078 = local_1.member_2[1u];
                                                    let _e9079 = ((_e9066 + ((_e9069 - _e9072) * _e8196)) - _e9078);
                                                    let _e9081 = select(_e9079, _e9063, (_e9063 < _e9079));
                                                    let _e9084 = local_1.member[2u];
                                                    let _e9087 = local_1.member_1[2u];
                                                    let _e9090 = local_1.member[2u];
                                                    let _e9096 = local_1.member_2[2u];
                                                    let _e9097 = ((_e9084 + ((_e9087 - _e9090) * _e8196)) - _e9096);
                                                    let _e9100 = local_1.member[3u];
                                                    let _e9103 = local_1.member_1[3u];
                                                    let _e9106 = local_1.member[3u];
                                                    let _e9112 = local_1.member_2[3u];
                                                    let _e9113 = ((_e9100 + ((_e9103 - _e9106) * _e8196)) - _e9112);
                                                    let _e9115 = select(_e9113, _e9097, (_e9097 < _e9113));
                                                    let _e9117 = select(_e9115, _e9081, (_e9081 < _e9115));
                                                    if (_e9117 > 0f) {
                                                        phi_14848_ = 0.5f;
                                                    } else {
                                                        let _e9121 = (0.95f * (_e9047 / (_e9047 - _e9117)));
                                                        phi_14848_ = select(0.0625f, select(0.9f, _e9121, (_e9121 < 0.9f)), (_e9121 > 0.0625f));
                                                    }
                                                    let _e9127 = phi_14848_;
                                                    phi_14850_ = u32();
                                                    phi_14851_ = (_e8495 * _e9127);
                                                    phi_14852_ = true;
                                                    phi_14853_ = false;
                                                    phi_14854_ = false;
                                                }
                                                let _e9133 = phi_14850_;
                                                let _e9135 = phi_14851_;
                                                let _e9137 = phi_14852_;
                                                let _e9139 = phi_14853_;
                                                let _e9141 = phi_14854_;
                                                phi_14855_ = _e9133;
                                                phi_14856_ = _e8198;
                                                phi_14857_ = _e9135;
                                                phi_14858_ = _e8200;
                                                phi_14859_ = _e8202;
                                                phi_14860_ = _e8204;
                                                phi_14861_ = _e8206;
                                                phi_14862_ = _e9137;
                                                phi_14863_ = _e9139;
                                                phi_14864_ = _e9141;
                                                phi_14865_ = false;
                                                phi_14867_ = false;
                                            } else {
                                                phi_14855_ = u32();
                                                phi_14856_ = _e8964;
                                                phi_14857_ = _e8966;
                                                phi_14858_ = _e8968;
                                                phi_14859_ = _e8196;
                                                phi_14860_ = true;
                                                phi_14861_ = 0u;
                                                phi_14862_ = _e8972;
                                                phi_14863_ = false;
                                                phi_14864_ = false;
                                                phi_14865_ = _e8974;
                                                phi_14867_ = _e8976;
                                            }
                                            let _e9143 = phi_14855_;
                                            let _e9145 = phi_14856_;
                                            let _e9147 = phi_14857_;
                                            let _e9149 = phi_14858_;
                                            let _e9151 = phi_14859_;
                                            let _e9153 = phi_14860_;
                                            let _e9155 = phi_14861_;
                                            let _e9157 = phi_14862_;
                                            let _e9159 = phi_14863_;
                                            let _e9161 = phi_14864_;
                                            let _e9163 = phi_14865_;
                                            let _e9165 = phi_14867_;
                                            if _e9157 {
                                                let _e9166 = (_e9151 + _e9147);
                                                let _e9168 = select(_e9145, _e9166, (_e9166 > _e9145));
                                                let _e9170 = select(_e7973.member_1, _e9168, (_e9168 < _e7973.member_1));
                                                let _e9173 = select(((_e9170 - _e9151) > _e8191), true, !(_e8204));
                                                phi_14895_ = _e9170;
                                                phi_14896_ = _e9145;
                                                phi_14897_ = _e9149;
                                                phi_14898_ = _e9151;
                                                phi_14899_ = _e9153;
                                                phi_14900_ = _e9155;
                                                phi_14901_ = _e9173;
                                                phi_14902_ = select(true, false, _e9173);
                                                phi_14903_ = false;
                                                phi_14904_ = false;
                                                phi_14906_ = false;
                                            } else {
                                                phi_14895_ = _e8196;
                                                phi_14896_ = _e8198;
                                                phi_14897_ = _e8200;
                                                phi_14898_ = _e8202;
                                                phi_14899_ = _e8204;
                                                phi_14900_ = _e9143;
                                                phi_14901_ = _e9159;
                                                phi_14902_ = false;
                                                phi_14903_ = _e9161;
                                                phi_14904_ = _e9163;
                                                phi_14906_ = _e9165;
                                            }
                                            let _e9176 = phi_14895_;
                                            let _e9178 = phi_14896_;
                                            let _e9180 = phi_14897_;
                                            let _e9182 = phi_14898_;
                                            let _e9184 = phi_14899_;
                                            let _e9186 = phi_14900_;
                                            let _e9188 = phi_14901_;
                                            let _e9190 = phi_14902_;
                                            let _e9192 = phi_14903_;
                                            let _e9194 = phi_14904_;
                                            let _e9196 = phi_14906_;
                                            phi_12728_ = _e9176;
                                            phi_12730_ = _e9178;
                                            phi_12732_ = _e9180;
                                            phi_12734_ = _e9182;
                                            phi_12736_ = _e9184;
                                            phi_12738_ = _e9186;
                                            phi_14907_ = _e9145;
                                            phi_14909_ = _e9188;
                                            phi_14910_ = _e9190;
                                            phi_14911_ = _e9192;
                                            phi_14912_ = _e9194;
                                            phi_14914_ = false;
                                            phi_14915_ = _e9196;
                                        } else {
                                            phi_12728_ = f32();
                                            phi_12730_ = f32();
                                            phi_12732_ = f32();
                                            phi_12734_ = f32();
                                            phi_12736_ = bool();
                                            phi_12738_ = u32();
                                            phi_14907_ = f32();
                                            phi_14909_ = false;
                                            phi_14910_ = false;
                                            phi_14911_ = false;
                                            phi_14912_ = false;
                                            phi_14914_ = true;
                                            phi_14915_ = false;
                                        }
                                        let _e9198 = phi_12728_;
                                        let _e9200 = phi_12730_;
                                        let _e9202 = phi_12732_;
                                        let _e9204 = phi_12734_;
                                        let _e9206 = phi_12736_;
                                        let _e9208 = phi_12738_;
                                        let _e9210 = phi_14907_;
                                        let _e9212 = phi_14909_;
                                        let _e9214 = phi_14910_;
                                        let _e9216 = phi_14911_;
                                        let _e9218 = phi_14912_;
                                        let _e9220 = phi_14914_;
                                        let _e9222 = phi_14915_;
                                        local_129 = _e9214;
                                        local_130 = _e9216;
                                        local_131 = _e9214;
                                        local_132 = _e9218;
                                        local_133 = _e9214;
                                        local_134 = _e9220;
                                        local_135 = _e9214;
                                        local_136 = _e9222;
                                        local_138 = _e9214;
                                        local_139 = _e9210;
                                        continue;
                                        continuing {
                                            phi_12724_ = type_9(select(_e8194.member, (_e8194.member + 1u), _e8209), select(_e8194.member_1, _e8194.member_1, _e8209));
                                            phi_12727_ = _e9198;
                                            phi_12729_ = _e9200;
                                            phi_12731_ = _e9202;
                                            phi_12733_ = _e9204;
                                            phi_12735_ = _e9206;
                                            phi_12737_ = _e9208;
                                            break if !(_e9212);
                                        }
                                    }
                                    let _e9225 = local_129;
                                    let _e9227 = local_130;
                                    let _e9228 = select(_e9227, false, _e9225);
                                    let _e9230 = local_131;
                                    let _e9232 = local_132;
                                    let _e9235 = local_133;
                                    let _e9237 = local_134;
                                    let _e9240 = local_135;
                                    let _e9242 = local_136;
                                    let _e9248 = local_137;
                                    let _e9250 = select(select(_e9232, false, _e9230), false, _e9228);
                                    let _e9252 = local_138;
                                    let _e9259 = select(select(_e9252, false, _e9228), false, _e9250);
                                    let _e9264 = local_139;
                                    let _e9266 = local_140;
                                    let _e9268 = select(select(select(select(_e9237, false, _e9235), false, _e9228), false, _e9250), true, _e9259);
                                    let _e9275 = select(select(select(select(select(_e9242, false, _e9240), false, _e9228), false, _e9250), false, _e9259), false, _e9268);
                                    let _e9280 = select(select(select(select(_e9228, true, _e9250), false, _e9259), false, _e9268), true, _e9275);
                                    let _e9283 = (select(select(type_30().member, 1u, _e9268), select(select(select(type_30().member, 1u, _e9228), 0u, _e9250), 0u, _e9275), _e9280) != 0u);
                                    phi_14983_ = select(select(type_30().member_1, select(_e9266, _e9264, _e9259), _e9268), select(select(select(type_30().member_1, _e9248, _e9228), type_30().member_1, _e9250), type_30().member_1, _e9275), _e9280);
                                    phi_14984_ = select(true, false, _e9283);
                                    phi_14985_ = _e9283;
                                    phi_14986_ = false;
                                    phi_14987_ = false;
                                    phi_14988_ = false;
                                } else {
                                    phi_14983_ = f32();
                                    phi_14984_ = _e7981;
                                    phi_14985_ = false;
                                    phi_14986_ = _e7983;
                                    phi_14987_ = _e7985;
                                    phi_14988_ = _e7987;
                                }
                                let _e9286 = phi_14983_;
                                let _e9288 = phi_14984_;
                                let _e9290 = phi_14985_;
                                let _e9292 = phi_14986_;
                                let _e9294 = phi_14987_;
                                let _e9296 = phi_14988_;
                                phi_14989_ = _e7973;
                                phi_14990_ = _e7975;
                                phi_14991_ = _e9286;
                                phi_14992_ = _e7977;
                                phi_14993_ = _e9288;
                                phi_14994_ = _e9290;
                                phi_14995_ = false;
                                phi_14996_ = _e9292;
                                phi_14997_ = _e9294;
                                phi_14998_ = _e9296;
                            } else {
                                phi_14989_ = type_45();
                                phi_14990_ = bool();
                                phi_14991_ = f32();
                                phi_14992_ = type_45();
                                phi_14993_ = false;
                                phi_14994_ = false;
                                phi_14995_ = true;
                                phi_14996_ = false;
                                phi_14997_ = false;
                                phi_14998_ = false;
                            }
                            let _e9298 = phi_14989_;
                            let _e9300 = phi_14990_;
                            let _e9302 = phi_14991_;
                            let _e9304 = phi_14992_;
                            let _e9306 = phi_14993_;
                            let _e9308 = phi_14994_;
                            let _e9310 = phi_14995_;
                            let _e9312 = phi_14996_;
                            let _e9314 = phi_14997_;
                            let _e9316 = phi_14998_;
                            local_141 = _e9308;
                            local_142 = _e9300;
                            local_143 = _e9298;
                            local_144 = _e9302;
                            local_145 = _e9302;
                            local_146 = _e9302;
                            local_163 = _e9310;
                            local_164 = _e9312;
                            local_165 = _e9314;
                            local_166 = _e9316;
                            local_147 = _e9308;
                            local_148 = _e9304;
                            continue;
                            continuing {
                                phi_10869_ = type_9(select(_e6995.member, (_e6995.member + 1u), _e6998), select(_e6995.member_1, _e6995.member_1, _e6998));
                                break if !(_e9306);
                            }
                        }
                        let _e9319 = local_141;
                        if _e9319 {
                            let _e9321 = local_142;
                            if _e9321 {
                                let _e9323 = local_143;
                                let _e9326 = local_144;
                                let _e9328 = ((_e9323.member_1 - _e9326) <= _e6959);
                                let _e9333 = local_145;
                                phi_15014_ = type_30(select(type_30().member, 1u, _e9328), select(type_30().member_1, _e9333, _e9328));
                                phi_15015_ = select(true, false, _e9328);
                            } else {
                                phi_15014_ = type_30();
                                phi_15015_ = true;
                            }
                            let _e9338 = phi_15014_;
                            let _e9340 = phi_15015_;
                            let _e9345 = local_146;
                            phi_15021_ = type_30(select(_e9338.member, 2u, _e9340), select(_e9338.member_1, _e9345, _e9340));
                            phi_15022_ = false;
                            phi_15023_ = false;
                            phi_15024_ = false;
                            phi_15025_ = false;
                        } else {
                            phi_15021_ = type_30();
                            let _e10194 = local_163;
                            phi_15022_ = _e10194;
                            let _e10197 = local_164;
                            phi_15023_ = _e10197;
                            let _e10200 = local_165;
                            phi_15024_ = _e10200;
                            let _e10203 = local_166;
                            phi_15025_ = _e10203;
                        }
                        let _e9349 = phi_15021_;
                        let _e9351 = phi_15022_;
                        let _e9353 = phi_15023_;
                        let _e9355 = phi_15024_;
                        let _e9357 = phi_15025_;
                        let _e9364 = select(_e9353, false, _e9351);
                        let _e9368 = local_147;
                        let _e9375 = select(select(_e9355, false, _e9351), false, _e9364);
                        let _e9381 = select(select(select(_e9357, false, _e9351), false, _e9364), false, _e9375);
                        let _e9385 = local_148;
                        let _e9389 = select(select(_e9364, true, _e9375), true, _e9381);
                        phi_15067_ = type_30(select(_e9349.member, select(select(select(type_30().member, 0u, _e9364), 0u, _e9375), 1u, _e9381), _e9389), select(_e9349.member_1, select(select(select(type_30().member_1, type_30().member_1, _e9364), type_30().member_1, _e9375), _e9385.member, _e9381), _e9389));
                        phi_15068_ = type_30(select(type_30().member, 0u, _e9351), select(type_30().member_1, type_30().member_1, _e9351));
                        phi_15069_ = select(select(select(select(select(_e9368, false, _e9351), false, _e9364), false, _e9375), false, _e9381), true, _e9389);
                    }
                    let _e9400 = phi_15067_;
                    let _e9402 = phi_15068_;
                    let _e9404 = phi_15069_;
                    let _e9407 = select(_e9402.member, _e9400.member, _e9404);
                    let _e9410 = select(_e9402.member_1, _e9400.member_1, _e9404);
                    let _e9416 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e9410 > _e6130)), (_e9407 == 1u))));
                    switch bitcast<i32>(_e9407) {
                        case 0: {
                            phi_15113_ = type_31(0u, _e9416, array<u32, 2>(0u, 0u), false);
                            break;
                        }
                        case 1: {
                            let _e9420 = function_4(_e9410);
                            phi_15113_ = type_31(0u, _e9416, _e9420, true);
                            break;
                        }
                        case 2: {
                            let _e9418 = function_4(_e9410);
                            phi_15113_ = type_31(1u, _e9416, _e9418, true);
                            break;
                        }
                        default: {
                            phi_15113_ = type_31();
                            break;
                        }
                    }
                    let _e9424 = phi_15113_;
                    let _e9428 = params.member.member.member_12;
                    let _e9429 = bitcast<u32>(_e9428);
                    if (_e9424.member_2[0] == select((_e9429 << bitcast<u32>(29i)), 0u, ((_e9429 & 2147483647u) < 8388608u))) {
                        let _e9439 = params.member.member.member_12;
                        let _e9440 = bitcast<u32>(_e9439);
                        let _e9441 = (_e9440 & 2147483647u);
                        phi_15153_ = (_e9424.member_2[1] == select(((_e9440 ^ _e9441) | ((_e9441 >> bitcast<u32>(3i)) + 939524096u)), 0u, (_e9441 < 8388608u)));
                    } else {
                        phi_15153_ = false;
                    }
                    let _e9451 = phi_15153_;
                    let _e9453 = params.member.member.member_1;
                    if ((_e9453 & 128u) != 0u) {
                        phi_15169_ = true;
                    } else {
                        let _e9457 = params.member.member.member_1;
                        phi_15169_ = select(false, _e9451, ((_e9457 & 64u) != 0u));
                    }
                    let _e9462 = phi_15169_;
                    phi_15188_ = type_31(select(1u, _e9424.member, select(true, select(true, false, _e9462), _e9424.member_3)), _e9424.member_1, _e9424.member_2, _e9424.member_3);
                } else {
                    phi_15188_ = _e6124;
                }
                let _e9473 = phi_15188_;
                phi_15189_ = _e9473;
                phi_15190_ = type_9(_e247, _e250);
            } else {
                phi_15189_ = type_31(0u, 0u, array<u32, 2>(0u, 0u), false);
                phi_15190_ = type_9(0u, 0u);
            }
            let _e9475 = phi_15189_;
            let _e9477 = phi_15190_;
            let _e9482 = (_e9475.member != 0u);
            let _e9485 = select(false, !(_e9482), _e9475.member_3);
            if _e9485 {
                let _e9489 = (_e9475.member_2[1] >> bitcast<u32>(20i));
                if (_e9489 <= 896u) {
                    phi_15221_ = 0u;
                } else {
                    phi_15221_ = ((((_e9489 - 896u) << bitcast<u32>(23i)) | ((_e9475.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e9475.member_2[0] >> bitcast<u32>(29i)));
                }
                let _e9504 = phi_15221_;
                let _e9506 = atomicMin((&earliest.member[0u]), _e9504);
            }
            let _e9509 = params.member.member.member_1;
            if ((_e9509 & 16u) != 0u) {
                if (_e163 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e9485 {
                    let _e9515 = atomicAdd((&counters[0u]), 1u);
                    phi_15243_ = _e9515;
                } else {
                    phi_15243_ = 0u;
                }
                let _e9517 = phi_15243_;
                workgroupBarrier();
                if (_e163 == 0u) {
                    let _e9520 = atomicLoad((&counters[0u]));
                    if (_e9520 > 0u) {
                        let _e9523 = atomicAdd((&contacts.member[0u]), _e9520);
                        atomicStore((&counters[1u]), _e9523);
                    }
                }
                workgroupBarrier();
                let _e9526 = atomicLoad((&counters[1u]));
                let _e9527 = (_e9526 + _e9517);
                if _e9485 {
                    let _e9530 = params.member.member_1.member_3;
                    let _e9532 = params.member.member_2.member.member;
                    if (_e9527 < _e9530) {
                        let _e9534 = (7u * _e9527);
                        atomicStore((&contacts.member[(4u + _e9534)]), _e9532);
                        atomicStore((&contacts.member[(_e9534 + 5u)]), _e9475.member);
                        atomicStore((&contacts.member[(_e9534 + 6u)]), _e9477.member);
                        atomicStore((&contacts.member[(_e9534 + 7u)]), _e9477.member_1);
                        atomicStore((&contacts.member[(_e9534 + 8u)]), _e9475.member_2[0]);
                        atomicStore((&contacts.member[(_e9534 + 9u)]), _e9475.member_2[1]);
                        atomicStore((&contacts.member[(_e9534 + 10u)]), _e9475.member_1);
                    }
                }
            }
            workgroupBarrier();
            if (_e163 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e9482 {
                let _e9558 = atomicAdd((&counters[0u]), 1u);
                phi_15309_ = _e9558;
            } else {
                phi_15309_ = 0u;
            }
            let _e9560 = phi_15309_;
            workgroupBarrier();
            if (_e163 == 0u) {
                let _e9563 = atomicLoad((&counters[0u]));
                if (_e9563 > 0u) {
                    let _e9566 = atomicAdd((&undecided.member[0u]), _e9563);
                    atomicStore((&counters[1u]), _e9566);
                }
            }
            workgroupBarrier();
            let _e9569 = atomicLoad((&counters[1u]));
            let _e9570 = (_e9569 + _e9560);
            if _e9482 {
                let _e9572 = params.member.member_2.member.member_1;
                if (_e9570 < _e9572) {
                    let _e9574 = (2u * _e9570);
                    atomicStore((&undecided.member[(4u + _e9574)]), _e9477.member);
                    atomicStore((&undecided.member[(_e9574 + 5u)]), _e9477.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_973_ = type_9(select(_e218.member, (_e218.member + 1u), _e221), select(_e218.member_1, _e218.member_1, _e221));
            break if !(_e234);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_16(id, n, lane);
}
