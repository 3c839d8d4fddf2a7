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

struct type_10 {
    member: array<u32>,
}

struct type_12 {
    member: u32,
    member_1: u32,
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

struct type_24 {
    member: array<array<u32, 2>>,
}

struct type_26 {
    member: u32,
}

struct type_27 {
    member: type_7,
    member_1: type_8,
    member_2: type_26,
}

struct type_28 {
    member: type_27,
}

struct type_32 {
    member: array<array<f64, 3>>,
}

struct type_33 {
    member: array<array<f64, 3>, 4>,
    member_1: array<array<f64, 3>, 4>,
}

struct type_35 {
    member: array<array<f64, 3>, 2>,
    member_1: array<array<f64, 3>, 2>,
    member_2: array<array<f64, 3>, 2>,
    member_3: f64,
}

struct type_37 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_38 {
    member: array<f64, 4>,
    member_1: array<f64, 4>,
    member_2: array<f64, 4>,
}

struct type_39 {
    member: array<f64, 3>,
    member_1: f64,
    member_2: f64,
}

struct type_40 {
    member: f64,
    member_1: f64,
}

struct type_44 {
    member: array<array<array<f64, 3>, 4>, 2>,
    member_1: f64,
    member_2: f64,
}

struct type_45 {
    member: type_35,
    member_1: f64,
}

struct type_46 {
    member: u32,
    member_1: f64,
}

struct type_47 {
    member: type_46,
    member_1: u32,
}

struct type_48 {
    member: f64,
    member_1: f64,
    member_2: u32,
}

struct type_49 {
    member: f64,
    member_1: f64,
    member_2: bool,
}

struct type_53 {
    member: array<atomic<u32>>,
}

@group(0) @binding(1) 
var<storage> paths: type_21;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_28;
@group(0) @binding(4) 
var<storage> input: type_10;
@group(0) @binding(2) 
var<storage> positions: type_32;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_53;
@group(0) @binding(3) 
var<storage> elements: type_24;
@group(0) @binding(5) 
var<storage, read_write> contacts: type_53;

fn function_(param: array<f32, 3>) -> array<f64, 3> {
    return array<f64, 3>(f64(param[0]), f64(param[1]), f64(param[2]));
}

fn function_1(param_1: f64) -> array<u32, 2> {
    let _e2 = bitcast<u64>(param_1);
    return array<u32, 2>(u32(_e2), u32((_e2 / 4294967296lu)));
}

fn function_2(param_2: array<f64, 3>, param_3: array<f64, 3>) -> array<f64, 3> {
    var phi_16165_: array<f64, 3>;

    if ((((param_3[0] * param_3[0]) + (param_3[1] * param_3[1])) + (param_3[2] * param_3[2])) < (((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2]))) {
        phi_16165_ = param_3;
    } else {
        phi_16165_ = param_2;
    }
    let _e26 = phi_16165_;
    return _e26;
}

fn function_3(param_4: array<f64, 3>, param_5: array<f64, 3>, param_6: array<f64, 3>, param_7: u32) -> array<f64, 3> {
    var phi_16017_: f64;
    var phi_16019_: f64;
    var phi_16061_: f64;
    var phi_16063_: f64;
    var phi_16111_: f64;
    var phi_16113_: f64;
    var phi_15822_: f64;
    var phi_15824_: f64;
    var phi_15872_: f64;
    var phi_15874_: f64;
    var phi_15919_: f64;
    var phi_15921_: f64;
    var phi_15972_: f64;
    var phi_15974_: f64;
    var phi_16128_: array<array<f64, 3>, 4>;

    let _e9 = (param_4[0] - param_5[0]);
    let _e12 = (param_4[1] - param_5[1]);
    let _e15 = (param_4[2] - param_5[2]);
    if (param_7 != 0u) {
        let _e169 = ((((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e169 > f64(0f)) {
            if (_e169 < f64(1f)) {
                phi_15822_ = _e169;
            } else {
                phi_15822_ = f64(1f);
            }
            let _e177 = phi_15822_;
            phi_15824_ = _e177;
        } else {
            phi_15824_ = f64(0f);
        }
        let _e179 = phi_15824_;
        let _e215 = ((((param_4[0] * param_6[0]) + (param_4[1] * param_6[1])) + (param_4[2] * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        if (_e215 > f64(0f)) {
            if (_e215 < f64(1f)) {
                phi_15872_ = _e215;
            } else {
                phi_15872_ = f64(1f);
            }
            let _e223 = phi_15872_;
            phi_15874_ = _e223;
        } else {
            phi_15874_ = f64(0f);
        }
        let _e225 = phi_15874_;
        let _e258 = ((((_e9 * param_6[0]) + (_e12 * param_6[1])) + (_e15 * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        if (_e258 > f64(0f)) {
            if (_e258 < f64(1f)) {
                phi_15919_ = _e258;
            } else {
                phi_15919_ = f64(1f);
            }
            let _e266 = phi_15919_;
            phi_15921_ = _e266;
        } else {
            phi_15921_ = f64(0f);
        }
        let _e268 = phi_15921_;
        let _e281 = (param_4[0] - param_6[0]);
        let _e284 = (param_4[1] - param_6[1]);
        let _e287 = (param_4[2] - param_6[2]);
        let _e307 = ((((_e281 * param_5[0]) + (_e284 * param_5[1])) + (_e287 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e307 > f64(0f)) {
            if (_e307 < f64(1f)) {
                phi_15972_ = _e307;
            } else {
                phi_15972_ = f64(1f);
            }
            let _e315 = phi_15972_;
            phi_15974_ = _e315;
        } else {
            phi_15974_ = f64(0f);
        }
        let _e317 = phi_15974_;
        phi_16128_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e179)), (param_4[1] - (param_5[1] * _e179)), (param_4[2] - (param_5[2] * _e179))), array<f64, 3>((param_4[0] - (param_6[0] * _e225)), (param_4[1] - (param_6[1] * _e225)), (param_4[2] - (param_6[2] * _e225))), array<f64, 3>((_e9 - (param_6[0] * _e268)), (_e12 - (param_6[1] * _e268)), (_e15 - (param_6[2] * _e268))), array<f64, 3>((_e281 - (param_5[0] * _e317)), (_e284 - (param_5[1] * _e317)), (_e287 - (param_5[2] * _e317))));
    } else {
        let _e19 = (param_6[0] - param_5[0]);
        let _e22 = (param_6[1] - param_5[1]);
        let _e25 = (param_6[2] - param_5[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        if (_e36 > f64(0f)) {
            if (_e36 < f64(1f)) {
                phi_16017_ = _e36;
            } else {
                phi_16017_ = f64(1f);
            }
            let _e44 = phi_16017_;
            phi_16019_ = _e44;
        } else {
            phi_16019_ = f64(0f);
        }
        let _e46 = phi_16019_;
        let _e53 = array<f64, 3>((_e9 - (_e19 * _e46)), (_e12 - (_e22 * _e46)), (_e15 - (_e25 * _e46)));
        let _e76 = ((((param_4[0] * param_5[0]) + (param_4[1] * param_5[1])) + (param_4[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e76 > f64(0f)) {
            if (_e76 < f64(1f)) {
                phi_16061_ = _e76;
            } else {
                phi_16061_ = f64(1f);
            }
            let _e84 = phi_16061_;
            phi_16063_ = _e84;
        } else {
            phi_16063_ = f64(0f);
        }
        let _e86 = phi_16063_;
        let _e122 = ((((param_4[0] * param_6[0]) + (param_4[1] * param_6[1])) + (param_4[2] * param_6[2])) / (((param_6[0] * param_6[0]) + (param_6[1] * param_6[1])) + (param_6[2] * param_6[2])));
        if (_e122 > f64(0f)) {
            if (_e122 < f64(1f)) {
                phi_16111_ = _e122;
            } else {
                phi_16111_ = f64(1f);
            }
            let _e130 = phi_16111_;
            phi_16113_ = _e130;
        } else {
            phi_16113_ = f64(0f);
        }
        let _e132 = phi_16113_;
        phi_16128_ = array<array<f64, 3>, 4>(array<f64, 3>((param_4[0] - (param_5[0] * _e86)), (param_4[1] - (param_5[1] * _e86)), (param_4[2] - (param_5[2] * _e86))), array<f64, 3>((param_4[0] - (param_6[0] * _e132)), (param_4[1] - (param_6[1] * _e132)), (param_4[2] - (param_6[2] * _e132))), _e53, _e53);
    }
    let _e330 = phi_16128_;
    let _e333 = function_2(_e330[0], _e330[1]);
    let _e335 = function_2(_e333, _e330[2]);
    let _e337 = function_2(_e335, _e330[3]);
    return _e337;
}

fn function_4(param_8: array<f64, 3>, param_9: array<f64, 3>, param_10: array<f64, 3>, param_11: u32) -> array<f64, 3> {
    var phi_15719_: bool;
    var phi_15720_: bool;
    var phi_15721_: bool;
    var phi_15722_: bool;
    var phi_15726_: bool;
    var phi_15699_: bool;
    var phi_15700_: bool;
    var phi_15701_: bool;
    var phi_15702_: bool;
    var phi_15703_: bool;
    var phi_15704_: bool;
    var phi_15708_: bool;
    var phi_15727_: bool;
    var phi_15761_: array<f64, 3>;
    var phi_15762_: bool;
    var phi_15763_: array<f64, 3>;
    var phi_15764_: bool;
    var phi_15769_: array<f64, 3>;

    let _e23 = (((param_9[0] * param_9[0]) + (param_9[1] * param_9[1])) + (param_9[2] * param_9[2]));
    let _e34 = (((param_9[0] * param_10[0]) + (param_9[1] * param_10[1])) + (param_9[2] * param_10[2]));
    let _e45 = (((param_10[0] * param_10[0]) + (param_10[1] * param_10[1])) + (param_10[2] * param_10[2]));
    let _e56 = (((param_8[0] * param_9[0]) + (param_8[1] * param_9[1])) + (param_8[2] * param_9[2]));
    let _e67 = (((param_8[0] * param_10[0]) + (param_8[1] * param_10[1])) + (param_8[2] * param_10[2]));
    let _e70 = ((_e23 * _e45) - (_e34 * _e34));
    let _e71 = f64(0f);
    let _e72 = f64(1f);
    let _e76 = (((_e56 * _e45) - (_e67 * _e34)) / _e70);
    let _e80 = (((_e67 * _e23) - (_e56 * _e34)) / _e70);
    if (param_11 != 0u) {
        if (_e76 >= _e71) {
            if (_e80 >= _e71) {
                if (_e76 <= _e72) {
                    phi_15699_ = (_e80 <= _e72);
                    phi_15700_ = false;
                } else {
                    phi_15699_ = bool();
                    phi_15700_ = true;
                }
                let _e101 = phi_15699_;
                let _e103 = phi_15700_;
                phi_15701_ = _e101;
                phi_15702_ = _e103;
            } else {
                phi_15701_ = bool();
                phi_15702_ = true;
            }
            let _e105 = phi_15701_;
            let _e107 = phi_15702_;
            phi_15703_ = _e105;
            phi_15704_ = _e107;
        } else {
            phi_15703_ = bool();
            phi_15704_ = true;
        }
        let _e109 = phi_15703_;
        let _e111 = phi_15704_;
        if _e111 {
            phi_15708_ = false;
        } else {
            phi_15708_ = _e109;
        }
        let _e113 = phi_15708_;
        phi_15727_ = _e113;
    } else {
        if (_e76 >= _e71) {
            if (_e80 >= _e71) {
                phi_15719_ = ((_e76 + _e80) <= _e72);
                phi_15720_ = false;
            } else {
                phi_15719_ = bool();
                phi_15720_ = true;
            }
            let _e87 = phi_15719_;
            let _e89 = phi_15720_;
            phi_15721_ = _e87;
            phi_15722_ = _e89;
        } else {
            phi_15721_ = bool();
            phi_15722_ = true;
        }
        let _e91 = phi_15721_;
        let _e93 = phi_15722_;
        if _e93 {
            phi_15726_ = false;
        } else {
            phi_15726_ = _e91;
        }
        let _e95 = phi_15726_;
        phi_15727_ = _e95;
    }
    let _e115 = phi_15727_;
    if (_e70 > ((_e23 * _e45) * (1.1102230246251565e-16lf * f64(64f)))) {
        if _e115 {
            phi_15761_ = array<f64, 3>((param_8[0] - ((param_9[0] * _e76) + (param_10[0] * _e80))), (param_8[1] - ((param_9[1] * _e76) + (param_10[1] * _e80))), (param_8[2] - ((param_9[2] * _e76) + (param_10[2] * _e80))));
            phi_15762_ = false;
        } else {
            phi_15761_ = array<f64, 3>();
            phi_15762_ = true;
        }
        let _e144 = phi_15761_;
        let _e146 = phi_15762_;
        phi_15763_ = _e144;
        phi_15764_ = _e146;
    } else {
        phi_15763_ = array<f64, 3>();
        phi_15764_ = true;
    }
    let _e148 = phi_15763_;
    let _e150 = phi_15764_;
    if _e150 {
        let _e151 = function_3(param_8, param_9, param_10, param_11);
        phi_15769_ = _e151;
    } else {
        phi_15769_ = _e148;
    }
    let _e153 = phi_15769_;
    return _e153;
}

fn function_5(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_38;
    var local_1: type_38;
    var local_2: type_39;
    var local_3: type_39;
    var local_4: type_39;
    var local_5: array<type_40, 4>;
    var local_6: array<f64, 4>;
    var local_7: array<f64, 2>;
    var local_8: type_38;
    var local_9: type_38;
    var local_10: type_38;
    var local_11: type_38;
    var local_12: array<f64, 4>;
    var local_13: array<f32, 3>;
    var local_14: type_44;
    var local_15: type_38;
    var local_16: type_38;
    var local_17: type_38;
    var local_18: type_35;
    var phi_274_: u32;
    var phi_290_: u32;
    var phi_311_: u32;
    var phi_312_: u32;
    var phi_315_: type_12;
    var phi_316_: type_12;
    var phi_339_: type_12;
    var phi_597_: type_33;
    var phi_722_: f64;
    var phi_728_: f64;
    var phi_733_: f64;
    var phi_739_: f64;
    var phi_744_: f64;
    var phi_750_: f64;
    var phi_756_: f64;
    var phi_761_: f64;
    var phi_767_: f64;
    var phi_772_: f64;
    var phi_777_: f64;
    var phi_784_: f64;
    var phi_790_: f64;
    var phi_795_: f64;
    var phi_801_: f64;
    var phi_806_: f64;
    var phi_812_: f64;
    var phi_818_: f64;
    var phi_823_: f64;
    var phi_829_: f64;
    var phi_834_: f64;
    var phi_839_: f64;
    var phi_846_: f64;
    var phi_852_: f64;
    var phi_857_: f64;
    var phi_863_: f64;
    var phi_868_: f64;
    var phi_874_: f64;
    var phi_880_: f64;
    var phi_885_: f64;
    var phi_891_: f64;
    var phi_896_: f64;
    var phi_901_: f64;
    var phi_907_: f64;
    var phi_912_: f64;
    var phi_921_: bool;
    var phi_945_: u64;
    var phi_957_: f64;
    var phi_958_: f64;
    var phi_989_: type_45;
    var phi_990_: bool;
    var phi_991_: type_45;
    var phi_992_: bool;
    var phi_993_: type_45;
    var phi_994_: bool;
    var phi_999_: type_45;
    var phi_8065_: f64;
    var phi_8072_: f64;
    var phi_8077_: f64;
    var phi_8084_: f64;
    var phi_8089_: f64;
    var phi_8102_: f64;
    var phi_8109_: f64;
    var phi_8114_: f64;
    var phi_8121_: f64;
    var phi_8126_: f64;
    var phi_8131_: f64;
    var phi_8148_: f64;
    var phi_8155_: f64;
    var phi_8160_: f64;
    var phi_8167_: f64;
    var phi_8172_: f64;
    var phi_8186_: f64;
    var phi_8193_: f64;
    var phi_8198_: f64;
    var phi_8205_: f64;
    var phi_8210_: f64;
    var phi_8215_: f64;
    var phi_8232_: f64;
    var phi_8239_: f64;
    var phi_8244_: f64;
    var phi_8251_: f64;
    var phi_8256_: f64;
    var phi_8270_: f64;
    var phi_8277_: f64;
    var phi_8282_: f64;
    var phi_8289_: f64;
    var phi_8294_: f64;
    var phi_8299_: f64;
    var phi_8336_: f64;
    var phi_8342_: f64;
    var phi_8349_: f64;
    var phi_8356_: f64;
    var phi_8362_: f64;
    var phi_8369_: f64;
    var phi_8375_: f64;
    var phi_8381_: f64;
    var phi_8387_: f64;
    var phi_8394_: f64;
    var phi_8401_: f64;
    var phi_8429_: f64;
    var phi_8434_: f64;
    var phi_8439_: f64;
    var phi_8444_: f64;
    var phi_8449_: f64;
    var phi_8454_: f64;
    var phi_8465_: f64;
    var phi_8479_: f64;
    var phi_8485_: f64;
    var phi_8490_: f64;
    var phi_8496_: f64;
    var phi_8502_: f64;
    var phi_8507_: f64;
    var phi_8512_: f64;
    var phi_8522_: bool;
    var phi_8529_: f64;
    var phi_8537_: f64;
    var phi_8545_: f64;
    var phi_8564_: f64;
    var phi_8713_: f64;
    var phi_8720_: f64;
    var phi_8725_: f64;
    var phi_8732_: f64;
    var phi_8737_: f64;
    var phi_8750_: f64;
    var phi_8757_: f64;
    var phi_8762_: f64;
    var phi_8769_: f64;
    var phi_8774_: f64;
    var phi_8779_: f64;
    var phi_8796_: f64;
    var phi_8803_: f64;
    var phi_8808_: f64;
    var phi_8815_: f64;
    var phi_8820_: f64;
    var phi_8834_: f64;
    var phi_8841_: f64;
    var phi_8846_: f64;
    var phi_8853_: f64;
    var phi_8858_: f64;
    var phi_8863_: f64;
    var phi_8880_: f64;
    var phi_8887_: f64;
    var phi_8892_: f64;
    var phi_8899_: f64;
    var phi_8904_: f64;
    var phi_8918_: f64;
    var phi_8925_: f64;
    var phi_8930_: f64;
    var phi_8937_: f64;
    var phi_8942_: f64;
    var phi_8947_: f64;
    var phi_9068_: f64;
    var phi_9075_: f64;
    var phi_9083_: f64;
    var phi_9129_: type_16;
    var phi_9132_: f64;
    var phi_9153_: bool;
    var phi_9159_: type_17;
    var phi_9130_: type_16;
    var phi_9173_: type_17;
    var phi_9133_: f64;
    var local_19: f64;
    var phi_9122_: f64;
    var phi_9186_: f64;
    var phi_9255_: f64;
    var phi_9261_: f64;
    var phi_9270_: f64;
    var phi_9276_: f64;
    var phi_9285_: f64;
    var phi_9291_: f64;
    var phi_9300_: f64;
    var phi_9306_: f64;
    var phi_9312_: type_38;
    var phi_9313_: bool;
    var phi_9314_: type_38;
    var phi_9315_: bool;
    var phi_9325_: type_38;
    var phi_9495_: bool;
    var phi_9496_: bool;
    var phi_9497_: bool;
    var phi_9498_: bool;
    var phi_9499_: bool;
    var phi_9500_: bool;
    var phi_9504_: bool;
    var phi_9532_: f64;
    var phi_9538_: f64;
    var phi_9545_: f64;
    var phi_9588_: type_16;
    var phi_9591_: f64;
    var phi_9612_: bool;
    var phi_9618_: type_17;
    var phi_9589_: type_16;
    var phi_9632_: type_17;
    var phi_9592_: f64;
    var local_20: f64;
    var phi_9581_: f64;
    var phi_9645_: f64;
    var phi_9714_: f64;
    var phi_9720_: f64;
    var phi_9729_: f64;
    var phi_9735_: f64;
    var phi_9744_: f64;
    var phi_9750_: f64;
    var phi_9759_: f64;
    var phi_9765_: f64;
    var phi_9771_: type_38;
    var phi_9772_: bool;
    var phi_9773_: type_38;
    var phi_9774_: bool;
    var phi_9784_: type_38;
    var phi_9954_: bool;
    var phi_9955_: bool;
    var phi_9956_: bool;
    var phi_9957_: bool;
    var phi_9958_: bool;
    var phi_9959_: bool;
    var phi_9963_: bool;
    var phi_9991_: f64;
    var phi_9997_: f64;
    var phi_10004_: f64;
    var phi_10047_: type_16;
    var phi_10050_: f64;
    var phi_10071_: bool;
    var phi_10077_: type_17;
    var phi_10048_: type_16;
    var phi_10091_: type_17;
    var phi_10051_: f64;
    var local_21: f64;
    var phi_10040_: f64;
    var phi_10104_: f64;
    var phi_10173_: f64;
    var phi_10179_: f64;
    var phi_10188_: f64;
    var phi_10194_: f64;
    var phi_10203_: f64;
    var phi_10209_: f64;
    var phi_10218_: f64;
    var phi_10224_: f64;
    var phi_10230_: type_38;
    var phi_10231_: bool;
    var phi_10232_: type_38;
    var phi_10233_: bool;
    var phi_10243_: type_38;
    var phi_10413_: bool;
    var phi_10414_: bool;
    var phi_10415_: bool;
    var phi_10416_: bool;
    var phi_10417_: bool;
    var phi_10418_: bool;
    var phi_10422_: bool;
    var phi_10450_: f64;
    var phi_10456_: f64;
    var phi_10463_: f64;
    var phi_10506_: type_16;
    var phi_10509_: f64;
    var phi_10530_: bool;
    var phi_10536_: type_17;
    var phi_10507_: type_16;
    var phi_10550_: type_17;
    var phi_10510_: f64;
    var local_22: f64;
    var phi_10499_: f64;
    var phi_10563_: f64;
    var phi_10632_: f64;
    var phi_10638_: f64;
    var phi_10647_: f64;
    var phi_10653_: f64;
    var phi_10662_: f64;
    var phi_10668_: f64;
    var phi_10677_: f64;
    var phi_10683_: f64;
    var phi_10689_: type_38;
    var phi_10690_: bool;
    var phi_10691_: type_38;
    var phi_10692_: bool;
    var phi_10702_: type_38;
    var phi_10872_: bool;
    var phi_10873_: bool;
    var phi_10874_: bool;
    var phi_10875_: bool;
    var phi_10876_: bool;
    var phi_10877_: bool;
    var phi_10881_: bool;
    var phi_10882_: bool;
    var phi_10883_: bool;
    var phi_10884_: bool;
    var phi_10885_: bool;
    var phi_10886_: bool;
    var phi_10890_: bool;
    var phi_10896_: type_46;
    var phi_10897_: bool;
    var phi_10898_: type_46;
    var phi_10899_: bool;
    var phi_10945_: type_16;
    var phi_10948_: f64;
    var phi_10969_: bool;
    var phi_10975_: type_17;
    var phi_10946_: type_16;
    var phi_10989_: type_17;
    var phi_10949_: f64;
    var local_23: f64;
    var phi_10938_: f64;
    var phi_11002_: f64;
    var phi_11008_: f64;
    var phi_11033_: type_12;
    var phi_11036_: u32;
    var phi_11034_: type_12;
    var phi_11059_: type_12;
    var phi_11103_: u32;
    var phi_11104_: u32;
    var phi_11037_: u32;
    var phi_11105_: u32;
    var phi_11125_: type_12;
    var phi_11126_: type_12;
    var phi_11149_: type_12;
    var phi_11168_: f64;
    var phi_11181_: f64;
    var phi_11217_: f64;
    var phi_11224_: f64;
    var phi_11236_: bool;
    var phi_11237_: bool;
    var phi_11238_: bool;
    var phi_11239_: bool;
    var phi_11243_: bool;
    var phi_11255_: type_49;
    var phi_11256_: type_49;
    var phi_11257_: bool;
    var phi_11258_: type_49;
    var phi_11259_: bool;
    var phi_11272_: f64;
    var phi_11284_: type_12;
    var phi_11287_: f64;
    var phi_11289_: f64;
    var phi_11291_: f64;
    var phi_11285_: type_12;
    var phi_11314_: type_12;
    var phi_11341_: f64;
    var phi_11342_: f64;
    var phi_11370_: f64;
    var phi_11386_: f64;
    var phi_11393_: bool;
    var phi_11394_: bool;
    var phi_11395_: bool;
    var phi_11401_: f64;
    var phi_11402_: f64;
    var phi_11403_: bool;
    var phi_11288_: f64;
    var phi_11290_: f64;
    var phi_11292_: f64;
    var phi_11404_: f64;
    var phi_11405_: bool;
    var phi_11406_: bool;
    var local_24: bool;
    var phi_11410_: f64;
    var phi_11411_: f64;
    var phi_11421_: f64;
    var phi_11425_: type_12;
    var phi_11428_: f64;
    var phi_11426_: type_12;
    var phi_11451_: type_12;
    var phi_11482_: f64;
    var phi_11483_: bool;
    var phi_11484_: f64;
    var phi_11485_: bool;
    var phi_11486_: bool;
    var phi_11487_: bool;
    var phi_11488_: f64;
    var phi_11429_: f64;
    var phi_11489_: bool;
    var phi_11490_: bool;
    var phi_11491_: bool;
    var phi_11492_: bool;
    var local_25: bool;
    var phi_11496_: bool;
    var phi_11497_: bool;
    var phi_11501_: bool;
    var phi_11505_: f64;
    var phi_11506_: f64;
    var phi_11508_: type_49;
    var phi_11539_: f64;
    var phi_11546_: f64;
    var phi_11551_: f64;
    var phi_11558_: f64;
    var phi_11563_: f64;
    var phi_11576_: f64;
    var phi_11583_: f64;
    var phi_11588_: f64;
    var phi_11595_: f64;
    var phi_11600_: f64;
    var phi_11605_: f64;
    var phi_11664_: f64;
    var phi_11670_: f64;
    var phi_11675_: f64;
    var phi_11681_: f64;
    var phi_11686_: f64;
    var phi_11700_: f64;
    var phi_11706_: f64;
    var phi_11711_: f64;
    var phi_11717_: f64;
    var phi_11722_: f64;
    var phi_11748_: f64;
    var phi_11755_: f64;
    var phi_11760_: f64;
    var phi_11767_: f64;
    var phi_11772_: f64;
    var phi_11785_: f64;
    var phi_11792_: f64;
    var phi_11797_: f64;
    var phi_11804_: f64;
    var phi_11809_: f64;
    var phi_11814_: f64;
    var phi_11873_: f64;
    var phi_11879_: f64;
    var phi_11884_: f64;
    var phi_11890_: f64;
    var phi_11895_: f64;
    var phi_11909_: f64;
    var phi_11915_: f64;
    var phi_11920_: f64;
    var phi_11926_: f64;
    var phi_11931_: f64;
    var phi_11957_: f64;
    var phi_11964_: f64;
    var phi_11969_: f64;
    var phi_11976_: f64;
    var phi_11981_: f64;
    var phi_11994_: f64;
    var phi_12001_: f64;
    var phi_12006_: f64;
    var phi_12013_: f64;
    var phi_12018_: f64;
    var phi_12023_: f64;
    var phi_12082_: f64;
    var phi_12088_: f64;
    var phi_12093_: f64;
    var phi_12099_: f64;
    var phi_12104_: f64;
    var phi_12118_: f64;
    var phi_12124_: f64;
    var phi_12129_: f64;
    var phi_12135_: f64;
    var phi_12140_: f64;
    var phi_12189_: f64;
    var phi_12195_: f64;
    var phi_12223_: f64;
    var phi_12229_: f64;
    var phi_12234_: u32;
    var phi_12235_: u32;
    var phi_12205_: f64;
    var phi_12211_: f64;
    var phi_12216_: u32;
    var phi_12217_: u32;
    var phi_12236_: u32;
    var phi_12237_: u32;
    var phi_12310_: f64;
    var phi_12322_: f64;
    var phi_12465_: f64;
    var phi_12471_: f64;
    var phi_12478_: f64;
    var phi_12534_: type_12;
    var phi_12537_: bool;
    var phi_12535_: type_12;
    var phi_12560_: type_12;
    var phi_12587_: bool;
    var phi_12588_: bool;
    var phi_12538_: bool;
    var phi_12589_: bool;
    var phi_12590_: bool;
    var local_26: bool;
    var phi_12594_: bool;
    var local_27: bool;
    var phi_12601_: u32;
    var phi_12602_: u32;
    var phi_12603_: bool;
    var phi_12604_: u32;
    var phi_12605_: u32;
    var phi_12606_: bool;
    var phi_12610_: u32;
    var phi_12620_: bool;
    var phi_12633_: bool;
    var phi_12634_: bool;
    var phi_12782_: f64;
    var phi_12789_: f64;
    var phi_12794_: f64;
    var phi_12801_: f64;
    var phi_12806_: f64;
    var phi_12819_: f64;
    var phi_12826_: f64;
    var phi_12831_: f64;
    var phi_12838_: f64;
    var phi_12843_: f64;
    var phi_12848_: f64;
    var phi_12865_: f64;
    var phi_12872_: f64;
    var phi_12877_: f64;
    var phi_12884_: f64;
    var phi_12889_: f64;
    var phi_12903_: f64;
    var phi_12910_: f64;
    var phi_12915_: f64;
    var phi_12922_: f64;
    var phi_12927_: f64;
    var phi_12932_: f64;
    var phi_12949_: f64;
    var phi_12956_: f64;
    var phi_12961_: f64;
    var phi_12968_: f64;
    var phi_12973_: f64;
    var phi_12987_: f64;
    var phi_12994_: f64;
    var phi_12999_: f64;
    var phi_13006_: f64;
    var phi_13011_: f64;
    var phi_13016_: f64;
    var phi_13063_: type_12;
    var phi_13066_: f64;
    var phi_13068_: f64;
    var phi_13070_: f64;
    var phi_13072_: f64;
    var phi_13074_: bool;
    var phi_13076_: u32;
    var phi_13064_: type_12;
    var phi_13099_: type_12;
    var phi_13214_: f64;
    var phi_13220_: f64;
    var phi_13226_: f64;
    var phi_13228_: array<f64, 3>;
    var phi_13235_: f64;
    var phi_13242_: f64;
    var phi_13250_: f64;
    var phi_13296_: type_16;
    var phi_13299_: f64;
    var phi_13320_: bool;
    var phi_13326_: type_17;
    var phi_13297_: type_16;
    var phi_13340_: type_17;
    var phi_13300_: f64;
    var local_28: f64;
    var phi_13289_: f64;
    var phi_13353_: f64;
    var phi_13422_: f64;
    var phi_13428_: f64;
    var phi_13437_: f64;
    var phi_13443_: f64;
    var phi_13452_: f64;
    var phi_13458_: f64;
    var phi_13467_: f64;
    var phi_13473_: f64;
    var phi_13479_: type_38;
    var phi_13480_: bool;
    var phi_13481_: type_38;
    var phi_13482_: bool;
    var phi_13492_: type_38;
    var phi_13664_: bool;
    var phi_13665_: bool;
    var phi_13666_: bool;
    var phi_13667_: bool;
    var phi_13668_: bool;
    var phi_13669_: bool;
    var phi_13673_: bool;
    var phi_13971_: bool;
    var phi_13972_: bool;
    var phi_13973_: bool;
    var phi_13974_: bool;
    var phi_13975_: bool;
    var phi_13976_: bool;
    var phi_13980_: bool;
    var phi_13984_: bool;
    var phi_13995_: bool;
    var phi_13996_: bool;
    var phi_14070_: bool;
    var phi_14071_: bool;
    var phi_14094_: f64;
    var phi_14095_: bool;
    var phi_14096_: f64;
    var phi_14097_: bool;
    var phi_14098_: f64;
    var phi_14099_: bool;
    var phi_14100_: bool;
    var phi_14105_: f64;
    var phi_14106_: bool;
    var phi_14110_: f64;
    var phi_14142_: bool;
    var phi_14143_: bool;
    var phi_14166_: f64;
    var phi_14167_: bool;
    var phi_14168_: f64;
    var phi_14169_: bool;
    var phi_14170_: f64;
    var phi_14171_: bool;
    var phi_14172_: bool;
    var phi_14177_: f64;
    var phi_14178_: bool;
    var phi_14182_: f64;
    var phi_14187_: f64;
    var phi_14219_: bool;
    var phi_14220_: bool;
    var phi_14243_: f64;
    var phi_14244_: bool;
    var phi_14245_: f64;
    var phi_14246_: bool;
    var phi_14247_: f64;
    var phi_14248_: bool;
    var phi_14249_: bool;
    var phi_14254_: f64;
    var phi_14255_: bool;
    var phi_14259_: f64;
    var phi_14291_: bool;
    var phi_14292_: bool;
    var phi_14315_: f64;
    var phi_14316_: bool;
    var phi_14317_: f64;
    var phi_14318_: bool;
    var phi_14319_: f64;
    var phi_14320_: bool;
    var phi_14321_: bool;
    var phi_14326_: f64;
    var phi_14327_: bool;
    var phi_14331_: f64;
    var phi_14336_: f64;
    var phi_14341_: f64;
    var phi_14346_: f64;
    var phi_14360_: f64;
    var phi_14498_: type_16;
    var phi_14501_: f64;
    var phi_14522_: bool;
    var phi_14528_: type_17;
    var phi_14499_: type_16;
    var phi_14542_: type_17;
    var phi_14502_: f64;
    var local_29: f64;
    var phi_14491_: f64;
    var phi_14555_: f64;
    var phi_14573_: f64;
    var phi_14580_: f64;
    var phi_14585_: f64;
    var phi_14592_: f64;
    var phi_14597_: f64;
    var phi_14610_: f64;
    var phi_14617_: f64;
    var phi_14622_: f64;
    var phi_14629_: f64;
    var phi_14634_: f64;
    var phi_14639_: f64;
    var phi_14656_: f64;
    var phi_14663_: f64;
    var phi_14668_: f64;
    var phi_14675_: f64;
    var phi_14680_: f64;
    var phi_14694_: f64;
    var phi_14701_: f64;
    var phi_14706_: f64;
    var phi_14713_: f64;
    var phi_14718_: f64;
    var phi_14723_: f64;
    var phi_14740_: f64;
    var phi_14747_: f64;
    var phi_14752_: f64;
    var phi_14759_: f64;
    var phi_14764_: f64;
    var phi_14778_: f64;
    var phi_14785_: f64;
    var phi_14790_: f64;
    var phi_14797_: f64;
    var phi_14802_: f64;
    var phi_14807_: f64;
    var phi_14831_: bool;
    var phi_14832_: bool;
    var phi_14833_: bool;
    var phi_14850_: f64;
    var phi_14851_: bool;
    var phi_14852_: f64;
    var phi_14853_: bool;
    var phi_14858_: f64;
    var phi_14860_: f64;
    var phi_14861_: f64;
    var phi_14862_: bool;
    var phi_14863_: f64;
    var phi_14864_: f64;
    var phi_14865_: bool;
    var phi_14866_: bool;
    var phi_14867_: f64;
    var phi_14868_: f64;
    var phi_14869_: f64;
    var phi_14870_: f64;
    var phi_14871_: bool;
    var phi_14872_: bool;
    var phi_14873_: bool;
    var phi_14874_: bool;
    var phi_14875_: f64;
    var phi_14876_: f64;
    var phi_14877_: f64;
    var phi_14878_: f64;
    var phi_14879_: bool;
    var phi_14880_: bool;
    var phi_14881_: bool;
    var phi_14882_: bool;
    var phi_14883_: bool;
    var phi_14884_: f64;
    var phi_14885_: f64;
    var phi_14886_: f64;
    var phi_14887_: f64;
    var phi_14888_: bool;
    var phi_14889_: bool;
    var phi_14890_: bool;
    var phi_14891_: bool;
    var phi_14892_: bool;
    var phi_14978_: f64;
    var phi_15051_: f64;
    var phi_15056_: f64;
    var phi_15129_: f64;
    var phi_15202_: f64;
    var phi_15207_: f64;
    var phi_15228_: f64;
    var phi_15229_: f64;
    var phi_15230_: f64;
    var phi_14905_: bool;
    var phi_15232_: u32;
    var phi_15233_: f64;
    var phi_15234_: bool;
    var phi_15235_: bool;
    var phi_15236_: bool;
    var phi_15237_: u32;
    var phi_15238_: f64;
    var phi_15239_: f64;
    var phi_15240_: f64;
    var phi_15241_: f64;
    var phi_15242_: bool;
    var phi_15243_: u32;
    var phi_15244_: bool;
    var phi_15245_: bool;
    var phi_15246_: bool;
    var phi_15247_: bool;
    var phi_15248_: bool;
    var phi_15249_: bool;
    var phi_15258_: f64;
    var phi_15263_: f64;
    var phi_15272_: bool;
    var phi_15276_: bool;
    var phi_15277_: f64;
    var phi_15278_: f64;
    var phi_15279_: f64;
    var phi_15280_: f64;
    var phi_15281_: bool;
    var phi_15282_: u32;
    var phi_15283_: bool;
    var phi_15284_: bool;
    var phi_15285_: bool;
    var phi_15286_: bool;
    var phi_15287_: bool;
    var phi_15288_: bool;
    var phi_13067_: f64;
    var phi_13069_: f64;
    var phi_13071_: f64;
    var phi_13073_: f64;
    var phi_13075_: bool;
    var phi_13077_: u32;
    var phi_15289_: f64;
    var phi_15290_: f64;
    var phi_15291_: bool;
    var phi_15292_: bool;
    var phi_15293_: bool;
    var phi_15294_: bool;
    var phi_15295_: bool;
    var phi_15296_: bool;
    var phi_15297_: bool;
    var local_30: bool;
    var phi_15301_: bool;
    var phi_15302_: bool;
    var phi_15303_: bool;
    var phi_15304_: bool;
    var phi_15305_: bool;
    var local_31: f64;
    var phi_15310_: type_46;
    var phi_15311_: bool;
    var phi_15312_: bool;
    var phi_15313_: bool;
    var phi_15314_: bool;
    var phi_15315_: bool;
    var phi_15320_: type_46;
    var phi_15321_: bool;
    var phi_15322_: bool;
    var phi_15323_: bool;
    var phi_15324_: bool;
    var phi_15325_: bool;
    var phi_15329_: f64;
    var phi_15330_: bool;
    var phi_15331_: bool;
    var phi_15332_: bool;
    var phi_15333_: bool;
    var phi_15337_: f64;
    var phi_15338_: bool;
    var phi_15339_: bool;
    var phi_15340_: bool;
    var phi_15345_: type_46;
    var phi_15346_: bool;
    var phi_15347_: bool;
    var phi_15352_: type_46;
    var phi_15353_: bool;
    var phi_15357_: type_46;
    var phi_15364_: bool;
    var phi_15365_: f64;
    var phi_15366_: bool;
    var phi_15367_: bool;
    var phi_15368_: bool;
    var phi_15369_: bool;
    var phi_15370_: f64;
    var phi_15371_: f64;
    var phi_15372_: bool;
    var phi_15373_: bool;
    var phi_15374_: bool;
    var phi_15375_: bool;
    var phi_15376_: f64;
    var phi_15377_: f64;
    var phi_15378_: bool;
    var phi_15379_: bool;
    var phi_15380_: bool;
    var phi_15381_: bool;
    var phi_15385_: bool;
    var phi_15386_: bool;
    var phi_15387_: bool;
    var phi_15388_: type_49;
    var phi_15389_: bool;
    var phi_15390_: f64;
    var phi_15391_: f64;
    var phi_15392_: type_49;
    var phi_15393_: bool;
    var phi_15394_: bool;
    var phi_15395_: bool;
    var phi_15396_: bool;
    var phi_15400_: bool;
    var phi_15401_: bool;
    var phi_15402_: bool;
    var phi_15403_: type_49;
    var phi_15404_: bool;
    var phi_15405_: f64;
    var phi_15406_: f64;
    var phi_15407_: type_49;
    var phi_15408_: bool;
    var phi_15409_: bool;
    var phi_15410_: bool;
    var phi_15411_: bool;
    var local_32: bool;
    var phi_15416_: type_46;
    var phi_15417_: bool;
    var phi_15418_: bool;
    var local_33: bool;
    var local_34: type_49;
    var local_35: f64;
    var local_36: f64;
    var local_37: f64;
    var phi_15432_: type_46;
    var phi_15433_: bool;
    var phi_15434_: type_46;
    var phi_15435_: bool;
    var local_38: f64;
    var phi_15440_: type_46;
    var phi_15441_: type_46;
    var phi_15442_: bool;
    var local_39: type_49;
    var phi_15448_: type_46;
    var phi_15449_: bool;
    var phi_15453_: type_46;
    var phi_15454_: type_46;
    var phi_15455_: bool;
    var phi_15459_: type_46;
    var phi_15460_: type_46;
    var phi_15461_: bool;
    var phi_15465_: type_46;
    var phi_15476_: bool;
    var phi_15477_: bool;
    var phi_15481_: bool;
    var phi_15485_: u32;
    var phi_1174_: type_16;
    var phi_1177_: f64;
    var phi_1198_: bool;
    var phi_1204_: type_17;
    var phi_1175_: type_16;
    var phi_1218_: type_17;
    var phi_1178_: f64;
    var local_40: f64;
    var phi_1167_: f64;
    var phi_1231_: f64;
    var phi_1249_: f64;
    var phi_1256_: f64;
    var phi_1261_: f64;
    var phi_1268_: f64;
    var phi_1273_: f64;
    var phi_1286_: f64;
    var phi_1293_: f64;
    var phi_1298_: f64;
    var phi_1305_: f64;
    var phi_1310_: f64;
    var phi_1315_: f64;
    var phi_1332_: f64;
    var phi_1339_: f64;
    var phi_1344_: f64;
    var phi_1351_: f64;
    var phi_1356_: f64;
    var phi_1370_: f64;
    var phi_1377_: f64;
    var phi_1382_: f64;
    var phi_1389_: f64;
    var phi_1394_: f64;
    var phi_1399_: f64;
    var phi_1416_: f64;
    var phi_1423_: f64;
    var phi_1428_: f64;
    var phi_1435_: f64;
    var phi_1440_: f64;
    var phi_1454_: f64;
    var phi_1461_: f64;
    var phi_1466_: f64;
    var phi_1473_: f64;
    var phi_1478_: f64;
    var phi_1483_: f64;
    var phi_1748_: f64;
    var phi_1755_: f64;
    var phi_1760_: f64;
    var phi_1767_: f64;
    var phi_1772_: f64;
    var phi_1785_: f64;
    var phi_1792_: f64;
    var phi_1797_: f64;
    var phi_1804_: f64;
    var phi_1809_: f64;
    var phi_1814_: f64;
    var phi_1831_: f64;
    var phi_1838_: f64;
    var phi_1843_: f64;
    var phi_1850_: f64;
    var phi_1855_: f64;
    var phi_1869_: f64;
    var phi_1876_: f64;
    var phi_1881_: f64;
    var phi_1888_: f64;
    var phi_1893_: f64;
    var phi_1898_: f64;
    var phi_1915_: f64;
    var phi_1922_: f64;
    var phi_1927_: f64;
    var phi_1934_: f64;
    var phi_1939_: f64;
    var phi_1953_: f64;
    var phi_1960_: f64;
    var phi_1965_: f64;
    var phi_1972_: f64;
    var phi_1977_: f64;
    var phi_1982_: f64;
    var phi_2019_: f64;
    var phi_2025_: f64;
    var phi_2032_: f64;
    var phi_2039_: f64;
    var phi_2045_: f64;
    var phi_2052_: f64;
    var phi_2058_: f64;
    var phi_2064_: f64;
    var phi_2070_: f64;
    var phi_2077_: f64;
    var phi_2084_: f64;
    var phi_2112_: f64;
    var phi_2117_: f64;
    var phi_2122_: f64;
    var phi_2127_: f64;
    var phi_2132_: f64;
    var phi_2137_: f64;
    var phi_2148_: f64;
    var phi_2158_: type_47;
    var phi_2159_: bool;
    var phi_2160_: type_47;
    var phi_2161_: bool;
    var phi_2167_: type_16;
    var phi_2170_: f64;
    var phi_2172_: u32;
    var phi_2174_: f64;
    var phi_2195_: bool;
    var phi_2201_: type_17;
    var phi_2168_: type_16;
    var phi_2215_: type_17;
    var phi_2230_: bool;
    var phi_2231_: bool;
    var phi_2377_: f64;
    var phi_2384_: f64;
    var phi_2389_: f64;
    var phi_2396_: f64;
    var phi_2401_: f64;
    var phi_2414_: f64;
    var phi_2421_: f64;
    var phi_2426_: f64;
    var phi_2433_: f64;
    var phi_2438_: f64;
    var phi_2443_: f64;
    var phi_2460_: f64;
    var phi_2467_: f64;
    var phi_2472_: f64;
    var phi_2479_: f64;
    var phi_2484_: f64;
    var phi_2498_: f64;
    var phi_2505_: f64;
    var phi_2510_: f64;
    var phi_2517_: f64;
    var phi_2522_: f64;
    var phi_2527_: f64;
    var phi_2544_: f64;
    var phi_2551_: f64;
    var phi_2556_: f64;
    var phi_2563_: f64;
    var phi_2568_: f64;
    var phi_2582_: f64;
    var phi_2589_: f64;
    var phi_2594_: f64;
    var phi_2601_: f64;
    var phi_2606_: f64;
    var phi_2611_: f64;
    var phi_2658_: type_12;
    var phi_2661_: f64;
    var phi_2663_: f64;
    var phi_2665_: f64;
    var phi_2667_: f64;
    var phi_2669_: bool;
    var phi_2671_: u32;
    var phi_2659_: type_12;
    var phi_2694_: type_12;
    var phi_2809_: f64;
    var phi_2815_: f64;
    var phi_2821_: f64;
    var phi_2823_: array<f64, 3>;
    var phi_2830_: f64;
    var phi_2837_: f64;
    var phi_2845_: f64;
    var phi_2891_: type_16;
    var phi_2894_: f64;
    var phi_2915_: bool;
    var phi_2921_: type_17;
    var phi_2892_: type_16;
    var phi_2935_: type_17;
    var phi_2895_: f64;
    var local_41: f64;
    var phi_2884_: f64;
    var phi_2948_: f64;
    var phi_3017_: f64;
    var phi_3023_: f64;
    var phi_3032_: f64;
    var phi_3038_: f64;
    var phi_3047_: f64;
    var phi_3053_: f64;
    var phi_3062_: f64;
    var phi_3068_: f64;
    var phi_3074_: type_38;
    var phi_3075_: bool;
    var phi_3076_: type_38;
    var phi_3077_: bool;
    var phi_3087_: type_38;
    var phi_3259_: bool;
    var phi_3260_: bool;
    var phi_3261_: bool;
    var phi_3262_: bool;
    var phi_3263_: bool;
    var phi_3264_: bool;
    var phi_3268_: bool;
    var phi_3566_: bool;
    var phi_3567_: bool;
    var phi_3568_: bool;
    var phi_3569_: bool;
    var phi_3570_: bool;
    var phi_3571_: bool;
    var phi_3575_: bool;
    var phi_3579_: bool;
    var phi_3590_: bool;
    var phi_3591_: bool;
    var phi_3665_: bool;
    var phi_3666_: bool;
    var phi_3689_: f64;
    var phi_3690_: bool;
    var phi_3691_: f64;
    var phi_3692_: bool;
    var phi_3693_: f64;
    var phi_3694_: bool;
    var phi_3695_: bool;
    var phi_3700_: f64;
    var phi_3701_: bool;
    var phi_3705_: f64;
    var phi_3737_: bool;
    var phi_3738_: bool;
    var phi_3761_: f64;
    var phi_3762_: bool;
    var phi_3763_: f64;
    var phi_3764_: bool;
    var phi_3765_: f64;
    var phi_3766_: bool;
    var phi_3767_: bool;
    var phi_3772_: f64;
    var phi_3773_: bool;
    var phi_3777_: f64;
    var phi_3782_: f64;
    var phi_3814_: bool;
    var phi_3815_: bool;
    var phi_3838_: f64;
    var phi_3839_: bool;
    var phi_3840_: f64;
    var phi_3841_: bool;
    var phi_3842_: f64;
    var phi_3843_: bool;
    var phi_3844_: bool;
    var phi_3849_: f64;
    var phi_3850_: bool;
    var phi_3854_: f64;
    var phi_3886_: bool;
    var phi_3887_: bool;
    var phi_3910_: f64;
    var phi_3911_: bool;
    var phi_3912_: f64;
    var phi_3913_: bool;
    var phi_3914_: f64;
    var phi_3915_: bool;
    var phi_3916_: bool;
    var phi_3921_: f64;
    var phi_3922_: bool;
    var phi_3926_: f64;
    var phi_3931_: f64;
    var phi_3936_: f64;
    var phi_3941_: f64;
    var phi_3955_: f64;
    var phi_4093_: type_16;
    var phi_4096_: f64;
    var phi_4117_: bool;
    var phi_4123_: type_17;
    var phi_4094_: type_16;
    var phi_4137_: type_17;
    var phi_4097_: f64;
    var local_42: f64;
    var phi_4086_: f64;
    var phi_4150_: f64;
    var phi_4168_: f64;
    var phi_4175_: f64;
    var phi_4180_: f64;
    var phi_4187_: f64;
    var phi_4192_: f64;
    var phi_4205_: f64;
    var phi_4212_: f64;
    var phi_4217_: f64;
    var phi_4224_: f64;
    var phi_4229_: f64;
    var phi_4234_: f64;
    var phi_4251_: f64;
    var phi_4258_: f64;
    var phi_4263_: f64;
    var phi_4270_: f64;
    var phi_4275_: f64;
    var phi_4289_: f64;
    var phi_4296_: f64;
    var phi_4301_: f64;
    var phi_4308_: f64;
    var phi_4313_: f64;
    var phi_4318_: f64;
    var phi_4335_: f64;
    var phi_4342_: f64;
    var phi_4347_: f64;
    var phi_4354_: f64;
    var phi_4359_: f64;
    var phi_4373_: f64;
    var phi_4380_: f64;
    var phi_4385_: f64;
    var phi_4392_: f64;
    var phi_4397_: f64;
    var phi_4402_: f64;
    var phi_4426_: bool;
    var phi_4427_: bool;
    var phi_4428_: bool;
    var phi_4445_: f64;
    var phi_4446_: bool;
    var phi_4447_: f64;
    var phi_4448_: bool;
    var phi_4453_: f64;
    var phi_4455_: f64;
    var phi_4456_: f64;
    var phi_4457_: bool;
    var phi_4458_: f64;
    var phi_4459_: f64;
    var phi_4460_: bool;
    var phi_4461_: bool;
    var phi_4462_: f64;
    var phi_4463_: f64;
    var phi_4464_: f64;
    var phi_4465_: f64;
    var phi_4466_: bool;
    var phi_4467_: bool;
    var phi_4468_: bool;
    var phi_4469_: bool;
    var phi_4470_: f64;
    var phi_4471_: f64;
    var phi_4472_: f64;
    var phi_4473_: f64;
    var phi_4474_: bool;
    var phi_4475_: bool;
    var phi_4476_: bool;
    var phi_4477_: bool;
    var phi_4478_: bool;
    var phi_4479_: f64;
    var phi_4480_: f64;
    var phi_4481_: f64;
    var phi_4482_: f64;
    var phi_4483_: bool;
    var phi_4484_: bool;
    var phi_4485_: bool;
    var phi_4486_: bool;
    var phi_4487_: bool;
    var phi_4573_: f64;
    var phi_4646_: f64;
    var phi_4651_: f64;
    var phi_4724_: f64;
    var phi_4797_: f64;
    var phi_4802_: f64;
    var phi_4823_: f64;
    var phi_4824_: f64;
    var phi_4825_: f64;
    var phi_4500_: bool;
    var phi_4827_: u32;
    var phi_4828_: f64;
    var phi_4829_: bool;
    var phi_4830_: bool;
    var phi_4831_: bool;
    var phi_4832_: u32;
    var phi_4833_: f64;
    var phi_4834_: f64;
    var phi_4835_: f64;
    var phi_4836_: f64;
    var phi_4837_: bool;
    var phi_4838_: u32;
    var phi_4839_: bool;
    var phi_4840_: bool;
    var phi_4841_: bool;
    var phi_4842_: bool;
    var phi_4843_: bool;
    var phi_4844_: bool;
    var phi_4853_: f64;
    var phi_4858_: f64;
    var phi_4867_: bool;
    var phi_4871_: bool;
    var phi_4872_: f64;
    var phi_4873_: f64;
    var phi_4874_: f64;
    var phi_4875_: f64;
    var phi_4876_: bool;
    var phi_4877_: u32;
    var phi_4878_: bool;
    var phi_4879_: bool;
    var phi_4880_: bool;
    var phi_4881_: bool;
    var phi_4882_: bool;
    var phi_4883_: bool;
    var phi_2662_: f64;
    var phi_2664_: f64;
    var phi_2666_: f64;
    var phi_2668_: f64;
    var phi_2670_: bool;
    var phi_2672_: u32;
    var phi_4884_: f64;
    var phi_4885_: f64;
    var phi_4886_: bool;
    var phi_4887_: bool;
    var phi_4888_: bool;
    var phi_4889_: bool;
    var phi_4890_: bool;
    var phi_4891_: bool;
    var phi_4892_: bool;
    var local_43: bool;
    var phi_4896_: bool;
    var phi_4897_: bool;
    var phi_4898_: bool;
    var phi_4899_: bool;
    var phi_4900_: bool;
    var local_44: f64;
    var phi_4905_: type_46;
    var phi_4906_: bool;
    var phi_4907_: bool;
    var phi_4908_: bool;
    var phi_4909_: bool;
    var phi_4910_: bool;
    var phi_4915_: type_46;
    var phi_4916_: bool;
    var phi_4917_: bool;
    var phi_4918_: bool;
    var phi_4919_: bool;
    var phi_4920_: bool;
    var phi_4924_: f64;
    var phi_4925_: bool;
    var phi_4926_: bool;
    var phi_4927_: bool;
    var phi_4928_: bool;
    var phi_4932_: f64;
    var phi_4933_: bool;
    var phi_4934_: bool;
    var phi_4935_: bool;
    var phi_4940_: type_46;
    var phi_4941_: bool;
    var phi_4942_: bool;
    var phi_4947_: type_46;
    var phi_4948_: bool;
    var phi_4952_: type_46;
    var phi_4959_: f64;
    var phi_4960_: bool;
    var phi_5073_: f64;
    var phi_5080_: f64;
    var phi_5088_: f64;
    var phi_5239_: f64;
    var phi_5246_: f64;
    var phi_5251_: f64;
    var phi_5258_: f64;
    var phi_5263_: f64;
    var phi_5276_: f64;
    var phi_5283_: f64;
    var phi_5288_: f64;
    var phi_5295_: f64;
    var phi_5300_: f64;
    var phi_5305_: f64;
    var phi_5322_: f64;
    var phi_5329_: f64;
    var phi_5334_: f64;
    var phi_5341_: f64;
    var phi_5346_: f64;
    var phi_5360_: f64;
    var phi_5367_: f64;
    var phi_5372_: f64;
    var phi_5379_: f64;
    var phi_5384_: f64;
    var phi_5389_: f64;
    var phi_5406_: f64;
    var phi_5413_: f64;
    var phi_5418_: f64;
    var phi_5425_: f64;
    var phi_5430_: f64;
    var phi_5444_: f64;
    var phi_5451_: f64;
    var phi_5456_: f64;
    var phi_5463_: f64;
    var phi_5468_: f64;
    var phi_5473_: f64;
    var phi_5585_: type_16;
    var phi_5588_: f64;
    var phi_5609_: bool;
    var phi_5615_: type_17;
    var phi_5586_: type_16;
    var phi_5629_: type_17;
    var phi_5589_: f64;
    var local_45: f64;
    var phi_5578_: f64;
    var phi_5642_: f64;
    var phi_5779_: f64;
    var phi_5785_: f64;
    var phi_5794_: f64;
    var phi_5800_: f64;
    var phi_5809_: f64;
    var phi_5815_: f64;
    var phi_5824_: f64;
    var phi_5830_: f64;
    var phi_5880_: type_16;
    var phi_5883_: f64;
    var phi_5904_: bool;
    var phi_5910_: type_17;
    var phi_5881_: type_16;
    var phi_5924_: type_17;
    var phi_5884_: f64;
    var local_46: f64;
    var phi_5873_: f64;
    var phi_5937_: f64;
    var phi_5969_: type_16;
    var phi_5972_: f64;
    var phi_5993_: bool;
    var phi_5999_: type_17;
    var phi_5970_: type_16;
    var phi_6013_: type_17;
    var phi_5973_: f64;
    var local_47: f64;
    var phi_5962_: f64;
    var phi_6026_: f64;
    var phi_6044_: f64;
    var phi_6051_: f64;
    var phi_6056_: f64;
    var phi_6063_: f64;
    var phi_6068_: f64;
    var phi_6081_: f64;
    var phi_6088_: f64;
    var phi_6093_: f64;
    var phi_6100_: f64;
    var phi_6105_: f64;
    var phi_6110_: f64;
    var phi_6127_: f64;
    var phi_6134_: f64;
    var phi_6139_: f64;
    var phi_6146_: f64;
    var phi_6151_: f64;
    var phi_6165_: f64;
    var phi_6172_: f64;
    var phi_6177_: f64;
    var phi_6184_: f64;
    var phi_6189_: f64;
    var phi_6194_: f64;
    var phi_6211_: f64;
    var phi_6218_: f64;
    var phi_6223_: f64;
    var phi_6230_: f64;
    var phi_6235_: f64;
    var phi_6249_: f64;
    var phi_6256_: f64;
    var phi_6261_: f64;
    var phi_6268_: f64;
    var phi_6273_: f64;
    var phi_6278_: f64;
    var phi_6326_: f64;
    var phi_6332_: f64;
    var phi_6344_: type_12;
    var phi_6347_: f64;
    var phi_6345_: type_12;
    var phi_6370_: type_12;
    var phi_6400_: f64;
    var phi_6406_: f64;
    var phi_6420_: f64;
    var phi_6348_: f64;
    var local_48: f64;
    var local_49: f64;
    var phi_6449_: type_16;
    var phi_6452_: f64;
    var phi_6473_: bool;
    var phi_6479_: type_17;
    var phi_6450_: type_16;
    var phi_6493_: type_17;
    var phi_6453_: f64;
    var local_50: f64;
    var phi_6442_: f64;
    var phi_6506_: f64;
    var phi_6513_: type_12;
    var phi_6516_: f64;
    var phi_6518_: bool;
    var phi_6520_: bool;
    var phi_6514_: type_12;
    var phi_6543_: type_12;
    var phi_6580_: f64;
    var phi_6587_: f64;
    var phi_6595_: f64;
    var phi_6603_: f64;
    var phi_6610_: f64;
    var phi_6618_: f64;
    var phi_6624_: f64;
    var phi_6644_: f64;
    var phi_6650_: f64;
    var phi_6657_: f64;
    var phi_6686_: f64;
    var phi_6692_: f64;
    var phi_6729_: bool;
    var phi_6736_: bool;
    var phi_6749_: f64;
    var phi_6755_: f64;
    var phi_6756_: f64;
    var phi_6757_: f64;
    var phi_6517_: f64;
    var phi_6519_: bool;
    var phi_6521_: bool;
    var local_51: f64;
    var phi_6763_: f64;
    var local_52: bool;
    var local_53: bool;
    var phi_6774_: type_48;
    var phi_6775_: type_48;
    var phi_6776_: bool;
    var local_54: bool;
    var phi_6794_: f64;
    var phi_6795_: f64;
    var phi_6798_: type_12;
    var phi_6801_: f64;
    var phi_6803_: f64;
    var phi_6799_: type_12;
    var phi_6826_: type_12;
    var phi_6912_: f64;
    var phi_6913_: f64;
    var phi_6914_: f64;
    var phi_6895_: f64;
    var phi_6915_: f64;
    var phi_6916_: f64;
    var phi_6802_: f64;
    var phi_6804_: f64;
    var local_55: f64;
    var local_56: f64;
    var local_57: f64;
    var phi_7079_: bool;
    var phi_7080_: bool;
    var phi_7081_: bool;
    var phi_7082_: bool;
    var phi_7083_: bool;
    var phi_7084_: bool;
    var phi_7088_: bool;
    var phi_7092_: bool;
    var phi_7093_: bool;
    var phi_7094_: bool;
    var phi_7099_: f64;
    var phi_7103_: type_48;
    var phi_7104_: type_48;
    var phi_7105_: bool;
    var phi_7106_: type_48;
    var phi_7107_: type_48;
    var phi_7108_: bool;
    var phi_7114_: type_48;
    var phi_7115_: type_48;
    var phi_7116_: bool;
    var phi_7120_: type_48;
    var phi_7121_: type_48;
    var phi_7122_: bool;
    var phi_7123_: bool;
    var phi_7124_: type_48;
    var phi_7125_: type_48;
    var phi_7126_: bool;
    var phi_7127_: bool;
    var phi_7133_: type_48;
    var phi_7134_: bool;
    var phi_7138_: type_48;
    var phi_7154_: f64;
    var phi_7155_: f64;
    var phi_7156_: bool;
    var phi_7157_: f64;
    var phi_7158_: f64;
    var phi_7159_: bool;
    var phi_7160_: bool;
    var phi_7161_: bool;
    var phi_7162_: f64;
    var phi_7163_: f64;
    var phi_7164_: bool;
    var phi_7165_: bool;
    var phi_7166_: bool;
    var phi_7167_: f64;
    var phi_7168_: u32;
    var phi_7169_: f64;
    var phi_7170_: type_48;
    var phi_7171_: u32;
    var phi_7172_: u32;
    var phi_7173_: bool;
    var phi_7174_: bool;
    var phi_7175_: bool;
    var phi_7176_: f64;
    var phi_7177_: u32;
    var phi_7178_: f64;
    var phi_7179_: type_48;
    var phi_7180_: u32;
    var phi_7181_: u32;
    var phi_7182_: bool;
    var phi_7183_: bool;
    var phi_7184_: bool;
    var phi_7185_: bool;
    var phi_7186_: bool;
    var phi_7187_: f64;
    var phi_2171_: f64;
    var phi_2173_: u32;
    var phi_2175_: f64;
    var phi_7188_: type_48;
    var phi_7189_: u32;
    var phi_7190_: f64;
    var phi_7191_: u32;
    var phi_7192_: bool;
    var phi_7193_: bool;
    var phi_7194_: bool;
    var phi_7195_: bool;
    var phi_7196_: bool;
    var phi_7197_: bool;
    var local_58: bool;
    var phi_7201_: bool;
    var phi_7202_: bool;
    var phi_7203_: bool;
    var phi_7204_: bool;
    var local_59: type_48;
    var local_60: type_48;
    var phi_7221_: u32;
    var local_61: type_48;
    var phi_7226_: type_47;
    var phi_7227_: type_47;
    var phi_7228_: bool;
    var phi_7229_: bool;
    var phi_7230_: bool;
    var phi_7231_: bool;
    var phi_7235_: u32;
    var phi_7236_: f64;
    var phi_7237_: bool;
    var phi_7238_: bool;
    var phi_7239_: bool;
    var phi_7240_: bool;
    var phi_7244_: f64;
    var phi_7245_: u32;
    var phi_7246_: bool;
    var phi_7247_: bool;
    var phi_7248_: bool;
    var phi_7262_: f64;
    var phi_7265_: type_12;
    var phi_7266_: type_12;
    var phi_7289_: type_12;
    var phi_7311_: f64;
    var phi_7441_: type_16;
    var phi_7444_: f64;
    var phi_7465_: bool;
    var phi_7471_: type_17;
    var phi_7442_: type_16;
    var phi_7485_: type_17;
    var phi_7445_: f64;
    var local_62: f64;
    var phi_7434_: f64;
    var phi_7498_: f64;
    var phi_7516_: f64;
    var phi_7523_: f64;
    var phi_7528_: f64;
    var phi_7535_: f64;
    var phi_7540_: f64;
    var phi_7553_: f64;
    var phi_7560_: f64;
    var phi_7565_: f64;
    var phi_7572_: f64;
    var phi_7577_: f64;
    var phi_7582_: f64;
    var phi_7599_: f64;
    var phi_7606_: f64;
    var phi_7611_: f64;
    var phi_7618_: f64;
    var phi_7623_: f64;
    var phi_7637_: f64;
    var phi_7644_: f64;
    var phi_7649_: f64;
    var phi_7656_: f64;
    var phi_7661_: f64;
    var phi_7666_: f64;
    var phi_7683_: f64;
    var phi_7690_: f64;
    var phi_7695_: f64;
    var phi_7702_: f64;
    var phi_7707_: f64;
    var phi_7721_: f64;
    var phi_7728_: f64;
    var phi_7733_: f64;
    var phi_7740_: f64;
    var phi_7745_: f64;
    var phi_7750_: f64;
    var phi_7774_: bool;
    var phi_7775_: bool;
    var phi_7776_: bool;
    var local_63: bool;
    var phi_7784_: u32;
    var phi_7788_: type_47;
    var phi_7789_: bool;
    var phi_7797_: u32;
    var phi_7801_: type_47;
    var phi_7802_: type_47;
    var phi_7803_: bool;
    var phi_7804_: bool;
    var phi_7811_: type_47;
    var phi_7812_: bool;
    var phi_7816_: type_47;
    var phi_7817_: type_47;
    var phi_7818_: bool;
    var phi_7822_: type_47;
    var phi_15489_: type_47;
    var phi_15504_: type_37;
    var phi_15528_: u32;
    var phi_15532_: type_22;
    var phi_15533_: bool;
    var phi_15552_: u32;
    var local_64: u32;
    var local_65: f64;
    var local_66: f64;
    var local_67: bool;
    var local_68: bool;
    var local_69: f64;
    var local_70: bool;
    var local_71: bool;
    var local_72: bool;
    var local_73: bool;
    var local_74: bool;
    var local_75: bool;
    var local_76: f64;
    var local_77: f64;
    var local_78: f64;
    var local_79: bool;
    var local_80: bool;
    var local_81: bool;
    var local_82: bool;
    var local_83: bool;
    var local_84: bool;
    var local_85: bool;
    var local_86: bool;
    var local_87: f64;
    var local_88: f64;
    var local_89: f64;
    var local_90: f64;
    var local_91: bool;
    var local_92: bool;
    var local_93: bool;
    var local_94: bool;
    var local_95: bool;
    var local_96: u32;
    var local_97: bool;
    var local_98: u32;
    var local_99: u32;
    var local_100: f64;
    var local_101: f64;
    var local_102: f64;
    var local_103: u32;
    var id_2: vec3<u32>;
    var n_2: vec3<u32>;
    var lane_2: u32;

    id_2 = id_1;
    n_2 = n_1;
    lane_2 = lane_1;
    let _e122 = id_2;
    let _e123 = n_2;
    let _e124 = lane_2;
    let _e136 = ((_e122.y * _e123.x) + _e122.x);
    let _e139 = (_e123.x * _e123.y);
    let _e142 = params.member.member_1.member_2;
    let _e144 = input.member[0u];
    if (_e142 < _e144) {
        phi_274_ = _e142;
    } else {
        phi_274_ = _e144;
    }
    let _e147 = phi_274_;
    let _e148 = (_e147 / 64u);
    if ((_e147 % 64u) > 0u) {
        phi_290_ = (_e148 + 1u);
    } else {
        phi_290_ = _e148;
    }
    let _e153 = phi_290_;
    if (_e153 > _e136) {
        let _e155 = (_e153 - _e136);
        if (_e139 == 0u) {
            return;
        }
        let _e157 = (_e155 / _e139);
        if (_e139 == 0u) {
            return;
        }
        if ((_e155 % _e139) > 0u) {
            phi_311_ = (_e157 + 1u);
        } else {
            phi_311_ = _e157;
        }
        let _e163 = phi_311_;
        phi_312_ = _e163;
    } else {
        phi_312_ = 0u;
    }
    let _e165 = phi_312_;
    phi_315_ = type_12(0u, _e165);
    loop {
        let _e168 = phi_315_;
        if (_e168.member < _e168.member_1) {
            phi_316_ = type_12((_e168.member + 1u), _e168.member_1);
            phi_339_ = type_12(1u, _e168.member);
        } else {
            phi_316_ = _e168;
            phi_339_ = type_12(0u, type_12().member_1);
        }
        let _e180 = phi_316_;
        let _e182 = phi_339_;
        let _e186 = (bitcast<i32>(_e182.member) != 0i);
        if _e186 {
            let _e190 = (((_e136 + (_e182.member_1 * _e139)) * 64u) + _e124);
            if (_e190 < _e147) {
                let _e192 = (2u * _e190);
                let _e195 = input.member[(4u + _e192)];
                let _e198 = input.member[(_e192 + 5u)];
                let _e201 = elements.member[_e195];
                let _e203 = elements.member[_e198];
                let _e209 = params.member.member.member_1;
                if ((_e209 & 8u) != 0u) {
                    let _e248 = paths.member[_e201[0]];
                    let _e250 = paths.member[_e201[1]];
                    let _e256 = paths.member[_e203[0]];
                    let _e258 = paths.member[_e203[1]];
                    let _e295 = function_(array<f32, 3>(_e248.member[0], _e248.member[1], _e248.member[2]));
                    let _e296 = function_(array<f32, 3>(_e250.member[0], _e250.member[1], _e250.member[2]));
                    let _e297 = function_(array<f32, 3>(_e256.member[0], _e256.member[1], _e256.member[2]));
                    let _e298 = function_(array<f32, 3>(_e258.member[0], _e258.member[1], _e258.member[2]));
                    let _e300 = function_(array<f32, 3>(_e248.member_1[0], _e248.member_1[1], _e248.member_1[2]));
                    let _e301 = function_(array<f32, 3>(_e250.member_1[0], _e250.member_1[1], _e250.member_1[2]));
                    let _e302 = function_(array<f32, 3>(_e256.member_1[0], _e256.member_1[1], _e256.member_1[2]));
                    let _e303 = function_(array<f32, 3>(_e258.member_1[0], _e258.member_1[1], _e258.member_1[2]));
                    phi_597_ = type_33(array<array<f64, 3>, 4>(_e295, _e296, _e297, _e298), array<array<f64, 3>, 4>(_e300, _e301, _e302, _e303));
                } else {
                    let _e213 = positions.member[_e201[0]];
                    let _e216 = params.member.member.member[0u];
                    let _e219 = positions.member[(_e216 + _e201[0])];
                    let _e221 = positions.member[_e201[1]];
                    let _e224 = params.member.member.member[0u];
                    let _e227 = positions.member[(_e224 + _e201[1])];
                    let _e229 = positions.member[_e203[0]];
                    let _e232 = params.member.member.member[0u];
                    let _e235 = positions.member[(_e232 + _e203[0])];
                    let _e237 = positions.member[_e203[1]];
                    let _e240 = params.member.member.member[0u];
                    let _e243 = positions.member[(_e240 + _e203[1])];
                    phi_597_ = type_33(array<array<f64, 3>, 4>(_e213, _e221, _e229, _e237), array<array<f64, 3>, 4>(_e219, _e227, _e235, _e243));
                }
                let _e307 = phi_597_;
                let _e314 = (_e307.member[2][0] - _e307.member[0][0]);
                let _e317 = (_e307.member[2][1] - _e307.member[0][1]);
                let _e320 = (_e307.member[2][2] - _e307.member[0][2]);
                let _e326 = (_e307.member_1[2][0] - _e307.member_1[0][0]);
                let _e329 = (_e307.member_1[2][1] - _e307.member_1[0][1]);
                let _e332 = (_e307.member_1[2][2] - _e307.member_1[0][2]);
                let _e339 = (_e307.member[1][0] - _e307.member[0][0]);
                let _e342 = (_e307.member[1][1] - _e307.member[0][1]);
                let _e345 = (_e307.member[1][2] - _e307.member[0][2]);
                let _e351 = (_e307.member_1[1][0] - _e307.member_1[0][0]);
                let _e354 = (_e307.member_1[1][1] - _e307.member_1[0][1]);
                let _e357 = (_e307.member_1[1][2] - _e307.member_1[0][2]);
                let _e364 = (_e307.member[2][0] - _e307.member[3][0]);
                let _e367 = (_e307.member[2][1] - _e307.member[3][1]);
                let _e370 = (_e307.member[2][2] - _e307.member[3][2]);
                let _e376 = (_e307.member_1[2][0] - _e307.member_1[3][0]);
                let _e379 = (_e307.member_1[2][1] - _e307.member_1[3][1]);
                let _e382 = (_e307.member_1[2][2] - _e307.member_1[3][2]);
                let _e385 = (0.0lf + 0.0lf);
                let _e388 = params.member.member.member_7;
                let _e395 = bitcast<f64>(((u64(_e388[1]) * 4294967296lu) + u64(_e388[0])));
                let _e397 = params.member.member.member_14;
                let _e404 = bitcast<f64>(((u64(_e397[1]) * 4294967296lu) + u64(_e397[0])));
                let _e406 = params.member.member.member_15;
                let _e413 = bitcast<f64>(((u64(_e406[1]) * 4294967296lu) + u64(_e406[0])));
                let _e415 = params.member.member.member_16;
                let _e422 = bitcast<f64>(((u64(_e415[1]) * 4294967296lu) + u64(_e415[0])));
                let _e424 = params.member.member.member_1;
                if (_e314 < 0.0lf) {
                    phi_722_ = -(_e314);
                } else {
                    phi_722_ = _e314;
                }
                let _e430 = phi_722_;
                if (_e317 < 0.0lf) {
                    phi_728_ = -(_e317);
                } else {
                    phi_728_ = _e317;
                }
                let _e434 = phi_728_;
                if (_e430 > _e434) {
                    phi_733_ = _e430;
                } else {
                    phi_733_ = _e434;
                }
                let _e437 = phi_733_;
                if (_e320 < 0.0lf) {
                    phi_739_ = -(_e320);
                } else {
                    phi_739_ = _e320;
                }
                let _e441 = phi_739_;
                if (_e437 > _e441) {
                    phi_744_ = _e437;
                } else {
                    phi_744_ = _e441;
                }
                let _e444 = phi_744_;
                if (_e326 < 0.0lf) {
                    phi_750_ = -(_e326);
                } else {
                    phi_750_ = _e326;
                }
                let _e448 = phi_750_;
                if (_e329 < 0.0lf) {
                    phi_756_ = -(_e329);
                } else {
                    phi_756_ = _e329;
                }
                let _e452 = phi_756_;
                if (_e448 > _e452) {
                    phi_761_ = _e448;
                } else {
                    phi_761_ = _e452;
                }
                let _e455 = phi_761_;
                if (_e332 < 0.0lf) {
                    phi_767_ = -(_e332);
                } else {
                    phi_767_ = _e332;
                }
                let _e459 = phi_767_;
                if (_e455 > _e459) {
                    phi_772_ = _e455;
                } else {
                    phi_772_ = _e459;
                }
                let _e462 = phi_772_;
                if (_e444 > _e462) {
                    phi_777_ = _e444;
                } else {
                    phi_777_ = _e462;
                }
                let _e465 = phi_777_;
                let _e466 = (_e465 + _e385);
                if (_e339 < 0.0lf) {
                    phi_784_ = -(_e339);
                } else {
                    phi_784_ = _e339;
                }
                let _e470 = phi_784_;
                if (_e342 < 0.0lf) {
                    phi_790_ = -(_e342);
                } else {
                    phi_790_ = _e342;
                }
                let _e474 = phi_790_;
                if (_e470 > _e474) {
                    phi_795_ = _e470;
                } else {
                    phi_795_ = _e474;
                }
                let _e477 = phi_795_;
                if (_e345 < 0.0lf) {
                    phi_801_ = -(_e345);
                } else {
                    phi_801_ = _e345;
                }
                let _e481 = phi_801_;
                if (_e477 > _e481) {
                    phi_806_ = _e477;
                } else {
                    phi_806_ = _e481;
                }
                let _e484 = phi_806_;
                if (_e351 < 0.0lf) {
                    phi_812_ = -(_e351);
                } else {
                    phi_812_ = _e351;
                }
                let _e488 = phi_812_;
                if (_e354 < 0.0lf) {
                    phi_818_ = -(_e354);
                } else {
                    phi_818_ = _e354;
                }
                let _e492 = phi_818_;
                if (_e488 > _e492) {
                    phi_823_ = _e488;
                } else {
                    phi_823_ = _e492;
                }
                let _e495 = phi_823_;
                if (_e357 < 0.0lf) {
                    phi_829_ = -(_e357);
                } else {
                    phi_829_ = _e357;
                }
                let _e499 = phi_829_;
                if (_e495 > _e499) {
                    phi_834_ = _e495;
                } else {
                    phi_834_ = _e499;
                }
                let _e502 = phi_834_;
                if (_e484 > _e502) {
                    phi_839_ = _e484;
                } else {
                    phi_839_ = _e502;
                }
                let _e505 = phi_839_;
                let _e506 = (_e505 + _e385);
                if (_e364 < 0.0lf) {
                    phi_846_ = -(_e364);
                } else {
                    phi_846_ = _e364;
                }
                let _e510 = phi_846_;
                if (_e367 < 0.0lf) {
                    phi_852_ = -(_e367);
                } else {
                    phi_852_ = _e367;
                }
                let _e514 = phi_852_;
                if (_e510 > _e514) {
                    phi_857_ = _e510;
                } else {
                    phi_857_ = _e514;
                }
                let _e517 = phi_857_;
                if (_e370 < 0.0lf) {
                    phi_863_ = -(_e370);
                } else {
                    phi_863_ = _e370;
                }
                let _e521 = phi_863_;
                if (_e517 > _e521) {
                    phi_868_ = _e517;
                } else {
                    phi_868_ = _e521;
                }
                let _e524 = phi_868_;
                if (_e376 < 0.0lf) {
                    phi_874_ = -(_e376);
                } else {
                    phi_874_ = _e376;
                }
                let _e528 = phi_874_;
                if (_e379 < 0.0lf) {
                    phi_880_ = -(_e379);
                } else {
                    phi_880_ = _e379;
                }
                let _e532 = phi_880_;
                if (_e528 > _e532) {
                    phi_885_ = _e528;
                } else {
                    phi_885_ = _e532;
                }
                let _e535 = phi_885_;
                if (_e382 < 0.0lf) {
                    phi_891_ = -(_e382);
                } else {
                    phi_891_ = _e382;
                }
                let _e539 = phi_891_;
                if (_e535 > _e539) {
                    phi_896_ = _e535;
                } else {
                    phi_896_ = _e539;
                }
                let _e542 = phi_896_;
                if (_e524 > _e542) {
                    phi_901_ = _e524;
                } else {
                    phi_901_ = _e542;
                }
                let _e545 = phi_901_;
                let _e546 = (_e545 + _e385);
                if (_e466 > _e506) {
                    phi_907_ = _e466;
                } else {
                    phi_907_ = _e506;
                }
                let _e549 = phi_907_;
                if (_e549 > _e546) {
                    phi_912_ = _e549;
                } else {
                    phi_912_ = _e546;
                }
                let _e552 = phi_912_;
                if (_e552 <= f64(65536f)) {
                    phi_921_ = (_e552 >= f64((1f / 65536f)));
                } else {
                    phi_921_ = false;
                }
                let _e559 = phi_921_;
                if _e559 {
                    phi_993_ = type_45();
                    phi_994_ = true;
                } else {
                    if (_e552 >= 2.2250738585072014e-308lf) {
                        if ((bitcast<u64>(_e552) & 9218868437227405312lu) != 9218868437227405312lu) {
                            let _e566 = (9214364837600034816lu - (bitcast<u64>(_e552) & 9218868437227405312lu));
                            if (_e566 > 4503599627370496lu) {
                                phi_945_ = _e566;
                            } else {
                                phi_945_ = 4503599627370496lu;
                            }
                            let _e569 = phi_945_;
                            let _e570 = bitcast<f64>(_e569);
                            let _e571 = (_e395 * _e570);
                            if (_e395 > f64(0f)) {
                                if (_e571 > 2.2250738585072014e-308lf) {
                                    phi_957_ = _e571;
                                } else {
                                    phi_957_ = 2.2250738585072014e-308lf;
                                }
                                let _e576 = phi_957_;
                                phi_958_ = _e576;
                            } else {
                                phi_958_ = _e571;
                            }
                            let _e578 = phi_958_;
                            phi_989_ = type_45(type_35(array<array<f64, 3>, 2>(array<f64, 3>((_e314 * _e570), (_e317 * _e570), (_e320 * _e570)), array<f64, 3>((_e326 * _e570), (_e329 * _e570), (_e332 * _e570))), array<array<f64, 3>, 2>(array<f64, 3>((_e339 * _e570), (_e342 * _e570), (_e345 * _e570)), array<f64, 3>((_e351 * _e570), (_e354 * _e570), (_e357 * _e570))), array<array<f64, 3>, 2>(array<f64, 3>((_e364 * _e570), (_e367 * _e570), (_e370 * _e570)), array<f64, 3>((_e376 * _e570), (_e379 * _e570), (_e382 * _e570))), (_e385 * _e570)), _e578);
                            phi_990_ = false;
                        } else {
                            phi_989_ = type_45();
                            phi_990_ = true;
                        }
                        let _e610 = phi_989_;
                        let _e612 = phi_990_;
                        phi_991_ = _e610;
                        phi_992_ = _e612;
                    } else {
                        phi_991_ = type_45();
                        phi_992_ = true;
                    }
                    let _e614 = phi_991_;
                    let _e616 = phi_992_;
                    phi_993_ = _e614;
                    phi_994_ = _e616;
                }
                let _e618 = phi_993_;
                let _e620 = phi_994_;
                if _e620 {
                    phi_999_ = type_45(type_35(array<array<f64, 3>, 2>(array<f64, 3>(_e314, _e317, _e320), array<f64, 3>(_e326, _e329, _e332)), array<array<f64, 3>, 2>(array<f64, 3>(_e339, _e342, _e345), array<f64, 3>(_e351, _e354, _e357)), array<array<f64, 3>, 2>(array<f64, 3>(_e364, _e367, _e370), array<f64, 3>(_e376, _e379, _e382)), _e385), _e395);
                } else {
                    phi_999_ = _e618;
                }
                let _e623 = phi_999_;
                local_18 = type_35(array<array<f64, 3>, 2>(array<f64, 3>(_e623.member.member[0][0], _e623.member.member[0][1], _e623.member.member[0][2]), array<f64, 3>(_e623.member.member[1][0], _e623.member.member[1][1], _e623.member.member[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e623.member.member_1[0][0], _e623.member.member_1[0][1], _e623.member.member_1[0][2]), array<f64, 3>(_e623.member.member_1[1][0], _e623.member.member_1[1][1], _e623.member.member_1[1][2])), array<array<f64, 3>, 2>(array<f64, 3>(_e623.member.member_2[0][0], _e623.member.member_2[0][1], _e623.member.member_2[0][2]), array<f64, 3>(_e623.member.member_2[1][0], _e623.member.member_2[1][1], _e623.member.member_2[1][2])), _e623.member.member_3);
                if (_e623.member_1 > f64(0f)) {
                    let _e5869 = local_18.member[0u];
                    let _e5875 = local_18.member[1u];
                    let _e5891 = local_18.member_1[0u];
                    let _e5897 = local_18.member_1[1u];
                    let _e5913 = local_18.member_2[0u];
                    let _e5919 = local_18.member_2[1u];
                    let _e5933 = function_4(array<f64, 3>((_e5869[0] + ((_e5875[0] - _e5869[0]) * _e413)), (_e5869[1] + ((_e5875[1] - _e5869[1]) * _e413)), (_e5869[2] + ((_e5875[2] - _e5869[2]) * _e413))), array<f64, 3>((_e5891[0] + ((_e5897[0] - _e5891[0]) * _e413)), (_e5891[1] + ((_e5897[1] - _e5891[1]) * _e413)), (_e5891[2] + ((_e5897[2] - _e5891[2]) * _e413))), array<f64, 3>((_e5913[0] + ((_e5919[0] - _e5913[0]) * _e413)), (_e5913[1] + ((_e5919[1] - _e5913[1]) * _e413)), (_e5913[2] + ((_e5919[2] - _e5913[2]) * _e413))), 1u);
                    let _e5944 = (((_e5933[0] * _e5933[0]) + (_e5933[1] * _e5933[1])) + (_e5933[2] * _e5933[2]));
                    if (_e5944 <= 2.2250738585072014e-308lf) {
                        if (_e5944 > 0.0lf) {
                            phi_1167_ = (1.464336215552873e-154lf * 2.0lf);
                        } else {
                            phi_1167_ = 0.0lf;
                        }
                        let _e5996 = phi_1167_;
                        phi_1231_ = _e5996;
                    } else {
                        phi_1174_ = type_16(0i, 5i);
                        phi_1177_ = bitcast<f64>(((bitcast<u64>(_e5944) / 2lu) + 2303426169912950784lu));
                        loop {
                            let _e5951 = phi_1174_;
                            let _e5953 = phi_1177_;
                            local_40 = _e5953;
                            if (_e5951.member < _e5951.member_1) {
                                let _e5960 = (_e5951.member + 1i);
                                if ((false == (_e5960 > _e5951.member)) != false) {
                                    phi_1198_ = true;
                                } else {
                                    phi_1198_ = false;
                                }
                                let _e5965 = phi_1198_;
                                if _e5965 {
                                    phi_1204_ = type_17(0u, type_17().member_1);
                                } else {
                                    phi_1204_ = type_17(1u, _e5960);
                                }
                                let _e5970 = phi_1204_;
                                phi_1175_ = type_16(_e5970.member_1, _e5951.member_1);
                                phi_1218_ = type_17(1u, _e5951.member);
                            } else {
                                phi_1175_ = _e5951;
                                phi_1218_ = type_17(0u, type_17().member_1);
                            }
                            let _e5976 = phi_1175_;
                            let _e5978 = phi_1218_;
                            let _e5981 = (bitcast<i32>(_e5978.member) != 0i);
                            if _e5981 {
                                phi_1178_ = (0.5lf * (_e5953 + (_e5944 / _e5953)));
                            } else {
                                phi_1178_ = f64();
                            }
                            let _e5986 = phi_1178_;
                            continue;
                            continuing {
                                phi_1174_ = _e5976;
                                phi_1177_ = _e5986;
                                break if !(_e5981);
                            }
                        }
                        let _e5991 = local_40;
                        phi_1231_ = (_e5991 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                    }
                    let _e5998 = phi_1231_;
                    let _e6006 = local_18.member[0u];
                    if (_e6006[0] < 0.0lf) {
                        phi_1249_ = -(_e6006[0]);
                    } else {
                        phi_1249_ = _e6006[0];
                    }
                    let _e6013 = phi_1249_;
                    if (_e6006[1] < 0.0lf) {
                        phi_1256_ = -(_e6006[1]);
                    } else {
                        phi_1256_ = _e6006[1];
                    }
                    let _e6017 = phi_1256_;
                    if (_e6013 > _e6017) {
                        phi_1261_ = _e6013;
                    } else {
                        phi_1261_ = _e6017;
                    }
                    let _e6020 = phi_1261_;
                    if (_e6006[2] < 0.0lf) {
                        phi_1268_ = -(_e6006[2]);
                    } else {
                        phi_1268_ = _e6006[2];
                    }
                    let _e6024 = phi_1268_;
                    if (_e6020 > _e6024) {
                        phi_1273_ = _e6020;
                    } else {
                        phi_1273_ = _e6024;
                    }
                    let _e6027 = phi_1273_;
                    let _e6030 = local_18.member[1u];
                    if (_e6030[0] < 0.0lf) {
                        phi_1286_ = -(_e6030[0]);
                    } else {
                        phi_1286_ = _e6030[0];
                    }
                    let _e6037 = phi_1286_;
                    if (_e6030[1] < 0.0lf) {
                        phi_1293_ = -(_e6030[1]);
                    } else {
                        phi_1293_ = _e6030[1];
                    }
                    let _e6041 = phi_1293_;
                    if (_e6037 > _e6041) {
                        phi_1298_ = _e6037;
                    } else {
                        phi_1298_ = _e6041;
                    }
                    let _e6044 = phi_1298_;
                    if (_e6030[2] < 0.0lf) {
                        phi_1305_ = -(_e6030[2]);
                    } else {
                        phi_1305_ = _e6030[2];
                    }
                    let _e6048 = phi_1305_;
                    if (_e6044 > _e6048) {
                        phi_1310_ = _e6044;
                    } else {
                        phi_1310_ = _e6048;
                    }
                    let _e6051 = phi_1310_;
                    if (_e6027 > _e6051) {
                        phi_1315_ = _e6027;
                    } else {
                        phi_1315_ = _e6051;
                    }
                    let _e6054 = phi_1315_;
                    let _e6056 = local_18.member_3;
                    let _e6060 = local_18.member_1[0u];
                    if (_e6060[0] < 0.0lf) {
                        phi_1332_ = -(_e6060[0]);
                    } else {
                        phi_1332_ = _e6060[0];
                    }
                    let _e6067 = phi_1332_;
                    if (_e6060[1] < 0.0lf) {
                        phi_1339_ = -(_e6060[1]);
                    } else {
                        phi_1339_ = _e6060[1];
                    }
                    let _e6071 = phi_1339_;
                    if (_e6067 > _e6071) {
                        phi_1344_ = _e6067;
                    } else {
                        phi_1344_ = _e6071;
                    }
                    let _e6074 = phi_1344_;
                    if (_e6060[2] < 0.0lf) {
                        phi_1351_ = -(_e6060[2]);
                    } else {
                        phi_1351_ = _e6060[2];
                    }
                    let _e6078 = phi_1351_;
                    if (_e6074 > _e6078) {
                        phi_1356_ = _e6074;
                    } else {
                        phi_1356_ = _e6078;
                    }
                    let _e6081 = phi_1356_;
                    let _e6084 = local_18.member_1[1u];
                    if (_e6084[0] < 0.0lf) {
                        phi_1370_ = -(_e6084[0]);
                    } else {
                        phi_1370_ = _e6084[0];
                    }
                    let _e6091 = phi_1370_;
                    if (_e6084[1] < 0.0lf) {
                        phi_1377_ = -(_e6084[1]);
                    } else {
                        phi_1377_ = _e6084[1];
                    }
                    let _e6095 = phi_1377_;
                    if (_e6091 > _e6095) {
                        phi_1382_ = _e6091;
                    } else {
                        phi_1382_ = _e6095;
                    }
                    let _e6098 = phi_1382_;
                    if (_e6084[2] < 0.0lf) {
                        phi_1389_ = -(_e6084[2]);
                    } else {
                        phi_1389_ = _e6084[2];
                    }
                    let _e6102 = phi_1389_;
                    if (_e6098 > _e6102) {
                        phi_1394_ = _e6098;
                    } else {
                        phi_1394_ = _e6102;
                    }
                    let _e6105 = phi_1394_;
                    if (_e6081 > _e6105) {
                        phi_1399_ = _e6081;
                    } else {
                        phi_1399_ = _e6105;
                    }
                    let _e6108 = phi_1399_;
                    let _e6110 = local_18.member_3;
                    let _e6114 = local_18.member_2[0u];
                    if (_e6114[0] < 0.0lf) {
                        phi_1416_ = -(_e6114[0]);
                    } else {
                        phi_1416_ = _e6114[0];
                    }
                    let _e6121 = phi_1416_;
                    if (_e6114[1] < 0.0lf) {
                        phi_1423_ = -(_e6114[1]);
                    } else {
                        phi_1423_ = _e6114[1];
                    }
                    let _e6125 = phi_1423_;
                    if (_e6121 > _e6125) {
                        phi_1428_ = _e6121;
                    } else {
                        phi_1428_ = _e6125;
                    }
                    let _e6128 = phi_1428_;
                    if (_e6114[2] < 0.0lf) {
                        phi_1435_ = -(_e6114[2]);
                    } else {
                        phi_1435_ = _e6114[2];
                    }
                    let _e6132 = phi_1435_;
                    if (_e6128 > _e6132) {
                        phi_1440_ = _e6128;
                    } else {
                        phi_1440_ = _e6132;
                    }
                    let _e6135 = phi_1440_;
                    let _e6138 = local_18.member_2[1u];
                    if (_e6138[0] < 0.0lf) {
                        phi_1454_ = -(_e6138[0]);
                    } else {
                        phi_1454_ = _e6138[0];
                    }
                    let _e6145 = phi_1454_;
                    if (_e6138[1] < 0.0lf) {
                        phi_1461_ = -(_e6138[1]);
                    } else {
                        phi_1461_ = _e6138[1];
                    }
                    let _e6149 = phi_1461_;
                    if (_e6145 > _e6149) {
                        phi_1466_ = _e6145;
                    } else {
                        phi_1466_ = _e6149;
                    }
                    let _e6152 = phi_1466_;
                    if (_e6138[2] < 0.0lf) {
                        phi_1473_ = -(_e6138[2]);
                    } else {
                        phi_1473_ = _e6138[2];
                    }
                    let _e6156 = phi_1473_;
                    if (_e6152 > _e6156) {
                        phi_1478_ = _e6152;
                    } else {
                        phi_1478_ = _e6156;
                    }
                    let _e6159 = phi_1478_;
                    if (_e6135 > _e6159) {
                        phi_1483_ = _e6135;
                    } else {
                        phi_1483_ = _e6159;
                    }
                    let _e6162 = phi_1483_;
                    let _e6164 = local_18.member_3;
                    let _e6172 = local_18.member_3;
                    let _e6182 = (((_e5998 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e6054 + _e6056) + (_e6108 + _e6110)) + (_e6162 + _e6164)) * (1.1102230246251565e-16lf * f64(16f))) + (_e6172 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e623.member_1);
                    if _e6182 {
                        phi_2160_ = type_47();
                        phi_2161_ = true;
                    } else {
                        let _e6185 = local_18.member_1[0u];
                        let _e6191 = local_18.member_2[0u];
                        let _e6197 = ((_e6185[1] * _e6191[2]) - (_e6185[2] * _e6191[1]));
                        let _e6200 = ((_e6185[2] * _e6191[0]) - (_e6185[0] * _e6191[2]));
                        let _e6203 = ((_e6185[0] * _e6191[1]) - (_e6185[1] * _e6191[0]));
                        let _e6206 = local_18.member_1[1u];
                        let _e6212 = local_18.member_2[1u];
                        let _e6218 = ((_e6206[1] * _e6212[2]) - (_e6206[2] * _e6212[1]));
                        let _e6221 = ((_e6206[2] * _e6212[0]) - (_e6206[0] * _e6212[2]));
                        let _e6224 = ((_e6206[0] * _e6212[1]) - (_e6206[1] * _e6212[0]));
                        let _e6227 = local_18.member_1[0u];
                        let _e6233 = local_18.member_2[1u];
                        let _e6248 = local_18.member_1[1u];
                        let _e6254 = local_18.member_2[0u];
                        let _e6267 = (((_e6227[1] * _e6233[2]) - (_e6227[2] * _e6233[1])) + ((_e6248[1] * _e6254[2]) - (_e6248[2] * _e6254[1])));
                        let _e6268 = (((_e6227[2] * _e6233[0]) - (_e6227[0] * _e6233[2])) + ((_e6248[2] * _e6254[0]) - (_e6248[0] * _e6254[2])));
                        let _e6269 = (((_e6227[0] * _e6233[1]) - (_e6227[1] * _e6233[0])) + ((_e6248[0] * _e6254[1]) - (_e6248[1] * _e6254[0])));
                        let _e6272 = local_18.member[0u];
                        let _e6283 = local_18.member[1u];
                        let _e6294 = local_18.member[0u];
                        let _e6303 = ((((_e6283[0] * _e6197) + (_e6283[1] * _e6200)) + (_e6283[2] * _e6203)) + (((_e6294[0] * _e6267) + (_e6294[1] * _e6268)) + (_e6294[2] * _e6269)));
                        let _e6306 = local_18.member[0u];
                        let _e6317 = local_18.member[1u];
                        let _e6326 = ((((_e6306[0] * _e6218) + (_e6306[1] * _e6221)) + (_e6306[2] * _e6224)) + (((_e6317[0] * _e6267) + (_e6317[1] * _e6268)) + (_e6317[2] * _e6269)));
                        let _e6329 = local_18.member[1u];
                        let _e6340 = local_18.member[0u];
                        if (_e6340[0] < 0.0lf) {
                            phi_1748_ = -(_e6340[0]);
                        } else {
                            phi_1748_ = _e6340[0];
                        }
                        let _e6347 = phi_1748_;
                        if (_e6340[1] < 0.0lf) {
                            phi_1755_ = -(_e6340[1]);
                        } else {
                            phi_1755_ = _e6340[1];
                        }
                        let _e6351 = phi_1755_;
                        if (_e6347 > _e6351) {
                            phi_1760_ = _e6347;
                        } else {
                            phi_1760_ = _e6351;
                        }
                        let _e6354 = phi_1760_;
                        if (_e6340[2] < 0.0lf) {
                            phi_1767_ = -(_e6340[2]);
                        } else {
                            phi_1767_ = _e6340[2];
                        }
                        let _e6358 = phi_1767_;
                        if (_e6354 > _e6358) {
                            phi_1772_ = _e6354;
                        } else {
                            phi_1772_ = _e6358;
                        }
                        let _e6361 = phi_1772_;
                        let _e6364 = local_18.member[1u];
                        if (_e6364[0] < 0.0lf) {
                            phi_1785_ = -(_e6364[0]);
                        } else {
                            phi_1785_ = _e6364[0];
                        }
                        let _e6371 = phi_1785_;
                        if (_e6364[1] < 0.0lf) {
                            phi_1792_ = -(_e6364[1]);
                        } else {
                            phi_1792_ = _e6364[1];
                        }
                        let _e6375 = phi_1792_;
                        if (_e6371 > _e6375) {
                            phi_1797_ = _e6371;
                        } else {
                            phi_1797_ = _e6375;
                        }
                        let _e6378 = phi_1797_;
                        if (_e6364[2] < 0.0lf) {
                            phi_1804_ = -(_e6364[2]);
                        } else {
                            phi_1804_ = _e6364[2];
                        }
                        let _e6382 = phi_1804_;
                        if (_e6378 > _e6382) {
                            phi_1809_ = _e6378;
                        } else {
                            phi_1809_ = _e6382;
                        }
                        let _e6385 = phi_1809_;
                        if (_e6361 > _e6385) {
                            phi_1814_ = _e6361;
                        } else {
                            phi_1814_ = _e6385;
                        }
                        let _e6388 = phi_1814_;
                        let _e6390 = local_18.member_3;
                        let _e6391 = (_e6388 + _e6390);
                        let _e6394 = local_18.member_1[0u];
                        if (_e6394[0] < 0.0lf) {
                            phi_1831_ = -(_e6394[0]);
                        } else {
                            phi_1831_ = _e6394[0];
                        }
                        let _e6401 = phi_1831_;
                        if (_e6394[1] < 0.0lf) {
                            phi_1838_ = -(_e6394[1]);
                        } else {
                            phi_1838_ = _e6394[1];
                        }
                        let _e6405 = phi_1838_;
                        if (_e6401 > _e6405) {
                            phi_1843_ = _e6401;
                        } else {
                            phi_1843_ = _e6405;
                        }
                        let _e6408 = phi_1843_;
                        if (_e6394[2] < 0.0lf) {
                            phi_1850_ = -(_e6394[2]);
                        } else {
                            phi_1850_ = _e6394[2];
                        }
                        let _e6412 = phi_1850_;
                        if (_e6408 > _e6412) {
                            phi_1855_ = _e6408;
                        } else {
                            phi_1855_ = _e6412;
                        }
                        let _e6415 = phi_1855_;
                        let _e6418 = local_18.member_1[1u];
                        if (_e6418[0] < 0.0lf) {
                            phi_1869_ = -(_e6418[0]);
                        } else {
                            phi_1869_ = _e6418[0];
                        }
                        let _e6425 = phi_1869_;
                        if (_e6418[1] < 0.0lf) {
                            phi_1876_ = -(_e6418[1]);
                        } else {
                            phi_1876_ = _e6418[1];
                        }
                        let _e6429 = phi_1876_;
                        if (_e6425 > _e6429) {
                            phi_1881_ = _e6425;
                        } else {
                            phi_1881_ = _e6429;
                        }
                        let _e6432 = phi_1881_;
                        if (_e6418[2] < 0.0lf) {
                            phi_1888_ = -(_e6418[2]);
                        } else {
                            phi_1888_ = _e6418[2];
                        }
                        let _e6436 = phi_1888_;
                        if (_e6432 > _e6436) {
                            phi_1893_ = _e6432;
                        } else {
                            phi_1893_ = _e6436;
                        }
                        let _e6439 = phi_1893_;
                        if (_e6415 > _e6439) {
                            phi_1898_ = _e6415;
                        } else {
                            phi_1898_ = _e6439;
                        }
                        let _e6442 = phi_1898_;
                        let _e6444 = local_18.member_3;
                        let _e6445 = (_e6442 + _e6444);
                        let _e6448 = local_18.member_2[0u];
                        if (_e6448[0] < 0.0lf) {
                            phi_1915_ = -(_e6448[0]);
                        } else {
                            phi_1915_ = _e6448[0];
                        }
                        let _e6455 = phi_1915_;
                        if (_e6448[1] < 0.0lf) {
                            phi_1922_ = -(_e6448[1]);
                        } else {
                            phi_1922_ = _e6448[1];
                        }
                        let _e6459 = phi_1922_;
                        if (_e6455 > _e6459) {
                            phi_1927_ = _e6455;
                        } else {
                            phi_1927_ = _e6459;
                        }
                        let _e6462 = phi_1927_;
                        if (_e6448[2] < 0.0lf) {
                            phi_1934_ = -(_e6448[2]);
                        } else {
                            phi_1934_ = _e6448[2];
                        }
                        let _e6466 = phi_1934_;
                        if (_e6462 > _e6466) {
                            phi_1939_ = _e6462;
                        } else {
                            phi_1939_ = _e6466;
                        }
                        let _e6469 = phi_1939_;
                        let _e6472 = local_18.member_2[1u];
                        if (_e6472[0] < 0.0lf) {
                            phi_1953_ = -(_e6472[0]);
                        } else {
                            phi_1953_ = _e6472[0];
                        }
                        let _e6479 = phi_1953_;
                        if (_e6472[1] < 0.0lf) {
                            phi_1960_ = -(_e6472[1]);
                        } else {
                            phi_1960_ = _e6472[1];
                        }
                        let _e6483 = phi_1960_;
                        if (_e6479 > _e6483) {
                            phi_1965_ = _e6479;
                        } else {
                            phi_1965_ = _e6483;
                        }
                        let _e6486 = phi_1965_;
                        if (_e6472[2] < 0.0lf) {
                            phi_1972_ = -(_e6472[2]);
                        } else {
                            phi_1972_ = _e6472[2];
                        }
                        let _e6490 = phi_1972_;
                        if (_e6486 > _e6490) {
                            phi_1977_ = _e6486;
                        } else {
                            phi_1977_ = _e6490;
                        }
                        let _e6493 = phi_1977_;
                        if (_e6469 > _e6493) {
                            phi_1982_ = _e6469;
                        } else {
                            phi_1982_ = _e6493;
                        }
                        let _e6496 = phi_1982_;
                        let _e6498 = local_18.member_3;
                        let _e6499 = (_e6496 + _e6498);
                        let _e6500 = f64(1f);
                        let _e6501 = f64(8f);
                        let _e6503 = ((_e6445 * _e6501) * _e6499);
                        let _e6511 = local_18.member_3;
                        if (_e6197 < 0.0lf) {
                            phi_2019_ = -(_e6197);
                        } else {
                            phi_2019_ = _e6197;
                        }
                        let _e6531 = phi_2019_;
                        if (_e6200 < 0.0lf) {
                            phi_2025_ = -(_e6200);
                        } else {
                            phi_2025_ = _e6200;
                        }
                        let _e6535 = phi_2025_;
                        if (_e6203 < 0.0lf) {
                            phi_2032_ = -(_e6203);
                        } else {
                            phi_2032_ = _e6203;
                        }
                        let _e6540 = phi_2032_;
                        let _e6541 = ((_e6531 + _e6535) + _e6540);
                        if (_e6218 < 0.0lf) {
                            phi_2039_ = -(_e6218);
                        } else {
                            phi_2039_ = _e6218;
                        }
                        let _e6545 = phi_2039_;
                        if (_e6221 < 0.0lf) {
                            phi_2045_ = -(_e6221);
                        } else {
                            phi_2045_ = _e6221;
                        }
                        let _e6549 = phi_2045_;
                        if (_e6224 < 0.0lf) {
                            phi_2052_ = -(_e6224);
                        } else {
                            phi_2052_ = _e6224;
                        }
                        let _e6554 = phi_2052_;
                        let _e6555 = ((_e6545 + _e6549) + _e6554);
                        if (_e6541 > _e6555) {
                            phi_2058_ = _e6541;
                        } else {
                            phi_2058_ = _e6555;
                        }
                        let _e6558 = phi_2058_;
                        if (_e6267 < 0.0lf) {
                            phi_2064_ = -(_e6267);
                        } else {
                            phi_2064_ = _e6267;
                        }
                        let _e6562 = phi_2064_;
                        if (_e6268 < 0.0lf) {
                            phi_2070_ = -(_e6268);
                        } else {
                            phi_2070_ = _e6268;
                        }
                        let _e6566 = phi_2070_;
                        if (_e6269 < 0.0lf) {
                            phi_2077_ = -(_e6269);
                        } else {
                            phi_2077_ = _e6269;
                        }
                        let _e6571 = phi_2077_;
                        let _e6573 = (((_e6562 + _e6566) + _e6571) * f64(0.5f));
                        if (_e6558 > _e6573) {
                            phi_2084_ = _e6558;
                        } else {
                            phi_2084_ = _e6573;
                        }
                        let _e6576 = phi_2084_;
                        let _e6582 = local_18.member_3;
                        let _e6597 = f64(3f);
                        let _e6598 = ((((_e6272[0] * _e6197) + (_e6272[1] * _e6200)) + (_e6272[2] * _e6203)) * _e6597);
                        let _e6599 = ((((_e6329[0] * _e6218) + (_e6329[1] * _e6221)) + (_e6329[2] * _e6224)) * _e6597);
                        if (_e6598 < _e6599) {
                            phi_2112_ = _e6598;
                        } else {
                            phi_2112_ = _e6599;
                        }
                        let _e6602 = phi_2112_;
                        if (_e6303 < _e6326) {
                            phi_2117_ = _e6303;
                        } else {
                            phi_2117_ = _e6326;
                        }
                        let _e6605 = phi_2117_;
                        if (_e6602 < _e6605) {
                            phi_2122_ = _e6602;
                        } else {
                            phi_2122_ = _e6605;
                        }
                        let _e6608 = phi_2122_;
                        if (_e6598 > _e6599) {
                            phi_2127_ = _e6598;
                        } else {
                            phi_2127_ = _e6599;
                        }
                        let _e6611 = phi_2127_;
                        if (_e6303 > _e6326) {
                            phi_2132_ = _e6303;
                        } else {
                            phi_2132_ = _e6326;
                        }
                        let _e6614 = phi_2132_;
                        if (_e6611 > _e6614) {
                            phi_2137_ = _e6611;
                        } else {
                            phi_2137_ = _e6614;
                        }
                        let _e6617 = phi_2137_;
                        let _e6623 = -(_e6617);
                        if (_e6608 > _e6623) {
                            phi_2148_ = _e6608;
                        } else {
                            phi_2148_ = _e6623;
                        }
                        let _e6626 = phi_2148_;
                        if ((_e6626 - ((((((_e6391 * _e6501) * _e6503) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e6511 * f64(19f)) * ((_e6391 * (_e6445 + _e6499)) + (_e6445 * _e6499)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e6500 + _e6391) * ((_e6500 + _e6445) * (_e6500 + _e6499))))) + ((_e623.member_1 * (((_e6576 + (_e6503 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e6582 * f64(6f)) * (_e6445 + _e6499))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e6500 + _e6445) * (_e6500 + _e6499))))) * f64((3f * 1.0001f))))) > f64(0f)) {
                            phi_2158_ = type_47(type_46(0u, f64()), 0u);
                            phi_2159_ = false;
                        } else {
                            phi_2158_ = type_47();
                            phi_2159_ = true;
                        }
                        let _e6633 = phi_2158_;
                        let _e6635 = phi_2159_;
                        phi_2160_ = _e6633;
                        phi_2161_ = _e6635;
                    }
                    let _e6637 = phi_2160_;
                    let _e6639 = phi_2161_;
                    if _e6639 {
                        phi_2167_ = type_16(0i, 2i);
                        phi_2170_ = _e413;
                        phi_2172_ = 0u;
                        phi_2174_ = _e413;
                        loop {
                            let _e6641 = phi_2167_;
                            let _e6643 = phi_2170_;
                            let _e6645 = phi_2172_;
                            let _e6647 = phi_2174_;
                            local_99 = _e6645;
                            local_102 = _e6643;
                            local_103 = _e6645;
                            if (_e6641.member < _e6641.member_1) {
                                let _e6654 = (_e6641.member + 1i);
                                if ((false == (_e6654 > _e6641.member)) != false) {
                                    phi_2195_ = true;
                                } else {
                                    phi_2195_ = false;
                                }
                                let _e6659 = phi_2195_;
                                if _e6659 {
                                    phi_2201_ = type_17(0u, type_17().member_1);
                                } else {
                                    phi_2201_ = type_17(1u, _e6654);
                                }
                                let _e6664 = phi_2201_;
                                phi_2168_ = type_16(_e6664.member_1, _e6641.member_1);
                                phi_2215_ = type_17(1u, _e6641.member);
                            } else {
                                phi_2168_ = _e6641;
                                phi_2215_ = type_17(0u, type_17().member_1);
                            }
                            let _e6670 = phi_2168_;
                            let _e6672 = phi_2215_;
                            if (bitcast<i32>(_e6672.member) != 0i) {
                                if (_e6672.member_1 > 0i) {
                                    phi_2231_ = true;
                                } else {
                                    if _e6182 {
                                        phi_2230_ = false;
                                    } else {
                                        phi_2230_ = true;
                                    }
                                    let _e6679 = phi_2230_;
                                    phi_2231_ = _e6679;
                                }
                                let _e6681 = phi_2231_;
                                if _e6681 {
                                    let _e6684 = local_18.member[0u];
                                    let _e6690 = local_18.member_1[0u];
                                    let _e6696 = local_18.member_2[0u];
                                    let _e6700 = (_e6684[0] - _e6690[0]);
                                    let _e6701 = (_e6684[1] - _e6690[1]);
                                    let _e6702 = (_e6684[2] - _e6690[2]);
                                    let _e6711 = local_18.member[1u];
                                    let _e6717 = local_18.member_1[1u];
                                    let _e6723 = local_18.member_2[1u];
                                    let _e6727 = (_e6711[0] - _e6717[0]);
                                    let _e6728 = (_e6711[1] - _e6717[1]);
                                    let _e6729 = (_e6711[2] - _e6717[2]);
                                    let _e6738 = local_18.member[0u];
                                    if (_e6738[0] < 0.0lf) {
                                        phi_2377_ = -(_e6738[0]);
                                    } else {
                                        phi_2377_ = _e6738[0];
                                    }
                                    let _e6745 = phi_2377_;
                                    if (_e6738[1] < 0.0lf) {
                                        phi_2384_ = -(_e6738[1]);
                                    } else {
                                        phi_2384_ = _e6738[1];
                                    }
                                    let _e6749 = phi_2384_;
                                    if (_e6745 > _e6749) {
                                        phi_2389_ = _e6745;
                                    } else {
                                        phi_2389_ = _e6749;
                                    }
                                    let _e6752 = phi_2389_;
                                    if (_e6738[2] < 0.0lf) {
                                        phi_2396_ = -(_e6738[2]);
                                    } else {
                                        phi_2396_ = _e6738[2];
                                    }
                                    let _e6756 = phi_2396_;
                                    if (_e6752 > _e6756) {
                                        phi_2401_ = _e6752;
                                    } else {
                                        phi_2401_ = _e6756;
                                    }
                                    let _e6759 = phi_2401_;
                                    let _e6762 = local_18.member[1u];
                                    if (_e6762[0] < 0.0lf) {
                                        phi_2414_ = -(_e6762[0]);
                                    } else {
                                        phi_2414_ = _e6762[0];
                                    }
                                    let _e6769 = phi_2414_;
                                    if (_e6762[1] < 0.0lf) {
                                        phi_2421_ = -(_e6762[1]);
                                    } else {
                                        phi_2421_ = _e6762[1];
                                    }
                                    let _e6773 = phi_2421_;
                                    if (_e6769 > _e6773) {
                                        phi_2426_ = _e6769;
                                    } else {
                                        phi_2426_ = _e6773;
                                    }
                                    let _e6776 = phi_2426_;
                                    if (_e6762[2] < 0.0lf) {
                                        phi_2433_ = -(_e6762[2]);
                                    } else {
                                        phi_2433_ = _e6762[2];
                                    }
                                    let _e6780 = phi_2433_;
                                    if (_e6776 > _e6780) {
                                        phi_2438_ = _e6776;
                                    } else {
                                        phi_2438_ = _e6780;
                                    }
                                    let _e6783 = phi_2438_;
                                    if (_e6759 > _e6783) {
                                        phi_2443_ = _e6759;
                                    } else {
                                        phi_2443_ = _e6783;
                                    }
                                    let _e6786 = phi_2443_;
                                    let _e6788 = local_18.member_3;
                                    let _e6792 = local_18.member_1[0u];
                                    if (_e6792[0] < 0.0lf) {
                                        phi_2460_ = -(_e6792[0]);
                                    } else {
                                        phi_2460_ = _e6792[0];
                                    }
                                    let _e6799 = phi_2460_;
                                    if (_e6792[1] < 0.0lf) {
                                        phi_2467_ = -(_e6792[1]);
                                    } else {
                                        phi_2467_ = _e6792[1];
                                    }
                                    let _e6803 = phi_2467_;
                                    if (_e6799 > _e6803) {
                                        phi_2472_ = _e6799;
                                    } else {
                                        phi_2472_ = _e6803;
                                    }
                                    let _e6806 = phi_2472_;
                                    if (_e6792[2] < 0.0lf) {
                                        phi_2479_ = -(_e6792[2]);
                                    } else {
                                        phi_2479_ = _e6792[2];
                                    }
                                    let _e6810 = phi_2479_;
                                    if (_e6806 > _e6810) {
                                        phi_2484_ = _e6806;
                                    } else {
                                        phi_2484_ = _e6810;
                                    }
                                    let _e6813 = phi_2484_;
                                    let _e6816 = local_18.member_1[1u];
                                    if (_e6816[0] < 0.0lf) {
                                        phi_2498_ = -(_e6816[0]);
                                    } else {
                                        phi_2498_ = _e6816[0];
                                    }
                                    let _e6823 = phi_2498_;
                                    if (_e6816[1] < 0.0lf) {
                                        phi_2505_ = -(_e6816[1]);
                                    } else {
                                        phi_2505_ = _e6816[1];
                                    }
                                    let _e6827 = phi_2505_;
                                    if (_e6823 > _e6827) {
                                        phi_2510_ = _e6823;
                                    } else {
                                        phi_2510_ = _e6827;
                                    }
                                    let _e6830 = phi_2510_;
                                    if (_e6816[2] < 0.0lf) {
                                        phi_2517_ = -(_e6816[2]);
                                    } else {
                                        phi_2517_ = _e6816[2];
                                    }
                                    let _e6834 = phi_2517_;
                                    if (_e6830 > _e6834) {
                                        phi_2522_ = _e6830;
                                    } else {
                                        phi_2522_ = _e6834;
                                    }
                                    let _e6837 = phi_2522_;
                                    if (_e6813 > _e6837) {
                                        phi_2527_ = _e6813;
                                    } else {
                                        phi_2527_ = _e6837;
                                    }
                                    let _e6840 = phi_2527_;
                                    let _e6842 = local_18.member_3;
                                    let _e6846 = local_18.member_2[0u];
                                    if (_e6846[0] < 0.0lf) {
                                        phi_2544_ = -(_e6846[0]);
                                    } else {
                                        phi_2544_ = _e6846[0];
                                    }
                                    let _e6853 = phi_2544_;
                                    if (_e6846[1] < 0.0lf) {
                                        phi_2551_ = -(_e6846[1]);
                                    } else {
                                        phi_2551_ = _e6846[1];
                                    }
                                    let _e6857 = phi_2551_;
                                    if (_e6853 > _e6857) {
                                        phi_2556_ = _e6853;
                                    } else {
                                        phi_2556_ = _e6857;
                                    }
                                    let _e6860 = phi_2556_;
                                    if (_e6846[2] < 0.0lf) {
                                        phi_2563_ = -(_e6846[2]);
                                    } else {
                                        phi_2563_ = _e6846[2];
                                    }
                                    let _e6864 = phi_2563_;
                                    if (_e6860 > _e6864) {
                                        phi_2568_ = _e6860;
                                    } else {
                                        phi_2568_ = _e6864;
                                    }
                                    let _e6867 = phi_2568_;
                                    let _e6870 = local_18.member_2[1u];
                                    if (_e6870[0] < 0.0lf) {
                                        phi_2582_ = -(_e6870[0]);
                                    } else {
                                        phi_2582_ = _e6870[0];
                                    }
                                    let _e6877 = phi_2582_;
                                    if (_e6870[1] < 0.0lf) {
                                        phi_2589_ = -(_e6870[1]);
                                    } else {
                                        phi_2589_ = _e6870[1];
                                    }
                                    let _e6881 = phi_2589_;
                                    if (_e6877 > _e6881) {
                                        phi_2594_ = _e6877;
                                    } else {
                                        phi_2594_ = _e6881;
                                    }
                                    let _e6884 = phi_2594_;
                                    if (_e6870[2] < 0.0lf) {
                                        phi_2601_ = -(_e6870[2]);
                                    } else {
                                        phi_2601_ = _e6870[2];
                                    }
                                    let _e6888 = phi_2601_;
                                    if (_e6884 > _e6888) {
                                        phi_2606_ = _e6884;
                                    } else {
                                        phi_2606_ = _e6888;
                                    }
                                    let _e6891 = phi_2606_;
                                    if (_e6867 > _e6891) {
                                        phi_2611_ = _e6867;
                                    } else {
                                        phi_2611_ = _e6891;
                                    }
                                    let _e6894 = phi_2611_;
                                    let _e6896 = local_18.member_3;
                                    let _e6904 = local_18.member_3;
                                    let _e6912 = (_e404 * f64(0.00390625f));
                                    let _e6913 = f64(0f);
                                    let _e6914 = f64(1f);
                                    local_16 = type_38(array<f64, 4>(_e6913, _e6913, _e6913, _e6913), array<f64, 4>(_e6913, _e6913, _e6913, _e6913), array<f64, 4>(_e6914, _e6914, _e6914, _e6914));
                                    phi_2658_ = type_12(0u, 96u);
                                    phi_2661_ = _e6647;
                                    phi_2663_ = _e6647;
                                    phi_2665_ = (_e422 - _e6647);
                                    phi_2667_ = _e6647;
                                    phi_2669_ = false;
                                    phi_2671_ = 0u;
                                    loop {
                                        let _e6921 = phi_2658_;
                                        let _e6923 = phi_2661_;
                                        let _e6925 = phi_2663_;
                                        let _e6927 = phi_2665_;
                                        let _e6929 = phi_2667_;
                                        let _e6931 = phi_2669_;
                                        let _e6933 = phi_2671_;
                                        local_44 = _e6923;
                                        local_89 = _e6925;
                                        if (_e6921.member < _e6921.member_1) {
                                            phi_2659_ = type_12((_e6921.member + 1u), _e6921.member_1);
                                            phi_2694_ = type_12(1u, _e6921.member);
                                        } else {
                                            phi_2659_ = _e6921;
                                            phi_2694_ = type_12(0u, type_12().member_1);
                                        }
                                        let _e6945 = phi_2659_;
                                        let _e6947 = phi_2694_;
                                        if (bitcast<i32>(_e6947.member) != 0i) {
                                            let _e6953 = local_18.member[0u];
                                            let _e6959 = local_18.member[1u];
                                            let _e6975 = local_18.member_1[0u];
                                            let _e6981 = local_18.member_1[1u];
                                            let _e6997 = local_18.member_2[0u];
                                            let _e7003 = local_18.member_2[1u];
                                            let _e7017 = function_4(array<f64, 3>((_e6953[0] + ((_e6959[0] - _e6953[0]) * _e6923)), (_e6953[1] + ((_e6959[1] - _e6953[1]) * _e6923)), (_e6953[2] + ((_e6959[2] - _e6953[2]) * _e6923))), array<f64, 3>((_e6975[0] + ((_e6981[0] - _e6975[0]) * _e6923)), (_e6975[1] + ((_e6981[1] - _e6975[1]) * _e6923)), (_e6975[2] + ((_e6981[2] - _e6975[2]) * _e6923))), array<f64, 3>((_e6997[0] + ((_e7003[0] - _e6997[0]) * _e6923)), (_e6997[1] + ((_e7003[1] - _e6997[1]) * _e6923)), (_e6997[2] + ((_e7003[2] - _e6997[2]) * _e6923))), 1u);
                                            if (_e6933 == 0u) {
                                                phi_2823_ = _e7017;
                                            } else {
                                                let _e7019 = f64(0f);
                                                if (_e6933 == 1u) {
                                                    phi_2809_ = _e7017[0];
                                                } else {
                                                    phi_2809_ = _e7019;
                                                }
                                                let _e7023 = phi_2809_;
                                                if (_e6933 == 2u) {
                                                    phi_2815_ = _e7017[1];
                                                } else {
                                                    phi_2815_ = _e7019;
                                                }
                                                let _e7027 = phi_2815_;
                                                if (_e6933 == 3u) {
                                                    phi_2821_ = _e7017[2];
                                                } else {
                                                    phi_2821_ = _e7019;
                                                }
                                                let _e7031 = phi_2821_;
                                                phi_2823_ = array<f64, 3>(_e7023, _e7027, _e7031);
                                            }
                                            let _e7034 = phi_2823_;
                                            if (_e7034[0] < 0.0lf) {
                                                phi_2830_ = -(_e7034[0]);
                                            } else {
                                                phi_2830_ = _e7034[0];
                                            }
                                            let _e7039 = phi_2830_;
                                            if (_e7034[1] < 0.0lf) {
                                                phi_2837_ = -(_e7034[1]);
                                            } else {
                                                phi_2837_ = _e7034[1];
                                            }
                                            let _e7044 = phi_2837_;
                                            if (_e7034[2] < 0.0lf) {
                                                phi_2845_ = -(_e7034[2]);
                                            } else {
                                                phi_2845_ = _e7034[2];
                                            }
                                            let _e7050 = phi_2845_;
                                            let _e7051 = ((_e7039 + _e7044) + _e7050);
                                            if (_e7051 > f64(0f)) {
                                                if ((bitcast<u64>(_e7051) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                    let _e7058 = (f64(1f) / _e7051);
                                                    let _e7060 = (_e7034[0] * _e7058);
                                                    let _e7062 = (_e7034[1] * _e7058);
                                                    let _e7064 = (_e7034[2] * _e7058);
                                                    let _e7069 = (((_e7060 * _e7060) + (_e7062 * _e7062)) + (_e7064 * _e7064));
                                                    if (_e7069 <= 2.2250738585072014e-308lf) {
                                                        if (_e7069 > 0.0lf) {
                                                            phi_2884_ = (1.464336215552873e-154lf * 2.0lf);
                                                        } else {
                                                            phi_2884_ = 0.0lf;
                                                        }
                                                        let _e7121 = phi_2884_;
                                                        phi_2948_ = _e7121;
                                                    } else {
                                                        phi_2891_ = type_16(0i, 5i);
                                                        phi_2894_ = bitcast<f64>(((bitcast<u64>(_e7069) / 2lu) + 2303426169912950784lu));
                                                        loop {
                                                            let _e7076 = phi_2891_;
                                                            let _e7078 = phi_2894_;
                                                            local_41 = _e7078;
                                                            if (_e7076.member < _e7076.member_1) {
                                                                let _e7085 = (_e7076.member + 1i);
                                                                if ((false == (_e7085 > _e7076.member)) != false) {
                                                                    phi_2915_ = true;
                                                                } else {
                                                                    phi_2915_ = false;
                                                                }
                                                                let _e7090 = phi_2915_;
                                                                if _e7090 {
                                                                    phi_2921_ = type_17(0u, type_17().member_1);
                                                                } else {
                                                                    phi_2921_ = type_17(1u, _e7085);
                                                                }
                                                                let _e7095 = phi_2921_;
                                                                phi_2892_ = type_16(_e7095.member_1, _e7076.member_1);
                                                                phi_2935_ = type_17(1u, _e7076.member);
                                                            } else {
                                                                phi_2892_ = _e7076;
                                                                phi_2935_ = type_17(0u, type_17().member_1);
                                                            }
                                                            let _e7101 = phi_2892_;
                                                            let _e7103 = phi_2935_;
                                                            let _e7106 = (bitcast<i32>(_e7103.member) != 0i);
                                                            if _e7106 {
                                                                phi_2895_ = (0.5lf * (_e7078 + (_e7069 / _e7078)));
                                                            } else {
                                                                phi_2895_ = f64();
                                                            }
                                                            let _e7111 = phi_2895_;
                                                            continue;
                                                            continuing {
                                                                phi_2891_ = _e7101;
                                                                phi_2894_ = _e7111;
                                                                break if !(_e7106);
                                                            }
                                                        }
                                                        let _e7116 = local_41;
                                                        phi_2948_ = (_e7116 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                    }
                                                    let _e7123 = phi_2948_;
                                                    let _e7125 = (1.1102230246251565e-16lf * f64(12f));
                                                    let _e7132 = ((((((((_e6786 + _e6788) + (_e6840 + _e6842)) + (_e6894 + _e6896)) * (1.1102230246251565e-16lf * f64(16f))) + (_e6904 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e623.member_1 * _e7123) * (f64(1f) + _e7125)));
                                                    let _e7137 = (((_e7060 * _e6684[0]) + (_e7062 * _e6684[1])) + (_e7064 * _e6684[2]));
                                                    let _e7142 = (((_e7060 * _e6700) + (_e7062 * _e6701)) + (_e7064 * _e6702));
                                                    let _e7147 = (((_e7060 * (_e6684[0] - _e6696[0])) + (_e7062 * (_e6684[1] - _e6696[1]))) + (_e7064 * (_e6684[2] - _e6696[2])));
                                                    let _e7152 = (((_e7060 * (_e6700 - _e6696[0])) + (_e7062 * (_e6701 - _e6696[1]))) + (_e7064 * (_e6702 - _e6696[2])));
                                                    let _e7158 = (((_e7060 * _e6711[0]) + (_e7062 * _e6711[1])) + (_e7064 * _e6711[2]));
                                                    let _e7163 = (((_e7060 * _e6727) + (_e7062 * _e6728)) + (_e7064 * _e6729));
                                                    let _e7168 = (((_e7060 * (_e6711[0] - _e6723[0])) + (_e7062 * (_e6711[1] - _e6723[1]))) + (_e7064 * (_e6711[2] - _e6723[2])));
                                                    let _e7173 = (((_e7060 * (_e6727 - _e6723[0])) + (_e7062 * (_e6728 - _e6723[1]))) + (_e7064 * (_e6729 - _e6723[2])));
                                                    if (_e7137 < 0.0lf) {
                                                        phi_3017_ = -(_e7137);
                                                    } else {
                                                        phi_3017_ = _e7137;
                                                    }
                                                    let _e7178 = phi_3017_;
                                                    if (_e7158 < 0.0lf) {
                                                        phi_3023_ = -(_e7158);
                                                    } else {
                                                        phi_3023_ = _e7158;
                                                    }
                                                    let _e7182 = phi_3023_;
                                                    if (_e7142 < 0.0lf) {
                                                        phi_3032_ = -(_e7142);
                                                    } else {
                                                        phi_3032_ = _e7142;
                                                    }
                                                    let _e7189 = phi_3032_;
                                                    if (_e7163 < 0.0lf) {
                                                        phi_3038_ = -(_e7163);
                                                    } else {
                                                        phi_3038_ = _e7163;
                                                    }
                                                    let _e7193 = phi_3038_;
                                                    if (_e7147 < 0.0lf) {
                                                        phi_3047_ = -(_e7147);
                                                    } else {
                                                        phi_3047_ = _e7147;
                                                    }
                                                    let _e7200 = phi_3047_;
                                                    if (_e7168 < 0.0lf) {
                                                        phi_3053_ = -(_e7168);
                                                    } else {
                                                        phi_3053_ = _e7168;
                                                    }
                                                    let _e7204 = phi_3053_;
                                                    if (_e7152 < 0.0lf) {
                                                        phi_3062_ = -(_e7152);
                                                    } else {
                                                        phi_3062_ = _e7152;
                                                    }
                                                    let _e7211 = phi_3062_;
                                                    if (_e7173 < 0.0lf) {
                                                        phi_3068_ = -(_e7173);
                                                    } else {
                                                        phi_3068_ = _e7173;
                                                    }
                                                    let _e7215 = phi_3068_;
                                                    phi_3074_ = type_38(array<f64, 4>(_e7137, _e7142, _e7147, _e7152), array<f64, 4>(_e7158, _e7163, _e7168, _e7173), array<f64, 4>((_e7132 + ((_e7178 + _e7182) * _e7125)), (_e7132 + ((_e7189 + _e7193) * _e7125)), (_e7132 + ((_e7200 + _e7204) * _e7125)), (_e7132 + ((_e7211 + _e7215) * _e7125))));
                                                    phi_3075_ = false;
                                                } else {
                                                    phi_3074_ = type_38();
                                                    phi_3075_ = true;
                                                }
                                                let _e7222 = phi_3074_;
                                                let _e7224 = phi_3075_;
                                                phi_3076_ = _e7222;
                                                phi_3077_ = _e7224;
                                            } else {
                                                phi_3076_ = type_38();
                                                phi_3077_ = true;
                                            }
                                            let _e7226 = phi_3076_;
                                            let _e7228 = phi_3077_;
                                            if _e7228 {
                                                let _e7229 = f64(0f);
                                                let _e7230 = f64(1f);
                                                phi_3087_ = type_38(array<f64, 4>(_e7229, _e7229, _e7229, _e7229), array<f64, 4>(_e7229, _e7229, _e7229, _e7229), array<f64, 4>(_e7230, _e7230, _e7230, _e7230));
                                            } else {
                                                phi_3087_ = _e7226;
                                            }
                                            let _e7236 = phi_3087_;
                                            local_17 = type_38(array<f64, 4>(_e7236.member[0], _e7236.member[1], _e7236.member[2], _e7236.member[3]), array<f64, 4>(_e7236.member_1[0], _e7236.member_1[1], _e7236.member_1[2], _e7236.member_1[3]), array<f64, 4>(_e7236.member_2[0], _e7236.member_2[1], _e7236.member_2[2], _e7236.member_2[3]));
                                            let _e7256 = (_e6923 - _e6929);
                                            let _e7258 = f64(0f);
                                            let _e7261 = local_17.member[0u];
                                            let _e7264 = local_17.member_1[0u];
                                            let _e7267 = local_17.member[0u];
                                            let _e7273 = local_17.member_2[0u];
                                            if (((_e7261 + ((_e7264 - _e7267) * _e6923)) - _e7273) > _e7258) {
                                                let _e7278 = local_17.member[1u];
                                                let _e7281 = local_17.member_1[1u];
                                                let _e7284 = local_17.member[1u];
                                                let _e7290 = local_17.member_2[1u];
                                                if (((_e7278 + ((_e7281 - _e7284) * _e6923)) - _e7290) > _e7258) {
                                                    let _e7295 = local_17.member[2u];
                                                    let _e7298 = local_17.member_1[2u];
                                                    let _e7301 = local_17.member[2u];
                                                    let _e7307 = local_17.member_2[2u];
                                                    if (((_e7295 + ((_e7298 - _e7301) * _e6923)) - _e7307) > _e7258) {
                                                        let _e7312 = local_17.member[3u];
                                                        let _e7315 = local_17.member_1[3u];
                                                        let _e7318 = local_17.member[3u];
                                                        let _e7324 = local_17.member_2[3u];
                                                        phi_3259_ = (((_e7312 + ((_e7315 - _e7318) * _e6923)) - _e7324) > _e7258);
                                                        phi_3260_ = false;
                                                    } else {
                                                        phi_3259_ = bool();
                                                        phi_3260_ = true;
                                                    }
                                                    let _e7328 = phi_3259_;
                                                    let _e7330 = phi_3260_;
                                                    phi_3261_ = _e7328;
                                                    phi_3262_ = _e7330;
                                                } else {
                                                    phi_3261_ = bool();
                                                    phi_3262_ = true;
                                                }
                                                let _e7332 = phi_3261_;
                                                let _e7334 = phi_3262_;
                                                phi_3263_ = _e7332;
                                                phi_3264_ = _e7334;
                                            } else {
                                                phi_3263_ = bool();
                                                phi_3264_ = true;
                                            }
                                            let _e7336 = phi_3263_;
                                            let _e7338 = phi_3264_;
                                            if _e7338 {
                                                phi_3268_ = false;
                                            } else {
                                                phi_3268_ = _e7336;
                                            }
                                            let _e7340 = phi_3268_;
                                            if _e7340 {
                                                if (_e6923 <= _e6925) {
                                                    phi_3579_ = true;
                                                } else {
                                                    let _e7342 = f64(0f);
                                                    let _e7345 = local_16.member[0u];
                                                    let _e7348 = local_16.member_1[0u];
                                                    let _e7351 = local_16.member[0u];
                                                    let _e7357 = local_16.member_2[0u];
                                                    let _e7361 = local_17.member[0u];
                                                    let _e7364 = local_17.member_1[0u];
                                                    let _e7367 = local_17.member[0u];
                                                    let _e7373 = local_17.member_2[0u];
                                                    if ((((_e7345 + ((_e7348 - _e7351) * _e6923)) - _e7357) + ((_e7361 + ((_e7364 - _e7367) * _e6929)) - _e7373)) > _e7342) {
                                                        let _e7379 = local_16.member[1u];
                                                        let _e7382 = local_16.member_1[1u];
                                                        let _e7385 = local_16.member[1u];
                                                        let _e7391 = local_16.member_2[1u];
                                                        let _e7395 = local_17.member[1u];
                                                        let _e7398 = local_17.member_1[1u];
                                                        let _e7401 = local_17.member[1u];
                                                        let _e7407 = local_17.member_2[1u];
                                                        if ((((_e7379 + ((_e7382 - _e7385) * _e6923)) - _e7391) + ((_e7395 + ((_e7398 - _e7401) * _e6929)) - _e7407)) > _e7342) {
                                                            let _e7413 = local_16.member[2u];
                                                            let _e7416 = local_16.member_1[2u];
                                                            let _e7419 = local_16.member[2u];
                                                            let _e7425 = local_16.member_2[2u];
                                                            let _e7429 = local_17.member[2u];
                                                            let _e7432 = local_17.member_1[2u];
                                                            let _e7435 = local_17.member[2u];
                                                            let _e7441 = local_17.member_2[2u];
                                                            if ((((_e7413 + ((_e7416 - _e7419) * _e6923)) - _e7425) + ((_e7429 + ((_e7432 - _e7435) * _e6929)) - _e7441)) > _e7342) {
                                                                let _e7447 = local_16.member[3u];
                                                                let _e7450 = local_16.member_1[3u];
                                                                let _e7453 = local_16.member[3u];
                                                                let _e7459 = local_16.member_2[3u];
                                                                let _e7463 = local_17.member[3u];
                                                                let _e7466 = local_17.member_1[3u];
                                                                let _e7469 = local_17.member[3u];
                                                                let _e7475 = local_17.member_2[3u];
                                                                phi_3566_ = ((((_e7447 + ((_e7450 - _e7453) * _e6923)) - _e7459) + ((_e7463 + ((_e7466 - _e7469) * _e6929)) - _e7475)) > _e7342);
                                                                phi_3567_ = false;
                                                            } else {
                                                                phi_3566_ = bool();
                                                                phi_3567_ = true;
                                                            }
                                                            let _e7480 = phi_3566_;
                                                            let _e7482 = phi_3567_;
                                                            phi_3568_ = _e7480;
                                                            phi_3569_ = _e7482;
                                                        } else {
                                                            phi_3568_ = bool();
                                                            phi_3569_ = true;
                                                        }
                                                        let _e7484 = phi_3568_;
                                                        let _e7486 = phi_3569_;
                                                        phi_3570_ = _e7484;
                                                        phi_3571_ = _e7486;
                                                    } else {
                                                        phi_3570_ = bool();
                                                        phi_3571_ = true;
                                                    }
                                                    let _e7488 = phi_3570_;
                                                    let _e7490 = phi_3571_;
                                                    if _e7490 {
                                                        phi_3575_ = false;
                                                    } else {
                                                        phi_3575_ = _e7488;
                                                    }
                                                    let _e7492 = phi_3575_;
                                                    phi_3579_ = _e7492;
                                                }
                                                let _e7494 = phi_3579_;
                                                if _e7494 {
                                                    if _e6931 {
                                                        if (_e6923 >= _e422) {
                                                            phi_3590_ = false;
                                                        } else {
                                                            phi_3590_ = true;
                                                        }
                                                        let _e7497 = phi_3590_;
                                                        phi_3591_ = _e7497;
                                                    } else {
                                                        phi_3591_ = true;
                                                    }
                                                    let _e7499 = phi_3591_;
                                                    if _e7499 {
                                                        local_16 = type_38(array<f64, 4>(_e7236.member[0], _e7236.member[1], _e7236.member[2], _e7236.member[3]), array<f64, 4>(_e7236.member_1[0], _e7236.member_1[1], _e7236.member_1[2], _e7236.member_1[3]), array<f64, 4>(_e7236.member_2[0], _e7236.member_2[1], _e7236.member_2[2], _e7236.member_2[3]));
                                                        let _e7521 = local_16.member[0u];
                                                        let _e7524 = local_16.member_1[0u];
                                                        let _e7527 = local_16.member_2[0u];
                                                        if (_e7521 > _e7527) {
                                                            if (_e7524 > _e7527) {
                                                                phi_3665_ = false;
                                                            } else {
                                                                phi_3665_ = true;
                                                            }
                                                            let _e7531 = phi_3665_;
                                                            phi_3666_ = _e7531;
                                                        } else {
                                                            phi_3666_ = true;
                                                        }
                                                        let _e7533 = phi_3666_;
                                                        if _e7533 {
                                                            let _e7534 = (_e7524 >= _e7521);
                                                            if _e7534 {
                                                                phi_3691_ = f64();
                                                                phi_3692_ = false;
                                                            } else {
                                                                if ((_e7521 - _e7524) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_3689_ = (((_e7521 - _e7527) / (_e7521 - _e7524)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_3690_ = false;
                                                                } else {
                                                                    phi_3689_ = f64();
                                                                    phi_3690_ = true;
                                                                }
                                                                let _e7548 = phi_3689_;
                                                                let _e7550 = phi_3690_;
                                                                phi_3691_ = _e7548;
                                                                phi_3692_ = _e7550;
                                                            }
                                                            let _e7552 = phi_3691_;
                                                            let _e7554 = phi_3692_;
                                                            phi_3693_ = _e7552;
                                                            phi_3694_ = _e7534;
                                                            phi_3695_ = _e7554;
                                                        } else {
                                                            phi_3693_ = f64();
                                                            phi_3694_ = true;
                                                            phi_3695_ = false;
                                                        }
                                                        let _e7556 = phi_3693_;
                                                        let _e7558 = phi_3694_;
                                                        let _e7560 = phi_3695_;
                                                        if _e7558 {
                                                            phi_3700_ = f64(2f);
                                                            phi_3701_ = true;
                                                        } else {
                                                            phi_3700_ = _e6923;
                                                            phi_3701_ = _e7560;
                                                        }
                                                        let _e7563 = phi_3700_;
                                                        let _e7565 = phi_3701_;
                                                        if _e7565 {
                                                            phi_3705_ = _e7563;
                                                        } else {
                                                            phi_3705_ = _e7556;
                                                        }
                                                        let _e7567 = phi_3705_;
                                                        let _e7570 = local_16.member[1u];
                                                        let _e7573 = local_16.member_1[1u];
                                                        let _e7576 = local_16.member_2[1u];
                                                        if (_e7570 > _e7576) {
                                                            if (_e7573 > _e7576) {
                                                                phi_3737_ = false;
                                                            } else {
                                                                phi_3737_ = true;
                                                            }
                                                            let _e7580 = phi_3737_;
                                                            phi_3738_ = _e7580;
                                                        } else {
                                                            phi_3738_ = true;
                                                        }
                                                        let _e7582 = phi_3738_;
                                                        if _e7582 {
                                                            let _e7583 = (_e7573 >= _e7570);
                                                            if _e7583 {
                                                                phi_3763_ = f64();
                                                                phi_3764_ = false;
                                                            } else {
                                                                if ((_e7570 - _e7573) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_3761_ = (((_e7570 - _e7576) / (_e7570 - _e7573)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_3762_ = false;
                                                                } else {
                                                                    phi_3761_ = f64();
                                                                    phi_3762_ = true;
                                                                }
                                                                let _e7597 = phi_3761_;
                                                                let _e7599 = phi_3762_;
                                                                phi_3763_ = _e7597;
                                                                phi_3764_ = _e7599;
                                                            }
                                                            let _e7601 = phi_3763_;
                                                            let _e7603 = phi_3764_;
                                                            phi_3765_ = _e7601;
                                                            phi_3766_ = _e7583;
                                                            phi_3767_ = _e7603;
                                                        } else {
                                                            phi_3765_ = f64();
                                                            phi_3766_ = true;
                                                            phi_3767_ = false;
                                                        }
                                                        let _e7605 = phi_3765_;
                                                        let _e7607 = phi_3766_;
                                                        let _e7609 = phi_3767_;
                                                        if _e7607 {
                                                            phi_3772_ = f64(2f);
                                                            phi_3773_ = true;
                                                        } else {
                                                            phi_3772_ = _e6923;
                                                            phi_3773_ = _e7609;
                                                        }
                                                        let _e7612 = phi_3772_;
                                                        let _e7614 = phi_3773_;
                                                        if _e7614 {
                                                            phi_3777_ = _e7612;
                                                        } else {
                                                            phi_3777_ = _e7605;
                                                        }
                                                        let _e7616 = phi_3777_;
                                                        if (_e7567 < _e7616) {
                                                            phi_3782_ = _e7567;
                                                        } else {
                                                            phi_3782_ = _e7616;
                                                        }
                                                        let _e7619 = phi_3782_;
                                                        let _e7622 = local_16.member[2u];
                                                        let _e7625 = local_16.member_1[2u];
                                                        let _e7628 = local_16.member_2[2u];
                                                        if (_e7622 > _e7628) {
                                                            if (_e7625 > _e7628) {
                                                                phi_3814_ = false;
                                                            } else {
                                                                phi_3814_ = true;
                                                            }
                                                            let _e7632 = phi_3814_;
                                                            phi_3815_ = _e7632;
                                                        } else {
                                                            phi_3815_ = true;
                                                        }
                                                        let _e7634 = phi_3815_;
                                                        if _e7634 {
                                                            let _e7635 = (_e7625 >= _e7622);
                                                            if _e7635 {
                                                                phi_3840_ = f64();
                                                                phi_3841_ = false;
                                                            } else {
                                                                if ((_e7622 - _e7625) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_3838_ = (((_e7622 - _e7628) / (_e7622 - _e7625)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_3839_ = false;
                                                                } else {
                                                                    phi_3838_ = f64();
                                                                    phi_3839_ = true;
                                                                }
                                                                let _e7649 = phi_3838_;
                                                                let _e7651 = phi_3839_;
                                                                phi_3840_ = _e7649;
                                                                phi_3841_ = _e7651;
                                                            }
                                                            let _e7653 = phi_3840_;
                                                            let _e7655 = phi_3841_;
                                                            phi_3842_ = _e7653;
                                                            phi_3843_ = _e7635;
                                                            phi_3844_ = _e7655;
                                                        } else {
                                                            phi_3842_ = f64();
                                                            phi_3843_ = true;
                                                            phi_3844_ = false;
                                                        }
                                                        let _e7657 = phi_3842_;
                                                        let _e7659 = phi_3843_;
                                                        let _e7661 = phi_3844_;
                                                        if _e7659 {
                                                            phi_3849_ = f64(2f);
                                                            phi_3850_ = true;
                                                        } else {
                                                            phi_3849_ = _e6923;
                                                            phi_3850_ = _e7661;
                                                        }
                                                        let _e7664 = phi_3849_;
                                                        let _e7666 = phi_3850_;
                                                        if _e7666 {
                                                            phi_3854_ = _e7664;
                                                        } else {
                                                            phi_3854_ = _e7657;
                                                        }
                                                        let _e7668 = phi_3854_;
                                                        let _e7671 = local_16.member[3u];
                                                        let _e7674 = local_16.member_1[3u];
                                                        let _e7677 = local_16.member_2[3u];
                                                        if (_e7671 > _e7677) {
                                                            if (_e7674 > _e7677) {
                                                                phi_3886_ = false;
                                                            } else {
                                                                phi_3886_ = true;
                                                            }
                                                            let _e7681 = phi_3886_;
                                                            phi_3887_ = _e7681;
                                                        } else {
                                                            phi_3887_ = true;
                                                        }
                                                        let _e7683 = phi_3887_;
                                                        if _e7683 {
                                                            let _e7684 = (_e7674 >= _e7671);
                                                            if _e7684 {
                                                                phi_3912_ = f64();
                                                                phi_3913_ = false;
                                                            } else {
                                                                if ((_e7671 - _e7674) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                    phi_3910_ = (((_e7671 - _e7677) / (_e7671 - _e7674)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                    phi_3911_ = false;
                                                                } else {
                                                                    phi_3910_ = f64();
                                                                    phi_3911_ = true;
                                                                }
                                                                let _e7698 = phi_3910_;
                                                                let _e7700 = phi_3911_;
                                                                phi_3912_ = _e7698;
                                                                phi_3913_ = _e7700;
                                                            }
                                                            let _e7702 = phi_3912_;
                                                            let _e7704 = phi_3913_;
                                                            phi_3914_ = _e7702;
                                                            phi_3915_ = _e7684;
                                                            phi_3916_ = _e7704;
                                                        } else {
                                                            phi_3914_ = f64();
                                                            phi_3915_ = true;
                                                            phi_3916_ = false;
                                                        }
                                                        let _e7706 = phi_3914_;
                                                        let _e7708 = phi_3915_;
                                                        let _e7710 = phi_3916_;
                                                        if _e7708 {
                                                            phi_3921_ = f64(2f);
                                                            phi_3922_ = true;
                                                        } else {
                                                            phi_3921_ = _e6923;
                                                            phi_3922_ = _e7710;
                                                        }
                                                        let _e7713 = phi_3921_;
                                                        let _e7715 = phi_3922_;
                                                        if _e7715 {
                                                            phi_3926_ = _e7713;
                                                        } else {
                                                            phi_3926_ = _e7706;
                                                        }
                                                        let _e7717 = phi_3926_;
                                                        if (_e7668 < _e7717) {
                                                            phi_3931_ = _e7668;
                                                        } else {
                                                            phi_3931_ = _e7717;
                                                        }
                                                        let _e7720 = phi_3931_;
                                                        if (_e7619 < _e7720) {
                                                            phi_3936_ = _e7619;
                                                        } else {
                                                            phi_3936_ = _e7720;
                                                        }
                                                        let _e7723 = phi_3936_;
                                                        if (_e7723 > _e6923) {
                                                            phi_3941_ = _e7723;
                                                        } else {
                                                            phi_3941_ = _e6923;
                                                        }
                                                        let _e7726 = phi_3941_;
                                                        let _e7727 = (_e7726 > _e422);
                                                        if _e7727 {
                                                            phi_4458_ = f64();
                                                            phi_4459_ = f64();
                                                            phi_4460_ = false;
                                                            phi_4461_ = false;
                                                        } else {
                                                            let _e7728 = (_e7726 - _e6923);
                                                            let _e7729 = (_e7728 <= _e6912);
                                                            let _e7732 = (_e7726 + (_e404 * f64(0.01f)));
                                                            if (_e7732 < _e422) {
                                                                phi_3955_ = _e7732;
                                                            } else {
                                                                phi_3955_ = _e422;
                                                            }
                                                            let _e7735 = phi_3955_;
                                                            if _e7729 {
                                                                if (_e623.member_1 > f64(0f)) {
                                                                    let _e7740 = local_18.member[0u];
                                                                    let _e7746 = local_18.member[1u];
                                                                    let _e7762 = local_18.member_1[0u];
                                                                    let _e7768 = local_18.member_1[1u];
                                                                    let _e7784 = local_18.member_2[0u];
                                                                    let _e7790 = local_18.member_2[1u];
                                                                    let _e7804 = function_4(array<f64, 3>((_e7740[0] + ((_e7746[0] - _e7740[0]) * _e7735)), (_e7740[1] + ((_e7746[1] - _e7740[1]) * _e7735)), (_e7740[2] + ((_e7746[2] - _e7740[2]) * _e7735))), array<f64, 3>((_e7762[0] + ((_e7768[0] - _e7762[0]) * _e7735)), (_e7762[1] + ((_e7768[1] - _e7762[1]) * _e7735)), (_e7762[2] + ((_e7768[2] - _e7762[2]) * _e7735))), array<f64, 3>((_e7784[0] + ((_e7790[0] - _e7784[0]) * _e7735)), (_e7784[1] + ((_e7790[1] - _e7784[1]) * _e7735)), (_e7784[2] + ((_e7790[2] - _e7784[2]) * _e7735))), 1u);
                                                                    let _e7815 = (((_e7804[0] * _e7804[0]) + (_e7804[1] * _e7804[1])) + (_e7804[2] * _e7804[2]));
                                                                    if (_e7815 <= 2.2250738585072014e-308lf) {
                                                                        if (_e7815 > 0.0lf) {
                                                                            phi_4086_ = (1.464336215552873e-154lf * 2.0lf);
                                                                        } else {
                                                                            phi_4086_ = 0.0lf;
                                                                        }
                                                                        let _e7867 = phi_4086_;
                                                                        phi_4150_ = _e7867;
                                                                    } else {
                                                                        phi_4093_ = type_16(0i, 5i);
                                                                        phi_4096_ = bitcast<f64>(((bitcast<u64>(_e7815) / 2lu) + 2303426169912950784lu));
                                                                        loop {
                                                                            let _e7822 = phi_4093_;
                                                                            let _e7824 = phi_4096_;
                                                                            local_42 = _e7824;
                                                                            if (_e7822.member < _e7822.member_1) {
                                                                                let _e7831 = (_e7822.member + 1i);
                                                                                if ((false == (_e7831 > _e7822.member)) != false) {
                                                                                    phi_4117_ = true;
                                                                                } else {
                                                                                    phi_4117_ = false;
                                                                                }
                                                                                let _e7836 = phi_4117_;
                                                                                if _e7836 {
                                                                                    phi_4123_ = type_17(0u, type_17().member_1);
                                                                                } else {
                                                                                    phi_4123_ = type_17(1u, _e7831);
                                                                                }
                                                                                let _e7841 = phi_4123_;
                                                                                phi_4094_ = type_16(_e7841.member_1, _e7822.member_1);
                                                                                phi_4137_ = type_17(1u, _e7822.member);
                                                                            } else {
                                                                                phi_4094_ = _e7822;
                                                                                phi_4137_ = type_17(0u, type_17().member_1);
                                                                            }
                                                                            let _e7847 = phi_4094_;
                                                                            let _e7849 = phi_4137_;
                                                                            let _e7852 = (bitcast<i32>(_e7849.member) != 0i);
                                                                            if _e7852 {
                                                                                phi_4097_ = (0.5lf * (_e7824 + (_e7815 / _e7824)));
                                                                            } else {
                                                                                phi_4097_ = f64();
                                                                            }
                                                                            let _e7857 = phi_4097_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_4093_ = _e7847;
                                                                                phi_4096_ = _e7857;
                                                                                break if !(_e7852);
                                                                            }
                                                                        }
                                                                        let _e7862 = local_42;
                                                                        phi_4150_ = (_e7862 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                    }
                                                                    let _e7869 = phi_4150_;
                                                                    let _e7877 = local_18.member[0u];
                                                                    if (_e7877[0] < 0.0lf) {
                                                                        phi_4168_ = -(_e7877[0]);
                                                                    } else {
                                                                        phi_4168_ = _e7877[0];
                                                                    }
                                                                    let _e7884 = phi_4168_;
                                                                    if (_e7877[1] < 0.0lf) {
                                                                        phi_4175_ = -(_e7877[1]);
                                                                    } else {
                                                                        phi_4175_ = _e7877[1];
                                                                    }
                                                                    let _e7888 = phi_4175_;
                                                                    if (_e7884 > _e7888) {
                                                                        phi_4180_ = _e7884;
                                                                    } else {
                                                                        phi_4180_ = _e7888;
                                                                    }
                                                                    let _e7891 = phi_4180_;
                                                                    if (_e7877[2] < 0.0lf) {
                                                                        phi_4187_ = -(_e7877[2]);
                                                                    } else {
                                                                        phi_4187_ = _e7877[2];
                                                                    }
                                                                    let _e7895 = phi_4187_;
                                                                    if (_e7891 > _e7895) {
                                                                        phi_4192_ = _e7891;
                                                                    } else {
                                                                        phi_4192_ = _e7895;
                                                                    }
                                                                    let _e7898 = phi_4192_;
                                                                    let _e7901 = local_18.member[1u];
                                                                    if (_e7901[0] < 0.0lf) {
                                                                        phi_4205_ = -(_e7901[0]);
                                                                    } else {
                                                                        phi_4205_ = _e7901[0];
                                                                    }
                                                                    let _e7908 = phi_4205_;
                                                                    if (_e7901[1] < 0.0lf) {
                                                                        phi_4212_ = -(_e7901[1]);
                                                                    } else {
                                                                        phi_4212_ = _e7901[1];
                                                                    }
                                                                    let _e7912 = phi_4212_;
                                                                    if (_e7908 > _e7912) {
                                                                        phi_4217_ = _e7908;
                                                                    } else {
                                                                        phi_4217_ = _e7912;
                                                                    }
                                                                    let _e7915 = phi_4217_;
                                                                    if (_e7901[2] < 0.0lf) {
                                                                        phi_4224_ = -(_e7901[2]);
                                                                    } else {
                                                                        phi_4224_ = _e7901[2];
                                                                    }
                                                                    let _e7919 = phi_4224_;
                                                                    if (_e7915 > _e7919) {
                                                                        phi_4229_ = _e7915;
                                                                    } else {
                                                                        phi_4229_ = _e7919;
                                                                    }
                                                                    let _e7922 = phi_4229_;
                                                                    if (_e7898 > _e7922) {
                                                                        phi_4234_ = _e7898;
                                                                    } else {
                                                                        phi_4234_ = _e7922;
                                                                    }
                                                                    let _e7925 = phi_4234_;
                                                                    let _e7927 = local_18.member_3;
                                                                    let _e7931 = local_18.member_1[0u];
                                                                    if (_e7931[0] < 0.0lf) {
                                                                        phi_4251_ = -(_e7931[0]);
                                                                    } else {
                                                                        phi_4251_ = _e7931[0];
                                                                    }
                                                                    let _e7938 = phi_4251_;
                                                                    if (_e7931[1] < 0.0lf) {
                                                                        phi_4258_ = -(_e7931[1]);
                                                                    } else {
                                                                        phi_4258_ = _e7931[1];
                                                                    }
                                                                    let _e7942 = phi_4258_;
                                                                    if (_e7938 > _e7942) {
                                                                        phi_4263_ = _e7938;
                                                                    } else {
                                                                        phi_4263_ = _e7942;
                                                                    }
                                                                    let _e7945 = phi_4263_;
                                                                    if (_e7931[2] < 0.0lf) {
                                                                        phi_4270_ = -(_e7931[2]);
                                                                    } else {
                                                                        phi_4270_ = _e7931[2];
                                                                    }
                                                                    let _e7949 = phi_4270_;
                                                                    if (_e7945 > _e7949) {
                                                                        phi_4275_ = _e7945;
                                                                    } else {
                                                                        phi_4275_ = _e7949;
                                                                    }
                                                                    let _e7952 = phi_4275_;
                                                                    let _e7955 = local_18.member_1[1u];
                                                                    if (_e7955[0] < 0.0lf) {
                                                                        phi_4289_ = -(_e7955[0]);
                                                                    } else {
                                                                        phi_4289_ = _e7955[0];
                                                                    }
                                                                    let _e7962 = phi_4289_;
                                                                    if (_e7955[1] < 0.0lf) {
                                                                        phi_4296_ = -(_e7955[1]);
                                                                    } else {
                                                                        phi_4296_ = _e7955[1];
                                                                    }
                                                                    let _e7966 = phi_4296_;
                                                                    if (_e7962 > _e7966) {
                                                                        phi_4301_ = _e7962;
                                                                    } else {
                                                                        phi_4301_ = _e7966;
                                                                    }
                                                                    let _e7969 = phi_4301_;
                                                                    if (_e7955[2] < 0.0lf) {
                                                                        phi_4308_ = -(_e7955[2]);
                                                                    } else {
                                                                        phi_4308_ = _e7955[2];
                                                                    }
                                                                    let _e7973 = phi_4308_;
                                                                    if (_e7969 > _e7973) {
                                                                        phi_4313_ = _e7969;
                                                                    } else {
                                                                        phi_4313_ = _e7973;
                                                                    }
                                                                    let _e7976 = phi_4313_;
                                                                    if (_e7952 > _e7976) {
                                                                        phi_4318_ = _e7952;
                                                                    } else {
                                                                        phi_4318_ = _e7976;
                                                                    }
                                                                    let _e7979 = phi_4318_;
                                                                    let _e7981 = local_18.member_3;
                                                                    let _e7985 = local_18.member_2[0u];
                                                                    if (_e7985[0] < 0.0lf) {
                                                                        phi_4335_ = -(_e7985[0]);
                                                                    } else {
                                                                        phi_4335_ = _e7985[0];
                                                                    }
                                                                    let _e7992 = phi_4335_;
                                                                    if (_e7985[1] < 0.0lf) {
                                                                        phi_4342_ = -(_e7985[1]);
                                                                    } else {
                                                                        phi_4342_ = _e7985[1];
                                                                    }
                                                                    let _e7996 = phi_4342_;
                                                                    if (_e7992 > _e7996) {
                                                                        phi_4347_ = _e7992;
                                                                    } else {
                                                                        phi_4347_ = _e7996;
                                                                    }
                                                                    let _e7999 = phi_4347_;
                                                                    if (_e7985[2] < 0.0lf) {
                                                                        phi_4354_ = -(_e7985[2]);
                                                                    } else {
                                                                        phi_4354_ = _e7985[2];
                                                                    }
                                                                    let _e8003 = phi_4354_;
                                                                    if (_e7999 > _e8003) {
                                                                        phi_4359_ = _e7999;
                                                                    } else {
                                                                        phi_4359_ = _e8003;
                                                                    }
                                                                    let _e8006 = phi_4359_;
                                                                    let _e8009 = local_18.member_2[1u];
                                                                    if (_e8009[0] < 0.0lf) {
                                                                        phi_4373_ = -(_e8009[0]);
                                                                    } else {
                                                                        phi_4373_ = _e8009[0];
                                                                    }
                                                                    let _e8016 = phi_4373_;
                                                                    if (_e8009[1] < 0.0lf) {
                                                                        phi_4380_ = -(_e8009[1]);
                                                                    } else {
                                                                        phi_4380_ = _e8009[1];
                                                                    }
                                                                    let _e8020 = phi_4380_;
                                                                    if (_e8016 > _e8020) {
                                                                        phi_4385_ = _e8016;
                                                                    } else {
                                                                        phi_4385_ = _e8020;
                                                                    }
                                                                    let _e8023 = phi_4385_;
                                                                    if (_e8009[2] < 0.0lf) {
                                                                        phi_4392_ = -(_e8009[2]);
                                                                    } else {
                                                                        phi_4392_ = _e8009[2];
                                                                    }
                                                                    let _e8027 = phi_4392_;
                                                                    if (_e8023 > _e8027) {
                                                                        phi_4397_ = _e8023;
                                                                    } else {
                                                                        phi_4397_ = _e8027;
                                                                    }
                                                                    let _e8030 = phi_4397_;
                                                                    if (_e8006 > _e8030) {
                                                                        phi_4402_ = _e8006;
                                                                    } else {
                                                                        phi_4402_ = _e8030;
                                                                    }
                                                                    let _e8033 = phi_4402_;
                                                                    let _e8035 = local_18.member_3;
                                                                    let _e8043 = local_18.member_3;
                                                                    if (((_e7869 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e7925 + _e7927) + (_e7979 + _e7981)) + (_e8033 + _e8035)) * (1.1102230246251565e-16lf * f64(16f))) + (_e8043 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e623.member_1) {
                                                                        phi_4426_ = false;
                                                                    } else {
                                                                        phi_4426_ = true;
                                                                    }
                                                                    let _e8055 = phi_4426_;
                                                                    phi_4427_ = _e8055;
                                                                } else {
                                                                    phi_4427_ = true;
                                                                }
                                                                let _e8057 = phi_4427_;
                                                                phi_4428_ = _e8057;
                                                            } else {
                                                                phi_4428_ = true;
                                                            }
                                                            let _e8059 = phi_4428_;
                                                            if _e8059 {
                                                                if _e6931 {
                                                                    if _e7729 {
                                                                        phi_4447_ = f64();
                                                                        phi_4448_ = true;
                                                                    } else {
                                                                        if (_e7728 <= (_e6927 * f64(0.25f))) {
                                                                            phi_4445_ = f64(0f);
                                                                            phi_4446_ = false;
                                                                        } else {
                                                                            phi_4445_ = f64();
                                                                            phi_4446_ = true;
                                                                        }
                                                                        let _e8066 = phi_4445_;
                                                                        let _e8068 = phi_4446_;
                                                                        phi_4447_ = _e8066;
                                                                        phi_4448_ = _e8068;
                                                                    }
                                                                    let _e8070 = phi_4447_;
                                                                    let _e8072 = phi_4448_;
                                                                    if _e8072 {
                                                                        phi_4453_ = (_e7256 + _e7256);
                                                                    } else {
                                                                        phi_4453_ = _e8070;
                                                                    }
                                                                    let _e8075 = phi_4453_;
                                                                    phi_4455_ = _e8075;
                                                                } else {
                                                                    phi_4455_ = (_e422 - _e6923);
                                                                }
                                                                let _e8077 = phi_4455_;
                                                                phi_4456_ = _e8077;
                                                                phi_4457_ = false;
                                                            } else {
                                                                phi_4456_ = f64();
                                                                phi_4457_ = true;
                                                            }
                                                            let _e8079 = phi_4456_;
                                                            let _e8081 = phi_4457_;
                                                            phi_4458_ = _e8079;
                                                            phi_4459_ = _e7728;
                                                            phi_4460_ = _e8059;
                                                            phi_4461_ = _e8081;
                                                        }
                                                        let _e8083 = phi_4458_;
                                                        let _e8085 = phi_4459_;
                                                        let _e8087 = phi_4460_;
                                                        let _e8089 = phi_4461_;
                                                        phi_4462_ = _e7726;
                                                        phi_4463_ = _e8083;
                                                        phi_4464_ = _e8085;
                                                        phi_4465_ = _e7726;
                                                        phi_4466_ = _e8087;
                                                        phi_4467_ = _e7727;
                                                        phi_4468_ = _e8089;
                                                        phi_4469_ = false;
                                                    } else {
                                                        phi_4462_ = f64();
                                                        phi_4463_ = f64();
                                                        phi_4464_ = f64();
                                                        phi_4465_ = f64();
                                                        phi_4466_ = false;
                                                        phi_4467_ = false;
                                                        phi_4468_ = false;
                                                        phi_4469_ = true;
                                                    }
                                                    let _e8091 = phi_4462_;
                                                    let _e8093 = phi_4463_;
                                                    let _e8095 = phi_4464_;
                                                    let _e8097 = phi_4465_;
                                                    let _e8099 = phi_4466_;
                                                    let _e8101 = phi_4467_;
                                                    let _e8103 = phi_4468_;
                                                    let _e8105 = phi_4469_;
                                                    phi_4470_ = _e8091;
                                                    phi_4471_ = _e8093;
                                                    phi_4472_ = _e8095;
                                                    phi_4473_ = _e8097;
                                                    phi_4474_ = false;
                                                    phi_4475_ = _e8099;
                                                    phi_4476_ = _e8101;
                                                    phi_4477_ = _e8103;
                                                    phi_4478_ = _e8105;
                                                } else {
                                                    phi_4470_ = f64();
                                                    phi_4471_ = f64();
                                                    phi_4472_ = f64();
                                                    phi_4473_ = f64();
                                                    phi_4474_ = true;
                                                    phi_4475_ = false;
                                                    phi_4476_ = false;
                                                    phi_4477_ = false;
                                                    phi_4478_ = false;
                                                }
                                                let _e8107 = phi_4470_;
                                                let _e8109 = phi_4471_;
                                                let _e8111 = phi_4472_;
                                                let _e8113 = phi_4473_;
                                                let _e8115 = phi_4474_;
                                                let _e8117 = phi_4475_;
                                                let _e8119 = phi_4476_;
                                                let _e8121 = phi_4477_;
                                                let _e8123 = phi_4478_;
                                                phi_4479_ = _e8107;
                                                phi_4480_ = _e8109;
                                                phi_4481_ = _e8111;
                                                phi_4482_ = _e8113;
                                                phi_4483_ = _e8115;
                                                phi_4484_ = _e8117;
                                                phi_4485_ = _e8119;
                                                phi_4486_ = _e8121;
                                                phi_4487_ = _e8123;
                                            } else {
                                                phi_4479_ = f64();
                                                phi_4480_ = f64();
                                                phi_4481_ = f64();
                                                phi_4482_ = f64();
                                                phi_4483_ = true;
                                                phi_4484_ = false;
                                                phi_4485_ = false;
                                                phi_4486_ = false;
                                                phi_4487_ = false;
                                            }
                                            let _e8125 = phi_4479_;
                                            let _e8127 = phi_4480_;
                                            let _e8129 = phi_4481_;
                                            let _e8131 = phi_4482_;
                                            let _e8133 = phi_4483_;
                                            let _e8135 = phi_4484_;
                                            let _e8137 = phi_4485_;
                                            let _e8139 = phi_4486_;
                                            let _e8141 = phi_4487_;
                                            if _e8133 {
                                                if (_e6923 <= _e6925) {
                                                    let _e8307 = (_e6933 + 1u);
                                                    let _e8308 = (_e8307 > 3u);
                                                    if _e8308 {
                                                        phi_4500_ = false;
                                                    } else {
                                                        phi_4500_ = true;
                                                    }
                                                    let _e8310 = phi_4500_;
                                                    phi_4827_ = _e8307;
                                                    phi_4828_ = f64();
                                                    phi_4829_ = false;
                                                    phi_4830_ = _e8310;
                                                    phi_4831_ = _e8308;
                                                } else {
                                                    let _e8145 = local_16.member[0u];
                                                    let _e8148 = local_16.member_1[0u];
                                                    let _e8151 = local_16.member[0u];
                                                    let _e8157 = local_16.member_2[0u];
                                                    let _e8158 = ((_e8145 + ((_e8148 - _e8151) * _e6929)) - _e8157);
                                                    let _e8161 = local_16.member[1u];
                                                    let _e8164 = local_16.member_1[1u];
                                                    let _e8167 = local_16.member[1u];
                                                    let _e8173 = local_16.member_2[1u];
                                                    let _e8174 = ((_e8161 + ((_e8164 - _e8167) * _e6929)) - _e8173);
                                                    if (_e8158 < _e8174) {
                                                        phi_4573_ = _e8158;
                                                    } else {
                                                        phi_4573_ = _e8174;
                                                    }
                                                    let _e8177 = phi_4573_;
                                                    let _e8180 = local_16.member[2u];
                                                    let _e8183 = local_16.member_1[2u];
                                                    let _e8186 = local_16.member[2u];
                                                    let _e8192 = local_16.member_2[2u];
                                                    let _e8193 = ((_e8180 + ((_e8183 - _e8186) * _e6929)) - _e8192);
                                                    let _e8196 = local_16.member[3u];
                                                    let _e8199 = local_16.member_1[3u];
                                                    let _e8202 = local_16.member[3u];
                                                    let _e8208 = local_16.member_2[3u];
                                                    let _e8209 = ((_e8196 + ((_e8199 - _e8202) * _e6929)) - _e8208);
                                                    if (_e8193 < _e8209) {
                                                        phi_4646_ = _e8193;
                                                    } else {
                                                        phi_4646_ = _e8209;
                                                    }
                                                    let _e8212 = phi_4646_;
                                                    if (_e8177 < _e8212) {
                                                        phi_4651_ = _e8177;
                                                    } else {
                                                        phi_4651_ = _e8212;
                                                    }
                                                    let _e8215 = phi_4651_;
                                                    let _e8218 = local_17.member[0u];
                                                    let _e8221 = local_17.member_1[0u];
                                                    let _e8224 = local_17.member[0u];
                                                    let _e8230 = local_17.member_2[0u];
                                                    let _e8231 = ((_e8218 + ((_e8221 - _e8224) * _e6923)) - _e8230);
                                                    let _e8234 = local_17.member[1u];
                                                    let _e8237 = local_17.member_1[1u];
                                                    let _e8240 = local_17.member[1u];
                                                    let _e8246 = local_17.member_2[1u];
                                                    let _e8247 = ((_e8234 + ((_e8237 - _e8240) * _e6923)) - _e8246);
                                                    if (_e8231 < _e8247) {
                                                        phi_4724_ = _e8231;
                                                    } else {
                                                        phi_4724_ = _e8247;
                                                    }
                                                    let _e8250 = phi_4724_;
                                                    let _e8253 = local_17.member[2u];
                                                    let _e8256 = local_17.member_1[2u];
                                                    let _e8259 = local_17.member[2u];
                                                    let _e8265 = local_17.member_2[2u];
                                                    let _e8266 = ((_e8253 + ((_e8256 - _e8259) * _e6923)) - _e8265);
                                                    let _e8269 = local_17.member[3u];
                                                    let _e8272 = local_17.member_1[3u];
                                                    let _e8275 = local_17.member[3u];
                                                    let _e8281 = local_17.member_2[3u];
                                                    let _e8282 = ((_e8269 + ((_e8272 - _e8275) * _e6923)) - _e8281);
                                                    if (_e8266 < _e8282) {
                                                        phi_4797_ = _e8266;
                                                    } else {
                                                        phi_4797_ = _e8282;
                                                    }
                                                    let _e8285 = phi_4797_;
                                                    if (_e8250 < _e8285) {
                                                        phi_4802_ = _e8250;
                                                    } else {
                                                        phi_4802_ = _e8285;
                                                    }
                                                    let _e8288 = phi_4802_;
                                                    let _e8289 = f64(0.0625f);
                                                    let _e8291 = f64(0.9f);
                                                    if (_e8288 > f64(0f)) {
                                                        phi_4825_ = f64(0.5f);
                                                    } else {
                                                        let _e8297 = (f64(0.95f) * (_e8215 / (_e8215 - _e8288)));
                                                        if (_e8297 > _e8289) {
                                                            if (_e8297 < _e8291) {
                                                                phi_4823_ = _e8297;
                                                            } else {
                                                                phi_4823_ = _e8291;
                                                            }
                                                            let _e8301 = phi_4823_;
                                                            phi_4824_ = _e8301;
                                                        } else {
                                                            phi_4824_ = _e8289;
                                                        }
                                                        let _e8303 = phi_4824_;
                                                        phi_4825_ = _e8303;
                                                    }
                                                    let _e8305 = phi_4825_;
                                                    phi_4827_ = u32();
                                                    phi_4828_ = (_e7256 * _e8305);
                                                    phi_4829_ = true;
                                                    phi_4830_ = false;
                                                    phi_4831_ = false;
                                                }
                                                let _e8312 = phi_4827_;
                                                let _e8314 = phi_4828_;
                                                let _e8316 = phi_4829_;
                                                let _e8318 = phi_4830_;
                                                let _e8320 = phi_4831_;
                                                phi_4832_ = _e8312;
                                                phi_4833_ = _e6925;
                                                phi_4834_ = _e8314;
                                                phi_4835_ = _e6927;
                                                phi_4836_ = _e6929;
                                                phi_4837_ = _e6931;
                                                phi_4838_ = _e6933;
                                                phi_4839_ = _e8316;
                                                phi_4840_ = _e8318;
                                                phi_4841_ = _e8320;
                                                phi_4842_ = false;
                                                phi_4843_ = false;
                                                phi_4844_ = false;
                                            } else {
                                                phi_4832_ = u32();
                                                phi_4833_ = _e8125;
                                                phi_4834_ = _e8127;
                                                phi_4835_ = _e8129;
                                                phi_4836_ = _e6923;
                                                phi_4837_ = true;
                                                phi_4838_ = 0u;
                                                phi_4839_ = _e8135;
                                                phi_4840_ = false;
                                                phi_4841_ = false;
                                                phi_4842_ = _e8137;
                                                phi_4843_ = _e8139;
                                                phi_4844_ = _e8141;
                                            }
                                            let _e8322 = phi_4832_;
                                            let _e8324 = phi_4833_;
                                            let _e8326 = phi_4834_;
                                            let _e8328 = phi_4835_;
                                            let _e8330 = phi_4836_;
                                            let _e8332 = phi_4837_;
                                            let _e8334 = phi_4838_;
                                            let _e8336 = phi_4839_;
                                            let _e8338 = phi_4840_;
                                            let _e8340 = phi_4841_;
                                            let _e8342 = phi_4842_;
                                            let _e8344 = phi_4843_;
                                            let _e8346 = phi_4844_;
                                            if _e8336 {
                                                let _e8347 = (_e8330 + _e8326);
                                                if (_e8347 > _e8324) {
                                                    phi_4853_ = _e8347;
                                                } else {
                                                    phi_4853_ = _e8324;
                                                }
                                                let _e8350 = phi_4853_;
                                                if (_e8350 < _e422) {
                                                    phi_4858_ = _e8350;
                                                } else {
                                                    phi_4858_ = _e422;
                                                }
                                                let _e8353 = phi_4858_;
                                                if !(_e6931) {
                                                    phi_4867_ = true;
                                                } else {
                                                    phi_4867_ = ((_e8353 - _e8330) > _e6912);
                                                }
                                                let _e8357 = phi_4867_;
                                                if _e8357 {
                                                    phi_4871_ = false;
                                                } else {
                                                    phi_4871_ = true;
                                                }
                                                let _e8359 = phi_4871_;
                                                phi_4872_ = _e8353;
                                                phi_4873_ = _e8324;
                                                phi_4874_ = _e8328;
                                                phi_4875_ = _e8330;
                                                phi_4876_ = _e8332;
                                                phi_4877_ = _e8334;
                                                phi_4878_ = _e8357;
                                                phi_4879_ = _e8359;
                                                phi_4880_ = false;
                                                phi_4881_ = false;
                                                phi_4882_ = false;
                                                phi_4883_ = false;
                                            } else {
                                                phi_4872_ = _e6923;
                                                phi_4873_ = _e6925;
                                                phi_4874_ = _e6927;
                                                phi_4875_ = _e6929;
                                                phi_4876_ = _e6931;
                                                phi_4877_ = _e8322;
                                                phi_4878_ = _e8338;
                                                phi_4879_ = false;
                                                phi_4880_ = _e8340;
                                                phi_4881_ = _e8342;
                                                phi_4882_ = _e8344;
                                                phi_4883_ = _e8346;
                                            }
                                            let _e8361 = phi_4872_;
                                            let _e8363 = phi_4873_;
                                            let _e8365 = phi_4874_;
                                            let _e8367 = phi_4875_;
                                            let _e8369 = phi_4876_;
                                            let _e8371 = phi_4877_;
                                            let _e8373 = phi_4878_;
                                            let _e8375 = phi_4879_;
                                            let _e8377 = phi_4880_;
                                            let _e8379 = phi_4881_;
                                            let _e8381 = phi_4882_;
                                            let _e8383 = phi_4883_;
                                            phi_2662_ = _e8361;
                                            phi_2664_ = _e8363;
                                            phi_2666_ = _e8365;
                                            phi_2668_ = _e8367;
                                            phi_2670_ = _e8369;
                                            phi_2672_ = _e8371;
                                            phi_4884_ = _e8324;
                                            phi_4885_ = _e8131;
                                            phi_4886_ = _e8373;
                                            phi_4887_ = _e8375;
                                            phi_4888_ = _e8377;
                                            phi_4889_ = _e8379;
                                            phi_4890_ = _e8381;
                                            phi_4891_ = false;
                                            phi_4892_ = _e8383;
                                        } else {
                                            phi_2662_ = f64();
                                            phi_2664_ = f64();
                                            phi_2666_ = f64();
                                            phi_2668_ = f64();
                                            phi_2670_ = bool();
                                            phi_2672_ = u32();
                                            phi_4884_ = f64();
                                            phi_4885_ = f64();
                                            phi_4886_ = false;
                                            phi_4887_ = false;
                                            phi_4888_ = false;
                                            phi_4889_ = false;
                                            phi_4890_ = false;
                                            phi_4891_ = true;
                                            phi_4892_ = false;
                                        }
                                        let _e8385 = phi_2662_;
                                        let _e8387 = phi_2664_;
                                        let _e8389 = phi_2666_;
                                        let _e8391 = phi_2668_;
                                        let _e8393 = phi_2670_;
                                        let _e8395 = phi_2672_;
                                        let _e8397 = phi_4884_;
                                        let _e8399 = phi_4885_;
                                        let _e8401 = phi_4886_;
                                        let _e8403 = phi_4887_;
                                        let _e8405 = phi_4888_;
                                        let _e8407 = phi_4889_;
                                        let _e8409 = phi_4890_;
                                        let _e8411 = phi_4891_;
                                        let _e8413 = phi_4892_;
                                        local_43 = _e8403;
                                        local_81 = _e8405;
                                        local_82 = _e8407;
                                        local_83 = _e8409;
                                        local_84 = _e8411;
                                        local_85 = _e8413;
                                        local_86 = _e8403;
                                        local_87 = _e8399;
                                        local_88 = _e8397;
                                        continue;
                                        continuing {
                                            phi_2658_ = _e6945;
                                            phi_2661_ = _e8385;
                                            phi_2663_ = _e8387;
                                            phi_2665_ = _e8389;
                                            phi_2667_ = _e8391;
                                            phi_2669_ = _e8393;
                                            phi_2671_ = _e8395;
                                            break if !(_e8401);
                                        }
                                    }
                                    let _e8416 = local_43;
                                    if _e8416 {
                                        phi_4896_ = false;
                                        phi_4897_ = false;
                                        phi_4898_ = false;
                                        phi_4899_ = false;
                                        phi_4900_ = false;
                                    } else {
                                        let _e11890 = local_81;
                                        phi_4896_ = _e11890;
                                        let _e11893 = local_82;
                                        phi_4897_ = _e11893;
                                        let _e11896 = local_83;
                                        phi_4898_ = _e11896;
                                        let _e11899 = local_84;
                                        phi_4899_ = _e11899;
                                        let _e11902 = local_85;
                                        phi_4900_ = _e11902;
                                    }
                                    let _e8418 = phi_4896_;
                                    let _e8420 = phi_4897_;
                                    let _e8422 = phi_4898_;
                                    let _e8424 = phi_4899_;
                                    let _e8426 = phi_4900_;
                                    if _e8418 {
                                        let _e8428 = local_44;
                                        phi_4905_ = type_46(1u, _e8428);
                                        phi_4906_ = false;
                                        phi_4907_ = false;
                                        phi_4908_ = false;
                                        phi_4909_ = false;
                                        phi_4910_ = false;
                                    } else {
                                        phi_4905_ = type_46();
                                        phi_4906_ = _e8420;
                                        phi_4907_ = _e8422;
                                        let _e11909 = local_86;
                                        phi_4908_ = _e11909;
                                        phi_4909_ = _e8424;
                                        phi_4910_ = _e8426;
                                    }
                                    let _e8431 = phi_4905_;
                                    let _e8433 = phi_4906_;
                                    let _e8435 = phi_4907_;
                                    let _e8437 = phi_4908_;
                                    let _e8439 = phi_4909_;
                                    let _e8441 = phi_4910_;
                                    if _e8433 {
                                        phi_4915_ = type_46(0u, type_46().member_1);
                                        phi_4916_ = false;
                                        phi_4917_ = false;
                                        phi_4918_ = false;
                                        phi_4919_ = false;
                                        phi_4920_ = true;
                                    } else {
                                        phi_4915_ = _e8431;
                                        phi_4916_ = _e8435;
                                        phi_4917_ = _e8437;
                                        phi_4918_ = _e8439;
                                        phi_4919_ = _e8441;
                                        phi_4920_ = _e8418;
                                    }
                                    let _e8445 = phi_4915_;
                                    let _e8447 = phi_4916_;
                                    let _e8449 = phi_4917_;
                                    let _e8451 = phi_4918_;
                                    let _e8453 = phi_4919_;
                                    let _e8455 = phi_4920_;
                                    if _e8447 {
                                        let _e11920 = local_87;
                                        phi_4924_ = _e11920;
                                        phi_4925_ = true;
                                        phi_4926_ = false;
                                        phi_4927_ = false;
                                        phi_4928_ = false;
                                    } else {
                                        let _e11922 = local_88;
                                        phi_4924_ = _e11922;
                                        phi_4925_ = _e8449;
                                        phi_4926_ = _e8451;
                                        phi_4927_ = _e8453;
                                        phi_4928_ = _e8455;
                                    }
                                    let _e8457 = phi_4924_;
                                    let _e8459 = phi_4925_;
                                    let _e8461 = phi_4926_;
                                    let _e8463 = phi_4927_;
                                    let _e8465 = phi_4928_;
                                    if _e8459 {
                                        phi_4932_ = _e8457;
                                        phi_4933_ = true;
                                        phi_4934_ = false;
                                        phi_4935_ = false;
                                    } else {
                                        let _e11929 = local_89;
                                        phi_4932_ = _e11929;
                                        phi_4933_ = _e8461;
                                        phi_4934_ = _e8463;
                                        phi_4935_ = _e8465;
                                    }
                                    let _e8467 = phi_4932_;
                                    let _e8469 = phi_4933_;
                                    let _e8471 = phi_4934_;
                                    let _e8473 = phi_4935_;
                                    if _e8469 {
                                        phi_4940_ = type_46(1u, _e8467);
                                        phi_4941_ = false;
                                        phi_4942_ = false;
                                    } else {
                                        phi_4940_ = type_46();
                                        phi_4941_ = _e8471;
                                        phi_4942_ = _e8473;
                                    }
                                    let _e8476 = phi_4940_;
                                    let _e8478 = phi_4941_;
                                    let _e8480 = phi_4942_;
                                    if _e8478 {
                                        phi_4947_ = type_46(0u, type_46().member_1);
                                        phi_4948_ = true;
                                    } else {
                                        phi_4947_ = _e8445;
                                        phi_4948_ = _e8480;
                                    }
                                    let _e8484 = phi_4947_;
                                    let _e8486 = phi_4948_;
                                    if _e8486 {
                                        phi_4952_ = _e8484;
                                    } else {
                                        phi_4952_ = _e8476;
                                    }
                                    let _e8488 = phi_4952_;
                                    phi_4959_ = _e8488.member_1;
                                    phi_4960_ = (_e8488.member != 0u);
                                } else {
                                    phi_4959_ = _e6643;
                                    phi_4960_ = true;
                                }
                                let _e8493 = phi_4959_;
                                let _e8495 = phi_4960_;
                                if _e8495 {
                                    let _e8496 = (_e8493 > _e413);
                                    if _e8496 {
                                        phi_7167_ = f64();
                                        phi_7168_ = u32();
                                        phi_7169_ = f64();
                                        phi_7170_ = type_48();
                                        phi_7171_ = u32();
                                        phi_7172_ = u32();
                                        phi_7173_ = false;
                                        phi_7174_ = false;
                                        phi_7175_ = false;
                                    } else {
                                        let _e8500 = local_18.member[0u];
                                        let _e8506 = local_18.member[1u];
                                        let _e8522 = local_18.member_1[0u];
                                        let _e8528 = local_18.member_1[1u];
                                        let _e8544 = local_18.member_2[0u];
                                        let _e8550 = local_18.member_2[1u];
                                        let _e8564 = function_4(array<f64, 3>((_e8500[0] + ((_e8506[0] - _e8500[0]) * _e6647)), (_e8500[1] + ((_e8506[1] - _e8500[1]) * _e6647)), (_e8500[2] + ((_e8506[2] - _e8500[2]) * _e6647))), array<f64, 3>((_e8522[0] + ((_e8528[0] - _e8522[0]) * _e6647)), (_e8522[1] + ((_e8528[1] - _e8522[1]) * _e6647)), (_e8522[2] + ((_e8528[2] - _e8522[2]) * _e6647))), array<f64, 3>((_e8544[0] + ((_e8550[0] - _e8544[0]) * _e6647)), (_e8544[1] + ((_e8550[1] - _e8544[1]) * _e6647)), (_e8544[2] + ((_e8550[2] - _e8544[2]) * _e6647))), 1u);
                                        if (_e8564[0] < 0.0lf) {
                                            phi_5073_ = -(_e8564[0]);
                                        } else {
                                            phi_5073_ = _e8564[0];
                                        }
                                        let _e8569 = phi_5073_;
                                        if (_e8564[1] < 0.0lf) {
                                            phi_5080_ = -(_e8564[1]);
                                        } else {
                                            phi_5080_ = _e8564[1];
                                        }
                                        let _e8574 = phi_5080_;
                                        if (_e8564[2] < 0.0lf) {
                                            phi_5088_ = -(_e8564[2]);
                                        } else {
                                            phi_5088_ = _e8564[2];
                                        }
                                        let _e8580 = phi_5088_;
                                        let _e8581 = ((_e8569 + _e8574) + _e8580);
                                        let _e8584 = local_18.member[0u];
                                        let _e8590 = local_18.member_1[0u];
                                        let _e8596 = local_18.member_2[0u];
                                        let _e8600 = (_e8584[0] - _e8590[0]);
                                        let _e8601 = (_e8584[1] - _e8590[1]);
                                        let _e8602 = (_e8584[2] - _e8590[2]);
                                        let _e8611 = local_18.member[1u];
                                        let _e8617 = local_18.member_1[1u];
                                        let _e8623 = local_18.member_2[1u];
                                        let _e8627 = (_e8611[0] - _e8617[0]);
                                        let _e8628 = (_e8611[1] - _e8617[1]);
                                        let _e8629 = (_e8611[2] - _e8617[2]);
                                        let _e8638 = local_18.member[0u];
                                        if (_e8638[0] < 0.0lf) {
                                            phi_5239_ = -(_e8638[0]);
                                        } else {
                                            phi_5239_ = _e8638[0];
                                        }
                                        let _e8645 = phi_5239_;
                                        if (_e8638[1] < 0.0lf) {
                                            phi_5246_ = -(_e8638[1]);
                                        } else {
                                            phi_5246_ = _e8638[1];
                                        }
                                        let _e8649 = phi_5246_;
                                        if (_e8645 > _e8649) {
                                            phi_5251_ = _e8645;
                                        } else {
                                            phi_5251_ = _e8649;
                                        }
                                        let _e8652 = phi_5251_;
                                        if (_e8638[2] < 0.0lf) {
                                            phi_5258_ = -(_e8638[2]);
                                        } else {
                                            phi_5258_ = _e8638[2];
                                        }
                                        let _e8656 = phi_5258_;
                                        if (_e8652 > _e8656) {
                                            phi_5263_ = _e8652;
                                        } else {
                                            phi_5263_ = _e8656;
                                        }
                                        let _e8659 = phi_5263_;
                                        let _e8662 = local_18.member[1u];
                                        if (_e8662[0] < 0.0lf) {
                                            phi_5276_ = -(_e8662[0]);
                                        } else {
                                            phi_5276_ = _e8662[0];
                                        }
                                        let _e8669 = phi_5276_;
                                        if (_e8662[1] < 0.0lf) {
                                            phi_5283_ = -(_e8662[1]);
                                        } else {
                                            phi_5283_ = _e8662[1];
                                        }
                                        let _e8673 = phi_5283_;
                                        if (_e8669 > _e8673) {
                                            phi_5288_ = _e8669;
                                        } else {
                                            phi_5288_ = _e8673;
                                        }
                                        let _e8676 = phi_5288_;
                                        if (_e8662[2] < 0.0lf) {
                                            phi_5295_ = -(_e8662[2]);
                                        } else {
                                            phi_5295_ = _e8662[2];
                                        }
                                        let _e8680 = phi_5295_;
                                        if (_e8676 > _e8680) {
                                            phi_5300_ = _e8676;
                                        } else {
                                            phi_5300_ = _e8680;
                                        }
                                        let _e8683 = phi_5300_;
                                        if (_e8659 > _e8683) {
                                            phi_5305_ = _e8659;
                                        } else {
                                            phi_5305_ = _e8683;
                                        }
                                        let _e8686 = phi_5305_;
                                        let _e8688 = local_18.member_3;
                                        let _e8692 = local_18.member_1[0u];
                                        if (_e8692[0] < 0.0lf) {
                                            phi_5322_ = -(_e8692[0]);
                                        } else {
                                            phi_5322_ = _e8692[0];
                                        }
                                        let _e8699 = phi_5322_;
                                        if (_e8692[1] < 0.0lf) {
                                            phi_5329_ = -(_e8692[1]);
                                        } else {
                                            phi_5329_ = _e8692[1];
                                        }
                                        let _e8703 = phi_5329_;
                                        if (_e8699 > _e8703) {
                                            phi_5334_ = _e8699;
                                        } else {
                                            phi_5334_ = _e8703;
                                        }
                                        let _e8706 = phi_5334_;
                                        if (_e8692[2] < 0.0lf) {
                                            phi_5341_ = -(_e8692[2]);
                                        } else {
                                            phi_5341_ = _e8692[2];
                                        }
                                        let _e8710 = phi_5341_;
                                        if (_e8706 > _e8710) {
                                            phi_5346_ = _e8706;
                                        } else {
                                            phi_5346_ = _e8710;
                                        }
                                        let _e8713 = phi_5346_;
                                        let _e8716 = local_18.member_1[1u];
                                        if (_e8716[0] < 0.0lf) {
                                            phi_5360_ = -(_e8716[0]);
                                        } else {
                                            phi_5360_ = _e8716[0];
                                        }
                                        let _e8723 = phi_5360_;
                                        if (_e8716[1] < 0.0lf) {
                                            phi_5367_ = -(_e8716[1]);
                                        } else {
                                            phi_5367_ = _e8716[1];
                                        }
                                        let _e8727 = phi_5367_;
                                        if (_e8723 > _e8727) {
                                            phi_5372_ = _e8723;
                                        } else {
                                            phi_5372_ = _e8727;
                                        }
                                        let _e8730 = phi_5372_;
                                        if (_e8716[2] < 0.0lf) {
                                            phi_5379_ = -(_e8716[2]);
                                        } else {
                                            phi_5379_ = _e8716[2];
                                        }
                                        let _e8734 = phi_5379_;
                                        if (_e8730 > _e8734) {
                                            phi_5384_ = _e8730;
                                        } else {
                                            phi_5384_ = _e8734;
                                        }
                                        let _e8737 = phi_5384_;
                                        if (_e8713 > _e8737) {
                                            phi_5389_ = _e8713;
                                        } else {
                                            phi_5389_ = _e8737;
                                        }
                                        let _e8740 = phi_5389_;
                                        let _e8742 = local_18.member_3;
                                        let _e8746 = local_18.member_2[0u];
                                        if (_e8746[0] < 0.0lf) {
                                            phi_5406_ = -(_e8746[0]);
                                        } else {
                                            phi_5406_ = _e8746[0];
                                        }
                                        let _e8753 = phi_5406_;
                                        if (_e8746[1] < 0.0lf) {
                                            phi_5413_ = -(_e8746[1]);
                                        } else {
                                            phi_5413_ = _e8746[1];
                                        }
                                        let _e8757 = phi_5413_;
                                        if (_e8753 > _e8757) {
                                            phi_5418_ = _e8753;
                                        } else {
                                            phi_5418_ = _e8757;
                                        }
                                        let _e8760 = phi_5418_;
                                        if (_e8746[2] < 0.0lf) {
                                            phi_5425_ = -(_e8746[2]);
                                        } else {
                                            phi_5425_ = _e8746[2];
                                        }
                                        let _e8764 = phi_5425_;
                                        if (_e8760 > _e8764) {
                                            phi_5430_ = _e8760;
                                        } else {
                                            phi_5430_ = _e8764;
                                        }
                                        let _e8767 = phi_5430_;
                                        let _e8770 = local_18.member_2[1u];
                                        if (_e8770[0] < 0.0lf) {
                                            phi_5444_ = -(_e8770[0]);
                                        } else {
                                            phi_5444_ = _e8770[0];
                                        }
                                        let _e8777 = phi_5444_;
                                        if (_e8770[1] < 0.0lf) {
                                            phi_5451_ = -(_e8770[1]);
                                        } else {
                                            phi_5451_ = _e8770[1];
                                        }
                                        let _e8781 = phi_5451_;
                                        if (_e8777 > _e8781) {
                                            phi_5456_ = _e8777;
                                        } else {
                                            phi_5456_ = _e8781;
                                        }
                                        let _e8784 = phi_5456_;
                                        if (_e8770[2] < 0.0lf) {
                                            phi_5463_ = -(_e8770[2]);
                                        } else {
                                            phi_5463_ = _e8770[2];
                                        }
                                        let _e8788 = phi_5463_;
                                        if (_e8784 > _e8788) {
                                            phi_5468_ = _e8784;
                                        } else {
                                            phi_5468_ = _e8788;
                                        }
                                        let _e8791 = phi_5468_;
                                        if (_e8767 > _e8791) {
                                            phi_5473_ = _e8767;
                                        } else {
                                            phi_5473_ = _e8791;
                                        }
                                        let _e8794 = phi_5473_;
                                        let _e8796 = local_18.member_3;
                                        let _e8804 = local_18.member_3;
                                        local_14 = type_44(array<array<array<f64, 3>, 4>, 2>(array<array<f64, 3>, 4>(_e8584, array<f64, 3>(_e8600, _e8601, _e8602), array<f64, 3>((_e8584[0] - _e8596[0]), (_e8584[1] - _e8596[1]), (_e8584[2] - _e8596[2])), array<f64, 3>((_e8600 - _e8596[0]), (_e8601 - _e8596[1]), (_e8602 - _e8596[2]))), array<array<f64, 3>, 4>(_e8611, array<f64, 3>(_e8627, _e8628, _e8629), array<f64, 3>((_e8611[0] - _e8623[0]), (_e8611[1] - _e8623[1]), (_e8611[2] - _e8623[2])), array<f64, 3>((_e8627 - _e8623[0]), (_e8628 - _e8623[1]), (_e8629 - _e8623[2])))), ((((((_e8686 + _e8688) + (_e8740 + _e8742)) + (_e8794 + _e8796)) * (1.1102230246251565e-16lf * f64(16f))) + (_e8804 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))), _e623.member_1);
                                        let _e8822 = local_14.member_1;
                                        if (_e8581 > _e8822) {
                                            if ((bitcast<u64>(_e8581) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e8828 = (f64(1f) / _e8581);
                                                let _e8830 = (_e8564[0] * _e8828);
                                                let _e8832 = (_e8564[1] * _e8828);
                                                let _e8834 = (_e8564[2] * _e8828);
                                                let _e8839 = (((_e8830 * _e8830) + (_e8832 * _e8832)) + (_e8834 * _e8834));
                                                if (_e8839 <= 2.2250738585072014e-308lf) {
                                                    if (_e8839 > 0.0lf) {
                                                        phi_5578_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_5578_ = 0.0lf;
                                                    }
                                                    let _e8891 = phi_5578_;
                                                    phi_5642_ = _e8891;
                                                } else {
                                                    phi_5585_ = type_16(0i, 5i);
                                                    phi_5588_ = bitcast<f64>(((bitcast<u64>(_e8839) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e8846 = phi_5585_;
                                                        let _e8848 = phi_5588_;
                                                        local_45 = _e8848;
                                                        if (_e8846.member < _e8846.member_1) {
                                                            let _e8855 = (_e8846.member + 1i);
                                                            if ((false == (_e8855 > _e8846.member)) != false) {
                                                                phi_5609_ = true;
                                                            } else {
                                                                phi_5609_ = false;
                                                            }
                                                            let _e8860 = phi_5609_;
                                                            if _e8860 {
                                                                phi_5615_ = type_17(0u, type_17().member_1);
                                                            } else {
                                                                phi_5615_ = type_17(1u, _e8855);
                                                            }
                                                            let _e8865 = phi_5615_;
                                                            phi_5586_ = type_16(_e8865.member_1, _e8846.member_1);
                                                            phi_5629_ = type_17(1u, _e8846.member);
                                                        } else {
                                                            phi_5586_ = _e8846;
                                                            phi_5629_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e8871 = phi_5586_;
                                                        let _e8873 = phi_5629_;
                                                        let _e8876 = (bitcast<i32>(_e8873.member) != 0i);
                                                        if _e8876 {
                                                            phi_5589_ = (0.5lf * (_e8848 + (_e8839 / _e8848)));
                                                        } else {
                                                            phi_5589_ = f64();
                                                        }
                                                        let _e8881 = phi_5589_;
                                                        continue;
                                                        continuing {
                                                            phi_5585_ = _e8871;
                                                            phi_5588_ = _e8881;
                                                            break if !(_e8876);
                                                        }
                                                    }
                                                    let _e8886 = local_45;
                                                    phi_5642_ = (_e8886 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e8893 = phi_5642_;
                                                let _e8895 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e8897 = local_14.member_1;
                                                let _e8901 = local_14.member_2;
                                                let _e8906 = ((_e8897 * f64(1.01f)) + ((_e8901 * _e8893) * (f64(1f) + _e8895)));
                                                let _e8910 = local_14.member[0u][0u];
                                                let _e8918 = (((_e8830 * _e8910[0]) + (_e8832 * _e8910[1])) + (_e8834 * _e8910[2]));
                                                let _e8922 = local_14.member[0u][1u];
                                                let _e8930 = (((_e8830 * _e8922[0]) + (_e8832 * _e8922[1])) + (_e8834 * _e8922[2]));
                                                let _e8934 = local_14.member[0u][2u];
                                                let _e8942 = (((_e8830 * _e8934[0]) + (_e8832 * _e8934[1])) + (_e8834 * _e8934[2]));
                                                let _e8946 = local_14.member[0u][3u];
                                                let _e8954 = (((_e8830 * _e8946[0]) + (_e8832 * _e8946[1])) + (_e8834 * _e8946[2]));
                                                let _e8958 = local_14.member[1u][0u];
                                                let _e8966 = (((_e8830 * _e8958[0]) + (_e8832 * _e8958[1])) + (_e8834 * _e8958[2]));
                                                let _e8970 = local_14.member[1u][1u];
                                                let _e8978 = (((_e8830 * _e8970[0]) + (_e8832 * _e8970[1])) + (_e8834 * _e8970[2]));
                                                let _e8982 = local_14.member[1u][2u];
                                                let _e8990 = (((_e8830 * _e8982[0]) + (_e8832 * _e8982[1])) + (_e8834 * _e8982[2]));
                                                let _e8994 = local_14.member[1u][3u];
                                                let _e9002 = (((_e8830 * _e8994[0]) + (_e8832 * _e8994[1])) + (_e8834 * _e8994[2]));
                                                if (_e8918 < 0.0lf) {
                                                    phi_5779_ = -(_e8918);
                                                } else {
                                                    phi_5779_ = _e8918;
                                                }
                                                let _e9006 = phi_5779_;
                                                if (_e8966 < 0.0lf) {
                                                    phi_5785_ = -(_e8966);
                                                } else {
                                                    phi_5785_ = _e8966;
                                                }
                                                let _e9010 = phi_5785_;
                                                if (_e8930 < 0.0lf) {
                                                    phi_5794_ = -(_e8930);
                                                } else {
                                                    phi_5794_ = _e8930;
                                                }
                                                let _e9017 = phi_5794_;
                                                if (_e8978 < 0.0lf) {
                                                    phi_5800_ = -(_e8978);
                                                } else {
                                                    phi_5800_ = _e8978;
                                                }
                                                let _e9021 = phi_5800_;
                                                if (_e8942 < 0.0lf) {
                                                    phi_5809_ = -(_e8942);
                                                } else {
                                                    phi_5809_ = _e8942;
                                                }
                                                let _e9028 = phi_5809_;
                                                if (_e8990 < 0.0lf) {
                                                    phi_5815_ = -(_e8990);
                                                } else {
                                                    phi_5815_ = _e8990;
                                                }
                                                let _e9032 = phi_5815_;
                                                if (_e8954 < 0.0lf) {
                                                    phi_5824_ = -(_e8954);
                                                } else {
                                                    phi_5824_ = _e8954;
                                                }
                                                let _e9039 = phi_5824_;
                                                if (_e9002 < 0.0lf) {
                                                    phi_5830_ = -(_e9002);
                                                } else {
                                                    phi_5830_ = _e9002;
                                                }
                                                let _e9043 = phi_5830_;
                                                local_15 = type_38(array<f64, 4>(_e8918, _e8930, _e8942, _e8954), array<f64, 4>(_e8966, _e8978, _e8990, _e9002), array<f64, 4>((_e8906 + ((_e9006 + _e9010) * _e8895)), (_e8906 + ((_e9017 + _e9021) * _e8895)), (_e8906 + ((_e9028 + _e9032) * _e8895)), (_e8906 + ((_e9039 + _e9043) * _e8895))));
                                                let _e9055 = (((_e8830 * _e8830) + (_e8832 * _e8832)) + (_e8834 * _e8834));
                                                if (_e9055 <= 2.2250738585072014e-308lf) {
                                                    if (_e9055 > 0.0lf) {
                                                        phi_5873_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_5873_ = 0.0lf;
                                                    }
                                                    let _e9107 = phi_5873_;
                                                    phi_5937_ = _e9107;
                                                } else {
                                                    phi_5880_ = type_16(0i, 5i);
                                                    phi_5883_ = bitcast<f64>(((bitcast<u64>(_e9055) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e9062 = phi_5880_;
                                                        let _e9064 = phi_5883_;
                                                        local_46 = _e9064;
                                                        if (_e9062.member < _e9062.member_1) {
                                                            let _e9071 = (_e9062.member + 1i);
                                                            if ((false == (_e9071 > _e9062.member)) != false) {
                                                                phi_5904_ = true;
                                                            } else {
                                                                phi_5904_ = false;
                                                            }
                                                            let _e9076 = phi_5904_;
                                                            if _e9076 {
                                                                phi_5910_ = type_17(0u, type_17().member_1);
                                                            } else {
                                                                phi_5910_ = type_17(1u, _e9071);
                                                            }
                                                            let _e9081 = phi_5910_;
                                                            phi_5881_ = type_16(_e9081.member_1, _e9062.member_1);
                                                            phi_5924_ = type_17(1u, _e9062.member);
                                                        } else {
                                                            phi_5881_ = _e9062;
                                                            phi_5924_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e9087 = phi_5881_;
                                                        let _e9089 = phi_5924_;
                                                        let _e9092 = (bitcast<i32>(_e9089.member) != 0i);
                                                        if _e9092 {
                                                            phi_5884_ = (0.5lf * (_e9064 + (_e9055 / _e9064)));
                                                        } else {
                                                            phi_5884_ = f64();
                                                        }
                                                        let _e9097 = phi_5884_;
                                                        continue;
                                                        continuing {
                                                            phi_5880_ = _e9087;
                                                            phi_5883_ = _e9097;
                                                            break if !(_e9092);
                                                        }
                                                    }
                                                    let _e9102 = local_46;
                                                    phi_5937_ = (_e9102 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e9109 = phi_5937_;
                                                let _e9120 = (((_e8564[0] * _e8564[0]) + (_e8564[1] * _e8564[1])) + (_e8564[2] * _e8564[2]));
                                                if (_e9120 <= 2.2250738585072014e-308lf) {
                                                    if (_e9120 > 0.0lf) {
                                                        phi_5962_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_5962_ = 0.0lf;
                                                    }
                                                    let _e9172 = phi_5962_;
                                                    phi_6026_ = _e9172;
                                                } else {
                                                    phi_5969_ = type_16(0i, 5i);
                                                    phi_5972_ = bitcast<f64>(((bitcast<u64>(_e9120) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e9127 = phi_5969_;
                                                        let _e9129 = phi_5972_;
                                                        local_47 = _e9129;
                                                        if (_e9127.member < _e9127.member_1) {
                                                            let _e9136 = (_e9127.member + 1i);
                                                            if ((false == (_e9136 > _e9127.member)) != false) {
                                                                phi_5993_ = true;
                                                            } else {
                                                                phi_5993_ = false;
                                                            }
                                                            let _e9141 = phi_5993_;
                                                            if _e9141 {
                                                                phi_5999_ = type_17(0u, type_17().member_1);
                                                            } else {
                                                                phi_5999_ = type_17(1u, _e9136);
                                                            }
                                                            let _e9146 = phi_5999_;
                                                            phi_5970_ = type_16(_e9146.member_1, _e9127.member_1);
                                                            phi_6013_ = type_17(1u, _e9127.member);
                                                        } else {
                                                            phi_5970_ = _e9127;
                                                            phi_6013_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e9152 = phi_5970_;
                                                        let _e9154 = phi_6013_;
                                                        let _e9157 = (bitcast<i32>(_e9154.member) != 0i);
                                                        if _e9157 {
                                                            phi_5973_ = (0.5lf * (_e9129 + (_e9120 / _e9129)));
                                                        } else {
                                                            phi_5973_ = f64();
                                                        }
                                                        let _e9162 = phi_5973_;
                                                        continue;
                                                        continuing {
                                                            phi_5969_ = _e9152;
                                                            phi_5972_ = _e9162;
                                                            break if !(_e9157);
                                                        }
                                                    }
                                                    let _e9167 = local_47;
                                                    phi_6026_ = (_e9167 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e9174 = phi_6026_;
                                                let _e9182 = local_18.member[0u];
                                                if (_e9182[0] < 0.0lf) {
                                                    phi_6044_ = -(_e9182[0]);
                                                } else {
                                                    phi_6044_ = _e9182[0];
                                                }
                                                let _e9189 = phi_6044_;
                                                if (_e9182[1] < 0.0lf) {
                                                    phi_6051_ = -(_e9182[1]);
                                                } else {
                                                    phi_6051_ = _e9182[1];
                                                }
                                                let _e9193 = phi_6051_;
                                                if (_e9189 > _e9193) {
                                                    phi_6056_ = _e9189;
                                                } else {
                                                    phi_6056_ = _e9193;
                                                }
                                                let _e9196 = phi_6056_;
                                                if (_e9182[2] < 0.0lf) {
                                                    phi_6063_ = -(_e9182[2]);
                                                } else {
                                                    phi_6063_ = _e9182[2];
                                                }
                                                let _e9200 = phi_6063_;
                                                if (_e9196 > _e9200) {
                                                    phi_6068_ = _e9196;
                                                } else {
                                                    phi_6068_ = _e9200;
                                                }
                                                let _e9203 = phi_6068_;
                                                let _e9206 = local_18.member[1u];
                                                if (_e9206[0] < 0.0lf) {
                                                    phi_6081_ = -(_e9206[0]);
                                                } else {
                                                    phi_6081_ = _e9206[0];
                                                }
                                                let _e9213 = phi_6081_;
                                                if (_e9206[1] < 0.0lf) {
                                                    phi_6088_ = -(_e9206[1]);
                                                } else {
                                                    phi_6088_ = _e9206[1];
                                                }
                                                let _e9217 = phi_6088_;
                                                if (_e9213 > _e9217) {
                                                    phi_6093_ = _e9213;
                                                } else {
                                                    phi_6093_ = _e9217;
                                                }
                                                let _e9220 = phi_6093_;
                                                if (_e9206[2] < 0.0lf) {
                                                    phi_6100_ = -(_e9206[2]);
                                                } else {
                                                    phi_6100_ = _e9206[2];
                                                }
                                                let _e9224 = phi_6100_;
                                                if (_e9220 > _e9224) {
                                                    phi_6105_ = _e9220;
                                                } else {
                                                    phi_6105_ = _e9224;
                                                }
                                                let _e9227 = phi_6105_;
                                                if (_e9203 > _e9227) {
                                                    phi_6110_ = _e9203;
                                                } else {
                                                    phi_6110_ = _e9227;
                                                }
                                                let _e9230 = phi_6110_;
                                                let _e9232 = local_18.member_3;
                                                let _e9236 = local_18.member_1[0u];
                                                if (_e9236[0] < 0.0lf) {
                                                    phi_6127_ = -(_e9236[0]);
                                                } else {
                                                    phi_6127_ = _e9236[0];
                                                }
                                                let _e9243 = phi_6127_;
                                                if (_e9236[1] < 0.0lf) {
                                                    phi_6134_ = -(_e9236[1]);
                                                } else {
                                                    phi_6134_ = _e9236[1];
                                                }
                                                let _e9247 = phi_6134_;
                                                if (_e9243 > _e9247) {
                                                    phi_6139_ = _e9243;
                                                } else {
                                                    phi_6139_ = _e9247;
                                                }
                                                let _e9250 = phi_6139_;
                                                if (_e9236[2] < 0.0lf) {
                                                    phi_6146_ = -(_e9236[2]);
                                                } else {
                                                    phi_6146_ = _e9236[2];
                                                }
                                                let _e9254 = phi_6146_;
                                                if (_e9250 > _e9254) {
                                                    phi_6151_ = _e9250;
                                                } else {
                                                    phi_6151_ = _e9254;
                                                }
                                                let _e9257 = phi_6151_;
                                                let _e9260 = local_18.member_1[1u];
                                                if (_e9260[0] < 0.0lf) {
                                                    phi_6165_ = -(_e9260[0]);
                                                } else {
                                                    phi_6165_ = _e9260[0];
                                                }
                                                let _e9267 = phi_6165_;
                                                if (_e9260[1] < 0.0lf) {
                                                    phi_6172_ = -(_e9260[1]);
                                                } else {
                                                    phi_6172_ = _e9260[1];
                                                }
                                                let _e9271 = phi_6172_;
                                                if (_e9267 > _e9271) {
                                                    phi_6177_ = _e9267;
                                                } else {
                                                    phi_6177_ = _e9271;
                                                }
                                                let _e9274 = phi_6177_;
                                                if (_e9260[2] < 0.0lf) {
                                                    phi_6184_ = -(_e9260[2]);
                                                } else {
                                                    phi_6184_ = _e9260[2];
                                                }
                                                let _e9278 = phi_6184_;
                                                if (_e9274 > _e9278) {
                                                    phi_6189_ = _e9274;
                                                } else {
                                                    phi_6189_ = _e9278;
                                                }
                                                let _e9281 = phi_6189_;
                                                if (_e9257 > _e9281) {
                                                    phi_6194_ = _e9257;
                                                } else {
                                                    phi_6194_ = _e9281;
                                                }
                                                let _e9284 = phi_6194_;
                                                let _e9286 = local_18.member_3;
                                                let _e9290 = local_18.member_2[0u];
                                                if (_e9290[0] < 0.0lf) {
                                                    phi_6211_ = -(_e9290[0]);
                                                } else {
                                                    phi_6211_ = _e9290[0];
                                                }
                                                let _e9297 = phi_6211_;
                                                if (_e9290[1] < 0.0lf) {
                                                    phi_6218_ = -(_e9290[1]);
                                                } else {
                                                    phi_6218_ = _e9290[1];
                                                }
                                                let _e9301 = phi_6218_;
                                                if (_e9297 > _e9301) {
                                                    phi_6223_ = _e9297;
                                                } else {
                                                    phi_6223_ = _e9301;
                                                }
                                                let _e9304 = phi_6223_;
                                                if (_e9290[2] < 0.0lf) {
                                                    phi_6230_ = -(_e9290[2]);
                                                } else {
                                                    phi_6230_ = _e9290[2];
                                                }
                                                let _e9308 = phi_6230_;
                                                if (_e9304 > _e9308) {
                                                    phi_6235_ = _e9304;
                                                } else {
                                                    phi_6235_ = _e9308;
                                                }
                                                let _e9311 = phi_6235_;
                                                let _e9314 = local_18.member_2[1u];
                                                if (_e9314[0] < 0.0lf) {
                                                    phi_6249_ = -(_e9314[0]);
                                                } else {
                                                    phi_6249_ = _e9314[0];
                                                }
                                                let _e9321 = phi_6249_;
                                                if (_e9314[1] < 0.0lf) {
                                                    phi_6256_ = -(_e9314[1]);
                                                } else {
                                                    phi_6256_ = _e9314[1];
                                                }
                                                let _e9325 = phi_6256_;
                                                if (_e9321 > _e9325) {
                                                    phi_6261_ = _e9321;
                                                } else {
                                                    phi_6261_ = _e9325;
                                                }
                                                let _e9328 = phi_6261_;
                                                if (_e9314[2] < 0.0lf) {
                                                    phi_6268_ = -(_e9314[2]);
                                                } else {
                                                    phi_6268_ = _e9314[2];
                                                }
                                                let _e9332 = phi_6268_;
                                                if (_e9328 > _e9332) {
                                                    phi_6273_ = _e9328;
                                                } else {
                                                    phi_6273_ = _e9332;
                                                }
                                                let _e9335 = phi_6273_;
                                                if (_e9311 > _e9335) {
                                                    phi_6278_ = _e9311;
                                                } else {
                                                    phi_6278_ = _e9335;
                                                }
                                                let _e9338 = phi_6278_;
                                                let _e9340 = local_18.member_3;
                                                let _e9348 = local_18.member_3;
                                                let _e9363 = ((((_e9174 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e9230 + _e9232) + (_e9284 + _e9286)) + (_e9338 + _e9340)) * (1.1102230246251565e-16lf * f64(16f))) + (_e9348 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) * _e9109) * (f64(1f) + (1.1102230246251565e-16lf * f64(64f))));
                                                let _e9366 = local_15.member[0u];
                                                let _e9369 = local_15.member_1[0u];
                                                if (_e9366 < 0.0lf) {
                                                    phi_6326_ = -(_e9366);
                                                } else {
                                                    phi_6326_ = _e9366;
                                                }
                                                let _e9375 = phi_6326_;
                                                if (_e9369 < 0.0lf) {
                                                    phi_6332_ = -(_e9369);
                                                } else {
                                                    phi_6332_ = _e9369;
                                                }
                                                let _e9379 = phi_6332_;
                                                phi_6344_ = type_12(1u, 4u);
                                                phi_6347_ = ((_e9366 + ((_e9369 - _e9366) * _e6647)) - ((_e8822 * f64(1.01f)) + ((_e9375 + _e9379) * (1.1102230246251565e-16lf * f64(12f)))));
                                                loop {
                                                    let _e9390 = phi_6344_;
                                                    let _e9392 = phi_6347_;
                                                    local_48 = _e9392;
                                                    local_49 = _e9392;
                                                    if (_e9390.member < _e9390.member_1) {
                                                        phi_6345_ = type_12((_e9390.member + 1u), _e9390.member_1);
                                                        phi_6370_ = type_12(1u, _e9390.member);
                                                    } else {
                                                        phi_6345_ = _e9390;
                                                        phi_6370_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e9404 = phi_6345_;
                                                    let _e9406 = phi_6370_;
                                                    let _e9410 = (bitcast<i32>(_e9406.member) != 0i);
                                                    if _e9410 {
                                                        let _e9413 = local_15.member[_e9406.member_1];
                                                        let _e9416 = local_15.member_1[_e9406.member_1];
                                                        if (_e9413 < 0.0lf) {
                                                            phi_6400_ = -(_e9413);
                                                        } else {
                                                            phi_6400_ = _e9413;
                                                        }
                                                        let _e9422 = phi_6400_;
                                                        if (_e9416 < 0.0lf) {
                                                            phi_6406_ = -(_e9416);
                                                        } else {
                                                            phi_6406_ = _e9416;
                                                        }
                                                        let _e9426 = phi_6406_;
                                                        let _e9435 = ((_e9413 + ((_e9416 - _e9413) * _e6647)) - ((_e8822 * f64(1.01f)) + ((_e9422 + _e9426) * (1.1102230246251565e-16lf * f64(12f)))));
                                                        if (_e9392 < _e9435) {
                                                            phi_6420_ = _e9392;
                                                        } else {
                                                            phi_6420_ = _e9435;
                                                        }
                                                        let _e9438 = phi_6420_;
                                                        phi_6348_ = _e9438;
                                                    } else {
                                                        phi_6348_ = f64();
                                                    }
                                                    let _e9440 = phi_6348_;
                                                    continue;
                                                    continuing {
                                                        phi_6344_ = _e9404;
                                                        phi_6347_ = _e9440;
                                                        break if !(_e9410);
                                                    }
                                                }
                                                let _e9443 = local_48;
                                                if (_e9443 > f64(0f)) {
                                                    let _e9448 = local_49;
                                                    let _e9452 = (((_e9363 - _e9448) / _e9363) * f64(2.02f));
                                                    if (_e9452 <= 2.2250738585072014e-308lf) {
                                                        if (_e9452 > 0.0lf) {
                                                            phi_6442_ = (1.464336215552873e-154lf * 2.0lf);
                                                        } else {
                                                            phi_6442_ = 0.0lf;
                                                        }
                                                        let _e9504 = phi_6442_;
                                                        phi_6506_ = _e9504;
                                                    } else {
                                                        phi_6449_ = type_16(0i, 5i);
                                                        phi_6452_ = bitcast<f64>(((bitcast<u64>(_e9452) / 2lu) + 2303426169912950784lu));
                                                        loop {
                                                            let _e9459 = phi_6449_;
                                                            let _e9461 = phi_6452_;
                                                            local_50 = _e9461;
                                                            if (_e9459.member < _e9459.member_1) {
                                                                let _e9468 = (_e9459.member + 1i);
                                                                if ((false == (_e9468 > _e9459.member)) != false) {
                                                                    phi_6473_ = true;
                                                                } else {
                                                                    phi_6473_ = false;
                                                                }
                                                                let _e9473 = phi_6473_;
                                                                if _e9473 {
                                                                    phi_6479_ = type_17(0u, type_17().member_1);
                                                                } else {
                                                                    phi_6479_ = type_17(1u, _e9468);
                                                                }
                                                                let _e9478 = phi_6479_;
                                                                phi_6450_ = type_16(_e9478.member_1, _e9459.member_1);
                                                                phi_6493_ = type_17(1u, _e9459.member);
                                                            } else {
                                                                phi_6450_ = _e9459;
                                                                phi_6493_ = type_17(0u, type_17().member_1);
                                                            }
                                                            let _e9484 = phi_6450_;
                                                            let _e9486 = phi_6493_;
                                                            let _e9489 = (bitcast<i32>(_e9486.member) != 0i);
                                                            if _e9489 {
                                                                phi_6453_ = (0.5lf * (_e9461 + (_e9452 / _e9461)));
                                                            } else {
                                                                phi_6453_ = f64();
                                                            }
                                                            let _e9494 = phi_6453_;
                                                            continue;
                                                            continuing {
                                                                phi_6449_ = _e9484;
                                                                phi_6452_ = _e9494;
                                                                break if !(_e9489);
                                                            }
                                                        }
                                                        let _e9499 = local_50;
                                                        phi_6506_ = (_e9499 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                    }
                                                    let _e9506 = phi_6506_;
                                                    let _e9509 = ((_e9506 * _e9109) * f64(1.01f));
                                                    phi_6513_ = type_12(0u, 4u);
                                                    phi_6516_ = f64(2f);
                                                    phi_6518_ = true;
                                                    phi_6520_ = true;
                                                    loop {
                                                        let _e9512 = phi_6513_;
                                                        let _e9514 = phi_6516_;
                                                        let _e9516 = phi_6518_;
                                                        let _e9518 = phi_6520_;
                                                        local_51 = _e9514;
                                                        local_90 = _e9514;
                                                        local_52 = _e9516;
                                                        local_53 = _e9518;
                                                        local_91 = _e9518;
                                                        local_54 = _e9518;
                                                        if (_e9512.member < _e9512.member_1) {
                                                            phi_6514_ = type_12((_e9512.member + 1u), _e9512.member_1);
                                                            phi_6543_ = type_12(1u, _e9512.member);
                                                        } else {
                                                            phi_6514_ = _e9512;
                                                            phi_6543_ = type_12(0u, type_12().member_1);
                                                        }
                                                        let _e9530 = phi_6514_;
                                                        let _e9532 = phi_6543_;
                                                        let _e9536 = (bitcast<i32>(_e9532.member) != 0i);
                                                        if _e9536 {
                                                            let _e9540 = local_14.member[0u][_e9532.member_1];
                                                            let _e9547 = local_14.member[1u][_e9532.member_1];
                                                            if (_e9540[0] < 0.0lf) {
                                                                phi_6580_ = -(_e9540[0]);
                                                            } else {
                                                                phi_6580_ = _e9540[0];
                                                            }
                                                            let _e9554 = phi_6580_;
                                                            if (_e9540[1] < 0.0lf) {
                                                                phi_6587_ = -(_e9540[1]);
                                                            } else {
                                                                phi_6587_ = _e9540[1];
                                                            }
                                                            let _e9558 = phi_6587_;
                                                            if (_e9540[2] < 0.0lf) {
                                                                phi_6595_ = -(_e9540[2]);
                                                            } else {
                                                                phi_6595_ = _e9540[2];
                                                            }
                                                            let _e9563 = phi_6595_;
                                                            let _e9564 = ((_e9554 + _e9558) + _e9563);
                                                            if (_e9547[0] < 0.0lf) {
                                                                phi_6603_ = -(_e9547[0]);
                                                            } else {
                                                                phi_6603_ = _e9547[0];
                                                            }
                                                            let _e9568 = phi_6603_;
                                                            if (_e9547[1] < 0.0lf) {
                                                                phi_6610_ = -(_e9547[1]);
                                                            } else {
                                                                phi_6610_ = _e9547[1];
                                                            }
                                                            let _e9572 = phi_6610_;
                                                            if (_e9547[2] < 0.0lf) {
                                                                phi_6618_ = -(_e9547[2]);
                                                            } else {
                                                                phi_6618_ = _e9547[2];
                                                            }
                                                            let _e9577 = phi_6618_;
                                                            let _e9578 = ((_e9568 + _e9572) + _e9577);
                                                            if (_e9564 > _e9578) {
                                                                phi_6624_ = _e9564;
                                                            } else {
                                                                phi_6624_ = _e9578;
                                                            }
                                                            let _e9581 = phi_6624_;
                                                            let _e9587 = (_e9547[0] - _e9540[0]);
                                                            let _e9588 = (_e9547[1] - _e9540[1]);
                                                            let _e9589 = (_e9547[2] - _e9540[2]);
                                                            if (_e9587 < 0.0lf) {
                                                                phi_6644_ = -(_e9587);
                                                            } else {
                                                                phi_6644_ = _e9587;
                                                            }
                                                            let _e9593 = phi_6644_;
                                                            if (_e9588 < 0.0lf) {
                                                                phi_6650_ = -(_e9588);
                                                            } else {
                                                                phi_6650_ = _e9588;
                                                            }
                                                            let _e9597 = phi_6650_;
                                                            if (_e9589 < 0.0lf) {
                                                                phi_6657_ = -(_e9589);
                                                            } else {
                                                                phi_6657_ = _e9589;
                                                            }
                                                            let _e9602 = phi_6657_;
                                                            let _e9611 = local_15.member[_e9532.member_1];
                                                            let _e9614 = local_15.member_1[_e9532.member_1];
                                                            if (_e9611 < 0.0lf) {
                                                                phi_6686_ = -(_e9611);
                                                            } else {
                                                                phi_6686_ = _e9611;
                                                            }
                                                            let _e9620 = phi_6686_;
                                                            if (_e9614 < 0.0lf) {
                                                                phi_6692_ = -(_e9614);
                                                            } else {
                                                                phi_6692_ = _e9614;
                                                            }
                                                            let _e9624 = phi_6692_;
                                                            let _e9629 = ((_e8822 * f64(1.01f)) + ((_e9620 + _e9624) * (1.1102230246251565e-16lf * f64(12f))));
                                                            let _e9636 = local_15.member_1[_e9532.member_1];
                                                            let _e9639 = local_15.member[_e9532.member_1];
                                                            let _e9640 = (_e9636 - _e9639);
                                                            let _e9643 = ((_e9629 + _e9629) + (_e9509 * ((((_e9593 + _e9597) + _e9602) + (_e8822 * f64(6f))) * f64(1.01f))));
                                                            let _e9646 = ((((_e9611 + ((_e9614 - _e9611) * _e6647)) - _e9629) - (_e9509 * ((_e9581 + (_e8822 * f64(3f))) * f64(1.01f)))) - _e9363);
                                                            let _e9647 = (_e9646 > 2.2250738585072014e-308lf);
                                                            let _e9648 = (_e9640 > _e9643);
                                                            if _e9648 {
                                                                phi_6729_ = true;
                                                            } else {
                                                                phi_6729_ = _e9647;
                                                            }
                                                            let _e9650 = phi_6729_;
                                                            if (_e9640 < -(_e9643)) {
                                                                phi_6736_ = true;
                                                            } else {
                                                                phi_6736_ = _e9647;
                                                            }
                                                            let _e9655 = phi_6736_;
                                                            if _e9648 {
                                                                phi_6757_ = _e9514;
                                                            } else {
                                                                if _e9647 {
                                                                    let _e9657 = (_e9643 - _e9640);
                                                                    if (_e9657 > 2.2250738585072014e-308lf) {
                                                                        phi_6749_ = _e9657;
                                                                    } else {
                                                                        phi_6749_ = 2.2250738585072014e-308lf;
                                                                    }
                                                                    let _e9660 = phi_6749_;
                                                                    let _e9661 = (_e9646 / _e9660);
                                                                    if (_e9514 < _e9661) {
                                                                        phi_6755_ = _e9514;
                                                                    } else {
                                                                        phi_6755_ = _e9661;
                                                                    }
                                                                    let _e9664 = phi_6755_;
                                                                    phi_6756_ = _e9664;
                                                                } else {
                                                                    phi_6756_ = _e9514;
                                                                }
                                                                let _e9666 = phi_6756_;
                                                                phi_6757_ = _e9666;
                                                            }
                                                            let _e9668 = phi_6757_;
                                                            phi_6517_ = _e9668;
                                                            phi_6519_ = (_e9516 && _e9655);
                                                            phi_6521_ = (_e9518 && _e9650);
                                                        } else {
                                                            phi_6517_ = f64();
                                                            phi_6519_ = bool();
                                                            phi_6521_ = bool();
                                                        }
                                                        let _e9670 = phi_6517_;
                                                        let _e9672 = phi_6519_;
                                                        let _e9674 = phi_6521_;
                                                        continue;
                                                        continuing {
                                                            phi_6513_ = _e9530;
                                                            phi_6516_ = _e9670;
                                                            phi_6518_ = _e9672;
                                                            phi_6520_ = _e9674;
                                                            break if !(_e9536);
                                                        }
                                                    }
                                                    let _e9676 = f64(2f);
                                                    let _e9678 = local_51;
                                                    if (_e9678 < _e9676) {
                                                        let _e12100 = local_90;
                                                        phi_6763_ = _e12100;
                                                    } else {
                                                        phi_6763_ = _e9676;
                                                    }
                                                    let _e9681 = phi_6763_;
                                                    let _e9683 = (_e9681 * f64(0.999f));
                                                    let _e9685 = local_52;
                                                    if _e9685 {
                                                        let _e9687 = local_53;
                                                        if _e9687 {
                                                            phi_6774_ = type_48();
                                                        } else {
                                                            phi_6774_ = type_48(_e6647, f64(2f), 1u);
                                                        }
                                                        let _e9691 = phi_6774_;
                                                        phi_6775_ = _e9691;
                                                        let _e12107 = local_91;
                                                        phi_6776_ = _e12107;
                                                    } else {
                                                        phi_6775_ = type_48();
                                                        phi_6776_ = true;
                                                    }
                                                    let _e9693 = phi_6775_;
                                                    let _e9695 = phi_6776_;
                                                    if _e9695 {
                                                        let _e9697 = local_54;
                                                        if _e9697 {
                                                            if (_e9683 > (1.1102230246251565e-16lf * f64(4096f))) {
                                                                let _e9703 = (_e6647 + _e9683);
                                                                if (_e9703 < _e422) {
                                                                    phi_6794_ = _e9703;
                                                                } else {
                                                                    phi_6794_ = _e422;
                                                                }
                                                                let _e9706 = phi_6794_;
                                                                phi_6795_ = _e9706;
                                                            } else {
                                                                phi_6795_ = _e6647;
                                                            }
                                                            let _e9708 = phi_6795_;
                                                            phi_6798_ = type_12(0u, 4u);
                                                            phi_6801_ = _e9708;
                                                            phi_6803_ = _e6647;
                                                            loop {
                                                                let _e9710 = phi_6798_;
                                                                let _e9712 = phi_6801_;
                                                                let _e9714 = phi_6803_;
                                                                local_55 = _e9712;
                                                                local_56 = _e9714;
                                                                local_57 = _e9714;
                                                                if (_e9710.member < _e9710.member_1) {
                                                                    phi_6799_ = type_12((_e9710.member + 1u), _e9710.member_1);
                                                                    phi_6826_ = type_12(1u, _e9710.member);
                                                                } else {
                                                                    phi_6799_ = _e9710;
                                                                    phi_6826_ = type_12(0u, type_12().member_1);
                                                                }
                                                                let _e9726 = phi_6799_;
                                                                let _e9728 = phi_6826_;
                                                                let _e9732 = (bitcast<i32>(_e9728.member) != 0i);
                                                                if _e9732 {
                                                                    let _e9735 = local_15.member[_e9728.member_1];
                                                                    let _e9738 = local_15.member_1[_e9728.member_1];
                                                                    let _e9741 = local_15.member[_e9728.member_1];
                                                                    let _e9747 = local_15.member_2[_e9728.member_1];
                                                                    let _e9748 = ((_e9735 + ((_e9738 - _e9741) * _e6647)) - _e9747);
                                                                    let _e9751 = local_15.member_1[_e9728.member_1];
                                                                    let _e9754 = local_15.member[_e9728.member_1];
                                                                    let _e9755 = (_e9751 - _e9754);
                                                                    if (_e9755 > f64(0f)) {
                                                                        let _e9772 = (_e6647 - (_e9748 / _e9755));
                                                                        if (_e9714 > _e9772) {
                                                                            phi_6895_ = _e9714;
                                                                        } else {
                                                                            phi_6895_ = _e9772;
                                                                        }
                                                                        let _e9775 = phi_6895_;
                                                                        phi_6915_ = _e9712;
                                                                        phi_6916_ = _e9775;
                                                                    } else {
                                                                        if (_e9748 > f64(0f)) {
                                                                            if (_e9755 < f64(0f)) {
                                                                                let _e9763 = (_e6647 - (_e9748 / _e9755));
                                                                                if (_e9712 < _e9763) {
                                                                                    phi_6912_ = _e9712;
                                                                                } else {
                                                                                    phi_6912_ = _e9763;
                                                                                }
                                                                                let _e9766 = phi_6912_;
                                                                                phi_6913_ = _e9766;
                                                                            } else {
                                                                                phi_6913_ = _e9712;
                                                                            }
                                                                            let _e9768 = phi_6913_;
                                                                            phi_6914_ = _e9768;
                                                                        } else {
                                                                            phi_6914_ = _e9712;
                                                                        }
                                                                        let _e9770 = phi_6914_;
                                                                        phi_6915_ = _e9770;
                                                                        phi_6916_ = _e9714;
                                                                    }
                                                                    let _e9777 = phi_6915_;
                                                                    let _e9779 = phi_6916_;
                                                                    phi_6802_ = _e9777;
                                                                    phi_6804_ = _e9779;
                                                                } else {
                                                                    phi_6802_ = f64();
                                                                    phi_6804_ = f64();
                                                                }
                                                                let _e9781 = phi_6802_;
                                                                let _e9783 = phi_6804_;
                                                                continue;
                                                                continuing {
                                                                    phi_6798_ = _e9726;
                                                                    phi_6801_ = _e9781;
                                                                    phi_6803_ = _e9783;
                                                                    break if !(_e9732);
                                                                }
                                                            }
                                                            let _e9786 = local_55;
                                                            let _e9788 = local_56;
                                                            let _e9793 = local_57;
                                                            let _e9794 = (_e9793 + ((_e9786 - _e9788) * f64(0.5f)));
                                                            if (_e9794 > _e6647) {
                                                                if (_e9794 <= _e9708) {
                                                                    let _e9797 = f64(0f);
                                                                    let _e9800 = local_15.member[0u];
                                                                    let _e9803 = local_15.member_1[0u];
                                                                    let _e9806 = local_15.member[0u];
                                                                    let _e9812 = local_15.member_2[0u];
                                                                    if (((_e9800 + ((_e9803 - _e9806) * _e9794)) - _e9812) > _e9797) {
                                                                        let _e9817 = local_15.member[1u];
                                                                        let _e9820 = local_15.member_1[1u];
                                                                        let _e9823 = local_15.member[1u];
                                                                        let _e9829 = local_15.member_2[1u];
                                                                        if (((_e9817 + ((_e9820 - _e9823) * _e9794)) - _e9829) > _e9797) {
                                                                            let _e9834 = local_15.member[2u];
                                                                            let _e9837 = local_15.member_1[2u];
                                                                            let _e9840 = local_15.member[2u];
                                                                            let _e9846 = local_15.member_2[2u];
                                                                            if (((_e9834 + ((_e9837 - _e9840) * _e9794)) - _e9846) > _e9797) {
                                                                                let _e9851 = local_15.member[3u];
                                                                                let _e9854 = local_15.member_1[3u];
                                                                                let _e9857 = local_15.member[3u];
                                                                                let _e9863 = local_15.member_2[3u];
                                                                                phi_7079_ = (((_e9851 + ((_e9854 - _e9857) * _e9794)) - _e9863) > _e9797);
                                                                                phi_7080_ = false;
                                                                            } else {
                                                                                phi_7079_ = bool();
                                                                                phi_7080_ = true;
                                                                            }
                                                                            let _e9867 = phi_7079_;
                                                                            let _e9869 = phi_7080_;
                                                                            phi_7081_ = _e9867;
                                                                            phi_7082_ = _e9869;
                                                                        } else {
                                                                            phi_7081_ = bool();
                                                                            phi_7082_ = true;
                                                                        }
                                                                        let _e9871 = phi_7081_;
                                                                        let _e9873 = phi_7082_;
                                                                        phi_7083_ = _e9871;
                                                                        phi_7084_ = _e9873;
                                                                    } else {
                                                                        phi_7083_ = bool();
                                                                        phi_7084_ = true;
                                                                    }
                                                                    let _e9875 = phi_7083_;
                                                                    let _e9877 = phi_7084_;
                                                                    if _e9877 {
                                                                        phi_7088_ = false;
                                                                    } else {
                                                                        phi_7088_ = _e9875;
                                                                    }
                                                                    let _e9879 = phi_7088_;
                                                                    if _e9879 {
                                                                        phi_7092_ = false;
                                                                    } else {
                                                                        phi_7092_ = true;
                                                                    }
                                                                    let _e9881 = phi_7092_;
                                                                    phi_7093_ = _e9881;
                                                                } else {
                                                                    phi_7093_ = true;
                                                                }
                                                                let _e9883 = phi_7093_;
                                                                phi_7094_ = _e9883;
                                                            } else {
                                                                phi_7094_ = true;
                                                            }
                                                            let _e9885 = phi_7094_;
                                                            if _e9885 {
                                                                phi_7099_ = f64(2f);
                                                            } else {
                                                                phi_7099_ = _e9794;
                                                            }
                                                            let _e9888 = phi_7099_;
                                                            phi_7103_ = type_48(_e9708, _e9888, 2u);
                                                            phi_7104_ = type_48();
                                                            phi_7105_ = false;
                                                        } else {
                                                            phi_7103_ = type_48();
                                                            phi_7104_ = type_48(_e6647, f64(2f), 0u);
                                                            phi_7105_ = true;
                                                        }
                                                        let _e9891 = phi_7103_;
                                                        let _e9893 = phi_7104_;
                                                        let _e9895 = phi_7105_;
                                                        phi_7106_ = _e9891;
                                                        phi_7107_ = _e9893;
                                                        phi_7108_ = _e9895;
                                                    } else {
                                                        phi_7106_ = type_48();
                                                        phi_7107_ = _e9693;
                                                        phi_7108_ = true;
                                                    }
                                                    let _e9897 = phi_7106_;
                                                    let _e9899 = phi_7107_;
                                                    let _e9901 = phi_7108_;
                                                    phi_7114_ = _e9899;
                                                    phi_7115_ = _e9897;
                                                    phi_7116_ = _e9901;
                                                } else {
                                                    phi_7114_ = type_48(_e6647, f64(2f), 0u);
                                                    phi_7115_ = type_48();
                                                    phi_7116_ = true;
                                                }
                                                let _e9903 = phi_7114_;
                                                let _e9905 = phi_7115_;
                                                let _e9907 = phi_7116_;
                                                phi_7120_ = _e9903;
                                                phi_7121_ = _e9905;
                                                phi_7122_ = false;
                                                phi_7123_ = _e9907;
                                            } else {
                                                phi_7120_ = type_48();
                                                phi_7121_ = type_48();
                                                phi_7122_ = true;
                                                phi_7123_ = false;
                                            }
                                            let _e9909 = phi_7120_;
                                            let _e9911 = phi_7121_;
                                            let _e9913 = phi_7122_;
                                            let _e9915 = phi_7123_;
                                            phi_7124_ = _e9909;
                                            phi_7125_ = _e9911;
                                            phi_7126_ = _e9913;
                                            phi_7127_ = _e9915;
                                        } else {
                                            phi_7124_ = type_48();
                                            phi_7125_ = type_48();
                                            phi_7126_ = true;
                                            phi_7127_ = false;
                                        }
                                        let _e9917 = phi_7124_;
                                        let _e9919 = phi_7125_;
                                        let _e9921 = phi_7126_;
                                        let _e9923 = phi_7127_;
                                        if _e9921 {
                                            phi_7133_ = type_48(_e6647, f64(2f), 0u);
                                            phi_7134_ = true;
                                        } else {
                                            phi_7133_ = _e9917;
                                            phi_7134_ = _e9923;
                                        }
                                        let _e9927 = phi_7133_;
                                        let _e9929 = phi_7134_;
                                        if _e9929 {
                                            phi_7138_ = _e9927;
                                        } else {
                                            phi_7138_ = _e9919;
                                        }
                                        let _e9931 = phi_7138_;
                                        if ((_e424 & 64u) != 0u) {
                                            if (_e9931.member_2 == 2u) {
                                                let _e9935 = (_e9931.member_1 <= _e422);
                                                if _e9935 {
                                                    phi_7154_ = _e9931.member_1;
                                                    phi_7155_ = _e9931.member_1;
                                                    phi_7156_ = false;
                                                } else {
                                                    phi_7154_ = f64();
                                                    phi_7155_ = f64();
                                                    phi_7156_ = true;
                                                }
                                                let _e9939 = phi_7154_;
                                                let _e9941 = phi_7155_;
                                                let _e9943 = phi_7156_;
                                                phi_7157_ = _e9939;
                                                phi_7158_ = _e9941;
                                                phi_7159_ = _e9935;
                                                phi_7160_ = _e9943;
                                                phi_7161_ = false;
                                            } else {
                                                phi_7157_ = f64();
                                                phi_7158_ = f64();
                                                phi_7159_ = false;
                                                phi_7160_ = false;
                                                phi_7161_ = true;
                                            }
                                            let _e9945 = phi_7157_;
                                            let _e9947 = phi_7158_;
                                            let _e9949 = phi_7159_;
                                            let _e9951 = phi_7160_;
                                            let _e9953 = phi_7161_;
                                            phi_7162_ = _e9945;
                                            phi_7163_ = _e9947;
                                            phi_7164_ = _e9949;
                                            phi_7165_ = _e9951;
                                            phi_7166_ = _e9953;
                                        } else {
                                            phi_7162_ = f64();
                                            phi_7163_ = f64();
                                            phi_7164_ = false;
                                            phi_7165_ = false;
                                            phi_7166_ = true;
                                        }
                                        let _e9955 = phi_7162_;
                                        let _e9957 = phi_7163_;
                                        let _e9959 = phi_7164_;
                                        let _e9961 = phi_7165_;
                                        let _e9963 = phi_7166_;
                                        phi_7167_ = _e9955;
                                        phi_7168_ = _e9931.member_2;
                                        phi_7169_ = _e9957;
                                        phi_7170_ = _e9931;
                                        phi_7171_ = _e9931.member_2;
                                        phi_7172_ = _e9931.member_2;
                                        phi_7173_ = _e9959;
                                        phi_7174_ = _e9961;
                                        phi_7175_ = _e9963;
                                    }
                                    let _e9965 = phi_7167_;
                                    let _e9967 = phi_7168_;
                                    let _e9969 = phi_7169_;
                                    let _e9971 = phi_7170_;
                                    let _e9973 = phi_7171_;
                                    let _e9975 = phi_7172_;
                                    let _e9977 = phi_7173_;
                                    let _e9979 = phi_7174_;
                                    let _e9981 = phi_7175_;
                                    phi_7176_ = _e9965;
                                    phi_7177_ = _e9967;
                                    phi_7178_ = _e9969;
                                    phi_7179_ = _e9971;
                                    phi_7180_ = _e9973;
                                    phi_7181_ = _e9975;
                                    phi_7182_ = _e9977;
                                    phi_7183_ = _e8496;
                                    phi_7184_ = _e9979;
                                    phi_7185_ = _e9981;
                                    phi_7186_ = false;
                                } else {
                                    phi_7176_ = f64();
                                    phi_7177_ = u32();
                                    phi_7178_ = f64();
                                    phi_7179_ = type_48();
                                    phi_7180_ = u32();
                                    phi_7181_ = u32();
                                    phi_7182_ = false;
                                    phi_7183_ = false;
                                    phi_7184_ = false;
                                    phi_7185_ = false;
                                    phi_7186_ = true;
                                }
                                let _e9983 = phi_7176_;
                                let _e9985 = phi_7177_;
                                let _e9987 = phi_7178_;
                                let _e9989 = phi_7179_;
                                let _e9991 = phi_7180_;
                                let _e9993 = phi_7181_;
                                let _e9995 = phi_7182_;
                                let _e9997 = phi_7183_;
                                let _e9999 = phi_7184_;
                                let _e10001 = phi_7185_;
                                let _e10003 = phi_7186_;
                                phi_7187_ = _e8493;
                                phi_2171_ = _e9983;
                                phi_2173_ = _e9985;
                                phi_2175_ = _e9987;
                                phi_7188_ = _e9989;
                                phi_7189_ = _e9991;
                                phi_7190_ = _e8493;
                                phi_7191_ = _e9993;
                                phi_7192_ = _e9995;
                                phi_7193_ = _e9997;
                                phi_7194_ = _e9999;
                                phi_7195_ = _e10001;
                                phi_7196_ = false;
                                phi_7197_ = _e10003;
                            } else {
                                phi_7187_ = f64();
                                phi_2171_ = f64();
                                phi_2173_ = u32();
                                phi_2175_ = f64();
                                phi_7188_ = type_48();
                                phi_7189_ = u32();
                                phi_7190_ = f64();
                                phi_7191_ = u32();
                                phi_7192_ = false;
                                phi_7193_ = false;
                                phi_7194_ = false;
                                phi_7195_ = false;
                                phi_7196_ = true;
                                phi_7197_ = false;
                            }
                            let _e10005 = phi_7187_;
                            let _e10007 = phi_2171_;
                            let _e10009 = phi_2173_;
                            let _e10011 = phi_2175_;
                            let _e10013 = phi_7188_;
                            let _e10015 = phi_7189_;
                            let _e10017 = phi_7190_;
                            let _e10019 = phi_7191_;
                            let _e10021 = phi_7192_;
                            let _e10023 = phi_7193_;
                            let _e10025 = phi_7194_;
                            let _e10027 = phi_7195_;
                            let _e10029 = phi_7196_;
                            let _e10031 = phi_7197_;
                            local_58 = _e10023;
                            local_92 = _e10025;
                            local_93 = _e10027;
                            local_94 = _e10029;
                            local_95 = _e10031;
                            local_59 = _e10013;
                            local_60 = _e10013;
                            local_96 = _e10015;
                            local_61 = _e10013;
                            local_97 = _e10023;
                            local_98 = _e10019;
                            local_100 = _e10017;
                            local_101 = _e10005;
                            continue;
                            continuing {
                                phi_2167_ = _e6670;
                                phi_2170_ = _e10007;
                                phi_2172_ = _e10009;
                                phi_2174_ = _e10011;
                                break if !(_e10021);
                            }
                        }
                        let _e10034 = local_58;
                        if _e10034 {
                            phi_7201_ = false;
                            phi_7202_ = false;
                            phi_7203_ = false;
                            phi_7204_ = false;
                        } else {
                            let _e12208 = local_92;
                            phi_7201_ = _e12208;
                            let _e12211 = local_93;
                            phi_7202_ = _e12211;
                            let _e12214 = local_94;
                            phi_7203_ = _e12214;
                            let _e12217 = local_95;
                            phi_7204_ = _e12217;
                        }
                        let _e10036 = phi_7201_;
                        let _e10038 = phi_7202_;
                        let _e10040 = phi_7203_;
                        let _e10042 = phi_7204_;
                        if _e10036 {
                            let _e10044 = local_59;
                            if (_e10044.member >= _e422) {
                                phi_7226_ = type_47(type_46(0u, f64()), 0u);
                            } else {
                                let _e10048 = local_60;
                                if (_e10048.member > _e413) {
                                    phi_7221_ = 0u;
                                } else {
                                    let _e12222 = local_96;
                                    phi_7221_ = _e12222;
                                }
                                let _e10052 = phi_7221_;
                                let _e10054 = local_61;
                                phi_7226_ = type_47(type_46(2u, _e10054.member), _e10052);
                            }
                            let _e10061 = phi_7226_;
                            phi_7227_ = _e10061;
                            phi_7228_ = false;
                            phi_7229_ = false;
                            phi_7230_ = false;
                            phi_7231_ = false;
                        } else {
                            phi_7227_ = type_47();
                            phi_7228_ = _e10038;
                            let _e12229 = local_97;
                            phi_7229_ = _e12229;
                            phi_7230_ = _e10040;
                            phi_7231_ = _e10042;
                        }
                        let _e10063 = phi_7227_;
                        let _e10065 = phi_7228_;
                        let _e10067 = phi_7229_;
                        let _e10069 = phi_7230_;
                        let _e10071 = phi_7231_;
                        if _e10065 {
                            let _e12234 = local_98;
                            phi_7235_ = _e12234;
                            let _e12239 = local_100;
                            phi_7236_ = _e12239;
                            phi_7237_ = true;
                            phi_7238_ = false;
                            phi_7239_ = false;
                            phi_7240_ = false;
                        } else {
                            let _e12236 = local_99;
                            phi_7235_ = _e12236;
                            let _e12241 = local_101;
                            phi_7236_ = _e12241;
                            phi_7237_ = _e10067;
                            phi_7238_ = _e10069;
                            phi_7239_ = _e10071;
                            phi_7240_ = _e10036;
                        }
                        let _e10073 = phi_7235_;
                        let _e10075 = phi_7236_;
                        let _e10077 = phi_7237_;
                        let _e10079 = phi_7238_;
                        let _e10081 = phi_7239_;
                        let _e10083 = phi_7240_;
                        if _e10077 {
                            phi_7244_ = _e10075;
                            phi_7245_ = _e10073;
                            phi_7246_ = true;
                            phi_7247_ = false;
                            phi_7248_ = false;
                        } else {
                            let _e12248 = local_102;
                            phi_7244_ = _e12248;
                            let _e12251 = local_103;
                            phi_7245_ = _e12251;
                            phi_7246_ = _e10079;
                            phi_7247_ = _e10081;
                            phi_7248_ = _e10083;
                        }
                        let _e10085 = phi_7244_;
                        let _e10087 = phi_7245_;
                        let _e10089 = phi_7246_;
                        let _e10091 = phi_7247_;
                        let _e10093 = phi_7248_;
                        if _e10089 {
                            local_13[0u] = 0.01f;
                            local_13[1u] = 0f;
                            local_13[2u] = 0.8f;
                            if (_e404 >= (1.1102230246251565e-16lf * f64(8f))) {
                                phi_7262_ = _e404;
                            } else {
                                phi_7262_ = f64(0f);
                            }
                            let _e10102 = phi_7262_;
                            phi_7265_ = type_12(0u, 3u);
                            loop {
                                let _e10104 = phi_7265_;
                                if (_e10104.member < _e10104.member_1) {
                                    phi_7266_ = type_12((_e10104.member + 1u), _e10104.member_1);
                                    phi_7289_ = type_12(1u, _e10104.member);
                                } else {
                                    phi_7266_ = _e10104;
                                    phi_7289_ = type_12(0u, type_12().member_1);
                                }
                                let _e10116 = phi_7266_;
                                let _e10118 = phi_7289_;
                                if (bitcast<i32>(_e10118.member) != 0i) {
                                    let _e10124 = local_13[_e10118.member_1];
                                    let _e10127 = (_e10085 + (_e10102 * f64(_e10124)));
                                    if (_e10127 < _e422) {
                                        phi_7311_ = _e10127;
                                    } else {
                                        phi_7311_ = _e422;
                                    }
                                    let _e10130 = phi_7311_;
                                    let _e10133 = local_18.member[0u];
                                    let _e10139 = local_18.member[1u];
                                    let _e10155 = local_18.member_1[0u];
                                    let _e10161 = local_18.member_1[1u];
                                    let _e10177 = local_18.member_2[0u];
                                    let _e10183 = local_18.member_2[1u];
                                    let _e10197 = function_4(array<f64, 3>((_e10133[0] + ((_e10139[0] - _e10133[0]) * _e10130)), (_e10133[1] + ((_e10139[1] - _e10133[1]) * _e10130)), (_e10133[2] + ((_e10139[2] - _e10133[2]) * _e10130))), array<f64, 3>((_e10155[0] + ((_e10161[0] - _e10155[0]) * _e10130)), (_e10155[1] + ((_e10161[1] - _e10155[1]) * _e10130)), (_e10155[2] + ((_e10161[2] - _e10155[2]) * _e10130))), array<f64, 3>((_e10177[0] + ((_e10183[0] - _e10177[0]) * _e10130)), (_e10177[1] + ((_e10183[1] - _e10177[1]) * _e10130)), (_e10177[2] + ((_e10183[2] - _e10177[2]) * _e10130))), 1u);
                                    let _e10208 = (((_e10197[0] * _e10197[0]) + (_e10197[1] * _e10197[1])) + (_e10197[2] * _e10197[2]));
                                    if (_e10208 <= 2.2250738585072014e-308lf) {
                                        if (_e10208 > 0.0lf) {
                                            phi_7434_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_7434_ = 0.0lf;
                                        }
                                        let _e10260 = phi_7434_;
                                        phi_7498_ = _e10260;
                                    } else {
                                        phi_7441_ = type_16(0i, 5i);
                                        phi_7444_ = bitcast<f64>(((bitcast<u64>(_e10208) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e10215 = phi_7441_;
                                            let _e10217 = phi_7444_;
                                            local_62 = _e10217;
                                            if (_e10215.member < _e10215.member_1) {
                                                let _e10224 = (_e10215.member + 1i);
                                                if ((false == (_e10224 > _e10215.member)) != false) {
                                                    phi_7465_ = true;
                                                } else {
                                                    phi_7465_ = false;
                                                }
                                                let _e10229 = phi_7465_;
                                                if _e10229 {
                                                    phi_7471_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_7471_ = type_17(1u, _e10224);
                                                }
                                                let _e10234 = phi_7471_;
                                                phi_7442_ = type_16(_e10234.member_1, _e10215.member_1);
                                                phi_7485_ = type_17(1u, _e10215.member);
                                            } else {
                                                phi_7442_ = _e10215;
                                                phi_7485_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e10240 = phi_7442_;
                                            let _e10242 = phi_7485_;
                                            let _e10245 = (bitcast<i32>(_e10242.member) != 0i);
                                            if _e10245 {
                                                phi_7445_ = (0.5lf * (_e10217 + (_e10208 / _e10217)));
                                            } else {
                                                phi_7445_ = f64();
                                            }
                                            let _e10250 = phi_7445_;
                                            continue;
                                            continuing {
                                                phi_7441_ = _e10240;
                                                phi_7444_ = _e10250;
                                                break if !(_e10245);
                                            }
                                        }
                                        let _e10255 = local_62;
                                        phi_7498_ = (_e10255 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e10262 = phi_7498_;
                                    let _e10270 = local_18.member[0u];
                                    if (_e10270[0] < 0.0lf) {
                                        phi_7516_ = -(_e10270[0]);
                                    } else {
                                        phi_7516_ = _e10270[0];
                                    }
                                    let _e10277 = phi_7516_;
                                    if (_e10270[1] < 0.0lf) {
                                        phi_7523_ = -(_e10270[1]);
                                    } else {
                                        phi_7523_ = _e10270[1];
                                    }
                                    let _e10281 = phi_7523_;
                                    if (_e10277 > _e10281) {
                                        phi_7528_ = _e10277;
                                    } else {
                                        phi_7528_ = _e10281;
                                    }
                                    let _e10284 = phi_7528_;
                                    if (_e10270[2] < 0.0lf) {
                                        phi_7535_ = -(_e10270[2]);
                                    } else {
                                        phi_7535_ = _e10270[2];
                                    }
                                    let _e10288 = phi_7535_;
                                    if (_e10284 > _e10288) {
                                        phi_7540_ = _e10284;
                                    } else {
                                        phi_7540_ = _e10288;
                                    }
                                    let _e10291 = phi_7540_;
                                    let _e10294 = local_18.member[1u];
                                    if (_e10294[0] < 0.0lf) {
                                        phi_7553_ = -(_e10294[0]);
                                    } else {
                                        phi_7553_ = _e10294[0];
                                    }
                                    let _e10301 = phi_7553_;
                                    if (_e10294[1] < 0.0lf) {
                                        phi_7560_ = -(_e10294[1]);
                                    } else {
                                        phi_7560_ = _e10294[1];
                                    }
                                    let _e10305 = phi_7560_;
                                    if (_e10301 > _e10305) {
                                        phi_7565_ = _e10301;
                                    } else {
                                        phi_7565_ = _e10305;
                                    }
                                    let _e10308 = phi_7565_;
                                    if (_e10294[2] < 0.0lf) {
                                        phi_7572_ = -(_e10294[2]);
                                    } else {
                                        phi_7572_ = _e10294[2];
                                    }
                                    let _e10312 = phi_7572_;
                                    if (_e10308 > _e10312) {
                                        phi_7577_ = _e10308;
                                    } else {
                                        phi_7577_ = _e10312;
                                    }
                                    let _e10315 = phi_7577_;
                                    if (_e10291 > _e10315) {
                                        phi_7582_ = _e10291;
                                    } else {
                                        phi_7582_ = _e10315;
                                    }
                                    let _e10318 = phi_7582_;
                                    let _e10320 = local_18.member_3;
                                    let _e10324 = local_18.member_1[0u];
                                    if (_e10324[0] < 0.0lf) {
                                        phi_7599_ = -(_e10324[0]);
                                    } else {
                                        phi_7599_ = _e10324[0];
                                    }
                                    let _e10331 = phi_7599_;
                                    if (_e10324[1] < 0.0lf) {
                                        phi_7606_ = -(_e10324[1]);
                                    } else {
                                        phi_7606_ = _e10324[1];
                                    }
                                    let _e10335 = phi_7606_;
                                    if (_e10331 > _e10335) {
                                        phi_7611_ = _e10331;
                                    } else {
                                        phi_7611_ = _e10335;
                                    }
                                    let _e10338 = phi_7611_;
                                    if (_e10324[2] < 0.0lf) {
                                        phi_7618_ = -(_e10324[2]);
                                    } else {
                                        phi_7618_ = _e10324[2];
                                    }
                                    let _e10342 = phi_7618_;
                                    if (_e10338 > _e10342) {
                                        phi_7623_ = _e10338;
                                    } else {
                                        phi_7623_ = _e10342;
                                    }
                                    let _e10345 = phi_7623_;
                                    let _e10348 = local_18.member_1[1u];
                                    if (_e10348[0] < 0.0lf) {
                                        phi_7637_ = -(_e10348[0]);
                                    } else {
                                        phi_7637_ = _e10348[0];
                                    }
                                    let _e10355 = phi_7637_;
                                    if (_e10348[1] < 0.0lf) {
                                        phi_7644_ = -(_e10348[1]);
                                    } else {
                                        phi_7644_ = _e10348[1];
                                    }
                                    let _e10359 = phi_7644_;
                                    if (_e10355 > _e10359) {
                                        phi_7649_ = _e10355;
                                    } else {
                                        phi_7649_ = _e10359;
                                    }
                                    let _e10362 = phi_7649_;
                                    if (_e10348[2] < 0.0lf) {
                                        phi_7656_ = -(_e10348[2]);
                                    } else {
                                        phi_7656_ = _e10348[2];
                                    }
                                    let _e10366 = phi_7656_;
                                    if (_e10362 > _e10366) {
                                        phi_7661_ = _e10362;
                                    } else {
                                        phi_7661_ = _e10366;
                                    }
                                    let _e10369 = phi_7661_;
                                    if (_e10345 > _e10369) {
                                        phi_7666_ = _e10345;
                                    } else {
                                        phi_7666_ = _e10369;
                                    }
                                    let _e10372 = phi_7666_;
                                    let _e10374 = local_18.member_3;
                                    let _e10378 = local_18.member_2[0u];
                                    if (_e10378[0] < 0.0lf) {
                                        phi_7683_ = -(_e10378[0]);
                                    } else {
                                        phi_7683_ = _e10378[0];
                                    }
                                    let _e10385 = phi_7683_;
                                    if (_e10378[1] < 0.0lf) {
                                        phi_7690_ = -(_e10378[1]);
                                    } else {
                                        phi_7690_ = _e10378[1];
                                    }
                                    let _e10389 = phi_7690_;
                                    if (_e10385 > _e10389) {
                                        phi_7695_ = _e10385;
                                    } else {
                                        phi_7695_ = _e10389;
                                    }
                                    let _e10392 = phi_7695_;
                                    if (_e10378[2] < 0.0lf) {
                                        phi_7702_ = -(_e10378[2]);
                                    } else {
                                        phi_7702_ = _e10378[2];
                                    }
                                    let _e10396 = phi_7702_;
                                    if (_e10392 > _e10396) {
                                        phi_7707_ = _e10392;
                                    } else {
                                        phi_7707_ = _e10396;
                                    }
                                    let _e10399 = phi_7707_;
                                    let _e10402 = local_18.member_2[1u];
                                    if (_e10402[0] < 0.0lf) {
                                        phi_7721_ = -(_e10402[0]);
                                    } else {
                                        phi_7721_ = _e10402[0];
                                    }
                                    let _e10409 = phi_7721_;
                                    if (_e10402[1] < 0.0lf) {
                                        phi_7728_ = -(_e10402[1]);
                                    } else {
                                        phi_7728_ = _e10402[1];
                                    }
                                    let _e10413 = phi_7728_;
                                    if (_e10409 > _e10413) {
                                        phi_7733_ = _e10409;
                                    } else {
                                        phi_7733_ = _e10413;
                                    }
                                    let _e10416 = phi_7733_;
                                    if (_e10402[2] < 0.0lf) {
                                        phi_7740_ = -(_e10402[2]);
                                    } else {
                                        phi_7740_ = _e10402[2];
                                    }
                                    let _e10420 = phi_7740_;
                                    if (_e10416 > _e10420) {
                                        phi_7745_ = _e10416;
                                    } else {
                                        phi_7745_ = _e10420;
                                    }
                                    let _e10423 = phi_7745_;
                                    if (_e10399 > _e10423) {
                                        phi_7750_ = _e10399;
                                    } else {
                                        phi_7750_ = _e10423;
                                    }
                                    let _e10426 = phi_7750_;
                                    let _e10428 = local_18.member_3;
                                    let _e10436 = local_18.member_3;
                                    let _e10446 = (((_e10262 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e10318 + _e10320) + (_e10372 + _e10374)) + (_e10426 + _e10428)) * (1.1102230246251565e-16lf * f64(16f))) + (_e10436 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e623.member_1);
                                    if _e10446 {
                                        phi_7774_ = false;
                                    } else {
                                        phi_7774_ = true;
                                    }
                                    let _e10448 = phi_7774_;
                                    phi_7775_ = _e10448;
                                    phi_7776_ = _e10446;
                                } else {
                                    phi_7775_ = false;
                                    phi_7776_ = false;
                                }
                                let _e10450 = phi_7775_;
                                let _e10452 = phi_7776_;
                                local_63 = _e10452;
                                continue;
                                continuing {
                                    phi_7265_ = _e10116;
                                    break if !(_e10450);
                                }
                            }
                            let _e10455 = local_63;
                            if _e10455 {
                                if (_e10085 > _e413) {
                                    phi_7784_ = 1u;
                                } else {
                                    phi_7784_ = _e10087;
                                }
                                let _e10458 = phi_7784_;
                                phi_7788_ = type_47(type_46(1u, _e10085), _e10458);
                                phi_7789_ = false;
                            } else {
                                phi_7788_ = type_47();
                                phi_7789_ = true;
                            }
                            let _e10462 = phi_7788_;
                            let _e10464 = phi_7789_;
                            if _e10464 {
                                if (_e10085 > _e413) {
                                    phi_7797_ = 0u;
                                } else {
                                    phi_7797_ = _e10087;
                                }
                                let _e10467 = phi_7797_;
                                phi_7801_ = type_47(type_46(2u, _e10085), _e10467);
                            } else {
                                phi_7801_ = _e10462;
                            }
                            let _e10471 = phi_7801_;
                            phi_7802_ = _e10471;
                            phi_7803_ = false;
                            phi_7804_ = false;
                        } else {
                            phi_7802_ = type_47();
                            phi_7803_ = _e10091;
                            phi_7804_ = _e10093;
                        }
                        let _e10473 = phi_7802_;
                        let _e10475 = phi_7803_;
                        let _e10477 = phi_7804_;
                        if _e10475 {
                            phi_7811_ = type_47(type_46(0u, f64()), 0u);
                            phi_7812_ = true;
                        } else {
                            phi_7811_ = _e10063;
                            phi_7812_ = _e10477;
                        }
                        let _e10481 = phi_7811_;
                        let _e10483 = phi_7812_;
                        phi_7816_ = _e10481;
                        phi_7817_ = _e10473;
                        phi_7818_ = _e10483;
                    } else {
                        phi_7816_ = _e6637;
                        phi_7817_ = type_47();
                        phi_7818_ = true;
                    }
                    let _e10485 = phi_7816_;
                    let _e10487 = phi_7817_;
                    let _e10489 = phi_7818_;
                    if _e10489 {
                        phi_7822_ = _e10485;
                    } else {
                        phi_7822_ = _e10487;
                    }
                    let _e10491 = phi_7822_;
                    phi_15489_ = _e10491;
                } else {
                    let _e666 = f64(0f);
                    let _e669 = local_18.member_1[0u];
                    let _e675 = local_18.member_2[0u];
                    let _e681 = ((_e669[1] * _e675[2]) - (_e669[2] * _e675[1]));
                    let _e684 = ((_e669[2] * _e675[0]) - (_e669[0] * _e675[2]));
                    let _e687 = ((_e669[0] * _e675[1]) - (_e669[1] * _e675[0]));
                    let _e690 = local_18.member_1[1u];
                    let _e696 = local_18.member_2[1u];
                    let _e702 = ((_e690[1] * _e696[2]) - (_e690[2] * _e696[1]));
                    let _e705 = ((_e690[2] * _e696[0]) - (_e690[0] * _e696[2]));
                    let _e708 = ((_e690[0] * _e696[1]) - (_e690[1] * _e696[0]));
                    let _e711 = local_18.member_1[0u];
                    let _e717 = local_18.member_2[1u];
                    let _e732 = local_18.member_1[1u];
                    let _e738 = local_18.member_2[0u];
                    let _e751 = (((_e711[1] * _e717[2]) - (_e711[2] * _e717[1])) + ((_e732[1] * _e738[2]) - (_e732[2] * _e738[1])));
                    let _e752 = (((_e711[2] * _e717[0]) - (_e711[0] * _e717[2])) + ((_e732[2] * _e738[0]) - (_e732[0] * _e738[2])));
                    let _e753 = (((_e711[0] * _e717[1]) - (_e711[1] * _e717[0])) + ((_e732[0] * _e738[1]) - (_e732[1] * _e738[0])));
                    let _e756 = local_18.member[0u];
                    let _e764 = (((_e756[0] * _e681) + (_e756[1] * _e684)) + (_e756[2] * _e687));
                    let _e767 = local_18.member[1u];
                    let _e778 = local_18.member[0u];
                    let _e787 = ((((_e767[0] * _e681) + (_e767[1] * _e684)) + (_e767[2] * _e687)) + (((_e778[0] * _e751) + (_e778[1] * _e752)) + (_e778[2] * _e753)));
                    let _e790 = local_18.member[0u];
                    let _e801 = local_18.member[1u];
                    let _e810 = ((((_e790[0] * _e702) + (_e790[1] * _e705)) + (_e790[2] * _e708)) + (((_e801[0] * _e751) + (_e801[1] * _e752)) + (_e801[2] * _e753)));
                    let _e813 = local_18.member[1u];
                    let _e821 = (((_e813[0] * _e702) + (_e813[1] * _e705)) + (_e813[2] * _e708));
                    let _e824 = local_18.member[0u];
                    if (_e824[0] < 0.0lf) {
                        phi_8065_ = -(_e824[0]);
                    } else {
                        phi_8065_ = _e824[0];
                    }
                    let _e831 = phi_8065_;
                    if (_e824[1] < 0.0lf) {
                        phi_8072_ = -(_e824[1]);
                    } else {
                        phi_8072_ = _e824[1];
                    }
                    let _e835 = phi_8072_;
                    if (_e831 > _e835) {
                        phi_8077_ = _e831;
                    } else {
                        phi_8077_ = _e835;
                    }
                    let _e838 = phi_8077_;
                    if (_e824[2] < 0.0lf) {
                        phi_8084_ = -(_e824[2]);
                    } else {
                        phi_8084_ = _e824[2];
                    }
                    let _e842 = phi_8084_;
                    if (_e838 > _e842) {
                        phi_8089_ = _e838;
                    } else {
                        phi_8089_ = _e842;
                    }
                    let _e845 = phi_8089_;
                    let _e848 = local_18.member[1u];
                    if (_e848[0] < 0.0lf) {
                        phi_8102_ = -(_e848[0]);
                    } else {
                        phi_8102_ = _e848[0];
                    }
                    let _e855 = phi_8102_;
                    if (_e848[1] < 0.0lf) {
                        phi_8109_ = -(_e848[1]);
                    } else {
                        phi_8109_ = _e848[1];
                    }
                    let _e859 = phi_8109_;
                    if (_e855 > _e859) {
                        phi_8114_ = _e855;
                    } else {
                        phi_8114_ = _e859;
                    }
                    let _e862 = phi_8114_;
                    if (_e848[2] < 0.0lf) {
                        phi_8121_ = -(_e848[2]);
                    } else {
                        phi_8121_ = _e848[2];
                    }
                    let _e866 = phi_8121_;
                    if (_e862 > _e866) {
                        phi_8126_ = _e862;
                    } else {
                        phi_8126_ = _e866;
                    }
                    let _e869 = phi_8126_;
                    if (_e845 > _e869) {
                        phi_8131_ = _e845;
                    } else {
                        phi_8131_ = _e869;
                    }
                    let _e872 = phi_8131_;
                    let _e874 = local_18.member_3;
                    let _e875 = (_e872 + _e874);
                    let _e878 = local_18.member_1[0u];
                    if (_e878[0] < 0.0lf) {
                        phi_8148_ = -(_e878[0]);
                    } else {
                        phi_8148_ = _e878[0];
                    }
                    let _e885 = phi_8148_;
                    if (_e878[1] < 0.0lf) {
                        phi_8155_ = -(_e878[1]);
                    } else {
                        phi_8155_ = _e878[1];
                    }
                    let _e889 = phi_8155_;
                    if (_e885 > _e889) {
                        phi_8160_ = _e885;
                    } else {
                        phi_8160_ = _e889;
                    }
                    let _e892 = phi_8160_;
                    if (_e878[2] < 0.0lf) {
                        phi_8167_ = -(_e878[2]);
                    } else {
                        phi_8167_ = _e878[2];
                    }
                    let _e896 = phi_8167_;
                    if (_e892 > _e896) {
                        phi_8172_ = _e892;
                    } else {
                        phi_8172_ = _e896;
                    }
                    let _e899 = phi_8172_;
                    let _e902 = local_18.member_1[1u];
                    if (_e902[0] < 0.0lf) {
                        phi_8186_ = -(_e902[0]);
                    } else {
                        phi_8186_ = _e902[0];
                    }
                    let _e909 = phi_8186_;
                    if (_e902[1] < 0.0lf) {
                        phi_8193_ = -(_e902[1]);
                    } else {
                        phi_8193_ = _e902[1];
                    }
                    let _e913 = phi_8193_;
                    if (_e909 > _e913) {
                        phi_8198_ = _e909;
                    } else {
                        phi_8198_ = _e913;
                    }
                    let _e916 = phi_8198_;
                    if (_e902[2] < 0.0lf) {
                        phi_8205_ = -(_e902[2]);
                    } else {
                        phi_8205_ = _e902[2];
                    }
                    let _e920 = phi_8205_;
                    if (_e916 > _e920) {
                        phi_8210_ = _e916;
                    } else {
                        phi_8210_ = _e920;
                    }
                    let _e923 = phi_8210_;
                    if (_e899 > _e923) {
                        phi_8215_ = _e899;
                    } else {
                        phi_8215_ = _e923;
                    }
                    let _e926 = phi_8215_;
                    let _e928 = local_18.member_3;
                    let _e929 = (_e926 + _e928);
                    let _e932 = local_18.member_2[0u];
                    if (_e932[0] < 0.0lf) {
                        phi_8232_ = -(_e932[0]);
                    } else {
                        phi_8232_ = _e932[0];
                    }
                    let _e939 = phi_8232_;
                    if (_e932[1] < 0.0lf) {
                        phi_8239_ = -(_e932[1]);
                    } else {
                        phi_8239_ = _e932[1];
                    }
                    let _e943 = phi_8239_;
                    if (_e939 > _e943) {
                        phi_8244_ = _e939;
                    } else {
                        phi_8244_ = _e943;
                    }
                    let _e946 = phi_8244_;
                    if (_e932[2] < 0.0lf) {
                        phi_8251_ = -(_e932[2]);
                    } else {
                        phi_8251_ = _e932[2];
                    }
                    let _e950 = phi_8251_;
                    if (_e946 > _e950) {
                        phi_8256_ = _e946;
                    } else {
                        phi_8256_ = _e950;
                    }
                    let _e953 = phi_8256_;
                    let _e956 = local_18.member_2[1u];
                    if (_e956[0] < 0.0lf) {
                        phi_8270_ = -(_e956[0]);
                    } else {
                        phi_8270_ = _e956[0];
                    }
                    let _e963 = phi_8270_;
                    if (_e956[1] < 0.0lf) {
                        phi_8277_ = -(_e956[1]);
                    } else {
                        phi_8277_ = _e956[1];
                    }
                    let _e967 = phi_8277_;
                    if (_e963 > _e967) {
                        phi_8282_ = _e963;
                    } else {
                        phi_8282_ = _e967;
                    }
                    let _e970 = phi_8282_;
                    if (_e956[2] < 0.0lf) {
                        phi_8289_ = -(_e956[2]);
                    } else {
                        phi_8289_ = _e956[2];
                    }
                    let _e974 = phi_8289_;
                    if (_e970 > _e974) {
                        phi_8294_ = _e970;
                    } else {
                        phi_8294_ = _e974;
                    }
                    let _e977 = phi_8294_;
                    if (_e953 > _e977) {
                        phi_8299_ = _e953;
                    } else {
                        phi_8299_ = _e977;
                    }
                    let _e980 = phi_8299_;
                    let _e982 = local_18.member_3;
                    let _e983 = (_e980 + _e982);
                    let _e984 = f64(1f);
                    let _e985 = f64(8f);
                    let _e987 = ((_e929 * _e985) * _e983);
                    let _e995 = local_18.member_3;
                    if (_e681 < 0.0lf) {
                        phi_8336_ = -(_e681);
                    } else {
                        phi_8336_ = _e681;
                    }
                    let _e1015 = phi_8336_;
                    if (_e684 < 0.0lf) {
                        phi_8342_ = -(_e684);
                    } else {
                        phi_8342_ = _e684;
                    }
                    let _e1019 = phi_8342_;
                    if (_e687 < 0.0lf) {
                        phi_8349_ = -(_e687);
                    } else {
                        phi_8349_ = _e687;
                    }
                    let _e1024 = phi_8349_;
                    let _e1025 = ((_e1015 + _e1019) + _e1024);
                    if (_e702 < 0.0lf) {
                        phi_8356_ = -(_e702);
                    } else {
                        phi_8356_ = _e702;
                    }
                    let _e1029 = phi_8356_;
                    if (_e705 < 0.0lf) {
                        phi_8362_ = -(_e705);
                    } else {
                        phi_8362_ = _e705;
                    }
                    let _e1033 = phi_8362_;
                    if (_e708 < 0.0lf) {
                        phi_8369_ = -(_e708);
                    } else {
                        phi_8369_ = _e708;
                    }
                    let _e1038 = phi_8369_;
                    let _e1039 = ((_e1029 + _e1033) + _e1038);
                    if (_e1025 > _e1039) {
                        phi_8375_ = _e1025;
                    } else {
                        phi_8375_ = _e1039;
                    }
                    let _e1042 = phi_8375_;
                    if (_e751 < 0.0lf) {
                        phi_8381_ = -(_e751);
                    } else {
                        phi_8381_ = _e751;
                    }
                    let _e1046 = phi_8381_;
                    if (_e752 < 0.0lf) {
                        phi_8387_ = -(_e752);
                    } else {
                        phi_8387_ = _e752;
                    }
                    let _e1050 = phi_8387_;
                    if (_e753 < 0.0lf) {
                        phi_8394_ = -(_e753);
                    } else {
                        phi_8394_ = _e753;
                    }
                    let _e1055 = phi_8394_;
                    let _e1057 = (((_e1046 + _e1050) + _e1055) * f64(0.5f));
                    if (_e1042 > _e1057) {
                        phi_8401_ = _e1042;
                    } else {
                        phi_8401_ = _e1057;
                    }
                    let _e1060 = phi_8401_;
                    let _e1066 = local_18.member_3;
                    let _e1080 = (((((_e875 * _e985) * _e987) * (1.1102230246251565e-16lf * f64((524f / 64f)))) + ((_e995 * f64(19f)) * ((_e875 * (_e929 + _e983)) + (_e929 * _e983)))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e984 + _e875) * ((_e984 + _e929) * (_e984 + _e983)))));
                    let _e1081 = f64(3f);
                    let _e1082 = (_e764 * _e1081);
                    let _e1083 = (_e821 * _e1081);
                    if (_e1082 < _e1083) {
                        phi_8429_ = _e1082;
                    } else {
                        phi_8429_ = _e1083;
                    }
                    let _e1086 = phi_8429_;
                    if (_e787 < _e810) {
                        phi_8434_ = _e787;
                    } else {
                        phi_8434_ = _e810;
                    }
                    let _e1089 = phi_8434_;
                    if (_e1086 < _e1089) {
                        phi_8439_ = _e1086;
                    } else {
                        phi_8439_ = _e1089;
                    }
                    let _e1092 = phi_8439_;
                    if (_e1082 > _e1083) {
                        phi_8444_ = _e1082;
                    } else {
                        phi_8444_ = _e1083;
                    }
                    let _e1095 = phi_8444_;
                    if (_e787 > _e810) {
                        phi_8449_ = _e787;
                    } else {
                        phi_8449_ = _e810;
                    }
                    let _e1098 = phi_8449_;
                    if (_e1095 > _e1098) {
                        phi_8454_ = _e1095;
                    } else {
                        phi_8454_ = _e1098;
                    }
                    let _e1101 = phi_8454_;
                    let _e1107 = -(_e1101);
                    if (_e1092 > _e1107) {
                        phi_8465_ = _e1092;
                    } else {
                        phi_8465_ = _e1107;
                    }
                    let _e1110 = phi_8465_;
                    if ((_e1110 - (_e1080 + ((_e666 * (((_e1060 + (_e987 * (1.1102230246251565e-16lf * f64(8f)))) + ((_e1066 * f64(6f)) * (_e929 + _e983))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e984 + _e929) * (_e984 + _e983))))) * f64((3f * 1.0001f))))) > _e666) {
                        phi_15459_ = type_46(0u, type_46().member_1);
                        phi_15460_ = type_46();
                        phi_15461_ = true;
                    } else {
                        if (_e764 < 0.0lf) {
                            phi_8479_ = -(_e764);
                        } else {
                            phi_8479_ = _e764;
                        }
                        let _e1118 = phi_8479_;
                        if (_e787 < 0.0lf) {
                            phi_8485_ = -(_e787);
                        } else {
                            phi_8485_ = _e787;
                        }
                        let _e1122 = phi_8485_;
                        if (_e1118 > _e1122) {
                            phi_8490_ = _e1118;
                        } else {
                            phi_8490_ = _e1122;
                        }
                        let _e1125 = phi_8490_;
                        if (_e810 < 0.0lf) {
                            phi_8496_ = -(_e810);
                        } else {
                            phi_8496_ = _e810;
                        }
                        let _e1129 = phi_8496_;
                        if (_e821 < 0.0lf) {
                            phi_8502_ = -(_e821);
                        } else {
                            phi_8502_ = _e821;
                        }
                        let _e1133 = phi_8502_;
                        if (_e1129 > _e1133) {
                            phi_8507_ = _e1129;
                        } else {
                            phi_8507_ = _e1133;
                        }
                        let _e1136 = phi_8507_;
                        if (_e1125 > _e1136) {
                            phi_8512_ = _e1125;
                        } else {
                            phi_8512_ = _e1136;
                        }
                        let _e1139 = phi_8512_;
                        let _e1141 = (2.2250738585072014e-308lf * f64(67108864f));
                        let _e1142 = f64(1f);
                        if (_e1139 >= _e1141) {
                            phi_8522_ = (_e1139 <= (_e1142 / _e1141));
                        } else {
                            phi_8522_ = false;
                        }
                        let _e1147 = phi_8522_;
                        if _e1147 {
                            phi_8529_ = (1.1102230246251565e-16lf * f64(256f));
                        } else {
                            phi_8529_ = f64(2f);
                        }
                        let _e1152 = phi_8529_;
                        let _e1154 = ((_e1080 * f64(0.34f)) + (_e1139 * _e1152));
                        if _e1147 {
                            phi_8537_ = (_e1142 / _e1139);
                        } else {
                            phi_8537_ = f64(0f);
                        }
                        let _e1158 = phi_8537_;
                        let _e1159 = f64(0.00000000000022737368f);
                        let _e1161 = (_e404 * f64(0.0625f));
                        if (_e1159 < _e1161) {
                            phi_8545_ = _e1159;
                        } else {
                            phi_8545_ = _e1161;
                        }
                        let _e1164 = phi_8545_;
                        let _e1166 = (f64(1f) - _e413);
                        let _e1177 = ((((_e764 * _e1166) + (_e787 * _e413)) * (_e1166 * _e1166)) + (((_e810 * _e1166) + (_e821 * _e413)) * (_e413 * _e413)));
                        if (_e1177 < 0.0lf) {
                            phi_8564_ = -(_e1177);
                        } else {
                            phi_8564_ = _e1177;
                        }
                        let _e1181 = phi_8564_;
                        if !((_e1181 > _e1154)) {
                            let _e1184 = f64(0f);
                            let _e1187 = local_18.member[0u];
                            let _e1193 = local_18.member_1[0u];
                            let _e1199 = local_18.member_2[0u];
                            let _e1203 = (_e1187[0] - _e1193[0]);
                            let _e1204 = (_e1187[1] - _e1193[1]);
                            let _e1205 = (_e1187[2] - _e1193[2]);
                            let _e1206 = (_e1203 - _e1199[0]);
                            let _e1207 = (_e1204 - _e1199[1]);
                            let _e1208 = (_e1205 - _e1199[2]);
                            let _e1209 = (_e1187[0] - _e1199[0]);
                            let _e1210 = (_e1187[1] - _e1199[1]);
                            let _e1211 = (_e1187[2] - _e1199[2]);
                            let _e1214 = local_18.member[1u];
                            let _e1220 = local_18.member_1[1u];
                            let _e1226 = local_18.member_2[1u];
                            let _e1230 = (_e1214[0] - _e1220[0]);
                            let _e1231 = (_e1214[1] - _e1220[1]);
                            let _e1232 = (_e1214[2] - _e1220[2]);
                            let _e1233 = (_e1230 - _e1226[0]);
                            let _e1234 = (_e1231 - _e1226[1]);
                            let _e1235 = (_e1232 - _e1226[2]);
                            let _e1236 = (_e1214[0] - _e1226[0]);
                            let _e1237 = (_e1214[1] - _e1226[1]);
                            let _e1238 = (_e1214[2] - _e1226[2]);
                            let _e1241 = local_18.member[0u];
                            if (_e1241[0] < 0.0lf) {
                                phi_8713_ = -(_e1241[0]);
                            } else {
                                phi_8713_ = _e1241[0];
                            }
                            let _e1248 = phi_8713_;
                            if (_e1241[1] < 0.0lf) {
                                phi_8720_ = -(_e1241[1]);
                            } else {
                                phi_8720_ = _e1241[1];
                            }
                            let _e1252 = phi_8720_;
                            if (_e1248 > _e1252) {
                                phi_8725_ = _e1248;
                            } else {
                                phi_8725_ = _e1252;
                            }
                            let _e1255 = phi_8725_;
                            if (_e1241[2] < 0.0lf) {
                                phi_8732_ = -(_e1241[2]);
                            } else {
                                phi_8732_ = _e1241[2];
                            }
                            let _e1259 = phi_8732_;
                            if (_e1255 > _e1259) {
                                phi_8737_ = _e1255;
                            } else {
                                phi_8737_ = _e1259;
                            }
                            let _e1262 = phi_8737_;
                            let _e1265 = local_18.member[1u];
                            if (_e1265[0] < 0.0lf) {
                                phi_8750_ = -(_e1265[0]);
                            } else {
                                phi_8750_ = _e1265[0];
                            }
                            let _e1272 = phi_8750_;
                            if (_e1265[1] < 0.0lf) {
                                phi_8757_ = -(_e1265[1]);
                            } else {
                                phi_8757_ = _e1265[1];
                            }
                            let _e1276 = phi_8757_;
                            if (_e1272 > _e1276) {
                                phi_8762_ = _e1272;
                            } else {
                                phi_8762_ = _e1276;
                            }
                            let _e1279 = phi_8762_;
                            if (_e1265[2] < 0.0lf) {
                                phi_8769_ = -(_e1265[2]);
                            } else {
                                phi_8769_ = _e1265[2];
                            }
                            let _e1283 = phi_8769_;
                            if (_e1279 > _e1283) {
                                phi_8774_ = _e1279;
                            } else {
                                phi_8774_ = _e1283;
                            }
                            let _e1286 = phi_8774_;
                            if (_e1262 > _e1286) {
                                phi_8779_ = _e1262;
                            } else {
                                phi_8779_ = _e1286;
                            }
                            let _e1289 = phi_8779_;
                            let _e1291 = local_18.member_3;
                            let _e1295 = local_18.member_1[0u];
                            if (_e1295[0] < 0.0lf) {
                                phi_8796_ = -(_e1295[0]);
                            } else {
                                phi_8796_ = _e1295[0];
                            }
                            let _e1302 = phi_8796_;
                            if (_e1295[1] < 0.0lf) {
                                phi_8803_ = -(_e1295[1]);
                            } else {
                                phi_8803_ = _e1295[1];
                            }
                            let _e1306 = phi_8803_;
                            if (_e1302 > _e1306) {
                                phi_8808_ = _e1302;
                            } else {
                                phi_8808_ = _e1306;
                            }
                            let _e1309 = phi_8808_;
                            if (_e1295[2] < 0.0lf) {
                                phi_8815_ = -(_e1295[2]);
                            } else {
                                phi_8815_ = _e1295[2];
                            }
                            let _e1313 = phi_8815_;
                            if (_e1309 > _e1313) {
                                phi_8820_ = _e1309;
                            } else {
                                phi_8820_ = _e1313;
                            }
                            let _e1316 = phi_8820_;
                            let _e1319 = local_18.member_1[1u];
                            if (_e1319[0] < 0.0lf) {
                                phi_8834_ = -(_e1319[0]);
                            } else {
                                phi_8834_ = _e1319[0];
                            }
                            let _e1326 = phi_8834_;
                            if (_e1319[1] < 0.0lf) {
                                phi_8841_ = -(_e1319[1]);
                            } else {
                                phi_8841_ = _e1319[1];
                            }
                            let _e1330 = phi_8841_;
                            if (_e1326 > _e1330) {
                                phi_8846_ = _e1326;
                            } else {
                                phi_8846_ = _e1330;
                            }
                            let _e1333 = phi_8846_;
                            if (_e1319[2] < 0.0lf) {
                                phi_8853_ = -(_e1319[2]);
                            } else {
                                phi_8853_ = _e1319[2];
                            }
                            let _e1337 = phi_8853_;
                            if (_e1333 > _e1337) {
                                phi_8858_ = _e1333;
                            } else {
                                phi_8858_ = _e1337;
                            }
                            let _e1340 = phi_8858_;
                            if (_e1316 > _e1340) {
                                phi_8863_ = _e1316;
                            } else {
                                phi_8863_ = _e1340;
                            }
                            let _e1343 = phi_8863_;
                            let _e1345 = local_18.member_3;
                            let _e1349 = local_18.member_2[0u];
                            if (_e1349[0] < 0.0lf) {
                                phi_8880_ = -(_e1349[0]);
                            } else {
                                phi_8880_ = _e1349[0];
                            }
                            let _e1356 = phi_8880_;
                            if (_e1349[1] < 0.0lf) {
                                phi_8887_ = -(_e1349[1]);
                            } else {
                                phi_8887_ = _e1349[1];
                            }
                            let _e1360 = phi_8887_;
                            if (_e1356 > _e1360) {
                                phi_8892_ = _e1356;
                            } else {
                                phi_8892_ = _e1360;
                            }
                            let _e1363 = phi_8892_;
                            if (_e1349[2] < 0.0lf) {
                                phi_8899_ = -(_e1349[2]);
                            } else {
                                phi_8899_ = _e1349[2];
                            }
                            let _e1367 = phi_8899_;
                            if (_e1363 > _e1367) {
                                phi_8904_ = _e1363;
                            } else {
                                phi_8904_ = _e1367;
                            }
                            let _e1370 = phi_8904_;
                            let _e1373 = local_18.member_2[1u];
                            if (_e1373[0] < 0.0lf) {
                                phi_8918_ = -(_e1373[0]);
                            } else {
                                phi_8918_ = _e1373[0];
                            }
                            let _e1380 = phi_8918_;
                            if (_e1373[1] < 0.0lf) {
                                phi_8925_ = -(_e1373[1]);
                            } else {
                                phi_8925_ = _e1373[1];
                            }
                            let _e1384 = phi_8925_;
                            if (_e1380 > _e1384) {
                                phi_8930_ = _e1380;
                            } else {
                                phi_8930_ = _e1384;
                            }
                            let _e1387 = phi_8930_;
                            if (_e1373[2] < 0.0lf) {
                                phi_8937_ = -(_e1373[2]);
                            } else {
                                phi_8937_ = _e1373[2];
                            }
                            let _e1391 = phi_8937_;
                            if (_e1387 > _e1391) {
                                phi_8942_ = _e1387;
                            } else {
                                phi_8942_ = _e1391;
                            }
                            let _e1394 = phi_8942_;
                            if (_e1370 > _e1394) {
                                phi_8947_ = _e1370;
                            } else {
                                phi_8947_ = _e1394;
                            }
                            let _e1397 = phi_8947_;
                            let _e1399 = local_18.member_3;
                            let _e1407 = local_18.member_3;
                            let _e1413 = ((((((_e1289 + _e1291) + (_e1343 + _e1345)) + (_e1397 + _e1399)) * (1.1102230246251565e-16lf * f64(16f))) + (_e1407 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f)));
                            let _e1416 = local_18.member[0u];
                            let _e1422 = local_18.member[1u];
                            let _e1438 = local_18.member_1[0u];
                            let _e1444 = local_18.member_1[1u];
                            let _e1460 = local_18.member_2[0u];
                            let _e1466 = local_18.member_2[1u];
                            let _e1480 = function_4(array<f64, 3>((_e1416[0] + ((_e1422[0] - _e1416[0]) * _e413)), (_e1416[1] + ((_e1422[1] - _e1416[1]) * _e413)), (_e1416[2] + ((_e1422[2] - _e1416[2]) * _e413))), array<f64, 3>((_e1438[0] + ((_e1444[0] - _e1438[0]) * _e413)), (_e1438[1] + ((_e1444[1] - _e1438[1]) * _e413)), (_e1438[2] + ((_e1444[2] - _e1438[2]) * _e413))), array<f64, 3>((_e1460[0] + ((_e1466[0] - _e1460[0]) * _e413)), (_e1460[1] + ((_e1466[1] - _e1460[1]) * _e413)), (_e1460[2] + ((_e1466[2] - _e1460[2]) * _e413))), 1u);
                            if (_e1480[0] < 0.0lf) {
                                phi_9068_ = -(_e1480[0]);
                            } else {
                                phi_9068_ = _e1480[0];
                            }
                            let _e1485 = phi_9068_;
                            if (_e1480[1] < 0.0lf) {
                                phi_9075_ = -(_e1480[1]);
                            } else {
                                phi_9075_ = _e1480[1];
                            }
                            let _e1490 = phi_9075_;
                            if (_e1480[2] < 0.0lf) {
                                phi_9083_ = -(_e1480[2]);
                            } else {
                                phi_9083_ = _e1480[2];
                            }
                            let _e1496 = phi_9083_;
                            let _e1497 = ((_e1485 + _e1490) + _e1496);
                            if (_e1497 > f64(0f)) {
                                if ((bitcast<u64>(_e1497) & 9218868437227405312lu) != 9218868437227405312lu) {
                                    let _e1504 = (f64(1f) / _e1497);
                                    let _e1506 = (_e1480[0] * _e1504);
                                    let _e1508 = (_e1480[1] * _e1504);
                                    let _e1510 = (_e1480[2] * _e1504);
                                    let _e1515 = (((_e1506 * _e1506) + (_e1508 * _e1508)) + (_e1510 * _e1510));
                                    if (_e1515 <= 2.2250738585072014e-308lf) {
                                        if (_e1515 > 0.0lf) {
                                            phi_9122_ = (1.464336215552873e-154lf * 2.0lf);
                                        } else {
                                            phi_9122_ = 0.0lf;
                                        }
                                        let _e1567 = phi_9122_;
                                        phi_9186_ = _e1567;
                                    } else {
                                        phi_9129_ = type_16(0i, 5i);
                                        phi_9132_ = bitcast<f64>(((bitcast<u64>(_e1515) / 2lu) + 2303426169912950784lu));
                                        loop {
                                            let _e1522 = phi_9129_;
                                            let _e1524 = phi_9132_;
                                            local_19 = _e1524;
                                            if (_e1522.member < _e1522.member_1) {
                                                let _e1531 = (_e1522.member + 1i);
                                                if ((false == (_e1531 > _e1522.member)) != false) {
                                                    phi_9153_ = true;
                                                } else {
                                                    phi_9153_ = false;
                                                }
                                                let _e1536 = phi_9153_;
                                                if _e1536 {
                                                    phi_9159_ = type_17(0u, type_17().member_1);
                                                } else {
                                                    phi_9159_ = type_17(1u, _e1531);
                                                }
                                                let _e1541 = phi_9159_;
                                                phi_9130_ = type_16(_e1541.member_1, _e1522.member_1);
                                                phi_9173_ = type_17(1u, _e1522.member);
                                            } else {
                                                phi_9130_ = _e1522;
                                                phi_9173_ = type_17(0u, type_17().member_1);
                                            }
                                            let _e1547 = phi_9130_;
                                            let _e1549 = phi_9173_;
                                            let _e1552 = (bitcast<i32>(_e1549.member) != 0i);
                                            if _e1552 {
                                                phi_9133_ = (0.5lf * (_e1524 + (_e1515 / _e1524)));
                                            } else {
                                                phi_9133_ = f64();
                                            }
                                            let _e1557 = phi_9133_;
                                            continue;
                                            continuing {
                                                phi_9129_ = _e1547;
                                                phi_9132_ = _e1557;
                                                break if !(_e1552);
                                            }
                                        }
                                        let _e1562 = local_19;
                                        phi_9186_ = (_e1562 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                    }
                                    let _e1569 = phi_9186_;
                                    let _e1571 = (1.1102230246251565e-16lf * f64(12f));
                                    let _e1578 = ((_e1413 * f64(1.01f)) + ((_e1184 * _e1569) * (f64(1f) + _e1571)));
                                    let _e1583 = (((_e1506 * _e1187[0]) + (_e1508 * _e1187[1])) + (_e1510 * _e1187[2]));
                                    let _e1588 = (((_e1506 * _e1203) + (_e1508 * _e1204)) + (_e1510 * _e1205));
                                    let _e1593 = (((_e1506 * _e1209) + (_e1508 * _e1210)) + (_e1510 * _e1211));
                                    let _e1598 = (((_e1506 * _e1206) + (_e1508 * _e1207)) + (_e1510 * _e1208));
                                    let _e1604 = (((_e1506 * _e1214[0]) + (_e1508 * _e1214[1])) + (_e1510 * _e1214[2]));
                                    let _e1609 = (((_e1506 * _e1230) + (_e1508 * _e1231)) + (_e1510 * _e1232));
                                    let _e1614 = (((_e1506 * _e1236) + (_e1508 * _e1237)) + (_e1510 * _e1238));
                                    let _e1619 = (((_e1506 * _e1233) + (_e1508 * _e1234)) + (_e1510 * _e1235));
                                    if (_e1583 < 0.0lf) {
                                        phi_9255_ = -(_e1583);
                                    } else {
                                        phi_9255_ = _e1583;
                                    }
                                    let _e1624 = phi_9255_;
                                    if (_e1604 < 0.0lf) {
                                        phi_9261_ = -(_e1604);
                                    } else {
                                        phi_9261_ = _e1604;
                                    }
                                    let _e1628 = phi_9261_;
                                    if (_e1588 < 0.0lf) {
                                        phi_9270_ = -(_e1588);
                                    } else {
                                        phi_9270_ = _e1588;
                                    }
                                    let _e1635 = phi_9270_;
                                    if (_e1609 < 0.0lf) {
                                        phi_9276_ = -(_e1609);
                                    } else {
                                        phi_9276_ = _e1609;
                                    }
                                    let _e1639 = phi_9276_;
                                    if (_e1593 < 0.0lf) {
                                        phi_9285_ = -(_e1593);
                                    } else {
                                        phi_9285_ = _e1593;
                                    }
                                    let _e1646 = phi_9285_;
                                    if (_e1614 < 0.0lf) {
                                        phi_9291_ = -(_e1614);
                                    } else {
                                        phi_9291_ = _e1614;
                                    }
                                    let _e1650 = phi_9291_;
                                    if (_e1598 < 0.0lf) {
                                        phi_9300_ = -(_e1598);
                                    } else {
                                        phi_9300_ = _e1598;
                                    }
                                    let _e1657 = phi_9300_;
                                    if (_e1619 < 0.0lf) {
                                        phi_9306_ = -(_e1619);
                                    } else {
                                        phi_9306_ = _e1619;
                                    }
                                    let _e1661 = phi_9306_;
                                    phi_9312_ = type_38(array<f64, 4>(_e1583, _e1588, _e1593, _e1598), array<f64, 4>(_e1604, _e1609, _e1614, _e1619), array<f64, 4>((_e1578 + ((_e1624 + _e1628) * _e1571)), (_e1578 + ((_e1635 + _e1639) * _e1571)), (_e1578 + ((_e1646 + _e1650) * _e1571)), (_e1578 + ((_e1657 + _e1661) * _e1571))));
                                    phi_9313_ = false;
                                } else {
                                    phi_9312_ = type_38();
                                    phi_9313_ = true;
                                }
                                let _e1668 = phi_9312_;
                                let _e1670 = phi_9313_;
                                phi_9314_ = _e1668;
                                phi_9315_ = _e1670;
                            } else {
                                phi_9314_ = type_38();
                                phi_9315_ = true;
                            }
                            let _e1672 = phi_9314_;
                            let _e1674 = phi_9315_;
                            if _e1674 {
                                let _e1675 = f64(0f);
                                let _e1676 = f64(1f);
                                phi_9325_ = type_38(array<f64, 4>(_e1675, _e1675, _e1675, _e1675), array<f64, 4>(_e1675, _e1675, _e1675, _e1675), array<f64, 4>(_e1676, _e1676, _e1676, _e1676));
                            } else {
                                phi_9325_ = _e1672;
                            }
                            let _e1682 = phi_9325_;
                            local_8 = type_38(array<f64, 4>(_e1682.member[0], _e1682.member[1], _e1682.member[2], _e1682.member[3]), array<f64, 4>(_e1682.member_1[0], _e1682.member_1[1], _e1682.member_1[2], _e1682.member_1[3]), array<f64, 4>(_e1682.member_2[0], _e1682.member_2[1], _e1682.member_2[2], _e1682.member_2[3]));
                            let _e1702 = f64(0f);
                            let _e1705 = local_8.member[0u];
                            let _e1708 = local_8.member_1[0u];
                            let _e1711 = local_8.member[0u];
                            let _e1717 = local_8.member_2[0u];
                            if (((_e1705 + ((_e1708 - _e1711) * _e413)) - _e1717) > _e1702) {
                                let _e1722 = local_8.member[1u];
                                let _e1725 = local_8.member_1[1u];
                                let _e1728 = local_8.member[1u];
                                let _e1734 = local_8.member_2[1u];
                                if (((_e1722 + ((_e1725 - _e1728) * _e413)) - _e1734) > _e1702) {
                                    let _e1739 = local_8.member[2u];
                                    let _e1742 = local_8.member_1[2u];
                                    let _e1745 = local_8.member[2u];
                                    let _e1751 = local_8.member_2[2u];
                                    if (((_e1739 + ((_e1742 - _e1745) * _e413)) - _e1751) > _e1702) {
                                        let _e1756 = local_8.member[3u];
                                        let _e1759 = local_8.member_1[3u];
                                        let _e1762 = local_8.member[3u];
                                        let _e1768 = local_8.member_2[3u];
                                        phi_9495_ = (((_e1756 + ((_e1759 - _e1762) * _e413)) - _e1768) > _e1702);
                                        phi_9496_ = false;
                                    } else {
                                        phi_9495_ = bool();
                                        phi_9496_ = true;
                                    }
                                    let _e1772 = phi_9495_;
                                    let _e1774 = phi_9496_;
                                    phi_9497_ = _e1772;
                                    phi_9498_ = _e1774;
                                } else {
                                    phi_9497_ = bool();
                                    phi_9498_ = true;
                                }
                                let _e1776 = phi_9497_;
                                let _e1778 = phi_9498_;
                                phi_9499_ = _e1776;
                                phi_9500_ = _e1778;
                            } else {
                                phi_9499_ = bool();
                                phi_9500_ = true;
                            }
                            let _e1780 = phi_9499_;
                            let _e1782 = phi_9500_;
                            if _e1782 {
                                phi_9504_ = false;
                            } else {
                                phi_9504_ = _e1780;
                            }
                            let _e1784 = phi_9504_;
                            if _e1784 {
                                phi_10885_ = bool();
                                phi_10886_ = true;
                            } else {
                                let _e1785 = f64(0f);
                                if (_e1480[0] < 0.0lf) {
                                    phi_9532_ = -(_e1480[0]);
                                } else {
                                    phi_9532_ = _e1480[0];
                                }
                                let _e1790 = phi_9532_;
                                if (_e1785 < 0.0lf) {
                                    phi_9538_ = -(_e1785);
                                } else {
                                    phi_9538_ = _e1785;
                                }
                                let _e1794 = phi_9538_;
                                if (_e1785 < 0.0lf) {
                                    phi_9545_ = -(_e1785);
                                } else {
                                    phi_9545_ = _e1785;
                                }
                                let _e1799 = phi_9545_;
                                let _e1800 = ((_e1790 + _e1794) + _e1799);
                                if (_e1800 > f64(0f)) {
                                    if ((bitcast<u64>(_e1800) & 9218868437227405312lu) != 9218868437227405312lu) {
                                        let _e1807 = (f64(1f) / _e1800);
                                        let _e1808 = (_e1480[0] * _e1807);
                                        let _e1809 = (_e1785 * _e1807);
                                        let _e1810 = (_e1785 * _e1807);
                                        let _e1815 = (((_e1808 * _e1808) + (_e1809 * _e1809)) + (_e1810 * _e1810));
                                        if (_e1815 <= 2.2250738585072014e-308lf) {
                                            if (_e1815 > 0.0lf) {
                                                phi_9581_ = (1.464336215552873e-154lf * 2.0lf);
                                            } else {
                                                phi_9581_ = 0.0lf;
                                            }
                                            let _e1867 = phi_9581_;
                                            phi_9645_ = _e1867;
                                        } else {
                                            phi_9588_ = type_16(0i, 5i);
                                            phi_9591_ = bitcast<f64>(((bitcast<u64>(_e1815) / 2lu) + 2303426169912950784lu));
                                            loop {
                                                let _e1822 = phi_9588_;
                                                let _e1824 = phi_9591_;
                                                local_20 = _e1824;
                                                if (_e1822.member < _e1822.member_1) {
                                                    let _e1831 = (_e1822.member + 1i);
                                                    if ((false == (_e1831 > _e1822.member)) != false) {
                                                        phi_9612_ = true;
                                                    } else {
                                                        phi_9612_ = false;
                                                    }
                                                    let _e1836 = phi_9612_;
                                                    if _e1836 {
                                                        phi_9618_ = type_17(0u, type_17().member_1);
                                                    } else {
                                                        phi_9618_ = type_17(1u, _e1831);
                                                    }
                                                    let _e1841 = phi_9618_;
                                                    phi_9589_ = type_16(_e1841.member_1, _e1822.member_1);
                                                    phi_9632_ = type_17(1u, _e1822.member);
                                                } else {
                                                    phi_9589_ = _e1822;
                                                    phi_9632_ = type_17(0u, type_17().member_1);
                                                }
                                                let _e1847 = phi_9589_;
                                                let _e1849 = phi_9632_;
                                                let _e1852 = (bitcast<i32>(_e1849.member) != 0i);
                                                if _e1852 {
                                                    phi_9592_ = (0.5lf * (_e1824 + (_e1815 / _e1824)));
                                                } else {
                                                    phi_9592_ = f64();
                                                }
                                                let _e1857 = phi_9592_;
                                                continue;
                                                continuing {
                                                    phi_9588_ = _e1847;
                                                    phi_9591_ = _e1857;
                                                    break if !(_e1852);
                                                }
                                            }
                                            let _e1862 = local_20;
                                            phi_9645_ = (_e1862 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                        }
                                        let _e1869 = phi_9645_;
                                        let _e1871 = (1.1102230246251565e-16lf * f64(12f));
                                        let _e1878 = ((_e1413 * f64(1.01f)) + ((_e1184 * _e1869) * (f64(1f) + _e1871)));
                                        let _e1883 = (((_e1808 * _e1187[0]) + (_e1809 * _e1187[1])) + (_e1810 * _e1187[2]));
                                        let _e1888 = (((_e1808 * _e1203) + (_e1809 * _e1204)) + (_e1810 * _e1205));
                                        let _e1893 = (((_e1808 * _e1209) + (_e1809 * _e1210)) + (_e1810 * _e1211));
                                        let _e1898 = (((_e1808 * _e1206) + (_e1809 * _e1207)) + (_e1810 * _e1208));
                                        let _e1904 = (((_e1808 * _e1214[0]) + (_e1809 * _e1214[1])) + (_e1810 * _e1214[2]));
                                        let _e1909 = (((_e1808 * _e1230) + (_e1809 * _e1231)) + (_e1810 * _e1232));
                                        let _e1914 = (((_e1808 * _e1236) + (_e1809 * _e1237)) + (_e1810 * _e1238));
                                        let _e1919 = (((_e1808 * _e1233) + (_e1809 * _e1234)) + (_e1810 * _e1235));
                                        if (_e1883 < 0.0lf) {
                                            phi_9714_ = -(_e1883);
                                        } else {
                                            phi_9714_ = _e1883;
                                        }
                                        let _e1924 = phi_9714_;
                                        if (_e1904 < 0.0lf) {
                                            phi_9720_ = -(_e1904);
                                        } else {
                                            phi_9720_ = _e1904;
                                        }
                                        let _e1928 = phi_9720_;
                                        if (_e1888 < 0.0lf) {
                                            phi_9729_ = -(_e1888);
                                        } else {
                                            phi_9729_ = _e1888;
                                        }
                                        let _e1935 = phi_9729_;
                                        if (_e1909 < 0.0lf) {
                                            phi_9735_ = -(_e1909);
                                        } else {
                                            phi_9735_ = _e1909;
                                        }
                                        let _e1939 = phi_9735_;
                                        if (_e1893 < 0.0lf) {
                                            phi_9744_ = -(_e1893);
                                        } else {
                                            phi_9744_ = _e1893;
                                        }
                                        let _e1946 = phi_9744_;
                                        if (_e1914 < 0.0lf) {
                                            phi_9750_ = -(_e1914);
                                        } else {
                                            phi_9750_ = _e1914;
                                        }
                                        let _e1950 = phi_9750_;
                                        if (_e1898 < 0.0lf) {
                                            phi_9759_ = -(_e1898);
                                        } else {
                                            phi_9759_ = _e1898;
                                        }
                                        let _e1957 = phi_9759_;
                                        if (_e1919 < 0.0lf) {
                                            phi_9765_ = -(_e1919);
                                        } else {
                                            phi_9765_ = _e1919;
                                        }
                                        let _e1961 = phi_9765_;
                                        phi_9771_ = type_38(array<f64, 4>(_e1883, _e1888, _e1893, _e1898), array<f64, 4>(_e1904, _e1909, _e1914, _e1919), array<f64, 4>((_e1878 + ((_e1924 + _e1928) * _e1871)), (_e1878 + ((_e1935 + _e1939) * _e1871)), (_e1878 + ((_e1946 + _e1950) * _e1871)), (_e1878 + ((_e1957 + _e1961) * _e1871))));
                                        phi_9772_ = false;
                                    } else {
                                        phi_9771_ = type_38();
                                        phi_9772_ = true;
                                    }
                                    let _e1968 = phi_9771_;
                                    let _e1970 = phi_9772_;
                                    phi_9773_ = _e1968;
                                    phi_9774_ = _e1970;
                                } else {
                                    phi_9773_ = type_38();
                                    phi_9774_ = true;
                                }
                                let _e1972 = phi_9773_;
                                let _e1974 = phi_9774_;
                                if _e1974 {
                                    let _e1975 = f64(0f);
                                    let _e1976 = f64(1f);
                                    phi_9784_ = type_38(array<f64, 4>(_e1975, _e1975, _e1975, _e1975), array<f64, 4>(_e1975, _e1975, _e1975, _e1975), array<f64, 4>(_e1976, _e1976, _e1976, _e1976));
                                } else {
                                    phi_9784_ = _e1972;
                                }
                                let _e1982 = phi_9784_;
                                local_9 = type_38(array<f64, 4>(_e1982.member[0], _e1982.member[1], _e1982.member[2], _e1982.member[3]), array<f64, 4>(_e1982.member_1[0], _e1982.member_1[1], _e1982.member_1[2], _e1982.member_1[3]), array<f64, 4>(_e1982.member_2[0], _e1982.member_2[1], _e1982.member_2[2], _e1982.member_2[3]));
                                let _e2002 = f64(0f);
                                let _e2005 = local_9.member[0u];
                                let _e2008 = local_9.member_1[0u];
                                let _e2011 = local_9.member[0u];
                                let _e2017 = local_9.member_2[0u];
                                if (((_e2005 + ((_e2008 - _e2011) * _e413)) - _e2017) > _e2002) {
                                    let _e2022 = local_9.member[1u];
                                    let _e2025 = local_9.member_1[1u];
                                    let _e2028 = local_9.member[1u];
                                    let _e2034 = local_9.member_2[1u];
                                    if (((_e2022 + ((_e2025 - _e2028) * _e413)) - _e2034) > _e2002) {
                                        let _e2039 = local_9.member[2u];
                                        let _e2042 = local_9.member_1[2u];
                                        let _e2045 = local_9.member[2u];
                                        let _e2051 = local_9.member_2[2u];
                                        if (((_e2039 + ((_e2042 - _e2045) * _e413)) - _e2051) > _e2002) {
                                            let _e2056 = local_9.member[3u];
                                            let _e2059 = local_9.member_1[3u];
                                            let _e2062 = local_9.member[3u];
                                            let _e2068 = local_9.member_2[3u];
                                            phi_9954_ = (((_e2056 + ((_e2059 - _e2062) * _e413)) - _e2068) > _e2002);
                                            phi_9955_ = false;
                                        } else {
                                            phi_9954_ = bool();
                                            phi_9955_ = true;
                                        }
                                        let _e2072 = phi_9954_;
                                        let _e2074 = phi_9955_;
                                        phi_9956_ = _e2072;
                                        phi_9957_ = _e2074;
                                    } else {
                                        phi_9956_ = bool();
                                        phi_9957_ = true;
                                    }
                                    let _e2076 = phi_9956_;
                                    let _e2078 = phi_9957_;
                                    phi_9958_ = _e2076;
                                    phi_9959_ = _e2078;
                                } else {
                                    phi_9958_ = bool();
                                    phi_9959_ = true;
                                }
                                let _e2080 = phi_9958_;
                                let _e2082 = phi_9959_;
                                if _e2082 {
                                    phi_9963_ = false;
                                } else {
                                    phi_9963_ = _e2080;
                                }
                                let _e2084 = phi_9963_;
                                if _e2084 {
                                    phi_10883_ = bool();
                                    phi_10884_ = true;
                                } else {
                                    let _e2085 = f64(0f);
                                    if (_e2085 < 0.0lf) {
                                        phi_9991_ = -(_e2085);
                                    } else {
                                        phi_9991_ = _e2085;
                                    }
                                    let _e2090 = phi_9991_;
                                    if (_e1480[1] < 0.0lf) {
                                        phi_9997_ = -(_e1480[1]);
                                    } else {
                                        phi_9997_ = _e1480[1];
                                    }
                                    let _e2094 = phi_9997_;
                                    if (_e2085 < 0.0lf) {
                                        phi_10004_ = -(_e2085);
                                    } else {
                                        phi_10004_ = _e2085;
                                    }
                                    let _e2099 = phi_10004_;
                                    let _e2100 = ((_e2090 + _e2094) + _e2099);
                                    if (_e2100 > f64(0f)) {
                                        if ((bitcast<u64>(_e2100) & 9218868437227405312lu) != 9218868437227405312lu) {
                                            let _e2107 = (f64(1f) / _e2100);
                                            let _e2108 = (_e2085 * _e2107);
                                            let _e2109 = (_e1480[1] * _e2107);
                                            let _e2110 = (_e2085 * _e2107);
                                            let _e2115 = (((_e2108 * _e2108) + (_e2109 * _e2109)) + (_e2110 * _e2110));
                                            if (_e2115 <= 2.2250738585072014e-308lf) {
                                                if (_e2115 > 0.0lf) {
                                                    phi_10040_ = (1.464336215552873e-154lf * 2.0lf);
                                                } else {
                                                    phi_10040_ = 0.0lf;
                                                }
                                                let _e2167 = phi_10040_;
                                                phi_10104_ = _e2167;
                                            } else {
                                                phi_10047_ = type_16(0i, 5i);
                                                phi_10050_ = bitcast<f64>(((bitcast<u64>(_e2115) / 2lu) + 2303426169912950784lu));
                                                loop {
                                                    let _e2122 = phi_10047_;
                                                    let _e2124 = phi_10050_;
                                                    local_21 = _e2124;
                                                    if (_e2122.member < _e2122.member_1) {
                                                        let _e2131 = (_e2122.member + 1i);
                                                        if ((false == (_e2131 > _e2122.member)) != false) {
                                                            phi_10071_ = true;
                                                        } else {
                                                            phi_10071_ = false;
                                                        }
                                                        let _e2136 = phi_10071_;
                                                        if _e2136 {
                                                            phi_10077_ = type_17(0u, type_17().member_1);
                                                        } else {
                                                            phi_10077_ = type_17(1u, _e2131);
                                                        }
                                                        let _e2141 = phi_10077_;
                                                        phi_10048_ = type_16(_e2141.member_1, _e2122.member_1);
                                                        phi_10091_ = type_17(1u, _e2122.member);
                                                    } else {
                                                        phi_10048_ = _e2122;
                                                        phi_10091_ = type_17(0u, type_17().member_1);
                                                    }
                                                    let _e2147 = phi_10048_;
                                                    let _e2149 = phi_10091_;
                                                    let _e2152 = (bitcast<i32>(_e2149.member) != 0i);
                                                    if _e2152 {
                                                        phi_10051_ = (0.5lf * (_e2124 + (_e2115 / _e2124)));
                                                    } else {
                                                        phi_10051_ = f64();
                                                    }
                                                    let _e2157 = phi_10051_;
                                                    continue;
                                                    continuing {
                                                        phi_10047_ = _e2147;
                                                        phi_10050_ = _e2157;
                                                        break if !(_e2152);
                                                    }
                                                }
                                                let _e2162 = local_21;
                                                phi_10104_ = (_e2162 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                            }
                                            let _e2169 = phi_10104_;
                                            let _e2171 = (1.1102230246251565e-16lf * f64(12f));
                                            let _e2178 = ((_e1413 * f64(1.01f)) + ((_e1184 * _e2169) * (f64(1f) + _e2171)));
                                            let _e2183 = (((_e2108 * _e1187[0]) + (_e2109 * _e1187[1])) + (_e2110 * _e1187[2]));
                                            let _e2188 = (((_e2108 * _e1203) + (_e2109 * _e1204)) + (_e2110 * _e1205));
                                            let _e2193 = (((_e2108 * _e1209) + (_e2109 * _e1210)) + (_e2110 * _e1211));
                                            let _e2198 = (((_e2108 * _e1206) + (_e2109 * _e1207)) + (_e2110 * _e1208));
                                            let _e2204 = (((_e2108 * _e1214[0]) + (_e2109 * _e1214[1])) + (_e2110 * _e1214[2]));
                                            let _e2209 = (((_e2108 * _e1230) + (_e2109 * _e1231)) + (_e2110 * _e1232));
                                            let _e2214 = (((_e2108 * _e1236) + (_e2109 * _e1237)) + (_e2110 * _e1238));
                                            let _e2219 = (((_e2108 * _e1233) + (_e2109 * _e1234)) + (_e2110 * _e1235));
                                            if (_e2183 < 0.0lf) {
                                                phi_10173_ = -(_e2183);
                                            } else {
                                                phi_10173_ = _e2183;
                                            }
                                            let _e2224 = phi_10173_;
                                            if (_e2204 < 0.0lf) {
                                                phi_10179_ = -(_e2204);
                                            } else {
                                                phi_10179_ = _e2204;
                                            }
                                            let _e2228 = phi_10179_;
                                            if (_e2188 < 0.0lf) {
                                                phi_10188_ = -(_e2188);
                                            } else {
                                                phi_10188_ = _e2188;
                                            }
                                            let _e2235 = phi_10188_;
                                            if (_e2209 < 0.0lf) {
                                                phi_10194_ = -(_e2209);
                                            } else {
                                                phi_10194_ = _e2209;
                                            }
                                            let _e2239 = phi_10194_;
                                            if (_e2193 < 0.0lf) {
                                                phi_10203_ = -(_e2193);
                                            } else {
                                                phi_10203_ = _e2193;
                                            }
                                            let _e2246 = phi_10203_;
                                            if (_e2214 < 0.0lf) {
                                                phi_10209_ = -(_e2214);
                                            } else {
                                                phi_10209_ = _e2214;
                                            }
                                            let _e2250 = phi_10209_;
                                            if (_e2198 < 0.0lf) {
                                                phi_10218_ = -(_e2198);
                                            } else {
                                                phi_10218_ = _e2198;
                                            }
                                            let _e2257 = phi_10218_;
                                            if (_e2219 < 0.0lf) {
                                                phi_10224_ = -(_e2219);
                                            } else {
                                                phi_10224_ = _e2219;
                                            }
                                            let _e2261 = phi_10224_;
                                            phi_10230_ = type_38(array<f64, 4>(_e2183, _e2188, _e2193, _e2198), array<f64, 4>(_e2204, _e2209, _e2214, _e2219), array<f64, 4>((_e2178 + ((_e2224 + _e2228) * _e2171)), (_e2178 + ((_e2235 + _e2239) * _e2171)), (_e2178 + ((_e2246 + _e2250) * _e2171)), (_e2178 + ((_e2257 + _e2261) * _e2171))));
                                            phi_10231_ = false;
                                        } else {
                                            phi_10230_ = type_38();
                                            phi_10231_ = true;
                                        }
                                        let _e2268 = phi_10230_;
                                        let _e2270 = phi_10231_;
                                        phi_10232_ = _e2268;
                                        phi_10233_ = _e2270;
                                    } else {
                                        phi_10232_ = type_38();
                                        phi_10233_ = true;
                                    }
                                    let _e2272 = phi_10232_;
                                    let _e2274 = phi_10233_;
                                    if _e2274 {
                                        let _e2275 = f64(0f);
                                        let _e2276 = f64(1f);
                                        phi_10243_ = type_38(array<f64, 4>(_e2275, _e2275, _e2275, _e2275), array<f64, 4>(_e2275, _e2275, _e2275, _e2275), array<f64, 4>(_e2276, _e2276, _e2276, _e2276));
                                    } else {
                                        phi_10243_ = _e2272;
                                    }
                                    let _e2282 = phi_10243_;
                                    local_10 = type_38(array<f64, 4>(_e2282.member[0], _e2282.member[1], _e2282.member[2], _e2282.member[3]), array<f64, 4>(_e2282.member_1[0], _e2282.member_1[1], _e2282.member_1[2], _e2282.member_1[3]), array<f64, 4>(_e2282.member_2[0], _e2282.member_2[1], _e2282.member_2[2], _e2282.member_2[3]));
                                    let _e2302 = f64(0f);
                                    let _e2305 = local_10.member[0u];
                                    let _e2308 = local_10.member_1[0u];
                                    let _e2311 = local_10.member[0u];
                                    let _e2317 = local_10.member_2[0u];
                                    if (((_e2305 + ((_e2308 - _e2311) * _e413)) - _e2317) > _e2302) {
                                        let _e2322 = local_10.member[1u];
                                        let _e2325 = local_10.member_1[1u];
                                        let _e2328 = local_10.member[1u];
                                        let _e2334 = local_10.member_2[1u];
                                        if (((_e2322 + ((_e2325 - _e2328) * _e413)) - _e2334) > _e2302) {
                                            let _e2339 = local_10.member[2u];
                                            let _e2342 = local_10.member_1[2u];
                                            let _e2345 = local_10.member[2u];
                                            let _e2351 = local_10.member_2[2u];
                                            if (((_e2339 + ((_e2342 - _e2345) * _e413)) - _e2351) > _e2302) {
                                                let _e2356 = local_10.member[3u];
                                                let _e2359 = local_10.member_1[3u];
                                                let _e2362 = local_10.member[3u];
                                                let _e2368 = local_10.member_2[3u];
                                                phi_10413_ = (((_e2356 + ((_e2359 - _e2362) * _e413)) - _e2368) > _e2302);
                                                phi_10414_ = false;
                                            } else {
                                                phi_10413_ = bool();
                                                phi_10414_ = true;
                                            }
                                            let _e2372 = phi_10413_;
                                            let _e2374 = phi_10414_;
                                            phi_10415_ = _e2372;
                                            phi_10416_ = _e2374;
                                        } else {
                                            phi_10415_ = bool();
                                            phi_10416_ = true;
                                        }
                                        let _e2376 = phi_10415_;
                                        let _e2378 = phi_10416_;
                                        phi_10417_ = _e2376;
                                        phi_10418_ = _e2378;
                                    } else {
                                        phi_10417_ = bool();
                                        phi_10418_ = true;
                                    }
                                    let _e2380 = phi_10417_;
                                    let _e2382 = phi_10418_;
                                    if _e2382 {
                                        phi_10422_ = false;
                                    } else {
                                        phi_10422_ = _e2380;
                                    }
                                    let _e2384 = phi_10422_;
                                    if _e2384 {
                                        phi_10882_ = bool();
                                    } else {
                                        let _e2385 = f64(0f);
                                        if (_e2385 < 0.0lf) {
                                            phi_10450_ = -(_e2385);
                                        } else {
                                            phi_10450_ = _e2385;
                                        }
                                        let _e2390 = phi_10450_;
                                        if (_e2385 < 0.0lf) {
                                            phi_10456_ = -(_e2385);
                                        } else {
                                            phi_10456_ = _e2385;
                                        }
                                        let _e2394 = phi_10456_;
                                        if (_e1480[2] < 0.0lf) {
                                            phi_10463_ = -(_e1480[2]);
                                        } else {
                                            phi_10463_ = _e1480[2];
                                        }
                                        let _e2399 = phi_10463_;
                                        let _e2400 = ((_e2390 + _e2394) + _e2399);
                                        if (_e2400 > f64(0f)) {
                                            if ((bitcast<u64>(_e2400) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                let _e2407 = (f64(1f) / _e2400);
                                                let _e2408 = (_e2385 * _e2407);
                                                let _e2409 = (_e2385 * _e2407);
                                                let _e2410 = (_e1480[2] * _e2407);
                                                let _e2415 = (((_e2408 * _e2408) + (_e2409 * _e2409)) + (_e2410 * _e2410));
                                                if (_e2415 <= 2.2250738585072014e-308lf) {
                                                    if (_e2415 > 0.0lf) {
                                                        phi_10499_ = (1.464336215552873e-154lf * 2.0lf);
                                                    } else {
                                                        phi_10499_ = 0.0lf;
                                                    }
                                                    let _e2467 = phi_10499_;
                                                    phi_10563_ = _e2467;
                                                } else {
                                                    phi_10506_ = type_16(0i, 5i);
                                                    phi_10509_ = bitcast<f64>(((bitcast<u64>(_e2415) / 2lu) + 2303426169912950784lu));
                                                    loop {
                                                        let _e2422 = phi_10506_;
                                                        let _e2424 = phi_10509_;
                                                        local_22 = _e2424;
                                                        if (_e2422.member < _e2422.member_1) {
                                                            let _e2431 = (_e2422.member + 1i);
                                                            if ((false == (_e2431 > _e2422.member)) != false) {
                                                                phi_10530_ = true;
                                                            } else {
                                                                phi_10530_ = false;
                                                            }
                                                            let _e2436 = phi_10530_;
                                                            if _e2436 {
                                                                phi_10536_ = type_17(0u, type_17().member_1);
                                                            } else {
                                                                phi_10536_ = type_17(1u, _e2431);
                                                            }
                                                            let _e2441 = phi_10536_;
                                                            phi_10507_ = type_16(_e2441.member_1, _e2422.member_1);
                                                            phi_10550_ = type_17(1u, _e2422.member);
                                                        } else {
                                                            phi_10507_ = _e2422;
                                                            phi_10550_ = type_17(0u, type_17().member_1);
                                                        }
                                                        let _e2447 = phi_10507_;
                                                        let _e2449 = phi_10550_;
                                                        let _e2452 = (bitcast<i32>(_e2449.member) != 0i);
                                                        if _e2452 {
                                                            phi_10510_ = (0.5lf * (_e2424 + (_e2415 / _e2424)));
                                                        } else {
                                                            phi_10510_ = f64();
                                                        }
                                                        let _e2457 = phi_10510_;
                                                        continue;
                                                        continuing {
                                                            phi_10506_ = _e2447;
                                                            phi_10509_ = _e2457;
                                                            break if !(_e2452);
                                                        }
                                                    }
                                                    let _e2462 = local_22;
                                                    phi_10563_ = (_e2462 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                }
                                                let _e2469 = phi_10563_;
                                                let _e2471 = (1.1102230246251565e-16lf * f64(12f));
                                                let _e2478 = ((_e1413 * f64(1.01f)) + ((_e1184 * _e2469) * (f64(1f) + _e2471)));
                                                let _e2483 = (((_e2408 * _e1187[0]) + (_e2409 * _e1187[1])) + (_e2410 * _e1187[2]));
                                                let _e2488 = (((_e2408 * _e1203) + (_e2409 * _e1204)) + (_e2410 * _e1205));
                                                let _e2493 = (((_e2408 * _e1209) + (_e2409 * _e1210)) + (_e2410 * _e1211));
                                                let _e2498 = (((_e2408 * _e1206) + (_e2409 * _e1207)) + (_e2410 * _e1208));
                                                let _e2504 = (((_e2408 * _e1214[0]) + (_e2409 * _e1214[1])) + (_e2410 * _e1214[2]));
                                                let _e2509 = (((_e2408 * _e1230) + (_e2409 * _e1231)) + (_e2410 * _e1232));
                                                let _e2514 = (((_e2408 * _e1236) + (_e2409 * _e1237)) + (_e2410 * _e1238));
                                                let _e2519 = (((_e2408 * _e1233) + (_e2409 * _e1234)) + (_e2410 * _e1235));
                                                if (_e2483 < 0.0lf) {
                                                    phi_10632_ = -(_e2483);
                                                } else {
                                                    phi_10632_ = _e2483;
                                                }
                                                let _e2524 = phi_10632_;
                                                if (_e2504 < 0.0lf) {
                                                    phi_10638_ = -(_e2504);
                                                } else {
                                                    phi_10638_ = _e2504;
                                                }
                                                let _e2528 = phi_10638_;
                                                if (_e2488 < 0.0lf) {
                                                    phi_10647_ = -(_e2488);
                                                } else {
                                                    phi_10647_ = _e2488;
                                                }
                                                let _e2535 = phi_10647_;
                                                if (_e2509 < 0.0lf) {
                                                    phi_10653_ = -(_e2509);
                                                } else {
                                                    phi_10653_ = _e2509;
                                                }
                                                let _e2539 = phi_10653_;
                                                if (_e2493 < 0.0lf) {
                                                    phi_10662_ = -(_e2493);
                                                } else {
                                                    phi_10662_ = _e2493;
                                                }
                                                let _e2546 = phi_10662_;
                                                if (_e2514 < 0.0lf) {
                                                    phi_10668_ = -(_e2514);
                                                } else {
                                                    phi_10668_ = _e2514;
                                                }
                                                let _e2550 = phi_10668_;
                                                if (_e2498 < 0.0lf) {
                                                    phi_10677_ = -(_e2498);
                                                } else {
                                                    phi_10677_ = _e2498;
                                                }
                                                let _e2557 = phi_10677_;
                                                if (_e2519 < 0.0lf) {
                                                    phi_10683_ = -(_e2519);
                                                } else {
                                                    phi_10683_ = _e2519;
                                                }
                                                let _e2561 = phi_10683_;
                                                phi_10689_ = type_38(array<f64, 4>(_e2483, _e2488, _e2493, _e2498), array<f64, 4>(_e2504, _e2509, _e2514, _e2519), array<f64, 4>((_e2478 + ((_e2524 + _e2528) * _e2471)), (_e2478 + ((_e2535 + _e2539) * _e2471)), (_e2478 + ((_e2546 + _e2550) * _e2471)), (_e2478 + ((_e2557 + _e2561) * _e2471))));
                                                phi_10690_ = false;
                                            } else {
                                                phi_10689_ = type_38();
                                                phi_10690_ = true;
                                            }
                                            let _e2568 = phi_10689_;
                                            let _e2570 = phi_10690_;
                                            phi_10691_ = _e2568;
                                            phi_10692_ = _e2570;
                                        } else {
                                            phi_10691_ = type_38();
                                            phi_10692_ = true;
                                        }
                                        let _e2572 = phi_10691_;
                                        let _e2574 = phi_10692_;
                                        if _e2574 {
                                            let _e2575 = f64(0f);
                                            let _e2576 = f64(1f);
                                            phi_10702_ = type_38(array<f64, 4>(_e2575, _e2575, _e2575, _e2575), array<f64, 4>(_e2575, _e2575, _e2575, _e2575), array<f64, 4>(_e2576, _e2576, _e2576, _e2576));
                                        } else {
                                            phi_10702_ = _e2572;
                                        }
                                        let _e2582 = phi_10702_;
                                        local_11 = type_38(array<f64, 4>(_e2582.member[0], _e2582.member[1], _e2582.member[2], _e2582.member[3]), array<f64, 4>(_e2582.member_1[0], _e2582.member_1[1], _e2582.member_1[2], _e2582.member_1[3]), array<f64, 4>(_e2582.member_2[0], _e2582.member_2[1], _e2582.member_2[2], _e2582.member_2[3]));
                                        let _e2602 = f64(0f);
                                        let _e2605 = local_11.member[0u];
                                        let _e2608 = local_11.member_1[0u];
                                        let _e2611 = local_11.member[0u];
                                        let _e2617 = local_11.member_2[0u];
                                        if (((_e2605 + ((_e2608 - _e2611) * _e413)) - _e2617) > _e2602) {
                                            let _e2622 = local_11.member[1u];
                                            let _e2625 = local_11.member_1[1u];
                                            let _e2628 = local_11.member[1u];
                                            let _e2634 = local_11.member_2[1u];
                                            if (((_e2622 + ((_e2625 - _e2628) * _e413)) - _e2634) > _e2602) {
                                                let _e2639 = local_11.member[2u];
                                                let _e2642 = local_11.member_1[2u];
                                                let _e2645 = local_11.member[2u];
                                                let _e2651 = local_11.member_2[2u];
                                                if (((_e2639 + ((_e2642 - _e2645) * _e413)) - _e2651) > _e2602) {
                                                    let _e2656 = local_11.member[3u];
                                                    let _e2659 = local_11.member_1[3u];
                                                    let _e2662 = local_11.member[3u];
                                                    let _e2668 = local_11.member_2[3u];
                                                    phi_10872_ = (((_e2656 + ((_e2659 - _e2662) * _e413)) - _e2668) > _e2602);
                                                    phi_10873_ = false;
                                                } else {
                                                    phi_10872_ = bool();
                                                    phi_10873_ = true;
                                                }
                                                let _e2672 = phi_10872_;
                                                let _e2674 = phi_10873_;
                                                phi_10874_ = _e2672;
                                                phi_10875_ = _e2674;
                                            } else {
                                                phi_10874_ = bool();
                                                phi_10875_ = true;
                                            }
                                            let _e2676 = phi_10874_;
                                            let _e2678 = phi_10875_;
                                            phi_10876_ = _e2676;
                                            phi_10877_ = _e2678;
                                        } else {
                                            phi_10876_ = bool();
                                            phi_10877_ = true;
                                        }
                                        let _e2680 = phi_10876_;
                                        let _e2682 = phi_10877_;
                                        if _e2682 {
                                            phi_10881_ = false;
                                        } else {
                                            phi_10881_ = _e2680;
                                        }
                                        let _e2684 = phi_10881_;
                                        phi_10882_ = _e2684;
                                    }
                                    let _e2686 = phi_10882_;
                                    phi_10883_ = _e2686;
                                    phi_10884_ = _e2384;
                                }
                                let _e2688 = phi_10883_;
                                let _e2690 = phi_10884_;
                                phi_10885_ = _e2688;
                                phi_10886_ = _e2690;
                            }
                            let _e2692 = phi_10885_;
                            let _e2694 = phi_10886_;
                            if _e2694 {
                                phi_10890_ = true;
                            } else {
                                phi_10890_ = _e2692;
                            }
                            let _e2696 = phi_10890_;
                            if !(_e2696) {
                                phi_10896_ = type_46(2u, _e413);
                                phi_10897_ = false;
                            } else {
                                phi_10896_ = type_46();
                                phi_10897_ = true;
                            }
                            let _e2700 = phi_10896_;
                            let _e2702 = phi_10897_;
                            phi_10898_ = _e2700;
                            phi_10899_ = _e2702;
                        } else {
                            phi_10898_ = type_46();
                            phi_10899_ = true;
                        }
                        let _e2704 = phi_10898_;
                        let _e2706 = phi_10899_;
                        if _e2706 {
                            let _e2707 = f64(0f);
                            let _e2708 = f64(1f);
                            let _e2709 = f64(3f);
                            let _e2715 = ((_e787 - (_e2709 * _e764)) * _e1158);
                            let _e2716 = ((_e810 - _e787) * _e1158);
                            let _e2717 = (((_e2709 * _e821) - _e810) * _e1158);
                            local_6[0u] = _e2707;
                            local_6[1u] = _e2708;
                            local_6[2u] = _e2708;
                            local_6[3u] = _e2708;
                            let _e2724 = ((_e2716 * _e2716) - (_e2715 * _e2717));
                            if (_e2724 > _e2707) {
                                if (_e2724 <= 2.2250738585072014e-308lf) {
                                    if (_e2724 > 0.0lf) {
                                        phi_10938_ = (1.464336215552873e-154lf * 2.0lf);
                                    } else {
                                        phi_10938_ = 0.0lf;
                                    }
                                    let _e2777 = phi_10938_;
                                    phi_11002_ = _e2777;
                                } else {
                                    phi_10945_ = type_16(0i, 5i);
                                    phi_10948_ = bitcast<f64>(((bitcast<u64>(_e2724) / 2lu) + 2303426169912950784lu));
                                    loop {
                                        let _e2732 = phi_10945_;
                                        let _e2734 = phi_10948_;
                                        local_23 = _e2734;
                                        if (_e2732.member < _e2732.member_1) {
                                            let _e2741 = (_e2732.member + 1i);
                                            if ((false == (_e2741 > _e2732.member)) != false) {
                                                phi_10969_ = true;
                                            } else {
                                                phi_10969_ = false;
                                            }
                                            let _e2746 = phi_10969_;
                                            if _e2746 {
                                                phi_10975_ = type_17(0u, type_17().member_1);
                                            } else {
                                                phi_10975_ = type_17(1u, _e2741);
                                            }
                                            let _e2751 = phi_10975_;
                                            phi_10946_ = type_16(_e2751.member_1, _e2732.member_1);
                                            phi_10989_ = type_17(1u, _e2732.member);
                                        } else {
                                            phi_10946_ = _e2732;
                                            phi_10989_ = type_17(0u, type_17().member_1);
                                        }
                                        let _e2757 = phi_10946_;
                                        let _e2759 = phi_10989_;
                                        let _e2762 = (bitcast<i32>(_e2759.member) != 0i);
                                        if _e2762 {
                                            phi_10949_ = (0.5lf * (_e2734 + (_e2724 / _e2734)));
                                        } else {
                                            phi_10949_ = f64();
                                        }
                                        let _e2767 = phi_10949_;
                                        continue;
                                        continuing {
                                            phi_10945_ = _e2757;
                                            phi_10948_ = _e2767;
                                            break if !(_e2762);
                                        }
                                    }
                                    let _e2772 = local_23;
                                    phi_11002_ = (_e2772 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                }
                                let _e2779 = phi_11002_;
                                if (_e2716 < _e2707) {
                                    phi_11008_ = -(_e2779);
                                } else {
                                    phi_11008_ = _e2779;
                                }
                                let _e2783 = phi_11008_;
                                let _e2785 = -((_e2716 + _e2783));
                                local_7[0u] = (_e2785 / (_e2785 + _e2717));
                                local_7[1u] = (_e2715 / (_e2715 + _e2785));
                                let _e2794 = local_7[1u];
                                let _e2795 = local_7[0u];
                                if (_e2794 < _e2795) {
                                    let _e2798 = local_7[1u];
                                    let _e2800 = local_7[0u];
                                    local_7[0u] = _e2798;
                                    local_7[1u] = _e2800;
                                }
                                phi_11033_ = type_12(0u, 2u);
                                phi_11036_ = 1u;
                                loop {
                                    let _e2804 = phi_11033_;
                                    let _e2806 = phi_11036_;
                                    local_64 = _e2806;
                                    if (_e2804.member < _e2804.member_1) {
                                        phi_11034_ = type_12((_e2804.member + 1u), _e2804.member_1);
                                        phi_11059_ = type_12(1u, _e2804.member);
                                    } else {
                                        phi_11034_ = _e2804;
                                        phi_11059_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e2818 = phi_11034_;
                                    let _e2820 = phi_11059_;
                                    let _e2824 = (bitcast<i32>(_e2820.member) != 0i);
                                    if _e2824 {
                                        let _e2826 = local_7[_e2820.member_1];
                                        if (_e2826 > _e2707) {
                                            let _e2829 = local_7[_e2820.member_1];
                                            if (_e2829 < _e2708) {
                                                let _e2832 = local_7[_e2820.member_1];
                                                local_6[_e2806] = _e2832;
                                                phi_11103_ = (_e2806 + 1u);
                                            } else {
                                                phi_11103_ = _e2806;
                                            }
                                            let _e2836 = phi_11103_;
                                            phi_11104_ = _e2836;
                                        } else {
                                            phi_11104_ = _e2806;
                                        }
                                        let _e2838 = phi_11104_;
                                        phi_11037_ = _e2838;
                                    } else {
                                        phi_11037_ = u32();
                                    }
                                    let _e2840 = phi_11037_;
                                    continue;
                                    continuing {
                                        phi_11033_ = _e2818;
                                        phi_11036_ = _e2840;
                                        break if !(_e2824);
                                    }
                                }
                                let _e10900 = local_64;
                                phi_11105_ = _e10900;
                            } else {
                                phi_11105_ = 1u;
                            }
                            let _e2843 = phi_11105_;
                            local_6[_e2843] = _e2708;
                            let _e2845 = local_6;
                            local_12 = _e2845;
                            phi_11125_ = type_12(0u, _e2843);
                            loop {
                                let _e2848 = phi_11125_;
                                if (_e2848.member < _e2848.member_1) {
                                    phi_11126_ = type_12((_e2848.member + 1u), _e2848.member_1);
                                    phi_11149_ = type_12(1u, _e2848.member);
                                } else {
                                    phi_11126_ = _e2848;
                                    phi_11149_ = type_12(0u, type_12().member_1);
                                }
                                let _e2860 = phi_11126_;
                                let _e2862 = phi_11149_;
                                if (bitcast<i32>(_e2862.member) != 0i) {
                                    let _e2868 = local_12[_e2862.member_1];
                                    if (_e2868 > _e413) {
                                        phi_11168_ = _e2868;
                                    } else {
                                        phi_11168_ = _e413;
                                    }
                                    let _e2871 = phi_11168_;
                                    let _e2874 = local_12[(_e2862.member_1 + 1u)];
                                    if (_e2874 < _e422) {
                                        phi_11181_ = _e2874;
                                    } else {
                                        phi_11181_ = _e422;
                                    }
                                    let _e2877 = phi_11181_;
                                    if (_e2871 <= _e2877) {
                                        let _e2880 = (f64(1f) - _e2871);
                                        let _e2891 = ((((_e764 * _e2880) + (_e787 * _e2871)) * (_e2880 * _e2880)) + (((_e810 * _e2880) + (_e821 * _e2871)) * (_e2871 * _e2871)));
                                        let _e2893 = (f64(1f) - _e2877);
                                        let _e2904 = ((((_e764 * _e2893) + (_e787 * _e2877)) * (_e2893 * _e2893)) + (((_e810 * _e2893) + (_e821 * _e2877)) * (_e2877 * _e2877)));
                                        if (_e2891 < 0.0lf) {
                                            phi_11217_ = -(_e2891);
                                        } else {
                                            phi_11217_ = _e2891;
                                        }
                                        let _e2908 = phi_11217_;
                                        let _e2909 = (_e2908 > _e1154);
                                        if (_e2904 < 0.0lf) {
                                            phi_11224_ = -(_e2904);
                                        } else {
                                            phi_11224_ = _e2904;
                                        }
                                        let _e2913 = phi_11224_;
                                        let _e2914 = (_e2913 > _e1154);
                                        let _e2915 = f64(0f);
                                        if _e2909 {
                                            if _e2914 {
                                                phi_11236_ = ((_e2891 > _e2915) != (_e2904 > _e2915));
                                                phi_11237_ = false;
                                            } else {
                                                phi_11236_ = bool();
                                                phi_11237_ = true;
                                            }
                                            let _e2920 = phi_11236_;
                                            let _e2922 = phi_11237_;
                                            phi_11238_ = _e2920;
                                            phi_11239_ = _e2922;
                                        } else {
                                            phi_11238_ = bool();
                                            phi_11239_ = true;
                                        }
                                        let _e2924 = phi_11238_;
                                        let _e2926 = phi_11239_;
                                        if _e2926 {
                                            phi_11243_ = false;
                                        } else {
                                            phi_11243_ = _e2924;
                                        }
                                        let _e2928 = phi_11243_;
                                        if _e2909 {
                                            if _e2914 {
                                                if _e2928 {
                                                    phi_11255_ = type_49();
                                                } else {
                                                    phi_11255_ = type_49(f64(1f), _e2915, _e2928);
                                                }
                                                let _e2932 = phi_11255_;
                                                phi_11256_ = _e2932;
                                                phi_11257_ = _e2928;
                                            } else {
                                                phi_11256_ = type_49();
                                                phi_11257_ = true;
                                            }
                                            let _e2934 = phi_11256_;
                                            let _e2936 = phi_11257_;
                                            phi_11258_ = _e2934;
                                            phi_11259_ = _e2936;
                                        } else {
                                            phi_11258_ = type_49();
                                            phi_11259_ = true;
                                        }
                                        let _e2938 = phi_11258_;
                                        let _e2940 = phi_11259_;
                                        if _e2940 {
                                            if _e2909 {
                                                if (_e2891 < _e2915) {
                                                    phi_11272_ = f64(-1f);
                                                } else {
                                                    phi_11272_ = f64(1f);
                                                }
                                                let _e2945 = phi_11272_;
                                                let _e2946 = f64(0.5f);
                                                let _e2947 = f64(3f);
                                                let _e2950 = (_e810 - _e787);
                                                phi_11284_ = type_12(0u, 64u);
                                                phi_11287_ = _e2877;
                                                phi_11289_ = _e2871;
                                                phi_11291_ = (_e2946 * (_e2871 + _e2877));
                                                loop {
                                                    let _e2956 = phi_11284_;
                                                    let _e2958 = phi_11287_;
                                                    let _e2960 = phi_11289_;
                                                    let _e2962 = phi_11291_;
                                                    local_66 = _e2960;
                                                    if (_e2956.member < _e2956.member_1) {
                                                        phi_11285_ = type_12((_e2956.member + 1u), _e2956.member_1);
                                                        phi_11314_ = type_12(1u, _e2956.member);
                                                    } else {
                                                        phi_11285_ = _e2956;
                                                        phi_11314_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e2974 = phi_11285_;
                                                    let _e2976 = phi_11314_;
                                                    if (bitcast<i32>(_e2976.member) != 0i) {
                                                        let _e2981 = (f64(1f) - _e2962);
                                                        let _e2994 = ((_e2945 * ((((_e764 * _e2981) + (_e787 * _e2962)) * (_e2981 * _e2981)) + (((_e810 * _e2981) + (_e821 * _e2962)) * (_e2962 * _e2962)))) - _e1154);
                                                        if (_e2994 > f64(0f)) {
                                                            phi_11341_ = _e2958;
                                                            phi_11342_ = _e2962;
                                                        } else {
                                                            phi_11341_ = _e2962;
                                                            phi_11342_ = _e2960;
                                                        }
                                                        let _e2998 = phi_11341_;
                                                        let _e3000 = phi_11342_;
                                                        let _e3002 = ((_e2998 - _e3000) > _e1164);
                                                        if _e3002 {
                                                            let _e3004 = (f64(1f) - _e2962);
                                                            let _e3016 = (-(_e2994) / (_e2945 * (((((_e787 - (_e2947 * _e764)) * _e3004) + (_e2950 * _e2962)) * _e3004) + (((_e2950 * _e3004) + (((_e2947 * _e821) - _e810) * _e2962)) * _e2962))));
                                                            if (_e2994 > f64(0f)) {
                                                                phi_11370_ = (_e2946 * _e1164);
                                                            } else {
                                                                phi_11370_ = -((_e2946 * _e1164));
                                                            }
                                                            let _e3023 = phi_11370_;
                                                            let _e3025 = ((_e2962 + _e3016) + _e3023);
                                                            if (_e3025 > _e3000) {
                                                                if (_e3025 < _e2998) {
                                                                    if (_e3016 < 0.0lf) {
                                                                        phi_11386_ = -(_e3016);
                                                                    } else {
                                                                        phi_11386_ = _e3016;
                                                                    }
                                                                    let _e3031 = phi_11386_;
                                                                    if (_e3031 < (_e2946 * (_e2998 - _e3000))) {
                                                                        phi_11393_ = false;
                                                                    } else {
                                                                        phi_11393_ = true;
                                                                    }
                                                                    let _e3036 = phi_11393_;
                                                                    phi_11394_ = _e3036;
                                                                } else {
                                                                    phi_11394_ = true;
                                                                }
                                                                let _e3038 = phi_11394_;
                                                                phi_11395_ = _e3038;
                                                            } else {
                                                                phi_11395_ = true;
                                                            }
                                                            let _e3040 = phi_11395_;
                                                            if _e3040 {
                                                                phi_11401_ = (_e2946 * (_e3000 + _e2998));
                                                            } else {
                                                                phi_11401_ = _e3025;
                                                            }
                                                            let _e3044 = phi_11401_;
                                                            phi_11402_ = _e3044;
                                                            phi_11403_ = false;
                                                        } else {
                                                            phi_11402_ = f64();
                                                            phi_11403_ = true;
                                                        }
                                                        let _e3046 = phi_11402_;
                                                        let _e3048 = phi_11403_;
                                                        phi_11288_ = _e2998;
                                                        phi_11290_ = _e3000;
                                                        phi_11292_ = _e3046;
                                                        phi_11404_ = _e3000;
                                                        phi_11405_ = _e3002;
                                                        phi_11406_ = _e3048;
                                                    } else {
                                                        phi_11288_ = f64();
                                                        phi_11290_ = f64();
                                                        phi_11292_ = f64();
                                                        phi_11404_ = f64();
                                                        phi_11405_ = false;
                                                        phi_11406_ = false;
                                                    }
                                                    let _e3050 = phi_11288_;
                                                    let _e3052 = phi_11290_;
                                                    let _e3054 = phi_11292_;
                                                    let _e3056 = phi_11404_;
                                                    let _e3058 = phi_11405_;
                                                    let _e3060 = phi_11406_;
                                                    local_24 = _e3060;
                                                    local_65 = _e3056;
                                                    continue;
                                                    continuing {
                                                        phi_11284_ = _e2974;
                                                        phi_11287_ = _e3050;
                                                        phi_11289_ = _e3052;
                                                        phi_11291_ = _e3054;
                                                        break if !(_e3058);
                                                    }
                                                }
                                                let _e3063 = local_24;
                                                if _e3063 {
                                                    let _e10944 = local_65;
                                                    phi_11410_ = _e10944;
                                                } else {
                                                    let _e10946 = local_66;
                                                    phi_11410_ = _e10946;
                                                }
                                                let _e3065 = phi_11410_;
                                                phi_11411_ = _e3065;
                                            } else {
                                                phi_11411_ = _e2871;
                                            }
                                            let _e3067 = phi_11411_;
                                            if _e2914 {
                                                if (_e2904 < _e2915) {
                                                    phi_11421_ = f64(-1f);
                                                } else {
                                                    phi_11421_ = f64(1f);
                                                }
                                                let _e3072 = phi_11421_;
                                                phi_11425_ = type_12(0u, 64u);
                                                phi_11428_ = (_e1164 + _e1164);
                                                loop {
                                                    let _e3075 = phi_11425_;
                                                    let _e3077 = phi_11428_;
                                                    if (_e3075.member < _e3075.member_1) {
                                                        phi_11426_ = type_12((_e3075.member + 1u), _e3075.member_1);
                                                        phi_11451_ = type_12(1u, _e3075.member);
                                                    } else {
                                                        phi_11426_ = _e3075;
                                                        phi_11451_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e3089 = phi_11426_;
                                                    let _e3091 = phi_11451_;
                                                    if (bitcast<i32>(_e3091.member) != 0i) {
                                                        let _e3095 = (_e3067 + _e3077);
                                                        if (_e3095 < _e2877) {
                                                            let _e3098 = (f64(1f) - _e3095);
                                                            let _e3111 = ((_e3072 * ((((_e764 * _e3098) + (_e787 * _e3095)) * (_e3098 * _e3098)) + (((_e810 * _e3098) + (_e821 * _e3095)) * (_e3095 * _e3095)))) > _e1154);
                                                            if _e3111 {
                                                                phi_11482_ = f64();
                                                                phi_11483_ = false;
                                                            } else {
                                                                phi_11482_ = (_e3077 + _e3077);
                                                                phi_11483_ = true;
                                                            }
                                                            let _e3114 = phi_11482_;
                                                            let _e3116 = phi_11483_;
                                                            phi_11484_ = _e3114;
                                                            phi_11485_ = _e3116;
                                                            phi_11486_ = _e3111;
                                                            phi_11487_ = false;
                                                        } else {
                                                            phi_11484_ = f64();
                                                            phi_11485_ = false;
                                                            phi_11486_ = false;
                                                            phi_11487_ = true;
                                                        }
                                                        let _e3118 = phi_11484_;
                                                        let _e3120 = phi_11485_;
                                                        let _e3122 = phi_11486_;
                                                        let _e3124 = phi_11487_;
                                                        phi_11488_ = _e3095;
                                                        phi_11429_ = _e3118;
                                                        phi_11489_ = _e3120;
                                                        phi_11490_ = _e3122;
                                                        phi_11491_ = _e3124;
                                                        phi_11492_ = false;
                                                    } else {
                                                        phi_11488_ = f64();
                                                        phi_11429_ = f64();
                                                        phi_11489_ = false;
                                                        phi_11490_ = false;
                                                        phi_11491_ = false;
                                                        phi_11492_ = true;
                                                    }
                                                    let _e3126 = phi_11488_;
                                                    let _e3128 = phi_11429_;
                                                    let _e3130 = phi_11489_;
                                                    let _e3132 = phi_11490_;
                                                    let _e3134 = phi_11491_;
                                                    let _e3136 = phi_11492_;
                                                    local_25 = _e3132;
                                                    local_67 = _e3134;
                                                    local_68 = _e3136;
                                                    local_69 = _e3126;
                                                    continue;
                                                    continuing {
                                                        phi_11425_ = _e3089;
                                                        phi_11428_ = _e3128;
                                                        break if !(_e3130);
                                                    }
                                                }
                                                let _e3139 = local_25;
                                                if _e3139 {
                                                    phi_11496_ = false;
                                                    phi_11497_ = false;
                                                } else {
                                                    let _e10968 = local_67;
                                                    phi_11496_ = _e10968;
                                                    let _e10971 = local_68;
                                                    phi_11497_ = _e10971;
                                                }
                                                let _e3141 = phi_11496_;
                                                let _e3143 = phi_11497_;
                                                if _e3141 {
                                                    phi_11501_ = true;
                                                } else {
                                                    phi_11501_ = _e3143;
                                                }
                                                let _e3145 = phi_11501_;
                                                if _e3145 {
                                                    phi_11505_ = _e2877;
                                                } else {
                                                    let _e10975 = local_69;
                                                    phi_11505_ = _e10975;
                                                }
                                                let _e3147 = phi_11505_;
                                                phi_11506_ = _e3147;
                                            } else {
                                                phi_11506_ = _e2877;
                                            }
                                            let _e3149 = phi_11506_;
                                            phi_11508_ = type_49(_e3067, _e3149, _e2928);
                                        } else {
                                            phi_11508_ = _e2938;
                                        }
                                        let _e3152 = phi_11508_;
                                        if (_e3152.member > _e3152.member_1) {
                                            phi_15375_ = bool();
                                            phi_15376_ = f64();
                                            phi_15377_ = f64();
                                            phi_15378_ = true;
                                            phi_15379_ = false;
                                            phi_15380_ = false;
                                            phi_15381_ = false;
                                        } else {
                                            let _e3160 = ((_e3152.member_1 - _e3152.member) * f64(0.5f));
                                            let _e3161 = (_e3152.member + _e3160);
                                            let _e3164 = (_e3160 + (1.1102230246251565e-16lf * f64(4f)));
                                            let _e3166 = local_18.member_3;
                                            let _e3169 = local_18.member[0u];
                                            if (_e3169[0] < 0.0lf) {
                                                phi_11539_ = -(_e3169[0]);
                                            } else {
                                                phi_11539_ = _e3169[0];
                                            }
                                            let _e3176 = phi_11539_;
                                            if (_e3169[1] < 0.0lf) {
                                                phi_11546_ = -(_e3169[1]);
                                            } else {
                                                phi_11546_ = _e3169[1];
                                            }
                                            let _e3180 = phi_11546_;
                                            if (_e3176 > _e3180) {
                                                phi_11551_ = _e3176;
                                            } else {
                                                phi_11551_ = _e3180;
                                            }
                                            let _e3183 = phi_11551_;
                                            if (_e3169[2] < 0.0lf) {
                                                phi_11558_ = -(_e3169[2]);
                                            } else {
                                                phi_11558_ = _e3169[2];
                                            }
                                            let _e3187 = phi_11558_;
                                            if (_e3183 > _e3187) {
                                                phi_11563_ = _e3183;
                                            } else {
                                                phi_11563_ = _e3187;
                                            }
                                            let _e3190 = phi_11563_;
                                            let _e3192 = local_18.member[1u];
                                            if (_e3192[0] < 0.0lf) {
                                                phi_11576_ = -(_e3192[0]);
                                            } else {
                                                phi_11576_ = _e3192[0];
                                            }
                                            let _e3199 = phi_11576_;
                                            if (_e3192[1] < 0.0lf) {
                                                phi_11583_ = -(_e3192[1]);
                                            } else {
                                                phi_11583_ = _e3192[1];
                                            }
                                            let _e3203 = phi_11583_;
                                            if (_e3199 > _e3203) {
                                                phi_11588_ = _e3199;
                                            } else {
                                                phi_11588_ = _e3203;
                                            }
                                            let _e3206 = phi_11588_;
                                            if (_e3192[2] < 0.0lf) {
                                                phi_11595_ = -(_e3192[2]);
                                            } else {
                                                phi_11595_ = _e3192[2];
                                            }
                                            let _e3210 = phi_11595_;
                                            if (_e3206 > _e3210) {
                                                phi_11600_ = _e3206;
                                            } else {
                                                phi_11600_ = _e3210;
                                            }
                                            let _e3213 = phi_11600_;
                                            if (_e3190 > _e3213) {
                                                phi_11605_ = _e3190;
                                            } else {
                                                phi_11605_ = _e3213;
                                            }
                                            let _e3216 = phi_11605_;
                                            let _e3219 = local_18.member[0u];
                                            let _e3224 = local_18.member[1u];
                                            let _e3234 = (_e3219[0] + ((_e3224[0] - _e3219[0]) * _e3161));
                                            let _e3235 = (_e3219[1] + ((_e3224[1] - _e3219[1]) * _e3161));
                                            let _e3236 = (_e3219[2] + ((_e3224[2] - _e3219[2]) * _e3161));
                                            let _e3238 = local_18.member[1u];
                                            let _e3243 = local_18.member[0u];
                                            let _e3247 = (_e3238[0] - _e3243[0]);
                                            let _e3248 = (_e3238[1] - _e3243[1]);
                                            let _e3249 = (_e3238[2] - _e3243[2]);
                                            if (_e3247 < 0.0lf) {
                                                phi_11664_ = -(_e3247);
                                            } else {
                                                phi_11664_ = _e3247;
                                            }
                                            let _e3253 = phi_11664_;
                                            if (_e3248 < 0.0lf) {
                                                phi_11670_ = -(_e3248);
                                            } else {
                                                phi_11670_ = _e3248;
                                            }
                                            let _e3257 = phi_11670_;
                                            if (_e3253 > _e3257) {
                                                phi_11675_ = _e3253;
                                            } else {
                                                phi_11675_ = _e3257;
                                            }
                                            let _e3260 = phi_11675_;
                                            if (_e3249 < 0.0lf) {
                                                phi_11681_ = -(_e3249);
                                            } else {
                                                phi_11681_ = _e3249;
                                            }
                                            let _e3264 = phi_11681_;
                                            if (_e3260 > _e3264) {
                                                phi_11686_ = _e3260;
                                            } else {
                                                phi_11686_ = _e3264;
                                            }
                                            let _e3267 = phi_11686_;
                                            let _e3275 = ((((_e3164 * _e3267) * f64(1.01f)) + ((_e3216 + _e3166) * (1.1102230246251565e-16lf * f64(8f)))) + _e3166);
                                            if (_e3234 < 0.0lf) {
                                                phi_11700_ = -(_e3234);
                                            } else {
                                                phi_11700_ = _e3234;
                                            }
                                            let _e3279 = phi_11700_;
                                            if (_e3235 < 0.0lf) {
                                                phi_11706_ = -(_e3235);
                                            } else {
                                                phi_11706_ = _e3235;
                                            }
                                            let _e3283 = phi_11706_;
                                            if (_e3279 > _e3283) {
                                                phi_11711_ = _e3279;
                                            } else {
                                                phi_11711_ = _e3283;
                                            }
                                            let _e3286 = phi_11711_;
                                            if (_e3236 < 0.0lf) {
                                                phi_11717_ = -(_e3236);
                                            } else {
                                                phi_11717_ = _e3236;
                                            }
                                            let _e3290 = phi_11717_;
                                            if (_e3286 > _e3290) {
                                                phi_11722_ = _e3286;
                                            } else {
                                                phi_11722_ = _e3290;
                                            }
                                            let _e3293 = phi_11722_;
                                            local_2 = type_39(array<f64, 3>(_e3234, _e3235, _e3236), _e3275, (_e3293 + _e3275));
                                            let _e3299 = local_18.member_3;
                                            let _e3301 = local_18.member_1[0u];
                                            if (_e3301[0] < 0.0lf) {
                                                phi_11748_ = -(_e3301[0]);
                                            } else {
                                                phi_11748_ = _e3301[0];
                                            }
                                            let _e3308 = phi_11748_;
                                            if (_e3301[1] < 0.0lf) {
                                                phi_11755_ = -(_e3301[1]);
                                            } else {
                                                phi_11755_ = _e3301[1];
                                            }
                                            let _e3312 = phi_11755_;
                                            if (_e3308 > _e3312) {
                                                phi_11760_ = _e3308;
                                            } else {
                                                phi_11760_ = _e3312;
                                            }
                                            let _e3315 = phi_11760_;
                                            if (_e3301[2] < 0.0lf) {
                                                phi_11767_ = -(_e3301[2]);
                                            } else {
                                                phi_11767_ = _e3301[2];
                                            }
                                            let _e3319 = phi_11767_;
                                            if (_e3315 > _e3319) {
                                                phi_11772_ = _e3315;
                                            } else {
                                                phi_11772_ = _e3319;
                                            }
                                            let _e3322 = phi_11772_;
                                            let _e3324 = local_18.member_1[1u];
                                            if (_e3324[0] < 0.0lf) {
                                                phi_11785_ = -(_e3324[0]);
                                            } else {
                                                phi_11785_ = _e3324[0];
                                            }
                                            let _e3331 = phi_11785_;
                                            if (_e3324[1] < 0.0lf) {
                                                phi_11792_ = -(_e3324[1]);
                                            } else {
                                                phi_11792_ = _e3324[1];
                                            }
                                            let _e3335 = phi_11792_;
                                            if (_e3331 > _e3335) {
                                                phi_11797_ = _e3331;
                                            } else {
                                                phi_11797_ = _e3335;
                                            }
                                            let _e3338 = phi_11797_;
                                            if (_e3324[2] < 0.0lf) {
                                                phi_11804_ = -(_e3324[2]);
                                            } else {
                                                phi_11804_ = _e3324[2];
                                            }
                                            let _e3342 = phi_11804_;
                                            if (_e3338 > _e3342) {
                                                phi_11809_ = _e3338;
                                            } else {
                                                phi_11809_ = _e3342;
                                            }
                                            let _e3345 = phi_11809_;
                                            if (_e3322 > _e3345) {
                                                phi_11814_ = _e3322;
                                            } else {
                                                phi_11814_ = _e3345;
                                            }
                                            let _e3348 = phi_11814_;
                                            let _e3351 = local_18.member_1[0u];
                                            let _e3356 = local_18.member_1[1u];
                                            let _e3366 = (_e3351[0] + ((_e3356[0] - _e3351[0]) * _e3161));
                                            let _e3367 = (_e3351[1] + ((_e3356[1] - _e3351[1]) * _e3161));
                                            let _e3368 = (_e3351[2] + ((_e3356[2] - _e3351[2]) * _e3161));
                                            let _e3370 = local_18.member_1[1u];
                                            let _e3375 = local_18.member_1[0u];
                                            let _e3379 = (_e3370[0] - _e3375[0]);
                                            let _e3380 = (_e3370[1] - _e3375[1]);
                                            let _e3381 = (_e3370[2] - _e3375[2]);
                                            if (_e3379 < 0.0lf) {
                                                phi_11873_ = -(_e3379);
                                            } else {
                                                phi_11873_ = _e3379;
                                            }
                                            let _e3385 = phi_11873_;
                                            if (_e3380 < 0.0lf) {
                                                phi_11879_ = -(_e3380);
                                            } else {
                                                phi_11879_ = _e3380;
                                            }
                                            let _e3389 = phi_11879_;
                                            if (_e3385 > _e3389) {
                                                phi_11884_ = _e3385;
                                            } else {
                                                phi_11884_ = _e3389;
                                            }
                                            let _e3392 = phi_11884_;
                                            if (_e3381 < 0.0lf) {
                                                phi_11890_ = -(_e3381);
                                            } else {
                                                phi_11890_ = _e3381;
                                            }
                                            let _e3396 = phi_11890_;
                                            if (_e3392 > _e3396) {
                                                phi_11895_ = _e3392;
                                            } else {
                                                phi_11895_ = _e3396;
                                            }
                                            let _e3399 = phi_11895_;
                                            let _e3407 = ((((_e3164 * _e3399) * f64(1.01f)) + ((_e3348 + _e3299) * (1.1102230246251565e-16lf * f64(8f)))) + _e3299);
                                            if (_e3366 < 0.0lf) {
                                                phi_11909_ = -(_e3366);
                                            } else {
                                                phi_11909_ = _e3366;
                                            }
                                            let _e3411 = phi_11909_;
                                            if (_e3367 < 0.0lf) {
                                                phi_11915_ = -(_e3367);
                                            } else {
                                                phi_11915_ = _e3367;
                                            }
                                            let _e3415 = phi_11915_;
                                            if (_e3411 > _e3415) {
                                                phi_11920_ = _e3411;
                                            } else {
                                                phi_11920_ = _e3415;
                                            }
                                            let _e3418 = phi_11920_;
                                            if (_e3368 < 0.0lf) {
                                                phi_11926_ = -(_e3368);
                                            } else {
                                                phi_11926_ = _e3368;
                                            }
                                            let _e3422 = phi_11926_;
                                            if (_e3418 > _e3422) {
                                                phi_11931_ = _e3418;
                                            } else {
                                                phi_11931_ = _e3422;
                                            }
                                            let _e3425 = phi_11931_;
                                            local_3 = type_39(array<f64, 3>(_e3366, _e3367, _e3368), _e3407, (_e3425 + _e3407));
                                            let _e3431 = local_18.member_3;
                                            let _e3433 = local_18.member_2[0u];
                                            if (_e3433[0] < 0.0lf) {
                                                phi_11957_ = -(_e3433[0]);
                                            } else {
                                                phi_11957_ = _e3433[0];
                                            }
                                            let _e3440 = phi_11957_;
                                            if (_e3433[1] < 0.0lf) {
                                                phi_11964_ = -(_e3433[1]);
                                            } else {
                                                phi_11964_ = _e3433[1];
                                            }
                                            let _e3444 = phi_11964_;
                                            if (_e3440 > _e3444) {
                                                phi_11969_ = _e3440;
                                            } else {
                                                phi_11969_ = _e3444;
                                            }
                                            let _e3447 = phi_11969_;
                                            if (_e3433[2] < 0.0lf) {
                                                phi_11976_ = -(_e3433[2]);
                                            } else {
                                                phi_11976_ = _e3433[2];
                                            }
                                            let _e3451 = phi_11976_;
                                            if (_e3447 > _e3451) {
                                                phi_11981_ = _e3447;
                                            } else {
                                                phi_11981_ = _e3451;
                                            }
                                            let _e3454 = phi_11981_;
                                            let _e3456 = local_18.member_2[1u];
                                            if (_e3456[0] < 0.0lf) {
                                                phi_11994_ = -(_e3456[0]);
                                            } else {
                                                phi_11994_ = _e3456[0];
                                            }
                                            let _e3463 = phi_11994_;
                                            if (_e3456[1] < 0.0lf) {
                                                phi_12001_ = -(_e3456[1]);
                                            } else {
                                                phi_12001_ = _e3456[1];
                                            }
                                            let _e3467 = phi_12001_;
                                            if (_e3463 > _e3467) {
                                                phi_12006_ = _e3463;
                                            } else {
                                                phi_12006_ = _e3467;
                                            }
                                            let _e3470 = phi_12006_;
                                            if (_e3456[2] < 0.0lf) {
                                                phi_12013_ = -(_e3456[2]);
                                            } else {
                                                phi_12013_ = _e3456[2];
                                            }
                                            let _e3474 = phi_12013_;
                                            if (_e3470 > _e3474) {
                                                phi_12018_ = _e3470;
                                            } else {
                                                phi_12018_ = _e3474;
                                            }
                                            let _e3477 = phi_12018_;
                                            if (_e3454 > _e3477) {
                                                phi_12023_ = _e3454;
                                            } else {
                                                phi_12023_ = _e3477;
                                            }
                                            let _e3480 = phi_12023_;
                                            let _e3483 = local_18.member_2[0u];
                                            let _e3488 = local_18.member_2[1u];
                                            let _e3498 = (_e3483[0] + ((_e3488[0] - _e3483[0]) * _e3161));
                                            let _e3499 = (_e3483[1] + ((_e3488[1] - _e3483[1]) * _e3161));
                                            let _e3500 = (_e3483[2] + ((_e3488[2] - _e3483[2]) * _e3161));
                                            let _e3502 = local_18.member_2[1u];
                                            let _e3507 = local_18.member_2[0u];
                                            let _e3511 = (_e3502[0] - _e3507[0]);
                                            let _e3512 = (_e3502[1] - _e3507[1]);
                                            let _e3513 = (_e3502[2] - _e3507[2]);
                                            if (_e3511 < 0.0lf) {
                                                phi_12082_ = -(_e3511);
                                            } else {
                                                phi_12082_ = _e3511;
                                            }
                                            let _e3517 = phi_12082_;
                                            if (_e3512 < 0.0lf) {
                                                phi_12088_ = -(_e3512);
                                            } else {
                                                phi_12088_ = _e3512;
                                            }
                                            let _e3521 = phi_12088_;
                                            if (_e3517 > _e3521) {
                                                phi_12093_ = _e3517;
                                            } else {
                                                phi_12093_ = _e3521;
                                            }
                                            let _e3524 = phi_12093_;
                                            if (_e3513 < 0.0lf) {
                                                phi_12099_ = -(_e3513);
                                            } else {
                                                phi_12099_ = _e3513;
                                            }
                                            let _e3528 = phi_12099_;
                                            if (_e3524 > _e3528) {
                                                phi_12104_ = _e3524;
                                            } else {
                                                phi_12104_ = _e3528;
                                            }
                                            let _e3531 = phi_12104_;
                                            let _e3539 = ((((_e3164 * _e3531) * f64(1.01f)) + ((_e3480 + _e3431) * (1.1102230246251565e-16lf * f64(8f)))) + _e3431);
                                            if (_e3498 < 0.0lf) {
                                                phi_12118_ = -(_e3498);
                                            } else {
                                                phi_12118_ = _e3498;
                                            }
                                            let _e3543 = phi_12118_;
                                            if (_e3499 < 0.0lf) {
                                                phi_12124_ = -(_e3499);
                                            } else {
                                                phi_12124_ = _e3499;
                                            }
                                            let _e3547 = phi_12124_;
                                            if (_e3543 > _e3547) {
                                                phi_12129_ = _e3543;
                                            } else {
                                                phi_12129_ = _e3547;
                                            }
                                            let _e3550 = phi_12129_;
                                            if (_e3500 < 0.0lf) {
                                                phi_12135_ = -(_e3500);
                                            } else {
                                                phi_12135_ = _e3500;
                                            }
                                            let _e3554 = phi_12135_;
                                            if (_e3550 > _e3554) {
                                                phi_12140_ = _e3550;
                                            } else {
                                                phi_12140_ = _e3554;
                                            }
                                            let _e3557 = phi_12140_;
                                            local_4 = type_39(array<f64, 3>(_e3498, _e3499, _e3500), _e3539, (_e3557 + _e3539));
                                            let _e3562 = local_3.member;
                                            let _e3567 = local_4.member;
                                            let _e3573 = ((_e3562[1] * _e3567[2]) - (_e3562[2] * _e3567[1]));
                                            let _e3576 = ((_e3562[2] * _e3567[0]) - (_e3562[0] * _e3567[2]));
                                            let _e3579 = ((_e3562[0] * _e3567[1]) - (_e3562[1] * _e3567[0]));
                                            if (_e3573 < 0.0lf) {
                                                phi_12189_ = -(_e3573);
                                            } else {
                                                phi_12189_ = _e3573;
                                            }
                                            let _e3583 = phi_12189_;
                                            if (_e3576 < 0.0lf) {
                                                phi_12195_ = -(_e3576);
                                            } else {
                                                phi_12195_ = _e3576;
                                            }
                                            let _e3587 = phi_12195_;
                                            if (_e3583 > _e3587) {
                                                if (_e3573 < 0.0lf) {
                                                    phi_12205_ = -(_e3573);
                                                } else {
                                                    phi_12205_ = _e3573;
                                                }
                                                let _e3605 = phi_12205_;
                                                if (_e3579 < 0.0lf) {
                                                    phi_12211_ = -(_e3579);
                                                } else {
                                                    phi_12211_ = _e3579;
                                                }
                                                let _e3609 = phi_12211_;
                                                if (_e3605 > _e3609) {
                                                    phi_12216_ = 2u;
                                                    phi_12217_ = 1u;
                                                } else {
                                                    phi_12216_ = 1u;
                                                    phi_12217_ = 0u;
                                                }
                                                let _e3612 = phi_12216_;
                                                let _e3614 = phi_12217_;
                                                phi_12236_ = _e3612;
                                                phi_12237_ = _e3614;
                                            } else {
                                                if (_e3576 < 0.0lf) {
                                                    phi_12223_ = -(_e3576);
                                                } else {
                                                    phi_12223_ = _e3576;
                                                }
                                                let _e3592 = phi_12223_;
                                                if (_e3579 < 0.0lf) {
                                                    phi_12229_ = -(_e3579);
                                                } else {
                                                    phi_12229_ = _e3579;
                                                }
                                                let _e3596 = phi_12229_;
                                                if (_e3592 > _e3596) {
                                                    phi_12234_ = 0u;
                                                    phi_12235_ = 2u;
                                                } else {
                                                    phi_12234_ = 1u;
                                                    phi_12235_ = 0u;
                                                }
                                                let _e3599 = phi_12234_;
                                                let _e3601 = phi_12235_;
                                                phi_12236_ = _e3599;
                                                phi_12237_ = _e3601;
                                            }
                                            let _e3616 = phi_12236_;
                                            let _e3618 = phi_12237_;
                                            let _e3621 = local_3.member[_e3618];
                                            let _e3624 = local_4.member[_e3616];
                                            let _e3628 = local_3.member[_e3616];
                                            let _e3631 = local_4.member[_e3618];
                                            let _e3633 = ((_e3621 * _e3624) - (_e3628 * _e3631));
                                            let _e3634 = f64(1f);
                                            let _e3635 = f64(2f);
                                            let _e3637 = local_3.member_1;
                                            let _e3639 = local_4.member_2;
                                            let _e3642 = local_3.member_2;
                                            let _e3644 = local_4.member_1;
                                            let _e3650 = local_3.member_2;
                                            let _e3653 = local_4.member_2;
                                            let _e3662 = local_3.member_2;
                                            let _e3665 = local_4.member_2;
                                            let _e3669 = (((((_e3637 * _e3639) + (_e3642 * _e3644)) * f64(2.01f)) + (((_e3650 * _e3635) * (_e3653 * _e3635)) * (1.1102230246251565e-16lf * _e3635))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e3634 + _e3662) * (_e3634 + _e3665))));
                                            if (_e3633 < 0.0lf) {
                                                phi_12310_ = -(_e3633);
                                            } else {
                                                phi_12310_ = _e3633;
                                            }
                                            let _e3673 = phi_12310_;
                                            if (_e3673 > _e3669) {
                                                if (_e3633 < f64(0f)) {
                                                    phi_12322_ = f64(-1f);
                                                } else {
                                                    phi_12322_ = f64(1f);
                                                }
                                                let _e3680 = phi_12322_;
                                                let _e3683 = local_2.member[_e3618];
                                                let _e3686 = local_4.member[_e3616];
                                                let _e3690 = local_2.member[_e3616];
                                                let _e3693 = local_4.member[_e3618];
                                                let _e3696 = f64(1f);
                                                let _e3697 = f64(2f);
                                                let _e3699 = local_2.member_1;
                                                let _e3701 = local_4.member_2;
                                                let _e3704 = local_2.member_2;
                                                let _e3706 = local_4.member_1;
                                                let _e3712 = local_2.member_2;
                                                let _e3715 = local_4.member_2;
                                                let _e3724 = local_2.member_2;
                                                let _e3727 = local_4.member_2;
                                                let _e3731 = (((((_e3699 * _e3701) + (_e3704 * _e3706)) * f64(2.01f)) + (((_e3712 * _e3697) * (_e3715 * _e3697)) * (1.1102230246251565e-16lf * _e3697))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e3696 + _e3724) * (_e3696 + _e3727))));
                                                let _e3734 = local_3.member[_e3618];
                                                let _e3737 = local_2.member[_e3616];
                                                let _e3741 = local_3.member[_e3616];
                                                let _e3744 = local_2.member[_e3618];
                                                let _e3747 = f64(1f);
                                                let _e3748 = f64(2f);
                                                let _e3750 = local_3.member_1;
                                                let _e3752 = local_2.member_2;
                                                let _e3755 = local_3.member_2;
                                                let _e3757 = local_2.member_1;
                                                let _e3763 = local_3.member_2;
                                                let _e3766 = local_2.member_2;
                                                let _e3775 = local_3.member_2;
                                                let _e3778 = local_2.member_2;
                                                let _e3782 = (((((_e3750 * _e3752) + (_e3755 * _e3757)) * f64(2.01f)) + (((_e3763 * _e3748) * (_e3766 * _e3748)) * (1.1102230246251565e-16lf * _e3748))) + ((2.2250738585072014e-308lf * f64(256f)) * ((_e3747 + _e3775) * (_e3747 + _e3778))));
                                                let _e3783 = (_e3633 * _e3680);
                                                let _e3784 = (((_e3683 * _e3686) - (_e3690 * _e3693)) * _e3680);
                                                let _e3785 = (((_e3734 * _e3737) - (_e3741 * _e3744)) * _e3680);
                                                if (_e3783 < 0.0lf) {
                                                    phi_12465_ = -(_e3783);
                                                } else {
                                                    phi_12465_ = _e3783;
                                                }
                                                let _e3789 = phi_12465_;
                                                if (_e3784 < 0.0lf) {
                                                    phi_12471_ = -(_e3784);
                                                } else {
                                                    phi_12471_ = _e3784;
                                                }
                                                let _e3793 = phi_12471_;
                                                if (_e3785 < 0.0lf) {
                                                    phi_12478_ = -(_e3785);
                                                } else {
                                                    phi_12478_ = _e3785;
                                                }
                                                let _e3798 = phi_12478_;
                                                let _e3802 = (((_e3789 + _e3793) + _e3798) * (1.1102230246251565e-16lf * f64(4f)));
                                                local_5 = array<type_40, 4>(type_40(_e3784, _e3731), type_40(_e3785, _e3782), type_40((_e3783 - _e3784), ((_e3669 + _e3731) + _e3802)), type_40((_e3783 - _e3785), ((_e3669 + _e3782) + _e3802)));
                                                phi_12534_ = type_12(0u, 4u);
                                                phi_12537_ = true;
                                                loop {
                                                    let _e3815 = phi_12534_;
                                                    let _e3817 = phi_12537_;
                                                    local_27 = _e3817;
                                                    if (_e3815.member < _e3815.member_1) {
                                                        phi_12535_ = type_12((_e3815.member + 1u), _e3815.member_1);
                                                        phi_12560_ = type_12(1u, _e3815.member);
                                                    } else {
                                                        phi_12535_ = _e3815;
                                                        phi_12560_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e3829 = phi_12535_;
                                                    let _e3831 = phi_12560_;
                                                    if (bitcast<i32>(_e3831.member) != 0i) {
                                                        let _e3838 = local_5[_e3831.member_1].member;
                                                        let _e3841 = local_5[_e3831.member_1].member_1;
                                                        let _e3843 = (_e3838 < -(_e3841));
                                                        if _e3843 {
                                                            phi_12587_ = bool();
                                                            phi_12588_ = false;
                                                        } else {
                                                            phi_12587_ = (_e3817 && (_e3838 > _e3841));
                                                            phi_12588_ = true;
                                                        }
                                                        let _e3847 = phi_12587_;
                                                        let _e3849 = phi_12588_;
                                                        phi_12538_ = _e3847;
                                                        phi_12589_ = _e3849;
                                                        phi_12590_ = _e3843;
                                                    } else {
                                                        phi_12538_ = bool();
                                                        phi_12589_ = false;
                                                        phi_12590_ = false;
                                                    }
                                                    let _e3851 = phi_12538_;
                                                    let _e3853 = phi_12589_;
                                                    let _e3855 = phi_12590_;
                                                    local_26 = _e3855;
                                                    continue;
                                                    continuing {
                                                        phi_12534_ = _e3829;
                                                        phi_12537_ = _e3851;
                                                        break if !(_e3853);
                                                    }
                                                }
                                                let _e3858 = local_26;
                                                if _e3858 {
                                                    phi_12594_ = false;
                                                } else {
                                                    phi_12594_ = true;
                                                }
                                                let _e3860 = phi_12594_;
                                                if _e3860 {
                                                    let _e3862 = local_27;
                                                    if _e3862 {
                                                        phi_12601_ = 1u;
                                                    } else {
                                                        phi_12601_ = 2u;
                                                    }
                                                    let _e3864 = phi_12601_;
                                                    phi_12602_ = _e3864;
                                                    phi_12603_ = false;
                                                } else {
                                                    phi_12602_ = u32();
                                                    phi_12603_ = true;
                                                }
                                                let _e3866 = phi_12602_;
                                                let _e3868 = phi_12603_;
                                                phi_12604_ = _e3866;
                                                phi_12605_ = 0u;
                                                phi_12606_ = _e3868;
                                            } else {
                                                phi_12604_ = u32();
                                                phi_12605_ = 2u;
                                                phi_12606_ = true;
                                            }
                                            let _e3870 = phi_12604_;
                                            let _e3872 = phi_12605_;
                                            let _e3874 = phi_12606_;
                                            if _e3874 {
                                                phi_12610_ = _e3872;
                                            } else {
                                                phi_12610_ = _e3870;
                                            }
                                            let _e3876 = phi_12610_;
                                            let _e3877 = (_e3876 == 0u);
                                            if _e3877 {
                                                phi_15369_ = bool();
                                                phi_15370_ = f64();
                                                phi_15371_ = f64();
                                                phi_15372_ = false;
                                                phi_15373_ = false;
                                                phi_15374_ = false;
                                            } else {
                                                if (_e3876 == 1u) {
                                                    phi_12620_ = _e3152.member_2;
                                                } else {
                                                    phi_12620_ = false;
                                                }
                                                let _e3881 = phi_12620_;
                                                let _e3883 = (_e404 * f64(0.99f));
                                                if _e3881 {
                                                    if ((_e3152.member_1 - _e3152.member) <= _e3883) {
                                                        phi_12633_ = false;
                                                    } else {
                                                        phi_12633_ = true;
                                                    }
                                                    let _e3889 = phi_12633_;
                                                    phi_12634_ = _e3889;
                                                } else {
                                                    phi_12634_ = true;
                                                }
                                                let _e3891 = phi_12634_;
                                                if _e3891 {
                                                    let _e3896 = local_18.member[0u];
                                                    let _e3902 = local_18.member_1[0u];
                                                    let _e3908 = local_18.member_2[0u];
                                                    let _e3912 = (_e3896[0] - _e3902[0]);
                                                    let _e3913 = (_e3896[1] - _e3902[1]);
                                                    let _e3914 = (_e3896[2] - _e3902[2]);
                                                    let _e3923 = local_18.member[1u];
                                                    let _e3929 = local_18.member_1[1u];
                                                    let _e3935 = local_18.member_2[1u];
                                                    let _e3939 = (_e3923[0] - _e3929[0]);
                                                    let _e3940 = (_e3923[1] - _e3929[1]);
                                                    let _e3941 = (_e3923[2] - _e3929[2]);
                                                    let _e3950 = local_18.member[0u];
                                                    if (_e3950[0] < 0.0lf) {
                                                        phi_12782_ = -(_e3950[0]);
                                                    } else {
                                                        phi_12782_ = _e3950[0];
                                                    }
                                                    let _e3957 = phi_12782_;
                                                    if (_e3950[1] < 0.0lf) {
                                                        phi_12789_ = -(_e3950[1]);
                                                    } else {
                                                        phi_12789_ = _e3950[1];
                                                    }
                                                    let _e3961 = phi_12789_;
                                                    if (_e3957 > _e3961) {
                                                        phi_12794_ = _e3957;
                                                    } else {
                                                        phi_12794_ = _e3961;
                                                    }
                                                    let _e3964 = phi_12794_;
                                                    if (_e3950[2] < 0.0lf) {
                                                        phi_12801_ = -(_e3950[2]);
                                                    } else {
                                                        phi_12801_ = _e3950[2];
                                                    }
                                                    let _e3968 = phi_12801_;
                                                    if (_e3964 > _e3968) {
                                                        phi_12806_ = _e3964;
                                                    } else {
                                                        phi_12806_ = _e3968;
                                                    }
                                                    let _e3971 = phi_12806_;
                                                    let _e3974 = local_18.member[1u];
                                                    if (_e3974[0] < 0.0lf) {
                                                        phi_12819_ = -(_e3974[0]);
                                                    } else {
                                                        phi_12819_ = _e3974[0];
                                                    }
                                                    let _e3981 = phi_12819_;
                                                    if (_e3974[1] < 0.0lf) {
                                                        phi_12826_ = -(_e3974[1]);
                                                    } else {
                                                        phi_12826_ = _e3974[1];
                                                    }
                                                    let _e3985 = phi_12826_;
                                                    if (_e3981 > _e3985) {
                                                        phi_12831_ = _e3981;
                                                    } else {
                                                        phi_12831_ = _e3985;
                                                    }
                                                    let _e3988 = phi_12831_;
                                                    if (_e3974[2] < 0.0lf) {
                                                        phi_12838_ = -(_e3974[2]);
                                                    } else {
                                                        phi_12838_ = _e3974[2];
                                                    }
                                                    let _e3992 = phi_12838_;
                                                    if (_e3988 > _e3992) {
                                                        phi_12843_ = _e3988;
                                                    } else {
                                                        phi_12843_ = _e3992;
                                                    }
                                                    let _e3995 = phi_12843_;
                                                    if (_e3971 > _e3995) {
                                                        phi_12848_ = _e3971;
                                                    } else {
                                                        phi_12848_ = _e3995;
                                                    }
                                                    let _e3998 = phi_12848_;
                                                    let _e4000 = local_18.member_3;
                                                    let _e4004 = local_18.member_1[0u];
                                                    if (_e4004[0] < 0.0lf) {
                                                        phi_12865_ = -(_e4004[0]);
                                                    } else {
                                                        phi_12865_ = _e4004[0];
                                                    }
                                                    let _e4011 = phi_12865_;
                                                    if (_e4004[1] < 0.0lf) {
                                                        phi_12872_ = -(_e4004[1]);
                                                    } else {
                                                        phi_12872_ = _e4004[1];
                                                    }
                                                    let _e4015 = phi_12872_;
                                                    if (_e4011 > _e4015) {
                                                        phi_12877_ = _e4011;
                                                    } else {
                                                        phi_12877_ = _e4015;
                                                    }
                                                    let _e4018 = phi_12877_;
                                                    if (_e4004[2] < 0.0lf) {
                                                        phi_12884_ = -(_e4004[2]);
                                                    } else {
                                                        phi_12884_ = _e4004[2];
                                                    }
                                                    let _e4022 = phi_12884_;
                                                    if (_e4018 > _e4022) {
                                                        phi_12889_ = _e4018;
                                                    } else {
                                                        phi_12889_ = _e4022;
                                                    }
                                                    let _e4025 = phi_12889_;
                                                    let _e4028 = local_18.member_1[1u];
                                                    if (_e4028[0] < 0.0lf) {
                                                        phi_12903_ = -(_e4028[0]);
                                                    } else {
                                                        phi_12903_ = _e4028[0];
                                                    }
                                                    let _e4035 = phi_12903_;
                                                    if (_e4028[1] < 0.0lf) {
                                                        phi_12910_ = -(_e4028[1]);
                                                    } else {
                                                        phi_12910_ = _e4028[1];
                                                    }
                                                    let _e4039 = phi_12910_;
                                                    if (_e4035 > _e4039) {
                                                        phi_12915_ = _e4035;
                                                    } else {
                                                        phi_12915_ = _e4039;
                                                    }
                                                    let _e4042 = phi_12915_;
                                                    if (_e4028[2] < 0.0lf) {
                                                        phi_12922_ = -(_e4028[2]);
                                                    } else {
                                                        phi_12922_ = _e4028[2];
                                                    }
                                                    let _e4046 = phi_12922_;
                                                    if (_e4042 > _e4046) {
                                                        phi_12927_ = _e4042;
                                                    } else {
                                                        phi_12927_ = _e4046;
                                                    }
                                                    let _e4049 = phi_12927_;
                                                    if (_e4025 > _e4049) {
                                                        phi_12932_ = _e4025;
                                                    } else {
                                                        phi_12932_ = _e4049;
                                                    }
                                                    let _e4052 = phi_12932_;
                                                    let _e4054 = local_18.member_3;
                                                    let _e4058 = local_18.member_2[0u];
                                                    if (_e4058[0] < 0.0lf) {
                                                        phi_12949_ = -(_e4058[0]);
                                                    } else {
                                                        phi_12949_ = _e4058[0];
                                                    }
                                                    let _e4065 = phi_12949_;
                                                    if (_e4058[1] < 0.0lf) {
                                                        phi_12956_ = -(_e4058[1]);
                                                    } else {
                                                        phi_12956_ = _e4058[1];
                                                    }
                                                    let _e4069 = phi_12956_;
                                                    if (_e4065 > _e4069) {
                                                        phi_12961_ = _e4065;
                                                    } else {
                                                        phi_12961_ = _e4069;
                                                    }
                                                    let _e4072 = phi_12961_;
                                                    if (_e4058[2] < 0.0lf) {
                                                        phi_12968_ = -(_e4058[2]);
                                                    } else {
                                                        phi_12968_ = _e4058[2];
                                                    }
                                                    let _e4076 = phi_12968_;
                                                    if (_e4072 > _e4076) {
                                                        phi_12973_ = _e4072;
                                                    } else {
                                                        phi_12973_ = _e4076;
                                                    }
                                                    let _e4079 = phi_12973_;
                                                    let _e4082 = local_18.member_2[1u];
                                                    if (_e4082[0] < 0.0lf) {
                                                        phi_12987_ = -(_e4082[0]);
                                                    } else {
                                                        phi_12987_ = _e4082[0];
                                                    }
                                                    let _e4089 = phi_12987_;
                                                    if (_e4082[1] < 0.0lf) {
                                                        phi_12994_ = -(_e4082[1]);
                                                    } else {
                                                        phi_12994_ = _e4082[1];
                                                    }
                                                    let _e4093 = phi_12994_;
                                                    if (_e4089 > _e4093) {
                                                        phi_12999_ = _e4089;
                                                    } else {
                                                        phi_12999_ = _e4093;
                                                    }
                                                    let _e4096 = phi_12999_;
                                                    if (_e4082[2] < 0.0lf) {
                                                        phi_13006_ = -(_e4082[2]);
                                                    } else {
                                                        phi_13006_ = _e4082[2];
                                                    }
                                                    let _e4100 = phi_13006_;
                                                    if (_e4096 > _e4100) {
                                                        phi_13011_ = _e4096;
                                                    } else {
                                                        phi_13011_ = _e4100;
                                                    }
                                                    let _e4103 = phi_13011_;
                                                    if (_e4079 > _e4103) {
                                                        phi_13016_ = _e4079;
                                                    } else {
                                                        phi_13016_ = _e4103;
                                                    }
                                                    let _e4106 = phi_13016_;
                                                    let _e4108 = local_18.member_3;
                                                    let _e4116 = local_18.member_3;
                                                    let _e4124 = (_e404 * f64(0.00390625f));
                                                    let _e4125 = f64(0f);
                                                    let _e4126 = f64(1f);
                                                    local = type_38(array<f64, 4>(_e4125, _e4125, _e4125, _e4125), array<f64, 4>(_e4125, _e4125, _e4125, _e4125), array<f64, 4>(_e4126, _e4126, _e4126, _e4126));
                                                    phi_13063_ = type_12(0u, 96u);
                                                    phi_13066_ = _e3152.member;
                                                    phi_13068_ = _e3152.member;
                                                    phi_13070_ = (_e3152.member_1 - _e3152.member);
                                                    phi_13072_ = _e3152.member;
                                                    phi_13074_ = false;
                                                    phi_13076_ = 0u;
                                                    loop {
                                                        let _e4133 = phi_13063_;
                                                        let _e4135 = phi_13066_;
                                                        let _e4137 = phi_13068_;
                                                        let _e4139 = phi_13070_;
                                                        let _e4141 = phi_13072_;
                                                        let _e4143 = phi_13074_;
                                                        let _e4145 = phi_13076_;
                                                        local_31 = _e4135;
                                                        local_78 = _e4137;
                                                        if (_e4133.member < _e4133.member_1) {
                                                            phi_13064_ = type_12((_e4133.member + 1u), _e4133.member_1);
                                                            phi_13099_ = type_12(1u, _e4133.member);
                                                        } else {
                                                            phi_13064_ = _e4133;
                                                            phi_13099_ = type_12(0u, type_12().member_1);
                                                        }
                                                        let _e4157 = phi_13064_;
                                                        let _e4159 = phi_13099_;
                                                        if (bitcast<i32>(_e4159.member) != 0i) {
                                                            let _e4165 = local_18.member[0u];
                                                            let _e4171 = local_18.member[1u];
                                                            let _e4187 = local_18.member_1[0u];
                                                            let _e4193 = local_18.member_1[1u];
                                                            let _e4209 = local_18.member_2[0u];
                                                            let _e4215 = local_18.member_2[1u];
                                                            let _e4229 = function_4(array<f64, 3>((_e4165[0] + ((_e4171[0] - _e4165[0]) * _e4135)), (_e4165[1] + ((_e4171[1] - _e4165[1]) * _e4135)), (_e4165[2] + ((_e4171[2] - _e4165[2]) * _e4135))), array<f64, 3>((_e4187[0] + ((_e4193[0] - _e4187[0]) * _e4135)), (_e4187[1] + ((_e4193[1] - _e4187[1]) * _e4135)), (_e4187[2] + ((_e4193[2] - _e4187[2]) * _e4135))), array<f64, 3>((_e4209[0] + ((_e4215[0] - _e4209[0]) * _e4135)), (_e4209[1] + ((_e4215[1] - _e4209[1]) * _e4135)), (_e4209[2] + ((_e4215[2] - _e4209[2]) * _e4135))), 1u);
                                                            if (_e4145 == 0u) {
                                                                phi_13228_ = _e4229;
                                                            } else {
                                                                let _e4231 = f64(0f);
                                                                if (_e4145 == 1u) {
                                                                    phi_13214_ = _e4229[0];
                                                                } else {
                                                                    phi_13214_ = _e4231;
                                                                }
                                                                let _e4235 = phi_13214_;
                                                                if (_e4145 == 2u) {
                                                                    phi_13220_ = _e4229[1];
                                                                } else {
                                                                    phi_13220_ = _e4231;
                                                                }
                                                                let _e4239 = phi_13220_;
                                                                if (_e4145 == 3u) {
                                                                    phi_13226_ = _e4229[2];
                                                                } else {
                                                                    phi_13226_ = _e4231;
                                                                }
                                                                let _e4243 = phi_13226_;
                                                                phi_13228_ = array<f64, 3>(_e4235, _e4239, _e4243);
                                                            }
                                                            let _e4246 = phi_13228_;
                                                            if (_e4246[0] < 0.0lf) {
                                                                phi_13235_ = -(_e4246[0]);
                                                            } else {
                                                                phi_13235_ = _e4246[0];
                                                            }
                                                            let _e4251 = phi_13235_;
                                                            if (_e4246[1] < 0.0lf) {
                                                                phi_13242_ = -(_e4246[1]);
                                                            } else {
                                                                phi_13242_ = _e4246[1];
                                                            }
                                                            let _e4256 = phi_13242_;
                                                            if (_e4246[2] < 0.0lf) {
                                                                phi_13250_ = -(_e4246[2]);
                                                            } else {
                                                                phi_13250_ = _e4246[2];
                                                            }
                                                            let _e4262 = phi_13250_;
                                                            let _e4263 = ((_e4251 + _e4256) + _e4262);
                                                            if (_e4263 > f64(0f)) {
                                                                if ((bitcast<u64>(_e4263) & 9218868437227405312lu) != 9218868437227405312lu) {
                                                                    let _e4270 = (f64(1f) / _e4263);
                                                                    let _e4272 = (_e4246[0] * _e4270);
                                                                    let _e4274 = (_e4246[1] * _e4270);
                                                                    let _e4276 = (_e4246[2] * _e4270);
                                                                    let _e4281 = (((_e4272 * _e4272) + (_e4274 * _e4274)) + (_e4276 * _e4276));
                                                                    if (_e4281 <= 2.2250738585072014e-308lf) {
                                                                        if (_e4281 > 0.0lf) {
                                                                            phi_13289_ = (1.464336215552873e-154lf * 2.0lf);
                                                                        } else {
                                                                            phi_13289_ = 0.0lf;
                                                                        }
                                                                        let _e4333 = phi_13289_;
                                                                        phi_13353_ = _e4333;
                                                                    } else {
                                                                        phi_13296_ = type_16(0i, 5i);
                                                                        phi_13299_ = bitcast<f64>(((bitcast<u64>(_e4281) / 2lu) + 2303426169912950784lu));
                                                                        loop {
                                                                            let _e4288 = phi_13296_;
                                                                            let _e4290 = phi_13299_;
                                                                            local_28 = _e4290;
                                                                            if (_e4288.member < _e4288.member_1) {
                                                                                let _e4297 = (_e4288.member + 1i);
                                                                                if ((false == (_e4297 > _e4288.member)) != false) {
                                                                                    phi_13320_ = true;
                                                                                } else {
                                                                                    phi_13320_ = false;
                                                                                }
                                                                                let _e4302 = phi_13320_;
                                                                                if _e4302 {
                                                                                    phi_13326_ = type_17(0u, type_17().member_1);
                                                                                } else {
                                                                                    phi_13326_ = type_17(1u, _e4297);
                                                                                }
                                                                                let _e4307 = phi_13326_;
                                                                                phi_13297_ = type_16(_e4307.member_1, _e4288.member_1);
                                                                                phi_13340_ = type_17(1u, _e4288.member);
                                                                            } else {
                                                                                phi_13297_ = _e4288;
                                                                                phi_13340_ = type_17(0u, type_17().member_1);
                                                                            }
                                                                            let _e4313 = phi_13297_;
                                                                            let _e4315 = phi_13340_;
                                                                            let _e4318 = (bitcast<i32>(_e4315.member) != 0i);
                                                                            if _e4318 {
                                                                                phi_13300_ = (0.5lf * (_e4290 + (_e4281 / _e4290)));
                                                                            } else {
                                                                                phi_13300_ = f64();
                                                                            }
                                                                            let _e4323 = phi_13300_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_13296_ = _e4313;
                                                                                phi_13299_ = _e4323;
                                                                                break if !(_e4318);
                                                                            }
                                                                        }
                                                                        let _e4328 = local_28;
                                                                        phi_13353_ = (_e4328 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                    }
                                                                    let _e4335 = phi_13353_;
                                                                    let _e4337 = (1.1102230246251565e-16lf * f64(12f));
                                                                    let _e4344 = ((((((((_e3998 + _e4000) + (_e4052 + _e4054)) + (_e4106 + _e4108)) * (1.1102230246251565e-16lf * f64(16f))) + (_e4116 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(1.01f)) + ((_e666 * _e4335) * (f64(1f) + _e4337)));
                                                                    let _e4349 = (((_e4272 * _e3896[0]) + (_e4274 * _e3896[1])) + (_e4276 * _e3896[2]));
                                                                    let _e4354 = (((_e4272 * _e3912) + (_e4274 * _e3913)) + (_e4276 * _e3914));
                                                                    let _e4359 = (((_e4272 * (_e3896[0] - _e3908[0])) + (_e4274 * (_e3896[1] - _e3908[1]))) + (_e4276 * (_e3896[2] - _e3908[2])));
                                                                    let _e4364 = (((_e4272 * (_e3912 - _e3908[0])) + (_e4274 * (_e3913 - _e3908[1]))) + (_e4276 * (_e3914 - _e3908[2])));
                                                                    let _e4370 = (((_e4272 * _e3923[0]) + (_e4274 * _e3923[1])) + (_e4276 * _e3923[2]));
                                                                    let _e4375 = (((_e4272 * _e3939) + (_e4274 * _e3940)) + (_e4276 * _e3941));
                                                                    let _e4380 = (((_e4272 * (_e3923[0] - _e3935[0])) + (_e4274 * (_e3923[1] - _e3935[1]))) + (_e4276 * (_e3923[2] - _e3935[2])));
                                                                    let _e4385 = (((_e4272 * (_e3939 - _e3935[0])) + (_e4274 * (_e3940 - _e3935[1]))) + (_e4276 * (_e3941 - _e3935[2])));
                                                                    if (_e4349 < 0.0lf) {
                                                                        phi_13422_ = -(_e4349);
                                                                    } else {
                                                                        phi_13422_ = _e4349;
                                                                    }
                                                                    let _e4390 = phi_13422_;
                                                                    if (_e4370 < 0.0lf) {
                                                                        phi_13428_ = -(_e4370);
                                                                    } else {
                                                                        phi_13428_ = _e4370;
                                                                    }
                                                                    let _e4394 = phi_13428_;
                                                                    if (_e4354 < 0.0lf) {
                                                                        phi_13437_ = -(_e4354);
                                                                    } else {
                                                                        phi_13437_ = _e4354;
                                                                    }
                                                                    let _e4401 = phi_13437_;
                                                                    if (_e4375 < 0.0lf) {
                                                                        phi_13443_ = -(_e4375);
                                                                    } else {
                                                                        phi_13443_ = _e4375;
                                                                    }
                                                                    let _e4405 = phi_13443_;
                                                                    if (_e4359 < 0.0lf) {
                                                                        phi_13452_ = -(_e4359);
                                                                    } else {
                                                                        phi_13452_ = _e4359;
                                                                    }
                                                                    let _e4412 = phi_13452_;
                                                                    if (_e4380 < 0.0lf) {
                                                                        phi_13458_ = -(_e4380);
                                                                    } else {
                                                                        phi_13458_ = _e4380;
                                                                    }
                                                                    let _e4416 = phi_13458_;
                                                                    if (_e4364 < 0.0lf) {
                                                                        phi_13467_ = -(_e4364);
                                                                    } else {
                                                                        phi_13467_ = _e4364;
                                                                    }
                                                                    let _e4423 = phi_13467_;
                                                                    if (_e4385 < 0.0lf) {
                                                                        phi_13473_ = -(_e4385);
                                                                    } else {
                                                                        phi_13473_ = _e4385;
                                                                    }
                                                                    let _e4427 = phi_13473_;
                                                                    phi_13479_ = type_38(array<f64, 4>(_e4349, _e4354, _e4359, _e4364), array<f64, 4>(_e4370, _e4375, _e4380, _e4385), array<f64, 4>((_e4344 + ((_e4390 + _e4394) * _e4337)), (_e4344 + ((_e4401 + _e4405) * _e4337)), (_e4344 + ((_e4412 + _e4416) * _e4337)), (_e4344 + ((_e4423 + _e4427) * _e4337))));
                                                                    phi_13480_ = false;
                                                                } else {
                                                                    phi_13479_ = type_38();
                                                                    phi_13480_ = true;
                                                                }
                                                                let _e4434 = phi_13479_;
                                                                let _e4436 = phi_13480_;
                                                                phi_13481_ = _e4434;
                                                                phi_13482_ = _e4436;
                                                            } else {
                                                                phi_13481_ = type_38();
                                                                phi_13482_ = true;
                                                            }
                                                            let _e4438 = phi_13481_;
                                                            let _e4440 = phi_13482_;
                                                            if _e4440 {
                                                                let _e4441 = f64(0f);
                                                                let _e4442 = f64(1f);
                                                                phi_13492_ = type_38(array<f64, 4>(_e4441, _e4441, _e4441, _e4441), array<f64, 4>(_e4441, _e4441, _e4441, _e4441), array<f64, 4>(_e4442, _e4442, _e4442, _e4442));
                                                            } else {
                                                                phi_13492_ = _e4438;
                                                            }
                                                            let _e4448 = phi_13492_;
                                                            local_1 = type_38(array<f64, 4>(_e4448.member[0], _e4448.member[1], _e4448.member[2], _e4448.member[3]), array<f64, 4>(_e4448.member_1[0], _e4448.member_1[1], _e4448.member_1[2], _e4448.member_1[3]), array<f64, 4>(_e4448.member_2[0], _e4448.member_2[1], _e4448.member_2[2], _e4448.member_2[3]));
                                                            let _e4468 = (_e4135 - _e4141);
                                                            let _e4470 = f64(0f);
                                                            let _e4473 = local_1.member[0u];
                                                            let _e4476 = local_1.member_1[0u];
                                                            let _e4479 = local_1.member[0u];
                                                            let _e4485 = local_1.member_2[0u];
                                                            if (((_e4473 + ((_e4476 - _e4479) * _e4135)) - _e4485) > _e4470) {
                                                                let _e4490 = local_1.member[1u];
                                                                let _e4493 = local_1.member_1[1u];
                                                                let _e4496 = local_1.member[1u];
                                                                let _e4502 = local_1.member_2[1u];
                                                                if (((_e4490 + ((_e4493 - _e4496) * _e4135)) - _e4502) > _e4470) {
                                                                    let _e4507 = local_1.member[2u];
                                                                    let _e4510 = local_1.member_1[2u];
                                                                    let _e4513 = local_1.member[2u];
                                                                    let _e4519 = local_1.member_2[2u];
                                                                    if (((_e4507 + ((_e4510 - _e4513) * _e4135)) - _e4519) > _e4470) {
                                                                        let _e4524 = local_1.member[3u];
                                                                        let _e4527 = local_1.member_1[3u];
                                                                        let _e4530 = local_1.member[3u];
                                                                        let _e4536 = local_1.member_2[3u];
                                                                        phi_13664_ = (((_e4524 + ((_e4527 - _e4530) * _e4135)) - _e4536) > _e4470);
                                                                        phi_13665_ = false;
                                                                    } else {
                                                                        phi_13664_ = bool();
                                                                        phi_13665_ = true;
                                                                    }
                                                                    let _e4540 = phi_13664_;
                                                                    let _e4542 = phi_13665_;
                                                                    phi_13666_ = _e4540;
                                                                    phi_13667_ = _e4542;
                                                                } else {
                                                                    phi_13666_ = bool();
                                                                    phi_13667_ = true;
                                                                }
                                                                let _e4544 = phi_13666_;
                                                                let _e4546 = phi_13667_;
                                                                phi_13668_ = _e4544;
                                                                phi_13669_ = _e4546;
                                                            } else {
                                                                phi_13668_ = bool();
                                                                phi_13669_ = true;
                                                            }
                                                            let _e4548 = phi_13668_;
                                                            let _e4550 = phi_13669_;
                                                            if _e4550 {
                                                                phi_13673_ = false;
                                                            } else {
                                                                phi_13673_ = _e4548;
                                                            }
                                                            let _e4552 = phi_13673_;
                                                            if _e4552 {
                                                                if (_e4135 <= _e4137) {
                                                                    phi_13984_ = true;
                                                                } else {
                                                                    let _e4554 = f64(0f);
                                                                    let _e4557 = local.member[0u];
                                                                    let _e4560 = local.member_1[0u];
                                                                    let _e4563 = local.member[0u];
                                                                    let _e4569 = local.member_2[0u];
                                                                    let _e4573 = local_1.member[0u];
                                                                    let _e4576 = local_1.member_1[0u];
                                                                    let _e4579 = local_1.member[0u];
                                                                    let _e4585 = local_1.member_2[0u];
                                                                    if ((((_e4557 + ((_e4560 - _e4563) * _e4135)) - _e4569) + ((_e4573 + ((_e4576 - _e4579) * _e4141)) - _e4585)) > _e4554) {
                                                                        let _e4591 = local.member[1u];
                                                                        let _e4594 = local.member_1[1u];
                                                                        let _e4597 = local.member[1u];
                                                                        let _e4603 = local.member_2[1u];
                                                                        let _e4607 = local_1.member[1u];
                                                                        let _e4610 = local_1.member_1[1u];
                                                                        let _e4613 = local_1.member[1u];
                                                                        let _e4619 = local_1.member_2[1u];
                                                                        if ((((_e4591 + ((_e4594 - _e4597) * _e4135)) - _e4603) + ((_e4607 + ((_e4610 - _e4613) * _e4141)) - _e4619)) > _e4554) {
                                                                            let _e4625 = local.member[2u];
                                                                            let _e4628 = local.member_1[2u];
                                                                            let _e4631 = local.member[2u];
                                                                            let _e4637 = local.member_2[2u];
                                                                            let _e4641 = local_1.member[2u];
                                                                            let _e4644 = local_1.member_1[2u];
                                                                            let _e4647 = local_1.member[2u];
                                                                            let _e4653 = local_1.member_2[2u];
                                                                            if ((((_e4625 + ((_e4628 - _e4631) * _e4135)) - _e4637) + ((_e4641 + ((_e4644 - _e4647) * _e4141)) - _e4653)) > _e4554) {
                                                                                let _e4659 = local.member[3u];
                                                                                let _e4662 = local.member_1[3u];
                                                                                let _e4665 = local.member[3u];
                                                                                let _e4671 = local.member_2[3u];
                                                                                let _e4675 = local_1.member[3u];
                                                                                let _e4678 = local_1.member_1[3u];
                                                                                let _e4681 = local_1.member[3u];
                                                                                let _e4687 = local_1.member_2[3u];
                                                                                phi_13971_ = ((((_e4659 + ((_e4662 - _e4665) * _e4135)) - _e4671) + ((_e4675 + ((_e4678 - _e4681) * _e4141)) - _e4687)) > _e4554);
                                                                                phi_13972_ = false;
                                                                            } else {
                                                                                phi_13971_ = bool();
                                                                                phi_13972_ = true;
                                                                            }
                                                                            let _e4692 = phi_13971_;
                                                                            let _e4694 = phi_13972_;
                                                                            phi_13973_ = _e4692;
                                                                            phi_13974_ = _e4694;
                                                                        } else {
                                                                            phi_13973_ = bool();
                                                                            phi_13974_ = true;
                                                                        }
                                                                        let _e4696 = phi_13973_;
                                                                        let _e4698 = phi_13974_;
                                                                        phi_13975_ = _e4696;
                                                                        phi_13976_ = _e4698;
                                                                    } else {
                                                                        phi_13975_ = bool();
                                                                        phi_13976_ = true;
                                                                    }
                                                                    let _e4700 = phi_13975_;
                                                                    let _e4702 = phi_13976_;
                                                                    if _e4702 {
                                                                        phi_13980_ = false;
                                                                    } else {
                                                                        phi_13980_ = _e4700;
                                                                    }
                                                                    let _e4704 = phi_13980_;
                                                                    phi_13984_ = _e4704;
                                                                }
                                                                let _e4706 = phi_13984_;
                                                                if _e4706 {
                                                                    if _e4143 {
                                                                        if (_e4135 >= _e3152.member_1) {
                                                                            phi_13995_ = false;
                                                                        } else {
                                                                            phi_13995_ = true;
                                                                        }
                                                                        let _e4709 = phi_13995_;
                                                                        phi_13996_ = _e4709;
                                                                    } else {
                                                                        phi_13996_ = true;
                                                                    }
                                                                    let _e4711 = phi_13996_;
                                                                    if _e4711 {
                                                                        local = type_38(array<f64, 4>(_e4448.member[0], _e4448.member[1], _e4448.member[2], _e4448.member[3]), array<f64, 4>(_e4448.member_1[0], _e4448.member_1[1], _e4448.member_1[2], _e4448.member_1[3]), array<f64, 4>(_e4448.member_2[0], _e4448.member_2[1], _e4448.member_2[2], _e4448.member_2[3]));
                                                                        let _e4733 = local.member[0u];
                                                                        let _e4736 = local.member_1[0u];
                                                                        let _e4739 = local.member_2[0u];
                                                                        if (_e4733 > _e4739) {
                                                                            if (_e4736 > _e4739) {
                                                                                phi_14070_ = false;
                                                                            } else {
                                                                                phi_14070_ = true;
                                                                            }
                                                                            let _e4743 = phi_14070_;
                                                                            phi_14071_ = _e4743;
                                                                        } else {
                                                                            phi_14071_ = true;
                                                                        }
                                                                        let _e4745 = phi_14071_;
                                                                        if _e4745 {
                                                                            let _e4746 = (_e4736 >= _e4733);
                                                                            if _e4746 {
                                                                                phi_14096_ = f64();
                                                                                phi_14097_ = false;
                                                                            } else {
                                                                                if ((_e4733 - _e4736) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14094_ = (((_e4733 - _e4739) / (_e4733 - _e4736)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14095_ = false;
                                                                                } else {
                                                                                    phi_14094_ = f64();
                                                                                    phi_14095_ = true;
                                                                                }
                                                                                let _e4760 = phi_14094_;
                                                                                let _e4762 = phi_14095_;
                                                                                phi_14096_ = _e4760;
                                                                                phi_14097_ = _e4762;
                                                                            }
                                                                            let _e4764 = phi_14096_;
                                                                            let _e4766 = phi_14097_;
                                                                            phi_14098_ = _e4764;
                                                                            phi_14099_ = _e4746;
                                                                            phi_14100_ = _e4766;
                                                                        } else {
                                                                            phi_14098_ = f64();
                                                                            phi_14099_ = true;
                                                                            phi_14100_ = false;
                                                                        }
                                                                        let _e4768 = phi_14098_;
                                                                        let _e4770 = phi_14099_;
                                                                        let _e4772 = phi_14100_;
                                                                        if _e4770 {
                                                                            phi_14105_ = f64(2f);
                                                                            phi_14106_ = true;
                                                                        } else {
                                                                            phi_14105_ = _e4135;
                                                                            phi_14106_ = _e4772;
                                                                        }
                                                                        let _e4775 = phi_14105_;
                                                                        let _e4777 = phi_14106_;
                                                                        if _e4777 {
                                                                            phi_14110_ = _e4775;
                                                                        } else {
                                                                            phi_14110_ = _e4768;
                                                                        }
                                                                        let _e4779 = phi_14110_;
                                                                        let _e4782 = local.member[1u];
                                                                        let _e4785 = local.member_1[1u];
                                                                        let _e4788 = local.member_2[1u];
                                                                        if (_e4782 > _e4788) {
                                                                            if (_e4785 > _e4788) {
                                                                                phi_14142_ = false;
                                                                            } else {
                                                                                phi_14142_ = true;
                                                                            }
                                                                            let _e4792 = phi_14142_;
                                                                            phi_14143_ = _e4792;
                                                                        } else {
                                                                            phi_14143_ = true;
                                                                        }
                                                                        let _e4794 = phi_14143_;
                                                                        if _e4794 {
                                                                            let _e4795 = (_e4785 >= _e4782);
                                                                            if _e4795 {
                                                                                phi_14168_ = f64();
                                                                                phi_14169_ = false;
                                                                            } else {
                                                                                if ((_e4782 - _e4785) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14166_ = (((_e4782 - _e4788) / (_e4782 - _e4785)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14167_ = false;
                                                                                } else {
                                                                                    phi_14166_ = f64();
                                                                                    phi_14167_ = true;
                                                                                }
                                                                                let _e4809 = phi_14166_;
                                                                                let _e4811 = phi_14167_;
                                                                                phi_14168_ = _e4809;
                                                                                phi_14169_ = _e4811;
                                                                            }
                                                                            let _e4813 = phi_14168_;
                                                                            let _e4815 = phi_14169_;
                                                                            phi_14170_ = _e4813;
                                                                            phi_14171_ = _e4795;
                                                                            phi_14172_ = _e4815;
                                                                        } else {
                                                                            phi_14170_ = f64();
                                                                            phi_14171_ = true;
                                                                            phi_14172_ = false;
                                                                        }
                                                                        let _e4817 = phi_14170_;
                                                                        let _e4819 = phi_14171_;
                                                                        let _e4821 = phi_14172_;
                                                                        if _e4819 {
                                                                            phi_14177_ = f64(2f);
                                                                            phi_14178_ = true;
                                                                        } else {
                                                                            phi_14177_ = _e4135;
                                                                            phi_14178_ = _e4821;
                                                                        }
                                                                        let _e4824 = phi_14177_;
                                                                        let _e4826 = phi_14178_;
                                                                        if _e4826 {
                                                                            phi_14182_ = _e4824;
                                                                        } else {
                                                                            phi_14182_ = _e4817;
                                                                        }
                                                                        let _e4828 = phi_14182_;
                                                                        if (_e4779 < _e4828) {
                                                                            phi_14187_ = _e4779;
                                                                        } else {
                                                                            phi_14187_ = _e4828;
                                                                        }
                                                                        let _e4831 = phi_14187_;
                                                                        let _e4834 = local.member[2u];
                                                                        let _e4837 = local.member_1[2u];
                                                                        let _e4840 = local.member_2[2u];
                                                                        if (_e4834 > _e4840) {
                                                                            if (_e4837 > _e4840) {
                                                                                phi_14219_ = false;
                                                                            } else {
                                                                                phi_14219_ = true;
                                                                            }
                                                                            let _e4844 = phi_14219_;
                                                                            phi_14220_ = _e4844;
                                                                        } else {
                                                                            phi_14220_ = true;
                                                                        }
                                                                        let _e4846 = phi_14220_;
                                                                        if _e4846 {
                                                                            let _e4847 = (_e4837 >= _e4834);
                                                                            if _e4847 {
                                                                                phi_14245_ = f64();
                                                                                phi_14246_ = false;
                                                                            } else {
                                                                                if ((_e4834 - _e4837) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14243_ = (((_e4834 - _e4840) / (_e4834 - _e4837)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14244_ = false;
                                                                                } else {
                                                                                    phi_14243_ = f64();
                                                                                    phi_14244_ = true;
                                                                                }
                                                                                let _e4861 = phi_14243_;
                                                                                let _e4863 = phi_14244_;
                                                                                phi_14245_ = _e4861;
                                                                                phi_14246_ = _e4863;
                                                                            }
                                                                            let _e4865 = phi_14245_;
                                                                            let _e4867 = phi_14246_;
                                                                            phi_14247_ = _e4865;
                                                                            phi_14248_ = _e4847;
                                                                            phi_14249_ = _e4867;
                                                                        } else {
                                                                            phi_14247_ = f64();
                                                                            phi_14248_ = true;
                                                                            phi_14249_ = false;
                                                                        }
                                                                        let _e4869 = phi_14247_;
                                                                        let _e4871 = phi_14248_;
                                                                        let _e4873 = phi_14249_;
                                                                        if _e4871 {
                                                                            phi_14254_ = f64(2f);
                                                                            phi_14255_ = true;
                                                                        } else {
                                                                            phi_14254_ = _e4135;
                                                                            phi_14255_ = _e4873;
                                                                        }
                                                                        let _e4876 = phi_14254_;
                                                                        let _e4878 = phi_14255_;
                                                                        if _e4878 {
                                                                            phi_14259_ = _e4876;
                                                                        } else {
                                                                            phi_14259_ = _e4869;
                                                                        }
                                                                        let _e4880 = phi_14259_;
                                                                        let _e4883 = local.member[3u];
                                                                        let _e4886 = local.member_1[3u];
                                                                        let _e4889 = local.member_2[3u];
                                                                        if (_e4883 > _e4889) {
                                                                            if (_e4886 > _e4889) {
                                                                                phi_14291_ = false;
                                                                            } else {
                                                                                phi_14291_ = true;
                                                                            }
                                                                            let _e4893 = phi_14291_;
                                                                            phi_14292_ = _e4893;
                                                                        } else {
                                                                            phi_14292_ = true;
                                                                        }
                                                                        let _e4895 = phi_14292_;
                                                                        if _e4895 {
                                                                            let _e4896 = (_e4886 >= _e4883);
                                                                            if _e4896 {
                                                                                phi_14317_ = f64();
                                                                                phi_14318_ = false;
                                                                            } else {
                                                                                if ((_e4883 - _e4886) <= (f64(0.25f) / 2.2250738585072014e-308lf)) {
                                                                                    phi_14315_ = (((_e4883 - _e4889) / (_e4883 - _e4886)) * (f64(1f) - (1.1102230246251565e-16lf * f64(16f))));
                                                                                    phi_14316_ = false;
                                                                                } else {
                                                                                    phi_14315_ = f64();
                                                                                    phi_14316_ = true;
                                                                                }
                                                                                let _e4910 = phi_14315_;
                                                                                let _e4912 = phi_14316_;
                                                                                phi_14317_ = _e4910;
                                                                                phi_14318_ = _e4912;
                                                                            }
                                                                            let _e4914 = phi_14317_;
                                                                            let _e4916 = phi_14318_;
                                                                            phi_14319_ = _e4914;
                                                                            phi_14320_ = _e4896;
                                                                            phi_14321_ = _e4916;
                                                                        } else {
                                                                            phi_14319_ = f64();
                                                                            phi_14320_ = true;
                                                                            phi_14321_ = false;
                                                                        }
                                                                        let _e4918 = phi_14319_;
                                                                        let _e4920 = phi_14320_;
                                                                        let _e4922 = phi_14321_;
                                                                        if _e4920 {
                                                                            phi_14326_ = f64(2f);
                                                                            phi_14327_ = true;
                                                                        } else {
                                                                            phi_14326_ = _e4135;
                                                                            phi_14327_ = _e4922;
                                                                        }
                                                                        let _e4925 = phi_14326_;
                                                                        let _e4927 = phi_14327_;
                                                                        if _e4927 {
                                                                            phi_14331_ = _e4925;
                                                                        } else {
                                                                            phi_14331_ = _e4918;
                                                                        }
                                                                        let _e4929 = phi_14331_;
                                                                        if (_e4880 < _e4929) {
                                                                            phi_14336_ = _e4880;
                                                                        } else {
                                                                            phi_14336_ = _e4929;
                                                                        }
                                                                        let _e4932 = phi_14336_;
                                                                        if (_e4831 < _e4932) {
                                                                            phi_14341_ = _e4831;
                                                                        } else {
                                                                            phi_14341_ = _e4932;
                                                                        }
                                                                        let _e4935 = phi_14341_;
                                                                        if (_e4935 > _e4135) {
                                                                            phi_14346_ = _e4935;
                                                                        } else {
                                                                            phi_14346_ = _e4135;
                                                                        }
                                                                        let _e4938 = phi_14346_;
                                                                        let _e4939 = (_e4938 > _e3152.member_1);
                                                                        if _e4939 {
                                                                            phi_14863_ = f64();
                                                                            phi_14864_ = f64();
                                                                            phi_14865_ = false;
                                                                            phi_14866_ = false;
                                                                        } else {
                                                                            let _e4940 = (_e4938 - _e4135);
                                                                            let _e4941 = (_e4940 <= _e4124);
                                                                            let _e4944 = (_e4938 + (_e404 * f64(0.01f)));
                                                                            if (_e4944 < _e3152.member_1) {
                                                                                phi_14360_ = _e4944;
                                                                            } else {
                                                                                phi_14360_ = _e3152.member_1;
                                                                            }
                                                                            let _e4947 = phi_14360_;
                                                                            if _e4941 {
                                                                                if (_e666 > f64(0f)) {
                                                                                    let _e4952 = local_18.member[0u];
                                                                                    let _e4958 = local_18.member[1u];
                                                                                    let _e4974 = local_18.member_1[0u];
                                                                                    let _e4980 = local_18.member_1[1u];
                                                                                    let _e4996 = local_18.member_2[0u];
                                                                                    let _e5002 = local_18.member_2[1u];
                                                                                    let _e5016 = function_4(array<f64, 3>((_e4952[0] + ((_e4958[0] - _e4952[0]) * _e4947)), (_e4952[1] + ((_e4958[1] - _e4952[1]) * _e4947)), (_e4952[2] + ((_e4958[2] - _e4952[2]) * _e4947))), array<f64, 3>((_e4974[0] + ((_e4980[0] - _e4974[0]) * _e4947)), (_e4974[1] + ((_e4980[1] - _e4974[1]) * _e4947)), (_e4974[2] + ((_e4980[2] - _e4974[2]) * _e4947))), array<f64, 3>((_e4996[0] + ((_e5002[0] - _e4996[0]) * _e4947)), (_e4996[1] + ((_e5002[1] - _e4996[1]) * _e4947)), (_e4996[2] + ((_e5002[2] - _e4996[2]) * _e4947))), 1u);
                                                                                    let _e5027 = (((_e5016[0] * _e5016[0]) + (_e5016[1] * _e5016[1])) + (_e5016[2] * _e5016[2]));
                                                                                    if (_e5027 <= 2.2250738585072014e-308lf) {
                                                                                        if (_e5027 > 0.0lf) {
                                                                                            phi_14491_ = (1.464336215552873e-154lf * 2.0lf);
                                                                                        } else {
                                                                                            phi_14491_ = 0.0lf;
                                                                                        }
                                                                                        let _e5079 = phi_14491_;
                                                                                        phi_14555_ = _e5079;
                                                                                    } else {
                                                                                        phi_14498_ = type_16(0i, 5i);
                                                                                        phi_14501_ = bitcast<f64>(((bitcast<u64>(_e5027) / 2lu) + 2303426169912950784lu));
                                                                                        loop {
                                                                                            let _e5034 = phi_14498_;
                                                                                            let _e5036 = phi_14501_;
                                                                                            local_29 = _e5036;
                                                                                            if (_e5034.member < _e5034.member_1) {
                                                                                                let _e5043 = (_e5034.member + 1i);
                                                                                                if ((false == (_e5043 > _e5034.member)) != false) {
                                                                                                    phi_14522_ = true;
                                                                                                } else {
                                                                                                    phi_14522_ = false;
                                                                                                }
                                                                                                let _e5048 = phi_14522_;
                                                                                                if _e5048 {
                                                                                                    phi_14528_ = type_17(0u, type_17().member_1);
                                                                                                } else {
                                                                                                    phi_14528_ = type_17(1u, _e5043);
                                                                                                }
                                                                                                let _e5053 = phi_14528_;
                                                                                                phi_14499_ = type_16(_e5053.member_1, _e5034.member_1);
                                                                                                phi_14542_ = type_17(1u, _e5034.member);
                                                                                            } else {
                                                                                                phi_14499_ = _e5034;
                                                                                                phi_14542_ = type_17(0u, type_17().member_1);
                                                                                            }
                                                                                            let _e5059 = phi_14499_;
                                                                                            let _e5061 = phi_14542_;
                                                                                            let _e5064 = (bitcast<i32>(_e5061.member) != 0i);
                                                                                            if _e5064 {
                                                                                                phi_14502_ = (0.5lf * (_e5036 + (_e5027 / _e5036)));
                                                                                            } else {
                                                                                                phi_14502_ = f64();
                                                                                            }
                                                                                            let _e5069 = phi_14502_;
                                                                                            continue;
                                                                                            continuing {
                                                                                                phi_14498_ = _e5059;
                                                                                                phi_14501_ = _e5069;
                                                                                                break if !(_e5064);
                                                                                            }
                                                                                        }
                                                                                        let _e5074 = local_29;
                                                                                        phi_14555_ = (_e5074 * (1.0lf + (8.0lf * 1.1102230246251565e-16lf)));
                                                                                    }
                                                                                    let _e5081 = phi_14555_;
                                                                                    let _e5089 = local_18.member[0u];
                                                                                    if (_e5089[0] < 0.0lf) {
                                                                                        phi_14573_ = -(_e5089[0]);
                                                                                    } else {
                                                                                        phi_14573_ = _e5089[0];
                                                                                    }
                                                                                    let _e5096 = phi_14573_;
                                                                                    if (_e5089[1] < 0.0lf) {
                                                                                        phi_14580_ = -(_e5089[1]);
                                                                                    } else {
                                                                                        phi_14580_ = _e5089[1];
                                                                                    }
                                                                                    let _e5100 = phi_14580_;
                                                                                    if (_e5096 > _e5100) {
                                                                                        phi_14585_ = _e5096;
                                                                                    } else {
                                                                                        phi_14585_ = _e5100;
                                                                                    }
                                                                                    let _e5103 = phi_14585_;
                                                                                    if (_e5089[2] < 0.0lf) {
                                                                                        phi_14592_ = -(_e5089[2]);
                                                                                    } else {
                                                                                        phi_14592_ = _e5089[2];
                                                                                    }
                                                                                    let _e5107 = phi_14592_;
                                                                                    if (_e5103 > _e5107) {
                                                                                        phi_14597_ = _e5103;
                                                                                    } else {
                                                                                        phi_14597_ = _e5107;
                                                                                    }
                                                                                    let _e5110 = phi_14597_;
                                                                                    let _e5113 = local_18.member[1u];
                                                                                    if (_e5113[0] < 0.0lf) {
                                                                                        phi_14610_ = -(_e5113[0]);
                                                                                    } else {
                                                                                        phi_14610_ = _e5113[0];
                                                                                    }
                                                                                    let _e5120 = phi_14610_;
                                                                                    if (_e5113[1] < 0.0lf) {
                                                                                        phi_14617_ = -(_e5113[1]);
                                                                                    } else {
                                                                                        phi_14617_ = _e5113[1];
                                                                                    }
                                                                                    let _e5124 = phi_14617_;
                                                                                    if (_e5120 > _e5124) {
                                                                                        phi_14622_ = _e5120;
                                                                                    } else {
                                                                                        phi_14622_ = _e5124;
                                                                                    }
                                                                                    let _e5127 = phi_14622_;
                                                                                    if (_e5113[2] < 0.0lf) {
                                                                                        phi_14629_ = -(_e5113[2]);
                                                                                    } else {
                                                                                        phi_14629_ = _e5113[2];
                                                                                    }
                                                                                    let _e5131 = phi_14629_;
                                                                                    if (_e5127 > _e5131) {
                                                                                        phi_14634_ = _e5127;
                                                                                    } else {
                                                                                        phi_14634_ = _e5131;
                                                                                    }
                                                                                    let _e5134 = phi_14634_;
                                                                                    if (_e5110 > _e5134) {
                                                                                        phi_14639_ = _e5110;
                                                                                    } else {
                                                                                        phi_14639_ = _e5134;
                                                                                    }
                                                                                    let _e5137 = phi_14639_;
                                                                                    let _e5139 = local_18.member_3;
                                                                                    let _e5143 = local_18.member_1[0u];
                                                                                    if (_e5143[0] < 0.0lf) {
                                                                                        phi_14656_ = -(_e5143[0]);
                                                                                    } else {
                                                                                        phi_14656_ = _e5143[0];
                                                                                    }
                                                                                    let _e5150 = phi_14656_;
                                                                                    if (_e5143[1] < 0.0lf) {
                                                                                        phi_14663_ = -(_e5143[1]);
                                                                                    } else {
                                                                                        phi_14663_ = _e5143[1];
                                                                                    }
                                                                                    let _e5154 = phi_14663_;
                                                                                    if (_e5150 > _e5154) {
                                                                                        phi_14668_ = _e5150;
                                                                                    } else {
                                                                                        phi_14668_ = _e5154;
                                                                                    }
                                                                                    let _e5157 = phi_14668_;
                                                                                    if (_e5143[2] < 0.0lf) {
                                                                                        phi_14675_ = -(_e5143[2]);
                                                                                    } else {
                                                                                        phi_14675_ = _e5143[2];
                                                                                    }
                                                                                    let _e5161 = phi_14675_;
                                                                                    if (_e5157 > _e5161) {
                                                                                        phi_14680_ = _e5157;
                                                                                    } else {
                                                                                        phi_14680_ = _e5161;
                                                                                    }
                                                                                    let _e5164 = phi_14680_;
                                                                                    let _e5167 = local_18.member_1[1u];
                                                                                    if (_e5167[0] < 0.0lf) {
                                                                                        phi_14694_ = -(_e5167[0]);
                                                                                    } else {
                                                                                        phi_14694_ = _e5167[0];
                                                                                    }
                                                                                    let _e5174 = phi_14694_;
                                                                                    if (_e5167[1] < 0.0lf) {
                                                                                        phi_14701_ = -(_e5167[1]);
                                                                                    } else {
                                                                                        phi_14701_ = _e5167[1];
                                                                                    }
                                                                                    let _e5178 = phi_14701_;
                                                                                    if (_e5174 > _e5178) {
                                                                                        phi_14706_ = _e5174;
                                                                                    } else {
                                                                                        phi_14706_ = _e5178;
                                                                                    }
                                                                                    let _e5181 = phi_14706_;
                                                                                    if (_e5167[2] < 0.0lf) {
                                                                                        phi_14713_ = -(_e5167[2]);
                                                                                    } else {
                                                                                        phi_14713_ = _e5167[2];
                                                                                    }
                                                                                    let _e5185 = phi_14713_;
                                                                                    if (_e5181 > _e5185) {
                                                                                        phi_14718_ = _e5181;
                                                                                    } else {
                                                                                        phi_14718_ = _e5185;
                                                                                    }
                                                                                    let _e5188 = phi_14718_;
                                                                                    if (_e5164 > _e5188) {
                                                                                        phi_14723_ = _e5164;
                                                                                    } else {
                                                                                        phi_14723_ = _e5188;
                                                                                    }
                                                                                    let _e5191 = phi_14723_;
                                                                                    let _e5193 = local_18.member_3;
                                                                                    let _e5197 = local_18.member_2[0u];
                                                                                    if (_e5197[0] < 0.0lf) {
                                                                                        phi_14740_ = -(_e5197[0]);
                                                                                    } else {
                                                                                        phi_14740_ = _e5197[0];
                                                                                    }
                                                                                    let _e5204 = phi_14740_;
                                                                                    if (_e5197[1] < 0.0lf) {
                                                                                        phi_14747_ = -(_e5197[1]);
                                                                                    } else {
                                                                                        phi_14747_ = _e5197[1];
                                                                                    }
                                                                                    let _e5208 = phi_14747_;
                                                                                    if (_e5204 > _e5208) {
                                                                                        phi_14752_ = _e5204;
                                                                                    } else {
                                                                                        phi_14752_ = _e5208;
                                                                                    }
                                                                                    let _e5211 = phi_14752_;
                                                                                    if (_e5197[2] < 0.0lf) {
                                                                                        phi_14759_ = -(_e5197[2]);
                                                                                    } else {
                                                                                        phi_14759_ = _e5197[2];
                                                                                    }
                                                                                    let _e5215 = phi_14759_;
                                                                                    if (_e5211 > _e5215) {
                                                                                        phi_14764_ = _e5211;
                                                                                    } else {
                                                                                        phi_14764_ = _e5215;
                                                                                    }
                                                                                    let _e5218 = phi_14764_;
                                                                                    let _e5221 = local_18.member_2[1u];
                                                                                    if (_e5221[0] < 0.0lf) {
                                                                                        phi_14778_ = -(_e5221[0]);
                                                                                    } else {
                                                                                        phi_14778_ = _e5221[0];
                                                                                    }
                                                                                    let _e5228 = phi_14778_;
                                                                                    if (_e5221[1] < 0.0lf) {
                                                                                        phi_14785_ = -(_e5221[1]);
                                                                                    } else {
                                                                                        phi_14785_ = _e5221[1];
                                                                                    }
                                                                                    let _e5232 = phi_14785_;
                                                                                    if (_e5228 > _e5232) {
                                                                                        phi_14790_ = _e5228;
                                                                                    } else {
                                                                                        phi_14790_ = _e5232;
                                                                                    }
                                                                                    let _e5235 = phi_14790_;
                                                                                    if (_e5221[2] < 0.0lf) {
                                                                                        phi_14797_ = -(_e5221[2]);
                                                                                    } else {
                                                                                        phi_14797_ = _e5221[2];
                                                                                    }
                                                                                    let _e5239 = phi_14797_;
                                                                                    if (_e5235 > _e5239) {
                                                                                        phi_14802_ = _e5235;
                                                                                    } else {
                                                                                        phi_14802_ = _e5239;
                                                                                    }
                                                                                    let _e5242 = phi_14802_;
                                                                                    if (_e5218 > _e5242) {
                                                                                        phi_14807_ = _e5218;
                                                                                    } else {
                                                                                        phi_14807_ = _e5242;
                                                                                    }
                                                                                    let _e5245 = phi_14807_;
                                                                                    let _e5247 = local_18.member_3;
                                                                                    let _e5255 = local_18.member_3;
                                                                                    if (((_e5081 * (f64(1f) + (1.1102230246251565e-16lf * f64(8f)))) + (((((((_e5137 + _e5139) + (_e5191 + _e5193)) + (_e5245 + _e5247)) * (1.1102230246251565e-16lf * f64(16f))) + (_e5255 * f64(3f))) + (2.2250738585072014e-308lf * f64(256f))) * f64(4f))) <= _e666) {
                                                                                        phi_14831_ = false;
                                                                                    } else {
                                                                                        phi_14831_ = true;
                                                                                    }
                                                                                    let _e5267 = phi_14831_;
                                                                                    phi_14832_ = _e5267;
                                                                                } else {
                                                                                    phi_14832_ = true;
                                                                                }
                                                                                let _e5269 = phi_14832_;
                                                                                phi_14833_ = _e5269;
                                                                            } else {
                                                                                phi_14833_ = true;
                                                                            }
                                                                            let _e5271 = phi_14833_;
                                                                            if _e5271 {
                                                                                if _e4143 {
                                                                                    if _e4941 {
                                                                                        phi_14852_ = f64();
                                                                                        phi_14853_ = true;
                                                                                    } else {
                                                                                        if (_e4940 <= (_e4139 * f64(0.25f))) {
                                                                                            phi_14850_ = f64(0f);
                                                                                            phi_14851_ = false;
                                                                                        } else {
                                                                                            phi_14850_ = f64();
                                                                                            phi_14851_ = true;
                                                                                        }
                                                                                        let _e5278 = phi_14850_;
                                                                                        let _e5280 = phi_14851_;
                                                                                        phi_14852_ = _e5278;
                                                                                        phi_14853_ = _e5280;
                                                                                    }
                                                                                    let _e5282 = phi_14852_;
                                                                                    let _e5284 = phi_14853_;
                                                                                    if _e5284 {
                                                                                        phi_14858_ = (_e4468 + _e4468);
                                                                                    } else {
                                                                                        phi_14858_ = _e5282;
                                                                                    }
                                                                                    let _e5287 = phi_14858_;
                                                                                    phi_14860_ = _e5287;
                                                                                } else {
                                                                                    phi_14860_ = (_e3152.member_1 - _e4135);
                                                                                }
                                                                                let _e5289 = phi_14860_;
                                                                                phi_14861_ = _e5289;
                                                                                phi_14862_ = false;
                                                                            } else {
                                                                                phi_14861_ = f64();
                                                                                phi_14862_ = true;
                                                                            }
                                                                            let _e5291 = phi_14861_;
                                                                            let _e5293 = phi_14862_;
                                                                            phi_14863_ = _e5291;
                                                                            phi_14864_ = _e4940;
                                                                            phi_14865_ = _e5271;
                                                                            phi_14866_ = _e5293;
                                                                        }
                                                                        let _e5295 = phi_14863_;
                                                                        let _e5297 = phi_14864_;
                                                                        let _e5299 = phi_14865_;
                                                                        let _e5301 = phi_14866_;
                                                                        phi_14867_ = _e4938;
                                                                        phi_14868_ = _e5295;
                                                                        phi_14869_ = _e5297;
                                                                        phi_14870_ = _e4938;
                                                                        phi_14871_ = _e5299;
                                                                        phi_14872_ = _e4939;
                                                                        phi_14873_ = _e5301;
                                                                        phi_14874_ = false;
                                                                    } else {
                                                                        phi_14867_ = f64();
                                                                        phi_14868_ = f64();
                                                                        phi_14869_ = f64();
                                                                        phi_14870_ = f64();
                                                                        phi_14871_ = false;
                                                                        phi_14872_ = false;
                                                                        phi_14873_ = false;
                                                                        phi_14874_ = true;
                                                                    }
                                                                    let _e5303 = phi_14867_;
                                                                    let _e5305 = phi_14868_;
                                                                    let _e5307 = phi_14869_;
                                                                    let _e5309 = phi_14870_;
                                                                    let _e5311 = phi_14871_;
                                                                    let _e5313 = phi_14872_;
                                                                    let _e5315 = phi_14873_;
                                                                    let _e5317 = phi_14874_;
                                                                    phi_14875_ = _e5303;
                                                                    phi_14876_ = _e5305;
                                                                    phi_14877_ = _e5307;
                                                                    phi_14878_ = _e5309;
                                                                    phi_14879_ = false;
                                                                    phi_14880_ = _e5311;
                                                                    phi_14881_ = _e5313;
                                                                    phi_14882_ = _e5315;
                                                                    phi_14883_ = _e5317;
                                                                } else {
                                                                    phi_14875_ = f64();
                                                                    phi_14876_ = f64();
                                                                    phi_14877_ = f64();
                                                                    phi_14878_ = f64();
                                                                    phi_14879_ = true;
                                                                    phi_14880_ = false;
                                                                    phi_14881_ = false;
                                                                    phi_14882_ = false;
                                                                    phi_14883_ = false;
                                                                }
                                                                let _e5319 = phi_14875_;
                                                                let _e5321 = phi_14876_;
                                                                let _e5323 = phi_14877_;
                                                                let _e5325 = phi_14878_;
                                                                let _e5327 = phi_14879_;
                                                                let _e5329 = phi_14880_;
                                                                let _e5331 = phi_14881_;
                                                                let _e5333 = phi_14882_;
                                                                let _e5335 = phi_14883_;
                                                                phi_14884_ = _e5319;
                                                                phi_14885_ = _e5321;
                                                                phi_14886_ = _e5323;
                                                                phi_14887_ = _e5325;
                                                                phi_14888_ = _e5327;
                                                                phi_14889_ = _e5329;
                                                                phi_14890_ = _e5331;
                                                                phi_14891_ = _e5333;
                                                                phi_14892_ = _e5335;
                                                            } else {
                                                                phi_14884_ = f64();
                                                                phi_14885_ = f64();
                                                                phi_14886_ = f64();
                                                                phi_14887_ = f64();
                                                                phi_14888_ = true;
                                                                phi_14889_ = false;
                                                                phi_14890_ = false;
                                                                phi_14891_ = false;
                                                                phi_14892_ = false;
                                                            }
                                                            let _e5337 = phi_14884_;
                                                            let _e5339 = phi_14885_;
                                                            let _e5341 = phi_14886_;
                                                            let _e5343 = phi_14887_;
                                                            let _e5345 = phi_14888_;
                                                            let _e5347 = phi_14889_;
                                                            let _e5349 = phi_14890_;
                                                            let _e5351 = phi_14891_;
                                                            let _e5353 = phi_14892_;
                                                            if _e5345 {
                                                                if (_e4135 <= _e4137) {
                                                                    let _e5519 = (_e4145 + 1u);
                                                                    let _e5520 = (_e5519 > 3u);
                                                                    if _e5520 {
                                                                        phi_14905_ = false;
                                                                    } else {
                                                                        phi_14905_ = true;
                                                                    }
                                                                    let _e5522 = phi_14905_;
                                                                    phi_15232_ = _e5519;
                                                                    phi_15233_ = f64();
                                                                    phi_15234_ = false;
                                                                    phi_15235_ = _e5522;
                                                                    phi_15236_ = _e5520;
                                                                } else {
                                                                    let _e5357 = local.member[0u];
                                                                    let _e5360 = local.member_1[0u];
                                                                    let _e5363 = local.member[0u];
                                                                    let _e5369 = local.member_2[0u];
                                                                    let _e5370 = ((_e5357 + ((_e5360 - _e5363) * _e4141)) - _e5369);
                                                                    let _e5373 = local.member[1u];
                                                                    let _e5376 = local.member_1[1u];
                                                                    let _e5379 = local.member[1u];
                                                                    let _e5385 = local.member_2[1u];
                                                                    let _e5386 = ((_e5373 + ((_e5376 - _e5379) * _e4141)) - _e5385);
                                                                    if (_e5370 < _e5386) {
                                                                        phi_14978_ = _e5370;
                                                                    } else {
                                                                        phi_14978_ = _e5386;
                                                                    }
                                                                    let _e5389 = phi_14978_;
                                                                    let _e5392 = local.member[2u];
                                                                    let _e5395 = local.member_1[2u];
                                                                    let _e5398 = local.member[2u];
                                                                    let _e5404 = local.member_2[2u];
                                                                    let _e5405 = ((_e5392 + ((_e5395 - _e5398) * _e4141)) - _e5404);
                                                                    let _e5408 = local.member[3u];
                                                                    let _e5411 = local.member_1[3u];
                                                                    let _e5414 = local.member[3u];
                                                                    let _e5420 = local.member_2[3u];
                                                                    let _e5421 = ((_e5408 + ((_e5411 - _e5414) * _e4141)) - _e5420);
                                                                    if (_e5405 < _e5421) {
                                                                        phi_15051_ = _e5405;
                                                                    } else {
                                                                        phi_15051_ = _e5421;
                                                                    }
                                                                    let _e5424 = phi_15051_;
                                                                    if (_e5389 < _e5424) {
                                                                        phi_15056_ = _e5389;
                                                                    } else {
                                                                        phi_15056_ = _e5424;
                                                                    }
                                                                    let _e5427 = phi_15056_;
                                                                    let _e5430 = local_1.member[0u];
                                                                    let _e5433 = local_1.member_1[0u];
                                                                    let _e5436 = local_1.member[0u];
                                                                    let _e5442 = local_1.member_2[0u];
                                                                    let _e5443 = ((_e5430 + ((_e5433 - _e5436) * _e4135)) - _e5442);
                                                                    let _e5446 = local_1.member[1u];
                                                                    let _e5449 = local_1.member_1[1u];
                                                                    let _e5452 = local_1.member[1u];
                                                                    let _e5458 = local_1.member_2[1u];
                                                                    let _e5459 = ((_e5446 + ((_e5449 - _e5452) * _e4135)) - _e5458);
                                                                    if (_e5443 < _e5459) {
                                                                        phi_15129_ = _e5443;
                                                                    } else {
                                                                        phi_15129_ = _e5459;
                                                                    }
                                                                    let _e5462 = phi_15129_;
                                                                    let _e5465 = local_1.member[2u];
                                                                    let _e5468 = local_1.member_1[2u];
                                                                    let _e5471 = local_1.member[2u];
                                                                    let _e5477 = local_1.member_2[2u];
                                                                    let _e5478 = ((_e5465 + ((_e5468 - _e5471) * _e4135)) - _e5477);
                                                                    let _e5481 = local_1.member[3u];
                                                                    let _e5484 = local_1.member_1[3u];
                                                                    let _e5487 = local_1.member[3u];
                                                                    let _e5493 = local_1.member_2[3u];
                                                                    let _e5494 = ((_e5481 + ((_e5484 - _e5487) * _e4135)) - _e5493);
                                                                    if (_e5478 < _e5494) {
                                                                        phi_15202_ = _e5478;
                                                                    } else {
                                                                        phi_15202_ = _e5494;
                                                                    }
                                                                    let _e5497 = phi_15202_;
                                                                    if (_e5462 < _e5497) {
                                                                        phi_15207_ = _e5462;
                                                                    } else {
                                                                        phi_15207_ = _e5497;
                                                                    }
                                                                    let _e5500 = phi_15207_;
                                                                    let _e5501 = f64(0.0625f);
                                                                    let _e5503 = f64(0.9f);
                                                                    if (_e5500 > f64(0f)) {
                                                                        phi_15230_ = f64(0.5f);
                                                                    } else {
                                                                        let _e5509 = (f64(0.95f) * (_e5427 / (_e5427 - _e5500)));
                                                                        if (_e5509 > _e5501) {
                                                                            if (_e5509 < _e5503) {
                                                                                phi_15228_ = _e5509;
                                                                            } else {
                                                                                phi_15228_ = _e5503;
                                                                            }
                                                                            let _e5513 = phi_15228_;
                                                                            phi_15229_ = _e5513;
                                                                        } else {
                                                                            phi_15229_ = _e5501;
                                                                        }
                                                                        let _e5515 = phi_15229_;
                                                                        phi_15230_ = _e5515;
                                                                    }
                                                                    let _e5517 = phi_15230_;
                                                                    phi_15232_ = u32();
                                                                    phi_15233_ = (_e4468 * _e5517);
                                                                    phi_15234_ = true;
                                                                    phi_15235_ = false;
                                                                    phi_15236_ = false;
                                                                }
                                                                let _e5524 = phi_15232_;
                                                                let _e5526 = phi_15233_;
                                                                let _e5528 = phi_15234_;
                                                                let _e5530 = phi_15235_;
                                                                let _e5532 = phi_15236_;
                                                                phi_15237_ = _e5524;
                                                                phi_15238_ = _e4137;
                                                                phi_15239_ = _e5526;
                                                                phi_15240_ = _e4139;
                                                                phi_15241_ = _e4141;
                                                                phi_15242_ = _e4143;
                                                                phi_15243_ = _e4145;
                                                                phi_15244_ = _e5528;
                                                                phi_15245_ = _e5530;
                                                                phi_15246_ = _e5532;
                                                                phi_15247_ = false;
                                                                phi_15248_ = false;
                                                                phi_15249_ = false;
                                                            } else {
                                                                phi_15237_ = u32();
                                                                phi_15238_ = _e5337;
                                                                phi_15239_ = _e5339;
                                                                phi_15240_ = _e5341;
                                                                phi_15241_ = _e4135;
                                                                phi_15242_ = true;
                                                                phi_15243_ = 0u;
                                                                phi_15244_ = _e5347;
                                                                phi_15245_ = false;
                                                                phi_15246_ = false;
                                                                phi_15247_ = _e5349;
                                                                phi_15248_ = _e5351;
                                                                phi_15249_ = _e5353;
                                                            }
                                                            let _e5534 = phi_15237_;
                                                            let _e5536 = phi_15238_;
                                                            let _e5538 = phi_15239_;
                                                            let _e5540 = phi_15240_;
                                                            let _e5542 = phi_15241_;
                                                            let _e5544 = phi_15242_;
                                                            let _e5546 = phi_15243_;
                                                            let _e5548 = phi_15244_;
                                                            let _e5550 = phi_15245_;
                                                            let _e5552 = phi_15246_;
                                                            let _e5554 = phi_15247_;
                                                            let _e5556 = phi_15248_;
                                                            let _e5558 = phi_15249_;
                                                            if _e5548 {
                                                                let _e5559 = (_e5542 + _e5538);
                                                                if (_e5559 > _e5536) {
                                                                    phi_15258_ = _e5559;
                                                                } else {
                                                                    phi_15258_ = _e5536;
                                                                }
                                                                let _e5562 = phi_15258_;
                                                                if (_e5562 < _e3152.member_1) {
                                                                    phi_15263_ = _e5562;
                                                                } else {
                                                                    phi_15263_ = _e3152.member_1;
                                                                }
                                                                let _e5565 = phi_15263_;
                                                                if !(_e4143) {
                                                                    phi_15272_ = true;
                                                                } else {
                                                                    phi_15272_ = ((_e5565 - _e5542) > _e4124);
                                                                }
                                                                let _e5569 = phi_15272_;
                                                                if _e5569 {
                                                                    phi_15276_ = false;
                                                                } else {
                                                                    phi_15276_ = true;
                                                                }
                                                                let _e5571 = phi_15276_;
                                                                phi_15277_ = _e5565;
                                                                phi_15278_ = _e5536;
                                                                phi_15279_ = _e5540;
                                                                phi_15280_ = _e5542;
                                                                phi_15281_ = _e5544;
                                                                phi_15282_ = _e5546;
                                                                phi_15283_ = _e5569;
                                                                phi_15284_ = _e5571;
                                                                phi_15285_ = false;
                                                                phi_15286_ = false;
                                                                phi_15287_ = false;
                                                                phi_15288_ = false;
                                                            } else {
                                                                phi_15277_ = _e4135;
                                                                phi_15278_ = _e4137;
                                                                phi_15279_ = _e4139;
                                                                phi_15280_ = _e4141;
                                                                phi_15281_ = _e4143;
                                                                phi_15282_ = _e5534;
                                                                phi_15283_ = _e5550;
                                                                phi_15284_ = false;
                                                                phi_15285_ = _e5552;
                                                                phi_15286_ = _e5554;
                                                                phi_15287_ = _e5556;
                                                                phi_15288_ = _e5558;
                                                            }
                                                            let _e5573 = phi_15277_;
                                                            let _e5575 = phi_15278_;
                                                            let _e5577 = phi_15279_;
                                                            let _e5579 = phi_15280_;
                                                            let _e5581 = phi_15281_;
                                                            let _e5583 = phi_15282_;
                                                            let _e5585 = phi_15283_;
                                                            let _e5587 = phi_15284_;
                                                            let _e5589 = phi_15285_;
                                                            let _e5591 = phi_15286_;
                                                            let _e5593 = phi_15287_;
                                                            let _e5595 = phi_15288_;
                                                            phi_13067_ = _e5573;
                                                            phi_13069_ = _e5575;
                                                            phi_13071_ = _e5577;
                                                            phi_13073_ = _e5579;
                                                            phi_13075_ = _e5581;
                                                            phi_13077_ = _e5583;
                                                            phi_15289_ = _e5536;
                                                            phi_15290_ = _e5343;
                                                            phi_15291_ = _e5585;
                                                            phi_15292_ = _e5587;
                                                            phi_15293_ = _e5589;
                                                            phi_15294_ = _e5591;
                                                            phi_15295_ = _e5593;
                                                            phi_15296_ = false;
                                                            phi_15297_ = _e5595;
                                                        } else {
                                                            phi_13067_ = f64();
                                                            phi_13069_ = f64();
                                                            phi_13071_ = f64();
                                                            phi_13073_ = f64();
                                                            phi_13075_ = bool();
                                                            phi_13077_ = u32();
                                                            phi_15289_ = f64();
                                                            phi_15290_ = f64();
                                                            phi_15291_ = false;
                                                            phi_15292_ = false;
                                                            phi_15293_ = false;
                                                            phi_15294_ = false;
                                                            phi_15295_ = false;
                                                            phi_15296_ = true;
                                                            phi_15297_ = false;
                                                        }
                                                        let _e5597 = phi_13067_;
                                                        let _e5599 = phi_13069_;
                                                        let _e5601 = phi_13071_;
                                                        let _e5603 = phi_13073_;
                                                        let _e5605 = phi_13075_;
                                                        let _e5607 = phi_13077_;
                                                        let _e5609 = phi_15289_;
                                                        let _e5611 = phi_15290_;
                                                        let _e5613 = phi_15291_;
                                                        let _e5615 = phi_15292_;
                                                        let _e5617 = phi_15293_;
                                                        let _e5619 = phi_15294_;
                                                        let _e5621 = phi_15295_;
                                                        let _e5623 = phi_15296_;
                                                        let _e5625 = phi_15297_;
                                                        local_30 = _e5615;
                                                        local_70 = _e5617;
                                                        local_71 = _e5619;
                                                        local_72 = _e5621;
                                                        local_73 = _e5623;
                                                        local_74 = _e5625;
                                                        local_75 = _e5615;
                                                        local_76 = _e5611;
                                                        local_77 = _e5609;
                                                        continue;
                                                        continuing {
                                                            phi_13063_ = _e4157;
                                                            phi_13066_ = _e5597;
                                                            phi_13068_ = _e5599;
                                                            phi_13070_ = _e5601;
                                                            phi_13072_ = _e5603;
                                                            phi_13074_ = _e5605;
                                                            phi_13076_ = _e5607;
                                                            break if !(_e5613);
                                                        }
                                                    }
                                                    let _e5628 = local_30;
                                                    if _e5628 {
                                                        phi_15301_ = false;
                                                        phi_15302_ = false;
                                                        phi_15303_ = false;
                                                        phi_15304_ = false;
                                                        phi_15305_ = false;
                                                    } else {
                                                        let _e11368 = local_70;
                                                        phi_15301_ = _e11368;
                                                        let _e11371 = local_71;
                                                        phi_15302_ = _e11371;
                                                        let _e11374 = local_72;
                                                        phi_15303_ = _e11374;
                                                        let _e11377 = local_73;
                                                        phi_15304_ = _e11377;
                                                        let _e11380 = local_74;
                                                        phi_15305_ = _e11380;
                                                    }
                                                    let _e5630 = phi_15301_;
                                                    let _e5632 = phi_15302_;
                                                    let _e5634 = phi_15303_;
                                                    let _e5636 = phi_15304_;
                                                    let _e5638 = phi_15305_;
                                                    if _e5630 {
                                                        let _e5640 = local_31;
                                                        phi_15310_ = type_46(1u, _e5640);
                                                        phi_15311_ = false;
                                                        phi_15312_ = false;
                                                        phi_15313_ = false;
                                                        phi_15314_ = false;
                                                        phi_15315_ = false;
                                                    } else {
                                                        phi_15310_ = type_46();
                                                        phi_15311_ = _e5632;
                                                        phi_15312_ = _e5634;
                                                        let _e11387 = local_75;
                                                        phi_15313_ = _e11387;
                                                        phi_15314_ = _e5636;
                                                        phi_15315_ = _e5638;
                                                    }
                                                    let _e5643 = phi_15310_;
                                                    let _e5645 = phi_15311_;
                                                    let _e5647 = phi_15312_;
                                                    let _e5649 = phi_15313_;
                                                    let _e5651 = phi_15314_;
                                                    let _e5653 = phi_15315_;
                                                    if _e5645 {
                                                        phi_15320_ = type_46(0u, type_46().member_1);
                                                        phi_15321_ = false;
                                                        phi_15322_ = false;
                                                        phi_15323_ = false;
                                                        phi_15324_ = false;
                                                        phi_15325_ = true;
                                                    } else {
                                                        phi_15320_ = _e5643;
                                                        phi_15321_ = _e5647;
                                                        phi_15322_ = _e5649;
                                                        phi_15323_ = _e5651;
                                                        phi_15324_ = _e5653;
                                                        phi_15325_ = _e5630;
                                                    }
                                                    let _e5657 = phi_15320_;
                                                    let _e5659 = phi_15321_;
                                                    let _e5661 = phi_15322_;
                                                    let _e5663 = phi_15323_;
                                                    let _e5665 = phi_15324_;
                                                    let _e5667 = phi_15325_;
                                                    if _e5659 {
                                                        let _e11398 = local_76;
                                                        phi_15329_ = _e11398;
                                                        phi_15330_ = true;
                                                        phi_15331_ = false;
                                                        phi_15332_ = false;
                                                        phi_15333_ = false;
                                                    } else {
                                                        let _e11400 = local_77;
                                                        phi_15329_ = _e11400;
                                                        phi_15330_ = _e5661;
                                                        phi_15331_ = _e5663;
                                                        phi_15332_ = _e5665;
                                                        phi_15333_ = _e5667;
                                                    }
                                                    let _e5669 = phi_15329_;
                                                    let _e5671 = phi_15330_;
                                                    let _e5673 = phi_15331_;
                                                    let _e5675 = phi_15332_;
                                                    let _e5677 = phi_15333_;
                                                    if _e5671 {
                                                        phi_15337_ = _e5669;
                                                        phi_15338_ = true;
                                                        phi_15339_ = false;
                                                        phi_15340_ = false;
                                                    } else {
                                                        let _e11407 = local_78;
                                                        phi_15337_ = _e11407;
                                                        phi_15338_ = _e5673;
                                                        phi_15339_ = _e5675;
                                                        phi_15340_ = _e5677;
                                                    }
                                                    let _e5679 = phi_15337_;
                                                    let _e5681 = phi_15338_;
                                                    let _e5683 = phi_15339_;
                                                    let _e5685 = phi_15340_;
                                                    if _e5681 {
                                                        phi_15345_ = type_46(1u, _e5679);
                                                        phi_15346_ = false;
                                                        phi_15347_ = false;
                                                    } else {
                                                        phi_15345_ = type_46();
                                                        phi_15346_ = _e5683;
                                                        phi_15347_ = _e5685;
                                                    }
                                                    let _e5688 = phi_15345_;
                                                    let _e5690 = phi_15346_;
                                                    let _e5692 = phi_15347_;
                                                    if _e5690 {
                                                        phi_15352_ = type_46(0u, type_46().member_1);
                                                        phi_15353_ = true;
                                                    } else {
                                                        phi_15352_ = _e5657;
                                                        phi_15353_ = _e5692;
                                                    }
                                                    let _e5696 = phi_15352_;
                                                    let _e5698 = phi_15353_;
                                                    if _e5698 {
                                                        phi_15357_ = _e5696;
                                                    } else {
                                                        phi_15357_ = _e5688;
                                                    }
                                                    let _e5700 = phi_15357_;
                                                    let _e5703 = (_e5700.member != 0u);
                                                    if _e5703 {
                                                        phi_15364_ = false;
                                                    } else {
                                                        phi_15364_ = true;
                                                    }
                                                    let _e5705 = phi_15364_;
                                                    phi_15365_ = _e5700.member_1;
                                                    phi_15366_ = _e5705;
                                                    phi_15367_ = _e5703;
                                                    phi_15368_ = false;
                                                } else {
                                                    phi_15365_ = f64();
                                                    phi_15366_ = false;
                                                    phi_15367_ = false;
                                                    phi_15368_ = true;
                                                }
                                                let _e5707 = phi_15365_;
                                                let _e5709 = phi_15366_;
                                                let _e5711 = phi_15367_;
                                                let _e5713 = phi_15368_;
                                                phi_15369_ = _e3881;
                                                phi_15370_ = _e3883;
                                                phi_15371_ = _e5707;
                                                phi_15372_ = _e5709;
                                                phi_15373_ = _e5711;
                                                phi_15374_ = _e5713;
                                            }
                                            let _e5715 = phi_15369_;
                                            let _e5717 = phi_15370_;
                                            let _e5719 = phi_15371_;
                                            let _e5721 = phi_15372_;
                                            let _e5723 = phi_15373_;
                                            let _e5725 = phi_15374_;
                                            phi_15375_ = _e5715;
                                            phi_15376_ = _e5717;
                                            phi_15377_ = _e5719;
                                            phi_15378_ = _e3877;
                                            phi_15379_ = _e5721;
                                            phi_15380_ = _e5723;
                                            phi_15381_ = _e5725;
                                        }
                                        let _e5727 = phi_15375_;
                                        let _e5729 = phi_15376_;
                                        let _e5731 = phi_15377_;
                                        let _e5733 = phi_15378_;
                                        let _e5735 = phi_15379_;
                                        let _e5737 = phi_15380_;
                                        let _e5739 = phi_15381_;
                                        if _e5733 {
                                            phi_15385_ = false;
                                            phi_15386_ = false;
                                            phi_15387_ = false;
                                        } else {
                                            phi_15385_ = _e5735;
                                            phi_15386_ = _e5737;
                                            phi_15387_ = _e5739;
                                        }
                                        let _e5741 = phi_15385_;
                                        let _e5743 = phi_15386_;
                                        let _e5745 = phi_15387_;
                                        phi_15388_ = _e3152;
                                        phi_15389_ = _e5727;
                                        phi_15390_ = _e5729;
                                        phi_15391_ = _e5731;
                                        phi_15392_ = _e3152;
                                        phi_15393_ = _e5733;
                                        phi_15394_ = _e5741;
                                        phi_15395_ = _e5743;
                                        phi_15396_ = _e5745;
                                    } else {
                                        phi_15388_ = type_49();
                                        phi_15389_ = bool();
                                        phi_15390_ = f64();
                                        phi_15391_ = f64();
                                        phi_15392_ = type_49();
                                        phi_15393_ = true;
                                        phi_15394_ = false;
                                        phi_15395_ = false;
                                        phi_15396_ = false;
                                    }
                                    let _e5747 = phi_15388_;
                                    let _e5749 = phi_15389_;
                                    let _e5751 = phi_15390_;
                                    let _e5753 = phi_15391_;
                                    let _e5755 = phi_15392_;
                                    let _e5757 = phi_15393_;
                                    let _e5759 = phi_15394_;
                                    let _e5761 = phi_15395_;
                                    let _e5763 = phi_15396_;
                                    if _e5757 {
                                        phi_15400_ = true;
                                        phi_15401_ = false;
                                        phi_15402_ = false;
                                    } else {
                                        phi_15400_ = _e5759;
                                        phi_15401_ = _e5761;
                                        phi_15402_ = _e5763;
                                    }
                                    let _e5765 = phi_15400_;
                                    let _e5767 = phi_15401_;
                                    let _e5769 = phi_15402_;
                                    phi_15403_ = _e5747;
                                    phi_15404_ = _e5749;
                                    phi_15405_ = _e5751;
                                    phi_15406_ = _e5753;
                                    phi_15407_ = _e5755;
                                    phi_15408_ = _e5765;
                                    phi_15409_ = false;
                                    phi_15410_ = _e5767;
                                    phi_15411_ = _e5769;
                                } else {
                                    phi_15403_ = type_49();
                                    phi_15404_ = bool();
                                    phi_15405_ = f64();
                                    phi_15406_ = f64();
                                    phi_15407_ = type_49();
                                    phi_15408_ = false;
                                    phi_15409_ = true;
                                    phi_15410_ = false;
                                    phi_15411_ = false;
                                }
                                let _e5771 = phi_15403_;
                                let _e5773 = phi_15404_;
                                let _e5775 = phi_15405_;
                                let _e5777 = phi_15406_;
                                let _e5779 = phi_15407_;
                                let _e5781 = phi_15408_;
                                let _e5783 = phi_15409_;
                                let _e5785 = phi_15410_;
                                let _e5787 = phi_15411_;
                                local_32 = _e5783;
                                local_79 = _e5785;
                                local_80 = _e5787;
                                local_33 = _e5773;
                                local_34 = _e5771;
                                local_35 = _e5777;
                                local_36 = _e5775;
                                local_37 = _e5777;
                                local_38 = _e5777;
                                local_39 = _e5779;
                                continue;
                                continuing {
                                    phi_11125_ = _e2860;
                                    break if !(_e5781);
                                }
                            }
                            let _e5790 = local_32;
                            if _e5790 {
                                phi_15416_ = type_46(0u, type_46().member_1);
                                phi_15417_ = false;
                                phi_15418_ = false;
                            } else {
                                phi_15416_ = type_46();
                                let _e11463 = local_79;
                                phi_15417_ = _e11463;
                                let _e11466 = local_80;
                                phi_15418_ = _e11466;
                            }
                            let _e5794 = phi_15416_;
                            let _e5796 = phi_15417_;
                            let _e5798 = phi_15418_;
                            if _e5796 {
                                let _e5800 = local_33;
                                if _e5800 {
                                    let _e5802 = local_34;
                                    let _e5805 = local_35;
                                    let _e5808 = local_36;
                                    if ((_e5802.member_1 - _e5805) <= _e5808) {
                                        let _e5811 = local_37;
                                        phi_15432_ = type_46(1u, _e5811);
                                        phi_15433_ = false;
                                    } else {
                                        phi_15432_ = type_46();
                                        phi_15433_ = true;
                                    }
                                    let _e5814 = phi_15432_;
                                    let _e5816 = phi_15433_;
                                    phi_15434_ = _e5814;
                                    phi_15435_ = _e5816;
                                } else {
                                    phi_15434_ = type_46();
                                    phi_15435_ = true;
                                }
                                let _e5818 = phi_15434_;
                                let _e5820 = phi_15435_;
                                if _e5820 {
                                    let _e5822 = local_38;
                                    phi_15440_ = type_46(2u, _e5822);
                                } else {
                                    phi_15440_ = _e5818;
                                }
                                let _e5825 = phi_15440_;
                                phi_15441_ = _e5825;
                                phi_15442_ = false;
                            } else {
                                phi_15441_ = type_46();
                                phi_15442_ = _e5798;
                            }
                            let _e5827 = phi_15441_;
                            let _e5829 = phi_15442_;
                            if _e5829 {
                                let _e5831 = local_39;
                                phi_15448_ = type_46(1u, _e5831.member);
                                phi_15449_ = true;
                            } else {
                                phi_15448_ = _e5827;
                                phi_15449_ = _e5796;
                            }
                            let _e5835 = phi_15448_;
                            let _e5837 = phi_15449_;
                            phi_15453_ = _e5835;
                            phi_15454_ = _e5794;
                            phi_15455_ = _e5837;
                        } else {
                            phi_15453_ = _e2704;
                            phi_15454_ = type_46();
                            phi_15455_ = true;
                        }
                        let _e5839 = phi_15453_;
                        let _e5841 = phi_15454_;
                        let _e5843 = phi_15455_;
                        phi_15459_ = _e5839;
                        phi_15460_ = _e5841;
                        phi_15461_ = _e5843;
                    }
                    let _e5847 = phi_15459_;
                    let _e5849 = phi_15460_;
                    let _e5851 = phi_15461_;
                    if _e5851 {
                        phi_15465_ = _e5847;
                    } else {
                        phi_15465_ = _e5849;
                    }
                    let _e5853 = phi_15465_;
                    if (_e5853.member == 1u) {
                        if (_e5853.member_1 > _e413) {
                            phi_15476_ = false;
                        } else {
                            phi_15476_ = true;
                        }
                        let _e5859 = phi_15476_;
                        phi_15477_ = _e5859;
                    } else {
                        phi_15477_ = true;
                    }
                    let _e5861 = phi_15477_;
                    if _e5861 {
                        phi_15481_ = false;
                    } else {
                        phi_15481_ = true;
                    }
                    let _e5863 = phi_15481_;
                    if _e5863 {
                        phi_15485_ = 1u;
                    } else {
                        phi_15485_ = 0u;
                    }
                    let _e5865 = phi_15485_;
                    phi_15489_ = type_47(_e5853, _e5865);
                }
                let _e10493 = phi_15489_;
                switch bitcast<i32>(_e10493.member.member) {
                    case 0: {
                        phi_15504_ = type_37(0u, _e10493.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e10504 = function_1(_e10493.member.member_1);
                        phi_15504_ = type_37(0u, _e10493.member_1, _e10504, true);
                        break;
                    }
                    case 2: {
                        let _e10500 = function_1(_e10493.member.member_1);
                        phi_15504_ = type_37(1u, _e10493.member_1, _e10500, true);
                        break;
                    }
                    default: {
                        phi_15504_ = type_37();
                        break;
                    }
                }
                let _e10508 = phi_15504_;
                if _e10508.member_3 {
                    let _e10516 = (_e10508.member_2[1] >> bitcast<u32>(20i));
                    if (_e10516 <= 896u) {
                        phi_15528_ = 0u;
                    } else {
                        phi_15528_ = ((((_e10516 - 896u) << bitcast<u32>(23i)) | ((_e10508.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e10508.member_2[0] >> bitcast<u32>(29i)));
                    }
                    let _e10531 = phi_15528_;
                    let _e10533 = atomicMin((&earliest.member[0u]), _e10531);
                }
                phi_15532_ = type_22(1u, _e10508.member, _e195, _e198, _e10508.member_2, _e10508.member_1);
                phi_15533_ = _e10508.member_3;
            } else {
                phi_15532_ = type_22(1u, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_15533_ = false;
            }
            let _e10535 = phi_15532_;
            let _e10537 = phi_15533_;
            let _e10540 = params.member.member.member_1;
            if ((_e10540 & 16u) != 0u) {
                if (_e124 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e10537 {
                    let _e10546 = atomicAdd((&counters[0u]), 1u);
                    phi_15552_ = _e10546;
                } else {
                    phi_15552_ = 0u;
                }
                let _e10548 = phi_15552_;
                workgroupBarrier();
                if (_e124 == 0u) {
                    let _e10551 = atomicLoad((&counters[0u]));
                    if (_e10551 > 0u) {
                        let _e10554 = atomicAdd((&contacts.member[0u]), _e10551);
                        atomicStore((&counters[1u]), _e10554);
                    }
                }
                workgroupBarrier();
                let _e10557 = atomicLoad((&counters[1u]));
                let _e10558 = (_e10557 + _e10548);
                if _e10537 {
                    let _e10561 = params.member.member_1.member_3;
                    if (_e10558 < _e10561) {
                        let _e10563 = (7u * _e10558);
                        atomicStore((&contacts.member[(4u + _e10563)]), _e10535.member);
                        atomicStore((&contacts.member[(_e10563 + 5u)]), _e10535.member_1);
                        atomicStore((&contacts.member[(_e10563 + 6u)]), _e10535.member_2);
                        atomicStore((&contacts.member[(_e10563 + 7u)]), _e10535.member_3);
                        atomicStore((&contacts.member[(_e10563 + 8u)]), _e10535.member_4[0]);
                        atomicStore((&contacts.member[(_e10563 + 9u)]), _e10535.member_4[1]);
                        atomicStore((&contacts.member[(_e10563 + 10u)]), _e10535.member_5);
                    }
                }
            }
        }
        continue;
        continuing {
            phi_315_ = _e180;
            break if !(_e186);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_edge_edge_wide(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_5(id, n, lane);
}
