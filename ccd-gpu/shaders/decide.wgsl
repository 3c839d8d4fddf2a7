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

struct type_10 {
    member: type_7,
    member_1: type_8,
    member_2: type_9,
}

struct type_11 {
    member: type_10,
}

struct type_13 {
    member: array<u32>,
}

struct type_16 {
    member: i32,
    member_1: i32,
}

struct type_17 {
    member: u32,
    member_1: i32,
}

struct type_19 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
}

struct type_21 {
    member: array<type_19>,
}

struct type_22 {
    member: u32,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: array<u32, 2>,
    member_5: u32,
}

struct type_25 {
    member: array<array<f32, 3>, 2>,
    member_1: array<array<f32, 3>, 2>,
    member_2: array<array<f32, 3>, 2>,
    member_3: f32,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: f32,
}

struct type_27 {
    member: u32,
    member_1: array<u32, 4>,
}

struct type_28 {
    member: f32,
    member_1: f32,
}

struct type_30 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_31 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
    member_2: array<f32, 4>,
}

struct type_35 {
    member: array<array<array<f32, 3>, 4>, 2>,
    member_1: f32,
    member_2: f32,
}

struct type_36 {
    member: type_25,
    member_1: f32,
}

struct type_37 {
    member: u32,
    member_1: f32,
}

struct type_38 {
    member: type_37,
    member_1: u32,
}

struct type_39 {
    member: u32,
    member_1: f32,
    member_2: f32,
}

struct type_40 {
    member: f32,
    member_1: f32,
    member_2: bool,
}

struct type_44 {
    member: array<atomic<u32>>,
}

@group(0) @binding(0) 
var<storage> params: type_11;
@group(0) @binding(1) 
var<storage> paths: type_21;
@group(0) @binding(3) 
var<storage> input: type_13;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(2) 
var<storage> elements: type_13;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_44;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_44;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_44;

fn function_(param: f32) -> array<u32, 2> {
    var phi_15985_: array<u32, 2>;

    let _e7 = bitcast<u32>(param);
    let _e8 = (_e7 & 2147483647u);
    if (_e8 < 8388608u) {
        phi_15985_ = array<u32, 2>(0u, 0u);
    } else {
        phi_15985_ = array<u32, 2>((_e7 << bitcast<u32>(29i)), ((_e7 ^ _e8) | ((_e8 >> bitcast<u32>(3i)) + 939524096u)));
    }
    let _e19 = phi_15985_;
    return _e19;
}

fn function_1(param_1: array<f32, 3>, param_2: array<f32, 3>) -> array<f32, 3> {
    var phi_15970_: array<f32, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_15970_ = param_2;
    } else {
        phi_15970_ = param_1;
    }
    let _e26 = phi_15970_;
    return _e26;
}

fn function_2(param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: array<f32, 3>, param_6: u32) -> array<f32, 3> {
    var phi_15831_: f32;
    var phi_15832_: f32;
    var phi_15871_: f32;
    var phi_15872_: f32;
    var phi_15917_: f32;
    var phi_15918_: f32;
    var phi_15652_: f32;
    var phi_15653_: f32;
    var phi_15698_: f32;
    var phi_15699_: f32;
    var phi_15741_: f32;
    var phi_15742_: f32;
    var phi_15790_: f32;
    var phi_15791_: f32;
    var phi_15933_: array<array<f32, 3>, 4>;

    let _e9 = (param_3[0] - param_4[0]);
    let _e12 = (param_3[1] - param_4[1]);
    let _e15 = (param_3[2] - param_4[2]);
    if (param_6 != 0u) {
        let _e157 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e157 > 0f) {
            if (_e157 < 1f) {
                phi_15652_ = _e157;
            } else {
                phi_15652_ = 1f;
            }
            let _e161 = phi_15652_;
            phi_15653_ = _e161;
        } else {
            phi_15653_ = 0f;
        }
        let _e163 = phi_15653_;
        let _e199 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e199 > 0f) {
            if (_e199 < 1f) {
                phi_15698_ = _e199;
            } else {
                phi_15698_ = 1f;
            }
            let _e203 = phi_15698_;
            phi_15699_ = _e203;
        } else {
            phi_15699_ = 0f;
        }
        let _e205 = phi_15699_;
        let _e238 = ((((_e9 * param_5[0]) + (_e12 * param_5[1])) + (_e15 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e238 > 0f) {
            if (_e238 < 1f) {
                phi_15741_ = _e238;
            } else {
                phi_15741_ = 1f;
            }
            let _e242 = phi_15741_;
            phi_15742_ = _e242;
        } else {
            phi_15742_ = 0f;
        }
        let _e244 = phi_15742_;
        let _e257 = (param_3[0] - param_5[0]);
        let _e260 = (param_3[1] - param_5[1]);
        let _e263 = (param_3[2] - param_5[2]);
        let _e283 = ((((_e257 * param_4[0]) + (_e260 * param_4[1])) + (_e263 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e283 > 0f) {
            if (_e283 < 1f) {
                phi_15790_ = _e283;
            } else {
                phi_15790_ = 1f;
            }
            let _e287 = phi_15790_;
            phi_15791_ = _e287;
        } else {
            phi_15791_ = 0f;
        }
        let _e289 = phi_15791_;
        phi_15933_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e163)), (param_3[1] - (param_4[1] * _e163)), (param_3[2] - (param_4[2] * _e163))), array<f32, 3>((param_3[0] - (param_5[0] * _e205)), (param_3[1] - (param_5[1] * _e205)), (param_3[2] - (param_5[2] * _e205))), array<f32, 3>((_e9 - (param_5[0] * _e244)), (_e12 - (param_5[1] * _e244)), (_e15 - (param_5[2] * _e244))), array<f32, 3>((_e257 - (param_4[0] * _e289)), (_e260 - (param_4[1] * _e289)), (_e263 - (param_4[2] * _e289))));
    } else {
        let _e19 = (param_5[0] - param_4[0]);
        let _e22 = (param_5[1] - param_4[1]);
        let _e25 = (param_5[2] - param_4[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        if (_e36 > 0f) {
            if (_e36 < 1f) {
                phi_15831_ = _e36;
            } else {
                phi_15831_ = 1f;
            }
            let _e40 = phi_15831_;
            phi_15832_ = _e40;
        } else {
            phi_15832_ = 0f;
        }
        let _e42 = phi_15832_;
        let _e49 = array<f32, 3>((_e9 - (_e19 * _e42)), (_e12 - (_e22 * _e42)), (_e15 - (_e25 * _e42)));
        let _e72 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e72 > 0f) {
            if (_e72 < 1f) {
                phi_15871_ = _e72;
            } else {
                phi_15871_ = 1f;
            }
            let _e76 = phi_15871_;
            phi_15872_ = _e76;
        } else {
            phi_15872_ = 0f;
        }
        let _e78 = phi_15872_;
        let _e114 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e114 > 0f) {
            if (_e114 < 1f) {
                phi_15917_ = _e114;
            } else {
                phi_15917_ = 1f;
            }
            let _e118 = phi_15917_;
            phi_15918_ = _e118;
        } else {
            phi_15918_ = 0f;
        }
        let _e120 = phi_15918_;
        phi_15933_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e78)), (param_3[1] - (param_4[1] * _e78)), (param_3[2] - (param_4[2] * _e78))), array<f32, 3>((param_3[0] - (param_5[0] * _e120)), (param_3[1] - (param_5[1] * _e120)), (param_3[2] - (param_5[2] * _e120))), _e49, _e49);
    }
    let _e302 = phi_15933_;
    let _e305 = function_1(_e302[0], _e302[1]);
    let _e307 = function_1(_e305, _e302[2]);
    let _e309 = function_1(_e307, _e302[3]);
    return _e309;
}

fn function_3(param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: array<f32, 3>, param_10: u32) -> array<f32, 3> {
    var phi_15553_: bool;
    var phi_15554_: bool;
    var phi_15555_: bool;
    var phi_15556_: bool;
    var phi_15560_: bool;
    var phi_15533_: bool;
    var phi_15534_: bool;
    var phi_15535_: bool;
    var phi_15536_: bool;
    var phi_15537_: bool;
    var phi_15538_: bool;
    var phi_15542_: bool;
    var phi_15561_: bool;
    var phi_15594_: array<f32, 3>;
    var phi_15595_: bool;
    var phi_15596_: array<f32, 3>;
    var phi_15597_: bool;
    var phi_15602_: array<f32, 3>;

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
                    phi_15533_ = (_e78 <= 1f);
                    phi_15534_ = false;
                } else {
                    phi_15533_ = bool();
                    phi_15534_ = true;
                }
                let _e99 = phi_15533_;
                let _e101 = phi_15534_;
                phi_15535_ = _e99;
                phi_15536_ = _e101;
            } else {
                phi_15535_ = bool();
                phi_15536_ = true;
            }
            let _e103 = phi_15535_;
            let _e105 = phi_15536_;
            phi_15537_ = _e103;
            phi_15538_ = _e105;
        } else {
            phi_15537_ = bool();
            phi_15538_ = true;
        }
        let _e107 = phi_15537_;
        let _e109 = phi_15538_;
        if _e109 {
            phi_15542_ = false;
        } else {
            phi_15542_ = _e107;
        }
        let _e111 = phi_15542_;
        phi_15561_ = _e111;
    } else {
        if (_e74 >= 0f) {
            if (_e78 >= 0f) {
                phi_15553_ = ((_e74 + _e78) <= 1f);
                phi_15554_ = false;
            } else {
                phi_15553_ = bool();
                phi_15554_ = true;
            }
            let _e85 = phi_15553_;
            let _e87 = phi_15554_;
            phi_15555_ = _e85;
            phi_15556_ = _e87;
        } else {
            phi_15555_ = bool();
            phi_15556_ = true;
        }
        let _e89 = phi_15555_;
        let _e91 = phi_15556_;
        if _e91 {
            phi_15560_ = false;
        } else {
            phi_15560_ = _e89;
        }
        let _e93 = phi_15560_;
        phi_15561_ = _e93;
    }
    let _e113 = phi_15561_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e113 {
            phi_15594_ = array<f32, 3>((param_7[0] - ((param_8[0] * _e74) + (param_9[0] * _e78))), (param_7[1] - ((param_8[1] * _e74) + (param_9[1] * _e78))), (param_7[2] - ((param_8[2] * _e74) + (param_9[2] * _e78))));
            phi_15595_ = false;
        } else {
            phi_15594_ = array<f32, 3>();
            phi_15595_ = true;
        }
        let _e141 = phi_15594_;
        let _e143 = phi_15595_;
        phi_15596_ = _e141;
        phi_15597_ = _e143;
    } else {
        phi_15596_ = array<f32, 3>();
        phi_15597_ = true;
    }
    let _e145 = phi_15596_;
    let _e147 = phi_15597_;
    if _e147 {
        let _e148 = function_2(param_7, param_8, param_9, param_10);
        phi_15602_ = _e148;
    } else {
        phi_15602_ = _e145;
    }
    let _e150 = phi_15602_;
    return _e150;
}

fn function_4(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_31;
    var local_1: type_31;
    var local_2: type_26;
    var local_3: type_26;
    var local_4: type_26;
    var local_5: array<type_28, 4>;
    var local_6: array<f32, 4>;
    var local_7: array<f32, 2>;
    var local_8: type_31;
    var local_9: type_31;
    var local_10: type_31;
    var local_11: type_31;
    var local_12: array<f32, 4>;
    var local_13: array<f32, 3>;
    var local_14: type_35;
    var local_15: type_31;
    var local_16: type_31;
    var local_17: type_31;
    var local_18: type_25;
    var phi_246_: u32;
    var phi_256_: u32;
    var phi_263_: u32;
    var phi_279_: u32;
    var phi_300_: u32;
    var phi_301_: u32;
    var phi_304_: type_9;
    var phi_305_: type_9;
    var phi_328_: type_9;
    var phi_461_: type_27;
    var phi_604_: type_25;
    var phi_619_: array<u32, 2>;
    var phi_633_: bool;
    var phi_649_: bool;
    var phi_657_: f32;
    var phi_664_: f32;
    var phi_669_: f32;
    var phi_676_: f32;
    var phi_681_: f32;
    var phi_689_: f32;
    var phi_696_: f32;
    var phi_701_: f32;
    var phi_708_: f32;
    var phi_713_: f32;
    var phi_718_: f32;
    var phi_728_: f32;
    var phi_735_: f32;
    var phi_740_: f32;
    var phi_747_: f32;
    var phi_752_: f32;
    var phi_760_: f32;
    var phi_767_: f32;
    var phi_772_: f32;
    var phi_779_: f32;
    var phi_784_: f32;
    var phi_789_: f32;
    var phi_799_: f32;
    var phi_806_: f32;
    var phi_811_: f32;
    var phi_818_: f32;
    var phi_823_: f32;
    var phi_831_: f32;
    var phi_838_: f32;
    var phi_843_: f32;
    var phi_850_: f32;
    var phi_855_: f32;
    var phi_860_: f32;
    var phi_867_: f32;
    var phi_872_: f32;
    var phi_879_: bool;
    var phi_903_: u32;
    var phi_914_: f32;
    var phi_915_: f32;
    var phi_973_: type_36;
    var phi_974_: bool;
    var phi_975_: type_36;
    var phi_976_: bool;
    var phi_977_: type_36;
    var phi_978_: bool;
    var phi_983_: type_36;
    var phi_7929_: f32;
    var phi_7936_: f32;
    var phi_7941_: f32;
    var phi_7948_: f32;
    var phi_7953_: f32;
    var phi_7966_: f32;
    var phi_7973_: f32;
    var phi_7978_: f32;
    var phi_7985_: f32;
    var phi_7990_: f32;
    var phi_7995_: f32;
    var phi_8012_: f32;
    var phi_8019_: f32;
    var phi_8024_: f32;
    var phi_8031_: f32;
    var phi_8036_: f32;
    var phi_8050_: f32;
    var phi_8057_: f32;
    var phi_8062_: f32;
    var phi_8069_: f32;
    var phi_8074_: f32;
    var phi_8079_: f32;
    var phi_8096_: f32;
    var phi_8103_: f32;
    var phi_8108_: f32;
    var phi_8115_: f32;
    var phi_8120_: f32;
    var phi_8134_: f32;
    var phi_8141_: f32;
    var phi_8146_: f32;
    var phi_8153_: f32;
    var phi_8158_: f32;
    var phi_8163_: f32;
    var phi_8194_: f32;
    var phi_8200_: f32;
    var phi_8207_: f32;
    var phi_8214_: f32;
    var phi_8220_: f32;
    var phi_8227_: f32;
    var phi_8233_: f32;
    var phi_8239_: f32;
    var phi_8245_: f32;
    var phi_8252_: f32;
    var phi_8259_: f32;
    var phi_8283_: f32;
    var phi_8288_: f32;
    var phi_8293_: f32;
    var phi_8298_: f32;
    var phi_8303_: f32;
    var phi_8308_: f32;
    var phi_8318_: f32;
    var phi_8331_: f32;
    var phi_8337_: f32;
    var phi_8342_: f32;
    var phi_8348_: f32;
    var phi_8354_: f32;
    var phi_8359_: f32;
    var phi_8364_: f32;
    var phi_8372_: bool;
    var phi_8377_: f32;
    var phi_8384_: f32;
    var phi_8390_: f32;
    var phi_8408_: f32;
    var phi_8469_: array<f32, 3>;
    var phi_8534_: array<f32, 3>;
    var phi_8556_: f32;
    var phi_8563_: f32;
    var phi_8568_: f32;
    var phi_8575_: f32;
    var phi_8580_: f32;
    var phi_8593_: f32;
    var phi_8600_: f32;
    var phi_8605_: f32;
    var phi_8612_: f32;
    var phi_8617_: f32;
    var phi_8622_: f32;
    var phi_8639_: f32;
    var phi_8646_: f32;
    var phi_8651_: f32;
    var phi_8658_: f32;
    var phi_8663_: f32;
    var phi_8677_: f32;
    var phi_8684_: f32;
    var phi_8689_: f32;
    var phi_8696_: f32;
    var phi_8701_: f32;
    var phi_8706_: f32;
    var phi_8723_: f32;
    var phi_8730_: f32;
    var phi_8735_: f32;
    var phi_8742_: f32;
    var phi_8747_: f32;
    var phi_8761_: f32;
    var phi_8768_: f32;
    var phi_8773_: f32;
    var phi_8780_: f32;
    var phi_8785_: f32;
    var phi_8790_: f32;
    var phi_8908_: f32;
    var phi_8915_: f32;
    var phi_8923_: f32;
    var phi_8967_: type_16;
    var phi_8970_: f32;
    var phi_8991_: bool;
    var phi_8997_: type_17;
    var phi_8968_: type_16;
    var phi_9011_: type_17;
    var phi_8971_: f32;
    var local_19: f32;
    var phi_8960_: f32;
    var phi_9024_: f32;
    var phi_9090_: f32;
    var phi_9096_: f32;
    var phi_9105_: f32;
    var phi_9111_: f32;
    var phi_9120_: f32;
    var phi_9126_: f32;
    var phi_9135_: f32;
    var phi_9141_: f32;
    var phi_9147_: type_31;
    var phi_9148_: bool;
    var phi_9149_: type_31;
    var phi_9150_: bool;
    var phi_9158_: type_31;
    var phi_9327_: bool;
    var phi_9328_: bool;
    var phi_9329_: bool;
    var phi_9330_: bool;
    var phi_9331_: bool;
    var phi_9332_: bool;
    var phi_9336_: bool;
    var phi_9363_: f32;
    var phi_9417_: type_16;
    var phi_9420_: f32;
    var phi_9441_: bool;
    var phi_9447_: type_17;
    var phi_9418_: type_16;
    var phi_9461_: type_17;
    var phi_9421_: f32;
    var local_20: f32;
    var phi_9410_: f32;
    var phi_9474_: f32;
    var phi_9540_: f32;
    var phi_9546_: f32;
    var phi_9555_: f32;
    var phi_9561_: f32;
    var phi_9570_: f32;
    var phi_9576_: f32;
    var phi_9585_: f32;
    var phi_9591_: f32;
    var phi_9597_: type_31;
    var phi_9598_: bool;
    var phi_9599_: type_31;
    var phi_9600_: bool;
    var phi_9608_: type_31;
    var phi_9777_: bool;
    var phi_9778_: bool;
    var phi_9779_: bool;
    var phi_9780_: bool;
    var phi_9781_: bool;
    var phi_9782_: bool;
    var phi_9786_: bool;
    var phi_9819_: f32;
    var phi_9867_: type_16;
    var phi_9870_: f32;
    var phi_9891_: bool;
    var phi_9897_: type_17;
    var phi_9868_: type_16;
    var phi_9911_: type_17;
    var phi_9871_: f32;
    var local_21: f32;
    var phi_9860_: f32;
    var phi_9924_: f32;
    var phi_9990_: f32;
    var phi_9996_: f32;
    var phi_10005_: f32;
    var phi_10011_: f32;
    var phi_10020_: f32;
    var phi_10026_: f32;
    var phi_10035_: f32;
    var phi_10041_: f32;
    var phi_10047_: type_31;
    var phi_10048_: bool;
    var phi_10049_: type_31;
    var phi_10050_: bool;
    var phi_10058_: type_31;
    var phi_10227_: bool;
    var phi_10228_: bool;
    var phi_10229_: bool;
    var phi_10230_: bool;
    var phi_10231_: bool;
    var phi_10232_: bool;
    var phi_10236_: bool;
    var phi_10276_: f32;
    var phi_10317_: type_16;
    var phi_10320_: f32;
    var phi_10341_: bool;
    var phi_10347_: type_17;
    var phi_10318_: type_16;
    var phi_10361_: type_17;
    var phi_10321_: f32;
    var local_22: f32;
    var phi_10310_: f32;
    var phi_10374_: f32;
    var phi_10440_: f32;
    var phi_10446_: f32;
    var phi_10455_: f32;
    var phi_10461_: f32;
    var phi_10470_: f32;
    var phi_10476_: f32;
    var phi_10485_: f32;
    var phi_10491_: f32;
    var phi_10497_: type_31;
    var phi_10498_: bool;
    var phi_10499_: type_31;
    var phi_10500_: bool;
    var phi_10508_: type_31;
    var phi_10677_: bool;
    var phi_10678_: bool;
    var phi_10679_: bool;
    var phi_10680_: bool;
    var phi_10681_: bool;
    var phi_10682_: bool;
    var phi_10686_: bool;
    var phi_10687_: bool;
    var phi_10688_: bool;
    var phi_10689_: bool;
    var phi_10690_: bool;
    var phi_10691_: bool;
    var phi_10695_: bool;
    var phi_10701_: type_37;
    var phi_10702_: bool;
    var phi_10703_: type_37;
    var phi_10704_: bool;
    var phi_10747_: type_16;
    var phi_10750_: f32;
    var phi_10771_: bool;
    var phi_10777_: type_17;
    var phi_10748_: type_16;
    var phi_10791_: type_17;
    var phi_10751_: f32;
    var local_23: f32;
    var phi_10740_: f32;
    var phi_10804_: f32;
    var phi_10810_: f32;
    var phi_10835_: type_9;
    var phi_10838_: u32;
    var phi_10836_: type_9;
    var phi_10861_: type_9;
    var phi_10905_: u32;
    var phi_10906_: u32;
    var phi_10839_: u32;
    var phi_10907_: u32;
    var phi_10927_: type_9;
    var phi_10928_: type_9;
    var phi_10951_: type_9;
    var phi_10970_: f32;
    var phi_10983_: f32;
    var phi_11017_: f32;
    var phi_11024_: f32;
    var phi_11035_: bool;
    var phi_11036_: bool;
    var phi_11037_: bool;
    var phi_11038_: bool;
    var phi_11042_: bool;
    var phi_11053_: type_40;
    var phi_11054_: type_40;
    var phi_11055_: bool;
    var phi_11056_: type_40;
    var phi_11057_: bool;
    var phi_11068_: f32;
    var phi_11078_: type_9;
    var phi_11081_: f32;
    var phi_11083_: f32;
    var phi_11085_: f32;
    var phi_11079_: type_9;
    var phi_11108_: type_9;
    var phi_11133_: f32;
    var phi_11134_: f32;
    var phi_11160_: f32;
    var phi_11176_: f32;
    var phi_11183_: bool;
    var phi_11184_: bool;
    var phi_11185_: bool;
    var phi_11191_: f32;
    var phi_11192_: f32;
    var phi_11193_: bool;
    var phi_11082_: f32;
    var phi_11084_: f32;
    var phi_11086_: f32;
    var phi_11194_: f32;
    var phi_11195_: bool;
    var phi_11196_: bool;
    var local_24: bool;
    var phi_11200_: f32;
    var phi_11201_: f32;
    var phi_11209_: f32;
    var phi_11213_: type_9;
    var phi_11216_: f32;
    var phi_11214_: type_9;
    var phi_11239_: type_9;
    var phi_11269_: f32;
    var phi_11270_: bool;
    var phi_11271_: f32;
    var phi_11272_: bool;
    var phi_11273_: bool;
    var phi_11274_: bool;
    var phi_11275_: f32;
    var phi_11217_: f32;
    var phi_11276_: bool;
    var phi_11277_: bool;
    var phi_11278_: bool;
    var phi_11279_: bool;
    var local_25: bool;
    var phi_11283_: bool;
    var phi_11284_: bool;
    var phi_11288_: bool;
    var phi_11292_: f32;
    var phi_11293_: f32;
    var phi_11295_: type_40;
    var phi_11324_: f32;
    var phi_11331_: f32;
    var phi_11336_: f32;
    var phi_11343_: f32;
    var phi_11348_: f32;
    var phi_11361_: f32;
    var phi_11368_: f32;
    var phi_11373_: f32;
    var phi_11380_: f32;
    var phi_11385_: f32;
    var phi_11390_: f32;
    var phi_11449_: f32;
    var phi_11455_: f32;
    var phi_11460_: f32;
    var phi_11466_: f32;
    var phi_11471_: f32;
    var phi_11483_: f32;
    var phi_11489_: f32;
    var phi_11494_: f32;
    var phi_11500_: f32;
    var phi_11505_: f32;
    var phi_11531_: f32;
    var phi_11538_: f32;
    var phi_11543_: f32;
    var phi_11550_: f32;
    var phi_11555_: f32;
    var phi_11568_: f32;
    var phi_11575_: f32;
    var phi_11580_: f32;
    var phi_11587_: f32;
    var phi_11592_: f32;
    var phi_11597_: f32;
    var phi_11656_: f32;
    var phi_11662_: f32;
    var phi_11667_: f32;
    var phi_11673_: f32;
    var phi_11678_: f32;
    var phi_11690_: f32;
    var phi_11696_: f32;
    var phi_11701_: f32;
    var phi_11707_: f32;
    var phi_11712_: f32;
    var phi_11738_: f32;
    var phi_11745_: f32;
    var phi_11750_: f32;
    var phi_11757_: f32;
    var phi_11762_: f32;
    var phi_11775_: f32;
    var phi_11782_: f32;
    var phi_11787_: f32;
    var phi_11794_: f32;
    var phi_11799_: f32;
    var phi_11804_: f32;
    var phi_11863_: f32;
    var phi_11869_: f32;
    var phi_11874_: f32;
    var phi_11880_: f32;
    var phi_11885_: f32;
    var phi_11897_: f32;
    var phi_11903_: f32;
    var phi_11908_: f32;
    var phi_11914_: f32;
    var phi_11919_: f32;
    var phi_11968_: f32;
    var phi_11974_: f32;
    var phi_12002_: f32;
    var phi_12008_: f32;
    var phi_12013_: u32;
    var phi_12014_: u32;
    var phi_11984_: f32;
    var phi_11990_: f32;
    var phi_11995_: u32;
    var phi_11996_: u32;
    var phi_12015_: u32;
    var phi_12016_: u32;
    var phi_12085_: f32;
    var phi_12094_: f32;
    var phi_12229_: f32;
    var phi_12235_: f32;
    var phi_12242_: f32;
    var phi_12277_: array<type_28, 4>;
    var phi_12297_: type_9;
    var phi_12300_: bool;
    var phi_12298_: type_9;
    var phi_12323_: type_9;
    var phi_12350_: bool;
    var phi_12351_: bool;
    var phi_12301_: bool;
    var phi_12352_: bool;
    var phi_12353_: bool;
    var local_26: bool;
    var phi_12357_: bool;
    var local_27: bool;
    var phi_12364_: u32;
    var phi_12365_: u32;
    var phi_12366_: bool;
    var phi_12367_: u32;
    var phi_12368_: u32;
    var phi_12369_: bool;
    var phi_12373_: u32;
    var phi_12383_: bool;
    var phi_12395_: bool;
    var phi_12396_: bool;
    var phi_12457_: array<f32, 3>;
    var phi_12522_: array<f32, 3>;
    var phi_12544_: f32;
    var phi_12551_: f32;
    var phi_12556_: f32;
    var phi_12563_: f32;
    var phi_12568_: f32;
    var phi_12581_: f32;
    var phi_12588_: f32;
    var phi_12593_: f32;
    var phi_12600_: f32;
    var phi_12605_: f32;
    var phi_12610_: f32;
    var phi_12627_: f32;
    var phi_12634_: f32;
    var phi_12639_: f32;
    var phi_12646_: f32;
    var phi_12651_: f32;
    var phi_12665_: f32;
    var phi_12672_: f32;
    var phi_12677_: f32;
    var phi_12684_: f32;
    var phi_12689_: f32;
    var phi_12694_: f32;
    var phi_12711_: f32;
    var phi_12718_: f32;
    var phi_12723_: f32;
    var phi_12730_: f32;
    var phi_12735_: f32;
    var phi_12749_: f32;
    var phi_12756_: f32;
    var phi_12761_: f32;
    var phi_12768_: f32;
    var phi_12773_: f32;
    var phi_12778_: f32;
    var phi_12819_: type_9;
    var phi_12822_: f32;
    var phi_12824_: f32;
    var phi_12826_: f32;
    var phi_12828_: f32;
    var phi_12830_: bool;
    var phi_12832_: u32;
    var phi_12820_: type_9;
    var phi_12855_: type_9;
    var phi_12969_: f32;
    var phi_12975_: f32;
    var phi_12981_: f32;
    var phi_12983_: array<f32, 3>;
    var phi_12990_: f32;
    var phi_12997_: f32;
    var phi_13005_: f32;
    var phi_13049_: type_16;
    var phi_13052_: f32;
    var phi_13073_: bool;
    var phi_13079_: type_17;
    var phi_13050_: type_16;
    var phi_13093_: type_17;
    var phi_13053_: f32;
    var local_28: f32;
    var phi_13042_: f32;
    var phi_13106_: f32;
    var phi_13172_: f32;
    var phi_13178_: f32;
    var phi_13187_: f32;
    var phi_13193_: f32;
    var phi_13202_: f32;
    var phi_13208_: f32;
    var phi_13217_: f32;
    var phi_13223_: f32;
    var phi_13229_: type_31;
    var phi_13230_: bool;
    var phi_13231_: type_31;
    var phi_13232_: bool;
    var phi_13240_: type_31;
    var phi_13411_: bool;
    var phi_13412_: bool;
    var phi_13413_: bool;
    var phi_13414_: bool;
    var phi_13415_: bool;
    var phi_13416_: bool;
    var phi_13420_: bool;
    var phi_13717_: bool;
    var phi_13718_: bool;
    var phi_13719_: bool;
    var phi_13720_: bool;
    var phi_13721_: bool;
    var phi_13722_: bool;
    var phi_13726_: bool;
    var phi_13730_: bool;
    var phi_13741_: bool;
    var phi_13742_: bool;
    var phi_13816_: bool;
    var phi_13817_: bool;
    var phi_13837_: f32;
    var phi_13838_: bool;
    var phi_13839_: f32;
    var phi_13840_: bool;
    var phi_13841_: f32;
    var phi_13842_: bool;
    var phi_13843_: bool;
    var phi_13847_: f32;
    var phi_13848_: bool;
    var phi_13852_: f32;
    var phi_13884_: bool;
    var phi_13885_: bool;
    var phi_13905_: f32;
    var phi_13906_: bool;
    var phi_13907_: f32;
    var phi_13908_: bool;
    var phi_13909_: f32;
    var phi_13910_: bool;
    var phi_13911_: bool;
    var phi_13915_: f32;
    var phi_13916_: bool;
    var phi_13920_: f32;
    var phi_13925_: f32;
    var phi_13957_: bool;
    var phi_13958_: bool;
    var phi_13978_: f32;
    var phi_13979_: bool;
    var phi_13980_: f32;
    var phi_13981_: bool;
    var phi_13982_: f32;
    var phi_13983_: bool;
    var phi_13984_: bool;
    var phi_13988_: f32;
    var phi_13989_: bool;
    var phi_13993_: f32;
    var phi_14025_: bool;
    var phi_14026_: bool;
    var phi_14046_: f32;
    var phi_14047_: bool;
    var phi_14048_: f32;
    var phi_14049_: bool;
    var phi_14050_: f32;
    var phi_14051_: bool;
    var phi_14052_: bool;
    var phi_14056_: f32;
    var phi_14057_: bool;
    var phi_14061_: f32;
    var phi_14066_: f32;
    var phi_14071_: f32;
    var phi_14076_: f32;
    var phi_14570_: bool;
    var phi_14571_: bool;
    var phi_14576_: f32;
    var phi_14578_: f32;
    var phi_14581_: f32;
    var phi_14582_: f32;
    var phi_14583_: bool;
    var phi_14585_: f32;
    var phi_14586_: f32;
    var phi_14587_: f32;
    var phi_14589_: bool;
    var phi_14590_: bool;
    var phi_14592_: bool;
    var phi_14593_: f32;
    var phi_14594_: f32;
    var phi_14595_: f32;
    var phi_14597_: bool;
    var phi_14598_: bool;
    var phi_14599_: bool;
    var phi_14601_: bool;
    var phi_14602_: f32;
    var phi_14603_: f32;
    var phi_14604_: f32;
    var phi_14606_: bool;
    var phi_14607_: bool;
    var phi_14608_: bool;
    var phi_14610_: bool;
    var phi_14696_: f32;
    var phi_14769_: f32;
    var phi_14774_: f32;
    var phi_14847_: f32;
    var phi_14920_: f32;
    var phi_14925_: f32;
    var phi_14941_: f32;
    var phi_14942_: f32;
    var phi_14943_: f32;
    var phi_14623_: bool;
    var phi_14945_: u32;
    var phi_14946_: f32;
    var phi_14947_: bool;
    var phi_14948_: bool;
    var phi_14949_: bool;
    var phi_14950_: u32;
    var phi_14951_: f32;
    var phi_14952_: f32;
    var phi_14953_: f32;
    var phi_14954_: f32;
    var phi_14955_: bool;
    var phi_14956_: u32;
    var phi_14957_: bool;
    var phi_14958_: bool;
    var phi_14959_: bool;
    var phi_14960_: bool;
    var phi_14962_: bool;
    var phi_14971_: f32;
    var phi_14976_: f32;
    var phi_14985_: bool;
    var phi_14989_: bool;
    var phi_14990_: f32;
    var phi_14991_: f32;
    var phi_14992_: f32;
    var phi_14993_: f32;
    var phi_14994_: bool;
    var phi_14995_: u32;
    var phi_14996_: bool;
    var phi_14997_: bool;
    var phi_14998_: bool;
    var phi_14999_: bool;
    var phi_15001_: bool;
    var phi_12823_: f32;
    var phi_12825_: f32;
    var phi_12827_: f32;
    var phi_12829_: f32;
    var phi_12831_: bool;
    var phi_12833_: u32;
    var phi_15002_: f32;
    var phi_15004_: bool;
    var phi_15005_: bool;
    var phi_15006_: bool;
    var phi_15007_: bool;
    var phi_15009_: bool;
    var phi_15010_: bool;
    var local_29: bool;
    var phi_15014_: bool;
    var phi_15015_: bool;
    var phi_15017_: bool;
    var phi_15018_: bool;
    var local_30: f32;
    var phi_15023_: type_37;
    var phi_15024_: bool;
    var phi_15026_: bool;
    var phi_15027_: bool;
    var phi_15028_: bool;
    var phi_15033_: type_37;
    var phi_15035_: bool;
    var phi_15036_: bool;
    var phi_15037_: bool;
    var phi_15038_: bool;
    var phi_15050_: f32;
    var phi_15051_: bool;
    var phi_15052_: bool;
    var phi_15053_: bool;
    var phi_15058_: type_37;
    var phi_15059_: bool;
    var phi_15060_: bool;
    var phi_15065_: type_37;
    var phi_15066_: bool;
    var phi_15070_: type_37;
    var phi_15077_: bool;
    var phi_15078_: f32;
    var phi_15079_: bool;
    var phi_15080_: bool;
    var phi_15081_: bool;
    var phi_15082_: bool;
    var phi_15083_: f32;
    var phi_15084_: f32;
    var phi_15085_: bool;
    var phi_15086_: bool;
    var phi_15087_: bool;
    var phi_15088_: bool;
    var phi_15089_: f32;
    var phi_15090_: f32;
    var phi_15091_: bool;
    var phi_15092_: bool;
    var phi_15093_: bool;
    var phi_15094_: bool;
    var phi_15098_: bool;
    var phi_15099_: bool;
    var phi_15100_: bool;
    var phi_15101_: type_40;
    var phi_15102_: bool;
    var phi_15103_: f32;
    var phi_15104_: f32;
    var phi_15105_: type_40;
    var phi_15106_: bool;
    var phi_15107_: bool;
    var phi_15108_: bool;
    var phi_15109_: bool;
    var phi_15113_: bool;
    var phi_15114_: bool;
    var phi_15115_: bool;
    var phi_15116_: type_40;
    var phi_15117_: bool;
    var phi_15118_: f32;
    var phi_15119_: f32;
    var phi_15120_: type_40;
    var phi_15121_: bool;
    var phi_15122_: bool;
    var phi_15123_: bool;
    var phi_15124_: bool;
    var local_31: bool;
    var phi_15129_: type_37;
    var phi_15130_: bool;
    var phi_15131_: bool;
    var local_32: bool;
    var local_33: type_40;
    var local_34: f32;
    var local_35: f32;
    var local_36: f32;
    var phi_15145_: type_37;
    var phi_15146_: bool;
    var phi_15147_: type_37;
    var phi_15148_: bool;
    var local_37: f32;
    var phi_15153_: type_37;
    var phi_15154_: type_37;
    var phi_15155_: bool;
    var local_38: type_40;
    var phi_15161_: type_37;
    var phi_15162_: bool;
    var phi_15166_: type_37;
    var phi_15167_: type_37;
    var phi_15168_: bool;
    var phi_15172_: type_37;
    var phi_15173_: type_37;
    var phi_15174_: bool;
    var phi_15178_: type_37;
    var phi_15189_: bool;
    var phi_15190_: bool;
    var phi_15194_: bool;
    var phi_15198_: u32;
    var phi_1157_: type_16;
    var phi_1160_: f32;
    var phi_1181_: bool;
    var phi_1187_: type_17;
    var phi_1158_: type_16;
    var phi_1201_: type_17;
    var phi_1161_: f32;
    var local_39: f32;
    var phi_1150_: f32;
    var phi_1214_: f32;
    var phi_1230_: f32;
    var phi_1237_: f32;
    var phi_1242_: f32;
    var phi_1249_: f32;
    var phi_1254_: f32;
    var phi_1267_: f32;
    var phi_1274_: f32;
    var phi_1279_: f32;
    var phi_1286_: f32;
    var phi_1291_: f32;
    var phi_1296_: f32;
    var phi_1313_: f32;
    var phi_1320_: f32;
    var phi_1325_: f32;
    var phi_1332_: f32;
    var phi_1337_: f32;
    var phi_1351_: f32;
    var phi_1358_: f32;
    var phi_1363_: f32;
    var phi_1370_: f32;
    var phi_1375_: f32;
    var phi_1380_: f32;
    var phi_1397_: f32;
    var phi_1404_: f32;
    var phi_1409_: f32;
    var phi_1416_: f32;
    var phi_1421_: f32;
    var phi_1435_: f32;
    var phi_1442_: f32;
    var phi_1447_: f32;
    var phi_1454_: f32;
    var phi_1459_: f32;
    var phi_1464_: f32;
    var phi_1725_: f32;
    var phi_1732_: f32;
    var phi_1737_: f32;
    var phi_1744_: f32;
    var phi_1749_: f32;
    var phi_1762_: f32;
    var phi_1769_: f32;
    var phi_1774_: f32;
    var phi_1781_: f32;
    var phi_1786_: f32;
    var phi_1791_: f32;
    var phi_1808_: f32;
    var phi_1815_: f32;
    var phi_1820_: f32;
    var phi_1827_: f32;
    var phi_1832_: f32;
    var phi_1846_: f32;
    var phi_1853_: f32;
    var phi_1858_: f32;
    var phi_1865_: f32;
    var phi_1870_: f32;
    var phi_1875_: f32;
    var phi_1892_: f32;
    var phi_1899_: f32;
    var phi_1904_: f32;
    var phi_1911_: f32;
    var phi_1916_: f32;
    var phi_1930_: f32;
    var phi_1937_: f32;
    var phi_1942_: f32;
    var phi_1949_: f32;
    var phi_1954_: f32;
    var phi_1959_: f32;
    var phi_1990_: f32;
    var phi_1996_: f32;
    var phi_2003_: f32;
    var phi_2010_: f32;
    var phi_2016_: f32;
    var phi_2023_: f32;
    var phi_2029_: f32;
    var phi_2035_: f32;
    var phi_2041_: f32;
    var phi_2048_: f32;
    var phi_2055_: f32;
    var phi_2079_: f32;
    var phi_2084_: f32;
    var phi_2089_: f32;
    var phi_2094_: f32;
    var phi_2099_: f32;
    var phi_2104_: f32;
    var phi_2114_: f32;
    var phi_2123_: type_38;
    var phi_2124_: bool;
    var phi_2125_: type_38;
    var phi_2126_: bool;
    var phi_2132_: type_16;
    var phi_2135_: f32;
    var phi_2137_: u32;
    var phi_2139_: f32;
    var phi_2160_: bool;
    var phi_2166_: type_17;
    var phi_2133_: type_16;
    var phi_2180_: type_17;
    var phi_2195_: bool;
    var phi_2196_: bool;
    var phi_2255_: array<f32, 3>;
    var phi_2320_: array<f32, 3>;
    var phi_2342_: f32;
    var phi_2349_: f32;
    var phi_2354_: f32;
    var phi_2361_: f32;
    var phi_2366_: f32;
    var phi_2379_: f32;
    var phi_2386_: f32;
    var phi_2391_: f32;
    var phi_2398_: f32;
    var phi_2403_: f32;
    var phi_2408_: f32;
    var phi_2425_: f32;
    var phi_2432_: f32;
    var phi_2437_: f32;
    var phi_2444_: f32;
    var phi_2449_: f32;
    var phi_2463_: f32;
    var phi_2470_: f32;
    var phi_2475_: f32;
    var phi_2482_: f32;
    var phi_2487_: f32;
    var phi_2492_: f32;
    var phi_2509_: f32;
    var phi_2516_: f32;
    var phi_2521_: f32;
    var phi_2528_: f32;
    var phi_2533_: f32;
    var phi_2547_: f32;
    var phi_2554_: f32;
    var phi_2559_: f32;
    var phi_2566_: f32;
    var phi_2571_: f32;
    var phi_2576_: f32;
    var phi_2617_: type_9;
    var phi_2620_: f32;
    var phi_2622_: f32;
    var phi_2624_: f32;
    var phi_2626_: f32;
    var phi_2628_: bool;
    var phi_2630_: u32;
    var phi_2618_: type_9;
    var phi_2653_: type_9;
    var phi_2767_: f32;
    var phi_2773_: f32;
    var phi_2779_: f32;
    var phi_2781_: array<f32, 3>;
    var phi_2788_: f32;
    var phi_2795_: f32;
    var phi_2803_: f32;
    var phi_2847_: type_16;
    var phi_2850_: f32;
    var phi_2871_: bool;
    var phi_2877_: type_17;
    var phi_2848_: type_16;
    var phi_2891_: type_17;
    var phi_2851_: f32;
    var local_40: f32;
    var phi_2840_: f32;
    var phi_2904_: f32;
    var phi_2970_: f32;
    var phi_2976_: f32;
    var phi_2985_: f32;
    var phi_2991_: f32;
    var phi_3000_: f32;
    var phi_3006_: f32;
    var phi_3015_: f32;
    var phi_3021_: f32;
    var phi_3027_: type_31;
    var phi_3028_: bool;
    var phi_3029_: type_31;
    var phi_3030_: bool;
    var phi_3038_: type_31;
    var phi_3209_: bool;
    var phi_3210_: bool;
    var phi_3211_: bool;
    var phi_3212_: bool;
    var phi_3213_: bool;
    var phi_3214_: bool;
    var phi_3218_: bool;
    var phi_3515_: bool;
    var phi_3516_: bool;
    var phi_3517_: bool;
    var phi_3518_: bool;
    var phi_3519_: bool;
    var phi_3520_: bool;
    var phi_3524_: bool;
    var phi_3528_: bool;
    var phi_3539_: bool;
    var phi_3540_: bool;
    var phi_3614_: bool;
    var phi_3615_: bool;
    var phi_3635_: f32;
    var phi_3636_: bool;
    var phi_3637_: f32;
    var phi_3638_: bool;
    var phi_3639_: f32;
    var phi_3640_: bool;
    var phi_3641_: bool;
    var phi_3645_: f32;
    var phi_3646_: bool;
    var phi_3650_: f32;
    var phi_3682_: bool;
    var phi_3683_: bool;
    var phi_3703_: f32;
    var phi_3704_: bool;
    var phi_3705_: f32;
    var phi_3706_: bool;
    var phi_3707_: f32;
    var phi_3708_: bool;
    var phi_3709_: bool;
    var phi_3713_: f32;
    var phi_3714_: bool;
    var phi_3718_: f32;
    var phi_3723_: f32;
    var phi_3755_: bool;
    var phi_3756_: bool;
    var phi_3776_: f32;
    var phi_3777_: bool;
    var phi_3778_: f32;
    var phi_3779_: bool;
    var phi_3780_: f32;
    var phi_3781_: bool;
    var phi_3782_: bool;
    var phi_3786_: f32;
    var phi_3787_: bool;
    var phi_3791_: f32;
    var phi_3823_: bool;
    var phi_3824_: bool;
    var phi_3844_: f32;
    var phi_3845_: bool;
    var phi_3846_: f32;
    var phi_3847_: bool;
    var phi_3848_: f32;
    var phi_3849_: bool;
    var phi_3850_: bool;
    var phi_3854_: f32;
    var phi_3855_: bool;
    var phi_3859_: f32;
    var phi_3864_: f32;
    var phi_3869_: f32;
    var phi_3874_: f32;
    var phi_3887_: f32;
    var phi_4024_: type_16;
    var phi_4027_: f32;
    var phi_4048_: bool;
    var phi_4054_: type_17;
    var phi_4025_: type_16;
    var phi_4068_: type_17;
    var phi_4028_: f32;
    var local_41: f32;
    var phi_4017_: f32;
    var phi_4081_: f32;
    var phi_4097_: f32;
    var phi_4104_: f32;
    var phi_4109_: f32;
    var phi_4116_: f32;
    var phi_4121_: f32;
    var phi_4134_: f32;
    var phi_4141_: f32;
    var phi_4146_: f32;
    var phi_4153_: f32;
    var phi_4158_: f32;
    var phi_4163_: f32;
    var phi_4180_: f32;
    var phi_4187_: f32;
    var phi_4192_: f32;
    var phi_4199_: f32;
    var phi_4204_: f32;
    var phi_4218_: f32;
    var phi_4225_: f32;
    var phi_4230_: f32;
    var phi_4237_: f32;
    var phi_4242_: f32;
    var phi_4247_: f32;
    var phi_4264_: f32;
    var phi_4271_: f32;
    var phi_4276_: f32;
    var phi_4283_: f32;
    var phi_4288_: f32;
    var phi_4302_: f32;
    var phi_4309_: f32;
    var phi_4314_: f32;
    var phi_4321_: f32;
    var phi_4326_: f32;
    var phi_4331_: f32;
    var phi_4351_: bool;
    var phi_4352_: bool;
    var phi_4353_: bool;
    var phi_4368_: bool;
    var phi_4369_: bool;
    var phi_4374_: f32;
    var phi_4376_: f32;
    var phi_4377_: f32;
    var phi_4378_: bool;
    var phi_4379_: f32;
    var phi_4380_: f32;
    var phi_4381_: bool;
    var phi_4382_: bool;
    var phi_4383_: f32;
    var phi_4384_: f32;
    var phi_4385_: f32;
    var phi_4386_: f32;
    var phi_4387_: bool;
    var phi_4388_: bool;
    var phi_4389_: bool;
    var phi_4390_: bool;
    var phi_4391_: f32;
    var phi_4392_: f32;
    var phi_4393_: f32;
    var phi_4394_: f32;
    var phi_4395_: bool;
    var phi_4396_: bool;
    var phi_4397_: bool;
    var phi_4398_: bool;
    var phi_4399_: bool;
    var phi_4400_: f32;
    var phi_4401_: f32;
    var phi_4402_: f32;
    var phi_4403_: f32;
    var phi_4404_: bool;
    var phi_4405_: bool;
    var phi_4406_: bool;
    var phi_4407_: bool;
    var phi_4408_: bool;
    var phi_4494_: f32;
    var phi_4567_: f32;
    var phi_4572_: f32;
    var phi_4645_: f32;
    var phi_4718_: f32;
    var phi_4723_: f32;
    var phi_4739_: f32;
    var phi_4740_: f32;
    var phi_4741_: f32;
    var phi_4421_: bool;
    var phi_4743_: u32;
    var phi_4744_: f32;
    var phi_4745_: bool;
    var phi_4746_: bool;
    var phi_4747_: bool;
    var phi_4748_: u32;
    var phi_4749_: f32;
    var phi_4750_: f32;
    var phi_4751_: f32;
    var phi_4752_: f32;
    var phi_4753_: bool;
    var phi_4754_: u32;
    var phi_4755_: bool;
    var phi_4756_: bool;
    var phi_4757_: bool;
    var phi_4758_: bool;
    var phi_4759_: bool;
    var phi_4760_: bool;
    var phi_4769_: f32;
    var phi_4774_: f32;
    var phi_4783_: bool;
    var phi_4787_: bool;
    var phi_4788_: f32;
    var phi_4789_: f32;
    var phi_4790_: f32;
    var phi_4791_: f32;
    var phi_4792_: bool;
    var phi_4793_: u32;
    var phi_4794_: bool;
    var phi_4795_: bool;
    var phi_4796_: bool;
    var phi_4797_: bool;
    var phi_4798_: bool;
    var phi_4799_: bool;
    var phi_2621_: f32;
    var phi_2623_: f32;
    var phi_2625_: f32;
    var phi_2627_: f32;
    var phi_2629_: bool;
    var phi_2631_: u32;
    var phi_4800_: f32;
    var phi_4801_: f32;
    var phi_4802_: bool;
    var phi_4803_: bool;
    var phi_4804_: bool;
    var phi_4805_: bool;
    var phi_4806_: bool;
    var phi_4807_: bool;
    var phi_4808_: bool;
    var local_42: bool;
    var phi_4812_: bool;
    var phi_4813_: bool;
    var phi_4814_: bool;
    var phi_4815_: bool;
    var phi_4816_: bool;
    var local_43: f32;
    var phi_4821_: type_37;
    var phi_4822_: bool;
    var phi_4823_: bool;
    var phi_4824_: bool;
    var phi_4825_: bool;
    var phi_4826_: bool;
    var phi_4831_: type_37;
    var phi_4832_: bool;
    var phi_4833_: bool;
    var phi_4834_: bool;
    var phi_4835_: bool;
    var phi_4836_: bool;
    var phi_4840_: f32;
    var phi_4841_: bool;
    var phi_4842_: bool;
    var phi_4843_: bool;
    var phi_4844_: bool;
    var phi_4848_: f32;
    var phi_4849_: bool;
    var phi_4850_: bool;
    var phi_4851_: bool;
    var phi_4856_: type_37;
    var phi_4857_: bool;
    var phi_4858_: bool;
    var phi_4863_: type_37;
    var phi_4864_: bool;
    var phi_4868_: type_37;
    var phi_4875_: f32;
    var phi_4876_: bool;
    var phi_4988_: f32;
    var phi_4995_: f32;
    var phi_5003_: f32;
    var phi_5061_: array<f32, 3>;
    var phi_5129_: array<f32, 3>;
    var phi_5154_: f32;
    var phi_5161_: f32;
    var phi_5166_: f32;
    var phi_5173_: f32;
    var phi_5178_: f32;
    var phi_5191_: f32;
    var phi_5198_: f32;
    var phi_5203_: f32;
    var phi_5210_: f32;
    var phi_5215_: f32;
    var phi_5220_: f32;
    var phi_5237_: f32;
    var phi_5244_: f32;
    var phi_5249_: f32;
    var phi_5256_: f32;
    var phi_5261_: f32;
    var phi_5275_: f32;
    var phi_5282_: f32;
    var phi_5287_: f32;
    var phi_5294_: f32;
    var phi_5299_: f32;
    var phi_5304_: f32;
    var phi_5321_: f32;
    var phi_5328_: f32;
    var phi_5333_: f32;
    var phi_5340_: f32;
    var phi_5345_: f32;
    var phi_5359_: f32;
    var phi_5366_: f32;
    var phi_5371_: f32;
    var phi_5378_: f32;
    var phi_5383_: f32;
    var phi_5388_: f32;
    var phi_5496_: type_16;
    var phi_5499_: f32;
    var phi_5520_: bool;
    var phi_5526_: type_17;
    var phi_5497_: type_16;
    var phi_5540_: type_17;
    var phi_5500_: f32;
    var local_44: f32;
    var phi_5489_: f32;
    var phi_5553_: f32;
    var phi_5687_: f32;
    var phi_5693_: f32;
    var phi_5702_: f32;
    var phi_5708_: f32;
    var phi_5717_: f32;
    var phi_5723_: f32;
    var phi_5732_: f32;
    var phi_5738_: f32;
    var phi_5788_: type_16;
    var phi_5791_: f32;
    var phi_5812_: bool;
    var phi_5818_: type_17;
    var phi_5789_: type_16;
    var phi_5832_: type_17;
    var phi_5792_: f32;
    var local_45: f32;
    var phi_5781_: f32;
    var phi_5845_: f32;
    var phi_5877_: type_16;
    var phi_5880_: f32;
    var phi_5901_: bool;
    var phi_5907_: type_17;
    var phi_5878_: type_16;
    var phi_5921_: type_17;
    var phi_5881_: f32;
    var local_46: f32;
    var phi_5870_: f32;
    var phi_5934_: f32;
    var phi_5950_: f32;
    var phi_5957_: f32;
    var phi_5962_: f32;
    var phi_5969_: f32;
    var phi_5974_: f32;
    var phi_5987_: f32;
    var phi_5994_: f32;
    var phi_5999_: f32;
    var phi_6006_: f32;
    var phi_6011_: f32;
    var phi_6016_: f32;
    var phi_6033_: f32;
    var phi_6040_: f32;
    var phi_6045_: f32;
    var phi_6052_: f32;
    var phi_6057_: f32;
    var phi_6071_: f32;
    var phi_6078_: f32;
    var phi_6083_: f32;
    var phi_6090_: f32;
    var phi_6095_: f32;
    var phi_6100_: f32;
    var phi_6117_: f32;
    var phi_6124_: f32;
    var phi_6129_: f32;
    var phi_6136_: f32;
    var phi_6141_: f32;
    var phi_6155_: f32;
    var phi_6162_: f32;
    var phi_6167_: f32;
    var phi_6174_: f32;
    var phi_6179_: f32;
    var phi_6184_: f32;
    var phi_6225_: f32;
    var phi_6231_: f32;
    var phi_6242_: type_9;
    var phi_6245_: f32;
    var phi_6243_: type_9;
    var phi_6268_: type_9;
    var phi_6297_: f32;
    var phi_6303_: f32;
    var phi_6316_: f32;
    var phi_6246_: f32;
    var local_47: f32;
    var local_48: f32;
    var phi_6344_: type_16;
    var phi_6347_: f32;
    var phi_6368_: bool;
    var phi_6374_: type_17;
    var phi_6345_: type_16;
    var phi_6388_: type_17;
    var phi_6348_: f32;
    var local_49: f32;
    var phi_6337_: f32;
    var phi_6401_: f32;
    var phi_6406_: type_9;
    var phi_6409_: f32;
    var phi_6411_: bool;
    var phi_6413_: bool;
    var phi_6407_: type_9;
    var phi_6436_: type_9;
    var phi_6473_: f32;
    var phi_6480_: f32;
    var phi_6488_: f32;
    var phi_6496_: f32;
    var phi_6503_: f32;
    var phi_6511_: f32;
    var phi_6517_: f32;
    var phi_6535_: f32;
    var phi_6541_: f32;
    var phi_6548_: f32;
    var phi_6574_: f32;
    var phi_6580_: f32;
    var phi_6616_: bool;
    var phi_6623_: bool;
    var phi_6636_: f32;
    var phi_6642_: f32;
    var phi_6643_: f32;
    var phi_6644_: f32;
    var phi_6410_: f32;
    var phi_6412_: bool;
    var phi_6414_: bool;
    var local_50: f32;
    var phi_6649_: f32;
    var local_51: bool;
    var local_52: bool;
    var phi_6658_: type_39;
    var phi_6659_: type_39;
    var phi_6660_: bool;
    var local_53: bool;
    var phi_6677_: f32;
    var phi_6678_: f32;
    var phi_6681_: type_9;
    var phi_6684_: f32;
    var phi_6686_: f32;
    var phi_6682_: type_9;
    var phi_6709_: type_9;
    var phi_6792_: f32;
    var phi_6793_: f32;
    var phi_6794_: f32;
    var phi_6777_: f32;
    var phi_6795_: f32;
    var phi_6796_: f32;
    var phi_6685_: f32;
    var phi_6687_: f32;
    var local_54: f32;
    var local_55: f32;
    var local_56: f32;
    var phi_6957_: bool;
    var phi_6958_: bool;
    var phi_6959_: bool;
    var phi_6960_: bool;
    var phi_6961_: bool;
    var phi_6962_: bool;
    var phi_6966_: bool;
    var phi_6970_: bool;
    var phi_6971_: bool;
    var phi_6972_: bool;
    var phi_6976_: f32;
    var phi_6979_: type_39;
    var phi_6980_: type_39;
    var phi_6981_: bool;
    var phi_6982_: type_39;
    var phi_6983_: type_39;
    var phi_6984_: bool;
    var phi_6989_: type_39;
    var phi_6990_: type_39;
    var phi_6991_: bool;
    var phi_6995_: type_39;
    var phi_6996_: type_39;
    var phi_6997_: bool;
    var phi_6998_: bool;
    var phi_6999_: type_39;
    var phi_7000_: type_39;
    var phi_7001_: bool;
    var phi_7002_: bool;
    var phi_7007_: type_39;
    var phi_7008_: bool;
    var phi_7012_: type_39;
    var phi_7028_: f32;
    var phi_7029_: f32;
    var phi_7030_: bool;
    var phi_7031_: f32;
    var phi_7032_: f32;
    var phi_7033_: bool;
    var phi_7034_: bool;
    var phi_7035_: bool;
    var phi_7036_: f32;
    var phi_7037_: f32;
    var phi_7038_: bool;
    var phi_7039_: bool;
    var phi_7040_: bool;
    var phi_7041_: f32;
    var phi_7042_: u32;
    var phi_7043_: f32;
    var phi_7044_: type_39;
    var phi_7045_: u32;
    var phi_7046_: u32;
    var phi_7047_: bool;
    var phi_7048_: bool;
    var phi_7049_: bool;
    var phi_7050_: f32;
    var phi_7051_: u32;
    var phi_7052_: f32;
    var phi_7053_: type_39;
    var phi_7054_: u32;
    var phi_7055_: u32;
    var phi_7056_: bool;
    var phi_7057_: bool;
    var phi_7058_: bool;
    var phi_7059_: bool;
    var phi_7060_: bool;
    var phi_7061_: f32;
    var phi_2136_: f32;
    var phi_2138_: u32;
    var phi_2140_: f32;
    var phi_7062_: type_39;
    var phi_7063_: u32;
    var phi_7064_: f32;
    var phi_7065_: u32;
    var phi_7066_: bool;
    var phi_7067_: bool;
    var phi_7068_: bool;
    var phi_7069_: bool;
    var phi_7070_: bool;
    var phi_7071_: bool;
    var local_57: bool;
    var phi_7075_: bool;
    var phi_7076_: bool;
    var phi_7077_: bool;
    var phi_7078_: bool;
    var local_58: type_39;
    var local_59: type_39;
    var phi_7095_: u32;
    var local_60: type_39;
    var phi_7100_: type_38;
    var phi_7101_: type_38;
    var phi_7102_: bool;
    var phi_7103_: bool;
    var phi_7104_: bool;
    var phi_7105_: bool;
    var phi_7109_: u32;
    var phi_7110_: f32;
    var phi_7111_: bool;
    var phi_7112_: bool;
    var phi_7113_: bool;
    var phi_7114_: bool;
    var phi_7118_: f32;
    var phi_7119_: u32;
    var phi_7120_: bool;
    var phi_7121_: bool;
    var phi_7122_: bool;
    var phi_7134_: f32;
    var phi_7137_: type_9;
    var phi_7138_: type_9;
    var phi_7161_: type_9;
    var phi_7182_: f32;
    var phi_7312_: type_16;
    var phi_7315_: f32;
    var phi_7336_: bool;
    var phi_7342_: type_17;
    var phi_7313_: type_16;
    var phi_7356_: type_17;
    var phi_7316_: f32;
    var local_61: f32;
    var phi_7305_: f32;
    var phi_7369_: f32;
    var phi_7385_: f32;
    var phi_7392_: f32;
    var phi_7397_: f32;
    var phi_7404_: f32;
    var phi_7409_: f32;
    var phi_7422_: f32;
    var phi_7429_: f32;
    var phi_7434_: f32;
    var phi_7441_: f32;
    var phi_7446_: f32;
    var phi_7451_: f32;
    var phi_7468_: f32;
    var phi_7475_: f32;
    var phi_7480_: f32;
    var phi_7487_: f32;
    var phi_7492_: f32;
    var phi_7506_: f32;
    var phi_7513_: f32;
    var phi_7518_: f32;
    var phi_7525_: f32;
    var phi_7530_: f32;
    var phi_7535_: f32;
    var phi_7552_: f32;
    var phi_7559_: f32;
    var phi_7564_: f32;
    var phi_7571_: f32;
    var phi_7576_: f32;
    var phi_7590_: f32;
    var phi_7597_: f32;
    var phi_7602_: f32;
    var phi_7609_: f32;
    var phi_7614_: f32;
    var phi_7619_: f32;
    var phi_7639_: bool;
    var phi_7640_: bool;
    var phi_7641_: bool;
    var local_62: bool;
    var phi_7649_: u32;
    var phi_7653_: type_38;
    var phi_7654_: bool;
    var phi_7662_: u32;
    var phi_7666_: type_38;
    var phi_7667_: type_38;
    var phi_7668_: bool;
    var phi_7669_: bool;
    var phi_7676_: type_38;
    var phi_7677_: bool;
    var phi_7681_: type_38;
    var phi_7682_: type_38;
    var phi_7683_: bool;
    var phi_7687_: type_38;
    var phi_15202_: type_38;
    var phi_15217_: type_30;
    var phi_15233_: array<u32, 2>;
    var phi_15254_: array<u32, 2>;
    var phi_15257_: bool;
    var phi_15272_: bool;
    var phi_15273_: bool;
    var phi_15281_: bool;
    var phi_15282_: bool;
    var phi_15287_: u32;
    var phi_15295_: bool;
    var phi_15316_: u32;
    var phi_15320_: type_22;
    var phi_15321_: bool;
    var phi_15322_: bool;
    var phi_15341_: u32;
    var phi_15408_: u32;
    var local_63: u32;
    var local_64: f32;
    var local_65: f32;
    var local_66: bool;
    var local_67: bool;
    var local_68: f32;
    var local_69: bool;
    var local_70: bool;
    var local_71: bool;
    var local_72: bool;
    var local_73: bool;
    var local_74: f32;
    var local_75: f32;
    var local_76: bool;
    var local_77: bool;
    var local_78: bool;
    var local_79: bool;
    var local_80: bool;
    var local_81: bool;
    var local_82: bool;
    var local_83: bool;
    var local_84: f32;
    var local_85: f32;
    var local_86: f32;
    var local_87: f32;
    var local_88: bool;
    var local_89: bool;
    var local_90: bool;
    var local_91: bool;
    var local_92: bool;
    var local_93: u32;
    var local_94: bool;
    var local_95: u32;
    var local_96: u32;
    var local_97: f32;
    var local_98: f32;
    var local_99: f32;
    var local_100: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e119 = id_2;
    let _e120 = n_2;
    let _e121 = lane_2;
    let _e133 = ((_e119.y * _e120.x) + _e119.x);
    let _e136 = (_e120.x * _e120.y);
    let _e139 = params.member.member_1.member_2;
    let _e141 = input.member[0u];
    if (_e139 < _e141) {
        phi_246_ = _e139;
    } else {
        phi_246_ = _e141;
    }
    let _e144 = phi_246_;
    let _e146 = params.member.member_1.member_1;
    if (_e144 > _e146) {
        let _e149 = params.member.member_1.member_1;
        phi_256_ = (_e144 - _e149);
    } else {
        phi_256_ = 0u;
    }
    let _e152 = phi_256_;
    let _e154 = params.member.member_1.member;
    if (_e154 < _e152) {
        phi_263_ = _e154;
    } else {
        phi_263_ = _e152;
    }
    let _e157 = phi_263_;
    let _e158 = (_e157 / 64u);
    if ((_e157 % 64u) > 0u) {
        phi_279_ = (_e158 + 1u);
    } else {
        phi_279_ = _e158;
    }
    let _e163 = phi_279_;
    if (_e163 > _e133) {
        let _e165 = (_e163 - _e133);
        if (_e136 == 0u) {
            return;
        }
        let _e167 = (_e165 / _e136);
        if (_e136 == 0u) {
            return;
        }
        if ((_e165 % _e136) > 0u) {
            phi_300_ = (_e167 + 1u);
        } else {
            phi_300_ = _e167;
        }
        let _e173 = phi_300_;
        phi_301_ = _e173;
    } else {
        phi_301_ = 0u;
    }
    let _e175 = phi_301_;
    phi_304_ = type_9(0u, _e175);
    loop {
        let _e178 = phi_304_;
        if (_e178.member < _e178.member_1) {
            phi_305_ = type_9((_e178.member + 1u), _e178.member_1);
            phi_328_ = type_9(1u, _e178.member);
        } else {
            phi_305_ = _e178;
            phi_328_ = type_9(0u, type_9().member_1);
        }
        let _e190 = phi_305_;
        let _e192 = phi_328_;
        let _e196 = (bitcast<i32>(_e192.member) != 0i);
        if _e196 {
            let _e200 = (((_e133 + (_e192.member_1 * _e136)) * 64u) + _e121);
            let _e203 = params.member.member_2.member;
            if (_e200 < _e157) {
                let _e208 = params.member.member_1.member_1;
                let _e210 = (2u * (_e208 + _e200));
                let _e213 = input.member[(4u + _e210)];
                let _e216 = input.member[(_e210 + 5u)];
                if (_e203 == 0u) {
                    let _e233 = (3u * _e216);
                    let _e235 = elements.member[_e233];
                    let _e238 = elements.member[(_e233 + 1u)];
                    let _e241 = elements.member[(_e233 + 2u)];
                    phi_461_ = type_27(0u, array<u32, 4>(_e213, _e235, _e238, _e241));
                } else {
                    let _e219 = (2u * _e213);
                    let _e220 = (2u * _e216);
                    let _e222 = elements.member[_e219];
                    let _e224 = elements.member[_e220];
                    let _e227 = elements.member[(_e219 + 1u)];
                    let _e230 = elements.member[(_e220 + 1u)];
                    phi_461_ = type_27(1u, array<u32, 4>(_e222, _e227, _e224, _e230));
                }
                let _e245 = phi_461_;
                let _e250 = paths.member[_e245.member_1[0]];
                let _e253 = paths.member[_e245.member_1[1]];
                let _e260 = paths.member[_e245.member_1[2]];
                let _e263 = paths.member[_e245.member_1[3]];
                let _e293 = params.member.member.member_4;
                if (_e245.member != 0u) {
                    phi_604_ = type_25(array<array<f32, 3>, 2>(array<f32, 3>((_e260.member[0] - _e250.member[0]), (_e260.member[1] - _e250.member[1]), (_e260.member[2] - _e250.member[2])), array<f32, 3>((_e260.member_1[0] - _e250.member_1[0]), (_e260.member_1[1] - _e250.member_1[1]), (_e260.member_1[2] - _e250.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e253.member[0] - _e250.member[0]), (_e253.member[1] - _e250.member[1]), (_e253.member[2] - _e250.member[2])), array<f32, 3>((_e253.member_1[0] - _e250.member_1[0]), (_e253.member_1[1] - _e250.member_1[1]), (_e253.member_1[2] - _e250.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e260.member[0] - _e263.member[0]), (_e260.member[1] - _e263.member[1]), (_e260.member[2] - _e263.member[2])), array<f32, 3>((_e260.member_1[0] - _e263.member_1[0]), (_e260.member_1[1] - _e263.member_1[1]), (_e260.member_1[2] - _e263.member_1[2]))), (_e293 + _e293));
                } else {
                    phi_604_ = type_25(array<array<f32, 3>, 2>(array<f32, 3>((_e250.member[0] - _e253.member[0]), (_e250.member[1] - _e253.member[1]), (_e250.member[2] - _e253.member[2])), array<f32, 3>((_e250.member_1[0] - _e253.member_1[0]), (_e250.member_1[1] - _e253.member_1[1]), (_e250.member_1[2] - _e253.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e260.member[0] - _e253.member[0]), (_e260.member[1] - _e253.member[1]), (_e260.member[2] - _e253.member[2])), array<f32, 3>((_e260.member_1[0] - _e253.member_1[0]), (_e260.member_1[1] - _e253.member_1[1]), (_e260.member_1[2] - _e253.member_1[2]))), array<array<f32, 3>, 2>(array<f32, 3>((_e263.member[0] - _e253.member[0]), (_e263.member[1] - _e253.member[1]), (_e263.member[2] - _e253.member[2])), array<f32, 3>((_e263.member_1[0] - _e253.member_1[0]), (_e263.member_1[1] - _e253.member_1[1]), (_e263.member_1[2] - _e253.member_1[2]))), (_e293 + _e293));
                }
                let _e354 = phi_604_;
                let _e356 = params.member.member.member_12;
                let _e357 = bitcast<u32>(_e356);
                let _e358 = (_e357 & 2147483647u);
                if (_e358 < 8388608u) {
                    phi_619_ = array<u32, 2>(0u, 0u);
                } else {
                    phi_619_ = array<u32, 2>((_e357 << bitcast<u32>(29i)), ((_e357 ^ _e358) | ((_e358 >> bitcast<u32>(3i)) + 939524096u)));
                }
                let _e369 = phi_619_;
                let _e373 = params.member.member.member_15[0u];
                if (_e369[0] == _e373) {
                    let _e378 = params.member.member.member_15[1u];
                    phi_633_ = (_e369[1] == _e378);
                } else {
                    phi_633_ = false;
                }
                let _e381 = phi_633_;
                let _e383 = params.member.member.member_5;
                let _e385 = params.member.member.member_11;
                let _e387 = params.member.member.member_12;
                let _e389 = params.member.member.member_13;
                let _e391 = params.member.member.member_1;
                if ((_e391 & 64u) != 0u) {
                    phi_649_ = _e381;
                } else {
                    phi_649_ = false;
                }
                let _e395 = phi_649_;
                if (_e354.member[0][0] < 0f) {
                    phi_657_ = -(_e354.member[0][0]);
                } else {
                    phi_657_ = _e354.member[0][0];
                }
                let _e402 = phi_657_;
                if (_e354.member[0][1] < 0f) {
                    phi_664_ = -(_e354.member[0][1]);
                } else {
                    phi_664_ = _e354.member[0][1];
                }
                let _e407 = phi_664_;
                if (_e402 > _e407) {
                    phi_669_ = _e402;
                } else {
                    phi_669_ = _e407;
                }
                let _e410 = phi_669_;
                if (_e354.member[0][2] < 0f) {
                    phi_676_ = -(_e354.member[0][2]);
                } else {
                    phi_676_ = _e354.member[0][2];
                }
                let _e415 = phi_676_;
                if (_e410 > _e415) {
                    phi_681_ = _e410;
                } else {
                    phi_681_ = _e415;
                }
                let _e418 = phi_681_;
                if (_e354.member[1][0] < 0f) {
                    phi_689_ = -(_e354.member[1][0]);
                } else {
                    phi_689_ = _e354.member[1][0];
                }
                let _e425 = phi_689_;
                if (_e354.member[1][1] < 0f) {
                    phi_696_ = -(_e354.member[1][1]);
                } else {
                    phi_696_ = _e354.member[1][1];
                }
                let _e430 = phi_696_;
                if (_e425 > _e430) {
                    phi_701_ = _e425;
                } else {
                    phi_701_ = _e430;
                }
                let _e433 = phi_701_;
                if (_e354.member[1][2] < 0f) {
                    phi_708_ = -(_e354.member[1][2]);
                } else {
                    phi_708_ = _e354.member[1][2];
                }
                let _e438 = phi_708_;
                if (_e433 > _e438) {
                    phi_713_ = _e433;
                } else {
                    phi_713_ = _e438;
                }
                let _e441 = phi_713_;
                if (_e418 > _e441) {
                    phi_718_ = _e418;
                } else {
                    phi_718_ = _e441;
                }
                let _e444 = phi_718_;
                let _e446 = (_e444 + _e354.member_3);
                if (_e354.member_1[0][0] < 0f) {
                    phi_728_ = -(_e354.member_1[0][0]);
                } else {
                    phi_728_ = _e354.member_1[0][0];
                }
                let _e453 = phi_728_;
                if (_e354.member_1[0][1] < 0f) {
                    phi_735_ = -(_e354.member_1[0][1]);
                } else {
                    phi_735_ = _e354.member_1[0][1];
                }
                let _e458 = phi_735_;
                if (_e453 > _e458) {
                    phi_740_ = _e453;
                } else {
                    phi_740_ = _e458;
                }
                let _e461 = phi_740_;
                if (_e354.member_1[0][2] < 0f) {
                    phi_747_ = -(_e354.member_1[0][2]);
                } else {
                    phi_747_ = _e354.member_1[0][2];
                }
                let _e466 = phi_747_;
                if (_e461 > _e466) {
                    phi_752_ = _e461;
                } else {
                    phi_752_ = _e466;
                }
                let _e469 = phi_752_;
                if (_e354.member_1[1][0] < 0f) {
                    phi_760_ = -(_e354.member_1[1][0]);
                } else {
                    phi_760_ = _e354.member_1[1][0];
                }
                let _e476 = phi_760_;
                if (_e354.member_1[1][1] < 0f) {
                    phi_767_ = -(_e354.member_1[1][1]);
                } else {
                    phi_767_ = _e354.member_1[1][1];
                }
                let _e481 = phi_767_;
                if (_e476 > _e481) {
                    phi_772_ = _e476;
                } else {
                    phi_772_ = _e481;
                }
                let _e484 = phi_772_;
                if (_e354.member_1[1][2] < 0f) {
                    phi_779_ = -(_e354.member_1[1][2]);
                } else {
                    phi_779_ = _e354.member_1[1][2];
                }
                let _e489 = phi_779_;
                if (_e484 > _e489) {
                    phi_784_ = _e484;
                } else {
                    phi_784_ = _e489;
                }
                let _e492 = phi_784_;
                if (_e469 > _e492) {
                    phi_789_ = _e469;
                } else {
                    phi_789_ = _e492;
                }
                let _e495 = phi_789_;
                let _e497 = (_e495 + _e354.member_3);
                if (_e354.member_2[0][0] < 0f) {
                    phi_799_ = -(_e354.member_2[0][0]);
                } else {
                    phi_799_ = _e354.member_2[0][0];
                }
                let _e504 = phi_799_;
                if (_e354.member_2[0][1] < 0f) {
                    phi_806_ = -(_e354.member_2[0][1]);
                } else {
                    phi_806_ = _e354.member_2[0][1];
                }
                let _e509 = phi_806_;
                if (_e504 > _e509) {
                    phi_811_ = _e504;
                } else {
                    phi_811_ = _e509;
                }
                let _e512 = phi_811_;
                if (_e354.member_2[0][2] < 0f) {
                    phi_818_ = -(_e354.member_2[0][2]);
                } else {
                    phi_818_ = _e354.member_2[0][2];
                }
                let _e517 = phi_818_;
                if (_e512 > _e517) {
                    phi_823_ = _e512;
                } else {
                    phi_823_ = _e517;
                }
                let _e520 = phi_823_;
                if (_e354.member_2[1][0] < 0f) {
                    phi_831_ = -(_e354.member_2[1][0]);
                } else {
                    phi_831_ = _e354.member_2[1][0];
                }
                let _e527 = phi_831_;
                if (_e354.member_2[1][1] < 0f) {
                    phi_838_ = -(_e354.member_2[1][1]);
                } else {
                    phi_838_ = _e354.member_2[1][1];
                }
                let _e532 = phi_838_;
                if (_e527 > _e532) {
                    phi_843_ = _e527;
                } else {
                    phi_843_ = _e532;
                }
                let _e535 = phi_843_;
                if (_e354.member_2[1][2] < 0f) {
                    phi_850_ = -(_e354.member_2[1][2]);
                } else {
                    phi_850_ = _e354.member_2[1][2];
                }
                let _e540 = phi_850_;
                if (_e535 > _e540) {
                    phi_855_ = _e535;
                } else {
                    phi_855_ = _e540;
                }
                let _e543 = phi_855_;
                if (_e520 > _e543) {
                    phi_860_ = _e520;
                } else {
                    phi_860_ = _e543;
                }
                let _e546 = phi_860_;
                let _e548 = (_e546 + _e354.member_3);
                if (_e446 > _e497) {
                    phi_867_ = _e446;
                } else {
                    phi_867_ = _e497;
                }
                let _e551 = phi_867_;
                if (_e551 > _e548) {
                    phi_872_ = _e551;
                } else {
                    phi_872_ = _e548;
                }
                let _e554 = phi_872_;
                if (_e554 <= 65536f) {
                    phi_879_ = (_e554 >= (1f / 65536f));
                } else {
                    phi_879_ = false;
                }
                let _e559 = phi_879_;
                if _e559 {
                    phi_977_ = type_36();
                    phi_978_ = true;
                } else {
                    if (_e554 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e554) & 2139095040u) != 2139095040u) {
                            let _e566 = (2130706432u - (bitcast<u32>(_e554) & 2139095040u));
                            if (_e566 > 8388608u) {
                                phi_903_ = _e566;
                            } else {
                                phi_903_ = 8388608u;
                            }
                            let _e569 = phi_903_;
                            let _e570 = bitcast<f32>(_e569);
                            let _e571 = (_e383 * _e570);
                            if (_e383 > 0f) {
                                if (_e571 > 0.000000000000000000000000000000000000011754944f) {
                                    phi_914_ = _e571;
                                } else {
                                    phi_914_ = 0.000000000000000000000000000000000000011754944f;
                                }
                                let _e575 = phi_914_;
                                phi_915_ = _e575;
                            } else {
                                phi_915_ = _e571;
                            }
                            let _e577 = phi_915_;
                            phi_973_ = type_36(type_25(array<array<f32, 3>, 2>(array<f32, 3>((_e354.member[0][0] * _e570), (_e354.member[0][1] * _e570), (_e354.member[0][2] * _e570)), array<f32, 3>((_e354.member[1][0] * _e570), (_e354.member[1][1] * _e570), (_e354.member[1][2] * _e570))), array<array<f32, 3>, 2>(array<f32, 3>((_e354.member_1[0][0] * _e570), (_e354.member_1[0][1] * _e570), (_e354.member_1[0][2] * _e570)), array<f32, 3>((_e354.member_1[1][0] * _e570), (_e354.member_1[1][1] * _e570), (_e354.member_1[1][2] * _e570))), array<array<f32, 3>, 2>(array<f32, 3>((_e354.member_2[0][0] * _e570), (_e354.member_2[0][1] * _e570), (_e354.member_2[0][2] * _e570)), array<f32, 3>((_e354.member_2[1][0] * _e570), (_e354.member_2[1][1] * _e570), (_e354.member_2[1][2] * _e570))), ((_e354.member_3 + (0.000000000000000000000000000000000000011754944f * 8f)) * _e570)), _e577);
                            phi_974_ = false;
                        } else {
                            phi_973_ = type_36();
                            phi_974_ = true;
                        }
                        let _e642 = phi_973_;
                        let _e644 = phi_974_;
                        phi_975_ = _e642;
                        phi_976_ = _e644;
                    } else {
                        phi_975_ = type_36();
                        phi_976_ = true;
                    }
                    let _e646 = phi_975_;
                    let _e648 = phi_976_;
                    phi_977_ = _e646;
                    phi_978_ = _e648;
                }
                let _e650 = phi_977_;
                let _e652 = phi_978_;
                if _e652 {
                    phi_983_ = type_36(_e354, _e383);
                } else {
                    phi_983_ = _e650;
                }
                let _e655 = phi_983_;
                local_18 = type_25(array<array<f32, 3>, 2>(array<f32, 3>(_e655.member.member[0][0], _e655.member.member[0][1], _e655.member.member[0][2]), array<f32, 3>(_e655.member.member[1][0], _e655.member.member[1][1], _e655.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e655.member.member_1[0][0], _e655.member.member_1[0][1], _e655.member.member_1[0][2]), array<f32, 3>(_e655.member.member_1[1][0], _e655.member.member_1[1][1], _e655.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e655.member.member_2[0][0], _e655.member.member_2[0][1], _e655.member.member_2[0][2]), array<f32, 3>(_e655.member.member_2[1][0], _e655.member.member_2[1][1], _e655.member.member_2[1][2])), _e655.member.member_3);
                if (_e655.member_1 > 0f) {
                    let _e5420 = local_18.member[0u];
                    let _e5426 = local_18.member[1u];
                    let _e5442 = local_18.member_1[0u];
                    let _e5448 = local_18.member_1[1u];
                    let _e5464 = local_18.member_2[0u];
                    let _e5470 = local_18.member_2[1u];
                    let _e5484 = function_3(array<f32, 3>((_e5420[0] + ((_e5426[0] - _e5420[0]) * _e387)), (_e5420[1] + ((_e5426[1] - _e5420[1]) * _e387)), (_e5420[2] + ((_e5426[2] - _e5420[2]) * _e387))), array<f32, 3>((_e5442[0] + ((_e5448[0] - _e5442[0]) * _e387)), (_e5442[1] + ((_e5448[1] - _e5442[1]) * _e387)), (_e5442[2] + ((_e5448[2] - _e5442[2]) * _e387))), array<f32, 3>((_e5464[0] + ((_e5470[0] - _e5464[0]) * _e387)), (_e5464[1] + ((_e5470[1] - _e5464[1]) * _e387)), (_e5464[2] + ((_e5470[2] - _e5464[2]) * _e387))), _e245.member);
                    let _e5495 = (((_e5484[0] * _e5484[0]) + (_e5484[1] * _e5484[1])) + (_e5484[2] * _e5484[2]));
                    if (_e5495 <= 0.000000000000000000000000000000000000011754944f) {
                        if (_e5495 > 0f) {
                            phi_1150_ = (0.000000000000000000106433627f * 2f);
                        } else {
                            phi_1150_ = 0f;
                        }
                        let _e5548 = phi_1150_;
                        phi_1214_ = _e5548;
                    } else {
                        phi_1157_ = type_16(0i, 5i);
                        phi_1160_ = bitcast<f32>(((bitcast<u32>(_e5495) >> bitcast<u32>(1i)) + 532369198u));
                        loop {
                            let _e5503 = phi_1157_;
                            let _e5505 = phi_1160_;
                            local_39 = _e5505;
                            if (_e5503.member < _e5503.member_1) {
                                let _e5512 = (_e5503.member + 1i);
                                if ((false == (_e5512 > _e5503.member)) != false) {
                                    phi_1181_ = true;
                                } else {
                                    phi_1181_ = false;
                                }
                                let _e5517 = phi_1181_;
                                if _e5517 {
                                    phi_1187_ = type_17(0u, type_17().member_1);
                                } else {
                                    phi_1187_ = type_17(1u, _e5512);
                                }
                                let _e5522 = phi_1187_;
                                phi_1158_ = type_16(_e5522.member_1, _e5503.member_1);
                                phi_1201_ = type_17(1u, _e5503.member);
                            } else {
                                phi_1158_ = _e5503;
                                phi_1201_ = type_17(0u, type_17().member_1);
                            }
                            let _e5528 = phi_1158_;
                            let _e5530 = phi_1201_;
                            let _e5533 = (bitcast<i32>(_e5530.member) != 0i);
                            if _e5533 {
                                phi_1161_ = (0.5f * (_e5505 + (_e5495 / _e5505)));
                            } else {
                                phi_1161_ = f32();
                            }
                            let _e5538 = phi_1161_;
                            continue;
                            continuing {
                                phi_1157_ = _e5528;
                                phi_1160_ = _e5538;
                                break if !(_e5533);
                            }
                        }
                        let _e5543 = local_39;
                        phi_1214_ = (_e5543 * (1f + (8f * 0.000000059604645f)));
                    }
                    let _e5550 = phi_1214_;
                    let _e5556 = local_18.member[0u];
                    if (_e5556[0] < 0f) {
                        phi_1230_ = -(_e5556[0]);
                    } else {
                        phi_1230_ = _e5556[0];
                    }
                    let _e5563 = phi_1230_;
                    if (_e5556[1] < 0f) {
                        phi_1237_ = -(_e5556[1]);
                    } else {
                        phi_1237_ = _e5556[1];
                    }
                    let _e5567 = phi_1237_;
                    if (_e5563 > _e5567) {
                        phi_1242_ = _e5563;
                    } else {
                        phi_1242_ = _e5567;
                    }
                    let _e5570 = phi_1242_;
                    if (_e5556[2] < 0f) {
                        phi_1249_ = -(_e5556[2]);
                    } else {
                        phi_1249_ = _e5556[2];
                    }
                    let _e5574 = phi_1249_;
                    if (_e5570 > _e5574) {
                        phi_1254_ = _e5570;
                    } else {
                        phi_1254_ = _e5574;
                    }
                    let _e5577 = phi_1254_;
                    let _e5580 = local_18.member[1u];
                    if (_e5580[0] < 0f) {
                        phi_1267_ = -(_e5580[0]);
                    } else {
                        phi_1267_ = _e5580[0];
                    }
                    let _e5587 = phi_1267_;
                    if (_e5580[1] < 0f) {
                        phi_1274_ = -(_e5580[1]);
                    } else {
                        phi_1274_ = _e5580[1];
                    }
                    let _e5591 = phi_1274_;
                    if (_e5587 > _e5591) {
                        phi_1279_ = _e5587;
                    } else {
                        phi_1279_ = _e5591;
                    }
                    let _e5594 = phi_1279_;
                    if (_e5580[2] < 0f) {
                        phi_1286_ = -(_e5580[2]);
                    } else {
                        phi_1286_ = _e5580[2];
                    }
                    let _e5598 = phi_1286_;
                    if (_e5594 > _e5598) {
                        phi_1291_ = _e5594;
                    } else {
                        phi_1291_ = _e5598;
                    }
                    let _e5601 = phi_1291_;
                    if (_e5577 > _e5601) {
                        phi_1296_ = _e5577;
                    } else {
                        phi_1296_ = _e5601;
                    }
                    let _e5604 = phi_1296_;
                    let _e5606 = local_18.member_3;
                    let _e5610 = local_18.member_1[0u];
                    if (_e5610[0] < 0f) {
                        phi_1313_ = -(_e5610[0]);
                    } else {
                        phi_1313_ = _e5610[0];
                    }
                    let _e5617 = phi_1313_;
                    if (_e5610[1] < 0f) {
                        phi_1320_ = -(_e5610[1]);
                    } else {
                        phi_1320_ = _e5610[1];
                    }
                    let _e5621 = phi_1320_;
                    if (_e5617 > _e5621) {
                        phi_1325_ = _e5617;
                    } else {
                        phi_1325_ = _e5621;
                    }
                    let _e5624 = phi_1325_;
                    if (_e5610[2] < 0f) {
                        phi_1332_ = -(_e5610[2]);
                    } else {
                        phi_1332_ = _e5610[2];
                    }
                    let _e5628 = phi_1332_;
                    if (_e5624 > _e5628) {
                        phi_1337_ = _e5624;
                    } else {
                        phi_1337_ = _e5628;
                    }
                    let _e5631 = phi_1337_;
                    let _e5634 = local_18.member_1[1u];
                    if (_e5634[0] < 0f) {
                        phi_1351_ = -(_e5634[0]);
                    } else {
                        phi_1351_ = _e5634[0];
                    }
                    let _e5641 = phi_1351_;
                    if (_e5634[1] < 0f) {
                        phi_1358_ = -(_e5634[1]);
                    } else {
                        phi_1358_ = _e5634[1];
                    }
                    let _e5645 = phi_1358_;
                    if (_e5641 > _e5645) {
                        phi_1363_ = _e5641;
                    } else {
                        phi_1363_ = _e5645;
                    }
                    let _e5648 = phi_1363_;
                    if (_e5634[2] < 0f) {
                        phi_1370_ = -(_e5634[2]);
                    } else {
                        phi_1370_ = _e5634[2];
                    }
                    let _e5652 = phi_1370_;
                    if (_e5648 > _e5652) {
                        phi_1375_ = _e5648;
                    } else {
                        phi_1375_ = _e5652;
                    }
                    let _e5655 = phi_1375_;
                    if (_e5631 > _e5655) {
                        phi_1380_ = _e5631;
                    } else {
                        phi_1380_ = _e5655;
                    }
                    let _e5658 = phi_1380_;
                    let _e5660 = local_18.member_3;
                    let _e5664 = local_18.member_2[0u];
                    if (_e5664[0] < 0f) {
                        phi_1397_ = -(_e5664[0]);
                    } else {
                        phi_1397_ = _e5664[0];
                    }
                    let _e5671 = phi_1397_;
                    if (_e5664[1] < 0f) {
                        phi_1404_ = -(_e5664[1]);
                    } else {
                        phi_1404_ = _e5664[1];
                    }
                    let _e5675 = phi_1404_;
                    if (_e5671 > _e5675) {
                        phi_1409_ = _e5671;
                    } else {
                        phi_1409_ = _e5675;
                    }
                    let _e5678 = phi_1409_;
                    if (_e5664[2] < 0f) {
                        phi_1416_ = -(_e5664[2]);
                    } else {
                        phi_1416_ = _e5664[2];
                    }
                    let _e5682 = phi_1416_;
                    if (_e5678 > _e5682) {
                        phi_1421_ = _e5678;
                    } else {
                        phi_1421_ = _e5682;
                    }
                    let _e5685 = phi_1421_;
                    let _e5688 = local_18.member_2[1u];
                    if (_e5688[0] < 0f) {
                        phi_1435_ = -(_e5688[0]);
                    } else {
                        phi_1435_ = _e5688[0];
                    }
                    let _e5695 = phi_1435_;
                    if (_e5688[1] < 0f) {
                        phi_1442_ = -(_e5688[1]);
                    } else {
                        phi_1442_ = _e5688[1];
                    }
                    let _e5699 = phi_1442_;
                    if (_e5695 > _e5699) {
                        phi_1447_ = _e5695;
                    } else {
                        phi_1447_ = _e5699;
                    }
                    let _e5702 = phi_1447_;
                    if (_e5688[2] < 0f) {
                        phi_1454_ = -(_e5688[2]);
                    } else {
                        phi_1454_ = _e5688[2];
                    }
                    let _e5706 = phi_1454_;
                    if (_e5702 > _e5706) {
                        phi_1459_ = _e5702;
                    } else {
                        phi_1459_ = _e5706;
                    }
                    let _e5709 = phi_1459_;
                    if (_e5685 > _e5709) {
                        phi_1464_ = _e5685;
                    } else {
                        phi_1464_ = _e5709;
                    }
                    let _e5712 = phi_1464_;
                    let _e5714 = local_18.member_3;
                    let _e5721 = local_18.member_3;
                    let _e5728 = (((_e5550 * (1f + (0.000000059604645f * 8f))) + (((((((_e5604 + _e5606) + (_e5658 + _e5660)) + (_e5712 + _e5714)) * (0.000000059604645f * 16f)) + (_e5721 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e655.member_1);
                    if _e5728 {
                        phi_2125_ = type_38();
                        phi_2126_ = true;
                    } else {
                        let _e5731 = local_18.member_1[0u];
                        let _e5737 = local_18.member_2[0u];
                        let _e5743 = ((_e5731[1] * _e5737[2]) - (_e5731[2] * _e5737[1]));
                        let _e5746 = ((_e5731[2] * _e5737[0]) - (_e5731[0] * _e5737[2]));
                        let _e5749 = ((_e5731[0] * _e5737[1]) - (_e5731[1] * _e5737[0]));
                        let _e5752 = local_18.member_1[1u];
                        let _e5758 = local_18.member_2[1u];
                        let _e5764 = ((_e5752[1] * _e5758[2]) - (_e5752[2] * _e5758[1]));
                        let _e5767 = ((_e5752[2] * _e5758[0]) - (_e5752[0] * _e5758[2]));
                        let _e5770 = ((_e5752[0] * _e5758[1]) - (_e5752[1] * _e5758[0]));
                        let _e5773 = local_18.member_1[0u];
                        let _e5779 = local_18.member_2[1u];
                        let _e5794 = local_18.member_1[1u];
                        let _e5800 = local_18.member_2[0u];
                        let _e5813 = (((_e5773[1] * _e5779[2]) - (_e5773[2] * _e5779[1])) + ((_e5794[1] * _e5800[2]) - (_e5794[2] * _e5800[1])));
                        let _e5814 = (((_e5773[2] * _e5779[0]) - (_e5773[0] * _e5779[2])) + ((_e5794[2] * _e5800[0]) - (_e5794[0] * _e5800[2])));
                        let _e5815 = (((_e5773[0] * _e5779[1]) - (_e5773[1] * _e5779[0])) + ((_e5794[0] * _e5800[1]) - (_e5794[1] * _e5800[0])));
                        let _e5818 = local_18.member[0u];
                        let _e5829 = local_18.member[1u];
                        let _e5840 = local_18.member[0u];
                        let _e5849 = ((((_e5829[0] * _e5743) + (_e5829[1] * _e5746)) + (_e5829[2] * _e5749)) + (((_e5840[0] * _e5813) + (_e5840[1] * _e5814)) + (_e5840[2] * _e5815)));
                        let _e5852 = local_18.member[0u];
                        let _e5863 = local_18.member[1u];
                        let _e5872 = ((((_e5852[0] * _e5764) + (_e5852[1] * _e5767)) + (_e5852[2] * _e5770)) + (((_e5863[0] * _e5813) + (_e5863[1] * _e5814)) + (_e5863[2] * _e5815)));
                        let _e5875 = local_18.member[1u];
                        let _e5886 = local_18.member[0u];
                        if (_e5886[0] < 0f) {
                            phi_1725_ = -(_e5886[0]);
                        } else {
                            phi_1725_ = _e5886[0];
                        }
                        let _e5893 = phi_1725_;
                        if (_e5886[1] < 0f) {
                            phi_1732_ = -(_e5886[1]);
                        } else {
                            phi_1732_ = _e5886[1];
                        }
                        let _e5897 = phi_1732_;
                        if (_e5893 > _e5897) {
                            phi_1737_ = _e5893;
                        } else {
                            phi_1737_ = _e5897;
                        }
                        let _e5900 = phi_1737_;
                        if (_e5886[2] < 0f) {
                            phi_1744_ = -(_e5886[2]);
                        } else {
                            phi_1744_ = _e5886[2];
                        }
                        let _e5904 = phi_1744_;
                        if (_e5900 > _e5904) {
                            phi_1749_ = _e5900;
                        } else {
                            phi_1749_ = _e5904;
                        }
                        let _e5907 = phi_1749_;
                        let _e5910 = local_18.member[1u];
                        if (_e5910[0] < 0f) {
                            phi_1762_ = -(_e5910[0]);
                        } else {
                            phi_1762_ = _e5910[0];
                        }
                        let _e5917 = phi_1762_;
                        if (_e5910[1] < 0f) {
                            phi_1769_ = -(_e5910[1]);
                        } else {
                            phi_1769_ = _e5910[1];
                        }
                        let _e5921 = phi_1769_;
                        if (_e5917 > _e5921) {
                            phi_1774_ = _e5917;
                        } else {
                            phi_1774_ = _e5921;
                        }
                        let _e5924 = phi_1774_;
                        if (_e5910[2] < 0f) {
                            phi_1781_ = -(_e5910[2]);
                        } else {
                            phi_1781_ = _e5910[2];
                        }
                        let _e5928 = phi_1781_;
                        if (_e5924 > _e5928) {
                            phi_1786_ = _e5924;
                        } else {
                            phi_1786_ = _e5928;
                        }
                        let _e5931 = phi_1786_;
                        if (_e5907 > _e5931) {
                            phi_1791_ = _e5907;
                        } else {
                            phi_1791_ = _e5931;
                        }
                        let _e5934 = phi_1791_;
                        let _e5936 = local_18.member_3;
                        let _e5937 = (_e5934 + _e5936);
                        let _e5940 = local_18.member_1[0u];
                        if (_e5940[0] < 0f) {
                            phi_1808_ = -(_e5940[0]);
                        } else {
                            phi_1808_ = _e5940[0];
                        }
                        let _e5947 = phi_1808_;
                        if (_e5940[1] < 0f) {
                            phi_1815_ = -(_e5940[1]);
                        } else {
                            phi_1815_ = _e5940[1];
                        }
                        let _e5951 = phi_1815_;
                        if (_e5947 > _e5951) {
                            phi_1820_ = _e5947;
                        } else {
                            phi_1820_ = _e5951;
                        }
                        let _e5954 = phi_1820_;
                        if (_e5940[2] < 0f) {
                            phi_1827_ = -(_e5940[2]);
                        } else {
                            phi_1827_ = _e5940[2];
                        }
                        let _e5958 = phi_1827_;
                        if (_e5954 > _e5958) {
                            phi_1832_ = _e5954;
                        } else {
                            phi_1832_ = _e5958;
                        }
                        let _e5961 = phi_1832_;
                        let _e5964 = local_18.member_1[1u];
                        if (_e5964[0] < 0f) {
                            phi_1846_ = -(_e5964[0]);
                        } else {
                            phi_1846_ = _e5964[0];
                        }
                        let _e5971 = phi_1846_;
                        if (_e5964[1] < 0f) {
                            phi_1853_ = -(_e5964[1]);
                        } else {
                            phi_1853_ = _e5964[1];
                        }
                        let _e5975 = phi_1853_;
                        if (_e5971 > _e5975) {
                            phi_1858_ = _e5971;
                        } else {
                            phi_1858_ = _e5975;
                        }
                        let _e5978 = phi_1858_;
                        if (_e5964[2] < 0f) {
                            phi_1865_ = -(_e5964[2]);
                        } else {
                            phi_1865_ = _e5964[2];
                        }
                        let _e5982 = phi_1865_;
                        if (_e5978 > _e5982) {
                            phi_1870_ = _e5978;
                        } else {
                            phi_1870_ = _e5982;
                        }
                        let _e5985 = phi_1870_;
                        if (_e5961 > _e5985) {
                            phi_1875_ = _e5961;
                        } else {
                            phi_1875_ = _e5985;
                        }
                        let _e5988 = phi_1875_;
                        let _e5990 = local_18.member_3;
                        let _e5991 = (_e5988 + _e5990);
                        let _e5994 = local_18.member_2[0u];
                        if (_e5994[0] < 0f) {
                            phi_1892_ = -(_e5994[0]);
                        } else {
                            phi_1892_ = _e5994[0];
                        }
                        let _e6001 = phi_1892_;
                        if (_e5994[1] < 0f) {
                            phi_1899_ = -(_e5994[1]);
                        } else {
                            phi_1899_ = _e5994[1];
                        }
                        let _e6005 = phi_1899_;
                        if (_e6001 > _e6005) {
                            phi_1904_ = _e6001;
                        } else {
                            phi_1904_ = _e6005;
                        }
                        let _e6008 = phi_1904_;
                        if (_e5994[2] < 0f) {
                            phi_1911_ = -(_e5994[2]);
                        } else {
                            phi_1911_ = _e5994[2];
                        }
                        let _e6012 = phi_1911_;
                        if (_e6008 > _e6012) {
                            phi_1916_ = _e6008;
                        } else {
                            phi_1916_ = _e6012;
                        }
                        let _e6015 = phi_1916_;
                        let _e6018 = local_18.member_2[1u];
                        if (_e6018[0] < 0f) {
                            phi_1930_ = -(_e6018[0]);
                        } else {
                            phi_1930_ = _e6018[0];
                        }
                        let _e6025 = phi_1930_;
                        if (_e6018[1] < 0f) {
                            phi_1937_ = -(_e6018[1]);
                        } else {
                            phi_1937_ = _e6018[1];
                        }
                        let _e6029 = phi_1937_;
                        if (_e6025 > _e6029) {
                            phi_1942_ = _e6025;
                        } else {
                            phi_1942_ = _e6029;
                        }
                        let _e6032 = phi_1942_;
                        if (_e6018[2] < 0f) {
                            phi_1949_ = -(_e6018[2]);
                        } else {
                            phi_1949_ = _e6018[2];
                        }
                        let _e6036 = phi_1949_;
                        if (_e6032 > _e6036) {
                            phi_1954_ = _e6032;
                        } else {
                            phi_1954_ = _e6036;
                        }
                        let _e6039 = phi_1954_;
                        if (_e6015 > _e6039) {
                            phi_1959_ = _e6015;
                        } else {
                            phi_1959_ = _e6039;
                        }
                        let _e6042 = phi_1959_;
                        let _e6044 = local_18.member_3;
                        let _e6045 = (_e6042 + _e6044);
                        let _e6047 = ((_e5991 * 8f) * _e6045);
                        let _e6054 = local_18.member_3;
                        if (_e5743 < 0f) {
                            phi_1990_ = -(_e5743);
                        } else {
                            phi_1990_ = _e5743;
                        }
                        let _e6071 = phi_1990_;
                        if (_e5746 < 0f) {
                            phi_1996_ = -(_e5746);
                        } else {
                            phi_1996_ = _e5746;
                        }
                        let _e6075 = phi_1996_;
                        if (_e5749 < 0f) {
                            phi_2003_ = -(_e5749);
                        } else {
                            phi_2003_ = _e5749;
                        }
                        let _e6080 = phi_2003_;
                        let _e6081 = ((_e6071 + _e6075) + _e6080);
                        if (_e5764 < 0f) {
                            phi_2010_ = -(_e5764);
                        } else {
                            phi_2010_ = _e5764;
                        }
                        let _e6085 = phi_2010_;
                        if (_e5767 < 0f) {
                            phi_2016_ = -(_e5767);
                        } else {
                            phi_2016_ = _e5767;
                        }
                        let _e6089 = phi_2016_;
                        if (_e5770 < 0f) {
                            phi_2023_ = -(_e5770);
                        } else {
                            phi_2023_ = _e5770;
                        }
                        let _e6094 = phi_2023_;
                        let _e6095 = ((_e6085 + _e6089) + _e6094);
                        if (_e6081 > _e6095) {
                            phi_2029_ = _e6081;
                        } else {
                            phi_2029_ = _e6095;
                        }
                        let _e6098 = phi_2029_;
                        if (_e5813 < 0f) {
                            phi_2035_ = -(_e5813);
                        } else {
                            phi_2035_ = _e5813;
                        }
                        let _e6102 = phi_2035_;
                        if (_e5814 < 0f) {
                            phi_2041_ = -(_e5814);
                        } else {
                            phi_2041_ = _e5814;
                        }
                        let _e6106 = phi_2041_;
                        if (_e5815 < 0f) {
                            phi_2048_ = -(_e5815);
                        } else {
                            phi_2048_ = _e5815;
                        }
                        let _e6111 = phi_2048_;
                        let _e6113 = (((_e6102 + _e6106) + _e6111) * 0.5f);
                        if (_e6098 > _e6113) {
                            phi_2055_ = _e6098;
                        } else {
                            phi_2055_ = _e6113;
                        }
                        let _e6116 = phi_2055_;
                        let _e6121 = local_18.member_3;
                        let _e6134 = ((((_e5818[0] * _e5743) + (_e5818[1] * _e5746)) + (_e5818[2] * _e5749)) * 3f);
                        let _e6135 = ((((_e5875[0] * _e5764) + (_e5875[1] * _e5767)) + (_e5875[2] * _e5770)) * 3f);
                        if (_e6134 < _e6135) {
                            phi_2079_ = _e6134;
                        } else {
                            phi_2079_ = _e6135;
                        }
                        let _e6138 = phi_2079_;
                        if (_e5849 < _e5872) {
                            phi_2084_ = _e5849;
                        } else {
                            phi_2084_ = _e5872;
                        }
                        let _e6141 = phi_2084_;
                        if (_e6138 < _e6141) {
                            phi_2089_ = _e6138;
                        } else {
                            phi_2089_ = _e6141;
                        }
                        let _e6144 = phi_2089_;
                        if (_e6134 > _e6135) {
                            phi_2094_ = _e6134;
                        } else {
                            phi_2094_ = _e6135;
                        }
                        let _e6147 = phi_2094_;
                        if (_e5849 > _e5872) {
                            phi_2099_ = _e5849;
                        } else {
                            phi_2099_ = _e5872;
                        }
                        let _e6150 = phi_2099_;
                        if (_e6147 > _e6150) {
                            phi_2104_ = _e6147;
                        } else {
                            phi_2104_ = _e6150;
                        }
                        let _e6153 = phi_2104_;
                        let _e6158 = -(_e6153);
                        if (_e6144 > _e6158) {
                            phi_2114_ = _e6144;
                        } else {
                            phi_2114_ = _e6158;
                        }
                        let _e6161 = phi_2114_;
                        if ((_e6161 - ((((((_e5937 * 8f) * _e6047) * (0.000000059604645f * (524f / 64f))) + ((_e6054 * 19f) * ((_e5937 * (_e5991 + _e6045)) + (_e5991 * _e6045)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e5937) * ((1f + _e5991) * (1f + _e6045))))) + ((_e655.member_1 * (((_e6116 + (_e6047 * (0.000000059604645f * 8f))) + ((_e6121 * 6f) * (_e5991 + _e6045))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e5991) * (1f + _e6045))))) * (3f * 1.0001f)))) > 0f) {
                            phi_2123_ = type_38(type_37(0u, f32()), 0u);
                            phi_2124_ = false;
                        } else {
                            phi_2123_ = type_38();
                            phi_2124_ = true;
                        }
                        let _e6167 = phi_2123_;
                        let _e6169 = phi_2124_;
                        phi_2125_ = _e6167;
                        phi_2126_ = _e6169;
                    }
                    let _e6171 = phi_2125_;
                    let _e6173 = phi_2126_;
                    if _e6173 {
                        phi_2132_ = type_16(0i, 2i);
                        phi_2135_ = _e387;
                        phi_2137_ = 0u;
                        phi_2139_ = _e387;
                        loop {
                            let _e6175 = phi_2132_;
                            let _e6177 = phi_2135_;
                            let _e6179 = phi_2137_;
                            let _e6181 = phi_2139_;
                            local_96 = _e6179;
                            local_99 = _e6177;
                            local_100 = _e6179;
                            if (_e6175.member < _e6175.member_1) {
                                let _e6188 = (_e6175.member + 1i);
                                if ((false == (_e6188 > _e6175.member)) != false) {
                                    phi_2160_ = true;
                                } else {
                                    phi_2160_ = false;
                                }
                                let _e6193 = phi_2160_;
                                if _e6193 {
                                    phi_2166_ = type_17(0u, type_17().member_1);
                                } else {
                                    phi_2166_ = type_17(1u, _e6188);
                                }
                                let _e6198 = phi_2166_;
                                phi_2133_ = type_16(_e6198.member_1, _e6175.member_1);
                                phi_2180_ = type_17(1u, _e6175.member);
                            } else {
                                phi_2133_ = _e6175;
                                phi_2180_ = type_17(0u, type_17().member_1);
                            }
                            let _e6204 = phi_2133_;
                            let _e6206 = phi_2180_;
                            if (bitcast<i32>(_e6206.member) != 0i) {
                                if (_e6206.member_1 > 0i) {
                                    phi_2196_ = true;
                                } else {
                                    if _e5728 {
                                        phi_2195_ = false;
                                    } else {
                                        phi_2195_ = true;
                                    }
                                    let _e6213 = phi_2195_;
                                    phi_2196_ = _e6213;
                                }
                                let _e6215 = phi_2196_;
                                if _e6215 {
                                    let _e6218 = local_18.member[0u];
                                    let _e6225 = local_18.member_1[0u];
                                    let _e6231 = local_18.member_2[0u];
                                    let _e6235 = (_e6218[0] - _e6225[0]);
                                    let _e6236 = (_e6218[1] - _e6225[1]);
                                    let _e6237 = (_e6218[2] - _e6225[2]);
                                    if (_e245.member == 0u) {
                                        phi_2255_ = array<f32, 3>(_e6218[0], _e6218[1], _e6218[2]);
                                    } else {
                                        phi_2255_ = array<f32, 3>((_e6235 - _e6231[0]), (_e6236 - _e6231[1]), (_e6237 - _e6231[2]));
                                    }
                                    let _e6244 = phi_2255_;
                                    let _e6250 = local_18.member[1u];
                                    let _e6257 = local_18.member_1[1u];
                                    let _e6263 = local_18.member_2[1u];
                                    let _e6267 = (_e6250[0] - _e6257[0]);
                                    let _e6268 = (_e6250[1] - _e6257[1]);
                                    let _e6269 = (_e6250[2] - _e6257[2]);
                                    if (_e245.member == 0u) {
                                        phi_2320_ = array<f32, 3>(_e6250[0], _e6250[1], _e6250[2]);
                                    } else {
                                        phi_2320_ = array<f32, 3>((_e6267 - _e6263[0]), (_e6268 - _e6263[1]), (_e6269 - _e6263[2]));
                                    }
                                    let _e6276 = phi_2320_;
                                    let _e6282 = local_18.member[0u];
                                    if (_e6282[0] < 0f) {
                                        phi_2342_ = -(_e6282[0]);
                                    } else {
                                        phi_2342_ = _e6282[0];
                                    }
                                    let _e6289 = phi_2342_;
                                    if (_e6282[1] < 0f) {
                                        phi_2349_ = -(_e6282[1]);
                                    } else {
                                        phi_2349_ = _e6282[1];
                                    }
                                    let _e6293 = phi_2349_;
                                    if (_e6289 > _e6293) {
                                        phi_2354_ = _e6289;
                                    } else {
                                        phi_2354_ = _e6293;
                                    }
                                    let _e6296 = phi_2354_;
                                    if (_e6282[2] < 0f) {
                                        phi_2361_ = -(_e6282[2]);
                                    } else {
                                        phi_2361_ = _e6282[2];
                                    }
                                    let _e6300 = phi_2361_;
                                    if (_e6296 > _e6300) {
                                        phi_2366_ = _e6296;
                                    } else {
                                        phi_2366_ = _e6300;
                                    }
                                    let _e6303 = phi_2366_;
                                    let _e6306 = local_18.member[1u];
                                    if (_e6306[0] < 0f) {
                                        phi_2379_ = -(_e6306[0]);
                                    } else {
                                        phi_2379_ = _e6306[0];
                                    }
                                    let _e6313 = phi_2379_;
                                    if (_e6306[1] < 0f) {
                                        phi_2386_ = -(_e6306[1]);
                                    } else {
                                        phi_2386_ = _e6306[1];
                                    }
                                    let _e6317 = phi_2386_;
                                    if (_e6313 > _e6317) {
                                        phi_2391_ = _e6313;
                                    } else {
                                        phi_2391_ = _e6317;
                                    }
                                    let _e6320 = phi_2391_;
                                    if (_e6306[2] < 0f) {
                                        phi_2398_ = -(_e6306[2]);
                                    } else {
                                        phi_2398_ = _e6306[2];
                                    }
                                    let _e6324 = phi_2398_;
                                    if (_e6320 > _e6324) {
                                        phi_2403_ = _e6320;
                                    } else {
                                        phi_2403_ = _e6324;
                                    }
                                    let _e6327 = phi_2403_;
                                    if (_e6303 > _e6327) {
                                        phi_2408_ = _e6303;
                                    } else {
                                        phi_2408_ = _e6327;
                                    }
                                    let _e6330 = phi_2408_;
                                    let _e6332 = local_18.member_3;
                                    let _e6336 = local_18.member_1[0u];
                                    if (_e6336[0] < 0f) {
                                        phi_2425_ = -(_e6336[0]);
                                    } else {
                                        phi_2425_ = _e6336[0];
                                    }
                                    let _e6343 = phi_2425_;
                                    if (_e6336[1] < 0f) {
                                        phi_2432_ = -(_e6336[1]);
                                    } else {
                                        phi_2432_ = _e6336[1];
                                    }
                                    let _e6347 = phi_2432_;
                                    if (_e6343 > _e6347) {
                                        phi_2437_ = _e6343;
                                    } else {
                                        phi_2437_ = _e6347;
                                    }
                                    let _e6350 = phi_2437_;
                                    if (_e6336[2] < 0f) {
                                        phi_2444_ = -(_e6336[2]);
                                    } else {
                                        phi_2444_ = _e6336[2];
                                    }
                                    let _e6354 = phi_2444_;
                                    if (_e6350 > _e6354) {
                                        phi_2449_ = _e6350;
                                    } else {
                                        phi_2449_ = _e6354;
                                    }
                                    let _e6357 = phi_2449_;
                                    let _e6360 = local_18.member_1[1u];
                                    if (_e6360[0] < 0f) {
                                        phi_2463_ = -(_e6360[0]);
                                    } else {
                                        phi_2463_ = _e6360[0];
                                    }
                                    let _e6367 = phi_2463_;
                                    if (_e6360[1] < 0f) {
                                        phi_2470_ = -(_e6360[1]);
                                    } else {
                                        phi_2470_ = _e6360[1];
                                    }
                                    let _e6371 = phi_2470_;
                                    if (_e6367 > _e6371) {
                                        phi_2475_ = _e6367;
                                    } else {
                                        phi_2475_ = _e6371;
                                    }
                                    let _e6374 = phi_2475_;
                                    if (_e6360[2] < 0f) {
                                        phi_2482_ = -(_e6360[2]);
                                    } else {
                                        phi_2482_ = _e6360[2];
                                    }
                                    let _e6378 = phi_2482_;
                                    if (_e6374 > _e6378) {
                                        phi_2487_ = _e6374;
                                    } else {
                                        phi_2487_ = _e6378;
                                    }
                                    let _e6381 = phi_2487_;
                                    if (_e6357 > _e6381) {
                                        phi_2492_ = _e6357;
                                    } else {
                                        phi_2492_ = _e6381;
                                    }
                                    let _e6384 = phi_2492_;
                                    let _e6386 = local_18.member_3;
                                    let _e6390 = local_18.member_2[0u];
                                    if (_e6390[0] < 0f) {
                                        phi_2509_ = -(_e6390[0]);
                                    } else {
                                        phi_2509_ = _e6390[0];
                                    }
                                    let _e6397 = phi_2509_;
                                    if (_e6390[1] < 0f) {
                                        phi_2516_ = -(_e6390[1]);
                                    } else {
                                        phi_2516_ = _e6390[1];
                                    }
                                    let _e6401 = phi_2516_;
                                    if (_e6397 > _e6401) {
                                        phi_2521_ = _e6397;
                                    } else {
                                        phi_2521_ = _e6401;
                                    }
                                    let _e6404 = phi_2521_;
                                    if (_e6390[2] < 0f) {
                                        phi_2528_ = -(_e6390[2]);
                                    } else {
                                        phi_2528_ = _e6390[2];
                                    }
                                    let _e6408 = phi_2528_;
                                    if (_e6404 > _e6408) {
                                        phi_2533_ = _e6404;
                                    } else {
                                        phi_2533_ = _e6408;
                                    }
                                    let _e6411 = phi_2533_;
                                    let _e6414 = local_18.member_2[1u];
                                    if (_e6414[0] < 0f) {
                                        phi_2547_ = -(_e6414[0]);
                                    } else {
                                        phi_2547_ = _e6414[0];
                                    }
                                    let _e6421 = phi_2547_;
                                    if (_e6414[1] < 0f) {
                                        phi_2554_ = -(_e6414[1]);
                                    } else {
                                        phi_2554_ = _e6414[1];
                                    }
                                    let _e6425 = phi_2554_;
                                    if (_e6421 > _e6425) {
                                        phi_2559_ = _e6421;
                                    } else {
                                        phi_2559_ = _e6425;
                                    }
                                    let _e6428 = phi_2559_;
                                    if (_e6414[2] < 0f) {
                                        phi_2566_ = -(_e6414[2]);
                                    } else {
                                        phi_2566_ = _e6414[2];
                                    }
                                    let _e6432 = phi_2566_;
                                    if (_e6428 > _e6432) {
                                        phi_2571_ = _e6428;
                                    } else {
                                        phi_2571_ = _e6432;
                                    }
                                    let _e6435 = phi_2571_;
                                    if (_e6411 > _e6435) {
                                        phi_2576_ = _e6411;
                                    } else {
                                        phi_2576_ = _e6435;
                                    }
                                    let _e6438 = phi_2576_;
                                    let _e6440 = local_18.member_3;
                                    let _e6447 = local_18.member_3;
                                    let _e6452 = (_e385 * 0.00390625f);
                                    local_16 = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    phi_2617_ = type_9(0u, 96u);
                                    phi_2620_ = _e6181;
                                    phi_2622_ = _e6181;
                                    phi_2624_ = (_e389 - _e6181);
                                    phi_2626_ = _e6181;
                                    phi_2628_ = false;
                                    phi_2630_ = 0u;
                                    loop {
                                        let _e6455 = phi_2617_;
                                        let _e6457 = phi_2620_;
                                        let _e6459 = phi_2622_;
                                        let _e6461 = phi_2624_;
                                        let _e6463 = phi_2626_;
                                        let _e6465 = phi_2628_;
                                        let _e6467 = phi_2630_;
                                        local_43 = _e6457;
                                        local_86 = _e6459;
                                        if (_e6455.member < _e6455.member_1) {
                                            phi_2618_ = type_9((_e6455.member + 1u), _e6455.member_1);
                                            phi_2653_ = type_9(1u, _e6455.member);
                                        } else {
                                            phi_2618_ = _e6455;
                                            phi_2653_ = type_9(0u, type_9().member_1);
                                        }
                                        let _e6479 = phi_2618_;
                                        let _e6481 = phi_2653_;
                                        if (bitcast<i32>(_e6481.member) != 0i) {
                                            let _e6487 = local_18.member[0u];
                                            let _e6493 = local_18.member[1u];
                                            let _e6509 = local_18.member_1[0u];
                                            let _e6515 = local_18.member_1[1u];
                                            let _e6531 = local_18.member_2[0u];
                                            let _e6537 = local_18.member_2[1u];
                                            let _e6551 = function_3(array<f32, 3>((_e6487[0] + ((_e6493[0] - _e6487[0]) * _e6457)), (_e6487[1] + ((_e6493[1] - _e6487[1]) * _e6457)), (_e6487[2] + ((_e6493[2] - _e6487[2]) * _e6457))), array<f32, 3>((_e6509[0] + ((_e6515[0] - _e6509[0]) * _e6457)), (_e6509[1] + ((_e6515[1] - _e6509[1]) * _e6457)), (_e6509[2] + ((_e6515[2] - _e6509[2]) * _e6457))), array<f32, 3>((_e6531[0] + ((_e6537[0] - _e6531[0]) * _e6457)), (_e6531[1] + ((_e6537[1] - _e6531[1]) * _e6457)), (_e6531[2] + ((_e6537[2] - _e6531[2]) * _e6457))), _e245.member);
                                            if (_e6467 == 0u) {
                                                phi_2781_ = _e6551;
                                            } else {
                                                if (_e6467 == 1u) {
                                                    phi_2767_ = _e6551[0];
                                                } else {
                                                    phi_2767_ = 0f;
                                                }
                                                let _e6556 = phi_2767_;
                                                if (_e6467 == 2u) {
                                                    phi_2773_ = _e6551[1];
                                                } else {
                                                    phi_2773_ = 0f;
                                                }
                                                let _e6560 = phi_2773_;
                                                if (_e6467 == 3u) {
                                                    phi_2779_ = _e6551[2];
                                                } else {
                                                    phi_2779_ = 0f;
                                                }
                                                let _e6564 = phi_2779_;
                                                phi_2781_ = array<f32, 3>(_e6556, _e6560, _e6564);
                                            }
                                            let _e6567 = phi_2781_;
                                            if (_e6567[0] < 0f) {
                                                phi_2788_ = -(_e6567[0]);
                                            } else {
                                                phi_2788_ = _e6567[0];
                                            }
                                            let _e6572 = phi_2788_;
                                            if (_e6567[1] < 0f) {
                                                phi_2795_ = -(_e6567[1]);
                                            } else {
                                                phi_2795_ = _e6567[1];
                                            }
                                            let _e6577 = phi_2795_;
                                            if (_e6567[2] < 0f) {
                                                phi_2803_ = -(_e6567[2]);
                                            } else {
                                                phi_2803_ = _e6567[2];
                                            }
                                            let _e6583 = phi_2803_;
                                            let _e6584 = ((_e6572 + _e6577) + _e6583);
                                            if (_e6584 > 0f) {
                                                if ((bitcast<u32>(_e6584) & 2139095040u) != 2139095040u) {
                                                    let _e6589 = (1f / _e6584);
                                                    let _e6591 = (_e6567[0] * _e6589);
                                                    let _e6593 = (_e6567[1] * _e6589);
                                                    let _e6595 = (_e6567[2] * _e6589);
                                                    let _e6600 = (((_e6591 * _e6591) + (_e6593 * _e6593)) + (_e6595 * _e6595));
                                                    if (_e6600 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e6600 > 0f) {
                                                            phi_2840_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_2840_ = 0f;
                                                        }
                                                        let _e6653 = phi_2840_;
                                                        phi_2904_ = _e6653;
                                                    } else {
                                                        phi_2847_ = type_16(0i, 5i);
                                                        phi_2850_ = bitcast<f32>(((bitcast<u32>(_e6600) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e6608 = phi_2847_;
                                                            let _e6610 = phi_2850_;
                                                            local_40 = _e6610;
                                                            if (_e6608.member < _e6608.member_1) {
                                                                let _e6617 = (_e6608.member + 1i);
                                                                if ((false == (_e6617 > _e6608.member)) != false) {
                                                                    phi_2871_ = true;
                                                                } else {
                                                                    phi_2871_ = false;
                                                                }
                                                                let _e6622 = phi_2871_;
                                                                if _e6622 {
                                                                    phi_2877_ = type_17(0u, type_17().member_1);
                                                                } else {
                                                                    phi_2877_ = type_17(1u, _e6617);
                                                                }
                                                                let _e6627 = phi_2877_;
                                                                phi_2848_ = type_16(_e6627.member_1, _e6608.member_1);
                                                                phi_2891_ = type_17(1u, _e6608.member);
                                                            } else {
                                                                phi_2848_ = _e6608;
                                                                phi_2891_ = type_17(0u, type_17().member_1);
                                                            }
                                                            let _e6633 = phi_2848_;
                                                            let _e6635 = phi_2891_;
                                                            let _e6638 = (bitcast<i32>(_e6635.member) != 0i);
                                                            if _e6638 {
                                                                phi_2851_ = (0.5f * (_e6610 + (_e6600 / _e6610)));
                                                            } else {
                                                                phi_2851_ = f32();
                                                            }
                                                            let _e6643 = phi_2851_;
                                                            continue;
                                                            continuing {
                                                                phi_2847_ = _e6633;
                                                                phi_2850_ = _e6643;
                                                                break if !(_e6638);
                                                            }
                                                        }
                                                        let _e6648 = local_40;
                                                        phi_2904_ = (_e6648 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e6655 = phi_2904_;
                                                    let _e6656 = (0.000000059604645f * 12f);
                                                    let _e6661 = ((((((((_e6330 + _e6332) + (_e6384 + _e6386)) + (_e6438 + _e6440)) * (0.000000059604645f * 16f)) + (_e6447 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e655.member_1 * _e6655) * (1f + _e6656)));
                                                    let _e6666 = (((_e6591 * _e6218[0]) + (_e6593 * _e6218[1])) + (_e6595 * _e6218[2]));
                                                    let _e6671 = (((_e6591 * _e6235) + (_e6593 * _e6236)) + (_e6595 * _e6237));
                                                    let _e6676 = (((_e6591 * (_e6218[0] - _e6231[0])) + (_e6593 * (_e6218[1] - _e6231[1]))) + (_e6595 * (_e6218[2] - _e6231[2])));
                                                    let _e6684 = (((_e6591 * _e6244[0]) + (_e6593 * _e6244[1])) + (_e6595 * _e6244[2]));
                                                    let _e6690 = (((_e6591 * _e6250[0]) + (_e6593 * _e6250[1])) + (_e6595 * _e6250[2]));
                                                    let _e6695 = (((_e6591 * _e6267) + (_e6593 * _e6268)) + (_e6595 * _e6269));
                                                    let _e6700 = (((_e6591 * (_e6250[0] - _e6263[0])) + (_e6593 * (_e6250[1] - _e6263[1]))) + (_e6595 * (_e6250[2] - _e6263[2])));
                                                    let _e6708 = (((_e6591 * _e6276[0]) + (_e6593 * _e6276[1])) + (_e6595 * _e6276[2]));
                                                    if (_e6666 < 0f) {
                                                        phi_2970_ = -(_e6666);
                                                    } else {
                                                        phi_2970_ = _e6666;
                                                    }
                                                    let _e6713 = phi_2970_;
                                                    if (_e6690 < 0f) {
                                                        phi_2976_ = -(_e6690);
                                                    } else {
                                                        phi_2976_ = _e6690;
                                                    }
                                                    let _e6717 = phi_2976_;
                                                    if (_e6671 < 0f) {
                                                        phi_2985_ = -(_e6671);
                                                    } else {
                                                        phi_2985_ = _e6671;
                                                    }
                                                    let _e6724 = phi_2985_;
                                                    if (_e6695 < 0f) {
                                                        phi_2991_ = -(_e6695);
                                                    } else {
                                                        phi_2991_ = _e6695;
                                                    }
                                                    let _e6728 = phi_2991_;
                                                    if (_e6676 < 0f) {
                                                        phi_3000_ = -(_e6676);
                                                    } else {
                                                        phi_3000_ = _e6676;
                                                    }
                                                    let _e6735 = phi_3000_;
                                                    if (_e6700 < 0f) {
                                                        phi_3006_ = -(_e6700);
                                                    } else {
                                                        phi_3006_ = _e6700;
                                                    }
                                                    let _e6739 = phi_3006_;
                                                    if (_e6684 < 0f) {
                                                        phi_3015_ = -(_e6684);
                                                    } else {
                                                        phi_3015_ = _e6684;
                                                    }
                                                    let _e6746 = phi_3015_;
                                                    if (_e6708 < 0f) {
                                                        phi_3021_ = -(_e6708);
                                                    } else {
                                                        phi_3021_ = _e6708;
                                                    }
                                                    let _e6750 = phi_3021_;
                                                    phi_3027_ = type_31(array<f32, 4>(_e6666, _e6671, _e6676, _e6684), array<f32, 4>(_e6690, _e6695, _e6700, _e6708), array<f32, 4>((_e6661 + ((_e6713 + _e6717) * _e6656)), (_e6661 + ((_e6724 + _e6728) * _e6656)), (_e6661 + ((_e6735 + _e6739) * _e6656)), (_e6661 + ((_e6746 + _e6750) * _e6656))));
                                                    phi_3028_ = false;
                                                } else {
                                                    phi_3027_ = type_31();
                                                    phi_3028_ = true;
                                                }
                                                let _e6757 = phi_3027_;
                                                let _e6759 = phi_3028_;
                                                phi_3029_ = _e6757;
                                                phi_3030_ = _e6759;
                                            } else {
                                                phi_3029_ = type_31();
                                                phi_3030_ = true;
                                            }
                                            let _e6761 = phi_3029_;
                                            let _e6763 = phi_3030_;
                                            if _e6763 {
                                                phi_3038_ = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            } else {
                                                phi_3038_ = _e6761;
                                            }
                                            let _e6765 = phi_3038_;
                                            local_17 = type_31(array<f32, 4>(_e6765.member[0], _e6765.member[1], _e6765.member[2], _e6765.member[3]), array<f32, 4>(_e6765.member_1[0], _e6765.member_1[1], _e6765.member_1[2], _e6765.member_1[3]), array<f32, 4>(_e6765.member_2[0], _e6765.member_2[1], _e6765.member_2[2], _e6765.member_2[3]));
                                            let _e6785 = (_e6457 - _e6463);
                                            let _e6789 = local_17.member[0u];
                                            let _e6792 = local_17.member_1[0u];
                                            let _e6795 = local_17.member[0u];
                                            let _e6801 = local_17.member_2[0u];
                                            if (((_e6789 + ((_e6792 - _e6795) * _e6457)) - _e6801) > 0f) {
                                                let _e6806 = local_17.member[1u];
                                                let _e6809 = local_17.member_1[1u];
                                                let _e6812 = local_17.member[1u];
                                                let _e6818 = local_17.member_2[1u];
                                                if (((_e6806 + ((_e6809 - _e6812) * _e6457)) - _e6818) > 0f) {
                                                    let _e6823 = local_17.member[2u];
                                                    let _e6826 = local_17.member_1[2u];
                                                    let _e6829 = local_17.member[2u];
                                                    let _e6835 = local_17.member_2[2u];
                                                    if (((_e6823 + ((_e6826 - _e6829) * _e6457)) - _e6835) > 0f) {
                                                        let _e6840 = local_17.member[3u];
                                                        let _e6843 = local_17.member_1[3u];
                                                        let _e6846 = local_17.member[3u];
                                                        let _e6852 = local_17.member_2[3u];
                                                        phi_3209_ = (((_e6840 + ((_e6843 - _e6846) * _e6457)) - _e6852) > 0f);
                                                        phi_3210_ = false;
                                                    } else {
                                                        phi_3209_ = bool();
                                                        phi_3210_ = true;
                                                    }
                                                    let _e6856 = phi_3209_;
                                                    let _e6858 = phi_3210_;
                                                    phi_3211_ = _e6856;
                                                    phi_3212_ = _e6858;
                                                } else {
                                                    phi_3211_ = bool();
                                                    phi_3212_ = true;
                                                }
                                                let _e6860 = phi_3211_;
                                                let _e6862 = phi_3212_;
                                                phi_3213_ = _e6860;
                                                phi_3214_ = _e6862;
                                            } else {
                                                phi_3213_ = bool();
                                                phi_3214_ = true;
                                            }
                                            let _e6864 = phi_3213_;
                                            let _e6866 = phi_3214_;
                                            if _e6866 {
                                                phi_3218_ = false;
                                            } else {
                                                phi_3218_ = _e6864;
                                            }
                                            let _e6868 = phi_3218_;
                                            if _e6868 {
                                                if (_e6457 <= _e6459) {
                                                    phi_3528_ = true;
                                                } else {
                                                    let _e6872 = local_16.member[0u];
                                                    let _e6875 = local_16.member_1[0u];
                                                    let _e6878 = local_16.member[0u];
                                                    let _e6884 = local_16.member_2[0u];
                                                    let _e6888 = local_17.member[0u];
                                                    let _e6891 = local_17.member_1[0u];
                                                    let _e6894 = local_17.member[0u];
                                                    let _e6900 = local_17.member_2[0u];
                                                    if ((((_e6872 + ((_e6875 - _e6878) * _e6457)) - _e6884) + ((_e6888 + ((_e6891 - _e6894) * _e6463)) - _e6900)) > 0f) {
                                                        let _e6906 = local_16.member[1u];
                                                        let _e6909 = local_16.member_1[1u];
                                                        let _e6912 = local_16.member[1u];
                                                        let _e6918 = local_16.member_2[1u];
                                                        let _e6922 = local_17.member[1u];
                                                        let _e6925 = local_17.member_1[1u];
                                                        let _e6928 = local_17.member[1u];
                                                        let _e6934 = local_17.member_2[1u];
                                                        if ((((_e6906 + ((_e6909 - _e6912) * _e6457)) - _e6918) + ((_e6922 + ((_e6925 - _e6928) * _e6463)) - _e6934)) > 0f) {
                                                            let _e6940 = local_16.member[2u];
                                                            let _e6943 = local_16.member_1[2u];
                                                            let _e6946 = local_16.member[2u];
                                                            let _e6952 = local_16.member_2[2u];
                                                            let _e6956 = local_17.member[2u];
                                                            let _e6959 = local_17.member_1[2u];
                                                            let _e6962 = local_17.member[2u];
                                                            let _e6968 = local_17.member_2[2u];
                                                            if ((((_e6940 + ((_e6943 - _e6946) * _e6457)) - _e6952) + ((_e6956 + ((_e6959 - _e6962) * _e6463)) - _e6968)) > 0f) {
                                                                let _e6974 = local_16.member[3u];
                                                                let _e6977 = local_16.member_1[3u];
                                                                let _e6980 = local_16.member[3u];
                                                                let _e6986 = local_16.member_2[3u];
                                                                let _e6990 = local_17.member[3u];
                                                                let _e6993 = local_17.member_1[3u];
                                                                let _e6996 = local_17.member[3u];
                                                                let _e7002 = local_17.member_2[3u];
                                                                phi_3515_ = ((((_e6974 + ((_e6977 - _e6980) * _e6457)) - _e6986) + ((_e6990 + ((_e6993 - _e6996) * _e6463)) - _e7002)) > 0f);
                                                                phi_3516_ = false;
                                                            } else {
                                                                phi_3515_ = bool();
                                                                phi_3516_ = true;
                                                            }
                                                            let _e7007 = phi_3515_;
                                                            let _e7009 = phi_3516_;
                                                            phi_3517_ = _e7007;
                                                            phi_3518_ = _e7009;
                                                        } else {
                                                            phi_3517_ = bool();
                                                            phi_3518_ = true;
                                                        }
                                                        let _e7011 = phi_3517_;
                                                        let _e7013 = phi_3518_;
                                                        phi_3519_ = _e7011;
                                                        phi_3520_ = _e7013;
                                                    } else {
                                                        phi_3519_ = bool();
                                                        phi_3520_ = true;
                                                    }
                                                    let _e7015 = phi_3519_;
                                                    let _e7017 = phi_3520_;
                                                    if _e7017 {
                                                        phi_3524_ = false;
                                                    } else {
                                                        phi_3524_ = _e7015;
                                                    }
                                                    let _e7019 = phi_3524_;
                                                    phi_3528_ = _e7019;
                                                }
                                                let _e7021 = phi_3528_;
                                                if _e7021 {
                                                    if _e6465 {
                                                        if (_e6457 >= _e389) {
                                                            phi_3539_ = false;
                                                        } else {
                                                            phi_3539_ = true;
                                                        }
                                                        let _e7024 = phi_3539_;
                                                        phi_3540_ = _e7024;
                                                    } else {
                                                        phi_3540_ = true;
                                                    }
                                                    let _e7026 = phi_3540_;
                                                    if _e7026 {
                                                        local_16 = type_31(array<f32, 4>(_e6765.member[0], _e6765.member[1], _e6765.member[2], _e6765.member[3]), array<f32, 4>(_e6765.member_1[0], _e6765.member_1[1], _e6765.member_1[2], _e6765.member_1[3]), array<f32, 4>(_e6765.member_2[0], _e6765.member_2[1], _e6765.member_2[2], _e6765.member_2[3]));
                                                        let _e7048 = local_16.member[0u];
                                                        let _e7051 = local_16.member_1[0u];
                                                        let _e7054 = local_16.member_2[0u];
                                                        if (_e7048 > _e7054) {
                                                            if (_e7051 > _e7054) {
                                                                phi_3614_ = false;
                                                            } else {
                                                                phi_3614_ = true;
                                                            }
                                                            let _e7058 = phi_3614_;
                                                            phi_3615_ = _e7058;
                                                        } else {
                                                            phi_3615_ = true;
                                                        }
                                                        let _e7060 = phi_3615_;
                                                        if _e7060 {
                                                            let _e7061 = (_e7051 >= _e7048);
                                                            if _e7061 {
                                                                phi_3637_ = f32();
                                                                phi_3638_ = false;
                                                            } else {
                                                                if ((_e7048 - _e7051) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3635_ = (((_e7048 - _e7054) / (_e7048 - _e7051)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3636_ = false;
                                                                } else {
                                                                    phi_3635_ = f32();
                                                                    phi_3636_ = true;
                                                                }
                                                                let _e7072 = phi_3635_;
                                                                let _e7074 = phi_3636_;
                                                                phi_3637_ = _e7072;
                                                                phi_3638_ = _e7074;
                                                            }
                                                            let _e7076 = phi_3637_;
                                                            let _e7078 = phi_3638_;
                                                            phi_3639_ = _e7076;
                                                            phi_3640_ = _e7061;
                                                            phi_3641_ = _e7078;
                                                        } else {
                                                            phi_3639_ = f32();
                                                            phi_3640_ = true;
                                                            phi_3641_ = false;
                                                        }
                                                        let _e7080 = phi_3639_;
                                                        let _e7082 = phi_3640_;
                                                        let _e7084 = phi_3641_;
                                                        if _e7082 {
                                                            phi_3645_ = 2f;
                                                            phi_3646_ = true;
                                                        } else {
                                                            phi_3645_ = _e6457;
                                                            phi_3646_ = _e7084;
                                                        }
                                                        let _e7086 = phi_3645_;
                                                        let _e7088 = phi_3646_;
                                                        if _e7088 {
                                                            phi_3650_ = _e7086;
                                                        } else {
                                                            phi_3650_ = _e7080;
                                                        }
                                                        let _e7090 = phi_3650_;
                                                        let _e7093 = local_16.member[1u];
                                                        let _e7096 = local_16.member_1[1u];
                                                        let _e7099 = local_16.member_2[1u];
                                                        if (_e7093 > _e7099) {
                                                            if (_e7096 > _e7099) {
                                                                phi_3682_ = false;
                                                            } else {
                                                                phi_3682_ = true;
                                                            }
                                                            let _e7103 = phi_3682_;
                                                            phi_3683_ = _e7103;
                                                        } else {
                                                            phi_3683_ = true;
                                                        }
                                                        let _e7105 = phi_3683_;
                                                        if _e7105 {
                                                            let _e7106 = (_e7096 >= _e7093);
                                                            if _e7106 {
                                                                phi_3705_ = f32();
                                                                phi_3706_ = false;
                                                            } else {
                                                                if ((_e7093 - _e7096) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3703_ = (((_e7093 - _e7099) / (_e7093 - _e7096)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3704_ = false;
                                                                } else {
                                                                    phi_3703_ = f32();
                                                                    phi_3704_ = true;
                                                                }
                                                                let _e7117 = phi_3703_;
                                                                let _e7119 = phi_3704_;
                                                                phi_3705_ = _e7117;
                                                                phi_3706_ = _e7119;
                                                            }
                                                            let _e7121 = phi_3705_;
                                                            let _e7123 = phi_3706_;
                                                            phi_3707_ = _e7121;
                                                            phi_3708_ = _e7106;
                                                            phi_3709_ = _e7123;
                                                        } else {
                                                            phi_3707_ = f32();
                                                            phi_3708_ = true;
                                                            phi_3709_ = false;
                                                        }
                                                        let _e7125 = phi_3707_;
                                                        let _e7127 = phi_3708_;
                                                        let _e7129 = phi_3709_;
                                                        if _e7127 {
                                                            phi_3713_ = 2f;
                                                            phi_3714_ = true;
                                                        } else {
                                                            phi_3713_ = _e6457;
                                                            phi_3714_ = _e7129;
                                                        }
                                                        let _e7131 = phi_3713_;
                                                        let _e7133 = phi_3714_;
                                                        if _e7133 {
                                                            phi_3718_ = _e7131;
                                                        } else {
                                                            phi_3718_ = _e7125;
                                                        }
                                                        let _e7135 = phi_3718_;
                                                        if (_e7090 < _e7135) {
                                                            phi_3723_ = _e7090;
                                                        } else {
                                                            phi_3723_ = _e7135;
                                                        }
                                                        let _e7138 = phi_3723_;
                                                        let _e7141 = local_16.member[2u];
                                                        let _e7144 = local_16.member_1[2u];
                                                        let _e7147 = local_16.member_2[2u];
                                                        if (_e7141 > _e7147) {
                                                            if (_e7144 > _e7147) {
                                                                phi_3755_ = false;
                                                            } else {
                                                                phi_3755_ = true;
                                                            }
                                                            let _e7151 = phi_3755_;
                                                            phi_3756_ = _e7151;
                                                        } else {
                                                            phi_3756_ = true;
                                                        }
                                                        let _e7153 = phi_3756_;
                                                        if _e7153 {
                                                            let _e7154 = (_e7144 >= _e7141);
                                                            if _e7154 {
                                                                phi_3778_ = f32();
                                                                phi_3779_ = false;
                                                            } else {
                                                                if ((_e7141 - _e7144) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3776_ = (((_e7141 - _e7147) / (_e7141 - _e7144)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3777_ = false;
                                                                } else {
                                                                    phi_3776_ = f32();
                                                                    phi_3777_ = true;
                                                                }
                                                                let _e7165 = phi_3776_;
                                                                let _e7167 = phi_3777_;
                                                                phi_3778_ = _e7165;
                                                                phi_3779_ = _e7167;
                                                            }
                                                            let _e7169 = phi_3778_;
                                                            let _e7171 = phi_3779_;
                                                            phi_3780_ = _e7169;
                                                            phi_3781_ = _e7154;
                                                            phi_3782_ = _e7171;
                                                        } else {
                                                            phi_3780_ = f32();
                                                            phi_3781_ = true;
                                                            phi_3782_ = false;
                                                        }
                                                        let _e7173 = phi_3780_;
                                                        let _e7175 = phi_3781_;
                                                        let _e7177 = phi_3782_;
                                                        if _e7175 {
                                                            phi_3786_ = 2f;
                                                            phi_3787_ = true;
                                                        } else {
                                                            phi_3786_ = _e6457;
                                                            phi_3787_ = _e7177;
                                                        }
                                                        let _e7179 = phi_3786_;
                                                        let _e7181 = phi_3787_;
                                                        if _e7181 {
                                                            phi_3791_ = _e7179;
                                                        } else {
                                                            phi_3791_ = _e7173;
                                                        }
                                                        let _e7183 = phi_3791_;
                                                        let _e7186 = local_16.member[3u];
                                                        let _e7189 = local_16.member_1[3u];
                                                        let _e7192 = local_16.member_2[3u];
                                                        if (_e7186 > _e7192) {
                                                            if (_e7189 > _e7192) {
                                                                phi_3823_ = false;
                                                            } else {
                                                                phi_3823_ = true;
                                                            }
                                                            let _e7196 = phi_3823_;
                                                            phi_3824_ = _e7196;
                                                        } else {
                                                            phi_3824_ = true;
                                                        }
                                                        let _e7198 = phi_3824_;
                                                        if _e7198 {
                                                            let _e7199 = (_e7189 >= _e7186);
                                                            if _e7199 {
                                                                phi_3846_ = f32();
                                                                phi_3847_ = false;
                                                            } else {
                                                                if ((_e7186 - _e7189) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3844_ = (((_e7186 - _e7192) / (_e7186 - _e7189)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3845_ = false;
                                                                } else {
                                                                    phi_3844_ = f32();
                                                                    phi_3845_ = true;
                                                                }
                                                                let _e7210 = phi_3844_;
                                                                let _e7212 = phi_3845_;
                                                                phi_3846_ = _e7210;
                                                                phi_3847_ = _e7212;
                                                            }
                                                            let _e7214 = phi_3846_;
                                                            let _e7216 = phi_3847_;
                                                            phi_3848_ = _e7214;
                                                            phi_3849_ = _e7199;
                                                            phi_3850_ = _e7216;
                                                        } else {
                                                            phi_3848_ = f32();
                                                            phi_3849_ = true;
                                                            phi_3850_ = false;
                                                        }
                                                        let _e7218 = phi_3848_;
                                                        let _e7220 = phi_3849_;
                                                        let _e7222 = phi_3850_;
                                                        if _e7220 {
                                                            phi_3854_ = 2f;
                                                            phi_3855_ = true;
                                                        } else {
                                                            phi_3854_ = _e6457;
                                                            phi_3855_ = _e7222;
                                                        }
                                                        let _e7224 = phi_3854_;
                                                        let _e7226 = phi_3855_;
                                                        if _e7226 {
                                                            phi_3859_ = _e7224;
                                                        } else {
                                                            phi_3859_ = _e7218;
                                                        }
                                                        let _e7228 = phi_3859_;
                                                        if (_e7183 < _e7228) {
                                                            phi_3864_ = _e7183;
                                                        } else {
                                                            phi_3864_ = _e7228;
                                                        }
                                                        let _e7231 = phi_3864_;
                                                        if (_e7138 < _e7231) {
                                                            phi_3869_ = _e7138;
                                                        } else {
                                                            phi_3869_ = _e7231;
                                                        }
                                                        let _e7234 = phi_3869_;
                                                        if (_e7234 > _e6457) {
                                                            phi_3874_ = _e7234;
                                                        } else {
                                                            phi_3874_ = _e6457;
                                                        }
                                                        let _e7237 = phi_3874_;
                                                        let _e7238 = (_e7237 > _e389);
                                                        if _e7238 {
                                                            phi_4379_ = f32();
                                                            phi_4380_ = f32();
                                                            phi_4381_ = false;
                                                            phi_4382_ = false;
                                                        } else {
                                                            let _e7239 = (_e7237 - _e6457);
                                                            let _e7240 = (_e7239 <= _e6452);
                                                            let _e7242 = (_e7237 + (_e385 * 0.01f));
                                                            if (_e7242 < _e389) {
                                                                phi_3887_ = _e7242;
                                                            } else {
                                                                phi_3887_ = _e389;
                                                            }
                                                            let _e7245 = phi_3887_;
                                                            if _e7240 {
                                                                if (_e655.member_1 > 0f) {
                                                                    let _e7249 = local_18.member[0u];
                                                                    let _e7255 = local_18.member[1u];
                                                                    let _e7271 = local_18.member_1[0u];
                                                                    let _e7277 = local_18.member_1[1u];
                                                                    let _e7293 = local_18.member_2[0u];
                                                                    let _e7299 = local_18.member_2[1u];
                                                                    let _e7313 = function_3(array<f32, 3>((_e7249[0] + ((_e7255[0] - _e7249[0]) * _e7245)), (_e7249[1] + ((_e7255[1] - _e7249[1]) * _e7245)), (_e7249[2] + ((_e7255[2] - _e7249[2]) * _e7245))), array<f32, 3>((_e7271[0] + ((_e7277[0] - _e7271[0]) * _e7245)), (_e7271[1] + ((_e7277[1] - _e7271[1]) * _e7245)), (_e7271[2] + ((_e7277[2] - _e7271[2]) * _e7245))), array<f32, 3>((_e7293[0] + ((_e7299[0] - _e7293[0]) * _e7245)), (_e7293[1] + ((_e7299[1] - _e7293[1]) * _e7245)), (_e7293[2] + ((_e7299[2] - _e7293[2]) * _e7245))), _e245.member);
                                                                    let _e7324 = (((_e7313[0] * _e7313[0]) + (_e7313[1] * _e7313[1])) + (_e7313[2] * _e7313[2]));
                                                                    if (_e7324 <= 0.000000000000000000000000000000000000011754944f) {
                                                                        if (_e7324 > 0f) {
                                                                            phi_4017_ = (0.000000000000000000106433627f * 2f);
                                                                        } else {
                                                                            phi_4017_ = 0f;
                                                                        }
                                                                        let _e7377 = phi_4017_;
                                                                        phi_4081_ = _e7377;
                                                                    } else {
                                                                        phi_4024_ = type_16(0i, 5i);
                                                                        phi_4027_ = bitcast<f32>(((bitcast<u32>(_e7324) >> bitcast<u32>(1i)) + 532369198u));
                                                                        loop {
                                                                            let _e7332 = phi_4024_;
                                                                            let _e7334 = phi_4027_;
                                                                            local_41 = _e7334;
                                                                            if (_e7332.member < _e7332.member_1) {
                                                                                let _e7341 = (_e7332.member + 1i);
                                                                                if ((false == (_e7341 > _e7332.member)) != false) {
                                                                                    phi_4048_ = true;
                                                                                } else {
                                                                                    phi_4048_ = false;
                                                                                }
                                                                                let _e7346 = phi_4048_;
                                                                                if _e7346 {
                                                                                    phi_4054_ = type_17(0u, type_17().member_1);
                                                                                } else {
                                                                                    phi_4054_ = type_17(1u, _e7341);
                                                                                }
                                                                                let _e7351 = phi_4054_;
                                                                                phi_4025_ = type_16(_e7351.member_1, _e7332.member_1);
                                                                                phi_4068_ = type_17(1u, _e7332.member);
                                                                            } else {
                                                                                phi_4025_ = _e7332;
                                                                                phi_4068_ = type_17(0u, type_17().member_1);
                                                                            }
                                                                            let _e7357 = phi_4025_;
                                                                            let _e7359 = phi_4068_;
                                                                            let _e7362 = (bitcast<i32>(_e7359.member) != 0i);
                                                                            if _e7362 {
                                                                                phi_4028_ = (0.5f * (_e7334 + (_e7324 / _e7334)));
                                                                            } else {
                                                                                phi_4028_ = f32();
                                                                            }
                                                                            let _e7367 = phi_4028_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_4024_ = _e7357;
                                                                                phi_4027_ = _e7367;
                                                                                break if !(_e7362);
                                                                            }
                                                                        }
                                                                        let _e7372 = local_41;
                                                                        phi_4081_ = (_e7372 * (1f + (8f * 0.000000059604645f)));
                                                                    }
                                                                    let _e7379 = phi_4081_;
                                                                    let _e7385 = local_18.member[0u];
                                                                    if (_e7385[0] < 0f) {
                                                                        phi_4097_ = -(_e7385[0]);
                                                                    } else {
                                                                        phi_4097_ = _e7385[0];
                                                                    }
                                                                    let _e7392 = phi_4097_;
                                                                    if (_e7385[1] < 0f) {
                                                                        phi_4104_ = -(_e7385[1]);
                                                                    } else {
                                                                        phi_4104_ = _e7385[1];
                                                                    }
                                                                    let _e7396 = phi_4104_;
                                                                    if (_e7392 > _e7396) {
                                                                        phi_4109_ = _e7392;
                                                                    } else {
                                                                        phi_4109_ = _e7396;
                                                                    }
                                                                    let _e7399 = phi_4109_;
                                                                    if (_e7385[2] < 0f) {
                                                                        phi_4116_ = -(_e7385[2]);
                                                                    } else {
                                                                        phi_4116_ = _e7385[2];
                                                                    }
                                                                    let _e7403 = phi_4116_;
                                                                    if (_e7399 > _e7403) {
                                                                        phi_4121_ = _e7399;
                                                                    } else {
                                                                        phi_4121_ = _e7403;
                                                                    }
                                                                    let _e7406 = phi_4121_;
                                                                    let _e7409 = local_18.member[1u];
                                                                    if (_e7409[0] < 0f) {
                                                                        phi_4134_ = -(_e7409[0]);
                                                                    } else {
                                                                        phi_4134_ = _e7409[0];
                                                                    }
                                                                    let _e7416 = phi_4134_;
                                                                    if (_e7409[1] < 0f) {
                                                                        phi_4141_ = -(_e7409[1]);
                                                                    } else {
                                                                        phi_4141_ = _e7409[1];
                                                                    }
                                                                    let _e7420 = phi_4141_;
                                                                    if (_e7416 > _e7420) {
                                                                        phi_4146_ = _e7416;
                                                                    } else {
                                                                        phi_4146_ = _e7420;
                                                                    }
                                                                    let _e7423 = phi_4146_;
                                                                    if (_e7409[2] < 0f) {
                                                                        phi_4153_ = -(_e7409[2]);
                                                                    } else {
                                                                        phi_4153_ = _e7409[2];
                                                                    }
                                                                    let _e7427 = phi_4153_;
                                                                    if (_e7423 > _e7427) {
                                                                        phi_4158_ = _e7423;
                                                                    } else {
                                                                        phi_4158_ = _e7427;
                                                                    }
                                                                    let _e7430 = phi_4158_;
                                                                    if (_e7406 > _e7430) {
                                                                        phi_4163_ = _e7406;
                                                                    } else {
                                                                        phi_4163_ = _e7430;
                                                                    }
                                                                    let _e7433 = phi_4163_;
                                                                    let _e7435 = local_18.member_3;
                                                                    let _e7439 = local_18.member_1[0u];
                                                                    if (_e7439[0] < 0f) {
                                                                        phi_4180_ = -(_e7439[0]);
                                                                    } else {
                                                                        phi_4180_ = _e7439[0];
                                                                    }
                                                                    let _e7446 = phi_4180_;
                                                                    if (_e7439[1] < 0f) {
                                                                        phi_4187_ = -(_e7439[1]);
                                                                    } else {
                                                                        phi_4187_ = _e7439[1];
                                                                    }
                                                                    let _e7450 = phi_4187_;
                                                                    if (_e7446 > _e7450) {
                                                                        phi_4192_ = _e7446;
                                                                    } else {
                                                                        phi_4192_ = _e7450;
                                                                    }
                                                                    let _e7453 = phi_4192_;
                                                                    if (_e7439[2] < 0f) {
                                                                        phi_4199_ = -(_e7439[2]);
                                                                    } else {
                                                                        phi_4199_ = _e7439[2];
                                                                    }
                                                                    let _e7457 = phi_4199_;
                                                                    if (_e7453 > _e7457) {
                                                                        phi_4204_ = _e7453;
                                                                    } else {
                                                                        phi_4204_ = _e7457;
                                                                    }
                                                                    let _e7460 = phi_4204_;
                                                                    let _e7463 = local_18.member_1[1u];
                                                                    if (_e7463[0] < 0f) {
                                                                        phi_4218_ = -(_e7463[0]);
                                                                    } else {
                                                                        phi_4218_ = _e7463[0];
                                                                    }
                                                                    let _e7470 = phi_4218_;
                                                                    if (_e7463[1] < 0f) {
                                                                        phi_4225_ = -(_e7463[1]);
                                                                    } else {
                                                                        phi_4225_ = _e7463[1];
                                                                    }
                                                                    let _e7474 = phi_4225_;
                                                                    if (_e7470 > _e7474) {
                                                                        phi_4230_ = _e7470;
                                                                    } else {
                                                                        phi_4230_ = _e7474;
                                                                    }
                                                                    let _e7477 = phi_4230_;
                                                                    if (_e7463[2] < 0f) {
                                                                        phi_4237_ = -(_e7463[2]);
                                                                    } else {
                                                                        phi_4237_ = _e7463[2];
                                                                    }
                                                                    let _e7481 = phi_4237_;
                                                                    if (_e7477 > _e7481) {
                                                                        phi_4242_ = _e7477;
                                                                    } else {
                                                                        phi_4242_ = _e7481;
                                                                    }
                                                                    let _e7484 = phi_4242_;
                                                                    if (_e7460 > _e7484) {
                                                                        phi_4247_ = _e7460;
                                                                    } else {
                                                                        phi_4247_ = _e7484;
                                                                    }
                                                                    let _e7487 = phi_4247_;
                                                                    let _e7489 = local_18.member_3;
                                                                    let _e7493 = local_18.member_2[0u];
                                                                    if (_e7493[0] < 0f) {
                                                                        phi_4264_ = -(_e7493[0]);
                                                                    } else {
                                                                        phi_4264_ = _e7493[0];
                                                                    }
                                                                    let _e7500 = phi_4264_;
                                                                    if (_e7493[1] < 0f) {
                                                                        phi_4271_ = -(_e7493[1]);
                                                                    } else {
                                                                        phi_4271_ = _e7493[1];
                                                                    }
                                                                    let _e7504 = phi_4271_;
                                                                    if (_e7500 > _e7504) {
                                                                        phi_4276_ = _e7500;
                                                                    } else {
                                                                        phi_4276_ = _e7504;
                                                                    }
                                                                    let _e7507 = phi_4276_;
                                                                    if (_e7493[2] < 0f) {
                                                                        phi_4283_ = -(_e7493[2]);
                                                                    } else {
                                                                        phi_4283_ = _e7493[2];
                                                                    }
                                                                    let _e7511 = phi_4283_;
                                                                    if (_e7507 > _e7511) {
                                                                        phi_4288_ = _e7507;
                                                                    } else {
                                                                        phi_4288_ = _e7511;
                                                                    }
                                                                    let _e7514 = phi_4288_;
                                                                    let _e7517 = local_18.member_2[1u];
                                                                    if (_e7517[0] < 0f) {
                                                                        phi_4302_ = -(_e7517[0]);
                                                                    } else {
                                                                        phi_4302_ = _e7517[0];
                                                                    }
                                                                    let _e7524 = phi_4302_;
                                                                    if (_e7517[1] < 0f) {
                                                                        phi_4309_ = -(_e7517[1]);
                                                                    } else {
                                                                        phi_4309_ = _e7517[1];
                                                                    }
                                                                    let _e7528 = phi_4309_;
                                                                    if (_e7524 > _e7528) {
                                                                        phi_4314_ = _e7524;
                                                                    } else {
                                                                        phi_4314_ = _e7528;
                                                                    }
                                                                    let _e7531 = phi_4314_;
                                                                    if (_e7517[2] < 0f) {
                                                                        phi_4321_ = -(_e7517[2]);
                                                                    } else {
                                                                        phi_4321_ = _e7517[2];
                                                                    }
                                                                    let _e7535 = phi_4321_;
                                                                    if (_e7531 > _e7535) {
                                                                        phi_4326_ = _e7531;
                                                                    } else {
                                                                        phi_4326_ = _e7535;
                                                                    }
                                                                    let _e7538 = phi_4326_;
                                                                    if (_e7514 > _e7538) {
                                                                        phi_4331_ = _e7514;
                                                                    } else {
                                                                        phi_4331_ = _e7538;
                                                                    }
                                                                    let _e7541 = phi_4331_;
                                                                    let _e7543 = local_18.member_3;
                                                                    let _e7550 = local_18.member_3;
                                                                    if (((_e7379 * (1f + (0.000000059604645f * 8f))) + (((((((_e7433 + _e7435) + (_e7487 + _e7489)) + (_e7541 + _e7543)) * (0.000000059604645f * 16f)) + (_e7550 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e655.member_1) {
                                                                        phi_4351_ = false;
                                                                    } else {
                                                                        phi_4351_ = true;
                                                                    }
                                                                    let _e7559 = phi_4351_;
                                                                    phi_4352_ = _e7559;
                                                                } else {
                                                                    phi_4352_ = true;
                                                                }
                                                                let _e7561 = phi_4352_;
                                                                phi_4353_ = _e7561;
                                                            } else {
                                                                phi_4353_ = true;
                                                            }
                                                            let _e7563 = phi_4353_;
                                                            if _e7563 {
                                                                if _e6465 {
                                                                    if _e7240 {
                                                                        phi_4369_ = true;
                                                                    } else {
                                                                        if (_e7239 <= (_e6461 * 0.25f)) {
                                                                            phi_4368_ = false;
                                                                        } else {
                                                                            phi_4368_ = true;
                                                                        }
                                                                        let _e7568 = phi_4368_;
                                                                        phi_4369_ = _e7568;
                                                                    }
                                                                    let _e7570 = phi_4369_;
                                                                    if _e7570 {
                                                                        phi_4374_ = (_e6785 + _e6785);
                                                                    } else {
                                                                        phi_4374_ = 0f;
                                                                    }
                                                                    let _e7573 = phi_4374_;
                                                                    phi_4376_ = _e7573;
                                                                } else {
                                                                    phi_4376_ = (_e389 - _e6457);
                                                                }
                                                                let _e7575 = phi_4376_;
                                                                phi_4377_ = _e7575;
                                                                phi_4378_ = false;
                                                            } else {
                                                                phi_4377_ = f32();
                                                                phi_4378_ = true;
                                                            }
                                                            let _e7577 = phi_4377_;
                                                            let _e7579 = phi_4378_;
                                                            phi_4379_ = _e7577;
                                                            phi_4380_ = _e7239;
                                                            phi_4381_ = _e7563;
                                                            phi_4382_ = _e7579;
                                                        }
                                                        let _e7581 = phi_4379_;
                                                        let _e7583 = phi_4380_;
                                                        let _e7585 = phi_4381_;
                                                        let _e7587 = phi_4382_;
                                                        phi_4383_ = _e7237;
                                                        phi_4384_ = _e7581;
                                                        phi_4385_ = _e7583;
                                                        phi_4386_ = _e7237;
                                                        phi_4387_ = _e7585;
                                                        phi_4388_ = _e7238;
                                                        phi_4389_ = _e7587;
                                                        phi_4390_ = false;
                                                    } else {
                                                        phi_4383_ = f32();
                                                        phi_4384_ = f32();
                                                        phi_4385_ = f32();
                                                        phi_4386_ = f32();
                                                        phi_4387_ = false;
                                                        phi_4388_ = false;
                                                        phi_4389_ = false;
                                                        phi_4390_ = true;
                                                    }
                                                    let _e7589 = phi_4383_;
                                                    let _e7591 = phi_4384_;
                                                    let _e7593 = phi_4385_;
                                                    let _e7595 = phi_4386_;
                                                    let _e7597 = phi_4387_;
                                                    let _e7599 = phi_4388_;
                                                    let _e7601 = phi_4389_;
                                                    let _e7603 = phi_4390_;
                                                    phi_4391_ = _e7589;
                                                    phi_4392_ = _e7591;
                                                    phi_4393_ = _e7593;
                                                    phi_4394_ = _e7595;
                                                    phi_4395_ = false;
                                                    phi_4396_ = _e7597;
                                                    phi_4397_ = _e7599;
                                                    phi_4398_ = _e7601;
                                                    phi_4399_ = _e7603;
                                                } else {
                                                    phi_4391_ = f32();
                                                    phi_4392_ = f32();
                                                    phi_4393_ = f32();
                                                    phi_4394_ = f32();
                                                    phi_4395_ = true;
                                                    phi_4396_ = false;
                                                    phi_4397_ = false;
                                                    phi_4398_ = false;
                                                    phi_4399_ = false;
                                                }
                                                let _e7605 = phi_4391_;
                                                let _e7607 = phi_4392_;
                                                let _e7609 = phi_4393_;
                                                let _e7611 = phi_4394_;
                                                let _e7613 = phi_4395_;
                                                let _e7615 = phi_4396_;
                                                let _e7617 = phi_4397_;
                                                let _e7619 = phi_4398_;
                                                let _e7621 = phi_4399_;
                                                phi_4400_ = _e7605;
                                                phi_4401_ = _e7607;
                                                phi_4402_ = _e7609;
                                                phi_4403_ = _e7611;
                                                phi_4404_ = _e7613;
                                                phi_4405_ = _e7615;
                                                phi_4406_ = _e7617;
                                                phi_4407_ = _e7619;
                                                phi_4408_ = _e7621;
                                            } else {
                                                phi_4400_ = f32();
                                                phi_4401_ = f32();
                                                phi_4402_ = f32();
                                                phi_4403_ = f32();
                                                phi_4404_ = true;
                                                phi_4405_ = false;
                                                phi_4406_ = false;
                                                phi_4407_ = false;
                                                phi_4408_ = false;
                                            }
                                            let _e7623 = phi_4400_;
                                            let _e7625 = phi_4401_;
                                            let _e7627 = phi_4402_;
                                            let _e7629 = phi_4403_;
                                            let _e7631 = phi_4404_;
                                            let _e7633 = phi_4405_;
                                            let _e7635 = phi_4406_;
                                            let _e7637 = phi_4407_;
                                            let _e7639 = phi_4408_;
                                            if _e7631 {
                                                if (_e6457 <= _e6459) {
                                                    let _e7800 = (_e6467 + 1u);
                                                    let _e7801 = (_e7800 > 3u);
                                                    if _e7801 {
                                                        phi_4421_ = false;
                                                    } else {
                                                        phi_4421_ = true;
                                                    }
                                                    let _e7803 = phi_4421_;
                                                    phi_4743_ = _e7800;
                                                    phi_4744_ = f32();
                                                    phi_4745_ = false;
                                                    phi_4746_ = _e7803;
                                                    phi_4747_ = _e7801;
                                                } else {
                                                    let _e7643 = local_16.member[0u];
                                                    let _e7646 = local_16.member_1[0u];
                                                    let _e7649 = local_16.member[0u];
                                                    let _e7655 = local_16.member_2[0u];
                                                    let _e7656 = ((_e7643 + ((_e7646 - _e7649) * _e6463)) - _e7655);
                                                    let _e7659 = local_16.member[1u];
                                                    let _e7662 = local_16.member_1[1u];
                                                    let _e7665 = local_16.member[1u];
                                                    let _e7671 = local_16.member_2[1u];
                                                    let _e7672 = ((_e7659 + ((_e7662 - _e7665) * _e6463)) - _e7671);
                                                    if (_e7656 < _e7672) {
                                                        phi_4494_ = _e7656;
                                                    } else {
                                                        phi_4494_ = _e7672;
                                                    }
                                                    let _e7675 = phi_4494_;
                                                    let _e7678 = local_16.member[2u];
                                                    let _e7681 = local_16.member_1[2u];
                                                    let _e7684 = local_16.member[2u];
                                                    let _e7690 = local_16.member_2[2u];
                                                    let _e7691 = ((_e7678 + ((_e7681 - _e7684) * _e6463)) - _e7690);
                                                    let _e7694 = local_16.member[3u];
                                                    let _e7697 = local_16.member_1[3u];
                                                    let _e7700 = local_16.member[3u];
                                                    let _e7706 = local_16.member_2[3u];
                                                    let _e7707 = ((_e7694 + ((_e7697 - _e7700) * _e6463)) - _e7706);
                                                    if (_e7691 < _e7707) {
                                                        phi_4567_ = _e7691;
                                                    } else {
                                                        phi_4567_ = _e7707;
                                                    }
                                                    let _e7710 = phi_4567_;
                                                    if (_e7675 < _e7710) {
                                                        phi_4572_ = _e7675;
                                                    } else {
                                                        phi_4572_ = _e7710;
                                                    }
                                                    let _e7713 = phi_4572_;
                                                    let _e7716 = local_17.member[0u];
                                                    let _e7719 = local_17.member_1[0u];
                                                    let _e7722 = local_17.member[0u];
                                                    let _e7728 = local_17.member_2[0u];
                                                    let _e7729 = ((_e7716 + ((_e7719 - _e7722) * _e6457)) - _e7728);
                                                    let _e7732 = local_17.member[1u];
                                                    let _e7735 = local_17.member_1[1u];
                                                    let _e7738 = local_17.member[1u];
                                                    let _e7744 = local_17.member_2[1u];
                                                    let _e7745 = ((_e7732 + ((_e7735 - _e7738) * _e6457)) - _e7744);
                                                    if (_e7729 < _e7745) {
                                                        phi_4645_ = _e7729;
                                                    } else {
                                                        phi_4645_ = _e7745;
                                                    }
                                                    let _e7748 = phi_4645_;
                                                    let _e7751 = local_17.member[2u];
                                                    let _e7754 = local_17.member_1[2u];
                                                    let _e7757 = local_17.member[2u];
                                                    let _e7763 = local_17.member_2[2u];
                                                    let _e7764 = ((_e7751 + ((_e7754 - _e7757) * _e6457)) - _e7763);
                                                    let _e7767 = local_17.member[3u];
                                                    let _e7770 = local_17.member_1[3u];
                                                    let _e7773 = local_17.member[3u];
                                                    let _e7779 = local_17.member_2[3u];
                                                    let _e7780 = ((_e7767 + ((_e7770 - _e7773) * _e6457)) - _e7779);
                                                    if (_e7764 < _e7780) {
                                                        phi_4718_ = _e7764;
                                                    } else {
                                                        phi_4718_ = _e7780;
                                                    }
                                                    let _e7783 = phi_4718_;
                                                    if (_e7748 < _e7783) {
                                                        phi_4723_ = _e7748;
                                                    } else {
                                                        phi_4723_ = _e7783;
                                                    }
                                                    let _e7786 = phi_4723_;
                                                    if (_e7786 > 0f) {
                                                        phi_4741_ = 0.5f;
                                                    } else {
                                                        let _e7790 = (0.95f * (_e7713 / (_e7713 - _e7786)));
                                                        if (_e7790 > 0.0625f) {
                                                            if (_e7790 < 0.9f) {
                                                                phi_4739_ = _e7790;
                                                            } else {
                                                                phi_4739_ = 0.9f;
                                                            }
                                                            let _e7794 = phi_4739_;
                                                            phi_4740_ = _e7794;
                                                        } else {
                                                            phi_4740_ = 0.0625f;
                                                        }
                                                        let _e7796 = phi_4740_;
                                                        phi_4741_ = _e7796;
                                                    }
                                                    let _e7798 = phi_4741_;
                                                    phi_4743_ = u32();
                                                    phi_4744_ = (_e6785 * _e7798);
                                                    phi_4745_ = true;
                                                    phi_4746_ = false;
                                                    phi_4747_ = false;
                                                }
                                                let _e7805 = phi_4743_;
                                                let _e7807 = phi_4744_;
                                                let _e7809 = phi_4745_;
                                                let _e7811 = phi_4746_;
                                                let _e7813 = phi_4747_;
                                                phi_4748_ = _e7805;
                                                phi_4749_ = _e6459;
                                                phi_4750_ = _e7807;
                                                phi_4751_ = _e6461;
                                                phi_4752_ = _e6463;
                                                phi_4753_ = _e6465;
                                                phi_4754_ = _e6467;
                                                phi_4755_ = _e7809;
                                                phi_4756_ = _e7811;
                                                phi_4757_ = _e7813;
                                                phi_4758_ = false;
                                                phi_4759_ = false;
                                                phi_4760_ = false;
                                            } else {
                                                phi_4748_ = u32();
                                                phi_4749_ = _e7623;
                                                phi_4750_ = _e7625;
                                                phi_4751_ = _e7627;
                                                phi_4752_ = _e6457;
                                                phi_4753_ = true;
                                                phi_4754_ = 0u;
                                                phi_4755_ = _e7633;
                                                phi_4756_ = false;
                                                phi_4757_ = false;
                                                phi_4758_ = _e7635;
                                                phi_4759_ = _e7637;
                                                phi_4760_ = _e7639;
                                            }
                                            let _e7815 = phi_4748_;
                                            let _e7817 = phi_4749_;
                                            let _e7819 = phi_4750_;
                                            let _e7821 = phi_4751_;
                                            let _e7823 = phi_4752_;
                                            let _e7825 = phi_4753_;
                                            let _e7827 = phi_4754_;
                                            let _e7829 = phi_4755_;
                                            let _e7831 = phi_4756_;
                                            let _e7833 = phi_4757_;
                                            let _e7835 = phi_4758_;
                                            let _e7837 = phi_4759_;
                                            let _e7839 = phi_4760_;
                                            if _e7829 {
                                                let _e7840 = (_e7823 + _e7819);
                                                if (_e7840 > _e7817) {
                                                    phi_4769_ = _e7840;
                                                } else {
                                                    phi_4769_ = _e7817;
                                                }
                                                let _e7843 = phi_4769_;
                                                if (_e7843 < _e389) {
                                                    phi_4774_ = _e7843;
                                                } else {
                                                    phi_4774_ = _e389;
                                                }
                                                let _e7846 = phi_4774_;
                                                if !(_e6465) {
                                                    phi_4783_ = true;
                                                } else {
                                                    phi_4783_ = ((_e7846 - _e7823) > _e6452);
                                                }
                                                let _e7850 = phi_4783_;
                                                if _e7850 {
                                                    phi_4787_ = false;
                                                } else {
                                                    phi_4787_ = true;
                                                }
                                                let _e7852 = phi_4787_;
                                                phi_4788_ = _e7846;
                                                phi_4789_ = _e7817;
                                                phi_4790_ = _e7821;
                                                phi_4791_ = _e7823;
                                                phi_4792_ = _e7825;
                                                phi_4793_ = _e7827;
                                                phi_4794_ = _e7850;
                                                phi_4795_ = _e7852;
                                                phi_4796_ = false;
                                                phi_4797_ = false;
                                                phi_4798_ = false;
                                                phi_4799_ = false;
                                            } else {
                                                phi_4788_ = _e6457;
                                                phi_4789_ = _e6459;
                                                phi_4790_ = _e6461;
                                                phi_4791_ = _e6463;
                                                phi_4792_ = _e6465;
                                                phi_4793_ = _e7815;
                                                phi_4794_ = _e7831;
                                                phi_4795_ = false;
                                                phi_4796_ = _e7833;
                                                phi_4797_ = _e7835;
                                                phi_4798_ = _e7837;
                                                phi_4799_ = _e7839;
                                            }
                                            let _e7854 = phi_4788_;
                                            let _e7856 = phi_4789_;
                                            let _e7858 = phi_4790_;
                                            let _e7860 = phi_4791_;
                                            let _e7862 = phi_4792_;
                                            let _e7864 = phi_4793_;
                                            let _e7866 = phi_4794_;
                                            let _e7868 = phi_4795_;
                                            let _e7870 = phi_4796_;
                                            let _e7872 = phi_4797_;
                                            let _e7874 = phi_4798_;
                                            let _e7876 = phi_4799_;
                                            phi_2621_ = _e7854;
                                            phi_2623_ = _e7856;
                                            phi_2625_ = _e7858;
                                            phi_2627_ = _e7860;
                                            phi_2629_ = _e7862;
                                            phi_2631_ = _e7864;
                                            phi_4800_ = _e7817;
                                            phi_4801_ = _e7629;
                                            phi_4802_ = _e7866;
                                            phi_4803_ = _e7868;
                                            phi_4804_ = _e7870;
                                            phi_4805_ = _e7872;
                                            phi_4806_ = _e7874;
                                            phi_4807_ = false;
                                            phi_4808_ = _e7876;
                                        } else {
                                            phi_2621_ = f32();
                                            phi_2623_ = f32();
                                            phi_2625_ = f32();
                                            phi_2627_ = f32();
                                            phi_2629_ = bool();
                                            phi_2631_ = u32();
                                            phi_4800_ = f32();
                                            phi_4801_ = f32();
                                            phi_4802_ = false;
                                            phi_4803_ = false;
                                            phi_4804_ = false;
                                            phi_4805_ = false;
                                            phi_4806_ = false;
                                            phi_4807_ = true;
                                            phi_4808_ = false;
                                        }
                                        let _e7878 = phi_2621_;
                                        let _e7880 = phi_2623_;
                                        let _e7882 = phi_2625_;
                                        let _e7884 = phi_2627_;
                                        let _e7886 = phi_2629_;
                                        let _e7888 = phi_2631_;
                                        let _e7890 = phi_4800_;
                                        let _e7892 = phi_4801_;
                                        let _e7894 = phi_4802_;
                                        let _e7896 = phi_4803_;
                                        let _e7898 = phi_4804_;
                                        let _e7900 = phi_4805_;
                                        let _e7902 = phi_4806_;
                                        let _e7904 = phi_4807_;
                                        let _e7906 = phi_4808_;
                                        local_42 = _e7896;
                                        local_78 = _e7898;
                                        local_79 = _e7900;
                                        local_80 = _e7902;
                                        local_81 = _e7904;
                                        local_82 = _e7906;
                                        local_83 = _e7896;
                                        local_84 = _e7892;
                                        local_85 = _e7890;
                                        continue;
                                        continuing {
                                            phi_2617_ = _e6479;
                                            phi_2620_ = _e7878;
                                            phi_2622_ = _e7880;
                                            phi_2624_ = _e7882;
                                            phi_2626_ = _e7884;
                                            phi_2628_ = _e7886;
                                            phi_2630_ = _e7888;
                                            break if !(_e7894);
                                        }
                                    }
                                    let _e7909 = local_42;
                                    if _e7909 {
                                        phi_4812_ = false;
                                        phi_4813_ = false;
                                        phi_4814_ = false;
                                        phi_4815_ = false;
                                        phi_4816_ = false;
                                    } else {
                                        let _e11376 = local_78;
                                        phi_4812_ = _e11376;
                                        let _e11379 = local_79;
                                        phi_4813_ = _e11379;
                                        let _e11382 = local_80;
                                        phi_4814_ = _e11382;
                                        let _e11385 = local_81;
                                        phi_4815_ = _e11385;
                                        let _e11388 = local_82;
                                        phi_4816_ = _e11388;
                                    }
                                    let _e7911 = phi_4812_;
                                    let _e7913 = phi_4813_;
                                    let _e7915 = phi_4814_;
                                    let _e7917 = phi_4815_;
                                    let _e7919 = phi_4816_;
                                    if _e7911 {
                                        let _e7921 = local_43;
                                        phi_4821_ = type_37(1u, _e7921);
                                        phi_4822_ = false;
                                        phi_4823_ = false;
                                        phi_4824_ = false;
                                        phi_4825_ = false;
                                        phi_4826_ = false;
                                    } else {
                                        phi_4821_ = type_37();
                                        phi_4822_ = _e7913;
                                        phi_4823_ = _e7915;
                                        let _e11395 = local_83;
                                        phi_4824_ = _e11395;
                                        phi_4825_ = _e7917;
                                        phi_4826_ = _e7919;
                                    }
                                    let _e7924 = phi_4821_;
                                    let _e7926 = phi_4822_;
                                    let _e7928 = phi_4823_;
                                    let _e7930 = phi_4824_;
                                    let _e7932 = phi_4825_;
                                    let _e7934 = phi_4826_;
                                    if _e7926 {
                                        phi_4831_ = type_37(0u, type_37().member_1);
                                        phi_4832_ = false;
                                        phi_4833_ = false;
                                        phi_4834_ = false;
                                        phi_4835_ = false;
                                        phi_4836_ = true;
                                    } else {
                                        phi_4831_ = _e7924;
                                        phi_4832_ = _e7928;
                                        phi_4833_ = _e7930;
                                        phi_4834_ = _e7932;
                                        phi_4835_ = _e7934;
                                        phi_4836_ = _e7911;
                                    }
                                    let _e7938 = phi_4831_;
                                    let _e7940 = phi_4832_;
                                    let _e7942 = phi_4833_;
                                    let _e7944 = phi_4834_;
                                    let _e7946 = phi_4835_;
                                    let _e7948 = phi_4836_;
                                    if _e7940 {
                                        let _e11406 = local_84;
                                        phi_4840_ = _e11406;
                                        phi_4841_ = true;
                                        phi_4842_ = false;
                                        phi_4843_ = false;
                                        phi_4844_ = false;
                                    } else {
                                        let _e11408 = local_85;
                                        phi_4840_ = _e11408;
                                        phi_4841_ = _e7942;
                                        phi_4842_ = _e7944;
                                        phi_4843_ = _e7946;
                                        phi_4844_ = _e7948;
                                    }
                                    let _e7950 = phi_4840_;
                                    let _e7952 = phi_4841_;
                                    let _e7954 = phi_4842_;
                                    let _e7956 = phi_4843_;
                                    let _e7958 = phi_4844_;
                                    if _e7952 {
                                        phi_4848_ = _e7950;
                                        phi_4849_ = true;
                                        phi_4850_ = false;
                                        phi_4851_ = false;
                                    } else {
                                        let _e11415 = local_86;
                                        phi_4848_ = _e11415;
                                        phi_4849_ = _e7954;
                                        phi_4850_ = _e7956;
                                        phi_4851_ = _e7958;
                                    }
                                    let _e7960 = phi_4848_;
                                    let _e7962 = phi_4849_;
                                    let _e7964 = phi_4850_;
                                    let _e7966 = phi_4851_;
                                    if _e7962 {
                                        phi_4856_ = type_37(1u, _e7960);
                                        phi_4857_ = false;
                                        phi_4858_ = false;
                                    } else {
                                        phi_4856_ = type_37();
                                        phi_4857_ = _e7964;
                                        phi_4858_ = _e7966;
                                    }
                                    let _e7969 = phi_4856_;
                                    let _e7971 = phi_4857_;
                                    let _e7973 = phi_4858_;
                                    if _e7971 {
                                        phi_4863_ = type_37(0u, type_37().member_1);
                                        phi_4864_ = true;
                                    } else {
                                        phi_4863_ = _e7938;
                                        phi_4864_ = _e7973;
                                    }
                                    let _e7977 = phi_4863_;
                                    let _e7979 = phi_4864_;
                                    if _e7979 {
                                        phi_4868_ = _e7977;
                                    } else {
                                        phi_4868_ = _e7969;
                                    }
                                    let _e7981 = phi_4868_;
                                    phi_4875_ = _e7981.member_1;
                                    phi_4876_ = (_e7981.member != 0u);
                                } else {
                                    phi_4875_ = _e6177;
                                    phi_4876_ = true;
                                }
                                let _e7986 = phi_4875_;
                                let _e7988 = phi_4876_;
                                if _e7988 {
                                    let _e7989 = (_e7986 > _e387);
                                    if _e7989 {
                                        phi_7041_ = f32();
                                        phi_7042_ = u32();
                                        phi_7043_ = f32();
                                        phi_7044_ = type_39();
                                        phi_7045_ = u32();
                                        phi_7046_ = u32();
                                        phi_7047_ = false;
                                        phi_7048_ = false;
                                        phi_7049_ = false;
                                    } else {
                                        let _e7992 = local_18.member[0u];
                                        let _e7998 = local_18.member[1u];
                                        let _e8014 = local_18.member_1[0u];
                                        let _e8020 = local_18.member_1[1u];
                                        let _e8036 = local_18.member_2[0u];
                                        let _e8042 = local_18.member_2[1u];
                                        let _e8056 = function_3(array<f32, 3>((_e7992[0] + ((_e7998[0] - _e7992[0]) * _e6181)), (_e7992[1] + ((_e7998[1] - _e7992[1]) * _e6181)), (_e7992[2] + ((_e7998[2] - _e7992[2]) * _e6181))), array<f32, 3>((_e8014[0] + ((_e8020[0] - _e8014[0]) * _e6181)), (_e8014[1] + ((_e8020[1] - _e8014[1]) * _e6181)), (_e8014[2] + ((_e8020[2] - _e8014[2]) * _e6181))), array<f32, 3>((_e8036[0] + ((_e8042[0] - _e8036[0]) * _e6181)), (_e8036[1] + ((_e8042[1] - _e8036[1]) * _e6181)), (_e8036[2] + ((_e8042[2] - _e8036[2]) * _e6181))), _e245.member);
                                        if (_e8056[0] < 0f) {
                                            phi_4988_ = -(_e8056[0]);
                                        } else {
                                            phi_4988_ = _e8056[0];
                                        }
                                        let _e8061 = phi_4988_;
                                        if (_e8056[1] < 0f) {
                                            phi_4995_ = -(_e8056[1]);
                                        } else {
                                            phi_4995_ = _e8056[1];
                                        }
                                        let _e8066 = phi_4995_;
                                        if (_e8056[2] < 0f) {
                                            phi_5003_ = -(_e8056[2]);
                                        } else {
                                            phi_5003_ = _e8056[2];
                                        }
                                        let _e8072 = phi_5003_;
                                        let _e8073 = ((_e8061 + _e8066) + _e8072);
                                        let _e8076 = local_18.member[0u];
                                        let _e8083 = local_18.member_1[0u];
                                        let _e8089 = local_18.member_2[0u];
                                        let _e8093 = (_e8076[0] - _e8083[0]);
                                        let _e8094 = (_e8076[1] - _e8083[1]);
                                        let _e8095 = (_e8076[2] - _e8083[2]);
                                        if (_e245.member == 0u) {
                                            phi_5061_ = array<f32, 3>(_e8076[0], _e8076[1], _e8076[2]);
                                        } else {
                                            phi_5061_ = array<f32, 3>((_e8093 - _e8089[0]), (_e8094 - _e8089[1]), (_e8095 - _e8089[2]));
                                        }
                                        let _e8102 = phi_5061_;
                                        let _e8108 = local_18.member[1u];
                                        let _e8115 = local_18.member_1[1u];
                                        let _e8121 = local_18.member_2[1u];
                                        let _e8125 = (_e8108[0] - _e8115[0]);
                                        let _e8126 = (_e8108[1] - _e8115[1]);
                                        let _e8127 = (_e8108[2] - _e8115[2]);
                                        if (_e245.member == 0u) {
                                            phi_5129_ = array<f32, 3>(_e8108[0], _e8108[1], _e8108[2]);
                                        } else {
                                            phi_5129_ = array<f32, 3>((_e8125 - _e8121[0]), (_e8126 - _e8121[1]), (_e8127 - _e8121[2]));
                                        }
                                        let _e8134 = phi_5129_;
                                        let _e8140 = local_18.member[0u];
                                        if (_e8140[0] < 0f) {
                                            phi_5154_ = -(_e8140[0]);
                                        } else {
                                            phi_5154_ = _e8140[0];
                                        }
                                        let _e8147 = phi_5154_;
                                        if (_e8140[1] < 0f) {
                                            phi_5161_ = -(_e8140[1]);
                                        } else {
                                            phi_5161_ = _e8140[1];
                                        }
                                        let _e8151 = phi_5161_;
                                        if (_e8147 > _e8151) {
                                            phi_5166_ = _e8147;
                                        } else {
                                            phi_5166_ = _e8151;
                                        }
                                        let _e8154 = phi_5166_;
                                        if (_e8140[2] < 0f) {
                                            phi_5173_ = -(_e8140[2]);
                                        } else {
                                            phi_5173_ = _e8140[2];
                                        }
                                        let _e8158 = phi_5173_;
                                        if (_e8154 > _e8158) {
                                            phi_5178_ = _e8154;
                                        } else {
                                            phi_5178_ = _e8158;
                                        }
                                        let _e8161 = phi_5178_;
                                        let _e8164 = local_18.member[1u];
                                        if (_e8164[0] < 0f) {
                                            phi_5191_ = -(_e8164[0]);
                                        } else {
                                            phi_5191_ = _e8164[0];
                                        }
                                        let _e8171 = phi_5191_;
                                        if (_e8164[1] < 0f) {
                                            phi_5198_ = -(_e8164[1]);
                                        } else {
                                            phi_5198_ = _e8164[1];
                                        }
                                        let _e8175 = phi_5198_;
                                        if (_e8171 > _e8175) {
                                            phi_5203_ = _e8171;
                                        } else {
                                            phi_5203_ = _e8175;
                                        }
                                        let _e8178 = phi_5203_;
                                        if (_e8164[2] < 0f) {
                                            phi_5210_ = -(_e8164[2]);
                                        } else {
                                            phi_5210_ = _e8164[2];
                                        }
                                        let _e8182 = phi_5210_;
                                        if (_e8178 > _e8182) {
                                            phi_5215_ = _e8178;
                                        } else {
                                            phi_5215_ = _e8182;
                                        }
                                        let _e8185 = phi_5215_;
                                        if (_e8161 > _e8185) {
                                            phi_5220_ = _e8161;
                                        } else {
                                            phi_5220_ = _e8185;
                                        }
                                        let _e8188 = phi_5220_;
                                        let _e8190 = local_18.member_3;
                                        let _e8194 = local_18.member_1[0u];
                                        if (_e8194[0] < 0f) {
                                            phi_5237_ = -(_e8194[0]);
                                        } else {
                                            phi_5237_ = _e8194[0];
                                        }
                                        let _e8201 = phi_5237_;
                                        if (_e8194[1] < 0f) {
                                            phi_5244_ = -(_e8194[1]);
                                        } else {
                                            phi_5244_ = _e8194[1];
                                        }
                                        let _e8205 = phi_5244_;
                                        if (_e8201 > _e8205) {
                                            phi_5249_ = _e8201;
                                        } else {
                                            phi_5249_ = _e8205;
                                        }
                                        let _e8208 = phi_5249_;
                                        if (_e8194[2] < 0f) {
                                            phi_5256_ = -(_e8194[2]);
                                        } else {
                                            phi_5256_ = _e8194[2];
                                        }
                                        let _e8212 = phi_5256_;
                                        if (_e8208 > _e8212) {
                                            phi_5261_ = _e8208;
                                        } else {
                                            phi_5261_ = _e8212;
                                        }
                                        let _e8215 = phi_5261_;
                                        let _e8218 = local_18.member_1[1u];
                                        if (_e8218[0] < 0f) {
                                            phi_5275_ = -(_e8218[0]);
                                        } else {
                                            phi_5275_ = _e8218[0];
                                        }
                                        let _e8225 = phi_5275_;
                                        if (_e8218[1] < 0f) {
                                            phi_5282_ = -(_e8218[1]);
                                        } else {
                                            phi_5282_ = _e8218[1];
                                        }
                                        let _e8229 = phi_5282_;
                                        if (_e8225 > _e8229) {
                                            phi_5287_ = _e8225;
                                        } else {
                                            phi_5287_ = _e8229;
                                        }
                                        let _e8232 = phi_5287_;
                                        if (_e8218[2] < 0f) {
                                            phi_5294_ = -(_e8218[2]);
                                        } else {
                                            phi_5294_ = _e8218[2];
                                        }
                                        let _e8236 = phi_5294_;
                                        if (_e8232 > _e8236) {
                                            phi_5299_ = _e8232;
                                        } else {
                                            phi_5299_ = _e8236;
                                        }
                                        let _e8239 = phi_5299_;
                                        if (_e8215 > _e8239) {
                                            phi_5304_ = _e8215;
                                        } else {
                                            phi_5304_ = _e8239;
                                        }
                                        let _e8242 = phi_5304_;
                                        let _e8244 = local_18.member_3;
                                        let _e8248 = local_18.member_2[0u];
                                        if (_e8248[0] < 0f) {
                                            phi_5321_ = -(_e8248[0]);
                                        } else {
                                            phi_5321_ = _e8248[0];
                                        }
                                        let _e8255 = phi_5321_;
                                        if (_e8248[1] < 0f) {
                                            phi_5328_ = -(_e8248[1]);
                                        } else {
                                            phi_5328_ = _e8248[1];
                                        }
                                        let _e8259 = phi_5328_;
                                        if (_e8255 > _e8259) {
                                            phi_5333_ = _e8255;
                                        } else {
                                            phi_5333_ = _e8259;
                                        }
                                        let _e8262 = phi_5333_;
                                        if (_e8248[2] < 0f) {
                                            phi_5340_ = -(_e8248[2]);
                                        } else {
                                            phi_5340_ = _e8248[2];
                                        }
                                        let _e8266 = phi_5340_;
                                        if (_e8262 > _e8266) {
                                            phi_5345_ = _e8262;
                                        } else {
                                            phi_5345_ = _e8266;
                                        }
                                        let _e8269 = phi_5345_;
                                        let _e8272 = local_18.member_2[1u];
                                        if (_e8272[0] < 0f) {
                                            phi_5359_ = -(_e8272[0]);
                                        } else {
                                            phi_5359_ = _e8272[0];
                                        }
                                        let _e8279 = phi_5359_;
                                        if (_e8272[1] < 0f) {
                                            phi_5366_ = -(_e8272[1]);
                                        } else {
                                            phi_5366_ = _e8272[1];
                                        }
                                        let _e8283 = phi_5366_;
                                        if (_e8279 > _e8283) {
                                            phi_5371_ = _e8279;
                                        } else {
                                            phi_5371_ = _e8283;
                                        }
                                        let _e8286 = phi_5371_;
                                        if (_e8272[2] < 0f) {
                                            phi_5378_ = -(_e8272[2]);
                                        } else {
                                            phi_5378_ = _e8272[2];
                                        }
                                        let _e8290 = phi_5378_;
                                        if (_e8286 > _e8290) {
                                            phi_5383_ = _e8286;
                                        } else {
                                            phi_5383_ = _e8290;
                                        }
                                        let _e8293 = phi_5383_;
                                        if (_e8269 > _e8293) {
                                            phi_5388_ = _e8269;
                                        } else {
                                            phi_5388_ = _e8293;
                                        }
                                        let _e8296 = phi_5388_;
                                        let _e8298 = local_18.member_3;
                                        let _e8305 = local_18.member_3;
                                        local_14 = type_35(array<array<array<f32, 3>, 4>, 2>(array<array<f32, 3>, 4>(_e8076, array<f32, 3>(_e8093, _e8094, _e8095), array<f32, 3>((_e8076[0] - _e8089[0]), (_e8076[1] - _e8089[1]), (_e8076[2] - _e8089[2])), array<f32, 3>(_e8102[0], _e8102[1], _e8102[2])), array<array<f32, 3>, 4>(_e8108, array<f32, 3>(_e8125, _e8126, _e8127), array<f32, 3>((_e8108[0] - _e8121[0]), (_e8108[1] - _e8121[1]), (_e8108[2] - _e8121[2])), array<f32, 3>(_e8134[0], _e8134[1], _e8134[2]))), ((((((_e8188 + _e8190) + (_e8242 + _e8244)) + (_e8296 + _e8298)) * (0.000000059604645f * 16f)) + (_e8305 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)), _e655.member_1);
                                        let _e8327 = local_14.member_1;
                                        if (_e8073 > _e8327) {
                                            if ((bitcast<u32>(_e8073) & 2139095040u) != 2139095040u) {
                                                let _e8332 = (1f / _e8073);
                                                let _e8334 = (_e8056[0] * _e8332);
                                                let _e8336 = (_e8056[1] * _e8332);
                                                let _e8338 = (_e8056[2] * _e8332);
                                                let _e8343 = (((_e8334 * _e8334) + (_e8336 * _e8336)) + (_e8338 * _e8338));
                                                if (_e8343 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e8343 > 0f) {
                                                        phi_5489_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_5489_ = 0f;
                                                    }
                                                    let _e8396 = phi_5489_;
                                                    phi_5553_ = _e8396;
                                                } else {
                                                    phi_5496_ = type_16(0i, 5i);
                                                    phi_5499_ = bitcast<f32>(((bitcast<u32>(_e8343) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e8351 = phi_5496_;
                                                        let _e8353 = phi_5499_;
                                                        local_44 = _e8353;
                                                        if (_e8351.member < _e8351.member_1) {
                                                            let _e8360 = (_e8351.member + 1i);
                                                            if ((false == (_e8360 > _e8351.member)) != false) {
                                                                phi_5520_ = true;
                                                            } else {
                                                                phi_5520_ = false;
                                                            }
                                                            let _e8365 = phi_5520_;
                                                            if _e8365 {
                                                                phi_5526_ = type_17(0u, type_17().member_1);
                                                            } else {
                                                                phi_5526_ = type_17(1u, _e8360);
                                                            }
                                                            let _e8370 = phi_5526_;
                                                            phi_5497_ = type_16(_e8370.member_1, _e8351.member_1);
                                                            phi_5540_ = type_17(1u, _e8351.member);
                                                        } else {
                                                            phi_5497_ = _e8351;
                                                            phi_5540_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e8376 = phi_5497_;
                                                        let _e8378 = phi_5540_;
                                                        let _e8381 = (bitcast<i32>(_e8378.member) != 0i);
                                                        if _e8381 {
                                                            phi_5500_ = (0.5f * (_e8353 + (_e8343 / _e8353)));
                                                        } else {
                                                            phi_5500_ = f32();
                                                        }
                                                        let _e8386 = phi_5500_;
                                                        continue;
                                                        continuing {
                                                            phi_5496_ = _e8376;
                                                            phi_5499_ = _e8386;
                                                            break if !(_e8381);
                                                        }
                                                    }
                                                    let _e8391 = local_44;
                                                    phi_5553_ = (_e8391 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e8398 = phi_5553_;
                                                let _e8399 = (0.000000059604645f * 12f);
                                                let _e8401 = local_14.member_1;
                                                let _e8404 = local_14.member_2;
                                                let _e8408 = ((_e8401 * 1.01f) + ((_e8404 * _e8398) * (1f + _e8399)));
                                                let _e8412 = local_14.member[0u][0u];
                                                let _e8420 = (((_e8334 * _e8412[0]) + (_e8336 * _e8412[1])) + (_e8338 * _e8412[2]));
                                                let _e8424 = local_14.member[0u][1u];
                                                let _e8432 = (((_e8334 * _e8424[0]) + (_e8336 * _e8424[1])) + (_e8338 * _e8424[2]));
                                                let _e8436 = local_14.member[0u][2u];
                                                let _e8444 = (((_e8334 * _e8436[0]) + (_e8336 * _e8436[1])) + (_e8338 * _e8436[2]));
                                                let _e8448 = local_14.member[0u][3u];
                                                let _e8456 = (((_e8334 * _e8448[0]) + (_e8336 * _e8448[1])) + (_e8338 * _e8448[2]));
                                                let _e8460 = local_14.member[1u][0u];
                                                let _e8468 = (((_e8334 * _e8460[0]) + (_e8336 * _e8460[1])) + (_e8338 * _e8460[2]));
                                                let _e8472 = local_14.member[1u][1u];
                                                let _e8480 = (((_e8334 * _e8472[0]) + (_e8336 * _e8472[1])) + (_e8338 * _e8472[2]));
                                                let _e8484 = local_14.member[1u][2u];
                                                let _e8492 = (((_e8334 * _e8484[0]) + (_e8336 * _e8484[1])) + (_e8338 * _e8484[2]));
                                                let _e8496 = local_14.member[1u][3u];
                                                let _e8504 = (((_e8334 * _e8496[0]) + (_e8336 * _e8496[1])) + (_e8338 * _e8496[2]));
                                                if (_e8420 < 0f) {
                                                    phi_5687_ = -(_e8420);
                                                } else {
                                                    phi_5687_ = _e8420;
                                                }
                                                let _e8508 = phi_5687_;
                                                if (_e8468 < 0f) {
                                                    phi_5693_ = -(_e8468);
                                                } else {
                                                    phi_5693_ = _e8468;
                                                }
                                                let _e8512 = phi_5693_;
                                                if (_e8432 < 0f) {
                                                    phi_5702_ = -(_e8432);
                                                } else {
                                                    phi_5702_ = _e8432;
                                                }
                                                let _e8519 = phi_5702_;
                                                if (_e8480 < 0f) {
                                                    phi_5708_ = -(_e8480);
                                                } else {
                                                    phi_5708_ = _e8480;
                                                }
                                                let _e8523 = phi_5708_;
                                                if (_e8444 < 0f) {
                                                    phi_5717_ = -(_e8444);
                                                } else {
                                                    phi_5717_ = _e8444;
                                                }
                                                let _e8530 = phi_5717_;
                                                if (_e8492 < 0f) {
                                                    phi_5723_ = -(_e8492);
                                                } else {
                                                    phi_5723_ = _e8492;
                                                }
                                                let _e8534 = phi_5723_;
                                                if (_e8456 < 0f) {
                                                    phi_5732_ = -(_e8456);
                                                } else {
                                                    phi_5732_ = _e8456;
                                                }
                                                let _e8541 = phi_5732_;
                                                if (_e8504 < 0f) {
                                                    phi_5738_ = -(_e8504);
                                                } else {
                                                    phi_5738_ = _e8504;
                                                }
                                                let _e8545 = phi_5738_;
                                                local_15 = type_31(array<f32, 4>(_e8420, _e8432, _e8444, _e8456), array<f32, 4>(_e8468, _e8480, _e8492, _e8504), array<f32, 4>((_e8408 + ((_e8508 + _e8512) * _e8399)), (_e8408 + ((_e8519 + _e8523) * _e8399)), (_e8408 + ((_e8530 + _e8534) * _e8399)), (_e8408 + ((_e8541 + _e8545) * _e8399))));
                                                let _e8557 = (((_e8334 * _e8334) + (_e8336 * _e8336)) + (_e8338 * _e8338));
                                                if (_e8557 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e8557 > 0f) {
                                                        phi_5781_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_5781_ = 0f;
                                                    }
                                                    let _e8610 = phi_5781_;
                                                    phi_5845_ = _e8610;
                                                } else {
                                                    phi_5788_ = type_16(0i, 5i);
                                                    phi_5791_ = bitcast<f32>(((bitcast<u32>(_e8557) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e8565 = phi_5788_;
                                                        let _e8567 = phi_5791_;
                                                        local_45 = _e8567;
                                                        if (_e8565.member < _e8565.member_1) {
                                                            let _e8574 = (_e8565.member + 1i);
                                                            if ((false == (_e8574 > _e8565.member)) != false) {
                                                                phi_5812_ = true;
                                                            } else {
                                                                phi_5812_ = false;
                                                            }
                                                            let _e8579 = phi_5812_;
                                                            if _e8579 {
                                                                phi_5818_ = type_17(0u, type_17().member_1);
                                                            } else {
                                                                phi_5818_ = type_17(1u, _e8574);
                                                            }
                                                            let _e8584 = phi_5818_;
                                                            phi_5789_ = type_16(_e8584.member_1, _e8565.member_1);
                                                            phi_5832_ = type_17(1u, _e8565.member);
                                                        } else {
                                                            phi_5789_ = _e8565;
                                                            phi_5832_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e8590 = phi_5789_;
                                                        let _e8592 = phi_5832_;
                                                        let _e8595 = (bitcast<i32>(_e8592.member) != 0i);
                                                        if _e8595 {
                                                            phi_5792_ = (0.5f * (_e8567 + (_e8557 / _e8567)));
                                                        } else {
                                                            phi_5792_ = f32();
                                                        }
                                                        let _e8600 = phi_5792_;
                                                        continue;
                                                        continuing {
                                                            phi_5788_ = _e8590;
                                                            phi_5791_ = _e8600;
                                                            break if !(_e8595);
                                                        }
                                                    }
                                                    let _e8605 = local_45;
                                                    phi_5845_ = (_e8605 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e8612 = phi_5845_;
                                                let _e8623 = (((_e8056[0] * _e8056[0]) + (_e8056[1] * _e8056[1])) + (_e8056[2] * _e8056[2]));
                                                if (_e8623 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e8623 > 0f) {
                                                        phi_5870_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_5870_ = 0f;
                                                    }
                                                    let _e8676 = phi_5870_;
                                                    phi_5934_ = _e8676;
                                                } else {
                                                    phi_5877_ = type_16(0i, 5i);
                                                    phi_5880_ = bitcast<f32>(((bitcast<u32>(_e8623) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e8631 = phi_5877_;
                                                        let _e8633 = phi_5880_;
                                                        local_46 = _e8633;
                                                        if (_e8631.member < _e8631.member_1) {
                                                            let _e8640 = (_e8631.member + 1i);
                                                            if ((false == (_e8640 > _e8631.member)) != false) {
                                                                phi_5901_ = true;
                                                            } else {
                                                                phi_5901_ = false;
                                                            }
                                                            let _e8645 = phi_5901_;
                                                            if _e8645 {
                                                                phi_5907_ = type_17(0u, type_17().member_1);
                                                            } else {
                                                                phi_5907_ = type_17(1u, _e8640);
                                                            }
                                                            let _e8650 = phi_5907_;
                                                            phi_5878_ = type_16(_e8650.member_1, _e8631.member_1);
                                                            phi_5921_ = type_17(1u, _e8631.member);
                                                        } else {
                                                            phi_5878_ = _e8631;
                                                            phi_5921_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e8656 = phi_5878_;
                                                        let _e8658 = phi_5921_;
                                                        let _e8661 = (bitcast<i32>(_e8658.member) != 0i);
                                                        if _e8661 {
                                                            phi_5881_ = (0.5f * (_e8633 + (_e8623 / _e8633)));
                                                        } else {
                                                            phi_5881_ = f32();
                                                        }
                                                        let _e8666 = phi_5881_;
                                                        continue;
                                                        continuing {
                                                            phi_5877_ = _e8656;
                                                            phi_5880_ = _e8666;
                                                            break if !(_e8661);
                                                        }
                                                    }
                                                    let _e8671 = local_46;
                                                    phi_5934_ = (_e8671 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e8678 = phi_5934_;
                                                let _e8684 = local_18.member[0u];
                                                if (_e8684[0] < 0f) {
                                                    phi_5950_ = -(_e8684[0]);
                                                } else {
                                                    phi_5950_ = _e8684[0];
                                                }
                                                let _e8691 = phi_5950_;
                                                if (_e8684[1] < 0f) {
                                                    phi_5957_ = -(_e8684[1]);
                                                } else {
                                                    phi_5957_ = _e8684[1];
                                                }
                                                let _e8695 = phi_5957_;
                                                if (_e8691 > _e8695) {
                                                    phi_5962_ = _e8691;
                                                } else {
                                                    phi_5962_ = _e8695;
                                                }
                                                let _e8698 = phi_5962_;
                                                if (_e8684[2] < 0f) {
                                                    phi_5969_ = -(_e8684[2]);
                                                } else {
                                                    phi_5969_ = _e8684[2];
                                                }
                                                let _e8702 = phi_5969_;
                                                if (_e8698 > _e8702) {
                                                    phi_5974_ = _e8698;
                                                } else {
                                                    phi_5974_ = _e8702;
                                                }
                                                let _e8705 = phi_5974_;
                                                let _e8708 = local_18.member[1u];
                                                if (_e8708[0] < 0f) {
                                                    phi_5987_ = -(_e8708[0]);
                                                } else {
                                                    phi_5987_ = _e8708[0];
                                                }
                                                let _e8715 = phi_5987_;
                                                if (_e8708[1] < 0f) {
                                                    phi_5994_ = -(_e8708[1]);
                                                } else {
                                                    phi_5994_ = _e8708[1];
                                                }
                                                let _e8719 = phi_5994_;
                                                if (_e8715 > _e8719) {
                                                    phi_5999_ = _e8715;
                                                } else {
                                                    phi_5999_ = _e8719;
                                                }
                                                let _e8722 = phi_5999_;
                                                if (_e8708[2] < 0f) {
                                                    phi_6006_ = -(_e8708[2]);
                                                } else {
                                                    phi_6006_ = _e8708[2];
                                                }
                                                let _e8726 = phi_6006_;
                                                if (_e8722 > _e8726) {
                                                    phi_6011_ = _e8722;
                                                } else {
                                                    phi_6011_ = _e8726;
                                                }
                                                let _e8729 = phi_6011_;
                                                if (_e8705 > _e8729) {
                                                    phi_6016_ = _e8705;
                                                } else {
                                                    phi_6016_ = _e8729;
                                                }
                                                let _e8732 = phi_6016_;
                                                let _e8734 = local_18.member_3;
                                                let _e8738 = local_18.member_1[0u];
                                                if (_e8738[0] < 0f) {
                                                    phi_6033_ = -(_e8738[0]);
                                                } else {
                                                    phi_6033_ = _e8738[0];
                                                }
                                                let _e8745 = phi_6033_;
                                                if (_e8738[1] < 0f) {
                                                    phi_6040_ = -(_e8738[1]);
                                                } else {
                                                    phi_6040_ = _e8738[1];
                                                }
                                                let _e8749 = phi_6040_;
                                                if (_e8745 > _e8749) {
                                                    phi_6045_ = _e8745;
                                                } else {
                                                    phi_6045_ = _e8749;
                                                }
                                                let _e8752 = phi_6045_;
                                                if (_e8738[2] < 0f) {
                                                    phi_6052_ = -(_e8738[2]);
                                                } else {
                                                    phi_6052_ = _e8738[2];
                                                }
                                                let _e8756 = phi_6052_;
                                                if (_e8752 > _e8756) {
                                                    phi_6057_ = _e8752;
                                                } else {
                                                    phi_6057_ = _e8756;
                                                }
                                                let _e8759 = phi_6057_;
                                                let _e8762 = local_18.member_1[1u];
                                                if (_e8762[0] < 0f) {
                                                    phi_6071_ = -(_e8762[0]);
                                                } else {
                                                    phi_6071_ = _e8762[0];
                                                }
                                                let _e8769 = phi_6071_;
                                                if (_e8762[1] < 0f) {
                                                    phi_6078_ = -(_e8762[1]);
                                                } else {
                                                    phi_6078_ = _e8762[1];
                                                }
                                                let _e8773 = phi_6078_;
                                                if (_e8769 > _e8773) {
                                                    phi_6083_ = _e8769;
                                                } else {
                                                    phi_6083_ = _e8773;
                                                }
                                                let _e8776 = phi_6083_;
                                                if (_e8762[2] < 0f) {
                                                    phi_6090_ = -(_e8762[2]);
                                                } else {
                                                    phi_6090_ = _e8762[2];
                                                }
                                                let _e8780 = phi_6090_;
                                                if (_e8776 > _e8780) {
                                                    phi_6095_ = _e8776;
                                                } else {
                                                    phi_6095_ = _e8780;
                                                }
                                                let _e8783 = phi_6095_;
                                                if (_e8759 > _e8783) {
                                                    phi_6100_ = _e8759;
                                                } else {
                                                    phi_6100_ = _e8783;
                                                }
                                                let _e8786 = phi_6100_;
                                                let _e8788 = local_18.member_3;
                                                let _e8792 = local_18.member_2[0u];
                                                if (_e8792[0] < 0f) {
                                                    phi_6117_ = -(_e8792[0]);
                                                } else {
                                                    phi_6117_ = _e8792[0];
                                                }
                                                let _e8799 = phi_6117_;
                                                if (_e8792[1] < 0f) {
                                                    phi_6124_ = -(_e8792[1]);
                                                } else {
                                                    phi_6124_ = _e8792[1];
                                                }
                                                let _e8803 = phi_6124_;
                                                if (_e8799 > _e8803) {
                                                    phi_6129_ = _e8799;
                                                } else {
                                                    phi_6129_ = _e8803;
                                                }
                                                let _e8806 = phi_6129_;
                                                if (_e8792[2] < 0f) {
                                                    phi_6136_ = -(_e8792[2]);
                                                } else {
                                                    phi_6136_ = _e8792[2];
                                                }
                                                let _e8810 = phi_6136_;
                                                if (_e8806 > _e8810) {
                                                    phi_6141_ = _e8806;
                                                } else {
                                                    phi_6141_ = _e8810;
                                                }
                                                let _e8813 = phi_6141_;
                                                let _e8816 = local_18.member_2[1u];
                                                if (_e8816[0] < 0f) {
                                                    phi_6155_ = -(_e8816[0]);
                                                } else {
                                                    phi_6155_ = _e8816[0];
                                                }
                                                let _e8823 = phi_6155_;
                                                if (_e8816[1] < 0f) {
                                                    phi_6162_ = -(_e8816[1]);
                                                } else {
                                                    phi_6162_ = _e8816[1];
                                                }
                                                let _e8827 = phi_6162_;
                                                if (_e8823 > _e8827) {
                                                    phi_6167_ = _e8823;
                                                } else {
                                                    phi_6167_ = _e8827;
                                                }
                                                let _e8830 = phi_6167_;
                                                if (_e8816[2] < 0f) {
                                                    phi_6174_ = -(_e8816[2]);
                                                } else {
                                                    phi_6174_ = _e8816[2];
                                                }
                                                let _e8834 = phi_6174_;
                                                if (_e8830 > _e8834) {
                                                    phi_6179_ = _e8830;
                                                } else {
                                                    phi_6179_ = _e8834;
                                                }
                                                let _e8837 = phi_6179_;
                                                if (_e8813 > _e8837) {
                                                    phi_6184_ = _e8813;
                                                } else {
                                                    phi_6184_ = _e8837;
                                                }
                                                let _e8840 = phi_6184_;
                                                let _e8842 = local_18.member_3;
                                                let _e8849 = local_18.member_3;
                                                let _e8859 = ((((_e8678 * (1f + (0.000000059604645f * 8f))) + (((((((_e8732 + _e8734) + (_e8786 + _e8788)) + (_e8840 + _e8842)) * (0.000000059604645f * 16f)) + (_e8849 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) * _e8612) * (1f + (0.000000059604645f * 64f)));
                                                let _e8862 = local_15.member[0u];
                                                let _e8865 = local_15.member_1[0u];
                                                if (_e8862 < 0f) {
                                                    phi_6225_ = -(_e8862);
                                                } else {
                                                    phi_6225_ = _e8862;
                                                }
                                                let _e8870 = phi_6225_;
                                                if (_e8865 < 0f) {
                                                    phi_6231_ = -(_e8865);
                                                } else {
                                                    phi_6231_ = _e8865;
                                                }
                                                let _e8874 = phi_6231_;
                                                phi_6242_ = type_9(1u, 4u);
                                                phi_6245_ = ((_e8862 + ((_e8865 - _e8862) * _e6181)) - ((_e8327 * 1.01f) + ((_e8870 + _e8874) * (0.000000059604645f * 12f))));
                                                loop {
                                                    let _e8884 = phi_6242_;
                                                    let _e8886 = phi_6245_;
                                                    local_47 = _e8886;
                                                    local_48 = _e8886;
                                                    if (_e8884.member < _e8884.member_1) {
                                                        phi_6243_ = type_9((_e8884.member + 1u), _e8884.member_1);
                                                        phi_6268_ = type_9(1u, _e8884.member);
                                                    } else {
                                                        phi_6243_ = _e8884;
                                                        phi_6268_ = type_9(0u, type_9().member_1);
                                                    }
                                                    let _e8898 = phi_6243_;
                                                    let _e8900 = phi_6268_;
                                                    let _e8904 = (bitcast<i32>(_e8900.member) != 0i);
                                                    if _e8904 {
                                                        let _e8907 = local_15.member[_e8900.member_1];
                                                        let _e8910 = local_15.member_1[_e8900.member_1];
                                                        if (_e8907 < 0f) {
                                                            phi_6297_ = -(_e8907);
                                                        } else {
                                                            phi_6297_ = _e8907;
                                                        }
                                                        let _e8915 = phi_6297_;
                                                        if (_e8910 < 0f) {
                                                            phi_6303_ = -(_e8910);
                                                        } else {
                                                            phi_6303_ = _e8910;
                                                        }
                                                        let _e8919 = phi_6303_;
                                                        let _e8927 = ((_e8907 + ((_e8910 - _e8907) * _e6181)) - ((_e8327 * 1.01f) + ((_e8915 + _e8919) * (0.000000059604645f * 12f))));
                                                        if (_e8886 < _e8927) {
                                                            phi_6316_ = _e8886;
                                                        } else {
                                                            phi_6316_ = _e8927;
                                                        }
                                                        let _e8930 = phi_6316_;
                                                        phi_6246_ = _e8930;
                                                    } else {
                                                        phi_6246_ = f32();
                                                    }
                                                    let _e8932 = phi_6246_;
                                                    continue;
                                                    continuing {
                                                        phi_6242_ = _e8898;
                                                        phi_6245_ = _e8932;
                                                        break if !(_e8904);
                                                    }
                                                }
                                                let _e8935 = local_47;
                                                if (_e8935 > 0f) {
                                                    let _e8939 = local_48;
                                                    let _e8942 = (((_e8859 - _e8939) / _e8859) * 2.02f);
                                                    if (_e8942 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e8942 > 0f) {
                                                            phi_6337_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_6337_ = 0f;
                                                        }
                                                        let _e8995 = phi_6337_;
                                                        phi_6401_ = _e8995;
                                                    } else {
                                                        phi_6344_ = type_16(0i, 5i);
                                                        phi_6347_ = bitcast<f32>(((bitcast<u32>(_e8942) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e8950 = phi_6344_;
                                                            let _e8952 = phi_6347_;
                                                            local_49 = _e8952;
                                                            if (_e8950.member < _e8950.member_1) {
                                                                let _e8959 = (_e8950.member + 1i);
                                                                if ((false == (_e8959 > _e8950.member)) != false) {
                                                                    phi_6368_ = true;
                                                                } else {
                                                                    phi_6368_ = false;
                                                                }
                                                                let _e8964 = phi_6368_;
                                                                if _e8964 {
                                                                    phi_6374_ = type_17(0u, type_17().member_1);
                                                                } else {
                                                                    phi_6374_ = type_17(1u, _e8959);
                                                                }
                                                                let _e8969 = phi_6374_;
                                                                phi_6345_ = type_16(_e8969.member_1, _e8950.member_1);
                                                                phi_6388_ = type_17(1u, _e8950.member);
                                                            } else {
                                                                phi_6345_ = _e8950;
                                                                phi_6388_ = type_17(0u, type_17().member_1);
                                                            }
                                                            let _e8975 = phi_6345_;
                                                            let _e8977 = phi_6388_;
                                                            let _e8980 = (bitcast<i32>(_e8977.member) != 0i);
                                                            if _e8980 {
                                                                phi_6348_ = (0.5f * (_e8952 + (_e8942 / _e8952)));
                                                            } else {
                                                                phi_6348_ = f32();
                                                            }
                                                            let _e8985 = phi_6348_;
                                                            continue;
                                                            continuing {
                                                                phi_6344_ = _e8975;
                                                                phi_6347_ = _e8985;
                                                                break if !(_e8980);
                                                            }
                                                        }
                                                        let _e8990 = local_49;
                                                        phi_6401_ = (_e8990 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e8997 = phi_6401_;
                                                    let _e8999 = ((_e8997 * _e8612) * 1.01f);
                                                    phi_6406_ = type_9(0u, 4u);
                                                    phi_6409_ = 2f;
                                                    phi_6411_ = true;
                                                    phi_6413_ = true;
                                                    loop {
                                                        let _e9001 = phi_6406_;
                                                        let _e9003 = phi_6409_;
                                                        let _e9005 = phi_6411_;
                                                        let _e9007 = phi_6413_;
                                                        local_50 = _e9003;
                                                        local_87 = _e9003;
                                                        local_51 = _e9005;
                                                        local_52 = _e9007;
                                                        local_88 = _e9007;
                                                        local_53 = _e9007;
                                                        if (_e9001.member < _e9001.member_1) {
                                                            phi_6407_ = type_9((_e9001.member + 1u), _e9001.member_1);
                                                            phi_6436_ = type_9(1u, _e9001.member);
                                                        } else {
                                                            phi_6407_ = _e9001;
                                                            phi_6436_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e9019 = phi_6407_;
                                                        let _e9021 = phi_6436_;
                                                        let _e9025 = (bitcast<i32>(_e9021.member) != 0i);
                                                        if _e9025 {
                                                            let _e9029 = local_14.member[0u][_e9021.member_1];
                                                            let _e9036 = local_14.member[1u][_e9021.member_1];
                                                            if (_e9029[0] < 0f) {
                                                                phi_6473_ = -(_e9029[0]);
                                                            } else {
                                                                phi_6473_ = _e9029[0];
                                                            }
                                                            let _e9043 = phi_6473_;
                                                            if (_e9029[1] < 0f) {
                                                                phi_6480_ = -(_e9029[1]);
                                                            } else {
                                                                phi_6480_ = _e9029[1];
                                                            }
                                                            let _e9047 = phi_6480_;
                                                            if (_e9029[2] < 0f) {
                                                                phi_6488_ = -(_e9029[2]);
                                                            } else {
                                                                phi_6488_ = _e9029[2];
                                                            }
                                                            let _e9052 = phi_6488_;
                                                            let _e9053 = ((_e9043 + _e9047) + _e9052);
                                                            if (_e9036[0] < 0f) {
                                                                phi_6496_ = -(_e9036[0]);
                                                            } else {
                                                                phi_6496_ = _e9036[0];
                                                            }
                                                            let _e9057 = phi_6496_;
                                                            if (_e9036[1] < 0f) {
                                                                phi_6503_ = -(_e9036[1]);
                                                            } else {
                                                                phi_6503_ = _e9036[1];
                                                            }
                                                            let _e9061 = phi_6503_;
                                                            if (_e9036[2] < 0f) {
                                                                phi_6511_ = -(_e9036[2]);
                                                            } else {
                                                                phi_6511_ = _e9036[2];
                                                            }
                                                            let _e9066 = phi_6511_;
                                                            let _e9067 = ((_e9057 + _e9061) + _e9066);
                                                            if (_e9053 > _e9067) {
                                                                phi_6517_ = _e9053;
                                                            } else {
                                                                phi_6517_ = _e9067;
                                                            }
                                                            let _e9070 = phi_6517_;
                                                            let _e9074 = (_e9036[0] - _e9029[0]);
                                                            let _e9075 = (_e9036[1] - _e9029[1]);
                                                            let _e9076 = (_e9036[2] - _e9029[2]);
                                                            if (_e9074 < 0f) {
                                                                phi_6535_ = -(_e9074);
                                                            } else {
                                                                phi_6535_ = _e9074;
                                                            }
                                                            let _e9080 = phi_6535_;
                                                            if (_e9075 < 0f) {
                                                                phi_6541_ = -(_e9075);
                                                            } else {
                                                                phi_6541_ = _e9075;
                                                            }
                                                            let _e9084 = phi_6541_;
                                                            if (_e9076 < 0f) {
                                                                phi_6548_ = -(_e9076);
                                                            } else {
                                                                phi_6548_ = _e9076;
                                                            }
                                                            let _e9089 = phi_6548_;
                                                            let _e9096 = local_15.member[_e9021.member_1];
                                                            let _e9099 = local_15.member_1[_e9021.member_1];
                                                            if (_e9096 < 0f) {
                                                                phi_6574_ = -(_e9096);
                                                            } else {
                                                                phi_6574_ = _e9096;
                                                            }
                                                            let _e9104 = phi_6574_;
                                                            if (_e9099 < 0f) {
                                                                phi_6580_ = -(_e9099);
                                                            } else {
                                                                phi_6580_ = _e9099;
                                                            }
                                                            let _e9108 = phi_6580_;
                                                            let _e9112 = ((_e8327 * 1.01f) + ((_e9104 + _e9108) * (0.000000059604645f * 12f)));
                                                            let _e9119 = local_15.member_1[_e9021.member_1];
                                                            let _e9122 = local_15.member[_e9021.member_1];
                                                            let _e9123 = (_e9119 - _e9122);
                                                            let _e9126 = ((_e9112 + _e9112) + (_e8999 * ((((_e9080 + _e9084) + _e9089) + (_e8327 * 6f)) * 1.01f)));
                                                            let _e9129 = ((((_e9096 + ((_e9099 - _e9096) * _e6181)) - _e9112) - (_e8999 * ((_e9070 + (_e8327 * 3f)) * 1.01f))) - _e8859);
                                                            let _e9130 = (_e9129 > 0.000000000000000000000000000000000000011754944f);
                                                            let _e9131 = (_e9123 > _e9126);
                                                            if _e9131 {
                                                                phi_6616_ = true;
                                                            } else {
                                                                phi_6616_ = _e9130;
                                                            }
                                                            let _e9133 = phi_6616_;
                                                            if (_e9123 < -(_e9126)) {
                                                                phi_6623_ = true;
                                                            } else {
                                                                phi_6623_ = _e9130;
                                                            }
                                                            let _e9138 = phi_6623_;
                                                            if _e9131 {
                                                                phi_6644_ = _e9003;
                                                            } else {
                                                                if _e9130 {
                                                                    let _e9140 = (_e9126 - _e9123);
                                                                    if (_e9140 > 0.000000000000000000000000000000000000011754944f) {
                                                                        phi_6636_ = _e9140;
                                                                    } else {
                                                                        phi_6636_ = 0.000000000000000000000000000000000000011754944f;
                                                                    }
                                                                    let _e9143 = phi_6636_;
                                                                    let _e9144 = (_e9129 / _e9143);
                                                                    if (_e9003 < _e9144) {
                                                                        phi_6642_ = _e9003;
                                                                    } else {
                                                                        phi_6642_ = _e9144;
                                                                    }
                                                                    let _e9147 = phi_6642_;
                                                                    phi_6643_ = _e9147;
                                                                } else {
                                                                    phi_6643_ = _e9003;
                                                                }
                                                                let _e9149 = phi_6643_;
                                                                phi_6644_ = _e9149;
                                                            }
                                                            let _e9151 = phi_6644_;
                                                            phi_6410_ = _e9151;
                                                            phi_6412_ = (_e9005 && _e9138);
                                                            phi_6414_ = (_e9007 && _e9133);
                                                        } else {
                                                            phi_6410_ = f32();
                                                            phi_6412_ = bool();
                                                            phi_6414_ = bool();
                                                        }
                                                        let _e9153 = phi_6410_;
                                                        let _e9155 = phi_6412_;
                                                        let _e9157 = phi_6414_;
                                                        continue;
                                                        continuing {
                                                            phi_6406_ = _e9019;
                                                            phi_6409_ = _e9153;
                                                            phi_6411_ = _e9155;
                                                            phi_6413_ = _e9157;
                                                            break if !(_e9025);
                                                        }
                                                    }
                                                    let _e9160 = local_50;
                                                    if (_e9160 < 2f) {
                                                        let _e11588 = local_87;
                                                        phi_6649_ = _e11588;
                                                    } else {
                                                        phi_6649_ = 2f;
                                                    }
                                                    let _e9163 = phi_6649_;
                                                    let _e9164 = (_e9163 * 0.999f);
                                                    let _e9166 = local_51;
                                                    if _e9166 {
                                                        let _e9168 = local_52;
                                                        if _e9168 {
                                                            phi_6658_ = type_39();
                                                        } else {
                                                            phi_6658_ = type_39(1u, _e6181, 2f);
                                                        }
                                                        let _e9171 = phi_6658_;
                                                        phi_6659_ = _e9171;
                                                        let _e11595 = local_88;
                                                        phi_6660_ = _e11595;
                                                    } else {
                                                        phi_6659_ = type_39();
                                                        phi_6660_ = true;
                                                    }
                                                    let _e9173 = phi_6659_;
                                                    let _e9175 = phi_6660_;
                                                    if _e9175 {
                                                        let _e9177 = local_53;
                                                        if _e9177 {
                                                            if (_e9164 > (0.000000059604645f * 4096f)) {
                                                                let _e9181 = (_e6181 + _e9164);
                                                                if (_e9181 < _e389) {
                                                                    phi_6677_ = _e9181;
                                                                } else {
                                                                    phi_6677_ = _e389;
                                                                }
                                                                let _e9184 = phi_6677_;
                                                                phi_6678_ = _e9184;
                                                            } else {
                                                                phi_6678_ = _e6181;
                                                            }
                                                            let _e9186 = phi_6678_;
                                                            phi_6681_ = type_9(0u, 4u);
                                                            phi_6684_ = _e9186;
                                                            phi_6686_ = _e6181;
                                                            loop {
                                                                let _e9188 = phi_6681_;
                                                                let _e9190 = phi_6684_;
                                                                let _e9192 = phi_6686_;
                                                                local_54 = _e9190;
                                                                local_55 = _e9192;
                                                                local_56 = _e9192;
                                                                if (_e9188.member < _e9188.member_1) {
                                                                    phi_6682_ = type_9((_e9188.member + 1u), _e9188.member_1);
                                                                    phi_6709_ = type_9(1u, _e9188.member);
                                                                } else {
                                                                    phi_6682_ = _e9188;
                                                                    phi_6709_ = type_9(0u, type_9().member_1);
                                                                }
                                                                let _e9204 = phi_6682_;
                                                                let _e9206 = phi_6709_;
                                                                let _e9210 = (bitcast<i32>(_e9206.member) != 0i);
                                                                if _e9210 {
                                                                    let _e9213 = local_15.member[_e9206.member_1];
                                                                    let _e9216 = local_15.member_1[_e9206.member_1];
                                                                    let _e9219 = local_15.member[_e9206.member_1];
                                                                    let _e9225 = local_15.member_2[_e9206.member_1];
                                                                    let _e9226 = ((_e9213 + ((_e9216 - _e9219) * _e6181)) - _e9225);
                                                                    let _e9229 = local_15.member_1[_e9206.member_1];
                                                                    let _e9232 = local_15.member[_e9206.member_1];
                                                                    let _e9233 = (_e9229 - _e9232);
                                                                    if (_e9233 > 0f) {
                                                                        let _e9247 = (_e6181 - (_e9226 / _e9233));
                                                                        if (_e9192 > _e9247) {
                                                                            phi_6777_ = _e9192;
                                                                        } else {
                                                                            phi_6777_ = _e9247;
                                                                        }
                                                                        let _e9250 = phi_6777_;
                                                                        phi_6795_ = _e9190;
                                                                        phi_6796_ = _e9250;
                                                                    } else {
                                                                        if (_e9226 > 0f) {
                                                                            if (_e9233 < 0f) {
                                                                                let _e9238 = (_e6181 - (_e9226 / _e9233));
                                                                                if (_e9190 < _e9238) {
                                                                                    phi_6792_ = _e9190;
                                                                                } else {
                                                                                    phi_6792_ = _e9238;
                                                                                }
                                                                                let _e9241 = phi_6792_;
                                                                                phi_6793_ = _e9241;
                                                                            } else {
                                                                                phi_6793_ = _e9190;
                                                                            }
                                                                            let _e9243 = phi_6793_;
                                                                            phi_6794_ = _e9243;
                                                                        } else {
                                                                            phi_6794_ = _e9190;
                                                                        }
                                                                        let _e9245 = phi_6794_;
                                                                        phi_6795_ = _e9245;
                                                                        phi_6796_ = _e9192;
                                                                    }
                                                                    let _e9252 = phi_6795_;
                                                                    let _e9254 = phi_6796_;
                                                                    phi_6685_ = _e9252;
                                                                    phi_6687_ = _e9254;
                                                                } else {
                                                                    phi_6685_ = f32();
                                                                    phi_6687_ = f32();
                                                                }
                                                                let _e9256 = phi_6685_;
                                                                let _e9258 = phi_6687_;
                                                                continue;
                                                                continuing {
                                                                    phi_6681_ = _e9204;
                                                                    phi_6684_ = _e9256;
                                                                    phi_6686_ = _e9258;
                                                                    break if !(_e9210);
                                                                }
                                                            }
                                                            let _e9261 = local_54;
                                                            let _e9263 = local_55;
                                                            let _e9267 = local_56;
                                                            let _e9268 = (_e9267 + ((_e9261 - _e9263) * 0.5f));
                                                            if (_e9268 > _e6181) {
                                                                if (_e9268 <= _e9186) {
                                                                    let _e9273 = local_15.member[0u];
                                                                    let _e9276 = local_15.member_1[0u];
                                                                    let _e9279 = local_15.member[0u];
                                                                    let _e9285 = local_15.member_2[0u];
                                                                    if (((_e9273 + ((_e9276 - _e9279) * _e9268)) - _e9285) > 0f) {
                                                                        let _e9290 = local_15.member[1u];
                                                                        let _e9293 = local_15.member_1[1u];
                                                                        let _e9296 = local_15.member[1u];
                                                                        let _e9302 = local_15.member_2[1u];
                                                                        if (((_e9290 + ((_e9293 - _e9296) * _e9268)) - _e9302) > 0f) {
                                                                            let _e9307 = local_15.member[2u];
                                                                            let _e9310 = local_15.member_1[2u];
                                                                            let _e9313 = local_15.member[2u];
                                                                            let _e9319 = local_15.member_2[2u];
                                                                            if (((_e9307 + ((_e9310 - _e9313) * _e9268)) - _e9319) > 0f) {
                                                                                let _e9324 = local_15.member[3u];
                                                                                let _e9327 = local_15.member_1[3u];
                                                                                let _e9330 = local_15.member[3u];
                                                                                let _e9336 = local_15.member_2[3u];
                                                                                phi_6957_ = (((_e9324 + ((_e9327 - _e9330) * _e9268)) - _e9336) > 0f);
                                                                                phi_6958_ = false;
                                                                            } else {
                                                                                phi_6957_ = bool();
                                                                                phi_6958_ = true;
                                                                            }
                                                                            let _e9340 = phi_6957_;
                                                                            let _e9342 = phi_6958_;
                                                                            phi_6959_ = _e9340;
                                                                            phi_6960_ = _e9342;
                                                                        } else {
                                                                            phi_6959_ = bool();
                                                                            phi_6960_ = true;
                                                                        }
                                                                        let _e9344 = phi_6959_;
                                                                        let _e9346 = phi_6960_;
                                                                        phi_6961_ = _e9344;
                                                                        phi_6962_ = _e9346;
                                                                    } else {
                                                                        phi_6961_ = bool();
                                                                        phi_6962_ = true;
                                                                    }
                                                                    let _e9348 = phi_6961_;
                                                                    let _e9350 = phi_6962_;
                                                                    if _e9350 {
                                                                        phi_6966_ = false;
                                                                    } else {
                                                                        phi_6966_ = _e9348;
                                                                    }
                                                                    let _e9352 = phi_6966_;
                                                                    if _e9352 {
                                                                        phi_6970_ = false;
                                                                    } else {
                                                                        phi_6970_ = true;
                                                                    }
                                                                    let _e9354 = phi_6970_;
                                                                    phi_6971_ = _e9354;
                                                                } else {
                                                                    phi_6971_ = true;
                                                                }
                                                                let _e9356 = phi_6971_;
                                                                phi_6972_ = _e9356;
                                                            } else {
                                                                phi_6972_ = true;
                                                            }
                                                            let _e9358 = phi_6972_;
                                                            if _e9358 {
                                                                phi_6976_ = 2f;
                                                            } else {
                                                                phi_6976_ = _e9268;
                                                            }
                                                            let _e9360 = phi_6976_;
                                                            phi_6979_ = type_39(2u, _e9186, _e9360);
                                                            phi_6980_ = type_39();
                                                            phi_6981_ = false;
                                                        } else {
                                                            phi_6979_ = type_39();
                                                            phi_6980_ = type_39(0u, _e6181, 2f);
                                                            phi_6981_ = true;
                                                        }
                                                        let _e9363 = phi_6979_;
                                                        let _e9365 = phi_6980_;
                                                        let _e9367 = phi_6981_;
                                                        phi_6982_ = _e9363;
                                                        phi_6983_ = _e9365;
                                                        phi_6984_ = _e9367;
                                                    } else {
                                                        phi_6982_ = type_39();
                                                        phi_6983_ = _e9173;
                                                        phi_6984_ = true;
                                                    }
                                                    let _e9369 = phi_6982_;
                                                    let _e9371 = phi_6983_;
                                                    let _e9373 = phi_6984_;
                                                    phi_6989_ = _e9371;
                                                    phi_6990_ = _e9369;
                                                    phi_6991_ = _e9373;
                                                } else {
                                                    phi_6989_ = type_39(0u, _e6181, 2f);
                                                    phi_6990_ = type_39();
                                                    phi_6991_ = true;
                                                }
                                                let _e9375 = phi_6989_;
                                                let _e9377 = phi_6990_;
                                                let _e9379 = phi_6991_;
                                                phi_6995_ = _e9375;
                                                phi_6996_ = _e9377;
                                                phi_6997_ = false;
                                                phi_6998_ = _e9379;
                                            } else {
                                                phi_6995_ = type_39();
                                                phi_6996_ = type_39();
                                                phi_6997_ = true;
                                                phi_6998_ = false;
                                            }
                                            let _e9381 = phi_6995_;
                                            let _e9383 = phi_6996_;
                                            let _e9385 = phi_6997_;
                                            let _e9387 = phi_6998_;
                                            phi_6999_ = _e9381;
                                            phi_7000_ = _e9383;
                                            phi_7001_ = _e9385;
                                            phi_7002_ = _e9387;
                                        } else {
                                            phi_6999_ = type_39();
                                            phi_7000_ = type_39();
                                            phi_7001_ = true;
                                            phi_7002_ = false;
                                        }
                                        let _e9389 = phi_6999_;
                                        let _e9391 = phi_7000_;
                                        let _e9393 = phi_7001_;
                                        let _e9395 = phi_7002_;
                                        if _e9393 {
                                            phi_7007_ = type_39(0u, _e6181, 2f);
                                            phi_7008_ = true;
                                        } else {
                                            phi_7007_ = _e9389;
                                            phi_7008_ = _e9395;
                                        }
                                        let _e9398 = phi_7007_;
                                        let _e9400 = phi_7008_;
                                        if _e9400 {
                                            phi_7012_ = _e9398;
                                        } else {
                                            phi_7012_ = _e9391;
                                        }
                                        let _e9402 = phi_7012_;
                                        if _e395 {
                                            if (_e9402.member == 2u) {
                                                let _e9406 = (_e9402.member_2 <= _e389);
                                                if _e9406 {
                                                    phi_7028_ = _e9402.member_2;
                                                    phi_7029_ = _e9402.member_2;
                                                    phi_7030_ = false;
                                                } else {
                                                    phi_7028_ = f32();
                                                    phi_7029_ = f32();
                                                    phi_7030_ = true;
                                                }
                                                let _e9410 = phi_7028_;
                                                let _e9412 = phi_7029_;
                                                let _e9414 = phi_7030_;
                                                phi_7031_ = _e9410;
                                                phi_7032_ = _e9412;
                                                phi_7033_ = _e9406;
                                                phi_7034_ = _e9414;
                                                phi_7035_ = false;
                                            } else {
                                                phi_7031_ = f32();
                                                phi_7032_ = f32();
                                                phi_7033_ = false;
                                                phi_7034_ = false;
                                                phi_7035_ = true;
                                            }
                                            let _e9416 = phi_7031_;
                                            let _e9418 = phi_7032_;
                                            let _e9420 = phi_7033_;
                                            let _e9422 = phi_7034_;
                                            let _e9424 = phi_7035_;
                                            phi_7036_ = _e9416;
                                            phi_7037_ = _e9418;
                                            phi_7038_ = _e9420;
                                            phi_7039_ = _e9422;
                                            phi_7040_ = _e9424;
                                        } else {
                                            phi_7036_ = f32();
                                            phi_7037_ = f32();
                                            phi_7038_ = false;
                                            phi_7039_ = false;
                                            phi_7040_ = true;
                                        }
                                        let _e9426 = phi_7036_;
                                        let _e9428 = phi_7037_;
                                        let _e9430 = phi_7038_;
                                        let _e9432 = phi_7039_;
                                        let _e9434 = phi_7040_;
                                        phi_7041_ = _e9426;
                                        phi_7042_ = _e9402.member;
                                        phi_7043_ = _e9428;
                                        phi_7044_ = _e9402;
                                        phi_7045_ = _e9402.member;
                                        phi_7046_ = _e9402.member;
                                        phi_7047_ = _e9430;
                                        phi_7048_ = _e9432;
                                        phi_7049_ = _e9434;
                                    }
                                    let _e9436 = phi_7041_;
                                    let _e9438 = phi_7042_;
                                    let _e9440 = phi_7043_;
                                    let _e9442 = phi_7044_;
                                    let _e9444 = phi_7045_;
                                    let _e9446 = phi_7046_;
                                    let _e9448 = phi_7047_;
                                    let _e9450 = phi_7048_;
                                    let _e9452 = phi_7049_;
                                    phi_7050_ = _e9436;
                                    phi_7051_ = _e9438;
                                    phi_7052_ = _e9440;
                                    phi_7053_ = _e9442;
                                    phi_7054_ = _e9444;
                                    phi_7055_ = _e9446;
                                    phi_7056_ = _e9448;
                                    phi_7057_ = _e7989;
                                    phi_7058_ = _e9450;
                                    phi_7059_ = _e9452;
                                    phi_7060_ = false;
                                } else {
                                    phi_7050_ = f32();
                                    phi_7051_ = u32();
                                    phi_7052_ = f32();
                                    phi_7053_ = type_39();
                                    phi_7054_ = u32();
                                    phi_7055_ = u32();
                                    phi_7056_ = false;
                                    phi_7057_ = false;
                                    phi_7058_ = false;
                                    phi_7059_ = false;
                                    phi_7060_ = true;
                                }
                                let _e9454 = phi_7050_;
                                let _e9456 = phi_7051_;
                                let _e9458 = phi_7052_;
                                let _e9460 = phi_7053_;
                                let _e9462 = phi_7054_;
                                let _e9464 = phi_7055_;
                                let _e9466 = phi_7056_;
                                let _e9468 = phi_7057_;
                                let _e9470 = phi_7058_;
                                let _e9472 = phi_7059_;
                                let _e9474 = phi_7060_;
                                phi_7061_ = _e7986;
                                phi_2136_ = _e9454;
                                phi_2138_ = _e9456;
                                phi_2140_ = _e9458;
                                phi_7062_ = _e9460;
                                phi_7063_ = _e9462;
                                phi_7064_ = _e7986;
                                phi_7065_ = _e9464;
                                phi_7066_ = _e9466;
                                phi_7067_ = _e9468;
                                phi_7068_ = _e9470;
                                phi_7069_ = _e9472;
                                phi_7070_ = false;
                                phi_7071_ = _e9474;
                            } else {
                                phi_7061_ = f32();
                                phi_2136_ = f32();
                                phi_2138_ = u32();
                                phi_2140_ = f32();
                                phi_7062_ = type_39();
                                phi_7063_ = u32();
                                phi_7064_ = f32();
                                phi_7065_ = u32();
                                phi_7066_ = false;
                                phi_7067_ = false;
                                phi_7068_ = false;
                                phi_7069_ = false;
                                phi_7070_ = true;
                                phi_7071_ = false;
                            }
                            let _e9476 = phi_7061_;
                            let _e9478 = phi_2136_;
                            let _e9480 = phi_2138_;
                            let _e9482 = phi_2140_;
                            let _e9484 = phi_7062_;
                            let _e9486 = phi_7063_;
                            let _e9488 = phi_7064_;
                            let _e9490 = phi_7065_;
                            let _e9492 = phi_7066_;
                            let _e9494 = phi_7067_;
                            let _e9496 = phi_7068_;
                            let _e9498 = phi_7069_;
                            let _e9500 = phi_7070_;
                            let _e9502 = phi_7071_;
                            local_57 = _e9494;
                            local_89 = _e9496;
                            local_90 = _e9498;
                            local_91 = _e9500;
                            local_92 = _e9502;
                            local_58 = _e9484;
                            local_59 = _e9484;
                            local_93 = _e9486;
                            local_60 = _e9484;
                            local_94 = _e9494;
                            local_95 = _e9490;
                            local_97 = _e9488;
                            local_98 = _e9476;
                            continue;
                            continuing {
                                phi_2132_ = _e6204;
                                phi_2135_ = _e9478;
                                phi_2137_ = _e9480;
                                phi_2139_ = _e9482;
                                break if !(_e9492);
                            }
                        }
                        let _e9505 = local_57;
                        if _e9505 {
                            phi_7075_ = false;
                            phi_7076_ = false;
                            phi_7077_ = false;
                            phi_7078_ = false;
                        } else {
                            let _e11696 = local_89;
                            phi_7075_ = _e11696;
                            let _e11699 = local_90;
                            phi_7076_ = _e11699;
                            let _e11702 = local_91;
                            phi_7077_ = _e11702;
                            let _e11705 = local_92;
                            phi_7078_ = _e11705;
                        }
                        let _e9507 = phi_7075_;
                        let _e9509 = phi_7076_;
                        let _e9511 = phi_7077_;
                        let _e9513 = phi_7078_;
                        if _e9507 {
                            let _e9515 = local_58;
                            if (_e9515.member_1 >= _e389) {
                                phi_7100_ = type_38(type_37(0u, f32()), 0u);
                            } else {
                                let _e9519 = local_59;
                                if (_e9519.member_1 > _e387) {
                                    phi_7095_ = 0u;
                                } else {
                                    let _e11710 = local_93;
                                    phi_7095_ = _e11710;
                                }
                                let _e9523 = phi_7095_;
                                let _e9525 = local_60;
                                phi_7100_ = type_38(type_37(2u, _e9525.member_1), _e9523);
                            }
                            let _e9532 = phi_7100_;
                            phi_7101_ = _e9532;
                            phi_7102_ = false;
                            phi_7103_ = false;
                            phi_7104_ = false;
                            phi_7105_ = false;
                        } else {
                            phi_7101_ = type_38();
                            phi_7102_ = _e9509;
                            let _e11717 = local_94;
                            phi_7103_ = _e11717;
                            phi_7104_ = _e9511;
                            phi_7105_ = _e9513;
                        }
                        let _e9534 = phi_7101_;
                        let _e9536 = phi_7102_;
                        let _e9538 = phi_7103_;
                        let _e9540 = phi_7104_;
                        let _e9542 = phi_7105_;
                        if _e9536 {
                            let _e11722 = local_95;
                            phi_7109_ = _e11722;
                            let _e11727 = local_97;
                            phi_7110_ = _e11727;
                            phi_7111_ = true;
                            phi_7112_ = false;
                            phi_7113_ = false;
                            phi_7114_ = false;
                        } else {
                            let _e11724 = local_96;
                            phi_7109_ = _e11724;
                            let _e11729 = local_98;
                            phi_7110_ = _e11729;
                            phi_7111_ = _e9538;
                            phi_7112_ = _e9540;
                            phi_7113_ = _e9542;
                            phi_7114_ = _e9507;
                        }
                        let _e9544 = phi_7109_;
                        let _e9546 = phi_7110_;
                        let _e9548 = phi_7111_;
                        let _e9550 = phi_7112_;
                        let _e9552 = phi_7113_;
                        let _e9554 = phi_7114_;
                        if _e9548 {
                            phi_7118_ = _e9546;
                            phi_7119_ = _e9544;
                            phi_7120_ = true;
                            phi_7121_ = false;
                            phi_7122_ = false;
                        } else {
                            let _e11736 = local_99;
                            phi_7118_ = _e11736;
                            let _e11739 = local_100;
                            phi_7119_ = _e11739;
                            phi_7120_ = _e9550;
                            phi_7121_ = _e9552;
                            phi_7122_ = _e9554;
                        }
                        let _e9556 = phi_7118_;
                        let _e9558 = phi_7119_;
                        let _e9560 = phi_7120_;
                        let _e9562 = phi_7121_;
                        let _e9564 = phi_7122_;
                        if _e9560 {
                            local_13[0u] = 0.01f;
                            local_13[1u] = 0f;
                            local_13[2u] = 0.8f;
                            if (_e385 >= (0.000000059604645f * 8f)) {
                                phi_7134_ = _e385;
                            } else {
                                phi_7134_ = 0f;
                            }
                            let _e9571 = phi_7134_;
                            phi_7137_ = type_9(0u, 3u);
                            loop {
                                let _e9573 = phi_7137_;
                                if (_e9573.member < _e9573.member_1) {
                                    phi_7138_ = type_9((_e9573.member + 1u), _e9573.member_1);
                                    phi_7161_ = type_9(1u, _e9573.member);
                                } else {
                                    phi_7138_ = _e9573;
                                    phi_7161_ = type_9(0u, type_9().member_1);
                                }
                                let _e9585 = phi_7138_;
                                let _e9587 = phi_7161_;
                                if (bitcast<i32>(_e9587.member) != 0i) {
                                    let _e9593 = local_13[_e9587.member_1];
                                    let _e9595 = (_e9556 + (_e9571 * _e9593));
                                    if (_e9595 < _e389) {
                                        phi_7182_ = _e9595;
                                    } else {
                                        phi_7182_ = _e389;
                                    }
                                    let _e9598 = phi_7182_;
                                    let _e9601 = local_18.member[0u];
                                    let _e9607 = local_18.member[1u];
                                    let _e9623 = local_18.member_1[0u];
                                    let _e9629 = local_18.member_1[1u];
                                    let _e9645 = local_18.member_2[0u];
                                    let _e9651 = local_18.member_2[1u];
                                    let _e9665 = function_3(array<f32, 3>((_e9601[0] + ((_e9607[0] - _e9601[0]) * _e9598)), (_e9601[1] + ((_e9607[1] - _e9601[1]) * _e9598)), (_e9601[2] + ((_e9607[2] - _e9601[2]) * _e9598))), array<f32, 3>((_e9623[0] + ((_e9629[0] - _e9623[0]) * _e9598)), (_e9623[1] + ((_e9629[1] - _e9623[1]) * _e9598)), (_e9623[2] + ((_e9629[2] - _e9623[2]) * _e9598))), array<f32, 3>((_e9645[0] + ((_e9651[0] - _e9645[0]) * _e9598)), (_e9645[1] + ((_e9651[1] - _e9645[1]) * _e9598)), (_e9645[2] + ((_e9651[2] - _e9645[2]) * _e9598))), _e245.member);
                                    let _e9676 = (((_e9665[0] * _e9665[0]) + (_e9665[1] * _e9665[1])) + (_e9665[2] * _e9665[2]));
                                    if (_e9676 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e9676 > 0f) {
                                            phi_7305_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_7305_ = 0f;
                                        }
                                        let _e9729 = phi_7305_;
                                        phi_7369_ = _e9729;
                                    } else {
                                        phi_7312_ = type_16(0i, 5i);
                                        phi_7315_ = bitcast<f32>(((bitcast<u32>(_e9676) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e9684 = phi_7312_;
                                            let _e9686 = phi_7315_;
                                            local_61 = _e9686;
                                            if (_e9684.member < _e9684.member_1) {
                                                let _e9693 = (_e9684.member + 1i);
                                                if ((false == (_e9693 > _e9684.member)) != false) {
                                                    phi_7336_ = true;
                                                } else {
                                                    phi_7336_ = false;
                                                }
                                                let _e9698 = phi_7336_;
                                                if _e9698 {
                                                    phi_7342_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_7342_ = type_17(1u, _e9693);
                                                }
                                                let _e9703 = phi_7342_;
                                                phi_7313_ = type_16(_e9703.member_1, _e9684.member_1);
                                                phi_7356_ = type_17(1u, _e9684.member);
                                            } else {
                                                phi_7313_ = _e9684;
                                                phi_7356_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e9709 = phi_7313_;
                                            let _e9711 = phi_7356_;
                                            let _e9714 = (bitcast<i32>(_e9711.member) != 0i);
                                            if _e9714 {
                                                phi_7316_ = (0.5f * (_e9686 + (_e9676 / _e9686)));
                                            } else {
                                                phi_7316_ = f32();
                                            }
                                            let _e9719 = phi_7316_;
                                            continue;
                                            continuing {
                                                phi_7312_ = _e9709;
                                                phi_7315_ = _e9719;
                                                break if !(_e9714);
                                            }
                                        }
                                        let _e9724 = local_61;
                                        phi_7369_ = (_e9724 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e9731 = phi_7369_;
                                    let _e9737 = local_18.member[0u];
                                    if (_e9737[0] < 0f) {
                                        phi_7385_ = -(_e9737[0]);
                                    } else {
                                        phi_7385_ = _e9737[0];
                                    }
                                    let _e9744 = phi_7385_;
                                    if (_e9737[1] < 0f) {
                                        phi_7392_ = -(_e9737[1]);
                                    } else {
                                        phi_7392_ = _e9737[1];
                                    }
                                    let _e9748 = phi_7392_;
                                    if (_e9744 > _e9748) {
                                        phi_7397_ = _e9744;
                                    } else {
                                        phi_7397_ = _e9748;
                                    }
                                    let _e9751 = phi_7397_;
                                    if (_e9737[2] < 0f) {
                                        phi_7404_ = -(_e9737[2]);
                                    } else {
                                        phi_7404_ = _e9737[2];
                                    }
                                    let _e9755 = phi_7404_;
                                    if (_e9751 > _e9755) {
                                        phi_7409_ = _e9751;
                                    } else {
                                        phi_7409_ = _e9755;
                                    }
                                    let _e9758 = phi_7409_;
                                    let _e9761 = local_18.member[1u];
                                    if (_e9761[0] < 0f) {
                                        phi_7422_ = -(_e9761[0]);
                                    } else {
                                        phi_7422_ = _e9761[0];
                                    }
                                    let _e9768 = phi_7422_;
                                    if (_e9761[1] < 0f) {
                                        phi_7429_ = -(_e9761[1]);
                                    } else {
                                        phi_7429_ = _e9761[1];
                                    }
                                    let _e9772 = phi_7429_;
                                    if (_e9768 > _e9772) {
                                        phi_7434_ = _e9768;
                                    } else {
                                        phi_7434_ = _e9772;
                                    }
                                    let _e9775 = phi_7434_;
                                    if (_e9761[2] < 0f) {
                                        phi_7441_ = -(_e9761[2]);
                                    } else {
                                        phi_7441_ = _e9761[2];
                                    }
                                    let _e9779 = phi_7441_;
                                    if (_e9775 > _e9779) {
                                        phi_7446_ = _e9775;
                                    } else {
                                        phi_7446_ = _e9779;
                                    }
                                    let _e9782 = phi_7446_;
                                    if (_e9758 > _e9782) {
                                        phi_7451_ = _e9758;
                                    } else {
                                        phi_7451_ = _e9782;
                                    }
                                    let _e9785 = phi_7451_;
                                    let _e9787 = local_18.member_3;
                                    let _e9791 = local_18.member_1[0u];
                                    if (_e9791[0] < 0f) {
                                        phi_7468_ = -(_e9791[0]);
                                    } else {
                                        phi_7468_ = _e9791[0];
                                    }
                                    let _e9798 = phi_7468_;
                                    if (_e9791[1] < 0f) {
                                        phi_7475_ = -(_e9791[1]);
                                    } else {
                                        phi_7475_ = _e9791[1];
                                    }
                                    let _e9802 = phi_7475_;
                                    if (_e9798 > _e9802) {
                                        phi_7480_ = _e9798;
                                    } else {
                                        phi_7480_ = _e9802;
                                    }
                                    let _e9805 = phi_7480_;
                                    if (_e9791[2] < 0f) {
                                        phi_7487_ = -(_e9791[2]);
                                    } else {
                                        phi_7487_ = _e9791[2];
                                    }
                                    let _e9809 = phi_7487_;
                                    if (_e9805 > _e9809) {
                                        phi_7492_ = _e9805;
                                    } else {
                                        phi_7492_ = _e9809;
                                    }
                                    let _e9812 = phi_7492_;
                                    let _e9815 = local_18.member_1[1u];
                                    if (_e9815[0] < 0f) {
                                        phi_7506_ = -(_e9815[0]);
                                    } else {
                                        phi_7506_ = _e9815[0];
                                    }
                                    let _e9822 = phi_7506_;
                                    if (_e9815[1] < 0f) {
                                        phi_7513_ = -(_e9815[1]);
                                    } else {
                                        phi_7513_ = _e9815[1];
                                    }
                                    let _e9826 = phi_7513_;
                                    if (_e9822 > _e9826) {
                                        phi_7518_ = _e9822;
                                    } else {
                                        phi_7518_ = _e9826;
                                    }
                                    let _e9829 = phi_7518_;
                                    if (_e9815[2] < 0f) {
                                        phi_7525_ = -(_e9815[2]);
                                    } else {
                                        phi_7525_ = _e9815[2];
                                    }
                                    let _e9833 = phi_7525_;
                                    if (_e9829 > _e9833) {
                                        phi_7530_ = _e9829;
                                    } else {
                                        phi_7530_ = _e9833;
                                    }
                                    let _e9836 = phi_7530_;
                                    if (_e9812 > _e9836) {
                                        phi_7535_ = _e9812;
                                    } else {
                                        phi_7535_ = _e9836;
                                    }
                                    let _e9839 = phi_7535_;
                                    let _e9841 = local_18.member_3;
                                    let _e9845 = local_18.member_2[0u];
                                    if (_e9845[0] < 0f) {
                                        phi_7552_ = -(_e9845[0]);
                                    } else {
                                        phi_7552_ = _e9845[0];
                                    }
                                    let _e9852 = phi_7552_;
                                    if (_e9845[1] < 0f) {
                                        phi_7559_ = -(_e9845[1]);
                                    } else {
                                        phi_7559_ = _e9845[1];
                                    }
                                    let _e9856 = phi_7559_;
                                    if (_e9852 > _e9856) {
                                        phi_7564_ = _e9852;
                                    } else {
                                        phi_7564_ = _e9856;
                                    }
                                    let _e9859 = phi_7564_;
                                    if (_e9845[2] < 0f) {
                                        phi_7571_ = -(_e9845[2]);
                                    } else {
                                        phi_7571_ = _e9845[2];
                                    }
                                    let _e9863 = phi_7571_;
                                    if (_e9859 > _e9863) {
                                        phi_7576_ = _e9859;
                                    } else {
                                        phi_7576_ = _e9863;
                                    }
                                    let _e9866 = phi_7576_;
                                    let _e9869 = local_18.member_2[1u];
                                    if (_e9869[0] < 0f) {
                                        phi_7590_ = -(_e9869[0]);
                                    } else {
                                        phi_7590_ = _e9869[0];
                                    }
                                    let _e9876 = phi_7590_;
                                    if (_e9869[1] < 0f) {
                                        phi_7597_ = -(_e9869[1]);
                                    } else {
                                        phi_7597_ = _e9869[1];
                                    }
                                    let _e9880 = phi_7597_;
                                    if (_e9876 > _e9880) {
                                        phi_7602_ = _e9876;
                                    } else {
                                        phi_7602_ = _e9880;
                                    }
                                    let _e9883 = phi_7602_;
                                    if (_e9869[2] < 0f) {
                                        phi_7609_ = -(_e9869[2]);
                                    } else {
                                        phi_7609_ = _e9869[2];
                                    }
                                    let _e9887 = phi_7609_;
                                    if (_e9883 > _e9887) {
                                        phi_7614_ = _e9883;
                                    } else {
                                        phi_7614_ = _e9887;
                                    }
                                    let _e9890 = phi_7614_;
                                    if (_e9866 > _e9890) {
                                        phi_7619_ = _e9866;
                                    } else {
                                        phi_7619_ = _e9890;
                                    }
                                    let _e9893 = phi_7619_;
                                    let _e9895 = local_18.member_3;
                                    let _e9902 = local_18.member_3;
                                    let _e9909 = (((_e9731 * (1f + (0.000000059604645f * 8f))) + (((((((_e9785 + _e9787) + (_e9839 + _e9841)) + (_e9893 + _e9895)) * (0.000000059604645f * 16f)) + (_e9902 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e655.member_1);
                                    if _e9909 {
                                        phi_7639_ = false;
                                    } else {
                                        phi_7639_ = true;
                                    }
                                    let _e9911 = phi_7639_;
                                    phi_7640_ = _e9911;
                                    phi_7641_ = _e9909;
                                } else {
                                    phi_7640_ = false;
                                    phi_7641_ = false;
                                }
                                let _e9913 = phi_7640_;
                                let _e9915 = phi_7641_;
                                local_62 = _e9915;
                                continue;
                                continuing {
                                    phi_7137_ = _e9585;
                                    break if !(_e9913);
                                }
                            }
                            let _e9918 = local_62;
                            if _e9918 {
                                if (_e9556 > _e387) {
                                    phi_7649_ = 1u;
                                } else {
                                    phi_7649_ = _e9558;
                                }
                                let _e9921 = phi_7649_;
                                phi_7653_ = type_38(type_37(1u, _e9556), _e9921);
                                phi_7654_ = false;
                            } else {
                                phi_7653_ = type_38();
                                phi_7654_ = true;
                            }
                            let _e9925 = phi_7653_;
                            let _e9927 = phi_7654_;
                            if _e9927 {
                                if (_e9556 > _e387) {
                                    phi_7662_ = 0u;
                                } else {
                                    phi_7662_ = _e9558;
                                }
                                let _e9930 = phi_7662_;
                                phi_7666_ = type_38(type_37(2u, _e9556), _e9930);
                            } else {
                                phi_7666_ = _e9925;
                            }
                            let _e9934 = phi_7666_;
                            phi_7667_ = _e9934;
                            phi_7668_ = false;
                            phi_7669_ = false;
                        } else {
                            phi_7667_ = type_38();
                            phi_7668_ = _e9562;
                            phi_7669_ = _e9564;
                        }
                        let _e9936 = phi_7667_;
                        let _e9938 = phi_7668_;
                        let _e9940 = phi_7669_;
                        if _e9938 {
                            phi_7676_ = type_38(type_37(0u, f32()), 0u);
                            phi_7677_ = true;
                        } else {
                            phi_7676_ = _e9534;
                            phi_7677_ = _e9940;
                        }
                        let _e9944 = phi_7676_;
                        let _e9946 = phi_7677_;
                        phi_7681_ = _e9944;
                        phi_7682_ = _e9936;
                        phi_7683_ = _e9946;
                    } else {
                        phi_7681_ = _e6171;
                        phi_7682_ = type_38();
                        phi_7683_ = true;
                    }
                    let _e9948 = phi_7681_;
                    let _e9950 = phi_7682_;
                    let _e9952 = phi_7683_;
                    if _e9952 {
                        phi_7687_ = _e9948;
                    } else {
                        phi_7687_ = _e9950;
                    }
                    let _e9954 = phi_7687_;
                    phi_15202_ = _e9954;
                } else {
                    let _e699 = local_18.member_1[0u];
                    let _e705 = local_18.member_2[0u];
                    let _e711 = ((_e699[1] * _e705[2]) - (_e699[2] * _e705[1]));
                    let _e714 = ((_e699[2] * _e705[0]) - (_e699[0] * _e705[2]));
                    let _e717 = ((_e699[0] * _e705[1]) - (_e699[1] * _e705[0]));
                    let _e720 = local_18.member_1[1u];
                    let _e726 = local_18.member_2[1u];
                    let _e732 = ((_e720[1] * _e726[2]) - (_e720[2] * _e726[1]));
                    let _e735 = ((_e720[2] * _e726[0]) - (_e720[0] * _e726[2]));
                    let _e738 = ((_e720[0] * _e726[1]) - (_e720[1] * _e726[0]));
                    let _e741 = local_18.member_1[0u];
                    let _e747 = local_18.member_2[1u];
                    let _e762 = local_18.member_1[1u];
                    let _e768 = local_18.member_2[0u];
                    let _e781 = (((_e741[1] * _e747[2]) - (_e741[2] * _e747[1])) + ((_e762[1] * _e768[2]) - (_e762[2] * _e768[1])));
                    let _e782 = (((_e741[2] * _e747[0]) - (_e741[0] * _e747[2])) + ((_e762[2] * _e768[0]) - (_e762[0] * _e768[2])));
                    let _e783 = (((_e741[0] * _e747[1]) - (_e741[1] * _e747[0])) + ((_e762[0] * _e768[1]) - (_e762[1] * _e768[0])));
                    let _e786 = local_18.member[0u];
                    let _e794 = (((_e786[0] * _e711) + (_e786[1] * _e714)) + (_e786[2] * _e717));
                    let _e797 = local_18.member[1u];
                    let _e808 = local_18.member[0u];
                    let _e817 = ((((_e797[0] * _e711) + (_e797[1] * _e714)) + (_e797[2] * _e717)) + (((_e808[0] * _e781) + (_e808[1] * _e782)) + (_e808[2] * _e783)));
                    let _e820 = local_18.member[0u];
                    let _e831 = local_18.member[1u];
                    let _e840 = ((((_e820[0] * _e732) + (_e820[1] * _e735)) + (_e820[2] * _e738)) + (((_e831[0] * _e781) + (_e831[1] * _e782)) + (_e831[2] * _e783)));
                    let _e843 = local_18.member[1u];
                    let _e851 = (((_e843[0] * _e732) + (_e843[1] * _e735)) + (_e843[2] * _e738));
                    let _e854 = local_18.member[0u];
                    if (_e854[0] < 0f) {
                        phi_7929_ = -(_e854[0]);
                    } else {
                        phi_7929_ = _e854[0];
                    }
                    let _e861 = phi_7929_;
                    if (_e854[1] < 0f) {
                        phi_7936_ = -(_e854[1]);
                    } else {
                        phi_7936_ = _e854[1];
                    }
                    let _e865 = phi_7936_;
                    if (_e861 > _e865) {
                        phi_7941_ = _e861;
                    } else {
                        phi_7941_ = _e865;
                    }
                    let _e868 = phi_7941_;
                    if (_e854[2] < 0f) {
                        phi_7948_ = -(_e854[2]);
                    } else {
                        phi_7948_ = _e854[2];
                    }
                    let _e872 = phi_7948_;
                    if (_e868 > _e872) {
                        phi_7953_ = _e868;
                    } else {
                        phi_7953_ = _e872;
                    }
                    let _e875 = phi_7953_;
                    let _e878 = local_18.member[1u];
                    if (_e878[0] < 0f) {
                        phi_7966_ = -(_e878[0]);
                    } else {
                        phi_7966_ = _e878[0];
                    }
                    let _e885 = phi_7966_;
                    if (_e878[1] < 0f) {
                        phi_7973_ = -(_e878[1]);
                    } else {
                        phi_7973_ = _e878[1];
                    }
                    let _e889 = phi_7973_;
                    if (_e885 > _e889) {
                        phi_7978_ = _e885;
                    } else {
                        phi_7978_ = _e889;
                    }
                    let _e892 = phi_7978_;
                    if (_e878[2] < 0f) {
                        phi_7985_ = -(_e878[2]);
                    } else {
                        phi_7985_ = _e878[2];
                    }
                    let _e896 = phi_7985_;
                    if (_e892 > _e896) {
                        phi_7990_ = _e892;
                    } else {
                        phi_7990_ = _e896;
                    }
                    let _e899 = phi_7990_;
                    if (_e875 > _e899) {
                        phi_7995_ = _e875;
                    } else {
                        phi_7995_ = _e899;
                    }
                    let _e902 = phi_7995_;
                    let _e904 = local_18.member_3;
                    let _e905 = (_e902 + _e904);
                    let _e908 = local_18.member_1[0u];
                    if (_e908[0] < 0f) {
                        phi_8012_ = -(_e908[0]);
                    } else {
                        phi_8012_ = _e908[0];
                    }
                    let _e915 = phi_8012_;
                    if (_e908[1] < 0f) {
                        phi_8019_ = -(_e908[1]);
                    } else {
                        phi_8019_ = _e908[1];
                    }
                    let _e919 = phi_8019_;
                    if (_e915 > _e919) {
                        phi_8024_ = _e915;
                    } else {
                        phi_8024_ = _e919;
                    }
                    let _e922 = phi_8024_;
                    if (_e908[2] < 0f) {
                        phi_8031_ = -(_e908[2]);
                    } else {
                        phi_8031_ = _e908[2];
                    }
                    let _e926 = phi_8031_;
                    if (_e922 > _e926) {
                        phi_8036_ = _e922;
                    } else {
                        phi_8036_ = _e926;
                    }
                    let _e929 = phi_8036_;
                    let _e932 = local_18.member_1[1u];
                    if (_e932[0] < 0f) {
                        phi_8050_ = -(_e932[0]);
                    } else {
                        phi_8050_ = _e932[0];
                    }
                    let _e939 = phi_8050_;
                    if (_e932[1] < 0f) {
                        phi_8057_ = -(_e932[1]);
                    } else {
                        phi_8057_ = _e932[1];
                    }
                    let _e943 = phi_8057_;
                    if (_e939 > _e943) {
                        phi_8062_ = _e939;
                    } else {
                        phi_8062_ = _e943;
                    }
                    let _e946 = phi_8062_;
                    if (_e932[2] < 0f) {
                        phi_8069_ = -(_e932[2]);
                    } else {
                        phi_8069_ = _e932[2];
                    }
                    let _e950 = phi_8069_;
                    if (_e946 > _e950) {
                        phi_8074_ = _e946;
                    } else {
                        phi_8074_ = _e950;
                    }
                    let _e953 = phi_8074_;
                    if (_e929 > _e953) {
                        phi_8079_ = _e929;
                    } else {
                        phi_8079_ = _e953;
                    }
                    let _e956 = phi_8079_;
                    let _e958 = local_18.member_3;
                    let _e959 = (_e956 + _e958);
                    let _e962 = local_18.member_2[0u];
                    if (_e962[0] < 0f) {
                        phi_8096_ = -(_e962[0]);
                    } else {
                        phi_8096_ = _e962[0];
                    }
                    let _e969 = phi_8096_;
                    if (_e962[1] < 0f) {
                        phi_8103_ = -(_e962[1]);
                    } else {
                        phi_8103_ = _e962[1];
                    }
                    let _e973 = phi_8103_;
                    if (_e969 > _e973) {
                        phi_8108_ = _e969;
                    } else {
                        phi_8108_ = _e973;
                    }
                    let _e976 = phi_8108_;
                    if (_e962[2] < 0f) {
                        phi_8115_ = -(_e962[2]);
                    } else {
                        phi_8115_ = _e962[2];
                    }
                    let _e980 = phi_8115_;
                    if (_e976 > _e980) {
                        phi_8120_ = _e976;
                    } else {
                        phi_8120_ = _e980;
                    }
                    let _e983 = phi_8120_;
                    let _e986 = local_18.member_2[1u];
                    if (_e986[0] < 0f) {
                        phi_8134_ = -(_e986[0]);
                    } else {
                        phi_8134_ = _e986[0];
                    }
                    let _e993 = phi_8134_;
                    if (_e986[1] < 0f) {
                        phi_8141_ = -(_e986[1]);
                    } else {
                        phi_8141_ = _e986[1];
                    }
                    let _e997 = phi_8141_;
                    if (_e993 > _e997) {
                        phi_8146_ = _e993;
                    } else {
                        phi_8146_ = _e997;
                    }
                    let _e1000 = phi_8146_;
                    if (_e986[2] < 0f) {
                        phi_8153_ = -(_e986[2]);
                    } else {
                        phi_8153_ = _e986[2];
                    }
                    let _e1004 = phi_8153_;
                    if (_e1000 > _e1004) {
                        phi_8158_ = _e1000;
                    } else {
                        phi_8158_ = _e1004;
                    }
                    let _e1007 = phi_8158_;
                    if (_e983 > _e1007) {
                        phi_8163_ = _e983;
                    } else {
                        phi_8163_ = _e1007;
                    }
                    let _e1010 = phi_8163_;
                    let _e1012 = local_18.member_3;
                    let _e1013 = (_e1010 + _e1012);
                    let _e1015 = ((_e959 * 8f) * _e1013);
                    let _e1022 = local_18.member_3;
                    if (_e711 < 0f) {
                        phi_8194_ = -(_e711);
                    } else {
                        phi_8194_ = _e711;
                    }
                    let _e1039 = phi_8194_;
                    if (_e714 < 0f) {
                        phi_8200_ = -(_e714);
                    } else {
                        phi_8200_ = _e714;
                    }
                    let _e1043 = phi_8200_;
                    if (_e717 < 0f) {
                        phi_8207_ = -(_e717);
                    } else {
                        phi_8207_ = _e717;
                    }
                    let _e1048 = phi_8207_;
                    let _e1049 = ((_e1039 + _e1043) + _e1048);
                    if (_e732 < 0f) {
                        phi_8214_ = -(_e732);
                    } else {
                        phi_8214_ = _e732;
                    }
                    let _e1053 = phi_8214_;
                    if (_e735 < 0f) {
                        phi_8220_ = -(_e735);
                    } else {
                        phi_8220_ = _e735;
                    }
                    let _e1057 = phi_8220_;
                    if (_e738 < 0f) {
                        phi_8227_ = -(_e738);
                    } else {
                        phi_8227_ = _e738;
                    }
                    let _e1062 = phi_8227_;
                    let _e1063 = ((_e1053 + _e1057) + _e1062);
                    if (_e1049 > _e1063) {
                        phi_8233_ = _e1049;
                    } else {
                        phi_8233_ = _e1063;
                    }
                    let _e1066 = phi_8233_;
                    if (_e781 < 0f) {
                        phi_8239_ = -(_e781);
                    } else {
                        phi_8239_ = _e781;
                    }
                    let _e1070 = phi_8239_;
                    if (_e782 < 0f) {
                        phi_8245_ = -(_e782);
                    } else {
                        phi_8245_ = _e782;
                    }
                    let _e1074 = phi_8245_;
                    if (_e783 < 0f) {
                        phi_8252_ = -(_e783);
                    } else {
                        phi_8252_ = _e783;
                    }
                    let _e1079 = phi_8252_;
                    let _e1081 = (((_e1070 + _e1074) + _e1079) * 0.5f);
                    if (_e1066 > _e1081) {
                        phi_8259_ = _e1066;
                    } else {
                        phi_8259_ = _e1081;
                    }
                    let _e1084 = phi_8259_;
                    let _e1089 = local_18.member_3;
                    let _e1101 = (((((_e905 * 8f) * _e1015) * (0.000000059604645f * (524f / 64f))) + ((_e1022 * 19f) * ((_e905 * (_e959 + _e1013)) + (_e959 * _e1013)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e905) * ((1f + _e959) * (1f + _e1013)))));
                    let _e1102 = (_e794 * 3f);
                    let _e1103 = (_e851 * 3f);
                    if (_e1102 < _e1103) {
                        phi_8283_ = _e1102;
                    } else {
                        phi_8283_ = _e1103;
                    }
                    let _e1106 = phi_8283_;
                    if (_e817 < _e840) {
                        phi_8288_ = _e817;
                    } else {
                        phi_8288_ = _e840;
                    }
                    let _e1109 = phi_8288_;
                    if (_e1106 < _e1109) {
                        phi_8293_ = _e1106;
                    } else {
                        phi_8293_ = _e1109;
                    }
                    let _e1112 = phi_8293_;
                    if (_e1102 > _e1103) {
                        phi_8298_ = _e1102;
                    } else {
                        phi_8298_ = _e1103;
                    }
                    let _e1115 = phi_8298_;
                    if (_e817 > _e840) {
                        phi_8303_ = _e817;
                    } else {
                        phi_8303_ = _e840;
                    }
                    let _e1118 = phi_8303_;
                    if (_e1115 > _e1118) {
                        phi_8308_ = _e1115;
                    } else {
                        phi_8308_ = _e1118;
                    }
                    let _e1121 = phi_8308_;
                    let _e1126 = -(_e1121);
                    if (_e1112 > _e1126) {
                        phi_8318_ = _e1112;
                    } else {
                        phi_8318_ = _e1126;
                    }
                    let _e1129 = phi_8318_;
                    if ((_e1129 - (_e1101 + ((0f * (((_e1084 + (_e1015 * (0.000000059604645f * 8f))) + ((_e1089 * 6f) * (_e959 + _e1013))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e959) * (1f + _e1013))))) * (3f * 1.0001f)))) > 0f) {
                        phi_15172_ = type_37(0u, type_37().member_1);
                        phi_15173_ = type_37();
                        phi_15174_ = true;
                    } else {
                        if (_e794 < 0f) {
                            phi_8331_ = -(_e794);
                        } else {
                            phi_8331_ = _e794;
                        }
                        let _e1136 = phi_8331_;
                        if (_e817 < 0f) {
                            phi_8337_ = -(_e817);
                        } else {
                            phi_8337_ = _e817;
                        }
                        let _e1140 = phi_8337_;
                        if (_e1136 > _e1140) {
                            phi_8342_ = _e1136;
                        } else {
                            phi_8342_ = _e1140;
                        }
                        let _e1143 = phi_8342_;
                        if (_e840 < 0f) {
                            phi_8348_ = -(_e840);
                        } else {
                            phi_8348_ = _e840;
                        }
                        let _e1147 = phi_8348_;
                        if (_e851 < 0f) {
                            phi_8354_ = -(_e851);
                        } else {
                            phi_8354_ = _e851;
                        }
                        let _e1151 = phi_8354_;
                        if (_e1147 > _e1151) {
                            phi_8359_ = _e1147;
                        } else {
                            phi_8359_ = _e1151;
                        }
                        let _e1154 = phi_8359_;
                        if (_e1143 > _e1154) {
                            phi_8364_ = _e1143;
                        } else {
                            phi_8364_ = _e1154;
                        }
                        let _e1157 = phi_8364_;
                        let _e1158 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e1157 >= _e1158) {
                            phi_8372_ = (_e1157 <= (1f / _e1158));
                        } else {
                            phi_8372_ = false;
                        }
                        let _e1163 = phi_8372_;
                        if _e1163 {
                            phi_8377_ = (0.000000059604645f * 256f);
                        } else {
                            phi_8377_ = 2f;
                        }
                        let _e1166 = phi_8377_;
                        let _e1168 = ((_e1101 * 0.34f) + (_e1157 * _e1166));
                        if _e1163 {
                            phi_8384_ = (1f / _e1157);
                        } else {
                            phi_8384_ = 0f;
                        }
                        let _e1171 = phi_8384_;
                        let _e1172 = (_e385 * 0.0625f);
                        if (0.00000000000022737368f < _e1172) {
                            phi_8390_ = 0.00000000000022737368f;
                        } else {
                            phi_8390_ = _e1172;
                        }
                        let _e1175 = phi_8390_;
                        let _e1176 = (1f - _e387);
                        let _e1187 = ((((_e794 * _e1176) + (_e817 * _e387)) * (_e1176 * _e1176)) + (((_e840 * _e1176) + (_e851 * _e387)) * (_e387 * _e387)));
                        if (_e1187 < 0f) {
                            phi_8408_ = -(_e1187);
                        } else {
                            phi_8408_ = _e1187;
                        }
                        let _e1191 = phi_8408_;
                        if !((_e1191 > _e1168)) {
                            let _e1196 = local_18.member[0u];
                            let _e1203 = local_18.member_1[0u];
                            let _e1209 = local_18.member_2[0u];
                            let _e1213 = (_e1196[0] - _e1203[0]);
                            let _e1214 = (_e1196[1] - _e1203[1]);
                            let _e1215 = (_e1196[2] - _e1203[2]);
                            if (_e245.member == 0u) {
                                phi_8469_ = array<f32, 3>(_e1196[0], _e1196[1], _e1196[2]);
                            } else {
                                phi_8469_ = array<f32, 3>((_e1213 - _e1209[0]), (_e1214 - _e1209[1]), (_e1215 - _e1209[2]));
                            }
                            let _e1222 = phi_8469_;
                            let _e1223 = (_e1196[0] - _e1209[0]);
                            let _e1224 = (_e1196[1] - _e1209[1]);
                            let _e1225 = (_e1196[2] - _e1209[2]);
                            let _e1228 = local_18.member[1u];
                            let _e1235 = local_18.member_1[1u];
                            let _e1241 = local_18.member_2[1u];
                            let _e1245 = (_e1228[0] - _e1235[0]);
                            let _e1246 = (_e1228[1] - _e1235[1]);
                            let _e1247 = (_e1228[2] - _e1235[2]);
                            if (_e245.member == 0u) {
                                phi_8534_ = array<f32, 3>(_e1228[0], _e1228[1], _e1228[2]);
                            } else {
                                phi_8534_ = array<f32, 3>((_e1245 - _e1241[0]), (_e1246 - _e1241[1]), (_e1247 - _e1241[2]));
                            }
                            let _e1254 = phi_8534_;
                            let _e1255 = (_e1228[0] - _e1241[0]);
                            let _e1256 = (_e1228[1] - _e1241[1]);
                            let _e1257 = (_e1228[2] - _e1241[2]);
                            let _e1260 = local_18.member[0u];
                            if (_e1260[0] < 0f) {
                                phi_8556_ = -(_e1260[0]);
                            } else {
                                phi_8556_ = _e1260[0];
                            }
                            let _e1267 = phi_8556_;
                            if (_e1260[1] < 0f) {
                                phi_8563_ = -(_e1260[1]);
                            } else {
                                phi_8563_ = _e1260[1];
                            }
                            let _e1271 = phi_8563_;
                            if (_e1267 > _e1271) {
                                phi_8568_ = _e1267;
                            } else {
                                phi_8568_ = _e1271;
                            }
                            let _e1274 = phi_8568_;
                            if (_e1260[2] < 0f) {
                                phi_8575_ = -(_e1260[2]);
                            } else {
                                phi_8575_ = _e1260[2];
                            }
                            let _e1278 = phi_8575_;
                            if (_e1274 > _e1278) {
                                phi_8580_ = _e1274;
                            } else {
                                phi_8580_ = _e1278;
                            }
                            let _e1281 = phi_8580_;
                            let _e1284 = local_18.member[1u];
                            if (_e1284[0] < 0f) {
                                phi_8593_ = -(_e1284[0]);
                            } else {
                                phi_8593_ = _e1284[0];
                            }
                            let _e1291 = phi_8593_;
                            if (_e1284[1] < 0f) {
                                phi_8600_ = -(_e1284[1]);
                            } else {
                                phi_8600_ = _e1284[1];
                            }
                            let _e1295 = phi_8600_;
                            if (_e1291 > _e1295) {
                                phi_8605_ = _e1291;
                            } else {
                                phi_8605_ = _e1295;
                            }
                            let _e1298 = phi_8605_;
                            if (_e1284[2] < 0f) {
                                phi_8612_ = -(_e1284[2]);
                            } else {
                                phi_8612_ = _e1284[2];
                            }
                            let _e1302 = phi_8612_;
                            if (_e1298 > _e1302) {
                                phi_8617_ = _e1298;
                            } else {
                                phi_8617_ = _e1302;
                            }
                            let _e1305 = phi_8617_;
                            if (_e1281 > _e1305) {
                                phi_8622_ = _e1281;
                            } else {
                                phi_8622_ = _e1305;
                            }
                            let _e1308 = phi_8622_;
                            let _e1310 = local_18.member_3;
                            let _e1314 = local_18.member_1[0u];
                            if (_e1314[0] < 0f) {
                                phi_8639_ = -(_e1314[0]);
                            } else {
                                phi_8639_ = _e1314[0];
                            }
                            let _e1321 = phi_8639_;
                            if (_e1314[1] < 0f) {
                                phi_8646_ = -(_e1314[1]);
                            } else {
                                phi_8646_ = _e1314[1];
                            }
                            let _e1325 = phi_8646_;
                            if (_e1321 > _e1325) {
                                phi_8651_ = _e1321;
                            } else {
                                phi_8651_ = _e1325;
                            }
                            let _e1328 = phi_8651_;
                            if (_e1314[2] < 0f) {
                                phi_8658_ = -(_e1314[2]);
                            } else {
                                phi_8658_ = _e1314[2];
                            }
                            let _e1332 = phi_8658_;
                            if (_e1328 > _e1332) {
                                phi_8663_ = _e1328;
                            } else {
                                phi_8663_ = _e1332;
                            }
                            let _e1335 = phi_8663_;
                            let _e1338 = local_18.member_1[1u];
                            if (_e1338[0] < 0f) {
                                phi_8677_ = -(_e1338[0]);
                            } else {
                                phi_8677_ = _e1338[0];
                            }
                            let _e1345 = phi_8677_;
                            if (_e1338[1] < 0f) {
                                phi_8684_ = -(_e1338[1]);
                            } else {
                                phi_8684_ = _e1338[1];
                            }
                            let _e1349 = phi_8684_;
                            if (_e1345 > _e1349) {
                                phi_8689_ = _e1345;
                            } else {
                                phi_8689_ = _e1349;
                            }
                            let _e1352 = phi_8689_;
                            if (_e1338[2] < 0f) {
                                phi_8696_ = -(_e1338[2]);
                            } else {
                                phi_8696_ = _e1338[2];
                            }
                            let _e1356 = phi_8696_;
                            if (_e1352 > _e1356) {
                                phi_8701_ = _e1352;
                            } else {
                                phi_8701_ = _e1356;
                            }
                            let _e1359 = phi_8701_;
                            if (_e1335 > _e1359) {
                                phi_8706_ = _e1335;
                            } else {
                                phi_8706_ = _e1359;
                            }
                            let _e1362 = phi_8706_;
                            let _e1364 = local_18.member_3;
                            let _e1368 = local_18.member_2[0u];
                            if (_e1368[0] < 0f) {
                                phi_8723_ = -(_e1368[0]);
                            } else {
                                phi_8723_ = _e1368[0];
                            }
                            let _e1375 = phi_8723_;
                            if (_e1368[1] < 0f) {
                                phi_8730_ = -(_e1368[1]);
                            } else {
                                phi_8730_ = _e1368[1];
                            }
                            let _e1379 = phi_8730_;
                            if (_e1375 > _e1379) {
                                phi_8735_ = _e1375;
                            } else {
                                phi_8735_ = _e1379;
                            }
                            let _e1382 = phi_8735_;
                            if (_e1368[2] < 0f) {
                                phi_8742_ = -(_e1368[2]);
                            } else {
                                phi_8742_ = _e1368[2];
                            }
                            let _e1386 = phi_8742_;
                            if (_e1382 > _e1386) {
                                phi_8747_ = _e1382;
                            } else {
                                phi_8747_ = _e1386;
                            }
                            let _e1389 = phi_8747_;
                            let _e1392 = local_18.member_2[1u];
                            if (_e1392[0] < 0f) {
                                phi_8761_ = -(_e1392[0]);
                            } else {
                                phi_8761_ = _e1392[0];
                            }
                            let _e1399 = phi_8761_;
                            if (_e1392[1] < 0f) {
                                phi_8768_ = -(_e1392[1]);
                            } else {
                                phi_8768_ = _e1392[1];
                            }
                            let _e1403 = phi_8768_;
                            if (_e1399 > _e1403) {
                                phi_8773_ = _e1399;
                            } else {
                                phi_8773_ = _e1403;
                            }
                            let _e1406 = phi_8773_;
                            if (_e1392[2] < 0f) {
                                phi_8780_ = -(_e1392[2]);
                            } else {
                                phi_8780_ = _e1392[2];
                            }
                            let _e1410 = phi_8780_;
                            if (_e1406 > _e1410) {
                                phi_8785_ = _e1406;
                            } else {
                                phi_8785_ = _e1410;
                            }
                            let _e1413 = phi_8785_;
                            if (_e1389 > _e1413) {
                                phi_8790_ = _e1389;
                            } else {
                                phi_8790_ = _e1413;
                            }
                            let _e1416 = phi_8790_;
                            let _e1418 = local_18.member_3;
                            let _e1425 = local_18.member_3;
                            let _e1429 = ((((((_e1308 + _e1310) + (_e1362 + _e1364)) + (_e1416 + _e1418)) * (0.000000059604645f * 16f)) + (_e1425 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                            let _e1432 = local_18.member[0u];
                            let _e1438 = local_18.member[1u];
                            let _e1454 = local_18.member_1[0u];
                            let _e1460 = local_18.member_1[1u];
                            let _e1476 = local_18.member_2[0u];
                            let _e1482 = local_18.member_2[1u];
                            let _e1496 = function_3(array<f32, 3>((_e1432[0] + ((_e1438[0] - _e1432[0]) * _e387)), (_e1432[1] + ((_e1438[1] - _e1432[1]) * _e387)), (_e1432[2] + ((_e1438[2] - _e1432[2]) * _e387))), array<f32, 3>((_e1454[0] + ((_e1460[0] - _e1454[0]) * _e387)), (_e1454[1] + ((_e1460[1] - _e1454[1]) * _e387)), (_e1454[2] + ((_e1460[2] - _e1454[2]) * _e387))), array<f32, 3>((_e1476[0] + ((_e1482[0] - _e1476[0]) * _e387)), (_e1476[1] + ((_e1482[1] - _e1476[1]) * _e387)), (_e1476[2] + ((_e1482[2] - _e1476[2]) * _e387))), _e245.member);
                            if (_e1496[0] < 0f) {
                                phi_8908_ = -(_e1496[0]);
                            } else {
                                phi_8908_ = _e1496[0];
                            }
                            let _e1501 = phi_8908_;
                            if (_e1496[1] < 0f) {
                                phi_8915_ = -(_e1496[1]);
                            } else {
                                phi_8915_ = _e1496[1];
                            }
                            let _e1506 = phi_8915_;
                            if (_e1496[2] < 0f) {
                                phi_8923_ = -(_e1496[2]);
                            } else {
                                phi_8923_ = _e1496[2];
                            }
                            let _e1512 = phi_8923_;
                            let _e1513 = ((_e1501 + _e1506) + _e1512);
                            if (_e1513 > 0f) {
                                if ((bitcast<u32>(_e1513) & 2139095040u) != 2139095040u) {
                                    let _e1518 = (1f / _e1513);
                                    let _e1520 = (_e1496[0] * _e1518);
                                    let _e1522 = (_e1496[1] * _e1518);
                                    let _e1524 = (_e1496[2] * _e1518);
                                    let _e1529 = (((_e1520 * _e1520) + (_e1522 * _e1522)) + (_e1524 * _e1524));
                                    if (_e1529 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e1529 > 0f) {
                                            phi_8960_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_8960_ = 0f;
                                        }
                                        let _e1582 = phi_8960_;
                                        phi_9024_ = _e1582;
                                    } else {
                                        phi_8967_ = type_16(0i, 5i);
                                        phi_8970_ = bitcast<f32>(((bitcast<u32>(_e1529) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e1537 = phi_8967_;
                                            let _e1539 = phi_8970_;
                                            local_19 = _e1539;
                                            if (_e1537.member < _e1537.member_1) {
                                                let _e1546 = (_e1537.member + 1i);
                                                if ((false == (_e1546 > _e1537.member)) != false) {
                                                    phi_8991_ = true;
                                                } else {
                                                    phi_8991_ = false;
                                                }
                                                let _e1551 = phi_8991_;
                                                if _e1551 {
                                                    phi_8997_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_8997_ = type_17(1u, _e1546);
                                                }
                                                let _e1556 = phi_8997_;
                                                phi_8968_ = type_16(_e1556.member_1, _e1537.member_1);
                                                phi_9011_ = type_17(1u, _e1537.member);
                                            } else {
                                                phi_8968_ = _e1537;
                                                phi_9011_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e1562 = phi_8968_;
                                            let _e1564 = phi_9011_;
                                            let _e1567 = (bitcast<i32>(_e1564.member) != 0i);
                                            if _e1567 {
                                                phi_8971_ = (0.5f * (_e1539 + (_e1529 / _e1539)));
                                            } else {
                                                phi_8971_ = f32();
                                            }
                                            let _e1572 = phi_8971_;
                                            continue;
                                            continuing {
                                                phi_8967_ = _e1562;
                                                phi_8970_ = _e1572;
                                                break if !(_e1567);
                                            }
                                        }
                                        let _e1577 = local_19;
                                        phi_9024_ = (_e1577 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e1584 = phi_9024_;
                                    let _e1585 = (0.000000059604645f * 12f);
                                    let _e1590 = ((_e1429 * 1.01f) + ((0f * _e1584) * (1f + _e1585)));
                                    let _e1595 = (((_e1520 * _e1196[0]) + (_e1522 * _e1196[1])) + (_e1524 * _e1196[2]));
                                    let _e1600 = (((_e1520 * _e1213) + (_e1522 * _e1214)) + (_e1524 * _e1215));
                                    let _e1605 = (((_e1520 * _e1223) + (_e1522 * _e1224)) + (_e1524 * _e1225));
                                    let _e1613 = (((_e1520 * _e1222[0]) + (_e1522 * _e1222[1])) + (_e1524 * _e1222[2]));
                                    let _e1619 = (((_e1520 * _e1228[0]) + (_e1522 * _e1228[1])) + (_e1524 * _e1228[2]));
                                    let _e1624 = (((_e1520 * _e1245) + (_e1522 * _e1246)) + (_e1524 * _e1247));
                                    let _e1629 = (((_e1520 * _e1255) + (_e1522 * _e1256)) + (_e1524 * _e1257));
                                    let _e1637 = (((_e1520 * _e1254[0]) + (_e1522 * _e1254[1])) + (_e1524 * _e1254[2]));
                                    if (_e1595 < 0f) {
                                        phi_9090_ = -(_e1595);
                                    } else {
                                        phi_9090_ = _e1595;
                                    }
                                    let _e1642 = phi_9090_;
                                    if (_e1619 < 0f) {
                                        phi_9096_ = -(_e1619);
                                    } else {
                                        phi_9096_ = _e1619;
                                    }
                                    let _e1646 = phi_9096_;
                                    if (_e1600 < 0f) {
                                        phi_9105_ = -(_e1600);
                                    } else {
                                        phi_9105_ = _e1600;
                                    }
                                    let _e1653 = phi_9105_;
                                    if (_e1624 < 0f) {
                                        phi_9111_ = -(_e1624);
                                    } else {
                                        phi_9111_ = _e1624;
                                    }
                                    let _e1657 = phi_9111_;
                                    if (_e1605 < 0f) {
                                        phi_9120_ = -(_e1605);
                                    } else {
                                        phi_9120_ = _e1605;
                                    }
                                    let _e1664 = phi_9120_;
                                    if (_e1629 < 0f) {
                                        phi_9126_ = -(_e1629);
                                    } else {
                                        phi_9126_ = _e1629;
                                    }
                                    let _e1668 = phi_9126_;
                                    if (_e1613 < 0f) {
                                        phi_9135_ = -(_e1613);
                                    } else {
                                        phi_9135_ = _e1613;
                                    }
                                    let _e1675 = phi_9135_;
                                    if (_e1637 < 0f) {
                                        phi_9141_ = -(_e1637);
                                    } else {
                                        phi_9141_ = _e1637;
                                    }
                                    let _e1679 = phi_9141_;
                                    phi_9147_ = type_31(array<f32, 4>(_e1595, _e1600, _e1605, _e1613), array<f32, 4>(_e1619, _e1624, _e1629, _e1637), array<f32, 4>((_e1590 + ((_e1642 + _e1646) * _e1585)), (_e1590 + ((_e1653 + _e1657) * _e1585)), (_e1590 + ((_e1664 + _e1668) * _e1585)), (_e1590 + ((_e1675 + _e1679) * _e1585))));
                                    phi_9148_ = false;
                                } else {
                                    phi_9147_ = type_31();
                                    phi_9148_ = true;
                                }
                                let _e1686 = phi_9147_;
                                let _e1688 = phi_9148_;
                                phi_9149_ = _e1686;
                                phi_9150_ = _e1688;
                            } else {
                                phi_9149_ = type_31();
                                phi_9150_ = true;
                            }
                            let _e1690 = phi_9149_;
                            let _e1692 = phi_9150_;
                            if _e1692 {
                                phi_9158_ = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                            } else {
                                phi_9158_ = _e1690;
                            }
                            let _e1694 = phi_9158_;
                            local_8 = type_31(array<f32, 4>(_e1694.member[0], _e1694.member[1], _e1694.member[2], _e1694.member[3]), array<f32, 4>(_e1694.member_1[0], _e1694.member_1[1], _e1694.member_1[2], _e1694.member_1[3]), array<f32, 4>(_e1694.member_2[0], _e1694.member_2[1], _e1694.member_2[2], _e1694.member_2[3]));
                            let _e1716 = local_8.member[0u];
                            let _e1719 = local_8.member_1[0u];
                            let _e1722 = local_8.member[0u];
                            let _e1728 = local_8.member_2[0u];
                            if (((_e1716 + ((_e1719 - _e1722) * _e387)) - _e1728) > 0f) {
                                let _e1733 = local_8.member[1u];
                                let _e1736 = local_8.member_1[1u];
                                let _e1739 = local_8.member[1u];
                                let _e1745 = local_8.member_2[1u];
                                if (((_e1733 + ((_e1736 - _e1739) * _e387)) - _e1745) > 0f) {
                                    let _e1750 = local_8.member[2u];
                                    let _e1753 = local_8.member_1[2u];
                                    let _e1756 = local_8.member[2u];
                                    let _e1762 = local_8.member_2[2u];
                                    if (((_e1750 + ((_e1753 - _e1756) * _e387)) - _e1762) > 0f) {
                                        let _e1767 = local_8.member[3u];
                                        let _e1770 = local_8.member_1[3u];
                                        let _e1773 = local_8.member[3u];
                                        let _e1779 = local_8.member_2[3u];
                                        phi_9327_ = (((_e1767 + ((_e1770 - _e1773) * _e387)) - _e1779) > 0f);
                                        phi_9328_ = false;
                                    } else {
                                        phi_9327_ = bool();
                                        phi_9328_ = true;
                                    }
                                    let _e1783 = phi_9327_;
                                    let _e1785 = phi_9328_;
                                    phi_9329_ = _e1783;
                                    phi_9330_ = _e1785;
                                } else {
                                    phi_9329_ = bool();
                                    phi_9330_ = true;
                                }
                                let _e1787 = phi_9329_;
                                let _e1789 = phi_9330_;
                                phi_9331_ = _e1787;
                                phi_9332_ = _e1789;
                            } else {
                                phi_9331_ = bool();
                                phi_9332_ = true;
                            }
                            let _e1791 = phi_9331_;
                            let _e1793 = phi_9332_;
                            if _e1793 {
                                phi_9336_ = false;
                            } else {
                                phi_9336_ = _e1791;
                            }
                            let _e1795 = phi_9336_;
                            if _e1795 {
                                phi_10690_ = bool();
                                phi_10691_ = true;
                            } else {
                                if (_e1496[0] < 0f) {
                                    phi_9363_ = -(_e1496[0]);
                                } else {
                                    phi_9363_ = _e1496[0];
                                }
                                let _e1800 = phi_9363_;
                                let _e1802 = ((_e1800 + 0f) + 0f);
                                if (_e1802 > 0f) {
                                    if ((bitcast<u32>(_e1802) & 2139095040u) != 2139095040u) {
                                        let _e1807 = (1f / _e1802);
                                        let _e1808 = (_e1496[0] * _e1807);
                                        let _e1809 = (0f * _e1807);
                                        let _e1810 = (0f * _e1807);
                                        let _e1815 = (((_e1808 * _e1808) + (_e1809 * _e1809)) + (_e1810 * _e1810));
                                        if (_e1815 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e1815 > 0f) {
                                                phi_9410_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_9410_ = 0f;
                                            }
                                            let _e1868 = phi_9410_;
                                            phi_9474_ = _e1868;
                                        } else {
                                            phi_9417_ = type_16(0i, 5i);
                                            phi_9420_ = bitcast<f32>(((bitcast<u32>(_e1815) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e1823 = phi_9417_;
                                                let _e1825 = phi_9420_;
                                                local_20 = _e1825;
                                                if (_e1823.member < _e1823.member_1) {
                                                    let _e1832 = (_e1823.member + 1i);
                                                    if ((false == (_e1832 > _e1823.member)) != false) {
                                                        phi_9441_ = true;
                                                    } else {
                                                        phi_9441_ = false;
                                                    }
                                                    let _e1837 = phi_9441_;
                                                    if _e1837 {
                                                        phi_9447_ = type_17(0u, type_17().member_1);
                                                    } else {
                                                        phi_9447_ = type_17(1u, _e1832);
                                                    }
                                                    let _e1842 = phi_9447_;
                                                    phi_9418_ = type_16(_e1842.member_1, _e1823.member_1);
                                                    phi_9461_ = type_17(1u, _e1823.member);
                                                } else {
                                                    phi_9418_ = _e1823;
                                                    phi_9461_ = type_17(0u, type_17().member_1);
                                                }
                                                let _e1848 = phi_9418_;
                                                let _e1850 = phi_9461_;
                                                let _e1853 = (bitcast<i32>(_e1850.member) != 0i);
                                                if _e1853 {
                                                    phi_9421_ = (0.5f * (_e1825 + (_e1815 / _e1825)));
                                                } else {
                                                    phi_9421_ = f32();
                                                }
                                                let _e1858 = phi_9421_;
                                                continue;
                                                continuing {
                                                    phi_9417_ = _e1848;
                                                    phi_9420_ = _e1858;
                                                    break if !(_e1853);
                                                }
                                            }
                                            let _e1863 = local_20;
                                            phi_9474_ = (_e1863 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e1870 = phi_9474_;
                                        let _e1871 = (0.000000059604645f * 12f);
                                        let _e1876 = ((_e1429 * 1.01f) + ((0f * _e1870) * (1f + _e1871)));
                                        let _e1881 = (((_e1808 * _e1196[0]) + (_e1809 * _e1196[1])) + (_e1810 * _e1196[2]));
                                        let _e1886 = (((_e1808 * _e1213) + (_e1809 * _e1214)) + (_e1810 * _e1215));
                                        let _e1891 = (((_e1808 * _e1223) + (_e1809 * _e1224)) + (_e1810 * _e1225));
                                        let _e1899 = (((_e1808 * _e1222[0]) + (_e1809 * _e1222[1])) + (_e1810 * _e1222[2]));
                                        let _e1905 = (((_e1808 * _e1228[0]) + (_e1809 * _e1228[1])) + (_e1810 * _e1228[2]));
                                        let _e1910 = (((_e1808 * _e1245) + (_e1809 * _e1246)) + (_e1810 * _e1247));
                                        let _e1915 = (((_e1808 * _e1255) + (_e1809 * _e1256)) + (_e1810 * _e1257));
                                        let _e1923 = (((_e1808 * _e1254[0]) + (_e1809 * _e1254[1])) + (_e1810 * _e1254[2]));
                                        if (_e1881 < 0f) {
                                            phi_9540_ = -(_e1881);
                                        } else {
                                            phi_9540_ = _e1881;
                                        }
                                        let _e1928 = phi_9540_;
                                        if (_e1905 < 0f) {
                                            phi_9546_ = -(_e1905);
                                        } else {
                                            phi_9546_ = _e1905;
                                        }
                                        let _e1932 = phi_9546_;
                                        if (_e1886 < 0f) {
                                            phi_9555_ = -(_e1886);
                                        } else {
                                            phi_9555_ = _e1886;
                                        }
                                        let _e1939 = phi_9555_;
                                        if (_e1910 < 0f) {
                                            phi_9561_ = -(_e1910);
                                        } else {
                                            phi_9561_ = _e1910;
                                        }
                                        let _e1943 = phi_9561_;
                                        if (_e1891 < 0f) {
                                            phi_9570_ = -(_e1891);
                                        } else {
                                            phi_9570_ = _e1891;
                                        }
                                        let _e1950 = phi_9570_;
                                        if (_e1915 < 0f) {
                                            phi_9576_ = -(_e1915);
                                        } else {
                                            phi_9576_ = _e1915;
                                        }
                                        let _e1954 = phi_9576_;
                                        if (_e1899 < 0f) {
                                            phi_9585_ = -(_e1899);
                                        } else {
                                            phi_9585_ = _e1899;
                                        }
                                        let _e1961 = phi_9585_;
                                        if (_e1923 < 0f) {
                                            phi_9591_ = -(_e1923);
                                        } else {
                                            phi_9591_ = _e1923;
                                        }
                                        let _e1965 = phi_9591_;
                                        phi_9597_ = type_31(array<f32, 4>(_e1881, _e1886, _e1891, _e1899), array<f32, 4>(_e1905, _e1910, _e1915, _e1923), array<f32, 4>((_e1876 + ((_e1928 + _e1932) * _e1871)), (_e1876 + ((_e1939 + _e1943) * _e1871)), (_e1876 + ((_e1950 + _e1954) * _e1871)), (_e1876 + ((_e1961 + _e1965) * _e1871))));
                                        phi_9598_ = false;
                                    } else {
                                        phi_9597_ = type_31();
                                        phi_9598_ = true;
                                    }
                                    let _e1972 = phi_9597_;
                                    let _e1974 = phi_9598_;
                                    phi_9599_ = _e1972;
                                    phi_9600_ = _e1974;
                                } else {
                                    phi_9599_ = type_31();
                                    phi_9600_ = true;
                                }
                                let _e1976 = phi_9599_;
                                let _e1978 = phi_9600_;
                                if _e1978 {
                                    phi_9608_ = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                } else {
                                    phi_9608_ = _e1976;
                                }
                                let _e1980 = phi_9608_;
                                local_9 = type_31(array<f32, 4>(_e1980.member[0], _e1980.member[1], _e1980.member[2], _e1980.member[3]), array<f32, 4>(_e1980.member_1[0], _e1980.member_1[1], _e1980.member_1[2], _e1980.member_1[3]), array<f32, 4>(_e1980.member_2[0], _e1980.member_2[1], _e1980.member_2[2], _e1980.member_2[3]));
                                let _e2002 = local_9.member[0u];
                                let _e2005 = local_9.member_1[0u];
                                let _e2008 = local_9.member[0u];
                                let _e2014 = local_9.member_2[0u];
                                if (((_e2002 + ((_e2005 - _e2008) * _e387)) - _e2014) > 0f) {
                                    let _e2019 = local_9.member[1u];
                                    let _e2022 = local_9.member_1[1u];
                                    let _e2025 = local_9.member[1u];
                                    let _e2031 = local_9.member_2[1u];
                                    if (((_e2019 + ((_e2022 - _e2025) * _e387)) - _e2031) > 0f) {
                                        let _e2036 = local_9.member[2u];
                                        let _e2039 = local_9.member_1[2u];
                                        let _e2042 = local_9.member[2u];
                                        let _e2048 = local_9.member_2[2u];
                                        if (((_e2036 + ((_e2039 - _e2042) * _e387)) - _e2048) > 0f) {
                                            let _e2053 = local_9.member[3u];
                                            let _e2056 = local_9.member_1[3u];
                                            let _e2059 = local_9.member[3u];
                                            let _e2065 = local_9.member_2[3u];
                                            phi_9777_ = (((_e2053 + ((_e2056 - _e2059) * _e387)) - _e2065) > 0f);
                                            phi_9778_ = false;
                                        } else {
                                            phi_9777_ = bool();
                                            phi_9778_ = true;
                                        }
                                        let _e2069 = phi_9777_;
                                        let _e2071 = phi_9778_;
                                        phi_9779_ = _e2069;
                                        phi_9780_ = _e2071;
                                    } else {
                                        phi_9779_ = bool();
                                        phi_9780_ = true;
                                    }
                                    let _e2073 = phi_9779_;
                                    let _e2075 = phi_9780_;
                                    phi_9781_ = _e2073;
                                    phi_9782_ = _e2075;
                                } else {
                                    phi_9781_ = bool();
                                    phi_9782_ = true;
                                }
                                let _e2077 = phi_9781_;
                                let _e2079 = phi_9782_;
                                if _e2079 {
                                    phi_9786_ = false;
                                } else {
                                    phi_9786_ = _e2077;
                                }
                                let _e2081 = phi_9786_;
                                if _e2081 {
                                    phi_10688_ = bool();
                                    phi_10689_ = true;
                                } else {
                                    if (_e1496[1] < 0f) {
                                        phi_9819_ = -(_e1496[1]);
                                    } else {
                                        phi_9819_ = _e1496[1];
                                    }
                                    let _e2086 = phi_9819_;
                                    let _e2088 = ((0f + _e2086) + 0f);
                                    if (_e2088 > 0f) {
                                        if ((bitcast<u32>(_e2088) & 2139095040u) != 2139095040u) {
                                            let _e2093 = (1f / _e2088);
                                            let _e2094 = (0f * _e2093);
                                            let _e2095 = (_e1496[1] * _e2093);
                                            let _e2096 = (0f * _e2093);
                                            let _e2101 = (((_e2094 * _e2094) + (_e2095 * _e2095)) + (_e2096 * _e2096));
                                            if (_e2101 <= 0.000000000000000000000000000000000000011754944f) {
                                                if (_e2101 > 0f) {
                                                    phi_9860_ = (0.000000000000000000106433627f * 2f);
                                                } else {
                                                    phi_9860_ = 0f;
                                                }
                                                let _e2154 = phi_9860_;
                                                phi_9924_ = _e2154;
                                            } else {
                                                phi_9867_ = type_16(0i, 5i);
                                                phi_9870_ = bitcast<f32>(((bitcast<u32>(_e2101) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e2109 = phi_9867_;
                                                    let _e2111 = phi_9870_;
                                                    local_21 = _e2111;
                                                    if (_e2109.member < _e2109.member_1) {
                                                        let _e2118 = (_e2109.member + 1i);
                                                        if ((false == (_e2118 > _e2109.member)) != false) {
                                                            phi_9891_ = true;
                                                        } else {
                                                            phi_9891_ = false;
                                                        }
                                                        let _e2123 = phi_9891_;
                                                        if _e2123 {
                                                            phi_9897_ = type_17(0u, type_17().member_1);
                                                        } else {
                                                            phi_9897_ = type_17(1u, _e2118);
                                                        }
                                                        let _e2128 = phi_9897_;
                                                        phi_9868_ = type_16(_e2128.member_1, _e2109.member_1);
                                                        phi_9911_ = type_17(1u, _e2109.member);
                                                    } else {
                                                        phi_9868_ = _e2109;
                                                        phi_9911_ = type_17(0u, type_17().member_1);
                                                    }
                                                    let _e2134 = phi_9868_;
                                                    let _e2136 = phi_9911_;
                                                    let _e2139 = (bitcast<i32>(_e2136.member) != 0i);
                                                    if _e2139 {
                                                        phi_9871_ = (0.5f * (_e2111 + (_e2101 / _e2111)));
                                                    } else {
                                                        phi_9871_ = f32();
                                                    }
                                                    let _e2144 = phi_9871_;
                                                    continue;
                                                    continuing {
                                                        phi_9867_ = _e2134;
                                                        phi_9870_ = _e2144;
                                                        break if !(_e2139);
                                                    }
                                                }
                                                let _e2149 = local_21;
                                                phi_9924_ = (_e2149 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e2156 = phi_9924_;
                                            let _e2157 = (0.000000059604645f * 12f);
                                            let _e2162 = ((_e1429 * 1.01f) + ((0f * _e2156) * (1f + _e2157)));
                                            let _e2167 = (((_e2094 * _e1196[0]) + (_e2095 * _e1196[1])) + (_e2096 * _e1196[2]));
                                            let _e2172 = (((_e2094 * _e1213) + (_e2095 * _e1214)) + (_e2096 * _e1215));
                                            let _e2177 = (((_e2094 * _e1223) + (_e2095 * _e1224)) + (_e2096 * _e1225));
                                            let _e2185 = (((_e2094 * _e1222[0]) + (_e2095 * _e1222[1])) + (_e2096 * _e1222[2]));
                                            let _e2191 = (((_e2094 * _e1228[0]) + (_e2095 * _e1228[1])) + (_e2096 * _e1228[2]));
                                            let _e2196 = (((_e2094 * _e1245) + (_e2095 * _e1246)) + (_e2096 * _e1247));
                                            let _e2201 = (((_e2094 * _e1255) + (_e2095 * _e1256)) + (_e2096 * _e1257));
                                            let _e2209 = (((_e2094 * _e1254[0]) + (_e2095 * _e1254[1])) + (_e2096 * _e1254[2]));
                                            if (_e2167 < 0f) {
                                                phi_9990_ = -(_e2167);
                                            } else {
                                                phi_9990_ = _e2167;
                                            }
                                            let _e2214 = phi_9990_;
                                            if (_e2191 < 0f) {
                                                phi_9996_ = -(_e2191);
                                            } else {
                                                phi_9996_ = _e2191;
                                            }
                                            let _e2218 = phi_9996_;
                                            if (_e2172 < 0f) {
                                                phi_10005_ = -(_e2172);
                                            } else {
                                                phi_10005_ = _e2172;
                                            }
                                            let _e2225 = phi_10005_;
                                            if (_e2196 < 0f) {
                                                phi_10011_ = -(_e2196);
                                            } else {
                                                phi_10011_ = _e2196;
                                            }
                                            let _e2229 = phi_10011_;
                                            if (_e2177 < 0f) {
                                                phi_10020_ = -(_e2177);
                                            } else {
                                                phi_10020_ = _e2177;
                                            }
                                            let _e2236 = phi_10020_;
                                            if (_e2201 < 0f) {
                                                phi_10026_ = -(_e2201);
                                            } else {
                                                phi_10026_ = _e2201;
                                            }
                                            let _e2240 = phi_10026_;
                                            if (_e2185 < 0f) {
                                                phi_10035_ = -(_e2185);
                                            } else {
                                                phi_10035_ = _e2185;
                                            }
                                            let _e2247 = phi_10035_;
                                            if (_e2209 < 0f) {
                                                phi_10041_ = -(_e2209);
                                            } else {
                                                phi_10041_ = _e2209;
                                            }
                                            let _e2251 = phi_10041_;
                                            phi_10047_ = type_31(array<f32, 4>(_e2167, _e2172, _e2177, _e2185), array<f32, 4>(_e2191, _e2196, _e2201, _e2209), array<f32, 4>((_e2162 + ((_e2214 + _e2218) * _e2157)), (_e2162 + ((_e2225 + _e2229) * _e2157)), (_e2162 + ((_e2236 + _e2240) * _e2157)), (_e2162 + ((_e2247 + _e2251) * _e2157))));
                                            phi_10048_ = false;
                                        } else {
                                            phi_10047_ = type_31();
                                            phi_10048_ = true;
                                        }
                                        let _e2258 = phi_10047_;
                                        let _e2260 = phi_10048_;
                                        phi_10049_ = _e2258;
                                        phi_10050_ = _e2260;
                                    } else {
                                        phi_10049_ = type_31();
                                        phi_10050_ = true;
                                    }
                                    let _e2262 = phi_10049_;
                                    let _e2264 = phi_10050_;
                                    if _e2264 {
                                        phi_10058_ = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    } else {
                                        phi_10058_ = _e2262;
                                    }
                                    let _e2266 = phi_10058_;
                                    local_10 = type_31(array<f32, 4>(_e2266.member[0], _e2266.member[1], _e2266.member[2], _e2266.member[3]), array<f32, 4>(_e2266.member_1[0], _e2266.member_1[1], _e2266.member_1[2], _e2266.member_1[3]), array<f32, 4>(_e2266.member_2[0], _e2266.member_2[1], _e2266.member_2[2], _e2266.member_2[3]));
                                    let _e2288 = local_10.member[0u];
                                    let _e2291 = local_10.member_1[0u];
                                    let _e2294 = local_10.member[0u];
                                    let _e2300 = local_10.member_2[0u];
                                    if (((_e2288 + ((_e2291 - _e2294) * _e387)) - _e2300) > 0f) {
                                        let _e2305 = local_10.member[1u];
                                        let _e2308 = local_10.member_1[1u];
                                        let _e2311 = local_10.member[1u];
                                        let _e2317 = local_10.member_2[1u];
                                        if (((_e2305 + ((_e2308 - _e2311) * _e387)) - _e2317) > 0f) {
                                            let _e2322 = local_10.member[2u];
                                            let _e2325 = local_10.member_1[2u];
                                            let _e2328 = local_10.member[2u];
                                            let _e2334 = local_10.member_2[2u];
                                            if (((_e2322 + ((_e2325 - _e2328) * _e387)) - _e2334) > 0f) {
                                                let _e2339 = local_10.member[3u];
                                                let _e2342 = local_10.member_1[3u];
                                                let _e2345 = local_10.member[3u];
                                                let _e2351 = local_10.member_2[3u];
                                                phi_10227_ = (((_e2339 + ((_e2342 - _e2345) * _e387)) - _e2351) > 0f);
                                                phi_10228_ = false;
                                            } else {
                                                phi_10227_ = bool();
                                                phi_10228_ = true;
                                            }
                                            let _e2355 = phi_10227_;
                                            let _e2357 = phi_10228_;
                                            phi_10229_ = _e2355;
                                            phi_10230_ = _e2357;
                                        } else {
                                            phi_10229_ = bool();
                                            phi_10230_ = true;
                                        }
                                        let _e2359 = phi_10229_;
                                        let _e2361 = phi_10230_;
                                        phi_10231_ = _e2359;
                                        phi_10232_ = _e2361;
                                    } else {
                                        phi_10231_ = bool();
                                        phi_10232_ = true;
                                    }
                                    let _e2363 = phi_10231_;
                                    let _e2365 = phi_10232_;
                                    if _e2365 {
                                        phi_10236_ = false;
                                    } else {
                                        phi_10236_ = _e2363;
                                    }
                                    let _e2367 = phi_10236_;
                                    if _e2367 {
                                        phi_10687_ = bool();
                                    } else {
                                        if (_e1496[2] < 0f) {
                                            phi_10276_ = -(_e1496[2]);
                                        } else {
                                            phi_10276_ = _e1496[2];
                                        }
                                        let _e2373 = phi_10276_;
                                        let _e2374 = ((0f + 0f) + _e2373);
                                        if (_e2374 > 0f) {
                                            if ((bitcast<u32>(_e2374) & 2139095040u) != 2139095040u) {
                                                let _e2379 = (1f / _e2374);
                                                let _e2380 = (0f * _e2379);
                                                let _e2381 = (0f * _e2379);
                                                let _e2382 = (_e1496[2] * _e2379);
                                                let _e2387 = (((_e2380 * _e2380) + (_e2381 * _e2381)) + (_e2382 * _e2382));
                                                if (_e2387 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e2387 > 0f) {
                                                        phi_10310_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_10310_ = 0f;
                                                    }
                                                    let _e2440 = phi_10310_;
                                                    phi_10374_ = _e2440;
                                                } else {
                                                    phi_10317_ = type_16(0i, 5i);
                                                    phi_10320_ = bitcast<f32>(((bitcast<u32>(_e2387) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e2395 = phi_10317_;
                                                        let _e2397 = phi_10320_;
                                                        local_22 = _e2397;
                                                        if (_e2395.member < _e2395.member_1) {
                                                            let _e2404 = (_e2395.member + 1i);
                                                            if ((false == (_e2404 > _e2395.member)) != false) {
                                                                phi_10341_ = true;
                                                            } else {
                                                                phi_10341_ = false;
                                                            }
                                                            let _e2409 = phi_10341_;
                                                            if _e2409 {
                                                                phi_10347_ = type_17(0u, type_17().member_1);
                                                            } else {
                                                                phi_10347_ = type_17(1u, _e2404);
                                                            }
                                                            let _e2414 = phi_10347_;
                                                            phi_10318_ = type_16(_e2414.member_1, _e2395.member_1);
                                                            phi_10361_ = type_17(1u, _e2395.member);
                                                        } else {
                                                            phi_10318_ = _e2395;
                                                            phi_10361_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e2420 = phi_10318_;
                                                        let _e2422 = phi_10361_;
                                                        let _e2425 = (bitcast<i32>(_e2422.member) != 0i);
                                                        if _e2425 {
                                                            phi_10321_ = (0.5f * (_e2397 + (_e2387 / _e2397)));
                                                        } else {
                                                            phi_10321_ = f32();
                                                        }
                                                        let _e2430 = phi_10321_;
                                                        continue;
                                                        continuing {
                                                            phi_10317_ = _e2420;
                                                            phi_10320_ = _e2430;
                                                            break if !(_e2425);
                                                        }
                                                    }
                                                    let _e2435 = local_22;
                                                    phi_10374_ = (_e2435 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e2442 = phi_10374_;
                                                let _e2443 = (0.000000059604645f * 12f);
                                                let _e2448 = ((_e1429 * 1.01f) + ((0f * _e2442) * (1f + _e2443)));
                                                let _e2453 = (((_e2380 * _e1196[0]) + (_e2381 * _e1196[1])) + (_e2382 * _e1196[2]));
                                                let _e2458 = (((_e2380 * _e1213) + (_e2381 * _e1214)) + (_e2382 * _e1215));
                                                let _e2463 = (((_e2380 * _e1223) + (_e2381 * _e1224)) + (_e2382 * _e1225));
                                                let _e2471 = (((_e2380 * _e1222[0]) + (_e2381 * _e1222[1])) + (_e2382 * _e1222[2]));
                                                let _e2477 = (((_e2380 * _e1228[0]) + (_e2381 * _e1228[1])) + (_e2382 * _e1228[2]));
                                                let _e2482 = (((_e2380 * _e1245) + (_e2381 * _e1246)) + (_e2382 * _e1247));
                                                let _e2487 = (((_e2380 * _e1255) + (_e2381 * _e1256)) + (_e2382 * _e1257));
                                                let _e2495 = (((_e2380 * _e1254[0]) + (_e2381 * _e1254[1])) + (_e2382 * _e1254[2]));
                                                if (_e2453 < 0f) {
                                                    phi_10440_ = -(_e2453);
                                                } else {
                                                    phi_10440_ = _e2453;
                                                }
                                                let _e2500 = phi_10440_;
                                                if (_e2477 < 0f) {
                                                    phi_10446_ = -(_e2477);
                                                } else {
                                                    phi_10446_ = _e2477;
                                                }
                                                let _e2504 = phi_10446_;
                                                if (_e2458 < 0f) {
                                                    phi_10455_ = -(_e2458);
                                                } else {
                                                    phi_10455_ = _e2458;
                                                }
                                                let _e2511 = phi_10455_;
                                                if (_e2482 < 0f) {
                                                    phi_10461_ = -(_e2482);
                                                } else {
                                                    phi_10461_ = _e2482;
                                                }
                                                let _e2515 = phi_10461_;
                                                if (_e2463 < 0f) {
                                                    phi_10470_ = -(_e2463);
                                                } else {
                                                    phi_10470_ = _e2463;
                                                }
                                                let _e2522 = phi_10470_;
                                                if (_e2487 < 0f) {
                                                    phi_10476_ = -(_e2487);
                                                } else {
                                                    phi_10476_ = _e2487;
                                                }
                                                let _e2526 = phi_10476_;
                                                if (_e2471 < 0f) {
                                                    phi_10485_ = -(_e2471);
                                                } else {
                                                    phi_10485_ = _e2471;
                                                }
                                                let _e2533 = phi_10485_;
                                                if (_e2495 < 0f) {
                                                    phi_10491_ = -(_e2495);
                                                } else {
                                                    phi_10491_ = _e2495;
                                                }
                                                let _e2537 = phi_10491_;
                                                phi_10497_ = type_31(array<f32, 4>(_e2453, _e2458, _e2463, _e2471), array<f32, 4>(_e2477, _e2482, _e2487, _e2495), array<f32, 4>((_e2448 + ((_e2500 + _e2504) * _e2443)), (_e2448 + ((_e2511 + _e2515) * _e2443)), (_e2448 + ((_e2522 + _e2526) * _e2443)), (_e2448 + ((_e2533 + _e2537) * _e2443))));
                                                phi_10498_ = false;
                                            } else {
                                                phi_10497_ = type_31();
                                                phi_10498_ = true;
                                            }
                                            let _e2544 = phi_10497_;
                                            let _e2546 = phi_10498_;
                                            phi_10499_ = _e2544;
                                            phi_10500_ = _e2546;
                                        } else {
                                            phi_10499_ = type_31();
                                            phi_10500_ = true;
                                        }
                                        let _e2548 = phi_10499_;
                                        let _e2550 = phi_10500_;
                                        if _e2550 {
                                            phi_10508_ = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        } else {
                                            phi_10508_ = _e2548;
                                        }
                                        let _e2552 = phi_10508_;
                                        local_11 = type_31(array<f32, 4>(_e2552.member[0], _e2552.member[1], _e2552.member[2], _e2552.member[3]), array<f32, 4>(_e2552.member_1[0], _e2552.member_1[1], _e2552.member_1[2], _e2552.member_1[3]), array<f32, 4>(_e2552.member_2[0], _e2552.member_2[1], _e2552.member_2[2], _e2552.member_2[3]));
                                        let _e2574 = local_11.member[0u];
                                        let _e2577 = local_11.member_1[0u];
                                        let _e2580 = local_11.member[0u];
                                        let _e2586 = local_11.member_2[0u];
                                        if (((_e2574 + ((_e2577 - _e2580) * _e387)) - _e2586) > 0f) {
                                            let _e2591 = local_11.member[1u];
                                            let _e2594 = local_11.member_1[1u];
                                            let _e2597 = local_11.member[1u];
                                            let _e2603 = local_11.member_2[1u];
                                            if (((_e2591 + ((_e2594 - _e2597) * _e387)) - _e2603) > 0f) {
                                                let _e2608 = local_11.member[2u];
                                                let _e2611 = local_11.member_1[2u];
                                                let _e2614 = local_11.member[2u];
                                                let _e2620 = local_11.member_2[2u];
                                                if (((_e2608 + ((_e2611 - _e2614) * _e387)) - _e2620) > 0f) {
                                                    let _e2625 = local_11.member[3u];
                                                    let _e2628 = local_11.member_1[3u];
                                                    let _e2631 = local_11.member[3u];
                                                    let _e2637 = local_11.member_2[3u];
                                                    phi_10677_ = (((_e2625 + ((_e2628 - _e2631) * _e387)) - _e2637) > 0f);
                                                    phi_10678_ = false;
                                                } else {
                                                    phi_10677_ = bool();
                                                    phi_10678_ = true;
                                                }
                                                let _e2641 = phi_10677_;
                                                let _e2643 = phi_10678_;
                                                phi_10679_ = _e2641;
                                                phi_10680_ = _e2643;
                                            } else {
                                                phi_10679_ = bool();
                                                phi_10680_ = true;
                                            }
                                            let _e2645 = phi_10679_;
                                            let _e2647 = phi_10680_;
                                            phi_10681_ = _e2645;
                                            phi_10682_ = _e2647;
                                        } else {
                                            phi_10681_ = bool();
                                            phi_10682_ = true;
                                        }
                                        let _e2649 = phi_10681_;
                                        let _e2651 = phi_10682_;
                                        if _e2651 {
                                            phi_10686_ = false;
                                        } else {
                                            phi_10686_ = _e2649;
                                        }
                                        let _e2653 = phi_10686_;
                                        phi_10687_ = _e2653;
                                    }
                                    let _e2655 = phi_10687_;
                                    phi_10688_ = _e2655;
                                    phi_10689_ = _e2367;
                                }
                                let _e2657 = phi_10688_;
                                let _e2659 = phi_10689_;
                                phi_10690_ = _e2657;
                                phi_10691_ = _e2659;
                            }
                            let _e2661 = phi_10690_;
                            let _e2663 = phi_10691_;
                            if _e2663 {
                                phi_10695_ = true;
                            } else {
                                phi_10695_ = _e2661;
                            }
                            let _e2665 = phi_10695_;
                            if !(_e2665) {
                                phi_10701_ = type_37(2u, _e387);
                                phi_10702_ = false;
                            } else {
                                phi_10701_ = type_37();
                                phi_10702_ = true;
                            }
                            let _e2669 = phi_10701_;
                            let _e2671 = phi_10702_;
                            phi_10703_ = _e2669;
                            phi_10704_ = _e2671;
                        } else {
                            phi_10703_ = type_37();
                            phi_10704_ = true;
                        }
                        let _e2673 = phi_10703_;
                        let _e2675 = phi_10704_;
                        if _e2675 {
                            let _e2681 = ((_e817 - (3f * _e794)) * _e1171);
                            let _e2682 = ((_e840 - _e817) * _e1171);
                            let _e2683 = (((3f * _e851) - _e840) * _e1171);
                            local_6[0u] = 0f;
                            local_6[1u] = 1f;
                            local_6[2u] = 1f;
                            local_6[3u] = 1f;
                            let _e2690 = ((_e2682 * _e2682) - (_e2681 * _e2683));
                            if (_e2690 > 0f) {
                                if (_e2690 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e2690 > 0f) {
                                        phi_10740_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_10740_ = 0f;
                                    }
                                    let _e2744 = phi_10740_;
                                    phi_10804_ = _e2744;
                                } else {
                                    phi_10747_ = type_16(0i, 5i);
                                    phi_10750_ = bitcast<f32>(((bitcast<u32>(_e2690) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e2699 = phi_10747_;
                                        let _e2701 = phi_10750_;
                                        local_23 = _e2701;
                                        if (_e2699.member < _e2699.member_1) {
                                            let _e2708 = (_e2699.member + 1i);
                                            if ((false == (_e2708 > _e2699.member)) != false) {
                                                phi_10771_ = true;
                                            } else {
                                                phi_10771_ = false;
                                            }
                                            let _e2713 = phi_10771_;
                                            if _e2713 {
                                                phi_10777_ = type_17(0u, type_17().member_1);
                                            } else {
                                                phi_10777_ = type_17(1u, _e2708);
                                            }
                                            let _e2718 = phi_10777_;
                                            phi_10748_ = type_16(_e2718.member_1, _e2699.member_1);
                                            phi_10791_ = type_17(1u, _e2699.member);
                                        } else {
                                            phi_10748_ = _e2699;
                                            phi_10791_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e2724 = phi_10748_;
                                        let _e2726 = phi_10791_;
                                        let _e2729 = (bitcast<i32>(_e2726.member) != 0i);
                                        if _e2729 {
                                            phi_10751_ = (0.5f * (_e2701 + (_e2690 / _e2701)));
                                        } else {
                                            phi_10751_ = f32();
                                        }
                                        let _e2734 = phi_10751_;
                                        continue;
                                        continuing {
                                            phi_10747_ = _e2724;
                                            phi_10750_ = _e2734;
                                            break if !(_e2729);
                                        }
                                    }
                                    let _e2739 = local_23;
                                    phi_10804_ = (_e2739 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e2746 = phi_10804_;
                                if (_e2682 < 0f) {
                                    phi_10810_ = -(_e2746);
                                } else {
                                    phi_10810_ = _e2746;
                                }
                                let _e2750 = phi_10810_;
                                let _e2752 = -((_e2682 + _e2750));
                                local_7[0u] = (_e2752 / (_e2752 + _e2683));
                                local_7[1u] = (_e2681 / (_e2681 + _e2752));
                                let _e2761 = local_7[1u];
                                let _e2762 = local_7[0u];
                                if (_e2761 < _e2762) {
                                    let _e2765 = local_7[1u];
                                    let _e2767 = local_7[0u];
                                    local_7[0u] = _e2765;
                                    local_7[1u] = _e2767;
                                }
                                phi_10835_ = type_9(0u, 2u);
                                phi_10838_ = 1u;
                                loop {
                                    let _e2771 = phi_10835_;
                                    let _e2773 = phi_10838_;
                                    local_63 = _e2773;
                                    if (_e2771.member < _e2771.member_1) {
                                        phi_10836_ = type_9((_e2771.member + 1u), _e2771.member_1);
                                        phi_10861_ = type_9(1u, _e2771.member);
                                    } else {
                                        phi_10836_ = _e2771;
                                        phi_10861_ = type_9(0u, type_9().member_1);
                                    }
                                    let _e2785 = phi_10836_;
                                    let _e2787 = phi_10861_;
                                    let _e2791 = (bitcast<i32>(_e2787.member) != 0i);
                                    if _e2791 {
                                        let _e2793 = local_7[_e2787.member_1];
                                        if (_e2793 > 0f) {
                                            let _e2796 = local_7[_e2787.member_1];
                                            if (_e2796 < 1f) {
                                                let _e2799 = local_7[_e2787.member_1];
                                                local_6[_e2773] = _e2799;
                                                phi_10905_ = (_e2773 + 1u);
                                            } else {
                                                phi_10905_ = _e2773;
                                            }
                                            let _e2803 = phi_10905_;
                                            phi_10906_ = _e2803;
                                        } else {
                                            phi_10906_ = _e2773;
                                        }
                                        let _e2805 = phi_10906_;
                                        phi_10839_ = _e2805;
                                    } else {
                                        phi_10839_ = u32();
                                    }
                                    let _e2807 = phi_10839_;
                                    continue;
                                    continuing {
                                        phi_10835_ = _e2785;
                                        phi_10838_ = _e2807;
                                        break if !(_e2791);
                                    }
                                }
                                let _e10457 = local_63;
                                phi_10907_ = _e10457;
                            } else {
                                phi_10907_ = 1u;
                            }
                            let _e2810 = phi_10907_;
                            local_6[_e2810] = 1f;
                            let _e2812 = local_6;
                            local_12 = _e2812;
                            phi_10927_ = type_9(0u, _e2810);
                            loop {
                                let _e2815 = phi_10927_;
                                if (_e2815.member < _e2815.member_1) {
                                    phi_10928_ = type_9((_e2815.member + 1u), _e2815.member_1);
                                    phi_10951_ = type_9(1u, _e2815.member);
                                } else {
                                    phi_10928_ = _e2815;
                                    phi_10951_ = type_9(0u, type_9().member_1);
                                }
                                let _e2827 = phi_10928_;
                                let _e2829 = phi_10951_;
                                if (bitcast<i32>(_e2829.member) != 0i) {
                                    let _e2835 = local_12[_e2829.member_1];
                                    if (_e2835 > _e387) {
                                        phi_10970_ = _e2835;
                                    } else {
                                        phi_10970_ = _e387;
                                    }
                                    let _e2838 = phi_10970_;
                                    let _e2841 = local_12[(_e2829.member_1 + 1u)];
                                    if (_e2841 < _e389) {
                                        phi_10983_ = _e2841;
                                    } else {
                                        phi_10983_ = _e389;
                                    }
                                    let _e2844 = phi_10983_;
                                    if (_e2838 <= _e2844) {
                                        let _e2846 = (1f - _e2838);
                                        let _e2857 = ((((_e794 * _e2846) + (_e817 * _e2838)) * (_e2846 * _e2846)) + (((_e840 * _e2846) + (_e851 * _e2838)) * (_e2838 * _e2838)));
                                        let _e2858 = (1f - _e2844);
                                        let _e2869 = ((((_e794 * _e2858) + (_e817 * _e2844)) * (_e2858 * _e2858)) + (((_e840 * _e2858) + (_e851 * _e2844)) * (_e2844 * _e2844)));
                                        if (_e2857 < 0f) {
                                            phi_11017_ = -(_e2857);
                                        } else {
                                            phi_11017_ = _e2857;
                                        }
                                        let _e2873 = phi_11017_;
                                        let _e2874 = (_e2873 > _e1168);
                                        if (_e2869 < 0f) {
                                            phi_11024_ = -(_e2869);
                                        } else {
                                            phi_11024_ = _e2869;
                                        }
                                        let _e2878 = phi_11024_;
                                        let _e2879 = (_e2878 > _e1168);
                                        if _e2874 {
                                            if _e2879 {
                                                phi_11035_ = ((_e2857 > 0f) != (_e2869 > 0f));
                                                phi_11036_ = false;
                                            } else {
                                                phi_11035_ = bool();
                                                phi_11036_ = true;
                                            }
                                            let _e2884 = phi_11035_;
                                            let _e2886 = phi_11036_;
                                            phi_11037_ = _e2884;
                                            phi_11038_ = _e2886;
                                        } else {
                                            phi_11037_ = bool();
                                            phi_11038_ = true;
                                        }
                                        let _e2888 = phi_11037_;
                                        let _e2890 = phi_11038_;
                                        if _e2890 {
                                            phi_11042_ = false;
                                        } else {
                                            phi_11042_ = _e2888;
                                        }
                                        let _e2892 = phi_11042_;
                                        if _e2874 {
                                            if _e2879 {
                                                if _e2892 {
                                                    phi_11053_ = type_40();
                                                } else {
                                                    phi_11053_ = type_40(1f, 0f, _e2892);
                                                }
                                                let _e2895 = phi_11053_;
                                                phi_11054_ = _e2895;
                                                phi_11055_ = _e2892;
                                            } else {
                                                phi_11054_ = type_40();
                                                phi_11055_ = true;
                                            }
                                            let _e2897 = phi_11054_;
                                            let _e2899 = phi_11055_;
                                            phi_11056_ = _e2897;
                                            phi_11057_ = _e2899;
                                        } else {
                                            phi_11056_ = type_40();
                                            phi_11057_ = true;
                                        }
                                        let _e2901 = phi_11056_;
                                        let _e2903 = phi_11057_;
                                        if _e2903 {
                                            if _e2874 {
                                                if (_e2857 < 0f) {
                                                    phi_11068_ = -1f;
                                                } else {
                                                    phi_11068_ = 1f;
                                                }
                                                let _e2906 = phi_11068_;
                                                let _e2909 = (_e840 - _e817);
                                                phi_11078_ = type_9(0u, 64u);
                                                phi_11081_ = _e2844;
                                                phi_11083_ = _e2838;
                                                phi_11085_ = (0.5f * (_e2838 + _e2844));
                                                loop {
                                                    let _e2915 = phi_11078_;
                                                    let _e2917 = phi_11081_;
                                                    let _e2919 = phi_11083_;
                                                    let _e2921 = phi_11085_;
                                                    local_65 = _e2919;
                                                    if (_e2915.member < _e2915.member_1) {
                                                        phi_11079_ = type_9((_e2915.member + 1u), _e2915.member_1);
                                                        phi_11108_ = type_9(1u, _e2915.member);
                                                    } else {
                                                        phi_11079_ = _e2915;
                                                        phi_11108_ = type_9(0u, type_9().member_1);
                                                    }
                                                    let _e2933 = phi_11079_;
                                                    let _e2935 = phi_11108_;
                                                    if (bitcast<i32>(_e2935.member) != 0i) {
                                                        let _e2939 = (1f - _e2921);
                                                        let _e2952 = ((_e2906 * ((((_e794 * _e2939) + (_e817 * _e2921)) * (_e2939 * _e2939)) + (((_e840 * _e2939) + (_e851 * _e2921)) * (_e2921 * _e2921)))) - _e1168);
                                                        if (_e2952 > 0f) {
                                                            phi_11133_ = _e2917;
                                                            phi_11134_ = _e2921;
                                                        } else {
                                                            phi_11133_ = _e2921;
                                                            phi_11134_ = _e2919;
                                                        }
                                                        let _e2955 = phi_11133_;
                                                        let _e2957 = phi_11134_;
                                                        let _e2959 = ((_e2955 - _e2957) > _e1175);
                                                        if _e2959 {
                                                            let _e2960 = (1f - _e2921);
                                                            let _e2972 = (-(_e2952) / (_e2906 * (((((_e817 - (3f * _e794)) * _e2960) + (_e2909 * _e2921)) * _e2960) + (((_e2909 * _e2960) + (((3f * _e851) - _e840) * _e2921)) * _e2921))));
                                                            if (_e2952 > 0f) {
                                                                phi_11160_ = (0.5f * _e1175);
                                                            } else {
                                                                phi_11160_ = -((0.5f * _e1175));
                                                            }
                                                            let _e2978 = phi_11160_;
                                                            let _e2980 = ((_e2921 + _e2972) + _e2978);
                                                            if (_e2980 > _e2957) {
                                                                if (_e2980 < _e2955) {
                                                                    if (_e2972 < 0f) {
                                                                        phi_11176_ = -(_e2972);
                                                                    } else {
                                                                        phi_11176_ = _e2972;
                                                                    }
                                                                    let _e2986 = phi_11176_;
                                                                    if (_e2986 < (0.5f * (_e2955 - _e2957))) {
                                                                        phi_11183_ = false;
                                                                    } else {
                                                                        phi_11183_ = true;
                                                                    }
                                                                    let _e2991 = phi_11183_;
                                                                    phi_11184_ = _e2991;
                                                                } else {
                                                                    phi_11184_ = true;
                                                                }
                                                                let _e2993 = phi_11184_;
                                                                phi_11185_ = _e2993;
                                                            } else {
                                                                phi_11185_ = true;
                                                            }
                                                            let _e2995 = phi_11185_;
                                                            if _e2995 {
                                                                phi_11191_ = (0.5f * (_e2957 + _e2955));
                                                            } else {
                                                                phi_11191_ = _e2980;
                                                            }
                                                            let _e2999 = phi_11191_;
                                                            phi_11192_ = _e2999;
                                                            phi_11193_ = false;
                                                        } else {
                                                            phi_11192_ = f32();
                                                            phi_11193_ = true;
                                                        }
                                                        let _e3001 = phi_11192_;
                                                        let _e3003 = phi_11193_;
                                                        phi_11082_ = _e2955;
                                                        phi_11084_ = _e2957;
                                                        phi_11086_ = _e3001;
                                                        phi_11194_ = _e2957;
                                                        phi_11195_ = _e2959;
                                                        phi_11196_ = _e3003;
                                                    } else {
                                                        phi_11082_ = f32();
                                                        phi_11084_ = f32();
                                                        phi_11086_ = f32();
                                                        phi_11194_ = f32();
                                                        phi_11195_ = false;
                                                        phi_11196_ = false;
                                                    }
                                                    let _e3005 = phi_11082_;
                                                    let _e3007 = phi_11084_;
                                                    let _e3009 = phi_11086_;
                                                    let _e3011 = phi_11194_;
                                                    let _e3013 = phi_11195_;
                                                    let _e3015 = phi_11196_;
                                                    local_24 = _e3015;
                                                    local_64 = _e3011;
                                                    continue;
                                                    continuing {
                                                        phi_11078_ = _e2933;
                                                        phi_11081_ = _e3005;
                                                        phi_11083_ = _e3007;
                                                        phi_11085_ = _e3009;
                                                        break if !(_e3013);
                                                    }
                                                }
                                                let _e3018 = local_24;
                                                if _e3018 {
                                                    let _e10501 = local_64;
                                                    phi_11200_ = _e10501;
                                                } else {
                                                    let _e10503 = local_65;
                                                    phi_11200_ = _e10503;
                                                }
                                                let _e3020 = phi_11200_;
                                                phi_11201_ = _e3020;
                                            } else {
                                                phi_11201_ = _e2838;
                                            }
                                            let _e3022 = phi_11201_;
                                            if _e2879 {
                                                if (_e2869 < 0f) {
                                                    phi_11209_ = -1f;
                                                } else {
                                                    phi_11209_ = 1f;
                                                }
                                                let _e3025 = phi_11209_;
                                                phi_11213_ = type_9(0u, 64u);
                                                phi_11216_ = (_e1175 + _e1175);
                                                loop {
                                                    let _e3028 = phi_11213_;
                                                    let _e3030 = phi_11216_;
                                                    if (_e3028.member < _e3028.member_1) {
                                                        phi_11214_ = type_9((_e3028.member + 1u), _e3028.member_1);
                                                        phi_11239_ = type_9(1u, _e3028.member);
                                                    } else {
                                                        phi_11214_ = _e3028;
                                                        phi_11239_ = type_9(0u, type_9().member_1);
                                                    }
                                                    let _e3042 = phi_11214_;
                                                    let _e3044 = phi_11239_;
                                                    if (bitcast<i32>(_e3044.member) != 0i) {
                                                        let _e3048 = (_e3022 + _e3030);
                                                        if (_e3048 < _e2844) {
                                                            let _e3050 = (1f - _e3048);
                                                            let _e3063 = ((_e3025 * ((((_e794 * _e3050) + (_e817 * _e3048)) * (_e3050 * _e3050)) + (((_e840 * _e3050) + (_e851 * _e3048)) * (_e3048 * _e3048)))) > _e1168);
                                                            if _e3063 {
                                                                phi_11269_ = f32();
                                                                phi_11270_ = false;
                                                            } else {
                                                                phi_11269_ = (_e3030 + _e3030);
                                                                phi_11270_ = true;
                                                            }
                                                            let _e3066 = phi_11269_;
                                                            let _e3068 = phi_11270_;
                                                            phi_11271_ = _e3066;
                                                            phi_11272_ = _e3068;
                                                            phi_11273_ = _e3063;
                                                            phi_11274_ = false;
                                                        } else {
                                                            phi_11271_ = f32();
                                                            phi_11272_ = false;
                                                            phi_11273_ = false;
                                                            phi_11274_ = true;
                                                        }
                                                        let _e3070 = phi_11271_;
                                                        let _e3072 = phi_11272_;
                                                        let _e3074 = phi_11273_;
                                                        let _e3076 = phi_11274_;
                                                        phi_11275_ = _e3048;
                                                        phi_11217_ = _e3070;
                                                        phi_11276_ = _e3072;
                                                        phi_11277_ = _e3074;
                                                        phi_11278_ = _e3076;
                                                        phi_11279_ = false;
                                                    } else {
                                                        phi_11275_ = f32();
                                                        phi_11217_ = f32();
                                                        phi_11276_ = false;
                                                        phi_11277_ = false;
                                                        phi_11278_ = false;
                                                        phi_11279_ = true;
                                                    }
                                                    let _e3078 = phi_11275_;
                                                    let _e3080 = phi_11217_;
                                                    let _e3082 = phi_11276_;
                                                    let _e3084 = phi_11277_;
                                                    let _e3086 = phi_11278_;
                                                    let _e3088 = phi_11279_;
                                                    local_25 = _e3084;
                                                    local_66 = _e3086;
                                                    local_67 = _e3088;
                                                    local_68 = _e3078;
                                                    continue;
                                                    continuing {
                                                        phi_11213_ = _e3042;
                                                        phi_11216_ = _e3080;
                                                        break if !(_e3082);
                                                    }
                                                }
                                                let _e3091 = local_25;
                                                if _e3091 {
                                                    phi_11283_ = false;
                                                    phi_11284_ = false;
                                                } else {
                                                    let _e10525 = local_66;
                                                    phi_11283_ = _e10525;
                                                    let _e10528 = local_67;
                                                    phi_11284_ = _e10528;
                                                }
                                                let _e3093 = phi_11283_;
                                                let _e3095 = phi_11284_;
                                                if _e3093 {
                                                    phi_11288_ = true;
                                                } else {
                                                    phi_11288_ = _e3095;
                                                }
                                                let _e3097 = phi_11288_;
                                                if _e3097 {
                                                    phi_11292_ = _e2844;
                                                } else {
                                                    let _e10532 = local_68;
                                                    phi_11292_ = _e10532;
                                                }
                                                let _e3099 = phi_11292_;
                                                phi_11293_ = _e3099;
                                            } else {
                                                phi_11293_ = _e2844;
                                            }
                                            let _e3101 = phi_11293_;
                                            phi_11295_ = type_40(_e3022, _e3101, _e2892);
                                        } else {
                                            phi_11295_ = _e2901;
                                        }
                                        let _e3104 = phi_11295_;
                                        if (_e3104.member > _e3104.member_1) {
                                            phi_15088_ = bool();
                                            phi_15089_ = f32();
                                            phi_15090_ = f32();
                                            phi_15091_ = true;
                                            phi_15092_ = false;
                                            phi_15093_ = false;
                                            phi_15094_ = false;
                                        } else {
                                            let _e3111 = ((_e3104.member_1 - _e3104.member) * 0.5f);
                                            let _e3112 = (_e3104.member + _e3111);
                                            let _e3114 = (_e3111 + (0.000000059604645f * 4f));
                                            let _e3116 = local_18.member_3;
                                            let _e3119 = local_18.member[0u];
                                            if (_e3119[0] < 0f) {
                                                phi_11324_ = -(_e3119[0]);
                                            } else {
                                                phi_11324_ = _e3119[0];
                                            }
                                            let _e3126 = phi_11324_;
                                            if (_e3119[1] < 0f) {
                                                phi_11331_ = -(_e3119[1]);
                                            } else {
                                                phi_11331_ = _e3119[1];
                                            }
                                            let _e3130 = phi_11331_;
                                            if (_e3126 > _e3130) {
                                                phi_11336_ = _e3126;
                                            } else {
                                                phi_11336_ = _e3130;
                                            }
                                            let _e3133 = phi_11336_;
                                            if (_e3119[2] < 0f) {
                                                phi_11343_ = -(_e3119[2]);
                                            } else {
                                                phi_11343_ = _e3119[2];
                                            }
                                            let _e3137 = phi_11343_;
                                            if (_e3133 > _e3137) {
                                                phi_11348_ = _e3133;
                                            } else {
                                                phi_11348_ = _e3137;
                                            }
                                            let _e3140 = phi_11348_;
                                            let _e3142 = local_18.member[1u];
                                            if (_e3142[0] < 0f) {
                                                phi_11361_ = -(_e3142[0]);
                                            } else {
                                                phi_11361_ = _e3142[0];
                                            }
                                            let _e3149 = phi_11361_;
                                            if (_e3142[1] < 0f) {
                                                phi_11368_ = -(_e3142[1]);
                                            } else {
                                                phi_11368_ = _e3142[1];
                                            }
                                            let _e3153 = phi_11368_;
                                            if (_e3149 > _e3153) {
                                                phi_11373_ = _e3149;
                                            } else {
                                                phi_11373_ = _e3153;
                                            }
                                            let _e3156 = phi_11373_;
                                            if (_e3142[2] < 0f) {
                                                phi_11380_ = -(_e3142[2]);
                                            } else {
                                                phi_11380_ = _e3142[2];
                                            }
                                            let _e3160 = phi_11380_;
                                            if (_e3156 > _e3160) {
                                                phi_11385_ = _e3156;
                                            } else {
                                                phi_11385_ = _e3160;
                                            }
                                            let _e3163 = phi_11385_;
                                            if (_e3140 > _e3163) {
                                                phi_11390_ = _e3140;
                                            } else {
                                                phi_11390_ = _e3163;
                                            }
                                            let _e3166 = phi_11390_;
                                            let _e3169 = local_18.member[0u];
                                            let _e3174 = local_18.member[1u];
                                            let _e3184 = (_e3169[0] + ((_e3174[0] - _e3169[0]) * _e3112));
                                            let _e3185 = (_e3169[1] + ((_e3174[1] - _e3169[1]) * _e3112));
                                            let _e3186 = (_e3169[2] + ((_e3174[2] - _e3169[2]) * _e3112));
                                            let _e3188 = local_18.member[1u];
                                            let _e3193 = local_18.member[0u];
                                            let _e3197 = (_e3188[0] - _e3193[0]);
                                            let _e3198 = (_e3188[1] - _e3193[1]);
                                            let _e3199 = (_e3188[2] - _e3193[2]);
                                            if (_e3197 < 0f) {
                                                phi_11449_ = -(_e3197);
                                            } else {
                                                phi_11449_ = _e3197;
                                            }
                                            let _e3203 = phi_11449_;
                                            if (_e3198 < 0f) {
                                                phi_11455_ = -(_e3198);
                                            } else {
                                                phi_11455_ = _e3198;
                                            }
                                            let _e3207 = phi_11455_;
                                            if (_e3203 > _e3207) {
                                                phi_11460_ = _e3203;
                                            } else {
                                                phi_11460_ = _e3207;
                                            }
                                            let _e3210 = phi_11460_;
                                            if (_e3199 < 0f) {
                                                phi_11466_ = -(_e3199);
                                            } else {
                                                phi_11466_ = _e3199;
                                            }
                                            let _e3214 = phi_11466_;
                                            if (_e3210 > _e3214) {
                                                phi_11471_ = _e3210;
                                            } else {
                                                phi_11471_ = _e3214;
                                            }
                                            let _e3217 = phi_11471_;
                                            let _e3223 = ((((_e3114 * _e3217) * 1.01f) + ((_e3166 + _e3116) * (0.000000059604645f * 8f))) + _e3116);
                                            if (_e3184 < 0f) {
                                                phi_11483_ = -(_e3184);
                                            } else {
                                                phi_11483_ = _e3184;
                                            }
                                            let _e3227 = phi_11483_;
                                            if (_e3185 < 0f) {
                                                phi_11489_ = -(_e3185);
                                            } else {
                                                phi_11489_ = _e3185;
                                            }
                                            let _e3231 = phi_11489_;
                                            if (_e3227 > _e3231) {
                                                phi_11494_ = _e3227;
                                            } else {
                                                phi_11494_ = _e3231;
                                            }
                                            let _e3234 = phi_11494_;
                                            if (_e3186 < 0f) {
                                                phi_11500_ = -(_e3186);
                                            } else {
                                                phi_11500_ = _e3186;
                                            }
                                            let _e3238 = phi_11500_;
                                            if (_e3234 > _e3238) {
                                                phi_11505_ = _e3234;
                                            } else {
                                                phi_11505_ = _e3238;
                                            }
                                            let _e3241 = phi_11505_;
                                            local_2 = type_26(array<f32, 3>(_e3184, _e3185, _e3186), _e3223, (_e3241 + _e3223));
                                            let _e3247 = local_18.member_3;
                                            let _e3249 = local_18.member_1[0u];
                                            if (_e3249[0] < 0f) {
                                                phi_11531_ = -(_e3249[0]);
                                            } else {
                                                phi_11531_ = _e3249[0];
                                            }
                                            let _e3256 = phi_11531_;
                                            if (_e3249[1] < 0f) {
                                                phi_11538_ = -(_e3249[1]);
                                            } else {
                                                phi_11538_ = _e3249[1];
                                            }
                                            let _e3260 = phi_11538_;
                                            if (_e3256 > _e3260) {
                                                phi_11543_ = _e3256;
                                            } else {
                                                phi_11543_ = _e3260;
                                            }
                                            let _e3263 = phi_11543_;
                                            if (_e3249[2] < 0f) {
                                                phi_11550_ = -(_e3249[2]);
                                            } else {
                                                phi_11550_ = _e3249[2];
                                            }
                                            let _e3267 = phi_11550_;
                                            if (_e3263 > _e3267) {
                                                phi_11555_ = _e3263;
                                            } else {
                                                phi_11555_ = _e3267;
                                            }
                                            let _e3270 = phi_11555_;
                                            let _e3272 = local_18.member_1[1u];
                                            if (_e3272[0] < 0f) {
                                                phi_11568_ = -(_e3272[0]);
                                            } else {
                                                phi_11568_ = _e3272[0];
                                            }
                                            let _e3279 = phi_11568_;
                                            if (_e3272[1] < 0f) {
                                                phi_11575_ = -(_e3272[1]);
                                            } else {
                                                phi_11575_ = _e3272[1];
                                            }
                                            let _e3283 = phi_11575_;
                                            if (_e3279 > _e3283) {
                                                phi_11580_ = _e3279;
                                            } else {
                                                phi_11580_ = _e3283;
                                            }
                                            let _e3286 = phi_11580_;
                                            if (_e3272[2] < 0f) {
                                                phi_11587_ = -(_e3272[2]);
                                            } else {
                                                phi_11587_ = _e3272[2];
                                            }
                                            let _e3290 = phi_11587_;
                                            if (_e3286 > _e3290) {
                                                phi_11592_ = _e3286;
                                            } else {
                                                phi_11592_ = _e3290;
                                            }
                                            let _e3293 = phi_11592_;
                                            if (_e3270 > _e3293) {
                                                phi_11597_ = _e3270;
                                            } else {
                                                phi_11597_ = _e3293;
                                            }
                                            let _e3296 = phi_11597_;
                                            let _e3299 = local_18.member_1[0u];
                                            let _e3304 = local_18.member_1[1u];
                                            let _e3314 = (_e3299[0] + ((_e3304[0] - _e3299[0]) * _e3112));
                                            let _e3315 = (_e3299[1] + ((_e3304[1] - _e3299[1]) * _e3112));
                                            let _e3316 = (_e3299[2] + ((_e3304[2] - _e3299[2]) * _e3112));
                                            let _e3318 = local_18.member_1[1u];
                                            let _e3323 = local_18.member_1[0u];
                                            let _e3327 = (_e3318[0] - _e3323[0]);
                                            let _e3328 = (_e3318[1] - _e3323[1]);
                                            let _e3329 = (_e3318[2] - _e3323[2]);
                                            if (_e3327 < 0f) {
                                                phi_11656_ = -(_e3327);
                                            } else {
                                                phi_11656_ = _e3327;
                                            }
                                            let _e3333 = phi_11656_;
                                            if (_e3328 < 0f) {
                                                phi_11662_ = -(_e3328);
                                            } else {
                                                phi_11662_ = _e3328;
                                            }
                                            let _e3337 = phi_11662_;
                                            if (_e3333 > _e3337) {
                                                phi_11667_ = _e3333;
                                            } else {
                                                phi_11667_ = _e3337;
                                            }
                                            let _e3340 = phi_11667_;
                                            if (_e3329 < 0f) {
                                                phi_11673_ = -(_e3329);
                                            } else {
                                                phi_11673_ = _e3329;
                                            }
                                            let _e3344 = phi_11673_;
                                            if (_e3340 > _e3344) {
                                                phi_11678_ = _e3340;
                                            } else {
                                                phi_11678_ = _e3344;
                                            }
                                            let _e3347 = phi_11678_;
                                            let _e3353 = ((((_e3114 * _e3347) * 1.01f) + ((_e3296 + _e3247) * (0.000000059604645f * 8f))) + _e3247);
                                            if (_e3314 < 0f) {
                                                phi_11690_ = -(_e3314);
                                            } else {
                                                phi_11690_ = _e3314;
                                            }
                                            let _e3357 = phi_11690_;
                                            if (_e3315 < 0f) {
                                                phi_11696_ = -(_e3315);
                                            } else {
                                                phi_11696_ = _e3315;
                                            }
                                            let _e3361 = phi_11696_;
                                            if (_e3357 > _e3361) {
                                                phi_11701_ = _e3357;
                                            } else {
                                                phi_11701_ = _e3361;
                                            }
                                            let _e3364 = phi_11701_;
                                            if (_e3316 < 0f) {
                                                phi_11707_ = -(_e3316);
                                            } else {
                                                phi_11707_ = _e3316;
                                            }
                                            let _e3368 = phi_11707_;
                                            if (_e3364 > _e3368) {
                                                phi_11712_ = _e3364;
                                            } else {
                                                phi_11712_ = _e3368;
                                            }
                                            let _e3371 = phi_11712_;
                                            local_3 = type_26(array<f32, 3>(_e3314, _e3315, _e3316), _e3353, (_e3371 + _e3353));
                                            let _e3377 = local_18.member_3;
                                            let _e3379 = local_18.member_2[0u];
                                            if (_e3379[0] < 0f) {
                                                phi_11738_ = -(_e3379[0]);
                                            } else {
                                                phi_11738_ = _e3379[0];
                                            }
                                            let _e3386 = phi_11738_;
                                            if (_e3379[1] < 0f) {
                                                phi_11745_ = -(_e3379[1]);
                                            } else {
                                                phi_11745_ = _e3379[1];
                                            }
                                            let _e3390 = phi_11745_;
                                            if (_e3386 > _e3390) {
                                                phi_11750_ = _e3386;
                                            } else {
                                                phi_11750_ = _e3390;
                                            }
                                            let _e3393 = phi_11750_;
                                            if (_e3379[2] < 0f) {
                                                phi_11757_ = -(_e3379[2]);
                                            } else {
                                                phi_11757_ = _e3379[2];
                                            }
                                            let _e3397 = phi_11757_;
                                            if (_e3393 > _e3397) {
                                                phi_11762_ = _e3393;
                                            } else {
                                                phi_11762_ = _e3397;
                                            }
                                            let _e3400 = phi_11762_;
                                            let _e3402 = local_18.member_2[1u];
                                            if (_e3402[0] < 0f) {
                                                phi_11775_ = -(_e3402[0]);
                                            } else {
                                                phi_11775_ = _e3402[0];
                                            }
                                            let _e3409 = phi_11775_;
                                            if (_e3402[1] < 0f) {
                                                phi_11782_ = -(_e3402[1]);
                                            } else {
                                                phi_11782_ = _e3402[1];
                                            }
                                            let _e3413 = phi_11782_;
                                            if (_e3409 > _e3413) {
                                                phi_11787_ = _e3409;
                                            } else {
                                                phi_11787_ = _e3413;
                                            }
                                            let _e3416 = phi_11787_;
                                            if (_e3402[2] < 0f) {
                                                phi_11794_ = -(_e3402[2]);
                                            } else {
                                                phi_11794_ = _e3402[2];
                                            }
                                            let _e3420 = phi_11794_;
                                            if (_e3416 > _e3420) {
                                                phi_11799_ = _e3416;
                                            } else {
                                                phi_11799_ = _e3420;
                                            }
                                            let _e3423 = phi_11799_;
                                            if (_e3400 > _e3423) {
                                                phi_11804_ = _e3400;
                                            } else {
                                                phi_11804_ = _e3423;
                                            }
                                            let _e3426 = phi_11804_;
                                            let _e3429 = local_18.member_2[0u];
                                            let _e3434 = local_18.member_2[1u];
                                            let _e3444 = (_e3429[0] + ((_e3434[0] - _e3429[0]) * _e3112));
                                            let _e3445 = (_e3429[1] + ((_e3434[1] - _e3429[1]) * _e3112));
                                            let _e3446 = (_e3429[2] + ((_e3434[2] - _e3429[2]) * _e3112));
                                            let _e3448 = local_18.member_2[1u];
                                            let _e3453 = local_18.member_2[0u];
                                            let _e3457 = (_e3448[0] - _e3453[0]);
                                            let _e3458 = (_e3448[1] - _e3453[1]);
                                            let _e3459 = (_e3448[2] - _e3453[2]);
                                            if (_e3457 < 0f) {
                                                phi_11863_ = -(_e3457);
                                            } else {
                                                phi_11863_ = _e3457;
                                            }
                                            let _e3463 = phi_11863_;
                                            if (_e3458 < 0f) {
                                                phi_11869_ = -(_e3458);
                                            } else {
                                                phi_11869_ = _e3458;
                                            }
                                            let _e3467 = phi_11869_;
                                            if (_e3463 > _e3467) {
                                                phi_11874_ = _e3463;
                                            } else {
                                                phi_11874_ = _e3467;
                                            }
                                            let _e3470 = phi_11874_;
                                            if (_e3459 < 0f) {
                                                phi_11880_ = -(_e3459);
                                            } else {
                                                phi_11880_ = _e3459;
                                            }
                                            let _e3474 = phi_11880_;
                                            if (_e3470 > _e3474) {
                                                phi_11885_ = _e3470;
                                            } else {
                                                phi_11885_ = _e3474;
                                            }
                                            let _e3477 = phi_11885_;
                                            let _e3483 = ((((_e3114 * _e3477) * 1.01f) + ((_e3426 + _e3377) * (0.000000059604645f * 8f))) + _e3377);
                                            if (_e3444 < 0f) {
                                                phi_11897_ = -(_e3444);
                                            } else {
                                                phi_11897_ = _e3444;
                                            }
                                            let _e3487 = phi_11897_;
                                            if (_e3445 < 0f) {
                                                phi_11903_ = -(_e3445);
                                            } else {
                                                phi_11903_ = _e3445;
                                            }
                                            let _e3491 = phi_11903_;
                                            if (_e3487 > _e3491) {
                                                phi_11908_ = _e3487;
                                            } else {
                                                phi_11908_ = _e3491;
                                            }
                                            let _e3494 = phi_11908_;
                                            if (_e3446 < 0f) {
                                                phi_11914_ = -(_e3446);
                                            } else {
                                                phi_11914_ = _e3446;
                                            }
                                            let _e3498 = phi_11914_;
                                            if (_e3494 > _e3498) {
                                                phi_11919_ = _e3494;
                                            } else {
                                                phi_11919_ = _e3498;
                                            }
                                            let _e3501 = phi_11919_;
                                            local_4 = type_26(array<f32, 3>(_e3444, _e3445, _e3446), _e3483, (_e3501 + _e3483));
                                            let _e3506 = local_3.member;
                                            let _e3511 = local_4.member;
                                            let _e3517 = ((_e3506[1] * _e3511[2]) - (_e3506[2] * _e3511[1]));
                                            let _e3520 = ((_e3506[2] * _e3511[0]) - (_e3506[0] * _e3511[2]));
                                            let _e3523 = ((_e3506[0] * _e3511[1]) - (_e3506[1] * _e3511[0]));
                                            if (_e3517 < 0f) {
                                                phi_11968_ = -(_e3517);
                                            } else {
                                                phi_11968_ = _e3517;
                                            }
                                            let _e3527 = phi_11968_;
                                            if (_e3520 < 0f) {
                                                phi_11974_ = -(_e3520);
                                            } else {
                                                phi_11974_ = _e3520;
                                            }
                                            let _e3531 = phi_11974_;
                                            if (_e3527 > _e3531) {
                                                if (_e3517 < 0f) {
                                                    phi_11984_ = -(_e3517);
                                                } else {
                                                    phi_11984_ = _e3517;
                                                }
                                                let _e3549 = phi_11984_;
                                                if (_e3523 < 0f) {
                                                    phi_11990_ = -(_e3523);
                                                } else {
                                                    phi_11990_ = _e3523;
                                                }
                                                let _e3553 = phi_11990_;
                                                if (_e3549 > _e3553) {
                                                    phi_11995_ = 2u;
                                                    phi_11996_ = 1u;
                                                } else {
                                                    phi_11995_ = 1u;
                                                    phi_11996_ = 0u;
                                                }
                                                let _e3556 = phi_11995_;
                                                let _e3558 = phi_11996_;
                                                phi_12015_ = _e3556;
                                                phi_12016_ = _e3558;
                                            } else {
                                                if (_e3520 < 0f) {
                                                    phi_12002_ = -(_e3520);
                                                } else {
                                                    phi_12002_ = _e3520;
                                                }
                                                let _e3536 = phi_12002_;
                                                if (_e3523 < 0f) {
                                                    phi_12008_ = -(_e3523);
                                                } else {
                                                    phi_12008_ = _e3523;
                                                }
                                                let _e3540 = phi_12008_;
                                                if (_e3536 > _e3540) {
                                                    phi_12013_ = 0u;
                                                    phi_12014_ = 2u;
                                                } else {
                                                    phi_12013_ = 1u;
                                                    phi_12014_ = 0u;
                                                }
                                                let _e3543 = phi_12013_;
                                                let _e3545 = phi_12014_;
                                                phi_12015_ = _e3543;
                                                phi_12016_ = _e3545;
                                            }
                                            let _e3560 = phi_12015_;
                                            let _e3562 = phi_12016_;
                                            let _e3565 = local_3.member[_e3562];
                                            let _e3568 = local_4.member[_e3560];
                                            let _e3572 = local_3.member[_e3560];
                                            let _e3575 = local_4.member[_e3562];
                                            let _e3577 = ((_e3565 * _e3568) - (_e3572 * _e3575));
                                            let _e3579 = local_3.member_1;
                                            let _e3581 = local_4.member_2;
                                            let _e3584 = local_3.member_2;
                                            let _e3586 = local_4.member_1;
                                            let _e3591 = local_3.member_2;
                                            let _e3594 = local_4.member_2;
                                            let _e3602 = local_3.member_2;
                                            let _e3605 = local_4.member_2;
                                            let _e3609 = (((((_e3579 * _e3581) + (_e3584 * _e3586)) * 2.01f) + (((_e3591 * 2f) * (_e3594 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3602) * (1f + _e3605))));
                                            if (_e3577 < 0f) {
                                                phi_12085_ = -(_e3577);
                                            } else {
                                                phi_12085_ = _e3577;
                                            }
                                            let _e3613 = phi_12085_;
                                            if (_e3613 > _e3609) {
                                                if (_e3577 < 0f) {
                                                    phi_12094_ = -1f;
                                                } else {
                                                    phi_12094_ = 1f;
                                                }
                                                let _e3617 = phi_12094_;
                                                let _e3620 = local_2.member[_e3562];
                                                let _e3623 = local_4.member[_e3560];
                                                let _e3627 = local_2.member[_e3560];
                                                let _e3630 = local_4.member[_e3562];
                                                let _e3634 = local_2.member_1;
                                                let _e3636 = local_4.member_2;
                                                let _e3639 = local_2.member_2;
                                                let _e3641 = local_4.member_1;
                                                let _e3646 = local_2.member_2;
                                                let _e3649 = local_4.member_2;
                                                let _e3657 = local_2.member_2;
                                                let _e3660 = local_4.member_2;
                                                let _e3664 = (((((_e3634 * _e3636) + (_e3639 * _e3641)) * 2.01f) + (((_e3646 * 2f) * (_e3649 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3657) * (1f + _e3660))));
                                                let _e3667 = local_3.member[_e3562];
                                                let _e3670 = local_2.member[_e3560];
                                                let _e3674 = local_3.member[_e3560];
                                                let _e3677 = local_2.member[_e3562];
                                                let _e3681 = local_3.member_1;
                                                let _e3683 = local_2.member_2;
                                                let _e3686 = local_3.member_2;
                                                let _e3688 = local_2.member_1;
                                                let _e3693 = local_3.member_2;
                                                let _e3696 = local_2.member_2;
                                                let _e3704 = local_3.member_2;
                                                let _e3707 = local_2.member_2;
                                                let _e3711 = (((((_e3681 * _e3683) + (_e3686 * _e3688)) * 2.01f) + (((_e3693 * 2f) * (_e3696 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3704) * (1f + _e3707))));
                                                let _e3712 = (_e3577 * _e3617);
                                                let _e3713 = (((_e3620 * _e3623) - (_e3627 * _e3630)) * _e3617);
                                                let _e3714 = (((_e3667 * _e3670) - (_e3674 * _e3677)) * _e3617);
                                                if (_e3712 < 0f) {
                                                    phi_12229_ = -(_e3712);
                                                } else {
                                                    phi_12229_ = _e3712;
                                                }
                                                let _e3718 = phi_12229_;
                                                if (_e3713 < 0f) {
                                                    phi_12235_ = -(_e3713);
                                                } else {
                                                    phi_12235_ = _e3713;
                                                }
                                                let _e3722 = phi_12235_;
                                                if (_e3714 < 0f) {
                                                    phi_12242_ = -(_e3714);
                                                } else {
                                                    phi_12242_ = _e3714;
                                                }
                                                let _e3727 = phi_12242_;
                                                let _e3730 = (((_e3718 + _e3722) + _e3727) * (0.000000059604645f * 4f));
                                                if (_e245.member != 0u) {
                                                    phi_12277_ = array<type_28, 4>(type_28(_e3713, _e3664), type_28(_e3714, _e3711), type_28((_e3712 - _e3713), ((_e3609 + _e3664) + _e3730)), type_28((_e3712 - _e3714), ((_e3609 + _e3711) + _e3730)));
                                                } else {
                                                    let _e3733 = ((_e3712 - _e3713) - _e3714);
                                                    let _e3736 = (((_e3609 + _e3664) + _e3711) + _e3730);
                                                    phi_12277_ = array<type_28, 4>(type_28(_e3713, _e3664), type_28(_e3714, _e3711), type_28(_e3733, _e3736), type_28(_e3733, _e3736));
                                                }
                                                let _e3754 = phi_12277_;
                                                local_5 = array<type_28, 4>(type_28(_e3754[0].member, _e3754[0].member_1), type_28(_e3754[1].member, _e3754[1].member_1), type_28(_e3754[2].member, _e3754[2].member_1), type_28(_e3754[3].member, _e3754[3].member_1));
                                                phi_12297_ = type_9(0u, 4u);
                                                phi_12300_ = true;
                                                loop {
                                                    let _e3773 = phi_12297_;
                                                    let _e3775 = phi_12300_;
                                                    local_27 = _e3775;
                                                    if (_e3773.member < _e3773.member_1) {
                                                        phi_12298_ = type_9((_e3773.member + 1u), _e3773.member_1);
                                                        phi_12323_ = type_9(1u, _e3773.member);
                                                    } else {
                                                        phi_12298_ = _e3773;
                                                        phi_12323_ = type_9(0u, type_9().member_1);
                                                    }
                                                    let _e3787 = phi_12298_;
                                                    let _e3789 = phi_12323_;
                                                    if (bitcast<i32>(_e3789.member) != 0i) {
                                                        let _e3796 = local_5[_e3789.member_1].member;
                                                        let _e3799 = local_5[_e3789.member_1].member_1;
                                                        let _e3801 = (_e3796 < -(_e3799));
                                                        if _e3801 {
                                                            phi_12350_ = bool();
                                                            phi_12351_ = false;
                                                        } else {
                                                            phi_12350_ = (_e3775 && (_e3796 > _e3799));
                                                            phi_12351_ = true;
                                                        }
                                                        let _e3805 = phi_12350_;
                                                        let _e3807 = phi_12351_;
                                                        phi_12301_ = _e3805;
                                                        phi_12352_ = _e3807;
                                                        phi_12353_ = _e3801;
                                                    } else {
                                                        phi_12301_ = bool();
                                                        phi_12352_ = false;
                                                        phi_12353_ = false;
                                                    }
                                                    let _e3809 = phi_12301_;
                                                    let _e3811 = phi_12352_;
                                                    let _e3813 = phi_12353_;
                                                    local_26 = _e3813;
                                                    continue;
                                                    continuing {
                                                        phi_12297_ = _e3787;
                                                        phi_12300_ = _e3809;
                                                        break if !(_e3811);
                                                    }
                                                }
                                                let _e3816 = local_26;
                                                if _e3816 {
                                                    phi_12357_ = false;
                                                } else {
                                                    phi_12357_ = true;
                                                }
                                                let _e3818 = phi_12357_;
                                                if _e3818 {
                                                    let _e3820 = local_27;
                                                    if _e3820 {
                                                        phi_12364_ = 1u;
                                                    } else {
                                                        phi_12364_ = 2u;
                                                    }
                                                    let _e3822 = phi_12364_;
                                                    phi_12365_ = _e3822;
                                                    phi_12366_ = false;
                                                } else {
                                                    phi_12365_ = u32();
                                                    phi_12366_ = true;
                                                }
                                                let _e3824 = phi_12365_;
                                                let _e3826 = phi_12366_;
                                                phi_12367_ = _e3824;
                                                phi_12368_ = 0u;
                                                phi_12369_ = _e3826;
                                            } else {
                                                phi_12367_ = u32();
                                                phi_12368_ = 2u;
                                                phi_12369_ = true;
                                            }
                                            let _e3828 = phi_12367_;
                                            let _e3830 = phi_12368_;
                                            let _e3832 = phi_12369_;
                                            if _e3832 {
                                                phi_12373_ = _e3830;
                                            } else {
                                                phi_12373_ = _e3828;
                                            }
                                            let _e3834 = phi_12373_;
                                            let _e3835 = (_e3834 == 0u);
                                            if _e3835 {
                                                phi_15082_ = bool();
                                                phi_15083_ = f32();
                                                phi_15084_ = f32();
                                                phi_15085_ = false;
                                                phi_15086_ = false;
                                                phi_15087_ = false;
                                            } else {
                                                if (_e3834 == 1u) {
                                                    phi_12383_ = _e3104.member_2;
                                                } else {
                                                    phi_12383_ = false;
                                                }
                                                let _e3839 = phi_12383_;
                                                let _e3840 = (_e385 * 0.99f);
                                                if _e3839 {
                                                    if ((_e3104.member_1 - _e3104.member) <= _e3840) {
                                                        phi_12395_ = false;
                                                    } else {
                                                        phi_12395_ = true;
                                                    }
                                                    let _e3846 = phi_12395_;
                                                    phi_12396_ = _e3846;
                                                } else {
                                                    phi_12396_ = true;
                                                }
                                                let _e3848 = phi_12396_;
                                                if _e3848 {
                                                    let _e3853 = local_18.member[0u];
                                                    let _e3860 = local_18.member_1[0u];
                                                    let _e3866 = local_18.member_2[0u];
                                                    let _e3870 = (_e3853[0] - _e3860[0]);
                                                    let _e3871 = (_e3853[1] - _e3860[1]);
                                                    let _e3872 = (_e3853[2] - _e3860[2]);
                                                    if (_e245.member == 0u) {
                                                        phi_12457_ = array<f32, 3>(_e3853[0], _e3853[1], _e3853[2]);
                                                    } else {
                                                        phi_12457_ = array<f32, 3>((_e3870 - _e3866[0]), (_e3871 - _e3866[1]), (_e3872 - _e3866[2]));
                                                    }
                                                    let _e3879 = phi_12457_;
                                                    let _e3885 = local_18.member[1u];
                                                    let _e3892 = local_18.member_1[1u];
                                                    let _e3898 = local_18.member_2[1u];
                                                    let _e3902 = (_e3885[0] - _e3892[0]);
                                                    let _e3903 = (_e3885[1] - _e3892[1]);
                                                    let _e3904 = (_e3885[2] - _e3892[2]);
                                                    if (_e245.member == 0u) {
                                                        phi_12522_ = array<f32, 3>(_e3885[0], _e3885[1], _e3885[2]);
                                                    } else {
                                                        phi_12522_ = array<f32, 3>((_e3902 - _e3898[0]), (_e3903 - _e3898[1]), (_e3904 - _e3898[2]));
                                                    }
                                                    let _e3911 = phi_12522_;
                                                    let _e3917 = local_18.member[0u];
                                                    if (_e3917[0] < 0f) {
                                                        phi_12544_ = -(_e3917[0]);
                                                    } else {
                                                        phi_12544_ = _e3917[0];
                                                    }
                                                    let _e3924 = phi_12544_;
                                                    if (_e3917[1] < 0f) {
                                                        phi_12551_ = -(_e3917[1]);
                                                    } else {
                                                        phi_12551_ = _e3917[1];
                                                    }
                                                    let _e3928 = phi_12551_;
                                                    if (_e3924 > _e3928) {
                                                        phi_12556_ = _e3924;
                                                    } else {
                                                        phi_12556_ = _e3928;
                                                    }
                                                    let _e3931 = phi_12556_;
                                                    if (_e3917[2] < 0f) {
                                                        phi_12563_ = -(_e3917[2]);
                                                    } else {
                                                        phi_12563_ = _e3917[2];
                                                    }
                                                    let _e3935 = phi_12563_;
                                                    if (_e3931 > _e3935) {
                                                        phi_12568_ = _e3931;
                                                    } else {
                                                        phi_12568_ = _e3935;
                                                    }
                                                    let _e3938 = phi_12568_;
                                                    let _e3941 = local_18.member[1u];
                                                    if (_e3941[0] < 0f) {
                                                        phi_12581_ = -(_e3941[0]);
                                                    } else {
                                                        phi_12581_ = _e3941[0];
                                                    }
                                                    let _e3948 = phi_12581_;
                                                    if (_e3941[1] < 0f) {
                                                        phi_12588_ = -(_e3941[1]);
                                                    } else {
                                                        phi_12588_ = _e3941[1];
                                                    }
                                                    let _e3952 = phi_12588_;
                                                    if (_e3948 > _e3952) {
                                                        phi_12593_ = _e3948;
                                                    } else {
                                                        phi_12593_ = _e3952;
                                                    }
                                                    let _e3955 = phi_12593_;
                                                    if (_e3941[2] < 0f) {
                                                        phi_12600_ = -(_e3941[2]);
                                                    } else {
                                                        phi_12600_ = _e3941[2];
                                                    }
                                                    let _e3959 = phi_12600_;
                                                    if (_e3955 > _e3959) {
                                                        phi_12605_ = _e3955;
                                                    } else {
                                                        phi_12605_ = _e3959;
                                                    }
                                                    let _e3962 = phi_12605_;
                                                    if (_e3938 > _e3962) {
                                                        phi_12610_ = _e3938;
                                                    } else {
                                                        phi_12610_ = _e3962;
                                                    }
                                                    let _e3965 = phi_12610_;
                                                    let _e3967 = local_18.member_3;
                                                    let _e3971 = local_18.member_1[0u];
                                                    if (_e3971[0] < 0f) {
                                                        phi_12627_ = -(_e3971[0]);
                                                    } else {
                                                        phi_12627_ = _e3971[0];
                                                    }
                                                    let _e3978 = phi_12627_;
                                                    if (_e3971[1] < 0f) {
                                                        phi_12634_ = -(_e3971[1]);
                                                    } else {
                                                        phi_12634_ = _e3971[1];
                                                    }
                                                    let _e3982 = phi_12634_;
                                                    if (_e3978 > _e3982) {
                                                        phi_12639_ = _e3978;
                                                    } else {
                                                        phi_12639_ = _e3982;
                                                    }
                                                    let _e3985 = phi_12639_;
                                                    if (_e3971[2] < 0f) {
                                                        phi_12646_ = -(_e3971[2]);
                                                    } else {
                                                        phi_12646_ = _e3971[2];
                                                    }
                                                    let _e3989 = phi_12646_;
                                                    if (_e3985 > _e3989) {
                                                        phi_12651_ = _e3985;
                                                    } else {
                                                        phi_12651_ = _e3989;
                                                    }
                                                    let _e3992 = phi_12651_;
                                                    let _e3995 = local_18.member_1[1u];
                                                    if (_e3995[0] < 0f) {
                                                        phi_12665_ = -(_e3995[0]);
                                                    } else {
                                                        phi_12665_ = _e3995[0];
                                                    }
                                                    let _e4002 = phi_12665_;
                                                    if (_e3995[1] < 0f) {
                                                        phi_12672_ = -(_e3995[1]);
                                                    } else {
                                                        phi_12672_ = _e3995[1];
                                                    }
                                                    let _e4006 = phi_12672_;
                                                    if (_e4002 > _e4006) {
                                                        phi_12677_ = _e4002;
                                                    } else {
                                                        phi_12677_ = _e4006;
                                                    }
                                                    let _e4009 = phi_12677_;
                                                    if (_e3995[2] < 0f) {
                                                        phi_12684_ = -(_e3995[2]);
                                                    } else {
                                                        phi_12684_ = _e3995[2];
                                                    }
                                                    let _e4013 = phi_12684_;
                                                    if (_e4009 > _e4013) {
                                                        phi_12689_ = _e4009;
                                                    } else {
                                                        phi_12689_ = _e4013;
                                                    }
                                                    let _e4016 = phi_12689_;
                                                    if (_e3992 > _e4016) {
                                                        phi_12694_ = _e3992;
                                                    } else {
                                                        phi_12694_ = _e4016;
                                                    }
                                                    let _e4019 = phi_12694_;
                                                    let _e4021 = local_18.member_3;
                                                    let _e4025 = local_18.member_2[0u];
                                                    if (_e4025[0] < 0f) {
                                                        phi_12711_ = -(_e4025[0]);
                                                    } else {
                                                        phi_12711_ = _e4025[0];
                                                    }
                                                    let _e4032 = phi_12711_;
                                                    if (_e4025[1] < 0f) {
                                                        phi_12718_ = -(_e4025[1]);
                                                    } else {
                                                        phi_12718_ = _e4025[1];
                                                    }
                                                    let _e4036 = phi_12718_;
                                                    if (_e4032 > _e4036) {
                                                        phi_12723_ = _e4032;
                                                    } else {
                                                        phi_12723_ = _e4036;
                                                    }
                                                    let _e4039 = phi_12723_;
                                                    if (_e4025[2] < 0f) {
                                                        phi_12730_ = -(_e4025[2]);
                                                    } else {
                                                        phi_12730_ = _e4025[2];
                                                    }
                                                    let _e4043 = phi_12730_;
                                                    if (_e4039 > _e4043) {
                                                        phi_12735_ = _e4039;
                                                    } else {
                                                        phi_12735_ = _e4043;
                                                    }
                                                    let _e4046 = phi_12735_;
                                                    let _e4049 = local_18.member_2[1u];
                                                    if (_e4049[0] < 0f) {
                                                        phi_12749_ = -(_e4049[0]);
                                                    } else {
                                                        phi_12749_ = _e4049[0];
                                                    }
                                                    let _e4056 = phi_12749_;
                                                    if (_e4049[1] < 0f) {
                                                        phi_12756_ = -(_e4049[1]);
                                                    } else {
                                                        phi_12756_ = _e4049[1];
                                                    }
                                                    let _e4060 = phi_12756_;
                                                    if (_e4056 > _e4060) {
                                                        phi_12761_ = _e4056;
                                                    } else {
                                                        phi_12761_ = _e4060;
                                                    }
                                                    let _e4063 = phi_12761_;
                                                    if (_e4049[2] < 0f) {
                                                        phi_12768_ = -(_e4049[2]);
                                                    } else {
                                                        phi_12768_ = _e4049[2];
                                                    }
                                                    let _e4067 = phi_12768_;
                                                    if (_e4063 > _e4067) {
                                                        phi_12773_ = _e4063;
                                                    } else {
                                                        phi_12773_ = _e4067;
                                                    }
                                                    let _e4070 = phi_12773_;
                                                    if (_e4046 > _e4070) {
                                                        phi_12778_ = _e4046;
                                                    } else {
                                                        phi_12778_ = _e4070;
                                                    }
                                                    let _e4073 = phi_12778_;
                                                    let _e4075 = local_18.member_3;
                                                    let _e4082 = local_18.member_3;
                                                    let _e4087 = (_e385 * 0.00390625f);
                                                    local = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                    phi_12819_ = type_9(0u, 96u);
                                                    phi_12822_ = _e3104.member;
                                                    phi_12824_ = _e3104.member;
                                                    phi_12826_ = (_e3104.member_1 - _e3104.member);
                                                    phi_12828_ = _e3104.member;
                                                    phi_12830_ = false;
                                                    phi_12832_ = 0u;
                                                    loop {
                                                        let _e4090 = phi_12819_;
                                                        let _e4092 = phi_12822_;
                                                        let _e4094 = phi_12824_;
                                                        let _e4096 = phi_12826_;
                                                        let _e4098 = phi_12828_;
                                                        let _e4100 = phi_12830_;
                                                        let _e4102 = phi_12832_;
                                                        local_30 = _e4092;
                                                        local_75 = _e4094;
                                                        if (_e4090.member < _e4090.member_1) {
                                                            phi_12820_ = type_9((_e4090.member + 1u), _e4090.member_1);
                                                            phi_12855_ = type_9(1u, _e4090.member);
                                                        } else {
                                                            phi_12820_ = _e4090;
                                                            phi_12855_ = type_9(0u, type_9().member_1);
                                                        }
                                                        let _e4114 = phi_12820_;
                                                        let _e4116 = phi_12855_;
                                                        if (bitcast<i32>(_e4116.member) != 0i) {
                                                            let _e4122 = local_18.member[0u];
                                                            let _e4128 = local_18.member[1u];
                                                            let _e4144 = local_18.member_1[0u];
                                                            let _e4150 = local_18.member_1[1u];
                                                            let _e4166 = local_18.member_2[0u];
                                                            let _e4172 = local_18.member_2[1u];
                                                            let _e4186 = function_3(array<f32, 3>((_e4122[0] + ((_e4128[0] - _e4122[0]) * _e4092)), (_e4122[1] + ((_e4128[1] - _e4122[1]) * _e4092)), (_e4122[2] + ((_e4128[2] - _e4122[2]) * _e4092))), array<f32, 3>((_e4144[0] + ((_e4150[0] - _e4144[0]) * _e4092)), (_e4144[1] + ((_e4150[1] - _e4144[1]) * _e4092)), (_e4144[2] + ((_e4150[2] - _e4144[2]) * _e4092))), array<f32, 3>((_e4166[0] + ((_e4172[0] - _e4166[0]) * _e4092)), (_e4166[1] + ((_e4172[1] - _e4166[1]) * _e4092)), (_e4166[2] + ((_e4172[2] - _e4166[2]) * _e4092))), _e245.member);
                                                            if (_e4102 == 0u) {
                                                                phi_12983_ = _e4186;
                                                            } else {
                                                                if (_e4102 == 1u) {
                                                                    phi_12969_ = _e4186[0];
                                                                } else {
                                                                    phi_12969_ = 0f;
                                                                }
                                                                let _e4191 = phi_12969_;
                                                                if (_e4102 == 2u) {
                                                                    phi_12975_ = _e4186[1];
                                                                } else {
                                                                    phi_12975_ = 0f;
                                                                }
                                                                let _e4195 = phi_12975_;
                                                                if (_e4102 == 3u) {
                                                                    phi_12981_ = _e4186[2];
                                                                } else {
                                                                    phi_12981_ = 0f;
                                                                }
                                                                let _e4199 = phi_12981_;
                                                                phi_12983_ = array<f32, 3>(_e4191, _e4195, _e4199);
                                                            }
                                                            let _e4202 = phi_12983_;
                                                            if (_e4202[0] < 0f) {
                                                                phi_12990_ = -(_e4202[0]);
                                                            } else {
                                                                phi_12990_ = _e4202[0];
                                                            }
                                                            let _e4207 = phi_12990_;
                                                            if (_e4202[1] < 0f) {
                                                                phi_12997_ = -(_e4202[1]);
                                                            } else {
                                                                phi_12997_ = _e4202[1];
                                                            }
                                                            let _e4212 = phi_12997_;
                                                            if (_e4202[2] < 0f) {
                                                                phi_13005_ = -(_e4202[2]);
                                                            } else {
                                                                phi_13005_ = _e4202[2];
                                                            }
                                                            let _e4218 = phi_13005_;
                                                            let _e4219 = ((_e4207 + _e4212) + _e4218);
                                                            if (_e4219 > 0f) {
                                                                if ((bitcast<u32>(_e4219) & 2139095040u) != 2139095040u) {
                                                                    let _e4224 = (1f / _e4219);
                                                                    let _e4226 = (_e4202[0] * _e4224);
                                                                    let _e4228 = (_e4202[1] * _e4224);
                                                                    let _e4230 = (_e4202[2] * _e4224);
                                                                    let _e4235 = (((_e4226 * _e4226) + (_e4228 * _e4228)) + (_e4230 * _e4230));
                                                                    if (_e4235 <= 0.000000000000000000000000000000000000011754944f) {
                                                                        if (_e4235 > 0f) {
                                                                            phi_13042_ = (0.000000000000000000106433627f * 2f);
                                                                        } else {
                                                                            phi_13042_ = 0f;
                                                                        }
                                                                        let _e4288 = phi_13042_;
                                                                        phi_13106_ = _e4288;
                                                                    } else {
                                                                        phi_13049_ = type_16(0i, 5i);
                                                                        phi_13052_ = bitcast<f32>(((bitcast<u32>(_e4235) >> bitcast<u32>(1i)) + 532369198u));
                                                                        loop {
                                                                            let _e4243 = phi_13049_;
                                                                            let _e4245 = phi_13052_;
                                                                            local_28 = _e4245;
                                                                            if (_e4243.member < _e4243.member_1) {
                                                                                let _e4252 = (_e4243.member + 1i);
                                                                                if ((false == (_e4252 > _e4243.member)) != false) {
                                                                                    phi_13073_ = true;
                                                                                } else {
                                                                                    phi_13073_ = false;
                                                                                }
                                                                                let _e4257 = phi_13073_;
                                                                                if _e4257 {
                                                                                    phi_13079_ = type_17(0u, type_17().member_1);
                                                                                } else {
                                                                                    phi_13079_ = type_17(1u, _e4252);
                                                                                }
                                                                                let _e4262 = phi_13079_;
                                                                                phi_13050_ = type_16(_e4262.member_1, _e4243.member_1);
                                                                                phi_13093_ = type_17(1u, _e4243.member);
                                                                            } else {
                                                                                phi_13050_ = _e4243;
                                                                                phi_13093_ = type_17(0u, type_17().member_1);
                                                                            }
                                                                            let _e4268 = phi_13050_;
                                                                            let _e4270 = phi_13093_;
                                                                            let _e4273 = (bitcast<i32>(_e4270.member) != 0i);
                                                                            if _e4273 {
                                                                                phi_13053_ = (0.5f * (_e4245 + (_e4235 / _e4245)));
                                                                            } else {
                                                                                phi_13053_ = f32();
                                                                            }
                                                                            let _e4278 = phi_13053_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_13049_ = _e4268;
                                                                                phi_13052_ = _e4278;
                                                                                break if !(_e4273);
                                                                            }
                                                                        }
                                                                        let _e4283 = local_28;
                                                                        phi_13106_ = (_e4283 * (1f + (8f * 0.000000059604645f)));
                                                                    }
                                                                    let _e4290 = phi_13106_;
                                                                    let _e4291 = (0.000000059604645f * 12f);
                                                                    let _e4296 = ((((((((_e3965 + _e3967) + (_e4019 + _e4021)) + (_e4073 + _e4075)) * (0.000000059604645f * 16f)) + (_e4082 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e4290) * (1f + _e4291)));
                                                                    let _e4301 = (((_e4226 * _e3853[0]) + (_e4228 * _e3853[1])) + (_e4230 * _e3853[2]));
                                                                    let _e4306 = (((_e4226 * _e3870) + (_e4228 * _e3871)) + (_e4230 * _e3872));
                                                                    let _e4311 = (((_e4226 * (_e3853[0] - _e3866[0])) + (_e4228 * (_e3853[1] - _e3866[1]))) + (_e4230 * (_e3853[2] - _e3866[2])));
                                                                    let _e4319 = (((_e4226 * _e3879[0]) + (_e4228 * _e3879[1])) + (_e4230 * _e3879[2]));
                                                                    let _e4325 = (((_e4226 * _e3885[0]) + (_e4228 * _e3885[1])) + (_e4230 * _e3885[2]));
                                                                    let _e4330 = (((_e4226 * _e3902) + (_e4228 * _e3903)) + (_e4230 * _e3904));
                                                                    let _e4335 = (((_e4226 * (_e3885[0] - _e3898[0])) + (_e4228 * (_e3885[1] - _e3898[1]))) + (_e4230 * (_e3885[2] - _e3898[2])));
                                                                    let _e4343 = (((_e4226 * _e3911[0]) + (_e4228 * _e3911[1])) + (_e4230 * _e3911[2]));
                                                                    if (_e4301 < 0f) {
                                                                        phi_13172_ = -(_e4301);
                                                                    } else {
                                                                        phi_13172_ = _e4301;
                                                                    }
                                                                    let _e4348 = phi_13172_;
                                                                    if (_e4325 < 0f) {
                                                                        phi_13178_ = -(_e4325);
                                                                    } else {
                                                                        phi_13178_ = _e4325;
                                                                    }
                                                                    let _e4352 = phi_13178_;
                                                                    if (_e4306 < 0f) {
                                                                        phi_13187_ = -(_e4306);
                                                                    } else {
                                                                        phi_13187_ = _e4306;
                                                                    }
                                                                    let _e4359 = phi_13187_;
                                                                    if (_e4330 < 0f) {
                                                                        phi_13193_ = -(_e4330);
                                                                    } else {
                                                                        phi_13193_ = _e4330;
                                                                    }
                                                                    let _e4363 = phi_13193_;
                                                                    if (_e4311 < 0f) {
                                                                        phi_13202_ = -(_e4311);
                                                                    } else {
                                                                        phi_13202_ = _e4311;
                                                                    }
                                                                    let _e4370 = phi_13202_;
                                                                    if (_e4335 < 0f) {
                                                                        phi_13208_ = -(_e4335);
                                                                    } else {
                                                                        phi_13208_ = _e4335;
                                                                    }
                                                                    let _e4374 = phi_13208_;
                                                                    if (_e4319 < 0f) {
                                                                        phi_13217_ = -(_e4319);
                                                                    } else {
                                                                        phi_13217_ = _e4319;
                                                                    }
                                                                    let _e4381 = phi_13217_;
                                                                    if (_e4343 < 0f) {
                                                                        phi_13223_ = -(_e4343);
                                                                    } else {
                                                                        phi_13223_ = _e4343;
                                                                    }
                                                                    let _e4385 = phi_13223_;
                                                                    phi_13229_ = type_31(array<f32, 4>(_e4301, _e4306, _e4311, _e4319), array<f32, 4>(_e4325, _e4330, _e4335, _e4343), array<f32, 4>((_e4296 + ((_e4348 + _e4352) * _e4291)), (_e4296 + ((_e4359 + _e4363) * _e4291)), (_e4296 + ((_e4370 + _e4374) * _e4291)), (_e4296 + ((_e4381 + _e4385) * _e4291))));
                                                                    phi_13230_ = false;
                                                                } else {
                                                                    phi_13229_ = type_31();
                                                                    phi_13230_ = true;
                                                                }
                                                                let _e4392 = phi_13229_;
                                                                let _e4394 = phi_13230_;
                                                                phi_13231_ = _e4392;
                                                                phi_13232_ = _e4394;
                                                            } else {
                                                                phi_13231_ = type_31();
                                                                phi_13232_ = true;
                                                            }
                                                            let _e4396 = phi_13231_;
                                                            let _e4398 = phi_13232_;
                                                            if _e4398 {
                                                                phi_13240_ = type_31(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                            } else {
                                                                phi_13240_ = _e4396;
                                                            }
                                                            let _e4400 = phi_13240_;
                                                            local_1 = type_31(array<f32, 4>(_e4400.member[0], _e4400.member[1], _e4400.member[2], _e4400.member[3]), array<f32, 4>(_e4400.member_1[0], _e4400.member_1[1], _e4400.member_1[2], _e4400.member_1[3]), array<f32, 4>(_e4400.member_2[0], _e4400.member_2[1], _e4400.member_2[2], _e4400.member_2[3]));
                                                            let _e4420 = (_e4092 - _e4098);
                                                            let _e4424 = local_1.member[0u];
                                                            let _e4427 = local_1.member_1[0u];
                                                            let _e4430 = local_1.member[0u];
                                                            let _e4436 = local_1.member_2[0u];
                                                            if (((_e4424 + ((_e4427 - _e4430) * _e4092)) - _e4436) > 0f) {
                                                                let _e4441 = local_1.member[1u];
                                                                let _e4444 = local_1.member_1[1u];
                                                                let _e4447 = local_1.member[1u];
                                                                let _e4453 = local_1.member_2[1u];
                                                                if (((_e4441 + ((_e4444 - _e4447) * _e4092)) - _e4453) > 0f) {
                                                                    let _e4458 = local_1.member[2u];
                                                                    let _e4461 = local_1.member_1[2u];
                                                                    let _e4464 = local_1.member[2u];
                                                                    let _e4470 = local_1.member_2[2u];
                                                                    if (((_e4458 + ((_e4461 - _e4464) * _e4092)) - _e4470) > 0f) {
                                                                        let _e4475 = local_1.member[3u];
                                                                        let _e4478 = local_1.member_1[3u];
                                                                        let _e4481 = local_1.member[3u];
                                                                        let _e4487 = local_1.member_2[3u];
                                                                        phi_13411_ = (((_e4475 + ((_e4478 - _e4481) * _e4092)) - _e4487) > 0f);
                                                                        phi_13412_ = false;
                                                                    } else {
                                                                        phi_13411_ = bool();
                                                                        phi_13412_ = true;
                                                                    }
                                                                    let _e4491 = phi_13411_;
                                                                    let _e4493 = phi_13412_;
                                                                    phi_13413_ = _e4491;
                                                                    phi_13414_ = _e4493;
                                                                } else {
                                                                    phi_13413_ = bool();
                                                                    phi_13414_ = true;
                                                                }
                                                                let _e4495 = phi_13413_;
                                                                let _e4497 = phi_13414_;
                                                                phi_13415_ = _e4495;
                                                                phi_13416_ = _e4497;
                                                            } else {
                                                                phi_13415_ = bool();
                                                                phi_13416_ = true;
                                                            }
                                                            let _e4499 = phi_13415_;
                                                            let _e4501 = phi_13416_;
                                                            if _e4501 {
                                                                phi_13420_ = false;
                                                            } else {
                                                                phi_13420_ = _e4499;
                                                            }
                                                            let _e4503 = phi_13420_;
                                                            if _e4503 {
                                                                if (_e4092 <= _e4094) {
                                                                    phi_13730_ = true;
                                                                } else {
                                                                    let _e4507 = local.member[0u];
                                                                    let _e4510 = local.member_1[0u];
                                                                    let _e4513 = local.member[0u];
                                                                    let _e4519 = local.member_2[0u];
                                                                    let _e4523 = local_1.member[0u];
                                                                    let _e4526 = local_1.member_1[0u];
                                                                    let _e4529 = local_1.member[0u];
                                                                    let _e4535 = local_1.member_2[0u];
                                                                    if ((((_e4507 + ((_e4510 - _e4513) * _e4092)) - _e4519) + ((_e4523 + ((_e4526 - _e4529) * _e4098)) - _e4535)) > 0f) {
                                                                        let _e4541 = local.member[1u];
                                                                        let _e4544 = local.member_1[1u];
                                                                        let _e4547 = local.member[1u];
                                                                        let _e4553 = local.member_2[1u];
                                                                        let _e4557 = local_1.member[1u];
                                                                        let _e4560 = local_1.member_1[1u];
                                                                        let _e4563 = local_1.member[1u];
                                                                        let _e4569 = local_1.member_2[1u];
                                                                        if ((((_e4541 + ((_e4544 - _e4547) * _e4092)) - _e4553) + ((_e4557 + ((_e4560 - _e4563) * _e4098)) - _e4569)) > 0f) {
                                                                            let _e4575 = local.member[2u];
                                                                            let _e4578 = local.member_1[2u];
                                                                            let _e4581 = local.member[2u];
                                                                            let _e4587 = local.member_2[2u];
                                                                            let _e4591 = local_1.member[2u];
                                                                            let _e4594 = local_1.member_1[2u];
                                                                            let _e4597 = local_1.member[2u];
                                                                            let _e4603 = local_1.member_2[2u];
                                                                            if ((((_e4575 + ((_e4578 - _e4581) * _e4092)) - _e4587) + ((_e4591 + ((_e4594 - _e4597) * _e4098)) - _e4603)) > 0f) {
                                                                                let _e4609 = local.member[3u];
                                                                                let _e4612 = local.member_1[3u];
                                                                                let _e4615 = local.member[3u];
                                                                                let _e4621 = local.member_2[3u];
                                                                                let _e4625 = local_1.member[3u];
                                                                                let _e4628 = local_1.member_1[3u];
                                                                                let _e4631 = local_1.member[3u];
                                                                                let _e4637 = local_1.member_2[3u];
                                                                                phi_13717_ = ((((_e4609 + ((_e4612 - _e4615) * _e4092)) - _e4621) + ((_e4625 + ((_e4628 - _e4631) * _e4098)) - _e4637)) > 0f);
                                                                                phi_13718_ = false;
                                                                            } else {
                                                                                phi_13717_ = bool();
                                                                                phi_13718_ = true;
                                                                            }
                                                                            let _e4642 = phi_13717_;
                                                                            let _e4644 = phi_13718_;
                                                                            phi_13719_ = _e4642;
                                                                            phi_13720_ = _e4644;
                                                                        } else {
                                                                            phi_13719_ = bool();
                                                                            phi_13720_ = true;
                                                                        }
                                                                        let _e4646 = phi_13719_;
                                                                        let _e4648 = phi_13720_;
                                                                        phi_13721_ = _e4646;
                                                                        phi_13722_ = _e4648;
                                                                    } else {
                                                                        phi_13721_ = bool();
                                                                        phi_13722_ = true;
                                                                    }
                                                                    let _e4650 = phi_13721_;
                                                                    let _e4652 = phi_13722_;
                                                                    if _e4652 {
                                                                        phi_13726_ = false;
                                                                    } else {
                                                                        phi_13726_ = _e4650;
                                                                    }
                                                                    let _e4654 = phi_13726_;
                                                                    phi_13730_ = _e4654;
                                                                }
                                                                let _e4656 = phi_13730_;
                                                                if _e4656 {
                                                                    if _e4100 {
                                                                        if (_e4092 >= _e3104.member_1) {
                                                                            phi_13741_ = false;
                                                                        } else {
                                                                            phi_13741_ = true;
                                                                        }
                                                                        let _e4659 = phi_13741_;
                                                                        phi_13742_ = _e4659;
                                                                    } else {
                                                                        phi_13742_ = true;
                                                                    }
                                                                    let _e4661 = phi_13742_;
                                                                    if _e4661 {
                                                                        local = type_31(array<f32, 4>(_e4400.member[0], _e4400.member[1], _e4400.member[2], _e4400.member[3]), array<f32, 4>(_e4400.member_1[0], _e4400.member_1[1], _e4400.member_1[2], _e4400.member_1[3]), array<f32, 4>(_e4400.member_2[0], _e4400.member_2[1], _e4400.member_2[2], _e4400.member_2[3]));
                                                                        let _e4683 = local.member[0u];
                                                                        let _e4686 = local.member_1[0u];
                                                                        let _e4689 = local.member_2[0u];
                                                                        if (_e4683 > _e4689) {
                                                                            if (_e4686 > _e4689) {
                                                                                phi_13816_ = false;
                                                                            } else {
                                                                                phi_13816_ = true;
                                                                            }
                                                                            let _e4693 = phi_13816_;
                                                                            phi_13817_ = _e4693;
                                                                        } else {
                                                                            phi_13817_ = true;
                                                                        }
                                                                        let _e4695 = phi_13817_;
                                                                        if _e4695 {
                                                                            let _e4696 = (_e4686 >= _e4683);
                                                                            if _e4696 {
                                                                                phi_13839_ = f32();
                                                                                phi_13840_ = false;
                                                                            } else {
                                                                                if ((_e4683 - _e4686) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_13837_ = (((_e4683 - _e4689) / (_e4683 - _e4686)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_13838_ = false;
                                                                                } else {
                                                                                    phi_13837_ = f32();
                                                                                    phi_13838_ = true;
                                                                                }
                                                                                let _e4707 = phi_13837_;
                                                                                let _e4709 = phi_13838_;
                                                                                phi_13839_ = _e4707;
                                                                                phi_13840_ = _e4709;
                                                                            }
                                                                            let _e4711 = phi_13839_;
                                                                            let _e4713 = phi_13840_;
                                                                            phi_13841_ = _e4711;
                                                                            phi_13842_ = _e4696;
                                                                            phi_13843_ = _e4713;
                                                                        } else {
                                                                            phi_13841_ = f32();
                                                                            phi_13842_ = true;
                                                                            phi_13843_ = false;
                                                                        }
                                                                        let _e4715 = phi_13841_;
                                                                        let _e4717 = phi_13842_;
                                                                        let _e4719 = phi_13843_;
                                                                        if _e4717 {
                                                                            phi_13847_ = 2f;
                                                                            phi_13848_ = true;
                                                                        } else {
                                                                            phi_13847_ = _e4092;
                                                                            phi_13848_ = _e4719;
                                                                        }
                                                                        let _e4721 = phi_13847_;
                                                                        let _e4723 = phi_13848_;
                                                                        if _e4723 {
                                                                            phi_13852_ = _e4721;
                                                                        } else {
                                                                            phi_13852_ = _e4715;
                                                                        }
                                                                        let _e4725 = phi_13852_;
                                                                        let _e4728 = local.member[1u];
                                                                        let _e4731 = local.member_1[1u];
                                                                        let _e4734 = local.member_2[1u];
                                                                        if (_e4728 > _e4734) {
                                                                            if (_e4731 > _e4734) {
                                                                                phi_13884_ = false;
                                                                            } else {
                                                                                phi_13884_ = true;
                                                                            }
                                                                            let _e4738 = phi_13884_;
                                                                            phi_13885_ = _e4738;
                                                                        } else {
                                                                            phi_13885_ = true;
                                                                        }
                                                                        let _e4740 = phi_13885_;
                                                                        if _e4740 {
                                                                            let _e4741 = (_e4731 >= _e4728);
                                                                            if _e4741 {
                                                                                phi_13907_ = f32();
                                                                                phi_13908_ = false;
                                                                            } else {
                                                                                if ((_e4728 - _e4731) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_13905_ = (((_e4728 - _e4734) / (_e4728 - _e4731)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_13906_ = false;
                                                                                } else {
                                                                                    phi_13905_ = f32();
                                                                                    phi_13906_ = true;
                                                                                }
                                                                                let _e4752 = phi_13905_;
                                                                                let _e4754 = phi_13906_;
                                                                                phi_13907_ = _e4752;
                                                                                phi_13908_ = _e4754;
                                                                            }
                                                                            let _e4756 = phi_13907_;
                                                                            let _e4758 = phi_13908_;
                                                                            phi_13909_ = _e4756;
                                                                            phi_13910_ = _e4741;
                                                                            phi_13911_ = _e4758;
                                                                        } else {
                                                                            phi_13909_ = f32();
                                                                            phi_13910_ = true;
                                                                            phi_13911_ = false;
                                                                        }
                                                                        let _e4760 = phi_13909_;
                                                                        let _e4762 = phi_13910_;
                                                                        let _e4764 = phi_13911_;
                                                                        if _e4762 {
                                                                            phi_13915_ = 2f;
                                                                            phi_13916_ = true;
                                                                        } else {
                                                                            phi_13915_ = _e4092;
                                                                            phi_13916_ = _e4764;
                                                                        }
                                                                        let _e4766 = phi_13915_;
                                                                        let _e4768 = phi_13916_;
                                                                        if _e4768 {
                                                                            phi_13920_ = _e4766;
                                                                        } else {
                                                                            phi_13920_ = _e4760;
                                                                        }
                                                                        let _e4770 = phi_13920_;
                                                                        if (_e4725 < _e4770) {
                                                                            phi_13925_ = _e4725;
                                                                        } else {
                                                                            phi_13925_ = _e4770;
                                                                        }
                                                                        let _e4773 = phi_13925_;
                                                                        let _e4776 = local.member[2u];
                                                                        let _e4779 = local.member_1[2u];
                                                                        let _e4782 = local.member_2[2u];
                                                                        if (_e4776 > _e4782) {
                                                                            if (_e4779 > _e4782) {
                                                                                phi_13957_ = false;
                                                                            } else {
                                                                                phi_13957_ = true;
                                                                            }
                                                                            let _e4786 = phi_13957_;
                                                                            phi_13958_ = _e4786;
                                                                        } else {
                                                                            phi_13958_ = true;
                                                                        }
                                                                        let _e4788 = phi_13958_;
                                                                        if _e4788 {
                                                                            let _e4789 = (_e4779 >= _e4776);
                                                                            if _e4789 {
                                                                                phi_13980_ = f32();
                                                                                phi_13981_ = false;
                                                                            } else {
                                                                                if ((_e4776 - _e4779) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_13978_ = (((_e4776 - _e4782) / (_e4776 - _e4779)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_13979_ = false;
                                                                                } else {
                                                                                    phi_13978_ = f32();
                                                                                    phi_13979_ = true;
                                                                                }
                                                                                let _e4800 = phi_13978_;
                                                                                let _e4802 = phi_13979_;
                                                                                phi_13980_ = _e4800;
                                                                                phi_13981_ = _e4802;
                                                                            }
                                                                            let _e4804 = phi_13980_;
                                                                            let _e4806 = phi_13981_;
                                                                            phi_13982_ = _e4804;
                                                                            phi_13983_ = _e4789;
                                                                            phi_13984_ = _e4806;
                                                                        } else {
                                                                            phi_13982_ = f32();
                                                                            phi_13983_ = true;
                                                                            phi_13984_ = false;
                                                                        }
                                                                        let _e4808 = phi_13982_;
                                                                        let _e4810 = phi_13983_;
                                                                        let _e4812 = phi_13984_;
                                                                        if _e4810 {
                                                                            phi_13988_ = 2f;
                                                                            phi_13989_ = true;
                                                                        } else {
                                                                            phi_13988_ = _e4092;
                                                                            phi_13989_ = _e4812;
                                                                        }
                                                                        let _e4814 = phi_13988_;
                                                                        let _e4816 = phi_13989_;
                                                                        if _e4816 {
                                                                            phi_13993_ = _e4814;
                                                                        } else {
                                                                            phi_13993_ = _e4808;
                                                                        }
                                                                        let _e4818 = phi_13993_;
                                                                        let _e4821 = local.member[3u];
                                                                        let _e4824 = local.member_1[3u];
                                                                        let _e4827 = local.member_2[3u];
                                                                        if (_e4821 > _e4827) {
                                                                            if (_e4824 > _e4827) {
                                                                                phi_14025_ = false;
                                                                            } else {
                                                                                phi_14025_ = true;
                                                                            }
                                                                            let _e4831 = phi_14025_;
                                                                            phi_14026_ = _e4831;
                                                                        } else {
                                                                            phi_14026_ = true;
                                                                        }
                                                                        let _e4833 = phi_14026_;
                                                                        if _e4833 {
                                                                            let _e4834 = (_e4824 >= _e4821);
                                                                            if _e4834 {
                                                                                phi_14048_ = f32();
                                                                                phi_14049_ = false;
                                                                            } else {
                                                                                if ((_e4821 - _e4824) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_14046_ = (((_e4821 - _e4827) / (_e4821 - _e4824)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_14047_ = false;
                                                                                } else {
                                                                                    phi_14046_ = f32();
                                                                                    phi_14047_ = true;
                                                                                }
                                                                                let _e4845 = phi_14046_;
                                                                                let _e4847 = phi_14047_;
                                                                                phi_14048_ = _e4845;
                                                                                phi_14049_ = _e4847;
                                                                            }
                                                                            let _e4849 = phi_14048_;
                                                                            let _e4851 = phi_14049_;
                                                                            phi_14050_ = _e4849;
                                                                            phi_14051_ = _e4834;
                                                                            phi_14052_ = _e4851;
                                                                        } else {
                                                                            phi_14050_ = f32();
                                                                            phi_14051_ = true;
                                                                            phi_14052_ = false;
                                                                        }
                                                                        let _e4853 = phi_14050_;
                                                                        let _e4855 = phi_14051_;
                                                                        let _e4857 = phi_14052_;
                                                                        if _e4855 {
                                                                            phi_14056_ = 2f;
                                                                            phi_14057_ = true;
                                                                        } else {
                                                                            phi_14056_ = _e4092;
                                                                            phi_14057_ = _e4857;
                                                                        }
                                                                        let _e4859 = phi_14056_;
                                                                        let _e4861 = phi_14057_;
                                                                        if _e4861 {
                                                                            phi_14061_ = _e4859;
                                                                        } else {
                                                                            phi_14061_ = _e4853;
                                                                        }
                                                                        let _e4863 = phi_14061_;
                                                                        if (_e4818 < _e4863) {
                                                                            phi_14066_ = _e4818;
                                                                        } else {
                                                                            phi_14066_ = _e4863;
                                                                        }
                                                                        let _e4866 = phi_14066_;
                                                                        if (_e4773 < _e4866) {
                                                                            phi_14071_ = _e4773;
                                                                        } else {
                                                                            phi_14071_ = _e4866;
                                                                        }
                                                                        let _e4869 = phi_14071_;
                                                                        if (_e4869 > _e4092) {
                                                                            phi_14076_ = _e4869;
                                                                        } else {
                                                                            phi_14076_ = _e4092;
                                                                        }
                                                                        let _e4872 = phi_14076_;
                                                                        let _e4873 = (_e4872 > _e3104.member_1);
                                                                        if _e4873 {
                                                                            phi_14581_ = f32();
                                                                            phi_14582_ = f32();
                                                                            phi_14583_ = false;
                                                                        } else {
                                                                            let _e4874 = (_e4872 - _e4092);
                                                                            if _e4100 {
                                                                                if (_e4874 <= _e4087) {
                                                                                    phi_14571_ = true;
                                                                                } else {
                                                                                    if (_e4874 <= (_e4096 * 0.25f)) {
                                                                                        phi_14570_ = false;
                                                                                    } else {
                                                                                        phi_14570_ = true;
                                                                                    }
                                                                                    let _e4880 = phi_14570_;
                                                                                    phi_14571_ = _e4880;
                                                                                }
                                                                                let _e4882 = phi_14571_;
                                                                                if _e4882 {
                                                                                    phi_14576_ = (_e4420 + _e4420);
                                                                                } else {
                                                                                    phi_14576_ = 0f;
                                                                                }
                                                                                let _e4885 = phi_14576_;
                                                                                phi_14578_ = _e4885;
                                                                            } else {
                                                                                phi_14578_ = (_e3104.member_1 - _e4092);
                                                                            }
                                                                            let _e4887 = phi_14578_;
                                                                            phi_14581_ = _e4887;
                                                                            phi_14582_ = _e4874;
                                                                            phi_14583_ = true;
                                                                        }
                                                                        let _e4889 = phi_14581_;
                                                                        let _e4891 = phi_14582_;
                                                                        let _e4893 = phi_14583_;
                                                                        phi_14585_ = _e4872;
                                                                        phi_14586_ = _e4889;
                                                                        phi_14587_ = _e4891;
                                                                        phi_14589_ = _e4893;
                                                                        phi_14590_ = _e4873;
                                                                        phi_14592_ = false;
                                                                    } else {
                                                                        phi_14585_ = f32();
                                                                        phi_14586_ = f32();
                                                                        phi_14587_ = f32();
                                                                        phi_14589_ = false;
                                                                        phi_14590_ = false;
                                                                        phi_14592_ = true;
                                                                    }
                                                                    let _e4895 = phi_14585_;
                                                                    let _e4897 = phi_14586_;
                                                                    let _e4899 = phi_14587_;
                                                                    let _e4901 = phi_14589_;
                                                                    let _e4903 = phi_14590_;
                                                                    let _e4905 = phi_14592_;
                                                                    phi_14593_ = _e4895;
                                                                    phi_14594_ = _e4897;
                                                                    phi_14595_ = _e4899;
                                                                    phi_14597_ = false;
                                                                    phi_14598_ = _e4901;
                                                                    phi_14599_ = _e4903;
                                                                    phi_14601_ = _e4905;
                                                                } else {
                                                                    phi_14593_ = f32();
                                                                    phi_14594_ = f32();
                                                                    phi_14595_ = f32();
                                                                    phi_14597_ = true;
                                                                    phi_14598_ = false;
                                                                    phi_14599_ = false;
                                                                    phi_14601_ = false;
                                                                }
                                                                let _e4907 = phi_14593_;
                                                                let _e4909 = phi_14594_;
                                                                let _e4911 = phi_14595_;
                                                                let _e4913 = phi_14597_;
                                                                let _e4915 = phi_14598_;
                                                                let _e4917 = phi_14599_;
                                                                let _e4919 = phi_14601_;
                                                                phi_14602_ = _e4907;
                                                                phi_14603_ = _e4909;
                                                                phi_14604_ = _e4911;
                                                                phi_14606_ = _e4913;
                                                                phi_14607_ = _e4915;
                                                                phi_14608_ = _e4917;
                                                                phi_14610_ = _e4919;
                                                            } else {
                                                                phi_14602_ = f32();
                                                                phi_14603_ = f32();
                                                                phi_14604_ = f32();
                                                                phi_14606_ = true;
                                                                phi_14607_ = false;
                                                                phi_14608_ = false;
                                                                phi_14610_ = false;
                                                            }
                                                            let _e4921 = phi_14602_;
                                                            let _e4923 = phi_14603_;
                                                            let _e4925 = phi_14604_;
                                                            let _e4927 = phi_14606_;
                                                            let _e4929 = phi_14607_;
                                                            let _e4931 = phi_14608_;
                                                            let _e4933 = phi_14610_;
                                                            if _e4927 {
                                                                if (_e4092 <= _e4094) {
                                                                    let _e5094 = (_e4102 + 1u);
                                                                    let _e5095 = (_e5094 > 3u);
                                                                    if _e5095 {
                                                                        phi_14623_ = false;
                                                                    } else {
                                                                        phi_14623_ = true;
                                                                    }
                                                                    let _e5097 = phi_14623_;
                                                                    phi_14945_ = _e5094;
                                                                    phi_14946_ = f32();
                                                                    phi_14947_ = false;
                                                                    phi_14948_ = _e5097;
                                                                    phi_14949_ = _e5095;
                                                                } else {
                                                                    let _e4937 = local.member[0u];
                                                                    let _e4940 = local.member_1[0u];
                                                                    let _e4943 = local.member[0u];
                                                                    let _e4949 = local.member_2[0u];
                                                                    let _e4950 = ((_e4937 + ((_e4940 - _e4943) * _e4098)) - _e4949);
                                                                    let _e4953 = local.member[1u];
                                                                    let _e4956 = local.member_1[1u];
                                                                    let _e4959 = local.member[1u];
                                                                    let _e4965 = local.member_2[1u];
                                                                    let _e4966 = ((_e4953 + ((_e4956 - _e4959) * _e4098)) - _e4965);
                                                                    if (_e4950 < _e4966) {
                                                                        phi_14696_ = _e4950;
                                                                    } else {
                                                                        phi_14696_ = _e4966;
                                                                    }
                                                                    let _e4969 = phi_14696_;
                                                                    let _e4972 = local.member[2u];
                                                                    let _e4975 = local.member_1[2u];
                                                                    let _e4978 = local.member[2u];
                                                                    let _e4984 = local.member_2[2u];
                                                                    let _e4985 = ((_e4972 + ((_e4975 - _e4978) * _e4098)) - _e4984);
                                                                    let _e4988 = local.member[3u];
                                                                    let _e4991 = local.member_1[3u];
                                                                    let _e4994 = local.member[3u];
                                                                    let _e5000 = local.member_2[3u];
                                                                    let _e5001 = ((_e4988 + ((_e4991 - _e4994) * _e4098)) - _e5000);
                                                                    if (_e4985 < _e5001) {
                                                                        phi_14769_ = _e4985;
                                                                    } else {
                                                                        phi_14769_ = _e5001;
                                                                    }
                                                                    let _e5004 = phi_14769_;
                                                                    if (_e4969 < _e5004) {
                                                                        phi_14774_ = _e4969;
                                                                    } else {
                                                                        phi_14774_ = _e5004;
                                                                    }
                                                                    let _e5007 = phi_14774_;
                                                                    let _e5010 = local_1.member[0u];
                                                                    let _e5013 = local_1.member_1[0u];
                                                                    let _e5016 = local_1.member[0u];
                                                                    let _e5022 = local_1.member_2[0u];
                                                                    let _e5023 = ((_e5010 + ((_e5013 - _e5016) * _e4092)) - _e5022);
                                                                    let _e5026 = local_1.member[1u];
                                                                    let _e5029 = local_1.member_1[1u];
                                                                    let _e5032 = local_1.member[1u];
                                                                    let _e5038 = local_1.member_2[1u];
                                                                    let _e5039 = ((_e5026 + ((_e5029 - _e5032) * _e4092)) - _e5038);
                                                                    if (_e5023 < _e5039) {
                                                                        phi_14847_ = _e5023;
                                                                    } else {
                                                                        phi_14847_ = _e5039;
                                                                    }
                                                                    let _e5042 = phi_14847_;
                                                                    let _e5045 = local_1.member[2u];
                                                                    let _e5048 = local_1.member_1[2u];
                                                                    let _e5051 = local_1.member[2u];
                                                                    let _e5057 = local_1.member_2[2u];
                                                                    let _e5058 = ((_e5045 + ((_e5048 - _e5051) * _e4092)) - _e5057);
                                                                    let _e5061 = local_1.member[3u];
                                                                    let _e5064 = local_1.member_1[3u];
                                                                    let _e5067 = local_1.member[3u];
                                                                    let _e5073 = local_1.member_2[3u];
                                                                    let _e5074 = ((_e5061 + ((_e5064 - _e5067) * _e4092)) - _e5073);
                                                                    if (_e5058 < _e5074) {
                                                                        phi_14920_ = _e5058;
                                                                    } else {
                                                                        phi_14920_ = _e5074;
                                                                    }
                                                                    let _e5077 = phi_14920_;
                                                                    if (_e5042 < _e5077) {
                                                                        phi_14925_ = _e5042;
                                                                    } else {
                                                                        phi_14925_ = _e5077;
                                                                    }
                                                                    let _e5080 = phi_14925_;
                                                                    if (_e5080 > 0f) {
                                                                        phi_14943_ = 0.5f;
                                                                    } else {
                                                                        let _e5084 = (0.95f * (_e5007 / (_e5007 - _e5080)));
                                                                        if (_e5084 > 0.0625f) {
                                                                            if (_e5084 < 0.9f) {
                                                                                phi_14941_ = _e5084;
                                                                            } else {
                                                                                phi_14941_ = 0.9f;
                                                                            }
                                                                            let _e5088 = phi_14941_;
                                                                            phi_14942_ = _e5088;
                                                                        } else {
                                                                            phi_14942_ = 0.0625f;
                                                                        }
                                                                        let _e5090 = phi_14942_;
                                                                        phi_14943_ = _e5090;
                                                                    }
                                                                    let _e5092 = phi_14943_;
                                                                    phi_14945_ = u32();
                                                                    phi_14946_ = (_e4420 * _e5092);
                                                                    phi_14947_ = true;
                                                                    phi_14948_ = false;
                                                                    phi_14949_ = false;
                                                                }
                                                                let _e5099 = phi_14945_;
                                                                let _e5101 = phi_14946_;
                                                                let _e5103 = phi_14947_;
                                                                let _e5105 = phi_14948_;
                                                                let _e5107 = phi_14949_;
                                                                phi_14950_ = _e5099;
                                                                phi_14951_ = _e4094;
                                                                phi_14952_ = _e5101;
                                                                phi_14953_ = _e4096;
                                                                phi_14954_ = _e4098;
                                                                phi_14955_ = _e4100;
                                                                phi_14956_ = _e4102;
                                                                phi_14957_ = _e5103;
                                                                phi_14958_ = _e5105;
                                                                phi_14959_ = _e5107;
                                                                phi_14960_ = false;
                                                                phi_14962_ = false;
                                                            } else {
                                                                phi_14950_ = u32();
                                                                phi_14951_ = _e4921;
                                                                phi_14952_ = _e4923;
                                                                phi_14953_ = _e4925;
                                                                phi_14954_ = _e4092;
                                                                phi_14955_ = true;
                                                                phi_14956_ = 0u;
                                                                phi_14957_ = _e4929;
                                                                phi_14958_ = false;
                                                                phi_14959_ = false;
                                                                phi_14960_ = _e4931;
                                                                phi_14962_ = _e4933;
                                                            }
                                                            let _e5109 = phi_14950_;
                                                            let _e5111 = phi_14951_;
                                                            let _e5113 = phi_14952_;
                                                            let _e5115 = phi_14953_;
                                                            let _e5117 = phi_14954_;
                                                            let _e5119 = phi_14955_;
                                                            let _e5121 = phi_14956_;
                                                            let _e5123 = phi_14957_;
                                                            let _e5125 = phi_14958_;
                                                            let _e5127 = phi_14959_;
                                                            let _e5129 = phi_14960_;
                                                            let _e5131 = phi_14962_;
                                                            if _e5123 {
                                                                let _e5132 = (_e5117 + _e5113);
                                                                if (_e5132 > _e5111) {
                                                                    phi_14971_ = _e5132;
                                                                } else {
                                                                    phi_14971_ = _e5111;
                                                                }
                                                                let _e5135 = phi_14971_;
                                                                if (_e5135 < _e3104.member_1) {
                                                                    phi_14976_ = _e5135;
                                                                } else {
                                                                    phi_14976_ = _e3104.member_1;
                                                                }
                                                                let _e5138 = phi_14976_;
                                                                if !(_e4100) {
                                                                    phi_14985_ = true;
                                                                } else {
                                                                    phi_14985_ = ((_e5138 - _e5117) > _e4087);
                                                                }
                                                                let _e5142 = phi_14985_;
                                                                if _e5142 {
                                                                    phi_14989_ = false;
                                                                } else {
                                                                    phi_14989_ = true;
                                                                }
                                                                let _e5144 = phi_14989_;
                                                                phi_14990_ = _e5138;
                                                                phi_14991_ = _e5111;
                                                                phi_14992_ = _e5115;
                                                                phi_14993_ = _e5117;
                                                                phi_14994_ = _e5119;
                                                                phi_14995_ = _e5121;
                                                                phi_14996_ = _e5142;
                                                                phi_14997_ = _e5144;
                                                                phi_14998_ = false;
                                                                phi_14999_ = false;
                                                                phi_15001_ = false;
                                                            } else {
                                                                phi_14990_ = _e4092;
                                                                phi_14991_ = _e4094;
                                                                phi_14992_ = _e4096;
                                                                phi_14993_ = _e4098;
                                                                phi_14994_ = _e4100;
                                                                phi_14995_ = _e5109;
                                                                phi_14996_ = _e5125;
                                                                phi_14997_ = false;
                                                                phi_14998_ = _e5127;
                                                                phi_14999_ = _e5129;
                                                                phi_15001_ = _e5131;
                                                            }
                                                            let _e5146 = phi_14990_;
                                                            let _e5148 = phi_14991_;
                                                            let _e5150 = phi_14992_;
                                                            let _e5152 = phi_14993_;
                                                            let _e5154 = phi_14994_;
                                                            let _e5156 = phi_14995_;
                                                            let _e5158 = phi_14996_;
                                                            let _e5160 = phi_14997_;
                                                            let _e5162 = phi_14998_;
                                                            let _e5164 = phi_14999_;
                                                            let _e5166 = phi_15001_;
                                                            phi_12823_ = _e5146;
                                                            phi_12825_ = _e5148;
                                                            phi_12827_ = _e5150;
                                                            phi_12829_ = _e5152;
                                                            phi_12831_ = _e5154;
                                                            phi_12833_ = _e5156;
                                                            phi_15002_ = _e5111;
                                                            phi_15004_ = _e5158;
                                                            phi_15005_ = _e5160;
                                                            phi_15006_ = _e5162;
                                                            phi_15007_ = _e5164;
                                                            phi_15009_ = false;
                                                            phi_15010_ = _e5166;
                                                        } else {
                                                            phi_12823_ = f32();
                                                            phi_12825_ = f32();
                                                            phi_12827_ = f32();
                                                            phi_12829_ = f32();
                                                            phi_12831_ = bool();
                                                            phi_12833_ = u32();
                                                            phi_15002_ = f32();
                                                            phi_15004_ = false;
                                                            phi_15005_ = false;
                                                            phi_15006_ = false;
                                                            phi_15007_ = false;
                                                            phi_15009_ = true;
                                                            phi_15010_ = false;
                                                        }
                                                        let _e5168 = phi_12823_;
                                                        let _e5170 = phi_12825_;
                                                        let _e5172 = phi_12827_;
                                                        let _e5174 = phi_12829_;
                                                        let _e5176 = phi_12831_;
                                                        let _e5178 = phi_12833_;
                                                        let _e5180 = phi_15002_;
                                                        let _e5182 = phi_15004_;
                                                        let _e5184 = phi_15005_;
                                                        let _e5186 = phi_15006_;
                                                        let _e5188 = phi_15007_;
                                                        let _e5190 = phi_15009_;
                                                        let _e5192 = phi_15010_;
                                                        local_29 = _e5184;
                                                        local_69 = _e5186;
                                                        local_70 = _e5188;
                                                        local_71 = _e5190;
                                                        local_72 = _e5192;
                                                        local_73 = _e5184;
                                                        local_74 = _e5180;
                                                        continue;
                                                        continuing {
                                                            phi_12819_ = _e4114;
                                                            phi_12822_ = _e5168;
                                                            phi_12824_ = _e5170;
                                                            phi_12826_ = _e5172;
                                                            phi_12828_ = _e5174;
                                                            phi_12830_ = _e5176;
                                                            phi_12832_ = _e5178;
                                                            break if !(_e5182);
                                                        }
                                                    }
                                                    let _e5195 = local_29;
                                                    if _e5195 {
                                                        phi_15014_ = false;
                                                        phi_15015_ = false;
                                                        phi_15017_ = false;
                                                        phi_15018_ = false;
                                                    } else {
                                                        let _e10866 = local_69;
                                                        phi_15014_ = _e10866;
                                                        let _e10869 = local_70;
                                                        phi_15015_ = _e10869;
                                                        let _e10872 = local_71;
                                                        phi_15017_ = _e10872;
                                                        let _e10875 = local_72;
                                                        phi_15018_ = _e10875;
                                                    }
                                                    let _e5197 = phi_15014_;
                                                    let _e5199 = phi_15015_;
                                                    let _e5201 = phi_15017_;
                                                    let _e5203 = phi_15018_;
                                                    if _e5197 {
                                                        let _e5205 = local_30;
                                                        phi_15023_ = type_37(1u, _e5205);
                                                        phi_15024_ = false;
                                                        phi_15026_ = false;
                                                        phi_15027_ = false;
                                                        phi_15028_ = false;
                                                    } else {
                                                        phi_15023_ = type_37();
                                                        phi_15024_ = _e5199;
                                                        let _e10881 = local_73;
                                                        phi_15026_ = _e10881;
                                                        phi_15027_ = _e5201;
                                                        phi_15028_ = _e5203;
                                                    }
                                                    let _e5208 = phi_15023_;
                                                    let _e5210 = phi_15024_;
                                                    let _e5212 = phi_15026_;
                                                    let _e5214 = phi_15027_;
                                                    let _e5216 = phi_15028_;
                                                    if _e5210 {
                                                        phi_15033_ = type_37(0u, type_37().member_1);
                                                        phi_15035_ = false;
                                                        phi_15036_ = false;
                                                        phi_15037_ = false;
                                                        phi_15038_ = true;
                                                    } else {
                                                        phi_15033_ = _e5208;
                                                        phi_15035_ = _e5212;
                                                        phi_15036_ = _e5214;
                                                        phi_15037_ = _e5216;
                                                        phi_15038_ = _e5197;
                                                    }
                                                    let _e5220 = phi_15033_;
                                                    let _e5222 = phi_15035_;
                                                    let _e5224 = phi_15036_;
                                                    let _e5226 = phi_15037_;
                                                    let _e5228 = phi_15038_;
                                                    if _e5222 {
                                                        let _e10891 = local_74;
                                                        phi_15050_ = _e10891;
                                                        phi_15051_ = true;
                                                        phi_15052_ = false;
                                                        phi_15053_ = false;
                                                    } else {
                                                        let _e10893 = local_75;
                                                        phi_15050_ = _e10893;
                                                        phi_15051_ = _e5224;
                                                        phi_15052_ = _e5226;
                                                        phi_15053_ = _e5228;
                                                    }
                                                    let _e5230 = phi_15050_;
                                                    let _e5232 = phi_15051_;
                                                    let _e5234 = phi_15052_;
                                                    let _e5236 = phi_15053_;
                                                    if _e5232 {
                                                        phi_15058_ = type_37(1u, _e5230);
                                                        phi_15059_ = false;
                                                        phi_15060_ = false;
                                                    } else {
                                                        phi_15058_ = type_37();
                                                        phi_15059_ = _e5234;
                                                        phi_15060_ = _e5236;
                                                    }
                                                    let _e5239 = phi_15058_;
                                                    let _e5241 = phi_15059_;
                                                    let _e5243 = phi_15060_;
                                                    if _e5241 {
                                                        phi_15065_ = type_37(0u, type_37().member_1);
                                                        phi_15066_ = true;
                                                    } else {
                                                        phi_15065_ = _e5220;
                                                        phi_15066_ = _e5243;
                                                    }
                                                    let _e5247 = phi_15065_;
                                                    let _e5249 = phi_15066_;
                                                    if _e5249 {
                                                        phi_15070_ = _e5247;
                                                    } else {
                                                        phi_15070_ = _e5239;
                                                    }
                                                    let _e5251 = phi_15070_;
                                                    let _e5254 = (_e5251.member != 0u);
                                                    if _e5254 {
                                                        phi_15077_ = false;
                                                    } else {
                                                        phi_15077_ = true;
                                                    }
                                                    let _e5256 = phi_15077_;
                                                    phi_15078_ = _e5251.member_1;
                                                    phi_15079_ = _e5256;
                                                    phi_15080_ = _e5254;
                                                    phi_15081_ = false;
                                                } else {
                                                    phi_15078_ = f32();
                                                    phi_15079_ = false;
                                                    phi_15080_ = false;
                                                    phi_15081_ = true;
                                                }
                                                let _e5258 = phi_15078_;
                                                let _e5260 = phi_15079_;
                                                let _e5262 = phi_15080_;
                                                let _e5264 = phi_15081_;
                                                phi_15082_ = _e3839;
                                                phi_15083_ = _e3840;
                                                phi_15084_ = _e5258;
                                                phi_15085_ = _e5260;
                                                phi_15086_ = _e5262;
                                                phi_15087_ = _e5264;
                                            }
                                            let _e5266 = phi_15082_;
                                            let _e5268 = phi_15083_;
                                            let _e5270 = phi_15084_;
                                            let _e5272 = phi_15085_;
                                            let _e5274 = phi_15086_;
                                            let _e5276 = phi_15087_;
                                            phi_15088_ = _e5266;
                                            phi_15089_ = _e5268;
                                            phi_15090_ = _e5270;
                                            phi_15091_ = _e3835;
                                            phi_15092_ = _e5272;
                                            phi_15093_ = _e5274;
                                            phi_15094_ = _e5276;
                                        }
                                        let _e5278 = phi_15088_;
                                        let _e5280 = phi_15089_;
                                        let _e5282 = phi_15090_;
                                        let _e5284 = phi_15091_;
                                        let _e5286 = phi_15092_;
                                        let _e5288 = phi_15093_;
                                        let _e5290 = phi_15094_;
                                        if _e5284 {
                                            phi_15098_ = false;
                                            phi_15099_ = false;
                                            phi_15100_ = false;
                                        } else {
                                            phi_15098_ = _e5286;
                                            phi_15099_ = _e5288;
                                            phi_15100_ = _e5290;
                                        }
                                        let _e5292 = phi_15098_;
                                        let _e5294 = phi_15099_;
                                        let _e5296 = phi_15100_;
                                        phi_15101_ = _e3104;
                                        phi_15102_ = _e5278;
                                        phi_15103_ = _e5280;
                                        phi_15104_ = _e5282;
                                        phi_15105_ = _e3104;
                                        phi_15106_ = _e5284;
                                        phi_15107_ = _e5292;
                                        phi_15108_ = _e5294;
                                        phi_15109_ = _e5296;
                                    } else {
                                        phi_15101_ = type_40();
                                        phi_15102_ = bool();
                                        phi_15103_ = f32();
                                        phi_15104_ = f32();
                                        phi_15105_ = type_40();
                                        phi_15106_ = true;
                                        phi_15107_ = false;
                                        phi_15108_ = false;
                                        phi_15109_ = false;
                                    }
                                    let _e5298 = phi_15101_;
                                    let _e5300 = phi_15102_;
                                    let _e5302 = phi_15103_;
                                    let _e5304 = phi_15104_;
                                    let _e5306 = phi_15105_;
                                    let _e5308 = phi_15106_;
                                    let _e5310 = phi_15107_;
                                    let _e5312 = phi_15108_;
                                    let _e5314 = phi_15109_;
                                    if _e5308 {
                                        phi_15113_ = true;
                                        phi_15114_ = false;
                                        phi_15115_ = false;
                                    } else {
                                        phi_15113_ = _e5310;
                                        phi_15114_ = _e5312;
                                        phi_15115_ = _e5314;
                                    }
                                    let _e5316 = phi_15113_;
                                    let _e5318 = phi_15114_;
                                    let _e5320 = phi_15115_;
                                    phi_15116_ = _e5298;
                                    phi_15117_ = _e5300;
                                    phi_15118_ = _e5302;
                                    phi_15119_ = _e5304;
                                    phi_15120_ = _e5306;
                                    phi_15121_ = _e5316;
                                    phi_15122_ = false;
                                    phi_15123_ = _e5318;
                                    phi_15124_ = _e5320;
                                } else {
                                    phi_15116_ = type_40();
                                    phi_15117_ = bool();
                                    phi_15118_ = f32();
                                    phi_15119_ = f32();
                                    phi_15120_ = type_40();
                                    phi_15121_ = false;
                                    phi_15122_ = true;
                                    phi_15123_ = false;
                                    phi_15124_ = false;
                                }
                                let _e5322 = phi_15116_;
                                let _e5324 = phi_15117_;
                                let _e5326 = phi_15118_;
                                let _e5328 = phi_15119_;
                                let _e5330 = phi_15120_;
                                let _e5332 = phi_15121_;
                                let _e5334 = phi_15122_;
                                let _e5336 = phi_15123_;
                                let _e5338 = phi_15124_;
                                local_31 = _e5334;
                                local_76 = _e5336;
                                local_77 = _e5338;
                                local_32 = _e5324;
                                local_33 = _e5322;
                                local_34 = _e5328;
                                local_35 = _e5326;
                                local_36 = _e5328;
                                local_37 = _e5328;
                                local_38 = _e5330;
                                continue;
                                continuing {
                                    phi_10927_ = _e2827;
                                    break if !(_e5332);
                                }
                            }
                            let _e5341 = local_31;
                            if _e5341 {
                                phi_15129_ = type_37(0u, type_37().member_1);
                                phi_15130_ = false;
                                phi_15131_ = false;
                            } else {
                                phi_15129_ = type_37();
                                let _e10949 = local_76;
                                phi_15130_ = _e10949;
                                let _e10952 = local_77;
                                phi_15131_ = _e10952;
                            }
                            let _e5345 = phi_15129_;
                            let _e5347 = phi_15130_;
                            let _e5349 = phi_15131_;
                            if _e5347 {
                                let _e5351 = local_32;
                                if _e5351 {
                                    let _e5353 = local_33;
                                    let _e5356 = local_34;
                                    let _e5359 = local_35;
                                    if ((_e5353.member_1 - _e5356) <= _e5359) {
                                        let _e5362 = local_36;
                                        phi_15145_ = type_37(1u, _e5362);
                                        phi_15146_ = false;
                                    } else {
                                        phi_15145_ = type_37();
                                        phi_15146_ = true;
                                    }
                                    let _e5365 = phi_15145_;
                                    let _e5367 = phi_15146_;
                                    phi_15147_ = _e5365;
                                    phi_15148_ = _e5367;
                                } else {
                                    phi_15147_ = type_37();
                                    phi_15148_ = true;
                                }
                                let _e5369 = phi_15147_;
                                let _e5371 = phi_15148_;
                                if _e5371 {
                                    let _e5373 = local_37;
                                    phi_15153_ = type_37(2u, _e5373);
                                } else {
                                    phi_15153_ = _e5369;
                                }
                                let _e5376 = phi_15153_;
                                phi_15154_ = _e5376;
                                phi_15155_ = false;
                            } else {
                                phi_15154_ = type_37();
                                phi_15155_ = _e5349;
                            }
                            let _e5378 = phi_15154_;
                            let _e5380 = phi_15155_;
                            if _e5380 {
                                let _e5382 = local_38;
                                phi_15161_ = type_37(1u, _e5382.member);
                                phi_15162_ = true;
                            } else {
                                phi_15161_ = _e5378;
                                phi_15162_ = _e5347;
                            }
                            let _e5386 = phi_15161_;
                            let _e5388 = phi_15162_;
                            phi_15166_ = _e5386;
                            phi_15167_ = _e5345;
                            phi_15168_ = _e5388;
                        } else {
                            phi_15166_ = _e2673;
                            phi_15167_ = type_37();
                            phi_15168_ = true;
                        }
                        let _e5390 = phi_15166_;
                        let _e5392 = phi_15167_;
                        let _e5394 = phi_15168_;
                        phi_15172_ = _e5390;
                        phi_15173_ = _e5392;
                        phi_15174_ = _e5394;
                    }
                    let _e5398 = phi_15172_;
                    let _e5400 = phi_15173_;
                    let _e5402 = phi_15174_;
                    if _e5402 {
                        phi_15178_ = _e5398;
                    } else {
                        phi_15178_ = _e5400;
                    }
                    let _e5404 = phi_15178_;
                    if (_e5404.member == 1u) {
                        if (_e5404.member_1 > _e387) {
                            phi_15189_ = false;
                        } else {
                            phi_15189_ = true;
                        }
                        let _e5410 = phi_15189_;
                        phi_15190_ = _e5410;
                    } else {
                        phi_15190_ = true;
                    }
                    let _e5412 = phi_15190_;
                    if _e5412 {
                        phi_15194_ = false;
                    } else {
                        phi_15194_ = true;
                    }
                    let _e5414 = phi_15194_;
                    if _e5414 {
                        phi_15198_ = 1u;
                    } else {
                        phi_15198_ = 0u;
                    }
                    let _e5416 = phi_15198_;
                    phi_15202_ = type_38(_e5404, _e5416);
                }
                let _e9956 = phi_15202_;
                switch bitcast<i32>(_e9956.member.member) {
                    case 0: {
                        phi_15217_ = type_30(0u, _e9956.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e9967 = function_(_e9956.member.member_1);
                        phi_15217_ = type_30(0u, _e9956.member_1, _e9967, true);
                        break;
                    }
                    case 2: {
                        let _e9963 = function_(_e9956.member.member_1);
                        phi_15217_ = type_30(1u, _e9956.member_1, _e9963, true);
                        break;
                    }
                    default: {
                        phi_15217_ = type_30();
                        break;
                    }
                }
                let _e9971 = phi_15217_;
                let _e9975 = params.member.member.member_12;
                let _e9976 = bitcast<u32>(_e9975);
                let _e9977 = (_e9976 & 2147483647u);
                if (_e9977 < 8388608u) {
                    phi_15233_ = array<u32, 2>(0u, 0u);
                } else {
                    phi_15233_ = array<u32, 2>((_e9976 << bitcast<u32>(29i)), ((_e9976 ^ _e9977) | ((_e9977 >> bitcast<u32>(3i)) + 939524096u)));
                }
                let _e9988 = phi_15233_;
                if (_e9971.member_2[0] == _e9988[0]) {
                    let _e9994 = params.member.member.member_12;
                    let _e9995 = bitcast<u32>(_e9994);
                    let _e9996 = (_e9995 & 2147483647u);
                    if (_e9996 < 8388608u) {
                        phi_15254_ = array<u32, 2>(0u, 0u);
                    } else {
                        phi_15254_ = array<u32, 2>((_e9995 << bitcast<u32>(29i)), ((_e9995 ^ _e9996) | ((_e9996 >> bitcast<u32>(3i)) + 939524096u)));
                    }
                    let _e10007 = phi_15254_;
                    phi_15257_ = (_e9971.member_2[1] == _e10007[1]);
                } else {
                    phi_15257_ = false;
                }
                let _e10011 = phi_15257_;
                let _e10013 = params.member.member.member_1;
                if ((_e10013 & 128u) != 0u) {
                    phi_15273_ = true;
                } else {
                    let _e10017 = params.member.member.member_1;
                    if ((_e10017 & 64u) != 0u) {
                        phi_15272_ = _e10011;
                    } else {
                        phi_15272_ = false;
                    }
                    let _e10021 = phi_15272_;
                    phi_15273_ = _e10021;
                }
                let _e10023 = phi_15273_;
                if _e9971.member_3 {
                    if _e10023 {
                        phi_15281_ = false;
                    } else {
                        phi_15281_ = true;
                    }
                    let _e10026 = phi_15281_;
                    phi_15282_ = _e10026;
                } else {
                    phi_15282_ = true;
                }
                let _e10028 = phi_15282_;
                if _e10028 {
                    phi_15287_ = _e9971.member;
                } else {
                    phi_15287_ = 1u;
                }
                let _e10031 = phi_15287_;
                if _e9971.member_3 {
                    phi_15295_ = (_e10031 == 0u);
                } else {
                    phi_15295_ = false;
                }
                let _e10037 = phi_15295_;
                if _e10037 {
                    let _e10042 = (_e9971.member_2[1] >> bitcast<u32>(20i));
                    if (_e10042 <= 896u) {
                        phi_15316_ = 0u;
                    } else {
                        phi_15316_ = ((((_e10042 - 896u) << bitcast<u32>(23i)) | ((_e9971.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e9971.member_2[0] >> bitcast<u32>(29i)));
                    }
                    let _e10057 = phi_15316_;
                    let _e10059 = atomicMin((&earliest.member[0u]), _e10057);
                }
                phi_15320_ = type_22(_e203, 0u, _e213, _e216, _e9971.member_2, _e9971.member_1);
                phi_15321_ = _e10037;
                phi_15322_ = (_e10031 != 0u);
            } else {
                phi_15320_ = type_22(_e203, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_15321_ = false;
                phi_15322_ = false;
            }
            let _e10061 = phi_15320_;
            let _e10063 = phi_15321_;
            let _e10065 = phi_15322_;
            let _e10068 = params.member.member.member_1;
            if ((_e10068 & 16u) != 0u) {
                if (_e121 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e10063 {
                    let _e10074 = atomicAdd((&counters[0u]), 1u);
                    phi_15341_ = _e10074;
                } else {
                    phi_15341_ = 0u;
                }
                let _e10076 = phi_15341_;
                workgroupBarrier();
                if (_e121 == 0u) {
                    let _e10079 = atomicLoad((&counters[0u]));
                    if (_e10079 > 0u) {
                        let _e10082 = atomicAdd((&contacts.member[0u]), _e10079);
                        atomicStore((&counters[1u]), _e10082);
                    }
                }
                workgroupBarrier();
                let _e10085 = atomicLoad((&counters[1u]));
                let _e10086 = (_e10085 + _e10076);
                if _e10063 {
                    let _e10089 = params.member.member_1.member_3;
                    if (_e10086 < _e10089) {
                        let _e10091 = (7u * _e10086);
                        atomicStore((&contacts.member[(4u + _e10091)]), _e10061.member);
                        atomicStore((&contacts.member[(_e10091 + 5u)]), _e10061.member_1);
                        atomicStore((&contacts.member[(_e10091 + 6u)]), _e10061.member_2);
                        atomicStore((&contacts.member[(_e10091 + 7u)]), _e10061.member_3);
                        atomicStore((&contacts.member[(_e10091 + 8u)]), _e10061.member_4[0]);
                        atomicStore((&contacts.member[(_e10091 + 9u)]), _e10061.member_4[1]);
                        atomicStore((&contacts.member[(_e10091 + 10u)]), _e10061.member_5);
                    }
                }
            }
            workgroupBarrier();
            if (_e121 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e10065 {
                let _e10118 = atomicAdd((&counters[0u]), 1u);
                phi_15408_ = _e10118;
            } else {
                phi_15408_ = 0u;
            }
            let _e10120 = phi_15408_;
            workgroupBarrier();
            if (_e121 == 0u) {
                let _e10123 = atomicLoad((&counters[0u]));
                if (_e10123 > 0u) {
                    let _e10126 = atomicAdd((&undecided.member[0u]), _e10123);
                    atomicStore((&counters[1u]), _e10126);
                }
            }
            workgroupBarrier();
            let _e10129 = atomicLoad((&counters[1u]));
            let _e10130 = (_e10129 + _e10120);
            if _e10065 {
                let _e10135 = params.member.member_2.member_1;
                if (_e10130 < _e10135) {
                    let _e10137 = (2u * _e10130);
                    atomicStore((&undecided.member[(4u + _e10137)]), _e10061.member_2);
                    atomicStore((&undecided.member[(_e10137 + 5u)]), _e10061.member_3);
                }
            }
        }
        continue;
        continuing {
            phi_304_ = _e190;
            break if !(_e196);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
