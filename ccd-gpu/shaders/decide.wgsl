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
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
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

fn function_5(param_13: ptr<function, type_34>, param_14: f32, param_15: f32, param_16: f32) -> bool {
    var phi_14901_: bool;
    var phi_14902_: bool;
    var phi_14907_: bool;

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
            phi_14901_ = select(bool(), ((_e43 > 0f) == (_e69 > 0f)), _e84);
            phi_14902_ = select(true, false, _e84);
        } else {
            phi_14901_ = bool();
            phi_14902_ = true;
        }
        let _e91 = phi_14901_;
        let _e93 = phi_14902_;
        phi_14907_ = select(_e91, false, _e93);
    } else {
        phi_14907_ = false;
    }
    let _e96 = phi_14907_;
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
    var phi_14393_: type_9;
    var phi_14394_: type_9;
    var phi_14395_: type_9;
    var phi_14396_: type_9;
    var phi_14397_: type_9;
    var phi_14398_: bool;

    let _e24 = ((param_39[1] >> bitcast<u32>(20i)) & 2047u);
    let _e28 = ((param_39[1] & 1048575u) | select(1048576u, 0u, (_e24 == 0u)));
    let _e33 = ((bitcast<i32>(select(1u, _e24, (1u < _e24))) - 1015i) - param_40);
    let _e35 = (bitcast<u32>(_e33) % 32u);
    if (_e33 >= 64i) {
        phi_14397_ = type_9();
        phi_14398_ = true;
    } else {
        let _e37 = (_e33 <= -53i);
        if _e37 {
            phi_14396_ = type_9();
        } else {
            if (_e33 >= 32i) {
                phi_14395_ = type_9((param_39[0] << bitcast<u32>((_e35 & 31u))), 0u);
            } else {
                if (_e33 >= 0i) {
                    phi_14394_ = type_9(((_e28 << bitcast<u32>((_e35 & 31u))) | ((param_39[0] >> bitcast<u32>(1i)) >> bitcast<u32>(((31u - _e35) & 31u)))), (param_39[0] << bitcast<u32>((_e35 & 31u))));
                } else {
                    if (_e33 > -32i) {
                        let _e49 = bitcast<u32>(-(_e33));
                        phi_14393_ = type_9(bitcast<u32>((bitcast<i32>(_e28) >> bitcast<u32>((_e49 & 31u)))), ((param_39[0] >> bitcast<u32>((_e49 & 31u))) | ((_e28 << bitcast<u32>(((31u - _e49) & 31u))) << bitcast<u32>(1i))));
                    } else {
                        phi_14393_ = type_9(0u, (_e28 >> bitcast<u32>(((bitcast<u32>(-(_e33)) - 32u) & 31u))));
                    }
                    let _e67 = phi_14393_;
                    phi_14394_ = _e67;
                }
                let _e83 = phi_14394_;
                phi_14395_ = _e83;
            }
            let _e89 = phi_14395_;
            phi_14396_ = _e89;
        }
        let _e91 = phi_14396_;
        phi_14397_ = _e91;
        phi_14398_ = _e37;
    }
    let _e93 = phi_14397_;
    let _e95 = phi_14398_;
    let _e97 = select(_e93.member, 0u, _e95);
    let _e99 = select(_e93.member_1, 0u, _e95);
    let _e102 = ((param_39[1] >> bitcast<u32>(31i)) != 0u);
    return type_9(select(_e97, (~(_e97) + select(0u, 1u, (_e99 == 0u))), _e102), select(_e99, (~(_e99) + 1u), _e102));
}

fn function_15(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_28;
    var local_1: type_28;
    var local_2: type_20;
    var local_3: type_20;
    var local_4: type_20;
    var local_5: array<type_16, 4>;
    var local_6: array<f32, 4>;
    var local_7: array<f32, 2>;
    var local_8: type_34;
    var local_9: array<f32, 4>;
    var local_10: type_27;
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
    var phi_963_: u32;
    var phi_966_: type_9;
    var phi_1124_: type_21;
    var phi_1538_: type_27;
    var phi_3246_: array<array<array<type_9, 3>, 2>, 4>;
    var phi_3793_: array<array<array<type_9, 3>, 2>, 3>;
    var phi_5088_: type_9;
    var phi_5091_: array<type_9, 4>;
    var phi_5095_: u32;
    var phi_5097_: u32;
    var phi_5317_: bool;
    var phi_5446_: u32;
    var phi_6595_: array<type_9, 2>;
    var phi_6624_: array<type_9, 2>;
    var phi_6653_: array<type_9, 2>;
    var phi_6667_: type_9;
    var phi_6989_: type_9;
    var phi_6990_: type_9;
    var phi_6991_: type_9;
    var phi_6992_: type_9;
    var phi_7106_: bool;
    var phi_7107_: bool;
    var phi_7108_: bool;
    var phi_7113_: u32;
    var phi_7114_: u32;
    var phi_7115_: bool;
    var phi_7116_: u32;
    var phi_7117_: bool;
    var phi_7118_: u32;
    var phi_7119_: bool;
    var phi_7124_: u32;
    var phi_7136_: bool;
    var phi_7137_: bool;
    var phi_7138_: bool;
    var phi_7139_: u32;
    var phi_7140_: u32;
    var phi_7141_: bool;
    var phi_7476_: array<type_9, 4>;
    var phi_7477_: u32;
    var phi_7478_: array<type_9, 4>;
    var phi_7480_: u32;
    var phi_7481_: u32;
    var phi_7482_: array<type_9, 4>;
    var phi_7484_: u32;
    var phi_7485_: u32;
    var phi_7486_: array<type_9, 4>;
    var phi_7488_: bool;
    var phi_7489_: u32;
    var phi_7490_: u32;
    var phi_7491_: bool;
    var phi_7492_: bool;
    var phi_7493_: u32;
    var phi_7494_: u32;
    var phi_7495_: bool;
    var phi_7790_: array<type_9, 4>;
    var phi_7791_: array<type_9, 4>;
    var phi_7792_: u32;
    var phi_7793_: u32;
    var phi_7794_: bool;
    var phi_7799_: array<type_9, 4>;
    var phi_7800_: u32;
    var phi_7801_: u32;
    var phi_7802_: bool;
    var phi_7803_: bool;
    var phi_7804_: bool;
    var phi_7805_: array<type_9, 4>;
    var phi_7807_: u32;
    var phi_7808_: u32;
    var phi_7809_: bool;
    var phi_7810_: bool;
    var phi_7811_: u32;
    var phi_7812_: u32;
    var phi_7813_: bool;
    var phi_7814_: bool;
    var phi_7815_: bool;
    var phi_5092_: array<type_9, 4>;
    var phi_5096_: u32;
    var phi_5098_: u32;
    var phi_7816_: u32;
    var phi_7817_: bool;
    var phi_7818_: bool;
    var phi_7819_: u32;
    var phi_7820_: u32;
    var phi_7821_: bool;
    var phi_7822_: bool;
    var phi_7823_: bool;
    var phi_7824_: bool;
    var phi_7825_: bool;
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
    var phi_8200_: bool;
    var phi_8201_: bool;
    var phi_8202_: bool;
    var phi_8203_: bool;
    var local_72: bool;
    var local_73: u32;
    var local_74: u32;
    var local_75: u32;
    var local_76: u32;
    var phi_8235_: type_9;
    var phi_8236_: bool;
    var phi_8237_: bool;
    var phi_8277_: array<u32, 2>;
    var phi_8283_: type_31;
    var phi_8290_: type_31;
    var phi_8291_: bool;
    var phi_8292_: type_31;
    var phi_8293_: bool;
    var phi_8564_: bool;
    var phi_8658_: type_29;
    var phi_8659_: bool;
    var phi_8660_: type_29;
    var phi_8661_: bool;
    var phi_8662_: type_29;
    var phi_8663_: bool;
    var phi_8668_: type_29;
    var phi_9393_: bool;
    var phi_9405_: f32;
    var phi_9476_: type_14;
    var phi_9479_: f32;
    var phi_9477_: type_14;
    var phi_9520_: type_15;
    var phi_9480_: f32;
    var local_77: f32;
    var phi_9533_: f32;
    var phi_9564_: type_9;
    var phi_9567_: u32;
    var phi_9634_: u32;
    var phi_9635_: u32;
    var phi_9568_: u32;
    var phi_9636_: u32;
    var phi_9692_: type_9;
    var phi_9848_: type_45;
    var phi_9849_: bool;
    var phi_9850_: type_45;
    var phi_9851_: bool;
    var phi_9882_: type_9;
    var phi_9885_: f32;
    var phi_9887_: f32;
    var phi_9889_: f32;
    var phi_9999_: bool;
    var phi_10006_: f32;
    var phi_10007_: bool;
    var phi_9886_: f32;
    var phi_9888_: f32;
    var phi_9890_: f32;
    var phi_10008_: f32;
    var phi_10009_: bool;
    var phi_10010_: bool;
    var local_78: bool;
    var local_79: f32;
    var local_80: f32;
    var phi_10015_: f32;
    var phi_10031_: type_9;
    var phi_10034_: f32;
    var phi_10099_: f32;
    var phi_10100_: bool;
    var phi_10101_: bool;
    var phi_10102_: bool;
    var phi_10103_: f32;
    var phi_10035_: f32;
    var phi_10104_: bool;
    var phi_10105_: bool;
    var phi_10106_: bool;
    var phi_10107_: bool;
    var local_81: bool;
    var local_82: bool;
    var local_83: bool;
    var local_84: bool;
    var local_85: f32;
    var phi_10121_: f32;
    var phi_10123_: type_45;
    var phi_10848_: u32;
    var phi_10849_: u32;
    var phi_11110_: array<type_16, 4>;
    var phi_11130_: type_9;
    var phi_11133_: bool;
    var phi_11134_: bool;
    var phi_11185_: bool;
    var phi_11186_: bool;
    var local_86: bool;
    var local_87: bool;
    var phi_11200_: u32;
    var phi_11201_: u32;
    var phi_11202_: bool;
    var phi_11233_: bool;
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
    var phi_11245_: type_45;
    var phi_11246_: bool;
    var phi_11247_: type_45;
    var phi_11248_: bool;
    var phi_11249_: bool;
    var phi_11250_: bool;
    var phi_11251_: bool;
    var phi_11252_: type_45;
    var phi_11253_: bool;
    var phi_11254_: type_45;
    var phi_11255_: bool;
    var phi_11256_: bool;
    var phi_11257_: bool;
    var phi_11258_: bool;
    var phi_11259_: bool;
    var phi_11267_: type_45;
    var phi_11268_: bool;
    var phi_11269_: type_45;
    var phi_11270_: bool;
    var phi_11271_: bool;
    var phi_11272_: bool;
    var phi_11273_: bool;
    var phi_11274_: bool;
    var phi_11697_: type_9;
    var phi_11700_: f32;
    var phi_11702_: f32;
    var phi_11704_: f32;
    var phi_11706_: f32;
    var phi_11708_: bool;
    var phi_11710_: u32;
    var phi_11861_: array<f32, 3>;
    var phi_11927_: type_14;
    var phi_11930_: f32;
    var phi_11928_: type_14;
    var phi_11971_: type_15;
    var phi_11931_: f32;
    var local_88: f32;
    var phi_11984_: f32;
    var phi_12107_: type_28;
    var phi_12108_: bool;
    var phi_12109_: type_28;
    var phi_12110_: bool;
    var phi_12118_: type_28;
    var phi_12289_: bool;
    var phi_12290_: bool;
    var phi_12291_: bool;
    var phi_12292_: bool;
    var phi_12293_: bool;
    var phi_12294_: bool;
    var phi_12595_: bool;
    var phi_12596_: bool;
    var phi_12597_: bool;
    var phi_12598_: bool;
    var phi_12599_: bool;
    var phi_12600_: bool;
    var phi_12608_: bool;
    var phi_12715_: f32;
    var phi_12716_: bool;
    var phi_12717_: f32;
    var phi_12718_: bool;
    var phi_12719_: f32;
    var phi_12720_: bool;
    var phi_12721_: bool;
    var phi_12783_: f32;
    var phi_12784_: bool;
    var phi_12785_: f32;
    var phi_12786_: bool;
    var phi_12787_: f32;
    var phi_12788_: bool;
    var phi_12789_: bool;
    var phi_12856_: f32;
    var phi_12857_: bool;
    var phi_12858_: f32;
    var phi_12859_: bool;
    var phi_12860_: f32;
    var phi_12861_: bool;
    var phi_12862_: bool;
    var phi_12924_: f32;
    var phi_12925_: bool;
    var phi_12926_: f32;
    var phi_12927_: bool;
    var phi_12928_: f32;
    var phi_12929_: bool;
    var phi_12930_: bool;
    var phi_13459_: f32;
    var phi_13460_: f32;
    var phi_13461_: bool;
    var phi_13463_: f32;
    var phi_13464_: f32;
    var phi_13465_: f32;
    var phi_13467_: bool;
    var phi_13468_: bool;
    var phi_13470_: bool;
    var phi_13471_: f32;
    var phi_13472_: f32;
    var phi_13473_: f32;
    var phi_13475_: bool;
    var phi_13476_: bool;
    var phi_13477_: bool;
    var phi_13479_: bool;
    var phi_13480_: f32;
    var phi_13481_: f32;
    var phi_13482_: f32;
    var phi_13484_: bool;
    var phi_13485_: bool;
    var phi_13486_: bool;
    var phi_13488_: bool;
    var phi_13821_: f32;
    var phi_13823_: u32;
    var phi_13824_: f32;
    var phi_13825_: bool;
    var phi_13826_: bool;
    var phi_13827_: bool;
    var phi_13828_: u32;
    var phi_13829_: f32;
    var phi_13830_: f32;
    var phi_13831_: f32;
    var phi_13832_: f32;
    var phi_13833_: bool;
    var phi_13834_: u32;
    var phi_13835_: bool;
    var phi_13836_: bool;
    var phi_13837_: bool;
    var phi_13838_: bool;
    var phi_13840_: bool;
    var phi_13868_: f32;
    var phi_13869_: f32;
    var phi_13870_: f32;
    var phi_13871_: f32;
    var phi_13872_: bool;
    var phi_13873_: u32;
    var phi_13874_: bool;
    var phi_13875_: bool;
    var phi_13876_: bool;
    var phi_13877_: bool;
    var phi_13879_: bool;
    var phi_11701_: f32;
    var phi_11703_: f32;
    var phi_11705_: f32;
    var phi_11707_: f32;
    var phi_11709_: bool;
    var phi_11711_: u32;
    var phi_13880_: f32;
    var phi_13882_: bool;
    var phi_13883_: bool;
    var phi_13884_: bool;
    var phi_13885_: bool;
    var phi_13887_: bool;
    var phi_13888_: bool;
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
    var phi_13956_: f32;
    var phi_13957_: bool;
    var phi_13958_: bool;
    var phi_13959_: bool;
    var phi_13960_: bool;
    var phi_13961_: bool;
    var phi_13962_: type_45;
    var phi_13963_: bool;
    var phi_13964_: f32;
    var phi_13965_: type_45;
    var phi_13966_: bool;
    var phi_13967_: bool;
    var phi_13968_: bool;
    var phi_13969_: bool;
    var phi_13970_: bool;
    var phi_13971_: bool;
    var local_101: bool;
    var local_102: bool;
    var local_103: type_45;
    var local_104: f32;
    var local_105: f32;
    var phi_13987_: type_30;
    var phi_13988_: bool;
    var local_106: f32;
    var phi_13994_: type_30;
    var phi_13995_: bool;
    var phi_13996_: bool;
    var phi_13997_: bool;
    var phi_13998_: bool;
    var local_107: bool;
    var local_108: type_45;
    var phi_14040_: type_30;
    var phi_14041_: type_30;
    var phi_14042_: bool;
    var phi_14086_: type_31;
    var phi_14126_: bool;
    var phi_14142_: bool;
    var phi_14161_: type_31;
    var phi_14162_: type_31;
    var phi_14163_: type_9;
    var phi_14194_: u32;
    var phi_14216_: u32;
    var phi_14282_: u32;
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
    let _e158 = id_2;
    let _e159 = n_2;
    let _e160 = lane_2;
    let _e173 = ((_e158.y * _e159.x) + _e158.x);
    let _e176 = (_e159.x * _e159.y);
    let _e179 = params.member.member_1.member_2;
    let _e181 = input.member[0u];
    let _e183 = select(_e181, _e179, (_e179 < _e181));
    let _e185 = params.member.member_1.member_1;
    if (_e183 > _e185) {
        let _e188 = params.member.member_1.member_1;
        phi_917_ = (_e183 - _e188);
    } else {
        phi_917_ = 0u;
    }
    let _e191 = phi_917_;
    let _e193 = params.member.member_1.member;
    let _e195 = select(_e191, _e193, (_e193 < _e191));
    let _e197 = (_e195 / 64u);
    let _e201 = select(_e197, (_e197 + 1u), ((_e195 % 64u) > 0u));
    if (_e201 > _e173) {
        let _e203 = (_e201 - _e173);
        if (_e176 == 0u) {
            return;
        }
        let _e205 = (_e203 / _e176);
        if (_e176 == 0u) {
            return;
        }
        phi_963_ = select(_e205, (_e205 + 1u), ((_e203 % _e176) > 0u));
    } else {
        phi_963_ = 0u;
    }
    let _e212 = phi_963_;
    phi_966_ = type_9(0u, _e212);
    loop {
        let _e215 = phi_966_;
        let _e218 = (_e215.member < _e215.member_1);
        let _e231 = (bitcast<i32>(select(0u, 1u, _e218)) != 0i);
        if _e231 {
            let _e235 = (((_e173 + (select(type_9().member_1, _e215.member, _e218) * _e176)) * 64u) + _e160);
            if (_e235 < _e195) {
                let _e239 = params.member.member_1.member_1;
                let _e241 = (2u * (_e239 + _e235));
                let _e244 = input.member[(4u + _e241)];
                let _e247 = input.member[(_e241 + 5u)];
                let _e253 = params.member.member_2.member.member;
                if (_e253 == 0u) {
                    let _e269 = (3u * _e247);
                    let _e271 = elements.member[_e269];
                    let _e274 = elements.member[(_e269 + 1u)];
                    let _e277 = elements.member[(_e269 + 2u)];
                    phi_1124_ = type_21(0u, array<u32, 4>(_e244, _e271, _e274, _e277));
                } else {
                    let _e255 = (2u * _e244);
                    let _e256 = (2u * _e247);
                    let _e258 = elements.member[_e255];
                    let _e260 = elements.member[_e256];
                    let _e263 = elements.member[(_e255 + 1u)];
                    let _e266 = elements.member[(_e256 + 1u)];
                    phi_1124_ = type_21(1u, array<u32, 4>(_e258, _e263, _e260, _e266));
                }
                let _e281 = phi_1124_;
                local_42 = array<u32, 4>(_e281.member_1[0], _e281.member_1[1], _e281.member_1[2], _e281.member_1[3]);
                let _e290 = paths.member[_e281.member_1[0]];
                let _e304 = paths.member[_e281.member_1[1]];
                let _e318 = paths.member[_e281.member_1[2]];
                let _e332 = paths.member[_e281.member_1[3]];
                local_43 = array<array<f32, 3>, 4>(array<f32, 3>(_e290.member.x, _e290.member.y, _e290.member.z), array<f32, 3>(_e304.member.x, _e304.member.y, _e304.member.z), array<f32, 3>(_e318.member.x, _e318.member.y, _e318.member.z), array<f32, 3>(_e332.member.x, _e332.member.y, _e332.member.z));
                local_44 = array<array<f32, 3>, 4>(array<f32, 3>(_e290.member_1.x, _e290.member_1.y, _e290.member_1.z), array<f32, 3>(_e304.member_1.x, _e304.member_1.y, _e304.member_1.z), array<f32, 3>(_e318.member_1.x, _e318.member_1.y, _e318.member_1.z), array<f32, 3>(_e332.member_1.x, _e332.member_1.y, _e332.member_1.z));
                let _e356 = params.member.member.member_4;
                if (_e281.member != 0u) {
                    let _e447 = local_43;
                    let _e452 = local_43;
                    let _e461 = local_44;
                    let _e466 = local_44;
                    let _e476 = local_43;
                    let _e481 = local_43;
                    let _e490 = local_44;
                    let _e495 = local_44;
                    let _e505 = local_43;
                    let _e510 = local_43;
                    let _e519 = local_44;
                    let _e524 = local_44;
                    phi_1538_ = type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e447[2][0] - _e452[0][0]), (_e447[2][1] - _e452[0][1]), (_e447[2][2] - _e452[0][2])), array<f32, 3>((_e461[2][0] - _e466[0][0]), (_e461[2][1] - _e466[0][1]), (_e461[2][2] - _e466[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e476[1][0] - _e481[0][0]), (_e476[1][1] - _e481[0][1]), (_e476[1][2] - _e481[0][2])), array<f32, 3>((_e490[1][0] - _e495[0][0]), (_e490[1][1] - _e495[0][1]), (_e490[1][2] - _e495[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e505[2][0] - _e510[3][0]), (_e505[2][1] - _e510[3][1]), (_e505[2][2] - _e510[3][2])), array<f32, 3>((_e519[2][0] - _e524[3][0]), (_e519[2][1] - _e524[3][1]), (_e519[2][2] - _e524[3][2]))), (_e356 + _e356));
                } else {
                    let _e358 = local_43;
                    let _e363 = local_43;
                    let _e372 = local_44;
                    let _e377 = local_44;
                    let _e387 = local_43;
                    let _e392 = local_43;
                    let _e401 = local_44;
                    let _e406 = local_44;
                    let _e416 = local_43;
                    let _e421 = local_43;
                    let _e430 = local_44;
                    let _e435 = local_44;
                    phi_1538_ = type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e358[0][0] - _e363[1][0]), (_e358[0][1] - _e363[1][1]), (_e358[0][2] - _e363[1][2])), array<f32, 3>((_e372[0][0] - _e377[1][0]), (_e372[0][1] - _e377[1][1]), (_e372[0][2] - _e377[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e387[2][0] - _e392[1][0]), (_e387[2][1] - _e392[1][1]), (_e387[2][2] - _e392[1][2])), array<f32, 3>((_e401[2][0] - _e406[1][0]), (_e401[2][1] - _e406[1][1]), (_e401[2][2] - _e406[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e416[3][0] - _e421[1][0]), (_e416[3][1] - _e421[1][1]), (_e416[3][2] - _e421[1][2])), array<f32, 3>((_e430[3][0] - _e435[1][0]), (_e430[3][1] - _e435[1][1]), (_e430[3][2] - _e435[1][2]))), (_e356 + _e356));
                }
                let _e537 = phi_1538_;
                let _e543 = select(_e537.member[0][0], -(_e537.member[0][0]), (_e537.member[0][0] < 0f));
                let _e547 = select(_e537.member[0][1], -(_e537.member[0][1]), (_e537.member[0][1] < 0f));
                let _e549 = select(_e547, _e543, (_e543 > _e547));
                let _e553 = select(_e537.member[0][2], -(_e537.member[0][2]), (_e537.member[0][2] < 0f));
                let _e555 = select(_e553, _e549, (_e549 > _e553));
                let _e561 = select(_e537.member[1][0], -(_e537.member[1][0]), (_e537.member[1][0] < 0f));
                let _e565 = select(_e537.member[1][1], -(_e537.member[1][1]), (_e537.member[1][1] < 0f));
                let _e567 = select(_e565, _e561, (_e561 > _e565));
                let _e571 = select(_e537.member[1][2], -(_e537.member[1][2]), (_e537.member[1][2] < 0f));
                let _e573 = select(_e571, _e567, (_e567 > _e571));
                let _e583 = select(_e537.member_1[0][0], -(_e537.member_1[0][0]), (_e537.member_1[0][0] < 0f));
                let _e587 = select(_e537.member_1[0][1], -(_e537.member_1[0][1]), (_e537.member_1[0][1] < 0f));
                let _e589 = select(_e587, _e583, (_e583 > _e587));
                let _e593 = select(_e537.member_1[0][2], -(_e537.member_1[0][2]), (_e537.member_1[0][2] < 0f));
                let _e595 = select(_e593, _e589, (_e589 > _e593));
                let _e601 = select(_e537.member_1[1][0], -(_e537.member_1[1][0]), (_e537.member_1[1][0] < 0f));
                let _e605 = select(_e537.member_1[1][1], -(_e537.member_1[1][1]), (_e537.member_1[1][1] < 0f));
                let _e607 = select(_e605, _e601, (_e601 > _e605));
                let _e611 = select(_e537.member_1[1][2], -(_e537.member_1[1][2]), (_e537.member_1[1][2] < 0f));
                let _e613 = select(_e611, _e607, (_e607 > _e611));
                let _e623 = select(_e537.member_2[0][0], -(_e537.member_2[0][0]), (_e537.member_2[0][0] < 0f));
                let _e627 = select(_e537.member_2[0][1], -(_e537.member_2[0][1]), (_e537.member_2[0][1] < 0f));
                let _e629 = select(_e627, _e623, (_e623 > _e627));
                let _e633 = select(_e537.member_2[0][2], -(_e537.member_2[0][2]), (_e537.member_2[0][2] < 0f));
                let _e635 = select(_e633, _e629, (_e629 > _e633));
                let _e641 = select(_e537.member_2[1][0], -(_e537.member_2[1][0]), (_e537.member_2[1][0] < 0f));
                let _e645 = select(_e537.member_2[1][1], -(_e537.member_2[1][1]), (_e537.member_2[1][1] < 0f));
                let _e647 = select(_e645, _e641, (_e641 > _e645));
                let _e651 = select(_e537.member_2[1][2], -(_e537.member_2[1][2]), (_e537.member_2[1][2] < 0f));
                let _e653 = select(_e651, _e647, (_e647 > _e651));
                let _e658 = function_((select(_e573, _e555, (_e555 > _e573)) + _e537.member_3), (select(_e613, _e595, (_e595 > _e613)) + _e537.member_3));
                let _e659 = function_(_e658, (select(_e653, _e635, (_e635 > _e653)) + _e537.member_3));
                let _e664 = bitcast<i32>(((bitcast<u32>(_e659) + 4u) >> bitcast<u32>(23i)));
                let _e665 = (_e664 >= 64i);
                let _e666 = (_e664 <= 190i);
                let _e672 = select(select(i32(), select(i32(), (_e664 - 126i), _e666), _e665), 2147483647i, select(true, select(true, false, _e666), _e665));
                let _e674 = params.member.member_2.member_3;
                if (_e674 > 0u) {
                    if (_e672 != 2147483647i) {
                        let _e678 = params.member.member.member_1;
                        if ((_e678 & 8u) != 0u) {
                            let _e918 = local_43;
                            let _e923 = bitcast<u32>(_e918[0][0]);
                            let _e924 = (_e923 & 2147483647u);
                            let _e925 = (_e924 < 8388608u);
                            let _e936 = function_14(array<u32, 2>(select((_e923 << bitcast<u32>(29i)), 0u, _e925), select(((_e923 ^ _e924) | ((_e924 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e925)), _e672);
                            let _e937 = bitcast<u32>(_e918[0][1]);
                            let _e938 = (_e937 & 2147483647u);
                            let _e939 = (_e938 < 8388608u);
                            let _e950 = function_14(array<u32, 2>(select((_e937 << bitcast<u32>(29i)), 0u, _e939), select(((_e937 ^ _e938) | ((_e938 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e939)), _e672);
                            let _e951 = bitcast<u32>(_e918[0][2]);
                            let _e952 = (_e951 & 2147483647u);
                            let _e953 = (_e952 < 8388608u);
                            let _e964 = function_14(array<u32, 2>(select((_e951 << bitcast<u32>(29i)), 0u, _e953), select(((_e951 ^ _e952) | ((_e952 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e953)), _e672);
                            let _e966 = local_44;
                            let _e971 = bitcast<u32>(_e966[0][0]);
                            let _e972 = (_e971 & 2147483647u);
                            let _e973 = (_e972 < 8388608u);
                            let _e984 = function_14(array<u32, 2>(select((_e971 << bitcast<u32>(29i)), 0u, _e973), select(((_e971 ^ _e972) | ((_e972 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e973)), _e672);
                            let _e985 = bitcast<u32>(_e966[0][1]);
                            let _e986 = (_e985 & 2147483647u);
                            let _e987 = (_e986 < 8388608u);
                            let _e998 = function_14(array<u32, 2>(select((_e985 << bitcast<u32>(29i)), 0u, _e987), select(((_e985 ^ _e986) | ((_e986 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e987)), _e672);
                            let _e999 = bitcast<u32>(_e966[0][2]);
                            let _e1000 = (_e999 & 2147483647u);
                            let _e1001 = (_e1000 < 8388608u);
                            let _e1012 = function_14(array<u32, 2>(select((_e999 << bitcast<u32>(29i)), 0u, _e1001), select(((_e999 ^ _e1000) | ((_e1000 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1001)), _e672);
                            let _e1015 = local_43;
                            let _e1020 = bitcast<u32>(_e1015[1][0]);
                            let _e1021 = (_e1020 & 2147483647u);
                            let _e1022 = (_e1021 < 8388608u);
                            let _e1033 = function_14(array<u32, 2>(select((_e1020 << bitcast<u32>(29i)), 0u, _e1022), select(((_e1020 ^ _e1021) | ((_e1021 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1022)), _e672);
                            let _e1034 = bitcast<u32>(_e1015[1][1]);
                            let _e1035 = (_e1034 & 2147483647u);
                            let _e1036 = (_e1035 < 8388608u);
                            let _e1047 = function_14(array<u32, 2>(select((_e1034 << bitcast<u32>(29i)), 0u, _e1036), select(((_e1034 ^ _e1035) | ((_e1035 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1036)), _e672);
                            let _e1048 = bitcast<u32>(_e1015[1][2]);
                            let _e1049 = (_e1048 & 2147483647u);
                            let _e1050 = (_e1049 < 8388608u);
                            let _e1061 = function_14(array<u32, 2>(select((_e1048 << bitcast<u32>(29i)), 0u, _e1050), select(((_e1048 ^ _e1049) | ((_e1049 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1050)), _e672);
                            let _e1063 = local_44;
                            let _e1068 = bitcast<u32>(_e1063[1][0]);
                            let _e1069 = (_e1068 & 2147483647u);
                            let _e1070 = (_e1069 < 8388608u);
                            let _e1081 = function_14(array<u32, 2>(select((_e1068 << bitcast<u32>(29i)), 0u, _e1070), select(((_e1068 ^ _e1069) | ((_e1069 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1070)), _e672);
                            let _e1082 = bitcast<u32>(_e1063[1][1]);
                            let _e1083 = (_e1082 & 2147483647u);
                            let _e1084 = (_e1083 < 8388608u);
                            let _e1095 = function_14(array<u32, 2>(select((_e1082 << bitcast<u32>(29i)), 0u, _e1084), select(((_e1082 ^ _e1083) | ((_e1083 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1084)), _e672);
                            let _e1096 = bitcast<u32>(_e1063[1][2]);
                            let _e1097 = (_e1096 & 2147483647u);
                            let _e1098 = (_e1097 < 8388608u);
                            let _e1109 = function_14(array<u32, 2>(select((_e1096 << bitcast<u32>(29i)), 0u, _e1098), select(((_e1096 ^ _e1097) | ((_e1097 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1098)), _e672);
                            let _e1112 = local_43;
                            let _e1117 = bitcast<u32>(_e1112[2][0]);
                            let _e1118 = (_e1117 & 2147483647u);
                            let _e1119 = (_e1118 < 8388608u);
                            let _e1130 = function_14(array<u32, 2>(select((_e1117 << bitcast<u32>(29i)), 0u, _e1119), select(((_e1117 ^ _e1118) | ((_e1118 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1119)), _e672);
                            let _e1131 = bitcast<u32>(_e1112[2][1]);
                            let _e1132 = (_e1131 & 2147483647u);
                            let _e1133 = (_e1132 < 8388608u);
                            let _e1144 = function_14(array<u32, 2>(select((_e1131 << bitcast<u32>(29i)), 0u, _e1133), select(((_e1131 ^ _e1132) | ((_e1132 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1133)), _e672);
                            let _e1145 = bitcast<u32>(_e1112[2][2]);
                            let _e1146 = (_e1145 & 2147483647u);
                            let _e1147 = (_e1146 < 8388608u);
                            let _e1158 = function_14(array<u32, 2>(select((_e1145 << bitcast<u32>(29i)), 0u, _e1147), select(((_e1145 ^ _e1146) | ((_e1146 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1147)), _e672);
                            let _e1160 = local_44;
                            let _e1165 = bitcast<u32>(_e1160[2][0]);
                            let _e1166 = (_e1165 & 2147483647u);
                            let _e1167 = (_e1166 < 8388608u);
                            let _e1178 = function_14(array<u32, 2>(select((_e1165 << bitcast<u32>(29i)), 0u, _e1167), select(((_e1165 ^ _e1166) | ((_e1166 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1167)), _e672);
                            let _e1179 = bitcast<u32>(_e1160[2][1]);
                            let _e1180 = (_e1179 & 2147483647u);
                            let _e1181 = (_e1180 < 8388608u);
                            let _e1192 = function_14(array<u32, 2>(select((_e1179 << bitcast<u32>(29i)), 0u, _e1181), select(((_e1179 ^ _e1180) | ((_e1180 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1181)), _e672);
                            let _e1193 = bitcast<u32>(_e1160[2][2]);
                            let _e1194 = (_e1193 & 2147483647u);
                            let _e1195 = (_e1194 < 8388608u);
                            let _e1206 = function_14(array<u32, 2>(select((_e1193 << bitcast<u32>(29i)), 0u, _e1195), select(((_e1193 ^ _e1194) | ((_e1194 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1195)), _e672);
                            let _e1209 = local_43;
                            let _e1214 = bitcast<u32>(_e1209[3][0]);
                            let _e1215 = (_e1214 & 2147483647u);
                            let _e1216 = (_e1215 < 8388608u);
                            let _e1227 = function_14(array<u32, 2>(select((_e1214 << bitcast<u32>(29i)), 0u, _e1216), select(((_e1214 ^ _e1215) | ((_e1215 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1216)), _e672);
                            let _e1228 = bitcast<u32>(_e1209[3][1]);
                            let _e1229 = (_e1228 & 2147483647u);
                            let _e1230 = (_e1229 < 8388608u);
                            let _e1241 = function_14(array<u32, 2>(select((_e1228 << bitcast<u32>(29i)), 0u, _e1230), select(((_e1228 ^ _e1229) | ((_e1229 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1230)), _e672);
                            let _e1242 = bitcast<u32>(_e1209[3][2]);
                            let _e1243 = (_e1242 & 2147483647u);
                            let _e1244 = (_e1243 < 8388608u);
                            let _e1255 = function_14(array<u32, 2>(select((_e1242 << bitcast<u32>(29i)), 0u, _e1244), select(((_e1242 ^ _e1243) | ((_e1243 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1244)), _e672);
                            let _e1257 = local_44;
                            let _e1262 = bitcast<u32>(_e1257[3][0]);
                            let _e1263 = (_e1262 & 2147483647u);
                            let _e1264 = (_e1263 < 8388608u);
                            let _e1275 = function_14(array<u32, 2>(select((_e1262 << bitcast<u32>(29i)), 0u, _e1264), select(((_e1262 ^ _e1263) | ((_e1263 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1264)), _e672);
                            let _e1276 = bitcast<u32>(_e1257[3][1]);
                            let _e1277 = (_e1276 & 2147483647u);
                            let _e1278 = (_e1277 < 8388608u);
                            let _e1289 = function_14(array<u32, 2>(select((_e1276 << bitcast<u32>(29i)), 0u, _e1278), select(((_e1276 ^ _e1277) | ((_e1277 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1278)), _e672);
                            let _e1290 = bitcast<u32>(_e1257[3][2]);
                            let _e1291 = (_e1290 & 2147483647u);
                            let _e1292 = (_e1291 < 8388608u);
                            let _e1303 = function_14(array<u32, 2>(select((_e1290 << bitcast<u32>(29i)), 0u, _e1292), select(((_e1290 ^ _e1291) | ((_e1291 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1292)), _e672);
                            phi_3246_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e936, _e950, _e964), array<type_9, 3>(_e984, _e998, _e1012)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1033, _e1047, _e1061), array<type_9, 3>(_e1081, _e1095, _e1109)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1130, _e1144, _e1158), array<type_9, 3>(_e1178, _e1192, _e1206)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1227, _e1241, _e1255), array<type_9, 3>(_e1275, _e1289, _e1303)));
                        } else {
                            let _e683 = params.member.member.member_10[1u];
                            let _e688 = (_e672 - (bitcast<i32>((_e683 >> bitcast<u32>(20i))) - 1023i));
                            let _e689 = local_42;
                            let _e693 = params.member.member.member[0u];
                            let _e695 = (6u * (_e693 + _e689[0]));
                            let _e696 = (6u * _e689[0]);
                            let _e698 = positions.member[_e696];
                            let _e701 = positions.member[(_e696 + 1u)];
                            let _e703 = function_14(array<u32, 2>(_e698, _e701), _e688);
                            let _e706 = positions.member[(_e696 + 2u)];
                            let _e709 = positions.member[(_e696 + 3u)];
                            let _e711 = function_14(array<u32, 2>(_e706, _e709), _e688);
                            let _e714 = positions.member[(_e696 + 4u)];
                            let _e717 = positions.member[(_e696 + 5u)];
                            let _e719 = function_14(array<u32, 2>(_e714, _e717), _e688);
                            let _e722 = positions.member[_e695];
                            let _e725 = positions.member[(_e695 + 1u)];
                            let _e727 = function_14(array<u32, 2>(_e722, _e725), _e688);
                            let _e730 = positions.member[(_e695 + 2u)];
                            let _e733 = positions.member[(_e695 + 3u)];
                            let _e735 = function_14(array<u32, 2>(_e730, _e733), _e688);
                            let _e738 = positions.member[(_e695 + 4u)];
                            let _e741 = positions.member[(_e695 + 5u)];
                            let _e743 = function_14(array<u32, 2>(_e738, _e741), _e688);
                            let _e746 = local_42;
                            let _e750 = params.member.member.member[0u];
                            let _e752 = (6u * (_e750 + _e746[1]));
                            let _e753 = (6u * _e746[1]);
                            let _e755 = positions.member[_e753];
                            let _e758 = positions.member[(_e753 + 1u)];
                            let _e760 = function_14(array<u32, 2>(_e755, _e758), _e688);
                            let _e763 = positions.member[(_e753 + 2u)];
                            let _e766 = positions.member[(_e753 + 3u)];
                            let _e768 = function_14(array<u32, 2>(_e763, _e766), _e688);
                            let _e771 = positions.member[(_e753 + 4u)];
                            let _e774 = positions.member[(_e753 + 5u)];
                            let _e776 = function_14(array<u32, 2>(_e771, _e774), _e688);
                            let _e779 = positions.member[_e752];
                            let _e782 = positions.member[(_e752 + 1u)];
                            let _e784 = function_14(array<u32, 2>(_e779, _e782), _e688);
                            let _e787 = positions.member[(_e752 + 2u)];
                            let _e790 = positions.member[(_e752 + 3u)];
                            let _e792 = function_14(array<u32, 2>(_e787, _e790), _e688);
                            let _e795 = positions.member[(_e752 + 4u)];
                            let _e798 = positions.member[(_e752 + 5u)];
                            let _e800 = function_14(array<u32, 2>(_e795, _e798), _e688);
                            let _e803 = local_42;
                            let _e807 = params.member.member.member[0u];
                            let _e809 = (6u * (_e807 + _e803[2]));
                            let _e810 = (6u * _e803[2]);
                            let _e812 = positions.member[_e810];
                            let _e815 = positions.member[(_e810 + 1u)];
                            let _e817 = function_14(array<u32, 2>(_e812, _e815), _e688);
                            let _e820 = positions.member[(_e810 + 2u)];
                            let _e823 = positions.member[(_e810 + 3u)];
                            let _e825 = function_14(array<u32, 2>(_e820, _e823), _e688);
                            let _e828 = positions.member[(_e810 + 4u)];
                            let _e831 = positions.member[(_e810 + 5u)];
                            let _e833 = function_14(array<u32, 2>(_e828, _e831), _e688);
                            let _e836 = positions.member[_e809];
                            let _e839 = positions.member[(_e809 + 1u)];
                            let _e841 = function_14(array<u32, 2>(_e836, _e839), _e688);
                            let _e844 = positions.member[(_e809 + 2u)];
                            let _e847 = positions.member[(_e809 + 3u)];
                            let _e849 = function_14(array<u32, 2>(_e844, _e847), _e688);
                            let _e852 = positions.member[(_e809 + 4u)];
                            let _e855 = positions.member[(_e809 + 5u)];
                            let _e857 = function_14(array<u32, 2>(_e852, _e855), _e688);
                            let _e860 = local_42;
                            let _e864 = params.member.member.member[0u];
                            let _e866 = (6u * (_e864 + _e860[3]));
                            let _e867 = (6u * _e860[3]);
                            let _e869 = positions.member[_e867];
                            let _e872 = positions.member[(_e867 + 1u)];
                            let _e874 = function_14(array<u32, 2>(_e869, _e872), _e688);
                            let _e877 = positions.member[(_e867 + 2u)];
                            let _e880 = positions.member[(_e867 + 3u)];
                            let _e882 = function_14(array<u32, 2>(_e877, _e880), _e688);
                            let _e885 = positions.member[(_e867 + 4u)];
                            let _e888 = positions.member[(_e867 + 5u)];
                            let _e890 = function_14(array<u32, 2>(_e885, _e888), _e688);
                            let _e893 = positions.member[_e866];
                            let _e896 = positions.member[(_e866 + 1u)];
                            let _e898 = function_14(array<u32, 2>(_e893, _e896), _e688);
                            let _e901 = positions.member[(_e866 + 2u)];
                            let _e904 = positions.member[(_e866 + 3u)];
                            let _e906 = function_14(array<u32, 2>(_e901, _e904), _e688);
                            let _e909 = positions.member[(_e866 + 4u)];
                            let _e912 = positions.member[(_e866 + 5u)];
                            let _e914 = function_14(array<u32, 2>(_e909, _e912), _e688);
                            phi_3246_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e703, _e711, _e719), array<type_9, 3>(_e727, _e735, _e743)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e760, _e768, _e776), array<type_9, 3>(_e784, _e792, _e800)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e817, _e825, _e833), array<type_9, 3>(_e841, _e849, _e857)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e874, _e882, _e890), array<type_9, 3>(_e898, _e906, _e914)));
                        }
                        let _e1308 = phi_3246_;
                        let _e1310 = params.member.member_2.member_1;
                        let _e1312 = params.member.member_2.member_2;
                        let _e1314 = params.member.member_2.member_3;
                        if (_e281.member != 0u) {
                            phi_3793_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1308[2][0][0].member - _e1308[0][0][0].member) - select(0u, 1u, (_e1308[2][0][0].member_1 < _e1308[0][0][0].member_1))), (_e1308[2][0][0].member_1 - _e1308[0][0][0].member_1)), type_9(((_e1308[2][0][1].member - _e1308[0][0][1].member) - select(0u, 1u, (_e1308[2][0][1].member_1 < _e1308[0][0][1].member_1))), (_e1308[2][0][1].member_1 - _e1308[0][0][1].member_1)), type_9(((_e1308[2][0][2].member - _e1308[0][0][2].member) - select(0u, 1u, (_e1308[2][0][2].member_1 < _e1308[0][0][2].member_1))), (_e1308[2][0][2].member_1 - _e1308[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1308[2][1][0].member - _e1308[0][1][0].member) - select(0u, 1u, (_e1308[2][1][0].member_1 < _e1308[0][1][0].member_1))), (_e1308[2][1][0].member_1 - _e1308[0][1][0].member_1)), type_9(((_e1308[2][1][1].member - _e1308[0][1][1].member) - select(0u, 1u, (_e1308[2][1][1].member_1 < _e1308[0][1][1].member_1))), (_e1308[2][1][1].member_1 - _e1308[0][1][1].member_1)), type_9(((_e1308[2][1][2].member - _e1308[0][1][2].member) - select(0u, 1u, (_e1308[2][1][2].member_1 < _e1308[0][1][2].member_1))), (_e1308[2][1][2].member_1 - _e1308[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1308[1][0][0].member - _e1308[0][0][0].member) - select(0u, 1u, (_e1308[1][0][0].member_1 < _e1308[0][0][0].member_1))), (_e1308[1][0][0].member_1 - _e1308[0][0][0].member_1)), type_9(((_e1308[1][0][1].member - _e1308[0][0][1].member) - select(0u, 1u, (_e1308[1][0][1].member_1 < _e1308[0][0][1].member_1))), (_e1308[1][0][1].member_1 - _e1308[0][0][1].member_1)), type_9(((_e1308[1][0][2].member - _e1308[0][0][2].member) - select(0u, 1u, (_e1308[1][0][2].member_1 < _e1308[0][0][2].member_1))), (_e1308[1][0][2].member_1 - _e1308[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1308[1][1][0].member - _e1308[0][1][0].member) - select(0u, 1u, (_e1308[1][1][0].member_1 < _e1308[0][1][0].member_1))), (_e1308[1][1][0].member_1 - _e1308[0][1][0].member_1)), type_9(((_e1308[1][1][1].member - _e1308[0][1][1].member) - select(0u, 1u, (_e1308[1][1][1].member_1 < _e1308[0][1][1].member_1))), (_e1308[1][1][1].member_1 - _e1308[0][1][1].member_1)), type_9(((_e1308[1][1][2].member - _e1308[0][1][2].member) - select(0u, 1u, (_e1308[1][1][2].member_1 < _e1308[0][1][2].member_1))), (_e1308[1][1][2].member_1 - _e1308[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1308[2][0][0].member - _e1308[3][0][0].member) - select(0u, 1u, (_e1308[2][0][0].member_1 < _e1308[3][0][0].member_1))), (_e1308[2][0][0].member_1 - _e1308[3][0][0].member_1)), type_9(((_e1308[2][0][1].member - _e1308[3][0][1].member) - select(0u, 1u, (_e1308[2][0][1].member_1 < _e1308[3][0][1].member_1))), (_e1308[2][0][1].member_1 - _e1308[3][0][1].member_1)), type_9(((_e1308[2][0][2].member - _e1308[3][0][2].member) - select(0u, 1u, (_e1308[2][0][2].member_1 < _e1308[3][0][2].member_1))), (_e1308[2][0][2].member_1 - _e1308[3][0][2].member_1))), array<type_9, 3>(type_9(((_e1308[2][1][0].member - _e1308[3][1][0].member) - select(0u, 1u, (_e1308[2][1][0].member_1 < _e1308[3][1][0].member_1))), (_e1308[2][1][0].member_1 - _e1308[3][1][0].member_1)), type_9(((_e1308[2][1][1].member - _e1308[3][1][1].member) - select(0u, 1u, (_e1308[2][1][1].member_1 < _e1308[3][1][1].member_1))), (_e1308[2][1][1].member_1 - _e1308[3][1][1].member_1)), type_9(((_e1308[2][1][2].member - _e1308[3][1][2].member) - select(0u, 1u, (_e1308[2][1][2].member_1 < _e1308[3][1][2].member_1))), (_e1308[2][1][2].member_1 - _e1308[3][1][2].member_1)))));
                        } else {
                            phi_3793_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1308[0][0][0].member - _e1308[1][0][0].member) - select(0u, 1u, (_e1308[0][0][0].member_1 < _e1308[1][0][0].member_1))), (_e1308[0][0][0].member_1 - _e1308[1][0][0].member_1)), type_9(((_e1308[0][0][1].member - _e1308[1][0][1].member) - select(0u, 1u, (_e1308[0][0][1].member_1 < _e1308[1][0][1].member_1))), (_e1308[0][0][1].member_1 - _e1308[1][0][1].member_1)), type_9(((_e1308[0][0][2].member - _e1308[1][0][2].member) - select(0u, 1u, (_e1308[0][0][2].member_1 < _e1308[1][0][2].member_1))), (_e1308[0][0][2].member_1 - _e1308[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1308[0][1][0].member - _e1308[1][1][0].member) - select(0u, 1u, (_e1308[0][1][0].member_1 < _e1308[1][1][0].member_1))), (_e1308[0][1][0].member_1 - _e1308[1][1][0].member_1)), type_9(((_e1308[0][1][1].member - _e1308[1][1][1].member) - select(0u, 1u, (_e1308[0][1][1].member_1 < _e1308[1][1][1].member_1))), (_e1308[0][1][1].member_1 - _e1308[1][1][1].member_1)), type_9(((_e1308[0][1][2].member - _e1308[1][1][2].member) - select(0u, 1u, (_e1308[0][1][2].member_1 < _e1308[1][1][2].member_1))), (_e1308[0][1][2].member_1 - _e1308[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1308[2][0][0].member - _e1308[1][0][0].member) - select(0u, 1u, (_e1308[2][0][0].member_1 < _e1308[1][0][0].member_1))), (_e1308[2][0][0].member_1 - _e1308[1][0][0].member_1)), type_9(((_e1308[2][0][1].member - _e1308[1][0][1].member) - select(0u, 1u, (_e1308[2][0][1].member_1 < _e1308[1][0][1].member_1))), (_e1308[2][0][1].member_1 - _e1308[1][0][1].member_1)), type_9(((_e1308[2][0][2].member - _e1308[1][0][2].member) - select(0u, 1u, (_e1308[2][0][2].member_1 < _e1308[1][0][2].member_1))), (_e1308[2][0][2].member_1 - _e1308[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1308[2][1][0].member - _e1308[1][1][0].member) - select(0u, 1u, (_e1308[2][1][0].member_1 < _e1308[1][1][0].member_1))), (_e1308[2][1][0].member_1 - _e1308[1][1][0].member_1)), type_9(((_e1308[2][1][1].member - _e1308[1][1][1].member) - select(0u, 1u, (_e1308[2][1][1].member_1 < _e1308[1][1][1].member_1))), (_e1308[2][1][1].member_1 - _e1308[1][1][1].member_1)), type_9(((_e1308[2][1][2].member - _e1308[1][1][2].member) - select(0u, 1u, (_e1308[2][1][2].member_1 < _e1308[1][1][2].member_1))), (_e1308[2][1][2].member_1 - _e1308[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1308[3][0][0].member - _e1308[1][0][0].member) - select(0u, 1u, (_e1308[3][0][0].member_1 < _e1308[1][0][0].member_1))), (_e1308[3][0][0].member_1 - _e1308[1][0][0].member_1)), type_9(((_e1308[3][0][1].member - _e1308[1][0][1].member) - select(0u, 1u, (_e1308[3][0][1].member_1 < _e1308[1][0][1].member_1))), (_e1308[3][0][1].member_1 - _e1308[1][0][1].member_1)), type_9(((_e1308[3][0][2].member - _e1308[1][0][2].member) - select(0u, 1u, (_e1308[3][0][2].member_1 < _e1308[1][0][2].member_1))), (_e1308[3][0][2].member_1 - _e1308[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1308[3][1][0].member - _e1308[1][1][0].member) - select(0u, 1u, (_e1308[3][1][0].member_1 < _e1308[1][1][0].member_1))), (_e1308[3][1][0].member_1 - _e1308[1][1][0].member_1)), type_9(((_e1308[3][1][1].member - _e1308[1][1][1].member) - select(0u, 1u, (_e1308[3][1][1].member_1 < _e1308[1][1][1].member_1))), (_e1308[3][1][1].member_1 - _e1308[1][1][1].member_1)), type_9(((_e1308[3][1][2].member - _e1308[1][1][2].member) - select(0u, 1u, (_e1308[3][1][2].member_1 < _e1308[1][1][2].member_1))), (_e1308[3][1][2].member_1 - _e1308[1][1][2].member_1)))));
                        }
                        let _e1889 = phi_3793_;
                        local_40 = array<type_9, 3>(type_9(_e1889[1][0][0].member, _e1889[1][0][0].member_1), type_9(_e1889[1][0][1].member, _e1889[1][0][1].member_1), type_9(_e1889[1][0][2].member, _e1889[1][0][2].member_1));
                        local_41 = array<type_9, 3>(type_9(_e1889[2][0][0].member, _e1889[2][0][0].member_1), type_9(_e1889[2][0][1].member, _e1889[2][0][1].member_1), type_9(_e1889[2][0][2].member, _e1889[2][0][2].member_1));
                        let _e1922 = local_40[1u].member;
                        let _e1924 = local_40[1u].member_1;
                        let _e1927 = local_41[2u].member;
                        let _e1929 = local_41[2u].member_1;
                        let _e1930 = function_10(_e1922, _e1924, _e1927, _e1929);
                        let _e1935 = local_40[2u].member;
                        let _e1937 = local_40[2u].member_1;
                        let _e1940 = local_41[1u].member;
                        let _e1942 = local_41[1u].member_1;
                        let _e1943 = function_10(_e1935, _e1937, _e1940, _e1942);
                        let _e1949 = ((_e1930.member - _e1943.member) - select(0u, 1u, (_e1930.member_1 < _e1943.member_1)));
                        let _e1950 = (_e1930.member_1 - _e1943.member_1);
                        local_38 = array<type_9, 3>(type_9(_e1889[1][0][0].member, _e1889[1][0][0].member_1), type_9(_e1889[1][0][1].member, _e1889[1][0][1].member_1), type_9(_e1889[1][0][2].member, _e1889[1][0][2].member_1));
                        local_39 = array<type_9, 3>(type_9(_e1889[2][0][0].member, _e1889[2][0][0].member_1), type_9(_e1889[2][0][1].member, _e1889[2][0][1].member_1), type_9(_e1889[2][0][2].member, _e1889[2][0][2].member_1));
                        let _e1979 = local_38[2u].member;
                        let _e1981 = local_38[2u].member_1;
                        let _e1984 = local_39[0u].member;
                        let _e1986 = local_39[0u].member_1;
                        let _e1987 = function_10(_e1979, _e1981, _e1984, _e1986);
                        let _e1992 = local_38[0u].member;
                        let _e1994 = local_38[0u].member_1;
                        let _e1997 = local_39[2u].member;
                        let _e1999 = local_39[2u].member_1;
                        let _e2000 = function_10(_e1992, _e1994, _e1997, _e1999);
                        let _e2006 = ((_e1987.member - _e2000.member) - select(0u, 1u, (_e1987.member_1 < _e2000.member_1)));
                        let _e2007 = (_e1987.member_1 - _e2000.member_1);
                        local_36 = array<type_9, 3>(type_9(_e1889[1][0][0].member, _e1889[1][0][0].member_1), type_9(_e1889[1][0][1].member, _e1889[1][0][1].member_1), type_9(_e1889[1][0][2].member, _e1889[1][0][2].member_1));
                        local_37 = array<type_9, 3>(type_9(_e1889[2][0][0].member, _e1889[2][0][0].member_1), type_9(_e1889[2][0][1].member, _e1889[2][0][1].member_1), type_9(_e1889[2][0][2].member, _e1889[2][0][2].member_1));
                        let _e2036 = local_36[0u].member;
                        let _e2038 = local_36[0u].member_1;
                        let _e2041 = local_37[1u].member;
                        let _e2043 = local_37[1u].member_1;
                        let _e2044 = function_10(_e2036, _e2038, _e2041, _e2043);
                        let _e2049 = local_36[1u].member;
                        let _e2051 = local_36[1u].member_1;
                        let _e2054 = local_37[0u].member;
                        let _e2056 = local_37[0u].member_1;
                        let _e2057 = function_10(_e2049, _e2051, _e2054, _e2056);
                        let _e2063 = ((_e2044.member - _e2057.member) - select(0u, 1u, (_e2044.member_1 < _e2057.member_1)));
                        let _e2064 = (_e2044.member_1 - _e2057.member_1);
                        local_34 = array<type_9, 3>(type_9(_e1889[1][1][0].member, _e1889[1][1][0].member_1), type_9(_e1889[1][1][1].member, _e1889[1][1][1].member_1), type_9(_e1889[1][1][2].member, _e1889[1][1][2].member_1));
                        local_35 = array<type_9, 3>(type_9(_e1889[2][1][0].member, _e1889[2][1][0].member_1), type_9(_e1889[2][1][1].member, _e1889[2][1][1].member_1), type_9(_e1889[2][1][2].member, _e1889[2][1][2].member_1));
                        let _e2097 = local_34[1u].member;
                        let _e2099 = local_34[1u].member_1;
                        let _e2102 = local_35[2u].member;
                        let _e2104 = local_35[2u].member_1;
                        let _e2105 = function_10(_e2097, _e2099, _e2102, _e2104);
                        let _e2110 = local_34[2u].member;
                        let _e2112 = local_34[2u].member_1;
                        let _e2115 = local_35[1u].member;
                        let _e2117 = local_35[1u].member_1;
                        let _e2118 = function_10(_e2110, _e2112, _e2115, _e2117);
                        let _e2124 = ((_e2105.member - _e2118.member) - select(0u, 1u, (_e2105.member_1 < _e2118.member_1)));
                        let _e2125 = (_e2105.member_1 - _e2118.member_1);
                        local_32 = array<type_9, 3>(type_9(_e1889[1][1][0].member, _e1889[1][1][0].member_1), type_9(_e1889[1][1][1].member, _e1889[1][1][1].member_1), type_9(_e1889[1][1][2].member, _e1889[1][1][2].member_1));
                        local_33 = array<type_9, 3>(type_9(_e1889[2][1][0].member, _e1889[2][1][0].member_1), type_9(_e1889[2][1][1].member, _e1889[2][1][1].member_1), type_9(_e1889[2][1][2].member, _e1889[2][1][2].member_1));
                        let _e2154 = local_32[2u].member;
                        let _e2156 = local_32[2u].member_1;
                        let _e2159 = local_33[0u].member;
                        let _e2161 = local_33[0u].member_1;
                        let _e2162 = function_10(_e2154, _e2156, _e2159, _e2161);
                        let _e2167 = local_32[0u].member;
                        let _e2169 = local_32[0u].member_1;
                        let _e2172 = local_33[2u].member;
                        let _e2174 = local_33[2u].member_1;
                        let _e2175 = function_10(_e2167, _e2169, _e2172, _e2174);
                        let _e2181 = ((_e2162.member - _e2175.member) - select(0u, 1u, (_e2162.member_1 < _e2175.member_1)));
                        let _e2182 = (_e2162.member_1 - _e2175.member_1);
                        local_30 = array<type_9, 3>(type_9(_e1889[1][1][0].member, _e1889[1][1][0].member_1), type_9(_e1889[1][1][1].member, _e1889[1][1][1].member_1), type_9(_e1889[1][1][2].member, _e1889[1][1][2].member_1));
                        local_31 = array<type_9, 3>(type_9(_e1889[2][1][0].member, _e1889[2][1][0].member_1), type_9(_e1889[2][1][1].member, _e1889[2][1][1].member_1), type_9(_e1889[2][1][2].member, _e1889[2][1][2].member_1));
                        let _e2211 = local_30[0u].member;
                        let _e2213 = local_30[0u].member_1;
                        let _e2216 = local_31[1u].member;
                        let _e2218 = local_31[1u].member_1;
                        let _e2219 = function_10(_e2211, _e2213, _e2216, _e2218);
                        let _e2224 = local_30[1u].member;
                        let _e2226 = local_30[1u].member_1;
                        let _e2229 = local_31[0u].member;
                        let _e2231 = local_31[0u].member_1;
                        let _e2232 = function_10(_e2224, _e2226, _e2229, _e2231);
                        let _e2238 = ((_e2219.member - _e2232.member) - select(0u, 1u, (_e2219.member_1 < _e2232.member_1)));
                        let _e2239 = (_e2219.member_1 - _e2232.member_1);
                        local_28 = array<type_9, 3>(type_9(_e1889[1][0][0].member, _e1889[1][0][0].member_1), type_9(_e1889[1][0][1].member, _e1889[1][0][1].member_1), type_9(_e1889[1][0][2].member, _e1889[1][0][2].member_1));
                        local_29 = array<type_9, 3>(type_9(_e1889[2][1][0].member, _e1889[2][1][0].member_1), type_9(_e1889[2][1][1].member, _e1889[2][1][1].member_1), type_9(_e1889[2][1][2].member, _e1889[2][1][2].member_1));
                        let _e2272 = local_28[1u].member;
                        let _e2274 = local_28[1u].member_1;
                        let _e2277 = local_29[2u].member;
                        let _e2279 = local_29[2u].member_1;
                        let _e2280 = function_10(_e2272, _e2274, _e2277, _e2279);
                        let _e2285 = local_28[2u].member;
                        let _e2287 = local_28[2u].member_1;
                        let _e2290 = local_29[1u].member;
                        let _e2292 = local_29[1u].member_1;
                        let _e2293 = function_10(_e2285, _e2287, _e2290, _e2292);
                        let _e2300 = (_e2280.member_1 - _e2293.member_1);
                        local_26 = array<type_9, 3>(type_9(_e1889[1][0][0].member, _e1889[1][0][0].member_1), type_9(_e1889[1][0][1].member, _e1889[1][0][1].member_1), type_9(_e1889[1][0][2].member, _e1889[1][0][2].member_1));
                        local_27 = array<type_9, 3>(type_9(_e1889[2][1][0].member, _e1889[2][1][0].member_1), type_9(_e1889[2][1][1].member, _e1889[2][1][1].member_1), type_9(_e1889[2][1][2].member, _e1889[2][1][2].member_1));
                        let _e2329 = local_26[2u].member;
                        let _e2331 = local_26[2u].member_1;
                        let _e2334 = local_27[0u].member;
                        let _e2336 = local_27[0u].member_1;
                        let _e2337 = function_10(_e2329, _e2331, _e2334, _e2336);
                        let _e2342 = local_26[0u].member;
                        let _e2344 = local_26[0u].member_1;
                        let _e2347 = local_27[2u].member;
                        let _e2349 = local_27[2u].member_1;
                        let _e2350 = function_10(_e2342, _e2344, _e2347, _e2349);
                        let _e2357 = (_e2337.member_1 - _e2350.member_1);
                        local_24 = array<type_9, 3>(type_9(_e1889[1][0][0].member, _e1889[1][0][0].member_1), type_9(_e1889[1][0][1].member, _e1889[1][0][1].member_1), type_9(_e1889[1][0][2].member, _e1889[1][0][2].member_1));
                        local_25 = array<type_9, 3>(type_9(_e1889[2][1][0].member, _e1889[2][1][0].member_1), type_9(_e1889[2][1][1].member, _e1889[2][1][1].member_1), type_9(_e1889[2][1][2].member, _e1889[2][1][2].member_1));
                        let _e2386 = local_24[0u].member;
                        let _e2388 = local_24[0u].member_1;
                        let _e2391 = local_25[1u].member;
                        let _e2393 = local_25[1u].member_1;
                        let _e2394 = function_10(_e2386, _e2388, _e2391, _e2393);
                        let _e2399 = local_24[1u].member;
                        let _e2401 = local_24[1u].member_1;
                        let _e2404 = local_25[0u].member;
                        let _e2406 = local_25[0u].member_1;
                        let _e2407 = function_10(_e2399, _e2401, _e2404, _e2406);
                        let _e2414 = (_e2394.member_1 - _e2407.member_1);
                        local_22 = array<type_9, 3>(type_9(_e1889[1][1][0].member, _e1889[1][1][0].member_1), type_9(_e1889[1][1][1].member, _e1889[1][1][1].member_1), type_9(_e1889[1][1][2].member, _e1889[1][1][2].member_1));
                        local_23 = array<type_9, 3>(type_9(_e1889[2][0][0].member, _e1889[2][0][0].member_1), type_9(_e1889[2][0][1].member, _e1889[2][0][1].member_1), type_9(_e1889[2][0][2].member, _e1889[2][0][2].member_1));
                        let _e2447 = local_22[1u].member;
                        let _e2449 = local_22[1u].member_1;
                        let _e2452 = local_23[2u].member;
                        let _e2454 = local_23[2u].member_1;
                        let _e2455 = function_10(_e2447, _e2449, _e2452, _e2454);
                        let _e2460 = local_22[2u].member;
                        let _e2462 = local_22[2u].member_1;
                        let _e2465 = local_23[1u].member;
                        let _e2467 = local_23[1u].member_1;
                        let _e2468 = function_10(_e2460, _e2462, _e2465, _e2467);
                        local_20 = array<type_9, 3>(type_9(_e1889[1][1][0].member, _e1889[1][1][0].member_1), type_9(_e1889[1][1][1].member, _e1889[1][1][1].member_1), type_9(_e1889[1][1][2].member, _e1889[1][1][2].member_1));
                        local_21 = array<type_9, 3>(type_9(_e1889[2][0][0].member, _e1889[2][0][0].member_1), type_9(_e1889[2][0][1].member, _e1889[2][0][1].member_1), type_9(_e1889[2][0][2].member, _e1889[2][0][2].member_1));
                        let _e2504 = local_20[2u].member;
                        let _e2506 = local_20[2u].member_1;
                        let _e2509 = local_21[0u].member;
                        let _e2511 = local_21[0u].member_1;
                        let _e2512 = function_10(_e2504, _e2506, _e2509, _e2511);
                        let _e2517 = local_20[0u].member;
                        let _e2519 = local_20[0u].member_1;
                        let _e2522 = local_21[2u].member;
                        let _e2524 = local_21[2u].member_1;
                        let _e2525 = function_10(_e2517, _e2519, _e2522, _e2524);
                        local_18 = array<type_9, 3>(type_9(_e1889[1][1][0].member, _e1889[1][1][0].member_1), type_9(_e1889[1][1][1].member, _e1889[1][1][1].member_1), type_9(_e1889[1][1][2].member, _e1889[1][1][2].member_1));
                        local_19 = array<type_9, 3>(type_9(_e1889[2][0][0].member, _e1889[2][0][0].member_1), type_9(_e1889[2][0][1].member, _e1889[2][0][1].member_1), type_9(_e1889[2][0][2].member, _e1889[2][0][2].member_1));
                        let _e2561 = local_18[0u].member;
                        let _e2563 = local_18[0u].member_1;
                        let _e2566 = local_19[1u].member;
                        let _e2568 = local_19[1u].member_1;
                        let _e2569 = function_10(_e2561, _e2563, _e2566, _e2568);
                        let _e2574 = local_18[1u].member;
                        let _e2576 = local_18[1u].member_1;
                        let _e2579 = local_19[0u].member;
                        let _e2581 = local_19[0u].member_1;
                        let _e2582 = function_10(_e2574, _e2576, _e2579, _e2581);
                        let _e2590 = (_e2300 + (_e2455.member_1 - _e2468.member_1));
                        let _e2594 = ((((_e2280.member - _e2293.member) - select(0u, 1u, (_e2280.member_1 < _e2293.member_1))) + ((_e2455.member - _e2468.member) - select(0u, 1u, (_e2455.member_1 < _e2468.member_1)))) + select(0u, 1u, (_e2590 < _e2300)));
                        let _e2595 = (_e2357 + (_e2512.member_1 - _e2525.member_1));
                        let _e2599 = ((((_e2337.member - _e2350.member) - select(0u, 1u, (_e2337.member_1 < _e2350.member_1))) + ((_e2512.member - _e2525.member) - select(0u, 1u, (_e2512.member_1 < _e2525.member_1)))) + select(0u, 1u, (_e2595 < _e2357)));
                        let _e2600 = (_e2414 + (_e2569.member_1 - _e2582.member_1));
                        let _e2604 = ((((_e2394.member - _e2407.member) - select(0u, 1u, (_e2394.member_1 < _e2407.member_1))) + ((_e2569.member - _e2582.member) - select(0u, 1u, (_e2569.member_1 < _e2582.member_1)))) + select(0u, 1u, (_e2600 < _e2414)));
                        let _e2611 = function_10(_e1889[0][0][0].member, _e1889[0][0][0].member_1, _e1949, _e1950);
                        let _e2618 = function_10(_e1889[0][0][1].member, _e1889[0][0][1].member_1, _e2006, _e2007);
                        let _e2621 = (_e2611.member_1 + _e2618.member_1);
                        let _e2630 = function_10(_e1889[0][0][2].member, _e1889[0][0][2].member_1, _e2063, _e2064);
                        let _e2633 = (_e2621 + _e2630.member_1);
                        let _e2638 = function_13(((((_e2611.member + _e2618.member) + select(0u, 1u, (_e2621 < _e2611.member_1))) + _e2630.member) + select(0u, 1u, (_e2633 < _e2621))), _e2633);
                        let _e2647 = function_10(_e1889[0][1][0].member, _e1889[0][1][0].member_1, _e1949, _e1950);
                        let _e2654 = function_10(_e1889[0][1][1].member, _e1889[0][1][1].member_1, _e2006, _e2007);
                        let _e2657 = (_e2647.member_1 + _e2654.member_1);
                        let _e2666 = function_10(_e1889[0][1][2].member, _e1889[0][1][2].member_1, _e2063, _e2064);
                        let _e2669 = (_e2657 + _e2666.member_1);
                        let _e2680 = function_10(_e1889[0][0][0].member, _e1889[0][0][0].member_1, _e2594, _e2590);
                        let _e2687 = function_10(_e1889[0][0][1].member, _e1889[0][0][1].member_1, _e2599, _e2595);
                        let _e2690 = (_e2680.member_1 + _e2687.member_1);
                        let _e2699 = function_10(_e1889[0][0][2].member, _e1889[0][0][2].member_1, _e2604, _e2600);
                        let _e2702 = (_e2690 + _e2699.member_1);
                        let _e2707 = (_e2669 + _e2702);
                        let _e2711 = ((((((_e2647.member + _e2654.member) + select(0u, 1u, (_e2657 < _e2647.member_1))) + _e2666.member) + select(0u, 1u, (_e2669 < _e2657))) + ((((_e2680.member + _e2687.member) + select(0u, 1u, (_e2690 < _e2680.member_1))) + _e2699.member) + select(0u, 1u, (_e2702 < _e2690)))) + select(0u, 1u, (_e2707 < _e2669)));
                        let _e2718 = function_10(_e1889[0][0][0].member, _e1889[0][0][0].member_1, _e2124, _e2125);
                        let _e2725 = function_10(_e1889[0][0][1].member, _e1889[0][0][1].member_1, _e2181, _e2182);
                        let _e2728 = (_e2718.member_1 + _e2725.member_1);
                        let _e2737 = function_10(_e1889[0][0][2].member, _e1889[0][0][2].member_1, _e2238, _e2239);
                        let _e2740 = (_e2728 + _e2737.member_1);
                        let _e2751 = function_10(_e1889[0][1][0].member, _e1889[0][1][0].member_1, _e2594, _e2590);
                        let _e2758 = function_10(_e1889[0][1][1].member, _e1889[0][1][1].member_1, _e2599, _e2595);
                        let _e2761 = (_e2751.member_1 + _e2758.member_1);
                        let _e2770 = function_10(_e1889[0][1][2].member, _e1889[0][1][2].member_1, _e2604, _e2600);
                        let _e2773 = (_e2761 + _e2770.member_1);
                        let _e2778 = (_e2740 + _e2773);
                        let _e2782 = ((((((_e2718.member + _e2725.member) + select(0u, 1u, (_e2728 < _e2718.member_1))) + _e2737.member) + select(0u, 1u, (_e2740 < _e2728))) + ((((_e2751.member + _e2758.member) + select(0u, 1u, (_e2761 < _e2751.member_1))) + _e2770.member) + select(0u, 1u, (_e2773 < _e2761)))) + select(0u, 1u, (_e2778 < _e2740)));
                        let _e2789 = function_10(_e1889[0][1][0].member, _e1889[0][1][0].member_1, _e2124, _e2125);
                        let _e2796 = function_10(_e1889[0][1][1].member, _e1889[0][1][1].member_1, _e2181, _e2182);
                        let _e2799 = (_e2789.member_1 + _e2796.member_1);
                        let _e2808 = function_10(_e1889[0][1][2].member, _e1889[0][1][2].member_1, _e2238, _e2239);
                        let _e2811 = (_e2799 + _e2808.member_1);
                        let _e2816 = function_13(((((_e2789.member + _e2796.member) + select(0u, 1u, (_e2799 < _e2789.member_1))) + _e2808.member) + select(0u, 1u, (_e2811 < _e2799))), _e2811);
                        phi_5088_ = type_9(0u, 128u);
                        phi_5091_ = array<type_9, 4>(_e2638, type_9(_e2711, _e2707), type_9(_e2782, _e2778), _e2816);
                        phi_5095_ = 0u;
                        phi_5097_ = 0u;
                        loop {
                            let _e2823 = phi_5088_;
                            let _e2825 = phi_5091_;
                            let _e2827 = phi_5095_;
                            let _e2829 = phi_5097_;
                            local_56 = _e2825;
                            local_57 = _e2825;
                            local_58 = _e2825;
                            let _e2832 = (_e2823.member < _e2823.member_1);
                            if (bitcast<i32>(select(0u, 1u, _e2832)) != 0i) {
                                let _e2844 = (31u - _e2827);
                                let _e2847 = (_e2829 << bitcast<u32>((_e2844 & 31u)));
                                let _e2852 = (_e2847 > _e1312);
                                if _e2852 {
                                    phi_7805_ = array<type_9, 4>();
                                    phi_7807_ = u32();
                                    phi_7808_ = u32();
                                    phi_7809_ = bool();
                                    phi_7810_ = bool();
                                    phi_7811_ = u32();
                                    phi_7812_ = u32();
                                    phi_7813_ = false;
                                    phi_7814_ = false;
                                    phi_7815_ = false;
                                } else {
                                    if (((_e2829 + 1u) << bitcast<u32>((_e2844 & 31u))) < _e1310) {
                                        phi_5317_ = true;
                                    } else {
                                        let _e2858 = function_12(128u);
                                        let _e2863 = ((_e2825[0].member >> bitcast<u32>(31i)) != 0u);
                                        let _e2891 = function_12(128u);
                                        let _e2896 = ((_e2825[1].member >> bitcast<u32>(31i)) != 0u);
                                        let _e2925 = function_12(128u);
                                        let _e2930 = ((_e2825[2].member >> bitcast<u32>(31i)) != 0u);
                                        let _e2959 = function_12(128u);
                                        let _e2964 = ((_e2825[3].member >> bitcast<u32>(31i)) != 0u);
                                        phi_5317_ = ((((select(0u, select(1u, 2u, ((_e2825[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2858.member - select(_e2825[0].member, (~(_e2825[0].member) + select(0u, 1u, (_e2825[0].member_1 == 0u))), _e2863)) - select(0u, 1u, (_e2858.member_1 < select(_e2825[0].member_1, (~(_e2825[0].member_1) + 1u), _e2863)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e2825[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e2891.member - select(_e2825[1].member, (~(_e2825[1].member) + select(0u, 1u, (_e2825[1].member_1 == 0u))), _e2896)) - select(0u, 1u, (_e2891.member_1 < select(_e2825[1].member_1, (~(_e2825[1].member_1) + 1u), _e2896)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2825[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e2925.member - select(_e2825[2].member, (~(_e2825[2].member) + select(0u, 1u, (_e2825[2].member_1 == 0u))), _e2930)) - select(0u, 1u, (_e2925.member_1 < select(_e2825[2].member_1, (~(_e2825[2].member_1) + 1u), _e2930)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2825[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e2959.member - select(_e2825[3].member, (~(_e2825[3].member) + select(0u, 1u, (_e2825[3].member_1 == 0u))), _e2964)) - select(0u, 1u, (_e2959.member_1 < select(_e2825[3].member_1, (~(_e2825[3].member_1) + 1u), _e2964)))) >> bitcast<u32>(31i)) != 0u))) != 0u);
                                    }
                                    let _e2991 = phi_5317_;
                                    if _e2991 {
                                        phi_7486_ = _e2825;
                                        phi_7488_ = _e2991;
                                        phi_7489_ = _e2827;
                                        phi_7490_ = _e2829;
                                        phi_7491_ = bool();
                                        phi_7492_ = bool();
                                        phi_7493_ = u32();
                                        phi_7494_ = u32();
                                        phi_7495_ = true;
                                    } else {
                                        let _e2992 = (_e2827 == 31u);
                                        if select(select(select((_e2827 == 14u), true, (_e2827 == 8u)), true, (_e2827 == 3u)), true, _e2992) {
                                            let _e3003 = function_12(128u);
                                            let _e3008 = ((_e2825[0].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3036 = function_12(128u);
                                            let _e3041 = ((_e2825[3].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3066 = ((select(0u, select(1u, 2u, ((_e2825[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3003.member - select(_e2825[0].member, (~(_e2825[0].member) + select(0u, 1u, (_e2825[0].member_1 == 0u))), _e3008)) - select(0u, 1u, (_e3003.member_1 < select(_e2825[0].member_1, (~(_e2825[0].member_1) + 1u), _e3008)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e2825[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e3036.member - select(_e2825[3].member, (~(_e2825[3].member) + select(0u, 1u, (_e2825[3].member_1 == 0u))), _e3041)) - select(0u, 1u, (_e3036.member_1 < select(_e2825[3].member_1, (~(_e2825[3].member_1) + 1u), _e3041)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                            let _e3068 = select(false, !(_e3066), _e2992);
                                            if _e3068 {
                                                phi_5446_ = select((bitcast<u32>(31i) - firstLeadingBit(_e1314)), 32u, (_e1314 == 0u));
                                            } else {
                                                phi_5446_ = _e2827;
                                            }
                                            let _e3075 = phi_5446_;
                                            let _e3097 = ((_e1889[0][1][0].member - _e1889[0][0][0].member) - select(0u, 1u, (_e1889[0][1][0].member_1 < _e1889[0][0][0].member_1)));
                                            let _e3098 = (_e1889[0][1][0].member_1 - _e1889[0][0][0].member_1);
                                            let _e3110 = ((_e1889[0][1][1].member - _e1889[0][0][1].member) - select(0u, 1u, (_e1889[0][1][1].member_1 < _e1889[0][0][1].member_1)));
                                            let _e3111 = (_e1889[0][1][1].member_1 - _e1889[0][0][1].member_1);
                                            let _e3123 = ((_e1889[0][1][2].member - _e1889[0][0][2].member) - select(0u, 1u, (_e1889[0][1][2].member_1 < _e1889[0][0][2].member_1)));
                                            let _e3124 = (_e1889[0][1][2].member_1 - _e1889[0][0][2].member_1);
                                            let _e3127 = ((_e3097 >> bitcast<u32>(31i)) != 0u);
                                            let _e3134 = select(_e3097, (~(_e3097) + select(0u, 1u, (_e3098 == 0u))), _e3127);
                                            let _e3135 = select(_e3098, (~(_e3098) + 1u), _e3127);
                                            let _e3138 = ((_e3110 >> bitcast<u32>(31i)) != 0u);
                                            let _e3145 = select(_e3110, (~(_e3110) + select(0u, 1u, (_e3111 == 0u))), _e3138);
                                            let _e3146 = select(_e3111, (~(_e3111) + 1u), _e3138);
                                            let _e3153 = ((((_e3145 - _e3134) - select(0u, 1u, (_e3146 < _e3135))) >> bitcast<u32>(31i)) != 0u);
                                            let _e3154 = select(_e3145, _e3134, _e3153);
                                            let _e3155 = select(_e3146, _e3135, _e3153);
                                            let _e3158 = ((_e3123 >> bitcast<u32>(31i)) != 0u);
                                            let _e3165 = select(_e3123, (~(_e3123) + select(0u, 1u, (_e3124 == 0u))), _e3158);
                                            let _e3166 = select(_e3124, (~(_e3124) + 1u), _e3158);
                                            let _e3173 = ((((_e3165 - _e3154) - select(0u, 1u, (_e3166 < _e3155))) >> bitcast<u32>(31i)) != 0u);
                                            let _e3175 = select(_e3166, _e3155, _e3173);
                                            let _e3176 = function_12(4u);
                                            let _e3179 = (_e3175 + _e3176.member_1);
                                            let _e3183 = ((select(_e3165, _e3154, _e3173) + _e3176.member) + select(0u, 1u, (_e3179 < _e3175)));
                                            let _e3198 = ((_e3179 >> bitcast<u32>((_e3075 & 31u))) | ((_e3183 << bitcast<u32>(((31u - _e3075) & 31u))) << bitcast<u32>(1i)));
                                            let _e3199 = function_12(4u);
                                            let _e3202 = (_e3198 + _e3199.member_1);
                                            let _e3220 = ((_e1889[1][1][0].member - _e1889[1][0][0].member) - select(0u, 1u, (_e1889[1][1][0].member_1 < _e1889[1][0][0].member_1)));
                                            let _e3221 = (_e1889[1][1][0].member_1 - _e1889[1][0][0].member_1);
                                            let _e3233 = ((_e1889[1][1][1].member - _e1889[1][0][1].member) - select(0u, 1u, (_e1889[1][1][1].member_1 < _e1889[1][0][1].member_1)));
                                            let _e3234 = (_e1889[1][1][1].member_1 - _e1889[1][0][1].member_1);
                                            let _e3246 = ((_e1889[1][1][2].member - _e1889[1][0][2].member) - select(0u, 1u, (_e1889[1][1][2].member_1 < _e1889[1][0][2].member_1)));
                                            let _e3247 = (_e1889[1][1][2].member_1 - _e1889[1][0][2].member_1);
                                            let _e3250 = ((_e3220 >> bitcast<u32>(31i)) != 0u);
                                            let _e3257 = select(_e3220, (~(_e3220) + select(0u, 1u, (_e3221 == 0u))), _e3250);
                                            let _e3258 = select(_e3221, (~(_e3221) + 1u), _e3250);
                                            let _e3261 = ((_e3233 >> bitcast<u32>(31i)) != 0u);
                                            let _e3268 = select(_e3233, (~(_e3233) + select(0u, 1u, (_e3234 == 0u))), _e3261);
                                            let _e3269 = select(_e3234, (~(_e3234) + 1u), _e3261);
                                            let _e3276 = ((((_e3268 - _e3257) - select(0u, 1u, (_e3269 < _e3258))) >> bitcast<u32>(31i)) != 0u);
                                            let _e3277 = select(_e3268, _e3257, _e3276);
                                            let _e3278 = select(_e3269, _e3258, _e3276);
                                            let _e3281 = ((_e3246 >> bitcast<u32>(31i)) != 0u);
                                            let _e3288 = select(_e3246, (~(_e3246) + select(0u, 1u, (_e3247 == 0u))), _e3281);
                                            let _e3289 = select(_e3247, (~(_e3247) + 1u), _e3281);
                                            let _e3296 = ((((_e3288 - _e3277) - select(0u, 1u, (_e3289 < _e3278))) >> bitcast<u32>(31i)) != 0u);
                                            let _e3298 = select(_e3289, _e3278, _e3296);
                                            let _e3299 = function_12(4u);
                                            let _e3302 = (_e3298 + _e3299.member_1);
                                            let _e3306 = ((select(_e3288, _e3277, _e3296) + _e3299.member) + select(0u, 1u, (_e3302 < _e3298)));
                                            let _e3321 = ((_e3302 >> bitcast<u32>((_e3075 & 31u))) | ((_e3306 << bitcast<u32>(((31u - _e3075) & 31u))) << bitcast<u32>(1i)));
                                            let _e3322 = function_12(4u);
                                            let _e3325 = (_e3321 + _e3322.member_1);
                                            let _e3343 = ((_e1889[2][1][0].member - _e1889[2][0][0].member) - select(0u, 1u, (_e1889[2][1][0].member_1 < _e1889[2][0][0].member_1)));
                                            let _e3344 = (_e1889[2][1][0].member_1 - _e1889[2][0][0].member_1);
                                            let _e3356 = ((_e1889[2][1][1].member - _e1889[2][0][1].member) - select(0u, 1u, (_e1889[2][1][1].member_1 < _e1889[2][0][1].member_1)));
                                            let _e3357 = (_e1889[2][1][1].member_1 - _e1889[2][0][1].member_1);
                                            let _e3369 = ((_e1889[2][1][2].member - _e1889[2][0][2].member) - select(0u, 1u, (_e1889[2][1][2].member_1 < _e1889[2][0][2].member_1)));
                                            let _e3370 = (_e1889[2][1][2].member_1 - _e1889[2][0][2].member_1);
                                            let _e3373 = ((_e3343 >> bitcast<u32>(31i)) != 0u);
                                            let _e3380 = select(_e3343, (~(_e3343) + select(0u, 1u, (_e3344 == 0u))), _e3373);
                                            let _e3381 = select(_e3344, (~(_e3344) + 1u), _e3373);
                                            let _e3384 = ((_e3356 >> bitcast<u32>(31i)) != 0u);
                                            let _e3391 = select(_e3356, (~(_e3356) + select(0u, 1u, (_e3357 == 0u))), _e3384);
                                            let _e3392 = select(_e3357, (~(_e3357) + 1u), _e3384);
                                            let _e3399 = ((((_e3391 - _e3380) - select(0u, 1u, (_e3392 < _e3381))) >> bitcast<u32>(31i)) != 0u);
                                            let _e3400 = select(_e3391, _e3380, _e3399);
                                            let _e3401 = select(_e3392, _e3381, _e3399);
                                            let _e3404 = ((_e3369 >> bitcast<u32>(31i)) != 0u);
                                            let _e3411 = select(_e3369, (~(_e3369) + select(0u, 1u, (_e3370 == 0u))), _e3404);
                                            let _e3412 = select(_e3370, (~(_e3370) + 1u), _e3404);
                                            let _e3419 = ((((_e3411 - _e3400) - select(0u, 1u, (_e3412 < _e3401))) >> bitcast<u32>(31i)) != 0u);
                                            let _e3421 = select(_e3412, _e3401, _e3419);
                                            let _e3422 = function_12(4u);
                                            let _e3425 = (_e3421 + _e3422.member_1);
                                            let _e3429 = ((select(_e3411, _e3400, _e3419) + _e3422.member) + select(0u, 1u, (_e3425 < _e3421)));
                                            let _e3444 = ((_e3425 >> bitcast<u32>((_e3075 & 31u))) | ((_e3429 << bitcast<u32>(((31u - _e3075) & 31u))) << bitcast<u32>(1i)));
                                            let _e3445 = function_12(4u);
                                            let _e3448 = (_e3444 + _e3445.member_1);
                                            local_17[0u].member = ((bitcast<u32>((bitcast<i32>(_e3183) >> bitcast<u32>((_e3075 & 31u)))) + _e3199.member) + select(0u, 1u, (_e3202 < _e3198)));
                                            local_17[0u].member_1 = _e3202;
                                            local_17[1u].member = ((bitcast<u32>((bitcast<i32>(_e3306) >> bitcast<u32>((_e3075 & 31u)))) + _e3322.member) + select(0u, 1u, (_e3325 < _e3321)));
                                            local_17[1u].member_1 = _e3325;
                                            local_17[2u].member = ((bitcast<u32>((bitcast<i32>(_e3429) >> bitcast<u32>((_e3075 & 31u)))) + _e3445.member) + select(0u, 1u, (_e3448 < _e3444)));
                                            local_17[2u].member_1 = _e3448;
                                            let _e3478 = function_6(((_e1889[0][1][0].member - _e1889[0][0][0].member) - select(0u, 1u, (_e1889[0][1][0].member_1 < _e1889[0][0][0].member_1))), (_e1889[0][1][0].member_1 - _e1889[0][0][0].member_1), _e2847);
                                            let _e3481 = (_e1889[0][0][0].member_1 + _e3478.member_1);
                                            let _e3485 = ((_e1889[0][0][0].member + _e3478.member) + select(0u, 1u, (_e3481 < _e1889[0][0][0].member_1)));
                                            let _e3499 = function_6(((_e1889[0][1][1].member - _e1889[0][0][1].member) - select(0u, 1u, (_e1889[0][1][1].member_1 < _e1889[0][0][1].member_1))), (_e1889[0][1][1].member_1 - _e1889[0][0][1].member_1), _e2847);
                                            let _e3502 = (_e1889[0][0][1].member_1 + _e3499.member_1);
                                            let _e3506 = ((_e1889[0][0][1].member + _e3499.member) + select(0u, 1u, (_e3502 < _e1889[0][0][1].member_1)));
                                            let _e3520 = function_6(((_e1889[0][1][2].member - _e1889[0][0][2].member) - select(0u, 1u, (_e1889[0][1][2].member_1 < _e1889[0][0][2].member_1))), (_e1889[0][1][2].member_1 - _e1889[0][0][2].member_1), _e2847);
                                            let _e3523 = (_e1889[0][0][2].member_1 + _e3520.member_1);
                                            let _e3527 = ((_e1889[0][0][2].member + _e3520.member) + select(0u, 1u, (_e3523 < _e1889[0][0][2].member_1)));
                                            let _e3543 = function_6(((_e1889[1][1][0].member - _e1889[1][0][0].member) - select(0u, 1u, (_e1889[1][1][0].member_1 < _e1889[1][0][0].member_1))), (_e1889[1][1][0].member_1 - _e1889[1][0][0].member_1), _e2847);
                                            let _e3546 = (_e1889[1][0][0].member_1 + _e3543.member_1);
                                            let _e3550 = ((_e1889[1][0][0].member + _e3543.member) + select(0u, 1u, (_e3546 < _e1889[1][0][0].member_1)));
                                            let _e3564 = function_6(((_e1889[1][1][1].member - _e1889[1][0][1].member) - select(0u, 1u, (_e1889[1][1][1].member_1 < _e1889[1][0][1].member_1))), (_e1889[1][1][1].member_1 - _e1889[1][0][1].member_1), _e2847);
                                            let _e3567 = (_e1889[1][0][1].member_1 + _e3564.member_1);
                                            let _e3571 = ((_e1889[1][0][1].member + _e3564.member) + select(0u, 1u, (_e3567 < _e1889[1][0][1].member_1)));
                                            let _e3585 = function_6(((_e1889[1][1][2].member - _e1889[1][0][2].member) - select(0u, 1u, (_e1889[1][1][2].member_1 < _e1889[1][0][2].member_1))), (_e1889[1][1][2].member_1 - _e1889[1][0][2].member_1), _e2847);
                                            let _e3588 = (_e1889[1][0][2].member_1 + _e3585.member_1);
                                            let _e3592 = ((_e1889[1][0][2].member + _e3585.member) + select(0u, 1u, (_e3588 < _e1889[1][0][2].member_1)));
                                            let _e3608 = function_6(((_e1889[2][1][0].member - _e1889[2][0][0].member) - select(0u, 1u, (_e1889[2][1][0].member_1 < _e1889[2][0][0].member_1))), (_e1889[2][1][0].member_1 - _e1889[2][0][0].member_1), _e2847);
                                            let _e3611 = (_e1889[2][0][0].member_1 + _e3608.member_1);
                                            let _e3615 = ((_e1889[2][0][0].member + _e3608.member) + select(0u, 1u, (_e3611 < _e1889[2][0][0].member_1)));
                                            let _e3629 = function_6(((_e1889[2][1][1].member - _e1889[2][0][1].member) - select(0u, 1u, (_e1889[2][1][1].member_1 < _e1889[2][0][1].member_1))), (_e1889[2][1][1].member_1 - _e1889[2][0][1].member_1), _e2847);
                                            let _e3632 = (_e1889[2][0][1].member_1 + _e3629.member_1);
                                            let _e3636 = ((_e1889[2][0][1].member + _e3629.member) + select(0u, 1u, (_e3632 < _e1889[2][0][1].member_1)));
                                            let _e3650 = function_6(((_e1889[2][1][2].member - _e1889[2][0][2].member) - select(0u, 1u, (_e1889[2][1][2].member_1 < _e1889[2][0][2].member_1))), (_e1889[2][1][2].member_1 - _e1889[2][0][2].member_1), _e2847);
                                            let _e3653 = (_e1889[2][0][2].member_1 + _e3650.member_1);
                                            let _e3657 = ((_e1889[2][0][2].member + _e3650.member) + select(0u, 1u, (_e3653 < _e1889[2][0][2].member_1)));
                                            local_15 = array<type_9, 3>(type_9(_e3550, _e3546), type_9(_e3571, _e3567), type_9(_e3592, _e3588));
                                            local_16 = array<type_9, 3>(type_9(_e3615, _e3611), type_9(_e3636, _e3632), type_9(_e3657, _e3653));
                                            let _e3668 = local_15[1u].member;
                                            let _e3670 = local_15[1u].member_1;
                                            let _e3673 = local_16[2u].member;
                                            let _e3675 = local_16[2u].member_1;
                                            let _e3676 = function_10(_e3668, _e3670, _e3673, _e3675);
                                            let _e3681 = local_15[2u].member;
                                            let _e3683 = local_15[2u].member_1;
                                            let _e3686 = local_16[1u].member;
                                            let _e3688 = local_16[1u].member_1;
                                            let _e3689 = function_10(_e3681, _e3683, _e3686, _e3688);
                                            let _e3695 = ((_e3676.member - _e3689.member) - select(0u, 1u, (_e3676.member_1 < _e3689.member_1)));
                                            let _e3696 = (_e3676.member_1 - _e3689.member_1);
                                            local_13 = array<type_9, 3>(type_9(_e3550, _e3546), type_9(_e3571, _e3567), type_9(_e3592, _e3588));
                                            local_14 = array<type_9, 3>(type_9(_e3615, _e3611), type_9(_e3636, _e3632), type_9(_e3657, _e3653));
                                            let _e3707 = local_13[2u].member;
                                            let _e3709 = local_13[2u].member_1;
                                            let _e3712 = local_14[0u].member;
                                            let _e3714 = local_14[0u].member_1;
                                            let _e3715 = function_10(_e3707, _e3709, _e3712, _e3714);
                                            let _e3720 = local_13[0u].member;
                                            let _e3722 = local_13[0u].member_1;
                                            let _e3725 = local_14[2u].member;
                                            let _e3727 = local_14[2u].member_1;
                                            let _e3728 = function_10(_e3720, _e3722, _e3725, _e3727);
                                            let _e3734 = ((_e3715.member - _e3728.member) - select(0u, 1u, (_e3715.member_1 < _e3728.member_1)));
                                            let _e3735 = (_e3715.member_1 - _e3728.member_1);
                                            local_11 = array<type_9, 3>(type_9(_e3550, _e3546), type_9(_e3571, _e3567), type_9(_e3592, _e3588));
                                            local_12 = array<type_9, 3>(type_9(_e3615, _e3611), type_9(_e3636, _e3632), type_9(_e3657, _e3653));
                                            let _e3746 = local_11[0u].member;
                                            let _e3748 = local_11[0u].member_1;
                                            let _e3751 = local_12[1u].member;
                                            let _e3753 = local_12[1u].member_1;
                                            let _e3754 = function_10(_e3746, _e3748, _e3751, _e3753);
                                            let _e3759 = local_11[1u].member;
                                            let _e3761 = local_11[1u].member_1;
                                            let _e3764 = local_12[0u].member;
                                            let _e3766 = local_12[0u].member_1;
                                            let _e3767 = function_10(_e3759, _e3761, _e3764, _e3766);
                                            let _e3773 = ((_e3754.member - _e3767.member) - select(0u, 1u, (_e3754.member_1 < _e3767.member_1)));
                                            let _e3774 = (_e3754.member_1 - _e3767.member_1);
                                            let _e3777 = ((_e3695 >> bitcast<u32>(31i)) != 0u);
                                            let _e3784 = select(_e3695, (~(_e3695) + select(0u, 1u, (_e3696 == 0u))), _e3777);
                                            let _e3785 = select(_e3696, (~(_e3696) + 1u), _e3777);
                                            let _e3788 = ((_e3734 >> bitcast<u32>(31i)) != 0u);
                                            let _e3795 = select(_e3734, (~(_e3734) + select(0u, 1u, (_e3735 == 0u))), _e3788);
                                            let _e3796 = select(_e3735, (~(_e3735) + 1u), _e3788);
                                            let _e3799 = ((_e3773 >> bitcast<u32>(31i)) != 0u);
                                            let _e3806 = select(_e3773, (~(_e3773) + select(0u, 1u, (_e3774 == 0u))), _e3799);
                                            let _e3807 = select(_e3774, (~(_e3774) + 1u), _e3799);
                                            let _e3832 = select(0i, select(2i, 1i, ((((_e3806 - _e3795) - select(0u, 1u, (_e3807 < _e3796))) >> bitcast<u32>(31i)) != 0u)), select(true, select(true, false, ((((_e3806 - _e3784) - select(0u, 1u, (_e3807 < _e3785))) >> bitcast<u32>(31i)) != 0u)), ((((_e3795 - _e3784) - select(0u, 1u, (_e3796 < _e3785))) >> bitcast<u32>(31i)) != 0u)));
                                            switch _e3832 {
                                                case 0: {
                                                    phi_6595_ = array<type_9, 2>(type_9(_e3506, _e3502), type_9(_e3527, _e3523));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6595_ = array<type_9, 2>(type_9(_e3527, _e3523), type_9(_e3485, _e3481));
                                                    break;
                                                }
                                                default: {
                                                    phi_6595_ = array<type_9, 2>(type_9(_e3485, _e3481), type_9(_e3506, _e3502));
                                                    break;
                                                }
                                            }
                                            let _e3843 = phi_6595_;
                                            switch _e3832 {
                                                case 0: {
                                                    phi_6624_ = array<type_9, 2>(type_9(_e3571, _e3567), type_9(_e3592, _e3588));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6624_ = array<type_9, 2>(type_9(_e3592, _e3588), type_9(_e3550, _e3546));
                                                    break;
                                                }
                                                default: {
                                                    phi_6624_ = array<type_9, 2>(type_9(_e3550, _e3546), type_9(_e3571, _e3567));
                                                    break;
                                                }
                                            }
                                            let _e3854 = phi_6624_;
                                            switch _e3832 {
                                                case 0: {
                                                    phi_6653_ = array<type_9, 2>(type_9(_e3636, _e3632), type_9(_e3657, _e3653));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6653_ = array<type_9, 2>(type_9(_e3657, _e3653), type_9(_e3615, _e3611));
                                                    break;
                                                }
                                                default: {
                                                    phi_6653_ = array<type_9, 2>(type_9(_e3615, _e3611), type_9(_e3636, _e3632));
                                                    break;
                                                }
                                            }
                                            let _e3865 = phi_6653_;
                                            switch _e3832 {
                                                case 0: {
                                                    phi_6667_ = type_9(_e3695, _e3696);
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6667_ = type_9(_e3734, _e3735);
                                                    break;
                                                }
                                                default: {
                                                    phi_6667_ = type_9(_e3773, _e3774);
                                                    break;
                                                }
                                            }
                                            let _e3870 = phi_6667_;
                                            let _e3873 = local_17[1u].member;
                                            let _e3875 = local_17[1u].member_1;
                                            let _e3878 = local_17[2u].member;
                                            let _e3880 = local_17[2u].member_1;
                                            let _e3881 = (_e3875 + _e3880);
                                            let _e3885 = ((_e3873 + _e3878) + select(0u, 1u, (_e3881 < _e3875)));
                                            let _e3896 = ((_e3881 >> bitcast<u32>(1u)) | ((_e3885 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e3897 = function_12(17u);
                                            let _e3900 = (_e3896 + _e3897.member_1);
                                            let _e3904 = ((bitcast<u32>((bitcast<i32>(_e3885) >> bitcast<u32>(1u))) + _e3897.member) + select(0u, 1u, (_e3900 < _e3896)));
                                            let _e3907 = local_17[0u].member;
                                            let _e3909 = local_17[0u].member_1;
                                            let _e3912 = local_17[2u].member;
                                            let _e3914 = local_17[2u].member_1;
                                            let _e3915 = (_e3909 + _e3914);
                                            let _e3919 = ((_e3907 + _e3912) + select(0u, 1u, (_e3915 < _e3909)));
                                            let _e3930 = ((_e3915 >> bitcast<u32>(1u)) | ((_e3919 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e3931 = function_12(17u);
                                            let _e3934 = (_e3930 + _e3931.member_1);
                                            let _e3938 = ((bitcast<u32>((bitcast<i32>(_e3919) >> bitcast<u32>(1u))) + _e3931.member) + select(0u, 1u, (_e3934 < _e3930)));
                                            let _e3941 = local_17[0u].member;
                                            let _e3943 = local_17[0u].member_1;
                                            let _e3946 = local_17[1u].member;
                                            let _e3948 = local_17[1u].member_1;
                                            let _e3949 = (_e3943 + _e3948);
                                            let _e3953 = ((_e3941 + _e3946) + select(0u, 1u, (_e3949 < _e3943)));
                                            let _e3964 = ((_e3949 >> bitcast<u32>(1u)) | ((_e3953 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e3965 = function_12(17u);
                                            let _e3968 = (_e3964 + _e3965.member_1);
                                            let _e3972 = ((bitcast<u32>((bitcast<i32>(_e3953) >> bitcast<u32>(1u))) + _e3965.member) + select(0u, 1u, (_e3968 < _e3964)));
                                            let _e3977 = ((_e3870.member >> bitcast<u32>(31i)) != 0u);
                                            if ((((_e3904 - select(_e3870.member, (~(_e3870.member) + select(0u, 1u, (_e3870.member_1 == 0u))), _e3977)) - select(0u, 1u, (_e3900 < select(_e3870.member_1, (~(_e3870.member_1) + 1u), _e3977)))) >> bitcast<u32>(31i)) != 0u) {
                                                let _e3998 = ((_e3870.member >> bitcast<u32>(31i)) != 0u);
                                                let _e4008 = select(_e3870.member, (~(_e3870.member) + select(0u, 1u, (_e3870.member_1 == 0u))), _e3998);
                                                let _e4010 = select(_e3870.member_1, (~(_e3870.member_1) + 1u), _e3998);
                                                let _e4011 = function_11(_e3843, _e3865);
                                                let _e4021 = select(_e4011.member, (~(_e4011.member) + select(0u, 1u, (_e4011.member_1 == 0u))), _e3998);
                                                let _e4023 = select(_e4011.member_1, (~(_e4011.member_1) + 1u), _e3998);
                                                let _e4024 = function_11(_e3854, _e3843);
                                                let _e4034 = select(_e4024.member, (~(_e4024.member) + select(0u, 1u, (_e4024.member_1 == 0u))), _e3998);
                                                let _e4036 = select(_e4024.member_1, (~(_e4024.member_1) + 1u), _e3998);
                                                if (_e281.member != 0u) {
                                                    let _e4068 = (_e3900 + _e3934);
                                                    let _e4080 = (_e3900 + _e3968);
                                                    phi_6989_ = type_9(((_e3904 + _e3972) + select(0u, 1u, (_e4080 < _e3900))), _e4080);
                                                    phi_6990_ = type_9(((_e4008 - _e4034) - select(0u, 1u, (_e4010 < _e4036))), (_e4010 - _e4036));
                                                    phi_6991_ = type_9(((_e3904 + _e3938) + select(0u, 1u, (_e4068 < _e3900))), _e4068);
                                                    phi_6992_ = type_9(((_e4008 - _e4021) - select(0u, 1u, (_e4010 < _e4023))), (_e4010 - _e4023));
                                                } else {
                                                    let _e4042 = (_e4010 - _e4023);
                                                    let _e4046 = ((((_e4008 - _e4021) - select(0u, 1u, (_e4010 < _e4023))) - _e4034) - select(0u, 1u, (_e4042 < _e4036)));
                                                    let _e4047 = (_e4042 - _e4036);
                                                    let _e4049 = (_e3900 + _e3934);
                                                    let _e4054 = (_e4049 + _e3968);
                                                    let _e4058 = ((((_e3904 + _e3938) + select(0u, 1u, (_e4049 < _e3900))) + _e3972) + select(0u, 1u, (_e4054 < _e4049)));
                                                    phi_6989_ = type_9(_e4058, _e4054);
                                                    phi_6990_ = type_9(_e4046, _e4047);
                                                    phi_6991_ = type_9(_e4058, _e4054);
                                                    phi_6992_ = type_9(_e4046, _e4047);
                                                }
                                                let _e4087 = phi_6989_;
                                                let _e4089 = phi_6990_;
                                                let _e4091 = phi_6991_;
                                                let _e4093 = phi_6992_;
                                                let _e4094 = function_9(_e4021, _e4023, _e3938, _e3934);
                                                if _e4094 {
                                                    phi_7118_ = u32();
                                                    phi_7119_ = true;
                                                } else {
                                                    let _e4095 = function_9(_e4034, _e4036, _e3972, _e3968);
                                                    if _e4095 {
                                                        phi_7116_ = u32();
                                                        phi_7117_ = true;
                                                    } else {
                                                        let _e4100 = function_9(_e4093.member, _e4093.member_1, _e4091.member, _e4091.member_1);
                                                        if _e4100 {
                                                            phi_7114_ = u32();
                                                            phi_7115_ = true;
                                                        } else {
                                                            let _e4105 = function_9(_e4089.member, _e4089.member_1, _e4087.member, _e4087.member_1);
                                                            if _e4105 {
                                                                phi_7113_ = u32();
                                                            } else {
                                                                let _e4106 = function_8(_e4021, _e4023, _e3938, _e3934);
                                                                if _e4106 {
                                                                    let _e4107 = function_8(_e4034, _e4036, _e3972, _e3968);
                                                                    if _e4107 {
                                                                        let _e4112 = function_8(_e4093.member, _e4093.member_1, _e4091.member, _e4091.member_1);
                                                                        if _e4112 {
                                                                            let _e4117 = function_8(_e4089.member, _e4089.member_1, _e4087.member, _e4087.member_1);
                                                                            phi_7106_ = select(true, false, _e4117);
                                                                        } else {
                                                                            phi_7106_ = true;
                                                                        }
                                                                        let _e4120 = phi_7106_;
                                                                        phi_7107_ = _e4120;
                                                                    } else {
                                                                        phi_7107_ = true;
                                                                    }
                                                                    let _e4122 = phi_7107_;
                                                                    phi_7108_ = _e4122;
                                                                } else {
                                                                    phi_7108_ = true;
                                                                }
                                                                let _e4124 = phi_7108_;
                                                                phi_7113_ = select(0u, 2u, _e4124);
                                                            }
                                                            let _e4127 = phi_7113_;
                                                            phi_7114_ = _e4127;
                                                            phi_7115_ = _e4105;
                                                        }
                                                        let _e4129 = phi_7114_;
                                                        let _e4131 = phi_7115_;
                                                        phi_7116_ = _e4129;
                                                        phi_7117_ = _e4131;
                                                    }
                                                    let _e4133 = phi_7116_;
                                                    let _e4135 = phi_7117_;
                                                    phi_7118_ = _e4133;
                                                    phi_7119_ = _e4135;
                                                }
                                                let _e4137 = phi_7118_;
                                                let _e4139 = phi_7119_;
                                                phi_7124_ = select(_e4137, 1u, _e4139);
                                            } else {
                                                phi_7124_ = 2u;
                                            }
                                            let _e4142 = phi_7124_;
                                            let _e4143 = (_e4142 == 1u);
                                            phi_7136_ = _e4143;
                                            phi_7137_ = _e3066;
                                            phi_7138_ = _e3068;
                                            phi_7139_ = (_e2847 + (1u << bitcast<u32>(((31u - _e3075) & 31u))));
                                            phi_7140_ = _e4142;
                                            phi_7141_ = select(true, _e4143, _e2992);
                                        } else {
                                            phi_7136_ = _e2991;
                                            phi_7137_ = bool();
                                            phi_7138_ = bool();
                                            phi_7139_ = u32();
                                            phi_7140_ = u32();
                                            phi_7141_ = true;
                                        }
                                        let _e4146 = phi_7136_;
                                        let _e4148 = phi_7137_;
                                        let _e4150 = phi_7138_;
                                        let _e4152 = phi_7139_;
                                        let _e4154 = phi_7140_;
                                        let _e4156 = phi_7141_;
                                        if _e4156 {
                                            if _e4146 {
                                                phi_7478_ = _e2825;
                                                phi_7480_ = _e2827;
                                                phi_7481_ = _e2829;
                                            } else {
                                                let _e4165 = (_e2825[0].member_1 + _e2825[1].member_1);
                                                let _e4169 = ((_e2825[0].member + _e2825[1].member) + select(0u, 1u, (_e4165 < _e2825[0].member_1)));
                                                let _e4177 = bitcast<u32>((bitcast<i32>(_e4169) >> bitcast<u32>(1u)));
                                                let _e4180 = ((_e4165 >> bitcast<u32>(1u)) | ((_e4169 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4189 = (_e2825[1].member_1 + _e2825[2].member_1);
                                                let _e4193 = ((_e2825[1].member + _e2825[2].member) + select(0u, 1u, (_e4189 < _e2825[1].member_1)));
                                                let _e4201 = bitcast<u32>((bitcast<i32>(_e4193) >> bitcast<u32>(1u)));
                                                let _e4204 = ((_e4189 >> bitcast<u32>(1u)) | ((_e4193 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4213 = (_e2825[2].member_1 + _e2825[3].member_1);
                                                let _e4217 = ((_e2825[2].member + _e2825[3].member) + select(0u, 1u, (_e4213 < _e2825[2].member_1)));
                                                let _e4225 = bitcast<u32>((bitcast<i32>(_e4217) >> bitcast<u32>(1u)));
                                                let _e4228 = ((_e4213 >> bitcast<u32>(1u)) | ((_e4217 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4229 = (_e4180 + _e4204);
                                                let _e4233 = ((_e4177 + _e4201) + select(0u, 1u, (_e4229 < _e4180)));
                                                let _e4241 = bitcast<u32>((bitcast<i32>(_e4233) >> bitcast<u32>(1u)));
                                                let _e4244 = ((_e4229 >> bitcast<u32>(1u)) | ((_e4233 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4245 = (_e4204 + _e4228);
                                                let _e4249 = ((_e4201 + _e4225) + select(0u, 1u, (_e4245 < _e4204)));
                                                let _e4257 = bitcast<u32>((bitcast<i32>(_e4249) >> bitcast<u32>(1u)));
                                                let _e4260 = ((_e4245 >> bitcast<u32>(1u)) | ((_e4249 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4261 = (_e4244 + _e4260);
                                                let _e4265 = ((_e4241 + _e4257) + select(0u, 1u, (_e4261 < _e4244)));
                                                let _e4273 = bitcast<u32>((bitcast<i32>(_e4265) >> bitcast<u32>(1u)));
                                                let _e4276 = ((_e4261 >> bitcast<u32>(1u)) | ((_e4265 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4277 = (2u * _e2829);
                                                let _e4288 = function_12(128u);
                                                let _e4293 = ((_e2825[0].member >> bitcast<u32>(31i)) != 0u);
                                                let _e4317 = function_12(128u);
                                                let _e4322 = ((_e4177 >> bitcast<u32>(31i)) != 0u);
                                                let _e4344 = function_12(128u);
                                                let _e4349 = ((_e4241 >> bitcast<u32>(31i)) != 0u);
                                                let _e4371 = function_12(128u);
                                                let _e4376 = ((_e4273 >> bitcast<u32>(31i)) != 0u);
                                                if ((((select(0u, select(1u, 2u, ((_e2825[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e4288.member - select(_e2825[0].member, (~(_e2825[0].member) + select(0u, 1u, (_e2825[0].member_1 == 0u))), _e4293)) - select(0u, 1u, (_e4288.member_1 < select(_e2825[0].member_1, (~(_e2825[0].member_1) + 1u), _e4293)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e4177 >> bitcast<u32>(31i)) != 0u)), ((((_e4317.member - select(_e4177, (~(_e4177) + select(0u, 1u, (_e4180 == 0u))), _e4322)) - select(0u, 1u, (_e4317.member_1 < select(_e4180, (~(_e4180) + 1u), _e4322)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e4241 >> bitcast<u32>(31i)) != 0u)), ((((_e4344.member - select(_e4241, (~(_e4241) + select(0u, 1u, (_e4244 == 0u))), _e4349)) - select(0u, 1u, (_e4344.member_1 < select(_e4244, (~(_e4244) + 1u), _e4349)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e4273 >> bitcast<u32>(31i)) != 0u)), ((((_e4371.member - select(_e4273, (~(_e4273) + select(0u, 1u, (_e4276 == 0u))), _e4376)) - select(0u, 1u, (_e4371.member_1 < select(_e4276, (~(_e4276) + 1u), _e4376)))) >> bitcast<u32>(31i)) != 0u))) != 0u) {
                                                    phi_7476_ = array<type_9, 4>(type_9(_e4273, _e4276), type_9(_e4257, _e4260), type_9(_e4225, _e4228), _e2825[3]);
                                                    phi_7477_ = (_e4277 + 1u);
                                                } else {
                                                    phi_7476_ = array<type_9, 4>(_e2825[0], type_9(_e4177, _e4180), type_9(_e4241, _e4244), type_9(_e4273, _e4276));
                                                    phi_7477_ = _e4277;
                                                }
                                                let _e4406 = phi_7476_;
                                                let _e4408 = phi_7477_;
                                                phi_7478_ = _e4406;
                                                phi_7480_ = (_e2827 + 1u);
                                                phi_7481_ = _e4408;
                                            }
                                            let _e4410 = phi_7478_;
                                            let _e4412 = phi_7480_;
                                            let _e4414 = phi_7481_;
                                            phi_7482_ = _e4410;
                                            phi_7484_ = _e4412;
                                            phi_7485_ = _e4414;
                                        } else {
                                            phi_7482_ = array<type_9, 4>();
                                            phi_7484_ = u32();
                                            phi_7485_ = u32();
                                        }
                                        let _e4416 = phi_7482_;
                                        let _e4418 = phi_7484_;
                                        let _e4420 = phi_7485_;
                                        phi_7486_ = _e4416;
                                        phi_7488_ = _e4146;
                                        phi_7489_ = _e4418;
                                        phi_7490_ = _e4420;
                                        phi_7491_ = _e4148;
                                        phi_7492_ = _e4150;
                                        phi_7493_ = _e4152;
                                        phi_7494_ = _e4154;
                                        phi_7495_ = _e4156;
                                    }
                                    let _e4422 = phi_7486_;
                                    let _e4424 = phi_7488_;
                                    let _e4426 = phi_7489_;
                                    let _e4428 = phi_7490_;
                                    let _e4430 = phi_7491_;
                                    let _e4432 = phi_7492_;
                                    let _e4434 = phi_7493_;
                                    let _e4436 = phi_7494_;
                                    let _e4438 = phi_7495_;
                                    if _e4438 {
                                        if _e4424 {
                                            let _e4439 = (_e4428 + 1u);
                                            let _e4441 = (_e4439 & (4294967295u - _e4428));
                                            let _e4447 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e4441)), 32u, (_e4441 == 0u)));
                                            let _e4449 = select(_e4447, _e4426, (_e4426 < _e4447));
                                            let _e4452 = (_e4439 >> bitcast<u32>((_e4449 & 31u)));
                                            let _e4453 = (_e4426 - _e4449);
                                            let _e4457 = select(true, select(true, false, (_e4453 == 0u)), (_e4452 == 1u));
                                            if _e4457 {
                                                let _e4458 = (31u - _e4453);
                                                let _e4461 = (_e4452 << bitcast<u32>((_e4458 & 31u)));
                                                let _e4465 = ((_e4452 + 1u) << bitcast<u32>((_e4458 & 31u)));
                                                let _e4471 = function_6(((_e2711 - _e2638.member) - select(0u, 1u, (_e2707 < _e2638.member_1))), (_e2707 - _e2638.member_1), _e4461);
                                                let _e4474 = (_e2638.member_1 + _e4471.member_1);
                                                let _e4484 = function_6(((_e2782 - _e2711) - select(0u, 1u, (_e2778 < _e2707))), (_e2778 - _e2707), _e4461);
                                                let _e4487 = (_e2707 + _e4484.member_1);
                                                let _e4497 = function_6(((_e2816.member - _e2782) - select(0u, 1u, (_e2816.member_1 < _e2778))), (_e2816.member_1 - _e2778), _e4461);
                                                let _e4500 = (_e2778 + _e4497.member_1);
                                                let _e4508 = array<type_9, 3>(type_9(((_e2638.member + _e4471.member) + select(0u, 1u, (_e4474 < _e2638.member_1))), _e4474), type_9(((_e2711 + _e4484.member) + select(0u, 1u, (_e4487 < _e2707))), _e4487), type_9(((_e2782 + _e4497.member) + select(0u, 1u, (_e4500 < _e2778))), _e4500));
                                                let _e4514 = function_6(((_e2711 - _e2638.member) - select(0u, 1u, (_e2707 < _e2638.member_1))), (_e2707 - _e2638.member_1), _e4465);
                                                let _e4517 = (_e2638.member_1 + _e4514.member_1);
                                                let _e4527 = function_6(((_e2782 - _e2711) - select(0u, 1u, (_e2778 < _e2707))), (_e2778 - _e2707), _e4465);
                                                let _e4530 = (_e2707 + _e4527.member_1);
                                                let _e4540 = function_6(((_e2816.member - _e2782) - select(0u, 1u, (_e2816.member_1 < _e2778))), (_e2816.member_1 - _e2778), _e4465);
                                                let _e4543 = (_e2778 + _e4540.member_1);
                                                let _e4552 = function_7(_e4508, _e4461);
                                                let _e4553 = function_7(_e4508, _e4465);
                                                let _e4554 = function_7(array<type_9, 3>(type_9(((_e2638.member + _e4514.member) + select(0u, 1u, (_e4517 < _e2638.member_1))), _e4517), type_9(((_e2711 + _e4527.member) + select(0u, 1u, (_e4530 < _e2707))), _e4530), type_9(((_e2782 + _e4540.member) + select(0u, 1u, (_e4543 < _e2778))), _e4543)), _e4465);
                                                let _e4568 = function_6(((_e4552[1].member - _e4552[0].member) - select(0u, 1u, (_e4552[1].member_1 < _e4552[0].member_1))), (_e4552[1].member_1 - _e4552[0].member_1), _e4461);
                                                let _e4571 = (_e4552[0].member_1 + _e4568.member_1);
                                                let _e4589 = function_6(((_e4552[1].member - _e4552[0].member) - select(0u, 1u, (_e4552[1].member_1 < _e4552[0].member_1))), (_e4552[1].member_1 - _e4552[0].member_1), _e4465);
                                                let _e4592 = (_e4552[0].member_1 + _e4589.member_1);
                                                let _e4610 = function_6(((_e4553[1].member - _e4553[0].member) - select(0u, 1u, (_e4553[1].member_1 < _e4553[0].member_1))), (_e4553[1].member_1 - _e4553[0].member_1), _e4465);
                                                let _e4613 = (_e4553[0].member_1 + _e4610.member_1);
                                                let _e4631 = function_6(((_e4554[1].member - _e4554[0].member) - select(0u, 1u, (_e4554[1].member_1 < _e4554[0].member_1))), (_e4554[1].member_1 - _e4554[0].member_1), _e4465);
                                                let _e4634 = (_e4554[0].member_1 + _e4631.member_1);
                                                phi_7790_ = array<type_9, 4>(type_9(((_e4552[0].member + _e4568.member) + select(0u, 1u, (_e4571 < _e4552[0].member_1))), _e4571), type_9(((_e4552[0].member + _e4589.member) + select(0u, 1u, (_e4592 < _e4552[0].member_1))), _e4592), type_9(((_e4553[0].member + _e4610.member) + select(0u, 1u, (_e4613 < _e4553[0].member_1))), _e4613), type_9(((_e4554[0].member + _e4631.member) + select(0u, 1u, (_e4634 < _e4554[0].member_1))), _e4634));
                                            } else {
                                                phi_7790_ = array<type_9, 4>();
                                            }
                                            let _e4645 = phi_7790_;
                                            phi_7791_ = _e4645;
                                            phi_7792_ = _e4453;
                                            phi_7793_ = _e4452;
                                            phi_7794_ = _e4457;
                                        } else {
                                            phi_7791_ = _e4422;
                                            phi_7792_ = _e4426;
                                            phi_7793_ = _e4428;
                                            phi_7794_ = true;
                                        }
                                        let _e4647 = phi_7791_;
                                        let _e4649 = phi_7792_;
                                        let _e4651 = phi_7793_;
                                        let _e4653 = phi_7794_;
                                        phi_7799_ = _e4647;
                                        phi_7800_ = _e4649;
                                        phi_7801_ = _e4651;
                                        phi_7802_ = _e4653;
                                        phi_7803_ = select(true, false, _e4653);
                                        phi_7804_ = false;
                                    } else {
                                        phi_7799_ = array<type_9, 4>();
                                        phi_7800_ = u32();
                                        phi_7801_ = u32();
                                        phi_7802_ = false;
                                        phi_7803_ = false;
                                        phi_7804_ = true;
                                    }
                                    let _e4656 = phi_7799_;
                                    let _e4658 = phi_7800_;
                                    let _e4660 = phi_7801_;
                                    let _e4662 = phi_7802_;
                                    let _e4664 = phi_7803_;
                                    let _e4666 = phi_7804_;
                                    phi_7805_ = _e4656;
                                    phi_7807_ = _e4658;
                                    phi_7808_ = _e4660;
                                    phi_7809_ = _e4430;
                                    phi_7810_ = _e4432;
                                    phi_7811_ = _e4434;
                                    phi_7812_ = _e4436;
                                    phi_7813_ = _e4662;
                                    phi_7814_ = _e4664;
                                    phi_7815_ = _e4666;
                                }
                                let _e4668 = phi_7805_;
                                let _e4670 = phi_7807_;
                                let _e4672 = phi_7808_;
                                let _e4674 = phi_7809_;
                                let _e4676 = phi_7810_;
                                let _e4678 = phi_7811_;
                                let _e4680 = phi_7812_;
                                let _e4682 = phi_7813_;
                                let _e4684 = phi_7814_;
                                let _e4686 = phi_7815_;
                                phi_5092_ = _e4668;
                                phi_5096_ = _e4670;
                                phi_5098_ = _e4672;
                                phi_7816_ = _e2847;
                                phi_7817_ = _e4674;
                                phi_7818_ = _e4676;
                                phi_7819_ = _e4678;
                                phi_7820_ = _e4680;
                                phi_7821_ = _e4682;
                                phi_7822_ = _e2852;
                                phi_7823_ = false;
                                phi_7824_ = _e4684;
                                phi_7825_ = _e4686;
                            } else {
                                phi_5092_ = array<type_9, 4>();
                                phi_5096_ = u32();
                                phi_5098_ = u32();
                                phi_7816_ = u32();
                                phi_7817_ = bool();
                                phi_7818_ = bool();
                                phi_7819_ = u32();
                                phi_7820_ = u32();
                                phi_7821_ = false;
                                phi_7822_ = false;
                                phi_7823_ = true;
                                phi_7824_ = false;
                                phi_7825_ = false;
                            }
                            let _e4688 = phi_5092_;
                            let _e4690 = phi_5096_;
                            let _e4692 = phi_5098_;
                            let _e4694 = phi_7816_;
                            let _e4696 = phi_7817_;
                            let _e4698 = phi_7818_;
                            let _e4700 = phi_7819_;
                            let _e4702 = phi_7820_;
                            let _e4704 = phi_7821_;
                            let _e4706 = phi_7822_;
                            let _e4708 = phi_7823_;
                            let _e4710 = phi_7824_;
                            let _e4712 = phi_7825_;
                            local_45 = _e4706;
                            local_46 = _e4706;
                            local_47 = _e4706;
                            local_48 = _e4708;
                            local_49 = _e4706;
                            local_50 = _e4710;
                            local_51 = _e4706;
                            local_52 = _e4712;
                            local_53 = _e4706;
                            local_54 = _e4698;
                            local_55 = _e4700;
                            local_59 = _e4700;
                            local_60 = _e4700;
                            local_61 = _e4700;
                            local_62 = _e4700;
                            local_63 = _e4700;
                            local_64 = _e4700;
                            local_65 = _e4700;
                            local_66 = _e4700;
                            local_67 = _e4700;
                            local_68 = _e4700;
                            local_69 = _e4700;
                            local_70 = _e4700;
                            local_71 = _e4700;
                            local_72 = _e4696;
                            local_73 = _e4694;
                            local_74 = _e4700;
                            local_75 = _e4702;
                            local_76 = _e4694;
                            continue;
                            continuing {
                                phi_5088_ = type_9(select(_e2823.member, (_e2823.member + 1u), _e2832), select(_e2823.member_1, _e2823.member_1, _e2832));
                                phi_5091_ = _e4688;
                                phi_5095_ = _e4690;
                                phi_5097_ = _e4692;
                                break if !(_e4704);
                            }
                        }
                        let _e4716 = local_45;
                        let _e4721 = local_46;
                        let _e4724 = local_47;
                        let _e4726 = local_48;
                        let _e4727 = select(_e4726, false, _e4724);
                        let _e4729 = local_49;
                        let _e4731 = local_50;
                        let _e4734 = local_51;
                        let _e4736 = local_52;
                        let _e4743 = select(select(_e4731, false, _e4729), false, _e4727);
                        let _e4746 = local_53;
                        if select(select(select(_e4736, false, _e4734), false, _e4727), false, _e4743) {
                            let _e4757 = local_54;
                            if _e4757 {
                                let _e4759 = local_55;
                                if (_e4759 <= 2147483648u) {
                                    let _e4762 = local_56;
                                    let _e4766 = local_57;
                                    let _e4769 = function_12(128u);
                                    let _e4774 = ((_e4762[0].member >> bitcast<u32>(31i)) != 0u);
                                    let _e4782 = local_58;
                                    let _e4806 = local_59;
                                    let _e4807 = function_6(((_e2711 - _e2638.member) - select(0u, 1u, (_e2707 < _e2638.member_1))), (_e2707 - _e2638.member_1), _e4806);
                                    let _e4810 = (_e2638.member_1 + _e4807.member_1);
                                    let _e4821 = local_60;
                                    let _e4822 = function_6(((_e2782 - _e2711) - select(0u, 1u, (_e2778 < _e2707))), (_e2778 - _e2707), _e4821);
                                    let _e4825 = (_e2707 + _e4822.member_1);
                                    let _e4836 = local_61;
                                    let _e4837 = function_6(((_e2816.member - _e2782) - select(0u, 1u, (_e2816.member_1 < _e2778))), (_e2816.member_1 - _e2778), _e4836);
                                    let _e4840 = (_e2778 + _e4837.member_1);
                                    let _e4848 = array<type_9, 3>(type_9(((_e2638.member + _e4807.member) + select(0u, 1u, (_e4810 < _e2638.member_1))), _e4810), type_9(((_e2711 + _e4822.member) + select(0u, 1u, (_e4825 < _e2707))), _e4825), type_9(((_e2782 + _e4837.member) + select(0u, 1u, (_e4840 < _e2778))), _e4840));
                                    let _e4855 = local_62;
                                    let _e4856 = function_6(((_e2711 - _e2638.member) - select(0u, 1u, (_e2707 < _e2638.member_1))), (_e2707 - _e2638.member_1), _e4855);
                                    let _e4859 = (_e2638.member_1 + _e4856.member_1);
                                    let _e4870 = local_63;
                                    let _e4871 = function_6(((_e2782 - _e2711) - select(0u, 1u, (_e2778 < _e2707))), (_e2778 - _e2707), _e4870);
                                    let _e4874 = (_e2707 + _e4871.member_1);
                                    let _e4885 = local_64;
                                    let _e4886 = function_6(((_e2816.member - _e2782) - select(0u, 1u, (_e2816.member_1 < _e2778))), (_e2816.member_1 - _e2778), _e4885);
                                    let _e4889 = (_e2778 + _e4886.member_1);
                                    let _e4899 = local_65;
                                    let _e4900 = function_7(_e4848, _e4899);
                                    let _e4902 = local_66;
                                    let _e4903 = function_7(_e4848, _e4902);
                                    let _e4905 = local_67;
                                    let _e4906 = function_7(array<type_9, 3>(type_9(((_e2638.member + _e4856.member) + select(0u, 1u, (_e4859 < _e2638.member_1))), _e4859), type_9(((_e2711 + _e4871.member) + select(0u, 1u, (_e4874 < _e2707))), _e4874), type_9(((_e2782 + _e4886.member) + select(0u, 1u, (_e4889 < _e2778))), _e4889)), _e4905);
                                    let _e4921 = local_68;
                                    let _e4922 = function_6(((_e4900[1].member - _e4900[0].member) - select(0u, 1u, (_e4900[1].member_1 < _e4900[0].member_1))), (_e4900[1].member_1 - _e4900[0].member_1), _e4921);
                                    let _e4925 = (_e4900[0].member_1 + _e4922.member_1);
                                    let _e4929 = ((_e4900[0].member + _e4922.member) + select(0u, 1u, (_e4925 < _e4900[0].member_1)));
                                    let _e4944 = local_69;
                                    let _e4945 = function_6(((_e4900[1].member - _e4900[0].member) - select(0u, 1u, (_e4900[1].member_1 < _e4900[0].member_1))), (_e4900[1].member_1 - _e4900[0].member_1), _e4944);
                                    let _e4960 = local_70;
                                    let _e4961 = function_6(((_e4903[1].member - _e4903[0].member) - select(0u, 1u, (_e4903[1].member_1 < _e4903[0].member_1))), (_e4903[1].member_1 - _e4903[0].member_1), _e4960);
                                    let _e4976 = local_71;
                                    let _e4977 = function_6(((_e4906[1].member - _e4906[0].member) - select(0u, 1u, (_e4906[1].member_1 < _e4906[0].member_1))), (_e4906[1].member_1 - _e4906[0].member_1), _e4976);
                                    let _e4978 = function_12(128u);
                                    let _e4983 = ((_e4929 >> bitcast<u32>(31i)) != 0u);
                                    phi_8200_ = ((select(0u, select(1u, 2u, ((_e4762[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e4769.member - select(_e4782[0].member, (~(_e4762[0].member) + select(0u, 1u, (_e4766[0].member_1 == 0u))), _e4774)) - select(0u, 1u, (_e4769.member_1 < select(_e4782[0].member_1, (~(_e4766[0].member_1) + 1u), _e4774)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e4929 >> bitcast<u32>(31i)) != 0u)), ((((_e4978.member - select(_e4929, (~(_e4929) + select(0u, 1u, (_e4925 == 0u))), _e4983)) - select(0u, 1u, (_e4978.member_1 < select(_e4925, (~(_e4925) + 1u), _e4983)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                    phi_8201_ = false;
                                } else {
                                    phi_8200_ = bool();
                                    phi_8201_ = true;
                                }
                                let _e5007 = phi_8200_;
                                let _e5009 = phi_8201_;
                                phi_8202_ = _e5007;
                                phi_8203_ = _e5009;
                            } else {
                                phi_8202_ = bool();
                                phi_8203_ = true;
                            }
                            let _e5011 = phi_8202_;
                            let _e5013 = phi_8203_;
                            let _e5015 = local_72;
                            let _e5016 = select(_e5011, _e5015, _e5013);
                            let _e5018 = local_73;
                            let _e5021 = local_74;
                            let _e5023 = select(false, (_e5021 <= _e1312), (_e5018 >= _e1310));
                            let _e5025 = local_75;
                            let _e5031 = select(select(bool(), select(bool(), (_e5025 == 0u), _e5023), _e5016), false, select(true, select(true, false, _e5023), _e5016));
                            let _e5035 = local_76;
                            phi_8235_ = type_9(select(2u, 1u, _e5031), select(type_9().member_1, _e5035, _e5031));
                            phi_8236_ = true;
                            phi_8237_ = false;
                        } else {
                            phi_8235_ = type_9(select(type_9().member, 0u, _e4743), select(type_9().member_1, type_9().member_1, _e4743));
                            phi_8236_ = _e4743;
                            phi_8237_ = select(select(_e4746, false, _e4727), false, _e4743);
                        }
                        let _e5039 = phi_8235_;
                        let _e5041 = phi_8236_;
                        let _e5043 = phi_8237_;
                        let _e5048 = select(_e5043, true, _e5041);
                        let _e5050 = select(select(type_9().member_1, type_9().member_1, _e4727), select(select(type_9().member_1, type_9().member_1, _e4721), _e5039.member_1, _e5041), _e5048);
                        switch bitcast<i32>(select(select(type_9().member, 2u, _e4727), select(select(type_9().member, 0u, _e4716), _e5039.member, _e5041), _e5048)) {
                            case 0: {
                                phi_8283_ = type_31(0u, 0u, array<u32, 2>(0u, 0u), false);
                                break;
                            }
                            case 1: {
                                if (_e5050 == 0u) {
                                    phi_8277_ = array<u32, 2>(0u, 0u);
                                } else {
                                    let _e5059 = select((bitcast<u32>(31i) - firstLeadingBit(_e5050)), 32u, (_e5050 == 0u));
                                    let _e5064 = ((_e5050 << bitcast<u32>((_e5059 & 31u))) << bitcast<u32>(1i));
                                    phi_8277_ = array<u32, 2>((_e5064 << bitcast<u32>(20i)), (((1023u - _e5059) << bitcast<u32>(20i)) | (_e5064 >> bitcast<u32>(12i))));
                                }
                                let _e5075 = phi_8277_;
                                phi_8283_ = type_31(0u, select(0u, 1u, (_e5050 > _e1310)), _e5075, true);
                                break;
                            }
                            case 2: {
                                phi_8283_ = type_31(1u, 0u, array<u32, 2>(0u, 0u), true);
                                break;
                            }
                            default: {
                                phi_8283_ = type_31();
                                break;
                            }
                        }
                        let _e5078 = phi_8283_;
                        phi_8290_ = _e5078;
                        phi_8291_ = select(true, false, (_e5078.member == 0u));
                    } else {
                        phi_8290_ = type_31();
                        phi_8291_ = true;
                    }
                    let _e5083 = phi_8290_;
                    let _e5085 = phi_8291_;
                    phi_8292_ = _e5083;
                    phi_8293_ = _e5085;
                } else {
                    phi_8292_ = type_31();
                    phi_8293_ = true;
                }
                let _e5087 = phi_8292_;
                let _e5089 = phi_8293_;
                if _e5089 {
                    let _e5091 = params.member.member.member_11;
                    let _e5093 = params.member.member.member_12;
                    let _e5095 = params.member.member.member_13;
                    let _e5097 = params.member.member.member_13;
                    let _e5103 = select(_e537.member[0][0], -(_e537.member[0][0]), (_e537.member[0][0] < 0f));
                    let _e5107 = select(_e537.member[0][1], -(_e537.member[0][1]), (_e537.member[0][1] < 0f));
                    let _e5109 = select(_e5107, _e5103, (_e5103 > _e5107));
                    let _e5113 = select(_e537.member[0][2], -(_e537.member[0][2]), (_e537.member[0][2] < 0f));
                    let _e5115 = select(_e5113, _e5109, (_e5109 > _e5113));
                    let _e5121 = select(_e537.member[1][0], -(_e537.member[1][0]), (_e537.member[1][0] < 0f));
                    let _e5125 = select(_e537.member[1][1], -(_e537.member[1][1]), (_e537.member[1][1] < 0f));
                    let _e5127 = select(_e5125, _e5121, (_e5121 > _e5125));
                    let _e5131 = select(_e537.member[1][2], -(_e537.member[1][2]), (_e537.member[1][2] < 0f));
                    let _e5133 = select(_e5131, _e5127, (_e5127 > _e5131));
                    let _e5137 = (select(_e5133, _e5115, (_e5115 > _e5133)) + _e537.member_3);
                    let _e5143 = select(_e537.member_1[0][0], -(_e537.member_1[0][0]), (_e537.member_1[0][0] < 0f));
                    let _e5147 = select(_e537.member_1[0][1], -(_e537.member_1[0][1]), (_e537.member_1[0][1] < 0f));
                    let _e5149 = select(_e5147, _e5143, (_e5143 > _e5147));
                    let _e5153 = select(_e537.member_1[0][2], -(_e537.member_1[0][2]), (_e537.member_1[0][2] < 0f));
                    let _e5155 = select(_e5153, _e5149, (_e5149 > _e5153));
                    let _e5161 = select(_e537.member_1[1][0], -(_e537.member_1[1][0]), (_e537.member_1[1][0] < 0f));
                    let _e5165 = select(_e537.member_1[1][1], -(_e537.member_1[1][1]), (_e537.member_1[1][1] < 0f));
                    let _e5167 = select(_e5165, _e5161, (_e5161 > _e5165));
                    let _e5171 = select(_e537.member_1[1][2], -(_e537.member_1[1][2]), (_e537.member_1[1][2] < 0f));
                    let _e5173 = select(_e5171, _e5167, (_e5167 > _e5171));
                    let _e5177 = (select(_e5173, _e5155, (_e5155 > _e5173)) + _e537.member_3);
                    let _e5183 = select(_e537.member_2[0][0], -(_e537.member_2[0][0]), (_e537.member_2[0][0] < 0f));
                    let _e5187 = select(_e537.member_2[0][1], -(_e537.member_2[0][1]), (_e537.member_2[0][1] < 0f));
                    let _e5189 = select(_e5187, _e5183, (_e5183 > _e5187));
                    let _e5193 = select(_e537.member_2[0][2], -(_e537.member_2[0][2]), (_e537.member_2[0][2] < 0f));
                    let _e5195 = select(_e5193, _e5189, (_e5189 > _e5193));
                    let _e5201 = select(_e537.member_2[1][0], -(_e537.member_2[1][0]), (_e537.member_2[1][0] < 0f));
                    let _e5205 = select(_e537.member_2[1][1], -(_e537.member_2[1][1]), (_e537.member_2[1][1] < 0f));
                    let _e5207 = select(_e5205, _e5201, (_e5201 > _e5205));
                    let _e5211 = select(_e537.member_2[1][2], -(_e537.member_2[1][2]), (_e537.member_2[1][2] < 0f));
                    let _e5213 = select(_e5211, _e5207, (_e5207 > _e5211));
                    let _e5217 = (select(_e5213, _e5195, (_e5195 > _e5213)) + _e537.member_3);
                    let _e5219 = select(_e5177, _e5137, (_e5137 > _e5177));
                    let _e5221 = select(_e5217, _e5219, (_e5219 > _e5217));
                    if (_e5221 <= 65536f) {
                        phi_8564_ = (_e5221 >= (1f / 65536f));
                    } else {
                        phi_8564_ = false;
                    }
                    let _e5226 = phi_8564_;
                    if _e5226 {
                        phi_8662_ = type_29();
                        phi_8663_ = true;
                    } else {
                        if (_e5221 >= 0.000000000000000000000000000000000000011754944f) {
                            if ((bitcast<u32>(_e5221) & 2139095040u) != 2139095040u) {
                                let _e5233 = (2130706432u - (bitcast<u32>(_e5221) & 2139095040u));
                                let _e5236 = bitcast<f32>(select(8388608u, _e5233, (_e5233 > 8388608u)));
                                phi_8658_ = type_29(type_27(array<array<f32, 3>, 2>(array<f32, 3>((_e537.member[0][0] * _e5236), (_e537.member[0][1] * _e5236), (_e537.member[0][2] * _e5236)), array<f32, 3>((_e537.member[1][0] * _e5236), (_e537.member[1][1] * _e5236), (_e537.member[1][2] * _e5236))), array<array<f32, 3>, 2>(array<f32, 3>((_e537.member_1[0][0] * _e5236), (_e537.member_1[0][1] * _e5236), (_e537.member_1[0][2] * _e5236)), array<f32, 3>((_e537.member_1[1][0] * _e5236), (_e537.member_1[1][1] * _e5236), (_e537.member_1[1][2] * _e5236))), array<array<f32, 3>, 2>(array<f32, 3>((_e537.member_2[0][0] * _e5236), (_e537.member_2[0][1] * _e5236), (_e537.member_2[0][2] * _e5236)), array<f32, 3>((_e537.member_2[1][0] * _e5236), (_e537.member_2[1][1] * _e5236), (_e537.member_2[1][2] * _e5236))), ((_e537.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e5236)), (0f * _e5236));
                                phi_8659_ = false;
                            } else {
                                phi_8658_ = type_29();
                                phi_8659_ = true;
                            }
                            let _e5302 = phi_8658_;
                            let _e5304 = phi_8659_;
                            phi_8660_ = _e5302;
                            phi_8661_ = _e5304;
                        } else {
                            phi_8660_ = type_29();
                            phi_8661_ = true;
                        }
                        let _e5306 = phi_8660_;
                        let _e5308 = phi_8661_;
                        phi_8662_ = _e5306;
                        phi_8663_ = _e5308;
                    }
                    let _e5310 = phi_8662_;
                    let _e5312 = phi_8663_;
                    if _e5312 {
                        phi_8668_ = type_29(_e537, 0f);
                    } else {
                        phi_8668_ = _e5310;
                    }
                    let _e5315 = phi_8668_;
                    local_10 = type_27(array<array<f32, 3>, 2>(array<f32, 3>(_e5315.member.member[0][0], _e5315.member.member[0][1], _e5315.member.member[0][2]), array<f32, 3>(_e5315.member.member[1][0], _e5315.member.member[1][1], _e5315.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e5315.member.member_1[0][0], _e5315.member.member_1[0][1], _e5315.member.member_1[0][2]), array<f32, 3>(_e5315.member.member_1[1][0], _e5315.member.member_1[1][1], _e5315.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e5315.member.member_2[0][0], _e5315.member.member_2[0][1], _e5315.member.member_2[0][2]), array<f32, 3>(_e5315.member.member_2[1][0], _e5315.member.member_2[1][1], _e5315.member.member_2[1][2])), _e5315.member.member_3);
                    let _e5357 = local_10.member_1[0u];
                    let _e5363 = local_10.member_2[0u];
                    let _e5369 = ((_e5357[1] * _e5363[2]) - (_e5357[2] * _e5363[1]));
                    let _e5372 = ((_e5357[2] * _e5363[0]) - (_e5357[0] * _e5363[2]));
                    let _e5375 = ((_e5357[0] * _e5363[1]) - (_e5357[1] * _e5363[0]));
                    let _e5378 = local_10.member_1[1u];
                    let _e5384 = local_10.member_2[1u];
                    let _e5390 = ((_e5378[1] * _e5384[2]) - (_e5378[2] * _e5384[1]));
                    let _e5393 = ((_e5378[2] * _e5384[0]) - (_e5378[0] * _e5384[2]));
                    let _e5396 = ((_e5378[0] * _e5384[1]) - (_e5378[1] * _e5384[0]));
                    let _e5399 = local_10.member_1[0u];
                    let _e5405 = local_10.member_2[1u];
                    let _e5420 = local_10.member_1[1u];
                    let _e5426 = local_10.member_2[0u];
                    let _e5439 = (((_e5399[1] * _e5405[2]) - (_e5399[2] * _e5405[1])) + ((_e5420[1] * _e5426[2]) - (_e5420[2] * _e5426[1])));
                    let _e5440 = (((_e5399[2] * _e5405[0]) - (_e5399[0] * _e5405[2])) + ((_e5420[2] * _e5426[0]) - (_e5420[0] * _e5426[2])));
                    let _e5441 = (((_e5399[0] * _e5405[1]) - (_e5399[1] * _e5405[0])) + ((_e5420[0] * _e5426[1]) - (_e5420[1] * _e5426[0])));
                    let _e5444 = local_10.member[0u];
                    let _e5452 = (((_e5444[0] * _e5369) + (_e5444[1] * _e5372)) + (_e5444[2] * _e5375));
                    let _e5455 = local_10.member[1u];
                    let _e5466 = local_10.member[0u];
                    let _e5475 = ((((_e5455[0] * _e5369) + (_e5455[1] * _e5372)) + (_e5455[2] * _e5375)) + (((_e5466[0] * _e5439) + (_e5466[1] * _e5440)) + (_e5466[2] * _e5441)));
                    let _e5478 = local_10.member[0u];
                    let _e5489 = local_10.member[1u];
                    let _e5498 = ((((_e5478[0] * _e5390) + (_e5478[1] * _e5393)) + (_e5478[2] * _e5396)) + (((_e5489[0] * _e5439) + (_e5489[1] * _e5440)) + (_e5489[2] * _e5441)));
                    let _e5501 = local_10.member[1u];
                    let _e5509 = (((_e5501[0] * _e5390) + (_e5501[1] * _e5393)) + (_e5501[2] * _e5396));
                    let _e5512 = local_10.member[0u];
                    let _e5518 = select(_e5512[0], -(_e5512[0]), (_e5512[0] < 0f));
                    let _e5521 = select(_e5512[1], -(_e5512[1]), (_e5512[1] < 0f));
                    let _e5523 = select(_e5521, _e5518, (_e5518 > _e5521));
                    let _e5526 = select(_e5512[2], -(_e5512[2]), (_e5512[2] < 0f));
                    let _e5528 = select(_e5526, _e5523, (_e5523 > _e5526));
                    let _e5531 = local_10.member[1u];
                    let _e5537 = select(_e5531[0], -(_e5531[0]), (_e5531[0] < 0f));
                    let _e5540 = select(_e5531[1], -(_e5531[1]), (_e5531[1] < 0f));
                    let _e5542 = select(_e5540, _e5537, (_e5537 > _e5540));
                    let _e5545 = select(_e5531[2], -(_e5531[2]), (_e5531[2] < 0f));
                    let _e5547 = select(_e5545, _e5542, (_e5542 > _e5545));
                    let _e5551 = local_10.member_3;
                    let _e5552 = (select(_e5547, _e5528, (_e5528 > _e5547)) + _e5551);
                    let _e5555 = local_10.member_1[0u];
                    let _e5561 = select(_e5555[0], -(_e5555[0]), (_e5555[0] < 0f));
                    let _e5564 = select(_e5555[1], -(_e5555[1]), (_e5555[1] < 0f));
                    let _e5566 = select(_e5564, _e5561, (_e5561 > _e5564));
                    let _e5569 = select(_e5555[2], -(_e5555[2]), (_e5555[2] < 0f));
                    let _e5571 = select(_e5569, _e5566, (_e5566 > _e5569));
                    let _e5574 = local_10.member_1[1u];
                    let _e5580 = select(_e5574[0], -(_e5574[0]), (_e5574[0] < 0f));
                    let _e5583 = select(_e5574[1], -(_e5574[1]), (_e5574[1] < 0f));
                    let _e5585 = select(_e5583, _e5580, (_e5580 > _e5583));
                    let _e5588 = select(_e5574[2], -(_e5574[2]), (_e5574[2] < 0f));
                    let _e5590 = select(_e5588, _e5585, (_e5585 > _e5588));
                    let _e5594 = local_10.member_3;
                    let _e5595 = (select(_e5590, _e5571, (_e5571 > _e5590)) + _e5594);
                    let _e5598 = local_10.member_2[0u];
                    let _e5604 = select(_e5598[0], -(_e5598[0]), (_e5598[0] < 0f));
                    let _e5607 = select(_e5598[1], -(_e5598[1]), (_e5598[1] < 0f));
                    let _e5609 = select(_e5607, _e5604, (_e5604 > _e5607));
                    let _e5612 = select(_e5598[2], -(_e5598[2]), (_e5598[2] < 0f));
                    let _e5614 = select(_e5612, _e5609, (_e5609 > _e5612));
                    let _e5617 = local_10.member_2[1u];
                    let _e5623 = select(_e5617[0], -(_e5617[0]), (_e5617[0] < 0f));
                    let _e5626 = select(_e5617[1], -(_e5617[1]), (_e5617[1] < 0f));
                    let _e5628 = select(_e5626, _e5623, (_e5623 > _e5626));
                    let _e5631 = select(_e5617[2], -(_e5617[2]), (_e5617[2] < 0f));
                    let _e5633 = select(_e5631, _e5628, (_e5628 > _e5631));
                    let _e5637 = local_10.member_3;
                    let _e5638 = (select(_e5633, _e5614, (_e5614 > _e5633)) + _e5637);
                    let _e5640 = ((_e5595 * 8f) * _e5638);
                    let _e5647 = local_10.member_3;
                    let _e5671 = ((select(_e5369, -(_e5369), (_e5369 < 0f)) + select(_e5372, -(_e5372), (_e5372 < 0f))) + select(_e5375, -(_e5375), (_e5375 < 0f)));
                    let _e5682 = ((select(_e5390, -(_e5390), (_e5390 < 0f)) + select(_e5393, -(_e5393), (_e5393 < 0f))) + select(_e5396, -(_e5396), (_e5396 < 0f)));
                    let _e5684 = select(_e5682, _e5671, (_e5671 > _e5682));
                    let _e5696 = (((select(_e5439, -(_e5439), (_e5439 < 0f)) + select(_e5440, -(_e5440), (_e5440 < 0f))) + select(_e5441, -(_e5441), (_e5441 < 0f))) * 0.5f);
                    let _e5703 = local_10.member_3;
                    let _e5715 = (((((_e5552 * 8f) * _e5640) * (0.000000059604645f * (524f / 64f))) + ((_e5647 * 19f) * ((_e5552 * (_e5595 + _e5638)) + (_e5595 * _e5638)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e5552) * ((1f + _e5595) * (1f + _e5638)))));
                    let _e5716 = (_e5452 * 3f);
                    let _e5717 = (_e5509 * 3f);
                    let _e5719 = select(_e5717, _e5716, (_e5716 < _e5717));
                    let _e5721 = select(_e5498, _e5475, (_e5475 < _e5498));
                    let _e5723 = select(_e5721, _e5719, (_e5719 < _e5721));
                    let _e5725 = select(_e5717, _e5716, (_e5716 > _e5717));
                    let _e5727 = select(_e5498, _e5475, (_e5475 > _e5498));
                    let _e5734 = -(select(_e5727, _e5725, (_e5725 > _e5727)));
                    if ((select(_e5734, _e5723, (_e5723 > _e5734)) - (_e5715 + ((0f * (((select(_e5696, _e5684, (_e5684 > _e5696)) + (_e5640 * (0.000000059604645f * 8f))) + ((_e5703 * 6f) * (_e5595 + _e5638))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e5595) * (1f + _e5638))))) * (3f * 1.0001f)))) > 0f) {
                        phi_14040_ = type_30(0u, type_30().member_1);
                        phi_14041_ = type_30();
                        phi_14042_ = true;
                    } else {
                        let _e5742 = select(_e5452, -(_e5452), (_e5452 < 0f));
                        let _e5745 = select(_e5475, -(_e5475), (_e5475 < 0f));
                        let _e5747 = select(_e5745, _e5742, (_e5742 > _e5745));
                        let _e5750 = select(_e5498, -(_e5498), (_e5498 < 0f));
                        let _e5753 = select(_e5509, -(_e5509), (_e5509 < 0f));
                        let _e5755 = select(_e5753, _e5750, (_e5750 > _e5753));
                        let _e5757 = select(_e5755, _e5747, (_e5747 > _e5755));
                        let _e5758 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e5757 >= _e5758) {
                            phi_9393_ = (_e5757 <= (1f / _e5758));
                        } else {
                            phi_9393_ = false;
                        }
                        let _e5763 = phi_9393_;
                        if _e5763 {
                            phi_9405_ = (1f / _e5757);
                        } else {
                            phi_9405_ = 0f;
                        }
                        let _e5770 = phi_9405_;
                        let _e5771 = (_e5091 * 0.0625f);
                        local_8 = type_34(array<f32, 4>(_e5452, _e5475, _e5498, _e5509), ((_e5715 * 0.34f) + (_e5757 * select(2f, (0.000000059604645f * 256f), _e5763))), _e5770, select(_e5771, 0.00000000000022737368f, (0.00000000000022737368f < _e5771)));
                        let _e5778 = local_8.member[0u];
                        let _e5781 = local_8.member[1u];
                        let _e5784 = local_8.member[2u];
                        let _e5787 = local_8.member[3u];
                        let _e5794 = local_8.member_2;
                        let _e5795 = ((_e5781 - (3f * _e5778)) * _e5794);
                        let _e5797 = local_8.member_2;
                        let _e5798 = ((_e5784 - _e5781) * _e5797);
                        let _e5800 = local_8.member_2;
                        let _e5801 = (((3f * _e5787) - _e5784) * _e5800);
                        local_6[0u] = 0f;
                        local_6[1u] = 1f;
                        local_6[2u] = 1f;
                        local_6[3u] = 1f;
                        let _e5808 = ((_e5798 * _e5798) - (_e5795 * _e5801));
                        if (_e5808 > 0f) {
                            if (_e5808 <= 0.000000000000000000000000000000000000011754944f) {
                                phi_9533_ = select(0f, (0.000000000000000000106433627f * 2f), (_e5808 > 0f));
                            } else {
                                phi_9476_ = type_14(0i, 5i);
                                phi_9479_ = bitcast<f32>(((bitcast<u32>(_e5808) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e5817 = phi_9476_;
                                    let _e5819 = phi_9479_;
                                    local_77 = _e5819;
                                    if (_e5817.member < _e5817.member_1) {
                                        let _e5826 = (_e5817.member + 1i);
                                        phi_9477_ = type_14(select(_e5826, type_15().member_1, select(false, true, ((false == (_e5826 > _e5817.member)) != false))), _e5817.member_1);
                                        phi_9520_ = type_15(1u, _e5817.member);
                                    } else {
                                        phi_9477_ = _e5817;
                                        phi_9520_ = type_15(0u, type_15().member_1);
                                    }
                                    let _e5837 = phi_9477_;
                                    let _e5839 = phi_9520_;
                                    let _e5842 = (bitcast<i32>(_e5839.member) != 0i);
                                    if _e5842 {
                                        phi_9480_ = (0.5f * (_e5819 + (_e5808 / _e5819)));
                                    } else {
                                        phi_9480_ = f32();
                                    }
                                    let _e5847 = phi_9480_;
                                    continue;
                                    continuing {
                                        phi_9476_ = _e5837;
                                        phi_9479_ = _e5847;
                                        break if !(_e5842);
                                    }
                                }
                                let _e5852 = local_77;
                                phi_9533_ = (_e5852 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e5858 = phi_9533_;
                            let _e5863 = -((_e5798 + select(_e5858, -(_e5858), (_e5798 < 0f))));
                            local_7[0u] = (_e5863 / (_e5863 + _e5801));
                            local_7[1u] = (_e5795 / (_e5795 + _e5863));
                            let _e5872 = local_7[1u];
                            let _e5873 = local_7[0u];
                            if (_e5872 < _e5873) {
                                let _e5876 = local_7[1u];
                                let _e5878 = local_7[0u];
                                local_7[0u] = _e5876;
                                local_7[1u] = _e5878;
                            }
                            phi_9564_ = type_9(0u, 2u);
                            phi_9567_ = 1u;
                            loop {
                                let _e5882 = phi_9564_;
                                let _e5884 = phi_9567_;
                                local_109 = _e5884;
                                let _e5887 = (_e5882.member < _e5882.member_1);
                                let _e5898 = select(type_9().member_1, _e5882.member, _e5887);
                                let _e5900 = (bitcast<i32>(select(0u, 1u, _e5887)) != 0i);
                                if _e5900 {
                                    let _e5902 = local_7[_e5898];
                                    if (_e5902 > 0f) {
                                        let _e5905 = local_7[_e5898];
                                        if (_e5905 < 1f) {
                                            let _e5908 = local_7[_e5898];
                                            local_6[_e5884] = _e5908;
                                            phi_9634_ = (_e5884 + 1u);
                                        } else {
                                            phi_9634_ = _e5884;
                                        }
                                        let _e5912 = phi_9634_;
                                        phi_9635_ = _e5912;
                                    } else {
                                        phi_9635_ = _e5884;
                                    }
                                    let _e5914 = phi_9635_;
                                    phi_9568_ = _e5914;
                                } else {
                                    phi_9568_ = u32();
                                }
                                let _e5916 = phi_9568_;
                                continue;
                                continuing {
                                    phi_9564_ = type_9(select(_e5882.member, (_e5882.member + 1u), _e5887), select(_e5882.member_1, _e5882.member_1, _e5887));
                                    phi_9567_ = _e5916;
                                    break if !(_e5900);
                                }
                            }
                            let _e8788 = local_109;
                            phi_9636_ = _e8788;
                        } else {
                            phi_9636_ = 1u;
                        }
                        let _e5919 = phi_9636_;
                        local_6[_e5919] = 1f;
                        let _e5921 = local_6;
                        local_9 = _e5921;
                        let _e5922 = (_e5091 * 0.99f);
                        let _e5923 = (1f - _e5093);
                        let _e5926 = local_8.member[0u];
                        let _e5929 = local_8.member[1u];
                        let _e5932 = local_8.member[2u];
                        let _e5935 = local_8.member[3u];
                        let _e5946 = ((((_e5926 * _e5923) + (_e5929 * _e5093)) * (_e5923 * _e5923)) + (((_e5932 * _e5923) + (_e5935 * _e5093)) * (_e5093 * _e5093)));
                        let _e5951 = local_8.member_1;
                        phi_9692_ = type_9(select(1u, 0u, !((select(_e5946, -(_e5946), (_e5946 < 0f)) > _e5951))), (_e5919 + 1u));
                        loop {
                            let _e5958 = phi_9692_;
                            let _e5961 = (_e5958.member < _e5958.member_1);
                            let _e5972 = select(type_9().member_1, _e5958.member, _e5961);
                            if (bitcast<i32>(select(0u, 1u, _e5961)) != 0i) {
                                if (_e5972 > 0u) {
                                    let _e5979 = local_9[(_e5972 - 1u)];
                                    let _e5981 = select(_e5093, _e5979, (_e5979 > _e5093));
                                    let _e5983 = local_9[_e5972];
                                    let _e5985 = select(_e5095, _e5983, (_e5983 < _e5095));
                                    if (_e5981 <= _e5985) {
                                        let _e5987 = function_5((&local_8), _e5097, _e5981, _e5985);
                                        if _e5987 {
                                            phi_11245_ = type_45();
                                            phi_11246_ = bool();
                                            phi_11247_ = type_45();
                                            phi_11248_ = false;
                                            phi_11249_ = false;
                                            phi_11250_ = false;
                                            phi_11251_ = false;
                                        } else {
                                            let _e5988 = (1f - _e5981);
                                            let _e5991 = local_8.member[0u];
                                            let _e5994 = local_8.member[1u];
                                            let _e5997 = local_8.member[2u];
                                            let _e6000 = local_8.member[3u];
                                            let _e6011 = ((((_e5991 * _e5988) + (_e5994 * _e5981)) * (_e5988 * _e5988)) + (((_e5997 * _e5988) + (_e6000 * _e5981)) * (_e5981 * _e5981)));
                                            let _e6012 = (1f - _e5985);
                                            let _e6015 = local_8.member[0u];
                                            let _e6018 = local_8.member[1u];
                                            let _e6021 = local_8.member[2u];
                                            let _e6024 = local_8.member[3u];
                                            let _e6035 = ((((_e6015 * _e6012) + (_e6018 * _e5985)) * (_e6012 * _e6012)) + (((_e6021 * _e6012) + (_e6024 * _e5985)) * (_e5985 * _e5985)));
                                            let _e6040 = local_8.member_1;
                                            let _e6041 = (select(_e6011, -(_e6011), (_e6011 < 0f)) > _e6040);
                                            let _e6046 = local_8.member_1;
                                            let _e6047 = (select(_e6035, -(_e6035), (_e6035 < 0f)) > _e6046);
                                            let _e6055 = select(select(bool(), select(bool(), ((_e6011 > 0f) != (_e6035 > 0f)), _e6047), _e6041), false, select(true, select(true, false, _e6047), _e6041));
                                            if _e6041 {
                                                if _e6047 {
                                                    phi_9848_ = type_45(select(1f, type_45().member, _e6055), select(0f, type_45().member_1, _e6055), select(_e6055, type_45().member_2, _e6055));
                                                    phi_9849_ = _e6055;
                                                } else {
                                                    phi_9848_ = type_45();
                                                    phi_9849_ = true;
                                                }
                                                let _e6064 = phi_9848_;
                                                let _e6066 = phi_9849_;
                                                phi_9850_ = _e6064;
                                                phi_9851_ = _e6066;
                                            } else {
                                                phi_9850_ = type_45();
                                                phi_9851_ = true;
                                            }
                                            let _e6068 = phi_9850_;
                                            let _e6070 = phi_9851_;
                                            if _e6070 {
                                                if _e6041 {
                                                    let _e6072 = select(1f, -1f, (_e6011 < 0f));
                                                    let _e6074 = local_8.member_3;
                                                    let _e6077 = local_8.member[0u];
                                                    let _e6080 = local_8.member[1u];
                                                    let _e6083 = local_8.member[2u];
                                                    let _e6086 = local_8.member[3u];
                                                    let _e6089 = (_e6083 - _e6080);
                                                    phi_9882_ = type_9(0u, 64u);
                                                    phi_9885_ = _e5985;
                                                    phi_9887_ = _e5981;
                                                    phi_9889_ = (0.5f * (_e5981 + _e5985));
                                                    loop {
                                                        let _e6095 = phi_9882_;
                                                        let _e6097 = phi_9885_;
                                                        let _e6099 = phi_9887_;
                                                        let _e6101 = phi_9889_;
                                                        local_80 = _e6099;
                                                        let _e6104 = (_e6095.member < _e6095.member_1);
                                                        if (bitcast<i32>(select(0u, 1u, _e6104)) != 0i) {
                                                            let _e6116 = (1f - _e6101);
                                                            let _e6119 = local_8.member[0u];
                                                            let _e6122 = local_8.member[1u];
                                                            let _e6125 = local_8.member[2u];
                                                            let _e6128 = local_8.member[3u];
                                                            let _e6142 = local_8.member_1;
                                                            let _e6143 = ((_e6072 * ((((_e6119 * _e6116) + (_e6122 * _e6101)) * (_e6116 * _e6116)) + (((_e6125 * _e6116) + (_e6128 * _e6101)) * (_e6101 * _e6101)))) - _e6142);
                                                            let _e6144 = (_e6143 > 0f);
                                                            let _e6145 = select(_e6101, _e6097, _e6144);
                                                            let _e6146 = select(_e6099, _e6101, _e6144);
                                                            let _e6148 = ((_e6145 - _e6146) > _e6074);
                                                            if _e6148 {
                                                                let _e6149 = (1f - _e6101);
                                                                let _e6161 = (-(_e6143) / (_e6072 * (((((_e6080 - (3f * _e6077)) * _e6149) + (_e6089 * _e6101)) * _e6149) + (((_e6089 * _e6149) + (((3f * _e6086) - _e6083) * _e6101)) * _e6101))));
                                                                let _e6168 = ((_e6101 + _e6161) + select(-((0.5f * _e6074)), (0.5f * _e6074), (_e6143 > 0f)));
                                                                if (_e6168 > _e6146) {
                                                                    phi_9999_ = select(true, select(true, false, (select(_e6161, -(_e6161), (_e6161 < 0f)) < (0.5f * (_e6145 - _e6146)))), (_e6168 < _e6145));
                                                                } else {
                                                                    phi_9999_ = true;
                                                                }
                                                                let _e6180 = phi_9999_;
                                                                phi_10006_ = select(_e6168, (0.5f * (_e6146 + _e6145)), _e6180);
                                                                phi_10007_ = false;
                                                            } else {
                                                                phi_10006_ = f32();
                                                                phi_10007_ = true;
                                                            }
                                                            let _e6185 = phi_10006_;
                                                            let _e6187 = phi_10007_;
                                                            phi_9886_ = _e6145;
                                                            phi_9888_ = _e6146;
                                                            phi_9890_ = _e6185;
                                                            phi_10008_ = _e6146;
                                                            phi_10009_ = _e6148;
                                                            phi_10010_ = _e6187;
                                                        } else {
                                                            phi_9886_ = f32();
                                                            phi_9888_ = f32();
                                                            phi_9890_ = f32();
                                                            phi_10008_ = f32();
                                                            phi_10009_ = false;
                                                            phi_10010_ = false;
                                                        }
                                                        let _e6189 = phi_9886_;
                                                        let _e6191 = phi_9888_;
                                                        let _e6193 = phi_9890_;
                                                        let _e6195 = phi_10008_;
                                                        let _e6197 = phi_10009_;
                                                        let _e6199 = phi_10010_;
                                                        local_78 = _e6199;
                                                        local_79 = _e6195;
                                                        continue;
                                                        continuing {
                                                            phi_9882_ = type_9(select(_e6095.member, (_e6095.member + 1u), _e6104), select(_e6095.member_1, _e6095.member_1, _e6104));
                                                            phi_9885_ = _e6189;
                                                            phi_9887_ = _e6191;
                                                            phi_9889_ = _e6193;
                                                            break if !(_e6197);
                                                        }
                                                    }
                                                    let _e6202 = local_78;
                                                    let _e6204 = local_79;
                                                    let _e6206 = local_80;
                                                    phi_10015_ = select(_e6206, _e6204, _e6202);
                                                } else {
                                                    phi_10015_ = _e5981;
                                                }
                                                let _e6209 = phi_10015_;
                                                if _e6047 {
                                                    let _e6213 = local_8.member_3;
                                                    let _e6215 = local_8.member_3;
                                                    phi_10031_ = type_9(0u, 64u);
                                                    phi_10034_ = (_e6213 + _e6215);
                                                    loop {
                                                        let _e6218 = phi_10031_;
                                                        let _e6220 = phi_10034_;
                                                        let _e6223 = (_e6218.member < _e6218.member_1);
                                                        if (bitcast<i32>(select(0u, 1u, _e6223)) != 0i) {
                                                            let _e6235 = (_e6209 + _e6220);
                                                            if (_e6235 < _e5985) {
                                                                let _e6237 = (1f - _e6235);
                                                                let _e6240 = local_8.member[0u];
                                                                let _e6243 = local_8.member[1u];
                                                                let _e6246 = local_8.member[2u];
                                                                let _e6249 = local_8.member[3u];
                                                                let _e6263 = local_8.member_1;
                                                                let _e6264 = ((select(1f, -1f, (_e6035 < 0f)) * ((((_e6240 * _e6237) + (_e6243 * _e6235)) * (_e6237 * _e6237)) + (((_e6246 * _e6237) + (_e6249 * _e6235)) * (_e6235 * _e6235)))) > _e6263);
                                                                phi_10099_ = select((_e6220 + _e6220), f32(), _e6264);
                                                                phi_10100_ = select(true, false, _e6264);
                                                                phi_10101_ = _e6264;
                                                                phi_10102_ = false;
                                                            } else {
                                                                phi_10099_ = f32();
                                                                phi_10100_ = false;
                                                                phi_10101_ = false;
                                                                phi_10102_ = true;
                                                            }
                                                            let _e6269 = phi_10099_;
                                                            let _e6271 = phi_10100_;
                                                            let _e6273 = phi_10101_;
                                                            let _e6275 = phi_10102_;
                                                            phi_10103_ = _e6235;
                                                            phi_10035_ = _e6269;
                                                            phi_10104_ = _e6271;
                                                            phi_10105_ = _e6273;
                                                            phi_10106_ = _e6275;
                                                            phi_10107_ = false;
                                                        } else {
                                                            phi_10103_ = f32();
                                                            phi_10035_ = f32();
                                                            phi_10104_ = false;
                                                            phi_10105_ = false;
                                                            phi_10106_ = false;
                                                            phi_10107_ = true;
                                                        }
                                                        let _e6277 = phi_10103_;
                                                        let _e6279 = phi_10035_;
                                                        let _e6281 = phi_10104_;
                                                        let _e6283 = phi_10105_;
                                                        let _e6285 = phi_10106_;
                                                        let _e6287 = phi_10107_;
                                                        local_81 = _e6283;
                                                        local_82 = _e6285;
                                                        local_83 = _e6283;
                                                        local_84 = _e6287;
                                                        local_85 = _e6277;
                                                        continue;
                                                        continuing {
                                                            phi_10031_ = type_9(select(_e6218.member, (_e6218.member + 1u), _e6223), select(_e6218.member_1, _e6218.member_1, _e6223));
                                                            phi_10034_ = _e6279;
                                                            break if !(_e6281);
                                                        }
                                                    }
                                                    let _e6290 = local_81;
                                                    let _e6292 = local_82;
                                                    let _e6295 = local_83;
                                                    let _e6297 = local_84;
                                                    let _e6301 = local_85;
                                                    phi_10121_ = select(_e6301, _e5985, select(select(_e6297, false, _e6295), true, select(_e6292, false, _e6290)));
                                                } else {
                                                    phi_10121_ = _e5985;
                                                }
                                                let _e6304 = phi_10121_;
                                                phi_10123_ = type_45(_e6209, _e6304, _e6055);
                                            } else {
                                                phi_10123_ = _e6068;
                                            }
                                            let _e6307 = phi_10123_;
                                            if (_e6307.member > _e6307.member_1) {
                                                phi_11240_ = bool();
                                                phi_11241_ = true;
                                                phi_11242_ = false;
                                                phi_11243_ = false;
                                                phi_11244_ = false;
                                            } else {
                                                let _e6312 = (_e6307.member > _e5097);
                                                if _e6312 {
                                                    phi_11236_ = bool();
                                                    phi_11237_ = false;
                                                    phi_11238_ = false;
                                                    phi_11239_ = false;
                                                } else {
                                                    let _e6316 = ((_e6307.member_1 - _e6307.member) * 0.5f);
                                                    let _e6317 = (_e6307.member + _e6316);
                                                    let _e6319 = (_e6316 + (0.000000059604645f * 4f));
                                                    let _e6321 = local_10.member_3;
                                                    let _e6324 = local_10.member[0u];
                                                    let _e6330 = select(_e6324[0], -(_e6324[0]), (_e6324[0] < 0f));
                                                    let _e6333 = select(_e6324[1], -(_e6324[1]), (_e6324[1] < 0f));
                                                    let _e6335 = select(_e6333, _e6330, (_e6330 > _e6333));
                                                    let _e6338 = select(_e6324[2], -(_e6324[2]), (_e6324[2] < 0f));
                                                    let _e6340 = select(_e6338, _e6335, (_e6335 > _e6338));
                                                    let _e6342 = local_10.member[1u];
                                                    let _e6348 = select(_e6342[0], -(_e6342[0]), (_e6342[0] < 0f));
                                                    let _e6351 = select(_e6342[1], -(_e6342[1]), (_e6342[1] < 0f));
                                                    let _e6353 = select(_e6351, _e6348, (_e6348 > _e6351));
                                                    let _e6356 = select(_e6342[2], -(_e6342[2]), (_e6342[2] < 0f));
                                                    let _e6358 = select(_e6356, _e6353, (_e6353 > _e6356));
                                                    let _e6363 = local_10.member[0u];
                                                    let _e6368 = local_10.member[1u];
                                                    let _e6378 = (_e6363[0] + ((_e6368[0] - _e6363[0]) * _e6317));
                                                    let _e6379 = (_e6363[1] + ((_e6368[1] - _e6363[1]) * _e6317));
                                                    let _e6380 = (_e6363[2] + ((_e6368[2] - _e6363[2]) * _e6317));
                                                    let _e6382 = local_10.member[1u];
                                                    let _e6387 = local_10.member[0u];
                                                    let _e6391 = (_e6382[0] - _e6387[0]);
                                                    let _e6392 = (_e6382[1] - _e6387[1]);
                                                    let _e6393 = (_e6382[2] - _e6387[2]);
                                                    let _e6396 = select(_e6391, -(_e6391), (_e6391 < 0f));
                                                    let _e6399 = select(_e6392, -(_e6392), (_e6392 < 0f));
                                                    let _e6401 = select(_e6399, _e6396, (_e6396 > _e6399));
                                                    let _e6404 = select(_e6393, -(_e6393), (_e6393 < 0f));
                                                    let _e6412 = ((((_e6319 * select(_e6404, _e6401, (_e6401 > _e6404))) * 1.01f) + ((select(_e6358, _e6340, (_e6340 > _e6358)) + _e6321) * (0.000000059604645f * 8f))) + _e6321);
                                                    let _e6415 = select(_e6378, -(_e6378), (_e6378 < 0f));
                                                    let _e6418 = select(_e6379, -(_e6379), (_e6379 < 0f));
                                                    let _e6420 = select(_e6418, _e6415, (_e6415 > _e6418));
                                                    let _e6423 = select(_e6380, -(_e6380), (_e6380 < 0f));
                                                    local_2 = type_20(array<f32, 3>(_e6378, _e6379, _e6380), _e6412, (select(_e6423, _e6420, (_e6420 > _e6423)) + _e6412));
                                                    let _e6431 = local_10.member_3;
                                                    let _e6433 = local_10.member_1[0u];
                                                    let _e6439 = select(_e6433[0], -(_e6433[0]), (_e6433[0] < 0f));
                                                    let _e6442 = select(_e6433[1], -(_e6433[1]), (_e6433[1] < 0f));
                                                    let _e6444 = select(_e6442, _e6439, (_e6439 > _e6442));
                                                    let _e6447 = select(_e6433[2], -(_e6433[2]), (_e6433[2] < 0f));
                                                    let _e6449 = select(_e6447, _e6444, (_e6444 > _e6447));
                                                    let _e6451 = local_10.member_1[1u];
                                                    let _e6457 = select(_e6451[0], -(_e6451[0]), (_e6451[0] < 0f));
                                                    let _e6460 = select(_e6451[1], -(_e6451[1]), (_e6451[1] < 0f));
                                                    let _e6462 = select(_e6460, _e6457, (_e6457 > _e6460));
                                                    let _e6465 = select(_e6451[2], -(_e6451[2]), (_e6451[2] < 0f));
                                                    let _e6467 = select(_e6465, _e6462, (_e6462 > _e6465));
                                                    let _e6472 = local_10.member_1[0u];
                                                    let _e6477 = local_10.member_1[1u];
                                                    let _e6487 = (_e6472[0] + ((_e6477[0] - _e6472[0]) * _e6317));
                                                    let _e6488 = (_e6472[1] + ((_e6477[1] - _e6472[1]) * _e6317));
                                                    let _e6489 = (_e6472[2] + ((_e6477[2] - _e6472[2]) * _e6317));
                                                    let _e6491 = local_10.member_1[1u];
                                                    let _e6496 = local_10.member_1[0u];
                                                    let _e6500 = (_e6491[0] - _e6496[0]);
                                                    let _e6501 = (_e6491[1] - _e6496[1]);
                                                    let _e6502 = (_e6491[2] - _e6496[2]);
                                                    let _e6505 = select(_e6500, -(_e6500), (_e6500 < 0f));
                                                    let _e6508 = select(_e6501, -(_e6501), (_e6501 < 0f));
                                                    let _e6510 = select(_e6508, _e6505, (_e6505 > _e6508));
                                                    let _e6513 = select(_e6502, -(_e6502), (_e6502 < 0f));
                                                    let _e6521 = ((((_e6319 * select(_e6513, _e6510, (_e6510 > _e6513))) * 1.01f) + ((select(_e6467, _e6449, (_e6449 > _e6467)) + _e6431) * (0.000000059604645f * 8f))) + _e6431);
                                                    let _e6524 = select(_e6487, -(_e6487), (_e6487 < 0f));
                                                    let _e6527 = select(_e6488, -(_e6488), (_e6488 < 0f));
                                                    let _e6529 = select(_e6527, _e6524, (_e6524 > _e6527));
                                                    let _e6532 = select(_e6489, -(_e6489), (_e6489 < 0f));
                                                    local_3 = type_20(array<f32, 3>(_e6487, _e6488, _e6489), _e6521, (select(_e6532, _e6529, (_e6529 > _e6532)) + _e6521));
                                                    let _e6540 = local_10.member_3;
                                                    let _e6542 = local_10.member_2[0u];
                                                    let _e6548 = select(_e6542[0], -(_e6542[0]), (_e6542[0] < 0f));
                                                    let _e6551 = select(_e6542[1], -(_e6542[1]), (_e6542[1] < 0f));
                                                    let _e6553 = select(_e6551, _e6548, (_e6548 > _e6551));
                                                    let _e6556 = select(_e6542[2], -(_e6542[2]), (_e6542[2] < 0f));
                                                    let _e6558 = select(_e6556, _e6553, (_e6553 > _e6556));
                                                    let _e6560 = local_10.member_2[1u];
                                                    let _e6566 = select(_e6560[0], -(_e6560[0]), (_e6560[0] < 0f));
                                                    let _e6569 = select(_e6560[1], -(_e6560[1]), (_e6560[1] < 0f));
                                                    let _e6571 = select(_e6569, _e6566, (_e6566 > _e6569));
                                                    let _e6574 = select(_e6560[2], -(_e6560[2]), (_e6560[2] < 0f));
                                                    let _e6576 = select(_e6574, _e6571, (_e6571 > _e6574));
                                                    let _e6581 = local_10.member_2[0u];
                                                    let _e6586 = local_10.member_2[1u];
                                                    let _e6596 = (_e6581[0] + ((_e6586[0] - _e6581[0]) * _e6317));
                                                    let _e6597 = (_e6581[1] + ((_e6586[1] - _e6581[1]) * _e6317));
                                                    let _e6598 = (_e6581[2] + ((_e6586[2] - _e6581[2]) * _e6317));
                                                    let _e6600 = local_10.member_2[1u];
                                                    let _e6605 = local_10.member_2[0u];
                                                    let _e6609 = (_e6600[0] - _e6605[0]);
                                                    let _e6610 = (_e6600[1] - _e6605[1]);
                                                    let _e6611 = (_e6600[2] - _e6605[2]);
                                                    let _e6614 = select(_e6609, -(_e6609), (_e6609 < 0f));
                                                    let _e6617 = select(_e6610, -(_e6610), (_e6610 < 0f));
                                                    let _e6619 = select(_e6617, _e6614, (_e6614 > _e6617));
                                                    let _e6622 = select(_e6611, -(_e6611), (_e6611 < 0f));
                                                    let _e6630 = ((((_e6319 * select(_e6622, _e6619, (_e6619 > _e6622))) * 1.01f) + ((select(_e6576, _e6558, (_e6558 > _e6576)) + _e6540) * (0.000000059604645f * 8f))) + _e6540);
                                                    let _e6633 = select(_e6596, -(_e6596), (_e6596 < 0f));
                                                    let _e6636 = select(_e6597, -(_e6597), (_e6597 < 0f));
                                                    let _e6638 = select(_e6636, _e6633, (_e6633 > _e6636));
                                                    let _e6641 = select(_e6598, -(_e6598), (_e6598 < 0f));
                                                    local_4 = type_20(array<f32, 3>(_e6596, _e6597, _e6598), _e6630, (select(_e6641, _e6638, (_e6638 > _e6641)) + _e6630));
                                                    let _e6648 = local_3.member;
                                                    let _e6653 = local_4.member;
                                                    let _e6659 = ((_e6648[1] * _e6653[2]) - (_e6648[2] * _e6653[1]));
                                                    let _e6662 = ((_e6648[2] * _e6653[0]) - (_e6648[0] * _e6653[2]));
                                                    let _e6665 = ((_e6648[0] * _e6653[1]) - (_e6648[1] * _e6653[0]));
                                                    if (select(_e6659, -(_e6659), (_e6659 < 0f)) > select(_e6662, -(_e6662), (_e6662 < 0f))) {
                                                        let _e6688 = (select(_e6659, -(_e6659), (_e6659 < 0f)) > select(_e6665, -(_e6665), (_e6665 < 0f)));
                                                        phi_10848_ = select(1u, 2u, _e6688);
                                                        phi_10849_ = select(0u, 1u, _e6688);
                                                    } else {
                                                        let _e6679 = (select(_e6662, -(_e6662), (_e6662 < 0f)) > select(_e6665, -(_e6665), (_e6665 < 0f)));
                                                        phi_10848_ = select(1u, 0u, _e6679);
                                                        phi_10849_ = select(0u, 2u, _e6679);
                                                    }
                                                    let _e6692 = phi_10848_;
                                                    let _e6694 = phi_10849_;
                                                    let _e6697 = local_3.member[_e6694];
                                                    let _e6700 = local_4.member[_e6692];
                                                    let _e6704 = local_3.member[_e6692];
                                                    let _e6707 = local_4.member[_e6694];
                                                    let _e6709 = ((_e6697 * _e6700) - (_e6704 * _e6707));
                                                    let _e6711 = local_3.member_1;
                                                    let _e6713 = local_4.member_2;
                                                    let _e6716 = local_3.member_2;
                                                    let _e6718 = local_4.member_1;
                                                    let _e6723 = local_3.member_2;
                                                    let _e6726 = local_4.member_2;
                                                    let _e6734 = local_3.member_2;
                                                    let _e6737 = local_4.member_2;
                                                    let _e6741 = (((((_e6711 * _e6713) + (_e6716 * _e6718)) * 2.01f) + (((_e6723 * 2f) * (_e6726 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6734) * (1f + _e6737))));
                                                    if (select(_e6709, -(_e6709), (_e6709 < 0f)) > _e6741) {
                                                        let _e6747 = select(1f, -1f, (_e6709 < 0f));
                                                        let _e6750 = local_2.member[_e6694];
                                                        let _e6753 = local_4.member[_e6692];
                                                        let _e6757 = local_2.member[_e6692];
                                                        let _e6760 = local_4.member[_e6694];
                                                        let _e6764 = local_2.member_1;
                                                        let _e6766 = local_4.member_2;
                                                        let _e6769 = local_2.member_2;
                                                        let _e6771 = local_4.member_1;
                                                        let _e6776 = local_2.member_2;
                                                        let _e6779 = local_4.member_2;
                                                        let _e6787 = local_2.member_2;
                                                        let _e6790 = local_4.member_2;
                                                        let _e6794 = (((((_e6764 * _e6766) + (_e6769 * _e6771)) * 2.01f) + (((_e6776 * 2f) * (_e6779 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6787) * (1f + _e6790))));
                                                        let _e6797 = local_3.member[_e6694];
                                                        let _e6800 = local_2.member[_e6692];
                                                        let _e6804 = local_3.member[_e6692];
                                                        let _e6807 = local_2.member[_e6694];
                                                        let _e6811 = local_3.member_1;
                                                        let _e6813 = local_2.member_2;
                                                        let _e6816 = local_3.member_2;
                                                        let _e6818 = local_2.member_1;
                                                        let _e6823 = local_3.member_2;
                                                        let _e6826 = local_2.member_2;
                                                        let _e6834 = local_3.member_2;
                                                        let _e6837 = local_2.member_2;
                                                        let _e6841 = (((((_e6811 * _e6813) + (_e6816 * _e6818)) * 2.01f) + (((_e6823 * 2f) * (_e6826 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6834) * (1f + _e6837))));
                                                        let _e6842 = (_e6709 * _e6747);
                                                        let _e6843 = (((_e6750 * _e6753) - (_e6757 * _e6760)) * _e6747);
                                                        let _e6844 = (((_e6797 * _e6800) - (_e6804 * _e6807)) * _e6747);
                                                        let _e6857 = (((select(_e6842, -(_e6842), (_e6842 < 0f)) + select(_e6843, -(_e6843), (_e6843 < 0f))) + select(_e6844, -(_e6844), (_e6844 < 0f))) * (0.000000059604645f * 4f));
                                                        if (_e281.member != 0u) {
                                                            phi_11110_ = array<type_16, 4>(type_16(_e6843, _e6794), type_16(_e6844, _e6841), type_16((_e6842 - _e6843), ((_e6741 + _e6794) + _e6857)), type_16((_e6842 - _e6844), ((_e6741 + _e6841) + _e6857)));
                                                        } else {
                                                            let _e6860 = ((_e6842 - _e6843) - _e6844);
                                                            let _e6863 = (((_e6741 + _e6794) + _e6841) + _e6857);
                                                            phi_11110_ = array<type_16, 4>(type_16(_e6843, _e6794), type_16(_e6844, _e6841), type_16(_e6860, _e6863), type_16(_e6860, _e6863));
                                                        }
                                                        let _e6881 = phi_11110_;
                                                        local_5 = array<type_16, 4>(type_16(_e6881[0].member, _e6881[0].member_1), type_16(_e6881[1].member, _e6881[1].member_1), type_16(_e6881[2].member, _e6881[2].member_1), type_16(_e6881[3].member, _e6881[3].member_1));
                                                        phi_11130_ = type_9(0u, 4u);
                                                        phi_11133_ = true;
                                                        loop {
                                                            let _e6900 = phi_11130_;
                                                            let _e6902 = phi_11133_;
                                                            local_87 = _e6902;
                                                            let _e6905 = (_e6900.member < _e6900.member_1);
                                                            let _e6916 = select(type_9().member_1, _e6900.member, _e6905);
                                                            if (bitcast<i32>(select(0u, 1u, _e6905)) != 0i) {
                                                                let _e6921 = local_5[_e6916].member;
                                                                let _e6924 = local_5[_e6916].member_1;
                                                                let _e6926 = (_e6921 < -(_e6924));
                                                                phi_11134_ = select((_e6902 && (_e6921 > _e6924)), bool(), _e6926);
                                                                phi_11185_ = select(true, false, _e6926);
                                                                phi_11186_ = _e6926;
                                                            } else {
                                                                phi_11134_ = bool();
                                                                phi_11185_ = false;
                                                                phi_11186_ = false;
                                                            }
                                                            let _e6932 = phi_11134_;
                                                            let _e6934 = phi_11185_;
                                                            let _e6936 = phi_11186_;
                                                            local_86 = _e6936;
                                                            continue;
                                                            continuing {
                                                                phi_11130_ = type_9(select(_e6900.member, (_e6900.member + 1u), _e6905), select(_e6900.member_1, _e6900.member_1, _e6905));
                                                                phi_11133_ = _e6932;
                                                                break if !(_e6934);
                                                            }
                                                        }
                                                        let _e6939 = local_86;
                                                        let _e6940 = select(true, false, _e6939);
                                                        let _e6942 = local_87;
                                                        phi_11200_ = select(u32(), select(2u, 1u, _e6942), _e6940);
                                                        phi_11201_ = 0u;
                                                        phi_11202_ = select(true, false, _e6940);
                                                    } else {
                                                        phi_11200_ = u32();
                                                        phi_11201_ = 2u;
                                                        phi_11202_ = true;
                                                    }
                                                    let _e6947 = phi_11200_;
                                                    let _e6949 = phi_11201_;
                                                    let _e6951 = phi_11202_;
                                                    let _e6952 = select(_e6947, _e6949, _e6951);
                                                    let _e6953 = (_e6952 == 0u);
                                                    if _e6953 {
                                                        phi_11233_ = bool();
                                                        phi_11234_ = false;
                                                        phi_11235_ = false;
                                                    } else {
                                                        let _e6956 = select(false, _e6307.member_2, (_e6952 == 1u));
                                                        let _e6962 = select(true, select(true, false, ((_e6307.member_1 - _e6307.member) <= _e5922)), _e6956);
                                                        phi_11233_ = _e6956;
                                                        phi_11234_ = _e6962;
                                                        phi_11235_ = select(true, false, _e6962);
                                                    }
                                                    let _e6965 = phi_11233_;
                                                    let _e6967 = phi_11234_;
                                                    let _e6969 = phi_11235_;
                                                    phi_11236_ = _e6965;
                                                    phi_11237_ = _e6953;
                                                    phi_11238_ = _e6967;
                                                    phi_11239_ = _e6969;
                                                }
                                                let _e6971 = phi_11236_;
                                                let _e6973 = phi_11237_;
                                                let _e6975 = phi_11238_;
                                                let _e6977 = phi_11239_;
                                                phi_11240_ = _e6971;
                                                phi_11241_ = _e6973;
                                                phi_11242_ = _e6975;
                                                phi_11243_ = _e6312;
                                                phi_11244_ = _e6977;
                                            }
                                            let _e6979 = phi_11240_;
                                            let _e6981 = phi_11241_;
                                            let _e6983 = phi_11242_;
                                            let _e6985 = phi_11243_;
                                            let _e6987 = phi_11244_;
                                            phi_11245_ = _e6307;
                                            phi_11246_ = _e6979;
                                            phi_11247_ = _e6307;
                                            phi_11248_ = _e6981;
                                            phi_11249_ = _e6983;
                                            phi_11250_ = _e6985;
                                            phi_11251_ = _e6987;
                                        }
                                        let _e6989 = phi_11245_;
                                        let _e6991 = phi_11246_;
                                        let _e6993 = phi_11247_;
                                        let _e6995 = phi_11248_;
                                        let _e6997 = phi_11249_;
                                        let _e6999 = phi_11250_;
                                        let _e7001 = phi_11251_;
                                        phi_11252_ = _e6989;
                                        phi_11253_ = _e6991;
                                        phi_11254_ = _e6993;
                                        phi_11255_ = _e6995;
                                        phi_11256_ = _e6997;
                                        phi_11257_ = _e5987;
                                        phi_11258_ = _e6999;
                                        phi_11259_ = _e7001;
                                    } else {
                                        phi_11252_ = type_45();
                                        phi_11253_ = bool();
                                        phi_11254_ = type_45();
                                        phi_11255_ = true;
                                        phi_11256_ = false;
                                        phi_11257_ = false;
                                        phi_11258_ = false;
                                        phi_11259_ = false;
                                    }
                                    let _e7003 = phi_11252_;
                                    let _e7005 = phi_11253_;
                                    let _e7007 = phi_11254_;
                                    let _e7009 = phi_11255_;
                                    let _e7011 = phi_11256_;
                                    let _e7013 = phi_11257_;
                                    let _e7015 = phi_11258_;
                                    let _e7017 = phi_11259_;
                                    phi_11267_ = _e7003;
                                    phi_11268_ = _e7005;
                                    phi_11269_ = _e7007;
                                    phi_11270_ = select(_e7011, false, _e7009);
                                    phi_11271_ = _e7009;
                                    phi_11272_ = select(_e7013, false, _e7009);
                                    phi_11273_ = select(_e7015, false, _e7009);
                                    phi_11274_ = select(_e7017, false, _e7009);
                                } else {
                                    phi_11267_ = type_45(_e5093, _e5093, false);
                                    phi_11268_ = false;
                                    phi_11269_ = type_45();
                                    phi_11270_ = true;
                                    phi_11271_ = false;
                                    phi_11272_ = false;
                                    phi_11273_ = false;
                                    phi_11274_ = false;
                                }
                                let _e7023 = phi_11267_;
                                let _e7025 = phi_11268_;
                                let _e7027 = phi_11269_;
                                let _e7029 = phi_11270_;
                                let _e7031 = phi_11271_;
                                let _e7033 = phi_11272_;
                                let _e7035 = phi_11273_;
                                let _e7037 = phi_11274_;
                                if _e7029 {
                                    let _e7042 = local_10.member[0u];
                                    let _e7048 = local_10.member_1[0u];
                                    let _e7054 = local_10.member_2[0u];
                                    let _e7058 = (_e7042[0] - _e7048[0]);
                                    let _e7059 = (_e7042[1] - _e7048[1]);
                                    let _e7060 = (_e7042[2] - _e7048[2]);
                                    let _e7061 = (_e281.member == 0u);
                                    let _e7073 = local_10.member[1u];
                                    let _e7079 = local_10.member_1[1u];
                                    let _e7085 = local_10.member_2[1u];
                                    let _e7089 = (_e7073[0] - _e7079[0]);
                                    let _e7090 = (_e7073[1] - _e7079[1]);
                                    let _e7091 = (_e7073[2] - _e7079[2]);
                                    let _e7092 = (_e281.member == 0u);
                                    let _e7104 = local_10.member[0u];
                                    let _e7110 = select(_e7104[0], -(_e7104[0]), (_e7104[0] < 0f));
                                    let _e7113 = select(_e7104[1], -(_e7104[1]), (_e7104[1] < 0f));
                                    let _e7115 = select(_e7113, _e7110, (_e7110 > _e7113));
                                    let _e7118 = select(_e7104[2], -(_e7104[2]), (_e7104[2] < 0f));
                                    let _e7120 = select(_e7118, _e7115, (_e7115 > _e7118));
                                    let _e7123 = local_10.member[1u];
                                    let _e7129 = select(_e7123[0], -(_e7123[0]), (_e7123[0] < 0f));
                                    let _e7132 = select(_e7123[1], -(_e7123[1]), (_e7123[1] < 0f));
                                    let _e7134 = select(_e7132, _e7129, (_e7129 > _e7132));
                                    let _e7137 = select(_e7123[2], -(_e7123[2]), (_e7123[2] < 0f));
                                    let _e7139 = select(_e7137, _e7134, (_e7134 > _e7137));
                                    let _e7143 = local_10.member_3;
                                    let _e7147 = local_10.member_1[0u];
                                    let _e7153 = select(_e7147[0], -(_e7147[0]), (_e7147[0] < 0f));
                                    let _e7156 = select(_e7147[1], -(_e7147[1]), (_e7147[1] < 0f));
                                    let _e7158 = select(_e7156, _e7153, (_e7153 > _e7156));
                                    let _e7161 = select(_e7147[2], -(_e7147[2]), (_e7147[2] < 0f));
                                    let _e7163 = select(_e7161, _e7158, (_e7158 > _e7161));
                                    let _e7166 = local_10.member_1[1u];
                                    let _e7172 = select(_e7166[0], -(_e7166[0]), (_e7166[0] < 0f));
                                    let _e7175 = select(_e7166[1], -(_e7166[1]), (_e7166[1] < 0f));
                                    let _e7177 = select(_e7175, _e7172, (_e7172 > _e7175));
                                    let _e7180 = select(_e7166[2], -(_e7166[2]), (_e7166[2] < 0f));
                                    let _e7182 = select(_e7180, _e7177, (_e7177 > _e7180));
                                    let _e7186 = local_10.member_3;
                                    let _e7190 = local_10.member_2[0u];
                                    let _e7196 = select(_e7190[0], -(_e7190[0]), (_e7190[0] < 0f));
                                    let _e7199 = select(_e7190[1], -(_e7190[1]), (_e7190[1] < 0f));
                                    let _e7201 = select(_e7199, _e7196, (_e7196 > _e7199));
                                    let _e7204 = select(_e7190[2], -(_e7190[2]), (_e7190[2] < 0f));
                                    let _e7206 = select(_e7204, _e7201, (_e7201 > _e7204));
                                    let _e7209 = local_10.member_2[1u];
                                    let _e7215 = select(_e7209[0], -(_e7209[0]), (_e7209[0] < 0f));
                                    let _e7218 = select(_e7209[1], -(_e7209[1]), (_e7209[1] < 0f));
                                    let _e7220 = select(_e7218, _e7215, (_e7215 > _e7218));
                                    let _e7223 = select(_e7209[2], -(_e7209[2]), (_e7209[2] < 0f));
                                    let _e7225 = select(_e7223, _e7220, (_e7220 > _e7223));
                                    let _e7229 = local_10.member_3;
                                    let _e7236 = local_10.member_3;
                                    let _e7241 = (_e5091 * 0.00390625f);
                                    local = type_28(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    phi_11697_ = type_9(0u, 96u);
                                    phi_11700_ = _e7023.member;
                                    phi_11702_ = _e7023.member;
                                    phi_11704_ = (_e7023.member_1 - _e7023.member);
                                    phi_11706_ = _e7023.member;
                                    phi_11708_ = false;
                                    phi_11710_ = 0u;
                                    loop {
                                        let _e7244 = phi_11697_;
                                        let _e7246 = phi_11700_;
                                        let _e7248 = phi_11702_;
                                        let _e7250 = phi_11704_;
                                        let _e7252 = phi_11706_;
                                        let _e7254 = phi_11708_;
                                        let _e7256 = phi_11710_;
                                        local_97 = _e7246;
                                        local_100 = _e7248;
                                        let _e7259 = (_e7244.member < _e7244.member_1);
                                        if (bitcast<i32>(select(0u, 1u, _e7259)) != 0i) {
                                            let _e7273 = local_10.member[0u];
                                            let _e7279 = local_10.member[1u];
                                            let _e7295 = local_10.member_1[0u];
                                            let _e7301 = local_10.member_1[1u];
                                            let _e7317 = local_10.member_2[0u];
                                            let _e7323 = local_10.member_2[1u];
                                            let _e7337 = function_3(array<f32, 3>((_e7273[0] + ((_e7279[0] - _e7273[0]) * _e7246)), (_e7273[1] + ((_e7279[1] - _e7273[1]) * _e7246)), (_e7273[2] + ((_e7279[2] - _e7273[2]) * _e7246))), array<f32, 3>((_e7295[0] + ((_e7301[0] - _e7295[0]) * _e7246)), (_e7295[1] + ((_e7301[1] - _e7295[1]) * _e7246)), (_e7295[2] + ((_e7301[2] - _e7295[2]) * _e7246))), array<f32, 3>((_e7317[0] + ((_e7323[0] - _e7317[0]) * _e7246)), (_e7317[1] + ((_e7323[1] - _e7317[1]) * _e7246)), (_e7317[2] + ((_e7323[2] - _e7317[2]) * _e7246))), _e281.member);
                                            if (_e7256 == 0u) {
                                                phi_11861_ = _e7337;
                                            } else {
                                                phi_11861_ = array<f32, 3>(select(0f, _e7337[0], (_e7256 == 1u)), select(0f, _e7337[1], (_e7256 == 2u)), select(0f, _e7337[2], (_e7256 == 3u)));
                                            }
                                            let _e7350 = phi_11861_;
                                            let _e7364 = ((select(_e7350[0], -(_e7350[0]), (_e7350[0] < 0f)) + select(_e7350[1], -(_e7350[1]), (_e7350[1] < 0f))) + select(_e7350[2], -(_e7350[2]), (_e7350[2] < 0f)));
                                            if (_e7364 > 0f) {
                                                if ((bitcast<u32>(_e7364) & 2139095040u) != 2139095040u) {
                                                    let _e7369 = (1f / _e7364);
                                                    let _e7371 = (_e7350[0] * _e7369);
                                                    let _e7373 = (_e7350[1] * _e7369);
                                                    let _e7375 = (_e7350[2] * _e7369);
                                                    let _e7380 = (((_e7371 * _e7371) + (_e7373 * _e7373)) + (_e7375 * _e7375));
                                                    if (_e7380 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_11984_ = select(0f, (0.000000000000000000106433627f * 2f), (_e7380 > 0f));
                                                    } else {
                                                        phi_11927_ = type_14(0i, 5i);
                                                        phi_11930_ = bitcast<f32>(((bitcast<u32>(_e7380) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e7388 = phi_11927_;
                                                            let _e7390 = phi_11930_;
                                                            local_88 = _e7390;
                                                            if (_e7388.member < _e7388.member_1) {
                                                                let _e7397 = (_e7388.member + 1i);
                                                                phi_11928_ = type_14(select(_e7397, type_15().member_1, select(false, true, ((false == (_e7397 > _e7388.member)) != false))), _e7388.member_1);
                                                                phi_11971_ = type_15(1u, _e7388.member);
                                                            } else {
                                                                phi_11928_ = _e7388;
                                                                phi_11971_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e7408 = phi_11928_;
                                                            let _e7410 = phi_11971_;
                                                            let _e7413 = (bitcast<i32>(_e7410.member) != 0i);
                                                            if _e7413 {
                                                                phi_11931_ = (0.5f * (_e7390 + (_e7380 / _e7390)));
                                                            } else {
                                                                phi_11931_ = f32();
                                                            }
                                                            let _e7418 = phi_11931_;
                                                            continue;
                                                            continuing {
                                                                phi_11927_ = _e7408;
                                                                phi_11930_ = _e7418;
                                                                break if !(_e7413);
                                                            }
                                                        }
                                                        let _e7423 = local_88;
                                                        phi_11984_ = (_e7423 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e7429 = phi_11984_;
                                                    let _e7430 = (0.000000059604645f * 12f);
                                                    let _e7435 = ((((((((select(_e7139, _e7120, (_e7120 > _e7139)) + _e7143) + (select(_e7182, _e7163, (_e7163 > _e7182)) + _e7186)) + (select(_e7225, _e7206, (_e7206 > _e7225)) + _e7229)) * (0.000000059604645f * 16f)) + (_e7236 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e7429) * (1f + _e7430)));
                                                    let _e7440 = (((_e7371 * _e7042[0]) + (_e7373 * _e7042[1])) + (_e7375 * _e7042[2]));
                                                    let _e7445 = (((_e7371 * _e7058) + (_e7373 * _e7059)) + (_e7375 * _e7060));
                                                    let _e7450 = (((_e7371 * (_e7042[0] - _e7054[0])) + (_e7373 * (_e7042[1] - _e7054[1]))) + (_e7375 * (_e7042[2] - _e7054[2])));
                                                    let _e7455 = (((_e7371 * select((_e7058 - _e7054[0]), _e7042[0], _e7061)) + (_e7373 * select((_e7059 - _e7054[1]), _e7042[1], _e7061))) + (_e7375 * select((_e7060 - _e7054[2]), _e7042[2], _e7061)));
                                                    let _e7461 = (((_e7371 * _e7073[0]) + (_e7373 * _e7073[1])) + (_e7375 * _e7073[2]));
                                                    let _e7466 = (((_e7371 * _e7089) + (_e7373 * _e7090)) + (_e7375 * _e7091));
                                                    let _e7471 = (((_e7371 * (_e7073[0] - _e7085[0])) + (_e7373 * (_e7073[1] - _e7085[1]))) + (_e7375 * (_e7073[2] - _e7085[2])));
                                                    let _e7476 = (((_e7371 * select((_e7089 - _e7085[0]), _e7073[0], _e7092)) + (_e7373 * select((_e7090 - _e7085[1]), _e7073[1], _e7092))) + (_e7375 * select((_e7091 - _e7085[2]), _e7073[2], _e7092)));
                                                    phi_12107_ = type_28(array<f32, 4>(_e7440, _e7445, _e7450, _e7455), array<f32, 4>(_e7461, _e7466, _e7471, _e7476), array<f32, 4>((_e7435 + ((select(_e7440, -(_e7440), (_e7440 < 0f)) + select(_e7461, -(_e7461), (_e7461 < 0f))) * _e7430)), (_e7435 + ((select(_e7445, -(_e7445), (_e7445 < 0f)) + select(_e7466, -(_e7466), (_e7466 < 0f))) * _e7430)), (_e7435 + ((select(_e7450, -(_e7450), (_e7450 < 0f)) + select(_e7471, -(_e7471), (_e7471 < 0f))) * _e7430)), (_e7435 + ((select(_e7455, -(_e7455), (_e7455 < 0f)) + select(_e7476, -(_e7476), (_e7476 < 0f))) * _e7430))));
                                                    phi_12108_ = false;
                                                } else {
                                                    phi_12107_ = type_28();
                                                    phi_12108_ = true;
                                                }
                                                let _e7517 = phi_12107_;
                                                let _e7519 = phi_12108_;
                                                phi_12109_ = _e7517;
                                                phi_12110_ = _e7519;
                                            } else {
                                                phi_12109_ = type_28();
                                                phi_12110_ = true;
                                            }
                                            let _e7521 = phi_12109_;
                                            let _e7523 = phi_12110_;
                                            if _e7523 {
                                                phi_12118_ = type_28(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            } else {
                                                phi_12118_ = _e7521;
                                            }
                                            let _e7525 = phi_12118_;
                                            local_1 = type_28(array<f32, 4>(_e7525.member[0], _e7525.member[1], _e7525.member[2], _e7525.member[3]), array<f32, 4>(_e7525.member_1[0], _e7525.member_1[1], _e7525.member_1[2], _e7525.member_1[3]), array<f32, 4>(_e7525.member_2[0], _e7525.member_2[1], _e7525.member_2[2], _e7525.member_2[3]));
                                            let _e7545 = (_e7246 - _e7252);
                                            let _e7549 = local_1.member[0u];
                                            let _e7552 = local_1.member_1[0u];
                                            let _e7555 = local_1.member[0u];
                                            let _e7561 = local_1.member_2[0u];
                                            if (((_e7549 + ((_e7552 - _e7555) * _e7246)) - _e7561) > 0f) {
                                                let _e7566 = local_1.member[1u];
                                                let _e7569 = local_1.member_1[1u];
                                                let _e7572 = local_1.member[1u];
                                                let _e7578 = local_1.member_2[1u];
                                                if (((_e7566 + ((_e7569 - _e7572) * _e7246)) - _e7578) > 0f) {
                                                    let _e7583 = local_1.member[2u];
                                                    let _e7586 = local_1.member_1[2u];
                                                    let _e7589 = local_1.member[2u];
                                                    let _e7595 = local_1.member_2[2u];
                                                    if (((_e7583 + ((_e7586 - _e7589) * _e7246)) - _e7595) > 0f) {
                                                        let _e7600 = local_1.member[3u];
                                                        let _e7603 = local_1.member_1[3u];
                                                        let _e7606 = local_1.member[3u];
                                                        let _e7612 = local_1.member_2[3u];
                                                        phi_12289_ = (((_e7600 + ((_e7603 - _e7606) * _e7246)) - _e7612) > 0f);
                                                        phi_12290_ = false;
                                                    } else {
                                                        phi_12289_ = bool();
                                                        phi_12290_ = true;
                                                    }
                                                    let _e7616 = phi_12289_;
                                                    let _e7618 = phi_12290_;
                                                    phi_12291_ = _e7616;
                                                    phi_12292_ = _e7618;
                                                } else {
                                                    phi_12291_ = bool();
                                                    phi_12292_ = true;
                                                }
                                                let _e7620 = phi_12291_;
                                                let _e7622 = phi_12292_;
                                                phi_12293_ = _e7620;
                                                phi_12294_ = _e7622;
                                            } else {
                                                phi_12293_ = bool();
                                                phi_12294_ = true;
                                            }
                                            let _e7624 = phi_12293_;
                                            let _e7626 = phi_12294_;
                                            if select(_e7624, false, _e7626) {
                                                if (_e7246 <= _e7248) {
                                                    phi_12608_ = true;
                                                } else {
                                                    let _e7631 = local.member[0u];
                                                    let _e7634 = local.member_1[0u];
                                                    let _e7637 = local.member[0u];
                                                    let _e7643 = local.member_2[0u];
                                                    let _e7647 = local_1.member[0u];
                                                    let _e7650 = local_1.member_1[0u];
                                                    let _e7653 = local_1.member[0u];
                                                    let _e7659 = local_1.member_2[0u];
                                                    if ((((_e7631 + ((_e7634 - _e7637) * _e7246)) - _e7643) + ((_e7647 + ((_e7650 - _e7653) * _e7252)) - _e7659)) > 0f) {
                                                        let _e7665 = local.member[1u];
                                                        let _e7668 = local.member_1[1u];
                                                        let _e7671 = local.member[1u];
                                                        let _e7677 = local.member_2[1u];
                                                        let _e7681 = local_1.member[1u];
                                                        let _e7684 = local_1.member_1[1u];
                                                        let _e7687 = local_1.member[1u];
                                                        let _e7693 = local_1.member_2[1u];
                                                        if ((((_e7665 + ((_e7668 - _e7671) * _e7246)) - _e7677) + ((_e7681 + ((_e7684 - _e7687) * _e7252)) - _e7693)) > 0f) {
                                                            let _e7699 = local.member[2u];
                                                            let _e7702 = local.member_1[2u];
                                                            let _e7705 = local.member[2u];
                                                            let _e7711 = local.member_2[2u];
                                                            let _e7715 = local_1.member[2u];
                                                            let _e7718 = local_1.member_1[2u];
                                                            let _e7721 = local_1.member[2u];
                                                            let _e7727 = local_1.member_2[2u];
                                                            if ((((_e7699 + ((_e7702 - _e7705) * _e7246)) - _e7711) + ((_e7715 + ((_e7718 - _e7721) * _e7252)) - _e7727)) > 0f) {
                                                                let _e7733 = local.member[3u];
                                                                let _e7736 = local.member_1[3u];
                                                                let _e7739 = local.member[3u];
                                                                let _e7745 = local.member_2[3u];
                                                                let _e7749 = local_1.member[3u];
                                                                let _e7752 = local_1.member_1[3u];
                                                                let _e7755 = local_1.member[3u];
                                                                let _e7761 = local_1.member_2[3u];
                                                                phi_12595_ = ((((_e7733 + ((_e7736 - _e7739) * _e7246)) - _e7745) + ((_e7749 + ((_e7752 - _e7755) * _e7252)) - _e7761)) > 0f);
                                                                phi_12596_ = false;
                                                            } else {
                                                                phi_12595_ = bool();
                                                                phi_12596_ = true;
                                                            }
                                                            let _e7766 = phi_12595_;
                                                            let _e7768 = phi_12596_;
                                                            phi_12597_ = _e7766;
                                                            phi_12598_ = _e7768;
                                                        } else {
                                                            phi_12597_ = bool();
                                                            phi_12598_ = true;
                                                        }
                                                        let _e7770 = phi_12597_;
                                                        let _e7772 = phi_12598_;
                                                        phi_12599_ = _e7770;
                                                        phi_12600_ = _e7772;
                                                    } else {
                                                        phi_12599_ = bool();
                                                        phi_12600_ = true;
                                                    }
                                                    let _e7774 = phi_12599_;
                                                    let _e7776 = phi_12600_;
                                                    phi_12608_ = select(_e7774, false, _e7776);
                                                }
                                                let _e7779 = phi_12608_;
                                                if _e7779 {
                                                    if select(true, select(true, false, (_e7246 >= _e7023.member_1)), _e7254) {
                                                        local = type_28(array<f32, 4>(_e7525.member[0], _e7525.member[1], _e7525.member[2], _e7525.member[3]), array<f32, 4>(_e7525.member_1[0], _e7525.member_1[1], _e7525.member_1[2], _e7525.member_1[3]), array<f32, 4>(_e7525.member_2[0], _e7525.member_2[1], _e7525.member_2[2], _e7525.member_2[3]));
                                                        let _e7804 = local.member[0u];
                                                        let _e7807 = local.member_1[0u];
                                                        let _e7810 = local.member_2[0u];
                                                        if select(true, select(true, false, (_e7807 > _e7810)), (_e7804 > _e7810)) {
                                                            let _e7815 = (_e7807 >= _e7804);
                                                            if _e7815 {
                                                                phi_12717_ = f32();
                                                                phi_12718_ = false;
                                                            } else {
                                                                if ((_e7804 - _e7807) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_12715_ = (((_e7804 - _e7810) / (_e7804 - _e7807)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_12716_ = false;
                                                                } else {
                                                                    phi_12715_ = f32();
                                                                    phi_12716_ = true;
                                                                }
                                                                let _e7826 = phi_12715_;
                                                                let _e7828 = phi_12716_;
                                                                phi_12717_ = _e7826;
                                                                phi_12718_ = _e7828;
                                                            }
                                                            let _e7830 = phi_12717_;
                                                            let _e7832 = phi_12718_;
                                                            phi_12719_ = _e7830;
                                                            phi_12720_ = _e7815;
                                                            phi_12721_ = _e7832;
                                                        } else {
                                                            phi_12719_ = f32();
                                                            phi_12720_ = true;
                                                            phi_12721_ = false;
                                                        }
                                                        let _e7834 = phi_12719_;
                                                        let _e7836 = phi_12720_;
                                                        let _e7838 = phi_12721_;
                                                        let _e7841 = select(_e7834, select(_e7246, 2f, _e7836), select(_e7838, true, _e7836));
                                                        let _e7844 = local.member[1u];
                                                        let _e7847 = local.member_1[1u];
                                                        let _e7850 = local.member_2[1u];
                                                        if select(true, select(true, false, (_e7847 > _e7850)), (_e7844 > _e7850)) {
                                                            let _e7855 = (_e7847 >= _e7844);
                                                            if _e7855 {
                                                                phi_12785_ = f32();
                                                                phi_12786_ = false;
                                                            } else {
                                                                if ((_e7844 - _e7847) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_12783_ = (((_e7844 - _e7850) / (_e7844 - _e7847)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_12784_ = false;
                                                                } else {
                                                                    phi_12783_ = f32();
                                                                    phi_12784_ = true;
                                                                }
                                                                let _e7866 = phi_12783_;
                                                                let _e7868 = phi_12784_;
                                                                phi_12785_ = _e7866;
                                                                phi_12786_ = _e7868;
                                                            }
                                                            let _e7870 = phi_12785_;
                                                            let _e7872 = phi_12786_;
                                                            phi_12787_ = _e7870;
                                                            phi_12788_ = _e7855;
                                                            phi_12789_ = _e7872;
                                                        } else {
                                                            phi_12787_ = f32();
                                                            phi_12788_ = true;
                                                            phi_12789_ = false;
                                                        }
                                                        let _e7874 = phi_12787_;
                                                        let _e7876 = phi_12788_;
                                                        let _e7878 = phi_12789_;
                                                        let _e7881 = select(_e7874, select(_e7246, 2f, _e7876), select(_e7878, true, _e7876));
                                                        let _e7883 = select(_e7881, _e7841, (_e7841 < _e7881));
                                                        let _e7886 = local.member[2u];
                                                        let _e7889 = local.member_1[2u];
                                                        let _e7892 = local.member_2[2u];
                                                        if select(true, select(true, false, (_e7889 > _e7892)), (_e7886 > _e7892)) {
                                                            let _e7897 = (_e7889 >= _e7886);
                                                            if _e7897 {
                                                                phi_12858_ = f32();
                                                                phi_12859_ = false;
                                                            } else {
                                                                if ((_e7886 - _e7889) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_12856_ = (((_e7886 - _e7892) / (_e7886 - _e7889)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_12857_ = false;
                                                                } else {
                                                                    phi_12856_ = f32();
                                                                    phi_12857_ = true;
                                                                }
                                                                let _e7908 = phi_12856_;
                                                                let _e7910 = phi_12857_;
                                                                phi_12858_ = _e7908;
                                                                phi_12859_ = _e7910;
                                                            }
                                                            let _e7912 = phi_12858_;
                                                            let _e7914 = phi_12859_;
                                                            phi_12860_ = _e7912;
                                                            phi_12861_ = _e7897;
                                                            phi_12862_ = _e7914;
                                                        } else {
                                                            phi_12860_ = f32();
                                                            phi_12861_ = true;
                                                            phi_12862_ = false;
                                                        }
                                                        let _e7916 = phi_12860_;
                                                        let _e7918 = phi_12861_;
                                                        let _e7920 = phi_12862_;
                                                        let _e7923 = select(_e7916, select(_e7246, 2f, _e7918), select(_e7920, true, _e7918));
                                                        let _e7926 = local.member[3u];
                                                        let _e7929 = local.member_1[3u];
                                                        let _e7932 = local.member_2[3u];
                                                        if select(true, select(true, false, (_e7929 > _e7932)), (_e7926 > _e7932)) {
                                                            let _e7937 = (_e7929 >= _e7926);
                                                            if _e7937 {
                                                                phi_12926_ = f32();
                                                                phi_12927_ = false;
                                                            } else {
                                                                if ((_e7926 - _e7929) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_12924_ = (((_e7926 - _e7932) / (_e7926 - _e7929)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_12925_ = false;
                                                                } else {
                                                                    phi_12924_ = f32();
                                                                    phi_12925_ = true;
                                                                }
                                                                let _e7948 = phi_12924_;
                                                                let _e7950 = phi_12925_;
                                                                phi_12926_ = _e7948;
                                                                phi_12927_ = _e7950;
                                                            }
                                                            let _e7952 = phi_12926_;
                                                            let _e7954 = phi_12927_;
                                                            phi_12928_ = _e7952;
                                                            phi_12929_ = _e7937;
                                                            phi_12930_ = _e7954;
                                                        } else {
                                                            phi_12928_ = f32();
                                                            phi_12929_ = true;
                                                            phi_12930_ = false;
                                                        }
                                                        let _e7956 = phi_12928_;
                                                        let _e7958 = phi_12929_;
                                                        let _e7960 = phi_12930_;
                                                        let _e7963 = select(_e7956, select(_e7246, 2f, _e7958), select(_e7960, true, _e7958));
                                                        let _e7965 = select(_e7963, _e7923, (_e7923 < _e7963));
                                                        let _e7967 = select(_e7965, _e7883, (_e7883 < _e7965));
                                                        let _e7969 = select(_e7246, _e7967, (_e7967 > _e7246));
                                                        let _e7970 = (_e7969 > _e7023.member_1);
                                                        if _e7970 {
                                                            phi_13459_ = f32();
                                                            phi_13460_ = f32();
                                                            phi_13461_ = false;
                                                        } else {
                                                            let _e7971 = (_e7969 - _e7246);
                                                            phi_13459_ = select((_e7023.member_1 - _e7246), select(0f, (_e7545 + _e7545), select(select(true, false, (_e7971 <= (_e7250 * 0.25f))), true, (_e7971 <= _e7241))), _e7254);
                                                            phi_13460_ = _e7971;
                                                            phi_13461_ = true;
                                                        }
                                                        let _e7982 = phi_13459_;
                                                        let _e7984 = phi_13460_;
                                                        let _e7986 = phi_13461_;
                                                        phi_13463_ = _e7969;
                                                        phi_13464_ = _e7982;
                                                        phi_13465_ = _e7984;
                                                        phi_13467_ = _e7986;
                                                        phi_13468_ = _e7970;
                                                        phi_13470_ = false;
                                                    } else {
                                                        phi_13463_ = f32();
                                                        phi_13464_ = f32();
                                                        phi_13465_ = f32();
                                                        phi_13467_ = false;
                                                        phi_13468_ = false;
                                                        phi_13470_ = true;
                                                    }
                                                    let _e7988 = phi_13463_;
                                                    let _e7990 = phi_13464_;
                                                    let _e7992 = phi_13465_;
                                                    let _e7994 = phi_13467_;
                                                    let _e7996 = phi_13468_;
                                                    let _e7998 = phi_13470_;
                                                    phi_13471_ = _e7988;
                                                    phi_13472_ = _e7990;
                                                    phi_13473_ = _e7992;
                                                    phi_13475_ = false;
                                                    phi_13476_ = _e7994;
                                                    phi_13477_ = _e7996;
                                                    phi_13479_ = _e7998;
                                                } else {
                                                    phi_13471_ = f32();
                                                    phi_13472_ = f32();
                                                    phi_13473_ = f32();
                                                    phi_13475_ = true;
                                                    phi_13476_ = false;
                                                    phi_13477_ = false;
                                                    phi_13479_ = false;
                                                }
                                                let _e8000 = phi_13471_;
                                                let _e8002 = phi_13472_;
                                                let _e8004 = phi_13473_;
                                                let _e8006 = phi_13475_;
                                                let _e8008 = phi_13476_;
                                                let _e8010 = phi_13477_;
                                                let _e8012 = phi_13479_;
                                                phi_13480_ = _e8000;
                                                phi_13481_ = _e8002;
                                                phi_13482_ = _e8004;
                                                phi_13484_ = _e8006;
                                                phi_13485_ = _e8008;
                                                phi_13486_ = _e8010;
                                                phi_13488_ = _e8012;
                                            } else {
                                                phi_13480_ = f32();
                                                phi_13481_ = f32();
                                                phi_13482_ = f32();
                                                phi_13484_ = true;
                                                phi_13485_ = false;
                                                phi_13486_ = false;
                                                phi_13488_ = false;
                                            }
                                            let _e8014 = phi_13480_;
                                            let _e8016 = phi_13481_;
                                            let _e8018 = phi_13482_;
                                            let _e8020 = phi_13484_;
                                            let _e8022 = phi_13485_;
                                            let _e8024 = phi_13486_;
                                            let _e8026 = phi_13488_;
                                            if _e8020 {
                                                if (_e7246 <= _e7248) {
                                                    let _e8179 = (_e7256 + 1u);
                                                    let _e8180 = (_e8179 > 3u);
                                                    phi_13823_ = _e8179;
                                                    phi_13824_ = f32();
                                                    phi_13825_ = false;
                                                    phi_13826_ = select(true, false, _e8180);
                                                    phi_13827_ = _e8180;
                                                } else {
                                                    let _e8030 = local.member[0u];
                                                    let _e8033 = local.member_1[0u];
                                                    let _e8036 = local.member[0u];
                                                    let _e8042 = local.member_2[0u];
                                                    let _e8043 = ((_e8030 + ((_e8033 - _e8036) * _e7252)) - _e8042);
                                                    let _e8046 = local.member[1u];
                                                    let _e8049 = local.member_1[1u];
                                                    let _e8052 = local.member[1u];
                                                    let _e8058 = local.member_2[1u];
                                                    let _e8059 = ((_e8046 + ((_e8049 - _e8052) * _e7252)) - _e8058);
                                                    let _e8061 = select(_e8059, _e8043, (_e8043 < _e8059));
                                                    let _e8064 = local.member[2u];
                                                    let _e8067 = local.member_1[2u];
                                                    let _e8070 = local.member[2u];
                                                    let _e8076 = local.member_2[2u];
                                                    let _e8077 = ((_e8064 + ((_e8067 - _e8070) * _e7252)) - _e8076);
                                                    let _e8080 = local.member[3u];
                                                    let _e8083 = local.member_1[3u];
                                                    let _e8086 = local.member[3u];
                                                    let _e8092 = local.member_2[3u];
                                                    let _e8093 = ((_e8080 + ((_e8083 - _e8086) * _e7252)) - _e8092);
                                                    let _e8095 = select(_e8093, _e8077, (_e8077 < _e8093));
                                                    let _e8097 = select(_e8095, _e8061, (_e8061 < _e8095));
                                                    let _e8100 = local_1.member[0u];
                                                    let _e8103 = local_1.member_1[0u];
                                                    let _e8106 = local_1.member[0u];
                                                    let _e8112 = local_1.member_2[0u];
                                                    let _e8113 = ((_e8100 + ((_e8103 - _e8106) * _e7246)) - _e8112);
                                                    let _e8116 = local_1.member[1u];
                                                    let _e8119 = local_1.member_1[1u];
                                                    let _e8122 = local_1.member[1u];
                                                    let _e8128 = local_1.member_2[1u];
                                                    let _e8129 = ((_e8116 + ((_e8119 - _e8122) * _e7246)) - _e8128);
                                                    let _e8131 = select(_e8129, _e8113, (_e8113 < _e8129));
                                                    let _e8134 = local_1.member[2u];
                                                    let _e8137 = local_1.member_1[2u];
                                                    let _e8140 = local_1.member[2u];
                                                    let _e8146 = local_1.member_2[2u];
                                                    let _e8147 = ((_e8134 + ((_e8137 - _e8140) * _e7246)) - _e8146);
                                                    let _e8150 = local_1.member[3u];
                                                    let _e8153 = local_1.member_1[3u];
                                                    let _e8156 = local_1.member[3u];
                                                    let _e8162 = local_1.member_2[3u];
                                                    let _e8163 = ((_e8150 + ((_e8153 - _e8156) * _e7246)) - _e8162);
                                                    let _e8165 = select(_e8163, _e8147, (_e8147 < _e8163));
                                                    let _e8167 = select(_e8165, _e8131, (_e8131 < _e8165));
                                                    if (_e8167 > 0f) {
                                                        phi_13821_ = 0.5f;
                                                    } else {
                                                        let _e8171 = (0.95f * (_e8097 / (_e8097 - _e8167)));
                                                        phi_13821_ = select(0.0625f, select(0.9f, _e8171, (_e8171 < 0.9f)), (_e8171 > 0.0625f));
                                                    }
                                                    let _e8177 = phi_13821_;
                                                    phi_13823_ = u32();
                                                    phi_13824_ = (_e7545 * _e8177);
                                                    phi_13825_ = true;
                                                    phi_13826_ = false;
                                                    phi_13827_ = false;
                                                }
                                                let _e8183 = phi_13823_;
                                                let _e8185 = phi_13824_;
                                                let _e8187 = phi_13825_;
                                                let _e8189 = phi_13826_;
                                                let _e8191 = phi_13827_;
                                                phi_13828_ = _e8183;
                                                phi_13829_ = _e7248;
                                                phi_13830_ = _e8185;
                                                phi_13831_ = _e7250;
                                                phi_13832_ = _e7252;
                                                phi_13833_ = _e7254;
                                                phi_13834_ = _e7256;
                                                phi_13835_ = _e8187;
                                                phi_13836_ = _e8189;
                                                phi_13837_ = _e8191;
                                                phi_13838_ = false;
                                                phi_13840_ = false;
                                            } else {
                                                phi_13828_ = u32();
                                                phi_13829_ = _e8014;
                                                phi_13830_ = _e8016;
                                                phi_13831_ = _e8018;
                                                phi_13832_ = _e7246;
                                                phi_13833_ = true;
                                                phi_13834_ = 0u;
                                                phi_13835_ = _e8022;
                                                phi_13836_ = false;
                                                phi_13837_ = false;
                                                phi_13838_ = _e8024;
                                                phi_13840_ = _e8026;
                                            }
                                            let _e8193 = phi_13828_;
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
                                            let _e8215 = phi_13840_;
                                            if _e8207 {
                                                let _e8216 = (_e8201 + _e8197);
                                                let _e8218 = select(_e8195, _e8216, (_e8216 > _e8195));
                                                let _e8220 = select(_e7023.member_1, _e8218, (_e8218 < _e7023.member_1));
                                                let _e8223 = select(((_e8220 - _e8201) > _e7241), true, !(_e7254));
                                                phi_13868_ = _e8220;
                                                phi_13869_ = _e8195;
                                                phi_13870_ = _e8199;
                                                phi_13871_ = _e8201;
                                                phi_13872_ = _e8203;
                                                phi_13873_ = _e8205;
                                                phi_13874_ = _e8223;
                                                phi_13875_ = select(true, false, _e8223);
                                                phi_13876_ = false;
                                                phi_13877_ = false;
                                                phi_13879_ = false;
                                            } else {
                                                phi_13868_ = _e7246;
                                                phi_13869_ = _e7248;
                                                phi_13870_ = _e7250;
                                                phi_13871_ = _e7252;
                                                phi_13872_ = _e7254;
                                                phi_13873_ = _e8193;
                                                phi_13874_ = _e8209;
                                                phi_13875_ = false;
                                                phi_13876_ = _e8211;
                                                phi_13877_ = _e8213;
                                                phi_13879_ = _e8215;
                                            }
                                            let _e8226 = phi_13868_;
                                            let _e8228 = phi_13869_;
                                            let _e8230 = phi_13870_;
                                            let _e8232 = phi_13871_;
                                            let _e8234 = phi_13872_;
                                            let _e8236 = phi_13873_;
                                            let _e8238 = phi_13874_;
                                            let _e8240 = phi_13875_;
                                            let _e8242 = phi_13876_;
                                            let _e8244 = phi_13877_;
                                            let _e8246 = phi_13879_;
                                            phi_11701_ = _e8226;
                                            phi_11703_ = _e8228;
                                            phi_11705_ = _e8230;
                                            phi_11707_ = _e8232;
                                            phi_11709_ = _e8234;
                                            phi_11711_ = _e8236;
                                            phi_13880_ = _e8195;
                                            phi_13882_ = _e8238;
                                            phi_13883_ = _e8240;
                                            phi_13884_ = _e8242;
                                            phi_13885_ = _e8244;
                                            phi_13887_ = false;
                                            phi_13888_ = _e8246;
                                        } else {
                                            phi_11701_ = f32();
                                            phi_11703_ = f32();
                                            phi_11705_ = f32();
                                            phi_11707_ = f32();
                                            phi_11709_ = bool();
                                            phi_11711_ = u32();
                                            phi_13880_ = f32();
                                            phi_13882_ = false;
                                            phi_13883_ = false;
                                            phi_13884_ = false;
                                            phi_13885_ = false;
                                            phi_13887_ = true;
                                            phi_13888_ = false;
                                        }
                                        let _e8248 = phi_11701_;
                                        let _e8250 = phi_11703_;
                                        let _e8252 = phi_11705_;
                                        let _e8254 = phi_11707_;
                                        let _e8256 = phi_11709_;
                                        let _e8258 = phi_11711_;
                                        let _e8260 = phi_13880_;
                                        let _e8262 = phi_13882_;
                                        let _e8264 = phi_13883_;
                                        let _e8266 = phi_13884_;
                                        let _e8268 = phi_13885_;
                                        let _e8270 = phi_13887_;
                                        let _e8272 = phi_13888_;
                                        local_89 = _e8264;
                                        local_90 = _e8266;
                                        local_91 = _e8264;
                                        local_92 = _e8268;
                                        local_93 = _e8264;
                                        local_94 = _e8270;
                                        local_95 = _e8264;
                                        local_96 = _e8272;
                                        local_98 = _e8264;
                                        local_99 = _e8260;
                                        continue;
                                        continuing {
                                            phi_11697_ = type_9(select(_e7244.member, (_e7244.member + 1u), _e7259), select(_e7244.member_1, _e7244.member_1, _e7259));
                                            phi_11700_ = _e8248;
                                            phi_11702_ = _e8250;
                                            phi_11704_ = _e8252;
                                            phi_11706_ = _e8254;
                                            phi_11708_ = _e8256;
                                            phi_11710_ = _e8258;
                                            break if !(_e8262);
                                        }
                                    }
                                    let _e8275 = local_89;
                                    let _e8277 = local_90;
                                    let _e8278 = select(_e8277, false, _e8275);
                                    let _e8280 = local_91;
                                    let _e8282 = local_92;
                                    let _e8285 = local_93;
                                    let _e8287 = local_94;
                                    let _e8290 = local_95;
                                    let _e8292 = local_96;
                                    let _e8298 = local_97;
                                    let _e8300 = select(select(_e8282, false, _e8280), false, _e8278);
                                    let _e8302 = local_98;
                                    let _e8309 = select(select(_e8302, false, _e8278), false, _e8300);
                                    let _e8314 = local_99;
                                    let _e8316 = local_100;
                                    let _e8318 = select(select(select(select(_e8287, false, _e8285), false, _e8278), false, _e8300), true, _e8309);
                                    let _e8325 = select(select(select(select(select(_e8292, false, _e8290), false, _e8278), false, _e8300), false, _e8309), false, _e8318);
                                    let _e8330 = select(select(select(select(_e8278, true, _e8300), false, _e8309), false, _e8318), true, _e8325);
                                    let _e8333 = (select(select(type_30().member, 1u, _e8318), select(select(select(type_30().member, 1u, _e8278), 0u, _e8300), 0u, _e8325), _e8330) != 0u);
                                    phi_13956_ = select(select(type_30().member_1, select(_e8316, _e8314, _e8309), _e8318), select(select(select(type_30().member_1, _e8298, _e8278), type_30().member_1, _e8300), type_30().member_1, _e8325), _e8330);
                                    phi_13957_ = select(true, false, _e8333);
                                    phi_13958_ = _e8333;
                                    phi_13959_ = false;
                                    phi_13960_ = false;
                                    phi_13961_ = false;
                                } else {
                                    phi_13956_ = f32();
                                    phi_13957_ = _e7031;
                                    phi_13958_ = false;
                                    phi_13959_ = _e7033;
                                    phi_13960_ = _e7035;
                                    phi_13961_ = _e7037;
                                }
                                let _e8336 = phi_13956_;
                                let _e8338 = phi_13957_;
                                let _e8340 = phi_13958_;
                                let _e8342 = phi_13959_;
                                let _e8344 = phi_13960_;
                                let _e8346 = phi_13961_;
                                phi_13962_ = _e7023;
                                phi_13963_ = _e7025;
                                phi_13964_ = _e8336;
                                phi_13965_ = _e7027;
                                phi_13966_ = _e8338;
                                phi_13967_ = _e8340;
                                phi_13968_ = false;
                                phi_13969_ = _e8342;
                                phi_13970_ = _e8344;
                                phi_13971_ = _e8346;
                            } else {
                                phi_13962_ = type_45();
                                phi_13963_ = bool();
                                phi_13964_ = f32();
                                phi_13965_ = type_45();
                                phi_13966_ = false;
                                phi_13967_ = false;
                                phi_13968_ = true;
                                phi_13969_ = false;
                                phi_13970_ = false;
                                phi_13971_ = false;
                            }
                            let _e8348 = phi_13962_;
                            let _e8350 = phi_13963_;
                            let _e8352 = phi_13964_;
                            let _e8354 = phi_13965_;
                            let _e8356 = phi_13966_;
                            let _e8358 = phi_13967_;
                            let _e8360 = phi_13968_;
                            let _e8362 = phi_13969_;
                            let _e8364 = phi_13970_;
                            let _e8366 = phi_13971_;
                            local_101 = _e8358;
                            local_102 = _e8350;
                            local_103 = _e8348;
                            local_104 = _e8352;
                            local_105 = _e8352;
                            local_106 = _e8352;
                            local_110 = _e8360;
                            local_111 = _e8362;
                            local_112 = _e8364;
                            local_113 = _e8366;
                            local_107 = _e8358;
                            local_108 = _e8354;
                            continue;
                            continuing {
                                phi_9692_ = type_9(select(_e5958.member, (_e5958.member + 1u), _e5961), select(_e5958.member_1, _e5958.member_1, _e5961));
                                break if !(_e8356);
                            }
                        }
                        let _e8369 = local_101;
                        if _e8369 {
                            let _e8371 = local_102;
                            if _e8371 {
                                let _e8373 = local_103;
                                let _e8376 = local_104;
                                let _e8378 = ((_e8373.member_1 - _e8376) <= _e5922);
                                let _e8383 = local_105;
                                phi_13987_ = type_30(select(type_30().member, 1u, _e8378), select(type_30().member_1, _e8383, _e8378));
                                phi_13988_ = select(true, false, _e8378);
                            } else {
                                phi_13987_ = type_30();
                                phi_13988_ = true;
                            }
                            let _e8388 = phi_13987_;
                            let _e8390 = phi_13988_;
                            let _e8395 = local_106;
                            phi_13994_ = type_30(select(_e8388.member, 2u, _e8390), select(_e8388.member_1, _e8395, _e8390));
                            phi_13995_ = false;
                            phi_13996_ = false;
                            phi_13997_ = false;
                            phi_13998_ = false;
                        } else {
                            phi_13994_ = type_30();
                            let _e9043 = local_110;
                            phi_13995_ = _e9043;
                            let _e9046 = local_111;
                            phi_13996_ = _e9046;
                            let _e9049 = local_112;
                            phi_13997_ = _e9049;
                            let _e9052 = local_113;
                            phi_13998_ = _e9052;
                        }
                        let _e8399 = phi_13994_;
                        let _e8401 = phi_13995_;
                        let _e8403 = phi_13996_;
                        let _e8405 = phi_13997_;
                        let _e8407 = phi_13998_;
                        let _e8414 = select(_e8403, false, _e8401);
                        let _e8418 = local_107;
                        let _e8425 = select(select(_e8405, false, _e8401), false, _e8414);
                        let _e8431 = select(select(select(_e8407, false, _e8401), false, _e8414), false, _e8425);
                        let _e8435 = local_108;
                        let _e8439 = select(select(_e8414, true, _e8425), true, _e8431);
                        phi_14040_ = type_30(select(_e8399.member, select(select(select(type_30().member, 0u, _e8414), 0u, _e8425), 1u, _e8431), _e8439), select(_e8399.member_1, select(select(select(type_30().member_1, type_30().member_1, _e8414), type_30().member_1, _e8425), _e8435.member, _e8431), _e8439));
                        phi_14041_ = type_30(select(type_30().member, 0u, _e8401), select(type_30().member_1, type_30().member_1, _e8401));
                        phi_14042_ = select(select(select(select(select(_e8418, false, _e8401), false, _e8414), false, _e8425), false, _e8431), true, _e8439);
                    }
                    let _e8450 = phi_14040_;
                    let _e8452 = phi_14041_;
                    let _e8454 = phi_14042_;
                    let _e8457 = select(_e8452.member, _e8450.member, _e8454);
                    let _e8460 = select(_e8452.member_1, _e8450.member_1, _e8454);
                    let _e8466 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e8460 > _e5093)), (_e8457 == 1u))));
                    switch bitcast<i32>(_e8457) {
                        case 0: {
                            phi_14086_ = type_31(0u, _e8466, array<u32, 2>(0u, 0u), false);
                            break;
                        }
                        case 1: {
                            let _e8470 = function_4(_e8460);
                            phi_14086_ = type_31(0u, _e8466, _e8470, true);
                            break;
                        }
                        case 2: {
                            let _e8468 = function_4(_e8460);
                            phi_14086_ = type_31(1u, _e8466, _e8468, true);
                            break;
                        }
                        default: {
                            phi_14086_ = type_31();
                            break;
                        }
                    }
                    let _e8474 = phi_14086_;
                    let _e8478 = params.member.member.member_12;
                    let _e8479 = bitcast<u32>(_e8478);
                    if (_e8474.member_2[0] == select((_e8479 << bitcast<u32>(29i)), 0u, ((_e8479 & 2147483647u) < 8388608u))) {
                        let _e8489 = params.member.member.member_12;
                        let _e8490 = bitcast<u32>(_e8489);
                        let _e8491 = (_e8490 & 2147483647u);
                        phi_14126_ = (_e8474.member_2[1] == select(((_e8490 ^ _e8491) | ((_e8491 >> bitcast<u32>(3i)) + 939524096u)), 0u, (_e8491 < 8388608u)));
                    } else {
                        phi_14126_ = false;
                    }
                    let _e8501 = phi_14126_;
                    let _e8503 = params.member.member.member_1;
                    if ((_e8503 & 128u) != 0u) {
                        phi_14142_ = true;
                    } else {
                        let _e8507 = params.member.member.member_1;
                        phi_14142_ = select(false, _e8501, ((_e8507 & 64u) != 0u));
                    }
                    let _e8512 = phi_14142_;
                    phi_14161_ = type_31(select(1u, _e8474.member, select(true, select(true, false, _e8512), _e8474.member_3)), _e8474.member_1, _e8474.member_2, _e8474.member_3);
                } else {
                    phi_14161_ = _e5087;
                }
                let _e8523 = phi_14161_;
                phi_14162_ = _e8523;
                phi_14163_ = type_9(_e244, _e247);
            } else {
                phi_14162_ = type_31(0u, 0u, array<u32, 2>(0u, 0u), false);
                phi_14163_ = type_9(0u, 0u);
            }
            let _e8525 = phi_14162_;
            let _e8527 = phi_14163_;
            let _e8532 = (_e8525.member != 0u);
            let _e8535 = select(false, !(_e8532), _e8525.member_3);
            if _e8535 {
                let _e8539 = (_e8525.member_2[1] >> bitcast<u32>(20i));
                if (_e8539 <= 896u) {
                    phi_14194_ = 0u;
                } else {
                    phi_14194_ = ((((_e8539 - 896u) << bitcast<u32>(23i)) | ((_e8525.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e8525.member_2[0] >> bitcast<u32>(29i)));
                }
                let _e8554 = phi_14194_;
                let _e8556 = atomicMin((&earliest.member[0u]), _e8554);
            }
            let _e8559 = params.member.member.member_1;
            if ((_e8559 & 16u) != 0u) {
                if (_e160 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e8535 {
                    let _e8565 = atomicAdd((&counters[0u]), 1u);
                    phi_14216_ = _e8565;
                } else {
                    phi_14216_ = 0u;
                }
                let _e8567 = phi_14216_;
                workgroupBarrier();
                if (_e160 == 0u) {
                    let _e8570 = atomicLoad((&counters[0u]));
                    if (_e8570 > 0u) {
                        let _e8573 = atomicAdd((&contacts.member[0u]), _e8570);
                        atomicStore((&counters[1u]), _e8573);
                    }
                }
                workgroupBarrier();
                let _e8576 = atomicLoad((&counters[1u]));
                let _e8577 = (_e8576 + _e8567);
                if _e8535 {
                    let _e8580 = params.member.member_1.member_3;
                    let _e8582 = params.member.member_2.member.member;
                    if (_e8577 < _e8580) {
                        let _e8584 = (7u * _e8577);
                        atomicStore((&contacts.member[(4u + _e8584)]), _e8582);
                        atomicStore((&contacts.member[(_e8584 + 5u)]), _e8525.member);
                        atomicStore((&contacts.member[(_e8584 + 6u)]), _e8527.member);
                        atomicStore((&contacts.member[(_e8584 + 7u)]), _e8527.member_1);
                        atomicStore((&contacts.member[(_e8584 + 8u)]), _e8525.member_2[0]);
                        atomicStore((&contacts.member[(_e8584 + 9u)]), _e8525.member_2[1]);
                        atomicStore((&contacts.member[(_e8584 + 10u)]), _e8525.member_1);
                    }
                }
            }
            workgroupBarrier();
            if (_e160 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e8532 {
                let _e8608 = atomicAdd((&counters[0u]), 1u);
                phi_14282_ = _e8608;
            } else {
                phi_14282_ = 0u;
            }
            let _e8610 = phi_14282_;
            workgroupBarrier();
            if (_e160 == 0u) {
                let _e8613 = atomicLoad((&counters[0u]));
                if (_e8613 > 0u) {
                    let _e8616 = atomicAdd((&undecided.member[0u]), _e8613);
                    atomicStore((&counters[1u]), _e8616);
                }
            }
            workgroupBarrier();
            let _e8619 = atomicLoad((&counters[1u]));
            let _e8620 = (_e8619 + _e8610);
            if _e8532 {
                let _e8622 = params.member.member_2.member.member_1;
                if (_e8620 < _e8622) {
                    let _e8624 = (2u * _e8620);
                    atomicStore((&undecided.member[(4u + _e8624)]), _e8527.member);
                    atomicStore((&undecided.member[(_e8624 + 5u)]), _e8527.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_966_ = type_9(select(_e215.member, (_e215.member + 1u), _e218), select(_e215.member_1, _e215.member_1, _e218));
            break if !(_e231);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_15(id, n, lane);
}
