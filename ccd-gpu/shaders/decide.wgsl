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
    member_1: array<u32, 4>,
}

struct type_21 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_23 {
    member: array<type_21>,
}

struct type_26 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_27 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
    member_2: array<f32, 4>,
}

struct type_28 {
    member: type_26,
    member_1: f32,
}

struct type_29 {
    member: u32,
    member_1: f32,
}

struct type_30 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_33 {
    member: array<f32, 4>,
    member_1: f32,
    member_2: f32,
    member_3: f32,
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
    member: f32,
    member_1: f32,
    member_2: bool,
}

struct type_48 {
    member: array<atomic<u32>>,
}

@group(0) @binding(4) 
var<storage> input: type_11;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(1) 
var<storage> paths: type_23;
@group(0) @binding(3) 
var<storage> elements: type_11;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_48;
@group(0) @binding(0) 
var<storage> params: type_38;
@group(0) @binding(2) 
var<storage> positions: type_11;
@group(0) @binding(6) 
var<storage, read_write> undecided: type_48;
@group(0) @binding(7) 
var<storage, read_write> earliest: type_48;

fn function_(param: f32, param_1: f32) -> f32 {
    return select(param, param_1, select((param_1 >= param), true, (param != param)));
}

fn function_1(param_2: array<f32, 3>, param_3: array<f32, 3>) -> array<f32, 3> {
    let _e24 = ((((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])) < (((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])));
    return array<f32, 3>(select(param_2[0], param_3[0], _e24), select(param_2[1], param_3[1], _e24), select(param_2[2], param_3[2], _e24));
}

fn function_2(param_4: array<f32, 3>, param_5: array<f32, 3>, param_6: array<f32, 3>, param_7: u32) -> array<f32, 3> {
    var phi_756_: array<array<f32, 3>, 4>;

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
        phi_756_ = array<array<f32, 3>, 4>(array<f32, 3>((param_4[0] - (param_5[0] * _e155)), (param_4[1] - (param_5[1] * _e155)), (param_4[2] - (param_5[2] * _e155))), array<f32, 3>((param_4[0] - (param_6[0] * _e195)), (param_4[1] - (param_6[1] * _e195)), (param_4[2] - (param_6[2] * _e195))), array<f32, 3>((_e9 - (param_6[0] * _e232)), (_e12 - (param_6[1] * _e232)), (_e15 - (param_6[2] * _e232))), array<f32, 3>((_e245 - (param_5[0] * _e275)), (_e248 - (param_5[1] * _e275)), (_e251 - (param_5[2] * _e275))));
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
        phi_756_ = array<array<f32, 3>, 4>(array<f32, 3>((param_4[0] - (param_5[0] * _e74)), (param_4[1] - (param_5[1] * _e74)), (param_4[2] - (param_5[2] * _e74))), array<f32, 3>((param_4[0] - (param_6[0] * _e114)), (param_4[1] - (param_6[1] * _e114)), (param_4[2] - (param_6[2] * _e114))), _e47, _e47);
    }
    let _e288 = phi_756_;
    let _e291 = function_1(_e288[0], _e288[1]);
    let _e293 = function_1(_e291, _e288[2]);
    let _e295 = function_1(_e293, _e288[3]);
    return _e295;
}

fn function_3(param_8: array<f32, 3>, param_9: array<f32, 3>, param_10: array<f32, 3>, param_11: u32) -> array<f32, 3> {
    var phi_384_: bool;
    var phi_417_: array<f32, 3>;
    var phi_418_: bool;
    var phi_419_: array<f32, 3>;
    var phi_420_: bool;
    var phi_425_: array<f32, 3>;

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
        phi_384_ = select(select(bool(), select(bool(), select(bool(), (_e78 <= 1f), _e91), _e90), _e89), false, select(true, select(true, select(true, false, _e91), _e90), _e89));
    } else {
        let _e80 = (_e74 >= 0f);
        let _e81 = (_e78 >= 0f);
        phi_384_ = select(select(bool(), select(bool(), ((_e74 + _e78) <= 1f), _e81), _e80), false, select(true, select(true, false, _e81), _e80));
    }
    let _e101 = phi_384_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e101 {
            phi_417_ = array<f32, 3>((param_8[0] - ((param_9[0] * _e74) + (param_10[0] * _e78))), (param_8[1] - ((param_9[1] * _e74) + (param_10[1] * _e78))), (param_8[2] - ((param_9[2] * _e74) + (param_10[2] * _e78))));
            phi_418_ = false;
        } else {
            phi_417_ = array<f32, 3>();
            phi_418_ = true;
        }
        let _e129 = phi_417_;
        let _e131 = phi_418_;
        phi_419_ = _e129;
        phi_420_ = _e131;
    } else {
        phi_419_ = array<f32, 3>();
        phi_420_ = true;
    }
    let _e133 = phi_419_;
    let _e135 = phi_420_;
    if _e135 {
        let _e136 = function_2(param_8, param_9, param_10, param_11);
        phi_425_ = _e136;
    } else {
        phi_425_ = _e133;
    }
    let _e138 = phi_425_;
    return _e138;
}

fn function_4(param_12: f32) -> array<u32, 2> {
    let _e7 = bitcast<u32>(param_12);
    let _e8 = (_e7 & 2147483647u);
    let _e9 = (_e8 < 8388608u);
    return array<u32, 2>(select((_e7 << bitcast<u32>(29i)), 0u, _e9), select(((_e7 ^ _e8) | ((_e8 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e9));
}

fn function_5(param_13: ptr<function, type_33>, param_14: f32, param_15: f32, param_16: f32) -> bool {
    var phi_14745_: bool;
    var phi_14746_: bool;
    var phi_14751_: bool;

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
            phi_14745_ = select(bool(), ((_e43 > 0f) == (_e69 > 0f)), _e84);
            phi_14746_ = select(true, false, _e84);
        } else {
            phi_14745_ = bool();
            phi_14746_ = true;
        }
        let _e91 = phi_14745_;
        let _e93 = phi_14746_;
        phi_14751_ = select(_e91, false, _e93);
    } else {
        phi_14751_ = false;
    }
    let _e96 = phi_14751_;
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
    var phi_14237_: type_9;
    var phi_14238_: type_9;
    var phi_14239_: type_9;
    var phi_14240_: type_9;
    var phi_14241_: type_9;
    var phi_14242_: bool;

    let _e24 = ((param_39[1] >> bitcast<u32>(20i)) & 2047u);
    let _e28 = ((param_39[1] & 1048575u) | select(1048576u, 0u, (_e24 == 0u)));
    let _e33 = ((bitcast<i32>(select(1u, _e24, (1u < _e24))) - 1015i) - param_40);
    let _e35 = (bitcast<u32>(_e33) % 32u);
    if (_e33 >= 64i) {
        phi_14241_ = type_9();
        phi_14242_ = true;
    } else {
        let _e37 = (_e33 <= -53i);
        if _e37 {
            phi_14240_ = type_9();
        } else {
            if (_e33 >= 32i) {
                phi_14239_ = type_9((param_39[0] << bitcast<u32>((_e35 & 31u))), 0u);
            } else {
                if (_e33 >= 0i) {
                    phi_14238_ = type_9(((_e28 << bitcast<u32>((_e35 & 31u))) | ((param_39[0] >> bitcast<u32>(1i)) >> bitcast<u32>(((31u - _e35) & 31u)))), (param_39[0] << bitcast<u32>((_e35 & 31u))));
                } else {
                    if (_e33 > -32i) {
                        let _e49 = bitcast<u32>(-(_e33));
                        phi_14237_ = type_9(bitcast<u32>((bitcast<i32>(_e28) >> bitcast<u32>((_e49 & 31u)))), ((param_39[0] >> bitcast<u32>((_e49 & 31u))) | ((_e28 << bitcast<u32>(((31u - _e49) & 31u))) << bitcast<u32>(1i))));
                    } else {
                        phi_14237_ = type_9(0u, (_e28 >> bitcast<u32>(((bitcast<u32>(-(_e33)) - 32u) & 31u))));
                    }
                    let _e67 = phi_14237_;
                    phi_14238_ = _e67;
                }
                let _e83 = phi_14238_;
                phi_14239_ = _e83;
            }
            let _e89 = phi_14239_;
            phi_14240_ = _e89;
        }
        let _e91 = phi_14240_;
        phi_14241_ = _e91;
        phi_14242_ = _e37;
    }
    let _e93 = phi_14241_;
    let _e95 = phi_14242_;
    let _e97 = select(_e93.member, 0u, _e95);
    let _e99 = select(_e93.member_1, 0u, _e95);
    let _e102 = ((param_39[1] >> bitcast<u32>(31i)) != 0u);
    return type_9(select(_e97, (~(_e97) + select(0u, 1u, (_e99 == 0u))), _e102), select(_e99, (~(_e99) + 1u), _e102));
}

fn function_15(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_27;
    var local_1: type_27;
    var local_2: array<type_16, 4>;
    var local_3: array<f32, 4>;
    var local_4: array<f32, 2>;
    var local_5: type_33;
    var local_6: array<f32, 4>;
    var local_7: type_26;
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
    var phi_911_: u32;
    var phi_957_: u32;
    var phi_960_: type_9;
    var phi_1118_: type_20;
    var phi_1532_: type_26;
    var phi_3240_: array<array<array<type_9, 3>, 2>, 4>;
    var phi_3787_: array<array<array<type_9, 3>, 2>, 3>;
    var phi_5082_: type_9;
    var phi_5085_: array<type_9, 4>;
    var phi_5089_: u32;
    var phi_5091_: u32;
    var phi_5311_: bool;
    var phi_5440_: u32;
    var phi_6589_: array<type_9, 2>;
    var phi_6618_: array<type_9, 2>;
    var phi_6647_: array<type_9, 2>;
    var phi_6661_: type_9;
    var phi_6983_: type_9;
    var phi_6984_: type_9;
    var phi_6985_: type_9;
    var phi_6986_: type_9;
    var phi_7100_: bool;
    var phi_7101_: bool;
    var phi_7102_: bool;
    var phi_7107_: u32;
    var phi_7108_: u32;
    var phi_7109_: bool;
    var phi_7110_: u32;
    var phi_7111_: bool;
    var phi_7112_: u32;
    var phi_7113_: bool;
    var phi_7118_: u32;
    var phi_7130_: bool;
    var phi_7131_: bool;
    var phi_7132_: bool;
    var phi_7133_: u32;
    var phi_7134_: u32;
    var phi_7135_: bool;
    var phi_7470_: array<type_9, 4>;
    var phi_7471_: u32;
    var phi_7472_: array<type_9, 4>;
    var phi_7474_: u32;
    var phi_7475_: u32;
    var phi_7476_: array<type_9, 4>;
    var phi_7478_: u32;
    var phi_7479_: u32;
    var phi_7480_: array<type_9, 4>;
    var phi_7482_: bool;
    var phi_7483_: u32;
    var phi_7484_: u32;
    var phi_7485_: bool;
    var phi_7486_: bool;
    var phi_7487_: u32;
    var phi_7488_: u32;
    var phi_7489_: bool;
    var phi_7784_: array<type_9, 4>;
    var phi_7785_: array<type_9, 4>;
    var phi_7786_: u32;
    var phi_7787_: u32;
    var phi_7788_: bool;
    var phi_7793_: array<type_9, 4>;
    var phi_7794_: u32;
    var phi_7795_: u32;
    var phi_7796_: bool;
    var phi_7797_: bool;
    var phi_7798_: bool;
    var phi_7799_: array<type_9, 4>;
    var phi_7801_: u32;
    var phi_7802_: u32;
    var phi_7803_: bool;
    var phi_7804_: bool;
    var phi_7805_: u32;
    var phi_7806_: u32;
    var phi_7807_: bool;
    var phi_7808_: bool;
    var phi_7809_: bool;
    var phi_5086_: array<type_9, 4>;
    var phi_5090_: u32;
    var phi_5092_: u32;
    var phi_7810_: u32;
    var phi_7811_: bool;
    var phi_7812_: bool;
    var phi_7813_: u32;
    var phi_7814_: u32;
    var phi_7815_: bool;
    var phi_7816_: bool;
    var phi_7817_: bool;
    var phi_7818_: bool;
    var phi_7819_: bool;
    var local_42: bool;
    var local_43: bool;
    var local_44: bool;
    var local_45: bool;
    var local_46: bool;
    var local_47: bool;
    var local_48: bool;
    var local_49: bool;
    var local_50: bool;
    var local_51: bool;
    var local_52: u32;
    var local_53: array<type_9, 4>;
    var local_54: array<type_9, 4>;
    var local_55: array<type_9, 4>;
    var local_56: u32;
    var local_57: u32;
    var local_58: u32;
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
    var phi_8194_: bool;
    var phi_8195_: bool;
    var phi_8196_: bool;
    var phi_8197_: bool;
    var local_69: bool;
    var local_70: u32;
    var local_71: u32;
    var local_72: u32;
    var local_73: u32;
    var phi_8229_: type_9;
    var phi_8230_: bool;
    var phi_8231_: bool;
    var phi_8271_: array<u32, 2>;
    var phi_8277_: type_30;
    var phi_8284_: type_30;
    var phi_8285_: bool;
    var phi_8286_: type_30;
    var phi_8287_: bool;
    var phi_8558_: bool;
    var phi_8652_: type_28;
    var phi_8653_: bool;
    var phi_8654_: type_28;
    var phi_8655_: bool;
    var phi_8656_: type_28;
    var phi_8657_: bool;
    var phi_8662_: type_28;
    var phi_9387_: bool;
    var phi_9399_: f32;
    var phi_9470_: type_14;
    var phi_9473_: f32;
    var phi_9471_: type_14;
    var phi_9514_: type_15;
    var phi_9474_: f32;
    var local_74: f32;
    var phi_9527_: f32;
    var phi_9558_: type_9;
    var phi_9561_: u32;
    var phi_9628_: u32;
    var phi_9629_: u32;
    var phi_9562_: u32;
    var phi_9630_: u32;
    var phi_9686_: type_9;
    var phi_9842_: type_44;
    var phi_9843_: bool;
    var phi_9844_: type_44;
    var phi_9845_: bool;
    var phi_9876_: type_9;
    var phi_9879_: f32;
    var phi_9881_: f32;
    var phi_9883_: f32;
    var phi_9993_: bool;
    var phi_10000_: f32;
    var phi_10001_: bool;
    var phi_9880_: f32;
    var phi_9882_: f32;
    var phi_9884_: f32;
    var phi_10002_: f32;
    var phi_10003_: bool;
    var phi_10004_: bool;
    var local_75: bool;
    var local_76: f32;
    var local_77: f32;
    var phi_10009_: f32;
    var phi_10025_: type_9;
    var phi_10028_: f32;
    var phi_10093_: f32;
    var phi_10094_: bool;
    var phi_10095_: bool;
    var phi_10096_: bool;
    var phi_10097_: f32;
    var phi_10029_: f32;
    var phi_10098_: bool;
    var phi_10099_: bool;
    var phi_10100_: bool;
    var phi_10101_: bool;
    var local_78: bool;
    var local_79: bool;
    var local_80: bool;
    var local_81: bool;
    var local_82: f32;
    var phi_10115_: f32;
    var phi_10117_: type_44;
    var phi_10954_: array<type_16, 4>;
    var phi_10974_: type_9;
    var phi_10977_: bool;
    var phi_10978_: bool;
    var phi_11029_: bool;
    var phi_11030_: bool;
    var local_83: bool;
    var local_84: bool;
    var phi_11044_: u32;
    var phi_11045_: u32;
    var phi_11046_: bool;
    var phi_11077_: bool;
    var phi_11078_: bool;
    var phi_11079_: bool;
    var phi_11080_: bool;
    var phi_11081_: bool;
    var phi_11082_: bool;
    var phi_11083_: bool;
    var phi_11084_: bool;
    var phi_11085_: bool;
    var phi_11086_: bool;
    var phi_11087_: bool;
    var phi_11088_: bool;
    var phi_11089_: type_44;
    var phi_11090_: bool;
    var phi_11091_: type_44;
    var phi_11092_: bool;
    var phi_11093_: bool;
    var phi_11094_: bool;
    var phi_11095_: bool;
    var phi_11096_: type_44;
    var phi_11097_: bool;
    var phi_11098_: type_44;
    var phi_11099_: bool;
    var phi_11100_: bool;
    var phi_11101_: bool;
    var phi_11102_: bool;
    var phi_11103_: bool;
    var phi_11111_: type_44;
    var phi_11112_: bool;
    var phi_11113_: type_44;
    var phi_11114_: bool;
    var phi_11115_: bool;
    var phi_11116_: bool;
    var phi_11117_: bool;
    var phi_11118_: bool;
    var phi_11541_: type_9;
    var phi_11544_: f32;
    var phi_11546_: f32;
    var phi_11548_: f32;
    var phi_11550_: f32;
    var phi_11552_: bool;
    var phi_11554_: u32;
    var phi_11705_: array<f32, 3>;
    var phi_11771_: type_14;
    var phi_11774_: f32;
    var phi_11772_: type_14;
    var phi_11815_: type_15;
    var phi_11775_: f32;
    var local_85: f32;
    var phi_11828_: f32;
    var phi_11951_: type_27;
    var phi_11952_: bool;
    var phi_11953_: type_27;
    var phi_11954_: bool;
    var phi_11962_: type_27;
    var phi_12133_: bool;
    var phi_12134_: bool;
    var phi_12135_: bool;
    var phi_12136_: bool;
    var phi_12137_: bool;
    var phi_12138_: bool;
    var phi_12439_: bool;
    var phi_12440_: bool;
    var phi_12441_: bool;
    var phi_12442_: bool;
    var phi_12443_: bool;
    var phi_12444_: bool;
    var phi_12452_: bool;
    var phi_12559_: f32;
    var phi_12560_: bool;
    var phi_12561_: f32;
    var phi_12562_: bool;
    var phi_12563_: f32;
    var phi_12564_: bool;
    var phi_12565_: bool;
    var phi_12627_: f32;
    var phi_12628_: bool;
    var phi_12629_: f32;
    var phi_12630_: bool;
    var phi_12631_: f32;
    var phi_12632_: bool;
    var phi_12633_: bool;
    var phi_12700_: f32;
    var phi_12701_: bool;
    var phi_12702_: f32;
    var phi_12703_: bool;
    var phi_12704_: f32;
    var phi_12705_: bool;
    var phi_12706_: bool;
    var phi_12768_: f32;
    var phi_12769_: bool;
    var phi_12770_: f32;
    var phi_12771_: bool;
    var phi_12772_: f32;
    var phi_12773_: bool;
    var phi_12774_: bool;
    var phi_13303_: f32;
    var phi_13304_: f32;
    var phi_13305_: bool;
    var phi_13307_: f32;
    var phi_13308_: f32;
    var phi_13309_: f32;
    var phi_13311_: bool;
    var phi_13312_: bool;
    var phi_13314_: bool;
    var phi_13315_: f32;
    var phi_13316_: f32;
    var phi_13317_: f32;
    var phi_13319_: bool;
    var phi_13320_: bool;
    var phi_13321_: bool;
    var phi_13323_: bool;
    var phi_13324_: f32;
    var phi_13325_: f32;
    var phi_13326_: f32;
    var phi_13328_: bool;
    var phi_13329_: bool;
    var phi_13330_: bool;
    var phi_13332_: bool;
    var phi_13665_: f32;
    var phi_13667_: u32;
    var phi_13668_: f32;
    var phi_13669_: bool;
    var phi_13670_: bool;
    var phi_13671_: bool;
    var phi_13672_: u32;
    var phi_13673_: f32;
    var phi_13674_: f32;
    var phi_13675_: f32;
    var phi_13676_: f32;
    var phi_13677_: bool;
    var phi_13678_: u32;
    var phi_13679_: bool;
    var phi_13680_: bool;
    var phi_13681_: bool;
    var phi_13682_: bool;
    var phi_13684_: bool;
    var phi_13712_: f32;
    var phi_13713_: f32;
    var phi_13714_: f32;
    var phi_13715_: f32;
    var phi_13716_: bool;
    var phi_13717_: u32;
    var phi_13718_: bool;
    var phi_13719_: bool;
    var phi_13720_: bool;
    var phi_13721_: bool;
    var phi_13723_: bool;
    var phi_11545_: f32;
    var phi_11547_: f32;
    var phi_11549_: f32;
    var phi_11551_: f32;
    var phi_11553_: bool;
    var phi_11555_: u32;
    var phi_13724_: f32;
    var phi_13726_: bool;
    var phi_13727_: bool;
    var phi_13728_: bool;
    var phi_13729_: bool;
    var phi_13731_: bool;
    var phi_13732_: bool;
    var local_86: bool;
    var local_87: bool;
    var local_88: bool;
    var local_89: bool;
    var local_90: bool;
    var local_91: bool;
    var local_92: bool;
    var local_93: bool;
    var local_94: f32;
    var local_95: bool;
    var local_96: f32;
    var local_97: f32;
    var phi_13800_: f32;
    var phi_13801_: bool;
    var phi_13802_: bool;
    var phi_13803_: bool;
    var phi_13804_: bool;
    var phi_13805_: bool;
    var phi_13806_: type_44;
    var phi_13807_: bool;
    var phi_13808_: f32;
    var phi_13809_: type_44;
    var phi_13810_: bool;
    var phi_13811_: bool;
    var phi_13812_: bool;
    var phi_13813_: bool;
    var phi_13814_: bool;
    var phi_13815_: bool;
    var local_98: bool;
    var local_99: bool;
    var local_100: type_44;
    var local_101: f32;
    var local_102: f32;
    var phi_13831_: type_29;
    var phi_13832_: bool;
    var local_103: f32;
    var phi_13838_: type_29;
    var phi_13839_: bool;
    var phi_13840_: bool;
    var phi_13841_: bool;
    var phi_13842_: bool;
    var local_104: bool;
    var local_105: type_44;
    var phi_13884_: type_29;
    var phi_13885_: type_29;
    var phi_13886_: bool;
    var phi_13930_: type_30;
    var phi_13970_: bool;
    var phi_13986_: bool;
    var phi_14005_: type_30;
    var phi_14006_: type_30;
    var phi_14007_: type_9;
    var phi_14038_: u32;
    var phi_14060_: u32;
    var phi_14126_: u32;
    var local_106: u32;
    var local_107: bool;
    var local_108: bool;
    var local_109: bool;
    var local_110: bool;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e155 = id_2;
    let _e156 = n_2;
    let _e157 = lane_2;
    let _e170 = ((_e155.y * _e156.x) + _e155.x);
    let _e173 = (_e156.x * _e156.y);
    let _e176 = params.member.member_1.member_2;
    let _e178 = input.member[0u];
    let _e180 = select(_e178, _e176, (_e176 < _e178));
    let _e182 = params.member.member_1.member_1;
    if (_e180 > _e182) {
        let _e185 = params.member.member_1.member_1;
        phi_911_ = (_e180 - _e185);
    } else {
        phi_911_ = 0u;
    }
    let _e188 = phi_911_;
    let _e190 = params.member.member_1.member;
    let _e192 = select(_e188, _e190, (_e190 < _e188));
    let _e194 = (_e192 / 64u);
    let _e198 = select(_e194, (_e194 + 1u), ((_e192 % 64u) > 0u));
    if (_e198 > _e170) {
        let _e200 = (_e198 - _e170);
        if (_e173 == 0u) {
            return;
        }
        let _e202 = (_e200 / _e173);
        if (_e173 == 0u) {
            return;
        }
        phi_957_ = select(_e202, (_e202 + 1u), ((_e200 % _e173) > 0u));
    } else {
        phi_957_ = 0u;
    }
    let _e209 = phi_957_;
    phi_960_ = type_9(0u, _e209);
    loop {
        let _e212 = phi_960_;
        let _e215 = (_e212.member < _e212.member_1);
        let _e228 = (bitcast<i32>(select(0u, 1u, _e215)) != 0i);
        if _e228 {
            let _e232 = (((_e170 + (select(type_9().member_1, _e212.member, _e215) * _e173)) * 64u) + _e157);
            if (_e232 < _e192) {
                let _e236 = params.member.member_1.member_1;
                let _e238 = (2u * (_e236 + _e232));
                let _e241 = input.member[(4u + _e238)];
                let _e244 = input.member[(_e238 + 5u)];
                let _e250 = params.member.member_2.member.member;
                if (_e250 == 0u) {
                    let _e266 = (3u * _e244);
                    let _e268 = elements.member[_e266];
                    let _e271 = elements.member[(_e266 + 1u)];
                    let _e274 = elements.member[(_e266 + 2u)];
                    phi_1118_ = type_20(0u, array<u32, 4>(_e241, _e268, _e271, _e274));
                } else {
                    let _e252 = (2u * _e241);
                    let _e253 = (2u * _e244);
                    let _e255 = elements.member[_e252];
                    let _e257 = elements.member[_e253];
                    let _e260 = elements.member[(_e252 + 1u)];
                    let _e263 = elements.member[(_e253 + 1u)];
                    phi_1118_ = type_20(1u, array<u32, 4>(_e255, _e260, _e257, _e263));
                }
                let _e278 = phi_1118_;
                local_39 = array<u32, 4>(_e278.member_1[0], _e278.member_1[1], _e278.member_1[2], _e278.member_1[3]);
                let _e287 = paths.member[_e278.member_1[0]];
                let _e301 = paths.member[_e278.member_1[1]];
                let _e315 = paths.member[_e278.member_1[2]];
                let _e329 = paths.member[_e278.member_1[3]];
                local_40 = array<array<f32, 3>, 4>(array<f32, 3>(_e287.member.x, _e287.member.y, _e287.member.z), array<f32, 3>(_e301.member.x, _e301.member.y, _e301.member.z), array<f32, 3>(_e315.member.x, _e315.member.y, _e315.member.z), array<f32, 3>(_e329.member.x, _e329.member.y, _e329.member.z));
                local_41 = array<array<f32, 3>, 4>(array<f32, 3>(_e287.member_1.x, _e287.member_1.y, _e287.member_1.z), array<f32, 3>(_e301.member_1.x, _e301.member_1.y, _e301.member_1.z), array<f32, 3>(_e315.member_1.x, _e315.member_1.y, _e315.member_1.z), array<f32, 3>(_e329.member_1.x, _e329.member_1.y, _e329.member_1.z));
                let _e353 = params.member.member.member_4;
                if (_e278.member != 0u) {
                    let _e444 = local_40;
                    let _e449 = local_40;
                    let _e458 = local_41;
                    let _e463 = local_41;
                    let _e473 = local_40;
                    let _e478 = local_40;
                    let _e487 = local_41;
                    let _e492 = local_41;
                    let _e502 = local_40;
                    let _e507 = local_40;
                    let _e516 = local_41;
                    let _e521 = local_41;
                    phi_1532_ = type_26(array<array<f32, 3>, 2>(array<f32, 3>((_e444[2][0] - _e449[0][0]), (_e444[2][1] - _e449[0][1]), (_e444[2][2] - _e449[0][2])), array<f32, 3>((_e458[2][0] - _e463[0][0]), (_e458[2][1] - _e463[0][1]), (_e458[2][2] - _e463[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e473[1][0] - _e478[0][0]), (_e473[1][1] - _e478[0][1]), (_e473[1][2] - _e478[0][2])), array<f32, 3>((_e487[1][0] - _e492[0][0]), (_e487[1][1] - _e492[0][1]), (_e487[1][2] - _e492[0][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e502[2][0] - _e507[3][0]), (_e502[2][1] - _e507[3][1]), (_e502[2][2] - _e507[3][2])), array<f32, 3>((_e516[2][0] - _e521[3][0]), (_e516[2][1] - _e521[3][1]), (_e516[2][2] - _e521[3][2]))), (_e353 + _e353));
                } else {
                    let _e355 = local_40;
                    let _e360 = local_40;
                    let _e369 = local_41;
                    let _e374 = local_41;
                    let _e384 = local_40;
                    let _e389 = local_40;
                    let _e398 = local_41;
                    let _e403 = local_41;
                    let _e413 = local_40;
                    let _e418 = local_40;
                    let _e427 = local_41;
                    let _e432 = local_41;
                    phi_1532_ = type_26(array<array<f32, 3>, 2>(array<f32, 3>((_e355[0][0] - _e360[1][0]), (_e355[0][1] - _e360[1][1]), (_e355[0][2] - _e360[1][2])), array<f32, 3>((_e369[0][0] - _e374[1][0]), (_e369[0][1] - _e374[1][1]), (_e369[0][2] - _e374[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e384[2][0] - _e389[1][0]), (_e384[2][1] - _e389[1][1]), (_e384[2][2] - _e389[1][2])), array<f32, 3>((_e398[2][0] - _e403[1][0]), (_e398[2][1] - _e403[1][1]), (_e398[2][2] - _e403[1][2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e413[3][0] - _e418[1][0]), (_e413[3][1] - _e418[1][1]), (_e413[3][2] - _e418[1][2])), array<f32, 3>((_e427[3][0] - _e432[1][0]), (_e427[3][1] - _e432[1][1]), (_e427[3][2] - _e432[1][2]))), (_e353 + _e353));
                }
                let _e534 = phi_1532_;
                let _e540 = select(_e534.member[0][0], -(_e534.member[0][0]), (_e534.member[0][0] < 0f));
                let _e544 = select(_e534.member[0][1], -(_e534.member[0][1]), (_e534.member[0][1] < 0f));
                let _e546 = select(_e544, _e540, (_e540 > _e544));
                let _e550 = select(_e534.member[0][2], -(_e534.member[0][2]), (_e534.member[0][2] < 0f));
                let _e552 = select(_e550, _e546, (_e546 > _e550));
                let _e558 = select(_e534.member[1][0], -(_e534.member[1][0]), (_e534.member[1][0] < 0f));
                let _e562 = select(_e534.member[1][1], -(_e534.member[1][1]), (_e534.member[1][1] < 0f));
                let _e564 = select(_e562, _e558, (_e558 > _e562));
                let _e568 = select(_e534.member[1][2], -(_e534.member[1][2]), (_e534.member[1][2] < 0f));
                let _e570 = select(_e568, _e564, (_e564 > _e568));
                let _e580 = select(_e534.member_1[0][0], -(_e534.member_1[0][0]), (_e534.member_1[0][0] < 0f));
                let _e584 = select(_e534.member_1[0][1], -(_e534.member_1[0][1]), (_e534.member_1[0][1] < 0f));
                let _e586 = select(_e584, _e580, (_e580 > _e584));
                let _e590 = select(_e534.member_1[0][2], -(_e534.member_1[0][2]), (_e534.member_1[0][2] < 0f));
                let _e592 = select(_e590, _e586, (_e586 > _e590));
                let _e598 = select(_e534.member_1[1][0], -(_e534.member_1[1][0]), (_e534.member_1[1][0] < 0f));
                let _e602 = select(_e534.member_1[1][1], -(_e534.member_1[1][1]), (_e534.member_1[1][1] < 0f));
                let _e604 = select(_e602, _e598, (_e598 > _e602));
                let _e608 = select(_e534.member_1[1][2], -(_e534.member_1[1][2]), (_e534.member_1[1][2] < 0f));
                let _e610 = select(_e608, _e604, (_e604 > _e608));
                let _e620 = select(_e534.member_2[0][0], -(_e534.member_2[0][0]), (_e534.member_2[0][0] < 0f));
                let _e624 = select(_e534.member_2[0][1], -(_e534.member_2[0][1]), (_e534.member_2[0][1] < 0f));
                let _e626 = select(_e624, _e620, (_e620 > _e624));
                let _e630 = select(_e534.member_2[0][2], -(_e534.member_2[0][2]), (_e534.member_2[0][2] < 0f));
                let _e632 = select(_e630, _e626, (_e626 > _e630));
                let _e638 = select(_e534.member_2[1][0], -(_e534.member_2[1][0]), (_e534.member_2[1][0] < 0f));
                let _e642 = select(_e534.member_2[1][1], -(_e534.member_2[1][1]), (_e534.member_2[1][1] < 0f));
                let _e644 = select(_e642, _e638, (_e638 > _e642));
                let _e648 = select(_e534.member_2[1][2], -(_e534.member_2[1][2]), (_e534.member_2[1][2] < 0f));
                let _e650 = select(_e648, _e644, (_e644 > _e648));
                let _e655 = function_((select(_e570, _e552, (_e552 > _e570)) + _e534.member_3), (select(_e610, _e592, (_e592 > _e610)) + _e534.member_3));
                let _e656 = function_(_e655, (select(_e650, _e632, (_e632 > _e650)) + _e534.member_3));
                let _e661 = bitcast<i32>(((bitcast<u32>(_e656) + 4u) >> bitcast<u32>(23i)));
                let _e662 = (_e661 >= 64i);
                let _e663 = (_e661 <= 190i);
                let _e669 = select(select(i32(), select(i32(), (_e661 - 126i), _e663), _e662), 2147483647i, select(true, select(true, false, _e663), _e662));
                let _e671 = params.member.member_2.member_3;
                if (_e671 > 0u) {
                    if (_e669 != 2147483647i) {
                        let _e675 = params.member.member.member_1;
                        if ((_e675 & 8u) != 0u) {
                            let _e915 = local_40;
                            let _e920 = bitcast<u32>(_e915[0][0]);
                            let _e921 = (_e920 & 2147483647u);
                            let _e922 = (_e921 < 8388608u);
                            let _e933 = function_14(array<u32, 2>(select((_e920 << bitcast<u32>(29i)), 0u, _e922), select(((_e920 ^ _e921) | ((_e921 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e922)), _e669);
                            let _e934 = bitcast<u32>(_e915[0][1]);
                            let _e935 = (_e934 & 2147483647u);
                            let _e936 = (_e935 < 8388608u);
                            let _e947 = function_14(array<u32, 2>(select((_e934 << bitcast<u32>(29i)), 0u, _e936), select(((_e934 ^ _e935) | ((_e935 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e936)), _e669);
                            let _e948 = bitcast<u32>(_e915[0][2]);
                            let _e949 = (_e948 & 2147483647u);
                            let _e950 = (_e949 < 8388608u);
                            let _e961 = function_14(array<u32, 2>(select((_e948 << bitcast<u32>(29i)), 0u, _e950), select(((_e948 ^ _e949) | ((_e949 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e950)), _e669);
                            let _e963 = local_41;
                            let _e968 = bitcast<u32>(_e963[0][0]);
                            let _e969 = (_e968 & 2147483647u);
                            let _e970 = (_e969 < 8388608u);
                            let _e981 = function_14(array<u32, 2>(select((_e968 << bitcast<u32>(29i)), 0u, _e970), select(((_e968 ^ _e969) | ((_e969 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e970)), _e669);
                            let _e982 = bitcast<u32>(_e963[0][1]);
                            let _e983 = (_e982 & 2147483647u);
                            let _e984 = (_e983 < 8388608u);
                            let _e995 = function_14(array<u32, 2>(select((_e982 << bitcast<u32>(29i)), 0u, _e984), select(((_e982 ^ _e983) | ((_e983 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e984)), _e669);
                            let _e996 = bitcast<u32>(_e963[0][2]);
                            let _e997 = (_e996 & 2147483647u);
                            let _e998 = (_e997 < 8388608u);
                            let _e1009 = function_14(array<u32, 2>(select((_e996 << bitcast<u32>(29i)), 0u, _e998), select(((_e996 ^ _e997) | ((_e997 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e998)), _e669);
                            let _e1012 = local_40;
                            let _e1017 = bitcast<u32>(_e1012[1][0]);
                            let _e1018 = (_e1017 & 2147483647u);
                            let _e1019 = (_e1018 < 8388608u);
                            let _e1030 = function_14(array<u32, 2>(select((_e1017 << bitcast<u32>(29i)), 0u, _e1019), select(((_e1017 ^ _e1018) | ((_e1018 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1019)), _e669);
                            let _e1031 = bitcast<u32>(_e1012[1][1]);
                            let _e1032 = (_e1031 & 2147483647u);
                            let _e1033 = (_e1032 < 8388608u);
                            let _e1044 = function_14(array<u32, 2>(select((_e1031 << bitcast<u32>(29i)), 0u, _e1033), select(((_e1031 ^ _e1032) | ((_e1032 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1033)), _e669);
                            let _e1045 = bitcast<u32>(_e1012[1][2]);
                            let _e1046 = (_e1045 & 2147483647u);
                            let _e1047 = (_e1046 < 8388608u);
                            let _e1058 = function_14(array<u32, 2>(select((_e1045 << bitcast<u32>(29i)), 0u, _e1047), select(((_e1045 ^ _e1046) | ((_e1046 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1047)), _e669);
                            let _e1060 = local_41;
                            let _e1065 = bitcast<u32>(_e1060[1][0]);
                            let _e1066 = (_e1065 & 2147483647u);
                            let _e1067 = (_e1066 < 8388608u);
                            let _e1078 = function_14(array<u32, 2>(select((_e1065 << bitcast<u32>(29i)), 0u, _e1067), select(((_e1065 ^ _e1066) | ((_e1066 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1067)), _e669);
                            let _e1079 = bitcast<u32>(_e1060[1][1]);
                            let _e1080 = (_e1079 & 2147483647u);
                            let _e1081 = (_e1080 < 8388608u);
                            let _e1092 = function_14(array<u32, 2>(select((_e1079 << bitcast<u32>(29i)), 0u, _e1081), select(((_e1079 ^ _e1080) | ((_e1080 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1081)), _e669);
                            let _e1093 = bitcast<u32>(_e1060[1][2]);
                            let _e1094 = (_e1093 & 2147483647u);
                            let _e1095 = (_e1094 < 8388608u);
                            let _e1106 = function_14(array<u32, 2>(select((_e1093 << bitcast<u32>(29i)), 0u, _e1095), select(((_e1093 ^ _e1094) | ((_e1094 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1095)), _e669);
                            let _e1109 = local_40;
                            let _e1114 = bitcast<u32>(_e1109[2][0]);
                            let _e1115 = (_e1114 & 2147483647u);
                            let _e1116 = (_e1115 < 8388608u);
                            let _e1127 = function_14(array<u32, 2>(select((_e1114 << bitcast<u32>(29i)), 0u, _e1116), select(((_e1114 ^ _e1115) | ((_e1115 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1116)), _e669);
                            let _e1128 = bitcast<u32>(_e1109[2][1]);
                            let _e1129 = (_e1128 & 2147483647u);
                            let _e1130 = (_e1129 < 8388608u);
                            let _e1141 = function_14(array<u32, 2>(select((_e1128 << bitcast<u32>(29i)), 0u, _e1130), select(((_e1128 ^ _e1129) | ((_e1129 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1130)), _e669);
                            let _e1142 = bitcast<u32>(_e1109[2][2]);
                            let _e1143 = (_e1142 & 2147483647u);
                            let _e1144 = (_e1143 < 8388608u);
                            let _e1155 = function_14(array<u32, 2>(select((_e1142 << bitcast<u32>(29i)), 0u, _e1144), select(((_e1142 ^ _e1143) | ((_e1143 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1144)), _e669);
                            let _e1157 = local_41;
                            let _e1162 = bitcast<u32>(_e1157[2][0]);
                            let _e1163 = (_e1162 & 2147483647u);
                            let _e1164 = (_e1163 < 8388608u);
                            let _e1175 = function_14(array<u32, 2>(select((_e1162 << bitcast<u32>(29i)), 0u, _e1164), select(((_e1162 ^ _e1163) | ((_e1163 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1164)), _e669);
                            let _e1176 = bitcast<u32>(_e1157[2][1]);
                            let _e1177 = (_e1176 & 2147483647u);
                            let _e1178 = (_e1177 < 8388608u);
                            let _e1189 = function_14(array<u32, 2>(select((_e1176 << bitcast<u32>(29i)), 0u, _e1178), select(((_e1176 ^ _e1177) | ((_e1177 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1178)), _e669);
                            let _e1190 = bitcast<u32>(_e1157[2][2]);
                            let _e1191 = (_e1190 & 2147483647u);
                            let _e1192 = (_e1191 < 8388608u);
                            let _e1203 = function_14(array<u32, 2>(select((_e1190 << bitcast<u32>(29i)), 0u, _e1192), select(((_e1190 ^ _e1191) | ((_e1191 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1192)), _e669);
                            let _e1206 = local_40;
                            let _e1211 = bitcast<u32>(_e1206[3][0]);
                            let _e1212 = (_e1211 & 2147483647u);
                            let _e1213 = (_e1212 < 8388608u);
                            let _e1224 = function_14(array<u32, 2>(select((_e1211 << bitcast<u32>(29i)), 0u, _e1213), select(((_e1211 ^ _e1212) | ((_e1212 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1213)), _e669);
                            let _e1225 = bitcast<u32>(_e1206[3][1]);
                            let _e1226 = (_e1225 & 2147483647u);
                            let _e1227 = (_e1226 < 8388608u);
                            let _e1238 = function_14(array<u32, 2>(select((_e1225 << bitcast<u32>(29i)), 0u, _e1227), select(((_e1225 ^ _e1226) | ((_e1226 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1227)), _e669);
                            let _e1239 = bitcast<u32>(_e1206[3][2]);
                            let _e1240 = (_e1239 & 2147483647u);
                            let _e1241 = (_e1240 < 8388608u);
                            let _e1252 = function_14(array<u32, 2>(select((_e1239 << bitcast<u32>(29i)), 0u, _e1241), select(((_e1239 ^ _e1240) | ((_e1240 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1241)), _e669);
                            let _e1254 = local_41;
                            let _e1259 = bitcast<u32>(_e1254[3][0]);
                            let _e1260 = (_e1259 & 2147483647u);
                            let _e1261 = (_e1260 < 8388608u);
                            let _e1272 = function_14(array<u32, 2>(select((_e1259 << bitcast<u32>(29i)), 0u, _e1261), select(((_e1259 ^ _e1260) | ((_e1260 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1261)), _e669);
                            let _e1273 = bitcast<u32>(_e1254[3][1]);
                            let _e1274 = (_e1273 & 2147483647u);
                            let _e1275 = (_e1274 < 8388608u);
                            let _e1286 = function_14(array<u32, 2>(select((_e1273 << bitcast<u32>(29i)), 0u, _e1275), select(((_e1273 ^ _e1274) | ((_e1274 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1275)), _e669);
                            let _e1287 = bitcast<u32>(_e1254[3][2]);
                            let _e1288 = (_e1287 & 2147483647u);
                            let _e1289 = (_e1288 < 8388608u);
                            let _e1300 = function_14(array<u32, 2>(select((_e1287 << bitcast<u32>(29i)), 0u, _e1289), select(((_e1287 ^ _e1288) | ((_e1288 >> bitcast<u32>(3i)) + 939524096u)), 0u, _e1289)), _e669);
                            phi_3240_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e933, _e947, _e961), array<type_9, 3>(_e981, _e995, _e1009)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1030, _e1044, _e1058), array<type_9, 3>(_e1078, _e1092, _e1106)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1127, _e1141, _e1155), array<type_9, 3>(_e1175, _e1189, _e1203)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e1224, _e1238, _e1252), array<type_9, 3>(_e1272, _e1286, _e1300)));
                        } else {
                            let _e680 = params.member.member.member_10[1u];
                            let _e685 = (_e669 - (bitcast<i32>((_e680 >> bitcast<u32>(20i))) - 1023i));
                            let _e686 = local_39;
                            let _e690 = params.member.member.member[0u];
                            let _e692 = (6u * (_e690 + _e686[0]));
                            let _e693 = (6u * _e686[0]);
                            let _e695 = positions.member[_e693];
                            let _e698 = positions.member[(_e693 + 1u)];
                            let _e700 = function_14(array<u32, 2>(_e695, _e698), _e685);
                            let _e703 = positions.member[(_e693 + 2u)];
                            let _e706 = positions.member[(_e693 + 3u)];
                            let _e708 = function_14(array<u32, 2>(_e703, _e706), _e685);
                            let _e711 = positions.member[(_e693 + 4u)];
                            let _e714 = positions.member[(_e693 + 5u)];
                            let _e716 = function_14(array<u32, 2>(_e711, _e714), _e685);
                            let _e719 = positions.member[_e692];
                            let _e722 = positions.member[(_e692 + 1u)];
                            let _e724 = function_14(array<u32, 2>(_e719, _e722), _e685);
                            let _e727 = positions.member[(_e692 + 2u)];
                            let _e730 = positions.member[(_e692 + 3u)];
                            let _e732 = function_14(array<u32, 2>(_e727, _e730), _e685);
                            let _e735 = positions.member[(_e692 + 4u)];
                            let _e738 = positions.member[(_e692 + 5u)];
                            let _e740 = function_14(array<u32, 2>(_e735, _e738), _e685);
                            let _e743 = local_39;
                            let _e747 = params.member.member.member[0u];
                            let _e749 = (6u * (_e747 + _e743[1]));
                            let _e750 = (6u * _e743[1]);
                            let _e752 = positions.member[_e750];
                            let _e755 = positions.member[(_e750 + 1u)];
                            let _e757 = function_14(array<u32, 2>(_e752, _e755), _e685);
                            let _e760 = positions.member[(_e750 + 2u)];
                            let _e763 = positions.member[(_e750 + 3u)];
                            let _e765 = function_14(array<u32, 2>(_e760, _e763), _e685);
                            let _e768 = positions.member[(_e750 + 4u)];
                            let _e771 = positions.member[(_e750 + 5u)];
                            let _e773 = function_14(array<u32, 2>(_e768, _e771), _e685);
                            let _e776 = positions.member[_e749];
                            let _e779 = positions.member[(_e749 + 1u)];
                            let _e781 = function_14(array<u32, 2>(_e776, _e779), _e685);
                            let _e784 = positions.member[(_e749 + 2u)];
                            let _e787 = positions.member[(_e749 + 3u)];
                            let _e789 = function_14(array<u32, 2>(_e784, _e787), _e685);
                            let _e792 = positions.member[(_e749 + 4u)];
                            let _e795 = positions.member[(_e749 + 5u)];
                            let _e797 = function_14(array<u32, 2>(_e792, _e795), _e685);
                            let _e800 = local_39;
                            let _e804 = params.member.member.member[0u];
                            let _e806 = (6u * (_e804 + _e800[2]));
                            let _e807 = (6u * _e800[2]);
                            let _e809 = positions.member[_e807];
                            let _e812 = positions.member[(_e807 + 1u)];
                            let _e814 = function_14(array<u32, 2>(_e809, _e812), _e685);
                            let _e817 = positions.member[(_e807 + 2u)];
                            let _e820 = positions.member[(_e807 + 3u)];
                            let _e822 = function_14(array<u32, 2>(_e817, _e820), _e685);
                            let _e825 = positions.member[(_e807 + 4u)];
                            let _e828 = positions.member[(_e807 + 5u)];
                            let _e830 = function_14(array<u32, 2>(_e825, _e828), _e685);
                            let _e833 = positions.member[_e806];
                            let _e836 = positions.member[(_e806 + 1u)];
                            let _e838 = function_14(array<u32, 2>(_e833, _e836), _e685);
                            let _e841 = positions.member[(_e806 + 2u)];
                            let _e844 = positions.member[(_e806 + 3u)];
                            let _e846 = function_14(array<u32, 2>(_e841, _e844), _e685);
                            let _e849 = positions.member[(_e806 + 4u)];
                            let _e852 = positions.member[(_e806 + 5u)];
                            let _e854 = function_14(array<u32, 2>(_e849, _e852), _e685);
                            let _e857 = local_39;
                            let _e861 = params.member.member.member[0u];
                            let _e863 = (6u * (_e861 + _e857[3]));
                            let _e864 = (6u * _e857[3]);
                            let _e866 = positions.member[_e864];
                            let _e869 = positions.member[(_e864 + 1u)];
                            let _e871 = function_14(array<u32, 2>(_e866, _e869), _e685);
                            let _e874 = positions.member[(_e864 + 2u)];
                            let _e877 = positions.member[(_e864 + 3u)];
                            let _e879 = function_14(array<u32, 2>(_e874, _e877), _e685);
                            let _e882 = positions.member[(_e864 + 4u)];
                            let _e885 = positions.member[(_e864 + 5u)];
                            let _e887 = function_14(array<u32, 2>(_e882, _e885), _e685);
                            let _e890 = positions.member[_e863];
                            let _e893 = positions.member[(_e863 + 1u)];
                            let _e895 = function_14(array<u32, 2>(_e890, _e893), _e685);
                            let _e898 = positions.member[(_e863 + 2u)];
                            let _e901 = positions.member[(_e863 + 3u)];
                            let _e903 = function_14(array<u32, 2>(_e898, _e901), _e685);
                            let _e906 = positions.member[(_e863 + 4u)];
                            let _e909 = positions.member[(_e863 + 5u)];
                            let _e911 = function_14(array<u32, 2>(_e906, _e909), _e685);
                            phi_3240_ = array<array<array<type_9, 3>, 2>, 4>(array<array<type_9, 3>, 2>(array<type_9, 3>(_e700, _e708, _e716), array<type_9, 3>(_e724, _e732, _e740)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e757, _e765, _e773), array<type_9, 3>(_e781, _e789, _e797)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e814, _e822, _e830), array<type_9, 3>(_e838, _e846, _e854)), array<array<type_9, 3>, 2>(array<type_9, 3>(_e871, _e879, _e887), array<type_9, 3>(_e895, _e903, _e911)));
                        }
                        let _e1305 = phi_3240_;
                        let _e1307 = params.member.member_2.member_1;
                        let _e1309 = params.member.member_2.member_2;
                        let _e1311 = params.member.member_2.member_3;
                        if (_e278.member != 0u) {
                            phi_3787_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1305[2][0][0].member - _e1305[0][0][0].member) - select(0u, 1u, (_e1305[2][0][0].member_1 < _e1305[0][0][0].member_1))), (_e1305[2][0][0].member_1 - _e1305[0][0][0].member_1)), type_9(((_e1305[2][0][1].member - _e1305[0][0][1].member) - select(0u, 1u, (_e1305[2][0][1].member_1 < _e1305[0][0][1].member_1))), (_e1305[2][0][1].member_1 - _e1305[0][0][1].member_1)), type_9(((_e1305[2][0][2].member - _e1305[0][0][2].member) - select(0u, 1u, (_e1305[2][0][2].member_1 < _e1305[0][0][2].member_1))), (_e1305[2][0][2].member_1 - _e1305[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1305[2][1][0].member - _e1305[0][1][0].member) - select(0u, 1u, (_e1305[2][1][0].member_1 < _e1305[0][1][0].member_1))), (_e1305[2][1][0].member_1 - _e1305[0][1][0].member_1)), type_9(((_e1305[2][1][1].member - _e1305[0][1][1].member) - select(0u, 1u, (_e1305[2][1][1].member_1 < _e1305[0][1][1].member_1))), (_e1305[2][1][1].member_1 - _e1305[0][1][1].member_1)), type_9(((_e1305[2][1][2].member - _e1305[0][1][2].member) - select(0u, 1u, (_e1305[2][1][2].member_1 < _e1305[0][1][2].member_1))), (_e1305[2][1][2].member_1 - _e1305[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1305[1][0][0].member - _e1305[0][0][0].member) - select(0u, 1u, (_e1305[1][0][0].member_1 < _e1305[0][0][0].member_1))), (_e1305[1][0][0].member_1 - _e1305[0][0][0].member_1)), type_9(((_e1305[1][0][1].member - _e1305[0][0][1].member) - select(0u, 1u, (_e1305[1][0][1].member_1 < _e1305[0][0][1].member_1))), (_e1305[1][0][1].member_1 - _e1305[0][0][1].member_1)), type_9(((_e1305[1][0][2].member - _e1305[0][0][2].member) - select(0u, 1u, (_e1305[1][0][2].member_1 < _e1305[0][0][2].member_1))), (_e1305[1][0][2].member_1 - _e1305[0][0][2].member_1))), array<type_9, 3>(type_9(((_e1305[1][1][0].member - _e1305[0][1][0].member) - select(0u, 1u, (_e1305[1][1][0].member_1 < _e1305[0][1][0].member_1))), (_e1305[1][1][0].member_1 - _e1305[0][1][0].member_1)), type_9(((_e1305[1][1][1].member - _e1305[0][1][1].member) - select(0u, 1u, (_e1305[1][1][1].member_1 < _e1305[0][1][1].member_1))), (_e1305[1][1][1].member_1 - _e1305[0][1][1].member_1)), type_9(((_e1305[1][1][2].member - _e1305[0][1][2].member) - select(0u, 1u, (_e1305[1][1][2].member_1 < _e1305[0][1][2].member_1))), (_e1305[1][1][2].member_1 - _e1305[0][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1305[2][0][0].member - _e1305[3][0][0].member) - select(0u, 1u, (_e1305[2][0][0].member_1 < _e1305[3][0][0].member_1))), (_e1305[2][0][0].member_1 - _e1305[3][0][0].member_1)), type_9(((_e1305[2][0][1].member - _e1305[3][0][1].member) - select(0u, 1u, (_e1305[2][0][1].member_1 < _e1305[3][0][1].member_1))), (_e1305[2][0][1].member_1 - _e1305[3][0][1].member_1)), type_9(((_e1305[2][0][2].member - _e1305[3][0][2].member) - select(0u, 1u, (_e1305[2][0][2].member_1 < _e1305[3][0][2].member_1))), (_e1305[2][0][2].member_1 - _e1305[3][0][2].member_1))), array<type_9, 3>(type_9(((_e1305[2][1][0].member - _e1305[3][1][0].member) - select(0u, 1u, (_e1305[2][1][0].member_1 < _e1305[3][1][0].member_1))), (_e1305[2][1][0].member_1 - _e1305[3][1][0].member_1)), type_9(((_e1305[2][1][1].member - _e1305[3][1][1].member) - select(0u, 1u, (_e1305[2][1][1].member_1 < _e1305[3][1][1].member_1))), (_e1305[2][1][1].member_1 - _e1305[3][1][1].member_1)), type_9(((_e1305[2][1][2].member - _e1305[3][1][2].member) - select(0u, 1u, (_e1305[2][1][2].member_1 < _e1305[3][1][2].member_1))), (_e1305[2][1][2].member_1 - _e1305[3][1][2].member_1)))));
                        } else {
                            phi_3787_ = array<array<array<type_9, 3>, 2>, 3>(array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1305[0][0][0].member - _e1305[1][0][0].member) - select(0u, 1u, (_e1305[0][0][0].member_1 < _e1305[1][0][0].member_1))), (_e1305[0][0][0].member_1 - _e1305[1][0][0].member_1)), type_9(((_e1305[0][0][1].member - _e1305[1][0][1].member) - select(0u, 1u, (_e1305[0][0][1].member_1 < _e1305[1][0][1].member_1))), (_e1305[0][0][1].member_1 - _e1305[1][0][1].member_1)), type_9(((_e1305[0][0][2].member - _e1305[1][0][2].member) - select(0u, 1u, (_e1305[0][0][2].member_1 < _e1305[1][0][2].member_1))), (_e1305[0][0][2].member_1 - _e1305[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1305[0][1][0].member - _e1305[1][1][0].member) - select(0u, 1u, (_e1305[0][1][0].member_1 < _e1305[1][1][0].member_1))), (_e1305[0][1][0].member_1 - _e1305[1][1][0].member_1)), type_9(((_e1305[0][1][1].member - _e1305[1][1][1].member) - select(0u, 1u, (_e1305[0][1][1].member_1 < _e1305[1][1][1].member_1))), (_e1305[0][1][1].member_1 - _e1305[1][1][1].member_1)), type_9(((_e1305[0][1][2].member - _e1305[1][1][2].member) - select(0u, 1u, (_e1305[0][1][2].member_1 < _e1305[1][1][2].member_1))), (_e1305[0][1][2].member_1 - _e1305[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1305[2][0][0].member - _e1305[1][0][0].member) - select(0u, 1u, (_e1305[2][0][0].member_1 < _e1305[1][0][0].member_1))), (_e1305[2][0][0].member_1 - _e1305[1][0][0].member_1)), type_9(((_e1305[2][0][1].member - _e1305[1][0][1].member) - select(0u, 1u, (_e1305[2][0][1].member_1 < _e1305[1][0][1].member_1))), (_e1305[2][0][1].member_1 - _e1305[1][0][1].member_1)), type_9(((_e1305[2][0][2].member - _e1305[1][0][2].member) - select(0u, 1u, (_e1305[2][0][2].member_1 < _e1305[1][0][2].member_1))), (_e1305[2][0][2].member_1 - _e1305[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1305[2][1][0].member - _e1305[1][1][0].member) - select(0u, 1u, (_e1305[2][1][0].member_1 < _e1305[1][1][0].member_1))), (_e1305[2][1][0].member_1 - _e1305[1][1][0].member_1)), type_9(((_e1305[2][1][1].member - _e1305[1][1][1].member) - select(0u, 1u, (_e1305[2][1][1].member_1 < _e1305[1][1][1].member_1))), (_e1305[2][1][1].member_1 - _e1305[1][1][1].member_1)), type_9(((_e1305[2][1][2].member - _e1305[1][1][2].member) - select(0u, 1u, (_e1305[2][1][2].member_1 < _e1305[1][1][2].member_1))), (_e1305[2][1][2].member_1 - _e1305[1][1][2].member_1)))), array<array<type_9, 3>, 2>(array<type_9, 3>(type_9(((_e1305[3][0][0].member - _e1305[1][0][0].member) - select(0u, 1u, (_e1305[3][0][0].member_1 < _e1305[1][0][0].member_1))), (_e1305[3][0][0].member_1 - _e1305[1][0][0].member_1)), type_9(((_e1305[3][0][1].member - _e1305[1][0][1].member) - select(0u, 1u, (_e1305[3][0][1].member_1 < _e1305[1][0][1].member_1))), (_e1305[3][0][1].member_1 - _e1305[1][0][1].member_1)), type_9(((_e1305[3][0][2].member - _e1305[1][0][2].member) - select(0u, 1u, (_e1305[3][0][2].member_1 < _e1305[1][0][2].member_1))), (_e1305[3][0][2].member_1 - _e1305[1][0][2].member_1))), array<type_9, 3>(type_9(((_e1305[3][1][0].member - _e1305[1][1][0].member) - select(0u, 1u, (_e1305[3][1][0].member_1 < _e1305[1][1][0].member_1))), (_e1305[3][1][0].member_1 - _e1305[1][1][0].member_1)), type_9(((_e1305[3][1][1].member - _e1305[1][1][1].member) - select(0u, 1u, (_e1305[3][1][1].member_1 < _e1305[1][1][1].member_1))), (_e1305[3][1][1].member_1 - _e1305[1][1][1].member_1)), type_9(((_e1305[3][1][2].member - _e1305[1][1][2].member) - select(0u, 1u, (_e1305[3][1][2].member_1 < _e1305[1][1][2].member_1))), (_e1305[3][1][2].member_1 - _e1305[1][1][2].member_1)))));
                        }
                        let _e1886 = phi_3787_;
                        local_37 = array<type_9, 3>(type_9(_e1886[1][0][0].member, _e1886[1][0][0].member_1), type_9(_e1886[1][0][1].member, _e1886[1][0][1].member_1), type_9(_e1886[1][0][2].member, _e1886[1][0][2].member_1));
                        local_38 = array<type_9, 3>(type_9(_e1886[2][0][0].member, _e1886[2][0][0].member_1), type_9(_e1886[2][0][1].member, _e1886[2][0][1].member_1), type_9(_e1886[2][0][2].member, _e1886[2][0][2].member_1));
                        let _e1919 = local_37[1u].member;
                        let _e1921 = local_37[1u].member_1;
                        let _e1924 = local_38[2u].member;
                        let _e1926 = local_38[2u].member_1;
                        let _e1927 = function_10(_e1919, _e1921, _e1924, _e1926);
                        let _e1932 = local_37[2u].member;
                        let _e1934 = local_37[2u].member_1;
                        let _e1937 = local_38[1u].member;
                        let _e1939 = local_38[1u].member_1;
                        let _e1940 = function_10(_e1932, _e1934, _e1937, _e1939);
                        let _e1946 = ((_e1927.member - _e1940.member) - select(0u, 1u, (_e1927.member_1 < _e1940.member_1)));
                        let _e1947 = (_e1927.member_1 - _e1940.member_1);
                        local_35 = array<type_9, 3>(type_9(_e1886[1][0][0].member, _e1886[1][0][0].member_1), type_9(_e1886[1][0][1].member, _e1886[1][0][1].member_1), type_9(_e1886[1][0][2].member, _e1886[1][0][2].member_1));
                        local_36 = array<type_9, 3>(type_9(_e1886[2][0][0].member, _e1886[2][0][0].member_1), type_9(_e1886[2][0][1].member, _e1886[2][0][1].member_1), type_9(_e1886[2][0][2].member, _e1886[2][0][2].member_1));
                        let _e1976 = local_35[2u].member;
                        let _e1978 = local_35[2u].member_1;
                        let _e1981 = local_36[0u].member;
                        let _e1983 = local_36[0u].member_1;
                        let _e1984 = function_10(_e1976, _e1978, _e1981, _e1983);
                        let _e1989 = local_35[0u].member;
                        let _e1991 = local_35[0u].member_1;
                        let _e1994 = local_36[2u].member;
                        let _e1996 = local_36[2u].member_1;
                        let _e1997 = function_10(_e1989, _e1991, _e1994, _e1996);
                        let _e2003 = ((_e1984.member - _e1997.member) - select(0u, 1u, (_e1984.member_1 < _e1997.member_1)));
                        let _e2004 = (_e1984.member_1 - _e1997.member_1);
                        local_33 = array<type_9, 3>(type_9(_e1886[1][0][0].member, _e1886[1][0][0].member_1), type_9(_e1886[1][0][1].member, _e1886[1][0][1].member_1), type_9(_e1886[1][0][2].member, _e1886[1][0][2].member_1));
                        local_34 = array<type_9, 3>(type_9(_e1886[2][0][0].member, _e1886[2][0][0].member_1), type_9(_e1886[2][0][1].member, _e1886[2][0][1].member_1), type_9(_e1886[2][0][2].member, _e1886[2][0][2].member_1));
                        let _e2033 = local_33[0u].member;
                        let _e2035 = local_33[0u].member_1;
                        let _e2038 = local_34[1u].member;
                        let _e2040 = local_34[1u].member_1;
                        let _e2041 = function_10(_e2033, _e2035, _e2038, _e2040);
                        let _e2046 = local_33[1u].member;
                        let _e2048 = local_33[1u].member_1;
                        let _e2051 = local_34[0u].member;
                        let _e2053 = local_34[0u].member_1;
                        let _e2054 = function_10(_e2046, _e2048, _e2051, _e2053);
                        let _e2060 = ((_e2041.member - _e2054.member) - select(0u, 1u, (_e2041.member_1 < _e2054.member_1)));
                        let _e2061 = (_e2041.member_1 - _e2054.member_1);
                        local_31 = array<type_9, 3>(type_9(_e1886[1][1][0].member, _e1886[1][1][0].member_1), type_9(_e1886[1][1][1].member, _e1886[1][1][1].member_1), type_9(_e1886[1][1][2].member, _e1886[1][1][2].member_1));
                        local_32 = array<type_9, 3>(type_9(_e1886[2][1][0].member, _e1886[2][1][0].member_1), type_9(_e1886[2][1][1].member, _e1886[2][1][1].member_1), type_9(_e1886[2][1][2].member, _e1886[2][1][2].member_1));
                        let _e2094 = local_31[1u].member;
                        let _e2096 = local_31[1u].member_1;
                        let _e2099 = local_32[2u].member;
                        let _e2101 = local_32[2u].member_1;
                        let _e2102 = function_10(_e2094, _e2096, _e2099, _e2101);
                        let _e2107 = local_31[2u].member;
                        let _e2109 = local_31[2u].member_1;
                        let _e2112 = local_32[1u].member;
                        let _e2114 = local_32[1u].member_1;
                        let _e2115 = function_10(_e2107, _e2109, _e2112, _e2114);
                        let _e2121 = ((_e2102.member - _e2115.member) - select(0u, 1u, (_e2102.member_1 < _e2115.member_1)));
                        let _e2122 = (_e2102.member_1 - _e2115.member_1);
                        local_29 = array<type_9, 3>(type_9(_e1886[1][1][0].member, _e1886[1][1][0].member_1), type_9(_e1886[1][1][1].member, _e1886[1][1][1].member_1), type_9(_e1886[1][1][2].member, _e1886[1][1][2].member_1));
                        local_30 = array<type_9, 3>(type_9(_e1886[2][1][0].member, _e1886[2][1][0].member_1), type_9(_e1886[2][1][1].member, _e1886[2][1][1].member_1), type_9(_e1886[2][1][2].member, _e1886[2][1][2].member_1));
                        let _e2151 = local_29[2u].member;
                        let _e2153 = local_29[2u].member_1;
                        let _e2156 = local_30[0u].member;
                        let _e2158 = local_30[0u].member_1;
                        let _e2159 = function_10(_e2151, _e2153, _e2156, _e2158);
                        let _e2164 = local_29[0u].member;
                        let _e2166 = local_29[0u].member_1;
                        let _e2169 = local_30[2u].member;
                        let _e2171 = local_30[2u].member_1;
                        let _e2172 = function_10(_e2164, _e2166, _e2169, _e2171);
                        let _e2178 = ((_e2159.member - _e2172.member) - select(0u, 1u, (_e2159.member_1 < _e2172.member_1)));
                        let _e2179 = (_e2159.member_1 - _e2172.member_1);
                        local_27 = array<type_9, 3>(type_9(_e1886[1][1][0].member, _e1886[1][1][0].member_1), type_9(_e1886[1][1][1].member, _e1886[1][1][1].member_1), type_9(_e1886[1][1][2].member, _e1886[1][1][2].member_1));
                        local_28 = array<type_9, 3>(type_9(_e1886[2][1][0].member, _e1886[2][1][0].member_1), type_9(_e1886[2][1][1].member, _e1886[2][1][1].member_1), type_9(_e1886[2][1][2].member, _e1886[2][1][2].member_1));
                        let _e2208 = local_27[0u].member;
                        let _e2210 = local_27[0u].member_1;
                        let _e2213 = local_28[1u].member;
                        let _e2215 = local_28[1u].member_1;
                        let _e2216 = function_10(_e2208, _e2210, _e2213, _e2215);
                        let _e2221 = local_27[1u].member;
                        let _e2223 = local_27[1u].member_1;
                        let _e2226 = local_28[0u].member;
                        let _e2228 = local_28[0u].member_1;
                        let _e2229 = function_10(_e2221, _e2223, _e2226, _e2228);
                        let _e2235 = ((_e2216.member - _e2229.member) - select(0u, 1u, (_e2216.member_1 < _e2229.member_1)));
                        let _e2236 = (_e2216.member_1 - _e2229.member_1);
                        local_25 = array<type_9, 3>(type_9(_e1886[1][0][0].member, _e1886[1][0][0].member_1), type_9(_e1886[1][0][1].member, _e1886[1][0][1].member_1), type_9(_e1886[1][0][2].member, _e1886[1][0][2].member_1));
                        local_26 = array<type_9, 3>(type_9(_e1886[2][1][0].member, _e1886[2][1][0].member_1), type_9(_e1886[2][1][1].member, _e1886[2][1][1].member_1), type_9(_e1886[2][1][2].member, _e1886[2][1][2].member_1));
                        let _e2269 = local_25[1u].member;
                        let _e2271 = local_25[1u].member_1;
                        let _e2274 = local_26[2u].member;
                        let _e2276 = local_26[2u].member_1;
                        let _e2277 = function_10(_e2269, _e2271, _e2274, _e2276);
                        let _e2282 = local_25[2u].member;
                        let _e2284 = local_25[2u].member_1;
                        let _e2287 = local_26[1u].member;
                        let _e2289 = local_26[1u].member_1;
                        let _e2290 = function_10(_e2282, _e2284, _e2287, _e2289);
                        let _e2297 = (_e2277.member_1 - _e2290.member_1);
                        local_23 = array<type_9, 3>(type_9(_e1886[1][0][0].member, _e1886[1][0][0].member_1), type_9(_e1886[1][0][1].member, _e1886[1][0][1].member_1), type_9(_e1886[1][0][2].member, _e1886[1][0][2].member_1));
                        local_24 = array<type_9, 3>(type_9(_e1886[2][1][0].member, _e1886[2][1][0].member_1), type_9(_e1886[2][1][1].member, _e1886[2][1][1].member_1), type_9(_e1886[2][1][2].member, _e1886[2][1][2].member_1));
                        let _e2326 = local_23[2u].member;
                        let _e2328 = local_23[2u].member_1;
                        let _e2331 = local_24[0u].member;
                        let _e2333 = local_24[0u].member_1;
                        let _e2334 = function_10(_e2326, _e2328, _e2331, _e2333);
                        let _e2339 = local_23[0u].member;
                        let _e2341 = local_23[0u].member_1;
                        let _e2344 = local_24[2u].member;
                        let _e2346 = local_24[2u].member_1;
                        let _e2347 = function_10(_e2339, _e2341, _e2344, _e2346);
                        let _e2354 = (_e2334.member_1 - _e2347.member_1);
                        local_21 = array<type_9, 3>(type_9(_e1886[1][0][0].member, _e1886[1][0][0].member_1), type_9(_e1886[1][0][1].member, _e1886[1][0][1].member_1), type_9(_e1886[1][0][2].member, _e1886[1][0][2].member_1));
                        local_22 = array<type_9, 3>(type_9(_e1886[2][1][0].member, _e1886[2][1][0].member_1), type_9(_e1886[2][1][1].member, _e1886[2][1][1].member_1), type_9(_e1886[2][1][2].member, _e1886[2][1][2].member_1));
                        let _e2383 = local_21[0u].member;
                        let _e2385 = local_21[0u].member_1;
                        let _e2388 = local_22[1u].member;
                        let _e2390 = local_22[1u].member_1;
                        let _e2391 = function_10(_e2383, _e2385, _e2388, _e2390);
                        let _e2396 = local_21[1u].member;
                        let _e2398 = local_21[1u].member_1;
                        let _e2401 = local_22[0u].member;
                        let _e2403 = local_22[0u].member_1;
                        let _e2404 = function_10(_e2396, _e2398, _e2401, _e2403);
                        let _e2411 = (_e2391.member_1 - _e2404.member_1);
                        local_19 = array<type_9, 3>(type_9(_e1886[1][1][0].member, _e1886[1][1][0].member_1), type_9(_e1886[1][1][1].member, _e1886[1][1][1].member_1), type_9(_e1886[1][1][2].member, _e1886[1][1][2].member_1));
                        local_20 = array<type_9, 3>(type_9(_e1886[2][0][0].member, _e1886[2][0][0].member_1), type_9(_e1886[2][0][1].member, _e1886[2][0][1].member_1), type_9(_e1886[2][0][2].member, _e1886[2][0][2].member_1));
                        let _e2444 = local_19[1u].member;
                        let _e2446 = local_19[1u].member_1;
                        let _e2449 = local_20[2u].member;
                        let _e2451 = local_20[2u].member_1;
                        let _e2452 = function_10(_e2444, _e2446, _e2449, _e2451);
                        let _e2457 = local_19[2u].member;
                        let _e2459 = local_19[2u].member_1;
                        let _e2462 = local_20[1u].member;
                        let _e2464 = local_20[1u].member_1;
                        let _e2465 = function_10(_e2457, _e2459, _e2462, _e2464);
                        local_17 = array<type_9, 3>(type_9(_e1886[1][1][0].member, _e1886[1][1][0].member_1), type_9(_e1886[1][1][1].member, _e1886[1][1][1].member_1), type_9(_e1886[1][1][2].member, _e1886[1][1][2].member_1));
                        local_18 = array<type_9, 3>(type_9(_e1886[2][0][0].member, _e1886[2][0][0].member_1), type_9(_e1886[2][0][1].member, _e1886[2][0][1].member_1), type_9(_e1886[2][0][2].member, _e1886[2][0][2].member_1));
                        let _e2501 = local_17[2u].member;
                        let _e2503 = local_17[2u].member_1;
                        let _e2506 = local_18[0u].member;
                        let _e2508 = local_18[0u].member_1;
                        let _e2509 = function_10(_e2501, _e2503, _e2506, _e2508);
                        let _e2514 = local_17[0u].member;
                        let _e2516 = local_17[0u].member_1;
                        let _e2519 = local_18[2u].member;
                        let _e2521 = local_18[2u].member_1;
                        let _e2522 = function_10(_e2514, _e2516, _e2519, _e2521);
                        local_15 = array<type_9, 3>(type_9(_e1886[1][1][0].member, _e1886[1][1][0].member_1), type_9(_e1886[1][1][1].member, _e1886[1][1][1].member_1), type_9(_e1886[1][1][2].member, _e1886[1][1][2].member_1));
                        local_16 = array<type_9, 3>(type_9(_e1886[2][0][0].member, _e1886[2][0][0].member_1), type_9(_e1886[2][0][1].member, _e1886[2][0][1].member_1), type_9(_e1886[2][0][2].member, _e1886[2][0][2].member_1));
                        let _e2558 = local_15[0u].member;
                        let _e2560 = local_15[0u].member_1;
                        let _e2563 = local_16[1u].member;
                        let _e2565 = local_16[1u].member_1;
                        let _e2566 = function_10(_e2558, _e2560, _e2563, _e2565);
                        let _e2571 = local_15[1u].member;
                        let _e2573 = local_15[1u].member_1;
                        let _e2576 = local_16[0u].member;
                        let _e2578 = local_16[0u].member_1;
                        let _e2579 = function_10(_e2571, _e2573, _e2576, _e2578);
                        let _e2587 = (_e2297 + (_e2452.member_1 - _e2465.member_1));
                        let _e2591 = ((((_e2277.member - _e2290.member) - select(0u, 1u, (_e2277.member_1 < _e2290.member_1))) + ((_e2452.member - _e2465.member) - select(0u, 1u, (_e2452.member_1 < _e2465.member_1)))) + select(0u, 1u, (_e2587 < _e2297)));
                        let _e2592 = (_e2354 + (_e2509.member_1 - _e2522.member_1));
                        let _e2596 = ((((_e2334.member - _e2347.member) - select(0u, 1u, (_e2334.member_1 < _e2347.member_1))) + ((_e2509.member - _e2522.member) - select(0u, 1u, (_e2509.member_1 < _e2522.member_1)))) + select(0u, 1u, (_e2592 < _e2354)));
                        let _e2597 = (_e2411 + (_e2566.member_1 - _e2579.member_1));
                        let _e2601 = ((((_e2391.member - _e2404.member) - select(0u, 1u, (_e2391.member_1 < _e2404.member_1))) + ((_e2566.member - _e2579.member) - select(0u, 1u, (_e2566.member_1 < _e2579.member_1)))) + select(0u, 1u, (_e2597 < _e2411)));
                        let _e2608 = function_10(_e1886[0][0][0].member, _e1886[0][0][0].member_1, _e1946, _e1947);
                        let _e2615 = function_10(_e1886[0][0][1].member, _e1886[0][0][1].member_1, _e2003, _e2004);
                        let _e2618 = (_e2608.member_1 + _e2615.member_1);
                        let _e2627 = function_10(_e1886[0][0][2].member, _e1886[0][0][2].member_1, _e2060, _e2061);
                        let _e2630 = (_e2618 + _e2627.member_1);
                        let _e2635 = function_13(((((_e2608.member + _e2615.member) + select(0u, 1u, (_e2618 < _e2608.member_1))) + _e2627.member) + select(0u, 1u, (_e2630 < _e2618))), _e2630);
                        let _e2644 = function_10(_e1886[0][1][0].member, _e1886[0][1][0].member_1, _e1946, _e1947);
                        let _e2651 = function_10(_e1886[0][1][1].member, _e1886[0][1][1].member_1, _e2003, _e2004);
                        let _e2654 = (_e2644.member_1 + _e2651.member_1);
                        let _e2663 = function_10(_e1886[0][1][2].member, _e1886[0][1][2].member_1, _e2060, _e2061);
                        let _e2666 = (_e2654 + _e2663.member_1);
                        let _e2677 = function_10(_e1886[0][0][0].member, _e1886[0][0][0].member_1, _e2591, _e2587);
                        let _e2684 = function_10(_e1886[0][0][1].member, _e1886[0][0][1].member_1, _e2596, _e2592);
                        let _e2687 = (_e2677.member_1 + _e2684.member_1);
                        let _e2696 = function_10(_e1886[0][0][2].member, _e1886[0][0][2].member_1, _e2601, _e2597);
                        let _e2699 = (_e2687 + _e2696.member_1);
                        let _e2704 = (_e2666 + _e2699);
                        let _e2708 = ((((((_e2644.member + _e2651.member) + select(0u, 1u, (_e2654 < _e2644.member_1))) + _e2663.member) + select(0u, 1u, (_e2666 < _e2654))) + ((((_e2677.member + _e2684.member) + select(0u, 1u, (_e2687 < _e2677.member_1))) + _e2696.member) + select(0u, 1u, (_e2699 < _e2687)))) + select(0u, 1u, (_e2704 < _e2666)));
                        let _e2715 = function_10(_e1886[0][0][0].member, _e1886[0][0][0].member_1, _e2121, _e2122);
                        let _e2722 = function_10(_e1886[0][0][1].member, _e1886[0][0][1].member_1, _e2178, _e2179);
                        let _e2725 = (_e2715.member_1 + _e2722.member_1);
                        let _e2734 = function_10(_e1886[0][0][2].member, _e1886[0][0][2].member_1, _e2235, _e2236);
                        let _e2737 = (_e2725 + _e2734.member_1);
                        let _e2748 = function_10(_e1886[0][1][0].member, _e1886[0][1][0].member_1, _e2591, _e2587);
                        let _e2755 = function_10(_e1886[0][1][1].member, _e1886[0][1][1].member_1, _e2596, _e2592);
                        let _e2758 = (_e2748.member_1 + _e2755.member_1);
                        let _e2767 = function_10(_e1886[0][1][2].member, _e1886[0][1][2].member_1, _e2601, _e2597);
                        let _e2770 = (_e2758 + _e2767.member_1);
                        let _e2775 = (_e2737 + _e2770);
                        let _e2779 = ((((((_e2715.member + _e2722.member) + select(0u, 1u, (_e2725 < _e2715.member_1))) + _e2734.member) + select(0u, 1u, (_e2737 < _e2725))) + ((((_e2748.member + _e2755.member) + select(0u, 1u, (_e2758 < _e2748.member_1))) + _e2767.member) + select(0u, 1u, (_e2770 < _e2758)))) + select(0u, 1u, (_e2775 < _e2737)));
                        let _e2786 = function_10(_e1886[0][1][0].member, _e1886[0][1][0].member_1, _e2121, _e2122);
                        let _e2793 = function_10(_e1886[0][1][1].member, _e1886[0][1][1].member_1, _e2178, _e2179);
                        let _e2796 = (_e2786.member_1 + _e2793.member_1);
                        let _e2805 = function_10(_e1886[0][1][2].member, _e1886[0][1][2].member_1, _e2235, _e2236);
                        let _e2808 = (_e2796 + _e2805.member_1);
                        let _e2813 = function_13(((((_e2786.member + _e2793.member) + select(0u, 1u, (_e2796 < _e2786.member_1))) + _e2805.member) + select(0u, 1u, (_e2808 < _e2796))), _e2808);
                        phi_5082_ = type_9(0u, 128u);
                        phi_5085_ = array<type_9, 4>(_e2635, type_9(_e2708, _e2704), type_9(_e2779, _e2775), _e2813);
                        phi_5089_ = 0u;
                        phi_5091_ = 0u;
                        loop {
                            let _e2820 = phi_5082_;
                            let _e2822 = phi_5085_;
                            let _e2824 = phi_5089_;
                            let _e2826 = phi_5091_;
                            local_53 = _e2822;
                            local_54 = _e2822;
                            local_55 = _e2822;
                            let _e2829 = (_e2820.member < _e2820.member_1);
                            if (bitcast<i32>(select(0u, 1u, _e2829)) != 0i) {
                                let _e2841 = (31u - _e2824);
                                let _e2844 = (_e2826 << bitcast<u32>((_e2841 & 31u)));
                                let _e2849 = (_e2844 > _e1309);
                                if _e2849 {
                                    phi_7799_ = array<type_9, 4>();
                                    phi_7801_ = u32();
                                    phi_7802_ = u32();
                                    phi_7803_ = bool();
                                    phi_7804_ = bool();
                                    phi_7805_ = u32();
                                    phi_7806_ = u32();
                                    phi_7807_ = false;
                                    phi_7808_ = false;
                                    phi_7809_ = false;
                                } else {
                                    if (((_e2826 + 1u) << bitcast<u32>((_e2841 & 31u))) < _e1307) {
                                        phi_5311_ = true;
                                    } else {
                                        let _e2855 = function_12(128u);
                                        let _e2860 = ((_e2822[0].member >> bitcast<u32>(31i)) != 0u);
                                        let _e2888 = function_12(128u);
                                        let _e2893 = ((_e2822[1].member >> bitcast<u32>(31i)) != 0u);
                                        let _e2922 = function_12(128u);
                                        let _e2927 = ((_e2822[2].member >> bitcast<u32>(31i)) != 0u);
                                        let _e2956 = function_12(128u);
                                        let _e2961 = ((_e2822[3].member >> bitcast<u32>(31i)) != 0u);
                                        phi_5311_ = ((((select(0u, select(1u, 2u, ((_e2822[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e2855.member - select(_e2822[0].member, (~(_e2822[0].member) + select(0u, 1u, (_e2822[0].member_1 == 0u))), _e2860)) - select(0u, 1u, (_e2855.member_1 < select(_e2822[0].member_1, (~(_e2822[0].member_1) + 1u), _e2860)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e2822[1].member >> bitcast<u32>(31i)) != 0u)), ((((_e2888.member - select(_e2822[1].member, (~(_e2822[1].member) + select(0u, 1u, (_e2822[1].member_1 == 0u))), _e2893)) - select(0u, 1u, (_e2888.member_1 < select(_e2822[1].member_1, (~(_e2822[1].member_1) + 1u), _e2893)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2822[2].member >> bitcast<u32>(31i)) != 0u)), ((((_e2922.member - select(_e2822[2].member, (~(_e2822[2].member) + select(0u, 1u, (_e2822[2].member_1 == 0u))), _e2927)) - select(0u, 1u, (_e2922.member_1 < select(_e2822[2].member_1, (~(_e2822[2].member_1) + 1u), _e2927)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e2822[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e2956.member - select(_e2822[3].member, (~(_e2822[3].member) + select(0u, 1u, (_e2822[3].member_1 == 0u))), _e2961)) - select(0u, 1u, (_e2956.member_1 < select(_e2822[3].member_1, (~(_e2822[3].member_1) + 1u), _e2961)))) >> bitcast<u32>(31i)) != 0u))) != 0u);
                                    }
                                    let _e2988 = phi_5311_;
                                    if _e2988 {
                                        phi_7480_ = _e2822;
                                        phi_7482_ = _e2988;
                                        phi_7483_ = _e2824;
                                        phi_7484_ = _e2826;
                                        phi_7485_ = bool();
                                        phi_7486_ = bool();
                                        phi_7487_ = u32();
                                        phi_7488_ = u32();
                                        phi_7489_ = true;
                                    } else {
                                        let _e2989 = (_e2824 == 31u);
                                        if select(select(select((_e2824 == 14u), true, (_e2824 == 8u)), true, (_e2824 == 3u)), true, _e2989) {
                                            let _e3000 = function_12(128u);
                                            let _e3005 = ((_e2822[0].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3033 = function_12(128u);
                                            let _e3038 = ((_e2822[3].member >> bitcast<u32>(31i)) != 0u);
                                            let _e3063 = ((select(0u, select(1u, 2u, ((_e2822[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e3000.member - select(_e2822[0].member, (~(_e2822[0].member) + select(0u, 1u, (_e2822[0].member_1 == 0u))), _e3005)) - select(0u, 1u, (_e3000.member_1 < select(_e2822[0].member_1, (~(_e2822[0].member_1) + 1u), _e3005)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e2822[3].member >> bitcast<u32>(31i)) != 0u)), ((((_e3033.member - select(_e2822[3].member, (~(_e2822[3].member) + select(0u, 1u, (_e2822[3].member_1 == 0u))), _e3038)) - select(0u, 1u, (_e3033.member_1 < select(_e2822[3].member_1, (~(_e2822[3].member_1) + 1u), _e3038)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                            let _e3065 = select(false, !(_e3063), _e2989);
                                            if _e3065 {
                                                phi_5440_ = select((bitcast<u32>(31i) - firstLeadingBit(_e1311)), 32u, (_e1311 == 0u));
                                            } else {
                                                phi_5440_ = _e2824;
                                            }
                                            let _e3072 = phi_5440_;
                                            let _e3094 = ((_e1886[0][1][0].member - _e1886[0][0][0].member) - select(0u, 1u, (_e1886[0][1][0].member_1 < _e1886[0][0][0].member_1)));
                                            let _e3095 = (_e1886[0][1][0].member_1 - _e1886[0][0][0].member_1);
                                            let _e3107 = ((_e1886[0][1][1].member - _e1886[0][0][1].member) - select(0u, 1u, (_e1886[0][1][1].member_1 < _e1886[0][0][1].member_1)));
                                            let _e3108 = (_e1886[0][1][1].member_1 - _e1886[0][0][1].member_1);
                                            let _e3120 = ((_e1886[0][1][2].member - _e1886[0][0][2].member) - select(0u, 1u, (_e1886[0][1][2].member_1 < _e1886[0][0][2].member_1)));
                                            let _e3121 = (_e1886[0][1][2].member_1 - _e1886[0][0][2].member_1);
                                            let _e3124 = ((_e3094 >> bitcast<u32>(31i)) != 0u);
                                            let _e3131 = select(_e3094, (~(_e3094) + select(0u, 1u, (_e3095 == 0u))), _e3124);
                                            let _e3132 = select(_e3095, (~(_e3095) + 1u), _e3124);
                                            let _e3135 = ((_e3107 >> bitcast<u32>(31i)) != 0u);
                                            let _e3142 = select(_e3107, (~(_e3107) + select(0u, 1u, (_e3108 == 0u))), _e3135);
                                            let _e3143 = select(_e3108, (~(_e3108) + 1u), _e3135);
                                            let _e3150 = ((((_e3142 - _e3131) - select(0u, 1u, (_e3143 < _e3132))) >> bitcast<u32>(31i)) != 0u);
                                            let _e3151 = select(_e3142, _e3131, _e3150);
                                            let _e3152 = select(_e3143, _e3132, _e3150);
                                            let _e3155 = ((_e3120 >> bitcast<u32>(31i)) != 0u);
                                            let _e3162 = select(_e3120, (~(_e3120) + select(0u, 1u, (_e3121 == 0u))), _e3155);
                                            let _e3163 = select(_e3121, (~(_e3121) + 1u), _e3155);
                                            let _e3170 = ((((_e3162 - _e3151) - select(0u, 1u, (_e3163 < _e3152))) >> bitcast<u32>(31i)) != 0u);
                                            let _e3172 = select(_e3163, _e3152, _e3170);
                                            let _e3173 = function_12(4u);
                                            let _e3176 = (_e3172 + _e3173.member_1);
                                            let _e3180 = ((select(_e3162, _e3151, _e3170) + _e3173.member) + select(0u, 1u, (_e3176 < _e3172)));
                                            let _e3195 = ((_e3176 >> bitcast<u32>((_e3072 & 31u))) | ((_e3180 << bitcast<u32>(((31u - _e3072) & 31u))) << bitcast<u32>(1i)));
                                            let _e3196 = function_12(4u);
                                            let _e3199 = (_e3195 + _e3196.member_1);
                                            let _e3217 = ((_e1886[1][1][0].member - _e1886[1][0][0].member) - select(0u, 1u, (_e1886[1][1][0].member_1 < _e1886[1][0][0].member_1)));
                                            let _e3218 = (_e1886[1][1][0].member_1 - _e1886[1][0][0].member_1);
                                            let _e3230 = ((_e1886[1][1][1].member - _e1886[1][0][1].member) - select(0u, 1u, (_e1886[1][1][1].member_1 < _e1886[1][0][1].member_1)));
                                            let _e3231 = (_e1886[1][1][1].member_1 - _e1886[1][0][1].member_1);
                                            let _e3243 = ((_e1886[1][1][2].member - _e1886[1][0][2].member) - select(0u, 1u, (_e1886[1][1][2].member_1 < _e1886[1][0][2].member_1)));
                                            let _e3244 = (_e1886[1][1][2].member_1 - _e1886[1][0][2].member_1);
                                            let _e3247 = ((_e3217 >> bitcast<u32>(31i)) != 0u);
                                            let _e3254 = select(_e3217, (~(_e3217) + select(0u, 1u, (_e3218 == 0u))), _e3247);
                                            let _e3255 = select(_e3218, (~(_e3218) + 1u), _e3247);
                                            let _e3258 = ((_e3230 >> bitcast<u32>(31i)) != 0u);
                                            let _e3265 = select(_e3230, (~(_e3230) + select(0u, 1u, (_e3231 == 0u))), _e3258);
                                            let _e3266 = select(_e3231, (~(_e3231) + 1u), _e3258);
                                            let _e3273 = ((((_e3265 - _e3254) - select(0u, 1u, (_e3266 < _e3255))) >> bitcast<u32>(31i)) != 0u);
                                            let _e3274 = select(_e3265, _e3254, _e3273);
                                            let _e3275 = select(_e3266, _e3255, _e3273);
                                            let _e3278 = ((_e3243 >> bitcast<u32>(31i)) != 0u);
                                            let _e3285 = select(_e3243, (~(_e3243) + select(0u, 1u, (_e3244 == 0u))), _e3278);
                                            let _e3286 = select(_e3244, (~(_e3244) + 1u), _e3278);
                                            let _e3293 = ((((_e3285 - _e3274) - select(0u, 1u, (_e3286 < _e3275))) >> bitcast<u32>(31i)) != 0u);
                                            let _e3295 = select(_e3286, _e3275, _e3293);
                                            let _e3296 = function_12(4u);
                                            let _e3299 = (_e3295 + _e3296.member_1);
                                            let _e3303 = ((select(_e3285, _e3274, _e3293) + _e3296.member) + select(0u, 1u, (_e3299 < _e3295)));
                                            let _e3318 = ((_e3299 >> bitcast<u32>((_e3072 & 31u))) | ((_e3303 << bitcast<u32>(((31u - _e3072) & 31u))) << bitcast<u32>(1i)));
                                            let _e3319 = function_12(4u);
                                            let _e3322 = (_e3318 + _e3319.member_1);
                                            let _e3340 = ((_e1886[2][1][0].member - _e1886[2][0][0].member) - select(0u, 1u, (_e1886[2][1][0].member_1 < _e1886[2][0][0].member_1)));
                                            let _e3341 = (_e1886[2][1][0].member_1 - _e1886[2][0][0].member_1);
                                            let _e3353 = ((_e1886[2][1][1].member - _e1886[2][0][1].member) - select(0u, 1u, (_e1886[2][1][1].member_1 < _e1886[2][0][1].member_1)));
                                            let _e3354 = (_e1886[2][1][1].member_1 - _e1886[2][0][1].member_1);
                                            let _e3366 = ((_e1886[2][1][2].member - _e1886[2][0][2].member) - select(0u, 1u, (_e1886[2][1][2].member_1 < _e1886[2][0][2].member_1)));
                                            let _e3367 = (_e1886[2][1][2].member_1 - _e1886[2][0][2].member_1);
                                            let _e3370 = ((_e3340 >> bitcast<u32>(31i)) != 0u);
                                            let _e3377 = select(_e3340, (~(_e3340) + select(0u, 1u, (_e3341 == 0u))), _e3370);
                                            let _e3378 = select(_e3341, (~(_e3341) + 1u), _e3370);
                                            let _e3381 = ((_e3353 >> bitcast<u32>(31i)) != 0u);
                                            let _e3388 = select(_e3353, (~(_e3353) + select(0u, 1u, (_e3354 == 0u))), _e3381);
                                            let _e3389 = select(_e3354, (~(_e3354) + 1u), _e3381);
                                            let _e3396 = ((((_e3388 - _e3377) - select(0u, 1u, (_e3389 < _e3378))) >> bitcast<u32>(31i)) != 0u);
                                            let _e3397 = select(_e3388, _e3377, _e3396);
                                            let _e3398 = select(_e3389, _e3378, _e3396);
                                            let _e3401 = ((_e3366 >> bitcast<u32>(31i)) != 0u);
                                            let _e3408 = select(_e3366, (~(_e3366) + select(0u, 1u, (_e3367 == 0u))), _e3401);
                                            let _e3409 = select(_e3367, (~(_e3367) + 1u), _e3401);
                                            let _e3416 = ((((_e3408 - _e3397) - select(0u, 1u, (_e3409 < _e3398))) >> bitcast<u32>(31i)) != 0u);
                                            let _e3418 = select(_e3409, _e3398, _e3416);
                                            let _e3419 = function_12(4u);
                                            let _e3422 = (_e3418 + _e3419.member_1);
                                            let _e3426 = ((select(_e3408, _e3397, _e3416) + _e3419.member) + select(0u, 1u, (_e3422 < _e3418)));
                                            let _e3441 = ((_e3422 >> bitcast<u32>((_e3072 & 31u))) | ((_e3426 << bitcast<u32>(((31u - _e3072) & 31u))) << bitcast<u32>(1i)));
                                            let _e3442 = function_12(4u);
                                            let _e3445 = (_e3441 + _e3442.member_1);
                                            local_14[0u].member = ((bitcast<u32>((bitcast<i32>(_e3180) >> bitcast<u32>((_e3072 & 31u)))) + _e3196.member) + select(0u, 1u, (_e3199 < _e3195)));
                                            local_14[0u].member_1 = _e3199;
                                            local_14[1u].member = ((bitcast<u32>((bitcast<i32>(_e3303) >> bitcast<u32>((_e3072 & 31u)))) + _e3319.member) + select(0u, 1u, (_e3322 < _e3318)));
                                            local_14[1u].member_1 = _e3322;
                                            local_14[2u].member = ((bitcast<u32>((bitcast<i32>(_e3426) >> bitcast<u32>((_e3072 & 31u)))) + _e3442.member) + select(0u, 1u, (_e3445 < _e3441)));
                                            local_14[2u].member_1 = _e3445;
                                            let _e3475 = function_6(((_e1886[0][1][0].member - _e1886[0][0][0].member) - select(0u, 1u, (_e1886[0][1][0].member_1 < _e1886[0][0][0].member_1))), (_e1886[0][1][0].member_1 - _e1886[0][0][0].member_1), _e2844);
                                            let _e3478 = (_e1886[0][0][0].member_1 + _e3475.member_1);
                                            let _e3482 = ((_e1886[0][0][0].member + _e3475.member) + select(0u, 1u, (_e3478 < _e1886[0][0][0].member_1)));
                                            let _e3496 = function_6(((_e1886[0][1][1].member - _e1886[0][0][1].member) - select(0u, 1u, (_e1886[0][1][1].member_1 < _e1886[0][0][1].member_1))), (_e1886[0][1][1].member_1 - _e1886[0][0][1].member_1), _e2844);
                                            let _e3499 = (_e1886[0][0][1].member_1 + _e3496.member_1);
                                            let _e3503 = ((_e1886[0][0][1].member + _e3496.member) + select(0u, 1u, (_e3499 < _e1886[0][0][1].member_1)));
                                            let _e3517 = function_6(((_e1886[0][1][2].member - _e1886[0][0][2].member) - select(0u, 1u, (_e1886[0][1][2].member_1 < _e1886[0][0][2].member_1))), (_e1886[0][1][2].member_1 - _e1886[0][0][2].member_1), _e2844);
                                            let _e3520 = (_e1886[0][0][2].member_1 + _e3517.member_1);
                                            let _e3524 = ((_e1886[0][0][2].member + _e3517.member) + select(0u, 1u, (_e3520 < _e1886[0][0][2].member_1)));
                                            let _e3540 = function_6(((_e1886[1][1][0].member - _e1886[1][0][0].member) - select(0u, 1u, (_e1886[1][1][0].member_1 < _e1886[1][0][0].member_1))), (_e1886[1][1][0].member_1 - _e1886[1][0][0].member_1), _e2844);
                                            let _e3543 = (_e1886[1][0][0].member_1 + _e3540.member_1);
                                            let _e3547 = ((_e1886[1][0][0].member + _e3540.member) + select(0u, 1u, (_e3543 < _e1886[1][0][0].member_1)));
                                            let _e3561 = function_6(((_e1886[1][1][1].member - _e1886[1][0][1].member) - select(0u, 1u, (_e1886[1][1][1].member_1 < _e1886[1][0][1].member_1))), (_e1886[1][1][1].member_1 - _e1886[1][0][1].member_1), _e2844);
                                            let _e3564 = (_e1886[1][0][1].member_1 + _e3561.member_1);
                                            let _e3568 = ((_e1886[1][0][1].member + _e3561.member) + select(0u, 1u, (_e3564 < _e1886[1][0][1].member_1)));
                                            let _e3582 = function_6(((_e1886[1][1][2].member - _e1886[1][0][2].member) - select(0u, 1u, (_e1886[1][1][2].member_1 < _e1886[1][0][2].member_1))), (_e1886[1][1][2].member_1 - _e1886[1][0][2].member_1), _e2844);
                                            let _e3585 = (_e1886[1][0][2].member_1 + _e3582.member_1);
                                            let _e3589 = ((_e1886[1][0][2].member + _e3582.member) + select(0u, 1u, (_e3585 < _e1886[1][0][2].member_1)));
                                            let _e3605 = function_6(((_e1886[2][1][0].member - _e1886[2][0][0].member) - select(0u, 1u, (_e1886[2][1][0].member_1 < _e1886[2][0][0].member_1))), (_e1886[2][1][0].member_1 - _e1886[2][0][0].member_1), _e2844);
                                            let _e3608 = (_e1886[2][0][0].member_1 + _e3605.member_1);
                                            let _e3612 = ((_e1886[2][0][0].member + _e3605.member) + select(0u, 1u, (_e3608 < _e1886[2][0][0].member_1)));
                                            let _e3626 = function_6(((_e1886[2][1][1].member - _e1886[2][0][1].member) - select(0u, 1u, (_e1886[2][1][1].member_1 < _e1886[2][0][1].member_1))), (_e1886[2][1][1].member_1 - _e1886[2][0][1].member_1), _e2844);
                                            let _e3629 = (_e1886[2][0][1].member_1 + _e3626.member_1);
                                            let _e3633 = ((_e1886[2][0][1].member + _e3626.member) + select(0u, 1u, (_e3629 < _e1886[2][0][1].member_1)));
                                            let _e3647 = function_6(((_e1886[2][1][2].member - _e1886[2][0][2].member) - select(0u, 1u, (_e1886[2][1][2].member_1 < _e1886[2][0][2].member_1))), (_e1886[2][1][2].member_1 - _e1886[2][0][2].member_1), _e2844);
                                            let _e3650 = (_e1886[2][0][2].member_1 + _e3647.member_1);
                                            let _e3654 = ((_e1886[2][0][2].member + _e3647.member) + select(0u, 1u, (_e3650 < _e1886[2][0][2].member_1)));
                                            local_12 = array<type_9, 3>(type_9(_e3547, _e3543), type_9(_e3568, _e3564), type_9(_e3589, _e3585));
                                            local_13 = array<type_9, 3>(type_9(_e3612, _e3608), type_9(_e3633, _e3629), type_9(_e3654, _e3650));
                                            let _e3665 = local_12[1u].member;
                                            let _e3667 = local_12[1u].member_1;
                                            let _e3670 = local_13[2u].member;
                                            let _e3672 = local_13[2u].member_1;
                                            let _e3673 = function_10(_e3665, _e3667, _e3670, _e3672);
                                            let _e3678 = local_12[2u].member;
                                            let _e3680 = local_12[2u].member_1;
                                            let _e3683 = local_13[1u].member;
                                            let _e3685 = local_13[1u].member_1;
                                            let _e3686 = function_10(_e3678, _e3680, _e3683, _e3685);
                                            let _e3692 = ((_e3673.member - _e3686.member) - select(0u, 1u, (_e3673.member_1 < _e3686.member_1)));
                                            let _e3693 = (_e3673.member_1 - _e3686.member_1);
                                            local_10 = array<type_9, 3>(type_9(_e3547, _e3543), type_9(_e3568, _e3564), type_9(_e3589, _e3585));
                                            local_11 = array<type_9, 3>(type_9(_e3612, _e3608), type_9(_e3633, _e3629), type_9(_e3654, _e3650));
                                            let _e3704 = local_10[2u].member;
                                            let _e3706 = local_10[2u].member_1;
                                            let _e3709 = local_11[0u].member;
                                            let _e3711 = local_11[0u].member_1;
                                            let _e3712 = function_10(_e3704, _e3706, _e3709, _e3711);
                                            let _e3717 = local_10[0u].member;
                                            let _e3719 = local_10[0u].member_1;
                                            let _e3722 = local_11[2u].member;
                                            let _e3724 = local_11[2u].member_1;
                                            let _e3725 = function_10(_e3717, _e3719, _e3722, _e3724);
                                            let _e3731 = ((_e3712.member - _e3725.member) - select(0u, 1u, (_e3712.member_1 < _e3725.member_1)));
                                            let _e3732 = (_e3712.member_1 - _e3725.member_1);
                                            local_8 = array<type_9, 3>(type_9(_e3547, _e3543), type_9(_e3568, _e3564), type_9(_e3589, _e3585));
                                            local_9 = array<type_9, 3>(type_9(_e3612, _e3608), type_9(_e3633, _e3629), type_9(_e3654, _e3650));
                                            let _e3743 = local_8[0u].member;
                                            let _e3745 = local_8[0u].member_1;
                                            let _e3748 = local_9[1u].member;
                                            let _e3750 = local_9[1u].member_1;
                                            let _e3751 = function_10(_e3743, _e3745, _e3748, _e3750);
                                            let _e3756 = local_8[1u].member;
                                            let _e3758 = local_8[1u].member_1;
                                            let _e3761 = local_9[0u].member;
                                            let _e3763 = local_9[0u].member_1;
                                            let _e3764 = function_10(_e3756, _e3758, _e3761, _e3763);
                                            let _e3770 = ((_e3751.member - _e3764.member) - select(0u, 1u, (_e3751.member_1 < _e3764.member_1)));
                                            let _e3771 = (_e3751.member_1 - _e3764.member_1);
                                            let _e3774 = ((_e3692 >> bitcast<u32>(31i)) != 0u);
                                            let _e3781 = select(_e3692, (~(_e3692) + select(0u, 1u, (_e3693 == 0u))), _e3774);
                                            let _e3782 = select(_e3693, (~(_e3693) + 1u), _e3774);
                                            let _e3785 = ((_e3731 >> bitcast<u32>(31i)) != 0u);
                                            let _e3792 = select(_e3731, (~(_e3731) + select(0u, 1u, (_e3732 == 0u))), _e3785);
                                            let _e3793 = select(_e3732, (~(_e3732) + 1u), _e3785);
                                            let _e3796 = ((_e3770 >> bitcast<u32>(31i)) != 0u);
                                            let _e3803 = select(_e3770, (~(_e3770) + select(0u, 1u, (_e3771 == 0u))), _e3796);
                                            let _e3804 = select(_e3771, (~(_e3771) + 1u), _e3796);
                                            let _e3829 = select(0i, select(2i, 1i, ((((_e3803 - _e3792) - select(0u, 1u, (_e3804 < _e3793))) >> bitcast<u32>(31i)) != 0u)), select(true, select(true, false, ((((_e3803 - _e3781) - select(0u, 1u, (_e3804 < _e3782))) >> bitcast<u32>(31i)) != 0u)), ((((_e3792 - _e3781) - select(0u, 1u, (_e3793 < _e3782))) >> bitcast<u32>(31i)) != 0u)));
                                            switch _e3829 {
                                                case 0: {
                                                    phi_6589_ = array<type_9, 2>(type_9(_e3503, _e3499), type_9(_e3524, _e3520));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6589_ = array<type_9, 2>(type_9(_e3524, _e3520), type_9(_e3482, _e3478));
                                                    break;
                                                }
                                                default: {
                                                    phi_6589_ = array<type_9, 2>(type_9(_e3482, _e3478), type_9(_e3503, _e3499));
                                                    break;
                                                }
                                            }
                                            let _e3840 = phi_6589_;
                                            switch _e3829 {
                                                case 0: {
                                                    phi_6618_ = array<type_9, 2>(type_9(_e3568, _e3564), type_9(_e3589, _e3585));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6618_ = array<type_9, 2>(type_9(_e3589, _e3585), type_9(_e3547, _e3543));
                                                    break;
                                                }
                                                default: {
                                                    phi_6618_ = array<type_9, 2>(type_9(_e3547, _e3543), type_9(_e3568, _e3564));
                                                    break;
                                                }
                                            }
                                            let _e3851 = phi_6618_;
                                            switch _e3829 {
                                                case 0: {
                                                    phi_6647_ = array<type_9, 2>(type_9(_e3633, _e3629), type_9(_e3654, _e3650));
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6647_ = array<type_9, 2>(type_9(_e3654, _e3650), type_9(_e3612, _e3608));
                                                    break;
                                                }
                                                default: {
                                                    phi_6647_ = array<type_9, 2>(type_9(_e3612, _e3608), type_9(_e3633, _e3629));
                                                    break;
                                                }
                                            }
                                            let _e3862 = phi_6647_;
                                            switch _e3829 {
                                                case 0: {
                                                    phi_6661_ = type_9(_e3692, _e3693);
                                                    break;
                                                }
                                                case 1: {
                                                    phi_6661_ = type_9(_e3731, _e3732);
                                                    break;
                                                }
                                                default: {
                                                    phi_6661_ = type_9(_e3770, _e3771);
                                                    break;
                                                }
                                            }
                                            let _e3867 = phi_6661_;
                                            let _e3870 = local_14[1u].member;
                                            let _e3872 = local_14[1u].member_1;
                                            let _e3875 = local_14[2u].member;
                                            let _e3877 = local_14[2u].member_1;
                                            let _e3878 = (_e3872 + _e3877);
                                            let _e3882 = ((_e3870 + _e3875) + select(0u, 1u, (_e3878 < _e3872)));
                                            let _e3893 = ((_e3878 >> bitcast<u32>(1u)) | ((_e3882 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e3894 = function_12(17u);
                                            let _e3897 = (_e3893 + _e3894.member_1);
                                            let _e3901 = ((bitcast<u32>((bitcast<i32>(_e3882) >> bitcast<u32>(1u))) + _e3894.member) + select(0u, 1u, (_e3897 < _e3893)));
                                            let _e3904 = local_14[0u].member;
                                            let _e3906 = local_14[0u].member_1;
                                            let _e3909 = local_14[2u].member;
                                            let _e3911 = local_14[2u].member_1;
                                            let _e3912 = (_e3906 + _e3911);
                                            let _e3916 = ((_e3904 + _e3909) + select(0u, 1u, (_e3912 < _e3906)));
                                            let _e3927 = ((_e3912 >> bitcast<u32>(1u)) | ((_e3916 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e3928 = function_12(17u);
                                            let _e3931 = (_e3927 + _e3928.member_1);
                                            let _e3935 = ((bitcast<u32>((bitcast<i32>(_e3916) >> bitcast<u32>(1u))) + _e3928.member) + select(0u, 1u, (_e3931 < _e3927)));
                                            let _e3938 = local_14[0u].member;
                                            let _e3940 = local_14[0u].member_1;
                                            let _e3943 = local_14[1u].member;
                                            let _e3945 = local_14[1u].member_1;
                                            let _e3946 = (_e3940 + _e3945);
                                            let _e3950 = ((_e3938 + _e3943) + select(0u, 1u, (_e3946 < _e3940)));
                                            let _e3961 = ((_e3946 >> bitcast<u32>(1u)) | ((_e3950 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                            let _e3962 = function_12(17u);
                                            let _e3965 = (_e3961 + _e3962.member_1);
                                            let _e3969 = ((bitcast<u32>((bitcast<i32>(_e3950) >> bitcast<u32>(1u))) + _e3962.member) + select(0u, 1u, (_e3965 < _e3961)));
                                            let _e3974 = ((_e3867.member >> bitcast<u32>(31i)) != 0u);
                                            if ((((_e3901 - select(_e3867.member, (~(_e3867.member) + select(0u, 1u, (_e3867.member_1 == 0u))), _e3974)) - select(0u, 1u, (_e3897 < select(_e3867.member_1, (~(_e3867.member_1) + 1u), _e3974)))) >> bitcast<u32>(31i)) != 0u) {
                                                let _e3995 = ((_e3867.member >> bitcast<u32>(31i)) != 0u);
                                                let _e4005 = select(_e3867.member, (~(_e3867.member) + select(0u, 1u, (_e3867.member_1 == 0u))), _e3995);
                                                let _e4007 = select(_e3867.member_1, (~(_e3867.member_1) + 1u), _e3995);
                                                let _e4008 = function_11(_e3840, _e3862);
                                                let _e4018 = select(_e4008.member, (~(_e4008.member) + select(0u, 1u, (_e4008.member_1 == 0u))), _e3995);
                                                let _e4020 = select(_e4008.member_1, (~(_e4008.member_1) + 1u), _e3995);
                                                let _e4021 = function_11(_e3851, _e3840);
                                                let _e4031 = select(_e4021.member, (~(_e4021.member) + select(0u, 1u, (_e4021.member_1 == 0u))), _e3995);
                                                let _e4033 = select(_e4021.member_1, (~(_e4021.member_1) + 1u), _e3995);
                                                if (_e278.member != 0u) {
                                                    let _e4065 = (_e3897 + _e3931);
                                                    let _e4077 = (_e3897 + _e3965);
                                                    phi_6983_ = type_9(((_e3901 + _e3969) + select(0u, 1u, (_e4077 < _e3897))), _e4077);
                                                    phi_6984_ = type_9(((_e4005 - _e4031) - select(0u, 1u, (_e4007 < _e4033))), (_e4007 - _e4033));
                                                    phi_6985_ = type_9(((_e3901 + _e3935) + select(0u, 1u, (_e4065 < _e3897))), _e4065);
                                                    phi_6986_ = type_9(((_e4005 - _e4018) - select(0u, 1u, (_e4007 < _e4020))), (_e4007 - _e4020));
                                                } else {
                                                    let _e4039 = (_e4007 - _e4020);
                                                    let _e4043 = ((((_e4005 - _e4018) - select(0u, 1u, (_e4007 < _e4020))) - _e4031) - select(0u, 1u, (_e4039 < _e4033)));
                                                    let _e4044 = (_e4039 - _e4033);
                                                    let _e4046 = (_e3897 + _e3931);
                                                    let _e4051 = (_e4046 + _e3965);
                                                    let _e4055 = ((((_e3901 + _e3935) + select(0u, 1u, (_e4046 < _e3897))) + _e3969) + select(0u, 1u, (_e4051 < _e4046)));
                                                    phi_6983_ = type_9(_e4055, _e4051);
                                                    phi_6984_ = type_9(_e4043, _e4044);
                                                    phi_6985_ = type_9(_e4055, _e4051);
                                                    phi_6986_ = type_9(_e4043, _e4044);
                                                }
                                                let _e4084 = phi_6983_;
                                                let _e4086 = phi_6984_;
                                                let _e4088 = phi_6985_;
                                                let _e4090 = phi_6986_;
                                                let _e4091 = function_9(_e4018, _e4020, _e3935, _e3931);
                                                if _e4091 {
                                                    phi_7112_ = u32();
                                                    phi_7113_ = true;
                                                } else {
                                                    let _e4092 = function_9(_e4031, _e4033, _e3969, _e3965);
                                                    if _e4092 {
                                                        phi_7110_ = u32();
                                                        phi_7111_ = true;
                                                    } else {
                                                        let _e4097 = function_9(_e4090.member, _e4090.member_1, _e4088.member, _e4088.member_1);
                                                        if _e4097 {
                                                            phi_7108_ = u32();
                                                            phi_7109_ = true;
                                                        } else {
                                                            let _e4102 = function_9(_e4086.member, _e4086.member_1, _e4084.member, _e4084.member_1);
                                                            if _e4102 {
                                                                phi_7107_ = u32();
                                                            } else {
                                                                let _e4103 = function_8(_e4018, _e4020, _e3935, _e3931);
                                                                if _e4103 {
                                                                    let _e4104 = function_8(_e4031, _e4033, _e3969, _e3965);
                                                                    if _e4104 {
                                                                        let _e4109 = function_8(_e4090.member, _e4090.member_1, _e4088.member, _e4088.member_1);
                                                                        if _e4109 {
                                                                            let _e4114 = function_8(_e4086.member, _e4086.member_1, _e4084.member, _e4084.member_1);
                                                                            phi_7100_ = select(true, false, _e4114);
                                                                        } else {
                                                                            phi_7100_ = true;
                                                                        }
                                                                        let _e4117 = phi_7100_;
                                                                        phi_7101_ = _e4117;
                                                                    } else {
                                                                        phi_7101_ = true;
                                                                    }
                                                                    let _e4119 = phi_7101_;
                                                                    phi_7102_ = _e4119;
                                                                } else {
                                                                    phi_7102_ = true;
                                                                }
                                                                let _e4121 = phi_7102_;
                                                                phi_7107_ = select(0u, 2u, _e4121);
                                                            }
                                                            let _e4124 = phi_7107_;
                                                            phi_7108_ = _e4124;
                                                            phi_7109_ = _e4102;
                                                        }
                                                        let _e4126 = phi_7108_;
                                                        let _e4128 = phi_7109_;
                                                        phi_7110_ = _e4126;
                                                        phi_7111_ = _e4128;
                                                    }
                                                    let _e4130 = phi_7110_;
                                                    let _e4132 = phi_7111_;
                                                    phi_7112_ = _e4130;
                                                    phi_7113_ = _e4132;
                                                }
                                                let _e4134 = phi_7112_;
                                                let _e4136 = phi_7113_;
                                                phi_7118_ = select(_e4134, 1u, _e4136);
                                            } else {
                                                phi_7118_ = 2u;
                                            }
                                            let _e4139 = phi_7118_;
                                            let _e4140 = (_e4139 == 1u);
                                            phi_7130_ = _e4140;
                                            phi_7131_ = _e3063;
                                            phi_7132_ = _e3065;
                                            phi_7133_ = (_e2844 + (1u << bitcast<u32>(((31u - _e3072) & 31u))));
                                            phi_7134_ = _e4139;
                                            phi_7135_ = select(true, _e4140, _e2989);
                                        } else {
                                            phi_7130_ = _e2988;
                                            phi_7131_ = bool();
                                            phi_7132_ = bool();
                                            phi_7133_ = u32();
                                            phi_7134_ = u32();
                                            phi_7135_ = true;
                                        }
                                        let _e4143 = phi_7130_;
                                        let _e4145 = phi_7131_;
                                        let _e4147 = phi_7132_;
                                        let _e4149 = phi_7133_;
                                        let _e4151 = phi_7134_;
                                        let _e4153 = phi_7135_;
                                        if _e4153 {
                                            if _e4143 {
                                                phi_7472_ = _e2822;
                                                phi_7474_ = _e2824;
                                                phi_7475_ = _e2826;
                                            } else {
                                                let _e4162 = (_e2822[0].member_1 + _e2822[1].member_1);
                                                let _e4166 = ((_e2822[0].member + _e2822[1].member) + select(0u, 1u, (_e4162 < _e2822[0].member_1)));
                                                let _e4174 = bitcast<u32>((bitcast<i32>(_e4166) >> bitcast<u32>(1u)));
                                                let _e4177 = ((_e4162 >> bitcast<u32>(1u)) | ((_e4166 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4186 = (_e2822[1].member_1 + _e2822[2].member_1);
                                                let _e4190 = ((_e2822[1].member + _e2822[2].member) + select(0u, 1u, (_e4186 < _e2822[1].member_1)));
                                                let _e4198 = bitcast<u32>((bitcast<i32>(_e4190) >> bitcast<u32>(1u)));
                                                let _e4201 = ((_e4186 >> bitcast<u32>(1u)) | ((_e4190 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4210 = (_e2822[2].member_1 + _e2822[3].member_1);
                                                let _e4214 = ((_e2822[2].member + _e2822[3].member) + select(0u, 1u, (_e4210 < _e2822[2].member_1)));
                                                let _e4222 = bitcast<u32>((bitcast<i32>(_e4214) >> bitcast<u32>(1u)));
                                                let _e4225 = ((_e4210 >> bitcast<u32>(1u)) | ((_e4214 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4226 = (_e4177 + _e4201);
                                                let _e4230 = ((_e4174 + _e4198) + select(0u, 1u, (_e4226 < _e4177)));
                                                let _e4238 = bitcast<u32>((bitcast<i32>(_e4230) >> bitcast<u32>(1u)));
                                                let _e4241 = ((_e4226 >> bitcast<u32>(1u)) | ((_e4230 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4242 = (_e4201 + _e4225);
                                                let _e4246 = ((_e4198 + _e4222) + select(0u, 1u, (_e4242 < _e4201)));
                                                let _e4254 = bitcast<u32>((bitcast<i32>(_e4246) >> bitcast<u32>(1u)));
                                                let _e4257 = ((_e4242 >> bitcast<u32>(1u)) | ((_e4246 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4258 = (_e4241 + _e4257);
                                                let _e4262 = ((_e4238 + _e4254) + select(0u, 1u, (_e4258 < _e4241)));
                                                let _e4270 = bitcast<u32>((bitcast<i32>(_e4262) >> bitcast<u32>(1u)));
                                                let _e4273 = ((_e4258 >> bitcast<u32>(1u)) | ((_e4262 << bitcast<u32>(30u)) << bitcast<u32>(1i)));
                                                let _e4274 = (2u * _e2826);
                                                let _e4285 = function_12(128u);
                                                let _e4290 = ((_e2822[0].member >> bitcast<u32>(31i)) != 0u);
                                                let _e4314 = function_12(128u);
                                                let _e4319 = ((_e4174 >> bitcast<u32>(31i)) != 0u);
                                                let _e4341 = function_12(128u);
                                                let _e4346 = ((_e4238 >> bitcast<u32>(31i)) != 0u);
                                                let _e4368 = function_12(128u);
                                                let _e4373 = ((_e4270 >> bitcast<u32>(31i)) != 0u);
                                                if ((((select(0u, select(1u, 2u, ((_e2822[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e4285.member - select(_e2822[0].member, (~(_e2822[0].member) + select(0u, 1u, (_e2822[0].member_1 == 0u))), _e4290)) - select(0u, 1u, (_e4285.member_1 < select(_e2822[0].member_1, (~(_e2822[0].member_1) + 1u), _e4290)))) >> bitcast<u32>(31i)) != 0u)) & select(0u, select(1u, 2u, ((_e4174 >> bitcast<u32>(31i)) != 0u)), ((((_e4314.member - select(_e4174, (~(_e4174) + select(0u, 1u, (_e4177 == 0u))), _e4319)) - select(0u, 1u, (_e4314.member_1 < select(_e4177, (~(_e4177) + 1u), _e4319)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e4238 >> bitcast<u32>(31i)) != 0u)), ((((_e4341.member - select(_e4238, (~(_e4238) + select(0u, 1u, (_e4241 == 0u))), _e4346)) - select(0u, 1u, (_e4341.member_1 < select(_e4241, (~(_e4241) + 1u), _e4346)))) >> bitcast<u32>(31i)) != 0u))) & select(0u, select(1u, 2u, ((_e4270 >> bitcast<u32>(31i)) != 0u)), ((((_e4368.member - select(_e4270, (~(_e4270) + select(0u, 1u, (_e4273 == 0u))), _e4373)) - select(0u, 1u, (_e4368.member_1 < select(_e4273, (~(_e4273) + 1u), _e4373)))) >> bitcast<u32>(31i)) != 0u))) != 0u) {
                                                    phi_7470_ = array<type_9, 4>(type_9(_e4270, _e4273), type_9(_e4254, _e4257), type_9(_e4222, _e4225), _e2822[3]);
                                                    phi_7471_ = (_e4274 + 1u);
                                                } else {
                                                    phi_7470_ = array<type_9, 4>(_e2822[0], type_9(_e4174, _e4177), type_9(_e4238, _e4241), type_9(_e4270, _e4273));
                                                    phi_7471_ = _e4274;
                                                }
                                                let _e4403 = phi_7470_;
                                                let _e4405 = phi_7471_;
                                                phi_7472_ = _e4403;
                                                phi_7474_ = (_e2824 + 1u);
                                                phi_7475_ = _e4405;
                                            }
                                            let _e4407 = phi_7472_;
                                            let _e4409 = phi_7474_;
                                            let _e4411 = phi_7475_;
                                            phi_7476_ = _e4407;
                                            phi_7478_ = _e4409;
                                            phi_7479_ = _e4411;
                                        } else {
                                            phi_7476_ = array<type_9, 4>();
                                            phi_7478_ = u32();
                                            phi_7479_ = u32();
                                        }
                                        let _e4413 = phi_7476_;
                                        let _e4415 = phi_7478_;
                                        let _e4417 = phi_7479_;
                                        phi_7480_ = _e4413;
                                        phi_7482_ = _e4143;
                                        phi_7483_ = _e4415;
                                        phi_7484_ = _e4417;
                                        phi_7485_ = _e4145;
                                        phi_7486_ = _e4147;
                                        phi_7487_ = _e4149;
                                        phi_7488_ = _e4151;
                                        phi_7489_ = _e4153;
                                    }
                                    let _e4419 = phi_7480_;
                                    let _e4421 = phi_7482_;
                                    let _e4423 = phi_7483_;
                                    let _e4425 = phi_7484_;
                                    let _e4427 = phi_7485_;
                                    let _e4429 = phi_7486_;
                                    let _e4431 = phi_7487_;
                                    let _e4433 = phi_7488_;
                                    let _e4435 = phi_7489_;
                                    if _e4435 {
                                        if _e4421 {
                                            let _e4436 = (_e4425 + 1u);
                                            let _e4438 = (_e4436 & (4294967295u - _e4425));
                                            let _e4444 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e4438)), 32u, (_e4438 == 0u)));
                                            let _e4446 = select(_e4444, _e4423, (_e4423 < _e4444));
                                            let _e4449 = (_e4436 >> bitcast<u32>((_e4446 & 31u)));
                                            let _e4450 = (_e4423 - _e4446);
                                            let _e4454 = select(true, select(true, false, (_e4450 == 0u)), (_e4449 == 1u));
                                            if _e4454 {
                                                let _e4455 = (31u - _e4450);
                                                let _e4458 = (_e4449 << bitcast<u32>((_e4455 & 31u)));
                                                let _e4462 = ((_e4449 + 1u) << bitcast<u32>((_e4455 & 31u)));
                                                let _e4468 = function_6(((_e2708 - _e2635.member) - select(0u, 1u, (_e2704 < _e2635.member_1))), (_e2704 - _e2635.member_1), _e4458);
                                                let _e4471 = (_e2635.member_1 + _e4468.member_1);
                                                let _e4481 = function_6(((_e2779 - _e2708) - select(0u, 1u, (_e2775 < _e2704))), (_e2775 - _e2704), _e4458);
                                                let _e4484 = (_e2704 + _e4481.member_1);
                                                let _e4494 = function_6(((_e2813.member - _e2779) - select(0u, 1u, (_e2813.member_1 < _e2775))), (_e2813.member_1 - _e2775), _e4458);
                                                let _e4497 = (_e2775 + _e4494.member_1);
                                                let _e4505 = array<type_9, 3>(type_9(((_e2635.member + _e4468.member) + select(0u, 1u, (_e4471 < _e2635.member_1))), _e4471), type_9(((_e2708 + _e4481.member) + select(0u, 1u, (_e4484 < _e2704))), _e4484), type_9(((_e2779 + _e4494.member) + select(0u, 1u, (_e4497 < _e2775))), _e4497));
                                                let _e4511 = function_6(((_e2708 - _e2635.member) - select(0u, 1u, (_e2704 < _e2635.member_1))), (_e2704 - _e2635.member_1), _e4462);
                                                let _e4514 = (_e2635.member_1 + _e4511.member_1);
                                                let _e4524 = function_6(((_e2779 - _e2708) - select(0u, 1u, (_e2775 < _e2704))), (_e2775 - _e2704), _e4462);
                                                let _e4527 = (_e2704 + _e4524.member_1);
                                                let _e4537 = function_6(((_e2813.member - _e2779) - select(0u, 1u, (_e2813.member_1 < _e2775))), (_e2813.member_1 - _e2775), _e4462);
                                                let _e4540 = (_e2775 + _e4537.member_1);
                                                let _e4549 = function_7(_e4505, _e4458);
                                                let _e4550 = function_7(_e4505, _e4462);
                                                let _e4551 = function_7(array<type_9, 3>(type_9(((_e2635.member + _e4511.member) + select(0u, 1u, (_e4514 < _e2635.member_1))), _e4514), type_9(((_e2708 + _e4524.member) + select(0u, 1u, (_e4527 < _e2704))), _e4527), type_9(((_e2779 + _e4537.member) + select(0u, 1u, (_e4540 < _e2775))), _e4540)), _e4462);
                                                let _e4565 = function_6(((_e4549[1].member - _e4549[0].member) - select(0u, 1u, (_e4549[1].member_1 < _e4549[0].member_1))), (_e4549[1].member_1 - _e4549[0].member_1), _e4458);
                                                let _e4568 = (_e4549[0].member_1 + _e4565.member_1);
                                                let _e4586 = function_6(((_e4549[1].member - _e4549[0].member) - select(0u, 1u, (_e4549[1].member_1 < _e4549[0].member_1))), (_e4549[1].member_1 - _e4549[0].member_1), _e4462);
                                                let _e4589 = (_e4549[0].member_1 + _e4586.member_1);
                                                let _e4607 = function_6(((_e4550[1].member - _e4550[0].member) - select(0u, 1u, (_e4550[1].member_1 < _e4550[0].member_1))), (_e4550[1].member_1 - _e4550[0].member_1), _e4462);
                                                let _e4610 = (_e4550[0].member_1 + _e4607.member_1);
                                                let _e4628 = function_6(((_e4551[1].member - _e4551[0].member) - select(0u, 1u, (_e4551[1].member_1 < _e4551[0].member_1))), (_e4551[1].member_1 - _e4551[0].member_1), _e4462);
                                                let _e4631 = (_e4551[0].member_1 + _e4628.member_1);
                                                phi_7784_ = array<type_9, 4>(type_9(((_e4549[0].member + _e4565.member) + select(0u, 1u, (_e4568 < _e4549[0].member_1))), _e4568), type_9(((_e4549[0].member + _e4586.member) + select(0u, 1u, (_e4589 < _e4549[0].member_1))), _e4589), type_9(((_e4550[0].member + _e4607.member) + select(0u, 1u, (_e4610 < _e4550[0].member_1))), _e4610), type_9(((_e4551[0].member + _e4628.member) + select(0u, 1u, (_e4631 < _e4551[0].member_1))), _e4631));
                                            } else {
                                                phi_7784_ = array<type_9, 4>();
                                            }
                                            let _e4642 = phi_7784_;
                                            phi_7785_ = _e4642;
                                            phi_7786_ = _e4450;
                                            phi_7787_ = _e4449;
                                            phi_7788_ = _e4454;
                                        } else {
                                            phi_7785_ = _e4419;
                                            phi_7786_ = _e4423;
                                            phi_7787_ = _e4425;
                                            phi_7788_ = true;
                                        }
                                        let _e4644 = phi_7785_;
                                        let _e4646 = phi_7786_;
                                        let _e4648 = phi_7787_;
                                        let _e4650 = phi_7788_;
                                        phi_7793_ = _e4644;
                                        phi_7794_ = _e4646;
                                        phi_7795_ = _e4648;
                                        phi_7796_ = _e4650;
                                        phi_7797_ = select(true, false, _e4650);
                                        phi_7798_ = false;
                                    } else {
                                        phi_7793_ = array<type_9, 4>();
                                        phi_7794_ = u32();
                                        phi_7795_ = u32();
                                        phi_7796_ = false;
                                        phi_7797_ = false;
                                        phi_7798_ = true;
                                    }
                                    let _e4653 = phi_7793_;
                                    let _e4655 = phi_7794_;
                                    let _e4657 = phi_7795_;
                                    let _e4659 = phi_7796_;
                                    let _e4661 = phi_7797_;
                                    let _e4663 = phi_7798_;
                                    phi_7799_ = _e4653;
                                    phi_7801_ = _e4655;
                                    phi_7802_ = _e4657;
                                    phi_7803_ = _e4427;
                                    phi_7804_ = _e4429;
                                    phi_7805_ = _e4431;
                                    phi_7806_ = _e4433;
                                    phi_7807_ = _e4659;
                                    phi_7808_ = _e4661;
                                    phi_7809_ = _e4663;
                                }
                                let _e4665 = phi_7799_;
                                let _e4667 = phi_7801_;
                                let _e4669 = phi_7802_;
                                let _e4671 = phi_7803_;
                                let _e4673 = phi_7804_;
                                let _e4675 = phi_7805_;
                                let _e4677 = phi_7806_;
                                let _e4679 = phi_7807_;
                                let _e4681 = phi_7808_;
                                let _e4683 = phi_7809_;
                                phi_5086_ = _e4665;
                                phi_5090_ = _e4667;
                                phi_5092_ = _e4669;
                                phi_7810_ = _e2844;
                                phi_7811_ = _e4671;
                                phi_7812_ = _e4673;
                                phi_7813_ = _e4675;
                                phi_7814_ = _e4677;
                                phi_7815_ = _e4679;
                                phi_7816_ = _e2849;
                                phi_7817_ = false;
                                phi_7818_ = _e4681;
                                phi_7819_ = _e4683;
                            } else {
                                phi_5086_ = array<type_9, 4>();
                                phi_5090_ = u32();
                                phi_5092_ = u32();
                                phi_7810_ = u32();
                                phi_7811_ = bool();
                                phi_7812_ = bool();
                                phi_7813_ = u32();
                                phi_7814_ = u32();
                                phi_7815_ = false;
                                phi_7816_ = false;
                                phi_7817_ = true;
                                phi_7818_ = false;
                                phi_7819_ = false;
                            }
                            let _e4685 = phi_5086_;
                            let _e4687 = phi_5090_;
                            let _e4689 = phi_5092_;
                            let _e4691 = phi_7810_;
                            let _e4693 = phi_7811_;
                            let _e4695 = phi_7812_;
                            let _e4697 = phi_7813_;
                            let _e4699 = phi_7814_;
                            let _e4701 = phi_7815_;
                            let _e4703 = phi_7816_;
                            let _e4705 = phi_7817_;
                            let _e4707 = phi_7818_;
                            let _e4709 = phi_7819_;
                            local_42 = _e4703;
                            local_43 = _e4703;
                            local_44 = _e4703;
                            local_45 = _e4705;
                            local_46 = _e4703;
                            local_47 = _e4707;
                            local_48 = _e4703;
                            local_49 = _e4709;
                            local_50 = _e4703;
                            local_51 = _e4695;
                            local_52 = _e4697;
                            local_56 = _e4697;
                            local_57 = _e4697;
                            local_58 = _e4697;
                            local_59 = _e4697;
                            local_60 = _e4697;
                            local_61 = _e4697;
                            local_62 = _e4697;
                            local_63 = _e4697;
                            local_64 = _e4697;
                            local_65 = _e4697;
                            local_66 = _e4697;
                            local_67 = _e4697;
                            local_68 = _e4697;
                            local_69 = _e4693;
                            local_70 = _e4691;
                            local_71 = _e4697;
                            local_72 = _e4699;
                            local_73 = _e4691;
                            continue;
                            continuing {
                                phi_5082_ = type_9(select(_e2820.member, (_e2820.member + 1u), _e2829), select(_e2820.member_1, _e2820.member_1, _e2829));
                                phi_5085_ = _e4685;
                                phi_5089_ = _e4687;
                                phi_5091_ = _e4689;
                                break if !(_e4701);
                            }
                        }
                        let _e4713 = local_42;
                        let _e4718 = local_43;
                        let _e4721 = local_44;
                        let _e4723 = local_45;
                        let _e4724 = select(_e4723, false, _e4721);
                        let _e4726 = local_46;
                        let _e4728 = local_47;
                        let _e4731 = local_48;
                        let _e4733 = local_49;
                        let _e4740 = select(select(_e4728, false, _e4726), false, _e4724);
                        let _e4743 = local_50;
                        if select(select(select(_e4733, false, _e4731), false, _e4724), false, _e4740) {
                            let _e4754 = local_51;
                            if _e4754 {
                                let _e4756 = local_52;
                                if (_e4756 <= 2147483648u) {
                                    let _e4759 = local_53;
                                    let _e4763 = local_54;
                                    let _e4766 = function_12(128u);
                                    let _e4771 = ((_e4759[0].member >> bitcast<u32>(31i)) != 0u);
                                    let _e4779 = local_55;
                                    let _e4803 = local_56;
                                    let _e4804 = function_6(((_e2708 - _e2635.member) - select(0u, 1u, (_e2704 < _e2635.member_1))), (_e2704 - _e2635.member_1), _e4803);
                                    let _e4807 = (_e2635.member_1 + _e4804.member_1);
                                    let _e4818 = local_57;
                                    let _e4819 = function_6(((_e2779 - _e2708) - select(0u, 1u, (_e2775 < _e2704))), (_e2775 - _e2704), _e4818);
                                    let _e4822 = (_e2704 + _e4819.member_1);
                                    let _e4833 = local_58;
                                    let _e4834 = function_6(((_e2813.member - _e2779) - select(0u, 1u, (_e2813.member_1 < _e2775))), (_e2813.member_1 - _e2775), _e4833);
                                    let _e4837 = (_e2775 + _e4834.member_1);
                                    let _e4845 = array<type_9, 3>(type_9(((_e2635.member + _e4804.member) + select(0u, 1u, (_e4807 < _e2635.member_1))), _e4807), type_9(((_e2708 + _e4819.member) + select(0u, 1u, (_e4822 < _e2704))), _e4822), type_9(((_e2779 + _e4834.member) + select(0u, 1u, (_e4837 < _e2775))), _e4837));
                                    let _e4852 = local_59;
                                    let _e4853 = function_6(((_e2708 - _e2635.member) - select(0u, 1u, (_e2704 < _e2635.member_1))), (_e2704 - _e2635.member_1), _e4852);
                                    let _e4856 = (_e2635.member_1 + _e4853.member_1);
                                    let _e4867 = local_60;
                                    let _e4868 = function_6(((_e2779 - _e2708) - select(0u, 1u, (_e2775 < _e2704))), (_e2775 - _e2704), _e4867);
                                    let _e4871 = (_e2704 + _e4868.member_1);
                                    let _e4882 = local_61;
                                    let _e4883 = function_6(((_e2813.member - _e2779) - select(0u, 1u, (_e2813.member_1 < _e2775))), (_e2813.member_1 - _e2775), _e4882);
                                    let _e4886 = (_e2775 + _e4883.member_1);
                                    let _e4896 = local_62;
                                    let _e4897 = function_7(_e4845, _e4896);
                                    let _e4899 = local_63;
                                    let _e4900 = function_7(_e4845, _e4899);
                                    let _e4902 = local_64;
                                    let _e4903 = function_7(array<type_9, 3>(type_9(((_e2635.member + _e4853.member) + select(0u, 1u, (_e4856 < _e2635.member_1))), _e4856), type_9(((_e2708 + _e4868.member) + select(0u, 1u, (_e4871 < _e2704))), _e4871), type_9(((_e2779 + _e4883.member) + select(0u, 1u, (_e4886 < _e2775))), _e4886)), _e4902);
                                    let _e4918 = local_65;
                                    let _e4919 = function_6(((_e4897[1].member - _e4897[0].member) - select(0u, 1u, (_e4897[1].member_1 < _e4897[0].member_1))), (_e4897[1].member_1 - _e4897[0].member_1), _e4918);
                                    let _e4922 = (_e4897[0].member_1 + _e4919.member_1);
                                    let _e4926 = ((_e4897[0].member + _e4919.member) + select(0u, 1u, (_e4922 < _e4897[0].member_1)));
                                    let _e4941 = local_66;
                                    let _e4942 = function_6(((_e4897[1].member - _e4897[0].member) - select(0u, 1u, (_e4897[1].member_1 < _e4897[0].member_1))), (_e4897[1].member_1 - _e4897[0].member_1), _e4941);
                                    let _e4957 = local_67;
                                    let _e4958 = function_6(((_e4900[1].member - _e4900[0].member) - select(0u, 1u, (_e4900[1].member_1 < _e4900[0].member_1))), (_e4900[1].member_1 - _e4900[0].member_1), _e4957);
                                    let _e4973 = local_68;
                                    let _e4974 = function_6(((_e4903[1].member - _e4903[0].member) - select(0u, 1u, (_e4903[1].member_1 < _e4903[0].member_1))), (_e4903[1].member_1 - _e4903[0].member_1), _e4973);
                                    let _e4975 = function_12(128u);
                                    let _e4980 = ((_e4926 >> bitcast<u32>(31i)) != 0u);
                                    phi_8194_ = ((select(0u, select(1u, 2u, ((_e4759[0].member >> bitcast<u32>(31i)) != 0u)), ((((_e4766.member - select(_e4779[0].member, (~(_e4759[0].member) + select(0u, 1u, (_e4763[0].member_1 == 0u))), _e4771)) - select(0u, 1u, (_e4766.member_1 < select(_e4779[0].member_1, (~(_e4763[0].member_1) + 1u), _e4771)))) >> bitcast<u32>(31i)) != 0u)) | select(0u, select(1u, 2u, ((_e4926 >> bitcast<u32>(31i)) != 0u)), ((((_e4975.member - select(_e4926, (~(_e4926) + select(0u, 1u, (_e4922 == 0u))), _e4980)) - select(0u, 1u, (_e4975.member_1 < select(_e4922, (~(_e4922) + 1u), _e4980)))) >> bitcast<u32>(31i)) != 0u))) == 3u);
                                    phi_8195_ = false;
                                } else {
                                    phi_8194_ = bool();
                                    phi_8195_ = true;
                                }
                                let _e5004 = phi_8194_;
                                let _e5006 = phi_8195_;
                                phi_8196_ = _e5004;
                                phi_8197_ = _e5006;
                            } else {
                                phi_8196_ = bool();
                                phi_8197_ = true;
                            }
                            let _e5008 = phi_8196_;
                            let _e5010 = phi_8197_;
                            let _e5012 = local_69;
                            let _e5013 = select(_e5008, _e5012, _e5010);
                            let _e5015 = local_70;
                            let _e5018 = local_71;
                            let _e5020 = select(false, (_e5018 <= _e1309), (_e5015 >= _e1307));
                            let _e5022 = local_72;
                            let _e5028 = select(select(bool(), select(bool(), (_e5022 == 0u), _e5020), _e5013), false, select(true, select(true, false, _e5020), _e5013));
                            let _e5032 = local_73;
                            phi_8229_ = type_9(select(2u, 1u, _e5028), select(type_9().member_1, _e5032, _e5028));
                            phi_8230_ = true;
                            phi_8231_ = false;
                        } else {
                            phi_8229_ = type_9(select(type_9().member, 0u, _e4740), select(type_9().member_1, type_9().member_1, _e4740));
                            phi_8230_ = _e4740;
                            phi_8231_ = select(select(_e4743, false, _e4724), false, _e4740);
                        }
                        let _e5036 = phi_8229_;
                        let _e5038 = phi_8230_;
                        let _e5040 = phi_8231_;
                        let _e5045 = select(_e5040, true, _e5038);
                        let _e5047 = select(select(type_9().member_1, type_9().member_1, _e4724), select(select(type_9().member_1, type_9().member_1, _e4718), _e5036.member_1, _e5038), _e5045);
                        switch bitcast<i32>(select(select(type_9().member, 2u, _e4724), select(select(type_9().member, 0u, _e4713), _e5036.member, _e5038), _e5045)) {
                            case 0: {
                                phi_8277_ = type_30(0u, 0u, array<u32, 2>(0u, 0u), false);
                                break;
                            }
                            case 1: {
                                if (_e5047 == 0u) {
                                    phi_8271_ = array<u32, 2>(0u, 0u);
                                } else {
                                    let _e5056 = select((bitcast<u32>(31i) - firstLeadingBit(_e5047)), 32u, (_e5047 == 0u));
                                    let _e5061 = ((_e5047 << bitcast<u32>((_e5056 & 31u))) << bitcast<u32>(1i));
                                    phi_8271_ = array<u32, 2>((_e5061 << bitcast<u32>(20i)), (((1023u - _e5056) << bitcast<u32>(20i)) | (_e5061 >> bitcast<u32>(12i))));
                                }
                                let _e5072 = phi_8271_;
                                phi_8277_ = type_30(0u, select(0u, 1u, (_e5047 > _e1307)), _e5072, true);
                                break;
                            }
                            case 2: {
                                phi_8277_ = type_30(1u, 0u, array<u32, 2>(0u, 0u), true);
                                break;
                            }
                            default: {
                                phi_8277_ = type_30();
                                break;
                            }
                        }
                        let _e5075 = phi_8277_;
                        phi_8284_ = _e5075;
                        phi_8285_ = select(true, false, (_e5075.member == 0u));
                    } else {
                        phi_8284_ = type_30();
                        phi_8285_ = true;
                    }
                    let _e5080 = phi_8284_;
                    let _e5082 = phi_8285_;
                    phi_8286_ = _e5080;
                    phi_8287_ = _e5082;
                } else {
                    phi_8286_ = type_30();
                    phi_8287_ = true;
                }
                let _e5084 = phi_8286_;
                let _e5086 = phi_8287_;
                if _e5086 {
                    let _e5088 = params.member.member.member_11;
                    let _e5090 = params.member.member.member_12;
                    let _e5092 = params.member.member.member_13;
                    let _e5094 = params.member.member.member_13;
                    let _e5100 = select(_e534.member[0][0], -(_e534.member[0][0]), (_e534.member[0][0] < 0f));
                    let _e5104 = select(_e534.member[0][1], -(_e534.member[0][1]), (_e534.member[0][1] < 0f));
                    let _e5106 = select(_e5104, _e5100, (_e5100 > _e5104));
                    let _e5110 = select(_e534.member[0][2], -(_e534.member[0][2]), (_e534.member[0][2] < 0f));
                    let _e5112 = select(_e5110, _e5106, (_e5106 > _e5110));
                    let _e5118 = select(_e534.member[1][0], -(_e534.member[1][0]), (_e534.member[1][0] < 0f));
                    let _e5122 = select(_e534.member[1][1], -(_e534.member[1][1]), (_e534.member[1][1] < 0f));
                    let _e5124 = select(_e5122, _e5118, (_e5118 > _e5122));
                    let _e5128 = select(_e534.member[1][2], -(_e534.member[1][2]), (_e534.member[1][2] < 0f));
                    let _e5130 = select(_e5128, _e5124, (_e5124 > _e5128));
                    let _e5134 = (select(_e5130, _e5112, (_e5112 > _e5130)) + _e534.member_3);
                    let _e5140 = select(_e534.member_1[0][0], -(_e534.member_1[0][0]), (_e534.member_1[0][0] < 0f));
                    let _e5144 = select(_e534.member_1[0][1], -(_e534.member_1[0][1]), (_e534.member_1[0][1] < 0f));
                    let _e5146 = select(_e5144, _e5140, (_e5140 > _e5144));
                    let _e5150 = select(_e534.member_1[0][2], -(_e534.member_1[0][2]), (_e534.member_1[0][2] < 0f));
                    let _e5152 = select(_e5150, _e5146, (_e5146 > _e5150));
                    let _e5158 = select(_e534.member_1[1][0], -(_e534.member_1[1][0]), (_e534.member_1[1][0] < 0f));
                    let _e5162 = select(_e534.member_1[1][1], -(_e534.member_1[1][1]), (_e534.member_1[1][1] < 0f));
                    let _e5164 = select(_e5162, _e5158, (_e5158 > _e5162));
                    let _e5168 = select(_e534.member_1[1][2], -(_e534.member_1[1][2]), (_e534.member_1[1][2] < 0f));
                    let _e5170 = select(_e5168, _e5164, (_e5164 > _e5168));
                    let _e5174 = (select(_e5170, _e5152, (_e5152 > _e5170)) + _e534.member_3);
                    let _e5180 = select(_e534.member_2[0][0], -(_e534.member_2[0][0]), (_e534.member_2[0][0] < 0f));
                    let _e5184 = select(_e534.member_2[0][1], -(_e534.member_2[0][1]), (_e534.member_2[0][1] < 0f));
                    let _e5186 = select(_e5184, _e5180, (_e5180 > _e5184));
                    let _e5190 = select(_e534.member_2[0][2], -(_e534.member_2[0][2]), (_e534.member_2[0][2] < 0f));
                    let _e5192 = select(_e5190, _e5186, (_e5186 > _e5190));
                    let _e5198 = select(_e534.member_2[1][0], -(_e534.member_2[1][0]), (_e534.member_2[1][0] < 0f));
                    let _e5202 = select(_e534.member_2[1][1], -(_e534.member_2[1][1]), (_e534.member_2[1][1] < 0f));
                    let _e5204 = select(_e5202, _e5198, (_e5198 > _e5202));
                    let _e5208 = select(_e534.member_2[1][2], -(_e534.member_2[1][2]), (_e534.member_2[1][2] < 0f));
                    let _e5210 = select(_e5208, _e5204, (_e5204 > _e5208));
                    let _e5214 = (select(_e5210, _e5192, (_e5192 > _e5210)) + _e534.member_3);
                    let _e5216 = select(_e5174, _e5134, (_e5134 > _e5174));
                    let _e5218 = select(_e5214, _e5216, (_e5216 > _e5214));
                    if (_e5218 <= 65536f) {
                        phi_8558_ = (_e5218 >= (1f / 65536f));
                    } else {
                        phi_8558_ = false;
                    }
                    let _e5223 = phi_8558_;
                    if _e5223 {
                        phi_8656_ = type_28();
                        phi_8657_ = true;
                    } else {
                        if (_e5218 >= 0.000000000000000000000000000000000000011754944f) {
                            if ((bitcast<u32>(_e5218) & 2139095040u) != 2139095040u) {
                                let _e5230 = (2130706432u - (bitcast<u32>(_e5218) & 2139095040u));
                                let _e5233 = bitcast<f32>(select(8388608u, _e5230, (_e5230 > 8388608u)));
                                phi_8652_ = type_28(type_26(array<array<f32, 3>, 2>(array<f32, 3>((_e534.member[0][0] * _e5233), (_e534.member[0][1] * _e5233), (_e534.member[0][2] * _e5233)), array<f32, 3>((_e534.member[1][0] * _e5233), (_e534.member[1][1] * _e5233), (_e534.member[1][2] * _e5233))), array<array<f32, 3>, 2>(array<f32, 3>((_e534.member_1[0][0] * _e5233), (_e534.member_1[0][1] * _e5233), (_e534.member_1[0][2] * _e5233)), array<f32, 3>((_e534.member_1[1][0] * _e5233), (_e534.member_1[1][1] * _e5233), (_e534.member_1[1][2] * _e5233))), array<array<f32, 3>, 2>(array<f32, 3>((_e534.member_2[0][0] * _e5233), (_e534.member_2[0][1] * _e5233), (_e534.member_2[0][2] * _e5233)), array<f32, 3>((_e534.member_2[1][0] * _e5233), (_e534.member_2[1][1] * _e5233), (_e534.member_2[1][2] * _e5233))), ((_e534.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e5233)), (0f * _e5233));
                                phi_8653_ = false;
                            } else {
                                phi_8652_ = type_28();
                                phi_8653_ = true;
                            }
                            let _e5299 = phi_8652_;
                            let _e5301 = phi_8653_;
                            phi_8654_ = _e5299;
                            phi_8655_ = _e5301;
                        } else {
                            phi_8654_ = type_28();
                            phi_8655_ = true;
                        }
                        let _e5303 = phi_8654_;
                        let _e5305 = phi_8655_;
                        phi_8656_ = _e5303;
                        phi_8657_ = _e5305;
                    }
                    let _e5307 = phi_8656_;
                    let _e5309 = phi_8657_;
                    if _e5309 {
                        phi_8662_ = type_28(_e534, 0f);
                    } else {
                        phi_8662_ = _e5307;
                    }
                    let _e5312 = phi_8662_;
                    local_7 = type_26(array<array<f32, 3>, 2>(array<f32, 3>(_e5312.member.member[0][0], _e5312.member.member[0][1], _e5312.member.member[0][2]), array<f32, 3>(_e5312.member.member[1][0], _e5312.member.member[1][1], _e5312.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e5312.member.member_1[0][0], _e5312.member.member_1[0][1], _e5312.member.member_1[0][2]), array<f32, 3>(_e5312.member.member_1[1][0], _e5312.member.member_1[1][1], _e5312.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e5312.member.member_2[0][0], _e5312.member.member_2[0][1], _e5312.member.member_2[0][2]), array<f32, 3>(_e5312.member.member_2[1][0], _e5312.member.member_2[1][1], _e5312.member.member_2[1][2])), _e5312.member.member_3);
                    let _e5354 = local_7.member_1[0u];
                    let _e5360 = local_7.member_2[0u];
                    let _e5366 = ((_e5354[1] * _e5360[2]) - (_e5354[2] * _e5360[1]));
                    let _e5369 = ((_e5354[2] * _e5360[0]) - (_e5354[0] * _e5360[2]));
                    let _e5372 = ((_e5354[0] * _e5360[1]) - (_e5354[1] * _e5360[0]));
                    let _e5375 = local_7.member_1[1u];
                    let _e5381 = local_7.member_2[1u];
                    let _e5387 = ((_e5375[1] * _e5381[2]) - (_e5375[2] * _e5381[1]));
                    let _e5390 = ((_e5375[2] * _e5381[0]) - (_e5375[0] * _e5381[2]));
                    let _e5393 = ((_e5375[0] * _e5381[1]) - (_e5375[1] * _e5381[0]));
                    let _e5396 = local_7.member_1[0u];
                    let _e5402 = local_7.member_2[1u];
                    let _e5417 = local_7.member_1[1u];
                    let _e5423 = local_7.member_2[0u];
                    let _e5436 = (((_e5396[1] * _e5402[2]) - (_e5396[2] * _e5402[1])) + ((_e5417[1] * _e5423[2]) - (_e5417[2] * _e5423[1])));
                    let _e5437 = (((_e5396[2] * _e5402[0]) - (_e5396[0] * _e5402[2])) + ((_e5417[2] * _e5423[0]) - (_e5417[0] * _e5423[2])));
                    let _e5438 = (((_e5396[0] * _e5402[1]) - (_e5396[1] * _e5402[0])) + ((_e5417[0] * _e5423[1]) - (_e5417[1] * _e5423[0])));
                    let _e5441 = local_7.member[0u];
                    let _e5449 = (((_e5441[0] * _e5366) + (_e5441[1] * _e5369)) + (_e5441[2] * _e5372));
                    let _e5452 = local_7.member[1u];
                    let _e5463 = local_7.member[0u];
                    let _e5472 = ((((_e5452[0] * _e5366) + (_e5452[1] * _e5369)) + (_e5452[2] * _e5372)) + (((_e5463[0] * _e5436) + (_e5463[1] * _e5437)) + (_e5463[2] * _e5438)));
                    let _e5475 = local_7.member[0u];
                    let _e5486 = local_7.member[1u];
                    let _e5495 = ((((_e5475[0] * _e5387) + (_e5475[1] * _e5390)) + (_e5475[2] * _e5393)) + (((_e5486[0] * _e5436) + (_e5486[1] * _e5437)) + (_e5486[2] * _e5438)));
                    let _e5498 = local_7.member[1u];
                    let _e5506 = (((_e5498[0] * _e5387) + (_e5498[1] * _e5390)) + (_e5498[2] * _e5393));
                    let _e5509 = local_7.member[0u];
                    let _e5515 = select(_e5509[0], -(_e5509[0]), (_e5509[0] < 0f));
                    let _e5518 = select(_e5509[1], -(_e5509[1]), (_e5509[1] < 0f));
                    let _e5520 = select(_e5518, _e5515, (_e5515 > _e5518));
                    let _e5523 = select(_e5509[2], -(_e5509[2]), (_e5509[2] < 0f));
                    let _e5525 = select(_e5523, _e5520, (_e5520 > _e5523));
                    let _e5528 = local_7.member[1u];
                    let _e5534 = select(_e5528[0], -(_e5528[0]), (_e5528[0] < 0f));
                    let _e5537 = select(_e5528[1], -(_e5528[1]), (_e5528[1] < 0f));
                    let _e5539 = select(_e5537, _e5534, (_e5534 > _e5537));
                    let _e5542 = select(_e5528[2], -(_e5528[2]), (_e5528[2] < 0f));
                    let _e5544 = select(_e5542, _e5539, (_e5539 > _e5542));
                    let _e5548 = local_7.member_3;
                    let _e5549 = (select(_e5544, _e5525, (_e5525 > _e5544)) + _e5548);
                    let _e5552 = local_7.member_1[0u];
                    let _e5558 = select(_e5552[0], -(_e5552[0]), (_e5552[0] < 0f));
                    let _e5561 = select(_e5552[1], -(_e5552[1]), (_e5552[1] < 0f));
                    let _e5563 = select(_e5561, _e5558, (_e5558 > _e5561));
                    let _e5566 = select(_e5552[2], -(_e5552[2]), (_e5552[2] < 0f));
                    let _e5568 = select(_e5566, _e5563, (_e5563 > _e5566));
                    let _e5571 = local_7.member_1[1u];
                    let _e5577 = select(_e5571[0], -(_e5571[0]), (_e5571[0] < 0f));
                    let _e5580 = select(_e5571[1], -(_e5571[1]), (_e5571[1] < 0f));
                    let _e5582 = select(_e5580, _e5577, (_e5577 > _e5580));
                    let _e5585 = select(_e5571[2], -(_e5571[2]), (_e5571[2] < 0f));
                    let _e5587 = select(_e5585, _e5582, (_e5582 > _e5585));
                    let _e5591 = local_7.member_3;
                    let _e5592 = (select(_e5587, _e5568, (_e5568 > _e5587)) + _e5591);
                    let _e5595 = local_7.member_2[0u];
                    let _e5601 = select(_e5595[0], -(_e5595[0]), (_e5595[0] < 0f));
                    let _e5604 = select(_e5595[1], -(_e5595[1]), (_e5595[1] < 0f));
                    let _e5606 = select(_e5604, _e5601, (_e5601 > _e5604));
                    let _e5609 = select(_e5595[2], -(_e5595[2]), (_e5595[2] < 0f));
                    let _e5611 = select(_e5609, _e5606, (_e5606 > _e5609));
                    let _e5614 = local_7.member_2[1u];
                    let _e5620 = select(_e5614[0], -(_e5614[0]), (_e5614[0] < 0f));
                    let _e5623 = select(_e5614[1], -(_e5614[1]), (_e5614[1] < 0f));
                    let _e5625 = select(_e5623, _e5620, (_e5620 > _e5623));
                    let _e5628 = select(_e5614[2], -(_e5614[2]), (_e5614[2] < 0f));
                    let _e5630 = select(_e5628, _e5625, (_e5625 > _e5628));
                    let _e5634 = local_7.member_3;
                    let _e5635 = (select(_e5630, _e5611, (_e5611 > _e5630)) + _e5634);
                    let _e5637 = ((_e5592 * 8f) * _e5635);
                    let _e5644 = local_7.member_3;
                    let _e5668 = ((select(_e5366, -(_e5366), (_e5366 < 0f)) + select(_e5369, -(_e5369), (_e5369 < 0f))) + select(_e5372, -(_e5372), (_e5372 < 0f)));
                    let _e5679 = ((select(_e5387, -(_e5387), (_e5387 < 0f)) + select(_e5390, -(_e5390), (_e5390 < 0f))) + select(_e5393, -(_e5393), (_e5393 < 0f)));
                    let _e5681 = select(_e5679, _e5668, (_e5668 > _e5679));
                    let _e5693 = (((select(_e5436, -(_e5436), (_e5436 < 0f)) + select(_e5437, -(_e5437), (_e5437 < 0f))) + select(_e5438, -(_e5438), (_e5438 < 0f))) * 0.5f);
                    let _e5700 = local_7.member_3;
                    let _e5712 = (((((_e5549 * 8f) * _e5637) * (0.000000059604645f * (524f / 64f))) + ((_e5644 * 19f) * ((_e5549 * (_e5592 + _e5635)) + (_e5592 * _e5635)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e5549) * ((1f + _e5592) * (1f + _e5635)))));
                    let _e5713 = (_e5449 * 3f);
                    let _e5714 = (_e5506 * 3f);
                    let _e5716 = select(_e5714, _e5713, (_e5713 < _e5714));
                    let _e5718 = select(_e5495, _e5472, (_e5472 < _e5495));
                    let _e5720 = select(_e5718, _e5716, (_e5716 < _e5718));
                    let _e5722 = select(_e5714, _e5713, (_e5713 > _e5714));
                    let _e5724 = select(_e5495, _e5472, (_e5472 > _e5495));
                    let _e5731 = -(select(_e5724, _e5722, (_e5722 > _e5724)));
                    if ((select(_e5731, _e5720, (_e5720 > _e5731)) - (_e5712 + ((0f * (((select(_e5693, _e5681, (_e5681 > _e5693)) + (_e5637 * (0.000000059604645f * 8f))) + ((_e5700 * 6f) * (_e5592 + _e5635))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e5592) * (1f + _e5635))))) * (3f * 1.0001f)))) > 0f) {
                        phi_13884_ = type_29(0u, type_29().member_1);
                        phi_13885_ = type_29();
                        phi_13886_ = true;
                    } else {
                        let _e5739 = select(_e5449, -(_e5449), (_e5449 < 0f));
                        let _e5742 = select(_e5472, -(_e5472), (_e5472 < 0f));
                        let _e5744 = select(_e5742, _e5739, (_e5739 > _e5742));
                        let _e5747 = select(_e5495, -(_e5495), (_e5495 < 0f));
                        let _e5750 = select(_e5506, -(_e5506), (_e5506 < 0f));
                        let _e5752 = select(_e5750, _e5747, (_e5747 > _e5750));
                        let _e5754 = select(_e5752, _e5744, (_e5744 > _e5752));
                        let _e5755 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e5754 >= _e5755) {
                            phi_9387_ = (_e5754 <= (1f / _e5755));
                        } else {
                            phi_9387_ = false;
                        }
                        let _e5760 = phi_9387_;
                        if _e5760 {
                            phi_9399_ = (1f / _e5754);
                        } else {
                            phi_9399_ = 0f;
                        }
                        let _e5767 = phi_9399_;
                        let _e5768 = (_e5088 * 0.0625f);
                        local_5 = type_33(array<f32, 4>(_e5449, _e5472, _e5495, _e5506), ((_e5712 * 0.34f) + (_e5754 * select(2f, (0.000000059604645f * 256f), _e5760))), _e5767, select(_e5768, 0.00000000000022737368f, (0.00000000000022737368f < _e5768)));
                        let _e5775 = local_5.member[0u];
                        let _e5778 = local_5.member[1u];
                        let _e5781 = local_5.member[2u];
                        let _e5784 = local_5.member[3u];
                        let _e5791 = local_5.member_2;
                        let _e5792 = ((_e5778 - (3f * _e5775)) * _e5791);
                        let _e5794 = local_5.member_2;
                        let _e5795 = ((_e5781 - _e5778) * _e5794);
                        let _e5797 = local_5.member_2;
                        let _e5798 = (((3f * _e5784) - _e5781) * _e5797);
                        local_3[0u] = 0f;
                        local_3[1u] = 1f;
                        local_3[2u] = 1f;
                        local_3[3u] = 1f;
                        let _e5805 = ((_e5795 * _e5795) - (_e5792 * _e5798));
                        if (_e5805 > 0f) {
                            if (_e5805 <= 0.000000000000000000000000000000000000011754944f) {
                                phi_9527_ = select(0f, (0.000000000000000000106433627f * 2f), (_e5805 > 0f));
                            } else {
                                phi_9470_ = type_14(0i, 5i);
                                phi_9473_ = bitcast<f32>(((bitcast<u32>(_e5805) >> bitcast<u32>(1i)) + 532369198u));
                                loop {
                                    let _e5814 = phi_9470_;
                                    let _e5816 = phi_9473_;
                                    local_74 = _e5816;
                                    if (_e5814.member < _e5814.member_1) {
                                        let _e5823 = (_e5814.member + 1i);
                                        phi_9471_ = type_14(select(_e5823, type_15().member_1, select(false, true, ((false == (_e5823 > _e5814.member)) != false))), _e5814.member_1);
                                        phi_9514_ = type_15(1u, _e5814.member);
                                    } else {
                                        phi_9471_ = _e5814;
                                        phi_9514_ = type_15(0u, type_15().member_1);
                                    }
                                    let _e5834 = phi_9471_;
                                    let _e5836 = phi_9514_;
                                    let _e5839 = (bitcast<i32>(_e5836.member) != 0i);
                                    if _e5839 {
                                        phi_9474_ = (0.5f * (_e5816 + (_e5805 / _e5816)));
                                    } else {
                                        phi_9474_ = f32();
                                    }
                                    let _e5844 = phi_9474_;
                                    continue;
                                    continuing {
                                        phi_9470_ = _e5834;
                                        phi_9473_ = _e5844;
                                        break if !(_e5839);
                                    }
                                }
                                let _e5849 = local_74;
                                phi_9527_ = (_e5849 * (1f + (8f * 0.000000059604645f)));
                            }
                            let _e5855 = phi_9527_;
                            let _e5860 = -((_e5795 + select(_e5855, -(_e5855), (_e5795 < 0f))));
                            local_4[0u] = (_e5860 / (_e5860 + _e5798));
                            local_4[1u] = (_e5792 / (_e5792 + _e5860));
                            let _e5869 = local_4[1u];
                            let _e5870 = local_4[0u];
                            if (_e5869 < _e5870) {
                                let _e5873 = local_4[1u];
                                let _e5875 = local_4[0u];
                                local_4[0u] = _e5873;
                                local_4[1u] = _e5875;
                            }
                            phi_9558_ = type_9(0u, 2u);
                            phi_9561_ = 1u;
                            loop {
                                let _e5879 = phi_9558_;
                                let _e5881 = phi_9561_;
                                local_106 = _e5881;
                                let _e5884 = (_e5879.member < _e5879.member_1);
                                let _e5895 = select(type_9().member_1, _e5879.member, _e5884);
                                let _e5897 = (bitcast<i32>(select(0u, 1u, _e5884)) != 0i);
                                if _e5897 {
                                    let _e5899 = local_4[_e5895];
                                    if (_e5899 > 0f) {
                                        let _e5902 = local_4[_e5895];
                                        if (_e5902 < 1f) {
                                            let _e5905 = local_4[_e5895];
                                            local_3[_e5881] = _e5905;
                                            phi_9628_ = (_e5881 + 1u);
                                        } else {
                                            phi_9628_ = _e5881;
                                        }
                                        let _e5909 = phi_9628_;
                                        phi_9629_ = _e5909;
                                    } else {
                                        phi_9629_ = _e5881;
                                    }
                                    let _e5911 = phi_9629_;
                                    phi_9562_ = _e5911;
                                } else {
                                    phi_9562_ = u32();
                                }
                                let _e5913 = phi_9562_;
                                continue;
                                continuing {
                                    phi_9558_ = type_9(select(_e5879.member, (_e5879.member + 1u), _e5884), select(_e5879.member_1, _e5879.member_1, _e5884));
                                    phi_9561_ = _e5913;
                                    break if !(_e5897);
                                }
                            }
                            let _e8698 = local_106;
                            phi_9630_ = _e8698;
                        } else {
                            phi_9630_ = 1u;
                        }
                        let _e5916 = phi_9630_;
                        local_3[_e5916] = 1f;
                        let _e5918 = local_3;
                        local_6 = _e5918;
                        let _e5919 = (_e5088 * 0.99f);
                        let _e5920 = (1f - _e5090);
                        let _e5923 = local_5.member[0u];
                        let _e5926 = local_5.member[1u];
                        let _e5929 = local_5.member[2u];
                        let _e5932 = local_5.member[3u];
                        let _e5943 = ((((_e5923 * _e5920) + (_e5926 * _e5090)) * (_e5920 * _e5920)) + (((_e5929 * _e5920) + (_e5932 * _e5090)) * (_e5090 * _e5090)));
                        let _e5948 = local_5.member_1;
                        phi_9686_ = type_9(select(1u, 0u, !((select(_e5943, -(_e5943), (_e5943 < 0f)) > _e5948))), (_e5916 + 1u));
                        loop {
                            let _e5955 = phi_9686_;
                            let _e5958 = (_e5955.member < _e5955.member_1);
                            let _e5969 = select(type_9().member_1, _e5955.member, _e5958);
                            if (bitcast<i32>(select(0u, 1u, _e5958)) != 0i) {
                                if (_e5969 > 0u) {
                                    let _e5976 = local_6[(_e5969 - 1u)];
                                    let _e5978 = select(_e5090, _e5976, (_e5976 > _e5090));
                                    let _e5980 = local_6[_e5969];
                                    let _e5982 = select(_e5092, _e5980, (_e5980 < _e5092));
                                    if (_e5978 <= _e5982) {
                                        let _e5984 = function_5((&local_5), _e5094, _e5978, _e5982);
                                        if _e5984 {
                                            phi_11089_ = type_44();
                                            phi_11090_ = bool();
                                            phi_11091_ = type_44();
                                            phi_11092_ = false;
                                            phi_11093_ = false;
                                            phi_11094_ = false;
                                            phi_11095_ = false;
                                        } else {
                                            let _e5985 = (1f - _e5978);
                                            let _e5988 = local_5.member[0u];
                                            let _e5991 = local_5.member[1u];
                                            let _e5994 = local_5.member[2u];
                                            let _e5997 = local_5.member[3u];
                                            let _e6008 = ((((_e5988 * _e5985) + (_e5991 * _e5978)) * (_e5985 * _e5985)) + (((_e5994 * _e5985) + (_e5997 * _e5978)) * (_e5978 * _e5978)));
                                            let _e6009 = (1f - _e5982);
                                            let _e6012 = local_5.member[0u];
                                            let _e6015 = local_5.member[1u];
                                            let _e6018 = local_5.member[2u];
                                            let _e6021 = local_5.member[3u];
                                            let _e6032 = ((((_e6012 * _e6009) + (_e6015 * _e5982)) * (_e6009 * _e6009)) + (((_e6018 * _e6009) + (_e6021 * _e5982)) * (_e5982 * _e5982)));
                                            let _e6037 = local_5.member_1;
                                            let _e6038 = (select(_e6008, -(_e6008), (_e6008 < 0f)) > _e6037);
                                            let _e6043 = local_5.member_1;
                                            let _e6044 = (select(_e6032, -(_e6032), (_e6032 < 0f)) > _e6043);
                                            let _e6052 = select(select(bool(), select(bool(), ((_e6008 > 0f) != (_e6032 > 0f)), _e6044), _e6038), false, select(true, select(true, false, _e6044), _e6038));
                                            if _e6038 {
                                                if _e6044 {
                                                    phi_9842_ = type_44(select(1f, type_44().member, _e6052), select(0f, type_44().member_1, _e6052), select(_e6052, type_44().member_2, _e6052));
                                                    phi_9843_ = _e6052;
                                                } else {
                                                    phi_9842_ = type_44();
                                                    phi_9843_ = true;
                                                }
                                                let _e6061 = phi_9842_;
                                                let _e6063 = phi_9843_;
                                                phi_9844_ = _e6061;
                                                phi_9845_ = _e6063;
                                            } else {
                                                phi_9844_ = type_44();
                                                phi_9845_ = true;
                                            }
                                            let _e6065 = phi_9844_;
                                            let _e6067 = phi_9845_;
                                            if _e6067 {
                                                if _e6038 {
                                                    let _e6069 = select(1f, -1f, (_e6008 < 0f));
                                                    let _e6071 = local_5.member_3;
                                                    let _e6074 = local_5.member[0u];
                                                    let _e6077 = local_5.member[1u];
                                                    let _e6080 = local_5.member[2u];
                                                    let _e6083 = local_5.member[3u];
                                                    let _e6086 = (_e6080 - _e6077);
                                                    phi_9876_ = type_9(0u, 64u);
                                                    phi_9879_ = _e5982;
                                                    phi_9881_ = _e5978;
                                                    phi_9883_ = (0.5f * (_e5978 + _e5982));
                                                    loop {
                                                        let _e6092 = phi_9876_;
                                                        let _e6094 = phi_9879_;
                                                        let _e6096 = phi_9881_;
                                                        let _e6098 = phi_9883_;
                                                        local_77 = _e6096;
                                                        let _e6101 = (_e6092.member < _e6092.member_1);
                                                        if (bitcast<i32>(select(0u, 1u, _e6101)) != 0i) {
                                                            let _e6113 = (1f - _e6098);
                                                            let _e6116 = local_5.member[0u];
                                                            let _e6119 = local_5.member[1u];
                                                            let _e6122 = local_5.member[2u];
                                                            let _e6125 = local_5.member[3u];
                                                            let _e6139 = local_5.member_1;
                                                            let _e6140 = ((_e6069 * ((((_e6116 * _e6113) + (_e6119 * _e6098)) * (_e6113 * _e6113)) + (((_e6122 * _e6113) + (_e6125 * _e6098)) * (_e6098 * _e6098)))) - _e6139);
                                                            let _e6141 = (_e6140 > 0f);
                                                            let _e6142 = select(_e6098, _e6094, _e6141);
                                                            let _e6143 = select(_e6096, _e6098, _e6141);
                                                            let _e6145 = ((_e6142 - _e6143) > _e6071);
                                                            if _e6145 {
                                                                let _e6146 = (1f - _e6098);
                                                                let _e6158 = (-(_e6140) / (_e6069 * (((((_e6077 - (3f * _e6074)) * _e6146) + (_e6086 * _e6098)) * _e6146) + (((_e6086 * _e6146) + (((3f * _e6083) - _e6080) * _e6098)) * _e6098))));
                                                                let _e6165 = ((_e6098 + _e6158) + select(-((0.5f * _e6071)), (0.5f * _e6071), (_e6140 > 0f)));
                                                                if (_e6165 > _e6143) {
                                                                    phi_9993_ = select(true, select(true, false, (select(_e6158, -(_e6158), (_e6158 < 0f)) < (0.5f * (_e6142 - _e6143)))), (_e6165 < _e6142));
                                                                } else {
                                                                    phi_9993_ = true;
                                                                }
                                                                let _e6177 = phi_9993_;
                                                                phi_10000_ = select(_e6165, (0.5f * (_e6143 + _e6142)), _e6177);
                                                                phi_10001_ = false;
                                                            } else {
                                                                phi_10000_ = f32();
                                                                phi_10001_ = true;
                                                            }
                                                            let _e6182 = phi_10000_;
                                                            let _e6184 = phi_10001_;
                                                            phi_9880_ = _e6142;
                                                            phi_9882_ = _e6143;
                                                            phi_9884_ = _e6182;
                                                            phi_10002_ = _e6143;
                                                            phi_10003_ = _e6145;
                                                            phi_10004_ = _e6184;
                                                        } else {
                                                            phi_9880_ = f32();
                                                            phi_9882_ = f32();
                                                            phi_9884_ = f32();
                                                            phi_10002_ = f32();
                                                            phi_10003_ = false;
                                                            phi_10004_ = false;
                                                        }
                                                        let _e6186 = phi_9880_;
                                                        let _e6188 = phi_9882_;
                                                        let _e6190 = phi_9884_;
                                                        let _e6192 = phi_10002_;
                                                        let _e6194 = phi_10003_;
                                                        let _e6196 = phi_10004_;
                                                        local_75 = _e6196;
                                                        local_76 = _e6192;
                                                        continue;
                                                        continuing {
                                                            phi_9876_ = type_9(select(_e6092.member, (_e6092.member + 1u), _e6101), select(_e6092.member_1, _e6092.member_1, _e6101));
                                                            phi_9879_ = _e6186;
                                                            phi_9881_ = _e6188;
                                                            phi_9883_ = _e6190;
                                                            break if !(_e6194);
                                                        }
                                                    }
                                                    let _e6199 = local_75;
                                                    let _e6201 = local_76;
                                                    let _e6203 = local_77;
                                                    phi_10009_ = select(_e6203, _e6201, _e6199);
                                                } else {
                                                    phi_10009_ = _e5978;
                                                }
                                                let _e6206 = phi_10009_;
                                                if _e6044 {
                                                    let _e6210 = local_5.member_3;
                                                    let _e6212 = local_5.member_3;
                                                    phi_10025_ = type_9(0u, 64u);
                                                    phi_10028_ = (_e6210 + _e6212);
                                                    loop {
                                                        let _e6215 = phi_10025_;
                                                        let _e6217 = phi_10028_;
                                                        let _e6220 = (_e6215.member < _e6215.member_1);
                                                        if (bitcast<i32>(select(0u, 1u, _e6220)) != 0i) {
                                                            let _e6232 = (_e6206 + _e6217);
                                                            if (_e6232 < _e5982) {
                                                                let _e6234 = (1f - _e6232);
                                                                let _e6237 = local_5.member[0u];
                                                                let _e6240 = local_5.member[1u];
                                                                let _e6243 = local_5.member[2u];
                                                                let _e6246 = local_5.member[3u];
                                                                let _e6260 = local_5.member_1;
                                                                let _e6261 = ((select(1f, -1f, (_e6032 < 0f)) * ((((_e6237 * _e6234) + (_e6240 * _e6232)) * (_e6234 * _e6234)) + (((_e6243 * _e6234) + (_e6246 * _e6232)) * (_e6232 * _e6232)))) > _e6260);
                                                                phi_10093_ = select((_e6217 + _e6217), f32(), _e6261);
                                                                phi_10094_ = select(true, false, _e6261);
                                                                phi_10095_ = _e6261;
                                                                phi_10096_ = false;
                                                            } else {
                                                                phi_10093_ = f32();
                                                                phi_10094_ = false;
                                                                phi_10095_ = false;
                                                                phi_10096_ = true;
                                                            }
                                                            let _e6266 = phi_10093_;
                                                            let _e6268 = phi_10094_;
                                                            let _e6270 = phi_10095_;
                                                            let _e6272 = phi_10096_;
                                                            phi_10097_ = _e6232;
                                                            phi_10029_ = _e6266;
                                                            phi_10098_ = _e6268;
                                                            phi_10099_ = _e6270;
                                                            phi_10100_ = _e6272;
                                                            phi_10101_ = false;
                                                        } else {
                                                            phi_10097_ = f32();
                                                            phi_10029_ = f32();
                                                            phi_10098_ = false;
                                                            phi_10099_ = false;
                                                            phi_10100_ = false;
                                                            phi_10101_ = true;
                                                        }
                                                        let _e6274 = phi_10097_;
                                                        let _e6276 = phi_10029_;
                                                        let _e6278 = phi_10098_;
                                                        let _e6280 = phi_10099_;
                                                        let _e6282 = phi_10100_;
                                                        let _e6284 = phi_10101_;
                                                        local_78 = _e6280;
                                                        local_79 = _e6282;
                                                        local_80 = _e6280;
                                                        local_81 = _e6284;
                                                        local_82 = _e6274;
                                                        continue;
                                                        continuing {
                                                            phi_10025_ = type_9(select(_e6215.member, (_e6215.member + 1u), _e6220), select(_e6215.member_1, _e6215.member_1, _e6220));
                                                            phi_10028_ = _e6276;
                                                            break if !(_e6278);
                                                        }
                                                    }
                                                    let _e6287 = local_78;
                                                    let _e6289 = local_79;
                                                    let _e6292 = local_80;
                                                    let _e6294 = local_81;
                                                    let _e6298 = local_82;
                                                    phi_10115_ = select(_e6298, _e5982, select(select(_e6294, false, _e6292), true, select(_e6289, false, _e6287)));
                                                } else {
                                                    phi_10115_ = _e5982;
                                                }
                                                let _e6301 = phi_10115_;
                                                phi_10117_ = type_44(_e6206, _e6301, _e6052);
                                            } else {
                                                phi_10117_ = _e6065;
                                            }
                                            let _e6304 = phi_10117_;
                                            if (_e6304.member > _e6304.member_1) {
                                                phi_11084_ = bool();
                                                phi_11085_ = true;
                                                phi_11086_ = false;
                                                phi_11087_ = false;
                                                phi_11088_ = false;
                                            } else {
                                                let _e6309 = (_e6304.member > _e5094);
                                                if _e6309 {
                                                    phi_11080_ = bool();
                                                    phi_11081_ = false;
                                                    phi_11082_ = false;
                                                    phi_11083_ = false;
                                                } else {
                                                    let _e6313 = ((_e6304.member_1 - _e6304.member) * 0.5f);
                                                    let _e6314 = (_e6304.member + _e6313);
                                                    let _e6316 = (_e6313 + (0.000000059604645f * 4f));
                                                    let _e6318 = local_7.member_3;
                                                    let _e6321 = local_7.member[0u];
                                                    let _e6327 = select(_e6321[0], -(_e6321[0]), (_e6321[0] < 0f));
                                                    let _e6330 = select(_e6321[1], -(_e6321[1]), (_e6321[1] < 0f));
                                                    let _e6332 = select(_e6330, _e6327, (_e6327 > _e6330));
                                                    let _e6335 = select(_e6321[2], -(_e6321[2]), (_e6321[2] < 0f));
                                                    let _e6337 = select(_e6335, _e6332, (_e6332 > _e6335));
                                                    let _e6339 = local_7.member[1u];
                                                    let _e6345 = select(_e6339[0], -(_e6339[0]), (_e6339[0] < 0f));
                                                    let _e6348 = select(_e6339[1], -(_e6339[1]), (_e6339[1] < 0f));
                                                    let _e6350 = select(_e6348, _e6345, (_e6345 > _e6348));
                                                    let _e6353 = select(_e6339[2], -(_e6339[2]), (_e6339[2] < 0f));
                                                    let _e6355 = select(_e6353, _e6350, (_e6350 > _e6353));
                                                    let _e6360 = local_7.member[0u];
                                                    let _e6365 = local_7.member[1u];
                                                    let _e6375 = (_e6360[0] + ((_e6365[0] - _e6360[0]) * _e6314));
                                                    let _e6376 = (_e6360[1] + ((_e6365[1] - _e6360[1]) * _e6314));
                                                    let _e6377 = (_e6360[2] + ((_e6365[2] - _e6360[2]) * _e6314));
                                                    let _e6379 = local_7.member[1u];
                                                    let _e6384 = local_7.member[0u];
                                                    let _e6388 = (_e6379[0] - _e6384[0]);
                                                    let _e6389 = (_e6379[1] - _e6384[1]);
                                                    let _e6390 = (_e6379[2] - _e6384[2]);
                                                    let _e6393 = select(_e6388, -(_e6388), (_e6388 < 0f));
                                                    let _e6396 = select(_e6389, -(_e6389), (_e6389 < 0f));
                                                    let _e6398 = select(_e6396, _e6393, (_e6393 > _e6396));
                                                    let _e6401 = select(_e6390, -(_e6390), (_e6390 < 0f));
                                                    let _e6409 = ((((_e6316 * select(_e6401, _e6398, (_e6398 > _e6401))) * 1.01f) + ((select(_e6355, _e6337, (_e6337 > _e6355)) + _e6318) * (0.000000059604645f * 8f))) + _e6318);
                                                    let _e6412 = select(_e6375, -(_e6375), (_e6375 < 0f));
                                                    let _e6415 = select(_e6376, -(_e6376), (_e6376 < 0f));
                                                    let _e6417 = select(_e6415, _e6412, (_e6412 > _e6415));
                                                    let _e6420 = select(_e6377, -(_e6377), (_e6377 < 0f));
                                                    let _e6423 = (select(_e6420, _e6417, (_e6417 > _e6420)) + _e6409);
                                                    let _e6426 = local_7.member_3;
                                                    let _e6428 = local_7.member_1[0u];
                                                    let _e6434 = select(_e6428[0], -(_e6428[0]), (_e6428[0] < 0f));
                                                    let _e6437 = select(_e6428[1], -(_e6428[1]), (_e6428[1] < 0f));
                                                    let _e6439 = select(_e6437, _e6434, (_e6434 > _e6437));
                                                    let _e6442 = select(_e6428[2], -(_e6428[2]), (_e6428[2] < 0f));
                                                    let _e6444 = select(_e6442, _e6439, (_e6439 > _e6442));
                                                    let _e6446 = local_7.member_1[1u];
                                                    let _e6452 = select(_e6446[0], -(_e6446[0]), (_e6446[0] < 0f));
                                                    let _e6455 = select(_e6446[1], -(_e6446[1]), (_e6446[1] < 0f));
                                                    let _e6457 = select(_e6455, _e6452, (_e6452 > _e6455));
                                                    let _e6460 = select(_e6446[2], -(_e6446[2]), (_e6446[2] < 0f));
                                                    let _e6462 = select(_e6460, _e6457, (_e6457 > _e6460));
                                                    let _e6467 = local_7.member_1[0u];
                                                    let _e6472 = local_7.member_1[1u];
                                                    let _e6482 = (_e6467[0] + ((_e6472[0] - _e6467[0]) * _e6314));
                                                    let _e6483 = (_e6467[1] + ((_e6472[1] - _e6467[1]) * _e6314));
                                                    let _e6484 = (_e6467[2] + ((_e6472[2] - _e6467[2]) * _e6314));
                                                    let _e6486 = local_7.member_1[1u];
                                                    let _e6491 = local_7.member_1[0u];
                                                    let _e6495 = (_e6486[0] - _e6491[0]);
                                                    let _e6496 = (_e6486[1] - _e6491[1]);
                                                    let _e6497 = (_e6486[2] - _e6491[2]);
                                                    let _e6500 = select(_e6495, -(_e6495), (_e6495 < 0f));
                                                    let _e6503 = select(_e6496, -(_e6496), (_e6496 < 0f));
                                                    let _e6505 = select(_e6503, _e6500, (_e6500 > _e6503));
                                                    let _e6508 = select(_e6497, -(_e6497), (_e6497 < 0f));
                                                    let _e6516 = ((((_e6316 * select(_e6508, _e6505, (_e6505 > _e6508))) * 1.01f) + ((select(_e6462, _e6444, (_e6444 > _e6462)) + _e6426) * (0.000000059604645f * 8f))) + _e6426);
                                                    let _e6519 = select(_e6482, -(_e6482), (_e6482 < 0f));
                                                    let _e6522 = select(_e6483, -(_e6483), (_e6483 < 0f));
                                                    let _e6524 = select(_e6522, _e6519, (_e6519 > _e6522));
                                                    let _e6527 = select(_e6484, -(_e6484), (_e6484 < 0f));
                                                    let _e6530 = (select(_e6527, _e6524, (_e6524 > _e6527)) + _e6516);
                                                    let _e6533 = local_7.member_3;
                                                    let _e6535 = local_7.member_2[0u];
                                                    let _e6541 = select(_e6535[0], -(_e6535[0]), (_e6535[0] < 0f));
                                                    let _e6544 = select(_e6535[1], -(_e6535[1]), (_e6535[1] < 0f));
                                                    let _e6546 = select(_e6544, _e6541, (_e6541 > _e6544));
                                                    let _e6549 = select(_e6535[2], -(_e6535[2]), (_e6535[2] < 0f));
                                                    let _e6551 = select(_e6549, _e6546, (_e6546 > _e6549));
                                                    let _e6553 = local_7.member_2[1u];
                                                    let _e6559 = select(_e6553[0], -(_e6553[0]), (_e6553[0] < 0f));
                                                    let _e6562 = select(_e6553[1], -(_e6553[1]), (_e6553[1] < 0f));
                                                    let _e6564 = select(_e6562, _e6559, (_e6559 > _e6562));
                                                    let _e6567 = select(_e6553[2], -(_e6553[2]), (_e6553[2] < 0f));
                                                    let _e6569 = select(_e6567, _e6564, (_e6564 > _e6567));
                                                    let _e6574 = local_7.member_2[0u];
                                                    let _e6579 = local_7.member_2[1u];
                                                    let _e6589 = (_e6574[0] + ((_e6579[0] - _e6574[0]) * _e6314));
                                                    let _e6590 = (_e6574[1] + ((_e6579[1] - _e6574[1]) * _e6314));
                                                    let _e6591 = (_e6574[2] + ((_e6579[2] - _e6574[2]) * _e6314));
                                                    let _e6593 = local_7.member_2[1u];
                                                    let _e6598 = local_7.member_2[0u];
                                                    let _e6602 = (_e6593[0] - _e6598[0]);
                                                    let _e6603 = (_e6593[1] - _e6598[1]);
                                                    let _e6604 = (_e6593[2] - _e6598[2]);
                                                    let _e6607 = select(_e6602, -(_e6602), (_e6602 < 0f));
                                                    let _e6610 = select(_e6603, -(_e6603), (_e6603 < 0f));
                                                    let _e6612 = select(_e6610, _e6607, (_e6607 > _e6610));
                                                    let _e6615 = select(_e6604, -(_e6604), (_e6604 < 0f));
                                                    let _e6623 = ((((_e6316 * select(_e6615, _e6612, (_e6612 > _e6615))) * 1.01f) + ((select(_e6569, _e6551, (_e6551 > _e6569)) + _e6533) * (0.000000059604645f * 8f))) + _e6533);
                                                    let _e6626 = select(_e6589, -(_e6589), (_e6589 < 0f));
                                                    let _e6629 = select(_e6590, -(_e6590), (_e6590 < 0f));
                                                    let _e6631 = select(_e6629, _e6626, (_e6626 > _e6629));
                                                    let _e6634 = select(_e6591, -(_e6591), (_e6591 < 0f));
                                                    let _e6637 = (select(_e6634, _e6631, (_e6631 > _e6634)) + _e6623);
                                                    let _e6640 = ((_e6483 * _e6591) - (_e6484 * _e6590));
                                                    let _e6643 = ((_e6484 * _e6589) - (_e6482 * _e6591));
                                                    let _e6646 = ((_e6482 * _e6590) - (_e6483 * _e6589));
                                                    let _e6661 = select(false, (select(_e6640, -(_e6640), (_e6640 < 0f)) > select(_e6646, -(_e6646), (_e6646 < 0f))), (select(_e6640, -(_e6640), (_e6640 < 0f)) > select(_e6643, -(_e6643), (_e6643 < 0f))));
                                                    let _e6676 = select((select(_e6643, -(_e6643), (_e6643 < 0f)) > select(_e6646, -(_e6646), (_e6646 < 0f))), false, (select(_e6640, -(_e6640), (_e6640 < 0f)) > select(_e6643, -(_e6643), (_e6643 < 0f))));
                                                    let _e6679 = select(select(_e6375, _e6376, _e6661), _e6377, _e6676);
                                                    let _e6680 = select(select(_e6376, _e6377, _e6661), _e6375, _e6676);
                                                    let _e6683 = select(select(_e6482, _e6483, _e6661), _e6484, _e6676);
                                                    let _e6684 = select(select(_e6483, _e6484, _e6661), _e6482, _e6676);
                                                    let _e6687 = select(select(_e6589, _e6590, _e6661), _e6591, _e6676);
                                                    let _e6688 = select(select(_e6590, _e6591, _e6661), _e6589, _e6676);
                                                    let _e6691 = ((_e6683 * _e6688) - (_e6684 * _e6687));
                                                    let _e6707 = (((((_e6516 * _e6637) + (_e6530 * _e6623)) * 2.01f) + (((_e6530 * 2f) * (_e6637 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6530) * (1f + _e6637))));
                                                    if (select(_e6691, -(_e6691), (_e6691 < 0f)) > _e6707) {
                                                        let _e6713 = select(1f, -1f, (_e6691 < 0f));
                                                        let _e6732 = (((((_e6409 * _e6637) + (_e6423 * _e6623)) * 2.01f) + (((_e6423 * 2f) * (_e6637 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6423) * (1f + _e6637))));
                                                        let _e6751 = (((((_e6516 * _e6423) + (_e6530 * _e6409)) * 2.01f) + (((_e6530 * 2f) * (_e6423 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e6530) * (1f + _e6423))));
                                                        let _e6752 = (_e6691 * _e6713);
                                                        let _e6753 = (((_e6679 * _e6688) - (_e6680 * _e6687)) * _e6713);
                                                        let _e6754 = (((_e6683 * _e6680) - (_e6684 * _e6679)) * _e6713);
                                                        let _e6767 = (((select(_e6752, -(_e6752), (_e6752 < 0f)) + select(_e6753, -(_e6753), (_e6753 < 0f))) + select(_e6754, -(_e6754), (_e6754 < 0f))) * (0.000000059604645f * 4f));
                                                        if (_e278.member != 0u) {
                                                            phi_10954_ = array<type_16, 4>(type_16(_e6753, _e6732), type_16(_e6754, _e6751), type_16((_e6752 - _e6753), ((_e6707 + _e6732) + _e6767)), type_16((_e6752 - _e6754), ((_e6707 + _e6751) + _e6767)));
                                                        } else {
                                                            let _e6770 = ((_e6752 - _e6753) - _e6754);
                                                            let _e6773 = (((_e6707 + _e6732) + _e6751) + _e6767);
                                                            phi_10954_ = array<type_16, 4>(type_16(_e6753, _e6732), type_16(_e6754, _e6751), type_16(_e6770, _e6773), type_16(_e6770, _e6773));
                                                        }
                                                        let _e6791 = phi_10954_;
                                                        local_2 = array<type_16, 4>(type_16(_e6791[0].member, _e6791[0].member_1), type_16(_e6791[1].member, _e6791[1].member_1), type_16(_e6791[2].member, _e6791[2].member_1), type_16(_e6791[3].member, _e6791[3].member_1));
                                                        phi_10974_ = type_9(0u, 4u);
                                                        phi_10977_ = true;
                                                        loop {
                                                            let _e6810 = phi_10974_;
                                                            let _e6812 = phi_10977_;
                                                            local_84 = _e6812;
                                                            let _e6815 = (_e6810.member < _e6810.member_1);
                                                            let _e6826 = select(type_9().member_1, _e6810.member, _e6815);
                                                            if (bitcast<i32>(select(0u, 1u, _e6815)) != 0i) {
                                                                let _e6831 = local_2[_e6826].member;
                                                                let _e6834 = local_2[_e6826].member_1;
                                                                let _e6836 = (_e6831 < -(_e6834));
                                                                phi_10978_ = select((_e6812 && (_e6831 > _e6834)), bool(), _e6836);
                                                                phi_11029_ = select(true, false, _e6836);
                                                                phi_11030_ = _e6836;
                                                            } else {
                                                                phi_10978_ = bool();
                                                                phi_11029_ = false;
                                                                phi_11030_ = false;
                                                            }
                                                            let _e6842 = phi_10978_;
                                                            let _e6844 = phi_11029_;
                                                            let _e6846 = phi_11030_;
                                                            local_83 = _e6846;
                                                            continue;
                                                            continuing {
                                                                phi_10974_ = type_9(select(_e6810.member, (_e6810.member + 1u), _e6815), select(_e6810.member_1, _e6810.member_1, _e6815));
                                                                phi_10977_ = _e6842;
                                                                break if !(_e6844);
                                                            }
                                                        }
                                                        let _e6849 = local_83;
                                                        let _e6850 = select(true, false, _e6849);
                                                        let _e6852 = local_84;
                                                        phi_11044_ = select(u32(), select(2u, 1u, _e6852), _e6850);
                                                        phi_11045_ = 0u;
                                                        phi_11046_ = select(true, false, _e6850);
                                                    } else {
                                                        phi_11044_ = u32();
                                                        phi_11045_ = 2u;
                                                        phi_11046_ = true;
                                                    }
                                                    let _e6857 = phi_11044_;
                                                    let _e6859 = phi_11045_;
                                                    let _e6861 = phi_11046_;
                                                    let _e6862 = select(_e6857, _e6859, _e6861);
                                                    let _e6863 = (_e6862 == 0u);
                                                    if _e6863 {
                                                        phi_11077_ = bool();
                                                        phi_11078_ = false;
                                                        phi_11079_ = false;
                                                    } else {
                                                        let _e6866 = select(false, _e6304.member_2, (_e6862 == 1u));
                                                        let _e6872 = select(true, select(true, false, ((_e6304.member_1 - _e6304.member) <= _e5919)), _e6866);
                                                        phi_11077_ = _e6866;
                                                        phi_11078_ = _e6872;
                                                        phi_11079_ = select(true, false, _e6872);
                                                    }
                                                    let _e6875 = phi_11077_;
                                                    let _e6877 = phi_11078_;
                                                    let _e6879 = phi_11079_;
                                                    phi_11080_ = _e6875;
                                                    phi_11081_ = _e6863;
                                                    phi_11082_ = _e6877;
                                                    phi_11083_ = _e6879;
                                                }
                                                let _e6881 = phi_11080_;
                                                let _e6883 = phi_11081_;
                                                let _e6885 = phi_11082_;
                                                let _e6887 = phi_11083_;
                                                phi_11084_ = _e6881;
                                                phi_11085_ = _e6883;
                                                phi_11086_ = _e6885;
                                                phi_11087_ = _e6309;
                                                phi_11088_ = _e6887;
                                            }
                                            let _e6889 = phi_11084_;
                                            let _e6891 = phi_11085_;
                                            let _e6893 = phi_11086_;
                                            let _e6895 = phi_11087_;
                                            let _e6897 = phi_11088_;
                                            phi_11089_ = _e6304;
                                            phi_11090_ = _e6889;
                                            phi_11091_ = _e6304;
                                            phi_11092_ = _e6891;
                                            phi_11093_ = _e6893;
                                            phi_11094_ = _e6895;
                                            phi_11095_ = _e6897;
                                        }
                                        let _e6899 = phi_11089_;
                                        let _e6901 = phi_11090_;
                                        let _e6903 = phi_11091_;
                                        let _e6905 = phi_11092_;
                                        let _e6907 = phi_11093_;
                                        let _e6909 = phi_11094_;
                                        let _e6911 = phi_11095_;
                                        phi_11096_ = _e6899;
                                        phi_11097_ = _e6901;
                                        phi_11098_ = _e6903;
                                        phi_11099_ = _e6905;
                                        phi_11100_ = _e6907;
                                        phi_11101_ = _e5984;
                                        phi_11102_ = _e6909;
                                        phi_11103_ = _e6911;
                                    } else {
                                        phi_11096_ = type_44();
                                        phi_11097_ = bool();
                                        phi_11098_ = type_44();
                                        phi_11099_ = true;
                                        phi_11100_ = false;
                                        phi_11101_ = false;
                                        phi_11102_ = false;
                                        phi_11103_ = false;
                                    }
                                    let _e6913 = phi_11096_;
                                    let _e6915 = phi_11097_;
                                    let _e6917 = phi_11098_;
                                    let _e6919 = phi_11099_;
                                    let _e6921 = phi_11100_;
                                    let _e6923 = phi_11101_;
                                    let _e6925 = phi_11102_;
                                    let _e6927 = phi_11103_;
                                    phi_11111_ = _e6913;
                                    phi_11112_ = _e6915;
                                    phi_11113_ = _e6917;
                                    phi_11114_ = select(_e6921, false, _e6919);
                                    phi_11115_ = _e6919;
                                    phi_11116_ = select(_e6923, false, _e6919);
                                    phi_11117_ = select(_e6925, false, _e6919);
                                    phi_11118_ = select(_e6927, false, _e6919);
                                } else {
                                    phi_11111_ = type_44(_e5090, _e5090, false);
                                    phi_11112_ = false;
                                    phi_11113_ = type_44();
                                    phi_11114_ = true;
                                    phi_11115_ = false;
                                    phi_11116_ = false;
                                    phi_11117_ = false;
                                    phi_11118_ = false;
                                }
                                let _e6933 = phi_11111_;
                                let _e6935 = phi_11112_;
                                let _e6937 = phi_11113_;
                                let _e6939 = phi_11114_;
                                let _e6941 = phi_11115_;
                                let _e6943 = phi_11116_;
                                let _e6945 = phi_11117_;
                                let _e6947 = phi_11118_;
                                if _e6939 {
                                    let _e6952 = local_7.member[0u];
                                    let _e6958 = local_7.member_1[0u];
                                    let _e6964 = local_7.member_2[0u];
                                    let _e6968 = (_e6952[0] - _e6958[0]);
                                    let _e6969 = (_e6952[1] - _e6958[1]);
                                    let _e6970 = (_e6952[2] - _e6958[2]);
                                    let _e6971 = (_e278.member == 0u);
                                    let _e6983 = local_7.member[1u];
                                    let _e6989 = local_7.member_1[1u];
                                    let _e6995 = local_7.member_2[1u];
                                    let _e6999 = (_e6983[0] - _e6989[0]);
                                    let _e7000 = (_e6983[1] - _e6989[1]);
                                    let _e7001 = (_e6983[2] - _e6989[2]);
                                    let _e7002 = (_e278.member == 0u);
                                    let _e7014 = local_7.member[0u];
                                    let _e7020 = select(_e7014[0], -(_e7014[0]), (_e7014[0] < 0f));
                                    let _e7023 = select(_e7014[1], -(_e7014[1]), (_e7014[1] < 0f));
                                    let _e7025 = select(_e7023, _e7020, (_e7020 > _e7023));
                                    let _e7028 = select(_e7014[2], -(_e7014[2]), (_e7014[2] < 0f));
                                    let _e7030 = select(_e7028, _e7025, (_e7025 > _e7028));
                                    let _e7033 = local_7.member[1u];
                                    let _e7039 = select(_e7033[0], -(_e7033[0]), (_e7033[0] < 0f));
                                    let _e7042 = select(_e7033[1], -(_e7033[1]), (_e7033[1] < 0f));
                                    let _e7044 = select(_e7042, _e7039, (_e7039 > _e7042));
                                    let _e7047 = select(_e7033[2], -(_e7033[2]), (_e7033[2] < 0f));
                                    let _e7049 = select(_e7047, _e7044, (_e7044 > _e7047));
                                    let _e7053 = local_7.member_3;
                                    let _e7057 = local_7.member_1[0u];
                                    let _e7063 = select(_e7057[0], -(_e7057[0]), (_e7057[0] < 0f));
                                    let _e7066 = select(_e7057[1], -(_e7057[1]), (_e7057[1] < 0f));
                                    let _e7068 = select(_e7066, _e7063, (_e7063 > _e7066));
                                    let _e7071 = select(_e7057[2], -(_e7057[2]), (_e7057[2] < 0f));
                                    let _e7073 = select(_e7071, _e7068, (_e7068 > _e7071));
                                    let _e7076 = local_7.member_1[1u];
                                    let _e7082 = select(_e7076[0], -(_e7076[0]), (_e7076[0] < 0f));
                                    let _e7085 = select(_e7076[1], -(_e7076[1]), (_e7076[1] < 0f));
                                    let _e7087 = select(_e7085, _e7082, (_e7082 > _e7085));
                                    let _e7090 = select(_e7076[2], -(_e7076[2]), (_e7076[2] < 0f));
                                    let _e7092 = select(_e7090, _e7087, (_e7087 > _e7090));
                                    let _e7096 = local_7.member_3;
                                    let _e7100 = local_7.member_2[0u];
                                    let _e7106 = select(_e7100[0], -(_e7100[0]), (_e7100[0] < 0f));
                                    let _e7109 = select(_e7100[1], -(_e7100[1]), (_e7100[1] < 0f));
                                    let _e7111 = select(_e7109, _e7106, (_e7106 > _e7109));
                                    let _e7114 = select(_e7100[2], -(_e7100[2]), (_e7100[2] < 0f));
                                    let _e7116 = select(_e7114, _e7111, (_e7111 > _e7114));
                                    let _e7119 = local_7.member_2[1u];
                                    let _e7125 = select(_e7119[0], -(_e7119[0]), (_e7119[0] < 0f));
                                    let _e7128 = select(_e7119[1], -(_e7119[1]), (_e7119[1] < 0f));
                                    let _e7130 = select(_e7128, _e7125, (_e7125 > _e7128));
                                    let _e7133 = select(_e7119[2], -(_e7119[2]), (_e7119[2] < 0f));
                                    let _e7135 = select(_e7133, _e7130, (_e7130 > _e7133));
                                    let _e7139 = local_7.member_3;
                                    let _e7146 = local_7.member_3;
                                    let _e7151 = (_e5088 * 0.00390625f);
                                    local = type_27(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    phi_11541_ = type_9(0u, 96u);
                                    phi_11544_ = _e6933.member;
                                    phi_11546_ = _e6933.member;
                                    phi_11548_ = (_e6933.member_1 - _e6933.member);
                                    phi_11550_ = _e6933.member;
                                    phi_11552_ = false;
                                    phi_11554_ = 0u;
                                    loop {
                                        let _e7154 = phi_11541_;
                                        let _e7156 = phi_11544_;
                                        let _e7158 = phi_11546_;
                                        let _e7160 = phi_11548_;
                                        let _e7162 = phi_11550_;
                                        let _e7164 = phi_11552_;
                                        let _e7166 = phi_11554_;
                                        local_94 = _e7156;
                                        local_97 = _e7158;
                                        let _e7169 = (_e7154.member < _e7154.member_1);
                                        if (bitcast<i32>(select(0u, 1u, _e7169)) != 0i) {
                                            let _e7183 = local_7.member[0u];
                                            let _e7189 = local_7.member[1u];
                                            let _e7205 = local_7.member_1[0u];
                                            let _e7211 = local_7.member_1[1u];
                                            let _e7227 = local_7.member_2[0u];
                                            let _e7233 = local_7.member_2[1u];
                                            let _e7247 = function_3(array<f32, 3>((_e7183[0] + ((_e7189[0] - _e7183[0]) * _e7156)), (_e7183[1] + ((_e7189[1] - _e7183[1]) * _e7156)), (_e7183[2] + ((_e7189[2] - _e7183[2]) * _e7156))), array<f32, 3>((_e7205[0] + ((_e7211[0] - _e7205[0]) * _e7156)), (_e7205[1] + ((_e7211[1] - _e7205[1]) * _e7156)), (_e7205[2] + ((_e7211[2] - _e7205[2]) * _e7156))), array<f32, 3>((_e7227[0] + ((_e7233[0] - _e7227[0]) * _e7156)), (_e7227[1] + ((_e7233[1] - _e7227[1]) * _e7156)), (_e7227[2] + ((_e7233[2] - _e7227[2]) * _e7156))), _e278.member);
                                            if (_e7166 == 0u) {
                                                phi_11705_ = _e7247;
                                            } else {
                                                phi_11705_ = array<f32, 3>(select(0f, _e7247[0], (_e7166 == 1u)), select(0f, _e7247[1], (_e7166 == 2u)), select(0f, _e7247[2], (_e7166 == 3u)));
                                            }
                                            let _e7260 = phi_11705_;
                                            let _e7274 = ((select(_e7260[0], -(_e7260[0]), (_e7260[0] < 0f)) + select(_e7260[1], -(_e7260[1]), (_e7260[1] < 0f))) + select(_e7260[2], -(_e7260[2]), (_e7260[2] < 0f)));
                                            if (_e7274 > 0f) {
                                                if ((bitcast<u32>(_e7274) & 2139095040u) != 2139095040u) {
                                                    let _e7279 = (1f / _e7274);
                                                    let _e7281 = (_e7260[0] * _e7279);
                                                    let _e7283 = (_e7260[1] * _e7279);
                                                    let _e7285 = (_e7260[2] * _e7279);
                                                    let _e7290 = (((_e7281 * _e7281) + (_e7283 * _e7283)) + (_e7285 * _e7285));
                                                    if (_e7290 <= 0.000000000000000000000000000000000000011754944f) {
                                                        phi_11828_ = select(0f, (0.000000000000000000106433627f * 2f), (_e7290 > 0f));
                                                    } else {
                                                        phi_11771_ = type_14(0i, 5i);
                                                        phi_11774_ = bitcast<f32>(((bitcast<u32>(_e7290) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e7298 = phi_11771_;
                                                            let _e7300 = phi_11774_;
                                                            local_85 = _e7300;
                                                            if (_e7298.member < _e7298.member_1) {
                                                                let _e7307 = (_e7298.member + 1i);
                                                                phi_11772_ = type_14(select(_e7307, type_15().member_1, select(false, true, ((false == (_e7307 > _e7298.member)) != false))), _e7298.member_1);
                                                                phi_11815_ = type_15(1u, _e7298.member);
                                                            } else {
                                                                phi_11772_ = _e7298;
                                                                phi_11815_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e7318 = phi_11772_;
                                                            let _e7320 = phi_11815_;
                                                            let _e7323 = (bitcast<i32>(_e7320.member) != 0i);
                                                            if _e7323 {
                                                                phi_11775_ = (0.5f * (_e7300 + (_e7290 / _e7300)));
                                                            } else {
                                                                phi_11775_ = f32();
                                                            }
                                                            let _e7328 = phi_11775_;
                                                            continue;
                                                            continuing {
                                                                phi_11771_ = _e7318;
                                                                phi_11774_ = _e7328;
                                                                break if !(_e7323);
                                                            }
                                                        }
                                                        let _e7333 = local_85;
                                                        phi_11828_ = (_e7333 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e7339 = phi_11828_;
                                                    let _e7340 = (0.000000059604645f * 12f);
                                                    let _e7345 = ((((((((select(_e7049, _e7030, (_e7030 > _e7049)) + _e7053) + (select(_e7092, _e7073, (_e7073 > _e7092)) + _e7096)) + (select(_e7135, _e7116, (_e7116 > _e7135)) + _e7139)) * (0.000000059604645f * 16f)) + (_e7146 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e7339) * (1f + _e7340)));
                                                    let _e7350 = (((_e7281 * _e6952[0]) + (_e7283 * _e6952[1])) + (_e7285 * _e6952[2]));
                                                    let _e7355 = (((_e7281 * _e6968) + (_e7283 * _e6969)) + (_e7285 * _e6970));
                                                    let _e7360 = (((_e7281 * (_e6952[0] - _e6964[0])) + (_e7283 * (_e6952[1] - _e6964[1]))) + (_e7285 * (_e6952[2] - _e6964[2])));
                                                    let _e7365 = (((_e7281 * select((_e6968 - _e6964[0]), _e6952[0], _e6971)) + (_e7283 * select((_e6969 - _e6964[1]), _e6952[1], _e6971))) + (_e7285 * select((_e6970 - _e6964[2]), _e6952[2], _e6971)));
                                                    let _e7371 = (((_e7281 * _e6983[0]) + (_e7283 * _e6983[1])) + (_e7285 * _e6983[2]));
                                                    let _e7376 = (((_e7281 * _e6999) + (_e7283 * _e7000)) + (_e7285 * _e7001));
                                                    let _e7381 = (((_e7281 * (_e6983[0] - _e6995[0])) + (_e7283 * (_e6983[1] - _e6995[1]))) + (_e7285 * (_e6983[2] - _e6995[2])));
                                                    let _e7386 = (((_e7281 * select((_e6999 - _e6995[0]), _e6983[0], _e7002)) + (_e7283 * select((_e7000 - _e6995[1]), _e6983[1], _e7002))) + (_e7285 * select((_e7001 - _e6995[2]), _e6983[2], _e7002)));
                                                    phi_11951_ = type_27(array<f32, 4>(_e7350, _e7355, _e7360, _e7365), array<f32, 4>(_e7371, _e7376, _e7381, _e7386), array<f32, 4>((_e7345 + ((select(_e7350, -(_e7350), (_e7350 < 0f)) + select(_e7371, -(_e7371), (_e7371 < 0f))) * _e7340)), (_e7345 + ((select(_e7355, -(_e7355), (_e7355 < 0f)) + select(_e7376, -(_e7376), (_e7376 < 0f))) * _e7340)), (_e7345 + ((select(_e7360, -(_e7360), (_e7360 < 0f)) + select(_e7381, -(_e7381), (_e7381 < 0f))) * _e7340)), (_e7345 + ((select(_e7365, -(_e7365), (_e7365 < 0f)) + select(_e7386, -(_e7386), (_e7386 < 0f))) * _e7340))));
                                                    phi_11952_ = false;
                                                } else {
                                                    phi_11951_ = type_27();
                                                    phi_11952_ = true;
                                                }
                                                let _e7427 = phi_11951_;
                                                let _e7429 = phi_11952_;
                                                phi_11953_ = _e7427;
                                                phi_11954_ = _e7429;
                                            } else {
                                                phi_11953_ = type_27();
                                                phi_11954_ = true;
                                            }
                                            let _e7431 = phi_11953_;
                                            let _e7433 = phi_11954_;
                                            if _e7433 {
                                                phi_11962_ = type_27(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            } else {
                                                phi_11962_ = _e7431;
                                            }
                                            let _e7435 = phi_11962_;
                                            local_1 = type_27(array<f32, 4>(_e7435.member[0], _e7435.member[1], _e7435.member[2], _e7435.member[3]), array<f32, 4>(_e7435.member_1[0], _e7435.member_1[1], _e7435.member_1[2], _e7435.member_1[3]), array<f32, 4>(_e7435.member_2[0], _e7435.member_2[1], _e7435.member_2[2], _e7435.member_2[3]));
                                            let _e7455 = (_e7156 - _e7162);
                                            let _e7459 = local_1.member[0u];
                                            let _e7462 = local_1.member_1[0u];
                                            let _e7465 = local_1.member[0u];
                                            let _e7471 = local_1.member_2[0u];
                                            if (((_e7459 + ((_e7462 - _e7465) * _e7156)) - _e7471) > 0f) {
                                                let _e7476 = local_1.member[1u];
                                                let _e7479 = local_1.member_1[1u];
                                                let _e7482 = local_1.member[1u];
                                                let _e7488 = local_1.member_2[1u];
                                                if (((_e7476 + ((_e7479 - _e7482) * _e7156)) - _e7488) > 0f) {
                                                    let _e7493 = local_1.member[2u];
                                                    let _e7496 = local_1.member_1[2u];
                                                    let _e7499 = local_1.member[2u];
                                                    let _e7505 = local_1.member_2[2u];
                                                    if (((_e7493 + ((_e7496 - _e7499) * _e7156)) - _e7505) > 0f) {
                                                        let _e7510 = local_1.member[3u];
                                                        let _e7513 = local_1.member_1[3u];
                                                        let _e7516 = local_1.member[3u];
                                                        let _e7522 = local_1.member_2[3u];
                                                        phi_12133_ = (((_e7510 + ((_e7513 - _e7516) * _e7156)) - _e7522) > 0f);
                                                        phi_12134_ = false;
                                                    } else {
                                                        phi_12133_ = bool();
                                                        phi_12134_ = true;
                                                    }
                                                    let _e7526 = phi_12133_;
                                                    let _e7528 = phi_12134_;
                                                    phi_12135_ = _e7526;
                                                    phi_12136_ = _e7528;
                                                } else {
                                                    phi_12135_ = bool();
                                                    phi_12136_ = true;
                                                }
                                                let _e7530 = phi_12135_;
                                                let _e7532 = phi_12136_;
                                                phi_12137_ = _e7530;
                                                phi_12138_ = _e7532;
                                            } else {
                                                phi_12137_ = bool();
                                                phi_12138_ = true;
                                            }
                                            let _e7534 = phi_12137_;
                                            let _e7536 = phi_12138_;
                                            if select(_e7534, false, _e7536) {
                                                if (_e7156 <= _e7158) {
                                                    phi_12452_ = true;
                                                } else {
                                                    let _e7541 = local.member[0u];
                                                    let _e7544 = local.member_1[0u];
                                                    let _e7547 = local.member[0u];
                                                    let _e7553 = local.member_2[0u];
                                                    let _e7557 = local_1.member[0u];
                                                    let _e7560 = local_1.member_1[0u];
                                                    let _e7563 = local_1.member[0u];
                                                    let _e7569 = local_1.member_2[0u];
                                                    if ((((_e7541 + ((_e7544 - _e7547) * _e7156)) - _e7553) + ((_e7557 + ((_e7560 - _e7563) * _e7162)) - _e7569)) > 0f) {
                                                        let _e7575 = local.member[1u];
                                                        let _e7578 = local.member_1[1u];
                                                        let _e7581 = local.member[1u];
                                                        let _e7587 = local.member_2[1u];
                                                        let _e7591 = local_1.member[1u];
                                                        let _e7594 = local_1.member_1[1u];
                                                        let _e7597 = local_1.member[1u];
                                                        let _e7603 = local_1.member_2[1u];
                                                        if ((((_e7575 + ((_e7578 - _e7581) * _e7156)) - _e7587) + ((_e7591 + ((_e7594 - _e7597) * _e7162)) - _e7603)) > 0f) {
                                                            let _e7609 = local.member[2u];
                                                            let _e7612 = local.member_1[2u];
                                                            let _e7615 = local.member[2u];
                                                            let _e7621 = local.member_2[2u];
                                                            let _e7625 = local_1.member[2u];
                                                            let _e7628 = local_1.member_1[2u];
                                                            let _e7631 = local_1.member[2u];
                                                            let _e7637 = local_1.member_2[2u];
                                                            if ((((_e7609 + ((_e7612 - _e7615) * _e7156)) - _e7621) + ((_e7625 + ((_e7628 - _e7631) * _e7162)) - _e7637)) > 0f) {
                                                                let _e7643 = local.member[3u];
                                                                let _e7646 = local.member_1[3u];
                                                                let _e7649 = local.member[3u];
                                                                let _e7655 = local.member_2[3u];
                                                                let _e7659 = local_1.member[3u];
                                                                let _e7662 = local_1.member_1[3u];
                                                                let _e7665 = local_1.member[3u];
                                                                let _e7671 = local_1.member_2[3u];
                                                                phi_12439_ = ((((_e7643 + ((_e7646 - _e7649) * _e7156)) - _e7655) + ((_e7659 + ((_e7662 - _e7665) * _e7162)) - _e7671)) > 0f);
                                                                phi_12440_ = false;
                                                            } else {
                                                                phi_12439_ = bool();
                                                                phi_12440_ = true;
                                                            }
                                                            let _e7676 = phi_12439_;
                                                            let _e7678 = phi_12440_;
                                                            phi_12441_ = _e7676;
                                                            phi_12442_ = _e7678;
                                                        } else {
                                                            phi_12441_ = bool();
                                                            phi_12442_ = true;
                                                        }
                                                        let _e7680 = phi_12441_;
                                                        let _e7682 = phi_12442_;
                                                        phi_12443_ = _e7680;
                                                        phi_12444_ = _e7682;
                                                    } else {
                                                        phi_12443_ = bool();
                                                        phi_12444_ = true;
                                                    }
                                                    let _e7684 = phi_12443_;
                                                    let _e7686 = phi_12444_;
                                                    phi_12452_ = select(_e7684, false, _e7686);
                                                }
                                                let _e7689 = phi_12452_;
                                                if _e7689 {
                                                    if select(true, select(true, false, (_e7156 >= _e6933.member_1)), _e7164) {
                                                        local = type_27(array<f32, 4>(_e7435.member[0], _e7435.member[1], _e7435.member[2], _e7435.member[3]), array<f32, 4>(_e7435.member_1[0], _e7435.member_1[1], _e7435.member_1[2], _e7435.member_1[3]), array<f32, 4>(_e7435.member_2[0], _e7435.member_2[1], _e7435.member_2[2], _e7435.member_2[3]));
                                                        let _e7714 = local.member[0u];
                                                        let _e7717 = local.member_1[0u];
                                                        let _e7720 = local.member_2[0u];
                                                        if select(true, select(true, false, (_e7717 > _e7720)), (_e7714 > _e7720)) {
                                                            let _e7725 = (_e7717 >= _e7714);
                                                            if _e7725 {
                                                                phi_12561_ = f32();
                                                                phi_12562_ = false;
                                                            } else {
                                                                if ((_e7714 - _e7717) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_12559_ = (((_e7714 - _e7720) / (_e7714 - _e7717)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_12560_ = false;
                                                                } else {
                                                                    phi_12559_ = f32();
                                                                    phi_12560_ = true;
                                                                }
                                                                let _e7736 = phi_12559_;
                                                                let _e7738 = phi_12560_;
                                                                phi_12561_ = _e7736;
                                                                phi_12562_ = _e7738;
                                                            }
                                                            let _e7740 = phi_12561_;
                                                            let _e7742 = phi_12562_;
                                                            phi_12563_ = _e7740;
                                                            phi_12564_ = _e7725;
                                                            phi_12565_ = _e7742;
                                                        } else {
                                                            phi_12563_ = f32();
                                                            phi_12564_ = true;
                                                            phi_12565_ = false;
                                                        }
                                                        let _e7744 = phi_12563_;
                                                        let _e7746 = phi_12564_;
                                                        let _e7748 = phi_12565_;
                                                        let _e7751 = select(_e7744, select(_e7156, 2f, _e7746), select(_e7748, true, _e7746));
                                                        let _e7754 = local.member[1u];
                                                        let _e7757 = local.member_1[1u];
                                                        let _e7760 = local.member_2[1u];
                                                        if select(true, select(true, false, (_e7757 > _e7760)), (_e7754 > _e7760)) {
                                                            let _e7765 = (_e7757 >= _e7754);
                                                            if _e7765 {
                                                                phi_12629_ = f32();
                                                                phi_12630_ = false;
                                                            } else {
                                                                if ((_e7754 - _e7757) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_12627_ = (((_e7754 - _e7760) / (_e7754 - _e7757)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_12628_ = false;
                                                                } else {
                                                                    phi_12627_ = f32();
                                                                    phi_12628_ = true;
                                                                }
                                                                let _e7776 = phi_12627_;
                                                                let _e7778 = phi_12628_;
                                                                phi_12629_ = _e7776;
                                                                phi_12630_ = _e7778;
                                                            }
                                                            let _e7780 = phi_12629_;
                                                            let _e7782 = phi_12630_;
                                                            phi_12631_ = _e7780;
                                                            phi_12632_ = _e7765;
                                                            phi_12633_ = _e7782;
                                                        } else {
                                                            phi_12631_ = f32();
                                                            phi_12632_ = true;
                                                            phi_12633_ = false;
                                                        }
                                                        let _e7784 = phi_12631_;
                                                        let _e7786 = phi_12632_;
                                                        let _e7788 = phi_12633_;
                                                        let _e7791 = select(_e7784, select(_e7156, 2f, _e7786), select(_e7788, true, _e7786));
                                                        let _e7793 = select(_e7791, _e7751, (_e7751 < _e7791));
                                                        let _e7796 = local.member[2u];
                                                        let _e7799 = local.member_1[2u];
                                                        let _e7802 = local.member_2[2u];
                                                        if select(true, select(true, false, (_e7799 > _e7802)), (_e7796 > _e7802)) {
                                                            let _e7807 = (_e7799 >= _e7796);
                                                            if _e7807 {
                                                                phi_12702_ = f32();
                                                                phi_12703_ = false;
                                                            } else {
                                                                if ((_e7796 - _e7799) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_12700_ = (((_e7796 - _e7802) / (_e7796 - _e7799)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_12701_ = false;
                                                                } else {
                                                                    phi_12700_ = f32();
                                                                    phi_12701_ = true;
                                                                }
                                                                let _e7818 = phi_12700_;
                                                                let _e7820 = phi_12701_;
                                                                phi_12702_ = _e7818;
                                                                phi_12703_ = _e7820;
                                                            }
                                                            let _e7822 = phi_12702_;
                                                            let _e7824 = phi_12703_;
                                                            phi_12704_ = _e7822;
                                                            phi_12705_ = _e7807;
                                                            phi_12706_ = _e7824;
                                                        } else {
                                                            phi_12704_ = f32();
                                                            phi_12705_ = true;
                                                            phi_12706_ = false;
                                                        }
                                                        let _e7826 = phi_12704_;
                                                        let _e7828 = phi_12705_;
                                                        let _e7830 = phi_12706_;
                                                        let _e7833 = select(_e7826, select(_e7156, 2f, _e7828), select(_e7830, true, _e7828));
                                                        let _e7836 = local.member[3u];
                                                        let _e7839 = local.member_1[3u];
                                                        let _e7842 = local.member_2[3u];
                                                        if select(true, select(true, false, (_e7839 > _e7842)), (_e7836 > _e7842)) {
                                                            let _e7847 = (_e7839 >= _e7836);
                                                            if _e7847 {
                                                                phi_12770_ = f32();
                                                                phi_12771_ = false;
                                                            } else {
                                                                if ((_e7836 - _e7839) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_12768_ = (((_e7836 - _e7842) / (_e7836 - _e7839)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_12769_ = false;
                                                                } else {
                                                                    phi_12768_ = f32();
                                                                    phi_12769_ = true;
                                                                }
                                                                let _e7858 = phi_12768_;
                                                                let _e7860 = phi_12769_;
                                                                phi_12770_ = _e7858;
                                                                phi_12771_ = _e7860;
                                                            }
                                                            let _e7862 = phi_12770_;
                                                            let _e7864 = phi_12771_;
                                                            phi_12772_ = _e7862;
                                                            phi_12773_ = _e7847;
                                                            phi_12774_ = _e7864;
                                                        } else {
                                                            phi_12772_ = f32();
                                                            phi_12773_ = true;
                                                            phi_12774_ = false;
                                                        }
                                                        let _e7866 = phi_12772_;
                                                        let _e7868 = phi_12773_;
                                                        let _e7870 = phi_12774_;
                                                        let _e7873 = select(_e7866, select(_e7156, 2f, _e7868), select(_e7870, true, _e7868));
                                                        let _e7875 = select(_e7873, _e7833, (_e7833 < _e7873));
                                                        let _e7877 = select(_e7875, _e7793, (_e7793 < _e7875));
                                                        let _e7879 = select(_e7156, _e7877, (_e7877 > _e7156));
                                                        let _e7880 = (_e7879 > _e6933.member_1);
                                                        if _e7880 {
                                                            phi_13303_ = f32();
                                                            phi_13304_ = f32();
                                                            phi_13305_ = false;
                                                        } else {
                                                            let _e7881 = (_e7879 - _e7156);
                                                            phi_13303_ = select((_e6933.member_1 - _e7156), select(0f, (_e7455 + _e7455), select(select(true, false, (_e7881 <= (_e7160 * 0.25f))), true, (_e7881 <= _e7151))), _e7164);
                                                            phi_13304_ = _e7881;
                                                            phi_13305_ = true;
                                                        }
                                                        let _e7892 = phi_13303_;
                                                        let _e7894 = phi_13304_;
                                                        let _e7896 = phi_13305_;
                                                        phi_13307_ = _e7879;
                                                        phi_13308_ = _e7892;
                                                        phi_13309_ = _e7894;
                                                        phi_13311_ = _e7896;
                                                        phi_13312_ = _e7880;
                                                        phi_13314_ = false;
                                                    } else {
                                                        phi_13307_ = f32();
                                                        phi_13308_ = f32();
                                                        phi_13309_ = f32();
                                                        phi_13311_ = false;
                                                        phi_13312_ = false;
                                                        phi_13314_ = true;
                                                    }
                                                    let _e7898 = phi_13307_;
                                                    let _e7900 = phi_13308_;
                                                    let _e7902 = phi_13309_;
                                                    let _e7904 = phi_13311_;
                                                    let _e7906 = phi_13312_;
                                                    let _e7908 = phi_13314_;
                                                    phi_13315_ = _e7898;
                                                    phi_13316_ = _e7900;
                                                    phi_13317_ = _e7902;
                                                    phi_13319_ = false;
                                                    phi_13320_ = _e7904;
                                                    phi_13321_ = _e7906;
                                                    phi_13323_ = _e7908;
                                                } else {
                                                    phi_13315_ = f32();
                                                    phi_13316_ = f32();
                                                    phi_13317_ = f32();
                                                    phi_13319_ = true;
                                                    phi_13320_ = false;
                                                    phi_13321_ = false;
                                                    phi_13323_ = false;
                                                }
                                                let _e7910 = phi_13315_;
                                                let _e7912 = phi_13316_;
                                                let _e7914 = phi_13317_;
                                                let _e7916 = phi_13319_;
                                                let _e7918 = phi_13320_;
                                                let _e7920 = phi_13321_;
                                                let _e7922 = phi_13323_;
                                                phi_13324_ = _e7910;
                                                phi_13325_ = _e7912;
                                                phi_13326_ = _e7914;
                                                phi_13328_ = _e7916;
                                                phi_13329_ = _e7918;
                                                phi_13330_ = _e7920;
                                                phi_13332_ = _e7922;
                                            } else {
                                                phi_13324_ = f32();
                                                phi_13325_ = f32();
                                                phi_13326_ = f32();
                                                phi_13328_ = true;
                                                phi_13329_ = false;
                                                phi_13330_ = false;
                                                phi_13332_ = false;
                                            }
                                            let _e7924 = phi_13324_;
                                            let _e7926 = phi_13325_;
                                            let _e7928 = phi_13326_;
                                            let _e7930 = phi_13328_;
                                            let _e7932 = phi_13329_;
                                            let _e7934 = phi_13330_;
                                            let _e7936 = phi_13332_;
                                            if _e7930 {
                                                if (_e7156 <= _e7158) {
                                                    let _e8089 = (_e7166 + 1u);
                                                    let _e8090 = (_e8089 > 3u);
                                                    phi_13667_ = _e8089;
                                                    phi_13668_ = f32();
                                                    phi_13669_ = false;
                                                    phi_13670_ = select(true, false, _e8090);
                                                    phi_13671_ = _e8090;
                                                } else {
                                                    let _e7940 = local.member[0u];
                                                    let _e7943 = local.member_1[0u];
                                                    let _e7946 = local.member[0u];
                                                    let _e7952 = local.member_2[0u];
                                                    let _e7953 = ((_e7940 + ((_e7943 - _e7946) * _e7162)) - _e7952);
                                                    let _e7956 = local.member[1u];
                                                    let _e7959 = local.member_1[1u];
                                                    let _e7962 = local.member[1u];
                                                    let _e7968 = local.member_2[1u];
                                                    let _e7969 = ((_e7956 + ((_e7959 - _e7962) * _e7162)) - _e7968);
                                                    let _e7971 = select(_e7969, _e7953, (_e7953 < _e7969));
                                                    let _e7974 = local.member[2u];
                                                    let _e7977 = local.member_1[2u];
                                                    let _e7980 = local.member[2u];
                                                    let _e7986 = local.member_2[2u];
                                                    let _e7987 = ((_e7974 + ((_e7977 - _e7980) * _e7162)) - _e7986);
                                                    let _e7990 = local.member[3u];
                                                    let _e7993 = local.member_1[3u];
                                                    let _e7996 = local.member[3u];
                                                    let _e8002 = local.member_2[3u];
                                                    let _e8003 = ((_e7990 + ((_e7993 - _e7996) * _e7162)) - _e8002);
                                                    let _e8005 = select(_e8003, _e7987, (_e7987 < _e8003));
                                                    let _e8007 = select(_e8005, _e7971, (_e7971 < _e8005));
                                                    let _e8010 = local_1.member[0u];
                                                    let _e8013 = local_1.member_1[0u];
                                                    let _e8016 = local_1.member[0u];
                                                    let _e8022 = local_1.member_2[0u];
                                                    let _e8023 = ((_e8010 + ((_e8013 - _e8016) * _e7156)) - _e8022);
                                                    let _e8026 = local_1.member[1u];
                                                    let _e8029 = local_1.member_1[1u];
                                                    let _e8032 = local_1.member[1u];
                                                    let _e8038 = local_1.member_2[1u];
                                                    let _e8039 = ((_e8026 + ((_e8029 - _e8032) * _e7156)) - _e8038);
                                                    let _e8041 = select(_e8039, _e8023, (_e8023 < _e8039));
                                                    let _e8044 = local_1.member[2u];
                                                    let _e8047 = local_1.member_1[2u];
                                                    let _e8050 = local_1.member[2u];
                                                    let _e8056 = local_1.member_2[2u];
                                                    let _e8057 = ((_e8044 + ((_e8047 - _e8050) * _e7156)) - _e8056);
                                                    let _e8060 = local_1.member[3u];
                                                    let _e8063 = local_1.member_1[3u];
                                                    let _e8066 = local_1.member[3u];
                                                    let _e8072 = local_1.member_2[3u];
                                                    let _e8073 = ((_e8060 + ((_e8063 - _e8066) * _e7156)) - _e8072);
                                                    let _e8075 = select(_e8073, _e8057, (_e8057 < _e8073));
                                                    let _e8077 = select(_e8075, _e8041, (_e8041 < _e8075));
                                                    if (_e8077 > 0f) {
                                                        phi_13665_ = 0.5f;
                                                    } else {
                                                        let _e8081 = (0.95f * (_e8007 / (_e8007 - _e8077)));
                                                        phi_13665_ = select(0.0625f, select(0.9f, _e8081, (_e8081 < 0.9f)), (_e8081 > 0.0625f));
                                                    }
                                                    let _e8087 = phi_13665_;
                                                    phi_13667_ = u32();
                                                    phi_13668_ = (_e7455 * _e8087);
                                                    phi_13669_ = true;
                                                    phi_13670_ = false;
                                                    phi_13671_ = false;
                                                }
                                                let _e8093 = phi_13667_;
                                                let _e8095 = phi_13668_;
                                                let _e8097 = phi_13669_;
                                                let _e8099 = phi_13670_;
                                                let _e8101 = phi_13671_;
                                                phi_13672_ = _e8093;
                                                phi_13673_ = _e7158;
                                                phi_13674_ = _e8095;
                                                phi_13675_ = _e7160;
                                                phi_13676_ = _e7162;
                                                phi_13677_ = _e7164;
                                                phi_13678_ = _e7166;
                                                phi_13679_ = _e8097;
                                                phi_13680_ = _e8099;
                                                phi_13681_ = _e8101;
                                                phi_13682_ = false;
                                                phi_13684_ = false;
                                            } else {
                                                phi_13672_ = u32();
                                                phi_13673_ = _e7924;
                                                phi_13674_ = _e7926;
                                                phi_13675_ = _e7928;
                                                phi_13676_ = _e7156;
                                                phi_13677_ = true;
                                                phi_13678_ = 0u;
                                                phi_13679_ = _e7932;
                                                phi_13680_ = false;
                                                phi_13681_ = false;
                                                phi_13682_ = _e7934;
                                                phi_13684_ = _e7936;
                                            }
                                            let _e8103 = phi_13672_;
                                            let _e8105 = phi_13673_;
                                            let _e8107 = phi_13674_;
                                            let _e8109 = phi_13675_;
                                            let _e8111 = phi_13676_;
                                            let _e8113 = phi_13677_;
                                            let _e8115 = phi_13678_;
                                            let _e8117 = phi_13679_;
                                            let _e8119 = phi_13680_;
                                            let _e8121 = phi_13681_;
                                            let _e8123 = phi_13682_;
                                            let _e8125 = phi_13684_;
                                            if _e8117 {
                                                let _e8126 = (_e8111 + _e8107);
                                                let _e8128 = select(_e8105, _e8126, (_e8126 > _e8105));
                                                let _e8130 = select(_e6933.member_1, _e8128, (_e8128 < _e6933.member_1));
                                                let _e8133 = select(((_e8130 - _e8111) > _e7151), true, !(_e7164));
                                                phi_13712_ = _e8130;
                                                phi_13713_ = _e8105;
                                                phi_13714_ = _e8109;
                                                phi_13715_ = _e8111;
                                                phi_13716_ = _e8113;
                                                phi_13717_ = _e8115;
                                                phi_13718_ = _e8133;
                                                phi_13719_ = select(true, false, _e8133);
                                                phi_13720_ = false;
                                                phi_13721_ = false;
                                                phi_13723_ = false;
                                            } else {
                                                phi_13712_ = _e7156;
                                                phi_13713_ = _e7158;
                                                phi_13714_ = _e7160;
                                                phi_13715_ = _e7162;
                                                phi_13716_ = _e7164;
                                                phi_13717_ = _e8103;
                                                phi_13718_ = _e8119;
                                                phi_13719_ = false;
                                                phi_13720_ = _e8121;
                                                phi_13721_ = _e8123;
                                                phi_13723_ = _e8125;
                                            }
                                            let _e8136 = phi_13712_;
                                            let _e8138 = phi_13713_;
                                            let _e8140 = phi_13714_;
                                            let _e8142 = phi_13715_;
                                            let _e8144 = phi_13716_;
                                            let _e8146 = phi_13717_;
                                            let _e8148 = phi_13718_;
                                            let _e8150 = phi_13719_;
                                            let _e8152 = phi_13720_;
                                            let _e8154 = phi_13721_;
                                            let _e8156 = phi_13723_;
                                            phi_11545_ = _e8136;
                                            phi_11547_ = _e8138;
                                            phi_11549_ = _e8140;
                                            phi_11551_ = _e8142;
                                            phi_11553_ = _e8144;
                                            phi_11555_ = _e8146;
                                            phi_13724_ = _e8105;
                                            phi_13726_ = _e8148;
                                            phi_13727_ = _e8150;
                                            phi_13728_ = _e8152;
                                            phi_13729_ = _e8154;
                                            phi_13731_ = false;
                                            phi_13732_ = _e8156;
                                        } else {
                                            phi_11545_ = f32();
                                            phi_11547_ = f32();
                                            phi_11549_ = f32();
                                            phi_11551_ = f32();
                                            phi_11553_ = bool();
                                            phi_11555_ = u32();
                                            phi_13724_ = f32();
                                            phi_13726_ = false;
                                            phi_13727_ = false;
                                            phi_13728_ = false;
                                            phi_13729_ = false;
                                            phi_13731_ = true;
                                            phi_13732_ = false;
                                        }
                                        let _e8158 = phi_11545_;
                                        let _e8160 = phi_11547_;
                                        let _e8162 = phi_11549_;
                                        let _e8164 = phi_11551_;
                                        let _e8166 = phi_11553_;
                                        let _e8168 = phi_11555_;
                                        let _e8170 = phi_13724_;
                                        let _e8172 = phi_13726_;
                                        let _e8174 = phi_13727_;
                                        let _e8176 = phi_13728_;
                                        let _e8178 = phi_13729_;
                                        let _e8180 = phi_13731_;
                                        let _e8182 = phi_13732_;
                                        local_86 = _e8174;
                                        local_87 = _e8176;
                                        local_88 = _e8174;
                                        local_89 = _e8178;
                                        local_90 = _e8174;
                                        local_91 = _e8180;
                                        local_92 = _e8174;
                                        local_93 = _e8182;
                                        local_95 = _e8174;
                                        local_96 = _e8170;
                                        continue;
                                        continuing {
                                            phi_11541_ = type_9(select(_e7154.member, (_e7154.member + 1u), _e7169), select(_e7154.member_1, _e7154.member_1, _e7169));
                                            phi_11544_ = _e8158;
                                            phi_11546_ = _e8160;
                                            phi_11548_ = _e8162;
                                            phi_11550_ = _e8164;
                                            phi_11552_ = _e8166;
                                            phi_11554_ = _e8168;
                                            break if !(_e8172);
                                        }
                                    }
                                    let _e8185 = local_86;
                                    let _e8187 = local_87;
                                    let _e8188 = select(_e8187, false, _e8185);
                                    let _e8190 = local_88;
                                    let _e8192 = local_89;
                                    let _e8195 = local_90;
                                    let _e8197 = local_91;
                                    let _e8200 = local_92;
                                    let _e8202 = local_93;
                                    let _e8208 = local_94;
                                    let _e8210 = select(select(_e8192, false, _e8190), false, _e8188);
                                    let _e8212 = local_95;
                                    let _e8219 = select(select(_e8212, false, _e8188), false, _e8210);
                                    let _e8224 = local_96;
                                    let _e8226 = local_97;
                                    let _e8228 = select(select(select(select(_e8197, false, _e8195), false, _e8188), false, _e8210), true, _e8219);
                                    let _e8235 = select(select(select(select(select(_e8202, false, _e8200), false, _e8188), false, _e8210), false, _e8219), false, _e8228);
                                    let _e8240 = select(select(select(select(_e8188, true, _e8210), false, _e8219), false, _e8228), true, _e8235);
                                    let _e8243 = (select(select(type_29().member, 1u, _e8228), select(select(select(type_29().member, 1u, _e8188), 0u, _e8210), 0u, _e8235), _e8240) != 0u);
                                    phi_13800_ = select(select(type_29().member_1, select(_e8226, _e8224, _e8219), _e8228), select(select(select(type_29().member_1, _e8208, _e8188), type_29().member_1, _e8210), type_29().member_1, _e8235), _e8240);
                                    phi_13801_ = select(true, false, _e8243);
                                    phi_13802_ = _e8243;
                                    phi_13803_ = false;
                                    phi_13804_ = false;
                                    phi_13805_ = false;
                                } else {
                                    phi_13800_ = f32();
                                    phi_13801_ = _e6941;
                                    phi_13802_ = false;
                                    phi_13803_ = _e6943;
                                    phi_13804_ = _e6945;
                                    phi_13805_ = _e6947;
                                }
                                let _e8246 = phi_13800_;
                                let _e8248 = phi_13801_;
                                let _e8250 = phi_13802_;
                                let _e8252 = phi_13803_;
                                let _e8254 = phi_13804_;
                                let _e8256 = phi_13805_;
                                phi_13806_ = _e6933;
                                phi_13807_ = _e6935;
                                phi_13808_ = _e8246;
                                phi_13809_ = _e6937;
                                phi_13810_ = _e8248;
                                phi_13811_ = _e8250;
                                phi_13812_ = false;
                                phi_13813_ = _e8252;
                                phi_13814_ = _e8254;
                                phi_13815_ = _e8256;
                            } else {
                                phi_13806_ = type_44();
                                phi_13807_ = bool();
                                phi_13808_ = f32();
                                phi_13809_ = type_44();
                                phi_13810_ = false;
                                phi_13811_ = false;
                                phi_13812_ = true;
                                phi_13813_ = false;
                                phi_13814_ = false;
                                phi_13815_ = false;
                            }
                            let _e8258 = phi_13806_;
                            let _e8260 = phi_13807_;
                            let _e8262 = phi_13808_;
                            let _e8264 = phi_13809_;
                            let _e8266 = phi_13810_;
                            let _e8268 = phi_13811_;
                            let _e8270 = phi_13812_;
                            let _e8272 = phi_13813_;
                            let _e8274 = phi_13814_;
                            let _e8276 = phi_13815_;
                            local_98 = _e8268;
                            local_99 = _e8260;
                            local_100 = _e8258;
                            local_101 = _e8262;
                            local_102 = _e8262;
                            local_103 = _e8262;
                            local_107 = _e8270;
                            local_108 = _e8272;
                            local_109 = _e8274;
                            local_110 = _e8276;
                            local_104 = _e8268;
                            local_105 = _e8264;
                            continue;
                            continuing {
                                phi_9686_ = type_9(select(_e5955.member, (_e5955.member + 1u), _e5958), select(_e5955.member_1, _e5955.member_1, _e5958));
                                break if !(_e8266);
                            }
                        }
                        let _e8279 = local_98;
                        if _e8279 {
                            let _e8281 = local_99;
                            if _e8281 {
                                let _e8283 = local_100;
                                let _e8286 = local_101;
                                let _e8288 = ((_e8283.member_1 - _e8286) <= _e5919);
                                let _e8293 = local_102;
                                phi_13831_ = type_29(select(type_29().member, 1u, _e8288), select(type_29().member_1, _e8293, _e8288));
                                phi_13832_ = select(true, false, _e8288);
                            } else {
                                phi_13831_ = type_29();
                                phi_13832_ = true;
                            }
                            let _e8298 = phi_13831_;
                            let _e8300 = phi_13832_;
                            let _e8305 = local_103;
                            phi_13838_ = type_29(select(_e8298.member, 2u, _e8300), select(_e8298.member_1, _e8305, _e8300));
                            phi_13839_ = false;
                            phi_13840_ = false;
                            phi_13841_ = false;
                            phi_13842_ = false;
                        } else {
                            phi_13838_ = type_29();
                            let _e8951 = local_107;
                            phi_13839_ = _e8951;
                            let _e8954 = local_108;
                            phi_13840_ = _e8954;
                            let _e8957 = local_109;
                            phi_13841_ = _e8957;
                            let _e8960 = local_110;
                            phi_13842_ = _e8960;
                        }
                        let _e8309 = phi_13838_;
                        let _e8311 = phi_13839_;
                        let _e8313 = phi_13840_;
                        let _e8315 = phi_13841_;
                        let _e8317 = phi_13842_;
                        let _e8324 = select(_e8313, false, _e8311);
                        let _e8328 = local_104;
                        let _e8335 = select(select(_e8315, false, _e8311), false, _e8324);
                        let _e8341 = select(select(select(_e8317, false, _e8311), false, _e8324), false, _e8335);
                        let _e8345 = local_105;
                        let _e8349 = select(select(_e8324, true, _e8335), true, _e8341);
                        phi_13884_ = type_29(select(_e8309.member, select(select(select(type_29().member, 0u, _e8324), 0u, _e8335), 1u, _e8341), _e8349), select(_e8309.member_1, select(select(select(type_29().member_1, type_29().member_1, _e8324), type_29().member_1, _e8335), _e8345.member, _e8341), _e8349));
                        phi_13885_ = type_29(select(type_29().member, 0u, _e8311), select(type_29().member_1, type_29().member_1, _e8311));
                        phi_13886_ = select(select(select(select(select(_e8328, false, _e8311), false, _e8324), false, _e8335), false, _e8341), true, _e8349);
                    }
                    let _e8360 = phi_13884_;
                    let _e8362 = phi_13885_;
                    let _e8364 = phi_13886_;
                    let _e8367 = select(_e8362.member, _e8360.member, _e8364);
                    let _e8370 = select(_e8362.member_1, _e8360.member_1, _e8364);
                    let _e8376 = select(0u, 1u, select(true, false, select(true, select(true, false, (_e8370 > _e5090)), (_e8367 == 1u))));
                    switch bitcast<i32>(_e8367) {
                        case 0: {
                            phi_13930_ = type_30(0u, _e8376, array<u32, 2>(0u, 0u), false);
                            break;
                        }
                        case 1: {
                            let _e8380 = function_4(_e8370);
                            phi_13930_ = type_30(0u, _e8376, _e8380, true);
                            break;
                        }
                        case 2: {
                            let _e8378 = function_4(_e8370);
                            phi_13930_ = type_30(1u, _e8376, _e8378, true);
                            break;
                        }
                        default: {
                            phi_13930_ = type_30();
                            break;
                        }
                    }
                    let _e8384 = phi_13930_;
                    let _e8388 = params.member.member.member_12;
                    let _e8389 = bitcast<u32>(_e8388);
                    if (_e8384.member_2[0] == select((_e8389 << bitcast<u32>(29i)), 0u, ((_e8389 & 2147483647u) < 8388608u))) {
                        let _e8399 = params.member.member.member_12;
                        let _e8400 = bitcast<u32>(_e8399);
                        let _e8401 = (_e8400 & 2147483647u);
                        phi_13970_ = (_e8384.member_2[1] == select(((_e8400 ^ _e8401) | ((_e8401 >> bitcast<u32>(3i)) + 939524096u)), 0u, (_e8401 < 8388608u)));
                    } else {
                        phi_13970_ = false;
                    }
                    let _e8411 = phi_13970_;
                    let _e8413 = params.member.member.member_1;
                    if ((_e8413 & 128u) != 0u) {
                        phi_13986_ = true;
                    } else {
                        let _e8417 = params.member.member.member_1;
                        phi_13986_ = select(false, _e8411, ((_e8417 & 64u) != 0u));
                    }
                    let _e8422 = phi_13986_;
                    phi_14005_ = type_30(select(1u, _e8384.member, select(true, select(true, false, _e8422), _e8384.member_3)), _e8384.member_1, _e8384.member_2, _e8384.member_3);
                } else {
                    phi_14005_ = _e5084;
                }
                let _e8433 = phi_14005_;
                phi_14006_ = _e8433;
                phi_14007_ = type_9(_e241, _e244);
            } else {
                phi_14006_ = type_30(0u, 0u, array<u32, 2>(0u, 0u), false);
                phi_14007_ = type_9(0u, 0u);
            }
            let _e8435 = phi_14006_;
            let _e8437 = phi_14007_;
            let _e8442 = (_e8435.member != 0u);
            let _e8445 = select(false, !(_e8442), _e8435.member_3);
            if _e8445 {
                let _e8449 = (_e8435.member_2[1] >> bitcast<u32>(20i));
                if (_e8449 <= 896u) {
                    phi_14038_ = 0u;
                } else {
                    phi_14038_ = ((((_e8449 - 896u) << bitcast<u32>(23i)) | ((_e8435.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e8435.member_2[0] >> bitcast<u32>(29i)));
                }
                let _e8464 = phi_14038_;
                let _e8466 = atomicMin((&earliest.member[0u]), _e8464);
            }
            let _e8469 = params.member.member.member_1;
            if ((_e8469 & 16u) != 0u) {
                if (_e157 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e8445 {
                    let _e8475 = atomicAdd((&counters[0u]), 1u);
                    phi_14060_ = _e8475;
                } else {
                    phi_14060_ = 0u;
                }
                let _e8477 = phi_14060_;
                workgroupBarrier();
                if (_e157 == 0u) {
                    let _e8480 = atomicLoad((&counters[0u]));
                    if (_e8480 > 0u) {
                        let _e8483 = atomicAdd((&contacts.member[0u]), _e8480);
                        atomicStore((&counters[1u]), _e8483);
                    }
                }
                workgroupBarrier();
                let _e8486 = atomicLoad((&counters[1u]));
                let _e8487 = (_e8486 + _e8477);
                if _e8445 {
                    let _e8490 = params.member.member_1.member_3;
                    let _e8492 = params.member.member_2.member.member;
                    if (_e8487 < _e8490) {
                        let _e8494 = (7u * _e8487);
                        atomicStore((&contacts.member[(4u + _e8494)]), _e8492);
                        atomicStore((&contacts.member[(_e8494 + 5u)]), _e8435.member);
                        atomicStore((&contacts.member[(_e8494 + 6u)]), _e8437.member);
                        atomicStore((&contacts.member[(_e8494 + 7u)]), _e8437.member_1);
                        atomicStore((&contacts.member[(_e8494 + 8u)]), _e8435.member_2[0]);
                        atomicStore((&contacts.member[(_e8494 + 9u)]), _e8435.member_2[1]);
                        atomicStore((&contacts.member[(_e8494 + 10u)]), _e8435.member_1);
                    }
                }
            }
            workgroupBarrier();
            if (_e157 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e8442 {
                let _e8518 = atomicAdd((&counters[0u]), 1u);
                phi_14126_ = _e8518;
            } else {
                phi_14126_ = 0u;
            }
            let _e8520 = phi_14126_;
            workgroupBarrier();
            if (_e157 == 0u) {
                let _e8523 = atomicLoad((&counters[0u]));
                if (_e8523 > 0u) {
                    let _e8526 = atomicAdd((&undecided.member[0u]), _e8523);
                    atomicStore((&counters[1u]), _e8526);
                }
            }
            workgroupBarrier();
            let _e8529 = atomicLoad((&counters[1u]));
            let _e8530 = (_e8529 + _e8520);
            if _e8442 {
                let _e8532 = params.member.member_2.member.member_1;
                if (_e8530 < _e8532) {
                    let _e8534 = (2u * _e8530);
                    atomicStore((&undecided.member[(4u + _e8534)]), _e8437.member);
                    atomicStore((&undecided.member[(_e8534 + 5u)]), _e8437.member_1);
                }
            }
        }
        continue;
        continuing {
            phi_960_ = type_9(select(_e212.member, (_e212.member + 1u), _e215), select(_e212.member_1, _e212.member_1, _e215));
            break if !(_e228);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_15(id, n, lane);
}
