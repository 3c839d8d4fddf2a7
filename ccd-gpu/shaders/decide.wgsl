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

fn function_(param: f32, param_1: f32) -> f32 {
    return select(param, param_1, select((param_1 <= param), true, (param != param)));
}

fn function_1(param_2: f32, param_3: f32) -> f32 {
    return select(param_2, param_3, select((param_3 >= param_2), true, (param_2 != param_2)));
}

fn function_2(param_4: array<f32, 3>, param_5: array<f32, 3>) -> array<f32, 3> {
    let _e24 = ((((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])) < (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
    return array<f32, 3>(select(param_4[0], param_5[0], _e24), select(param_4[1], param_5[1], _e24), select(param_4[2], param_5[2], _e24));
}

fn function_3(param_6: array<f32, 3>, param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: u32) -> array<f32, 3> {
    var phi_782_: array<array<f32, 3>, 4>;

    let _e9 = (param_6[0] - param_7[0]);
    let _e12 = (param_6[1] - param_7[1]);
    let _e15 = (param_6[2] - param_7[2]);
    if (param_9 != 0u) {
        let _e151 = ((((param_6[0] * param_7[0]) + (param_6[1] * param_7[1])) + (param_6[2] * param_7[2])) / (((param_7[0] * param_7[0]) + (param_7[1] * param_7[1])) + (param_7[2] * param_7[2])));
        let _e155 = select(0f, select(1f, _e151, (_e151 < 1f)), (_e151 > 0f));
        let _e191 = ((((param_6[0] * param_8[0]) + (param_6[1] * param_8[1])) + (param_6[2] * param_8[2])) / (((param_8[0] * param_8[0]) + (param_8[1] * param_8[1])) + (param_8[2] * param_8[2])));
        let _e195 = select(0f, select(1f, _e191, (_e191 < 1f)), (_e191 > 0f));
        let _e228 = ((((_e9 * param_8[0]) + (_e12 * param_8[1])) + (_e15 * param_8[2])) / (((param_8[0] * param_8[0]) + (param_8[1] * param_8[1])) + (param_8[2] * param_8[2])));
        let _e232 = select(0f, select(1f, _e228, (_e228 < 1f)), (_e228 > 0f));
        let _e245 = (param_6[0] - param_8[0]);
        let _e248 = (param_6[1] - param_8[1]);
        let _e251 = (param_6[2] - param_8[2]);
        let _e271 = ((((_e245 * param_7[0]) + (_e248 * param_7[1])) + (_e251 * param_7[2])) / (((param_7[0] * param_7[0]) + (param_7[1] * param_7[1])) + (param_7[2] * param_7[2])));
        let _e275 = select(0f, select(1f, _e271, (_e271 < 1f)), (_e271 > 0f));
        phi_782_ = array<array<f32, 3>, 4>(array<f32, 3>((param_6[0] - (param_7[0] * _e155)), (param_6[1] - (param_7[1] * _e155)), (param_6[2] - (param_7[2] * _e155))), array<f32, 3>((param_6[0] - (param_8[0] * _e195)), (param_6[1] - (param_8[1] * _e195)), (param_6[2] - (param_8[2] * _e195))), array<f32, 3>((_e9 - (param_8[0] * _e232)), (_e12 - (param_8[1] * _e232)), (_e15 - (param_8[2] * _e232))), array<f32, 3>((_e245 - (param_7[0] * _e275)), (_e248 - (param_7[1] * _e275)), (_e251 - (param_7[2] * _e275))));
    } else {
        let _e19 = (param_8[0] - param_7[0]);
        let _e22 = (param_8[1] - param_7[1]);
        let _e25 = (param_8[2] - param_7[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        let _e40 = select(0f, select(1f, _e36, (_e36 < 1f)), (_e36 > 0f));
        let _e47 = array<f32, 3>((_e9 - (_e19 * _e40)), (_e12 - (_e22 * _e40)), (_e15 - (_e25 * _e40)));
        let _e70 = ((((param_6[0] * param_7[0]) + (param_6[1] * param_7[1])) + (param_6[2] * param_7[2])) / (((param_7[0] * param_7[0]) + (param_7[1] * param_7[1])) + (param_7[2] * param_7[2])));
        let _e74 = select(0f, select(1f, _e70, (_e70 < 1f)), (_e70 > 0f));
        let _e110 = ((((param_6[0] * param_8[0]) + (param_6[1] * param_8[1])) + (param_6[2] * param_8[2])) / (((param_8[0] * param_8[0]) + (param_8[1] * param_8[1])) + (param_8[2] * param_8[2])));
        let _e114 = select(0f, select(1f, _e110, (_e110 < 1f)), (_e110 > 0f));
        phi_782_ = array<array<f32, 3>, 4>(array<f32, 3>((param_6[0] - (param_7[0] * _e74)), (param_6[1] - (param_7[1] * _e74)), (param_6[2] - (param_7[2] * _e74))), array<f32, 3>((param_6[0] - (param_8[0] * _e114)), (param_6[1] - (param_8[1] * _e114)), (param_6[2] - (param_8[2] * _e114))), _e47, _e47);
    }
    let _e288 = phi_782_;
    let _e291 = function_2(_e288[0], _e288[1]);
    let _e293 = function_2(_e291, _e288[2]);
    let _e295 = function_2(_e293, _e288[3]);
    return _e295;
}

fn function_4(param_10: array<f32, 3>, param_11: array<f32, 3>, param_12: array<f32, 3>, param_13: u32) -> array<f32, 3> {
    var phi_410_: bool;
    var phi_443_: array<f32, 3>;
    var phi_444_: bool;
    var phi_445_: array<f32, 3>;
    var phi_446_: bool;
    var phi_451_: array<f32, 3>;

    let _e23 = (((param_11[0] * param_11[0]) + (param_11[1] * param_11[1])) + (param_11[2] * param_11[2]));
    let _e34 = (((param_11[0] * param_12[0]) + (param_11[1] * param_12[1])) + (param_11[2] * param_12[2]));
    let _e45 = (((param_12[0] * param_12[0]) + (param_12[1] * param_12[1])) + (param_12[2] * param_12[2]));
    let _e56 = (((param_10[0] * param_11[0]) + (param_10[1] * param_11[1])) + (param_10[2] * param_11[2]));
    let _e67 = (((param_10[0] * param_12[0]) + (param_10[1] * param_12[1])) + (param_10[2] * param_12[2]));
    let _e70 = ((_e23 * _e45) - (_e34 * _e34));
    let _e74 = (((_e56 * _e45) - (_e67 * _e34)) / _e70);
    let _e78 = (((_e67 * _e23) - (_e56 * _e34)) / _e70);
    if (param_13 != 0u) {
        let _e89 = (_e74 >= 0f);
        let _e90 = (_e78 >= 0f);
        let _e91 = (_e74 <= 1f);
        phi_410_ = select(select(bool(), select(bool(), select(bool(), (_e78 <= 1f), _e91), _e90), _e89), false, select(true, select(true, select(true, false, _e91), _e90), _e89));
    } else {
        let _e80 = (_e74 >= 0f);
        let _e81 = (_e78 >= 0f);
        phi_410_ = select(select(bool(), select(bool(), ((_e74 + _e78) <= 1f), _e81), _e80), false, select(true, select(true, false, _e81), _e80));
    }
    let _e101 = phi_410_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e101 {
            phi_443_ = array<f32, 3>((param_10[0] - ((param_11[0] * _e74) + (param_12[0] * _e78))), (param_10[1] - ((param_11[1] * _e74) + (param_12[1] * _e78))), (param_10[2] - ((param_11[2] * _e74) + (param_12[2] * _e78))));
            phi_444_ = false;
        } else {
            phi_443_ = array<f32, 3>();
            phi_444_ = true;
        }
        let _e129 = phi_443_;
        let _e131 = phi_444_;
        phi_445_ = _e129;
        phi_446_ = _e131;
    } else {
        phi_445_ = array<f32, 3>();
        phi_446_ = true;
    }
    let _e133 = phi_445_;
    let _e135 = phi_446_;
    if _e135 {
        let _e136 = function_3(param_10, param_11, param_12, param_13);
        phi_451_ = _e136;
    } else {
        phi_451_ = _e133;
    }
    let _e138 = phi_451_;
    return _e138;
}

fn function_5(param_14: f32) -> array<u32, 2> {
    let _e7 = bitcast<u32>(param_14);
    let _e8 = (_e7 & 2147483647u);
    let _e9 = (_e8 < 8388608u);
    return array<u32, 2>(select((_e7 << bitcast<u32>(29i)), 0u, _e9), select(((_e7 ^ _e8) | ((_e8 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e9));
}

fn function_6(param_15: ptr<function, type_34>, param_16: f32, param_17: f32, param_18: f32) -> bool {
    var phi_15463_: bool;
    var phi_15464_: bool;
    var phi_15469_: bool;

    let _e14 = (*param_15).member_3;
    let _e16 = (*param_15).member_3;
    let _e18 = (param_16 + (_e14 + _e16));
    if (_e18 < param_18) {
        let _e20 = (1f - param_17);
        let _e23 = (*param_15).member[0u];
        let _e26 = (*param_15).member[1u];
        let _e29 = (*param_15).member[2u];
        let _e32 = (*param_15).member[3u];
        let _e43 = ((((_e23 * _e20) + (_e26 * param_17)) * (_e20 * _e20)) + (((_e29 * _e20) + (_e32 * param_17)) * (param_17 * param_17)));
        let _e45 = select(param_17, _e18, (_e18 > param_17));
        let _e46 = (1f - _e45);
        let _e49 = (*param_15).member[0u];
        let _e52 = (*param_15).member[1u];
        let _e55 = (*param_15).member[2u];
        let _e58 = (*param_15).member[3u];
        let _e69 = ((((_e49 * _e46) + (_e52 * _e45)) * (_e46 * _e46)) + (((_e55 * _e46) + (_e58 * _e45)) * (_e45 * _e45)));
        let _e71 = (*param_15).member_1;
        let _e73 = (*param_15).member_1;
        let _e79 = (*param_15).member_1;
        if (select(_e43, -(_e43), (_e43 < 0f)) > _e79) {
            let _e84 = (select(_e69, -(_e69), (_e69 < 0f)) > (_e71 + _e73));
            phi_15463_ = select(bool(), ((_e43 > 0f) == (_e69 > 0f)), _e84);
            phi_15464_ = select(true, false, _e84);
        } else {
            phi_15463_ = bool();
            phi_15464_ = true;
        }
        let _e91 = phi_15463_;
        let _e93 = phi_15464_;
        phi_15469_ = select(_e91, false, _e93);
    } else {
        phi_15469_ = false;
    }
    let _e96 = phi_15469_;
    return _e96;
}

fn function_7(param_19: u32, param_20: u32, param_21: u32) -> type_9 {
    let _e11 = ((param_19 >> bitcast<u32>(31i)) != 0u);
    let _e18 = select(param_19, (~(param_19) + select(0u, 1u, (param_20 == 0u))), _e11);
    let _e19 = select(param_20, (~(param_20) + 1u), _e11);
    let _e21 = (_e18 >> bitcast<u32>(16i));
    let _e22 = (_e18 & 65535u);
    let _e24 = (param_21 >> bitcast<u32>(16i));
    let _e25 = (param_21 & 65535u);
    let _e30 = ((_e21 * _e25) + ((_e22 * _e25) >> bitcast<u32>(16i)));
    let _e41 = (_e18 * param_21);
    let _e43 = (_e19 >> bitcast<u32>(16i));
    let _e44 = (_e19 & 65535u);
    let _e46 = (param_21 >> bitcast<u32>(16i));
    let _e47 = (param_21 & 65535u);
    let _e52 = ((_e43 * _e47) + ((_e44 * _e47) >> bitcast<u32>(16i)));
    let _e64 = (_e41 + (((_e43 * _e46) + (_e52 >> bitcast<u32>(16i))) + (((_e44 * _e46) + (_e52 & 65535u)) >> bitcast<u32>(16i))));
    let _e72 = ((((((_e21 * _e24) + (_e30 >> bitcast<u32>(16i))) + (((_e22 * _e24) + (_e30 & 65535u)) >> bitcast<u32>(16i))) + select(0u, 1u, (_e64 < _e41))) << bitcast<u32>(1i)) | (_e64 >> bitcast<u32>(31i)));
    let _e77 = ((_e64 << bitcast<u32>(1i)) | ((_e19 * param_21) >> bitcast<u32>(31i)));
    let _e80 = ((param_19 >> bitcast<u32>(31i)) != 0u);
    return type_9(select(_e72, (~(_e72) + select(0u, 1u, (_e77 == 0u))), _e80), select(_e77, (~(_e77) + 1u), _e80));
}

fn function_8(param_22: array<type_9, 3>, param_23: u32) -> array<type_9, 2> {
    let _e17 = function_7(((param_22[1].member - param_22[0].member) - select(0u, 1u, (param_22[1].member_1 < param_22[0].member_1))), (param_22[1].member_1 - param_22[0].member_1), param_23);
    let _e20 = (param_22[0].member_1 + _e17.member_1);
    let _e38 = function_7(((param_22[2].member - param_22[1].member) - select(0u, 1u, (param_22[2].member_1 < param_22[1].member_1))), (param_22[2].member_1 - param_22[1].member_1), param_23);
    let _e41 = (param_22[1].member_1 + _e38.member_1);
    return array<type_9, 2>(type_9(((param_22[0].member + _e17.member) + select(0u, 1u, (_e20 < param_22[0].member_1))), _e20), type_9(((param_22[1].member + _e38.member) + select(0u, 1u, (_e41 < param_22[1].member_1))), _e41));
}

fn function_9(param_24: u32, param_25: u32, param_26: u32, param_27: u32) -> bool {
    return ((((param_26 - param_24) - select(0u, 1u, (param_27 < param_25))) >> bitcast<u32>(31i)) != 0u);
}

fn function_10(param_28: u32, param_29: u32, param_30: u32, param_31: u32) -> bool {
    return ((((param_30 - (~(param_28) + select(0u, 1u, (param_29 == 0u)))) - select(0u, 1u, (param_31 < (~(param_29) + 1u)))) >> bitcast<u32>(31i)) != 0u);
}

fn function_11(param_32: u32, param_33: u32, param_34: u32, param_35: u32) -> type_9 {
    let _e13 = ((param_32 >> bitcast<u32>(31i)) != 0u);
    let _e20 = select(param_32, (~(param_32) + select(0u, 1u, (param_33 == 0u))), _e13);
    let _e21 = select(param_33, (~(param_33) + 1u), _e13);
    let _e24 = ((param_34 >> bitcast<u32>(31i)) != 0u);
    let _e31 = select(param_34, (~(param_34) + select(0u, 1u, (param_35 == 0u))), _e24);
    let _e32 = select(param_35, (~(param_35) + 1u), _e24);
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
    let _e130 = (((param_32 >> bitcast<u32>(31i)) != 0u) != ((param_34 >> bitcast<u32>(31i)) != 0u));
    return type_9(select(_e123, (~(_e123) + select(0u, 1u, (_e118 == 0u))), _e130), select(_e118, (~(_e118) + 1u), _e130));
}

fn function_12(param_36: array<type_9, 2>, param_37: array<type_9, 2>) -> type_9 {
    let _e12 = function_11(param_36[0].member, param_36[0].member_1, param_37[1].member, param_37[1].member_1);
    let _e23 = function_11(param_36[1].member, param_36[1].member_1, param_37[0].member, param_37[0].member_1);
    return type_9(((_e12.member - _e23.member) - select(0u, 1u, (_e12.member_1 < _e23.member_1))), (_e12.member_1 - _e23.member_1));
}

fn function_13(param_38: f32, param_39: f32, param_40: f32) -> f32 {
    return (param_38 + ((param_39 - param_38) * param_40));
}

fn function_14(param_41: u32) -> type_9 {
    return type_9(0u, param_41);
}

fn function_15(param_42: u32, param_43: u32) -> type_9 {
    let _e4 = (param_43 + param_43);
    let _e9 = (_e4 + param_43);
    return type_9(((((param_42 + param_42) + select(0u, 1u, (_e4 < param_43))) + param_42) + select(0u, 1u, (_e9 < _e4))), _e9);
}

fn function_16(param_44: array<u32, 2>, param_45: i32) -> type_9 {
    var phi_14948_: type_9;
    var phi_14949_: type_9;
    var phi_14950_: type_9;
    var phi_14951_: type_9;
    var phi_14952_: type_9;
    var phi_14953_: bool;

    let _e24 = ((param_44[1] >> bitcast<u32>(20i)) & 2047u);
    let _e28 = ((param_44[1] & 1048575u) | select(1048576u, 0u, (_e24 == 0u)));
    let _e33 = ((bitcast<i32>(select(1u, _e24, (1u < _e24))) - 1015i) - param_45);
    let _e35 = (bitcast<u32>(_e33) % 32u);
    if (_e33 >= 64i) {
        phi_14952_ = type_9();
        phi_14953_ = true;
    } else {
        let _e37 = (_e33 <= -53i);
        if _e37 {
            phi_14951_ = type_9();
        } else {
            if (_e33 >= 32i) {
                phi_14950_ = type_9((param_44[0] << bitcast<u32>((_e35 & 31u))), 0u);
            } else {
                if (_e33 >= 0i) {
                    phi_14949_ = type_9(((_e28 << bitcast<u32>((_e35 & 31u))) | ((param_44[0] >> bitcast<u32>(1i)) >> bitcast<u32>(((31u - _e35) & 31u)))), (param_44[0] << bitcast<u32>((_e35 & 31u))));
                } else {
                    if (_e33 > -32i) {
                        let _e49 = bitcast<u32>(-(_e33));
                        phi_14948_ = type_9(bitcast<u32>((bitcast<i32>(_e28) >> bitcast<u32>((_e49 & 31u)))), ((param_44[0] >> bitcast<u32>((_e49 & 31u))) | ((_e28 << bitcast<u32>(((31u - _e49) & 31u))) << bitcast<u32>(1i))));
                    } else {
                        phi_14948_ = type_9(0u, (_e28 >> bitcast<u32>(((bitcast<u32>(-(_e33)) - 32u) & 31u))));
                    }
                    let _e67 = phi_14948_;
                    phi_14949_ = _e67;
                }
                let _e83 = phi_14949_;
                phi_14950_ = _e83;
            }
            let _e89 = phi_14950_;
            phi_14951_ = _e89;
        }
        let _e91 = phi_14951_;
        phi_14952_ = _e91;
        phi_14953_ = _e37;
    }
    let _e93 = phi_14952_;
    let _e95 = phi_14953_;
    let _e97 = select(_e93.member, 0u, _e95);
    let _e99 = select(_e93.member_1, 0u, _e95);
    let _e102 = ((param_44[1] >> bitcast<u32>(31i)) != 0u);
    return type_9(select(_e97, (~(_e97) + select(0u, 1u, (_e99 == 0u))), _e102), select(_e99, (~(_e99) + 1u), _e102));
}

fn function_17(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
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
    var phi_937_: u32;
    var phi_983_: u32;
    var phi_986_: type_9;
    var phi_1144_: type_21;
    var phi_1558_: type_27;
    var phi_3266_: array<array<array<type_9, 3>, 2>, 4>;
    var phi_3813_: array<array<array<type_9, 3>, 2>, 3>;
    var phi_5117_: type_9;
    var phi_5120_: array<type_9, 4>;
    var phi_5122_: bool;
    var phi_5124_: bool;
    var phi_5128_: u32;
    var phi_5130_: u32;
    var phi_5350_: bool;
    var phi_5722_: type_14;
    var phi_5725_: f32;
    var phi_5723_: type_14;
    var phi_5766_: type_15;
    var phi_5726_: f32;
    var local_42: f32;
    var phi_6211_: bool;
    var phi_6212_: type_20;
    var phi_6213_: bool;
    var phi_6214_: bool;
    var phi_6215_: type_20;
    var phi_6216_: bool;
    var phi_6451_: bool;
    var phi_6452_: bool;
    var phi_6453_: type_20;
    var phi_6454_: bool;
    var phi_6455_: type_20;
    var phi_6456_: bool;
    var phi_6457_: bool;
    var phi_6458_: type_20;
    var phi_7605_: array<type_9, 2>;
    var phi_7634_: array<type_9, 2>;
    var phi_7663_: array<type_9, 2>;
    var phi_7677_: type_9;
    var phi_7999_: type_9;
    var phi_8000_: type_9;
    var phi_8001_: type_9;
    var phi_8002_: type_9;
    var phi_8116_: bool;
    var phi_8117_: bool;
    var phi_8118_: bool;
    var phi_8123_: u32;
    var phi_8124_: u32;
    var phi_8125_: bool;
    var phi_8126_: u32;
    var phi_8127_: bool;
    var phi_8128_: u32;
    var phi_8129_: bool;
    var phi_8134_: u32;
    var phi_8198_: bool;
    var phi_8199_: bool;
    var phi_8200_: bool;
    var phi_8201_: type_20;
    var phi_8202_: bool;
    var phi_8203_: bool;
    var phi_8204_: bool;
    var phi_8539_: array<type_9, 4>;
    var phi_8540_: u32;
    var phi_8541_: array<type_9, 4>;
    var phi_8543_: u32;
    var phi_8544_: u32;
    var phi_8545_: array<type_9, 4>;
    var phi_8547_: u32;
    var phi_8548_: u32;
    var phi_8549_: bool;
    var phi_8550_: bool;
    var phi_8551_: array<type_9, 4>;
    var phi_8552_: bool;
    var phi_8553_: bool;
    var phi_8555_: bool;
    var phi_8556_: u32;
    var phi_8557_: u32;
    var phi_8558_: type_20;
    var phi_8559_: bool;
    var phi_8560_: bool;
    var phi_8561_: bool;
    var phi_8856_: array<type_9, 4>;
    var phi_8857_: array<type_9, 4>;
    var phi_8858_: bool;
    var phi_8859_: bool;
    var phi_8860_: u32;
    var phi_8861_: u32;
    var phi_8862_: bool;
    var phi_8867_: array<type_9, 4>;
    var phi_8868_: bool;
    var phi_8869_: bool;
    var phi_8870_: u32;
    var phi_8871_: u32;
    var phi_8872_: bool;
    var phi_8873_: bool;
    var phi_8874_: bool;
    var phi_8875_: bool;
    var phi_8876_: array<type_9, 4>;
    var phi_8877_: bool;
    var phi_8878_: bool;
    var phi_8880_: u32;
    var phi_8881_: u32;
    var phi_8882_: type_20;
    var phi_8883_: bool;
    var phi_8884_: bool;
    var phi_8885_: bool;
    var phi_8886_: bool;
    var phi_5121_: array<type_9, 4>;
    var phi_5123_: bool;
    var phi_5125_: bool;
    var phi_5129_: u32;
    var phi_5131_: u32;
    var phi_8887_: type_20;
    var phi_8888_: bool;
    var phi_8889_: bool;
    var phi_8890_: bool;
    var phi_8891_: bool;
    var phi_8892_: bool;
    var phi_8893_: bool;
    var local_43: bool;
    var local_44: bool;
    var local_45: bool;
    var local_46: bool;
    var local_47: bool;
    var local_48: bool;
    var local_49: bool;
    var local_50: bool;
    var local_51: bool;
    var local_52: bool;
    var local_53: bool;
    var local_54: type_20;
    var phi_8982_: array<u32, 2>;
    var phi_8988_: type_31;
    var phi_8995_: type_31;
    var phi_8996_: bool;
    var phi_8997_: type_31;
    var phi_8998_: bool;
    var phi_9269_: bool;
    var phi_9363_: type_29;
    var phi_9364_: bool;
    var phi_9365_: type_29;
    var phi_9366_: bool;
    var phi_9367_: type_29;
    var phi_9368_: bool;
    var phi_9373_: type_29;
    var phi_10098_: bool;
    var phi_10110_: f32;
    var phi_10181_: type_14;
    var phi_10184_: f32;
    var phi_10182_: type_14;
    var phi_10225_: type_15;
    var phi_10185_: f32;
    var local_55: f32;
    var phi_10238_: f32;
    var phi_10269_: type_9;
    var phi_10272_: u32;
    var phi_10339_: u32;
    var phi_10340_: u32;
    var phi_10273_: u32;
    var phi_10341_: u32;
    var phi_10397_: type_9;
    var phi_10553_: type_45;
    var phi_10554_: bool;
    var phi_10555_: type_45;
    var phi_10556_: bool;
    var phi_10587_: type_9;
    var phi_10590_: f32;
    var phi_10592_: f32;
    var phi_10594_: f32;
    var phi_10704_: bool;
    var phi_10711_: f32;
    var phi_10712_: bool;
    var phi_10591_: f32;
    var phi_10593_: f32;
    var phi_10595_: f32;
    var phi_10713_: f32;
    var phi_10714_: bool;
    var phi_10715_: bool;
    var local_56: bool;
    var local_57: f32;
    var local_58: f32;
    var phi_10720_: f32;
    var phi_10736_: type_9;
    var phi_10739_: f32;
    var phi_10804_: f32;
    var phi_10805_: bool;
    var phi_10806_: bool;
    var phi_10807_: bool;
    var phi_10808_: f32;
    var phi_10740_: f32;
    var phi_10809_: bool;
    var phi_10810_: bool;
    var phi_10811_: bool;
    var phi_10812_: bool;
    var local_59: bool;
    var local_60: bool;
    var local_61: bool;
    var local_62: bool;
    var local_63: f32;
    var phi_10826_: f32;
    var phi_10828_: type_45;
    var phi_11665_: array<type_16, 4>;
    var phi_11685_: type_9;
    var phi_11688_: bool;
    var phi_11689_: bool;
    var phi_11740_: bool;
    var phi_11741_: bool;
    var local_64: bool;
    var local_65: bool;
    var phi_11755_: u32;
    var phi_11756_: u32;
    var phi_11757_: bool;
    var phi_11788_: bool;
    var phi_11789_: bool;
    var phi_11790_: bool;
    var phi_11791_: bool;
    var phi_11792_: bool;
    var phi_11793_: bool;
    var phi_11794_: bool;
    var phi_11795_: bool;
    var phi_11796_: bool;
    var phi_11797_: bool;
    var phi_11798_: bool;
    var phi_11799_: bool;
    var phi_11800_: type_45;
    var phi_11801_: bool;
    var phi_11802_: type_45;
    var phi_11803_: bool;
    var phi_11804_: bool;
    var phi_11805_: bool;
    var phi_11806_: bool;
    var phi_11807_: type_45;
    var phi_11808_: bool;
    var phi_11809_: type_45;
    var phi_11810_: bool;
    var phi_11811_: bool;
    var phi_11812_: bool;
    var phi_11813_: bool;
    var phi_11814_: bool;
    var phi_11822_: type_45;
    var phi_11823_: bool;
    var phi_11824_: type_45;
    var phi_11825_: bool;
    var phi_11826_: bool;
    var phi_11827_: bool;
    var phi_11828_: bool;
    var phi_11829_: bool;
    var phi_12252_: type_9;
    var phi_12255_: f32;
    var phi_12257_: f32;
    var phi_12259_: f32;
    var phi_12261_: f32;
    var phi_12263_: bool;
    var phi_12265_: u32;
    var phi_12416_: array<f32, 3>;
    var phi_12482_: type_14;
    var phi_12485_: f32;
    var phi_12483_: type_14;
    var phi_12526_: type_15;
    var phi_12486_: f32;
    var local_66: f32;
    var phi_12539_: f32;
    var phi_12662_: type_28;
    var phi_12663_: bool;
    var phi_12664_: type_28;
    var phi_12665_: bool;
    var phi_12673_: type_28;
    var phi_12844_: bool;
    var phi_12845_: bool;
    var phi_12846_: bool;
    var phi_12847_: bool;
    var phi_12848_: bool;
    var phi_12849_: bool;
    var phi_13150_: bool;
    var phi_13151_: bool;
    var phi_13152_: bool;
    var phi_13153_: bool;
    var phi_13154_: bool;
    var phi_13155_: bool;
    var phi_13163_: bool;
    var phi_13270_: f32;
    var phi_13271_: bool;
    var phi_13272_: f32;
    var phi_13273_: bool;
    var phi_13274_: f32;
    var phi_13275_: bool;
    var phi_13276_: bool;
    var phi_13338_: f32;
    var phi_13339_: bool;
    var phi_13340_: f32;
    var phi_13341_: bool;
    var phi_13342_: f32;
    var phi_13343_: bool;
    var phi_13344_: bool;
    var phi_13411_: f32;
    var phi_13412_: bool;
    var phi_13413_: f32;
    var phi_13414_: bool;
    var phi_13415_: f32;
    var phi_13416_: bool;
    var phi_13417_: bool;
    var phi_13479_: f32;
    var phi_13480_: bool;
    var phi_13481_: f32;
    var phi_13482_: bool;
    var phi_13483_: f32;
    var phi_13484_: bool;
    var phi_13485_: bool;
    var phi_14014_: f32;
    var phi_14015_: f32;
    var phi_14016_: bool;
    var phi_14018_: f32;
    var phi_14019_: f32;
    var phi_14020_: f32;
    var phi_14022_: bool;
    var phi_14023_: bool;
    var phi_14025_: bool;
    var phi_14026_: f32;
    var phi_14027_: f32;
    var phi_14028_: f32;
    var phi_14030_: bool;
    var phi_14031_: bool;
    var phi_14032_: bool;
    var phi_14034_: bool;
    var phi_14035_: f32;
    var phi_14036_: f32;
    var phi_14037_: f32;
    var phi_14039_: bool;
    var phi_14040_: bool;
    var phi_14041_: bool;
    var phi_14043_: bool;
    var phi_14376_: f32;
    var phi_14378_: u32;
    var phi_14379_: f32;
    var phi_14380_: bool;
    var phi_14381_: bool;
    var phi_14382_: bool;
    var phi_14383_: u32;
    var phi_14384_: f32;
    var phi_14385_: f32;
    var phi_14386_: f32;
    var phi_14387_: f32;
    var phi_14388_: bool;
    var phi_14389_: u32;
    var phi_14390_: bool;
    var phi_14391_: bool;
    var phi_14392_: bool;
    var phi_14393_: bool;
    var phi_14395_: bool;
    var phi_14423_: f32;
    var phi_14424_: f32;
    var phi_14425_: f32;
    var phi_14426_: f32;
    var phi_14427_: bool;
    var phi_14428_: u32;
    var phi_14429_: bool;
    var phi_14430_: bool;
    var phi_14431_: bool;
    var phi_14432_: bool;
    var phi_14434_: bool;
    var phi_12256_: f32;
    var phi_12258_: f32;
    var phi_12260_: f32;
    var phi_12262_: f32;
    var phi_12264_: bool;
    var phi_12266_: u32;
    var phi_14435_: f32;
    var phi_14437_: bool;
    var phi_14438_: bool;
    var phi_14439_: bool;
    var phi_14440_: bool;
    var phi_14442_: bool;
    var phi_14443_: bool;
    var local_67: bool;
    var local_68: bool;
    var local_69: bool;
    var local_70: bool;
    var local_71: bool;
    var local_72: bool;
    var local_73: bool;
    var local_74: bool;
    var local_75: f32;
    var local_76: bool;
    var local_77: f32;
    var local_78: f32;
    var phi_14511_: f32;
    var phi_14512_: bool;
    var phi_14513_: bool;
    var phi_14514_: bool;
    var phi_14515_: bool;
    var phi_14516_: bool;
    var phi_14517_: type_45;
    var phi_14518_: bool;
    var phi_14519_: f32;
    var phi_14520_: type_45;
    var phi_14521_: bool;
    var phi_14522_: bool;
    var phi_14523_: bool;
    var phi_14524_: bool;
    var phi_14525_: bool;
    var phi_14526_: bool;
    var local_79: bool;
    var local_80: bool;
    var local_81: type_45;
    var local_82: f32;
    var local_83: f32;
    var phi_14542_: type_30;
    var phi_14543_: bool;
    var local_84: f32;
    var phi_14549_: type_30;
    var phi_14550_: bool;
    var phi_14551_: bool;
    var phi_14552_: bool;
    var phi_14553_: bool;
    var local_85: bool;
    var local_86: type_45;
    var phi_14595_: type_30;
    var phi_14596_: type_30;
    var phi_14597_: bool;
    var phi_14641_: type_31;
    var phi_14681_: bool;
    var phi_14697_: bool;
    var phi_14716_: type_31;
    var phi_14717_: type_31;
    var phi_14718_: type_9;
    var phi_14749_: u32;
    var phi_14771_: u32;
    var phi_14837_: u32;
    var local_87: u32;
    var local_88: bool;
    var local_89: bool;
    var local_90: bool;
    var local_91: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e160 = id_2;
    let _e161 = n_2;
    let _e162 = lane_2;
    let _e175 = ((_e160.y * _e161.x) + _e160.x);
    let _e178 = (_e161.x * _e161.y);
    let _e181 = params.member.member_1.member_2;
    let _e183 = input.member[0u];
    let _e185 = select(_e183, _e181, (_e181 < _e183));
    let _e187 = params.member.member_1.member_1;
    if (_e185 > _e187) {
        let _e190 = params.member.member_1.member_1;
        phi_937_ = (_e185 - _e190);
    } else {
        phi_937_ = 0u;
    }
    let _e193 = phi_937_;
    let _e195 = params.member.member_1.member;
    let _e197 = select(_e193, _e195, (_e195 < _e193));
    let _e199 = (_e197 / 64u);
    let _e203 = select(_e199, (_e199 + 1u), ((_e197 % 64u) > 0u));
    if (_e203 > _e175) {
        let _e205 = (_e203 - _e175);
        if (_e178 == 0u) {
            return;
        }
        let _e207 = (_e205 / _e178);
        if (_e178 == 0u) {
            return;
        }
        phi_983_ = select(_e207, (_e207 + 1u), ((_e205 % _e178) > 0u));
    } else {
        phi_983_ = 0u;
    }
    let _e214 = phi_983_;
    phi_986_ = type_9(0u, _e214);
    loop {
        let _e217 = phi_986_;
        let _e220 = (_e217.member < _e217.member_1);
        let _e233 = (bitcast<i32>(select(0u, 1u, _e220)) != 0i);
        if _e233 {
            let _e237 = (((_e175 + (select(type_9().member_1, _e217.member, _e220) * _e178)) * 64u) + _e162);
            if (_e237 < _e197) {
                let _e241 = params.member.member_1.member_1;
                let _e243 = (2u * (_e241 + _e237));
                let _e246 = input.member[(4u + _e243)];
                let _e249 = input.member[(_e243 + 5u)];
                let _e255 = params.member.member_2.member.member;
                if (_e255 == 0u) {
                    let _e271 = (3u * _e249);
                    let _e273 = elements.member[_e271];
                    let _e276 = elements.member[(_e271 + 1u)];
                    let _e279 = elements.member[(_e271 + 2u)];
                    phi_1144_ = type_21(0u, array<u32, 4>(_e246, _e273, _e276, _e279));
                } else {
                    let _e257 = (2u * _e246);
                    let _e258 = (2u * _e249);
                    let _e260 = elements.member[_e257];
                    let _e262 = elements.member[_e258];
                    let _e265 = elements.member[(_e257 + 1u)];
                    let _e268 = elements.member[(_e258 + 1u)];
                    phi_1144_ = type_21(1u, array<u32, 4>(_e260, _e265, _e262, _e268));
                }
                let _e283 = phi_1144_;
                local_39 = array<u32, 4>(_e283.member_1[0], _e283.member_1[1], _e283.member_1[2], _e283.member_1[3]);
                let _e292 = paths.member[_e283.member_1[0]];
                let _e306 = paths.member[_e283.member_1[1]];
                let _e320 = paths.member[_e283.member_1[2]];
                let _e334 = paths.member[_e283.member_1[3]];
                local_40 = array<array<f32, 3>, 4>(array<f32, 3>(_e292.member.x, _e292.member.y, _e292.member.z), array<f32, 3>(_e306.member.x, _e306.member.y, _e306.member.z), array<f32, 3>(_e320.member.x, _e320.member.y, _e320.member.z), array<f32, 3>(_e334.member.x, _e334.member.y, _e334.member.z));
                local_41 = array<array<f32, 3>, 4>(array<f32, 3>(_e292.member_1.x, _e292.member_1.y, _e292.member_1.z), array<f32, 3>(_e306.member_1.x, _e306.member_1.y, _e306.member_1.z), array<f32, 3>(_e320.member_1.x, _e320.member_1.y, _e320.member_1.z), array<f32, 3>(_e334.member_1.x, _e334.member_1.y, _e334.member_1.z));
                let _e358 = params.member.member.member_4;
                if (_e283.member != 0u) {
                    let _e449 = local_40;
                    let _e454 = local_40;
                    let _e463 = local_41;
                    let _e468 = local_41;
                    let _e478 = local_40;
                    let _e483 = local_40;
                    let _e492 = local_41;
                    let _e497 = local_41;
                    let _e507 = local_40;
                    let _e512 = local_40;
                    let _e521 = local_41;
                    let _e526 = local_41;
                    phi_1558_ = type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e449[2][0] - _e454[0][0]), (_e449[2][1] - _e454[0][1]), (_e449[2][2] - _e454[0][2])), array<f32, 3>((_e463[2][0] - _e468[0][0]), (_e463[2][1] - _e468[0][1]), (_e463[2][2] - _e468[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e478[1][0] - _e483[0][0]), (_e478[1][1] - _e483[0][1]), (_e478[1][2] - _e483[0][2])), array<f32, 3>((_e492[1][0] - _e497[0][0]), (_e492[1][1] - _e497[0][1]), (_e492[1][2] - _e497[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e507[2][0] - _e512[3][0]), (_e507[2][1] - _e512[3][1]), (_e507[2][2] - _e512[3][2])), array<f32, 3>((_e521[2][0] - _e526[3][0]), (_e521[2][1] - _e526[3][1]), (_e521[2][2] - _e526[3][2]))), (_e358 + _e358));
                } else {
                    let _e360 = local_40;
                    let _e365 = local_40;
                    let _e374 = local_41;
                    let _e379 = local_41;
                    let _e389 = local_40;
                    let _e394 = local_40;
                    let _e403 = local_41;
                    let _e408 = local_41;
                    let _e418 = local_40;
                    let _e423 = local_40;
                    let _e432 = local_41;
                    let _e437 = local_41;
                    phi_1558_ = type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e360[0][0] - _e365[1][0]), (_e360[0][1] - _e365[1][1]), (_e360[0][2] - _e365[1][2])), array<f32, 3>((_e374[0][0] - _e379[1][0]), (_e374[0][1] - _e379[1][1]), (_e374[0][2] - _e379[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e389[2][0] - _e394[1][0]), (_e389[2][1] - _e394[1][1]), (_e389[2][2] - _e394[1][2])), array<f32, 3>((_e403[2][0] - _e408[1][0]), (_e403[2][1] - _e408[1][1]), (_e403[2][2] - _e408[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e418[3][0] - _e423[1][0]), (_e418[3][1] - _e423[1][1]), (_e418[3][2] - _e423[1][2])), array<f32, 3>((_e432[3][0] - _e437[1][0]), (_e432[3][1] - _e437[1][1]), (_e432[3][2] - _e437[1][2]))), (_e358 + _e358));
                }
                let _e539 = phi_1558_;
                let _e545 = select(_e539.member[0][0], -(_e539.member[0][0]), (_e539.member[0][0] < 0f));
                let _e549 = select(_e539.member[0][1], -(_e539.member[0][1]), (_e539.member[0][1] < 0f));
                let _e551 = select(_e549, _e545, (_e545 > _e549));
                let _e555 = select(_e539.member[0][2], -(_e539.member[0][2]), (_e539.member[0][2] < 0f));
                let _e557 = select(_e555, _e551, (_e551 > _e555));
                let _e563 = select(_e539.member[1][0], -(_e539.member[1][0]), (_e539.member[1][0] < 0f));
                let _e567 = select(_e539.member[1][1], -(_e539.member[1][1]), (_e539.member[1][1] < 0f));
                let _e569 = select(_e567, _e563, (_e563 > _e567));
                let _e573 = select(_e539.member[1][2], -(_e539.member[1][2]), (_e539.member[1][2] < 0f));
                let _e575 = select(_e573, _e569, (_e569 > _e573));
                let _e585 = select(_e539.member_1[0][0], -(_e539.member_1[0][0]), (_e539.member_1[0][0] < 0f));
                let _e589 = select(_e539.member_1[0][1], -(_e539.member_1[0][1]), (_e539.member_1[0][1] < 0f));
                let _e591 = select(_e589, _e585, (_e585 > _e589));
                let _e595 = select(_e539.member_1[0][2], -(_e539.member_1[0][2]), (_e539.member_1[0][2] < 0f));
                let _e597 = select(_e595, _e591, (_e591 > _e595));
                let _e603 = select(_e539.member_1[1][0], -(_e539.member_1[1][0]), (_e539.member_1[1][0] < 0f));
                let _e607 = select(_e539.member_1[1][1], -(_e539.member_1[1][1]), (_e539.member_1[1][1] < 0f));
                let _e609 = select(_e607, _e603, (_e603 > _e607));
                let _e613 = select(_e539.member_1[1][2], -(_e539.member_1[1][2]), (_e539.member_1[1][2] < 0f));
                let _e615 = select(_e613, _e609, (_e609 > _e613));
                let _e625 = select(_e539.member_2[0][0], -(_e539.member_2[0][0]), (_e539.member_2[0][0] < 0f));
                let _e629 = select(_e539.member_2[0][1], -(_e539.member_2[0][1]), (_e539.member_2[0][1] < 0f));
                let _e631 = select(_e629, _e625, (_e625 > _e629));
                let _e635 = select(_e539.member_2[0][2], -(_e539.member_2[0][2]), (_e539.member_2[0][2] < 0f));
                let _e637 = select(_e635, _e631, (_e631 > _e635));
                let _e643 = select(_e539.member_2[1][0], -(_e539.member_2[1][0]), (_e539.member_2[1][0] < 0f));
                let _e647 = select(_e539.member_2[1][1], -(_e539.member_2[1][1]), (_e539.member_2[1][1] < 0f));
                let _e649 = select(_e647, _e643, (_e643 > _e647));
                let _e653 = select(_e539.member_2[1][2], -(_e539.member_2[1][2]), (_e539.member_2[1][2] < 0f));
                let _e655 = select(_e653, _e649, (_e649 > _e653));
                let _e660 = function_1((select(_e575, _e557, (_e557 > _e575)) + _e539.member_3), (select(_e615, _e597, (_e597 > _e615)) + _e539.member_3));
                let _e661 = function_1(_e660, (select(_e655, _e637, (_e637 > _e655)) + _e539.member_3));
                let _e666 = bitcast<i32>(((bitcast<u32>(_e661) + 4u) >> bitcast<u32>(23i)));
                let _e667 = (_e666 >= 64i);
                let _e668 = (_e666 <= 190i);
                let _e674 = select(select(i32(), select(i32(), (_e666 - 126i), _e668), _e667), 2147483647i, select(true, select(true, false, _e668), _e667));
                let _e676 = params.member.member_2.member_3;
                if (_e676 > 0u) {
                    if (_e674 != 2147483647i) {
                        let _e680 = params.member.member.member_1;
                        if ((_e680 & 8u) != 0u) {
                            let _e920 = local_40;
                            let _e925 = bitcast<u32>(_e920[0][0]);
                            let _e926 = (_e925 & 2147483647u);
                            let _e927 = (_e926 < 8388608u);
                            let _e938 = function_16(array<u32, 2>(select((_e925 << bitcast<u32>(29i)), 0u, _e927), select(((_e925 ^ _e926) | ((_e926 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e927)), _e674);
                            let _e939 = bitcast<u32>(_e920[0][1]);
                            let _e940 = (_e939 & 2147483647u);
                            let _e941 = (_e940 < 8388608u);
                            let _e952 = function_16(array<u32, 2>(select((_e939 << bitcast<u32>(29i)), 0u, _e941), select(((_e939 ^ _e940) | ((_e940 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e941)), _e674);
                            let _e953 = bitcast<u32>(_e920[0][2]);
                            let _e954 = (_e953 & 2147483647u);
                            let _e955 = (_e954 < 8388608u);
                            let _e966 = function_16(array<u32, 2>(select((_e953 << bitcast<u32>(29i)), 0u, _e955), select(((_e953 ^ _e954) | ((_e954 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e955)), _e674);
                            let _e968 = local_41;
                            let _e973 = bitcast<u32>(_e968[0][0]);
                            let _e974 = (_e973 & 2147483647u);
                            let _e975 = (_e974 < 8388608u);
                            let _e986 = function_16(array<u32, 2>(select((_e973 << bitcast<u32>(29i)), 0u, _e975), select(((_e973 ^ _e974) | ((_e974 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e975)), _e674);
                            let _e987 = bitcast<u32>(_e968[0][1]);
                            let _e988 = (_e987 & 2147483647u);
                            let _e989 = (_e988 < 8388608u);
                            let _e1000 = function_16(array<u32, 2>(select((_e987 << bitcast<u32>(29i)), 0u, _e989), select(((_e987 ^ _e988) | ((_e988 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e989)), _e674);
                            let _e1001 = bitcast<u32>(_e968[0][2]);
                            let _e1002 = (_e1001 & 2147483647u);
                            let _e1003 = (_e1002 < 8388608u);
                            let _e1014 = function_16(array<u32, 2>(select((_e1001 << bitcast<u32>(29i)), 0u, _e1003), select(((_e1001 ^ _e1002) | ((_e1002 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1003)), _e674);
                            let _e1017 = local_40;
                            let _e1022 = bitcast<u32>(_e1017[1][0]);
                            let _e1023 = (_e1022 & 2147483647u);
                            let _e1024 = (_e1023 < 8388608u);
                            let _e1035 = function_16(array<u32, 2>(select((_e1022 << bitcast<u32>(29i)), 0u, _e1024), select(((_e1022 ^ _e1023) | ((_e1023 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1024)), _e674);
                            let _e1036 = bitcast<u32>(_e1017[1][1]);
                            let _e1037 = (_e1036 & 2147483647u);
                            let _e1038 = (_e1037 < 8388608u);
                            let _e1049 = function_16(array<u32, 2>(select((_e1036 << bitcast<u32>(29i)), 0u, _e1038), select(((_e1036 ^ _e1037) | ((_e1037 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1038)), _e674);
                            let _e1050 = bitcast<u32>(_e1017[1][2]);
                            let _e1051 = (_e1050 & 2147483647u);
                            let _e1052 = (_e1051 < 8388608u);
                            let _e1063 = function_16(array<u32, 2>(select((_e1050 << bitcast<u32>(29i)), 0u, _e1052), select(((_e1050 ^ _e1051) | ((_e1051 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1052)), _e674);
                            let _e1065 = local_41;
                            let _e1070 = bitcast<u32>(_e1065[1][0]);
                            let _e1071 = (_e1070 & 2147483647u);
                            let _e1072 = (_e1071 < 8388608u);
                            let _e1083 = function_16(array<u32, 2>(select((_e1070 << bitcast<u32>(29i)), 0u, _e1072), select(((_e1070 ^ _e1071) | ((_e1071 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1072)), _e674);
                            let _e1084 = bitcast<u32>(_e1065[1][1]);
                            let _e1085 = (_e1084 & 2147483647u);
                            let _e1086 = (_e1085 < 8388608u);
                            let _e1097 = function_16(array<u32, 2>(select((_e1084 << bitcast<u32>(29i)), 0u, _e1086), select(((_e1084 ^ _e1085) | ((_e1085 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1086)), _e674);
                            let _e1098 = bitcast<u32>(_e1065[1][2]);
                            let _e1099 = (_e1098 & 2147483647u);
                            let _e1100 = (_e1099 < 8388608u);
                            let _e1111 = function_16(array<u32, 2>(select((_e1098 << bitcast<u32>(29i)), 0u, _e1100), select(((_e1098 ^ _e1099) | ((_e1099 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1100)), _e674);
                            let _e1114 = local_40;
                            let _e1119 = bitcast<u32>(_e1114[2][0]);
                            let _e1120 = (_e1119 & 2147483647u);
                            let _e1121 = (_e1120 < 8388608u);
                            let _e1132 = function_16(array<u32, 2>(select((_e1119 << bitcast<u32>(29i)), 0u, _e1121), select(((_e1119 ^ _e1120) | ((_e1120 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1121)), _e674);
                            let _e1133 = bitcast<u32>(_e1114[2][1]);
                            let _e1134 = (_e1133 & 2147483647u);
                            let _e1135 = (_e1134 < 8388608u);
                            let _e1146 = function_16(array<u32, 2>(select((_e1133 << bitcast<u32>(29i)), 0u, _e1135), select(((_e1133 ^ _e1134) | ((_e1134 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1135)), _e674);
                            let _e1147 = bitcast<u32>(_e1114[2][2]);
                            let _e1148 = (_e1147 & 2147483647u);
                            let _e1149 = (_e1148 < 8388608u);
                            let _e1160 = function_16(array<u32, 2>(select((_e1147 << bitcast<u32>(29i)), 0u, _e1149), select(((_e1147 ^ _e1148) | ((_e1148 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1149)), _e674);
                            let _e1162 = local_41;
                            let _e1167 = bitcast<u32>(_e1162[2][0]);
                            let _e1168 = (_e1167 & 2147483647u);
                            let _e1169 = (_e1168 < 8388608u);
                            let _e1180 = function_16(array<u32, 2>(select((_e1167 << bitcast<u32>(29i)), 0u, _e1169), select(((_e1167 ^ _e1168) | ((_e1168 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1169)), _e674);
                            let _e1181 = bitcast<u32>(_e1162[2][1]);
                            let _e1182 = (_e1181 & 2147483647u);
                            let _e1183 = (_e1182 < 8388608u);
                            let _e1194 = function_16(array<u32, 2>(select((_e1181 << bitcast<u32>(29i)), 0u, _e1183), select(((_e1181 ^ _e1182) | ((_e1182 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1183)), _e674);
                            let _e1195 = bitcast<u32>(_e1162[2][2]);
                            let _e1196 = (_e1195 & 2147483647u);
                            let _e1197 = (_e1196 < 8388608u);
                            let _e1208 = function_16(array<u32, 2>(select((_e1195 << bitcast<u32>(29i)), 0u, _e1197), select(((_e1195 ^ _e1196) | ((_e1196 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1197)), _e674);
                            let _e1211 = local_40;
                            let _e1216 = bitcast<u32>(_e1211[3][0]);
                            let _e1217 = (_e1216 & 2147483647u);
                            let _e1218 = (_e1217 < 8388608u);
                            let _e1229 = function_16(array<u32, 2>(select((_e1216 << bitcast<u32>(29i)), 0u, _e1218), select(((_e1216 ^ _e1217) | ((_e1217 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1218)), _e674);
                            let _e1230 = bitcast<u32>(_e1211[3][1]);
                            let _e1231 = (_e1230 & 2147483647u);
                            let _e1232 = (_e1231 < 8388608u);
                            let _e1243 = function_16(array<u32, 2>(select((_e1230 << bitcast<u32>(29i)), 0u, _e1232), select(((_e1230 ^ _e1231) | ((_e1231 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1232)), _e674);
                            let _e1244 = bitcast<u32>(_e1211[3][2]);
                            let _e1245 = (_e1244 & 2147483647u);
                            let _e1246 = (_e1245 < 8388608u);
                            let _e1257 = function_16(array<u32, 2>(select((_e1244 << bitcast<u32>(29i)), 0u, _e1246), select(((_e1244 ^ _e1245) | ((_e1245 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1246)), _e674);
                            let _e1259 = local_41;
                            let _e1264 = bitcast<u32>(_e1259[3][0]);
                            let _e1265 = (_e1264 & 2147483647u);
                            let _e1266 = (_e1265 < 8388608u);
                            let _e1277 = function_16(array<u32, 2>(select((_e1264 << bitcast<u32>(29i)), 0u, _e1266), select(((_e1264 ^ _e1265) | ((_e1265 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1266)), _e674);
                            let _e1278 = bitcast<u32>(_e1259[3][1]);
                            let _e1279 = (_e1278 & 2147483647u);
                            let _e1280 = (_e1279 < 8388608u);
                            let _e1291 = function_16(array<u32, 2>(select((_e1278 << bitcast<u32>(29i)), 0u, _e1280), select(((_e1278 ^ _e1279) | ((_e1279 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1280)), _e674);
                            let _e1292 = bitcast<u32>(_e1259[3][2]);
                            let _e1293 = (_e1292 & 2147483647u);
                            let _e1294 = (_e1293 < 8388608u);
                            let _e1305 = function_16(array<u32, 2>(select((_e1292 << bitcast<u32>(29i)), 0u, _e1294), select(((_e1292 ^ _e1293) | ((_e1293 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1294)), _e674);
                            phi_3266_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e938, _e952, _e966), array<type_9, 3>(_e986, _e1000, _e1014)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1035, _e1049, _e1063), array<type_9, 3>(_e1083, _e1097, _e1111)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1132, _e1146, _e1160), array<type_9, 3>(_e1180, _e1194, _e1208)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1229, _e1243, _e1257), array<type_9, 3>(_e1277, _e1291, _e1305)));
                        } else {
                            let _e685 = params.member.member.member_10[1u];
                            let _e690 = (_e674 - (bitcast<i32>((_e685 >> bitcast<u32>(20i))) - 1023i));
                            let _e691 = local_39;
                            let _e695 = params.member.member.member[0u];
                            let _e697 = (6u * (_e695 + _e691[0]));
                            let _e698 = (6u * _e691[0]);
                            let _e700 = positions.member[_e698];
                            let _e703 = positions.member[(_e698 + 1u)];
                            let _e705 = function_16(array<u32, 2>(_e700, _e703), _e690);
                            let _e708 = positions.member[(_e698 + 2u)];
                            let _e711 = positions.member[(_e698 + 3u)];
                            let _e713 = function_16(array<u32, 2>(_e708, _e711), _e690);
                            let _e716 = positions.member[(_e698 + 4u)];
                            let _e719 = positions.member[(_e698 + 5u)];
                            let _e721 = function_16(array<u32, 2>(_e716, _e719), _e690);
                            let _e724 = positions.member[_e697];
                            let _e727 = positions.member[(_e697 + 1u)];
                            let _e729 = function_16(array<u32, 2>(_e724, _e727), _e690);
                            let _e732 = positions.member[(_e697 + 2u)];
                            let _e735 = positions.member[(_e697 + 3u)];
                            let _e737 = function_16(array<u32, 2>(_e732, _e735), _e690);
                            let _e740 = positions.member[(_e697 + 4u)];
                            let _e743 = positions.member[(_e697 + 5u)];
                            let _e745 = function_16(array<u32, 2>(_e740, _e743), _e690);
                            let _e748 = local_39;
                            let _e752 = params.member.member.member[0u];
                            let _e754 = (6u * (_e752 + _e748[1]));
                            let _e755 = (6u * _e748[1]);
                            let _e757 = positions.member[_e755];
                            let _e760 = positions.member[(_e755 + 1u)];
                            let _e762 = function_16(array<u32, 2>(_e757, _e760), _e690);
                            let _e765 = positions.member[(_e755 + 2u)];
                            let _e768 = positions.member[(_e755 + 3u)];
                            let _e770 = function_16(array<u32, 2>(_e765, _e768), _e690);
                            let _e773 = positions.member[(_e755 + 4u)];
                            let _e776 = positions.member[(_e755 + 5u)];
                            let _e778 = function_16(array<u32, 2>(_e773, _e776), _e690);
                            let _e781 = positions.member[_e754];
                            let _e784 = positions.member[(_e754 + 1u)];
                            let _e786 = function_16(array<u32, 2>(_e781, _e784), _e690);
                            let _e789 = positions.member[(_e754 + 2u)];
                            let _e792 = positions.member[(_e754 + 3u)];
                            let _e794 = function_16(array<u32, 2>(_e789, _e792), _e690);
                            let _e797 = positions.member[(_e754 + 4u)];
                            let _e800 = positions.member[(_e754 + 5u)];
                            let _e802 = function_16(array<u32, 2>(_e797, _e800), _e690);
                            let _e805 = local_39;
                            let _e809 = params.member.member.member[0u];
                            let _e811 = (6u * (_e809 + _e805[2]));
                            let _e812 = (6u * _e805[2]);
                            let _e814 = positions.member[_e812];
                            let _e817 = positions.member[(_e812 + 1u)];
                            let _e819 = function_16(array<u32, 2>(_e814, _e817), _e690);
                            let _e822 = positions.member[(_e812 + 2u)];
                            let _e825 = positions.member[(_e812 + 3u)];
                            let _e827 = function_16(array<u32, 2>(_e822, _e825), _e690);
                            let _e830 = positions.member[(_e812 + 4u)];
                            let _e833 = positions.member[(_e812 + 5u)];
                            let _e835 = function_16(array<u32, 2>(_e830, _e833), _e690);
                            let _e838 = positions.member[_e811];
                            let _e841 = positions.member[(_e811 + 1u)];
                            let _e843 = function_16(array<u32, 2>(_e838, _e841), _e690);
                            let _e846 = positions.member[(_e811 + 2u)];
                            let _e849 = positions.member[(_e811 + 3u)];
                            let _e851 = function_16(array<u32, 2>(_e846, _e849), _e690);
                            let _e854 = positions.member[(_e811 + 4u)];
                            let _e857 = positions.member[(_e811 + 5u)];
                            let _e859 = function_16(array<u32, 2>(_e854, _e857), _e690);
                            let _e862 = local_39;
                            let _e866 = params.member.member.member[0u];
                            let _e868 = (6u * (_e866 + _e862[3]));
                            let _e869 = (6u * _e862[3]);
                            let _e871 = positions.member[_e869];
                            let _e874 = positions.member[(_e869 + 1u)];
                            let _e876 = function_16(array<u32, 2>(_e871, _e874), _e690);
                            let _e879 = positions.member[(_e869 + 2u)];
                            let _e882 = positions.member[(_e869 + 3u)];
                            let _e884 = function_16(array<u32, 2>(_e879, _e882), _e690);
                            let _e887 = positions.member[(_e869 + 4u)];
                            let _e890 = positions.member[(_e869 + 5u)];
                            let _e892 = function_16(array<u32, 2>(_e887, _e890), _e690);
                            let _e895 = positions.member[_e868];
                            let _e898 = positions.member[(_e868 + 1u)];
                            let _e900 = function_16(array<u32, 2>(_e895, _e898), _e690);
                            let _e903 = positions.member[(_e868 + 2u)];
                            let _e906 = positions.member[(_e868 + 3u)];
                            let _e908 = function_16(array<u32, 2>(_e903, _e906), _e690);
                            let _e911 = positions.member[(_e868 + 4u)];
                            let _e914 = positions.member[(_e868 + 5u)];
                            let _e916 = function_16(array<u32, 2>(_e911, _e914), _e690);
                            phi_3266_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e705, _e713, _e721), array<type_9, 3>(_e729, _e737, _e745)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e762, _e770, _e778), array<type_9, 3>(_e786, _e794, _e802)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e819, _e827, _e835), array<type_9, 3>(_e843, _e851, _e859)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e876, _e884, _e892), array<type_9, 3>(_e900, _e908, _e916)));
                        }
                        let _e1310 = phi_3266_;
                        let _e1312 = params.member.member_2.member_1;
                        let _e1314 = params.member.member_2.member_2;
                        let _e1316 = params.member.member_2.member_3;
                        if (_e283.member != 0u) {
                            phi_3813_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1310[2][0][0].member - _e1310[0][0][0].member) - select(0u, 1u, (_e1310[2][0][0].member_1 < _e1310[0][0][0].member_1))), (_e1310[2][0][0].member_1 - _e1310[0][0][0].member_1)), type_9(((_e1310[2][0][1].member - _e1310[0][0][1].member) - select(0u, 1u, (_e1310[2][0][1].member_1 < _e1310[0][0][1].member_1))), (_e1310[2][0][1].member_1 - _e1310[0][0][1].member_1)), type_9(((_e1310[2][0][2].member - _e1310[0][0][2].member) - select(0u, 1u, (_e1310[2][0][2].member_1 < _e1310[0][0][2].member_1))), (_e1310[2][0][2].member_1 - _e1310[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1310[2][1][0].member - _e1310[0][1][0].member) - select(0u, 1u, (_e1310[2][1][0].member_1 < _e1310[0][1][0].member_1))), (_e1310[2][1][0].member_1 - _e1310[0][1][0].member_1)), type_9(((_e1310[2][1][1].member - _e1310[0][1][1].member) - select(0u, 1u, (_e1310[2][1][1].member_1 < _e1310[0][1][1].member_1))), (_e1310[2][1][1].member_1 - _e1310[0][1][1].member_1)), type_9(((_e1310[2][1][2].member - _e1310[0][1][2].member) - select(0u, 1u, (_e1310[2][1][2].member_1 < _e1310[0][1][2].member_1))), (_e1310[2][1][2].member_1 - _e1310[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1310[1][0][0].member - _e1310[0][0][0].member) - select(0u, 1u, (_e1310[1][0][0].member_1 < _e1310[0][0][0].member_1))), (_e1310[1][0][0].member_1 - _e1310[0][0][0].member_1)), type_9(((_e1310[1][0][1].member - _e1310[0][0][1].member) - select(0u, 1u, (_e1310[1][0][1].member_1 < _e1310[0][0][1].member_1))), (_e1310[1][0][1].member_1 - _e1310[0][0][1].member_1)), type_9(((_e1310[1][0][2].member - _e1310[0][0][2].member) - select(0u, 1u, (_e1310[1][0][2].member_1 < _e1310[0][0][2].member_1))), (_e1310[1][0][2].member_1 - _e1310[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1310[1][1][0].member - _e1310[0][1][0].member) - select(0u, 1u, (_e1310[1][1][0].member_1 < _e1310[0][1][0].member_1))), (_e1310[1][1][0].member_1 - _e1310[0][1][0].member_1)), type_9(((_e1310[1][1][1].member - _e1310[0][1][1].member) - select(0u, 1u, (_e1310[1][1][1].member_1 < _e1310[0][1][1].member_1))), (_e1310[1][1][1].member_1 - _e1310[0][1][1].member_1)), type_9(((_e1310[1][1][2].member - _e1310[0][1][2].member) - select(0u, 1u, (_e1310[1][1][2].member_1 < _e1310[0][1][2].member_1))), (_e1310[1][1][2].member_1 - _e1310[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1310[2][0][0].member - _e1310[3][0][0].member) - select(0u, 1u, (_e1310[2][0][0].member_1 < _e1310[3][0][0].member_1))), (_e1310[2][0][0].member_1 - _e1310[3][0][0].member_1)), type_9(((_e1310[2][0][1].member - _e1310[3][0][1].member) - select(0u, 1u, (_e1310[2][0][1].member_1 < _e1310[3][0][1].member_1))), (_e1310[2][0][1].member_1 - _e1310[3][0][1].member_1)), type_9(((_e1310[2][0][2].member - _e1310[3][0][2].member) - select(0u, 1u, (_e1310[2][0][2].member_1 < _e1310[3][0][2].member_1))), (_e1310[2][0][2].member_1 - _e1310[3][0][2].member_1))), array<type_9, 3>(type_9(((_e1310[2][1][0].member - _e1310[3][1][0].member) - select(0u, 1u, (_e1310[2][1][0].member_1 < _e1310[3][1][0].member_1))), (_e1310[2][1][0].member_1 - _e1310[3][1][0].member_1)), type_9(((_e1310[2][1][1].member - _e1310[3][1][1].member) - select(0u, 1u, (_e1310[2][1][1].member_1 < _e1310[3][1][1].member_1))), (_e1310[2][1][1].member_1 - _e1310[3][1][1].member_1)), type_9(((_e1310[2][1][2].member - _e1310[3][1][2].member) - select(0u, 1u, (_e1310[2][1][2].member_1 < _e1310[3][1][2].member_1))), (_e1310[2][1][2].member_1 - _e1310[3][1][2].member_1)))));
                        } else {
                            phi_3813_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1310[0][0][0].member - _e1310[1][0][0].member) - select(0u, 1u, (_e1310[0][0][0].member_1 < _e1310[1][0][0].member_1))), (_e1310[0][0][0].member_1 - _e1310[1][0][0].member_1)), type_9(((_e1310[0][0][1].member - _e1310[1][0][1].member) - select(0u, 1u, (_e1310[0][0][1].member_1 < _e1310[1][0][1].member_1))), (_e1310[0][0][1].member_1 - _e1310[1][0][1].member_1)), type_9(((_e1310[0][0][2].member - _e1310[1][0][2].member) - select(0u, 1u, (_e1310[0][0][2].member_1 < _e1310[1][0][2].member_1))), (_e1310[0][0][2].member_1 - _e1310[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1310[0][1][0].member - _e1310[1][1][0].member) - select(0u, 1u, (_e1310[0][1][0].member_1 < _e1310[1][1][0].member_1))), (_e1310[0][1][0].member_1 - _e1310[1][1][0].member_1)), type_9(((_e1310[0][1][1].member - _e1310[1][1][1].member) - select(0u, 1u, (_e1310[0][1][1].member_1 < _e1310[1][1][1].member_1))), (_e1310[0][1][1].member_1 - _e1310[1][1][1].member_1)), type_9(((_e1310[0][1][2].member - _e1310[1][1][2].member) - select(0u, 1u, (_e1310[0][1][2].member_1 < _e1310[1][1][2].member_1))), (_e1310[0][1][2].member_1 - _e1310[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1310[2][0][0].member - _e1310[1][0][0].member) - select(0u, 1u, (_e1310[2][0][0].member_1 < _e1310[1][0][0].member_1))), (_e1310[2][0][0].member_1 - _e1310[1][0][0].member_1)), type_9(((_e1310[2][0][1].member - _e1310[1][0][1].member) - select(0u, 1u, (_e1310[2][0][1].member_1 < _e1310[1][0][1].member_1))), (_e1310[2][0][1].member_1 - _e1310[1][0][1].member_1)), type_9(((_e1310[2][0][2].member - _e1310[1][0][2].member) - select(0u, 1u, (_e1310[2][0][2].member_1 < _e1310[1][0][2].member_1))), (_e1310[2][0][2].member_1 - _e1310[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1310[2][1][0].member - _e1310[1][1][0].member) - select(0u, 1u, (_e1310[2][1][0].member_1 < _e1310[1][1][0].member_1))), (_e1310[2][1][0].member_1 - _e1310[1][1][0].member_1)), type_9(((_e1310[2][1][1].member - _e1310[1][1][1].member) - select(0u, 1u, (_e1310[2][1][1].member_1 < _e1310[1][1][1].member_1))), (_e1310[2][1][1].member_1 - _e1310[1][1][1].member_1)), type_9(((_e1310[2][1][2].member - _e1310[1][1][2].member) - select(0u, 1u, (_e1310[2][1][2].member_1 < _e1310[1][1][2].member_1))), (_e1310[2][1][2].member_1 - _e1310[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1310[3][0][0].member - _e1310[1][0][0].member) - select(0u, 1u, (_e1310[3][0][0].member_1 < _e1310[1][0][0].member_1))), (_e1310[3][0][0].member_1 - _e1310[1][0][0].member_1)), type_9(((_e1310[3][0][1].member - _e1310[1][0][1].member) - select(0u, 1u, (_e1310[3][0][1].member_1 < _e1310[1][0][1].member_1))), (_e1310[3][0][1].member_1 - _e1310[1][0][1].member_1)), type_9(((_e1310[3][0][2].member - _e1310[1][0][2].member) - select(0u, 1u, (_e1310[3][0][2].member_1 < _e1310[1][0][2].member_1))), (_e1310[3][0][2].member_1 - _e1310[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1310[3][1][0].member - _e1310[1][1][0].member) - select(0u, 1u, (_e1310[3][1][0].member_1 < _e1310[1][1][0].member_1))), (_e1310[3][1][0].member_1 - _e1310[1][1][0].member_1)), type_9(((_e1310[3][1][1].member - _e1310[1][1][1].member) - select(0u, 1u, (_e1310[3][1][1].member_1 < _e1310[1][1][1].member_1))), (_e1310[3][1][1].member_1 - _e1310[1][1][1].member_1)), type_9(((_e1310[3][1][2].member - _e1310[1][1][2].member) - select(0u, 1u, (_e1310[3][1][2].member_1 < _e1310[1][1][2].member_1))), (_e1310[3][1][2].member_1 - _e1310[1][1][2].member_1)))));
                        }
                        let _e1891 = phi_3813_;
                        local_37 = array<type_9, 3>(type_9(_e1891[1][0][0].member, _e1891[1][0][0].member_1), type_9(_e1891[1][0][1].member, _e1891[1][0][1].member_1), type_9(_e1891[1][0][2].member, _e1891[1][0][2].member_1));
                        local_38 = array<type_9, 3>(type_9(_e1891[2][0][0].member, _e1891[2][0][0].member_1), type_9(_e1891[2][0][1].member, _e1891[2][0][1].member_1), type_9(_e1891[2][0][2].member, _e1891[2][0][2].member_1));
                        let _e1924 = local_37[1u].member;
                        let _e1926 = local_37[1u].member_1;
                        let _e1929 = local_38[2u].member;
                        let _e1931 = local_38[2u].member_1;
                        let _e1932 = function_11(_e1924, _e1926, _e1929, _e1931);
                        let _e1937 = local_37[2u].member;
                        let _e1939 = local_37[2u].member_1;
                        let _e1942 = local_38[1u].member;
                        let _e1944 = local_38[1u].member_1;
                        let _e1945 = function_11(_e1937, _e1939, _e1942, _e1944);
                        let _e1951 = ((_e1932.member - _e1945.member) - select(0u, 1u, (_e1932.member_1 < _e1945.member_1)));
                        let _e1952 = (_e1932.member_1 - _e1945.member_1);
                        local_35 = array<type_9, 3>(type_9(_e1891[1][0][0].member, _e1891[1][0][0].member_1), type_9(_e1891[1][0][1].member, _e1891[1][0][1].member_1), type_9(_e1891[1][0][2].member, _e1891[1][0][2].member_1));
                        local_36 = array<type_9, 3>(type_9(_e1891[2][0][0].member, _e1891[2][0][0].member_1), type_9(_e1891[2][0][1].member, _e1891[2][0][1].member_1), type_9(_e1891[2][0][2].member, _e1891[2][0][2].member_1));
                        let _e1981 = local_35[2u].member;
                        let _e1983 = local_35[2u].member_1;
                        let _e1986 = local_36[0u].member;
                        let _e1988 = local_36[0u].member_1;
                        let _e1989 = function_11(_e1981, _e1983, _e1986, _e1988);
                        let _e1994 = local_35[0u].member;
                        let _e1996 = local_35[0u].member_1;
                        let _e1999 = local_36[2u].member;
                        let _e2001 = local_36[2u].member_1;
                        let _e2002 = function_11(_e1994, _e1996, _e1999, _e2001);
                        let _e2008 = ((_e1989.member - _e2002.member) - select(0u, 1u, (_e1989.member_1 < _e2002.member_1)));
                        let _e2009 = (_e1989.member_1 - _e2002.member_1);
                        local_33 = array<type_9, 3>(type_9(_e1891[1][0][0].member, _e1891[1][0][0].member_1), type_9(_e1891[1][0][1].member, _e1891[1][0][1].member_1), type_9(_e1891[1][0][2].member, _e1891[1][0][2].member_1));
                        local_34 = array<type_9, 3>(type_9(_e1891[2][0][0].member, _e1891[2][0][0].member_1), type_9(_e1891[2][0][1].member, _e1891[2][0][1].member_1), type_9(_e1891[2][0][2].member, _e1891[2][0][2].member_1));
                        let _e2038 = local_33[0u].member;
                        let _e2040 = local_33[0u].member_1;
                        let _e2043 = local_34[1u].member;
                        let _e2045 = local_34[1u].member_1;
                        let _e2046 = function_11(_e2038, _e2040, _e2043, _e2045);
                        let _e2051 = local_33[1u].member;
                        let _e2053 = local_33[1u].member_1;
                        let _e2056 = local_34[0u].member;
                        let _e2058 = local_34[0u].member_1;
                        let _e2059 = function_11(_e2051, _e2053, _e2056, _e2058);
                        let _e2065 = ((_e2046.member - _e2059.member) - select(0u, 1u, (_e2046.member_1 < _e2059.member_1)));
                        let _e2066 = (_e2046.member_1 - _e2059.member_1);
                        local_31 = array<type_9, 3>(type_9(_e1891[1][1][0].member, _e1891[1][1][0].member_1), type_9(_e1891[1][1][1].member, _e1891[1][1][1].member_1), type_9(_e1891[1][1][2].member, _e1891[1][1][2].member_1));
                        local_32 = array<type_9, 3>(type_9(_e1891[2][1][0].member, _e1891[2][1][0].member_1), type_9(_e1891[2][1][1].member, _e1891[2][1][1].member_1), type_9(_e1891[2][1][2].member, _e1891[2][1][2].member_1));
                        let _e2099 = local_31[1u].member;
                        let _e2101 = local_31[1u].member_1;
                        let _e2104 = local_32[2u].member;
                        let _e2106 = local_32[2u].member_1;
                        let _e2107 = function_11(_e2099, _e2101, _e2104, _e2106);
                        let _e2112 = local_31[2u].member;
                        let _e2114 = local_31[2u].member_1;
                        let _e2117 = local_32[1u].member;
                        let _e2119 = local_32[1u].member_1;
                        let _e2120 = function_11(_e2112, _e2114, _e2117, _e2119);
                        let _e2126 = ((_e2107.member - _e2120.member) - select(0u, 1u, (_e2107.member_1 < _e2120.member_1)));
                        let _e2127 = (_e2107.member_1 - _e2120.member_1);
                        local_29 = array<type_9, 3>(type_9(_e1891[1][1][0].member, _e1891[1][1][0].member_1), type_9(_e1891[1][1][1].member, _e1891[1][1][1].member_1), type_9(_e1891[1][1][2].member, _e1891[1][1][2].member_1));
                        local_30 = array<type_9, 3>(type_9(_e1891[2][1][0].member, _e1891[2][1][0].member_1), type_9(_e1891[2][1][1].member, _e1891[2][1][1].member_1), type_9(_e1891[2][1][2].member, _e1891[2][1][2].member_1));
                        let _e2156 = local_29[2u].member;
                        let _e2158 = local_29[2u].member_1;
                        let _e2161 = local_30[0u].member;
                        let _e2163 = local_30[0u].member_1;
                        let _e2164 = function_11(_e2156, _e2158, _e2161, _e2163);
                        let _e2169 = local_29[0u].member;
                        let _e2171 = local_29[0u].member_1;
                        let _e2174 = local_30[2u].member;
                        let _e2176 = local_30[2u].member_1;
                        let _e2177 = function_11(_e2169, _e2171, _e2174, _e2176);
                        let _e2183 = ((_e2164.member - _e2177.member) - select(0u, 1u, (_e2164.member_1 < _e2177.member_1)));
                        let _e2184 = (_e2164.member_1 - _e2177.member_1);
                        local_27 = array<type_9, 3>(type_9(_e1891[1][1][0].member, _e1891[1][1][0].member_1), type_9(_e1891[1][1][1].member, _e1891[1][1][1].member_1), type_9(_e1891[1][1][2].member, _e1891[1][1][2].member_1));
                        local_28 = array<type_9, 3>(type_9(_e1891[2][1][0].member, _e1891[2][1][0].member_1), type_9(_e1891[2][1][1].member, _e1891[2][1][1].member_1), type_9(_e1891[2][1][2].member, _e1891[2][1][2].member_1));
                        let _e2213 = local_27[0u].member;
                        let _e2215 = local_27[0u].member_1;
                        let _e2218 = local_28[1u].member;
                        let _e2220 = local_28[1u].member_1;
                        let _e2221 = function_11(_e2213, _e2215, _e2218, _e2220);
                        let _e2226 = local_27[1u].member;
                        let _e2228 = local_27[1u].member_1;
                        let _e2231 = local_28[0u].member;
                        let _e2233 = local_28[0u].member_1;
                        let _e2234 = function_11(_e2226, _e2228, _e2231, _e2233);
                        let _e2240 = ((_e2221.member - _e2234.member) - select(0u, 1u, (_e2221.member_1 < _e2234.member_1)));
                        let _e2241 = (_e2221.member_1 - _e2234.member_1);
                        local_25 = array<type_9, 3>(type_9(_e1891[1][0][0].member, _e1891[1][0][0].member_1), type_9(_e1891[1][0][1].member, _e1891[1][0][1].member_1), type_9(_e1891[1][0][2].member, _e1891[1][0][2].member_1));
                        local_26 = array<type_9, 3>(type_9(_e1891[2][1][0].member, _e1891[2][1][0].member_1), type_9(_e1891[2][1][1].member, _e1891[2][1][1].member_1), type_9(_e1891[2][1][2].member, _e1891[2][1][2].member_1));
                        let _e2274 = local_25[1u].member;
                        let _e2276 = local_25[1u].member_1;
                        let _e2279 = local_26[2u].member;
                        let _e2281 = local_26[2u].member_1;
                        let _e2282 = function_11(_e2274, _e2276, _e2279, _e2281);
                        let _e2287 = local_25[2u].member;
                        let _e2289 = local_25[2u].member_1;
                        let _e2292 = local_26[1u].member;
                        let _e2294 = local_26[1u].member_1;
                        let _e2295 = function_11(_e2287, _e2289, _e2292, _e2294);
                        let _e2302 = (_e2282.member_1 - _e2295.member_1);
                        local_23 = array<type_9, 3>(type_9(_e1891[1][0][0].member, _e1891[1][0][0].member_1), type_9(_e1891[1][0][1].member, _e1891[1][0][1].member_1), type_9(_e1891[1][0][2].member, _e1891[1][0][2].member_1));
                        local_24 = array<type_9, 3>(type_9(_e1891[2][1][0].member, _e1891[2][1][0].member_1), type_9(_e1891[2][1][1].member, _e1891[2][1][1].member_1), type_9(_e1891[2][1][2].member, _e1891[2][1][2].member_1));
                        let _e2331 = local_23[2u].member;
                        let _e2333 = local_23[2u].member_1;
                        let _e2336 = local_24[0u].member;
                        let _e2338 = local_24[0u].member_1;
                        let _e2339 = function_11(_e2331, _e2333, _e2336, _e2338);
                        let _e2344 = local_23[0u].member;
                        let _e2346 = local_23[0u].member_1;
                        let _e2349 = local_24[2u].member;
                        let _e2351 = local_24[2u].member_1;
                        let _e2352 = function_11(_e2344, _e2346, _e2349, _e2351);
                        let _e2359 = (_e2339.member_1 - _e2352.member_1);
                        local_21 = array<type_9, 3>(type_9(_e1891[1][0][0].member, _e1891[1][0][0].member_1), type_9(_e1891[1][0][1].member, _e1891[1][0][1].member_1), type_9(_e1891[1][0][2].member, _e1891[1][0][2].member_1));
                        local_22 = array<type_9, 3>(type_9(_e1891[2][1][0].member, _e1891[2][1][0].member_1), type_9(_e1891[2][1][1].member, _e1891[2][1][1].member_1), type_9(_e1891[2][1][2].member, _e1891[2][1][2].member_1));
                        let _e2388 = local_21[0u].member;
                        let _e2390 = local_21[0u].member_1;
                        let _e2393 = local_22[1u].member;
                        let _e2395 = local_22[1u].member_1;
                        let _e2396 = function_11(_e2388, _e2390, _e2393, _e2395);
                        let _e2401 = local_21[1u].member;
                        let _e2403 = local_21[1u].member_1;
                        let _e2406 = local_22[0u].member;
                        let _e2408 = local_22[0u].member_1;
                        let _e2409 = function_11(_e2401, _e2403, _e2406, _e2408);
                        let _e2416 = (_e2396.member_1 - _e2409.member_1);
                        local_19 = array<type_9, 3>(type_9(_e1891[1][1][0].member, _e1891[1][1][0].member_1), type_9(_e1891[1][1][1].member, _e1891[1][1][1].member_1), type_9(_e1891[1][1][2].member, _e1891[1][1][2].member_1));
                        local_20 = array<type_9, 3>(type_9(_e1891[2][0][0].member, _e1891[2][0][0].member_1), type_9(_e1891[2][0][1].member, _e1891[2][0][1].member_1), type_9(_e1891[2][0][2].member, _e1891[2][0][2].member_1));
                        let _e2449 = local_19[1u].member;
                        let _e2451 = local_19[1u].member_1;
                        let _e2454 = local_20[2u].member;
                        let _e2456 = local_20[2u].member_1;
                        let _e2457 = function_11(_e2449, _e2451, _e2454, _e2456);
                        let _e2462 = local_19[2u].member;
                        let _e2464 = local_19[2u].member_1;
                        let _e2467 = local_20[1u].member;
                        let _e2469 = local_20[1u].member_1;
                        let _e2470 = function_11(_e2462, _e2464, _e2467, _e2469);
                        local_17 = array<type_9, 3>(type_9(_e1891[1][1][0].member, _e1891[1][1][0].member_1), type_9(_e1891[1][1][1].member, _e1891[1][1][1].member_1), type_9(_e1891[1][1][2].member, _e1891[1][1][2].member_1));
                        local_18 = array<type_9, 3>(type_9(_e1891[2][0][0].member, _e1891[2][0][0].member_1), type_9(_e1891[2][0][1].member, _e1891[2][0][1].member_1), type_9(_e1891[2][0][2].member, _e1891[2][0][2].member_1));
                        let _e2506 = local_17[2u].member;
                        let _e2508 = local_17[2u].member_1;
                        let _e2511 = local_18[0u].member;
                        let _e2513 = local_18[0u].member_1;
                        let _e2514 = function_11(_e2506, _e2508, _e2511, _e2513);
                        let _e2519 = local_17[0u].member;
                        let _e2521 = local_17[0u].member_1;
                        let _e2524 = local_18[2u].member;
                        let _e2526 = local_18[2u].member_1;
                        let _e2527 = function_11(_e2519, _e2521, _e2524, _e2526);
                        local_15 = array<type_9, 3>(type_9(_e1891[1][1][0].member, _e1891[1][1][0].member_1), type_9(_e1891[1][1][1].member, _e1891[1][1][1].member_1), type_9(_e1891[1][1][2].member, _e1891[1][1][2].member_1));
                        local_16 = array<type_9, 3>(type_9(_e1891[2][0][0].member, _e1891[2][0][0].member_1), type_9(_e1891[2][0][1].member, _e1891[2][0][1].member_1), type_9(_e1891[2][0][2].member, _e1891[2][0][2].member_1));
                        let _e2563 = local_15[0u].member;
                        let _e2565 = local_15[0u].member_1;
                        let _e2568 = local_16[1u].member;
                        let _e2570 = local_16[1u].member_1;
                        let _e2571 = function_11(_e2563, _e2565, _e2568, _e2570);
                        let _e2576 = local_15[1u].member;
                        let _e2578 = local_15[1u].member_1;
                        let _e2581 = local_16[0u].member;
                        let _e2583 = local_16[0u].member_1;
                        let _e2584 = function_11(_e2576, _e2578, _e2581, _e2583);
                        let _e2592 = (_e2302 + (_e2457.member_1 - _e2470.member_1));
                        let _e2596 = ((((_e2282.member - _e2295.member) - select(0u, 1u, (_e2282.member_1 < _e2295.member_1))) + ((_e2457.member - _e2470.member) - select(0u, 1u, (_e2457.member_1 < _e2470.member_1)))) + select(0u, 1u, (_e2592 < _e2302)));
                        let _e2597 = (_e2359 + (_e2514.member_1 - _e2527.member_1));
                        let _e2601 = ((((_e2339.member - _e2352.member) - select(0u, 1u, (_e2339.member_1 < _e2352.member_1))) + ((_e2514.member - _e2527.member) - select(0u, 1u, (_e2514.member_1 < _e2527.member_1)))) + select(0u, 1u, (_e2597 < _e2359)));
                        let _e2602 = (_e2416 + (_e2571.member_1 - _e2584.member_1));
                        let _e2606 = ((((_e2396.member - _e2409.member) - select(0u, 1u, (_e2396.member_1 < _e2409.member_1))) + ((_e2571.member - _e2584.member) - select(0u, 1u, (_e2571.member_1 < _e2584.member_1)))) + select(0u, 1u, (_e2602 < _e2416)));
                        let _e2613 = function_11(_e1891[0][0][0].member, _e1891[0][0][0].member_1, _e1951, _e1952);
                        let _e2620 = function_11(_e1891[0][0][1].member, _e1891[0][0][1].member_1, _e2008, _e2009);
                        let _e2623 = (_e2613.member_1 + _e2620.member_1);
                        let _e2632 = function_11(_e1891[0][0][2].member, _e1891[0][0][2].member_1, _e2065, _e2066);
                        let _e2635 = (_e2623 + _e2632.member_1);
                        let _e2640 = function_15(((((_e2613.member + _e2620.member) + select(0u, 1u, (_e2623 < _e2613.member_1))) + _e2632.member) + select(0u, 1u, (_e2635 < _e2623))), _e2635);
                        let _e2649 = function_11(_e1891[0][1][0].member, _e1891[0][1][0].member_1, _e1951, _e1952);
                        let _e2656 = function_11(_e1891[0][1][1].member, _e1891[0][1][1].member_1, _e2008, _e2009);
                        let _e2659 = (_e2649.member_1 + _e2656.member_1);
                        let _e2668 = function_11(_e1891[0][1][2].member, _e1891[0][1][2].member_1, _e2065, _e2066);
                        let _e2671 = (_e2659 + _e2668.member_1);
                        let _e2682 = function_11(_e1891[0][0][0].member, _e1891[0][0][0].member_1, _e2596, _e2592);
                        let _e2689 = function_11(_e1891[0][0][1].member, _e1891[0][0][1].member_1, _e2601, _e2597);
                        let _e2692 = (_e2682.member_1 + _e2689.member_1);
                        let _e2701 = function_11(_e1891[0][0][2].member, _e1891[0][0][2].member_1, _e2606, _e2602);
                        let _e2704 = (_e2692 + _e2701.member_1);
                        let _e2709 = (_e2671 + _e2704);
                        let _e2713 = ((((((_e2649.member + _e2656.member) + select(0u, 1u, (_e2659 < _e2649.member_1))) + _e2668.member) + select(0u, 1u, (_e2671 < _e2659))) + ((((_e2682.member + _e2689.member) + select(0u, 1u, (_e2692 < _e2682.member_1))) + _e2701.member) + select(0u, 1u, (_e2704 < _e2692)))) + select(0u, 1u, (_e2709 < _e2671)));
                        let _e2720 = function_11(_e1891[0][0][0].member, _e1891[0][0][0].member_1, _e2126, _e2127);
                        let _e2727 = function_11(_e1891[0][0][1].member, _e1891[0][0][1].member_1, _e2183, _e2184);
                        let _e2730 = (_e2720.member_1 + _e2727.member_1);
                        let _e2739 = function_11(_e1891[0][0][2].member, _e1891[0][0][2].member_1, _e2240, _e2241);
                        let _e2742 = (_e2730 + _e2739.member_1);
                        let _e2753 = function_11(_e1891[0][1][0].member, _e1891[0][1][0].member_1, _e2596, _e2592);
                        let _e2760 = function_11(_e1891[0][1][1].member, _e1891[0][1][1].member_1, _e2601, _e2597);
                        let _e2763 = (_e2753.member_1 + _e2760.member_1);
                        let _e2772 = function_11(_e1891[0][1][2].member, _e1891[0][1][2].member_1, _e2606, _e2602);
                        let _e2775 = (_e2763 + _e2772.member_1);
                        let _e2780 = (_e2742 + _e2775);
                        let _e2784 = ((((((_e2720.member + _e2727.member) + select(0u, 1u, (_e2730 < _e2720.member_1))) + _e2739.member) + select(0u, 1u, (_e2742 < _e2730))) + ((((_e2753.member + _e2760.member) + select(0u, 1u, (_e2763 < _e2753.member_1))) + _e2772.member) + select(0u, 1u, (_e2775 < _e2763)))) + select(0u, 1u, (_e2780 < _e2742)));
                        let _e2791 = function_11(_e1891[0][1][0].member, _e1891[0][1][0].member_1, _e2126, _e2127);
                        let _e2798 = function_11(_e1891[0][1][1].member, _e1891[0][1][1].member_1, _e2183, _e2184);
                        let _e2801 = (_e2791.member_1 + _e2798.member_1);
                        let _e2810 = function_11(_e1891[0][1][2].member, _e1891[0][1][2].member_1, _e2240, _e2241);
                        let _e2813 = (_e2801 + _e2810.member_1);
                        let _e2818 = function_15(((((_e2791.member + _e2798.member) + select(0u, 1u, (_e2801 < _e2791.member_1))) + _e2810.member) + select(0u, 1u, (_e2813 < _e2801))), _e2813);
                        let _e2828 = select((bitcast<u32>(31i) - firstLeadingBit(_e1316)), 32u, (_e1316 == 0u));
                        let _e2830 = select(18u, _e2828, (18u < _e2828));
                        phi_5117_ = type_9(0u, 128u);
                        phi_5120_ = array<type_9, 4>(_e2640, type_9(_e2713, _e2709), type_9(_e2784, _e2780), _e2818);
                        phi_5122_ = false;
                        phi_5124_ = false;
                        phi_5128_ = 0u;
                        phi_5130_ = 0u;
                        loop {
                            let _e2832 = phi_5117_;
                            let _e2834 = phi_5120_;
                            let _e2836 = phi_5122_;
                            let _e2838 = phi_5124_;
                            let _e2840 = phi_5128_;
                            let _e2842 = phi_5130_;
                            let _e2845 = (_e2832.member < _e2832.member_1);
                            if (bitcast<i32>(select(0u, 1u, _e2845)) != 0i) {
                                let _e2857 = (31u - _e2840);
                                let _e2860 = (_e2842 << bitcast<u32>((_e2857 & 31u)));
                                let _e2864 = ((_e2842 + 1u) << bitcast<u32>((_e2857 & 31u)));
                                let _e2865 = (_e2860 > _e1314);
                                if _e2865 {
                                    phi_8876_ = array<type_9, 4>();
                                    phi_8877_ = bool();
                                    phi_8878_ = bool();
                                    phi_8880_ = u32();
                                    phi_8881_ = u32();
                                    phi_8882_ = type_20();
                                    phi_8883_ = false;
                                    phi_8884_ = false;
                                    phi_8885_ = false;
                                    phi_8886_ = false;
                                } else {
                                    if (_e2864 < _e1312) {
                                        phi_5350_ = true;
                                    } else {
                                        let _e2871 = function_14(128u);
                                        let _e2876 = ((_e2834[0].member >> bitcast<u32>(31i)) != 0u);
                                        let _e2904 = function_14(128u);
                                        let _e2909 = ((_e2834[1].member >> bitcast<u32>(31i)) != 0u);
                                        let _e2938 = function_14(128u);
                                        let _e2943 = ((_e2834[2].member >> bitcast<u32>(31i)) != 0u);
                                        let _e2972 = function_14(128u);
                                        let _e2977 = ((_e2834[3].member >> bitcast<u32>(31i)) != 0u);
                                        phi_5350_ = ((((select(0u, select(1u, 2u, ((_e2834[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2871.member - select(_e2834[0].member, (~(_e2834[0].member) + select(0u, 1u, (_e2834[0].member_1 == 0u))), _e2876)) - select(0u, 1u, (_e2871.member_1 < select(_e2834[0].member_1, (~(_e2834[0].member_1) + 1u), _e2876)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e2834[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e2904.member - select(_e2834[1].member, (~(_e2834[1].member) + select(0u, 1u, (_e2834[1].member_1 == 0u))), _e2909)) - select(0u, 1u, (_e2904.member_1 < select(_e2834[1].member_1, (~(_e2834[1].member_1) + 1u), _e2909)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2834[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e2938.member - select(_e2834[2].member, (~(_e2834[2].member) + select(0u, 1u, (_e2834[2].member_1 == 0u))), _e2943)) - select(0u, 1u, (_e2938.member_1 < select(_e2834[2].member_1, (~(_e2834[2].member_1) + 1u), _e2943)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2834[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e2972.member - select(_e2834[3].member, (~(_e2834[3].member) + select(0u, 1u, (_e2834[3].member_1 == 0u))), _e2977)) - select(0u, 1u, (_e2972.member_1 < select(_e2834[3].member_1, (~(_e2834[3].member_1) + 1u), _e2977)))) >> bitcast<u32>(31i)) != 0u))) != 0u);
                                    }
                                    let _e3004 = phi_5350_;
                                    if _e3004 {
                                        phi_8551_ = _e2834;
                                        phi_8552_ = _e2836;
                                        phi_8553_ = _e2838;
                                        phi_8555_ = _e3004;
                                        phi_8556_ = _e2840;
                                        phi_8557_ = _e2842;
                                        phi_8558_ = type_20();
                                        phi_8559_ = true;
                                        phi_8560_ = false;
                                        phi_8561_ = false;
                                    } else {
                                        let _e3005 = (_e2840 == 31u);
                                        let _e3010 = function_14(128u);
                                        let _e3015 = ((_e2834[0].member >> bitcast<u32>(31i)) != 0u);
                                        let _e3038 = select(0u, select(1u, 2u, ((_e2834[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3010.member - select(_e2834[0].member, (~(_e2834[0].member) + select(0u, 1u, (_e2834[0].member_1 == 0u))), _e3015)) - select(0u, 1u, (_e3010.member_1 < select(_e2834[0].member_1, (~(_e2834[0].member_1) + 1u), _e3015)))) >> bitcast<u32>(31i)) != 0u));
                                        let _e3043 = function_14(128u);
                                        let _e3048 = ((_e2834[1].member >> bitcast<u32>(31i)) != 0u);
                                        let _e3071 = select(0u, select(1u, 2u, ((_e2834[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e3043.member - select(_e2834[1].member, (~(_e2834[1].member) + select(0u, 1u, (_e2834[1].member_1 == 0u))), _e3048)) - select(0u, 1u, (_e3043.member_1 < select(_e2834[1].member_1, (~(_e2834[1].member_1) + 1u), _e3048)))) >> bitcast<u32>(31i)) != 0u));
                                        let _e3076 = function_14(128u);
                                        let _e3081 = ((_e2834[2].member >> bitcast<u32>(31i)) != 0u);
                                        let _e3104 = select(0u, select(1u, 2u, ((_e2834[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e3076.member - select(_e2834[2].member, (~(_e2834[2].member) + select(0u, 1u, (_e2834[2].member_1 == 0u))), _e3081)) - select(0u, 1u, (_e3076.member_1 < select(_e2834[2].member_1, (~(_e2834[2].member_1) + 1u), _e3081)))) >> bitcast<u32>(31i)) != 0u));
                                        let _e3109 = function_14(128u);
                                        let _e3114 = ((_e2834[3].member >> bitcast<u32>(31i)) != 0u);
                                        let _e3137 = select(0u, select(1u, 2u, ((_e2834[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e3109.member - select(_e2834[3].member, (~(_e2834[3].member) + select(0u, 1u, (_e2834[3].member_1 == 0u))), _e3114)) - select(0u, 1u, (_e3109.member_1 < select(_e2834[3].member_1, (~(_e2834[3].member_1) + 1u), _e3114)))) >> bitcast<u32>(31i)) != 0u));
                                        let _e3147 = select(false, select(true, select(false, (_e3071 != 0u), (_e3104 == _e3137)), select(true, (_e3104 == 0u), (_e3071 == _e3038))), ((_e3038 | _e3137) == 3u));
                                        let _e3148 = (_e2840 == 3u);
                                        let _e3149 = (_e2840 == 8u);
                                        if select(select(select(select(false, select(true, false, _e2838), _e3147), true, select(select(select((_e2840 == 14u), bool(), _e3149), bool(), _e3148), true, select(_e3149, true, _e3148))), false, _e2836), true, _e3005) {
                                            let _e3160 = type_20(_e2860, _e2864, _e2840);
                                            let _e3165 = function_14(128u);
                                            let _e3170 = ((_e2834[0].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3198 = function_14(128u);
                                            let _e3203 = ((_e2834[3].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3228 = ((select(0u, select(1u, 2u, ((_e2834[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3165.member - select(_e2834[0].member, (~(_e2834[0].member) + select(0u, 1u, (_e2834[0].member_1 == 0u))), _e3170)) - select(0u, 1u, (_e3165.member_1 < select(_e2834[0].member_1, (~(_e2834[0].member_1) + 1u), _e3170)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e2834[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e3198.member - select(_e2834[3].member, (~(_e2834[3].member) + select(0u, 1u, (_e2834[3].member_1 == 0u))), _e3203)) - select(0u, 1u, (_e3198.member_1 < select(_e2834[3].member_1, (~(_e2834[3].member_1) + 1u), _e3203)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                            if _e3147 {
                                                if (_e2840 < _e2830) {
                                                    let _e3238 = ((f32(bitcast<i32>(_e2834[0].member)) * 4294967300f) + f32(_e2834[0].member_1));
                                                    let _e3247 = ((f32(bitcast<i32>(_e2834[1].member)) * 4294967300f) + f32(_e2834[1].member_1));
                                                    let _e3256 = ((f32(bitcast<i32>(_e2834[2].member)) * 4294967300f) + f32(_e2834[2].member_1));
                                                    let _e3265 = ((f32(bitcast<i32>(_e2834[3].member)) * 4294967300f) + f32(_e2834[3].member_1));
                                                    phi_5722_ = type_14(0i, 4i);
                                                    phi_5725_ = (_e3238 / (_e3238 - _e3265));
                                                    loop {
                                                        let _e3269 = phi_5722_;
                                                        let _e3271 = phi_5725_;
                                                        local_42 = _e3271;
                                                        if (_e3269.member < _e3269.member_1) {
                                                            let _e3278 = (_e3269.member + 1i);
                                                            phi_5723_ = type_14(select(_e3278, type_15().member_1, select(false, true, ((false == (_e3278 > _e3269.member)) != false))), _e3269.member_1);
                                                            phi_5766_ = type_15(1u, _e3269.member);
                                                        } else {
                                                            phi_5723_ = _e3269;
                                                            phi_5766_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e3289 = phi_5723_;
                                                        let _e3291 = phi_5766_;
                                                        let _e3294 = (bitcast<i32>(_e3291.member) != 0i);
                                                        if _e3294 {
                                                            let _e3295 = function_13(_e3238, _e3247, _e3271);
                                                            let _e3296 = function_13(_e3247, _e3256, _e3271);
                                                            let _e3297 = function_13(_e3256, _e3265, _e3271);
                                                            let _e3298 = function_13(_e3295, _e3296, _e3271);
                                                            let _e3299 = function_13(_e3296, _e3297, _e3271);
                                                            let _e3300 = function_13(_e3298, _e3299, _e3271);
                                                            let _e3305 = function_1((_e3271 - (_e3300 / (3f * (_e3299 - _e3298)))), 0f);
                                                            let _e3306 = function_(_e3305, 1f);
                                                            phi_5726_ = _e3306;
                                                        } else {
                                                            phi_5726_ = f32();
                                                        }
                                                        let _e3308 = phi_5726_;
                                                        continue;
                                                        continuing {
                                                            phi_5722_ = _e3289;
                                                            phi_5725_ = _e3308;
                                                            break if !(_e3294);
                                                        }
                                                    }
                                                    let _e3313 = (1u << bitcast<u32>(((31u - _e2830) & 31u)));
                                                    let _e3314 = (_e2864 - _e2860);
                                                    let _e3317 = local_42;
                                                    let _e3318 = (_e3317 * f32(_e3314));
                                                    let _e3323 = select(select(u32(_e3318), 0u, (_e3318 < 0f)), 4294967295u, (_e3318 > 4294967000f));
                                                    let _e3325 = select(_e3323, _e3314, (_e3314 < _e3323));
                                                    let _e3326 = (_e2860 + _e3325);
                                                    let _e3332 = function_7(((_e2713 - _e2640.member) - select(0u, 1u, (_e2709 < _e2640.member_1))), (_e2709 - _e2640.member_1), _e3326);
                                                    let _e3335 = (_e2640.member_1 + _e3332.member_1);
                                                    let _e3339 = ((_e2640.member + _e3332.member) + select(0u, 1u, (_e3335 < _e2640.member_1)));
                                                    let _e3345 = function_7(((_e2784 - _e2713) - select(0u, 1u, (_e2780 < _e2709))), (_e2780 - _e2709), _e3326);
                                                    let _e3348 = (_e2709 + _e3345.member_1);
                                                    let _e3352 = ((_e2713 + _e3345.member) + select(0u, 1u, (_e3348 < _e2709)));
                                                    let _e3358 = function_7(((_e2818.member - _e2784) - select(0u, 1u, (_e2818.member_1 < _e2780))), (_e2818.member_1 - _e2780), _e3326);
                                                    let _e3361 = (_e2780 + _e3358.member_1);
                                                    let _e3371 = function_7(((_e3352 - _e3339) - select(0u, 1u, (_e3348 < _e3335))), (_e3348 - _e3335), _e3326);
                                                    let _e3374 = (_e3335 + _e3371.member_1);
                                                    let _e3378 = ((_e3339 + _e3371.member) + select(0u, 1u, (_e3374 < _e3335)));
                                                    let _e3384 = function_7(((((_e2784 + _e3358.member) + select(0u, 1u, (_e3361 < _e2780))) - _e3352) - select(0u, 1u, (_e3361 < _e3348))), (_e3361 - _e3348), _e3326);
                                                    let _e3387 = (_e3348 + _e3384.member_1);
                                                    let _e3397 = function_7(((((_e3352 + _e3384.member) + select(0u, 1u, (_e3387 < _e3348))) - _e3378) - select(0u, 1u, (_e3387 < _e3374))), (_e3387 - _e3374), _e3326);
                                                    let _e3400 = (_e3374 + _e3397.member_1);
                                                    let _e3404 = ((_e3378 + _e3397.member) + select(0u, 1u, (_e3400 < _e3374)));
                                                    let _e3405 = function_14(128u);
                                                    let _e3410 = ((_e3404 >> bitcast<u32>(31i)) != 0u);
                                                    let _e3430 = select(0u, select(1u, 2u, ((_e3404 >> bitcast<u32>(31i)) != 0u)), ((((_e3405.member - select(_e3404, (~(_e3404) + select(0u, 1u, (_e3400 == 0u))), _e3410)) - select(0u, 1u, (_e3405.member_1 < select(_e3400, (~(_e3400) + 1u), _e3410)))) >> bitcast<u32>(31i)) != 0u));
                                                    let _e3435 = function_14(128u);
                                                    let _e3440 = ((_e2834[0].member >> bitcast<u32>(31i)) != 0u);
                                                    let _e3464 = (_e3430 == select(0u, select(1u, 2u, ((_e2834[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3435.member - select(_e2834[0].member, (~(_e2834[0].member) + select(0u, 1u, (_e2834[0].member_1 == 0u))), _e3440)) - select(0u, 1u, (_e3435.member_1 < select(_e2834[0].member_1, (~(_e2834[0].member_1) + 1u), _e3440)))) >> bitcast<u32>(31i)) != 0u)));
                                                    let _e3465 = (_e3314 - _e3325);
                                                    let _e3472 = select((_e3326 - select(_e3313, _e3325, (_e3325 < _e3313))), (_e3326 + select(_e3313, _e3465, (_e3465 < _e3313))), _e3464);
                                                    let _e3478 = function_7(((_e2713 - _e2640.member) - select(0u, 1u, (_e2709 < _e2640.member_1))), (_e2709 - _e2640.member_1), _e3472);
                                                    let _e3481 = (_e2640.member_1 + _e3478.member_1);
                                                    let _e3485 = ((_e2640.member + _e3478.member) + select(0u, 1u, (_e3481 < _e2640.member_1)));
                                                    let _e3491 = function_7(((_e2784 - _e2713) - select(0u, 1u, (_e2780 < _e2709))), (_e2780 - _e2709), _e3472);
                                                    let _e3494 = (_e2709 + _e3491.member_1);
                                                    let _e3498 = ((_e2713 + _e3491.member) + select(0u, 1u, (_e3494 < _e2709)));
                                                    let _e3504 = function_7(((_e2818.member - _e2784) - select(0u, 1u, (_e2818.member_1 < _e2780))), (_e2818.member_1 - _e2780), _e3472);
                                                    let _e3507 = (_e2780 + _e3504.member_1);
                                                    let _e3517 = function_7(((_e3498 - _e3485) - select(0u, 1u, (_e3494 < _e3481))), (_e3494 - _e3481), _e3472);
                                                    let _e3520 = (_e3481 + _e3517.member_1);
                                                    let _e3524 = ((_e3485 + _e3517.member) + select(0u, 1u, (_e3520 < _e3481)));
                                                    let _e3530 = function_7(((((_e2784 + _e3504.member) + select(0u, 1u, (_e3507 < _e2780))) - _e3498) - select(0u, 1u, (_e3507 < _e3494))), (_e3507 - _e3494), _e3472);
                                                    let _e3533 = (_e3494 + _e3530.member_1);
                                                    let _e3543 = function_7(((((_e3498 + _e3530.member) + select(0u, 1u, (_e3533 < _e3494))) - _e3524) - select(0u, 1u, (_e3533 < _e3520))), (_e3533 - _e3520), _e3472);
                                                    let _e3546 = (_e3520 + _e3543.member_1);
                                                    let _e3550 = ((_e3524 + _e3543.member) + select(0u, 1u, (_e3546 < _e3520)));
                                                    let _e3551 = function_14(128u);
                                                    let _e3556 = ((_e3550 >> bitcast<u32>(31i)) != 0u);
                                                    let _e3578 = ((_e3430 | select(0u, select(1u, 2u, ((_e3550 >> bitcast<u32>(31i)) != 0u)), ((((_e3551.member - select(_e3550, (~(_e3550) + select(0u, 1u, (_e3546 == 0u))), _e3556)) - select(0u, 1u, (_e3551.member_1 < select(_e3546, (~(_e3546) + 1u), _e3556)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                                    phi_6211_ = _e3578;
                                                    phi_6212_ = type_20(select(_e2860, select(_e3472, _e3326, _e3464), _e3578), select(_e2864, select(_e3326, _e3472, _e3464), _e3578), select(_e2840, _e2830, _e3578));
                                                    phi_6213_ = false;
                                                } else {
                                                    phi_6211_ = bool();
                                                    phi_6212_ = type_20();
                                                    phi_6213_ = true;
                                                }
                                                let _e3586 = phi_6211_;
                                                let _e3588 = phi_6212_;
                                                let _e3590 = phi_6213_;
                                                phi_6214_ = _e3586;
                                                phi_6215_ = _e3588;
                                                phi_6216_ = _e3590;
                                            } else {
                                                phi_6214_ = bool();
                                                phi_6215_ = type_20();
                                                phi_6216_ = true;
                                            }
                                            let _e3592 = phi_6214_;
                                            let _e3594 = phi_6215_;
                                            let _e3596 = phi_6216_;
                                            if _e3596 {
                                                if _e3005 {
                                                    if _e3228 {
                                                        phi_6452_ = _e3228;
                                                        phi_6453_ = _e3160;
                                                    } else {
                                                        let _e3601 = select((bitcast<u32>(31i) - firstLeadingBit(_e1316)), 32u, (_e1316 == 0u));
                                                        let _e3606 = (_e2860 + (1u << bitcast<u32>(((31u - _e3601) & 31u))));
                                                        if (_e3606 <= 2147483648u) {
                                                            let _e3613 = function_14(128u);
                                                            let _e3618 = ((_e2834[0].member >> bitcast<u32>(31i)) != 0u);
                                                            let _e3647 = function_7(((_e2713 - _e2640.member) - select(0u, 1u, (_e2709 < _e2640.member_1))), (_e2709 - _e2640.member_1), _e3606);
                                                            let _e3650 = (_e2640.member_1 + _e3647.member_1);
                                                            let _e3654 = ((_e2640.member + _e3647.member) + select(0u, 1u, (_e3650 < _e2640.member_1)));
                                                            let _e3660 = function_7(((_e2784 - _e2713) - select(0u, 1u, (_e2780 < _e2709))), (_e2780 - _e2709), _e3606);
                                                            let _e3663 = (_e2709 + _e3660.member_1);
                                                            let _e3667 = ((_e2713 + _e3660.member) + select(0u, 1u, (_e3663 < _e2709)));
                                                            let _e3673 = function_7(((_e2818.member - _e2784) - select(0u, 1u, (_e2818.member_1 < _e2780))), (_e2818.member_1 - _e2780), _e3606);
                                                            let _e3676 = (_e2780 + _e3673.member_1);
                                                            let _e3686 = function_7(((_e3667 - _e3654) - select(0u, 1u, (_e3663 < _e3650))), (_e3663 - _e3650), _e3606);
                                                            let _e3689 = (_e3650 + _e3686.member_1);
                                                            let _e3693 = ((_e3654 + _e3686.member) + select(0u, 1u, (_e3689 < _e3650)));
                                                            let _e3699 = function_7(((((_e2784 + _e3673.member) + select(0u, 1u, (_e3676 < _e2780))) - _e3667) - select(0u, 1u, (_e3676 < _e3663))), (_e3676 - _e3663), _e3606);
                                                            let _e3702 = (_e3663 + _e3699.member_1);
                                                            let _e3712 = function_7(((((_e3667 + _e3699.member) + select(0u, 1u, (_e3702 < _e3663))) - _e3693) - select(0u, 1u, (_e3702 < _e3689))), (_e3702 - _e3689), _e3606);
                                                            let _e3715 = (_e3689 + _e3712.member_1);
                                                            let _e3719 = ((_e3693 + _e3712.member) + select(0u, 1u, (_e3715 < _e3689)));
                                                            let _e3720 = function_14(128u);
                                                            let _e3725 = ((_e3719 >> bitcast<u32>(31i)) != 0u);
                                                            phi_6451_ = ((select(0u, select(1u, 2u, ((_e2834[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3613.member - select(_e2834[0].member, (~(_e2834[0].member) + select(0u, 1u, (_e2834[0].member_1 == 0u))), _e3618)) - select(0u, 1u, (_e3613.member_1 < select(_e2834[0].member_1, (~(_e2834[0].member_1) + 1u), _e3618)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e3719 >> bitcast<u32>(31i)) != 0u)), ((((_e3720.member - select(_e3719, (~(_e3719) + select(0u, 1u, (_e3715 == 0u))), _e3725)) - select(0u, 1u, (_e3720.member_1 < select(_e3715, (~(_e3715) + 1u), _e3725)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                                        } else {
                                                            phi_6451_ = false;
                                                        }
                                                        let _e3749 = phi_6451_;
                                                        phi_6452_ = _e3749;
                                                        phi_6453_ = type_20(_e2860, _e3606, _e3601);
                                                    }
                                                    let _e3751 = phi_6452_;
                                                    let _e3753 = phi_6453_;
                                                    phi_6454_ = _e3751;
                                                    phi_6455_ = _e3753;
                                                } else {
                                                    phi_6454_ = _e3228;
                                                    phi_6455_ = _e3160;
                                                }
                                                let _e3755 = phi_6454_;
                                                let _e3757 = phi_6455_;
                                                phi_6456_ = _e2836;
                                                phi_6457_ = _e3755;
                                                phi_6458_ = _e3757;
                                            } else {
                                                phi_6456_ = _e3592;
                                                phi_6457_ = _e3228;
                                                phi_6458_ = _e3594;
                                            }
                                            let _e3759 = phi_6456_;
                                            let _e3761 = phi_6457_;
                                            let _e3763 = phi_6458_;
                                            let _e3782 = ((_e1891[0][1][0].member - _e1891[0][0][0].member) - select(0u, 1u, (_e1891[0][1][0].member_1 < _e1891[0][0][0].member_1)));
                                            let _e3783 = (_e1891[0][1][0].member_1 - _e1891[0][0][0].member_1);
                                            let _e3795 = ((_e1891[0][1][1].member - _e1891[0][0][1].member) - select(0u, 1u, (_e1891[0][1][1].member_1 < _e1891[0][0][1].member_1)));
                                            let _e3796 = (_e1891[0][1][1].member_1 - _e1891[0][0][1].member_1);
                                            let _e3808 = ((_e1891[0][1][2].member - _e1891[0][0][2].member) - select(0u, 1u, (_e1891[0][1][2].member_1 < _e1891[0][0][2].member_1)));
                                            let _e3809 = (_e1891[0][1][2].member_1 - _e1891[0][0][2].member_1);
                                            let _e3812 = ((_e3782 >> bitcast<u32>(31i)) != 0u);
                                            let _e3819 = select(_e3782, (~(_e3782) + select(0u, 1u, (_e3783 == 0u))), _e3812);
                                            let _e3820 = select(_e3783, (~(_e3783) + 1u), _e3812);
                                            let _e3823 = ((_e3795 >> bitcast<u32>(31i)) != 0u);
                                            let _e3830 = select(_e3795, (~(_e3795) + select(0u, 1u, (_e3796 == 0u))), _e3823);
                                            let _e3831 = select(_e3796, (~(_e3796) + 1u), _e3823);
                                            let _e3838 = ((((_e3830 - _e3819) - select(0u, 1u, (_e3831 < _e3820))) >> bitcast<u32>(31i)) != 0u);
                                            let _e3839 = select(_e3830, _e3819, _e3838);
                                            let _e3840 = select(_e3831, _e3820, _e3838);
                                            let _e3843 = ((_e3808 >> bitcast<u32>(31i)) != 0u);
                                            let _e3850 = select(_e3808, (~(_e3808) + select(0u, 1u, (_e3809 == 0u))), _e3843);
                                            let _e3851 = select(_e3809, (~(_e3809) + 1u), _e3843);
                                            let _e3858 = ((((_e3850 - _e3839) - select(0u, 1u, (_e3851 < _e3840))) >> bitcast<u32>(31i)) != 0u);
                                            let _e3860 = select(_e3851, _e3840, _e3858);
                                            let _e3861 = function_14(4u);
                                            let _e3864 = (_e3860 + _e3861.member_1);
                                            let _e3868 = ((select(_e3850, _e3839, _e3858) + _e3861.member) + select(0u, 1u, (_e3864 < _e3860)));
                                            let _e3883 = ((_e3864 >> bitcast<u32>((_e3763.member_2 & 31u))) | ((_e3868 << bitcast<u32>(((31u - _e3763.member_2) & 31u))) << bitcast<u32>(1i)));
                                            let _e3884 = function_14(4u);
                                            let _e3887 = (_e3883 + _e3884.member_1);
                                            let _e3905 = ((_e1891[1][1][0].member - _e1891[1][0][0].member) - select(0u, 1u, (_e1891[1][1][0].member_1 < _e1891[1][0][0].member_1)));
                                            let _e3906 = (_e1891[1][1][0].member_1 - _e1891[1][0][0].member_1);
                                            let _e3918 = ((_e1891[1][1][1].member - _e1891[1][0][1].member) - select(0u, 1u, (_e1891[1][1][1].member_1 < _e1891[1][0][1].member_1)));
                                            let _e3919 = (_e1891[1][1][1].member_1 - _e1891[1][0][1].member_1);
                                            let _e3931 = ((_e1891[1][1][2].member - _e1891[1][0][2].member) - select(0u, 1u, (_e1891[1][1][2].member_1 < _e1891[1][0][2].member_1)));
                                            let _e3932 = (_e1891[1][1][2].member_1 - _e1891[1][0][2].member_1);
                                            let _e3935 = ((_e3905 >> bitcast<u32>(31i)) != 0u);
                                            let _e3942 = select(_e3905, (~(_e3905) + select(0u, 1u, (_e3906 == 0u))), _e3935);
                                            let _e3943 = select(_e3906, (~(_e3906) + 1u), _e3935);
                                            let _e3946 = ((_e3918 >> bitcast<u32>(31i)) != 0u);
                                            let _e3953 = select(_e3918, (~(_e3918) + select(0u, 1u, (_e3919 == 0u))), _e3946);
                                            let _e3954 = select(_e3919, (~(_e3919) + 1u), _e3946);
                                            let _e3961 = ((((_e3953 - _e3942) - select(0u, 1u, (_e3954 < _e3943))) >> bitcast<u32>(31i)) != 0u);
                                            let _e3962 = select(_e3953, _e3942, _e3961);
                                            let _e3963 = select(_e3954, _e3943, _e3961);
                                            let _e3966 = ((_e3931 >> bitcast<u32>(31i)) != 0u);
                                            let _e3973 = select(_e3931, (~(_e3931) + select(0u, 1u, (_e3932 == 0u))), _e3966);
                                            let _e3974 = select(_e3932, (~(_e3932) + 1u), _e3966);
                                            let _e3981 = ((((_e3973 - _e3962) - select(0u, 1u, (_e3974 < _e3963))) >> bitcast<u32>(31i)) != 0u);
                                            let _e3983 = select(_e3974, _e3963, _e3981);
                                            let _e3984 = function_14(4u);
                                            let _e3987 = (_e3983 + _e3984.member_1);
                                            let _e3991 = ((select(_e3973, _e3962, _e3981) + _e3984.member) + select(0u, 1u, (_e3987 < _e3983)));
                                            let _e4006 = ((_e3987 >> bitcast<u32>((_e3763.member_2 & 31u))) | ((_e3991 << bitcast<u32>(((31u - _e3763.member_2) & 31u))) << bitcast<u32>(1i)));
                                            let _e4007 = function_14(4u);
                                            let _e4010 = (_e4006 + _e4007.member_1);
                                            let _e4028 = ((_e1891[2][1][0].member - _e1891[2][0][0].member) - select(0u, 1u, (_e1891[2][1][0].member_1 < _e1891[2][0][0].member_1)));
                                            let _e4029 = (_e1891[2][1][0].member_1 - _e1891[2][0][0].member_1);
                                            let _e4041 = ((_e1891[2][1][1].member - _e1891[2][0][1].member) - select(0u, 1u, (_e1891[2][1][1].member_1 < _e1891[2][0][1].member_1)));
                                            let _e4042 = (_e1891[2][1][1].member_1 - _e1891[2][0][1].member_1);
                                            let _e4054 = ((_e1891[2][1][2].member - _e1891[2][0][2].member) - select(0u, 1u, (_e1891[2][1][2].member_1 < _e1891[2][0][2].member_1)));
                                            let _e4055 = (_e1891[2][1][2].member_1 - _e1891[2][0][2].member_1);
                                            let _e4058 = ((_e4028 >> bitcast<u32>(31i)) != 0u);
                                            let _e4065 = select(_e4028, (~(_e4028) + select(0u, 1u, (_e4029 == 0u))), _e4058);
                                            let _e4066 = select(_e4029, (~(_e4029) + 1u), _e4058);
                                            let _e4069 = ((_e4041 >> bitcast<u32>(31i)) != 0u);
                                            let _e4076 = select(_e4041, (~(_e4041) + select(0u, 1u, (_e4042 == 0u))), _e4069);
                                            let _e4077 = select(_e4042, (~(_e4042) + 1u), _e4069);
                                            let _e4084 = ((((_e4076 - _e4065) - select(0u, 1u, (_e4077 < _e4066))) >> bitcast<u32>(31i)) != 0u);
                                            let _e4085 = select(_e4076, _e4065, _e4084);
                                            let _e4086 = select(_e4077, _e4066, _e4084);
                                            let _e4089 = ((_e4054 >> bitcast<u32>(31i)) != 0u);
                                            let _e4096 = select(_e4054, (~(_e4054) + select(0u, 1u, (_e4055 == 0u))), _e4089);
                                            let _e4097 = select(_e4055, (~(_e4055) + 1u), _e4089);
                                            let _e4104 = ((((_e4096 - _e4085) - select(0u, 1u, (_e4097 < _e4086))) >> bitcast<u32>(31i)) != 0u);
                                            let _e4106 = select(_e4097, _e4086, _e4104);
                                            let _e4107 = function_14(4u);
                                            let _e4110 = (_e4106 + _e4107.member_1);
                                            let _e4114 = ((select(_e4096, _e4085, _e4104) + _e4107.member) + select(0u, 1u, (_e4110 < _e4106)));
                                            let _e4129 = ((_e4110 >> bitcast<u32>((_e3763.member_2 & 31u))) | ((_e4114 << bitcast<u32>(((31u - _e3763.member_2) & 31u))) << bitcast<u32>(1i)));
                                            let _e4130 = function_14(4u);
                                            let _e4133 = (_e4129 + _e4130.member_1);
                                            local_14[0u].member = ((bitcast<u32>((bitcast<i32>(_e3868) >> bitcast<u32>((_e3763.member_2 & 31u)))) + _e3884.member) + select(0u, 1u, (_e3887 < _e3883)));
                                            local_14[0u].member_1 = _e3887;
                                            local_14[1u].member = ((bitcast<u32>((bitcast<i32>(_e3991) >> bitcast<u32>((_e3763.member_2 & 31u)))) + _e4007.member) + select(0u, 1u, (_e4010 < _e4006)));
                                            local_14[1u].member_1 = _e4010;
                                            local_14[2u].member = ((bitcast<u32>((bitcast<i32>(_e4114) >> bitcast<u32>((_e3763.member_2 & 31u)))) + _e4130.member) + select(0u, 1u, (_e4133 < _e4129)));
                                            local_14[2u].member_1 = _e4133;
                                            let _e4163 = function_7(((_e1891[0][1][0].member - _e1891[0][0][0].member) - select(0u, 1u, (_e1891[0][1][0].member_1 < _e1891[0][0][0].member_1))), (_e1891[0][1][0].member_1 - _e1891[0][0][0].member_1), _e3763.member);
                                            let _e4166 = (_e1891[0][0][0].member_1 + _e4163.member_1);
                                            let _e4170 = ((_e1891[0][0][0].member + _e4163.member) + select(0u, 1u, (_e4166 < _e1891[0][0][0].member_1)));
                                            let _e4184 = function_7(((_e1891[0][1][1].member - _e1891[0][0][1].member) - select(0u, 1u, (_e1891[0][1][1].member_1 < _e1891[0][0][1].member_1))), (_e1891[0][1][1].member_1 - _e1891[0][0][1].member_1), _e3763.member);
                                            let _e4187 = (_e1891[0][0][1].member_1 + _e4184.member_1);
                                            let _e4191 = ((_e1891[0][0][1].member + _e4184.member) + select(0u, 1u, (_e4187 < _e1891[0][0][1].member_1)));
                                            let _e4205 = function_7(((_e1891[0][1][2].member - _e1891[0][0][2].member) - select(0u, 1u, (_e1891[0][1][2].member_1 < _e1891[0][0][2].member_1))), (_e1891[0][1][2].member_1 - _e1891[0][0][2].member_1), _e3763.member);
                                            let _e4208 = (_e1891[0][0][2].member_1 + _e4205.member_1);
                                            let _e4212 = ((_e1891[0][0][2].member + _e4205.member) + select(0u, 1u, (_e4208 < _e1891[0][0][2].member_1)));
                                            let _e4228 = function_7(((_e1891[1][1][0].member - _e1891[1][0][0].member) - select(0u, 1u, (_e1891[1][1][0].member_1 < _e1891[1][0][0].member_1))), (_e1891[1][1][0].member_1 - _e1891[1][0][0].member_1), _e3763.member);
                                            let _e4231 = (_e1891[1][0][0].member_1 + _e4228.member_1);
                                            let _e4235 = ((_e1891[1][0][0].member + _e4228.member) + select(0u, 1u, (_e4231 < _e1891[1][0][0].member_1)));
                                            let _e4249 = function_7(((_e1891[1][1][1].member - _e1891[1][0][1].member) - select(0u, 1u, (_e1891[1][1][1].member_1 < _e1891[1][0][1].member_1))), (_e1891[1][1][1].member_1 - _e1891[1][0][1].member_1), _e3763.member);
                                            let _e4252 = (_e1891[1][0][1].member_1 + _e4249.member_1);
                                            let _e4256 = ((_e1891[1][0][1].member + _e4249.member) + select(0u, 1u, (_e4252 < _e1891[1][0][1].member_1)));
                                            let _e4270 = function_7(((_e1891[1][1][2].member - _e1891[1][0][2].member) - select(0u, 1u, (_e1891[1][1][2].member_1 < _e1891[1][0][2].member_1))), (_e1891[1][1][2].member_1 - _e1891[1][0][2].member_1), _e3763.member);
                                            let _e4273 = (_e1891[1][0][2].member_1 + _e4270.member_1);
                                            let _e4277 = ((_e1891[1][0][2].member + _e4270.member) + select(0u, 1u, (_e4273 < _e1891[1][0][2].member_1)));
                                            let _e4293 = function_7(((_e1891[2][1][0].member - _e1891[2][0][0].member) - select(0u, 1u, (_e1891[2][1][0].member_1 < _e1891[2][0][0].member_1))), (_e1891[2][1][0].member_1 - _e1891[2][0][0].member_1), _e3763.member);
                                            let _e4296 = (_e1891[2][0][0].member_1 + _e4293.member_1);
                                            let _e4300 = ((_e1891[2][0][0].member + _e4293.member) + select(0u, 1u, (_e4296 < _e1891[2][0][0].member_1)));
                                            let _e4314 = function_7(((_e1891[2][1][1].member - _e1891[2][0][1].member) - select(0u, 1u, (_e1891[2][1][1].member_1 < _e1891[2][0][1].member_1))), (_e1891[2][1][1].member_1 - _e1891[2][0][1].member_1), _e3763.member);
                                            let _e4317 = (_e1891[2][0][1].member_1 + _e4314.member_1);
                                            let _e4321 = ((_e1891[2][0][1].member + _e4314.member) + select(0u, 1u, (_e4317 < _e1891[2][0][1].member_1)));
                                            let _e4335 = function_7(((_e1891[2][1][2].member - _e1891[2][0][2].member) - select(0u, 1u, (_e1891[2][1][2].member_1 < _e1891[2][0][2].member_1))), (_e1891[2][1][2].member_1 - _e1891[2][0][2].member_1), _e3763.member);
                                            let _e4338 = (_e1891[2][0][2].member_1 + _e4335.member_1);
                                            let _e4342 = ((_e1891[2][0][2].member + _e4335.member) + select(0u, 1u, (_e4338 < _e1891[2][0][2].member_1)));
                                            local_12 = array<type_9, 3>(type_9(_e4235, _e4231), type_9(_e4256, _e4252), type_9(_e4277, _e4273));
                                            local_13 = array<type_9, 3>(type_9(_e4300, _e4296), type_9(_e4321, _e4317), type_9(_e4342, _e4338));
                                            let _e4353 = local_12[1u].member;
                                            let _e4355 = local_12[1u].member_1;
                                            let _e4358 = local_13[2u].member;
                                            let _e4360 = local_13[2u].member_1;
                                            let _e4361 = function_11(_e4353, _e4355, _e4358, _e4360);
                                            let _e4366 = local_12[2u].member;
                                            let _e4368 = local_12[2u].member_1;
                                            let _e4371 = local_13[1u].member;
                                            let _e4373 = local_13[1u].member_1;
                                            let _e4374 = function_11(_e4366, _e4368, _e4371, _e4373);
                                            let _e4380 = ((_e4361.member - _e4374.member) - select(0u, 1u, (_e4361.member_1 < _e4374.member_1)));
                                            let _e4381 = (_e4361.member_1 - _e4374.member_1);
                                            local_10 = array<type_9, 3>(type_9(_e4235, _e4231), type_9(_e4256, _e4252), type_9(_e4277, _e4273));
                                            local_11 = array<type_9, 3>(type_9(_e4300, _e4296), type_9(_e4321, _e4317), type_9(_e4342, _e4338));
                                            let _e4392 = local_10[2u].member;
                                            let _e4394 = local_10[2u].member_1;
                                            let _e4397 = local_11[0u].member;
                                            let _e4399 = local_11[0u].member_1;
                                            let _e4400 = function_11(_e4392, _e4394, _e4397, _e4399);
                                            let _e4405 = local_10[0u].member;
                                            let _e4407 = local_10[0u].member_1;
                                            let _e4410 = local_11[2u].member;
                                            let _e4412 = local_11[2u].member_1;
                                            let _e4413 = function_11(_e4405, _e4407, _e4410, _e4412);
                                            let _e4419 = ((_e4400.member - _e4413.member) - select(0u, 1u, (_e4400.member_1 < _e4413.member_1)));
                                            let _e4420 = (_e4400.member_1 - _e4413.member_1);
                                            local_8 = array<type_9, 3>(type_9(_e4235, _e4231), type_9(_e4256, _e4252), type_9(_e4277, _e4273));
                                            local_9 = array<type_9, 3>(type_9(_e4300, _e4296), type_9(_e4321, _e4317), type_9(_e4342, _e4338));
                                            let _e4431 = local_8[0u].member;
                                            let _e4433 = local_8[0u].member_1;
                                            let _e4436 = local_9[1u].member;
                                            let _e4438 = local_9[1u].member_1;
                                            let _e4439 = function_11(_e4431, _e4433, _e4436, _e4438);
                                            let _e4444 = local_8[1u].member;
                                            let _e4446 = local_8[1u].member_1;
                                            let _e4449 = local_9[0u].member;
                                            let _e4451 = local_9[0u].member_1;
                                            let _e4452 = function_11(_e4444, _e4446, _e4449, _e4451);
                                            let _e4458 = ((_e4439.member - _e4452.member) - select(0u, 1u, (_e4439.member_1 < _e4452.member_1)));
                                            let _e4459 = (_e4439.member_1 - _e4452.member_1);
                                            let _e4462 = ((_e4380 >> bitcast<u32>(31i)) != 0u);
                                            let _e4469 = select(_e4380, (~(_e4380) + select(0u, 1u, (_e4381 == 0u))), _e4462);
                                            let _e4470 = select(_e4381, (~(_e4381) + 1u), _e4462);
                                            let _e4473 = ((_e4419 >> bitcast<u32>(31i)) != 0u);
                                            let _e4480 = select(_e4419, (~(_e4419) + select(0u, 1u, (_e4420 == 0u))), _e4473);
                                            let _e4481 = select(_e4420, (~(_e4420) + 1u), _e4473);
                                            let _e4484 = ((_e4458 >> bitcast<u32>(31i)) != 0u);
                                            let _e4491 = select(_e4458, (~(_e4458) + select(0u, 1u, (_e4459 == 0u))), _e4484);
                                            let _e4492 = select(_e4459, (~(_e4459) + 1u), _e4484);
                                            let _e4517 = select(0i, select(2i, 1i, ((((_e4491 - _e4480) - select(0u, 1u, (_e4492 < _e4481))) >> bitcast<u32>(31i)) != 0u)), select(true, select(true, false, ((((_e4491 - _e4469) - select(0u, 1u, (_e4492 < _e4470))) >> bitcast<u32>(31i)) != 0u)), ((((_e4480 - _e4469) - select(0u, 1u, (_e4481 < _e4470))) >> bitcast<u32>(31i)) != 0u)));
                                            switch _e4517 {
                                                case 0: {
                                                    phi_7605_ = array<type_9, 2>(type_9(_e4191, _e4187), type_9(_e4212, _e4208));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_7605_ = array<type_9, 2>(type_9(_e4212, _e4208), type_9(_e4170, _e4166));
                                                    break;
                                                }
                                                default: {
                                                    phi_7605_ = array<type_9, 2>(type_9(_e4170, _e4166), type_9(_e4191, _e4187));
                                                    break;
                                                }
                                            }
                                            let _e4528 = phi_7605_;
                                            switch _e4517 {
                                                case 0: {
                                                    phi_7634_ = array<type_9, 2>(type_9(_e4256, _e4252), type_9(_e4277, _e4273));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_7634_ = array<type_9, 2>(type_9(_e4277, _e4273), type_9(_e4235, _e4231));
                                                    break;
                                                }
                                                default: {
                                                    phi_7634_ = array<type_9, 2>(type_9(_e4235, _e4231), type_9(_e4256, _e4252));
                                                    break;
                                                }
                                            }
                                            let _e4539 = phi_7634_;
                                            switch _e4517 {
                                                case 0: {
                                                    phi_7663_ = array<type_9, 2>(type_9(_e4321, _e4317), type_9(_e4342, _e4338));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_7663_ = array<type_9, 2>(type_9(_e4342, _e4338), type_9(_e4300, _e4296));
                                                    break;
                                                }
                                                default: {
                                                    phi_7663_ = array<type_9, 2>(type_9(_e4300, _e4296), type_9(_e4321, _e4317));
                                                    break;
                                                }
                                            }
                                            let _e4550 = phi_7663_;
                                            switch _e4517 {
                                                case 0: {
                                                    phi_7677_ = type_9(_e4380, _e4381);
                                                    break;
                                                }
                                                case 1: {
                                                    phi_7677_ = type_9(_e4419, _e4420);
                                                    break;
                                                }
                                                default: {
                                                    phi_7677_ = type_9(_e4458, _e4459);
                                                    break;
                                                }
                                            }
                                            let _e4555 = phi_7677_;
                                            let _e4558 = local_14[1u].member;
                                            let _e4560 = local_14[1u].member_1;
                                            let _e4563 = local_14[2u].member;
                                            let _e4565 = local_14[2u].member_1;
                                            let _e4566 = (_e4560 + _e4565);
                                            let _e4570 = ((_e4558 + _e4563) + select(0u, 1u, (_e4566 < _e4560)));
                                            let _e4581 = ((_e4566 >> bitcast<u32>(1u)) | ((_e4570 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e4582 = function_14(17u);
                                            let _e4585 = (_e4581 + _e4582.member_1);
                                            let _e4589 = ((bitcast<u32>((bitcast<i32>(_e4570) >> bitcast<u32>(1u))) + _e4582.member) + select(0u, 1u, (_e4585 < _e4581)));
                                            let _e4592 = local_14[0u].member;
                                            let _e4594 = local_14[0u].member_1;
                                            let _e4597 = local_14[2u].member;
                                            let _e4599 = local_14[2u].member_1;
                                            let _e4600 = (_e4594 + _e4599);
                                            let _e4604 = ((_e4592 + _e4597) + select(0u, 1u, (_e4600 < _e4594)));
                                            let _e4615 = ((_e4600 >> bitcast<u32>(1u)) | ((_e4604 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e4616 = function_14(17u);
                                            let _e4619 = (_e4615 + _e4616.member_1);
                                            let _e4623 = ((bitcast<u32>((bitcast<i32>(_e4604) >> bitcast<u32>(1u))) + _e4616.member) + select(0u, 1u, (_e4619 < _e4615)));
                                            let _e4626 = local_14[0u].member;
                                            let _e4628 = local_14[0u].member_1;
                                            let _e4631 = local_14[1u].member;
                                            let _e4633 = local_14[1u].member_1;
                                            let _e4634 = (_e4628 + _e4633);
                                            let _e4638 = ((_e4626 + _e4631) + select(0u, 1u, (_e4634 < _e4628)));
                                            let _e4649 = ((_e4634 >> bitcast<u32>(1u)) | ((_e4638 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e4650 = function_14(17u);
                                            let _e4653 = (_e4649 + _e4650.member_1);
                                            let _e4657 = ((bitcast<u32>((bitcast<i32>(_e4638) >> bitcast<u32>(1u))) + _e4650.member) + select(0u, 1u, (_e4653 < _e4649)));
                                            let _e4662 = ((_e4555.member >> bitcast<u32>(31i)) != 0u);
                                            if ((((_e4589 - select(_e4555.member, (~(_e4555.member) + select(0u, 1u, (_e4555.member_1 == 0u))), _e4662)) - select(0u, 1u, (_e4585 < select(_e4555.member_1, (~(_e4555.member_1) + 1u), _e4662)))) >> bitcast<u32>(31i)) != 0u) {
                                                let _e4683 = ((_e4555.member >> bitcast<u32>(31i)) != 0u);
                                                let _e4693 = select(_e4555.member, (~(_e4555.member) + select(0u, 1u, (_e4555.member_1 == 0u))), _e4683);
                                                let _e4695 = select(_e4555.member_1, (~(_e4555.member_1) + 1u), _e4683);
                                                let _e4696 = function_12(_e4528, _e4550);
                                                let _e4706 = select(_e4696.member, (~(_e4696.member) + select(0u, 1u, (_e4696.member_1 == 0u))), _e4683);
                                                let _e4708 = select(_e4696.member_1, (~(_e4696.member_1) + 1u), _e4683);
                                                let _e4709 = function_12(_e4539, _e4528);
                                                let _e4719 = select(_e4709.member, (~(_e4709.member) + select(0u, 1u, (_e4709.member_1 == 0u))), _e4683);
                                                let _e4721 = select(_e4709.member_1, (~(_e4709.member_1) + 1u), _e4683);
                                                if (_e283.member != 0u) {
                                                    let _e4753 = (_e4585 + _e4619);
                                                    let _e4765 = (_e4585 + _e4653);
                                                    phi_7999_ = type_9(((_e4589 + _e4657) + select(0u, 1u, (_e4765 < _e4585))), _e4765);
                                                    phi_8000_ = type_9(((_e4693 - _e4719) - select(0u, 1u, (_e4695 < _e4721))), (_e4695 - _e4721));
                                                    phi_8001_ = type_9(((_e4589 + _e4623) + select(0u, 1u, (_e4753 < _e4585))), _e4753);
                                                    phi_8002_ = type_9(((_e4693 - _e4706) - select(0u, 1u, (_e4695 < _e4708))), (_e4695 - _e4708));
                                                } else {
                                                    let _e4727 = (_e4695 - _e4708);
                                                    let _e4731 = ((((_e4693 - _e4706) - select(0u, 1u, (_e4695 < _e4708))) - _e4719) - select(0u, 1u, (_e4727 < _e4721)));
                                                    let _e4732 = (_e4727 - _e4721);
                                                    let _e4734 = (_e4585 + _e4619);
                                                    let _e4739 = (_e4734 + _e4653);
                                                    let _e4743 = ((((_e4589 + _e4623) + select(0u, 1u, (_e4734 < _e4585))) + _e4657) + select(0u, 1u, (_e4739 < _e4734)));
                                                    phi_7999_ = type_9(_e4743, _e4739);
                                                    phi_8000_ = type_9(_e4731, _e4732);
                                                    phi_8001_ = type_9(_e4743, _e4739);
                                                    phi_8002_ = type_9(_e4731, _e4732);
                                                }
                                                let _e4772 = phi_7999_;
                                                let _e4774 = phi_8000_;
                                                let _e4776 = phi_8001_;
                                                let _e4778 = phi_8002_;
                                                let _e4779 = function_10(_e4706, _e4708, _e4623, _e4619);
                                                if _e4779 {
                                                    phi_8128_ = u32();
                                                    phi_8129_ = true;
                                                } else {
                                                    let _e4780 = function_10(_e4719, _e4721, _e4657, _e4653);
                                                    if _e4780 {
                                                        phi_8126_ = u32();
                                                        phi_8127_ = true;
                                                    } else {
                                                        let _e4785 = function_10(_e4778.member, _e4778.member_1, _e4776.member, _e4776.member_1);
                                                        if _e4785 {
                                                            phi_8124_ = u32();
                                                            phi_8125_ = true;
                                                        } else {
                                                            let _e4790 = function_10(_e4774.member, _e4774.member_1, _e4772.member, _e4772.member_1);
                                                            if _e4790 {
                                                                phi_8123_ = u32();
                                                            } else {
                                                                let _e4791 = function_9(_e4706, _e4708, _e4623, _e4619);
                                                                if _e4791 {
                                                                    let _e4792 = function_9(_e4719, _e4721, _e4657, _e4653);
                                                                    if _e4792 {
                                                                        let _e4797 = function_9(_e4778.member, _e4778.member_1, _e4776.member, _e4776.member_1);
                                                                        if _e4797 {
                                                                            let _e4802 = function_9(_e4774.member, _e4774.member_1, _e4772.member, _e4772.member_1);
                                                                            phi_8116_ = select(true, false, _e4802);
                                                                        } else {
                                                                            phi_8116_ = true;
                                                                        }
                                                                        let _e4805 = phi_8116_;
                                                                        phi_8117_ = _e4805;
                                                                    } else {
                                                                        phi_8117_ = true;
                                                                    }
                                                                    let _e4807 = phi_8117_;
                                                                    phi_8118_ = _e4807;
                                                                } else {
                                                                    phi_8118_ = true;
                                                                }
                                                                let _e4809 = phi_8118_;
                                                                phi_8123_ = select(0u, 2u, _e4809);
                                                            }
                                                            let _e4812 = phi_8123_;
                                                            phi_8124_ = _e4812;
                                                            phi_8125_ = _e4790;
                                                        }
                                                        let _e4814 = phi_8124_;
                                                        let _e4816 = phi_8125_;
                                                        phi_8126_ = _e4814;
                                                        phi_8127_ = _e4816;
                                                    }
                                                    let _e4818 = phi_8126_;
                                                    let _e4820 = phi_8127_;
                                                    phi_8128_ = _e4818;
                                                    phi_8129_ = _e4820;
                                                }
                                                let _e4822 = phi_8128_;
                                                let _e4824 = phi_8129_;
                                                phi_8134_ = select(_e4822, 1u, _e4824);
                                            } else {
                                                phi_8134_ = 2u;
                                            }
                                            let _e4827 = phi_8134_;
                                            let _e4835 = select(select(false, select((_e3763.member > _e1314), true, (_e3763.member_1 < _e1312)), _e3759), true, (_e4827 == 1u));
                                            let _e4849 = select(true, select(true, select(true, select(true, false, (_e4827 == 0u)), ((_e3763.member_1 - _e3763.member) <= _e1316)), select(false, (_e3763.member_1 <= _e1314), (_e3763.member >= _e1312))), _e3761);
                                            let _e4850 = select(true, _e4835, _e3005);
                                            phi_8198_ = _e3759;
                                            phi_8199_ = _e3147;
                                            phi_8200_ = _e4835;
                                            phi_8201_ = _e3763;
                                            phi_8202_ = select(false, _e4850, _e4849);
                                            phi_8203_ = select(false, select(true, false, _e4850), _e4849);
                                            phi_8204_ = select(true, false, _e4849);
                                        } else {
                                            phi_8198_ = _e2836;
                                            phi_8199_ = _e2838;
                                            phi_8200_ = _e3004;
                                            phi_8201_ = type_20();
                                            phi_8202_ = true;
                                            phi_8203_ = false;
                                            phi_8204_ = false;
                                        }
                                        let _e4856 = phi_8198_;
                                        let _e4858 = phi_8199_;
                                        let _e4860 = phi_8200_;
                                        let _e4862 = phi_8201_;
                                        let _e4864 = phi_8202_;
                                        let _e4866 = phi_8203_;
                                        let _e4868 = phi_8204_;
                                        if _e4864 {
                                            if _e4860 {
                                                phi_8541_ = _e2834;
                                                phi_8543_ = _e2840;
                                                phi_8544_ = _e2842;
                                            } else {
                                                let _e4877 = (_e2834[0].member_1 + _e2834[1].member_1);
                                                let _e4881 = ((_e2834[0].member + _e2834[1].member) + select(0u, 1u, (_e4877 < _e2834[0].member_1)));
                                                let _e4889 = bitcast<u32>((bitcast<i32>(_e4881) >> bitcast<u32>(1u)));
                                                let _e4892 = ((_e4877 >> bitcast<u32>(1u)) | ((_e4881 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4901 = (_e2834[1].member_1 + _e2834[2].member_1);
                                                let _e4905 = ((_e2834[1].member + _e2834[2].member) + select(0u, 1u, (_e4901 < _e2834[1].member_1)));
                                                let _e4913 = bitcast<u32>((bitcast<i32>(_e4905) >> bitcast<u32>(1u)));
                                                let _e4916 = ((_e4901 >> bitcast<u32>(1u)) | ((_e4905 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4925 = (_e2834[2].member_1 + _e2834[3].member_1);
                                                let _e4929 = ((_e2834[2].member + _e2834[3].member) + select(0u, 1u, (_e4925 < _e2834[2].member_1)));
                                                let _e4937 = bitcast<u32>((bitcast<i32>(_e4929) >> bitcast<u32>(1u)));
                                                let _e4940 = ((_e4925 >> bitcast<u32>(1u)) | ((_e4929 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4941 = (_e4892 + _e4916);
                                                let _e4945 = ((_e4889 + _e4913) + select(0u, 1u, (_e4941 < _e4892)));
                                                let _e4953 = bitcast<u32>((bitcast<i32>(_e4945) >> bitcast<u32>(1u)));
                                                let _e4956 = ((_e4941 >> bitcast<u32>(1u)) | ((_e4945 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4957 = (_e4916 + _e4940);
                                                let _e4961 = ((_e4913 + _e4937) + select(0u, 1u, (_e4957 < _e4916)));
                                                let _e4969 = bitcast<u32>((bitcast<i32>(_e4961) >> bitcast<u32>(1u)));
                                                let _e4972 = ((_e4957 >> bitcast<u32>(1u)) | ((_e4961 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4973 = (_e4956 + _e4972);
                                                let _e4977 = ((_e4953 + _e4969) + select(0u, 1u, (_e4973 < _e4956)));
                                                let _e4985 = bitcast<u32>((bitcast<i32>(_e4977) >> bitcast<u32>(1u)));
                                                let _e4988 = ((_e4973 >> bitcast<u32>(1u)) | ((_e4977 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4989 = (2u * _e2842);
                                                let _e5000 = function_14(128u);
                                                let _e5005 = ((_e2834[0].member >> bitcast<u32>(31i)) != 0u);
                                                let _e5029 = function_14(128u);
                                                let _e5034 = ((_e4889 >> bitcast<u32>(31i)) != 0u);
                                                let _e5056 = function_14(128u);
                                                let _e5061 = ((_e4953 >> bitcast<u32>(31i)) != 0u);
                                                let _e5083 = function_14(128u);
                                                let _e5088 = ((_e4985 >> bitcast<u32>(31i)) != 0u);
                                                if ((((select(0u, select(1u, 2u, ((_e2834[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e5000.member - select(_e2834[0].member, (~(_e2834[0].member) + select(0u, 1u, (_e2834[0].member_1 == 0u))), _e5005)) - select(0u, 1u, (_e5000.member_1 < select(_e2834[0].member_1, (~(_e2834[0].member_1) + 1u), _e5005)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e4889 >> bitcast<u32>(31i)) != 0u)), ((((_e5029.member - select(_e4889, (~(_e4889) + select(0u, 1u, (_e4892 == 0u))), _e5034)) - select(0u, 1u, (_e5029.member_1 < select(_e4892, (~(_e4892) + 1u), _e5034)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e4953 >> bitcast<u32>(31i)) != 0u)), ((((_e5056.member - select(_e4953, (~(_e4953) + select(0u, 1u, (_e4956 == 0u))), _e5061)) - select(0u, 1u, (_e5056.member_1 < select(_e4956, (~(_e4956) + 1u), _e5061)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e4985 >> bitcast<u32>(31i)) != 0u)), ((((_e5083.member - select(_e4985, (~(_e4985) + select(0u, 1u, (_e4988 == 0u))), _e5088)) - select(0u, 1u, (_e5083.member_1 < select(_e4988, (~(_e4988) + 1u), _e5088)))) >> bitcast<u32>(31i)) != 0u))) != 0u) {
                                                    phi_8539_ = array<type_9, 4>(type_9(_e4985, _e4988), type_9(_e4969, _e4972), type_9(_e4937, _e4940), _e2834[3]);
                                                    phi_8540_ = (_e4989 + 1u);
                                                } else {
                                                    phi_8539_ = array<type_9, 4>(_e2834[0], type_9(_e4889, _e4892), type_9(_e4953, _e4956), type_9(_e4985, _e4988));
                                                    phi_8540_ = _e4989;
                                                }
                                                let _e5118 = phi_8539_;
                                                let _e5120 = phi_8540_;
                                                phi_8541_ = _e5118;
                                                phi_8543_ = (_e2840 + 1u);
                                                phi_8544_ = _e5120;
                                            }
                                            let _e5122 = phi_8541_;
                                            let _e5124 = phi_8543_;
                                            let _e5126 = phi_8544_;
                                            phi_8545_ = _e5122;
                                            phi_8547_ = _e5124;
                                            phi_8548_ = _e5126;
                                            phi_8549_ = false;
                                            phi_8550_ = false;
                                        } else {
                                            phi_8545_ = array<type_9, 4>();
                                            phi_8547_ = u32();
                                            phi_8548_ = u32();
                                            phi_8549_ = _e4866;
                                            phi_8550_ = _e4868;
                                        }
                                        let _e5128 = phi_8545_;
                                        let _e5130 = phi_8547_;
                                        let _e5132 = phi_8548_;
                                        let _e5134 = phi_8549_;
                                        let _e5136 = phi_8550_;
                                        phi_8551_ = _e5128;
                                        phi_8552_ = _e4856;
                                        phi_8553_ = _e4858;
                                        phi_8555_ = _e4860;
                                        phi_8556_ = _e5130;
                                        phi_8557_ = _e5132;
                                        phi_8558_ = _e4862;
                                        phi_8559_ = _e4864;
                                        phi_8560_ = _e5134;
                                        phi_8561_ = _e5136;
                                    }
                                    let _e5138 = phi_8551_;
                                    let _e5140 = phi_8552_;
                                    let _e5142 = phi_8553_;
                                    let _e5144 = phi_8555_;
                                    let _e5146 = phi_8556_;
                                    let _e5148 = phi_8557_;
                                    let _e5150 = phi_8558_;
                                    let _e5152 = phi_8559_;
                                    let _e5154 = phi_8560_;
                                    let _e5156 = phi_8561_;
                                    if _e5152 {
                                        if _e5144 {
                                            let _e5157 = (_e5148 + 1u);
                                            let _e5159 = (_e5157 & (4294967295u - _e5148));
                                            let _e5165 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e5159)), 32u, (_e5159 == 0u)));
                                            let _e5167 = select(_e5165, _e5146, (_e5146 < _e5165));
                                            let _e5170 = (_e5157 >> bitcast<u32>((_e5167 & 31u)));
                                            let _e5171 = (_e5146 - _e5167);
                                            let _e5175 = select(true, select(true, false, (_e5171 == 0u)), (_e5170 == 1u));
                                            if _e5175 {
                                                let _e5176 = (31u - _e5171);
                                                let _e5179 = (_e5170 << bitcast<u32>((_e5176 & 31u)));
                                                let _e5183 = ((_e5170 + 1u) << bitcast<u32>((_e5176 & 31u)));
                                                let _e5189 = function_7(((_e2713 - _e2640.member) - select(0u, 1u, (_e2709 < _e2640.member_1))), (_e2709 - _e2640.member_1), _e5179);
                                                let _e5192 = (_e2640.member_1 + _e5189.member_1);
                                                let _e5202 = function_7(((_e2784 - _e2713) - select(0u, 1u, (_e2780 < _e2709))), (_e2780 - _e2709), _e5179);
                                                let _e5205 = (_e2709 + _e5202.member_1);
                                                let _e5215 = function_7(((_e2818.member - _e2784) - select(0u, 1u, (_e2818.member_1 < _e2780))), (_e2818.member_1 - _e2780), _e5179);
                                                let _e5218 = (_e2780 + _e5215.member_1);
                                                let _e5226 = array<type_9, 3>(type_9(((_e2640.member + _e5189.member) + select(0u, 1u, (_e5192 < _e2640.member_1))), _e5192), type_9(((_e2713 + _e5202.member) + select(0u, 1u, (_e5205 < _e2709))), _e5205), type_9(((_e2784 + _e5215.member) + select(0u, 1u, (_e5218 < _e2780))), _e5218));
                                                let _e5232 = function_7(((_e2713 - _e2640.member) - select(0u, 1u, (_e2709 < _e2640.member_1))), (_e2709 - _e2640.member_1), _e5183);
                                                let _e5235 = (_e2640.member_1 + _e5232.member_1);
                                                let _e5245 = function_7(((_e2784 - _e2713) - select(0u, 1u, (_e2780 < _e2709))), (_e2780 - _e2709), _e5183);
                                                let _e5248 = (_e2709 + _e5245.member_1);
                                                let _e5258 = function_7(((_e2818.member - _e2784) - select(0u, 1u, (_e2818.member_1 < _e2780))), (_e2818.member_1 - _e2780), _e5183);
                                                let _e5261 = (_e2780 + _e5258.member_1);
                                                let _e5270 = function_8(_e5226, _e5179);
                                                let _e5271 = function_8(_e5226, _e5183);
                                                let _e5272 = function_8(array<type_9, 3>(type_9(((_e2640.member + _e5232.member) + select(0u, 1u, (_e5235 < _e2640.member_1))), _e5235), type_9(((_e2713 + _e5245.member) + select(0u, 1u, (_e5248 < _e2709))), _e5248), type_9(((_e2784 + _e5258.member) + select(0u, 1u, (_e5261 < _e2780))), _e5261)), _e5183);
                                                let _e5286 = function_7(((_e5270[1].member - _e5270[0].member) - select(0u, 1u, (_e5270[1].member_1 < _e5270[0].member_1))), (_e5270[1].member_1 - _e5270[0].member_1), _e5179);
                                                let _e5289 = (_e5270[0].member_1 + _e5286.member_1);
                                                let _e5307 = function_7(((_e5270[1].member - _e5270[0].member) - select(0u, 1u, (_e5270[1].member_1 < _e5270[0].member_1))), (_e5270[1].member_1 - _e5270[0].member_1), _e5183);
                                                let _e5310 = (_e5270[0].member_1 + _e5307.member_1);
                                                let _e5328 = function_7(((_e5271[1].member - _e5271[0].member) - select(0u, 1u, (_e5271[1].member_1 < _e5271[0].member_1))), (_e5271[1].member_1 - _e5271[0].member_1), _e5183);
                                                let _e5331 = (_e5271[0].member_1 + _e5328.member_1);
                                                let _e5349 = function_7(((_e5272[1].member - _e5272[0].member) - select(0u, 1u, (_e5272[1].member_1 < _e5272[0].member_1))), (_e5272[1].member_1 - _e5272[0].member_1), _e5183);
                                                let _e5352 = (_e5272[0].member_1 + _e5349.member_1);
                                                phi_8856_ = array<type_9, 4>(type_9(((_e5270[0].member + _e5286.member) + select(0u, 1u, (_e5289 < _e5270[0].member_1))), _e5289), type_9(((_e5270[0].member + _e5307.member) + select(0u, 1u, (_e5310 < _e5270[0].member_1))), _e5310), type_9(((_e5271[0].member + _e5328.member) + select(0u, 1u, (_e5331 < _e5271[0].member_1))), _e5331), type_9(((_e5272[0].member + _e5349.member) + select(0u, 1u, (_e5352 < _e5272[0].member_1))), _e5352));
                                            } else {
                                                phi_8856_ = array<type_9, 4>();
                                            }
                                            let _e5363 = phi_8856_;
                                            phi_8857_ = _e5363;
                                            phi_8858_ = false;
                                            phi_8859_ = false;
                                            phi_8860_ = _e5171;
                                            phi_8861_ = _e5170;
                                            phi_8862_ = _e5175;
                                        } else {
                                            phi_8857_ = _e5138;
                                            phi_8858_ = _e5140;
                                            phi_8859_ = _e5142;
                                            phi_8860_ = _e5146;
                                            phi_8861_ = _e5148;
                                            phi_8862_ = true;
                                        }
                                        let _e5365 = phi_8857_;
                                        let _e5367 = phi_8858_;
                                        let _e5369 = phi_8859_;
                                        let _e5371 = phi_8860_;
                                        let _e5373 = phi_8861_;
                                        let _e5375 = phi_8862_;
                                        phi_8867_ = _e5365;
                                        phi_8868_ = _e5367;
                                        phi_8869_ = _e5369;
                                        phi_8870_ = _e5371;
                                        phi_8871_ = _e5373;
                                        phi_8872_ = _e5375;
                                        phi_8873_ = select(true, false, _e5375);
                                        phi_8874_ = false;
                                        phi_8875_ = false;
                                    } else {
                                        phi_8867_ = array<type_9, 4>();
                                        phi_8868_ = bool();
                                        phi_8869_ = bool();
                                        phi_8870_ = u32();
                                        phi_8871_ = u32();
                                        phi_8872_ = false;
                                        phi_8873_ = false;
                                        phi_8874_ = _e5154;
                                        phi_8875_ = _e5156;
                                    }
                                    let _e5378 = phi_8867_;
                                    let _e5380 = phi_8868_;
                                    let _e5382 = phi_8869_;
                                    let _e5384 = phi_8870_;
                                    let _e5386 = phi_8871_;
                                    let _e5388 = phi_8872_;
                                    let _e5390 = phi_8873_;
                                    let _e5392 = phi_8874_;
                                    let _e5394 = phi_8875_;
                                    phi_8876_ = _e5378;
                                    phi_8877_ = _e5380;
                                    phi_8878_ = _e5382;
                                    phi_8880_ = _e5384;
                                    phi_8881_ = _e5386;
                                    phi_8882_ = _e5150;
                                    phi_8883_ = _e5388;
                                    phi_8884_ = _e5390;
                                    phi_8885_ = _e5392;
                                    phi_8886_ = _e5394;
                                }
                                let _e5396 = phi_8876_;
                                let _e5398 = phi_8877_;
                                let _e5400 = phi_8878_;
                                let _e5402 = phi_8880_;
                                let _e5404 = phi_8881_;
                                let _e5406 = phi_8882_;
                                let _e5408 = phi_8883_;
                                let _e5410 = phi_8884_;
                                let _e5412 = phi_8885_;
                                let _e5414 = phi_8886_;
                                phi_5121_ = _e5396;
                                phi_5123_ = _e5398;
                                phi_5125_ = _e5400;
                                phi_5129_ = _e5402;
                                phi_5131_ = _e5404;
                                phi_8887_ = _e5406;
                                phi_8888_ = _e5408;
                                phi_8889_ = _e2865;
                                phi_8890_ = false;
                                phi_8891_ = _e5410;
                                phi_8892_ = _e5412;
                                phi_8893_ = _e5414;
                            } else {
                                phi_5121_ = array<type_9, 4>();
                                phi_5123_ = bool();
                                phi_5125_ = bool();
                                phi_5129_ = u32();
                                phi_5131_ = u32();
                                phi_8887_ = type_20();
                                phi_8888_ = false;
                                phi_8889_ = false;
                                phi_8890_ = true;
                                phi_8891_ = false;
                                phi_8892_ = false;
                                phi_8893_ = false;
                            }
                            let _e5416 = phi_5121_;
                            let _e5418 = phi_5123_;
                            let _e5420 = phi_5125_;
                            let _e5422 = phi_5129_;
                            let _e5424 = phi_5131_;
                            let _e5426 = phi_8887_;
                            let _e5428 = phi_8888_;
                            let _e5430 = phi_8889_;
                            let _e5432 = phi_8890_;
                            let _e5434 = phi_8891_;
                            let _e5436 = phi_8892_;
                            let _e5438 = phi_8893_;
                            local_43 = _e5430;
                            local_44 = _e5430;
                            local_45 = _e5430;
                            local_46 = _e5432;
                            local_47 = _e5430;
                            local_48 = _e5434;
                            local_49 = _e5430;
                            local_50 = _e5436;
                            local_51 = _e5430;
                            local_52 = _e5438;
                            local_53 = _e5430;
                            local_54 = _e5426;
                            continue;
                            continuing {
                                phi_5117_ = type_9(select(_e2832.member, (_e2832.member + 1u), _e2845), select(_e2832.member_1, _e2832.member_1, _e2845));
                                phi_5120_ = _e5416;
                                phi_5122_ = _e5418;
                                phi_5124_ = _e5420;
                                phi_5128_ = _e5422;
                                phi_5130_ = _e5424;
                                break if !(_e5428);
                            }
                        }
                        let _e5442 = local_43;
                        let _e5447 = local_44;
                        let _e5450 = local_45;
                        let _e5452 = local_46;
                        let _e5453 = select(_e5452, false, _e5450);
                        let _e5455 = local_47;
                        let _e5457 = local_48;
                        let _e5460 = local_49;
                        let _e5462 = local_50;
                        let _e5465 = local_51;
                        let _e5467 = local_52;
                        let _e5474 = select(select(_e5457, false, _e5455), false, _e5453);
                        let _e5478 = local_53;
                        let _e5485 = select(select(select(_e5462, false, _e5460), false, _e5453), false, _e5474);
                        let _e5493 = select(select(select(select(_e5467, false, _e5465), false, _e5453), false, _e5474), false, _e5485);
                        let _e5497 = local_54;
                        let _e5501 = select(_e5485, true, _e5493);
                        let _e5506 = select(select(select(_e5474, false, _e5485), false, _e5493), true, _e5501);
                        let _e5510 = select(select(select(select(select(select(_e5478, false, _e5453), false, _e5474), false, _e5485), false, _e5493), false, _e5501), true, _e5506);
                        let _e5512 = select(select(type_9().member_1, type_9().member_1, _e5453), select(select(type_9().member_1, type_9().member_1, _e5447), select(select(type_9().member_1, type_9().member_1, _e5474), select(select(type_9().member_1, type_9().member_1, _e5485), _e5497.member, _e5493), _e5501), _e5506), _e5510);
                        switch bitcast<i32>(select(select(type_9().member, 2u, _e5453), select(select(type_9().member, 0u, _e5442), select(select(type_9().member, 0u, _e5474), select(select(type_9().member, 2u, _e5485), 1u, _e5493), _e5501), _e5506), _e5510)) {
                            case 0: {
                                phi_8988_ = type_31(0u, 0u, array<u32, 2>(0u, 0u), false);
                                break;
                            }
                            case 1: {
                                if (_e5512 == 0u) {
                                    phi_8982_ = array<u32, 2>(0u, 0u);
                                } else {
                                    let _e5521 = select((bitcast<u32>(31i) - firstLeadingBit(_e5512)), 32u, (_e5512 == 0u));
                                    let _e5526 = ((_e5512 << bitcast<u32>((_e5521 & 31u))) << bitcast<u32>(1i));
                                    phi_8982_ = array<u32, 2>((_e5526 << bitcast<u32>(20i)), (((1023u - _e5521) << bitcast<u32>(20i)) | (_e5526 >> bitcast<u32>(12i))));
                                }
                                let _e5537 = phi_8982_;
                                phi_8988_ = type_31(0u, select(0u, 1u, (_e5512 > _e1312)), _e5537, true);
                                break;
                            }
                            case 2: {
                                phi_8988_ = type_31(1u, 0u, array<u32, 2>(0u, 0u), true);
                                break;
                            }
                            default: {
                                phi_8988_ = type_31();
                                break;
                            }
                        }
                        let _e5540 = phi_8988_;
                        phi_8995_ = _e5540;
                        phi_8996_ = select(true, false, (_e5540.member == 0u));
                    } else {
                        phi_8995_ = type_31();
                        phi_8996_ = true;
                    }
                    let _e5545 = phi_8995_;
                    let _e5547 = phi_8996_;
                    phi_8997_ = _e5545;
                    phi_8998_ = _e5547;
                } else {
                    phi_8997_ = type_31();
                    phi_8998_ = true;
                }
                let _e5549 = phi_8997_;
                let _e5551 = phi_8998_;
                if _e5551 {
                    let _e5553 = params.member.member.member_11;
                    let _e5555 = params.member.member.member_12;
                    let _e5557 = params.member.member.member_13;
                    let _e5559 = params.member.member.member_13;
                    let _e5565 = select(_e539.member[0][0], -(_e539.member[0][0]), (_e539.member[0][0] < 0f));
                    let _e5569 = select(_e539.member[0][1], -(_e539.member[0][1]), (_e539.member[0][1] < 0f));
                    let _e5571 = select(_e5569, _e5565, (_e5565 > _e5569));
                    let _e5575 = select(_e539.member[0][2], -(_e539.member[0][2]), (_e539.member[0][2] < 0f));
                    let _e5577 = select(_e5575, _e5571, (_e5571 > _e5575));
                    let _e5583 = select(_e539.member[1][0], -(_e539.member[1][0]), (_e539.member[1][0] < 0f));
                    let _e5587 = select(_e539.member[1][1], -(_e539.member[1][1]), (_e539.member[1][1] < 0f));
                    let _e5589 = select(_e5587, _e5583, (_e5583 > _e5587));
                    let _e5593 = select(_e539.member[1][2], -(_e539.member[1][2]), (_e539.member[1][2] < 0f));
                    let _e5595 = select(_e5593, _e5589, (_e5589 > _e5593));
                    let _e5599 = (select(_e5595, _e5577, (_e5577 > _e5595)) + _e539.member_3);
                    let _e5605 = select(_e539.member_1[0][0], -(_e539.member_1[0][0]), (_e539.member_1[0][0] < 0f));
                    let _e5609 = select(_e539.member_1[0][1], -(_e539.member_1[0][1]), (_e539.member_1[0][1] < 0f));
                    let _e5611 = select(_e5609, _e5605, (_e5605 > _e5609));
                    let _e5615 = select(_e539.member_1[0][2], -(_e539.member_1[0][2]), (_e539.member_1[0][2] < 0f));
                    let _e5617 = select(_e5615, _e5611, (_e5611 > _e5615));
                    let _e5623 = select(_e539.member_1[1][0], -(_e539.member_1[1][0]), (_e539.member_1[1][0] < 0f));
                    let _e5627 = select(_e539.member_1[1][1], -(_e539.member_1[1][1]), (_e539.member_1[1][1] < 0f));
                    let _e5629 = select(_e5627, _e5623, (_e5623 > _e5627));
                    let _e5633 = select(_e539.member_1[1][2], -(_e539.member_1[1][2]), (_e539.member_1[1][2] < 0f));
                    let _e5635 = select(_e5633, _e5629, (_e5629 > _e5633));
                    let _e5639 = (select(_e5635, _e5617, (_e5617 > _e5635)) + _e539.member_3);
                    let _e5645 = select(_e539.member_2[0][0], -(_e539.member_2[0][0]), (_e539.member_2[0][0] < 0f));
                    let _e5649 = select(_e539.member_2[0][1], -(_e539.member_2[0][1]), (_e539.member_2[0][1] < 0f));
                    let _e5651 = select(_e5649, _e5645, (_e5645 > _e5649));
                    let _e5655 = select(_e539.member_2[0][2], -(_e539.member_2[0][2]), (_e539.member_2[0][2] < 0f));
                    let _e5657 = select(_e5655, _e5651, (_e5651 > _e5655));
                    let _e5663 = select(_e539.member_2[1][0], -(_e539.member_2[1][0]), (_e539.member_2[1][0] < 0f));
                    let _e5667 = select(_e539.member_2[1][1], -(_e539.member_2[1][1]), (_e539.member_2[1][1] < 0f));
                    let _e5669 = select(_e5667, _e5663, (_e5663 > _e5667));
                    let _e5673 = select(_e539.member_2[1][2], -(_e539.member_2[1][2]), (_e539.member_2[1][2] < 0f));
                    let _e5675 = select(_e5673, _e5669, (_e5669 > _e5673));
                    let _e5679 = (select(_e5675, _e5657, (_e5657 > _e5675)) + _e539.member_3);
                    let _e5681 = select(_e5639, _e5599, (_e5599 > _e5639));
                    let _e5683 = select(_e5679, _e5681, (_e5681 > _e5679));
                    if (_e5683 <= 65536f) {
                        phi_9269_ = (_e5683 >= (1f / 65536f));
                    } else {
                        phi_9269_ = false;
                    }
                    let _e5688 = phi_9269_;
                    if _e5688 {
                        phi_9367_ = type_29();
                        phi_9368_ = true;
                    } else {
                        if (_e5683 >= 0.000000000000000000000000000000000000011754944f) {
                            if ((bitcast<u32>(_e5683) & 2139095040u) != 2139095040u) {
                                let _e5695 = (2130706432u - (bitcast<u32>(_e5683) & 2139095040u));
                                let _e5698 = bitcast<f32>(select(8388608u, _e5695, (_e5695 > 8388608u)));
                                phi_9363_ = type_29(type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e539.member[0][0] * _e5698), (_e539.member[0][1] * _e5698), (_e539.member[0][2] * _e5698)), array<f32, 3>((_e539.member[1][0] * _e5698), (_e539.member[1][1] * _e5698), (_e539.member[1][2] * _e5698))), array<array<f32, 3>, 2>(array<f32, 3>((_e539.member_1[0][0] * _e5698), (_e539.member_1[0][1] * _e5698), (_e539.member_1[0][2] * _e5698)), array<f32, 3>((_e539.member_1[1][0] * _e5698), (_e539.member_1[1][1] * _e5698), (_e539.member_1[1][2] * _e5698))), array<array<f32, 3>, 2>(array<f32, 3>((_e539.member_2[0][0] * _e5698), (_e539.member_2[0][1] * _e5698), (_e539.member_2[0][2] * _e5698)), array<f32, 3>((_e539.member_2[1][0] * _e5698), (_e539.member_2[1][1] * _e5698), (_e539.member_2[1][2] * _e5698))), ((_e539.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e5698)), (0f * _e5698));
                                phi_9364_ = false;
                            } else {
                                phi_9363_ = type_29();
                                phi_9364_ = true;
                            }
                            let _e5764 = phi_9363_;
                            let _e5766 = phi_9364_;
                            phi_9365_ = _e5764;
                            phi_9366_ = _e5766;
                        } else {
                            phi_9365_ = type_29();
                            phi_9366_ = true;
                        }
                        let _e5768 = phi_9365_;
                        let _e5770 = phi_9366_;
                        phi_9367_ = _e5768;
                        phi_9368_ = _e5770;
                    }
                    let _e5772 = phi_9367_;
                    let _e5774 = phi_9368_;
                    if _e5774 {
                        phi_9373_ = type_29(_e539, 0f);
                    } else {
                        phi_9373_ = _e5772;
                    }
                    let _e5777 = phi_9373_;
                    local_7 = type_27(array<array<f32, 3>, 2>(array<f32, 3>(_e5777.member.member[0][0], _e5777.member.member[0][1], _e5777.member.member[0][2]), array<f32, 3>(_e5777.member.member[1][0], _e5777.member.member[1][1], _e5777.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e5777.member.member_1[0][0], _e5777.member.member_1[0][1], _e5777.member.member_1[0][2]), array<f32, 3>(_e5777.member.member_1[1][0], _e5777.member.member_1[1][1], _e5777.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e5777.member.member_2[0][0], _e5777.member.member_2[0][1], _e5777.member.member_2[0][2]), array<f32, 3>(_e5777.member.member_2[1][0], _e5777.member.member_2[1][1], _e5777.member.member_2[1][2])), _e5777.member.member_3);
                    let _e5819 = local_7.member_1[0u];
                    let _e5825 = local_7.member_2[0u];
                    let _e5831 = ((_e5819[1] * _e5825[2]) - (_e5819[2] * _e5825[1]));
                    let _e5834 = ((_e5819[2] * _e5825[0]) - (_e5819[0] * _e5825[2]));
                    let _e5837 = ((_e5819[0] * _e5825[1]) - (_e5819[1] * _e5825[0]));
                    let _e5840 = local_7.member_1[1u];
                    let _e5846 = local_7.member_2[1u];
                    let _e5852 = ((_e5840[1] * _e5846[2]) - (_e5840[2] * _e5846[1]));
                    let _e5855 = ((_e5840[2] * _e5846[0]) - (_e5840[0] * _e5846[2]));
                    let _e5858 = ((_e5840[0] * _e5846[1]) - (_e5840[1] * _e5846[0]));
                    let _e5861 = local_7.member_1[0u];
                    let _e5867 = local_7.member_2[1u];
                    let _e5882 = local_7.member_1[1u];
                    let _e5888 = local_7.member_2[0u];
                    let _e5901 = (((_e5861[1] * _e5867[2]) - (_e5861[2] * _e5867[1])) + ((_e5882[1] * _e5888[2]) - (_e5882[2] * _e5888[1])));
                    let _e5902 = (((_e5861[2] * _e5867[0]) - (_e5861[0] * _e5867[2])) + ((_e5882[2] * _e5888[0]) - (_e5882[0] * _e5888[2])));
                    let _e5903 = (((_e5861[0] * _e5867[1]) - (_e5861[1] * _e5867[0])) + ((_e5882[0] * _e5888[1]) - (_e5882[1] * _e5888[0])));
                    let _e5906 = local_7.member[0u];
                    let _e5914 = (((_e5906[0] * _e5831) + (_e5906[1] * _e5834)) + (_e5906[2] * _e5837));
                    let _e5917 = local_7.member[1u];
                    let _e5928 = local_7.member[0u];
                    let _e5937 = ((((_e5917[0] * _e5831) + (_e5917[1] * _e5834)) + (_e5917[2] * _e5837)) + (((_e5928[0] * _e5901) + (_e5928[1] * _e5902)) + (_e5928[2] * _e5903)));
                    let _e5940 = local_7.member[0u];
                    let _e5951 = local_7.member[1u];
                    let _e5960 = ((((_e5940[0] * _e5852) + (_e5940[1] * _e5855)) + (_e5940[2] * _e5858)) + (((_e5951[0] * _e5901) + (_e5951[1] * _e5902)) + (_e5951[2] * _e5903)));
                    let _e5963 = local_7.member[1u];
                    let _e5971 = (((_e5963[0] * _e5852) + (_e5963[1] * _e5855)) + (_e5963[2] * _e5858));
                    let _e5974 = local_7.member[0u];
                    let _e5980 = select(_e5974[0], -(_e5974[0]), (_e5974[0] < 0f));
                    let _e5983 = select(_e5974[1], -(_e5974[1]), (_e5974[1] < 0f));
                    let _e5985 = select(_e5983, _e5980, (_e5980 > _e5983));
                    let _e5988 = select(_e5974[2], -(_e5974[2]), (_e5974[2] < 0f));
                    let _e5990 = select(_e5988, _e5985, (_e5985 > _e5988));
                    let _e5993 = local_7.member[1u];
                    let _e5999 = select(_e5993[0], -(_e5993[0]), (_e5993[0] < 0f));
                    let _e6002 = select(_e5993[1], -(_e5993[1]), (_e5993[1] < 0f));
                    let _e6004 = select(_e6002, _e5999, (_e5999 > _e6002));
                    let _e6007 = select(_e5993[2], -(_e5993[2]), (_e5993[2] < 0f));
                    let _e6009 = select(_e6007, _e6004, (_e6004 > _e6007));
                    let _e6013 = local_7.member_3;
                    let _e6014 = (select(_e6009, _e5990, (_e5990 > _e6009)) + _e6013);
                    let _e6017 = local_7.member_1[0u];
                    let _e6023 = select(_e6017[0], -(_e6017[0]), (_e6017[0] < 0f));
                    let _e6026 = select(_e6017[1], -(_e6017[1]), (_e6017[1] < 0f));
                    let _e6028 = select(_e6026, _e6023, (_e6023 > _e6026));
                    let _e6031 = select(_e6017[2], -(_e6017[2]), (_e6017[2] < 0f));
                    let _e6033 = select(_e6031, _e6028, (_e6028 > _e6031));
                    let _e6036 = local_7.member_1[1u];
                    let _e6042 = select(_e6036[0], -(_e6036[0]), (_e6036[0] < 0f));
                    let _e6045 = select(_e6036[1], -(_e6036[1]), (_e6036[1] < 0f));
                    let _e6047 = select(_e6045, _e6042, (_e6042 > _e6045));
                    let _e6050 = select(_e6036[2], -(_e6036[2]), (_e6036[2] < 0f));
                    let _e6052 = select(_e6050, _e6047, (_e6047 > _e6050));
                    let _e6056 = local_7.member_3;
                    let _e6057 = (select(_e6052, _e6033, (_e6033 > _e6052)) + _e6056);
                    let _e6060 = local_7.member_2[0u];
                    let _e6066 = select(_e6060[0], -(_e6060[0]), (_e6060[0] < 0f));
                    let _e6069 = select(_e6060[1], -(_e6060[1]), (_e6060[1] < 0f));
                    let _e6071 = select(_e6069, _e6066, (_e6066 > _e6069));
                    let _e6074 = select(_e6060[2], -(_e6060[2]), (_e6060[2] < 0f));
                    let _e6076 = select(_e6074, _e6071, (_e6071 > _e6074));
                    let _e6079 = local_7.member_2[1u];
                    let _e6085 = select(_e6079[0], -(_e6079[0]), (_e6079[0] < 0f));
                    let _e6088 = select(_e6079[1], -(_e6079[1]), (_e6079[1] < 0f));
                    let _e6090 = select(_e6088, _e6085, (_e6085 > _e6088));
                    let _e6093 = select(_e6079[2], -(_e6079[2]), (_e6079[2] < 0f));
                    let _e6095 = select(_e6093, _e6090, (_e6090 > _e6093));
                    let _e6099 = local_7.member_3;
                    let _e6100 = (select(_e6095, _e6076, (_e6076 > _e6095)) + _e6099);
                    let _e6102 = ((_e6057 * 8f) * _e6100);
                    let _e6109 = local_7.member_3;
                    let _e6133 = ((select(_e5831, -(_e5831), (_e5831 < 0f)) + select(_e5834, -(_e5834), (_e5834 < 0f))) + select(_e5837, -(_e5837), (_e5837 < 0f)));
                    let _e6144 = ((select(_e5852, -(_e5852), (_e5852 < 0f)) + select(_e5855, -(_e5855), (_e5855 < 0f))) + select(_e5858, -(_e5858), (_e5858 < 0f)));
                    let _e6146 = select(_e6144, _e6133, (_e6133 > _e6144));
                    let _e6158 = (((select(_e5901, -(_e5901), (_e5901 < 0f)) + select(_e5902, -(_e5902), (_e5902 < 0f))) + select(_e5903, -(_e5903), (_e5903 < 0f))) * 0.5f);
                    let _e6165 = local_7.member_3;
                    let _e6177 = (((((_e6014 * 8f) * _e6102) * (0.000000059604645f * (524f / 64f))) + ((_e6109 * 19f) * ((_e6014 * (_e6057 + _e6100)) + (_e6057 * _e6100)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6014) * ((1f + _e6057) * (1f + _e6100)))));
                    let _e6178 = (_e5914 * 3f);
                    let _e6179 = (_e5971 * 3f);
                    let _e6181 = select(_e6179, _e6178, (_e6178 < _e6179));
                    let _e6183 = select(_e5960, _e5937, (_e5937 < _e5960));
                    let _e6185 = select(_e6183, _e6181, (_e6181 < _e6183));
                    let _e6187 = select(_e6179, _e6178, (_e6178 > _e6179));
                    let _e6189 = select(_e5960, _e5937, (_e5937 > _e5960));
                    let _e6196 = -(select(_e6189, _e6187, (_e6187 > _e6189)));
                    if ((select(_e6196, _e6185, (_e6185 > _e6196)) - (_e6177 + ((0f * (((select(_e6158, _e6146, (_e6146 > _e6158)) + (_e6102 * (0.000000059604645f * 8f))) + ((_e6165 * 6f) * (_e6057 + _e6100))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6057) * (1f + _e6100))))) * (3f * 1.0001f)))) > 0f) {
                        phi_14595_ = type_30(0u, type_30().member_1);
                        phi_14596_ = type_30();
                        phi_14597_ = true;
                    } else {
                        let _e6204 = select(_e5914, -(_e5914), (_e5914 < 0f));
                        let _e6207 = select(_e5937, -(_e5937), (_e5937 < 0f));
                        let _e6209 = select(_e6207, _e6204, (_e6204 > _e6207));
                        let _e6212 = select(_e5960, -(_e5960), (_e5960 < 0f));
                        let _e6215 = select(_e5971, -(_e5971), (_e5971 < 0f));
                        let _e6217 = select(_e6215, _e6212, (_e6212 > _e6215));
                        let _e6219 = select(_e6217, _e6209, (_e6209 > _e6217));
                        let _e6220 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e6219 >= _e6220) {
                            phi_10098_ = (_e6219 <= (1f / _e6220));
                        } else {
                            phi_10098_ = false;
                        }
                        let _e6225 = phi_10098_;
                        if _e6225 {
                            phi_10110_ = (1f / _e6219);
                        } else {
                            phi_10110_ = 0f;
                        }
                        let _e6232 = phi_10110_;
                        let _e6233 = (_e5553 * 0.0625f);
                        local_5 = type_34(array<f32, 4>(_e5914, _e5937, _e5960, _e5971), ((_e6177 * 0.34f) + (_e6219 * select(2f, (0.000000059604645f * 256f), _e6225))), _e6232, select(_e6233, 0.00000000000022737368f, (0.00000000000022737368f < _e6233)));
                        let _e6240 = local_5.member[0u];
                        let _e6243 = local_5.member[1u];
                        let _e6246 = local_5.member[2u];
                        let _e6249 = local_5.member[3u];
                        let _e6256 = local_5.member_2;
                        let _e6257 = ((_e6243 - (3f * _e6240)) * _e6256);
                        let _e6259 = local_5.member_2;
                        let _e6260 = ((_e6246 - _e6243) * _e6259);
                        let _e6262 = local_5.member_2;
                        let _e6263 = (((3f * _e6249) - _e6246) * _e6262);
                        local_3[0u] = 0f;
                        local_3[1u] = 1f;
                        local_3[2u] = 1f;
                        local_3[3u] = 1f;
                        let _e6270 = ((_e6260 * _e6260) - (_e6257 * _e6263));
                        if (_e6270 > 0f) {
                            if (_e6270 <= 0.000000000000000000000000000000000000011754944f) {
                                phi_10238_ = select(0f, (0.000000000000000000106433627f * 2f), (_e6270 > 0f));
                            } else {
                                phi_10181_ = type_14(0i, 5i);
                                phi_10184_ = bitcast<f32>(((bitcast<u32>(_e6270) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e6279 = phi_10181_;
                                    let _e6281 = phi_10184_;
                                    local_55 = _e6281;
                                    if (_e6279.member < _e6279.member_1) {
                                        let _e6288 = (_e6279.member + 1i);
                                        phi_10182_ = type_14(select(_e6288, type_15().member_1, select(false, true, ((false == (_e6288 > _e6279.member)) != false))), _e6279.member_1);
                                        phi_10225_ = type_15(1u, _e6279.member);
                                    } else {
                                        phi_10182_ = _e6279;
                                        phi_10225_ = type_15(0u, type_15().member_1);
                                    }
                                    let _e6299 = phi_10182_;
                                    let _e6301 = phi_10225_;
                                    let _e6304 = (bitcast<i32>(_e6301.member) != 0i);
                                    if _e6304 {
                                        phi_10185_ = (0.5f * (_e6281 + (_e6270 / _e6281)));
                                    } else {
                                        phi_10185_ = f32();
                                    }
                                    let _e6309 = phi_10185_;
                                    continue;
                                    continuing {
                                        phi_10181_ = _e6299;
                                        phi_10184_ = _e6309;
                                        break if !(_e6304);
                                    }
                                }
                                let _e6314 = local_55;
                                phi_10238_ = (_e6314 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e6320 = phi_10238_;
                            let _e6325 = -((_e6260 + select(_e6320, -(_e6320), (_e6260 < 0f))));
                            local_4[0u] = (_e6325 / (_e6325 + _e6263));
                            local_4[1u] = (_e6257 / (_e6257 + _e6325));
                            let _e6334 = local_4[1u];
                            let _e6335 = local_4[0u];
                            if (_e6334 < _e6335) {
                                let _e6338 = local_4[1u];
                                let _e6340 = local_4[0u];
                                local_4[0u] = _e6338;
                                local_4[1u] = _e6340;
                            }
                            phi_10269_ = type_9(0u, 2u);
                            phi_10272_ = 1u;
                            loop {
                                let _e6344 = phi_10269_;
                                let _e6346 = phi_10272_;
                                local_87 = _e6346;
                                let _e6349 = (_e6344.member < _e6344.member_1);
                                let _e6360 = select(type_9().member_1, _e6344.member, _e6349);
                                let _e6362 = (bitcast<i32>(select(0u, 1u, _e6349)) != 0i);
                                if _e6362 {
                                    let _e6364 = local_4[_e6360];
                                    if (_e6364 > 0f) {
                                        let _e6367 = local_4[_e6360];
                                        if (_e6367 < 1f) {
                                            let _e6370 = local_4[_e6360];
                                            local_3[_e6346] = _e6370;
                                            phi_10339_ = (_e6346 + 1u);
                                        } else {
                                            phi_10339_ = _e6346;
                                        }
                                        let _e6374 = phi_10339_;
                                        phi_10340_ = _e6374;
                                    } else {
                                        phi_10340_ = _e6346;
                                    }
                                    let _e6376 = phi_10340_;
                                    phi_10273_ = _e6376;
                                } else {
                                    phi_10273_ = u32();
                                }
                                let _e6378 = phi_10273_;
                                continue;
                                continuing {
                                    phi_10269_ = type_9(select(_e6344.member, (_e6344.member + 1u), _e6349), select(_e6344.member_1, _e6344.member_1, _e6349));
                                    phi_10272_ = _e6378;
                                    break if !(_e6362);
                                }
                            }
                            let _e9165 = local_87;
                            phi_10341_ = _e9165;
                        } else {
                            phi_10341_ = 1u;
                        }
                        let _e6381 = phi_10341_;
                        local_3[_e6381] = 1f;
                        let _e6383 = local_3;
                        local_6 = _e6383;
                        let _e6384 = (_e5553 * 0.99f);
                        let _e6385 = (1f - _e5555);
                        let _e6388 = local_5.member[0u];
                        let _e6391 = local_5.member[1u];
                        let _e6394 = local_5.member[2u];
                        let _e6397 = local_5.member[3u];
                        let _e6408 = ((((_e6388 * _e6385) + (_e6391 * _e5555)) * (_e6385 * _e6385)) + (((_e6394 * _e6385) + (_e6397 * _e5555)) * (_e5555 * _e5555)));
                        let _e6413 = local_5.member_1;
                        phi_10397_ = type_9(select(1u, 0u, !((select(_e6408, -(_e6408), (_e6408 < 0f)) > _e6413))), (_e6381 + 1u));
                        loop {
                            let _e6420 = phi_10397_;
                            let _e6423 = (_e6420.member < _e6420.member_1);
                            let _e6434 = select(type_9().member_1, _e6420.member, _e6423);
                            if (bitcast<i32>(select(0u, 1u, _e6423)) != 0i) {
                                if (_e6434 > 0u) {
                                    let _e6441 = local_6[(_e6434 - 1u)];
                                    let _e6443 = select(_e5555, _e6441, (_e6441 > _e5555));
                                    let _e6445 = local_6[_e6434];
                                    let _e6447 = select(_e5557, _e6445, (_e6445 < _e5557));
                                    if (_e6443 <= _e6447) {
                                        let _e6449 = function_6((&local_5), _e5559, _e6443, _e6447);
                                        if _e6449 {
                                            phi_11800_ = type_45();
                                            phi_11801_ = bool();
                                            phi_11802_ = type_45();
                                            phi_11803_ = false;
                                            phi_11804_ = false;
                                            phi_11805_ = false;
                                            phi_11806_ = false;
                                        } else {
                                            let _e6450 = (1f - _e6443);
                                            let _e6453 = local_5.member[0u];
                                            let _e6456 = local_5.member[1u];
                                            let _e6459 = local_5.member[2u];
                                            let _e6462 = local_5.member[3u];
                                            let _e6473 = ((((_e6453 * _e6450) + (_e6456 * _e6443)) * (_e6450 * _e6450)) + (((_e6459 * _e6450) + (_e6462 * _e6443)) * (_e6443 * _e6443)));
                                            let _e6474 = (1f - _e6447);
                                            let _e6477 = local_5.member[0u];
                                            let _e6480 = local_5.member[1u];
                                            let _e6483 = local_5.member[2u];
                                            let _e6486 = local_5.member[3u];
                                            let _e6497 = ((((_e6477 * _e6474) + (_e6480 * _e6447)) * (_e6474 * _e6474)) + (((_e6483 * _e6474) + (_e6486 * _e6447)) * (_e6447 * _e6447)));
                                            let _e6502 = local_5.member_1;
                                            let _e6503 = (select(_e6473, -(_e6473), (_e6473 < 0f)) > _e6502);
                                            let _e6508 = local_5.member_1;
                                            let _e6509 = (select(_e6497, -(_e6497), (_e6497 < 0f)) > _e6508);
                                            let _e6517 = select(select(bool(), select(bool(), ((_e6473 > 0f) != (_e6497 > 0f)), _e6509), _e6503), false, select(true, select(true, false, _e6509), _e6503));
                                            if _e6503 {
                                                if _e6509 {
                                                    phi_10553_ = type_45(select(1f, type_45().member, _e6517), select(0f, type_45().member_1, _e6517), select(_e6517, type_45().member_2, _e6517));
                                                    phi_10554_ = _e6517;
                                                } else {
                                                    phi_10553_ = type_45();
                                                    phi_10554_ = true;
                                                }
                                                let _e6526 = phi_10553_;
                                                let _e6528 = phi_10554_;
                                                phi_10555_ = _e6526;
                                                phi_10556_ = _e6528;
                                            } else {
                                                phi_10555_ = type_45();
                                                phi_10556_ = true;
                                            }
                                            let _e6530 = phi_10555_;
                                            let _e6532 = phi_10556_;
                                            if _e6532 {
                                                if _e6503 {
                                                    let _e6534 = select(1f, -1f, (_e6473 < 0f));
                                                    let _e6536 = local_5.member_3;
                                                    let _e6539 = local_5.member[0u];
                                                    let _e6542 = local_5.member[1u];
                                                    let _e6545 = local_5.member[2u];
                                                    let _e6548 = local_5.member[3u];
                                                    let _e6551 = (_e6545 - _e6542);
                                                    phi_10587_ = type_9(0u, 64u);
                                                    phi_10590_ = _e6447;
                                                    phi_10592_ = _e6443;
                                                    phi_10594_ = (0.5f * (_e6443 + _e6447));
                                                    loop {
                                                        let _e6557 = phi_10587_;
                                                        let _e6559 = phi_10590_;
                                                        let _e6561 = phi_10592_;
                                                        let _e6563 = phi_10594_;
                                                        local_58 = _e6561;
                                                        let _e6566 = (_e6557.member < _e6557.member_1);
                                                        if (bitcast<i32>(select(0u, 1u, _e6566)) != 0i) {
                                                            let _e6578 = (1f - _e6563);
                                                            let _e6581 = local_5.member[0u];
                                                            let _e6584 = local_5.member[1u];
                                                            let _e6587 = local_5.member[2u];
                                                            let _e6590 = local_5.member[3u];
                                                            let _e6604 = local_5.member_1;
                                                            let _e6605 = ((_e6534 * ((((_e6581 * _e6578) + (_e6584 * _e6563)) * (_e6578 * _e6578)) + (((_e6587 * _e6578) + (_e6590 * _e6563)) * (_e6563 * _e6563)))) - _e6604);
                                                            let _e6606 = (_e6605 > 0f);
                                                            let _e6607 = select(_e6563, _e6559, _e6606);
                                                            let _e6608 = select(_e6561, _e6563, _e6606);
                                                            let _e6610 = ((_e6607 - _e6608) > _e6536);
                                                            if _e6610 {
                                                                let _e6611 = (1f - _e6563);
                                                                let _e6623 = (-(_e6605) / (_e6534 * (((((_e6542 - (3f * _e6539)) * _e6611) + (_e6551 * _e6563)) * _e6611) + (((_e6551 * _e6611) + (((3f * _e6548) - _e6545) * _e6563)) * _e6563))));
                                                                let _e6630 = ((_e6563 + _e6623) + select(-((0.5f * _e6536)), (0.5f * _e6536), (_e6605 > 0f)));
                                                                if (_e6630 > _e6608) {
                                                                    phi_10704_ = select(true, select(true, false, (select(_e6623, -(_e6623), (_e6623 < 0f)) < (0.5f * (_e6607 - _e6608)))), (_e6630 < _e6607));
                                                                } else {
                                                                    phi_10704_ = true;
                                                                }
                                                                let _e6642 = phi_10704_;
                                                                phi_10711_ = select(_e6630, (0.5f * (_e6608 + _e6607)), _e6642);
                                                                phi_10712_ = false;
                                                            } else {
                                                                phi_10711_ = f32();
                                                                phi_10712_ = true;
                                                            }
                                                            let _e6647 = phi_10711_;
                                                            let _e6649 = phi_10712_;
                                                            phi_10591_ = _e6607;
                                                            phi_10593_ = _e6608;
                                                            phi_10595_ = _e6647;
                                                            phi_10713_ = _e6608;
                                                            phi_10714_ = _e6610;
                                                            phi_10715_ = _e6649;
                                                        } else {
                                                            phi_10591_ = f32();
                                                            phi_10593_ = f32();
                                                            phi_10595_ = f32();
                                                            phi_10713_ = f32();
                                                            phi_10714_ = false;
                                                            phi_10715_ = false;
                                                        }
                                                        let _e6651 = phi_10591_;
                                                        let _e6653 = phi_10593_;
                                                        let _e6655 = phi_10595_;
                                                        let _e6657 = phi_10713_;
                                                        let _e6659 = phi_10714_;
                                                        let _e6661 = phi_10715_;
                                                        local_56 = _e6661;
                                                        local_57 = _e6657;
                                                        continue;
                                                        continuing {
                                                            phi_10587_ = type_9(select(_e6557.member, (_e6557.member + 1u), _e6566), select(_e6557.member_1, _e6557.member_1, _e6566));
                                                            phi_10590_ = _e6651;
                                                            phi_10592_ = _e6653;
                                                            phi_10594_ = _e6655;
                                                            break if !(_e6659);
                                                        }
                                                    }
                                                    let _e6664 = local_56;
                                                    let _e6666 = local_57;
                                                    let _e6668 = local_58;
                                                    phi_10720_ = select(_e6668, _e6666, _e6664);
                                                } else {
                                                    phi_10720_ = _e6443;
                                                }
                                                let _e6671 = phi_10720_;
                                                if _e6509 {
                                                    let _e6675 = local_5.member_3;
                                                    let _e6677 = local_5.member_3;
                                                    phi_10736_ = type_9(0u, 64u);
                                                    phi_10739_ = (_e6675 + _e6677);
                                                    loop {
                                                        let _e6680 = phi_10736_;
                                                        let _e6682 = phi_10739_;
                                                        let _e6685 = (_e6680.member < _e6680.member_1);
                                                        if (bitcast<i32>(select(0u, 1u, _e6685)) != 0i) {
                                                            let _e6697 = (_e6671 + _e6682);
                                                            if (_e6697 < _e6447) {
                                                                let _e6699 = (1f - _e6697);
                                                                let _e6702 = local_5.member[0u];
                                                                let _e6705 = local_5.member[1u];
                                                                let _e6708 = local_5.member[2u];
                                                                let _e6711 = local_5.member[3u];
                                                                let _e6725 = local_5.member_1;
                                                                let _e6726 = ((select(1f, -1f, (_e6497 < 0f)) * ((((_e6702 * _e6699) + (_e6705 * _e6697)) * (_e6699 * _e6699)) + (((_e6708 * _e6699) + (_e6711 * _e6697)) * (_e6697 * _e6697)))) > _e6725);
                                                                phi_10804_ = select((_e6682 + _e6682), f32(), _e6726);
                                                                phi_10805_ = select(true, false, _e6726);
                                                                phi_10806_ = _e6726;
                                                                phi_10807_ = false;
                                                            } else {
                                                                phi_10804_ = f32();
                                                                phi_10805_ = false;
                                                                phi_10806_ = false;
                                                                phi_10807_ = true;
                                                            }
                                                            let _e6731 = phi_10804_;
                                                            let _e6733 = phi_10805_;
                                                            let _e6735 = phi_10806_;
                                                            let _e6737 = phi_10807_;
                                                            phi_10808_ = _e6697;
                                                            phi_10740_ = _e6731;
                                                            phi_10809_ = _e6733;
                                                            phi_10810_ = _e6735;
                                                            phi_10811_ = _e6737;
                                                            phi_10812_ = false;
                                                        } else {
                                                            phi_10808_ = f32();
                                                            phi_10740_ = f32();
                                                            phi_10809_ = false;
                                                            phi_10810_ = false;
                                                            phi_10811_ = false;
                                                            phi_10812_ = true;
                                                        }
                                                        let _e6739 = phi_10808_;
                                                        let _e6741 = phi_10740_;
                                                        let _e6743 = phi_10809_;
                                                        let _e6745 = phi_10810_;
                                                        let _e6747 = phi_10811_;
                                                        let _e6749 = phi_10812_;
                                                        local_59 = _e6745;
                                                        local_60 = _e6747;
                                                        local_61 = _e6745;
                                                        local_62 = _e6749;
                                                        local_63 = _e6739;
                                                        continue;
                                                        continuing {
                                                            phi_10736_ = type_9(select(_e6680.member, (_e6680.member + 1u), _e6685), select(_e6680.member_1, _e6680.member_1, _e6685));
                                                            phi_10739_ = _e6741;
                                                            break if !(_e6743);
                                                        }
                                                    }
                                                    let _e6752 = local_59;
                                                    let _e6754 = local_60;
                                                    let _e6757 = local_61;
                                                    let _e6759 = local_62;
                                                    let _e6763 = local_63;
                                                    phi_10826_ = select(_e6763, _e6447, select(select(_e6759, false, _e6757), true, select(_e6754, false, _e6752)));
                                                } else {
                                                    phi_10826_ = _e6447;
                                                }
                                                let _e6766 = phi_10826_;
                                                phi_10828_ = type_45(_e6671, _e6766, _e6517);
                                            } else {
                                                phi_10828_ = _e6530;
                                            }
                                            let _e6769 = phi_10828_;
                                            if (_e6769.member > _e6769.member_1) {
                                                phi_11795_ = bool();
                                                phi_11796_ = true;
                                                phi_11797_ = false;
                                                phi_11798_ = false;
                                                phi_11799_ = false;
                                            } else {
                                                let _e6774 = (_e6769.member > _e5559);
                                                if _e6774 {
                                                    phi_11791_ = bool();
                                                    phi_11792_ = false;
                                                    phi_11793_ = false;
                                                    phi_11794_ = false;
                                                } else {
                                                    let _e6778 = ((_e6769.member_1 - _e6769.member) * 0.5f);
                                                    let _e6779 = (_e6769.member + _e6778);
                                                    let _e6781 = (_e6778 + (0.000000059604645f * 4f));
                                                    let _e6783 = local_7.member_3;
                                                    let _e6786 = local_7.member[0u];
                                                    let _e6792 = select(_e6786[0], -(_e6786[0]), (_e6786[0] < 0f));
                                                    let _e6795 = select(_e6786[1], -(_e6786[1]), (_e6786[1] < 0f));
                                                    let _e6797 = select(_e6795, _e6792, (_e6792 > _e6795));
                                                    let _e6800 = select(_e6786[2], -(_e6786[2]), (_e6786[2] < 0f));
                                                    let _e6802 = select(_e6800, _e6797, (_e6797 > _e6800));
                                                    let _e6804 = local_7.member[1u];
                                                    let _e6810 = select(_e6804[0], -(_e6804[0]), (_e6804[0] < 0f));
                                                    let _e6813 = select(_e6804[1], -(_e6804[1]), (_e6804[1] < 0f));
                                                    let _e6815 = select(_e6813, _e6810, (_e6810 > _e6813));
                                                    let _e6818 = select(_e6804[2], -(_e6804[2]), (_e6804[2] < 0f));
                                                    let _e6820 = select(_e6818, _e6815, (_e6815 > _e6818));
                                                    let _e6825 = local_7.member[0u];
                                                    let _e6830 = local_7.member[1u];
                                                    let _e6840 = (_e6825[0] + ((_e6830[0] - _e6825[0]) * _e6779));
                                                    let _e6841 = (_e6825[1] + ((_e6830[1] - _e6825[1]) * _e6779));
                                                    let _e6842 = (_e6825[2] + ((_e6830[2] - _e6825[2]) * _e6779));
                                                    let _e6844 = local_7.member[1u];
                                                    let _e6849 = local_7.member[0u];
                                                    let _e6853 = (_e6844[0] - _e6849[0]);
                                                    let _e6854 = (_e6844[1] - _e6849[1]);
                                                    let _e6855 = (_e6844[2] - _e6849[2]);
                                                    let _e6858 = select(_e6853, -(_e6853), (_e6853 < 0f));
                                                    let _e6861 = select(_e6854, -(_e6854), (_e6854 < 0f));
                                                    let _e6863 = select(_e6861, _e6858, (_e6858 > _e6861));
                                                    let _e6866 = select(_e6855, -(_e6855), (_e6855 < 0f));
                                                    let _e6874 = ((((_e6781 * select(_e6866, _e6863, (_e6863 > _e6866))) * 1.01f) + ((select(_e6820, _e6802, (_e6802 > _e6820)) + _e6783) * (0.000000059604645f * 8f))) + _e6783);
                                                    let _e6877 = select(_e6840, -(_e6840), (_e6840 < 0f));
                                                    let _e6880 = select(_e6841, -(_e6841), (_e6841 < 0f));
                                                    let _e6882 = select(_e6880, _e6877, (_e6877 > _e6880));
                                                    let _e6885 = select(_e6842, -(_e6842), (_e6842 < 0f));
                                                    let _e6888 = (select(_e6885, _e6882, (_e6882 > _e6885)) + _e6874);
                                                    let _e6891 = local_7.member_3;
                                                    let _e6893 = local_7.member_1[0u];
                                                    let _e6899 = select(_e6893[0], -(_e6893[0]), (_e6893[0] < 0f));
                                                    let _e6902 = select(_e6893[1], -(_e6893[1]), (_e6893[1] < 0f));
                                                    let _e6904 = select(_e6902, _e6899, (_e6899 > _e6902));
                                                    let _e6907 = select(_e6893[2], -(_e6893[2]), (_e6893[2] < 0f));
                                                    let _e6909 = select(_e6907, _e6904, (_e6904 > _e6907));
                                                    let _e6911 = local_7.member_1[1u];
                                                    let _e6917 = select(_e6911[0], -(_e6911[0]), (_e6911[0] < 0f));
                                                    let _e6920 = select(_e6911[1], -(_e6911[1]), (_e6911[1] < 0f));
                                                    let _e6922 = select(_e6920, _e6917, (_e6917 > _e6920));
                                                    let _e6925 = select(_e6911[2], -(_e6911[2]), (_e6911[2] < 0f));
                                                    let _e6927 = select(_e6925, _e6922, (_e6922 > _e6925));
                                                    let _e6932 = local_7.member_1[0u];
                                                    let _e6937 = local_7.member_1[1u];
                                                    let _e6947 = (_e6932[0] + ((_e6937[0] - _e6932[0]) * _e6779));
                                                    let _e6948 = (_e6932[1] + ((_e6937[1] - _e6932[1]) * _e6779));
                                                    let _e6949 = (_e6932[2] + ((_e6937[2] - _e6932[2]) * _e6779));
                                                    let _e6951 = local_7.member_1[1u];
                                                    let _e6956 = local_7.member_1[0u];
                                                    let _e6960 = (_e6951[0] - _e6956[0]);
                                                    let _e6961 = (_e6951[1] - _e6956[1]);
                                                    let _e6962 = (_e6951[2] - _e6956[2]);
                                                    let _e6965 = select(_e6960, -(_e6960), (_e6960 < 0f));
                                                    let _e6968 = select(_e6961, -(_e6961), (_e6961 < 0f));
                                                    let _e6970 = select(_e6968, _e6965, (_e6965 > _e6968));
                                                    let _e6973 = select(_e6962, -(_e6962), (_e6962 < 0f));
                                                    let _e6981 = ((((_e6781 * select(_e6973, _e6970, (_e6970 > _e6973))) * 1.01f) + ((select(_e6927, _e6909, (_e6909 > _e6927)) + _e6891) * (0.000000059604645f * 8f))) + _e6891);
                                                    let _e6984 = select(_e6947, -(_e6947), (_e6947 < 0f));
                                                    let _e6987 = select(_e6948, -(_e6948), (_e6948 < 0f));
                                                    let _e6989 = select(_e6987, _e6984, (_e6984 > _e6987));
                                                    let _e6992 = select(_e6949, -(_e6949), (_e6949 < 0f));
                                                    let _e6995 = (select(_e6992, _e6989, (_e6989 > _e6992)) + _e6981);
                                                    let _e6998 = local_7.member_3;
                                                    let _e7000 = local_7.member_2[0u];
                                                    let _e7006 = select(_e7000[0], -(_e7000[0]), (_e7000[0] < 0f));
                                                    let _e7009 = select(_e7000[1], -(_e7000[1]), (_e7000[1] < 0f));
                                                    let _e7011 = select(_e7009, _e7006, (_e7006 > _e7009));
                                                    let _e7014 = select(_e7000[2], -(_e7000[2]), (_e7000[2] < 0f));
                                                    let _e7016 = select(_e7014, _e7011, (_e7011 > _e7014));
                                                    let _e7018 = local_7.member_2[1u];
                                                    let _e7024 = select(_e7018[0], -(_e7018[0]), (_e7018[0] < 0f));
                                                    let _e7027 = select(_e7018[1], -(_e7018[1]), (_e7018[1] < 0f));
                                                    let _e7029 = select(_e7027, _e7024, (_e7024 > _e7027));
                                                    let _e7032 = select(_e7018[2], -(_e7018[2]), (_e7018[2] < 0f));
                                                    let _e7034 = select(_e7032, _e7029, (_e7029 > _e7032));
                                                    let _e7039 = local_7.member_2[0u];
                                                    let _e7044 = local_7.member_2[1u];
                                                    let _e7054 = (_e7039[0] + ((_e7044[0] - _e7039[0]) * _e6779));
                                                    let _e7055 = (_e7039[1] + ((_e7044[1] - _e7039[1]) * _e6779));
                                                    let _e7056 = (_e7039[2] + ((_e7044[2] - _e7039[2]) * _e6779));
                                                    let _e7058 = local_7.member_2[1u];
                                                    let _e7063 = local_7.member_2[0u];
                                                    let _e7067 = (_e7058[0] - _e7063[0]);
                                                    let _e7068 = (_e7058[1] - _e7063[1]);
                                                    let _e7069 = (_e7058[2] - _e7063[2]);
                                                    let _e7072 = select(_e7067, -(_e7067), (_e7067 < 0f));
                                                    let _e7075 = select(_e7068, -(_e7068), (_e7068 < 0f));
                                                    let _e7077 = select(_e7075, _e7072, (_e7072 > _e7075));
                                                    let _e7080 = select(_e7069, -(_e7069), (_e7069 < 0f));
                                                    let _e7088 = ((((_e6781 * select(_e7080, _e7077, (_e7077 > _e7080))) * 1.01f) + ((select(_e7034, _e7016, (_e7016 > _e7034)) + _e6998) * (0.000000059604645f * 8f))) + _e6998);
                                                    let _e7091 = select(_e7054, -(_e7054), (_e7054 < 0f));
                                                    let _e7094 = select(_e7055, -(_e7055), (_e7055 < 0f));
                                                    let _e7096 = select(_e7094, _e7091, (_e7091 > _e7094));
                                                    let _e7099 = select(_e7056, -(_e7056), (_e7056 < 0f));
                                                    let _e7102 = (select(_e7099, _e7096, (_e7096 > _e7099)) + _e7088);
                                                    let _e7105 = ((_e6948 * _e7056) - (_e6949 * _e7055));
                                                    let _e7108 = ((_e6949 * _e7054) - (_e6947 * _e7056));
                                                    let _e7111 = ((_e6947 * _e7055) - (_e6948 * _e7054));
                                                    let _e7126 = select(false, (select(_e7105, -(_e7105), (_e7105 < 0f)) > select(_e7111, -(_e7111), (_e7111 < 0f))), (select(_e7105, -(_e7105), (_e7105 < 0f)) > select(_e7108, -(_e7108), (_e7108 < 0f))));
                                                    let _e7141 = select((select(_e7108, -(_e7108), (_e7108 < 0f)) > select(_e7111, -(_e7111), (_e7111 < 0f))), false, (select(_e7105, -(_e7105), (_e7105 < 0f)) > select(_e7108, -(_e7108), (_e7108 < 0f))));
                                                    let _e7144 = select(select(_e6840, _e6841, _e7126), _e6842, _e7141);
                                                    let _e7145 = select(select(_e6841, _e6842, _e7126), _e6840, _e7141);
                                                    let _e7148 = select(select(_e6947, _e6948, _e7126), _e6949, _e7141);
                                                    let _e7149 = select(select(_e6948, _e6949, _e7126), _e6947, _e7141);
                                                    let _e7152 = select(select(_e7054, _e7055, _e7126), _e7056, _e7141);
                                                    let _e7153 = select(select(_e7055, _e7056, _e7126), _e7054, _e7141);
                                                    let _e7156 = ((_e7148 * _e7153) - (_e7149 * _e7152));
                                                    let _e7172 = (((((_e6981 * _e7102) + (_e6995 * _e7088)) * 2.01f) + (((_e6995 * 2f) * (_e7102 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6995) * (1f + _e7102))));
                                                    if (select(_e7156, -(_e7156), (_e7156 < 0f)) > _e7172) {
                                                        let _e7178 = select(1f, -1f, (_e7156 < 0f));
                                                        let _e7197 = (((((_e6874 * _e7102) + (_e6888 * _e7088)) * 2.01f) + (((_e6888 * 2f) * (_e7102 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6888) * (1f + _e7102))));
                                                        let _e7216 = (((((_e6981 * _e6888) + (_e6995 * _e6874)) * 2.01f) + (((_e6995 * 2f) * (_e6888 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6995) * (1f + _e6888))));
                                                        let _e7217 = (_e7156 * _e7178);
                                                        let _e7218 = (((_e7144 * _e7153) - (_e7145 * _e7152)) * _e7178);
                                                        let _e7219 = (((_e7148 * _e7145) - (_e7149 * _e7144)) * _e7178);
                                                        let _e7232 = (((select(_e7217, -(_e7217), (_e7217 < 0f)) + select(_e7218, -(_e7218), (_e7218 < 0f))) + select(_e7219, -(_e7219), (_e7219 < 0f))) * (0.000000059604645f * 4f));
                                                        if (_e283.member != 0u) {
                                                            phi_11665_ = array<type_16, 4>(type_16(_e7218, _e7197), type_16(_e7219, _e7216), type_16((_e7217 - _e7218), ((_e7172 + _e7197) + _e7232)), type_16((_e7217 - _e7219), ((_e7172 + _e7216) + _e7232)));
                                                        } else {
                                                            let _e7235 = ((_e7217 - _e7218) - _e7219);
                                                            let _e7238 = (((_e7172 + _e7197) + _e7216) + _e7232);
                                                            phi_11665_ = array<type_16, 4>(type_16(_e7218, _e7197), type_16(_e7219, _e7216), type_16(_e7235, _e7238), type_16(_e7235, _e7238));
                                                        }
                                                        let _e7256 = phi_11665_;
                                                        local_2 = array<type_16, 4>(type_16(_e7256[0].member, _e7256[0].member_1), type_16(_e7256[1].member, _e7256[1].member_1), type_16(_e7256[2].member, _e7256[2].member_1), type_16(_e7256[3].member, _e7256[3].member_1));
                                                        phi_11685_ = type_9(0u, 4u);
                                                        phi_11688_ = true;
                                                        loop {
                                                            let _e7275 = phi_11685_;
                                                            let _e7277 = phi_11688_;
                                                            local_65 = _e7277;
                                                            let _e7280 = (_e7275.member < _e7275.member_1);
                                                            let _e7291 = select(type_9().member_1, _e7275.member, _e7280);
                                                            if (bitcast<i32>(select(0u, 1u, _e7280)) != 0i) {
                                                                let _e7296 = local_2[_e7291].member;
                                                                let _e7299 = local_2[_e7291].member_1;
                                                                let _e7301 = (_e7296 < -(_e7299));
                                                                phi_11689_ = select((_e7277 && (_e7296 > _e7299)), bool(), _e7301);
                                                                phi_11740_ = select(true, false, _e7301);
                                                                phi_11741_ = _e7301;
                                                            } else {
                                                                phi_11689_ = bool();
                                                                phi_11740_ = false;
                                                                phi_11741_ = false;
                                                            }
                                                            let _e7307 = phi_11689_;
                                                            let _e7309 = phi_11740_;
                                                            let _e7311 = phi_11741_;
                                                            local_64 = _e7311;
                                                            continue;
                                                            continuing {
                                                                phi_11685_ = type_9(select(_e7275.member, (_e7275.member + 1u), _e7280), select(_e7275.member_1, _e7275.member_1, _e7280));
                                                                phi_11688_ = _e7307;
                                                                break if !(_e7309);
                                                            }
                                                        }
                                                        let _e7314 = local_64;
                                                        let _e7315 = select(true, false, _e7314);
                                                        let _e7317 = local_65;
                                                        phi_11755_ = select(u32(), select(2u, 1u, _e7317), _e7315);
                                                        phi_11756_ = 0u;
                                                        phi_11757_ = select(true, false, _e7315);
                                                    } else {
                                                        phi_11755_ = u32();
                                                        phi_11756_ = 2u;
                                                        phi_11757_ = true;
                                                    }
                                                    let _e7322 = phi_11755_;
                                                    let _e7324 = phi_11756_;
                                                    let _e7326 = phi_11757_;
                                                    let _e7327 = select(_e7322, _e7324, _e7326);
                                                    let _e7328 = (_e7327 == 0u);
                                                    if _e7328 {
                                                        phi_11788_ = bool();
                                                        phi_11789_ = false;
                                                        phi_11790_ = false;
                                                    } else {
                                                        let _e7331 = select(false, _e6769.member_2, (_e7327 == 1u));
                                                        let _e7337 = select(true, select(true, false, ((_e6769.member_1 - _e6769.member) <= _e6384)), _e7331);
                                                        phi_11788_ = _e7331;
                                                        phi_11789_ = _e7337;
                                                        phi_11790_ = select(true, false, _e7337);
                                                    }
                                                    let _e7340 = phi_11788_;
                                                    let _e7342 = phi_11789_;
                                                    let _e7344 = phi_11790_;
                                                    phi_11791_ = _e7340;
                                                    phi_11792_ = _e7328;
                                                    phi_11793_ = _e7342;
                                                    phi_11794_ = _e7344;
                                                }
                                                let _e7346 = phi_11791_;
                                                let _e7348 = phi_11792_;
                                                let _e7350 = phi_11793_;
                                                let _e7352 = phi_11794_;
                                                phi_11795_ = _e7346;
                                                phi_11796_ = _e7348;
                                                phi_11797_ = _e7350;
                                                phi_11798_ = _e6774;
                                                phi_11799_ = _e7352;
                                            }
                                            let _e7354 = phi_11795_;
                                            let _e7356 = phi_11796_;
                                            let _e7358 = phi_11797_;
                                            let _e7360 = phi_11798_;
                                            let _e7362 = phi_11799_;
                                            phi_11800_ = _e6769;
                                            phi_11801_ = _e7354;
                                            phi_11802_ = _e6769;
                                            phi_11803_ = _e7356;
                                            phi_11804_ = _e7358;
                                            phi_11805_ = _e7360;
                                            phi_11806_ = _e7362;
                                        }
                                        let _e7364 = phi_11800_;
                                        let _e7366 = phi_11801_;
                                        let _e7368 = phi_11802_;
                                        let _e7370 = phi_11803_;
                                        let _e7372 = phi_11804_;
                                        let _e7374 = phi_11805_;
                                        let _e7376 = phi_11806_;
                                        phi_11807_ = _e7364;
                                        phi_11808_ = _e7366;
                                        phi_11809_ = _e7368;
                                        phi_11810_ = _e7370;
                                        phi_11811_ = _e7372;
                                        phi_11812_ = _e6449;
                                        phi_11813_ = _e7374;
                                        phi_11814_ = _e7376;
                                    } else {
                                        phi_11807_ = type_45();
                                        phi_11808_ = bool();
                                        phi_11809_ = type_45();
                                        phi_11810_ = true;
                                        phi_11811_ = false;
                                        phi_11812_ = false;
                                        phi_11813_ = false;
                                        phi_11814_ = false;
                                    }
                                    let _e7378 = phi_11807_;
                                    let _e7380 = phi_11808_;
                                    let _e7382 = phi_11809_;
                                    let _e7384 = phi_11810_;
                                    let _e7386 = phi_11811_;
                                    let _e7388 = phi_11812_;
                                    let _e7390 = phi_11813_;
                                    let _e7392 = phi_11814_;
                                    phi_11822_ = _e7378;
                                    phi_11823_ = _e7380;
                                    phi_11824_ = _e7382;
                                    phi_11825_ = select(_e7386, false, _e7384);
                                    phi_11826_ = _e7384;
                                    phi_11827_ = select(_e7388, false, _e7384);
                                    phi_11828_ = select(_e7390, false, _e7384);
                                    phi_11829_ = select(_e7392, false, _e7384);
                                } else {
                                    phi_11822_ = type_45(_e5555, _e5555, false);
                                    phi_11823_ = false;
                                    phi_11824_ = type_45();
                                    phi_11825_ = true;
                                    phi_11826_ = false;
                                    phi_11827_ = false;
                                    phi_11828_ = false;
                                    phi_11829_ = false;
                                }
                                let _e7398 = phi_11822_;
                                let _e7400 = phi_11823_;
                                let _e7402 = phi_11824_;
                                let _e7404 = phi_11825_;
                                let _e7406 = phi_11826_;
                                let _e7408 = phi_11827_;
                                let _e7410 = phi_11828_;
                                let _e7412 = phi_11829_;
                                if _e7404 {
                                    let _e7417 = local_7.member[0u];
                                    let _e7423 = local_7.member_1[0u];
                                    let _e7429 = local_7.member_2[0u];
                                    let _e7433 = (_e7417[0] - _e7423[0]);
                                    let _e7434 = (_e7417[1] - _e7423[1]);
                                    let _e7435 = (_e7417[2] - _e7423[2]);
                                    let _e7436 = (_e283.member == 0u);
                                    let _e7448 = local_7.member[1u];
                                    let _e7454 = local_7.member_1[1u];
                                    let _e7460 = local_7.member_2[1u];
                                    let _e7464 = (_e7448[0] - _e7454[0]);
                                    let _e7465 = (_e7448[1] - _e7454[1]);
                                    let _e7466 = (_e7448[2] - _e7454[2]);
                                    let _e7467 = (_e283.member == 0u);
                                    let _e7479 = local_7.member[0u];
                                    let _e7485 = select(_e7479[0], -(_e7479[0]), (_e7479[0] < 0f));
                                    let _e7488 = select(_e7479[1], -(_e7479[1]), (_e7479[1] < 0f));
                                    let _e7490 = select(_e7488, _e7485, (_e7485 > _e7488));
                                    let _e7493 = select(_e7479[2], -(_e7479[2]), (_e7479[2] < 0f));
                                    let _e7495 = select(_e7493, _e7490, (_e7490 > _e7493));
                                    let _e7498 = local_7.member[1u];
                                    let _e7504 = select(_e7498[0], -(_e7498[0]), (_e7498[0] < 0f));
                                    let _e7507 = select(_e7498[1], -(_e7498[1]), (_e7498[1] < 0f));
                                    let _e7509 = select(_e7507, _e7504, (_e7504 > _e7507));
                                    let _e7512 = select(_e7498[2], -(_e7498[2]), (_e7498[2] < 0f));
                                    let _e7514 = select(_e7512, _e7509, (_e7509 > _e7512));
                                    let _e7518 = local_7.member_3;
                                    let _e7522 = local_7.member_1[0u];
                                    let _e7528 = select(_e7522[0], -(_e7522[0]), (_e7522[0] < 0f));
                                    let _e7531 = select(_e7522[1], -(_e7522[1]), (_e7522[1] < 0f));
                                    let _e7533 = select(_e7531, _e7528, (_e7528 > _e7531));
                                    let _e7536 = select(_e7522[2], -(_e7522[2]), (_e7522[2] < 0f));
                                    let _e7538 = select(_e7536, _e7533, (_e7533 > _e7536));
                                    let _e7541 = local_7.member_1[1u];
                                    let _e7547 = select(_e7541[0], -(_e7541[0]), (_e7541[0] < 0f));
                                    let _e7550 = select(_e7541[1], -(_e7541[1]), (_e7541[1] < 0f));
                                    let _e7552 = select(_e7550, _e7547, (_e7547 > _e7550));
                                    let _e7555 = select(_e7541[2], -(_e7541[2]), (_e7541[2] < 0f));
                                    let _e7557 = select(_e7555, _e7552, (_e7552 > _e7555));
                                    let _e7561 = local_7.member_3;
                                    let _e7565 = local_7.member_2[0u];
                                    let _e7571 = select(_e7565[0], -(_e7565[0]), (_e7565[0] < 0f));
                                    let _e7574 = select(_e7565[1], -(_e7565[1]), (_e7565[1] < 0f));
                                    let _e7576 = select(_e7574, _e7571, (_e7571 > _e7574));
                                    let _e7579 = select(_e7565[2], -(_e7565[2]), (_e7565[2] < 0f));
                                    let _e7581 = select(_e7579, _e7576, (_e7576 > _e7579));
                                    let _e7584 = local_7.member_2[1u];
                                    let _e7590 = select(_e7584[0], -(_e7584[0]), (_e7584[0] < 0f));
                                    let _e7593 = select(_e7584[1], -(_e7584[1]), (_e7584[1] < 0f));
                                    let _e7595 = select(_e7593, _e7590, (_e7590 > _e7593));
                                    let _e7598 = select(_e7584[2], -(_e7584[2]), (_e7584[2] < 0f));
                                    let _e7600 = select(_e7598, _e7595, (_e7595 > _e7598));
                                    let _e7604 = local_7.member_3;
                                    let _e7611 = local_7.member_3;
                                    let _e7616 = (_e5553 * 0.00390625f);
                                    local = type_28(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    phi_12252_ = type_9(0u, 96u);
                                    phi_12255_ = _e7398.member;
                                    phi_12257_ = _e7398.member;
                                    phi_12259_ = (_e7398.member_1 - _e7398.member);
                                    phi_12261_ = _e7398.member;
                                    phi_12263_ = false;
                                    phi_12265_ = 0u;
                                    loop {
                                        let _e7619 = phi_12252_;
                                        let _e7621 = phi_12255_;
                                        let _e7623 = phi_12257_;
                                        let _e7625 = phi_12259_;
                                        let _e7627 = phi_12261_;
                                        let _e7629 = phi_12263_;
                                        let _e7631 = phi_12265_;
                                        local_75 = _e7621;
                                        local_78 = _e7623;
                                        let _e7634 = (_e7619.member < _e7619.member_1);
                                        if (bitcast<i32>(select(0u, 1u, _e7634)) != 0i) {
                                            let _e7648 = local_7.member[0u];
                                            let _e7654 = local_7.member[1u];
                                            let _e7670 = local_7.member_1[0u];
                                            let _e7676 = local_7.member_1[1u];
                                            let _e7692 = local_7.member_2[0u];
                                            let _e7698 = local_7.member_2[1u];
                                            let _e7712 = function_4(array<f32, 3>((_e7648[0] + ((_e7654[0] - _e7648[0]) * _e7621)), (_e7648[1] + ((_e7654[1] - _e7648[1]) * _e7621)), (_e7648[2] + ((_e7654[2] - _e7648[2]) * _e7621))), array<f32, 3>((_e7670[0] + ((_e7676[0] - _e7670[0]) * _e7621)), (_e7670[1] + ((_e7676[1] - _e7670[1]) * _e7621)), (_e7670[2] + ((_e7676[2] - _e7670[2]) * _e7621))), array<f32, 3>((_e7692[0] + ((_e7698[0] - _e7692[0]) * _e7621)), (_e7692[1] + ((_e7698[1] - _e7692[1]) * _e7621)), (_e7692[2] + ((_e7698[2] - _e7692[2]) * _e7621))), _e283.member);
                                            if (_e7631 == 0u) {
                                                phi_12416_ = _e7712;
                                            } else {
                                                phi_12416_ = array<f32, 3>(select(0f, _e7712[0], (_e7631 == 1u)), select(0f, _e7712[1], (_e7631 == 2u)), select(0f, _e7712[2], (_e7631 == 3u)));
                                            }
                                            let _e7725 = phi_12416_;
                                            let _e7739 = ((select(_e7725[0], -(_e7725[0]), (_e7725[0] < 0f)) + select(_e7725[1], -(_e7725[1]), (_e7725[1] < 0f))) + select(_e7725[2], -(_e7725[2]), (_e7725[2] < 0f)));
                                            if (_e7739 > 0f) {
                                                if ((bitcast<u32>(_e7739) & 2139095040u) != 2139095040u) {
                                                    let _e7744 = (1f / _e7739);
                                                    let _e7746 = (_e7725[0] * _e7744);
                                                    let _e7748 = (_e7725[1] * _e7744);
                                                    let _e7750 = (_e7725[2] * _e7744);
                                                    let _e7755 = (((_e7746 * _e7746) + (_e7748 * _e7748)) + (_e7750 * _e7750));
                                                    if (_e7755 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_12539_ = select(0f, (0.000000000000000000106433627f * 2f), (_e7755 > 0f));
                                                    } else {
                                                        phi_12482_ = type_14(0i, 5i);
                                                        phi_12485_ = bitcast<f32>(((bitcast<u32>(_e7755) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e7763 = phi_12482_;
                                                            let _e7765 = phi_12485_;
                                                            local_66 = _e7765;
                                                            if (_e7763.member < _e7763.member_1) {
                                                                let _e7772 = (_e7763.member + 1i);
                                                                phi_12483_ = type_14(select(_e7772, type_15().member_1, select(false, true, ((false == (_e7772 > _e7763.member)) != false))), _e7763.member_1);
                                                                phi_12526_ = type_15(1u, _e7763.member);
                                                            } else {
                                                                phi_12483_ = _e7763;
                                                                phi_12526_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e7783 = phi_12483_;
                                                            let _e7785 = phi_12526_;
                                                            let _e7788 = (bitcast<i32>(_e7785.member) != 0i);
                                                            if _e7788 {
                                                                phi_12486_ = (0.5f * (_e7765 + (_e7755 / _e7765)));
                                                            } else {
                                                                phi_12486_ = f32();
                                                            }
                                                            let _e7793 = phi_12486_;
                                                            continue;
                                                            continuing {
                                                                phi_12482_ = _e7783;
                                                                phi_12485_ = _e7793;
                                                                break if !(_e7788);
                                                            }
                                                        }
                                                        let _e7798 = local_66;
                                                        phi_12539_ = (_e7798 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e7804 = phi_12539_;
                                                    let _e7805 = (0.000000059604645f * 12f);
                                                    let _e7810 = ((((((((select(_e7514, _e7495, (_e7495 > _e7514)) + _e7518) + (select(_e7557, _e7538, (_e7538 > _e7557)) + _e7561)) + (select(_e7600, _e7581, (_e7581 > _e7600)) + _e7604)) * (0.000000059604645f * 16f)) + (_e7611 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e7804) * (1f + _e7805)));
                                                    let _e7815 = (((_e7746 * _e7417[0]) + (_e7748 * _e7417[1])) + (_e7750 * _e7417[2]));
                                                    let _e7820 = (((_e7746 * _e7433) + (_e7748 * _e7434)) + (_e7750 * _e7435));
                                                    let _e7825 = (((_e7746 * (_e7417[0] - _e7429[0])) + (_e7748 * (_e7417[1] - _e7429[1]))) + (_e7750 * (_e7417[2] - _e7429[2])));
                                                    let _e7830 = (((_e7746 * select((_e7433 - _e7429[0]), _e7417[0], _e7436)) + (_e7748 * select((_e7434 - _e7429[1]), _e7417[1], _e7436))) + (_e7750 * select((_e7435 - _e7429[2]), _e7417[2], _e7436)));
                                                    let _e7836 = (((_e7746 * _e7448[0]) + (_e7748 * _e7448[1])) + (_e7750 * _e7448[2]));
                                                    let _e7841 = (((_e7746 * _e7464) + (_e7748 * _e7465)) + (_e7750 * _e7466));
                                                    let _e7846 = (((_e7746 * (_e7448[0] - _e7460[0])) + (_e7748 * (_e7448[1] - _e7460[1]))) + (_e7750 * (_e7448[2] - _e7460[2])));
                                                    let _e7851 = (((_e7746 * select((_e7464 - _e7460[0]), _e7448[0], _e7467)) + (_e7748 * select((_e7465 - _e7460[1]), _e7448[1], _e7467))) + (_e7750 * select((_e7466 - _e7460[2]), _e7448[2], _e7467)));
                                                    phi_12662_ = type_28(array<f32, 4>(_e7815, _e7820, _e7825, _e7830), array<f32, 4>(_e7836, _e7841, _e7846, _e7851), array<f32, 4>((_e7810 + ((select(_e7815, -(_e7815), (_e7815 < 0f)) + select(_e7836, -(_e7836), (_e7836 < 0f))) * _e7805)), (_e7810 + ((select(_e7820, -(_e7820), (_e7820 < 0f)) + select(_e7841, -(_e7841), (_e7841 < 0f))) * _e7805)), (_e7810 + ((select(_e7825, -(_e7825), (_e7825 < 0f)) + select(_e7846, -(_e7846), (_e7846 < 0f))) * _e7805)), (_e7810 + ((select(_e7830, -(_e7830), (_e7830 < 0f)) + select(_e7851, -(_e7851), (_e7851 < 0f))) * _e7805))));
                                                    phi_12663_ = false;
                                                } else {
                                                    phi_12662_ = type_28();
                                                    phi_12663_ = true;
                                                }
                                                let _e7892 = phi_12662_;
                                                let _e7894 = phi_12663_;
                                                phi_12664_ = _e7892;
                                                phi_12665_ = _e7894;
                                            } else {
                                                phi_12664_ = type_28();
                                                phi_12665_ = true;
                                            }
                                            let _e7896 = phi_12664_;
                                            let _e7898 = phi_12665_;
                                            if _e7898 {
                                                phi_12673_ = type_28(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            } else {
                                                phi_12673_ = _e7896;
                                            }
                                            let _e7900 = phi_12673_;
                                            local_1 = type_28(array<f32, 4>(_e7900.member[0], _e7900.member[1], _e7900.member[2], _e7900.member[3]), array<f32, 4>(_e7900.member_1[0], _e7900.member_1[1], _e7900.member_1[2], _e7900.member_1[3]), array<f32, 4>(_e7900.member_2[0], _e7900.member_2[1], _e7900.member_2[2], _e7900.member_2[3]));
                                            let _e7920 = (_e7621 - _e7627);
                                            let _e7924 = local_1.member[0u];
                                            let _e7927 = local_1.member_1[0u];
                                            let _e7930 = local_1.member[0u];
                                            let _e7936 = local_1.member_2[0u];
                                            if (((_e7924 + ((_e7927 - _e7930) * _e7621)) - _e7936) > 0f) {
                                                let _e7941 = local_1.member[1u];
                                                let _e7944 = local_1.member_1[1u];
                                                let _e7947 = local_1.member[1u];
                                                let _e7953 = local_1.member_2[1u];
                                                if (((_e7941 + ((_e7944 - _e7947) * _e7621)) - _e7953) > 0f) {
                                                    let _e7958 = local_1.member[2u];
                                                    let _e7961 = local_1.member_1[2u];
                                                    let _e7964 = local_1.member[2u];
                                                    let _e7970 = local_1.member_2[2u];
                                                    if (((_e7958 + ((_e7961 - _e7964) * _e7621)) - _e7970) > 0f) {
                                                        let _e7975 = local_1.member[3u];
                                                        let _e7978 = local_1.member_1[3u];
                                                        let _e7981 = local_1.member[3u];
                                                        let _e7987 = local_1.member_2[3u];
                                                        phi_12844_ = (((_e7975 + ((_e7978 - _e7981) * _e7621)) - _e7987) > 0f);
                                                        phi_12845_ = false;
                                                    } else {
                                                        phi_12844_ = bool();
                                                        phi_12845_ = true;
                                                    }
                                                    let _e7991 = phi_12844_;
                                                    let _e7993 = phi_12845_;
                                                    phi_12846_ = _e7991;
                                                    phi_12847_ = _e7993;
                                                } else {
                                                    phi_12846_ = bool();
                                                    phi_12847_ = true;
                                                }
                                                let _e7995 = phi_12846_;
                                                let _e7997 = phi_12847_;
                                                phi_12848_ = _e7995;
                                                phi_12849_ = _e7997;
                                            } else {
                                                phi_12848_ = bool();
                                                phi_12849_ = true;
                                            }
                                            let _e7999 = phi_12848_;
                                            let _e8001 = phi_12849_;
                                            if select(_e7999, false, _e8001) {
                                                if (_e7621 <= _e7623) {
                                                    phi_13163_ = true;
                                                } else {
                                                    let _e8006 = local.member[0u];
                                                    let _e8009 = local.member_1[0u];
                                                    let _e8012 = local.member[0u];
                                                    let _e8018 = local.member_2[0u];
                                                    let _e8022 = local_1.member[0u];
                                                    let _e8025 = local_1.member_1[0u];
                                                    let _e8028 = local_1.member[0u];
                                                    let _e8034 = local_1.member_2[0u];
                                                    if ((((_e8006 + ((_e8009 - _e8012) * _e7621)) - _e8018) + ((_e8022 + ((_e8025 - _e8028) * _e7627)) - _e8034)) > 0f) {
                                                        let _e8040 = local.member[1u];
                                                        let _e8043 = local.member_1[1u];
                                                        let _e8046 = local.member[1u];
                                                        let _e8052 = local.member_2[1u];
                                                        let _e8056 = local_1.member[1u];
                                                        let _e8059 = local_1.member_1[1u];
                                                        let _e8062 = local_1.member[1u];
                                                        let _e8068 = local_1.member_2[1u];
                                                        if ((((_e8040 + ((_e8043 - _e8046) * _e7621)) - _e8052) + ((_e8056 + ((_e8059 - _e8062) * _e7627)) - _e8068)) > 0f) {
                                                            let _e8074 = local.member[2u];
                                                            let _e8077 = local.member_1[2u];
                                                            let _e8080 = local.member[2u];
                                                            let _e8086 = local.member_2[2u];
                                                            let _e8090 = local_1.member[2u];
                                                            let _e8093 = local_1.member_1[2u];
                                                            let _e8096 = local_1.member[2u];
                                                            let _e8102 = local_1.member_2[2u];
                                                            if ((((_e8074 + ((_e8077 - _e8080) * _e7621)) - _e8086) + ((_e8090 + ((_e8093 - _e8096) * _e7627)) - _e8102)) > 0f) {
                                                                let _e8108 = local.member[3u];
                                                                let _e8111 = local.member_1[3u];
                                                                let _e8114 = local.member[3u];
                                                                let _e8120 = local.member_2[3u];
                                                                let _e8124 = local_1.member[3u];
                                                                let _e8127 = local_1.member_1[3u];
                                                                let _e8130 = local_1.member[3u];
                                                                let _e8136 = local_1.member_2[3u];
                                                                phi_13150_ = ((((_e8108 + ((_e8111 - _e8114) * _e7621)) - _e8120) + ((_e8124 + ((_e8127 - _e8130) * _e7627)) - _e8136)) > 0f);
                                                                phi_13151_ = false;
                                                            } else {
                                                                phi_13150_ = bool();
                                                                phi_13151_ = true;
                                                            }
                                                            let _e8141 = phi_13150_;
                                                            let _e8143 = phi_13151_;
                                                            phi_13152_ = _e8141;
                                                            phi_13153_ = _e8143;
                                                        } else {
                                                            phi_13152_ = bool();
                                                            phi_13153_ = true;
                                                        }
                                                        let _e8145 = phi_13152_;
                                                        let _e8147 = phi_13153_;
                                                        phi_13154_ = _e8145;
                                                        phi_13155_ = _e8147;
                                                    } else {
                                                        phi_13154_ = bool();
                                                        phi_13155_ = true;
                                                    }
                                                    let _e8149 = phi_13154_;
                                                    let _e8151 = phi_13155_;
                                                    phi_13163_ = select(_e8149, false, _e8151);
                                                }
                                                let _e8154 = phi_13163_;
                                                if _e8154 {
                                                    if select(true, select(true, false, (_e7621 >= _e7398.member_1)), _e7629) {
                                                        local = type_28(array<f32, 4>(_e7900.member[0], _e7900.member[1], _e7900.member[2], _e7900.member[3]), array<f32, 4>(_e7900.member_1[0], _e7900.member_1[1], _e7900.member_1[2], _e7900.member_1[3]), array<f32, 4>(_e7900.member_2[0], _e7900.member_2[1], _e7900.member_2[2], _e7900.member_2[3]));
                                                        let _e8179 = local.member[0u];
                                                        let _e8182 = local.member_1[0u];
                                                        let _e8185 = local.member_2[0u];
                                                        if select(true, select(true, false, (_e8182 > _e8185)), (_e8179 > _e8185)) {
                                                            let _e8190 = (_e8182 >= _e8179);
                                                            if _e8190 {
                                                                phi_13272_ = f32();
                                                                phi_13273_ = false;
                                                            } else {
                                                                if ((_e8179 - _e8182) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_13270_ = (((_e8179 - _e8185) / (_e8179 - _e8182)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_13271_ = false;
                                                                } else {
                                                                    phi_13270_ = f32();
                                                                    phi_13271_ = true;
                                                                }
                                                                let _e8201 = phi_13270_;
                                                                let _e8203 = phi_13271_;
                                                                phi_13272_ = _e8201;
                                                                phi_13273_ = _e8203;
                                                            }
                                                            let _e8205 = phi_13272_;
                                                            let _e8207 = phi_13273_;
                                                            phi_13274_ = _e8205;
                                                            phi_13275_ = _e8190;
                                                            phi_13276_ = _e8207;
                                                        } else {
                                                            phi_13274_ = f32();
                                                            phi_13275_ = true;
                                                            phi_13276_ = false;
                                                        }
                                                        let _e8209 = phi_13274_;
                                                        let _e8211 = phi_13275_;
                                                        let _e8213 = phi_13276_;
                                                        let _e8216 = select(_e8209, select(_e7621, 2f, _e8211), select(_e8213, true, _e8211));
                                                        let _e8219 = local.member[1u];
                                                        let _e8222 = local.member_1[1u];
                                                        let _e8225 = local.member_2[1u];
                                                        if select(true, select(true, false, (_e8222 > _e8225)), (_e8219 > _e8225)) {
                                                            let _e8230 = (_e8222 >= _e8219);
                                                            if _e8230 {
                                                                phi_13340_ = f32();
                                                                phi_13341_ = false;
                                                            } else {
                                                                if ((_e8219 - _e8222) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_13338_ = (((_e8219 - _e8225) / (_e8219 - _e8222)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_13339_ = false;
                                                                } else {
                                                                    phi_13338_ = f32();
                                                                    phi_13339_ = true;
                                                                }
                                                                let _e8241 = phi_13338_;
                                                                let _e8243 = phi_13339_;
                                                                phi_13340_ = _e8241;
                                                                phi_13341_ = _e8243;
                                                            }
                                                            let _e8245 = phi_13340_;
                                                            let _e8247 = phi_13341_;
                                                            phi_13342_ = _e8245;
                                                            phi_13343_ = _e8230;
                                                            phi_13344_ = _e8247;
                                                        } else {
                                                            phi_13342_ = f32();
                                                            phi_13343_ = true;
                                                            phi_13344_ = false;
                                                        }
                                                        let _e8249 = phi_13342_;
                                                        let _e8251 = phi_13343_;
                                                        let _e8253 = phi_13344_;
                                                        let _e8256 = select(_e8249, select(_e7621, 2f, _e8251), select(_e8253, true, _e8251));
                                                        let _e8258 = select(_e8256, _e8216, (_e8216 < _e8256));
                                                        let _e8261 = local.member[2u];
                                                        let _e8264 = local.member_1[2u];
                                                        let _e8267 = local.member_2[2u];
                                                        if select(true, select(true, false, (_e8264 > _e8267)), (_e8261 > _e8267)) {
                                                            let _e8272 = (_e8264 >= _e8261);
                                                            if _e8272 {
                                                                phi_13413_ = f32();
                                                                phi_13414_ = false;
                                                            } else {
                                                                if ((_e8261 - _e8264) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_13411_ = (((_e8261 - _e8267) / (_e8261 - _e8264)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_13412_ = false;
                                                                } else {
                                                                    phi_13411_ = f32();
                                                                    phi_13412_ = true;
                                                                }
                                                                let _e8283 = phi_13411_;
                                                                let _e8285 = phi_13412_;
                                                                phi_13413_ = _e8283;
                                                                phi_13414_ = _e8285;
                                                            }
                                                            let _e8287 = phi_13413_;
                                                            let _e8289 = phi_13414_;
                                                            phi_13415_ = _e8287;
                                                            phi_13416_ = _e8272;
                                                            phi_13417_ = _e8289;
                                                        } else {
                                                            phi_13415_ = f32();
                                                            phi_13416_ = true;
                                                            phi_13417_ = false;
                                                        }
                                                        let _e8291 = phi_13415_;
                                                        let _e8293 = phi_13416_;
                                                        let _e8295 = phi_13417_;
                                                        let _e8298 = select(_e8291, select(_e7621, 2f, _e8293), select(_e8295, true, _e8293));
                                                        let _e8301 = local.member[3u];
                                                        let _e8304 = local.member_1[3u];
                                                        let _e8307 = local.member_2[3u];
                                                        if select(true, select(true, false, (_e8304 > _e8307)), (_e8301 > _e8307)) {
                                                            let _e8312 = (_e8304 >= _e8301);
                                                            if _e8312 {
                                                                phi_13481_ = f32();
                                                                phi_13482_ = false;
                                                            } else {
                                                                if ((_e8301 - _e8304) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_13479_ = (((_e8301 - _e8307) / (_e8301 - _e8304)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_13480_ = false;
                                                                } else {
                                                                    phi_13479_ = f32();
                                                                    phi_13480_ = true;
                                                                }
                                                                let _e8323 = phi_13479_;
                                                                let _e8325 = phi_13480_;
                                                                phi_13481_ = _e8323;
                                                                phi_13482_ = _e8325;
                                                            }
                                                            let _e8327 = phi_13481_;
                                                            let _e8329 = phi_13482_;
                                                            phi_13483_ = _e8327;
                                                            phi_13484_ = _e8312;
                                                            phi_13485_ = _e8329;
                                                        } else {
                                                            phi_13483_ = f32();
                                                            phi_13484_ = true;
                                                            phi_13485_ = false;
                                                        }
                                                        let _e8331 = phi_13483_;
                                                        let _e8333 = phi_13484_;
                                                        let _e8335 = phi_13485_;
                                                        let _e8338 = select(_e8331, select(_e7621, 2f, _e8333), select(_e8335, true, _e8333));
                                                        let _e8340 = select(_e8338, _e8298, (_e8298 < _e8338));
                                                        let _e8342 = select(_e8340, _e8258, (_e8258 < _e8340));
                                                        let _e8344 = select(_e7621, _e8342, (_e8342 > _e7621));
                                                        let _e8345 = (_e8344 > _e7398.member_1);
                                                        if _e8345 {
                                                            phi_14014_ = f32();
                                                            phi_14015_ = f32();
                                                            phi_14016_ = false;
                                                        } else {
                                                            let _e8346 = (_e8344 - _e7621);
                                                            phi_14014_ = select((_e7398.member_1 - _e7621), select(0f, (_e7920 + _e7920), select(select(true, false, (_e8346 <= (_e7625 * 0.25f))), true, (_e8346 <= _e7616))), _e7629);
                                                            phi_14015_ = _e8346;
                                                            phi_14016_ = true;
                                                        }
                                                        let _e8357 = phi_14014_;
                                                        let _e8359 = phi_14015_;
                                                        let _e8361 = phi_14016_;
                                                        phi_14018_ = _e8344;
                                                        phi_14019_ = _e8357;
                                                        phi_14020_ = _e8359;
                                                        phi_14022_ = _e8361;
                                                        phi_14023_ = _e8345;
                                                        phi_14025_ = false;
                                                    } else {
                                                        phi_14018_ = f32();
                                                        phi_14019_ = f32();
                                                        phi_14020_ = f32();
                                                        phi_14022_ = false;
                                                        phi_14023_ = false;
                                                        phi_14025_ = true;
                                                    }
                                                    let _e8363 = phi_14018_;
                                                    let _e8365 = phi_14019_;
                                                    let _e8367 = phi_14020_;
                                                    let _e8369 = phi_14022_;
                                                    let _e8371 = phi_14023_;
                                                    let _e8373 = phi_14025_;
                                                    phi_14026_ = _e8363;
                                                    phi_14027_ = _e8365;
                                                    phi_14028_ = _e8367;
                                                    phi_14030_ = false;
                                                    phi_14031_ = _e8369;
                                                    phi_14032_ = _e8371;
                                                    phi_14034_ = _e8373;
                                                } else {
                                                    phi_14026_ = f32();
                                                    phi_14027_ = f32();
                                                    phi_14028_ = f32();
                                                    phi_14030_ = true;
                                                    phi_14031_ = false;
                                                    phi_14032_ = false;
                                                    phi_14034_ = false;
                                                }
                                                let _e8375 = phi_14026_;
                                                let _e8377 = phi_14027_;
                                                let _e8379 = phi_14028_;
                                                let _e8381 = phi_14030_;
                                                let _e8383 = phi_14031_;
                                                let _e8385 = phi_14032_;
                                                let _e8387 = phi_14034_;
                                                phi_14035_ = _e8375;
                                                phi_14036_ = _e8377;
                                                phi_14037_ = _e8379;
                                                phi_14039_ = _e8381;
                                                phi_14040_ = _e8383;
                                                phi_14041_ = _e8385;
                                                phi_14043_ = _e8387;
                                            } else {
                                                phi_14035_ = f32();
                                                phi_14036_ = f32();
                                                phi_14037_ = f32();
                                                phi_14039_ = true;
                                                phi_14040_ = false;
                                                phi_14041_ = false;
                                                phi_14043_ = false;
                                            }
                                            let _e8389 = phi_14035_;
                                            let _e8391 = phi_14036_;
                                            let _e8393 = phi_14037_;
                                            let _e8395 = phi_14039_;
                                            let _e8397 = phi_14040_;
                                            let _e8399 = phi_14041_;
                                            let _e8401 = phi_14043_;
                                            if _e8395 {
                                                if (_e7621 <= _e7623) {
                                                    let _e8554 = (_e7631 + 1u);
                                                    let _e8555 = (_e8554 > 3u);
                                                    phi_14378_ = _e8554;
                                                    phi_14379_ = f32();
                                                    phi_14380_ = false;
                                                    phi_14381_ = select(true, false, _e8555);
                                                    phi_14382_ = _e8555;
                                                } else {
                                                    let _e8405 = local.member[0u];
                                                    let _e8408 = local.member_1[0u];
                                                    let _e8411 = local.member[0u];
                                                    let _e8417 = local.member_2[0u];
                                                    let _e8418 = ((_e8405 + ((_e8408 - _e8411) * _e7627)) - _e8417);
                                                    let _e8421 = local.member[1u];
                                                    let _e8424 = local.member_1[1u];
                                                    let _e8427 = local.member[1u];
                                                    let _e8433 = local.member_2[1u];
                                                    let _e8434 = ((_e8421 + ((_e8424 - _e8427) * _e7627)) - _e8433);
                                                    let _e8436 = select(_e8434, _e8418, (_e8418 < _e8434));
                                                    let _e8439 = local.member[2u];
                                                    let _e8442 = local.member_1[2u];
                                                    let _e8445 = local.member[2u];
                                                    let _e8451 = local.member_2[2u];
                                                    let _e8452 = ((_e8439 + ((_e8442 - _e8445) * _e7627)) - _e8451);
                                                    let _e8455 = local.member[3u];
                                                    let _e8458 = local.member_1[3u];
                                                    let _e8461 = local.member[3u];
                                                    let _e8467 = local.member_2[3u];
                                                    let _e8468 = ((_e8455 + ((_e8458 - _e8461) * _e7627)) - _e8467);
                                                    let _e8470 = select(_e8468, _e8452, (_e8452 < _e8468));
                                                    let _e8472 = select(_e8470, _e8436, (_e8436 < _e8470));
                                                    let _e8475 = local_1.member[0u];
                                                    let _e8478 = local_1.member_1[0u];
                                                    let _e8481 = local_1.member[0u];
                                                    let _e8487 = local_1.member_2[0u];
                                                    let _e8488 = ((_e8475 + ((_e8478 - _e8481) * _e7621)) - _e8487);
                                                    let _e8491 = local_1.member[1u];
                                                    let _e8494 = local_1.member_1[1u];
                                                    let _e8497 = local_1.member[1u];
                                                    let _e8503 = local_1.member_2[1u];
                                                    let _e8504 = ((_e8491 + ((_e8494 - _e8497) * _e7621)) - _e8503);
                                                    let _e8506 = select(_e8504, _e8488, (_e8488 < _e8504));
                                                    let _e8509 = local_1.member[2u];
                                                    let _e8512 = local_1.member_1[2u];
                                                    let _e8515 = local_1.member[2u];
                                                    let _e8521 = local_1.member_2[2u];
                                                    let _e8522 = ((_e8509 + ((_e8512 - _e8515) * _e7621)) - _e8521);
                                                    let _e8525 = local_1.member[3u];
                                                    let _e8528 = local_1.member_1[3u];
                                                    let _e8531 = local_1.member[3u];
                                                    let _e8537 = local_1.member_2[3u];
                                                    let _e8538 = ((_e8525 + ((_e8528 - _e8531) * _e7621)) - _e8537);
                                                    let _e8540 = select(_e8538, _e8522, (_e8522 < _e8538));
                                                    let _e8542 = select(_e8540, _e8506, (_e8506 < _e8540));
                                                    if (_e8542 > 0f) {
                                                        phi_14376_ = 0.5f;
                                                    } else {
                                                        let _e8546 = (0.95f * (_e8472 / (_e8472 - _e8542)));
                                                        phi_14376_ = select(0.0625f, select(0.9f, _e8546, (_e8546 < 0.9f)), (_e8546 > 0.0625f));
                                                    }
                                                    let _e8552 = phi_14376_;
                                                    phi_14378_ = u32();
                                                    phi_14379_ = (_e7920 * _e8552);
                                                    phi_14380_ = true;
                                                    phi_14381_ = false;
                                                    phi_14382_ = false;
                                                }
                                                let _e8558 = phi_14378_;
                                                let _e8560 = phi_14379_;
                                                let _e8562 = phi_14380_;
                                                let _e8564 = phi_14381_;
                                                let _e8566 = phi_14382_;
                                                phi_14383_ = _e8558;
                                                phi_14384_ = _e7623;
                                                phi_14385_ = _e8560;
                                                phi_14386_ = _e7625;
                                                phi_14387_ = _e7627;
                                                phi_14388_ = _e7629;
                                                phi_14389_ = _e7631;
                                                phi_14390_ = _e8562;
                                                phi_14391_ = _e8564;
                                                phi_14392_ = _e8566;
                                                phi_14393_ = false;
                                                phi_14395_ = false;
                                            } else {
                                                phi_14383_ = u32();
                                                phi_14384_ = _e8389;
                                                phi_14385_ = _e8391;
                                                phi_14386_ = _e8393;
                                                phi_14387_ = _e7621;
                                                phi_14388_ = true;
                                                phi_14389_ = 0u;
                                                phi_14390_ = _e8397;
                                                phi_14391_ = false;
                                                phi_14392_ = false;
                                                phi_14393_ = _e8399;
                                                phi_14395_ = _e8401;
                                            }
                                            let _e8568 = phi_14383_;
                                            let _e8570 = phi_14384_;
                                            let _e8572 = phi_14385_;
                                            let _e8574 = phi_14386_;
                                            let _e8576 = phi_14387_;
                                            let _e8578 = phi_14388_;
                                            let _e8580 = phi_14389_;
                                            let _e8582 = phi_14390_;
                                            let _e8584 = phi_14391_;
                                            let _e8586 = phi_14392_;
                                            let _e8588 = phi_14393_;
                                            let _e8590 = phi_14395_;
                                            if _e8582 {
                                                let _e8591 = (_e8576 + _e8572);
                                                let _e8593 = select(_e8570, _e8591, (_e8591 > _e8570));
                                                let _e8595 = select(_e7398.member_1, _e8593, (_e8593 < _e7398.member_1));
                                                let _e8598 = select(((_e8595 - _e8576) > _e7616), true, !(_e7629));
                                                phi_14423_ = _e8595;
                                                phi_14424_ = _e8570;
                                                phi_14425_ = _e8574;
                                                phi_14426_ = _e8576;
                                                phi_14427_ = _e8578;
                                                phi_14428_ = _e8580;
                                                phi_14429_ = _e8598;
                                                phi_14430_ = select(true, false, _e8598);
                                                phi_14431_ = false;
                                                phi_14432_ = false;
                                                phi_14434_ = false;
                                            } else {
                                                phi_14423_ = _e7621;
                                                phi_14424_ = _e7623;
                                                phi_14425_ = _e7625;
                                                phi_14426_ = _e7627;
                                                phi_14427_ = _e7629;
                                                phi_14428_ = _e8568;
                                                phi_14429_ = _e8584;
                                                phi_14430_ = false;
                                                phi_14431_ = _e8586;
                                                phi_14432_ = _e8588;
                                                phi_14434_ = _e8590;
                                            }
                                            let _e8601 = phi_14423_;
                                            let _e8603 = phi_14424_;
                                            let _e8605 = phi_14425_;
                                            let _e8607 = phi_14426_;
                                            let _e8609 = phi_14427_;
                                            let _e8611 = phi_14428_;
                                            let _e8613 = phi_14429_;
                                            let _e8615 = phi_14430_;
                                            let _e8617 = phi_14431_;
                                            let _e8619 = phi_14432_;
                                            let _e8621 = phi_14434_;
                                            phi_12256_ = _e8601;
                                            phi_12258_ = _e8603;
                                            phi_12260_ = _e8605;
                                            phi_12262_ = _e8607;
                                            phi_12264_ = _e8609;
                                            phi_12266_ = _e8611;
                                            phi_14435_ = _e8570;
                                            phi_14437_ = _e8613;
                                            phi_14438_ = _e8615;
                                            phi_14439_ = _e8617;
                                            phi_14440_ = _e8619;
                                            phi_14442_ = false;
                                            phi_14443_ = _e8621;
                                        } else {
                                            phi_12256_ = f32();
                                            phi_12258_ = f32();
                                            phi_12260_ = f32();
                                            phi_12262_ = f32();
                                            phi_12264_ = bool();
                                            phi_12266_ = u32();
                                            phi_14435_ = f32();
                                            phi_14437_ = false;
                                            phi_14438_ = false;
                                            phi_14439_ = false;
                                            phi_14440_ = false;
                                            phi_14442_ = true;
                                            phi_14443_ = false;
                                        }
                                        let _e8623 = phi_12256_;
                                        let _e8625 = phi_12258_;
                                        let _e8627 = phi_12260_;
                                        let _e8629 = phi_12262_;
                                        let _e8631 = phi_12264_;
                                        let _e8633 = phi_12266_;
                                        let _e8635 = phi_14435_;
                                        let _e8637 = phi_14437_;
                                        let _e8639 = phi_14438_;
                                        let _e8641 = phi_14439_;
                                        let _e8643 = phi_14440_;
                                        let _e8645 = phi_14442_;
                                        let _e8647 = phi_14443_;
                                        local_67 = _e8639;
                                        local_68 = _e8641;
                                        local_69 = _e8639;
                                        local_70 = _e8643;
                                        local_71 = _e8639;
                                        local_72 = _e8645;
                                        local_73 = _e8639;
                                        local_74 = _e8647;
                                        local_76 = _e8639;
                                        local_77 = _e8635;
                                        continue;
                                        continuing {
                                            phi_12252_ = type_9(select(_e7619.member, (_e7619.member + 1u), _e7634), select(_e7619.member_1, _e7619.member_1, _e7634));
                                            phi_12255_ = _e8623;
                                            phi_12257_ = _e8625;
                                            phi_12259_ = _e8627;
                                            phi_12261_ = _e8629;
                                            phi_12263_ = _e8631;
                                            phi_12265_ = _e8633;
                                            break if !(_e8637);
                                        }
                                    }
                                    let _e8650 = local_67;
                                    let _e8652 = local_68;
                                    let _e8653 = select(_e8652, false, _e8650);
                                    let _e8655 = local_69;
                                    let _e8657 = local_70;
                                    let _e8660 = local_71;
                                    let _e8662 = local_72;
                                    let _e8665 = local_73;
                                    let _e8667 = local_74;
                                    let _e8673 = local_75;
                                    let _e8675 = select(select(_e8657, false, _e8655), false, _e8653);
                                    let _e8677 = local_76;
                                    let _e8684 = select(select(_e8677, false, _e8653), false, _e8675);
                                    let _e8689 = local_77;
                                    let _e8691 = local_78;
                                    let _e8693 = select(select(select(select(_e8662, false, _e8660), false, _e8653), false, _e8675), true, _e8684);
                                    let _e8700 = select(select(select(select(select(_e8667, false, _e8665), false, _e8653), false, _e8675), false, _e8684), false, _e8693);
                                    let _e8705 = select(select(select(select(_e8653, true, _e8675), false, _e8684), false, _e8693), true, _e8700);
                                    let _e8708 = (select(select(type_30().member, 1u, _e8693), select(select(select(type_30().member, 1u, _e8653), 0u, _e8675), 0u, _e8700), _e8705) != 0u);
                                    phi_14511_ = select(select(type_30().member_1, select(_e8691, _e8689, _e8684), _e8693), select(select(select(type_30().member_1, _e8673, _e8653), type_30().member_1, _e8675), type_30().member_1, _e8700), _e8705);
                                    phi_14512_ = select(true, false, _e8708);
                                    phi_14513_ = _e8708;
                                    phi_14514_ = false;
                                    phi_14515_ = false;
                                    phi_14516_ = false;
                                } else {
                                    phi_14511_ = f32();
                                    phi_14512_ = _e7406;
                                    phi_14513_ = false;
                                    phi_14514_ = _e7408;
                                    phi_14515_ = _e7410;
                                    phi_14516_ = _e7412;
                                }
                                let _e8711 = phi_14511_;
                                let _e8713 = phi_14512_;
                                let _e8715 = phi_14513_;
                                let _e8717 = phi_14514_;
                                let _e8719 = phi_14515_;
                                let _e8721 = phi_14516_;
                                phi_14517_ = _e7398;
                                phi_14518_ = _e7400;
                                phi_14519_ = _e8711;
                                phi_14520_ = _e7402;
                                phi_14521_ = _e8713;
                                phi_14522_ = _e8715;
                                phi_14523_ = false;
                                phi_14524_ = _e8717;
                                phi_14525_ = _e8719;
                                phi_14526_ = _e8721;
                            } else {
                                phi_14517_ = type_45();
                                phi_14518_ = bool();
                                phi_14519_ = f32();
                                phi_14520_ = type_45();
                                phi_14521_ = false;
                                phi_14522_ = false;
                                phi_14523_ = true;
                                phi_14524_ = false;
                                phi_14525_ = false;
                                phi_14526_ = false;
                            }
                            let _e8723 = phi_14517_;
                            let _e8725 = phi_14518_;
                            let _e8727 = phi_14519_;
                            let _e8729 = phi_14520_;
                            let _e8731 = phi_14521_;
                            let _e8733 = phi_14522_;
                            let _e8735 = phi_14523_;
                            let _e8737 = phi_14524_;
                            let _e8739 = phi_14525_;
                            let _e8741 = phi_14526_;
                            local_79 = _e8733;
                            local_80 = _e8725;
                            local_81 = _e8723;
                            local_82 = _e8727;
                            local_83 = _e8727;
                            local_84 = _e8727;
                            local_88 = _e8735;
                            local_89 = _e8737;
                            local_90 = _e8739;
                            local_91 = _e8741;
                            local_85 = _e8733;
                            local_86 = _e8729;
                            continue;
                            continuing {
                                phi_10397_ = type_9(select(_e6420.member, (_e6420.member + 1u), _e6423), select(_e6420.member_1, _e6420.member_1, _e6423));
                                break if !(_e8731);
                            }
                        }
                        let _e8744 = local_79;
                        if _e8744 {
                            let _e8746 = local_80;
                            if _e8746 {
                                let _e8748 = local_81;
                                let _e8751 = local_82;
                                let _e8753 = ((_e8748.member_1 - _e8751) <= _e6384);
                                let _e8758 = local_83;
                                phi_14542_ = type_30(select(type_30().member, 1u, _e8753), select(type_30().member_1, _e8758, _e8753));
                                phi_14543_ = select(true, false, _e8753);
                            } else {
                                phi_14542_ = type_30();
                                phi_14543_ = true;
                            }
                            let _e8763 = phi_14542_;
                            let _e8765 = phi_14543_;
                            let _e8770 = local_84;
                            phi_14549_ = type_30(select(_e8763.member, 2u, _e8765), select(_e8763.member_1, _e8770, _e8765));
                            phi_14550_ = false;
                            phi_14551_ = false;
                            phi_14552_ = false;
                            phi_14553_ = false;
                        } else {
                            phi_14549_ = type_30();
                            let _e9418 = local_88;
                            phi_14550_ = _e9418;
                            let _e9421 = local_89;
                            phi_14551_ = _e9421;
                            let _e9424 = local_90;
                            phi_14552_ = _e9424;
                            let _e9427 = local_91;
                            phi_14553_ = _e9427;
                        }
                        let _e8774 = phi_14549_;
                        let _e8776 = phi_14550_;
                        let _e8778 = phi_14551_;
                        let _e8780 = phi_14552_;
                        let _e8782 = phi_14553_;
                        let _e8789 = select(_e8778, false, _e8776);
                        let _e8793 = local_85;
                        let _e8800 = select(select(_e8780, false, _e8776), false, _e8789);
                        let _e8806 = select(select(select(_e8782, false, _e8776), false, _e8789), false, _e8800);
                        let _e8810 = local_86;
                        let _e8814 = select(select(_e8789, true, _e8800), true, _e8806);
                        phi_14595_ = type_30(select(_e8774.member, select(select(select(type_30().member, 0u, _e8789), 0u, _e8800), 1u, _e8806), _e8814), select(_e8774.member_1, select(select(select(type_30().member_1, type_30().member_1, _e8789), type_30().member_1, _e8800), _e8810.member, _e8806), _e8814));
                        phi_14596_ = type_30(select(type_30().member, 0u, _e8776), select(type_30().member_1, type_30().member_1, _e8776));
                        phi_14597_ = select(select(select(select(select(_e8793, false, _e8776), false, _e8789), false, _e8800), false, _e8806), true, _e8814);
                    }
                    let _e8825 = phi_14595_;
                    let _e8827 = phi_14596_;
                    let _e8829 = phi_14597_;
                    let _e8832 = select(_e8827.member, _e8825.member, _e8829);
                    let _e8835 = select(_e8827.member_1, _e8825.member_1, _e8829);
                    let _e8841 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e8835 > _e5555)), (_e8832 == 1u))));
                    switch bitcast<i32>(_e8832) {
                        case 0: {
                            phi_14641_ = type_31(0u, _e8841, array<u32, 2>(0u, 0u), false);
                            break;
                        }
                        case 1: {
                            let _e8845 = function_5(_e8835);
                            phi_14641_ = type_31(0u, _e8841, _e8845, true);
                            break;
                        }
                        case 2: {
                            let _e8843 = function_5(_e8835);
                            phi_14641_ = type_31(1u, _e8841, _e8843, true);
                            break;
                        }
                        default: {
                            phi_14641_ = type_31();
                            break;
                        }
                    }
                    let _e8849 = phi_14641_;
                    let _e8853 = params.member.member.member_12;
                    let _e8854 = bitcast<u32>(_e8853);
                    if (_e8849.member_2[0] == select((_e8854 << bitcast<u32>(29i)), 0u, ((_e8854 & 2147483647u) < 8388608u))) {
                        let _e8864 = params.member.member.member_12;
                        let _e8865 = bitcast<u32>(_e8864);
                        let _e8866 = (_e8865 & 2147483647u);
                        phi_14681_ = (_e8849.member_2[1] == select(((_e8865 ^ _e8866) | ((_e8866 >> bitcast<u32>(3i)) + 939524096u)), 0u, (_e8866 < 8388608u)));
                    } else {
                        phi_14681_ = false;
                    }
                    let _e8876 = phi_14681_;
                    let _e8878 = params.member.member.member_1;
                    if ((_e8878 & 128u) != 0u) {
                        phi_14697_ = true;
                    } else {
                        let _e8882 = params.member.member.member_1;
                        phi_14697_ = select(false, _e8876, ((_e8882 & 64u) != 0u));
                    }
                    let _e8887 = phi_14697_;
                    phi_14716_ = type_31(select(1u, _e8849.member, select(true, select(true, false, _e8887), _e8849.member_3)), _e8849.member_1, _e8849.member_2, _e8849.member_3);
                } else {
                    phi_14716_ = _e5549;
                }
                let _e8898 = phi_14716_;
                phi_14717_ = _e8898;
                phi_14718_ = type_9(_e246, _e249);
            } else {
                phi_14717_ = type_31(0u, 0u, array<u32, 2>(0u, 0u), false);
                phi_14718_ = type_9(0u, 0u);
            }
            let _e8900 = phi_14717_;
            let _e8902 = phi_14718_;
            let _e8907 = (_e8900.member != 0u);
            let _e8910 = select(false, !(_e8907), _e8900.member_3);
            if _e8910 {
                let _e8914 = (_e8900.member_2[1] >> bitcast<u32>(20i));
                if (_e8914 <= 896u) {
                    phi_14749_ = 0u;
                } else {
                    phi_14749_ = ((((_e8914 - 896u) << bitcast<u32>(23i)) | ((_e8900.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e8900.member_2[0] >> bitcast<u32>(29i)));
                }
                let _e8929 = phi_14749_;
                let _e8931 = atomicMin((&earliest.member[0u]), _e8929);
            }
            let _e8934 = params.member.member.member_1;
            if ((_e8934 & 16u) != 0u) {
                if (_e162 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e8910 {
                    let _e8940 = atomicAdd((&counters[0u]), 1u);
                    phi_14771_ = _e8940;
                } else {
                    phi_14771_ = 0u;
                }
                let _e8942 = phi_14771_;
                workgroupBarrier();
                if (_e162 == 0u) {
                    let _e8945 = atomicLoad((&counters[0u]));
                    if (_e8945 > 0u) {
                        let _e8948 = atomicAdd((&contacts.member[0u]), _e8945);
                        atomicStore((&counters[1u]), _e8948);
                    }
                }
                workgroupBarrier();
                let _e8951 = atomicLoad((&counters[1u]));
                let _e8952 = (_e8951 + _e8942);
                if _e8910 {
                    let _e8955 = params.member.member_1.member_3;
                    let _e8957 = params.member.member_2.member.member;
                    if (_e8952 < _e8955) {
                        let _e8959 = (7u * _e8952);
                        atomicStore((&contacts.member[(4u + _e8959)]), _e8957);
                        atomicStore((&contacts.member[(_e8959 + 5u)]), _e8900.member);
                        atomicStore((&contacts.member[(_e8959 + 6u)]), _e8902.member);
                        atomicStore((&contacts.member[(_e8959 + 7u)]), _e8902.member_1);
                        atomicStore((&contacts.member[(_e8959 + 8u)]), _e8900.member_2[0]);
                        atomicStore((&contacts.member[(_e8959 + 9u)]), _e8900.member_2[1]);
                        atomicStore((&contacts.member[(_e8959 + 10u)]), _e8900.member_1);
                    }
                }
            }
            workgroupBarrier();
            if (_e162 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e8907 {
                let _e8983 = atomicAdd((&counters[0u]), 1u);
                phi_14837_ = _e8983;
            } else {
                phi_14837_ = 0u;
            }
            let _e8985 = phi_14837_;
            workgroupBarrier();
            if (_e162 == 0u) {
                let _e8988 = atomicLoad((&counters[0u]));
                if (_e8988 > 0u) {
                    let _e8991 = atomicAdd((&undecided.member[0u]), _e8988);
                    atomicStore((&counters[1u]), _e8991);
                }
            }
            workgroupBarrier();
            let _e8994 = atomicLoad((&counters[1u]));
            let _e8995 = (_e8994 + _e8985);
            if _e8907 {
                let _e8997 = params.member.member_2.member.member_1;
                if (_e8995 < _e8997) {
                    let _e8999 = (2u * _e8995);
                    atomicStore((&undecided.member[(4u + _e8999)]), _e8902.member);
                    atomicStore((&undecided.member[(_e8999 + 5u)]), _e8902.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_986_ = type_9(select(_e217.member, (_e217.member + 1u), _e220), select(_e217.member_1, _e217.member_1, _e220));
            break if !(_e233);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_17(id, n, lane);
}
