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

struct type_22 {
    member: array<array<u32, 2>>,
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
}

struct type_28 {
    member: type_7,
    member_1: type_8,
    member_2: type_27,
}

struct type_29 {
    member: type_28,
}

struct type_30 {
    member: u32,
    member_1: f32,
}

struct type_32 {
    member: array<f32, 4>,
    member_1: array<f32, 4>,
    member_2: array<f32, 4>,
}

struct type_33 {
    member: f32,
    member_1: f32,
}

struct type_37 {
    member: array<array<array<f32, 3>, 4>, 2>,
    member_1: f32,
    member_2: f32,
}

struct type_38 {
    member: type_25,
    member_1: f32,
}

struct type_39 {
    member: type_30,
    member_1: u32,
}

struct type_40 {
    member: u32,
    member_1: f32,
    member_2: f32,
}

struct type_41 {
    member: f32,
    member_1: f32,
    member_2: bool,
}

struct type_42 {
    member: u32,
    member_1: u32,
    member_2: array<u32, 2>,
    member_3: bool,
}

struct type_46 {
    member: array<atomic<u32>>,
}

@group(0) @binding(1) 
var<storage> paths: type_19;
@group(0) @binding(3) 
var<storage> input: type_10;
var<workgroup> counters: array<atomic<u32>, 4>;
@group(0) @binding(0) 
var<storage> params: type_29;
@group(0) @binding(2) 
var<storage> elements: type_22;
@group(0) @binding(4) 
var<storage, read_write> contacts: type_46;
@group(0) @binding(5) 
var<storage, read_write> undecided: type_46;
@group(0) @binding(6) 
var<storage, read_write> earliest: type_46;

fn function_(param: f32) -> array<u32, 2> {
    var phi_15801_: array<u32, 2>;
    var phi_15802_: array<u32, 2>;
    var phi_15803_: bool;
    var phi_15807_: array<u32, 2>;

    let _e13 = bitcast<u32>(param);
    if (_e13 < 8388608u) {
        phi_15802_ = array<u32, 2>();
        phi_15803_ = true;
    } else {
        let _e17 = ((_e13 >> bitcast<u32>(31i)) == 1u);
        if _e17 {
            phi_15801_ = array<u32, 2>();
        } else {
            phi_15801_ = array<u32, 2>((_e13 << bitcast<u32>(29i)), ((((_e13 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e13 & 8388607u) >> bitcast<u32>(3i))));
        }
        let _e31 = phi_15801_;
        phi_15802_ = _e31;
        phi_15803_ = _e17;
    }
    let _e33 = phi_15802_;
    let _e35 = phi_15803_;
    if _e35 {
        phi_15807_ = array<u32, 2>(0u, 0u);
    } else {
        phi_15807_ = _e33;
    }
    let _e37 = phi_15807_;
    return _e37;
}

fn function_1(param_1: array<f32, 3>, param_2: array<f32, 3>) -> array<f32, 3> {
    var phi_15780_: array<f32, 3>;

    if ((((param_2[0] * param_2[0]) + (param_2[1] * param_2[1])) + (param_2[2] * param_2[2])) < (((param_1[0] * param_1[0]) + (param_1[1] * param_1[1])) + (param_1[2] * param_1[2]))) {
        phi_15780_ = param_2;
    } else {
        phi_15780_ = param_1;
    }
    let _e26 = phi_15780_;
    return _e26;
}

fn function_2(param_3: array<f32, 3>, param_4: array<f32, 3>, param_5: array<f32, 3>, param_6: u32) -> array<f32, 3> {
    var phi_15641_: f32;
    var phi_15642_: f32;
    var phi_15681_: f32;
    var phi_15682_: f32;
    var phi_15727_: f32;
    var phi_15728_: f32;
    var phi_15462_: f32;
    var phi_15463_: f32;
    var phi_15508_: f32;
    var phi_15509_: f32;
    var phi_15551_: f32;
    var phi_15552_: f32;
    var phi_15600_: f32;
    var phi_15601_: f32;
    var phi_15743_: array<array<f32, 3>, 4>;

    let _e9 = (param_3[0] - param_4[0]);
    let _e12 = (param_3[1] - param_4[1]);
    let _e15 = (param_3[2] - param_4[2]);
    if (param_6 != 0u) {
        let _e157 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e157 > 0f) {
            if (_e157 < 1f) {
                phi_15462_ = _e157;
            } else {
                phi_15462_ = 1f;
            }
            let _e161 = phi_15462_;
            phi_15463_ = _e161;
        } else {
            phi_15463_ = 0f;
        }
        let _e163 = phi_15463_;
        let _e199 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e199 > 0f) {
            if (_e199 < 1f) {
                phi_15508_ = _e199;
            } else {
                phi_15508_ = 1f;
            }
            let _e203 = phi_15508_;
            phi_15509_ = _e203;
        } else {
            phi_15509_ = 0f;
        }
        let _e205 = phi_15509_;
        let _e238 = ((((_e9 * param_5[0]) + (_e12 * param_5[1])) + (_e15 * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e238 > 0f) {
            if (_e238 < 1f) {
                phi_15551_ = _e238;
            } else {
                phi_15551_ = 1f;
            }
            let _e242 = phi_15551_;
            phi_15552_ = _e242;
        } else {
            phi_15552_ = 0f;
        }
        let _e244 = phi_15552_;
        let _e257 = (param_3[0] - param_5[0]);
        let _e260 = (param_3[1] - param_5[1]);
        let _e263 = (param_3[2] - param_5[2]);
        let _e283 = ((((_e257 * param_4[0]) + (_e260 * param_4[1])) + (_e263 * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e283 > 0f) {
            if (_e283 < 1f) {
                phi_15600_ = _e283;
            } else {
                phi_15600_ = 1f;
            }
            let _e287 = phi_15600_;
            phi_15601_ = _e287;
        } else {
            phi_15601_ = 0f;
        }
        let _e289 = phi_15601_;
        phi_15743_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e163)), (param_3[1] - (param_4[1] * _e163)), (param_3[2] - (param_4[2] * _e163))), array<f32, 3>((param_3[0] - (param_5[0] * _e205)), (param_3[1] - (param_5[1] * _e205)), (param_3[2] - (param_5[2] * _e205))), array<f32, 3>((_e9 - (param_5[0] * _e244)), (_e12 - (param_5[1] * _e244)), (_e15 - (param_5[2] * _e244))), array<f32, 3>((_e257 - (param_4[0] * _e289)), (_e260 - (param_4[1] * _e289)), (_e263 - (param_4[2] * _e289))));
    } else {
        let _e19 = (param_5[0] - param_4[0]);
        let _e22 = (param_5[1] - param_4[1]);
        let _e25 = (param_5[2] - param_4[2]);
        let _e36 = ((((_e9 * _e19) + (_e12 * _e22)) + (_e15 * _e25)) / (((_e19 * _e19) + (_e22 * _e22)) + (_e25 * _e25)));
        if (_e36 > 0f) {
            if (_e36 < 1f) {
                phi_15641_ = _e36;
            } else {
                phi_15641_ = 1f;
            }
            let _e40 = phi_15641_;
            phi_15642_ = _e40;
        } else {
            phi_15642_ = 0f;
        }
        let _e42 = phi_15642_;
        let _e49 = array<f32, 3>((_e9 - (_e19 * _e42)), (_e12 - (_e22 * _e42)), (_e15 - (_e25 * _e42)));
        let _e72 = ((((param_3[0] * param_4[0]) + (param_3[1] * param_4[1])) + (param_3[2] * param_4[2])) / (((param_4[0] * param_4[0]) + (param_4[1] * param_4[1])) + (param_4[2] * param_4[2])));
        if (_e72 > 0f) {
            if (_e72 < 1f) {
                phi_15681_ = _e72;
            } else {
                phi_15681_ = 1f;
            }
            let _e76 = phi_15681_;
            phi_15682_ = _e76;
        } else {
            phi_15682_ = 0f;
        }
        let _e78 = phi_15682_;
        let _e114 = ((((param_3[0] * param_5[0]) + (param_3[1] * param_5[1])) + (param_3[2] * param_5[2])) / (((param_5[0] * param_5[0]) + (param_5[1] * param_5[1])) + (param_5[2] * param_5[2])));
        if (_e114 > 0f) {
            if (_e114 < 1f) {
                phi_15727_ = _e114;
            } else {
                phi_15727_ = 1f;
            }
            let _e118 = phi_15727_;
            phi_15728_ = _e118;
        } else {
            phi_15728_ = 0f;
        }
        let _e120 = phi_15728_;
        phi_15743_ = array<array<f32, 3>, 4>(array<f32, 3>((param_3[0] - (param_4[0] * _e78)), (param_3[1] - (param_4[1] * _e78)), (param_3[2] - (param_4[2] * _e78))), array<f32, 3>((param_3[0] - (param_5[0] * _e120)), (param_3[1] - (param_5[1] * _e120)), (param_3[2] - (param_5[2] * _e120))), _e49, _e49);
    }
    let _e302 = phi_15743_;
    let _e305 = function_1(_e302[0], _e302[1]);
    let _e307 = function_1(_e305, _e302[2]);
    let _e309 = function_1(_e307, _e302[3]);
    return _e309;
}

fn function_3(param_7: array<f32, 3>, param_8: array<f32, 3>, param_9: array<f32, 3>, param_10: u32) -> array<f32, 3> {
    var phi_15363_: bool;
    var phi_15364_: bool;
    var phi_15365_: bool;
    var phi_15366_: bool;
    var phi_15370_: bool;
    var phi_15343_: bool;
    var phi_15344_: bool;
    var phi_15345_: bool;
    var phi_15346_: bool;
    var phi_15347_: bool;
    var phi_15348_: bool;
    var phi_15352_: bool;
    var phi_15371_: bool;
    var phi_15404_: array<f32, 3>;
    var phi_15405_: bool;
    var phi_15406_: array<f32, 3>;
    var phi_15407_: bool;
    var phi_15412_: array<f32, 3>;

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
                    phi_15343_ = (_e78 <= 1f);
                    phi_15344_ = false;
                } else {
                    phi_15343_ = bool();
                    phi_15344_ = true;
                }
                let _e99 = phi_15343_;
                let _e101 = phi_15344_;
                phi_15345_ = _e99;
                phi_15346_ = _e101;
            } else {
                phi_15345_ = bool();
                phi_15346_ = true;
            }
            let _e103 = phi_15345_;
            let _e105 = phi_15346_;
            phi_15347_ = _e103;
            phi_15348_ = _e105;
        } else {
            phi_15347_ = bool();
            phi_15348_ = true;
        }
        let _e107 = phi_15347_;
        let _e109 = phi_15348_;
        if _e109 {
            phi_15352_ = false;
        } else {
            phi_15352_ = _e107;
        }
        let _e111 = phi_15352_;
        phi_15371_ = _e111;
    } else {
        if (_e74 >= 0f) {
            if (_e78 >= 0f) {
                phi_15363_ = ((_e74 + _e78) <= 1f);
                phi_15364_ = false;
            } else {
                phi_15363_ = bool();
                phi_15364_ = true;
            }
            let _e85 = phi_15363_;
            let _e87 = phi_15364_;
            phi_15365_ = _e85;
            phi_15366_ = _e87;
        } else {
            phi_15365_ = bool();
            phi_15366_ = true;
        }
        let _e89 = phi_15365_;
        let _e91 = phi_15366_;
        if _e91 {
            phi_15370_ = false;
        } else {
            phi_15370_ = _e89;
        }
        let _e93 = phi_15370_;
        phi_15371_ = _e93;
    }
    let _e113 = phi_15371_;
    if (_e70 > ((_e23 * _e45) * (0.000000059604645f * 64f))) {
        if _e113 {
            phi_15404_ = array<f32, 3>((param_7[0] - ((param_8[0] * _e74) + (param_9[0] * _e78))), (param_7[1] - ((param_8[1] * _e74) + (param_9[1] * _e78))), (param_7[2] - ((param_8[2] * _e74) + (param_9[2] * _e78))));
            phi_15405_ = false;
        } else {
            phi_15404_ = array<f32, 3>();
            phi_15405_ = true;
        }
        let _e141 = phi_15404_;
        let _e143 = phi_15405_;
        phi_15406_ = _e141;
        phi_15407_ = _e143;
    } else {
        phi_15406_ = array<f32, 3>();
        phi_15407_ = true;
    }
    let _e145 = phi_15406_;
    let _e147 = phi_15407_;
    if _e147 {
        let _e148 = function_2(param_7, param_8, param_9, param_10);
        phi_15412_ = _e148;
    } else {
        phi_15412_ = _e145;
    }
    let _e150 = phi_15412_;
    return _e150;
}

fn function_4(id_1: vec3<u32>, n_1: vec3<u32>, lane_1: u32) {
    var local: type_32;
    var local_1: type_32;
    var local_2: type_26;
    var local_3: type_26;
    var local_4: type_26;
    var local_5: array<type_33, 4>;
    var local_6: array<f32, 4>;
    var local_7: array<f32, 2>;
    var local_8: type_32;
    var local_9: type_32;
    var local_10: type_32;
    var local_11: type_32;
    var local_12: array<f32, 4>;
    var local_13: array<f32, 3>;
    var local_14: type_37;
    var local_15: type_32;
    var local_16: type_32;
    var local_17: type_32;
    var local_18: type_25;
    var phi_250_: u32;
    var phi_266_: u32;
    var phi_287_: u32;
    var phi_288_: u32;
    var phi_291_: type_12;
    var phi_292_: type_12;
    var phi_315_: type_12;
    var phi_500_: f32;
    var phi_506_: f32;
    var phi_511_: f32;
    var phi_517_: f32;
    var phi_522_: f32;
    var phi_528_: f32;
    var phi_534_: f32;
    var phi_539_: f32;
    var phi_545_: f32;
    var phi_550_: f32;
    var phi_555_: f32;
    var phi_562_: f32;
    var phi_568_: f32;
    var phi_573_: f32;
    var phi_579_: f32;
    var phi_584_: f32;
    var phi_590_: f32;
    var phi_596_: f32;
    var phi_601_: f32;
    var phi_607_: f32;
    var phi_612_: f32;
    var phi_617_: f32;
    var phi_624_: f32;
    var phi_630_: f32;
    var phi_635_: f32;
    var phi_641_: f32;
    var phi_646_: f32;
    var phi_652_: f32;
    var phi_658_: f32;
    var phi_663_: f32;
    var phi_669_: f32;
    var phi_674_: f32;
    var phi_679_: f32;
    var phi_685_: f32;
    var phi_690_: f32;
    var phi_697_: bool;
    var phi_721_: u32;
    var phi_732_: f32;
    var phi_733_: f32;
    var phi_764_: type_38;
    var phi_765_: bool;
    var phi_766_: type_38;
    var phi_767_: bool;
    var phi_768_: type_38;
    var phi_769_: bool;
    var phi_774_: type_38;
    var phi_7715_: f32;
    var phi_7722_: f32;
    var phi_7727_: f32;
    var phi_7734_: f32;
    var phi_7739_: f32;
    var phi_7752_: f32;
    var phi_7759_: f32;
    var phi_7764_: f32;
    var phi_7771_: f32;
    var phi_7776_: f32;
    var phi_7781_: f32;
    var phi_7798_: f32;
    var phi_7805_: f32;
    var phi_7810_: f32;
    var phi_7817_: f32;
    var phi_7822_: f32;
    var phi_7836_: f32;
    var phi_7843_: f32;
    var phi_7848_: f32;
    var phi_7855_: f32;
    var phi_7860_: f32;
    var phi_7865_: f32;
    var phi_7882_: f32;
    var phi_7889_: f32;
    var phi_7894_: f32;
    var phi_7901_: f32;
    var phi_7906_: f32;
    var phi_7920_: f32;
    var phi_7927_: f32;
    var phi_7932_: f32;
    var phi_7939_: f32;
    var phi_7944_: f32;
    var phi_7949_: f32;
    var phi_7980_: f32;
    var phi_7986_: f32;
    var phi_7993_: f32;
    var phi_8000_: f32;
    var phi_8006_: f32;
    var phi_8013_: f32;
    var phi_8019_: f32;
    var phi_8025_: f32;
    var phi_8031_: f32;
    var phi_8038_: f32;
    var phi_8045_: f32;
    var phi_8069_: f32;
    var phi_8074_: f32;
    var phi_8079_: f32;
    var phi_8084_: f32;
    var phi_8089_: f32;
    var phi_8094_: f32;
    var phi_8104_: f32;
    var phi_8117_: f32;
    var phi_8123_: f32;
    var phi_8128_: f32;
    var phi_8134_: f32;
    var phi_8140_: f32;
    var phi_8145_: f32;
    var phi_8150_: f32;
    var phi_8158_: bool;
    var phi_8163_: f32;
    var phi_8170_: f32;
    var phi_8176_: f32;
    var phi_8194_: f32;
    var phi_8342_: f32;
    var phi_8349_: f32;
    var phi_8354_: f32;
    var phi_8361_: f32;
    var phi_8366_: f32;
    var phi_8379_: f32;
    var phi_8386_: f32;
    var phi_8391_: f32;
    var phi_8398_: f32;
    var phi_8403_: f32;
    var phi_8408_: f32;
    var phi_8425_: f32;
    var phi_8432_: f32;
    var phi_8437_: f32;
    var phi_8444_: f32;
    var phi_8449_: f32;
    var phi_8463_: f32;
    var phi_8470_: f32;
    var phi_8475_: f32;
    var phi_8482_: f32;
    var phi_8487_: f32;
    var phi_8492_: f32;
    var phi_8509_: f32;
    var phi_8516_: f32;
    var phi_8521_: f32;
    var phi_8528_: f32;
    var phi_8533_: f32;
    var phi_8547_: f32;
    var phi_8554_: f32;
    var phi_8559_: f32;
    var phi_8566_: f32;
    var phi_8571_: f32;
    var phi_8576_: f32;
    var phi_8694_: f32;
    var phi_8701_: f32;
    var phi_8709_: f32;
    var phi_8753_: type_14;
    var phi_8756_: f32;
    var phi_8777_: bool;
    var phi_8783_: type_15;
    var phi_8754_: type_14;
    var phi_8797_: type_15;
    var phi_8757_: f32;
    var local_19: f32;
    var phi_8746_: f32;
    var phi_8810_: f32;
    var phi_8876_: f32;
    var phi_8882_: f32;
    var phi_8891_: f32;
    var phi_8897_: f32;
    var phi_8906_: f32;
    var phi_8912_: f32;
    var phi_8921_: f32;
    var phi_8927_: f32;
    var phi_8933_: type_32;
    var phi_8934_: bool;
    var phi_8935_: type_32;
    var phi_8936_: bool;
    var phi_8944_: type_32;
    var phi_9113_: bool;
    var phi_9114_: bool;
    var phi_9115_: bool;
    var phi_9116_: bool;
    var phi_9117_: bool;
    var phi_9118_: bool;
    var phi_9122_: bool;
    var phi_9149_: f32;
    var phi_9203_: type_14;
    var phi_9206_: f32;
    var phi_9227_: bool;
    var phi_9233_: type_15;
    var phi_9204_: type_14;
    var phi_9247_: type_15;
    var phi_9207_: f32;
    var local_20: f32;
    var phi_9196_: f32;
    var phi_9260_: f32;
    var phi_9326_: f32;
    var phi_9332_: f32;
    var phi_9341_: f32;
    var phi_9347_: f32;
    var phi_9356_: f32;
    var phi_9362_: f32;
    var phi_9371_: f32;
    var phi_9377_: f32;
    var phi_9383_: type_32;
    var phi_9384_: bool;
    var phi_9385_: type_32;
    var phi_9386_: bool;
    var phi_9394_: type_32;
    var phi_9563_: bool;
    var phi_9564_: bool;
    var phi_9565_: bool;
    var phi_9566_: bool;
    var phi_9567_: bool;
    var phi_9568_: bool;
    var phi_9572_: bool;
    var phi_9605_: f32;
    var phi_9653_: type_14;
    var phi_9656_: f32;
    var phi_9677_: bool;
    var phi_9683_: type_15;
    var phi_9654_: type_14;
    var phi_9697_: type_15;
    var phi_9657_: f32;
    var local_21: f32;
    var phi_9646_: f32;
    var phi_9710_: f32;
    var phi_9776_: f32;
    var phi_9782_: f32;
    var phi_9791_: f32;
    var phi_9797_: f32;
    var phi_9806_: f32;
    var phi_9812_: f32;
    var phi_9821_: f32;
    var phi_9827_: f32;
    var phi_9833_: type_32;
    var phi_9834_: bool;
    var phi_9835_: type_32;
    var phi_9836_: bool;
    var phi_9844_: type_32;
    var phi_10013_: bool;
    var phi_10014_: bool;
    var phi_10015_: bool;
    var phi_10016_: bool;
    var phi_10017_: bool;
    var phi_10018_: bool;
    var phi_10022_: bool;
    var phi_10062_: f32;
    var phi_10103_: type_14;
    var phi_10106_: f32;
    var phi_10127_: bool;
    var phi_10133_: type_15;
    var phi_10104_: type_14;
    var phi_10147_: type_15;
    var phi_10107_: f32;
    var local_22: f32;
    var phi_10096_: f32;
    var phi_10160_: f32;
    var phi_10226_: f32;
    var phi_10232_: f32;
    var phi_10241_: f32;
    var phi_10247_: f32;
    var phi_10256_: f32;
    var phi_10262_: f32;
    var phi_10271_: f32;
    var phi_10277_: f32;
    var phi_10283_: type_32;
    var phi_10284_: bool;
    var phi_10285_: type_32;
    var phi_10286_: bool;
    var phi_10294_: type_32;
    var phi_10463_: bool;
    var phi_10464_: bool;
    var phi_10465_: bool;
    var phi_10466_: bool;
    var phi_10467_: bool;
    var phi_10468_: bool;
    var phi_10472_: bool;
    var phi_10473_: bool;
    var phi_10474_: bool;
    var phi_10475_: bool;
    var phi_10476_: bool;
    var phi_10477_: bool;
    var phi_10481_: bool;
    var phi_10487_: type_30;
    var phi_10488_: bool;
    var phi_10489_: type_30;
    var phi_10490_: bool;
    var phi_10533_: type_14;
    var phi_10536_: f32;
    var phi_10557_: bool;
    var phi_10563_: type_15;
    var phi_10534_: type_14;
    var phi_10577_: type_15;
    var phi_10537_: f32;
    var local_23: f32;
    var phi_10526_: f32;
    var phi_10590_: f32;
    var phi_10596_: f32;
    var phi_10621_: type_12;
    var phi_10624_: u32;
    var phi_10622_: type_12;
    var phi_10647_: type_12;
    var phi_10691_: u32;
    var phi_10692_: u32;
    var phi_10625_: u32;
    var phi_10693_: u32;
    var phi_10713_: type_12;
    var phi_10714_: type_12;
    var phi_10737_: type_12;
    var phi_10756_: f32;
    var phi_10769_: f32;
    var phi_10803_: f32;
    var phi_10810_: f32;
    var phi_10821_: bool;
    var phi_10822_: bool;
    var phi_10823_: bool;
    var phi_10824_: bool;
    var phi_10828_: bool;
    var phi_10839_: type_41;
    var phi_10840_: type_41;
    var phi_10841_: bool;
    var phi_10842_: type_41;
    var phi_10843_: bool;
    var phi_10854_: f32;
    var phi_10864_: type_12;
    var phi_10867_: f32;
    var phi_10869_: f32;
    var phi_10871_: f32;
    var phi_10865_: type_12;
    var phi_10894_: type_12;
    var phi_10919_: f32;
    var phi_10920_: f32;
    var phi_10946_: f32;
    var phi_10962_: f32;
    var phi_10969_: bool;
    var phi_10970_: bool;
    var phi_10971_: bool;
    var phi_10977_: f32;
    var phi_10978_: f32;
    var phi_10979_: bool;
    var phi_10868_: f32;
    var phi_10870_: f32;
    var phi_10872_: f32;
    var phi_10980_: f32;
    var phi_10981_: bool;
    var phi_10982_: bool;
    var local_24: bool;
    var phi_10986_: f32;
    var phi_10987_: f32;
    var phi_10995_: f32;
    var phi_10999_: type_12;
    var phi_11002_: f32;
    var phi_11000_: type_12;
    var phi_11025_: type_12;
    var phi_11055_: f32;
    var phi_11056_: bool;
    var phi_11057_: f32;
    var phi_11058_: bool;
    var phi_11059_: bool;
    var phi_11060_: bool;
    var phi_11061_: f32;
    var phi_11003_: f32;
    var phi_11062_: bool;
    var phi_11063_: bool;
    var phi_11064_: bool;
    var phi_11065_: bool;
    var local_25: bool;
    var phi_11069_: bool;
    var phi_11070_: bool;
    var phi_11074_: bool;
    var phi_11078_: f32;
    var phi_11079_: f32;
    var phi_11081_: type_41;
    var phi_11110_: f32;
    var phi_11117_: f32;
    var phi_11122_: f32;
    var phi_11129_: f32;
    var phi_11134_: f32;
    var phi_11147_: f32;
    var phi_11154_: f32;
    var phi_11159_: f32;
    var phi_11166_: f32;
    var phi_11171_: f32;
    var phi_11176_: f32;
    var phi_11235_: f32;
    var phi_11241_: f32;
    var phi_11246_: f32;
    var phi_11252_: f32;
    var phi_11257_: f32;
    var phi_11269_: f32;
    var phi_11275_: f32;
    var phi_11280_: f32;
    var phi_11286_: f32;
    var phi_11291_: f32;
    var phi_11317_: f32;
    var phi_11324_: f32;
    var phi_11329_: f32;
    var phi_11336_: f32;
    var phi_11341_: f32;
    var phi_11354_: f32;
    var phi_11361_: f32;
    var phi_11366_: f32;
    var phi_11373_: f32;
    var phi_11378_: f32;
    var phi_11383_: f32;
    var phi_11442_: f32;
    var phi_11448_: f32;
    var phi_11453_: f32;
    var phi_11459_: f32;
    var phi_11464_: f32;
    var phi_11476_: f32;
    var phi_11482_: f32;
    var phi_11487_: f32;
    var phi_11493_: f32;
    var phi_11498_: f32;
    var phi_11524_: f32;
    var phi_11531_: f32;
    var phi_11536_: f32;
    var phi_11543_: f32;
    var phi_11548_: f32;
    var phi_11561_: f32;
    var phi_11568_: f32;
    var phi_11573_: f32;
    var phi_11580_: f32;
    var phi_11585_: f32;
    var phi_11590_: f32;
    var phi_11649_: f32;
    var phi_11655_: f32;
    var phi_11660_: f32;
    var phi_11666_: f32;
    var phi_11671_: f32;
    var phi_11683_: f32;
    var phi_11689_: f32;
    var phi_11694_: f32;
    var phi_11700_: f32;
    var phi_11705_: f32;
    var phi_11754_: f32;
    var phi_11760_: f32;
    var phi_11788_: f32;
    var phi_11794_: f32;
    var phi_11799_: u32;
    var phi_11800_: u32;
    var phi_11770_: f32;
    var phi_11776_: f32;
    var phi_11781_: u32;
    var phi_11782_: u32;
    var phi_11801_: u32;
    var phi_11802_: u32;
    var phi_11871_: f32;
    var phi_11880_: f32;
    var phi_12015_: f32;
    var phi_12021_: f32;
    var phi_12028_: f32;
    var phi_12083_: type_12;
    var phi_12086_: bool;
    var phi_12084_: type_12;
    var phi_12109_: type_12;
    var phi_12136_: bool;
    var phi_12137_: bool;
    var phi_12087_: bool;
    var phi_12138_: bool;
    var phi_12139_: bool;
    var local_26: bool;
    var phi_12143_: bool;
    var local_27: bool;
    var phi_12150_: u32;
    var phi_12151_: u32;
    var phi_12152_: bool;
    var phi_12153_: u32;
    var phi_12154_: u32;
    var phi_12155_: bool;
    var phi_12159_: u32;
    var phi_12169_: bool;
    var phi_12181_: bool;
    var phi_12182_: bool;
    var phi_12330_: f32;
    var phi_12337_: f32;
    var phi_12342_: f32;
    var phi_12349_: f32;
    var phi_12354_: f32;
    var phi_12367_: f32;
    var phi_12374_: f32;
    var phi_12379_: f32;
    var phi_12386_: f32;
    var phi_12391_: f32;
    var phi_12396_: f32;
    var phi_12413_: f32;
    var phi_12420_: f32;
    var phi_12425_: f32;
    var phi_12432_: f32;
    var phi_12437_: f32;
    var phi_12451_: f32;
    var phi_12458_: f32;
    var phi_12463_: f32;
    var phi_12470_: f32;
    var phi_12475_: f32;
    var phi_12480_: f32;
    var phi_12497_: f32;
    var phi_12504_: f32;
    var phi_12509_: f32;
    var phi_12516_: f32;
    var phi_12521_: f32;
    var phi_12535_: f32;
    var phi_12542_: f32;
    var phi_12547_: f32;
    var phi_12554_: f32;
    var phi_12559_: f32;
    var phi_12564_: f32;
    var phi_12605_: type_12;
    var phi_12608_: f32;
    var phi_12610_: f32;
    var phi_12612_: f32;
    var phi_12614_: f32;
    var phi_12616_: bool;
    var phi_12618_: u32;
    var phi_12606_: type_12;
    var phi_12641_: type_12;
    var phi_12755_: f32;
    var phi_12761_: f32;
    var phi_12767_: f32;
    var phi_12769_: array<f32, 3>;
    var phi_12776_: f32;
    var phi_12783_: f32;
    var phi_12791_: f32;
    var phi_12835_: type_14;
    var phi_12838_: f32;
    var phi_12859_: bool;
    var phi_12865_: type_15;
    var phi_12836_: type_14;
    var phi_12879_: type_15;
    var phi_12839_: f32;
    var local_28: f32;
    var phi_12828_: f32;
    var phi_12892_: f32;
    var phi_12958_: f32;
    var phi_12964_: f32;
    var phi_12973_: f32;
    var phi_12979_: f32;
    var phi_12988_: f32;
    var phi_12994_: f32;
    var phi_13003_: f32;
    var phi_13009_: f32;
    var phi_13015_: type_32;
    var phi_13016_: bool;
    var phi_13017_: type_32;
    var phi_13018_: bool;
    var phi_13026_: type_32;
    var phi_13197_: bool;
    var phi_13198_: bool;
    var phi_13199_: bool;
    var phi_13200_: bool;
    var phi_13201_: bool;
    var phi_13202_: bool;
    var phi_13206_: bool;
    var phi_13503_: bool;
    var phi_13504_: bool;
    var phi_13505_: bool;
    var phi_13506_: bool;
    var phi_13507_: bool;
    var phi_13508_: bool;
    var phi_13512_: bool;
    var phi_13516_: bool;
    var phi_13527_: bool;
    var phi_13528_: bool;
    var phi_13602_: bool;
    var phi_13603_: bool;
    var phi_13623_: f32;
    var phi_13624_: bool;
    var phi_13625_: f32;
    var phi_13626_: bool;
    var phi_13627_: f32;
    var phi_13628_: bool;
    var phi_13629_: bool;
    var phi_13633_: f32;
    var phi_13634_: bool;
    var phi_13638_: f32;
    var phi_13670_: bool;
    var phi_13671_: bool;
    var phi_13691_: f32;
    var phi_13692_: bool;
    var phi_13693_: f32;
    var phi_13694_: bool;
    var phi_13695_: f32;
    var phi_13696_: bool;
    var phi_13697_: bool;
    var phi_13701_: f32;
    var phi_13702_: bool;
    var phi_13706_: f32;
    var phi_13711_: f32;
    var phi_13743_: bool;
    var phi_13744_: bool;
    var phi_13764_: f32;
    var phi_13765_: bool;
    var phi_13766_: f32;
    var phi_13767_: bool;
    var phi_13768_: f32;
    var phi_13769_: bool;
    var phi_13770_: bool;
    var phi_13774_: f32;
    var phi_13775_: bool;
    var phi_13779_: f32;
    var phi_13811_: bool;
    var phi_13812_: bool;
    var phi_13832_: f32;
    var phi_13833_: bool;
    var phi_13834_: f32;
    var phi_13835_: bool;
    var phi_13836_: f32;
    var phi_13837_: bool;
    var phi_13838_: bool;
    var phi_13842_: f32;
    var phi_13843_: bool;
    var phi_13847_: f32;
    var phi_13852_: f32;
    var phi_13857_: f32;
    var phi_13862_: f32;
    var phi_14356_: bool;
    var phi_14357_: bool;
    var phi_14362_: f32;
    var phi_14364_: f32;
    var phi_14367_: f32;
    var phi_14368_: f32;
    var phi_14369_: bool;
    var phi_14371_: f32;
    var phi_14372_: f32;
    var phi_14373_: f32;
    var phi_14375_: bool;
    var phi_14376_: bool;
    var phi_14378_: bool;
    var phi_14379_: f32;
    var phi_14380_: f32;
    var phi_14381_: f32;
    var phi_14383_: bool;
    var phi_14384_: bool;
    var phi_14385_: bool;
    var phi_14387_: bool;
    var phi_14388_: f32;
    var phi_14389_: f32;
    var phi_14390_: f32;
    var phi_14392_: bool;
    var phi_14393_: bool;
    var phi_14394_: bool;
    var phi_14396_: bool;
    var phi_14482_: f32;
    var phi_14555_: f32;
    var phi_14560_: f32;
    var phi_14633_: f32;
    var phi_14706_: f32;
    var phi_14711_: f32;
    var phi_14727_: f32;
    var phi_14728_: f32;
    var phi_14729_: f32;
    var phi_14409_: bool;
    var phi_14731_: u32;
    var phi_14732_: f32;
    var phi_14733_: bool;
    var phi_14734_: bool;
    var phi_14735_: bool;
    var phi_14736_: u32;
    var phi_14737_: f32;
    var phi_14738_: f32;
    var phi_14739_: f32;
    var phi_14740_: f32;
    var phi_14741_: bool;
    var phi_14742_: u32;
    var phi_14743_: bool;
    var phi_14744_: bool;
    var phi_14745_: bool;
    var phi_14746_: bool;
    var phi_14748_: bool;
    var phi_14757_: f32;
    var phi_14762_: f32;
    var phi_14771_: bool;
    var phi_14775_: bool;
    var phi_14776_: f32;
    var phi_14777_: f32;
    var phi_14778_: f32;
    var phi_14779_: f32;
    var phi_14780_: bool;
    var phi_14781_: u32;
    var phi_14782_: bool;
    var phi_14783_: bool;
    var phi_14784_: bool;
    var phi_14785_: bool;
    var phi_14787_: bool;
    var phi_12609_: f32;
    var phi_12611_: f32;
    var phi_12613_: f32;
    var phi_12615_: f32;
    var phi_12617_: bool;
    var phi_12619_: u32;
    var phi_14788_: f32;
    var phi_14790_: bool;
    var phi_14791_: bool;
    var phi_14792_: bool;
    var phi_14793_: bool;
    var phi_14795_: bool;
    var phi_14796_: bool;
    var local_29: bool;
    var phi_14800_: bool;
    var phi_14801_: bool;
    var phi_14803_: bool;
    var phi_14804_: bool;
    var local_30: f32;
    var phi_14809_: type_30;
    var phi_14810_: bool;
    var phi_14812_: bool;
    var phi_14813_: bool;
    var phi_14814_: bool;
    var phi_14819_: type_30;
    var phi_14821_: bool;
    var phi_14822_: bool;
    var phi_14823_: bool;
    var phi_14824_: bool;
    var phi_14836_: f32;
    var phi_14837_: bool;
    var phi_14838_: bool;
    var phi_14839_: bool;
    var phi_14844_: type_30;
    var phi_14845_: bool;
    var phi_14846_: bool;
    var phi_14851_: type_30;
    var phi_14852_: bool;
    var phi_14856_: type_30;
    var phi_14863_: bool;
    var phi_14864_: f32;
    var phi_14865_: bool;
    var phi_14866_: bool;
    var phi_14867_: bool;
    var phi_14868_: bool;
    var phi_14869_: f32;
    var phi_14870_: f32;
    var phi_14871_: bool;
    var phi_14872_: bool;
    var phi_14873_: bool;
    var phi_14874_: bool;
    var phi_14875_: f32;
    var phi_14876_: f32;
    var phi_14877_: bool;
    var phi_14878_: bool;
    var phi_14879_: bool;
    var phi_14880_: bool;
    var phi_14884_: bool;
    var phi_14885_: bool;
    var phi_14886_: bool;
    var phi_14887_: type_41;
    var phi_14888_: bool;
    var phi_14889_: f32;
    var phi_14890_: f32;
    var phi_14891_: type_41;
    var phi_14892_: bool;
    var phi_14893_: bool;
    var phi_14894_: bool;
    var phi_14895_: bool;
    var phi_14899_: bool;
    var phi_14900_: bool;
    var phi_14901_: bool;
    var phi_14902_: type_41;
    var phi_14903_: bool;
    var phi_14904_: f32;
    var phi_14905_: f32;
    var phi_14906_: type_41;
    var phi_14907_: bool;
    var phi_14908_: bool;
    var phi_14909_: bool;
    var phi_14910_: bool;
    var local_31: bool;
    var phi_14915_: type_30;
    var phi_14916_: bool;
    var phi_14917_: bool;
    var local_32: bool;
    var local_33: type_41;
    var local_34: f32;
    var local_35: f32;
    var local_36: f32;
    var phi_14931_: type_30;
    var phi_14932_: bool;
    var phi_14933_: type_30;
    var phi_14934_: bool;
    var local_37: f32;
    var phi_14939_: type_30;
    var phi_14940_: type_30;
    var phi_14941_: bool;
    var local_38: type_41;
    var phi_14947_: type_30;
    var phi_14948_: bool;
    var phi_14952_: type_30;
    var phi_14953_: type_30;
    var phi_14954_: bool;
    var phi_14958_: type_30;
    var phi_14959_: type_30;
    var phi_14960_: bool;
    var phi_14964_: type_30;
    var phi_14975_: bool;
    var phi_14976_: bool;
    var phi_14980_: bool;
    var phi_14984_: u32;
    var phi_948_: type_14;
    var phi_951_: f32;
    var phi_972_: bool;
    var phi_978_: type_15;
    var phi_949_: type_14;
    var phi_992_: type_15;
    var phi_952_: f32;
    var local_39: f32;
    var phi_941_: f32;
    var phi_1005_: f32;
    var phi_1021_: f32;
    var phi_1028_: f32;
    var phi_1033_: f32;
    var phi_1040_: f32;
    var phi_1045_: f32;
    var phi_1058_: f32;
    var phi_1065_: f32;
    var phi_1070_: f32;
    var phi_1077_: f32;
    var phi_1082_: f32;
    var phi_1087_: f32;
    var phi_1104_: f32;
    var phi_1111_: f32;
    var phi_1116_: f32;
    var phi_1123_: f32;
    var phi_1128_: f32;
    var phi_1142_: f32;
    var phi_1149_: f32;
    var phi_1154_: f32;
    var phi_1161_: f32;
    var phi_1166_: f32;
    var phi_1171_: f32;
    var phi_1188_: f32;
    var phi_1195_: f32;
    var phi_1200_: f32;
    var phi_1207_: f32;
    var phi_1212_: f32;
    var phi_1226_: f32;
    var phi_1233_: f32;
    var phi_1238_: f32;
    var phi_1245_: f32;
    var phi_1250_: f32;
    var phi_1255_: f32;
    var phi_1516_: f32;
    var phi_1523_: f32;
    var phi_1528_: f32;
    var phi_1535_: f32;
    var phi_1540_: f32;
    var phi_1553_: f32;
    var phi_1560_: f32;
    var phi_1565_: f32;
    var phi_1572_: f32;
    var phi_1577_: f32;
    var phi_1582_: f32;
    var phi_1599_: f32;
    var phi_1606_: f32;
    var phi_1611_: f32;
    var phi_1618_: f32;
    var phi_1623_: f32;
    var phi_1637_: f32;
    var phi_1644_: f32;
    var phi_1649_: f32;
    var phi_1656_: f32;
    var phi_1661_: f32;
    var phi_1666_: f32;
    var phi_1683_: f32;
    var phi_1690_: f32;
    var phi_1695_: f32;
    var phi_1702_: f32;
    var phi_1707_: f32;
    var phi_1721_: f32;
    var phi_1728_: f32;
    var phi_1733_: f32;
    var phi_1740_: f32;
    var phi_1745_: f32;
    var phi_1750_: f32;
    var phi_1781_: f32;
    var phi_1787_: f32;
    var phi_1794_: f32;
    var phi_1801_: f32;
    var phi_1807_: f32;
    var phi_1814_: f32;
    var phi_1820_: f32;
    var phi_1826_: f32;
    var phi_1832_: f32;
    var phi_1839_: f32;
    var phi_1846_: f32;
    var phi_1870_: f32;
    var phi_1875_: f32;
    var phi_1880_: f32;
    var phi_1885_: f32;
    var phi_1890_: f32;
    var phi_1895_: f32;
    var phi_1905_: f32;
    var phi_1914_: type_39;
    var phi_1915_: bool;
    var phi_1916_: type_39;
    var phi_1917_: bool;
    var phi_1923_: type_14;
    var phi_1926_: f32;
    var phi_1928_: u32;
    var phi_1930_: f32;
    var phi_1951_: bool;
    var phi_1957_: type_15;
    var phi_1924_: type_14;
    var phi_1971_: type_15;
    var phi_1986_: bool;
    var phi_1987_: bool;
    var phi_2133_: f32;
    var phi_2140_: f32;
    var phi_2145_: f32;
    var phi_2152_: f32;
    var phi_2157_: f32;
    var phi_2170_: f32;
    var phi_2177_: f32;
    var phi_2182_: f32;
    var phi_2189_: f32;
    var phi_2194_: f32;
    var phi_2199_: f32;
    var phi_2216_: f32;
    var phi_2223_: f32;
    var phi_2228_: f32;
    var phi_2235_: f32;
    var phi_2240_: f32;
    var phi_2254_: f32;
    var phi_2261_: f32;
    var phi_2266_: f32;
    var phi_2273_: f32;
    var phi_2278_: f32;
    var phi_2283_: f32;
    var phi_2300_: f32;
    var phi_2307_: f32;
    var phi_2312_: f32;
    var phi_2319_: f32;
    var phi_2324_: f32;
    var phi_2338_: f32;
    var phi_2345_: f32;
    var phi_2350_: f32;
    var phi_2357_: f32;
    var phi_2362_: f32;
    var phi_2367_: f32;
    var phi_2408_: type_12;
    var phi_2411_: f32;
    var phi_2413_: f32;
    var phi_2415_: f32;
    var phi_2417_: f32;
    var phi_2419_: bool;
    var phi_2421_: u32;
    var phi_2409_: type_12;
    var phi_2444_: type_12;
    var phi_2558_: f32;
    var phi_2564_: f32;
    var phi_2570_: f32;
    var phi_2572_: array<f32, 3>;
    var phi_2579_: f32;
    var phi_2586_: f32;
    var phi_2594_: f32;
    var phi_2638_: type_14;
    var phi_2641_: f32;
    var phi_2662_: bool;
    var phi_2668_: type_15;
    var phi_2639_: type_14;
    var phi_2682_: type_15;
    var phi_2642_: f32;
    var local_40: f32;
    var phi_2631_: f32;
    var phi_2695_: f32;
    var phi_2761_: f32;
    var phi_2767_: f32;
    var phi_2776_: f32;
    var phi_2782_: f32;
    var phi_2791_: f32;
    var phi_2797_: f32;
    var phi_2806_: f32;
    var phi_2812_: f32;
    var phi_2818_: type_32;
    var phi_2819_: bool;
    var phi_2820_: type_32;
    var phi_2821_: bool;
    var phi_2829_: type_32;
    var phi_3000_: bool;
    var phi_3001_: bool;
    var phi_3002_: bool;
    var phi_3003_: bool;
    var phi_3004_: bool;
    var phi_3005_: bool;
    var phi_3009_: bool;
    var phi_3306_: bool;
    var phi_3307_: bool;
    var phi_3308_: bool;
    var phi_3309_: bool;
    var phi_3310_: bool;
    var phi_3311_: bool;
    var phi_3315_: bool;
    var phi_3319_: bool;
    var phi_3330_: bool;
    var phi_3331_: bool;
    var phi_3405_: bool;
    var phi_3406_: bool;
    var phi_3426_: f32;
    var phi_3427_: bool;
    var phi_3428_: f32;
    var phi_3429_: bool;
    var phi_3430_: f32;
    var phi_3431_: bool;
    var phi_3432_: bool;
    var phi_3436_: f32;
    var phi_3437_: bool;
    var phi_3441_: f32;
    var phi_3473_: bool;
    var phi_3474_: bool;
    var phi_3494_: f32;
    var phi_3495_: bool;
    var phi_3496_: f32;
    var phi_3497_: bool;
    var phi_3498_: f32;
    var phi_3499_: bool;
    var phi_3500_: bool;
    var phi_3504_: f32;
    var phi_3505_: bool;
    var phi_3509_: f32;
    var phi_3514_: f32;
    var phi_3546_: bool;
    var phi_3547_: bool;
    var phi_3567_: f32;
    var phi_3568_: bool;
    var phi_3569_: f32;
    var phi_3570_: bool;
    var phi_3571_: f32;
    var phi_3572_: bool;
    var phi_3573_: bool;
    var phi_3577_: f32;
    var phi_3578_: bool;
    var phi_3582_: f32;
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
    var phi_3655_: f32;
    var phi_3660_: f32;
    var phi_3665_: f32;
    var phi_3678_: f32;
    var phi_3815_: type_14;
    var phi_3818_: f32;
    var phi_3839_: bool;
    var phi_3845_: type_15;
    var phi_3816_: type_14;
    var phi_3859_: type_15;
    var phi_3819_: f32;
    var local_41: f32;
    var phi_3808_: f32;
    var phi_3872_: f32;
    var phi_3888_: f32;
    var phi_3895_: f32;
    var phi_3900_: f32;
    var phi_3907_: f32;
    var phi_3912_: f32;
    var phi_3925_: f32;
    var phi_3932_: f32;
    var phi_3937_: f32;
    var phi_3944_: f32;
    var phi_3949_: f32;
    var phi_3954_: f32;
    var phi_3971_: f32;
    var phi_3978_: f32;
    var phi_3983_: f32;
    var phi_3990_: f32;
    var phi_3995_: f32;
    var phi_4009_: f32;
    var phi_4016_: f32;
    var phi_4021_: f32;
    var phi_4028_: f32;
    var phi_4033_: f32;
    var phi_4038_: f32;
    var phi_4055_: f32;
    var phi_4062_: f32;
    var phi_4067_: f32;
    var phi_4074_: f32;
    var phi_4079_: f32;
    var phi_4093_: f32;
    var phi_4100_: f32;
    var phi_4105_: f32;
    var phi_4112_: f32;
    var phi_4117_: f32;
    var phi_4122_: f32;
    var phi_4142_: bool;
    var phi_4143_: bool;
    var phi_4144_: bool;
    var phi_4159_: bool;
    var phi_4160_: bool;
    var phi_4165_: f32;
    var phi_4167_: f32;
    var phi_4168_: f32;
    var phi_4169_: bool;
    var phi_4170_: f32;
    var phi_4171_: f32;
    var phi_4172_: bool;
    var phi_4173_: bool;
    var phi_4174_: f32;
    var phi_4175_: f32;
    var phi_4176_: f32;
    var phi_4177_: f32;
    var phi_4178_: bool;
    var phi_4179_: bool;
    var phi_4180_: bool;
    var phi_4181_: bool;
    var phi_4182_: f32;
    var phi_4183_: f32;
    var phi_4184_: f32;
    var phi_4185_: f32;
    var phi_4186_: bool;
    var phi_4187_: bool;
    var phi_4188_: bool;
    var phi_4189_: bool;
    var phi_4190_: bool;
    var phi_4191_: f32;
    var phi_4192_: f32;
    var phi_4193_: f32;
    var phi_4194_: f32;
    var phi_4195_: bool;
    var phi_4196_: bool;
    var phi_4197_: bool;
    var phi_4198_: bool;
    var phi_4199_: bool;
    var phi_4285_: f32;
    var phi_4358_: f32;
    var phi_4363_: f32;
    var phi_4436_: f32;
    var phi_4509_: f32;
    var phi_4514_: f32;
    var phi_4530_: f32;
    var phi_4531_: f32;
    var phi_4532_: f32;
    var phi_4212_: bool;
    var phi_4534_: u32;
    var phi_4535_: f32;
    var phi_4536_: bool;
    var phi_4537_: bool;
    var phi_4538_: bool;
    var phi_4539_: u32;
    var phi_4540_: f32;
    var phi_4541_: f32;
    var phi_4542_: f32;
    var phi_4543_: f32;
    var phi_4544_: bool;
    var phi_4545_: u32;
    var phi_4546_: bool;
    var phi_4547_: bool;
    var phi_4548_: bool;
    var phi_4549_: bool;
    var phi_4550_: bool;
    var phi_4551_: bool;
    var phi_4560_: f32;
    var phi_4565_: f32;
    var phi_4574_: bool;
    var phi_4578_: bool;
    var phi_4579_: f32;
    var phi_4580_: f32;
    var phi_4581_: f32;
    var phi_4582_: f32;
    var phi_4583_: bool;
    var phi_4584_: u32;
    var phi_4585_: bool;
    var phi_4586_: bool;
    var phi_4587_: bool;
    var phi_4588_: bool;
    var phi_4589_: bool;
    var phi_4590_: bool;
    var phi_2412_: f32;
    var phi_2414_: f32;
    var phi_2416_: f32;
    var phi_2418_: f32;
    var phi_2420_: bool;
    var phi_2422_: u32;
    var phi_4591_: f32;
    var phi_4592_: f32;
    var phi_4593_: bool;
    var phi_4594_: bool;
    var phi_4595_: bool;
    var phi_4596_: bool;
    var phi_4597_: bool;
    var phi_4598_: bool;
    var phi_4599_: bool;
    var local_42: bool;
    var phi_4603_: bool;
    var phi_4604_: bool;
    var phi_4605_: bool;
    var phi_4606_: bool;
    var phi_4607_: bool;
    var local_43: f32;
    var phi_4612_: type_30;
    var phi_4613_: bool;
    var phi_4614_: bool;
    var phi_4615_: bool;
    var phi_4616_: bool;
    var phi_4617_: bool;
    var phi_4622_: type_30;
    var phi_4623_: bool;
    var phi_4624_: bool;
    var phi_4625_: bool;
    var phi_4626_: bool;
    var phi_4627_: bool;
    var phi_4631_: f32;
    var phi_4632_: bool;
    var phi_4633_: bool;
    var phi_4634_: bool;
    var phi_4635_: bool;
    var phi_4639_: f32;
    var phi_4640_: bool;
    var phi_4641_: bool;
    var phi_4642_: bool;
    var phi_4647_: type_30;
    var phi_4648_: bool;
    var phi_4649_: bool;
    var phi_4654_: type_30;
    var phi_4655_: bool;
    var phi_4659_: type_30;
    var phi_4666_: f32;
    var phi_4667_: bool;
    var phi_4779_: f32;
    var phi_4786_: f32;
    var phi_4794_: f32;
    var phi_4945_: f32;
    var phi_4952_: f32;
    var phi_4957_: f32;
    var phi_4964_: f32;
    var phi_4969_: f32;
    var phi_4982_: f32;
    var phi_4989_: f32;
    var phi_4994_: f32;
    var phi_5001_: f32;
    var phi_5006_: f32;
    var phi_5011_: f32;
    var phi_5028_: f32;
    var phi_5035_: f32;
    var phi_5040_: f32;
    var phi_5047_: f32;
    var phi_5052_: f32;
    var phi_5066_: f32;
    var phi_5073_: f32;
    var phi_5078_: f32;
    var phi_5085_: f32;
    var phi_5090_: f32;
    var phi_5095_: f32;
    var phi_5112_: f32;
    var phi_5119_: f32;
    var phi_5124_: f32;
    var phi_5131_: f32;
    var phi_5136_: f32;
    var phi_5150_: f32;
    var phi_5157_: f32;
    var phi_5162_: f32;
    var phi_5169_: f32;
    var phi_5174_: f32;
    var phi_5179_: f32;
    var phi_5287_: type_14;
    var phi_5290_: f32;
    var phi_5311_: bool;
    var phi_5317_: type_15;
    var phi_5288_: type_14;
    var phi_5331_: type_15;
    var phi_5291_: f32;
    var local_44: f32;
    var phi_5280_: f32;
    var phi_5344_: f32;
    var phi_5478_: f32;
    var phi_5484_: f32;
    var phi_5493_: f32;
    var phi_5499_: f32;
    var phi_5508_: f32;
    var phi_5514_: f32;
    var phi_5523_: f32;
    var phi_5529_: f32;
    var phi_5579_: type_14;
    var phi_5582_: f32;
    var phi_5603_: bool;
    var phi_5609_: type_15;
    var phi_5580_: type_14;
    var phi_5623_: type_15;
    var phi_5583_: f32;
    var local_45: f32;
    var phi_5572_: f32;
    var phi_5636_: f32;
    var phi_5668_: type_14;
    var phi_5671_: f32;
    var phi_5692_: bool;
    var phi_5698_: type_15;
    var phi_5669_: type_14;
    var phi_5712_: type_15;
    var phi_5672_: f32;
    var local_46: f32;
    var phi_5661_: f32;
    var phi_5725_: f32;
    var phi_5741_: f32;
    var phi_5748_: f32;
    var phi_5753_: f32;
    var phi_5760_: f32;
    var phi_5765_: f32;
    var phi_5778_: f32;
    var phi_5785_: f32;
    var phi_5790_: f32;
    var phi_5797_: f32;
    var phi_5802_: f32;
    var phi_5807_: f32;
    var phi_5824_: f32;
    var phi_5831_: f32;
    var phi_5836_: f32;
    var phi_5843_: f32;
    var phi_5848_: f32;
    var phi_5862_: f32;
    var phi_5869_: f32;
    var phi_5874_: f32;
    var phi_5881_: f32;
    var phi_5886_: f32;
    var phi_5891_: f32;
    var phi_5908_: f32;
    var phi_5915_: f32;
    var phi_5920_: f32;
    var phi_5927_: f32;
    var phi_5932_: f32;
    var phi_5946_: f32;
    var phi_5953_: f32;
    var phi_5958_: f32;
    var phi_5965_: f32;
    var phi_5970_: f32;
    var phi_5975_: f32;
    var phi_6016_: f32;
    var phi_6022_: f32;
    var phi_6033_: type_12;
    var phi_6036_: f32;
    var phi_6034_: type_12;
    var phi_6059_: type_12;
    var phi_6088_: f32;
    var phi_6094_: f32;
    var phi_6107_: f32;
    var phi_6037_: f32;
    var local_47: f32;
    var local_48: f32;
    var phi_6135_: type_14;
    var phi_6138_: f32;
    var phi_6159_: bool;
    var phi_6165_: type_15;
    var phi_6136_: type_14;
    var phi_6179_: type_15;
    var phi_6139_: f32;
    var local_49: f32;
    var phi_6128_: f32;
    var phi_6192_: f32;
    var phi_6197_: type_12;
    var phi_6200_: f32;
    var phi_6202_: bool;
    var phi_6204_: bool;
    var phi_6198_: type_12;
    var phi_6227_: type_12;
    var phi_6264_: f32;
    var phi_6271_: f32;
    var phi_6279_: f32;
    var phi_6287_: f32;
    var phi_6294_: f32;
    var phi_6302_: f32;
    var phi_6308_: f32;
    var phi_6326_: f32;
    var phi_6332_: f32;
    var phi_6339_: f32;
    var phi_6365_: f32;
    var phi_6371_: f32;
    var phi_6407_: bool;
    var phi_6414_: bool;
    var phi_6427_: f32;
    var phi_6433_: f32;
    var phi_6434_: f32;
    var phi_6435_: f32;
    var phi_6201_: f32;
    var phi_6203_: bool;
    var phi_6205_: bool;
    var local_50: f32;
    var phi_6440_: f32;
    var local_51: bool;
    var local_52: bool;
    var phi_6449_: type_40;
    var phi_6450_: type_40;
    var phi_6451_: bool;
    var local_53: bool;
    var phi_6468_: f32;
    var phi_6469_: f32;
    var phi_6472_: type_12;
    var phi_6475_: f32;
    var phi_6477_: f32;
    var phi_6473_: type_12;
    var phi_6500_: type_12;
    var phi_6579_: f32;
    var phi_6580_: f32;
    var phi_6568_: f32;
    var phi_6581_: f32;
    var phi_6582_: f32;
    var phi_6476_: f32;
    var phi_6478_: f32;
    var local_54: f32;
    var local_55: f32;
    var local_56: f32;
    var phi_6743_: bool;
    var phi_6744_: bool;
    var phi_6745_: bool;
    var phi_6746_: bool;
    var phi_6747_: bool;
    var phi_6748_: bool;
    var phi_6752_: bool;
    var phi_6756_: bool;
    var phi_6757_: bool;
    var phi_6758_: bool;
    var phi_6762_: f32;
    var phi_6765_: type_40;
    var phi_6766_: type_40;
    var phi_6767_: bool;
    var phi_6768_: type_40;
    var phi_6769_: type_40;
    var phi_6770_: bool;
    var phi_6775_: type_40;
    var phi_6776_: type_40;
    var phi_6777_: bool;
    var phi_6781_: type_40;
    var phi_6782_: type_40;
    var phi_6783_: bool;
    var phi_6784_: bool;
    var phi_6785_: type_40;
    var phi_6786_: type_40;
    var phi_6787_: bool;
    var phi_6788_: bool;
    var phi_6793_: type_40;
    var phi_6794_: bool;
    var phi_6798_: type_40;
    var phi_6814_: f32;
    var phi_6815_: f32;
    var phi_6816_: bool;
    var phi_6817_: f32;
    var phi_6818_: f32;
    var phi_6819_: bool;
    var phi_6820_: bool;
    var phi_6821_: bool;
    var phi_6822_: f32;
    var phi_6823_: f32;
    var phi_6824_: bool;
    var phi_6825_: bool;
    var phi_6826_: bool;
    var phi_6827_: f32;
    var phi_6828_: u32;
    var phi_6829_: f32;
    var phi_6830_: type_40;
    var phi_6831_: u32;
    var phi_6832_: u32;
    var phi_6833_: bool;
    var phi_6834_: bool;
    var phi_6835_: bool;
    var phi_6836_: f32;
    var phi_6837_: u32;
    var phi_6838_: f32;
    var phi_6839_: type_40;
    var phi_6840_: u32;
    var phi_6841_: u32;
    var phi_6842_: bool;
    var phi_6843_: bool;
    var phi_6844_: bool;
    var phi_6845_: bool;
    var phi_6846_: bool;
    var phi_6847_: f32;
    var phi_1927_: f32;
    var phi_1929_: u32;
    var phi_1931_: f32;
    var phi_6848_: type_40;
    var phi_6849_: u32;
    var phi_6850_: f32;
    var phi_6851_: u32;
    var phi_6852_: bool;
    var phi_6853_: bool;
    var phi_6854_: bool;
    var phi_6855_: bool;
    var phi_6856_: bool;
    var phi_6857_: bool;
    var local_57: bool;
    var phi_6861_: bool;
    var phi_6862_: bool;
    var phi_6863_: bool;
    var phi_6864_: bool;
    var local_58: type_40;
    var local_59: type_40;
    var phi_6881_: u32;
    var local_60: type_40;
    var phi_6886_: type_39;
    var phi_6887_: type_39;
    var phi_6888_: bool;
    var phi_6889_: bool;
    var phi_6890_: bool;
    var phi_6891_: bool;
    var phi_6895_: u32;
    var phi_6896_: f32;
    var phi_6897_: bool;
    var phi_6898_: bool;
    var phi_6899_: bool;
    var phi_6900_: bool;
    var phi_6904_: f32;
    var phi_6905_: u32;
    var phi_6906_: bool;
    var phi_6907_: bool;
    var phi_6908_: bool;
    var phi_6920_: f32;
    var phi_6923_: type_12;
    var phi_6924_: type_12;
    var phi_6947_: type_12;
    var phi_6968_: f32;
    var phi_7098_: type_14;
    var phi_7101_: f32;
    var phi_7122_: bool;
    var phi_7128_: type_15;
    var phi_7099_: type_14;
    var phi_7142_: type_15;
    var phi_7102_: f32;
    var local_61: f32;
    var phi_7091_: f32;
    var phi_7155_: f32;
    var phi_7171_: f32;
    var phi_7178_: f32;
    var phi_7183_: f32;
    var phi_7190_: f32;
    var phi_7195_: f32;
    var phi_7208_: f32;
    var phi_7215_: f32;
    var phi_7220_: f32;
    var phi_7227_: f32;
    var phi_7232_: f32;
    var phi_7237_: f32;
    var phi_7254_: f32;
    var phi_7261_: f32;
    var phi_7266_: f32;
    var phi_7273_: f32;
    var phi_7278_: f32;
    var phi_7292_: f32;
    var phi_7299_: f32;
    var phi_7304_: f32;
    var phi_7311_: f32;
    var phi_7316_: f32;
    var phi_7321_: f32;
    var phi_7338_: f32;
    var phi_7345_: f32;
    var phi_7350_: f32;
    var phi_7357_: f32;
    var phi_7362_: f32;
    var phi_7376_: f32;
    var phi_7383_: f32;
    var phi_7388_: f32;
    var phi_7395_: f32;
    var phi_7400_: f32;
    var phi_7405_: f32;
    var phi_7425_: bool;
    var phi_7426_: bool;
    var phi_7427_: bool;
    var local_62: bool;
    var phi_7435_: u32;
    var phi_7439_: type_39;
    var phi_7440_: bool;
    var phi_7448_: u32;
    var phi_7452_: type_39;
    var phi_7453_: type_39;
    var phi_7454_: bool;
    var phi_7455_: bool;
    var phi_7462_: type_39;
    var phi_7463_: bool;
    var phi_7467_: type_39;
    var phi_7468_: type_39;
    var phi_7469_: bool;
    var phi_7473_: type_39;
    var phi_14988_: type_39;
    var phi_15003_: type_42;
    var phi_15025_: array<u32, 2>;
    var phi_15026_: array<u32, 2>;
    var phi_15027_: bool;
    var phi_15031_: array<u32, 2>;
    var phi_15058_: array<u32, 2>;
    var phi_15059_: array<u32, 2>;
    var phi_15060_: bool;
    var phi_15064_: array<u32, 2>;
    var phi_15067_: bool;
    var phi_15082_: bool;
    var phi_15083_: bool;
    var phi_15091_: bool;
    var phi_15092_: bool;
    var phi_15097_: u32;
    var phi_15105_: bool;
    var phi_15126_: u32;
    var phi_15130_: type_20;
    var phi_15131_: bool;
    var phi_15132_: bool;
    var phi_15151_: u32;
    var phi_15218_: u32;
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
    let _e121 = id_2;
    let _e122 = n_2;
    let _e123 = lane_2;
    let _e135 = ((_e121.y * _e122.x) + _e121.x);
    let _e138 = (_e122.x * _e122.y);
    let _e141 = params.member.member_1.member_2;
    let _e143 = input.member[0u];
    if (_e141 < _e143) {
        phi_250_ = _e141;
    } else {
        phi_250_ = _e143;
    }
    let _e146 = phi_250_;
    let _e147 = (_e146 / 64u);
    if ((_e146 % 64u) > 0u) {
        phi_266_ = (_e147 + 1u);
    } else {
        phi_266_ = _e147;
    }
    let _e152 = phi_266_;
    if (_e152 > _e135) {
        let _e154 = (_e152 - _e135);
        if (_e138 == 0u) {
            return;
        }
        let _e156 = (_e154 / _e138);
        if (_e138 == 0u) {
            return;
        }
        if ((_e154 % _e138) > 0u) {
            phi_287_ = (_e156 + 1u);
        } else {
            phi_287_ = _e156;
        }
        let _e162 = phi_287_;
        phi_288_ = _e162;
    } else {
        phi_288_ = 0u;
    }
    let _e164 = phi_288_;
    phi_291_ = type_12(0u, _e164);
    loop {
        let _e167 = phi_291_;
        if (_e167.member < _e167.member_1) {
            phi_292_ = type_12((_e167.member + 1u), _e167.member_1);
            phi_315_ = type_12(1u, _e167.member);
        } else {
            phi_292_ = _e167;
            phi_315_ = type_12(0u, type_12().member_1);
        }
        let _e179 = phi_292_;
        let _e181 = phi_315_;
        let _e185 = (bitcast<i32>(_e181.member) != 0i);
        if _e185 {
            let _e189 = (((_e135 + (_e181.member_1 * _e138)) * 64u) + _e123);
            if (_e189 < _e146) {
                let _e191 = (2u * _e189);
                let _e194 = input.member[(4u + _e191)];
                let _e197 = input.member[(_e191 + 5u)];
                let _e200 = elements.member[_e194];
                let _e202 = elements.member[_e197];
                let _e208 = paths.member[_e200[0]];
                let _e210 = paths.member[_e200[1]];
                let _e216 = paths.member[_e202[0]];
                let _e218 = paths.member[_e202[1]];
                let _e248 = params.member.member.member_4;
                let _e249 = (_e216.member[0] - _e208.member[0]);
                let _e250 = (_e216.member[1] - _e208.member[1]);
                let _e251 = (_e216.member[2] - _e208.member[2]);
                let _e253 = (_e216.member_1[0] - _e208.member_1[0]);
                let _e254 = (_e216.member_1[1] - _e208.member_1[1]);
                let _e255 = (_e216.member_1[2] - _e208.member_1[2]);
                let _e258 = (_e210.member[0] - _e208.member[0]);
                let _e259 = (_e210.member[1] - _e208.member[1]);
                let _e260 = (_e210.member[2] - _e208.member[2]);
                let _e262 = (_e210.member_1[0] - _e208.member_1[0]);
                let _e263 = (_e210.member_1[1] - _e208.member_1[1]);
                let _e264 = (_e210.member_1[2] - _e208.member_1[2]);
                let _e267 = (_e216.member[0] - _e218.member[0]);
                let _e268 = (_e216.member[1] - _e218.member[1]);
                let _e269 = (_e216.member[2] - _e218.member[2]);
                let _e271 = (_e216.member_1[0] - _e218.member_1[0]);
                let _e272 = (_e216.member_1[1] - _e218.member_1[1]);
                let _e273 = (_e216.member_1[2] - _e218.member_1[2]);
                let _e276 = (_e248 + _e248);
                let _e279 = params.member.member.member_5;
                let _e281 = params.member.member.member_11;
                let _e283 = params.member.member.member_12;
                let _e285 = params.member.member.member_13;
                let _e287 = params.member.member.member_1;
                if (_e249 < 0f) {
                    phi_500_ = -(_e249);
                } else {
                    phi_500_ = _e249;
                }
                let _e293 = phi_500_;
                if (_e250 < 0f) {
                    phi_506_ = -(_e250);
                } else {
                    phi_506_ = _e250;
                }
                let _e297 = phi_506_;
                if (_e293 > _e297) {
                    phi_511_ = _e293;
                } else {
                    phi_511_ = _e297;
                }
                let _e300 = phi_511_;
                if (_e251 < 0f) {
                    phi_517_ = -(_e251);
                } else {
                    phi_517_ = _e251;
                }
                let _e304 = phi_517_;
                if (_e300 > _e304) {
                    phi_522_ = _e300;
                } else {
                    phi_522_ = _e304;
                }
                let _e307 = phi_522_;
                if (_e253 < 0f) {
                    phi_528_ = -(_e253);
                } else {
                    phi_528_ = _e253;
                }
                let _e311 = phi_528_;
                if (_e254 < 0f) {
                    phi_534_ = -(_e254);
                } else {
                    phi_534_ = _e254;
                }
                let _e315 = phi_534_;
                if (_e311 > _e315) {
                    phi_539_ = _e311;
                } else {
                    phi_539_ = _e315;
                }
                let _e318 = phi_539_;
                if (_e255 < 0f) {
                    phi_545_ = -(_e255);
                } else {
                    phi_545_ = _e255;
                }
                let _e322 = phi_545_;
                if (_e318 > _e322) {
                    phi_550_ = _e318;
                } else {
                    phi_550_ = _e322;
                }
                let _e325 = phi_550_;
                if (_e307 > _e325) {
                    phi_555_ = _e307;
                } else {
                    phi_555_ = _e325;
                }
                let _e328 = phi_555_;
                let _e329 = (_e328 + _e276);
                if (_e258 < 0f) {
                    phi_562_ = -(_e258);
                } else {
                    phi_562_ = _e258;
                }
                let _e333 = phi_562_;
                if (_e259 < 0f) {
                    phi_568_ = -(_e259);
                } else {
                    phi_568_ = _e259;
                }
                let _e337 = phi_568_;
                if (_e333 > _e337) {
                    phi_573_ = _e333;
                } else {
                    phi_573_ = _e337;
                }
                let _e340 = phi_573_;
                if (_e260 < 0f) {
                    phi_579_ = -(_e260);
                } else {
                    phi_579_ = _e260;
                }
                let _e344 = phi_579_;
                if (_e340 > _e344) {
                    phi_584_ = _e340;
                } else {
                    phi_584_ = _e344;
                }
                let _e347 = phi_584_;
                if (_e262 < 0f) {
                    phi_590_ = -(_e262);
                } else {
                    phi_590_ = _e262;
                }
                let _e351 = phi_590_;
                if (_e263 < 0f) {
                    phi_596_ = -(_e263);
                } else {
                    phi_596_ = _e263;
                }
                let _e355 = phi_596_;
                if (_e351 > _e355) {
                    phi_601_ = _e351;
                } else {
                    phi_601_ = _e355;
                }
                let _e358 = phi_601_;
                if (_e264 < 0f) {
                    phi_607_ = -(_e264);
                } else {
                    phi_607_ = _e264;
                }
                let _e362 = phi_607_;
                if (_e358 > _e362) {
                    phi_612_ = _e358;
                } else {
                    phi_612_ = _e362;
                }
                let _e365 = phi_612_;
                if (_e347 > _e365) {
                    phi_617_ = _e347;
                } else {
                    phi_617_ = _e365;
                }
                let _e368 = phi_617_;
                let _e369 = (_e368 + _e276);
                if (_e267 < 0f) {
                    phi_624_ = -(_e267);
                } else {
                    phi_624_ = _e267;
                }
                let _e373 = phi_624_;
                if (_e268 < 0f) {
                    phi_630_ = -(_e268);
                } else {
                    phi_630_ = _e268;
                }
                let _e377 = phi_630_;
                if (_e373 > _e377) {
                    phi_635_ = _e373;
                } else {
                    phi_635_ = _e377;
                }
                let _e380 = phi_635_;
                if (_e269 < 0f) {
                    phi_641_ = -(_e269);
                } else {
                    phi_641_ = _e269;
                }
                let _e384 = phi_641_;
                if (_e380 > _e384) {
                    phi_646_ = _e380;
                } else {
                    phi_646_ = _e384;
                }
                let _e387 = phi_646_;
                if (_e271 < 0f) {
                    phi_652_ = -(_e271);
                } else {
                    phi_652_ = _e271;
                }
                let _e391 = phi_652_;
                if (_e272 < 0f) {
                    phi_658_ = -(_e272);
                } else {
                    phi_658_ = _e272;
                }
                let _e395 = phi_658_;
                if (_e391 > _e395) {
                    phi_663_ = _e391;
                } else {
                    phi_663_ = _e395;
                }
                let _e398 = phi_663_;
                if (_e273 < 0f) {
                    phi_669_ = -(_e273);
                } else {
                    phi_669_ = _e273;
                }
                let _e402 = phi_669_;
                if (_e398 > _e402) {
                    phi_674_ = _e398;
                } else {
                    phi_674_ = _e402;
                }
                let _e405 = phi_674_;
                if (_e387 > _e405) {
                    phi_679_ = _e387;
                } else {
                    phi_679_ = _e405;
                }
                let _e408 = phi_679_;
                let _e409 = (_e408 + _e276);
                if (_e329 > _e369) {
                    phi_685_ = _e329;
                } else {
                    phi_685_ = _e369;
                }
                let _e412 = phi_685_;
                if (_e412 > _e409) {
                    phi_690_ = _e412;
                } else {
                    phi_690_ = _e409;
                }
                let _e415 = phi_690_;
                if (_e415 <= 65536f) {
                    phi_697_ = (_e415 >= (1f / 65536f));
                } else {
                    phi_697_ = false;
                }
                let _e420 = phi_697_;
                if _e420 {
                    phi_768_ = type_38();
                    phi_769_ = true;
                } else {
                    if (_e415 >= 0.000000000000000000000000000000000000011754944f) {
                        if ((bitcast<u32>(_e415) & 2139095040u) != 2139095040u) {
                            let _e427 = (2130706432u - (bitcast<u32>(_e415) & 2139095040u));
                            if (_e427 > 8388608u) {
                                phi_721_ = _e427;
                            } else {
                                phi_721_ = 8388608u;
                            }
                            let _e430 = phi_721_;
                            let _e431 = bitcast<f32>(_e430);
                            let _e432 = (_e279 * _e431);
                            if (_e279 > 0f) {
                                if (_e432 > 0.000000000000000000000000000000000000011754944f) {
                                    phi_732_ = _e432;
                                } else {
                                    phi_732_ = 0.000000000000000000000000000000000000011754944f;
                                }
                                let _e436 = phi_732_;
                                phi_733_ = _e436;
                            } else {
                                phi_733_ = _e432;
                            }
                            let _e438 = phi_733_;
                            phi_764_ = type_38(type_25(array<array<f32, 3>, 2>(array<f32, 3>((_e249 * _e431), (_e250 * _e431), (_e251 * _e431)), array<f32, 3>((_e253 * _e431), (_e254 * _e431), (_e255 * _e431))), array<array<f32, 3>, 2>(array<f32, 3>((_e258 * _e431), (_e259 * _e431), (_e260 * _e431)), array<f32, 3>((_e262 * _e431), (_e263 * _e431), (_e264 * _e431))), array<array<f32, 3>, 2>(array<f32, 3>((_e267 * _e431), (_e268 * _e431), (_e269 * _e431)), array<f32, 3>((_e271 * _e431), (_e272 * _e431), (_e273 * _e431))), (_e276 * _e431)), _e438);
                            phi_765_ = false;
                        } else {
                            phi_764_ = type_38();
                            phi_765_ = true;
                        }
                        let _e470 = phi_764_;
                        let _e472 = phi_765_;
                        phi_766_ = _e470;
                        phi_767_ = _e472;
                    } else {
                        phi_766_ = type_38();
                        phi_767_ = true;
                    }
                    let _e474 = phi_766_;
                    let _e476 = phi_767_;
                    phi_768_ = _e474;
                    phi_769_ = _e476;
                }
                let _e478 = phi_768_;
                let _e480 = phi_769_;
                if _e480 {
                    phi_774_ = type_38(type_25(array<array<f32, 3>, 2>(array<f32, 3>(_e249, _e250, _e251), array<f32, 3>(_e253, _e254, _e255)), array<array<f32, 3>, 2>(array<f32, 3>(_e258, _e259, _e260), array<f32, 3>(_e262, _e263, _e264)), array<array<f32, 3>, 2>(array<f32, 3>(_e267, _e268, _e269), array<f32, 3>(_e271, _e272, _e273)), _e276), _e279);
                } else {
                    phi_774_ = _e478;
                }
                let _e483 = phi_774_;
                local_18 = type_25(array<array<f32, 3>, 2>(array<f32, 3>(_e483.member.member[0][0], _e483.member.member[0][1], _e483.member.member[0][2]), array<f32, 3>(_e483.member.member[1][0], _e483.member.member[1][1], _e483.member.member[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e483.member.member_1[0][0], _e483.member.member_1[0][1], _e483.member.member_1[0][2]), array<f32, 3>(_e483.member.member_1[1][0], _e483.member.member_1[1][1], _e483.member.member_1[1][2])), array<array<f32, 3>, 2>(array<f32, 3>(_e483.member.member_2[0][0], _e483.member.member_2[0][1], _e483.member.member_2[0][2]), array<f32, 3>(_e483.member.member_2[1][0], _e483.member.member_2[1][1], _e483.member.member_2[1][2])), _e483.member.member_3);
                if (_e483.member_1 > 0f) {
                    let _e5168 = local_18.member[0u];
                    let _e5174 = local_18.member[1u];
                    let _e5190 = local_18.member_1[0u];
                    let _e5196 = local_18.member_1[1u];
                    let _e5212 = local_18.member_2[0u];
                    let _e5218 = local_18.member_2[1u];
                    let _e5232 = function_3(array<f32, 3>((_e5168[0] + ((_e5174[0] - _e5168[0]) * _e283)), (_e5168[1] + ((_e5174[1] - _e5168[1]) * _e283)), (_e5168[2] + ((_e5174[2] - _e5168[2]) * _e283))), array<f32, 3>((_e5190[0] + ((_e5196[0] - _e5190[0]) * _e283)), (_e5190[1] + ((_e5196[1] - _e5190[1]) * _e283)), (_e5190[2] + ((_e5196[2] - _e5190[2]) * _e283))), array<f32, 3>((_e5212[0] + ((_e5218[0] - _e5212[0]) * _e283)), (_e5212[1] + ((_e5218[1] - _e5212[1]) * _e283)), (_e5212[2] + ((_e5218[2] - _e5212[2]) * _e283))), 1u);
                    let _e5243 = (((_e5232[0] * _e5232[0]) + (_e5232[1] * _e5232[1])) + (_e5232[2] * _e5232[2]));
                    if (_e5243 <= 0.000000000000000000000000000000000000011754944f) {
                        if (_e5243 > 0f) {
                            phi_941_ = (0.000000000000000000106433627f * 2f);
                        } else {
                            phi_941_ = 0f;
                        }
                        let _e5296 = phi_941_;
                        phi_1005_ = _e5296;
                    } else {
                        phi_948_ = type_14(0i, 5i);
                        phi_951_ = bitcast<f32>(((bitcast<u32>(_e5243) >> bitcast<u32>(1i)) + 532369198u));
                        loop {
                            let _e5251 = phi_948_;
                            let _e5253 = phi_951_;
                            local_39 = _e5253;
                            if (_e5251.member < _e5251.member_1) {
                                let _e5260 = (_e5251.member + 1i);
                                if ((false == (_e5260 > _e5251.member)) != false) {
                                    phi_972_ = true;
                                } else {
                                    phi_972_ = false;
                                }
                                let _e5265 = phi_972_;
                                if _e5265 {
                                    phi_978_ = type_15(0u, type_15().member_1);
                                } else {
                                    phi_978_ = type_15(1u, _e5260);
                                }
                                let _e5270 = phi_978_;
                                phi_949_ = type_14(_e5270.member_1, _e5251.member_1);
                                phi_992_ = type_15(1u, _e5251.member);
                            } else {
                                phi_949_ = _e5251;
                                phi_992_ = type_15(0u, type_15().member_1);
                            }
                            let _e5276 = phi_949_;
                            let _e5278 = phi_992_;
                            let _e5281 = (bitcast<i32>(_e5278.member) != 0i);
                            if _e5281 {
                                phi_952_ = (0.5f * (_e5253 + (_e5243 / _e5253)));
                            } else {
                                phi_952_ = f32();
                            }
                            let _e5286 = phi_952_;
                            continue;
                            continuing {
                                phi_948_ = _e5276;
                                phi_951_ = _e5286;
                                break if !(_e5281);
                            }
                        }
                        let _e5291 = local_39;
                        phi_1005_ = (_e5291 * (1f + (8f * 0.000000059604645f)));
                    }
                    let _e5298 = phi_1005_;
                    let _e5304 = local_18.member[0u];
                    if (_e5304[0] < 0f) {
                        phi_1021_ = -(_e5304[0]);
                    } else {
                        phi_1021_ = _e5304[0];
                    }
                    let _e5311 = phi_1021_;
                    if (_e5304[1] < 0f) {
                        phi_1028_ = -(_e5304[1]);
                    } else {
                        phi_1028_ = _e5304[1];
                    }
                    let _e5315 = phi_1028_;
                    if (_e5311 > _e5315) {
                        phi_1033_ = _e5311;
                    } else {
                        phi_1033_ = _e5315;
                    }
                    let _e5318 = phi_1033_;
                    if (_e5304[2] < 0f) {
                        phi_1040_ = -(_e5304[2]);
                    } else {
                        phi_1040_ = _e5304[2];
                    }
                    let _e5322 = phi_1040_;
                    if (_e5318 > _e5322) {
                        phi_1045_ = _e5318;
                    } else {
                        phi_1045_ = _e5322;
                    }
                    let _e5325 = phi_1045_;
                    let _e5328 = local_18.member[1u];
                    if (_e5328[0] < 0f) {
                        phi_1058_ = -(_e5328[0]);
                    } else {
                        phi_1058_ = _e5328[0];
                    }
                    let _e5335 = phi_1058_;
                    if (_e5328[1] < 0f) {
                        phi_1065_ = -(_e5328[1]);
                    } else {
                        phi_1065_ = _e5328[1];
                    }
                    let _e5339 = phi_1065_;
                    if (_e5335 > _e5339) {
                        phi_1070_ = _e5335;
                    } else {
                        phi_1070_ = _e5339;
                    }
                    let _e5342 = phi_1070_;
                    if (_e5328[2] < 0f) {
                        phi_1077_ = -(_e5328[2]);
                    } else {
                        phi_1077_ = _e5328[2];
                    }
                    let _e5346 = phi_1077_;
                    if (_e5342 > _e5346) {
                        phi_1082_ = _e5342;
                    } else {
                        phi_1082_ = _e5346;
                    }
                    let _e5349 = phi_1082_;
                    if (_e5325 > _e5349) {
                        phi_1087_ = _e5325;
                    } else {
                        phi_1087_ = _e5349;
                    }
                    let _e5352 = phi_1087_;
                    let _e5354 = local_18.member_3;
                    let _e5358 = local_18.member_1[0u];
                    if (_e5358[0] < 0f) {
                        phi_1104_ = -(_e5358[0]);
                    } else {
                        phi_1104_ = _e5358[0];
                    }
                    let _e5365 = phi_1104_;
                    if (_e5358[1] < 0f) {
                        phi_1111_ = -(_e5358[1]);
                    } else {
                        phi_1111_ = _e5358[1];
                    }
                    let _e5369 = phi_1111_;
                    if (_e5365 > _e5369) {
                        phi_1116_ = _e5365;
                    } else {
                        phi_1116_ = _e5369;
                    }
                    let _e5372 = phi_1116_;
                    if (_e5358[2] < 0f) {
                        phi_1123_ = -(_e5358[2]);
                    } else {
                        phi_1123_ = _e5358[2];
                    }
                    let _e5376 = phi_1123_;
                    if (_e5372 > _e5376) {
                        phi_1128_ = _e5372;
                    } else {
                        phi_1128_ = _e5376;
                    }
                    let _e5379 = phi_1128_;
                    let _e5382 = local_18.member_1[1u];
                    if (_e5382[0] < 0f) {
                        phi_1142_ = -(_e5382[0]);
                    } else {
                        phi_1142_ = _e5382[0];
                    }
                    let _e5389 = phi_1142_;
                    if (_e5382[1] < 0f) {
                        phi_1149_ = -(_e5382[1]);
                    } else {
                        phi_1149_ = _e5382[1];
                    }
                    let _e5393 = phi_1149_;
                    if (_e5389 > _e5393) {
                        phi_1154_ = _e5389;
                    } else {
                        phi_1154_ = _e5393;
                    }
                    let _e5396 = phi_1154_;
                    if (_e5382[2] < 0f) {
                        phi_1161_ = -(_e5382[2]);
                    } else {
                        phi_1161_ = _e5382[2];
                    }
                    let _e5400 = phi_1161_;
                    if (_e5396 > _e5400) {
                        phi_1166_ = _e5396;
                    } else {
                        phi_1166_ = _e5400;
                    }
                    let _e5403 = phi_1166_;
                    if (_e5379 > _e5403) {
                        phi_1171_ = _e5379;
                    } else {
                        phi_1171_ = _e5403;
                    }
                    let _e5406 = phi_1171_;
                    let _e5408 = local_18.member_3;
                    let _e5412 = local_18.member_2[0u];
                    if (_e5412[0] < 0f) {
                        phi_1188_ = -(_e5412[0]);
                    } else {
                        phi_1188_ = _e5412[0];
                    }
                    let _e5419 = phi_1188_;
                    if (_e5412[1] < 0f) {
                        phi_1195_ = -(_e5412[1]);
                    } else {
                        phi_1195_ = _e5412[1];
                    }
                    let _e5423 = phi_1195_;
                    if (_e5419 > _e5423) {
                        phi_1200_ = _e5419;
                    } else {
                        phi_1200_ = _e5423;
                    }
                    let _e5426 = phi_1200_;
                    if (_e5412[2] < 0f) {
                        phi_1207_ = -(_e5412[2]);
                    } else {
                        phi_1207_ = _e5412[2];
                    }
                    let _e5430 = phi_1207_;
                    if (_e5426 > _e5430) {
                        phi_1212_ = _e5426;
                    } else {
                        phi_1212_ = _e5430;
                    }
                    let _e5433 = phi_1212_;
                    let _e5436 = local_18.member_2[1u];
                    if (_e5436[0] < 0f) {
                        phi_1226_ = -(_e5436[0]);
                    } else {
                        phi_1226_ = _e5436[0];
                    }
                    let _e5443 = phi_1226_;
                    if (_e5436[1] < 0f) {
                        phi_1233_ = -(_e5436[1]);
                    } else {
                        phi_1233_ = _e5436[1];
                    }
                    let _e5447 = phi_1233_;
                    if (_e5443 > _e5447) {
                        phi_1238_ = _e5443;
                    } else {
                        phi_1238_ = _e5447;
                    }
                    let _e5450 = phi_1238_;
                    if (_e5436[2] < 0f) {
                        phi_1245_ = -(_e5436[2]);
                    } else {
                        phi_1245_ = _e5436[2];
                    }
                    let _e5454 = phi_1245_;
                    if (_e5450 > _e5454) {
                        phi_1250_ = _e5450;
                    } else {
                        phi_1250_ = _e5454;
                    }
                    let _e5457 = phi_1250_;
                    if (_e5433 > _e5457) {
                        phi_1255_ = _e5433;
                    } else {
                        phi_1255_ = _e5457;
                    }
                    let _e5460 = phi_1255_;
                    let _e5462 = local_18.member_3;
                    let _e5469 = local_18.member_3;
                    let _e5476 = (((_e5298 * (1f + (0.000000059604645f * 8f))) + (((((((_e5352 + _e5354) + (_e5406 + _e5408)) + (_e5460 + _e5462)) * (0.000000059604645f * 16f)) + (_e5469 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e483.member_1);
                    if _e5476 {
                        phi_1916_ = type_39();
                        phi_1917_ = true;
                    } else {
                        let _e5479 = local_18.member_1[0u];
                        let _e5485 = local_18.member_2[0u];
                        let _e5491 = ((_e5479[1] * _e5485[2]) - (_e5479[2] * _e5485[1]));
                        let _e5494 = ((_e5479[2] * _e5485[0]) - (_e5479[0] * _e5485[2]));
                        let _e5497 = ((_e5479[0] * _e5485[1]) - (_e5479[1] * _e5485[0]));
                        let _e5500 = local_18.member_1[1u];
                        let _e5506 = local_18.member_2[1u];
                        let _e5512 = ((_e5500[1] * _e5506[2]) - (_e5500[2] * _e5506[1]));
                        let _e5515 = ((_e5500[2] * _e5506[0]) - (_e5500[0] * _e5506[2]));
                        let _e5518 = ((_e5500[0] * _e5506[1]) - (_e5500[1] * _e5506[0]));
                        let _e5521 = local_18.member_1[0u];
                        let _e5527 = local_18.member_2[1u];
                        let _e5542 = local_18.member_1[1u];
                        let _e5548 = local_18.member_2[0u];
                        let _e5561 = (((_e5521[1] * _e5527[2]) - (_e5521[2] * _e5527[1])) + ((_e5542[1] * _e5548[2]) - (_e5542[2] * _e5548[1])));
                        let _e5562 = (((_e5521[2] * _e5527[0]) - (_e5521[0] * _e5527[2])) + ((_e5542[2] * _e5548[0]) - (_e5542[0] * _e5548[2])));
                        let _e5563 = (((_e5521[0] * _e5527[1]) - (_e5521[1] * _e5527[0])) + ((_e5542[0] * _e5548[1]) - (_e5542[1] * _e5548[0])));
                        let _e5566 = local_18.member[0u];
                        let _e5577 = local_18.member[1u];
                        let _e5588 = local_18.member[0u];
                        let _e5597 = ((((_e5577[0] * _e5491) + (_e5577[1] * _e5494)) + (_e5577[2] * _e5497)) + (((_e5588[0] * _e5561) + (_e5588[1] * _e5562)) + (_e5588[2] * _e5563)));
                        let _e5600 = local_18.member[0u];
                        let _e5611 = local_18.member[1u];
                        let _e5620 = ((((_e5600[0] * _e5512) + (_e5600[1] * _e5515)) + (_e5600[2] * _e5518)) + (((_e5611[0] * _e5561) + (_e5611[1] * _e5562)) + (_e5611[2] * _e5563)));
                        let _e5623 = local_18.member[1u];
                        let _e5634 = local_18.member[0u];
                        if (_e5634[0] < 0f) {
                            phi_1516_ = -(_e5634[0]);
                        } else {
                            phi_1516_ = _e5634[0];
                        }
                        let _e5641 = phi_1516_;
                        if (_e5634[1] < 0f) {
                            phi_1523_ = -(_e5634[1]);
                        } else {
                            phi_1523_ = _e5634[1];
                        }
                        let _e5645 = phi_1523_;
                        if (_e5641 > _e5645) {
                            phi_1528_ = _e5641;
                        } else {
                            phi_1528_ = _e5645;
                        }
                        let _e5648 = phi_1528_;
                        if (_e5634[2] < 0f) {
                            phi_1535_ = -(_e5634[2]);
                        } else {
                            phi_1535_ = _e5634[2];
                        }
                        let _e5652 = phi_1535_;
                        if (_e5648 > _e5652) {
                            phi_1540_ = _e5648;
                        } else {
                            phi_1540_ = _e5652;
                        }
                        let _e5655 = phi_1540_;
                        let _e5658 = local_18.member[1u];
                        if (_e5658[0] < 0f) {
                            phi_1553_ = -(_e5658[0]);
                        } else {
                            phi_1553_ = _e5658[0];
                        }
                        let _e5665 = phi_1553_;
                        if (_e5658[1] < 0f) {
                            phi_1560_ = -(_e5658[1]);
                        } else {
                            phi_1560_ = _e5658[1];
                        }
                        let _e5669 = phi_1560_;
                        if (_e5665 > _e5669) {
                            phi_1565_ = _e5665;
                        } else {
                            phi_1565_ = _e5669;
                        }
                        let _e5672 = phi_1565_;
                        if (_e5658[2] < 0f) {
                            phi_1572_ = -(_e5658[2]);
                        } else {
                            phi_1572_ = _e5658[2];
                        }
                        let _e5676 = phi_1572_;
                        if (_e5672 > _e5676) {
                            phi_1577_ = _e5672;
                        } else {
                            phi_1577_ = _e5676;
                        }
                        let _e5679 = phi_1577_;
                        if (_e5655 > _e5679) {
                            phi_1582_ = _e5655;
                        } else {
                            phi_1582_ = _e5679;
                        }
                        let _e5682 = phi_1582_;
                        let _e5684 = local_18.member_3;
                        let _e5685 = (_e5682 + _e5684);
                        let _e5688 = local_18.member_1[0u];
                        if (_e5688[0] < 0f) {
                            phi_1599_ = -(_e5688[0]);
                        } else {
                            phi_1599_ = _e5688[0];
                        }
                        let _e5695 = phi_1599_;
                        if (_e5688[1] < 0f) {
                            phi_1606_ = -(_e5688[1]);
                        } else {
                            phi_1606_ = _e5688[1];
                        }
                        let _e5699 = phi_1606_;
                        if (_e5695 > _e5699) {
                            phi_1611_ = _e5695;
                        } else {
                            phi_1611_ = _e5699;
                        }
                        let _e5702 = phi_1611_;
                        if (_e5688[2] < 0f) {
                            phi_1618_ = -(_e5688[2]);
                        } else {
                            phi_1618_ = _e5688[2];
                        }
                        let _e5706 = phi_1618_;
                        if (_e5702 > _e5706) {
                            phi_1623_ = _e5702;
                        } else {
                            phi_1623_ = _e5706;
                        }
                        let _e5709 = phi_1623_;
                        let _e5712 = local_18.member_1[1u];
                        if (_e5712[0] < 0f) {
                            phi_1637_ = -(_e5712[0]);
                        } else {
                            phi_1637_ = _e5712[0];
                        }
                        let _e5719 = phi_1637_;
                        if (_e5712[1] < 0f) {
                            phi_1644_ = -(_e5712[1]);
                        } else {
                            phi_1644_ = _e5712[1];
                        }
                        let _e5723 = phi_1644_;
                        if (_e5719 > _e5723) {
                            phi_1649_ = _e5719;
                        } else {
                            phi_1649_ = _e5723;
                        }
                        let _e5726 = phi_1649_;
                        if (_e5712[2] < 0f) {
                            phi_1656_ = -(_e5712[2]);
                        } else {
                            phi_1656_ = _e5712[2];
                        }
                        let _e5730 = phi_1656_;
                        if (_e5726 > _e5730) {
                            phi_1661_ = _e5726;
                        } else {
                            phi_1661_ = _e5730;
                        }
                        let _e5733 = phi_1661_;
                        if (_e5709 > _e5733) {
                            phi_1666_ = _e5709;
                        } else {
                            phi_1666_ = _e5733;
                        }
                        let _e5736 = phi_1666_;
                        let _e5738 = local_18.member_3;
                        let _e5739 = (_e5736 + _e5738);
                        let _e5742 = local_18.member_2[0u];
                        if (_e5742[0] < 0f) {
                            phi_1683_ = -(_e5742[0]);
                        } else {
                            phi_1683_ = _e5742[0];
                        }
                        let _e5749 = phi_1683_;
                        if (_e5742[1] < 0f) {
                            phi_1690_ = -(_e5742[1]);
                        } else {
                            phi_1690_ = _e5742[1];
                        }
                        let _e5753 = phi_1690_;
                        if (_e5749 > _e5753) {
                            phi_1695_ = _e5749;
                        } else {
                            phi_1695_ = _e5753;
                        }
                        let _e5756 = phi_1695_;
                        if (_e5742[2] < 0f) {
                            phi_1702_ = -(_e5742[2]);
                        } else {
                            phi_1702_ = _e5742[2];
                        }
                        let _e5760 = phi_1702_;
                        if (_e5756 > _e5760) {
                            phi_1707_ = _e5756;
                        } else {
                            phi_1707_ = _e5760;
                        }
                        let _e5763 = phi_1707_;
                        let _e5766 = local_18.member_2[1u];
                        if (_e5766[0] < 0f) {
                            phi_1721_ = -(_e5766[0]);
                        } else {
                            phi_1721_ = _e5766[0];
                        }
                        let _e5773 = phi_1721_;
                        if (_e5766[1] < 0f) {
                            phi_1728_ = -(_e5766[1]);
                        } else {
                            phi_1728_ = _e5766[1];
                        }
                        let _e5777 = phi_1728_;
                        if (_e5773 > _e5777) {
                            phi_1733_ = _e5773;
                        } else {
                            phi_1733_ = _e5777;
                        }
                        let _e5780 = phi_1733_;
                        if (_e5766[2] < 0f) {
                            phi_1740_ = -(_e5766[2]);
                        } else {
                            phi_1740_ = _e5766[2];
                        }
                        let _e5784 = phi_1740_;
                        if (_e5780 > _e5784) {
                            phi_1745_ = _e5780;
                        } else {
                            phi_1745_ = _e5784;
                        }
                        let _e5787 = phi_1745_;
                        if (_e5763 > _e5787) {
                            phi_1750_ = _e5763;
                        } else {
                            phi_1750_ = _e5787;
                        }
                        let _e5790 = phi_1750_;
                        let _e5792 = local_18.member_3;
                        let _e5793 = (_e5790 + _e5792);
                        let _e5795 = ((_e5739 * 8f) * _e5793);
                        let _e5802 = local_18.member_3;
                        if (_e5491 < 0f) {
                            phi_1781_ = -(_e5491);
                        } else {
                            phi_1781_ = _e5491;
                        }
                        let _e5819 = phi_1781_;
                        if (_e5494 < 0f) {
                            phi_1787_ = -(_e5494);
                        } else {
                            phi_1787_ = _e5494;
                        }
                        let _e5823 = phi_1787_;
                        if (_e5497 < 0f) {
                            phi_1794_ = -(_e5497);
                        } else {
                            phi_1794_ = _e5497;
                        }
                        let _e5828 = phi_1794_;
                        let _e5829 = ((_e5819 + _e5823) + _e5828);
                        if (_e5512 < 0f) {
                            phi_1801_ = -(_e5512);
                        } else {
                            phi_1801_ = _e5512;
                        }
                        let _e5833 = phi_1801_;
                        if (_e5515 < 0f) {
                            phi_1807_ = -(_e5515);
                        } else {
                            phi_1807_ = _e5515;
                        }
                        let _e5837 = phi_1807_;
                        if (_e5518 < 0f) {
                            phi_1814_ = -(_e5518);
                        } else {
                            phi_1814_ = _e5518;
                        }
                        let _e5842 = phi_1814_;
                        let _e5843 = ((_e5833 + _e5837) + _e5842);
                        if (_e5829 > _e5843) {
                            phi_1820_ = _e5829;
                        } else {
                            phi_1820_ = _e5843;
                        }
                        let _e5846 = phi_1820_;
                        if (_e5561 < 0f) {
                            phi_1826_ = -(_e5561);
                        } else {
                            phi_1826_ = _e5561;
                        }
                        let _e5850 = phi_1826_;
                        if (_e5562 < 0f) {
                            phi_1832_ = -(_e5562);
                        } else {
                            phi_1832_ = _e5562;
                        }
                        let _e5854 = phi_1832_;
                        if (_e5563 < 0f) {
                            phi_1839_ = -(_e5563);
                        } else {
                            phi_1839_ = _e5563;
                        }
                        let _e5859 = phi_1839_;
                        let _e5861 = (((_e5850 + _e5854) + _e5859) * 0.5f);
                        if (_e5846 > _e5861) {
                            phi_1846_ = _e5846;
                        } else {
                            phi_1846_ = _e5861;
                        }
                        let _e5864 = phi_1846_;
                        let _e5869 = local_18.member_3;
                        let _e5882 = ((((_e5566[0] * _e5491) + (_e5566[1] * _e5494)) + (_e5566[2] * _e5497)) * 3f);
                        let _e5883 = ((((_e5623[0] * _e5512) + (_e5623[1] * _e5515)) + (_e5623[2] * _e5518)) * 3f);
                        if (_e5882 < _e5883) {
                            phi_1870_ = _e5882;
                        } else {
                            phi_1870_ = _e5883;
                        }
                        let _e5886 = phi_1870_;
                        if (_e5597 < _e5620) {
                            phi_1875_ = _e5597;
                        } else {
                            phi_1875_ = _e5620;
                        }
                        let _e5889 = phi_1875_;
                        if (_e5886 < _e5889) {
                            phi_1880_ = _e5886;
                        } else {
                            phi_1880_ = _e5889;
                        }
                        let _e5892 = phi_1880_;
                        if (_e5882 > _e5883) {
                            phi_1885_ = _e5882;
                        } else {
                            phi_1885_ = _e5883;
                        }
                        let _e5895 = phi_1885_;
                        if (_e5597 > _e5620) {
                            phi_1890_ = _e5597;
                        } else {
                            phi_1890_ = _e5620;
                        }
                        let _e5898 = phi_1890_;
                        if (_e5895 > _e5898) {
                            phi_1895_ = _e5895;
                        } else {
                            phi_1895_ = _e5898;
                        }
                        let _e5901 = phi_1895_;
                        let _e5906 = -(_e5901);
                        if (_e5892 > _e5906) {
                            phi_1905_ = _e5892;
                        } else {
                            phi_1905_ = _e5906;
                        }
                        let _e5909 = phi_1905_;
                        if ((_e5909 - ((((((_e5685 * 8f) * _e5795) * (0.000000059604645f * (524f / 64f))) + ((_e5802 * 19f) * ((_e5685 * (_e5739 + _e5793)) + (_e5739 * _e5793)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e5685) * ((1f + _e5739) * (1f + _e5793))))) + ((_e483.member_1 * (((_e5864 + (_e5795 * (0.000000059604645f * 8f))) + ((_e5869 * 6f) * (_e5739 + _e5793))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e5739) * (1f + _e5793))))) * (3f * 1.0001f)))) > 0f) {
                            phi_1914_ = type_39(type_30(0u, f32()), 0u);
                            phi_1915_ = false;
                        } else {
                            phi_1914_ = type_39();
                            phi_1915_ = true;
                        }
                        let _e5915 = phi_1914_;
                        let _e5917 = phi_1915_;
                        phi_1916_ = _e5915;
                        phi_1917_ = _e5917;
                    }
                    let _e5919 = phi_1916_;
                    let _e5921 = phi_1917_;
                    if _e5921 {
                        phi_1923_ = type_14(0i, 2i);
                        phi_1926_ = _e283;
                        phi_1928_ = 0u;
                        phi_1930_ = _e283;
                        loop {
                            let _e5923 = phi_1923_;
                            let _e5925 = phi_1926_;
                            let _e5927 = phi_1928_;
                            let _e5929 = phi_1930_;
                            local_96 = _e5927;
                            local_99 = _e5925;
                            local_100 = _e5927;
                            if (_e5923.member < _e5923.member_1) {
                                let _e5936 = (_e5923.member + 1i);
                                if ((false == (_e5936 > _e5923.member)) != false) {
                                    phi_1951_ = true;
                                } else {
                                    phi_1951_ = false;
                                }
                                let _e5941 = phi_1951_;
                                if _e5941 {
                                    phi_1957_ = type_15(0u, type_15().member_1);
                                } else {
                                    phi_1957_ = type_15(1u, _e5936);
                                }
                                let _e5946 = phi_1957_;
                                phi_1924_ = type_14(_e5946.member_1, _e5923.member_1);
                                phi_1971_ = type_15(1u, _e5923.member);
                            } else {
                                phi_1924_ = _e5923;
                                phi_1971_ = type_15(0u, type_15().member_1);
                            }
                            let _e5952 = phi_1924_;
                            let _e5954 = phi_1971_;
                            if (bitcast<i32>(_e5954.member) != 0i) {
                                if (_e5954.member_1 > 0i) {
                                    phi_1987_ = true;
                                } else {
                                    if _e5476 {
                                        phi_1986_ = false;
                                    } else {
                                        phi_1986_ = true;
                                    }
                                    let _e5961 = phi_1986_;
                                    phi_1987_ = _e5961;
                                }
                                let _e5963 = phi_1987_;
                                if _e5963 {
                                    let _e5966 = local_18.member[0u];
                                    let _e5972 = local_18.member_1[0u];
                                    let _e5978 = local_18.member_2[0u];
                                    let _e5982 = (_e5966[0] - _e5972[0]);
                                    let _e5983 = (_e5966[1] - _e5972[1]);
                                    let _e5984 = (_e5966[2] - _e5972[2]);
                                    let _e5993 = local_18.member[1u];
                                    let _e5999 = local_18.member_1[1u];
                                    let _e6005 = local_18.member_2[1u];
                                    let _e6009 = (_e5993[0] - _e5999[0]);
                                    let _e6010 = (_e5993[1] - _e5999[1]);
                                    let _e6011 = (_e5993[2] - _e5999[2]);
                                    let _e6020 = local_18.member[0u];
                                    if (_e6020[0] < 0f) {
                                        phi_2133_ = -(_e6020[0]);
                                    } else {
                                        phi_2133_ = _e6020[0];
                                    }
                                    let _e6027 = phi_2133_;
                                    if (_e6020[1] < 0f) {
                                        phi_2140_ = -(_e6020[1]);
                                    } else {
                                        phi_2140_ = _e6020[1];
                                    }
                                    let _e6031 = phi_2140_;
                                    if (_e6027 > _e6031) {
                                        phi_2145_ = _e6027;
                                    } else {
                                        phi_2145_ = _e6031;
                                    }
                                    let _e6034 = phi_2145_;
                                    if (_e6020[2] < 0f) {
                                        phi_2152_ = -(_e6020[2]);
                                    } else {
                                        phi_2152_ = _e6020[2];
                                    }
                                    let _e6038 = phi_2152_;
                                    if (_e6034 > _e6038) {
                                        phi_2157_ = _e6034;
                                    } else {
                                        phi_2157_ = _e6038;
                                    }
                                    let _e6041 = phi_2157_;
                                    let _e6044 = local_18.member[1u];
                                    if (_e6044[0] < 0f) {
                                        phi_2170_ = -(_e6044[0]);
                                    } else {
                                        phi_2170_ = _e6044[0];
                                    }
                                    let _e6051 = phi_2170_;
                                    if (_e6044[1] < 0f) {
                                        phi_2177_ = -(_e6044[1]);
                                    } else {
                                        phi_2177_ = _e6044[1];
                                    }
                                    let _e6055 = phi_2177_;
                                    if (_e6051 > _e6055) {
                                        phi_2182_ = _e6051;
                                    } else {
                                        phi_2182_ = _e6055;
                                    }
                                    let _e6058 = phi_2182_;
                                    if (_e6044[2] < 0f) {
                                        phi_2189_ = -(_e6044[2]);
                                    } else {
                                        phi_2189_ = _e6044[2];
                                    }
                                    let _e6062 = phi_2189_;
                                    if (_e6058 > _e6062) {
                                        phi_2194_ = _e6058;
                                    } else {
                                        phi_2194_ = _e6062;
                                    }
                                    let _e6065 = phi_2194_;
                                    if (_e6041 > _e6065) {
                                        phi_2199_ = _e6041;
                                    } else {
                                        phi_2199_ = _e6065;
                                    }
                                    let _e6068 = phi_2199_;
                                    let _e6070 = local_18.member_3;
                                    let _e6074 = local_18.member_1[0u];
                                    if (_e6074[0] < 0f) {
                                        phi_2216_ = -(_e6074[0]);
                                    } else {
                                        phi_2216_ = _e6074[0];
                                    }
                                    let _e6081 = phi_2216_;
                                    if (_e6074[1] < 0f) {
                                        phi_2223_ = -(_e6074[1]);
                                    } else {
                                        phi_2223_ = _e6074[1];
                                    }
                                    let _e6085 = phi_2223_;
                                    if (_e6081 > _e6085) {
                                        phi_2228_ = _e6081;
                                    } else {
                                        phi_2228_ = _e6085;
                                    }
                                    let _e6088 = phi_2228_;
                                    if (_e6074[2] < 0f) {
                                        phi_2235_ = -(_e6074[2]);
                                    } else {
                                        phi_2235_ = _e6074[2];
                                    }
                                    let _e6092 = phi_2235_;
                                    if (_e6088 > _e6092) {
                                        phi_2240_ = _e6088;
                                    } else {
                                        phi_2240_ = _e6092;
                                    }
                                    let _e6095 = phi_2240_;
                                    let _e6098 = local_18.member_1[1u];
                                    if (_e6098[0] < 0f) {
                                        phi_2254_ = -(_e6098[0]);
                                    } else {
                                        phi_2254_ = _e6098[0];
                                    }
                                    let _e6105 = phi_2254_;
                                    if (_e6098[1] < 0f) {
                                        phi_2261_ = -(_e6098[1]);
                                    } else {
                                        phi_2261_ = _e6098[1];
                                    }
                                    let _e6109 = phi_2261_;
                                    if (_e6105 > _e6109) {
                                        phi_2266_ = _e6105;
                                    } else {
                                        phi_2266_ = _e6109;
                                    }
                                    let _e6112 = phi_2266_;
                                    if (_e6098[2] < 0f) {
                                        phi_2273_ = -(_e6098[2]);
                                    } else {
                                        phi_2273_ = _e6098[2];
                                    }
                                    let _e6116 = phi_2273_;
                                    if (_e6112 > _e6116) {
                                        phi_2278_ = _e6112;
                                    } else {
                                        phi_2278_ = _e6116;
                                    }
                                    let _e6119 = phi_2278_;
                                    if (_e6095 > _e6119) {
                                        phi_2283_ = _e6095;
                                    } else {
                                        phi_2283_ = _e6119;
                                    }
                                    let _e6122 = phi_2283_;
                                    let _e6124 = local_18.member_3;
                                    let _e6128 = local_18.member_2[0u];
                                    if (_e6128[0] < 0f) {
                                        phi_2300_ = -(_e6128[0]);
                                    } else {
                                        phi_2300_ = _e6128[0];
                                    }
                                    let _e6135 = phi_2300_;
                                    if (_e6128[1] < 0f) {
                                        phi_2307_ = -(_e6128[1]);
                                    } else {
                                        phi_2307_ = _e6128[1];
                                    }
                                    let _e6139 = phi_2307_;
                                    if (_e6135 > _e6139) {
                                        phi_2312_ = _e6135;
                                    } else {
                                        phi_2312_ = _e6139;
                                    }
                                    let _e6142 = phi_2312_;
                                    if (_e6128[2] < 0f) {
                                        phi_2319_ = -(_e6128[2]);
                                    } else {
                                        phi_2319_ = _e6128[2];
                                    }
                                    let _e6146 = phi_2319_;
                                    if (_e6142 > _e6146) {
                                        phi_2324_ = _e6142;
                                    } else {
                                        phi_2324_ = _e6146;
                                    }
                                    let _e6149 = phi_2324_;
                                    let _e6152 = local_18.member_2[1u];
                                    if (_e6152[0] < 0f) {
                                        phi_2338_ = -(_e6152[0]);
                                    } else {
                                        phi_2338_ = _e6152[0];
                                    }
                                    let _e6159 = phi_2338_;
                                    if (_e6152[1] < 0f) {
                                        phi_2345_ = -(_e6152[1]);
                                    } else {
                                        phi_2345_ = _e6152[1];
                                    }
                                    let _e6163 = phi_2345_;
                                    if (_e6159 > _e6163) {
                                        phi_2350_ = _e6159;
                                    } else {
                                        phi_2350_ = _e6163;
                                    }
                                    let _e6166 = phi_2350_;
                                    if (_e6152[2] < 0f) {
                                        phi_2357_ = -(_e6152[2]);
                                    } else {
                                        phi_2357_ = _e6152[2];
                                    }
                                    let _e6170 = phi_2357_;
                                    if (_e6166 > _e6170) {
                                        phi_2362_ = _e6166;
                                    } else {
                                        phi_2362_ = _e6170;
                                    }
                                    let _e6173 = phi_2362_;
                                    if (_e6149 > _e6173) {
                                        phi_2367_ = _e6149;
                                    } else {
                                        phi_2367_ = _e6173;
                                    }
                                    let _e6176 = phi_2367_;
                                    let _e6178 = local_18.member_3;
                                    let _e6185 = local_18.member_3;
                                    let _e6190 = (_e281 * 0.00390625f);
                                    local_16 = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    phi_2408_ = type_12(0u, 96u);
                                    phi_2411_ = _e5929;
                                    phi_2413_ = _e5929;
                                    phi_2415_ = (_e285 - _e5929);
                                    phi_2417_ = _e5929;
                                    phi_2419_ = false;
                                    phi_2421_ = 0u;
                                    loop {
                                        let _e6193 = phi_2408_;
                                        let _e6195 = phi_2411_;
                                        let _e6197 = phi_2413_;
                                        let _e6199 = phi_2415_;
                                        let _e6201 = phi_2417_;
                                        let _e6203 = phi_2419_;
                                        let _e6205 = phi_2421_;
                                        local_43 = _e6195;
                                        local_86 = _e6197;
                                        if (_e6193.member < _e6193.member_1) {
                                            phi_2409_ = type_12((_e6193.member + 1u), _e6193.member_1);
                                            phi_2444_ = type_12(1u, _e6193.member);
                                        } else {
                                            phi_2409_ = _e6193;
                                            phi_2444_ = type_12(0u, type_12().member_1);
                                        }
                                        let _e6217 = phi_2409_;
                                        let _e6219 = phi_2444_;
                                        if (bitcast<i32>(_e6219.member) != 0i) {
                                            let _e6225 = local_18.member[0u];
                                            let _e6231 = local_18.member[1u];
                                            let _e6247 = local_18.member_1[0u];
                                            let _e6253 = local_18.member_1[1u];
                                            let _e6269 = local_18.member_2[0u];
                                            let _e6275 = local_18.member_2[1u];
                                            let _e6289 = function_3(array<f32, 3>((_e6225[0] + ((_e6231[0] - _e6225[0]) * _e6195)), (_e6225[1] + ((_e6231[1] - _e6225[1]) * _e6195)), (_e6225[2] + ((_e6231[2] - _e6225[2]) * _e6195))), array<f32, 3>((_e6247[0] + ((_e6253[0] - _e6247[0]) * _e6195)), (_e6247[1] + ((_e6253[1] - _e6247[1]) * _e6195)), (_e6247[2] + ((_e6253[2] - _e6247[2]) * _e6195))), array<f32, 3>((_e6269[0] + ((_e6275[0] - _e6269[0]) * _e6195)), (_e6269[1] + ((_e6275[1] - _e6269[1]) * _e6195)), (_e6269[2] + ((_e6275[2] - _e6269[2]) * _e6195))), 1u);
                                            if (_e6205 == 0u) {
                                                phi_2572_ = _e6289;
                                            } else {
                                                if (_e6205 == 1u) {
                                                    phi_2558_ = _e6289[0];
                                                } else {
                                                    phi_2558_ = 0f;
                                                }
                                                let _e6294 = phi_2558_;
                                                if (_e6205 == 2u) {
                                                    phi_2564_ = _e6289[1];
                                                } else {
                                                    phi_2564_ = 0f;
                                                }
                                                let _e6298 = phi_2564_;
                                                if (_e6205 == 3u) {
                                                    phi_2570_ = _e6289[2];
                                                } else {
                                                    phi_2570_ = 0f;
                                                }
                                                let _e6302 = phi_2570_;
                                                phi_2572_ = array<f32, 3>(_e6294, _e6298, _e6302);
                                            }
                                            let _e6305 = phi_2572_;
                                            if (_e6305[0] < 0f) {
                                                phi_2579_ = -(_e6305[0]);
                                            } else {
                                                phi_2579_ = _e6305[0];
                                            }
                                            let _e6310 = phi_2579_;
                                            if (_e6305[1] < 0f) {
                                                phi_2586_ = -(_e6305[1]);
                                            } else {
                                                phi_2586_ = _e6305[1];
                                            }
                                            let _e6315 = phi_2586_;
                                            if (_e6305[2] < 0f) {
                                                phi_2594_ = -(_e6305[2]);
                                            } else {
                                                phi_2594_ = _e6305[2];
                                            }
                                            let _e6321 = phi_2594_;
                                            let _e6322 = ((_e6310 + _e6315) + _e6321);
                                            if (_e6322 > 0f) {
                                                if ((bitcast<u32>(_e6322) & 2139095040u) != 2139095040u) {
                                                    let _e6327 = (1f / _e6322);
                                                    let _e6329 = (_e6305[0] * _e6327);
                                                    let _e6331 = (_e6305[1] * _e6327);
                                                    let _e6333 = (_e6305[2] * _e6327);
                                                    let _e6338 = (((_e6329 * _e6329) + (_e6331 * _e6331)) + (_e6333 * _e6333));
                                                    if (_e6338 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e6338 > 0f) {
                                                            phi_2631_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_2631_ = 0f;
                                                        }
                                                        let _e6391 = phi_2631_;
                                                        phi_2695_ = _e6391;
                                                    } else {
                                                        phi_2638_ = type_14(0i, 5i);
                                                        phi_2641_ = bitcast<f32>(((bitcast<u32>(_e6338) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e6346 = phi_2638_;
                                                            let _e6348 = phi_2641_;
                                                            local_40 = _e6348;
                                                            if (_e6346.member < _e6346.member_1) {
                                                                let _e6355 = (_e6346.member + 1i);
                                                                if ((false == (_e6355 > _e6346.member)) != false) {
                                                                    phi_2662_ = true;
                                                                } else {
                                                                    phi_2662_ = false;
                                                                }
                                                                let _e6360 = phi_2662_;
                                                                if _e6360 {
                                                                    phi_2668_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_2668_ = type_15(1u, _e6355);
                                                                }
                                                                let _e6365 = phi_2668_;
                                                                phi_2639_ = type_14(_e6365.member_1, _e6346.member_1);
                                                                phi_2682_ = type_15(1u, _e6346.member);
                                                            } else {
                                                                phi_2639_ = _e6346;
                                                                phi_2682_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e6371 = phi_2639_;
                                                            let _e6373 = phi_2682_;
                                                            let _e6376 = (bitcast<i32>(_e6373.member) != 0i);
                                                            if _e6376 {
                                                                phi_2642_ = (0.5f * (_e6348 + (_e6338 / _e6348)));
                                                            } else {
                                                                phi_2642_ = f32();
                                                            }
                                                            let _e6381 = phi_2642_;
                                                            continue;
                                                            continuing {
                                                                phi_2638_ = _e6371;
                                                                phi_2641_ = _e6381;
                                                                break if !(_e6376);
                                                            }
                                                        }
                                                        let _e6386 = local_40;
                                                        phi_2695_ = (_e6386 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e6393 = phi_2695_;
                                                    let _e6394 = (0.000000059604645f * 12f);
                                                    let _e6399 = ((((((((_e6068 + _e6070) + (_e6122 + _e6124)) + (_e6176 + _e6178)) * (0.000000059604645f * 16f)) + (_e6185 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((_e483.member_1 * _e6393) * (1f + _e6394)));
                                                    let _e6404 = (((_e6329 * _e5966[0]) + (_e6331 * _e5966[1])) + (_e6333 * _e5966[2]));
                                                    let _e6409 = (((_e6329 * _e5982) + (_e6331 * _e5983)) + (_e6333 * _e5984));
                                                    let _e6414 = (((_e6329 * (_e5966[0] - _e5978[0])) + (_e6331 * (_e5966[1] - _e5978[1]))) + (_e6333 * (_e5966[2] - _e5978[2])));
                                                    let _e6419 = (((_e6329 * (_e5982 - _e5978[0])) + (_e6331 * (_e5983 - _e5978[1]))) + (_e6333 * (_e5984 - _e5978[2])));
                                                    let _e6425 = (((_e6329 * _e5993[0]) + (_e6331 * _e5993[1])) + (_e6333 * _e5993[2]));
                                                    let _e6430 = (((_e6329 * _e6009) + (_e6331 * _e6010)) + (_e6333 * _e6011));
                                                    let _e6435 = (((_e6329 * (_e5993[0] - _e6005[0])) + (_e6331 * (_e5993[1] - _e6005[1]))) + (_e6333 * (_e5993[2] - _e6005[2])));
                                                    let _e6440 = (((_e6329 * (_e6009 - _e6005[0])) + (_e6331 * (_e6010 - _e6005[1]))) + (_e6333 * (_e6011 - _e6005[2])));
                                                    if (_e6404 < 0f) {
                                                        phi_2761_ = -(_e6404);
                                                    } else {
                                                        phi_2761_ = _e6404;
                                                    }
                                                    let _e6445 = phi_2761_;
                                                    if (_e6425 < 0f) {
                                                        phi_2767_ = -(_e6425);
                                                    } else {
                                                        phi_2767_ = _e6425;
                                                    }
                                                    let _e6449 = phi_2767_;
                                                    if (_e6409 < 0f) {
                                                        phi_2776_ = -(_e6409);
                                                    } else {
                                                        phi_2776_ = _e6409;
                                                    }
                                                    let _e6456 = phi_2776_;
                                                    if (_e6430 < 0f) {
                                                        phi_2782_ = -(_e6430);
                                                    } else {
                                                        phi_2782_ = _e6430;
                                                    }
                                                    let _e6460 = phi_2782_;
                                                    if (_e6414 < 0f) {
                                                        phi_2791_ = -(_e6414);
                                                    } else {
                                                        phi_2791_ = _e6414;
                                                    }
                                                    let _e6467 = phi_2791_;
                                                    if (_e6435 < 0f) {
                                                        phi_2797_ = -(_e6435);
                                                    } else {
                                                        phi_2797_ = _e6435;
                                                    }
                                                    let _e6471 = phi_2797_;
                                                    if (_e6419 < 0f) {
                                                        phi_2806_ = -(_e6419);
                                                    } else {
                                                        phi_2806_ = _e6419;
                                                    }
                                                    let _e6478 = phi_2806_;
                                                    if (_e6440 < 0f) {
                                                        phi_2812_ = -(_e6440);
                                                    } else {
                                                        phi_2812_ = _e6440;
                                                    }
                                                    let _e6482 = phi_2812_;
                                                    phi_2818_ = type_32(array<f32, 4>(_e6404, _e6409, _e6414, _e6419), array<f32, 4>(_e6425, _e6430, _e6435, _e6440), array<f32, 4>((_e6399 + ((_e6445 + _e6449) * _e6394)), (_e6399 + ((_e6456 + _e6460) * _e6394)), (_e6399 + ((_e6467 + _e6471) * _e6394)), (_e6399 + ((_e6478 + _e6482) * _e6394))));
                                                    phi_2819_ = false;
                                                } else {
                                                    phi_2818_ = type_32();
                                                    phi_2819_ = true;
                                                }
                                                let _e6489 = phi_2818_;
                                                let _e6491 = phi_2819_;
                                                phi_2820_ = _e6489;
                                                phi_2821_ = _e6491;
                                            } else {
                                                phi_2820_ = type_32();
                                                phi_2821_ = true;
                                            }
                                            let _e6493 = phi_2820_;
                                            let _e6495 = phi_2821_;
                                            if _e6495 {
                                                phi_2829_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                            } else {
                                                phi_2829_ = _e6493;
                                            }
                                            let _e6497 = phi_2829_;
                                            local_17 = type_32(array<f32, 4>(_e6497.member[0], _e6497.member[1], _e6497.member[2], _e6497.member[3]), array<f32, 4>(_e6497.member_1[0], _e6497.member_1[1], _e6497.member_1[2], _e6497.member_1[3]), array<f32, 4>(_e6497.member_2[0], _e6497.member_2[1], _e6497.member_2[2], _e6497.member_2[3]));
                                            let _e6517 = (_e6195 - _e6201);
                                            let _e6521 = local_17.member[0u];
                                            let _e6524 = local_17.member_1[0u];
                                            let _e6527 = local_17.member[0u];
                                            let _e6533 = local_17.member_2[0u];
                                            if (((_e6521 + ((_e6524 - _e6527) * _e6195)) - _e6533) > 0f) {
                                                let _e6538 = local_17.member[1u];
                                                let _e6541 = local_17.member_1[1u];
                                                let _e6544 = local_17.member[1u];
                                                let _e6550 = local_17.member_2[1u];
                                                if (((_e6538 + ((_e6541 - _e6544) * _e6195)) - _e6550) > 0f) {
                                                    let _e6555 = local_17.member[2u];
                                                    let _e6558 = local_17.member_1[2u];
                                                    let _e6561 = local_17.member[2u];
                                                    let _e6567 = local_17.member_2[2u];
                                                    if (((_e6555 + ((_e6558 - _e6561) * _e6195)) - _e6567) > 0f) {
                                                        let _e6572 = local_17.member[3u];
                                                        let _e6575 = local_17.member_1[3u];
                                                        let _e6578 = local_17.member[3u];
                                                        let _e6584 = local_17.member_2[3u];
                                                        phi_3000_ = (((_e6572 + ((_e6575 - _e6578) * _e6195)) - _e6584) > 0f);
                                                        phi_3001_ = false;
                                                    } else {
                                                        phi_3000_ = bool();
                                                        phi_3001_ = true;
                                                    }
                                                    let _e6588 = phi_3000_;
                                                    let _e6590 = phi_3001_;
                                                    phi_3002_ = _e6588;
                                                    phi_3003_ = _e6590;
                                                } else {
                                                    phi_3002_ = bool();
                                                    phi_3003_ = true;
                                                }
                                                let _e6592 = phi_3002_;
                                                let _e6594 = phi_3003_;
                                                phi_3004_ = _e6592;
                                                phi_3005_ = _e6594;
                                            } else {
                                                phi_3004_ = bool();
                                                phi_3005_ = true;
                                            }
                                            let _e6596 = phi_3004_;
                                            let _e6598 = phi_3005_;
                                            if _e6598 {
                                                phi_3009_ = false;
                                            } else {
                                                phi_3009_ = _e6596;
                                            }
                                            let _e6600 = phi_3009_;
                                            if _e6600 {
                                                if (_e6195 <= _e6197) {
                                                    phi_3319_ = true;
                                                } else {
                                                    let _e6604 = local_16.member[0u];
                                                    let _e6607 = local_16.member_1[0u];
                                                    let _e6610 = local_16.member[0u];
                                                    let _e6616 = local_16.member_2[0u];
                                                    let _e6620 = local_17.member[0u];
                                                    let _e6623 = local_17.member_1[0u];
                                                    let _e6626 = local_17.member[0u];
                                                    let _e6632 = local_17.member_2[0u];
                                                    if ((((_e6604 + ((_e6607 - _e6610) * _e6195)) - _e6616) + ((_e6620 + ((_e6623 - _e6626) * _e6201)) - _e6632)) > 0f) {
                                                        let _e6638 = local_16.member[1u];
                                                        let _e6641 = local_16.member_1[1u];
                                                        let _e6644 = local_16.member[1u];
                                                        let _e6650 = local_16.member_2[1u];
                                                        let _e6654 = local_17.member[1u];
                                                        let _e6657 = local_17.member_1[1u];
                                                        let _e6660 = local_17.member[1u];
                                                        let _e6666 = local_17.member_2[1u];
                                                        if ((((_e6638 + ((_e6641 - _e6644) * _e6195)) - _e6650) + ((_e6654 + ((_e6657 - _e6660) * _e6201)) - _e6666)) > 0f) {
                                                            let _e6672 = local_16.member[2u];
                                                            let _e6675 = local_16.member_1[2u];
                                                            let _e6678 = local_16.member[2u];
                                                            let _e6684 = local_16.member_2[2u];
                                                            let _e6688 = local_17.member[2u];
                                                            let _e6691 = local_17.member_1[2u];
                                                            let _e6694 = local_17.member[2u];
                                                            let _e6700 = local_17.member_2[2u];
                                                            if ((((_e6672 + ((_e6675 - _e6678) * _e6195)) - _e6684) + ((_e6688 + ((_e6691 - _e6694) * _e6201)) - _e6700)) > 0f) {
                                                                let _e6706 = local_16.member[3u];
                                                                let _e6709 = local_16.member_1[3u];
                                                                let _e6712 = local_16.member[3u];
                                                                let _e6718 = local_16.member_2[3u];
                                                                let _e6722 = local_17.member[3u];
                                                                let _e6725 = local_17.member_1[3u];
                                                                let _e6728 = local_17.member[3u];
                                                                let _e6734 = local_17.member_2[3u];
                                                                phi_3306_ = ((((_e6706 + ((_e6709 - _e6712) * _e6195)) - _e6718) + ((_e6722 + ((_e6725 - _e6728) * _e6201)) - _e6734)) > 0f);
                                                                phi_3307_ = false;
                                                            } else {
                                                                phi_3306_ = bool();
                                                                phi_3307_ = true;
                                                            }
                                                            let _e6739 = phi_3306_;
                                                            let _e6741 = phi_3307_;
                                                            phi_3308_ = _e6739;
                                                            phi_3309_ = _e6741;
                                                        } else {
                                                            phi_3308_ = bool();
                                                            phi_3309_ = true;
                                                        }
                                                        let _e6743 = phi_3308_;
                                                        let _e6745 = phi_3309_;
                                                        phi_3310_ = _e6743;
                                                        phi_3311_ = _e6745;
                                                    } else {
                                                        phi_3310_ = bool();
                                                        phi_3311_ = true;
                                                    }
                                                    let _e6747 = phi_3310_;
                                                    let _e6749 = phi_3311_;
                                                    if _e6749 {
                                                        phi_3315_ = false;
                                                    } else {
                                                        phi_3315_ = _e6747;
                                                    }
                                                    let _e6751 = phi_3315_;
                                                    phi_3319_ = _e6751;
                                                }
                                                let _e6753 = phi_3319_;
                                                if _e6753 {
                                                    if _e6203 {
                                                        if (_e6195 >= _e285) {
                                                            phi_3330_ = false;
                                                        } else {
                                                            phi_3330_ = true;
                                                        }
                                                        let _e6756 = phi_3330_;
                                                        phi_3331_ = _e6756;
                                                    } else {
                                                        phi_3331_ = true;
                                                    }
                                                    let _e6758 = phi_3331_;
                                                    if _e6758 {
                                                        local_16 = type_32(array<f32, 4>(_e6497.member[0], _e6497.member[1], _e6497.member[2], _e6497.member[3]), array<f32, 4>(_e6497.member_1[0], _e6497.member_1[1], _e6497.member_1[2], _e6497.member_1[3]), array<f32, 4>(_e6497.member_2[0], _e6497.member_2[1], _e6497.member_2[2], _e6497.member_2[3]));
                                                        let _e6780 = local_16.member[0u];
                                                        let _e6783 = local_16.member_1[0u];
                                                        let _e6786 = local_16.member_2[0u];
                                                        if (_e6780 > _e6786) {
                                                            if (_e6783 > _e6786) {
                                                                phi_3405_ = false;
                                                            } else {
                                                                phi_3405_ = true;
                                                            }
                                                            let _e6790 = phi_3405_;
                                                            phi_3406_ = _e6790;
                                                        } else {
                                                            phi_3406_ = true;
                                                        }
                                                        let _e6792 = phi_3406_;
                                                        if _e6792 {
                                                            let _e6793 = (_e6783 >= _e6780);
                                                            if _e6793 {
                                                                phi_3428_ = f32();
                                                                phi_3429_ = false;
                                                            } else {
                                                                if ((_e6780 - _e6783) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3426_ = (((_e6780 - _e6786) / (_e6780 - _e6783)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3427_ = false;
                                                                } else {
                                                                    phi_3426_ = f32();
                                                                    phi_3427_ = true;
                                                                }
                                                                let _e6804 = phi_3426_;
                                                                let _e6806 = phi_3427_;
                                                                phi_3428_ = _e6804;
                                                                phi_3429_ = _e6806;
                                                            }
                                                            let _e6808 = phi_3428_;
                                                            let _e6810 = phi_3429_;
                                                            phi_3430_ = _e6808;
                                                            phi_3431_ = _e6793;
                                                            phi_3432_ = _e6810;
                                                        } else {
                                                            phi_3430_ = f32();
                                                            phi_3431_ = true;
                                                            phi_3432_ = false;
                                                        }
                                                        let _e6812 = phi_3430_;
                                                        let _e6814 = phi_3431_;
                                                        let _e6816 = phi_3432_;
                                                        if _e6814 {
                                                            phi_3436_ = 2f;
                                                            phi_3437_ = true;
                                                        } else {
                                                            phi_3436_ = _e6195;
                                                            phi_3437_ = _e6816;
                                                        }
                                                        let _e6818 = phi_3436_;
                                                        let _e6820 = phi_3437_;
                                                        if _e6820 {
                                                            phi_3441_ = _e6818;
                                                        } else {
                                                            phi_3441_ = _e6812;
                                                        }
                                                        let _e6822 = phi_3441_;
                                                        let _e6825 = local_16.member[1u];
                                                        let _e6828 = local_16.member_1[1u];
                                                        let _e6831 = local_16.member_2[1u];
                                                        if (_e6825 > _e6831) {
                                                            if (_e6828 > _e6831) {
                                                                phi_3473_ = false;
                                                            } else {
                                                                phi_3473_ = true;
                                                            }
                                                            let _e6835 = phi_3473_;
                                                            phi_3474_ = _e6835;
                                                        } else {
                                                            phi_3474_ = true;
                                                        }
                                                        let _e6837 = phi_3474_;
                                                        if _e6837 {
                                                            let _e6838 = (_e6828 >= _e6825);
                                                            if _e6838 {
                                                                phi_3496_ = f32();
                                                                phi_3497_ = false;
                                                            } else {
                                                                if ((_e6825 - _e6828) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3494_ = (((_e6825 - _e6831) / (_e6825 - _e6828)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3495_ = false;
                                                                } else {
                                                                    phi_3494_ = f32();
                                                                    phi_3495_ = true;
                                                                }
                                                                let _e6849 = phi_3494_;
                                                                let _e6851 = phi_3495_;
                                                                phi_3496_ = _e6849;
                                                                phi_3497_ = _e6851;
                                                            }
                                                            let _e6853 = phi_3496_;
                                                            let _e6855 = phi_3497_;
                                                            phi_3498_ = _e6853;
                                                            phi_3499_ = _e6838;
                                                            phi_3500_ = _e6855;
                                                        } else {
                                                            phi_3498_ = f32();
                                                            phi_3499_ = true;
                                                            phi_3500_ = false;
                                                        }
                                                        let _e6857 = phi_3498_;
                                                        let _e6859 = phi_3499_;
                                                        let _e6861 = phi_3500_;
                                                        if _e6859 {
                                                            phi_3504_ = 2f;
                                                            phi_3505_ = true;
                                                        } else {
                                                            phi_3504_ = _e6195;
                                                            phi_3505_ = _e6861;
                                                        }
                                                        let _e6863 = phi_3504_;
                                                        let _e6865 = phi_3505_;
                                                        if _e6865 {
                                                            phi_3509_ = _e6863;
                                                        } else {
                                                            phi_3509_ = _e6857;
                                                        }
                                                        let _e6867 = phi_3509_;
                                                        if (_e6822 < _e6867) {
                                                            phi_3514_ = _e6822;
                                                        } else {
                                                            phi_3514_ = _e6867;
                                                        }
                                                        let _e6870 = phi_3514_;
                                                        let _e6873 = local_16.member[2u];
                                                        let _e6876 = local_16.member_1[2u];
                                                        let _e6879 = local_16.member_2[2u];
                                                        if (_e6873 > _e6879) {
                                                            if (_e6876 > _e6879) {
                                                                phi_3546_ = false;
                                                            } else {
                                                                phi_3546_ = true;
                                                            }
                                                            let _e6883 = phi_3546_;
                                                            phi_3547_ = _e6883;
                                                        } else {
                                                            phi_3547_ = true;
                                                        }
                                                        let _e6885 = phi_3547_;
                                                        if _e6885 {
                                                            let _e6886 = (_e6876 >= _e6873);
                                                            if _e6886 {
                                                                phi_3569_ = f32();
                                                                phi_3570_ = false;
                                                            } else {
                                                                if ((_e6873 - _e6876) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3567_ = (((_e6873 - _e6879) / (_e6873 - _e6876)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3568_ = false;
                                                                } else {
                                                                    phi_3567_ = f32();
                                                                    phi_3568_ = true;
                                                                }
                                                                let _e6897 = phi_3567_;
                                                                let _e6899 = phi_3568_;
                                                                phi_3569_ = _e6897;
                                                                phi_3570_ = _e6899;
                                                            }
                                                            let _e6901 = phi_3569_;
                                                            let _e6903 = phi_3570_;
                                                            phi_3571_ = _e6901;
                                                            phi_3572_ = _e6886;
                                                            phi_3573_ = _e6903;
                                                        } else {
                                                            phi_3571_ = f32();
                                                            phi_3572_ = true;
                                                            phi_3573_ = false;
                                                        }
                                                        let _e6905 = phi_3571_;
                                                        let _e6907 = phi_3572_;
                                                        let _e6909 = phi_3573_;
                                                        if _e6907 {
                                                            phi_3577_ = 2f;
                                                            phi_3578_ = true;
                                                        } else {
                                                            phi_3577_ = _e6195;
                                                            phi_3578_ = _e6909;
                                                        }
                                                        let _e6911 = phi_3577_;
                                                        let _e6913 = phi_3578_;
                                                        if _e6913 {
                                                            phi_3582_ = _e6911;
                                                        } else {
                                                            phi_3582_ = _e6905;
                                                        }
                                                        let _e6915 = phi_3582_;
                                                        let _e6918 = local_16.member[3u];
                                                        let _e6921 = local_16.member_1[3u];
                                                        let _e6924 = local_16.member_2[3u];
                                                        if (_e6918 > _e6924) {
                                                            if (_e6921 > _e6924) {
                                                                phi_3614_ = false;
                                                            } else {
                                                                phi_3614_ = true;
                                                            }
                                                            let _e6928 = phi_3614_;
                                                            phi_3615_ = _e6928;
                                                        } else {
                                                            phi_3615_ = true;
                                                        }
                                                        let _e6930 = phi_3615_;
                                                        if _e6930 {
                                                            let _e6931 = (_e6921 >= _e6918);
                                                            if _e6931 {
                                                                phi_3637_ = f32();
                                                                phi_3638_ = false;
                                                            } else {
                                                                if ((_e6918 - _e6921) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                    phi_3635_ = (((_e6918 - _e6924) / (_e6918 - _e6921)) * (1f - (0.000000059604645f * 16f)));
                                                                    phi_3636_ = false;
                                                                } else {
                                                                    phi_3635_ = f32();
                                                                    phi_3636_ = true;
                                                                }
                                                                let _e6942 = phi_3635_;
                                                                let _e6944 = phi_3636_;
                                                                phi_3637_ = _e6942;
                                                                phi_3638_ = _e6944;
                                                            }
                                                            let _e6946 = phi_3637_;
                                                            let _e6948 = phi_3638_;
                                                            phi_3639_ = _e6946;
                                                            phi_3640_ = _e6931;
                                                            phi_3641_ = _e6948;
                                                        } else {
                                                            phi_3639_ = f32();
                                                            phi_3640_ = true;
                                                            phi_3641_ = false;
                                                        }
                                                        let _e6950 = phi_3639_;
                                                        let _e6952 = phi_3640_;
                                                        let _e6954 = phi_3641_;
                                                        if _e6952 {
                                                            phi_3645_ = 2f;
                                                            phi_3646_ = true;
                                                        } else {
                                                            phi_3645_ = _e6195;
                                                            phi_3646_ = _e6954;
                                                        }
                                                        let _e6956 = phi_3645_;
                                                        let _e6958 = phi_3646_;
                                                        if _e6958 {
                                                            phi_3650_ = _e6956;
                                                        } else {
                                                            phi_3650_ = _e6950;
                                                        }
                                                        let _e6960 = phi_3650_;
                                                        if (_e6915 < _e6960) {
                                                            phi_3655_ = _e6915;
                                                        } else {
                                                            phi_3655_ = _e6960;
                                                        }
                                                        let _e6963 = phi_3655_;
                                                        if (_e6870 < _e6963) {
                                                            phi_3660_ = _e6870;
                                                        } else {
                                                            phi_3660_ = _e6963;
                                                        }
                                                        let _e6966 = phi_3660_;
                                                        if (_e6966 > _e6195) {
                                                            phi_3665_ = _e6966;
                                                        } else {
                                                            phi_3665_ = _e6195;
                                                        }
                                                        let _e6969 = phi_3665_;
                                                        let _e6970 = (_e6969 > _e285);
                                                        if _e6970 {
                                                            phi_4170_ = f32();
                                                            phi_4171_ = f32();
                                                            phi_4172_ = false;
                                                            phi_4173_ = false;
                                                        } else {
                                                            let _e6971 = (_e6969 - _e6195);
                                                            let _e6972 = (_e6971 <= _e6190);
                                                            let _e6974 = (_e6969 + (_e281 * 0.01f));
                                                            if (_e6974 < _e285) {
                                                                phi_3678_ = _e6974;
                                                            } else {
                                                                phi_3678_ = _e285;
                                                            }
                                                            let _e6977 = phi_3678_;
                                                            if _e6972 {
                                                                if (_e483.member_1 > 0f) {
                                                                    let _e6981 = local_18.member[0u];
                                                                    let _e6987 = local_18.member[1u];
                                                                    let _e7003 = local_18.member_1[0u];
                                                                    let _e7009 = local_18.member_1[1u];
                                                                    let _e7025 = local_18.member_2[0u];
                                                                    let _e7031 = local_18.member_2[1u];
                                                                    let _e7045 = function_3(array<f32, 3>((_e6981[0] + ((_e6987[0] - _e6981[0]) * _e6977)), (_e6981[1] + ((_e6987[1] - _e6981[1]) * _e6977)), (_e6981[2] + ((_e6987[2] - _e6981[2]) * _e6977))), array<f32, 3>((_e7003[0] + ((_e7009[0] - _e7003[0]) * _e6977)), (_e7003[1] + ((_e7009[1] - _e7003[1]) * _e6977)), (_e7003[2] + ((_e7009[2] - _e7003[2]) * _e6977))), array<f32, 3>((_e7025[0] + ((_e7031[0] - _e7025[0]) * _e6977)), (_e7025[1] + ((_e7031[1] - _e7025[1]) * _e6977)), (_e7025[2] + ((_e7031[2] - _e7025[2]) * _e6977))), 1u);
                                                                    let _e7056 = (((_e7045[0] * _e7045[0]) + (_e7045[1] * _e7045[1])) + (_e7045[2] * _e7045[2]));
                                                                    if (_e7056 <= 0.000000000000000000000000000000000000011754944f) {
                                                                        if (_e7056 > 0f) {
                                                                            phi_3808_ = (0.000000000000000000106433627f * 2f);
                                                                        } else {
                                                                            phi_3808_ = 0f;
                                                                        }
                                                                        let _e7109 = phi_3808_;
                                                                        phi_3872_ = _e7109;
                                                                    } else {
                                                                        phi_3815_ = type_14(0i, 5i);
                                                                        phi_3818_ = bitcast<f32>(((bitcast<u32>(_e7056) >> bitcast<u32>(1i)) + 532369198u));
                                                                        loop {
                                                                            let _e7064 = phi_3815_;
                                                                            let _e7066 = phi_3818_;
                                                                            local_41 = _e7066;
                                                                            if (_e7064.member < _e7064.member_1) {
                                                                                let _e7073 = (_e7064.member + 1i);
                                                                                if ((false == (_e7073 > _e7064.member)) != false) {
                                                                                    phi_3839_ = true;
                                                                                } else {
                                                                                    phi_3839_ = false;
                                                                                }
                                                                                let _e7078 = phi_3839_;
                                                                                if _e7078 {
                                                                                    phi_3845_ = type_15(0u, type_15().member_1);
                                                                                } else {
                                                                                    phi_3845_ = type_15(1u, _e7073);
                                                                                }
                                                                                let _e7083 = phi_3845_;
                                                                                phi_3816_ = type_14(_e7083.member_1, _e7064.member_1);
                                                                                phi_3859_ = type_15(1u, _e7064.member);
                                                                            } else {
                                                                                phi_3816_ = _e7064;
                                                                                phi_3859_ = type_15(0u, type_15().member_1);
                                                                            }
                                                                            let _e7089 = phi_3816_;
                                                                            let _e7091 = phi_3859_;
                                                                            let _e7094 = (bitcast<i32>(_e7091.member) != 0i);
                                                                            if _e7094 {
                                                                                phi_3819_ = (0.5f * (_e7066 + (_e7056 / _e7066)));
                                                                            } else {
                                                                                phi_3819_ = f32();
                                                                            }
                                                                            let _e7099 = phi_3819_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_3815_ = _e7089;
                                                                                phi_3818_ = _e7099;
                                                                                break if !(_e7094);
                                                                            }
                                                                        }
                                                                        let _e7104 = local_41;
                                                                        phi_3872_ = (_e7104 * (1f + (8f * 0.000000059604645f)));
                                                                    }
                                                                    let _e7111 = phi_3872_;
                                                                    let _e7117 = local_18.member[0u];
                                                                    if (_e7117[0] < 0f) {
                                                                        phi_3888_ = -(_e7117[0]);
                                                                    } else {
                                                                        phi_3888_ = _e7117[0];
                                                                    }
                                                                    let _e7124 = phi_3888_;
                                                                    if (_e7117[1] < 0f) {
                                                                        phi_3895_ = -(_e7117[1]);
                                                                    } else {
                                                                        phi_3895_ = _e7117[1];
                                                                    }
                                                                    let _e7128 = phi_3895_;
                                                                    if (_e7124 > _e7128) {
                                                                        phi_3900_ = _e7124;
                                                                    } else {
                                                                        phi_3900_ = _e7128;
                                                                    }
                                                                    let _e7131 = phi_3900_;
                                                                    if (_e7117[2] < 0f) {
                                                                        phi_3907_ = -(_e7117[2]);
                                                                    } else {
                                                                        phi_3907_ = _e7117[2];
                                                                    }
                                                                    let _e7135 = phi_3907_;
                                                                    if (_e7131 > _e7135) {
                                                                        phi_3912_ = _e7131;
                                                                    } else {
                                                                        phi_3912_ = _e7135;
                                                                    }
                                                                    let _e7138 = phi_3912_;
                                                                    let _e7141 = local_18.member[1u];
                                                                    if (_e7141[0] < 0f) {
                                                                        phi_3925_ = -(_e7141[0]);
                                                                    } else {
                                                                        phi_3925_ = _e7141[0];
                                                                    }
                                                                    let _e7148 = phi_3925_;
                                                                    if (_e7141[1] < 0f) {
                                                                        phi_3932_ = -(_e7141[1]);
                                                                    } else {
                                                                        phi_3932_ = _e7141[1];
                                                                    }
                                                                    let _e7152 = phi_3932_;
                                                                    if (_e7148 > _e7152) {
                                                                        phi_3937_ = _e7148;
                                                                    } else {
                                                                        phi_3937_ = _e7152;
                                                                    }
                                                                    let _e7155 = phi_3937_;
                                                                    if (_e7141[2] < 0f) {
                                                                        phi_3944_ = -(_e7141[2]);
                                                                    } else {
                                                                        phi_3944_ = _e7141[2];
                                                                    }
                                                                    let _e7159 = phi_3944_;
                                                                    if (_e7155 > _e7159) {
                                                                        phi_3949_ = _e7155;
                                                                    } else {
                                                                        phi_3949_ = _e7159;
                                                                    }
                                                                    let _e7162 = phi_3949_;
                                                                    if (_e7138 > _e7162) {
                                                                        phi_3954_ = _e7138;
                                                                    } else {
                                                                        phi_3954_ = _e7162;
                                                                    }
                                                                    let _e7165 = phi_3954_;
                                                                    let _e7167 = local_18.member_3;
                                                                    let _e7171 = local_18.member_1[0u];
                                                                    if (_e7171[0] < 0f) {
                                                                        phi_3971_ = -(_e7171[0]);
                                                                    } else {
                                                                        phi_3971_ = _e7171[0];
                                                                    }
                                                                    let _e7178 = phi_3971_;
                                                                    if (_e7171[1] < 0f) {
                                                                        phi_3978_ = -(_e7171[1]);
                                                                    } else {
                                                                        phi_3978_ = _e7171[1];
                                                                    }
                                                                    let _e7182 = phi_3978_;
                                                                    if (_e7178 > _e7182) {
                                                                        phi_3983_ = _e7178;
                                                                    } else {
                                                                        phi_3983_ = _e7182;
                                                                    }
                                                                    let _e7185 = phi_3983_;
                                                                    if (_e7171[2] < 0f) {
                                                                        phi_3990_ = -(_e7171[2]);
                                                                    } else {
                                                                        phi_3990_ = _e7171[2];
                                                                    }
                                                                    let _e7189 = phi_3990_;
                                                                    if (_e7185 > _e7189) {
                                                                        phi_3995_ = _e7185;
                                                                    } else {
                                                                        phi_3995_ = _e7189;
                                                                    }
                                                                    let _e7192 = phi_3995_;
                                                                    let _e7195 = local_18.member_1[1u];
                                                                    if (_e7195[0] < 0f) {
                                                                        phi_4009_ = -(_e7195[0]);
                                                                    } else {
                                                                        phi_4009_ = _e7195[0];
                                                                    }
                                                                    let _e7202 = phi_4009_;
                                                                    if (_e7195[1] < 0f) {
                                                                        phi_4016_ = -(_e7195[1]);
                                                                    } else {
                                                                        phi_4016_ = _e7195[1];
                                                                    }
                                                                    let _e7206 = phi_4016_;
                                                                    if (_e7202 > _e7206) {
                                                                        phi_4021_ = _e7202;
                                                                    } else {
                                                                        phi_4021_ = _e7206;
                                                                    }
                                                                    let _e7209 = phi_4021_;
                                                                    if (_e7195[2] < 0f) {
                                                                        phi_4028_ = -(_e7195[2]);
                                                                    } else {
                                                                        phi_4028_ = _e7195[2];
                                                                    }
                                                                    let _e7213 = phi_4028_;
                                                                    if (_e7209 > _e7213) {
                                                                        phi_4033_ = _e7209;
                                                                    } else {
                                                                        phi_4033_ = _e7213;
                                                                    }
                                                                    let _e7216 = phi_4033_;
                                                                    if (_e7192 > _e7216) {
                                                                        phi_4038_ = _e7192;
                                                                    } else {
                                                                        phi_4038_ = _e7216;
                                                                    }
                                                                    let _e7219 = phi_4038_;
                                                                    let _e7221 = local_18.member_3;
                                                                    let _e7225 = local_18.member_2[0u];
                                                                    if (_e7225[0] < 0f) {
                                                                        phi_4055_ = -(_e7225[0]);
                                                                    } else {
                                                                        phi_4055_ = _e7225[0];
                                                                    }
                                                                    let _e7232 = phi_4055_;
                                                                    if (_e7225[1] < 0f) {
                                                                        phi_4062_ = -(_e7225[1]);
                                                                    } else {
                                                                        phi_4062_ = _e7225[1];
                                                                    }
                                                                    let _e7236 = phi_4062_;
                                                                    if (_e7232 > _e7236) {
                                                                        phi_4067_ = _e7232;
                                                                    } else {
                                                                        phi_4067_ = _e7236;
                                                                    }
                                                                    let _e7239 = phi_4067_;
                                                                    if (_e7225[2] < 0f) {
                                                                        phi_4074_ = -(_e7225[2]);
                                                                    } else {
                                                                        phi_4074_ = _e7225[2];
                                                                    }
                                                                    let _e7243 = phi_4074_;
                                                                    if (_e7239 > _e7243) {
                                                                        phi_4079_ = _e7239;
                                                                    } else {
                                                                        phi_4079_ = _e7243;
                                                                    }
                                                                    let _e7246 = phi_4079_;
                                                                    let _e7249 = local_18.member_2[1u];
                                                                    if (_e7249[0] < 0f) {
                                                                        phi_4093_ = -(_e7249[0]);
                                                                    } else {
                                                                        phi_4093_ = _e7249[0];
                                                                    }
                                                                    let _e7256 = phi_4093_;
                                                                    if (_e7249[1] < 0f) {
                                                                        phi_4100_ = -(_e7249[1]);
                                                                    } else {
                                                                        phi_4100_ = _e7249[1];
                                                                    }
                                                                    let _e7260 = phi_4100_;
                                                                    if (_e7256 > _e7260) {
                                                                        phi_4105_ = _e7256;
                                                                    } else {
                                                                        phi_4105_ = _e7260;
                                                                    }
                                                                    let _e7263 = phi_4105_;
                                                                    if (_e7249[2] < 0f) {
                                                                        phi_4112_ = -(_e7249[2]);
                                                                    } else {
                                                                        phi_4112_ = _e7249[2];
                                                                    }
                                                                    let _e7267 = phi_4112_;
                                                                    if (_e7263 > _e7267) {
                                                                        phi_4117_ = _e7263;
                                                                    } else {
                                                                        phi_4117_ = _e7267;
                                                                    }
                                                                    let _e7270 = phi_4117_;
                                                                    if (_e7246 > _e7270) {
                                                                        phi_4122_ = _e7246;
                                                                    } else {
                                                                        phi_4122_ = _e7270;
                                                                    }
                                                                    let _e7273 = phi_4122_;
                                                                    let _e7275 = local_18.member_3;
                                                                    let _e7282 = local_18.member_3;
                                                                    if (((_e7111 * (1f + (0.000000059604645f * 8f))) + (((((((_e7165 + _e7167) + (_e7219 + _e7221)) + (_e7273 + _e7275)) * (0.000000059604645f * 16f)) + (_e7282 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e483.member_1) {
                                                                        phi_4142_ = false;
                                                                    } else {
                                                                        phi_4142_ = true;
                                                                    }
                                                                    let _e7291 = phi_4142_;
                                                                    phi_4143_ = _e7291;
                                                                } else {
                                                                    phi_4143_ = true;
                                                                }
                                                                let _e7293 = phi_4143_;
                                                                phi_4144_ = _e7293;
                                                            } else {
                                                                phi_4144_ = true;
                                                            }
                                                            let _e7295 = phi_4144_;
                                                            if _e7295 {
                                                                if _e6203 {
                                                                    if _e6972 {
                                                                        phi_4160_ = true;
                                                                    } else {
                                                                        if (_e6971 <= (_e6199 * 0.25f)) {
                                                                            phi_4159_ = false;
                                                                        } else {
                                                                            phi_4159_ = true;
                                                                        }
                                                                        let _e7300 = phi_4159_;
                                                                        phi_4160_ = _e7300;
                                                                    }
                                                                    let _e7302 = phi_4160_;
                                                                    if _e7302 {
                                                                        phi_4165_ = (_e6517 + _e6517);
                                                                    } else {
                                                                        phi_4165_ = 0f;
                                                                    }
                                                                    let _e7305 = phi_4165_;
                                                                    phi_4167_ = _e7305;
                                                                } else {
                                                                    phi_4167_ = (_e285 - _e6195);
                                                                }
                                                                let _e7307 = phi_4167_;
                                                                phi_4168_ = _e7307;
                                                                phi_4169_ = false;
                                                            } else {
                                                                phi_4168_ = f32();
                                                                phi_4169_ = true;
                                                            }
                                                            let _e7309 = phi_4168_;
                                                            let _e7311 = phi_4169_;
                                                            phi_4170_ = _e7309;
                                                            phi_4171_ = _e6971;
                                                            phi_4172_ = _e7295;
                                                            phi_4173_ = _e7311;
                                                        }
                                                        let _e7313 = phi_4170_;
                                                        let _e7315 = phi_4171_;
                                                        let _e7317 = phi_4172_;
                                                        let _e7319 = phi_4173_;
                                                        phi_4174_ = _e6969;
                                                        phi_4175_ = _e7313;
                                                        phi_4176_ = _e7315;
                                                        phi_4177_ = _e6969;
                                                        phi_4178_ = _e7317;
                                                        phi_4179_ = _e6970;
                                                        phi_4180_ = _e7319;
                                                        phi_4181_ = false;
                                                    } else {
                                                        phi_4174_ = f32();
                                                        phi_4175_ = f32();
                                                        phi_4176_ = f32();
                                                        phi_4177_ = f32();
                                                        phi_4178_ = false;
                                                        phi_4179_ = false;
                                                        phi_4180_ = false;
                                                        phi_4181_ = true;
                                                    }
                                                    let _e7321 = phi_4174_;
                                                    let _e7323 = phi_4175_;
                                                    let _e7325 = phi_4176_;
                                                    let _e7327 = phi_4177_;
                                                    let _e7329 = phi_4178_;
                                                    let _e7331 = phi_4179_;
                                                    let _e7333 = phi_4180_;
                                                    let _e7335 = phi_4181_;
                                                    phi_4182_ = _e7321;
                                                    phi_4183_ = _e7323;
                                                    phi_4184_ = _e7325;
                                                    phi_4185_ = _e7327;
                                                    phi_4186_ = false;
                                                    phi_4187_ = _e7329;
                                                    phi_4188_ = _e7331;
                                                    phi_4189_ = _e7333;
                                                    phi_4190_ = _e7335;
                                                } else {
                                                    phi_4182_ = f32();
                                                    phi_4183_ = f32();
                                                    phi_4184_ = f32();
                                                    phi_4185_ = f32();
                                                    phi_4186_ = true;
                                                    phi_4187_ = false;
                                                    phi_4188_ = false;
                                                    phi_4189_ = false;
                                                    phi_4190_ = false;
                                                }
                                                let _e7337 = phi_4182_;
                                                let _e7339 = phi_4183_;
                                                let _e7341 = phi_4184_;
                                                let _e7343 = phi_4185_;
                                                let _e7345 = phi_4186_;
                                                let _e7347 = phi_4187_;
                                                let _e7349 = phi_4188_;
                                                let _e7351 = phi_4189_;
                                                let _e7353 = phi_4190_;
                                                phi_4191_ = _e7337;
                                                phi_4192_ = _e7339;
                                                phi_4193_ = _e7341;
                                                phi_4194_ = _e7343;
                                                phi_4195_ = _e7345;
                                                phi_4196_ = _e7347;
                                                phi_4197_ = _e7349;
                                                phi_4198_ = _e7351;
                                                phi_4199_ = _e7353;
                                            } else {
                                                phi_4191_ = f32();
                                                phi_4192_ = f32();
                                                phi_4193_ = f32();
                                                phi_4194_ = f32();
                                                phi_4195_ = true;
                                                phi_4196_ = false;
                                                phi_4197_ = false;
                                                phi_4198_ = false;
                                                phi_4199_ = false;
                                            }
                                            let _e7355 = phi_4191_;
                                            let _e7357 = phi_4192_;
                                            let _e7359 = phi_4193_;
                                            let _e7361 = phi_4194_;
                                            let _e7363 = phi_4195_;
                                            let _e7365 = phi_4196_;
                                            let _e7367 = phi_4197_;
                                            let _e7369 = phi_4198_;
                                            let _e7371 = phi_4199_;
                                            if _e7363 {
                                                if (_e6195 <= _e6197) {
                                                    let _e7532 = (_e6205 + 1u);
                                                    let _e7533 = (_e7532 > 3u);
                                                    if _e7533 {
                                                        phi_4212_ = false;
                                                    } else {
                                                        phi_4212_ = true;
                                                    }
                                                    let _e7535 = phi_4212_;
                                                    phi_4534_ = _e7532;
                                                    phi_4535_ = f32();
                                                    phi_4536_ = false;
                                                    phi_4537_ = _e7535;
                                                    phi_4538_ = _e7533;
                                                } else {
                                                    let _e7375 = local_16.member[0u];
                                                    let _e7378 = local_16.member_1[0u];
                                                    let _e7381 = local_16.member[0u];
                                                    let _e7387 = local_16.member_2[0u];
                                                    let _e7388 = ((_e7375 + ((_e7378 - _e7381) * _e6201)) - _e7387);
                                                    let _e7391 = local_16.member[1u];
                                                    let _e7394 = local_16.member_1[1u];
                                                    let _e7397 = local_16.member[1u];
                                                    let _e7403 = local_16.member_2[1u];
                                                    let _e7404 = ((_e7391 + ((_e7394 - _e7397) * _e6201)) - _e7403);
                                                    if (_e7388 < _e7404) {
                                                        phi_4285_ = _e7388;
                                                    } else {
                                                        phi_4285_ = _e7404;
                                                    }
                                                    let _e7407 = phi_4285_;
                                                    let _e7410 = local_16.member[2u];
                                                    let _e7413 = local_16.member_1[2u];
                                                    let _e7416 = local_16.member[2u];
                                                    let _e7422 = local_16.member_2[2u];
                                                    let _e7423 = ((_e7410 + ((_e7413 - _e7416) * _e6201)) - _e7422);
                                                    let _e7426 = local_16.member[3u];
                                                    let _e7429 = local_16.member_1[3u];
                                                    let _e7432 = local_16.member[3u];
                                                    let _e7438 = local_16.member_2[3u];
                                                    let _e7439 = ((_e7426 + ((_e7429 - _e7432) * _e6201)) - _e7438);
                                                    if (_e7423 < _e7439) {
                                                        phi_4358_ = _e7423;
                                                    } else {
                                                        phi_4358_ = _e7439;
                                                    }
                                                    let _e7442 = phi_4358_;
                                                    if (_e7407 < _e7442) {
                                                        phi_4363_ = _e7407;
                                                    } else {
                                                        phi_4363_ = _e7442;
                                                    }
                                                    let _e7445 = phi_4363_;
                                                    let _e7448 = local_17.member[0u];
                                                    let _e7451 = local_17.member_1[0u];
                                                    let _e7454 = local_17.member[0u];
                                                    let _e7460 = local_17.member_2[0u];
                                                    let _e7461 = ((_e7448 + ((_e7451 - _e7454) * _e6195)) - _e7460);
                                                    let _e7464 = local_17.member[1u];
                                                    let _e7467 = local_17.member_1[1u];
                                                    let _e7470 = local_17.member[1u];
                                                    let _e7476 = local_17.member_2[1u];
                                                    let _e7477 = ((_e7464 + ((_e7467 - _e7470) * _e6195)) - _e7476);
                                                    if (_e7461 < _e7477) {
                                                        phi_4436_ = _e7461;
                                                    } else {
                                                        phi_4436_ = _e7477;
                                                    }
                                                    let _e7480 = phi_4436_;
                                                    let _e7483 = local_17.member[2u];
                                                    let _e7486 = local_17.member_1[2u];
                                                    let _e7489 = local_17.member[2u];
                                                    let _e7495 = local_17.member_2[2u];
                                                    let _e7496 = ((_e7483 + ((_e7486 - _e7489) * _e6195)) - _e7495);
                                                    let _e7499 = local_17.member[3u];
                                                    let _e7502 = local_17.member_1[3u];
                                                    let _e7505 = local_17.member[3u];
                                                    let _e7511 = local_17.member_2[3u];
                                                    let _e7512 = ((_e7499 + ((_e7502 - _e7505) * _e6195)) - _e7511);
                                                    if (_e7496 < _e7512) {
                                                        phi_4509_ = _e7496;
                                                    } else {
                                                        phi_4509_ = _e7512;
                                                    }
                                                    let _e7515 = phi_4509_;
                                                    if (_e7480 < _e7515) {
                                                        phi_4514_ = _e7480;
                                                    } else {
                                                        phi_4514_ = _e7515;
                                                    }
                                                    let _e7518 = phi_4514_;
                                                    if (_e7518 > 0f) {
                                                        phi_4532_ = 0.5f;
                                                    } else {
                                                        let _e7522 = (0.95f * (_e7445 / (_e7445 - _e7518)));
                                                        if (_e7522 > 0.0625f) {
                                                            if (_e7522 < 0.9f) {
                                                                phi_4530_ = _e7522;
                                                            } else {
                                                                phi_4530_ = 0.9f;
                                                            }
                                                            let _e7526 = phi_4530_;
                                                            phi_4531_ = _e7526;
                                                        } else {
                                                            phi_4531_ = 0.0625f;
                                                        }
                                                        let _e7528 = phi_4531_;
                                                        phi_4532_ = _e7528;
                                                    }
                                                    let _e7530 = phi_4532_;
                                                    phi_4534_ = u32();
                                                    phi_4535_ = (_e6517 * _e7530);
                                                    phi_4536_ = true;
                                                    phi_4537_ = false;
                                                    phi_4538_ = false;
                                                }
                                                let _e7537 = phi_4534_;
                                                let _e7539 = phi_4535_;
                                                let _e7541 = phi_4536_;
                                                let _e7543 = phi_4537_;
                                                let _e7545 = phi_4538_;
                                                phi_4539_ = _e7537;
                                                phi_4540_ = _e6197;
                                                phi_4541_ = _e7539;
                                                phi_4542_ = _e6199;
                                                phi_4543_ = _e6201;
                                                phi_4544_ = _e6203;
                                                phi_4545_ = _e6205;
                                                phi_4546_ = _e7541;
                                                phi_4547_ = _e7543;
                                                phi_4548_ = _e7545;
                                                phi_4549_ = false;
                                                phi_4550_ = false;
                                                phi_4551_ = false;
                                            } else {
                                                phi_4539_ = u32();
                                                phi_4540_ = _e7355;
                                                phi_4541_ = _e7357;
                                                phi_4542_ = _e7359;
                                                phi_4543_ = _e6195;
                                                phi_4544_ = true;
                                                phi_4545_ = 0u;
                                                phi_4546_ = _e7365;
                                                phi_4547_ = false;
                                                phi_4548_ = false;
                                                phi_4549_ = _e7367;
                                                phi_4550_ = _e7369;
                                                phi_4551_ = _e7371;
                                            }
                                            let _e7547 = phi_4539_;
                                            let _e7549 = phi_4540_;
                                            let _e7551 = phi_4541_;
                                            let _e7553 = phi_4542_;
                                            let _e7555 = phi_4543_;
                                            let _e7557 = phi_4544_;
                                            let _e7559 = phi_4545_;
                                            let _e7561 = phi_4546_;
                                            let _e7563 = phi_4547_;
                                            let _e7565 = phi_4548_;
                                            let _e7567 = phi_4549_;
                                            let _e7569 = phi_4550_;
                                            let _e7571 = phi_4551_;
                                            if _e7561 {
                                                let _e7572 = (_e7555 + _e7551);
                                                if (_e7572 > _e7549) {
                                                    phi_4560_ = _e7572;
                                                } else {
                                                    phi_4560_ = _e7549;
                                                }
                                                let _e7575 = phi_4560_;
                                                if (_e7575 < _e285) {
                                                    phi_4565_ = _e7575;
                                                } else {
                                                    phi_4565_ = _e285;
                                                }
                                                let _e7578 = phi_4565_;
                                                if !(_e6203) {
                                                    phi_4574_ = true;
                                                } else {
                                                    phi_4574_ = ((_e7578 - _e7555) > _e6190);
                                                }
                                                let _e7582 = phi_4574_;
                                                if _e7582 {
                                                    phi_4578_ = false;
                                                } else {
                                                    phi_4578_ = true;
                                                }
                                                let _e7584 = phi_4578_;
                                                phi_4579_ = _e7578;
                                                phi_4580_ = _e7549;
                                                phi_4581_ = _e7553;
                                                phi_4582_ = _e7555;
                                                phi_4583_ = _e7557;
                                                phi_4584_ = _e7559;
                                                phi_4585_ = _e7582;
                                                phi_4586_ = _e7584;
                                                phi_4587_ = false;
                                                phi_4588_ = false;
                                                phi_4589_ = false;
                                                phi_4590_ = false;
                                            } else {
                                                phi_4579_ = _e6195;
                                                phi_4580_ = _e6197;
                                                phi_4581_ = _e6199;
                                                phi_4582_ = _e6201;
                                                phi_4583_ = _e6203;
                                                phi_4584_ = _e7547;
                                                phi_4585_ = _e7563;
                                                phi_4586_ = false;
                                                phi_4587_ = _e7565;
                                                phi_4588_ = _e7567;
                                                phi_4589_ = _e7569;
                                                phi_4590_ = _e7571;
                                            }
                                            let _e7586 = phi_4579_;
                                            let _e7588 = phi_4580_;
                                            let _e7590 = phi_4581_;
                                            let _e7592 = phi_4582_;
                                            let _e7594 = phi_4583_;
                                            let _e7596 = phi_4584_;
                                            let _e7598 = phi_4585_;
                                            let _e7600 = phi_4586_;
                                            let _e7602 = phi_4587_;
                                            let _e7604 = phi_4588_;
                                            let _e7606 = phi_4589_;
                                            let _e7608 = phi_4590_;
                                            phi_2412_ = _e7586;
                                            phi_2414_ = _e7588;
                                            phi_2416_ = _e7590;
                                            phi_2418_ = _e7592;
                                            phi_2420_ = _e7594;
                                            phi_2422_ = _e7596;
                                            phi_4591_ = _e7549;
                                            phi_4592_ = _e7361;
                                            phi_4593_ = _e7598;
                                            phi_4594_ = _e7600;
                                            phi_4595_ = _e7602;
                                            phi_4596_ = _e7604;
                                            phi_4597_ = _e7606;
                                            phi_4598_ = false;
                                            phi_4599_ = _e7608;
                                        } else {
                                            phi_2412_ = f32();
                                            phi_2414_ = f32();
                                            phi_2416_ = f32();
                                            phi_2418_ = f32();
                                            phi_2420_ = bool();
                                            phi_2422_ = u32();
                                            phi_4591_ = f32();
                                            phi_4592_ = f32();
                                            phi_4593_ = false;
                                            phi_4594_ = false;
                                            phi_4595_ = false;
                                            phi_4596_ = false;
                                            phi_4597_ = false;
                                            phi_4598_ = true;
                                            phi_4599_ = false;
                                        }
                                        let _e7610 = phi_2412_;
                                        let _e7612 = phi_2414_;
                                        let _e7614 = phi_2416_;
                                        let _e7616 = phi_2418_;
                                        let _e7618 = phi_2420_;
                                        let _e7620 = phi_2422_;
                                        let _e7622 = phi_4591_;
                                        let _e7624 = phi_4592_;
                                        let _e7626 = phi_4593_;
                                        let _e7628 = phi_4594_;
                                        let _e7630 = phi_4595_;
                                        let _e7632 = phi_4596_;
                                        let _e7634 = phi_4597_;
                                        let _e7636 = phi_4598_;
                                        let _e7638 = phi_4599_;
                                        local_42 = _e7628;
                                        local_78 = _e7630;
                                        local_79 = _e7632;
                                        local_80 = _e7634;
                                        local_81 = _e7636;
                                        local_82 = _e7638;
                                        local_83 = _e7628;
                                        local_84 = _e7624;
                                        local_85 = _e7622;
                                        continue;
                                        continuing {
                                            phi_2408_ = _e6217;
                                            phi_2411_ = _e7610;
                                            phi_2413_ = _e7612;
                                            phi_2415_ = _e7614;
                                            phi_2417_ = _e7616;
                                            phi_2419_ = _e7618;
                                            phi_2421_ = _e7620;
                                            break if !(_e7626);
                                        }
                                    }
                                    let _e7641 = local_42;
                                    if _e7641 {
                                        phi_4603_ = false;
                                        phi_4604_ = false;
                                        phi_4605_ = false;
                                        phi_4606_ = false;
                                        phi_4607_ = false;
                                    } else {
                                        let _e11099 = local_78;
                                        phi_4603_ = _e11099;
                                        let _e11102 = local_79;
                                        phi_4604_ = _e11102;
                                        let _e11105 = local_80;
                                        phi_4605_ = _e11105;
                                        let _e11108 = local_81;
                                        phi_4606_ = _e11108;
                                        let _e11111 = local_82;
                                        phi_4607_ = _e11111;
                                    }
                                    let _e7643 = phi_4603_;
                                    let _e7645 = phi_4604_;
                                    let _e7647 = phi_4605_;
                                    let _e7649 = phi_4606_;
                                    let _e7651 = phi_4607_;
                                    if _e7643 {
                                        let _e7653 = local_43;
                                        phi_4612_ = type_30(1u, _e7653);
                                        phi_4613_ = false;
                                        phi_4614_ = false;
                                        phi_4615_ = false;
                                        phi_4616_ = false;
                                        phi_4617_ = false;
                                    } else {
                                        phi_4612_ = type_30();
                                        phi_4613_ = _e7645;
                                        phi_4614_ = _e7647;
                                        let _e11118 = local_83;
                                        phi_4615_ = _e11118;
                                        phi_4616_ = _e7649;
                                        phi_4617_ = _e7651;
                                    }
                                    let _e7656 = phi_4612_;
                                    let _e7658 = phi_4613_;
                                    let _e7660 = phi_4614_;
                                    let _e7662 = phi_4615_;
                                    let _e7664 = phi_4616_;
                                    let _e7666 = phi_4617_;
                                    if _e7658 {
                                        phi_4622_ = type_30(0u, type_30().member_1);
                                        phi_4623_ = false;
                                        phi_4624_ = false;
                                        phi_4625_ = false;
                                        phi_4626_ = false;
                                        phi_4627_ = true;
                                    } else {
                                        phi_4622_ = _e7656;
                                        phi_4623_ = _e7660;
                                        phi_4624_ = _e7662;
                                        phi_4625_ = _e7664;
                                        phi_4626_ = _e7666;
                                        phi_4627_ = _e7643;
                                    }
                                    let _e7670 = phi_4622_;
                                    let _e7672 = phi_4623_;
                                    let _e7674 = phi_4624_;
                                    let _e7676 = phi_4625_;
                                    let _e7678 = phi_4626_;
                                    let _e7680 = phi_4627_;
                                    if _e7672 {
                                        let _e11129 = local_84;
                                        phi_4631_ = _e11129;
                                        phi_4632_ = true;
                                        phi_4633_ = false;
                                        phi_4634_ = false;
                                        phi_4635_ = false;
                                    } else {
                                        let _e11131 = local_85;
                                        phi_4631_ = _e11131;
                                        phi_4632_ = _e7674;
                                        phi_4633_ = _e7676;
                                        phi_4634_ = _e7678;
                                        phi_4635_ = _e7680;
                                    }
                                    let _e7682 = phi_4631_;
                                    let _e7684 = phi_4632_;
                                    let _e7686 = phi_4633_;
                                    let _e7688 = phi_4634_;
                                    let _e7690 = phi_4635_;
                                    if _e7684 {
                                        phi_4639_ = _e7682;
                                        phi_4640_ = true;
                                        phi_4641_ = false;
                                        phi_4642_ = false;
                                    } else {
                                        let _e11138 = local_86;
                                        phi_4639_ = _e11138;
                                        phi_4640_ = _e7686;
                                        phi_4641_ = _e7688;
                                        phi_4642_ = _e7690;
                                    }
                                    let _e7692 = phi_4639_;
                                    let _e7694 = phi_4640_;
                                    let _e7696 = phi_4641_;
                                    let _e7698 = phi_4642_;
                                    if _e7694 {
                                        phi_4647_ = type_30(1u, _e7692);
                                        phi_4648_ = false;
                                        phi_4649_ = false;
                                    } else {
                                        phi_4647_ = type_30();
                                        phi_4648_ = _e7696;
                                        phi_4649_ = _e7698;
                                    }
                                    let _e7701 = phi_4647_;
                                    let _e7703 = phi_4648_;
                                    let _e7705 = phi_4649_;
                                    if _e7703 {
                                        phi_4654_ = type_30(0u, type_30().member_1);
                                        phi_4655_ = true;
                                    } else {
                                        phi_4654_ = _e7670;
                                        phi_4655_ = _e7705;
                                    }
                                    let _e7709 = phi_4654_;
                                    let _e7711 = phi_4655_;
                                    if _e7711 {
                                        phi_4659_ = _e7709;
                                    } else {
                                        phi_4659_ = _e7701;
                                    }
                                    let _e7713 = phi_4659_;
                                    phi_4666_ = _e7713.member_1;
                                    phi_4667_ = (_e7713.member != 0u);
                                } else {
                                    phi_4666_ = _e5925;
                                    phi_4667_ = true;
                                }
                                let _e7718 = phi_4666_;
                                let _e7720 = phi_4667_;
                                if _e7720 {
                                    let _e7721 = (_e7718 > _e283);
                                    if _e7721 {
                                        phi_6827_ = f32();
                                        phi_6828_ = u32();
                                        phi_6829_ = f32();
                                        phi_6830_ = type_40();
                                        phi_6831_ = u32();
                                        phi_6832_ = u32();
                                        phi_6833_ = false;
                                        phi_6834_ = false;
                                        phi_6835_ = false;
                                    } else {
                                        let _e7724 = local_18.member[0u];
                                        let _e7730 = local_18.member[1u];
                                        let _e7746 = local_18.member_1[0u];
                                        let _e7752 = local_18.member_1[1u];
                                        let _e7768 = local_18.member_2[0u];
                                        let _e7774 = local_18.member_2[1u];
                                        let _e7788 = function_3(array<f32, 3>((_e7724[0] + ((_e7730[0] - _e7724[0]) * _e5929)), (_e7724[1] + ((_e7730[1] - _e7724[1]) * _e5929)), (_e7724[2] + ((_e7730[2] - _e7724[2]) * _e5929))), array<f32, 3>((_e7746[0] + ((_e7752[0] - _e7746[0]) * _e5929)), (_e7746[1] + ((_e7752[1] - _e7746[1]) * _e5929)), (_e7746[2] + ((_e7752[2] - _e7746[2]) * _e5929))), array<f32, 3>((_e7768[0] + ((_e7774[0] - _e7768[0]) * _e5929)), (_e7768[1] + ((_e7774[1] - _e7768[1]) * _e5929)), (_e7768[2] + ((_e7774[2] - _e7768[2]) * _e5929))), 1u);
                                        if (_e7788[0] < 0f) {
                                            phi_4779_ = -(_e7788[0]);
                                        } else {
                                            phi_4779_ = _e7788[0];
                                        }
                                        let _e7793 = phi_4779_;
                                        if (_e7788[1] < 0f) {
                                            phi_4786_ = -(_e7788[1]);
                                        } else {
                                            phi_4786_ = _e7788[1];
                                        }
                                        let _e7798 = phi_4786_;
                                        if (_e7788[2] < 0f) {
                                            phi_4794_ = -(_e7788[2]);
                                        } else {
                                            phi_4794_ = _e7788[2];
                                        }
                                        let _e7804 = phi_4794_;
                                        let _e7805 = ((_e7793 + _e7798) + _e7804);
                                        let _e7808 = local_18.member[0u];
                                        let _e7814 = local_18.member_1[0u];
                                        let _e7820 = local_18.member_2[0u];
                                        let _e7824 = (_e7808[0] - _e7814[0]);
                                        let _e7825 = (_e7808[1] - _e7814[1]);
                                        let _e7826 = (_e7808[2] - _e7814[2]);
                                        let _e7835 = local_18.member[1u];
                                        let _e7841 = local_18.member_1[1u];
                                        let _e7847 = local_18.member_2[1u];
                                        let _e7851 = (_e7835[0] - _e7841[0]);
                                        let _e7852 = (_e7835[1] - _e7841[1]);
                                        let _e7853 = (_e7835[2] - _e7841[2]);
                                        let _e7862 = local_18.member[0u];
                                        if (_e7862[0] < 0f) {
                                            phi_4945_ = -(_e7862[0]);
                                        } else {
                                            phi_4945_ = _e7862[0];
                                        }
                                        let _e7869 = phi_4945_;
                                        if (_e7862[1] < 0f) {
                                            phi_4952_ = -(_e7862[1]);
                                        } else {
                                            phi_4952_ = _e7862[1];
                                        }
                                        let _e7873 = phi_4952_;
                                        if (_e7869 > _e7873) {
                                            phi_4957_ = _e7869;
                                        } else {
                                            phi_4957_ = _e7873;
                                        }
                                        let _e7876 = phi_4957_;
                                        if (_e7862[2] < 0f) {
                                            phi_4964_ = -(_e7862[2]);
                                        } else {
                                            phi_4964_ = _e7862[2];
                                        }
                                        let _e7880 = phi_4964_;
                                        if (_e7876 > _e7880) {
                                            phi_4969_ = _e7876;
                                        } else {
                                            phi_4969_ = _e7880;
                                        }
                                        let _e7883 = phi_4969_;
                                        let _e7886 = local_18.member[1u];
                                        if (_e7886[0] < 0f) {
                                            phi_4982_ = -(_e7886[0]);
                                        } else {
                                            phi_4982_ = _e7886[0];
                                        }
                                        let _e7893 = phi_4982_;
                                        if (_e7886[1] < 0f) {
                                            phi_4989_ = -(_e7886[1]);
                                        } else {
                                            phi_4989_ = _e7886[1];
                                        }
                                        let _e7897 = phi_4989_;
                                        if (_e7893 > _e7897) {
                                            phi_4994_ = _e7893;
                                        } else {
                                            phi_4994_ = _e7897;
                                        }
                                        let _e7900 = phi_4994_;
                                        if (_e7886[2] < 0f) {
                                            phi_5001_ = -(_e7886[2]);
                                        } else {
                                            phi_5001_ = _e7886[2];
                                        }
                                        let _e7904 = phi_5001_;
                                        if (_e7900 > _e7904) {
                                            phi_5006_ = _e7900;
                                        } else {
                                            phi_5006_ = _e7904;
                                        }
                                        let _e7907 = phi_5006_;
                                        if (_e7883 > _e7907) {
                                            phi_5011_ = _e7883;
                                        } else {
                                            phi_5011_ = _e7907;
                                        }
                                        let _e7910 = phi_5011_;
                                        let _e7912 = local_18.member_3;
                                        let _e7916 = local_18.member_1[0u];
                                        if (_e7916[0] < 0f) {
                                            phi_5028_ = -(_e7916[0]);
                                        } else {
                                            phi_5028_ = _e7916[0];
                                        }
                                        let _e7923 = phi_5028_;
                                        if (_e7916[1] < 0f) {
                                            phi_5035_ = -(_e7916[1]);
                                        } else {
                                            phi_5035_ = _e7916[1];
                                        }
                                        let _e7927 = phi_5035_;
                                        if (_e7923 > _e7927) {
                                            phi_5040_ = _e7923;
                                        } else {
                                            phi_5040_ = _e7927;
                                        }
                                        let _e7930 = phi_5040_;
                                        if (_e7916[2] < 0f) {
                                            phi_5047_ = -(_e7916[2]);
                                        } else {
                                            phi_5047_ = _e7916[2];
                                        }
                                        let _e7934 = phi_5047_;
                                        if (_e7930 > _e7934) {
                                            phi_5052_ = _e7930;
                                        } else {
                                            phi_5052_ = _e7934;
                                        }
                                        let _e7937 = phi_5052_;
                                        let _e7940 = local_18.member_1[1u];
                                        if (_e7940[0] < 0f) {
                                            phi_5066_ = -(_e7940[0]);
                                        } else {
                                            phi_5066_ = _e7940[0];
                                        }
                                        let _e7947 = phi_5066_;
                                        if (_e7940[1] < 0f) {
                                            phi_5073_ = -(_e7940[1]);
                                        } else {
                                            phi_5073_ = _e7940[1];
                                        }
                                        let _e7951 = phi_5073_;
                                        if (_e7947 > _e7951) {
                                            phi_5078_ = _e7947;
                                        } else {
                                            phi_5078_ = _e7951;
                                        }
                                        let _e7954 = phi_5078_;
                                        if (_e7940[2] < 0f) {
                                            phi_5085_ = -(_e7940[2]);
                                        } else {
                                            phi_5085_ = _e7940[2];
                                        }
                                        let _e7958 = phi_5085_;
                                        if (_e7954 > _e7958) {
                                            phi_5090_ = _e7954;
                                        } else {
                                            phi_5090_ = _e7958;
                                        }
                                        let _e7961 = phi_5090_;
                                        if (_e7937 > _e7961) {
                                            phi_5095_ = _e7937;
                                        } else {
                                            phi_5095_ = _e7961;
                                        }
                                        let _e7964 = phi_5095_;
                                        let _e7966 = local_18.member_3;
                                        let _e7970 = local_18.member_2[0u];
                                        if (_e7970[0] < 0f) {
                                            phi_5112_ = -(_e7970[0]);
                                        } else {
                                            phi_5112_ = _e7970[0];
                                        }
                                        let _e7977 = phi_5112_;
                                        if (_e7970[1] < 0f) {
                                            phi_5119_ = -(_e7970[1]);
                                        } else {
                                            phi_5119_ = _e7970[1];
                                        }
                                        let _e7981 = phi_5119_;
                                        if (_e7977 > _e7981) {
                                            phi_5124_ = _e7977;
                                        } else {
                                            phi_5124_ = _e7981;
                                        }
                                        let _e7984 = phi_5124_;
                                        if (_e7970[2] < 0f) {
                                            phi_5131_ = -(_e7970[2]);
                                        } else {
                                            phi_5131_ = _e7970[2];
                                        }
                                        let _e7988 = phi_5131_;
                                        if (_e7984 > _e7988) {
                                            phi_5136_ = _e7984;
                                        } else {
                                            phi_5136_ = _e7988;
                                        }
                                        let _e7991 = phi_5136_;
                                        let _e7994 = local_18.member_2[1u];
                                        if (_e7994[0] < 0f) {
                                            phi_5150_ = -(_e7994[0]);
                                        } else {
                                            phi_5150_ = _e7994[0];
                                        }
                                        let _e8001 = phi_5150_;
                                        if (_e7994[1] < 0f) {
                                            phi_5157_ = -(_e7994[1]);
                                        } else {
                                            phi_5157_ = _e7994[1];
                                        }
                                        let _e8005 = phi_5157_;
                                        if (_e8001 > _e8005) {
                                            phi_5162_ = _e8001;
                                        } else {
                                            phi_5162_ = _e8005;
                                        }
                                        let _e8008 = phi_5162_;
                                        if (_e7994[2] < 0f) {
                                            phi_5169_ = -(_e7994[2]);
                                        } else {
                                            phi_5169_ = _e7994[2];
                                        }
                                        let _e8012 = phi_5169_;
                                        if (_e8008 > _e8012) {
                                            phi_5174_ = _e8008;
                                        } else {
                                            phi_5174_ = _e8012;
                                        }
                                        let _e8015 = phi_5174_;
                                        if (_e7991 > _e8015) {
                                            phi_5179_ = _e7991;
                                        } else {
                                            phi_5179_ = _e8015;
                                        }
                                        let _e8018 = phi_5179_;
                                        let _e8020 = local_18.member_3;
                                        let _e8027 = local_18.member_3;
                                        local_14 = type_37(array<array<array<f32, 3>, 4>, 2>(array<array<f32, 3>, 4>(_e7808, array<f32, 3>(_e7824, _e7825, _e7826), array<f32, 3>((_e7808[0] - _e7820[0]), (_e7808[1] - _e7820[1]), (_e7808[2] - _e7820[2])), array<f32, 3>((_e7824 - _e7820[0]), (_e7825 - _e7820[1]), (_e7826 - _e7820[2]))), array<array<f32, 3>, 4>(_e7835, array<f32, 3>(_e7851, _e7852, _e7853), array<f32, 3>((_e7835[0] - _e7847[0]), (_e7835[1] - _e7847[1]), (_e7835[2] - _e7847[2])), array<f32, 3>((_e7851 - _e7847[0]), (_e7852 - _e7847[1]), (_e7853 - _e7847[2])))), ((((((_e7910 + _e7912) + (_e7964 + _e7966)) + (_e8018 + _e8020)) * (0.000000059604645f * 16f)) + (_e8027 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)), _e483.member_1);
                                        let _e8043 = local_14.member_1;
                                        if (_e7805 > _e8043) {
                                            if ((bitcast<u32>(_e7805) & 2139095040u) != 2139095040u) {
                                                let _e8048 = (1f / _e7805);
                                                let _e8050 = (_e7788[0] * _e8048);
                                                let _e8052 = (_e7788[1] * _e8048);
                                                let _e8054 = (_e7788[2] * _e8048);
                                                let _e8059 = (((_e8050 * _e8050) + (_e8052 * _e8052)) + (_e8054 * _e8054));
                                                if (_e8059 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e8059 > 0f) {
                                                        phi_5280_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_5280_ = 0f;
                                                    }
                                                    let _e8112 = phi_5280_;
                                                    phi_5344_ = _e8112;
                                                } else {
                                                    phi_5287_ = type_14(0i, 5i);
                                                    phi_5290_ = bitcast<f32>(((bitcast<u32>(_e8059) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e8067 = phi_5287_;
                                                        let _e8069 = phi_5290_;
                                                        local_44 = _e8069;
                                                        if (_e8067.member < _e8067.member_1) {
                                                            let _e8076 = (_e8067.member + 1i);
                                                            if ((false == (_e8076 > _e8067.member)) != false) {
                                                                phi_5311_ = true;
                                                            } else {
                                                                phi_5311_ = false;
                                                            }
                                                            let _e8081 = phi_5311_;
                                                            if _e8081 {
                                                                phi_5317_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_5317_ = type_15(1u, _e8076);
                                                            }
                                                            let _e8086 = phi_5317_;
                                                            phi_5288_ = type_14(_e8086.member_1, _e8067.member_1);
                                                            phi_5331_ = type_15(1u, _e8067.member);
                                                        } else {
                                                            phi_5288_ = _e8067;
                                                            phi_5331_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e8092 = phi_5288_;
                                                        let _e8094 = phi_5331_;
                                                        let _e8097 = (bitcast<i32>(_e8094.member) != 0i);
                                                        if _e8097 {
                                                            phi_5291_ = (0.5f * (_e8069 + (_e8059 / _e8069)));
                                                        } else {
                                                            phi_5291_ = f32();
                                                        }
                                                        let _e8102 = phi_5291_;
                                                        continue;
                                                        continuing {
                                                            phi_5287_ = _e8092;
                                                            phi_5290_ = _e8102;
                                                            break if !(_e8097);
                                                        }
                                                    }
                                                    let _e8107 = local_44;
                                                    phi_5344_ = (_e8107 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e8114 = phi_5344_;
                                                let _e8115 = (0.000000059604645f * 12f);
                                                let _e8117 = local_14.member_1;
                                                let _e8120 = local_14.member_2;
                                                let _e8124 = ((_e8117 * 1.01f) + ((_e8120 * _e8114) * (1f + _e8115)));
                                                let _e8128 = local_14.member[0u][0u];
                                                let _e8136 = (((_e8050 * _e8128[0]) + (_e8052 * _e8128[1])) + (_e8054 * _e8128[2]));
                                                let _e8140 = local_14.member[0u][1u];
                                                let _e8148 = (((_e8050 * _e8140[0]) + (_e8052 * _e8140[1])) + (_e8054 * _e8140[2]));
                                                let _e8152 = local_14.member[0u][2u];
                                                let _e8160 = (((_e8050 * _e8152[0]) + (_e8052 * _e8152[1])) + (_e8054 * _e8152[2]));
                                                let _e8164 = local_14.member[0u][3u];
                                                let _e8172 = (((_e8050 * _e8164[0]) + (_e8052 * _e8164[1])) + (_e8054 * _e8164[2]));
                                                let _e8176 = local_14.member[1u][0u];
                                                let _e8184 = (((_e8050 * _e8176[0]) + (_e8052 * _e8176[1])) + (_e8054 * _e8176[2]));
                                                let _e8188 = local_14.member[1u][1u];
                                                let _e8196 = (((_e8050 * _e8188[0]) + (_e8052 * _e8188[1])) + (_e8054 * _e8188[2]));
                                                let _e8200 = local_14.member[1u][2u];
                                                let _e8208 = (((_e8050 * _e8200[0]) + (_e8052 * _e8200[1])) + (_e8054 * _e8200[2]));
                                                let _e8212 = local_14.member[1u][3u];
                                                let _e8220 = (((_e8050 * _e8212[0]) + (_e8052 * _e8212[1])) + (_e8054 * _e8212[2]));
                                                if (_e8136 < 0f) {
                                                    phi_5478_ = -(_e8136);
                                                } else {
                                                    phi_5478_ = _e8136;
                                                }
                                                let _e8224 = phi_5478_;
                                                if (_e8184 < 0f) {
                                                    phi_5484_ = -(_e8184);
                                                } else {
                                                    phi_5484_ = _e8184;
                                                }
                                                let _e8228 = phi_5484_;
                                                if (_e8148 < 0f) {
                                                    phi_5493_ = -(_e8148);
                                                } else {
                                                    phi_5493_ = _e8148;
                                                }
                                                let _e8235 = phi_5493_;
                                                if (_e8196 < 0f) {
                                                    phi_5499_ = -(_e8196);
                                                } else {
                                                    phi_5499_ = _e8196;
                                                }
                                                let _e8239 = phi_5499_;
                                                if (_e8160 < 0f) {
                                                    phi_5508_ = -(_e8160);
                                                } else {
                                                    phi_5508_ = _e8160;
                                                }
                                                let _e8246 = phi_5508_;
                                                if (_e8208 < 0f) {
                                                    phi_5514_ = -(_e8208);
                                                } else {
                                                    phi_5514_ = _e8208;
                                                }
                                                let _e8250 = phi_5514_;
                                                if (_e8172 < 0f) {
                                                    phi_5523_ = -(_e8172);
                                                } else {
                                                    phi_5523_ = _e8172;
                                                }
                                                let _e8257 = phi_5523_;
                                                if (_e8220 < 0f) {
                                                    phi_5529_ = -(_e8220);
                                                } else {
                                                    phi_5529_ = _e8220;
                                                }
                                                let _e8261 = phi_5529_;
                                                local_15 = type_32(array<f32, 4>(_e8136, _e8148, _e8160, _e8172), array<f32, 4>(_e8184, _e8196, _e8208, _e8220), array<f32, 4>((_e8124 + ((_e8224 + _e8228) * _e8115)), (_e8124 + ((_e8235 + _e8239) * _e8115)), (_e8124 + ((_e8246 + _e8250) * _e8115)), (_e8124 + ((_e8257 + _e8261) * _e8115))));
                                                let _e8273 = (((_e8050 * _e8050) + (_e8052 * _e8052)) + (_e8054 * _e8054));
                                                if (_e8273 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e8273 > 0f) {
                                                        phi_5572_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_5572_ = 0f;
                                                    }
                                                    let _e8326 = phi_5572_;
                                                    phi_5636_ = _e8326;
                                                } else {
                                                    phi_5579_ = type_14(0i, 5i);
                                                    phi_5582_ = bitcast<f32>(((bitcast<u32>(_e8273) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e8281 = phi_5579_;
                                                        let _e8283 = phi_5582_;
                                                        local_45 = _e8283;
                                                        if (_e8281.member < _e8281.member_1) {
                                                            let _e8290 = (_e8281.member + 1i);
                                                            if ((false == (_e8290 > _e8281.member)) != false) {
                                                                phi_5603_ = true;
                                                            } else {
                                                                phi_5603_ = false;
                                                            }
                                                            let _e8295 = phi_5603_;
                                                            if _e8295 {
                                                                phi_5609_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_5609_ = type_15(1u, _e8290);
                                                            }
                                                            let _e8300 = phi_5609_;
                                                            phi_5580_ = type_14(_e8300.member_1, _e8281.member_1);
                                                            phi_5623_ = type_15(1u, _e8281.member);
                                                        } else {
                                                            phi_5580_ = _e8281;
                                                            phi_5623_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e8306 = phi_5580_;
                                                        let _e8308 = phi_5623_;
                                                        let _e8311 = (bitcast<i32>(_e8308.member) != 0i);
                                                        if _e8311 {
                                                            phi_5583_ = (0.5f * (_e8283 + (_e8273 / _e8283)));
                                                        } else {
                                                            phi_5583_ = f32();
                                                        }
                                                        let _e8316 = phi_5583_;
                                                        continue;
                                                        continuing {
                                                            phi_5579_ = _e8306;
                                                            phi_5582_ = _e8316;
                                                            break if !(_e8311);
                                                        }
                                                    }
                                                    let _e8321 = local_45;
                                                    phi_5636_ = (_e8321 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e8328 = phi_5636_;
                                                let _e8339 = (((_e7788[0] * _e7788[0]) + (_e7788[1] * _e7788[1])) + (_e7788[2] * _e7788[2]));
                                                if (_e8339 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e8339 > 0f) {
                                                        phi_5661_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_5661_ = 0f;
                                                    }
                                                    let _e8392 = phi_5661_;
                                                    phi_5725_ = _e8392;
                                                } else {
                                                    phi_5668_ = type_14(0i, 5i);
                                                    phi_5671_ = bitcast<f32>(((bitcast<u32>(_e8339) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e8347 = phi_5668_;
                                                        let _e8349 = phi_5671_;
                                                        local_46 = _e8349;
                                                        if (_e8347.member < _e8347.member_1) {
                                                            let _e8356 = (_e8347.member + 1i);
                                                            if ((false == (_e8356 > _e8347.member)) != false) {
                                                                phi_5692_ = true;
                                                            } else {
                                                                phi_5692_ = false;
                                                            }
                                                            let _e8361 = phi_5692_;
                                                            if _e8361 {
                                                                phi_5698_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_5698_ = type_15(1u, _e8356);
                                                            }
                                                            let _e8366 = phi_5698_;
                                                            phi_5669_ = type_14(_e8366.member_1, _e8347.member_1);
                                                            phi_5712_ = type_15(1u, _e8347.member);
                                                        } else {
                                                            phi_5669_ = _e8347;
                                                            phi_5712_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e8372 = phi_5669_;
                                                        let _e8374 = phi_5712_;
                                                        let _e8377 = (bitcast<i32>(_e8374.member) != 0i);
                                                        if _e8377 {
                                                            phi_5672_ = (0.5f * (_e8349 + (_e8339 / _e8349)));
                                                        } else {
                                                            phi_5672_ = f32();
                                                        }
                                                        let _e8382 = phi_5672_;
                                                        continue;
                                                        continuing {
                                                            phi_5668_ = _e8372;
                                                            phi_5671_ = _e8382;
                                                            break if !(_e8377);
                                                        }
                                                    }
                                                    let _e8387 = local_46;
                                                    phi_5725_ = (_e8387 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e8394 = phi_5725_;
                                                let _e8400 = local_18.member[0u];
                                                if (_e8400[0] < 0f) {
                                                    phi_5741_ = -(_e8400[0]);
                                                } else {
                                                    phi_5741_ = _e8400[0];
                                                }
                                                let _e8407 = phi_5741_;
                                                if (_e8400[1] < 0f) {
                                                    phi_5748_ = -(_e8400[1]);
                                                } else {
                                                    phi_5748_ = _e8400[1];
                                                }
                                                let _e8411 = phi_5748_;
                                                if (_e8407 > _e8411) {
                                                    phi_5753_ = _e8407;
                                                } else {
                                                    phi_5753_ = _e8411;
                                                }
                                                let _e8414 = phi_5753_;
                                                if (_e8400[2] < 0f) {
                                                    phi_5760_ = -(_e8400[2]);
                                                } else {
                                                    phi_5760_ = _e8400[2];
                                                }
                                                let _e8418 = phi_5760_;
                                                if (_e8414 > _e8418) {
                                                    phi_5765_ = _e8414;
                                                } else {
                                                    phi_5765_ = _e8418;
                                                }
                                                let _e8421 = phi_5765_;
                                                let _e8424 = local_18.member[1u];
                                                if (_e8424[0] < 0f) {
                                                    phi_5778_ = -(_e8424[0]);
                                                } else {
                                                    phi_5778_ = _e8424[0];
                                                }
                                                let _e8431 = phi_5778_;
                                                if (_e8424[1] < 0f) {
                                                    phi_5785_ = -(_e8424[1]);
                                                } else {
                                                    phi_5785_ = _e8424[1];
                                                }
                                                let _e8435 = phi_5785_;
                                                if (_e8431 > _e8435) {
                                                    phi_5790_ = _e8431;
                                                } else {
                                                    phi_5790_ = _e8435;
                                                }
                                                let _e8438 = phi_5790_;
                                                if (_e8424[2] < 0f) {
                                                    phi_5797_ = -(_e8424[2]);
                                                } else {
                                                    phi_5797_ = _e8424[2];
                                                }
                                                let _e8442 = phi_5797_;
                                                if (_e8438 > _e8442) {
                                                    phi_5802_ = _e8438;
                                                } else {
                                                    phi_5802_ = _e8442;
                                                }
                                                let _e8445 = phi_5802_;
                                                if (_e8421 > _e8445) {
                                                    phi_5807_ = _e8421;
                                                } else {
                                                    phi_5807_ = _e8445;
                                                }
                                                let _e8448 = phi_5807_;
                                                let _e8450 = local_18.member_3;
                                                let _e8454 = local_18.member_1[0u];
                                                if (_e8454[0] < 0f) {
                                                    phi_5824_ = -(_e8454[0]);
                                                } else {
                                                    phi_5824_ = _e8454[0];
                                                }
                                                let _e8461 = phi_5824_;
                                                if (_e8454[1] < 0f) {
                                                    phi_5831_ = -(_e8454[1]);
                                                } else {
                                                    phi_5831_ = _e8454[1];
                                                }
                                                let _e8465 = phi_5831_;
                                                if (_e8461 > _e8465) {
                                                    phi_5836_ = _e8461;
                                                } else {
                                                    phi_5836_ = _e8465;
                                                }
                                                let _e8468 = phi_5836_;
                                                if (_e8454[2] < 0f) {
                                                    phi_5843_ = -(_e8454[2]);
                                                } else {
                                                    phi_5843_ = _e8454[2];
                                                }
                                                let _e8472 = phi_5843_;
                                                if (_e8468 > _e8472) {
                                                    phi_5848_ = _e8468;
                                                } else {
                                                    phi_5848_ = _e8472;
                                                }
                                                let _e8475 = phi_5848_;
                                                let _e8478 = local_18.member_1[1u];
                                                if (_e8478[0] < 0f) {
                                                    phi_5862_ = -(_e8478[0]);
                                                } else {
                                                    phi_5862_ = _e8478[0];
                                                }
                                                let _e8485 = phi_5862_;
                                                if (_e8478[1] < 0f) {
                                                    phi_5869_ = -(_e8478[1]);
                                                } else {
                                                    phi_5869_ = _e8478[1];
                                                }
                                                let _e8489 = phi_5869_;
                                                if (_e8485 > _e8489) {
                                                    phi_5874_ = _e8485;
                                                } else {
                                                    phi_5874_ = _e8489;
                                                }
                                                let _e8492 = phi_5874_;
                                                if (_e8478[2] < 0f) {
                                                    phi_5881_ = -(_e8478[2]);
                                                } else {
                                                    phi_5881_ = _e8478[2];
                                                }
                                                let _e8496 = phi_5881_;
                                                if (_e8492 > _e8496) {
                                                    phi_5886_ = _e8492;
                                                } else {
                                                    phi_5886_ = _e8496;
                                                }
                                                let _e8499 = phi_5886_;
                                                if (_e8475 > _e8499) {
                                                    phi_5891_ = _e8475;
                                                } else {
                                                    phi_5891_ = _e8499;
                                                }
                                                let _e8502 = phi_5891_;
                                                let _e8504 = local_18.member_3;
                                                let _e8508 = local_18.member_2[0u];
                                                if (_e8508[0] < 0f) {
                                                    phi_5908_ = -(_e8508[0]);
                                                } else {
                                                    phi_5908_ = _e8508[0];
                                                }
                                                let _e8515 = phi_5908_;
                                                if (_e8508[1] < 0f) {
                                                    phi_5915_ = -(_e8508[1]);
                                                } else {
                                                    phi_5915_ = _e8508[1];
                                                }
                                                let _e8519 = phi_5915_;
                                                if (_e8515 > _e8519) {
                                                    phi_5920_ = _e8515;
                                                } else {
                                                    phi_5920_ = _e8519;
                                                }
                                                let _e8522 = phi_5920_;
                                                if (_e8508[2] < 0f) {
                                                    phi_5927_ = -(_e8508[2]);
                                                } else {
                                                    phi_5927_ = _e8508[2];
                                                }
                                                let _e8526 = phi_5927_;
                                                if (_e8522 > _e8526) {
                                                    phi_5932_ = _e8522;
                                                } else {
                                                    phi_5932_ = _e8526;
                                                }
                                                let _e8529 = phi_5932_;
                                                let _e8532 = local_18.member_2[1u];
                                                if (_e8532[0] < 0f) {
                                                    phi_5946_ = -(_e8532[0]);
                                                } else {
                                                    phi_5946_ = _e8532[0];
                                                }
                                                let _e8539 = phi_5946_;
                                                if (_e8532[1] < 0f) {
                                                    phi_5953_ = -(_e8532[1]);
                                                } else {
                                                    phi_5953_ = _e8532[1];
                                                }
                                                let _e8543 = phi_5953_;
                                                if (_e8539 > _e8543) {
                                                    phi_5958_ = _e8539;
                                                } else {
                                                    phi_5958_ = _e8543;
                                                }
                                                let _e8546 = phi_5958_;
                                                if (_e8532[2] < 0f) {
                                                    phi_5965_ = -(_e8532[2]);
                                                } else {
                                                    phi_5965_ = _e8532[2];
                                                }
                                                let _e8550 = phi_5965_;
                                                if (_e8546 > _e8550) {
                                                    phi_5970_ = _e8546;
                                                } else {
                                                    phi_5970_ = _e8550;
                                                }
                                                let _e8553 = phi_5970_;
                                                if (_e8529 > _e8553) {
                                                    phi_5975_ = _e8529;
                                                } else {
                                                    phi_5975_ = _e8553;
                                                }
                                                let _e8556 = phi_5975_;
                                                let _e8558 = local_18.member_3;
                                                let _e8565 = local_18.member_3;
                                                let _e8575 = ((((_e8394 * (1f + (0.000000059604645f * 8f))) + (((((((_e8448 + _e8450) + (_e8502 + _e8504)) + (_e8556 + _e8558)) * (0.000000059604645f * 16f)) + (_e8565 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) * _e8328) * (1f + (0.000000059604645f * 64f)));
                                                let _e8578 = local_15.member[0u];
                                                let _e8581 = local_15.member_1[0u];
                                                if (_e8578 < 0f) {
                                                    phi_6016_ = -(_e8578);
                                                } else {
                                                    phi_6016_ = _e8578;
                                                }
                                                let _e8586 = phi_6016_;
                                                if (_e8581 < 0f) {
                                                    phi_6022_ = -(_e8581);
                                                } else {
                                                    phi_6022_ = _e8581;
                                                }
                                                let _e8590 = phi_6022_;
                                                phi_6033_ = type_12(1u, 4u);
                                                phi_6036_ = ((_e8578 + ((_e8581 - _e8578) * _e5929)) - ((_e8043 * 1.01f) + ((_e8586 + _e8590) * (0.000000059604645f * 12f))));
                                                loop {
                                                    let _e8600 = phi_6033_;
                                                    let _e8602 = phi_6036_;
                                                    local_47 = _e8602;
                                                    local_48 = _e8602;
                                                    if (_e8600.member < _e8600.member_1) {
                                                        phi_6034_ = type_12((_e8600.member + 1u), _e8600.member_1);
                                                        phi_6059_ = type_12(1u, _e8600.member);
                                                    } else {
                                                        phi_6034_ = _e8600;
                                                        phi_6059_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e8614 = phi_6034_;
                                                    let _e8616 = phi_6059_;
                                                    let _e8620 = (bitcast<i32>(_e8616.member) != 0i);
                                                    if _e8620 {
                                                        let _e8623 = local_15.member[_e8616.member_1];
                                                        let _e8626 = local_15.member_1[_e8616.member_1];
                                                        if (_e8623 < 0f) {
                                                            phi_6088_ = -(_e8623);
                                                        } else {
                                                            phi_6088_ = _e8623;
                                                        }
                                                        let _e8631 = phi_6088_;
                                                        if (_e8626 < 0f) {
                                                            phi_6094_ = -(_e8626);
                                                        } else {
                                                            phi_6094_ = _e8626;
                                                        }
                                                        let _e8635 = phi_6094_;
                                                        let _e8643 = ((_e8623 + ((_e8626 - _e8623) * _e5929)) - ((_e8043 * 1.01f) + ((_e8631 + _e8635) * (0.000000059604645f * 12f))));
                                                        if (_e8602 < _e8643) {
                                                            phi_6107_ = _e8602;
                                                        } else {
                                                            phi_6107_ = _e8643;
                                                        }
                                                        let _e8646 = phi_6107_;
                                                        phi_6037_ = _e8646;
                                                    } else {
                                                        phi_6037_ = f32();
                                                    }
                                                    let _e8648 = phi_6037_;
                                                    continue;
                                                    continuing {
                                                        phi_6033_ = _e8614;
                                                        phi_6036_ = _e8648;
                                                        break if !(_e8620);
                                                    }
                                                }
                                                let _e8651 = local_47;
                                                if (_e8651 > 0f) {
                                                    let _e8655 = local_48;
                                                    let _e8658 = (((_e8575 - _e8655) / _e8575) * 2.02f);
                                                    if (_e8658 <= 0.000000000000000000000000000000000000011754944f) {
                                                        if (_e8658 > 0f) {
                                                            phi_6128_ = (0.000000000000000000106433627f * 2f);
                                                        } else {
                                                            phi_6128_ = 0f;
                                                        }
                                                        let _e8711 = phi_6128_;
                                                        phi_6192_ = _e8711;
                                                    } else {
                                                        phi_6135_ = type_14(0i, 5i);
                                                        phi_6138_ = bitcast<f32>(((bitcast<u32>(_e8658) >> bitcast<u32>(1i)) + 532369198u));
                                                        loop {
                                                            let _e8666 = phi_6135_;
                                                            let _e8668 = phi_6138_;
                                                            local_49 = _e8668;
                                                            if (_e8666.member < _e8666.member_1) {
                                                                let _e8675 = (_e8666.member + 1i);
                                                                if ((false == (_e8675 > _e8666.member)) != false) {
                                                                    phi_6159_ = true;
                                                                } else {
                                                                    phi_6159_ = false;
                                                                }
                                                                let _e8680 = phi_6159_;
                                                                if _e8680 {
                                                                    phi_6165_ = type_15(0u, type_15().member_1);
                                                                } else {
                                                                    phi_6165_ = type_15(1u, _e8675);
                                                                }
                                                                let _e8685 = phi_6165_;
                                                                phi_6136_ = type_14(_e8685.member_1, _e8666.member_1);
                                                                phi_6179_ = type_15(1u, _e8666.member);
                                                            } else {
                                                                phi_6136_ = _e8666;
                                                                phi_6179_ = type_15(0u, type_15().member_1);
                                                            }
                                                            let _e8691 = phi_6136_;
                                                            let _e8693 = phi_6179_;
                                                            let _e8696 = (bitcast<i32>(_e8693.member) != 0i);
                                                            if _e8696 {
                                                                phi_6139_ = (0.5f * (_e8668 + (_e8658 / _e8668)));
                                                            } else {
                                                                phi_6139_ = f32();
                                                            }
                                                            let _e8701 = phi_6139_;
                                                            continue;
                                                            continuing {
                                                                phi_6135_ = _e8691;
                                                                phi_6138_ = _e8701;
                                                                break if !(_e8696);
                                                            }
                                                        }
                                                        let _e8706 = local_49;
                                                        phi_6192_ = (_e8706 * (1f + (8f * 0.000000059604645f)));
                                                    }
                                                    let _e8713 = phi_6192_;
                                                    let _e8715 = ((_e8713 * _e8328) * 1.01f);
                                                    phi_6197_ = type_12(0u, 4u);
                                                    phi_6200_ = 2f;
                                                    phi_6202_ = true;
                                                    phi_6204_ = true;
                                                    loop {
                                                        let _e8717 = phi_6197_;
                                                        let _e8719 = phi_6200_;
                                                        let _e8721 = phi_6202_;
                                                        let _e8723 = phi_6204_;
                                                        local_50 = _e8719;
                                                        local_87 = _e8719;
                                                        local_51 = _e8721;
                                                        local_52 = _e8723;
                                                        local_88 = _e8723;
                                                        local_53 = _e8723;
                                                        if (_e8717.member < _e8717.member_1) {
                                                            phi_6198_ = type_12((_e8717.member + 1u), _e8717.member_1);
                                                            phi_6227_ = type_12(1u, _e8717.member);
                                                        } else {
                                                            phi_6198_ = _e8717;
                                                            phi_6227_ = type_12(0u, type_12().member_1);
                                                        }
                                                        let _e8735 = phi_6198_;
                                                        let _e8737 = phi_6227_;
                                                        let _e8741 = (bitcast<i32>(_e8737.member) != 0i);
                                                        if _e8741 {
                                                            let _e8745 = local_14.member[0u][_e8737.member_1];
                                                            let _e8752 = local_14.member[1u][_e8737.member_1];
                                                            if (_e8745[0] < 0f) {
                                                                phi_6264_ = -(_e8745[0]);
                                                            } else {
                                                                phi_6264_ = _e8745[0];
                                                            }
                                                            let _e8759 = phi_6264_;
                                                            if (_e8745[1] < 0f) {
                                                                phi_6271_ = -(_e8745[1]);
                                                            } else {
                                                                phi_6271_ = _e8745[1];
                                                            }
                                                            let _e8763 = phi_6271_;
                                                            if (_e8745[2] < 0f) {
                                                                phi_6279_ = -(_e8745[2]);
                                                            } else {
                                                                phi_6279_ = _e8745[2];
                                                            }
                                                            let _e8768 = phi_6279_;
                                                            let _e8769 = ((_e8759 + _e8763) + _e8768);
                                                            if (_e8752[0] < 0f) {
                                                                phi_6287_ = -(_e8752[0]);
                                                            } else {
                                                                phi_6287_ = _e8752[0];
                                                            }
                                                            let _e8773 = phi_6287_;
                                                            if (_e8752[1] < 0f) {
                                                                phi_6294_ = -(_e8752[1]);
                                                            } else {
                                                                phi_6294_ = _e8752[1];
                                                            }
                                                            let _e8777 = phi_6294_;
                                                            if (_e8752[2] < 0f) {
                                                                phi_6302_ = -(_e8752[2]);
                                                            } else {
                                                                phi_6302_ = _e8752[2];
                                                            }
                                                            let _e8782 = phi_6302_;
                                                            let _e8783 = ((_e8773 + _e8777) + _e8782);
                                                            if (_e8769 > _e8783) {
                                                                phi_6308_ = _e8769;
                                                            } else {
                                                                phi_6308_ = _e8783;
                                                            }
                                                            let _e8786 = phi_6308_;
                                                            let _e8790 = (_e8752[0] - _e8745[0]);
                                                            let _e8791 = (_e8752[1] - _e8745[1]);
                                                            let _e8792 = (_e8752[2] - _e8745[2]);
                                                            if (_e8790 < 0f) {
                                                                phi_6326_ = -(_e8790);
                                                            } else {
                                                                phi_6326_ = _e8790;
                                                            }
                                                            let _e8796 = phi_6326_;
                                                            if (_e8791 < 0f) {
                                                                phi_6332_ = -(_e8791);
                                                            } else {
                                                                phi_6332_ = _e8791;
                                                            }
                                                            let _e8800 = phi_6332_;
                                                            if (_e8792 < 0f) {
                                                                phi_6339_ = -(_e8792);
                                                            } else {
                                                                phi_6339_ = _e8792;
                                                            }
                                                            let _e8805 = phi_6339_;
                                                            let _e8812 = local_15.member[_e8737.member_1];
                                                            let _e8815 = local_15.member_1[_e8737.member_1];
                                                            if (_e8812 < 0f) {
                                                                phi_6365_ = -(_e8812);
                                                            } else {
                                                                phi_6365_ = _e8812;
                                                            }
                                                            let _e8820 = phi_6365_;
                                                            if (_e8815 < 0f) {
                                                                phi_6371_ = -(_e8815);
                                                            } else {
                                                                phi_6371_ = _e8815;
                                                            }
                                                            let _e8824 = phi_6371_;
                                                            let _e8828 = ((_e8043 * 1.01f) + ((_e8820 + _e8824) * (0.000000059604645f * 12f)));
                                                            let _e8835 = local_15.member_1[_e8737.member_1];
                                                            let _e8838 = local_15.member[_e8737.member_1];
                                                            let _e8839 = (_e8835 - _e8838);
                                                            let _e8842 = ((_e8828 + _e8828) + (_e8715 * ((((_e8796 + _e8800) + _e8805) + (_e8043 * 6f)) * 1.01f)));
                                                            let _e8845 = ((((_e8812 + ((_e8815 - _e8812) * _e5929)) - _e8828) - (_e8715 * ((_e8786 + (_e8043 * 3f)) * 1.01f))) - _e8575);
                                                            let _e8846 = (_e8845 > 0.000000000000000000000000000000000000011754944f);
                                                            let _e8847 = (_e8839 > _e8842);
                                                            if _e8847 {
                                                                phi_6407_ = true;
                                                            } else {
                                                                phi_6407_ = _e8846;
                                                            }
                                                            let _e8849 = phi_6407_;
                                                            if (_e8839 < -(_e8842)) {
                                                                phi_6414_ = true;
                                                            } else {
                                                                phi_6414_ = _e8846;
                                                            }
                                                            let _e8854 = phi_6414_;
                                                            if _e8847 {
                                                                phi_6435_ = _e8719;
                                                            } else {
                                                                if _e8846 {
                                                                    let _e8856 = (_e8842 - _e8839);
                                                                    if (_e8856 > 0.000000000000000000000000000000000000011754944f) {
                                                                        phi_6427_ = _e8856;
                                                                    } else {
                                                                        phi_6427_ = 0.000000000000000000000000000000000000011754944f;
                                                                    }
                                                                    let _e8859 = phi_6427_;
                                                                    let _e8860 = (_e8845 / _e8859);
                                                                    if (_e8719 < _e8860) {
                                                                        phi_6433_ = _e8719;
                                                                    } else {
                                                                        phi_6433_ = _e8860;
                                                                    }
                                                                    let _e8863 = phi_6433_;
                                                                    phi_6434_ = _e8863;
                                                                } else {
                                                                    phi_6434_ = _e8719;
                                                                }
                                                                let _e8865 = phi_6434_;
                                                                phi_6435_ = _e8865;
                                                            }
                                                            let _e8867 = phi_6435_;
                                                            phi_6201_ = _e8867;
                                                            phi_6203_ = (_e8721 && _e8854);
                                                            phi_6205_ = (_e8723 && _e8849);
                                                        } else {
                                                            phi_6201_ = f32();
                                                            phi_6203_ = bool();
                                                            phi_6205_ = bool();
                                                        }
                                                        let _e8869 = phi_6201_;
                                                        let _e8871 = phi_6203_;
                                                        let _e8873 = phi_6205_;
                                                        continue;
                                                        continuing {
                                                            phi_6197_ = _e8735;
                                                            phi_6200_ = _e8869;
                                                            phi_6202_ = _e8871;
                                                            phi_6204_ = _e8873;
                                                            break if !(_e8741);
                                                        }
                                                    }
                                                    let _e8876 = local_50;
                                                    if (_e8876 < 2f) {
                                                        let _e11309 = local_87;
                                                        phi_6440_ = _e11309;
                                                    } else {
                                                        phi_6440_ = 2f;
                                                    }
                                                    let _e8879 = phi_6440_;
                                                    let _e8880 = (_e8879 * 0.999f);
                                                    let _e8882 = local_51;
                                                    if _e8882 {
                                                        let _e8884 = local_52;
                                                        if _e8884 {
                                                            phi_6449_ = type_40();
                                                        } else {
                                                            phi_6449_ = type_40(1u, _e5929, 2f);
                                                        }
                                                        let _e8887 = phi_6449_;
                                                        phi_6450_ = _e8887;
                                                        let _e11316 = local_88;
                                                        phi_6451_ = _e11316;
                                                    } else {
                                                        phi_6450_ = type_40();
                                                        phi_6451_ = true;
                                                    }
                                                    let _e8889 = phi_6450_;
                                                    let _e8891 = phi_6451_;
                                                    if _e8891 {
                                                        let _e8893 = local_53;
                                                        if _e8893 {
                                                            if (_e8880 > (0.000000059604645f * 4096f)) {
                                                                let _e8897 = (_e5929 + _e8880);
                                                                if (_e8897 < _e285) {
                                                                    phi_6468_ = _e8897;
                                                                } else {
                                                                    phi_6468_ = _e285;
                                                                }
                                                                let _e8900 = phi_6468_;
                                                                phi_6469_ = _e8900;
                                                            } else {
                                                                phi_6469_ = _e5929;
                                                            }
                                                            let _e8902 = phi_6469_;
                                                            phi_6472_ = type_12(0u, 4u);
                                                            phi_6475_ = _e8902;
                                                            phi_6477_ = _e5929;
                                                            loop {
                                                                let _e8904 = phi_6472_;
                                                                let _e8906 = phi_6475_;
                                                                let _e8908 = phi_6477_;
                                                                local_54 = _e8906;
                                                                local_55 = _e8908;
                                                                local_56 = _e8908;
                                                                if (_e8904.member < _e8904.member_1) {
                                                                    phi_6473_ = type_12((_e8904.member + 1u), _e8904.member_1);
                                                                    phi_6500_ = type_12(1u, _e8904.member);
                                                                } else {
                                                                    phi_6473_ = _e8904;
                                                                    phi_6500_ = type_12(0u, type_12().member_1);
                                                                }
                                                                let _e8920 = phi_6473_;
                                                                let _e8922 = phi_6500_;
                                                                let _e8926 = (bitcast<i32>(_e8922.member) != 0i);
                                                                if _e8926 {
                                                                    let _e8929 = local_15.member[_e8922.member_1];
                                                                    let _e8932 = local_15.member_1[_e8922.member_1];
                                                                    let _e8935 = local_15.member[_e8922.member_1];
                                                                    let _e8941 = local_15.member_2[_e8922.member_1];
                                                                    let _e8942 = ((_e8929 + ((_e8932 - _e8935) * _e5929)) - _e8941);
                                                                    let _e8945 = local_15.member_1[_e8922.member_1];
                                                                    let _e8948 = local_15.member[_e8922.member_1];
                                                                    let _e8949 = (_e8945 - _e8948);
                                                                    if (_e8949 > 0f) {
                                                                        let _e8960 = (_e5929 - (_e8942 / _e8949));
                                                                        if (_e8908 > _e8960) {
                                                                            phi_6568_ = _e8908;
                                                                        } else {
                                                                            phi_6568_ = _e8960;
                                                                        }
                                                                        let _e8963 = phi_6568_;
                                                                        phi_6581_ = _e8906;
                                                                        phi_6582_ = _e8963;
                                                                    } else {
                                                                        if (_e8942 > 0f) {
                                                                            let _e8953 = (_e5929 - (_e8942 / _e8949));
                                                                            if (_e8906 < _e8953) {
                                                                                phi_6579_ = _e8906;
                                                                            } else {
                                                                                phi_6579_ = _e8953;
                                                                            }
                                                                            let _e8956 = phi_6579_;
                                                                            phi_6580_ = _e8956;
                                                                        } else {
                                                                            phi_6580_ = _e8906;
                                                                        }
                                                                        let _e8958 = phi_6580_;
                                                                        phi_6581_ = _e8958;
                                                                        phi_6582_ = _e8908;
                                                                    }
                                                                    let _e8965 = phi_6581_;
                                                                    let _e8967 = phi_6582_;
                                                                    phi_6476_ = _e8965;
                                                                    phi_6478_ = _e8967;
                                                                } else {
                                                                    phi_6476_ = f32();
                                                                    phi_6478_ = f32();
                                                                }
                                                                let _e8969 = phi_6476_;
                                                                let _e8971 = phi_6478_;
                                                                continue;
                                                                continuing {
                                                                    phi_6472_ = _e8920;
                                                                    phi_6475_ = _e8969;
                                                                    phi_6477_ = _e8971;
                                                                    break if !(_e8926);
                                                                }
                                                            }
                                                            let _e8974 = local_54;
                                                            let _e8976 = local_55;
                                                            let _e8980 = local_56;
                                                            let _e8981 = (_e8980 + ((_e8974 - _e8976) * 0.5f));
                                                            if (_e8981 > _e5929) {
                                                                if (_e8981 <= _e8902) {
                                                                    let _e8986 = local_15.member[0u];
                                                                    let _e8989 = local_15.member_1[0u];
                                                                    let _e8992 = local_15.member[0u];
                                                                    let _e8998 = local_15.member_2[0u];
                                                                    if (((_e8986 + ((_e8989 - _e8992) * _e8981)) - _e8998) > 0f) {
                                                                        let _e9003 = local_15.member[1u];
                                                                        let _e9006 = local_15.member_1[1u];
                                                                        let _e9009 = local_15.member[1u];
                                                                        let _e9015 = local_15.member_2[1u];
                                                                        if (((_e9003 + ((_e9006 - _e9009) * _e8981)) - _e9015) > 0f) {
                                                                            let _e9020 = local_15.member[2u];
                                                                            let _e9023 = local_15.member_1[2u];
                                                                            let _e9026 = local_15.member[2u];
                                                                            let _e9032 = local_15.member_2[2u];
                                                                            if (((_e9020 + ((_e9023 - _e9026) * _e8981)) - _e9032) > 0f) {
                                                                                let _e9037 = local_15.member[3u];
                                                                                let _e9040 = local_15.member_1[3u];
                                                                                let _e9043 = local_15.member[3u];
                                                                                let _e9049 = local_15.member_2[3u];
                                                                                phi_6743_ = (((_e9037 + ((_e9040 - _e9043) * _e8981)) - _e9049) > 0f);
                                                                                phi_6744_ = false;
                                                                            } else {
                                                                                phi_6743_ = bool();
                                                                                phi_6744_ = true;
                                                                            }
                                                                            let _e9053 = phi_6743_;
                                                                            let _e9055 = phi_6744_;
                                                                            phi_6745_ = _e9053;
                                                                            phi_6746_ = _e9055;
                                                                        } else {
                                                                            phi_6745_ = bool();
                                                                            phi_6746_ = true;
                                                                        }
                                                                        let _e9057 = phi_6745_;
                                                                        let _e9059 = phi_6746_;
                                                                        phi_6747_ = _e9057;
                                                                        phi_6748_ = _e9059;
                                                                    } else {
                                                                        phi_6747_ = bool();
                                                                        phi_6748_ = true;
                                                                    }
                                                                    let _e9061 = phi_6747_;
                                                                    let _e9063 = phi_6748_;
                                                                    if _e9063 {
                                                                        phi_6752_ = false;
                                                                    } else {
                                                                        phi_6752_ = _e9061;
                                                                    }
                                                                    let _e9065 = phi_6752_;
                                                                    if _e9065 {
                                                                        phi_6756_ = false;
                                                                    } else {
                                                                        phi_6756_ = true;
                                                                    }
                                                                    let _e9067 = phi_6756_;
                                                                    phi_6757_ = _e9067;
                                                                } else {
                                                                    phi_6757_ = true;
                                                                }
                                                                let _e9069 = phi_6757_;
                                                                phi_6758_ = _e9069;
                                                            } else {
                                                                phi_6758_ = true;
                                                            }
                                                            let _e9071 = phi_6758_;
                                                            if _e9071 {
                                                                phi_6762_ = 2f;
                                                            } else {
                                                                phi_6762_ = _e8981;
                                                            }
                                                            let _e9073 = phi_6762_;
                                                            phi_6765_ = type_40(2u, _e8902, _e9073);
                                                            phi_6766_ = type_40();
                                                            phi_6767_ = false;
                                                        } else {
                                                            phi_6765_ = type_40();
                                                            phi_6766_ = type_40(0u, _e5929, 2f);
                                                            phi_6767_ = true;
                                                        }
                                                        let _e9076 = phi_6765_;
                                                        let _e9078 = phi_6766_;
                                                        let _e9080 = phi_6767_;
                                                        phi_6768_ = _e9076;
                                                        phi_6769_ = _e9078;
                                                        phi_6770_ = _e9080;
                                                    } else {
                                                        phi_6768_ = type_40();
                                                        phi_6769_ = _e8889;
                                                        phi_6770_ = true;
                                                    }
                                                    let _e9082 = phi_6768_;
                                                    let _e9084 = phi_6769_;
                                                    let _e9086 = phi_6770_;
                                                    phi_6775_ = _e9084;
                                                    phi_6776_ = _e9082;
                                                    phi_6777_ = _e9086;
                                                } else {
                                                    phi_6775_ = type_40(0u, _e5929, 2f);
                                                    phi_6776_ = type_40();
                                                    phi_6777_ = true;
                                                }
                                                let _e9088 = phi_6775_;
                                                let _e9090 = phi_6776_;
                                                let _e9092 = phi_6777_;
                                                phi_6781_ = _e9088;
                                                phi_6782_ = _e9090;
                                                phi_6783_ = false;
                                                phi_6784_ = _e9092;
                                            } else {
                                                phi_6781_ = type_40();
                                                phi_6782_ = type_40();
                                                phi_6783_ = true;
                                                phi_6784_ = false;
                                            }
                                            let _e9094 = phi_6781_;
                                            let _e9096 = phi_6782_;
                                            let _e9098 = phi_6783_;
                                            let _e9100 = phi_6784_;
                                            phi_6785_ = _e9094;
                                            phi_6786_ = _e9096;
                                            phi_6787_ = _e9098;
                                            phi_6788_ = _e9100;
                                        } else {
                                            phi_6785_ = type_40();
                                            phi_6786_ = type_40();
                                            phi_6787_ = true;
                                            phi_6788_ = false;
                                        }
                                        let _e9102 = phi_6785_;
                                        let _e9104 = phi_6786_;
                                        let _e9106 = phi_6787_;
                                        let _e9108 = phi_6788_;
                                        if _e9106 {
                                            phi_6793_ = type_40(0u, _e5929, 2f);
                                            phi_6794_ = true;
                                        } else {
                                            phi_6793_ = _e9102;
                                            phi_6794_ = _e9108;
                                        }
                                        let _e9111 = phi_6793_;
                                        let _e9113 = phi_6794_;
                                        if _e9113 {
                                            phi_6798_ = _e9111;
                                        } else {
                                            phi_6798_ = _e9104;
                                        }
                                        let _e9115 = phi_6798_;
                                        if ((_e287 & 64u) != 0u) {
                                            if (_e9115.member == 2u) {
                                                let _e9119 = (_e9115.member_2 <= _e285);
                                                if _e9119 {
                                                    phi_6814_ = _e9115.member_2;
                                                    phi_6815_ = _e9115.member_2;
                                                    phi_6816_ = false;
                                                } else {
                                                    phi_6814_ = f32();
                                                    phi_6815_ = f32();
                                                    phi_6816_ = true;
                                                }
                                                let _e9123 = phi_6814_;
                                                let _e9125 = phi_6815_;
                                                let _e9127 = phi_6816_;
                                                phi_6817_ = _e9123;
                                                phi_6818_ = _e9125;
                                                phi_6819_ = _e9119;
                                                phi_6820_ = _e9127;
                                                phi_6821_ = false;
                                            } else {
                                                phi_6817_ = f32();
                                                phi_6818_ = f32();
                                                phi_6819_ = false;
                                                phi_6820_ = false;
                                                phi_6821_ = true;
                                            }
                                            let _e9129 = phi_6817_;
                                            let _e9131 = phi_6818_;
                                            let _e9133 = phi_6819_;
                                            let _e9135 = phi_6820_;
                                            let _e9137 = phi_6821_;
                                            phi_6822_ = _e9129;
                                            phi_6823_ = _e9131;
                                            phi_6824_ = _e9133;
                                            phi_6825_ = _e9135;
                                            phi_6826_ = _e9137;
                                        } else {
                                            phi_6822_ = f32();
                                            phi_6823_ = f32();
                                            phi_6824_ = false;
                                            phi_6825_ = false;
                                            phi_6826_ = true;
                                        }
                                        let _e9139 = phi_6822_;
                                        let _e9141 = phi_6823_;
                                        let _e9143 = phi_6824_;
                                        let _e9145 = phi_6825_;
                                        let _e9147 = phi_6826_;
                                        phi_6827_ = _e9139;
                                        phi_6828_ = _e9115.member;
                                        phi_6829_ = _e9141;
                                        phi_6830_ = _e9115;
                                        phi_6831_ = _e9115.member;
                                        phi_6832_ = _e9115.member;
                                        phi_6833_ = _e9143;
                                        phi_6834_ = _e9145;
                                        phi_6835_ = _e9147;
                                    }
                                    let _e9149 = phi_6827_;
                                    let _e9151 = phi_6828_;
                                    let _e9153 = phi_6829_;
                                    let _e9155 = phi_6830_;
                                    let _e9157 = phi_6831_;
                                    let _e9159 = phi_6832_;
                                    let _e9161 = phi_6833_;
                                    let _e9163 = phi_6834_;
                                    let _e9165 = phi_6835_;
                                    phi_6836_ = _e9149;
                                    phi_6837_ = _e9151;
                                    phi_6838_ = _e9153;
                                    phi_6839_ = _e9155;
                                    phi_6840_ = _e9157;
                                    phi_6841_ = _e9159;
                                    phi_6842_ = _e9161;
                                    phi_6843_ = _e7721;
                                    phi_6844_ = _e9163;
                                    phi_6845_ = _e9165;
                                    phi_6846_ = false;
                                } else {
                                    phi_6836_ = f32();
                                    phi_6837_ = u32();
                                    phi_6838_ = f32();
                                    phi_6839_ = type_40();
                                    phi_6840_ = u32();
                                    phi_6841_ = u32();
                                    phi_6842_ = false;
                                    phi_6843_ = false;
                                    phi_6844_ = false;
                                    phi_6845_ = false;
                                    phi_6846_ = true;
                                }
                                let _e9167 = phi_6836_;
                                let _e9169 = phi_6837_;
                                let _e9171 = phi_6838_;
                                let _e9173 = phi_6839_;
                                let _e9175 = phi_6840_;
                                let _e9177 = phi_6841_;
                                let _e9179 = phi_6842_;
                                let _e9181 = phi_6843_;
                                let _e9183 = phi_6844_;
                                let _e9185 = phi_6845_;
                                let _e9187 = phi_6846_;
                                phi_6847_ = _e7718;
                                phi_1927_ = _e9167;
                                phi_1929_ = _e9169;
                                phi_1931_ = _e9171;
                                phi_6848_ = _e9173;
                                phi_6849_ = _e9175;
                                phi_6850_ = _e7718;
                                phi_6851_ = _e9177;
                                phi_6852_ = _e9179;
                                phi_6853_ = _e9181;
                                phi_6854_ = _e9183;
                                phi_6855_ = _e9185;
                                phi_6856_ = false;
                                phi_6857_ = _e9187;
                            } else {
                                phi_6847_ = f32();
                                phi_1927_ = f32();
                                phi_1929_ = u32();
                                phi_1931_ = f32();
                                phi_6848_ = type_40();
                                phi_6849_ = u32();
                                phi_6850_ = f32();
                                phi_6851_ = u32();
                                phi_6852_ = false;
                                phi_6853_ = false;
                                phi_6854_ = false;
                                phi_6855_ = false;
                                phi_6856_ = true;
                                phi_6857_ = false;
                            }
                            let _e9189 = phi_6847_;
                            let _e9191 = phi_1927_;
                            let _e9193 = phi_1929_;
                            let _e9195 = phi_1931_;
                            let _e9197 = phi_6848_;
                            let _e9199 = phi_6849_;
                            let _e9201 = phi_6850_;
                            let _e9203 = phi_6851_;
                            let _e9205 = phi_6852_;
                            let _e9207 = phi_6853_;
                            let _e9209 = phi_6854_;
                            let _e9211 = phi_6855_;
                            let _e9213 = phi_6856_;
                            let _e9215 = phi_6857_;
                            local_57 = _e9207;
                            local_89 = _e9209;
                            local_90 = _e9211;
                            local_91 = _e9213;
                            local_92 = _e9215;
                            local_58 = _e9197;
                            local_59 = _e9197;
                            local_93 = _e9199;
                            local_60 = _e9197;
                            local_94 = _e9207;
                            local_95 = _e9203;
                            local_97 = _e9201;
                            local_98 = _e9189;
                            continue;
                            continuing {
                                phi_1923_ = _e5952;
                                phi_1926_ = _e9191;
                                phi_1928_ = _e9193;
                                phi_1930_ = _e9195;
                                break if !(_e9205);
                            }
                        }
                        let _e9218 = local_57;
                        if _e9218 {
                            phi_6861_ = false;
                            phi_6862_ = false;
                            phi_6863_ = false;
                            phi_6864_ = false;
                        } else {
                            let _e11416 = local_89;
                            phi_6861_ = _e11416;
                            let _e11419 = local_90;
                            phi_6862_ = _e11419;
                            let _e11422 = local_91;
                            phi_6863_ = _e11422;
                            let _e11425 = local_92;
                            phi_6864_ = _e11425;
                        }
                        let _e9220 = phi_6861_;
                        let _e9222 = phi_6862_;
                        let _e9224 = phi_6863_;
                        let _e9226 = phi_6864_;
                        if _e9220 {
                            let _e9228 = local_58;
                            if (_e9228.member_1 >= _e285) {
                                phi_6886_ = type_39(type_30(0u, f32()), 0u);
                            } else {
                                let _e9232 = local_59;
                                if (_e9232.member_1 > _e283) {
                                    phi_6881_ = 0u;
                                } else {
                                    let _e11430 = local_93;
                                    phi_6881_ = _e11430;
                                }
                                let _e9236 = phi_6881_;
                                let _e9238 = local_60;
                                phi_6886_ = type_39(type_30(2u, _e9238.member_1), _e9236);
                            }
                            let _e9245 = phi_6886_;
                            phi_6887_ = _e9245;
                            phi_6888_ = false;
                            phi_6889_ = false;
                            phi_6890_ = false;
                            phi_6891_ = false;
                        } else {
                            phi_6887_ = type_39();
                            phi_6888_ = _e9222;
                            let _e11437 = local_94;
                            phi_6889_ = _e11437;
                            phi_6890_ = _e9224;
                            phi_6891_ = _e9226;
                        }
                        let _e9247 = phi_6887_;
                        let _e9249 = phi_6888_;
                        let _e9251 = phi_6889_;
                        let _e9253 = phi_6890_;
                        let _e9255 = phi_6891_;
                        if _e9249 {
                            let _e11442 = local_95;
                            phi_6895_ = _e11442;
                            let _e11447 = local_97;
                            phi_6896_ = _e11447;
                            phi_6897_ = true;
                            phi_6898_ = false;
                            phi_6899_ = false;
                            phi_6900_ = false;
                        } else {
                            let _e11444 = local_96;
                            phi_6895_ = _e11444;
                            let _e11449 = local_98;
                            phi_6896_ = _e11449;
                            phi_6897_ = _e9251;
                            phi_6898_ = _e9253;
                            phi_6899_ = _e9255;
                            phi_6900_ = _e9220;
                        }
                        let _e9257 = phi_6895_;
                        let _e9259 = phi_6896_;
                        let _e9261 = phi_6897_;
                        let _e9263 = phi_6898_;
                        let _e9265 = phi_6899_;
                        let _e9267 = phi_6900_;
                        if _e9261 {
                            phi_6904_ = _e9259;
                            phi_6905_ = _e9257;
                            phi_6906_ = true;
                            phi_6907_ = false;
                            phi_6908_ = false;
                        } else {
                            let _e11456 = local_99;
                            phi_6904_ = _e11456;
                            let _e11459 = local_100;
                            phi_6905_ = _e11459;
                            phi_6906_ = _e9263;
                            phi_6907_ = _e9265;
                            phi_6908_ = _e9267;
                        }
                        let _e9269 = phi_6904_;
                        let _e9271 = phi_6905_;
                        let _e9273 = phi_6906_;
                        let _e9275 = phi_6907_;
                        let _e9277 = phi_6908_;
                        if _e9273 {
                            local_13[0u] = 0.01f;
                            local_13[1u] = 0f;
                            local_13[2u] = 0.8f;
                            if (_e281 >= (0.000000059604645f * 8f)) {
                                phi_6920_ = _e281;
                            } else {
                                phi_6920_ = 0f;
                            }
                            let _e9284 = phi_6920_;
                            phi_6923_ = type_12(0u, 3u);
                            loop {
                                let _e9286 = phi_6923_;
                                if (_e9286.member < _e9286.member_1) {
                                    phi_6924_ = type_12((_e9286.member + 1u), _e9286.member_1);
                                    phi_6947_ = type_12(1u, _e9286.member);
                                } else {
                                    phi_6924_ = _e9286;
                                    phi_6947_ = type_12(0u, type_12().member_1);
                                }
                                let _e9298 = phi_6924_;
                                let _e9300 = phi_6947_;
                                if (bitcast<i32>(_e9300.member) != 0i) {
                                    let _e9306 = local_13[_e9300.member_1];
                                    let _e9308 = (_e9269 + (_e9284 * _e9306));
                                    if (_e9308 < _e285) {
                                        phi_6968_ = _e9308;
                                    } else {
                                        phi_6968_ = _e285;
                                    }
                                    let _e9311 = phi_6968_;
                                    let _e9314 = local_18.member[0u];
                                    let _e9320 = local_18.member[1u];
                                    let _e9336 = local_18.member_1[0u];
                                    let _e9342 = local_18.member_1[1u];
                                    let _e9358 = local_18.member_2[0u];
                                    let _e9364 = local_18.member_2[1u];
                                    let _e9378 = function_3(array<f32, 3>((_e9314[0] + ((_e9320[0] - _e9314[0]) * _e9311)), (_e9314[1] + ((_e9320[1] - _e9314[1]) * _e9311)), (_e9314[2] + ((_e9320[2] - _e9314[2]) * _e9311))), array<f32, 3>((_e9336[0] + ((_e9342[0] - _e9336[0]) * _e9311)), (_e9336[1] + ((_e9342[1] - _e9336[1]) * _e9311)), (_e9336[2] + ((_e9342[2] - _e9336[2]) * _e9311))), array<f32, 3>((_e9358[0] + ((_e9364[0] - _e9358[0]) * _e9311)), (_e9358[1] + ((_e9364[1] - _e9358[1]) * _e9311)), (_e9358[2] + ((_e9364[2] - _e9358[2]) * _e9311))), 1u);
                                    let _e9389 = (((_e9378[0] * _e9378[0]) + (_e9378[1] * _e9378[1])) + (_e9378[2] * _e9378[2]));
                                    if (_e9389 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e9389 > 0f) {
                                            phi_7091_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_7091_ = 0f;
                                        }
                                        let _e9442 = phi_7091_;
                                        phi_7155_ = _e9442;
                                    } else {
                                        phi_7098_ = type_14(0i, 5i);
                                        phi_7101_ = bitcast<f32>(((bitcast<u32>(_e9389) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e9397 = phi_7098_;
                                            let _e9399 = phi_7101_;
                                            local_61 = _e9399;
                                            if (_e9397.member < _e9397.member_1) {
                                                let _e9406 = (_e9397.member + 1i);
                                                if ((false == (_e9406 > _e9397.member)) != false) {
                                                    phi_7122_ = true;
                                                } else {
                                                    phi_7122_ = false;
                                                }
                                                let _e9411 = phi_7122_;
                                                if _e9411 {
                                                    phi_7128_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_7128_ = type_15(1u, _e9406);
                                                }
                                                let _e9416 = phi_7128_;
                                                phi_7099_ = type_14(_e9416.member_1, _e9397.member_1);
                                                phi_7142_ = type_15(1u, _e9397.member);
                                            } else {
                                                phi_7099_ = _e9397;
                                                phi_7142_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e9422 = phi_7099_;
                                            let _e9424 = phi_7142_;
                                            let _e9427 = (bitcast<i32>(_e9424.member) != 0i);
                                            if _e9427 {
                                                phi_7102_ = (0.5f * (_e9399 + (_e9389 / _e9399)));
                                            } else {
                                                phi_7102_ = f32();
                                            }
                                            let _e9432 = phi_7102_;
                                            continue;
                                            continuing {
                                                phi_7098_ = _e9422;
                                                phi_7101_ = _e9432;
                                                break if !(_e9427);
                                            }
                                        }
                                        let _e9437 = local_61;
                                        phi_7155_ = (_e9437 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e9444 = phi_7155_;
                                    let _e9450 = local_18.member[0u];
                                    if (_e9450[0] < 0f) {
                                        phi_7171_ = -(_e9450[0]);
                                    } else {
                                        phi_7171_ = _e9450[0];
                                    }
                                    let _e9457 = phi_7171_;
                                    if (_e9450[1] < 0f) {
                                        phi_7178_ = -(_e9450[1]);
                                    } else {
                                        phi_7178_ = _e9450[1];
                                    }
                                    let _e9461 = phi_7178_;
                                    if (_e9457 > _e9461) {
                                        phi_7183_ = _e9457;
                                    } else {
                                        phi_7183_ = _e9461;
                                    }
                                    let _e9464 = phi_7183_;
                                    if (_e9450[2] < 0f) {
                                        phi_7190_ = -(_e9450[2]);
                                    } else {
                                        phi_7190_ = _e9450[2];
                                    }
                                    let _e9468 = phi_7190_;
                                    if (_e9464 > _e9468) {
                                        phi_7195_ = _e9464;
                                    } else {
                                        phi_7195_ = _e9468;
                                    }
                                    let _e9471 = phi_7195_;
                                    let _e9474 = local_18.member[1u];
                                    if (_e9474[0] < 0f) {
                                        phi_7208_ = -(_e9474[0]);
                                    } else {
                                        phi_7208_ = _e9474[0];
                                    }
                                    let _e9481 = phi_7208_;
                                    if (_e9474[1] < 0f) {
                                        phi_7215_ = -(_e9474[1]);
                                    } else {
                                        phi_7215_ = _e9474[1];
                                    }
                                    let _e9485 = phi_7215_;
                                    if (_e9481 > _e9485) {
                                        phi_7220_ = _e9481;
                                    } else {
                                        phi_7220_ = _e9485;
                                    }
                                    let _e9488 = phi_7220_;
                                    if (_e9474[2] < 0f) {
                                        phi_7227_ = -(_e9474[2]);
                                    } else {
                                        phi_7227_ = _e9474[2];
                                    }
                                    let _e9492 = phi_7227_;
                                    if (_e9488 > _e9492) {
                                        phi_7232_ = _e9488;
                                    } else {
                                        phi_7232_ = _e9492;
                                    }
                                    let _e9495 = phi_7232_;
                                    if (_e9471 > _e9495) {
                                        phi_7237_ = _e9471;
                                    } else {
                                        phi_7237_ = _e9495;
                                    }
                                    let _e9498 = phi_7237_;
                                    let _e9500 = local_18.member_3;
                                    let _e9504 = local_18.member_1[0u];
                                    if (_e9504[0] < 0f) {
                                        phi_7254_ = -(_e9504[0]);
                                    } else {
                                        phi_7254_ = _e9504[0];
                                    }
                                    let _e9511 = phi_7254_;
                                    if (_e9504[1] < 0f) {
                                        phi_7261_ = -(_e9504[1]);
                                    } else {
                                        phi_7261_ = _e9504[1];
                                    }
                                    let _e9515 = phi_7261_;
                                    if (_e9511 > _e9515) {
                                        phi_7266_ = _e9511;
                                    } else {
                                        phi_7266_ = _e9515;
                                    }
                                    let _e9518 = phi_7266_;
                                    if (_e9504[2] < 0f) {
                                        phi_7273_ = -(_e9504[2]);
                                    } else {
                                        phi_7273_ = _e9504[2];
                                    }
                                    let _e9522 = phi_7273_;
                                    if (_e9518 > _e9522) {
                                        phi_7278_ = _e9518;
                                    } else {
                                        phi_7278_ = _e9522;
                                    }
                                    let _e9525 = phi_7278_;
                                    let _e9528 = local_18.member_1[1u];
                                    if (_e9528[0] < 0f) {
                                        phi_7292_ = -(_e9528[0]);
                                    } else {
                                        phi_7292_ = _e9528[0];
                                    }
                                    let _e9535 = phi_7292_;
                                    if (_e9528[1] < 0f) {
                                        phi_7299_ = -(_e9528[1]);
                                    } else {
                                        phi_7299_ = _e9528[1];
                                    }
                                    let _e9539 = phi_7299_;
                                    if (_e9535 > _e9539) {
                                        phi_7304_ = _e9535;
                                    } else {
                                        phi_7304_ = _e9539;
                                    }
                                    let _e9542 = phi_7304_;
                                    if (_e9528[2] < 0f) {
                                        phi_7311_ = -(_e9528[2]);
                                    } else {
                                        phi_7311_ = _e9528[2];
                                    }
                                    let _e9546 = phi_7311_;
                                    if (_e9542 > _e9546) {
                                        phi_7316_ = _e9542;
                                    } else {
                                        phi_7316_ = _e9546;
                                    }
                                    let _e9549 = phi_7316_;
                                    if (_e9525 > _e9549) {
                                        phi_7321_ = _e9525;
                                    } else {
                                        phi_7321_ = _e9549;
                                    }
                                    let _e9552 = phi_7321_;
                                    let _e9554 = local_18.member_3;
                                    let _e9558 = local_18.member_2[0u];
                                    if (_e9558[0] < 0f) {
                                        phi_7338_ = -(_e9558[0]);
                                    } else {
                                        phi_7338_ = _e9558[0];
                                    }
                                    let _e9565 = phi_7338_;
                                    if (_e9558[1] < 0f) {
                                        phi_7345_ = -(_e9558[1]);
                                    } else {
                                        phi_7345_ = _e9558[1];
                                    }
                                    let _e9569 = phi_7345_;
                                    if (_e9565 > _e9569) {
                                        phi_7350_ = _e9565;
                                    } else {
                                        phi_7350_ = _e9569;
                                    }
                                    let _e9572 = phi_7350_;
                                    if (_e9558[2] < 0f) {
                                        phi_7357_ = -(_e9558[2]);
                                    } else {
                                        phi_7357_ = _e9558[2];
                                    }
                                    let _e9576 = phi_7357_;
                                    if (_e9572 > _e9576) {
                                        phi_7362_ = _e9572;
                                    } else {
                                        phi_7362_ = _e9576;
                                    }
                                    let _e9579 = phi_7362_;
                                    let _e9582 = local_18.member_2[1u];
                                    if (_e9582[0] < 0f) {
                                        phi_7376_ = -(_e9582[0]);
                                    } else {
                                        phi_7376_ = _e9582[0];
                                    }
                                    let _e9589 = phi_7376_;
                                    if (_e9582[1] < 0f) {
                                        phi_7383_ = -(_e9582[1]);
                                    } else {
                                        phi_7383_ = _e9582[1];
                                    }
                                    let _e9593 = phi_7383_;
                                    if (_e9589 > _e9593) {
                                        phi_7388_ = _e9589;
                                    } else {
                                        phi_7388_ = _e9593;
                                    }
                                    let _e9596 = phi_7388_;
                                    if (_e9582[2] < 0f) {
                                        phi_7395_ = -(_e9582[2]);
                                    } else {
                                        phi_7395_ = _e9582[2];
                                    }
                                    let _e9600 = phi_7395_;
                                    if (_e9596 > _e9600) {
                                        phi_7400_ = _e9596;
                                    } else {
                                        phi_7400_ = _e9600;
                                    }
                                    let _e9603 = phi_7400_;
                                    if (_e9579 > _e9603) {
                                        phi_7405_ = _e9579;
                                    } else {
                                        phi_7405_ = _e9603;
                                    }
                                    let _e9606 = phi_7405_;
                                    let _e9608 = local_18.member_3;
                                    let _e9615 = local_18.member_3;
                                    let _e9622 = (((_e9444 * (1f + (0.000000059604645f * 8f))) + (((((((_e9498 + _e9500) + (_e9552 + _e9554)) + (_e9606 + _e9608)) * (0.000000059604645f * 16f)) + (_e9615 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 4f)) <= _e483.member_1);
                                    if _e9622 {
                                        phi_7425_ = false;
                                    } else {
                                        phi_7425_ = true;
                                    }
                                    let _e9624 = phi_7425_;
                                    phi_7426_ = _e9624;
                                    phi_7427_ = _e9622;
                                } else {
                                    phi_7426_ = false;
                                    phi_7427_ = false;
                                }
                                let _e9626 = phi_7426_;
                                let _e9628 = phi_7427_;
                                local_62 = _e9628;
                                continue;
                                continuing {
                                    phi_6923_ = _e9298;
                                    break if !(_e9626);
                                }
                            }
                            let _e9631 = local_62;
                            if _e9631 {
                                if (_e9269 > _e283) {
                                    phi_7435_ = 1u;
                                } else {
                                    phi_7435_ = _e9271;
                                }
                                let _e9634 = phi_7435_;
                                phi_7439_ = type_39(type_30(1u, _e9269), _e9634);
                                phi_7440_ = false;
                            } else {
                                phi_7439_ = type_39();
                                phi_7440_ = true;
                            }
                            let _e9638 = phi_7439_;
                            let _e9640 = phi_7440_;
                            if _e9640 {
                                if (_e9269 > _e283) {
                                    phi_7448_ = 0u;
                                } else {
                                    phi_7448_ = _e9271;
                                }
                                let _e9643 = phi_7448_;
                                phi_7452_ = type_39(type_30(2u, _e9269), _e9643);
                            } else {
                                phi_7452_ = _e9638;
                            }
                            let _e9647 = phi_7452_;
                            phi_7453_ = _e9647;
                            phi_7454_ = false;
                            phi_7455_ = false;
                        } else {
                            phi_7453_ = type_39();
                            phi_7454_ = _e9275;
                            phi_7455_ = _e9277;
                        }
                        let _e9649 = phi_7453_;
                        let _e9651 = phi_7454_;
                        let _e9653 = phi_7455_;
                        if _e9651 {
                            phi_7462_ = type_39(type_30(0u, f32()), 0u);
                            phi_7463_ = true;
                        } else {
                            phi_7462_ = _e9247;
                            phi_7463_ = _e9653;
                        }
                        let _e9657 = phi_7462_;
                        let _e9659 = phi_7463_;
                        phi_7467_ = _e9657;
                        phi_7468_ = _e9649;
                        phi_7469_ = _e9659;
                    } else {
                        phi_7467_ = _e5919;
                        phi_7468_ = type_39();
                        phi_7469_ = true;
                    }
                    let _e9661 = phi_7467_;
                    let _e9663 = phi_7468_;
                    let _e9665 = phi_7469_;
                    if _e9665 {
                        phi_7473_ = _e9661;
                    } else {
                        phi_7473_ = _e9663;
                    }
                    let _e9667 = phi_7473_;
                    phi_14988_ = _e9667;
                } else {
                    let _e527 = local_18.member_1[0u];
                    let _e533 = local_18.member_2[0u];
                    let _e539 = ((_e527[1] * _e533[2]) - (_e527[2] * _e533[1]));
                    let _e542 = ((_e527[2] * _e533[0]) - (_e527[0] * _e533[2]));
                    let _e545 = ((_e527[0] * _e533[1]) - (_e527[1] * _e533[0]));
                    let _e548 = local_18.member_1[1u];
                    let _e554 = local_18.member_2[1u];
                    let _e560 = ((_e548[1] * _e554[2]) - (_e548[2] * _e554[1]));
                    let _e563 = ((_e548[2] * _e554[0]) - (_e548[0] * _e554[2]));
                    let _e566 = ((_e548[0] * _e554[1]) - (_e548[1] * _e554[0]));
                    let _e569 = local_18.member_1[0u];
                    let _e575 = local_18.member_2[1u];
                    let _e590 = local_18.member_1[1u];
                    let _e596 = local_18.member_2[0u];
                    let _e609 = (((_e569[1] * _e575[2]) - (_e569[2] * _e575[1])) + ((_e590[1] * _e596[2]) - (_e590[2] * _e596[1])));
                    let _e610 = (((_e569[2] * _e575[0]) - (_e569[0] * _e575[2])) + ((_e590[2] * _e596[0]) - (_e590[0] * _e596[2])));
                    let _e611 = (((_e569[0] * _e575[1]) - (_e569[1] * _e575[0])) + ((_e590[0] * _e596[1]) - (_e590[1] * _e596[0])));
                    let _e614 = local_18.member[0u];
                    let _e622 = (((_e614[0] * _e539) + (_e614[1] * _e542)) + (_e614[2] * _e545));
                    let _e625 = local_18.member[1u];
                    let _e636 = local_18.member[0u];
                    let _e645 = ((((_e625[0] * _e539) + (_e625[1] * _e542)) + (_e625[2] * _e545)) + (((_e636[0] * _e609) + (_e636[1] * _e610)) + (_e636[2] * _e611)));
                    let _e648 = local_18.member[0u];
                    let _e659 = local_18.member[1u];
                    let _e668 = ((((_e648[0] * _e560) + (_e648[1] * _e563)) + (_e648[2] * _e566)) + (((_e659[0] * _e609) + (_e659[1] * _e610)) + (_e659[2] * _e611)));
                    let _e671 = local_18.member[1u];
                    let _e679 = (((_e671[0] * _e560) + (_e671[1] * _e563)) + (_e671[2] * _e566));
                    let _e682 = local_18.member[0u];
                    if (_e682[0] < 0f) {
                        phi_7715_ = -(_e682[0]);
                    } else {
                        phi_7715_ = _e682[0];
                    }
                    let _e689 = phi_7715_;
                    if (_e682[1] < 0f) {
                        phi_7722_ = -(_e682[1]);
                    } else {
                        phi_7722_ = _e682[1];
                    }
                    let _e693 = phi_7722_;
                    if (_e689 > _e693) {
                        phi_7727_ = _e689;
                    } else {
                        phi_7727_ = _e693;
                    }
                    let _e696 = phi_7727_;
                    if (_e682[2] < 0f) {
                        phi_7734_ = -(_e682[2]);
                    } else {
                        phi_7734_ = _e682[2];
                    }
                    let _e700 = phi_7734_;
                    if (_e696 > _e700) {
                        phi_7739_ = _e696;
                    } else {
                        phi_7739_ = _e700;
                    }
                    let _e703 = phi_7739_;
                    let _e706 = local_18.member[1u];
                    if (_e706[0] < 0f) {
                        phi_7752_ = -(_e706[0]);
                    } else {
                        phi_7752_ = _e706[0];
                    }
                    let _e713 = phi_7752_;
                    if (_e706[1] < 0f) {
                        phi_7759_ = -(_e706[1]);
                    } else {
                        phi_7759_ = _e706[1];
                    }
                    let _e717 = phi_7759_;
                    if (_e713 > _e717) {
                        phi_7764_ = _e713;
                    } else {
                        phi_7764_ = _e717;
                    }
                    let _e720 = phi_7764_;
                    if (_e706[2] < 0f) {
                        phi_7771_ = -(_e706[2]);
                    } else {
                        phi_7771_ = _e706[2];
                    }
                    let _e724 = phi_7771_;
                    if (_e720 > _e724) {
                        phi_7776_ = _e720;
                    } else {
                        phi_7776_ = _e724;
                    }
                    let _e727 = phi_7776_;
                    if (_e703 > _e727) {
                        phi_7781_ = _e703;
                    } else {
                        phi_7781_ = _e727;
                    }
                    let _e730 = phi_7781_;
                    let _e732 = local_18.member_3;
                    let _e733 = (_e730 + _e732);
                    let _e736 = local_18.member_1[0u];
                    if (_e736[0] < 0f) {
                        phi_7798_ = -(_e736[0]);
                    } else {
                        phi_7798_ = _e736[0];
                    }
                    let _e743 = phi_7798_;
                    if (_e736[1] < 0f) {
                        phi_7805_ = -(_e736[1]);
                    } else {
                        phi_7805_ = _e736[1];
                    }
                    let _e747 = phi_7805_;
                    if (_e743 > _e747) {
                        phi_7810_ = _e743;
                    } else {
                        phi_7810_ = _e747;
                    }
                    let _e750 = phi_7810_;
                    if (_e736[2] < 0f) {
                        phi_7817_ = -(_e736[2]);
                    } else {
                        phi_7817_ = _e736[2];
                    }
                    let _e754 = phi_7817_;
                    if (_e750 > _e754) {
                        phi_7822_ = _e750;
                    } else {
                        phi_7822_ = _e754;
                    }
                    let _e757 = phi_7822_;
                    let _e760 = local_18.member_1[1u];
                    if (_e760[0] < 0f) {
                        phi_7836_ = -(_e760[0]);
                    } else {
                        phi_7836_ = _e760[0];
                    }
                    let _e767 = phi_7836_;
                    if (_e760[1] < 0f) {
                        phi_7843_ = -(_e760[1]);
                    } else {
                        phi_7843_ = _e760[1];
                    }
                    let _e771 = phi_7843_;
                    if (_e767 > _e771) {
                        phi_7848_ = _e767;
                    } else {
                        phi_7848_ = _e771;
                    }
                    let _e774 = phi_7848_;
                    if (_e760[2] < 0f) {
                        phi_7855_ = -(_e760[2]);
                    } else {
                        phi_7855_ = _e760[2];
                    }
                    let _e778 = phi_7855_;
                    if (_e774 > _e778) {
                        phi_7860_ = _e774;
                    } else {
                        phi_7860_ = _e778;
                    }
                    let _e781 = phi_7860_;
                    if (_e757 > _e781) {
                        phi_7865_ = _e757;
                    } else {
                        phi_7865_ = _e781;
                    }
                    let _e784 = phi_7865_;
                    let _e786 = local_18.member_3;
                    let _e787 = (_e784 + _e786);
                    let _e790 = local_18.member_2[0u];
                    if (_e790[0] < 0f) {
                        phi_7882_ = -(_e790[0]);
                    } else {
                        phi_7882_ = _e790[0];
                    }
                    let _e797 = phi_7882_;
                    if (_e790[1] < 0f) {
                        phi_7889_ = -(_e790[1]);
                    } else {
                        phi_7889_ = _e790[1];
                    }
                    let _e801 = phi_7889_;
                    if (_e797 > _e801) {
                        phi_7894_ = _e797;
                    } else {
                        phi_7894_ = _e801;
                    }
                    let _e804 = phi_7894_;
                    if (_e790[2] < 0f) {
                        phi_7901_ = -(_e790[2]);
                    } else {
                        phi_7901_ = _e790[2];
                    }
                    let _e808 = phi_7901_;
                    if (_e804 > _e808) {
                        phi_7906_ = _e804;
                    } else {
                        phi_7906_ = _e808;
                    }
                    let _e811 = phi_7906_;
                    let _e814 = local_18.member_2[1u];
                    if (_e814[0] < 0f) {
                        phi_7920_ = -(_e814[0]);
                    } else {
                        phi_7920_ = _e814[0];
                    }
                    let _e821 = phi_7920_;
                    if (_e814[1] < 0f) {
                        phi_7927_ = -(_e814[1]);
                    } else {
                        phi_7927_ = _e814[1];
                    }
                    let _e825 = phi_7927_;
                    if (_e821 > _e825) {
                        phi_7932_ = _e821;
                    } else {
                        phi_7932_ = _e825;
                    }
                    let _e828 = phi_7932_;
                    if (_e814[2] < 0f) {
                        phi_7939_ = -(_e814[2]);
                    } else {
                        phi_7939_ = _e814[2];
                    }
                    let _e832 = phi_7939_;
                    if (_e828 > _e832) {
                        phi_7944_ = _e828;
                    } else {
                        phi_7944_ = _e832;
                    }
                    let _e835 = phi_7944_;
                    if (_e811 > _e835) {
                        phi_7949_ = _e811;
                    } else {
                        phi_7949_ = _e835;
                    }
                    let _e838 = phi_7949_;
                    let _e840 = local_18.member_3;
                    let _e841 = (_e838 + _e840);
                    let _e843 = ((_e787 * 8f) * _e841);
                    let _e850 = local_18.member_3;
                    if (_e539 < 0f) {
                        phi_7980_ = -(_e539);
                    } else {
                        phi_7980_ = _e539;
                    }
                    let _e867 = phi_7980_;
                    if (_e542 < 0f) {
                        phi_7986_ = -(_e542);
                    } else {
                        phi_7986_ = _e542;
                    }
                    let _e871 = phi_7986_;
                    if (_e545 < 0f) {
                        phi_7993_ = -(_e545);
                    } else {
                        phi_7993_ = _e545;
                    }
                    let _e876 = phi_7993_;
                    let _e877 = ((_e867 + _e871) + _e876);
                    if (_e560 < 0f) {
                        phi_8000_ = -(_e560);
                    } else {
                        phi_8000_ = _e560;
                    }
                    let _e881 = phi_8000_;
                    if (_e563 < 0f) {
                        phi_8006_ = -(_e563);
                    } else {
                        phi_8006_ = _e563;
                    }
                    let _e885 = phi_8006_;
                    if (_e566 < 0f) {
                        phi_8013_ = -(_e566);
                    } else {
                        phi_8013_ = _e566;
                    }
                    let _e890 = phi_8013_;
                    let _e891 = ((_e881 + _e885) + _e890);
                    if (_e877 > _e891) {
                        phi_8019_ = _e877;
                    } else {
                        phi_8019_ = _e891;
                    }
                    let _e894 = phi_8019_;
                    if (_e609 < 0f) {
                        phi_8025_ = -(_e609);
                    } else {
                        phi_8025_ = _e609;
                    }
                    let _e898 = phi_8025_;
                    if (_e610 < 0f) {
                        phi_8031_ = -(_e610);
                    } else {
                        phi_8031_ = _e610;
                    }
                    let _e902 = phi_8031_;
                    if (_e611 < 0f) {
                        phi_8038_ = -(_e611);
                    } else {
                        phi_8038_ = _e611;
                    }
                    let _e907 = phi_8038_;
                    let _e909 = (((_e898 + _e902) + _e907) * 0.5f);
                    if (_e894 > _e909) {
                        phi_8045_ = _e894;
                    } else {
                        phi_8045_ = _e909;
                    }
                    let _e912 = phi_8045_;
                    let _e917 = local_18.member_3;
                    let _e929 = (((((_e733 * 8f) * _e843) * (0.000000059604645f * (524f / 64f))) + ((_e850 * 19f) * ((_e733 * (_e787 + _e841)) + (_e787 * _e841)))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e733) * ((1f + _e787) * (1f + _e841)))));
                    let _e930 = (_e622 * 3f);
                    let _e931 = (_e679 * 3f);
                    if (_e930 < _e931) {
                        phi_8069_ = _e930;
                    } else {
                        phi_8069_ = _e931;
                    }
                    let _e934 = phi_8069_;
                    if (_e645 < _e668) {
                        phi_8074_ = _e645;
                    } else {
                        phi_8074_ = _e668;
                    }
                    let _e937 = phi_8074_;
                    if (_e934 < _e937) {
                        phi_8079_ = _e934;
                    } else {
                        phi_8079_ = _e937;
                    }
                    let _e940 = phi_8079_;
                    if (_e930 > _e931) {
                        phi_8084_ = _e930;
                    } else {
                        phi_8084_ = _e931;
                    }
                    let _e943 = phi_8084_;
                    if (_e645 > _e668) {
                        phi_8089_ = _e645;
                    } else {
                        phi_8089_ = _e668;
                    }
                    let _e946 = phi_8089_;
                    if (_e943 > _e946) {
                        phi_8094_ = _e943;
                    } else {
                        phi_8094_ = _e946;
                    }
                    let _e949 = phi_8094_;
                    let _e954 = -(_e949);
                    if (_e940 > _e954) {
                        phi_8104_ = _e940;
                    } else {
                        phi_8104_ = _e954;
                    }
                    let _e957 = phi_8104_;
                    if ((_e957 - (_e929 + ((0f * (((_e912 + (_e843 * (0.000000059604645f * 8f))) + ((_e917 * 6f) * (_e787 + _e841))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e787) * (1f + _e841))))) * (3f * 1.0001f)))) > 0f) {
                        phi_14958_ = type_30(0u, type_30().member_1);
                        phi_14959_ = type_30();
                        phi_14960_ = true;
                    } else {
                        if (_e622 < 0f) {
                            phi_8117_ = -(_e622);
                        } else {
                            phi_8117_ = _e622;
                        }
                        let _e964 = phi_8117_;
                        if (_e645 < 0f) {
                            phi_8123_ = -(_e645);
                        } else {
                            phi_8123_ = _e645;
                        }
                        let _e968 = phi_8123_;
                        if (_e964 > _e968) {
                            phi_8128_ = _e964;
                        } else {
                            phi_8128_ = _e968;
                        }
                        let _e971 = phi_8128_;
                        if (_e668 < 0f) {
                            phi_8134_ = -(_e668);
                        } else {
                            phi_8134_ = _e668;
                        }
                        let _e975 = phi_8134_;
                        if (_e679 < 0f) {
                            phi_8140_ = -(_e679);
                        } else {
                            phi_8140_ = _e679;
                        }
                        let _e979 = phi_8140_;
                        if (_e975 > _e979) {
                            phi_8145_ = _e975;
                        } else {
                            phi_8145_ = _e979;
                        }
                        let _e982 = phi_8145_;
                        if (_e971 > _e982) {
                            phi_8150_ = _e971;
                        } else {
                            phi_8150_ = _e982;
                        }
                        let _e985 = phi_8150_;
                        let _e986 = (0.000000000000000000000000000000000000011754944f * 67108864f);
                        if (_e985 >= _e986) {
                            phi_8158_ = (_e985 <= (1f / _e986));
                        } else {
                            phi_8158_ = false;
                        }
                        let _e991 = phi_8158_;
                        if _e991 {
                            phi_8163_ = (0.000000059604645f * 256f);
                        } else {
                            phi_8163_ = 2f;
                        }
                        let _e994 = phi_8163_;
                        let _e996 = ((_e929 * 0.34f) + (_e985 * _e994));
                        if _e991 {
                            phi_8170_ = (1f / _e985);
                        } else {
                            phi_8170_ = 0f;
                        }
                        let _e999 = phi_8170_;
                        let _e1000 = (_e281 * 0.0625f);
                        if (0.00000000000022737368f < _e1000) {
                            phi_8176_ = 0.00000000000022737368f;
                        } else {
                            phi_8176_ = _e1000;
                        }
                        let _e1003 = phi_8176_;
                        let _e1004 = (1f - _e283);
                        let _e1015 = ((((_e622 * _e1004) + (_e645 * _e283)) * (_e1004 * _e1004)) + (((_e668 * _e1004) + (_e679 * _e283)) * (_e283 * _e283)));
                        if (_e1015 < 0f) {
                            phi_8194_ = -(_e1015);
                        } else {
                            phi_8194_ = _e1015;
                        }
                        let _e1019 = phi_8194_;
                        if !((_e1019 > _e996)) {
                            let _e1024 = local_18.member[0u];
                            let _e1030 = local_18.member_1[0u];
                            let _e1036 = local_18.member_2[0u];
                            let _e1040 = (_e1024[0] - _e1030[0]);
                            let _e1041 = (_e1024[1] - _e1030[1]);
                            let _e1042 = (_e1024[2] - _e1030[2]);
                            let _e1043 = (_e1040 - _e1036[0]);
                            let _e1044 = (_e1041 - _e1036[1]);
                            let _e1045 = (_e1042 - _e1036[2]);
                            let _e1046 = (_e1024[0] - _e1036[0]);
                            let _e1047 = (_e1024[1] - _e1036[1]);
                            let _e1048 = (_e1024[2] - _e1036[2]);
                            let _e1051 = local_18.member[1u];
                            let _e1057 = local_18.member_1[1u];
                            let _e1063 = local_18.member_2[1u];
                            let _e1067 = (_e1051[0] - _e1057[0]);
                            let _e1068 = (_e1051[1] - _e1057[1]);
                            let _e1069 = (_e1051[2] - _e1057[2]);
                            let _e1070 = (_e1067 - _e1063[0]);
                            let _e1071 = (_e1068 - _e1063[1]);
                            let _e1072 = (_e1069 - _e1063[2]);
                            let _e1073 = (_e1051[0] - _e1063[0]);
                            let _e1074 = (_e1051[1] - _e1063[1]);
                            let _e1075 = (_e1051[2] - _e1063[2]);
                            let _e1078 = local_18.member[0u];
                            if (_e1078[0] < 0f) {
                                phi_8342_ = -(_e1078[0]);
                            } else {
                                phi_8342_ = _e1078[0];
                            }
                            let _e1085 = phi_8342_;
                            if (_e1078[1] < 0f) {
                                phi_8349_ = -(_e1078[1]);
                            } else {
                                phi_8349_ = _e1078[1];
                            }
                            let _e1089 = phi_8349_;
                            if (_e1085 > _e1089) {
                                phi_8354_ = _e1085;
                            } else {
                                phi_8354_ = _e1089;
                            }
                            let _e1092 = phi_8354_;
                            if (_e1078[2] < 0f) {
                                phi_8361_ = -(_e1078[2]);
                            } else {
                                phi_8361_ = _e1078[2];
                            }
                            let _e1096 = phi_8361_;
                            if (_e1092 > _e1096) {
                                phi_8366_ = _e1092;
                            } else {
                                phi_8366_ = _e1096;
                            }
                            let _e1099 = phi_8366_;
                            let _e1102 = local_18.member[1u];
                            if (_e1102[0] < 0f) {
                                phi_8379_ = -(_e1102[0]);
                            } else {
                                phi_8379_ = _e1102[0];
                            }
                            let _e1109 = phi_8379_;
                            if (_e1102[1] < 0f) {
                                phi_8386_ = -(_e1102[1]);
                            } else {
                                phi_8386_ = _e1102[1];
                            }
                            let _e1113 = phi_8386_;
                            if (_e1109 > _e1113) {
                                phi_8391_ = _e1109;
                            } else {
                                phi_8391_ = _e1113;
                            }
                            let _e1116 = phi_8391_;
                            if (_e1102[2] < 0f) {
                                phi_8398_ = -(_e1102[2]);
                            } else {
                                phi_8398_ = _e1102[2];
                            }
                            let _e1120 = phi_8398_;
                            if (_e1116 > _e1120) {
                                phi_8403_ = _e1116;
                            } else {
                                phi_8403_ = _e1120;
                            }
                            let _e1123 = phi_8403_;
                            if (_e1099 > _e1123) {
                                phi_8408_ = _e1099;
                            } else {
                                phi_8408_ = _e1123;
                            }
                            let _e1126 = phi_8408_;
                            let _e1128 = local_18.member_3;
                            let _e1132 = local_18.member_1[0u];
                            if (_e1132[0] < 0f) {
                                phi_8425_ = -(_e1132[0]);
                            } else {
                                phi_8425_ = _e1132[0];
                            }
                            let _e1139 = phi_8425_;
                            if (_e1132[1] < 0f) {
                                phi_8432_ = -(_e1132[1]);
                            } else {
                                phi_8432_ = _e1132[1];
                            }
                            let _e1143 = phi_8432_;
                            if (_e1139 > _e1143) {
                                phi_8437_ = _e1139;
                            } else {
                                phi_8437_ = _e1143;
                            }
                            let _e1146 = phi_8437_;
                            if (_e1132[2] < 0f) {
                                phi_8444_ = -(_e1132[2]);
                            } else {
                                phi_8444_ = _e1132[2];
                            }
                            let _e1150 = phi_8444_;
                            if (_e1146 > _e1150) {
                                phi_8449_ = _e1146;
                            } else {
                                phi_8449_ = _e1150;
                            }
                            let _e1153 = phi_8449_;
                            let _e1156 = local_18.member_1[1u];
                            if (_e1156[0] < 0f) {
                                phi_8463_ = -(_e1156[0]);
                            } else {
                                phi_8463_ = _e1156[0];
                            }
                            let _e1163 = phi_8463_;
                            if (_e1156[1] < 0f) {
                                phi_8470_ = -(_e1156[1]);
                            } else {
                                phi_8470_ = _e1156[1];
                            }
                            let _e1167 = phi_8470_;
                            if (_e1163 > _e1167) {
                                phi_8475_ = _e1163;
                            } else {
                                phi_8475_ = _e1167;
                            }
                            let _e1170 = phi_8475_;
                            if (_e1156[2] < 0f) {
                                phi_8482_ = -(_e1156[2]);
                            } else {
                                phi_8482_ = _e1156[2];
                            }
                            let _e1174 = phi_8482_;
                            if (_e1170 > _e1174) {
                                phi_8487_ = _e1170;
                            } else {
                                phi_8487_ = _e1174;
                            }
                            let _e1177 = phi_8487_;
                            if (_e1153 > _e1177) {
                                phi_8492_ = _e1153;
                            } else {
                                phi_8492_ = _e1177;
                            }
                            let _e1180 = phi_8492_;
                            let _e1182 = local_18.member_3;
                            let _e1186 = local_18.member_2[0u];
                            if (_e1186[0] < 0f) {
                                phi_8509_ = -(_e1186[0]);
                            } else {
                                phi_8509_ = _e1186[0];
                            }
                            let _e1193 = phi_8509_;
                            if (_e1186[1] < 0f) {
                                phi_8516_ = -(_e1186[1]);
                            } else {
                                phi_8516_ = _e1186[1];
                            }
                            let _e1197 = phi_8516_;
                            if (_e1193 > _e1197) {
                                phi_8521_ = _e1193;
                            } else {
                                phi_8521_ = _e1197;
                            }
                            let _e1200 = phi_8521_;
                            if (_e1186[2] < 0f) {
                                phi_8528_ = -(_e1186[2]);
                            } else {
                                phi_8528_ = _e1186[2];
                            }
                            let _e1204 = phi_8528_;
                            if (_e1200 > _e1204) {
                                phi_8533_ = _e1200;
                            } else {
                                phi_8533_ = _e1204;
                            }
                            let _e1207 = phi_8533_;
                            let _e1210 = local_18.member_2[1u];
                            if (_e1210[0] < 0f) {
                                phi_8547_ = -(_e1210[0]);
                            } else {
                                phi_8547_ = _e1210[0];
                            }
                            let _e1217 = phi_8547_;
                            if (_e1210[1] < 0f) {
                                phi_8554_ = -(_e1210[1]);
                            } else {
                                phi_8554_ = _e1210[1];
                            }
                            let _e1221 = phi_8554_;
                            if (_e1217 > _e1221) {
                                phi_8559_ = _e1217;
                            } else {
                                phi_8559_ = _e1221;
                            }
                            let _e1224 = phi_8559_;
                            if (_e1210[2] < 0f) {
                                phi_8566_ = -(_e1210[2]);
                            } else {
                                phi_8566_ = _e1210[2];
                            }
                            let _e1228 = phi_8566_;
                            if (_e1224 > _e1228) {
                                phi_8571_ = _e1224;
                            } else {
                                phi_8571_ = _e1228;
                            }
                            let _e1231 = phi_8571_;
                            if (_e1207 > _e1231) {
                                phi_8576_ = _e1207;
                            } else {
                                phi_8576_ = _e1231;
                            }
                            let _e1234 = phi_8576_;
                            let _e1236 = local_18.member_3;
                            let _e1243 = local_18.member_3;
                            let _e1247 = ((((((_e1126 + _e1128) + (_e1180 + _e1182)) + (_e1234 + _e1236)) * (0.000000059604645f * 16f)) + (_e1243 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f));
                            let _e1250 = local_18.member[0u];
                            let _e1256 = local_18.member[1u];
                            let _e1272 = local_18.member_1[0u];
                            let _e1278 = local_18.member_1[1u];
                            let _e1294 = local_18.member_2[0u];
                            let _e1300 = local_18.member_2[1u];
                            let _e1314 = function_3(array<f32, 3>((_e1250[0] + ((_e1256[0] - _e1250[0]) * _e283)), (_e1250[1] + ((_e1256[1] - _e1250[1]) * _e283)), (_e1250[2] + ((_e1256[2] - _e1250[2]) * _e283))), array<f32, 3>((_e1272[0] + ((_e1278[0] - _e1272[0]) * _e283)), (_e1272[1] + ((_e1278[1] - _e1272[1]) * _e283)), (_e1272[2] + ((_e1278[2] - _e1272[2]) * _e283))), array<f32, 3>((_e1294[0] + ((_e1300[0] - _e1294[0]) * _e283)), (_e1294[1] + ((_e1300[1] - _e1294[1]) * _e283)), (_e1294[2] + ((_e1300[2] - _e1294[2]) * _e283))), 1u);
                            if (_e1314[0] < 0f) {
                                phi_8694_ = -(_e1314[0]);
                            } else {
                                phi_8694_ = _e1314[0];
                            }
                            let _e1319 = phi_8694_;
                            if (_e1314[1] < 0f) {
                                phi_8701_ = -(_e1314[1]);
                            } else {
                                phi_8701_ = _e1314[1];
                            }
                            let _e1324 = phi_8701_;
                            if (_e1314[2] < 0f) {
                                phi_8709_ = -(_e1314[2]);
                            } else {
                                phi_8709_ = _e1314[2];
                            }
                            let _e1330 = phi_8709_;
                            let _e1331 = ((_e1319 + _e1324) + _e1330);
                            if (_e1331 > 0f) {
                                if ((bitcast<u32>(_e1331) & 2139095040u) != 2139095040u) {
                                    let _e1336 = (1f / _e1331);
                                    let _e1338 = (_e1314[0] * _e1336);
                                    let _e1340 = (_e1314[1] * _e1336);
                                    let _e1342 = (_e1314[2] * _e1336);
                                    let _e1347 = (((_e1338 * _e1338) + (_e1340 * _e1340)) + (_e1342 * _e1342));
                                    if (_e1347 <= 0.000000000000000000000000000000000000011754944f) {
                                        if (_e1347 > 0f) {
                                            phi_8746_ = (0.000000000000000000106433627f * 2f);
                                        } else {
                                            phi_8746_ = 0f;
                                        }
                                        let _e1400 = phi_8746_;
                                        phi_8810_ = _e1400;
                                    } else {
                                        phi_8753_ = type_14(0i, 5i);
                                        phi_8756_ = bitcast<f32>(((bitcast<u32>(_e1347) >> bitcast<u32>(1i)) + 532369198u));
                                        loop {
                                            let _e1355 = phi_8753_;
                                            let _e1357 = phi_8756_;
                                            local_19 = _e1357;
                                            if (_e1355.member < _e1355.member_1) {
                                                let _e1364 = (_e1355.member + 1i);
                                                if ((false == (_e1364 > _e1355.member)) != false) {
                                                    phi_8777_ = true;
                                                } else {
                                                    phi_8777_ = false;
                                                }
                                                let _e1369 = phi_8777_;
                                                if _e1369 {
                                                    phi_8783_ = type_15(0u, type_15().member_1);
                                                } else {
                                                    phi_8783_ = type_15(1u, _e1364);
                                                }
                                                let _e1374 = phi_8783_;
                                                phi_8754_ = type_14(_e1374.member_1, _e1355.member_1);
                                                phi_8797_ = type_15(1u, _e1355.member);
                                            } else {
                                                phi_8754_ = _e1355;
                                                phi_8797_ = type_15(0u, type_15().member_1);
                                            }
                                            let _e1380 = phi_8754_;
                                            let _e1382 = phi_8797_;
                                            let _e1385 = (bitcast<i32>(_e1382.member) != 0i);
                                            if _e1385 {
                                                phi_8757_ = (0.5f * (_e1357 + (_e1347 / _e1357)));
                                            } else {
                                                phi_8757_ = f32();
                                            }
                                            let _e1390 = phi_8757_;
                                            continue;
                                            continuing {
                                                phi_8753_ = _e1380;
                                                phi_8756_ = _e1390;
                                                break if !(_e1385);
                                            }
                                        }
                                        let _e1395 = local_19;
                                        phi_8810_ = (_e1395 * (1f + (8f * 0.000000059604645f)));
                                    }
                                    let _e1402 = phi_8810_;
                                    let _e1403 = (0.000000059604645f * 12f);
                                    let _e1408 = ((_e1247 * 1.01f) + ((0f * _e1402) * (1f + _e1403)));
                                    let _e1413 = (((_e1338 * _e1024[0]) + (_e1340 * _e1024[1])) + (_e1342 * _e1024[2]));
                                    let _e1418 = (((_e1338 * _e1040) + (_e1340 * _e1041)) + (_e1342 * _e1042));
                                    let _e1423 = (((_e1338 * _e1046) + (_e1340 * _e1047)) + (_e1342 * _e1048));
                                    let _e1428 = (((_e1338 * _e1043) + (_e1340 * _e1044)) + (_e1342 * _e1045));
                                    let _e1434 = (((_e1338 * _e1051[0]) + (_e1340 * _e1051[1])) + (_e1342 * _e1051[2]));
                                    let _e1439 = (((_e1338 * _e1067) + (_e1340 * _e1068)) + (_e1342 * _e1069));
                                    let _e1444 = (((_e1338 * _e1073) + (_e1340 * _e1074)) + (_e1342 * _e1075));
                                    let _e1449 = (((_e1338 * _e1070) + (_e1340 * _e1071)) + (_e1342 * _e1072));
                                    if (_e1413 < 0f) {
                                        phi_8876_ = -(_e1413);
                                    } else {
                                        phi_8876_ = _e1413;
                                    }
                                    let _e1454 = phi_8876_;
                                    if (_e1434 < 0f) {
                                        phi_8882_ = -(_e1434);
                                    } else {
                                        phi_8882_ = _e1434;
                                    }
                                    let _e1458 = phi_8882_;
                                    if (_e1418 < 0f) {
                                        phi_8891_ = -(_e1418);
                                    } else {
                                        phi_8891_ = _e1418;
                                    }
                                    let _e1465 = phi_8891_;
                                    if (_e1439 < 0f) {
                                        phi_8897_ = -(_e1439);
                                    } else {
                                        phi_8897_ = _e1439;
                                    }
                                    let _e1469 = phi_8897_;
                                    if (_e1423 < 0f) {
                                        phi_8906_ = -(_e1423);
                                    } else {
                                        phi_8906_ = _e1423;
                                    }
                                    let _e1476 = phi_8906_;
                                    if (_e1444 < 0f) {
                                        phi_8912_ = -(_e1444);
                                    } else {
                                        phi_8912_ = _e1444;
                                    }
                                    let _e1480 = phi_8912_;
                                    if (_e1428 < 0f) {
                                        phi_8921_ = -(_e1428);
                                    } else {
                                        phi_8921_ = _e1428;
                                    }
                                    let _e1487 = phi_8921_;
                                    if (_e1449 < 0f) {
                                        phi_8927_ = -(_e1449);
                                    } else {
                                        phi_8927_ = _e1449;
                                    }
                                    let _e1491 = phi_8927_;
                                    phi_8933_ = type_32(array<f32, 4>(_e1413, _e1418, _e1423, _e1428), array<f32, 4>(_e1434, _e1439, _e1444, _e1449), array<f32, 4>((_e1408 + ((_e1454 + _e1458) * _e1403)), (_e1408 + ((_e1465 + _e1469) * _e1403)), (_e1408 + ((_e1476 + _e1480) * _e1403)), (_e1408 + ((_e1487 + _e1491) * _e1403))));
                                    phi_8934_ = false;
                                } else {
                                    phi_8933_ = type_32();
                                    phi_8934_ = true;
                                }
                                let _e1498 = phi_8933_;
                                let _e1500 = phi_8934_;
                                phi_8935_ = _e1498;
                                phi_8936_ = _e1500;
                            } else {
                                phi_8935_ = type_32();
                                phi_8936_ = true;
                            }
                            let _e1502 = phi_8935_;
                            let _e1504 = phi_8936_;
                            if _e1504 {
                                phi_8944_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                            } else {
                                phi_8944_ = _e1502;
                            }
                            let _e1506 = phi_8944_;
                            local_8 = type_32(array<f32, 4>(_e1506.member[0], _e1506.member[1], _e1506.member[2], _e1506.member[3]), array<f32, 4>(_e1506.member_1[0], _e1506.member_1[1], _e1506.member_1[2], _e1506.member_1[3]), array<f32, 4>(_e1506.member_2[0], _e1506.member_2[1], _e1506.member_2[2], _e1506.member_2[3]));
                            let _e1528 = local_8.member[0u];
                            let _e1531 = local_8.member_1[0u];
                            let _e1534 = local_8.member[0u];
                            let _e1540 = local_8.member_2[0u];
                            if (((_e1528 + ((_e1531 - _e1534) * _e283)) - _e1540) > 0f) {
                                let _e1545 = local_8.member[1u];
                                let _e1548 = local_8.member_1[1u];
                                let _e1551 = local_8.member[1u];
                                let _e1557 = local_8.member_2[1u];
                                if (((_e1545 + ((_e1548 - _e1551) * _e283)) - _e1557) > 0f) {
                                    let _e1562 = local_8.member[2u];
                                    let _e1565 = local_8.member_1[2u];
                                    let _e1568 = local_8.member[2u];
                                    let _e1574 = local_8.member_2[2u];
                                    if (((_e1562 + ((_e1565 - _e1568) * _e283)) - _e1574) > 0f) {
                                        let _e1579 = local_8.member[3u];
                                        let _e1582 = local_8.member_1[3u];
                                        let _e1585 = local_8.member[3u];
                                        let _e1591 = local_8.member_2[3u];
                                        phi_9113_ = (((_e1579 + ((_e1582 - _e1585) * _e283)) - _e1591) > 0f);
                                        phi_9114_ = false;
                                    } else {
                                        phi_9113_ = bool();
                                        phi_9114_ = true;
                                    }
                                    let _e1595 = phi_9113_;
                                    let _e1597 = phi_9114_;
                                    phi_9115_ = _e1595;
                                    phi_9116_ = _e1597;
                                } else {
                                    phi_9115_ = bool();
                                    phi_9116_ = true;
                                }
                                let _e1599 = phi_9115_;
                                let _e1601 = phi_9116_;
                                phi_9117_ = _e1599;
                                phi_9118_ = _e1601;
                            } else {
                                phi_9117_ = bool();
                                phi_9118_ = true;
                            }
                            let _e1603 = phi_9117_;
                            let _e1605 = phi_9118_;
                            if _e1605 {
                                phi_9122_ = false;
                            } else {
                                phi_9122_ = _e1603;
                            }
                            let _e1607 = phi_9122_;
                            if _e1607 {
                                phi_10476_ = bool();
                                phi_10477_ = true;
                            } else {
                                if (_e1314[0] < 0f) {
                                    phi_9149_ = -(_e1314[0]);
                                } else {
                                    phi_9149_ = _e1314[0];
                                }
                                let _e1612 = phi_9149_;
                                let _e1614 = ((_e1612 + 0f) + 0f);
                                if (_e1614 > 0f) {
                                    if ((bitcast<u32>(_e1614) & 2139095040u) != 2139095040u) {
                                        let _e1619 = (1f / _e1614);
                                        let _e1620 = (_e1314[0] * _e1619);
                                        let _e1621 = (0f * _e1619);
                                        let _e1622 = (0f * _e1619);
                                        let _e1627 = (((_e1620 * _e1620) + (_e1621 * _e1621)) + (_e1622 * _e1622));
                                        if (_e1627 <= 0.000000000000000000000000000000000000011754944f) {
                                            if (_e1627 > 0f) {
                                                phi_9196_ = (0.000000000000000000106433627f * 2f);
                                            } else {
                                                phi_9196_ = 0f;
                                            }
                                            let _e1680 = phi_9196_;
                                            phi_9260_ = _e1680;
                                        } else {
                                            phi_9203_ = type_14(0i, 5i);
                                            phi_9206_ = bitcast<f32>(((bitcast<u32>(_e1627) >> bitcast<u32>(1i)) + 532369198u));
                                            loop {
                                                let _e1635 = phi_9203_;
                                                let _e1637 = phi_9206_;
                                                local_20 = _e1637;
                                                if (_e1635.member < _e1635.member_1) {
                                                    let _e1644 = (_e1635.member + 1i);
                                                    if ((false == (_e1644 > _e1635.member)) != false) {
                                                        phi_9227_ = true;
                                                    } else {
                                                        phi_9227_ = false;
                                                    }
                                                    let _e1649 = phi_9227_;
                                                    if _e1649 {
                                                        phi_9233_ = type_15(0u, type_15().member_1);
                                                    } else {
                                                        phi_9233_ = type_15(1u, _e1644);
                                                    }
                                                    let _e1654 = phi_9233_;
                                                    phi_9204_ = type_14(_e1654.member_1, _e1635.member_1);
                                                    phi_9247_ = type_15(1u, _e1635.member);
                                                } else {
                                                    phi_9204_ = _e1635;
                                                    phi_9247_ = type_15(0u, type_15().member_1);
                                                }
                                                let _e1660 = phi_9204_;
                                                let _e1662 = phi_9247_;
                                                let _e1665 = (bitcast<i32>(_e1662.member) != 0i);
                                                if _e1665 {
                                                    phi_9207_ = (0.5f * (_e1637 + (_e1627 / _e1637)));
                                                } else {
                                                    phi_9207_ = f32();
                                                }
                                                let _e1670 = phi_9207_;
                                                continue;
                                                continuing {
                                                    phi_9203_ = _e1660;
                                                    phi_9206_ = _e1670;
                                                    break if !(_e1665);
                                                }
                                            }
                                            let _e1675 = local_20;
                                            phi_9260_ = (_e1675 * (1f + (8f * 0.000000059604645f)));
                                        }
                                        let _e1682 = phi_9260_;
                                        let _e1683 = (0.000000059604645f * 12f);
                                        let _e1688 = ((_e1247 * 1.01f) + ((0f * _e1682) * (1f + _e1683)));
                                        let _e1693 = (((_e1620 * _e1024[0]) + (_e1621 * _e1024[1])) + (_e1622 * _e1024[2]));
                                        let _e1698 = (((_e1620 * _e1040) + (_e1621 * _e1041)) + (_e1622 * _e1042));
                                        let _e1703 = (((_e1620 * _e1046) + (_e1621 * _e1047)) + (_e1622 * _e1048));
                                        let _e1708 = (((_e1620 * _e1043) + (_e1621 * _e1044)) + (_e1622 * _e1045));
                                        let _e1714 = (((_e1620 * _e1051[0]) + (_e1621 * _e1051[1])) + (_e1622 * _e1051[2]));
                                        let _e1719 = (((_e1620 * _e1067) + (_e1621 * _e1068)) + (_e1622 * _e1069));
                                        let _e1724 = (((_e1620 * _e1073) + (_e1621 * _e1074)) + (_e1622 * _e1075));
                                        let _e1729 = (((_e1620 * _e1070) + (_e1621 * _e1071)) + (_e1622 * _e1072));
                                        if (_e1693 < 0f) {
                                            phi_9326_ = -(_e1693);
                                        } else {
                                            phi_9326_ = _e1693;
                                        }
                                        let _e1734 = phi_9326_;
                                        if (_e1714 < 0f) {
                                            phi_9332_ = -(_e1714);
                                        } else {
                                            phi_9332_ = _e1714;
                                        }
                                        let _e1738 = phi_9332_;
                                        if (_e1698 < 0f) {
                                            phi_9341_ = -(_e1698);
                                        } else {
                                            phi_9341_ = _e1698;
                                        }
                                        let _e1745 = phi_9341_;
                                        if (_e1719 < 0f) {
                                            phi_9347_ = -(_e1719);
                                        } else {
                                            phi_9347_ = _e1719;
                                        }
                                        let _e1749 = phi_9347_;
                                        if (_e1703 < 0f) {
                                            phi_9356_ = -(_e1703);
                                        } else {
                                            phi_9356_ = _e1703;
                                        }
                                        let _e1756 = phi_9356_;
                                        if (_e1724 < 0f) {
                                            phi_9362_ = -(_e1724);
                                        } else {
                                            phi_9362_ = _e1724;
                                        }
                                        let _e1760 = phi_9362_;
                                        if (_e1708 < 0f) {
                                            phi_9371_ = -(_e1708);
                                        } else {
                                            phi_9371_ = _e1708;
                                        }
                                        let _e1767 = phi_9371_;
                                        if (_e1729 < 0f) {
                                            phi_9377_ = -(_e1729);
                                        } else {
                                            phi_9377_ = _e1729;
                                        }
                                        let _e1771 = phi_9377_;
                                        phi_9383_ = type_32(array<f32, 4>(_e1693, _e1698, _e1703, _e1708), array<f32, 4>(_e1714, _e1719, _e1724, _e1729), array<f32, 4>((_e1688 + ((_e1734 + _e1738) * _e1683)), (_e1688 + ((_e1745 + _e1749) * _e1683)), (_e1688 + ((_e1756 + _e1760) * _e1683)), (_e1688 + ((_e1767 + _e1771) * _e1683))));
                                        phi_9384_ = false;
                                    } else {
                                        phi_9383_ = type_32();
                                        phi_9384_ = true;
                                    }
                                    let _e1778 = phi_9383_;
                                    let _e1780 = phi_9384_;
                                    phi_9385_ = _e1778;
                                    phi_9386_ = _e1780;
                                } else {
                                    phi_9385_ = type_32();
                                    phi_9386_ = true;
                                }
                                let _e1782 = phi_9385_;
                                let _e1784 = phi_9386_;
                                if _e1784 {
                                    phi_9394_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                } else {
                                    phi_9394_ = _e1782;
                                }
                                let _e1786 = phi_9394_;
                                local_9 = type_32(array<f32, 4>(_e1786.member[0], _e1786.member[1], _e1786.member[2], _e1786.member[3]), array<f32, 4>(_e1786.member_1[0], _e1786.member_1[1], _e1786.member_1[2], _e1786.member_1[3]), array<f32, 4>(_e1786.member_2[0], _e1786.member_2[1], _e1786.member_2[2], _e1786.member_2[3]));
                                let _e1808 = local_9.member[0u];
                                let _e1811 = local_9.member_1[0u];
                                let _e1814 = local_9.member[0u];
                                let _e1820 = local_9.member_2[0u];
                                if (((_e1808 + ((_e1811 - _e1814) * _e283)) - _e1820) > 0f) {
                                    let _e1825 = local_9.member[1u];
                                    let _e1828 = local_9.member_1[1u];
                                    let _e1831 = local_9.member[1u];
                                    let _e1837 = local_9.member_2[1u];
                                    if (((_e1825 + ((_e1828 - _e1831) * _e283)) - _e1837) > 0f) {
                                        let _e1842 = local_9.member[2u];
                                        let _e1845 = local_9.member_1[2u];
                                        let _e1848 = local_9.member[2u];
                                        let _e1854 = local_9.member_2[2u];
                                        if (((_e1842 + ((_e1845 - _e1848) * _e283)) - _e1854) > 0f) {
                                            let _e1859 = local_9.member[3u];
                                            let _e1862 = local_9.member_1[3u];
                                            let _e1865 = local_9.member[3u];
                                            let _e1871 = local_9.member_2[3u];
                                            phi_9563_ = (((_e1859 + ((_e1862 - _e1865) * _e283)) - _e1871) > 0f);
                                            phi_9564_ = false;
                                        } else {
                                            phi_9563_ = bool();
                                            phi_9564_ = true;
                                        }
                                        let _e1875 = phi_9563_;
                                        let _e1877 = phi_9564_;
                                        phi_9565_ = _e1875;
                                        phi_9566_ = _e1877;
                                    } else {
                                        phi_9565_ = bool();
                                        phi_9566_ = true;
                                    }
                                    let _e1879 = phi_9565_;
                                    let _e1881 = phi_9566_;
                                    phi_9567_ = _e1879;
                                    phi_9568_ = _e1881;
                                } else {
                                    phi_9567_ = bool();
                                    phi_9568_ = true;
                                }
                                let _e1883 = phi_9567_;
                                let _e1885 = phi_9568_;
                                if _e1885 {
                                    phi_9572_ = false;
                                } else {
                                    phi_9572_ = _e1883;
                                }
                                let _e1887 = phi_9572_;
                                if _e1887 {
                                    phi_10474_ = bool();
                                    phi_10475_ = true;
                                } else {
                                    if (_e1314[1] < 0f) {
                                        phi_9605_ = -(_e1314[1]);
                                    } else {
                                        phi_9605_ = _e1314[1];
                                    }
                                    let _e1892 = phi_9605_;
                                    let _e1894 = ((0f + _e1892) + 0f);
                                    if (_e1894 > 0f) {
                                        if ((bitcast<u32>(_e1894) & 2139095040u) != 2139095040u) {
                                            let _e1899 = (1f / _e1894);
                                            let _e1900 = (0f * _e1899);
                                            let _e1901 = (_e1314[1] * _e1899);
                                            let _e1902 = (0f * _e1899);
                                            let _e1907 = (((_e1900 * _e1900) + (_e1901 * _e1901)) + (_e1902 * _e1902));
                                            if (_e1907 <= 0.000000000000000000000000000000000000011754944f) {
                                                if (_e1907 > 0f) {
                                                    phi_9646_ = (0.000000000000000000106433627f * 2f);
                                                } else {
                                                    phi_9646_ = 0f;
                                                }
                                                let _e1960 = phi_9646_;
                                                phi_9710_ = _e1960;
                                            } else {
                                                phi_9653_ = type_14(0i, 5i);
                                                phi_9656_ = bitcast<f32>(((bitcast<u32>(_e1907) >> bitcast<u32>(1i)) + 532369198u));
                                                loop {
                                                    let _e1915 = phi_9653_;
                                                    let _e1917 = phi_9656_;
                                                    local_21 = _e1917;
                                                    if (_e1915.member < _e1915.member_1) {
                                                        let _e1924 = (_e1915.member + 1i);
                                                        if ((false == (_e1924 > _e1915.member)) != false) {
                                                            phi_9677_ = true;
                                                        } else {
                                                            phi_9677_ = false;
                                                        }
                                                        let _e1929 = phi_9677_;
                                                        if _e1929 {
                                                            phi_9683_ = type_15(0u, type_15().member_1);
                                                        } else {
                                                            phi_9683_ = type_15(1u, _e1924);
                                                        }
                                                        let _e1934 = phi_9683_;
                                                        phi_9654_ = type_14(_e1934.member_1, _e1915.member_1);
                                                        phi_9697_ = type_15(1u, _e1915.member);
                                                    } else {
                                                        phi_9654_ = _e1915;
                                                        phi_9697_ = type_15(0u, type_15().member_1);
                                                    }
                                                    let _e1940 = phi_9654_;
                                                    let _e1942 = phi_9697_;
                                                    let _e1945 = (bitcast<i32>(_e1942.member) != 0i);
                                                    if _e1945 {
                                                        phi_9657_ = (0.5f * (_e1917 + (_e1907 / _e1917)));
                                                    } else {
                                                        phi_9657_ = f32();
                                                    }
                                                    let _e1950 = phi_9657_;
                                                    continue;
                                                    continuing {
                                                        phi_9653_ = _e1940;
                                                        phi_9656_ = _e1950;
                                                        break if !(_e1945);
                                                    }
                                                }
                                                let _e1955 = local_21;
                                                phi_9710_ = (_e1955 * (1f + (8f * 0.000000059604645f)));
                                            }
                                            let _e1962 = phi_9710_;
                                            let _e1963 = (0.000000059604645f * 12f);
                                            let _e1968 = ((_e1247 * 1.01f) + ((0f * _e1962) * (1f + _e1963)));
                                            let _e1973 = (((_e1900 * _e1024[0]) + (_e1901 * _e1024[1])) + (_e1902 * _e1024[2]));
                                            let _e1978 = (((_e1900 * _e1040) + (_e1901 * _e1041)) + (_e1902 * _e1042));
                                            let _e1983 = (((_e1900 * _e1046) + (_e1901 * _e1047)) + (_e1902 * _e1048));
                                            let _e1988 = (((_e1900 * _e1043) + (_e1901 * _e1044)) + (_e1902 * _e1045));
                                            let _e1994 = (((_e1900 * _e1051[0]) + (_e1901 * _e1051[1])) + (_e1902 * _e1051[2]));
                                            let _e1999 = (((_e1900 * _e1067) + (_e1901 * _e1068)) + (_e1902 * _e1069));
                                            let _e2004 = (((_e1900 * _e1073) + (_e1901 * _e1074)) + (_e1902 * _e1075));
                                            let _e2009 = (((_e1900 * _e1070) + (_e1901 * _e1071)) + (_e1902 * _e1072));
                                            if (_e1973 < 0f) {
                                                phi_9776_ = -(_e1973);
                                            } else {
                                                phi_9776_ = _e1973;
                                            }
                                            let _e2014 = phi_9776_;
                                            if (_e1994 < 0f) {
                                                phi_9782_ = -(_e1994);
                                            } else {
                                                phi_9782_ = _e1994;
                                            }
                                            let _e2018 = phi_9782_;
                                            if (_e1978 < 0f) {
                                                phi_9791_ = -(_e1978);
                                            } else {
                                                phi_9791_ = _e1978;
                                            }
                                            let _e2025 = phi_9791_;
                                            if (_e1999 < 0f) {
                                                phi_9797_ = -(_e1999);
                                            } else {
                                                phi_9797_ = _e1999;
                                            }
                                            let _e2029 = phi_9797_;
                                            if (_e1983 < 0f) {
                                                phi_9806_ = -(_e1983);
                                            } else {
                                                phi_9806_ = _e1983;
                                            }
                                            let _e2036 = phi_9806_;
                                            if (_e2004 < 0f) {
                                                phi_9812_ = -(_e2004);
                                            } else {
                                                phi_9812_ = _e2004;
                                            }
                                            let _e2040 = phi_9812_;
                                            if (_e1988 < 0f) {
                                                phi_9821_ = -(_e1988);
                                            } else {
                                                phi_9821_ = _e1988;
                                            }
                                            let _e2047 = phi_9821_;
                                            if (_e2009 < 0f) {
                                                phi_9827_ = -(_e2009);
                                            } else {
                                                phi_9827_ = _e2009;
                                            }
                                            let _e2051 = phi_9827_;
                                            phi_9833_ = type_32(array<f32, 4>(_e1973, _e1978, _e1983, _e1988), array<f32, 4>(_e1994, _e1999, _e2004, _e2009), array<f32, 4>((_e1968 + ((_e2014 + _e2018) * _e1963)), (_e1968 + ((_e2025 + _e2029) * _e1963)), (_e1968 + ((_e2036 + _e2040) * _e1963)), (_e1968 + ((_e2047 + _e2051) * _e1963))));
                                            phi_9834_ = false;
                                        } else {
                                            phi_9833_ = type_32();
                                            phi_9834_ = true;
                                        }
                                        let _e2058 = phi_9833_;
                                        let _e2060 = phi_9834_;
                                        phi_9835_ = _e2058;
                                        phi_9836_ = _e2060;
                                    } else {
                                        phi_9835_ = type_32();
                                        phi_9836_ = true;
                                    }
                                    let _e2062 = phi_9835_;
                                    let _e2064 = phi_9836_;
                                    if _e2064 {
                                        phi_9844_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                    } else {
                                        phi_9844_ = _e2062;
                                    }
                                    let _e2066 = phi_9844_;
                                    local_10 = type_32(array<f32, 4>(_e2066.member[0], _e2066.member[1], _e2066.member[2], _e2066.member[3]), array<f32, 4>(_e2066.member_1[0], _e2066.member_1[1], _e2066.member_1[2], _e2066.member_1[3]), array<f32, 4>(_e2066.member_2[0], _e2066.member_2[1], _e2066.member_2[2], _e2066.member_2[3]));
                                    let _e2088 = local_10.member[0u];
                                    let _e2091 = local_10.member_1[0u];
                                    let _e2094 = local_10.member[0u];
                                    let _e2100 = local_10.member_2[0u];
                                    if (((_e2088 + ((_e2091 - _e2094) * _e283)) - _e2100) > 0f) {
                                        let _e2105 = local_10.member[1u];
                                        let _e2108 = local_10.member_1[1u];
                                        let _e2111 = local_10.member[1u];
                                        let _e2117 = local_10.member_2[1u];
                                        if (((_e2105 + ((_e2108 - _e2111) * _e283)) - _e2117) > 0f) {
                                            let _e2122 = local_10.member[2u];
                                            let _e2125 = local_10.member_1[2u];
                                            let _e2128 = local_10.member[2u];
                                            let _e2134 = local_10.member_2[2u];
                                            if (((_e2122 + ((_e2125 - _e2128) * _e283)) - _e2134) > 0f) {
                                                let _e2139 = local_10.member[3u];
                                                let _e2142 = local_10.member_1[3u];
                                                let _e2145 = local_10.member[3u];
                                                let _e2151 = local_10.member_2[3u];
                                                phi_10013_ = (((_e2139 + ((_e2142 - _e2145) * _e283)) - _e2151) > 0f);
                                                phi_10014_ = false;
                                            } else {
                                                phi_10013_ = bool();
                                                phi_10014_ = true;
                                            }
                                            let _e2155 = phi_10013_;
                                            let _e2157 = phi_10014_;
                                            phi_10015_ = _e2155;
                                            phi_10016_ = _e2157;
                                        } else {
                                            phi_10015_ = bool();
                                            phi_10016_ = true;
                                        }
                                        let _e2159 = phi_10015_;
                                        let _e2161 = phi_10016_;
                                        phi_10017_ = _e2159;
                                        phi_10018_ = _e2161;
                                    } else {
                                        phi_10017_ = bool();
                                        phi_10018_ = true;
                                    }
                                    let _e2163 = phi_10017_;
                                    let _e2165 = phi_10018_;
                                    if _e2165 {
                                        phi_10022_ = false;
                                    } else {
                                        phi_10022_ = _e2163;
                                    }
                                    let _e2167 = phi_10022_;
                                    if _e2167 {
                                        phi_10473_ = bool();
                                    } else {
                                        if (_e1314[2] < 0f) {
                                            phi_10062_ = -(_e1314[2]);
                                        } else {
                                            phi_10062_ = _e1314[2];
                                        }
                                        let _e2173 = phi_10062_;
                                        let _e2174 = ((0f + 0f) + _e2173);
                                        if (_e2174 > 0f) {
                                            if ((bitcast<u32>(_e2174) & 2139095040u) != 2139095040u) {
                                                let _e2179 = (1f / _e2174);
                                                let _e2180 = (0f * _e2179);
                                                let _e2181 = (0f * _e2179);
                                                let _e2182 = (_e1314[2] * _e2179);
                                                let _e2187 = (((_e2180 * _e2180) + (_e2181 * _e2181)) + (_e2182 * _e2182));
                                                if (_e2187 <= 0.000000000000000000000000000000000000011754944f) {
                                                    if (_e2187 > 0f) {
                                                        phi_10096_ = (0.000000000000000000106433627f * 2f);
                                                    } else {
                                                        phi_10096_ = 0f;
                                                    }
                                                    let _e2240 = phi_10096_;
                                                    phi_10160_ = _e2240;
                                                } else {
                                                    phi_10103_ = type_14(0i, 5i);
                                                    phi_10106_ = bitcast<f32>(((bitcast<u32>(_e2187) >> bitcast<u32>(1i)) + 532369198u));
                                                    loop {
                                                        let _e2195 = phi_10103_;
                                                        let _e2197 = phi_10106_;
                                                        local_22 = _e2197;
                                                        if (_e2195.member < _e2195.member_1) {
                                                            let _e2204 = (_e2195.member + 1i);
                                                            if ((false == (_e2204 > _e2195.member)) != false) {
                                                                phi_10127_ = true;
                                                            } else {
                                                                phi_10127_ = false;
                                                            }
                                                            let _e2209 = phi_10127_;
                                                            if _e2209 {
                                                                phi_10133_ = type_15(0u, type_15().member_1);
                                                            } else {
                                                                phi_10133_ = type_15(1u, _e2204);
                                                            }
                                                            let _e2214 = phi_10133_;
                                                            phi_10104_ = type_14(_e2214.member_1, _e2195.member_1);
                                                            phi_10147_ = type_15(1u, _e2195.member);
                                                        } else {
                                                            phi_10104_ = _e2195;
                                                            phi_10147_ = type_15(0u, type_15().member_1);
                                                        }
                                                        let _e2220 = phi_10104_;
                                                        let _e2222 = phi_10147_;
                                                        let _e2225 = (bitcast<i32>(_e2222.member) != 0i);
                                                        if _e2225 {
                                                            phi_10107_ = (0.5f * (_e2197 + (_e2187 / _e2197)));
                                                        } else {
                                                            phi_10107_ = f32();
                                                        }
                                                        let _e2230 = phi_10107_;
                                                        continue;
                                                        continuing {
                                                            phi_10103_ = _e2220;
                                                            phi_10106_ = _e2230;
                                                            break if !(_e2225);
                                                        }
                                                    }
                                                    let _e2235 = local_22;
                                                    phi_10160_ = (_e2235 * (1f + (8f * 0.000000059604645f)));
                                                }
                                                let _e2242 = phi_10160_;
                                                let _e2243 = (0.000000059604645f * 12f);
                                                let _e2248 = ((_e1247 * 1.01f) + ((0f * _e2242) * (1f + _e2243)));
                                                let _e2253 = (((_e2180 * _e1024[0]) + (_e2181 * _e1024[1])) + (_e2182 * _e1024[2]));
                                                let _e2258 = (((_e2180 * _e1040) + (_e2181 * _e1041)) + (_e2182 * _e1042));
                                                let _e2263 = (((_e2180 * _e1046) + (_e2181 * _e1047)) + (_e2182 * _e1048));
                                                let _e2268 = (((_e2180 * _e1043) + (_e2181 * _e1044)) + (_e2182 * _e1045));
                                                let _e2274 = (((_e2180 * _e1051[0]) + (_e2181 * _e1051[1])) + (_e2182 * _e1051[2]));
                                                let _e2279 = (((_e2180 * _e1067) + (_e2181 * _e1068)) + (_e2182 * _e1069));
                                                let _e2284 = (((_e2180 * _e1073) + (_e2181 * _e1074)) + (_e2182 * _e1075));
                                                let _e2289 = (((_e2180 * _e1070) + (_e2181 * _e1071)) + (_e2182 * _e1072));
                                                if (_e2253 < 0f) {
                                                    phi_10226_ = -(_e2253);
                                                } else {
                                                    phi_10226_ = _e2253;
                                                }
                                                let _e2294 = phi_10226_;
                                                if (_e2274 < 0f) {
                                                    phi_10232_ = -(_e2274);
                                                } else {
                                                    phi_10232_ = _e2274;
                                                }
                                                let _e2298 = phi_10232_;
                                                if (_e2258 < 0f) {
                                                    phi_10241_ = -(_e2258);
                                                } else {
                                                    phi_10241_ = _e2258;
                                                }
                                                let _e2305 = phi_10241_;
                                                if (_e2279 < 0f) {
                                                    phi_10247_ = -(_e2279);
                                                } else {
                                                    phi_10247_ = _e2279;
                                                }
                                                let _e2309 = phi_10247_;
                                                if (_e2263 < 0f) {
                                                    phi_10256_ = -(_e2263);
                                                } else {
                                                    phi_10256_ = _e2263;
                                                }
                                                let _e2316 = phi_10256_;
                                                if (_e2284 < 0f) {
                                                    phi_10262_ = -(_e2284);
                                                } else {
                                                    phi_10262_ = _e2284;
                                                }
                                                let _e2320 = phi_10262_;
                                                if (_e2268 < 0f) {
                                                    phi_10271_ = -(_e2268);
                                                } else {
                                                    phi_10271_ = _e2268;
                                                }
                                                let _e2327 = phi_10271_;
                                                if (_e2289 < 0f) {
                                                    phi_10277_ = -(_e2289);
                                                } else {
                                                    phi_10277_ = _e2289;
                                                }
                                                let _e2331 = phi_10277_;
                                                phi_10283_ = type_32(array<f32, 4>(_e2253, _e2258, _e2263, _e2268), array<f32, 4>(_e2274, _e2279, _e2284, _e2289), array<f32, 4>((_e2248 + ((_e2294 + _e2298) * _e2243)), (_e2248 + ((_e2305 + _e2309) * _e2243)), (_e2248 + ((_e2316 + _e2320) * _e2243)), (_e2248 + ((_e2327 + _e2331) * _e2243))));
                                                phi_10284_ = false;
                                            } else {
                                                phi_10283_ = type_32();
                                                phi_10284_ = true;
                                            }
                                            let _e2338 = phi_10283_;
                                            let _e2340 = phi_10284_;
                                            phi_10285_ = _e2338;
                                            phi_10286_ = _e2340;
                                        } else {
                                            phi_10285_ = type_32();
                                            phi_10286_ = true;
                                        }
                                        let _e2342 = phi_10285_;
                                        let _e2344 = phi_10286_;
                                        if _e2344 {
                                            phi_10294_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                        } else {
                                            phi_10294_ = _e2342;
                                        }
                                        let _e2346 = phi_10294_;
                                        local_11 = type_32(array<f32, 4>(_e2346.member[0], _e2346.member[1], _e2346.member[2], _e2346.member[3]), array<f32, 4>(_e2346.member_1[0], _e2346.member_1[1], _e2346.member_1[2], _e2346.member_1[3]), array<f32, 4>(_e2346.member_2[0], _e2346.member_2[1], _e2346.member_2[2], _e2346.member_2[3]));
                                        let _e2368 = local_11.member[0u];
                                        let _e2371 = local_11.member_1[0u];
                                        let _e2374 = local_11.member[0u];
                                        let _e2380 = local_11.member_2[0u];
                                        if (((_e2368 + ((_e2371 - _e2374) * _e283)) - _e2380) > 0f) {
                                            let _e2385 = local_11.member[1u];
                                            let _e2388 = local_11.member_1[1u];
                                            let _e2391 = local_11.member[1u];
                                            let _e2397 = local_11.member_2[1u];
                                            if (((_e2385 + ((_e2388 - _e2391) * _e283)) - _e2397) > 0f) {
                                                let _e2402 = local_11.member[2u];
                                                let _e2405 = local_11.member_1[2u];
                                                let _e2408 = local_11.member[2u];
                                                let _e2414 = local_11.member_2[2u];
                                                if (((_e2402 + ((_e2405 - _e2408) * _e283)) - _e2414) > 0f) {
                                                    let _e2419 = local_11.member[3u];
                                                    let _e2422 = local_11.member_1[3u];
                                                    let _e2425 = local_11.member[3u];
                                                    let _e2431 = local_11.member_2[3u];
                                                    phi_10463_ = (((_e2419 + ((_e2422 - _e2425) * _e283)) - _e2431) > 0f);
                                                    phi_10464_ = false;
                                                } else {
                                                    phi_10463_ = bool();
                                                    phi_10464_ = true;
                                                }
                                                let _e2435 = phi_10463_;
                                                let _e2437 = phi_10464_;
                                                phi_10465_ = _e2435;
                                                phi_10466_ = _e2437;
                                            } else {
                                                phi_10465_ = bool();
                                                phi_10466_ = true;
                                            }
                                            let _e2439 = phi_10465_;
                                            let _e2441 = phi_10466_;
                                            phi_10467_ = _e2439;
                                            phi_10468_ = _e2441;
                                        } else {
                                            phi_10467_ = bool();
                                            phi_10468_ = true;
                                        }
                                        let _e2443 = phi_10467_;
                                        let _e2445 = phi_10468_;
                                        if _e2445 {
                                            phi_10472_ = false;
                                        } else {
                                            phi_10472_ = _e2443;
                                        }
                                        let _e2447 = phi_10472_;
                                        phi_10473_ = _e2447;
                                    }
                                    let _e2449 = phi_10473_;
                                    phi_10474_ = _e2449;
                                    phi_10475_ = _e2167;
                                }
                                let _e2451 = phi_10474_;
                                let _e2453 = phi_10475_;
                                phi_10476_ = _e2451;
                                phi_10477_ = _e2453;
                            }
                            let _e2455 = phi_10476_;
                            let _e2457 = phi_10477_;
                            if _e2457 {
                                phi_10481_ = true;
                            } else {
                                phi_10481_ = _e2455;
                            }
                            let _e2459 = phi_10481_;
                            if !(_e2459) {
                                phi_10487_ = type_30(2u, _e283);
                                phi_10488_ = false;
                            } else {
                                phi_10487_ = type_30();
                                phi_10488_ = true;
                            }
                            let _e2463 = phi_10487_;
                            let _e2465 = phi_10488_;
                            phi_10489_ = _e2463;
                            phi_10490_ = _e2465;
                        } else {
                            phi_10489_ = type_30();
                            phi_10490_ = true;
                        }
                        let _e2467 = phi_10489_;
                        let _e2469 = phi_10490_;
                        if _e2469 {
                            let _e2475 = ((_e645 - (3f * _e622)) * _e999);
                            let _e2476 = ((_e668 - _e645) * _e999);
                            let _e2477 = (((3f * _e679) - _e668) * _e999);
                            local_6[0u] = 0f;
                            local_6[1u] = 1f;
                            local_6[2u] = 1f;
                            local_6[3u] = 1f;
                            let _e2484 = ((_e2476 * _e2476) - (_e2475 * _e2477));
                            if (_e2484 > 0f) {
                                if (_e2484 <= 0.000000000000000000000000000000000000011754944f) {
                                    if (_e2484 > 0f) {
                                        phi_10526_ = (0.000000000000000000106433627f * 2f);
                                    } else {
                                        phi_10526_ = 0f;
                                    }
                                    let _e2538 = phi_10526_;
                                    phi_10590_ = _e2538;
                                } else {
                                    phi_10533_ = type_14(0i, 5i);
                                    phi_10536_ = bitcast<f32>(((bitcast<u32>(_e2484) >> bitcast<u32>(1i)) + 532369198u));
                                    loop {
                                        let _e2493 = phi_10533_;
                                        let _e2495 = phi_10536_;
                                        local_23 = _e2495;
                                        if (_e2493.member < _e2493.member_1) {
                                            let _e2502 = (_e2493.member + 1i);
                                            if ((false == (_e2502 > _e2493.member)) != false) {
                                                phi_10557_ = true;
                                            } else {
                                                phi_10557_ = false;
                                            }
                                            let _e2507 = phi_10557_;
                                            if _e2507 {
                                                phi_10563_ = type_15(0u, type_15().member_1);
                                            } else {
                                                phi_10563_ = type_15(1u, _e2502);
                                            }
                                            let _e2512 = phi_10563_;
                                            phi_10534_ = type_14(_e2512.member_1, _e2493.member_1);
                                            phi_10577_ = type_15(1u, _e2493.member);
                                        } else {
                                            phi_10534_ = _e2493;
                                            phi_10577_ = type_15(0u, type_15().member_1);
                                        }
                                        let _e2518 = phi_10534_;
                                        let _e2520 = phi_10577_;
                                        let _e2523 = (bitcast<i32>(_e2520.member) != 0i);
                                        if _e2523 {
                                            phi_10537_ = (0.5f * (_e2495 + (_e2484 / _e2495)));
                                        } else {
                                            phi_10537_ = f32();
                                        }
                                        let _e2528 = phi_10537_;
                                        continue;
                                        continuing {
                                            phi_10533_ = _e2518;
                                            phi_10536_ = _e2528;
                                            break if !(_e2523);
                                        }
                                    }
                                    let _e2533 = local_23;
                                    phi_10590_ = (_e2533 * (1f + (8f * 0.000000059604645f)));
                                }
                                let _e2540 = phi_10590_;
                                if (_e2476 < 0f) {
                                    phi_10596_ = -(_e2540);
                                } else {
                                    phi_10596_ = _e2540;
                                }
                                let _e2544 = phi_10596_;
                                let _e2546 = -((_e2476 + _e2544));
                                local_7[0u] = (_e2546 / (_e2546 + _e2477));
                                local_7[1u] = (_e2475 / (_e2475 + _e2546));
                                let _e2555 = local_7[1u];
                                let _e2556 = local_7[0u];
                                if (_e2555 < _e2556) {
                                    let _e2559 = local_7[1u];
                                    let _e2561 = local_7[0u];
                                    local_7[0u] = _e2559;
                                    local_7[1u] = _e2561;
                                }
                                phi_10621_ = type_12(0u, 2u);
                                phi_10624_ = 1u;
                                loop {
                                    let _e2565 = phi_10621_;
                                    let _e2567 = phi_10624_;
                                    local_63 = _e2567;
                                    if (_e2565.member < _e2565.member_1) {
                                        phi_10622_ = type_12((_e2565.member + 1u), _e2565.member_1);
                                        phi_10647_ = type_12(1u, _e2565.member);
                                    } else {
                                        phi_10622_ = _e2565;
                                        phi_10647_ = type_12(0u, type_12().member_1);
                                    }
                                    let _e2579 = phi_10622_;
                                    let _e2581 = phi_10647_;
                                    let _e2585 = (bitcast<i32>(_e2581.member) != 0i);
                                    if _e2585 {
                                        let _e2587 = local_7[_e2581.member_1];
                                        if (_e2587 > 0f) {
                                            let _e2590 = local_7[_e2581.member_1];
                                            if (_e2590 < 1f) {
                                                let _e2593 = local_7[_e2581.member_1];
                                                local_6[_e2567] = _e2593;
                                                phi_10691_ = (_e2567 + 1u);
                                            } else {
                                                phi_10691_ = _e2567;
                                            }
                                            let _e2597 = phi_10691_;
                                            phi_10692_ = _e2597;
                                        } else {
                                            phi_10692_ = _e2567;
                                        }
                                        let _e2599 = phi_10692_;
                                        phi_10625_ = _e2599;
                                    } else {
                                        phi_10625_ = u32();
                                    }
                                    let _e2601 = phi_10625_;
                                    continue;
                                    continuing {
                                        phi_10621_ = _e2579;
                                        phi_10624_ = _e2601;
                                        break if !(_e2585);
                                    }
                                }
                                let _e10185 = local_63;
                                phi_10693_ = _e10185;
                            } else {
                                phi_10693_ = 1u;
                            }
                            let _e2604 = phi_10693_;
                            local_6[_e2604] = 1f;
                            let _e2606 = local_6;
                            local_12 = _e2606;
                            phi_10713_ = type_12(0u, _e2604);
                            loop {
                                let _e2609 = phi_10713_;
                                if (_e2609.member < _e2609.member_1) {
                                    phi_10714_ = type_12((_e2609.member + 1u), _e2609.member_1);
                                    phi_10737_ = type_12(1u, _e2609.member);
                                } else {
                                    phi_10714_ = _e2609;
                                    phi_10737_ = type_12(0u, type_12().member_1);
                                }
                                let _e2621 = phi_10714_;
                                let _e2623 = phi_10737_;
                                if (bitcast<i32>(_e2623.member) != 0i) {
                                    let _e2629 = local_12[_e2623.member_1];
                                    if (_e2629 > _e283) {
                                        phi_10756_ = _e2629;
                                    } else {
                                        phi_10756_ = _e283;
                                    }
                                    let _e2632 = phi_10756_;
                                    let _e2635 = local_12[(_e2623.member_1 + 1u)];
                                    if (_e2635 < _e285) {
                                        phi_10769_ = _e2635;
                                    } else {
                                        phi_10769_ = _e285;
                                    }
                                    let _e2638 = phi_10769_;
                                    if (_e2632 <= _e2638) {
                                        let _e2640 = (1f - _e2632);
                                        let _e2651 = ((((_e622 * _e2640) + (_e645 * _e2632)) * (_e2640 * _e2640)) + (((_e668 * _e2640) + (_e679 * _e2632)) * (_e2632 * _e2632)));
                                        let _e2652 = (1f - _e2638);
                                        let _e2663 = ((((_e622 * _e2652) + (_e645 * _e2638)) * (_e2652 * _e2652)) + (((_e668 * _e2652) + (_e679 * _e2638)) * (_e2638 * _e2638)));
                                        if (_e2651 < 0f) {
                                            phi_10803_ = -(_e2651);
                                        } else {
                                            phi_10803_ = _e2651;
                                        }
                                        let _e2667 = phi_10803_;
                                        let _e2668 = (_e2667 > _e996);
                                        if (_e2663 < 0f) {
                                            phi_10810_ = -(_e2663);
                                        } else {
                                            phi_10810_ = _e2663;
                                        }
                                        let _e2672 = phi_10810_;
                                        let _e2673 = (_e2672 > _e996);
                                        if _e2668 {
                                            if _e2673 {
                                                phi_10821_ = ((_e2651 > 0f) != (_e2663 > 0f));
                                                phi_10822_ = false;
                                            } else {
                                                phi_10821_ = bool();
                                                phi_10822_ = true;
                                            }
                                            let _e2678 = phi_10821_;
                                            let _e2680 = phi_10822_;
                                            phi_10823_ = _e2678;
                                            phi_10824_ = _e2680;
                                        } else {
                                            phi_10823_ = bool();
                                            phi_10824_ = true;
                                        }
                                        let _e2682 = phi_10823_;
                                        let _e2684 = phi_10824_;
                                        if _e2684 {
                                            phi_10828_ = false;
                                        } else {
                                            phi_10828_ = _e2682;
                                        }
                                        let _e2686 = phi_10828_;
                                        if _e2668 {
                                            if _e2673 {
                                                if _e2686 {
                                                    phi_10839_ = type_41();
                                                } else {
                                                    phi_10839_ = type_41(1f, 0f, _e2686);
                                                }
                                                let _e2689 = phi_10839_;
                                                phi_10840_ = _e2689;
                                                phi_10841_ = _e2686;
                                            } else {
                                                phi_10840_ = type_41();
                                                phi_10841_ = true;
                                            }
                                            let _e2691 = phi_10840_;
                                            let _e2693 = phi_10841_;
                                            phi_10842_ = _e2691;
                                            phi_10843_ = _e2693;
                                        } else {
                                            phi_10842_ = type_41();
                                            phi_10843_ = true;
                                        }
                                        let _e2695 = phi_10842_;
                                        let _e2697 = phi_10843_;
                                        if _e2697 {
                                            if _e2668 {
                                                if (_e2651 < 0f) {
                                                    phi_10854_ = -1f;
                                                } else {
                                                    phi_10854_ = 1f;
                                                }
                                                let _e2700 = phi_10854_;
                                                let _e2703 = (_e668 - _e645);
                                                phi_10864_ = type_12(0u, 64u);
                                                phi_10867_ = _e2638;
                                                phi_10869_ = _e2632;
                                                phi_10871_ = (0.5f * (_e2632 + _e2638));
                                                loop {
                                                    let _e2709 = phi_10864_;
                                                    let _e2711 = phi_10867_;
                                                    let _e2713 = phi_10869_;
                                                    let _e2715 = phi_10871_;
                                                    local_65 = _e2713;
                                                    if (_e2709.member < _e2709.member_1) {
                                                        phi_10865_ = type_12((_e2709.member + 1u), _e2709.member_1);
                                                        phi_10894_ = type_12(1u, _e2709.member);
                                                    } else {
                                                        phi_10865_ = _e2709;
                                                        phi_10894_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e2727 = phi_10865_;
                                                    let _e2729 = phi_10894_;
                                                    if (bitcast<i32>(_e2729.member) != 0i) {
                                                        let _e2733 = (1f - _e2715);
                                                        let _e2746 = ((_e2700 * ((((_e622 * _e2733) + (_e645 * _e2715)) * (_e2733 * _e2733)) + (((_e668 * _e2733) + (_e679 * _e2715)) * (_e2715 * _e2715)))) - _e996);
                                                        if (_e2746 > 0f) {
                                                            phi_10919_ = _e2711;
                                                            phi_10920_ = _e2715;
                                                        } else {
                                                            phi_10919_ = _e2715;
                                                            phi_10920_ = _e2713;
                                                        }
                                                        let _e2749 = phi_10919_;
                                                        let _e2751 = phi_10920_;
                                                        let _e2753 = ((_e2749 - _e2751) > _e1003);
                                                        if _e2753 {
                                                            let _e2754 = (1f - _e2715);
                                                            let _e2766 = (-(_e2746) / (_e2700 * (((((_e645 - (3f * _e622)) * _e2754) + (_e2703 * _e2715)) * _e2754) + (((_e2703 * _e2754) + (((3f * _e679) - _e668) * _e2715)) * _e2715))));
                                                            if (_e2746 > 0f) {
                                                                phi_10946_ = (0.5f * _e1003);
                                                            } else {
                                                                phi_10946_ = -((0.5f * _e1003));
                                                            }
                                                            let _e2772 = phi_10946_;
                                                            let _e2774 = ((_e2715 + _e2766) + _e2772);
                                                            if (_e2774 > _e2751) {
                                                                if (_e2774 < _e2749) {
                                                                    if (_e2766 < 0f) {
                                                                        phi_10962_ = -(_e2766);
                                                                    } else {
                                                                        phi_10962_ = _e2766;
                                                                    }
                                                                    let _e2780 = phi_10962_;
                                                                    if (_e2780 < (0.5f * (_e2749 - _e2751))) {
                                                                        phi_10969_ = false;
                                                                    } else {
                                                                        phi_10969_ = true;
                                                                    }
                                                                    let _e2785 = phi_10969_;
                                                                    phi_10970_ = _e2785;
                                                                } else {
                                                                    phi_10970_ = true;
                                                                }
                                                                let _e2787 = phi_10970_;
                                                                phi_10971_ = _e2787;
                                                            } else {
                                                                phi_10971_ = true;
                                                            }
                                                            let _e2789 = phi_10971_;
                                                            if _e2789 {
                                                                phi_10977_ = (0.5f * (_e2751 + _e2749));
                                                            } else {
                                                                phi_10977_ = _e2774;
                                                            }
                                                            let _e2793 = phi_10977_;
                                                            phi_10978_ = _e2793;
                                                            phi_10979_ = false;
                                                        } else {
                                                            phi_10978_ = f32();
                                                            phi_10979_ = true;
                                                        }
                                                        let _e2795 = phi_10978_;
                                                        let _e2797 = phi_10979_;
                                                        phi_10868_ = _e2749;
                                                        phi_10870_ = _e2751;
                                                        phi_10872_ = _e2795;
                                                        phi_10980_ = _e2751;
                                                        phi_10981_ = _e2753;
                                                        phi_10982_ = _e2797;
                                                    } else {
                                                        phi_10868_ = f32();
                                                        phi_10870_ = f32();
                                                        phi_10872_ = f32();
                                                        phi_10980_ = f32();
                                                        phi_10981_ = false;
                                                        phi_10982_ = false;
                                                    }
                                                    let _e2799 = phi_10868_;
                                                    let _e2801 = phi_10870_;
                                                    let _e2803 = phi_10872_;
                                                    let _e2805 = phi_10980_;
                                                    let _e2807 = phi_10981_;
                                                    let _e2809 = phi_10982_;
                                                    local_24 = _e2809;
                                                    local_64 = _e2805;
                                                    continue;
                                                    continuing {
                                                        phi_10864_ = _e2727;
                                                        phi_10867_ = _e2799;
                                                        phi_10869_ = _e2801;
                                                        phi_10871_ = _e2803;
                                                        break if !(_e2807);
                                                    }
                                                }
                                                let _e2812 = local_24;
                                                if _e2812 {
                                                    let _e10229 = local_64;
                                                    phi_10986_ = _e10229;
                                                } else {
                                                    let _e10231 = local_65;
                                                    phi_10986_ = _e10231;
                                                }
                                                let _e2814 = phi_10986_;
                                                phi_10987_ = _e2814;
                                            } else {
                                                phi_10987_ = _e2632;
                                            }
                                            let _e2816 = phi_10987_;
                                            if _e2673 {
                                                if (_e2663 < 0f) {
                                                    phi_10995_ = -1f;
                                                } else {
                                                    phi_10995_ = 1f;
                                                }
                                                let _e2819 = phi_10995_;
                                                phi_10999_ = type_12(0u, 64u);
                                                phi_11002_ = (_e1003 + _e1003);
                                                loop {
                                                    let _e2822 = phi_10999_;
                                                    let _e2824 = phi_11002_;
                                                    if (_e2822.member < _e2822.member_1) {
                                                        phi_11000_ = type_12((_e2822.member + 1u), _e2822.member_1);
                                                        phi_11025_ = type_12(1u, _e2822.member);
                                                    } else {
                                                        phi_11000_ = _e2822;
                                                        phi_11025_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e2836 = phi_11000_;
                                                    let _e2838 = phi_11025_;
                                                    if (bitcast<i32>(_e2838.member) != 0i) {
                                                        let _e2842 = (_e2816 + _e2824);
                                                        if (_e2842 < _e2638) {
                                                            let _e2844 = (1f - _e2842);
                                                            let _e2857 = ((_e2819 * ((((_e622 * _e2844) + (_e645 * _e2842)) * (_e2844 * _e2844)) + (((_e668 * _e2844) + (_e679 * _e2842)) * (_e2842 * _e2842)))) > _e996);
                                                            if _e2857 {
                                                                phi_11055_ = f32();
                                                                phi_11056_ = false;
                                                            } else {
                                                                phi_11055_ = (_e2824 + _e2824);
                                                                phi_11056_ = true;
                                                            }
                                                            let _e2860 = phi_11055_;
                                                            let _e2862 = phi_11056_;
                                                            phi_11057_ = _e2860;
                                                            phi_11058_ = _e2862;
                                                            phi_11059_ = _e2857;
                                                            phi_11060_ = false;
                                                        } else {
                                                            phi_11057_ = f32();
                                                            phi_11058_ = false;
                                                            phi_11059_ = false;
                                                            phi_11060_ = true;
                                                        }
                                                        let _e2864 = phi_11057_;
                                                        let _e2866 = phi_11058_;
                                                        let _e2868 = phi_11059_;
                                                        let _e2870 = phi_11060_;
                                                        phi_11061_ = _e2842;
                                                        phi_11003_ = _e2864;
                                                        phi_11062_ = _e2866;
                                                        phi_11063_ = _e2868;
                                                        phi_11064_ = _e2870;
                                                        phi_11065_ = false;
                                                    } else {
                                                        phi_11061_ = f32();
                                                        phi_11003_ = f32();
                                                        phi_11062_ = false;
                                                        phi_11063_ = false;
                                                        phi_11064_ = false;
                                                        phi_11065_ = true;
                                                    }
                                                    let _e2872 = phi_11061_;
                                                    let _e2874 = phi_11003_;
                                                    let _e2876 = phi_11062_;
                                                    let _e2878 = phi_11063_;
                                                    let _e2880 = phi_11064_;
                                                    let _e2882 = phi_11065_;
                                                    local_25 = _e2878;
                                                    local_66 = _e2880;
                                                    local_67 = _e2882;
                                                    local_68 = _e2872;
                                                    continue;
                                                    continuing {
                                                        phi_10999_ = _e2836;
                                                        phi_11002_ = _e2874;
                                                        break if !(_e2876);
                                                    }
                                                }
                                                let _e2885 = local_25;
                                                if _e2885 {
                                                    phi_11069_ = false;
                                                    phi_11070_ = false;
                                                } else {
                                                    let _e10253 = local_66;
                                                    phi_11069_ = _e10253;
                                                    let _e10256 = local_67;
                                                    phi_11070_ = _e10256;
                                                }
                                                let _e2887 = phi_11069_;
                                                let _e2889 = phi_11070_;
                                                if _e2887 {
                                                    phi_11074_ = true;
                                                } else {
                                                    phi_11074_ = _e2889;
                                                }
                                                let _e2891 = phi_11074_;
                                                if _e2891 {
                                                    phi_11078_ = _e2638;
                                                } else {
                                                    let _e10260 = local_68;
                                                    phi_11078_ = _e10260;
                                                }
                                                let _e2893 = phi_11078_;
                                                phi_11079_ = _e2893;
                                            } else {
                                                phi_11079_ = _e2638;
                                            }
                                            let _e2895 = phi_11079_;
                                            phi_11081_ = type_41(_e2816, _e2895, _e2686);
                                        } else {
                                            phi_11081_ = _e2695;
                                        }
                                        let _e2898 = phi_11081_;
                                        if (_e2898.member > _e2898.member_1) {
                                            phi_14874_ = bool();
                                            phi_14875_ = f32();
                                            phi_14876_ = f32();
                                            phi_14877_ = true;
                                            phi_14878_ = false;
                                            phi_14879_ = false;
                                            phi_14880_ = false;
                                        } else {
                                            let _e2905 = ((_e2898.member_1 - _e2898.member) * 0.5f);
                                            let _e2906 = (_e2898.member + _e2905);
                                            let _e2908 = (_e2905 + (0.000000059604645f * 4f));
                                            let _e2910 = local_18.member_3;
                                            let _e2913 = local_18.member[0u];
                                            if (_e2913[0] < 0f) {
                                                phi_11110_ = -(_e2913[0]);
                                            } else {
                                                phi_11110_ = _e2913[0];
                                            }
                                            let _e2920 = phi_11110_;
                                            if (_e2913[1] < 0f) {
                                                phi_11117_ = -(_e2913[1]);
                                            } else {
                                                phi_11117_ = _e2913[1];
                                            }
                                            let _e2924 = phi_11117_;
                                            if (_e2920 > _e2924) {
                                                phi_11122_ = _e2920;
                                            } else {
                                                phi_11122_ = _e2924;
                                            }
                                            let _e2927 = phi_11122_;
                                            if (_e2913[2] < 0f) {
                                                phi_11129_ = -(_e2913[2]);
                                            } else {
                                                phi_11129_ = _e2913[2];
                                            }
                                            let _e2931 = phi_11129_;
                                            if (_e2927 > _e2931) {
                                                phi_11134_ = _e2927;
                                            } else {
                                                phi_11134_ = _e2931;
                                            }
                                            let _e2934 = phi_11134_;
                                            let _e2936 = local_18.member[1u];
                                            if (_e2936[0] < 0f) {
                                                phi_11147_ = -(_e2936[0]);
                                            } else {
                                                phi_11147_ = _e2936[0];
                                            }
                                            let _e2943 = phi_11147_;
                                            if (_e2936[1] < 0f) {
                                                phi_11154_ = -(_e2936[1]);
                                            } else {
                                                phi_11154_ = _e2936[1];
                                            }
                                            let _e2947 = phi_11154_;
                                            if (_e2943 > _e2947) {
                                                phi_11159_ = _e2943;
                                            } else {
                                                phi_11159_ = _e2947;
                                            }
                                            let _e2950 = phi_11159_;
                                            if (_e2936[2] < 0f) {
                                                phi_11166_ = -(_e2936[2]);
                                            } else {
                                                phi_11166_ = _e2936[2];
                                            }
                                            let _e2954 = phi_11166_;
                                            if (_e2950 > _e2954) {
                                                phi_11171_ = _e2950;
                                            } else {
                                                phi_11171_ = _e2954;
                                            }
                                            let _e2957 = phi_11171_;
                                            if (_e2934 > _e2957) {
                                                phi_11176_ = _e2934;
                                            } else {
                                                phi_11176_ = _e2957;
                                            }
                                            let _e2960 = phi_11176_;
                                            let _e2963 = local_18.member[0u];
                                            let _e2968 = local_18.member[1u];
                                            let _e2978 = (_e2963[0] + ((_e2968[0] - _e2963[0]) * _e2906));
                                            let _e2979 = (_e2963[1] + ((_e2968[1] - _e2963[1]) * _e2906));
                                            let _e2980 = (_e2963[2] + ((_e2968[2] - _e2963[2]) * _e2906));
                                            let _e2982 = local_18.member[1u];
                                            let _e2987 = local_18.member[0u];
                                            let _e2991 = (_e2982[0] - _e2987[0]);
                                            let _e2992 = (_e2982[1] - _e2987[1]);
                                            let _e2993 = (_e2982[2] - _e2987[2]);
                                            if (_e2991 < 0f) {
                                                phi_11235_ = -(_e2991);
                                            } else {
                                                phi_11235_ = _e2991;
                                            }
                                            let _e2997 = phi_11235_;
                                            if (_e2992 < 0f) {
                                                phi_11241_ = -(_e2992);
                                            } else {
                                                phi_11241_ = _e2992;
                                            }
                                            let _e3001 = phi_11241_;
                                            if (_e2997 > _e3001) {
                                                phi_11246_ = _e2997;
                                            } else {
                                                phi_11246_ = _e3001;
                                            }
                                            let _e3004 = phi_11246_;
                                            if (_e2993 < 0f) {
                                                phi_11252_ = -(_e2993);
                                            } else {
                                                phi_11252_ = _e2993;
                                            }
                                            let _e3008 = phi_11252_;
                                            if (_e3004 > _e3008) {
                                                phi_11257_ = _e3004;
                                            } else {
                                                phi_11257_ = _e3008;
                                            }
                                            let _e3011 = phi_11257_;
                                            let _e3017 = ((((_e2908 * _e3011) * 1.01f) + ((_e2960 + _e2910) * (0.000000059604645f * 8f))) + _e2910);
                                            if (_e2978 < 0f) {
                                                phi_11269_ = -(_e2978);
                                            } else {
                                                phi_11269_ = _e2978;
                                            }
                                            let _e3021 = phi_11269_;
                                            if (_e2979 < 0f) {
                                                phi_11275_ = -(_e2979);
                                            } else {
                                                phi_11275_ = _e2979;
                                            }
                                            let _e3025 = phi_11275_;
                                            if (_e3021 > _e3025) {
                                                phi_11280_ = _e3021;
                                            } else {
                                                phi_11280_ = _e3025;
                                            }
                                            let _e3028 = phi_11280_;
                                            if (_e2980 < 0f) {
                                                phi_11286_ = -(_e2980);
                                            } else {
                                                phi_11286_ = _e2980;
                                            }
                                            let _e3032 = phi_11286_;
                                            if (_e3028 > _e3032) {
                                                phi_11291_ = _e3028;
                                            } else {
                                                phi_11291_ = _e3032;
                                            }
                                            let _e3035 = phi_11291_;
                                            local_2 = type_26(array<f32, 3>(_e2978, _e2979, _e2980), _e3017, (_e3035 + _e3017));
                                            let _e3041 = local_18.member_3;
                                            let _e3043 = local_18.member_1[0u];
                                            if (_e3043[0] < 0f) {
                                                phi_11317_ = -(_e3043[0]);
                                            } else {
                                                phi_11317_ = _e3043[0];
                                            }
                                            let _e3050 = phi_11317_;
                                            if (_e3043[1] < 0f) {
                                                phi_11324_ = -(_e3043[1]);
                                            } else {
                                                phi_11324_ = _e3043[1];
                                            }
                                            let _e3054 = phi_11324_;
                                            if (_e3050 > _e3054) {
                                                phi_11329_ = _e3050;
                                            } else {
                                                phi_11329_ = _e3054;
                                            }
                                            let _e3057 = phi_11329_;
                                            if (_e3043[2] < 0f) {
                                                phi_11336_ = -(_e3043[2]);
                                            } else {
                                                phi_11336_ = _e3043[2];
                                            }
                                            let _e3061 = phi_11336_;
                                            if (_e3057 > _e3061) {
                                                phi_11341_ = _e3057;
                                            } else {
                                                phi_11341_ = _e3061;
                                            }
                                            let _e3064 = phi_11341_;
                                            let _e3066 = local_18.member_1[1u];
                                            if (_e3066[0] < 0f) {
                                                phi_11354_ = -(_e3066[0]);
                                            } else {
                                                phi_11354_ = _e3066[0];
                                            }
                                            let _e3073 = phi_11354_;
                                            if (_e3066[1] < 0f) {
                                                phi_11361_ = -(_e3066[1]);
                                            } else {
                                                phi_11361_ = _e3066[1];
                                            }
                                            let _e3077 = phi_11361_;
                                            if (_e3073 > _e3077) {
                                                phi_11366_ = _e3073;
                                            } else {
                                                phi_11366_ = _e3077;
                                            }
                                            let _e3080 = phi_11366_;
                                            if (_e3066[2] < 0f) {
                                                phi_11373_ = -(_e3066[2]);
                                            } else {
                                                phi_11373_ = _e3066[2];
                                            }
                                            let _e3084 = phi_11373_;
                                            if (_e3080 > _e3084) {
                                                phi_11378_ = _e3080;
                                            } else {
                                                phi_11378_ = _e3084;
                                            }
                                            let _e3087 = phi_11378_;
                                            if (_e3064 > _e3087) {
                                                phi_11383_ = _e3064;
                                            } else {
                                                phi_11383_ = _e3087;
                                            }
                                            let _e3090 = phi_11383_;
                                            let _e3093 = local_18.member_1[0u];
                                            let _e3098 = local_18.member_1[1u];
                                            let _e3108 = (_e3093[0] + ((_e3098[0] - _e3093[0]) * _e2906));
                                            let _e3109 = (_e3093[1] + ((_e3098[1] - _e3093[1]) * _e2906));
                                            let _e3110 = (_e3093[2] + ((_e3098[2] - _e3093[2]) * _e2906));
                                            let _e3112 = local_18.member_1[1u];
                                            let _e3117 = local_18.member_1[0u];
                                            let _e3121 = (_e3112[0] - _e3117[0]);
                                            let _e3122 = (_e3112[1] - _e3117[1]);
                                            let _e3123 = (_e3112[2] - _e3117[2]);
                                            if (_e3121 < 0f) {
                                                phi_11442_ = -(_e3121);
                                            } else {
                                                phi_11442_ = _e3121;
                                            }
                                            let _e3127 = phi_11442_;
                                            if (_e3122 < 0f) {
                                                phi_11448_ = -(_e3122);
                                            } else {
                                                phi_11448_ = _e3122;
                                            }
                                            let _e3131 = phi_11448_;
                                            if (_e3127 > _e3131) {
                                                phi_11453_ = _e3127;
                                            } else {
                                                phi_11453_ = _e3131;
                                            }
                                            let _e3134 = phi_11453_;
                                            if (_e3123 < 0f) {
                                                phi_11459_ = -(_e3123);
                                            } else {
                                                phi_11459_ = _e3123;
                                            }
                                            let _e3138 = phi_11459_;
                                            if (_e3134 > _e3138) {
                                                phi_11464_ = _e3134;
                                            } else {
                                                phi_11464_ = _e3138;
                                            }
                                            let _e3141 = phi_11464_;
                                            let _e3147 = ((((_e2908 * _e3141) * 1.01f) + ((_e3090 + _e3041) * (0.000000059604645f * 8f))) + _e3041);
                                            if (_e3108 < 0f) {
                                                phi_11476_ = -(_e3108);
                                            } else {
                                                phi_11476_ = _e3108;
                                            }
                                            let _e3151 = phi_11476_;
                                            if (_e3109 < 0f) {
                                                phi_11482_ = -(_e3109);
                                            } else {
                                                phi_11482_ = _e3109;
                                            }
                                            let _e3155 = phi_11482_;
                                            if (_e3151 > _e3155) {
                                                phi_11487_ = _e3151;
                                            } else {
                                                phi_11487_ = _e3155;
                                            }
                                            let _e3158 = phi_11487_;
                                            if (_e3110 < 0f) {
                                                phi_11493_ = -(_e3110);
                                            } else {
                                                phi_11493_ = _e3110;
                                            }
                                            let _e3162 = phi_11493_;
                                            if (_e3158 > _e3162) {
                                                phi_11498_ = _e3158;
                                            } else {
                                                phi_11498_ = _e3162;
                                            }
                                            let _e3165 = phi_11498_;
                                            local_3 = type_26(array<f32, 3>(_e3108, _e3109, _e3110), _e3147, (_e3165 + _e3147));
                                            let _e3171 = local_18.member_3;
                                            let _e3173 = local_18.member_2[0u];
                                            if (_e3173[0] < 0f) {
                                                phi_11524_ = -(_e3173[0]);
                                            } else {
                                                phi_11524_ = _e3173[0];
                                            }
                                            let _e3180 = phi_11524_;
                                            if (_e3173[1] < 0f) {
                                                phi_11531_ = -(_e3173[1]);
                                            } else {
                                                phi_11531_ = _e3173[1];
                                            }
                                            let _e3184 = phi_11531_;
                                            if (_e3180 > _e3184) {
                                                phi_11536_ = _e3180;
                                            } else {
                                                phi_11536_ = _e3184;
                                            }
                                            let _e3187 = phi_11536_;
                                            if (_e3173[2] < 0f) {
                                                phi_11543_ = -(_e3173[2]);
                                            } else {
                                                phi_11543_ = _e3173[2];
                                            }
                                            let _e3191 = phi_11543_;
                                            if (_e3187 > _e3191) {
                                                phi_11548_ = _e3187;
                                            } else {
                                                phi_11548_ = _e3191;
                                            }
                                            let _e3194 = phi_11548_;
                                            let _e3196 = local_18.member_2[1u];
                                            if (_e3196[0] < 0f) {
                                                phi_11561_ = -(_e3196[0]);
                                            } else {
                                                phi_11561_ = _e3196[0];
                                            }
                                            let _e3203 = phi_11561_;
                                            if (_e3196[1] < 0f) {
                                                phi_11568_ = -(_e3196[1]);
                                            } else {
                                                phi_11568_ = _e3196[1];
                                            }
                                            let _e3207 = phi_11568_;
                                            if (_e3203 > _e3207) {
                                                phi_11573_ = _e3203;
                                            } else {
                                                phi_11573_ = _e3207;
                                            }
                                            let _e3210 = phi_11573_;
                                            if (_e3196[2] < 0f) {
                                                phi_11580_ = -(_e3196[2]);
                                            } else {
                                                phi_11580_ = _e3196[2];
                                            }
                                            let _e3214 = phi_11580_;
                                            if (_e3210 > _e3214) {
                                                phi_11585_ = _e3210;
                                            } else {
                                                phi_11585_ = _e3214;
                                            }
                                            let _e3217 = phi_11585_;
                                            if (_e3194 > _e3217) {
                                                phi_11590_ = _e3194;
                                            } else {
                                                phi_11590_ = _e3217;
                                            }
                                            let _e3220 = phi_11590_;
                                            let _e3223 = local_18.member_2[0u];
                                            let _e3228 = local_18.member_2[1u];
                                            let _e3238 = (_e3223[0] + ((_e3228[0] - _e3223[0]) * _e2906));
                                            let _e3239 = (_e3223[1] + ((_e3228[1] - _e3223[1]) * _e2906));
                                            let _e3240 = (_e3223[2] + ((_e3228[2] - _e3223[2]) * _e2906));
                                            let _e3242 = local_18.member_2[1u];
                                            let _e3247 = local_18.member_2[0u];
                                            let _e3251 = (_e3242[0] - _e3247[0]);
                                            let _e3252 = (_e3242[1] - _e3247[1]);
                                            let _e3253 = (_e3242[2] - _e3247[2]);
                                            if (_e3251 < 0f) {
                                                phi_11649_ = -(_e3251);
                                            } else {
                                                phi_11649_ = _e3251;
                                            }
                                            let _e3257 = phi_11649_;
                                            if (_e3252 < 0f) {
                                                phi_11655_ = -(_e3252);
                                            } else {
                                                phi_11655_ = _e3252;
                                            }
                                            let _e3261 = phi_11655_;
                                            if (_e3257 > _e3261) {
                                                phi_11660_ = _e3257;
                                            } else {
                                                phi_11660_ = _e3261;
                                            }
                                            let _e3264 = phi_11660_;
                                            if (_e3253 < 0f) {
                                                phi_11666_ = -(_e3253);
                                            } else {
                                                phi_11666_ = _e3253;
                                            }
                                            let _e3268 = phi_11666_;
                                            if (_e3264 > _e3268) {
                                                phi_11671_ = _e3264;
                                            } else {
                                                phi_11671_ = _e3268;
                                            }
                                            let _e3271 = phi_11671_;
                                            let _e3277 = ((((_e2908 * _e3271) * 1.01f) + ((_e3220 + _e3171) * (0.000000059604645f * 8f))) + _e3171);
                                            if (_e3238 < 0f) {
                                                phi_11683_ = -(_e3238);
                                            } else {
                                                phi_11683_ = _e3238;
                                            }
                                            let _e3281 = phi_11683_;
                                            if (_e3239 < 0f) {
                                                phi_11689_ = -(_e3239);
                                            } else {
                                                phi_11689_ = _e3239;
                                            }
                                            let _e3285 = phi_11689_;
                                            if (_e3281 > _e3285) {
                                                phi_11694_ = _e3281;
                                            } else {
                                                phi_11694_ = _e3285;
                                            }
                                            let _e3288 = phi_11694_;
                                            if (_e3240 < 0f) {
                                                phi_11700_ = -(_e3240);
                                            } else {
                                                phi_11700_ = _e3240;
                                            }
                                            let _e3292 = phi_11700_;
                                            if (_e3288 > _e3292) {
                                                phi_11705_ = _e3288;
                                            } else {
                                                phi_11705_ = _e3292;
                                            }
                                            let _e3295 = phi_11705_;
                                            local_4 = type_26(array<f32, 3>(_e3238, _e3239, _e3240), _e3277, (_e3295 + _e3277));
                                            let _e3300 = local_3.member;
                                            let _e3305 = local_4.member;
                                            let _e3311 = ((_e3300[1] * _e3305[2]) - (_e3300[2] * _e3305[1]));
                                            let _e3314 = ((_e3300[2] * _e3305[0]) - (_e3300[0] * _e3305[2]));
                                            let _e3317 = ((_e3300[0] * _e3305[1]) - (_e3300[1] * _e3305[0]));
                                            if (_e3311 < 0f) {
                                                phi_11754_ = -(_e3311);
                                            } else {
                                                phi_11754_ = _e3311;
                                            }
                                            let _e3321 = phi_11754_;
                                            if (_e3314 < 0f) {
                                                phi_11760_ = -(_e3314);
                                            } else {
                                                phi_11760_ = _e3314;
                                            }
                                            let _e3325 = phi_11760_;
                                            if (_e3321 > _e3325) {
                                                if (_e3311 < 0f) {
                                                    phi_11770_ = -(_e3311);
                                                } else {
                                                    phi_11770_ = _e3311;
                                                }
                                                let _e3343 = phi_11770_;
                                                if (_e3317 < 0f) {
                                                    phi_11776_ = -(_e3317);
                                                } else {
                                                    phi_11776_ = _e3317;
                                                }
                                                let _e3347 = phi_11776_;
                                                if (_e3343 > _e3347) {
                                                    phi_11781_ = 2u;
                                                    phi_11782_ = 1u;
                                                } else {
                                                    phi_11781_ = 1u;
                                                    phi_11782_ = 0u;
                                                }
                                                let _e3350 = phi_11781_;
                                                let _e3352 = phi_11782_;
                                                phi_11801_ = _e3350;
                                                phi_11802_ = _e3352;
                                            } else {
                                                if (_e3314 < 0f) {
                                                    phi_11788_ = -(_e3314);
                                                } else {
                                                    phi_11788_ = _e3314;
                                                }
                                                let _e3330 = phi_11788_;
                                                if (_e3317 < 0f) {
                                                    phi_11794_ = -(_e3317);
                                                } else {
                                                    phi_11794_ = _e3317;
                                                }
                                                let _e3334 = phi_11794_;
                                                if (_e3330 > _e3334) {
                                                    phi_11799_ = 0u;
                                                    phi_11800_ = 2u;
                                                } else {
                                                    phi_11799_ = 1u;
                                                    phi_11800_ = 0u;
                                                }
                                                let _e3337 = phi_11799_;
                                                let _e3339 = phi_11800_;
                                                phi_11801_ = _e3337;
                                                phi_11802_ = _e3339;
                                            }
                                            let _e3354 = phi_11801_;
                                            let _e3356 = phi_11802_;
                                            let _e3359 = local_3.member[_e3356];
                                            let _e3362 = local_4.member[_e3354];
                                            let _e3366 = local_3.member[_e3354];
                                            let _e3369 = local_4.member[_e3356];
                                            let _e3371 = ((_e3359 * _e3362) - (_e3366 * _e3369));
                                            let _e3373 = local_3.member_1;
                                            let _e3375 = local_4.member_2;
                                            let _e3378 = local_3.member_2;
                                            let _e3380 = local_4.member_1;
                                            let _e3385 = local_3.member_2;
                                            let _e3388 = local_4.member_2;
                                            let _e3396 = local_3.member_2;
                                            let _e3399 = local_4.member_2;
                                            let _e3403 = (((((_e3373 * _e3375) + (_e3378 * _e3380)) * 2.01f) + (((_e3385 * 2f) * (_e3388 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3396) * (1f + _e3399))));
                                            if (_e3371 < 0f) {
                                                phi_11871_ = -(_e3371);
                                            } else {
                                                phi_11871_ = _e3371;
                                            }
                                            let _e3407 = phi_11871_;
                                            if (_e3407 > _e3403) {
                                                if (_e3371 < 0f) {
                                                    phi_11880_ = -1f;
                                                } else {
                                                    phi_11880_ = 1f;
                                                }
                                                let _e3411 = phi_11880_;
                                                let _e3414 = local_2.member[_e3356];
                                                let _e3417 = local_4.member[_e3354];
                                                let _e3421 = local_2.member[_e3354];
                                                let _e3424 = local_4.member[_e3356];
                                                let _e3428 = local_2.member_1;
                                                let _e3430 = local_4.member_2;
                                                let _e3433 = local_2.member_2;
                                                let _e3435 = local_4.member_1;
                                                let _e3440 = local_2.member_2;
                                                let _e3443 = local_4.member_2;
                                                let _e3451 = local_2.member_2;
                                                let _e3454 = local_4.member_2;
                                                let _e3458 = (((((_e3428 * _e3430) + (_e3433 * _e3435)) * 2.01f) + (((_e3440 * 2f) * (_e3443 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3451) * (1f + _e3454))));
                                                let _e3461 = local_3.member[_e3356];
                                                let _e3464 = local_2.member[_e3354];
                                                let _e3468 = local_3.member[_e3354];
                                                let _e3471 = local_2.member[_e3356];
                                                let _e3475 = local_3.member_1;
                                                let _e3477 = local_2.member_2;
                                                let _e3480 = local_3.member_2;
                                                let _e3482 = local_2.member_1;
                                                let _e3487 = local_3.member_2;
                                                let _e3490 = local_2.member_2;
                                                let _e3498 = local_3.member_2;
                                                let _e3501 = local_2.member_2;
                                                let _e3505 = (((((_e3475 * _e3477) + (_e3480 * _e3482)) * 2.01f) + (((_e3487 * 2f) * (_e3490 * 2f)) * (0.000000059604645f * 2f))) + ((0.000000000000000000000000000000000000011754944f * 256f) * ((1f + _e3498) * (1f + _e3501))));
                                                let _e3506 = (_e3371 * _e3411);
                                                let _e3507 = (((_e3414 * _e3417) - (_e3421 * _e3424)) * _e3411);
                                                let _e3508 = (((_e3461 * _e3464) - (_e3468 * _e3471)) * _e3411);
                                                if (_e3506 < 0f) {
                                                    phi_12015_ = -(_e3506);
                                                } else {
                                                    phi_12015_ = _e3506;
                                                }
                                                let _e3512 = phi_12015_;
                                                if (_e3507 < 0f) {
                                                    phi_12021_ = -(_e3507);
                                                } else {
                                                    phi_12021_ = _e3507;
                                                }
                                                let _e3516 = phi_12021_;
                                                if (_e3508 < 0f) {
                                                    phi_12028_ = -(_e3508);
                                                } else {
                                                    phi_12028_ = _e3508;
                                                }
                                                let _e3521 = phi_12028_;
                                                let _e3524 = (((_e3512 + _e3516) + _e3521) * (0.000000059604645f * 4f));
                                                local_5 = array<type_33, 4>(type_33(_e3507, _e3458), type_33(_e3508, _e3505), type_33((_e3506 - _e3507), ((_e3403 + _e3458) + _e3524)), type_33((_e3506 - _e3508), ((_e3403 + _e3505) + _e3524)));
                                                phi_12083_ = type_12(0u, 4u);
                                                phi_12086_ = true;
                                                loop {
                                                    let _e3537 = phi_12083_;
                                                    let _e3539 = phi_12086_;
                                                    local_27 = _e3539;
                                                    if (_e3537.member < _e3537.member_1) {
                                                        phi_12084_ = type_12((_e3537.member + 1u), _e3537.member_1);
                                                        phi_12109_ = type_12(1u, _e3537.member);
                                                    } else {
                                                        phi_12084_ = _e3537;
                                                        phi_12109_ = type_12(0u, type_12().member_1);
                                                    }
                                                    let _e3551 = phi_12084_;
                                                    let _e3553 = phi_12109_;
                                                    if (bitcast<i32>(_e3553.member) != 0i) {
                                                        let _e3560 = local_5[_e3553.member_1].member;
                                                        let _e3563 = local_5[_e3553.member_1].member_1;
                                                        let _e3565 = (_e3560 < -(_e3563));
                                                        if _e3565 {
                                                            phi_12136_ = bool();
                                                            phi_12137_ = false;
                                                        } else {
                                                            phi_12136_ = (_e3539 && (_e3560 > _e3563));
                                                            phi_12137_ = true;
                                                        }
                                                        let _e3569 = phi_12136_;
                                                        let _e3571 = phi_12137_;
                                                        phi_12087_ = _e3569;
                                                        phi_12138_ = _e3571;
                                                        phi_12139_ = _e3565;
                                                    } else {
                                                        phi_12087_ = bool();
                                                        phi_12138_ = false;
                                                        phi_12139_ = false;
                                                    }
                                                    let _e3573 = phi_12087_;
                                                    let _e3575 = phi_12138_;
                                                    let _e3577 = phi_12139_;
                                                    local_26 = _e3577;
                                                    continue;
                                                    continuing {
                                                        phi_12083_ = _e3551;
                                                        phi_12086_ = _e3573;
                                                        break if !(_e3575);
                                                    }
                                                }
                                                let _e3580 = local_26;
                                                if _e3580 {
                                                    phi_12143_ = false;
                                                } else {
                                                    phi_12143_ = true;
                                                }
                                                let _e3582 = phi_12143_;
                                                if _e3582 {
                                                    let _e3584 = local_27;
                                                    if _e3584 {
                                                        phi_12150_ = 1u;
                                                    } else {
                                                        phi_12150_ = 2u;
                                                    }
                                                    let _e3586 = phi_12150_;
                                                    phi_12151_ = _e3586;
                                                    phi_12152_ = false;
                                                } else {
                                                    phi_12151_ = u32();
                                                    phi_12152_ = true;
                                                }
                                                let _e3588 = phi_12151_;
                                                let _e3590 = phi_12152_;
                                                phi_12153_ = _e3588;
                                                phi_12154_ = 0u;
                                                phi_12155_ = _e3590;
                                            } else {
                                                phi_12153_ = u32();
                                                phi_12154_ = 2u;
                                                phi_12155_ = true;
                                            }
                                            let _e3592 = phi_12153_;
                                            let _e3594 = phi_12154_;
                                            let _e3596 = phi_12155_;
                                            if _e3596 {
                                                phi_12159_ = _e3594;
                                            } else {
                                                phi_12159_ = _e3592;
                                            }
                                            let _e3598 = phi_12159_;
                                            let _e3599 = (_e3598 == 0u);
                                            if _e3599 {
                                                phi_14868_ = bool();
                                                phi_14869_ = f32();
                                                phi_14870_ = f32();
                                                phi_14871_ = false;
                                                phi_14872_ = false;
                                                phi_14873_ = false;
                                            } else {
                                                if (_e3598 == 1u) {
                                                    phi_12169_ = _e2898.member_2;
                                                } else {
                                                    phi_12169_ = false;
                                                }
                                                let _e3603 = phi_12169_;
                                                let _e3604 = (_e281 * 0.99f);
                                                if _e3603 {
                                                    if ((_e2898.member_1 - _e2898.member) <= _e3604) {
                                                        phi_12181_ = false;
                                                    } else {
                                                        phi_12181_ = true;
                                                    }
                                                    let _e3610 = phi_12181_;
                                                    phi_12182_ = _e3610;
                                                } else {
                                                    phi_12182_ = true;
                                                }
                                                let _e3612 = phi_12182_;
                                                if _e3612 {
                                                    let _e3617 = local_18.member[0u];
                                                    let _e3623 = local_18.member_1[0u];
                                                    let _e3629 = local_18.member_2[0u];
                                                    let _e3633 = (_e3617[0] - _e3623[0]);
                                                    let _e3634 = (_e3617[1] - _e3623[1]);
                                                    let _e3635 = (_e3617[2] - _e3623[2]);
                                                    let _e3644 = local_18.member[1u];
                                                    let _e3650 = local_18.member_1[1u];
                                                    let _e3656 = local_18.member_2[1u];
                                                    let _e3660 = (_e3644[0] - _e3650[0]);
                                                    let _e3661 = (_e3644[1] - _e3650[1]);
                                                    let _e3662 = (_e3644[2] - _e3650[2]);
                                                    let _e3671 = local_18.member[0u];
                                                    if (_e3671[0] < 0f) {
                                                        phi_12330_ = -(_e3671[0]);
                                                    } else {
                                                        phi_12330_ = _e3671[0];
                                                    }
                                                    let _e3678 = phi_12330_;
                                                    if (_e3671[1] < 0f) {
                                                        phi_12337_ = -(_e3671[1]);
                                                    } else {
                                                        phi_12337_ = _e3671[1];
                                                    }
                                                    let _e3682 = phi_12337_;
                                                    if (_e3678 > _e3682) {
                                                        phi_12342_ = _e3678;
                                                    } else {
                                                        phi_12342_ = _e3682;
                                                    }
                                                    let _e3685 = phi_12342_;
                                                    if (_e3671[2] < 0f) {
                                                        phi_12349_ = -(_e3671[2]);
                                                    } else {
                                                        phi_12349_ = _e3671[2];
                                                    }
                                                    let _e3689 = phi_12349_;
                                                    if (_e3685 > _e3689) {
                                                        phi_12354_ = _e3685;
                                                    } else {
                                                        phi_12354_ = _e3689;
                                                    }
                                                    let _e3692 = phi_12354_;
                                                    let _e3695 = local_18.member[1u];
                                                    if (_e3695[0] < 0f) {
                                                        phi_12367_ = -(_e3695[0]);
                                                    } else {
                                                        phi_12367_ = _e3695[0];
                                                    }
                                                    let _e3702 = phi_12367_;
                                                    if (_e3695[1] < 0f) {
                                                        phi_12374_ = -(_e3695[1]);
                                                    } else {
                                                        phi_12374_ = _e3695[1];
                                                    }
                                                    let _e3706 = phi_12374_;
                                                    if (_e3702 > _e3706) {
                                                        phi_12379_ = _e3702;
                                                    } else {
                                                        phi_12379_ = _e3706;
                                                    }
                                                    let _e3709 = phi_12379_;
                                                    if (_e3695[2] < 0f) {
                                                        phi_12386_ = -(_e3695[2]);
                                                    } else {
                                                        phi_12386_ = _e3695[2];
                                                    }
                                                    let _e3713 = phi_12386_;
                                                    if (_e3709 > _e3713) {
                                                        phi_12391_ = _e3709;
                                                    } else {
                                                        phi_12391_ = _e3713;
                                                    }
                                                    let _e3716 = phi_12391_;
                                                    if (_e3692 > _e3716) {
                                                        phi_12396_ = _e3692;
                                                    } else {
                                                        phi_12396_ = _e3716;
                                                    }
                                                    let _e3719 = phi_12396_;
                                                    let _e3721 = local_18.member_3;
                                                    let _e3725 = local_18.member_1[0u];
                                                    if (_e3725[0] < 0f) {
                                                        phi_12413_ = -(_e3725[0]);
                                                    } else {
                                                        phi_12413_ = _e3725[0];
                                                    }
                                                    let _e3732 = phi_12413_;
                                                    if (_e3725[1] < 0f) {
                                                        phi_12420_ = -(_e3725[1]);
                                                    } else {
                                                        phi_12420_ = _e3725[1];
                                                    }
                                                    let _e3736 = phi_12420_;
                                                    if (_e3732 > _e3736) {
                                                        phi_12425_ = _e3732;
                                                    } else {
                                                        phi_12425_ = _e3736;
                                                    }
                                                    let _e3739 = phi_12425_;
                                                    if (_e3725[2] < 0f) {
                                                        phi_12432_ = -(_e3725[2]);
                                                    } else {
                                                        phi_12432_ = _e3725[2];
                                                    }
                                                    let _e3743 = phi_12432_;
                                                    if (_e3739 > _e3743) {
                                                        phi_12437_ = _e3739;
                                                    } else {
                                                        phi_12437_ = _e3743;
                                                    }
                                                    let _e3746 = phi_12437_;
                                                    let _e3749 = local_18.member_1[1u];
                                                    if (_e3749[0] < 0f) {
                                                        phi_12451_ = -(_e3749[0]);
                                                    } else {
                                                        phi_12451_ = _e3749[0];
                                                    }
                                                    let _e3756 = phi_12451_;
                                                    if (_e3749[1] < 0f) {
                                                        phi_12458_ = -(_e3749[1]);
                                                    } else {
                                                        phi_12458_ = _e3749[1];
                                                    }
                                                    let _e3760 = phi_12458_;
                                                    if (_e3756 > _e3760) {
                                                        phi_12463_ = _e3756;
                                                    } else {
                                                        phi_12463_ = _e3760;
                                                    }
                                                    let _e3763 = phi_12463_;
                                                    if (_e3749[2] < 0f) {
                                                        phi_12470_ = -(_e3749[2]);
                                                    } else {
                                                        phi_12470_ = _e3749[2];
                                                    }
                                                    let _e3767 = phi_12470_;
                                                    if (_e3763 > _e3767) {
                                                        phi_12475_ = _e3763;
                                                    } else {
                                                        phi_12475_ = _e3767;
                                                    }
                                                    let _e3770 = phi_12475_;
                                                    if (_e3746 > _e3770) {
                                                        phi_12480_ = _e3746;
                                                    } else {
                                                        phi_12480_ = _e3770;
                                                    }
                                                    let _e3773 = phi_12480_;
                                                    let _e3775 = local_18.member_3;
                                                    let _e3779 = local_18.member_2[0u];
                                                    if (_e3779[0] < 0f) {
                                                        phi_12497_ = -(_e3779[0]);
                                                    } else {
                                                        phi_12497_ = _e3779[0];
                                                    }
                                                    let _e3786 = phi_12497_;
                                                    if (_e3779[1] < 0f) {
                                                        phi_12504_ = -(_e3779[1]);
                                                    } else {
                                                        phi_12504_ = _e3779[1];
                                                    }
                                                    let _e3790 = phi_12504_;
                                                    if (_e3786 > _e3790) {
                                                        phi_12509_ = _e3786;
                                                    } else {
                                                        phi_12509_ = _e3790;
                                                    }
                                                    let _e3793 = phi_12509_;
                                                    if (_e3779[2] < 0f) {
                                                        phi_12516_ = -(_e3779[2]);
                                                    } else {
                                                        phi_12516_ = _e3779[2];
                                                    }
                                                    let _e3797 = phi_12516_;
                                                    if (_e3793 > _e3797) {
                                                        phi_12521_ = _e3793;
                                                    } else {
                                                        phi_12521_ = _e3797;
                                                    }
                                                    let _e3800 = phi_12521_;
                                                    let _e3803 = local_18.member_2[1u];
                                                    if (_e3803[0] < 0f) {
                                                        phi_12535_ = -(_e3803[0]);
                                                    } else {
                                                        phi_12535_ = _e3803[0];
                                                    }
                                                    let _e3810 = phi_12535_;
                                                    if (_e3803[1] < 0f) {
                                                        phi_12542_ = -(_e3803[1]);
                                                    } else {
                                                        phi_12542_ = _e3803[1];
                                                    }
                                                    let _e3814 = phi_12542_;
                                                    if (_e3810 > _e3814) {
                                                        phi_12547_ = _e3810;
                                                    } else {
                                                        phi_12547_ = _e3814;
                                                    }
                                                    let _e3817 = phi_12547_;
                                                    if (_e3803[2] < 0f) {
                                                        phi_12554_ = -(_e3803[2]);
                                                    } else {
                                                        phi_12554_ = _e3803[2];
                                                    }
                                                    let _e3821 = phi_12554_;
                                                    if (_e3817 > _e3821) {
                                                        phi_12559_ = _e3817;
                                                    } else {
                                                        phi_12559_ = _e3821;
                                                    }
                                                    let _e3824 = phi_12559_;
                                                    if (_e3800 > _e3824) {
                                                        phi_12564_ = _e3800;
                                                    } else {
                                                        phi_12564_ = _e3824;
                                                    }
                                                    let _e3827 = phi_12564_;
                                                    let _e3829 = local_18.member_3;
                                                    let _e3836 = local_18.member_3;
                                                    let _e3841 = (_e281 * 0.00390625f);
                                                    local = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                    phi_12605_ = type_12(0u, 96u);
                                                    phi_12608_ = _e2898.member;
                                                    phi_12610_ = _e2898.member;
                                                    phi_12612_ = (_e2898.member_1 - _e2898.member);
                                                    phi_12614_ = _e2898.member;
                                                    phi_12616_ = false;
                                                    phi_12618_ = 0u;
                                                    loop {
                                                        let _e3844 = phi_12605_;
                                                        let _e3846 = phi_12608_;
                                                        let _e3848 = phi_12610_;
                                                        let _e3850 = phi_12612_;
                                                        let _e3852 = phi_12614_;
                                                        let _e3854 = phi_12616_;
                                                        let _e3856 = phi_12618_;
                                                        local_30 = _e3846;
                                                        local_75 = _e3848;
                                                        if (_e3844.member < _e3844.member_1) {
                                                            phi_12606_ = type_12((_e3844.member + 1u), _e3844.member_1);
                                                            phi_12641_ = type_12(1u, _e3844.member);
                                                        } else {
                                                            phi_12606_ = _e3844;
                                                            phi_12641_ = type_12(0u, type_12().member_1);
                                                        }
                                                        let _e3868 = phi_12606_;
                                                        let _e3870 = phi_12641_;
                                                        if (bitcast<i32>(_e3870.member) != 0i) {
                                                            let _e3876 = local_18.member[0u];
                                                            let _e3882 = local_18.member[1u];
                                                            let _e3898 = local_18.member_1[0u];
                                                            let _e3904 = local_18.member_1[1u];
                                                            let _e3920 = local_18.member_2[0u];
                                                            let _e3926 = local_18.member_2[1u];
                                                            let _e3940 = function_3(array<f32, 3>((_e3876[0] + ((_e3882[0] - _e3876[0]) * _e3846)), (_e3876[1] + ((_e3882[1] - _e3876[1]) * _e3846)), (_e3876[2] + ((_e3882[2] - _e3876[2]) * _e3846))), array<f32, 3>((_e3898[0] + ((_e3904[0] - _e3898[0]) * _e3846)), (_e3898[1] + ((_e3904[1] - _e3898[1]) * _e3846)), (_e3898[2] + ((_e3904[2] - _e3898[2]) * _e3846))), array<f32, 3>((_e3920[0] + ((_e3926[0] - _e3920[0]) * _e3846)), (_e3920[1] + ((_e3926[1] - _e3920[1]) * _e3846)), (_e3920[2] + ((_e3926[2] - _e3920[2]) * _e3846))), 1u);
                                                            if (_e3856 == 0u) {
                                                                phi_12769_ = _e3940;
                                                            } else {
                                                                if (_e3856 == 1u) {
                                                                    phi_12755_ = _e3940[0];
                                                                } else {
                                                                    phi_12755_ = 0f;
                                                                }
                                                                let _e3945 = phi_12755_;
                                                                if (_e3856 == 2u) {
                                                                    phi_12761_ = _e3940[1];
                                                                } else {
                                                                    phi_12761_ = 0f;
                                                                }
                                                                let _e3949 = phi_12761_;
                                                                if (_e3856 == 3u) {
                                                                    phi_12767_ = _e3940[2];
                                                                } else {
                                                                    phi_12767_ = 0f;
                                                                }
                                                                let _e3953 = phi_12767_;
                                                                phi_12769_ = array<f32, 3>(_e3945, _e3949, _e3953);
                                                            }
                                                            let _e3956 = phi_12769_;
                                                            if (_e3956[0] < 0f) {
                                                                phi_12776_ = -(_e3956[0]);
                                                            } else {
                                                                phi_12776_ = _e3956[0];
                                                            }
                                                            let _e3961 = phi_12776_;
                                                            if (_e3956[1] < 0f) {
                                                                phi_12783_ = -(_e3956[1]);
                                                            } else {
                                                                phi_12783_ = _e3956[1];
                                                            }
                                                            let _e3966 = phi_12783_;
                                                            if (_e3956[2] < 0f) {
                                                                phi_12791_ = -(_e3956[2]);
                                                            } else {
                                                                phi_12791_ = _e3956[2];
                                                            }
                                                            let _e3972 = phi_12791_;
                                                            let _e3973 = ((_e3961 + _e3966) + _e3972);
                                                            if (_e3973 > 0f) {
                                                                if ((bitcast<u32>(_e3973) & 2139095040u) != 2139095040u) {
                                                                    let _e3978 = (1f / _e3973);
                                                                    let _e3980 = (_e3956[0] * _e3978);
                                                                    let _e3982 = (_e3956[1] * _e3978);
                                                                    let _e3984 = (_e3956[2] * _e3978);
                                                                    let _e3989 = (((_e3980 * _e3980) + (_e3982 * _e3982)) + (_e3984 * _e3984));
                                                                    if (_e3989 <= 0.000000000000000000000000000000000000011754944f) {
                                                                        if (_e3989 > 0f) {
                                                                            phi_12828_ = (0.000000000000000000106433627f * 2f);
                                                                        } else {
                                                                            phi_12828_ = 0f;
                                                                        }
                                                                        let _e4042 = phi_12828_;
                                                                        phi_12892_ = _e4042;
                                                                    } else {
                                                                        phi_12835_ = type_14(0i, 5i);
                                                                        phi_12838_ = bitcast<f32>(((bitcast<u32>(_e3989) >> bitcast<u32>(1i)) + 532369198u));
                                                                        loop {
                                                                            let _e3997 = phi_12835_;
                                                                            let _e3999 = phi_12838_;
                                                                            local_28 = _e3999;
                                                                            if (_e3997.member < _e3997.member_1) {
                                                                                let _e4006 = (_e3997.member + 1i);
                                                                                if ((false == (_e4006 > _e3997.member)) != false) {
                                                                                    phi_12859_ = true;
                                                                                } else {
                                                                                    phi_12859_ = false;
                                                                                }
                                                                                let _e4011 = phi_12859_;
                                                                                if _e4011 {
                                                                                    phi_12865_ = type_15(0u, type_15().member_1);
                                                                                } else {
                                                                                    phi_12865_ = type_15(1u, _e4006);
                                                                                }
                                                                                let _e4016 = phi_12865_;
                                                                                phi_12836_ = type_14(_e4016.member_1, _e3997.member_1);
                                                                                phi_12879_ = type_15(1u, _e3997.member);
                                                                            } else {
                                                                                phi_12836_ = _e3997;
                                                                                phi_12879_ = type_15(0u, type_15().member_1);
                                                                            }
                                                                            let _e4022 = phi_12836_;
                                                                            let _e4024 = phi_12879_;
                                                                            let _e4027 = (bitcast<i32>(_e4024.member) != 0i);
                                                                            if _e4027 {
                                                                                phi_12839_ = (0.5f * (_e3999 + (_e3989 / _e3999)));
                                                                            } else {
                                                                                phi_12839_ = f32();
                                                                            }
                                                                            let _e4032 = phi_12839_;
                                                                            continue;
                                                                            continuing {
                                                                                phi_12835_ = _e4022;
                                                                                phi_12838_ = _e4032;
                                                                                break if !(_e4027);
                                                                            }
                                                                        }
                                                                        let _e4037 = local_28;
                                                                        phi_12892_ = (_e4037 * (1f + (8f * 0.000000059604645f)));
                                                                    }
                                                                    let _e4044 = phi_12892_;
                                                                    let _e4045 = (0.000000059604645f * 12f);
                                                                    let _e4050 = ((((((((_e3719 + _e3721) + (_e3773 + _e3775)) + (_e3827 + _e3829)) * (0.000000059604645f * 16f)) + (_e3836 * 3f)) + (0.000000000000000000000000000000000000011754944f * 256f)) * 1.01f) + ((0f * _e4044) * (1f + _e4045)));
                                                                    let _e4055 = (((_e3980 * _e3617[0]) + (_e3982 * _e3617[1])) + (_e3984 * _e3617[2]));
                                                                    let _e4060 = (((_e3980 * _e3633) + (_e3982 * _e3634)) + (_e3984 * _e3635));
                                                                    let _e4065 = (((_e3980 * (_e3617[0] - _e3629[0])) + (_e3982 * (_e3617[1] - _e3629[1]))) + (_e3984 * (_e3617[2] - _e3629[2])));
                                                                    let _e4070 = (((_e3980 * (_e3633 - _e3629[0])) + (_e3982 * (_e3634 - _e3629[1]))) + (_e3984 * (_e3635 - _e3629[2])));
                                                                    let _e4076 = (((_e3980 * _e3644[0]) + (_e3982 * _e3644[1])) + (_e3984 * _e3644[2]));
                                                                    let _e4081 = (((_e3980 * _e3660) + (_e3982 * _e3661)) + (_e3984 * _e3662));
                                                                    let _e4086 = (((_e3980 * (_e3644[0] - _e3656[0])) + (_e3982 * (_e3644[1] - _e3656[1]))) + (_e3984 * (_e3644[2] - _e3656[2])));
                                                                    let _e4091 = (((_e3980 * (_e3660 - _e3656[0])) + (_e3982 * (_e3661 - _e3656[1]))) + (_e3984 * (_e3662 - _e3656[2])));
                                                                    if (_e4055 < 0f) {
                                                                        phi_12958_ = -(_e4055);
                                                                    } else {
                                                                        phi_12958_ = _e4055;
                                                                    }
                                                                    let _e4096 = phi_12958_;
                                                                    if (_e4076 < 0f) {
                                                                        phi_12964_ = -(_e4076);
                                                                    } else {
                                                                        phi_12964_ = _e4076;
                                                                    }
                                                                    let _e4100 = phi_12964_;
                                                                    if (_e4060 < 0f) {
                                                                        phi_12973_ = -(_e4060);
                                                                    } else {
                                                                        phi_12973_ = _e4060;
                                                                    }
                                                                    let _e4107 = phi_12973_;
                                                                    if (_e4081 < 0f) {
                                                                        phi_12979_ = -(_e4081);
                                                                    } else {
                                                                        phi_12979_ = _e4081;
                                                                    }
                                                                    let _e4111 = phi_12979_;
                                                                    if (_e4065 < 0f) {
                                                                        phi_12988_ = -(_e4065);
                                                                    } else {
                                                                        phi_12988_ = _e4065;
                                                                    }
                                                                    let _e4118 = phi_12988_;
                                                                    if (_e4086 < 0f) {
                                                                        phi_12994_ = -(_e4086);
                                                                    } else {
                                                                        phi_12994_ = _e4086;
                                                                    }
                                                                    let _e4122 = phi_12994_;
                                                                    if (_e4070 < 0f) {
                                                                        phi_13003_ = -(_e4070);
                                                                    } else {
                                                                        phi_13003_ = _e4070;
                                                                    }
                                                                    let _e4129 = phi_13003_;
                                                                    if (_e4091 < 0f) {
                                                                        phi_13009_ = -(_e4091);
                                                                    } else {
                                                                        phi_13009_ = _e4091;
                                                                    }
                                                                    let _e4133 = phi_13009_;
                                                                    phi_13015_ = type_32(array<f32, 4>(_e4055, _e4060, _e4065, _e4070), array<f32, 4>(_e4076, _e4081, _e4086, _e4091), array<f32, 4>((_e4050 + ((_e4096 + _e4100) * _e4045)), (_e4050 + ((_e4107 + _e4111) * _e4045)), (_e4050 + ((_e4118 + _e4122) * _e4045)), (_e4050 + ((_e4129 + _e4133) * _e4045))));
                                                                    phi_13016_ = false;
                                                                } else {
                                                                    phi_13015_ = type_32();
                                                                    phi_13016_ = true;
                                                                }
                                                                let _e4140 = phi_13015_;
                                                                let _e4142 = phi_13016_;
                                                                phi_13017_ = _e4140;
                                                                phi_13018_ = _e4142;
                                                            } else {
                                                                phi_13017_ = type_32();
                                                                phi_13018_ = true;
                                                            }
                                                            let _e4144 = phi_13017_;
                                                            let _e4146 = phi_13018_;
                                                            if _e4146 {
                                                                phi_13026_ = type_32(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(1f, 1f, 1f, 1f));
                                                            } else {
                                                                phi_13026_ = _e4144;
                                                            }
                                                            let _e4148 = phi_13026_;
                                                            local_1 = type_32(array<f32, 4>(_e4148.member[0], _e4148.member[1], _e4148.member[2], _e4148.member[3]), array<f32, 4>(_e4148.member_1[0], _e4148.member_1[1], _e4148.member_1[2], _e4148.member_1[3]), array<f32, 4>(_e4148.member_2[0], _e4148.member_2[1], _e4148.member_2[2], _e4148.member_2[3]));
                                                            let _e4168 = (_e3846 - _e3852);
                                                            let _e4172 = local_1.member[0u];
                                                            let _e4175 = local_1.member_1[0u];
                                                            let _e4178 = local_1.member[0u];
                                                            let _e4184 = local_1.member_2[0u];
                                                            if (((_e4172 + ((_e4175 - _e4178) * _e3846)) - _e4184) > 0f) {
                                                                let _e4189 = local_1.member[1u];
                                                                let _e4192 = local_1.member_1[1u];
                                                                let _e4195 = local_1.member[1u];
                                                                let _e4201 = local_1.member_2[1u];
                                                                if (((_e4189 + ((_e4192 - _e4195) * _e3846)) - _e4201) > 0f) {
                                                                    let _e4206 = local_1.member[2u];
                                                                    let _e4209 = local_1.member_1[2u];
                                                                    let _e4212 = local_1.member[2u];
                                                                    let _e4218 = local_1.member_2[2u];
                                                                    if (((_e4206 + ((_e4209 - _e4212) * _e3846)) - _e4218) > 0f) {
                                                                        let _e4223 = local_1.member[3u];
                                                                        let _e4226 = local_1.member_1[3u];
                                                                        let _e4229 = local_1.member[3u];
                                                                        let _e4235 = local_1.member_2[3u];
                                                                        phi_13197_ = (((_e4223 + ((_e4226 - _e4229) * _e3846)) - _e4235) > 0f);
                                                                        phi_13198_ = false;
                                                                    } else {
                                                                        phi_13197_ = bool();
                                                                        phi_13198_ = true;
                                                                    }
                                                                    let _e4239 = phi_13197_;
                                                                    let _e4241 = phi_13198_;
                                                                    phi_13199_ = _e4239;
                                                                    phi_13200_ = _e4241;
                                                                } else {
                                                                    phi_13199_ = bool();
                                                                    phi_13200_ = true;
                                                                }
                                                                let _e4243 = phi_13199_;
                                                                let _e4245 = phi_13200_;
                                                                phi_13201_ = _e4243;
                                                                phi_13202_ = _e4245;
                                                            } else {
                                                                phi_13201_ = bool();
                                                                phi_13202_ = true;
                                                            }
                                                            let _e4247 = phi_13201_;
                                                            let _e4249 = phi_13202_;
                                                            if _e4249 {
                                                                phi_13206_ = false;
                                                            } else {
                                                                phi_13206_ = _e4247;
                                                            }
                                                            let _e4251 = phi_13206_;
                                                            if _e4251 {
                                                                if (_e3846 <= _e3848) {
                                                                    phi_13516_ = true;
                                                                } else {
                                                                    let _e4255 = local.member[0u];
                                                                    let _e4258 = local.member_1[0u];
                                                                    let _e4261 = local.member[0u];
                                                                    let _e4267 = local.member_2[0u];
                                                                    let _e4271 = local_1.member[0u];
                                                                    let _e4274 = local_1.member_1[0u];
                                                                    let _e4277 = local_1.member[0u];
                                                                    let _e4283 = local_1.member_2[0u];
                                                                    if ((((_e4255 + ((_e4258 - _e4261) * _e3846)) - _e4267) + ((_e4271 + ((_e4274 - _e4277) * _e3852)) - _e4283)) > 0f) {
                                                                        let _e4289 = local.member[1u];
                                                                        let _e4292 = local.member_1[1u];
                                                                        let _e4295 = local.member[1u];
                                                                        let _e4301 = local.member_2[1u];
                                                                        let _e4305 = local_1.member[1u];
                                                                        let _e4308 = local_1.member_1[1u];
                                                                        let _e4311 = local_1.member[1u];
                                                                        let _e4317 = local_1.member_2[1u];
                                                                        if ((((_e4289 + ((_e4292 - _e4295) * _e3846)) - _e4301) + ((_e4305 + ((_e4308 - _e4311) * _e3852)) - _e4317)) > 0f) {
                                                                            let _e4323 = local.member[2u];
                                                                            let _e4326 = local.member_1[2u];
                                                                            let _e4329 = local.member[2u];
                                                                            let _e4335 = local.member_2[2u];
                                                                            let _e4339 = local_1.member[2u];
                                                                            let _e4342 = local_1.member_1[2u];
                                                                            let _e4345 = local_1.member[2u];
                                                                            let _e4351 = local_1.member_2[2u];
                                                                            if ((((_e4323 + ((_e4326 - _e4329) * _e3846)) - _e4335) + ((_e4339 + ((_e4342 - _e4345) * _e3852)) - _e4351)) > 0f) {
                                                                                let _e4357 = local.member[3u];
                                                                                let _e4360 = local.member_1[3u];
                                                                                let _e4363 = local.member[3u];
                                                                                let _e4369 = local.member_2[3u];
                                                                                let _e4373 = local_1.member[3u];
                                                                                let _e4376 = local_1.member_1[3u];
                                                                                let _e4379 = local_1.member[3u];
                                                                                let _e4385 = local_1.member_2[3u];
                                                                                phi_13503_ = ((((_e4357 + ((_e4360 - _e4363) * _e3846)) - _e4369) + ((_e4373 + ((_e4376 - _e4379) * _e3852)) - _e4385)) > 0f);
                                                                                phi_13504_ = false;
                                                                            } else {
                                                                                phi_13503_ = bool();
                                                                                phi_13504_ = true;
                                                                            }
                                                                            let _e4390 = phi_13503_;
                                                                            let _e4392 = phi_13504_;
                                                                            phi_13505_ = _e4390;
                                                                            phi_13506_ = _e4392;
                                                                        } else {
                                                                            phi_13505_ = bool();
                                                                            phi_13506_ = true;
                                                                        }
                                                                        let _e4394 = phi_13505_;
                                                                        let _e4396 = phi_13506_;
                                                                        phi_13507_ = _e4394;
                                                                        phi_13508_ = _e4396;
                                                                    } else {
                                                                        phi_13507_ = bool();
                                                                        phi_13508_ = true;
                                                                    }
                                                                    let _e4398 = phi_13507_;
                                                                    let _e4400 = phi_13508_;
                                                                    if _e4400 {
                                                                        phi_13512_ = false;
                                                                    } else {
                                                                        phi_13512_ = _e4398;
                                                                    }
                                                                    let _e4402 = phi_13512_;
                                                                    phi_13516_ = _e4402;
                                                                }
                                                                let _e4404 = phi_13516_;
                                                                if _e4404 {
                                                                    if _e3854 {
                                                                        if (_e3846 >= _e2898.member_1) {
                                                                            phi_13527_ = false;
                                                                        } else {
                                                                            phi_13527_ = true;
                                                                        }
                                                                        let _e4407 = phi_13527_;
                                                                        phi_13528_ = _e4407;
                                                                    } else {
                                                                        phi_13528_ = true;
                                                                    }
                                                                    let _e4409 = phi_13528_;
                                                                    if _e4409 {
                                                                        local = type_32(array<f32, 4>(_e4148.member[0], _e4148.member[1], _e4148.member[2], _e4148.member[3]), array<f32, 4>(_e4148.member_1[0], _e4148.member_1[1], _e4148.member_1[2], _e4148.member_1[3]), array<f32, 4>(_e4148.member_2[0], _e4148.member_2[1], _e4148.member_2[2], _e4148.member_2[3]));
                                                                        let _e4431 = local.member[0u];
                                                                        let _e4434 = local.member_1[0u];
                                                                        let _e4437 = local.member_2[0u];
                                                                        if (_e4431 > _e4437) {
                                                                            if (_e4434 > _e4437) {
                                                                                phi_13602_ = false;
                                                                            } else {
                                                                                phi_13602_ = true;
                                                                            }
                                                                            let _e4441 = phi_13602_;
                                                                            phi_13603_ = _e4441;
                                                                        } else {
                                                                            phi_13603_ = true;
                                                                        }
                                                                        let _e4443 = phi_13603_;
                                                                        if _e4443 {
                                                                            let _e4444 = (_e4434 >= _e4431);
                                                                            if _e4444 {
                                                                                phi_13625_ = f32();
                                                                                phi_13626_ = false;
                                                                            } else {
                                                                                if ((_e4431 - _e4434) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_13623_ = (((_e4431 - _e4437) / (_e4431 - _e4434)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_13624_ = false;
                                                                                } else {
                                                                                    phi_13623_ = f32();
                                                                                    phi_13624_ = true;
                                                                                }
                                                                                let _e4455 = phi_13623_;
                                                                                let _e4457 = phi_13624_;
                                                                                phi_13625_ = _e4455;
                                                                                phi_13626_ = _e4457;
                                                                            }
                                                                            let _e4459 = phi_13625_;
                                                                            let _e4461 = phi_13626_;
                                                                            phi_13627_ = _e4459;
                                                                            phi_13628_ = _e4444;
                                                                            phi_13629_ = _e4461;
                                                                        } else {
                                                                            phi_13627_ = f32();
                                                                            phi_13628_ = true;
                                                                            phi_13629_ = false;
                                                                        }
                                                                        let _e4463 = phi_13627_;
                                                                        let _e4465 = phi_13628_;
                                                                        let _e4467 = phi_13629_;
                                                                        if _e4465 {
                                                                            phi_13633_ = 2f;
                                                                            phi_13634_ = true;
                                                                        } else {
                                                                            phi_13633_ = _e3846;
                                                                            phi_13634_ = _e4467;
                                                                        }
                                                                        let _e4469 = phi_13633_;
                                                                        let _e4471 = phi_13634_;
                                                                        if _e4471 {
                                                                            phi_13638_ = _e4469;
                                                                        } else {
                                                                            phi_13638_ = _e4463;
                                                                        }
                                                                        let _e4473 = phi_13638_;
                                                                        let _e4476 = local.member[1u];
                                                                        let _e4479 = local.member_1[1u];
                                                                        let _e4482 = local.member_2[1u];
                                                                        if (_e4476 > _e4482) {
                                                                            if (_e4479 > _e4482) {
                                                                                phi_13670_ = false;
                                                                            } else {
                                                                                phi_13670_ = true;
                                                                            }
                                                                            let _e4486 = phi_13670_;
                                                                            phi_13671_ = _e4486;
                                                                        } else {
                                                                            phi_13671_ = true;
                                                                        }
                                                                        let _e4488 = phi_13671_;
                                                                        if _e4488 {
                                                                            let _e4489 = (_e4479 >= _e4476);
                                                                            if _e4489 {
                                                                                phi_13693_ = f32();
                                                                                phi_13694_ = false;
                                                                            } else {
                                                                                if ((_e4476 - _e4479) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_13691_ = (((_e4476 - _e4482) / (_e4476 - _e4479)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_13692_ = false;
                                                                                } else {
                                                                                    phi_13691_ = f32();
                                                                                    phi_13692_ = true;
                                                                                }
                                                                                let _e4500 = phi_13691_;
                                                                                let _e4502 = phi_13692_;
                                                                                phi_13693_ = _e4500;
                                                                                phi_13694_ = _e4502;
                                                                            }
                                                                            let _e4504 = phi_13693_;
                                                                            let _e4506 = phi_13694_;
                                                                            phi_13695_ = _e4504;
                                                                            phi_13696_ = _e4489;
                                                                            phi_13697_ = _e4506;
                                                                        } else {
                                                                            phi_13695_ = f32();
                                                                            phi_13696_ = true;
                                                                            phi_13697_ = false;
                                                                        }
                                                                        let _e4508 = phi_13695_;
                                                                        let _e4510 = phi_13696_;
                                                                        let _e4512 = phi_13697_;
                                                                        if _e4510 {
                                                                            phi_13701_ = 2f;
                                                                            phi_13702_ = true;
                                                                        } else {
                                                                            phi_13701_ = _e3846;
                                                                            phi_13702_ = _e4512;
                                                                        }
                                                                        let _e4514 = phi_13701_;
                                                                        let _e4516 = phi_13702_;
                                                                        if _e4516 {
                                                                            phi_13706_ = _e4514;
                                                                        } else {
                                                                            phi_13706_ = _e4508;
                                                                        }
                                                                        let _e4518 = phi_13706_;
                                                                        if (_e4473 < _e4518) {
                                                                            phi_13711_ = _e4473;
                                                                        } else {
                                                                            phi_13711_ = _e4518;
                                                                        }
                                                                        let _e4521 = phi_13711_;
                                                                        let _e4524 = local.member[2u];
                                                                        let _e4527 = local.member_1[2u];
                                                                        let _e4530 = local.member_2[2u];
                                                                        if (_e4524 > _e4530) {
                                                                            if (_e4527 > _e4530) {
                                                                                phi_13743_ = false;
                                                                            } else {
                                                                                phi_13743_ = true;
                                                                            }
                                                                            let _e4534 = phi_13743_;
                                                                            phi_13744_ = _e4534;
                                                                        } else {
                                                                            phi_13744_ = true;
                                                                        }
                                                                        let _e4536 = phi_13744_;
                                                                        if _e4536 {
                                                                            let _e4537 = (_e4527 >= _e4524);
                                                                            if _e4537 {
                                                                                phi_13766_ = f32();
                                                                                phi_13767_ = false;
                                                                            } else {
                                                                                if ((_e4524 - _e4527) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_13764_ = (((_e4524 - _e4530) / (_e4524 - _e4527)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_13765_ = false;
                                                                                } else {
                                                                                    phi_13764_ = f32();
                                                                                    phi_13765_ = true;
                                                                                }
                                                                                let _e4548 = phi_13764_;
                                                                                let _e4550 = phi_13765_;
                                                                                phi_13766_ = _e4548;
                                                                                phi_13767_ = _e4550;
                                                                            }
                                                                            let _e4552 = phi_13766_;
                                                                            let _e4554 = phi_13767_;
                                                                            phi_13768_ = _e4552;
                                                                            phi_13769_ = _e4537;
                                                                            phi_13770_ = _e4554;
                                                                        } else {
                                                                            phi_13768_ = f32();
                                                                            phi_13769_ = true;
                                                                            phi_13770_ = false;
                                                                        }
                                                                        let _e4556 = phi_13768_;
                                                                        let _e4558 = phi_13769_;
                                                                        let _e4560 = phi_13770_;
                                                                        if _e4558 {
                                                                            phi_13774_ = 2f;
                                                                            phi_13775_ = true;
                                                                        } else {
                                                                            phi_13774_ = _e3846;
                                                                            phi_13775_ = _e4560;
                                                                        }
                                                                        let _e4562 = phi_13774_;
                                                                        let _e4564 = phi_13775_;
                                                                        if _e4564 {
                                                                            phi_13779_ = _e4562;
                                                                        } else {
                                                                            phi_13779_ = _e4556;
                                                                        }
                                                                        let _e4566 = phi_13779_;
                                                                        let _e4569 = local.member[3u];
                                                                        let _e4572 = local.member_1[3u];
                                                                        let _e4575 = local.member_2[3u];
                                                                        if (_e4569 > _e4575) {
                                                                            if (_e4572 > _e4575) {
                                                                                phi_13811_ = false;
                                                                            } else {
                                                                                phi_13811_ = true;
                                                                            }
                                                                            let _e4579 = phi_13811_;
                                                                            phi_13812_ = _e4579;
                                                                        } else {
                                                                            phi_13812_ = true;
                                                                        }
                                                                        let _e4581 = phi_13812_;
                                                                        if _e4581 {
                                                                            let _e4582 = (_e4572 >= _e4569);
                                                                            if _e4582 {
                                                                                phi_13834_ = f32();
                                                                                phi_13835_ = false;
                                                                            } else {
                                                                                if ((_e4569 - _e4572) <= (0.25f / 0.000000000000000000000000000000000000011754944f)) {
                                                                                    phi_13832_ = (((_e4569 - _e4575) / (_e4569 - _e4572)) * (1f - (0.000000059604645f * 16f)));
                                                                                    phi_13833_ = false;
                                                                                } else {
                                                                                    phi_13832_ = f32();
                                                                                    phi_13833_ = true;
                                                                                }
                                                                                let _e4593 = phi_13832_;
                                                                                let _e4595 = phi_13833_;
                                                                                phi_13834_ = _e4593;
                                                                                phi_13835_ = _e4595;
                                                                            }
                                                                            let _e4597 = phi_13834_;
                                                                            let _e4599 = phi_13835_;
                                                                            phi_13836_ = _e4597;
                                                                            phi_13837_ = _e4582;
                                                                            phi_13838_ = _e4599;
                                                                        } else {
                                                                            phi_13836_ = f32();
                                                                            phi_13837_ = true;
                                                                            phi_13838_ = false;
                                                                        }
                                                                        let _e4601 = phi_13836_;
                                                                        let _e4603 = phi_13837_;
                                                                        let _e4605 = phi_13838_;
                                                                        if _e4603 {
                                                                            phi_13842_ = 2f;
                                                                            phi_13843_ = true;
                                                                        } else {
                                                                            phi_13842_ = _e3846;
                                                                            phi_13843_ = _e4605;
                                                                        }
                                                                        let _e4607 = phi_13842_;
                                                                        let _e4609 = phi_13843_;
                                                                        if _e4609 {
                                                                            phi_13847_ = _e4607;
                                                                        } else {
                                                                            phi_13847_ = _e4601;
                                                                        }
                                                                        let _e4611 = phi_13847_;
                                                                        if (_e4566 < _e4611) {
                                                                            phi_13852_ = _e4566;
                                                                        } else {
                                                                            phi_13852_ = _e4611;
                                                                        }
                                                                        let _e4614 = phi_13852_;
                                                                        if (_e4521 < _e4614) {
                                                                            phi_13857_ = _e4521;
                                                                        } else {
                                                                            phi_13857_ = _e4614;
                                                                        }
                                                                        let _e4617 = phi_13857_;
                                                                        if (_e4617 > _e3846) {
                                                                            phi_13862_ = _e4617;
                                                                        } else {
                                                                            phi_13862_ = _e3846;
                                                                        }
                                                                        let _e4620 = phi_13862_;
                                                                        let _e4621 = (_e4620 > _e2898.member_1);
                                                                        if _e4621 {
                                                                            phi_14367_ = f32();
                                                                            phi_14368_ = f32();
                                                                            phi_14369_ = false;
                                                                        } else {
                                                                            let _e4622 = (_e4620 - _e3846);
                                                                            if _e3854 {
                                                                                if (_e4622 <= _e3841) {
                                                                                    phi_14357_ = true;
                                                                                } else {
                                                                                    if (_e4622 <= (_e3850 * 0.25f)) {
                                                                                        phi_14356_ = false;
                                                                                    } else {
                                                                                        phi_14356_ = true;
                                                                                    }
                                                                                    let _e4628 = phi_14356_;
                                                                                    phi_14357_ = _e4628;
                                                                                }
                                                                                let _e4630 = phi_14357_;
                                                                                if _e4630 {
                                                                                    phi_14362_ = (_e4168 + _e4168);
                                                                                } else {
                                                                                    phi_14362_ = 0f;
                                                                                }
                                                                                let _e4633 = phi_14362_;
                                                                                phi_14364_ = _e4633;
                                                                            } else {
                                                                                phi_14364_ = (_e2898.member_1 - _e3846);
                                                                            }
                                                                            let _e4635 = phi_14364_;
                                                                            phi_14367_ = _e4635;
                                                                            phi_14368_ = _e4622;
                                                                            phi_14369_ = true;
                                                                        }
                                                                        let _e4637 = phi_14367_;
                                                                        let _e4639 = phi_14368_;
                                                                        let _e4641 = phi_14369_;
                                                                        phi_14371_ = _e4620;
                                                                        phi_14372_ = _e4637;
                                                                        phi_14373_ = _e4639;
                                                                        phi_14375_ = _e4641;
                                                                        phi_14376_ = _e4621;
                                                                        phi_14378_ = false;
                                                                    } else {
                                                                        phi_14371_ = f32();
                                                                        phi_14372_ = f32();
                                                                        phi_14373_ = f32();
                                                                        phi_14375_ = false;
                                                                        phi_14376_ = false;
                                                                        phi_14378_ = true;
                                                                    }
                                                                    let _e4643 = phi_14371_;
                                                                    let _e4645 = phi_14372_;
                                                                    let _e4647 = phi_14373_;
                                                                    let _e4649 = phi_14375_;
                                                                    let _e4651 = phi_14376_;
                                                                    let _e4653 = phi_14378_;
                                                                    phi_14379_ = _e4643;
                                                                    phi_14380_ = _e4645;
                                                                    phi_14381_ = _e4647;
                                                                    phi_14383_ = false;
                                                                    phi_14384_ = _e4649;
                                                                    phi_14385_ = _e4651;
                                                                    phi_14387_ = _e4653;
                                                                } else {
                                                                    phi_14379_ = f32();
                                                                    phi_14380_ = f32();
                                                                    phi_14381_ = f32();
                                                                    phi_14383_ = true;
                                                                    phi_14384_ = false;
                                                                    phi_14385_ = false;
                                                                    phi_14387_ = false;
                                                                }
                                                                let _e4655 = phi_14379_;
                                                                let _e4657 = phi_14380_;
                                                                let _e4659 = phi_14381_;
                                                                let _e4661 = phi_14383_;
                                                                let _e4663 = phi_14384_;
                                                                let _e4665 = phi_14385_;
                                                                let _e4667 = phi_14387_;
                                                                phi_14388_ = _e4655;
                                                                phi_14389_ = _e4657;
                                                                phi_14390_ = _e4659;
                                                                phi_14392_ = _e4661;
                                                                phi_14393_ = _e4663;
                                                                phi_14394_ = _e4665;
                                                                phi_14396_ = _e4667;
                                                            } else {
                                                                phi_14388_ = f32();
                                                                phi_14389_ = f32();
                                                                phi_14390_ = f32();
                                                                phi_14392_ = true;
                                                                phi_14393_ = false;
                                                                phi_14394_ = false;
                                                                phi_14396_ = false;
                                                            }
                                                            let _e4669 = phi_14388_;
                                                            let _e4671 = phi_14389_;
                                                            let _e4673 = phi_14390_;
                                                            let _e4675 = phi_14392_;
                                                            let _e4677 = phi_14393_;
                                                            let _e4679 = phi_14394_;
                                                            let _e4681 = phi_14396_;
                                                            if _e4675 {
                                                                if (_e3846 <= _e3848) {
                                                                    let _e4842 = (_e3856 + 1u);
                                                                    let _e4843 = (_e4842 > 3u);
                                                                    if _e4843 {
                                                                        phi_14409_ = false;
                                                                    } else {
                                                                        phi_14409_ = true;
                                                                    }
                                                                    let _e4845 = phi_14409_;
                                                                    phi_14731_ = _e4842;
                                                                    phi_14732_ = f32();
                                                                    phi_14733_ = false;
                                                                    phi_14734_ = _e4845;
                                                                    phi_14735_ = _e4843;
                                                                } else {
                                                                    let _e4685 = local.member[0u];
                                                                    let _e4688 = local.member_1[0u];
                                                                    let _e4691 = local.member[0u];
                                                                    let _e4697 = local.member_2[0u];
                                                                    let _e4698 = ((_e4685 + ((_e4688 - _e4691) * _e3852)) - _e4697);
                                                                    let _e4701 = local.member[1u];
                                                                    let _e4704 = local.member_1[1u];
                                                                    let _e4707 = local.member[1u];
                                                                    let _e4713 = local.member_2[1u];
                                                                    let _e4714 = ((_e4701 + ((_e4704 - _e4707) * _e3852)) - _e4713);
                                                                    if (_e4698 < _e4714) {
                                                                        phi_14482_ = _e4698;
                                                                    } else {
                                                                        phi_14482_ = _e4714;
                                                                    }
                                                                    let _e4717 = phi_14482_;
                                                                    let _e4720 = local.member[2u];
                                                                    let _e4723 = local.member_1[2u];
                                                                    let _e4726 = local.member[2u];
                                                                    let _e4732 = local.member_2[2u];
                                                                    let _e4733 = ((_e4720 + ((_e4723 - _e4726) * _e3852)) - _e4732);
                                                                    let _e4736 = local.member[3u];
                                                                    let _e4739 = local.member_1[3u];
                                                                    let _e4742 = local.member[3u];
                                                                    let _e4748 = local.member_2[3u];
                                                                    let _e4749 = ((_e4736 + ((_e4739 - _e4742) * _e3852)) - _e4748);
                                                                    if (_e4733 < _e4749) {
                                                                        phi_14555_ = _e4733;
                                                                    } else {
                                                                        phi_14555_ = _e4749;
                                                                    }
                                                                    let _e4752 = phi_14555_;
                                                                    if (_e4717 < _e4752) {
                                                                        phi_14560_ = _e4717;
                                                                    } else {
                                                                        phi_14560_ = _e4752;
                                                                    }
                                                                    let _e4755 = phi_14560_;
                                                                    let _e4758 = local_1.member[0u];
                                                                    let _e4761 = local_1.member_1[0u];
                                                                    let _e4764 = local_1.member[0u];
                                                                    let _e4770 = local_1.member_2[0u];
                                                                    let _e4771 = ((_e4758 + ((_e4761 - _e4764) * _e3846)) - _e4770);
                                                                    let _e4774 = local_1.member[1u];
                                                                    let _e4777 = local_1.member_1[1u];
                                                                    let _e4780 = local_1.member[1u];
                                                                    let _e4786 = local_1.member_2[1u];
                                                                    let _e4787 = ((_e4774 + ((_e4777 - _e4780) * _e3846)) - _e4786);
                                                                    if (_e4771 < _e4787) {
                                                                        phi_14633_ = _e4771;
                                                                    } else {
                                                                        phi_14633_ = _e4787;
                                                                    }
                                                                    let _e4790 = phi_14633_;
                                                                    let _e4793 = local_1.member[2u];
                                                                    let _e4796 = local_1.member_1[2u];
                                                                    let _e4799 = local_1.member[2u];
                                                                    let _e4805 = local_1.member_2[2u];
                                                                    let _e4806 = ((_e4793 + ((_e4796 - _e4799) * _e3846)) - _e4805);
                                                                    let _e4809 = local_1.member[3u];
                                                                    let _e4812 = local_1.member_1[3u];
                                                                    let _e4815 = local_1.member[3u];
                                                                    let _e4821 = local_1.member_2[3u];
                                                                    let _e4822 = ((_e4809 + ((_e4812 - _e4815) * _e3846)) - _e4821);
                                                                    if (_e4806 < _e4822) {
                                                                        phi_14706_ = _e4806;
                                                                    } else {
                                                                        phi_14706_ = _e4822;
                                                                    }
                                                                    let _e4825 = phi_14706_;
                                                                    if (_e4790 < _e4825) {
                                                                        phi_14711_ = _e4790;
                                                                    } else {
                                                                        phi_14711_ = _e4825;
                                                                    }
                                                                    let _e4828 = phi_14711_;
                                                                    if (_e4828 > 0f) {
                                                                        phi_14729_ = 0.5f;
                                                                    } else {
                                                                        let _e4832 = (0.95f * (_e4755 / (_e4755 - _e4828)));
                                                                        if (_e4832 > 0.0625f) {
                                                                            if (_e4832 < 0.9f) {
                                                                                phi_14727_ = _e4832;
                                                                            } else {
                                                                                phi_14727_ = 0.9f;
                                                                            }
                                                                            let _e4836 = phi_14727_;
                                                                            phi_14728_ = _e4836;
                                                                        } else {
                                                                            phi_14728_ = 0.0625f;
                                                                        }
                                                                        let _e4838 = phi_14728_;
                                                                        phi_14729_ = _e4838;
                                                                    }
                                                                    let _e4840 = phi_14729_;
                                                                    phi_14731_ = u32();
                                                                    phi_14732_ = (_e4168 * _e4840);
                                                                    phi_14733_ = true;
                                                                    phi_14734_ = false;
                                                                    phi_14735_ = false;
                                                                }
                                                                let _e4847 = phi_14731_;
                                                                let _e4849 = phi_14732_;
                                                                let _e4851 = phi_14733_;
                                                                let _e4853 = phi_14734_;
                                                                let _e4855 = phi_14735_;
                                                                phi_14736_ = _e4847;
                                                                phi_14737_ = _e3848;
                                                                phi_14738_ = _e4849;
                                                                phi_14739_ = _e3850;
                                                                phi_14740_ = _e3852;
                                                                phi_14741_ = _e3854;
                                                                phi_14742_ = _e3856;
                                                                phi_14743_ = _e4851;
                                                                phi_14744_ = _e4853;
                                                                phi_14745_ = _e4855;
                                                                phi_14746_ = false;
                                                                phi_14748_ = false;
                                                            } else {
                                                                phi_14736_ = u32();
                                                                phi_14737_ = _e4669;
                                                                phi_14738_ = _e4671;
                                                                phi_14739_ = _e4673;
                                                                phi_14740_ = _e3846;
                                                                phi_14741_ = true;
                                                                phi_14742_ = 0u;
                                                                phi_14743_ = _e4677;
                                                                phi_14744_ = false;
                                                                phi_14745_ = false;
                                                                phi_14746_ = _e4679;
                                                                phi_14748_ = _e4681;
                                                            }
                                                            let _e4857 = phi_14736_;
                                                            let _e4859 = phi_14737_;
                                                            let _e4861 = phi_14738_;
                                                            let _e4863 = phi_14739_;
                                                            let _e4865 = phi_14740_;
                                                            let _e4867 = phi_14741_;
                                                            let _e4869 = phi_14742_;
                                                            let _e4871 = phi_14743_;
                                                            let _e4873 = phi_14744_;
                                                            let _e4875 = phi_14745_;
                                                            let _e4877 = phi_14746_;
                                                            let _e4879 = phi_14748_;
                                                            if _e4871 {
                                                                let _e4880 = (_e4865 + _e4861);
                                                                if (_e4880 > _e4859) {
                                                                    phi_14757_ = _e4880;
                                                                } else {
                                                                    phi_14757_ = _e4859;
                                                                }
                                                                let _e4883 = phi_14757_;
                                                                if (_e4883 < _e2898.member_1) {
                                                                    phi_14762_ = _e4883;
                                                                } else {
                                                                    phi_14762_ = _e2898.member_1;
                                                                }
                                                                let _e4886 = phi_14762_;
                                                                if !(_e3854) {
                                                                    phi_14771_ = true;
                                                                } else {
                                                                    phi_14771_ = ((_e4886 - _e4865) > _e3841);
                                                                }
                                                                let _e4890 = phi_14771_;
                                                                if _e4890 {
                                                                    phi_14775_ = false;
                                                                } else {
                                                                    phi_14775_ = true;
                                                                }
                                                                let _e4892 = phi_14775_;
                                                                phi_14776_ = _e4886;
                                                                phi_14777_ = _e4859;
                                                                phi_14778_ = _e4863;
                                                                phi_14779_ = _e4865;
                                                                phi_14780_ = _e4867;
                                                                phi_14781_ = _e4869;
                                                                phi_14782_ = _e4890;
                                                                phi_14783_ = _e4892;
                                                                phi_14784_ = false;
                                                                phi_14785_ = false;
                                                                phi_14787_ = false;
                                                            } else {
                                                                phi_14776_ = _e3846;
                                                                phi_14777_ = _e3848;
                                                                phi_14778_ = _e3850;
                                                                phi_14779_ = _e3852;
                                                                phi_14780_ = _e3854;
                                                                phi_14781_ = _e4857;
                                                                phi_14782_ = _e4873;
                                                                phi_14783_ = false;
                                                                phi_14784_ = _e4875;
                                                                phi_14785_ = _e4877;
                                                                phi_14787_ = _e4879;
                                                            }
                                                            let _e4894 = phi_14776_;
                                                            let _e4896 = phi_14777_;
                                                            let _e4898 = phi_14778_;
                                                            let _e4900 = phi_14779_;
                                                            let _e4902 = phi_14780_;
                                                            let _e4904 = phi_14781_;
                                                            let _e4906 = phi_14782_;
                                                            let _e4908 = phi_14783_;
                                                            let _e4910 = phi_14784_;
                                                            let _e4912 = phi_14785_;
                                                            let _e4914 = phi_14787_;
                                                            phi_12609_ = _e4894;
                                                            phi_12611_ = _e4896;
                                                            phi_12613_ = _e4898;
                                                            phi_12615_ = _e4900;
                                                            phi_12617_ = _e4902;
                                                            phi_12619_ = _e4904;
                                                            phi_14788_ = _e4859;
                                                            phi_14790_ = _e4906;
                                                            phi_14791_ = _e4908;
                                                            phi_14792_ = _e4910;
                                                            phi_14793_ = _e4912;
                                                            phi_14795_ = false;
                                                            phi_14796_ = _e4914;
                                                        } else {
                                                            phi_12609_ = f32();
                                                            phi_12611_ = f32();
                                                            phi_12613_ = f32();
                                                            phi_12615_ = f32();
                                                            phi_12617_ = bool();
                                                            phi_12619_ = u32();
                                                            phi_14788_ = f32();
                                                            phi_14790_ = false;
                                                            phi_14791_ = false;
                                                            phi_14792_ = false;
                                                            phi_14793_ = false;
                                                            phi_14795_ = true;
                                                            phi_14796_ = false;
                                                        }
                                                        let _e4916 = phi_12609_;
                                                        let _e4918 = phi_12611_;
                                                        let _e4920 = phi_12613_;
                                                        let _e4922 = phi_12615_;
                                                        let _e4924 = phi_12617_;
                                                        let _e4926 = phi_12619_;
                                                        let _e4928 = phi_14788_;
                                                        let _e4930 = phi_14790_;
                                                        let _e4932 = phi_14791_;
                                                        let _e4934 = phi_14792_;
                                                        let _e4936 = phi_14793_;
                                                        let _e4938 = phi_14795_;
                                                        let _e4940 = phi_14796_;
                                                        local_29 = _e4932;
                                                        local_69 = _e4934;
                                                        local_70 = _e4936;
                                                        local_71 = _e4938;
                                                        local_72 = _e4940;
                                                        local_73 = _e4932;
                                                        local_74 = _e4928;
                                                        continue;
                                                        continuing {
                                                            phi_12605_ = _e3868;
                                                            phi_12608_ = _e4916;
                                                            phi_12610_ = _e4918;
                                                            phi_12612_ = _e4920;
                                                            phi_12614_ = _e4922;
                                                            phi_12616_ = _e4924;
                                                            phi_12618_ = _e4926;
                                                            break if !(_e4930);
                                                        }
                                                    }
                                                    let _e4943 = local_29;
                                                    if _e4943 {
                                                        phi_14800_ = false;
                                                        phi_14801_ = false;
                                                        phi_14803_ = false;
                                                        phi_14804_ = false;
                                                    } else {
                                                        let _e10591 = local_69;
                                                        phi_14800_ = _e10591;
                                                        let _e10594 = local_70;
                                                        phi_14801_ = _e10594;
                                                        let _e10597 = local_71;
                                                        phi_14803_ = _e10597;
                                                        let _e10600 = local_72;
                                                        phi_14804_ = _e10600;
                                                    }
                                                    let _e4945 = phi_14800_;
                                                    let _e4947 = phi_14801_;
                                                    let _e4949 = phi_14803_;
                                                    let _e4951 = phi_14804_;
                                                    if _e4945 {
                                                        let _e4953 = local_30;
                                                        phi_14809_ = type_30(1u, _e4953);
                                                        phi_14810_ = false;
                                                        phi_14812_ = false;
                                                        phi_14813_ = false;
                                                        phi_14814_ = false;
                                                    } else {
                                                        phi_14809_ = type_30();
                                                        phi_14810_ = _e4947;
                                                        let _e10606 = local_73;
                                                        phi_14812_ = _e10606;
                                                        phi_14813_ = _e4949;
                                                        phi_14814_ = _e4951;
                                                    }
                                                    let _e4956 = phi_14809_;
                                                    let _e4958 = phi_14810_;
                                                    let _e4960 = phi_14812_;
                                                    let _e4962 = phi_14813_;
                                                    let _e4964 = phi_14814_;
                                                    if _e4958 {
                                                        phi_14819_ = type_30(0u, type_30().member_1);
                                                        phi_14821_ = false;
                                                        phi_14822_ = false;
                                                        phi_14823_ = false;
                                                        phi_14824_ = true;
                                                    } else {
                                                        phi_14819_ = _e4956;
                                                        phi_14821_ = _e4960;
                                                        phi_14822_ = _e4962;
                                                        phi_14823_ = _e4964;
                                                        phi_14824_ = _e4945;
                                                    }
                                                    let _e4968 = phi_14819_;
                                                    let _e4970 = phi_14821_;
                                                    let _e4972 = phi_14822_;
                                                    let _e4974 = phi_14823_;
                                                    let _e4976 = phi_14824_;
                                                    if _e4970 {
                                                        let _e10616 = local_74;
                                                        phi_14836_ = _e10616;
                                                        phi_14837_ = true;
                                                        phi_14838_ = false;
                                                        phi_14839_ = false;
                                                    } else {
                                                        let _e10618 = local_75;
                                                        phi_14836_ = _e10618;
                                                        phi_14837_ = _e4972;
                                                        phi_14838_ = _e4974;
                                                        phi_14839_ = _e4976;
                                                    }
                                                    let _e4978 = phi_14836_;
                                                    let _e4980 = phi_14837_;
                                                    let _e4982 = phi_14838_;
                                                    let _e4984 = phi_14839_;
                                                    if _e4980 {
                                                        phi_14844_ = type_30(1u, _e4978);
                                                        phi_14845_ = false;
                                                        phi_14846_ = false;
                                                    } else {
                                                        phi_14844_ = type_30();
                                                        phi_14845_ = _e4982;
                                                        phi_14846_ = _e4984;
                                                    }
                                                    let _e4987 = phi_14844_;
                                                    let _e4989 = phi_14845_;
                                                    let _e4991 = phi_14846_;
                                                    if _e4989 {
                                                        phi_14851_ = type_30(0u, type_30().member_1);
                                                        phi_14852_ = true;
                                                    } else {
                                                        phi_14851_ = _e4968;
                                                        phi_14852_ = _e4991;
                                                    }
                                                    let _e4995 = phi_14851_;
                                                    let _e4997 = phi_14852_;
                                                    if _e4997 {
                                                        phi_14856_ = _e4995;
                                                    } else {
                                                        phi_14856_ = _e4987;
                                                    }
                                                    let _e4999 = phi_14856_;
                                                    let _e5002 = (_e4999.member != 0u);
                                                    if _e5002 {
                                                        phi_14863_ = false;
                                                    } else {
                                                        phi_14863_ = true;
                                                    }
                                                    let _e5004 = phi_14863_;
                                                    phi_14864_ = _e4999.member_1;
                                                    phi_14865_ = _e5004;
                                                    phi_14866_ = _e5002;
                                                    phi_14867_ = false;
                                                } else {
                                                    phi_14864_ = f32();
                                                    phi_14865_ = false;
                                                    phi_14866_ = false;
                                                    phi_14867_ = true;
                                                }
                                                let _e5006 = phi_14864_;
                                                let _e5008 = phi_14865_;
                                                let _e5010 = phi_14866_;
                                                let _e5012 = phi_14867_;
                                                phi_14868_ = _e3603;
                                                phi_14869_ = _e3604;
                                                phi_14870_ = _e5006;
                                                phi_14871_ = _e5008;
                                                phi_14872_ = _e5010;
                                                phi_14873_ = _e5012;
                                            }
                                            let _e5014 = phi_14868_;
                                            let _e5016 = phi_14869_;
                                            let _e5018 = phi_14870_;
                                            let _e5020 = phi_14871_;
                                            let _e5022 = phi_14872_;
                                            let _e5024 = phi_14873_;
                                            phi_14874_ = _e5014;
                                            phi_14875_ = _e5016;
                                            phi_14876_ = _e5018;
                                            phi_14877_ = _e3599;
                                            phi_14878_ = _e5020;
                                            phi_14879_ = _e5022;
                                            phi_14880_ = _e5024;
                                        }
                                        let _e5026 = phi_14874_;
                                        let _e5028 = phi_14875_;
                                        let _e5030 = phi_14876_;
                                        let _e5032 = phi_14877_;
                                        let _e5034 = phi_14878_;
                                        let _e5036 = phi_14879_;
                                        let _e5038 = phi_14880_;
                                        if _e5032 {
                                            phi_14884_ = false;
                                            phi_14885_ = false;
                                            phi_14886_ = false;
                                        } else {
                                            phi_14884_ = _e5034;
                                            phi_14885_ = _e5036;
                                            phi_14886_ = _e5038;
                                        }
                                        let _e5040 = phi_14884_;
                                        let _e5042 = phi_14885_;
                                        let _e5044 = phi_14886_;
                                        phi_14887_ = _e2898;
                                        phi_14888_ = _e5026;
                                        phi_14889_ = _e5028;
                                        phi_14890_ = _e5030;
                                        phi_14891_ = _e2898;
                                        phi_14892_ = _e5032;
                                        phi_14893_ = _e5040;
                                        phi_14894_ = _e5042;
                                        phi_14895_ = _e5044;
                                    } else {
                                        phi_14887_ = type_41();
                                        phi_14888_ = bool();
                                        phi_14889_ = f32();
                                        phi_14890_ = f32();
                                        phi_14891_ = type_41();
                                        phi_14892_ = true;
                                        phi_14893_ = false;
                                        phi_14894_ = false;
                                        phi_14895_ = false;
                                    }
                                    let _e5046 = phi_14887_;
                                    let _e5048 = phi_14888_;
                                    let _e5050 = phi_14889_;
                                    let _e5052 = phi_14890_;
                                    let _e5054 = phi_14891_;
                                    let _e5056 = phi_14892_;
                                    let _e5058 = phi_14893_;
                                    let _e5060 = phi_14894_;
                                    let _e5062 = phi_14895_;
                                    if _e5056 {
                                        phi_14899_ = true;
                                        phi_14900_ = false;
                                        phi_14901_ = false;
                                    } else {
                                        phi_14899_ = _e5058;
                                        phi_14900_ = _e5060;
                                        phi_14901_ = _e5062;
                                    }
                                    let _e5064 = phi_14899_;
                                    let _e5066 = phi_14900_;
                                    let _e5068 = phi_14901_;
                                    phi_14902_ = _e5046;
                                    phi_14903_ = _e5048;
                                    phi_14904_ = _e5050;
                                    phi_14905_ = _e5052;
                                    phi_14906_ = _e5054;
                                    phi_14907_ = _e5064;
                                    phi_14908_ = false;
                                    phi_14909_ = _e5066;
                                    phi_14910_ = _e5068;
                                } else {
                                    phi_14902_ = type_41();
                                    phi_14903_ = bool();
                                    phi_14904_ = f32();
                                    phi_14905_ = f32();
                                    phi_14906_ = type_41();
                                    phi_14907_ = false;
                                    phi_14908_ = true;
                                    phi_14909_ = false;
                                    phi_14910_ = false;
                                }
                                let _e5070 = phi_14902_;
                                let _e5072 = phi_14903_;
                                let _e5074 = phi_14904_;
                                let _e5076 = phi_14905_;
                                let _e5078 = phi_14906_;
                                let _e5080 = phi_14907_;
                                let _e5082 = phi_14908_;
                                let _e5084 = phi_14909_;
                                let _e5086 = phi_14910_;
                                local_31 = _e5082;
                                local_76 = _e5084;
                                local_77 = _e5086;
                                local_32 = _e5072;
                                local_33 = _e5070;
                                local_34 = _e5076;
                                local_35 = _e5074;
                                local_36 = _e5076;
                                local_37 = _e5076;
                                local_38 = _e5078;
                                continue;
                                continuing {
                                    phi_10713_ = _e2621;
                                    break if !(_e5080);
                                }
                            }
                            let _e5089 = local_31;
                            if _e5089 {
                                phi_14915_ = type_30(0u, type_30().member_1);
                                phi_14916_ = false;
                                phi_14917_ = false;
                            } else {
                                phi_14915_ = type_30();
                                let _e10674 = local_76;
                                phi_14916_ = _e10674;
                                let _e10677 = local_77;
                                phi_14917_ = _e10677;
                            }
                            let _e5093 = phi_14915_;
                            let _e5095 = phi_14916_;
                            let _e5097 = phi_14917_;
                            if _e5095 {
                                let _e5099 = local_32;
                                if _e5099 {
                                    let _e5101 = local_33;
                                    let _e5104 = local_34;
                                    let _e5107 = local_35;
                                    if ((_e5101.member_1 - _e5104) <= _e5107) {
                                        let _e5110 = local_36;
                                        phi_14931_ = type_30(1u, _e5110);
                                        phi_14932_ = false;
                                    } else {
                                        phi_14931_ = type_30();
                                        phi_14932_ = true;
                                    }
                                    let _e5113 = phi_14931_;
                                    let _e5115 = phi_14932_;
                                    phi_14933_ = _e5113;
                                    phi_14934_ = _e5115;
                                } else {
                                    phi_14933_ = type_30();
                                    phi_14934_ = true;
                                }
                                let _e5117 = phi_14933_;
                                let _e5119 = phi_14934_;
                                if _e5119 {
                                    let _e5121 = local_37;
                                    phi_14939_ = type_30(2u, _e5121);
                                } else {
                                    phi_14939_ = _e5117;
                                }
                                let _e5124 = phi_14939_;
                                phi_14940_ = _e5124;
                                phi_14941_ = false;
                            } else {
                                phi_14940_ = type_30();
                                phi_14941_ = _e5097;
                            }
                            let _e5126 = phi_14940_;
                            let _e5128 = phi_14941_;
                            if _e5128 {
                                let _e5130 = local_38;
                                phi_14947_ = type_30(1u, _e5130.member);
                                phi_14948_ = true;
                            } else {
                                phi_14947_ = _e5126;
                                phi_14948_ = _e5095;
                            }
                            let _e5134 = phi_14947_;
                            let _e5136 = phi_14948_;
                            phi_14952_ = _e5134;
                            phi_14953_ = _e5093;
                            phi_14954_ = _e5136;
                        } else {
                            phi_14952_ = _e2467;
                            phi_14953_ = type_30();
                            phi_14954_ = true;
                        }
                        let _e5138 = phi_14952_;
                        let _e5140 = phi_14953_;
                        let _e5142 = phi_14954_;
                        phi_14958_ = _e5138;
                        phi_14959_ = _e5140;
                        phi_14960_ = _e5142;
                    }
                    let _e5146 = phi_14958_;
                    let _e5148 = phi_14959_;
                    let _e5150 = phi_14960_;
                    if _e5150 {
                        phi_14964_ = _e5146;
                    } else {
                        phi_14964_ = _e5148;
                    }
                    let _e5152 = phi_14964_;
                    if (_e5152.member == 1u) {
                        if (_e5152.member_1 > _e283) {
                            phi_14975_ = false;
                        } else {
                            phi_14975_ = true;
                        }
                        let _e5158 = phi_14975_;
                        phi_14976_ = _e5158;
                    } else {
                        phi_14976_ = true;
                    }
                    let _e5160 = phi_14976_;
                    if _e5160 {
                        phi_14980_ = false;
                    } else {
                        phi_14980_ = true;
                    }
                    let _e5162 = phi_14980_;
                    if _e5162 {
                        phi_14984_ = 1u;
                    } else {
                        phi_14984_ = 0u;
                    }
                    let _e5164 = phi_14984_;
                    phi_14988_ = type_39(_e5152, _e5164);
                }
                let _e9669 = phi_14988_;
                switch bitcast<i32>(_e9669.member.member) {
                    case 0: {
                        phi_15003_ = type_42(0u, _e9669.member_1, array<u32, 2>(0u, 0u), false);
                        break;
                    }
                    case 1: {
                        let _e9680 = function_(_e9669.member.member_1);
                        phi_15003_ = type_42(0u, _e9669.member_1, _e9680, true);
                        break;
                    }
                    case 2: {
                        let _e9676 = function_(_e9669.member.member_1);
                        phi_15003_ = type_42(1u, _e9669.member_1, _e9676, true);
                        break;
                    }
                    default: {
                        phi_15003_ = type_42();
                        break;
                    }
                }
                let _e9684 = phi_15003_;
                let _e9688 = params.member.member.member_12;
                let _e9689 = bitcast<u32>(_e9688);
                if (_e9689 < 8388608u) {
                    phi_15026_ = array<u32, 2>();
                    phi_15027_ = true;
                } else {
                    let _e9693 = ((_e9689 >> bitcast<u32>(31i)) == 1u);
                    if _e9693 {
                        phi_15025_ = array<u32, 2>();
                    } else {
                        phi_15025_ = array<u32, 2>((_e9689 << bitcast<u32>(29i)), ((((_e9689 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e9689 & 8388607u) >> bitcast<u32>(3i))));
                    }
                    let _e9707 = phi_15025_;
                    phi_15026_ = _e9707;
                    phi_15027_ = _e9693;
                }
                let _e9709 = phi_15026_;
                let _e9711 = phi_15027_;
                if _e9711 {
                    phi_15031_ = array<u32, 2>(0u, 0u);
                } else {
                    phi_15031_ = _e9709;
                }
                let _e9713 = phi_15031_;
                if (_e9684.member_2[0] == _e9713[0]) {
                    let _e9719 = params.member.member.member_12;
                    let _e9720 = bitcast<u32>(_e9719);
                    if (_e9720 < 8388608u) {
                        phi_15059_ = array<u32, 2>();
                        phi_15060_ = true;
                    } else {
                        let _e9724 = ((_e9720 >> bitcast<u32>(31i)) == 1u);
                        if _e9724 {
                            phi_15058_ = array<u32, 2>();
                        } else {
                            phi_15058_ = array<u32, 2>((_e9720 << bitcast<u32>(29i)), ((((_e9720 >> bitcast<u32>(23i)) + 896u) << bitcast<u32>(20i)) | ((_e9720 & 8388607u) >> bitcast<u32>(3i))));
                        }
                        let _e9738 = phi_15058_;
                        phi_15059_ = _e9738;
                        phi_15060_ = _e9724;
                    }
                    let _e9740 = phi_15059_;
                    let _e9742 = phi_15060_;
                    if _e9742 {
                        phi_15064_ = array<u32, 2>(0u, 0u);
                    } else {
                        phi_15064_ = _e9740;
                    }
                    let _e9744 = phi_15064_;
                    phi_15067_ = (_e9684.member_2[1] == _e9744[1]);
                } else {
                    phi_15067_ = false;
                }
                let _e9748 = phi_15067_;
                let _e9750 = params.member.member.member_1;
                if ((_e9750 & 128u) != 0u) {
                    phi_15083_ = true;
                } else {
                    let _e9754 = params.member.member.member_1;
                    if ((_e9754 & 64u) != 0u) {
                        phi_15082_ = _e9748;
                    } else {
                        phi_15082_ = false;
                    }
                    let _e9758 = phi_15082_;
                    phi_15083_ = _e9758;
                }
                let _e9760 = phi_15083_;
                if _e9684.member_3 {
                    if _e9760 {
                        phi_15091_ = false;
                    } else {
                        phi_15091_ = true;
                    }
                    let _e9763 = phi_15091_;
                    phi_15092_ = _e9763;
                } else {
                    phi_15092_ = true;
                }
                let _e9765 = phi_15092_;
                if _e9765 {
                    phi_15097_ = _e9684.member;
                } else {
                    phi_15097_ = 1u;
                }
                let _e9768 = phi_15097_;
                if _e9684.member_3 {
                    phi_15105_ = (_e9768 == 0u);
                } else {
                    phi_15105_ = false;
                }
                let _e9774 = phi_15105_;
                if _e9774 {
                    let _e9779 = (_e9684.member_2[1] >> bitcast<u32>(20i));
                    if (_e9779 <= 896u) {
                        phi_15126_ = 0u;
                    } else {
                        phi_15126_ = ((((_e9779 - 896u) << bitcast<u32>(23i)) | ((_e9684.member_2[1] & 1048575u) << bitcast<u32>(3i))) | (_e9684.member_2[0] >> bitcast<u32>(29i)));
                    }
                    let _e9794 = phi_15126_;
                    let _e9796 = atomicMin((&earliest.member[0u]), _e9794);
                }
                phi_15130_ = type_20(1u, 0u, _e194, _e197, _e9684.member_2, _e9684.member_1);
                phi_15131_ = _e9774;
                phi_15132_ = (_e9768 != 0u);
            } else {
                phi_15130_ = type_20(1u, 0u, 0u, 0u, array<u32, 2>(0u, 0u), 0u);
                phi_15131_ = false;
                phi_15132_ = false;
            }
            let _e9798 = phi_15130_;
            let _e9800 = phi_15131_;
            let _e9802 = phi_15132_;
            let _e9805 = params.member.member.member_1;
            if ((_e9805 & 16u) != 0u) {
                if (_e123 == 0u) {
                    atomicStore((&counters[0u]), 0u);
                }
                workgroupBarrier();
                if _e9800 {
                    let _e9811 = atomicAdd((&counters[0u]), 1u);
                    phi_15151_ = _e9811;
                } else {
                    phi_15151_ = 0u;
                }
                let _e9813 = phi_15151_;
                workgroupBarrier();
                if (_e123 == 0u) {
                    let _e9816 = atomicLoad((&counters[0u]));
                    if (_e9816 > 0u) {
                        let _e9819 = atomicAdd((&contacts.member[0u]), _e9816);
                        atomicStore((&counters[1u]), _e9819);
                    }
                }
                workgroupBarrier();
                let _e9822 = atomicLoad((&counters[1u]));
                let _e9823 = (_e9822 + _e9813);
                if _e9800 {
                    let _e9826 = params.member.member_1.member_3;
                    if (_e9823 < _e9826) {
                        let _e9828 = (7u * _e9823);
                        atomicStore((&contacts.member[(4u + _e9828)]), _e9798.member);
                        atomicStore((&contacts.member[(_e9828 + 5u)]), _e9798.member_1);
                        atomicStore((&contacts.member[(_e9828 + 6u)]), _e9798.member_2);
                        atomicStore((&contacts.member[(_e9828 + 7u)]), _e9798.member_3);
                        atomicStore((&contacts.member[(_e9828 + 8u)]), _e9798.member_4[0]);
                        atomicStore((&contacts.member[(_e9828 + 9u)]), _e9798.member_4[1]);
                        atomicStore((&contacts.member[(_e9828 + 10u)]), _e9798.member_5);
                    }
                }
            }
            workgroupBarrier();
            if (_e123 == 0u) {
                atomicStore((&counters[0u]), 0u);
            }
            workgroupBarrier();
            if _e9802 {
                let _e9855 = atomicAdd((&counters[0u]), 1u);
                phi_15218_ = _e9855;
            } else {
                phi_15218_ = 0u;
            }
            let _e9857 = phi_15218_;
            workgroupBarrier();
            if (_e123 == 0u) {
                let _e9860 = atomicLoad((&counters[0u]));
                if (_e9860 > 0u) {
                    let _e9863 = atomicAdd((&undecided.member[0u]), _e9860);
                    atomicStore((&counters[1u]), _e9863);
                }
            }
            workgroupBarrier();
            let _e9866 = atomicLoad((&counters[1u]));
            let _e9867 = (_e9866 + _e9857);
            if _e9802 {
                let _e9870 = params.member.member_2.member;
                if (_e9867 < _e9870) {
                    let _e9874 = (2u * _e9867);
                    atomicStore((&undecided.member[(4u + _e9874)]), _e9798.member_2);
                    atomicStore((&undecided.member[(_e9874 + 5u)]), _e9798.member_3);
                }
            }
        }
        continue;
        continuing {
            phi_291_ = _e179;
            break if !(_e185);
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn decide_edge_edge(@builtin(workgroup_id) id: vec3<u32>, @builtin(num_workgroups) n: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    function_4(id, n, lane);
}
