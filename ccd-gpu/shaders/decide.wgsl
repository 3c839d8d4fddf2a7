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
    var phi_15507_: bool;
    var phi_15508_: bool;
    var phi_15513_: bool;

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
            phi_15507_ = select(bool(), ((_e43 > 0f) == (_e69 > 0f)), _e84);
            phi_15508_ = select(true, false, _e84);
        } else {
            phi_15507_ = bool();
            phi_15508_ = true;
        }
        let _e91 = phi_15507_;
        let _e93 = phi_15508_;
        phi_15513_ = select(_e91, false, _e93);
    } else {
        phi_15513_ = false;
    }
    let _e96 = phi_15513_;
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
    var phi_14992_: type_9;
    var phi_14993_: type_9;
    var phi_14994_: type_9;
    var phi_14995_: type_9;
    var phi_14996_: type_9;
    var phi_14997_: bool;

    let _e24 = ((param_44[1] >> bitcast<u32>(20i)) & 2047u);
    let _e28 = ((param_44[1] & 1048575u) | select(1048576u, 0u, (_e24 == 0u)));
    let _e33 = ((bitcast<i32>(select(1u, _e24, (1u < _e24))) - 1015i) - param_45);
    let _e35 = (bitcast<u32>(_e33) % 32u);
    if (_e33 >= 64i) {
        phi_14996_ = type_9();
        phi_14997_ = true;
    } else {
        let _e37 = (_e33 <= -53i);
        if _e37 {
            phi_14995_ = type_9();
        } else {
            if (_e33 >= 32i) {
                phi_14994_ = type_9((param_44[0] << bitcast<u32>((_e35 & 31u))), 0u);
            } else {
                if (_e33 >= 0i) {
                    phi_14993_ = type_9(((_e28 << bitcast<u32>((_e35 & 31u))) | ((param_44[0] >> bitcast<u32>(1i)) >> bitcast<u32>(((31u - _e35) & 31u)))), (param_44[0] << bitcast<u32>((_e35 & 31u))));
                } else {
                    if (_e33 > -32i) {
                        let _e49 = bitcast<u32>(-(_e33));
                        phi_14992_ = type_9(bitcast<u32>((bitcast<i32>(_e28) >> bitcast<u32>((_e49 & 31u)))), ((param_44[0] >> bitcast<u32>((_e49 & 31u))) | ((_e28 << bitcast<u32>(((31u - _e49) & 31u))) << bitcast<u32>(1i))));
                    } else {
                        phi_14992_ = type_9(0u, (_e28 >> bitcast<u32>(((bitcast<u32>(-(_e33)) - 32u) & 31u))));
                    }
                    let _e67 = phi_14992_;
                    phi_14993_ = _e67;
                }
                let _e83 = phi_14993_;
                phi_14994_ = _e83;
            }
            let _e89 = phi_14994_;
            phi_14995_ = _e89;
        }
        let _e91 = phi_14995_;
        phi_14996_ = _e91;
        phi_14997_ = _e37;
    }
    let _e93 = phi_14996_;
    let _e95 = phi_14997_;
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
    var phi_5116_: array<type_9, 4>;
    var phi_5119_: bool;
    var phi_5121_: bool;
    var phi_5123_: bool;
    var phi_5127_: u32;
    var phi_5129_: u32;
    var phi_5131_: u32;
    var phi_5140_: array<type_9, 4>;
    var phi_5143_: bool;
    var phi_5145_: bool;
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
    var phi_5945_: array<type_9, 4>;
    var phi_5946_: u32;
    var phi_5947_: array<type_9, 4>;
    var phi_5948_: bool;
    var phi_5950_: u32;
    var phi_5951_: u32;
    var phi_5952_: array<type_9, 4>;
    var phi_5953_: bool;
    var phi_5955_: u32;
    var phi_5956_: u32;
    var phi_5957_: array<type_9, 4>;
    var phi_5958_: bool;
    var phi_5959_: bool;
    var phi_5961_: bool;
    var phi_5962_: bool;
    var phi_5963_: u32;
    var phi_5964_: u32;
    var phi_5965_: u32;
    var phi_5966_: u32;
    var phi_5967_: u32;
    var phi_5968_: bool;
    var phi_5969_: array<type_9, 4>;
    var phi_5970_: bool;
    var phi_5971_: bool;
    var phi_5973_: bool;
    var phi_5974_: bool;
    var phi_5975_: u32;
    var phi_5976_: u32;
    var phi_5977_: u32;
    var phi_5978_: u32;
    var phi_5979_: u32;
    var phi_5980_: bool;
    var phi_5141_: array<type_9, 4>;
    var phi_5144_: bool;
    var phi_5146_: bool;
    var phi_5150_: bool;
    var phi_5152_: bool;
    var phi_5154_: u32;
    var phi_5156_: u32;
    var phi_5158_: u32;
    var phi_5160_: u32;
    var phi_5162_: u32;
    var phi_5981_: bool;
    var local_42: bool;
    var local_43: bool;
    var local_44: u32;
    var local_45: u32;
    var local_46: u32;
    var local_47: u32;
    var local_48: array<type_9, 4>;
    var local_49: array<type_9, 4>;
    var local_50: array<type_9, 4>;
    var local_51: array<type_9, 4>;
    var local_52: array<type_9, 4>;
    var local_53: array<type_9, 4>;
    var local_54: bool;
    var local_55: u32;
    var local_56: array<type_9, 4>;
    var local_57: array<type_9, 4>;
    var local_58: array<type_9, 4>;
    var local_59: array<type_9, 4>;
    var local_60: array<type_9, 4>;
    var local_61: array<type_9, 4>;
    var local_62: array<type_9, 4>;
    var local_63: array<type_9, 4>;
    var phi_6117_: type_14;
    var phi_6120_: f32;
    var phi_6118_: type_14;
    var phi_6161_: type_15;
    var phi_6121_: f32;
    var local_64: u32;
    var local_65: u32;
    var local_66: f32;
    var local_67: u32;
    var local_68: array<type_9, 4>;
    var local_69: array<type_9, 4>;
    var local_70: array<type_9, 4>;
    var local_71: u32;
    var local_72: u32;
    var local_73: u32;
    var phi_6606_: bool;
    var phi_6607_: type_20;
    var phi_6608_: bool;
    var phi_6609_: bool;
    var phi_6610_: type_20;
    var phi_6611_: bool;
    var local_74: u32;
    var local_75: u32;
    var local_76: array<type_9, 4>;
    var local_77: array<type_9, 4>;
    var local_78: array<type_9, 4>;
    var phi_6846_: bool;
    var phi_6847_: bool;
    var phi_6848_: type_20;
    var phi_6849_: bool;
    var phi_6850_: type_20;
    var phi_6851_: bool;
    var phi_6852_: bool;
    var phi_6853_: type_20;
    var phi_8000_: array<type_9, 2>;
    var phi_8029_: array<type_9, 2>;
    var phi_8058_: array<type_9, 2>;
    var phi_8072_: type_9;
    var phi_8394_: type_9;
    var phi_8395_: type_9;
    var phi_8396_: type_9;
    var phi_8397_: type_9;
    var phi_8511_: bool;
    var phi_8512_: bool;
    var phi_8513_: bool;
    var phi_8518_: u32;
    var phi_8519_: u32;
    var phi_8520_: bool;
    var phi_8521_: u32;
    var phi_8522_: bool;
    var phi_8523_: u32;
    var phi_8524_: bool;
    var phi_8529_: u32;
    var phi_8593_: bool;
    var phi_8594_: bool;
    var phi_8595_: bool;
    var phi_8596_: bool;
    var phi_8597_: type_20;
    var phi_8598_: bool;
    var phi_8599_: bool;
    var phi_8600_: bool;
    var phi_8601_: bool;
    var phi_8602_: bool;
    var phi_8603_: bool;
    var phi_8604_: bool;
    var phi_8605_: type_20;
    var phi_8606_: bool;
    var phi_8607_: bool;
    var phi_8608_: bool;
    var local_79: u32;
    var local_80: u32;
    var local_81: u32;
    var local_82: u32;
    var local_83: u32;
    var local_84: u32;
    var phi_8907_: array<type_9, 4>;
    var phi_8908_: bool;
    var phi_8909_: array<type_9, 4>;
    var phi_8910_: bool;
    var phi_8911_: bool;
    var phi_8912_: array<type_9, 4>;
    var phi_8913_: bool;
    var phi_8914_: bool;
    var phi_8915_: bool;
    var phi_8916_: u32;
    var phi_8917_: u32;
    var phi_8918_: bool;
    var phi_8919_: bool;
    var phi_8920_: bool;
    var phi_8926_: array<type_9, 4>;
    var phi_8927_: bool;
    var phi_8928_: bool;
    var phi_8929_: bool;
    var phi_8930_: u32;
    var phi_8931_: u32;
    var phi_8932_: bool;
    var phi_8933_: bool;
    var phi_8934_: bool;
    var phi_8935_: bool;
    var phi_8936_: bool;
    var phi_5117_: array<type_9, 4>;
    var phi_5120_: bool;
    var phi_5122_: bool;
    var phi_5124_: bool;
    var phi_5128_: u32;
    var phi_5130_: u32;
    var phi_5132_: u32;
    var phi_8937_: type_20;
    var phi_8938_: bool;
    var phi_8939_: bool;
    var phi_8940_: bool;
    var phi_8941_: bool;
    var phi_8942_: bool;
    var phi_8943_: bool;
    var local_85: bool;
    var local_86: bool;
    var local_87: bool;
    var local_88: bool;
    var local_89: bool;
    var local_90: bool;
    var local_91: bool;
    var local_92: bool;
    var local_93: bool;
    var local_94: bool;
    var local_95: type_20;
    var phi_9026_: array<u32, 2>;
    var phi_9032_: type_31;
    var phi_9039_: type_31;
    var phi_9040_: bool;
    var phi_9041_: type_31;
    var phi_9042_: bool;
    var phi_9313_: bool;
    var phi_9407_: type_29;
    var phi_9408_: bool;
    var phi_9409_: type_29;
    var phi_9410_: bool;
    var phi_9411_: type_29;
    var phi_9412_: bool;
    var phi_9417_: type_29;
    var phi_10142_: bool;
    var phi_10154_: f32;
    var phi_10225_: type_14;
    var phi_10228_: f32;
    var phi_10226_: type_14;
    var phi_10269_: type_15;
    var phi_10229_: f32;
    var local_96: f32;
    var phi_10282_: f32;
    var phi_10313_: type_9;
    var phi_10316_: u32;
    var phi_10383_: u32;
    var phi_10384_: u32;
    var phi_10317_: u32;
    var phi_10385_: u32;
    var phi_10441_: type_9;
    var phi_10597_: type_45;
    var phi_10598_: bool;
    var phi_10599_: type_45;
    var phi_10600_: bool;
    var phi_10631_: type_9;
    var phi_10634_: f32;
    var phi_10636_: f32;
    var phi_10638_: f32;
    var phi_10748_: bool;
    var phi_10755_: f32;
    var phi_10756_: bool;
    var phi_10635_: f32;
    var phi_10637_: f32;
    var phi_10639_: f32;
    var phi_10757_: f32;
    var phi_10758_: bool;
    var phi_10759_: bool;
    var local_97: bool;
    var local_98: f32;
    var local_99: f32;
    var phi_10764_: f32;
    var phi_10780_: type_9;
    var phi_10783_: f32;
    var phi_10848_: f32;
    var phi_10849_: bool;
    var phi_10850_: bool;
    var phi_10851_: bool;
    var phi_10852_: f32;
    var phi_10784_: f32;
    var phi_10853_: bool;
    var phi_10854_: bool;
    var phi_10855_: bool;
    var phi_10856_: bool;
    var local_100: bool;
    var local_101: bool;
    var local_102: bool;
    var local_103: bool;
    var local_104: f32;
    var phi_10870_: f32;
    var phi_10872_: type_45;
    var phi_11709_: array<type_16, 4>;
    var phi_11729_: type_9;
    var phi_11732_: bool;
    var phi_11733_: bool;
    var phi_11784_: bool;
    var phi_11785_: bool;
    var local_105: bool;
    var local_106: bool;
    var phi_11799_: u32;
    var phi_11800_: u32;
    var phi_11801_: bool;
    var phi_11832_: bool;
    var phi_11833_: bool;
    var phi_11834_: bool;
    var phi_11835_: bool;
    var phi_11836_: bool;
    var phi_11837_: bool;
    var phi_11838_: bool;
    var phi_11839_: bool;
    var phi_11840_: bool;
    var phi_11841_: bool;
    var phi_11842_: bool;
    var phi_11843_: bool;
    var phi_11844_: type_45;
    var phi_11845_: bool;
    var phi_11846_: type_45;
    var phi_11847_: bool;
    var phi_11848_: bool;
    var phi_11849_: bool;
    var phi_11850_: bool;
    var phi_11851_: type_45;
    var phi_11852_: bool;
    var phi_11853_: type_45;
    var phi_11854_: bool;
    var phi_11855_: bool;
    var phi_11856_: bool;
    var phi_11857_: bool;
    var phi_11858_: bool;
    var phi_11866_: type_45;
    var phi_11867_: bool;
    var phi_11868_: type_45;
    var phi_11869_: bool;
    var phi_11870_: bool;
    var phi_11871_: bool;
    var phi_11872_: bool;
    var phi_11873_: bool;
    var phi_12296_: type_9;
    var phi_12299_: f32;
    var phi_12301_: f32;
    var phi_12303_: f32;
    var phi_12305_: f32;
    var phi_12307_: bool;
    var phi_12309_: u32;
    var phi_12460_: array<f32, 3>;
    var phi_12526_: type_14;
    var phi_12529_: f32;
    var phi_12527_: type_14;
    var phi_12570_: type_15;
    var phi_12530_: f32;
    var local_107: f32;
    var phi_12583_: f32;
    var phi_12706_: type_28;
    var phi_12707_: bool;
    var phi_12708_: type_28;
    var phi_12709_: bool;
    var phi_12717_: type_28;
    var phi_12888_: bool;
    var phi_12889_: bool;
    var phi_12890_: bool;
    var phi_12891_: bool;
    var phi_12892_: bool;
    var phi_12893_: bool;
    var phi_13194_: bool;
    var phi_13195_: bool;
    var phi_13196_: bool;
    var phi_13197_: bool;
    var phi_13198_: bool;
    var phi_13199_: bool;
    var phi_13207_: bool;
    var phi_13314_: f32;
    var phi_13315_: bool;
    var phi_13316_: f32;
    var phi_13317_: bool;
    var phi_13318_: f32;
    var phi_13319_: bool;
    var phi_13320_: bool;
    var phi_13382_: f32;
    var phi_13383_: bool;
    var phi_13384_: f32;
    var phi_13385_: bool;
    var phi_13386_: f32;
    var phi_13387_: bool;
    var phi_13388_: bool;
    var phi_13455_: f32;
    var phi_13456_: bool;
    var phi_13457_: f32;
    var phi_13458_: bool;
    var phi_13459_: f32;
    var phi_13460_: bool;
    var phi_13461_: bool;
    var phi_13523_: f32;
    var phi_13524_: bool;
    var phi_13525_: f32;
    var phi_13526_: bool;
    var phi_13527_: f32;
    var phi_13528_: bool;
    var phi_13529_: bool;
    var phi_14058_: f32;
    var phi_14059_: f32;
    var phi_14060_: bool;
    var phi_14062_: f32;
    var phi_14063_: f32;
    var phi_14064_: f32;
    var phi_14066_: bool;
    var phi_14067_: bool;
    var phi_14069_: bool;
    var phi_14070_: f32;
    var phi_14071_: f32;
    var phi_14072_: f32;
    var phi_14074_: bool;
    var phi_14075_: bool;
    var phi_14076_: bool;
    var phi_14078_: bool;
    var phi_14079_: f32;
    var phi_14080_: f32;
    var phi_14081_: f32;
    var phi_14083_: bool;
    var phi_14084_: bool;
    var phi_14085_: bool;
    var phi_14087_: bool;
    var phi_14420_: f32;
    var phi_14422_: u32;
    var phi_14423_: f32;
    var phi_14424_: bool;
    var phi_14425_: bool;
    var phi_14426_: bool;
    var phi_14427_: u32;
    var phi_14428_: f32;
    var phi_14429_: f32;
    var phi_14430_: f32;
    var phi_14431_: f32;
    var phi_14432_: bool;
    var phi_14433_: u32;
    var phi_14434_: bool;
    var phi_14435_: bool;
    var phi_14436_: bool;
    var phi_14437_: bool;
    var phi_14439_: bool;
    var phi_14467_: f32;
    var phi_14468_: f32;
    var phi_14469_: f32;
    var phi_14470_: f32;
    var phi_14471_: bool;
    var phi_14472_: u32;
    var phi_14473_: bool;
    var phi_14474_: bool;
    var phi_14475_: bool;
    var phi_14476_: bool;
    var phi_14478_: bool;
    var phi_12300_: f32;
    var phi_12302_: f32;
    var phi_12304_: f32;
    var phi_12306_: f32;
    var phi_12308_: bool;
    var phi_12310_: u32;
    var phi_14479_: f32;
    var phi_14481_: bool;
    var phi_14482_: bool;
    var phi_14483_: bool;
    var phi_14484_: bool;
    var phi_14486_: bool;
    var phi_14487_: bool;
    var local_108: bool;
    var local_109: bool;
    var local_110: bool;
    var local_111: bool;
    var local_112: bool;
    var local_113: bool;
    var local_114: bool;
    var local_115: bool;
    var local_116: f32;
    var local_117: bool;
    var local_118: f32;
    var local_119: f32;
    var phi_14555_: f32;
    var phi_14556_: bool;
    var phi_14557_: bool;
    var phi_14558_: bool;
    var phi_14559_: bool;
    var phi_14560_: bool;
    var phi_14561_: type_45;
    var phi_14562_: bool;
    var phi_14563_: f32;
    var phi_14564_: type_45;
    var phi_14565_: bool;
    var phi_14566_: bool;
    var phi_14567_: bool;
    var phi_14568_: bool;
    var phi_14569_: bool;
    var phi_14570_: bool;
    var local_120: bool;
    var local_121: bool;
    var local_122: type_45;
    var local_123: f32;
    var local_124: f32;
    var phi_14586_: type_30;
    var phi_14587_: bool;
    var local_125: f32;
    var phi_14593_: type_30;
    var phi_14594_: bool;
    var phi_14595_: bool;
    var phi_14596_: bool;
    var phi_14597_: bool;
    var local_126: bool;
    var local_127: type_45;
    var phi_14639_: type_30;
    var phi_14640_: type_30;
    var phi_14641_: bool;
    var phi_14685_: type_31;
    var phi_14725_: bool;
    var phi_14741_: bool;
    var phi_14760_: type_31;
    var phi_14761_: type_31;
    var phi_14762_: type_9;
    var phi_14793_: u32;
    var phi_14815_: u32;
    var phi_14881_: u32;
    var local_128: bool;
    var local_129: bool;
    var local_130: bool;
    var local_131: bool;
    var local_132: bool;
    var local_133: array<type_9, 4>;
    var local_134: u32;
    var local_135: u32;
    var local_136: u32;
    var local_137: u32;
    var local_138: bool;
    var local_139: bool;
    var local_140: bool;
    var local_141: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e159 = id_2;
    let _e160 = n_2;
    let _e161 = lane_2;
    let _e174 = ((_e159.y * _e160.x) + _e159.x);
    let _e177 = (_e160.x * _e160.y);
    let _e180 = params.member.member_1.member_2;
    let _e182 = input.member[0u];
    let _e184 = select(_e182, _e180, (_e180 < _e182));
    let _e186 = params.member.member_1.member_1;
    if (_e184 > _e186) {
        let _e189 = params.member.member_1.member_1;
        phi_937_ = (_e184 - _e189);
    } else {
        phi_937_ = 0u;
    }
    let _e192 = phi_937_;
    let _e194 = params.member.member_1.member;
    let _e196 = select(_e192, _e194, (_e194 < _e192));
    let _e198 = (_e196 / 64u);
    let _e202 = select(_e198, (_e198 + 1u), ((_e196 % 64u) > 0u));
    if (_e202 > _e174) {
        let _e204 = (_e202 - _e174);
        if (_e177 == 0u) {
            return;
        }
        let _e206 = (_e204 / _e177);
        if (_e177 == 0u) {
            return;
        }
        phi_983_ = select(_e206, (_e206 + 1u), ((_e204 % _e177) > 0u));
    } else {
        phi_983_ = 0u;
    }
    let _e213 = phi_983_;
    phi_986_ = type_9(0u, _e213);
    loop {
        let _e216 = phi_986_;
        let _e219 = (_e216.member < _e216.member_1);
        let _e232 = (bitcast<i32>(select(0u, 1u, _e219)) != 0i);
        if _e232 {
            let _e236 = (((_e174 + (select(type_9().member_1, _e216.member, _e219) * _e177)) * 64u) + _e161);
            if (_e236 < _e196) {
                let _e240 = params.member.member_1.member_1;
                let _e242 = (2u * (_e240 + _e236));
                let _e245 = input.member[(4u + _e242)];
                let _e248 = input.member[(_e242 + 5u)];
                let _e254 = params.member.member_2.member.member;
                if (_e254 == 0u) {
                    let _e270 = (3u * _e248);
                    let _e272 = elements.member[_e270];
                    let _e275 = elements.member[(_e270 + 1u)];
                    let _e278 = elements.member[(_e270 + 2u)];
                    phi_1144_ = type_21(0u, array<u32, 4>(_e245, _e272, _e275, _e278));
                } else {
                    let _e256 = (2u * _e245);
                    let _e257 = (2u * _e248);
                    let _e259 = elements.member[_e256];
                    let _e261 = elements.member[_e257];
                    let _e264 = elements.member[(_e256 + 1u)];
                    let _e267 = elements.member[(_e257 + 1u)];
                    phi_1144_ = type_21(1u, array<u32, 4>(_e259, _e264, _e261, _e267));
                }
                let _e282 = phi_1144_;
                local_39 = array<u32, 4>(_e282.member_1[0], _e282.member_1[1], _e282.member_1[2], _e282.member_1[3]);
                let _e291 = paths.member[_e282.member_1[0]];
                let _e305 = paths.member[_e282.member_1[1]];
                let _e319 = paths.member[_e282.member_1[2]];
                let _e333 = paths.member[_e282.member_1[3]];
                local_40 = array<array<f32, 3>, 4>(array<f32, 3>(_e291.member.x, _e291.member.y, _e291.member.z), array<f32, 3>(_e305.member.x, _e305.member.y, _e305.member.z), array<f32, 3>(_e319.member.x, _e319.member.y, _e319.member.z), array<f32, 3>(_e333.member.x, _e333.member.y, _e333.member.z));
                local_41 = array<array<f32, 3>, 4>(array<f32, 3>(_e291.member_1.x, _e291.member_1.y, _e291.member_1.z), array<f32, 3>(_e305.member_1.x, _e305.member_1.y, _e305.member_1.z), array<f32, 3>(_e319.member_1.x, _e319.member_1.y, _e319.member_1.z), array<f32, 3>(_e333.member_1.x, _e333.member_1.y, _e333.member_1.z));
                let _e357 = params.member.member.member_4;
                if (_e282.member != 0u) {
                    let _e448 = local_40;
                    let _e453 = local_40;
                    let _e462 = local_41;
                    let _e467 = local_41;
                    let _e477 = local_40;
                    let _e482 = local_40;
                    let _e491 = local_41;
                    let _e496 = local_41;
                    let _e506 = local_40;
                    let _e511 = local_40;
                    let _e520 = local_41;
                    let _e525 = local_41;
                    phi_1558_ = type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e448[2][0] - _e453[0][0]), (_e448[2][1] - _e453[0][1]), (_e448[2][2] - _e453[0][2])), array<f32, 3>((_e462[2][0] - _e467[0][0]), (_e462[2][1] - _e467[0][1]), (_e462[2][2] - _e467[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e477[1][0] - _e482[0][0]), (_e477[1][1] - _e482[0][1]), (_e477[1][2] - _e482[0][2])), array<f32, 3>((_e491[1][0] - _e496[0][0]), (_e491[1][1] - _e496[0][1]), (_e491[1][2] - _e496[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e506[2][0] - _e511[3][0]), (_e506[2][1] - _e511[3][1]), (_e506[2][2] - _e511[3][2])), array<f32, 3>((_e520[2][0] - _e525[3][0]), (_e520[2][1] - _e525[3][1]), (_e520[2][2] - _e525[3][2]))), (_e357 + _e357));
                } else {
                    let _e359 = local_40;
                    let _e364 = local_40;
                    let _e373 = local_41;
                    let _e378 = local_41;
                    let _e388 = local_40;
                    let _e393 = local_40;
                    let _e402 = local_41;
                    let _e407 = local_41;
                    let _e417 = local_40;
                    let _e422 = local_40;
                    let _e431 = local_41;
                    let _e436 = local_41;
                    phi_1558_ = type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e359[0][0] - _e364[1][0]), (_e359[0][1] - _e364[1][1]), (_e359[0][2] - _e364[1][2])), array<f32, 3>((_e373[0][0] - _e378[1][0]), (_e373[0][1] - _e378[1][1]), (_e373[0][2] - _e378[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e388[2][0] - _e393[1][0]), (_e388[2][1] - _e393[1][1]), (_e388[2][2] - _e393[1][2])), array<f32, 3>((_e402[2][0] - _e407[1][0]), (_e402[2][1] - _e407[1][1]), (_e402[2][2] - _e407[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e417[3][0] - _e422[1][0]), (_e417[3][1] - _e422[1][1]), (_e417[3][2] - _e422[1][2])), array<f32, 3>((_e431[3][0] - _e436[1][0]), (_e431[3][1] - _e436[1][1]), (_e431[3][2] - _e436[1][2]))), (_e357 + _e357));
                }
                let _e538 = phi_1558_;
                let _e544 = select(_e538.member[0][0], -(_e538.member[0][0]), (_e538.member[0][0] < 0f));
                let _e548 = select(_e538.member[0][1], -(_e538.member[0][1]), (_e538.member[0][1] < 0f));
                let _e550 = select(_e548, _e544, (_e544 > _e548));
                let _e554 = select(_e538.member[0][2], -(_e538.member[0][2]), (_e538.member[0][2] < 0f));
                let _e556 = select(_e554, _e550, (_e550 > _e554));
                let _e562 = select(_e538.member[1][0], -(_e538.member[1][0]), (_e538.member[1][0] < 0f));
                let _e566 = select(_e538.member[1][1], -(_e538.member[1][1]), (_e538.member[1][1] < 0f));
                let _e568 = select(_e566, _e562, (_e562 > _e566));
                let _e572 = select(_e538.member[1][2], -(_e538.member[1][2]), (_e538.member[1][2] < 0f));
                let _e574 = select(_e572, _e568, (_e568 > _e572));
                let _e584 = select(_e538.member_1[0][0], -(_e538.member_1[0][0]), (_e538.member_1[0][0] < 0f));
                let _e588 = select(_e538.member_1[0][1], -(_e538.member_1[0][1]), (_e538.member_1[0][1] < 0f));
                let _e590 = select(_e588, _e584, (_e584 > _e588));
                let _e594 = select(_e538.member_1[0][2], -(_e538.member_1[0][2]), (_e538.member_1[0][2] < 0f));
                let _e596 = select(_e594, _e590, (_e590 > _e594));
                let _e602 = select(_e538.member_1[1][0], -(_e538.member_1[1][0]), (_e538.member_1[1][0] < 0f));
                let _e606 = select(_e538.member_1[1][1], -(_e538.member_1[1][1]), (_e538.member_1[1][1] < 0f));
                let _e608 = select(_e606, _e602, (_e602 > _e606));
                let _e612 = select(_e538.member_1[1][2], -(_e538.member_1[1][2]), (_e538.member_1[1][2] < 0f));
                let _e614 = select(_e612, _e608, (_e608 > _e612));
                let _e624 = select(_e538.member_2[0][0], -(_e538.member_2[0][0]), (_e538.member_2[0][0] < 0f));
                let _e628 = select(_e538.member_2[0][1], -(_e538.member_2[0][1]), (_e538.member_2[0][1] < 0f));
                let _e630 = select(_e628, _e624, (_e624 > _e628));
                let _e634 = select(_e538.member_2[0][2], -(_e538.member_2[0][2]), (_e538.member_2[0][2] < 0f));
                let _e636 = select(_e634, _e630, (_e630 > _e634));
                let _e642 = select(_e538.member_2[1][0], -(_e538.member_2[1][0]), (_e538.member_2[1][0] < 0f));
                let _e646 = select(_e538.member_2[1][1], -(_e538.member_2[1][1]), (_e538.member_2[1][1] < 0f));
                let _e648 = select(_e646, _e642, (_e642 > _e646));
                let _e652 = select(_e538.member_2[1][2], -(_e538.member_2[1][2]), (_e538.member_2[1][2] < 0f));
                let _e654 = select(_e652, _e648, (_e648 > _e652));
                let _e659 = function_1((select(_e574, _e556, (_e556 > _e574)) + _e538.member_3), (select(_e614, _e596, (_e596 > _e614)) + _e538.member_3));
                let _e660 = function_1(_e659, (select(_e654, _e636, (_e636 > _e654)) + _e538.member_3));
                let _e665 = bitcast<i32>(((bitcast<u32>(_e660) + 4u) >> bitcast<u32>(23i)));
                let _e666 = (_e665 >= 64i);
                let _e667 = (_e665 <= 190i);
                let _e673 = select(select(i32(), select(i32(), (_e665 - 126i), _e667), _e666), 2147483647i, select(true, select(true, false, _e667), _e666));
                let _e675 = params.member.member_2.member_3;
                if (_e675 > 0u) {
                    if (_e673 != 2147483647i) {
                        let _e679 = params.member.member.member_1;
                        if ((_e679 & 8u) != 0u) {
                            let _e919 = local_40;
                            let _e924 = bitcast<u32>(_e919[0][0]);
                            let _e925 = (_e924 & 2147483647u);
                            let _e926 = (_e925 < 8388608u);
                            let _e937 = function_16(array<u32, 2>(select((_e924 << bitcast<u32>(29i)), 0u, _e926), select(((_e924 ^ _e925) | ((_e925 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e926)), _e673);
                            let _e938 = bitcast<u32>(_e919[0][1]);
                            let _e939 = (_e938 & 2147483647u);
                            let _e940 = (_e939 < 8388608u);
                            let _e951 = function_16(array<u32, 2>(select((_e938 << bitcast<u32>(29i)), 0u, _e940), select(((_e938 ^ _e939) | ((_e939 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e940)), _e673);
                            let _e952 = bitcast<u32>(_e919[0][2]);
                            let _e953 = (_e952 & 2147483647u);
                            let _e954 = (_e953 < 8388608u);
                            let _e965 = function_16(array<u32, 2>(select((_e952 << bitcast<u32>(29i)), 0u, _e954), select(((_e952 ^ _e953) | ((_e953 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e954)), _e673);
                            let _e967 = local_41;
                            let _e972 = bitcast<u32>(_e967[0][0]);
                            let _e973 = (_e972 & 2147483647u);
                            let _e974 = (_e973 < 8388608u);
                            let _e985 = function_16(array<u32, 2>(select((_e972 << bitcast<u32>(29i)), 0u, _e974), select(((_e972 ^ _e973) | ((_e973 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e974)), _e673);
                            let _e986 = bitcast<u32>(_e967[0][1]);
                            let _e987 = (_e986 & 2147483647u);
                            let _e988 = (_e987 < 8388608u);
                            let _e999 = function_16(array<u32, 2>(select((_e986 << bitcast<u32>(29i)), 0u, _e988), select(((_e986 ^ _e987) | ((_e987 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e988)), _e673);
                            let _e1000 = bitcast<u32>(_e967[0][2]);
                            let _e1001 = (_e1000 & 2147483647u);
                            let _e1002 = (_e1001 < 8388608u);
                            let _e1013 = function_16(array<u32, 2>(select((_e1000 << bitcast<u32>(29i)), 0u, _e1002), select(((_e1000 ^ _e1001) | ((_e1001 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1002)), _e673);
                            let _e1016 = local_40;
                            let _e1021 = bitcast<u32>(_e1016[1][0]);
                            let _e1022 = (_e1021 & 2147483647u);
                            let _e1023 = (_e1022 < 8388608u);
                            let _e1034 = function_16(array<u32, 2>(select((_e1021 << bitcast<u32>(29i)), 0u, _e1023), select(((_e1021 ^ _e1022) | ((_e1022 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1023)), _e673);
                            let _e1035 = bitcast<u32>(_e1016[1][1]);
                            let _e1036 = (_e1035 & 2147483647u);
                            let _e1037 = (_e1036 < 8388608u);
                            let _e1048 = function_16(array<u32, 2>(select((_e1035 << bitcast<u32>(29i)), 0u, _e1037), select(((_e1035 ^ _e1036) | ((_e1036 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1037)), _e673);
                            let _e1049 = bitcast<u32>(_e1016[1][2]);
                            let _e1050 = (_e1049 & 2147483647u);
                            let _e1051 = (_e1050 < 8388608u);
                            let _e1062 = function_16(array<u32, 2>(select((_e1049 << bitcast<u32>(29i)), 0u, _e1051), select(((_e1049 ^ _e1050) | ((_e1050 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1051)), _e673);
                            let _e1064 = local_41;
                            let _e1069 = bitcast<u32>(_e1064[1][0]);
                            let _e1070 = (_e1069 & 2147483647u);
                            let _e1071 = (_e1070 < 8388608u);
                            let _e1082 = function_16(array<u32, 2>(select((_e1069 << bitcast<u32>(29i)), 0u, _e1071), select(((_e1069 ^ _e1070) | ((_e1070 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1071)), _e673);
                            let _e1083 = bitcast<u32>(_e1064[1][1]);
                            let _e1084 = (_e1083 & 2147483647u);
                            let _e1085 = (_e1084 < 8388608u);
                            let _e1096 = function_16(array<u32, 2>(select((_e1083 << bitcast<u32>(29i)), 0u, _e1085), select(((_e1083 ^ _e1084) | ((_e1084 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1085)), _e673);
                            let _e1097 = bitcast<u32>(_e1064[1][2]);
                            let _e1098 = (_e1097 & 2147483647u);
                            let _e1099 = (_e1098 < 8388608u);
                            let _e1110 = function_16(array<u32, 2>(select((_e1097 << bitcast<u32>(29i)), 0u, _e1099), select(((_e1097 ^ _e1098) | ((_e1098 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1099)), _e673);
                            let _e1113 = local_40;
                            let _e1118 = bitcast<u32>(_e1113[2][0]);
                            let _e1119 = (_e1118 & 2147483647u);
                            let _e1120 = (_e1119 < 8388608u);
                            let _e1131 = function_16(array<u32, 2>(select((_e1118 << bitcast<u32>(29i)), 0u, _e1120), select(((_e1118 ^ _e1119) | ((_e1119 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1120)), _e673);
                            let _e1132 = bitcast<u32>(_e1113[2][1]);
                            let _e1133 = (_e1132 & 2147483647u);
                            let _e1134 = (_e1133 < 8388608u);
                            let _e1145 = function_16(array<u32, 2>(select((_e1132 << bitcast<u32>(29i)), 0u, _e1134), select(((_e1132 ^ _e1133) | ((_e1133 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1134)), _e673);
                            let _e1146 = bitcast<u32>(_e1113[2][2]);
                            let _e1147 = (_e1146 & 2147483647u);
                            let _e1148 = (_e1147 < 8388608u);
                            let _e1159 = function_16(array<u32, 2>(select((_e1146 << bitcast<u32>(29i)), 0u, _e1148), select(((_e1146 ^ _e1147) | ((_e1147 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1148)), _e673);
                            let _e1161 = local_41;
                            let _e1166 = bitcast<u32>(_e1161[2][0]);
                            let _e1167 = (_e1166 & 2147483647u);
                            let _e1168 = (_e1167 < 8388608u);
                            let _e1179 = function_16(array<u32, 2>(select((_e1166 << bitcast<u32>(29i)), 0u, _e1168), select(((_e1166 ^ _e1167) | ((_e1167 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1168)), _e673);
                            let _e1180 = bitcast<u32>(_e1161[2][1]);
                            let _e1181 = (_e1180 & 2147483647u);
                            let _e1182 = (_e1181 < 8388608u);
                            let _e1193 = function_16(array<u32, 2>(select((_e1180 << bitcast<u32>(29i)), 0u, _e1182), select(((_e1180 ^ _e1181) | ((_e1181 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1182)), _e673);
                            let _e1194 = bitcast<u32>(_e1161[2][2]);
                            let _e1195 = (_e1194 & 2147483647u);
                            let _e1196 = (_e1195 < 8388608u);
                            let _e1207 = function_16(array<u32, 2>(select((_e1194 << bitcast<u32>(29i)), 0u, _e1196), select(((_e1194 ^ _e1195) | ((_e1195 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1196)), _e673);
                            let _e1210 = local_40;
                            let _e1215 = bitcast<u32>(_e1210[3][0]);
                            let _e1216 = (_e1215 & 2147483647u);
                            let _e1217 = (_e1216 < 8388608u);
                            let _e1228 = function_16(array<u32, 2>(select((_e1215 << bitcast<u32>(29i)), 0u, _e1217), select(((_e1215 ^ _e1216) | ((_e1216 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1217)), _e673);
                            let _e1229 = bitcast<u32>(_e1210[3][1]);
                            let _e1230 = (_e1229 & 2147483647u);
                            let _e1231 = (_e1230 < 8388608u);
                            let _e1242 = function_16(array<u32, 2>(select((_e1229 << bitcast<u32>(29i)), 0u, _e1231), select(((_e1229 ^ _e1230) | ((_e1230 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1231)), _e673);
                            let _e1243 = bitcast<u32>(_e1210[3][2]);
                            let _e1244 = (_e1243 & 2147483647u);
                            let _e1245 = (_e1244 < 8388608u);
                            let _e1256 = function_16(array<u32, 2>(select((_e1243 << bitcast<u32>(29i)), 0u, _e1245), select(((_e1243 ^ _e1244) | ((_e1244 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1245)), _e673);
                            let _e1258 = local_41;
                            let _e1263 = bitcast<u32>(_e1258[3][0]);
                            let _e1264 = (_e1263 & 2147483647u);
                            let _e1265 = (_e1264 < 8388608u);
                            let _e1276 = function_16(array<u32, 2>(select((_e1263 << bitcast<u32>(29i)), 0u, _e1265), select(((_e1263 ^ _e1264) | ((_e1264 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1265)), _e673);
                            let _e1277 = bitcast<u32>(_e1258[3][1]);
                            let _e1278 = (_e1277 & 2147483647u);
                            let _e1279 = (_e1278 < 8388608u);
                            let _e1290 = function_16(array<u32, 2>(select((_e1277 << bitcast<u32>(29i)), 0u, _e1279), select(((_e1277 ^ _e1278) | ((_e1278 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1279)), _e673);
                            let _e1291 = bitcast<u32>(_e1258[3][2]);
                            let _e1292 = (_e1291 & 2147483647u);
                            let _e1293 = (_e1292 < 8388608u);
                            let _e1304 = function_16(array<u32, 2>(select((_e1291 << bitcast<u32>(29i)), 0u, _e1293), select(((_e1291 ^ _e1292) | ((_e1292 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1293)), _e673);
                            phi_3266_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e937, _e951, _e965), array<type_9, 3>(_e985, _e999, _e1013)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1034, _e1048, _e1062), array<type_9, 3>(_e1082, _e1096, _e1110)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1131, _e1145, _e1159), array<type_9, 3>(_e1179, _e1193, _e1207)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1228, _e1242, _e1256), array<type_9, 3>(_e1276, _e1290, _e1304)));
                        } else {
                            let _e684 = params.member.member.member_10[1u];
                            let _e689 = (_e673 - (bitcast<i32>((_e684 >> bitcast<u32>(20i))) - 1023i));
                            let _e690 = local_39;
                            let _e694 = params.member.member.member[0u];
                            let _e696 = (6u * (_e694 + _e690[0]));
                            let _e697 = (6u * _e690[0]);
                            let _e699 = positions.member[_e697];
                            let _e702 = positions.member[(_e697 + 1u)];
                            let _e704 = function_16(array<u32, 2>(_e699, _e702), _e689);
                            let _e707 = positions.member[(_e697 + 2u)];
                            let _e710 = positions.member[(_e697 + 3u)];
                            let _e712 = function_16(array<u32, 2>(_e707, _e710), _e689);
                            let _e715 = positions.member[(_e697 + 4u)];
                            let _e718 = positions.member[(_e697 + 5u)];
                            let _e720 = function_16(array<u32, 2>(_e715, _e718), _e689);
                            let _e723 = positions.member[_e696];
                            let _e726 = positions.member[(_e696 + 1u)];
                            let _e728 = function_16(array<u32, 2>(_e723, _e726), _e689);
                            let _e731 = positions.member[(_e696 + 2u)];
                            let _e734 = positions.member[(_e696 + 3u)];
                            let _e736 = function_16(array<u32, 2>(_e731, _e734), _e689);
                            let _e739 = positions.member[(_e696 + 4u)];
                            let _e742 = positions.member[(_e696 + 5u)];
                            let _e744 = function_16(array<u32, 2>(_e739, _e742), _e689);
                            let _e747 = local_39;
                            let _e751 = params.member.member.member[0u];
                            let _e753 = (6u * (_e751 + _e747[1]));
                            let _e754 = (6u * _e747[1]);
                            let _e756 = positions.member[_e754];
                            let _e759 = positions.member[(_e754 + 1u)];
                            let _e761 = function_16(array<u32, 2>(_e756, _e759), _e689);
                            let _e764 = positions.member[(_e754 + 2u)];
                            let _e767 = positions.member[(_e754 + 3u)];
                            let _e769 = function_16(array<u32, 2>(_e764, _e767), _e689);
                            let _e772 = positions.member[(_e754 + 4u)];
                            let _e775 = positions.member[(_e754 + 5u)];
                            let _e777 = function_16(array<u32, 2>(_e772, _e775), _e689);
                            let _e780 = positions.member[_e753];
                            let _e783 = positions.member[(_e753 + 1u)];
                            let _e785 = function_16(array<u32, 2>(_e780, _e783), _e689);
                            let _e788 = positions.member[(_e753 + 2u)];
                            let _e791 = positions.member[(_e753 + 3u)];
                            let _e793 = function_16(array<u32, 2>(_e788, _e791), _e689);
                            let _e796 = positions.member[(_e753 + 4u)];
                            let _e799 = positions.member[(_e753 + 5u)];
                            let _e801 = function_16(array<u32, 2>(_e796, _e799), _e689);
                            let _e804 = local_39;
                            let _e808 = params.member.member.member[0u];
                            let _e810 = (6u * (_e808 + _e804[2]));
                            let _e811 = (6u * _e804[2]);
                            let _e813 = positions.member[_e811];
                            let _e816 = positions.member[(_e811 + 1u)];
                            let _e818 = function_16(array<u32, 2>(_e813, _e816), _e689);
                            let _e821 = positions.member[(_e811 + 2u)];
                            let _e824 = positions.member[(_e811 + 3u)];
                            let _e826 = function_16(array<u32, 2>(_e821, _e824), _e689);
                            let _e829 = positions.member[(_e811 + 4u)];
                            let _e832 = positions.member[(_e811 + 5u)];
                            let _e834 = function_16(array<u32, 2>(_e829, _e832), _e689);
                            let _e837 = positions.member[_e810];
                            let _e840 = positions.member[(_e810 + 1u)];
                            let _e842 = function_16(array<u32, 2>(_e837, _e840), _e689);
                            let _e845 = positions.member[(_e810 + 2u)];
                            let _e848 = positions.member[(_e810 + 3u)];
                            let _e850 = function_16(array<u32, 2>(_e845, _e848), _e689);
                            let _e853 = positions.member[(_e810 + 4u)];
                            let _e856 = positions.member[(_e810 + 5u)];
                            let _e858 = function_16(array<u32, 2>(_e853, _e856), _e689);
                            let _e861 = local_39;
                            let _e865 = params.member.member.member[0u];
                            let _e867 = (6u * (_e865 + _e861[3]));
                            let _e868 = (6u * _e861[3]);
                            let _e870 = positions.member[_e868];
                            let _e873 = positions.member[(_e868 + 1u)];
                            let _e875 = function_16(array<u32, 2>(_e870, _e873), _e689);
                            let _e878 = positions.member[(_e868 + 2u)];
                            let _e881 = positions.member[(_e868 + 3u)];
                            let _e883 = function_16(array<u32, 2>(_e878, _e881), _e689);
                            let _e886 = positions.member[(_e868 + 4u)];
                            let _e889 = positions.member[(_e868 + 5u)];
                            let _e891 = function_16(array<u32, 2>(_e886, _e889), _e689);
                            let _e894 = positions.member[_e867];
                            let _e897 = positions.member[(_e867 + 1u)];
                            let _e899 = function_16(array<u32, 2>(_e894, _e897), _e689);
                            let _e902 = positions.member[(_e867 + 2u)];
                            let _e905 = positions.member[(_e867 + 3u)];
                            let _e907 = function_16(array<u32, 2>(_e902, _e905), _e689);
                            let _e910 = positions.member[(_e867 + 4u)];
                            let _e913 = positions.member[(_e867 + 5u)];
                            let _e915 = function_16(array<u32, 2>(_e910, _e913), _e689);
                            phi_3266_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e704, _e712, _e720), array<type_9, 3>(_e728, _e736, _e744)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e761, _e769, _e777), array<type_9, 3>(_e785, _e793, _e801)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e818, _e826, _e834), array<type_9, 3>(_e842, _e850, _e858)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e875, _e883, _e891), array<type_9, 3>(_e899, _e907, _e915)));
                        }
                        let _e1309 = phi_3266_;
                        let _e1311 = params.member.member_2.member_1;
                        let _e1313 = params.member.member_2.member_2;
                        let _e1315 = params.member.member_2.member_3;
                        if (_e282.member != 0u) {
                            phi_3813_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1309[2][0][0].member - _e1309[0][0][0].member) - select(0u, 1u, (_e1309[2][0][0].member_1 < _e1309[0][0][0].member_1))), (_e1309[2][0][0].member_1 - _e1309[0][0][0].member_1)), type_9(((_e1309[2][0][1].member - _e1309[0][0][1].member) - select(0u, 1u, (_e1309[2][0][1].member_1 < _e1309[0][0][1].member_1))), (_e1309[2][0][1].member_1 - _e1309[0][0][1].member_1)), type_9(((_e1309[2][0][2].member - _e1309[0][0][2].member) - select(0u, 1u, (_e1309[2][0][2].member_1 < _e1309[0][0][2].member_1))), (_e1309[2][0][2].member_1 - _e1309[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1309[2][1][0].member - _e1309[0][1][0].member) - select(0u, 1u, (_e1309[2][1][0].member_1 < _e1309[0][1][0].member_1))), (_e1309[2][1][0].member_1 - _e1309[0][1][0].member_1)), type_9(((_e1309[2][1][1].member - _e1309[0][1][1].member) - select(0u, 1u, (_e1309[2][1][1].member_1 < _e1309[0][1][1].member_1))), (_e1309[2][1][1].member_1 - _e1309[0][1][1].member_1)), type_9(((_e1309[2][1][2].member - _e1309[0][1][2].member) - select(0u, 1u, (_e1309[2][1][2].member_1 < _e1309[0][1][2].member_1))), (_e1309[2][1][2].member_1 - _e1309[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1309[1][0][0].member - _e1309[0][0][0].member) - select(0u, 1u, (_e1309[1][0][0].member_1 < _e1309[0][0][0].member_1))), (_e1309[1][0][0].member_1 - _e1309[0][0][0].member_1)), type_9(((_e1309[1][0][1].member - _e1309[0][0][1].member) - select(0u, 1u, (_e1309[1][0][1].member_1 < _e1309[0][0][1].member_1))), (_e1309[1][0][1].member_1 - _e1309[0][0][1].member_1)), type_9(((_e1309[1][0][2].member - _e1309[0][0][2].member) - select(0u, 1u, (_e1309[1][0][2].member_1 < _e1309[0][0][2].member_1))), (_e1309[1][0][2].member_1 - _e1309[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1309[1][1][0].member - _e1309[0][1][0].member) - select(0u, 1u, (_e1309[1][1][0].member_1 < _e1309[0][1][0].member_1))), (_e1309[1][1][0].member_1 - _e1309[0][1][0].member_1)), type_9(((_e1309[1][1][1].member - _e1309[0][1][1].member) - select(0u, 1u, (_e1309[1][1][1].member_1 < _e1309[0][1][1].member_1))), (_e1309[1][1][1].member_1 - _e1309[0][1][1].member_1)), type_9(((_e1309[1][1][2].member - _e1309[0][1][2].member) - select(0u, 1u, (_e1309[1][1][2].member_1 < _e1309[0][1][2].member_1))), (_e1309[1][1][2].member_1 - _e1309[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1309[2][0][0].member - _e1309[3][0][0].member) - select(0u, 1u, (_e1309[2][0][0].member_1 < _e1309[3][0][0].member_1))), (_e1309[2][0][0].member_1 - _e1309[3][0][0].member_1)), type_9(((_e1309[2][0][1].member - _e1309[3][0][1].member) - select(0u, 1u, (_e1309[2][0][1].member_1 < _e1309[3][0][1].member_1))), (_e1309[2][0][1].member_1 - _e1309[3][0][1].member_1)), type_9(((_e1309[2][0][2].member - _e1309[3][0][2].member) - select(0u, 1u, (_e1309[2][0][2].member_1 < _e1309[3][0][2].member_1))), (_e1309[2][0][2].member_1 - _e1309[3][0][2].member_1))), array<type_9, 3>(type_9(((_e1309[2][1][0].member - _e1309[3][1][0].member) - select(0u, 1u, (_e1309[2][1][0].member_1 < _e1309[3][1][0].member_1))), (_e1309[2][1][0].member_1 - _e1309[3][1][0].member_1)), type_9(((_e1309[2][1][1].member - _e1309[3][1][1].member) - select(0u, 1u, (_e1309[2][1][1].member_1 < _e1309[3][1][1].member_1))), (_e1309[2][1][1].member_1 - _e1309[3][1][1].member_1)), type_9(((_e1309[2][1][2].member - _e1309[3][1][2].member) - select(0u, 1u, (_e1309[2][1][2].member_1 < _e1309[3][1][2].member_1))), (_e1309[2][1][2].member_1 - _e1309[3][1][2].member_1)))));
                        } else {
                            phi_3813_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1309[0][0][0].member - _e1309[1][0][0].member) - select(0u, 1u, (_e1309[0][0][0].member_1 < _e1309[1][0][0].member_1))), (_e1309[0][0][0].member_1 - _e1309[1][0][0].member_1)), type_9(((_e1309[0][0][1].member - _e1309[1][0][1].member) - select(0u, 1u, (_e1309[0][0][1].member_1 < _e1309[1][0][1].member_1))), (_e1309[0][0][1].member_1 - _e1309[1][0][1].member_1)), type_9(((_e1309[0][0][2].member - _e1309[1][0][2].member) - select(0u, 1u, (_e1309[0][0][2].member_1 < _e1309[1][0][2].member_1))), (_e1309[0][0][2].member_1 - _e1309[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1309[0][1][0].member - _e1309[1][1][0].member) - select(0u, 1u, (_e1309[0][1][0].member_1 < _e1309[1][1][0].member_1))), (_e1309[0][1][0].member_1 - _e1309[1][1][0].member_1)), type_9(((_e1309[0][1][1].member - _e1309[1][1][1].member) - select(0u, 1u, (_e1309[0][1][1].member_1 < _e1309[1][1][1].member_1))), (_e1309[0][1][1].member_1 - _e1309[1][1][1].member_1)), type_9(((_e1309[0][1][2].member - _e1309[1][1][2].member) - select(0u, 1u, (_e1309[0][1][2].member_1 < _e1309[1][1][2].member_1))), (_e1309[0][1][2].member_1 - _e1309[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1309[2][0][0].member - _e1309[1][0][0].member) - select(0u, 1u, (_e1309[2][0][0].member_1 < _e1309[1][0][0].member_1))), (_e1309[2][0][0].member_1 - _e1309[1][0][0].member_1)), type_9(((_e1309[2][0][1].member - _e1309[1][0][1].member) - select(0u, 1u, (_e1309[2][0][1].member_1 < _e1309[1][0][1].member_1))), (_e1309[2][0][1].member_1 - _e1309[1][0][1].member_1)), type_9(((_e1309[2][0][2].member - _e1309[1][0][2].member) - select(0u, 1u, (_e1309[2][0][2].member_1 < _e1309[1][0][2].member_1))), (_e1309[2][0][2].member_1 - _e1309[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1309[2][1][0].member - _e1309[1][1][0].member) - select(0u, 1u, (_e1309[2][1][0].member_1 < _e1309[1][1][0].member_1))), (_e1309[2][1][0].member_1 - _e1309[1][1][0].member_1)), type_9(((_e1309[2][1][1].member - _e1309[1][1][1].member) - select(0u, 1u, (_e1309[2][1][1].member_1 < _e1309[1][1][1].member_1))), (_e1309[2][1][1].member_1 - _e1309[1][1][1].member_1)), type_9(((_e1309[2][1][2].member - _e1309[1][1][2].member) - select(0u, 1u, (_e1309[2][1][2].member_1 < _e1309[1][1][2].member_1))), (_e1309[2][1][2].member_1 - _e1309[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1309[3][0][0].member - _e1309[1][0][0].member) - select(0u, 1u, (_e1309[3][0][0].member_1 < _e1309[1][0][0].member_1))), (_e1309[3][0][0].member_1 - _e1309[1][0][0].member_1)), type_9(((_e1309[3][0][1].member - _e1309[1][0][1].member) - select(0u, 1u, (_e1309[3][0][1].member_1 < _e1309[1][0][1].member_1))), (_e1309[3][0][1].member_1 - _e1309[1][0][1].member_1)), type_9(((_e1309[3][0][2].member - _e1309[1][0][2].member) - select(0u, 1u, (_e1309[3][0][2].member_1 < _e1309[1][0][2].member_1))), (_e1309[3][0][2].member_1 - _e1309[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1309[3][1][0].member - _e1309[1][1][0].member) - select(0u, 1u, (_e1309[3][1][0].member_1 < _e1309[1][1][0].member_1))), (_e1309[3][1][0].member_1 - _e1309[1][1][0].member_1)), type_9(((_e1309[3][1][1].member - _e1309[1][1][1].member) - select(0u, 1u, (_e1309[3][1][1].member_1 < _e1309[1][1][1].member_1))), (_e1309[3][1][1].member_1 - _e1309[1][1][1].member_1)), type_9(((_e1309[3][1][2].member - _e1309[1][1][2].member) - select(0u, 1u, (_e1309[3][1][2].member_1 < _e1309[1][1][2].member_1))), (_e1309[3][1][2].member_1 - _e1309[1][1][2].member_1)))));
                        }
                        let _e1890 = phi_3813_;
                        local_37 = array<type_9, 3>(type_9(_e1890[1][0][0].member, _e1890[1][0][0].member_1), type_9(_e1890[1][0][1].member, _e1890[1][0][1].member_1), type_9(_e1890[1][0][2].member, _e1890[1][0][2].member_1));
                        local_38 = array<type_9, 3>(type_9(_e1890[2][0][0].member, _e1890[2][0][0].member_1), type_9(_e1890[2][0][1].member, _e1890[2][0][1].member_1), type_9(_e1890[2][0][2].member, _e1890[2][0][2].member_1));
                        let _e1923 = local_37[1u].member;
                        let _e1925 = local_37[1u].member_1;
                        let _e1928 = local_38[2u].member;
                        let _e1930 = local_38[2u].member_1;
                        let _e1931 = function_11(_e1923, _e1925, _e1928, _e1930);
                        let _e1936 = local_37[2u].member;
                        let _e1938 = local_37[2u].member_1;
                        let _e1941 = local_38[1u].member;
                        let _e1943 = local_38[1u].member_1;
                        let _e1944 = function_11(_e1936, _e1938, _e1941, _e1943);
                        let _e1950 = ((_e1931.member - _e1944.member) - select(0u, 1u, (_e1931.member_1 < _e1944.member_1)));
                        let _e1951 = (_e1931.member_1 - _e1944.member_1);
                        local_35 = array<type_9, 3>(type_9(_e1890[1][0][0].member, _e1890[1][0][0].member_1), type_9(_e1890[1][0][1].member, _e1890[1][0][1].member_1), type_9(_e1890[1][0][2].member, _e1890[1][0][2].member_1));
                        local_36 = array<type_9, 3>(type_9(_e1890[2][0][0].member, _e1890[2][0][0].member_1), type_9(_e1890[2][0][1].member, _e1890[2][0][1].member_1), type_9(_e1890[2][0][2].member, _e1890[2][0][2].member_1));
                        let _e1980 = local_35[2u].member;
                        let _e1982 = local_35[2u].member_1;
                        let _e1985 = local_36[0u].member;
                        let _e1987 = local_36[0u].member_1;
                        let _e1988 = function_11(_e1980, _e1982, _e1985, _e1987);
                        let _e1993 = local_35[0u].member;
                        let _e1995 = local_35[0u].member_1;
                        let _e1998 = local_36[2u].member;
                        let _e2000 = local_36[2u].member_1;
                        let _e2001 = function_11(_e1993, _e1995, _e1998, _e2000);
                        let _e2007 = ((_e1988.member - _e2001.member) - select(0u, 1u, (_e1988.member_1 < _e2001.member_1)));
                        let _e2008 = (_e1988.member_1 - _e2001.member_1);
                        local_33 = array<type_9, 3>(type_9(_e1890[1][0][0].member, _e1890[1][0][0].member_1), type_9(_e1890[1][0][1].member, _e1890[1][0][1].member_1), type_9(_e1890[1][0][2].member, _e1890[1][0][2].member_1));
                        local_34 = array<type_9, 3>(type_9(_e1890[2][0][0].member, _e1890[2][0][0].member_1), type_9(_e1890[2][0][1].member, _e1890[2][0][1].member_1), type_9(_e1890[2][0][2].member, _e1890[2][0][2].member_1));
                        let _e2037 = local_33[0u].member;
                        let _e2039 = local_33[0u].member_1;
                        let _e2042 = local_34[1u].member;
                        let _e2044 = local_34[1u].member_1;
                        let _e2045 = function_11(_e2037, _e2039, _e2042, _e2044);
                        let _e2050 = local_33[1u].member;
                        let _e2052 = local_33[1u].member_1;
                        let _e2055 = local_34[0u].member;
                        let _e2057 = local_34[0u].member_1;
                        let _e2058 = function_11(_e2050, _e2052, _e2055, _e2057);
                        let _e2064 = ((_e2045.member - _e2058.member) - select(0u, 1u, (_e2045.member_1 < _e2058.member_1)));
                        let _e2065 = (_e2045.member_1 - _e2058.member_1);
                        local_31 = array<type_9, 3>(type_9(_e1890[1][1][0].member, _e1890[1][1][0].member_1), type_9(_e1890[1][1][1].member, _e1890[1][1][1].member_1), type_9(_e1890[1][1][2].member, _e1890[1][1][2].member_1));
                        local_32 = array<type_9, 3>(type_9(_e1890[2][1][0].member, _e1890[2][1][0].member_1), type_9(_e1890[2][1][1].member, _e1890[2][1][1].member_1), type_9(_e1890[2][1][2].member, _e1890[2][1][2].member_1));
                        let _e2098 = local_31[1u].member;
                        let _e2100 = local_31[1u].member_1;
                        let _e2103 = local_32[2u].member;
                        let _e2105 = local_32[2u].member_1;
                        let _e2106 = function_11(_e2098, _e2100, _e2103, _e2105);
                        let _e2111 = local_31[2u].member;
                        let _e2113 = local_31[2u].member_1;
                        let _e2116 = local_32[1u].member;
                        let _e2118 = local_32[1u].member_1;
                        let _e2119 = function_11(_e2111, _e2113, _e2116, _e2118);
                        let _e2125 = ((_e2106.member - _e2119.member) - select(0u, 1u, (_e2106.member_1 < _e2119.member_1)));
                        let _e2126 = (_e2106.member_1 - _e2119.member_1);
                        local_29 = array<type_9, 3>(type_9(_e1890[1][1][0].member, _e1890[1][1][0].member_1), type_9(_e1890[1][1][1].member, _e1890[1][1][1].member_1), type_9(_e1890[1][1][2].member, _e1890[1][1][2].member_1));
                        local_30 = array<type_9, 3>(type_9(_e1890[2][1][0].member, _e1890[2][1][0].member_1), type_9(_e1890[2][1][1].member, _e1890[2][1][1].member_1), type_9(_e1890[2][1][2].member, _e1890[2][1][2].member_1));
                        let _e2155 = local_29[2u].member;
                        let _e2157 = local_29[2u].member_1;
                        let _e2160 = local_30[0u].member;
                        let _e2162 = local_30[0u].member_1;
                        let _e2163 = function_11(_e2155, _e2157, _e2160, _e2162);
                        let _e2168 = local_29[0u].member;
                        let _e2170 = local_29[0u].member_1;
                        let _e2173 = local_30[2u].member;
                        let _e2175 = local_30[2u].member_1;
                        let _e2176 = function_11(_e2168, _e2170, _e2173, _e2175);
                        let _e2182 = ((_e2163.member - _e2176.member) - select(0u, 1u, (_e2163.member_1 < _e2176.member_1)));
                        let _e2183 = (_e2163.member_1 - _e2176.member_1);
                        local_27 = array<type_9, 3>(type_9(_e1890[1][1][0].member, _e1890[1][1][0].member_1), type_9(_e1890[1][1][1].member, _e1890[1][1][1].member_1), type_9(_e1890[1][1][2].member, _e1890[1][1][2].member_1));
                        local_28 = array<type_9, 3>(type_9(_e1890[2][1][0].member, _e1890[2][1][0].member_1), type_9(_e1890[2][1][1].member, _e1890[2][1][1].member_1), type_9(_e1890[2][1][2].member, _e1890[2][1][2].member_1));
                        let _e2212 = local_27[0u].member;
                        let _e2214 = local_27[0u].member_1;
                        let _e2217 = local_28[1u].member;
                        let _e2219 = local_28[1u].member_1;
                        let _e2220 = function_11(_e2212, _e2214, _e2217, _e2219);
                        let _e2225 = local_27[1u].member;
                        let _e2227 = local_27[1u].member_1;
                        let _e2230 = local_28[0u].member;
                        let _e2232 = local_28[0u].member_1;
                        let _e2233 = function_11(_e2225, _e2227, _e2230, _e2232);
                        let _e2239 = ((_e2220.member - _e2233.member) - select(0u, 1u, (_e2220.member_1 < _e2233.member_1)));
                        let _e2240 = (_e2220.member_1 - _e2233.member_1);
                        local_25 = array<type_9, 3>(type_9(_e1890[1][0][0].member, _e1890[1][0][0].member_1), type_9(_e1890[1][0][1].member, _e1890[1][0][1].member_1), type_9(_e1890[1][0][2].member, _e1890[1][0][2].member_1));
                        local_26 = array<type_9, 3>(type_9(_e1890[2][1][0].member, _e1890[2][1][0].member_1), type_9(_e1890[2][1][1].member, _e1890[2][1][1].member_1), type_9(_e1890[2][1][2].member, _e1890[2][1][2].member_1));
                        let _e2273 = local_25[1u].member;
                        let _e2275 = local_25[1u].member_1;
                        let _e2278 = local_26[2u].member;
                        let _e2280 = local_26[2u].member_1;
                        let _e2281 = function_11(_e2273, _e2275, _e2278, _e2280);
                        let _e2286 = local_25[2u].member;
                        let _e2288 = local_25[2u].member_1;
                        let _e2291 = local_26[1u].member;
                        let _e2293 = local_26[1u].member_1;
                        let _e2294 = function_11(_e2286, _e2288, _e2291, _e2293);
                        let _e2301 = (_e2281.member_1 - _e2294.member_1);
                        local_23 = array<type_9, 3>(type_9(_e1890[1][0][0].member, _e1890[1][0][0].member_1), type_9(_e1890[1][0][1].member, _e1890[1][0][1].member_1), type_9(_e1890[1][0][2].member, _e1890[1][0][2].member_1));
                        local_24 = array<type_9, 3>(type_9(_e1890[2][1][0].member, _e1890[2][1][0].member_1), type_9(_e1890[2][1][1].member, _e1890[2][1][1].member_1), type_9(_e1890[2][1][2].member, _e1890[2][1][2].member_1));
                        let _e2330 = local_23[2u].member;
                        let _e2332 = local_23[2u].member_1;
                        let _e2335 = local_24[0u].member;
                        let _e2337 = local_24[0u].member_1;
                        let _e2338 = function_11(_e2330, _e2332, _e2335, _e2337);
                        let _e2343 = local_23[0u].member;
                        let _e2345 = local_23[0u].member_1;
                        let _e2348 = local_24[2u].member;
                        let _e2350 = local_24[2u].member_1;
                        let _e2351 = function_11(_e2343, _e2345, _e2348, _e2350);
                        let _e2358 = (_e2338.member_1 - _e2351.member_1);
                        local_21 = array<type_9, 3>(type_9(_e1890[1][0][0].member, _e1890[1][0][0].member_1), type_9(_e1890[1][0][1].member, _e1890[1][0][1].member_1), type_9(_e1890[1][0][2].member, _e1890[1][0][2].member_1));
                        local_22 = array<type_9, 3>(type_9(_e1890[2][1][0].member, _e1890[2][1][0].member_1), type_9(_e1890[2][1][1].member, _e1890[2][1][1].member_1), type_9(_e1890[2][1][2].member, _e1890[2][1][2].member_1));
                        let _e2387 = local_21[0u].member;
                        let _e2389 = local_21[0u].member_1;
                        let _e2392 = local_22[1u].member;
                        let _e2394 = local_22[1u].member_1;
                        let _e2395 = function_11(_e2387, _e2389, _e2392, _e2394);
                        let _e2400 = local_21[1u].member;
                        let _e2402 = local_21[1u].member_1;
                        let _e2405 = local_22[0u].member;
                        let _e2407 = local_22[0u].member_1;
                        let _e2408 = function_11(_e2400, _e2402, _e2405, _e2407);
                        let _e2415 = (_e2395.member_1 - _e2408.member_1);
                        local_19 = array<type_9, 3>(type_9(_e1890[1][1][0].member, _e1890[1][1][0].member_1), type_9(_e1890[1][1][1].member, _e1890[1][1][1].member_1), type_9(_e1890[1][1][2].member, _e1890[1][1][2].member_1));
                        local_20 = array<type_9, 3>(type_9(_e1890[2][0][0].member, _e1890[2][0][0].member_1), type_9(_e1890[2][0][1].member, _e1890[2][0][1].member_1), type_9(_e1890[2][0][2].member, _e1890[2][0][2].member_1));
                        let _e2448 = local_19[1u].member;
                        let _e2450 = local_19[1u].member_1;
                        let _e2453 = local_20[2u].member;
                        let _e2455 = local_20[2u].member_1;
                        let _e2456 = function_11(_e2448, _e2450, _e2453, _e2455);
                        let _e2461 = local_19[2u].member;
                        let _e2463 = local_19[2u].member_1;
                        let _e2466 = local_20[1u].member;
                        let _e2468 = local_20[1u].member_1;
                        let _e2469 = function_11(_e2461, _e2463, _e2466, _e2468);
                        local_17 = array<type_9, 3>(type_9(_e1890[1][1][0].member, _e1890[1][1][0].member_1), type_9(_e1890[1][1][1].member, _e1890[1][1][1].member_1), type_9(_e1890[1][1][2].member, _e1890[1][1][2].member_1));
                        local_18 = array<type_9, 3>(type_9(_e1890[2][0][0].member, _e1890[2][0][0].member_1), type_9(_e1890[2][0][1].member, _e1890[2][0][1].member_1), type_9(_e1890[2][0][2].member, _e1890[2][0][2].member_1));
                        let _e2505 = local_17[2u].member;
                        let _e2507 = local_17[2u].member_1;
                        let _e2510 = local_18[0u].member;
                        let _e2512 = local_18[0u].member_1;
                        let _e2513 = function_11(_e2505, _e2507, _e2510, _e2512);
                        let _e2518 = local_17[0u].member;
                        let _e2520 = local_17[0u].member_1;
                        let _e2523 = local_18[2u].member;
                        let _e2525 = local_18[2u].member_1;
                        let _e2526 = function_11(_e2518, _e2520, _e2523, _e2525);
                        local_15 = array<type_9, 3>(type_9(_e1890[1][1][0].member, _e1890[1][1][0].member_1), type_9(_e1890[1][1][1].member, _e1890[1][1][1].member_1), type_9(_e1890[1][1][2].member, _e1890[1][1][2].member_1));
                        local_16 = array<type_9, 3>(type_9(_e1890[2][0][0].member, _e1890[2][0][0].member_1), type_9(_e1890[2][0][1].member, _e1890[2][0][1].member_1), type_9(_e1890[2][0][2].member, _e1890[2][0][2].member_1));
                        let _e2562 = local_15[0u].member;
                        let _e2564 = local_15[0u].member_1;
                        let _e2567 = local_16[1u].member;
                        let _e2569 = local_16[1u].member_1;
                        let _e2570 = function_11(_e2562, _e2564, _e2567, _e2569);
                        let _e2575 = local_15[1u].member;
                        let _e2577 = local_15[1u].member_1;
                        let _e2580 = local_16[0u].member;
                        let _e2582 = local_16[0u].member_1;
                        let _e2583 = function_11(_e2575, _e2577, _e2580, _e2582);
                        let _e2591 = (_e2301 + (_e2456.member_1 - _e2469.member_1));
                        let _e2595 = ((((_e2281.member - _e2294.member) - select(0u, 1u, (_e2281.member_1 < _e2294.member_1))) + ((_e2456.member - _e2469.member) - select(0u, 1u, (_e2456.member_1 < _e2469.member_1)))) + select(0u, 1u, (_e2591 < _e2301)));
                        let _e2596 = (_e2358 + (_e2513.member_1 - _e2526.member_1));
                        let _e2600 = ((((_e2338.member - _e2351.member) - select(0u, 1u, (_e2338.member_1 < _e2351.member_1))) + ((_e2513.member - _e2526.member) - select(0u, 1u, (_e2513.member_1 < _e2526.member_1)))) + select(0u, 1u, (_e2596 < _e2358)));
                        let _e2601 = (_e2415 + (_e2570.member_1 - _e2583.member_1));
                        let _e2605 = ((((_e2395.member - _e2408.member) - select(0u, 1u, (_e2395.member_1 < _e2408.member_1))) + ((_e2570.member - _e2583.member) - select(0u, 1u, (_e2570.member_1 < _e2583.member_1)))) + select(0u, 1u, (_e2601 < _e2415)));
                        let _e2612 = function_11(_e1890[0][0][0].member, _e1890[0][0][0].member_1, _e1950, _e1951);
                        let _e2619 = function_11(_e1890[0][0][1].member, _e1890[0][0][1].member_1, _e2007, _e2008);
                        let _e2622 = (_e2612.member_1 + _e2619.member_1);
                        let _e2631 = function_11(_e1890[0][0][2].member, _e1890[0][0][2].member_1, _e2064, _e2065);
                        let _e2634 = (_e2622 + _e2631.member_1);
                        let _e2639 = function_15(((((_e2612.member + _e2619.member) + select(0u, 1u, (_e2622 < _e2612.member_1))) + _e2631.member) + select(0u, 1u, (_e2634 < _e2622))), _e2634);
                        let _e2648 = function_11(_e1890[0][1][0].member, _e1890[0][1][0].member_1, _e1950, _e1951);
                        let _e2655 = function_11(_e1890[0][1][1].member, _e1890[0][1][1].member_1, _e2007, _e2008);
                        let _e2658 = (_e2648.member_1 + _e2655.member_1);
                        let _e2667 = function_11(_e1890[0][1][2].member, _e1890[0][1][2].member_1, _e2064, _e2065);
                        let _e2670 = (_e2658 + _e2667.member_1);
                        let _e2681 = function_11(_e1890[0][0][0].member, _e1890[0][0][0].member_1, _e2595, _e2591);
                        let _e2688 = function_11(_e1890[0][0][1].member, _e1890[0][0][1].member_1, _e2600, _e2596);
                        let _e2691 = (_e2681.member_1 + _e2688.member_1);
                        let _e2700 = function_11(_e1890[0][0][2].member, _e1890[0][0][2].member_1, _e2605, _e2601);
                        let _e2703 = (_e2691 + _e2700.member_1);
                        let _e2708 = (_e2670 + _e2703);
                        let _e2712 = ((((((_e2648.member + _e2655.member) + select(0u, 1u, (_e2658 < _e2648.member_1))) + _e2667.member) + select(0u, 1u, (_e2670 < _e2658))) + ((((_e2681.member + _e2688.member) + select(0u, 1u, (_e2691 < _e2681.member_1))) + _e2700.member) + select(0u, 1u, (_e2703 < _e2691)))) + select(0u, 1u, (_e2708 < _e2670)));
                        let _e2719 = function_11(_e1890[0][0][0].member, _e1890[0][0][0].member_1, _e2125, _e2126);
                        let _e2726 = function_11(_e1890[0][0][1].member, _e1890[0][0][1].member_1, _e2182, _e2183);
                        let _e2729 = (_e2719.member_1 + _e2726.member_1);
                        let _e2738 = function_11(_e1890[0][0][2].member, _e1890[0][0][2].member_1, _e2239, _e2240);
                        let _e2741 = (_e2729 + _e2738.member_1);
                        let _e2752 = function_11(_e1890[0][1][0].member, _e1890[0][1][0].member_1, _e2595, _e2591);
                        let _e2759 = function_11(_e1890[0][1][1].member, _e1890[0][1][1].member_1, _e2600, _e2596);
                        let _e2762 = (_e2752.member_1 + _e2759.member_1);
                        let _e2771 = function_11(_e1890[0][1][2].member, _e1890[0][1][2].member_1, _e2605, _e2601);
                        let _e2774 = (_e2762 + _e2771.member_1);
                        let _e2779 = (_e2741 + _e2774);
                        let _e2783 = ((((((_e2719.member + _e2726.member) + select(0u, 1u, (_e2729 < _e2719.member_1))) + _e2738.member) + select(0u, 1u, (_e2741 < _e2729))) + ((((_e2752.member + _e2759.member) + select(0u, 1u, (_e2762 < _e2752.member_1))) + _e2771.member) + select(0u, 1u, (_e2774 < _e2762)))) + select(0u, 1u, (_e2779 < _e2741)));
                        let _e2790 = function_11(_e1890[0][1][0].member, _e1890[0][1][0].member_1, _e2125, _e2126);
                        let _e2797 = function_11(_e1890[0][1][1].member, _e1890[0][1][1].member_1, _e2182, _e2183);
                        let _e2800 = (_e2790.member_1 + _e2797.member_1);
                        let _e2809 = function_11(_e1890[0][1][2].member, _e1890[0][1][2].member_1, _e2239, _e2240);
                        let _e2812 = (_e2800 + _e2809.member_1);
                        let _e2817 = function_15(((((_e2790.member + _e2797.member) + select(0u, 1u, (_e2800 < _e2790.member_1))) + _e2809.member) + select(0u, 1u, (_e2812 < _e2800))), _e2812);
                        let _e2827 = select((bitcast<u32>(31i) - firstLeadingBit(_e1315)), 32u, (_e1315 == 0u));
                        let _e2829 = select(18u, _e2827, (18u < _e2827));
                        phi_5116_ = array<type_9, 4>(_e2639, type_9(_e2712, _e2708), type_9(_e2783, _e2779), _e2817);
                        phi_5119_ = false;
                        phi_5121_ = false;
                        phi_5123_ = false;
                        phi_5127_ = 0u;
                        phi_5129_ = 0u;
                        phi_5131_ = 0u;
                        loop {
                            let _e2831 = phi_5116_;
                            let _e2833 = phi_5119_;
                            let _e2835 = phi_5121_;
                            let _e2837 = phi_5123_;
                            let _e2839 = phi_5127_;
                            let _e2841 = phi_5129_;
                            let _e2843 = phi_5131_;
                            if (_e2839 < 128u) {
                                phi_5140_ = _e2831;
                                phi_5143_ = _e2837;
                                phi_5145_ = false;
                                phi_5149_ = false;
                                phi_5151_ = false;
                                phi_5153_ = 0u;
                                phi_5155_ = 0u;
                                phi_5157_ = _e2839;
                                phi_5159_ = _e2841;
                                phi_5161_ = _e2843;
                                loop {
                                    let _e2846 = phi_5140_;
                                    let _e2848 = phi_5143_;
                                    let _e2850 = phi_5145_;
                                    let _e2852 = phi_5149_;
                                    let _e2854 = phi_5151_;
                                    let _e2856 = phi_5153_;
                                    let _e2858 = phi_5155_;
                                    let _e2860 = phi_5157_;
                                    let _e2862 = phi_5159_;
                                    let _e2864 = phi_5161_;
                                    local_42 = _e2852;
                                    local_43 = _e2850;
                                    local_44 = _e2862;
                                    local_45 = _e2858;
                                    local_46 = _e2856;
                                    local_47 = _e2862;
                                    local_48 = _e2846;
                                    local_49 = _e2846;
                                    local_50 = _e2846;
                                    local_51 = _e2846;
                                    local_52 = _e2846;
                                    local_53 = _e2846;
                                    local_54 = _e2854;
                                    local_55 = _e2862;
                                    local_56 = _e2846;
                                    local_57 = _e2846;
                                    local_58 = _e2846;
                                    local_59 = _e2846;
                                    local_60 = _e2846;
                                    local_61 = _e2846;
                                    local_62 = _e2846;
                                    local_63 = _e2846;
                                    local_64 = _e2856;
                                    local_65 = _e2858;
                                    local_67 = _e2858;
                                    local_68 = _e2846;
                                    local_69 = _e2846;
                                    local_70 = _e2846;
                                    local_71 = _e2858;
                                    local_72 = _e2856;
                                    local_73 = _e2862;
                                    local_74 = _e2858;
                                    local_75 = _e2858;
                                    local_76 = _e2846;
                                    local_77 = _e2846;
                                    local_78 = _e2846;
                                    local_128 = _e2854;
                                    local_129 = _e2848;
                                    local_130 = _e2850;
                                    local_131 = _e2848;
                                    local_132 = _e2850;
                                    local_79 = _e2864;
                                    local_80 = _e2864;
                                    local_81 = _e2862;
                                    local_82 = _e2862;
                                    local_83 = _e2862;
                                    local_84 = _e2858;
                                    local_133 = _e2846;
                                    local_134 = _e2862;
                                    local_135 = _e2864;
                                    local_136 = _e2860;
                                    if (_e2860 < 128u) {
                                        if _e2850 {
                                            phi_5969_ = array<type_9, 4>();
                                            phi_5970_ = bool();
                                            phi_5971_ = bool();
                                            phi_5973_ = bool();
                                            phi_5974_ = bool();
                                            phi_5975_ = u32();
                                            phi_5976_ = u32();
                                            phi_5977_ = u32();
                                            phi_5978_ = u32();
                                            phi_5979_ = u32();
                                            phi_5980_ = false;
                                        } else {
                                            if _e2852 {
                                                phi_5957_ = array<type_9, 4>();
                                                phi_5958_ = bool();
                                                phi_5959_ = bool();
                                                phi_5961_ = bool();
                                                phi_5962_ = bool();
                                                phi_5963_ = u32();
                                                phi_5964_ = u32();
                                                phi_5965_ = u32();
                                                phi_5966_ = u32();
                                                phi_5967_ = u32();
                                                phi_5968_ = false;
                                            } else {
                                                let _e2867 = (31u - _e2862);
                                                let _e2870 = (_e2864 << bitcast<u32>((_e2867 & 31u)));
                                                let _e2874 = ((_e2864 + 1u) << bitcast<u32>((_e2867 & 31u)));
                                                if (_e2870 > _e1313) {
                                                    phi_5367_ = bool();
                                                    phi_5368_ = true;
                                                } else {
                                                    let _e2876 = (_e2874 < _e1311);
                                                    if _e2876 {
                                                        phi_5366_ = bool();
                                                    } else {
                                                        let _e2881 = function_14(128u);
                                                        let _e2886 = ((_e2846[0].member >> bitcast<u32>(31i)) != 0u);
                                                        let _e2914 = function_14(128u);
                                                        let _e2919 = ((_e2846[1].member >> bitcast<u32>(31i)) != 0u);
                                                        let _e2948 = function_14(128u);
                                                        let _e2953 = ((_e2846[2].member >> bitcast<u32>(31i)) != 0u);
                                                        let _e2982 = function_14(128u);
                                                        let _e2987 = ((_e2846[3].member >> bitcast<u32>(31i)) != 0u);
                                                        phi_5366_ = ((((select(0u, select(1u, 2u, ((_e2846[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2881.member - select(_e2846[0].member, (~(_e2846[0].member) + select(0u, 1u, (_e2846[0].member_1 == 0u))), _e2886)) - select(0u, 1u, (_e2881.member_1 < select(_e2846[0].member_1, (~(_e2846[0].member_1) + 1u), _e2886)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e2846[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e2914.member - select(_e2846[1].member, (~(_e2846[1].member) + select(0u, 1u, (_e2846[1].member_1 == 0u))), _e2919)) - select(0u, 1u, (_e2914.member_1 < select(_e2846[1].member_1, (~(_e2846[1].member_1) + 1u), _e2919)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2846[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e2948.member - select(_e2846[2].member, (~(_e2846[2].member) + select(0u, 1u, (_e2846[2].member_1 == 0u))), _e2953)) - select(0u, 1u, (_e2948.member_1 < select(_e2846[2].member_1, (~(_e2846[2].member_1) + 1u), _e2953)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2846[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e2982.member - select(_e2846[3].member, (~(_e2846[3].member) + select(0u, 1u, (_e2846[3].member_1 == 0u))), _e2987)) - select(0u, 1u, (_e2982.member_1 < select(_e2846[3].member_1, (~(_e2846[3].member_1) + 1u), _e2987)))) >> bitcast<u32>(31i)) != 0u))) != 0u);
                                                    }
                                                    let _e3014 = phi_5366_;
                                                    phi_5367_ = _e3014;
                                                    phi_5368_ = _e2876;
                                                }
                                                let _e3016 = phi_5367_;
                                                let _e3018 = phi_5368_;
                                                let _e3019 = select(_e3016, true, _e3018);
                                                let _e3024 = function_14(128u);
                                                let _e3029 = ((_e2846[0].member >> bitcast<u32>(31i)) != 0u);
                                                let _e3052 = select(0u, select(1u, 2u, ((_e2846[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3024.member - select(_e2846[0].member, (~(_e2846[0].member) + select(0u, 1u, (_e2846[0].member_1 == 0u))), _e3029)) - select(0u, 1u, (_e3024.member_1 < select(_e2846[0].member_1, (~(_e2846[0].member_1) + 1u), _e3029)))) >> bitcast<u32>(31i)) != 0u));
                                                let _e3057 = function_14(128u);
                                                let _e3062 = ((_e2846[1].member >> bitcast<u32>(31i)) != 0u);
                                                let _e3085 = select(0u, select(1u, 2u, ((_e2846[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e3057.member - select(_e2846[1].member, (~(_e2846[1].member) + select(0u, 1u, (_e2846[1].member_1 == 0u))), _e3062)) - select(0u, 1u, (_e3057.member_1 < select(_e2846[1].member_1, (~(_e2846[1].member_1) + 1u), _e3062)))) >> bitcast<u32>(31i)) != 0u));
                                                let _e3090 = function_14(128u);
                                                let _e3095 = ((_e2846[2].member >> bitcast<u32>(31i)) != 0u);
                                                let _e3118 = select(0u, select(1u, 2u, ((_e2846[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e3090.member - select(_e2846[2].member, (~(_e2846[2].member) + select(0u, 1u, (_e2846[2].member_1 == 0u))), _e3095)) - select(0u, 1u, (_e3090.member_1 < select(_e2846[2].member_1, (~(_e2846[2].member_1) + 1u), _e3095)))) >> bitcast<u32>(31i)) != 0u));
                                                let _e3123 = function_14(128u);
                                                let _e3128 = ((_e2846[3].member >> bitcast<u32>(31i)) != 0u);
                                                let _e3151 = select(0u, select(1u, 2u, ((_e2846[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e3123.member - select(_e2846[3].member, (~(_e2846[3].member) + select(0u, 1u, (_e2846[3].member_1 == 0u))), _e3128)) - select(0u, 1u, (_e3123.member_1 < select(_e2846[3].member_1, (~(_e2846[3].member_1) + 1u), _e3128)))) >> bitcast<u32>(31i)) != 0u));
                                                let _e3161 = select(false, select(true, select(false, (_e3085 != 0u), (_e3118 == _e3151)), select(true, (_e3118 == 0u), (_e3085 == _e3052))), ((_e3052 | _e3151) == 3u));
                                                let _e3162 = (_e2862 == 3u);
                                                let _e3163 = (_e2862 == 8u);
                                                let _e3175 = select(select(select(select(select(false, !(_e2835), _e3161), true, select(select(select((_e2862 == 14u), bool(), _e3163), bool(), _e3162), true, select(_e3163, true, _e3162))), false, _e2833), true, (_e2862 == 31u)), false, _e2848);
                                                if _e3019 {
                                                    phi_5952_ = _e2846;
                                                    phi_5953_ = _e2848;
                                                    phi_5955_ = _e2862;
                                                    phi_5956_ = _e2864;
                                                } else {
                                                    if _e3175 {
                                                        phi_5947_ = _e2846;
                                                        phi_5948_ = _e2848;
                                                        phi_5950_ = _e2862;
                                                        phi_5951_ = _e2864;
                                                    } else {
                                                        let _e3184 = (_e2846[0].member_1 + _e2846[1].member_1);
                                                        let _e3188 = ((_e2846[0].member + _e2846[1].member) + select(0u, 1u, (_e3184 < _e2846[0].member_1)));
                                                        let _e3196 = bitcast<u32>((bitcast<i32>(_e3188) >> bitcast<u32>(1u)));
                                                        let _e3199 = ((_e3184 >> bitcast<u32>(1u)) | ((_e3188 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                        let _e3208 = (_e2846[1].member_1 + _e2846[2].member_1);
                                                        let _e3212 = ((_e2846[1].member + _e2846[2].member) + select(0u, 1u, (_e3208 < _e2846[1].member_1)));
                                                        let _e3220 = bitcast<u32>((bitcast<i32>(_e3212) >> bitcast<u32>(1u)));
                                                        let _e3223 = ((_e3208 >> bitcast<u32>(1u)) | ((_e3212 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                        let _e3232 = (_e2846[2].member_1 + _e2846[3].member_1);
                                                        let _e3236 = ((_e2846[2].member + _e2846[3].member) + select(0u, 1u, (_e3232 < _e2846[2].member_1)));
                                                        let _e3244 = bitcast<u32>((bitcast<i32>(_e3236) >> bitcast<u32>(1u)));
                                                        let _e3247 = ((_e3232 >> bitcast<u32>(1u)) | ((_e3236 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                        let _e3248 = (_e3199 + _e3223);
                                                        let _e3252 = ((_e3196 + _e3220) + select(0u, 1u, (_e3248 < _e3199)));
                                                        let _e3260 = bitcast<u32>((bitcast<i32>(_e3252) >> bitcast<u32>(1u)));
                                                        let _e3263 = ((_e3248 >> bitcast<u32>(1u)) | ((_e3252 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                        let _e3264 = (_e3223 + _e3247);
                                                        let _e3268 = ((_e3220 + _e3244) + select(0u, 1u, (_e3264 < _e3223)));
                                                        let _e3276 = bitcast<u32>((bitcast<i32>(_e3268) >> bitcast<u32>(1u)));
                                                        let _e3279 = ((_e3264 >> bitcast<u32>(1u)) | ((_e3268 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                        let _e3280 = (_e3263 + _e3279);
                                                        let _e3284 = ((_e3260 + _e3276) + select(0u, 1u, (_e3280 < _e3263)));
                                                        let _e3292 = bitcast<u32>((bitcast<i32>(_e3284) >> bitcast<u32>(1u)));
                                                        let _e3295 = ((_e3280 >> bitcast<u32>(1u)) | ((_e3284 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                        let _e3296 = (2u * _e2864);
                                                        let _e3307 = function_14(128u);
                                                        let _e3312 = ((_e2846[0].member >> bitcast<u32>(31i)) != 0u);
                                                        let _e3336 = function_14(128u);
                                                        let _e3341 = ((_e3196 >> bitcast<u32>(31i)) != 0u);
                                                        let _e3363 = function_14(128u);
                                                        let _e3368 = ((_e3260 >> bitcast<u32>(31i)) != 0u);
                                                        let _e3390 = function_14(128u);
                                                        let _e3395 = ((_e3292 >> bitcast<u32>(31i)) != 0u);
                                                        if ((((select(0u, select(1u, 2u, ((_e2846[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3307.member - select(_e2846[0].member, (~(_e2846[0].member) + select(0u, 1u, (_e2846[0].member_1 == 0u))), _e3312)) - select(0u, 1u, (_e3307.member_1 < select(_e2846[0].member_1, (~(_e2846[0].member_1) + 1u), _e3312)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e3196 >> bitcast<u32>(31i)) != 0u)), ((((_e3336.member - select(_e3196, (~(_e3196) + select(0u, 1u, (_e3199 == 0u))), _e3341)) - select(0u, 1u, (_e3336.member_1 < select(_e3199, (~(_e3199) + 1u), _e3341)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e3260 >> bitcast<u32>(31i)) != 0u)), ((((_e3363.member - select(_e3260, (~(_e3260) + select(0u, 1u, (_e3263 == 0u))), _e3368)) - select(0u, 1u, (_e3363.member_1 < select(_e3263, (~(_e3263) + 1u), _e3368)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e3292 >> bitcast<u32>(31i)) != 0u)), ((((_e3390.member - select(_e3292, (~(_e3292) + select(0u, 1u, (_e3295 == 0u))), _e3395)) - select(0u, 1u, (_e3390.member_1 < select(_e3295, (~(_e3295) + 1u), _e3395)))) >> bitcast<u32>(31i)) != 0u))) != 0u) {
                                                            phi_5945_ = array<type_9, 4>(type_9(_e3292, _e3295), type_9(_e3276, _e3279), type_9(_e3244, _e3247), _e2846[3]);
                                                            phi_5946_ = (_e3296 + 1u);
                                                        } else {
                                                            phi_5945_ = array<type_9, 4>(_e2846[0], type_9(_e3196, _e3199), type_9(_e3260, _e3263), type_9(_e3292, _e3295));
                                                            phi_5946_ = _e3296;
                                                        }
                                                        let _e3425 = phi_5945_;
                                                        let _e3427 = phi_5946_;
                                                        phi_5947_ = _e3425;
                                                        phi_5948_ = false;
                                                        phi_5950_ = (_e2862 + 1u);
                                                        phi_5951_ = _e3427;
                                                    }
                                                    let _e3429 = phi_5947_;
                                                    let _e3431 = phi_5948_;
                                                    let _e3433 = phi_5950_;
                                                    let _e3435 = phi_5951_;
                                                    phi_5952_ = _e3429;
                                                    phi_5953_ = _e3431;
                                                    phi_5955_ = _e3433;
                                                    phi_5956_ = _e3435;
                                                }
                                                let _e3437 = phi_5952_;
                                                let _e3439 = phi_5953_;
                                                let _e3441 = phi_5955_;
                                                let _e3443 = phi_5956_;
                                                phi_5957_ = _e3437;
                                                phi_5958_ = _e3439;
                                                phi_5959_ = _e3019;
                                                phi_5961_ = _e3175;
                                                phi_5962_ = _e3161;
                                                phi_5963_ = _e2874;
                                                phi_5964_ = _e2870;
                                                phi_5965_ = (_e2860 + 1u);
                                                phi_5966_ = _e3441;
                                                phi_5967_ = _e3443;
                                                phi_5968_ = true;
                                            }
                                            let _e3445 = phi_5957_;
                                            let _e3447 = phi_5958_;
                                            let _e3449 = phi_5959_;
                                            let _e3451 = phi_5961_;
                                            let _e3453 = phi_5962_;
                                            let _e3455 = phi_5963_;
                                            let _e3457 = phi_5964_;
                                            let _e3459 = phi_5965_;
                                            let _e3461 = phi_5966_;
                                            let _e3463 = phi_5967_;
                                            let _e3465 = phi_5968_;
                                            phi_5969_ = _e3445;
                                            phi_5970_ = _e3447;
                                            phi_5971_ = _e3449;
                                            phi_5973_ = _e3451;
                                            phi_5974_ = _e3453;
                                            phi_5975_ = _e3455;
                                            phi_5976_ = _e3457;
                                            phi_5977_ = _e3459;
                                            phi_5978_ = _e3461;
                                            phi_5979_ = _e3463;
                                            phi_5980_ = _e3465;
                                        }
                                        let _e3467 = phi_5969_;
                                        let _e3469 = phi_5970_;
                                        let _e3471 = phi_5971_;
                                        let _e3473 = phi_5973_;
                                        let _e3475 = phi_5974_;
                                        let _e3477 = phi_5975_;
                                        let _e3479 = phi_5976_;
                                        let _e3481 = phi_5977_;
                                        let _e3483 = phi_5978_;
                                        let _e3485 = phi_5979_;
                                        let _e3487 = phi_5980_;
                                        phi_5141_ = _e3467;
                                        phi_5144_ = _e3469;
                                        phi_5146_ = _e3471;
                                        phi_5150_ = _e3473;
                                        phi_5152_ = _e3475;
                                        phi_5154_ = _e3477;
                                        phi_5156_ = _e3479;
                                        phi_5158_ = _e3481;
                                        phi_5160_ = _e3483;
                                        phi_5162_ = _e3485;
                                        phi_5981_ = _e3487;
                                    } else {
                                        phi_5141_ = array<type_9, 4>();
                                        phi_5144_ = bool();
                                        phi_5146_ = bool();
                                        phi_5150_ = bool();
                                        phi_5152_ = bool();
                                        phi_5154_ = u32();
                                        phi_5156_ = u32();
                                        phi_5158_ = u32();
                                        phi_5160_ = u32();
                                        phi_5162_ = u32();
                                        phi_5981_ = false;
                                    }
                                    let _e3489 = phi_5141_;
                                    let _e3491 = phi_5144_;
                                    let _e3493 = phi_5146_;
                                    let _e3495 = phi_5150_;
                                    let _e3497 = phi_5152_;
                                    let _e3499 = phi_5154_;
                                    let _e3501 = phi_5156_;
                                    let _e3503 = phi_5158_;
                                    let _e3505 = phi_5160_;
                                    let _e3507 = phi_5162_;
                                    let _e3509 = phi_5981_;
                                    continue;
                                    continuing {
                                        phi_5140_ = _e3489;
                                        phi_5143_ = _e3491;
                                        phi_5145_ = _e3493;
                                        phi_5149_ = _e3495;
                                        phi_5151_ = _e3497;
                                        phi_5153_ = _e3499;
                                        phi_5155_ = _e3501;
                                        phi_5157_ = _e3503;
                                        phi_5159_ = _e3505;
                                        phi_5161_ = _e3507;
                                        break if !(_e3509);
                                    }
                                }
                                let _e3512 = local_42;
                                if _e3512 {
                                    let _e3514 = local_43;
                                    if _e3514 {
                                        phi_8593_ = _e2833;
                                        phi_8594_ = _e2835;
                                        let _e9314 = local_129;
                                        phi_8595_ = _e9314;
                                        let _e9317 = local_130;
                                        phi_8596_ = _e9317;
                                        phi_8597_ = type_20();
                                        phi_8598_ = true;
                                        phi_8599_ = false;
                                        phi_8600_ = false;
                                    } else {
                                        let _e3516 = local_44;
                                        let _e3517 = (_e3516 == 31u);
                                        let _e3519 = local_45;
                                        let _e3521 = local_46;
                                        let _e3523 = local_47;
                                        let _e3524 = type_20(_e3519, _e3521, _e3523);
                                        let _e3526 = local_48;
                                        let _e3530 = local_49;
                                        let _e3533 = function_14(128u);
                                        let _e3538 = ((_e3526[0].member >> bitcast<u32>(31i)) != 0u);
                                        let _e3546 = local_50;
                                        let _e3565 = local_51;
                                        let _e3569 = local_52;
                                        let _e3572 = function_14(128u);
                                        let _e3577 = ((_e3565[3].member >> bitcast<u32>(31i)) != 0u);
                                        let _e3585 = local_53;
                                        let _e3604 = ((select(0u, select(1u, 2u, ((_e3526[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3533.member - select(_e3546[0].member, (~(_e3526[0].member) + select(0u, 1u, (_e3530[0].member_1 == 0u))), _e3538)) - select(0u, 1u, (_e3533.member_1 < select(_e3546[0].member_1, (~(_e3530[0].member_1) + 1u), _e3538)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e3565[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e3572.member - select(_e3585[3].member, (~(_e3565[3].member) + select(0u, 1u, (_e3569[3].member_1 == 0u))), _e3577)) - select(0u, 1u, (_e3572.member_1 < select(_e3585[3].member_1, (~(_e3569[3].member_1) + 1u), _e3577)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                        let _e3606 = local_54;
                                        if _e3606 {
                                            let _e3608 = local_55;
                                            if (_e3608 < _e2829) {
                                                let _e3611 = local_56;
                                                let _e3615 = local_57;
                                                let _e3622 = ((f32(bitcast<i32>(_e3611[0].member)) * 4294967300f) + f32(_e3615[0].member_1));
                                                let _e3624 = local_58;
                                                let _e3628 = local_59;
                                                let _e3635 = ((f32(bitcast<i32>(_e3624[1].member)) * 4294967300f) + f32(_e3628[1].member_1));
                                                let _e3637 = local_60;
                                                let _e3641 = local_61;
                                                let _e3648 = ((f32(bitcast<i32>(_e3637[2].member)) * 4294967300f) + f32(_e3641[2].member_1));
                                                let _e3650 = local_62;
                                                let _e3654 = local_63;
                                                let _e3661 = ((f32(bitcast<i32>(_e3650[3].member)) * 4294967300f) + f32(_e3654[3].member_1));
                                                phi_6117_ = type_14(0i, 4i);
                                                phi_6120_ = (_e3622 / (_e3622 - _e3661));
                                                loop {
                                                    let _e3665 = phi_6117_;
                                                    let _e3667 = phi_6120_;
                                                    local_66 = _e3667;
                                                    if (_e3665.member < _e3665.member_1) {
                                                        let _e3674 = (_e3665.member + 1i);
                                                        phi_6118_ = type_14(select(_e3674, type_15().member_1, select(false, true, ((false == (_e3674 > _e3665.member)) != false))), _e3665.member_1);
                                                        phi_6161_ = type_15(1u, _e3665.member);
                                                    } else {
                                                        phi_6118_ = _e3665;
                                                        phi_6161_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e3685 = phi_6118_;
                                                    let _e3687 = phi_6161_;
                                                    let _e3690 = (bitcast<i32>(_e3687.member) != 0i);
                                                    if _e3690 {
                                                        let _e3691 = function_13(_e3622, _e3635, _e3667);
                                                        let _e3692 = function_13(_e3635, _e3648, _e3667);
                                                        let _e3693 = function_13(_e3648, _e3661, _e3667);
                                                        let _e3694 = function_13(_e3691, _e3692, _e3667);
                                                        let _e3695 = function_13(_e3692, _e3693, _e3667);
                                                        let _e3696 = function_13(_e3694, _e3695, _e3667);
                                                        let _e3701 = function_1((_e3667 - (_e3696 / (3f * (_e3695 - _e3694)))), 0f);
                                                        let _e3702 = function_(_e3701, 1f);
                                                        phi_6121_ = _e3702;
                                                    } else {
                                                        phi_6121_ = f32();
                                                    }
                                                    let _e3704 = phi_6121_;
                                                    continue;
                                                    continuing {
                                                        phi_6117_ = _e3685;
                                                        phi_6120_ = _e3704;
                                                        break if !(_e3690);
                                                    }
                                                }
                                                let _e3709 = (1u << bitcast<u32>(((31u - _e2829) & 31u)));
                                                let _e3711 = local_64;
                                                let _e3713 = local_65;
                                                let _e3714 = (_e3711 - _e3713);
                                                let _e3717 = local_66;
                                                let _e3718 = (_e3717 * f32(_e3714));
                                                let _e3723 = select(select(u32(_e3718), 0u, (_e3718 < 0f)), 4294967295u, (_e3718 > 4294967000f));
                                                let _e3725 = select(_e3723, _e3714, (_e3714 < _e3723));
                                                let _e3727 = local_67;
                                                let _e3728 = (_e3727 + _e3725);
                                                let _e3734 = function_7(((_e2712 - _e2639.member) - select(0u, 1u, (_e2708 < _e2639.member_1))), (_e2708 - _e2639.member_1), _e3728);
                                                let _e3737 = (_e2639.member_1 + _e3734.member_1);
                                                let _e3741 = ((_e2639.member + _e3734.member) + select(0u, 1u, (_e3737 < _e2639.member_1)));
                                                let _e3747 = function_7(((_e2783 - _e2712) - select(0u, 1u, (_e2779 < _e2708))), (_e2779 - _e2708), _e3728);
                                                let _e3750 = (_e2708 + _e3747.member_1);
                                                let _e3754 = ((_e2712 + _e3747.member) + select(0u, 1u, (_e3750 < _e2708)));
                                                let _e3760 = function_7(((_e2817.member - _e2783) - select(0u, 1u, (_e2817.member_1 < _e2779))), (_e2817.member_1 - _e2779), _e3728);
                                                let _e3763 = (_e2779 + _e3760.member_1);
                                                let _e3773 = function_7(((_e3754 - _e3741) - select(0u, 1u, (_e3750 < _e3737))), (_e3750 - _e3737), _e3728);
                                                let _e3776 = (_e3737 + _e3773.member_1);
                                                let _e3780 = ((_e3741 + _e3773.member) + select(0u, 1u, (_e3776 < _e3737)));
                                                let _e3786 = function_7(((((_e2783 + _e3760.member) + select(0u, 1u, (_e3763 < _e2779))) - _e3754) - select(0u, 1u, (_e3763 < _e3750))), (_e3763 - _e3750), _e3728);
                                                let _e3789 = (_e3750 + _e3786.member_1);
                                                let _e3799 = function_7(((((_e3754 + _e3786.member) + select(0u, 1u, (_e3789 < _e3750))) - _e3780) - select(0u, 1u, (_e3789 < _e3776))), (_e3789 - _e3776), _e3728);
                                                let _e3802 = (_e3776 + _e3799.member_1);
                                                let _e3806 = ((_e3780 + _e3799.member) + select(0u, 1u, (_e3802 < _e3776)));
                                                let _e3807 = function_14(128u);
                                                let _e3812 = ((_e3806 >> bitcast<u32>(31i)) != 0u);
                                                let _e3832 = select(0u, select(1u, 2u, ((_e3806 >> bitcast<u32>(31i)) != 0u)), ((((_e3807.member - select(_e3806, (~(_e3806) + select(0u, 1u, (_e3802 == 0u))), _e3812)) - select(0u, 1u, (_e3807.member_1 < select(_e3802, (~(_e3802) + 1u), _e3812)))) >> bitcast<u32>(31i)) != 0u));
                                                let _e3834 = local_68;
                                                let _e3838 = local_69;
                                                let _e3841 = function_14(128u);
                                                let _e3846 = ((_e3834[0].member >> bitcast<u32>(31i)) != 0u);
                                                let _e3854 = local_70;
                                                let _e3872 = (_e3832 == select(0u, select(1u, 2u, ((_e3834[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3841.member - select(_e3854[0].member, (~(_e3834[0].member) + select(0u, 1u, (_e3838[0].member_1 == 0u))), _e3846)) - select(0u, 1u, (_e3841.member_1 < select(_e3854[0].member_1, (~(_e3838[0].member_1) + 1u), _e3846)))) >> bitcast<u32>(31i)) != 0u)));
                                                let _e3873 = (_e3714 - _e3725);
                                                let _e3880 = select((_e3728 - select(_e3709, _e3725, (_e3725 < _e3709))), (_e3728 + select(_e3709, _e3873, (_e3873 < _e3709))), _e3872);
                                                let _e3886 = function_7(((_e2712 - _e2639.member) - select(0u, 1u, (_e2708 < _e2639.member_1))), (_e2708 - _e2639.member_1), _e3880);
                                                let _e3889 = (_e2639.member_1 + _e3886.member_1);
                                                let _e3893 = ((_e2639.member + _e3886.member) + select(0u, 1u, (_e3889 < _e2639.member_1)));
                                                let _e3899 = function_7(((_e2783 - _e2712) - select(0u, 1u, (_e2779 < _e2708))), (_e2779 - _e2708), _e3880);
                                                let _e3902 = (_e2708 + _e3899.member_1);
                                                let _e3906 = ((_e2712 + _e3899.member) + select(0u, 1u, (_e3902 < _e2708)));
                                                let _e3912 = function_7(((_e2817.member - _e2783) - select(0u, 1u, (_e2817.member_1 < _e2779))), (_e2817.member_1 - _e2779), _e3880);
                                                let _e3915 = (_e2779 + _e3912.member_1);
                                                let _e3925 = function_7(((_e3906 - _e3893) - select(0u, 1u, (_e3902 < _e3889))), (_e3902 - _e3889), _e3880);
                                                let _e3928 = (_e3889 + _e3925.member_1);
                                                let _e3932 = ((_e3893 + _e3925.member) + select(0u, 1u, (_e3928 < _e3889)));
                                                let _e3938 = function_7(((((_e2783 + _e3912.member) + select(0u, 1u, (_e3915 < _e2779))) - _e3906) - select(0u, 1u, (_e3915 < _e3902))), (_e3915 - _e3902), _e3880);
                                                let _e3941 = (_e3902 + _e3938.member_1);
                                                let _e3951 = function_7(((((_e3906 + _e3938.member) + select(0u, 1u, (_e3941 < _e3902))) - _e3932) - select(0u, 1u, (_e3941 < _e3928))), (_e3941 - _e3928), _e3880);
                                                let _e3954 = (_e3928 + _e3951.member_1);
                                                let _e3958 = ((_e3932 + _e3951.member) + select(0u, 1u, (_e3954 < _e3928)));
                                                let _e3959 = function_14(128u);
                                                let _e3964 = ((_e3958 >> bitcast<u32>(31i)) != 0u);
                                                let _e3986 = ((_e3832 | select(0u, select(1u, 2u, ((_e3958 >> bitcast<u32>(31i)) != 0u)), ((((_e3959.member - select(_e3958, (~(_e3958) + select(0u, 1u, (_e3954 == 0u))), _e3964)) - select(0u, 1u, (_e3959.member_1 < select(_e3954, (~(_e3954) + 1u), _e3964)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                                let _e3990 = local_71;
                                                let _e3993 = local_72;
                                                let _e3996 = local_73;
                                                phi_6606_ = _e3986;
                                                phi_6607_ = type_20(select(_e3990, select(_e3880, _e3728, _e3872), _e3986), select(_e3993, select(_e3728, _e3880, _e3872), _e3986), select(_e3996, _e2829, _e3986));
                                                phi_6608_ = false;
                                            } else {
                                                phi_6606_ = bool();
                                                phi_6607_ = type_20();
                                                phi_6608_ = true;
                                            }
                                            let _e4000 = phi_6606_;
                                            let _e4002 = phi_6607_;
                                            let _e4004 = phi_6608_;
                                            phi_6609_ = _e4000;
                                            phi_6610_ = _e4002;
                                            phi_6611_ = _e4004;
                                        } else {
                                            phi_6609_ = bool();
                                            phi_6610_ = type_20();
                                            phi_6611_ = true;
                                        }
                                        let _e4006 = phi_6609_;
                                        let _e4008 = phi_6610_;
                                        let _e4010 = phi_6611_;
                                        if _e4010 {
                                            if _e3517 {
                                                if _e3604 {
                                                    phi_6847_ = _e3604;
                                                    phi_6848_ = _e3524;
                                                } else {
                                                    let _e4015 = select((bitcast<u32>(31i) - firstLeadingBit(_e1315)), 32u, (_e1315 == 0u));
                                                    let _e4021 = local_74;
                                                    let _e4022 = (_e4021 + (1u << bitcast<u32>(((31u - _e4015) & 31u))));
                                                    let _e4024 = local_75;
                                                    if (_e4022 <= 2147483648u) {
                                                        let _e4028 = local_76;
                                                        let _e4032 = local_77;
                                                        let _e4035 = function_14(128u);
                                                        let _e4040 = ((_e4028[0].member >> bitcast<u32>(31i)) != 0u);
                                                        let _e4048 = local_78;
                                                        let _e4071 = function_7(((_e2712 - _e2639.member) - select(0u, 1u, (_e2708 < _e2639.member_1))), (_e2708 - _e2639.member_1), _e4022);
                                                        let _e4074 = (_e2639.member_1 + _e4071.member_1);
                                                        let _e4078 = ((_e2639.member + _e4071.member) + select(0u, 1u, (_e4074 < _e2639.member_1)));
                                                        let _e4084 = function_7(((_e2783 - _e2712) - select(0u, 1u, (_e2779 < _e2708))), (_e2779 - _e2708), _e4022);
                                                        let _e4087 = (_e2708 + _e4084.member_1);
                                                        let _e4091 = ((_e2712 + _e4084.member) + select(0u, 1u, (_e4087 < _e2708)));
                                                        let _e4097 = function_7(((_e2817.member - _e2783) - select(0u, 1u, (_e2817.member_1 < _e2779))), (_e2817.member_1 - _e2779), _e4022);
                                                        let _e4100 = (_e2779 + _e4097.member_1);
                                                        let _e4110 = function_7(((_e4091 - _e4078) - select(0u, 1u, (_e4087 < _e4074))), (_e4087 - _e4074), _e4022);
                                                        let _e4113 = (_e4074 + _e4110.member_1);
                                                        let _e4117 = ((_e4078 + _e4110.member) + select(0u, 1u, (_e4113 < _e4074)));
                                                        let _e4123 = function_7(((((_e2783 + _e4097.member) + select(0u, 1u, (_e4100 < _e2779))) - _e4091) - select(0u, 1u, (_e4100 < _e4087))), (_e4100 - _e4087), _e4022);
                                                        let _e4126 = (_e4087 + _e4123.member_1);
                                                        let _e4136 = function_7(((((_e4091 + _e4123.member) + select(0u, 1u, (_e4126 < _e4087))) - _e4117) - select(0u, 1u, (_e4126 < _e4113))), (_e4126 - _e4113), _e4022);
                                                        let _e4139 = (_e4113 + _e4136.member_1);
                                                        let _e4143 = ((_e4117 + _e4136.member) + select(0u, 1u, (_e4139 < _e4113)));
                                                        let _e4144 = function_14(128u);
                                                        let _e4149 = ((_e4143 >> bitcast<u32>(31i)) != 0u);
                                                        phi_6846_ = ((select(0u, select(1u, 2u, ((_e4028[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e4035.member - select(_e4048[0].member, (~(_e4028[0].member) + select(0u, 1u, (_e4032[0].member_1 == 0u))), _e4040)) - select(0u, 1u, (_e4035.member_1 < select(_e4048[0].member_1, (~(_e4032[0].member_1) + 1u), _e4040)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e4143 >> bitcast<u32>(31i)) != 0u)), ((((_e4144.member - select(_e4143, (~(_e4143) + select(0u, 1u, (_e4139 == 0u))), _e4149)) - select(0u, 1u, (_e4144.member_1 < select(_e4139, (~(_e4139) + 1u), _e4149)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                                    } else {
                                                        phi_6846_ = false;
                                                    }
                                                    let _e4173 = phi_6846_;
                                                    phi_6847_ = _e4173;
                                                    phi_6848_ = type_20(_e4024, _e4022, _e4015);
                                                }
                                                let _e4175 = phi_6847_;
                                                let _e4177 = phi_6848_;
                                                phi_6849_ = _e4175;
                                                phi_6850_ = _e4177;
                                            } else {
                                                phi_6849_ = _e3604;
                                                phi_6850_ = _e3524;
                                            }
                                            let _e4179 = phi_6849_;
                                            let _e4181 = phi_6850_;
                                            phi_6851_ = _e2833;
                                            phi_6852_ = _e4179;
                                            phi_6853_ = _e4181;
                                        } else {
                                            phi_6851_ = _e4006;
                                            phi_6852_ = _e3604;
                                            phi_6853_ = _e4008;
                                        }
                                        let _e4183 = phi_6851_;
                                        let _e4185 = phi_6852_;
                                        let _e4187 = phi_6853_;
                                        let _e4206 = ((_e1890[0][1][0].member - _e1890[0][0][0].member) - select(0u, 1u, (_e1890[0][1][0].member_1 < _e1890[0][0][0].member_1)));
                                        let _e4207 = (_e1890[0][1][0].member_1 - _e1890[0][0][0].member_1);
                                        let _e4219 = ((_e1890[0][1][1].member - _e1890[0][0][1].member) - select(0u, 1u, (_e1890[0][1][1].member_1 < _e1890[0][0][1].member_1)));
                                        let _e4220 = (_e1890[0][1][1].member_1 - _e1890[0][0][1].member_1);
                                        let _e4232 = ((_e1890[0][1][2].member - _e1890[0][0][2].member) - select(0u, 1u, (_e1890[0][1][2].member_1 < _e1890[0][0][2].member_1)));
                                        let _e4233 = (_e1890[0][1][2].member_1 - _e1890[0][0][2].member_1);
                                        let _e4236 = ((_e4206 >> bitcast<u32>(31i)) != 0u);
                                        let _e4243 = select(_e4206, (~(_e4206) + select(0u, 1u, (_e4207 == 0u))), _e4236);
                                        let _e4244 = select(_e4207, (~(_e4207) + 1u), _e4236);
                                        let _e4247 = ((_e4219 >> bitcast<u32>(31i)) != 0u);
                                        let _e4254 = select(_e4219, (~(_e4219) + select(0u, 1u, (_e4220 == 0u))), _e4247);
                                        let _e4255 = select(_e4220, (~(_e4220) + 1u), _e4247);
                                        let _e4262 = ((((_e4254 - _e4243) - select(0u, 1u, (_e4255 < _e4244))) >> bitcast<u32>(31i)) != 0u);
                                        let _e4263 = select(_e4254, _e4243, _e4262);
                                        let _e4264 = select(_e4255, _e4244, _e4262);
                                        let _e4267 = ((_e4232 >> bitcast<u32>(31i)) != 0u);
                                        let _e4274 = select(_e4232, (~(_e4232) + select(0u, 1u, (_e4233 == 0u))), _e4267);
                                        let _e4275 = select(_e4233, (~(_e4233) + 1u), _e4267);
                                        let _e4282 = ((((_e4274 - _e4263) - select(0u, 1u, (_e4275 < _e4264))) >> bitcast<u32>(31i)) != 0u);
                                        let _e4284 = select(_e4275, _e4264, _e4282);
                                        let _e4285 = function_14(4u);
                                        let _e4288 = (_e4284 + _e4285.member_1);
                                        let _e4292 = ((select(_e4274, _e4263, _e4282) + _e4285.member) + select(0u, 1u, (_e4288 < _e4284)));
                                        let _e4307 = ((_e4288 >> bitcast<u32>((_e4187.member_2 & 31u))) | ((_e4292 << bitcast<u32>(((31u - _e4187.member_2) & 31u))) << bitcast<u32>(1i)));
                                        let _e4308 = function_14(4u);
                                        let _e4311 = (_e4307 + _e4308.member_1);
                                        let _e4329 = ((_e1890[1][1][0].member - _e1890[1][0][0].member) - select(0u, 1u, (_e1890[1][1][0].member_1 < _e1890[1][0][0].member_1)));
                                        let _e4330 = (_e1890[1][1][0].member_1 - _e1890[1][0][0].member_1);
                                        let _e4342 = ((_e1890[1][1][1].member - _e1890[1][0][1].member) - select(0u, 1u, (_e1890[1][1][1].member_1 < _e1890[1][0][1].member_1)));
                                        let _e4343 = (_e1890[1][1][1].member_1 - _e1890[1][0][1].member_1);
                                        let _e4355 = ((_e1890[1][1][2].member - _e1890[1][0][2].member) - select(0u, 1u, (_e1890[1][1][2].member_1 < _e1890[1][0][2].member_1)));
                                        let _e4356 = (_e1890[1][1][2].member_1 - _e1890[1][0][2].member_1);
                                        let _e4359 = ((_e4329 >> bitcast<u32>(31i)) != 0u);
                                        let _e4366 = select(_e4329, (~(_e4329) + select(0u, 1u, (_e4330 == 0u))), _e4359);
                                        let _e4367 = select(_e4330, (~(_e4330) + 1u), _e4359);
                                        let _e4370 = ((_e4342 >> bitcast<u32>(31i)) != 0u);
                                        let _e4377 = select(_e4342, (~(_e4342) + select(0u, 1u, (_e4343 == 0u))), _e4370);
                                        let _e4378 = select(_e4343, (~(_e4343) + 1u), _e4370);
                                        let _e4385 = ((((_e4377 - _e4366) - select(0u, 1u, (_e4378 < _e4367))) >> bitcast<u32>(31i)) != 0u);
                                        let _e4386 = select(_e4377, _e4366, _e4385);
                                        let _e4387 = select(_e4378, _e4367, _e4385);
                                        let _e4390 = ((_e4355 >> bitcast<u32>(31i)) != 0u);
                                        let _e4397 = select(_e4355, (~(_e4355) + select(0u, 1u, (_e4356 == 0u))), _e4390);
                                        let _e4398 = select(_e4356, (~(_e4356) + 1u), _e4390);
                                        let _e4405 = ((((_e4397 - _e4386) - select(0u, 1u, (_e4398 < _e4387))) >> bitcast<u32>(31i)) != 0u);
                                        let _e4407 = select(_e4398, _e4387, _e4405);
                                        let _e4408 = function_14(4u);
                                        let _e4411 = (_e4407 + _e4408.member_1);
                                        let _e4415 = ((select(_e4397, _e4386, _e4405) + _e4408.member) + select(0u, 1u, (_e4411 < _e4407)));
                                        let _e4430 = ((_e4411 >> bitcast<u32>((_e4187.member_2 & 31u))) | ((_e4415 << bitcast<u32>(((31u - _e4187.member_2) & 31u))) << bitcast<u32>(1i)));
                                        let _e4431 = function_14(4u);
                                        let _e4434 = (_e4430 + _e4431.member_1);
                                        let _e4452 = ((_e1890[2][1][0].member - _e1890[2][0][0].member) - select(0u, 1u, (_e1890[2][1][0].member_1 < _e1890[2][0][0].member_1)));
                                        let _e4453 = (_e1890[2][1][0].member_1 - _e1890[2][0][0].member_1);
                                        let _e4465 = ((_e1890[2][1][1].member - _e1890[2][0][1].member) - select(0u, 1u, (_e1890[2][1][1].member_1 < _e1890[2][0][1].member_1)));
                                        let _e4466 = (_e1890[2][1][1].member_1 - _e1890[2][0][1].member_1);
                                        let _e4478 = ((_e1890[2][1][2].member - _e1890[2][0][2].member) - select(0u, 1u, (_e1890[2][1][2].member_1 < _e1890[2][0][2].member_1)));
                                        let _e4479 = (_e1890[2][1][2].member_1 - _e1890[2][0][2].member_1);
                                        let _e4482 = ((_e4452 >> bitcast<u32>(31i)) != 0u);
                                        let _e4489 = select(_e4452, (~(_e4452) + select(0u, 1u, (_e4453 == 0u))), _e4482);
                                        let _e4490 = select(_e4453, (~(_e4453) + 1u), _e4482);
                                        let _e4493 = ((_e4465 >> bitcast<u32>(31i)) != 0u);
                                        let _e4500 = select(_e4465, (~(_e4465) + select(0u, 1u, (_e4466 == 0u))), _e4493);
                                        let _e4501 = select(_e4466, (~(_e4466) + 1u), _e4493);
                                        let _e4508 = ((((_e4500 - _e4489) - select(0u, 1u, (_e4501 < _e4490))) >> bitcast<u32>(31i)) != 0u);
                                        let _e4509 = select(_e4500, _e4489, _e4508);
                                        let _e4510 = select(_e4501, _e4490, _e4508);
                                        let _e4513 = ((_e4478 >> bitcast<u32>(31i)) != 0u);
                                        let _e4520 = select(_e4478, (~(_e4478) + select(0u, 1u, (_e4479 == 0u))), _e4513);
                                        let _e4521 = select(_e4479, (~(_e4479) + 1u), _e4513);
                                        let _e4528 = ((((_e4520 - _e4509) - select(0u, 1u, (_e4521 < _e4510))) >> bitcast<u32>(31i)) != 0u);
                                        let _e4530 = select(_e4521, _e4510, _e4528);
                                        let _e4531 = function_14(4u);
                                        let _e4534 = (_e4530 + _e4531.member_1);
                                        let _e4538 = ((select(_e4520, _e4509, _e4528) + _e4531.member) + select(0u, 1u, (_e4534 < _e4530)));
                                        let _e4553 = ((_e4534 >> bitcast<u32>((_e4187.member_2 & 31u))) | ((_e4538 << bitcast<u32>(((31u - _e4187.member_2) & 31u))) << bitcast<u32>(1i)));
                                        let _e4554 = function_14(4u);
                                        let _e4557 = (_e4553 + _e4554.member_1);
                                        local_14[0u].member = ((bitcast<u32>((bitcast<i32>(_e4292) >> bitcast<u32>((_e4187.member_2 & 31u)))) + _e4308.member) + select(0u, 1u, (_e4311 < _e4307)));
                                        local_14[0u].member_1 = _e4311;
                                        local_14[1u].member = ((bitcast<u32>((bitcast<i32>(_e4415) >> bitcast<u32>((_e4187.member_2 & 31u)))) + _e4431.member) + select(0u, 1u, (_e4434 < _e4430)));
                                        local_14[1u].member_1 = _e4434;
                                        local_14[2u].member = ((bitcast<u32>((bitcast<i32>(_e4538) >> bitcast<u32>((_e4187.member_2 & 31u)))) + _e4554.member) + select(0u, 1u, (_e4557 < _e4553)));
                                        local_14[2u].member_1 = _e4557;
                                        let _e4587 = function_7(((_e1890[0][1][0].member - _e1890[0][0][0].member) - select(0u, 1u, (_e1890[0][1][0].member_1 < _e1890[0][0][0].member_1))), (_e1890[0][1][0].member_1 - _e1890[0][0][0].member_1), _e4187.member);
                                        let _e4590 = (_e1890[0][0][0].member_1 + _e4587.member_1);
                                        let _e4594 = ((_e1890[0][0][0].member + _e4587.member) + select(0u, 1u, (_e4590 < _e1890[0][0][0].member_1)));
                                        let _e4608 = function_7(((_e1890[0][1][1].member - _e1890[0][0][1].member) - select(0u, 1u, (_e1890[0][1][1].member_1 < _e1890[0][0][1].member_1))), (_e1890[0][1][1].member_1 - _e1890[0][0][1].member_1), _e4187.member);
                                        let _e4611 = (_e1890[0][0][1].member_1 + _e4608.member_1);
                                        let _e4615 = ((_e1890[0][0][1].member + _e4608.member) + select(0u, 1u, (_e4611 < _e1890[0][0][1].member_1)));
                                        let _e4629 = function_7(((_e1890[0][1][2].member - _e1890[0][0][2].member) - select(0u, 1u, (_e1890[0][1][2].member_1 < _e1890[0][0][2].member_1))), (_e1890[0][1][2].member_1 - _e1890[0][0][2].member_1), _e4187.member);
                                        let _e4632 = (_e1890[0][0][2].member_1 + _e4629.member_1);
                                        let _e4636 = ((_e1890[0][0][2].member + _e4629.member) + select(0u, 1u, (_e4632 < _e1890[0][0][2].member_1)));
                                        let _e4652 = function_7(((_e1890[1][1][0].member - _e1890[1][0][0].member) - select(0u, 1u, (_e1890[1][1][0].member_1 < _e1890[1][0][0].member_1))), (_e1890[1][1][0].member_1 - _e1890[1][0][0].member_1), _e4187.member);
                                        let _e4655 = (_e1890[1][0][0].member_1 + _e4652.member_1);
                                        let _e4659 = ((_e1890[1][0][0].member + _e4652.member) + select(0u, 1u, (_e4655 < _e1890[1][0][0].member_1)));
                                        let _e4673 = function_7(((_e1890[1][1][1].member - _e1890[1][0][1].member) - select(0u, 1u, (_e1890[1][1][1].member_1 < _e1890[1][0][1].member_1))), (_e1890[1][1][1].member_1 - _e1890[1][0][1].member_1), _e4187.member);
                                        let _e4676 = (_e1890[1][0][1].member_1 + _e4673.member_1);
                                        let _e4680 = ((_e1890[1][0][1].member + _e4673.member) + select(0u, 1u, (_e4676 < _e1890[1][0][1].member_1)));
                                        let _e4694 = function_7(((_e1890[1][1][2].member - _e1890[1][0][2].member) - select(0u, 1u, (_e1890[1][1][2].member_1 < _e1890[1][0][2].member_1))), (_e1890[1][1][2].member_1 - _e1890[1][0][2].member_1), _e4187.member);
                                        let _e4697 = (_e1890[1][0][2].member_1 + _e4694.member_1);
                                        let _e4701 = ((_e1890[1][0][2].member + _e4694.member) + select(0u, 1u, (_e4697 < _e1890[1][0][2].member_1)));
                                        let _e4717 = function_7(((_e1890[2][1][0].member - _e1890[2][0][0].member) - select(0u, 1u, (_e1890[2][1][0].member_1 < _e1890[2][0][0].member_1))), (_e1890[2][1][0].member_1 - _e1890[2][0][0].member_1), _e4187.member);
                                        let _e4720 = (_e1890[2][0][0].member_1 + _e4717.member_1);
                                        let _e4724 = ((_e1890[2][0][0].member + _e4717.member) + select(0u, 1u, (_e4720 < _e1890[2][0][0].member_1)));
                                        let _e4738 = function_7(((_e1890[2][1][1].member - _e1890[2][0][1].member) - select(0u, 1u, (_e1890[2][1][1].member_1 < _e1890[2][0][1].member_1))), (_e1890[2][1][1].member_1 - _e1890[2][0][1].member_1), _e4187.member);
                                        let _e4741 = (_e1890[2][0][1].member_1 + _e4738.member_1);
                                        let _e4745 = ((_e1890[2][0][1].member + _e4738.member) + select(0u, 1u, (_e4741 < _e1890[2][0][1].member_1)));
                                        let _e4759 = function_7(((_e1890[2][1][2].member - _e1890[2][0][2].member) - select(0u, 1u, (_e1890[2][1][2].member_1 < _e1890[2][0][2].member_1))), (_e1890[2][1][2].member_1 - _e1890[2][0][2].member_1), _e4187.member);
                                        let _e4762 = (_e1890[2][0][2].member_1 + _e4759.member_1);
                                        let _e4766 = ((_e1890[2][0][2].member + _e4759.member) + select(0u, 1u, (_e4762 < _e1890[2][0][2].member_1)));
                                        local_12 = array<type_9, 3>(type_9(_e4659, _e4655), type_9(_e4680, _e4676), type_9(_e4701, _e4697));
                                        local_13 = array<type_9, 3>(type_9(_e4724, _e4720), type_9(_e4745, _e4741), type_9(_e4766, _e4762));
                                        let _e4777 = local_12[1u].member;
                                        let _e4779 = local_12[1u].member_1;
                                        let _e4782 = local_13[2u].member;
                                        let _e4784 = local_13[2u].member_1;
                                        let _e4785 = function_11(_e4777, _e4779, _e4782, _e4784);
                                        let _e4790 = local_12[2u].member;
                                        let _e4792 = local_12[2u].member_1;
                                        let _e4795 = local_13[1u].member;
                                        let _e4797 = local_13[1u].member_1;
                                        let _e4798 = function_11(_e4790, _e4792, _e4795, _e4797);
                                        let _e4804 = ((_e4785.member - _e4798.member) - select(0u, 1u, (_e4785.member_1 < _e4798.member_1)));
                                        let _e4805 = (_e4785.member_1 - _e4798.member_1);
                                        local_10 = array<type_9, 3>(type_9(_e4659, _e4655), type_9(_e4680, _e4676), type_9(_e4701, _e4697));
                                        local_11 = array<type_9, 3>(type_9(_e4724, _e4720), type_9(_e4745, _e4741), type_9(_e4766, _e4762));
                                        let _e4816 = local_10[2u].member;
                                        let _e4818 = local_10[2u].member_1;
                                        let _e4821 = local_11[0u].member;
                                        let _e4823 = local_11[0u].member_1;
                                        let _e4824 = function_11(_e4816, _e4818, _e4821, _e4823);
                                        let _e4829 = local_10[0u].member;
                                        let _e4831 = local_10[0u].member_1;
                                        let _e4834 = local_11[2u].member;
                                        let _e4836 = local_11[2u].member_1;
                                        let _e4837 = function_11(_e4829, _e4831, _e4834, _e4836);
                                        let _e4843 = ((_e4824.member - _e4837.member) - select(0u, 1u, (_e4824.member_1 < _e4837.member_1)));
                                        let _e4844 = (_e4824.member_1 - _e4837.member_1);
                                        local_8 = array<type_9, 3>(type_9(_e4659, _e4655), type_9(_e4680, _e4676), type_9(_e4701, _e4697));
                                        local_9 = array<type_9, 3>(type_9(_e4724, _e4720), type_9(_e4745, _e4741), type_9(_e4766, _e4762));
                                        let _e4855 = local_8[0u].member;
                                        let _e4857 = local_8[0u].member_1;
                                        let _e4860 = local_9[1u].member;
                                        let _e4862 = local_9[1u].member_1;
                                        let _e4863 = function_11(_e4855, _e4857, _e4860, _e4862);
                                        let _e4868 = local_8[1u].member;
                                        let _e4870 = local_8[1u].member_1;
                                        let _e4873 = local_9[0u].member;
                                        let _e4875 = local_9[0u].member_1;
                                        let _e4876 = function_11(_e4868, _e4870, _e4873, _e4875);
                                        let _e4882 = ((_e4863.member - _e4876.member) - select(0u, 1u, (_e4863.member_1 < _e4876.member_1)));
                                        let _e4883 = (_e4863.member_1 - _e4876.member_1);
                                        let _e4886 = ((_e4804 >> bitcast<u32>(31i)) != 0u);
                                        let _e4893 = select(_e4804, (~(_e4804) + select(0u, 1u, (_e4805 == 0u))), _e4886);
                                        let _e4894 = select(_e4805, (~(_e4805) + 1u), _e4886);
                                        let _e4897 = ((_e4843 >> bitcast<u32>(31i)) != 0u);
                                        let _e4904 = select(_e4843, (~(_e4843) + select(0u, 1u, (_e4844 == 0u))), _e4897);
                                        let _e4905 = select(_e4844, (~(_e4844) + 1u), _e4897);
                                        let _e4908 = ((_e4882 >> bitcast<u32>(31i)) != 0u);
                                        let _e4915 = select(_e4882, (~(_e4882) + select(0u, 1u, (_e4883 == 0u))), _e4908);
                                        let _e4916 = select(_e4883, (~(_e4883) + 1u), _e4908);
                                        let _e4941 = select(0i, select(2i, 1i, ((((_e4915 - _e4904) - select(0u, 1u, (_e4916 < _e4905))) >> bitcast<u32>(31i)) != 0u)), select(true, select(true, false, ((((_e4915 - _e4893) - select(0u, 1u, (_e4916 < _e4894))) >> bitcast<u32>(31i)) != 0u)), ((((_e4904 - _e4893) - select(0u, 1u, (_e4905 < _e4894))) >> bitcast<u32>(31i)) != 0u)));
                                        switch _e4941 {
                                            case 0: {
                                                phi_8000_ = array<type_9, 2>(type_9(_e4615, _e4611), type_9(_e4636, _e4632));
                                                break;
                                            }
                                            case 1: {
                                                phi_8000_ = array<type_9, 2>(type_9(_e4636, _e4632), type_9(_e4594, _e4590));
                                                break;
                                            }
                                            default: {
                                                phi_8000_ = array<type_9, 2>(type_9(_e4594, _e4590), type_9(_e4615, _e4611));
                                                break;
                                            }
                                        }
                                        let _e4952 = phi_8000_;
                                        switch _e4941 {
                                            case 0: {
                                                phi_8029_ = array<type_9, 2>(type_9(_e4680, _e4676), type_9(_e4701, _e4697));
                                                break;
                                            }
                                            case 1: {
                                                phi_8029_ = array<type_9, 2>(type_9(_e4701, _e4697), type_9(_e4659, _e4655));
                                                break;
                                            }
                                            default: {
                                                phi_8029_ = array<type_9, 2>(type_9(_e4659, _e4655), type_9(_e4680, _e4676));
                                                break;
                                            }
                                        }
                                        let _e4963 = phi_8029_;
                                        switch _e4941 {
                                            case 0: {
                                                phi_8058_ = array<type_9, 2>(type_9(_e4745, _e4741), type_9(_e4766, _e4762));
                                                break;
                                            }
                                            case 1: {
                                                phi_8058_ = array<type_9, 2>(type_9(_e4766, _e4762), type_9(_e4724, _e4720));
                                                break;
                                            }
                                            default: {
                                                phi_8058_ = array<type_9, 2>(type_9(_e4724, _e4720), type_9(_e4745, _e4741));
                                                break;
                                            }
                                        }
                                        let _e4974 = phi_8058_;
                                        switch _e4941 {
                                            case 0: {
                                                phi_8072_ = type_9(_e4804, _e4805);
                                                break;
                                            }
                                            case 1: {
                                                phi_8072_ = type_9(_e4843, _e4844);
                                                break;
                                            }
                                            default: {
                                                phi_8072_ = type_9(_e4882, _e4883);
                                                break;
                                            }
                                        }
                                        let _e4979 = phi_8072_;
                                        let _e4982 = local_14[1u].member;
                                        let _e4984 = local_14[1u].member_1;
                                        let _e4987 = local_14[2u].member;
                                        let _e4989 = local_14[2u].member_1;
                                        let _e4990 = (_e4984 + _e4989);
                                        let _e4994 = ((_e4982 + _e4987) + select(0u, 1u, (_e4990 < _e4984)));
                                        let _e5005 = ((_e4990 >> bitcast<u32>(1u)) | ((_e4994 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                        let _e5006 = function_14(17u);
                                        let _e5009 = (_e5005 + _e5006.member_1);
                                        let _e5013 = ((bitcast<u32>((bitcast<i32>(_e4994) >> bitcast<u32>(1u))) + _e5006.member) + select(0u, 1u, (_e5009 < _e5005)));
                                        let _e5016 = local_14[0u].member;
                                        let _e5018 = local_14[0u].member_1;
                                        let _e5021 = local_14[2u].member;
                                        let _e5023 = local_14[2u].member_1;
                                        let _e5024 = (_e5018 + _e5023);
                                        let _e5028 = ((_e5016 + _e5021) + select(0u, 1u, (_e5024 < _e5018)));
                                        let _e5039 = ((_e5024 >> bitcast<u32>(1u)) | ((_e5028 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                        let _e5040 = function_14(17u);
                                        let _e5043 = (_e5039 + _e5040.member_1);
                                        let _e5047 = ((bitcast<u32>((bitcast<i32>(_e5028) >> bitcast<u32>(1u))) + _e5040.member) + select(0u, 1u, (_e5043 < _e5039)));
                                        let _e5050 = local_14[0u].member;
                                        let _e5052 = local_14[0u].member_1;
                                        let _e5055 = local_14[1u].member;
                                        let _e5057 = local_14[1u].member_1;
                                        let _e5058 = (_e5052 + _e5057);
                                        let _e5062 = ((_e5050 + _e5055) + select(0u, 1u, (_e5058 < _e5052)));
                                        let _e5073 = ((_e5058 >> bitcast<u32>(1u)) | ((_e5062 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                        let _e5074 = function_14(17u);
                                        let _e5077 = (_e5073 + _e5074.member_1);
                                        let _e5081 = ((bitcast<u32>((bitcast<i32>(_e5062) >> bitcast<u32>(1u))) + _e5074.member) + select(0u, 1u, (_e5077 < _e5073)));
                                        let _e5086 = ((_e4979.member >> bitcast<u32>(31i)) != 0u);
                                        if ((((_e5013 - select(_e4979.member, (~(_e4979.member) + select(0u, 1u, (_e4979.member_1 == 0u))), _e5086)) - select(0u, 1u, (_e5009 < select(_e4979.member_1, (~(_e4979.member_1) + 1u), _e5086)))) >> bitcast<u32>(31i)) != 0u) {
                                            let _e5107 = ((_e4979.member >> bitcast<u32>(31i)) != 0u);
                                            let _e5117 = select(_e4979.member, (~(_e4979.member) + select(0u, 1u, (_e4979.member_1 == 0u))), _e5107);
                                            let _e5119 = select(_e4979.member_1, (~(_e4979.member_1) + 1u), _e5107);
                                            let _e5120 = function_12(_e4952, _e4974);
                                            let _e5130 = select(_e5120.member, (~(_e5120.member) + select(0u, 1u, (_e5120.member_1 == 0u))), _e5107);
                                            let _e5132 = select(_e5120.member_1, (~(_e5120.member_1) + 1u), _e5107);
                                            let _e5133 = function_12(_e4963, _e4952);
                                            let _e5143 = select(_e5133.member, (~(_e5133.member) + select(0u, 1u, (_e5133.member_1 == 0u))), _e5107);
                                            let _e5145 = select(_e5133.member_1, (~(_e5133.member_1) + 1u), _e5107);
                                            if (_e282.member != 0u) {
                                                let _e5177 = (_e5009 + _e5043);
                                                let _e5189 = (_e5009 + _e5077);
                                                phi_8394_ = type_9(((_e5013 + _e5081) + select(0u, 1u, (_e5189 < _e5009))), _e5189);
                                                phi_8395_ = type_9(((_e5117 - _e5143) - select(0u, 1u, (_e5119 < _e5145))), (_e5119 - _e5145));
                                                phi_8396_ = type_9(((_e5013 + _e5047) + select(0u, 1u, (_e5177 < _e5009))), _e5177);
                                                phi_8397_ = type_9(((_e5117 - _e5130) - select(0u, 1u, (_e5119 < _e5132))), (_e5119 - _e5132));
                                            } else {
                                                let _e5151 = (_e5119 - _e5132);
                                                let _e5155 = ((((_e5117 - _e5130) - select(0u, 1u, (_e5119 < _e5132))) - _e5143) - select(0u, 1u, (_e5151 < _e5145)));
                                                let _e5156 = (_e5151 - _e5145);
                                                let _e5158 = (_e5009 + _e5043);
                                                let _e5163 = (_e5158 + _e5077);
                                                let _e5167 = ((((_e5013 + _e5047) + select(0u, 1u, (_e5158 < _e5009))) + _e5081) + select(0u, 1u, (_e5163 < _e5158)));
                                                phi_8394_ = type_9(_e5167, _e5163);
                                                phi_8395_ = type_9(_e5155, _e5156);
                                                phi_8396_ = type_9(_e5167, _e5163);
                                                phi_8397_ = type_9(_e5155, _e5156);
                                            }
                                            let _e5196 = phi_8394_;
                                            let _e5198 = phi_8395_;
                                            let _e5200 = phi_8396_;
                                            let _e5202 = phi_8397_;
                                            let _e5203 = function_10(_e5130, _e5132, _e5047, _e5043);
                                            if _e5203 {
                                                phi_8523_ = u32();
                                                phi_8524_ = true;
                                            } else {
                                                let _e5204 = function_10(_e5143, _e5145, _e5081, _e5077);
                                                if _e5204 {
                                                    phi_8521_ = u32();
                                                    phi_8522_ = true;
                                                } else {
                                                    let _e5209 = function_10(_e5202.member, _e5202.member_1, _e5200.member, _e5200.member_1);
                                                    if _e5209 {
                                                        phi_8519_ = u32();
                                                        phi_8520_ = true;
                                                    } else {
                                                        let _e5214 = function_10(_e5198.member, _e5198.member_1, _e5196.member, _e5196.member_1);
                                                        if _e5214 {
                                                            phi_8518_ = u32();
                                                        } else {
                                                            let _e5215 = function_9(_e5130, _e5132, _e5047, _e5043);
                                                            if _e5215 {
                                                                let _e5216 = function_9(_e5143, _e5145, _e5081, _e5077);
                                                                if _e5216 {
                                                                    let _e5221 = function_9(_e5202.member, _e5202.member_1, _e5200.member, _e5200.member_1);
                                                                    if _e5221 {
                                                                        let _e5226 = function_9(_e5198.member, _e5198.member_1, _e5196.member, _e5196.member_1);
                                                                        phi_8511_ = select(true, false, _e5226);
                                                                    } else {
                                                                        phi_8511_ = true;
                                                                    }
                                                                    let _e5229 = phi_8511_;
                                                                    phi_8512_ = _e5229;
                                                                } else {
                                                                    phi_8512_ = true;
                                                                }
                                                                let _e5231 = phi_8512_;
                                                                phi_8513_ = _e5231;
                                                            } else {
                                                                phi_8513_ = true;
                                                            }
                                                            let _e5233 = phi_8513_;
                                                            phi_8518_ = select(0u, 2u, _e5233);
                                                        }
                                                        let _e5236 = phi_8518_;
                                                        phi_8519_ = _e5236;
                                                        phi_8520_ = _e5214;
                                                    }
                                                    let _e5238 = phi_8519_;
                                                    let _e5240 = phi_8520_;
                                                    phi_8521_ = _e5238;
                                                    phi_8522_ = _e5240;
                                                }
                                                let _e5242 = phi_8521_;
                                                let _e5244 = phi_8522_;
                                                phi_8523_ = _e5242;
                                                phi_8524_ = _e5244;
                                            }
                                            let _e5246 = phi_8523_;
                                            let _e5248 = phi_8524_;
                                            phi_8529_ = select(_e5246, 1u, _e5248);
                                        } else {
                                            phi_8529_ = 2u;
                                        }
                                        let _e5251 = phi_8529_;
                                        let _e5259 = select(select(false, select((_e4187.member > _e1313), true, (_e4187.member_1 < _e1311)), _e4183), true, (_e5251 == 1u));
                                        let _e5273 = select(true, select(true, select(true, select(true, false, (_e5251 == 0u)), ((_e4187.member_1 - _e4187.member) <= _e1315)), select(false, (_e4187.member_1 <= _e1313), (_e4187.member >= _e1311))), _e4185);
                                        let _e5274 = select(true, _e5259, _e3517);
                                        phi_8593_ = _e4183;
                                        let _e9311 = local_128;
                                        phi_8594_ = _e9311;
                                        phi_8595_ = true;
                                        phi_8596_ = _e5259;
                                        phi_8597_ = _e4187;
                                        phi_8598_ = select(false, _e5274, _e5273);
                                        phi_8599_ = select(false, select(true, false, _e5274), _e5273);
                                        phi_8600_ = select(true, false, _e5273);
                                    }
                                    let _e5280 = phi_8593_;
                                    let _e5282 = phi_8594_;
                                    let _e5284 = phi_8595_;
                                    let _e5286 = phi_8596_;
                                    let _e5288 = phi_8597_;
                                    let _e5290 = phi_8598_;
                                    let _e5292 = phi_8599_;
                                    let _e5294 = phi_8600_;
                                    phi_8601_ = _e5280;
                                    phi_8602_ = _e5282;
                                    phi_8603_ = _e5284;
                                    phi_8604_ = _e5286;
                                    phi_8605_ = _e5288;
                                    phi_8606_ = _e5290;
                                    phi_8607_ = _e5292;
                                    phi_8608_ = _e5294;
                                } else {
                                    phi_8601_ = _e2833;
                                    phi_8602_ = _e2835;
                                    let _e9326 = local_131;
                                    phi_8603_ = _e9326;
                                    let _e9329 = local_132;
                                    phi_8604_ = _e9329;
                                    phi_8605_ = type_20();
                                    phi_8606_ = true;
                                    phi_8607_ = false;
                                    phi_8608_ = false;
                                }
                                let _e5296 = phi_8601_;
                                let _e5298 = phi_8602_;
                                let _e5300 = phi_8603_;
                                let _e5302 = phi_8604_;
                                let _e5304 = phi_8605_;
                                let _e5306 = phi_8606_;
                                let _e5308 = phi_8607_;
                                let _e5310 = phi_8608_;
                                if _e5306 {
                                    if _e5302 {
                                        let _e5312 = local_79;
                                        let _e5313 = (_e5312 + 1u);
                                        let _e5315 = local_80;
                                        let _e5317 = (_e5313 & (4294967295u - _e5315));
                                        let _e5323 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e5317)), 32u, (_e5317 == 0u)));
                                        let _e5325 = local_81;
                                        let _e5328 = local_82;
                                        let _e5329 = select(_e5323, _e5328, (_e5325 < _e5323));
                                        let _e5332 = (_e5313 >> bitcast<u32>((_e5329 & 31u)));
                                        let _e5334 = local_83;
                                        let _e5335 = (_e5334 - _e5329);
                                        let _e5337 = local_84;
                                        let _e5338 = (_e5337 > _e1313);
                                        if _e5338 {
                                            phi_8909_ = array<type_9, 4>();
                                            phi_8910_ = false;
                                            phi_8911_ = false;
                                        } else {
                                            let _e5342 = select(true, select(true, false, (_e5335 == 0u)), (_e5332 == 1u));
                                            if _e5342 {
                                                let _e5343 = (31u - _e5335);
                                                let _e5346 = (_e5332 << bitcast<u32>((_e5343 & 31u)));
                                                let _e5350 = ((_e5332 + 1u) << bitcast<u32>((_e5343 & 31u)));
                                                let _e5356 = function_7(((_e2712 - _e2639.member) - select(0u, 1u, (_e2708 < _e2639.member_1))), (_e2708 - _e2639.member_1), _e5346);
                                                let _e5359 = (_e2639.member_1 + _e5356.member_1);
                                                let _e5369 = function_7(((_e2783 - _e2712) - select(0u, 1u, (_e2779 < _e2708))), (_e2779 - _e2708), _e5346);
                                                let _e5372 = (_e2708 + _e5369.member_1);
                                                let _e5382 = function_7(((_e2817.member - _e2783) - select(0u, 1u, (_e2817.member_1 < _e2779))), (_e2817.member_1 - _e2779), _e5346);
                                                let _e5385 = (_e2779 + _e5382.member_1);
                                                let _e5393 = array<type_9, 3>(type_9(((_e2639.member + _e5356.member) + select(0u, 1u, (_e5359 < _e2639.member_1))), _e5359), type_9(((_e2712 + _e5369.member) + select(0u, 1u, (_e5372 < _e2708))), _e5372), type_9(((_e2783 + _e5382.member) + select(0u, 1u, (_e5385 < _e2779))), _e5385));
                                                let _e5399 = function_7(((_e2712 - _e2639.member) - select(0u, 1u, (_e2708 < _e2639.member_1))), (_e2708 - _e2639.member_1), _e5350);
                                                let _e5402 = (_e2639.member_1 + _e5399.member_1);
                                                let _e5412 = function_7(((_e2783 - _e2712) - select(0u, 1u, (_e2779 < _e2708))), (_e2779 - _e2708), _e5350);
                                                let _e5415 = (_e2708 + _e5412.member_1);
                                                let _e5425 = function_7(((_e2817.member - _e2783) - select(0u, 1u, (_e2817.member_1 < _e2779))), (_e2817.member_1 - _e2779), _e5350);
                                                let _e5428 = (_e2779 + _e5425.member_1);
                                                let _e5437 = function_8(_e5393, _e5346);
                                                let _e5438 = function_8(_e5393, _e5350);
                                                let _e5439 = function_8(array<type_9, 3>(type_9(((_e2639.member + _e5399.member) + select(0u, 1u, (_e5402 < _e2639.member_1))), _e5402), type_9(((_e2712 + _e5412.member) + select(0u, 1u, (_e5415 < _e2708))), _e5415), type_9(((_e2783 + _e5425.member) + select(0u, 1u, (_e5428 < _e2779))), _e5428)), _e5350);
                                                let _e5453 = function_7(((_e5437[1].member - _e5437[0].member) - select(0u, 1u, (_e5437[1].member_1 < _e5437[0].member_1))), (_e5437[1].member_1 - _e5437[0].member_1), _e5346);
                                                let _e5456 = (_e5437[0].member_1 + _e5453.member_1);
                                                let _e5474 = function_7(((_e5437[1].member - _e5437[0].member) - select(0u, 1u, (_e5437[1].member_1 < _e5437[0].member_1))), (_e5437[1].member_1 - _e5437[0].member_1), _e5350);
                                                let _e5477 = (_e5437[0].member_1 + _e5474.member_1);
                                                let _e5495 = function_7(((_e5438[1].member - _e5438[0].member) - select(0u, 1u, (_e5438[1].member_1 < _e5438[0].member_1))), (_e5438[1].member_1 - _e5438[0].member_1), _e5350);
                                                let _e5498 = (_e5438[0].member_1 + _e5495.member_1);
                                                let _e5516 = function_7(((_e5439[1].member - _e5439[0].member) - select(0u, 1u, (_e5439[1].member_1 < _e5439[0].member_1))), (_e5439[1].member_1 - _e5439[0].member_1), _e5350);
                                                let _e5519 = (_e5439[0].member_1 + _e5516.member_1);
                                                phi_8907_ = array<type_9, 4>(type_9(((_e5437[0].member + _e5453.member) + select(0u, 1u, (_e5456 < _e5437[0].member_1))), _e5456), type_9(((_e5437[0].member + _e5474.member) + select(0u, 1u, (_e5477 < _e5437[0].member_1))), _e5477), type_9(((_e5438[0].member + _e5495.member) + select(0u, 1u, (_e5498 < _e5438[0].member_1))), _e5498), type_9(((_e5439[0].member + _e5516.member) + select(0u, 1u, (_e5519 < _e5439[0].member_1))), _e5519));
                                                phi_8908_ = false;
                                            } else {
                                                phi_8907_ = array<type_9, 4>();
                                                phi_8908_ = true;
                                            }
                                            let _e5530 = phi_8907_;
                                            let _e5532 = phi_8908_;
                                            phi_8909_ = _e5530;
                                            phi_8910_ = _e5342;
                                            phi_8911_ = _e5532;
                                        }
                                        let _e5534 = phi_8909_;
                                        let _e5536 = phi_8910_;
                                        let _e5538 = phi_8911_;
                                        phi_8912_ = _e5534;
                                        phi_8913_ = false;
                                        phi_8914_ = false;
                                        phi_8915_ = false;
                                        phi_8916_ = _e5335;
                                        phi_8917_ = _e5332;
                                        phi_8918_ = _e5536;
                                        phi_8919_ = _e5338;
                                        phi_8920_ = _e5538;
                                    } else {
                                        let _e9347 = local_133;
                                        phi_8912_ = _e9347;
                                        phi_8913_ = _e5296;
                                        phi_8914_ = _e5298;
                                        phi_8915_ = _e5300;
                                        let _e9353 = local_134;
                                        phi_8916_ = _e9353;
                                        let _e9356 = local_135;
                                        phi_8917_ = _e9356;
                                        phi_8918_ = true;
                                        phi_8919_ = false;
                                        phi_8920_ = false;
                                    }
                                    let _e5540 = phi_8912_;
                                    let _e5542 = phi_8913_;
                                    let _e5544 = phi_8914_;
                                    let _e5546 = phi_8915_;
                                    let _e5548 = phi_8916_;
                                    let _e5550 = phi_8917_;
                                    let _e5552 = phi_8918_;
                                    let _e5554 = phi_8919_;
                                    let _e5556 = phi_8920_;
                                    phi_8926_ = _e5540;
                                    phi_8927_ = _e5542;
                                    phi_8928_ = _e5544;
                                    phi_8929_ = _e5546;
                                    phi_8930_ = _e5548;
                                    phi_8931_ = _e5550;
                                    phi_8932_ = _e5552;
                                    phi_8933_ = select(_e5554, false, _e5552);
                                    phi_8934_ = select(_e5556, false, _e5552);
                                    phi_8935_ = false;
                                    phi_8936_ = false;
                                } else {
                                    phi_8926_ = array<type_9, 4>();
                                    phi_8927_ = bool();
                                    phi_8928_ = bool();
                                    phi_8929_ = bool();
                                    phi_8930_ = u32();
                                    phi_8931_ = u32();
                                    phi_8932_ = false;
                                    phi_8933_ = false;
                                    phi_8934_ = false;
                                    phi_8935_ = _e5308;
                                    phi_8936_ = _e5310;
                                }
                                let _e5560 = phi_8926_;
                                let _e5562 = phi_8927_;
                                let _e5564 = phi_8928_;
                                let _e5566 = phi_8929_;
                                let _e5568 = phi_8930_;
                                let _e5570 = phi_8931_;
                                let _e5572 = phi_8932_;
                                let _e5574 = phi_8933_;
                                let _e5576 = phi_8934_;
                                let _e5578 = phi_8935_;
                                let _e5580 = phi_8936_;
                                phi_5117_ = _e5560;
                                phi_5120_ = _e5562;
                                phi_5122_ = _e5564;
                                phi_5124_ = _e5566;
                                let _e9377 = local_136;
                                phi_5128_ = _e9377;
                                phi_5130_ = _e5568;
                                phi_5132_ = _e5570;
                                phi_8937_ = _e5304;
                                phi_8938_ = _e5572;
                                phi_8939_ = false;
                                phi_8940_ = _e5574;
                                phi_8941_ = _e5576;
                                phi_8942_ = _e5578;
                                phi_8943_ = _e5580;
                            } else {
                                phi_5117_ = array<type_9, 4>();
                                phi_5120_ = bool();
                                phi_5122_ = bool();
                                phi_5124_ = bool();
                                phi_5128_ = u32();
                                phi_5130_ = u32();
                                phi_5132_ = u32();
                                phi_8937_ = type_20();
                                phi_8938_ = false;
                                phi_8939_ = true;
                                phi_8940_ = false;
                                phi_8941_ = false;
                                phi_8942_ = false;
                                phi_8943_ = false;
                            }
                            let _e5582 = phi_5117_;
                            let _e5584 = phi_5120_;
                            let _e5586 = phi_5122_;
                            let _e5588 = phi_5124_;
                            let _e5590 = phi_5128_;
                            let _e5592 = phi_5130_;
                            let _e5594 = phi_5132_;
                            let _e5596 = phi_8937_;
                            let _e5598 = phi_8938_;
                            let _e5600 = phi_8939_;
                            let _e5602 = phi_8940_;
                            let _e5604 = phi_8941_;
                            let _e5606 = phi_8942_;
                            let _e5608 = phi_8943_;
                            local_85 = _e5600;
                            local_86 = _e5600;
                            local_87 = _e5600;
                            local_88 = _e5602;
                            local_89 = _e5600;
                            local_90 = _e5604;
                            local_91 = _e5600;
                            local_92 = _e5606;
                            local_93 = _e5600;
                            local_94 = _e5608;
                            local_95 = _e5596;
                            continue;
                            continuing {
                                phi_5116_ = _e5582;
                                phi_5119_ = _e5584;
                                phi_5121_ = _e5586;
                                phi_5123_ = _e5588;
                                phi_5127_ = _e5590;
                                phi_5129_ = _e5592;
                                phi_5131_ = _e5594;
                                break if !(_e5598);
                            }
                        }
                        let _e5612 = local_85;
                        let _e5617 = local_86;
                        let _e5620 = local_87;
                        let _e5622 = local_88;
                        let _e5623 = select(_e5622, false, _e5620);
                        let _e5625 = local_89;
                        let _e5627 = local_90;
                        let _e5630 = local_91;
                        let _e5632 = local_92;
                        let _e5635 = local_93;
                        let _e5637 = local_94;
                        let _e5639 = select(select(_e5627, false, _e5625), false, _e5623);
                        let _e5642 = select(_e5623, true, _e5639);
                        let _e5650 = select(select(select(select(_e5632, false, _e5630), false, _e5623), false, _e5639), false, _e5642);
                        let _e5657 = select(select(select(select(select(_e5637, false, _e5635), false, _e5623), false, _e5639), false, _e5642), false, _e5650);
                        let _e5660 = local_95;
                        let _e5664 = select(_e5650, true, _e5657);
                        let _e5668 = select(select(select(_e5642, false, _e5650), false, _e5657), true, _e5664);
                        let _e5670 = select(select(type_9().member_1, type_9().member_1, _e5617), select(select(type_9().member_1, type_9().member_1, _e5642), select(select(type_9().member_1, type_9().member_1, _e5650), _e5660.member, _e5657), _e5664), _e5668);
                        switch bitcast<i32>(select(select(type_9().member, 2u, _e5612), select(select(type_9().member, 0u, _e5642), select(select(type_9().member, 2u, _e5650), 1u, _e5657), _e5664), _e5668)) {
                            case 0: {
                                phi_9032_ = type_31(0u, 0u, array<u32, 2>(0u, 0u), false);
                                break;
                            }
                            case 1: {
                                if (_e5670 == 0u) {
                                    phi_9026_ = array<u32, 2>(0u, 0u);
                                } else {
                                    let _e5679 = select((bitcast<u32>(31i) - firstLeadingBit(_e5670)), 32u, (_e5670 == 0u));
                                    let _e5684 = ((_e5670 << bitcast<u32>((_e5679 & 31u))) << bitcast<u32>(1i));
                                    phi_9026_ = array<u32, 2>((_e5684 << bitcast<u32>(20i)), (((1023u - _e5679) << bitcast<u32>(20i)) | (_e5684 >> bitcast<u32>(12i))));
                                }
                                let _e5695 = phi_9026_;
                                phi_9032_ = type_31(0u, select(0u, 1u, (_e5670 > _e1311)), _e5695, true);
                                break;
                            }
                            case 2: {
                                phi_9032_ = type_31(1u, 0u, array<u32, 2>(0u, 0u), true);
                                break;
                            }
                            default: {
                                phi_9032_ = type_31();
                                break;
                            }
                        }
                        let _e5698 = phi_9032_;
                        phi_9039_ = _e5698;
                        phi_9040_ = select(true, false, (_e5698.member == 0u));
                    } else {
                        phi_9039_ = type_31();
                        phi_9040_ = true;
                    }
                    let _e5703 = phi_9039_;
                    let _e5705 = phi_9040_;
                    phi_9041_ = _e5703;
                    phi_9042_ = _e5705;
                } else {
                    phi_9041_ = type_31();
                    phi_9042_ = true;
                }
                let _e5707 = phi_9041_;
                let _e5709 = phi_9042_;
                if _e5709 {
                    let _e5711 = params.member.member.member_11;
                    let _e5713 = params.member.member.member_12;
                    let _e5715 = params.member.member.member_13;
                    let _e5717 = params.member.member.member_13;
                    let _e5723 = select(_e538.member[0][0], -(_e538.member[0][0]), (_e538.member[0][0] < 0f));
                    let _e5727 = select(_e538.member[0][1], -(_e538.member[0][1]), (_e538.member[0][1] < 0f));
                    let _e5729 = select(_e5727, _e5723, (_e5723 > _e5727));
                    let _e5733 = select(_e538.member[0][2], -(_e538.member[0][2]), (_e538.member[0][2] < 0f));
                    let _e5735 = select(_e5733, _e5729, (_e5729 > _e5733));
                    let _e5741 = select(_e538.member[1][0], -(_e538.member[1][0]), (_e538.member[1][0] < 0f));
                    let _e5745 = select(_e538.member[1][1], -(_e538.member[1][1]), (_e538.member[1][1] < 0f));
                    let _e5747 = select(_e5745, _e5741, (_e5741 > _e5745));
                    let _e5751 = select(_e538.member[1][2], -(_e538.member[1][2]), (_e538.member[1][2] < 0f));
                    let _e5753 = select(_e5751, _e5747, (_e5747 > _e5751));
                    let _e5757 = (select(_e5753, _e5735, (_e5735 > _e5753)) + _e538.member_3);
                    let _e5763 = select(_e538.member_1[0][0], -(_e538.member_1[0][0]), (_e538.member_1[0][0] < 0f));
                    let _e5767 = select(_e538.member_1[0][1], -(_e538.member_1[0][1]), (_e538.member_1[0][1] < 0f));
                    let _e5769 = select(_e5767, _e5763, (_e5763 > _e5767));
                    let _e5773 = select(_e538.member_1[0][2], -(_e538.member_1[0][2]), (_e538.member_1[0][2] < 0f));
                    let _e5775 = select(_e5773, _e5769, (_e5769 > _e5773));
                    let _e5781 = select(_e538.member_1[1][0], -(_e538.member_1[1][0]), (_e538.member_1[1][0] < 0f));
                    let _e5785 = select(_e538.member_1[1][1], -(_e538.member_1[1][1]), (_e538.member_1[1][1] < 0f));
                    let _e5787 = select(_e5785, _e5781, (_e5781 > _e5785));
                    let _e5791 = select(_e538.member_1[1][2], -(_e538.member_1[1][2]), (_e538.member_1[1][2] < 0f));
                    let _e5793 = select(_e5791, _e5787, (_e5787 > _e5791));
                    let _e5797 = (select(_e5793, _e5775, (_e5775 > _e5793)) + _e538.member_3);
                    let _e5803 = select(_e538.member_2[0][0], -(_e538.member_2[0][0]), (_e538.member_2[0][0] < 0f));
                    let _e5807 = select(_e538.member_2[0][1], -(_e538.member_2[0][1]), (_e538.member_2[0][1] < 0f));
                    let _e5809 = select(_e5807, _e5803, (_e5803 > _e5807));
                    let _e5813 = select(_e538.member_2[0][2], -(_e538.member_2[0][2]), (_e538.member_2[0][2] < 0f));
                    let _e5815 = select(_e5813, _e5809, (_e5809 > _e5813));
                    let _e5821 = select(_e538.member_2[1][0], -(_e538.member_2[1][0]), (_e538.member_2[1][0] < 0f));
                    let _e5825 = select(_e538.member_2[1][1], -(_e538.member_2[1][1]), (_e538.member_2[1][1] < 0f));
                    let _e5827 = select(_e5825, _e5821, (_e5821 > _e5825));
                    let _e5831 = select(_e538.member_2[1][2], -(_e538.member_2[1][2]), (_e538.member_2[1][2] < 0f));
                    let _e5833 = select(_e5831, _e5827, (_e5827 > _e5831));
                    let _e5837 = (select(_e5833, _e5815, (_e5815 > _e5833)) + _e538.member_3);
                    let _e5839 = select(_e5797, _e5757, (_e5757 > _e5797));
                    let _e5841 = select(_e5837, _e5839, (_e5839 > _e5837));
                    if (_e5841 <= 65536f) {
                        phi_9313_ = (_e5841 >= (1f / 65536f));
                    } else {
                        phi_9313_ = false;
                    }
                    let _e5846 = phi_9313_;
                    if _e5846 {
                        phi_9411_ = type_29();
                        phi_9412_ = true;
                    } else {
                        if (_e5841 >= 0.000000000000000000000000000000000000011754944f) {
                            if ((bitcast<u32>(_e5841) & 2139095040u) != 2139095040u) {
                                let _e5853 = (2130706432u - (bitcast<u32>(_e5841) & 2139095040u));
                                let _e5856 = bitcast<f32>(select(8388608u, _e5853, (_e5853 > 8388608u)));
                                phi_9407_ = type_29(type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e538.member[0][0] * _e5856), (_e538.member[0][1] * _e5856), (_e538.member[0][2] * _e5856)), array<f32, 3>((_e538.member[1][0] * _e5856), (_e538.member[1][1] * _e5856), (_e538.member[1][2] * _e5856))), array<array<f32, 3>, 2>(array<f32, 3>((_e538.member_1[0][0] * _e5856), (_e538.member_1[0][1] * _e5856), (_e538.member_1[0][2] * _e5856)), array<f32, 3>((_e538.member_1[1][0] * _e5856), (_e538.member_1[1][1] * _e5856), (_e538.member_1[1][2] * _e5856))), array<array<f32, 3>, 2>(array<f32, 3>((_e538.member_2[0][0] * _e5856), (_e538.member_2[0][1] * _e5856), (_e538.member_2[0][2] * _e5856)), array<f32, 3>((_e538.member_2[1][0] * _e5856), (_e538.member_2[1][1] * _e5856), (_e538.member_2[1][2] * _e5856))), ((_e538.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e5856)), (0f * _e5856));
                                phi_9408_ = false;
                            } else {
                                phi_9407_ = type_29();
                                phi_9408_ = true;
                            }
                            let _e5922 = phi_9407_;
                            let _e5924 = phi_9408_;
                            phi_9409_ = _e5922;
                            phi_9410_ = _e5924;
                        } else {
                            phi_9409_ = type_29();
                            phi_9410_ = true;
                        }
                        let _e5926 = phi_9409_;
                        let _e5928 = phi_9410_;
                        phi_9411_ = _e5926;
                        phi_9412_ = _e5928;
                    }
                    let _e5930 = phi_9411_;
                    let _e5932 = phi_9412_;
                    if _e5932 {
                        phi_9417_ = type_29(_e538, 0f);
                    } else {
                        phi_9417_ = _e5930;
                    }
                    let _e5935 = phi_9417_;
                    local_7 = type_27(array<array<f32, 3>, 2>(array<f32, 3>(_e5935.member.member[0][0], _e5935.member.member[0][1], _e5935.member.member[0][2]), array<f32, 3>(_e5935.member.member[1][0], _e5935.member.member[1][1], _e5935.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e5935.member.member_1[0][0], _e5935.member.member_1[0][1], _e5935.member.member_1[0][2]), array<f32, 3>(_e5935.member.member_1[1][0], _e5935.member.member_1[1][1], _e5935.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e5935.member.member_2[0][0], _e5935.member.member_2[0][1], _e5935.member.member_2[0][2]), array<f32, 3>(_e5935.member.member_2[1][0], _e5935.member.member_2[1][1], _e5935.member.member_2[1][2])), _e5935.member.member_3);
                    let _e5977 = local_7.member_1[0u];
                    let _e5983 = local_7.member_2[0u];
                    let _e5989 = ((_e5977[1] * _e5983[2]) - (_e5977[2] * _e5983[1]));
                    let _e5992 = ((_e5977[2] * _e5983[0]) - (_e5977[0] * _e5983[2]));
                    let _e5995 = ((_e5977[0] * _e5983[1]) - (_e5977[1] * _e5983[0]));
                    let _e5998 = local_7.member_1[1u];
                    let _e6004 = local_7.member_2[1u];
                    let _e6010 = ((_e5998[1] * _e6004[2]) - (_e5998[2] * _e6004[1]));
                    let _e6013 = ((_e5998[2] * _e6004[0]) - (_e5998[0] * _e6004[2]));
                    let _e6016 = ((_e5998[0] * _e6004[1]) - (_e5998[1] * _e6004[0]));
                    let _e6019 = local_7.member_1[0u];
                    let _e6025 = local_7.member_2[1u];
                    let _e6040 = local_7.member_1[1u];
                    let _e6046 = local_7.member_2[0u];
                    let _e6059 = (((_e6019[1] * _e6025[2]) - (_e6019[2] * _e6025[1])) + ((_e6040[1] * _e6046[2]) - (_e6040[2] * _e6046[1])));
                    let _e6060 = (((_e6019[2] * _e6025[0]) - (_e6019[0] * _e6025[2])) + ((_e6040[2] * _e6046[0]) - (_e6040[0] * _e6046[2])));
                    let _e6061 = (((_e6019[0] * _e6025[1]) - (_e6019[1] * _e6025[0])) + ((_e6040[0] * _e6046[1]) - (_e6040[1] * _e6046[0])));
                    let _e6064 = local_7.member[0u];
                    let _e6072 = (((_e6064[0] * _e5989) + (_e6064[1] * _e5992)) + (_e6064[2] * _e5995));
                    let _e6075 = local_7.member[1u];
                    let _e6086 = local_7.member[0u];
                    let _e6095 = ((((_e6075[0] * _e5989) + (_e6075[1] * _e5992)) + (_e6075[2] * _e5995)) + (((_e6086[0] * _e6059) + (_e6086[1] * _e6060)) + (_e6086[2] * _e6061)));
                    let _e6098 = local_7.member[0u];
                    let _e6109 = local_7.member[1u];
                    let _e6118 = ((((_e6098[0] * _e6010) + (_e6098[1] * _e6013)) + (_e6098[2] * _e6016)) + (((_e6109[0] * _e6059) + (_e6109[1] * _e6060)) + (_e6109[2] * _e6061)));
                    let _e6121 = local_7.member[1u];
                    let _e6129 = (((_e6121[0] * _e6010) + (_e6121[1] * _e6013)) + (_e6121[2] * _e6016));
                    let _e6132 = local_7.member[0u];
                    let _e6138 = select(_e6132[0], -(_e6132[0]), (_e6132[0] < 0f));
                    let _e6141 = select(_e6132[1], -(_e6132[1]), (_e6132[1] < 0f));
                    let _e6143 = select(_e6141, _e6138, (_e6138 > _e6141));
                    let _e6146 = select(_e6132[2], -(_e6132[2]), (_e6132[2] < 0f));
                    let _e6148 = select(_e6146, _e6143, (_e6143 > _e6146));
                    let _e6151 = local_7.member[1u];
                    let _e6157 = select(_e6151[0], -(_e6151[0]), (_e6151[0] < 0f));
                    let _e6160 = select(_e6151[1], -(_e6151[1]), (_e6151[1] < 0f));
                    let _e6162 = select(_e6160, _e6157, (_e6157 > _e6160));
                    let _e6165 = select(_e6151[2], -(_e6151[2]), (_e6151[2] < 0f));
                    let _e6167 = select(_e6165, _e6162, (_e6162 > _e6165));
                    let _e6171 = local_7.member_3;
                    let _e6172 = (select(_e6167, _e6148, (_e6148 > _e6167)) + _e6171);
                    let _e6175 = local_7.member_1[0u];
                    let _e6181 = select(_e6175[0], -(_e6175[0]), (_e6175[0] < 0f));
                    let _e6184 = select(_e6175[1], -(_e6175[1]), (_e6175[1] < 0f));
                    let _e6186 = select(_e6184, _e6181, (_e6181 > _e6184));
                    let _e6189 = select(_e6175[2], -(_e6175[2]), (_e6175[2] < 0f));
                    let _e6191 = select(_e6189, _e6186, (_e6186 > _e6189));
                    let _e6194 = local_7.member_1[1u];
                    let _e6200 = select(_e6194[0], -(_e6194[0]), (_e6194[0] < 0f));
                    let _e6203 = select(_e6194[1], -(_e6194[1]), (_e6194[1] < 0f));
                    let _e6205 = select(_e6203, _e6200, (_e6200 > _e6203));
                    let _e6208 = select(_e6194[2], -(_e6194[2]), (_e6194[2] < 0f));
                    let _e6210 = select(_e6208, _e6205, (_e6205 > _e6208));
                    let _e6214 = local_7.member_3;
                    let _e6215 = (select(_e6210, _e6191, (_e6191 > _e6210)) + _e6214);
                    let _e6218 = local_7.member_2[0u];
                    let _e6224 = select(_e6218[0], -(_e6218[0]), (_e6218[0] < 0f));
                    let _e6227 = select(_e6218[1], -(_e6218[1]), (_e6218[1] < 0f));
                    let _e6229 = select(_e6227, _e6224, (_e6224 > _e6227));
                    let _e6232 = select(_e6218[2], -(_e6218[2]), (_e6218[2] < 0f));
                    let _e6234 = select(_e6232, _e6229, (_e6229 > _e6232));
                    let _e6237 = local_7.member_2[1u];
                    let _e6243 = select(_e6237[0], -(_e6237[0]), (_e6237[0] < 0f));
                    let _e6246 = select(_e6237[1], -(_e6237[1]), (_e6237[1] < 0f));
                    let _e6248 = select(_e6246, _e6243, (_e6243 > _e6246));
                    let _e6251 = select(_e6237[2], -(_e6237[2]), (_e6237[2] < 0f));
                    let _e6253 = select(_e6251, _e6248, (_e6248 > _e6251));
                    let _e6257 = local_7.member_3;
                    let _e6258 = (select(_e6253, _e6234, (_e6234 > _e6253)) + _e6257);
                    let _e6260 = ((_e6215 * 8f) * _e6258);
                    let _e6267 = local_7.member_3;
                    let _e6291 = ((select(_e5989, -(_e5989), (_e5989 < 0f)) + select(_e5992, -(_e5992), (_e5992 < 0f))) + select(_e5995, -(_e5995), (_e5995 < 0f)));
                    let _e6302 = ((select(_e6010, -(_e6010), (_e6010 < 0f)) + select(_e6013, -(_e6013), (_e6013 < 0f))) + select(_e6016, -(_e6016), (_e6016 < 0f)));
                    let _e6304 = select(_e6302, _e6291, (_e6291 > _e6302));
                    let _e6316 = (((select(_e6059, -(_e6059), (_e6059 < 0f)) + select(_e6060, -(_e6060), (_e6060 < 0f))) + select(_e6061, -(_e6061), (_e6061 < 0f))) * 0.5f);
                    let _e6323 = local_7.member_3;
                    let _e6335 = (((((_e6172 * 8f) * _e6260) * (0.000000059604645f * (524f / 64f))) + ((_e6267 * 19f) * ((_e6172 * (_e6215 + _e6258)) + (_e6215 * _e6258)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6172) * ((1f + _e6215) * (1f + _e6258)))));
                    let _e6336 = (_e6072 * 3f);
                    let _e6337 = (_e6129 * 3f);
                    let _e6339 = select(_e6337, _e6336, (_e6336 < _e6337));
                    let _e6341 = select(_e6118, _e6095, (_e6095 < _e6118));
                    let _e6343 = select(_e6341, _e6339, (_e6339 < _e6341));
                    let _e6345 = select(_e6337, _e6336, (_e6336 > _e6337));
                    let _e6347 = select(_e6118, _e6095, (_e6095 > _e6118));
                    let _e6354 = -(select(_e6347, _e6345, (_e6345 > _e6347)));
                    if ((select(_e6354, _e6343, (_e6343 > _e6354)) - (_e6335 + ((0f * (((select(_e6316, _e6304, (_e6304 > _e6316)) + (_e6260 * (0.000000059604645f * 8f))) + ((_e6323 * 6f) * (_e6215 + _e6258))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6215) * (1f + _e6258))))) * (3f * 1.0001f)))) > 0f) {
                        phi_14639_ = type_30(0u, type_30().member_1);
                        phi_14640_ = type_30();
                        phi_14641_ = true;
                    } else {
                        let _e6362 = select(_e6072, -(_e6072), (_e6072 < 0f));
                        let _e6365 = select(_e6095, -(_e6095), (_e6095 < 0f));
                        let _e6367 = select(_e6365, _e6362, (_e6362 > _e6365));
                        let _e6370 = select(_e6118, -(_e6118), (_e6118 < 0f));
                        let _e6373 = select(_e6129, -(_e6129), (_e6129 < 0f));
                        let _e6375 = select(_e6373, _e6370, (_e6370 > _e6373));
                        let _e6377 = select(_e6375, _e6367, (_e6367 > _e6375));
                        let _e6378 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e6377 >= _e6378) {
                            phi_10142_ = (_e6377 <= (1f / _e6378));
                        } else {
                            phi_10142_ = false;
                        }
                        let _e6383 = phi_10142_;
                        if _e6383 {
                            phi_10154_ = (1f / _e6377);
                        } else {
                            phi_10154_ = 0f;
                        }
                        let _e6390 = phi_10154_;
                        let _e6391 = (_e5711 * 0.0625f);
                        local_5 = type_34(array<f32, 4>(_e6072, _e6095, _e6118, _e6129), ((_e6335 * 0.34f) + (_e6377 * select(2f, (0.000000059604645f * 256f), _e6383))), _e6390, select(_e6391, 0.00000000000022737368f, (0.00000000000022737368f < _e6391)));
                        let _e6398 = local_5.member[0u];
                        let _e6401 = local_5.member[1u];
                        let _e6404 = local_5.member[2u];
                        let _e6407 = local_5.member[3u];
                        let _e6414 = local_5.member_2;
                        let _e6415 = ((_e6401 - (3f * _e6398)) * _e6414);
                        let _e6417 = local_5.member_2;
                        let _e6418 = ((_e6404 - _e6401) * _e6417);
                        let _e6420 = local_5.member_2;
                        let _e6421 = (((3f * _e6407) - _e6404) * _e6420);
                        local_3[0u] = 0f;
                        local_3[1u] = 1f;
                        local_3[2u] = 1f;
                        local_3[3u] = 1f;
                        let _e6428 = ((_e6418 * _e6418) - (_e6415 * _e6421));
                        if (_e6428 > 0f) {
                            if (_e6428 <= 0.000000000000000000000000000000000000011754944f) {
                                phi_10282_ = select(0f, (0.000000000000000000106433627f * 2f), (_e6428 > 0f));
                            } else {
                                phi_10225_ = type_14(0i, 5i);
                                phi_10228_ = bitcast<f32>(((bitcast<u32>(_e6428) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e6437 = phi_10225_;
                                    let _e6439 = phi_10228_;
                                    local_96 = _e6439;
                                    if (_e6437.member < _e6437.member_1) {
                                        let _e6446 = (_e6437.member + 1i);
                                        phi_10226_ = type_14(select(_e6446, type_15().member_1, select(false, true, ((false == (_e6446 > _e6437.member)) != false))), _e6437.member_1);
                                        phi_10269_ = type_15(1u, _e6437.member);
                                    } else {
                                        phi_10226_ = _e6437;
                                        phi_10269_ = type_15(0u, type_15().member_1);
                                    }
                                    let _e6457 = phi_10226_;
                                    let _e6459 = phi_10269_;
                                    let _e6462 = (bitcast<i32>(_e6459.member) != 0i);
                                    if _e6462 {
                                        phi_10229_ = (0.5f * (_e6439 + (_e6428 / _e6439)));
                                    } else {
                                        phi_10229_ = f32();
                                    }
                                    let _e6467 = phi_10229_;
                                    continue;
                                    continuing {
                                        phi_10225_ = _e6457;
                                        phi_10228_ = _e6467;
                                        break if !(_e6462);
                                    }
                                }
                                let _e6472 = local_96;
                                phi_10282_ = (_e6472 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e6478 = phi_10282_;
                            let _e6483 = -((_e6418 + select(_e6478, -(_e6478), (_e6418 < 0f))));
                            local_4[0u] = (_e6483 / (_e6483 + _e6421));
                            local_4[1u] = (_e6415 / (_e6415 + _e6483));
                            let _e6492 = local_4[1u];
                            let _e6493 = local_4[0u];
                            if (_e6492 < _e6493) {
                                let _e6496 = local_4[1u];
                                let _e6498 = local_4[0u];
                                local_4[0u] = _e6496;
                                local_4[1u] = _e6498;
                            }
                            phi_10313_ = type_9(0u, 2u);
                            phi_10316_ = 1u;
                            loop {
                                let _e6502 = phi_10313_;
                                let _e6504 = phi_10316_;
                                local_137 = _e6504;
                                let _e6507 = (_e6502.member < _e6502.member_1);
                                let _e6518 = select(type_9().member_1, _e6502.member, _e6507);
                                let _e6520 = (bitcast<i32>(select(0u, 1u, _e6507)) != 0i);
                                if _e6520 {
                                    let _e6522 = local_4[_e6518];
                                    if (_e6522 > 0f) {
                                        let _e6525 = local_4[_e6518];
                                        if (_e6525 < 1f) {
                                            let _e6528 = local_4[_e6518];
                                            local_3[_e6504] = _e6528;
                                            phi_10383_ = (_e6504 + 1u);
                                        } else {
                                            phi_10383_ = _e6504;
                                        }
                                        let _e6532 = phi_10383_;
                                        phi_10384_ = _e6532;
                                    } else {
                                        phi_10384_ = _e6504;
                                    }
                                    let _e6534 = phi_10384_;
                                    phi_10317_ = _e6534;
                                } else {
                                    phi_10317_ = u32();
                                }
                                let _e6536 = phi_10317_;
                                continue;
                                continuing {
                                    phi_10313_ = type_9(select(_e6502.member, (_e6502.member + 1u), _e6507), select(_e6502.member_1, _e6502.member_1, _e6507));
                                    phi_10316_ = _e6536;
                                    break if !(_e6520);
                                }
                            }
                            let _e9428 = local_137;
                            phi_10385_ = _e9428;
                        } else {
                            phi_10385_ = 1u;
                        }
                        let _e6539 = phi_10385_;
                        local_3[_e6539] = 1f;
                        let _e6541 = local_3;
                        local_6 = _e6541;
                        let _e6542 = (_e5711 * 0.99f);
                        let _e6543 = (1f - _e5713);
                        let _e6546 = local_5.member[0u];
                        let _e6549 = local_5.member[1u];
                        let _e6552 = local_5.member[2u];
                        let _e6555 = local_5.member[3u];
                        let _e6566 = ((((_e6546 * _e6543) + (_e6549 * _e5713)) * (_e6543 * _e6543)) + (((_e6552 * _e6543) + (_e6555 * _e5713)) * (_e5713 * _e5713)));
                        let _e6571 = local_5.member_1;
                        phi_10441_ = type_9(select(1u, 0u, !((select(_e6566, -(_e6566), (_e6566 < 0f)) > _e6571))), (_e6539 + 1u));
                        loop {
                            let _e6578 = phi_10441_;
                            let _e6581 = (_e6578.member < _e6578.member_1);
                            let _e6592 = select(type_9().member_1, _e6578.member, _e6581);
                            if (bitcast<i32>(select(0u, 1u, _e6581)) != 0i) {
                                if (_e6592 > 0u) {
                                    let _e6599 = local_6[(_e6592 - 1u)];
                                    let _e6601 = select(_e5713, _e6599, (_e6599 > _e5713));
                                    let _e6603 = local_6[_e6592];
                                    let _e6605 = select(_e5715, _e6603, (_e6603 < _e5715));
                                    if (_e6601 <= _e6605) {
                                        let _e6607 = function_6((&local_5), _e5717, _e6601, _e6605);
                                        if _e6607 {
                                            phi_11844_ = type_45();
                                            phi_11845_ = bool();
                                            phi_11846_ = type_45();
                                            phi_11847_ = false;
                                            phi_11848_ = false;
                                            phi_11849_ = false;
                                            phi_11850_ = false;
                                        } else {
                                            let _e6608 = (1f - _e6601);
                                            let _e6611 = local_5.member[0u];
                                            let _e6614 = local_5.member[1u];
                                            let _e6617 = local_5.member[2u];
                                            let _e6620 = local_5.member[3u];
                                            let _e6631 = ((((_e6611 * _e6608) + (_e6614 * _e6601)) * (_e6608 * _e6608)) + (((_e6617 * _e6608) + (_e6620 * _e6601)) * (_e6601 * _e6601)));
                                            let _e6632 = (1f - _e6605);
                                            let _e6635 = local_5.member[0u];
                                            let _e6638 = local_5.member[1u];
                                            let _e6641 = local_5.member[2u];
                                            let _e6644 = local_5.member[3u];
                                            let _e6655 = ((((_e6635 * _e6632) + (_e6638 * _e6605)) * (_e6632 * _e6632)) + (((_e6641 * _e6632) + (_e6644 * _e6605)) * (_e6605 * _e6605)));
                                            let _e6660 = local_5.member_1;
                                            let _e6661 = (select(_e6631, -(_e6631), (_e6631 < 0f)) > _e6660);
                                            let _e6666 = local_5.member_1;
                                            let _e6667 = (select(_e6655, -(_e6655), (_e6655 < 0f)) > _e6666);
                                            let _e6675 = select(select(bool(), select(bool(), ((_e6631 > 0f) != (_e6655 > 0f)), _e6667), _e6661), false, select(true, select(true, false, _e6667), _e6661));
                                            if _e6661 {
                                                if _e6667 {
                                                    phi_10597_ = type_45(select(1f, type_45().member, _e6675), select(0f, type_45().member_1, _e6675), select(_e6675, type_45().member_2, _e6675));
                                                    phi_10598_ = _e6675;
                                                } else {
                                                    phi_10597_ = type_45();
                                                    phi_10598_ = true;
                                                }
                                                let _e6684 = phi_10597_;
                                                let _e6686 = phi_10598_;
                                                phi_10599_ = _e6684;
                                                phi_10600_ = _e6686;
                                            } else {
                                                phi_10599_ = type_45();
                                                phi_10600_ = true;
                                            }
                                            let _e6688 = phi_10599_;
                                            let _e6690 = phi_10600_;
                                            if _e6690 {
                                                if _e6661 {
                                                    let _e6692 = select(1f, -1f, (_e6631 < 0f));
                                                    let _e6694 = local_5.member_3;
                                                    let _e6697 = local_5.member[0u];
                                                    let _e6700 = local_5.member[1u];
                                                    let _e6703 = local_5.member[2u];
                                                    let _e6706 = local_5.member[3u];
                                                    let _e6709 = (_e6703 - _e6700);
                                                    phi_10631_ = type_9(0u, 64u);
                                                    phi_10634_ = _e6605;
                                                    phi_10636_ = _e6601;
                                                    phi_10638_ = (0.5f * (_e6601 + _e6605));
                                                    loop {
                                                        let _e6715 = phi_10631_;
                                                        let _e6717 = phi_10634_;
                                                        let _e6719 = phi_10636_;
                                                        let _e6721 = phi_10638_;
                                                        local_99 = _e6719;
                                                        let _e6724 = (_e6715.member < _e6715.member_1);
                                                        if (bitcast<i32>(select(0u, 1u, _e6724)) != 0i) {
                                                            let _e6736 = (1f - _e6721);
                                                            let _e6739 = local_5.member[0u];
                                                            let _e6742 = local_5.member[1u];
                                                            let _e6745 = local_5.member[2u];
                                                            let _e6748 = local_5.member[3u];
                                                            let _e6762 = local_5.member_1;
                                                            let _e6763 = ((_e6692 * ((((_e6739 * _e6736) + (_e6742 * _e6721)) * (_e6736 * _e6736)) + (((_e6745 * _e6736) + (_e6748 * _e6721)) * (_e6721 * _e6721)))) - _e6762);
                                                            let _e6764 = (_e6763 > 0f);
                                                            let _e6765 = select(_e6721, _e6717, _e6764);
                                                            let _e6766 = select(_e6719, _e6721, _e6764);
                                                            let _e6768 = ((_e6765 - _e6766) > _e6694);
                                                            if _e6768 {
                                                                let _e6769 = (1f - _e6721);
                                                                let _e6781 = (-(_e6763) / (_e6692 * (((((_e6700 - (3f * _e6697)) * _e6769) + (_e6709 * _e6721)) * _e6769) + (((_e6709 * _e6769) + (((3f * _e6706) - _e6703) * _e6721)) * _e6721))));
                                                                let _e6788 = ((_e6721 + _e6781) + select(-((0.5f * _e6694)), (0.5f * _e6694), (_e6763 > 0f)));
                                                                if (_e6788 > _e6766) {
                                                                    phi_10748_ = select(true, select(true, false, (select(_e6781, -(_e6781), (_e6781 < 0f)) < (0.5f * (_e6765 - _e6766)))), (_e6788 < _e6765));
                                                                } else {
                                                                    phi_10748_ = true;
                                                                }
                                                                let _e6800 = phi_10748_;
                                                                phi_10755_ = select(_e6788, (0.5f * (_e6766 + _e6765)), _e6800);
                                                                phi_10756_ = false;
                                                            } else {
                                                                phi_10755_ = f32();
                                                                phi_10756_ = true;
                                                            }
                                                            let _e6805 = phi_10755_;
                                                            let _e6807 = phi_10756_;
                                                            phi_10635_ = _e6765;
                                                            phi_10637_ = _e6766;
                                                            phi_10639_ = _e6805;
                                                            phi_10757_ = _e6766;
                                                            phi_10758_ = _e6768;
                                                            phi_10759_ = _e6807;
                                                        } else {
                                                            phi_10635_ = f32();
                                                            phi_10637_ = f32();
                                                            phi_10639_ = f32();
                                                            phi_10757_ = f32();
                                                            phi_10758_ = false;
                                                            phi_10759_ = false;
                                                        }
                                                        let _e6809 = phi_10635_;
                                                        let _e6811 = phi_10637_;
                                                        let _e6813 = phi_10639_;
                                                        let _e6815 = phi_10757_;
                                                        let _e6817 = phi_10758_;
                                                        let _e6819 = phi_10759_;
                                                        local_97 = _e6819;
                                                        local_98 = _e6815;
                                                        continue;
                                                        continuing {
                                                            phi_10631_ = type_9(select(_e6715.member, (_e6715.member + 1u), _e6724), select(_e6715.member_1, _e6715.member_1, _e6724));
                                                            phi_10634_ = _e6809;
                                                            phi_10636_ = _e6811;
                                                            phi_10638_ = _e6813;
                                                            break if !(_e6817);
                                                        }
                                                    }
                                                    let _e6822 = local_97;
                                                    let _e6824 = local_98;
                                                    let _e6826 = local_99;
                                                    phi_10764_ = select(_e6826, _e6824, _e6822);
                                                } else {
                                                    phi_10764_ = _e6601;
                                                }
                                                let _e6829 = phi_10764_;
                                                if _e6667 {
                                                    let _e6833 = local_5.member_3;
                                                    let _e6835 = local_5.member_3;
                                                    phi_10780_ = type_9(0u, 64u);
                                                    phi_10783_ = (_e6833 + _e6835);
                                                    loop {
                                                        let _e6838 = phi_10780_;
                                                        let _e6840 = phi_10783_;
                                                        let _e6843 = (_e6838.member < _e6838.member_1);
                                                        if (bitcast<i32>(select(0u, 1u, _e6843)) != 0i) {
                                                            let _e6855 = (_e6829 + _e6840);
                                                            if (_e6855 < _e6605) {
                                                                let _e6857 = (1f - _e6855);
                                                                let _e6860 = local_5.member[0u];
                                                                let _e6863 = local_5.member[1u];
                                                                let _e6866 = local_5.member[2u];
                                                                let _e6869 = local_5.member[3u];
                                                                let _e6883 = local_5.member_1;
                                                                let _e6884 = ((select(1f, -1f, (_e6655 < 0f)) * ((((_e6860 * _e6857) + (_e6863 * _e6855)) * (_e6857 * _e6857)) + (((_e6866 * _e6857) + (_e6869 * _e6855)) * (_e6855 * _e6855)))) > _e6883);
                                                                phi_10848_ = select((_e6840 + _e6840), f32(), _e6884);
                                                                phi_10849_ = select(true, false, _e6884);
                                                                phi_10850_ = _e6884;
                                                                phi_10851_ = false;
                                                            } else {
                                                                phi_10848_ = f32();
                                                                phi_10849_ = false;
                                                                phi_10850_ = false;
                                                                phi_10851_ = true;
                                                            }
                                                            let _e6889 = phi_10848_;
                                                            let _e6891 = phi_10849_;
                                                            let _e6893 = phi_10850_;
                                                            let _e6895 = phi_10851_;
                                                            phi_10852_ = _e6855;
                                                            phi_10784_ = _e6889;
                                                            phi_10853_ = _e6891;
                                                            phi_10854_ = _e6893;
                                                            phi_10855_ = _e6895;
                                                            phi_10856_ = false;
                                                        } else {
                                                            phi_10852_ = f32();
                                                            phi_10784_ = f32();
                                                            phi_10853_ = false;
                                                            phi_10854_ = false;
                                                            phi_10855_ = false;
                                                            phi_10856_ = true;
                                                        }
                                                        let _e6897 = phi_10852_;
                                                        let _e6899 = phi_10784_;
                                                        let _e6901 = phi_10853_;
                                                        let _e6903 = phi_10854_;
                                                        let _e6905 = phi_10855_;
                                                        let _e6907 = phi_10856_;
                                                        local_100 = _e6903;
                                                        local_101 = _e6905;
                                                        local_102 = _e6903;
                                                        local_103 = _e6907;
                                                        local_104 = _e6897;
                                                        continue;
                                                        continuing {
                                                            phi_10780_ = type_9(select(_e6838.member, (_e6838.member + 1u), _e6843), select(_e6838.member_1, _e6838.member_1, _e6843));
                                                            phi_10783_ = _e6899;
                                                            break if !(_e6901);
                                                        }
                                                    }
                                                    let _e6910 = local_100;
                                                    let _e6912 = local_101;
                                                    let _e6915 = local_102;
                                                    let _e6917 = local_103;
                                                    let _e6921 = local_104;
                                                    phi_10870_ = select(_e6921, _e6605, select(select(_e6917, false, _e6915), true, select(_e6912, false, _e6910)));
                                                } else {
                                                    phi_10870_ = _e6605;
                                                }
                                                let _e6924 = phi_10870_;
                                                phi_10872_ = type_45(_e6829, _e6924, _e6675);
                                            } else {
                                                phi_10872_ = _e6688;
                                            }
                                            let _e6927 = phi_10872_;
                                            if (_e6927.member > _e6927.member_1) {
                                                phi_11839_ = bool();
                                                phi_11840_ = true;
                                                phi_11841_ = false;
                                                phi_11842_ = false;
                                                phi_11843_ = false;
                                            } else {
                                                let _e6932 = (_e6927.member > _e5717);
                                                if _e6932 {
                                                    phi_11835_ = bool();
                                                    phi_11836_ = false;
                                                    phi_11837_ = false;
                                                    phi_11838_ = false;
                                                } else {
                                                    let _e6936 = ((_e6927.member_1 - _e6927.member) * 0.5f);
                                                    let _e6937 = (_e6927.member + _e6936);
                                                    let _e6939 = (_e6936 + (0.000000059604645f * 4f));
                                                    let _e6941 = local_7.member_3;
                                                    let _e6944 = local_7.member[0u];
                                                    let _e6950 = select(_e6944[0], -(_e6944[0]), (_e6944[0] < 0f));
                                                    let _e6953 = select(_e6944[1], -(_e6944[1]), (_e6944[1] < 0f));
                                                    let _e6955 = select(_e6953, _e6950, (_e6950 > _e6953));
                                                    let _e6958 = select(_e6944[2], -(_e6944[2]), (_e6944[2] < 0f));
                                                    let _e6960 = select(_e6958, _e6955, (_e6955 > _e6958));
                                                    let _e6962 = local_7.member[1u];
                                                    let _e6968 = select(_e6962[0], -(_e6962[0]), (_e6962[0] < 0f));
                                                    let _e6971 = select(_e6962[1], -(_e6962[1]), (_e6962[1] < 0f));
                                                    let _e6973 = select(_e6971, _e6968, (_e6968 > _e6971));
                                                    let _e6976 = select(_e6962[2], -(_e6962[2]), (_e6962[2] < 0f));
                                                    let _e6978 = select(_e6976, _e6973, (_e6973 > _e6976));
                                                    let _e6983 = local_7.member[0u];
                                                    let _e6988 = local_7.member[1u];
                                                    let _e6998 = (_e6983[0] + ((_e6988[0] - _e6983[0]) * _e6937));
                                                    let _e6999 = (_e6983[1] + ((_e6988[1] - _e6983[1]) * _e6937));
                                                    let _e7000 = (_e6983[2] + ((_e6988[2] - _e6983[2]) * _e6937));
                                                    let _e7002 = local_7.member[1u];
                                                    let _e7007 = local_7.member[0u];
                                                    let _e7011 = (_e7002[0] - _e7007[0]);
                                                    let _e7012 = (_e7002[1] - _e7007[1]);
                                                    let _e7013 = (_e7002[2] - _e7007[2]);
                                                    let _e7016 = select(_e7011, -(_e7011), (_e7011 < 0f));
                                                    let _e7019 = select(_e7012, -(_e7012), (_e7012 < 0f));
                                                    let _e7021 = select(_e7019, _e7016, (_e7016 > _e7019));
                                                    let _e7024 = select(_e7013, -(_e7013), (_e7013 < 0f));
                                                    let _e7032 = ((((_e6939 * select(_e7024, _e7021, (_e7021 > _e7024))) * 1.01f) + ((select(_e6978, _e6960, (_e6960 > _e6978)) + _e6941) * (0.000000059604645f * 8f))) + _e6941);
                                                    let _e7035 = select(_e6998, -(_e6998), (_e6998 < 0f));
                                                    let _e7038 = select(_e6999, -(_e6999), (_e6999 < 0f));
                                                    let _e7040 = select(_e7038, _e7035, (_e7035 > _e7038));
                                                    let _e7043 = select(_e7000, -(_e7000), (_e7000 < 0f));
                                                    let _e7046 = (select(_e7043, _e7040, (_e7040 > _e7043)) + _e7032);
                                                    let _e7049 = local_7.member_3;
                                                    let _e7051 = local_7.member_1[0u];
                                                    let _e7057 = select(_e7051[0], -(_e7051[0]), (_e7051[0] < 0f));
                                                    let _e7060 = select(_e7051[1], -(_e7051[1]), (_e7051[1] < 0f));
                                                    let _e7062 = select(_e7060, _e7057, (_e7057 > _e7060));
                                                    let _e7065 = select(_e7051[2], -(_e7051[2]), (_e7051[2] < 0f));
                                                    let _e7067 = select(_e7065, _e7062, (_e7062 > _e7065));
                                                    let _e7069 = local_7.member_1[1u];
                                                    let _e7075 = select(_e7069[0], -(_e7069[0]), (_e7069[0] < 0f));
                                                    let _e7078 = select(_e7069[1], -(_e7069[1]), (_e7069[1] < 0f));
                                                    let _e7080 = select(_e7078, _e7075, (_e7075 > _e7078));
                                                    let _e7083 = select(_e7069[2], -(_e7069[2]), (_e7069[2] < 0f));
                                                    let _e7085 = select(_e7083, _e7080, (_e7080 > _e7083));
                                                    let _e7090 = local_7.member_1[0u];
                                                    let _e7095 = local_7.member_1[1u];
                                                    let _e7105 = (_e7090[0] + ((_e7095[0] - _e7090[0]) * _e6937));
                                                    let _e7106 = (_e7090[1] + ((_e7095[1] - _e7090[1]) * _e6937));
                                                    let _e7107 = (_e7090[2] + ((_e7095[2] - _e7090[2]) * _e6937));
                                                    let _e7109 = local_7.member_1[1u];
                                                    let _e7114 = local_7.member_1[0u];
                                                    let _e7118 = (_e7109[0] - _e7114[0]);
                                                    let _e7119 = (_e7109[1] - _e7114[1]);
                                                    let _e7120 = (_e7109[2] - _e7114[2]);
                                                    let _e7123 = select(_e7118, -(_e7118), (_e7118 < 0f));
                                                    let _e7126 = select(_e7119, -(_e7119), (_e7119 < 0f));
                                                    let _e7128 = select(_e7126, _e7123, (_e7123 > _e7126));
                                                    let _e7131 = select(_e7120, -(_e7120), (_e7120 < 0f));
                                                    let _e7139 = ((((_e6939 * select(_e7131, _e7128, (_e7128 > _e7131))) * 1.01f) + ((select(_e7085, _e7067, (_e7067 > _e7085)) + _e7049) * (0.000000059604645f * 8f))) + _e7049);
                                                    let _e7142 = select(_e7105, -(_e7105), (_e7105 < 0f));
                                                    let _e7145 = select(_e7106, -(_e7106), (_e7106 < 0f));
                                                    let _e7147 = select(_e7145, _e7142, (_e7142 > _e7145));
                                                    let _e7150 = select(_e7107, -(_e7107), (_e7107 < 0f));
                                                    let _e7153 = (select(_e7150, _e7147, (_e7147 > _e7150)) + _e7139);
                                                    let _e7156 = local_7.member_3;
                                                    let _e7158 = local_7.member_2[0u];
                                                    let _e7164 = select(_e7158[0], -(_e7158[0]), (_e7158[0] < 0f));
                                                    let _e7167 = select(_e7158[1], -(_e7158[1]), (_e7158[1] < 0f));
                                                    let _e7169 = select(_e7167, _e7164, (_e7164 > _e7167));
                                                    let _e7172 = select(_e7158[2], -(_e7158[2]), (_e7158[2] < 0f));
                                                    let _e7174 = select(_e7172, _e7169, (_e7169 > _e7172));
                                                    let _e7176 = local_7.member_2[1u];
                                                    let _e7182 = select(_e7176[0], -(_e7176[0]), (_e7176[0] < 0f));
                                                    let _e7185 = select(_e7176[1], -(_e7176[1]), (_e7176[1] < 0f));
                                                    let _e7187 = select(_e7185, _e7182, (_e7182 > _e7185));
                                                    let _e7190 = select(_e7176[2], -(_e7176[2]), (_e7176[2] < 0f));
                                                    let _e7192 = select(_e7190, _e7187, (_e7187 > _e7190));
                                                    let _e7197 = local_7.member_2[0u];
                                                    let _e7202 = local_7.member_2[1u];
                                                    let _e7212 = (_e7197[0] + ((_e7202[0] - _e7197[0]) * _e6937));
                                                    let _e7213 = (_e7197[1] + ((_e7202[1] - _e7197[1]) * _e6937));
                                                    let _e7214 = (_e7197[2] + ((_e7202[2] - _e7197[2]) * _e6937));
                                                    let _e7216 = local_7.member_2[1u];
                                                    let _e7221 = local_7.member_2[0u];
                                                    let _e7225 = (_e7216[0] - _e7221[0]);
                                                    let _e7226 = (_e7216[1] - _e7221[1]);
                                                    let _e7227 = (_e7216[2] - _e7221[2]);
                                                    let _e7230 = select(_e7225, -(_e7225), (_e7225 < 0f));
                                                    let _e7233 = select(_e7226, -(_e7226), (_e7226 < 0f));
                                                    let _e7235 = select(_e7233, _e7230, (_e7230 > _e7233));
                                                    let _e7238 = select(_e7227, -(_e7227), (_e7227 < 0f));
                                                    let _e7246 = ((((_e6939 * select(_e7238, _e7235, (_e7235 > _e7238))) * 1.01f) + ((select(_e7192, _e7174, (_e7174 > _e7192)) + _e7156) * (0.000000059604645f * 8f))) + _e7156);
                                                    let _e7249 = select(_e7212, -(_e7212), (_e7212 < 0f));
                                                    let _e7252 = select(_e7213, -(_e7213), (_e7213 < 0f));
                                                    let _e7254 = select(_e7252, _e7249, (_e7249 > _e7252));
                                                    let _e7257 = select(_e7214, -(_e7214), (_e7214 < 0f));
                                                    let _e7260 = (select(_e7257, _e7254, (_e7254 > _e7257)) + _e7246);
                                                    let _e7263 = ((_e7106 * _e7214) - (_e7107 * _e7213));
                                                    let _e7266 = ((_e7107 * _e7212) - (_e7105 * _e7214));
                                                    let _e7269 = ((_e7105 * _e7213) - (_e7106 * _e7212));
                                                    let _e7284 = select(false, (select(_e7263, -(_e7263), (_e7263 < 0f)) > select(_e7269, -(_e7269), (_e7269 < 0f))), (select(_e7263, -(_e7263), (_e7263 < 0f)) > select(_e7266, -(_e7266), (_e7266 < 0f))));
                                                    let _e7299 = select((select(_e7266, -(_e7266), (_e7266 < 0f)) > select(_e7269, -(_e7269), (_e7269 < 0f))), false, (select(_e7263, -(_e7263), (_e7263 < 0f)) > select(_e7266, -(_e7266), (_e7266 < 0f))));
                                                    let _e7302 = select(select(_e6998, _e6999, _e7284), _e7000, _e7299);
                                                    let _e7303 = select(select(_e6999, _e7000, _e7284), _e6998, _e7299);
                                                    let _e7306 = select(select(_e7105, _e7106, _e7284), _e7107, _e7299);
                                                    let _e7307 = select(select(_e7106, _e7107, _e7284), _e7105, _e7299);
                                                    let _e7310 = select(select(_e7212, _e7213, _e7284), _e7214, _e7299);
                                                    let _e7311 = select(select(_e7213, _e7214, _e7284), _e7212, _e7299);
                                                    let _e7314 = ((_e7306 * _e7311) - (_e7307 * _e7310));
                                                    let _e7330 = (((((_e7139 * _e7260) + (_e7153 * _e7246)) * 2.01f) + (((_e7153 * 2f) * (_e7260 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e7153) * (1f + _e7260))));
                                                    if (select(_e7314, -(_e7314), (_e7314 < 0f)) > _e7330) {
                                                        let _e7336 = select(1f, -1f, (_e7314 < 0f));
                                                        let _e7355 = (((((_e7032 * _e7260) + (_e7046 * _e7246)) * 2.01f) + (((_e7046 * 2f) * (_e7260 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e7046) * (1f + _e7260))));
                                                        let _e7374 = (((((_e7139 * _e7046) + (_e7153 * _e7032)) * 2.01f) + (((_e7153 * 2f) * (_e7046 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e7153) * (1f + _e7046))));
                                                        let _e7375 = (_e7314 * _e7336);
                                                        let _e7376 = (((_e7302 * _e7311) - (_e7303 * _e7310)) * _e7336);
                                                        let _e7377 = (((_e7306 * _e7303) - (_e7307 * _e7302)) * _e7336);
                                                        let _e7390 = (((select(_e7375, -(_e7375), (_e7375 < 0f)) + select(_e7376, -(_e7376), (_e7376 < 0f))) + select(_e7377, -(_e7377), (_e7377 < 0f))) * (0.000000059604645f * 4f));
                                                        if (_e282.member != 0u) {
                                                            phi_11709_ = array<type_16, 4>(type_16(_e7376, _e7355), type_16(_e7377, _e7374), type_16((_e7375 - _e7376), ((_e7330 + _e7355) + _e7390)), type_16((_e7375 - _e7377), ((_e7330 + _e7374) + _e7390)));
                                                        } else {
                                                            let _e7393 = ((_e7375 - _e7376) - _e7377);
                                                            let _e7396 = (((_e7330 + _e7355) + _e7374) + _e7390);
                                                            phi_11709_ = array<type_16, 4>(type_16(_e7376, _e7355), type_16(_e7377, _e7374), type_16(_e7393, _e7396), type_16(_e7393, _e7396));
                                                        }
                                                        let _e7414 = phi_11709_;
                                                        local_2 = array<type_16, 4>(type_16(_e7414[0].member, _e7414[0].member_1), type_16(_e7414[1].member, _e7414[1].member_1), type_16(_e7414[2].member, _e7414[2].member_1), type_16(_e7414[3].member, _e7414[3].member_1));
                                                        phi_11729_ = type_9(0u, 4u);
                                                        phi_11732_ = true;
                                                        loop {
                                                            let _e7433 = phi_11729_;
                                                            let _e7435 = phi_11732_;
                                                            local_106 = _e7435;
                                                            let _e7438 = (_e7433.member < _e7433.member_1);
                                                            let _e7449 = select(type_9().member_1, _e7433.member, _e7438);
                                                            if (bitcast<i32>(select(0u, 1u, _e7438)) != 0i) {
                                                                let _e7454 = local_2[_e7449].member;
                                                                let _e7457 = local_2[_e7449].member_1;
                                                                let _e7459 = (_e7454 < -(_e7457));
                                                                phi_11733_ = select((_e7435 && (_e7454 > _e7457)), bool(), _e7459);
                                                                phi_11784_ = select(true, false, _e7459);
                                                                phi_11785_ = _e7459;
                                                            } else {
                                                                phi_11733_ = bool();
                                                                phi_11784_ = false;
                                                                phi_11785_ = false;
                                                            }
                                                            let _e7465 = phi_11733_;
                                                            let _e7467 = phi_11784_;
                                                            let _e7469 = phi_11785_;
                                                            local_105 = _e7469;
                                                            continue;
                                                            continuing {
                                                                phi_11729_ = type_9(select(_e7433.member, (_e7433.member + 1u), _e7438), select(_e7433.member_1, _e7433.member_1, _e7438));
                                                                phi_11732_ = _e7465;
                                                                break if !(_e7467);
                                                            }
                                                        }
                                                        let _e7472 = local_105;
                                                        let _e7473 = select(true, false, _e7472);
                                                        let _e7475 = local_106;
                                                        phi_11799_ = select(u32(), select(2u, 1u, _e7475), _e7473);
                                                        phi_11800_ = 0u;
                                                        phi_11801_ = select(true, false, _e7473);
                                                    } else {
                                                        phi_11799_ = u32();
                                                        phi_11800_ = 2u;
                                                        phi_11801_ = true;
                                                    }
                                                    let _e7480 = phi_11799_;
                                                    let _e7482 = phi_11800_;
                                                    let _e7484 = phi_11801_;
                                                    let _e7485 = select(_e7480, _e7482, _e7484);
                                                    let _e7486 = (_e7485 == 0u);
                                                    if _e7486 {
                                                        phi_11832_ = bool();
                                                        phi_11833_ = false;
                                                        phi_11834_ = false;
                                                    } else {
                                                        let _e7489 = select(false, _e6927.member_2, (_e7485 == 1u));
                                                        let _e7495 = select(true, select(true, false, ((_e6927.member_1 - _e6927.member) <= _e6542)), _e7489);
                                                        phi_11832_ = _e7489;
                                                        phi_11833_ = _e7495;
                                                        phi_11834_ = select(true, false, _e7495);
                                                    }
                                                    let _e7498 = phi_11832_;
                                                    let _e7500 = phi_11833_;
                                                    let _e7502 = phi_11834_;
                                                    phi_11835_ = _e7498;
                                                    phi_11836_ = _e7486;
                                                    phi_11837_ = _e7500;
                                                    phi_11838_ = _e7502;
                                                }
                                                let _e7504 = phi_11835_;
                                                let _e7506 = phi_11836_;
                                                let _e7508 = phi_11837_;
                                                let _e7510 = phi_11838_;
                                                phi_11839_ = _e7504;
                                                phi_11840_ = _e7506;
                                                phi_11841_ = _e7508;
                                                phi_11842_ = _e6932;
                                                phi_11843_ = _e7510;
                                            }
                                            let _e7512 = phi_11839_;
                                            let _e7514 = phi_11840_;
                                            let _e7516 = phi_11841_;
                                            let _e7518 = phi_11842_;
                                            let _e7520 = phi_11843_;
                                            phi_11844_ = _e6927;
                                            phi_11845_ = _e7512;
                                            phi_11846_ = _e6927;
                                            phi_11847_ = _e7514;
                                            phi_11848_ = _e7516;
                                            phi_11849_ = _e7518;
                                            phi_11850_ = _e7520;
                                        }
                                        let _e7522 = phi_11844_;
                                        let _e7524 = phi_11845_;
                                        let _e7526 = phi_11846_;
                                        let _e7528 = phi_11847_;
                                        let _e7530 = phi_11848_;
                                        let _e7532 = phi_11849_;
                                        let _e7534 = phi_11850_;
                                        phi_11851_ = _e7522;
                                        phi_11852_ = _e7524;
                                        phi_11853_ = _e7526;
                                        phi_11854_ = _e7528;
                                        phi_11855_ = _e7530;
                                        phi_11856_ = _e6607;
                                        phi_11857_ = _e7532;
                                        phi_11858_ = _e7534;
                                    } else {
                                        phi_11851_ = type_45();
                                        phi_11852_ = bool();
                                        phi_11853_ = type_45();
                                        phi_11854_ = true;
                                        phi_11855_ = false;
                                        phi_11856_ = false;
                                        phi_11857_ = false;
                                        phi_11858_ = false;
                                    }
                                    let _e7536 = phi_11851_;
                                    let _e7538 = phi_11852_;
                                    let _e7540 = phi_11853_;
                                    let _e7542 = phi_11854_;
                                    let _e7544 = phi_11855_;
                                    let _e7546 = phi_11856_;
                                    let _e7548 = phi_11857_;
                                    let _e7550 = phi_11858_;
                                    phi_11866_ = _e7536;
                                    phi_11867_ = _e7538;
                                    phi_11868_ = _e7540;
                                    phi_11869_ = select(_e7544, false, _e7542);
                                    phi_11870_ = _e7542;
                                    phi_11871_ = select(_e7546, false, _e7542);
                                    phi_11872_ = select(_e7548, false, _e7542);
                                    phi_11873_ = select(_e7550, false, _e7542);
                                } else {
                                    phi_11866_ = type_45(_e5713, _e5713, false);
                                    phi_11867_ = false;
                                    phi_11868_ = type_45();
                                    phi_11869_ = true;
                                    phi_11870_ = false;
                                    phi_11871_ = false;
                                    phi_11872_ = false;
                                    phi_11873_ = false;
                                }
                                let _e7556 = phi_11866_;
                                let _e7558 = phi_11867_;
                                let _e7560 = phi_11868_;
                                let _e7562 = phi_11869_;
                                let _e7564 = phi_11870_;
                                let _e7566 = phi_11871_;
                                let _e7568 = phi_11872_;
                                let _e7570 = phi_11873_;
                                if _e7562 {
                                    let _e7575 = local_7.member[0u];
                                    let _e7581 = local_7.member_1[0u];
                                    let _e7587 = local_7.member_2[0u];
                                    let _e7591 = (_e7575[0] - _e7581[0]);
                                    let _e7592 = (_e7575[1] - _e7581[1]);
                                    let _e7593 = (_e7575[2] - _e7581[2]);
                                    let _e7594 = (_e282.member == 0u);
                                    let _e7606 = local_7.member[1u];
                                    let _e7612 = local_7.member_1[1u];
                                    let _e7618 = local_7.member_2[1u];
                                    let _e7622 = (_e7606[0] - _e7612[0]);
                                    let _e7623 = (_e7606[1] - _e7612[1]);
                                    let _e7624 = (_e7606[2] - _e7612[2]);
                                    let _e7625 = (_e282.member == 0u);
                                    let _e7637 = local_7.member[0u];
                                    let _e7643 = select(_e7637[0], -(_e7637[0]), (_e7637[0] < 0f));
                                    let _e7646 = select(_e7637[1], -(_e7637[1]), (_e7637[1] < 0f));
                                    let _e7648 = select(_e7646, _e7643, (_e7643 > _e7646));
                                    let _e7651 = select(_e7637[2], -(_e7637[2]), (_e7637[2] < 0f));
                                    let _e7653 = select(_e7651, _e7648, (_e7648 > _e7651));
                                    let _e7656 = local_7.member[1u];
                                    let _e7662 = select(_e7656[0], -(_e7656[0]), (_e7656[0] < 0f));
                                    let _e7665 = select(_e7656[1], -(_e7656[1]), (_e7656[1] < 0f));
                                    let _e7667 = select(_e7665, _e7662, (_e7662 > _e7665));
                                    let _e7670 = select(_e7656[2], -(_e7656[2]), (_e7656[2] < 0f));
                                    let _e7672 = select(_e7670, _e7667, (_e7667 > _e7670));
                                    let _e7676 = local_7.member_3;
                                    let _e7680 = local_7.member_1[0u];
                                    let _e7686 = select(_e7680[0], -(_e7680[0]), (_e7680[0] < 0f));
                                    let _e7689 = select(_e7680[1], -(_e7680[1]), (_e7680[1] < 0f));
                                    let _e7691 = select(_e7689, _e7686, (_e7686 > _e7689));
                                    let _e7694 = select(_e7680[2], -(_e7680[2]), (_e7680[2] < 0f));
                                    let _e7696 = select(_e7694, _e7691, (_e7691 > _e7694));
                                    let _e7699 = local_7.member_1[1u];
                                    let _e7705 = select(_e7699[0], -(_e7699[0]), (_e7699[0] < 0f));
                                    let _e7708 = select(_e7699[1], -(_e7699[1]), (_e7699[1] < 0f));
                                    let _e7710 = select(_e7708, _e7705, (_e7705 > _e7708));
                                    let _e7713 = select(_e7699[2], -(_e7699[2]), (_e7699[2] < 0f));
                                    let _e7715 = select(_e7713, _e7710, (_e7710 > _e7713));
                                    let _e7719 = local_7.member_3;
                                    let _e7723 = local_7.member_2[0u];
                                    let _e7729 = select(_e7723[0], -(_e7723[0]), (_e7723[0] < 0f));
                                    let _e7732 = select(_e7723[1], -(_e7723[1]), (_e7723[1] < 0f));
                                    let _e7734 = select(_e7732, _e7729, (_e7729 > _e7732));
                                    let _e7737 = select(_e7723[2], -(_e7723[2]), (_e7723[2] < 0f));
                                    let _e7739 = select(_e7737, _e7734, (_e7734 > _e7737));
                                    let _e7742 = local_7.member_2[1u];
                                    let _e7748 = select(_e7742[0], -(_e7742[0]), (_e7742[0] < 0f));
                                    let _e7751 = select(_e7742[1], -(_e7742[1]), (_e7742[1] < 0f));
                                    let _e7753 = select(_e7751, _e7748, (_e7748 > _e7751));
                                    let _e7756 = select(_e7742[2], -(_e7742[2]), (_e7742[2] < 0f));
                                    let _e7758 = select(_e7756, _e7753, (_e7753 > _e7756));
                                    let _e7762 = local_7.member_3;
                                    let _e7769 = local_7.member_3;
                                    let _e7774 = (_e5711 * 0.00390625f);
                                    local = type_28(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    phi_12296_ = type_9(0u, 96u);
                                    phi_12299_ = _e7556.member;
                                    phi_12301_ = _e7556.member;
                                    phi_12303_ = (_e7556.member_1 - _e7556.member);
                                    phi_12305_ = _e7556.member;
                                    phi_12307_ = false;
                                    phi_12309_ = 0u;
                                    loop {
                                        let _e7777 = phi_12296_;
                                        let _e7779 = phi_12299_;
                                        let _e7781 = phi_12301_;
                                        let _e7783 = phi_12303_;
                                        let _e7785 = phi_12305_;
                                        let _e7787 = phi_12307_;
                                        let _e7789 = phi_12309_;
                                        local_116 = _e7779;
                                        local_119 = _e7781;
                                        let _e7792 = (_e7777.member < _e7777.member_1);
                                        if (bitcast<i32>(select(0u, 1u, _e7792)) != 0i) {
                                            let _e7806 = local_7.member[0u];
                                            let _e7812 = local_7.member[1u];
                                            let _e7828 = local_7.member_1[0u];
                                            let _e7834 = local_7.member_1[1u];
                                            let _e7850 = local_7.member_2[0u];
                                            let _e7856 = local_7.member_2[1u];
                                            let _e7870 = function_4(array<f32, 3>((_e7806[0] + ((_e7812[0] - _e7806[0]) * _e7779)), (_e7806[1] + ((_e7812[1] - _e7806[1]) * _e7779)), (_e7806[2] + ((_e7812[2] - _e7806[2]) * _e7779))), array<f32, 3>((_e7828[0] + ((_e7834[0] - _e7828[0]) * _e7779)), (_e7828[1] + ((_e7834[1] - _e7828[1]) * _e7779)), (_e7828[2] + ((_e7834[2] - _e7828[2]) * _e7779))), array<f32, 3>((_e7850[0] + ((_e7856[0] - _e7850[0]) * _e7779)), (_e7850[1] + ((_e7856[1] - _e7850[1]) * _e7779)), (_e7850[2] + ((_e7856[2] - _e7850[2]) * _e7779))), _e282.member);
                                            if (_e7789 == 0u) {
                                                phi_12460_ = _e7870;
                                            } else {
                                                phi_12460_ = array<f32, 3>(select(0f, _e7870[0], (_e7789 == 1u)), select(0f, _e7870[1], (_e7789 == 2u)), select(0f, _e7870[2], (_e7789 == 3u)));
                                            }
                                            let _e7883 = phi_12460_;
                                            let _e7897 = ((select(_e7883[0], -(_e7883[0]), (_e7883[0] < 0f)) + select(_e7883[1], -(_e7883[1]), (_e7883[1] < 0f))) + select(_e7883[2], -(_e7883[2]), (_e7883[2] < 0f)));
                                            if (_e7897 > 0f) {
                                                if ((bitcast<u32>(_e7897) & 2139095040u) != 2139095040u) {
                                                    let _e7902 = (1f / _e7897);
                                                    let _e7904 = (_e7883[0] * _e7902);
                                                    let _e7906 = (_e7883[1] * _e7902);
                                                    let _e7908 = (_e7883[2] * _e7902);
                                                    let _e7913 = (((_e7904 * _e7904) + (_e7906 * _e7906)) + (_e7908 * _e7908));
                                                    if (_e7913 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_12583_ = select(0f, (0.000000000000000000106433627f * 2f), (_e7913 > 0f));
                                                    } else {
                                                        phi_12526_ = type_14(0i, 5i);
                                                        phi_12529_ = bitcast<f32>(((bitcast<u32>(_e7913) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e7921 = phi_12526_;
                                                            let _e7923 = phi_12529_;
                                                            local_107 = _e7923;
                                                            if (_e7921.member < _e7921.member_1) {
                                                                let _e7930 = (_e7921.member + 1i);
                                                                phi_12527_ = type_14(select(_e7930, type_15().member_1, select(false, true, ((false == (_e7930 > _e7921.member)) != false))), _e7921.member_1);
                                                                phi_12570_ = type_15(1u, _e7921.member);
                                                            } else {
                                                                phi_12527_ = _e7921;
                                                                phi_12570_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e7941 = phi_12527_;
                                                            let _e7943 = phi_12570_;
                                                            let _e7946 = (bitcast<i32>(_e7943.member) != 0i);
                                                            if _e7946 {
                                                                phi_12530_ = (0.5f * (_e7923 + (_e7913 / _e7923)));
                                                            } else {
                                                                phi_12530_ = f32();
                                                            }
                                                            let _e7951 = phi_12530_;
                                                            continue;
                                                            continuing {
                                                                phi_12526_ = _e7941;
                                                                phi_12529_ = _e7951;
                                                                break if !(_e7946);
                                                            }
                                                        }
                                                        let _e7956 = local_107;
                                                        phi_12583_ = (_e7956 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e7962 = phi_12583_;
                                                    let _e7963 = (0.000000059604645f * 12f);
                                                    let _e7968 = ((((((((select(_e7672, _e7653, (_e7653 > _e7672)) + _e7676) + (select(_e7715, _e7696, (_e7696 > _e7715)) + _e7719)) + (select(_e7758, _e7739, (_e7739 > _e7758)) + _e7762)) * (0.000000059604645f * 16f)) + (_e7769 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e7962) * (1f + _e7963)));
                                                    let _e7973 = (((_e7904 * _e7575[0]) + (_e7906 * _e7575[1])) + (_e7908 * _e7575[2]));
                                                    let _e7978 = (((_e7904 * _e7591) + (_e7906 * _e7592)) + (_e7908 * _e7593));
                                                    let _e7983 = (((_e7904 * (_e7575[0] - _e7587[0])) + (_e7906 * (_e7575[1] - _e7587[1]))) + (_e7908 * (_e7575[2] - _e7587[2])));
                                                    let _e7988 = (((_e7904 * select((_e7591 - _e7587[0]), _e7575[0], _e7594)) + (_e7906 * select((_e7592 - _e7587[1]), _e7575[1], _e7594))) + (_e7908 * select((_e7593 - _e7587[2]), _e7575[2], _e7594)));
                                                    let _e7994 = (((_e7904 * _e7606[0]) + (_e7906 * _e7606[1])) + (_e7908 * _e7606[2]));
                                                    let _e7999 = (((_e7904 * _e7622) + (_e7906 * _e7623)) + (_e7908 * _e7624));
                                                    let _e8004 = (((_e7904 * (_e7606[0] - _e7618[0])) + (_e7906 * (_e7606[1] - _e7618[1]))) + (_e7908 * (_e7606[2] - _e7618[2])));
                                                    let _e8009 = (((_e7904 * select((_e7622 - _e7618[0]), _e7606[0], _e7625)) + (_e7906 * select((_e7623 - _e7618[1]), _e7606[1], _e7625))) + (_e7908 * select((_e7624 - _e7618[2]), _e7606[2], _e7625)));
                                                    phi_12706_ = type_28(array<f32, 4>(_e7973, _e7978, _e7983, _e7988), array<f32, 4>(_e7994, _e7999, _e8004, _e8009), array<f32, 4>((_e7968 + ((select(_e7973, -(_e7973), (_e7973 < 0f)) + select(_e7994, -(_e7994), (_e7994 < 0f))) * _e7963)), (_e7968 + ((select(_e7978, -(_e7978), (_e7978 < 0f)) + select(_e7999, -(_e7999), (_e7999 < 0f))) * _e7963)), (_e7968 + ((select(_e7983, -(_e7983), (_e7983 < 0f)) + select(_e8004, -(_e8004), (_e8004 < 0f))) * _e7963)), (_e7968 + ((select(_e7988, -(_e7988), (_e7988 < 0f)) + select(_e8009, -(_e8009), (_e8009 < 0f))) * _e7963))));
                                                    phi_12707_ = false;
                                                } else {
                                                    phi_12706_ = type_28();
                                                    phi_12707_ = true;
                                                }
                                                let _e8050 = phi_12706_;
                                                let _e8052 = phi_12707_;
                                                phi_12708_ = _e8050;
                                                phi_12709_ = _e8052;
                                            } else {
                                                phi_12708_ = type_28();
                                                phi_12709_ = true;
                                            }
                                            let _e8054 = phi_12708_;
                                            let _e8056 = phi_12709_;
                                            if _e8056 {
                                                phi_12717_ = type_28(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            } else {
                                                phi_12717_ = _e8054;
                                            }
                                            let _e8058 = phi_12717_;
                                            local_1 = type_28(array<f32, 4>(_e8058.member[0], _e8058.member[1], _e8058.member[2], _e8058.member[3]), array<f32, 4>(_e8058.member_1[0], _e8058.member_1[1], _e8058.member_1[2], _e8058.member_1[3]), array<f32, 4>(_e8058.member_2[0], _e8058.member_2[1], _e8058.member_2[2], _e8058.member_2[3]));
                                            let _e8078 = (_e7779 - _e7785);
                                            let _e8082 = local_1.member[0u];
                                            let _e8085 = local_1.member_1[0u];
                                            let _e8088 = local_1.member[0u];
                                            let _e8094 = local_1.member_2[0u];
                                            if (((_e8082 + ((_e8085 - _e8088) * _e7779)) - _e8094) > 0f) {
                                                let _e8099 = local_1.member[1u];
                                                let _e8102 = local_1.member_1[1u];
                                                let _e8105 = local_1.member[1u];
                                                let _e8111 = local_1.member_2[1u];
                                                if (((_e8099 + ((_e8102 - _e8105) * _e7779)) - _e8111) > 0f) {
                                                    let _e8116 = local_1.member[2u];
                                                    let _e8119 = local_1.member_1[2u];
                                                    let _e8122 = local_1.member[2u];
                                                    let _e8128 = local_1.member_2[2u];
                                                    if (((_e8116 + ((_e8119 - _e8122) * _e7779)) - _e8128) > 0f) {
                                                        let _e8133 = local_1.member[3u];
                                                        let _e8136 = local_1.member_1[3u];
                                                        let _e8139 = local_1.member[3u];
                                                        let _e8145 = local_1.member_2[3u];
                                                        phi_12888_ = (((_e8133 + ((_e8136 - _e8139) * _e7779)) - _e8145) > 0f);
                                                        phi_12889_ = false;
                                                    } else {
                                                        phi_12888_ = bool();
                                                        phi_12889_ = true;
                                                    }
                                                    let _e8149 = phi_12888_;
                                                    let _e8151 = phi_12889_;
                                                    phi_12890_ = _e8149;
                                                    phi_12891_ = _e8151;
                                                } else {
                                                    phi_12890_ = bool();
                                                    phi_12891_ = true;
                                                }
                                                let _e8153 = phi_12890_;
                                                let _e8155 = phi_12891_;
                                                phi_12892_ = _e8153;
                                                phi_12893_ = _e8155;
                                            } else {
                                                phi_12892_ = bool();
                                                phi_12893_ = true;
                                            }
                                            let _e8157 = phi_12892_;
                                            let _e8159 = phi_12893_;
                                            if select(_e8157, false, _e8159) {
                                                if (_e7779 <= _e7781) {
                                                    phi_13207_ = true;
                                                } else {
                                                    let _e8164 = local.member[0u];
                                                    let _e8167 = local.member_1[0u];
                                                    let _e8170 = local.member[0u];
                                                    let _e8176 = local.member_2[0u];
                                                    let _e8180 = local_1.member[0u];
                                                    let _e8183 = local_1.member_1[0u];
                                                    let _e8186 = local_1.member[0u];
                                                    let _e8192 = local_1.member_2[0u];
                                                    if ((((_e8164 + ((_e8167 - _e8170) * _e7779)) - _e8176) + ((_e8180 + ((_e8183 - _e8186) * _e7785)) - _e8192)) > 0f) {
                                                        let _e8198 = local.member[1u];
                                                        let _e8201 = local.member_1[1u];
                                                        let _e8204 = local.member[1u];
                                                        let _e8210 = local.member_2[1u];
                                                        let _e8214 = local_1.member[1u];
                                                        let _e8217 = local_1.member_1[1u];
                                                        let _e8220 = local_1.member[1u];
                                                        let _e8226 = local_1.member_2[1u];
                                                        if ((((_e8198 + ((_e8201 - _e8204) * _e7779)) - _e8210) + ((_e8214 + ((_e8217 - _e8220) * _e7785)) - _e8226)) > 0f) {
                                                            let _e8232 = local.member[2u];
                                                            let _e8235 = local.member_1[2u];
                                                            let _e8238 = local.member[2u];
                                                            let _e8244 = local.member_2[2u];
                                                            let _e8248 = local_1.member[2u];
                                                            let _e8251 = local_1.member_1[2u];
                                                            let _e8254 = local_1.member[2u];
                                                            let _e8260 = local_1.member_2[2u];
                                                            if ((((_e8232 + ((_e8235 - _e8238) * _e7779)) - _e8244) + ((_e8248 + ((_e8251 - _e8254) * _e7785)) - _e8260)) > 0f) {
                                                                let _e8266 = local.member[3u];
                                                                let _e8269 = local.member_1[3u];
                                                                let _e8272 = local.member[3u];
                                                                let _e8278 = local.member_2[3u];
                                                                let _e8282 = local_1.member[3u];
                                                                let _e8285 = local_1.member_1[3u];
                                                                let _e8288 = local_1.member[3u];
                                                                let _e8294 = local_1.member_2[3u];
                                                                phi_13194_ = ((((_e8266 + ((_e8269 - _e8272) * _e7779)) - _e8278) + ((_e8282 + ((_e8285 - _e8288) * _e7785)) - _e8294)) > 0f);
                                                                phi_13195_ = false;
                                                            } else {
                                                                phi_13194_ = bool();
                                                                phi_13195_ = true;
                                                            }
                                                            let _e8299 = phi_13194_;
                                                            let _e8301 = phi_13195_;
                                                            phi_13196_ = _e8299;
                                                            phi_13197_ = _e8301;
                                                        } else {
                                                            phi_13196_ = bool();
                                                            phi_13197_ = true;
                                                        }
                                                        let _e8303 = phi_13196_;
                                                        let _e8305 = phi_13197_;
                                                        phi_13198_ = _e8303;
                                                        phi_13199_ = _e8305;
                                                    } else {
                                                        phi_13198_ = bool();
                                                        phi_13199_ = true;
                                                    }
                                                    let _e8307 = phi_13198_;
                                                    let _e8309 = phi_13199_;
                                                    phi_13207_ = select(_e8307, false, _e8309);
                                                }
                                                let _e8312 = phi_13207_;
                                                if _e8312 {
                                                    if select(true, select(true, false, (_e7779 >= _e7556.member_1)), _e7787) {
                                                        local = type_28(array<f32, 4>(_e8058.member[0], _e8058.member[1], _e8058.member[2], _e8058.member[3]), array<f32, 4>(_e8058.member_1[0], _e8058.member_1[1], _e8058.member_1[2], _e8058.member_1[3]), array<f32, 4>(_e8058.member_2[0], _e8058.member_2[1], _e8058.member_2[2], _e8058.member_2[3]));
                                                        let _e8337 = local.member[0u];
                                                        let _e8340 = local.member_1[0u];
                                                        let _e8343 = local.member_2[0u];
                                                        if select(true, select(true, false, (_e8340 > _e8343)), (_e8337 > _e8343)) {
                                                            let _e8348 = (_e8340 >= _e8337);
                                                            if _e8348 {
                                                                phi_13316_ = f32();
                                                                phi_13317_ = false;
                                                            } else {
                                                                if ((_e8337 - _e8340) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_13314_ = (((_e8337 - _e8343) / (_e8337 - _e8340)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_13315_ = false;
                                                                } else {
                                                                    phi_13314_ = f32();
                                                                    phi_13315_ = true;
                                                                }
                                                                let _e8359 = phi_13314_;
                                                                let _e8361 = phi_13315_;
                                                                phi_13316_ = _e8359;
                                                                phi_13317_ = _e8361;
                                                            }
                                                            let _e8363 = phi_13316_;
                                                            let _e8365 = phi_13317_;
                                                            phi_13318_ = _e8363;
                                                            phi_13319_ = _e8348;
                                                            phi_13320_ = _e8365;
                                                        } else {
                                                            phi_13318_ = f32();
                                                            phi_13319_ = true;
                                                            phi_13320_ = false;
                                                        }
                                                        let _e8367 = phi_13318_;
                                                        let _e8369 = phi_13319_;
                                                        let _e8371 = phi_13320_;
                                                        let _e8374 = select(_e8367, select(_e7779, 2f, _e8369), select(_e8371, true, _e8369));
                                                        let _e8377 = local.member[1u];
                                                        let _e8380 = local.member_1[1u];
                                                        let _e8383 = local.member_2[1u];
                                                        if select(true, select(true, false, (_e8380 > _e8383)), (_e8377 > _e8383)) {
                                                            let _e8388 = (_e8380 >= _e8377);
                                                            if _e8388 {
                                                                phi_13384_ = f32();
                                                                phi_13385_ = false;
                                                            } else {
                                                                if ((_e8377 - _e8380) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_13382_ = (((_e8377 - _e8383) / (_e8377 - _e8380)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_13383_ = false;
                                                                } else {
                                                                    phi_13382_ = f32();
                                                                    phi_13383_ = true;
                                                                }
                                                                let _e8399 = phi_13382_;
                                                                let _e8401 = phi_13383_;
                                                                phi_13384_ = _e8399;
                                                                phi_13385_ = _e8401;
                                                            }
                                                            let _e8403 = phi_13384_;
                                                            let _e8405 = phi_13385_;
                                                            phi_13386_ = _e8403;
                                                            phi_13387_ = _e8388;
                                                            phi_13388_ = _e8405;
                                                        } else {
                                                            phi_13386_ = f32();
                                                            phi_13387_ = true;
                                                            phi_13388_ = false;
                                                        }
                                                        let _e8407 = phi_13386_;
                                                        let _e8409 = phi_13387_;
                                                        let _e8411 = phi_13388_;
                                                        let _e8414 = select(_e8407, select(_e7779, 2f, _e8409), select(_e8411, true, _e8409));
                                                        let _e8416 = select(_e8414, _e8374, (_e8374 < _e8414));
                                                        let _e8419 = local.member[2u];
                                                        let _e8422 = local.member_1[2u];
                                                        let _e8425 = local.member_2[2u];
                                                        if select(true, select(true, false, (_e8422 > _e8425)), (_e8419 > _e8425)) {
                                                            let _e8430 = (_e8422 >= _e8419);
                                                            if _e8430 {
                                                                phi_13457_ = f32();
                                                                phi_13458_ = false;
                                                            } else {
                                                                if ((_e8419 - _e8422) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_13455_ = (((_e8419 - _e8425) / (_e8419 - _e8422)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_13456_ = false;
                                                                } else {
                                                                    phi_13455_ = f32();
                                                                    phi_13456_ = true;
                                                                }
                                                                let _e8441 = phi_13455_;
                                                                let _e8443 = phi_13456_;
                                                                phi_13457_ = _e8441;
                                                                phi_13458_ = _e8443;
                                                            }
                                                            let _e8445 = phi_13457_;
                                                            let _e8447 = phi_13458_;
                                                            phi_13459_ = _e8445;
                                                            phi_13460_ = _e8430;
                                                            phi_13461_ = _e8447;
                                                        } else {
                                                            phi_13459_ = f32();
                                                            phi_13460_ = true;
                                                            phi_13461_ = false;
                                                        }
                                                        let _e8449 = phi_13459_;
                                                        let _e8451 = phi_13460_;
                                                        let _e8453 = phi_13461_;
                                                        let _e8456 = select(_e8449, select(_e7779, 2f, _e8451), select(_e8453, true, _e8451));
                                                        let _e8459 = local.member[3u];
                                                        let _e8462 = local.member_1[3u];
                                                        let _e8465 = local.member_2[3u];
                                                        if select(true, select(true, false, (_e8462 > _e8465)), (_e8459 > _e8465)) {
                                                            let _e8470 = (_e8462 >= _e8459);
                                                            if _e8470 {
                                                                phi_13525_ = f32();
                                                                phi_13526_ = false;
                                                            } else {
                                                                if ((_e8459 - _e8462) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_13523_ = (((_e8459 - _e8465) / (_e8459 - _e8462)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_13524_ = false;
                                                                } else {
                                                                    phi_13523_ = f32();
                                                                    phi_13524_ = true;
                                                                }
                                                                let _e8481 = phi_13523_;
                                                                let _e8483 = phi_13524_;
                                                                phi_13525_ = _e8481;
                                                                phi_13526_ = _e8483;
                                                            }
                                                            let _e8485 = phi_13525_;
                                                            let _e8487 = phi_13526_;
                                                            phi_13527_ = _e8485;
                                                            phi_13528_ = _e8470;
                                                            phi_13529_ = _e8487;
                                                        } else {
                                                            phi_13527_ = f32();
                                                            phi_13528_ = true;
                                                            phi_13529_ = false;
                                                        }
                                                        let _e8489 = phi_13527_;
                                                        let _e8491 = phi_13528_;
                                                        let _e8493 = phi_13529_;
                                                        let _e8496 = select(_e8489, select(_e7779, 2f, _e8491), select(_e8493, true, _e8491));
                                                        let _e8498 = select(_e8496, _e8456, (_e8456 < _e8496));
                                                        let _e8500 = select(_e8498, _e8416, (_e8416 < _e8498));
                                                        let _e8502 = select(_e7779, _e8500, (_e8500 > _e7779));
                                                        let _e8503 = (_e8502 > _e7556.member_1);
                                                        if _e8503 {
                                                            phi_14058_ = f32();
                                                            phi_14059_ = f32();
                                                            phi_14060_ = false;
                                                        } else {
                                                            let _e8504 = (_e8502 - _e7779);
                                                            phi_14058_ = select((_e7556.member_1 - _e7779), select(0f, (_e8078 + _e8078), select(select(true, false, (_e8504 <= (_e7783 * 0.25f))), true, (_e8504 <= _e7774))), _e7787);
                                                            phi_14059_ = _e8504;
                                                            phi_14060_ = true;
                                                        }
                                                        let _e8515 = phi_14058_;
                                                        let _e8517 = phi_14059_;
                                                        let _e8519 = phi_14060_;
                                                        phi_14062_ = _e8502;
                                                        phi_14063_ = _e8515;
                                                        phi_14064_ = _e8517;
                                                        phi_14066_ = _e8519;
                                                        phi_14067_ = _e8503;
                                                        phi_14069_ = false;
                                                    } else {
                                                        phi_14062_ = f32();
                                                        phi_14063_ = f32();
                                                        phi_14064_ = f32();
                                                        phi_14066_ = false;
                                                        phi_14067_ = false;
                                                        phi_14069_ = true;
                                                    }
                                                    let _e8521 = phi_14062_;
                                                    let _e8523 = phi_14063_;
                                                    let _e8525 = phi_14064_;
                                                    let _e8527 = phi_14066_;
                                                    let _e8529 = phi_14067_;
                                                    let _e8531 = phi_14069_;
                                                    phi_14070_ = _e8521;
                                                    phi_14071_ = _e8523;
                                                    phi_14072_ = _e8525;
                                                    phi_14074_ = false;
                                                    phi_14075_ = _e8527;
                                                    phi_14076_ = _e8529;
                                                    phi_14078_ = _e8531;
                                                } else {
                                                    phi_14070_ = f32();
                                                    phi_14071_ = f32();
                                                    phi_14072_ = f32();
                                                    phi_14074_ = true;
                                                    phi_14075_ = false;
                                                    phi_14076_ = false;
                                                    phi_14078_ = false;
                                                }
                                                let _e8533 = phi_14070_;
                                                let _e8535 = phi_14071_;
                                                let _e8537 = phi_14072_;
                                                let _e8539 = phi_14074_;
                                                let _e8541 = phi_14075_;
                                                let _e8543 = phi_14076_;
                                                let _e8545 = phi_14078_;
                                                phi_14079_ = _e8533;
                                                phi_14080_ = _e8535;
                                                phi_14081_ = _e8537;
                                                phi_14083_ = _e8539;
                                                phi_14084_ = _e8541;
                                                phi_14085_ = _e8543;
                                                phi_14087_ = _e8545;
                                            } else {
                                                phi_14079_ = f32();
                                                phi_14080_ = f32();
                                                phi_14081_ = f32();
                                                phi_14083_ = true;
                                                phi_14084_ = false;
                                                phi_14085_ = false;
                                                phi_14087_ = false;
                                            }
                                            let _e8547 = phi_14079_;
                                            let _e8549 = phi_14080_;
                                            let _e8551 = phi_14081_;
                                            let _e8553 = phi_14083_;
                                            let _e8555 = phi_14084_;
                                            let _e8557 = phi_14085_;
                                            let _e8559 = phi_14087_;
                                            if _e8553 {
                                                if (_e7779 <= _e7781) {
                                                    let _e8712 = (_e7789 + 1u);
                                                    let _e8713 = (_e8712 > 3u);
                                                    phi_14422_ = _e8712;
                                                    phi_14423_ = f32();
                                                    phi_14424_ = false;
                                                    phi_14425_ = select(true, false, _e8713);
                                                    phi_14426_ = _e8713;
                                                } else {
                                                    let _e8563 = local.member[0u];
                                                    let _e8566 = local.member_1[0u];
                                                    let _e8569 = local.member[0u];
                                                    let _e8575 = local.member_2[0u];
                                                    let _e8576 = ((_e8563 + ((_e8566 - _e8569) * _e7785)) - _e8575);
                                                    let _e8579 = local.member[1u];
                                                    let _e8582 = local.member_1[1u];
                                                    let _e8585 = local.member[1u];
                                                    let _e8591 = local.member_2[1u];
                                                    let _e8592 = ((_e8579 + ((_e8582 - _e8585) * _e7785)) - _e8591);
                                                    let _e8594 = select(_e8592, _e8576, (_e8576 < _e8592));
                                                    let _e8597 = local.member[2u];
                                                    let _e8600 = local.member_1[2u];
                                                    let _e8603 = local.member[2u];
                                                    let _e8609 = local.member_2[2u];
                                                    let _e8610 = ((_e8597 + ((_e8600 - _e8603) * _e7785)) - _e8609);
                                                    let _e8613 = local.member[3u];
                                                    let _e8616 = local.member_1[3u];
                                                    let _e8619 = local.member[3u];
                                                    let _e8625 = local.member_2[3u];
                                                    let _e8626 = ((_e8613 + ((_e8616 - _e8619) * _e7785)) - _e8625);
                                                    let _e8628 = select(_e8626, _e8610, (_e8610 < _e8626));
                                                    let _e8630 = select(_e8628, _e8594, (_e8594 < _e8628));
                                                    let _e8633 = local_1.member[0u];
                                                    let _e8636 = local_1.member_1[0u];
                                                    let _e8639 = local_1.member[0u];
                                                    let _e8645 = local_1.member_2[0u];
                                                    let _e8646 = ((_e8633 + ((_e8636 - _e8639) * _e7779)) - _e8645);
                                                    let _e8649 = local_1.member[1u];
                                                    let _e8652 = local_1.member_1[1u];
                                                    let _e8655 = local_1.member[1u];
                                                    let _e8661 = local_1.member_2[1u];
                                                    let _e8662 = ((_e8649 + ((_e8652 - _e8655) * _e7779)) - _e8661);
                                                    let _e8664 = select(_e8662, _e8646, (_e8646 < _e8662));
                                                    let _e8667 = local_1.member[2u];
                                                    let _e8670 = local_1.member_1[2u];
                                                    let _e8673 = local_1.member[2u];
                                                    let _e8679 = local_1.member_2[2u];
                                                    let _e8680 = ((_e8667 + ((_e8670 - _e8673) * _e7779)) - _e8679);
                                                    let _e8683 = local_1.member[3u];
                                                    let _e8686 = local_1.member_1[3u];
                                                    let _e8689 = local_1.member[3u];
                                                    let _e8695 = local_1.member_2[3u];
                                                    let _e8696 = ((_e8683 + ((_e8686 - _e8689) * _e7779)) - _e8695);
                                                    let _e8698 = select(_e8696, _e8680, (_e8680 < _e8696));
                                                    let _e8700 = select(_e8698, _e8664, (_e8664 < _e8698));
                                                    if (_e8700 > 0f) {
                                                        phi_14420_ = 0.5f;
                                                    } else {
                                                        let _e8704 = (0.95f * (_e8630 / (_e8630 - _e8700)));
                                                        phi_14420_ = select(0.0625f, select(0.9f, _e8704, (_e8704 < 0.9f)), (_e8704 > 0.0625f));
                                                    }
                                                    let _e8710 = phi_14420_;
                                                    phi_14422_ = u32();
                                                    phi_14423_ = (_e8078 * _e8710);
                                                    phi_14424_ = true;
                                                    phi_14425_ = false;
                                                    phi_14426_ = false;
                                                }
                                                let _e8716 = phi_14422_;
                                                let _e8718 = phi_14423_;
                                                let _e8720 = phi_14424_;
                                                let _e8722 = phi_14425_;
                                                let _e8724 = phi_14426_;
                                                phi_14427_ = _e8716;
                                                phi_14428_ = _e7781;
                                                phi_14429_ = _e8718;
                                                phi_14430_ = _e7783;
                                                phi_14431_ = _e7785;
                                                phi_14432_ = _e7787;
                                                phi_14433_ = _e7789;
                                                phi_14434_ = _e8720;
                                                phi_14435_ = _e8722;
                                                phi_14436_ = _e8724;
                                                phi_14437_ = false;
                                                phi_14439_ = false;
                                            } else {
                                                phi_14427_ = u32();
                                                phi_14428_ = _e8547;
                                                phi_14429_ = _e8549;
                                                phi_14430_ = _e8551;
                                                phi_14431_ = _e7779;
                                                phi_14432_ = true;
                                                phi_14433_ = 0u;
                                                phi_14434_ = _e8555;
                                                phi_14435_ = false;
                                                phi_14436_ = false;
                                                phi_14437_ = _e8557;
                                                phi_14439_ = _e8559;
                                            }
                                            let _e8726 = phi_14427_;
                                            let _e8728 = phi_14428_;
                                            let _e8730 = phi_14429_;
                                            let _e8732 = phi_14430_;
                                            let _e8734 = phi_14431_;
                                            let _e8736 = phi_14432_;
                                            let _e8738 = phi_14433_;
                                            let _e8740 = phi_14434_;
                                            let _e8742 = phi_14435_;
                                            let _e8744 = phi_14436_;
                                            let _e8746 = phi_14437_;
                                            let _e8748 = phi_14439_;
                                            if _e8740 {
                                                let _e8749 = (_e8734 + _e8730);
                                                let _e8751 = select(_e8728, _e8749, (_e8749 > _e8728));
                                                let _e8753 = select(_e7556.member_1, _e8751, (_e8751 < _e7556.member_1));
                                                let _e8756 = select(((_e8753 - _e8734) > _e7774), true, !(_e7787));
                                                phi_14467_ = _e8753;
                                                phi_14468_ = _e8728;
                                                phi_14469_ = _e8732;
                                                phi_14470_ = _e8734;
                                                phi_14471_ = _e8736;
                                                phi_14472_ = _e8738;
                                                phi_14473_ = _e8756;
                                                phi_14474_ = select(true, false, _e8756);
                                                phi_14475_ = false;
                                                phi_14476_ = false;
                                                phi_14478_ = false;
                                            } else {
                                                phi_14467_ = _e7779;
                                                phi_14468_ = _e7781;
                                                phi_14469_ = _e7783;
                                                phi_14470_ = _e7785;
                                                phi_14471_ = _e7787;
                                                phi_14472_ = _e8726;
                                                phi_14473_ = _e8742;
                                                phi_14474_ = false;
                                                phi_14475_ = _e8744;
                                                phi_14476_ = _e8746;
                                                phi_14478_ = _e8748;
                                            }
                                            let _e8759 = phi_14467_;
                                            let _e8761 = phi_14468_;
                                            let _e8763 = phi_14469_;
                                            let _e8765 = phi_14470_;
                                            let _e8767 = phi_14471_;
                                            let _e8769 = phi_14472_;
                                            let _e8771 = phi_14473_;
                                            let _e8773 = phi_14474_;
                                            let _e8775 = phi_14475_;
                                            let _e8777 = phi_14476_;
                                            let _e8779 = phi_14478_;
                                            phi_12300_ = _e8759;
                                            phi_12302_ = _e8761;
                                            phi_12304_ = _e8763;
                                            phi_12306_ = _e8765;
                                            phi_12308_ = _e8767;
                                            phi_12310_ = _e8769;
                                            phi_14479_ = _e8728;
                                            phi_14481_ = _e8771;
                                            phi_14482_ = _e8773;
                                            phi_14483_ = _e8775;
                                            phi_14484_ = _e8777;
                                            phi_14486_ = false;
                                            phi_14487_ = _e8779;
                                        } else {
                                            phi_12300_ = f32();
                                            phi_12302_ = f32();
                                            phi_12304_ = f32();
                                            phi_12306_ = f32();
                                            phi_12308_ = bool();
                                            phi_12310_ = u32();
                                            phi_14479_ = f32();
                                            phi_14481_ = false;
                                            phi_14482_ = false;
                                            phi_14483_ = false;
                                            phi_14484_ = false;
                                            phi_14486_ = true;
                                            phi_14487_ = false;
                                        }
                                        let _e8781 = phi_12300_;
                                        let _e8783 = phi_12302_;
                                        let _e8785 = phi_12304_;
                                        let _e8787 = phi_12306_;
                                        let _e8789 = phi_12308_;
                                        let _e8791 = phi_12310_;
                                        let _e8793 = phi_14479_;
                                        let _e8795 = phi_14481_;
                                        let _e8797 = phi_14482_;
                                        let _e8799 = phi_14483_;
                                        let _e8801 = phi_14484_;
                                        let _e8803 = phi_14486_;
                                        let _e8805 = phi_14487_;
                                        local_108 = _e8797;
                                        local_109 = _e8799;
                                        local_110 = _e8797;
                                        local_111 = _e8801;
                                        local_112 = _e8797;
                                        local_113 = _e8803;
                                        local_114 = _e8797;
                                        local_115 = _e8805;
                                        local_117 = _e8797;
                                        local_118 = _e8793;
                                        continue;
                                        continuing {
                                            phi_12296_ = type_9(select(_e7777.member, (_e7777.member + 1u), _e7792), select(_e7777.member_1, _e7777.member_1, _e7792));
                                            phi_12299_ = _e8781;
                                            phi_12301_ = _e8783;
                                            phi_12303_ = _e8785;
                                            phi_12305_ = _e8787;
                                            phi_12307_ = _e8789;
                                            phi_12309_ = _e8791;
                                            break if !(_e8795);
                                        }
                                    }
                                    let _e8808 = local_108;
                                    let _e8810 = local_109;
                                    let _e8811 = select(_e8810, false, _e8808);
                                    let _e8813 = local_110;
                                    let _e8815 = local_111;
                                    let _e8818 = local_112;
                                    let _e8820 = local_113;
                                    let _e8823 = local_114;
                                    let _e8825 = local_115;
                                    let _e8831 = local_116;
                                    let _e8833 = select(select(_e8815, false, _e8813), false, _e8811);
                                    let _e8835 = local_117;
                                    let _e8842 = select(select(_e8835, false, _e8811), false, _e8833);
                                    let _e8847 = local_118;
                                    let _e8849 = local_119;
                                    let _e8851 = select(select(select(select(_e8820, false, _e8818), false, _e8811), false, _e8833), true, _e8842);
                                    let _e8858 = select(select(select(select(select(_e8825, false, _e8823), false, _e8811), false, _e8833), false, _e8842), false, _e8851);
                                    let _e8863 = select(select(select(select(_e8811, true, _e8833), false, _e8842), false, _e8851), true, _e8858);
                                    let _e8866 = (select(select(type_30().member, 1u, _e8851), select(select(select(type_30().member, 1u, _e8811), 0u, _e8833), 0u, _e8858), _e8863) != 0u);
                                    phi_14555_ = select(select(type_30().member_1, select(_e8849, _e8847, _e8842), _e8851), select(select(select(type_30().member_1, _e8831, _e8811), type_30().member_1, _e8833), type_30().member_1, _e8858), _e8863);
                                    phi_14556_ = select(true, false, _e8866);
                                    phi_14557_ = _e8866;
                                    phi_14558_ = false;
                                    phi_14559_ = false;
                                    phi_14560_ = false;
                                } else {
                                    phi_14555_ = f32();
                                    phi_14556_ = _e7564;
                                    phi_14557_ = false;
                                    phi_14558_ = _e7566;
                                    phi_14559_ = _e7568;
                                    phi_14560_ = _e7570;
                                }
                                let _e8869 = phi_14555_;
                                let _e8871 = phi_14556_;
                                let _e8873 = phi_14557_;
                                let _e8875 = phi_14558_;
                                let _e8877 = phi_14559_;
                                let _e8879 = phi_14560_;
                                phi_14561_ = _e7556;
                                phi_14562_ = _e7558;
                                phi_14563_ = _e8869;
                                phi_14564_ = _e7560;
                                phi_14565_ = _e8871;
                                phi_14566_ = _e8873;
                                phi_14567_ = false;
                                phi_14568_ = _e8875;
                                phi_14569_ = _e8877;
                                phi_14570_ = _e8879;
                            } else {
                                phi_14561_ = type_45();
                                phi_14562_ = bool();
                                phi_14563_ = f32();
                                phi_14564_ = type_45();
                                phi_14565_ = false;
                                phi_14566_ = false;
                                phi_14567_ = true;
                                phi_14568_ = false;
                                phi_14569_ = false;
                                phi_14570_ = false;
                            }
                            let _e8881 = phi_14561_;
                            let _e8883 = phi_14562_;
                            let _e8885 = phi_14563_;
                            let _e8887 = phi_14564_;
                            let _e8889 = phi_14565_;
                            let _e8891 = phi_14566_;
                            let _e8893 = phi_14567_;
                            let _e8895 = phi_14568_;
                            let _e8897 = phi_14569_;
                            let _e8899 = phi_14570_;
                            local_120 = _e8891;
                            local_121 = _e8883;
                            local_122 = _e8881;
                            local_123 = _e8885;
                            local_124 = _e8885;
                            local_125 = _e8885;
                            local_138 = _e8893;
                            local_139 = _e8895;
                            local_140 = _e8897;
                            local_141 = _e8899;
                            local_126 = _e8891;
                            local_127 = _e8887;
                            continue;
                            continuing {
                                phi_10441_ = type_9(select(_e6578.member, (_e6578.member + 1u), _e6581), select(_e6578.member_1, _e6578.member_1, _e6581));
                                break if !(_e8889);
                            }
                        }
                        let _e8902 = local_120;
                        if _e8902 {
                            let _e8904 = local_121;
                            if _e8904 {
                                let _e8906 = local_122;
                                let _e8909 = local_123;
                                let _e8911 = ((_e8906.member_1 - _e8909) <= _e6542);
                                let _e8916 = local_124;
                                phi_14586_ = type_30(select(type_30().member, 1u, _e8911), select(type_30().member_1, _e8916, _e8911));
                                phi_14587_ = select(true, false, _e8911);
                            } else {
                                phi_14586_ = type_30();
                                phi_14587_ = true;
                            }
                            let _e8921 = phi_14586_;
                            let _e8923 = phi_14587_;
                            let _e8928 = local_125;
                            phi_14593_ = type_30(select(_e8921.member, 2u, _e8923), select(_e8921.member_1, _e8928, _e8923));
                            phi_14594_ = false;
                            phi_14595_ = false;
                            phi_14596_ = false;
                            phi_14597_ = false;
                        } else {
                            phi_14593_ = type_30();
                            let _e9681 = local_138;
                            phi_14594_ = _e9681;
                            let _e9684 = local_139;
                            phi_14595_ = _e9684;
                            let _e9687 = local_140;
                            phi_14596_ = _e9687;
                            let _e9690 = local_141;
                            phi_14597_ = _e9690;
                        }
                        let _e8932 = phi_14593_;
                        let _e8934 = phi_14594_;
                        let _e8936 = phi_14595_;
                        let _e8938 = phi_14596_;
                        let _e8940 = phi_14597_;
                        let _e8947 = select(_e8936, false, _e8934);
                        let _e8951 = local_126;
                        let _e8958 = select(select(_e8938, false, _e8934), false, _e8947);
                        let _e8964 = select(select(select(_e8940, false, _e8934), false, _e8947), false, _e8958);
                        let _e8968 = local_127;
                        let _e8972 = select(select(_e8947, true, _e8958), true, _e8964);
                        phi_14639_ = type_30(select(_e8932.member, select(select(select(type_30().member, 0u, _e8947), 0u, _e8958), 1u, _e8964), _e8972), select(_e8932.member_1, select(select(select(type_30().member_1, type_30().member_1, _e8947), type_30().member_1, _e8958), _e8968.member, _e8964), _e8972));
                        phi_14640_ = type_30(select(type_30().member, 0u, _e8934), select(type_30().member_1, type_30().member_1, _e8934));
                        phi_14641_ = select(select(select(select(select(_e8951, false, _e8934), false, _e8947), false, _e8958), false, _e8964), true, _e8972);
                    }
                    let _e8983 = phi_14639_;
                    let _e8985 = phi_14640_;
                    let _e8987 = phi_14641_;
                    let _e8990 = select(_e8985.member, _e8983.member, _e8987);
                    let _e8993 = select(_e8985.member_1, _e8983.member_1, _e8987);
                    let _e8999 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e8993 > _e5713)), (_e8990 == 1u))));
                    switch bitcast<i32>(_e8990) {
                        case 0: {
                            phi_14685_ = type_31(0u, _e8999, array<u32, 2>(0u, 0u), false);
                            break;
                        }
                        case 1: {
                            let _e9003 = function_5(_e8993);
                            phi_14685_ = type_31(0u, _e8999, _e9003, true);
                            break;
                        }
                        case 2: {
                            let _e9001 = function_5(_e8993);
                            phi_14685_ = type_31(1u, _e8999, _e9001, true);
                            break;
                        }
                        default: {
                            phi_14685_ = type_31();
                            break;
                        }
                    }
                    let _e9007 = phi_14685_;
                    let _e9011 = params.member.member.member_12;
                    let _e9012 = bitcast<u32>(_e9011);
                    if (_e9007.member_2[0] == select((_e9012 << bitcast<u32>(29i)), 0u, ((_e9012 & 2147483647u) < 8388608u))) {
                        let _e9022 = params.member.member.member_12;
                        let _e9023 = bitcast<u32>(_e9022);
                        let _e9024 = (_e9023 & 2147483647u);
                        phi_14725_ = (_e9007.member_2[1] == select(((_e9023 ^ _e9024) | ((_e9024 >> bitcast<u32>(3i)) + 939524096u)), 0u, (_e9024 < 8388608u)));
                    } else {
                        phi_14725_ = false;
                    }
                    let _e9034 = phi_14725_;
                    let _e9036 = params.member.member.member_1;
                    if ((_e9036 & 128u) != 0u) {
                        phi_14741_ = true;
                    } else {
                        let _e9040 = params.member.member.member_1;
                        phi_14741_ = select(false, _e9034, ((_e9040 & 64u) != 0u));
                    }
                    let _e9045 = phi_14741_;
                    phi_14760_ = type_31(select(1u, _e9007.member, select(true, select(true, false, _e9045), _e9007.member_3)), _e9007.member_1, _e9007.member_2, _e9007.member_3);
                } else {
                    phi_14760_ = _e5707;
                }
                let _e9056 = phi_14760_;
                phi_14761_ = _e9056;
                phi_14762_ = type_9(_e245, _e248);
            } else {
                phi_14761_ = type_31(0u, 0u, array<u32, 2>(0u, 0u), false);
                phi_14762_ = type_9(0u, 0u);
            }
            let _e9058 = phi_14761_;
            let _e9060 = phi_14762_;
            let _e9065 = (_e9058.member != 0u);
            let _e9068 = select(false, !(_e9065), _e9058.member_3);
            if _e9068 {
                let _e9072 = (_e9058.member_2[1] >> bitcast<u32>(20i));
                if (_e9072 <= 896u) {
                    phi_14793_ = 0u;
                } else {
                    phi_14793_ = ((((_e9072 - 896u) << bitcast<u32>(23i)) | ((_e9058.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e9058.member_2[0] >> bitcast<u32>(29i)));
                }
                let _e9087 = phi_14793_;
                let _e9089 = atomicMin((&earliest.member[0u]), _e9087);
            }
            let _e9092 = params.member.member.member_1;
            if ((_e9092 & 16u) != 0u) {
                if (_e161 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e9068 {
                    let _e9098 = atomicAdd((&counters[0u]), 1u);
                    phi_14815_ = _e9098;
                } else {
                    phi_14815_ = 0u;
                }
                let _e9100 = phi_14815_;
                workgroupBarrier();
                if (_e161 == 0u) {
                    let _e9103 = atomicLoad((&counters[0u]));
                    if (_e9103 > 0u) {
                        let _e9106 = atomicAdd((&contacts.member[0u]), _e9103);
                        atomicStore((&counters[1u]), _e9106);
                    }
                }
                workgroupBarrier();
                let _e9109 = atomicLoad((&counters[1u]));
                let _e9110 = (_e9109 + _e9100);
                if _e9068 {
                    let _e9113 = params.member.member_1.member_3;
                    let _e9115 = params.member.member_2.member.member;
                    if (_e9110 < _e9113) {
                        let _e9117 = (7u * _e9110);
                        atomicStore((&contacts.member[(4u + _e9117)]), _e9115);
                        atomicStore((&contacts.member[(_e9117 + 5u)]), _e9058.member);
                        atomicStore((&contacts.member[(_e9117 + 6u)]), _e9060.member);
                        atomicStore((&contacts.member[(_e9117 + 7u)]), _e9060.member_1);
                        atomicStore((&contacts.member[(_e9117 + 8u)]), _e9058.member_2[0]);
                        atomicStore((&contacts.member[(_e9117 + 9u)]), _e9058.member_2[1]);
                        atomicStore((&contacts.member[(_e9117 + 10u)]), _e9058.member_1);
                    }
                }
            }
            workgroupBarrier();
            if (_e161 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e9065 {
                let _e9141 = atomicAdd((&counters[0u]), 1u);
                phi_14881_ = _e9141;
            } else {
                phi_14881_ = 0u;
            }
            let _e9143 = phi_14881_;
            workgroupBarrier();
            if (_e161 == 0u) {
                let _e9146 = atomicLoad((&counters[0u]));
                if (_e9146 > 0u) {
                    let _e9149 = atomicAdd((&undecided.member[0u]), _e9146);
                    atomicStore((&counters[1u]), _e9149);
                }
            }
            workgroupBarrier();
            let _e9152 = atomicLoad((&counters[1u]));
            let _e9153 = (_e9152 + _e9143);
            if _e9065 {
                let _e9155 = params.member.member_2.member.member_1;
                if (_e9153 < _e9155) {
                    let _e9157 = (2u * _e9153);
                    atomicStore((&undecided.member[(4u + _e9157)]), _e9060.member);
                    atomicStore((&undecided.member[(_e9157 + 5u)]), _e9060.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_986_ = type_9(select(_e216.member, (_e216.member + 1u), _e219), select(_e216.member_1, _e216.member_1, _e219));
            break if !(_e232);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_17(id, n, lane);
}
