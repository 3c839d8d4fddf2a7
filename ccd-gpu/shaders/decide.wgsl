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
    member: array<f32, 4>,
    member_1: array<f32, 4>,
    member_2: array<f32, 4>,
}

struct type_30 {
    member: type_9,
    member_1: u32,
    member_2: u32,
    member_3: u32,
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
    member: type_28,
    member_1: f32,
}

struct type_34 {
    member: u32,
    member_1: f32,
}

struct type_35 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_38 {
    member: array<f32, 4>,
    member_1: f32,
    member_2: f32,
    member_3: f32,
}

struct type_46 {
    member: f32,
    member_1: f32,
    member_2: bool,
}

struct type_50 {
    member: array<atomic<u32>>,
}

@group(0) @binding(4) 
var<storage> input: type_11;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_32;
@group(0) @binding(1) 
var<storage> paths: type_25;
@group(0) @binding(3) 
var<storage> elements: type_11;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_50;
@group(0) @binding(6) 
var<storage, read_write> undecided: type_50;
@group(0) @binding(7) 
var<storage, read_write> earliest: type_50;
@group(0) @binding(2) 
var<storage> positions: type_11;

fn function_(param: f32, param_1: f32) -> f32 {
    return select(param, param_1, select((param_1 >= param), true, (param != param)));
}

fn function_1(param_2: array<f32, 3>, param_3: array<f32, 3>) -> array<f32, 3> {
    let _e24 = ((((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])) < (((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])));
    return array<f32, 3>(select(param_2[0], param_3[0], _e24), select(param_2[1], param_3[1], _e24), select(param_2[2], param_3[2], _e24));
}

fn function_2(param_4: array<f32, 3>, param_5: array<f32, 3>, param_6: array<f32, 3>, param_7: u32) -> array<f32, 3> {
    var phi_759_: array<array<f32, 3>, 4>;

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
        phi_759_ = array<array<f32, 3>, 4>(array<f32, 3>((param_4[0] - (param_5[0] * _e155)), (param_4[1] - (param_5[1] * _e155)), (param_4[2] - (param_5[2] * _e155))), array<f32, 3>((param_4[0] - (param_6[0] * _e195)), (param_4[1] - (param_6[1] * _e195)), (param_4[2] - (param_6[2] * _e195))), array<f32, 3>((_e9 - (param_6[0] * _e232)), (_e12 - (param_6[1] * _e232)), (_e15 - (param_6[2] * _e232))), array<f32, 3>((_e245 - (param_5[0] * _e275)), (_e248 - (param_5[1] * _e275)), (_e251 - (param_5[2] * _e275))));
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
        phi_759_ = array<array<f32, 3>, 4>(array<f32, 3>((param_4[0] - (param_5[0] * _e74)), (param_4[1] - (param_5[1] * _e74)), (param_4[2] - (param_5[2] * _e74))), array<f32, 3>((param_4[0] - (param_6[0] * _e114)), (param_4[1] - (param_6[1] * _e114)), (param_4[2] - (param_6[2] * _e114))), _e47, _e47);
    }
    let _e288 = phi_759_;
    let _e291 = function_1(_e288[0], _e288[1]);
    let _e293 = function_1(_e291, _e288[2]);
    let _e295 = function_1(_e293, _e288[3]);
    return _e295;
}

fn function_3(param_8: array<f32, 3>, param_9: array<f32, 3>, param_10: array<f32, 3>, param_11: u32) -> array<f32, 3> {
    var phi_387_: bool;
    var phi_420_: array<f32, 3>;
    var phi_421_: bool;
    var phi_422_: array<f32, 3>;
    var phi_423_: bool;
    var phi_428_: array<f32, 3>;

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
        phi_387_ = select(select(bool(), select(bool(), select(bool(), (_e78 <= 1f), _e91), _e90), _e89), false, select(true, select(true, select(true, false, _e91), _e90), _e89));
    } else {
        let _e80 = (_e74 >= 0f);
        let _e81 = (_e78 >= 0f);
        phi_387_ = select(select(bool(), select(bool(), ((_e74 + _e78) <= 1f), _e81), _e80), false, select(true, select(true, false, _e81), _e80));
    }
    let _e101 = phi_387_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e101 {
            phi_420_ = array<f32, 3>((param_8[0] - ((param_9[0] * _e74) + (param_10[0] * _e78))), (param_8[1] - ((param_9[1] * _e74) + (param_10[1] * _e78))), (param_8[2] - ((param_9[2] * _e74) + (param_10[2] * _e78))));
            phi_421_ = false;
        } else {
            phi_420_ = array<f32, 3>();
            phi_421_ = true;
        }
        let _e129 = phi_420_;
        let _e131 = phi_421_;
        phi_422_ = _e129;
        phi_423_ = _e131;
    } else {
        phi_422_ = array<f32, 3>();
        phi_423_ = true;
    }
    let _e133 = phi_422_;
    let _e135 = phi_423_;
    if _e135 {
        let _e136 = function_2(param_8, param_9, param_10, param_11);
        phi_428_ = _e136;
    } else {
        phi_428_ = _e133;
    }
    let _e138 = phi_428_;
    return _e138;
}

fn function_4(param_12: f32) -> array<u32, 2> {
    let _e7 = bitcast<u32>(param_12);
    let _e8 = (_e7 & 2147483647u);
    let _e9 = (_e8 < 8388608u);
    return array<u32, 2>(select((_e7 << bitcast<u32>(29i)), 0u, _e9), select(((_e7 ^ _e8) | ((_e8 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e9));
}

fn function_5(param_13: ptr<function, type_38>, param_14: f32, param_15: f32, param_16: f32) -> bool {
    var phi_14908_: bool;
    var phi_14909_: bool;
    var phi_14914_: bool;

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
            phi_14908_ = select(bool(), ((_e43 > 0f) == (_e69 > 0f)), _e84);
            phi_14909_ = select(true, false, _e84);
        } else {
            phi_14908_ = bool();
            phi_14909_ = true;
        }
        let _e91 = phi_14908_;
        let _e93 = phi_14909_;
        phi_14914_ = select(_e91, false, _e93);
    } else {
        phi_14914_ = false;
    }
    let _e96 = phi_14914_;
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

fn function_12(param_36: u32) -> type_9 {
    return type_9(0u, param_36);
}

fn function_13(param_37: u32, param_38: u32) -> type_9 {
    let _e4 = (param_38 + param_38);
    let _e9 = (_e4 + param_38);
    return type_9(((((param_37 + param_37) + select(0u, 1u, (_e4 < param_38))) + param_37) + select(0u, 1u, (_e9 < _e4))), _e9);
}

fn function_14(param_39: array<u32, 2>, param_40: i32) -> type_9 {
    var phi_14400_: type_9;
    var phi_14401_: type_9;
    var phi_14402_: type_9;
    var phi_14403_: type_9;
    var phi_14404_: type_9;
    var phi_14405_: bool;

    let _e24 = ((param_39[1] >> bitcast<u32>(20i)) & 2047u);
    let _e28 = ((param_39[1] & 1048575u) | select(1048576u, 0u, (_e24 == 0u)));
    let _e33 = ((bitcast<i32>(select(1u, _e24, (1u < _e24))) - 1015i) - param_40);
    let _e35 = (bitcast<u32>(_e33) % 32u);
    if (_e33 >= 64i) {
        phi_14404_ = type_9();
        phi_14405_ = true;
    } else {
        let _e37 = (_e33 <= -53i);
        if _e37 {
            phi_14403_ = type_9();
        } else {
            if (_e33 >= 32i) {
                phi_14402_ = type_9((param_39[0] << bitcast<u32>((_e35 & 31u))), 0u);
            } else {
                if (_e33 >= 0i) {
                    phi_14401_ = type_9(((_e28 << bitcast<u32>((_e35 & 31u))) | ((param_39[0] >> bitcast<u32>(1i)) >> bitcast<u32>(((31u - _e35) & 31u)))), (param_39[0] << bitcast<u32>((_e35 & 31u))));
                } else {
                    if (_e33 > -32i) {
                        let _e49 = bitcast<u32>(-(_e33));
                        phi_14400_ = type_9(bitcast<u32>((bitcast<i32>(_e28) >> bitcast<u32>((_e49 & 31u)))), ((param_39[0] >> bitcast<u32>((_e49 & 31u))) | ((_e28 << bitcast<u32>(((31u - _e49) & 31u))) << bitcast<u32>(1i))));
                    } else {
                        phi_14400_ = type_9(0u, (_e28 >> bitcast<u32>(((bitcast<u32>(-(_e33)) - 32u) & 31u))));
                    }
                    let _e67 = phi_14400_;
                    phi_14401_ = _e67;
                }
                let _e83 = phi_14401_;
                phi_14402_ = _e83;
            }
            let _e89 = phi_14402_;
            phi_14403_ = _e89;
        }
        let _e91 = phi_14403_;
        phi_14404_ = _e91;
        phi_14405_ = _e37;
    }
    let _e93 = phi_14404_;
    let _e95 = phi_14405_;
    let _e97 = select(_e93.member, 0u, _e95);
    let _e99 = select(_e93.member_1, 0u, _e95);
    let _e102 = ((param_39[1] >> bitcast<u32>(31i)) != 0u);
    return type_9(select(_e97, (~(_e97) + select(0u, 1u, (_e99 == 0u))), _e102), select(_e99, (~(_e99) + 1u), _e102));
}

fn function_15(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_29;
    var local_1: type_29;
    var local_2: type_21;
    var local_3: type_21;
    var local_4: type_21;
    var local_5: array<type_16, 4>;
    var local_6: array<f32, 4>;
    var local_7: array<f32, 2>;
    var local_8: type_38;
    var local_9: array<f32, 4>;
    var local_10: type_28;
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
    var local_39: array<type_9, 3>;
    var local_40: array<type_9, 3>;
    var local_41: array<type_9, 3>;
    var local_42: array<u32, 4>;
    var local_43: array<array<f32, 3>, 4>;
    var local_44: array<array<f32, 3>, 4>;
    var phi_917_: u32;
    var phi_962_: u32;
    var phi_965_: type_9;
    var phi_1125_: type_22;
    var phi_1539_: type_28;
    var phi_3247_: array<array<array<type_9, 3>, 2>, 4>;
    var phi_3794_: array<array<array<type_9, 3>, 2>, 3>;
    var phi_5089_: type_9;
    var phi_5092_: array<type_9, 4>;
    var phi_5096_: u32;
    var phi_5098_: u32;
    var phi_5318_: bool;
    var phi_5447_: u32;
    var phi_6596_: array<type_9, 2>;
    var phi_6625_: array<type_9, 2>;
    var phi_6654_: array<type_9, 2>;
    var phi_6668_: type_9;
    var phi_6990_: type_9;
    var phi_6991_: type_9;
    var phi_6992_: type_9;
    var phi_6993_: type_9;
    var phi_7107_: bool;
    var phi_7108_: bool;
    var phi_7109_: bool;
    var phi_7114_: u32;
    var phi_7115_: u32;
    var phi_7116_: bool;
    var phi_7117_: u32;
    var phi_7118_: bool;
    var phi_7119_: u32;
    var phi_7120_: bool;
    var phi_7125_: u32;
    var phi_7137_: bool;
    var phi_7138_: bool;
    var phi_7139_: bool;
    var phi_7140_: u32;
    var phi_7141_: u32;
    var phi_7142_: bool;
    var phi_7477_: array<type_9, 4>;
    var phi_7478_: u32;
    var phi_7479_: array<type_9, 4>;
    var phi_7481_: u32;
    var phi_7482_: u32;
    var phi_7483_: array<type_9, 4>;
    var phi_7485_: u32;
    var phi_7486_: u32;
    var phi_7487_: array<type_9, 4>;
    var phi_7489_: bool;
    var phi_7490_: u32;
    var phi_7491_: u32;
    var phi_7492_: bool;
    var phi_7493_: bool;
    var phi_7494_: u32;
    var phi_7495_: u32;
    var phi_7496_: bool;
    var phi_7791_: array<type_9, 4>;
    var phi_7792_: array<type_9, 4>;
    var phi_7793_: u32;
    var phi_7794_: u32;
    var phi_7795_: bool;
    var phi_7800_: array<type_9, 4>;
    var phi_7801_: u32;
    var phi_7802_: u32;
    var phi_7803_: bool;
    var phi_7804_: bool;
    var phi_7805_: bool;
    var phi_7806_: array<type_9, 4>;
    var phi_7808_: u32;
    var phi_7809_: u32;
    var phi_7810_: bool;
    var phi_7811_: bool;
    var phi_7812_: u32;
    var phi_7813_: u32;
    var phi_7814_: bool;
    var phi_7815_: bool;
    var phi_7816_: bool;
    var phi_5093_: array<type_9, 4>;
    var phi_5097_: u32;
    var phi_5099_: u32;
    var phi_7817_: u32;
    var phi_7818_: bool;
    var phi_7819_: bool;
    var phi_7820_: u32;
    var phi_7821_: u32;
    var phi_7822_: bool;
    var phi_7823_: bool;
    var phi_7824_: bool;
    var phi_7825_: bool;
    var phi_7826_: bool;
    var local_45: bool;
    var local_46: bool;
    var local_47: bool;
    var local_48: bool;
    var local_49: bool;
    var local_50: bool;
    var local_51: bool;
    var local_52: bool;
    var local_53: bool;
    var local_54: bool;
    var local_55: u32;
    var local_56: array<type_9, 4>;
    var local_57: array<type_9, 4>;
    var local_58: array<type_9, 4>;
    var local_59: u32;
    var local_60: u32;
    var local_61: u32;
    var local_62: u32;
    var local_63: u32;
    var local_64: u32;
    var local_65: u32;
    var local_66: u32;
    var local_67: u32;
    var local_68: u32;
    var local_69: u32;
    var local_70: u32;
    var local_71: u32;
    var phi_8201_: bool;
    var phi_8202_: bool;
    var phi_8203_: bool;
    var phi_8204_: bool;
    var local_72: bool;
    var local_73: u32;
    var local_74: u32;
    var local_75: u32;
    var local_76: u32;
    var phi_8236_: type_9;
    var phi_8237_: bool;
    var phi_8238_: bool;
    var phi_8278_: array<u32, 2>;
    var phi_8284_: type_35;
    var phi_8291_: type_35;
    var phi_8292_: bool;
    var phi_8293_: type_35;
    var phi_8294_: bool;
    var phi_8565_: bool;
    var phi_8659_: type_33;
    var phi_8660_: bool;
    var phi_8661_: type_33;
    var phi_8662_: bool;
    var phi_8663_: type_33;
    var phi_8664_: bool;
    var phi_8669_: type_33;
    var phi_9394_: bool;
    var phi_9406_: f32;
    var phi_9477_: type_14;
    var phi_9480_: f32;
    var phi_9478_: type_14;
    var phi_9521_: type_15;
    var phi_9481_: f32;
    var local_77: f32;
    var phi_9534_: f32;
    var phi_9565_: type_9;
    var phi_9568_: u32;
    var phi_9635_: u32;
    var phi_9636_: u32;
    var phi_9569_: u32;
    var phi_9637_: u32;
    var phi_9693_: type_9;
    var phi_9849_: type_46;
    var phi_9850_: bool;
    var phi_9851_: type_46;
    var phi_9852_: bool;
    var phi_9883_: type_9;
    var phi_9886_: f32;
    var phi_9888_: f32;
    var phi_9890_: f32;
    var phi_10000_: bool;
    var phi_10007_: f32;
    var phi_10008_: bool;
    var phi_9887_: f32;
    var phi_9889_: f32;
    var phi_9891_: f32;
    var phi_10009_: f32;
    var phi_10010_: bool;
    var phi_10011_: bool;
    var local_78: bool;
    var local_79: f32;
    var local_80: f32;
    var phi_10016_: f32;
    var phi_10032_: type_9;
    var phi_10035_: f32;
    var phi_10100_: f32;
    var phi_10101_: bool;
    var phi_10102_: bool;
    var phi_10103_: bool;
    var phi_10104_: f32;
    var phi_10036_: f32;
    var phi_10105_: bool;
    var phi_10106_: bool;
    var phi_10107_: bool;
    var phi_10108_: bool;
    var local_81: bool;
    var local_82: bool;
    var local_83: bool;
    var local_84: bool;
    var local_85: f32;
    var phi_10122_: f32;
    var phi_10124_: type_46;
    var phi_10849_: u32;
    var phi_10850_: u32;
    var phi_11111_: array<type_16, 4>;
    var phi_11131_: type_9;
    var phi_11134_: bool;
    var phi_11135_: bool;
    var phi_11186_: bool;
    var phi_11187_: bool;
    var local_86: bool;
    var local_87: bool;
    var phi_11201_: u32;
    var phi_11202_: u32;
    var phi_11203_: bool;
    var phi_11234_: bool;
    var phi_11235_: bool;
    var phi_11236_: bool;
    var phi_11237_: bool;
    var phi_11238_: bool;
    var phi_11239_: bool;
    var phi_11240_: bool;
    var phi_11241_: bool;
    var phi_11242_: bool;
    var phi_11243_: bool;
    var phi_11244_: bool;
    var phi_11245_: bool;
    var phi_11246_: type_46;
    var phi_11247_: bool;
    var phi_11248_: type_46;
    var phi_11249_: bool;
    var phi_11250_: bool;
    var phi_11251_: bool;
    var phi_11252_: bool;
    var phi_11253_: type_46;
    var phi_11254_: bool;
    var phi_11255_: type_46;
    var phi_11256_: bool;
    var phi_11257_: bool;
    var phi_11258_: bool;
    var phi_11259_: bool;
    var phi_11260_: bool;
    var phi_11268_: type_46;
    var phi_11269_: bool;
    var phi_11270_: type_46;
    var phi_11271_: bool;
    var phi_11272_: bool;
    var phi_11273_: bool;
    var phi_11274_: bool;
    var phi_11275_: bool;
    var phi_11698_: type_9;
    var phi_11701_: f32;
    var phi_11703_: f32;
    var phi_11705_: f32;
    var phi_11707_: f32;
    var phi_11709_: bool;
    var phi_11711_: u32;
    var phi_11862_: array<f32, 3>;
    var phi_11928_: type_14;
    var phi_11931_: f32;
    var phi_11929_: type_14;
    var phi_11972_: type_15;
    var phi_11932_: f32;
    var local_88: f32;
    var phi_11985_: f32;
    var phi_12108_: type_29;
    var phi_12109_: bool;
    var phi_12110_: type_29;
    var phi_12111_: bool;
    var phi_12119_: type_29;
    var phi_12290_: bool;
    var phi_12291_: bool;
    var phi_12292_: bool;
    var phi_12293_: bool;
    var phi_12294_: bool;
    var phi_12295_: bool;
    var phi_12596_: bool;
    var phi_12597_: bool;
    var phi_12598_: bool;
    var phi_12599_: bool;
    var phi_12600_: bool;
    var phi_12601_: bool;
    var phi_12609_: bool;
    var phi_12716_: f32;
    var phi_12717_: bool;
    var phi_12718_: f32;
    var phi_12719_: bool;
    var phi_12720_: f32;
    var phi_12721_: bool;
    var phi_12722_: bool;
    var phi_12784_: f32;
    var phi_12785_: bool;
    var phi_12786_: f32;
    var phi_12787_: bool;
    var phi_12788_: f32;
    var phi_12789_: bool;
    var phi_12790_: bool;
    var phi_12857_: f32;
    var phi_12858_: bool;
    var phi_12859_: f32;
    var phi_12860_: bool;
    var phi_12861_: f32;
    var phi_12862_: bool;
    var phi_12863_: bool;
    var phi_12925_: f32;
    var phi_12926_: bool;
    var phi_12927_: f32;
    var phi_12928_: bool;
    var phi_12929_: f32;
    var phi_12930_: bool;
    var phi_12931_: bool;
    var phi_13460_: f32;
    var phi_13461_: f32;
    var phi_13462_: bool;
    var phi_13464_: f32;
    var phi_13465_: f32;
    var phi_13466_: f32;
    var phi_13468_: bool;
    var phi_13469_: bool;
    var phi_13471_: bool;
    var phi_13472_: f32;
    var phi_13473_: f32;
    var phi_13474_: f32;
    var phi_13476_: bool;
    var phi_13477_: bool;
    var phi_13478_: bool;
    var phi_13480_: bool;
    var phi_13481_: f32;
    var phi_13482_: f32;
    var phi_13483_: f32;
    var phi_13485_: bool;
    var phi_13486_: bool;
    var phi_13487_: bool;
    var phi_13489_: bool;
    var phi_13822_: f32;
    var phi_13824_: u32;
    var phi_13825_: f32;
    var phi_13826_: bool;
    var phi_13827_: bool;
    var phi_13828_: bool;
    var phi_13829_: u32;
    var phi_13830_: f32;
    var phi_13831_: f32;
    var phi_13832_: f32;
    var phi_13833_: f32;
    var phi_13834_: bool;
    var phi_13835_: u32;
    var phi_13836_: bool;
    var phi_13837_: bool;
    var phi_13838_: bool;
    var phi_13839_: bool;
    var phi_13841_: bool;
    var phi_13869_: f32;
    var phi_13870_: f32;
    var phi_13871_: f32;
    var phi_13872_: f32;
    var phi_13873_: bool;
    var phi_13874_: u32;
    var phi_13875_: bool;
    var phi_13876_: bool;
    var phi_13877_: bool;
    var phi_13878_: bool;
    var phi_13880_: bool;
    var phi_11702_: f32;
    var phi_11704_: f32;
    var phi_11706_: f32;
    var phi_11708_: f32;
    var phi_11710_: bool;
    var phi_11712_: u32;
    var phi_13881_: f32;
    var phi_13883_: bool;
    var phi_13884_: bool;
    var phi_13885_: bool;
    var phi_13886_: bool;
    var phi_13888_: bool;
    var phi_13889_: bool;
    var local_89: bool;
    var local_90: bool;
    var local_91: bool;
    var local_92: bool;
    var local_93: bool;
    var local_94: bool;
    var local_95: bool;
    var local_96: bool;
    var local_97: f32;
    var local_98: bool;
    var local_99: f32;
    var local_100: f32;
    var phi_13957_: f32;
    var phi_13958_: bool;
    var phi_13959_: bool;
    var phi_13960_: bool;
    var phi_13961_: bool;
    var phi_13962_: bool;
    var phi_13963_: type_46;
    var phi_13964_: bool;
    var phi_13965_: f32;
    var phi_13966_: type_46;
    var phi_13967_: bool;
    var phi_13968_: bool;
    var phi_13969_: bool;
    var phi_13970_: bool;
    var phi_13971_: bool;
    var phi_13972_: bool;
    var local_101: bool;
    var local_102: bool;
    var local_103: type_46;
    var local_104: f32;
    var local_105: f32;
    var phi_13988_: type_34;
    var phi_13989_: bool;
    var local_106: f32;
    var phi_13995_: type_34;
    var phi_13996_: bool;
    var phi_13997_: bool;
    var phi_13998_: bool;
    var phi_13999_: bool;
    var local_107: bool;
    var local_108: type_46;
    var phi_14041_: type_34;
    var phi_14042_: type_34;
    var phi_14043_: bool;
    var phi_14087_: type_35;
    var phi_14127_: bool;
    var phi_14143_: bool;
    var phi_14162_: type_35;
    var phi_14194_: u32;
    var phi_14198_: type_18;
    var phi_14199_: bool;
    var phi_14200_: bool;
    var phi_14219_: u32;
    var phi_14286_: u32;
    var local_109: u32;
    var local_110: bool;
    var local_111: bool;
    var local_112: bool;
    var local_113: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e157 = id_2;
    let _e158 = n_2;
    let _e159 = lane_2;
    let _e172 = ((_e157.y * _e158.x) + _e157.x);
    let _e175 = (_e158.x * _e158.y);
    let _e178 = params.member.member_1.member_2;
    let _e180 = input.member[0u];
    let _e182 = select(_e180, _e178, (_e178 < _e180));
    let _e184 = params.member.member_1.member_1;
    if (_e182 > _e184) {
        let _e187 = params.member.member_1.member_1;
        phi_917_ = (_e182 - _e187);
    } else {
        phi_917_ = 0u;
    }
    let _e190 = phi_917_;
    let _e192 = params.member.member_1.member;
    let _e194 = select(_e190, _e192, (_e192 < _e190));
    let _e195 = (_e194 / 64u);
    let _e199 = select(_e195, (_e195 + 1u), ((_e194 % 64u) > 0u));
    if (_e199 > _e172) {
        let _e201 = (_e199 - _e172);
        if (_e175 == 0u) {
            return;
        }
        let _e203 = (_e201 / _e175);
        if (_e175 == 0u) {
            return;
        }
        phi_962_ = select(_e203, (_e203 + 1u), ((_e201 % _e175) > 0u));
    } else {
        phi_962_ = 0u;
    }
    let _e210 = phi_962_;
    phi_965_ = type_9(0u, _e210);
    loop {
        let _e213 = phi_965_;
        let _e216 = (_e213.member < _e213.member_1);
        let _e229 = (bitcast<i32>(select(0u, 1u, _e216)) != 0i);
        if _e229 {
            let _e233 = (((_e172 + (select(type_9().member_1, _e213.member, _e216) * _e175)) * 64u) + _e159);
            let _e237 = params.member.member_2.member.member;
            if (_e233 < _e194) {
                let _e242 = params.member.member_1.member_1;
                let _e244 = (2u * (_e242 + _e233));
                let _e247 = input.member[(4u + _e244)];
                let _e250 = input.member[(_e244 + 5u)];
                let _e255 = params.member.member_2.member.member;
                if (_e255 == 0u) {
                    let _e271 = (3u * _e250);
                    let _e273 = elements.member[_e271];
                    let _e276 = elements.member[(_e271 + 1u)];
                    let _e279 = elements.member[(_e271 + 2u)];
                    phi_1125_ = type_22(0u, array<u32, 4>(_e247, _e273, _e276, _e279));
                } else {
                    let _e257 = (2u * _e247);
                    let _e258 = (2u * _e250);
                    let _e260 = elements.member[_e257];
                    let _e262 = elements.member[_e258];
                    let _e265 = elements.member[(_e257 + 1u)];
                    let _e268 = elements.member[(_e258 + 1u)];
                    phi_1125_ = type_22(1u, array<u32, 4>(_e260, _e265, _e262, _e268));
                }
                let _e283 = phi_1125_;
                local_42 = array<u32, 4>(_e283.member_1[0], _e283.member_1[1], _e283.member_1[2], _e283.member_1[3]);
                let _e292 = paths.member[_e283.member_1[0]];
                let _e306 = paths.member[_e283.member_1[1]];
                let _e320 = paths.member[_e283.member_1[2]];
                let _e334 = paths.member[_e283.member_1[3]];
                local_43 = array<array<f32, 3>, 4>(array<f32, 3>(_e292.member.x, _e292.member.y, _e292.member.z), array<f32, 3>(_e306.member.x, _e306.member.y, _e306.member.z), array<f32, 3>(_e320.member.x, _e320.member.y, _e320.member.z), array<f32, 3>(_e334.member.x, _e334.member.y, _e334.member.z));
                local_44 = array<array<f32, 3>, 4>(array<f32, 3>(_e292.member_1.x, _e292.member_1.y, _e292.member_1.z), array<f32, 3>(_e306.member_1.x, _e306.member_1.y, _e306.member_1.z), array<f32, 3>(_e320.member_1.x, _e320.member_1.y, _e320.member_1.z), array<f32, 3>(_e334.member_1.x, _e334.member_1.y, _e334.member_1.z));
                let _e358 = params.member.member.member_4;
                if (_e283.member != 0u) {
                    let _e449 = local_43;
                    let _e454 = local_43;
                    let _e463 = local_44;
                    let _e468 = local_44;
                    let _e478 = local_43;
                    let _e483 = local_43;
                    let _e492 = local_44;
                    let _e497 = local_44;
                    let _e507 = local_43;
                    let _e512 = local_43;
                    let _e521 = local_44;
                    let _e526 = local_44;
                    phi_1539_ = type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e449[2][0] - _e454[0][0]), (_e449[2][1] - _e454[0][1]), (_e449[2][2] - _e454[0][2])), array<f32, 3>((_e463[2][0] - _e468[0][0]), (_e463[2][1] - _e468[0][1]), (_e463[2][2] - _e468[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e478[1][0] - _e483[0][0]), (_e478[1][1] - _e483[0][1]), (_e478[1][2] - _e483[0][2])), array<f32, 3>((_e492[1][0] - _e497[0][0]), (_e492[1][1] - _e497[0][1]), (_e492[1][2] - _e497[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e507[2][0] - _e512[3][0]), (_e507[2][1] - _e512[3][1]), (_e507[2][2] - _e512[3][2])), array<f32, 3>((_e521[2][0] - _e526[3][0]), (_e521[2][1] - _e526[3][1]), (_e521[2][2] - _e526[3][2]))), (_e358 + _e358));
                } else {
                    let _e360 = local_43;
                    let _e365 = local_43;
                    let _e374 = local_44;
                    let _e379 = local_44;
                    let _e389 = local_43;
                    let _e394 = local_43;
                    let _e403 = local_44;
                    let _e408 = local_44;
                    let _e418 = local_43;
                    let _e423 = local_43;
                    let _e432 = local_44;
                    let _e437 = local_44;
                    phi_1539_ = type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e360[0][0] - _e365[1][0]), (_e360[0][1] - _e365[1][1]), (_e360[0][2] - _e365[1][2])), array<f32, 3>((_e374[0][0] - _e379[1][0]), (_e374[0][1] - _e379[1][1]), (_e374[0][2] - _e379[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e389[2][0] - _e394[1][0]), (_e389[2][1] - _e394[1][1]), (_e389[2][2] - _e394[1][2])), array<f32, 3>((_e403[2][0] - _e408[1][0]), (_e403[2][1] - _e408[1][1]), (_e403[2][2] - _e408[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e418[3][0] - _e423[1][0]), (_e418[3][1] - _e423[1][1]), (_e418[3][2] - _e423[1][2])), array<f32, 3>((_e432[3][0] - _e437[1][0]), (_e432[3][1] - _e437[1][1]), (_e432[3][2] - _e437[1][2]))), (_e358 + _e358));
                }
                let _e539 = phi_1539_;
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
                let _e660 = function_((select(_e575, _e557, (_e557 > _e575)) + _e539.member_3), (select(_e615, _e597, (_e597 > _e615)) + _e539.member_3));
                let _e661 = function_(_e660, (select(_e655, _e637, (_e637 > _e655)) + _e539.member_3));
                let _e666 = bitcast<i32>(((bitcast<u32>(_e661) + 4u) >> bitcast<u32>(23i)));
                let _e667 = (_e666 >= 64i);
                let _e668 = (_e666 <= 190i);
                let _e674 = select(select(i32(), select(i32(), (_e666 - 126i), _e668), _e667), 2147483647i, select(true, select(true, false, _e668), _e667));
                let _e676 = params.member.member_2.member_3;
                if (_e676 > 0u) {
                    if (_e674 != 2147483647i) {
                        let _e680 = params.member.member.member_1;
                        if ((_e680 & 8u) != 0u) {
                            let _e920 = local_43;
                            let _e925 = bitcast<u32>(_e920[0][0]);
                            let _e926 = (_e925 & 2147483647u);
                            let _e927 = (_e926 < 8388608u);
                            let _e938 = function_14(array<u32, 2>(select((_e925 << bitcast<u32>(29i)), 0u, _e927), select(((_e925 ^ _e926) | ((_e926 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e927)), _e674);
                            let _e939 = bitcast<u32>(_e920[0][1]);
                            let _e940 = (_e939 & 2147483647u);
                            let _e941 = (_e940 < 8388608u);
                            let _e952 = function_14(array<u32, 2>(select((_e939 << bitcast<u32>(29i)), 0u, _e941), select(((_e939 ^ _e940) | ((_e940 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e941)), _e674);
                            let _e953 = bitcast<u32>(_e920[0][2]);
                            let _e954 = (_e953 & 2147483647u);
                            let _e955 = (_e954 < 8388608u);
                            let _e966 = function_14(array<u32, 2>(select((_e953 << bitcast<u32>(29i)), 0u, _e955), select(((_e953 ^ _e954) | ((_e954 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e955)), _e674);
                            let _e968 = local_44;
                            let _e973 = bitcast<u32>(_e968[0][0]);
                            let _e974 = (_e973 & 2147483647u);
                            let _e975 = (_e974 < 8388608u);
                            let _e986 = function_14(array<u32, 2>(select((_e973 << bitcast<u32>(29i)), 0u, _e975), select(((_e973 ^ _e974) | ((_e974 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e975)), _e674);
                            let _e987 = bitcast<u32>(_e968[0][1]);
                            let _e988 = (_e987 & 2147483647u);
                            let _e989 = (_e988 < 8388608u);
                            let _e1000 = function_14(array<u32, 2>(select((_e987 << bitcast<u32>(29i)), 0u, _e989), select(((_e987 ^ _e988) | ((_e988 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e989)), _e674);
                            let _e1001 = bitcast<u32>(_e968[0][2]);
                            let _e1002 = (_e1001 & 2147483647u);
                            let _e1003 = (_e1002 < 8388608u);
                            let _e1014 = function_14(array<u32, 2>(select((_e1001 << bitcast<u32>(29i)), 0u, _e1003), select(((_e1001 ^ _e1002) | ((_e1002 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1003)), _e674);
                            let _e1017 = local_43;
                            let _e1022 = bitcast<u32>(_e1017[1][0]);
                            let _e1023 = (_e1022 & 2147483647u);
                            let _e1024 = (_e1023 < 8388608u);
                            let _e1035 = function_14(array<u32, 2>(select((_e1022 << bitcast<u32>(29i)), 0u, _e1024), select(((_e1022 ^ _e1023) | ((_e1023 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1024)), _e674);
                            let _e1036 = bitcast<u32>(_e1017[1][1]);
                            let _e1037 = (_e1036 & 2147483647u);
                            let _e1038 = (_e1037 < 8388608u);
                            let _e1049 = function_14(array<u32, 2>(select((_e1036 << bitcast<u32>(29i)), 0u, _e1038), select(((_e1036 ^ _e1037) | ((_e1037 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1038)), _e674);
                            let _e1050 = bitcast<u32>(_e1017[1][2]);
                            let _e1051 = (_e1050 & 2147483647u);
                            let _e1052 = (_e1051 < 8388608u);
                            let _e1063 = function_14(array<u32, 2>(select((_e1050 << bitcast<u32>(29i)), 0u, _e1052), select(((_e1050 ^ _e1051) | ((_e1051 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1052)), _e674);
                            let _e1065 = local_44;
                            let _e1070 = bitcast<u32>(_e1065[1][0]);
                            let _e1071 = (_e1070 & 2147483647u);
                            let _e1072 = (_e1071 < 8388608u);
                            let _e1083 = function_14(array<u32, 2>(select((_e1070 << bitcast<u32>(29i)), 0u, _e1072), select(((_e1070 ^ _e1071) | ((_e1071 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1072)), _e674);
                            let _e1084 = bitcast<u32>(_e1065[1][1]);
                            let _e1085 = (_e1084 & 2147483647u);
                            let _e1086 = (_e1085 < 8388608u);
                            let _e1097 = function_14(array<u32, 2>(select((_e1084 << bitcast<u32>(29i)), 0u, _e1086), select(((_e1084 ^ _e1085) | ((_e1085 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1086)), _e674);
                            let _e1098 = bitcast<u32>(_e1065[1][2]);
                            let _e1099 = (_e1098 & 2147483647u);
                            let _e1100 = (_e1099 < 8388608u);
                            let _e1111 = function_14(array<u32, 2>(select((_e1098 << bitcast<u32>(29i)), 0u, _e1100), select(((_e1098 ^ _e1099) | ((_e1099 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1100)), _e674);
                            let _e1114 = local_43;
                            let _e1119 = bitcast<u32>(_e1114[2][0]);
                            let _e1120 = (_e1119 & 2147483647u);
                            let _e1121 = (_e1120 < 8388608u);
                            let _e1132 = function_14(array<u32, 2>(select((_e1119 << bitcast<u32>(29i)), 0u, _e1121), select(((_e1119 ^ _e1120) | ((_e1120 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1121)), _e674);
                            let _e1133 = bitcast<u32>(_e1114[2][1]);
                            let _e1134 = (_e1133 & 2147483647u);
                            let _e1135 = (_e1134 < 8388608u);
                            let _e1146 = function_14(array<u32, 2>(select((_e1133 << bitcast<u32>(29i)), 0u, _e1135), select(((_e1133 ^ _e1134) | ((_e1134 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1135)), _e674);
                            let _e1147 = bitcast<u32>(_e1114[2][2]);
                            let _e1148 = (_e1147 & 2147483647u);
                            let _e1149 = (_e1148 < 8388608u);
                            let _e1160 = function_14(array<u32, 2>(select((_e1147 << bitcast<u32>(29i)), 0u, _e1149), select(((_e1147 ^ _e1148) | ((_e1148 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1149)), _e674);
                            let _e1162 = local_44;
                            let _e1167 = bitcast<u32>(_e1162[2][0]);
                            let _e1168 = (_e1167 & 2147483647u);
                            let _e1169 = (_e1168 < 8388608u);
                            let _e1180 = function_14(array<u32, 2>(select((_e1167 << bitcast<u32>(29i)), 0u, _e1169), select(((_e1167 ^ _e1168) | ((_e1168 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1169)), _e674);
                            let _e1181 = bitcast<u32>(_e1162[2][1]);
                            let _e1182 = (_e1181 & 2147483647u);
                            let _e1183 = (_e1182 < 8388608u);
                            let _e1194 = function_14(array<u32, 2>(select((_e1181 << bitcast<u32>(29i)), 0u, _e1183), select(((_e1181 ^ _e1182) | ((_e1182 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1183)), _e674);
                            let _e1195 = bitcast<u32>(_e1162[2][2]);
                            let _e1196 = (_e1195 & 2147483647u);
                            let _e1197 = (_e1196 < 8388608u);
                            let _e1208 = function_14(array<u32, 2>(select((_e1195 << bitcast<u32>(29i)), 0u, _e1197), select(((_e1195 ^ _e1196) | ((_e1196 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1197)), _e674);
                            let _e1211 = local_43;
                            let _e1216 = bitcast<u32>(_e1211[3][0]);
                            let _e1217 = (_e1216 & 2147483647u);
                            let _e1218 = (_e1217 < 8388608u);
                            let _e1229 = function_14(array<u32, 2>(select((_e1216 << bitcast<u32>(29i)), 0u, _e1218), select(((_e1216 ^ _e1217) | ((_e1217 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1218)), _e674);
                            let _e1230 = bitcast<u32>(_e1211[3][1]);
                            let _e1231 = (_e1230 & 2147483647u);
                            let _e1232 = (_e1231 < 8388608u);
                            let _e1243 = function_14(array<u32, 2>(select((_e1230 << bitcast<u32>(29i)), 0u, _e1232), select(((_e1230 ^ _e1231) | ((_e1231 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1232)), _e674);
                            let _e1244 = bitcast<u32>(_e1211[3][2]);
                            let _e1245 = (_e1244 & 2147483647u);
                            let _e1246 = (_e1245 < 8388608u);
                            let _e1257 = function_14(array<u32, 2>(select((_e1244 << bitcast<u32>(29i)), 0u, _e1246), select(((_e1244 ^ _e1245) | ((_e1245 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1246)), _e674);
                            let _e1259 = local_44;
                            let _e1264 = bitcast<u32>(_e1259[3][0]);
                            let _e1265 = (_e1264 & 2147483647u);
                            let _e1266 = (_e1265 < 8388608u);
                            let _e1277 = function_14(array<u32, 2>(select((_e1264 << bitcast<u32>(29i)), 0u, _e1266), select(((_e1264 ^ _e1265) | ((_e1265 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1266)), _e674);
                            let _e1278 = bitcast<u32>(_e1259[3][1]);
                            let _e1279 = (_e1278 & 2147483647u);
                            let _e1280 = (_e1279 < 8388608u);
                            let _e1291 = function_14(array<u32, 2>(select((_e1278 << bitcast<u32>(29i)), 0u, _e1280), select(((_e1278 ^ _e1279) | ((_e1279 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1280)), _e674);
                            let _e1292 = bitcast<u32>(_e1259[3][2]);
                            let _e1293 = (_e1292 & 2147483647u);
                            let _e1294 = (_e1293 < 8388608u);
                            let _e1305 = function_14(array<u32, 2>(select((_e1292 << bitcast<u32>(29i)), 0u, _e1294), select(((_e1292 ^ _e1293) | ((_e1293 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1294)), _e674);
                            phi_3247_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e938, _e952, _e966), array<type_9, 3>(_e986, _e1000, _e1014)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1035, _e1049, _e1063), array<type_9, 3>(_e1083, _e1097, _e1111)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1132, _e1146, _e1160), array<type_9, 3>(_e1180, _e1194, _e1208)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1229, _e1243, _e1257), array<type_9, 3>(_e1277, _e1291, _e1305)));
                        } else {
                            let _e685 = params.member.member.member_10[1u];
                            let _e690 = (_e674 - (bitcast<i32>((_e685 >> bitcast<u32>(20i))) - 1023i));
                            let _e691 = local_42;
                            let _e695 = params.member.member.member[0u];
                            let _e697 = (6u * (_e695 + _e691[0]));
                            let _e698 = (6u * _e691[0]);
                            let _e700 = positions.member[_e698];
                            let _e703 = positions.member[(_e698 + 1u)];
                            let _e705 = function_14(array<u32, 2>(_e700, _e703), _e690);
                            let _e708 = positions.member[(_e698 + 2u)];
                            let _e711 = positions.member[(_e698 + 3u)];
                            let _e713 = function_14(array<u32, 2>(_e708, _e711), _e690);
                            let _e716 = positions.member[(_e698 + 4u)];
                            let _e719 = positions.member[(_e698 + 5u)];
                            let _e721 = function_14(array<u32, 2>(_e716, _e719), _e690);
                            let _e724 = positions.member[_e697];
                            let _e727 = positions.member[(_e697 + 1u)];
                            let _e729 = function_14(array<u32, 2>(_e724, _e727), _e690);
                            let _e732 = positions.member[(_e697 + 2u)];
                            let _e735 = positions.member[(_e697 + 3u)];
                            let _e737 = function_14(array<u32, 2>(_e732, _e735), _e690);
                            let _e740 = positions.member[(_e697 + 4u)];
                            let _e743 = positions.member[(_e697 + 5u)];
                            let _e745 = function_14(array<u32, 2>(_e740, _e743), _e690);
                            let _e748 = local_42;
                            let _e752 = params.member.member.member[0u];
                            let _e754 = (6u * (_e752 + _e748[1]));
                            let _e755 = (6u * _e748[1]);
                            let _e757 = positions.member[_e755];
                            let _e760 = positions.member[(_e755 + 1u)];
                            let _e762 = function_14(array<u32, 2>(_e757, _e760), _e690);
                            let _e765 = positions.member[(_e755 + 2u)];
                            let _e768 = positions.member[(_e755 + 3u)];
                            let _e770 = function_14(array<u32, 2>(_e765, _e768), _e690);
                            let _e773 = positions.member[(_e755 + 4u)];
                            let _e776 = positions.member[(_e755 + 5u)];
                            let _e778 = function_14(array<u32, 2>(_e773, _e776), _e690);
                            let _e781 = positions.member[_e754];
                            let _e784 = positions.member[(_e754 + 1u)];
                            let _e786 = function_14(array<u32, 2>(_e781, _e784), _e690);
                            let _e789 = positions.member[(_e754 + 2u)];
                            let _e792 = positions.member[(_e754 + 3u)];
                            let _e794 = function_14(array<u32, 2>(_e789, _e792), _e690);
                            let _e797 = positions.member[(_e754 + 4u)];
                            let _e800 = positions.member[(_e754 + 5u)];
                            let _e802 = function_14(array<u32, 2>(_e797, _e800), _e690);
                            let _e805 = local_42;
                            let _e809 = params.member.member.member[0u];
                            let _e811 = (6u * (_e809 + _e805[2]));
                            let _e812 = (6u * _e805[2]);
                            let _e814 = positions.member[_e812];
                            let _e817 = positions.member[(_e812 + 1u)];
                            let _e819 = function_14(array<u32, 2>(_e814, _e817), _e690);
                            let _e822 = positions.member[(_e812 + 2u)];
                            let _e825 = positions.member[(_e812 + 3u)];
                            let _e827 = function_14(array<u32, 2>(_e822, _e825), _e690);
                            let _e830 = positions.member[(_e812 + 4u)];
                            let _e833 = positions.member[(_e812 + 5u)];
                            let _e835 = function_14(array<u32, 2>(_e830, _e833), _e690);
                            let _e838 = positions.member[_e811];
                            let _e841 = positions.member[(_e811 + 1u)];
                            let _e843 = function_14(array<u32, 2>(_e838, _e841), _e690);
                            let _e846 = positions.member[(_e811 + 2u)];
                            let _e849 = positions.member[(_e811 + 3u)];
                            let _e851 = function_14(array<u32, 2>(_e846, _e849), _e690);
                            let _e854 = positions.member[(_e811 + 4u)];
                            let _e857 = positions.member[(_e811 + 5u)];
                            let _e859 = function_14(array<u32, 2>(_e854, _e857), _e690);
                            let _e862 = local_42;
                            let _e866 = params.member.member.member[0u];
                            let _e868 = (6u * (_e866 + _e862[3]));
                            let _e869 = (6u * _e862[3]);
                            let _e871 = positions.member[_e869];
                            let _e874 = positions.member[(_e869 + 1u)];
                            let _e876 = function_14(array<u32, 2>(_e871, _e874), _e690);
                            let _e879 = positions.member[(_e869 + 2u)];
                            let _e882 = positions.member[(_e869 + 3u)];
                            let _e884 = function_14(array<u32, 2>(_e879, _e882), _e690);
                            let _e887 = positions.member[(_e869 + 4u)];
                            let _e890 = positions.member[(_e869 + 5u)];
                            let _e892 = function_14(array<u32, 2>(_e887, _e890), _e690);
                            let _e895 = positions.member[_e868];
                            let _e898 = positions.member[(_e868 + 1u)];
                            let _e900 = function_14(array<u32, 2>(_e895, _e898), _e690);
                            let _e903 = positions.member[(_e868 + 2u)];
                            let _e906 = positions.member[(_e868 + 3u)];
                            let _e908 = function_14(array<u32, 2>(_e903, _e906), _e690);
                            let _e911 = positions.member[(_e868 + 4u)];
                            let _e914 = positions.member[(_e868 + 5u)];
                            let _e916 = function_14(array<u32, 2>(_e911, _e914), _e690);
                            phi_3247_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e705, _e713, _e721), array<type_9, 3>(_e729, _e737, _e745)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e762, _e770, _e778), array<type_9, 3>(_e786, _e794, _e802)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e819, _e827, _e835), array<type_9, 3>(_e843, _e851, _e859)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e876, _e884, _e892), array<type_9, 3>(_e900, _e908, _e916)));
                        }
                        let _e1310 = phi_3247_;
                        let _e1312 = params.member.member_2.member_1;
                        let _e1314 = params.member.member_2.member_2;
                        let _e1316 = params.member.member_2.member_3;
                        if (_e283.member != 0u) {
                            phi_3794_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1310[2][0][0].member - _e1310[0][0][0].member) - select(0u, 1u, (_e1310[2][0][0].member_1 < _e1310[0][0][0].member_1))), (_e1310[2][0][0].member_1 - _e1310[0][0][0].member_1)), type_9(((_e1310[2][0][1].member - _e1310[0][0][1].member) - select(0u, 1u, (_e1310[2][0][1].member_1 < _e1310[0][0][1].member_1))), (_e1310[2][0][1].member_1 - _e1310[0][0][1].member_1)), type_9(((_e1310[2][0][2].member - _e1310[0][0][2].member) - select(0u, 1u, (_e1310[2][0][2].member_1 < _e1310[0][0][2].member_1))), (_e1310[2][0][2].member_1 - _e1310[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1310[2][1][0].member - _e1310[0][1][0].member) - select(0u, 1u, (_e1310[2][1][0].member_1 < _e1310[0][1][0].member_1))), (_e1310[2][1][0].member_1 - _e1310[0][1][0].member_1)), type_9(((_e1310[2][1][1].member - _e1310[0][1][1].member) - select(0u, 1u, (_e1310[2][1][1].member_1 < _e1310[0][1][1].member_1))), (_e1310[2][1][1].member_1 - _e1310[0][1][1].member_1)), type_9(((_e1310[2][1][2].member - _e1310[0][1][2].member) - select(0u, 1u, (_e1310[2][1][2].member_1 < _e1310[0][1][2].member_1))), (_e1310[2][1][2].member_1 - _e1310[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1310[1][0][0].member - _e1310[0][0][0].member) - select(0u, 1u, (_e1310[1][0][0].member_1 < _e1310[0][0][0].member_1))), (_e1310[1][0][0].member_1 - _e1310[0][0][0].member_1)), type_9(((_e1310[1][0][1].member - _e1310[0][0][1].member) - select(0u, 1u, (_e1310[1][0][1].member_1 < _e1310[0][0][1].member_1))), (_e1310[1][0][1].member_1 - _e1310[0][0][1].member_1)), type_9(((_e1310[1][0][2].member - _e1310[0][0][2].member) - select(0u, 1u, (_e1310[1][0][2].member_1 < _e1310[0][0][2].member_1))), (_e1310[1][0][2].member_1 - _e1310[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1310[1][1][0].member - _e1310[0][1][0].member) - select(0u, 1u, (_e1310[1][1][0].member_1 < _e1310[0][1][0].member_1))), (_e1310[1][1][0].member_1 - _e1310[0][1][0].member_1)), type_9(((_e1310[1][1][1].member - _e1310[0][1][1].member) - select(0u, 1u, (_e1310[1][1][1].member_1 < _e1310[0][1][1].member_1))), (_e1310[1][1][1].member_1 - _e1310[0][1][1].member_1)), type_9(((_e1310[1][1][2].member - _e1310[0][1][2].member) - select(0u, 1u, (_e1310[1][1][2].member_1 < _e1310[0][1][2].member_1))), (_e1310[1][1][2].member_1 - _e1310[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1310[2][0][0].member - _e1310[3][0][0].member) - select(0u, 1u, (_e1310[2][0][0].member_1 < _e1310[3][0][0].member_1))), (_e1310[2][0][0].member_1 - _e1310[3][0][0].member_1)), type_9(((_e1310[2][0][1].member - _e1310[3][0][1].member) - select(0u, 1u, (_e1310[2][0][1].member_1 < _e1310[3][0][1].member_1))), (_e1310[2][0][1].member_1 - _e1310[3][0][1].member_1)), type_9(((_e1310[2][0][2].member - _e1310[3][0][2].member) - select(0u, 1u, (_e1310[2][0][2].member_1 < _e1310[3][0][2].member_1))), (_e1310[2][0][2].member_1 - _e1310[3][0][2].member_1))), array<type_9, 3>(type_9(((_e1310[2][1][0].member - _e1310[3][1][0].member) - select(0u, 1u, (_e1310[2][1][0].member_1 < _e1310[3][1][0].member_1))), (_e1310[2][1][0].member_1 - _e1310[3][1][0].member_1)), type_9(((_e1310[2][1][1].member - _e1310[3][1][1].member) - select(0u, 1u, (_e1310[2][1][1].member_1 < _e1310[3][1][1].member_1))), (_e1310[2][1][1].member_1 - _e1310[3][1][1].member_1)), type_9(((_e1310[2][1][2].member - _e1310[3][1][2].member) - select(0u, 1u, (_e1310[2][1][2].member_1 < _e1310[3][1][2].member_1))), (_e1310[2][1][2].member_1 - _e1310[3][1][2].member_1)))));
                        } else {
                            phi_3794_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1310[0][0][0].member - _e1310[1][0][0].member) - select(0u, 1u, (_e1310[0][0][0].member_1 < _e1310[1][0][0].member_1))), (_e1310[0][0][0].member_1 - _e1310[1][0][0].member_1)), type_9(((_e1310[0][0][1].member - _e1310[1][0][1].member) - select(0u, 1u, (_e1310[0][0][1].member_1 < _e1310[1][0][1].member_1))), (_e1310[0][0][1].member_1 - _e1310[1][0][1].member_1)), type_9(((_e1310[0][0][2].member - _e1310[1][0][2].member) - select(0u, 1u, (_e1310[0][0][2].member_1 < _e1310[1][0][2].member_1))), (_e1310[0][0][2].member_1 - _e1310[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1310[0][1][0].member - _e1310[1][1][0].member) - select(0u, 1u, (_e1310[0][1][0].member_1 < _e1310[1][1][0].member_1))), (_e1310[0][1][0].member_1 - _e1310[1][1][0].member_1)), type_9(((_e1310[0][1][1].member - _e1310[1][1][1].member) - select(0u, 1u, (_e1310[0][1][1].member_1 < _e1310[1][1][1].member_1))), (_e1310[0][1][1].member_1 - _e1310[1][1][1].member_1)), type_9(((_e1310[0][1][2].member - _e1310[1][1][2].member) - select(0u, 1u, (_e1310[0][1][2].member_1 < _e1310[1][1][2].member_1))), (_e1310[0][1][2].member_1 - _e1310[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1310[2][0][0].member - _e1310[1][0][0].member) - select(0u, 1u, (_e1310[2][0][0].member_1 < _e1310[1][0][0].member_1))), (_e1310[2][0][0].member_1 - _e1310[1][0][0].member_1)), type_9(((_e1310[2][0][1].member - _e1310[1][0][1].member) - select(0u, 1u, (_e1310[2][0][1].member_1 < _e1310[1][0][1].member_1))), (_e1310[2][0][1].member_1 - _e1310[1][0][1].member_1)), type_9(((_e1310[2][0][2].member - _e1310[1][0][2].member) - select(0u, 1u, (_e1310[2][0][2].member_1 < _e1310[1][0][2].member_1))), (_e1310[2][0][2].member_1 - _e1310[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1310[2][1][0].member - _e1310[1][1][0].member) - select(0u, 1u, (_e1310[2][1][0].member_1 < _e1310[1][1][0].member_1))), (_e1310[2][1][0].member_1 - _e1310[1][1][0].member_1)), type_9(((_e1310[2][1][1].member - _e1310[1][1][1].member) - select(0u, 1u, (_e1310[2][1][1].member_1 < _e1310[1][1][1].member_1))), (_e1310[2][1][1].member_1 - _e1310[1][1][1].member_1)), type_9(((_e1310[2][1][2].member - _e1310[1][1][2].member) - select(0u, 1u, (_e1310[2][1][2].member_1 < _e1310[1][1][2].member_1))), (_e1310[2][1][2].member_1 - _e1310[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1310[3][0][0].member - _e1310[1][0][0].member) - select(0u, 1u, (_e1310[3][0][0].member_1 < _e1310[1][0][0].member_1))), (_e1310[3][0][0].member_1 - _e1310[1][0][0].member_1)), type_9(((_e1310[3][0][1].member - _e1310[1][0][1].member) - select(0u, 1u, (_e1310[3][0][1].member_1 < _e1310[1][0][1].member_1))), (_e1310[3][0][1].member_1 - _e1310[1][0][1].member_1)), type_9(((_e1310[3][0][2].member - _e1310[1][0][2].member) - select(0u, 1u, (_e1310[3][0][2].member_1 < _e1310[1][0][2].member_1))), (_e1310[3][0][2].member_1 - _e1310[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1310[3][1][0].member - _e1310[1][1][0].member) - select(0u, 1u, (_e1310[3][1][0].member_1 < _e1310[1][1][0].member_1))), (_e1310[3][1][0].member_1 - _e1310[1][1][0].member_1)), type_9(((_e1310[3][1][1].member - _e1310[1][1][1].member) - select(0u, 1u, (_e1310[3][1][1].member_1 < _e1310[1][1][1].member_1))), (_e1310[3][1][1].member_1 - _e1310[1][1][1].member_1)), type_9(((_e1310[3][1][2].member - _e1310[1][1][2].member) - select(0u, 1u, (_e1310[3][1][2].member_1 < _e1310[1][1][2].member_1))), (_e1310[3][1][2].member_1 - _e1310[1][1][2].member_1)))));
                        }
                        let _e1891 = phi_3794_;
                        local_40 = array<type_9, 3>(type_9(_e1891[1][0][0].member, _e1891[1][0][0].member_1), type_9(_e1891[1][0][1].member, _e1891[1][0][1].member_1), type_9(_e1891[1][0][2].member, _e1891[1][0][2].member_1));
                        local_41 = array<type_9, 3>(type_9(_e1891[2][0][0].member, _e1891[2][0][0].member_1), type_9(_e1891[2][0][1].member, _e1891[2][0][1].member_1), type_9(_e1891[2][0][2].member, _e1891[2][0][2].member_1));
                        let _e1924 = local_40[1u].member;
                        let _e1926 = local_40[1u].member_1;
                        let _e1929 = local_41[2u].member;
                        let _e1931 = local_41[2u].member_1;
                        let _e1932 = function_10(_e1924, _e1926, _e1929, _e1931);
                        let _e1937 = local_40[2u].member;
                        let _e1939 = local_40[2u].member_1;
                        let _e1942 = local_41[1u].member;
                        let _e1944 = local_41[1u].member_1;
                        let _e1945 = function_10(_e1937, _e1939, _e1942, _e1944);
                        let _e1951 = ((_e1932.member - _e1945.member) - select(0u, 1u, (_e1932.member_1 < _e1945.member_1)));
                        let _e1952 = (_e1932.member_1 - _e1945.member_1);
                        local_38 = array<type_9, 3>(type_9(_e1891[1][0][0].member, _e1891[1][0][0].member_1), type_9(_e1891[1][0][1].member, _e1891[1][0][1].member_1), type_9(_e1891[1][0][2].member, _e1891[1][0][2].member_1));
                        local_39 = array<type_9, 3>(type_9(_e1891[2][0][0].member, _e1891[2][0][0].member_1), type_9(_e1891[2][0][1].member, _e1891[2][0][1].member_1), type_9(_e1891[2][0][2].member, _e1891[2][0][2].member_1));
                        let _e1981 = local_38[2u].member;
                        let _e1983 = local_38[2u].member_1;
                        let _e1986 = local_39[0u].member;
                        let _e1988 = local_39[0u].member_1;
                        let _e1989 = function_10(_e1981, _e1983, _e1986, _e1988);
                        let _e1994 = local_38[0u].member;
                        let _e1996 = local_38[0u].member_1;
                        let _e1999 = local_39[2u].member;
                        let _e2001 = local_39[2u].member_1;
                        let _e2002 = function_10(_e1994, _e1996, _e1999, _e2001);
                        let _e2008 = ((_e1989.member - _e2002.member) - select(0u, 1u, (_e1989.member_1 < _e2002.member_1)));
                        let _e2009 = (_e1989.member_1 - _e2002.member_1);
                        local_36 = array<type_9, 3>(type_9(_e1891[1][0][0].member, _e1891[1][0][0].member_1), type_9(_e1891[1][0][1].member, _e1891[1][0][1].member_1), type_9(_e1891[1][0][2].member, _e1891[1][0][2].member_1));
                        local_37 = array<type_9, 3>(type_9(_e1891[2][0][0].member, _e1891[2][0][0].member_1), type_9(_e1891[2][0][1].member, _e1891[2][0][1].member_1), type_9(_e1891[2][0][2].member, _e1891[2][0][2].member_1));
                        let _e2038 = local_36[0u].member;
                        let _e2040 = local_36[0u].member_1;
                        let _e2043 = local_37[1u].member;
                        let _e2045 = local_37[1u].member_1;
                        let _e2046 = function_10(_e2038, _e2040, _e2043, _e2045);
                        let _e2051 = local_36[1u].member;
                        let _e2053 = local_36[1u].member_1;
                        let _e2056 = local_37[0u].member;
                        let _e2058 = local_37[0u].member_1;
                        let _e2059 = function_10(_e2051, _e2053, _e2056, _e2058);
                        let _e2065 = ((_e2046.member - _e2059.member) - select(0u, 1u, (_e2046.member_1 < _e2059.member_1)));
                        let _e2066 = (_e2046.member_1 - _e2059.member_1);
                        local_34 = array<type_9, 3>(type_9(_e1891[1][1][0].member, _e1891[1][1][0].member_1), type_9(_e1891[1][1][1].member, _e1891[1][1][1].member_1), type_9(_e1891[1][1][2].member, _e1891[1][1][2].member_1));
                        local_35 = array<type_9, 3>(type_9(_e1891[2][1][0].member, _e1891[2][1][0].member_1), type_9(_e1891[2][1][1].member, _e1891[2][1][1].member_1), type_9(_e1891[2][1][2].member, _e1891[2][1][2].member_1));
                        let _e2099 = local_34[1u].member;
                        let _e2101 = local_34[1u].member_1;
                        let _e2104 = local_35[2u].member;
                        let _e2106 = local_35[2u].member_1;
                        let _e2107 = function_10(_e2099, _e2101, _e2104, _e2106);
                        let _e2112 = local_34[2u].member;
                        let _e2114 = local_34[2u].member_1;
                        let _e2117 = local_35[1u].member;
                        let _e2119 = local_35[1u].member_1;
                        let _e2120 = function_10(_e2112, _e2114, _e2117, _e2119);
                        let _e2126 = ((_e2107.member - _e2120.member) - select(0u, 1u, (_e2107.member_1 < _e2120.member_1)));
                        let _e2127 = (_e2107.member_1 - _e2120.member_1);
                        local_32 = array<type_9, 3>(type_9(_e1891[1][1][0].member, _e1891[1][1][0].member_1), type_9(_e1891[1][1][1].member, _e1891[1][1][1].member_1), type_9(_e1891[1][1][2].member, _e1891[1][1][2].member_1));
                        local_33 = array<type_9, 3>(type_9(_e1891[2][1][0].member, _e1891[2][1][0].member_1), type_9(_e1891[2][1][1].member, _e1891[2][1][1].member_1), type_9(_e1891[2][1][2].member, _e1891[2][1][2].member_1));
                        let _e2156 = local_32[2u].member;
                        let _e2158 = local_32[2u].member_1;
                        let _e2161 = local_33[0u].member;
                        let _e2163 = local_33[0u].member_1;
                        let _e2164 = function_10(_e2156, _e2158, _e2161, _e2163);
                        let _e2169 = local_32[0u].member;
                        let _e2171 = local_32[0u].member_1;
                        let _e2174 = local_33[2u].member;
                        let _e2176 = local_33[2u].member_1;
                        let _e2177 = function_10(_e2169, _e2171, _e2174, _e2176);
                        let _e2183 = ((_e2164.member - _e2177.member) - select(0u, 1u, (_e2164.member_1 < _e2177.member_1)));
                        let _e2184 = (_e2164.member_1 - _e2177.member_1);
                        local_30 = array<type_9, 3>(type_9(_e1891[1][1][0].member, _e1891[1][1][0].member_1), type_9(_e1891[1][1][1].member, _e1891[1][1][1].member_1), type_9(_e1891[1][1][2].member, _e1891[1][1][2].member_1));
                        local_31 = array<type_9, 3>(type_9(_e1891[2][1][0].member, _e1891[2][1][0].member_1), type_9(_e1891[2][1][1].member, _e1891[2][1][1].member_1), type_9(_e1891[2][1][2].member, _e1891[2][1][2].member_1));
                        let _e2213 = local_30[0u].member;
                        let _e2215 = local_30[0u].member_1;
                        let _e2218 = local_31[1u].member;
                        let _e2220 = local_31[1u].member_1;
                        let _e2221 = function_10(_e2213, _e2215, _e2218, _e2220);
                        let _e2226 = local_30[1u].member;
                        let _e2228 = local_30[1u].member_1;
                        let _e2231 = local_31[0u].member;
                        let _e2233 = local_31[0u].member_1;
                        let _e2234 = function_10(_e2226, _e2228, _e2231, _e2233);
                        let _e2240 = ((_e2221.member - _e2234.member) - select(0u, 1u, (_e2221.member_1 < _e2234.member_1)));
                        let _e2241 = (_e2221.member_1 - _e2234.member_1);
                        local_28 = array<type_9, 3>(type_9(_e1891[1][0][0].member, _e1891[1][0][0].member_1), type_9(_e1891[1][0][1].member, _e1891[1][0][1].member_1), type_9(_e1891[1][0][2].member, _e1891[1][0][2].member_1));
                        local_29 = array<type_9, 3>(type_9(_e1891[2][1][0].member, _e1891[2][1][0].member_1), type_9(_e1891[2][1][1].member, _e1891[2][1][1].member_1), type_9(_e1891[2][1][2].member, _e1891[2][1][2].member_1));
                        let _e2274 = local_28[1u].member;
                        let _e2276 = local_28[1u].member_1;
                        let _e2279 = local_29[2u].member;
                        let _e2281 = local_29[2u].member_1;
                        let _e2282 = function_10(_e2274, _e2276, _e2279, _e2281);
                        let _e2287 = local_28[2u].member;
                        let _e2289 = local_28[2u].member_1;
                        let _e2292 = local_29[1u].member;
                        let _e2294 = local_29[1u].member_1;
                        let _e2295 = function_10(_e2287, _e2289, _e2292, _e2294);
                        let _e2302 = (_e2282.member_1 - _e2295.member_1);
                        local_26 = array<type_9, 3>(type_9(_e1891[1][0][0].member, _e1891[1][0][0].member_1), type_9(_e1891[1][0][1].member, _e1891[1][0][1].member_1), type_9(_e1891[1][0][2].member, _e1891[1][0][2].member_1));
                        local_27 = array<type_9, 3>(type_9(_e1891[2][1][0].member, _e1891[2][1][0].member_1), type_9(_e1891[2][1][1].member, _e1891[2][1][1].member_1), type_9(_e1891[2][1][2].member, _e1891[2][1][2].member_1));
                        let _e2331 = local_26[2u].member;
                        let _e2333 = local_26[2u].member_1;
                        let _e2336 = local_27[0u].member;
                        let _e2338 = local_27[0u].member_1;
                        let _e2339 = function_10(_e2331, _e2333, _e2336, _e2338);
                        let _e2344 = local_26[0u].member;
                        let _e2346 = local_26[0u].member_1;
                        let _e2349 = local_27[2u].member;
                        let _e2351 = local_27[2u].member_1;
                        let _e2352 = function_10(_e2344, _e2346, _e2349, _e2351);
                        let _e2359 = (_e2339.member_1 - _e2352.member_1);
                        local_24 = array<type_9, 3>(type_9(_e1891[1][0][0].member, _e1891[1][0][0].member_1), type_9(_e1891[1][0][1].member, _e1891[1][0][1].member_1), type_9(_e1891[1][0][2].member, _e1891[1][0][2].member_1));
                        local_25 = array<type_9, 3>(type_9(_e1891[2][1][0].member, _e1891[2][1][0].member_1), type_9(_e1891[2][1][1].member, _e1891[2][1][1].member_1), type_9(_e1891[2][1][2].member, _e1891[2][1][2].member_1));
                        let _e2388 = local_24[0u].member;
                        let _e2390 = local_24[0u].member_1;
                        let _e2393 = local_25[1u].member;
                        let _e2395 = local_25[1u].member_1;
                        let _e2396 = function_10(_e2388, _e2390, _e2393, _e2395);
                        let _e2401 = local_24[1u].member;
                        let _e2403 = local_24[1u].member_1;
                        let _e2406 = local_25[0u].member;
                        let _e2408 = local_25[0u].member_1;
                        let _e2409 = function_10(_e2401, _e2403, _e2406, _e2408);
                        let _e2416 = (_e2396.member_1 - _e2409.member_1);
                        local_22 = array<type_9, 3>(type_9(_e1891[1][1][0].member, _e1891[1][1][0].member_1), type_9(_e1891[1][1][1].member, _e1891[1][1][1].member_1), type_9(_e1891[1][1][2].member, _e1891[1][1][2].member_1));
                        local_23 = array<type_9, 3>(type_9(_e1891[2][0][0].member, _e1891[2][0][0].member_1), type_9(_e1891[2][0][1].member, _e1891[2][0][1].member_1), type_9(_e1891[2][0][2].member, _e1891[2][0][2].member_1));
                        let _e2449 = local_22[1u].member;
                        let _e2451 = local_22[1u].member_1;
                        let _e2454 = local_23[2u].member;
                        let _e2456 = local_23[2u].member_1;
                        let _e2457 = function_10(_e2449, _e2451, _e2454, _e2456);
                        let _e2462 = local_22[2u].member;
                        let _e2464 = local_22[2u].member_1;
                        let _e2467 = local_23[1u].member;
                        let _e2469 = local_23[1u].member_1;
                        let _e2470 = function_10(_e2462, _e2464, _e2467, _e2469);
                        local_20 = array<type_9, 3>(type_9(_e1891[1][1][0].member, _e1891[1][1][0].member_1), type_9(_e1891[1][1][1].member, _e1891[1][1][1].member_1), type_9(_e1891[1][1][2].member, _e1891[1][1][2].member_1));
                        local_21 = array<type_9, 3>(type_9(_e1891[2][0][0].member, _e1891[2][0][0].member_1), type_9(_e1891[2][0][1].member, _e1891[2][0][1].member_1), type_9(_e1891[2][0][2].member, _e1891[2][0][2].member_1));
                        let _e2506 = local_20[2u].member;
                        let _e2508 = local_20[2u].member_1;
                        let _e2511 = local_21[0u].member;
                        let _e2513 = local_21[0u].member_1;
                        let _e2514 = function_10(_e2506, _e2508, _e2511, _e2513);
                        let _e2519 = local_20[0u].member;
                        let _e2521 = local_20[0u].member_1;
                        let _e2524 = local_21[2u].member;
                        let _e2526 = local_21[2u].member_1;
                        let _e2527 = function_10(_e2519, _e2521, _e2524, _e2526);
                        local_18 = array<type_9, 3>(type_9(_e1891[1][1][0].member, _e1891[1][1][0].member_1), type_9(_e1891[1][1][1].member, _e1891[1][1][1].member_1), type_9(_e1891[1][1][2].member, _e1891[1][1][2].member_1));
                        local_19 = array<type_9, 3>(type_9(_e1891[2][0][0].member, _e1891[2][0][0].member_1), type_9(_e1891[2][0][1].member, _e1891[2][0][1].member_1), type_9(_e1891[2][0][2].member, _e1891[2][0][2].member_1));
                        let _e2563 = local_18[0u].member;
                        let _e2565 = local_18[0u].member_1;
                        let _e2568 = local_19[1u].member;
                        let _e2570 = local_19[1u].member_1;
                        let _e2571 = function_10(_e2563, _e2565, _e2568, _e2570);
                        let _e2576 = local_18[1u].member;
                        let _e2578 = local_18[1u].member_1;
                        let _e2581 = local_19[0u].member;
                        let _e2583 = local_19[0u].member_1;
                        let _e2584 = function_10(_e2576, _e2578, _e2581, _e2583);
                        let _e2592 = (_e2302 + (_e2457.member_1 - _e2470.member_1));
                        let _e2596 = ((((_e2282.member - _e2295.member) - select(0u, 1u, (_e2282.member_1 < _e2295.member_1))) + ((_e2457.member - _e2470.member) - select(0u, 1u, (_e2457.member_1 < _e2470.member_1)))) + select(0u, 1u, (_e2592 < _e2302)));
                        let _e2597 = (_e2359 + (_e2514.member_1 - _e2527.member_1));
                        let _e2601 = ((((_e2339.member - _e2352.member) - select(0u, 1u, (_e2339.member_1 < _e2352.member_1))) + ((_e2514.member - _e2527.member) - select(0u, 1u, (_e2514.member_1 < _e2527.member_1)))) + select(0u, 1u, (_e2597 < _e2359)));
                        let _e2602 = (_e2416 + (_e2571.member_1 - _e2584.member_1));
                        let _e2606 = ((((_e2396.member - _e2409.member) - select(0u, 1u, (_e2396.member_1 < _e2409.member_1))) + ((_e2571.member - _e2584.member) - select(0u, 1u, (_e2571.member_1 < _e2584.member_1)))) + select(0u, 1u, (_e2602 < _e2416)));
                        let _e2613 = function_10(_e1891[0][0][0].member, _e1891[0][0][0].member_1, _e1951, _e1952);
                        let _e2620 = function_10(_e1891[0][0][1].member, _e1891[0][0][1].member_1, _e2008, _e2009);
                        let _e2623 = (_e2613.member_1 + _e2620.member_1);
                        let _e2632 = function_10(_e1891[0][0][2].member, _e1891[0][0][2].member_1, _e2065, _e2066);
                        let _e2635 = (_e2623 + _e2632.member_1);
                        let _e2640 = function_13(((((_e2613.member + _e2620.member) + select(0u, 1u, (_e2623 < _e2613.member_1))) + _e2632.member) + select(0u, 1u, (_e2635 < _e2623))), _e2635);
                        let _e2649 = function_10(_e1891[0][1][0].member, _e1891[0][1][0].member_1, _e1951, _e1952);
                        let _e2656 = function_10(_e1891[0][1][1].member, _e1891[0][1][1].member_1, _e2008, _e2009);
                        let _e2659 = (_e2649.member_1 + _e2656.member_1);
                        let _e2668 = function_10(_e1891[0][1][2].member, _e1891[0][1][2].member_1, _e2065, _e2066);
                        let _e2671 = (_e2659 + _e2668.member_1);
                        let _e2682 = function_10(_e1891[0][0][0].member, _e1891[0][0][0].member_1, _e2596, _e2592);
                        let _e2689 = function_10(_e1891[0][0][1].member, _e1891[0][0][1].member_1, _e2601, _e2597);
                        let _e2692 = (_e2682.member_1 + _e2689.member_1);
                        let _e2701 = function_10(_e1891[0][0][2].member, _e1891[0][0][2].member_1, _e2606, _e2602);
                        let _e2704 = (_e2692 + _e2701.member_1);
                        let _e2709 = (_e2671 + _e2704);
                        let _e2713 = ((((((_e2649.member + _e2656.member) + select(0u, 1u, (_e2659 < _e2649.member_1))) + _e2668.member) + select(0u, 1u, (_e2671 < _e2659))) + ((((_e2682.member + _e2689.member) + select(0u, 1u, (_e2692 < _e2682.member_1))) + _e2701.member) + select(0u, 1u, (_e2704 < _e2692)))) + select(0u, 1u, (_e2709 < _e2671)));
                        let _e2720 = function_10(_e1891[0][0][0].member, _e1891[0][0][0].member_1, _e2126, _e2127);
                        let _e2727 = function_10(_e1891[0][0][1].member, _e1891[0][0][1].member_1, _e2183, _e2184);
                        let _e2730 = (_e2720.member_1 + _e2727.member_1);
                        let _e2739 = function_10(_e1891[0][0][2].member, _e1891[0][0][2].member_1, _e2240, _e2241);
                        let _e2742 = (_e2730 + _e2739.member_1);
                        let _e2753 = function_10(_e1891[0][1][0].member, _e1891[0][1][0].member_1, _e2596, _e2592);
                        let _e2760 = function_10(_e1891[0][1][1].member, _e1891[0][1][1].member_1, _e2601, _e2597);
                        let _e2763 = (_e2753.member_1 + _e2760.member_1);
                        let _e2772 = function_10(_e1891[0][1][2].member, _e1891[0][1][2].member_1, _e2606, _e2602);
                        let _e2775 = (_e2763 + _e2772.member_1);
                        let _e2780 = (_e2742 + _e2775);
                        let _e2784 = ((((((_e2720.member + _e2727.member) + select(0u, 1u, (_e2730 < _e2720.member_1))) + _e2739.member) + select(0u, 1u, (_e2742 < _e2730))) + ((((_e2753.member + _e2760.member) + select(0u, 1u, (_e2763 < _e2753.member_1))) + _e2772.member) + select(0u, 1u, (_e2775 < _e2763)))) + select(0u, 1u, (_e2780 < _e2742)));
                        let _e2791 = function_10(_e1891[0][1][0].member, _e1891[0][1][0].member_1, _e2126, _e2127);
                        let _e2798 = function_10(_e1891[0][1][1].member, _e1891[0][1][1].member_1, _e2183, _e2184);
                        let _e2801 = (_e2791.member_1 + _e2798.member_1);
                        let _e2810 = function_10(_e1891[0][1][2].member, _e1891[0][1][2].member_1, _e2240, _e2241);
                        let _e2813 = (_e2801 + _e2810.member_1);
                        let _e2818 = function_13(((((_e2791.member + _e2798.member) + select(0u, 1u, (_e2801 < _e2791.member_1))) + _e2810.member) + select(0u, 1u, (_e2813 < _e2801))), _e2813);
                        phi_5089_ = type_9(0u, 128u);
                        phi_5092_ = array<type_9, 4>(_e2640, type_9(_e2713, _e2709), type_9(_e2784, _e2780), _e2818);
                        phi_5096_ = 0u;
                        phi_5098_ = 0u;
                        loop {
                            let _e2825 = phi_5089_;
                            let _e2827 = phi_5092_;
                            let _e2829 = phi_5096_;
                            let _e2831 = phi_5098_;
                            local_56 = _e2827;
                            local_57 = _e2827;
                            local_58 = _e2827;
                            let _e2834 = (_e2825.member < _e2825.member_1);
                            if (bitcast<i32>(select(0u, 1u, _e2834)) != 0i) {
                                let _e2846 = (31u - _e2829);
                                let _e2849 = (_e2831 << bitcast<u32>((_e2846 & 31u)));
                                let _e2854 = (_e2849 > _e1314);
                                if _e2854 {
                                    phi_7806_ = array<type_9, 4>();
                                    phi_7808_ = u32();
                                    phi_7809_ = u32();
                                    phi_7810_ = bool();
                                    phi_7811_ = bool();
                                    phi_7812_ = u32();
                                    phi_7813_ = u32();
                                    phi_7814_ = false;
                                    phi_7815_ = false;
                                    phi_7816_ = false;
                                } else {
                                    if (((_e2831 + 1u) << bitcast<u32>((_e2846 & 31u))) < _e1312) {
                                        phi_5318_ = true;
                                    } else {
                                        let _e2860 = function_12(128u);
                                        let _e2865 = ((_e2827[0].member >> bitcast<u32>(31i)) != 0u);
                                        let _e2893 = function_12(128u);
                                        let _e2898 = ((_e2827[1].member >> bitcast<u32>(31i)) != 0u);
                                        let _e2927 = function_12(128u);
                                        let _e2932 = ((_e2827[2].member >> bitcast<u32>(31i)) != 0u);
                                        let _e2961 = function_12(128u);
                                        let _e2966 = ((_e2827[3].member >> bitcast<u32>(31i)) != 0u);
                                        phi_5318_ = ((((select(0u, select(1u, 2u, ((_e2827[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2860.member - select(_e2827[0].member, (~(_e2827[0].member) + select(0u, 1u, (_e2827[0].member_1 == 0u))), _e2865)) - select(0u, 1u, (_e2860.member_1 < select(_e2827[0].member_1, (~(_e2827[0].member_1) + 1u), _e2865)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e2827[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e2893.member - select(_e2827[1].member, (~(_e2827[1].member) + select(0u, 1u, (_e2827[1].member_1 == 0u))), _e2898)) - select(0u, 1u, (_e2893.member_1 < select(_e2827[1].member_1, (~(_e2827[1].member_1) + 1u), _e2898)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2827[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e2927.member - select(_e2827[2].member, (~(_e2827[2].member) + select(0u, 1u, (_e2827[2].member_1 == 0u))), _e2932)) - select(0u, 1u, (_e2927.member_1 < select(_e2827[2].member_1, (~(_e2827[2].member_1) + 1u), _e2932)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2827[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e2961.member - select(_e2827[3].member, (~(_e2827[3].member) + select(0u, 1u, (_e2827[3].member_1 == 0u))), _e2966)) - select(0u, 1u, (_e2961.member_1 < select(_e2827[3].member_1, (~(_e2827[3].member_1) + 1u), _e2966)))) >> bitcast<u32>(31i)) != 0u))) != 0u);
                                    }
                                    let _e2993 = phi_5318_;
                                    if _e2993 {
                                        phi_7487_ = _e2827;
                                        phi_7489_ = _e2993;
                                        phi_7490_ = _e2829;
                                        phi_7491_ = _e2831;
                                        phi_7492_ = bool();
                                        phi_7493_ = bool();
                                        phi_7494_ = u32();
                                        phi_7495_ = u32();
                                        phi_7496_ = true;
                                    } else {
                                        let _e2994 = (_e2829 == 31u);
                                        if select(select(select((_e2829 == 14u), true, (_e2829 == 8u)), true, (_e2829 == 3u)), true, _e2994) {
                                            let _e3005 = function_12(128u);
                                            let _e3010 = ((_e2827[0].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3038 = function_12(128u);
                                            let _e3043 = ((_e2827[3].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3068 = ((select(0u, select(1u, 2u, ((_e2827[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3005.member - select(_e2827[0].member, (~(_e2827[0].member) + select(0u, 1u, (_e2827[0].member_1 == 0u))), _e3010)) - select(0u, 1u, (_e3005.member_1 < select(_e2827[0].member_1, (~(_e2827[0].member_1) + 1u), _e3010)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e2827[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e3038.member - select(_e2827[3].member, (~(_e2827[3].member) + select(0u, 1u, (_e2827[3].member_1 == 0u))), _e3043)) - select(0u, 1u, (_e3038.member_1 < select(_e2827[3].member_1, (~(_e2827[3].member_1) + 1u), _e3043)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                            let _e3070 = select(false, !(_e3068), _e2994);
                                            if _e3070 {
                                                phi_5447_ = select((bitcast<u32>(31i) - firstLeadingBit(_e1316)), 32u, (_e1316 == 0u));
                                            } else {
                                                phi_5447_ = _e2829;
                                            }
                                            let _e3077 = phi_5447_;
                                            let _e3099 = ((_e1891[0][1][0].member - _e1891[0][0][0].member) - select(0u, 1u, (_e1891[0][1][0].member_1 < _e1891[0][0][0].member_1)));
                                            let _e3100 = (_e1891[0][1][0].member_1 - _e1891[0][0][0].member_1);
                                            let _e3112 = ((_e1891[0][1][1].member - _e1891[0][0][1].member) - select(0u, 1u, (_e1891[0][1][1].member_1 < _e1891[0][0][1].member_1)));
                                            let _e3113 = (_e1891[0][1][1].member_1 - _e1891[0][0][1].member_1);
                                            let _e3125 = ((_e1891[0][1][2].member - _e1891[0][0][2].member) - select(0u, 1u, (_e1891[0][1][2].member_1 < _e1891[0][0][2].member_1)));
                                            let _e3126 = (_e1891[0][1][2].member_1 - _e1891[0][0][2].member_1);
                                            let _e3129 = ((_e3099 >> bitcast<u32>(31i)) != 0u);
                                            let _e3136 = select(_e3099, (~(_e3099) + select(0u, 1u, (_e3100 == 0u))), _e3129);
                                            let _e3137 = select(_e3100, (~(_e3100) + 1u), _e3129);
                                            let _e3140 = ((_e3112 >> bitcast<u32>(31i)) != 0u);
                                            let _e3147 = select(_e3112, (~(_e3112) + select(0u, 1u, (_e3113 == 0u))), _e3140);
                                            let _e3148 = select(_e3113, (~(_e3113) + 1u), _e3140);
                                            let _e3155 = ((((_e3147 - _e3136) - select(0u, 1u, (_e3148 < _e3137))) >> bitcast<u32>(31i)) != 0u);
                                            let _e3156 = select(_e3147, _e3136, _e3155);
                                            let _e3157 = select(_e3148, _e3137, _e3155);
                                            let _e3160 = ((_e3125 >> bitcast<u32>(31i)) != 0u);
                                            let _e3167 = select(_e3125, (~(_e3125) + select(0u, 1u, (_e3126 == 0u))), _e3160);
                                            let _e3168 = select(_e3126, (~(_e3126) + 1u), _e3160);
                                            let _e3175 = ((((_e3167 - _e3156) - select(0u, 1u, (_e3168 < _e3157))) >> bitcast<u32>(31i)) != 0u);
                                            let _e3177 = select(_e3168, _e3157, _e3175);
                                            let _e3178 = function_12(4u);
                                            let _e3181 = (_e3177 + _e3178.member_1);
                                            let _e3185 = ((select(_e3167, _e3156, _e3175) + _e3178.member) + select(0u, 1u, (_e3181 < _e3177)));
                                            let _e3200 = ((_e3181 >> bitcast<u32>((_e3077 & 31u))) | ((_e3185 << bitcast<u32>(((31u - _e3077) & 31u))) << bitcast<u32>(1i)));
                                            let _e3201 = function_12(4u);
                                            let _e3204 = (_e3200 + _e3201.member_1);
                                            let _e3222 = ((_e1891[1][1][0].member - _e1891[1][0][0].member) - select(0u, 1u, (_e1891[1][1][0].member_1 < _e1891[1][0][0].member_1)));
                                            let _e3223 = (_e1891[1][1][0].member_1 - _e1891[1][0][0].member_1);
                                            let _e3235 = ((_e1891[1][1][1].member - _e1891[1][0][1].member) - select(0u, 1u, (_e1891[1][1][1].member_1 < _e1891[1][0][1].member_1)));
                                            let _e3236 = (_e1891[1][1][1].member_1 - _e1891[1][0][1].member_1);
                                            let _e3248 = ((_e1891[1][1][2].member - _e1891[1][0][2].member) - select(0u, 1u, (_e1891[1][1][2].member_1 < _e1891[1][0][2].member_1)));
                                            let _e3249 = (_e1891[1][1][2].member_1 - _e1891[1][0][2].member_1);
                                            let _e3252 = ((_e3222 >> bitcast<u32>(31i)) != 0u);
                                            let _e3259 = select(_e3222, (~(_e3222) + select(0u, 1u, (_e3223 == 0u))), _e3252);
                                            let _e3260 = select(_e3223, (~(_e3223) + 1u), _e3252);
                                            let _e3263 = ((_e3235 >> bitcast<u32>(31i)) != 0u);
                                            let _e3270 = select(_e3235, (~(_e3235) + select(0u, 1u, (_e3236 == 0u))), _e3263);
                                            let _e3271 = select(_e3236, (~(_e3236) + 1u), _e3263);
                                            let _e3278 = ((((_e3270 - _e3259) - select(0u, 1u, (_e3271 < _e3260))) >> bitcast<u32>(31i)) != 0u);
                                            let _e3279 = select(_e3270, _e3259, _e3278);
                                            let _e3280 = select(_e3271, _e3260, _e3278);
                                            let _e3283 = ((_e3248 >> bitcast<u32>(31i)) != 0u);
                                            let _e3290 = select(_e3248, (~(_e3248) + select(0u, 1u, (_e3249 == 0u))), _e3283);
                                            let _e3291 = select(_e3249, (~(_e3249) + 1u), _e3283);
                                            let _e3298 = ((((_e3290 - _e3279) - select(0u, 1u, (_e3291 < _e3280))) >> bitcast<u32>(31i)) != 0u);
                                            let _e3300 = select(_e3291, _e3280, _e3298);
                                            let _e3301 = function_12(4u);
                                            let _e3304 = (_e3300 + _e3301.member_1);
                                            let _e3308 = ((select(_e3290, _e3279, _e3298) + _e3301.member) + select(0u, 1u, (_e3304 < _e3300)));
                                            let _e3323 = ((_e3304 >> bitcast<u32>((_e3077 & 31u))) | ((_e3308 << bitcast<u32>(((31u - _e3077) & 31u))) << bitcast<u32>(1i)));
                                            let _e3324 = function_12(4u);
                                            let _e3327 = (_e3323 + _e3324.member_1);
                                            let _e3345 = ((_e1891[2][1][0].member - _e1891[2][0][0].member) - select(0u, 1u, (_e1891[2][1][0].member_1 < _e1891[2][0][0].member_1)));
                                            let _e3346 = (_e1891[2][1][0].member_1 - _e1891[2][0][0].member_1);
                                            let _e3358 = ((_e1891[2][1][1].member - _e1891[2][0][1].member) - select(0u, 1u, (_e1891[2][1][1].member_1 < _e1891[2][0][1].member_1)));
                                            let _e3359 = (_e1891[2][1][1].member_1 - _e1891[2][0][1].member_1);
                                            let _e3371 = ((_e1891[2][1][2].member - _e1891[2][0][2].member) - select(0u, 1u, (_e1891[2][1][2].member_1 < _e1891[2][0][2].member_1)));
                                            let _e3372 = (_e1891[2][1][2].member_1 - _e1891[2][0][2].member_1);
                                            let _e3375 = ((_e3345 >> bitcast<u32>(31i)) != 0u);
                                            let _e3382 = select(_e3345, (~(_e3345) + select(0u, 1u, (_e3346 == 0u))), _e3375);
                                            let _e3383 = select(_e3346, (~(_e3346) + 1u), _e3375);
                                            let _e3386 = ((_e3358 >> bitcast<u32>(31i)) != 0u);
                                            let _e3393 = select(_e3358, (~(_e3358) + select(0u, 1u, (_e3359 == 0u))), _e3386);
                                            let _e3394 = select(_e3359, (~(_e3359) + 1u), _e3386);
                                            let _e3401 = ((((_e3393 - _e3382) - select(0u, 1u, (_e3394 < _e3383))) >> bitcast<u32>(31i)) != 0u);
                                            let _e3402 = select(_e3393, _e3382, _e3401);
                                            let _e3403 = select(_e3394, _e3383, _e3401);
                                            let _e3406 = ((_e3371 >> bitcast<u32>(31i)) != 0u);
                                            let _e3413 = select(_e3371, (~(_e3371) + select(0u, 1u, (_e3372 == 0u))), _e3406);
                                            let _e3414 = select(_e3372, (~(_e3372) + 1u), _e3406);
                                            let _e3421 = ((((_e3413 - _e3402) - select(0u, 1u, (_e3414 < _e3403))) >> bitcast<u32>(31i)) != 0u);
                                            let _e3423 = select(_e3414, _e3403, _e3421);
                                            let _e3424 = function_12(4u);
                                            let _e3427 = (_e3423 + _e3424.member_1);
                                            let _e3431 = ((select(_e3413, _e3402, _e3421) + _e3424.member) + select(0u, 1u, (_e3427 < _e3423)));
                                            let _e3446 = ((_e3427 >> bitcast<u32>((_e3077 & 31u))) | ((_e3431 << bitcast<u32>(((31u - _e3077) & 31u))) << bitcast<u32>(1i)));
                                            let _e3447 = function_12(4u);
                                            let _e3450 = (_e3446 + _e3447.member_1);
                                            local_17[0u].member = ((bitcast<u32>((bitcast<i32>(_e3185) >> bitcast<u32>((_e3077 & 31u)))) + _e3201.member) + select(0u, 1u, (_e3204 < _e3200)));
                                            local_17[0u].member_1 = _e3204;
                                            local_17[1u].member = ((bitcast<u32>((bitcast<i32>(_e3308) >> bitcast<u32>((_e3077 & 31u)))) + _e3324.member) + select(0u, 1u, (_e3327 < _e3323)));
                                            local_17[1u].member_1 = _e3327;
                                            local_17[2u].member = ((bitcast<u32>((bitcast<i32>(_e3431) >> bitcast<u32>((_e3077 & 31u)))) + _e3447.member) + select(0u, 1u, (_e3450 < _e3446)));
                                            local_17[2u].member_1 = _e3450;
                                            let _e3480 = function_6(((_e1891[0][1][0].member - _e1891[0][0][0].member) - select(0u, 1u, (_e1891[0][1][0].member_1 < _e1891[0][0][0].member_1))), (_e1891[0][1][0].member_1 - _e1891[0][0][0].member_1), _e2849);
                                            let _e3483 = (_e1891[0][0][0].member_1 + _e3480.member_1);
                                            let _e3487 = ((_e1891[0][0][0].member + _e3480.member) + select(0u, 1u, (_e3483 < _e1891[0][0][0].member_1)));
                                            let _e3501 = function_6(((_e1891[0][1][1].member - _e1891[0][0][1].member) - select(0u, 1u, (_e1891[0][1][1].member_1 < _e1891[0][0][1].member_1))), (_e1891[0][1][1].member_1 - _e1891[0][0][1].member_1), _e2849);
                                            let _e3504 = (_e1891[0][0][1].member_1 + _e3501.member_1);
                                            let _e3508 = ((_e1891[0][0][1].member + _e3501.member) + select(0u, 1u, (_e3504 < _e1891[0][0][1].member_1)));
                                            let _e3522 = function_6(((_e1891[0][1][2].member - _e1891[0][0][2].member) - select(0u, 1u, (_e1891[0][1][2].member_1 < _e1891[0][0][2].member_1))), (_e1891[0][1][2].member_1 - _e1891[0][0][2].member_1), _e2849);
                                            let _e3525 = (_e1891[0][0][2].member_1 + _e3522.member_1);
                                            let _e3529 = ((_e1891[0][0][2].member + _e3522.member) + select(0u, 1u, (_e3525 < _e1891[0][0][2].member_1)));
                                            let _e3545 = function_6(((_e1891[1][1][0].member - _e1891[1][0][0].member) - select(0u, 1u, (_e1891[1][1][0].member_1 < _e1891[1][0][0].member_1))), (_e1891[1][1][0].member_1 - _e1891[1][0][0].member_1), _e2849);
                                            let _e3548 = (_e1891[1][0][0].member_1 + _e3545.member_1);
                                            let _e3552 = ((_e1891[1][0][0].member + _e3545.member) + select(0u, 1u, (_e3548 < _e1891[1][0][0].member_1)));
                                            let _e3566 = function_6(((_e1891[1][1][1].member - _e1891[1][0][1].member) - select(0u, 1u, (_e1891[1][1][1].member_1 < _e1891[1][0][1].member_1))), (_e1891[1][1][1].member_1 - _e1891[1][0][1].member_1), _e2849);
                                            let _e3569 = (_e1891[1][0][1].member_1 + _e3566.member_1);
                                            let _e3573 = ((_e1891[1][0][1].member + _e3566.member) + select(0u, 1u, (_e3569 < _e1891[1][0][1].member_1)));
                                            let _e3587 = function_6(((_e1891[1][1][2].member - _e1891[1][0][2].member) - select(0u, 1u, (_e1891[1][1][2].member_1 < _e1891[1][0][2].member_1))), (_e1891[1][1][2].member_1 - _e1891[1][0][2].member_1), _e2849);
                                            let _e3590 = (_e1891[1][0][2].member_1 + _e3587.member_1);
                                            let _e3594 = ((_e1891[1][0][2].member + _e3587.member) + select(0u, 1u, (_e3590 < _e1891[1][0][2].member_1)));
                                            let _e3610 = function_6(((_e1891[2][1][0].member - _e1891[2][0][0].member) - select(0u, 1u, (_e1891[2][1][0].member_1 < _e1891[2][0][0].member_1))), (_e1891[2][1][0].member_1 - _e1891[2][0][0].member_1), _e2849);
                                            let _e3613 = (_e1891[2][0][0].member_1 + _e3610.member_1);
                                            let _e3617 = ((_e1891[2][0][0].member + _e3610.member) + select(0u, 1u, (_e3613 < _e1891[2][0][0].member_1)));
                                            let _e3631 = function_6(((_e1891[2][1][1].member - _e1891[2][0][1].member) - select(0u, 1u, (_e1891[2][1][1].member_1 < _e1891[2][0][1].member_1))), (_e1891[2][1][1].member_1 - _e1891[2][0][1].member_1), _e2849);
                                            let _e3634 = (_e1891[2][0][1].member_1 + _e3631.member_1);
                                            let _e3638 = ((_e1891[2][0][1].member + _e3631.member) + select(0u, 1u, (_e3634 < _e1891[2][0][1].member_1)));
                                            let _e3652 = function_6(((_e1891[2][1][2].member - _e1891[2][0][2].member) - select(0u, 1u, (_e1891[2][1][2].member_1 < _e1891[2][0][2].member_1))), (_e1891[2][1][2].member_1 - _e1891[2][0][2].member_1), _e2849);
                                            let _e3655 = (_e1891[2][0][2].member_1 + _e3652.member_1);
                                            let _e3659 = ((_e1891[2][0][2].member + _e3652.member) + select(0u, 1u, (_e3655 < _e1891[2][0][2].member_1)));
                                            local_15 = array<type_9, 3>(type_9(_e3552, _e3548), type_9(_e3573, _e3569), type_9(_e3594, _e3590));
                                            local_16 = array<type_9, 3>(type_9(_e3617, _e3613), type_9(_e3638, _e3634), type_9(_e3659, _e3655));
                                            let _e3670 = local_15[1u].member;
                                            let _e3672 = local_15[1u].member_1;
                                            let _e3675 = local_16[2u].member;
                                            let _e3677 = local_16[2u].member_1;
                                            let _e3678 = function_10(_e3670, _e3672, _e3675, _e3677);
                                            let _e3683 = local_15[2u].member;
                                            let _e3685 = local_15[2u].member_1;
                                            let _e3688 = local_16[1u].member;
                                            let _e3690 = local_16[1u].member_1;
                                            let _e3691 = function_10(_e3683, _e3685, _e3688, _e3690);
                                            let _e3697 = ((_e3678.member - _e3691.member) - select(0u, 1u, (_e3678.member_1 < _e3691.member_1)));
                                            let _e3698 = (_e3678.member_1 - _e3691.member_1);
                                            local_13 = array<type_9, 3>(type_9(_e3552, _e3548), type_9(_e3573, _e3569), type_9(_e3594, _e3590));
                                            local_14 = array<type_9, 3>(type_9(_e3617, _e3613), type_9(_e3638, _e3634), type_9(_e3659, _e3655));
                                            let _e3709 = local_13[2u].member;
                                            let _e3711 = local_13[2u].member_1;
                                            let _e3714 = local_14[0u].member;
                                            let _e3716 = local_14[0u].member_1;
                                            let _e3717 = function_10(_e3709, _e3711, _e3714, _e3716);
                                            let _e3722 = local_13[0u].member;
                                            let _e3724 = local_13[0u].member_1;
                                            let _e3727 = local_14[2u].member;
                                            let _e3729 = local_14[2u].member_1;
                                            let _e3730 = function_10(_e3722, _e3724, _e3727, _e3729);
                                            let _e3736 = ((_e3717.member - _e3730.member) - select(0u, 1u, (_e3717.member_1 < _e3730.member_1)));
                                            let _e3737 = (_e3717.member_1 - _e3730.member_1);
                                            local_11 = array<type_9, 3>(type_9(_e3552, _e3548), type_9(_e3573, _e3569), type_9(_e3594, _e3590));
                                            local_12 = array<type_9, 3>(type_9(_e3617, _e3613), type_9(_e3638, _e3634), type_9(_e3659, _e3655));
                                            let _e3748 = local_11[0u].member;
                                            let _e3750 = local_11[0u].member_1;
                                            let _e3753 = local_12[1u].member;
                                            let _e3755 = local_12[1u].member_1;
                                            let _e3756 = function_10(_e3748, _e3750, _e3753, _e3755);
                                            let _e3761 = local_11[1u].member;
                                            let _e3763 = local_11[1u].member_1;
                                            let _e3766 = local_12[0u].member;
                                            let _e3768 = local_12[0u].member_1;
                                            let _e3769 = function_10(_e3761, _e3763, _e3766, _e3768);
                                            let _e3775 = ((_e3756.member - _e3769.member) - select(0u, 1u, (_e3756.member_1 < _e3769.member_1)));
                                            let _e3776 = (_e3756.member_1 - _e3769.member_1);
                                            let _e3779 = ((_e3697 >> bitcast<u32>(31i)) != 0u);
                                            let _e3786 = select(_e3697, (~(_e3697) + select(0u, 1u, (_e3698 == 0u))), _e3779);
                                            let _e3787 = select(_e3698, (~(_e3698) + 1u), _e3779);
                                            let _e3790 = ((_e3736 >> bitcast<u32>(31i)) != 0u);
                                            let _e3797 = select(_e3736, (~(_e3736) + select(0u, 1u, (_e3737 == 0u))), _e3790);
                                            let _e3798 = select(_e3737, (~(_e3737) + 1u), _e3790);
                                            let _e3801 = ((_e3775 >> bitcast<u32>(31i)) != 0u);
                                            let _e3808 = select(_e3775, (~(_e3775) + select(0u, 1u, (_e3776 == 0u))), _e3801);
                                            let _e3809 = select(_e3776, (~(_e3776) + 1u), _e3801);
                                            let _e3834 = select(0i, select(2i, 1i, ((((_e3808 - _e3797) - select(0u, 1u, (_e3809 < _e3798))) >> bitcast<u32>(31i)) != 0u)), select(true, select(true, false, ((((_e3808 - _e3786) - select(0u, 1u, (_e3809 < _e3787))) >> bitcast<u32>(31i)) != 0u)), ((((_e3797 - _e3786) - select(0u, 1u, (_e3798 < _e3787))) >> bitcast<u32>(31i)) != 0u)));
                                            switch _e3834 {
                                                case 0: {
                                                    phi_6596_ = array<type_9, 2>(type_9(_e3508, _e3504), type_9(_e3529, _e3525));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6596_ = array<type_9, 2>(type_9(_e3529, _e3525), type_9(_e3487, _e3483));
                                                    break;
                                                }
                                                default: {
                                                    phi_6596_ = array<type_9, 2>(type_9(_e3487, _e3483), type_9(_e3508, _e3504));
                                                    break;
                                                }
                                            }
                                            let _e3845 = phi_6596_;
                                            switch _e3834 {
                                                case 0: {
                                                    phi_6625_ = array<type_9, 2>(type_9(_e3573, _e3569), type_9(_e3594, _e3590));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6625_ = array<type_9, 2>(type_9(_e3594, _e3590), type_9(_e3552, _e3548));
                                                    break;
                                                }
                                                default: {
                                                    phi_6625_ = array<type_9, 2>(type_9(_e3552, _e3548), type_9(_e3573, _e3569));
                                                    break;
                                                }
                                            }
                                            let _e3856 = phi_6625_;
                                            switch _e3834 {
                                                case 0: {
                                                    phi_6654_ = array<type_9, 2>(type_9(_e3638, _e3634), type_9(_e3659, _e3655));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6654_ = array<type_9, 2>(type_9(_e3659, _e3655), type_9(_e3617, _e3613));
                                                    break;
                                                }
                                                default: {
                                                    phi_6654_ = array<type_9, 2>(type_9(_e3617, _e3613), type_9(_e3638, _e3634));
                                                    break;
                                                }
                                            }
                                            let _e3867 = phi_6654_;
                                            switch _e3834 {
                                                case 0: {
                                                    phi_6668_ = type_9(_e3697, _e3698);
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6668_ = type_9(_e3736, _e3737);
                                                    break;
                                                }
                                                default: {
                                                    phi_6668_ = type_9(_e3775, _e3776);
                                                    break;
                                                }
                                            }
                                            let _e3872 = phi_6668_;
                                            let _e3875 = local_17[1u].member;
                                            let _e3877 = local_17[1u].member_1;
                                            let _e3880 = local_17[2u].member;
                                            let _e3882 = local_17[2u].member_1;
                                            let _e3883 = (_e3877 + _e3882);
                                            let _e3887 = ((_e3875 + _e3880) + select(0u, 1u, (_e3883 < _e3877)));
                                            let _e3898 = ((_e3883 >> bitcast<u32>(1u)) | ((_e3887 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e3899 = function_12(17u);
                                            let _e3902 = (_e3898 + _e3899.member_1);
                                            let _e3906 = ((bitcast<u32>((bitcast<i32>(_e3887) >> bitcast<u32>(1u))) + _e3899.member) + select(0u, 1u, (_e3902 < _e3898)));
                                            let _e3909 = local_17[0u].member;
                                            let _e3911 = local_17[0u].member_1;
                                            let _e3914 = local_17[2u].member;
                                            let _e3916 = local_17[2u].member_1;
                                            let _e3917 = (_e3911 + _e3916);
                                            let _e3921 = ((_e3909 + _e3914) + select(0u, 1u, (_e3917 < _e3911)));
                                            let _e3932 = ((_e3917 >> bitcast<u32>(1u)) | ((_e3921 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e3933 = function_12(17u);
                                            let _e3936 = (_e3932 + _e3933.member_1);
                                            let _e3940 = ((bitcast<u32>((bitcast<i32>(_e3921) >> bitcast<u32>(1u))) + _e3933.member) + select(0u, 1u, (_e3936 < _e3932)));
                                            let _e3943 = local_17[0u].member;
                                            let _e3945 = local_17[0u].member_1;
                                            let _e3948 = local_17[1u].member;
                                            let _e3950 = local_17[1u].member_1;
                                            let _e3951 = (_e3945 + _e3950);
                                            let _e3955 = ((_e3943 + _e3948) + select(0u, 1u, (_e3951 < _e3945)));
                                            let _e3966 = ((_e3951 >> bitcast<u32>(1u)) | ((_e3955 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e3967 = function_12(17u);
                                            let _e3970 = (_e3966 + _e3967.member_1);
                                            let _e3974 = ((bitcast<u32>((bitcast<i32>(_e3955) >> bitcast<u32>(1u))) + _e3967.member) + select(0u, 1u, (_e3970 < _e3966)));
                                            let _e3979 = ((_e3872.member >> bitcast<u32>(31i)) != 0u);
                                            if ((((_e3906 - select(_e3872.member, (~(_e3872.member) + select(0u, 1u, (_e3872.member_1 == 0u))), _e3979)) - select(0u, 1u, (_e3902 < select(_e3872.member_1, (~(_e3872.member_1) + 1u), _e3979)))) >> bitcast<u32>(31i)) != 0u) {
                                                let _e4000 = ((_e3872.member >> bitcast<u32>(31i)) != 0u);
                                                let _e4010 = select(_e3872.member, (~(_e3872.member) + select(0u, 1u, (_e3872.member_1 == 0u))), _e4000);
                                                let _e4012 = select(_e3872.member_1, (~(_e3872.member_1) + 1u), _e4000);
                                                let _e4013 = function_11(_e3845, _e3867);
                                                let _e4023 = select(_e4013.member, (~(_e4013.member) + select(0u, 1u, (_e4013.member_1 == 0u))), _e4000);
                                                let _e4025 = select(_e4013.member_1, (~(_e4013.member_1) + 1u), _e4000);
                                                let _e4026 = function_11(_e3856, _e3845);
                                                let _e4036 = select(_e4026.member, (~(_e4026.member) + select(0u, 1u, (_e4026.member_1 == 0u))), _e4000);
                                                let _e4038 = select(_e4026.member_1, (~(_e4026.member_1) + 1u), _e4000);
                                                if (_e283.member != 0u) {
                                                    let _e4070 = (_e3902 + _e3936);
                                                    let _e4082 = (_e3902 + _e3970);
                                                    phi_6990_ = type_9(((_e3906 + _e3974) + select(0u, 1u, (_e4082 < _e3902))), _e4082);
                                                    phi_6991_ = type_9(((_e4010 - _e4036) - select(0u, 1u, (_e4012 < _e4038))), (_e4012 - _e4038));
                                                    phi_6992_ = type_9(((_e3906 + _e3940) + select(0u, 1u, (_e4070 < _e3902))), _e4070);
                                                    phi_6993_ = type_9(((_e4010 - _e4023) - select(0u, 1u, (_e4012 < _e4025))), (_e4012 - _e4025));
                                                } else {
                                                    let _e4044 = (_e4012 - _e4025);
                                                    let _e4048 = ((((_e4010 - _e4023) - select(0u, 1u, (_e4012 < _e4025))) - _e4036) - select(0u, 1u, (_e4044 < _e4038)));
                                                    let _e4049 = (_e4044 - _e4038);
                                                    let _e4051 = (_e3902 + _e3936);
                                                    let _e4056 = (_e4051 + _e3970);
                                                    let _e4060 = ((((_e3906 + _e3940) + select(0u, 1u, (_e4051 < _e3902))) + _e3974) + select(0u, 1u, (_e4056 < _e4051)));
                                                    phi_6990_ = type_9(_e4060, _e4056);
                                                    phi_6991_ = type_9(_e4048, _e4049);
                                                    phi_6992_ = type_9(_e4060, _e4056);
                                                    phi_6993_ = type_9(_e4048, _e4049);
                                                }
                                                let _e4089 = phi_6990_;
                                                let _e4091 = phi_6991_;
                                                let _e4093 = phi_6992_;
                                                let _e4095 = phi_6993_;
                                                let _e4096 = function_9(_e4023, _e4025, _e3940, _e3936);
                                                if _e4096 {
                                                    phi_7119_ = u32();
                                                    phi_7120_ = true;
                                                } else {
                                                    let _e4097 = function_9(_e4036, _e4038, _e3974, _e3970);
                                                    if _e4097 {
                                                        phi_7117_ = u32();
                                                        phi_7118_ = true;
                                                    } else {
                                                        let _e4102 = function_9(_e4095.member, _e4095.member_1, _e4093.member, _e4093.member_1);
                                                        if _e4102 {
                                                            phi_7115_ = u32();
                                                            phi_7116_ = true;
                                                        } else {
                                                            let _e4107 = function_9(_e4091.member, _e4091.member_1, _e4089.member, _e4089.member_1);
                                                            if _e4107 {
                                                                phi_7114_ = u32();
                                                            } else {
                                                                let _e4108 = function_8(_e4023, _e4025, _e3940, _e3936);
                                                                if _e4108 {
                                                                    let _e4109 = function_8(_e4036, _e4038, _e3974, _e3970);
                                                                    if _e4109 {
                                                                        let _e4114 = function_8(_e4095.member, _e4095.member_1, _e4093.member, _e4093.member_1);
                                                                        if _e4114 {
                                                                            let _e4119 = function_8(_e4091.member, _e4091.member_1, _e4089.member, _e4089.member_1);
                                                                            phi_7107_ = select(true, false, _e4119);
                                                                        } else {
                                                                            phi_7107_ = true;
                                                                        }
                                                                        let _e4122 = phi_7107_;
                                                                        phi_7108_ = _e4122;
                                                                    } else {
                                                                        phi_7108_ = true;
                                                                    }
                                                                    let _e4124 = phi_7108_;
                                                                    phi_7109_ = _e4124;
                                                                } else {
                                                                    phi_7109_ = true;
                                                                }
                                                                let _e4126 = phi_7109_;
                                                                phi_7114_ = select(0u, 2u, _e4126);
                                                            }
                                                            let _e4129 = phi_7114_;
                                                            phi_7115_ = _e4129;
                                                            phi_7116_ = _e4107;
                                                        }
                                                        let _e4131 = phi_7115_;
                                                        let _e4133 = phi_7116_;
                                                        phi_7117_ = _e4131;
                                                        phi_7118_ = _e4133;
                                                    }
                                                    let _e4135 = phi_7117_;
                                                    let _e4137 = phi_7118_;
                                                    phi_7119_ = _e4135;
                                                    phi_7120_ = _e4137;
                                                }
                                                let _e4139 = phi_7119_;
                                                let _e4141 = phi_7120_;
                                                phi_7125_ = select(_e4139, 1u, _e4141);
                                            } else {
                                                phi_7125_ = 2u;
                                            }
                                            let _e4144 = phi_7125_;
                                            let _e4145 = (_e4144 == 1u);
                                            phi_7137_ = _e4145;
                                            phi_7138_ = _e3068;
                                            phi_7139_ = _e3070;
                                            phi_7140_ = (_e2849 + (1u << bitcast<u32>(((31u - _e3077) & 31u))));
                                            phi_7141_ = _e4144;
                                            phi_7142_ = select(true, _e4145, _e2994);
                                        } else {
                                            phi_7137_ = _e2993;
                                            phi_7138_ = bool();
                                            phi_7139_ = bool();
                                            phi_7140_ = u32();
                                            phi_7141_ = u32();
                                            phi_7142_ = true;
                                        }
                                        let _e4148 = phi_7137_;
                                        let _e4150 = phi_7138_;
                                        let _e4152 = phi_7139_;
                                        let _e4154 = phi_7140_;
                                        let _e4156 = phi_7141_;
                                        let _e4158 = phi_7142_;
                                        if _e4158 {
                                            if _e4148 {
                                                phi_7479_ = _e2827;
                                                phi_7481_ = _e2829;
                                                phi_7482_ = _e2831;
                                            } else {
                                                let _e4167 = (_e2827[0].member_1 + _e2827[1].member_1);
                                                let _e4171 = ((_e2827[0].member + _e2827[1].member) + select(0u, 1u, (_e4167 < _e2827[0].member_1)));
                                                let _e4179 = bitcast<u32>((bitcast<i32>(_e4171) >> bitcast<u32>(1u)));
                                                let _e4182 = ((_e4167 >> bitcast<u32>(1u)) | ((_e4171 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4191 = (_e2827[1].member_1 + _e2827[2].member_1);
                                                let _e4195 = ((_e2827[1].member + _e2827[2].member) + select(0u, 1u, (_e4191 < _e2827[1].member_1)));
                                                let _e4203 = bitcast<u32>((bitcast<i32>(_e4195) >> bitcast<u32>(1u)));
                                                let _e4206 = ((_e4191 >> bitcast<u32>(1u)) | ((_e4195 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4215 = (_e2827[2].member_1 + _e2827[3].member_1);
                                                let _e4219 = ((_e2827[2].member + _e2827[3].member) + select(0u, 1u, (_e4215 < _e2827[2].member_1)));
                                                let _e4227 = bitcast<u32>((bitcast<i32>(_e4219) >> bitcast<u32>(1u)));
                                                let _e4230 = ((_e4215 >> bitcast<u32>(1u)) | ((_e4219 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4231 = (_e4182 + _e4206);
                                                let _e4235 = ((_e4179 + _e4203) + select(0u, 1u, (_e4231 < _e4182)));
                                                let _e4243 = bitcast<u32>((bitcast<i32>(_e4235) >> bitcast<u32>(1u)));
                                                let _e4246 = ((_e4231 >> bitcast<u32>(1u)) | ((_e4235 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4247 = (_e4206 + _e4230);
                                                let _e4251 = ((_e4203 + _e4227) + select(0u, 1u, (_e4247 < _e4206)));
                                                let _e4259 = bitcast<u32>((bitcast<i32>(_e4251) >> bitcast<u32>(1u)));
                                                let _e4262 = ((_e4247 >> bitcast<u32>(1u)) | ((_e4251 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4263 = (_e4246 + _e4262);
                                                let _e4267 = ((_e4243 + _e4259) + select(0u, 1u, (_e4263 < _e4246)));
                                                let _e4275 = bitcast<u32>((bitcast<i32>(_e4267) >> bitcast<u32>(1u)));
                                                let _e4278 = ((_e4263 >> bitcast<u32>(1u)) | ((_e4267 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4279 = (2u * _e2831);
                                                let _e4290 = function_12(128u);
                                                let _e4295 = ((_e2827[0].member >> bitcast<u32>(31i)) != 0u);
                                                let _e4319 = function_12(128u);
                                                let _e4324 = ((_e4179 >> bitcast<u32>(31i)) != 0u);
                                                let _e4346 = function_12(128u);
                                                let _e4351 = ((_e4243 >> bitcast<u32>(31i)) != 0u);
                                                let _e4373 = function_12(128u);
                                                let _e4378 = ((_e4275 >> bitcast<u32>(31i)) != 0u);
                                                if ((((select(0u, select(1u, 2u, ((_e2827[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e4290.member - select(_e2827[0].member, (~(_e2827[0].member) + select(0u, 1u, (_e2827[0].member_1 == 0u))), _e4295)) - select(0u, 1u, (_e4290.member_1 < select(_e2827[0].member_1, (~(_e2827[0].member_1) + 1u), _e4295)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e4179 >> bitcast<u32>(31i)) != 0u)), ((((_e4319.member - select(_e4179, (~(_e4179) + select(0u, 1u, (_e4182 == 0u))), _e4324)) - select(0u, 1u, (_e4319.member_1 < select(_e4182, (~(_e4182) + 1u), _e4324)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e4243 >> bitcast<u32>(31i)) != 0u)), ((((_e4346.member - select(_e4243, (~(_e4243) + select(0u, 1u, (_e4246 == 0u))), _e4351)) - select(0u, 1u, (_e4346.member_1 < select(_e4246, (~(_e4246) + 1u), _e4351)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e4275 >> bitcast<u32>(31i)) != 0u)), ((((_e4373.member - select(_e4275, (~(_e4275) + select(0u, 1u, (_e4278 == 0u))), _e4378)) - select(0u, 1u, (_e4373.member_1 < select(_e4278, (~(_e4278) + 1u), _e4378)))) >> bitcast<u32>(31i)) != 0u))) != 0u) {
                                                    phi_7477_ = array<type_9, 4>(type_9(_e4275, _e4278), type_9(_e4259, _e4262), type_9(_e4227, _e4230), _e2827[3]);
                                                    phi_7478_ = (_e4279 + 1u);
                                                } else {
                                                    phi_7477_ = array<type_9, 4>(_e2827[0], type_9(_e4179, _e4182), type_9(_e4243, _e4246), type_9(_e4275, _e4278));
                                                    phi_7478_ = _e4279;
                                                }
                                                let _e4408 = phi_7477_;
                                                let _e4410 = phi_7478_;
                                                phi_7479_ = _e4408;
                                                phi_7481_ = (_e2829 + 1u);
                                                phi_7482_ = _e4410;
                                            }
                                            let _e4412 = phi_7479_;
                                            let _e4414 = phi_7481_;
                                            let _e4416 = phi_7482_;
                                            phi_7483_ = _e4412;
                                            phi_7485_ = _e4414;
                                            phi_7486_ = _e4416;
                                        } else {
                                            phi_7483_ = array<type_9, 4>();
                                            phi_7485_ = u32();
                                            phi_7486_ = u32();
                                        }
                                        let _e4418 = phi_7483_;
                                        let _e4420 = phi_7485_;
                                        let _e4422 = phi_7486_;
                                        phi_7487_ = _e4418;
                                        phi_7489_ = _e4148;
                                        phi_7490_ = _e4420;
                                        phi_7491_ = _e4422;
                                        phi_7492_ = _e4150;
                                        phi_7493_ = _e4152;
                                        phi_7494_ = _e4154;
                                        phi_7495_ = _e4156;
                                        phi_7496_ = _e4158;
                                    }
                                    let _e4424 = phi_7487_;
                                    let _e4426 = phi_7489_;
                                    let _e4428 = phi_7490_;
                                    let _e4430 = phi_7491_;
                                    let _e4432 = phi_7492_;
                                    let _e4434 = phi_7493_;
                                    let _e4436 = phi_7494_;
                                    let _e4438 = phi_7495_;
                                    let _e4440 = phi_7496_;
                                    if _e4440 {
                                        if _e4426 {
                                            let _e4441 = (_e4430 + 1u);
                                            let _e4443 = (_e4441 & (4294967295u - _e4430));
                                            let _e4449 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e4443)), 32u, (_e4443 == 0u)));
                                            let _e4451 = select(_e4449, _e4428, (_e4428 < _e4449));
                                            let _e4454 = (_e4441 >> bitcast<u32>((_e4451 & 31u)));
                                            let _e4455 = (_e4428 - _e4451);
                                            let _e4459 = select(true, select(true, false, (_e4455 == 0u)), (_e4454 == 1u));
                                            if _e4459 {
                                                let _e4460 = (31u - _e4455);
                                                let _e4463 = (_e4454 << bitcast<u32>((_e4460 & 31u)));
                                                let _e4467 = ((_e4454 + 1u) << bitcast<u32>((_e4460 & 31u)));
                                                let _e4473 = function_6(((_e2713 - _e2640.member) - select(0u, 1u, (_e2709 < _e2640.member_1))), (_e2709 - _e2640.member_1), _e4463);
                                                let _e4476 = (_e2640.member_1 + _e4473.member_1);
                                                let _e4486 = function_6(((_e2784 - _e2713) - select(0u, 1u, (_e2780 < _e2709))), (_e2780 - _e2709), _e4463);
                                                let _e4489 = (_e2709 + _e4486.member_1);
                                                let _e4499 = function_6(((_e2818.member - _e2784) - select(0u, 1u, (_e2818.member_1 < _e2780))), (_e2818.member_1 - _e2780), _e4463);
                                                let _e4502 = (_e2780 + _e4499.member_1);
                                                let _e4510 = array<type_9, 3>(type_9(((_e2640.member + _e4473.member) + select(0u, 1u, (_e4476 < _e2640.member_1))), _e4476), type_9(((_e2713 + _e4486.member) + select(0u, 1u, (_e4489 < _e2709))), _e4489), type_9(((_e2784 + _e4499.member) + select(0u, 1u, (_e4502 < _e2780))), _e4502));
                                                let _e4516 = function_6(((_e2713 - _e2640.member) - select(0u, 1u, (_e2709 < _e2640.member_1))), (_e2709 - _e2640.member_1), _e4467);
                                                let _e4519 = (_e2640.member_1 + _e4516.member_1);
                                                let _e4529 = function_6(((_e2784 - _e2713) - select(0u, 1u, (_e2780 < _e2709))), (_e2780 - _e2709), _e4467);
                                                let _e4532 = (_e2709 + _e4529.member_1);
                                                let _e4542 = function_6(((_e2818.member - _e2784) - select(0u, 1u, (_e2818.member_1 < _e2780))), (_e2818.member_1 - _e2780), _e4467);
                                                let _e4545 = (_e2780 + _e4542.member_1);
                                                let _e4554 = function_7(_e4510, _e4463);
                                                let _e4555 = function_7(_e4510, _e4467);
                                                let _e4556 = function_7(array<type_9, 3>(type_9(((_e2640.member + _e4516.member) + select(0u, 1u, (_e4519 < _e2640.member_1))), _e4519), type_9(((_e2713 + _e4529.member) + select(0u, 1u, (_e4532 < _e2709))), _e4532), type_9(((_e2784 + _e4542.member) + select(0u, 1u, (_e4545 < _e2780))), _e4545)), _e4467);
                                                let _e4570 = function_6(((_e4554[1].member - _e4554[0].member) - select(0u, 1u, (_e4554[1].member_1 < _e4554[0].member_1))), (_e4554[1].member_1 - _e4554[0].member_1), _e4463);
                                                let _e4573 = (_e4554[0].member_1 + _e4570.member_1);
                                                let _e4591 = function_6(((_e4554[1].member - _e4554[0].member) - select(0u, 1u, (_e4554[1].member_1 < _e4554[0].member_1))), (_e4554[1].member_1 - _e4554[0].member_1), _e4467);
                                                let _e4594 = (_e4554[0].member_1 + _e4591.member_1);
                                                let _e4612 = function_6(((_e4555[1].member - _e4555[0].member) - select(0u, 1u, (_e4555[1].member_1 < _e4555[0].member_1))), (_e4555[1].member_1 - _e4555[0].member_1), _e4467);
                                                let _e4615 = (_e4555[0].member_1 + _e4612.member_1);
                                                let _e4633 = function_6(((_e4556[1].member - _e4556[0].member) - select(0u, 1u, (_e4556[1].member_1 < _e4556[0].member_1))), (_e4556[1].member_1 - _e4556[0].member_1), _e4467);
                                                let _e4636 = (_e4556[0].member_1 + _e4633.member_1);
                                                phi_7791_ = array<type_9, 4>(type_9(((_e4554[0].member + _e4570.member) + select(0u, 1u, (_e4573 < _e4554[0].member_1))), _e4573), type_9(((_e4554[0].member + _e4591.member) + select(0u, 1u, (_e4594 < _e4554[0].member_1))), _e4594), type_9(((_e4555[0].member + _e4612.member) + select(0u, 1u, (_e4615 < _e4555[0].member_1))), _e4615), type_9(((_e4556[0].member + _e4633.member) + select(0u, 1u, (_e4636 < _e4556[0].member_1))), _e4636));
                                            } else {
                                                phi_7791_ = array<type_9, 4>();
                                            }
                                            let _e4647 = phi_7791_;
                                            phi_7792_ = _e4647;
                                            phi_7793_ = _e4455;
                                            phi_7794_ = _e4454;
                                            phi_7795_ = _e4459;
                                        } else {
                                            phi_7792_ = _e4424;
                                            phi_7793_ = _e4428;
                                            phi_7794_ = _e4430;
                                            phi_7795_ = true;
                                        }
                                        let _e4649 = phi_7792_;
                                        let _e4651 = phi_7793_;
                                        let _e4653 = phi_7794_;
                                        let _e4655 = phi_7795_;
                                        phi_7800_ = _e4649;
                                        phi_7801_ = _e4651;
                                        phi_7802_ = _e4653;
                                        phi_7803_ = _e4655;
                                        phi_7804_ = select(true, false, _e4655);
                                        phi_7805_ = false;
                                    } else {
                                        phi_7800_ = array<type_9, 4>();
                                        phi_7801_ = u32();
                                        phi_7802_ = u32();
                                        phi_7803_ = false;
                                        phi_7804_ = false;
                                        phi_7805_ = true;
                                    }
                                    let _e4658 = phi_7800_;
                                    let _e4660 = phi_7801_;
                                    let _e4662 = phi_7802_;
                                    let _e4664 = phi_7803_;
                                    let _e4666 = phi_7804_;
                                    let _e4668 = phi_7805_;
                                    phi_7806_ = _e4658;
                                    phi_7808_ = _e4660;
                                    phi_7809_ = _e4662;
                                    phi_7810_ = _e4432;
                                    phi_7811_ = _e4434;
                                    phi_7812_ = _e4436;
                                    phi_7813_ = _e4438;
                                    phi_7814_ = _e4664;
                                    phi_7815_ = _e4666;
                                    phi_7816_ = _e4668;
                                }
                                let _e4670 = phi_7806_;
                                let _e4672 = phi_7808_;
                                let _e4674 = phi_7809_;
                                let _e4676 = phi_7810_;
                                let _e4678 = phi_7811_;
                                let _e4680 = phi_7812_;
                                let _e4682 = phi_7813_;
                                let _e4684 = phi_7814_;
                                let _e4686 = phi_7815_;
                                let _e4688 = phi_7816_;
                                phi_5093_ = _e4670;
                                phi_5097_ = _e4672;
                                phi_5099_ = _e4674;
                                phi_7817_ = _e2849;
                                phi_7818_ = _e4676;
                                phi_7819_ = _e4678;
                                phi_7820_ = _e4680;
                                phi_7821_ = _e4682;
                                phi_7822_ = _e4684;
                                phi_7823_ = _e2854;
                                phi_7824_ = false;
                                phi_7825_ = _e4686;
                                phi_7826_ = _e4688;
                            } else {
                                phi_5093_ = array<type_9, 4>();
                                phi_5097_ = u32();
                                phi_5099_ = u32();
                                phi_7817_ = u32();
                                phi_7818_ = bool();
                                phi_7819_ = bool();
                                phi_7820_ = u32();
                                phi_7821_ = u32();
                                phi_7822_ = false;
                                phi_7823_ = false;
                                phi_7824_ = true;
                                phi_7825_ = false;
                                phi_7826_ = false;
                            }
                            let _e4690 = phi_5093_;
                            let _e4692 = phi_5097_;
                            let _e4694 = phi_5099_;
                            let _e4696 = phi_7817_;
                            let _e4698 = phi_7818_;
                            let _e4700 = phi_7819_;
                            let _e4702 = phi_7820_;
                            let _e4704 = phi_7821_;
                            let _e4706 = phi_7822_;
                            let _e4708 = phi_7823_;
                            let _e4710 = phi_7824_;
                            let _e4712 = phi_7825_;
                            let _e4714 = phi_7826_;
                            local_45 = _e4708;
                            local_46 = _e4708;
                            local_47 = _e4708;
                            local_48 = _e4710;
                            local_49 = _e4708;
                            local_50 = _e4712;
                            local_51 = _e4708;
                            local_52 = _e4714;
                            local_53 = _e4708;
                            local_54 = _e4700;
                            local_55 = _e4702;
                            local_59 = _e4702;
                            local_60 = _e4702;
                            local_61 = _e4702;
                            local_62 = _e4702;
                            local_63 = _e4702;
                            local_64 = _e4702;
                            local_65 = _e4702;
                            local_66 = _e4702;
                            local_67 = _e4702;
                            local_68 = _e4702;
                            local_69 = _e4702;
                            local_70 = _e4702;
                            local_71 = _e4702;
                            local_72 = _e4698;
                            local_73 = _e4696;
                            local_74 = _e4702;
                            local_75 = _e4704;
                            local_76 = _e4696;
                            continue;
                            continuing {
                                phi_5089_ = type_9(select(_e2825.member, (_e2825.member + 1u), _e2834), select(_e2825.member_1, _e2825.member_1, _e2834));
                                phi_5092_ = _e4690;
                                phi_5096_ = _e4692;
                                phi_5098_ = _e4694;
                                break if !(_e4706);
                            }
                        }
                        let _e4718 = local_45;
                        let _e4723 = local_46;
                        let _e4726 = local_47;
                        let _e4728 = local_48;
                        let _e4729 = select(_e4728, false, _e4726);
                        let _e4731 = local_49;
                        let _e4733 = local_50;
                        let _e4736 = local_51;
                        let _e4738 = local_52;
                        let _e4745 = select(select(_e4733, false, _e4731), false, _e4729);
                        let _e4748 = local_53;
                        if select(select(select(_e4738, false, _e4736), false, _e4729), false, _e4745) {
                            let _e4759 = local_54;
                            if _e4759 {
                                let _e4761 = local_55;
                                if (_e4761 <= 2147483648u) {
                                    let _e4764 = local_56;
                                    let _e4768 = local_57;
                                    let _e4771 = function_12(128u);
                                    let _e4776 = ((_e4764[0].member >> bitcast<u32>(31i)) != 0u);
                                    let _e4784 = local_58;
                                    let _e4808 = local_59;
                                    let _e4809 = function_6(((_e2713 - _e2640.member) - select(0u, 1u, (_e2709 < _e2640.member_1))), (_e2709 - _e2640.member_1), _e4808);
                                    let _e4812 = (_e2640.member_1 + _e4809.member_1);
                                    let _e4823 = local_60;
                                    let _e4824 = function_6(((_e2784 - _e2713) - select(0u, 1u, (_e2780 < _e2709))), (_e2780 - _e2709), _e4823);
                                    let _e4827 = (_e2709 + _e4824.member_1);
                                    let _e4838 = local_61;
                                    let _e4839 = function_6(((_e2818.member - _e2784) - select(0u, 1u, (_e2818.member_1 < _e2780))), (_e2818.member_1 - _e2780), _e4838);
                                    let _e4842 = (_e2780 + _e4839.member_1);
                                    let _e4850 = array<type_9, 3>(type_9(((_e2640.member + _e4809.member) + select(0u, 1u, (_e4812 < _e2640.member_1))), _e4812), type_9(((_e2713 + _e4824.member) + select(0u, 1u, (_e4827 < _e2709))), _e4827), type_9(((_e2784 + _e4839.member) + select(0u, 1u, (_e4842 < _e2780))), _e4842));
                                    let _e4857 = local_62;
                                    let _e4858 = function_6(((_e2713 - _e2640.member) - select(0u, 1u, (_e2709 < _e2640.member_1))), (_e2709 - _e2640.member_1), _e4857);
                                    let _e4861 = (_e2640.member_1 + _e4858.member_1);
                                    let _e4872 = local_63;
                                    let _e4873 = function_6(((_e2784 - _e2713) - select(0u, 1u, (_e2780 < _e2709))), (_e2780 - _e2709), _e4872);
                                    let _e4876 = (_e2709 + _e4873.member_1);
                                    let _e4887 = local_64;
                                    let _e4888 = function_6(((_e2818.member - _e2784) - select(0u, 1u, (_e2818.member_1 < _e2780))), (_e2818.member_1 - _e2780), _e4887);
                                    let _e4891 = (_e2780 + _e4888.member_1);
                                    let _e4901 = local_65;
                                    let _e4902 = function_7(_e4850, _e4901);
                                    let _e4904 = local_66;
                                    let _e4905 = function_7(_e4850, _e4904);
                                    let _e4907 = local_67;
                                    let _e4908 = function_7(array<type_9, 3>(type_9(((_e2640.member + _e4858.member) + select(0u, 1u, (_e4861 < _e2640.member_1))), _e4861), type_9(((_e2713 + _e4873.member) + select(0u, 1u, (_e4876 < _e2709))), _e4876), type_9(((_e2784 + _e4888.member) + select(0u, 1u, (_e4891 < _e2780))), _e4891)), _e4907);
                                    let _e4923 = local_68;
                                    let _e4924 = function_6(((_e4902[1].member - _e4902[0].member) - select(0u, 1u, (_e4902[1].member_1 < _e4902[0].member_1))), (_e4902[1].member_1 - _e4902[0].member_1), _e4923);
                                    let _e4927 = (_e4902[0].member_1 + _e4924.member_1);
                                    let _e4931 = ((_e4902[0].member + _e4924.member) + select(0u, 1u, (_e4927 < _e4902[0].member_1)));
                                    let _e4946 = local_69;
                                    let _e4947 = function_6(((_e4902[1].member - _e4902[0].member) - select(0u, 1u, (_e4902[1].member_1 < _e4902[0].member_1))), (_e4902[1].member_1 - _e4902[0].member_1), _e4946);
                                    let _e4962 = local_70;
                                    let _e4963 = function_6(((_e4905[1].member - _e4905[0].member) - select(0u, 1u, (_e4905[1].member_1 < _e4905[0].member_1))), (_e4905[1].member_1 - _e4905[0].member_1), _e4962);
                                    let _e4978 = local_71;
                                    let _e4979 = function_6(((_e4908[1].member - _e4908[0].member) - select(0u, 1u, (_e4908[1].member_1 < _e4908[0].member_1))), (_e4908[1].member_1 - _e4908[0].member_1), _e4978);
                                    let _e4980 = function_12(128u);
                                    let _e4985 = ((_e4931 >> bitcast<u32>(31i)) != 0u);
                                    phi_8201_ = ((select(0u, select(1u, 2u, ((_e4764[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e4771.member - select(_e4784[0].member, (~(_e4764[0].member) + select(0u, 1u, (_e4768[0].member_1 == 0u))), _e4776)) - select(0u, 1u, (_e4771.member_1 < select(_e4784[0].member_1, (~(_e4768[0].member_1) + 1u), _e4776)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e4931 >> bitcast<u32>(31i)) != 0u)), ((((_e4980.member - select(_e4931, (~(_e4931) + select(0u, 1u, (_e4927 == 0u))), _e4985)) - select(0u, 1u, (_e4980.member_1 < select(_e4927, (~(_e4927) + 1u), _e4985)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                    phi_8202_ = false;
                                } else {
                                    phi_8201_ = bool();
                                    phi_8202_ = true;
                                }
                                let _e5009 = phi_8201_;
                                let _e5011 = phi_8202_;
                                phi_8203_ = _e5009;
                                phi_8204_ = _e5011;
                            } else {
                                phi_8203_ = bool();
                                phi_8204_ = true;
                            }
                            let _e5013 = phi_8203_;
                            let _e5015 = phi_8204_;
                            let _e5017 = local_72;
                            let _e5018 = select(_e5013, _e5017, _e5015);
                            let _e5020 = local_73;
                            let _e5023 = local_74;
                            let _e5025 = select(false, (_e5023 <= _e1314), (_e5020 >= _e1312));
                            let _e5027 = local_75;
                            let _e5033 = select(select(bool(), select(bool(), (_e5027 == 0u), _e5025), _e5018), false, select(true, select(true, false, _e5025), _e5018));
                            let _e5037 = local_76;
                            phi_8236_ = type_9(select(2u, 1u, _e5033), select(type_9().member_1, _e5037, _e5033));
                            phi_8237_ = true;
                            phi_8238_ = false;
                        } else {
                            phi_8236_ = type_9(select(type_9().member, 0u, _e4745), select(type_9().member_1, type_9().member_1, _e4745));
                            phi_8237_ = _e4745;
                            phi_8238_ = select(select(_e4748, false, _e4729), false, _e4745);
                        }
                        let _e5041 = phi_8236_;
                        let _e5043 = phi_8237_;
                        let _e5045 = phi_8238_;
                        let _e5050 = select(_e5045, true, _e5043);
                        let _e5052 = select(select(type_9().member_1, type_9().member_1, _e4729), select(select(type_9().member_1, type_9().member_1, _e4723), _e5041.member_1, _e5043), _e5050);
                        switch bitcast<i32>(select(select(type_9().member, 2u, _e4729), select(select(type_9().member, 0u, _e4718), _e5041.member, _e5043), _e5050)) {
                            case 0: {
                                phi_8284_ = type_35(0u, 0u, array<u32, 2>(0u, 0u), false);
                                break;
                            }
                            case 1: {
                                if (_e5052 == 0u) {
                                    phi_8278_ = array<u32, 2>(0u, 0u);
                                } else {
                                    let _e5061 = select((bitcast<u32>(31i) - firstLeadingBit(_e5052)), 32u, (_e5052 == 0u));
                                    let _e5066 = ((_e5052 << bitcast<u32>((_e5061 & 31u))) << bitcast<u32>(1i));
                                    phi_8278_ = array<u32, 2>((_e5066 << bitcast<u32>(20i)), (((1023u - _e5061) << bitcast<u32>(20i)) | (_e5066 >> bitcast<u32>(12i))));
                                }
                                let _e5077 = phi_8278_;
                                phi_8284_ = type_35(0u, select(0u, 1u, (_e5052 > _e1312)), _e5077, true);
                                break;
                            }
                            case 2: {
                                phi_8284_ = type_35(1u, 0u, array<u32, 2>(0u, 0u), true);
                                break;
                            }
                            default: {
                                phi_8284_ = type_35();
                                break;
                            }
                        }
                        let _e5080 = phi_8284_;
                        phi_8291_ = _e5080;
                        phi_8292_ = select(true, false, (_e5080.member == 0u));
                    } else {
                        phi_8291_ = type_35();
                        phi_8292_ = true;
                    }
                    let _e5085 = phi_8291_;
                    let _e5087 = phi_8292_;
                    phi_8293_ = _e5085;
                    phi_8294_ = _e5087;
                } else {
                    phi_8293_ = type_35();
                    phi_8294_ = true;
                }
                let _e5089 = phi_8293_;
                let _e5091 = phi_8294_;
                if _e5091 {
                    let _e5093 = params.member.member.member_11;
                    let _e5095 = params.member.member.member_12;
                    let _e5097 = params.member.member.member_13;
                    let _e5099 = params.member.member.member_13;
                    let _e5105 = select(_e539.member[0][0], -(_e539.member[0][0]), (_e539.member[0][0] < 0f));
                    let _e5109 = select(_e539.member[0][1], -(_e539.member[0][1]), (_e539.member[0][1] < 0f));
                    let _e5111 = select(_e5109, _e5105, (_e5105 > _e5109));
                    let _e5115 = select(_e539.member[0][2], -(_e539.member[0][2]), (_e539.member[0][2] < 0f));
                    let _e5117 = select(_e5115, _e5111, (_e5111 > _e5115));
                    let _e5123 = select(_e539.member[1][0], -(_e539.member[1][0]), (_e539.member[1][0] < 0f));
                    let _e5127 = select(_e539.member[1][1], -(_e539.member[1][1]), (_e539.member[1][1] < 0f));
                    let _e5129 = select(_e5127, _e5123, (_e5123 > _e5127));
                    let _e5133 = select(_e539.member[1][2], -(_e539.member[1][2]), (_e539.member[1][2] < 0f));
                    let _e5135 = select(_e5133, _e5129, (_e5129 > _e5133));
                    let _e5139 = (select(_e5135, _e5117, (_e5117 > _e5135)) + _e539.member_3);
                    let _e5145 = select(_e539.member_1[0][0], -(_e539.member_1[0][0]), (_e539.member_1[0][0] < 0f));
                    let _e5149 = select(_e539.member_1[0][1], -(_e539.member_1[0][1]), (_e539.member_1[0][1] < 0f));
                    let _e5151 = select(_e5149, _e5145, (_e5145 > _e5149));
                    let _e5155 = select(_e539.member_1[0][2], -(_e539.member_1[0][2]), (_e539.member_1[0][2] < 0f));
                    let _e5157 = select(_e5155, _e5151, (_e5151 > _e5155));
                    let _e5163 = select(_e539.member_1[1][0], -(_e539.member_1[1][0]), (_e539.member_1[1][0] < 0f));
                    let _e5167 = select(_e539.member_1[1][1], -(_e539.member_1[1][1]), (_e539.member_1[1][1] < 0f));
                    let _e5169 = select(_e5167, _e5163, (_e5163 > _e5167));
                    let _e5173 = select(_e539.member_1[1][2], -(_e539.member_1[1][2]), (_e539.member_1[1][2] < 0f));
                    let _e5175 = select(_e5173, _e5169, (_e5169 > _e5173));
                    let _e5179 = (select(_e5175, _e5157, (_e5157 > _e5175)) + _e539.member_3);
                    let _e5185 = select(_e539.member_2[0][0], -(_e539.member_2[0][0]), (_e539.member_2[0][0] < 0f));
                    let _e5189 = select(_e539.member_2[0][1], -(_e539.member_2[0][1]), (_e539.member_2[0][1] < 0f));
                    let _e5191 = select(_e5189, _e5185, (_e5185 > _e5189));
                    let _e5195 = select(_e539.member_2[0][2], -(_e539.member_2[0][2]), (_e539.member_2[0][2] < 0f));
                    let _e5197 = select(_e5195, _e5191, (_e5191 > _e5195));
                    let _e5203 = select(_e539.member_2[1][0], -(_e539.member_2[1][0]), (_e539.member_2[1][0] < 0f));
                    let _e5207 = select(_e539.member_2[1][1], -(_e539.member_2[1][1]), (_e539.member_2[1][1] < 0f));
                    let _e5209 = select(_e5207, _e5203, (_e5203 > _e5207));
                    let _e5213 = select(_e539.member_2[1][2], -(_e539.member_2[1][2]), (_e539.member_2[1][2] < 0f));
                    let _e5215 = select(_e5213, _e5209, (_e5209 > _e5213));
                    let _e5219 = (select(_e5215, _e5197, (_e5197 > _e5215)) + _e539.member_3);
                    let _e5221 = select(_e5179, _e5139, (_e5139 > _e5179));
                    let _e5223 = select(_e5219, _e5221, (_e5221 > _e5219));
                    if (_e5223 <= 65536f) {
                        phi_8565_ = (_e5223 >= (1f / 65536f));
                    } else {
                        phi_8565_ = false;
                    }
                    let _e5228 = phi_8565_;
                    if _e5228 {
                        phi_8663_ = type_33();
                        phi_8664_ = true;
                    } else {
                        if (_e5223 >= 0.000000000000000000000000000000000000011754944f) {
                            if ((bitcast<u32>(_e5223) & 2139095040u) != 2139095040u) {
                                let _e5235 = (2130706432u - (bitcast<u32>(_e5223) & 2139095040u));
                                let _e5238 = bitcast<f32>(select(8388608u, _e5235, (_e5235 > 8388608u)));
                                phi_8659_ = type_33(type_28(array<array<f32, 3>, 2>(array<f32, 3>((_e539.member[0][0] * _e5238), (_e539.member[0][1] * _e5238), (_e539.member[0][2] * _e5238)), array<f32, 3>((_e539.member[1][0] * _e5238), (_e539.member[1][1] * _e5238), (_e539.member[1][2] * _e5238))), array<array<f32, 3>, 2>(array<f32, 3>((_e539.member_1[0][0] * _e5238), (_e539.member_1[0][1] * _e5238), (_e539.member_1[0][2] * _e5238)), array<f32, 3>((_e539.member_1[1][0] * _e5238), (_e539.member_1[1][1] * _e5238), (_e539.member_1[1][2] * _e5238))), array<array<f32, 3>, 2>(array<f32, 3>((_e539.member_2[0][0] * _e5238), (_e539.member_2[0][1] * _e5238), (_e539.member_2[0][2] * _e5238)), array<f32, 3>((_e539.member_2[1][0] * _e5238), (_e539.member_2[1][1] * _e5238), (_e539.member_2[1][2] * _e5238))), ((_e539.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e5238)), (0f * _e5238));
                                phi_8660_ = false;
                            } else {
                                phi_8659_ = type_33();
                                phi_8660_ = true;
                            }
                            let _e5304 = phi_8659_;
                            let _e5306 = phi_8660_;
                            phi_8661_ = _e5304;
                            phi_8662_ = _e5306;
                        } else {
                            phi_8661_ = type_33();
                            phi_8662_ = true;
                        }
                        let _e5308 = phi_8661_;
                        let _e5310 = phi_8662_;
                        phi_8663_ = _e5308;
                        phi_8664_ = _e5310;
                    }
                    let _e5312 = phi_8663_;
                    let _e5314 = phi_8664_;
                    if _e5314 {
                        phi_8669_ = type_33(_e539, 0f);
                    } else {
                        phi_8669_ = _e5312;
                    }
                    let _e5317 = phi_8669_;
                    local_10 = type_28(array<array<f32, 3>, 2>(array<f32, 3>(_e5317.member.member[0][0], _e5317.member.member[0][1], _e5317.member.member[0][2]), array<f32, 3>(_e5317.member.member[1][0], _e5317.member.member[1][1], _e5317.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e5317.member.member_1[0][0], _e5317.member.member_1[0][1], _e5317.member.member_1[0][2]), array<f32, 3>(_e5317.member.member_1[1][0], _e5317.member.member_1[1][1], _e5317.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e5317.member.member_2[0][0], _e5317.member.member_2[0][1], _e5317.member.member_2[0][2]), array<f32, 3>(_e5317.member.member_2[1][0], _e5317.member.member_2[1][1], _e5317.member.member_2[1][2])), _e5317.member.member_3);
                    let _e5359 = local_10.member_1[0u];
                    let _e5365 = local_10.member_2[0u];
                    let _e5371 = ((_e5359[1] * _e5365[2]) - (_e5359[2] * _e5365[1]));
                    let _e5374 = ((_e5359[2] * _e5365[0]) - (_e5359[0] * _e5365[2]));
                    let _e5377 = ((_e5359[0] * _e5365[1]) - (_e5359[1] * _e5365[0]));
                    let _e5380 = local_10.member_1[1u];
                    let _e5386 = local_10.member_2[1u];
                    let _e5392 = ((_e5380[1] * _e5386[2]) - (_e5380[2] * _e5386[1]));
                    let _e5395 = ((_e5380[2] * _e5386[0]) - (_e5380[0] * _e5386[2]));
                    let _e5398 = ((_e5380[0] * _e5386[1]) - (_e5380[1] * _e5386[0]));
                    let _e5401 = local_10.member_1[0u];
                    let _e5407 = local_10.member_2[1u];
                    let _e5422 = local_10.member_1[1u];
                    let _e5428 = local_10.member_2[0u];
                    let _e5441 = (((_e5401[1] * _e5407[2]) - (_e5401[2] * _e5407[1])) + ((_e5422[1] * _e5428[2]) - (_e5422[2] * _e5428[1])));
                    let _e5442 = (((_e5401[2] * _e5407[0]) - (_e5401[0] * _e5407[2])) + ((_e5422[2] * _e5428[0]) - (_e5422[0] * _e5428[2])));
                    let _e5443 = (((_e5401[0] * _e5407[1]) - (_e5401[1] * _e5407[0])) + ((_e5422[0] * _e5428[1]) - (_e5422[1] * _e5428[0])));
                    let _e5446 = local_10.member[0u];
                    let _e5454 = (((_e5446[0] * _e5371) + (_e5446[1] * _e5374)) + (_e5446[2] * _e5377));
                    let _e5457 = local_10.member[1u];
                    let _e5468 = local_10.member[0u];
                    let _e5477 = ((((_e5457[0] * _e5371) + (_e5457[1] * _e5374)) + (_e5457[2] * _e5377)) + (((_e5468[0] * _e5441) + (_e5468[1] * _e5442)) + (_e5468[2] * _e5443)));
                    let _e5480 = local_10.member[0u];
                    let _e5491 = local_10.member[1u];
                    let _e5500 = ((((_e5480[0] * _e5392) + (_e5480[1] * _e5395)) + (_e5480[2] * _e5398)) + (((_e5491[0] * _e5441) + (_e5491[1] * _e5442)) + (_e5491[2] * _e5443)));
                    let _e5503 = local_10.member[1u];
                    let _e5511 = (((_e5503[0] * _e5392) + (_e5503[1] * _e5395)) + (_e5503[2] * _e5398));
                    let _e5514 = local_10.member[0u];
                    let _e5520 = select(_e5514[0], -(_e5514[0]), (_e5514[0] < 0f));
                    let _e5523 = select(_e5514[1], -(_e5514[1]), (_e5514[1] < 0f));
                    let _e5525 = select(_e5523, _e5520, (_e5520 > _e5523));
                    let _e5528 = select(_e5514[2], -(_e5514[2]), (_e5514[2] < 0f));
                    let _e5530 = select(_e5528, _e5525, (_e5525 > _e5528));
                    let _e5533 = local_10.member[1u];
                    let _e5539 = select(_e5533[0], -(_e5533[0]), (_e5533[0] < 0f));
                    let _e5542 = select(_e5533[1], -(_e5533[1]), (_e5533[1] < 0f));
                    let _e5544 = select(_e5542, _e5539, (_e5539 > _e5542));
                    let _e5547 = select(_e5533[2], -(_e5533[2]), (_e5533[2] < 0f));
                    let _e5549 = select(_e5547, _e5544, (_e5544 > _e5547));
                    let _e5553 = local_10.member_3;
                    let _e5554 = (select(_e5549, _e5530, (_e5530 > _e5549)) + _e5553);
                    let _e5557 = local_10.member_1[0u];
                    let _e5563 = select(_e5557[0], -(_e5557[0]), (_e5557[0] < 0f));
                    let _e5566 = select(_e5557[1], -(_e5557[1]), (_e5557[1] < 0f));
                    let _e5568 = select(_e5566, _e5563, (_e5563 > _e5566));
                    let _e5571 = select(_e5557[2], -(_e5557[2]), (_e5557[2] < 0f));
                    let _e5573 = select(_e5571, _e5568, (_e5568 > _e5571));
                    let _e5576 = local_10.member_1[1u];
                    let _e5582 = select(_e5576[0], -(_e5576[0]), (_e5576[0] < 0f));
                    let _e5585 = select(_e5576[1], -(_e5576[1]), (_e5576[1] < 0f));
                    let _e5587 = select(_e5585, _e5582, (_e5582 > _e5585));
                    let _e5590 = select(_e5576[2], -(_e5576[2]), (_e5576[2] < 0f));
                    let _e5592 = select(_e5590, _e5587, (_e5587 > _e5590));
                    let _e5596 = local_10.member_3;
                    let _e5597 = (select(_e5592, _e5573, (_e5573 > _e5592)) + _e5596);
                    let _e5600 = local_10.member_2[0u];
                    let _e5606 = select(_e5600[0], -(_e5600[0]), (_e5600[0] < 0f));
                    let _e5609 = select(_e5600[1], -(_e5600[1]), (_e5600[1] < 0f));
                    let _e5611 = select(_e5609, _e5606, (_e5606 > _e5609));
                    let _e5614 = select(_e5600[2], -(_e5600[2]), (_e5600[2] < 0f));
                    let _e5616 = select(_e5614, _e5611, (_e5611 > _e5614));
                    let _e5619 = local_10.member_2[1u];
                    let _e5625 = select(_e5619[0], -(_e5619[0]), (_e5619[0] < 0f));
                    let _e5628 = select(_e5619[1], -(_e5619[1]), (_e5619[1] < 0f));
                    let _e5630 = select(_e5628, _e5625, (_e5625 > _e5628));
                    let _e5633 = select(_e5619[2], -(_e5619[2]), (_e5619[2] < 0f));
                    let _e5635 = select(_e5633, _e5630, (_e5630 > _e5633));
                    let _e5639 = local_10.member_3;
                    let _e5640 = (select(_e5635, _e5616, (_e5616 > _e5635)) + _e5639);
                    let _e5642 = ((_e5597 * 8f) * _e5640);
                    let _e5649 = local_10.member_3;
                    let _e5673 = ((select(_e5371, -(_e5371), (_e5371 < 0f)) + select(_e5374, -(_e5374), (_e5374 < 0f))) + select(_e5377, -(_e5377), (_e5377 < 0f)));
                    let _e5684 = ((select(_e5392, -(_e5392), (_e5392 < 0f)) + select(_e5395, -(_e5395), (_e5395 < 0f))) + select(_e5398, -(_e5398), (_e5398 < 0f)));
                    let _e5686 = select(_e5684, _e5673, (_e5673 > _e5684));
                    let _e5698 = (((select(_e5441, -(_e5441), (_e5441 < 0f)) + select(_e5442, -(_e5442), (_e5442 < 0f))) + select(_e5443, -(_e5443), (_e5443 < 0f))) * 0.5f);
                    let _e5705 = local_10.member_3;
                    let _e5717 = (((((_e5554 * 8f) * _e5642) * (0.000000059604645f * (524f / 64f))) + ((_e5649 * 19f) * ((_e5554 * (_e5597 + _e5640)) + (_e5597 * _e5640)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e5554) * ((1f + _e5597) * (1f + _e5640)))));
                    let _e5718 = (_e5454 * 3f);
                    let _e5719 = (_e5511 * 3f);
                    let _e5721 = select(_e5719, _e5718, (_e5718 < _e5719));
                    let _e5723 = select(_e5500, _e5477, (_e5477 < _e5500));
                    let _e5725 = select(_e5723, _e5721, (_e5721 < _e5723));
                    let _e5727 = select(_e5719, _e5718, (_e5718 > _e5719));
                    let _e5729 = select(_e5500, _e5477, (_e5477 > _e5500));
                    let _e5736 = -(select(_e5729, _e5727, (_e5727 > _e5729)));
                    if ((select(_e5736, _e5725, (_e5725 > _e5736)) - (_e5717 + ((0f * (((select(_e5698, _e5686, (_e5686 > _e5698)) + (_e5642 * (0.000000059604645f * 8f))) + ((_e5705 * 6f) * (_e5597 + _e5640))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e5597) * (1f + _e5640))))) * (3f * 1.0001f)))) > 0f) {
                        phi_14041_ = type_34(0u, type_34().member_1);
                        phi_14042_ = type_34();
                        phi_14043_ = true;
                    } else {
                        let _e5744 = select(_e5454, -(_e5454), (_e5454 < 0f));
                        let _e5747 = select(_e5477, -(_e5477), (_e5477 < 0f));
                        let _e5749 = select(_e5747, _e5744, (_e5744 > _e5747));
                        let _e5752 = select(_e5500, -(_e5500), (_e5500 < 0f));
                        let _e5755 = select(_e5511, -(_e5511), (_e5511 < 0f));
                        let _e5757 = select(_e5755, _e5752, (_e5752 > _e5755));
                        let _e5759 = select(_e5757, _e5749, (_e5749 > _e5757));
                        let _e5760 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e5759 >= _e5760) {
                            phi_9394_ = (_e5759 <= (1f / _e5760));
                        } else {
                            phi_9394_ = false;
                        }
                        let _e5765 = phi_9394_;
                        if _e5765 {
                            phi_9406_ = (1f / _e5759);
                        } else {
                            phi_9406_ = 0f;
                        }
                        let _e5772 = phi_9406_;
                        let _e5773 = (_e5093 * 0.0625f);
                        local_8 = type_38(array<f32, 4>(_e5454, _e5477, _e5500, _e5511), ((_e5717 * 0.34f) + (_e5759 * select(2f, (0.000000059604645f * 256f), _e5765))), _e5772, select(_e5773, 0.00000000000022737368f, (0.00000000000022737368f < _e5773)));
                        let _e5780 = local_8.member[0u];
                        let _e5783 = local_8.member[1u];
                        let _e5786 = local_8.member[2u];
                        let _e5789 = local_8.member[3u];
                        let _e5796 = local_8.member_2;
                        let _e5797 = ((_e5783 - (3f * _e5780)) * _e5796);
                        let _e5799 = local_8.member_2;
                        let _e5800 = ((_e5786 - _e5783) * _e5799);
                        let _e5802 = local_8.member_2;
                        let _e5803 = (((3f * _e5789) - _e5786) * _e5802);
                        local_6[0u] = 0f;
                        local_6[1u] = 1f;
                        local_6[2u] = 1f;
                        local_6[3u] = 1f;
                        let _e5810 = ((_e5800 * _e5800) - (_e5797 * _e5803));
                        if (_e5810 > 0f) {
                            if (_e5810 <= 0.000000000000000000000000000000000000011754944f) {
                                phi_9534_ = select(0f, (0.000000000000000000106433627f * 2f), (_e5810 > 0f));
                            } else {
                                phi_9477_ = type_14(0i, 5i);
                                phi_9480_ = bitcast<f32>(((bitcast<u32>(_e5810) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e5819 = phi_9477_;
                                    let _e5821 = phi_9480_;
                                    local_77 = _e5821;
                                    if (_e5819.member < _e5819.member_1) {
                                        let _e5828 = (_e5819.member + 1i);
                                        phi_9478_ = type_14(select(_e5828, type_15().member_1, select(false, true, ((false == (_e5828 > _e5819.member)) != false))), _e5819.member_1);
                                        phi_9521_ = type_15(1u, _e5819.member);
                                    } else {
                                        phi_9478_ = _e5819;
                                        phi_9521_ = type_15(0u, type_15().member_1);
                                    }
                                    let _e5839 = phi_9478_;
                                    let _e5841 = phi_9521_;
                                    let _e5844 = (bitcast<i32>(_e5841.member) != 0i);
                                    if _e5844 {
                                        phi_9481_ = (0.5f * (_e5821 + (_e5810 / _e5821)));
                                    } else {
                                        phi_9481_ = f32();
                                    }
                                    let _e5849 = phi_9481_;
                                    continue;
                                    continuing {
                                        phi_9477_ = _e5839;
                                        phi_9480_ = _e5849;
                                        break if !(_e5844);
                                    }
                                }
                                let _e5854 = local_77;
                                phi_9534_ = (_e5854 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e5860 = phi_9534_;
                            let _e5865 = -((_e5800 + select(_e5860, -(_e5860), (_e5800 < 0f))));
                            local_7[0u] = (_e5865 / (_e5865 + _e5803));
                            local_7[1u] = (_e5797 / (_e5797 + _e5865));
                            let _e5874 = local_7[1u];
                            let _e5875 = local_7[0u];
                            if (_e5874 < _e5875) {
                                let _e5878 = local_7[1u];
                                let _e5880 = local_7[0u];
                                local_7[0u] = _e5878;
                                local_7[1u] = _e5880;
                            }
                            phi_9565_ = type_9(0u, 2u);
                            phi_9568_ = 1u;
                            loop {
                                let _e5884 = phi_9565_;
                                let _e5886 = phi_9568_;
                                local_109 = _e5886;
                                let _e5889 = (_e5884.member < _e5884.member_1);
                                let _e5900 = select(type_9().member_1, _e5884.member, _e5889);
                                let _e5902 = (bitcast<i32>(select(0u, 1u, _e5889)) != 0i);
                                if _e5902 {
                                    let _e5904 = local_7[_e5900];
                                    if (_e5904 > 0f) {
                                        let _e5907 = local_7[_e5900];
                                        if (_e5907 < 1f) {
                                            let _e5910 = local_7[_e5900];
                                            local_6[_e5886] = _e5910;
                                            phi_9635_ = (_e5886 + 1u);
                                        } else {
                                            phi_9635_ = _e5886;
                                        }
                                        let _e5914 = phi_9635_;
                                        phi_9636_ = _e5914;
                                    } else {
                                        phi_9636_ = _e5886;
                                    }
                                    let _e5916 = phi_9636_;
                                    phi_9569_ = _e5916;
                                } else {
                                    phi_9569_ = u32();
                                }
                                let _e5918 = phi_9569_;
                                continue;
                                continuing {
                                    phi_9565_ = type_9(select(_e5884.member, (_e5884.member + 1u), _e5889), select(_e5884.member_1, _e5884.member_1, _e5889));
                                    phi_9568_ = _e5918;
                                    break if !(_e5902);
                                }
                            }
                            let _e8798 = local_109;
                            phi_9637_ = _e8798;
                        } else {
                            phi_9637_ = 1u;
                        }
                        let _e5921 = phi_9637_;
                        local_6[_e5921] = 1f;
                        let _e5923 = local_6;
                        local_9 = _e5923;
                        let _e5924 = (_e5093 * 0.99f);
                        let _e5925 = (1f - _e5095);
                        let _e5928 = local_8.member[0u];
                        let _e5931 = local_8.member[1u];
                        let _e5934 = local_8.member[2u];
                        let _e5937 = local_8.member[3u];
                        let _e5948 = ((((_e5928 * _e5925) + (_e5931 * _e5095)) * (_e5925 * _e5925)) + (((_e5934 * _e5925) + (_e5937 * _e5095)) * (_e5095 * _e5095)));
                        let _e5953 = local_8.member_1;
                        phi_9693_ = type_9(select(1u, 0u, !((select(_e5948, -(_e5948), (_e5948 < 0f)) > _e5953))), (_e5921 + 1u));
                        loop {
                            let _e5960 = phi_9693_;
                            let _e5963 = (_e5960.member < _e5960.member_1);
                            let _e5974 = select(type_9().member_1, _e5960.member, _e5963);
                            if (bitcast<i32>(select(0u, 1u, _e5963)) != 0i) {
                                if (_e5974 > 0u) {
                                    let _e5981 = local_9[(_e5974 - 1u)];
                                    let _e5983 = select(_e5095, _e5981, (_e5981 > _e5095));
                                    let _e5985 = local_9[_e5974];
                                    let _e5987 = select(_e5097, _e5985, (_e5985 < _e5097));
                                    if (_e5983 <= _e5987) {
                                        let _e5989 = function_5((&local_8), _e5099, _e5983, _e5987);
                                        if _e5989 {
                                            phi_11246_ = type_46();
                                            phi_11247_ = bool();
                                            phi_11248_ = type_46();
                                            phi_11249_ = false;
                                            phi_11250_ = false;
                                            phi_11251_ = false;
                                            phi_11252_ = false;
                                        } else {
                                            let _e5990 = (1f - _e5983);
                                            let _e5993 = local_8.member[0u];
                                            let _e5996 = local_8.member[1u];
                                            let _e5999 = local_8.member[2u];
                                            let _e6002 = local_8.member[3u];
                                            let _e6013 = ((((_e5993 * _e5990) + (_e5996 * _e5983)) * (_e5990 * _e5990)) + (((_e5999 * _e5990) + (_e6002 * _e5983)) * (_e5983 * _e5983)));
                                            let _e6014 = (1f - _e5987);
                                            let _e6017 = local_8.member[0u];
                                            let _e6020 = local_8.member[1u];
                                            let _e6023 = local_8.member[2u];
                                            let _e6026 = local_8.member[3u];
                                            let _e6037 = ((((_e6017 * _e6014) + (_e6020 * _e5987)) * (_e6014 * _e6014)) + (((_e6023 * _e6014) + (_e6026 * _e5987)) * (_e5987 * _e5987)));
                                            let _e6042 = local_8.member_1;
                                            let _e6043 = (select(_e6013, -(_e6013), (_e6013 < 0f)) > _e6042);
                                            let _e6048 = local_8.member_1;
                                            let _e6049 = (select(_e6037, -(_e6037), (_e6037 < 0f)) > _e6048);
                                            let _e6057 = select(select(bool(), select(bool(), ((_e6013 > 0f) != (_e6037 > 0f)), _e6049), _e6043), false, select(true, select(true, false, _e6049), _e6043));
                                            if _e6043 {
                                                if _e6049 {
                                                    phi_9849_ = type_46(select(1f, type_46().member, _e6057), select(0f, type_46().member_1, _e6057), select(_e6057, type_46().member_2, _e6057));
                                                    phi_9850_ = _e6057;
                                                } else {
                                                    phi_9849_ = type_46();
                                                    phi_9850_ = true;
                                                }
                                                let _e6066 = phi_9849_;
                                                let _e6068 = phi_9850_;
                                                phi_9851_ = _e6066;
                                                phi_9852_ = _e6068;
                                            } else {
                                                phi_9851_ = type_46();
                                                phi_9852_ = true;
                                            }
                                            let _e6070 = phi_9851_;
                                            let _e6072 = phi_9852_;
                                            if _e6072 {
                                                if _e6043 {
                                                    let _e6074 = select(1f, -1f, (_e6013 < 0f));
                                                    let _e6076 = local_8.member_3;
                                                    let _e6079 = local_8.member[0u];
                                                    let _e6082 = local_8.member[1u];
                                                    let _e6085 = local_8.member[2u];
                                                    let _e6088 = local_8.member[3u];
                                                    let _e6091 = (_e6085 - _e6082);
                                                    phi_9883_ = type_9(0u, 64u);
                                                    phi_9886_ = _e5987;
                                                    phi_9888_ = _e5983;
                                                    phi_9890_ = (0.5f * (_e5983 + _e5987));
                                                    loop {
                                                        let _e6097 = phi_9883_;
                                                        let _e6099 = phi_9886_;
                                                        let _e6101 = phi_9888_;
                                                        let _e6103 = phi_9890_;
                                                        local_80 = _e6101;
                                                        let _e6106 = (_e6097.member < _e6097.member_1);
                                                        if (bitcast<i32>(select(0u, 1u, _e6106)) != 0i) {
                                                            let _e6118 = (1f - _e6103);
                                                            let _e6121 = local_8.member[0u];
                                                            let _e6124 = local_8.member[1u];
                                                            let _e6127 = local_8.member[2u];
                                                            let _e6130 = local_8.member[3u];
                                                            let _e6144 = local_8.member_1;
                                                            let _e6145 = ((_e6074 * ((((_e6121 * _e6118) + (_e6124 * _e6103)) * (_e6118 * _e6118)) + (((_e6127 * _e6118) + (_e6130 * _e6103)) * (_e6103 * _e6103)))) - _e6144);
                                                            let _e6146 = (_e6145 > 0f);
                                                            let _e6147 = select(_e6103, _e6099, _e6146);
                                                            let _e6148 = select(_e6101, _e6103, _e6146);
                                                            let _e6150 = ((_e6147 - _e6148) > _e6076);
                                                            if _e6150 {
                                                                let _e6151 = (1f - _e6103);
                                                                let _e6163 = (-(_e6145) / (_e6074 * (((((_e6082 - (3f * _e6079)) * _e6151) + (_e6091 * _e6103)) * _e6151) + (((_e6091 * _e6151) + (((3f * _e6088) - _e6085) * _e6103)) * _e6103))));
                                                                let _e6170 = ((_e6103 + _e6163) + select(-((0.5f * _e6076)), (0.5f * _e6076), (_e6145 > 0f)));
                                                                if (_e6170 > _e6148) {
                                                                    phi_10000_ = select(true, select(true, false, (select(_e6163, -(_e6163), (_e6163 < 0f)) < (0.5f * (_e6147 - _e6148)))), (_e6170 < _e6147));
                                                                } else {
                                                                    phi_10000_ = true;
                                                                }
                                                                let _e6182 = phi_10000_;
                                                                phi_10007_ = select(_e6170, (0.5f * (_e6148 + _e6147)), _e6182);
                                                                phi_10008_ = false;
                                                            } else {
                                                                phi_10007_ = f32();
                                                                phi_10008_ = true;
                                                            }
                                                            let _e6187 = phi_10007_;
                                                            let _e6189 = phi_10008_;
                                                            phi_9887_ = _e6147;
                                                            phi_9889_ = _e6148;
                                                            phi_9891_ = _e6187;
                                                            phi_10009_ = _e6148;
                                                            phi_10010_ = _e6150;
                                                            phi_10011_ = _e6189;
                                                        } else {
                                                            phi_9887_ = f32();
                                                            phi_9889_ = f32();
                                                            phi_9891_ = f32();
                                                            phi_10009_ = f32();
                                                            phi_10010_ = false;
                                                            phi_10011_ = false;
                                                        }
                                                        let _e6191 = phi_9887_;
                                                        let _e6193 = phi_9889_;
                                                        let _e6195 = phi_9891_;
                                                        let _e6197 = phi_10009_;
                                                        let _e6199 = phi_10010_;
                                                        let _e6201 = phi_10011_;
                                                        local_78 = _e6201;
                                                        local_79 = _e6197;
                                                        continue;
                                                        continuing {
                                                            phi_9883_ = type_9(select(_e6097.member, (_e6097.member + 1u), _e6106), select(_e6097.member_1, _e6097.member_1, _e6106));
                                                            phi_9886_ = _e6191;
                                                            phi_9888_ = _e6193;
                                                            phi_9890_ = _e6195;
                                                            break if !(_e6199);
                                                        }
                                                    }
                                                    let _e6204 = local_78;
                                                    let _e6206 = local_79;
                                                    let _e6208 = local_80;
                                                    phi_10016_ = select(_e6208, _e6206, _e6204);
                                                } else {
                                                    phi_10016_ = _e5983;
                                                }
                                                let _e6211 = phi_10016_;
                                                if _e6049 {
                                                    let _e6215 = local_8.member_3;
                                                    let _e6217 = local_8.member_3;
                                                    phi_10032_ = type_9(0u, 64u);
                                                    phi_10035_ = (_e6215 + _e6217);
                                                    loop {
                                                        let _e6220 = phi_10032_;
                                                        let _e6222 = phi_10035_;
                                                        let _e6225 = (_e6220.member < _e6220.member_1);
                                                        if (bitcast<i32>(select(0u, 1u, _e6225)) != 0i) {
                                                            let _e6237 = (_e6211 + _e6222);
                                                            if (_e6237 < _e5987) {
                                                                let _e6239 = (1f - _e6237);
                                                                let _e6242 = local_8.member[0u];
                                                                let _e6245 = local_8.member[1u];
                                                                let _e6248 = local_8.member[2u];
                                                                let _e6251 = local_8.member[3u];
                                                                let _e6265 = local_8.member_1;
                                                                let _e6266 = ((select(1f, -1f, (_e6037 < 0f)) * ((((_e6242 * _e6239) + (_e6245 * _e6237)) * (_e6239 * _e6239)) + (((_e6248 * _e6239) + (_e6251 * _e6237)) * (_e6237 * _e6237)))) > _e6265);
                                                                phi_10100_ = select((_e6222 + _e6222), f32(), _e6266);
                                                                phi_10101_ = select(true, false, _e6266);
                                                                phi_10102_ = _e6266;
                                                                phi_10103_ = false;
                                                            } else {
                                                                phi_10100_ = f32();
                                                                phi_10101_ = false;
                                                                phi_10102_ = false;
                                                                phi_10103_ = true;
                                                            }
                                                            let _e6271 = phi_10100_;
                                                            let _e6273 = phi_10101_;
                                                            let _e6275 = phi_10102_;
                                                            let _e6277 = phi_10103_;
                                                            phi_10104_ = _e6237;
                                                            phi_10036_ = _e6271;
                                                            phi_10105_ = _e6273;
                                                            phi_10106_ = _e6275;
                                                            phi_10107_ = _e6277;
                                                            phi_10108_ = false;
                                                        } else {
                                                            phi_10104_ = f32();
                                                            phi_10036_ = f32();
                                                            phi_10105_ = false;
                                                            phi_10106_ = false;
                                                            phi_10107_ = false;
                                                            phi_10108_ = true;
                                                        }
                                                        let _e6279 = phi_10104_;
                                                        let _e6281 = phi_10036_;
                                                        let _e6283 = phi_10105_;
                                                        let _e6285 = phi_10106_;
                                                        let _e6287 = phi_10107_;
                                                        let _e6289 = phi_10108_;
                                                        local_81 = _e6285;
                                                        local_82 = _e6287;
                                                        local_83 = _e6285;
                                                        local_84 = _e6289;
                                                        local_85 = _e6279;
                                                        continue;
                                                        continuing {
                                                            phi_10032_ = type_9(select(_e6220.member, (_e6220.member + 1u), _e6225), select(_e6220.member_1, _e6220.member_1, _e6225));
                                                            phi_10035_ = _e6281;
                                                            break if !(_e6283);
                                                        }
                                                    }
                                                    let _e6292 = local_81;
                                                    let _e6294 = local_82;
                                                    let _e6297 = local_83;
                                                    let _e6299 = local_84;
                                                    let _e6303 = local_85;
                                                    phi_10122_ = select(_e6303, _e5987, select(select(_e6299, false, _e6297), true, select(_e6294, false, _e6292)));
                                                } else {
                                                    phi_10122_ = _e5987;
                                                }
                                                let _e6306 = phi_10122_;
                                                phi_10124_ = type_46(_e6211, _e6306, _e6057);
                                            } else {
                                                phi_10124_ = _e6070;
                                            }
                                            let _e6309 = phi_10124_;
                                            if (_e6309.member > _e6309.member_1) {
                                                phi_11241_ = bool();
                                                phi_11242_ = true;
                                                phi_11243_ = false;
                                                phi_11244_ = false;
                                                phi_11245_ = false;
                                            } else {
                                                let _e6314 = (_e6309.member > _e5099);
                                                if _e6314 {
                                                    phi_11237_ = bool();
                                                    phi_11238_ = false;
                                                    phi_11239_ = false;
                                                    phi_11240_ = false;
                                                } else {
                                                    let _e6318 = ((_e6309.member_1 - _e6309.member) * 0.5f);
                                                    let _e6319 = (_e6309.member + _e6318);
                                                    let _e6321 = (_e6318 + (0.000000059604645f * 4f));
                                                    let _e6323 = local_10.member_3;
                                                    let _e6326 = local_10.member[0u];
                                                    let _e6332 = select(_e6326[0], -(_e6326[0]), (_e6326[0] < 0f));
                                                    let _e6335 = select(_e6326[1], -(_e6326[1]), (_e6326[1] < 0f));
                                                    let _e6337 = select(_e6335, _e6332, (_e6332 > _e6335));
                                                    let _e6340 = select(_e6326[2], -(_e6326[2]), (_e6326[2] < 0f));
                                                    let _e6342 = select(_e6340, _e6337, (_e6337 > _e6340));
                                                    let _e6344 = local_10.member[1u];
                                                    let _e6350 = select(_e6344[0], -(_e6344[0]), (_e6344[0] < 0f));
                                                    let _e6353 = select(_e6344[1], -(_e6344[1]), (_e6344[1] < 0f));
                                                    let _e6355 = select(_e6353, _e6350, (_e6350 > _e6353));
                                                    let _e6358 = select(_e6344[2], -(_e6344[2]), (_e6344[2] < 0f));
                                                    let _e6360 = select(_e6358, _e6355, (_e6355 > _e6358));
                                                    let _e6365 = local_10.member[0u];
                                                    let _e6370 = local_10.member[1u];
                                                    let _e6380 = (_e6365[0] + ((_e6370[0] - _e6365[0]) * _e6319));
                                                    let _e6381 = (_e6365[1] + ((_e6370[1] - _e6365[1]) * _e6319));
                                                    let _e6382 = (_e6365[2] + ((_e6370[2] - _e6365[2]) * _e6319));
                                                    let _e6384 = local_10.member[1u];
                                                    let _e6389 = local_10.member[0u];
                                                    let _e6393 = (_e6384[0] - _e6389[0]);
                                                    let _e6394 = (_e6384[1] - _e6389[1]);
                                                    let _e6395 = (_e6384[2] - _e6389[2]);
                                                    let _e6398 = select(_e6393, -(_e6393), (_e6393 < 0f));
                                                    let _e6401 = select(_e6394, -(_e6394), (_e6394 < 0f));
                                                    let _e6403 = select(_e6401, _e6398, (_e6398 > _e6401));
                                                    let _e6406 = select(_e6395, -(_e6395), (_e6395 < 0f));
                                                    let _e6414 = ((((_e6321 * select(_e6406, _e6403, (_e6403 > _e6406))) * 1.01f) + ((select(_e6360, _e6342, (_e6342 > _e6360)) + _e6323) * (0.000000059604645f * 8f))) + _e6323);
                                                    let _e6417 = select(_e6380, -(_e6380), (_e6380 < 0f));
                                                    let _e6420 = select(_e6381, -(_e6381), (_e6381 < 0f));
                                                    let _e6422 = select(_e6420, _e6417, (_e6417 > _e6420));
                                                    let _e6425 = select(_e6382, -(_e6382), (_e6382 < 0f));
                                                    local_2 = type_21(array<f32, 3>(_e6380, _e6381, _e6382), _e6414, (select(_e6425, _e6422, (_e6422 > _e6425)) + _e6414));
                                                    let _e6433 = local_10.member_3;
                                                    let _e6435 = local_10.member_1[0u];
                                                    let _e6441 = select(_e6435[0], -(_e6435[0]), (_e6435[0] < 0f));
                                                    let _e6444 = select(_e6435[1], -(_e6435[1]), (_e6435[1] < 0f));
                                                    let _e6446 = select(_e6444, _e6441, (_e6441 > _e6444));
                                                    let _e6449 = select(_e6435[2], -(_e6435[2]), (_e6435[2] < 0f));
                                                    let _e6451 = select(_e6449, _e6446, (_e6446 > _e6449));
                                                    let _e6453 = local_10.member_1[1u];
                                                    let _e6459 = select(_e6453[0], -(_e6453[0]), (_e6453[0] < 0f));
                                                    let _e6462 = select(_e6453[1], -(_e6453[1]), (_e6453[1] < 0f));
                                                    let _e6464 = select(_e6462, _e6459, (_e6459 > _e6462));
                                                    let _e6467 = select(_e6453[2], -(_e6453[2]), (_e6453[2] < 0f));
                                                    let _e6469 = select(_e6467, _e6464, (_e6464 > _e6467));
                                                    let _e6474 = local_10.member_1[0u];
                                                    let _e6479 = local_10.member_1[1u];
                                                    let _e6489 = (_e6474[0] + ((_e6479[0] - _e6474[0]) * _e6319));
                                                    let _e6490 = (_e6474[1] + ((_e6479[1] - _e6474[1]) * _e6319));
                                                    let _e6491 = (_e6474[2] + ((_e6479[2] - _e6474[2]) * _e6319));
                                                    let _e6493 = local_10.member_1[1u];
                                                    let _e6498 = local_10.member_1[0u];
                                                    let _e6502 = (_e6493[0] - _e6498[0]);
                                                    let _e6503 = (_e6493[1] - _e6498[1]);
                                                    let _e6504 = (_e6493[2] - _e6498[2]);
                                                    let _e6507 = select(_e6502, -(_e6502), (_e6502 < 0f));
                                                    let _e6510 = select(_e6503, -(_e6503), (_e6503 < 0f));
                                                    let _e6512 = select(_e6510, _e6507, (_e6507 > _e6510));
                                                    let _e6515 = select(_e6504, -(_e6504), (_e6504 < 0f));
                                                    let _e6523 = ((((_e6321 * select(_e6515, _e6512, (_e6512 > _e6515))) * 1.01f) + ((select(_e6469, _e6451, (_e6451 > _e6469)) + _e6433) * (0.000000059604645f * 8f))) + _e6433);
                                                    let _e6526 = select(_e6489, -(_e6489), (_e6489 < 0f));
                                                    let _e6529 = select(_e6490, -(_e6490), (_e6490 < 0f));
                                                    let _e6531 = select(_e6529, _e6526, (_e6526 > _e6529));
                                                    let _e6534 = select(_e6491, -(_e6491), (_e6491 < 0f));
                                                    local_3 = type_21(array<f32, 3>(_e6489, _e6490, _e6491), _e6523, (select(_e6534, _e6531, (_e6531 > _e6534)) + _e6523));
                                                    let _e6542 = local_10.member_3;
                                                    let _e6544 = local_10.member_2[0u];
                                                    let _e6550 = select(_e6544[0], -(_e6544[0]), (_e6544[0] < 0f));
                                                    let _e6553 = select(_e6544[1], -(_e6544[1]), (_e6544[1] < 0f));
                                                    let _e6555 = select(_e6553, _e6550, (_e6550 > _e6553));
                                                    let _e6558 = select(_e6544[2], -(_e6544[2]), (_e6544[2] < 0f));
                                                    let _e6560 = select(_e6558, _e6555, (_e6555 > _e6558));
                                                    let _e6562 = local_10.member_2[1u];
                                                    let _e6568 = select(_e6562[0], -(_e6562[0]), (_e6562[0] < 0f));
                                                    let _e6571 = select(_e6562[1], -(_e6562[1]), (_e6562[1] < 0f));
                                                    let _e6573 = select(_e6571, _e6568, (_e6568 > _e6571));
                                                    let _e6576 = select(_e6562[2], -(_e6562[2]), (_e6562[2] < 0f));
                                                    let _e6578 = select(_e6576, _e6573, (_e6573 > _e6576));
                                                    let _e6583 = local_10.member_2[0u];
                                                    let _e6588 = local_10.member_2[1u];
                                                    let _e6598 = (_e6583[0] + ((_e6588[0] - _e6583[0]) * _e6319));
                                                    let _e6599 = (_e6583[1] + ((_e6588[1] - _e6583[1]) * _e6319));
                                                    let _e6600 = (_e6583[2] + ((_e6588[2] - _e6583[2]) * _e6319));
                                                    let _e6602 = local_10.member_2[1u];
                                                    let _e6607 = local_10.member_2[0u];
                                                    let _e6611 = (_e6602[0] - _e6607[0]);
                                                    let _e6612 = (_e6602[1] - _e6607[1]);
                                                    let _e6613 = (_e6602[2] - _e6607[2]);
                                                    let _e6616 = select(_e6611, -(_e6611), (_e6611 < 0f));
                                                    let _e6619 = select(_e6612, -(_e6612), (_e6612 < 0f));
                                                    let _e6621 = select(_e6619, _e6616, (_e6616 > _e6619));
                                                    let _e6624 = select(_e6613, -(_e6613), (_e6613 < 0f));
                                                    let _e6632 = ((((_e6321 * select(_e6624, _e6621, (_e6621 > _e6624))) * 1.01f) + ((select(_e6578, _e6560, (_e6560 > _e6578)) + _e6542) * (0.000000059604645f * 8f))) + _e6542);
                                                    let _e6635 = select(_e6598, -(_e6598), (_e6598 < 0f));
                                                    let _e6638 = select(_e6599, -(_e6599), (_e6599 < 0f));
                                                    let _e6640 = select(_e6638, _e6635, (_e6635 > _e6638));
                                                    let _e6643 = select(_e6600, -(_e6600), (_e6600 < 0f));
                                                    local_4 = type_21(array<f32, 3>(_e6598, _e6599, _e6600), _e6632, (select(_e6643, _e6640, (_e6640 > _e6643)) + _e6632));
                                                    let _e6650 = local_3.member;
                                                    let _e6655 = local_4.member;
                                                    let _e6661 = ((_e6650[1] * _e6655[2]) - (_e6650[2] * _e6655[1]));
                                                    let _e6664 = ((_e6650[2] * _e6655[0]) - (_e6650[0] * _e6655[2]));
                                                    let _e6667 = ((_e6650[0] * _e6655[1]) - (_e6650[1] * _e6655[0]));
                                                    if (select(_e6661, -(_e6661), (_e6661 < 0f)) > select(_e6664, -(_e6664), (_e6664 < 0f))) {
                                                        let _e6690 = (select(_e6661, -(_e6661), (_e6661 < 0f)) > select(_e6667, -(_e6667), (_e6667 < 0f)));
                                                        phi_10849_ = select(1u, 2u, _e6690);
                                                        phi_10850_ = select(0u, 1u, _e6690);
                                                    } else {
                                                        let _e6681 = (select(_e6664, -(_e6664), (_e6664 < 0f)) > select(_e6667, -(_e6667), (_e6667 < 0f)));
                                                        phi_10849_ = select(1u, 0u, _e6681);
                                                        phi_10850_ = select(0u, 2u, _e6681);
                                                    }
                                                    let _e6694 = phi_10849_;
                                                    let _e6696 = phi_10850_;
                                                    let _e6699 = local_3.member[_e6696];
                                                    let _e6702 = local_4.member[_e6694];
                                                    let _e6706 = local_3.member[_e6694];
                                                    let _e6709 = local_4.member[_e6696];
                                                    let _e6711 = ((_e6699 * _e6702) - (_e6706 * _e6709));
                                                    let _e6713 = local_3.member_1;
                                                    let _e6715 = local_4.member_2;
                                                    let _e6718 = local_3.member_2;
                                                    let _e6720 = local_4.member_1;
                                                    let _e6725 = local_3.member_2;
                                                    let _e6728 = local_4.member_2;
                                                    let _e6736 = local_3.member_2;
                                                    let _e6739 = local_4.member_2;
                                                    let _e6743 = (((((_e6713 * _e6715) + (_e6718 * _e6720)) * 2.01f) + (((_e6725 * 2f) * (_e6728 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6736) * (1f + _e6739))));
                                                    if (select(_e6711, -(_e6711), (_e6711 < 0f)) > _e6743) {
                                                        let _e6749 = select(1f, -1f, (_e6711 < 0f));
                                                        let _e6752 = local_2.member[_e6696];
                                                        let _e6755 = local_4.member[_e6694];
                                                        let _e6759 = local_2.member[_e6694];
                                                        let _e6762 = local_4.member[_e6696];
                                                        let _e6766 = local_2.member_1;
                                                        let _e6768 = local_4.member_2;
                                                        let _e6771 = local_2.member_2;
                                                        let _e6773 = local_4.member_1;
                                                        let _e6778 = local_2.member_2;
                                                        let _e6781 = local_4.member_2;
                                                        let _e6789 = local_2.member_2;
                                                        let _e6792 = local_4.member_2;
                                                        let _e6796 = (((((_e6766 * _e6768) + (_e6771 * _e6773)) * 2.01f) + (((_e6778 * 2f) * (_e6781 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6789) * (1f + _e6792))));
                                                        let _e6799 = local_3.member[_e6696];
                                                        let _e6802 = local_2.member[_e6694];
                                                        let _e6806 = local_3.member[_e6694];
                                                        let _e6809 = local_2.member[_e6696];
                                                        let _e6813 = local_3.member_1;
                                                        let _e6815 = local_2.member_2;
                                                        let _e6818 = local_3.member_2;
                                                        let _e6820 = local_2.member_1;
                                                        let _e6825 = local_3.member_2;
                                                        let _e6828 = local_2.member_2;
                                                        let _e6836 = local_3.member_2;
                                                        let _e6839 = local_2.member_2;
                                                        let _e6843 = (((((_e6813 * _e6815) + (_e6818 * _e6820)) * 2.01f) + (((_e6825 * 2f) * (_e6828 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6836) * (1f + _e6839))));
                                                        let _e6844 = (_e6711 * _e6749);
                                                        let _e6845 = (((_e6752 * _e6755) - (_e6759 * _e6762)) * _e6749);
                                                        let _e6846 = (((_e6799 * _e6802) - (_e6806 * _e6809)) * _e6749);
                                                        let _e6859 = (((select(_e6844, -(_e6844), (_e6844 < 0f)) + select(_e6845, -(_e6845), (_e6845 < 0f))) + select(_e6846, -(_e6846), (_e6846 < 0f))) * (0.000000059604645f * 4f));
                                                        if (_e283.member != 0u) {
                                                            phi_11111_ = array<type_16, 4>(type_16(_e6845, _e6796), type_16(_e6846, _e6843), type_16((_e6844 - _e6845), ((_e6743 + _e6796) + _e6859)), type_16((_e6844 - _e6846), ((_e6743 + _e6843) + _e6859)));
                                                        } else {
                                                            let _e6862 = ((_e6844 - _e6845) - _e6846);
                                                            let _e6865 = (((_e6743 + _e6796) + _e6843) + _e6859);
                                                            phi_11111_ = array<type_16, 4>(type_16(_e6845, _e6796), type_16(_e6846, _e6843), type_16(_e6862, _e6865), type_16(_e6862, _e6865));
                                                        }
                                                        let _e6883 = phi_11111_;
                                                        local_5 = array<type_16, 4>(type_16(_e6883[0].member, _e6883[0].member_1), type_16(_e6883[1].member, _e6883[1].member_1), type_16(_e6883[2].member, _e6883[2].member_1), type_16(_e6883[3].member, _e6883[3].member_1));
                                                        phi_11131_ = type_9(0u, 4u);
                                                        phi_11134_ = true;
                                                        loop {
                                                            let _e6902 = phi_11131_;
                                                            let _e6904 = phi_11134_;
                                                            local_87 = _e6904;
                                                            let _e6907 = (_e6902.member < _e6902.member_1);
                                                            let _e6918 = select(type_9().member_1, _e6902.member, _e6907);
                                                            if (bitcast<i32>(select(0u, 1u, _e6907)) != 0i) {
                                                                let _e6923 = local_5[_e6918].member;
                                                                let _e6926 = local_5[_e6918].member_1;
                                                                let _e6928 = (_e6923 < -(_e6926));
                                                                phi_11135_ = select((_e6904 && (_e6923 > _e6926)), bool(), _e6928);
                                                                phi_11186_ = select(true, false, _e6928);
                                                                phi_11187_ = _e6928;
                                                            } else {
                                                                phi_11135_ = bool();
                                                                phi_11186_ = false;
                                                                phi_11187_ = false;
                                                            }
                                                            let _e6934 = phi_11135_;
                                                            let _e6936 = phi_11186_;
                                                            let _e6938 = phi_11187_;
                                                            local_86 = _e6938;
                                                            continue;
                                                            continuing {
                                                                phi_11131_ = type_9(select(_e6902.member, (_e6902.member + 1u), _e6907), select(_e6902.member_1, _e6902.member_1, _e6907));
                                                                phi_11134_ = _e6934;
                                                                break if !(_e6936);
                                                            }
                                                        }
                                                        let _e6941 = local_86;
                                                        let _e6942 = select(true, false, _e6941);
                                                        let _e6944 = local_87;
                                                        phi_11201_ = select(u32(), select(2u, 1u, _e6944), _e6942);
                                                        phi_11202_ = 0u;
                                                        phi_11203_ = select(true, false, _e6942);
                                                    } else {
                                                        phi_11201_ = u32();
                                                        phi_11202_ = 2u;
                                                        phi_11203_ = true;
                                                    }
                                                    let _e6949 = phi_11201_;
                                                    let _e6951 = phi_11202_;
                                                    let _e6953 = phi_11203_;
                                                    let _e6954 = select(_e6949, _e6951, _e6953);
                                                    let _e6955 = (_e6954 == 0u);
                                                    if _e6955 {
                                                        phi_11234_ = bool();
                                                        phi_11235_ = false;
                                                        phi_11236_ = false;
                                                    } else {
                                                        let _e6958 = select(false, _e6309.member_2, (_e6954 == 1u));
                                                        let _e6964 = select(true, select(true, false, ((_e6309.member_1 - _e6309.member) <= _e5924)), _e6958);
                                                        phi_11234_ = _e6958;
                                                        phi_11235_ = _e6964;
                                                        phi_11236_ = select(true, false, _e6964);
                                                    }
                                                    let _e6967 = phi_11234_;
                                                    let _e6969 = phi_11235_;
                                                    let _e6971 = phi_11236_;
                                                    phi_11237_ = _e6967;
                                                    phi_11238_ = _e6955;
                                                    phi_11239_ = _e6969;
                                                    phi_11240_ = _e6971;
                                                }
                                                let _e6973 = phi_11237_;
                                                let _e6975 = phi_11238_;
                                                let _e6977 = phi_11239_;
                                                let _e6979 = phi_11240_;
                                                phi_11241_ = _e6973;
                                                phi_11242_ = _e6975;
                                                phi_11243_ = _e6977;
                                                phi_11244_ = _e6314;
                                                phi_11245_ = _e6979;
                                            }
                                            let _e6981 = phi_11241_;
                                            let _e6983 = phi_11242_;
                                            let _e6985 = phi_11243_;
                                            let _e6987 = phi_11244_;
                                            let _e6989 = phi_11245_;
                                            phi_11246_ = _e6309;
                                            phi_11247_ = _e6981;
                                            phi_11248_ = _e6309;
                                            phi_11249_ = _e6983;
                                            phi_11250_ = _e6985;
                                            phi_11251_ = _e6987;
                                            phi_11252_ = _e6989;
                                        }
                                        let _e6991 = phi_11246_;
                                        let _e6993 = phi_11247_;
                                        let _e6995 = phi_11248_;
                                        let _e6997 = phi_11249_;
                                        let _e6999 = phi_11250_;
                                        let _e7001 = phi_11251_;
                                        let _e7003 = phi_11252_;
                                        phi_11253_ = _e6991;
                                        phi_11254_ = _e6993;
                                        phi_11255_ = _e6995;
                                        phi_11256_ = _e6997;
                                        phi_11257_ = _e6999;
                                        phi_11258_ = _e5989;
                                        phi_11259_ = _e7001;
                                        phi_11260_ = _e7003;
                                    } else {
                                        phi_11253_ = type_46();
                                        phi_11254_ = bool();
                                        phi_11255_ = type_46();
                                        phi_11256_ = true;
                                        phi_11257_ = false;
                                        phi_11258_ = false;
                                        phi_11259_ = false;
                                        phi_11260_ = false;
                                    }
                                    let _e7005 = phi_11253_;
                                    let _e7007 = phi_11254_;
                                    let _e7009 = phi_11255_;
                                    let _e7011 = phi_11256_;
                                    let _e7013 = phi_11257_;
                                    let _e7015 = phi_11258_;
                                    let _e7017 = phi_11259_;
                                    let _e7019 = phi_11260_;
                                    phi_11268_ = _e7005;
                                    phi_11269_ = _e7007;
                                    phi_11270_ = _e7009;
                                    phi_11271_ = select(_e7013, false, _e7011);
                                    phi_11272_ = _e7011;
                                    phi_11273_ = select(_e7015, false, _e7011);
                                    phi_11274_ = select(_e7017, false, _e7011);
                                    phi_11275_ = select(_e7019, false, _e7011);
                                } else {
                                    phi_11268_ = type_46(_e5095, _e5095, false);
                                    phi_11269_ = false;
                                    phi_11270_ = type_46();
                                    phi_11271_ = true;
                                    phi_11272_ = false;
                                    phi_11273_ = false;
                                    phi_11274_ = false;
                                    phi_11275_ = false;
                                }
                                let _e7025 = phi_11268_;
                                let _e7027 = phi_11269_;
                                let _e7029 = phi_11270_;
                                let _e7031 = phi_11271_;
                                let _e7033 = phi_11272_;
                                let _e7035 = phi_11273_;
                                let _e7037 = phi_11274_;
                                let _e7039 = phi_11275_;
                                if _e7031 {
                                    let _e7044 = local_10.member[0u];
                                    let _e7050 = local_10.member_1[0u];
                                    let _e7056 = local_10.member_2[0u];
                                    let _e7060 = (_e7044[0] - _e7050[0]);
                                    let _e7061 = (_e7044[1] - _e7050[1]);
                                    let _e7062 = (_e7044[2] - _e7050[2]);
                                    let _e7063 = (_e283.member == 0u);
                                    let _e7075 = local_10.member[1u];
                                    let _e7081 = local_10.member_1[1u];
                                    let _e7087 = local_10.member_2[1u];
                                    let _e7091 = (_e7075[0] - _e7081[0]);
                                    let _e7092 = (_e7075[1] - _e7081[1]);
                                    let _e7093 = (_e7075[2] - _e7081[2]);
                                    let _e7094 = (_e283.member == 0u);
                                    let _e7106 = local_10.member[0u];
                                    let _e7112 = select(_e7106[0], -(_e7106[0]), (_e7106[0] < 0f));
                                    let _e7115 = select(_e7106[1], -(_e7106[1]), (_e7106[1] < 0f));
                                    let _e7117 = select(_e7115, _e7112, (_e7112 > _e7115));
                                    let _e7120 = select(_e7106[2], -(_e7106[2]), (_e7106[2] < 0f));
                                    let _e7122 = select(_e7120, _e7117, (_e7117 > _e7120));
                                    let _e7125 = local_10.member[1u];
                                    let _e7131 = select(_e7125[0], -(_e7125[0]), (_e7125[0] < 0f));
                                    let _e7134 = select(_e7125[1], -(_e7125[1]), (_e7125[1] < 0f));
                                    let _e7136 = select(_e7134, _e7131, (_e7131 > _e7134));
                                    let _e7139 = select(_e7125[2], -(_e7125[2]), (_e7125[2] < 0f));
                                    let _e7141 = select(_e7139, _e7136, (_e7136 > _e7139));
                                    let _e7145 = local_10.member_3;
                                    let _e7149 = local_10.member_1[0u];
                                    let _e7155 = select(_e7149[0], -(_e7149[0]), (_e7149[0] < 0f));
                                    let _e7158 = select(_e7149[1], -(_e7149[1]), (_e7149[1] < 0f));
                                    let _e7160 = select(_e7158, _e7155, (_e7155 > _e7158));
                                    let _e7163 = select(_e7149[2], -(_e7149[2]), (_e7149[2] < 0f));
                                    let _e7165 = select(_e7163, _e7160, (_e7160 > _e7163));
                                    let _e7168 = local_10.member_1[1u];
                                    let _e7174 = select(_e7168[0], -(_e7168[0]), (_e7168[0] < 0f));
                                    let _e7177 = select(_e7168[1], -(_e7168[1]), (_e7168[1] < 0f));
                                    let _e7179 = select(_e7177, _e7174, (_e7174 > _e7177));
                                    let _e7182 = select(_e7168[2], -(_e7168[2]), (_e7168[2] < 0f));
                                    let _e7184 = select(_e7182, _e7179, (_e7179 > _e7182));
                                    let _e7188 = local_10.member_3;
                                    let _e7192 = local_10.member_2[0u];
                                    let _e7198 = select(_e7192[0], -(_e7192[0]), (_e7192[0] < 0f));
                                    let _e7201 = select(_e7192[1], -(_e7192[1]), (_e7192[1] < 0f));
                                    let _e7203 = select(_e7201, _e7198, (_e7198 > _e7201));
                                    let _e7206 = select(_e7192[2], -(_e7192[2]), (_e7192[2] < 0f));
                                    let _e7208 = select(_e7206, _e7203, (_e7203 > _e7206));
                                    let _e7211 = local_10.member_2[1u];
                                    let _e7217 = select(_e7211[0], -(_e7211[0]), (_e7211[0] < 0f));
                                    let _e7220 = select(_e7211[1], -(_e7211[1]), (_e7211[1] < 0f));
                                    let _e7222 = select(_e7220, _e7217, (_e7217 > _e7220));
                                    let _e7225 = select(_e7211[2], -(_e7211[2]), (_e7211[2] < 0f));
                                    let _e7227 = select(_e7225, _e7222, (_e7222 > _e7225));
                                    let _e7231 = local_10.member_3;
                                    let _e7238 = local_10.member_3;
                                    let _e7243 = (_e5093 * 0.00390625f);
                                    local = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    phi_11698_ = type_9(0u, 96u);
                                    phi_11701_ = _e7025.member;
                                    phi_11703_ = _e7025.member;
                                    phi_11705_ = (_e7025.member_1 - _e7025.member);
                                    phi_11707_ = _e7025.member;
                                    phi_11709_ = false;
                                    phi_11711_ = 0u;
                                    loop {
                                        let _e7246 = phi_11698_;
                                        let _e7248 = phi_11701_;
                                        let _e7250 = phi_11703_;
                                        let _e7252 = phi_11705_;
                                        let _e7254 = phi_11707_;
                                        let _e7256 = phi_11709_;
                                        let _e7258 = phi_11711_;
                                        local_97 = _e7248;
                                        local_100 = _e7250;
                                        let _e7261 = (_e7246.member < _e7246.member_1);
                                        if (bitcast<i32>(select(0u, 1u, _e7261)) != 0i) {
                                            let _e7275 = local_10.member[0u];
                                            let _e7281 = local_10.member[1u];
                                            let _e7297 = local_10.member_1[0u];
                                            let _e7303 = local_10.member_1[1u];
                                            let _e7319 = local_10.member_2[0u];
                                            let _e7325 = local_10.member_2[1u];
                                            let _e7339 = function_3(array<f32, 3>((_e7275[0] + ((_e7281[0] - _e7275[0]) * _e7248)), (_e7275[1] + ((_e7281[1] - _e7275[1]) * _e7248)), (_e7275[2] + ((_e7281[2] - _e7275[2]) * _e7248))), array<f32, 3>((_e7297[0] + ((_e7303[0] - _e7297[0]) * _e7248)), (_e7297[1] + ((_e7303[1] - _e7297[1]) * _e7248)), (_e7297[2] + ((_e7303[2] - _e7297[2]) * _e7248))), array<f32, 3>((_e7319[0] + ((_e7325[0] - _e7319[0]) * _e7248)), (_e7319[1] + ((_e7325[1] - _e7319[1]) * _e7248)), (_e7319[2] + ((_e7325[2] - _e7319[2]) * _e7248))), _e283.member);
                                            if (_e7258 == 0u) {
                                                phi_11862_ = _e7339;
                                            } else {
                                                phi_11862_ = array<f32, 3>(select(0f, _e7339[0], (_e7258 == 1u)), select(0f, _e7339[1], (_e7258 == 2u)), select(0f, _e7339[2], (_e7258 == 3u)));
                                            }
                                            let _e7352 = phi_11862_;
                                            let _e7366 = ((select(_e7352[0], -(_e7352[0]), (_e7352[0] < 0f)) + select(_e7352[1], -(_e7352[1]), (_e7352[1] < 0f))) + select(_e7352[2], -(_e7352[2]), (_e7352[2] < 0f)));
                                            if (_e7366 > 0f) {
                                                if ((bitcast<u32>(_e7366) & 2139095040u) != 2139095040u) {
                                                    let _e7371 = (1f / _e7366);
                                                    let _e7373 = (_e7352[0] * _e7371);
                                                    let _e7375 = (_e7352[1] * _e7371);
                                                    let _e7377 = (_e7352[2] * _e7371);
                                                    let _e7382 = (((_e7373 * _e7373) + (_e7375 * _e7375)) + (_e7377 * _e7377));
                                                    if (_e7382 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_11985_ = select(0f, (0.000000000000000000106433627f * 2f), (_e7382 > 0f));
                                                    } else {
                                                        phi_11928_ = type_14(0i, 5i);
                                                        phi_11931_ = bitcast<f32>(((bitcast<u32>(_e7382) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e7390 = phi_11928_;
                                                            let _e7392 = phi_11931_;
                                                            local_88 = _e7392;
                                                            if (_e7390.member < _e7390.member_1) {
                                                                let _e7399 = (_e7390.member + 1i);
                                                                phi_11929_ = type_14(select(_e7399, type_15().member_1, select(false, true, ((false == (_e7399 > _e7390.member)) != false))), _e7390.member_1);
                                                                phi_11972_ = type_15(1u, _e7390.member);
                                                            } else {
                                                                phi_11929_ = _e7390;
                                                                phi_11972_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e7410 = phi_11929_;
                                                            let _e7412 = phi_11972_;
                                                            let _e7415 = (bitcast<i32>(_e7412.member) != 0i);
                                                            if _e7415 {
                                                                phi_11932_ = (0.5f * (_e7392 + (_e7382 / _e7392)));
                                                            } else {
                                                                phi_11932_ = f32();
                                                            }
                                                            let _e7420 = phi_11932_;
                                                            continue;
                                                            continuing {
                                                                phi_11928_ = _e7410;
                                                                phi_11931_ = _e7420;
                                                                break if !(_e7415);
                                                            }
                                                        }
                                                        let _e7425 = local_88;
                                                        phi_11985_ = (_e7425 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e7431 = phi_11985_;
                                                    let _e7432 = (0.000000059604645f * 12f);
                                                    let _e7437 = ((((((((select(_e7141, _e7122, (_e7122 > _e7141)) + _e7145) + (select(_e7184, _e7165, (_e7165 > _e7184)) + _e7188)) + (select(_e7227, _e7208, (_e7208 > _e7227)) + _e7231)) * (0.000000059604645f * 16f)) + (_e7238 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e7431) * (1f + _e7432)));
                                                    let _e7442 = (((_e7373 * _e7044[0]) + (_e7375 * _e7044[1])) + (_e7377 * _e7044[2]));
                                                    let _e7447 = (((_e7373 * _e7060) + (_e7375 * _e7061)) + (_e7377 * _e7062));
                                                    let _e7452 = (((_e7373 * (_e7044[0] - _e7056[0])) + (_e7375 * (_e7044[1] - _e7056[1]))) + (_e7377 * (_e7044[2] - _e7056[2])));
                                                    let _e7457 = (((_e7373 * select((_e7060 - _e7056[0]), _e7044[0], _e7063)) + (_e7375 * select((_e7061 - _e7056[1]), _e7044[1], _e7063))) + (_e7377 * select((_e7062 - _e7056[2]), _e7044[2], _e7063)));
                                                    let _e7463 = (((_e7373 * _e7075[0]) + (_e7375 * _e7075[1])) + (_e7377 * _e7075[2]));
                                                    let _e7468 = (((_e7373 * _e7091) + (_e7375 * _e7092)) + (_e7377 * _e7093));
                                                    let _e7473 = (((_e7373 * (_e7075[0] - _e7087[0])) + (_e7375 * (_e7075[1] - _e7087[1]))) + (_e7377 * (_e7075[2] - _e7087[2])));
                                                    let _e7478 = (((_e7373 * select((_e7091 - _e7087[0]), _e7075[0], _e7094)) + (_e7375 * select((_e7092 - _e7087[1]), _e7075[1], _e7094))) + (_e7377 * select((_e7093 - _e7087[2]), _e7075[2], _e7094)));
                                                    phi_12108_ = type_29(array<f32, 4>(_e7442, _e7447, _e7452, _e7457), array<f32, 4>(_e7463, _e7468, _e7473, _e7478), array<f32, 4>((_e7437 + ((select(_e7442, -(_e7442), (_e7442 < 0f)) + select(_e7463, -(_e7463), (_e7463 < 0f))) * _e7432)), (_e7437 + ((select(_e7447, -(_e7447), (_e7447 < 0f)) + select(_e7468, -(_e7468), (_e7468 < 0f))) * _e7432)), (_e7437 + ((select(_e7452, -(_e7452), (_e7452 < 0f)) + select(_e7473, -(_e7473), (_e7473 < 0f))) * _e7432)), (_e7437 + ((select(_e7457, -(_e7457), (_e7457 < 0f)) + select(_e7478, -(_e7478), (_e7478 < 0f))) * _e7432))));
                                                    phi_12109_ = false;
                                                } else {
                                                    phi_12108_ = type_29();
                                                    phi_12109_ = true;
                                                }
                                                let _e7519 = phi_12108_;
                                                let _e7521 = phi_12109_;
                                                phi_12110_ = _e7519;
                                                phi_12111_ = _e7521;
                                            } else {
                                                phi_12110_ = type_29();
                                                phi_12111_ = true;
                                            }
                                            let _e7523 = phi_12110_;
                                            let _e7525 = phi_12111_;
                                            if _e7525 {
                                                phi_12119_ = type_29(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            } else {
                                                phi_12119_ = _e7523;
                                            }
                                            let _e7527 = phi_12119_;
                                            local_1 = type_29(array<f32, 4>(_e7527.member[0], _e7527.member[1], _e7527.member[2], _e7527.member[3]), array<f32, 4>(_e7527.member_1[0], _e7527.member_1[1], _e7527.member_1[2], _e7527.member_1[3]), array<f32, 4>(_e7527.member_2[0], _e7527.member_2[1], _e7527.member_2[2], _e7527.member_2[3]));
                                            let _e7547 = (_e7248 - _e7254);
                                            let _e7551 = local_1.member[0u];
                                            let _e7554 = local_1.member_1[0u];
                                            let _e7557 = local_1.member[0u];
                                            let _e7563 = local_1.member_2[0u];
                                            if (((_e7551 + ((_e7554 - _e7557) * _e7248)) - _e7563) > 0f) {
                                                let _e7568 = local_1.member[1u];
                                                let _e7571 = local_1.member_1[1u];
                                                let _e7574 = local_1.member[1u];
                                                let _e7580 = local_1.member_2[1u];
                                                if (((_e7568 + ((_e7571 - _e7574) * _e7248)) - _e7580) > 0f) {
                                                    let _e7585 = local_1.member[2u];
                                                    let _e7588 = local_1.member_1[2u];
                                                    let _e7591 = local_1.member[2u];
                                                    let _e7597 = local_1.member_2[2u];
                                                    if (((_e7585 + ((_e7588 - _e7591) * _e7248)) - _e7597) > 0f) {
                                                        let _e7602 = local_1.member[3u];
                                                        let _e7605 = local_1.member_1[3u];
                                                        let _e7608 = local_1.member[3u];
                                                        let _e7614 = local_1.member_2[3u];
                                                        phi_12290_ = (((_e7602 + ((_e7605 - _e7608) * _e7248)) - _e7614) > 0f);
                                                        phi_12291_ = false;
                                                    } else {
                                                        phi_12290_ = bool();
                                                        phi_12291_ = true;
                                                    }
                                                    let _e7618 = phi_12290_;
                                                    let _e7620 = phi_12291_;
                                                    phi_12292_ = _e7618;
                                                    phi_12293_ = _e7620;
                                                } else {
                                                    phi_12292_ = bool();
                                                    phi_12293_ = true;
                                                }
                                                let _e7622 = phi_12292_;
                                                let _e7624 = phi_12293_;
                                                phi_12294_ = _e7622;
                                                phi_12295_ = _e7624;
                                            } else {
                                                phi_12294_ = bool();
                                                phi_12295_ = true;
                                            }
                                            let _e7626 = phi_12294_;
                                            let _e7628 = phi_12295_;
                                            if select(_e7626, false, _e7628) {
                                                if (_e7248 <= _e7250) {
                                                    phi_12609_ = true;
                                                } else {
                                                    let _e7633 = local.member[0u];
                                                    let _e7636 = local.member_1[0u];
                                                    let _e7639 = local.member[0u];
                                                    let _e7645 = local.member_2[0u];
                                                    let _e7649 = local_1.member[0u];
                                                    let _e7652 = local_1.member_1[0u];
                                                    let _e7655 = local_1.member[0u];
                                                    let _e7661 = local_1.member_2[0u];
                                                    if ((((_e7633 + ((_e7636 - _e7639) * _e7248)) - _e7645) + ((_e7649 + ((_e7652 - _e7655) * _e7254)) - _e7661)) > 0f) {
                                                        let _e7667 = local.member[1u];
                                                        let _e7670 = local.member_1[1u];
                                                        let _e7673 = local.member[1u];
                                                        let _e7679 = local.member_2[1u];
                                                        let _e7683 = local_1.member[1u];
                                                        let _e7686 = local_1.member_1[1u];
                                                        let _e7689 = local_1.member[1u];
                                                        let _e7695 = local_1.member_2[1u];
                                                        if ((((_e7667 + ((_e7670 - _e7673) * _e7248)) - _e7679) + ((_e7683 + ((_e7686 - _e7689) * _e7254)) - _e7695)) > 0f) {
                                                            let _e7701 = local.member[2u];
                                                            let _e7704 = local.member_1[2u];
                                                            let _e7707 = local.member[2u];
                                                            let _e7713 = local.member_2[2u];
                                                            let _e7717 = local_1.member[2u];
                                                            let _e7720 = local_1.member_1[2u];
                                                            let _e7723 = local_1.member[2u];
                                                            let _e7729 = local_1.member_2[2u];
                                                            if ((((_e7701 + ((_e7704 - _e7707) * _e7248)) - _e7713) + ((_e7717 + ((_e7720 - _e7723) * _e7254)) - _e7729)) > 0f) {
                                                                let _e7735 = local.member[3u];
                                                                let _e7738 = local.member_1[3u];
                                                                let _e7741 = local.member[3u];
                                                                let _e7747 = local.member_2[3u];
                                                                let _e7751 = local_1.member[3u];
                                                                let _e7754 = local_1.member_1[3u];
                                                                let _e7757 = local_1.member[3u];
                                                                let _e7763 = local_1.member_2[3u];
                                                                phi_12596_ = ((((_e7735 + ((_e7738 - _e7741) * _e7248)) - _e7747) + ((_e7751 + ((_e7754 - _e7757) * _e7254)) - _e7763)) > 0f);
                                                                phi_12597_ = false;
                                                            } else {
                                                                phi_12596_ = bool();
                                                                phi_12597_ = true;
                                                            }
                                                            let _e7768 = phi_12596_;
                                                            let _e7770 = phi_12597_;
                                                            phi_12598_ = _e7768;
                                                            phi_12599_ = _e7770;
                                                        } else {
                                                            phi_12598_ = bool();
                                                            phi_12599_ = true;
                                                        }
                                                        let _e7772 = phi_12598_;
                                                        let _e7774 = phi_12599_;
                                                        phi_12600_ = _e7772;
                                                        phi_12601_ = _e7774;
                                                    } else {
                                                        phi_12600_ = bool();
                                                        phi_12601_ = true;
                                                    }
                                                    let _e7776 = phi_12600_;
                                                    let _e7778 = phi_12601_;
                                                    phi_12609_ = select(_e7776, false, _e7778);
                                                }
                                                let _e7781 = phi_12609_;
                                                if _e7781 {
                                                    if select(true, select(true, false, (_e7248 >= _e7025.member_1)), _e7256) {
                                                        local = type_29(array<f32, 4>(_e7527.member[0], _e7527.member[1], _e7527.member[2], _e7527.member[3]), array<f32, 4>(_e7527.member_1[0], _e7527.member_1[1], _e7527.member_1[2], _e7527.member_1[3]), array<f32, 4>(_e7527.member_2[0], _e7527.member_2[1], _e7527.member_2[2], _e7527.member_2[3]));
                                                        let _e7806 = local.member[0u];
                                                        let _e7809 = local.member_1[0u];
                                                        let _e7812 = local.member_2[0u];
                                                        if select(true, select(true, false, (_e7809 > _e7812)), (_e7806 > _e7812)) {
                                                            let _e7817 = (_e7809 >= _e7806);
                                                            if _e7817 {
                                                                phi_12718_ = f32();
                                                                phi_12719_ = false;
                                                            } else {
                                                                if ((_e7806 - _e7809) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_12716_ = (((_e7806 - _e7812) / (_e7806 - _e7809)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_12717_ = false;
                                                                } else {
                                                                    phi_12716_ = f32();
                                                                    phi_12717_ = true;
                                                                }
                                                                let _e7828 = phi_12716_;
                                                                let _e7830 = phi_12717_;
                                                                phi_12718_ = _e7828;
                                                                phi_12719_ = _e7830;
                                                            }
                                                            let _e7832 = phi_12718_;
                                                            let _e7834 = phi_12719_;
                                                            phi_12720_ = _e7832;
                                                            phi_12721_ = _e7817;
                                                            phi_12722_ = _e7834;
                                                        } else {
                                                            phi_12720_ = f32();
                                                            phi_12721_ = true;
                                                            phi_12722_ = false;
                                                        }
                                                        let _e7836 = phi_12720_;
                                                        let _e7838 = phi_12721_;
                                                        let _e7840 = phi_12722_;
                                                        let _e7843 = select(_e7836, select(_e7248, 2f, _e7838), select(_e7840, true, _e7838));
                                                        let _e7846 = local.member[1u];
                                                        let _e7849 = local.member_1[1u];
                                                        let _e7852 = local.member_2[1u];
                                                        if select(true, select(true, false, (_e7849 > _e7852)), (_e7846 > _e7852)) {
                                                            let _e7857 = (_e7849 >= _e7846);
                                                            if _e7857 {
                                                                phi_12786_ = f32();
                                                                phi_12787_ = false;
                                                            } else {
                                                                if ((_e7846 - _e7849) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_12784_ = (((_e7846 - _e7852) / (_e7846 - _e7849)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_12785_ = false;
                                                                } else {
                                                                    phi_12784_ = f32();
                                                                    phi_12785_ = true;
                                                                }
                                                                let _e7868 = phi_12784_;
                                                                let _e7870 = phi_12785_;
                                                                phi_12786_ = _e7868;
                                                                phi_12787_ = _e7870;
                                                            }
                                                            let _e7872 = phi_12786_;
                                                            let _e7874 = phi_12787_;
                                                            phi_12788_ = _e7872;
                                                            phi_12789_ = _e7857;
                                                            phi_12790_ = _e7874;
                                                        } else {
                                                            phi_12788_ = f32();
                                                            phi_12789_ = true;
                                                            phi_12790_ = false;
                                                        }
                                                        let _e7876 = phi_12788_;
                                                        let _e7878 = phi_12789_;
                                                        let _e7880 = phi_12790_;
                                                        let _e7883 = select(_e7876, select(_e7248, 2f, _e7878), select(_e7880, true, _e7878));
                                                        let _e7885 = select(_e7883, _e7843, (_e7843 < _e7883));
                                                        let _e7888 = local.member[2u];
                                                        let _e7891 = local.member_1[2u];
                                                        let _e7894 = local.member_2[2u];
                                                        if select(true, select(true, false, (_e7891 > _e7894)), (_e7888 > _e7894)) {
                                                            let _e7899 = (_e7891 >= _e7888);
                                                            if _e7899 {
                                                                phi_12859_ = f32();
                                                                phi_12860_ = false;
                                                            } else {
                                                                if ((_e7888 - _e7891) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_12857_ = (((_e7888 - _e7894) / (_e7888 - _e7891)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_12858_ = false;
                                                                } else {
                                                                    phi_12857_ = f32();
                                                                    phi_12858_ = true;
                                                                }
                                                                let _e7910 = phi_12857_;
                                                                let _e7912 = phi_12858_;
                                                                phi_12859_ = _e7910;
                                                                phi_12860_ = _e7912;
                                                            }
                                                            let _e7914 = phi_12859_;
                                                            let _e7916 = phi_12860_;
                                                            phi_12861_ = _e7914;
                                                            phi_12862_ = _e7899;
                                                            phi_12863_ = _e7916;
                                                        } else {
                                                            phi_12861_ = f32();
                                                            phi_12862_ = true;
                                                            phi_12863_ = false;
                                                        }
                                                        let _e7918 = phi_12861_;
                                                        let _e7920 = phi_12862_;
                                                        let _e7922 = phi_12863_;
                                                        let _e7925 = select(_e7918, select(_e7248, 2f, _e7920), select(_e7922, true, _e7920));
                                                        let _e7928 = local.member[3u];
                                                        let _e7931 = local.member_1[3u];
                                                        let _e7934 = local.member_2[3u];
                                                        if select(true, select(true, false, (_e7931 > _e7934)), (_e7928 > _e7934)) {
                                                            let _e7939 = (_e7931 >= _e7928);
                                                            if _e7939 {
                                                                phi_12927_ = f32();
                                                                phi_12928_ = false;
                                                            } else {
                                                                if ((_e7928 - _e7931) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_12925_ = (((_e7928 - _e7934) / (_e7928 - _e7931)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_12926_ = false;
                                                                } else {
                                                                    phi_12925_ = f32();
                                                                    phi_12926_ = true;
                                                                }
                                                                let _e7950 = phi_12925_;
                                                                let _e7952 = phi_12926_;
                                                                phi_12927_ = _e7950;
                                                                phi_12928_ = _e7952;
                                                            }
                                                            let _e7954 = phi_12927_;
                                                            let _e7956 = phi_12928_;
                                                            phi_12929_ = _e7954;
                                                            phi_12930_ = _e7939;
                                                            phi_12931_ = _e7956;
                                                        } else {
                                                            phi_12929_ = f32();
                                                            phi_12930_ = true;
                                                            phi_12931_ = false;
                                                        }
                                                        let _e7958 = phi_12929_;
                                                        let _e7960 = phi_12930_;
                                                        let _e7962 = phi_12931_;
                                                        let _e7965 = select(_e7958, select(_e7248, 2f, _e7960), select(_e7962, true, _e7960));
                                                        let _e7967 = select(_e7965, _e7925, (_e7925 < _e7965));
                                                        let _e7969 = select(_e7967, _e7885, (_e7885 < _e7967));
                                                        let _e7971 = select(_e7248, _e7969, (_e7969 > _e7248));
                                                        let _e7972 = (_e7971 > _e7025.member_1);
                                                        if _e7972 {
                                                            phi_13460_ = f32();
                                                            phi_13461_ = f32();
                                                            phi_13462_ = false;
                                                        } else {
                                                            let _e7973 = (_e7971 - _e7248);
                                                            phi_13460_ = select((_e7025.member_1 - _e7248), select(0f, (_e7547 + _e7547), select(select(true, false, (_e7973 <= (_e7252 * 0.25f))), true, (_e7973 <= _e7243))), _e7256);
                                                            phi_13461_ = _e7973;
                                                            phi_13462_ = true;
                                                        }
                                                        let _e7984 = phi_13460_;
                                                        let _e7986 = phi_13461_;
                                                        let _e7988 = phi_13462_;
                                                        phi_13464_ = _e7971;
                                                        phi_13465_ = _e7984;
                                                        phi_13466_ = _e7986;
                                                        phi_13468_ = _e7988;
                                                        phi_13469_ = _e7972;
                                                        phi_13471_ = false;
                                                    } else {
                                                        phi_13464_ = f32();
                                                        phi_13465_ = f32();
                                                        phi_13466_ = f32();
                                                        phi_13468_ = false;
                                                        phi_13469_ = false;
                                                        phi_13471_ = true;
                                                    }
                                                    let _e7990 = phi_13464_;
                                                    let _e7992 = phi_13465_;
                                                    let _e7994 = phi_13466_;
                                                    let _e7996 = phi_13468_;
                                                    let _e7998 = phi_13469_;
                                                    let _e8000 = phi_13471_;
                                                    phi_13472_ = _e7990;
                                                    phi_13473_ = _e7992;
                                                    phi_13474_ = _e7994;
                                                    phi_13476_ = false;
                                                    phi_13477_ = _e7996;
                                                    phi_13478_ = _e7998;
                                                    phi_13480_ = _e8000;
                                                } else {
                                                    phi_13472_ = f32();
                                                    phi_13473_ = f32();
                                                    phi_13474_ = f32();
                                                    phi_13476_ = true;
                                                    phi_13477_ = false;
                                                    phi_13478_ = false;
                                                    phi_13480_ = false;
                                                }
                                                let _e8002 = phi_13472_;
                                                let _e8004 = phi_13473_;
                                                let _e8006 = phi_13474_;
                                                let _e8008 = phi_13476_;
                                                let _e8010 = phi_13477_;
                                                let _e8012 = phi_13478_;
                                                let _e8014 = phi_13480_;
                                                phi_13481_ = _e8002;
                                                phi_13482_ = _e8004;
                                                phi_13483_ = _e8006;
                                                phi_13485_ = _e8008;
                                                phi_13486_ = _e8010;
                                                phi_13487_ = _e8012;
                                                phi_13489_ = _e8014;
                                            } else {
                                                phi_13481_ = f32();
                                                phi_13482_ = f32();
                                                phi_13483_ = f32();
                                                phi_13485_ = true;
                                                phi_13486_ = false;
                                                phi_13487_ = false;
                                                phi_13489_ = false;
                                            }
                                            let _e8016 = phi_13481_;
                                            let _e8018 = phi_13482_;
                                            let _e8020 = phi_13483_;
                                            let _e8022 = phi_13485_;
                                            let _e8024 = phi_13486_;
                                            let _e8026 = phi_13487_;
                                            let _e8028 = phi_13489_;
                                            if _e8022 {
                                                if (_e7248 <= _e7250) {
                                                    let _e8181 = (_e7258 + 1u);
                                                    let _e8182 = (_e8181 > 3u);
                                                    phi_13824_ = _e8181;
                                                    phi_13825_ = f32();
                                                    phi_13826_ = false;
                                                    phi_13827_ = select(true, false, _e8182);
                                                    phi_13828_ = _e8182;
                                                } else {
                                                    let _e8032 = local.member[0u];
                                                    let _e8035 = local.member_1[0u];
                                                    let _e8038 = local.member[0u];
                                                    let _e8044 = local.member_2[0u];
                                                    let _e8045 = ((_e8032 + ((_e8035 - _e8038) * _e7254)) - _e8044);
                                                    let _e8048 = local.member[1u];
                                                    let _e8051 = local.member_1[1u];
                                                    let _e8054 = local.member[1u];
                                                    let _e8060 = local.member_2[1u];
                                                    let _e8061 = ((_e8048 + ((_e8051 - _e8054) * _e7254)) - _e8060);
                                                    let _e8063 = select(_e8061, _e8045, (_e8045 < _e8061));
                                                    let _e8066 = local.member[2u];
                                                    let _e8069 = local.member_1[2u];
                                                    let _e8072 = local.member[2u];
                                                    let _e8078 = local.member_2[2u];
                                                    let _e8079 = ((_e8066 + ((_e8069 - _e8072) * _e7254)) - _e8078);
                                                    let _e8082 = local.member[3u];
                                                    let _e8085 = local.member_1[3u];
                                                    let _e8088 = local.member[3u];
                                                    let _e8094 = local.member_2[3u];
                                                    let _e8095 = ((_e8082 + ((_e8085 - _e8088) * _e7254)) - _e8094);
                                                    let _e8097 = select(_e8095, _e8079, (_e8079 < _e8095));
                                                    let _e8099 = select(_e8097, _e8063, (_e8063 < _e8097));
                                                    let _e8102 = local_1.member[0u];
                                                    let _e8105 = local_1.member_1[0u];
                                                    let _e8108 = local_1.member[0u];
                                                    let _e8114 = local_1.member_2[0u];
                                                    let _e8115 = ((_e8102 + ((_e8105 - _e8108) * _e7248)) - _e8114);
                                                    let _e8118 = local_1.member[1u];
                                                    let _e8121 = local_1.member_1[1u];
                                                    let _e8124 = local_1.member[1u];
                                                    let _e8130 = local_1.member_2[1u];
                                                    let _e8131 = ((_e8118 + ((_e8121 - _e8124) * _e7248)) - _e8130);
                                                    let _e8133 = select(_e8131, _e8115, (_e8115 < _e8131));
                                                    let _e8136 = local_1.member[2u];
                                                    let _e8139 = local_1.member_1[2u];
                                                    let _e8142 = local_1.member[2u];
                                                    let _e8148 = local_1.member_2[2u];
                                                    let _e8149 = ((_e8136 + ((_e8139 - _e8142) * _e7248)) - _e8148);
                                                    let _e8152 = local_1.member[3u];
                                                    let _e8155 = local_1.member_1[3u];
                                                    let _e8158 = local_1.member[3u];
                                                    let _e8164 = local_1.member_2[3u];
                                                    let _e8165 = ((_e8152 + ((_e8155 - _e8158) * _e7248)) - _e8164);
                                                    let _e8167 = select(_e8165, _e8149, (_e8149 < _e8165));
                                                    let _e8169 = select(_e8167, _e8133, (_e8133 < _e8167));
                                                    if (_e8169 > 0f) {
                                                        phi_13822_ = 0.5f;
                                                    } else {
                                                        let _e8173 = (0.95f * (_e8099 / (_e8099 - _e8169)));
                                                        phi_13822_ = select(0.0625f, select(0.9f, _e8173, (_e8173 < 0.9f)), (_e8173 > 0.0625f));
                                                    }
                                                    let _e8179 = phi_13822_;
                                                    phi_13824_ = u32();
                                                    phi_13825_ = (_e7547 * _e8179);
                                                    phi_13826_ = true;
                                                    phi_13827_ = false;
                                                    phi_13828_ = false;
                                                }
                                                let _e8185 = phi_13824_;
                                                let _e8187 = phi_13825_;
                                                let _e8189 = phi_13826_;
                                                let _e8191 = phi_13827_;
                                                let _e8193 = phi_13828_;
                                                phi_13829_ = _e8185;
                                                phi_13830_ = _e7250;
                                                phi_13831_ = _e8187;
                                                phi_13832_ = _e7252;
                                                phi_13833_ = _e7254;
                                                phi_13834_ = _e7256;
                                                phi_13835_ = _e7258;
                                                phi_13836_ = _e8189;
                                                phi_13837_ = _e8191;
                                                phi_13838_ = _e8193;
                                                phi_13839_ = false;
                                                phi_13841_ = false;
                                            } else {
                                                phi_13829_ = u32();
                                                phi_13830_ = _e8016;
                                                phi_13831_ = _e8018;
                                                phi_13832_ = _e8020;
                                                phi_13833_ = _e7248;
                                                phi_13834_ = true;
                                                phi_13835_ = 0u;
                                                phi_13836_ = _e8024;
                                                phi_13837_ = false;
                                                phi_13838_ = false;
                                                phi_13839_ = _e8026;
                                                phi_13841_ = _e8028;
                                            }
                                            let _e8195 = phi_13829_;
                                            let _e8197 = phi_13830_;
                                            let _e8199 = phi_13831_;
                                            let _e8201 = phi_13832_;
                                            let _e8203 = phi_13833_;
                                            let _e8205 = phi_13834_;
                                            let _e8207 = phi_13835_;
                                            let _e8209 = phi_13836_;
                                            let _e8211 = phi_13837_;
                                            let _e8213 = phi_13838_;
                                            let _e8215 = phi_13839_;
                                            let _e8217 = phi_13841_;
                                            if _e8209 {
                                                let _e8218 = (_e8203 + _e8199);
                                                let _e8220 = select(_e8197, _e8218, (_e8218 > _e8197));
                                                let _e8222 = select(_e7025.member_1, _e8220, (_e8220 < _e7025.member_1));
                                                let _e8225 = select(((_e8222 - _e8203) > _e7243), true, !(_e7256));
                                                phi_13869_ = _e8222;
                                                phi_13870_ = _e8197;
                                                phi_13871_ = _e8201;
                                                phi_13872_ = _e8203;
                                                phi_13873_ = _e8205;
                                                phi_13874_ = _e8207;
                                                phi_13875_ = _e8225;
                                                phi_13876_ = select(true, false, _e8225);
                                                phi_13877_ = false;
                                                phi_13878_ = false;
                                                phi_13880_ = false;
                                            } else {
                                                phi_13869_ = _e7248;
                                                phi_13870_ = _e7250;
                                                phi_13871_ = _e7252;
                                                phi_13872_ = _e7254;
                                                phi_13873_ = _e7256;
                                                phi_13874_ = _e8195;
                                                phi_13875_ = _e8211;
                                                phi_13876_ = false;
                                                phi_13877_ = _e8213;
                                                phi_13878_ = _e8215;
                                                phi_13880_ = _e8217;
                                            }
                                            let _e8228 = phi_13869_;
                                            let _e8230 = phi_13870_;
                                            let _e8232 = phi_13871_;
                                            let _e8234 = phi_13872_;
                                            let _e8236 = phi_13873_;
                                            let _e8238 = phi_13874_;
                                            let _e8240 = phi_13875_;
                                            let _e8242 = phi_13876_;
                                            let _e8244 = phi_13877_;
                                            let _e8246 = phi_13878_;
                                            let _e8248 = phi_13880_;
                                            phi_11702_ = _e8228;
                                            phi_11704_ = _e8230;
                                            phi_11706_ = _e8232;
                                            phi_11708_ = _e8234;
                                            phi_11710_ = _e8236;
                                            phi_11712_ = _e8238;
                                            phi_13881_ = _e8197;
                                            phi_13883_ = _e8240;
                                            phi_13884_ = _e8242;
                                            phi_13885_ = _e8244;
                                            phi_13886_ = _e8246;
                                            phi_13888_ = false;
                                            phi_13889_ = _e8248;
                                        } else {
                                            phi_11702_ = f32();
                                            phi_11704_ = f32();
                                            phi_11706_ = f32();
                                            phi_11708_ = f32();
                                            phi_11710_ = bool();
                                            phi_11712_ = u32();
                                            phi_13881_ = f32();
                                            phi_13883_ = false;
                                            phi_13884_ = false;
                                            phi_13885_ = false;
                                            phi_13886_ = false;
                                            phi_13888_ = true;
                                            phi_13889_ = false;
                                        }
                                        let _e8250 = phi_11702_;
                                        let _e8252 = phi_11704_;
                                        let _e8254 = phi_11706_;
                                        let _e8256 = phi_11708_;
                                        let _e8258 = phi_11710_;
                                        let _e8260 = phi_11712_;
                                        let _e8262 = phi_13881_;
                                        let _e8264 = phi_13883_;
                                        let _e8266 = phi_13884_;
                                        let _e8268 = phi_13885_;
                                        let _e8270 = phi_13886_;
                                        let _e8272 = phi_13888_;
                                        let _e8274 = phi_13889_;
                                        local_89 = _e8266;
                                        local_90 = _e8268;
                                        local_91 = _e8266;
                                        local_92 = _e8270;
                                        local_93 = _e8266;
                                        local_94 = _e8272;
                                        local_95 = _e8266;
                                        local_96 = _e8274;
                                        local_98 = _e8266;
                                        local_99 = _e8262;
                                        continue;
                                        continuing {
                                            phi_11698_ = type_9(select(_e7246.member, (_e7246.member + 1u), _e7261), select(_e7246.member_1, _e7246.member_1, _e7261));
                                            phi_11701_ = _e8250;
                                            phi_11703_ = _e8252;
                                            phi_11705_ = _e8254;
                                            phi_11707_ = _e8256;
                                            phi_11709_ = _e8258;
                                            phi_11711_ = _e8260;
                                            break if !(_e8264);
                                        }
                                    }
                                    let _e8277 = local_89;
                                    let _e8279 = local_90;
                                    let _e8280 = select(_e8279, false, _e8277);
                                    let _e8282 = local_91;
                                    let _e8284 = local_92;
                                    let _e8287 = local_93;
                                    let _e8289 = local_94;
                                    let _e8292 = local_95;
                                    let _e8294 = local_96;
                                    let _e8300 = local_97;
                                    let _e8302 = select(select(_e8284, false, _e8282), false, _e8280);
                                    let _e8304 = local_98;
                                    let _e8311 = select(select(_e8304, false, _e8280), false, _e8302);
                                    let _e8316 = local_99;
                                    let _e8318 = local_100;
                                    let _e8320 = select(select(select(select(_e8289, false, _e8287), false, _e8280), false, _e8302), true, _e8311);
                                    let _e8327 = select(select(select(select(select(_e8294, false, _e8292), false, _e8280), false, _e8302), false, _e8311), false, _e8320);
                                    let _e8332 = select(select(select(select(_e8280, true, _e8302), false, _e8311), false, _e8320), true, _e8327);
                                    let _e8335 = (select(select(type_34().member, 1u, _e8320), select(select(select(type_34().member, 1u, _e8280), 0u, _e8302), 0u, _e8327), _e8332) != 0u);
                                    phi_13957_ = select(select(type_34().member_1, select(_e8318, _e8316, _e8311), _e8320), select(select(select(type_34().member_1, _e8300, _e8280), type_34().member_1, _e8302), type_34().member_1, _e8327), _e8332);
                                    phi_13958_ = select(true, false, _e8335);
                                    phi_13959_ = _e8335;
                                    phi_13960_ = false;
                                    phi_13961_ = false;
                                    phi_13962_ = false;
                                } else {
                                    phi_13957_ = f32();
                                    phi_13958_ = _e7033;
                                    phi_13959_ = false;
                                    phi_13960_ = _e7035;
                                    phi_13961_ = _e7037;
                                    phi_13962_ = _e7039;
                                }
                                let _e8338 = phi_13957_;
                                let _e8340 = phi_13958_;
                                let _e8342 = phi_13959_;
                                let _e8344 = phi_13960_;
                                let _e8346 = phi_13961_;
                                let _e8348 = phi_13962_;
                                phi_13963_ = _e7025;
                                phi_13964_ = _e7027;
                                phi_13965_ = _e8338;
                                phi_13966_ = _e7029;
                                phi_13967_ = _e8340;
                                phi_13968_ = _e8342;
                                phi_13969_ = false;
                                phi_13970_ = _e8344;
                                phi_13971_ = _e8346;
                                phi_13972_ = _e8348;
                            } else {
                                phi_13963_ = type_46();
                                phi_13964_ = bool();
                                phi_13965_ = f32();
                                phi_13966_ = type_46();
                                phi_13967_ = false;
                                phi_13968_ = false;
                                phi_13969_ = true;
                                phi_13970_ = false;
                                phi_13971_ = false;
                                phi_13972_ = false;
                            }
                            let _e8350 = phi_13963_;
                            let _e8352 = phi_13964_;
                            let _e8354 = phi_13965_;
                            let _e8356 = phi_13966_;
                            let _e8358 = phi_13967_;
                            let _e8360 = phi_13968_;
                            let _e8362 = phi_13969_;
                            let _e8364 = phi_13970_;
                            let _e8366 = phi_13971_;
                            let _e8368 = phi_13972_;
                            local_101 = _e8360;
                            local_102 = _e8352;
                            local_103 = _e8350;
                            local_104 = _e8354;
                            local_105 = _e8354;
                            local_106 = _e8354;
                            local_110 = _e8362;
                            local_111 = _e8364;
                            local_112 = _e8366;
                            local_113 = _e8368;
                            local_107 = _e8360;
                            local_108 = _e8356;
                            continue;
                            continuing {
                                phi_9693_ = type_9(select(_e5960.member, (_e5960.member + 1u), _e5963), select(_e5960.member_1, _e5960.member_1, _e5963));
                                break if !(_e8358);
                            }
                        }
                        let _e8371 = local_101;
                        if _e8371 {
                            let _e8373 = local_102;
                            if _e8373 {
                                let _e8375 = local_103;
                                let _e8378 = local_104;
                                let _e8380 = ((_e8375.member_1 - _e8378) <= _e5924);
                                let _e8385 = local_105;
                                phi_13988_ = type_34(select(type_34().member, 1u, _e8380), select(type_34().member_1, _e8385, _e8380));
                                phi_13989_ = select(true, false, _e8380);
                            } else {
                                phi_13988_ = type_34();
                                phi_13989_ = true;
                            }
                            let _e8390 = phi_13988_;
                            let _e8392 = phi_13989_;
                            let _e8397 = local_106;
                            phi_13995_ = type_34(select(_e8390.member, 2u, _e8392), select(_e8390.member_1, _e8397, _e8392));
                            phi_13996_ = false;
                            phi_13997_ = false;
                            phi_13998_ = false;
                            phi_13999_ = false;
                        } else {
                            phi_13995_ = type_34();
                            let _e9053 = local_110;
                            phi_13996_ = _e9053;
                            let _e9056 = local_111;
                            phi_13997_ = _e9056;
                            let _e9059 = local_112;
                            phi_13998_ = _e9059;
                            let _e9062 = local_113;
                            phi_13999_ = _e9062;
                        }
                        let _e8401 = phi_13995_;
                        let _e8403 = phi_13996_;
                        let _e8405 = phi_13997_;
                        let _e8407 = phi_13998_;
                        let _e8409 = phi_13999_;
                        let _e8416 = select(_e8405, false, _e8403);
                        let _e8420 = local_107;
                        let _e8427 = select(select(_e8407, false, _e8403), false, _e8416);
                        let _e8433 = select(select(select(_e8409, false, _e8403), false, _e8416), false, _e8427);
                        let _e8437 = local_108;
                        let _e8441 = select(select(_e8416, true, _e8427), true, _e8433);
                        phi_14041_ = type_34(select(_e8401.member, select(select(select(type_34().member, 0u, _e8416), 0u, _e8427), 1u, _e8433), _e8441), select(_e8401.member_1, select(select(select(type_34().member_1, type_34().member_1, _e8416), type_34().member_1, _e8427), _e8437.member, _e8433), _e8441));
                        phi_14042_ = type_34(select(type_34().member, 0u, _e8403), select(type_34().member_1, type_34().member_1, _e8403));
                        phi_14043_ = select(select(select(select(select(_e8420, false, _e8403), false, _e8416), false, _e8427), false, _e8433), true, _e8441);
                    }
                    let _e8452 = phi_14041_;
                    let _e8454 = phi_14042_;
                    let _e8456 = phi_14043_;
                    let _e8459 = select(_e8454.member, _e8452.member, _e8456);
                    let _e8462 = select(_e8454.member_1, _e8452.member_1, _e8456);
                    let _e8468 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e8462 > _e5095)), (_e8459 == 1u))));
                    switch bitcast<i32>(_e8459) {
                        case 0: {
                            phi_14087_ = type_35(0u, _e8468, array<u32, 2>(0u, 0u), false);
                            break;
                        }
                        case 1: {
                            let _e8472 = function_4(_e8462);
                            phi_14087_ = type_35(0u, _e8468, _e8472, true);
                            break;
                        }
                        case 2: {
                            let _e8470 = function_4(_e8462);
                            phi_14087_ = type_35(1u, _e8468, _e8470, true);
                            break;
                        }
                        default: {
                            phi_14087_ = type_35();
                            break;
                        }
                    }
                    let _e8476 = phi_14087_;
                    let _e8480 = params.member.member.member_12;
                    let _e8481 = bitcast<u32>(_e8480);
                    if (_e8476.member_2[0] == select((_e8481 << bitcast<u32>(29i)), 0u, ((_e8481 & 2147483647u) < 8388608u))) {
                        let _e8491 = params.member.member.member_12;
                        let _e8492 = bitcast<u32>(_e8491);
                        let _e8493 = (_e8492 & 2147483647u);
                        phi_14127_ = (_e8476.member_2[1] == select(((_e8492 ^ _e8493) | ((_e8493 >> bitcast<u32>(3i)) + 939524096u)), 0u, (_e8493 < 8388608u)));
                    } else {
                        phi_14127_ = false;
                    }
                    let _e8503 = phi_14127_;
                    let _e8505 = params.member.member.member_1;
                    if ((_e8505 & 128u) != 0u) {
                        phi_14143_ = true;
                    } else {
                        let _e8509 = params.member.member.member_1;
                        phi_14143_ = select(false, _e8503, ((_e8509 & 64u) != 0u));
                    }
                    let _e8514 = phi_14143_;
                    phi_14162_ = type_35(select(1u, _e8476.member, select(true, select(true, false, _e8514), _e8476.member_3)), _e8476.member_1, _e8476.member_2, _e8476.member_3);
                } else {
                    phi_14162_ = _e5089;
                }
                let _e8525 = phi_14162_;
                let _e8529 = select(false, (_e8525.member == 0u), _e8525.member_3);
                if _e8529 {
                    let _e8538 = (_e8525.member_2[1] >> bitcast<u32>(20i));
                    if (_e8538 <= 896u) {
                        phi_14194_ = 0u;
                    } else {
                        phi_14194_ = ((((_e8538 - 896u) << bitcast<u32>(23i)) | ((_e8525.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e8525.member_2[0] >> bitcast<u32>(29i)));
                    }
                    let _e8553 = phi_14194_;
                    let _e8555 = atomicMin((&earliest.member[0u]), _e8553);
                }
                phi_14198_ = type_18(_e237, 0u, _e247, _e250, _e8525.member_2, _e8525.member_1);
                phi_14199_ = _e8529;
                phi_14200_ = (_e8525.member != 0u);
            } else {
                phi_14198_ = type_18(_e237, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_14199_ = false;
                phi_14200_ = false;
            }
            let _e8557 = phi_14198_;
            let _e8559 = phi_14199_;
            let _e8561 = phi_14200_;
            let _e8564 = params.member.member.member_1;
            if ((_e8564 & 16u) != 0u) {
                if (_e159 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e8559 {
                    let _e8570 = atomicAdd((&counters[0u]), 1u);
                    phi_14219_ = _e8570;
                } else {
                    phi_14219_ = 0u;
                }
                let _e8572 = phi_14219_;
                workgroupBarrier();
                if (_e159 == 0u) {
                    let _e8575 = atomicLoad((&counters[0u]));
                    if (_e8575 > 0u) {
                        let _e8578 = atomicAdd((&contacts.member[0u]), _e8575);
                        atomicStore((&counters[1u]), _e8578);
                    }
                }
                workgroupBarrier();
                let _e8581 = atomicLoad((&counters[1u]));
                let _e8582 = (_e8581 + _e8572);
                if _e8559 {
                    let _e8585 = params.member.member_1.member_3;
                    if (_e8582 < _e8585) {
                        let _e8587 = (7u * _e8582);
                        atomicStore((&contacts.member[(4u + _e8587)]), _e8557.member);
                        atomicStore((&contacts.member[(_e8587 + 5u)]), _e8557.member_1);
                        atomicStore((&contacts.member[(_e8587 + 6u)]), _e8557.member_2);
                        atomicStore((&contacts.member[(_e8587 + 7u)]), _e8557.member_3);
                        atomicStore((&contacts.member[(_e8587 + 8u)]), _e8557.member_4[0]);
                        atomicStore((&contacts.member[(_e8587 + 9u)]), _e8557.member_4[1]);
                        atomicStore((&contacts.member[(_e8587 + 10u)]), _e8557.member_5);
                    }
                }
            }
            workgroupBarrier();
            if (_e159 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e8561 {
                let _e8614 = atomicAdd((&counters[0u]), 1u);
                phi_14286_ = _e8614;
            } else {
                phi_14286_ = 0u;
            }
            let _e8616 = phi_14286_;
            workgroupBarrier();
            if (_e159 == 0u) {
                let _e8619 = atomicLoad((&counters[0u]));
                if (_e8619 > 0u) {
                    let _e8622 = atomicAdd((&undecided.member[0u]), _e8619);
                    atomicStore((&counters[1u]), _e8622);
                }
            }
            workgroupBarrier();
            let _e8625 = atomicLoad((&counters[1u]));
            let _e8626 = (_e8625 + _e8616);
            if _e8561 {
                let _e8632 = params.member.member_2.member.member_1;
                if (_e8626 < _e8632) {
                    let _e8634 = (2u * _e8626);
                    atomicStore((&undecided.member[(4u + _e8634)]), _e8557.member_2);
                    atomicStore((&undecided.member[(_e8634 + 5u)]), _e8557.member_3);
                }
            }
        }
        continue;
        continuing {
            phi_965_ = type_9(select(_e213.member, (_e213.member + 1u), _e216), select(_e213.member_1, _e213.member_1, _e216));
            break if !(_e229);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_15(id, n, lane);
}
